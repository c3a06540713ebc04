# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a simulated wall over its height: table, curves, and what shift and tilt leave (dat-2025, figs. 12, 13)."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from typing import Any

import numpy as np

from millcorr.arrays import Floats
from millcorr.production.wall import Wall

from . import reader
from .html import capital, figure, html_table, um
from .plots import WIDTH, Plot, course, frame, value_axis
from .svg import Axis, Canvas, columns, polyline

MOST_TABLED = 8
"""Stretches of which the page has figures; simulation.json has all."""

LOOKS = ("excess", "undercut", "within", "predicted", "filtered", "raw")
"""One style a height; of more heights so many are drawn, evenly spread."""

_PANEL = 190.0


def csv_lines(wall: Wall) -> Iterator[str]:
    """Lines of wall.csv, the header first: a row for every step that makes a wall."""
    e, rows = wall.before.model.engagement, wall.rows
    names = [f"error_at_{h:g}_mm" for h in wall.before.heights]
    names += [] if wall.tilted is None else [f"tilted_at_{h:g}_mm" for h in wall.before.heights]
    yield ",".join(["line", "stretch", "s_mm", "t_s", "x_mm", "y_mm", *names]) + "\n"
    values = [wall.before.value] if wall.tilted is None else [wall.before.value, wall.tilted.value]
    table = np.column_stack([e.s, wall.t, e.position[:, :2], *values])[rows]
    for line, stretch, row in zip(wall.line[rows].tolist(), wall.stretch[rows].tolist(), table.tolist(), strict=True):
        cells = ",".join("" if v != v else f"{v:.9g}" for v in row)
        yield f"{line},{stretch or ''},{cells}\n"


def summary(wall: Wall) -> dict[str, Any]:
    """What simulation.json says of the wall; lengths in mm, positive where material is left or out of the part."""
    out: dict[str, Any] = {
        "heights_mm": wall.before.heights.tolist(),
        "largest_mm": dict(zip(("before", "shifted", "tilted"), wall.largest, strict=False)),
        "loop_accuracy_mm": wall.before.residual,
        "caution": wall.before.caution,
        "note": wall.note,
        "stretches": [],
    }
    r = wall.remedy
    if r is None:
        return out
    out["tilted_about_mm"] = r.about
    for k, stretch in enumerate(r.stretches):
        out["stretches"].append(
            {
                "stretch": int(r.number[k]) + 1,
                "length_mm": stretch.length,
                "shift_mm": float(r.offset[k]),
                "tilt_deg": float(r.degrees[k]),
                "floor_mm": float(r.floor[k]),
                "before_mm": _plain(r.before[k]),
                "shifted_mm": _plain(r.shifted[k]),
                "tilted_mm": _plain(r.after[k]),
                "largest_mm": dict(zip(("before", "shifted", "tilted"), r.worst[k].tolist(), strict=True)),
            }
        )
    return out


def _plain(values: Floats) -> list[float | None]:
    return [None if v != v else v for v in values.tolist()]


def in_words(wall: Wall) -> list[str]:
    """What to say in the terminal."""
    heights = ", ".join(f"{h / reader.unit().mm:.6g}" for h in wall.before.heights)
    before, *after = (reader.small(v, ".1f") for v in wall.largest)
    left = f"; shifted {after[0]}; shifted and tilted {after[1]}" if after else ""
    out = [f"wall        at most {before} off, {heights} {reader.coarse()} above the tip{left}"]
    if wall.note:
        out.append(f"warning     {reader.worded(wall.note)}")
    return out


