# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a profile is to be moved along its normal, everywhere: a function of arc length on each smooth stretch.

Positive is out of the material.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.geometry.profile import Profile, Stretch
from millcorr.tolerances import ALIKE


@dataclass(frozen=True, eq=False, slots=True)
class Course:
    """A correction along one stretch: a cubic spline over arc length.

    Parameters
    ----------
    breaks : (k + 1,) float64
        mm from the stretch's start.
    coefficient : (4, k) float64
        Powers of the distance from each break, lowest first, in mm.
    period : float
        Length of a closed stretch; 0 for an open one, where the end values hold on.
    """

    breaks: Floats
    coefficient: Floats
    period: float = 0.0

    @staticmethod
    def constant(value: float, length: float, closed: bool) -> Course:
        """The same correction everywhere."""
        return Course(np.array([0.0, length]), np.array([[value], [0.0], [0.0], [0.0]]), length if closed else 0.0)

    @staticmethod
    def through(s: Floats, value: Floats, length: float, closed: bool) -> Course:
        """Cubic spline through values at increasing arc lengths within one stretch (at least one).

        On an open stretch it runs out level at the first and the last value, so that holding them beyond makes
        no kink.
        """
        if len(s) == 1 or np.ptp(value) == 0.0:
            return Course.constant(float(value[0]), length, closed)
        from scipy.interpolate import CubicSpline

        if closed:
            spline = CubicSpline(np.append(s, s[0] + length), np.append(value, value[0]), bc_type="periodic")
        else:
            spline = CubicSpline(s, value, bc_type="clamped")
        return Course(np.array(spline.x), np.array(spline.c[::-1]), length if closed else 0.0)

    @property
    def is_constant(self) -> bool:
        """True where the correction is one number along the stretch."""
        return bool(
            np.ptp(self.coefficient[0]) < ALIKE
            and (np.abs(self.coefficient[1:, :]) * np.diff(self.breaks) ** np.arange(1, 4)[:, None]).max() < ALIKE
        )

    def __call__(self, s: Floats) -> tuple[Floats, Floats]:
        """Correction in mm and its slope at arc lengths from the stretch's start."""
        value, slope, _ = self.derivatives(s)
        return value, slope

    def derivatives(self, s: Floats) -> tuple[Floats, Floats, Floats]:
        """Correction in mm and its first two derivatives over arc length, at arc lengths from the start."""
        x = s
        if self.period:
            x = self.breaks[0] + np.mod(s - self.breaks[0], self.period)
            held = np.zeros(np.shape(s), dtype=bool)
        else:
            x = np.clip(s, self.breaks[0], self.breaks[-1])
            held = x != s
        i = np.clip(np.searchsorted(self.breaks, x, side="right") - 1, 0, self.coefficient.shape[1] - 1)
        h = x - self.breaks[i]
        a, b, c, d = self.coefficient[:, i]
        slope, bend = b + h * (2 * c + 3 * h * d), 2 * c + 6 * h * d
        return a + h * (b + h * (c + h * d)), np.where(held, 0.0, slope), np.where(held, 0.0, bend)

    @property
    def extreme(self) -> tuple[float, float]:
        """Arc length and value of the largest absolute correction, mm each; exact."""
        a, b, c, d = self.coefficient
        h = np.diff(self.breaks)
        # Roots of b + 2 c x + 3 d x^2, in the form that stays exact where d or c vanish.
        root = np.sqrt(np.maximum(c * c - 3 * b * d, 0.0))
        q = -(c + np.where(c < 0, -root, root))
        with np.errstate(divide="ignore", invalid="ignore"):
            inner = np.nan_to_num(np.stack([np.zeros_like(h), h, q / (3 * d), b / q]))
        x = np.clip(inner, 0.0, h)
        value = a + x * (b + x * (c + x * d))
        k, i = np.unravel_index(int(np.argmax(np.abs(value))), value.shape)
        return float(self.breaks[i] + x[k, i]), float(value[k, i])


@dataclass(frozen=True, eq=False, slots=True)
class Correction:
    """Where the profile is to be moved: one course a smooth stretch.

    Parameters
    ----------
    stretches : tuple of Stretch
        The profile's, by number.
    courses : tuple of Course
    """

    stretches: tuple[Stretch, ...]
    courses: tuple[Course, ...]

    @staticmethod
    def none(profile: Profile) -> Correction:
        """No correction anywhere."""
        return Correction.even(profile, 0.0)

    @staticmethod
    def even(profile: Profile, value: float) -> Correction:
        """The same shift everywhere, in mm, positive out of the material."""
        stretches = tuple(profile.stretches())
        return Correction(stretches, tuple(Course.constant(value, t.length, t.closed) for t in stretches))

    @property
    def largest(self) -> float:
        """Largest absolute correction in mm."""
        return max((abs(course.extreme[1]) for course in self.courses), default=0.0)

    def at(self, number: Ints, s: Floats, profile: Profile) -> Floats:
        """Correction in mm at arc lengths of the contour on the numbered stretches; (n,)."""
        progress.step()
        out = np.empty(len(s))
        for k in np.unique(number):
            rows = number == k
            out[rows] = self.courses[k](along(self.stretches[k], s[rows], profile))[0]
        return out


def along(stretch: Stretch, s: Floats, profile: Profile) -> Floats:
    """Arc length from the stretch's start, for arc lengths from the contour's start."""
    local: Floats = s - stretch.begin
    if profile.contours[stretch.contour].closed:
        total = float(profile.total[stretch.contour])
        # Rounding at its very ends, or an end at a whole turn, must not take a place to the other end.
        inside = (local >= -1e-6) & (local <= stretch.length + 1e-6) & (not stretch.closed)
        local = np.where(inside, local, np.mod(local + 1e-6, total) - 1e-6)
    return local


@dataclass(frozen=True, slots=True)
class LargestCorrection:
    """Where the profile is moved farthest.

    Parameters
    ----------
    value : float
        Signed correction in mm, positive out of the material.
    contour : int
    s : float
        mm from the contour's start.
    point : tuple of float
        x, y of the nominal in mm.
    """

    value: float
    contour: int
    s: float
    point: tuple[float, float]


def largest_correction(correction: Correction, nominal: Profile) -> LargestCorrection:
    """The largest correction and its place."""
    extremes = [course.extreme for course in correction.courses]
    k = int(np.argmax([abs(value) for _, value in extremes]))
    stretch, (along_stretch, value) = correction.stretches[k], extremes[k]
    s = stretch.begin + along_stretch
    if nominal.contours[stretch.contour].closed:
        s %= float(nominal.total[stretch.contour])
    point, _ = nominal.at(stretch.contour, np.array([s]))
    return LargestCorrection(value, stretch.contour, s, (float(point[0, 0]), float(point[0, 1])))
