# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline regression along a line that takes as many knots as the data can prove, and no more."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .bspline_basis import BandedFactor, Basis
from .spatial_correlation import Moran, moran_test, neighbour_links

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

# Neighbours on either side that Moran's I looks at, and the one-sided 5 % point of the normal law.
_REACH = 2
_SIGNIFICANT = 1.6448536269514722
# No knot spacing below this many places: finer detail cannot be told from noise.
PLACES_PER_KNOT = 3
"""Fewest places to a knot."""
# More places than this are averaged in groups for the search; the knots stay far coarser than a group.
MOST_NODES = 3000
"""Most groups that are fitted."""
_GAP = 5.0
# A remainder below this share of the deviations' spread is none.
_NOTHING_LEFT = 1e-3
# What an information criterion must gain before a correlation of the residuals is put down to chance.
_CHANCE = 6.0
_ROUNDS = 5
# Candidates up to this number lie a tenth apart, beyond it a quarter.
_FINE_STEPS = 64
# The coarsest groups Moran's I is judged on are this many; every parameter takes three of them at least.
_COARSEST = 32
_GROUPS_PER_PARAMETER = 3
# Correlated noise is suspected where the finer search takes this many times, and this many more, parameters.
_DISPUTED_RATIO = 2.0
_DISPUTED_LEAST = 12
# What noise does not do: a value so far above the usual extreme (in deviations), a spectrum whose logarithm is
# so far below its usual mean (in deviations of the mean), a line so strong (chance of one in noise).
_EXTREME = 2.0
_UNLIKELY = 3.0
_HIDDEN_LINE = 0.02


@dataclass(frozen=True, eq=False, slots=True)
class SplineRegression:
    """The regression that was chosen.

    Attributes
    ----------
    values : ndarray, shape (n,)
        Fitted values at the points.
    weights : ndarray, shape (n,)
        Trust in every point, 0 to 1.
    parameters : int
        Number of free parameters: 1 is a constant, on an open line 2 and 3 are polynomials.
    random_std : float
        Standard deviation of the random part: of the residuals with n - parameters degrees of freedom (NaN
        where there are none); with correlated noise, what the fit takes out of it is added.
    variance : ndarray, shape (n,)
        Variance of the fit at the points for noise of unit variance: white, or as correlated as found.
    smooth : callable
        The regression with its knots and weights held: other values (n,) at the points to fitted ones.
    knot_spacing : float
        Mean distance between knots in mm.
    moran : Moran
        Test of the residuals.
    settled : bool
        Whether the residuals showed no more correlation, at the scale they were judged at.
    correlation_length: float
        Length in mm over which noise that was found correlated counts as one independent value; NaN where the
        noise was not found correlated.
    fits : int
        Number of regressions made, at most a few hundred whatever the data.
    """

    values: Floats
    weights: Floats
    parameters: int
    random_std: float
    variance: Floats
    smooth: Callable[[Floats], Floats]
    knot_spacing: float
    moran: Moran
    settled: bool
    correlation_length: float
    fits: int


@dataclass(frozen=True, eq=False, slots=True)
class _Line:
    """Places along the line in the regression's own coordinate t, and the node every place belongs to."""

    t: Floats
    rank: Floats
    node: Ints
    node_t: Floats
    node_rank: Floats
    period: float | None

    @property
    def nodes(self) -> int:
        return self.node_t.size


@dataclass(frozen=True, eq=False, slots=True)
class _Fit:
    parameters: int
    basis: Basis
    coefficients: Floats
    factor: BandedFactor
    moran: Moran
    criterion: float
    passed: bool
    density: float


@dataclass(frozen=True, eq=False, slots=True)
class _Sample:
    """What is fitted: mean values at the nodes that have points, roots of their weights, and their links."""

    line: _Line
    t: Floats
    mean: Floats
    root: Floats
    links: Any
    floor: float


@dataclass(frozen=True, eq=False, slots=True)
class _Choice:
    """A fit, the line of its nodes, whether the noise was found correlated, and the most parameters allowed."""

    line: _Line
    fit: _Fit
    correlated: bool
    most: float


