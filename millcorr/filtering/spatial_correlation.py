# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moran's I of regression residuals: is there still something determined in them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Traces of larger matrices are estimated with random signs (Hutchinson 1990). They err by about
# sqrt(2 k / 64), a twentieth of the deviation of the sums they enter, which grows as sqrt(n).
_PROBED = 200
_PROBES = 64


@dataclass(frozen=True, slots=True)
class Moran:
    """Moran's I with its moments under independence.

    Attributes
    ----------
    index : float
        Moran's I: near 0 for independent residuals, towards 1 where neighbours go together.
    expectation, variance : float
        Its exact moments for the residuals of the regression when the errors are independent and normal.
    """

    index: float
    expectation: float
    variance: float

    @property
    def z(self) -> float:
        """Standardised index; above 1.645 the residuals are correlated at the one-sided 5 % level."""
        return (self.index - self.expectation) / math.sqrt(self.variance) if self.variance > 0.0 else 0.0


def neighbour_links(n: int, joined: NDArray[np.bool_], reach: int) -> Any:
    """Link every point with its nearest neighbours along the line.

    Parameters
    ----------
    n : int
        Number of points, numbered along the line.
    joined : ndarray of bool, shape (n - 1,) or (n,)
        Whether a link may cross the step from every point to the next; n of them on a closed contour.
    reach : int
        Neighbours on either side.

    Returns
    -------
    scipy.sparse.csr_array, shape (n, n)
        Symmetric matrix of ones with an empty diagonal.
    """
    from scipy.sparse import csr_array

    closed = joined.size == n
    first: list[NDArray[np.int64]] = []
    second: list[NDArray[np.int64]] = []
    whole = joined.copy()
    for lag in range(1, min(reach, (n - 1) // 2 if closed else n - 1) + 1):
        if lag > 1:
            whole = whole & np.roll(joined, 1 - lag) if closed else whole[:-1] & joined[lag - 1 :]
        here = np.flatnonzero(whole)
        first.append(here)
        second.append((here + lag) % n)
    i = np.concatenate([*first, *second]) if first else np.zeros(0, dtype=np.int64)
    j = np.concatenate([*second, *first]) if first else np.zeros(0, dtype=np.int64)
    return csr_array((np.ones(i.size), (i, j)), shape=(n, n))


def moran_test(
    residuals: Floats,
    links: Any,
    design: Any,
    solve: Callable[[Floats], Floats] | None = None,
    *,
    enough: float = math.inf,
) -> Moran:
    """Moran's I of regression residuals and its exact first two moments.

    Parameters
    ----------
    residuals : ndarray, shape (n,)
        Least-squares residuals of the regression on `design`; for weighted regression both scaled by the
        roots of the weights.
    links : sparse array, shape (n, n)
        Symmetric spatial weights W with an empty diagonal.
    design : sparse array, shape (n, k)
        Regressors; a column of ones for the plain Moran's I.
    solve : callable, optional
        Solves (design' design) x = b for the columns of b, where a factor of that matrix is at hand.
    enough : float
        The moments cost far more than the index. Where z exceeds this by a bound on them, the bound is
        returned for them: expectation 0 and the largest variance, so that z is no more than the true one.

    Returns
    -------
    Moran
        Index, expectation and variance; all 0 where there are no links or no residuals.

    Notes
    -----
    With M the projection on the residuals, S0 the sum of the weights and f = n - k (Cliff & Ord, Spatial
    Processes, 1981, section 8.3): E(I) = (n/S0) tr(MW) / f and
    E(I^2) = (n/S0)^2 (2 tr(MWMW) + tr(MW)^2) / (f (f + 2)). For k = 1 this is the familiar -1/(n - 1). The
    plain expectation would be too high: the more regressors, the more negative the correlation of residuals.
    Beyond 200 regressors the traces are estimated, which moves z by a few hundredths.
    The bound: tr(MW) <= 0 for regressors whose fits are smooth, and tr(MWMW) <= tr(WW).
    """
    n, k = design.shape
    total = float(links.sum())
    squares = float(residuals @ residuals)
    if total == 0.0 or squares == 0.0:
        return Moran(0.0, 0.0, 0.0)
    scale = n / total
    index = scale * float(residuals @ (links @ residuals)) / squares
    square_links = float((links * links).sum())
    if n > k:
        bound = scale * scale * 2.0 * square_links / ((n - k) * (n - k + 2.0))
        if index > enough * math.sqrt(bound):
            return Moran(index, 0.0, bound)
    gram = design.T @ design
    if solve is None:
        solve = _dense_solver(gram.toarray())
    linked = links @ design
    shared, once, outer, inner = _traces(solve, gram, design.T @ linked, linked.T @ linked)
    freedom = n - shared
    if freedom < 0.5:
        return Moran(0.0, 0.0, 0.0)
    once = -once
    twice = square_links - 2.0 * outer + inner
    expectation = scale * once / freedom
    second = scale * scale * (2.0 * twice + once * once) / (freedom * (freedom + 2.0))
    return Moran(index, expectation, max(0.0, second - expectation * expectation))


def _traces(
    solve: Callable[[Floats], Floats], gram: Any, crossed: Any, outer: Any
) -> tuple[float, float, float, float]:
    """Traces of G^-1 gram, G^-1 crossed, G^-1 outer and (G^-1 crossed)^2."""
    k = gram.shape[0]
    if k <= _PROBED:
        product = solve(crossed.toarray())
        return (
            float(np.trace(solve(gram.toarray()))),
            float(np.trace(product)),
            float(np.trace(solve(outer.toarray()))),
            float(np.sum(product * product.T)),
        )
    signs = np.random.default_rng(0).choice((-1.0, 1.0), (k, _PROBES))
    product = solve(crossed @ signs)
    return (
        float(np.sum(signs * solve(gram @ signs))) / _PROBES,
        float(np.sum(signs * product)) / _PROBES,
        float(np.sum(signs * solve(outer @ signs))) / _PROBES,
        float(np.sum(signs * solve(crossed @ product))) / _PROBES,
    )


def _dense_solver(matrix: Floats) -> Callable[[Floats], Floats]:
    from scipy.linalg import cho_factor, cho_solve

    factor = cho_factor(matrix)

    def solve(right: Floats) -> Floats:
        solution: Floats = cho_solve(factor, right)
        return solution

    return solve
