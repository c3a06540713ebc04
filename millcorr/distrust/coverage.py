# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a profile the points speak for: the rest is not corrected."""

from __future__ import annotations

import numpy as np

from millcorr.deviation import Deviation
from millcorr.filtering import Filter
from millcorr.gaps import wide_gaps
from millcorr.profile import Profile

from .findings import Finding

NOTICEABLE = 0.25
"""A larger share of a contour in gaps is worth a word."""

UNMEASURED = 0.6
"""A larger share is dangerous: most of the contour stays as it is. petrakov-2025 measures 45 % of its contour."""


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
    gaps = wide_gaps(deviation, profile, filter.cutoff)
    share = np.zeros(len(profile.contours))
    np.add.at(share, [gap.contour for gap in gaps], [gap.length for gap in gaps])
    share /= profile.total
    worst = int(np.argmax(share))
    if share[worst] <= NOTICEABLE:
        return ()
    there = [gap for gap in gaps if gap.contour == worst]
    gap = max(there, key=lambda g: g.length)
    ends = np.array([gap.begin, gap.begin + gap.length])
    length = float(profile.total[worst])
    if profile.contours[worst].closed:
        ends %= length
    (x0, y0), (x1, y1) = profile.at(np.full(2, worst), ends)[0]
    then = (
        f"runs out within {gap.reach:.3g} mm of the points and leaves the rest as it is"
        if gap.between
        else "holds its last value to the end of the contour"
    )
    text = (
        f"{100 * share[worst]:.0f} % of the contour of {length:.4g} mm has no usable point ({len(there)} "
        f"{'gap' if len(there) == 1 else 'gaps'}, the longest {gap.length:.4g} mm from X{x0:.3f} Y{y0:.3f} to "
        f"X{x1:.3f} Y{y1:.3f}): the correction {then}; measure there too"
    )
    return (Finding("unmeasured", text, bool(share[worst] > UNMEASURED)),)
