# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr simulate`: signals, files and page; the figures of petrakov-2023 through the command line."""

from __future__ import annotations

import csv
import html
import json
import re
from dataclasses import replace

import numpy as np
import pytest
import shapely

from millcorr.__main__ import main
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.engagement import stock_of
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.prediction import simulate
from millcorr.process.prediction.signals import COLUMNS, Signals
from millcorr.report.length_unit import INCH
from millcorr.report.reader import Reader, read_by
from millcorr.report.simulation_view import stock_rings
from tests.core.paper_2023 import PROGRAM, SETUP, as_cut, nominal, program, setup


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    here = tmp_path_factory.mktemp("simulated")
    (here / "part.nc").write_text(PROGRAM)
    return here


@pytest.fixture(scope="module")
def report(directory):
    arguments = ["--program", str(directory / "part.nc"), "--setup", str(SETUP), "--side", "left"]
    assert main(["simulate", *arguments, "--report", str(directory / "report")]) == 0
    return directory / "report"


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_figures_of_the_paper(report):
    """45.57 and 79.05 degrees and a load ratio of 2.70 by the shape of the cut (paper: 45, 80, 2.67); 150 and 400 N."""
    figures = json.loads((report / "simulation.json").read_text(encoding="utf-8"))
    assert figures["rigid"]["arc_deg"]["median"] == pytest.approx(45.57, abs=0.005)
    assert figures["rigid"]["arc_deg"]["max"] == pytest.approx(79.05, abs=0.005)
    assert figures["rigid"]["load_ratio_max"] == pytest.approx(2.70, abs=0.005)
    assert figures["force_n"]["median"] == pytest.approx(150.0, rel=0.01)
    assert figures["force_n"]["max"] == pytest.approx(400.0, rel=0.03)
    assert figures["predicted_error_mm"]["max"] == pytest.approx(0.3, abs=0.005)
    assert figures["predicted_error_after_mm"] <= 0.09
    # 50, pi/2 times 5 and 55 mm at 400 mm/min.
    length = 105.0 + 2.5 * np.pi
    assert figures["path_length_mm"] == pytest.approx(length, abs=1e-9)
    assert figures["time_s"] == pytest.approx(length / (400 / 60), rel=1e-9)


def test_signals_are_the_simulation(report):
    table = rows(report / "signals.csv")
    assert tuple(table[0]) == COLUMNS
    signals = Signals.of(as_cut(), program())
    assert len(table) == len(signals)
    for name, values in (("fx_n", signals.force[:, 0]), ("dy_mm", signals.deflection[:, 1]), ("t_s", signals.t)):
        assert [float(row[name]) for row in table] == pytest.approx(values.tolist(), rel=1e-8, abs=1e-9)
    # Quasi-static: deflection is force over stiffness, and removal rate is area times teeth a second.
    assert signals.deflection == pytest.approx(signals.force / 1200.0, abs=2e-7)
    assert signals.mrr == pytest.approx(signals.area * 10.0 * 1500 / 60 * 6, rel=1e-9)
    lines = PROGRAM.splitlines()
    assert lines[int(table[0]["line"]) - 1] == "G1 X20"
    assert lines[int(table[-1]["line"]) - 1] == "G1 Y60"


def test_predicted_surface_is_written(report):
    table = rows(report / "predicted.csv")
    assert [float(row["deviation"]) for row in table] == pytest.approx(as_cut().deviation.value.tolist(), rel=1e-8)
    left = np.array([float(row["deviation_corrected"] or "nan") for row in table])
    assert np.nanmax(np.abs(left)) <= 0.09


def test_a_refused_correction_is_only_not_shown(directory, capsys):
    """0.3 mm of predicted error are more than a limit of 0.05: the program as it is, and why there is no other."""
    arguments = ["--program", str(directory / "part.nc"), "--setup", str(SETUP), "--side", "left", "--limit", "0.05"]
    assert main(["simulate", *arguments, "--report", str(directory / "limited")]) == 0
    told = capsys.readouterr().out
    assert "No corrected path is shown: " in told and "--limit" in told and "corrected at most" not in told
    figures = json.loads((directory / "limited" / "simulation.json").read_text(encoding="utf-8"))
    assert figures["predicted_error_after_mm"] is None
    assert figures["predicted_error_mm"]["max"] == pytest.approx(0.3, abs=0.005)
    assert {row["deviation_corrected"] for row in rows(directory / "limited" / "predicted.csv")} == {""}


