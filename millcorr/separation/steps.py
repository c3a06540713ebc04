# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repeats along the contours of a part, walls in steps included: one form a wall, an offset of its own a step.

The steps of a wall are cut by one cutter along one path, each a little farther out: what bends, lags or leads does so
on all of them at the same places. So they are heights of one wall to the model, and few points on each tell the form.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.compensation import along
from millcorr.profile import Profile
from millcorr.wall_steps import StepPlaces

from .model import Separated, Stretches

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]


class FormPlaces:
    """Where the form of a contour is kept: on the contour itself, for steps of a wall on the lowest of them.

    Parameters
    ----------
    profile : Profile

    Attributes
    ----------
    stretches : Stretches
        Smooth stretches that have a form of their own.
    """

    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        self._steps = StepPlaces(profile)
        self._lowest = {k: wall[0] for wall in profile.steps for k in wall[1:]}
        own = [k for k, t in enumerate(self._steps.stretches) if t.contour not in self._lowest]
        self._number = dict(zip(own, range(len(own)), strict=True))
        chosen = [self._steps.stretches[k] for k in own]
        self.stretches = Stretches(
            np.array([t.length for t in chosen]),
            np.array([t.closed for t in chosen]),
            np.array([t.contour for t in chosen], dtype=np.int64),
        )

    def of(self, stretch: Ints, s: Floats) -> tuple[Ints, Floats]:
        """Stretch of the form at places, and arc length from its start.

        Parameters
        ----------
        stretch : (n,) int64
            Of the profile.
        s : (n,) float64
            mm from the contour's start.

        Returns
        -------
        (n,) int64
            Of `stretches`.
        (n,) float64
            mm.
        """
        out, local = np.empty(len(s), dtype=np.int64), np.empty(len(s))
        for k in np.unique(stretch).tolist():
            rows, one, own = stretch == k, self._steps.stretches[k], k
            local[rows] = np.clip(along(one, s[rows], self.profile), 0.0, one.length)
            if one.contour in self._lowest:
                own, local[rows] = self._steps.on(self._lowest[one.contour], k, local[rows])
            out[rows] = self._number[own]
        return out, local


@dataclass(frozen=True, eq=False, slots=True)
class Systematic:
    """The systematic part anywhere on the contours of a nominal.

    Parameters
    ----------
    separated : Separated
        Where the form is kept.
    places : FormPlaces
    offset : (contours,) float64
        What each step of a wall has more than the mean of the measured heights, mm; 0 for other contours. Steps between
        measured ones lie between them.
    variance : (contours,) float64
        What its variance differs by from that of the mean, mm2.
    known : (contours,) bool
        False for the steps of a wall above and below all that were measured.
    contour : (n,) int64
        Contour of every observed point.
    """

    separated: Separated
    places: FormPlaces
    offset: Floats
    variance: Floats
    known: Bools
    contour: Ints

    @staticmethod
    def of(separated: Separated, places: FormPlaces, contour: Ints) -> Systematic:
        """Systematic part of separated values.

        Parameters
        ----------
        separated : Separated
            Of values at the places of `places`, of which each height of each step is a level.
        places : FormPlaces
        contour : (n,) int64
            Contour that each observed point lies on.
        """
        profile = places.profile
        count = len(profile.contours)
        offset, variance, known = np.zeros(count), np.zeros(count), np.ones(count, dtype=bool)
        level = {one.level: one for one in separated.levels}
        for wall in profile.steps:
            row = np.array(wall)
            bottom, _ = profile.heights(row)
            of_step = {n: np.unique(separated.observed.level[contour == k]).tolist() for n, k in enumerate(wall)}
            measured = [n for n, found in of_step.items() if found]
            if len(measured) < 2:
                known[row] = [n in measured for n in range(len(row))]
                continue
            means = [np.mean([level[k].mean for k in of_step[n]]) for n in measured]
            own = [np.mean([level[k].std ** 2 for k in of_step[n]]) / len(of_step[n]) for n in measured]
            offset[row] = np.interp(bottom, bottom[measured], means)
            # The measured heights are all there are, and no sample of others about whose mean they would tell.
            sample = separated.sizes.level**2 / sum(len(of_step[n]) for n in measured)
            variance[row] = np.interp(bottom, bottom[measured], own) - sample
            known[row] = (np.arange(len(row)) >= measured[0]) & (np.arange(len(row)) <= measured[-1])
        return Systematic(separated, places, offset, variance, known, contour)

    @property
    def at_points(self) -> tuple[Floats, Floats]:
        """Systematic part at the observed points and its standard uncertainty, (n,) each, mm."""
        return self._of_step(self.separated.systematic, self.separated.uncertainty, self.contour)

    def _of_step(self, mean: Floats, std: Floats, contour: Ints) -> tuple[Floats, Floats]:
        return mean + self.offset[contour], np.sqrt(np.maximum(std**2 + self.variance[contour], 0.0))

    def at(self, stretch: Ints, s: Floats) -> tuple[Floats, Floats]:
        """Systematic part and its standard uncertainty at any place, mm; (m,) each.

        Parameters
        ----------
        stretch : (m,) int64
        s : (m,) float64
            mm from the contour's start.

        Returns
        -------
        mean, std : (m,) float64
            On a contour without points 0 and NaN: not known.
        """
        profile = self.places.profile
        contour = np.array([t.contour for t in profile.stretches()], dtype=np.int64)[stretch]
        mean, std = self.separated.at(*self.places.of(stretch, s))
        return self._of_step(mean, std, contour)
