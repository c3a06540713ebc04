# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a profile the points speak for: what lies between them is invented, not measured."""

from __future__ import annotations

import numpy as np

from millcorr.deviation import Deviation
from millcorr.filtering import Filter
from millcorr.profile import Profile

from .findings import Finding

GAP = 5.0
"""A step of so many typical ones is a gap, as for the filters."""

LEAST, MOST = 0.05, 0.25
"""No gap is below the one share of its contour, and none that is above the other is bridged: four points, one each
quarter, tell the size of a bore."""

NOTICEABLE = 0.25
"""A larger share of a contour in gaps is worth a word."""

UNMEASURED = 0.6
"""A larger share is dangerous: most of the correction is invented. petrakov-2025 measures 45 % of its contour."""


def examine_coverage(deviation: Deviation, profile: Profile, filter: Filter) -> tuple[Finding, ...]:
    """Whether the points speak for the whole of each contour that they lie on.

    Parameters
    ----------
    deviation : Deviation
        Used points; those of all levels count.
    profile : Profile
        Nominal. Contours without any point are not corrected and not judged.
    filter : Filter
        Half of its cutoff reaches to either side of a point.

    Returns
    -------
    tuple of Finding
        At most one, with the worst contour.
    """
    worst: tuple[float, str] | None = None
    for contour in np.unique(deviation.contour):
        length = float(profile.total[contour])
        s = np.unique(np.round(deviation.s[deviation.contour == contour] % length, 6))
        if profile.contours[contour].closed:
            begin, gaps = s, np.append(np.diff(s), s[0] + length - s[-1])
        else:
            # An end speaks for itself: what is beyond the outermost points was not measured either.
            s = np.unique(np.round(deviation.s[deviation.contour == contour], 6))
            begin, gaps = np.append(0.0, s), np.diff(s, prepend=0.0, append=length)
        reach = 0.0 if np.isnan(filter.cutoff) else 0.5 * filter.cutoff
        least = float(np.clip(max(GAP * np.median(gaps), reach), LEAST * length, MOST * length))
        wide = gaps > least
        share = float(gaps[wide].sum()) / length
        if share <= NOTICEABLE or (worst is not None and share <= worst[0]):
            continue
        at = int(np.argmax(gaps))
        ends, _ = profile.at(np.full(2, contour), np.array([begin[at], (begin[at] + gaps[at]) % length]))
        (x0, y0), (x1, y1) = ends
        text = (
            f"{100 * share:.0f} % of the contour of {length:.4g} mm has no usable point ({int(wide.sum())} "
            f"{'gap' if wide.sum() == 1 else 'gaps'}, the longest {gaps[at]:.4g} mm from X{x0:.3f} Y{y0:.3f} to "
            f"X{x1:.3f} Y{y1:.3f}): the correction there would be invented; measure there too"
        )
        worst = share, text
    return () if worst is None else (Finding("unmeasured", worst[1], worst[0] > UNMEASURED),)
