# SPDX-License-Identifier: LGPL-2.1-or-later
"""Standard uncertainty of the determined part along the contour: how well the correction is known at every point.

From one part it comes from the scatter of its points; from several parts from what differs between them, which
needs no assumption about how the scatter of neighbouring points hangs together.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .deviation import Deviation
from .filtering import Separation
from .parts import Parts

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TWO_SIGMA = 0.954499736
"""Probability within two standard deviations of a normal law; what k = 2 stands for."""

ENOUGH = 30.0
"""Degrees of freedom from which a standard deviation is known well enough (to 13 %) to be looked at by itself."""

MOST_NEIGHBOURS = 20
"""Residuals farther apart than so many points are not looked at for correlation."""


def safety_factor(freedom: float) -> float:
    """Factor h on a standard deviation from few values, after which k = 2 covers as it does for many.

    Half of Student's t for the probability of two standard deviations: the safety factor of ISO 14253-2 for
    small samples (7 from two values, 2.3 from three, 1.4 from five, ...).

    Parameters
    ----------
    freedom : float
        Degrees of freedom, at least 1 assumed.

    Returns
    -------
    float
        At least 1.
    """
    from scipy.special import stdtrit

    return float(stdtrit(max(freedom, 1.0), 0.5 + 0.5 * TWO_SIGMA)) / 2.0


def of_one_part(values: Floats, deviation: Deviation, blocks: Sequence[tuple[Ints, Separation]]) -> Floats:
    """Standard uncertainty of the determined part of one part's deviations, from the scatter of its points.

    Parameters
    ----------
    values : (n,) float64
        What was filtered, mm.
    deviation : Deviation
        Where the points lie.
    blocks : sequence of ((k,) int64, Separation)
        Rows of every stretch and level, and what the filter made of them.

    Returns
    -------
    (n,) float64
        ``h sigma sqrt(v f)`` in mm (k = 1): sigma the random part, v the filter's variance at the point, f how
        many points count as one because their residuals are correlated, h the `safety_factor`. NaN where the
        random part is not known.

    Notes
    -----
    What is the same all along this part and another on the next cannot be seen on one part and is not in it.
    """
    out = np.full(len(values), math.nan)
    known = [(rows, part) for rows, part in blocks if math.isfinite(part.random_std)]
    if not known:
        return out
    clumping = [_points_counted_as_one(values, deviation, rows, part) for rows, part in known]
    freedom = np.array(
        [max(1.0, len(rows) * (1 - part.variance_factor) / f) for (rows, part), f in zip(known, clumping, strict=True)]
    )
    variance = np.array([part.random_std**2 for _, part in known])
    pooled, together = float(freedom @ variance / freedom.sum()), float(freedom.sum())
    for (rows, part), f, own, mine in zip(known, clumping, freedom, variance, strict=True):
        # A stretch with few points says little about its own scatter: all of them say it together.
        sigma2, nu = (mine, own) if own >= ENOUGH else (pooled, together)
        out[rows] = safety_factor(nu) * np.sqrt(np.minimum(part.variance * f, 1.0) * sigma2)
    return out


def _points_counted_as_one(values: Floats, deviation: Deviation, rows: Ints, part: Separation) -> float:
    """Sum of the autocorrelation of the residuals up to its first zero, both ways; 1 for independent points."""
    order = rows[np.argsort(deviation.s[rows], kind="stable")]
    residual = np.empty(len(values))
    residual[rows] = (values[rows] - part.determined) * part.weights
    e = residual[order]
    power = float(e @ e)
    if len(e) < 2 * MOST_NEIGHBOURS or power == 0.0:
        return 1.0
    counted = 1.0
    for lag in range(1, MOST_NEIGHBOURS + 1):
        # Chance alone makes 1/sqrt(n) of it: only what is beyond two of these counts.
        correlation = float(e[lag:] @ e[:-lag]) / power
        if correlation < 2.0 / math.sqrt(len(e)):
            break
        counted += 2.0 * correlation
    return counted


def of_several_parts(several: Parts, deviation: Deviation, blocks: Sequence[tuple[Ints, Separation]]) -> Floats:
    """Standard uncertainty of the determined part of the mean of several parts, from their spread.

    Parameters
    ----------
    several : Parts
        The parts at the points of the first.
    deviation : Deviation
        Where the points lie.
    blocks : sequence of ((k,) int64, Separation)
        Rows of every stretch and level, and what the filter made of the mean.

    Returns
    -------
    (n,) float64
        In mm (k = 1); NaN where no place was measured on two parts.

    Notes
    -----
    Every part goes through the very filter that the mean went through (same weights, same knots), so that
    what differs between the results is what the filter lets pass of the spread, whether that is noise from
    point to point, a slow wave, or an offset of a whole part. The variance of an offset of whole parts has
    m - 1 degrees of freedom for m parts; what varies along the contour has more, by the number of independent
    values along it (from the spectrum of the spread), and is pooled over the shortest neighbourhood that has
    thirty. Both are put together after Welch and Satterthwaite (JCGM 100, G.4) and enlarged by `safety_factor`.
    """
    n = len(several.mean)
    count = several.count.astype(np.float64)
    shared = several.count > 1
    if not shared.any():
        return np.full(n, math.nan)
    # Differences from the mean, with the size they would have from the true mean.
    spread = np.nan_to_num(several.values - several.mean) * np.sqrt(count / np.maximum(count - 1.0, 1.0))
    passed, gain = np.empty_like(spread), np.ones(n)
    for rows, part in blocks:
        gain[rows] = part.variance
        for k in range(len(spread)):
            passed[k, rows] = part.smooth(spread[k, rows])
    order = np.lexsort((deviation.s, deviation.contour, deviation.level))
    order = order[shared[order]]
    field = passed[:, order]
    m = float(count[order].mean())
    offset = field.mean(axis=1)
    along = (field - offset[:, None]) / np.sqrt(gain[order])
    alike = float((offset**2).sum()) / m
    varying = (along**2).sum(axis=0) / count[order]
    independent = _independent_values(along, m)
    neighbourhood = min(1.0, ENOUGH / ((m - 1.0) * independent))
    local = np.full(n, float(varying.mean()))
    if neighbourhood < 1.0:
        from scipy.ndimage import uniform_filter1d

        local[order] = uniform_filter1d(varying, max(1, round(neighbourhood * len(order))), mode="reflect")
    local *= gain
    freedom = (m - 1.0) * np.array([1.0, max(1.0, independent * neighbourhood)])
    total = alike + local
    with np.errstate(divide="ignore", invalid="ignore"):
        effective = np.where(total > 0.0, total**2 / (alike**2 / freedom[0] + local**2 / freedom[1]), freedom[1])
    # The factor depends on the degrees of freedom alone: smooth, so a table of it is exact enough (0.1 %).
    table = np.geomspace(max(1.0, float(effective.min())), max(1.0, float(effective.max())) * 1.0001, 200)
    factor = np.interp(effective, table, [safety_factor(nu) for nu in table])
    out: Floats = factor * np.sqrt(total / count)
    return out


def _independent_values(field: Floats, parts: float) -> float:
    """How many independent values a field has along its points, from its spectrum: (sum of power)^2 / sum of squares.

    Of m parts a line of the spectrum has m - 1 degrees of freedom, complex: its square is on average 1 + 1/(m - 1)
    times the square of its mean.
    """
    from scipy.fft import rfft

    if field.shape[1] < 4:
        return 1.0
    power = (np.abs(rfft(field, axis=1)[:, 1:]) ** 2).sum(axis=0)
    squares = float((power**2).sum())
    if squares == 0.0:
        return float(field.shape[1] - 1)
    m = max(parts - 1.0, 1.0)
    squares /= 1.0 + 1.0 / m
    total = max(float(power.sum()) ** 2 - squares / m, squares)
    return min(2.0 * total / squares, float(field.shape[1] - 1))
