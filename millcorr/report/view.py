# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of a report seen from above: deviations on the contour, and the path beside it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.geometry.correction import along
from millcorr.geometry.profile import Profile
from millcorr.pipeline import Result
from millcorr.production.contour_check import path_contours, touched_points

from . import reader
from .magnification import magnification_for
from .plots import MOST_MARKERS, MOST_PANELS, WIDTH, Plot, corners, course, groups, levels_of
from .svg import MARKERS, Axis, Canvas, markers, number, polyline, round_step

MOST_WHISKERS = 300
MOST_POINTS = 2000
"""Contact points beyond which the largest of each place are drawn."""


def on_contour(
    profile: Profile,
    deviation: Deviation,
    filtered: Floats,
    *,
    within: float,
    rejected: Floats | None = None,
    magnification: float | None = None,
) -> Plot:
    """Whiskers on the nominal: excess outward, undercut into the material; a panel for every level.

    Parameters
    ----------
    profile : Profile
        Nominal.
    deviation : Deviation
        May be empty.
    filtered : (n,) float64
        mm.
    within : float
        Deviations up to this, in mm, are drawn as near zero.
    rejected : (m, 3) float64, optional
        Points that were not used, mm.
    magnification : float, optional
        Whisker over deviation; by default one that fits.
    """
    largest = float(np.abs(deviation.value).max()) if len(deviation) else 0.0
    times = magnification or magnification_for(profile, largest)
    levels = levels_of(deviation) or [(0, math.nan)]
    shown = levels[:MOST_PANELS]
    left, bottom, right, top = _extent(profile, times * largest)
    scale = min((WIDTH - 68) / (right - left), (620 if len(levels) == 1 else 400) / (top - bottom))
    inner = (top - bottom) * scale
    height = inner + 70
    canvas = Canvas(WIDTH, 30 + len(shown) * height, "Deviations on the contour")
    small = number(round(within * reader.fine_per_mm(), reader.unit().fine_digits + 1))
    near = f"within \N{PLUS-MINUS SIGN}{small} {reader.fine()}"
    entries = [
        ("excess material", [("excess", "m-10 0h10"), ("excess tip", MARKERS[0])]),
        (near, [("within", "m-8 0h16")]),
        ("undercut", [("undercut", "m-10 0h10"), ("undercut tip", MARKERS[2])]),
        ("determined part", [("course", "m-9 0h18")]),
    ]
    if rejected is not None and len(rejected):
        entries.append(("left out", [("rejected", MARKERS[5])]))
    if len(deviation):
        canvas.legend(56, 14, entries)
    outline = _Outline.of(profile)
    spare = 0.5 * (WIDTH - 68 - (right - left) * scale)
    thinned = False
    heights = np.array([z for _, z in levels])
    nearest = np.zeros(0, dtype=np.int64)
    if rejected is not None:
        nearest = np.searchsorted((heights[1:] + heights[:-1]) / 2, rejected[:, 2])
    for i, (level, z) in enumerate(shown):
        y0 = 36 + i * height
        x = Axis(left, right, 56 + spare, 56 + spare + (right - left) * scale)
        y = Axis(bottom, top, y0 + inner, y0)
        _draw_outline(canvas, outline, profile, x, y)
        at = np.flatnonzero(deviation.level == level)
        thinned |= _draw_whiskers(canvas, profile, deviation, at, filtered, times, within, x, y)
        if rejected is not None and len(rejected):
            here = nearest == i
            px, py = x(rejected[here, 0]), y(rejected[here, 1])
            inside = (px > x.start) & (px < x.end) & (py < y.start) & (py > y.end)
            canvas.path(markers(px[inside][:300], py[inside][:300], 5), "rejected")
        _draw_start(canvas, profile, x, y)
        _coordinate_frame(canvas, x, y)
        if len(deviation):
            _scale_bars(canvas, x, y, scale, times, largest)
        if len(levels) > 1:
            canvas.text(x.start + 8, y.end + 14, f"level {level + 1}, Z {reader.length(z)}", "strong")
    words = [f"The nominal contour, seen from above, coordinates in {reader.coarse()}; grey is material."]
    if not outline.material:
        words[0] = f"The nominal contour, seen from above, coordinates in {reader.coarse()}."
    if len(deviation):
        words.append(
            f"Whiskers show the deviations along the normal at {number(times)}:1, outward for excess material and into "
            "the material for undercut."
        )
    words.append("The ring is the start of the arc length, the arrow its direction.")
    if thinned:
        words.append("Of many neighbouring points the one with the largest deviation is drawn.")
    if len(levels) > len(shown):
        words.append(f"{len(shown)} of {len(levels)} levels are drawn; deviations.csv has all.")
    return Plot(str(canvas), " ".join(words))


