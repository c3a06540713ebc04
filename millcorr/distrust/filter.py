# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a filter made of the deviations: a determined part that no measured point bears out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.deviation import Deviation

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


def examine_determined(
    deviation: Deviation, machine: Floats, determined: Floats, trust: Floats | None
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

    Returns
    -------
    tuple of Finding
        At most one, with the worst stretch.

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
    if worst is None:
        return ()
    text = (
        f"{worst[1]}: a chip under the probe, or a filter too coarse or too fine for these points; leave such points "
        "out, measure there again, or take another --filter"
    )
    return (Finding("overshoot", text, True),)


def _place(deviation: Deviation, row: int) -> str:
    x, y = deviation.foot[row]
    return f"X{x:.3f} Y{y:.3f}"


def point_to_point(value: Floats) -> float:
    """Standard deviation in mm of values in order, from second differences: what is smooth drops out."""
    if len(value) < 5:
        return 0.0
    second = value[1:-1] - 0.5 * (value[:-2] + value[2:])
    return float(1.482602 * np.median(np.abs(second)) / np.sqrt(1.5))
