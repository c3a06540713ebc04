# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part as a mesh of facets: where it has a wall, and what of it stands in a probe's way at a height."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely

from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays

_UPRIGHT = 1e-6
"""A facet whose normal has no larger share along Z is upright: no vertical line crosses it."""

_DIGITS = 6
"""Heights are rounded to so many digits of a millimetre: pieces that stand on each other have no gap."""


_GRID = 1e-6
"""Sections are laid on a grid of so many millimetres, much finer than facets are good."""


@dataclass(frozen=True, eq=False, slots=True)
class Walls(ReadOnlyArrays):
    """Stretches of wall over the height, in mm; a place may have several, over each other, or none.

    Parameters
    ----------
    place : (n,) int64
        Number of the place.
    bottom, top : (n,) float64
    """

    place: Ints
    bottom: Floats
    top: Floats


@dataclass(frozen=True, eq=False, slots=True)
class Workpiece(ReadOnlyArrays):
    """Facets of the finished part, in the frame of the program.

    Parameters
    ----------
    facets : (n, 3, 3) float64
        Corners of closed meshes in mm, anticlockwise seen from outside; upright facets may be missing.
    tolerance : float
        How far the facets may lie off the part, mm.
    """

    facets: Floats
    tolerance: float = 0.01

    @property
    def top(self) -> float:
        """Highest place, mm."""
        return float(self.facets[:, :, 2].max())

    def walls(self, contact: Floats, normal: Floats) -> Walls:
        """Where there is material behind places of a contour and none before them.

        Parameters
        ----------
        contact, normal : (n, 2) float64
            Places in mm and directional cosines there, away from the material.
        """
        behind = self._crossings(contact - 2 * self.tolerance * normal)
        before = self._crossings(contact + 2 * self.tolerance * normal)
        place = np.concatenate([behind[0], before[0]])
        z = np.concatenate([behind[1], before[1]])
        into = np.concatenate([behind[2], before[2]])
        # One piece is entered before another is left at the same height.
        order = np.lexsort((-into, z, place))
        place, z, into = place[order], z[order], into[order]
        of_behind = order < len(behind[0])
        inside, outside = np.cumsum(into * of_behind), np.cumsum(into * ~of_behind)
        # Each place begins below everything, and ends above it: a closed mesh is left as often as it is entered.
        wall = (inside > 0) & (outside <= 0)
        was = np.concatenate([[False], wall[:-1]]) & np.concatenate([[False], np.diff(place) == 0])
        first, last = np.flatnonzero(wall & ~was), np.flatnonzero(~wall & was)
        real = z[last] > z[first]
        return Walls(place[first][real], z[first][real], z[last][real])

    def above(self, z: float) -> Obstacles:
        """What stands above a height, seen from above."""
        up = self.facets[_steepness(self.facets) > _UPRIGHT]
        higher = up[:, :, 2] > z
        count = higher.sum(axis=1)
        whole = up[count == 3]
        # The corner that is alone on its side of the height comes first; both its edges cross.
        alone = np.where(count == 1, higher.argmax(axis=1), (~higher).argmax(axis=1))
        turned = np.take_along_axis(up, ((alone[:, None] + np.arange(3)) % 3)[:, :, None], axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (z - turned[:, :1, 2]) / (turned[:, 1:, 2] - turned[:, :1, 2])
            crossing = turned[:, :1] + share[:, :, None] * (turned[:, 1:] - turned[:, :1])
        one, two = count == 1, count == 2
        tips = np.stack([turned[one, 0], crossing[one, 0], crossing[one, 1]], axis=1)
        rests = np.stack([crossing[two, 0], turned[two, 1], turned[two, 2], crossing[two, 1]], axis=1)
        flat = [shapely.polygons(piece[:, :, :2]) for piece in (whole, tips, rests) if len(piece)]
        # Without a grid the union of thin facets whose edges nearly meet may lose some of them.
        area = shapely.union_all(np.concatenate(flat), grid_size=_GRID) if flat else shapely.Polygon()
        return Obstacles(area, self.tolerance)

    def _crossings(self, points: Floats) -> tuple[Ints, Floats, Ints]:
        """Where vertical lines cross the mesh: number of the line, height, and 1 into the material or -1 out of it."""
        steep = _steepness(self.facets)
        sloped = np.abs(steep) > _UPRIGHT
        facets, up = self.facets[sloped], steep[sloped] > 0
        tree = shapely.STRtree(shapely.polygons(facets[:, :, :2]))
        line, facet = tree.query(shapely.points(points))
        within = np.ones(len(line), dtype=bool)
        for k in range(3):
            left = _left_of(points[line], facets[facet, k, :2], facets[facet, (k + 1) % 3, :2])
            within &= left == up[facet]
        line, facet = line[within], facet[within]
        corner, one, two = (facets[facet, k] for k in range(3))
        across = np.cross(one - corner, two - corner)
        z = corner[:, 2] - ((points[line] - corner[:, :2]) * across[:, :2]).sum(axis=1) / across[:, 2]
        return line, np.round(z, _DIGITS), np.where(up[facet], -1, 1)


def _left_of(points: Floats, begin: Floats, end: Floats) -> Bools:
    """Whether points lie left of edges; one on an edge counts as left of the way in which X, then Y, increases.

    So each point lies in one of two facets that share an edge, and in one of all that share a corner.
    """
    back = (begin[:, 0] > end[:, 0]) | ((begin[:, 0] == end[:, 0]) & (begin[:, 1] > end[:, 1]))
    first, last = np.where(back[:, None], end, begin), np.where(back[:, None], begin, end)
    way, to = last - first, points - first
    out: Bools = (way[:, 0] * to[:, 1] - way[:, 1] * to[:, 0] >= 0) != back
    return out


class Obstacles:
    """What stands in the way, seen from above.

    Parameters
    ----------
    area : shapely geometry
        Polygons in mm.
    tolerance : float
        How far it may reach beyond what is really there, mm.
    """

    def __init__(self, area: Any, tolerance: float) -> None:
        self.area, self._tolerance = area, tolerance
        rings = shapely.get_rings(shapely.get_parts(area))
        corners = [shapely.get_coordinates(ring) for ring in rings]
        edges = [np.stack([ring[:-1], ring[1:]], axis=1) for ring in corners]
        self._edges = shapely.STRtree(shapely.linestrings(np.concatenate(edges)) if edges else [])
        shapely.prepare(area)

    def distance(self, points: Floats) -> Floats:
        """Distance of points, (n, 2) in mm, at most; inf where there is nothing at all."""
        out = np.full(len(points), np.inf)
        if len(self._edges) and len(points):
            found, far = self._edges.query_nearest(shapely.points(points), return_distance=True, all_matches=False)
            out[found[0]] = far + self._tolerance
            out[shapely.contains_xy(self.area, points[:, 0], points[:, 1])] = 0.0
        return out


def _steepness(facets: Floats) -> Floats:
    """Z of the facets' unit normals: 1 looks up, 0 is upright or no facet at all."""
    across = np.cross(facets[:, 1] - facets[:, 0], facets[:, 2] - facets[:, 0])
    size = np.linalg.norm(across, axis=1)
    out: Floats = np.divide(across[:, 2], size, out=np.zeros(len(facets)), where=size > 0)
    return out