def path_and_contour(result: Result) -> Plot:
    """The program's path, the theoretical contour, ball centres, and contact points with their errors magnified.

    Parameters
    ----------
    result : Result
        With used points.
    """
    profile, points = result.nominal, touched_points(result)
    largest = float(np.abs(points.error).max())
    times = magnification_for(profile, largest)
    # What is not on the drawing of the contour itself: a ball's radius and the cutter's.
    measurement = result.request.measurement
    ball = 0.0 if measurement is None else measurement.ball_radius
    left, bottom, right, top = _extent(profile, max(times * largest, ball, 1.02 * result.path_radius))
    scale = min((WIDTH - 68) / (right - left), 620 / (top - bottom))
    canvas = Canvas(WIDTH, 100 + (top - bottom) * scale, "Path and contour")
    spare = 0.5 * (WIDTH - 68 - (right - left) * scale)
    x = Axis(left, right, 56 + spare, 56 + spare + (right - left) * scale)
    y = Axis(bottom, top, 36 + (top - bottom) * scale, 36.0)
    _draw_outline(canvas, _Outline.of(profile), profile, x, y)
    way = _Outline.of(path_contours(result))
    canvas.path("".join(polyline(x(p[:, 0]), y(p[:, 1]), closed) for p, closed in way.lines), "way")
    at = _largest_of_each(np.arange(len(points), dtype=np.float64), points.error, MOST_POINTS)
    balls = ball > 0 or (measurement is not None and measurement.axis_radii is not None)
    if balls:
        canvas.path(markers(x(points.measured[at, 0]), y(points.measured[at, 1]), 0), "raw")
    tip = points.foot[at] + times * points.error[at, None] * points.normal[at]
    fx, fy, tx, ty = x(points.foot[at, 0]), y(points.foot[at, 1]), x(tip[:, 0]), y(tip[:, 1])
    for css, chosen, shape in (("excess", points.error[at] > 0, 0), ("undercut", points.error[at] <= 0, 2)):
        lines = zip(fx[chosen], fy[chosen], tx[chosen], ty[chosen], strict=True)
        canvas.path("".join(f"M{a:.1f} {b:.1f}L{c:.1f} {d:.1f}" for a, b, c, d in lines), css)
        canvas.path(markers(tx[chosen], ty[chosen], shape), f"{css} tip")
    canvas.legend(
        56,
        14,
        [
            ("theoretical contour", [("nominal", "m-9 0h18")]),
            ("path of the program", [("way", "m-9 0h18")]),
            *([("ball centre", [("raw", MARKERS[0])])] if balls else []),
            ("contact, excess", [("excess", "m-10 0h10"), ("excess tip", MARKERS[0])]),
            ("contact, undercut", [("undercut", "m-10 0h10"), ("undercut tip", MARKERS[2])]),
        ],
    )
    _draw_start(canvas, profile, x, y)
    _coordinate_frame(canvas, x, y)
    _scale_bars(canvas, x, y, scale, times, largest)
    gives = "the cutter's centre" if result.path_radius else "the contour itself, which the control offsets"
    words = [f"The program's path ({gives}) and the theoretical contour, coordinates in {reader.coarse()}."]
    words.append(
        f"Each contact point stands off the contour by its error at {number(times)}:1"
        + (", the ball's radius taken off along the contour's normal." if balls else ".")
    )
    if len(at) < len(points):
        words.append(f"{len(at)} of {len(points)} points are drawn, the largest of each place; deviations.csv has all.")
    return Plot(str(canvas), " ".join(words))


