# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one use case: a program and a measurement in, a corrected toolpath with its proof out."""

from __future__ import annotations

import logging
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import __version__, alignment, distrust, gcode, provenance
from .commanded import Commanded, beside_the_path, choose_side, commanded_offset, nominal_of
from .compensation import Correction, along, correction_from, dead_band
from .deviation import Deviation, deviations, statistics
from .errors import InputError, LimitError, UsageError
from .filtering import Filter, Separation, separate
from .measurement import Measurement
from .parts import averaged
from .profile import Profile
from .reconstruction import CompensatedContour
from .regeneration import OUTPUT_MOVES, Regeneration, regenerate
from .toolpath import Compensation, Kind, Toolpath
from .verification import Verification, verify

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

log = logging.getLogger(__name__)

LARGEST_TOLERANCE = 0.05
"""Path errors beyond this, in mm, are as large as the deviations worth correcting."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to correct. Lengths in mm; see the command line for the meaning of each."""

    side: str = "auto"
    align: str = "none"
    filter: str = "auto"
    method: str = "mirror"
    gain: float = 1.0
    limit: float = 0.5
    dead_band: float = 0.0
    tolerance: float = 0.001
    output_moves: str = "keep"
    cutter_compensation: str = "contour"
    accept: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        choices = {
            "side": ("auto", "left", "right"),
            "method": ("mirror",),
            "output_moves": OUTPUT_MOVES,
            "cutter_compensation": ("contour", "wear"),
        }
        for name, legal in choices.items():
            if getattr(self, name) not in legal:
                option = "--" + name.replace("_", "-")
                raise UsageError(f"{option} {getattr(self, name)}: choose one of {', '.join(legal)}")
        alignment.Freedom.parse(self.align)
        Filter.parse(self.filter)
        if not 0 < self.gain <= 2:
            raise UsageError(f"--gain {self.gain:g}: must be above 0 and at most 2")
        for name in ("limit", "tolerance"):
            if not getattr(self, name) > 0:
                raise UsageError(f"--{name} {getattr(self, name):g}: must be above 0")
        if self.tolerance > LARGEST_TOLERANCE:
            raise UsageError(
                f"--tolerance {self.tolerance:g}: more than {LARGEST_TOLERANCE:g} mm would hide what is to be corrected"
            )
        if not self.dead_band >= 0:
            raise UsageError(f"--dead-band {self.dead_band:g}: must not be negative")

    def in_words(self) -> str:
        """The settings that shape a correction, in one line."""
        return (
            f"method {self.method} filter {self.filter} gain {self.gain:g} dead band {self.dead_band:g} "
            f"limit {self.limit:g} tolerance {self.tolerance:g} moves {self.output_moves} align {self.align}"
            + (f" accepted {' '.join(self.accept)}" if self.accept else "")
        )


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
        Further parts cut with the same program; the first one's deviations become the mean of all.
    """

    program: gcode.Program
    radius: float
    measurement: Measurement | None
    nominal: Profile | None = None
    settings: Settings = field(default_factory=Settings)
    further: tuple[Measurement, ...] = ()

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
    predicted : (n,) float64
        What the same machine is expected to leave at each point after the correction, mm.
    commanded : (n,) float64
        Offset of the program's own contour from the nominal at each point, mm.
    separations : tuple of Separation
        One a smooth stretch and level with points.
    random_std : float
        Standard deviation of the random part, mm; NaN where it is not known.
    regeneration : Regeneration
    path_radius : float
        Distance in mm between path and contour: the cutter radius, or 0 where the program gives the contour.
    fit_residual : float
        Largest distance between the exact compensated contour and its NURBS, mm.
    verification : Verification
    text : bytes
        The corrected program; the very bytes of the original where nothing changed.
    advice : tuple of str
        What to expect of the next part.
    warnings : tuple of str
        What may be wrong or was not possible.
    """

    request: Request
    nominal: Profile
    compensated: Profile
    correction: Correction
    alignment: alignment.Alignment | None
    deviation: Deviation
    filtered: Floats
    predicted: Floats
    commanded: Floats
    separations: tuple[Separation, ...]
    random_std: float
    regeneration: Regeneration
    path_radius: float
    fit_residual: float
    verification: Verification
    text: bytes
    advice: tuple[str, ...]
    warnings: tuple[str, ...]

    def summary(self) -> dict[str, Any]:
        """The contents of report.json."""
        curves = [c.as_dict() for contour in self.compensated.contours for c in contour.curves]
        first = curves[0]
        keys = ("degree", "poles", "weights", "knots", "multiplicities", "periodic")
        d = self.deviation
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
            "correction": {"max": self.correction.largest, "limited": 0},
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
        return _header(self.request)


