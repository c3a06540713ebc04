# SPDX-License-Identifier: LGPL-2.1-or-later
"""From measured parts to where the profile is to be moved: averaged, separated, aimed, laid along the contour."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .compensation import Correction, along, correction_from, dead_band
from .deviation import Deviation, statistics
from .errors import UsageError
from .filtering import Filter, Separation, separate
from .gaps import wide_gaps
from .parts import averaged
from .profile import Profile
from .settings import Settings
from .transfer_function import TransferFunction, along_axis, examine, from_line, identify, line_over_depth, one_value
from .uncertainty import of_one_part, of_several_parts

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


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
            out.append(f"gain {settings.gain:g} leaves {left:.0f} % of what the next part would show on purpose")
        if not self.transfer.offset_known:
            out.append(
                "one depth cannot tell a constant offset (tool radius, backlash, edge force) from elastic response: "
                "all of it is taken as elastic, which is right at the depth measured; for another depth measure two"
            )
        if settings.depth_along != "normal":
            more = self.system.correction(self.next_depth) - self.transfer.correction(self.next_depth)
            out.append(
                f"deviations along {settings.depth_along.upper()} with depths along the normal correct by "
                f"{1000 * more.mean():.1f} um more on average than --depth-along normal"
            )
        return tuple(out)


@dataclass(frozen=True, eq=False, slots=True)
class Target:
    """Deviations with what became of them, and the filter's trust in each; arrays over the used points."""

    deviation: Deviation
    commanded: Floats
    filtered: Floats
    uncertainty: Floats
    wanted: Floats
    separations: tuple[Separation, ...]
    random_std: float
    elastic: Elastic | None = None
    trust: Floats | None = None

    @staticmethod
    def empty() -> Target:
        """Target without a point: nothing was measured."""
        none, zero = np.zeros(0, dtype=np.int64), np.zeros(0)
        flat = np.zeros((0, 2))
        deviation = Deviation(none, none, none, none, zero, zero, flat, flat, zero, ())
        return Target(deviation, zero, zero, zero, zero, (), float("nan"))

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
    filtered: _Filtered
    random_std: float
    aim: TransferFunction | None = None
    system: TransferFunction | None = None


@dataclass(frozen=True, eq=False, slots=True)
class _Filtered:
    """Values filtered, one separation a stretch and level."""

    determined: Floats
    blocks: tuple[tuple[Ints, Separation], ...]

    @property
    def random_std(self) -> float:
        """Standard deviation of the random part over all stretches and levels where it is known; else NaN."""
        known = [(part.random_std, len(rows)) for rows, part in self.blocks if math.isfinite(part.random_std)]
        total = sum(n for _, n in known)
        return math.sqrt(sum(std**2 * n for std, n in known) / total) if total else math.nan

    @property
    def trust(self) -> Floats:
        """Weight of every point, 0 (outlier) to 1; (n,)."""
        out = np.zeros(len(self.determined))
        for rows, part in self.blocks:
            out[rows] = part.weights
        return out

    def std(self, single: float | None = None) -> Floats:
        """Standard uncertainty of the filtered values: random part times the root of the filter's variance; (n,)."""
        out = np.full(len(self.determined), math.nan)
        for rows, part in self.blocks:
            out[rows] = (part.random_std if single is None else single) * math.sqrt(part.variance_factor)
        # A point that was given its neighbours' value is as uncertain as the worst.
        out[np.isnan(out)] = np.fmax.reduce(out)
        return out


