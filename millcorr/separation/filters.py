# SPDX-License-Identifier: LGPL-2.1-or-later
"""Split deviations along a profile into a determined part, which repeats, and a random part."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.errors import InputError, UsageError
from millcorr.messages import mm, phrase

from .gaussian_regression import LocalLine, local_line, local_line_on_grid

_LEGAL = phrase("legal filters: none, mean:5, mean:1,2,3,2,1 (odd number of weights), gauss:MM, robust:MM, auto")

# Places nearer than this share of the length are one place: the two ends of a closed contour after rounding.
_SAME_PLACE = 1e-9
_UNEVEN = 2.0
_GAP = 5.0

# ISO 16610-31: c = 4.4478 times the median residual is three standard deviations of a normal law.
_BIWEIGHT = 4.447807
_ROBUST_ROUNDS = 50
_LEAST_TRUST = 1e-6
# From this number of points on the robust regression is taken on a grid.
_MANY = 20_000
_STEADY = 0.8


@dataclass(frozen=True, slots=True)
class Filter:
    """A choice of filter, as written on the command line.

    Attributes
    ----------
    kind : str
        'none', 'mean', 'gauss', 'robust' or 'auto'.
    mask : tuple of float
        Weights of the moving average, odd in number; empty for the others.
    cutoff : float
        Nesting index in mm of 'gauss' and 'robust'; NaN for the others.
    """

    kind: str
    mask: tuple[float, ...] = ()
    cutoff: float = math.nan

    @staticmethod
    def parse(text: str) -> Filter:
        """Read a filter from its text.

        Parameters
        ----------
        text : str
            ``none``, ``auto``, ``mean:N`` (N ones, N odd), ``mean:W,W,W`` (an odd number of weights whose sum
            is not 0), ``gauss:MM`` or ``robust:MM`` (cutoff in mm).

        Returns
        -------
        Filter
            The choice.

        Raises
        ------
        UsageError
            The text is none of these; the message lists the legal forms.
        """
        kind, colon, argument = text.strip().lower().partition(":")
        argument = argument.strip()
        if kind in ("none", "auto") and not colon:
            return Filter(kind)
        if kind not in ("mean", "gauss", "robust") or not argument:
            raise UsageError(phrase("unknown filter '{}'; {}", text, _LEGAL))
        try:
            numbers = tuple(float(part) for part in argument.split(","))
        except ValueError:
            raise UsageError(phrase("filter '{}' holds something that is not a number; {}", text, _LEGAL)) from None
        if not all(math.isfinite(number) for number in numbers):
            raise UsageError(phrase("filter '{}' holds a number that is not finite; {}", text, _LEGAL))
        if kind != "mean":
            if len(numbers) != 1 or numbers[0] <= 0.0:
                raise UsageError(phrase("filter '{}' needs one cutoff in mm above 0; {}", text, _LEGAL))
            return Filter(kind, cutoff=numbers[0])
        if len(numbers) == 1:
            size = numbers[0]
            if size != int(size) or size < 1 or int(size) % 2 == 0 or size > 1_000_001:
                raise UsageError(phrase("filter '{}' needs an odd whole number of points; {}", text, _LEGAL))
            return Filter(kind, mask=(1.0,) * int(size))
        if len(numbers) % 2 == 0:
            raise UsageError(phrase("filter '{}' has an even number of weights; {}", text, _LEGAL))
        if abs(sum(numbers)) <= 1e-12 * sum(abs(number) for number in numbers):
            raise UsageError(phrase("the weights of filter '{}' add up to 0; {}", text, _LEGAL))
        return Filter(kind, mask=numbers)

    @property
    def leaves_out(self) -> bool:
        """Whether points that are more probably wrong than right have no say."""
        return self.kind in ("auto", "robust")

    def __str__(self) -> str:
        if self.kind == "mean":
            if len(set(self.mask)) == 1:
                return f"mean:{len(self.mask)}"
            return "mean:" + ",".join(f"{weight:g}" for weight in self.mask)
        return self.kind if math.isnan(self.cutoff) else f"{self.kind}:{self.cutoff:g}"


@dataclass(frozen=True, eq=False, slots=True)
class Filtered:
    """Deviations split into a determined and a random part.

    Attributes
    ----------
    determined : ndarray, shape (n,)
        Determined part in mm at the points, in the order of the input; read-only.
    random_std : float
        Estimated standard deviation of the random part in mm, with the degrees of freedom the filter leaves;
        NaN when it cannot be known.
    variance_factor : float
        Mean over the points of var(determined) / var(noise) for white noise: q of the correction's error
        balance, 0.2 for a mean of 5 on a closed contour. From the linear operator as it ended; the choice
        that 'auto' makes from the data is not in it. Where 'auto' finds the noise correlated, for such noise.
    description : str
        What was done and which wavelengths come through.
    warnings : tuple of str
        What the user should know about this result.
    weights : ndarray, shape (n,)
        Trust in every point, 0 (outlier, ignored) to 1; read-only.
    variance : ndarray, shape (n,)
        var(determined) / var(noise) at every point, whose mean is `variance_factor`; read-only.
    smooth : callable
        The filter as it ended, with its weights and knots held: values (n,) at the same points to their smoothed
        values (n,). Linear, and leaves a constant as it is.
    """

    determined: Floats
    random_std: float
    variance_factor: float
    description: str
    warnings: tuple[str, ...]
    weights: Floats
    variance: Floats
    smooth: Callable[[Floats], Floats]


@dataclass(frozen=True, eq=False, slots=True)
class Row:
    """The points of one stretch in order along it, coinciding points gathered into places.

    Attributes
    ----------
    order : ndarray of int, shape (n,)
        Input index of every sorted point.
    s, d : ndarray, shape (n,)
        Arc length and value in mm, sorted; values less their mean.
    place : ndarray of int, shape (n,)
        Place of every sorted point.
    place_s, place_d : ndarray, shape (m,)
        Arc length, ascending, and mean value of every place.
    count : ndarray, shape (m,)
        Number of points at every place.
    spacing : ndarray
        Distances between neighbouring places: m of them on a closed contour, else m - 1.
    length : float
        Length of the stretch, or the contour's period.
    closed : bool
        Whether the row wraps round.
    """

    order: Ints
    s: Floats
    d: Floats
    place: Ints
    place_s: Floats
    place_d: Floats
    count: Floats
    spacing: Floats
    length: float
    closed: bool

    @property
    def typical_spacing(self) -> float:
        """Median distance between neighbouring places in mm; NaN for a single place."""
        return float(np.median(self.spacing)) if self.place_s.size > 1 else math.nan


@dataclass(frozen=True, eq=False, slots=True)
class Parts:
    """What a filter hands back: values at the sorted points, its operator and the operator's figures."""

    values: Floats
    random_std: float
    variance: Floats
    smooth: Callable[[Floats], Floats]
    description: str
    warnings: tuple[str, ...] = ()
    weights: Floats | None = None


