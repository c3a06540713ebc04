# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact distances from points to the moves of a toolpath, in the plane.

What a cutter leaves is what lies its radius away from its path: every question about a surface is one about this
distance, whatever pieces the path is made of.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.nc.toolpath import Kind, Plane, Toolpath

BLOCK = 5_000
"""So many points are asked for at once: shapely lets no other thread run while it makes them, a window must live on."""

SAGITTA = 1e-3
"""Arcs are looked up as chords that are off them by no more than this, in mm; the distance itself is exact."""

CUBIC_CHORD = 1e-5
"""Splines are taken as chords that are off them by no more than this, in mm."""


class PathDistance:
    """Distance from points to moves, and the nearest of them.

    Parameters
    ----------
    toolpath : Toolpath
    rows : (m,) int64
        Moves to look at. Moves without a known place in X and Y are left out; a plunge is a point.
    """

    def __init__(self, toolpath: Toolpath, rows: Ints) -> None:
        known = np.isfinite(toolpath.start[rows, :2]).all(axis=1) & np.isfinite(toolpath.end[rows, :2]).all(axis=1)
        rows = rows[known]
        # An arc out of the XY plane is seen from above as the chord between its ends, or near enough to it.
        arc = (toolpath.kind[rows] == Kind.ARC) & (toolpath.plane[rows] == Plane.XY)
        cubic = toolpath.kind[rows] == Kind.CUBIC
        plain = rows[~arc & ~cubic]
        a, b, owner = [toolpath.start[plain, :2]], [toolpath.end[plain, :2]], [plain]
        u0, u1 = [np.zeros(len(plain))], [np.ones(len(plain))]
        for row in rows[cubic]:
            t = np.linspace(0.0, 1.0, chords_of_cubic(toolpath, int(row)) + 1)
            points = toolpath.take(np.array([row])).position(t)[0, :, :2]
            a.append(points[:-1])
            b.append(points[1:])
            u0.append(t[:-1])
            u1.append(t[1:])
            owner.append(np.full(len(t) - 1, row))
        self._lines = SegmentTree(np.concatenate(a), np.concatenate(b))
        self._line_owner = np.concatenate(owner)
        self._line_u = np.stack([np.concatenate(u0), np.concatenate(u1)], axis=1)
        self._set_arcs(toolpath, rows[arc])

    def _set_arcs(self, toolpath: Toolpath, rows: Ints) -> None:
        centre = toolpath.centre[rows, :2]
        arm0, arm1 = toolpath.start[rows, :2] - centre, toolpath.end[rows, :2] - centre
        r0, r1, sweep = np.hypot(*arm0.T), np.hypot(*arm1.T), toolpath.sweep[rows]
        step = np.sqrt(8 * SAGITTA / np.maximum(np.maximum(r0, r1), 1e-6))
        count = np.maximum(1, np.ceil(np.abs(sweep) / np.minimum(step, 1.0)).astype(np.int64))
        piece = np.repeat(np.arange(len(rows)), count)
        number = np.arange(len(piece)) - np.repeat(np.cumsum(count) - count, count)
        ends = []
        for shift in (0, 1):
            u = (number + shift) / count[piece]
            angle = np.arctan2(arm0[piece, 1], arm0[piece, 0]) + sweep[piece] * u
            r = r0[piece] + (r1 - r0)[piece] * u
            ends.append(centre[piece] + r[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1))
        self._arcs = SegmentTree(*ends) if len(rows) else SegmentTree(np.zeros((0, 2)), np.zeros((0, 2)))
        self._arc_piece = piece
        self._arc_owner, self._arc_centre, self._arc_arm = rows, centre, arm0
        self._arc_end, self._arc_sweep, self._arc_radii = toolpath.end[rows, :2], sweep, np.stack([r0, r1], axis=1)

    def nearest(self, points: Floats) -> tuple[Floats, Ints, Floats]:
        """Distance to the nearest move, its row, and where on it.

        Parameters
        ----------
        points : (n, 2) float64
            mm.

        Returns
        -------
        distance : (n,) float64
            mm; infinite where there is no move.
        row : (n,) int64
            -1 where there is none.
        u : (n,) float64
            Fraction of the move, 0 at its start.
        """
        if len(points) > BLOCK:
            blocks = []
            for k in range(0, len(points), BLOCK):
                progress.step()
                blocks.append(self.nearest(points[k : k + BLOCK]))
            distances, rows, shares = zip(*blocks, strict=True)
            return np.concatenate(distances), np.concatenate(rows), np.concatenate(shares)
        distance = np.full(len(points), np.inf)
        row = np.full(len(points), -1, dtype=np.int64)
        u = np.zeros(len(points))
        which, piece = self._lines.nearest(points)
        if len(which):
            found, share = _to_segment(points[which], self._lines.a[piece], self._lines.b[piece])
            distance[which], row[which] = found, self._line_owner[piece]
            low, high = self._line_u[piece].T
            u[which] = low + (high - low) * share
        which, piece = self._arcs.near(points, distance)
        if len(which):
            found, share = self._to_arc(points[which], self._arc_piece[piece])
            order = np.lexsort((found, which))
            first = order[np.flatnonzero(np.diff(which[order], prepend=-1))]
            better = first[found[first] < distance[which[first]]]
            distance[which[better]] = found[better]
            row[which[better]] = self._arc_owner[self._arc_piece[piece[better]]]
            u[which[better]] = share[better]
        return distance, row, u

    def __call__(self, points: Floats) -> Floats:
        """Distance to the nearest move, mm; (n,)."""
        return self.nearest(points)[0]

    def _to_arc(self, points: Floats, arc: Ints) -> tuple[Floats, Floats]:
        """Distance to whole arcs and the fraction of the foot; spirals between unlike radii are followed."""
        arm, away = self._arc_arm[arc], points - self._arc_centre[arc]
        sweep, (r0, r1) = self._arc_sweep[arc], self._arc_radii[arc].T
        turn = np.arctan2(arm[:, 0] * away[:, 1] - arm[:, 1] * away[:, 0], (arm * away).sum(axis=1))
        way = np.where(sweep < 0, -1.0, 1.0)
        size = np.maximum(np.abs(sweep), 1e-300)
        angle = np.mod(way * turn, 2 * np.pi)
        u = np.where(angle <= size, angle / size, np.where(angle - size < 2 * np.pi - angle, 1.0, 0.0))
        r = r0 + (r1 - r0) * u
        at = np.arctan2(arm[:, 1], arm[:, 0]) + sweep * u
        foot = self._arc_centre[arc] + r[:, None] * np.stack([np.cos(at), np.sin(at)], axis=1)
        foot = np.where((u == 1.0)[:, None], self._arc_end[arc], foot)
        return np.hypot(*(points - foot).T), u


