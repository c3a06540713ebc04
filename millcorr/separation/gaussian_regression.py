# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaussian regression along a line: local straight lines under the weighting function of ISO 16610-21."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Floats, Ints

ALPHA = math.sqrt(math.log(2.0) / math.pi)
"""The constant that puts 50 % transmission at the cutoff (ISO 16610-21, clause 4.2)."""

# The sums over all pairs of points are taken with the fast Gauss transform: the points fall into boxes, the
# Gaussian is expanded around the box centres, and a box sees only those within REACH. Lengths are in units
# of the width w of exp(-(x/w)^2). With boxes of 0.25 the expansion of 14 terms errs by less than 2e-12 of
# the largest weight, and what lies beyond 5.25 weighs 1e-12.
_BOX = 0.25
_TERMS = 14
_REACH = 5.25
_BOXES_AT_ONCE = 1 << 15
_POINTS_AT_ONCE = 1 << 17


@dataclass(frozen=True, eq=False, slots=True)
class LocalLine:
    """The fitted values and what the linear operator says about them.

    Attributes
    ----------
    values : ndarray, shape (n,)
        Ordinates of the local lines at the points, in the unit of the values.
    own_weight : ndarray, shape (n,)
        Weight of every point in its own result (the diagonal of the operator).
    squared_weights : ndarray, shape (n,)
        Sum of the squared weights behind every result: variance of the result for unit white noise.
    """

    values: Floats
    own_weight: Floats
    squared_weights: Floats


def local_line(
    s: Floats, d: Floats, weights: Floats, *, cutoff: float, length: float, closed: bool, figures: bool = True
) -> LocalLine:
    """Fit at every point a straight line under the Gaussian weighting function and take its ordinate.

    Parameters
    ----------
    s : ndarray, shape (n,)
        Arc length in mm, ascending; on a closed contour within [0, length).
    d : ndarray, shape (n,)
        Values.
    weights : ndarray, shape (n,)
        Weight of every point, not negative: the arc length it represents, times its trust.
    cutoff : float
        Nesting index in mm: a sine of this wavelength is returned with 50 % of its amplitude.
    length : float
        Length of the stretch in mm; the period of a closed contour.
    closed : bool
        Whether the line wraps round.
    figures : bool
        Whether the operator's figures are wanted; else they are empty.

    Returns
    -------
    LocalLine
        Where only one place carries weight, the line is a constant.

    Notes
    -----
    On an evenly measured closed contour the line's slope does not enter by symmetry, and the result is the
    closed-profile filter of ISO 16610-21; at open ends it is the first-moment form of ISO 16610-28 (the
    regression of ISO 16610-31 with p = 1), which leaves a straight line as it is.
    """
    # Beyond these the operator has become the mean, or one straight line: exp(-pi (8 alpha)^2) = 1e-19.
    widest = 8.0 * length if closed else 100.0 * max(float(np.ptp(s)), 1e-300)
    width = min(cutoff, widest) * ALPHA / math.sqrt(math.pi)
    scale = float(np.max(weights))
    w = weights / scale
    # With u = s_j - s_i in units of the width: G' = 2 sum(w u g), G'' = sum(w (4 u^2 - 2) g).
    g, gd = _gauss_sums(s / width, (w, w * d), length / width if closed else None)
    s0, s1, s2 = g[0], g[1] / 2.0, (g[2] + 2.0 * g[0]) / 4.0
    t0, t1 = gd[0], gd[1] / 2.0
    determinant = s0 * s2 - s1 * s1
    line = determinant > 1e-8 * s0 * s0
    # One place alone in the window carries no slope: the order falls to zero there.
    s1 = np.where(line, s1, 0.0)
    s2 = np.where(line, s2, 1.0)
    determinant = np.where(line, determinant, s0)
    values = (s2 * t0 - s1 * t1) / determinant
    if not figures:
        return LocalLine(values, np.empty(0), np.empty(0))
    squares = _squared_sums(s / width, w * w, s1, s2, length / width if closed else None) / determinant**2
    own = w * s2 / determinant
    if closed:
        images = np.arange(1, int(_REACH * width / length) + 1) * (length / width)
        own = own * (1.0 + 2.0 * float(np.sum(np.exp(-(images**2)))))
    return LocalLine(values, own, np.maximum(squares, 0.0))


