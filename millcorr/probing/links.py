# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways of a probe between touches at measuring height, proven clear of the part.

The distance to a contour changes by no more than the ball moves, so that samples a step apart, less half the step,
bound the distance everywhere between them.
"""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.geometry.profile import Profile

from .space import Space

_ROUND = np.radians(20.0)
"""Around a corner the ball's centre goes in chords of at most this angle."""


def links_between(
    space: Space,
    contour: Ints,
    s: Floats,
    start: Floats,
    *,
    stand: float,
    least: float,
    most: float,
) -> tuple[Floats | None, ...]:
    """Way from each touch's start to the next one's: straight, along the contour, or over the safe height.

    Parameters
    ----------
    space : Space
    contour : (n,) int64
    s : (n,) float64
        Arc length of the contact points in mm.
    start : (n, 2) float64
        Ball centres in mm.
    stand : float
        Distance of the ball's centre from the contour, in mm, on the way along it.
    least, most : float
        Distances in mm that the centre must keep on all of the way, from everything and from the nominal.

    Returns
    -------
    tuple of ((k, 2) float64 or None)
        Both ends included; None where only the safe height is left.
    """
    straight = [start[k : k + 2] for k in range(len(start) - 1)]
    good_ways = clear(space, straight, least, most)
    links: list[Floats | None] = [way if good else None for way, good in zip(straight, good_ways, strict=True)]
    rest = [k for k, way in enumerate(links) if way is None and contour[k] == contour[k + 1]]
    around = [
        _along(space.search.profile, int(contour[k]), float(s[k]), float(s[k + 1]), start[k], start[k + 1], stand)
        for k in rest
    ]
    for k, way, good in zip(rest, around, clear(space, around, least, most), strict=True):
        links[k] = way if good else None
    return tuple(links)


def clear(space: Space, ways: list[Floats], least: float, most: float) -> list[bool]:
    """Whether the whole of each way keeps far enough from everything, and near enough to the contour.

    Parameters
    ----------
    space : Space
    ways : list of (k, 2) float64
        Corners of polylines, mm.
    least, most : float
        mm; as for `links_between`.
    """
    if not ways:
        return []
    step = least / 16
    points, owner, reach = [], [], []
    for number, way in enumerate(ways):
        for a, b in zip(way[:-1], way[1:], strict=True):
            count = max(1, int(np.ceil(np.hypot(*(b - a)) / step)))
            u = np.linspace(0.0, 1.0, count + 1)[:, None]
            points.append(a + u * (b - a))
            owner.append(np.full(count + 1, number))
            reach.append(np.full(count + 1, np.hypot(*(b - a)) / count / 2))
    place, half, number_of = np.concatenate(points), np.concatenate(reach), np.concatenate(owner)
    own, nearest = space.distances(place)
    bad = (nearest - half < least) | (own + half > most)
    failed = np.bincount(number_of, weights=bad, minlength=len(ways)) > 0
    return [not f for f in failed.tolist()]


def _along(profile: Profile, contour: int, s0: float, s1: float, start: Floats, end: Floats, stand: float) -> Floats:
    """Row of chords beside the contour, `stand` off it, rounded at corners; the short way round a closed one."""
    total = float(profile.total[contour])
    way = s1 - s0
    if profile.contours[contour].closed:
        way = (way + total / 2) % total - total / 2
    step = stand / 8
    inner = s0 + np.linspace(0.0, way, max(2, int(np.ceil(abs(way) / step)) + 1))
    foot, normal = profile.at(contour, np.mod(inner, total) if profile.contours[contour].closed else inner)
    points: list[Floats] = [start]
    turn = np.arctan2(
        normal[:-1, 0] * normal[1:, 1] - normal[:-1, 1] * normal[1:, 0], (normal[:-1] * normal[1:]).sum(axis=1)
    )
    for k in range(len(foot)):
        points.append(foot[k] + stand * normal[k])
        if k < len(turn) and abs(turn[k]) > _ROUND:
            pieces = int(np.ceil(abs(turn[k]) / _ROUND))
            angle = np.arctan2(normal[k, 1], normal[k, 0]) + turn[k] * np.arange(1, pieces) / pieces
            points += list(foot[k] + stand * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    points.append(end)
    return _fewer(np.array(points), stand / 32)


def _fewer(points: Floats, tolerance: float) -> Floats:
    """Corners of a polyline that stays within the tolerance of the given one (Douglas and Peucker)."""
    from shapely import LineString

    out: Floats = np.array(LineString(points).simplify(tolerance).coords)
    return out