class SegmentTree:
    """Straight pieces by place.

    Parameters
    ----------
    a, b : (m, 2) float64
        Ends, mm.
    """

    def __init__(self, a: Floats, b: Floats) -> None:
        self.a, self.b = a, b
        self._tree: Any = None

    def _made(self) -> Any:
        import shapely

        if self._tree is None:
            self._tree = shapely.STRtree(shapely.linestrings(np.stack([self.a, self.b], axis=1)))
        return self._tree

    def distance(self, points: Floats) -> Floats:
        """Distance of points (n, 2) from the nearest piece, mm; infinite without one."""
        out = np.full(len(points), np.inf)
        which, piece = self.nearest(points)
        out[which] = _to_segment(points[which], self.a[piece], self.b[piece])[0]
        return out

    def nearest(self, points: Floats) -> tuple[Ints, Ints]:
        """Index of the points, and of the nearest piece of each."""
        import shapely

        if not len(self.a) or not len(points):
            return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
        which, piece = self._made().query_nearest(shapely.points(points), all_matches=False)
        return which, piece

    def foot(self, points: Floats) -> Floats:
        """Nearest points (n, 2) of the pieces to points (n, 2), mm."""
        which, piece = self.nearest(points)
        out = np.full(points.shape, np.nan)
        a, b = self.a[piece], self.b[piece]
        out[which] = a + _to_segment(points[which], a, b)[1][:, None] * (b - a)
        return out

    def near(self, points: Floats, distance: Floats) -> tuple[Ints, Ints]:
        """Points and pieces of them that may be nearer than a distance: within the chords' error of the nearest."""
        import shapely

        if not len(self.a) or not len(points):
            return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
        places = shapely.points(points)
        which, piece = self._made().query_nearest(places, all_matches=False)
        to_chord, _ = _to_segment(points[which], self.a[piece], self.b[piece])
        reach = np.minimum(to_chord, distance[which] + SAGITTA) + 2 * SAGITTA
        rows = np.flatnonzero(to_chord <= distance[which] + SAGITTA)
        found, piece = self._made().query(places[rows], predicate="dwithin", distance=reach[rows])
        return rows[found], piece


def _to_segment(points: Floats, a: Floats, b: Floats) -> tuple[Floats, Floats]:
    along = b - a
    size = np.maximum((along * along).sum(axis=1), 1e-300)
    u = np.clip(((points - a) * along).sum(axis=1) / size, 0.0, 1.0)
    return np.hypot(*(points - a - u[:, None] * along).T), u


def chords_of_cubic(toolpath: Toolpath, row: int) -> int:
    """How many chords of a spline move are off it by no more than `CUBIC_CHORD`."""
    p = np.concatenate([toolpath.start[row, :2], toolpath.control[row], toolpath.end[row, :2]]).reshape(4, 2)
    bend = 6 * np.abs(p[:-2] - 2 * p[1:-1] + p[2:]).max() * np.sqrt(2.0)
    return max(1, int(np.ceil(np.sqrt(bend / (8 * CUBIC_CHORD)))))