@dataclass(frozen=True, eq=False, slots=True)
class _Outline:
    """Sampled contours in mm, and on which side material can be shaded: 'in', 'out' or ''."""

    lines: tuple[tuple[Floats, bool], ...]
    material: str

    @staticmethod
    def of(profile: Profile) -> _Outline:
        lines = []
        total = profile.total
        for k, contour in enumerate(profile.contours):
            count = int(np.clip(1600 * total[k] / total.sum(), 48, 1600))
            s = np.linspace(0.0, float(total[k]), count + 1)
            inner = corners(profile, k)
            if len(inner) < 5000:
                s = np.unique(np.concatenate([s, inner]))
            if contour.closed:
                s = s[s < total[k] - 1e-9]
            lines.append((profile.at(k, s)[0], contour.closed))
        area = profile.signed_areas()
        side = ""
        if all(c.closed for c in profile.contours):
            side = "in" if area[np.argmax(np.abs(area))] > 0 else "out"
        return _Outline(tuple(lines), side)


def _extent(profile: Profile, whisker: float) -> tuple[float, float, float, float]:
    left, bottom, right, top = profile.bounding_box()
    size = max(right - left, top - bottom)
    margin = whisker + 0.04 * size
    low = 0.25 * size
    # A straight edge along an axis still gets a drawing of some height.
    extra_x = max(0.0, low - (right - left) - 2 * margin) / 2
    extra_y = max(0.0, low - (top - bottom) - 2 * margin) / 2
    return left - margin - extra_x, bottom - margin - extra_y, right + margin + extra_x, top + margin + extra_y


def _draw_outline(canvas: Canvas, outline: _Outline, profile: Profile, x: Axis, y: Axis) -> None:
    data = [polyline(x(points[:, 0]), y(points[:, 1]), closed) for points, closed in outline.lines]
    if outline.material:
        frame = ""
        if outline.material == "out":
            frame = f"M{x.start:.1f} {y.start:.1f}H{x.end:.1f}V{y.end:.1f}H{x.start:.1f}z"
        canvas.path(frame + "".join(data), "material")
    canvas.path("".join(data), "nominal")


def _draw_whiskers(
    canvas: Canvas,
    profile: Profile,
    deviation: Deviation,
    rows: Ints,
    filtered: Floats,
    times: float,
    within: float,
    x: Axis,
    y: Axis,
) -> bool:
    """Whiskers of one level; True where points were left out."""
    stretches = profile.stretches()
    for k, here in groups(deviation.stretch[rows]):
        at = rows[here]
        at = at[_largest_of_each(along(stretches[k], deviation.s[at], profile), filtered[at], MOST_MARKERS)]
        local = along(stretches[k], deviation.s[at], profile)
        tip = deviation.foot[at] + times * filtered[at, None] * deviation.normal[at]
        index = np.arange(len(at), dtype=np.float64)
        for _, order in course(local, index, stretches[k].length, stretches[k].closed):
            i = order.astype(np.int64)
            canvas.path(polyline(x(tip[i, 0]), y(tip[i, 1])), "course")
    by_contour = groups(deviation.contour[rows])
    whole = float(sum(profile.total[c] for c, _ in by_contour))
    kept = []
    for c, here in by_contour:
        at = rows[here]
        most = max(12, int(MOST_WHISKERS * profile.total[c] / whole))
        kept.append(at[_largest_of_each(deviation.s[at], deviation.value[at], most)])
    if not kept:
        return False
    at = np.concatenate(kept)
    value = deviation.value[at]
    foot = deviation.foot[at]
    tip = foot + times * value[:, None] * deviation.normal[at]
    fx, fy, tx, ty = x(foot[:, 0]), y(foot[:, 1]), x(tip[:, 0]), y(tip[:, 1])
    for css, chosen, shape in (
        ("within", np.abs(value) <= within, None),
        ("excess", value > within, 0),
        ("undercut", value < -within, 2),
    ):
        lines = zip(fx[chosen], fy[chosen], tx[chosen], ty[chosen], strict=True)
        canvas.path("".join(f"M{a:.1f} {b:.1f}L{c:.1f} {d:.1f}" for a, b, c, d in lines), css)
        if shape is not None:
            canvas.path(markers(tx[chosen], ty[chosen], shape), f"{css} tip")
    return len(at) < len(rows)


