# SPDX-License-Identifier: LGPL-2.1-or-later
"""First stage: the program as passes, the nominal, and what was measured made ready to be compared with it."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

import numpy as np

from millcorr import nc, plausibility, progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.commanded_surface import CommandedSurface, choose_side, nominal_of
from millcorr.comparison.cutters import cutter_radii, nearest_group, stated_diameters
from millcorr.comparison.deviation import Deviation
from millcorr.comparison.theoretical_contour import CutContour, cutting_runs
from millcorr.correction import provenance
from millcorr.correction.settings import Settings
from millcorr.errors import DistrustError, FormatError, InputError, LimitError, UsageError
from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, remedy
from millcorr.nc.toolpath import Compensation, Kind, Toolpath
from millcorr.path.passes import (
    Commanded,
    beside_the_path,
    commanded_offset,
    cut_onto_the_contour,
    on_the_path,
    roughing,
    sharing,
)
from millcorr.path.reconstruction import CompensatedContour
from millcorr.path.second_reader import moves_of
from millcorr.path.vanishing_arcs import without_vanishing_arcs
from millcorr.process.prediction.predicted_correction import require_setup
from millcorr.process.setup_file import Setup
from millcorr.readers.measurement import Measurement
from millcorr.tolerances import EXACT

from .request import Request

OTHER_FRAMES = re.compile(rb"G(?:5[5-9]|54\.1|52|92|68|10)(?![0-9])|CYCL[ \t]+DEF[ \t]+(?:7|247)\b|TRANS[ \t]+DATUM")
"""Codes, in capitals, that put what follows into another frame than G54."""


@dataclass(frozen=True, eq=False, slots=True)
class History:
    """Corrections that a program carries.

    Parameters
    ----------
    marks : tuple of Mark
        In the order of its comments.
    again : Mark or None
        The one that was made from a part which is now looked at again.
    notes : tuple of str
        What is to be said of that.
    """

    marks: tuple[provenance.Mark, ...]
    again: provenance.Mark | None
    notes: tuple[str, ...]


@dataclass(frozen=True, eq=False, slots=True)
class Moves:
    """Moves that a correction is laid on.

    Parameters
    ----------
    toolpath : Toolpath
    following : (n,) bool
        Those that make the surface.
    along : (n,) bool
        Those that leave stock on it, or make a part of it with another cutter, and go along.
    origin : (n,) int64
        The program's own move that each is, or is a part of.
    """

    toolpath: Toolpath
    following: Bools
    along: Bools
    origin: Ints


@dataclass(frozen=True, eq=False, slots=True)
class Passes:
    """A program as the passes that make a nominal.

    Parameters
    ----------
    nominal : Profile
        Its material on the side that the path leaves.
    drawn : bool
        Whether the path is laid on the exact parallel; what the program itself cuts keeps its chords and rounding.
    radius : float
        Distance in mm from contour to path: the cutter's radius, or 0 where the program states the contour.
    cutters : (n,) float64
        Radius of the cutter of every move of the program, mm; NaN where it is not known, or cuts another part.
    divided : Moves
        Divided where a contour begins on one of them.
    whole : Moves
        Undivided, for a path that stays where it is.
    expected : CompensatedContour or None
        What the program follows, where the nominal was given apart from it: the nominal with what it carries.
    error : float
        How far the moves are off it, mm.
    notes : tuple of str
        What stays as it is, and how the contour was found.
    """

    nominal: Profile
    drawn: bool
    radius: float
    cutters: Floats
    divided: Moves
    whole: Moves
    expected: CompensatedContour | None
    error: float
    notes: tuple[str, ...]

    @property
    def carried(self) -> Correction | None:
        """What the program carries already, mm; None where the nominal is its own."""
        return None if self.expected is None else self.expected.correction


@dataclass(frozen=True, eq=False, slots=True)
class Prepared:
    """A request that can be computed.

    Parameters
    ----------
    request : Request
    history : History
    setup : Setup or None
        For the methods that simulate.
    depths, allowances : tuple of float
        Of each part, mm: how deep it was cut, what stock was left on it.
    surfaces : tuple of Measurement
        The parts' points, allowances taken off.
    passes : Passes
    notes : tuple of str
        What may be wrong, or stays as it is.
    """

    request: Request
    history: History
    setup: Setup | None
    depths: tuple[float, ...]
    allowances: tuple[float, ...]
    surfaces: tuple[Measurement, ...]
    passes: Passes
    notes: tuple[str, ...]

    @property
    def rest(self) -> Correction | None:
        """What stays where nothing was measured, mm; errors of a program that was never corrected go all the same."""
        return self.passes.carried if self.history.marks and self.history.again is None else None

    def commanded_at(self, deviation: Deviation, has_z: bool = False) -> Floats:
        """Offset in mm of the surface that the program commands from the nominal at points; as `commanded_offset`."""
        moves, toolpath = self.passes.divided, self.request.program.toolpath
        making = np.zeros(len(toolpath), dtype=bool)
        making[moves.origin[moves.following]] = True
        # Points without a height are taken for points of the deepest pass: a way back above the part makes no surface.
        deepest = np.nan_to_num(moves.toolpath.end[moves.following, 2], nan=np.inf).min()
        z = deviation.z if has_z else np.full(len(deviation), deepest)
        surface = CommandedSurface(toolpath, self.passes.cutters)
        return commanded_offset(surface, deviation, z, self.passes.expected, making)


def prepare(request: Request, *, check: bool = False) -> Prepared:
    """Read a program as passes about a nominal.

    Parameters
    ----------
    request : Request
    check : bool
        True where nothing will be written: a measurement that the program carries already is then looked at, with a
        warning, in place of being refused.

    Returns
    -------
    Prepared

    Raises
    ------
    UsageError, InputError, FormatError
        If the request or the program cannot be used.
    RefusedError
        If the program carries a correction from the measurement.
    """
    progress.stage("prepare")
    settings, program = request.settings, request.program
    if not 0 < request.radius < np.inf:
        raise UsageError(phrase("the tool diameter {} must be a length above 0", mm(2 * request.radius, "g")))
    count = len(request.measurements)
    if len({m.fingerprint for m in request.measurements}) < count:
        raise UsageError(phrase("the same measurement is given twice: averaging needs different parts"))
    depths = settings.each("depth", count)
    _require_a_cut(settings, request.radius)
    allowances = settings.each("allowance", count)
    history = _history(request, allowances, check)
    setup = require_setup(request.setup, settings, request.radius) if settings.with_setup else None
    _require_measured_or_not(request)
    surfaces = tuple(taken_down(m, a) for m, a in zip(request.measurements, allowances, strict=True))
    progress.step()
    passes = _passes(request, bool(history.marks), surfaces[0] if surfaces else None)
    if setup is not None and not settings.depths and setup.stock.allowance_mm is not None:
        # What an elastic machine may leave of this depth is no mistake.
        depths = tuple(max(setup.stock.allowance_mm - allowance, 0.0) for allowance in allowances)
    program.require_plain(_touched(passes))
    return Prepared(request, history, setup, depths, allowances, surfaces, passes, history.notes + passes.notes)


def _history(request: Request, allowances: tuple[float, ...], check: bool) -> History:
    program = request.program
    carried = provenance.marks(program.comments())
    digests = [m.fingerprint for m in request.measurements]
    again = provenance.applied(carried, digests) if check else None
    notes: tuple[str, ...] = ()
    if again is not None:
        notes = (
            phrase(
                "{} carries the correction from this measurement already, since {}: the part was cut by an "
                "earlier program, so all is shown as if this one carried no correction",
                program.name,
                again.date,
            ),
        )
    if carried and any(allowances):
        raise InputError(
            phrase(
                "{}:{}: a part with stock left was cut by a first cut of the uncorrected program: give that "
                "as {}, not one that was corrected since",
                program.name,
                carried[-1].line,
                option("program"),
            ),
        )
    unknown = () if again is not None else digests
    provenance.refuse_second_use(carried, unknown, program.name, request.nominal is not None)
    return History(carried, again, notes)


def _require_measured_or_not(request: Request) -> None:
    """UsageError where a method needs a measurement that is missing, or takes none."""
    settings, measured = request.settings, request.measurement is not None
    if settings.method == "combined" and not measured:
        raise UsageError(
            phrase(
                "{} needs {}: one touch or two; without any {}",
                option("method", "combined"),
                option("measured", of="FILE"),
                remedy("method", "predicted"),
            ),
        )
    if settings.method == "predicted" and measured:
        raise UsageError(
            phrase(
                "{} takes no {}: with touches use {}",
                option("method", "predicted"),
                option("measured"),
                remedy("method", "combined"),
            ),
        )
    if settings.leave_stock and measured:
        raise UsageError(phrase("a first cut that leaves stock is made before anything is measured"))


def _passes(request: Request, corrected: bool, measurement: Measurement | None) -> Passes:
    """The moves that make the nominal, and the nominal where it is the program's own."""
    program, settings = request.program, request.settings
    usable, path_radius = _usable(program, request.radius, settings)
    cutters, notes = _cutters(program, request, path_radius, measurement)
    own = np.where(program.toolpath.compensation != Compensation.OFF, path_radius, request.radius)
    mine = usable & (np.abs(cutters - own) < EXACT)
    if request.nominal is None:
        nominal, moves, more = _of_its_own(request, path_radius, mine, measurement)
        notes += more
        found, whole, drawn = None, moves, False
    else:
        drawn = not request.nominal_is_first_program
        nominal, found, moves, whole = _of_a_nominal(
            request, request.nominal, path_radius, mine, cutters, drawn, settings.limit if corrected else 0.0
        )
    if not moves.following.any():
        raise InputError(phrase("{}: no move runs along the contour that the points lie on", program.name))
    # The same wall may be another cutter's, too, as beside the corners that it clears.
    others = (usable & np.isfinite(cutters) & ~mine)[moves.origin] & ~moves.following
    if others.any() and request.nominal is None:
        surface = CommandedSurface(moves.toolpath, cutters[moves.origin])
        moves = replace(moves, along=sharing(surface, others, nominal, program.resolution))
    if settings.keep_allowance:
        # What roughs comes before what finishes.
        earlier = np.arange(len(moves.toolpath)) < np.flatnonzero(moves.following)[-1]
        rows = usable[moves.origin] & earlier & ~moves.following
        along = _roughing(moves.toolpath, cutters[moves.origin], rows, nominal, request)
        moves = replace(moves, along=moves.along | along)
    expected, error = (None, 0.0) if found is None else (found.expected, found.error)
    return Passes(nominal, drawn, path_radius, cutters, moves, whole, expected, error, notes)


