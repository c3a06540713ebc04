# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one use case: a program and a measurement in, a corrected toolpath with its proof out."""

from __future__ import annotations

import hashlib
import logging
import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import PurePath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import __version__, alignment, distrust, gcode, provenance
from .commanded import (
    EXACT,
    Commanded,
    CommandedSurface,
    beside_the_path,
    choose_side,
    commanded_offset,
    cut_onto_the_contour,
    nominal_of,
    on_the_path,
    roughing,
)
from .comparison.cutters import cutter_radii, nearest_group, stated_diameters
from .compensation import Correction
from .deviation import Deviation, deviations, require_heights, statistics
from .errors import DistrustError, FormatError, InputError, LimitError, UsageError
from .footpoint import FootPointSearch
from .largest import largest_correction
from .measurement import Measurement
from .path.emission import Emission, emit
from .path.reading import read_moves
from .prediction import Aim, Simulation, simulate
from .prediction.combined_control import AxisTransfer, Machine
from .prediction.foreseen import FirstCut, Foreseen, aim_of, combined_target, foresee, predicted_target, require_setup
from .probe import axis_residue, contact_known, numbered_as_read
from .profile import Profile
from .reconstruction import CompensatedContour
from .regeneration import Regeneration
from .regeneration.vanishing_arcs import without_vanishing_arcs
from .separation import Separated
from .separation.steps import Systematic
from .settings import Settings as Settings
from .setup_file import Setup
from .targets import Elastic, Part, Target, carried_along, correction_through, smoothed_over_parts, target_of
from .theoretical_contour import CutContour, cutting_runs
from .toolpath import Compensation, Kind, Toolpath
from .verification import Verification

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

log = logging.getLogger(__name__)

OTHER_FRAMES = re.compile(rb"[Gg](5[5-9]|54\.1|52|92|68|10)(?![0-9])")
"""Codes that put what follows into another frame than G54."""

LEAST_UNDER = 0.05
"""A first cut leaves its allowance and what the machine yields, never less by more than this, in mm."""


@dataclass(frozen=True, eq=False, slots=True)
class Request:
    """What to correct.

    Parameters
    ----------
    program : Program
        The NC program, or the text of a CAM operation's path.
    radius : float
        Cutter radius in mm.
    measurement : Measurement or None
        None lays the path on the exact nominal and corrects nothing.
    nominal : Profile, optional
        The profile the part should have; by default what the program cuts.
    settings : Settings
    further : tuple of Measurement
        Further parts cut with the same program; the first one's deviations become the mean of all. Where they were
        cut at other depths, they tell the transfer function from a constant offset.
    smoothed : Correction, optional
        What to take out, mm over arc length, in place of what this part shows: smoothed over the parts of a series. Of
        a program that was corrected before the deviation from the nominal, of another one what the machine adds.
    setup : Setup, optional
        Tool, material, machine and stock, for the methods that simulate.
    nominal_is_first_program : bool
        True where the nominal is what the first, uncorrected program cuts: the path keeps that program's form.
    shift : Correction, optional
        Displacement of the nominal that is known beforehand, in place of one from a measurement.
    """

    program: gcode.Program
    radius: float
    measurement: Measurement | None
    nominal: Profile | None = None
    settings: Settings = field(default_factory=Settings)
    further: tuple[Measurement, ...] = ()
    smoothed: Correction | None = None
    setup: Setup | None = None
    shift: Correction | None = None
    in_series: bool = False
    nominal_is_first_program: bool = False

    @property
    def measurements(self) -> tuple[Measurement, ...]:
        """All measured parts; none where nothing was measured."""
        return () if self.measurement is None else (self.measurement, *self.further)


