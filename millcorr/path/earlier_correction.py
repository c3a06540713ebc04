# SPDX-License-Identifier: LGPL-2.1-or-later
"""The correction that a program carries, read off its own path.

A corrected program runs off the nominal's parallel by its correction: up to the limit of a correction, and not the
same everywhere. Moves that follow are therefore looked for about what the program is expected to follow, and not in a
wider band about the nominal, which would take roughing passes for finishing ones.
"""

from __future__ import annotations

import math

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.correction.compensation import correction_from
from millcorr.errors import LimitError
from millcorr.geometry.correction import Correction, along
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.messages import at_z, mm, phrase, xy
from millcorr.nc.toolpath import Toolpath
from millcorr.path.reconstruction import CompensatedContour

from .path_following import follow, length_in_plane

CELL = 2.0
"""The correction is read once in every cell of about this length of contour, in mm."""

APART = 1.0
"""Samples along a move are at most this far apart, in mm: every pass has one in every cell."""

STEEP = 0.2
"""A path that nears the contour by more than this per mm leads onto it or off it; no correction is so steep."""

HEIGHT = 0.01
"""Heights that differ by less than this, in mm, are the same."""

MANY = 0.1
"""Passes are told apart by their height where a larger share of the contour asks for it: not at a single lead."""


def earlier_correction(
    toolpath: Toolpath, nominal: CompensatedContour, radius: float, rows: Bools, *, band: float, reach: float
) -> Correction:
    """How far the finishing pass of a corrected program runs off the nominal's parallel.

    Parameters
    ----------
    toolpath : Toolpath
    nominal : CompensatedContour
        The nominal without a correction.
    radius : float
        Distance in mm from contour to path.
    rows : (n,) bool
        Moves that may follow.
    band : float
        A move that followed before the first correction was at most this far off, in mm, and none that did not
        follow was nearer.
    reach : float
        Largest correction to look for, mm.

    Returns
    -------
    Correction
        Zero where no pass is within reach.

    Raises
    ------
    LimitError
        If two passes run along the profile and it cannot be told which of them carries the correction.

    Notes
    -----
    Of several passes along one place the finishing pass is the one nearest to the material: what it leaves is the
    surface. Only a pass within `band` of the nominal goes before one that is deeper, for every such pass was corrected
    and no other can be there. A deeper pass at another height may be a step of the part: then it is not known.
    """
    profile = nominal.profile
    stretch, s, off, z = _samples(toolpath, nominal, radius, rows, reach)
    if not len(off):
        return Correction.none(profile)
    stretches = profile.stretches()
    cells = np.array([max(1, round(one.length / CELL)) for one in stretches])
    start = np.concatenate([[0], np.cumsum(cells)])
    local, cell = np.empty(len(s)), np.empty(len(s), dtype=np.int64)
    for k in np.unique(stretch):
        one = stretches[k]
        at = stretch == k
        local[at] = along(one, s[at], profile)
        cell[at] = start[k] + np.clip((local[at] / one.length * cells[k]).astype(np.int64), 0, cells[k] - 1)
    order = np.lexsort((off, np.abs(off) > band, cell))
    deepest = order[np.flatnonzero(np.diff(cell[order], prepend=-1))]
    rough, _ = correction_from(profile, stretch[deepest], s[deepest], off[deepest], limit=math.inf)
    over = off - rough.at(stretch, s, profile)
    mine = np.abs(over) <= 0.5 * band
    mine[deepest] = True
    _refuse_unclear(profile, (stretch, s, off, z), cell, mine, over > 0.5 * band, band)
    count = np.bincount(cell[mine])
    held = np.flatnonzero(count)
    owner = np.searchsorted(start, held, side="right") - 1
    # Cells begin at the stretch's start, so that no mean is taken across it.
    begin = np.array([one.begin for one in stretches])[owner]
    where = begin + np.bincount(cell[mine], local[mine])[held] / count[held]
    value = np.bincount(cell[mine], off[mine])[held] / count[held]
    smooth, _ = correction_from(profile, owner, where, value, limit=math.inf)
    return smooth


def _refuse_unclear(
    profile: Profile,
    samples: tuple[Ints, Floats, Floats, Floats],
    cell: Ints,
    mine: Bools,
    others: Bools,
    band: float,
) -> None:
    """LimitError where a pass that leaves more goes lower than the one taken for the finishing pass."""
    stretch, s, off, z = samples
    count = int(cell.max()) + 1
    lowest, below = np.full(count, np.inf), np.full(count, np.inf)
    np.fmin.at(lowest, cell[mine], z[mine])
    np.fmin.at(below, cell[others], z[others])
    unclear = below < lowest - HEIGHT
    unclear &= np.isin(np.arange(count), cell[mine & (np.abs(off) > band)])
    if unclear.sum() <= MANY * len(np.unique(cell)):
        return
    at = np.flatnonzero(unclear[cell])
    a, b = at[mine[at]][0], at[others[at]][0]
    point, _ = profile.at(profile.stretches()[stretch[a]].contour, s[[a]])
    raise LimitError(
        phrase(
            "near {} the program runs {} off the profile at {} and {} off it at {}: which pass "
            "carries the correction cannot be told; correct the first, uncorrected program, or one that "
            "holds the finishing pass alone",
            xy(point[0, 0], point[0, 1]),
            mm(off[a], "+.3f"),
            at_z(z[a]),
            mm(off[b], "+.3f"),
            at_z(z[b]),
        ),
        place=(float(point[0, 0]), float(point[0, 1])),
        figure=float(off[a] - off[b]),
    )


def _samples(
    toolpath: Toolpath, nominal: CompensatedContour, radius: float, rows: Bools, reach: float
) -> tuple[Ints, Floats, Floats, Floats]:
    """Stretch, arc length, offset from the nominal's parallel and height along all passes within reach, mm."""
    profile = nominal.profile
    index = np.unique(follow(toolpath, nominal, radius, band=reach, rows=rows).row)
    moves = toolpath.take(index)
    # A power of two of samples a move: few groups of moves of the same number.
    steps = 2 ** np.ceil(np.log2(np.maximum(length_in_plane(moves) / APART, 4.0))).astype(np.int64)
    stretch, s, off, z = [], [], [], []
    for number in np.unique(steps):
        t = (np.arange(number) + 0.5) / number
        points = moves.take(np.flatnonzero(steps == number)).position(t)
        feet = FootPointSearch(profile, margin=radius + reach + 1.0).find(points.reshape(-1, 3))
        away = feet.distance - radius
        travel = np.hypot(*(np.gradient(points[:, :, i], axis=1) for i in (0, 1)))
        slope = np.abs(np.gradient(away.reshape(travel.shape), axis=1))
        keep = (feet.place == Place.SMOOTH) & (np.abs(away) <= reach) & (slope < STEEP * travel).ravel()
        if radius > 0:
            # The cutter's centre is outside of the material: a path on the other side is none of this contour.
            keep &= feet.distance > 0
        stretch.append(profile.stretch[feet.span][keep])
        s.append(profile.arc_length(feet.span, feet.t)[keep])
        off.append(away[keep])
        z.append(points[:, :, 2].ravel()[keep])
    if not stretch:
        empty = np.zeros(0)
        return np.zeros(0, dtype=np.int64), empty, empty, empty
    return np.concatenate(stretch), np.concatenate(s), np.concatenate(off), np.concatenate(z)
