# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a correction is largest, and how much it is there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import Profile


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
