# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which pieces of a path can matter to which steps: neighbours found in groups, so that dense programs stay cheap."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import shapely

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

from .path_pieces import Pieces

BLOCK = 16
"""So many neighbouring steps look for pieces together."""

GROUP = 8
"""So many consecutive pieces, or groups of them, make a group."""

PAIRS = 100_000
"""At most about so many pairs of step and group are held at once."""

SMALL = 0.25
"""Groups are made as long as most are smaller than this share of the reach."""

_SLACK = 1e-9

Filter = Callable[[Ints, Floats, Floats, Floats, Ints, int], Bools]
"""(step, x, y, half, first, count) -> pairs to keep: `count` pieces from `first` on, within `half` mm of (x, y)."""


def _everything(step: Ints, x: Floats, y: Floats, half: Floats, first: Ints, count: int) -> Bools:
    return np.ones(len(step), dtype=bool)


class PieceTree:
    """Pieces in groups of groups, and a search tree over the outermost.

    Parameters
    ----------
    pieces : Pieces
        In their order along the path.
    reach : float
        How far a step looks, mm.
    """

    def __init__(self, pieces: Pieces, reach: float) -> None:
        self.pieces = pieces
        self.reach = reach
        self._levels = _levels(pieces, reach) if len(pieces) else []
        if self._levels:
            x, y, half = self._levels[-1]
            self._tree = shapely.STRtree(shapely.box(x - half, y - half, x + half, y + half))

    def near(self, centre: Floats, least: float = 0.0, keep: Filter = _everything) -> Iterator[tuple[Ints, Ints]]:
        """Pairs of a step and a piece that may come within reach of it.

        Parameters
        ----------
        centre : (n, 2) float64
            Places of the steps in mm; neighbours in the row should be neighbours in the plane.
        least : float
            Pieces that stay nearer than this, in mm, are left out.
        keep : callable
            Decides on pieces, and on whole groups of them: what it drops for a group must be useless for every piece.

        Yields
        ------
        step, piece : (m,) int64
            In portions; a pair comes once.
        """
        n = len(centre)
        if not n or not self._levels:
            return
        x, y, half = self._levels[-1]
        begin = np.arange(0, n, BLOCK)
        low = np.minimum.reduceat(centre, begin) - self.reach
        high = np.maximum.reduceat(centre, begin) + self.reach
        block, group = self._tree.query(shapely.box(*low.T, *high.T))
        portion = max(1, PAIRS // BLOCK)
        cx, cy = (np.append(v, np.full(-n % BLOCK, np.nan)).reshape(-1, BLOCK) for v in centre.T)
        for a in range(0, len(block), portion):
            progress.step()
            b, g = block[a : a + portion], group[a : a + portion]
            # Steps beyond the last one are NaN, which is never near.
            near = _within(cx[b] - x[g, None], cy[b] - y[g, None], half[g, None], self.reach, least)
            k, column = np.nonzero(near)
            step, row = b[k] * BLOCK + column, g[k]
            count = GROUP ** (len(self._levels) - 1)
            good = keep(step, x[row], y[row], half[row], row * count, count)
            step, row = step[good], row[good]
            for depth in range(len(self._levels) - 2, -1, -1):
                xx, yy, hh = self._levels[depth]
                row = (row[:, None] * GROUP + np.arange(GROUP)).ravel()
                step = np.repeat(step, GROUP)
                there = row < len(xx)
                step, row = step[there], row[there]
                near = _within(centre[step, 0] - xx[row], centre[step, 1] - yy[row], hh[row], self.reach, least)
                step, row = step[near], row[near]
                good = keep(step, xx[row], yy[row], hh[row], row * GROUP**depth, GROUP**depth)
                step, row = step[good], row[good]
            yield step.astype(np.int64), row.astype(np.int64)


def _within(dx: Floats, dy: Floats, half: Floats, reach: float, least: float) -> Bools:
    """Whether circles of radius `half` at (dx, dy) reach between `least` and `reach` mm from the origin."""
    d2 = dx * dx + dy * dy
    half = half + _SLACK
    out: Bools = d2 <= (reach + half) ** 2
    if least > 0:
        out &= d2 >= np.maximum(least - half, 0.0) ** 2
    return out


def _levels(pieces: Pieces, reach: float) -> list[tuple[Floats, Floats, Floats]]:
    """Circles (x, y, radius) round pieces, then round groups of them, and so on."""
    middle = (pieces.start + pieces.end) / 2
    # An arc of less than half a turn stays within the circle over its chord.
    half = np.hypot(*(pieces.end - pieces.start).T) / 2
    out = [(middle[:, 0].copy(), middle[:, 1].copy(), half)]
    while len(out[-1][0]) > 4 * GROUP:
        x, y, half = out[-1]
        first = np.arange(0, len(x), GROUP)
        gx, gy = ((np.minimum.reduceat(v - half, first) + np.maximum.reduceat(v + half, first)) / 2 for v in (x, y))
        of = np.arange(len(x)) // GROUP
        size = np.maximum.reduceat(np.hypot(x - gx[of], y - gy[of]) + half, first)
        if np.median(size) > SMALL * reach:
            break
        out.append((gx, gy, size))
    return out
