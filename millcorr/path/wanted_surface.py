# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface that is wanted, and how near a cutter's centre may come to it.

The path of a corrected program is what a disc may follow without cutting into the wanted surface anywhere near: for
each place the outermost centre that any wanted point within a radius asks for. In an inside corner hardly wider than
the cutter, a disc let in by its own place's deviation would cut into the wall beside it.
"""

from __future__ import annotations

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.path_distance import SegmentTree
from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import CORNER_ANGLE, Profile
from millcorr.tolerances import EXACT

CHORD = 2e-5
"""The surface is drawn by chords that are off it by no more than this, in mm. Two surfaces drawn at the same places
err alike, so that what is moved errs by far less."""

BEND = 2e-5
"""A correction is drawn by chords that are off it by no more than this, in mm: these errors do not cancel."""

FINEST, COARSEST = 0.02, 0.25
"""Shortest and longest chord, mm: a correction does not bend on shorter ways, and is looked at on longer ones."""

FLAT = 0.02
"""Where the sides of a joint turn less, in rad, what they differ by is no corner."""

FARTHEST = 4.0
"""A centre that goes so many times farther than any place of the surface goes past a side and not away from it."""

MANY_ROUNDS = 200
"""Steps of the search for a centre between two sides: each goes to one of them, the nearer the more acute they are."""

FEW_ROUNDS, MEETS = 30, 1e-8
"""Steps of the search for where two sides meet, each as much shorter as a correction is steep; the last one, mm."""

ROUNDS = 60
"""Steps of the search for a centre; each is as long as the centre is too far, or too near."""


class WantedSurface:
    """A profile moved along its normal by a correction, as a fine row of chords.

    Parameters
    ----------
    profile : Profile
    correction : Correction
    alike : Correction, optional
        That of another surface of the same profile which this one is compared with: both are drawn at the same places.

    Attributes
    ----------
    profile : Profile
    nominal, place : (n, 2) float64
        Points of the profile, and of the surface, mm.
    stretch, s : (n,)
        Where they come from: smooth stretch, and arc length from the contour's start, mm.
    bottom, top : (n,) float64
        Heights in mm between which the part has the point's contour; infinite where it always does.
    normal : (n, 2) float64
        Normal of the profile there.
    moved : (n,) float64
        The correction there, mm.
    at_corner : (n,) bool
        So near to a corner that the sides it moves along do not meet there any more.
    chords : (k, 2) int64
        Points that follow each other.
    """

    def __init__(self, profile: Profile, correction: Correction, alike: Correction | None = None) -> None:
        self.profile = profile
        span, t = self._samples(profile)
        for one in (correction,) if alike is None else (correction, alike):
            span, t = self._followed(profile, one, span, t)
        self.nominal = profile.evaluate(span, t)[0]
        self.normal = profile.normals(span, t)
        self.stretch, self.s = profile.stretch[span], profile.arc_length(span, t)
        self.moved = correction.at(self.stretch, self.s, profile)
        self.place = self.nominal + self.moved[:, None] * self.normal
        self._contour = profile.contour[span]
        keep = self._set_corners(profile, span, t, self.nominal)
        after = self._next(profile, span, t, keep)
        rows = np.flatnonzero(after >= 0)
        self.chords = np.stack([rows, after[rows]], axis=1)
        self.bottom, self.top = profile.heights(profile.contour[span])
        self._sections = profile.sections
        self._trees: dict[int, SegmentTree] = {}

    @staticmethod
    def _samples(profile: Profile) -> tuple[Ints, Floats]:
        every = np.arange(profile.spans)
        bend = np.abs(profile.curvature(np.repeat(every, 3), np.tile([0.0, 0.5, 1.0], profile.spans)))
        step = np.clip(np.sqrt(8 * CHORD / np.maximum(bend.reshape(-1, 3).max(axis=1), 1e-9)), FINEST, COARSEST)
        count = np.maximum(1, np.ceil(profile.length / step).astype(np.int64))
        span = np.repeat(every, count + 1)
        number = np.arange(len(span)) - np.repeat(np.cumsum(count + 1) - (count + 1), count + 1)
        return span, number / count[span]

    @staticmethod
    def _followed(profile: Profile, correction: Correction, span: Ints, t: Floats) -> tuple[Ints, Floats]:
        """Samples with more between where a correction bends away from its chords."""

        def moved(t: Floats, span: Ints) -> Floats:
            return correction.at(profile.stretch[span], profile.arc_length(span, t), profile)

        left = np.flatnonzero(span[1:] == span[:-1])
        side, t0, t1 = span[left], t[left], t[left + 1]
        m0, m1 = moved(t0, side), moved(t1, side)
        while len(side):
            middle = (t0 + t1) / 2
            m = moved(middle, side)
            bent = (np.abs(m - (m0 + m1) / 2) > BEND) & ((t1 - t0) * profile.length[side] > 2 * FINEST)
            t0, middle, t1, m0, m, m1 = (x[bent] for x in (t0, middle, t1, m0, m, m1))
            side = side[bent]
            span, t = np.concatenate([span, side]), np.concatenate([t, middle])
            side, t0, t1 = np.tile(side, 2), np.concatenate([t0, middle]), np.concatenate([middle, t1])
            m0, m1 = np.concatenate([m0, m]), np.concatenate([m, m1])
        order = np.lexsort((t, span))
        return span[order], t[order]

    def _set_corners(self, profile: Profile, span: Ints, t: Floats, nominal: Floats) -> Bools:
        """Move the ends of the sides of every joint to where the moved sides meet; which samples stay."""
        keep = np.ones(len(span), dtype=bool)
        self.at_corner = np.zeros(len(span), dtype=bool)
        last = np.flatnonzero(t == 1.0)
        last = last[np.isfinite(profile.turn[span[last]])]
        first_of = np.flatnonzero(t == 0.0)
        first = first_of[profile.neighbour(span[last], 1)]
        n0, n1 = self.normal[last], self.normal[first]
        shift = meeting(n0, n1, self.moved[last], self.moved[first])
        turn = np.abs(profile.turn[span[last]])
        corners = np.flatnonzero(turn > CORNER_ANGLE)
        sides = [(self._side(profile, last[i], -1), self._side(profile, first[i], 1)) for i in corners]
        for i, both in zip(corners, sides, strict=True):
            shift[i] = self._where_sides_meet(nominal[last[i]], both, shift[i])
        corner = nominal[last] + shift
        self.place[last], self.place[first] = corner, corner
        self._corners, self._corner_shift = nominal[last], shift
        self._sharp = corners
        # Where a side would be at a joint lies beyond where the other one cuts it off.
        beside = np.abs(self.moved[last]) * turn**2 / 2 > CHORD
        self.at_corner[last[beside]] = self.at_corner[first[beside]] = True
        for i, both in zip(corners, sides, strict=True):
            for (side, away), way in zip(both, (-1, 1), strict=True):
                normal, total = self.normal[side[0]], float(profile.total[self._contour[side[0]]])
                along = float(way * (shift[i] @ np.array([-normal[1], normal[0]])))
                self.at_corner[side[away < 2 * abs(along) + FINEST]] = True
                # What lies beyond the corner is cut off; not round the whole contour, and never the corner itself.
                keep[side[(away > 1e-9) & (away < min(along, 0.5 * total))]] = False
        return keep

    def _side(self, profile: Profile, end: int, way: int) -> tuple[Ints, Floats]:
        """Samples of the stretch that ends or begins at a corner, and how far from it they are, mm, in rising order."""
        side = np.flatnonzero(self.stretch == self.stretch[end])
        away = way * (self.s[side] - self.s[end])
        k = self._contour[end]
        if profile.contours[k].closed:
            away = np.mod(away + 1e-9, profile.total[k]) - 1e-9
        # Where a contour has no other corner, its far end is at the same place: that belongs to the other side.
        mine = (away > 1e-9) | (side == end)
        side, away = side[mine], away[mine]
        order = np.argsort(away, kind="stable")
        return side[order], away[order]

    def _where_sides_meet(self, corner: Floats, sides: tuple[tuple[Ints, Floats], ...], shift: Floats) -> Floats:
        """Shift (2,) mm of a corner, from what it would be if its sides did all along as at their ends.

        Where a side is cut off, it is the place up to which it stays that counts.
        """
        start, normal, off = shift, np.empty((2, 2)), np.empty(2)
        for _ in range(FEW_ROUNDS):
            for k, ((side, away), way) in enumerate(zip(sides, (-1, 1), strict=True)):
                n = self.normal[side[0]]
                back = way * float(shift @ np.array([-n[1], n[0]]))
                place, normal[k] = (
                    np.array([np.interp(back, away, column) for column in values[side].T])
                    for values in (self.nominal, self.normal)
                )
                off[k] = (place - corner) @ normal[k] + np.interp(back, away, self.moved[side])
            if abs(np.linalg.det(normal)) < FLAT:
                break
            before, shift = shift, np.asarray(np.linalg.solve(normal, off), dtype=np.float64)
            if np.abs(shift - before).max() < MEETS:
                return shift
        return start

    def corners_of(self, other: WantedSurface, places: Floats) -> Floats:
        """Where corners are, (n, 2) mm, that are at places (n, 2) on another surface of the profile; NaN without."""
        from scipy.spatial import cKDTree

        out = np.full((len(places), 2), np.nan)
        if len(self._corners) and len(places):
            apart, which = cKDTree(other._corners + other._corner_shift).query(places)
            near = apart < FINEST
            out[near] = (self._corners + self._corner_shift)[which[near]]
        return out

    @staticmethod
    def _next(profile: Profile, span: Ints, t: Floats, keep: Bools) -> Ints:
        """Sample that follows each along its contour; -1 at an open end."""
        after = np.full(len(span), -1)
        for k in range(len(profile.contours)):
            rows = np.flatnonzero((profile.contour[span] == k) & keep)
            after[rows[:-1]] = rows[1:]
            if profile.contours[k].closed:
                after[rows[-1]] = rows[0]
        return after

    def corner_shift(self, corners: Floats) -> Floats:
        """How far corners of the profile, (n, 2) mm, have moved; (n, 2) mm."""
        from scipy.spatial import cKDTree

        if not len(corners):
            return np.zeros((0, 2))
        _, which = cKDTree(self._corners).query(corners)
        out: Floats = self._corner_shift[which]
        return out

    def distance(self, points: Floats) -> Floats:
        """Distance of points (n, 2) or (n, 3) from the surface at their heights, mm; without one from all of it."""
        out = np.empty(len(points))
        for k, rows in self._sections.split(points):
            out[rows] = self._tree(k).distance(points[rows, :2])
        return out

    def _tree(self, section: int) -> SegmentTree:
        if section not in self._trees:
            chords = self.chords
            if section >= 0:
                chords = chords[np.isin(self._contour[chords[:, 0]], self._sections.contours[section])]
            self._trees[section] = SegmentTree(self.place[chords[:, 0]], self.place[chords[:, 1]])
        return self._trees[section]

    def clearance(self, origin: Floats, direction: Floats, radius: float, guess: Floats) -> Floats:
        """How far along a direction a disc's centre may come to the surface.

        Parameters
        ----------
        origin : (n, 2) or (n, 3) float64
            Places in mm.
        direction : (n, 2) float64
            Unit vectors away from the surface.
        radius : float
            mm.
        guess : (n,) float64
            Where to begin, mm from the origins.

        Returns
        -------
        (n,) float64
            Distances from the origins, mm, at which the disc touches the surface and does not cut into it; NaN where it
            does so at none, as beside an inside corner, whose other side it does not leave that way.
        """
        t = guess.copy()
        longest = FARTHEST * float(np.abs(self.moved).max()) + FINEST
        active = np.arange(len(t))
        way = np.pad(direction, ((0, 0), (0, origin.shape[1] - 2)))
        for _ in range(ROUNDS):
            progress.step()
            if not len(active):
                break
            step = radius - self.distance(origin[active] + t[active, None] * way[active])
            t[active] += step
            lost = np.abs(t[active] - guess[active]) > longest
            t[active[lost]] = np.nan
            active = active[(np.abs(step) > 1e-8) & ~lost]
        t[active] = np.nan
        return t

    def outside(self, places: Floats, radius: float | Floats) -> Floats:
        """The nearest centres, (n, 2) mm, to places (n, 3) from which a disc does not cut into the surface.

        The radius, in mm, is one for all or one a place.
        """
        out, own = places.copy(), np.broadcast_to(radius, len(places))
        active = np.arange(len(out))
        for _ in range(MANY_ROUNDS):
            progress.step()
            if not len(active):
                break
            nearest = self._nearest(out[active])
            away = out[active, :2] - nearest
            size = np.hypot(*away.T)
            short = size < own[active] - 1e-9
            active = active[short]
            out[active, :2] += (own[active] / np.maximum(size[short], 1e-9) - 1.0)[:, None] * away[short]
        return out[:, :2]

    def nearest_a_joint(self, points: Floats) -> Bools:
        """Whether of the surface a joint is what is nearest to points (n, 2) or (n, 3), mm; (n,)."""
        # Sides that turn with their corrections meet beside where they would as straight ones.
        return self._within(self._nearest(points), self._corners + self._corner_shift, FINEST)

    def on_a_corner(self, places: Floats) -> Bools:
        """Whether places (n, 2) of the surface are corners of it, and no joints of facets; (n,)."""
        return self._within(places, (self._corners + self._corner_shift)[self._sharp], EXACT)

    @staticmethod
    def _within(places: Floats, others: Floats, reach: float) -> Bools:
        from scipy.spatial import cKDTree

        if not len(others):
            return np.zeros(len(places), dtype=bool)
        apart, _ = cKDTree(others).query(places)
        out: Bools = apart < reach
        return out

    def _nearest(self, points: Floats) -> Floats:
        """Nearest points (n, 2) of the surface at the heights of points (n, 3), mm."""
        out = np.empty((len(points), 2))
        for k, rows in self._sections.split(points):
            out[rows] = self._tree(k).foot(points[rows, :2])
        return out


def meeting(n0: Floats, n1: Floats, c0: Floats, c1: Floats) -> Floats:
    """Shift of a corner whose sides move by c0 and c1 along their normals.

    Parameters
    ----------
    n0, n1 : (n, 2) float64
        Unit normals of the sides.
    c0, c1 : (n,) float64
        mm.

    Returns
    -------
    (n, 2) float64
        mm. Where the sides are as good as in line, along their common normal only.
    """
    both, apart = n0 + n1, n0 - n1
    size2, apart2 = (both * both).sum(axis=1), (apart * apart).sum(axis=1)
    out: Floats = ((c0 + c1) / np.maximum(size2, 1e-6))[:, None] * both
    sharp = apart2 > FLAT**2
    out[sharp] += ((c0 - c1)[sharp] / apart2[sharp])[:, None] * apart[sharp]
    return out
