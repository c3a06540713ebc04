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

from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import ArrayLike, NDArray

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

from .profile import SMOOTH_ANGLE, Profile

BLOCK = 8192
"""So many points at a time: their columns stay in the cache."""

CONVERGED = 1e-11
"""Newton stops when its step along the profile is shorter than this, in mm."""

FEW = 2000
"""As many points are compared themselves; more go by the grid."""

FACET_ANGLE = 0.02
"""Joints that turn less, in rad, are facets: only points right beside them have two feet."""

RIVAL = 0.1
"""Another branch that is no more than this farther, in mm, is always told."""

_SAMPLES = 4000
_GROUP = 16
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
        How much farther, in mm, the nearest other branch of the profile is; inf where that is more than the
        point's own distance from the profile or the search's margin, and more than `RIVAL`, and where it was not
        asked for.
    """

    span: Ints
    t: Floats
    foot: Floats
    normal: Floats
    distance: Floats
    place: Ints
    rival: Floats

    @staticmethod
    def none(count: int) -> FootPoints:
        """So many rows to be replaced."""
        number, length, flat = np.zeros(count, dtype=np.int64), np.zeros(count), np.zeros((count, 2))
        return FootPoints(number, length, flat, flat, length, number, length)

    def at(self, rows: Ints) -> FootPoints:
        """Some of the rows."""
        return FootPoints(*(getattr(self, name)[rows] for name in self.__slots__))

    def replaced(self, rows: Ints, other: FootPoints, chosen: Bools | slice) -> FootPoints:
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


class _Steps:
    """The profile in short steps, in groups of neighbours with a circle round each; what searches on it share."""

    _made: WeakKeyDictionary[Profile, _Steps] = WeakKeyDictionary()

    @classmethod
    def of(cls, profile: Profile) -> _Steps:
        """Those of a profile, made once; they do not keep it alive."""
        steps = cls._made.get(profile)
        if steps is None:
            steps = cls._made[profile] = cls(profile)
        return steps

    def __init__(self, profile: Profile) -> None:
        self.spacing = max(float(profile.total.sum()) / _SAMPLES, 1e-4)
        span, t = profile.samples(self.spacing)
        self.sections = profile.sections
        self.closed = np.array([c.closed for c in profile.contours])
        # From each sample to the next one of its span.
        step = t < 1.0
        self.span, self.t, self.t_end = span[step], t[step], t[np.flatnonzero(step) + 1]
        self.grids: dict[float, _Grid] = {}
        self.parts: dict[tuple[int, ...], tuple[Profile, Ints]] = {}
        x, y, dx, dy, ddx, ddy = profile._derivatives(self.span, self.t)
        speed = np.hypot(dx, dy)
        self.x, self.y, self.dx, self.dy = x, y, dx / speed, dy / speed
        bend = (dx * ddy - dy * ddx) / speed**3
        x1, y1, dx, dy, *_ = profile._derivatives(self.span, self.t_end)
        speed = np.hypot(dx, dy)
        self.x_end, self.y_end, self.dx_end, self.dy_end = x1, y1, dx / speed, dy / speed
        before = np.arange(-1, len(x) - 1)
        ends = np.searchsorted(self.span, profile.first)
        before[ends[:-1]] = np.where(self.closed, ends[1:] - 1, ends[:-1])
        self.dx_before, self.dy_before = self.dx_end[before], self.dy_end[before]
        # Where an open contour opens and closes.
        self.opens, self.closes = np.zeros(len(x), dtype=bool), np.zeros(len(x), dtype=bool)
        self.opens[ends[:-1][~self.closed]] = True
        self.closes[ends[1:][~self.closed] - 1] = True
        # How sharply the contour bends to either side, in 1/mm; a corner has no radius at all. Past an acute one
        # a point sees both sides from anywhere.
        turn = np.where(self.t == 0.0, np.nan_to_num(profile.turn[self.span[before]]), 0.0)
        turn = np.where(self.opens, 0.0, turn)
        bend = np.where(np.abs(turn) > FACET_ANGLE, np.copysign(np.inf, turn), bend)
        acute = np.abs(turn) > np.pi / 2
        self.bend_left = np.where(acute, np.inf, np.maximum(bend, 0.0))
        self.bend_right = np.where(acute, np.inf, np.maximum(-bend, 0.0))
        self.faceted = bool(((np.abs(turn) > SMOOTH_ANGLE) & (np.abs(turn) <= FACET_ANGLE)).any())
        rows = []
        for a, b in zip(ends[:-1], ends[1:], strict=True):
            index = np.arange(a, a + -(-(b - a) // _GROUP) * _GROUP).reshape(-1, _GROUP)
            rows.append(np.where(index < b, index, -1))
        member = np.concatenate(rows)
        self.filled = member >= 0
        self.member = np.where(self.filled, member, member[:, :1])
        m = self.member
        self.step_x, self.step_y = x[m], y[m]
        all_x, all_y = np.concatenate([x[m], x1[m]], axis=1), np.concatenate([y[m], y1[m]], axis=1)
        self.group_x = (all_x.min(axis=1) + all_x.max(axis=1)) / 2
        self.group_y = (all_y.min(axis=1) + all_y.max(axis=1)) / 2
        away = np.hypot(all_x - self.group_x[:, None], all_y - self.group_y[:, None])
        self.group_r = away.max(axis=1)


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
        self._margin = margin
        # Searches whose bands are almost as wide share a grid.
        self._band = 2.0 ** np.ceil(np.log2(max(margin, 1.0)))
        self._steps = _Steps.of(profile)

    def find(self, points: Floats, *, rivals: bool = False) -> FootPoints:
        """Foot points of the given points.

        Parameters
        ----------
        points : (n, 2) or (n, 3) float64
            mm. Heights choose among the steps of a wall; without one, (NaN or no column), the nearest contour does.
        rivals : bool
            Whether `FootPoints.rival` is wanted: it takes comparing with more of the profile, several times as long
            for points far from it. Else it is inf throughout.

        Returns
        -------
        FootPoints
        """
        if len(self._steps.sections.bounds) and points.shape[1] > 2:
            feet = FootPoints.none(len(points))
            for k, rows in self._steps.sections.split(points):
                search, spans = self._of_section(k)
                found = search.find(points[rows, :2], rivals=rivals)
                feet = feet.replaced(rows, replace(found, span=spans[found.span]), slice(None))
            return feet
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
            span[rest], t[rest], rival[rest], exact = self._compare(x[rest], y[rest], rivals=rivals)
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
        points : (n, 2) or (n, 3) float64
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
        if len(self._steps.sections.bounds) and points.shape[1] > 2:
            for k, rows in self._steps.sections.split(points):
                search, spans = self._of_section(k)
                number = np.full(self.profile.spans, -1)
                number[spans] = np.arange(len(spans))
                here = feet.at(rows)
                own = replace(here, span=number[here.span])
                found = search.on_the_side_of(points[rows, :2], normals[rows], own)
                feet = feet.replaced(rows, replace(found, span=spans[found.span]), slice(None))
            return feet
        length = np.hypot(*normals.T)
        unit = normals / np.maximum(length, 1e-12)[:, None]
        points = points[:, :2]
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

    def among(self, contours: ArrayLike) -> tuple[FootPointSearch, Ints]:
        """Search among some of the contours alone, and the spans of the profile that its spans are."""
        numbers = np.unique(contours)
        parts, key = self._steps.parts, tuple(numbers.tolist())
        if key not in parts:
            parts[key] = self.profile.part(numbers), np.flatnonzero(np.isin(self.profile.contour, numbers))
        part, spans = parts[key]
        return FootPointSearch(part, self._margin), spans

    def _of_section(self, number: int) -> tuple[FootPointSearch, Ints]:
        """Search among the contours of one section."""
        every = np.arange(len(self.profile.contours))
        return self.among(every if number < 0 else self._steps.sections.contours[number])

    def _newton(
        self, x: Floats, y: Floats, span: Ints, t: Floats, steps: int = 6
    ) -> tuple[Ints, Floats, Bools, tuple[Floats, ...]]:
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

    def _compare(
        self, x: Floats, y: Floats, extra: float = 0.0, *, rivals: bool = True
    ) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
        """Foot points by comparing with all groups of samples: the nearest branch, and the gap to the next one.

        Other branches are seen up to twice the distance (at least `RIVAL` and at most the search's margin
        beyond it), and `extra` farther; without `rivals` none is. With `extra`, the values end with the sharpest
        bends to the left and to the right so far.
        """
        n, groups = len(x), len(self._steps.group_x)
        span = np.zeros(n, dtype=np.int64)
        t, rival = np.empty(n), np.empty(n)
        values = tuple(np.empty(n) for _ in range(7 if extra else 5))
        chunk = max(1, 500_000 // groups)
        for a in range(0, n, chunk):
            progress.step()
            rows = slice(a, min(a + chunk, n))
            px, py = x[rows], y[rows]
            # Several times as fast as np.hypot, whose care about overflow is not needed.
            away = np.sqrt((px[:, None] - self._steps.group_x) ** 2 + (py[:, None] - self._steps.group_y) ** 2)
            nearest = (away + self._steps.group_r).min(axis=1) + 2 * self._steps.spacing
            limit = self._window(nearest, extra, rivals)
            point, group = np.nonzero(away - self._steps.group_r <= limit[:, None])
            first = np.searchsorted(point, np.arange(len(px) + 1))
            # Points far away meet every group: take as many at a time as fit the cache.
            cut = 0
            while cut < len(px):
                end = max(cut + 1, int(np.searchsorted(first, first[cut] + _PAIRS, side="right")) - 1)
                pairs = slice(first[cut], first[end])
                part = slice(a + cut, a + end)
                span[part], t[part], rival[part], best = self._compare_groups(
                    x[part], y[part], point[pairs] - cut, group[pairs], extra, rivals
                )
                for target, value in zip(values, best, strict=True):
                    target[part] = value
                cut = end
        return span, t, rival, values

    def _window(self, nearest: Floats, extra: float, rivals: bool) -> Floats:
        """How far samples are looked at by points whose nearest one is so far."""
        if not rivals:
            return nearest + extra
        margin = self._band if extra else self._margin
        out: Floats = nearest + np.clip(nearest, RIVAL, max(RIVAL, margin)) + extra
        return out

    def _compare_groups(
        self, x: Floats, y: Floats, point: Ints, group: Ints, extra: float, rivals: bool
    ) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
        """The same for pairs of a point and a group, sorted by point, at least one pair a point.

        A minimum lies within a step if the distance falls at its start and rises at its end, or at its start if
        the distance falls before and rises after.
        """
        steps = self._steps
        d2 = (steps.step_x[group] - x[point, None]) ** 2 + (steps.step_y[group] - y[point, None]) ** 2
        first = np.searchsorted(point, np.arange(len(x)))
        nearest = np.sqrt(np.minimum.reduceat(d2.min(axis=1), first))
        # A branch whose sample is this much farther may still come nearest between samples.
        window = self._window(nearest + 2 * steps.spacing, extra, rivals)
        pair, column = np.nonzero((d2 <= (window**2)[point, None]) & steps.filled[group])
        step = steps.member[group[pair], column]
        curved = self._bends_at(step, point[pair], len(x)) if extra else None
        px, py = x[point[pair]], y[point[pair]]
        ex, ey = steps.x[step] - px, steps.y[step] - py
        # Both sides of a joint must not be missed for rounding; found twice is found once.
        little = 1e-9 * (1.0 + nearest)[point[pair]]
        slope = ex * steps.dx[step] + ey * steps.dy[step]
        slope_before = ex * steps.dx_before[step] + ey * steps.dy_before[step]
        slope_end = (steps.x_end[step] - px) * steps.dx_end[step] + (steps.y_end[step] - py) * steps.dy_end[step]
        at_start = (slope >= -little) & ((slope_before <= little) | steps.opens[step])
        at_end = (slope_end <= little) & steps.closes[step]
        kept = np.flatnonzero(((slope < 0) & (slope_end > 0)) | at_start | at_end)
        step = step[kept]
        seed = (steps.t[step] + steps.t_end[step]) / 2
        seed = np.where(at_start[kept], steps.t[step], seed)
        seed = np.where(at_end[kept], steps.t_end[step], seed)
        point = point[pair][kept]
        span, t, settled, values = self._newton(x[point], y[point], steps.span[step], seed, steps=40)
        gap = np.hypot(values[0] - x[point], values[1] - y[point])
        gap = np.where(settled, gap, gap + 1e-9)
        order = np.lexsort((gap, point))
        head = order[np.searchsorted(point[order], np.arange(len(x)))]
        # Another branch: a foot at a different place whose way there leads over farther points.
        main = head[point]
        contour = self.profile.contour[span]
        rival = np.full(len(x), np.inf)
        several = np.flatnonzero(np.bincount(point, minlength=len(x))[point] > 1) if rivals else ()
        if len(several):
            s = np.zeros(len(span))
            s[several] = self.profile.arc_length(span[several], t[several])
            along = self._way(s, s[main], contour)
            other = (contour != contour[main]) | (along > 1e-6 + 1e-3 * steps.spacing)
            np.minimum.at(rival, point[other], (gap - gap[main])[other])
        best = tuple(v[head] for v in values)
        if curved is not None:
            best += curved
        return span[head], t[head], np.maximum(rival, 0.0), best

    def _bends_at(self, step: Ints, point: Ints, count: int) -> tuple[Floats, Floats]:
        """Sharpest bends to the left and to the right, both positive in 1/mm, among the steps of each point."""
        first = np.searchsorted(point, np.arange(count))
        left: Floats = np.maximum.reduceat(self._steps.bend_left[step], first)
        right: Floats = np.maximum.reduceat(self._steps.bend_right[step], first)
        return left, right

    def _way(self, a: Floats, b: Floats, contour: Ints) -> Floats:
        """Distance along the contour between two arc lengths, the short way round."""
        along = np.abs(a - b)
        return np.where(self._steps.closed[contour], np.minimum(along, self.profile.total[contour] - along), along)

    def _make_grid(self) -> _Grid:
        x, y = [self._steps.x, self._steps.x_end], [self._steps.y, self._steps.y_end]
        low = np.array([np.min(x), np.min(y)]) - self._band
        high = np.array([np.max(x), np.max(y)]) + self._band
        cell = float(np.sqrt(np.prod(high - low) / _CELLS))
        shape = (int((high[0] - low[0]) / cell) + 1, int((high[1] - low[1]) / cell) + 1)
        n = shape[0] * shape[1] + 1
        known, sure = np.zeros(n, dtype=bool), np.zeros(n, dtype=bool)
        # The last cell stands for everything outside: known, and never sure.
        known[-1] = True
        return _Grid(low, cell, shape, known, sure, np.zeros(n, dtype=np.int64), np.zeros(n), np.zeros(n), np.zeros(n))

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
        reach = np.clip(np.abs(values[4]) + half, RIVAL, self._band)
        sure = (rival > 2 * half + reach) & (bend > 0.25 * speed2)
        # No point of the cell may come near the centre of a bend towards it: there branches divide.
        distance, left, right = values[4:]
        far = np.abs(distance) + 2 * half + reach
        sure &= ~((distance < half) & (left * far > 0.75)) & ~((distance > -half) & (right * far > 0.75))
        bend = np.where(sure, bend, 1.0)
        grid.span[cells], grid.tx[cells], grid.ty[cells] = span, dx / bend, dy / bend
        grid.t[cells] = t - (x * dx + y * dy) / bend
        grid.sure[cells] = sure
        grid.known[cells] = True

    def _by_grid(self, x: Floats, y: Floats, span: Ints, t: Floats, out: tuple[Floats, ...]) -> Ints:
        """Foot points by seeds from the grid, in place; returns the points that must be compared themselves."""
        grids = self._steps.grids
        if self._band not in grids:
            grids[self._band] = self._make_grid()
        grid = grids[self._band]
        n = len(x)
        cell = np.empty(n, dtype=np.int64)
        for a in range(0, n, BLOCK):
            progress.step()
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
            progress.step()
            rows = slice(a, min(a + BLOCK, n))
            bad.append(a + self._two_steps(grid, cell[rows], x[rows], y[rows], rows, span, t, out))
        rest = np.concatenate(bad)
        sure = grid.sure[cell[rest]]
        again = [rest[~sure]]
        for a in range(0, len(rest), BLOCK):
            progress.step()
            some = rest[a : a + BLOCK][sure[a : a + BLOCK]]
            new_span, new_t, settled, exact = self._newton(x[some], y[some], span[some], t[some], steps=30)
            back = some[settled]
            span[back], t[back] = new_span[settled], new_t[settled]
            for target, value in zip(out, exact, strict=True):
                target[back] = value[settled]
            again.append(some[~settled])
        if self._steps.faceted:
            beside = self._beside_facets(span, t, out[4])
            beside[np.concatenate(again)] = False
            again.append(np.flatnonzero(beside))
        return np.concatenate(again)

    def _beside_facets(self, span: Ints, t: Floats, distance: Floats) -> Bools:
        """Whether a foot is so near to a joint turning towards the point that the next facet may be nearer."""
        profile = self.profile
        turn = np.nan_to_num(profile.turn)
        before = turn[profile.neighbour(np.arange(profile.spans), -1)]
        reach = 0.51 * np.abs(distance)
        length = profile.length[span]
        out: Bools = (-distance * before[span] > 0) & (t * length <= reach * np.abs(before[span]))
        out |= (-distance * turn[span] > 0) & ((1 - t) * length <= reach * np.abs(turn[span]))
        return out

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
        s = np.where(self._steps.closed[contour], np.mod(s, total), np.clip(s, 0.0, total))
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
        single = free & self._steps.closed[profile.contour[before]]
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
