# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moran's I of regression residuals: is there still something determined in them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


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


def moran_test(residuals: Floats, links: Any, design: Any, factor: Any = None) -> Moran:
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
    factor : tuple, optional
        ``scipy.linalg.cho_factor`` of design' design, where it is at hand.

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
    """
    from scipy.linalg import cho_factor, cho_solve

    n = residuals.size
    total = float(links.sum())
    squares = float(residuals @ residuals)
    gram = (design.T @ design).toarray()
    if factor is None:
        factor = cho_factor(gram)
    freedom = n - float(np.trace(cho_solve(factor, gram)))
    if total == 0.0 or squares == 0.0 or freedom < 0.5:
        return Moran(0.0, 0.0, 0.0)
    scale = n / total
    linked = links @ design
    crossed = cho_solve(factor, (design.T @ linked).toarray())
    once = -float(np.trace(crossed))
    twice = (
        float((links * links).sum())
        - 2.0 * float(np.trace(cho_solve(factor, (linked.T @ linked).toarray())))
        + float(np.sum(crossed * crossed.T))
    )
    expectation = scale * once / freedom
    second = scale * scale * (2.0 * twice + once * once) / (freedom * (freedom + 2.0))
    index = scale * float(residuals @ (links @ residuals)) / squares
    return Moran(index, expectation, max(0.0, second - expectation * expectation))