def local_line_on_grid(
    s: Floats, d: Floats, weights: Floats, *, cutoff: float, length: float, closed: bool, figures: bool = True
) -> LocalLine | None:
    """Fit the lines of `local_line` to a thousandth of the scatter of the points, many times as fast.

    Parameters
    ----------
    s, d, weights, cutoff, length, closed, figures
        As for `local_line`.

    Returns
    -------
    LocalLine or None
        None where a grid of a quarter of the weighting function's width would be no gain, or too coarse: with
        more cells than points, with more empty cells than others, or with fewer cells than the function reaches.

    Notes
    -----
    The points enter by their moments up to the second about the grid's centres; the local lines are fitted
    there and interpolated by cubics.
    """
    from scipy.fft import next_fast_len

    width = cutoff * ALPHA / math.sqrt(math.pi)
    origin = 0.0 if closed else float(s[0])
    cells = math.ceil((length if closed else float(s[-1]) - origin) / (_BOX * width))
    if cells > s.size or cells < 2 * (math.ceil(_REACH / _BOX) + 1) + 4:
        return None
    if closed:
        cells = int(next_fast_len(cells, real=True))
    step = length / cells if closed else _BOX * width
    place = (s - origin) / step
    cell = np.minimum(place.astype(np.int64), cells - 1)
    if 2 * np.count_nonzero(np.bincount(cell)) < cells:
        return None
    y = (place - cell - 0.5) * (step / width)
    w = weights / float(np.max(weights))
    (s0, s1, s2), (t0, t1, _) = _grid_sums(cell, y, (w, w * d), cells, step / width, closed)
    determinant = s0 * s2 - s1 * s1
    some = s0 > 1e-9
    line = some & (determinant > 1e-2 * s0 * s0)
    s0 = np.where(some, s0, 1.0)
    s1 = np.where(line, s1, 0.0)
    s2 = np.where(line, s2, 1.0)
    determinant = np.where(line, determinant, s0)
    values = _interpolated((s2 * t0 - s1 * t1) / determinant, place - 0.5, closed)
    if not figures:
        return LocalLine(values, np.empty(0), np.empty(0))
    own = w * _interpolated(s2 / determinant, place - 0.5, closed)
    # g^2 is g in units shorter by sqrt(2).
    root = math.sqrt(2.0)
    ((r0, r1, r2),) = _grid_sums(cell, y * root, (w * w,), cells, step / width * root, closed)
    squares = (s2 * s2 * r0 - 2.0 * s1 * s2 * r1 / root + s1 * s1 * r2 / 2.0) / determinant**2
    return LocalLine(values, own, np.maximum(_interpolated(squares, place - 0.5, closed), 0.0))


def _grid_sums(
    cell: Ints, y: Floats, charges: tuple[Floats, ...], cells: int, step: float, closed: bool
) -> list[tuple[Floats, Floats, Floats]]:
    """Sum charge * u^p exp(-u^2) for p = 0, 1, 2 at the centres of the cells; u from centre to point.

    The points lie at y from the centre of their cell; all lengths in units of the width.
    """
    from scipy.fft import irfft, next_fast_len, rfft

    reach = math.ceil(_REACH / step) + 1
    size = cells if closed else int(next_fast_len(cells + reach, real=True))
    # Taps in the order of a circular convolution: how far the centre lies ahead of the point's cell.
    lag = np.arange(-reach, reach + 1)
    x = lag * step
    g = np.exp(-x * x)
    # With u = y - x: Taylor's series of u^p exp(-u^2) in y.
    series = (
        (g, 2.0 * x * g, (4.0 * x**2 - 2.0) * g),
        (-x * g, (1.0 - 2.0 * x**2) * g, (6.0 * x - 4.0 * x**3) * g),
        (x**2 * g, (2.0 * x**3 - 2.0 * x) * g, (4.0 * x**4 - 10.0 * x**2 + 2.0) * g),
    )
    taps = [[rfft(np.bincount(lag % size, weights=kernel, minlength=size)) for kernel in row] for row in series]
    results = []
    for charge in charges:
        moments = (charge, charge * y, 0.5 * charge * y * y)
        spectra = [rfft(np.bincount(cell, weights=moment, minlength=size)) for moment in moments]
        sums = [
            irfft(sum(tap * spectrum for tap, spectrum in zip(row, spectra, strict=True)), size)[:cells] for row in taps
        ]
        results.append((sums[0], sums[1], sums[2]))
    return results


