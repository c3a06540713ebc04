# SPDX-License-Identifier: LGPL-2.1-or-later
"""From deviations to the correction: how far the profile is to be moved along its normal, everywhere.

A correction is a function of arc length on every smooth stretch of the profile, positive out of the material;
mirroring a deviation d gives -g d (werner-2018, eqs. 2 and 3, with gain g).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import LimitError
from millcorr.geometry.correction import Correction, Course, along
from millcorr.geometry.profile import Profile, Stretch
from millcorr.messages import mm, option, phrase, xy

NEAR = 0.01
"""Points nearer to each other than this, in mm, are averaged: no machine follows waves so short."""

GAP_SPACINGS = 10.0
"""A gap between points longer than this many typical spacings is bridged by a straight line and reported."""


def dead_band(value: Floats, band: float) -> Floats:
    """Leave values within the band uncorrected; 0 inside, whole from twice the band on, smooth between.

    Parameters
    ----------
    value : (n,) float64
        mm.
    band : float
        mm; 0 changes nothing.
    """
    if band <= 0:
        return value
    x = np.clip(np.abs(value) / band - 1.0, 0.0, 1.0)
    out: Floats = value * x * x * (3 - 2 * x)
    return out


def correction_from(
    profile: Profile,
    number: Ints,
    s: Floats,
    value: Floats,
    *,
    limit: float,
) -> tuple[Correction, tuple[str, ...]]:
    """Correction through values at points.

    Parameters
    ----------
    profile : Profile
    number : (n,) int64
        Stretch of each point.
    s : (n,) float64
        Arc length from the contour's start, mm.
    value : (n,) float64
        Wanted displacement of the profile along its normal, mm.
    limit : float
        Largest displacement allowed, mm.

    Returns
    -------
    Correction
    warnings : tuple of str
        Gaps that were bridged or left, stretches without a point.

    Raises
    ------
    LimitError
        If a value, or the correction between two points, exceeds the limit; names the place.
    """
    stretches = tuple(profile.stretches())
    worst = int(np.argmax(np.abs(value))) if len(value) else 0
    if len(value) and abs(value[worst]) > limit:
        point, _ = profile.at(stretches[int(number[worst])].contour, np.array([s[worst]]))
        raise beyond_the_limit(value, worst, (float(point[0, 0]), float(point[0, 1])), limit)
    courses: list[Course | None] = []
    warnings: list[str] = []
    for k, stretch in enumerate(stretches):
        rows = np.flatnonzero(number == k)
        if not len(rows):
            courses.append(None)
            continue
        local = along(stretch, s[rows], profile)
        x, y = _merged(local, value[rows], stretch)
        if len(x) == 1:
            warnings.append(_one_place(profile, stretch, float(x[0]), float(y[0])))
        x, y, bridges = _bridged(x, y, stretch)
        course = Course.through(x, y, stretch.length, stretch.closed)
        refuse_swing(profile, stretch, course, limit)
        courses.append(course)
        if bridges:
            a, b = max(bridges, key=lambda bridge: bridge[1] - bridge[0])
            p, _ = profile.at(stretch.contour, np.array([stretch.begin + a, stretch.begin + b]))
            more = phrase(" and {} shorter gaps", len(bridges) - 1) if len(bridges) > 1 else ""
            warnings.append(
                phrase(
                    "no usable point on {} between {} and {}{}: the correction runs straight across or holds its "
                    "last value",
                    mm(b - a, ".2f"),
                    xy(p[0, 0], p[0, 1]),
                    xy(p[1, 0], p[1, 1]),
                    more,
                )
            )
    warnings += _fill_unmeasured(profile, stretches, courses)
    return Correction(stretches, tuple(c for c in courses if c is not None)), tuple(warnings)


def _one_place(profile: Profile, stretch: Stretch, at: float, value: float) -> str:
    p, _ = profile.at(stretch.contour, np.array([stretch.begin + at]))
    return phrase(
        "the stretch of {} through {} was measured at that place only: {} hold all along it",
        mm(stretch.length),
        xy(p[0, 0], p[0, 1]),
        mm(value, "+.4f"),
    )


def beyond_the_limit(value: Floats, worst: int, place: tuple[float, float], limit: float) -> LimitError:
    """The error that the largest of some corrections, in mm, is beyond the limit at a place."""
    x, y = place
    return LimitError(
        phrase(
            "a correction of {} is needed at {} ({} points), more than {}; nothing was corrected: look at the place "
            "in the report of a check, and say a larger {} if it is right",
            mm(value[worst], "+.4f"),
            xy(x, y),
            int((np.abs(value) > limit).sum()),
            option("limit", limit),
            option("limit"),
        ),
        place=place,
        figure=float(value[worst]),
    )


def refuse_swing(profile: Profile, stretch: Stretch, course: Course, limit: float) -> None:
    """LimitError where a course exceeds the limit, mm; names the place."""
    at, value = course.extreme
    if abs(value) > limit * (1 + 1e-9):
        p, _ = profile.at(stretch.contour, np.array([stretch.begin + at]))
        raise LimitError(
            phrase(
                "between the points the correction swings to {} at {}, more than {}: use a stronger {}; "
                "nothing was corrected",
                mm(value, "+.4f"),
                xy(p[0, 0], p[0, 1]),
                option("limit", limit),
                option("filter"),
            ),
            place=(float(p[0, 0]), float(p[0, 1])),
            figure=float(value),
        )


def _merged(s: Floats, value: Floats, stretch: Stretch) -> tuple[Floats, Floats]:
    """Sort by arc length and average points that nearly coincide, so that noise is not made into slope.

    Nearly means nearer than `NEAR`, or than a quarter of the spacing there: a scan repeated gives pairs, a place
    scanned more finely than the rest keeps its detail. The seam of a closed stretch makes no difference.
    """
    if len(s) < 2:
        return s, value
    order = np.argsort(s, kind="stable")
    s, value = s[order], value[order]
    origin = 0.0
    if stretch.closed:
        # Count from behind the widest gap: no points that belong together lie on both sides of the start.
        step = np.diff(s, append=s[0] + stretch.length)
        widest = int(np.argmax(step)) + 1
        origin = float(s[widest % len(s)])
        s = np.concatenate([s[widest:], s[:widest] + stretch.length]) - origin
        value = np.roll(value, -widest)
    count = np.ones(len(s))
    if np.diff(s).min() < NEAR:
        s, value, count = _averaged(np.floor((s - s[0]) / NEAR), s, value, count)
        # Means of neighbouring cells may still nearly coincide, but never three in a row.
        s, value, count = _averaged(_apart(s, NEAR / 2), s, value, count)
    if len(s) > 1:
        s, value, count = _averaged(_apart(s, 0.25 * _spacing(s, stretch.length)), s, value, count)
    s = s + origin
    if stretch.closed:
        turned = int(np.searchsorted(s, stretch.length))
        s = np.concatenate([s[turned:] - stretch.length, s[:turned]])
        value = np.roll(value, -turned)
    return s, value


def _spacing(s: Floats, length: float, reach: int = 8) -> Floats:
    """Mean spacing about each interval between increasing `s`, over up to `reach` points to either side."""
    if len(s) < 4:
        return np.full(len(s) - 1, length / len(s))
    i = np.arange(len(s) - 1)
    low, high = np.maximum(i - reach + 1, 0), np.minimum(i + reach, len(s) - 1)
    out: Floats = (s[high] - s[low]) / (high - low)
    return out


def _apart(s: Floats, least: Floats | float) -> Ints:
    """Number of the group of each of increasing `s`; a new one starts behind an interval of at least `least`."""
    out: Ints = np.cumsum(np.append(True, np.diff(s) >= least)).astype(np.int64)
    return out


def _averaged(group: Floats | Ints, s: Floats, value: Floats, count: Floats) -> tuple[Floats, Floats, Floats]:
    """Means of the groups and their counts."""
    _, inverse = np.unique(group, return_inverse=True)
    total: Floats = np.bincount(inverse, count).astype(np.float64)
    return np.bincount(inverse, s * count) / total, np.bincount(inverse, value * count) / total, total


def _bridged(s: Floats, value: Floats, stretch: Stretch) -> tuple[Floats, Floats, list[tuple[float, float]]]:
    """Add supports on a straight line across long gaps, and hold the end values of an open stretch."""
    gaps: list[tuple[float, float]] = []
    if len(s) < 2:
        return s, value, gaps
    ends_s, ends_v = s, value
    if stretch.closed:
        ends_s, ends_v = np.append(s, s[0] + stretch.length), np.append(value, value[0])
    step = np.diff(ends_s)
    typical = float(np.median(step))
    extra_s, extra_v = [s], [value]
    for i in np.flatnonzero(step > GAP_SPACINGS * typical):
        count = int(min(step[i] / typical, 200))
        x = ends_s[i] + step[i] * np.arange(1, count) / count
        extra_s.append(x)
        extra_v.append(ends_v[i] + (ends_v[i + 1] - ends_v[i]) * np.arange(1, count) / count)
        gaps.append((float(ends_s[i]), float(ends_s[i + 1])))
    if not stretch.closed:
        for end, at, inner in ((0.0, s[0], value[0]), (stretch.length, s[-1], value[-1])):
            room = abs(at - end)
            if room > GAP_SPACINGS * typical:
                gaps.append((min(end, float(at)), max(end, float(at))))
            # Where no room is left the course itself runs out level at its last point.
            if room > 0.25 * typical:
                count = int(min(room / typical, 200)) + 1
                extra_s.append(at + (end - at) * np.arange(1, count + 1) / count)
                extra_v.append(np.full(count, inner))
    all_s, all_v = np.concatenate(extra_s), np.concatenate(extra_v)
    if stretch.closed:
        all_s = np.mod(all_s, stretch.length)
    order = np.argsort(all_s, kind="stable")
    all_s, all_v = all_s[order], all_v[order]
    apart = np.concatenate([[True], np.diff(all_s) > 1e-9])
    return all_s[apart], all_v[apart], gaps


def _fill_unmeasured(profile: Profile, stretches: Sequence[Stretch], courses: list[Course | None]) -> list[str]:
    """Stretches without a point lead from one measured neighbour's end to the other's, in place; says so."""
    notes: list[str] = []
    with_points = [i for i, course in enumerate(courses) if course is not None]
    for k, stretch in enumerate(stretches):
        if courses[k] is not None:
            continue
        measured = [i for i in with_points if stretches[i].contour == stretch.contour]
        p, _ = profile.at(stretch.contour, np.array([stretch.begin + stretch.length / 2]))
        where = phrase("the stretch of {} near {} has no usable point", mm(stretch.length), xy(p[0, 0], p[0, 1]))
        if not measured:
            courses[k] = Course.constant(0.0, stretch.length, stretch.closed)
            notes.append(phrase("{}: it is not corrected", where))
            continue
        total = float(profile.total[stretch.contour])
        middle = stretch.begin + stretch.length / 2
        ends = []
        for i in measured:
            other, course = stretches[i], courses[i]
            assert course is not None
            for at in (0.0, other.length):
                away = other.begin + at - middle
                if profile.contours[stretch.contour].closed:
                    away = (away + total / 2) % total - total / 2
                ends.append((away, float(course(np.array([at]))[0][0])))
        before = max((e for e in ends if e[0] <= 0), default=None)
        after = min((e for e in ends if e[0] > 0), default=None)
        first = before or after
        last = after or before
        assert first is not None and last is not None
        # Several such stretches in a row share one straight line from neighbour to neighbour.
        x = np.array([0.0, stretch.length])
        y = np.interp(x - stretch.length / 2, [first[0], last[0]], [first[1], last[1]])
        courses[k] = Course.through(x, y, stretch.length, False)
        notes.append(phrase("{}: it follows its neighbours, {} to {}", where, mm(y[0], "+.4f"), mm(y[1], "+.4f")))
    return notes
