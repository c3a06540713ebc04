# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three plots of a report as SVG: along the contour, on the contour, and the distribution.

Many points are thinned for drawing only, and the captions say how; no number comes from what is drawn.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .compensation import GAP_SPACINGS, along
from .deviation import Deviation
from .profile import CORNER_ANGLE, Profile
from .svg import MARKERS, Axis, Canvas, bars, columns, markers, number, polyline, round_down, round_step

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

UM = 1000.0
MICRO = "\N{MICRO SIGN}m"

WIDTH = 760.0
MOST_MARKERS = 1200
"""Points of one panel beyond which columns of pixels are drawn instead."""

MOST_WHISKERS = 300
MOST_PANELS = 8
MAGNIFICATION = 500.0

COLOURS = {
    "light": {
        "ink": "#1b2530",
        "soft": "#5b6875",
        "faint": "#dde3e9",
        "paper": "#ffffff",
        "material": "#eef2f6",
        "raw": "#7c8a98",
        "predicted": "#7d4cb8",
        "excess": "#0065a8",
        "within": "#0a8a63",
        "undercut": "#c8480a",
    },
    "dark": {
        "ink": "#e4eaf0",
        "soft": "#9aa8b6",
        "faint": "#303a45",
        "paper": "#161c22",
        "material": "#212a33",
        "raw": "#8795a3",
        "predicted": "#b893ec",
        "excess": "#5ab4f2",
        "within": "#3ecb9b",
        "undercut": "#ff8a4f",
    },
}
"""Colours by role; excess, within and undercut stay apart for colour-blind eyes."""

STYLE = """
.plot text{font-family:inherit;font-size:11px;fill:var(--soft)}
.plot .legend,.plot .strong{fill:var(--ink)}
.plot .strong{font-weight:600}
.plot path{fill:none}
.plot .axis{stroke:var(--soft);stroke-width:1}
.plot .grid{stroke:var(--faint);stroke-width:1}
.plot .zero{stroke:var(--soft);stroke-width:1}
.plot .corner{stroke:var(--soft);stroke-width:1;stroke-dasharray:2 3}
.plot .raw{stroke:var(--raw);stroke-width:1}
.plot .predicted{stroke:var(--predicted);stroke-width:1}
.plot .raw-columns{stroke:var(--raw);stroke-width:1;opacity:.55}
.plot .predicted-columns{stroke:var(--predicted);stroke-width:1;opacity:.5}
.plot .filtered{stroke:var(--ink);stroke-width:1.8;stroke-linejoin:round}
.plot .filtered.dash1{stroke-dasharray:7 3}
.plot .filtered.dash2{stroke-dasharray:2 2}
.plot .filtered.dash3{stroke-dasharray:9 3 2 3}
.plot .material{fill:var(--material);fill-rule:evenodd}
.plot .nominal{stroke:var(--ink);stroke-width:1.2;stroke-linejoin:round}
.plot .course{stroke:var(--soft);stroke-width:1;stroke-linejoin:round}
.plot .excess{stroke:var(--excess);stroke-width:1.1}
.plot .within{stroke:var(--within);stroke-width:1.1}
.plot .undercut{stroke:var(--undercut);stroke-width:1.1}
.plot .excess.tip{fill:var(--excess)}
.plot .undercut.tip{fill:var(--paper)}
.plot .rejected{stroke:var(--soft);stroke-width:1.2}
.plot .start{stroke:var(--ink);stroke-width:1.6;fill:var(--paper)}
.plot .arrow{stroke:var(--ink);stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}
.plot .raw-fill{stroke:var(--raw);fill:var(--raw);fill-opacity:.35}
.plot .predicted-fill{stroke:var(--predicted);fill:var(--predicted);fill-opacity:.4}
.plot .spread{stroke:var(--ink);stroke-width:1.4}
.plot .bell{stroke:var(--ink);stroke-width:1.2;stroke-dasharray:4 3}
"""


