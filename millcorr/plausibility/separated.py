# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the model of the deviations shows: how much of a contour nobody measured, how many points are wrong, heights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.comparison.deviation import Deviation
from millcorr.geometry.profile import Profile, Stretch
from millcorr.messages import at_z, option, phrase, um, xy
from millcorr.separation import Separated

from .findings import Finding

NOTICEABLE = 0.1
"""From this share of outliers on a word is said: two in a hundred are in every file of a measuring machine."""

MANY = 1.0 / 3.0
"""From this share on it cannot be told which points are the wrong ones."""

BETWEEN = 0.25
"""On a closed contour a gap of up to this share is bridged: four points, one each quarter, tell the size of a bore."""

CORRELATED = 0.95
"""Lengths of the form at which its correlation has fallen to one half (Matern 5/2)."""

LEANING = 0.002
"""Differences between heights below this, in mm, are not worth a word."""


def examine_separated(
    deviation: Deviation, separated: Separated, profile: Profile, unmeasured_share: float
) -> tuple[Finding, ...]:
    """Whether the points speak for their contours, whether most of them can be believed, and whether heights agree.

    Parameters
    ----------
    deviation : Deviation
        Used points of the first part.
    separated : Separated
        What repeats of all parts.
    profile : Profile
    unmeasured_share : float
        Largest share of a contour that may be unmeasured.

    Returns
    -------
    tuple of Finding
    """
    return (
        *_unmeasured(separated, profile, unmeasured_share),
        *_outliers(deviation, separated),
        *_heights(separated, profile),
    )


@dataclass(frozen=True, slots=True)
class Gap:
    """Places of a contour that no sound point is near.

    Parameters
    ----------
    contour : int
    begin, end : float
        mm from the contour's start; `end` may lie past its seam.
    points : (float, float)
        The points before and behind, or the contour's ends, mm.
    """

    contour: int
    begin: float
    end: float
    points: tuple[float, float]


def _stretches(separated: Separated, profile: Profile) -> list[Stretch]:
    """Stretches that have a form: steps of a wall speak for it together, on one of them."""
    return [t for t in profile.stretches() if t.contour in separated.stretches.contour]


def gaps(separated: Separated, profile: Profile, bridged: float = 0.0) -> tuple[Gap, ...]:
    """Where on the measured contours the systematic part rests on no points: the form there is not that of any of them.

    Parameters
    ----------
    separated : Separated
    profile : Profile
    bridged : float
        Between points nearer than this share of the contour nothing is a gap.
    """
    seen, trusted = separated.observed, ~separated.outlier
    begin = np.array([stretch.begin for stretch in _stretches(separated, profile)])
    of = separated.stretches.contour[seen.stretch]
    out = []
    for contour in np.unique(of[trusted]):
        length, closed = float(profile.total[contour]), profile.contours[contour].closed
        # However smooth the form, points at one end of a contour do not speak for the other.
        reach = min(CORRELATED * separated.sizes.form_length, 0.5 * BETWEEN * length)
        rows = trusted & (of == contour)
        s = begin[seen.stretch[rows]] + seen.s[rows]
        s = np.sort(np.mod(s, length) if closed else s)
        before = s if closed else np.append(0.0, s)
        behind = np.append(s[1:], s[0] + length) if closed else np.append(s, length)
        low, high = before + reach, behind - reach
        if not closed:
            low[0], high[-1] = 0.0, length
        for i in np.flatnonzero((behind - before > bridged * length) & (high > low)):
            ends = float(before[i]), float(behind[i])
            out.append(Gap(int(contour), float(low[i]), float(high[i]), ends))
    return tuple(out)


def unmeasured(separated: Separated, profile: Profile) -> float:
    """Largest share of a measured contour that no sound point is near, 0 to 1."""
    return _largest_share(gaps(separated, profile, BETWEEN), profile)


def _largest_share(wide: Sequence[Gap], profile: Profile) -> float:
    shares = np.zeros(len(profile.contours))
    for gap in wide:
        shares[gap.contour] += (gap.end - gap.begin) / float(profile.total[gap.contour])
    return float(shares.max(initial=0.0))


def _unmeasured(separated: Separated, profile: Profile, most: float) -> tuple[Finding, ...]:
    wide = gaps(separated, profile, BETWEEN)
    share = _largest_share(wide, profile)
    if share <= most:
        return ()
    widest = max(wide, key=lambda gap: gap.end - gap.begin)
    ends = np.array(widest.points)
    if profile.contours[widest.contour].closed:
        ends %= float(profile.total[widest.contour])
    (x0, y0), (x1, y1) = profile.at(np.full(2, widest.contour), ends)[0]
    text = phrase(
        "{:.0f} % of the contour has no measured point near, most of it between {} and {}: measure "
        "there, or say with {} how much may be left to the mean",
        100 * share,
        xy(x0, y0),
        xy(x1, y1),
        option("unmeasured_share", of="SHARE"),
    )
    return (Finding("unmeasured", text, True, place=(float(x0), float(y0)), figure=share),)


def _outliers(deviation: Deviation, separated: Separated) -> tuple[Finding, ...]:
    wrong = separated.outlier
    share = float(wrong.mean()) if len(wrong) else 0.0
    if share <= NOTICEABLE:
        return ()
    first = np.flatnonzero(wrong[: len(deviation)])
    counts = int(wrong.sum()), len(wrong)
    text = phrase("{} of {} points are outliers: clean the part and the probe, measure again", *counts)
    if len(first):
        place = xy(*deviation.foot[first[0]])
        text = phrase(
            "{} of {} points are outliers, the first at {}: clean the part and the probe, measure again", *counts, place
        )
    return (Finding("outliers", text, share > MANY, figure=share),)


def _heights(separated: Separated, profile: Profile) -> tuple[Finding, ...]:
    """A wall that leans is not corrected by its mean without a word: how much, and where the most."""
    if any(len(wall) > 1 for wall in profile.steps):
        # Its steps are heights with passes of their own, each corrected by its own.
        return ()
    mean = {one.level: one.mean for one in separated.levels}
    differing = [one.level for one in separated.levels if one.significant]
    most, low, high, where = 0.0, 0, 0, phrase("all along")
    if len(differing) >= 2:
        low, high = min(differing, key=mean.__getitem__), max(differing, key=mean.__getitem__)
        most = mean[high] - mean[low]
    lean = separated.lean
    if lean is not None and lean.significant.any():
        worst = int(np.argmax(np.where(lean.significant, np.abs(lean.difference), 0.0)))
        there = abs(float(lean.difference[worst]))
        if there > most + LEANING:
            most, low, high = there, lean.low, lean.high
            if lean.difference[worst] < 0.0:
                low, high = high, low
            stretch = _stretches(separated, profile)[lean.stretch[worst]]
            contour, at = stretch.contour, stretch.begin + float(lean.s[worst])
            if profile.contours[contour].closed:
                at %= float(profile.total[contour])
            x, y = profile.at(np.array([contour]), np.array([at]))[0][0]
            where = phrase("at {}, {} on the average", xy(x, y), um(mean[high] - mean[low], "+.1f"))
    if most < LEANING:
        return ()
    seen = separated.observed
    height = seen.level if seen.z is None else seen.z
    z = [float(height[seen.level == level].mean()) for level in (high, low)]
    text = phrase(
        "the wall leans: at {} it has {} more than at {} {}; one path corrects the mean of the "
        "heights: a spring pass or less overhang of the tool takes the lean away",
        at_z(z[0]),
        um(most),
        at_z(z[1]),
        where,
    )
    return (Finding("many-levels", text, False),)