def test_page_needs_nothing_but_itself(report):
    page = (report / "simulation.html").read_text(encoding="utf-8")
    assert "default-src 'none'" in page
    assert not re.search(r"(?:src|href)\s*=|@import|url\((?!#)|https?://(?!www\.w3\.org)", page)
    data = json.loads(re.search(r"<script type=application/json id=data>(.*?)</script>", page, re.S)[1])
    n = len(data["t"])
    assert n == len(data["actual"]) == len(data["line"]) == len(data["force"]) > 400
    assert all(len(v) == n for strip in data["strips"] for v in strip["values"])
    assert data["clockwise"] is True and data["radius"] == 10.0
    # Travelling along X with the wall on the right: the engaged arc lies between the wall and 45.57 degrees ahead.
    k = 20
    low, high = sorted((data["from"][k], data["to"][k]))
    assert low == pytest.approx(-np.pi / 2, abs=2e-3)
    assert np.degrees(high - low) == pytest.approx(44.85, abs=0.1)
    for name in ("load.svg", "axes.svg", "contour.svg"):
        assert (report / name).read_text(encoding="utf-8").startswith("<svg")


def test_the_page_in_inches(report, directory):
    """No millimetre is left on the page, what it draws is in its unit, and the figures of the files stay in mm."""
    arguments = ["--program", str(directory / "part.nc"), "--setup", str(SETUP), "--side", "left"]
    with read_by(Reader(INCH)):
        assert main(["simulate", *arguments, "--report", str(directory / "inches")]) == 0
    text, metric = ((d / "simulation.html").read_text(encoding="utf-8") for d in (directory / "inches", report))
    drawn = json.loads(re.search("<script type=application/json id=data>(.*?)</script>", text)[1])
    # What a setup says of itself stays as it is.
    own = r"<script.*?</script>|<section class=warnings>.*?</section>|<[^>]*>"
    shown = html.unescape(re.sub(own, " ", text, flags=re.DOTALL))
    assert {word.strip(",;:.") for word in re.findall(r"\S*(?:\bmm|\u00b5m\b|\bum\b)\S*", shown)} <= {
        "N/mm",
        "N/mm\u00b2",
    }
    assert drawn["unit"] == {"name": "in", "mm": 25.4}
    assert {strip["unit"] for strip in drawn["strips"]} == {"N", "\u00b0", "in/min", "thou"}
    figures = [json.loads((d / "simulation.json").read_text(encoding="utf-8")) for d in (directory / "inches", report)]
    assert figures[0]["predicted_error_mm"] == figures[1]["predicted_error_mm"]
    said = [
        float(re.search(rf"<b>([0-9.]+) {unit}</b>", page)[1]) for page, unit in ((text, "thou"), (metric, "\u00b5m"))
    ]
    assert said[0] * 25.4 == pytest.approx(said[1], abs=0.01)


def test_real_feed_is_shown():
    its = setup()
    its = replace(its, machine=replace(its.machine, acceleration_time_x_ms=150.0, acceleration_time_y_ms=150.0))
    found = simulate(program(), its, nominal())
    signals = Signals.of(found, program())
    assert (np.diff(signals.t) >= 0).all() and signals.t[0] > 0
    assert signals.feed[0] < 0.9 * signals.programmed[0]
    middle = len(signals) // 4
    assert signals.feed[middle] == pytest.approx(signals.programmed[middle], rel=1e-3)


def test_stock_of_a_picture():
    """Area of a disc of 20 with 2 on it: pi 22^2; of a hole with 2 in it: box less pi 18^2."""
    box = (-30.0, -30.0, 30.0, 30.0)
    for turn, wanted in ((2 * np.pi, np.pi * 22**2), (-2 * np.pi, 3600 - np.pi * 18**2)):
        ring = Profile.from_contours([Contour((NurbsCurve.arc((20, 0), (20, 0), (0, 0), turn),), True)])
        rings = stock_rings(StockRegion(ring, 2.0), box, 5.0)
        areas = sorted((shapely.Polygon(r).area for r in rings), reverse=True)
        assert areas[0] - sum(areas[1:]) == pytest.approx(wanted, rel=5e-3)


