# SPDX-License-Identifier: LGPL-2.1-or-later
"""Foot points: the nearest point of a profile to each given point, exact and in blocks of cache size.

Newton's method starts from a seed. Few points are compared with the samples of the profile, group by group.
Many points take their seed from a grid over the profile's box, whose cells are compared in their stead as far as
points lie in them: the seed is the cell centre's own foot point, moved along to first order, which leaves two
Newton steps. Where a cell does not belong to one branch alone (near the medial axis, in narrow slots, at thin
walls) and wherever Newton does not settle, a point is compared itself, which also finds the nearest *other*
branch.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .profile import SMOOTH_ANGLE, Profile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

BLOCK = 8192
CONVERGED = 1e-11
"""Newton stops when its step along the profile is shorter than this, in mm."""

FEW = 2000
"""As many points are compared themselves; more go by the grid."""

_SAMPLES = 4000
_GROUP = 32
_CELLS = 65_000
_PAIRS = 60_000
_LAST_STEP = 1e-7
"""A Newton step shorter than this, in mm, leaves an error of its square over the radius of curvature."""


class Place(IntEnum):
    """Where on the profile a foot point lies."""

    SMOOTH = 0
    JOINT = 1
    """At a joint that turns away from the point: every direction between the two normals leads there."""
    END = 2
    """At the end of an open contour: the point lies beyond it."""


@dataclass(frozen=True, eq=False, slots=True)
class FootPoints:
    """Nearest points of a profile, one row a point.

    Parameters
    ----------
    span : (n,) int64
        Span of the profile.
    t : (n,) float64
        Local parameter, 0..1.
    foot : (n, 2) float64
        Foot point in mm.
    normal : (n, 2) float64
        Directional cosines at the foot. At a joint, the direction through the point.
    distance : (n,) float64
        Signed distance in mm along the normal, positive outside the material.
    place : (n,) int64
        `Place` of the foot.
    rival : (n,) float64
        How much farther, in mm, the nearest other branch of the profile is; inf where it is farther than the
        point's own distance from the profile or the search's margin, whichever is less.
    """

    span: Ints
    t: Floats
    foot: Floats
    normal: Floats
    distance: Floats
    place: Ints
    rival: Floats


    def replaced(self, rows: Ints, other: FootPoints, chosen: NDArray[np.bool_]) -> FootPoints:
        """Copy in which `rows` are the chosen rows of other foot points."""
        arrays = []
        for name in self.__slots__:
            array = getattr(self, name).copy()
            array[rows] = getattr(other, name)[chosen]
            arrays.append(array)
        return FootPoints(*arrays)


@dataclass(frozen=True, eq=False, slots=True)
class _Grid:
    """Cells over the profile's box; a cell's numbers are valid where it is known.

    The seed of a point (x, y) is ``t + tx x + ty y`` on the cell's span. A sure cell belongs to one branch.
    """

    low: Floats
    cell: float
    shape: tuple[int, int]
    known: Bools
    sure: Bools
    span: Ints
    t: Floats
    tx: Floats
    ty: Floats


class FootPointSearch:
    """Finds foot points on one profile.

    Parameters
    ----------
    profile : Profile
    margin : float
        Band in mm around the profile's box that the seed grid covers; other branches that are farther by more
        than this need not be found.
    """

    def __init__(self, profile: Profile, margin: float = 2.0) -> None:
        self.profile = profile
        size = float(profile.total.sum())
        self._spacing = max(size / _SAMPLES, 1e-4)
        span, t = profile.samples(self._spacing)
        self._closed = np.array([c.closed for c in profile.contours])
        # Where spans meet, the start of the later one stands for both.
        last = np.isin(span, profile.first[1:][~self._closed] - 1)
        kept = (t < 1.0) | last
        span, t = span[kept], t[kept]
        x, y, *_ = profile._derivatives(span, t)
        self._span, self._t, self._x, self._y = span, t, x, y
        self._margin = margin
        self._grid: _Grid | None = None
        self._make_groups()

    def find(self, points: Floats) -> FootPoints:
        """Foot points of the given points.

        Parameters
        ----------
        points : (n, 2) or (n, 3) float64
            mm; a third coordinate is ignored.

        Returns
        -------
        FootPoints
        """
        x = np.array(points[:, 0], dtype=np.float64)
        y = np.array(points[:, 1], dtype=np.float64)
        n = len(x)
        span = np.zeros(n, dtype=np.int64)
        t = np.empty(n)
        rival = np.full(n, np.inf)
        out = tuple(np.empty(n) for _ in range(5))
        if n <= FEW:
            rest = np.arange(n)
        else:
            rest = self._by_grid(x, y, span, t, out)
        if len(rest):
            span[rest], t[rest], rival[rest], exact = self._compare(x[rest], y[rest])
            for target, value in zip(out, exact, strict=True):
                target[rest] = value
        cx, cy, nx, ny, distance = out
        foot, normal = np.stack([cx, cy], axis=1), np.stack([nx, ny], axis=1)
        place = self._resolve_joints(x, y, span, t, foot, normal, distance)
        return FootPoints(span, t, foot, normal, distance, place, rival)

    def on_the_side_of(self, points: Floats, normals: Floats, feet: FootPoints) -> FootPoints:
        """Move foot points to the branch that faces the way the measured normals do.

        Parameters
        ----------
        points : (n, 2) float64
            mm.
        normals : (n, 2) float64
            Measured normals; rows of length 0 are left alone.
        feet : FootPoints
            What `find` gave for the points.

        Returns
        -------
        FootPoints
            Rows whose normal disagreed now lie on the nearest facing branch, where one was found within
            2 mm along the measured normal.
        """
        length = np.hypot(*normals.T)
        unit = normals / np.maximum(length, 1e-12)[:, None]
        wrong = np.flatnonzero((length > 0.1) & ((unit * feet.normal).sum(axis=1) < 0.5))
        for shift in (0.25, 0.5, 1.0, 2.0):
            if not len(wrong):
                break
            out = self.find(points[wrong] + shift * unit[wrong])
            facing = ((unit[wrong] * out.normal).sum(axis=1) > 0.7) & (out.place == Place.SMOOTH)
            rows = wrong[facing]
            if len(rows):
                span, t, settled, values = self._newton(
                    points[rows, 0], points[rows, 1], out.span[facing], out.t[facing]
                )
                cx, cy, nx, ny, distance = values
                keep = settled & (np.abs(distance) <= 2.0)
                back = rows[keep]
                foot = np.stack([cx, cy], axis=1)
                normal = np.stack([nx, ny], axis=1)
                smooth = np.full(len(rows), int(Place.SMOOTH))
                alone = np.full(len(rows), np.inf)
                feet = feet.replaced(back, FootPoints(span, t, foot, normal, distance, smooth, alone), keep)
            wrong = wrong[~facing]
        return feet

    def _newton(
        self, x: Floats, y: Floats, span: Ints, t: Floats, steps: int = 6
    ) -> tuple[Ints, Floats, NDArray[np.bool_], tuple[Floats, ...]]:
        """Newton's method along the contour, crossing from span to span.

        Returns span, t, whether it settled on a minimum, and (cx, cy, nx, ny, signed distance).
        """
        profile = self.profile
        span, t = span.copy(), t.copy()
        rows: NDArray[np.intp] | slice = slice(None)
        settled = np.zeros(len(x), dtype=bool)
        values = tuple(np.empty(len(x)) for _ in range(5))
        for step in range(steps + 1):
            here, at, qx, qy = span[rows], t[rows], x[rows], y[rows]
            cx, cy, dx, dy, ddx, ddy = profile._derivatives(here, at)
            ex, ey = cx - qx, cy - qy
            speed2 = dx * dx + dy * dy
            slope = ex * dx + ey * dy
            bend = speed2 + ex * ddx + ey * ddy
            # Away from a minimum the plain gradient of the distance still points the right way.
            floor = 0.1 if step < 10 else 1e-4
            move = -slope / np.where(bend > floor * speed2, bend, speed2)
            wanted = at + move
            inside = np.clip(wanted, 0.0, 1.0)
            stuck = inside == at
            done = (np.abs(inside - at) * np.sqrt(speed2) < CONVERGED) & (bend > 0)
            beyond = wanted - inside
            crossing = done & (beyond != 0)
            speed = np.sqrt(speed2)
            nx, ny = dy / speed, -dx / speed
            for target, value in zip(values, (cx, cy, nx, ny, -(ex * nx + ey * ny)), strict=True):
                target[rows] = value
            if step == steps:
                settled[rows] = done & ~crossing
                break
            new_span = here
            if crossing.any():
                # The minimum lies past the span's end: go on in the neighbour, unless that pushes back.
                c = np.flatnonzero(crossing & stuck)
                way = np.sign(beyond[c]).astype(np.int64)
                other = profile.neighbour(here[c], way)
                entry = np.where(way > 0, 0.0, 1.0)
                _, _, fx, fy, _, _ = profile._derivatives(other, entry)
                push = (ex[c] * fx + ey[c] * fy) * way
                go = (push < 0) & (other != here[c])
                new_span = here.copy()
                new_span[c[go]] = other[go]
                inside[c[go]] = entry[go]
                crossing[c[~go]] = False
            span[rows], t[rows] = new_span, inside
            finished = done & ~crossing
            index = np.arange(len(x))[rows]
            settled[index[finished]] = True
            rest = index[~finished]
            if not len(rest):
                break
            if len(rest) < len(index):
                rows = rest
        return span, t, settled, values

    def _make_groups(self) -> None:
        """Put neighbouring samples into groups, each with one more sample at either side, and a circle round it."""
        profile = self.profile
        members, valid = [], []
        ends = np.searchsorted(self._span, profile.first)
        for k, (a, b) in enumerate(zip(ends[:-1], ends[1:], strict=True)):
            count = -(-(b - a) // _GROUP)
            index = a + np.arange(count)[:, None] * _GROUP + np.arange(-1, _GROUP + 1)[None, :]
            valid.append(index[:, 1:-1] < b)
            left, right = (b - 1, a) if self._closed[k] else (a, b - 1)
            index = np.where(index < a, left, np.where(index == b, right, np.minimum(index, b - 1)))
            members.append(index)
        self._member, self._valid = np.concatenate(members), np.concatenate(valid)
        self._sample_x, self._sample_y = self._x[self._member], self._y[self._member]
        self._group_x = (self._sample_x.min(axis=1) + self._sample_x.max(axis=1)) / 2
        self._group_y = (self._sample_y.min(axis=1) + self._sample_y.max(axis=1)) / 2
        away = np.hypot(self._sample_x - self._group_x[:, None], self._sample_y - self._group_y[:, None])
        self._group_r = away.max(axis=1)

    def _compare(self, x: Floats, y: Floats, extra: float = 0.0) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
        """Foot points by comparing with all groups of samples: the nearest branch, and the gap to the next one.

        Other branches are seen up to twice the distance (1 mm at least and the search's margin at most beyond
        it), and `extra` farther.
        """
        n, groups = len(x), len(self._group_x)
        span = np.zeros(n, dtype=np.int64)
        t, rival = np.empty(n), np.empty(n)
        values = tuple(np.empty(n) for _ in range(5))
        chunk = max(1, 500_000 // groups)
        for a in range(0, n, chunk):
            rows = slice(a, min(a + chunk, n))
            px, py = x[rows], y[rows]
            away = np.hypot(px[:, None] - self._group_x, py[:, None] - self._group_y)
            nearest = (away + self._group_r).min(axis=1) + 2 * self._spacing
            limit = nearest + np.clip(nearest, 1.0, max(1.0, self._margin)) + extra
            point, group = np.nonzero(away - self._group_r <= limit[:, None])
            first = np.searchsorted(point, np.arange(len(px) + 1))
            # Points far away meet every group: take as many at a time as fit the cache.
            cut = 0
            while cut < len(px):
                end = max(cut + 1, int(np.searchsorted(first, first[cut] + _PAIRS, side="right")) - 1)
                pairs = slice(first[cut], first[end])
                part = slice(a + cut, a + end)
                span[part], t[part], rival[part], best = self._compare_groups(
                    x[part], y[part], point[pairs] - cut, group[pairs], extra
                )
                for target, value in zip(values, best, strict=True):
                    target[part] = value
                cut = end
        return span, t, rival, values

    def _compare_groups(
        self, x: Floats, y: Floats, point: Ints, group: Ints, extra: float
    ) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
        """The same for pairs of a point and a group, sorted by point, at least one pair a point."""
        d2 = (self._sample_x[group] - x[point, None]) ** 2 + (self._sample_y[group] - y[point, None]) ** 2
        first = np.searchsorted(point, np.arange(len(x)))
        nearest = np.sqrt(np.minimum.reduceat(d2.min(axis=1), first))
        # A branch whose sample is this much farther may still come nearest between samples.
        slack = nearest + 2 * self._spacing
        window = (slack + np.clip(slack, 1.0, max(1.0, self._margin)) + extra) ** 2
        inner = d2[:, 1:-1]
        lowest = (inner <= d2[:, :-2]) & (inner <= d2[:, 2:]) & (inner <= window[point, None])
        pair, column = np.nonzero(lowest & self._valid[group])
        point, sample = point[pair], self._member[group[pair], column + 1]
        span, t, settled, values = self._newton(x[point], y[point], self._span[sample], self._t[sample], steps=40)
        gap = np.hypot(values[0] - x[point], values[1] - y[point])
        gap = np.where(settled, gap, gap + 1e-9)
        order = np.lexsort((gap, point))
        head = order[np.searchsorted(point[order], np.arange(len(x)))]
        # Another branch: a foot at a different place whose way there leads over farther points.
        main = head[point]
        contour = self.profile.contour[span]
        several = np.flatnonzero(np.bincount(point, minlength=len(x))[point] > 1)
        rival = np.full(len(x), np.inf)
        if len(several):
            s = np.zeros(len(span))
            s[several] = self.profile.arc_length(span[several], t[several])
            along = self._way(s, s[main], contour)
            other = (contour != contour[main]) | (along > 1e-6 + 1e-3 * self._spacing)
            np.minimum.at(rival, point[other], (gap - gap[main])[other])
        return span[head], t[head], np.maximum(rival, 0.0), tuple(v[head] for v in values)

    def _way(self, a: Floats, b: Floats, contour: Ints) -> Floats:
        """Distance along the contour between two arc lengths, the short way round."""
        along = np.abs(a - b)
        return np.where(self._closed[contour], np.minimum(along, self.profile.total[contour] - along), along)

    def _make_grid(self) -> _Grid:
        low = np.array([self._x.min(), self._y.min()]) - self._margin
        high = np.array([self._x.max(), self._y.max()]) + self._margin
        cell = float(np.sqrt(np.prod(high - low) / _CELLS))
        shape = (int((high[0] - low[0]) / cell) + 1, int((high[1] - low[1]) / cell) + 1)
        n = shape[0] * shape[1] + 1
        known, sure = np.zeros(n, dtype=bool), np.zeros(n, dtype=bool)
        # The last cell stands for everything outside: known, and never sure.
        known[-1] = True
        return _Grid(
            low, cell, shape, known, sure, np.zeros(n, dtype=np.int64), np.zeros(n), np.zeros(n), np.zeros(n)
        )

    def _learn(self, grid: _Grid, cells: Ints) -> None:
        """Foot points of cell centres, and whether all points of the cell share their branch."""
        profile = self.profile
        x = grid.low[0] + (cells // grid.shape[1] + 0.5) * grid.cell
        y = grid.low[1] + (cells % grid.shape[1] + 0.5) * grid.cell
        half = grid.cell * np.sqrt(0.5)
        span, t, rival, values = self._compare(x, y, extra=4 * half)
        cx, cy, dx, dy, ddx, ddy = profile._derivatives(span, t)
        speed2 = dx * dx + dy * dy
        bend = speed2 + (cx - x) * ddx + (cy - y) * ddy
        # From centre to corner of the cell, either branch's distance changes by half a diagonal at most.
        reach = np.clip(np.abs(values[4]) + half, 0.02, self._margin)
        sure = (rival > 2 * half + reach) & (bend > 0.25 * speed2)
        bend = np.where(sure, bend, 1.0)
        grid.span[cells], grid.tx[cells], grid.ty[cells] = span, dx / bend, dy / bend
        grid.t[cells] = t - (x * dx + y * dy) / bend
        grid.sure[cells] = sure
        grid.known[cells] = True

    def _by_grid(self, x: Floats, y: Floats, span: Ints, t: Floats, out: tuple[Floats, ...]) -> Ints:
        """Foot points by seeds from the grid, in place; returns the points that must be compared themselves."""
        if self._grid is None:
            self._grid = self._make_grid()
        grid = self._grid
        n = len(x)
        cell = np.empty(n, dtype=np.int64)
        for a in range(0, n, BLOCK):
            rows = slice(a, a + BLOCK)
            i, j = (x[rows] - grid.low[0]) / grid.cell, (y[rows] - grid.low[1]) / grid.cell
            outside = (i < 0) | (i >= grid.shape[0]) | (j < 0) | (j >= grid.shape[1])
            if outside.any():
                i, j = np.where(outside, 0.0, i), np.where(outside, 0.0, j)
            flat = i.astype(np.int64) * grid.shape[1] + j.astype(np.int64)
            if outside.any():
                flat[outside] = len(grid.known) - 1
            cell[rows] = flat
        touched = np.zeros(len(grid.known), dtype=bool)
        touched[cell] = True
        new = np.flatnonzero(touched & ~grid.known)
        if len(new) > n // 2:
            return np.arange(n)
        if len(new):
            self._learn(grid, new)
        bad = []
        for a in range(0, n, BLOCK):
            rows = slice(a, min(a + BLOCK, n))
            bad.append(a + self._two_steps(grid, cell[rows], x[rows], y[rows], rows, span, t, out))
        rest = np.concatenate(bad)
        sure = grid.sure[cell[rest]]
        unsettled = []
        for a in range(0, len(rest), BLOCK):
            some = rest[a : a + BLOCK][sure[a : a + BLOCK]]
            new_span, new_t, settled, exact = self._newton(x[some], y[some], span[some], t[some], steps=30)
            back = some[settled]
            span[back], t[back] = new_span[settled], new_t[settled]
            for target, value in zip(out, exact, strict=True):
                target[back] = value[settled]
            unsettled.append(some[~settled])
        return np.concatenate([rest[~sure], *unsettled])

    def _two_steps(
        self,
        grid: _Grid,
        cell: Ints,
        x: Floats,
        y: Floats,
        rows: slice,
        span: Ints,
        t: Floats,
        out: tuple[Floats, ...],
    ) -> Ints:
        """Newton's method for one block, in place; returns the rows of the block that are not done.

        Those hold a seed.
        """
        here = grid.span.take(cell)
        at = grid.tx.take(cell)
        at *= x
        at += grid.ty.take(cell) * y
        at += grid.t.take(cell)
        self._carry_over(here, at)
        step, *_ = self._step(here, at, x, y)
        at += step
        step, shaky, cx, cy, dx, dy, ddx, ddy, speed2 = self._step(here, at, x, y)
        end = at + step
        # A comparison with NaN is false, so that such points count as bad.
        good = (end > 0.0) & (end < 1.0) & (step * step * speed2 < _LAST_STEP**2) & ~shaky
        good &= grid.sure.take(cell)
        # The last step by Taylor's series.
        ddx *= step
        ddy *= step
        cx += step * (dx + 0.5 * ddx)
        cy += step * (dy + 0.5 * ddy)
        dx += ddx
        dy += ddy
        speed = np.sqrt(dx * dx + dy * dy)
        dy /= speed
        dx /= -speed
        span[rows], t[rows] = here, end
        values = (cx, cy, dy, dx, (x - cx) * dy + (y - cy) * dx)
        for target, value in zip(out, values, strict=True):
            target[rows] = value
        bad = np.flatnonzero(~good)
        t[rows.start + bad] = np.clip(np.nan_to_num(end[bad]), 0.0, 1.0)
        return bad

    def _carry_over(self, span: Ints, t: Floats) -> None:
        """Take seeds past the end of their span on into the spans that follow, in place."""
        past = np.flatnonzero((t < 0.0) | (t > 1.0))
        if not len(past):
            return
        profile = self.profile
        here = span[past]
        contour = profile.contour[here]
        s = profile.begin[here] + t[past] * profile.length[here]
        total = profile.total[contour]
        s = np.where(self._closed[contour], np.mod(s, total), np.clip(s, 0.0, total))
        # Arc lengths count from each contour's start; laid end to end they increase through all spans.
        before = np.concatenate([[0.0], np.cumsum(profile.total)])
        begin = profile.begin + before[profile.contour]
        there = np.searchsorted(begin, s + before[contour], side="right") - 1
        there = np.clip(there, profile.first[contour], profile.first[contour + 1] - 1)
        span[past] = there
        t[past] = np.clip((s - profile.begin[there]) / profile.length[there], 0.0, 1.0)

    def _step(self, span: Ints, t: Floats, x: Floats, y: Floats) -> tuple[Any, ...]:
        """One Newton step, whether it cannot be trusted, and the curve's derivatives with the squared speed."""
        cx, cy, dx, dy, ddx, ddy = self.profile._derivatives(span, t)
        ex, ey = cx - x, cy - y
        slope = ex * dx
        slope += ey * dy
        speed2 = dx * dx
        speed2 += dy * dy
        bend = ex
        bend *= ddx
        ey *= ddy
        bend += ey
        bend += speed2
        shaky = bend < 0.1 * speed2
        np.divide(slope, bend, out=slope, where=~shaky)
        np.negative(slope, out=slope)
        return slope, shaky, cx, cy, dx, dy, ddx, ddy, speed2

    def _resolve_joints(
        self, x: Floats, y: Floats, span: Ints, t: Floats, foot: Floats, normal: Floats, distance: Floats
    ) -> Ints:
        """Mark feet at joints and ends; there the normal leads through the point. Works in place."""
        profile = self.profile
        place = np.zeros(len(x), dtype=np.int64)
        edge = np.flatnonzero((t == 0.0) | (t == 1.0))
        if not len(edge):
            return place
        at_end = t[edge] == 1.0
        before = np.where(at_end, span[edge], profile.neighbour(span[edge], -1))
        after = np.where(at_end, profile.neighbour(span[edge], 1), span[edge])
        turn = profile.turn[before]
        free = before == after
        single = free & self._closed[profile.contour[before]]
        turn = np.where(free & ~single, np.nan, turn)
        open_end = np.isnan(turn)
        ex, ey = x[edge] - foot[edge, 0], y[edge] - foot[edge, 1]
        gap = np.hypot(ex, ey)
        ones, zeros = np.ones(len(edge)), np.zeros(len(edge))
        n0 = profile.normals(before, ones)
        n1 = profile.normals(after, zeros)
        # A point beyond an open end has a part along the tangent.
        along = np.where(
            at_end, -ex * normal[edge, 1] + ey * normal[edge, 0], ex * normal[edge, 1] - ey * normal[edge, 0]
        )
        place[edge[open_end & (along > CONVERGED * 10)]] = Place.END
        kink = ~open_end & (np.abs(np.nan_to_num(turn)) > SMOOTH_ANGLE)
        rows = np.flatnonzero(kink)
        if len(rows):
            # Where the joint bulges towards the point, the point sees it from outside when turn > 0.
            sign = np.where(turn[rows] > 0, 1.0, -1.0)
            middle = n0[rows] + n1[rows]
            middle /= np.maximum(np.hypot(*middle.T), 1e-300)[:, None]
            clear = gap[rows] > 1e-9
            direction = np.stack([ex[rows], ey[rows]], 1) / np.where(clear, gap[rows], 1.0)[:, None]
            normal[edge[rows]] = np.where(clear[:, None], sign[:, None] * direction, middle)
            distance[edge[rows]] = sign * gap[rows]
            place[edge[rows]] = Place.JOINT
        return place
