# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting area of a square end mill with helix, tooth by tooth: closed form, and on a Z-map (dat-2025, figs. 8, 9).

A square end mill in a cut of constant depth removes a column of the workpiece from the bottom up: at height z its
edges lag behind their tips by ``z tan(helix) / R``. So the map holds for every column, at every slice of the height,
which edge removes it and at which angle. The columns are not swept step by step: the cutter's circle first reaches a
column at the root of a quadratic, and the next edge passes it at the root of a phase that grows all but evenly. Both
are solved for all columns together, so that the only error is the columns' size, and the cost grows with the path's
length. Teeth run on their true trochoids, at the path's real feed.

The closed form takes the chip as ``f_t sin(phi)`` on the exact engaged arcs of `process.engagement`. It is what the
force model uses; the map is the paper's way, and the check on it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.setup_file import Tool

from .real_path import RealPath

GRID = 0.01
"""Size of a column in mm (dat-2025, fig. 8)."""

SLICES = 16
"""Slices of the height: the edge turns by a sixteenth of its whole lag in one."""

BINS = 360

_TILE = 128
"""Columns along a tile's side: a tile's work fits a processor's cache."""

_MOST_COLUMNS = 200_000_000


def cutting_area(
    turn: ArrayLike,
    entry: ArrayLike,
    exit: ArrayLike,
    low: ArrayLike,
    high: ArrayLike,
    feed_per_tooth: float,
    tool: Tool,
) -> Floats:
    """Cutting area S of one tooth as it turns, on engaged arcs.

    Parameters
    ----------
    turn : (k,)
        Immersion angle of the tooth's tip in rad; behind the last arc its higher parts still cut.
    entry, exit : (m,)
        Engaged arcs, immersion angles in rad.
    low, high : (m,)
        Heights above the tip between which each arc is engaged, mm.
    feed_per_tooth : float
        mm.
    tool : Tool

    Returns
    -------
    (k,) float64
        mm^2: ``f_t sin(phi)`` over the height of the edge that is in the cut (S of dat-2025, eq. 6).
    """
    begin, end, bottom, top = (np.atleast_1d(np.asarray(v, dtype=float)) for v in (entry, exit, low, high))
    lag = np.tan(np.radians(tool.helix_deg)) / tool.radius
    tip = np.atleast_1d(np.asarray(turn, dtype=float))[:, None]
    if lag * float((top - bottom).max(initial=0.0)) < 1e-9:
        inside = (begin <= tip) & (tip <= end)
        out: Floats = np.where(inside, np.sin(tip) * (top - bottom), 0.0).sum(axis=1) * feed_per_tooth
        return out
    first = np.clip(tip - lag * top, begin, end)
    last = np.clip(tip - lag * bottom, begin, end)
    out = (np.cos(first) - np.cos(last)).sum(axis=1) * feed_per_tooth / lag
    return out


@dataclass(frozen=True, eq=False, slots=True)
class ToothMap(ReadOnlyArrays):
    """Cutting area of every edge as it turns, along a path.

    Parameters
    ----------
    area : (n, b) float64
        Cutting area S in mm^2 of each passing edge, by the angle of its tip.
    turn : (b,) float64
        Immersion angle of the tip in rad in the middle of each bin, from 0 to pi and the lag of the edge's upper end.
    begin : (n,) float64
        Time in s at which the tip of each edge is at immersion angle 0.
    place : (n, 2) float64
        Centre of the cutter then, mm.
    volume : float
        What the path removes, mm^3.
    columns : int
        Columns looked at.
    """

    area: Floats
    turn: Floats
    begin: Floats
    place: Floats
    volume: float
    columns: int

    def __len__(self) -> int:
        return len(self.area)

    @property
    def peak(self) -> Floats:
        """Largest cutting area of each edge in mm^2; (n,)."""
        out: Floats = self.area.max(axis=1, initial=0.0)
        return out


