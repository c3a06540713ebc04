# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a filter made of the deviations: a determined part that no measured point bears out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.deviation import Deviation
from millcorr.profile import Profile

from .findings import Finding

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

OVER = 0.005
"""A determined part may leave the range of the values it comes from by this, in mm: less than is worth a word."""

OF_RANGE = 0.08
"""... and by this share of the range: a fitted line is rounder than what it runs through."""

NOISES = 5.0
"""... and by so many standard deviations from point to point."""

WORSE = 0.02
"""A correction that leaves more than was measured does so by more than this, in mm, and not by noise."""

WORSE_OF_RANGE = 0.25
"""... and by more than this share of the range: any smoothing moves the foot of a step."""

AT_LEAST = 2
"""A single point may be a slip."""

IGNORED = 1e-3
"""Points with less trust than this were taken as outliers."""

NARROW = 5.0
"""Errors of a machine come again with the pitch of its ball screws, 5 mm or more; what is raised on less of the contour
is no such wave."""

HIGH = 0.03
"""What a machine does on a shorter way, at the reversal of an axis, stays below this, in mm."""

ABOVE_USUAL = 6.0
"""So many standard deviations of all points of a stretch about their running median a lump must be high."""

TAKEN = 0.015
"""What a filter lets through of a lump is worth stopping for from here on, in mm."""

MOST_RAISED = 0.1
"""Where more of the points are raised it is the part."""

OF_SWING = 0.25
"""A running median over 20 mm cuts this share of the swing off crests of waves of 30 mm, and less of longer ones."""

ENOUGH = 16
"""Among fewer points on a stretch it cannot be told what is usual."""

MOST_NEIGHBOURS = 401
"""A running median is taken over so many values at most: SciPy's needs memory for all of them at every point."""


def examine_determined(
    deviation: Deviation, machine: Floats, determined: Floats, trust: Floats | None, profile: Profile
) -> tuple[Finding, ...]:
    """Whether a filter's determined part goes beyond what was measured, or makes measured places worse.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    machine, determined : (n,) float64
        What the machine added at the points, and the determined part of it, mm; NaN where it is not known.
    trust : (n,) float64 or None
        The filter's trust in each point, 0 (outlier) to 1; None: all are trusted.
    profile : Profile
        Nominal.

    Returns
    -------
    tuple of Finding
        At most one, with the worst stretch or lump.

    Notes
    -----
    A filter takes something away; what it returns stays within the values it believes, but for noise. A chip or
    swarf under the probe raises a few points by far more than their neighbours: a spline that follows them swings
    out on both sides, and takes the good neighbours for the outliers.
    """
    worst: tuple[float, str] | None = None
    block = deviation.stretch * (int(deviation.level.max(initial=0)) + 1) + deviation.level
    for key in np.unique(block):
        rows = np.flatnonzero((block == key) & np.isfinite(machine))
        believed = rows if trust is None else rows[trust[rows] > IGNORED]
        if len(believed) < 3:
            continue
        low, high = float(machine[believed].min()), float(machine[believed].max())
        noise = NOISES * point_to_point(machine[rows[np.argsort(deviation.s[rows], kind="stable")]])
        beyond = np.maximum(determined[rows] - high, low - determined[rows])
        at = int(np.argmax(beyond))
        if beyond[at] > max(OVER, OF_RANGE * (high - low), noise):
            seen = (
                f"the filter's determined part reaches {determined[rows[at]] * 1000:+.0f} um near "
                f"{_place(deviation, rows[at])}, but the points that it believes lie between {low * 1000:+.0f} and "
                f"{high * 1000:+.0f} um"
            )
            worst = max(worst or (0.0, ""), (float(beyond[at]), seen))
        more = np.abs(machine[rows] - determined[rows]) - np.abs(machine[rows])
        bad = more > max(WORSE, WORSE_OF_RANGE * (high - low), noise)
        if int(bad.sum()) >= AT_LEAST:
            at = int(np.argmax(more))
            left = machine[rows[at]] - determined[rows[at]]
            seen = (
                f"{int(bad.sum())} points would be worse after the correction, at {_place(deviation, rows[at])} "
                f"{left * 1000:+.0f} um in place of {machine[rows[at]] * 1000:+.0f}"
            )
            worst = max(worst or (0.0, ""), (float(more[at]), seen))
    lumps = _swarf(deviation, machine, determined, block, profile)
    if worst is None or lumps:
        return lumps
    text = (
        f"{worst[1]}: a chip under the probe, or a filter too coarse or too fine for these points; leave such points "
        "out, measure there again, or take another --filter"
    )
    return (Finding("overshoot", text, True),)


