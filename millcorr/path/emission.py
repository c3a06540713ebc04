# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program corrected in place: its path displaced, written, read back and proven."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr import nc, progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.commanded_surface import CommandedSurface
from millcorr.comparison.deviation import Deviation
from millcorr.correction.settings import Settings
from millcorr.errors import FitError, FormatError, LimitError
from millcorr.geometry.correction import Correction
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.messages import mm, phrase, remedy, um, xy
from millcorr.nc.toolpath import Plane, Toolpath
from millcorr.path.free_ends import keep_coordinate
from millcorr.path.leads import own_work
from millcorr.path.moves import Regeneration
from millcorr.path.passes import beside_the_path
from millcorr.path.reconstruction import CompensatedContour
from millcorr.path.verification import Verification
from millcorr.tolerances import ARITHMETIC

from .displacement import displace
from .neighbours import refuse_cut_neighbours
from .repeated_leads import leads_alike
from .second_reader import prove
from .surface_proof import prove_surface
from .wanted_surface import WantedSurface


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
    program: nc.Program,
    toolpath: Toolpath,
    following: Bools,
    along: Bools,
    nominal: Profile,
    correction: Correction,
    radius: float,
    cutters: Floats,
    settings: Settings,
    *,
    header: Sequence[str],
    carried: Correction | None = None,
    exact: bool = False,
    original_error: float = 0.0,
    measured: Deviation | None = None,
) -> tuple[Emission, tuple[str, ...]]:
    """Move the surface of a program by a correction, write it and prove what was written.

    Parameters
    ----------
    program : Program
    toolpath : Toolpath
        Its moves, divided where a contour begins on one of them; of a first cut without the fillets that vanish.
    following : (n,) bool
        Moves that make the surface.
    along : (n,) bool
        Moves that leave stock on it, and go along so that it stays.
    nominal : Profile
    correction : Correction
        Of the nominal, in all.
    radius : float
        Distance in mm from contour to path.
    cutters : (m,) float64
        Radius of the cutter of every move of the toolpath, mm; NaN where it is not known.
    settings : Settings
        Its tolerance and moves.
    header : sequence of str
        Comments for the first lines of a program that changed.
    carried : Correction, optional
        What of it the program carries already; nothing by default.
    exact : bool
        Whether the path is laid on the exact parallel of the wanted surface, as where the nominal is a drawing; else it
        keeps chords and rounding of its own.
    original_error : float
        How far the moves are off what they follow so far, mm.
    measured : Deviation, optional
        What the correction rests on: beyond its ends an open contour may be a lead, and what cuts into it is only said.

    Returns
    -------
    Emission
    notes : tuple of str
        What the cutter cannot reach, with place and amount; the lines that went along.

    Raises
    ------
    LimitError, FitError
        If the path would be unsafe, or the text does not prove.
    """
    if settings.leave_stock:
        # An allowance may be more than a detail of the contour: then nothing of it is left to lay a path on.
        CompensatedContour(nominal, correction)
    progress.step()
    carried = Correction.none(nominal) if carried is None else carried
    before, after = WantedSurface(nominal, carried, correction), WantedSurface(nominal, correction, carried)
    regeneration = displace(
        toolpath,
        following,
        None if exact else before,
        after,
        nominal,
        radius,
        along=(along, before),
        tolerance=settings.tolerance,
        output_moves=settings.output_moves,
        original_error=original_error,
        undivided=np.isin(toolpath.source, program.led),
    )
    reach = regeneration.largest_shift + settings.tolerance
    if settings.depth_along != "normal" and not any(c.closed for c in nominal.contours):
        # Ends slide along themselves by no more than twice as far again.
        reach += 2 * regeneration.largest_shift
        regeneration = keep_coordinate(toolpath, regeneration, axis="yx".index(settings.depth_along))
    progress.step()
    regeneration = leads_alike(program, toolpath, regeneration)
    text = written_text(program, regeneration, settings.tolerance, header)
    # Of a first cut's vanishing fillets the lines go, and their neighbours' ends with them.
    lines = np.unique(program.toolpath.source) if settings.leave_stock else regeneration.lines
    lines = np.unique(program.lines_of(program.written_out(lines)))
    proven = prove(program.data, text, lines, header=header, reach=reach, beside=program.beside)
    emitted = proven.moves.toolpath().with_lines(proven.line)
    progress.step()
    emitted = emitted.take(~_nowhere(emitted))
    goes = _stated(regeneration.toolpath, emitted, settings.tolerance)
    planned, following_now = regeneration.toolpath.take(goes), regeneration.following[goes]
    if len(emitted) != len(planned):
        raise LimitError(
            phrase("the written program reads back with {} moves in place of {}", len(emitted), len(planned))
        )
    compared = regeneration.lines
    if proven.unplaced is not None:
        compared = compared[~proven.unplaced[program.lines_of(compared)]]
    _refuse_other_moves(planned, emitted, compared, settings.tolerance)
    progress.step()
    original = CommandedSurface(toolpath, cutters)
    written = CommandedSurface(emitted, cutters[regeneration.origin[goes]])
    changed = np.isin(toolpath.source, regeneration.lines), np.isin(planned.source, regeneration.lines)
    shift = regeneration.largest_shift + settings.tolerance
    proof, (stays, place), (held, beside, line) = prove_surface(
        original,
        written,
        (following, following_now),
        regeneration.origin[goes],
        before,
        after,
        radius,
        tolerance=settings.tolerance,
        exact=exact,
        beyond=None if measured is None else _beyond(after, measured),
    )
    progress.step()
    leads = beside_the_path(toolpath, following) & ~following & ~own_work(toolpath, following)
    refuse_cut_neighbours(original, written, changed, leads, shift=shift, tolerance=settings.tolerance)
    notes = []
    if stays > settings.tolerance:
        notes.append(
            phrase(
                "{} stays at {}: what is wanted there is too narrow for a cutter of {}; a smaller one would reach it",
                mm(stays),
                xy(place[0], place[1]),
                mm(2 * radius, "g"),
            )
        )
    if line:
        notes.append(
            phrase(
                "line {} of the corrected program, which is not corrected itself, cuts {} into the corrected "
                "surface at {}, beyond what was measured: if that is a wall of the part and no lead, {} "
                "moves such passes along",
                line,
                um(held),
                xy(beside[0], beside[1]),
                remedy("keep_allowance"),
            )
        )
    moved = np.intersect1d(toolpath.source[along], regeneration.lines)
    if len(moved):
        which = _listed(np.unique(program.lines_of(moved)) + 1)
        notes.append(
            phrase("other passes on the corrected wall are moved along with it: lines {} of {}", which, program.name)
        )
    compensated, residual = compensated_profile(nominal, correction, after)
    return Emission(compensated, residual, regeneration, proof, text), tuple(notes)


