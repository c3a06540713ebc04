# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the deviations show: a moved or scaled part, wrong heights, outliers, too few points for the filter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.compensation import along
from millcorr.deviation import Deviation
from millcorr.footpoint import FootPointSearch
from millcorr.profile import Profile
from millcorr.separation.filters import Filter
from millcorr.toolpath import Toolpath

from . import elastic
from .file import identical_to_nominal
from .findings import Finding

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

MANY_REJECTED = 0.4
"""A larger share of points that cannot be used means the wrong program, part or frame."""

MISALIGNED = 0.05
"""A shift, turn or size of the whole part that moves points by more than this, in mm, is dangerous to correct."""

NOTICEABLE = 0.005
"""A shift, turn or size that moves no point by this, in mm, is not worth a word."""

EXPLAINED = 0.7
"""Share of the squared deviations that a shift, turn or size explains by itself before it is suspected."""

OUTLIER = 8.0
"""So many standard deviations from its neighbours' median a point is an outlier."""

AMONG_OTHERS = 5.0
"""A value this many standard deviations of all values, waves and steps included, off their median is no wave."""

LEAST_SCATTER = 1e-4
"""Scatter in mm below which nobody measures."""

NEARLY_ALL = 0.9
"""Where a larger share of points lies where nothing is cut, it is the frame that is wrong and not a few points."""

TIP = 0.01
"""Points may lie this far, in mm, below the deepest pass: the height of a probe is no more exact."""

AUTO_NEEDS = 6
"""With fewer points on a stretch `auto` has no freedom to tell the determined from the random part: its finest
line takes three points a knot, and Moran's I needs neighbours."""


@dataclass(frozen=True, eq=False, slots=True)
class CutHeights:
    """Between which heights a program cuts the profile.

    Parameters
    ----------
    bottom : (contours,) float64
        Lowest height of the moves that follow each contour, mm; NaN where it is not known.
    top : float
        Height from which the cutter goes down at most, mm: no material of the cut is above it. Infinite where
        it is not known.
    """

    bottom: Floats
    top: float

    @staticmethod
    def of(toolpath: Toolpath, following: Bools, profile: Profile) -> CutHeights:
        """Heights of a program.

        Parameters
        ----------
        toolpath : Toolpath
        following : (m,) bool
            Moves that follow the profile.
        profile : Profile
        """
        bottom = np.full(len(profile.contours), np.nan)
        rows = np.flatnonzero(following)
        search = FootPointSearch(profile)
        for end in (toolpath.start[rows], toolpath.end[rows]):
            known = end[np.isfinite(end).all(axis=1)]
            if len(known):
                owner = profile.contour[search.find(np.ascontiguousarray(known[:, :2])).span]
                lowest = np.full(len(bottom), np.inf)
                np.minimum.at(lowest, owner, known[:, 2])
                bottom = np.where(np.isfinite(lowest), np.fmin(bottom, lowest), bottom)
        start, end = toolpath.start[:, 2], toolpath.end[:, 2]
        down = start[np.isfinite(start) & np.isfinite(end) & (start > end)]
        return CutHeights(bottom, float(down.max()) if len(down) else np.inf)


def examine_deviations(
    deviation: Deviation,
    machine: Floats,
    profile: Profile,
    heights: CutHeights | None,
    step: float = 0.0,
    depth: float = 0.0,
) -> tuple[Finding, ...]:
    """Signs of misalignment, a wrong size, outliers, nominal in place of measured data and a wrong height.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    machine : (n,) float64
        Deviations less the program's own offset, mm.
    profile : Profile
    heights : CutHeights or None
        None where the points have no height.
    step : float
        Resolution of the file's coordinates in mm; 0 where it has none.
    depth : float
        Depth in mm along the normal that the part was cut at, where elastic deviations are expected; 0 elsewhere.

    Returns
    -------
    tuple of Finding
    """
    identical = identical_to_nominal(deviation.value, step)
    if identical is not None:
        return (identical,)
    found = []
    read = len(deviation) + len(deviation.rejected)
    if len(deviation.rejected) > MANY_REJECTED * read:
        text = (
            f"only {len(deviation)} of {read} points can be used, most others are {_commonest(deviation)}: is the "
            "program whole, and is it the one that cut the part?"
        )
        found.append(Finding("many-rejected", text, True))
    found += [] if heights is None else _heights(deviation, heights)
    found += _outliers(deviation, machine)
    return (*found, *_moved_or_scaled(deviation, profile, depth))


def _commonest(deviation: Deviation) -> str:
    reasons = [r.reason for r in deviation.rejected]
    return max(set(reasons), key=reasons.count)


