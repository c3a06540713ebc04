# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of a series as one page of HTML that needs nothing but itself, with a trend chart a series."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from html import escape
from pathlib import Path

import numpy as np

from millcorr.messages import phrase
from millcorr.production import history
from millcorr.production.journal import Chain, Entry
from millcorr.whole_file import write_together

from . import reader
from .html import figure, html_facts, html_page, html_table, um
from .plots import WIDTH, Plot, frame, value_axis
from .svg import MARKERS, Axis, Canvas, bars, markers, polyline

FILES = ("history.html", "history.csv")
"""What a report consists of."""

HEIGHT = 190.0

_SHAPES = {"mean": ("filtered", 0), "place X": ("excess", 1), "place Y": ("undercut", 2), "form": ("predicted", 3)}
"""Class and marker of each component."""


def write(chains: Sequence[Chain], journal: Path, directory: Path, *, date: datetime.date | None = None) -> list[Path]:
    """Write `FILES`; those that are there are replaced when all are complete. Errors as `write_together`."""
    html = page(chains, journal.name, date=date)
    return write_together(directory, {"history.html": [html], "history.csv": history.csv_lines(chains)})


def page(chains: Sequence[Chain], name: str, *, date: datetime.date | None = None) -> str:
    """The journal as HTML.

    Parameters
    ----------
    chains : sequence of Chain
    name : str
        Of the journal.
    date : datetime.date, optional
        Today by default.
    """
    return html_page(
        phrase("Serial production"),
        name,
        [_chain(chain) for chain in chains] or ["<p class=verdict>The journal has no part yet.</p>"],
        about="serial production",
        files="Every entry is in <b>history.csv</b>.",
        date=date,
    )


def _chain(chain: Chain) -> str:
    entries = chain.entries
    corrected = sum(entry.corrected for entry in entries)
    count = f"{len(entries)} {'part' if len(entries) == 1 else 'parts'}"
    said = [line for line, _ in history.series(entries)]
    found = "".join(f"<li>{escape(reader.worded(line))}</li>" for line in said)
    out = [
        f"<section><h2>{escape(chain.name)}</h2><p class=verdict>{count}; after {corrected} of them the program was "
        f"corrected, after {len(entries) - corrected} it stayed as it was.</p>",
        f"<div class=warnings><b>{reader.worded(phrase('What the machine does'))}</b><ul>{found}</ul></div>"
        if said
        else "",
    ]
    out += [figure(deviations(entries)), figure(machine(entries))]
    rows = []
    for e in entries:
        d = e.statistics["deviation"]
        values = (d["mean"], d["std"], d["height"], e.statistics["determined"], e.statistics.get("smoothed", np.nan))
        numbers = [um(v) if np.isfinite(v) else "" for v in (*values, e.statistics["correction"])]
        rows.append([f"{e.part}", e.time, *numbers, reader.worded(history.decision_in_words(e))])
    head = (
        phrase("part"),
        phrase("time (UTC)"),
        phrase("mean"),
        phrase("std"),
        phrase("height"),
        phrase("largest"),
        phrase("smoothed"),
        phrase("correction"),
        phrase("decision"),
    )
    out.append(html_table(head, rows))
    last = entries[-1]
    out.append(
        html_facts(
            [
                (phrase("First program, SHA-256"), f"{chain.first}..."),
                (phrase("Program for the next part"), f"{last.after[0]}, SHA-256 {last.after[1]}"),
                *((phrase("Settings of part {}", last.part), _settings(last)),),
            ]
        )
    )
    out.append(
        f"<p class=small>Deviations in {reader.fine()}, positive where material is left. largest: determined deviation "
        "at its largest; smoothed: what was compared with the limit; correction: sum of all corrections in force for "
        "the next part, at its largest place.</p></section>"
    )
    return "\n".join(part for part in out if part)


def _settings(entry: Entry) -> str:
    control = entry.settings.get("control")
    said = ", ".join(f"{k.replace('_', ' ')} {v:g}" for k, v in (control or {}).items())
    rules = f"; control: {said}" if said else ""
    return f"{entry.settings['correction']}{rules}; lengths in mm"