def filtered(s: ArrayLike, d: ArrayLike, *, length: float, closed: bool, filter: Filter) -> Filtered:
    """Pass the deviations along one smooth stretch through a filter that a drawing or a paper prescribes.

    Parameters
    ----------
    s : array_like, shape (n,)
        Arc length of the points in mm, in any order; coinciding points, uneven spacing and gaps are legal.
    d : array_like, shape (n,)
        Deviations in mm.
    length : float
        Length of the stretch in mm; on a closed contour the period of `s`.
    closed : bool
        Whether the stretch wraps round.
    filter : Filter
        What separates the parts.

    Returns
    -------
    Filtered
        Independent of the order of the points, of where a closed contour starts and of its direction.

    Raises
    ------
    InputError
        There are no points, a number is not finite, the arrays do not match, or the points spread over more
        than the length.

    Notes
    -----
    The moving average is eqs. (4) and (5) of Werner 2018; the Gaussian filters follow ISO 16610-21, -28 and
    -31; 'auto' is no such filter, see `model.separate`. Points at one place count as one point of their mean.
    """
    places = np.asarray(s, dtype=np.float64)
    deviations = np.asarray(d, dtype=np.float64)
    _check(places, deviations, length)
    # Sorted, so that not even its last bit depends on the order: what is robust may turn on it.
    mean = float(np.mean(np.sort(deviations)))
    row = _row(places, deviations - mean, float(length), closed)
    if filter.kind == "none":
        parts = Parts(
            row.d, math.nan, np.ones_like(row.d), _unchanged, "no filter: all of the deviation is taken as determined"
        )
    elif filter.kind == "mean":
        parts = _moving_average(row, filter.mask)
    elif filter.kind == "gauss":
        parts = _gaussian(row, filter.cutoff)
    elif filter.kind == "robust":
        parts = _robust_gaussian(row, filter.cutoff)
    else:
        raise UsageError(phrase("unknown filter '{}'; {}", filter, _LEGAL))
    determined = np.empty_like(deviations)
    determined[row.order] = parts.values + mean
    weights = np.ones_like(deviations)
    if parts.weights is not None:
        weights[row.order] = parts.weights
    variance = np.empty_like(deviations)
    variance[row.order] = parts.variance
    determined.flags.writeable = weights.flags.writeable = variance.flags.writeable = False
    warnings = parts.warnings
    if deviations.size == 1:
        warnings += (phrase("a single point: its deviation is taken as it is, the random part cannot be known"),)

    def smooth(values: Floats) -> Floats:
        out = np.empty(len(row.order))
        out[row.order] = parts.smooth(values[row.order])
        return out

    factor = float(np.mean(parts.variance))
    return Filtered(determined, parts.random_std, factor, parts.description, warnings, weights, variance, smooth)