def target_of(
    parts: list[Part], nominal: Profile, settings: Settings, corrected_before: bool, warnings: list[str]
) -> Target:
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
    warnings : list of str
        Findings are appended.

    Returns
    -------
    Target

    Raises
    ------
    UsageError, InputError, RefusedError
        If depths are missing, do not fit the parts, or make no transfer function.
    """
    depths = settings.each("depth", len(parts))
    first = parts[0]
    if len(set(depths)) > 1:
        found = _at_several_depths(parts, depths, nominal, settings, warnings)
    else:
        found = _at_one_depth(parts, depths[0], nominal, settings, warnings)
    deviation, offset = first.deviation, first.offset
    if found.machine is not first.machine:
        deviation = replace(deviation, value=offset + found.machine)
    filtered = offset + found.determined
    elastic: Elastic | None = None
    aim, yields = -found.determined, np.ones(len(offset))
    if found.aim is not None and found.system is not None:
        warnings += examine(found.aim, deviation.foot)
        stock = np.broadcast_to(_next_depth(parts, depths, settings, filtered), filtered.shape)
        elastic = Elastic(found.aim, found.system, stock, settings.depths, settings.transfer_function)
        aim, yields = found.aim.correction(stock), 1.0 + found.aim.ms
    # A path put e over the nominal leaves (e - aim) / (1 + MS): 0 at the aim. Without a transfer function MS is 0.
    base = offset if corrected_before else np.zeros(len(offset))
    left = dead_band((base - aim) / yields, settings.dead_band)
    wanted = base - settings.gain * yields * left
    separations = tuple(part for _, part in found.filtered.blocks)
    trust = found.filtered.trust
    return Target(deviation, offset, filtered, found.uncertainty, wanted, separations, found.random_std, elastic, trust)


def _next_depth(parts: list[Part], depths: tuple[float, ...], settings: Settings, filtered: Floats) -> float | Floats:
    """Stock over the nominal that the next program finds, mm: one number, or what the measured part still has."""
    if settings.next_depth is not None:
        return settings.next_depth
    allowances = {part.allowance for part in parts}
    if len(set(depths)) > 1 or len(allowances) > 1:
        raise UsageError("the parts were cut at different depths: say with --next-depth MM what the next one takes off")
    allowance = allowances.pop()
    # The second half of an allowance is cut from the real surface, not from where the first half was to end.
    return allowance + filtered if allowance > 0 else depths[0]


def _at_one_depth(parts: list[Part], depth: float, nominal: Profile, settings: Settings, warnings: list[str]) -> _Found:
    """Parts of one depth: their mean, filtered; the transfer function where the settings want one."""
    first = parts[0]
    deviation, machine, part_std, several = first.deviation, first.machine, math.nan, None
    if len(parts) > 1:
        several = averaged([(p.deviation, p.machine) for p in parts], nominal)
        machine, part_std = several.mean, several.std
        warnings.append(
            f"deviations are the mean of {len(parts)} parts; from part to part they differ by "
            f"{part_std * 1000:.2f} um (standard deviation)"
        )
    found = _filtered(deviation, machine, nominal, settings, warnings)
    if several is None:
        uncertainty = of_one_part(machine, deviation, found.blocks)
    else:
        uncertainty = of_several_parts(several, deviation, found.blocks)
    random_std = part_std if math.isfinite(part_std) else found.random_std
    if settings.method != "transfer":
        return _Found(machine, found.determined, uncertainty, found, random_std)
    h, place = depth - first.offset, deviation.foot
    system = identify(found.determined, h, uncertainty, place)
    factor = along_axis(deviation.normal, place, settings.depth_along)
    # A point of the mean of parts is as uncertain as their spread lets it be.
    single = factor * (part_std / math.sqrt(len(parts)) if math.isfinite(part_std) else found.random_std)
    if settings.transfer_function == "points":
        aim = identify(factor * machine, h, single, place)
    else:
        aim = identify(factor * found.determined, h, factor * uncertainty, place)
    if settings.transfer_function == "one":
        ms, std = one_value(aim.ms, found.trust, (1.0 + aim.ms) ** 2 * single / h)
        aim = TransferFunction.constant(ms, std, len(aim))
    return _Found(machine, found.determined, uncertainty, found, random_std, aim, system)


def _at_several_depths(
    parts: list[Part], depths: tuple[float, ...], nominal: Profile, settings: Settings, warnings: list[str]
) -> _Found:
    """Parts of different depths: transfer function from the slope over the depth, offset from what the slope leaves."""
    first = parts[0]
    deviation, place = first.deviation, first.deviation.foot
    values = averaged([(p.deviation, p.machine) for p in parts], nominal).values
    # Each part was cut by the program of its time: where one says nothing, its value is left out anyway.
    offsets = np.nan_to_num(averaged([(p.deviation, p.offset) for p in parts], nominal).values)
    h: Floats = np.asarray(depths)[:, None] - offsets
    line = line_over_depth(values, h)
    slope = _filtered(deviation, line.slope, nominal, settings, warnings)
    b, middle = slope.determined, h.mean(axis=0)
    # All values brought to the mean depth by the slope, so that a part without a point here makes no step.
    level = np.nanmean(values - b * (h - middle), axis=0)
    levels = _filtered(deviation, level, nominal, settings, warnings)
    single = slope.random_std
    if math.isfinite(line.std):
        single = line.std / math.sqrt(float(np.median(line.spread[line.spread > 0])))

    def reading(b: Floats, std: Floats, level: Floats, level_std: Floats, factor: Floats) -> TransferFunction:
        return from_line(
            level - b * middle, factor * b, slope_std=factor * std, level_std=level_std, depth=middle, place=place
        )

    ones = np.ones(len(b))
    system = reading(b, slope.std(single), levels.determined, levels.std(), ones)
    factor = along_axis(deviation.normal, place, settings.depth_along)
    if settings.transfer_function == "points":
        b_at = np.where(np.isfinite(line.slope), line.slope, b)
        aim = reading(b_at, single * ones, level, levels.random_std * ones, factor)
    elif settings.transfer_function == "one":
        mean, std = one_value(b, slope.trust, single * ones)
        aim = reading(mean * ones, std * ones, levels.determined, levels.std(), factor)
    else:
        aim = reading(b, slope.std(single), levels.determined, levels.std(), factor)
    listed = ", ".join(f"{d:g}" for d in sorted(set(depths)))
    warnings.append(
        f"{len(parts)} parts cut {listed} mm deep: the transfer function is taken from the difference, the constant "
        "offset apart; deviations are shown as at the depth of the first"
    )
    first_depth = b * (h[0] - middle)
    random_std = line.std if math.isfinite(line.std) else levels.random_std * math.sqrt(len(parts))
    uncertainty = np.hypot(
        of_one_part(level, deviation, levels.blocks),
        of_one_part(line.slope, deviation, slope.blocks) * (h[0] - middle),
    )
    determined = levels.determined + first_depth
    return _Found(level + first_depth, determined, uncertainty, levels, random_std, aim, system)


def _filtered(
    deviation: Deviation, values: Floats, nominal: Profile, settings: Settings, warnings: list[str]
) -> _Filtered:
    """Determined part of values, each stretch and level by itself; points without a value take their neighbours'."""
    filter_ = Filter.parse(settings.filter)
    determined = np.full(len(deviation), math.nan)
    blocks: list[tuple[Ints, Separation]] = []
    for k, stretch in enumerate(nominal.stretches()):
        for level in np.unique(deviation.level[deviation.stretch == k]):
            rows = np.flatnonzero((deviation.stretch == k) & (deviation.level == level))
            s = along(stretch, deviation.s[rows], nominal)
            known = np.isfinite(values[rows])
            if not known.any():
                continue
            part = separate(s[known], values[rows[known]], length=stretch.length, closed=stretch.closed, filter=filter_)
            determined[rows[known]] = part.determined
            if not known.all():
                order = np.argsort(s[known], kind="stable")
                period = stretch.length if stretch.closed else None
                determined[rows[~known]] = np.interp(s[~known], s[known][order], part.determined[order], period=period)
            blocks.append((rows[known], part))
            warnings += [w for w in part.warnings if w not in warnings]
    determined = np.where(np.isfinite(determined), determined, np.nanmean(determined))
    return _Filtered(determined, tuple(blocks))


