# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a correction to the bytes of a program: path laid anew, written, read back and proven."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr import gcode
from millcorr.compensation import Correction
from millcorr.errors import LimitError
from millcorr.path.text_proof import prove_text
from millcorr.profile import Profile
from millcorr.reconstruction import CompensatedContour
from millcorr.settings import Settings
from millcorr.toolpath import Toolpath
from millcorr.verification import Verification, verify

from .free_ends import keep_coordinate
from .moves import Regeneration, regenerate

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True, eq=False, slots=True)
class Emission:
    """A program laid on a moved profile, with its proof.

    Parameters
    ----------
    compensated : Profile
        The profile that it cuts on a machine without errors.
    fit_residual : float
        Largest distance between the exact moved contour and that NURBS, mm.
    regeneration : Regeneration
    verification : Verification
        Of the program's text, read back.
    text : bytes
        The program; the very bytes of the original where nothing changed.
    """

    compensated: Profile
    fit_residual: float
    regeneration: Regeneration
    verification: Verification
    text: bytes


def emit(
    program: gcode.Program,
    nominal: Profile,
    correction: Correction,
    path_radius: float,
    settings: Settings,
    *,
    rows: Bools,
    nominal_from_path: bool,
    header: Sequence[str],
    toolpath: Toolpath | None = None,
    expected: CompensatedContour | None = None,
) -> Emission:
    """Move the nominal by the correction, lay the program's path on it, write it and prove what was written.

    Parameters
    ----------
    program : Program
    nominal : Profile
    correction : Correction
    path_radius : float
        Distance in mm from contour to path.
    settings : Settings
        Its tolerance, moves and axis.
    rows : (n,) bool
        Moves that may be changed.
    nominal_from_path : bool
        True where the nominal was taken from this program.
    header : sequence of str
        Comments for the first lines of a program that changed.
    toolpath : Toolpath, optional
        What to lay anew in place of the program's own moves.
    expected : CompensatedContour, optional
        What the program follows so far, where it carries a correction; the nominal by default.

    Raises
    ------
    LimitError, FitError
        If the moved profile or the path would be unsafe, or the text does not prove.
    """
    contour = CompensatedContour(nominal, correction)
    _refuse_crossing(nominal, contour)
    compensated, residual = contour.to_profile()
    toolpath = program.toolpath if toolpath is None else toolpath
    regeneration = regenerate(
        toolpath,
        contour,
        path_radius,
        tolerance=settings.tolerance,
        output_moves=settings.output_moves,
        rows=rows,
        nominal_from_path=nominal_from_path,
        expected=expected,
    )
    if settings.depth_along != "normal" and not any(c.closed for c in nominal.contours):
        regeneration = keep_coordinate(toolpath, regeneration, axis="yx".index(settings.depth_along))
    _refuse_detour(toolpath, regeneration)
    text = written_text(program, regeneration, settings.tolerance, header)
    # A first cut has corners where fillets vanish: their lines go, and their neighbours' ends with them.
    lines = np.unique(program.toolpath.source) if settings.leave_stock else regeneration.lines
    prove_text(program.data, text, lines, header=header)
    emitted = gcode.parse(text, program.name).toolpath
    if len(emitted) != len(regeneration.toolpath):
        raise LimitError(
            f"the written program reads back with {len(emitted)} moves in place of {len(regeneration.toolpath)}"
        )
    proof = verify(emitted, compensated, path_radius, following=regeneration.following, tolerance=settings.tolerance)
    return Emission(compensated, residual, regeneration, proof, text)


def _refuse_crossing(nominal: Profile, contour: CompensatedContour) -> None:
    """LimitError where the compensated contour crosses itself although the nominal does not."""
    import shapely

    for k, c in enumerate(nominal.contours):
        pieces = np.flatnonzero(contour.contour == k)
        before: list[Floats] = []
        after: list[Floats] = []
        for piece in pieces:
            count = int(max(9, contour.length[piece] / 0.1))
            for corrected, low, high, out in (
                (False, 0.0, contour.length[piece], before),
                (True, contour.low[piece], contour.high[piece], after),
            ):
                sigma = np.linspace(low, high, count)[:-1]
                out.append(contour.evaluate(np.full(len(sigma), piece), sigma, corrected=corrected)[0])
        shape = shapely.LinearRing if c.closed else shapely.LineString
        moved = shape(np.concatenate(after))
        if not moved.is_simple and shape(np.concatenate(before)).is_simple:
            raise LimitError(
                "the corrected profile crosses itself: the correction is larger than a detail of the contour"
            )


def _refuse_detour(toolpath: Toolpath, regeneration: Regeneration) -> None:
    """LimitError where the corrected path is much longer or shorter than the path it replaces."""
    rows = np.unique(regeneration.origin[regeneration.following])
    before = float(np.nansum(toolpath.take(rows).length()))
    moves = regeneration.toolpath.take(np.flatnonzero(regeneration.following))
    after = float(np.nansum(moves.length()))
    # Every corner lengthens or shortens the path by a few times the correction.
    if abs(after - before) > 0.01 * before + 8 * len(rows) * regeneration.largest_shift:
        raise LimitError(
            f"the corrected path along the contour would be {after:.3f} mm long in place of {before:.3f} mm: the "
            "program does not run along the nominal as expected; check --nominal"
        )


def written_text(program: gcode.Program, regeneration: Regeneration, tolerance: float, header: Sequence[str]) -> bytes:
    """The new program; decimals as the program has them where the tolerance allows."""
    plain = gcode.write(program, regeneration.toolpath, tolerance=tolerance)
    if plain == program.data:
        return plain
    room = tolerance - regeneration.fit_error
    # Rounding moves a point by at most half a unit in each of two directions.
    own = program.style.decimals
    unit = 25.4 if (program.modal.unit == 20).any() else 1.0
    decimals = own if np.sqrt(0.5) * unit * 10.0**-own <= 0.9 * room else None
    return gcode.write(program, regeneration.toolpath, decimals=decimals, tolerance=tolerance, header=header)
