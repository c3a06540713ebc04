# SPDX-License-Identifier: LGPL-2.1-or-later
"""From measured parts to where the profile is to be moved: averaged, separated, aimed, laid along the contour."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import Deviation, statistics
from millcorr.comparison.wall_steps import in_order
from millcorr.errors import UsageError
from millcorr.geometry.correction import Correction, Course, along
from millcorr.geometry.profile import Profile, Stretch
from millcorr.messages import option, phrase, remedy, um
from millcorr.separation import Filter, Observed, Separated, filtered, interpolated
from millcorr.separation.parts import averaged, same_levels
from millcorr.separation.steps import Systematic, steps_of
from millcorr.tolerances import ALIKE

from .compensation import beyond_the_limit, dead_band, refuse_swing
from .settings import Settings
from .transfer_function import TransferFunction, along_axis, examine, from_line, identify, line_over_depth, one_value

SUPPORTS = 24.0
"""Supports of a correction in a length of the form: its nodes are a sixth apart, with a quintic between them."""

FOLLOWED = 5e-5
"""Standard deviation in mm of a spline through the supports from the form between them, at most."""

SPLINE_LEFT = 0.465
"""Of a form of size v and length l a cubic spline through places h apart leaves 0.465 v (h / l)^2.5 halfway.

For h well below l: the spectrum 16/3 v^2 (sqrt(5) / l)^5 / w^6 of a Matern 5/2 form, times what the cardinal spline
makes of a wave of w other than the wave itself, 7.24e-4 in units of h^5."""

LEVEL = 1.0
"""Length in mm of the last piece of an open course, on which it runs out level."""

MOST_SUPPORTS = 20_000

CARRIED = 1.0
"""What a program carries is read every so many mm: a form is never shorter than two."""

CARRIED_IN_SERIES = 0.5
"""In a series, where part of what a program carries stays in it on purpose, so that waves of 3 mm do."""


@dataclass(frozen=True, eq=False, slots=True)
class Part:
    """One measured part: its deviations, the program's own offset, and what the machine added, mm.

    Parameters
    ----------
    deviation : Deviation
        Against the surface that the part's program should make: the nominal, or an allowance over it.
    offset, machine : (n,) float64
        Program's own offset from that surface, and what the machine added.
    allowance : float
        Stock that the program left over the nominal.
    """

    deviation: Deviation
    offset: Floats
    machine: Floats
    allowance: float = 0.0


@dataclass(frozen=True, eq=False, slots=True)
class Elastic:
    """What a transfer function expects of the next part.

    Parameters
    ----------
    transfer : TransferFunction
        The one that corrects: as the settings want it taken.
    system : TransferFunction
        Along the normal and along the contour: what the machine is expected to do.
    next_depth : (n,) float64
        Stock over the nominal that the next program finds, mm.
    depth : tuple of float
        Depths that the parts were cut at, mm.
    taken : str
        How it was taken: as in ``Settings.transfer_function``, or ``by axis`` from touches.
    """

    transfer: TransferFunction
    system: TransferFunction
    next_depth: Floats
    depth: tuple[float, ...]
    taken: str

    def summary(self, settings: Settings) -> dict[str, Any]:
        """What report.json says of it; lengths in mm, uncertainties are standard ones, None where not known."""
        ms = self.transfer
        over = statistics(ms.ms)
        return {
            **{f"ms_{name}": over[name] for name in ("mean", "min", "max", "std")},
            "ms_uncertainty": _typical(ms.ms_std),
            "depth": list(self.depth),
            "next_depth": float(np.median(self.next_depth)),
            "next_depth_range": [float(self.next_depth.min()), float(self.next_depth.max())],
            "depth_along": settings.depth_along,
            "taken": self.taken,
            "offset": statistics(ms.offset) | {"uncertainty": _typical(ms.offset_std)} if ms.offset_known else None,
            "correction_uncertainty": _typical(ms.correction_std(self.next_depth)),
        }

    def advice(self, settings: Settings) -> tuple[str, ...]:
        """What to expect of the next part."""
        out = []
        if settings.gain != 1.0:
            left = 100 * (1 - settings.gain)
            out.append(
                phrase("gain {:g} leaves {:.0f} % of what the next part would show on purpose", settings.gain, left)
            )
        if not self.transfer.offset_known:
            out.append(
                phrase(
                    "one depth cannot tell a constant offset (tool radius, backlash, edge force) from elastic "
                    "response: all of it is taken as elastic, which is right at the depth measured; for another "
                    "depth measure two"
                )
            )
        if settings.depth_along != "normal":
            more = self.system.correction(self.next_depth) - self.transfer.correction(self.next_depth)
            out.append(
                phrase(
                    "deviations along {} with depths along the normal correct by {} more on average than {}",
                    settings.depth_along.upper(),
                    um(more.mean()),
                    remedy("depth_along", "normal"),
                )
            )
        return tuple(out)


@dataclass(frozen=True, eq=False, slots=True)
class WantedDisplacement:
    """Deviations with what became of them; arrays over the used points.

    Parameters
    ----------
    deviation : Deviation
    commanded : (n,) float64
        Program's own offset, mm.
    filtered, uncertainty : (n,) float64
        Systematic part and its standard uncertainty, mm; NaN where that is not known.
    wanted : (n,) float64
        Wanted displacement of the profile, mm.
    random_std : float
        Of what does not repeat, mm; NaN where it is not known.
    systematic : Systematic or None
        What repeats, anywhere on the contours; None without a measurement, or where a model carries touches on.
    outlier : (n,) bool
        Points that are more probably wrong than right.
    elastic : Elastic or None
    added : bool
        Whether the wanted displacement is added to what the program carries already.
    smoothed : Correction or None
        What a series takes out in place of the part's own; see `smoothed_over_parts`.
    notes : tuple of str
        What is to be said of how it was found.
    """

    deviation: Deviation
    commanded: Floats
    filtered: Floats
    uncertainty: Floats
    wanted: Floats
    random_std: float
    systematic: Systematic | None = None
    outlier: Bools | None = None
    elastic: Elastic | None = None
    added: bool = False
    smoothed: Correction | None = None
    notes: tuple[str, ...] = ()

    @property
    def separated(self) -> Separated | None:
        """What repeats where the form is kept; None without a measurement."""
        return None if self.systematic is None else self.systematic.separated

    @staticmethod
    def empty() -> WantedDisplacement:
        """Displacement without a point: nothing was measured."""
        none, zero = np.zeros(0, dtype=np.int64), np.zeros(0)
        flat = np.zeros((0, 2))
        deviation = Deviation(none, none, none, none, zero, zero, flat, flat, zero, ())
        return WantedDisplacement(deviation, zero, zero, zero, zero, float("nan"))

    @property
    def yields(self) -> Floats:
        """How much farther the path moves than what is left changes, 1 + MS; (n,)."""
        return np.ones(len(self.deviation)) if self.elastic is None else 1.0 + self.elastic.transfer.ms

    def predicted(self, applied: Floats) -> Floats:
        """What the same machine is expected to leave after a correction of `applied` mm, with the random part; (n,)."""
        if self.elastic is None:
            return self.deviation.value - self.commanded + applied
        expected = self.elastic.system.left(self.elastic.next_depth, applied)
        return expected + self.deviation.value - self.filtered


@dataclass(frozen=True, eq=False, slots=True)
class _Found:
    """What the machine added at the points of the first part, separated; mm."""

    machine: Floats
    determined: Floats
    uncertainty: Floats
    systematic: Systematic | None
    weight: Floats
    random_std: float
    aim: TransferFunction | None = None
    system: TransferFunction | None = None
    notes: tuple[str, ...] = ()


def wanted_displacement(
    parts: list[Part], nominal: Profile, settings: Settings, corrected_before: bool
) -> WantedDisplacement:
    """Average the parts, filter what the machine added, and say where to move the profile.

    Parameters
    ----------
    parts : list of Part
        All measured against the same nominal; the points of the first are used.
    nominal : Profile
    settings : Settings
    corrected_before : bool
        Whether the program carries a correction, to which another is added, in place of errors of its own, which
        go.

    Returns
    -------
    WantedDisplacement

    Raises
    ------
    UsageError, InputError, RefusedError
        If depths are missing, do not fit the parts, or make no transfer function.
    """
    depths = settings.each("depth", len(parts))
    if len(set(depths)) > 1:
        found = _at_several_depths(parts, depths, nominal, settings)
    else:
        found = _at_one_depth(parts, depths[0], nominal, settings)
    return _target(found, parts, depths, settings, corrected_before)


def displacement_without_noise(
    part: Part, nominal: Profile, settings: Settings, corrected_before: bool
) -> WantedDisplacement:
    """Displacement of a surface that a model says: all of it repeats, but for what a chosen filter takes away.

    Parameters
    ----------
    part : Part
    nominal : Profile
    settings : Settings
        With one depth at most.
    corrected_before : bool

    Returns
    -------
    WantedDisplacement
        Without uncertainty: a model gives none.

    Raises
    ------
    InputError, RefusedError
        If the depth makes no transfer function.
    """
    depths = settings.each("depth", 1)
    d, determined = part.deviation, part.machine
    filter = Filter.parse(settings.filter)
    if filter.kind not in ("auto", "none"):
        determined = part.machine.copy()
        stretches = nominal.stretches()
        for k, level in np.unique(np.column_stack([d.stretch, d.level]), axis=0):
            rows = (d.stretch == k) & (d.level == level)
            t = stretches[k]
            s = local(nominal, d.stretch[rows], d.s[rows])
            made = filtered(s, part.machine[rows], length=t.length, closed=t.closed, filter=filter)
            determined[rows] = made.determined
    unknown, trust = np.full(len(d), math.nan), np.ones(len(d))
    found = _Found(part.machine, determined, unknown, None, trust, math.nan)
    if settings.method == "transfer":
        found = _with_transfer(found, part, depths[0], math.nan, settings)
    return _target(found, [part], depths, settings, corrected_before)


def smoothed_over_parts(
    work: WantedDisplacement, smoothed: Correction, nominal: Profile, settings: Settings
) -> WantedDisplacement:
    """The target with what a series has smoothed over its parts in place of what this part shows.

    Parameters
    ----------
    work : WantedDisplacement
    smoothed : Correction
        What is to come out of the part, mm over arc length: of a program that carries a correction the deviation from
        the nominal, of another one what the machine adds.
    nominal : Profile
    settings : Settings
    """
    base = work.commanded if work.added else np.zeros(len(work.deviation))
    left = smoothed.at(work.deviation.stretch, work.deviation.s, nominal)
    wanted = base - settings.gain * work.yields * dead_band(left, settings.dead_band)
    return replace(work, wanted=wanted, smoothed=smoothed)


def _target(
    found: _Found,
    parts: list[Part],
    depths: tuple[float, ...],
    settings: Settings,
    corrected_before: bool,
) -> WantedDisplacement:
    """Where to move the profile by what was found."""
    first = parts[0]
    deviation, offset = first.deviation, first.offset
    if found.machine is not first.machine:
        deviation = replace(deviation, value=offset + found.machine)
    whole = offset + found.determined
    elastic: Elastic | None = None
    aim, yields, notes = -found.determined, np.ones(len(offset)), found.notes
    if found.aim is not None and found.system is not None:
        notes += tuple(examine(found.aim, deviation.foot))
        stock = np.broadcast_to(_next_depth(parts, depths, settings, whole), whole.shape)
        elastic = Elastic(found.aim, found.system, stock, settings.depths, settings.transfer_function)
        aim, yields = found.aim.correction(stock), 1.0 + found.aim.ms
    # A path put e over the nominal leaves (e - aim) / (1 + MS): 0 at the aim. Without a transfer function MS is 0.
    base = offset if corrected_before else np.zeros(len(offset))
    left = dead_band((base - aim) / yields, settings.dead_band)
    wanted = base - settings.gain * yields * left
    return WantedDisplacement(
        deviation,
        offset,
        whole,
        found.uncertainty,
        wanted,
        found.random_std,
        found.systematic,
        found.weight < 0.5,
        elastic,
        corrected_before,
        notes=notes,
    )


def _next_depth(parts: list[Part], depths: tuple[float, ...], settings: Settings, filtered: Floats) -> float | Floats:
    """Stock over the nominal that the next program finds, mm: one number, or what the measured part still has."""
    if settings.next_depth is not None:
        return settings.next_depth
    allowances = {part.allowance for part in parts}
    if len(set(depths)) > 1 or len(allowances) > 1:
        raise UsageError(
            phrase(
                "the parts were cut at different depths: say with {} what the next one takes off",
                option("next_depth", of="MM"),
            ),
        )
    allowance = allowances.pop()
    # The second half of an allowance is cut from the real surface, not from where the first half was to end.
    return allowance + filtered if allowance > 0 else depths[0]


def _at_one_depth(parts: list[Part], depth: float, nominal: Profile, settings: Settings) -> _Found:
    """Parts of one depth: their mean, separated; the transfer function where the settings want one."""
    first = parts[0]
    deviation, machine = first.deviation, first.machine
    # A number rounded to a step scatters by the root of a twelfth of it, and two by as much in any direction.
    rounding = math.sqrt(sum(p.deviation.step**2 for p in parts) / (12.0 * len(parts)))
    systematic = _separated([(p.deviation, p.machine) for p in parts], nominal, settings, rounding)
    separated = systematic.separated
    part_std = math.nan
    if len(parts) > 1:
        several = averaged([(p.deviation, p.machine) for p in parts], nominal)
        machine, part_std = several.mean, several.std
    n = len(deviation)
    determined, uncertainty = (every[:n] for every in systematic.at_points)
    weight = separated.weight[:n]
    random_std = part_std if math.isfinite(part_std) else separated.random_std
    found = _Found(machine, determined, uncertainty, systematic, weight, random_std)
    if settings.method != "transfer":
        return found
    # A point of the mean of parts is as uncertain as their spread lets it be.
    single = part_std / math.sqrt(len(parts)) if math.isfinite(part_std) else separated.random_std
    return _with_transfer(found, first, depth, single, settings)


def _with_transfer(found: _Found, part: Part, depth: float, single: float, settings: Settings) -> _Found:
    """What was found at one depth with the transfer function that the settings want; `single` of one point, mm."""
    h, place = depth - part.offset, part.deviation.foot
    system = identify(found.determined, h, found.uncertainty, place)
    factor = along_axis(part.deviation.normal, place, settings.depth_along)
    if settings.transfer_function == "points":
        aim = identify(factor * found.machine, h, factor * single, place)
    else:
        aim = identify(factor * found.determined, h, factor * found.uncertainty, place)
    if settings.transfer_function == "one":
        ms, std = one_value(aim.ms, found.weight, (1.0 + aim.ms) ** 2 * factor * single / h)
        aim = TransferFunction.constant(ms, std, len(aim))
    return replace(found, aim=aim, system=system)


def _at_several_depths(parts: list[Part], depths: tuple[float, ...], nominal: Profile, settings: Settings) -> _Found:
    """Parts of different depths: transfer function from the slope over the depth, offset from what the slope leaves."""
    first = parts[0]
    deviation, place = first.deviation, first.deviation.foot
    values = averaged([(p.deviation, p.machine) for p in parts], nominal).values
    # Each part was cut by the program of its time: where one says nothing, its value is left out anyway.
    offsets = np.nan_to_num(averaged([(p.deviation, p.offset) for p in parts], nominal).values)
    h: Floats = np.asarray(depths)[:, None] - offsets
    line = line_over_depth(values, h)
    slope = _separated([(deviation, line.slope)], nominal, settings)
    b, b_std, b_weight = _at_points(slope, line.slope, deviation, nominal)
    middle = h.mean(axis=0)
    # All values brought to the mean depth by the slope, so that a part without a point here makes no step.
    level = np.nanmean(values - b * (h - middle), axis=0)
    levels = _separated([(deviation, level)], nominal, settings)
    at_middle, level_std, weight = _at_points(levels, level, deviation, nominal)
    single = slope.separated.random_std
    if math.isfinite(line.std):
        single = line.std / math.sqrt(float(np.median(line.spread[line.spread > 0])))

    def reading(b: Floats, std: Floats, level: Floats, level_std: Floats, factor: Floats) -> TransferFunction:
        return from_line(
            level - b * middle, factor * b, slope_std=factor * std, level_std=level_std, depth=middle, place=place
        )

    ones = np.ones(len(b))
    system = reading(b, b_std, at_middle, level_std, ones)
    factor = along_axis(deviation.normal, place, settings.depth_along)
    if settings.transfer_function == "points":
        b_at = np.where(np.isfinite(line.slope), line.slope, b)
        aim = reading(b_at, single * ones, level, levels.separated.random_std * ones, factor)
    elif settings.transfer_function == "one":
        mean, std = one_value(b, b_weight, single * ones)
        aim = reading(mean * ones, std * ones, at_middle, level_std, factor)
    else:
        aim = reading(b, b_std, at_middle, level_std, factor)
    listed = ", ".join(f"{d:g}" for d in sorted(set(depths)))
    note = phrase(
        "{} parts cut {} mm deep: the transfer function is taken from the difference, the constant offset apart; "
        "deviations are shown as at the depth of the first",
        len(parts),
        listed,
    )
    first_depth = b * (h[0] - middle)
    random_std = line.std if math.isfinite(line.std) else levels.separated.random_std * math.sqrt(len(parts))
    uncertainty = np.hypot(level_std, b_std * (h[0] - middle))
    determined = at_middle + first_depth
    return _Found(level + first_depth, determined, uncertainty, levels, weight, random_std, aim, system, (note,))


def local(nominal: Profile, stretch: Ints, s: Floats) -> Floats:
    """Arc lengths from the start of each point's stretch, mm, for those from its contour's; (n,)."""
    progress.step()
    found, out = nominal.stretches(), np.empty(len(s))
    for k in np.unique(stretch):
        rows = stretch == k
        out[rows] = np.clip(along(found[k], s[rows], nominal), 0.0, found[k].length)
    return out


def _separated(
    parts: Sequence[tuple[Deviation, Floats]], nominal: Profile, settings: Settings, rounding: float = 0.0
) -> Systematic:
    """What repeats of values at the points of all parts, in their order, but for those without a value."""
    own = [np.unique(d.level, return_index=True, return_inverse=True) for d, _ in parts]
    levels = same_levels(
        [
            (steps_of(nominal)[d.contour[first]], np.bincount(of, d.z) / np.bincount(of))
            for (d, _), (_, first, of) in zip(parts, own, strict=True)
        ]
    )
    columns: list[tuple[NDArray[Any], ...]] = []
    for number, ((d, values), (_, _, of), level) in enumerate(zip(parts, own, levels, strict=True)):
        s, known = local(nominal, d.stretch, d.s), np.isfinite(values)
        row = (d.stretch, s, values, np.full(len(d), number), level[of], d.z)
        columns.append(tuple(column[known] for column in row))
    stretch, s, value, part, level, z = (np.concatenate(column) for column in zip(*columns, strict=True))
    measured = Observed(stretch, s, value, part, level, z, rounding)
    return Systematic.of(measured, nominal, Filter.parse(settings.filter))


def _at_points(
    systematic: Systematic, values: Floats, deviation: Deviation, nominal: Profile
) -> tuple[Floats, Floats, Floats]:
    """Systematic part, its standard uncertainty and the trust at all points, also at those without a value."""
    mean, std = systematic.at(deviation.stretch, local(nominal, deviation.stretch, deviation.s))
    known, weight = np.isfinite(values), np.zeros(len(values))
    mean[known], std[known] = systematic.at_points
    weight[known] = systematic.separated.weight
    return mean, std, weight


def _typical(std: Floats) -> float:
    """Root mean square of standard uncertainties; NaN where one is not known."""
    return float(np.sqrt(np.mean(std**2)))


def correction_through(
    work: WantedDisplacement, nominal: Profile, settings: Settings, rest: Correction | None = None
) -> tuple[Correction, tuple[str, ...]]:
    """Correction along the whole contour, also between the points and where there are none.

    Parameters
    ----------
    work : WantedDisplacement
    nominal : Profile
    settings : Settings
    rest : Correction, optional
        What the program carries already: contours without a point keep it. By default nothing.

    Returns
    -------
    Correction
    tuple of str
        What is to be said of it.

    Raises
    ------
    LimitError
        If the correction exceeds the limit anywhere; names the place.
    """
    systematic = work.systematic
    assert systematic is not None
    separated = systematic.separated
    stretches = tuple(nominal.stretches())
    d = work.deviation
    s = local(nominal, d.stretch, d.s)
    worst = int(np.argmax(np.abs(work.wanted)))
    if abs(work.wanted[worst]) > settings.limit:
        x, y = d.foot[worst].tolist()
        raise beyond_the_limit(work.wanted, worst, (x, y), settings.limit)
    sound = np.ones(len(d), dtype=bool) if work.outlier is None else ~work.outlier
    left_over = float(d.value[sound].mean()) if sound.any() else 0.0
    measured = {stretches[k].contour for k in np.unique(separated.observed.stretch)}
    # A step between two that were measured is a part of their wall.
    measured |= {k for wall in nominal.steps for k in wall if systematic.known[k]}
    courses = []
    left = 0
    for k, stretch in enumerate(stretches):
        there = None if rest is None else rest.courses[k]
        if stretch.contour not in measured:
            left += 1
            courses.append(there or Course.constant(0.0, stretch.length, stretch.closed))
            continue
        rows = d.stretch == k
        base = _carried(there, stretch) if work.added and there is not None else None
        if work.smoothed is not None:
            courses.append(_smoothed_course(work, k, s[rows], rows, there if work.added else None, settings))
            refuse_swing(nominal, stretch, courses[-1], settings.limit)
            continue
        places = _supports(stretch, _step(separated, s[rows], settings))

        def mirrored(at: Floats, k: int = k, base: Course | None = base) -> Floats:
            own = np.zeros(len(at)) if base is None else base(at)[0]
            of = np.full(len(at), k)
            mean, _ = systematic.at(of, at)
            out = own - settings.gain * dead_band(own + mean, settings.dead_band)
            if base is None:
                return out
            # Far from any point what the program carries stays, but for the mean of what is left.
            as_it_is = own - settings.gain * left_over
            return out + (as_it_is - out) * staying_share(systematic.unknown(of, at))

        value = mirrored(places)
        if rows.any():
            # What is wanted otherwise at the points; a transfer function is no matter of what is mirrored.
            if work.elastic is not None:
                value, plain = np.zeros(len(places)), np.zeros(int(rows.sum()))
            elif work.added:
                # From the same offsets as what is wanted: nobody wishes for facets and digits of the moves.
                plain = work.commanded[rows] - settings.gain * dead_band(work.filtered[rows], settings.dead_band)
            else:
                plain = mirrored(s[rows])
            more = work.wanted[rows] - plain
            if np.abs(more).max() > ALIKE:
                value = value + interpolated(s[rows], more, stretch.length, stretch.closed, places)
        course = Course.through(places, value, stretch.length, stretch.closed)
        refuse_swing(nominal, stretch, course, settings.limit)
        courses.append(course)
    said = phrase("{} stretches of contours without a measured point are left as they are", left)
    return in_order(Correction(stretches, tuple(courses)), nominal), (said,) if left else ()


def staying_share(unknown: Floats) -> Floats:
    """How much of what a program carries stays at places, by how much of the form's variance is open there.

    0 where less than half of it is, 1 where all is; (n,).
    """
    x = np.clip(2.0 * unknown - 1.0, 0.0, 1.0)
    out: Floats = x * x * (3.0 - 2.0 * x)
    return out


def _carried(course: Course, stretch: Stretch) -> Course:
    """What a program carries without the facets and digits of its moves, which are no correction."""
    count = max(math.ceil(stretch.length / CARRIED), 4)
    s = np.linspace(0.0, stretch.length, count, endpoint=not stretch.closed)
    return Course.through(s, course(s)[0], stretch.length, stretch.closed)


def carried_along(read: Correction, work: WantedDisplacement, nominal: Profile) -> Correction:
    """What a program carries, as exact as the points are dense: read off its path, and put right at the points.

    Parameters
    ----------
    read : Correction
        Read off the program's path, a mean over every 2 mm.
    work : WantedDisplacement
        With the program's own offset at the points.
    nominal : Profile
    """
    d = work.deviation
    s = local(nominal, d.stretch, d.s)
    courses = []
    for k, (course, stretch) in enumerate(zip(read.courses, read.stretches, strict=True)):
        rows = d.stretch == k
        if not rows.any():
            courses.append(course)
            continue
        at = _supports(stretch, CARRIED_IN_SERIES)
        off = interpolated(s[rows], work.commanded[rows] - course(s[rows])[0], stretch.length, stretch.closed, at)
        courses.append(Course.through(at, course(at)[0] + off, stretch.length, stretch.closed))
    return Correction(read.stretches, tuple(courses))


def _smoothed_course(
    work: WantedDisplacement, k: int, s: Floats, rows: Bools, base: Course | None, settings: Settings
) -> Course:
    """Correction along a stretch by what a series has smoothed, which is known all along it."""
    progress.step()
    assert work.smoothed is not None
    stretch, smoothed = work.smoothed.stretches[k], work.smoothed.courses[k]
    step = float(np.diff(smoothed.breaks).min())
    if base is not None:
        step = min(step, CARRIED_IN_SERIES)
    places = _supports(stretch, step / (4.0 if settings.dead_band > 0 else 1.0))
    own = np.zeros(len(places)) if base is None else base(places)[0]
    # Without a point on a stretch the machine yields there as it does elsewhere.
    yields = np.full(len(places), work.yields.mean())
    if rows.any():
        yields = interpolated(s, work.yields[rows], stretch.length, stretch.closed, places)
    value = own - settings.gain * yields * dead_band(smoothed(places)[0], settings.dead_band)
    return Course.through(places, value, stretch.length, stretch.closed)


def _step(separated: Separated, s: Floats, settings: Settings) -> float:
    """Distance in mm of places that a cubic spline through follows the correction to `FOLLOWED`."""
    sizes = separated.sizes
    step = sizes.form_length * min(1.0 / SUPPORTS, float((FOLLOWED / (SPLINE_LEFT * sizes.form)) ** 0.4))
    if settings.dead_band > 0:
        step /= 4.0
    if separated.filter.kind != "auto" and len(s) > 1:
        # A prescribed filter has a value of its own at every point.
        step = min(step, max(float(np.median(np.diff(np.sort(s)))), 0.05) / 3.0)
    return step


def _supports(stretch: Stretch, step: float) -> Floats:
    """Places on a stretch no farther apart than a step, mm from its start."""
    count = min(max(math.ceil(stretch.length / step), 8), MOST_SUPPORTS)
    even = np.linspace(0.0, stretch.length, count, endpoint=not stretch.closed)
    if not stretch.closed and stretch.length > 6 * LEVEL:
        # A course ends level: on a shorter way it would bend more than a cutter follows.
        even = even[(even >= LEVEL) & (even <= stretch.length - LEVEL)]
        even = np.concatenate([[0.0], even, [stretch.length]])
    return even
