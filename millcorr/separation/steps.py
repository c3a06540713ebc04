# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repeats along the contours of a part, walls in steps included: one form a wall, an offset of its own a step.

The steps of a wall are cut by one cutter along one path, each a little farther out: what bends, lags or leads does so
on all of them at the same places. So they are heights of one wall to the model, and few points on each tell the form.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.wall_steps import StepPlaces
from millcorr.geometry.profile import Profile

from .filters import Filter
from .model import Observed, Separated, Stretches, separate


def steps_of(profile: Profile) -> Ints:
    """Of each contour its own number where it is a step of a wall, -1 for others; (contours,)."""
    return np.array([-1 if contour.step is None else k for k, contour in enumerate(profile.contours)], dtype=np.int64)


class FormPlaces:
    """Where the form of a contour is kept: on the contour itself, for steps of a wall on the lowest of them.

    Parameters
    ----------
    profile : Profile

    Attributes
    ----------
    stretches : Stretches
        Smooth stretches that have a form of their own.
    contour : (stretches,) int64
        Of every stretch of the profile.
    """

    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        self._steps = StepPlaces(profile)
        self.contour = np.array([t.contour for t in self._steps.stretches], dtype=np.int64)
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
            mm from the stretch's start.

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
            local[rows] = np.clip(s[rows], 0.0, one.length)
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
    measured : Observed
        The points, with stretches of the nominal.
    """

    separated: Separated
    places: FormPlaces
    offset: Floats
    variance: Floats
    known: Bools
    measured: Observed

    @staticmethod
    def of(
        measured: Observed, profile: Profile, filter: Filter | None = None, count: Floats | None = None
    ) -> Systematic:
        """Systematic part of measured values.

        Parameters
        ----------
        measured : Observed
            With stretches of the profile; each height of each step is a level.
        profile : Profile
        filter : Filter, optional
        count : (parts,) float64, optional
            How many times each part counts; see `separate`.
        """
        places = FormPlaces(profile)
        stretch, s = places.of(measured.stretch, measured.s)
        separated = separate(replace(measured, stretch=stretch, s=s), places.stretches, filter, count)
        contour = places.contour[measured.stretch]
        number = len(profile.contours)
        offset, variance, known = np.zeros(number), np.zeros(number), np.ones(number, dtype=bool)
        level = {one.level: one for one in separated.levels}
        for wall in profile.steps:
            row = np.array(wall)
            bottom, _ = profile.heights(row)
            of_step = {n: np.unique(separated.observed.level[contour == k]).tolist() for n, k in enumerate(wall)}
            seen = [n for n, found in of_step.items() if found]
            if len(seen) < 2:
                known[row] = [n in seen for n in range(len(row))]
                continue
            means = [np.mean([level[k].mean for k in of_step[n]]) for n in seen]
            own = [np.mean([level[k].std ** 2 for k in of_step[n]]) / len(of_step[n]) for n in seen]
            offset[row] = np.interp(bottom, bottom[seen], means)
            # The measured heights are all there are, and no sample of others about whose mean they would tell.
            sample = separated.sizes.level**2 / sum(len(of_step[n]) for n in seen)
            variance[row] = np.interp(bottom, bottom[seen], own) - sample
            known[row] = (np.arange(len(row)) >= seen[0]) & (np.arange(len(row)) <= seen[-1])
        return Systematic(separated, places, offset, variance, known, measured)

    @property
    def at_points(self) -> tuple[Floats, Floats]:
        """Systematic part at the observed points and its standard uncertainty, (n,) each, mm."""
        return self._of_step(self.separated.systematic, self.separated.uncertainty, self.measured.stretch)

    def _of_step(self, mean: Floats, std: Floats, stretch: Ints) -> tuple[Floats, Floats]:
        contour = self.places.contour[stretch]
        known, std = self.known[contour], np.sqrt(np.maximum(std**2 + self.variance[contour], 0.0))
        return np.where(known, mean + self.offset[contour], 0.0), np.where(known, std, np.nan)

    def at(self, stretch: Ints, s: Floats) -> tuple[Floats, Floats]:
        """Systematic part and its standard uncertainty at any place, mm; (m,) each.

        Parameters
        ----------
        stretch : (m,) int64
        s : (m,) float64
            mm from the stretch's start.

        Returns
        -------
        mean, std : (m,) float64
            On a contour without points, and on steps that are not known, 0 and NaN.
        """
        return self._of_step(*self.separated.at(*self.places.of(stretch, s)), stretch)

    def unknown(self, stretch: Ints, s: Floats) -> Floats:
        """How much less is known at any place than where most is, as a share of the form's variance, 0 to 1; (m,).

        1 on a contour without points, and on steps that are not known.
        """
        open_ = self.separated.unknown(*self.places.of(stretch, s))
        out: Floats = np.where(self.known[self.places.contour[stretch]] & np.isfinite(open_), open_, 1.0)
        return out