def _interpolated(values: Floats, place: Floats, closed: bool) -> Floats:
    """Cubic through the four values around every place; at open ends the last four."""
    n = values.size
    first = np.floor(place).astype(np.int64)
    if not closed:
        first = np.clip(first, 1, n - 3)
    x = place - first
    below, above = x + 1.0, x - 2.0
    middle = x - 1.0
    result: Floats = (
        -x * middle * above / 6.0 * values[(first - 1) % n]
        + below * middle * above / 2.0 * values[first % n]
        - below * x * above / 2.0 * values[(first + 1) % n]
        + below * x * middle / 6.0 * values[(first + 2) % n]
    )
    return result


def _squared_sums(t: Floats, charge: Floats, s1: Floats, s2: Floats, period: float | None) -> Floats:
    """Sum charge * (sum over the images of (s2 - s1 u) exp(-u^2))^2 over the points."""

    def moments(t: Floats, charge: Floats) -> Floats:
        # g^2 = exp(-2 u^2): the same sums in units shorter by sqrt(2).
        root = math.sqrt(2.0)
        (h,) = _gauss_sums(t * root, (charge,), None if period is None else period * root)
        return np.stack((h[0], h[1] / (2.0 * root), (h[2] + 2.0 * h[0]) / 8.0))

    def combine(r: Floats) -> Floats:
        total: Floats = s2 * s2 * r[0] - 2.0 * s1 * s2 * r[1] + s1 * s1 * r[2]
        return total

    r = moments(t, charge)
    if period is None or period > 2.0 * _REACH:
        return combine(r)
    # The weighting function meets its own images. Two images k periods apart multiply to the square of one
    # in the middle between them: exp(-k^2 period^2 / 2) g(v)^2 ((s2 - s1 v)^2 - (s1 k period / 2)^2).
    # For odd k the middle lies half a period off: there the same points are looked at from across.
    shifted = np.concatenate((t, np.mod(t + 0.5 * period, period)))
    order = np.argsort(shifted, kind="stable")
    across = np.empty((3, shifted.size))
    across[:, order] = moments(shifted[order], np.concatenate((charge, np.zeros_like(charge)))[order])
    total = np.zeros_like(t)
    k_max = int(2.0 * _REACH / period) + 1
    for k in range(-k_max, k_max + 1):
        q = across[:, t.size :] if k % 2 else r
        total += math.exp(-0.5 * (k * period) ** 2) * (combine(q) - (0.5 * k * period * s1) ** 2 * q[0])
    return total


def _gauss_sums(t: Floats, charges: tuple[Floats, ...], period: float | None) -> list[Floats]:
    """Sum charge * exp(-(t_i - t_j)^2) over j, with its first and second derivative by t_i.

    Returns one array of shape (3, n) per charge.
    """
    progress.step()
    n = t.size
    if period is None or period > 2.0 * _REACH:
        ahead = t if period is None else np.concatenate((t, t + period))
        window = int(np.max(np.searchsorted(ahead, t + _REACH) - np.arange(n))) - 1
        boxes = 1 + int(np.count_nonzero(np.diff(np.floor(t / _BOX))))
        # Measured: a step of the window costs 0.04 us a point, a box 8 us, the polynomials 0.6 us a point.
        if window < 15 + 200 * boxes / n and window < n:
            return _windowed_sums(t, charges, period, window)
    return _transformed_sums(t, charges, period)


def _windowed_sums(t: Floats, charges: tuple[Floats, ...], period: float | None, window: int) -> list[Floats]:
    """Take the sums pair by pair, all points at once for the 1st, 2nd, ... neighbour."""
    results = [np.stack((charge, np.zeros_like(t), -2.0 * charge)) for charge in charges]
    for lag in range(1, window + 1):
        progress.step()
        if period is None:
            here, there = slice(0, t.size - lag), slice(lag, t.size)
            u = t[there] - t[here]
            pairs = [(here, there, charge[here], charge[there]) for charge in charges]
        else:
            here = there = slice(None)
            u = np.roll(t, -lag) - t
            u[-lag:] += period
            pairs = [(here, there, charge, np.roll(charge, -lag)) for charge in charges]
        g = np.exp(-u * u)
        slope = 2.0 * u * g
        bend = 2.0 * u * slope - 2.0 * g
        for result, (back, forth, own, other) in zip(results, pairs, strict=True):
            for k, kernel, sign in ((0, g, 1.0), (1, slope, -1.0), (2, bend, 1.0)):
                result[k, back] += other * kernel
                reverse = own * kernel if sign > 0.0 else own * -kernel
                result[k, forth] += reverse if period is None else np.roll(reverse, lag)
    return results


