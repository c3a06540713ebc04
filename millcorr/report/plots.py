# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots of a report as SVG: looks, deviations along the contour, and their distribution.

Many points are thinned for drawing only, and the captions say how; no number comes from what is drawn.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.correction.compensation import GAP_SPACINGS
from millcorr.geometry.correction import along
from millcorr.geometry.profile import CORNER_ANGLE, Profile, Stretch

from . import reader
from .posterior import Posterior, runs
from .svg import MARKERS, Axis, Canvas, bars, columns, markers, number, polyline, round_step

UM = 1000.0
MICRO = "\N{MICRO SIGN}m"

WIDTH = 760.0
MOST_MARKERS = 1200
"""Points of one panel beyond which columns of pixels are drawn instead."""

MOST_PANELS = 8

COVERAGE = 2.0
"""Coverage factor k of the drawn band: about 95 %."""

_CROSS = "m-3.5-3.5l7 7m-7 0l7-7"

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
.plot .band{fill:var(--ink);fill-opacity:.16}
.plot .whole{fill:var(--ink);fill-opacity:.08}
.plot .outlier{stroke:var(--undercut);stroke-width:1.6}
.plot .bare{stroke:var(--undercut);stroke-width:1.8;stroke-dasharray:2 3}
.plot .raw-columns{stroke:var(--raw);stroke-width:1;opacity:.55}
.plot .predicted-columns{stroke:var(--predicted);stroke-width:1;opacity:.5}
.plot .filtered{stroke:var(--ink);stroke-width:1.8;stroke-linejoin:round}
.plot .filtered.dash1{stroke-dasharray:7 3}
.plot .filtered.dash2{stroke-dasharray:2 2}
.plot .filtered.dash3{stroke-dasharray:9 3 2 3}
.plot .material{fill:var(--material);fill-rule:evenodd}
.plot .nominal{stroke:var(--ink);stroke-width:1.2;stroke-linejoin:round}
.plot .way{stroke:var(--predicted);stroke-width:1.2;stroke-dasharray:6 3;stroke-linejoin:round}
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


def along_contour(
    profile: Profile,
    deviation: Deviation,
    filtered: Floats,
    predicted: Floats,
    uncertainty: Floats | None = None,
    posterior: Sequence[Posterior] = (),
    outlier: Bools | None = None,
) -> Plot:
    """Deviations over arc length: points, determined part with its uncertainty, prediction; a panel for every contour.

    Parameters
    ----------
    profile : Profile
        Nominal.
    deviation : Deviation
        At least one point.
    filtered, predicted : (n,) float64
        mm.
    uncertainty : (n,) float64, optional
        Standard uncertainty of the determined part in mm; a band of twice as much on either side is drawn where it
        is a number.
    posterior : sequence of Posterior
        The determined part between the points, in gaps and on sides without a point, too, in place of lines through
        the points.
    outlier : (n,) bool, optional
        Points to mark; they do not set the scale.
    """
    wrong = np.zeros(len(deviation), dtype=bool) if outlier is None else outlier
    half = np.full(len(deviation), np.nan) if uncertainty is None else COVERAGE * uncertainty
    contours = groups(deviation.contour)
    shown = contours
    if len(contours) > MOST_PANELS:
        worst = [float(np.abs(deviation.value[rows]).max()) for _, rows in contours]
        shown = [contours[i] for i in sorted(np.argsort(worst)[-MOST_PANELS:].tolist())]
    levels = levels_of(deviation)
    height = 250.0 if len(shown) == 1 else 175.0
    second = len(levels) > 1 or bool(wrong.any()) or any(row.bare.any() for row in posterior)
    top = 48 if second else 30
    canvas = Canvas(WIDTH, top - 6 + len(shown) * (height + 44), "Deviation along the contour")
    dense = max(len(rows) for _, rows in shown) > MOST_MARKERS
    banded = bool(np.isfinite(half).any())
    _along_legend(canvas, levels, dense, banded, posterior, bool(wrong.any()))
    for i, (k, rows) in enumerate(shown):
        title = f"contour {k + 1}" if len(profile.contours) > 1 else ""
        panel = _Panel(canvas, top + i * (height + 44), height, title, f"along{k}")
        panel.draw(profile, k, deviation, rows, filtered, half, predicted, levels, wrong, posterior)
    words = [
        f"Deviation in {reader.fine()} over the arc length of the nominal, from its start; above zero material is "
        "left, below too much is gone."
    ]
    if banded:
        words.append(
            f"Band: the determined part with its expanded uncertainty (k = {COVERAGE:g}, about 95 %), "
            f"up to \N{PLUS-MINUS SIGN}{reader.shown(np.nanmax(half), '.2f')}"
            f"{' at the points' if posterior else ''}."
        )
    if posterior:
        words.append("The lighter band holds along the whole contour together, with 95 %.")
    bare = [row for row in posterior if row.bare.any()]
    if bare:
        widest = max(float(COVERAGE * row.std[row.bare].max()) for row in bare)
        words.append(
            "Where the line is dashed the correction rests on no points: it goes on as the form does, then back to "
            f"the mean, known to \N{PLUS-MINUS SIGN}{reader.shown(widest, '.1f')} (k = {COVERAGE:g}) at the worst."
        )
    if wrong.any():
        words.append("Crosses are outliers, left out; at the edge of the plot they lie beyond it.")
    if dense:
        words.append("Where points are dense, each column of pixels shows the range from the smallest to the largest.")
    if len(shown) < len(contours):
        words.append(
            f"Of {len(contours)} measured contours the {len(shown)} with the largest deviations are drawn; "
            "deviations.csv has all."
        )
    if any(len(corners(profile, k)) for k, _ in shown):
        words.append("Dotted uprights mark corners: no filter reaches across them.")
    return Plot(str(canvas), " ".join(words))