@pytest.mark.parametrize("end", ["with the part", "goes on"])
def test_picture_of_the_stock_is_that_of_the_model(end):
    """2000 places: stock in the picture where the model's signed distance is below the allowance, at the ends, too."""
    its = setup()
    its = replace(its, stock=replace(its.stock, end=end))
    bend = Profile.from_contours(
        [Contour((NurbsCurve.line((20, 0), (-10, 0)), NurbsCurve.line((-10, 0), (-10, -25))), False)]
    )
    stock = stock_of(its, bend)
    assert stock.profile is not None
    box = (-18.0, -40.0, 36.0, 8.0)
    polygons = [shapely.Polygon(r) for r in stock_rings(stock, box, 10.0)]
    place = np.random.default_rng(2).uniform(box[:2], box[2:], (2000, 2))
    # The picture has material 1.5 R deep behind the contour; nearer to an edge than 0.05 mm it may be drawn beside it.
    near = FootPointSearch(stock.profile, margin=60.0).find(place)
    away = np.where(near.place == Place.END, np.hypot(*(place - near.foot).T), near.distance)
    away = np.where(near.distance > 0, away, near.distance)
    sure = (np.abs(away - 3.0) > 0.05) & (np.abs(near.distance) > 0.05) & (near.distance > -14.0)
    drawn = np.any([shapely.contains_xy(p, *place.T) for p in polygons], axis=0)
    assert (away[sure] < 3.0).mean() > 0.2
    assert (drawn == (away < 3.0))[sure].all()
    # Beyond the end of the wall, outside: there is stock only where it goes on.
    outside = np.array([[26.0, 1.5]])
    assert any(shapely.contains_xy(p, *outside.T)[0] for p in polygons) == (end == "goes on")


def test_the_predicted_error_keeps_to_the_end_where_the_stock_goes_on():
    """On the straight that ends the paper's part: 0.09 mm to the last place, where it once fell to 10 um."""
    its = setup()
    falls = as_cut().deviation
    goes_on = simulate(program(), replace(its, stock=replace(its.stock, end="goes on")), nominal()).deviation
    straight = goes_on.foot[:, 1] > 30
    middle = float(np.median(goes_on.value[straight]))
    assert middle == pytest.approx(0.09, abs=0.002)
    assert goes_on.value[straight] == pytest.approx(middle, abs=1e-5)
    ends = falls.foot[:, 1] > 30
    assert falls.value[ends].min() < 0.02 and np.median(falls.value[ends]) == pytest.approx(middle, abs=1e-5)


@pytest.mark.parametrize(
    "old, new, key",
    [
        ("kx_n_per_mm = 1200.0", "kx_n_per_mm = 0.0", "kx_n_per_mm"),
        ("spindle_rpm = 1500.0", "spindle_rpm = 1500.0\noverhang_mm = 8.0", "overhang_mm"),
        ("allowance_mm = 3.0", "", "[stock]"),
        ("ktc_n_per_mm2 = 1180.0", "ktc_n_per_mm2 = 1.18", "ktc_n_per_mm2"),
        ("flutes = 6", "teeth = 6", "teeth"),
    ],
)
def test_bad_setup_ends_in_one_line(directory, capsys, old, new, key):
    text = SETUP.read_text(encoding="utf-8")
    assert old in text
    bad = directory / "bad.toml"
    bad.write_text(text.replace(old, new), encoding="utf-8")
    arguments = ["--program", str(directory / "part.nc"), "--setup", str(bad), "--side", "left"]
    assert main(["simulate", *arguments, "--report", str(directory / "none")]) == 3
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and key in said and "bad.toml" in said
    assert not (directory / "none").exists()


def test_correct_through_the_command_line(directory, capsys):
    part, out = directory / "part.nc", directory / "out.nc"
    common = ["correct", "--program", str(part), "--side", "left", "--output", str(out)]
    d = as_cut().deviation
    row = int(np.argmin(np.abs(d.foot[:, 0])))
    x, y = d.foot[row] + d.value[row] * d.normal[row]
    (directory / "touch.csv").write_text(f"x,y,z\n{x:.6f},{y:.6f},-5\n")
    measured = ["--measured", str(directory / "touch.csv"), "--points", "contact"]
    report = ["--report", str(directory / "combined")]
    assert main([*common, "--method", "combined", "--setup", str(SETUP), *measured, *report]) == 0
    said = capsys.readouterr().out
    assert "MSx 0.0310" in said
    summary = json.loads((directory / "combined" / "report.json").read_text(encoding="utf-8"))
    assert summary["foreseen"]["combined"]["msx"] == pytest.approx(0.09012 / 2.90988, rel=1e-3)
    assert summary["foreseen"]["predicted_after"][-1] <= 0.09
    assert main([*common, "--method", "predicted", "--setup", str(SETUP)]) == 0
    assert main([*common, "--method", "predicted", "--setup", str(SETUP), *measured]) == 2
    assert main([*common, "--method", "predicted"]) == 2
    assert main([*common, "--method", "mirror", *measured, "--setup", str(SETUP)]) == 2
    assert "--setup belongs to" in capsys.readouterr().err
