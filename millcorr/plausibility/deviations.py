# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the deviations show: a moved or scaled part, wrong heights, another revision, one cause all along."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import UNREACHED, Deviation
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import at_z, joined, mm, option, phrase, um, xy
from millcorr.nc.toolpath import Toolpath

from . import elastic
from .file import identical_to_nominal
from .findings import Finding

MANY_REJECTED = 0.4
"""A larger share of points that cannot be used means the wrong program, part or frame."""

SOME_REJECTED = 0.1
"""A larger share is worth a word; below it the points beside those left out speak for their places."""

MISALIGNED = 0.05
"""A shift, turn or size of the whole part that moves points by more than this, in mm, is dangerous to correct."""

NOTICEABLE = 0.02
"""A shift, turn or size that moves no point by this, in mm, is what guideways out of square leave, too."""

EXPLAINED = 0.9
"""Share of the deviations' variance that a shift, turn or size explains before it is suspected: what is left over is
then a third of its size. Walls that give way are similar to a shift up to 0.85 (1,000 random sound jobs)."""

SMALL_PART = 70.0
"""Diagonal in mm below which more must be explained. Over a part that is small beside the lengths of a machine's errors
these are a shift and turn but for what grows with the part, of the variance with its square: 600 sound parts each of
20, 30, 45 and 60 mm left 0.1 (diagonal / 70 mm)^2 at least, but for two of the 2,400."""

LARGE_MEAN = 0.025
"""Below this mean, in mm, tool wear and a machine that gives way need no other explanation."""

MEAN_OVER_FORM = 2.0
"""A mean that is so many times the form's height is no average of a form: one cause acts all along."""

GROWTH = 11.5e-6
"""Thermal expansion of steel, 1/K."""

PLAUSIBLE_DEGREES = 20.0
"""No shop and no cut warms a part by more than this, in K, above where it is measured."""

STEP = 0.05
"""Sides that differ by less than this, in mm, differ by how much their walls and their direction of cut give way."""

STEP_OVER_FORM = 3.0
"""... and so many times more than anything on the sides themselves varies: machines leave transitions."""

NO_MACHINE = 0.2
"""A side cut this much too deep, in mm, beside others that are right is another drawing and no error of a machine."""

STRAIGHT = 1e-4
"""Largest curvature in 1/mm of a straight side."""

NEARLY_ALL = 0.9
"""Where a larger share of points lies where nothing is cut, it is the frame that is wrong and not a few points."""

TIP = 0.01
"""Points may lie this far, in mm, below the deepest pass: the height of a probe is no more exact."""


MOST_IN_FORM = 10_000
"""A form is told from so many values at most, each the median of a group of neighbours."""


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
                owner = profile.contour[search.find(known).span]
                lowest = np.full(len(bottom), np.inf)
                np.minimum.at(lowest, owner, known[:, 2])
                bottom = np.where(np.isfinite(lowest), np.fmin(bottom, lowest), bottom)
        start, end = toolpath.start[:, 2], toolpath.end[:, 2]
        down = start[np.isfinite(start) & np.isfinite(end) & (start > end)]
        return CutHeights(bottom, float(down.max()) if len(down) else np.inf)


