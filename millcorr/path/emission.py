# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program corrected in place: its path displaced, written, read back and proven."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from millcorr import gcode
from millcorr.commanded import CommandedSurface
from millcorr.compensation import Correction
from millcorr.errors import FitError, LimitError
from millcorr.nurbs import NurbsCurve
from millcorr.profile import Contour, Profile
from millcorr.reconstruction import CompensatedContour
from millcorr.regeneration.emission import Emission, written_text
from millcorr.regeneration.free_ends import keep_coordinate
from millcorr.settings import Settings
from millcorr.toolpath import Plane, Toolpath

from .displacement import displace
from .surface_proof import prove_surface
from .text_proof import prove_text
from .wanted_surface import WantedSurface

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]


STILL = 1e-9
"""A move shorter than this along every axis, in mm, goes nowhere."""


def emit_in_place(
    program: gcode.Program,
    following: Bools,
    nominal: Profile,
    correction: Correction,
    radius: float,
    cutters: Floats,
    settings: Settings,
    *,
    header: Sequence[str],
    carried: Correction | None = None,
) -> tuple[Emission, str | None]:
    """Move the surface of a program by a correction, write it and prove what was written.

    Parameters
    ----------
    program : Program
    following : (n,) bool
        Moves that make the surface.
    nominal : Profile
    correction : Correction
        Of the nominal, in all.
    radius : float
        Distance in mm from contour to path.
    cutters : (m,) float64
        Radius of the cutter of every move of the program, mm; NaN where it is not known.
    settings : Settings
        Its tolerance and moves.
    header : sequence of str
        Comments for the first lines of a program that changed.
    carried : Correction, optional
        What of it the program carries already; nothing by default.

    Returns
    -------
    Emission
    note : str or None
        What the cutter cannot reach, with place and amount.

    Raises
    ------
    LimitError, FitError
        If the path would be unsafe, or the text does not prove.
    """
    before = WantedSurface(nominal, Correction.none(nominal) if carried is None else carried)
    after = WantedSurface(nominal, correction)
    regeneration = displace(
        program.toolpath,
        following,
        before,
        after,
        nominal,
        radius,
        tolerance=settings.tolerance,
        output_moves=settings.output_moves,
    )
    reach = regeneration.largest_shift + settings.tolerance
    if settings.depth_along != "normal" and not any(c.closed for c in nominal.contours):
        # Ends slide along themselves by no more than twice as far again.
        reach += 2 * regeneration.largest_shift
        regeneration = keep_coordinate(program.toolpath, regeneration, axis="yx".index(settings.depth_along))
    text = written_text(program, regeneration, settings.tolerance, header)
    emitted = prove_text(program.data, text, regeneration.lines, header=header, reach=reach).moves.toolpath()
    emitted = emitted.take(~_nowhere(emitted))
    goes = ~_nowhere(regeneration.toolpath)
    planned, following_now = regeneration.toolpath.take(goes), regeneration.following[goes]
    if len(emitted) != len(planned):
        raise LimitError(f"the written program reads back with {len(emitted)} moves in place of {len(planned)}")
    _refuse_other_moves(planned, emitted, regeneration.lines, settings.tolerance)
    proof, (stays, place) = prove_surface(
        CommandedSurface(program.toolpath, cutters),
        CommandedSurface(emitted, cutters[regeneration.origin[goes]]),
        (following, following_now),
        before,
        after,
        radius,
        tolerance=settings.tolerance,
    )
    note = None
    if stays > settings.tolerance:
        note = (
            f"{stays:.3f} mm stays at X{place[0]:.3f} Y{place[1]:.3f}: the corner is too narrow for a cutter of "
            f"{2 * radius:g} mm to reach what is wanted there; a smaller one would"
        )
    compensated, residual = compensated_profile(nominal, correction, after)
    return Emission(compensated, residual, regeneration, proof, text), note


def _refuse_other_moves(planned: Toolpath, emitted: Toolpath, lines: Ints, tolerance: float) -> None:
    """LimitError where a move of a line that changed is not what was planned, rounding apart."""
    rows = np.flatnonzero(np.isin(planned.source, lines))
    # An arc too flat to be written becomes a line, and what is not known of a place is not compared.
    flat = (planned.plane[rows] == Plane.XY) & (emitted.plane[rows] == Plane.XY)
    share = np.array([0.0, 0.5, 1.0])
    gap = np.abs(emitted.take(rows).position(share) - planned.take(rows).position(share))
    gap[~flat, 1] = 0.0
    off = np.nan_to_num(gap).max(axis=(1, 2), initial=0.0) > 2 * tolerance
    off |= np.isnan(emitted.end[rows, :2]).any(axis=1) & ~np.isnan(planned.end[rows, :2]).any(axis=1)
    if off.any():
        row = rows[int(np.argmax(off))]
        x, y = emitted.end[row, :2]
        raise LimitError(
            f"line {int(emitted.source[row]) + 1} of the written program goes to X{x:.3f} Y{y:.3f} and not where it "
            "was planned to go"
        )


def _nowhere(toolpath: Toolpath) -> Bools:
    """Moves that go nowhere: a reader may count them or not."""
    # Sums of displacements differ in their last digit where the text states one and the same place.
    still = (np.abs(toolpath.end - toolpath.start) < STILL) | np.isnan(toolpath.start + toolpath.end)
    out: Bools = still.all(axis=1) & (toolpath.sweep == 0)
    return out


def compensated_profile(nominal: Profile, correction: Correction, surface: WantedSurface) -> tuple[Profile, float]:
    """The corrected profile as NURBS, and the largest distance in mm of it from the exact one.

    Where the profile has details that the correction swallows, such as facets shorter than it, it is given as the
    fine row of chords of the surface that is wanted.
    """
    try:
        return CompensatedContour(nominal, correction).to_profile()
    except (LimitError, FitError):
        pass
    contours = []
    after = dict(surface.chords.tolist())
    contour_of = np.array([stretch.contour for stretch in nominal.stretches()])[surface.stretch]
    for k, contour in enumerate(nominal.contours):
        row = int(np.flatnonzero((contour_of == k) & np.isin(np.arange(len(contour_of)), surface.chords[:, 0]))[0])
        rows = [row]
        while (row := after.get(row, -1)) >= 0 and row != rows[0]:
            rows.append(row)
        points = surface.place[rows + ([rows[0]] if contour.closed else [])]
        points = points[np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 1e-6])]
        count = np.ones(len(points), dtype=np.int64)
        count[[0, -1]] = 2
        curve = NurbsCurve(1, points, np.ones(len(points)), np.arange(float(len(points))), count)
        contours.append(Contour((curve,), contour.closed, contour.step))
    return Profile.from_contours(contours), 0.0