@dataclass(frozen=True, eq=False, slots=True)
class Result:
    """A correction and its proof.

    Parameters
    ----------
    request : Request
    nominal, compensated : Profile
    correction : Correction
    alignment : Alignment or None
        What the best fit moved; None without one.
    deviation : Deviation
        Against the nominal; empty without a measurement.
    filtered : (n,) float64
        Determined part of each deviation, mm.
    uncertainty : (n,) float64
        Standard uncertainty (k = 1) of the determined part at each point, mm; NaN where it is not known.
    predicted : (n,) float64
        What the same machine is expected to leave at each point after the correction, mm.
    commanded : (n,) float64
        Offset of the program's own contour from the nominal at each point, mm.
    carried : Correction or None
        The same all along the contour, for a program that was corrected before; None for another one.
    systematic : Systematic or None
        What repeats, anywhere on the contours; None without a measurement of the whole contour.
    outlier : (n,) bool
        Points that are more probably wrong than right; the model and robust filters leave them out.
    random_std : float
        Standard deviation of the random part, mm; NaN where it is not known.
    elastic : Elastic or None
        Transfer function at the used points, and the depth it was carried to; None without one.
    foreseen : Foreseen or None
        What the model of a setup says before and after; None without one.
    regeneration : Regeneration
    path_radius : float
        Distance in mm between path and contour: the cutter radius, or 0 where the program gives the contour.
    fit_residual : float
        Largest distance between the exact compensated contour and its NURBS, mm.
    verification : Verification
    text : bytes
        The corrected program; the very bytes of the original where nothing changed.
    advice : tuple of str
        What to expect of the next part, and what the readers did or left out beyond copying numbers.
    warnings : tuple of str
        What may be wrong or was not possible.
    noted : tuple of (24,) int64
        Deviations of each part that the corrected program notes, to recognise the part by.
    """

    request: Request
    nominal: Profile
    compensated: Profile
    correction: Correction
    alignment: alignment.Alignment | None
    deviation: Deviation
    filtered: Floats
    uncertainty: Floats
    predicted: Floats
    commanded: Floats
    carried: Correction | None
    systematic: Systematic | None
    outlier: NDArray[np.bool_]
    random_std: float
    elastic: Elastic | None
    foreseen: Foreseen | None
    regeneration: Regeneration
    path_radius: float
    fit_residual: float
    verification: Verification
    text: bytes
    advice: tuple[str, ...]
    warnings: tuple[str, ...]
    noted: tuple[Ints, ...] = ()

    @property
    def correction_uncertainty(self) -> Floats:
        """Standard uncertainty of the correction at each point, mm; NaN where it is not known. (n,)."""
        elastic = self.elastic
        own = self.uncertainty if elastic is None else elastic.transfer.correction_std(elastic.next_depth)
        return self.request.settings.gain * own

    @property
    def separated(self) -> Separated | None:
        """What repeats where the form is kept; None without a measurement of the whole contour."""
        return None if self.systematic is None else self.systematic.separated

    def summary(self) -> dict[str, Any]:
        """The contents of report.json."""
        curves = [c.as_dict() for contour in self.compensated.contours for c in contour.curves]
        first = curves[0]
        keys = ("degree", "poles", "weights", "knots", "multiplicities", "periodic")
        d = self.deviation
        uncertainty = statistics(self.uncertainty[np.isfinite(self.uncertainty)])
        largest = largest_correction(self.correction, self.nominal)
        return {
            "millcorr": __version__,
            "unit": "mm",
            "points": {
                "read": len(d) + len(d.rejected),
                "used": len(d),
                "rejected": [{"index": r.index, "reason": r.reason} for r in d.rejected],
            },
            "deviation": statistics(d.value),
            "filtered": statistics(self.filtered),
            "random_std": self.random_std,
            "path_error_of_program": self.regeneration.original_error,
            "predicted": statistics(self.predicted),
            "correction": {
                "max": self.correction.largest,
                "limited": 0,
                "largest": largest.value,
                "place": list(largest.point),
                "uncertainty_max": float(np.fmax.reduce(self.correction_uncertainty, initial=np.nan)),
            },
            "uncertainty": uncertainty,
            "band": None if self.separated is None else self.separated.band,
            "band_longest_memory": None if self.separated is None else self.separated.longest_memory,
            "outliers": self.outliers(),
            "unmeasured": 0.0 if self.separated is None else distrust.unmeasured(self.separated, self.nominal),
            "transfer": None if self.elastic is None else self.elastic.summary(self.request.settings),
            "foreseen": None if self.foreseen is None else self.foreseen.summary(),
            "alignment": self._alignment_summary(),
            "profile": {k: first[k] for k in keys} | {"curves": curves, "fit_residual": self.fit_residual},
            "verification": {
                "path_error_max": self.verification.path_error_max,
                "gouge_max": self.verification.gouge_max,
                "length": self.verification.length,
            },
            "moves": {"changed": self.regeneration.changed, "written": len(self.regeneration.toolpath)},
            "inputs": self.inputs(),
            "settings": {name: getattr(self.request.settings, name) for name in Settings.__slots__},
            "advice": list(self.advice),
            "warnings": list(self.warnings),
        }

    def outliers(self) -> list[dict[str, Any]]:
        """Points that are more probably wrong than right, by their row of the file; lengths in mm."""
        measurement, d = self.request.measurement, self.deviation
        if measurement is None:
            return []
        rows = np.flatnonzero(self.outlier)
        points = measurement.points[d.index[rows]].tolist()
        return [
            {
                "index": int(d.index[i]),
                **dict(zip("xyz", point, strict=True)),
                "value": float(d.value[i]),
                "expected": float(self.filtered[i]),
            }
            for i, point in zip(rows, points, strict=True)
        ]

    def _alignment_summary(self) -> dict[str, Any]:
        fit = self.alignment
        if fit is None:
            return {"shift": [0.0, 0.0], "rotation_deg": 0.0}
        return {
            "shift": list(fit.transform.shift),
            "rotation_deg": float(np.degrees(fit.transform.rotation)),
            "free": list(fit.free),
            "undetermined": list(fit.undetermined),
            "mean_before": fit.before.mean,
            "mean_after": fit.after.mean,
            "rms_before": fit.before.rms,
            "rms_after": fit.after.rms,
            "scale": fit.scale,
        }

    def inputs(self) -> dict[str, Any]:
        """Names and SHA-256 of what went in."""
        program = self.request.program
        out: dict[str, Any] = {"program": {"name": program.name, "sha256": program.digest}}
        for number, measurement in enumerate(self.request.measurements, 1):
            key = "measurement" if number == 1 else f"measurement {number}"
            out[key] = {"name": measurement.source, "sha256": measurement.digest}
        return out

    def header(self) -> tuple[str, ...]:
        """Comment lines that mark the corrected program."""
        return _header(self.request, self.noted)


