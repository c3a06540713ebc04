# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaps between measured points that are too wide to be bridged: what would be said of them is invented."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .deviation import Deviation
from .profile import Profile

SPACINGS = 5.0
"""A step of so many typical ones is a gap, as for the filters."""

LEAST, MOST = 0.05, 0.25
"""No gap is below the one share of its contour, and none that is above the other is bridged: four points, one each
quarter, tell the size of a bore."""


@dataclass(frozen=True, slots=True)
class Gap:
    """A piece of a contour that no measured point speaks for.

    Parameters
    ----------
    contour : int
    begin, length : float
        Arc length in mm from the contour's start, and mm; on a closed contour it may reach past the seam.
    between : bool
        Whether measured points lie at both ends; False at an end of an open contour, where the last value holds on.
    reach : float
        How far in mm a point speaks into it: half of the widest gap that is bridged.
    """

    contour: int
    begin: float
    length: float
    reach: float
    between: bool = True


def wide_gaps(deviation: Deviation, profile: Profile, cutoff: float) -> tuple[Gap, ...]:
    """Gaps that are wider than a correction may bridge.

    Parameters
    ----------
    deviation : Deviation
        Used points; those of all levels count.
    profile : Profile
        Nominal. Contours without any point are not corrected and not judged.
    cutoff : float
        Of the filter, in mm; half of it reaches to either side of a point. NaN where the filter has none.

    Returns
    -------
    tuple of Gap
        By contour and arc length.
    """
    found = []
    reaching = 0.0 if np.isnan(cutoff) else 0.5 * cutoff
    for contour in np.unique(deviation.contour):
        length = float(profile.total[contour])
        s = deviation.s[deviation.contour == contour]
        closed = profile.contours[contour].closed
        s = np.unique(np.round(s % length if closed else s, 6))
        if closed:
            begin, gaps = s, np.append(np.diff(s), s[0] + length - s[-1])
        else:
            # An end speaks for itself: what is beyond the outermost points was not measured either.
            begin, gaps = np.append(0.0, s), np.diff(s, prepend=0.0, append=length)
        least = float(np.clip(max(SPACINGS * np.median(gaps), reaching), LEAST * length, MOST * length))
        for i in np.flatnonzero(gaps > least + 1e-6):
            between = closed or 0 < i < len(gaps) - 1
            found.append(Gap(int(contour), float(begin[i]), float(gaps[i]), 0.5 * least, bool(between)))
    return tuple(found)
