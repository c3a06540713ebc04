# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-spline regression along a line that takes as many knots as the data can prove, and no more."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .spatial_correlation import Moran, moran_test, neighbour_links

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

# Neighbours on either side that Moran's I looks at, and the one-sided 5 % point of the normal law.
_REACH = 2
_SIGNIFICANT = 1.6448536269514722
# No knot spacing below this many places: finer detail cannot be told from noise.
_PLACES_PER_KNOT = 3
# More places than this are averaged in groups for the search; the knots stay far coarser than a group.
_NODES = 3000
_GAP = 5.0
# A remainder below this share of the deviations' spread is none.
_NOTHING_LEFT = 1e-3
# What an information criterion must gain before a correlation of the residuals is put down to chance.
_CHANCE = 6.0
_ROUNDS = 5


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
        Standard deviation of the residuals with n - parameters degrees of freedom; NaN where there are none.
    variance_factor : float
        Mean over the points of the fit's variance for unit white noise.
    knot_spacing : float
        Mean distance between knots in mm.
    moran : Moran
        Test of the residuals.
    settled : bool
        Whether the residuals showed no more correlation.
    """

    values: Floats
    weights: Floats
    parameters: int
    random_std: float
    variance_factor: float
    knot_spacing: float
    moran: Moran
    settled: bool


@dataclass(frozen=True, eq=False, slots=True)
class _Line:
    """Places along the line in the regression's own coordinate t, and the node every place belongs to."""

    t: Floats
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
    basis: _Basis
    coefficients: Floats
    factor: Any
    moran: Moran
    criterion: float
    passed: bool


@dataclass(frozen=True, eq=False, slots=True)
class _Basis:
    """Cubic B-splines (lower degrees for fewer than four parameters), periodic on a closed line."""

    knots: Floats
    degree: int
    parameters: int
    periodic: bool

    def design(self, t: Floats) -> Any:
        """Values of the basis functions at t: sparse, shape (t.size, parameters)."""
        from scipy.interpolate import BSpline
        from scipy.sparse import csr_array

        raw = BSpline.design_matrix(t, self.knots, self.degree).tocoo()
        columns = raw.col % self.parameters if self.periodic else raw.col
        # Building from triplets adds up the functions that wrap round onto the same column.
        return csr_array((raw.data, (raw.row, columns)), shape=(t.size, self.parameters))

    def evaluate(self, coefficients: Floats, t: Floats) -> Floats:
        from scipy.interpolate import BSpline

        wrapped = np.arange(self.knots.size - self.degree - 1) % self.parameters
        values: Floats = BSpline(self.knots, coefficients[wrapped], self.degree)(t)
        return values


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
    for _ in range(_ROUNDS):
        fit = _search(line, d, place, trust, floor)
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
    spans = fit.parameters if period is not None else max(1, fit.parameters - 3)
    return SplineRegression(
        values,
        trust,
        fit.parameters,
        std,
        _variance_factor(line, fit, place, trust),
        length / spans,
        fit.moran,
        fit.passed,
    )


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
        t = np.where((rank < 0.25 * m) & (t > 0.75 * period), 0.0, t)
        t = np.where((rank > 0.75 * m) & (t < 0.25 * period), math.nextafter(period, 0.0), t)
        t = np.where(t >= period, math.nextafter(period, 0.0), t)
    nodes = min(m, _NODES)
    if m <= _NODES:
        node = np.argsort(np.argsort(rank, kind="stable"), kind="stable").astype(np.int64)
    else:
        node = np.minimum((rank * (nodes / m)).astype(np.int64), nodes - 1)
    size = np.bincount(node, minlength=nodes)
    node_t = np.bincount(node, weights=t, minlength=nodes) / size
    node_rank = np.bincount(node, weights=rank, minlength=nodes) / size * (nodes / m)
    return _Line(t, node, node_t, node_rank, period)


