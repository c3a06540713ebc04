# SPDX-License-Identifier: LGPL-2.1-or-later
"""Foot points: the nearest point of a profile to each given point, exact and in blocks of cache size.

Newton's method starts from a seed. Few points are compared with every sample of the profile; many points take
their seed from a grid over the profile's box. Where neighbouring cells disagree about the branch (near the
medial axis, in narrow slots, at thin walls) and wherever Newton does not settle, a point falls back to the
full comparison, which also finds the nearest *other* branch.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from .profile import SMOOTH_ANGLE, Profile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

BLOCK = 8192
CONVERGED = 1e-11
"""Newton stops when its step along the profile is shorter than this, in mm."""


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
        How much farther, in mm, the nearest other branch of the profile is; inf where none competes.
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


class FootPointSearch:
    """Finds foot points on one profile.

    Parameters
    ----------
    profile : Profile
    margin : float
        Band in mm around the profile's box that the seed grid covers.
    """

    def __init__(self, profile: Profile, margin: float = 2.0) -> None:
        self.profile = profile
        size = float(profile.total.sum())
        self._spacing = max(size / 4000.0, 1e-4)
        span, t = profile.samples(self._spacing)
        c, _, _ = profile.evaluate(span, t)
        self._span, self._t, self._c = span, t, c
        self._s = profile.arc_length(span, t)
        self._margin = margin
        self._cells: tuple[Floats, float, Ints, NDArray[np.bool_]] | None = None

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
        x, y = np.ascontiguousarray(points[:, 0]), np.ascontiguousarray(points[:, 1])
        n = len(x)
        span = np.empty(n, dtype=np.int64)
        t = np.empty(n)
        rival = np.full(n, np.inf)
        out = tuple(np.empty(n) for _ in range(5))
        whole = n * len(self._span) <= 4_000_000
        if not whole and self._cells is None:
            self._cells = self._make_grid()
        for a in range(0, n, BLOCK):
            rows = slice(a, min(a + BLOCK, n))
            px, py = x[rows], y[rows]
            if whole:
                doubtful = np.arange(len(px))
                values = tuple(np.empty(len(px)) for _ in range(5))
                block_span, block_t = np.zeros(len(px), dtype=np.int64), np.zeros(len(px))
            else:
                seed, sure = self._seeds(px, py)
                block_span, block_t, settled, values = self._newton(px, py, self._span[seed], self._t[seed])
                doubtful = np.flatnonzero(~(sure & settled))
            if len(doubtful):
                qx, qy = px[doubtful], py[doubtful]
                block_span[doubtful], block_t[doubtful], rival[a + doubtful], exact = self._compare_all(qx, qy)
                for target, value in zip(values, exact, strict=True):
                    target[doubtful] = value
            span[rows], t[rows] = block_span, block_t
            for target, value in zip(out, values, strict=True):
                target[rows] = value
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
            move = -slope / np.where(bend > 0.1 * speed2, bend, speed2)
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

    def _compare_all(self, x: Floats, y: Floats) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
        """Foot points by comparing with every sample: the nearest branch, and the distance to the next one."""
        n, samples = len(x), len(self._span)
        best_span = np.zeros(n, dtype=np.int64)
        best_t = np.zeros(n)
        rival = np.full(n, np.inf)
        best = tuple(np.empty(n) for _ in range(5))
        chunk = max(1, 2_000_000 // samples)
        for a in range(0, n, chunk):
            rows = slice(a, min(a + chunk, n))
            qx, qy = x[rows], y[rows]
            d2 = (qx[:, None] - self._c[None, :, 0]) ** 2 + (qy[:, None] - self._c[None, :, 1]) ** 2
            nearest = np.sqrt(d2.min(axis=1))
            # A branch whose sample is this much farther may still come nearest between samples.
            slack = nearest + 2 * self._spacing
            low = d2 <= (slack + np.maximum(slack, 1.0))[:, None] ** 2
            left, right = np.roll(d2, 1, axis=1), np.roll(d2, -1, axis=1)
            point, sample = np.nonzero(low & (d2 <= left) & (d2 <= right))
            span, t, settled, values = self._newton(
                qx[point], qy[point], self._span[sample], self._t[sample], steps=40
            )
            cx, cy, nx, ny, signed = values
            gap = np.hypot(cx - qx[point], cy - qy[point])
            gap = np.where(settled, gap, gap + 1e-9)
            order = np.lexsort((gap, point))
            head = order[np.searchsorted(point[order], np.arange(len(qx)))]
            best_span[rows], best_t[rows] = span[head], t[head]
            for target, value in zip(best, values, strict=True):
                target[rows] = value[head]
            # Another branch: a foot at a different place whose way there leads over farther points.
            s = self.profile.arc_length(span, t)
            k = self.profile.contour[span]
            main = head[point]
            along = np.abs(s - s[main])
            total = self.profile.total[k]
            closed = np.array([c.closed for c in self.profile.contours])[k]
            along = np.where(closed, np.minimum(along, total - along), along)
            other = (k != k[main]) | (along > 1e-6 + 1e-3 * self._spacing)
            found = np.full(len(qx), np.inf)
            np.minimum.at(found, point[other], gap[other] - gap[main][other])
            rival[rows] = np.maximum(found, 0.0)
        return best_span, best_t, rival, best

    def _make_grid(self) -> tuple[Floats, float, Ints, NDArray[np.bool_]]:
        """Seed of every cell over the profile's box, and whether a cell is sure of its branch."""
        from scipy.spatial import cKDTree

        low = self._c.min(axis=0) - self._margin
        high = self._c.max(axis=0) + self._margin
        cell = float(np.sqrt(np.prod(high - low) / 40_000))
        shape = np.ceil((high - low) / cell).astype(int) + 1
        gx = low[0] + (np.arange(shape[0]) + 0.5) * cell
        gy = low[1] + (np.arange(shape[1]) + 0.5) * cell
        centre = np.stack(np.meshgrid(gx, gy, indexing="ij"), axis=-1).reshape(-1, 2)
        _, seed = cKDTree(self._c).query(centre)
        seed = seed.astype(np.int64).reshape(shape)
        s = self._s[seed]
        contour = self.profile.contour[self._span[seed]]
        total = self.profile.total[contour]
        closed = np.array([c.closed for c in self.profile.contours])[contour]
        sure = np.ones(shape, dtype=bool)
        reach = 4 * cell + 4 * self._spacing
        for axis in (0, 1):
            for step in (1, 2):
                a = tuple(slice(step, None) if i == axis else slice(None) for i in range(2))
                b = tuple(slice(None, -step) if i == axis else slice(None) for i in range(2))
                along = np.abs(s[a] - s[b])
                along = np.where(closed[a], np.minimum(along, total[a] - along), along)
                jump = (along > reach * step) | (contour[a] != contour[b])
                sure[a] &= ~jump
                sure[b] &= ~jump
        sure[[0, -1]] = False
        sure[:, [0, -1]] = False
        return low, cell, seed, sure

    def _seeds(self, x: Floats, y: Floats) -> tuple[Ints, NDArray[np.bool_]]:
        assert self._cells is not None
        low, cell, seed, sure = self._cells
        i = np.clip((x - low[0]) / cell, 0, seed.shape[0] - 1).astype(np.int64)
        j = np.clip((y - low[1]) / cell, 0, seed.shape[1] - 1).astype(np.int64)
        flat = i * seed.shape[1] + j
        return seed.ravel()[flat], sure.ravel()[flat]

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
        single = free & np.array([c.closed for c in profile.contours])[profile.contour[before]]
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