def _typical(std: Floats) -> float:
    """Root mean square of standard uncertainties; NaN where one is not known."""
    return float(np.sqrt(np.mean(std**2)))


def correction_through(
    work: Target, nominal: Profile, settings: Settings, warnings: list[str], rest: Correction | None = None
) -> Correction:
    """Course of the correction through a target's points; levels by themselves, then their mean.

    In gaps that are too wide to be bridged it runs out into `rest`, what the program has there already: by default
    nothing.
    """
    deviation = work.deviation
    laid = partial(
        correction_from,
        nominal,
        limit=settings.limit,
        gaps=wide_gaps(deviation, nominal, Filter.parse(settings.filter).cutoff),
        rest=rest,
    )
    levels = np.unique(deviation.level)
    if len(levels) == 1:
        correction, notes = laid(deviation.stretch, deviation.s, work.wanted)
        warnings += notes
        return correction
    # Each level by itself, then their mean along the contour: points of different heights are never mixed.
    single = []
    for level in levels:
        rows = deviation.level == level
        one, notes = laid(deviation.stretch[rows], deviation.s[rows], work.wanted[rows])
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
    mean, notes = laid(deviation.stretch[rows], deviation.s[rows], values.mean(axis=0))
    warnings += [n for n in notes if n not in warnings]
    return mean
