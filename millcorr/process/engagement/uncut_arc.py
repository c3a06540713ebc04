# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the cutter's front that meets material, at many places of a path at once.

A point of the front is cut where it is stock and no earlier part of the path has swept it. What earlier pieces
cover of each circle is closed form (`swept_circle`); the rest is what is cut. So the stock is carried forward
without ever being built: passes that cross, repeat or run into each other need nothing special.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

from .path_pieces import Pieces
from .piece_tree import GROUP, PieceTree
from .stock_region import StockRegion
from .swept_circle import SAME_PLACE, behind, covered_by_arcs, covered_by_lines, half_width, wrapped

JOINED = 1e-6
"""Pieces whose ends are nearer than this, in mm, follow each other without a break."""

NOTHING = 1e-9
"""Arcs shorter than this, in rad, are not cut."""

PORTION = 16_384
"""So many steps are worked on at once, to bound the memory."""

_APART = 1e-6
"""The direction to a place nearer than this, in mm, is not certain."""

_CHUNK = 1024


@dataclass(frozen=True, eq=False, slots=True)
class Steps:
    """Places of the cutter along its path, one row a step.

    Parameters
    ----------
    centre : (n, 2) float64
        mm.
    direction : (n,) float64
        Direction of travel in rad.
    piece : (n,) int64
        Piece of path that the cutter is on.
    u : (n,) float64
        Part of the piece behind it, 0..1.
    """

    centre: Floats
    direction: Floats
    piece: Ints
    u: Floats

    def __len__(self) -> int:
        return len(self.piece)

    def take(self, index: Ints | Bools | slice) -> Steps:
        """Steps chosen by index or mask."""
        return Steps(self.centre[index], self.direction[index], self.piece[index], self.u[index])


@dataclass(frozen=True, eq=False, slots=True)
class Past:
    """What a cutter has swept before each of its steps.

    Parameters
    ----------
    pieces : Pieces
        Its path, in order.
    known : (n,) int64
        Step i has behind it the pieces before row ``known[i]``; what led up to the step itself is in `own`.
    own : (step, low, high)
        In the order of steps: parts of the front that the piece under the step covers, angles in rad from the
        direction of travel.
    """

    pieces: Pieces
    known: Ints
    own: tuple[Ints, Floats, Floats]


def past_of(steps: Steps, pieces: Pieces, here: Bools, radius: float) -> Past:
    """The past of steps on a path: pieces that are not `here`, (m,), do not reach the height looked at.

    Standing at a piece's start, all from the piece that led there on only touches the place: it counts as far as
    it covers the front, by its direction alone.
    """
    led, begins = _led_by(pieces)
    start = steps.u * pieces.length[steps.piece] <= SAME_PLACE
    piece = np.where(start, led[steps.piece], steps.piece)
    row = np.flatnonzero((piece >= 0) & here[piece])
    k = piece[row]
    part = np.where(start[row], 1.0, steps.u[row])
    middle, half = behind(radius, pieces.radius[k], pieces.sweep[k] * part)
    ahead = pieces.tangent(k, part)
    own = _front(steps, row, np.arctan2(ahead[:, 1], ahead[:, 0]) + middle, half)
    order = np.argsort(own[0], kind="stable")
    own = own[0][order], own[1][order], own[2][order]
    known = np.where(start, np.where(piece >= 0, piece, begins[steps.piece]), steps.piece)
    # Counted among the pieces that reach the height.
    return Past(pieces.take(here), np.concatenate([[0], np.cumsum(here)])[known], own)


def uncut(steps: Steps, past: Past, radius: float, stock: StockRegion, height: float) -> tuple[Ints, Floats, Floats]:
    """Arcs of the cutter's front that meet material.

    Parameters
    ----------
    steps : Steps
        In the order of the program.
    past : Past
    radius : float
        Cutter radius in mm.
    stock : StockRegion
    height : float
        Height looked at, mm: earlier programs count where their tip is not above it.

    Returns
    -------
    step : (k,) int64
        In order.
    low, high : (k,) float64
        Angles in rad from the direction of travel, positive to its left, within -pi/2..pi/2, ascending.
    """
    outside = stock.outside(steps.centre, steps.direction, radius)
    trees: list[tuple[PieceTree, float, Ints | None]] = [(PieceTree(past.pieces, 2 * radius), radius, past.known)]
    for before in stock.swept:
        z0, z1 = before.pieces.z0, before.pieces.z1
        # A plunge reaches its depth, a ramp only at one end.
        tip = np.where(before.pieces.length > 0, np.maximum(z0, z1), np.minimum(z0, z1))
        trees.append((PieceTree(before.pieces.take(~(tip > height)), radius + before.radius), before.radius, None))
    found = []
    for a in range(0, len(steps), PORTION):
        progress.step()
        part = steps.take(slice(a, a + PORTION))
        covered = [_rows(outside, a, a + PORTION), _rows(past.own, a, a + PORTION)]
        for tree, swept, known in trees:
            useful = _Useful(part, tree.pieces, radius, swept, None if known is None else known[a : a + PORTION])
            for step, row in tree.near(part.centre, keep=useful):
                progress.step()
                covered += [_front(part, *c) for c in _covered(part, tree.pieces, step, row, radius, swept)]
            covered += [_front(part, *c) for c in useful.certain]
        step, low, high = _left_over(len(part), *(np.concatenate([c[i] for c in covered]) for i in range(3)))
        found.append((step + a, low, high))
    step, low, high = (np.concatenate([f[i] for f in found]) for i in range(3))
    return step, low, high


