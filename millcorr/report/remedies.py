# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of what a simulation wrote or found beside itself: slowed corners, a tilted tool, an identified machine."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from typing import Any

from millcorr.process.prediction.corner_feed import CornerFeeds
from millcorr.production.remedy_programs import ShiftedProgram, TiltedProgram
from millcorr.production.simulation import Study

from . import reader
from .html import coordinates, html_table, um

MOST_TABLED = 12
"""Corners of which the page has figures; simulation.json has all."""


def summary(study: Study) -> dict[str, Any]:
    """What simulation.json says of it: lengths in mm, times in s."""
    return {
        "slowed": None if study.slowed is None else _slowed(study, study.slowed),
        "shifted": None
        if study.shifted is None
        else {
            "program": str(study.asked.shifted),
            "path_moved_mm": study.shifted.largest,
            "largest_before_mm": study.shifted.before,
            "largest_after_mm": study.shifted.after,
        },
        "tilted": None if study.tilted is None else _tilted(study, study.tilted),
        "identified": None if study.machine is None else study.machine.summary(),
    }


def _slowed(study: Study, found: CornerFeeds) -> dict[str, Any]:
    rows = zip(found.line, found.vertex, found.feed, found.before, found.after, strict=True)
    return {
        "program": str(study.asked.slowed),
        "bound_mm": study.asked.corner_error,
        "time_before_s": found.duration[0],
        "time_after_s": found.duration[1],
        "corners": [
            {
                "line": int(line),
                "place_mm": [None if v != v else v for v in vertex.tolist()],
                "feed_mm_min": 60 * float(feed),
                "before_mm": float(before),
                "after_mm": float(after),
            }
            for line, vertex, feed, before, after in rows
        ],
    }


def _tilted(study: Study, found: TiltedProgram) -> dict[str, Any]:
    return {
        "program": str(study.asked.tilted),
        "lines": list(found.lines),
        "stretches": [
            {
                "stretch": int(found.remedy.number[k]) + 1,
                "tilt_deg": float(found.remedy.degrees[k]),
                "path_moved_mm": float(found.shift[k]),
                "largest_before_mm": float(found.remedy.worst[k, 0]),
                "largest_after_mm": float(found.after[k]),
            }
            for k in range(len(found.after))
        ],
    }


def in_words(study: Study) -> Iterator[str]:
    """What to say in the terminal."""
    if study.machine is not None:
        m = study.machine
        left = (
            reader.small(m.residual, ".2g") if m.positions else f"{reader.feed_in_unit(m.residual):.2g} {reader.feed()}"
        )
        yield f"identified  [machine] by {m.source}, which scatters by {left} about it; simulated with it"
        yield from (f"            {line}" for line in m.lines())
    if study.slowed is not None:
        yield f"slowed      {_slowed_in_words(study, study.slowed)}: {study.asked.slowed}"
    if study.shifted is not None:
        yield f"shifted     {_shifted_in_words(study.shifted)}: {study.asked.shifted}"
    if study.tilted is not None:
        before, after = (reader.small(v.max(), ".1f") for v in (study.tilted.remedy.worst[:, 0], study.tilted.after))
        yield f"tilted      walls from {before} to {after} off at most: {study.asked.tilted}"


def _shifted_in_words(found: ShiftedProgram) -> str:
    before, after, largest = (reader.small(v, ".1f") for v in (found.before, found.after, found.largest))
    return f"walls from {before} to {after} off at most, by moving the contour up to {largest}"


def _slowed_in_words(study: Study, found: CornerFeeds) -> str:
    bound = reader.small(study.asked.corner_error or 0.0, "g")
    if not len(found.line):
        return f"no corner is off by more than {bound}, the program is written as it was"
    corners = f"{len(found.line)} {'corner' if len(found.line) == 1 else 'corners'}"
    return (
        f"{corners} from {reader.small(found.before.max(), '.1f')} to {reader.small(found.after.max(), '.1f')} at most "
        f"(bound {bound}), in {found.duration[1]:.2f} s in place of {found.duration[0]:.2f} s"
    )


def sections(study: Study) -> Iterator[str]:
    """Parts of the page, as HTML."""
    if study.machine is not None:
        lines = "\n".join(escape(line) for line in study.machine.lines())
        yield (
            f"<h2>Machine by its log</h2><p>Identified from {escape(study.machine.source)}, with standard "
            f"uncertainties; this simulation runs with it.</p><pre>[machine]\n{lines}</pre>"
        )
    if study.slowed is not None:
        said = escape(_slowed_in_words(study, study.slowed))
        yield f"<h2>Corners run slower</h2><p>{said}.</p>" + _corners(study.slowed)
    if study.shifted is not None:
        yield (
            f"<h2>Shifted contour</h2><p>{escape(str(study.asked.shifted))}: "
            f"{escape(_shifted_in_words(study.shifted))}. It has been read back and predicted again.</p>"
        )
    if study.tilted is not None:
        t = study.tilted
        rows = [
            (
                f"stretch {t.remedy.number[k] + 1}",
                f"{t.remedy.degrees[k]:+.4f}",
                um(t.shift[k], True),
                um(t.remedy.worst[k, 0]),
                um(t.after[k]),
            )
            for k in range(min(len(t.after), MOST_TABLED))
        ]
        head = (
            "",
            "tilt / \N{DEGREE SIGN}",
            *(f"{w} / {reader.fine()}" for w in ("path moved", "at most off", "tilted")),
        )
        yield (
            f"<h2>Tilted tool</h2><p>{escape(str(study.asked.tilted))} turns the tool on lines "
            f"{', '.join(map(str, t.lines))}. It has been read back and predicted again. The control keeps the tip "
            "where it is programmed, so its path is moved with the tilt.</p>" + html_table(head, rows)
        )


def _corners(found: CornerFeeds) -> str:
    if not len(found.line):
        return ""
    rows = [
        (
            f"line {found.line[k]}, {coordinates(*found.vertex[k][:2])}",
            f"{reader.feed_in_unit(found.feed[k]):.6g}",
            um(found.before[k]),
            um(found.after[k]),
        )
        for k in range(min(len(found.line), MOST_TABLED))
    ]
    more = len(found.line) - len(rows)
    note = f"<p class=small>{more} more corners are in simulation.json.</p>" if more else ""
    head = ("", f"feed / {reader.feed()}", f"before / {reader.fine()}", f"after / {reader.fine()}")
    return html_table(head, rows) + note