@dataclass(frozen=True, slots=True)
class Plot:
    """A drawing and the words under it.

    Parameters
    ----------
    svg : str
        The drawing; its looks come from `STYLE`, which needs `COLOURS` as CSS variables. See `standalone`.
    caption : str
    """

    svg: str
    caption: str


def standalone(plot: Plot, theme: str = "light") -> str:
    """The drawing as an SVG file of its own, with the colours of a theme written in."""
    colours = COLOURS[theme]
    style = re.sub(r"var\(--([a-z]+)\)", lambda match: colours[match[1]], STYLE)
    style = style.replace(".plot ", "").replace("inherit", "sans-serif")
    return plot.svg.replace("<title>", f"<style>{style}</style><title>", 1)


def along_contour(profile: Profile, deviation: Deviation, filtered: Floats, predicted: Floats) -> Plot:
    """Deviations over arc length: points, determined part, prediction; a panel for every contour.

    Parameters
    ----------
    profile : Profile
        Nominal.
    deviation : Deviation
        At least one point.
    filtered, predicted : (n,) float64
        mm.
    """
    contours = np.unique(deviation.contour)
    shown = contours
    if len(contours) > MOST_PANELS:
        worst = [np.abs(deviation.value[deviation.contour == k]).max() for k in contours]
        shown = np.sort(contours[np.argsort(worst)[-MOST_PANELS:]])
    levels = _levels(deviation)
    height = 250.0 if len(shown) == 1 else 175.0
    top = 30 if len(levels) == 1 else 48
    canvas = Canvas(WIDTH, top - 6 + len(shown) * (height + 44), "Deviation along the contour")
    dense = max(int((deviation.contour == k).sum()) for k in shown) > MOST_MARKERS
    _along_legend(canvas, levels, dense)
    for i, k in enumerate(shown):
        rows = np.flatnonzero(deviation.contour == k)
        title = f"contour {int(k) + 1}" if len(profile.contours) > 1 else ""
        panel = _Panel(canvas, top + i * (height + 44), height, title, f"along{int(k)}")
        panel.draw(profile, int(k), deviation, rows, filtered, predicted, levels)
    words = [
        f"Deviation in {MICRO} over the arc length of the nominal, from its start; above zero material is left, "
        "below too much is gone."
    ]
    if dense:
        words.append("Where points are dense, each column of pixels shows the range from the smallest to the largest.")
    if len(shown) < len(contours):
        words.append(
            f"Of {len(contours)} measured contours the {len(shown)} with the largest deviations are drawn; "
            "deviations.csv has all."
        )
    if any(len(corners(profile, int(k))) for k in shown):
        words.append("Dotted uprights mark corners: no filter reaches across them.")
    return Plot(str(canvas), " ".join(words))


def corners(profile: Profile, contour: int) -> Floats:
    """Arc lengths in mm of a contour's corners, from its start."""
    spans = np.flatnonzero((profile.contour == contour) & (np.abs(np.nan_to_num(profile.turn)) > CORNER_ANGLE))
    total = float(profile.total[contour])
    at = profile.begin[spans] + profile.length[spans]
    return np.sort(np.where(at > total - 1e-9, 0.0, at)) if profile.contours[contour].closed else np.sort(at)


def _levels(deviation: Deviation) -> list[tuple[int, float]]:
    """Number and mean height of every level."""
    return [(int(k), float(deviation.z[deviation.level == k].mean())) for k in np.unique(deviation.level)]