def correct(request: Request, *, check: bool = False) -> Result:
    """Correct a toolpath from a measured part.

    Parameters
    ----------
    request : Request
    check : bool
        True where nothing will be written: a measurement that the program carries already is then looked at, with a
        warning, in place of being refused.

    Returns
    -------
    Result

    Raises
    ------
    UsageError, InputError, FormatError
        If the request or a file cannot be used.
    RefusedError, LimitError, FitError
        If the correction would be unsafe: nothing is changed.
    """
    settings, program = request.settings, request.program
    toolpath = program.toolpath
    if not 0 < request.radius < np.inf:
        raise UsageError(f"the tool diameter {2 * request.radius:g} mm must be a length above 0")
    warnings: list[str] = []
    carried = provenance.marks(program.comments())
    digests = [m.fingerprint for m in request.measurements]
    if len(set(digests)) < len(digests):
        raise UsageError("the same measurement is given twice: averaging needs different parts")
    depths = settings.each("depth", len(digests))
    _require_a_cut(settings, request.radius)
    allowances = settings.each("allowance", len(digests))
    surfaces = [_taken_down(m, a) for m, a in zip(request.measurements, allowances, strict=True)]
    measurement = surfaces[0] if surfaces else None
    again = provenance.applied(carried, digests) if check else None
    if again is not None:
        warnings.append(
            f"{program.name} carries the correction from this measurement already, since {again.date}: the part was "
            "cut by an earlier program, so all is shown as if this one carried no correction"
        )
    unknown = () if again is not None else digests
    if carried and any(allowances):
        raise InputError(
            f"{program.name}:{carried[-1].line}: a part with stock left was cut by a first cut of the uncorrected "
            "program: give that as --program, not one that was corrected since"
        )
    provenance.refuse_second_use(carried, unknown, program.name, request.nominal is not None)
    setup = require_setup(request.setup, settings, request.radius) if settings.with_setup else None
    if settings.method == "combined" and measurement is None:
        raise UsageError("--method combined needs --measured FILE: one touch or two; without any --method predicted")
    if settings.method == "predicted" and measurement is not None:
        raise UsageError("--method predicted takes no --measured: with touches use --method combined")

    usable, path_radius = _usable(program, request.radius, settings)
    cutters = _cutters(program, request, path_radius, measurement, warnings)
    plain = usable
    own = np.where(toolpath.compensation != Compensation.OFF, path_radius, request.radius)
    usable = usable & (np.abs(cutters - own) < EXACT)
    kept = np.ones(len(toolpath), dtype=bool)
    if settings.leave_stock:
        if measurement is not None:
            raise UsageError("a first cut that leaves stock is made before anything is measured")
        if request.nominal is None:
            toolpath, kept = _for_first_cut(program, request, path_radius, usable)
            usable = usable[kept]
    nominal = request.nominal
    # What the program itself cuts keeps its chords and rounding; on a drawing the path is laid exactly.
    drawn = nominal is not None and not request.nominal_is_first_program
    row_of, none = np.flatnonzero(kept), np.zeros(len(toolpath), dtype=bool)
    expected: CompensatedContour | None = None
    original_error = 0.0
    if nominal is None:
        if settings.method == "predicted":
            _require_side(settings, toolpath, usable)
        nominal, cut = _own_contour(
            program, toolpath, settings, measurement, request.radius, path_radius, usable, warnings
        )
        following = on_the_path(toolpath, usable, cut, program.resolution)
        whole = toolpath, following, row_of, none
    else:
        reach = settings.limit if carried else 0.0
        nominal, commanded = _turned_to_the_path(nominal, toolpath, path_radius, usable, reach, True)
        carried_there = commanded.expected.correction if drawn else None
        rough = _roughing(toolpath, cutters, commanded.following, nominal, program, settings, carried_there)
        if rough.any():
            usable = usable & ~rough
            nominal, commanded = _turned_to_the_path(nominal, toolpath, path_radius, usable, reach, True)
        whole = toolpath, commanded.following, row_of, none
        following = commanded.following
        divided, row = cut_onto_the_contour(toolpath, commanded.following)
        if len(divided) > len(toolpath) and drawn:
            _, found = _turned_to_the_path(nominal, divided, path_radius, usable[row], reach, False)
            # What only touches the contour is no part of it, and stays one move.
            if len(np.unique(row[found.following])) > commanded.following.sum():
                toolpath, following, row_of, commanded = divided, found.following, row, found
        expected, original_error = commanded.expected, commanded.error
    if not following.any():
        raise InputError(f"{program.name}: no move runs along the contour that the points lie on")
    along = np.zeros(len(toolpath), dtype=bool)
    if settings.keep_allowance:
        # What roughs comes before what finishes.
        earlier = np.arange(len(toolpath)) < np.flatnonzero(following)[-1]
        along = _roughing(toolpath, cutters[row_of], plain[row_of] & earlier & ~following, nominal, program, settings)
    rows = np.zeros(len(kept), dtype=bool)
    rows[row_of[beside_the_path(toolpath, following | along)]] = True
    program.require_plain(rows)
    surface = CommandedSurface(program.toolpath, cutters)

    making = np.zeros(len(program.toolpath), dtype=bool)
    making[row_of[following]] = True
    # Points without a height are taken for points of the deepest pass: a way back above the part makes no surface.
    deepest = np.nan_to_num(toolpath.end[following, 2], nan=np.inf).min()

    def offset_of(deviation: Deviation, has_z: bool = False) -> Floats:
        z = deviation.z if has_z else np.full(len(deviation), deepest)
        return commanded_offset(surface, deviation, z, expected, making)

    before: Simulation | None = None
    axes: AxisTransfer | None = None
    machine_found: Machine | None = None
    first: FirstCut | None = None
    aim: Aim | None = None
    correction = Correction.none(nominal)
    exact: Correction | None = None
    # What was not measured stays as the program has it; errors of an uncorrected one's own go all the same.
    rest = expected.correction if expected is not None and carried and again is None else None
    if setup is not None and settings.method == "predicted":
        before = simulate(program, setup, nominal)
        request = replace(request, measurement=before.surface())

    aligned: alignment.Alignment | None = None
    noted: list[Ints] = []
    if before is not None:
        deviation = deviations(before.surface(), nominal, cutter_radius=request.radius)
        offset = offset_of(deviation)
        as_cut = Part(deviation, offset, deviation.value - offset)
        work = predicted_target(as_cut, nominal, before.setup, settings, bool(carried), warnings)
        aim = aim_of(work)
    elif measurement is None:
        correction, work = request.shift or Correction.even(nominal, settings.leave_stock), Target.empty()
    else:
        parts: list[Part] = []
        sources: list[str] = []
        heights = distrust.CutHeights.of(toolpath, following, nominal)
        if setup is not None and not settings.depths and setup.stock.allowance_mm is not None:
            # What an elastic machine may leave of this depth is no mistake.
            depths = tuple(max(setup.stock.allowance_mm - allowance, 0.0) for allowance in allowances)
        for read, part, depth, allowance in zip(request.measurements, surfaces, depths, allowances, strict=True):
            naming = partial(distrust.named, read.source if len(surfaces) > 1 else "")
            alone = distrust.refuse_dangerous(distrust.examine_file(read), settings.accept, read.source)
            warnings += [note for note in naming(alone) if note not in warnings]
            _refuse_wrong_allowance(part, nominal, allowance)
            moved, fit = _believed(part, nominal, request, depth, allowance, warnings)
            aligned = aligned or fit
            # A cutter that leaves an allowance reaches the nominal where one larger by it would.
            reaching = request.radius + allowance
            sources.append(read.source)
            deviation = numbered_as_read(deviations(moved, nominal, cutter_radius=reaching), moved)
            noted.append(provenance.values_of(deviation, nominal))
            # Parts of a series come back to the same size by wear; its journal knows which it has seen.
            known = again is not None or request.in_series
            otherwise = None if known else provenance.recognised(carried, noted[-1], distrust.resolution(read))
            if otherwise is not None:
                provenance.refuse_mark(otherwise, program.name)
            # A first cut that millcorr wrote runs on the exact parallel; what this program is off by came after it.
            cut_by_another = allowance or again is not None
            offset = np.zeros(len(deviation)) if cut_by_another else offset_of(deviation, part.has_z)
            if len(lost := np.flatnonzero(np.isnan(offset))):
                deviation = deviation.without(lost, "where another move of the program cuts the profile away")
                offset = np.delete(offset, lost)
            machine = deviation.value - offset
            if request.nominal is None and not cut_by_another:
                # The nominal is what the passes leave; the profile only says where and which way.
                deviation, offset = replace(deviation, value=machine), np.zeros(len(machine))
            findings = distrust.examine_deviations(
                deviation,
                nominal,
                request.radius,
                ball_radius=moved.ball_radius - allowance,
                heights=heights if part.has_z else None,
                step=distrust.resolution(read),
                depth=depth,
            )
            if carried and not cut_by_another:
                findings += distrust.examine_program(deviation, offset, provenance.gain(program.comments()))
            if len(surfaces) > 1:
                # One part without a deviation is a warning; among several it would take its share of the others'.
                same = "identical-to-nominal"
                findings = tuple(replace(f, dangerous=f.dangerous or f.name == same) for f in findings)
            notes = distrust.refuse_dangerous(findings, settings.accept, part.source)
            warnings += [note for note in naming(notes) if note not in warnings]
            parts.append(Part(deviation, offset, machine, allowance))
        if settings.method != "combined":
            with_points = [(m, p.deviation) for m, p in zip(request.measurements, parts, strict=True)]
            together = distrust.examine_parts(with_points, nominal)
            warnings += distrust.refuse_dangerous(together, settings.accept, sources[0])
        if setup is not None:
            first = _first_cut(request, nominal, allowances[0])
            work, aim, before, axes, machine_found = combined_target(
                parts, program, nominal, setup, settings, bool(carried), first,
                offset_of, warnings,
            )  # fmt: skip
        else:
            work = target_of(parts, nominal, settings, bool(carried), warnings)
            if work.separated is not None:
                seen = distrust.examine_separated(work.deviation, work.separated, nominal, settings.unmeasured_share)
                warnings += distrust.refuse_dangerous(seen, settings.accept, sources[0])
        if request.smoothed is not None:
            work = smoothed_over_parts(work, request.smoothed, nominal, settings)
        if aim is None:
            exact = None if rest is None else carried_along(rest, work, nominal)
            correction = correction_through(work, nominal, settings, warnings, rest if work.smoothed is None else exact)

    header = _header(request, noted)

    def lay(correction: Correction) -> Emission:
        moves, rows, origin, roughs = (toolpath, following, row_of, along) if correction.largest > EXACT else whole
        emission, notes = emit(
            program,
            moves,
            rows,
            roughs,
            nominal,
            correction,
            path_radius,
            cutters[origin],
            settings,
            header=header,
            carried=None if expected is None else expected.correction,
            exact=drawn,
            original_error=original_error,
        )
        warnings.extend(note for note in notes if note not in warnings)
        return emission

    foreseen: Foreseen | None = None
    if aim is None or before is None:
        written = lay(correction)
    else:
        foreseen, correction, written = foresee(aim, before, first, settings, program.name, lay, warnings)
        foreseen = replace(foreseen, axes=axes, machine=machine_found)
    if correction.largest > EXACT:
        of_program = replace(written.regeneration, origin=row_of[written.regeneration.origin])
        written = replace(written, regeneration=of_program)
    applied = np.zeros(len(work.deviation))
    if len(work.deviation):
        applied = correction.at(work.deviation.stretch, work.deviation.s, nominal)
    return Result(
        request=request,
        nominal=nominal,
        compensated=written.compensated,
        correction=correction,
        alignment=aligned,
        deviation=work.deviation,
        filtered=work.filtered,
        uncertainty=work.uncertainty,
        predicted=work.predicted(applied) if foreseen is None else foreseen.left_at(work),
        commanded=work.commanded,
        carried=exact,
        systematic=work.systematic,
        outlier=np.zeros(len(work.deviation), dtype=bool) if work.outlier is None else work.outlier,
        random_std=work.random_std,
        elastic=work.elastic,
        foreseen=foreseen,
        regeneration=written.regeneration,
        path_radius=path_radius,
        fit_residual=written.fit_residual,
        verification=written.verification,
        text=written.text,
        advice=(
            *(_advice(work, settings) if foreseen is None else foreseen.advice()),
            *(f"{m.source}: {note}" for m in request.measurements for note in m.notes),
        ),
        warnings=tuple(warnings),
        noted=tuple(noted),
    )