def correct(request: Request) -> Result:
    """Correct a toolpath from a measured part.

    Parameters
    ----------
    request : Request

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
    settings, program, measurement = request.settings, request.program, request.measurement
    toolpath = program.toolpath
    if not 0 < request.radius < np.inf:
        raise UsageError(f"the tool diameter {2 * request.radius:g} mm must be a length above 0")
    warnings: list[str] = []
    carried = provenance.marks(program.comments())
    digests = [m.fingerprint for m in request.measurements]
    if len(set(digests)) < len(digests):
        raise UsageError("the same measurement is given twice: averaging needs different parts")
    provenance.refuse_second_use(carried, digests, program.name, request.nominal is not None)

    usable, path_radius = _usable(program, request.radius, settings)
    nominal = request.nominal
    if nominal is None:
        nominal = _own_contour(program, settings, measurement, request.radius, path_radius, usable, warnings)
    nominal, commanded = _turned_to_the_path(nominal, toolpath, path_radius, usable, request.nominal is not None)
    program.require_plain(beside_the_path(toolpath, commanded.following))

    aligned: alignment.Alignment | None = None
    if measurement is None:
        correction, work = Correction.none(nominal), _Work.empty()
    else:
        parts = []
        lowest = _lowest_cut(toolpath, commanded)
        for part in request.measurements:
            moved, fit = _believed(part, nominal, request, warnings)
            aligned = aligned or fit
            deviation = deviations(moved, nominal, cutter_radius=request.radius)
            offset = commanded_offset(commanded, deviation)
            machine = deviation.value - offset
            findings = distrust.examine_deviations(deviation, machine, nominal, lowest if part.has_z else None)
            warnings += distrust.refuse_dangerous(findings, settings.accept, part.source)
            parts.append(_Part(deviation, offset, machine))
        work = _separated(parts, nominal, settings, bool(carried), warnings)
        correction = _correction(work, nominal, settings, warnings)
    contour = CompensatedContour(nominal, correction)
    _refuse_crossing(nominal, contour)
    compensated, residual = contour.to_profile()
    regeneration = regenerate(
        toolpath,
        contour,
        path_radius,
        tolerance=settings.tolerance,
        output_moves=settings.output_moves,
        rows=usable,
        nominal_from_path=request.nominal is None,
    )
    _refuse_detour(toolpath, regeneration)
    text = _written(request, regeneration)
    emitted = gcode.parse(text, program.name).toolpath
    if len(emitted) != len(regeneration.toolpath):
        raise LimitError(
            f"the written program reads back with {len(emitted)} moves in place of {len(regeneration.toolpath)}"
        )
    proof = verify(
        emitted, compensated, path_radius, following=regeneration.following, tolerance=settings.tolerance
    )
    applied = np.zeros(len(work.deviation))
    if len(work.deviation):
        applied = correction.at(work.deviation.stretch, work.deviation.s, nominal)
    rejected = len(work.deviation.rejected)
    if rejected:
        warnings.append(f"{rejected} {'point was' if rejected == 1 else 'points were'} rejected, see the report")
    return Result(
        request=request,
        nominal=nominal,
        compensated=compensated,
        correction=correction,
        alignment=aligned,
        deviation=work.deviation,
        filtered=work.filtered,
        predicted=work.deviation.value - work.commanded + applied,
        commanded=work.commanded,
        separations=work.separations,
        random_std=work.random_std,
        regeneration=regeneration,
        path_radius=path_radius,
        fit_residual=residual,
        verification=proof,
        text=text,
        advice=_advice(work, len(carried) + 1, settings),
        warnings=tuple(warnings),
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
    return _own_contour(program, settings, measurement, radius, path_radius, usable, [])


def _own_contour(
    program: gcode.Program,
    settings: Settings,
    measurement: Measurement | None,
    radius: float,
    path_radius: float,
    usable: NDArray[np.bool_],
    warnings: list[str],
) -> Profile:
    """The contour that the program cuts near the measured points."""
    right = choose_side(program.toolpath, usable, settings.side, measurement, radius, path_radius)
    nominal, others = nominal_of(program.toolpath, usable, path_radius, right, measurement, program.name)
    if others:
        contours = "another contour" if others == 1 else f"{others} other contours"
        warnings.append(f"the program cuts {contours} without measured points: left as it is")
    return nominal


def _usable(program: gcode.Program, radius: float, settings: Settings) -> tuple[NDArray[np.bool_], float]:
    """Moves that may be corrected, and the distance from path to contour, mm."""
    usable = ~program.opaque_moves()
    feeds = program.toolpath.kind != Kind.RAPID
    if not feeds.any():
        raise InputError(f"{program.name}: the program has no feed move that could follow a contour")
    if not (feeds & usable).any():
        program.require_plain(feeds)
    compensated = program.toolpath.compensation != Compensation.OFF
    if not compensated.any():
        return usable, radius
    return usable & compensated, 0.0 if settings.cutter_compensation == "contour" else radius


def _turned_to_the_path(
    nominal: Profile, toolpath: Toolpath, radius: float, usable: NDArray[np.bool_], given: bool
) -> tuple[Profile, Commanded]:
    """Nominal with its material on the side that the path leaves, and the path's following moves."""
    try:
        plain = CompensatedContour(nominal, Correction.none(nominal))
        return nominal, Commanded.find(toolpath, plain, radius, usable)
    except LimitError:
        if not given:
            raise
        other = nominal.reversed()
        plain = CompensatedContour(other, Correction.none(other))
        try:
            return other, Commanded.find(toolpath, plain, radius, usable)
        except LimitError:
            pass
        raise


