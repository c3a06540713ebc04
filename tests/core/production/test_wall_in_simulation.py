# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr simulate --heights`: the corner of dat-2025 through the command line."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import numpy as np
import pytest

from millcorr import nc
from millcorr.__main__ import main
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.deflection.height_error import WallModel
from millcorr.process.deflection.real_path import real_path
from millcorr.process.deflection.tilt import remedies
from millcorr.process.engagement import stock_of
from millcorr.process.kinematics import AxisDynamics, Control
from millcorr.process.setup_file import load

SETUP = Path(__file__).resolve().parents[3] / "resources" / "setups" / "dat-2025.toml"
CORNER = "G90 G17 G21 F300\nG0 X-25 Y0 Z5\nG1 Z0\nG1 X0\nG1 Y25\nG0 Z5\n"
HOLLOW = Profile.from_contours(
    [Contour((NurbsCurve.line((5, 60), (5, -5)), NurbsCurve.line((5, -5), (-60, -5))), False)]
)
"""Inner corner of the part, to the right of the paper's path along +X, then +Y."""
HEIGHTS = ("0.5", "1", "1.5", "2")
INERTIA = "acceleration_time_x_ms = 50.0\nacceleration_time_y_ms = 50.0\nposition_gain_per_s = 40.0\n"


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    here = tmp_path_factory.mktemp("wall")
    (here / "corner.nc").write_text(CORNER)
    (here / "profile.json").write_text(json.dumps(HOLLOW.as_dict()))
    return here


def run(directory, report, heights, setup=SETUP, program="corner.nc"):
    arguments = ["--program", str(directory / program), "--nominal", str(directory / "profile.json"), "--side", "left"]
    wanted = [word for height in heights for word in ("--heights", height)]
    return main(["simulate", *arguments, "--setup", str(setup), "--report", str(directory / report), *wanted])


@pytest.fixture(scope="module")
def report(directory):
    # Not in order: the report puts heights in order.
    assert run(directory, "report", reversed(HEIGHTS)) == 0
    return directory / "report"


def figures(report):
    return json.loads((report / "simulation.json").read_text(encoding="utf-8"))["wall"]


