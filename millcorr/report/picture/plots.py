# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots of a correction as arrays that any toolkit can draw, and where on the part each place of them is.

All contours lie one after the other on one axis: arc length from the start of the first one. Lengths along it in mm,
deviations in micrometres.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.geometry.correction import along as along_stretch
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile, Stretch
from millcorr.pipeline import Result
from millcorr.production import history, trend
from millcorr.production.journal import Entry
from millcorr.report.plots import COVERAGE, UM, class_width, corners, course
from millcorr.report.posterior import posteriors, runs

from .correction import Lines, thinned
from .probing import joined

MOST_POINTS = 20_000
"""So many points are drawn; of each group of neighbours the one with the largest deviation."""

MARK = 0xE000C0FF
"""Colour 0xRRGGBBAA of the place that is pointed at."""

SPACING = 0.5
"""Points of a stretch that is to be brought into view are this far apart, mm, as long as they are not too many."""

MOST_PLACES = 2000

RING = 0.012
"""Radius of the ring about the place that is pointed at, as a share of the part's size."""

REACH = 0.1
"""Farther than this from the contour, as a share of the part's size, nothing is pointed at."""


@dataclass(frozen=True, eq=False, slots=True)
class Course:
    """Determined part of one stretch and level, without long gaps; of a stretch through its gaps where a model says it.

    Parameters
    ----------
    level : int
    x : (k,) float64
        mm.
    value, low, high : (k,) float64
        Determined part, and the ends of its band of uncertainty, um; NaN where that is not known.
    whole_low, whole_high : (k,) float64
        Ends of the band that holds along the whole contour with 95 %, um; NaN where that is not known.
    bare : bool
        Whether no sound point is near.
    """

    level: int
    x: Floats
    value: Floats
    low: Floats
    high: Floats
    whole_low: Floats
    whole_high: Floats
    bare: bool


@dataclass(frozen=True, eq=False, slots=True)
class Along:
    """Deviations along the contours.

    Parameters
    ----------
    x : (n,) float64
        Place of every deviation, mm.
    raw, predicted : (n,) float64
        Before, and expected after the correction, um.
    rows : (m,) int64
        Deviations to draw as points.
    outliers : (o,) int64
        Deviations to mark as outliers.
    courses : tuple of Course
    starts : (c,) float64
        Where each contour begins.
    corners : (k,) float64
    total : float
        End of the axis.
    coverage : float
        Factor k of the band of uncertainty.
    """

    x: Floats
    raw: Floats
    predicted: Floats
    rows: Ints
    outliers: Ints
    courses: tuple[Course, ...]
    starts: Floats
    corners: Floats
    total: float
    coverage: float


@dataclass(frozen=True, eq=False, slots=True)
class Distribution:
    """Histogram of the deviations.

    Parameters
    ----------
    edges : (k + 1,) float64
        um.
    before, predicted : (k,) int64
        Points in each class.
    bell_x, bell : (m,) float64
        Normal law of the random part about the predicted mean; empty where it is not known or narrower than a class.
    """

    edges: Floats
    before: Ints
    predicted: Ints
    bell_x: Floats
    bell: Floats


@dataclass(frozen=True, eq=False, slots=True)
class Series:
    """Parts of a series, in their order.

    Parameters
    ----------
    part : (n,) int64
    mean, std, low, high : (n,) float64
        Mean deviation, its standard deviation, least and greatest, um.
    form : (n,) float64
        Root mean square of the form that the parts share, as much of it as each shows, um; NaN where not known.
    smoothed, limit : (n,) float64
        Largest smoothed deviation, and the limit beyond which the program is corrected, um; NaN without a control.
    corrected : (n,) bool
        The program was changed after this part.
    """

    part: Ints
    mean: Floats
    std: Floats
    low: Floats
    high: Floats
    form: Floats
    smoothed: Floats
    limit: Floats
    corrected: Bools


def along(result: Result) -> Along:
    """Deviations along the contours of a result.

    Parameters
    ----------
    result : Result

    Returns
    -------
    Along
    """
    d, profile = result.deviation, result.nominal
    starts = _starts(profile)
    shown = thinned(result, MOST_POINTS)
    at = [starts[k] + corners(profile, k) for k in range(len(profile.contours))]
    return Along(
        x=d.s + starts[d.contour],
        raw=UM * d.value,
        predicted=UM * result.predicted,
        rows=shown[~result.outlier[shown]],
        outliers=np.flatnonzero(result.outlier),
        courses=tuple(_courses_of_model(result, starts) or _courses_of_points(result)),
        starts=starts[:-1],
        corners=np.concatenate(at),
        total=float(starts[-1]),
        coverage=COVERAGE,
    )


def _courses_of_model(result: Result, starts: Floats) -> list[Course]:
    """What the model says along every stretch, through gaps and on sides without a point, too."""
    stretches = result.nominal.stretches()
    courses = []
    for row in posteriors(result):
        stretch = stretches[row.stretch]
        edges = [row.value + sign * factor * row.std for factor in (COVERAGE, row.band) for sign in (-1.0, 1.0)]
        for bare, here in runs(row.bare):
            columns = [values[here] for values in (row.value, *edges)]
            courses += _turned(0, starts, stretch, row.s[here], columns, bare)
    return courses