def nominal_from_program(
    program: gcode.Program, radius: float, settings: Settings, measurement: Measurement | None
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
            f"{program.name}:{carried[-1].line}: --nominal names a corrected program; give the first, uncorrected one"
        )
    usable, path_radius = _usable(program, radius, settings)
    if measurement is not None:
        measurement = _taken_down(measurement, (*settings.allowances, 0.0)[0])
    return _own_contour(program, program.toolpath, settings, measurement, radius, path_radius, usable, [])[0]


def _require_a_cut(settings: Settings, radius: float) -> None:
    """UsageError where a depth along the normal is more than the cutter is wide."""
    for option, values in (("depth", settings.depths), ("next-depth", (settings.next_depth or 0.0,))):
        for value in values:
            if value > 2 * radius:
                raise UsageError(
                    f"--{option} {value:g}: a cutter of {2 * radius:g} mm takes no more than its width off; the depth "
                    "is meant along the contour's normal, from the stock to the surface, in mm"
                )


def _taken_down(measurement: Measurement, allowance: float) -> Measurement:
    """Points of a surface that lies an allowance over the nominal, in mm, compared with the nominal itself.

    To the profile they are what centres of a ball of that radius are: exact on any contour.
    """
    return replace(measurement, ball_radius=measurement.ball_radius + allowance) if allowance else measurement