def spline_regression(
    d: Floats, place: Ints, place_s: Floats, *, period: float | None, noise_floor: float
) -> SplineRegression:
    """Regress the values on a cubic B-spline with the number of knots that leaves no correlated residuals.

    Parameters
    ----------
    d : ndarray, shape (n,)
        Values at the points, along the line.
    place : ndarray of int, shape (n,)
        Place of every point.
    place_s : ndarray, shape (m,)
        Arc length of the places in mm, strictly ascending.
    period : float or None
        Length in mm of a closed contour, within which the places lie.
    noise_floor : float
        Residuals not above this are rounding.

    Returns
    -------
    SplineRegression
        The chosen regression.

    Notes
    -----
    On dense points neighbours may be correlated although nothing there is determined: the process, or a
    scanning probe, has a short memory. So the search is repeated on coarser groups of points, from 32 groups
    up. Where groups pass with no more than half of the parameters, what the finer search adds to them is looked at: if
    it is spread over all places and its spectrum does not rise towards short wavelengths nor hold single
    lines, it is noise of short correlation length, and the coarser regression is taken. Its density at long
    wavelengths then stands for the noise in `variance`.

    Knots stand at equal distances where the points do; where the points are uneven, closer among close points
    and never with an empty span. Their number grows until Moran's I of
    the residuals, with its exact moments for regression residuals, is not significant at the one-sided 5 %
    level (Poniatowska & Werner). A single test misses a weak remainder now and then: up to half as many knots
    again are tried, and of those that pass the one with the smallest corrected Akaike criterion (AICc) is
    taken. One test in twenty rejects pure chance, which more knots do not cure: a regression that does not
    pass is preferred where its AICc is better by more than 6, and `settled` says so. On a closed contour the
    first knot stands where the first harmonic of the values peaks, so the starting point of the arc length
    does not matter.

    Points far from the line are outliers: full trust up to 3.5 standard deviations, falling to none at 6 as
    Tukey's biweight does. The first guess comes from a running median of seven, which only isolated points
    deviate from: a short but real error is not mistaken for outliers.
    """
    spread = float(np.std(d))
    floor = max(noise_floor, _NOTHING_LEFT * spread)
    line = _line(d, place, place_s, period)
    robust = d.size >= 8
    trust = _first_trust(d, period is not None, noise_floor) if robust else np.ones_like(d)
    choice, fits = _choose(line, d, place, trust, floor)
    for rounds in range(_ROUNDS):
        if rounds:
            choice, made = _renew(choice, d, place, trust, floor)
            fits += made
        fit = choice.fit
        values = fit.basis.evaluate(fit.coefficients, line.t)[place]
        if not robust:
            break
        residual = d - values
        freedom = max(1.0, d.size - fit.parameters)
        deviation = 1.482602 * float(np.median(np.abs(residual))) * math.sqrt(d.size / freedom)
        renewed = _trust(residual, max(deviation, noise_floor))
        if np.max(np.abs(renewed - trust)) < 1e-2:
            break
        trust = renewed
    residual = d - values
    freedom = float(trust.sum()) - fit.parameters
    std = math.sqrt(float(trust @ residual**2) / freedom) if freedom > 1e-6 * d.size else math.nan
    length = period if period is not None else float(place_s[-1] - place_s[0])
    variance = _variance(choice.line, fit, place, trust)
    final = trust
    correlation = math.nan
    if choice.correlated:
        # A parameter takes the density of the noise at long wavelengths out of the residuals, not its variance.
        std = math.sqrt((float(trust @ residual**2) + fit.parameters * fit.density) / float(trust.sum()))
        share = fit.density / std**2
        variance *= share
        correlation = share * length / d.size
    spans = fit.parameters if period is not None else max(1, fit.parameters - 3)
    return SplineRegression(
        values,
        trust,
        fit.parameters,
        std,
        variance,
        lambda other: _refitted(choice.line, choice.fit, place, final, other),
        length / spans,
        fit.moran,
        fit.passed,
        correlation,
        fits,
    )


def _renew(choice: _Choice, d: Floats, place: Ints, trust: Floats, floor: float) -> tuple[_Choice, int]:
    """Search the surroundings of a choice again, with other trust in the points."""
    sample = _sample(choice.line, d, place, trust, floor)
    fit, fits = _search(sample, choice.fit.parameters / 1.5, choice.most)
    return _settle(sample, fit, fits, choice.correlated, choice.most)