def tooth_map(
    path: RealPath,
    tool: Tool,
    stock: StockRegion,
    depth: float,
    *,
    grid: float = GRID,
    slices: int = SLICES,
    bins: int = BINS,
) -> ToothMap:
    """Cut a workpiece column by column.

    Parameters
    ----------
    path : RealPath
        Its short lines cut, all at one height.
    tool : Tool
    stock : StockRegion
    depth : float
        Axial depth of cut in mm.
    grid : float
        Size of a column in mm.
    slices : int
        Slices of the depth; without helix one is enough and is taken.
    bins : int
        Bins of the tip's angle.

    Returns
    -------
    ToothMap

    Raises
    ------
    UsageError
        If a number is not positive, or the feed is not known.
    InputError
        If the path needs too many columns.
    """
    if not (grid > 0 and depth > 0 and slices > 0 and bins > 0):
        raise UsageError("tooth map: grid, depth, slices and bins are all above 0")
    cut = np.flatnonzero(path.short)
    track = _Track.of(path, cut, tool)
    helix = np.tan(np.radians(tool.helix_deg)) / tool.radius
    count = slices if helix > 0 else 1
    height = (np.arange(count) + 0.5) * (depth / count)
    top = np.pi + helix * depth
    first, edges = track.numbers(top)
    bin_of = bins / top
    total = np.zeros(edges * bins)
    columns, removed = 0, 0
    for points in _tiles(track, stock, tool.radius, grid):
        progress.step()
        columns += len(points)
        when = track.reached(points, tool.radius)
        there = np.isfinite(when)
        points, when = points[there], when[there]
        seen = track.immersion(points, track.rows(when), when)
        for z in height:
            progress.step()
            edge, phi, passed = track.passed(points, when, seen, helix * z)
            edge, phi = edge[passed] - first, phi[passed]
            removed += len(edge)
            slot = np.clip(((phi + helix * z) * bin_of).astype(np.int64), 0, bins - 1)
            total += np.bincount(edge * bins + slot, minlength=edges * bins)
    # A slice of a column is spread over the angle that the edge turns along the slice's height.
    cell = grid * grid * depth / count
    area = total.reshape(edges, bins) * (cell * bin_of / tool.radius)
    if count > 1:
        area = _spread(area, helix * depth / count * bin_of)
    begin, place = track.passages(first + np.arange(edges))
    return ToothMap(area, (np.arange(bins) + 0.5) / bin_of, begin, place, removed * cell, columns)


def _spread(area: Floats, width: float) -> Floats:
    """Mean over `width` bins about each bin, by differences of the running sum."""
    bins = area.shape[1]
    total = np.concatenate([np.zeros((len(area), 1)), np.cumsum(area, axis=1)], axis=1)
    at = np.arange(bins)[:, None] + 0.5 + np.array([-1.0, 1.0]) * max(width, 1.0) / 2
    at = np.clip(at, 0.0, bins)
    k = np.minimum(at.astype(np.int64), bins - 1)
    value = total[:, k] + (total[:, k + 1] - total[:, k]) * (at - k)
    out: Floats = (value[..., 1] - value[..., 0]) / max(width, 1.0)
    return out