def _refuse_wrong_allowance(surface: Measurement, nominal: Profile, allowance: float) -> None:
    """InputError where the points lie on the nominal itself and not an allowance over it."""
    if not allowance:
        return
    points = surface.points[:: max(1, len(surface) // distrust.SAMPLE), :2]
    over = FootPointSearch(nominal, margin=surface.ball_radius + 1.0).find(points).distance - surface.ball_radius
    if np.median(over) < -LEAST_UNDER:
        raise InputError(
            f"{surface.source}: the points lie {np.median(over) + allowance:+.3f} mm off the profile and not "
            f"{allowance:g} mm over it: check --allowance; it belongs to a part with stock left on it, and --program "
            "is then the program that finishes it"
        )


def _roughing(
    toolpath: Toolpath,
    cutters: Floats,
    rows: NDArray[np.bool_],
    nominal: Profile,
    program: gcode.Program,
    settings: Settings,
    carried: Correction | None = None,
) -> NDArray[np.bool_]:
    """Which of some moves of a program leave stock on the nominal for others; (n,)."""
    return roughing(CommandedSurface(toolpath, cutters), rows, nominal, program.resolution, settings.limit, carried)


def _for_first_cut(
    program: gcode.Program, request: Request, path_radius: float, usable: NDArray[np.bool_]
) -> tuple[Toolpath, NDArray[np.bool_]]:
    """Moves with corners for the fillets that a first cut has no room for, and which of the program's are kept."""
    settings, toolpath = request.settings, program.toolpath
    _require_side(settings, toolpath, usable)
    right = choose_side(toolpath, usable, settings.side, None, request.radius, path_radius)
    return without_vanishing_arcs(toolpath, usable, right, settings.leave_stock)


def _first_cut(request: Request, nominal: Profile, allowance: float) -> FirstCut | None:
    """What cut the touched part of a single piece, as `millcorr split` writes it."""
    if not allowance:
        return None
    settings = Settings(
        side=request.settings.side,
        cutter_compensation=request.settings.cutter_compensation,
        tolerance=request.settings.tolerance,
        leave_stock=allowance,
    )
    done = correct(Request(request.program, request.radius, None, request.nominal, settings))
    program = gcode.parse(done.text, f"first cut of {request.program.name}")
    return FirstCut(program, done.compensated, allowance)


def _require_side(settings: Settings, toolpath: Toolpath, usable: NDArray[np.bool_]) -> None:
    """UsageError where neither the settings nor the program say on which side the cutter runs."""
    if settings.side == "auto" and not (toolpath.compensation[usable] != Compensation.OFF).any():
        raise UsageError("--side left or --side right: the program has no G41 or G42 that tells the side of the cutter")


def _own_contour(
    program: gcode.Program,
    toolpath: Toolpath,
    settings: Settings,
    measurement: Measurement | None,
    radius: float,
    path_radius: float,
    usable: NDArray[np.bool_],
    warnings: list[str],
) -> tuple[Profile, list[CutContour]]:
    """The contour that the program cuts near the measured points, and what cuts it."""

    def doubt(everything: Profile) -> None:
        if measurement is not None and measurement.axis_radii is None and measurement.probe is None:
            found = distrust.examine_points(measurement, everything, radius)
            distrust.refuse_dangerous(found, settings.accept, measurement.source)

    try:
        right = choose_side(toolpath, usable, settings.side, measurement, radius, path_radius)
    except InputError:
        # Points in another frame lie on no side; a contour on the better one shows which frame it is.
        for side in (False, True):
            try:
                doubt(nominal_of(toolpath, usable, path_radius, side, None, program.name)[0])
            except DistrustError as error:
                if any(f"--accept {name})" in str(error) for name in ("unit", "mirrored", "turned")):
                    raise
            except InputError:
                continue
        raise
    nominal, words, cut = nominal_of(
        toolpath, usable, path_radius, right, measurement, program.name, doubt, resolution=program.resolution
    )
    warnings += words
    return nominal, cut


def _cutters(
    program: gcode.Program, request: Request, path_radius: float, measurement: Measurement | None, warnings: list[str]
) -> Floats:
    """Radius of the cutter of every move of the program, mm; NaN where it is not known, or cuts another part."""
    other = _other_parts(program, request, path_radius, measurement, warnings)
    if len(np.unique(program.toolpath.tool)) < 2:
        radii = cutter_radii(program.toolpath, request.radius, path_radius, {}, measurement)[0]
        return np.where(other, np.nan, radii)
    scale = 25.4 if (program.modal.unit == 20).any() else 1.0
    stated = stated_diameters(program.comments(), scale) | dict(request.settings.tool_diameters)
    radii, unknown = cutter_radii(program.toolpath, request.radius, path_radius, stated, measurement)
    if unknown:
        names = [program.tool(tool) for tool in unknown if tool != -1]
        listed = [f"T{name}" if name.isdigit() else name for name in names]
        listed += ["the tool before the first T word"] if -1 in unknown else []
        remedy = f"--tool {names[0]}=MM states it" if names else "a T word before its cuts gives it a number to state"
        what = f"the diameter of {', '.join(listed)} is not known"
        warnings.append(f"{what}: what it cuts stays as it is and is not looked at; {remedy}")
    return np.where(other, np.nan, radii)


def _other_parts(
    program: gcode.Program, request: Request, path_radius: float, measurement: Measurement | None, warnings: list[str]
) -> NDArray[np.bool_]:
    """Moves under another work offset than those that made the points, or in a frame that is turned or moved; (n,)."""
    toolpath = program.toolpath
    out = np.zeros(len(toolpath), dtype=bool)
    if not OTHER_FRAMES.search(program.data):
        return out
    out |= program.opaque_moves()
    moves = read_moves(program.data)
    if not len(moves) or measurement is None:
        return out
    offset = moves.offset[np.clip(np.searchsorted(moves.line, toolpath.source, side="right") - 1, 0, None)]
    cuts = (toolpath.kind != Kind.RAPID) & np.isfinite(toolpath.end[:, :2]).all(axis=1) & ~out
    _, first = np.unique(offset[cuts], return_index=True)
    frames = offset[cuts][np.sort(first)].tolist()
    if len(frames) < 2:
        return out
    away = abs(path_radius - measurement.ball_radius), abs(request.radius - measurement.ball_radius)
    mine = nearest_group(toolpath, cuts, offset, frames, away, measurement)
    warnings.append(
        f"what is cut under {_offset_name(frames[0] if frames[0] != mine else frames[1])} is another part than the "
        f"measured one, cut under {_offset_name(mine)}: it stays as it is"
    )
    other: NDArray[np.bool_] = out | (offset != mine)
    return other


def _offset_name(offset: int) -> str:
    """G54, G54.1 P2: a work offset as `PlainMoves.offset` numbers it."""
    code, number = divmod(offset, 1000)
    return f"G{code / 10:g}" + (f" P{number}" if number else "")


def _usable(program: gcode.Program, radius: float, settings: Settings) -> tuple[NDArray[np.bool_], float]:
    """Moves that may be corrected, and the distance from path to contour, mm."""
    usable = ~program.opaque_moves()
    feeds = program.toolpath.kind != Kind.RAPID
    if not feeds.any():
        raise InputError(f"{program.name}: the program has no feed move that could follow a contour")
    if not (feeds & usable).any():
        program.require_plain(feeds)
    if program.opaque and not any(usable[run].any() for run in cutting_runs(program.toolpath)):
        why = program.opaque[0]
        raise FormatError(
            f"nothing that runs along a contour is read: {why.reason}; write the moves in place of this line, as plain "
            "G0 to G3 moves",
            program.name,
            why.first + 1,
        )
    compensated = program.toolpath.compensation != Compensation.OFF
    if not compensated.any():
        return usable, radius
    return usable & compensated, 0.0 if settings.cutter_compensation == "contour" else radius


def _turned_to_the_path(
    nominal: Profile, toolpath: Toolpath, radius: float, usable: NDArray[np.bool_], limit: float, given: bool
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


def _believed(
    measurement: Measurement, nominal: Profile, request: Request, depth: float, allowance: float, warnings: list[str]
) -> tuple[Measurement, alignment.Alignment | None]:
    """The measurement, aligned if that is asked for, after looking whether it can be what it is said to be."""
    settings = request.settings
    require_heights(measurement, nominal)
    freedom = alignment.Freedom.parse(settings.align)
    known = contact_known(measurement, nominal)
    residue = axis_residue(measurement, known, nominal)
    findings = distrust.examine_points(known, nominal, request.radius, depth, allowance)
    if residue is not None:
        findings = (distrust.Finding(*residue), *findings)
    measurement = known
    warnings += distrust.refuse_dangerous(findings, settings.accept, measurement.source)
    if not any(freedom.free):
        return measurement, None
    measurement, aligned = alignment.align(measurement, nominal, freedom)
    warnings += aligned.warnings
    return measurement, aligned


def _header(request: Request, noted: Sequence[Ints]) -> tuple[str, ...]:
    program, left = request.program, request.settings.leave_stock
    if left:
        return (f"millcorr {__version__} first cut, leaves {left:g} mm", f"of {PurePath(program.name).name}")
    if request.shift is not None:
        # Marked like any correction: the path no longer shows the nominal.
        moved = f"contour moved against a bending tool by at most {request.shift.largest:.4f} mm"
        digest = hashlib.sha256(f"{program.digest} {moved}".encode()).hexdigest()
        return provenance.header([("nothing, predicted", digest)], (program.name, program.digest), moved)
    if request.measurement is None:
        return (f"millcorr {__version__} path laid on the exact nominal, no correction",)
    return provenance.header(
        [(m.source, m.fingerprint) for m in request.measurements],
        (program.name, program.digest),
        request.settings.in_words(),
        noted,
    )


def _advice(work: Target, settings: Settings) -> tuple[str, ...]:
    """What to expect of the next part."""
    if not len(work.deviation):
        return ()
    if work.elastic is not None:
        return work.elastic.advice(settings)
    if settings.gain == 1.0:
        return ()
    left = 100 * (1 - settings.gain)
    return (f"gain {settings.gain:g} leaves {left:.0f} % of the determined deviation on purpose",)