def _unchanged(values: Floats) -> Floats:
    return values


def _check(s: Floats, d: Floats, length: float) -> None:
    if s.ndim != 1 or s.shape != d.shape:
        raise InputError(phrase("arc lengths and deviations must be equally long rows, not {}, {}", s.shape, d.shape))
    if s.size == 0:
        raise InputError(phrase("there are no deviations to filter"))
    if not (np.isfinite(s).all() and np.isfinite(d).all()):
        raise InputError(phrase("an arc length or a deviation is not a finite number"))
    if not (math.isfinite(length) and length > 0.0):
        raise InputError(phrase("the length of the stretch must be above 0, not {:g}", length))


def _row(s: Floats, d: Floats, length: float, closed: bool) -> Row:
    """Sort the points along the stretch and gather those that coincide."""
    if closed:
        s = np.mod(s, length)
        s = np.where(s >= length, 0.0, s)
    elif np.ptp(s) > length * (1.0 + 1e-6):
        raise InputError(phrase("the points spread over {} of a stretch of {}", mm(np.ptp(s), "g"), mm(length, "g")))
    # Sorting ties by value too makes the sums, to the last bit, independent of the order of the input.
    ascending = bool(np.all(np.diff(s) > 0.0))
    order = np.arange(s.size) if ascending else np.lexsort((d, s))
    s, d = s[order], d[order]
    place = np.cumsum(np.diff(s, prepend=s[0]) > _SAME_PLACE * length, dtype=np.int64)
    if closed and place[-1] > 0 and s[0] + length - s[-1] <= _SAME_PLACE * length:
        place[place == place[-1]] = 0
    count = np.bincount(place).astype(np.float64)
    first = np.flatnonzero(np.diff(place, prepend=-1) > 0)
    place_s = s[first[: count.size]]
    place_d = np.bincount(place, weights=d) / count
    spacing = np.diff(place_s)
    if closed:
        spacing = np.append(spacing, place_s[0] + length - place_s[-1])
    return Row(order, s, d, place, place_s, place_d, count, spacing, length, closed)


def _random_std(residual: Floats, trace: float, squared: float) -> float:
    """Noise level behind the residuals of a linear filter H: E(rss) = sigma^2 tr((I - H)(I - H)')."""
    freedom = residual.size - 2.0 * trace + squared
    if freedom <= 1e-6 * residual.size:
        return math.nan
    return math.sqrt(float(residual @ residual) / freedom)


