# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixed points ``x = g(x)`` of many small systems at once, by Anderson's acceleration of each.

For one unknown it is the secant method. Source: Walker and Ni, Anderson acceleration for fixed-point iterations,
SIAM J. Numer. Anal. 49 (2011).
"""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Floats, Ints

DEPTH = 3
"""So many earlier rounds are looked at: as many as a deflection has axes."""

FARTHEST = 2.0
"""A step is at most so many times as long as the difference: slopes above 0.5 are not followed."""

_STILL = 1e-20
"""Squares of changes below this share of the largest tell nothing."""


class FixedPoint:
    """Rounds towards the fixed points of systems that do not know of one another.

    Parameters
    ----------
    system : (m,) int64
        System of each row of unknowns.
    count : int
        Number of systems.
    depth : int
        So many earlier rounds are looked at: systems of so many unknowns are followed exactly where g is linear. 1
        where systems do know of one another after all: a second round back would be read as their own.
    """

    def __init__(self, system: Ints, count: int, depth: int) -> None:
        self._system, self._count, self._depth = system, count, depth
        self._last: tuple[Floats, Floats] | None = None
        self._moved: list[Floats] = []
        self._answered: list[Floats] = []

    def step(self, x: Floats, answer: Floats) -> Floats:
        """Where to go from x, whose g is `answer`; both (m, d), the result, too.

        What is asked for next must be this result, or x itself in systems that are left alone.
        """
        off = answer - x
        if self._last is not None:
            self._moved = [x - self._last[0], *self._moved][: self._depth]
            self._answered = [off - self._last[1], *self._answered][: self._depth]
        self._last = x, off
        if not self._moved:
            return answer
        k = len(self._moved)
        normal, right = np.empty((self._count, k, k)), np.empty((self._count, k))
        for i in range(k):
            right[:, i] = self._sum(self._answered[i], off)
            for j in range(i + 1):
                normal[:, i, j] = normal[:, j, i] = self._sum(self._answered[i], self._answered[j])
        # Rounds that changed nothing, or all the same, have no say; their part of the difference is taken whole.
        size = np.trace(normal, axis1=1, axis2=2)
        normal += (1e-10 * size + np.where(size > _STILL * size.max(initial=0.0), 0.0, 1.0))[:, None, None] * np.eye(k)
        share = np.linalg.solve(normal, right[..., None])[..., 0]
        way = off.copy()
        for i in range(k):
            way -= share[self._system, i, None] * (self._moved[i] + self._answered[i])
        long, most = np.sqrt(self._sum(way, way)), FARTHEST * np.sqrt(self._sum(off, off))
        way = way * np.where(long > most, most / np.where(long > 0, long, 1.0), 1.0)[self._system, None]
        out: Floats = x + way
        return out

    def _sum(self, a: Floats, b: Floats) -> Floats:
        out: Floats = np.bincount(self._system, (a * b).sum(axis=1), minlength=self._count).astype(np.float64)
        return out