def _heights(deviation: Deviation, heights: CutHeights) -> list[Finding]:
    """Points below the deepest pass round their contour, or above all that the cutter comes down from."""
    if not len(deviation):
        return []
    z, floor = deviation.z, heights.bottom[deviation.contour]
    below = z < floor - TIP
    above = z > heights.top + TIP
    remedy = "check the height of the work frame of the measurement"
    if below.sum() + above.sum() > NEARLY_ALL * len(z):
        deepest, top = float(np.nanmin(heights.bottom)), heights.top
        there = f"Z{deepest:.3f}" + (f" to Z{top:.3f}" if np.isfinite(top) else " up")
        for how, other in (("times 25.4", z * 25.4), ("divided by 25.4", z / 25.4), ("with z reversed", -z)):
            # Whatever is near height 0 fits any unit.
            fits = (other >= floor - TIP) & (other <= top + TIP) & (np.minimum(np.abs(z), np.abs(other)) > 1.0)
            if fits.mean() > NEARLY_ALL:
                remedy = f"{how} they would lie there; check the unit of z and the height of the work frame"
                break
        outside = int(below.sum() + above.sum())
        where = "below" if below.sum() >= above.sum() else "above"
        text = (
            f"{outside} of {len(z)} points on the profile "
            f"(Z{float(z.min()):.3f} to Z{float(z.max()):.3f}) lie {where} all that the "
            f"program cuts, {there}: {remedy}, or leave the column z out"
        )
        return [Finding("wrong-level", text, bool(where == "below" or "would" in remedy))]
    found = []
    if below.any():
        worst = int(np.argmax(np.where(below, floor - z, -np.inf)))
        text = (
            f"{int(below.sum())} points (from Z{float(z[below].min()):.3f}) lie below the deepest pass at "
            f"Z{floor[worst]:.3f}: {remedy}"
        )
        found.append(Finding("below-the-cut", text, False))
    if above.any():
        text = (
            f"{int(above.sum())} points (up to Z{float(z.max()):.3f}) lie above Z{heights.top:.3f}, from where the "
            f"cutter comes down: {remedy}"
        )
        found.append(Finding("above-the-cut", text, False))
    return found


def _outliers(deviation: Deviation, machine: Floats) -> list[Finding]:
    """Single points far from their neighbours along the contour."""
    from scipy.ndimage import median_filter

    if len(machine) < 8:
        return []
    residual = np.empty(len(machine))
    order = np.lexsort((deviation.s, deviation.level, deviation.stretch))
    block = deviation.stretch[order] * (int(deviation.level.max()) + 1) + deviation.level[order]
    for rows in np.split(order, np.flatnonzero(np.diff(block)) + 1):
        middle = median_filter(machine[rows], size=7, mode="mirror") if len(rows) >= 8 else np.median(machine[rows])
        residual[rows] = machine[rows] - middle
    size = np.abs(residual)
    # Where a few points of a stretch are their own median, the mean of the smaller nine tenths holds.
    scatter = max(1.482602 * float(np.median(size)), 1.253314 * float(np.minimum(size, np.quantile(size, 0.9)).mean()))
    # A wave or a step that the few points round it do not show is no outlier: it stays among the others' values.
    low, typical, high = np.percentile(machine, [25.0, 50.0, 75.0])
    usual = max((high - low) / 1.349, LEAST_SCATTER)
    far = (size > OUTLIER * max(scatter, LEAST_SCATTER)) & (np.abs(machine - typical) > AMONG_OTHERS * usual)
    if not far.any() or far.mean() > 0.1:
        return []
    worst = int(np.argmax(size))
    x, y = deviation.foot[worst]
    count = int(far.sum())
    text = (
        f"{count} {'outlier' if count == 1 else 'outliers'}, the largest {residual[worst] * 1000:+.1f} um off its "
        f"neighbours at X{x:.3f} Y{y:.3f}: the filters auto and robust leave them out, mean and gauss do not"
    )
    return [Finding("outliers", text, False)]


def _moved_or_scaled(deviation: Deviation, profile: Profile, depth: float) -> tuple[Finding, ...]:
    """A shift and turn, or a change of size, that by itself explains most of the deviations.

    Dangerous only where the machine's giving way cannot be it: walls of different stiffness look like either.
    """
    if len(deviation) < 10:
        return ()
    n = deviation.normal
    left, bottom, right, top = profile.bounding_box()
    middle = np.array([(left + right) / 2, (bottom + top) / 2])
    size = max(right - left, top - bottom) / 2
    arm = (deviation.foot - middle) / size
    turn = arm[:, 0] * n[:, 1] - arm[:, 1] * n[:, 0]
    low, high = np.percentile(deviation.value, [2, 98])
    clipped = np.clip(deviation.value, low, high)
    expected = elastic.expected(low, high, depth)
    also = ""
    if expected:
        ms = [elastic.transfer(value, depth) for value in (low, high)]
        also = f"; a transfer function of {ms[0]:.3f} to {ms[1]:.3f} would give them, too"
    found = []
    fitted, explained, moved = _explained(clipped, np.column_stack([n, turn]))
    if explained >= EXPLAINED and moved >= NOTICEABLE:
        dx, dy, turned = fitted
        text = (
            f"{100 * explained:.0f} % of the deviations are what a shift of X{dx * 1000:+.0f} Y{dy * 1000:+.0f} um and "
            f"a turn of {np.degrees(turned / size) * 3600:+.0f} arc seconds would give: check the alignment of the "
            f"measurement (--align), or correct the work offset{also}"
        )
        found.append(Finding("misalignment", text, moved > MISALIGNED and not expected))
    growth = (arm * n).sum(axis=1)
    fitted, scaled, _ = _explained(clipped, np.column_stack([n, turn, growth]))
    moved = float(np.abs(fitted[3] * growth).max())
    # Beside a shift and turn, of what those leave.
    if scaled >= EXPLAINED and 1.0 - scaled <= (1.0 - EXPLAINED) * (1.0 - explained) and moved >= NOTICEABLE:
        factor = 1.0 + float(fitted[3]) / size
        text = (
            f"{100 * scaled:.0f} % of the deviations are what a size of {factor:.6f} times the profile's would "
            f"give ({moved * 1000:.0f} um at the rim; steel makes 11.5 um per metre and degree): check temperature, "
            f"unit and scale of the measurement; no scale is ever applied{also}"
        )
        found.append(Finding("scale", text, moved > MISALIGNED and not expected))
    return tuple(found)


