# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stock before cutting: a profile with an even allowance, and what earlier programs took away.

A point is stock where its signed distance from the profile is below the allowance, and where no earlier cutter
has been. Beyond the end of an open contour the distance outside counts from the end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
import shapely

from millcorr.arrays import Bools, Floats, Ints
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile

from .path_pieces import Pieces, pieces_of_profile
from .piece_tree import PieceTree
from .swept_circle import wrapped

_SLACK = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Swept:
    """What a cutter took before the program.

    Parameters
    ----------
    pieces : Pieces
        Path of its centre.
    radius : float
        mm.
    """

    pieces: Pieces
    radius: float


@dataclass(frozen=True, eq=False, slots=True)
class StockRegion:
    """Material before the program cuts.

    Parameters
    ----------
    profile : Profile or None
        Contour with the material on its left; None for material everywhere.
    allowance : float
        Stock in mm outside the profile, even along its normal; 0 where the profile is the stock's own contour.
    swept : tuple of Swept
        What cutters took before.
    """

    profile: Profile | None = None
    allowance: float = 0.0
    swept: tuple[Swept, ...] = ()
    _boundary: Pieces | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        if self.profile is not None:
            object.__setattr__(self, "_boundary", _parallel(pieces_of_profile(self.profile), self.allowance))

    def outside(self, centre: Floats, direction: Floats, radius: float) -> tuple[Ints, Floats, Floats]:
        """Parts of the front of circles that lie outside the profile's stock.

        Parameters
        ----------
        centre : (n, 2) float64
            mm.
        direction : (n,) float64
            Direction of travel in rad.
        radius : float
            mm.

        Returns
        -------
        step : (m,) int64
        low, high : (m,) float64
            Angles from the direction of travel, within -pi/2..pi/2.
        """
        n = len(centre)
        profile, boundary = self.profile, self._boundary
        if profile is None or boundary is None:
            return np.zeros(0, dtype=np.int64), np.zeros(0), np.zeros(0)
        steps, angles = [np.arange(n), np.arange(n)], [np.full(n, -np.pi / 2), np.full(n, np.pi / 2)]
        ex, ey = np.cos(direction), np.sin(direction)

        def in_front(step: Ints, x: Floats, y: Floats, half: Floats, first: Ints, count: int) -> Bools:
            ahead = (x - centre[step, 0]) * ex[step] + (y - centre[step, 1]) * ey[step]
            out: Bools = ahead + half >= -_SLACK
            return out

        for step, piece in PieceTree(boundary, radius).near(centre, radius, keep=in_front):
            for k, angle in _crossings(centre[step], radius, boundary.take(piece)):
                relative = wrapped(angle - direction[step[k]])
                front = np.abs(relative) < np.pi / 2
                steps.append(step[k][front])
                angles.append(relative[front])
        for k, angle in _corner_crossings(profile, centre, radius, self.allowance):
            relative = wrapped(angle - direction[k])
            front = np.abs(relative) < np.pi / 2
            steps.append(k[front])
            angles.append(relative[front])
        step, angle = np.concatenate(steps), np.concatenate(angles)
        order = np.lexsort((angle, step))
        step, angle = step[order], angle[order]
        same = np.flatnonzero((step[1:] == step[:-1]) & (angle[1:] - angle[:-1] > 1e-13))
        low, high, step = angle[same], angle[same + 1], step[same]
        middle = direction[step] + (low + high) / 2
        point = centre[step] + radius * np.stack([np.cos(middle), np.sin(middle)], axis=1)
        feet = FootPointSearch(profile, margin=20.0 + abs(self.allowance)).find(point)
        # Beyond an open end the part goes on, the allowance does not: it ends with a round.
        round_ = (feet.place == Place.END) & (feet.distance > 0)
        there = np.where(round_, np.hypot(*(point - feet.foot).T), feet.distance) >= self.allowance
        return step[there].astype(np.int64), low[there], high[there]


def prolonged(profile: Profile, length: float) -> Profile:
    """A profile whose open contours go on straight at both ends.

    Parameters
    ----------
    profile : Profile
    length : float
        At each end, mm.

    Returns
    -------
    Profile
    """
    contours = []
    for k, contour in enumerate(profile.contours):
        if contour.closed:
            contours.append(contour)
            continue
        (first, last), normal = profile.at(np.array([k, k]), np.array([0.0, float(profile.total[k])]))
        # The material is on the left, the normal points to the right.
        back, on = np.stack([-normal[:, 1], normal[:, 0]], axis=1) * [[-length], [length]]
        before, behind = NurbsCurve.line(first + back, first), NurbsCurve.line(last, last + on)
        contours.append(Contour((before, *contour.curves, behind), False))
    return Profile.from_contours(contours)


