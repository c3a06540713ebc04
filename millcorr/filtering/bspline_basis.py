# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cubic B-splines on a line or round a contour, and the banded normal equations of a regression on them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, eq=False, slots=True)
class Basis:
    """Cubic B-splines (lower degrees for fewer than four parameters), periodic on a closed line.

    Attributes
    ----------
    knots : ndarray
        All knots, with those beyond the ends.
    degree : int
        Degree of the pieces.
    parameters : int
        Number of basis functions; those that wrap round a contour count once.
    periodic : bool
        Whether the line wraps round.
    """

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
        """Values of the spline with these coefficients at t."""
        from scipy.interpolate import BSpline

        wrapped = np.arange(self.knots.size - self.degree - 1) % self.parameters
        values: Floats = BSpline(self.knots, coefficients[wrapped], self.degree)(t)
        return values

    def stiffness(self) -> Any:
        """Second differences of the coefficients, squared: decides, gently, what no point decides."""
        from scipy.sparse import csr_array

        k = self.parameters
        if k < 3:
            return csr_array((k, k))
        rows = np.arange(k if self.periodic else k - 2)
        columns = np.concatenate((rows, rows + 1, rows + 2)) % k
        entries = np.repeat((1.0, -2.0, 1.0), rows.size)
        second = csr_array((entries, (np.tile(rows, 3), columns)), shape=(rows.size, k))
        return second.T @ second


@dataclass(frozen=True, eq=False, slots=True)
class BandedFactor:
    """Cholesky factor of a positive definite matrix whose entries lie near the diagonal or wrap round.

    Attributes
    ----------
    place : ndarray of int, shape (k,)
        Place of every unknown among those of the factor. A contour is folded flat, 0, k - 1, 1, k - 2, ...:
        its ends come to lie side by side, and the band is twice as wide instead of as wide as the matrix.
    band : ndarray
        Factor in the lower form of ``scipy.linalg.cholesky_banded``.
    """

    place: Ints
    band: Floats

    @staticmethod
    def of(matrix: Any, *, periodic: bool) -> BandedFactor:
        """Factorise a sparse matrix; raises numpy.linalg.LinAlgError where it is not positive definite."""
        from scipy.linalg import cholesky_banded

        k = matrix.shape[0]
        place = np.arange(k)
        if periodic:
            place = np.where(2 * place < k, 2 * place, 2 * (k - place) - 1)
        entries = matrix.tocoo()
        row, column = place[entries.row], place[entries.col]
        below = row >= column
        distance = (row - column)[below]
        band = np.zeros((int(distance.max()) + 1, k))
        band[distance, column[below]] = entries.data[below]
        return BandedFactor(place, cholesky_banded(band, overwrite_ab=True, lower=True))

    def solve(self, right: Floats) -> Floats:
        """Solve for one right-hand side, shape (k,), or for the columns of several, shape (k, m)."""
        from scipy.linalg import cho_solve_banded

        folded = np.empty_like(right)
        folded[self.place] = right
        solution: Floats = cho_solve_banded((self.band, True), folded, overwrite_b=True, check_finite=False)
        return solution[self.place]