def _swarf(
    deviation: Deviation, machine: Floats, determined: Floats, block: Ints, profile: Profile
) -> tuple[Finding, ...]:
    """A few neighbouring points far above the others that the determined part follows."""
    stretches = profile.stretches()
    worst: tuple[float, str] | None = None
    for key in np.unique(block):
        rows = np.flatnonzero((block == key) & np.isfinite(machine))
        rows = rows[np.argsort(deviation.s[rows], kind="stable")]
        if len(rows) < ENOUGH:
            continue
        s = deviation.s[rows]
        stretch = stretches[int(deviation.stretch[rows[0]])]
        size = max(min(2 * int(2.0 * NARROW / max(float(np.median(np.diff(s))), 1e-6)) + 1, len(rows) // 2), 7)
        base = _running_median(machine[rows], size, stretch.closed)
        over = machine[rows] - base
        # Waves and steps of the part itself, what is left of them beside a running median, and what it cuts off crests.
        usual = 1.482602 * float(np.median(np.abs(over)))
        raised = over > max(HIGH, ABOVE_USUAL * usual, OF_SWING * float(np.ptp(base)))
        if stretch.closed:
            # No lump lies across the place to begin at.
            low = int(np.argmax(~raised & ~np.roll(raised, 1)))
            rows, base, raised = np.roll(rows, -low), np.roll(base, -low), np.roll(raised, -low)
            s = np.concatenate([s[low:], s[:low] + stretch.length])
        if raised.mean() > MOST_RAISED:
            continue
        step = np.diff(raised.astype(int))
        begin, end = np.flatnonzero(step == 1) + 1, np.flatnonzero(step == -1)
        # Next to a corner machines do leave such errors.
        begin, end = begin[: len(begin) - int(raised[-1])], end[int(raised[0]) :]
        wide, apart = s[end] - s[begin], np.maximum(s[begin] - s[begin - 1], s[end + 1] - s[end])
        for first, last, width in zip(begin, end, np.maximum(wide, apart), strict=True):
            run = rows[first : last + 1]
            taken = float((determined[run] - base[first : last + 1]).max())
            if width > NARROW or taken < TAKEN:
                continue
            at = first + int(np.argmax(machine[run]))
            height = machine[rows[at]] - base[at]
            seen = (
                f"{len(run)} {'point' if len(run) == 1 else 'neighbouring points'} near {_place(deviation, rows[at])} "
                f"{'lies' if len(run) == 1 else 'lie up to'} {height * 1000:+.0f} um over what is round, on "
                f"{s[last + 1] - s[first - 1]:.2g} mm of the contour, and the "
                f"correction would take {taken * 1000:.0f} um of that away"
            )
            worst = max(worst or (0.0, ""), (float(height), seen))
    if worst is None:
        return ()
    text = (
        f"{worst[1]}: so high and narrow is swarf under the probe, not an error of a machine; clean the part and "
        "measure there again, leave the points out, or take --filter robust:MM"
    )
    return (Finding("swarf", text, True),)


def _running_median(value: Floats, size: int, closed: bool) -> Floats:
    """Running median over `size` neighbours; of medians of small groups where that is many, which needs the memory."""
    from scipy.ndimage import median_filter

    mode = "wrap" if closed else "nearest"
    group = -(-size // MOST_NEIGHBOURS)
    if group == 1:
        out: Floats = median_filter(value, size=size, mode=mode)
        return out
    groups = len(value) // group
    middle = np.median(value[: groups * group].reshape(groups, group), axis=1)
    slow = median_filter(middle, size=size // group | 1, mode=mode)
    at = (np.arange(groups) + 0.5) * group - 0.5
    between: Floats = np.interp(np.arange(len(value)), at, slow, period=len(value) if closed else None)
    return between


def _place(deviation: Deviation, row: int) -> str:
    x, y = deviation.foot[row]
    return f"X{x:.3f} Y{y:.3f}"


def point_to_point(value: Floats) -> float:
    """Standard deviation in mm of values in order, from second differences: what is smooth drops out."""
    if len(value) < 5:
        return 0.0
    second = value[1:-1] - 0.5 * (value[:-2] + value[2:])
    return float(1.482602 * np.median(np.abs(second)) / np.sqrt(1.5))