def curves(wall: Wall) -> Plot:
    """Error at each height against path length: as it is, and below it shifted and tilted."""
    heights = wall.before.heights
    shown = np.unique(np.linspace(0, len(heights) - 1, min(len(heights), len(LOOKS))).round().astype(np.int64))
    rows = wall.rows
    s = wall.before.model.engagement.s[rows] / reader.unit().mm
    panels = [("as it is", wall.before.value)]
    if wall.tilted is not None:
        panels.append(("shifted and tilted", wall.tilted.value))
    canvas = Canvas(WIDTH, 36 + len(panels) * (_PANEL + 50), "Error of the wall at each height")
    canvas.legend(56, 14, [(reader.length(float(heights[k])), [(LOOKS[i], "m-9 0h18")]) for i, k in enumerate(shown)])
    known = np.concatenate([value[rows][:, shown].ravel() for _, value in panels])
    known = known[np.isfinite(known)] * reader.fine_per_mm()
    x = Axis(float(s[0]), float(max(s[-1], s[0] + 1e-6)), 56.0, WIDTH - 12.0)
    stretch = wall.stretch[rows]
    turns = (s[1:] + s[:-1])[stretch[1:] != stretch[:-1]] / 2
    for i, (title, value) in enumerate(panels):
        top = 36 + i * (_PANEL + 50)
        y = value_axis(known, top + _PANEL, top)
        frame(canvas, x, y, f"path length / {reader.coarse()}", f"error / {reader.fine()}")
        canvas.text(x.end, top - 5, title, "strong", "end")
        for at in turns:
            canvas.line(x.at(at), top, x.at(at), top + _PANEL, "corner")
        for look, k in zip(LOOKS, shown, strict=False):
            there = np.isfinite(value[rows, k])
            for along, error in course(s[there], value[rows, k][there] * reader.fine_per_mm(), 0.0, False):
                canvas.path(_drawn(x(along), y(error)), look)
    words = [
        f"Error of the wall in {reader.fine()} along its normal at each height above the tip, over the length of the "
        "path; above zero material is left."
    ]
    if len(turns):
        words.append("Dotted uprights mark where one stretch of the contour ends.")
    if len(shown) < len(heights):
        words.append(f"Of {len(heights)} heights {len(shown)} are drawn; wall.csv has all.")
    return Plot(str(canvas), " ".join(words))


def _drawn(x: Floats, y: Floats) -> str:
    """Path through points; where they are dense, through the lowest and the highest of each column of pixels."""
    if len(x) > 2 * WIDTH:
        middle, [(low, _, high)] = columns(x, [y])
        x, y = np.repeat(middle, 2), np.stack([low, high], axis=1).ravel()
    return polyline(x, y)


def section(wall: Wall, plot: Plot) -> str:
    """The page's part on the wall, as HTML."""
    parts = [
        "<h2>Wall over the height</h2>",
        "<p class=small>Deflection at the moment in which an edge makes the surface at each height, by the forces of "
        "the real feed; the figures above go by the mean force of a turn, over the whole height.</p>",
        figure(plot),
    ]
    if wall.before.caution:
        parts.append(f"<p class=note>{escape(capital(wall.before.caution))}.</p>")
    if wall.note:
        parts.append(f"<p class=note>{escape(reader.worded(wall.note))}</p>")
    r = wall.remedy
    if r is not None:
        worst = np.sort(np.argsort(-r.worst[:, 0], kind="stable")[:MOST_TABLED])
        table = [
            [
                f"stretch {r.number[k] + 1}, {reader.length(h)} above the tip",
                *(um(v[k, i], True) for v in (r.before, r.shifted, r.after)),
            ]
            for k in worst
            for i, h in enumerate(r.heights)
        ]
        parts.append(f"<h3>Mean error in {reader.fine()}</h3>")
        parts.append(html_table(("", "before", "shifted", "shifted and tilted"), table))
        lines = r.lines()
        words = "".join(f"<li>{escape(capital(lines[k]))}.</li>" for k in worst)
        parts.append(f"<h3>Remedies</h3><ul>{words}</ul>")
        if len(worst) < len(lines):
            parts.append(f"<p class=small>The {len(worst)} worst of {len(lines)}; simulation.json has all.</p>")
        parts.append(
            "<p class=small>A negative shift moves the contour into the part; a positive tilt leans the tool's upper "
            f"end out of it, about the height of {reader.length(r.about)}. Both fit the mean of a stretch: where the "
            "tool is slow, at starts, stops and corners, it bends less. Neither is in the corrected path above.</p>"
        )
    parts.append("<p class=small>Every step is in <b>wall.csv</b>.</p>")
    return "".join(parts)