def deviations(entries: Sequence[Entry]) -> Plot:
    """Deviation of each part: range, mean, what is smoothed and its limit; dotted uprights where it was corrected."""
    canvas = Canvas(WIDTH, HEIGHT + 68, "Deviation of the parts")
    canvas.legend(
        56,
        14,
        [
            ("range of the points", [("raw", "m0-6v12")]),
            ("mean", [("predicted", MARKERS[0])]),
            ("smoothed, largest", [("filtered", "m-9 0h18")]),
            ("limit", [("axis", "m-9 0h18")]),
            ("program corrected", [("corner", "m0-6v12")]),
        ],
    )
    x = _parts_axis(entries)
    part = np.array([e.part for e in entries], dtype=np.float64)
    low, mean, high = (
        np.array([e.statistics["deviation"][k] for e in entries]) * reader.fine_per_mm() for k in ("min", "mean", "max")
    )
    smoothed = np.array([e.statistics.get("smoothed", np.nan) for e in entries]) * reader.fine_per_mm()
    limit = np.array([e.settings.get("control", {}).get("limit", np.nan) for e in entries]) * reader.fine_per_mm()
    shown = np.concatenate([low, high, smoothed, limit, -limit])
    y = value_axis(shown[np.isfinite(shown)], 30 + HEIGHT, 30.0)
    frame(canvas, x, y, "part", f"deviation / {reader.fine()}")
    for e in entries:
        if e.corrected:
            canvas.line(x.at(e.part + 0.5), y.start, x.at(e.part + 0.5), y.end, "corner")
    canvas.path(bars(x(part), y(high), y(low)), "raw")
    known = np.isfinite(limit)
    for sign in (1.0, -1.0):
        canvas.path(polyline(x(part[known]), y(sign * limit[known])), "axis")
    known = np.isfinite(smoothed)
    canvas.path(polyline(x(part[known]), y(smoothed[known])), "filtered")
    canvas.path(markers(x(part), y(mean), 0), "predicted")
    return Plot(
        str(canvas),
        "Each part: smallest to largest measured deviation and their mean; line: the largest smoothed deviation (its "
        "absolute value), which is compared with the limit. Dotted uprights: the next part is cut with a corrected "
        "program.",
    )


def machine(entries: Sequence[Entry]) -> Plot:
    """What the machine does without the corrections: mean, place and form of the part, with trends and jumps."""
    canvas = Canvas(WIDTH, HEIGHT + 68, "What the machine does")
    canvas.legend(56, 14, [(name, [(css, MARKERS[shape])]) for name, (css, shape) in _SHAPES.items()])
    x = _parts_axis(entries)
    part = np.array([e.part for e in entries], dtype=np.float64)
    value = {name: own * reader.fine_per_mm() for name, (own, _) in history.machine(entries).items()}
    shown = np.concatenate(list(value.values()))
    y = value_axis(shown[np.isfinite(shown)], 30 + HEIGHT, 30.0)
    frame(canvas, x, y, "part", f"deviation / {reader.fine()}")
    for name, v in value.items():
        known = np.isfinite(v)
        css, shape = _SHAPES[name]
        canvas.path(polyline(x(part[known]), y(v[known])), "course")
        canvas.path(markers(x(part[known]), y(v[known]), shape), css)
    for _, change in history.changes(entries):
        at = x.at(entries[change.part].part - 0.5)
        if change.kind == "jump":
            canvas.line(at, y.start, at, y.end, "corner")
            canvas.text(at + 3, y.end + 10, reader.shown(change.size, "+.1f"))
    return Plot(
        str(canvas),
        "Measured deviation less what the program commands, so that corrections do not show: mean along the contour, "
        "displacement of the part, and the root mean square of the form that the parts share, as much of it as each "
        "shows. Dotted uprights: jumps.",
    )


def _parts_axis(entries: Sequence[Entry]) -> Axis:
    """Parts side by side; the ends leave room, so that whole numbers are the only ticks for few parts."""
    return Axis(entries[0].part - 0.7, max(entries[-1].part, entries[0].part + 9) + 0.7, 56.0, WIDTH - 12.0)