@dataclass(frozen=True, eq=False, slots=True)
class _Track:
    """Lines of the cutter's centre over time, and how far its teeth have turned.

    Angles count in the sense of the spindle. Edge e is the one whose tip is at immersion angle 0 when the phase
    (spindle less heading, in teeth) is e; headings are unwrapped, so that edges count on round every bend.
    """

    start: Floats
    end: Floats
    begin: Floats
    finish: Floats
    heading: Floats
    turn: float
    rate: float
    pitch: float

    @staticmethod
    def of(path: RealPath, cut: Ints, tool: Tool) -> _Track:
        start, end = path.toolpath.start[cut, :2], path.toolpath.end[cut, :2]
        begin, finish = path.begin[cut], path.end[cut]
        if not (finish > begin).all():
            raise UsageError("tooth map: a move that cuts has no feed in mm/min: state F in G94")
        d = end - start
        turn = -1.0 if tool.rotation == "clockwise" else 1.0
        heading = turn * np.unwrap(np.arctan2(d[:, 1], d[:, 0]))
        return _Track(start, end, begin, finish, heading, turn, tool.tooth_frequency, 2 * np.pi / tool.flutes)

    def numbers(self, top: float) -> tuple[int, int]:
        """First edge, and how many, that can cut anywhere along the path up to an angle `top` of the tip."""
        more = int(np.ceil((top + 2 * np.pi) / self.pitch)) + 1
        first = int(np.floor((self.begin * self.rate - self.heading / self.pitch).min())) - more
        last = int(np.ceil((self.finish * self.rate - self.heading / self.pitch).max())) + more
        return first, last - first + 1

    def passages(self, edge: Ints) -> tuple[Floats, Floats]:
        """When the tips of edges are at immersion angle 0, in s, and where the cutter's centre is then, mm."""
        time = np.stack([self.begin, self.finish], axis=1).ravel()
        heading = np.repeat(self.heading, 2)
        phase = np.maximum.accumulate(time * self.rate + (np.pi / 2 - heading) / self.pitch)
        t = np.interp(edge, phase, time)
        return t, self.at(self.rows(t), t)

    def rows(self, t: Floats) -> Ints:
        """Line that is run at times in s."""
        out: Ints = np.clip(np.searchsorted(self.begin, t, side="right") - 1, 0, len(self.begin) - 1)
        return out

    def at(self, row: Ints, t: Floats) -> Floats:
        """Centre in mm at times in s."""
        part = (t - self.begin[row]) / (self.finish[row] - self.begin[row])
        out: Floats = self.start[row] + part[:, None] * (self.end[row] - self.start[row])
        return out

    def immersion(self, points: Floats, row: Ints, t: Floats) -> Floats:
        """Immersion angle of the direction to places, -pi/2 to 3 pi/2."""
        x, y = (points - self.at(row, t)).T
        phi = self.turn * np.arctan2(y, x) - self.heading[row] + np.pi / 2
        out: Floats = np.mod(phi + np.pi / 2, 2 * np.pi) - np.pi / 2
        return out

    def passed(self, points: Floats, when: Floats, seen: Floats, lag: float) -> tuple[Ints, Floats, Bools]:
        """Edge that passes columns next, `lag` rad behind its tip: its number, immersion angle, and whether it does.

        `seen` is the immersion angle of the columns when they are first reached.
        """
        row, phi, t = self.rows(when), seen, when
        phase = self._phase(row, phi, t, lag)
        edge = np.ceil(phase - 1e-9)
        # The direction turns by a hundredth while a tooth comes round: each step leaves a hundredth of the last one.
        for _ in range(2):
            t = t + (edge - phase) / self.rate
            row = self.rows(t)
            phi = self.immersion(points, row, t)
            phase = self._phase(row, phi, t, lag)
        cuts = (phi >= 0.0) & (phi <= np.pi) & (t <= self.finish[row] + 1e-9)
        return edge.astype(np.int64), phi, cuts

    def _phase(self, row: Ints, phi: Floats, t: Floats, lag: float) -> Floats:
        out: Floats = t * self.rate + (np.pi / 2 - lag - self.heading[row] - phi) / self.pitch
        return out

    def reached(self, points: Floats, radius: float, stride: int = 16) -> Floats:
        """When the cutter's circle first reaches columns, in s; NaN where it never does, or is there from the start."""
        when = np.full(len(points), np.nan)
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        reach = float(np.hypot(*(points - middle).T).max())
        longest = float(np.hypot(*(self.end - self.start).T).max())
        near = np.flatnonzero(np.hypot(*(self.end - middle).T) <= radius + reach + longest)
        left = np.arange(len(points))
        for group in np.split(near, np.flatnonzero(np.diff(near) > 1) + 1):
            left = self._enter(points, left, group, radius, stride, stride * longest, when)
        return when

    def _enter(
        self, points: Floats, left: Ints, group: Ints, radius: float, stride: int, slack: float, when: Floats
    ) -> Ints:
        """Fill in `when` for columns that are reached on a row of lines; returns those that are not."""
        # Every stride-th vertex first: no line reaches a column that these pass by more than the slack.
        coarse = self.end[group[::stride]]
        if not len(coarse):
            return left
        distance = _distance2(points[left], coarse)
        close = distance <= (radius + slack) ** 2
        place = np.where(close.any(axis=1), np.argmax(close, axis=1) * stride - stride, len(group))
        place = np.maximum(place, 0)
        done = np.zeros(len(left), dtype=bool)
        going = np.flatnonzero(place < len(group))
        while len(going):
            progress.step()
            k = place[going, None] + np.arange(stride)
            line = group[np.minimum(k, len(group) - 1)]
            p = points[left[going]]
            away_x, away_y = p[:, :1] - self.end[line, 0], p[:, 1:] - self.end[line, 1]
            inside = away_x * away_x + away_y * away_y <= radius * radius
            first = np.argmax(inside, axis=1)
            hit = inside[np.arange(len(going)), first]
            rows, row = left[going[hit]], line[hit, first[hit]]
            when[rows] = self._entry(points[rows], row, radius)
            done[going[hit]] = True
            place[going] += stride
            going = going[~hit & (place[going] < len(group))]
        return left[~done]

    def _entry(self, points: Floats, row: Ints, radius: float) -> Floats:
        """When circles that hold places at the end of lines first did, in s; NaN where already at the start."""
        d, back = self.end[row] - self.start[row], points - self.start[row]
        a, b = (d * d).sum(axis=1), (back * d).sum(axis=1)
        c = (back * back).sum(axis=1) - radius * radius
        share = (b - np.sqrt(np.maximum(b * b - a * c, 0.0))) / a
        out: Floats = np.where(c > 0, self.begin[row] + share * (self.finish[row] - self.begin[row]), np.nan)
        return out