def _beyond(surface: WantedSurface, measured: Deviation) -> Bools:
    """Places of a surface on open contours before the first measured point of these or behind the last; (n,)."""
    profile = surface.profile
    contour = np.array([stretch.contour for stretch in profile.stretches()])
    mine, seen = contour[surface.stretch], contour[measured.stretch]
    out = np.zeros(len(mine), dtype=bool)
    for k in np.unique(seen):
        if not profile.contours[k].closed:
            s = measured.s[seen == k]
            out |= (mine == k) & ((surface.s < s.min()) | (surface.s > s.max()))
    return out


def _listed(lines: Ints) -> str:
    """Numbers of lines in rising order, those that follow one another as from and to."""
    runs = np.split(lines, np.flatnonzero(np.diff(lines) > 1) + 1)
    return ", ".join(f"{run[0]}" if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs)


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
            phrase(
                "line {} of the written program goes to {} and not where it was planned to go",
                emitted.line(row),
                xy(x, y),
            )
        )


def _nowhere(toolpath: Toolpath) -> Bools:
    """Moves that go nowhere: a reader may count them or not."""
    # Sums of displacements differ in their last digit where the text states one and the same place.
    still = (np.abs(toolpath.end - toolpath.start) < ARITHMETIC) | np.isnan(toolpath.start + toolpath.end)
    out: Bools = still.all(axis=1) & (toolpath.sweep == 0)
    return out


def _stated(planned: Toolpath, emitted: Toolpath, tolerance: float) -> Ints:
    """Planned moves that a text states, (n,): of those shorter than its last digit rounding may leave nothing."""
    rows = np.flatnonzero(~_nowhere(planned))
    short = (np.abs(planned.end - planned.start) < tolerance).all(axis=1) & (planned.sweep == 0)
    while len(rows) > len(emitted):
        progress.step()
        off = np.abs(planned.end[rows[: len(emitted)]] - emitted.end).max(axis=1) > tolerance
        # What is missing stands before the first place where the two are apart.
        before = int(np.argmax(off)) if off.any() else len(emitted)
        missing = np.flatnonzero(short[rows[: before + 1]])
        if not len(missing):
            break
        rows = np.delete(rows, missing[-1])
    return rows


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


def written_text(program: nc.Program, regeneration: Regeneration, tolerance: float, header: Sequence[str]) -> bytes:
    """The new program; decimals as the program has them where the tolerance allows."""
    plain = nc.write(program, regeneration.toolpath, tolerance=tolerance)
    if plain == program.data:
        return plain
    room = tolerance - regeneration.fit_error
    # Rounding moves a point by at most half a unit in each of two directions.
    own = program.style.decimals
    unit = 25.4 if (program.modal.unit == 20).any() else 1.0
    if np.sqrt(0.5) * unit * 10.0**-own <= 0.9 * room:
        try:
            return nc.write(program, regeneration.toolpath, decimals=own, tolerance=tolerance, header=header)
        except FormatError:
            # An arc by its radius may need one more than its ends do.
            pass
    return nc.write(program, regeneration.toolpath, tolerance=tolerance, header=header)