def _of_its_own(
    request: Request, path_radius: float, usable: Bools, measurement: Measurement | None
) -> tuple[Profile, Moves, tuple[str, ...]]:
    """The nominal that a program cuts, the moves that cut it, and what is to be said of it."""
    program, settings = request.program, request.settings
    toolpath, kept = program.toolpath, np.ones(len(program.toolpath), dtype=bool)
    if settings.leave_stock:
        toolpath, kept = _for_first_cut(program, request, path_radius, usable)
        usable = usable[kept]
    if settings.method == "predicted":
        _require_side(settings, toolpath, usable)
    nominal, cut, notes = _own_contour(program, toolpath, settings, measurement, request.radius, path_radius, usable)
    following = on_the_path(toolpath, usable, cut, program.resolution)
    return nominal, Moves(toolpath, following, np.zeros(len(toolpath), dtype=bool), np.flatnonzero(kept)), notes


def _of_a_nominal(
    request: Request, nominal: Profile, path_radius: float, usable: Bools, cutters: Floats, drawn: bool, reach: float
) -> tuple[Profile, Commanded, Moves, Moves]:
    """A nominal turned to the path, the moves that follow it, these divided at its contours' starts, and whole."""
    toolpath = request.program.toolpath
    nominal, commanded = _turned_to_the_path(nominal, toolpath, path_radius, usable, reach, True)
    wanted = commanded.expected.correction if drawn else None
    rough = _roughing(toolpath, cutters, commanded.following, nominal, request, wanted)
    if rough.any():
        usable = usable & ~rough
        nominal, commanded = _turned_to_the_path(nominal, toolpath, path_radius, usable, reach, True)
    none = np.zeros(len(toolpath), dtype=bool)
    moves = whole = Moves(toolpath, commanded.following, none, np.arange(len(toolpath)))
    divided, origin = cut_onto_the_contour(toolpath, commanded.following)
    if len(divided) > len(toolpath) and drawn:
        _, found = _turned_to_the_path(nominal, divided, path_radius, usable[origin], reach, False)
        # What only touches the contour is no part of it, and stays one move.
        if len(np.unique(origin[found.following])) > commanded.following.sum():
            commanded, moves = found, Moves(divided, found.following, none[origin], origin)
    return nominal, commanded, moves, whole