@dataclass(frozen=True, eq=False, slots=True)
class _Work:
    """Deviations with what became of them; arrays over the used points."""

    deviation: Deviation
    commanded: Floats
    filtered: Floats
    wanted: Floats
    separations: tuple[Separation, ...]
    random_std: float

    @staticmethod
    def empty() -> _Work:
        none, zero = np.zeros(0, dtype=np.int64), np.zeros(0)
        flat = np.zeros((0, 2))
        deviation = Deviation(none, none, none, none, zero, zero, flat, flat, zero, ())
        return _Work(deviation, zero, zero, zero, (), float("nan"))


def _believed(
    measurement: Measurement, nominal: Profile, request: Request, warnings: list[str]
) -> tuple[Measurement, alignment.Alignment | None]:
    """The measurement, aligned if that is asked for, after looking whether it can be what it is said to be."""
    settings = request.settings
    freedom = alignment.Freedom.parse(settings.align)
    findings = distrust.examine_points(measurement, nominal, request.radius)
    warnings += distrust.refuse_dangerous(findings, settings.accept, measurement.source)
    if not any(freedom.free):
        return measurement, None
    measurement, aligned = alignment.align(measurement, nominal, freedom)
    warnings += aligned.warnings
    return measurement, aligned


def _lowest_cut(toolpath: Toolpath, commanded: Commanded) -> float | None:
    """Lowest known height of the following moves, mm."""
    heights = np.concatenate([toolpath.start[commanded.following, 2], toolpath.end[commanded.following, 2]])
    known = heights[np.isfinite(heights)]
    return float(known.min()) if len(known) else None


@dataclass(frozen=True, eq=False, slots=True)
class _Part:
    """One measured part: its deviations, the program's own offset, and what the machine added, mm."""

    deviation: Deviation
    offset: Floats
    machine: Floats