def _turned(
    level: int, starts: Floats, stretch: Stretch, s: Floats, columns: Sequence[Floats], bare: bool
) -> list[Course]:
    """Course of a stretch; what runs past the seam is drawn at the other end, as far as nothing is drawn there."""
    first, last = float(starts[stretch.contour]), float(starts[stretch.contour + 1])
    x = first + stretch.begin + s
    return [
        _cut(level, x + turn, columns, low, high, bare)
        for turn, low, high in (
            (0.0, first, last),
            (first - last, first, min(last, x[0])),
            (last - first, max(first, x[-1]), last),
        )
        if max(x[0] + turn, low) < min(x[-1] + turn, high)
    ]


def _courses_of_points(result: Result) -> list[Course]:
    """Lines through the determined part at the points, by stretch and level."""
    d, profile = result.deviation, result.nominal
    starts = _starts(profile)
    half = COVERAGE * result.uncertainty
    courses = []
    stretches = profile.stretches()
    levels = int(d.level.max(initial=-1)) + 1
    key = d.stretch * max(levels, 1) + d.level
    for one in np.unique(key):
        rows, stretch = np.flatnonzero(key == one), stretches[int(one) // levels]
        local = along_stretch(stretch, d.s[rows], profile)
        columns = [
            course(local, value, stretch.length, stretch.closed)
            for value in (result.filtered[rows], (result.filtered - half)[rows], (result.filtered + half)[rows])
        ]
        for (s, value), (_, low), (_, high) in zip(*columns, strict=True):
            unknown = np.full(len(s), np.nan)
            courses += _turned(int(one) % levels, starts, stretch, s, (value, low, high, unknown, unknown), False)
    return courses


def _cut(level: int, x: Floats, columns: Sequence[Floats], first: float, last: float, bare: bool) -> Course:
    """Course between two places, its ends interpolated; from mm to um."""
    places = np.concatenate([[max(x[0], first)], x[(x > first) & (x < last)], [min(x[-1], last)]])
    value, low, high, whole_low, whole_high = (UM * np.interp(places, x, column) for column in columns)
    return Course(level, places, value, low, high, whole_low, whole_high, bare)


def _starts(profile: Profile) -> Floats:
    """Where each contour begins on the axis, and where the last one ends; (c + 1,)."""
    return np.concatenate([[0.0], np.cumsum(profile.total)])


def distribution(result: Result) -> Distribution:
    """Histogram of a result's deviations, before and as predicted.

    Parameters
    ----------
    result : Result

    Returns
    -------
    Distribution
        Empty where there are no deviations.
    """
    none = np.zeros(0)
    if not len(result.deviation):
        return Distribution(np.zeros(1), none.astype(np.int64), none.astype(np.int64), none, none)
    a, b = UM * result.deviation.value, UM * result.predicted
    low, high = float(min(a.min(), b.min(), 0.0)), float(max(a.max(), b.max(), 0.0))
    width = class_width(a, b, high - low)
    first = math.floor(low / width)
    last = max(math.floor(high / width) + 1, first + 1)
    edges: Floats = np.arange(first, last + 1, dtype=np.float64) * width
    before, predicted = (np.histogram(v, edges)[0].astype(np.int64) for v in (a, b))
    sigma = UM * result.random_std
    peak = len(b) * width / (sigma * math.sqrt(2 * math.pi)) if sigma > 0 else math.inf
    if peak > 2 * max(before.max(), predicted.max()):
        # Narrower than a class, it would dwarf what it is compared with.
        return Distribution(edges, before, predicted, none, none)
    at = float(b.mean()) + sigma * np.linspace(-4.0, 4.0, 161)
    bell = peak * np.exp(-0.5 * ((at - b.mean()) / sigma) ** 2)
    return Distribution(edges, before, predicted, at, bell)


def series(entries: Sequence[Entry]) -> Series:
    """Parts of a series as arrays.

    Parameters
    ----------
    entries : sequence of Entry
    """
    rows = [entry.statistics["deviation"] for entry in entries]
    columns = {name: UM * np.array([float(row[name]) for row in rows]) for name in ("mean", "std", "min", "max")}
    form, _ = history.machine(entries)[trend.FORM]
    return Series(
        np.array([entry.part or number for number, entry in enumerate(entries, 1)], dtype=np.int64),
        columns["mean"],
        columns["std"],
        columns["min"],
        columns["max"],
        UM * form,
        UM * np.array([float(entry.statistics.get("smoothed", np.nan)) for entry in entries]),
        UM * np.array([float(entry.settings.get("control", {}).get("limit", np.nan)) for entry in entries]),
        np.array([entry.corrected for entry in entries], dtype=bool),
    )


# From a place of the plot to the part, and back ----------------------------------------------------------


def place_of(result: Result, row: int) -> float:
    """Place on the axis of a deviation, mm."""
    d = result.deviation
    return float(_starts(result.nominal)[d.contour[row]] + d.s[row])


def row_near(result: Result, point: Floats) -> int:
    """Deviation that was measured nearest to a point of the wall, (3,) in mm; -1 where there is none."""
    d, measurement = result.deviation, result.request.measurement
    if not len(d):
        return -1
    away = np.hypot(d.foot[:, 0] - point[0], d.foot[:, 1] - point[1])
    if measurement is not None and measurement.has_z:
        away = np.hypot(away, d.z - point[2])
    return int(away.argmin())


def nearest(plot: Along, x: float) -> int:
    """Deviation that lies nearest to a place of the axis; -1 where there is none."""
    return int(np.abs(plot.x - x).argmin()) if len(plot.x) else -1


def mark(result: Result, x: float) -> Lines:
    """A ring about a place of the nominal, and a stroke along its normal.

    Parameters
    ----------
    result : Result
    x : float
        Place on the axis, mm.
    """
    point, normal = (row[0] for row in result.nominal.at(*_places(result.nominal, np.array([x]))))
    z, radius = _height(result), RING * size(result)
    angle = np.linspace(0.0, 2 * np.pi, 33)
    ring = point + radius * np.column_stack([np.cos(angle), np.sin(angle)])
    stroke = np.stack([point - 2 * radius * normal, point + 2 * radius * normal])
    return joined([(np.column_stack([row, np.full(len(row), z)]), MARK) for row in (ring, stroke)])


def stretch_points(result: Result, low: float, high: float) -> Floats:
    """Points of the nominal between two places of the axis, (k, 3) in mm, at least two."""
    count = max(2, math.ceil((high - low) / SPACING) + 1)
    return _points(result, np.linspace(low, high, min(count, MOST_PLACES)))


def seen(result: Result, plot: Along, matrix: Sequence[Sequence[float]]) -> tuple[float, float]:
    """The part of the axis whose contour a view shows.

    Parameters
    ----------
    result : Result
    plot : Along
    matrix : 4 x 4 float
        From the frame of the job to the view's, -1 to 1 in all three directions; points are rows, to its left.

    Returns
    -------
    low, high : float
        All of the axis where nothing or everything is seen, and where what is seen runs past the seam.
    """
    x = np.linspace(0.0, plot.total, 1001)
    points = _points(result, x)
    inside = _inside(points, np.asarray(matrix, dtype=np.float64))
    if not inside.any() or inside.all() or (inside[0] and inside[-1] and len(plot.starts) == 1):
        return 0.0, plot.total
    places = x[inside]
    return float(places[0]), float(places[-1])


def _points(result: Result, x: Floats) -> Floats:
    """Points of the nominal at places of the axis, (k, 3) in mm."""
    point, _ = result.nominal.at(*_places(result.nominal, x))
    return np.column_stack([point, np.full(len(x), _height(result))])


def _inside(points: Floats, matrix: Floats) -> Bools:
    clip = np.column_stack([points, np.ones(len(points))]) @ matrix
    out: Bools = (np.abs(clip[:, :2]) <= clip[:, 3:]).all(axis=1) & (clip[:, 3] > 0)
    return out


def place_under(result: Result, matrix: Sequence[Sequence[float]], u: float, v: float) -> float | None:
    """The place of the axis that lies under a point of a view.

    Parameters
    ----------
    result : Result
    matrix : 4 x 4 float
        As in `seen`.
    u, v : float
        Point of the view, -1 to 1.

    Returns
    -------
    float or None
        None where the contour is far from there.
    """
    reach = REACH * size(result)
    forward = np.asarray(matrix, dtype=np.float64)
    if not abs(np.linalg.det(forward)) > 0:
        return None
    ends = np.array([[u, v, -1.0, 1.0], [u, v, 1.0, 1.0]]) @ np.linalg.inv(forward)
    (near, far) = ends[:, :3] / ends[:, 3:]
    drop = far[2] - near[2]
    if abs(drop) < 1e-9:
        return None
    hit = near + (_height(result) - near[2]) / drop * (far - near)
    feet = FootPointSearch(result.nominal, margin=reach).find(hit[None, :2])
    if not abs(feet.distance[0]) <= reach:
        return None
    begin = _starts(result.nominal)[result.nominal.contour[feet.span[0]]]
    return float(begin + result.nominal.arc_length(feet.span, feet.t)[0])


def _places(profile: Profile, x: Floats) -> tuple[Ints, Floats]:
    """Contour and arc length on it of places of the axis."""
    starts = _starts(profile)
    k = np.clip(np.searchsorted(starts, x, side="right") - 1, 0, len(starts) - 2)
    return k, np.clip(x - starts[k], 0.0, profile.total[k])


def size(result: Result) -> float:
    """Larger side of the nominal's bounding box, mm."""
    left, bottom, right, top = result.nominal.bounding_box()
    return max(right - left, top - bottom)


def _height(result: Result) -> float:
    """Z at which the contour is drawn: the mean height of the points, or 0."""
    d = result.deviation
    measurement = result.request.measurement
    return float(d.z.mean()) if len(d) and measurement is not None and measurement.has_z else 0.0