def _touched(passes: Passes) -> Bools:
    """Moves of the program that are written anew, or may be; (n,)."""
    moves = passes.divided
    out = np.zeros(len(passes.cutters), dtype=bool)
    out[moves.origin[beside_the_path(moves.toolpath, moves.following | moves.along)]] = True
    return out


def nominal_from_program(
    program: nc.Program, radius: float, settings: Settings, measurement: Measurement | None
) -> Profile:
    """The profile that an uncorrected program cuts.

    Parameters
    ----------
    program : Program
    radius : float
        Cutter radius, mm.
    settings : Settings
        Its side and cutter compensation.
    measurement : Measurement or None
        Chooses the contours near its points, and the side where the program does not say.

    Raises
    ------
    InputError
        If the program was corrected before, or cuts no contour near the points.
    """
    carried = provenance.marks(program.comments())
    if carried:
        raise InputError(
            phrase(
                "{}:{}: {} names a corrected program; give the first, uncorrected one",
                program.name,
                carried[-1].line,
                option("nominal"),
            ),
        )
    usable, path_radius = _usable(program, radius, settings)
    if measurement is not None:
        measurement = taken_down(measurement, (*settings.allowances, 0.0)[0])
    return _own_contour(program, program.toolpath, settings, measurement, radius, path_radius, usable)[0]


