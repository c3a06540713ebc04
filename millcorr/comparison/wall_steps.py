# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that are cut in steps: the same place on all of them, and the order in which they can stand.

What is deeper is cut by passes that come by everything above it, too. So no step can stand farther out than the one
below. Where a part is drafted on some sides only, the steps are one wall on the others, and there it can have one
correction; where steps are nearer to each other than their corrections differ, likewise.
"""

from __future__ import annotations

import math

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.geometry.correction import Correction, Course, along
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile, Stretch
from millcorr.tolerances import ALIKE, EXACT

from .deviation import REACH

SPACING = 1.0
"""A correction that is one number along a stretch is looked at every so many mm."""

FACING = 0.9
"""Cosine of 26 degrees: steps of a wall that face more unlike each other are two sides about a corner."""

PROBES = 33
"""So many places tell which stretch of another step runs along one."""


class StepPlaces:
    """The same place on other steps of a wall: beside it, and on the same side of every corner.

    Parameters
    ----------
    profile : Profile
    """

    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        self.stretches = profile.stretches()
        self._like: dict[tuple[int, int], int] = {}

    def on(self, contour: int, stretch: int, s: Floats) -> tuple[int, Floats]:
        """Places of a stretch on another step.

        Parameters
        ----------
        contour : int
            The other step.
        stretch : int
            Of the profile.
        s : (n,) float64
            mm from the stretch's start.

        Returns
        -------
        stretch : int
            The one of the other step that runs along it.
        s : (n,) float64
            mm from its start; held at its ends.
        """
        one = self.stretches[stretch]
        key = contour, stretch
        if key not in self._like:
            inside = (np.arange(PROBES) + 0.5) / PROBES * one.length
            self._like[key] = int(np.bincount(self._feet(contour, stretch, inside)[0]).argmax())
        like = self.stretches[self._like[key]]
        number, there = self._feet(contour, stretch, s)
        held = np.where(s < 0.5 * one.length, 0.0, like.length)
        local = np.clip(along(like, there, self.profile), 0.0, like.length)
        return self._like[key], np.where(number == self._like[key], local, held)

    def _feet(self, contour: int, stretch: int, s: Floats) -> tuple[Ints, Floats]:
        """Stretch of the feet on a contour, and arc length from its start."""
        profile, one = self.profile, self.stretches[stretch]
        search, spans = FootPointSearch(profile).among(contour)
        feet = search.find(profile.at(one.contour, one.begin + s)[0])
        span = spans[feet.span]
        return profile.stretch[span], profile.arc_length(span, feet.t)


def in_order(correction: Correction, profile: Profile) -> Correction:
    """The correction that the passes of walls in steps can make.

    Of all walls that they can leave it is the nearest to what each step wants by itself: the isotonic regression over
    the depth (Barlow, Bartholomew, Bremner & Brunk 1972, ch. 1).

    Parameters
    ----------
    correction : Correction
        What each step wants by itself.
    profile : Profile

    Returns
    -------
    Correction
        The same one where no step would stand farther out than the one below.
    """
    courses = list(correction.courses)
    places = StepPlaces(profile)
    for wall in profile.steps:
        if len(wall) < 2:
            continue
        for number, stretch in enumerate(correction.stretches):
            if stretch.contour not in wall:
                continue
            own = wall.index(stretch.contour)
            at = _places(correction.courses[number], stretch.length, stretch.closed)
            here, normal = _inside(profile, stretch, at)
            stands = np.tile(correction.courses[number](at)[0], (len(wall), 1))
            for n, contour in enumerate(wall):
                if n == own:
                    continue
                like, s = places.on(contour, number, at)
                there, facing = _inside(profile, correction.stretches[like], s)
                over = ((there - here) * normal).sum(axis=1)
                # What is no side of the same wall there has no say.
                beside = (np.abs(over) < REACH) & ((facing * normal).sum(axis=1) > FACING)
                stands[n, beside] = (over + correction.courses[like](s)[0])[beside]
            ordered = _falling(stands)[own]
            if np.abs(ordered - stands[own]).max() > ALIKE:
                courses[number] = Course.through(at, ordered, stretch.length, stretch.closed)
    return Correction(correction.stretches, tuple(courses))


def _inside(profile: Profile, stretch: Stretch, s: Floats) -> tuple[Floats, Floats]:
    """Points and normals at arc lengths from a stretch's start; at its ends its own normals, not its neighbour's."""
    within = s if stretch.closed else np.clip(s, EXACT, stretch.length - EXACT)
    return profile.at(stretch.contour, stretch.begin + within)


def _places(course: Course, length: float, closed: bool) -> Floats:
    """Arc lengths from a stretch's start, increasing, at which its correction is looked at, mm."""
    if not course.is_constant:
        inside = course.breaks[:-1] if closed else course.breaks
        return np.unique(np.mod(inside, length) if closed else np.clip(inside, 0.0, length))
    return np.linspace(0.0, length, max(4, math.ceil(length / SPACING)), endpoint=not closed)


def _falling(stands: Floats) -> Floats:
    """Isotonic regression, never rising along the first axis: the least of the greatest means from either side."""
    count = len(stands)
    total = np.concatenate([np.zeros((1, stands.shape[1])), np.cumsum(stands, axis=0)])
    out = np.empty_like(stands)
    for k in range(count):
        least = np.full(stands.shape[1], np.inf)
        for first in range(k + 1):
            means = [(total[last + 1] - total[first]) / (last + 1 - first) for last in range(k, count)]
            least = np.minimum(least, np.max(means, axis=0))
        out[k] = least
    return out