def _choose(line: _Line, d: Floats, place: Ints, trust: Floats, floor: float) -> tuple[_Choice, int]:
    """Take what the finest groups prove, unless what they prove beyond coarser groups looks like noise."""
    sample = _sample(line, d, place, trust, floor)
    fine, fits = _search(sample)
    groups = _COARSEST
    # A coarse fit takes at most half of the parameters, and every one of them has its groups.
    useful = min(line.nodes / 2.0, _GROUPS_PER_PARAMETER * fine.parameters) if fine.density > 0.0 else 0.0
    while groups <= useful and fine.parameters > _DISPUTED_LEAST:
        most = groups / _GROUPS_PER_PARAMETER
        coarse_line = _gathered(line.t, line.rank, line.period, groups)
        coarse_sample = _sample(coarse_line, d, place, trust, floor)
        coarse, made = _search(coarse_sample, most=most)
        fits += made
        k = coarse.parameters
        apart = max(_DISPUTED_RATIO * k, k + _DISPUTED_LEAST) <= fine.parameters
        if coarse.passed and apart and _evenly_spread(line, fine, coarse):
            return _Choice(coarse_line, coarse, True, most), fits
        groups = round(1.4 * groups)
    return _settle(sample, fine, fits, False, math.inf)


def _settle(sample: _Sample, fit: _Fit, fits: int, correlated: bool, most: float) -> tuple[_Choice, int]:
    """Make the choice; a fit that did not pass is tested once more, with the exact moments."""
    if not fit.passed:
        fit, fits = _fit(sample, fit.parameters, enough=math.inf), fits + 1
    return _Choice(sample.line, fit, correlated, most), fits


def _evenly_spread(line: _Line, fine: _Fit, coarse: _Fit) -> bool:
    """Whether what the fine fit adds is spread over places and wavelengths as noise is.

    Noise of a short correlation length has a spectrum that is flat at long wavelengths and falls at short
    ones. A determined part sticks out of any such spectrum by a few lines, or stands at few places.
    """
    from scipy.fft import dct, rfft

    n = 4 * fine.parameters
    end = line.period if line.period is not None else float(line.t[-1])
    t = np.linspace(0.5 / n, 1.0 - 0.5 / n, n) * end
    added = fine.basis.evaluate(fine.coefficients, t) - coarse.basis.evaluate(coarse.coefficients, t)
    size = np.abs(added)
    extremes = math.sqrt(2.0 * math.log(2.0 * (fine.parameters - coarse.parameters)))
    if size.max() > (extremes + _EXTREME) * 1.482602 * float(np.median(size)):
        return False
    # Both spectra by the number of parameters that a wavelength takes.
    if line.period is not None:
        power, dof = np.abs(rfft(added)) ** 2, 2.0
    else:
        power, dof = dct(added) ** 2, 1.0
    first, last = math.ceil((coarse.parameters + 1) / dof), math.ceil(fine.parameters / dof)
    power = power[first : last + 1]
    if power.size < 4 or power.min() <= 0.0:
        return False
    relative = power / _falling(power)
    # Of a chi-squared law of 2 (of 1) degrees of freedom and mean 1: mean and deviation of the logarithm.
    mean, deviation = (-0.577216, 1.282550) if dof == 2.0 else (-1.270363, 2.221441)
    if float(np.mean(np.log(relative))) < mean - _UNLIKELY * deviation / math.sqrt(power.size):
        return False
    # Fisher's test for a hidden line, exact for a flat spectrum of 2 degrees of freedom a line.
    n = power.size
    limit = n * (1.0 - (_HIDDEN_LINE / n) ** (1.0 / (n - 1)))
    return bool(relative.max() <= limit * 2.0 / dof)


def _falling(power: Floats) -> Floats:
    """Spectrum that does not rise towards short wavelengths: means over narrow bands, the risers pooled."""
    blocks: list[tuple[float, int]] = []
    a = 0
    while a < power.size:
        b = max(a + 6, math.ceil(1.15 * a))
        b = power.size if b + 6 > power.size else b
        total, size = float(power[a:b].sum()), b - a
        while blocks and blocks[-1][0] * size < total * blocks[-1][1]:
            before = blocks.pop()
            total, size = total + before[0], size + before[1]
        blocks.append((total, size))
        a = b
    return np.concatenate([np.full(size, total / size) for total, size in blocks])


def _line(d: Floats, place: Ints, place_s: Floats, period: float | None) -> _Line:
    """Choose the origin of a closed contour and gather very many places into nodes."""
    m = place_s.size
    rank = np.arange(m, dtype=np.float64)
    if period is None:
        t = place_s - place_s[0]
    else:
        mean = np.bincount(place, weights=d) / np.bincount(place)
        peak = float(np.angle(np.sum(mean * np.exp(2j * np.pi * rank / m)))) * m / (2.0 * np.pi)
        origin = np.interp(peak % m, np.arange(m + 1), np.append(place_s, place_s[0] + period))
        rank = np.mod(rank - peak, m)
        t = np.mod(place_s - origin, period)
        # Rounding may put a place at the origin on either side: rank and t must agree about which.
        t = np.where((rank < 1e-3) & (t > 0.75 * period), 0.0, t)
        t = np.where((rank > m - 1e-3) & (t < 0.25 * period), math.nextafter(period, 0.0), t)
        t = np.where(t >= period, math.nextafter(period, 0.0), t)
    return _gathered(t, rank, period, min(m, MOST_NODES))