def _require_a_cut(settings: Settings, radius: float) -> None:
    """UsageError where a depth along the normal is more than the cutter is wide."""
    for key, values in (("depth", settings.depths), ("next_depth", (settings.next_depth or 0.0,))):
        for value in values:
            if value > 2 * radius:
                raise UsageError(
                    phrase(
                        "{}: a cutter of {} takes no more than its width off; the depth is meant along the contour's "
                        "normal, from the stock to the surface, in mm",
                        option(key, value),
                        mm(2 * radius, "g"),
                    ),
                )


def taken_down(measurement: Measurement, allowance: float) -> Measurement:
    """Points of a surface that lies an allowance over the nominal, in mm, compared with the nominal itself.

    To the profile they are what centres of a ball of that radius are: exact on any contour.
    """
    return replace(measurement, ball_radius=measurement.ball_radius + allowance) if allowance else measurement


def _roughing(
    toolpath: Toolpath,
    cutters: Floats,
    rows: Bools,
    nominal: Profile,
    request: Request,
    wanted: Correction | None = None,
) -> Bools:
    """Which of some moves of a program leave stock on the nominal for others; (n,)."""
    surface, resolution = CommandedSurface(toolpath, cutters), request.program.resolution
    return roughing(surface, rows, nominal, resolution, request.settings.limit, wanted)


def _for_first_cut(program: nc.Program, request: Request, path_radius: float, usable: Bools) -> tuple[Toolpath, Bools]:
    """Moves with corners for the fillets that a first cut has no room for, and which of the program's are kept."""
    settings, toolpath = request.settings, program.toolpath
    _require_side(settings, toolpath, usable)
    right = choose_side(toolpath, usable, settings.side, None, request.radius, path_radius)
    return without_vanishing_arcs(toolpath, usable, right, settings.leave_stock)


def _require_side(settings: Settings, toolpath: Toolpath, usable: Bools) -> None:
    """UsageError where neither the settings nor the program say on which side the cutter runs."""
    if settings.side == "auto" and not (toolpath.compensation[usable] != Compensation.OFF).any():
        raise UsageError(
            phrase(
                "{} or {}: the program has no G41 or G42 that tells the side of the cutter",
                remedy("side", "left"),
                remedy("side", "right"),
            ),
        )


def _own_contour(
    program: nc.Program,
    toolpath: Toolpath,
    settings: Settings,
    measurement: Measurement | None,
    radius: float,
    path_radius: float,
    usable: Bools,
) -> tuple[Profile, list[CutContour], tuple[str, ...]]:
    """The contour that the program cuts near the measured points, what cuts it, and what is to be said of it."""

    def doubt(everything: Profile) -> None:
        if measurement is not None and measurement.axis_radii is None and measurement.probe is None:
            found = plausibility.examine_points(measurement, everything, radius)
            plausibility.refuse_dangerous(found, settings.accept, measurement.source)

    try:
        right = choose_side(toolpath, usable, settings.side, measurement, radius, path_radius)
    except InputError:
        # Points in another frame lie on no side; a contour on the better one shows which frame it is.
        for side in (False, True):
            try:
                doubt(nominal_of(toolpath, usable, path_radius, side, None, program.name)[0])
            except DistrustError as error:
                if error.finding in ("unit", "mirrored", "turned"):
                    raise
            except InputError:
                continue
        raise
    nominal, notes, cut = nominal_of(
        toolpath, usable, path_radius, right, measurement, program.name, doubt, resolution=program.resolution
    )
    return nominal, cut, tuple(notes)


