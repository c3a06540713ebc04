# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report's section on the transfer function: MS along the contour, depths, and the offset kept apart."""

from __future__ import annotations

import math

import numpy as np

from millcorr.comparison.deviation import statistics
from millcorr.correction.wanted_displacement import Elastic
from millcorr.geometry.correction import along
from millcorr.messages import phrase
from millcorr.pipeline import Result

from . import reader
from .html import figure, heading, html_facts, mm, um, with_unit
from .plots import COVERAGE, MOST_MARKERS, WIDTH, Plot, corners, course, frame, groups
from .prediction import nothing_measured
from .svg import Axis, Canvas, columns, polyline

HEIGHT = 175.0
_BESIDE = "\N{PLUS-MINUS SIGN}"


def transfer_section(result: Result) -> str:
    """The section as HTML; '' where no transfer function corrects."""
    elastic = result.elastic
    if elastic is None:
        return ""
    said = elastic.summary(result.request.settings)
    depths = ", ".join(reader.length(depth) for depth in said["depth"])
    low, high = said["next_depth_range"]
    following = reader.length(said["next_depth"])
    if high - low > 5e-4:
        following = f"{mm(low)} to {mm(high)} {reader.coarse()}"
    readings = {
        "smooth": "smooth along the contour, from the filtered deviations",
        "one": "one value, the mean over the points",
        "points": "one value a point, as measured",
        "by axis": "MSx and MSy of the touches, as the load has it at each",
    }
    part = "simulated" if nothing_measured(result) else "measured"
    rows = [
        ("MS", f"{said['ms_mean']:.4f} in the mean, {said['ms_min']:.4f} to {said['ms_max']:.4f}"),
        ("Standard uncertainty of MS", _number(said["ms_uncertainty"], "{:.4f}")),
        (f"Depth of the {part} part", f"{depths}, deviations along {_axis(said['depth_along'])}"),
        ("Depth that the next part finds", following),
        ("Taken as", readings[said["taken"]]),
        ("Uncertainty of the correction", _known(said["correction_uncertainty"], " (k = 1)")),
    ]
    offset = said["offset"]
    if offset:
        rows.append(
            (
                "Constant offset, kept apart",
                f"{with_unit(offset['mean'], True)} in the mean, {um(offset['min'], True)} to "
                f"{with_unit(offset['max'], True)}; standard uncertainty " + _known(offset["uncertainty"]),
            )
        )
    words = (
        "Of a commanded depth h the machine removes so much that MS times the removed depth stays (Petrakov 2025, "
        "eq. 4). The corrected program commands (1 + MS) times the next depth."
    )
    title = heading(phrase("Transfer function"))
    return f"{title}<p>{words}</p>{figure(ms_along_contour(result, elastic))}{html_facts(rows)}"


def _axis(name: str) -> str:
    return "the normal" if name == "normal" else name.upper()


def _known(value: float | None, more: str = "") -> str:
    return "not known" if value is None or not math.isfinite(value) else reader.shown(value) + more


def _number(value: float | None, form: str) -> str:
    return "not known" if value is None or not math.isfinite(value) else form.format(value)


def ms_along_contour(result: Result, elastic: Elastic) -> Plot:
    """MS over arc length with its expanded uncertainty; a panel for every contour.

    Parameters
    ----------
    result : Result
    elastic : Elastic
        Its transfer function is drawn at the used points.
    """
    d, profile, ms = result.deviation, result.nominal, elastic.transfer.ms
    half = COVERAGE * elastic.transfer.ms_std
    shown = np.unique(d.contour)[:8]
    canvas = Canvas(WIDTH, 24 + len(shown) * (HEIGHT + 44), "Transfer function along the contour")
    entries = [("MS", [("filtered", "m-9 0h18")])]
    if np.isfinite(half).any():
        entries.append((f"its uncertainty, k = {COVERAGE:g}", [("band", "m-9-4h18v8h-18z")]))
    canvas.legend(56, 14, entries)
    stretches, levels = profile.stretches(), int(d.level.max()) + 1
    edge = np.nan_to_num(half)
    low, high = min(0.0, float((ms - edge).min())), float((ms + edge).max())
    room = 0.08 * max(high - low, 1e-4)
    for i, contour in enumerate(shown.tolist()):
        top = 30.0 + i * (HEIGHT + 44)
        x = Axis(0.0, float(profile.total[contour]), 56.0, WIDTH - 12.0)
        y = Axis(low - room, high + room, top + HEIGHT, top)
        frame(canvas, x.scaled(1.0 / reader.unit().mm), y, f"s / {reader.coarse()}", "MS")
        if len(profile.contours) > 1:
            canvas.text(x.end, top - 5, f"contour {contour + 1}", "strong", "end")
        name = f"transfer{contour}"
        canvas.clip(name, x.start, top, x.end - x.start, HEIGHT)
        for s in corners(profile, contour):
            canvas.line(x.at(s), top, x.at(s), y.start, "corner")
        rows = np.flatnonzero(d.contour == contour)
        key = d.stretch[rows] * levels + d.level[rows]
        band, line = "", ""
        for one, here in groups(key):
            at, stretch = rows[here], stretches[one // levels]
            local = along(stretch, d.s[at], profile)
            index = np.arange(len(at), dtype=np.float64)
            for s, order in course(local, index, stretch.length, stretch.closed):
                pick = at[order.astype(np.int64)]
                px, parts = x(stretch.begin + s), [y(ms[pick]), y(ms[pick] - half[pick]), y(ms[pick] + half[pick])]
                if len(px) > MOST_MARKERS:
                    px, means = columns(px, parts)
                    parts = [mean for _, mean, _ in means]
                for shift in (0.0, x.start - x.end, x.end - x.start):
                    if (px + shift).max() > x.start and (px + shift).min() < x.end:
                        line += polyline(px + shift, parts[0])
                        if np.isfinite(parts[1]).all():
                            both = np.append(parts[1], parts[2][::-1])
                            band += polyline(np.append(px, px[::-1]) + shift, both, True)
        canvas.path(band, "band", name)
        canvas.path(line, "filtered", name)
    over = statistics(ms)
    words = [f"MS over the arc length of the nominal: {over['mean']:.4f} in the mean."]
    if np.isfinite(half).any():
        words.append(f"Band: expanded uncertainty (k = {COVERAGE:g}), up to {_BESIDE}{np.nanmax(half):.4f}.")
    if len(np.unique(d.contour)) > len(shown):
        words.append(f"The first {len(shown)} contours are drawn; deviations.csv has all.")
    return Plot(str(canvas), " ".join(words))