def _gathered(t: Floats, rank: Floats, period: float | None, nodes: int) -> _Line:
    """Gather the places in nodes of equally many, alike from either end."""
    m = t.size
    if m <= nodes:
        node = np.argsort(np.argsort(rank, kind="stable"), kind="stable").astype(np.int64)
    else:
        x = (rank + (0.5 if period is None else 0.0)) * (nodes / m)
        node = np.where(x < 0.5 * nodes, np.floor(x + 1e-9), np.ceil(x - 1e-9) - 1.0).astype(np.int64)
        node = np.clip(node, 0, nodes - 1)
    size = np.bincount(node, minlength=nodes)
    node_t = np.bincount(node, weights=t, minlength=nodes) / size
    node_rank = np.bincount(node, weights=rank, minlength=nodes) / size * (nodes / m)
    return _Line(t, rank, node, node_t, node_rank, period)


def _basis(line: _Line, parameters: int) -> Basis:
    n = line.nodes
    if line.period is None:
        degree = min(3, parameters - 1)
        end = float(line.t[-1])
        measure = np.append(0.0, np.cumsum(_measure(np.diff(line.node_t), parameters)))
        shares = np.arange(1, parameters - degree) / (parameters - degree)
        inner = np.interp(shares * measure[-1], measure, line.node_t)
        knots = np.concatenate((np.zeros(degree + 1), inner, np.full(degree + 1, end if end > 0.0 else 1.0)))
        return Basis(knots, degree, parameters, False)
    period = line.period
    ranks = np.concatenate(([line.node_rank[-1] - n], line.node_rank, [line.node_rank[0] + n]))
    t = np.concatenate(([line.node_t[-1] - period], line.node_t, [line.node_t[0] + period]))
    steps = _measure(np.diff(t[1:]), parameters)
    measure = np.cumsum(np.concatenate(([-steps[-1], steps[-1]], steps)))
    start = np.interp(0.0, ranks, measure)
    inner = np.interp(start + np.arange(parameters) * (measure[-1] / parameters), measure, t)
    inner[0] = 0.0
    around = np.arange(-3, parameters + 4)
    return Basis(inner[around % parameters] + period * (around // parameters), 3, parameters, True)


def _measure(step: Floats, parameters: int) -> Floats:
    """What every step between nodes counts for when the knots are spread out.

    Between equal length, which leaves spans empty where points are rare, and equal number of points, which
    spends the knots where points are dense: the root of the step, at most three times its mean, and the
    nearer the knots come to three nodes each, the more the number alone.
    """
    if step.size == 0:
        return step
    share = np.sqrt(step)
    for _ in range(5):
        share = np.minimum(share / np.mean(share), 3.0)
    crowding = min(1.0, parameters * PLACES_PER_KNOT / (step.size + 1.0))
    measure: Floats = crowding + (1.0 - crowding) * share
    return measure


def _candidates(nodes: int, closed: bool) -> list[int]:
    """Numbers of parameters to try: one by one, then in steps of a tenth, from 64 on of a quarter."""
    most = nodes // PLACES_PER_KNOT
    if not closed and nodes >= 4:
        most = max(most, 2)
    numbers = [1]
    while True:
        step = 1.1 if numbers[-1] < _FINE_STEPS else 1.25
        following = max(numbers[-1] + 1, math.ceil(step * numbers[-1]))
        # Two knots round a contour make a wave of one phase only.
        following = 3 if closed and following == 2 else following
        if following > most:
            return numbers
        numbers.append(following)


def _sample(line: _Line, d: Floats, place: Ints, trust: Floats, floor: float) -> _Sample:
    """Take the means of the points at every node, and link the nodes that are neighbours."""
    node = line.node[place]
    n = line.nodes
    weight = np.bincount(node, weights=trust, minlength=n)
    used = weight > 1e-3
    mean = np.bincount(node, weights=trust * d, minlength=n) / np.where(used, weight, 1.0)
    t = line.node_t[used]
    step = np.diff(t) if line.period is None else np.append(np.diff(t), t[0] + line.period - t[-1])
    links = neighbour_links(t.size, _joined(step, line.period is not None), _REACH)
    return _Sample(line, t, mean[used], np.sqrt(weight[used]), links, floor)


def _search(sample: _Sample, fewest: float = 1.0, most: float = math.inf) -> tuple[_Fit, int]:
    """Fewest knots that leave no correlation, and the best of their neighbours; with the number of fits."""
    fits: list[_Fit] = []
    until = math.inf
    candidates = _candidates(sample.t.size, sample.line.period is not None)
    # Nodes whose points lost their trust may leave fewer candidates than there were.
    fewest = min(fewest, most, candidates[-1])
    for parameters in candidates:
        if parameters < fewest:
            continue
        if parameters > min(until, most) and fits:
            break
        fit = _fit(sample, parameters)
        fits.append(fit)
        if fit.passed and math.isinf(until):
            until = 1.5 * parameters + 4
    return min(fits, key=lambda fit: fit.criterion + (0.0 if fit.passed else _CHANCE)), len(fits)


def _joined(step: Floats, closed: bool) -> NDArray[np.bool_]:
    """Whether a step is no gap, by what is usual around it."""
    from scipy.ndimage import median_filter

    if step.size < 3:
        return np.ones(step.size, dtype=np.bool_)
    usual = median_filter(step, size=11, mode="wrap" if closed else "mirror")
    joined: NDArray[np.bool_] = step <= _GAP * usual
    return joined


def _fit(sample: _Sample, parameters: int, enough: float = _SIGNIFICANT) -> _Fit:
    from scipy.sparse import diags

    basis = _basis(sample.line, parameters)
    n, k, root = sample.t.size, basis.parameters, sample.root
    design = diags(root) @ basis.design(sample.t)
    gram = design.T @ design
    gentle = basis.stiffness() * (1e-10 * float(gram.trace()) / k)
    factor = BandedFactor.of(gram + gentle, periodic=basis.periodic)
    coefficients = factor.solve(design.T @ (root * sample.mean))
    residual = root * sample.mean - design @ coefficients
    rss = float(residual @ residual)
    moran = moran_test(residual, sample.links, design, factor.solve, enough=enough)
    exact = rss <= sample.floor * sample.floor * float(root @ root)
    # AICc; the deviation counts as a parameter
    penalty = 2.0 * (k + 1) * n / (n - k - 2) if n > k + 2 else math.inf
    criterion = n * math.log(max(rss, 1e-300) / n) + penalty
    density = rss / (n - k) if n > k else math.nan
    return _Fit(k, basis, coefficients, factor, moran, criterion, exact or moran.z <= _SIGNIFICANT, density)


def _variance(line: _Line, fit: _Fit, place: Ints, trust: Floats) -> Floats:
    """Variance of the fit at the points for unit noise: the diagonal of X G^-1 X'W^2 X G^-1 X'."""
    from scipy.sparse import diags

    node = line.node[place]
    design = fit.basis.design(line.node_t)
    noise = diags(np.bincount(node, weights=trust**2, minlength=line.nodes))
    spread = fit.factor.solve((design.T @ noise @ design).toarray())
    covariance = fit.factor.solve(np.ascontiguousarray(spread.T))
    at_nodes = np.asarray((design @ covariance) * design.toarray()).sum(axis=1)
    variance: Floats = at_nodes[node]
    return variance


def _refitted(line: _Line, fit: _Fit, place: Ints, trust: Floats, d: Floats) -> Floats:
    """Fitted values of other values at the points, with the knots and the trust of a fit."""
    sample = _sample(line, d, place, trust, 0.0)
    design = fit.basis.design(sample.t)
    coefficients = fit.factor.solve(design.T @ (sample.root**2 * sample.mean))
    return fit.basis.evaluate(coefficients, line.t)[place]


def _first_trust(d: Floats, closed: bool, noise_floor: float) -> Floats:
    from scipy.ndimage import median_filter

    residual = d - median_filter(d, size=7, mode="wrap" if closed else "mirror")
    size = np.abs(residual)
    # Coarsely rounded values may equal their neighbours' median more often than not.
    common = np.minimum(size, np.quantile(size, 0.9))
    deviation = max(1.482602 * float(np.median(size)), 1.253314 * float(np.mean(common)))
    return _trust(residual, max(deviation, noise_floor))


def _trust(residual: Floats, deviation: float) -> Floats:
    """Full up to 3.5 deviations, none from 6 on, with the fall of Tukey's biweight between."""
    if deviation == 0.0:
        return np.ones_like(residual)
    excess = np.clip((np.abs(residual) / deviation - 3.5) / 2.5, 0.0, 1.0)
    trust: Floats = (1.0 - excess**2) ** 2
    return trust