def _cutters(
    program: nc.Program, request: Request, path_radius: float, measurement: Measurement | None
) -> tuple[Floats, tuple[str, ...]]:
    """Radius of the cutter of every move of the program, mm; NaN where it is not known, or cuts another part.

    Beside what is to be said of such moves.
    """
    other, notes = _other_parts(program, request, path_radius, measurement)
    if len(np.unique(program.toolpath.tool)) < 2:
        radii = cutter_radii(program.toolpath, request.radius, path_radius, {}, measurement)[0]
        return np.where(other, np.nan, radii), notes
    scale = 25.4 if (program.modal.unit == 20).any() else 1.0
    stated = stated_diameters(program.comments(), scale) | dict(request.settings.tool_diameters)
    radii, unknown = cutter_radii(program.toolpath, request.radius, path_radius, stated, measurement)
    if unknown:
        names = [program.tool(tool) for tool in unknown if tool != -1]
        listed = [f"T{name}" if name.isdigit() else name for name in names]
        listed += ["the tool before the first T word"] if -1 in unknown else []
        way_out = (
            phrase("{} states it", option("tools", of=f"{names[0]}=MM"))
            if names
            else phrase("a T word before its cuts gives it a number to state")
        )
        what = phrase("the diameter of {} is not known", ", ".join(listed))
        notes += (phrase("{}: what it cuts stays as it is and is not looked at; {}", what, way_out),)
    return np.where(other, np.nan, radii), notes


def _other_parts(
    program: nc.Program, request: Request, path_radius: float, measurement: Measurement | None
) -> tuple[Bools, tuple[str, ...]]:
    """Moves under another work offset than those that made the points, or in a frame that is turned or moved; (n,).

    Beside what is to be said of them.
    """
    toolpath = program.toolpath
    out = np.zeros(len(toolpath), dtype=bool)
    if not OTHER_FRAMES.search(program.data.upper()):
        return out, ()
    out |= program.opaque_moves()
    moves = moves_of(program.data, program.beside)
    if not len(moves) or measurement is None:
        return out, ()
    offset = moves.offset[np.clip(np.searchsorted(moves.line, toolpath.source, side="right") - 1, 0, None)]
    cuts = (toolpath.kind != Kind.RAPID) & np.isfinite(toolpath.end[:, :2]).all(axis=1) & ~out
    _, first = np.unique(offset[cuts], return_index=True)
    frames = offset[cuts][np.sort(first)].tolist()
    if len(frames) < 2:
        return out, ()
    away = abs(path_radius - measurement.ball_radius), abs(request.radius - measurement.ball_radius)
    mine = nearest_group(toolpath, cuts, offset, frames, away, measurement)
    note = phrase(
        "what is cut under {} is another part than the measured one, cut under {}: it stays as it is",
        _offset_name(frames[0] if frames[0] != mine else frames[1]),
        _offset_name(mine),
    )
    return out | (offset != mine), (note,)


def _offset_name(offset: int) -> str:
    """G54, G54.1 P2: a work offset as `PlainMoves.offset` numbers it; below 1 the datum shifts of plain language."""
    if offset <= 0:
        return f"datum shift {-offset}" if offset else "no datum shift"
    code, number = divmod(offset, 1000)
    return f"G{code / 10:g}" + (f" P{number}" if number else "")


def _usable(program: nc.Program, radius: float, settings: Settings) -> tuple[Bools, float]:
    """Moves that may be corrected, and the distance from path to contour, mm."""
    usable = ~program.opaque_moves()
    feeds = program.toolpath.kind != Kind.RAPID
    if not feeds.any():
        raise InputError(phrase("{}: the program has no feed move that could follow a contour", program.name))
    if not (feeds & usable).any():
        program.require_plain(feeds)
    if program.opaque and not any(usable[run].any() for run in cutting_runs(program.toolpath)):
        why = program.opaque[0]
        raise FormatError(
            phrase(
                "nothing that runs along a contour is read: {}; write the moves in place of this line, as {}",
                why.reason,
                program.plain_moves,
            ),
            program.name,
            program.line_of(why.first) + 1,
        )
    compensated = program.toolpath.compensation != Compensation.OFF
    if not compensated.any():
        return usable, radius
    return usable & compensated, 0.0 if settings.cutter_compensation == "contour" else radius


def _turned_to_the_path(
    nominal: Profile, toolpath: Toolpath, radius: float, usable: Bools, limit: float, given: bool
) -> tuple[Profile, Commanded]:
    """Nominal with its material on the side that the path leaves, and the path's following moves."""
    try:
        plain = CompensatedContour(nominal, Correction.none(nominal))
        return nominal, Commanded.find(toolpath, plain, radius, usable, limit)
    except LimitError:
        if not given:
            raise
        other = nominal.reversed()
        plain = CompensatedContour(other, Correction.none(other))
        try:
            return other, Commanded.find(toolpath, plain, radius, usable, limit)
        except LimitError:
            pass
        raise