def _distance2(a: Floats, b: Floats) -> Floats:
    """Squared distances of all pairs, (n, m)."""
    x, y = a[:, :1] - b[:, 0], a[:, 1:] - b[:, 1]
    out: Floats = x * x + y * y
    return out


def _tiles(track: _Track, stock: StockRegion, radius: float, grid: float) -> Iterator[Floats]:
    """Columns of stock about the path, tile by tile; (k, 2) places of their middles in mm."""
    if stock.swept:
        raise InputError("tooth map: stock left by another program is not mapped: give it as a contour or an allowance")
    size = _TILE * grid
    points = np.vstack([track.start[:1], track.end])
    low, high = points.min(axis=0) - radius, points.max(axis=0) + radius
    count = np.ceil((high - low) / size).astype(np.int64)
    half = size / np.sqrt(2.0)
    # Tiles that the circle can reach, found from the path so that the cost goes by its length.
    every = max(1, int(size / 4 / max(float(np.hypot(*(track.end - track.start).T).max()), 1e-9)))
    around = np.arange(-int(np.ceil(radius / size)) - 1, int(np.ceil(radius / size)) + 2)
    home = np.unique(np.floor((points[::every] - low) / size).astype(np.int64), axis=0)
    tiles = (home[:, None, None, :] + np.stack(np.meshgrid(around, around), axis=-1)).reshape(-1, 2)
    tiles = tiles[((tiles >= 0) & (tiles < count)).all(axis=1)]
    # Numbers sort ten times as fast as rows.
    tiles = np.column_stack(np.divmod(np.unique(tiles[:, 0] * count[1] + tiles[:, 1]), count[1]))
    middle = low + (tiles + 0.5) * size
    search = None if stock.profile is None else FootPointSearch(stock.profile, margin=20.0 + abs(stock.allowance))
    over = np.full(len(tiles), -np.inf) if search is None else search.find(middle).distance - stock.allowance
    kept = over < half
    if kept.sum() * _TILE**2 > _MOST_COLUMNS:
        raise InputError(
            f"tooth map: {kept.sum() * _TILE**2 / 1e6:.0f} million columns of {grid:g} mm: take a larger grid or a "
            "shorter path"
        )
    offset = (np.arange(_TILE) + 0.5) * grid
    square = np.stack(np.meshgrid(offset, offset), axis=-1).reshape(-1, 2)
    for tile, sure in zip(tiles[kept], over[kept] < -half, strict=True):
        p = low + tile * size + square
        if search is not None and not sure:
            p = p[search.find(p).distance < stock.allowance]
        if len(p):
            yield p