def _parallel(pieces: Pieces, offset: float) -> Pieces:
    """Every piece moved to its right by `offset` mm, one by one; arcs that would turn inside out are left out."""
    rows = np.arange(len(pieces))
    n0, n1 = (pieces.tangent(rows, np.full(len(rows), u)) @ np.array([[0.0, -1.0], [1.0, 0.0]]) for u in (0.0, 1.0))
    radius = np.where(pieces.is_arc, pieces.radius + np.sign(pieces.sweep) * offset, np.inf)
    moved = replace(pieces, start=pieces.start + offset * n0, end=pieces.end + offset * n1, radius=radius)
    return moved.take(radius > 0)


def _crossings(centre: Floats, radius: float, piece: Pieces) -> Iterator[tuple[Ints, Floats]]:
    """Angles at which circles meet pieces, pair by pair."""
    arc = piece.is_arc
    k = np.flatnonzero(~arc)
    if len(k):
        d = piece.end[k] - piece.start[k]
        length = np.hypot(*d.T)
        d = d / np.maximum(length, 1e-300)[:, None]
        v = piece.start[k] - centre[k]
        c = (v[:, 0] * d[:, 1] - v[:, 1] * d[:, 0]) / radius
        meets = np.abs(c) <= 1
        along = v[:, 0] * d[:, 0] + v[:, 1] * d[:, 1]
        across = np.arctan2(-d[:, 0], d[:, 1])
        turn = np.arccos(np.clip(c, -1.0, 1.0))
        for sign in (1.0, -1.0):
            # Turned left from the right normal a point lies forward.
            reach = sign * radius * np.sin(turn)
            good = meets & (along - _SLACK <= reach) & (reach <= along + length + _SLACK)
            yield k[good], (across + sign * turn)[good]
    k = np.flatnonzero(arc)
    if len(k):
        turning = np.sign(piece.sweep[k])
        q = piece.radius[k]
        v = piece.centre[k] - centre[k]
        d = np.maximum(np.hypot(*v.T), 1e-300)
        c = (d * d + radius * radius - q * q) / (2 * d * radius)
        meets = np.abs(c) <= 1
        turn, towards = np.arccos(np.clip(c, -1.0, 1.0)), np.arctan2(v[:, 1], v[:, 0])
        begin = piece.start[k] - piece.centre[k]
        begin_angle = np.arctan2(begin[:, 1], begin[:, 0])
        for way in (1.0, -1.0):
            angle = towards + way * turn
            px, py = radius * np.cos(angle) - v[:, 0], radius * np.sin(angle) - v[:, 1]
            around = turning * (np.arctan2(py, px) - begin_angle)
            around = np.mod(around + _SLACK, 2 * np.pi) - _SLACK
            good = meets & (around <= np.abs(piece.sweep[k]) + _SLACK)
            yield k[good], angle[good]


def _corner_crossings(profile: Profile, centre: Floats, radius: float, offset: float) -> Iterator[tuple[Ints, Floats]]:
    """Angles at which circles meet the rounds of the stock about corners and ends of the profile."""
    if offset == 0:
        return
    turn: Floats = np.nan_to_num(profile.turn, nan=np.pi)
    last = np.flatnonzero(turn * np.sign(offset) > 1e-9)
    corner = profile.evaluate(last, np.ones(len(last)))[0]
    opening = [profile.ends(k)[0] for k, c in enumerate(profile.contours) if not c.closed]
    corner = np.vstack([corner, *opening])
    if not len(corner):
        return
    tree = shapely.STRtree(shapely.points(corner))
    step, row = tree.query(shapely.points(centre), predicate="dwithin", distance=radius + abs(offset))
    v = corner[row] - centre[step]
    d = np.maximum(np.hypot(*v.T), 1e-300)
    c = (d * d + radius * radius - offset * offset) / (2 * d * radius)
    meets = np.abs(c) <= 1
    half, towards = np.arccos(np.clip(c[meets], -1.0, 1.0)), np.arctan2(v[meets, 1], v[meets, 0])
    for way in (1.0, -1.0):
        yield step[meets], towards + way * half