def _transformed_sums(t: Floats, charges: tuple[Floats, ...], period: float | None) -> list[Floats]:
    """Take the sums by the fast Gauss transform (Greengard & Strain 1991) in one dimension.

    Moments about the box centres are moved to Taylor polynomials about the box centres with the derivatives
    of the Gaussian, (-1)^m H_m(x) exp(-x^2).
    """
    n = t.size
    if period is None:
        origin, box_width, boxes_round = float(t[0]), _BOX, 0
    else:
        boxes_round = max(1, math.ceil(period / _BOX))
        origin, box_width = 0.0, period / boxes_round
    box = np.floor((t - origin) / box_width).astype(np.int64)
    if boxes_round:
        box = np.clip(box, 0, boxes_round - 1)
    first = np.flatnonzero(np.diff(box, prepend=box[0] - 1))
    occupied = box[first]
    counts = np.diff(np.append(first, n))
    # y: place within the box
    y = t - origin - (box + 0.5) * box_width
    moments = np.empty((len(charges), occupied.size, _TERMS))
    for c, charge in enumerate(charges):
        term = charge.copy()
        for j in range(_TERMS):
            moments[c, :, j] = np.add.reduceat(term, first)
            term *= y
            term *= -1.0 / (j + 1)
    reach = math.ceil(_REACH / box_width) + 1
    transfers = _transfers(np.arange(-reach, reach + 1) * -box_width)
    results = [np.empty((3, n)) for _ in charges]
    ends = np.append(first[1:], n)
    a = 0
    while a < occupied.size:
        progress.step()
        b = min(a + _BOXES_AT_ONCE, int(np.searchsorted(first, first[a] + _POINTS_AT_ONCE)), occupied.size)
        b = max(b, a + 1)
        local = np.zeros((len(charges), b - a, _TERMS))
        for offset, transfer in zip(range(-reach, reach + 1), transfers, strict=True):
            wanted = occupied[a:b] + offset
            if boxes_round:
                wanted = wanted % boxes_round
            place = np.minimum(np.searchsorted(occupied, wanted), occupied.size - 1)
            hit = occupied[place] == wanted
            if hit.all():
                local += moments[:, place] @ transfer
            elif hit.any():
                local[:, hit] += moments[:, place[hit]] @ transfer
        points = slice(int(first[a]), int(ends[b - 1]))
        x = y[points]
        for c in range(len(charges)):
            results[c][:, points] = _taylor(local[c], np.repeat(np.arange(b - a), counts[a:b]), x)
        a = b
    return results


def _transfers(distances: NDArray[np.floating[Any]]) -> Floats:
    """Matrices that turn the moments of a box into the Taylor terms of another, one per distance."""
    orders = 2 * _TERMS - 1
    derivative = np.empty((orders, distances.size))
    derivative[0] = np.exp(-(distances**2))
    derivative[1] = -2.0 * distances * derivative[0]
    for m in range(2, orders):
        derivative[m] = -2.0 * distances * derivative[m - 1] - 2.0 * (m - 1) * derivative[m - 2]
    j, k = np.indices((_TERMS, _TERMS))
    factorial = np.array([math.factorial(m) for m in range(_TERMS)], dtype=np.float64)
    return np.ascontiguousarray(np.moveaxis(derivative[j + k] / factorial[k][..., None], -1, 0))


def _taylor(terms: Floats, box: Ints, x: Floats) -> Floats:
    """Horner's rule for the polynomials of the boxes and their first two derivatives."""
    value = terms[box, _TERMS - 1]
    slope = np.zeros_like(x)
    bend = np.zeros_like(x)
    for k in range(_TERMS - 2, -1, -1):
        bend *= x
        bend += slope
        slope *= x
        slope += value
        value *= x
        value += terms[box, k]
    return np.stack((value, slope, 2.0 * bend))