def _moving_average(row: Row, mask: tuple[float, ...]) -> Parts:
    """Weighted moving average over neighbouring places, eqs. (4) and (5) of Werner 2018."""
    warnings: list[str] = []
    m = row.place_s.size
    f = np.array(mask)
    if row.closed and f.size > m:
        # A mask longer than the contour would count points twice.
        cut = (f.size - (m - 1 + m % 2)) // 2
        f = f[cut : f.size - cut]
        warnings.append(phrase("the mask of {} is longer than the row of {} points: cut to {}", len(mask), m, f.size))
    elif f.size > m:
        warnings.append(phrase("the mask of {} is longer than the row of {} points", f.size, m))
    if not np.array_equal(f, f[::-1]):
        warnings.append(phrase("the mask is not symmetric: it shifts the deviations along the profile"))
    if m > 2 and row.spacing.max() > _UNEVEN * row.typical_spacing:
        warnings.append(
            phrase(
                "the points are unevenly spaced (up to {}, median {}) and the moving average counts points: "
                "prefer gauss:MM or auto",
                mm(row.spacing.max(), ".3g"),
                mm(row.typical_spacing, ".3g"),
            )
        )
    divisor = _correlate(np.ones(m), f, row.closed)
    # At an open end the mask is cut off; where what is left of it sums to 0, eq. (5) has no value.
    void = np.abs(divisor) <= 1e-9 * np.abs(f).sum()
    if void.any():
        warnings.append(phrase("the mask sums to 0 at an end of the row: those points are left unfiltered"))
        divisor = np.where(void, 1.0, divisor)

    def smooth(d: Floats) -> Floats:
        place_d = np.bincount(row.place, weights=d) / row.count
        averaged: Floats = np.where(void, place_d, _correlate(place_d, f, row.closed) / divisor)[row.place]
        return averaged

    variance = np.where(void, 1.0 / row.count, _correlate(1.0 / row.count, f * f, row.closed) / divisor**2)
    own = np.where(void, 1.0, f[f.size // 2] / divisor)
    at_points = smooth(row.d)
    return Parts(
        at_points,
        _random_std(row.d - at_points, float(own.sum()), float(row.count @ variance)),
        variance[row.place],
        smooth,
        f"moving average, mask of {f.size} points{_mask_transmission(f, row)}{_shortest(row)}",
        tuple(warnings),
    )


def _correlate(values: Floats, mask: Floats, closed: bool) -> Floats:
    """Sum of mask[k] * values[i + k]; beyond an open end the values are 0."""
    progress.step()
    half = mask.size // 2
    padded = np.pad(values, half, mode="wrap" if closed else "constant")
    if mask.size <= 64:
        return np.correlate(padded, mask, "valid")
    from scipy.signal import fftconvolve

    summed: Floats = fftconvolve(padded, mask[::-1], "valid")
    return summed


def _mask_transmission(mask: Floats, row: Row) -> str:
    """Words for the longest wavelength of which the mask lets only half through, on even spacing."""
    if row.place_s.size < 2:
        return ""
    k = np.arange(mask.size) - mask.size // 2
    # In steps of a small share of the band that the mask passes.
    frequency = np.linspace(0.0, min(0.5, 8.0 / mask.size), 513)
    used = np.abs(np.exp(2j * np.pi * np.outer(frequency, k)) @ (mask / mask.sum()))
    below = np.flatnonzero(used < 0.5)
    if below.size == 0:
        return ", every wavelength comes through with more than 50 %"
    i = int(below[0])
    share = (used[i - 1] - 0.5) / (used[i - 1] - used[i])
    crossing = frequency[i - 1] + (frequency[i] - frequency[i - 1]) * share
    return f", 50 % transmission at a wavelength of {row.typical_spacing / crossing:.3g} mm"


def _shortest(row: Row) -> str:
    """Words for what no filter can return."""
    if row.place_s.size < 2:
        return ""
    return f"; nothing below {2.0 * row.typical_spacing:.3g} mm, twice the point spacing, can come back"


def _represented_length(row: Row, longest: float) -> Floats:
    """Arc length that every point stands for: half the way to its neighbours, no side above `longest`."""
    if row.place_s.size == 1:
        return np.ones_like(row.s) / row.s.size
    half = np.minimum(0.5 * row.spacing, longest)
    cell = half + np.roll(half, 1) if row.closed else np.append(half, 0.0) + np.append(0.0, half)
    shares: Floats = (cell / row.count)[row.place]
    return shares


def _sampling_warnings(row: Row, cutoff: float) -> tuple[str, ...]:
    warnings: list[str] = []
    if row.place_s.size < 2:
        return ()
    if cutoff < 2.0 * row.typical_spacing:
        warnings.append(
            phrase(
                "the cutoff of {} is below twice the point spacing ({}): next to nothing is filtered",
                mm(cutoff, "g"),
                mm(row.typical_spacing, ".3g"),
            )
        )
    return (*warnings, *_gap_warnings(row, cutoff))


def _gap_warnings(row: Row, wavelength: float) -> tuple[str, ...]:
    """Name the stretches that the points on their sides do not reach across."""
    if row.place_s.size < 2:
        return ()
    gaps = np.flatnonzero(row.spacing > max(_GAP * row.typical_spacing, 0.5 * wavelength))
    if gaps.size == 0:
        return ()
    i = gaps[np.argmax(row.spacing[gaps])]
    return (
        phrase(
            "{} gap(s) without points, the longest {} from s = {}: the deviation there is not known",
            gaps.size,
            mm(row.spacing[i], ".3g"),
            mm(row.place_s[i], ".6g"),
        ),
    )


def _gaussian(row: Row, cutoff: float) -> Parts:
    """Gaussian regression of order 1 in arc length, ISO 16610-21 and -28."""
    # Points more than a quarter of the cutoff apart weigh alike, so that a gap does not blow up its edges.
    weights = _represented_length(row, cutoff / 8.0)
    fit = local_line(row.s, row.d, weights, cutoff=cutoff, length=row.length, closed=row.closed)

    def smooth(d: Floats) -> Floats:
        return local_line(row.s, d, weights, cutoff=cutoff, length=row.length, closed=row.closed, figures=False).values

    return Parts(
        fit.values,
        _random_std(row.d - fit.values, float(fit.own_weight.sum()), float(fit.squared_weights.sum())),
        fit.squared_weights,
        smooth,
        f"Gaussian regression in arc length (ISO 16610-21, {_ends(row)}), 50 % transmission at a wavelength"
        f" of {cutoff:g} mm{_shortest(row)}",
        _sampling_warnings(row, cutoff),
    )


def _robust_gaussian(row: Row, cutoff: float) -> Parts:
    """Robust Gaussian regression of order 1, ISO 16610-31: Tukey's biweight, c from the median residual."""
    lengths = _represented_length(row, cutoff / 8.0)
    trust = np.ones_like(row.d)
    warnings = list(_sampling_warnings(row, cutoff))
    values = np.full_like(row.d, math.inf)
    step = np.zeros_like(row.d)
    for rounds in range(_ROBUST_ROUNDS):
        progress.step()
        before, last = values, step
        # Where a whole window is distrusted the floor brings the plain regression back.
        values = _local_line(row, lengths * np.maximum(trust, _LEAST_TRUST), cutoff, figures=False).values
        step = values - before
        median = float(np.median(np.abs(row.d - values)))
        if float(np.sqrt(np.mean(step**2))) <= 1e-3 * median:
            break
        if rounds >= 3 and rounds % 3 == 0 and row.s.size >= _MANY:
            # The rounds close in on the limit by a nearly constant ratio: take the rest of the way at once.
            ratio = min(max(float(step @ last) / float(last @ last), 0.0), _STEADY)
            values = values + ratio / (1.0 - ratio) * step
        size = np.abs(row.d - values)
        if median <= 1e-12 * float(np.max(np.abs(row.d))):
            # More than half of the points lie on the line: whatever does not is an outlier.
            median = 1e-12 * float(np.max(np.abs(row.d)))
            if median == 0.0:
                break
        trust = np.clip(1.0 - (size / (_BIWEIGHT * median)) ** 2, 0.0, 1.0) ** 2
    else:
        warnings.append(phrase("the robust regression did not settle within {} rounds", _ROBUST_ROUNDS))
    weights = lengths * np.maximum(trust, _LEAST_TRUST)
    fit = _local_line(row, weights, cutoff, figures=True)

    def smooth(d: Floats) -> Floats:
        return _local_line(replace(row, d=d), weights, cutoff, figures=False).values

    squared = float(fit.squared_weights.sum())
    freedom = row.d.size - 2.0 * float(fit.own_weight.sum()) + squared
    share = freedom / row.d.size
    std = _biweight_std(row.d - fit.values) / math.sqrt(share) if share > 1e-6 else math.nan
    outliers = int(np.count_nonzero(trust < 1e-3))
    if outliers:
        warnings.append(phrase("points far off the line, which are outliers and left out: {}", outliers))
    return Parts(
        fit.values,
        std,
        fit.squared_weights,
        smooth,
        f"robust Gaussian regression in arc length (ISO 16610-31, order 1, {_ends(row)}), 50 % transmission"
        f" at a wavelength of {cutoff:g} mm{_shortest(row)}",
        tuple(warnings),
        trust,
    )


def _local_line(row: Row, weights: Floats, cutoff: float, *, figures: bool) -> LocalLine:
    """Gaussian regression, of many points on a grid: the trust in them is no more exact than that."""
    progress.step()
    fit = None
    if row.s.size >= _MANY:
        fit = local_line_on_grid(
            row.s, row.d, weights, cutoff=cutoff, length=row.length, closed=row.closed, figures=figures
        )
    if fit is None:
        fit = local_line(row.s, row.d, weights, cutoff=cutoff, length=row.length, closed=row.closed, figures=figures)
    return fit


def _biweight_std(residual: Floats) -> float:
    """Standard deviation that outliers do not move: biweight midvariance (Mosteller & Tukey 1977)."""
    median = float(np.median(np.abs(residual)))
    if median == 0.0:
        return 0.0
    u = np.minimum((residual / (9.0 * median)) ** 2, 1.0)
    spread = float(np.sum(residual**2 * (1.0 - u) ** 4))
    slope = float(np.sum((1.0 - u) * (1.0 - 5.0 * u)))
    return math.sqrt(residual.size * spread) / abs(slope)


def _ends(row: Row) -> str:
    return "closed profile" if row.closed else "linear regression at the open ends per ISO 16610-28"