def _along_legend(canvas: Canvas, levels: list[tuple[int, float]], dense: bool) -> None:
    mark = "m-4-4v8m2-10v9m2-6v8m2-9v9m2-8v8" if dense else MARKERS[0]
    suffix = "-columns" if dense else ""
    entries = [
        ("before, range of the points" if dense else "before, each point", [(f"raw{suffix}", mark)]),
        ("determined part (filtered)", [("filtered", "m-9 0h18")]),
        ("predicted after the correction", [(f"predicted{suffix}", mark)]),
    ]
    canvas.legend(56, 14, entries)
    if len(levels) > 1:
        # More do not fit; the table by level has them.
        entries = [
            (f"Z {number(round(z, 3))}", [(f"filtered dash{i % 4}", "m-12 0h24"), *_level_mark(i, dense)])
            for i, (_, z) in enumerate(levels[:8])
        ]
        canvas.legend(56, 32, entries)


def _level_mark(level: int, dense: bool) -> list[tuple[str, str]]:
    return [] if dense else [("raw", MARKERS[level % len(MARKERS)])]


@dataclass(slots=True)
class _Panel:
    """One contour's plot over arc length."""

    canvas: Canvas
    top: float
    height: float
    title: str
    name: str

    def draw(
        self,
        profile: Profile,
        contour: int,
        deviation: Deviation,
        rows: Ints,
        filtered: Floats,
        predicted: Floats,
        levels: list[tuple[int, float]],
    ) -> None:
        canvas, bottom = self.canvas, self.top + self.height
        total = float(profile.total[contour])
        x = Axis(0.0, total, 56.0, WIDTH - 12.0)
        values = np.concatenate([deviation.value[rows], predicted[rows], filtered[rows]]) * UM
        y = _value_axis(values, bottom, self.top)
        _frame(canvas, x, y, "s / mm", f"deviation / {MICRO}")
        if self.title:
            canvas.text(x.end, self.top - 5, self.title, "strong", "end")
        canvas.clip(self.name, x.start, self.top, x.end - x.start, self.height)
        for s in corners(profile, contour):
            canvas.line(x.at(s), self.top, x.at(s), bottom, "corner")
        dense = len(rows) > MOST_MARKERS
        for i, (level, _) in enumerate(levels):
            at = rows[deviation.level[rows] == level]
            if not len(at):
                continue
            px = x(deviation.s[at])
            for value, css in ((deviation.value, "raw"), (predicted, "predicted")):
                py = y(value[at] * UM)
                if dense:
                    middle, [(low, _, high)] = columns(px, [py])
                    canvas.path(bars(middle, low, high), f"{css}-columns")
                else:
                    canvas.path(markers(px, py, i), css)
        stretches = profile.stretches()
        for i, (level, _) in enumerate(levels):
            for k in np.unique(deviation.stretch[rows]):
                at = rows[(deviation.level[rows] == level) & (deviation.stretch[rows] == k)]
                local = along(stretches[int(k)], deviation.s[at], profile)
                line = _course(local, filtered[at], stretches[int(k)].length, stretches[int(k)].closed)
                begin = stretches[int(k)].begin
                data = "".join(self._wrapped(x, y, begin + s, value, total) for s, value in line)
                canvas.path(data, f"filtered dash{i % 4}", self.name)

    @staticmethod
    def _wrapped(x: Axis, y: Axis, s: Floats, value: Floats, total: float) -> str:
        """The line, and once more a turn earlier where it runs past the contour's seam."""
        px, py = x(s), y(value * UM)
        if len(s) > 2 * MOST_MARKERS:
            px, [(_, py, _)] = columns(px, [py])
        out = polyline(px, py)
        turn = x.end - x.start
        for shift, needed in ((-turn, s.max() > total), (turn, s.min() < 0)):
            if needed:
                out += polyline(px + shift, py)
        return out


def _course(s: Floats, value: Floats, length: float, closed: bool) -> list[tuple[Floats, Floats]]:
    """Values sorted by arc length, cut where a gap is long; a closed course goes on past its seam by a point."""
    if not len(s):
        return []
    order = np.argsort(s, kind="stable")
    s, value = s[order], value[order]
    if closed:
        s = np.concatenate([[s[-1] - length], s, [s[0] + length]])
        value = np.concatenate([[value[-1]], value, [value[0]]])
    step = np.diff(s)
    apart = step[step > 0]
    typical = float(np.median(apart)) if len(apart) else math.inf
    cuts = np.flatnonzero(step > GAP_SPACINGS * typical) + 1
    return list(zip(np.split(s, cuts), np.split(value, cuts), strict=True))


