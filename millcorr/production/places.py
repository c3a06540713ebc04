# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along the nominal that are the same for all parts, and fields over them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.correction.compensation import correction_from
from millcorr.errors import InputError
from millcorr.geometry.correction import Correction, Course
from millcorr.geometry.profile import Profile, Stretch
from millcorr.messages import phrase
from millcorr.tolerances import EXACT

SPACING = 0.5
"""Distance of places in mm: a cubic spline through them returns a wave of 3 mm to 0.3 %."""

FEWEST, MOST = 8, 2000
"""Places on one stretch."""


@dataclass(frozen=True, eq=False, slots=True)
class Places:
    """Even places on every smooth stretch of a profile.

    Parameters
    ----------
    stretches : tuple of Stretch
    counts : tuple of int
        Number of places on each; on an open stretch the outer ones are its ends.
    """

    stretches: tuple[Stretch, ...]
    counts: tuple[int, ...]

    @staticmethod
    def of(profile: Profile) -> Places:
        """The places of a nominal."""
        stretches = tuple(profile.stretches())
        return Places(stretches, tuple(int(np.clip(np.ceil(t.length / SPACING), FEWEST, MOST)) for t in stretches))

    def __len__(self) -> int:
        return sum(self.counts)

    def s(self, number: int) -> Floats:
        """Arc lengths in mm from the start of a stretch, (counts[number],)."""
        stretch, count = self.stretches[number], self.counts[number]
        return np.linspace(0.0, stretch.length, count, endpoint=not stretch.closed)

    def along(self) -> tuple[Ints, Floats]:
        """Stretch of every place, and arc length in mm from its start; (n,) each."""
        stretch = np.repeat(np.arange(len(self.counts)), self.counts)
        return stretch, np.concatenate([self.s(k) for k in range(len(self.counts))])

    def normals(self, profile: Profile) -> Floats:
        """Directional cosines at the places, (n, 2)."""
        normals = [profile.at(t.contour, t.begin + self.s(k))[1] for k, t in enumerate(self.stretches)]
        return np.concatenate(normals)

    def sampled(self, profile: Profile, deviation: Deviation, value: Floats) -> Floats:
        """A value known at measured points, at the places.

        Parameters
        ----------
        profile : Profile
            Whose places these are.
        deviation : Deviation
            The points.
        value : (m,) float64
            mm, one a point. Levels are averaged along the contour, each through a curve of its own.

        Returns
        -------
        (n,) float64
            mm; NaN on stretches without a point.
        """
        total = np.zeros(len(self))
        levels = np.unique(deviation.level)
        count = np.zeros(len(self))
        ends = np.cumsum(self.counts)
        for level in levels:
            rows = deviation.level == level
            field, _ = correction_from(profile, deviation.stretch[rows], deviation.s[rows], value[rows], limit=np.inf)
            measured = np.isin(np.arange(len(self.stretches)), deviation.stretch[rows])
            for k in np.flatnonzero(measured).tolist():
                here = slice(ends[k] - self.counts[k], ends[k])
                total[here] += field.courses[k](self.s(k))[0]
                count[here] += 1
        out: Floats = np.where(count > 0, total / np.maximum(count, 1), np.nan)
        return out

    def of_correction(self, correction: Correction) -> Floats:
        """A correction at the places, (n,), mm."""
        return np.concatenate([course(self.s(k))[0] for k, course in enumerate(correction.courses)])

    def field(self, value: Floats) -> Correction:
        """Smooth field along the contour through finite values at the places, mm."""
        parts = np.split(value, np.cumsum(self.counts)[:-1])
        courses = [
            Course.through(self.s(k), part, stretch.length, stretch.closed)
            for k, (stretch, part) in enumerate(zip(self.stretches, parts, strict=True))
        ]
        return Correction(self.stretches, tuple(courses))

    def text(self) -> str:
        """As JSON."""
        rows = zip(self.stretches, self.counts, strict=True)
        return json.dumps([[t.contour, t.begin, t.length, t.closed, count] for t, count in rows])

    @staticmethod
    def from_text(text: str) -> Places:
        """From JSON; ValueError or TypeError where it is damaged."""
        rows: Sequence[Sequence[float]] = json.loads(text)
        stretches = tuple(Stretch(int(r[0]), float(r[1]), float(r[2]), bool(r[3])) for r in rows)
        return Places(stretches, tuple(int(r[4]) for r in rows))

    def same(self, other: Places) -> bool:
        """True where both belong to the same nominal, as far as lengths tell."""
        if self.counts != other.counts:
            return False
        return all(
            a.contour == b.contour
            and a.closed == b.closed
            and abs(a.begin - b.begin) < EXACT
            and abs(a.length - b.length) < EXACT
            for a, b in zip(self.stretches, other.stretches, strict=True)
        )


def field_in_text(places: Places, value: Floats, measured: Sequence[str]) -> str:
    """A field through values at the places, (n,) mm, as text, with the fingerprints of what it follows from."""
    return json.dumps({"places": json.loads(places.text()), "value": value.tolist(), "measured": list(measured)})


def field_of_text(text: str, measured: Sequence[str]) -> Correction | None:
    """The field of a text of `field_in_text`; None where it follows from other measurements.

    Raises
    ------
    InputError
        If the text is none.
    """
    try:
        read = json.loads(text)
        places, value = Places.from_text(json.dumps(read["places"])), np.array(read["value"], dtype=np.float64)
        if value.shape != (len(places),) or not np.isfinite(value).all():
            raise ValueError("values and places do not belong together")
        return places.field(value) if read["measured"] == list(measured) else None
    except (ValueError, TypeError, LookupError) as error:
        raise InputError(
            phrase("the smoothed deviation of a series is damaged ({}): correct from the part again", error)
        ) from (error)