def _explained(value: Floats, design: Floats) -> tuple[Floats, float, float]:
    """Fit of columns beside a constant: coefficients, share that they explain, largest effect.

    The share is the smaller one of those of the squares (a constant is no motion: what it explains is not theirs) and
    of the variation about a constant (which must not be split into a motion and its opposite).

    Columns that the points hardly determine (one straight edge, a round part) say nothing and are left out.
    """
    out = np.zeros(design.shape[1])
    strong = np.sqrt(((design - design.mean(axis=0)) ** 2).mean(axis=0)) > 0.1
    columns = np.column_stack([np.ones(len(value)), design[:, strong]])
    if columns.shape[1] < 2 or np.linalg.cond(columns) > 20:
        return out, 0.0, 0.0
    out[strong] = np.linalg.lstsq(columns, value, rcond=None)[0][1:]
    effect = design @ out
    total, variation = float((value**2).mean()), float(value.var())
    if variation == 0.0:
        return out, 0.0, 0.0
    explained = 1.0 - float(((value - effect) ** 2).mean()) / total
    of_variation = 1.0 - float((value - effect).var()) / variation
    return out, min(explained, of_variation), float(np.abs(effect).max())


def examine_sampling(deviation: Deviation, profile: Profile, filter: Filter) -> tuple[Finding, ...]:
    """Whether there are enough points for a filter.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    profile : Profile
    filter : Filter

    Returns
    -------
    tuple of Finding
        At most one, with the worst stretch.

    Notes
    -----
    A wave comes back from points only if it is longer than twice their spacing (Nyquist). A cutoff below the
    spacing itself lets all of the random part through, whatever the user meant to keep out of the next part.
    """
    few: list[tuple[float, str, bool]] = []
    stretches = profile.stretches()
    levels = int(deviation.level.max(initial=0)) + 1
    for key in np.unique(deviation.stretch * levels + deviation.level):
        number, level = divmod(int(key), levels)
        stretch = stretches[number]
        rows = (deviation.stretch == number) & (deviation.level == level)
        s = np.unique(np.round(along(stretch, deviation.s[rows], profile), 6))
        gaps = np.diff(s)
        if stretch.closed and len(s) > 1:
            gaps = np.append(gaps, s[0] + stretch.length - s[-1])
        if not len(gaps):
            continue
        x, y = deviation.foot[np.flatnonzero(rows)[0]]
        where = f"on the stretch of {stretch.length:.3g} mm at X{x:.3f} Y{y:.3f}"
        typical = float(np.median(gaps))
        if filter.kind == "auto" and len(s) < AUTO_NEEDS:
            text = (
                f"{len(s)} points {where} are too few for --filter auto to tell the determined from the random "
                f"part, it needs {AUTO_NEEDS}: measure more points, or average several parts"
            )
            few.append((AUTO_NEEDS / len(s), text, False))
        elif filter.kind == "mean" and len(filter.mask) > len(s):
            text = (
                f"{len(s)} points {where} are fewer than the {len(filter.mask)} that --filter {filter} averages: "
                "measure more points, or take --filter auto"
            )
            few.append((len(filter.mask) / len(s), text, False))
        elif filter.cutoff < typical:
            text = (
                f"the points {where} are {typical:.3g} mm apart, farther than the cutoff of --filter {filter}: nothing "
                f"would be filtered; take --filter {filter.kind}:{2.0 * typical:.2g} or more, or points every "
                f"{0.5 * filter.cutoff:.2g} mm"
            )
            few.append((typical / filter.cutoff, text, True))
    if not few:
        return ()
    _, text, dangerous = max(few, key=lambda entry: (entry[2], entry[0]))
    return (Finding("too-few-points", text, dangerous),)