def _value_axis(values: Floats, bottom: float, top: float) -> Axis:
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    room = max(high - low, 0.2)
    return Axis(low - 0.08 * room, high + 0.08 * room, bottom, top)


def _frame(canvas: Canvas, x: Axis, y: Axis, below: str, beside: str) -> None:
    """Grid, ticks and names of a plot whose zero is marked."""
    for value in y.ticks(6):
        at = y.at(value)
        canvas.line(x.start, at, x.end, at, "zero" if value == 0 else "grid")
        canvas.text(x.start - 6, at + 4, number(value), anchor="end")
    for value in x.ticks(10):
        at = x.at(value)
        canvas.line(at, y.start, at, y.start + 4, "axis")
        canvas.text(at, y.start + 16, number(value), anchor="middle")
    canvas.line(x.start, y.start, x.end, y.start, "axis")
    canvas.text((x.start + x.end) / 2, y.start + 30, below, anchor="middle")
    canvas.text(13, (y.start + y.end) / 2, beside, anchor="middle", turn=-90)


def magnification_for(profile: Profile, largest: float) -> float:
    """Magnification 1, 2 or 5 times a power of ten at which the largest deviation is seen and fits.

    500 where its whisker is between 3 and 12 % of the part's size, else the largest that keeps to 12 %.

    Parameters
    ----------
    profile : Profile
    largest : float
        mm.
    """
    left, bottom, right, top = profile.bounding_box()
    size = max(right - left, top - bottom)
    if not largest > 0:
        return MAGNIFICATION
    most, least = 0.12 * size / largest, 0.03 * size / largest
    if least <= MAGNIFICATION <= most:
        return MAGNIFICATION
    return round_down(most)


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
    levels = _levels(deviation) or [(0, math.nan)]
    shown = levels[:MOST_PANELS]
    left, bottom, right, top = _extent(profile, times * largest)
    scale = min((WIDTH - 68) / (right - left), (620 if len(levels) == 1 else 400) / (top - bottom))
    inner = (top - bottom) * scale
    height = inner + 70
    canvas = Canvas(WIDTH, 30 + len(shown) * height, "Deviations on the contour")
    near = f"within \N{PLUS-MINUS SIGN}{number(round(within * UM, 2))} {MICRO}"
    entries = [
        ("excess material", [("excess", "m-10 0h10"), ("excess tip", MARKERS[0])]),
        (near, [("within", "m-8 0h16")]),
        ("undercut", [("undercut", "m-10 0h10"), ("undercut tip", MARKERS[2])]),
        ("determined part", [("course", "m-9 0h18")]),
    ]
    if rejected is not None and len(rejected):
        entries.append(("rejected", [("rejected", MARKERS[5])]))
    if len(deviation):
        canvas.legend(56, 14, entries)
    outline = _Outline.of(profile)
    spare = 0.5 * (WIDTH - 68 - (right - left) * scale)
    thinned = False
    for i, (level, z) in enumerate(shown):
        y0 = 36 + i * height
        x = Axis(left, right, 56 + spare, 56 + spare + (right - left) * scale)
        y = Axis(bottom, top, y0 + inner, y0)
        _draw_outline(canvas, outline, profile, x, y)
        at = np.flatnonzero(deviation.level == level)
        thinned |= _draw_whiskers(canvas, profile, deviation, at, filtered, times, within, x, y)
        if rejected is not None and len(rejected):
            here = np.argmin(np.abs(rejected[:, 2:] - [[height for _, height in levels]]), axis=1) == i
            px, py = x(rejected[here, 0]), y(rejected[here, 1])
            inside = (px > x.start) & (px < x.end) & (py < y.start) & (py > y.end)
            canvas.path(markers(px[inside][:300], py[inside][:300], 5), "rejected")
        _draw_start(canvas, profile, x, y)
        _coordinate_frame(canvas, x, y)
        if len(deviation):
            _scale_bars(canvas, x, y, scale, times, largest)
        if len(levels) > 1:
            canvas.text(x.start + 8, y.end + 14, f"level {level + 1}, Z {number(round(z, 3))} mm", "strong")
    words = ["The nominal contour, seen from above, coordinates in mm; grey is material."]
    if not outline.material:
        words[0] = "The nominal contour, seen from above, coordinates in mm."
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
    for k in np.unique(deviation.stretch[rows]):
        at = rows[deviation.stretch[rows] == k]
        at = at[_largest_of_each(along(stretches[int(k)], deviation.s[at], profile), filtered[at], MOST_MARKERS)]
        local = along(stretches[int(k)], deviation.s[at], profile)
        tip = deviation.foot[at] + times * filtered[at, None] * deviation.normal[at]
        index = np.arange(len(at), dtype=np.float64)
        for _, chosen in _course(local, index, stretches[int(k)].length, stretches[int(k)].closed):
            i = chosen.astype(np.int64)
            canvas.path(polyline(x(tip[i, 0]), y(tip[i, 1])), "course")
    whole = float(profile.total[np.unique(deviation.contour[rows])].sum()) if len(rows) else 0.0
    kept = []
    for c in np.unique(deviation.contour[rows]):
        at = rows[deviation.contour[rows] == c]
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
    order = np.lexsort((np.arange(len(s)), -np.abs(value), part))
    first = np.flatnonzero(np.diff(part[order], prepend=-1))
    return np.asarray(order[first], dtype=np.int64)


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
    canvas.text(x.end, y.start + 29, "X / mm", anchor="end")
    canvas.text(x.start - 7, y.end - 4, "Y / mm", anchor="end")