def columns(report):
    with open(report / "wall.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def test_paper_corner_25_um_fall_to_3(report):
    """dat-2025, fig. 13: about 25 um at 0.5 mm above the tip, about 3 um with the angle corrected."""
    wall = figures(report)
    assert wall["heights_mm"] == [0.5, 1.0, 1.5, 2.0]
    assert wall["largest_mm"]["before"] == pytest.approx(0.025, abs=1e-4)
    assert wall["largest_mm"]["shifted"] > 0.010
    assert wall["largest_mm"]["tilted"] <= 0.003
    assert "factor of two" in wall["caution"] and wall["note"] == ""
    assert [one["stretch"] for one in wall["stretches"]] == [1, 2]
    for one in wall["stretches"]:
        assert one["before_mm"][0] == pytest.approx(0.025, abs=1e-4)
        # The wall leans by its own slope, and the end face digs by R sin of it.
        slope = np.polyfit(wall["heights_mm"], one["before_mm"], 1)[0]
        assert np.radians(one["tilt_deg"]) == pytest.approx(-slope, rel=0.02)
        assert one["floor_mm"] == pytest.approx(5.0 * np.sin(np.radians(one["tilt_deg"])), rel=1e-9)
        assert one["shift_mm"] == pytest.approx(-np.mean(one["before_mm"]), rel=0.02)


def test_table_is_the_model(report):
    """Every row of wall.csv against the model asked directly; nine digits are written."""
    setup, table = load(SETUP), columns(report)
    path = real_path(nc.parse(CORNER).toolpath, spacing=0.1)
    error = WallModel.of(path, setup, stock_of(setup, HOLLOW)).errors([0.5, 1.0, 1.5, 2.0])
    rows = np.flatnonzero(np.isfinite(error.value).any(axis=1))
    assert len(rows) == len(table["s_mm"]) > 400
    e = error.model.engagement
    assert table["s_mm"] == pytest.approx(e.s[rows], rel=1e-8)
    # 300 mm/min are 5 mm/s.
    assert table["t_s"] == pytest.approx(e.s[rows] / 5.0, rel=1e-8, abs=1e-9)
    assert set(table["line"]) == {4.0, 5.0}
    assert (table["line"] == np.where(e.s[rows] < 25.0 + 1e-9, 4, 5)).mean() > 0.99
    for k, height in enumerate(HEIGHTS):
        assert table[f"error_at_{height}_mm"] == pytest.approx(error.value[rows, k], rel=1e-8, abs=1e-12, nan_ok=True)
    remedy = remedies(error, HOLLOW)
    tilted = np.column_stack([table[f"tilted_at_{height}_mm"] for height in HEIGHTS])
    known = np.isfinite(tilted).any(axis=1)
    assert (known == (table["stretch"] > 0)).all()
    assert np.nanmax(np.abs(tilted)) == pytest.approx(remedy.worst[:, 2].max(), rel=1e-6)


def test_page_shows_the_wall(report):
    page = (report / "simulation.html").read_text(encoding="utf-8")
    part = page[page.index("<h2>Wall over the height</h2>") : page.index("<h2>Setup</h2>")]
    for height in HEIGHTS:
        assert f">{height} mm</text>" in part
        assert len(re.findall(rf"<th>stretch \d, {height} mm above the tip</th>", part)) == 2
    assert part.count("shift -") == 2 and "tilt +0.9" in part and "factor of two" in part
    assert (report / "wall.svg").read_text(encoding="utf-8").startswith("<svg")


def test_with_acceleration_time_and_feed_are_those_of_the_actual_motion(directory):
    """The corner of a slow machine: the same walls, later, and less error where the feed is least."""
    slow = directory / "slow.toml"
    slow.write_text(SETUP.read_text(encoding="utf-8").replace("[machine]\n", "[machine]\n" + INERTIA), encoding="utf-8")
    assert run(directory, "slow", HEIGHTS, slow) == 0
    table, wall = columns(directory / "slow"), figures(directory / "slow")
    # A linear ramp of 50 ms and the servo's lag of 1/40 s put the end of 50 mm at 5 mm/s off by less than 0.5 s.
    assert (np.diff(table["t_s"]) >= 0).all() and 0.0 < table["t_s"][-1] - table["t_s"][0] - 10.0 < 0.5
    setup = load(slow)
    path = real_path(nc.parse(CORNER).toolpath, Control.alike(AxisDynamics(0.05, "linear", 40.0)))
    error = WallModel.of(path, setup, stock_of(setup, HOLLOW)).errors([0.5, 1.0, 1.5, 2.0])
    rows = np.flatnonzero(np.isfinite(error.value).any(axis=1))
    assert table["error_at_0.5_mm"] == pytest.approx(error.value[rows, 0], rel=1e-8, abs=1e-12, nan_ok=True)
    middle = (table["s_mm"] > 20) & (table["s_mm"] < 30)
    assert np.nanmin(table["error_at_0.5_mm"][middle]) < 0.8 * np.nanmax(table["error_at_0.5_mm"])
    assert max(abs(v) for one in wall["stretches"] for v in one["tilted_mm"]) <= 0.003


def test_one_height_has_no_remedy(directory, capsys):
    assert run(directory, "one", ["0.5"]) == 0
    assert "a slope needs two heights" in capsys.readouterr().out
    wall = figures(directory / "one")
    assert wall["stretches"] == [] and "two heights" in wall["note"]
    assert wall["largest_mm"] == {"before": pytest.approx(0.025, abs=1e-4)}
    assert not any(name.startswith("tilted") for name in columns(directory / "one"))


def test_without_heights_there_is_no_wall(directory):
    assert run(directory, "none", []) == 0
    assert figures(directory / "none") is None
    assert not (directory / "none" / "wall.csv").exists()
    assert "Wall over the height" not in (directory / "none" / "simulation.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("value", ["2.6", "-0.5", "nan", "inf", "wide"])
def test_bad_heights_end_in_one_line(directory, capsys, value):
    try:
        status = run(directory, "bad", ["0.5", value])
    except SystemExit as stop:
        status = stop.code
    said = capsys.readouterr().err
    assert status == 2 and said.count("\n") == 1 and "--heights" in said and value in said
    assert not (directory / "bad").exists()


def test_a_tool_without_overhang_is_named(directory, capsys):
    setup = directory / "short.toml"
    setup.write_text(SETUP.read_text(encoding="utf-8").replace("overhang_mm = 50.0\n", ""), encoding="utf-8")
    assert run(directory, "bad", HEIGHTS, setup) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "overhang_mm" in said
    assert not (directory / "bad").exists()
