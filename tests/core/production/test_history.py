# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown of a journal: table, CSV, page. Numbers are those that went in."""

from __future__ import annotations

import csv
import dataclasses
import datetime
import math
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

from millcorr.errors import UsageError
from millcorr.geometry.profile import Stretch
from millcorr.production import history
from millcorr.production.journal import Chain, Entry
from millcorr.production.places import Places
from millcorr.report import history as report_history

PLACES = Places((Stretch(0, 0.0, 30.0, True),), (60,))


def entry(part: int, mean: float, *, corrected: bool, smoothed: float = math.nan, place: float = 0.0) -> Entry:
    """A part whose points scatter by 1 um about the mean, um."""
    zero = np.zeros(60)
    row = {"mean": mean, "min": mean - 2, "max": mean + 3, "height": 5.0, "std": 1.0}
    statistics = {
        "points": 200,
        "deviation": {name: value / 1000 for name, value in row.items()},
        "determined": abs(mean) / 1000,
        "correction": 0.012,
        "components": {"mean": mean / 1000, "place X": place / 1000, "place Y": math.nan},
        "commanded": {"mean": 0.0, "place X": 0.0, "place Y": math.nan},
    }
    if math.isfinite(smoothed):
        statistics["smoothed"] = smoothed / 1000
    before = f"P{part - 1}.nc"
    return Entry(
        f"2024-05-{part:02}T06:30:00Z",
        (before, "aa" * 32),
        (f"P{part}.nc", ("bb" if corrected else "aa") * 32),
        ((f"part <{part}>.csv", f"{part:064x}"),),
        "smoothed" if corrected else "keep",
        "why, <indeed>",
        {"correction": "method mirror", "control": {"weight": 2.0, "limit": 0.004}},
        statistics,
        zero,
        zero,
        zero,
        zero,
        None,
        part,
    )


def chain(*entries: Entry) -> Chain:
    return Chain("ab" * 8, "P0 & Co.nc", (), PLACES, entries)


SERIES = chain(
    entry(1, 12.0, corrected=True, smoothed=12.0),
    entry(2, -3.0, corrected=False, smoothed=1.5),
    dataclasses.replace(entry(3, 4.0, corrected=True), pending=True),
)


def test_the_table_says_what_was_corrected_and_what_was_not() -> None:
    lines = history.table([SERIES]).splitlines()
    assert lines[0] == f"P0 & Co.nc (first program {'ab' * 8}), 3 parts; um"
    assert lines[2].split() == "1 2024-05-01T06:30:00Z 12.00 1.00 5.00 12.00 12.00 12.00".split() + (
        "corrected by the smoothed deviation".split()
    )
    assert lines[3].endswith("NOT CORRECTED") and lines[3].split()[2:7] == ["-3.00", "1.00", "5.00", "3.00", "1.50"]
    assert "PENDING" in lines[4] and lines[4].split()[6] == "-"
    assert history.table([]) == "the journal has no part yet"
    # A journal without process control, where nothing was to be corrected.
    plain = dataclasses.replace(entry(1, 0.0, corrected=False), decision="correct")
    assert history.decision_in_words(plain) == "NOT CORRECTED"


def test_the_csv_holds_every_number() -> None:
    rows = list(csv.DictReader(history.csv_lines([SERIES, dataclasses.replace(SERIES, first="cd" * 8)])))
    assert len(rows) == 6 and [r["part"] for r in rows[:3]] == ["1", "2", "3"]
    second = rows[1]
    assert (second["chain"], second["time"], second["status"]) == ("ab" * 8, "2024-05-02T06:30:00Z", "done")
    assert (second["measured"], second["fingerprint"]) == ("part <2>.csv", f"{2:064x}")
    assert (second["corrected"], second["decision"], second["reason"]) == ("0", "keep", "why, <indeed>")
    expected = {"mean": -0.003, "min": -0.005, "max": 0.0, "height": 0.005, "std": 0.001, "determined": 0.003}
    expected |= {"smoothed": 0.0015, "correction": 0.012, "machine_mean": -0.003, "machine_x": 0.0}
    assert {name: float(second[name]) for name in expected} == pytest.approx(expected)
    assert (
        second["machine_y"] == second["machine_form"] == ""
        and rows[2]["smoothed"] == ""
        and rows[2]["status"] == "pending"
    )


def marks(svg: str, css: str) -> list[tuple[float, float]]:
    """Where the marks of a class stand, the legend's own left out."""
    data = "".join(re.findall(rf'<path class="{css}" d="([^"]*)"/>', svg))
    return [(float(x), float(y)) for x, y in re.findall(r"M([\d.-]+) ([\d.-]+)m", data)][1:]


def test_the_charts_stand_where_the_numbers_say() -> None:
    series = [entry(n, float(n), corrected=n == 3, smoothed=n / 2) for n in range(1, 13)]
    plot = report_history.deviations(series)
    ElementTree.fromstring(plot.svg)
    at = np.array(marks(plot.svg, "predicted"))
    assert len(at) == 12
    # Equal steps in part and in deviation; up is more material.
    assert np.diff(at[:, 0]) == pytest.approx(np.full(11, at[1, 0] - at[0, 0]), abs=0.02)
    assert np.diff(at[:, 1]) == pytest.approx(np.full(11, at[1, 1] - at[0, 1]), abs=0.02) and at[1, 1] < at[0, 1]
    (upright,) = re.findall(r'class="corner" d="M([\d.]+) [\d.]+L\1 ', plot.svg)
    assert float(upright) == pytest.approx(at[2:4, 0].mean(), abs=0.02)


def test_jumps_are_drawn_before_their_part() -> None:
    place = [0.1, -0.1, 0.1, -0.1, 0.1, -0.1, 0.1, 30.1, 29.9, 30.1]
    series = [entry(n, 1.0, corrected=False, place=p) for n, p in enumerate(place, 1)]
    ((component, change),) = history.changes(series)
    assert (component, change.kind, change.part) == ("place X", "jump", 7)
    plot = report_history.machine(series)
    ElementTree.fromstring(plot.svg)
    at = np.array(marks(plot.svg, "excess"))
    (upright,) = re.findall(r'class="corner" d="M([\d.]+) [\d.]+L\1 ', plot.svg)
    assert float(upright) == pytest.approx(at[6:8, 0].mean(), abs=0.02)
    assert "+30.0 \N{MICRO SIGN}m" in plot.svg


def test_the_page_stands_alone_and_escapes_what_it_shows(tmp_path: Path) -> None:
    one = chain(entry(1, 12.0, corrected=True))
    date = datetime.date(2024, 5, 1)
    html, table = report_history.write([SERIES, one], Path("a<b.journal"), tmp_path / "report", date=date)
    text = html.read_text(encoding="utf-8")
    assert "a&lt;b.journal" in text and "P0 &amp; Co.nc" in text and "a<b" not in text
    assert "NOT CORRECTED" in text and "after 2 of them the program was corrected, after 1 it stayed" in text
    assert not re.search(r"(?:src|href)=|<script|@import|url\((?!#)", text)
    assert table.read_text(encoding="utf-8") == "".join(history.csv_lines([SERIES, one]))
    assert report_history.page([SERIES], "x", date=date) == report_history.page([SERIES], "x", date=date)
    assert "no part yet" in report_history.page([], "x")
    assert sorted(p.name for p in (tmp_path / "report").iterdir()) == ["history.csv", "history.html"]
    (tmp_path / "file").touch()
    with pytest.raises(UsageError, match="needs a directory"):
        report_history.write([SERIES], Path("a"), tmp_path / "file")
