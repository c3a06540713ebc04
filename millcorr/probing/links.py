# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways of a probe between touches at measuring height, proven clear of the part.

The distance to a contour changes by no more than the ball moves, so that samples a step apart, less half the step,
bound the distance everywhere between them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.footpoint import FootPointSearch

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_ROUND = np.radians(20.0)
"""Around a corner the ball's centre goes in chords of at most this angle."""


def links_between(
    search: FootPointSearch,
    contour: Ints,
    s: Floats,
    start: Floats,
    *,
    stand: float,
    least: float,
    most: float,
    cutter_radius: float,
) -> tuple[Floats | None, ...]:
    """Way from each touch's start to the next one's: straight, along the contour, or over the safe height.

    Parameters
    ----------
    search : FootPointSearch
        On the nominal.
    contour : (n,) int64
    s : (n,) float64
        Arc length of the contact points in mm.
    start : (n, 2) float64
        Ball centres in mm.
    stand : float
        Distance of the ball's centre from the contour, in mm, on the way along it.
    least, most : float
        Distances in mm that the centre must keep on all of the way.
    cutter_radius : float
        What a cutter of this radius in mm leaves in inner corners is kept clear of as well.

    Returns
    -------
    tuple of ((k, 2) float64 or None)
        Both ends included; None where only the safe height is left.
    """
    straight = [start[k : k + 2] for k in range(len(start) - 1)]
    good_ways = clear(search, straight, least, most, cutter_radius)
    links: list[Floats | None] = [way if good else None for way, good in zip(straight, good_ways, strict=True)]
    rest = [k for k, way in enumerate(links) if way is None and contour[k] == contour[k + 1]]
    around = [
        _along(search, int(contour[k]), float(s[k]), float(s[k + 1]), start[k], start[k + 1], stand) for k in rest
    ]
    for k, way, good in zip(rest, around, clear(search, around, least, most, cutter_radius), strict=True):
        links[k] = way if good else None
    return tuple(links)


def clear(search: FootPointSearch, ways: list[Floats], least: float, most: float, cutter_radius: float) -> list[bool]:
    """Whether the whole of each way keeps between two distances from the contour.

    Parameters
    ----------
    search : FootPointSearch
    ways : list of (k, 2) float64
        Corners of polylines, mm.
    least, most, cutter_radius : float
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
    distance = search.find(place).distance
    bad = (distance - half < least) | (distance + half > most)
    bad |= into_fillets(search, place, cutter_radius) - half < least
    failed = np.bincount(number_of, weights=bad, minlength=len(ways)) > 0
    return [not f for f in failed.tolist()]


def into_fillets(search: FootPointSearch, points: Floats, cutter_radius: float) -> Floats:
    """Distance of points from what a cutter leaves beside the nominal, mm; a lower bound, inf where it is no matter.

    A cutter leaves its fillet in inner corners. A disc about a point is free of it if some place of the cutter that
    does not touch the nominal covers the disc; the place is looked for by pushing the cutter off the nearest wall.
    (A disc larger than the cutter that is free of the nominal is made of such places.)
    """
    if cutter_radius <= 0:
        return np.full(len(points), np.inf)
    own = search.find(points).distance
    rows = np.flatnonzero(own < cutter_radius)
    out = np.full(len(points), np.inf)
    # Rows whose place still touches the nominal; beside a plain wall one push is enough.
    place, pending = points[rows].copy(), np.arange(len(rows))
    for _ in range(12):
        feet = search.find(place[pending])
        lacking = cutter_radius - feet.distance
        pending, lacking, normal = pending[lacking > 1e-9], lacking[lacking > 1e-9], feet.normal[lacking > 1e-9]
        if not len(pending):
            break
        place[pending] += lacking[:, None] * normal
    covered = cutter_radius - np.hypot(*(place - points[rows]).T)
    if len(pending):
        covered[pending[search.find(place[pending]).distance < cutter_radius - 1e-6]] = -np.inf
    out[rows] = covered
    return out


def _along(
    search: FootPointSearch, contour: int, s0: float, s1: float, start: Floats, end: Floats, stand: float
) -> Floats:
    """Row of chords beside the contour, `stand` off it, rounded at corners; the short way round a closed one."""
    profile = search.profile
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