def _largest_of_each(s: Floats, value: Floats, most: int) -> Ints:
    """Of every `most`-th part of the range the point with the largest absolute value, in order of s."""
    if len(s) <= most:
        return np.argsort(s, kind="stable")
    span = float(np.ptp(s)) or 1.0
    part = np.minimum(((s - s.min()) / span * most).astype(np.int64), most - 1)
    size = np.abs(value)
    largest = np.full(most, -1.0)
    np.fmax.at(largest, part, size)
    at = np.flatnonzero(size == largest[part])
    # Of equal ones the first.
    _, first = np.unique(part[at], return_index=True)
    return at[first]


def _draw_start(canvas: Canvas, profile: Profile, x: Axis, y: Axis) -> None:
    for k in range(min(len(profile.contours), 40)):
        point, normal = profile.at(k, np.array([0.0]))
        px, py = x.at(point[0, 0]), y.at(point[0, 1])
        # Along the contour, set back into the material so that whiskers do not cover it.
        tx, ty = -normal[0, 1], -normal[0, 0]
        nx, ny = normal[0, 0], -normal[0, 1]
        ax, ay = px - 11 * nx, py - 11 * ny
        bx, by = ax + 26 * tx, ay + 26 * ty
        head = "".join(f"M{bx:.1f} {by:.1f}L{bx - 7 * tx + w * nx:.1f} {by - 7 * ty + w * ny:.1f}" for w in (3.5, -3.5))
        canvas.path(f"M{ax:.1f} {ay:.1f}L{bx:.1f} {by:.1f}{head}", "arrow")
        canvas.add(f'<circle class="start" cx="{px:.1f}" cy="{py:.1f}" r="4"/>')
        if len(profile.contours) > 1:
            canvas.text(bx + 10 * tx, by + 10 * ty + 4, str(k + 1), "strong", "middle")


def _coordinate_frame(canvas: Canvas, x: Axis, y: Axis) -> None:
    canvas.line(x.start, y.start, x.end, y.start, "axis")
    canvas.line(x.start, y.start, x.start, y.end, "axis")
    x, y = (axis.scaled(1.0 / reader.unit().mm) for axis in (x, y))
    step = max(round_step((x.high - x.low) / 8), round_step((y.high - y.low) / 8))
    for axis, flat in ((x, True), (y, False)):
        for value in np.arange(math.ceil(axis.low / step), math.floor(axis.high / step) + 1) * step:
            at = axis.at(value)
            text = number(round(float(value), 9))
            if flat:
                canvas.line(at, y.start, at, y.start + 4, "axis")
                canvas.text(at, y.start + 16, text, anchor="middle")
            else:
                canvas.line(x.start - 4, at, x.start, at, "axis")
                canvas.text(x.start - 7, at + 4, text, anchor="end")
    canvas.text(x.end, y.start + 29, f"X / {reader.coarse()}", anchor="end")
    canvas.text(x.start - 7, y.end - 4, f"Y / {reader.coarse()}", anchor="end")


def _scale_bars(canvas: Canvas, x: Axis, y: Axis, scale: float, times: float, largest: float) -> None:
    """Two bars below the drawing: a length on the part and a deviation."""
    at = y.start + 32
    size = round_step(60 / scale / reader.unit().mm)
    deviation = round_step(30 / (scale * times) * reader.fine_per_mm())
    left = x.start + 2
    for wide, text in (
        (size * reader.unit().mm * scale, f"{number(size)} {reader.coarse()} on the part"),
        (
            deviation / reader.fine_per_mm() * times * scale,
            f"{number(deviation)} {reader.fine()} of deviation ({number(times)}:1)",
        ),
    ):
        canvas.path(f"M{left:.1f} {at - 4:.1f}v8m0-4h{wide:.2f}m0-4v8", "axis")
        canvas.text(left + wide + 7, at + 4, text, "legend")
        left += wide + 7 + 6.2 * len(text) + 20