def corners(profile: Profile, contour: int) -> Floats:
    """Arc lengths in mm of a contour's corners, from its start."""
    spans = np.flatnonzero((profile.contour == contour) & (np.abs(np.nan_to_num(profile.turn)) > CORNER_ANGLE))
    total = float(profile.total[contour])
    at = profile.begin[spans] + profile.length[spans]
    return np.sort(np.where(at > total - 1e-9, 0.0, at)) if profile.contours[contour].closed else np.sort(at)


def levels_of(deviation: Deviation) -> list[tuple[int, float]]:
    """Number and mean height of every level."""
    return [(level, float(deviation.z[rows].mean())) for level, rows in groups(deviation.level)]


def groups(key: Ints) -> list[tuple[int, Ints]]:
    """Values of a key in order, and the rows of each in theirs, (k,)."""
    order = np.argsort(key, kind="stable")
    parts = np.split(order, np.flatnonzero(np.diff(key[order])) + 1)
    return [(int(key[rows[0]]), rows) for rows in parts if len(rows)]


def _along_legend(
    canvas: Canvas,
    levels: list[tuple[int, float]],
    dense: bool,
    banded: bool,
    posterior: Sequence[Posterior],
    wrong: bool,
) -> None:
    mark = "m-4-4v8m2-10v9m2-6v8m2-9v9m2-8v8" if dense else MARKERS[0]
    suffix = "-columns" if dense else ""
    entries = [
        ("before, range of the points" if dense else "before, each point", [(f"raw{suffix}", mark)]),
        ("determined part (filtered)", [("filtered", "m-9 0h18")]),
        ("predicted after the correction", [(f"predicted{suffix}", mark)]),
    ]
    if banded:
        entries.insert(2, (f"its uncertainty, k = {COVERAGE:g}", [("band", "m-9-4h18v8h-18z")]))
    canvas.legend(56, 14, entries)
    entries = []
    if any(row.bare.any() for row in posterior):
        entries.append(("no points near", [("bare", "m-9 0h18")]))
    if wrong:
        entries.append(("outlier", [("outlier", _CROSS)]))
    if len(levels) > 1:
        # More do not fit; the table by level has them.
        entries += [
            (
                f"Z {number(round(z / reader.unit().mm, reader.unit().digits - 1))}",
                [*([] if posterior else [(f"filtered dash{i % 4}", "m-12 0h24")]), *_level_mark(i, dense)],
            )
            for i, (_, z) in enumerate(levels[: 8 - 2 * len(entries)])
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
        half: Floats,
        predicted: Floats,
        levels: list[tuple[int, float]],
        wrong: Bools,
        posterior: Sequence[Posterior],
    ) -> None:
        stretches = profile.stretches()
        posterior = [row for row in posterior if stretches[row.stretch].contour == contour]
        canvas, bottom = self.canvas, self.top + self.height
        total = float(profile.total[contour])
        x = Axis(0.0, total, 56.0, WIDTH - 12.0)
        edge = np.nan_to_num(half[rows])
        sound = rows[~wrong[rows]]
        values = np.concatenate(
            [deviation.value[sound], predicted[sound], filtered[rows] - edge, filtered[rows] + edge]
            + [row.value + sign * COVERAGE * row.std for row in posterior for sign in (-1.0, 1.0)]
        )
        y = value_axis(values * reader.fine_per_mm(), bottom, self.top)
        frame(canvas, x.scaled(1.0 / reader.unit().mm), y, f"s / {reader.coarse()}", f"deviation / {reader.fine()}")
        if self.title:
            canvas.text(x.end, self.top - 5, self.title, "strong", "end")
        canvas.clip(self.name, x.start, self.top, x.end - x.start, self.height)
        for s in corners(profile, contour):
            canvas.line(x.at(s), self.top, x.at(s), bottom, "corner")
        dense = len(rows) > MOST_MARKERS
        if posterior:
            self._posterior(x, y, profile, posterior, total)
        else:
            self._bands(x, y, profile, deviation, rows, filtered, half, total)
        far = rows[wrong[rows]]
        rows = sound
        index = {level: i for i, (level, _) in enumerate(levels)}
        # Columns of pixels look alike at all levels.
        for level, here in [(levels[0][0], np.arange(len(rows)))] if dense else groups(deviation.level[rows]):
            i, at = index[level], rows[here]
            px, py = x(deviation.s[at]), [y(value[at] * reader.fine_per_mm()) for value in (deviation.value, predicted)]
            if dense:
                middle, ranges = columns(px, py)
                for (low, _, high), css in zip(ranges, ("raw", "predicted"), strict=True):
                    canvas.path(bars(middle, low, high), f"{css}-columns")
            else:
                for value, css in zip(py, ("raw", "predicted"), strict=True):
                    canvas.path(markers(px, value, i), css)
        # Outliers beyond the axis stand at its edge.
        height = np.clip(y(deviation.value[far] * reader.fine_per_mm()), self.top + 3.0, bottom - 3.0)
        canvas.path(
            "".join(f"M{a:.1f} {b:.1f}{_CROSS}" for a, b in zip(x(deviation.s[far]), height, strict=True)), "outlier"
        )
        if posterior:
            return
        pixel = total / (x.end - x.start)
        for key, here in groups(deviation.level[rows] * len(stretches) + deviation.stretch[rows]):
            level, k = divmod(key, len(stretches))
            at, stretch = rows[here], stretches[k]
            local = along(stretch, deviation.s[at], profile)
            line = by_pixel(local, [filtered[at]], stretch, pixel)
            data = "".join(self._wrapped(x, y, stretch.begin + s, value, total) for s, value in line)
            canvas.path(data, f"filtered dash{index[level] % 4}", self.name)

    def _posterior(self, x: Axis, y: Axis, profile: Profile, posterior: Sequence[Posterior], total: float) -> None:
        """Both bands and the determined part of every stretch, dashed where no point is near."""
        stretches = profile.stretches()
        turn = x.end - x.start
        for row in posterior:
            px = x(stretches[row.stretch].begin + row.s)
            for factor, css in ((row.band, "whole"), (COVERAGE, "band")):
                low, high = (y((row.value + sign * factor * row.std) * reader.fine_per_mm()) for sign in (-1.0, 1.0))
                data = "".join(
                    polyline(np.append(px, px[::-1]) + shift, np.append(low, high[::-1]), True)
                    for shift in (0.0, -turn, turn)
                    if (px + shift).max() > x.start and (px + shift).min() < x.end
                )
                self.canvas.path(data, css, self.name)
        for row in posterior:
            for bare, here in runs(row.bare):
                s = stretches[row.stretch].begin + row.s[here]
                data = self._wrapped(x, y, s, row.value[here], total)
                self.canvas.path(data, "bare" if bare else "filtered dash0", self.name)

    def _bands(
        self,
        x: Axis,
        y: Axis,
        profile: Profile,
        deviation: Deviation,
        rows: Ints,
        filtered: Floats,
        half: Floats,
        total: float,
    ) -> None:
        """Determined part less and plus half the band's width, for every stretch and level."""
        stretches = profile.stretches()
        rows = rows[np.isfinite(half[rows])]
        levels = int(deviation.level.max()) + 1
        pixel = total / (x.end - x.start)
        for one, here in groups(deviation.stretch[rows] * levels + deviation.level[rows]):
            at, stretch = rows[here], stretches[one // levels]
            local = along(stretch, deviation.s[at], profile)
            data = ""
            for s, low, high in by_pixel(local, [filtered[at] - half[at], filtered[at] + half[at]], stretch, pixel):
                px, py, qy = x(stretch.begin + s), y(low * reader.fine_per_mm()), y(high * reader.fine_per_mm())
                for shift in (0.0, x.start - x.end, x.end - x.start):
                    if (px + shift).max() > x.start and (px + shift).min() < x.end:
                        data += polyline(np.append(px, px[::-1]) + shift, np.append(py, qy[::-1]), True)
            self.canvas.path(data, "band", self.name)

    @staticmethod
    def _wrapped(x: Axis, y: Axis, s: Floats, value: Floats, total: float) -> str:
        """The line, and once more a turn earlier where it runs past the contour's seam."""
        px, py = x(s), y(value * reader.fine_per_mm())
        out = polyline(px, py)
        turn = x.end - x.start
        for shift, needed in ((-turn, s.max() > total), (turn, s.min() < 0)):
            if needed:
                out += polyline(px + shift, py)
        return out


def by_pixel(s: Floats, values: Sequence[Floats], stretch: Stretch, pixel: float) -> list[tuple[Floats, ...]]:
    """Courses of values along a stretch, each as places and values; of many points the means of every pixel (mm)."""
    gap, many = None, len(s)
    if many > 2 * MOST_MARKERS:
        column = np.floor(s / pixel).astype(np.int64)
        column -= column.min()
        count = np.bincount(column)
        shown = count > 0
        s, *values = (np.bincount(column, value)[shown] / count[shown] for value in (s, *values))
        gap = max(GAP_SPACINGS * stretch.length / many, 2.0 * pixel)
    index = np.arange(len(s), dtype=np.float64)
    found = course(s, index, stretch.length, stretch.closed, gap)
    return [(place, *(value[order.astype(np.int64)] for value in values)) for place, order in found]


def course(
    s: Floats, value: Floats, length: float, closed: bool, gap: float | None = None
) -> list[tuple[Floats, Floats]]:
    """Values sorted by arc length, cut where a gap is long; a closed course goes on past its seam by a point.

    A gap is long beyond `gap` in mm, by default beyond `GAP_SPACINGS` typical spacings.
    """
    if not len(s):
        return []
    order = np.argsort(s, kind="stable")
    s, value = s[order], value[order]
    if closed:
        s = np.concatenate([[s[-1] - length], s, [s[0] + length]])
        value = np.concatenate([[value[-1]], value, [value[0]]])
    step = np.diff(s)
    if gap is None:
        apart = step[step > 0]
        gap = GAP_SPACINGS * float(np.median(apart)) if len(apart) else math.inf
    cuts = np.flatnonzero(step > gap) + 1
    return list(zip(np.split(s, cuts), np.split(value, cuts), strict=True))


def value_axis(values: Floats, bottom: float, top: float) -> Axis:
    """Axis of values in small units that holds zero."""
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    room = max(high - low, 0.2)
    return Axis(low - 0.08 * room, high + 0.08 * room, bottom, top)


def frame(canvas: Canvas, x: Axis, y: Axis, below: str, beside: str) -> None:
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


def histogram(before: Floats, predicted: Floats, random_std: float) -> Plot:
    """Distribution of the deviations before, and predicted after the correction.

    Parameters
    ----------
    before, predicted : (n,) float64
        mm; at least one point.
    random_std : float
        mm; NaN where it is not known.
    """
    a, b = before * reader.fine_per_mm(), predicted * reader.fine_per_mm()
    low, high = float(min(a.min(), b.min(), 0.0)), float(max(a.max(), b.max(), 0.0))
    width = class_width(a, b, high - low)
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
        tallest = max(tallest, len(b) * width / (random_std * reader.fine_per_mm() * math.sqrt(2 * math.pi)))
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
        sigma, mean = random_std * reader.fine_per_mm(), float(b.mean())
        at = np.linspace(max(x.low, mean - 4 * sigma), min(x.high, mean + 4 * sigma), 161)
        bell = len(b) * width / (sigma * math.sqrt(2 * math.pi)) * np.exp(-0.5 * ((at - mean) / sigma) ** 2)
        canvas.path(polyline(x(at), y(bell)), "bell")
    canvas.text((x.start + x.end) / 2, bottom + 32, f"deviation / {reader.fine()}", anchor="middle")
    canvas.text(13, (top + bottom) / 2, "points", anchor="middle", turn=-90)
    words = f"Classes of {number(width)} {reader.fine()}; bars above: mean \N{PLUS-MINUS SIGN} standard deviation."
    if math.isfinite(random_std):
        words += (
            f" The random part has a standard deviation of {reader.shown(random_std, '.2f')}: no correction can make "
            "the spread smaller than what of it comes from the process."
        )
    return Plot(str(canvas), words)


def class_width(a: Floats, b: Floats, span: float) -> float:
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