def _rows(intervals: tuple[Ints, Floats, Floats], begin: int, end: int) -> tuple[Ints, Floats, Floats]:
    """Intervals of steps begin to end, in the order of steps, counted from begin."""
    step, low, high = intervals
    a, b = np.searchsorted(step, (begin, end))
    return step[a:b] - begin, low[a:b], high[a:b]


def _led_by(pieces: Pieces) -> tuple[Ints, Ints]:
    """For each piece the last one with a length that leads to its start without a break, and where its row begins.

    The first is -1 where none does.
    """
    n = len(pieces)
    rows = np.arange(n)
    apart = np.ones(n, dtype=bool)
    apart[1:] = np.hypot(*(pieces.start[1:] - pieces.end[:-1]).T) > JOINED
    begins: Ints = np.maximum.accumulate(np.where(apart, rows, 0))
    solid = np.maximum.accumulate(np.where(pieces.length > SAME_PLACE, rows, -1))
    last = np.concatenate([[-1], solid[:-1]])
    return np.where(last >= begins, last, -1), begins


def layer(steps: Steps, past: Past, radius: float, arc: tuple[Ints, Floats, Floats], reach: float) -> Floats:
    """Thickness of the material before the middle of engaged arcs, up to what the same cutter has swept before.

    Parameters
    ----------
    steps : Steps
    past : Past
    radius : float
        Cutter radius in mm.
    arc : (step, low, high)
        As `uncut` gives them, (k,) each.
    reach : float
        Thicknesses above this, in mm, need not be told apart.

    Returns
    -------
    (k,) float64
        mm, at most `reach`.
    """
    step, low, high = arc
    angle = steps.direction[step] + (low + high) / 2
    point = steps.centre[step] + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    out = np.full(len(step), reach)

    def before(row: Ints, x: Floats, y: Floats, half: Floats, first: Ints, count: int) -> Bools:
        keep: Bools = first < past.known[step[row]]
        return keep

    for row, piece in PieceTree(past.pieces, radius + reach).near(point, radius, keep=before):
        np.minimum.at(out, row, past.pieces.distance(piece, point[row]) - radius)
    out[out < 0.0] = 0.0
    return out


class _Useful:
    """Filter of pairs: pieces before ``known[step]`` (None: all) that may cover some of the front, more than others do.

    Discs of radius `swept` somewhere within `half` mm of (x, y) lie within one of radius ``swept + half``. Behind,
    its interval stays clear of the front where the cosine of its direction from straight back is not below the sine
    of its half width. Groups of pieces are also dropped where it lies within what single places of all groups cover
    for certain, joined to the rear, which does not matter; `certain` collects that as intervals.
    """

    def __init__(self, steps: Steps, pieces: Pieces, radius: float, swept: float, known: Ints | None) -> None:
        self.pieces, self.radius, self.swept, self.known = pieces, radius, swept, known
        self.direction = steps.direction
        self.ex, self.ey = np.cos(steps.direction), np.sin(steps.direction)
        self.cx, self.cy = steps.centre[:, 0].copy(), steps.centre[:, 1].copy()
        self.certain: list[tuple[Ints, Floats, Floats]] = []

    def __call__(self, step: Ints, x: Floats, y: Floats, half: Floats, first: Ints, count: int) -> Bools:
        vx, vy = x - self.cx[step], y - self.cy[step]
        d2 = vx * vx + vy * vy
        c = (d2 + (self.radius - self.swept - half) * (self.radius + self.swept + half)) / (2 * self.radius)
        back = -(vx * self.ex[step] + vy * self.ey[step])
        # Both sides times the distance: back >= sqrt(d^2 - c^2), c >= 0.
        out: Bools = (c < 0) | (back < 0) | (back * back + c * c < d2)
        if self.known is not None:
            out &= first < self.known[step]
        if count == GROUP:
            k = np.flatnonzero(out)
            out[k] = self._beyond_certain(step[k], vx[k], vy[k], half[k], first[k])
        return out

    def _beyond_certain(self, step: Ints, vx: Floats, vy: Floats, half: Floats, first: Ints) -> Bools:
        n = len(self.cx)
        behind_ = self.direction + np.pi
        place = first + GROUP // 2
        last = len(self.pieces) if self.known is None else self.known[step]
        there = place < last
        at = self.pieces.start[np.where(there, place, 0)]
        px, py = at[:, 0] - self.cx[step], at[:, 1] - self.cy[step]
        d2 = px * px + py * py
        wide = np.where(there & (d2 > _APART**2), half_width(d2, self.radius, self.swept), 0.0)
        way = wrapped(np.arctan2(py, px) - behind_[step])
        joins = np.flatnonzero((np.abs(way) < wide + np.pi / 2) & (wide > 0))
        low, high = np.full(n, -np.pi / 2), np.full(n, np.pi / 2)
        np.minimum.at(low, step[joins], (way - wide)[joins])
        np.maximum.at(high, step[joins], (way + wide)[joins])
        touched = np.zeros(n, dtype=bool)
        touched[step[joins]] = True
        some = np.flatnonzero(touched)
        self.certain.append((some, behind_[some] + (low + high)[some] / 2, (high - low)[some] / 2))
        middle = wrapped(np.arctan2(vy, vx) - behind_[step])
        outer = half_width(vx * vx + vy * vy, self.radius, self.swept + half)
        out: Bools = (middle - outer < low[step]) | (middle + outer > high[step])
        return out


