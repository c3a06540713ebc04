# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof: an emitted program, read back, against the exact parallel of the compensated profile."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.theoretical_contour import cutting_runs
from millcorr.errors import LimitError
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.messages import option, phrase, um, xy
from millcorr.nc.toolpath import Toolpath

SPACING = 0.25
"""Distance in mm between places at which moves are checked; at least nine a move."""


@dataclass(frozen=True, slots=True)
class Verification:
    """What reading the emitted program back has shown.

    Parameters
    ----------
    path_error_max : float
        Largest distance in mm of the emitted following moves from the exact parallel of the compensated profile.
    place : tuple of float
        x, y of that place in mm.
    gouge_max : float
        By how much, in mm, the cutter comes nearer to any part of the profile than its radius; never negative.
    length : float
        Length of path that was checked, mm.
    """

    path_error_max: float
    place: tuple[float, float]
    gouge_max: float
    length: float


def verify(
    emitted: Toolpath,
    compensated: Profile,
    radius: float,
    *,
    following: Bools,
    tolerance: float,
) -> Verification:
    """Check the following moves of an emitted program.

    Parameters
    ----------
    emitted : Toolpath
        Read back from the emitted text.
    compensated : Profile
        Compensated NURBS profile.
    radius : float
        Distance in mm between path and profile.
    following : (n,) bool
        Moves that follow the profile.
    tolerance : float
        Largest path error allowed, mm.

    Returns
    -------
    Verification

    Raises
    ------
    LimitError
        If the path is farther off than the tolerance, or gouges; names the place.
    """
    points, length = sampled(emitted, np.flatnonzero(following))
    feet = FootPointSearch(compensated, margin=radius + 2.0).find(points)
    off = feet.distance - radius
    # Past a convex corner or an open end the path may run straight on: the cutter is then farther away.
    beyond = (feet.place != Place.SMOOTH) & (off > 0)
    error = np.where(beyond, 0.0, np.abs(off))
    if radius == 0:
        error = np.where(feet.place == Place.END, np.minimum(error, np.abs(_across(points, compensated, feet))), error)
    worst = int(np.argmax(error))
    gouge = float(max(0.0, -off.min()))
    x, y = points[worst]
    result = Verification(float(error[worst]), (float(x), float(y)), gouge, length)
    if error[worst] > tolerance:
        raise too_far_off("path", float(off[worst]), (float(x), float(y)), tolerance)
    return result


def _across(points: Floats, profile: Profile, feet: FootPoints) -> Floats:
    """Distance of points beyond an open end from its tangent."""
    normal = profile.normals(feet.span, feet.t)
    out: Floats = ((points - feet.foot) * normal).sum(axis=1)
    return out


def sampled(toolpath: Toolpath, rows: Ints) -> tuple[Floats, float]:
    """Places along moves in mm, (k, 2), every `SPACING` mm and nine a move at least, and the length of the moves."""
    moves = toolpath.take(rows)
    # Heights may be unknown where the program has not stated one; the proof is in the plane.
    level = np.nan_to_num(moves.start) * [1, 1, 0], np.nan_to_num(moves.end) * [1, 1, 0]
    length = moves.with_moves(start=level[0], end=level[1]).length()
    count = np.maximum(9, np.ceil(length / SPACING).astype(np.int64) + 1)
    out = []
    for k in np.unique(count):
        group = np.flatnonzero(count == k)
        out.append(moves.take(group).position(np.linspace(0.0, 1.0, int(k)))[:, :, :2].reshape(-1, 2))
    return np.concatenate(out), float(length.sum())


def following_by_place(emitted: Toolpath, planned: Toolpath, following: Bools, near: float = 0.02) -> Bools:
    """Moves of an emitted program that lie on planned following moves.

    A post processor may add and drop lines, so the emitted moves are recognised by their place; each planned
    move must be found.

    Parameters
    ----------
    emitted, planned : Toolpath
    following : (n,) bool
        Planned moves that follow the profile.
    near : float
        Both ends and the middle agree within this, in mm.

    Returns
    -------
    (m,) bool

    Raises
    ------
    LimitError
        If a planned following move is missing from the emitted program.
    """
    out = np.zeros(len(emitted), dtype=bool)
    runs = cutting_runs(emitted)
    index = np.concatenate(runs) if runs else np.zeros(0, dtype=np.int64)
    wanted = np.flatnonzero(following)
    t = np.array([0.0, 0.5, 1.0])
    have = emitted.take(index).position(t).reshape(len(index), -1)
    want = planned.take(wanted).position(t).reshape(len(wanted), -1)
    at = 0
    for row, target in zip(wanted, want, strict=True):
        close = np.flatnonzero((np.abs(have[at:] - target) < near).all(axis=1))
        if not len(close):
            x, y = target[-3], target[-2]
            raise LimitError(
                phrase("the posted program lacks the move to {} (command {} of the path)", xy(x, y), row + 1)
            )
        at += int(close[0]) + 1
        out[index[at - 1]] = True
    return out


def too_far_off(what: str, off: float, place: tuple[float, float], tolerance: float) -> LimitError:
    """The error that a corrected path or surface is off by more than the tolerance, mm; negative where it gouges."""
    x, y = place
    gouges = off < 0
    how = um(abs(off), ".2f"), xy(x, y), um(tolerance, "g")
    seen = phrase(
        "the corrected {} would be {} off at {}, more than the tolerance of {}",
        phrase("path") if what == "path" else phrase("surface"),
        *how,
    )
    return LimitError(
        phrase("{} (the cutter gouges there)", seen)
        if gouges
        else phrase("{}: where that does no harm, a larger {}", seen, option("tolerance")),
        place=place,
        figure=off,
    )