def _scale_bars(canvas: Canvas, x: Axis, y: Axis, scale: float, times: float, largest: float) -> None:
    """Two bars below the drawing: a length on the part and a deviation."""
    at = y.start + 32
    length = round_step(60 / scale)
    deviation = round_step(30 / (scale * times) * UM)
    left = x.start + 2
    for wide, text in (
        (length * scale, f"{number(length)} mm on the part"),
        (
            deviation / UM * times * scale,
            f"{number(deviation)} {MICRO} of deviation ({number(times)}:1)",
        ),
    ):
        canvas.path(f"M{left:.1f} {at - 4:.1f}v8m0-4h{wide:.2f}m0-4v8", "axis")
        canvas.text(left + wide + 7, at + 4, text, "legend")
        left += wide + 7 + 6.2 * len(text) + 20


def histogram(before: Floats, predicted: Floats, random_std: float) -> Plot:
    """Distribution of the deviations before, and predicted after the correction.

    Parameters
    ----------
    before, predicted : (n,) float64
        mm; at least one point.
    random_std : float
        mm; NaN where it is not known.
    """
    a, b = before * UM, predicted * UM
    low, high = float(min(a.min(), b.min(), 0.0)), float(max(a.max(), b.max(), 0.0))
    width = _bin_width(a, b, high - low)
    first, last = math.floor(low / width), max(math.floor(high / width) + 1, math.floor(low / width) + 1)
    edges = np.arange(first, last + 1) * width
    counts = [np.histogram(v, edges)[0] for v in (a, b)]
    canvas = Canvas(WIDTH, 262, "Distribution of the deviations")
    canvas.legend(
        56,
        14,
        [
            ("before", [("raw-fill", "m-8-4h16v8h-16z")]),
            ("predicted after the correction", [("predicted-fill", "m-8-4h16v8h-16z")]),
            ("mean \N{PLUS-MINUS SIGN} standard deviation", [("spread", "m-9-4v8m0-4h18m0-4v8")]),
            *([("normal law of the random part", [("bell", "m-9 0h18")])] if random_std > 0 else []),
        ],
    )
    top, bottom = 48.0, 226.0
    x = Axis(float(edges[0]) - width, float(edges[-1]) + width, 56, WIDTH - 12)
    tallest = float(max(c.max() for c in counts))
    if random_std > 0:
        tallest = max(tallest, len(b) * width / (random_std * UM * math.sqrt(2 * math.pi)))
    y = Axis(0.0, 1.05 * tallest, bottom, top)
    for value in y.ticks(5):
        if value == int(value):
            canvas.line(x.start, y.at(value), x.end, y.at(value), "grid")
            canvas.text(x.start - 6, y.at(value) + 4, number(value), anchor="end")
    for count, css in zip(counts, ("raw-fill", "predicted-fill"), strict=True):
        canvas.path(_steps(x(edges), y(count.astype(np.float64)), bottom), css)
    for value in x.ticks(12):
        canvas.line(x.at(value), bottom, x.at(value), bottom + 4, "axis")
        canvas.text(x.at(value), bottom + 16, number(value), anchor="middle")
    canvas.line(x.start, bottom, x.end, bottom, "axis")
    if x.low < 0 < x.high:
        canvas.line(x.at(0), top - 8, x.at(0), bottom, "zero")
    for v, level, css in ((a, 30.0, "raw"), (b, 40.0, "predicted")):
        mean, std = float(v.mean()), float(v.std(ddof=1)) if len(v) > 1 else 0.0
        canvas.line(x.at(mean - std), level, x.at(mean + std), level, "spread")
        canvas.path(f"M{x.at(mean):.1f} {level:.1f}{MARKERS[3]}", css)
        for end in (mean - std, mean + std):
            canvas.line(x.at(end), level - 3, x.at(end), level + 3, "spread")
    if math.isfinite(random_std) and random_std > 0:
        sigma, mean = random_std * UM, float(b.mean())
        at = np.linspace(max(x.low, mean - 4 * sigma), min(x.high, mean + 4 * sigma), 161)
        bell = len(b) * width / (sigma * math.sqrt(2 * math.pi)) * np.exp(-0.5 * ((at - mean) / sigma) ** 2)
        canvas.path(polyline(x(at), y(bell)), "bell")
    canvas.text((x.start + x.end) / 2, bottom + 32, f"deviation / {MICRO}", anchor="middle")
    canvas.text(13, (top + bottom) / 2, "points", anchor="middle", turn=-90)
    words = f"Classes of {number(width)} {MICRO}; bars above: mean \N{PLUS-MINUS SIGN} standard deviation."
    if math.isfinite(random_std):
        words += (
            f" The random part has a standard deviation of {random_std * UM:.2f} {MICRO}: no correction can make the "
            "spread smaller than what of it comes from the process."
        )
    return Plot(str(canvas), words)


def _bin_width(a: Floats, b: Floats, span: float) -> float:
    """Round class width after Freedman and Diaconis, with 14 to 60 classes."""
    wide = []
    for v in (a, b):
        quarter = float(np.subtract(*np.percentile(v, [75, 25])))
        if quarter > 1e-9:
            wide.append(2 * quarter / len(v) ** (1 / 3))
    width = min(wide, default=span / 20)
    return round_step(float(np.clip(width / 2, max(span / 60, 1e-3), max(span / 30, 1e-3))))


def _steps(edges: Floats, tops: Floats, base: float) -> str:
    x = np.repeat(edges, 2)
    y = np.concatenate([[base], np.repeat(tops, 2), [base]])
    filled = np.flatnonzero(tops < base)
    if not len(filled):
        return ""
    low, high = 2 * int(filled[0]), 2 * int(filled[-1]) + 4
    return polyline(x[low:high], y[low:high], True)