def _covered(
    steps: Steps, pieces: Pieces, step: Ints, row: Ints, radius: float, swept: float
) -> Iterator[tuple[Ints, Floats, Floats]]:
    """Intervals, in the plane's directions, that pieces cover of the circles they are paired with."""
    arc = pieces.is_arc[row]
    for arcs in (False, True):
        k = np.flatnonzero(arc == arcs)
        if not len(k):
            continue
        s, r = step[k], row[k]
        ox, oy = steps.centre[s].T
        if arcs:
            cx, cy = pieces.centre[r].T
            ax, ay = (pieces.start[r] - pieces.centre[r]).T
            angle = np.arctan2(ay, ax)
            pair, middle, half = covered_by_arcs(
                ox, oy, radius, cx, cy, pieces.radius[r], angle, pieces.sweep[r], swept
            )
        else:
            (ax, ay), (bx, by) = pieces.start[r].T, pieces.end[r].T
            pair, middle, half = covered_by_lines(ox, oy, radius, ax, ay, bx, by, swept)
        yield s[pair], middle, half


def _front(steps: Steps, step: Ints, middle: Floats, half: Floats) -> tuple[Ints, Floats, Floats]:
    """Intervals ``middle +- half`` as seen from the direction of travel, cut to the front; those behind are dropped."""
    relative = wrapped(middle - steps.direction[step])
    out = []
    for turn in (0.0, -2 * np.pi, 2 * np.pi):
        low, high = relative + turn - half, relative + turn + half
        keep = np.flatnonzero((low < np.pi / 2) & (high > -np.pi / 2))
        out.append((step[keep], low[keep], high[keep]))
    return tuple(np.concatenate([o[i] for o in out]) for i in range(3))  # type: ignore[return-value]


def _left_over(n: int, step: Ints, low: Floats, high: Floats) -> tuple[Ints, Floats, Floats]:
    """What intervals leave of -pi/2..pi/2, step by step."""
    edge = np.full(n, np.pi / 2)
    step = np.concatenate([np.arange(n), step, np.arange(n)])
    low, high = np.concatenate([-edge, low, edge]), np.concatenate([-edge, high, edge])
    # One key in place of two, and runs that are in order already: lows nearer to each other than its last digit, 6e-11
    # rad, may change places.
    order = np.argsort(low + 16.0 * step, kind="stable")
    step, low, high = step[order], low[order], high[order]
    # A running maximum for each step: steps are kept apart by an offset, small enough not to cost digits.
    bounds = np.searchsorted(step, np.arange(0, n + _CHUNK, _CHUNK))
    reached = np.empty(len(step))
    for c, (a, b) in enumerate(zip(bounds[:-1], bounds[1:], strict=True)):
        offset = 16.0 * (step[a:b] - c * _CHUNK)
        reached[a:b] = np.maximum.accumulate(np.minimum(high[a:b], np.pi / 2) + offset) - offset
    gap = np.flatnonzero((step[1:] == step[:-1]) & (low[1:] - reached[:-1] > NOTHING))
    return step[gap].astype(np.int64), np.maximum(reached[gap], -np.pi / 2), np.minimum(low[gap + 1], np.pi / 2)