def _basis(line: _Line, parameters: int) -> _Basis:
    n = line.nodes
    if line.period is None:
        degree = min(3, parameters - 1)
        end = float(line.t[-1])
        measure = np.append(0.0, np.cumsum(_measure(np.diff(line.node_t), parameters)))
        shares = np.arange(1, parameters - degree) / (parameters - degree)
        inner = np.interp(shares * measure[-1], measure, line.node_t)
        knots = np.concatenate((np.zeros(degree + 1), inner, np.full(degree + 1, end if end > 0.0 else 1.0)))
        return _Basis(knots, degree, parameters, False)
    period = line.period
    ranks = np.concatenate(([line.node_rank[-1] - n], line.node_rank, [line.node_rank[0] + n]))
    t = np.concatenate(([line.node_t[-1] - period], line.node_t, [line.node_t[0] + period]))
    steps = _measure(np.diff(t[1:]), parameters)
    measure = np.cumsum(np.concatenate(([-steps[-1], steps[-1]], steps)))
    start = np.interp(0.0, ranks, measure)
    inner = np.interp(start + np.arange(parameters) * (measure[-1] / parameters), measure, t)
    inner[0] = 0.0
    around = np.arange(-3, parameters + 4)
    return _Basis(inner[around % parameters] + period * (around // parameters), 3, parameters, True)


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
    crowding = min(1.0, parameters * _PLACES_PER_KNOT / (step.size + 1.0))
    measure: Floats = crowding + (1.0 - crowding) * share
    return measure


def _candidates(nodes: int, closed: bool) -> list[int]:
    """Numbers of parameters to try: one by one first, then in steps of a tenth."""
    most = nodes // _PLACES_PER_KNOT
    if not closed and nodes >= 4:
        most = max(most, 2)
    numbers = [1]
    while True:
        following = max(numbers[-1] + 1, math.ceil(1.1 * numbers[-1]))
        # Two knots round a contour make a wave of one phase only.
        following = 3 if closed and following == 2 else following
        if following > most:
            return numbers
        numbers.append(following)


def _search(line: _Line, d: Floats, place: Ints, trust: Floats, floor: float) -> _Fit:
    """Fewest knots that leave no correlation, and the best of their neighbours."""
    node = line.node[place]
    n = line.nodes
    weight = np.bincount(node, weights=trust, minlength=n)
    used = weight > 1e-3
    mean = np.bincount(node, weights=trust * d, minlength=n) / np.where(used, weight, 1.0)
    root, mean, t = np.sqrt(weight[used]), mean[used], line.node_t[used]
    step = np.diff(t) if line.period is None else np.append(np.diff(t), t[0] + line.period - t[-1])
    links = neighbour_links(t.size, _joined(step, line.period is not None), _REACH)
    fits: list[_Fit] = []
    until = math.inf
    for parameters in _candidates(t.size, line.period is not None):
        if parameters > until:
            break
        fit = _fit(_basis(line, parameters), t, mean, root, links, floor)
        fits.append(fit)
        if fit.passed and math.isinf(until):
            until = 1.5 * parameters + 4
    return min(fits, key=lambda fit: fit.criterion + (0.0 if fit.passed else _CHANCE))


def _joined(step: Floats, closed: bool) -> NDArray[np.bool_]:
    """Whether a step is no gap, by what is usual around it."""
    from scipy.ndimage import median_filter

    if step.size < 3:
        return np.ones(step.size, dtype=np.bool_)
    usual = median_filter(step, size=11, mode="wrap" if closed else "mirror")
    joined: NDArray[np.bool_] = step <= _GAP * usual
    return joined


def _fit(basis: _Basis, t: Floats, d: Floats, root: Floats, links: Any, floor: float) -> _Fit:
    from scipy.linalg import cho_factor, cho_solve
    from scipy.sparse import diags

    n, k = t.size, basis.parameters
    design = diags(root) @ basis.design(t)
    gram = (design.T @ design).toarray()
    factor = cho_factor(gram + _stiffness(basis) * (1e-10 * np.trace(gram) / k))
    coefficients = cho_solve(factor, design.T @ (root * d))
    residual = root * d - design @ coefficients
    rss = float(residual @ residual)
    moran = moran_test(residual, links, design, factor)
    exact = rss <= floor * floor * float(root @ root)
    # AICc; the deviation counts as a parameter
    penalty = 2.0 * (k + 1) * n / (n - k - 2) if n > k + 2 else math.inf
    criterion = n * math.log(max(rss, 1e-300) / n) + penalty
    return _Fit(k, basis, coefficients, factor, moran, criterion, exact or moran.z <= _SIGNIFICANT)


def _stiffness(basis: _Basis) -> Floats:
    """Second differences of the coefficients, squared: decides, gently, what no point decides."""
    k = basis.parameters
    bend = np.zeros((k, k))
    if k < 3:
        return bend
    second = np.eye(k, k) * -2.0 + np.eye(k, k, 1) + np.eye(k, k, -1)
    if basis.periodic:
        second[0, -1] += 1.0
        second[-1, 0] += 1.0
    else:
        second = second[1:-1]
    product: Floats = second.T @ second
    return product


def _variance_factor(line: _Line, fit: _Fit, place: Ints, trust: Floats) -> float:
    """Mean variance of the fit for unit noise: tr(G^-1 X'W^2 X G^-1 X'X) / n."""
    from scipy.linalg import cho_solve
    from scipy.sparse import diags

    node = line.node[place]
    design = fit.basis.design(line.node_t)
    noise = diags(np.bincount(node, weights=trust**2, minlength=line.nodes))
    count = diags(np.bincount(node, minlength=line.nodes).astype(np.float64))
    spread = cho_solve(fit.factor, (design.T @ noise @ design).toarray())
    reach = cho_solve(fit.factor, (design.T @ count @ design).toarray())
    return float(np.sum(spread * reach.T)) / place.size


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