def _separated(
    parts: list[_Part], nominal: Profile, settings: Settings, corrected_before: bool, warnings: list[str]
) -> _Work:
    """Average the parts, filter what the machine added, and say where to move the profile."""
    deviation, offset, machine = parts[0].deviation, parts[0].offset, parts[0].machine
    part_std = float("nan")
    if len(parts) > 1:
        several = averaged([(p.deviation, p.machine) for p in parts], nominal)
        machine, part_std = several.mean, several.std
        deviation = replace(deviation, value=offset + machine)
        warnings.append(
            f"deviations are the mean of {len(parts)} parts; from part to part they differ by "
            f"{part_std * 1000:.2f} um (standard deviation)"
        )
    filter_ = Filter.parse(settings.filter)
    determined = np.empty(len(deviation))
    separations: list[Separation] = []
    variance, freedom = 0.0, 0
    for k, stretch in enumerate(nominal.stretches()):
        for level in np.unique(deviation.level[deviation.stretch == k]):
            rows = np.flatnonzero((deviation.stretch == k) & (deviation.level == level))
            s = along(stretch, deviation.s[rows], nominal)
            part = separate(s, machine[rows], length=stretch.length, closed=stretch.closed, filter=filter_)
            determined[rows] = part.determined
            separations.append(part)
            warnings += [w for w in part.warnings if w not in warnings]
            if np.isfinite(part.random_std):
                variance += part.random_std**2 * len(rows)
                freedom += len(rows)
    residual = offset + determined if corrected_before else determined
    moved = -settings.gain * dead_band(residual, settings.dead_band)
    wanted = offset + moved if corrected_before else moved
    random_std = float(np.sqrt(variance / freedom)) if freedom else float("nan")
    if np.isfinite(part_std):
        random_std = part_std
    return _Work(deviation, offset, offset + determined, wanted, tuple(separations), random_std)


def _correction(work: _Work, nominal: Profile, settings: Settings, warnings: list[str]) -> Correction:
    deviation = work.deviation
    levels = np.unique(deviation.level)
    if len(levels) == 1:
        correction, notes = correction_from(
            nominal, deviation.stretch, deviation.s, work.wanted, limit=settings.limit
        )
        warnings += notes
        return correction
    # Each level by itself, then their mean along the contour: points of different heights are never mixed.
    single = []
    for level in levels:
        rows = deviation.level == level
        one, notes = correction_from(
            nominal, deviation.stretch[rows], deviation.s[rows], work.wanted[rows], limit=settings.limit
        )
        single.append((one, int(rows.sum())))
        warnings += [n for n in notes if n not in warnings]
    densest = max(single, key=lambda pair: pair[1])[0]
    rows = deviation.level == levels[[pair[0] is densest for pair in single].index(True)]
    values = np.stack([one.at(deviation.stretch[rows], deviation.s[rows], nominal) for one, _ in single])
    spread = float(np.ptp(values, axis=0).max())
    heights = [float(deviation.z[deviation.level == level].mean()) for level in levels]
    listed = ", ".join(f"{z:g}" for z in heights)
    warnings.append(
        f"{len(levels)} levels were measured (Z {listed}); the correction is their mean, they differ by up to "
        f"{spread * 1000:.1f} um"
    )
    mean, notes = correction_from(
        nominal, deviation.stretch[rows], deviation.s[rows], values.mean(axis=0), limit=settings.limit
    )
    warnings += [n for n in notes if n not in warnings]
    return mean


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


def _written(request: Request, regeneration: Regeneration) -> bytes:
    """The corrected program; decimals as the program has them where the tolerance allows."""
    program, tolerance = request.program, request.settings.tolerance
    plain = gcode.write(program, regeneration.toolpath, tolerance=tolerance)
    if plain == program.data:
        return plain
    room = tolerance - regeneration.fit_error
    # Rounding moves a point by at most half a unit in each of two directions.
    own = program.style.decimals
    unit = 25.4 if (program.modal.unit == 20).any() else 1.0
    decimals = own if np.sqrt(0.5) * unit * 10.0**-own <= 0.9 * room else None
    return gcode.write(
        program, regeneration.toolpath, decimals=decimals, tolerance=tolerance, header=_header(request)
    )


def _header(request: Request) -> tuple[str, ...]:
    program = request.program
    if request.measurement is None:
        return (f"millcorr {__version__} path laid on the exact nominal, no correction",)
    return provenance.header(
        [(m.source, m.fingerprint) for m in request.measurements],
        (program.name, program.digest),
        request.settings.in_words(),
    )


def _advice(work: _Work, loops: int, settings: Settings) -> tuple[str, ...]:
    """What to expect of the next part."""
    if not len(work.deviation):
        return ()
    if settings.gain != 1.0:
        left = 100 * (1 - settings.gain)
        return (f"gain {settings.gain:g} leaves {left:.0f} % of the determined deviation on purpose",)
    ordinal = {1: "", 2: "twice ", 3: "three times "}.get(loops, f"{loops} times ")
    return (
        f"tool and machine give way: a share MS/(1+MS) of every shift comes back, {ordinal}taken of the first "
        f"deviation by now (a stiff machine, MS 0.05: {100 * (0.05 / 1.05) ** loops:.2g} % is left); measure the next "
        "part",
    )