def examine_deviations(
    deviation: Deviation,
    profile: Profile,
    cutter_radius: float,
    *,
    ball_radius: float = 0.0,
    heights: CutHeights | None = None,
    step: float = 0.0,
    depth: float = 0.0,
) -> tuple[Finding, ...]:
    """Signs of another part or program, frame, size, ball or tool, and of nominal in place of measured data.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    profile : Profile
    cutter_radius : float
        mm.
    ball_radius : float
        What was taken off between point and surface, mm; 0 for contact points.
    heights : CutHeights, optional
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
    found = _rejected(deviation)
    found += [] if heights is None else _heights(deviation, heights)
    misaligned, scaled = _moved_or_scaled(deviation, profile, depth)
    stepped, sides = _step(deviation, profile)
    # On few sides one is a special case of the other: the simplest is named, of what stops first.
    stops = misaligned if misaligned is not None and misaligned.dangerous else None
    found += [f for f in (stops, stepped if sides == 1 else None, scaled, misaligned, stepped) if f is not None][:1]
    return (*found, *_mean(deviation, profile, cutter_radius, ball_radius, depth))


def _rejected(deviation: Deviation) -> list[Finding]:
    """A large share of points that belong nowhere.

    What a cutter leaves in corners is what its program cuts: points there only say nothing of the walls.
    """
    strange = [r.reason for r in deviation.rejected if r.reason != UNREACHED]
    read = len(deviation) + len(strange)
    if len(strange) <= SOME_REJECTED * read:
        return []
    commonest, share = max(sorted(set(strange)), key=strange.count), len(strange) / read
    if share > MANY_REJECTED:
        text = phrase(
            "only {} of {} points can be used, most others are {}: is the program whole, and is it the "
            "one that cut the part?",
            len(deviation),
            read,
            commonest,
        )
        return [Finding("many-rejected", text, True, figure=share)]
    text = phrase(
        "{} of {} points cannot be used, most are {}: see the report for which", len(strange), read, commonest
    )
    return [Finding("many-rejected", text, False, figure=share)]


def _heights(deviation: Deviation, heights: CutHeights) -> list[Finding]:
    """Points below the deepest pass round their contour, or above all that the cutter comes down from."""
    progress.step()
    if not len(deviation):
        return []
    z, floor = deviation.z, heights.bottom[deviation.contour]
    below = z < floor - TIP
    above = z > heights.top + TIP
    remedy, explained = phrase("check the height of the work frame of the measurement"), False
    if below.sum() + above.sum() > NEARLY_ALL * len(z):
        deepest, top = float(np.nanmin(heights.bottom)), heights.top
        there = phrase("{} to {}", at_z(deepest), at_z(top)) if np.isfinite(top) else phrase("{} up", at_z(deepest))
        for how, other in (
            (phrase("times 25.4"), z * 25.4),
            (phrase("divided by 25.4"), z / 25.4),
            (phrase("with z reversed"), -z),
        ):
            # Whatever is near height 0 fits any unit.
            fits = (other >= floor - TIP) & (other <= top + TIP) & (np.minimum(np.abs(z), np.abs(other)) > 1.0)
            if fits.mean() > NEARLY_ALL:
                remedy = phrase("{} they would lie there; check the unit of z and the height of the work frame", how)
                explained = True
                break
        outside = int(below.sum() + above.sum())
        where = phrase("below") if below.sum() >= above.sum() else phrase("above")
        text = phrase(
            "{} of {} points on the profile ({} to {}) lie {} all that the program cuts, {}: "
            "{}, or leave the column z out",
            outside,
            len(z),
            at_z(z.min()),
            at_z(z.max()),
            where,
            there,
            remedy,
        )
        return [Finding("wrong-level", text, bool(where == "below" or explained))]
    found = []
    if below.any():
        worst = int(np.argmax(np.where(below, floor - z, -np.inf)))
        text = phrase(
            "{} points (from {}) lie below the deepest pass at {}: {}",
            int(below.sum()),
            at_z(z[below].min()),
            at_z(floor[worst]),
            remedy,
        )
        found.append(Finding("below-the-cut", text, False))
    if above.any():
        text = phrase(
            "{} points (up to {}) lie above {}, from where the cutter comes down: {}",
            int(above.sum()),
            at_z(z.max()),
            at_z(heights.top),
            remedy,
        )
        found.append(Finding("above-the-cut", text, False))
    return found


def _ordered(deviation: Deviation) -> Ints:
    """Rows in the order of their places along the contours, heights side by side."""
    progress.step()
    return np.lexsort((deviation.s, deviation.contour))


def _form(value: Floats) -> tuple[Floats, float]:
    """Values in order without single points, mm, and their height.

    The running median of a hundredth of the points, of 3 at least: shorter lumps are outliers, longer ones form.
    """
    progress.step()
    from scipy.ndimage import median_filter

    # Of very many points the medians of small groups: SciPy's filter takes its time over long windows.
    group = -(-len(value) // MOST_IN_FORM)
    groups = len(value) // group
    of_group = np.median(value[: groups * group].reshape(groups, group), axis=1)
    size = min(max(3, groups // 100 | 1), groups)
    middle: Floats = median_filter(of_group, size=size, mode="nearest")
    return middle[np.minimum(np.arange(len(value)) // group, groups - 1)], float(np.ptp(middle))


def _mean(
    deviation: Deviation, profile: Profile, cutter_radius: float, ball_radius: float, depth: float
) -> list[Finding]:
    """A mean that stands above the form, and what would explain it figure by figure."""
    progress.step()
    order = _ordered(deviation)
    form, height = _form(deviation.value[order])
    mean = float(form.mean())
    if abs(mean) < max(LARGE_MEAN, MEAN_OVER_FORM * height) or elastic.expected(mean, mean, depth):
        return []
    more = mean > 0
    if ball_radius:
        probe = phrase("a probe's radius {} for {}", mm(ball_radius + mean), mm(ball_radius, "g"))
    elif more:
        probe = phrase("a probe's radius {} too small", mm(mean))
    else:
        probe = phrase("a probe's radius {} too large", mm(-mean))
    tool = phrase("a tool's diameter {} for {}", mm(2 * (cutter_radius - mean)), mm(2 * cutter_radius, "g"))
    causes = [probe, tool]
    if more:
        causes.append(phrase("{} of stock left", mm(mean)))
    left, bottom, right, top = profile.bounding_box()
    arm = float(((deviation.foot - [(left + right) / 2, (bottom + top) / 2]) * deviation.normal).sum(axis=1).mean())
    degrees = mean / (GROWTH * arm) if arm else np.inf
    if abs(degrees) <= PLAUSIBLE_DEGREES:
        warm = phrase("steel measured {:.0f} K too warm", degrees)
        causes.append(warm if degrees > 0 else phrase("steel measured {:.0f} K too cold", -degrees))
    text = phrase(
        "mean {} all along, form only {}: check for {}; else the machine gives way",
        um(mean, "+.0f"),
        um(height, ".0f"),
        joined(causes),
    )
    return [Finding("constant-offset", text, False, figure=mean)]


def _step(deviation: Deviation, profile: Profile) -> tuple[Finding | None, int]:
    """Straight sides that lie off by a constant which the other sides do not have: another revision of the drawing.

    The sides fall into two groups with a gap between their medians that is wider than all that varies within either
    group and on any side. What a machine leaves varies along a side, and from side to side in between. With the
    finding, how many sides lie off.
    """
    progress.step()
    sides = _sides(deviation, profile)
    if len(sides) < 2:
        return None, 0
    # Outliers are few on each side, and its ends may lie on a fillet of another revision.
    low, median, high = np.array([np.percentile(deviation.value[rows], [10.0, 50.0, 90.0]) for rows in sides]).T
    rank = np.argsort(median)
    gaps = np.diff(median[rank])
    widest = int(np.argmax(gaps))
    groups = rank[: widest + 1], rank[widest + 1 :]
    varies = max(float((high - low).max()), *(float(np.ptp(median[group])) for group in groups))
    if gaps[widest] < max(STEP, STEP_OVER_FORM * varies):
        return None, 0
    # The sides that lie off are those farther from the nominal.
    off = max(groups, key=lambda group: abs(float(median[group].mean())))
    others = groups[1] if off is groups[0] else groups[0]
    step = float(median[off].mean() - median[others].mean())
    x, y = deviation.foot[sides[off[0]]].mean(axis=0)
    text = phrase(
        "sides that lie {} off the other {} all along (each within {}): {}, the first at {}; compare that dimension "
        "with the drawing: another revision, or a wall that gives way",
        um(step, "+.0f"),
        len(others),
        um(varies, ".0f"),
        len(off),
        xy(x, y),
    )
    # Nothing that gives way cuts deeper than it is told to on one side and rightly on the others.
    deeper = step < -NO_MACHINE and float(median[off].max()) < -NO_MACHINE
    return Finding("step", text, deeper, place=(float(x), float(y)), figure=float(step)), len(off)


def _sides(deviation: Deviation, profile: Profile) -> list[Ints]:
    """Rows of the points on each straight side, of at least 5 points and a twentieth of the contour."""
    order = _ordered(deviation)
    order = order[:: max(1, len(order) // 20_000)]
    contour, s, normal = deviation.contour[order], deviation.s[order], deviation.normal[order]
    straight = np.abs(profile.curvature(*profile.locate(contour, s))) < STRAIGHT
    turned = np.abs(normal[1:, 0] * normal[:-1, 1] - normal[1:, 1] * normal[:-1, 0]) > 0.01
    cut = (straight[1:] != straight[:-1]) | turned | (contour[1:] != contour[:-1])
    runs = np.split(np.arange(len(order)), np.flatnonzero(cut) + 1)
    whole = profile.total[contour]
    return [order[run] for run in runs if len(run) >= 5 and straight[run[0]] and np.ptp(s[run]) > 0.05 * whole[run[0]]]


def _moved_or_scaled(deviation: Deviation, profile: Profile, depth: float) -> tuple[Finding | None, Finding | None]:
    """A shift and turn, or a change of size, that by itself explains most of the deviations.

    A size leaves no constant beside it. With a free one the two cancel on a small or round part, and together with a
    shift they fit any four sides of a rectangle. So beside a size there is no more of a constant than what needs no
    explanation, and the size must move the rim by more than such a constant can cancel.

    No word where a stated depth leaves that much: walls of different stiffness look like either.
    """
    progress.step()
    low, high = np.percentile(deviation.value, [2, 98])
    if len(deviation) < 10 or elastic.expected(low, high, depth):
        return None, None
    n = deviation.normal
    left, bottom, right, top = profile.bounding_box()
    middle = np.array([(left + right) / 2, (bottom + top) / 2])
    size = max(right - left, top - bottom) / 2
    arm = (deviation.foot - middle) / size
    turn = arm[:, 0] * n[:, 1] - arm[:, 1] * n[:, 0]
    clipped = np.clip(deviation.value, low, high)
    misaligned = grown = None
    left_over = (1.0 - EXPLAINED) * min(float(np.hypot(right - left, top - bottom)) / SMALL_PART, 1.0) ** 2
    fitted, explained, moved = _explained(clipped, np.column_stack([n, turn]))
    if 1.0 - explained <= left_over and moved >= NOTICEABLE:
        dx, dy, turned = fitted
        text = phrase(
            "{:.0f} % of the deviations are what a shift of X{} Y{} and a turn of {:+.0f} arc "
            "seconds would give: check the alignment of the measurement ({}), or correct the work offset",
            100 * explained,
            um(dx, "+.0f"),
            um(dy, "+.0f"),
            np.degrees(turned / size) * 3600,
            option("align"),
        )
        misaligned = Finding("misalignment", text, moved > MISALIGNED, figure=moved)
    growth = (arm * n).sum(axis=1)
    fitted, scaled, _ = _explained(clipped, np.column_stack([n, turn, growth]), LARGE_MEAN)
    # What a mean takes back of a size is no error of the part.
    moved = min(float(np.abs(fitted[3] * growth).max()), float(np.abs(clipped).max()))
    # The simpler goes first: of what a mean, a shift and a turn leave.
    if 1.0 - scaled <= left_over * (1.0 - explained) and moved > MISALIGNED:
        factor = 1.0 + float(fitted[3]) / size
        text = phrase(
            "{:.0f} % of the deviations are what a size of {:.6f} times the profile's would give ({} at "
            "the rim; steel grows by 11.5 millionths a degree): check temperature, unit and scale of "
            "the measurement; no scale is ever applied",
            100 * scaled,
            factor,
            um(moved, ".0f"),
        )
        grown = Finding("scale", text, True, figure=factor)
    return misaligned, grown


def _explained(value: Floats, design: Floats, most: float = np.inf) -> tuple[Floats, float, float]:
    """Fit of columns beside a constant of at most so many mm: coefficients, share explained, largest effect.

    The share is of the variance; a mean that is left counts as not explained. Columns that the points hardly determine
    (one straight edge, a round part) say nothing and are left out.
    """
    progress.step()
    out = np.zeros(design.shape[1])
    strong = np.sqrt(((design - design.mean(axis=0)) ** 2).mean(axis=0)) > 0.1
    columns = np.column_stack([np.ones(len(value)), design[:, strong]])
    variance = float(value.var())
    # Columns so far from being alike that their products lose nothing: four rows and columns in place of all points.
    products = columns.T @ columns
    if not strong.any() or np.linalg.cond(products) > 20**2 or variance == 0.0:
        return out, 0.0, 0.0
    constant = float(np.linalg.solve(products, columns.T @ value)[0])
    # Of a quadratic in one number the best within bounds is the best of all, cut at the bound.
    constant = min(max(constant, -most), most)
    out[strong] = np.linalg.solve(products[1:, 1:], columns[:, 1:].T @ (value - constant))
    effect = design @ out
    left = float(((value - constant - effect) ** 2).mean())
    return out, 1.0 - left / variance, float(np.abs(effect).max())
