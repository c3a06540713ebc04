# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr simulate --slowed`, `--tilted` and `--trace`: programs with a remedy, and a machine by its log."""

from __future__ import annotations

import csv
import json
import re

import numpy as np
import pytest

from millcorr import nc
from millcorr.__main__ import main
from millcorr.process.kinematics import AxisDynamics, ContourControl, Control, corner_errors, motion
from tests.core.process.test_tilt import APART, HOLLOW
from tests.core.production.test_wall_in_simulation import CORNER, HEIGHTS, SETUP

FAST = CORNER.replace("F300", "F900").replace("G1 Z0", "G0 Z0")
LINEAR = "acceleration_time_x_ms = 50.0\nacceleration_time_y_ms = 50.0\n"
TILT = '\n[tilt]\norder = "AB"\ntool_centre_point = true\n'


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    here = tmp_path_factory.mktemp("remedies")
    plain = SETUP.read_text(encoding="utf-8")
    # At 900 mm/min the cut is stiffer than the paper's shank.
    stiff = plain.replace("1013.352126", "20000.0")
    inert = "[machine]\n" + LINEAR
    for name, text in (
        ("corner.nc", CORNER),
        ("fast.nc", FAST),
        ("apart.nc", APART),
        ("profile.json", json.dumps(HOLLOW.as_dict())),
        ("plain.toml", plain),
        ("stiff.toml", stiff),
        ("inert.toml", stiff.replace("[machine]\n", inert)),
        ("tilt.toml", plain + TILT),
        ("both.toml", plain.replace("[machine]\n", inert) + TILT),
    ):
        (here / name).write_text(text, encoding="utf-8")
    return here


def run(directory, program, setup, report, *words):
    arguments = ["--program", str(directory / program), "--nominal", str(directory / "profile.json"), "--side", "left"]
    places = [str(directory / word) if re.search(r"\.(nc|csv)$", word) else word for word in words]
    return main(
        ["simulate", *arguments, "--setup", str(directory / setup), "--report", str(directory / report), *places]
    )


def heights():
    return [word for height in HEIGHTS for word in ("--heights", height)]


def found(directory, report):
    return json.loads((directory / report / "simulation.json").read_text(encoding="utf-8"))


def test_slowed_corner(directory, capsys):
    """900 mm/min and ramps of 50 ms: off by sqrt 2 v T / 8 = 0.1326 mm, and by less than asked for in the new file."""
    assert run(directory, "fast.nc", "inert.toml", "slowed", "--slowed", "out.nc", "--corner-error", "0.02") == 0
    assert "1 corner from 132.6 \N{MICRO SIGN}m to" in capsys.readouterr().out
    slowed = found(directory, "slowed")["slowed"]
    [corner] = slowed["corners"]
    assert corner["before_mm"] == pytest.approx(np.sqrt(2) * 15.0 * 0.05 / 8, rel=1e-6)
    assert (corner["line"], corner["place_mm"]) == (4, [0.0, 0.0, 0.0])
    assert slowed["time_after_s"] > slowed["time_before_s"]
    written = nc.read(directory / "out.nc")
    again = corner_errors(written.toolpath, Control.alike(AxisDynamics(0.05)))
    # The two places where the feed changes are straight, so one corner is left.
    assert len(again) == 1 and again.error[0] == pytest.approx(corner["after_mm"], rel=1e-9)
    assert again.error[0] <= 0.02
    # Five points: two more than the three that the program has, and a comment.
    lines = written.text.splitlines()
    assert len(lines) == len(FAST.splitlines()) + 3 and "slowed at corners" in lines[0] + lines[1]
    # What the axes leave is in the predicted surface, and beside it.
    with open(directory / "slowed" / "predicted.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    left = np.array([float(row["kinematic"]) for row in rows])
    range_ = found(directory, "slowed")["kinematic_error_mm"]
    assert (left.min(), left.max()) == pytest.approx((range_["min"], range_["max"]), rel=1e-8)
    assert 0.005 < left.max() < corner["before_mm"]
    page = (directory / "slowed" / "simulation.html").read_text(encoding="utf-8")
    assert "Corners run slower" in page and "line 4, X0.000 Y0.000" in page


def test_corners_within_the_bound_stay(directory, capsys):
    assert run(directory, "fast.nc", "inert.toml", "kept", "--slowed", "same.nc", "--corner-error", "0.2") == 0
    assert "no corner is off by more than 200" in capsys.readouterr().out
    assert (directory / "same.nc").read_text() == FAST
    assert found(directory, "kept")["slowed"]["corners"] == []


def test_tilted_walls(directory, capsys):
    """25 um at 0.5 mm fall to less than 3, with the tip's path moved for a control that keeps the tip."""
    assert run(directory, "apart.nc", "tilt.toml", "tilted", *heights(), "--tilted", "tilted.nc") == 0
    assert "walls from 25.0 \N{MICRO SIGN}m to 2.2 \N{MICRO SIGN}m off at most" in capsys.readouterr().out
    tilted = found(directory, "tilted")["tilted"]
    text = (directory / "tilted.nc").read_text()
    words = re.findall(r"A(-?[\d.]+) B(-?[\d.]+)", text)
    assert len(words) == 4 and words[1] == words[3] == ("0", "0")
    lean = np.radians(-float(words[0][0]))
    for one in tilted["stretches"]:
        assert one["largest_before_mm"] == pytest.approx(0.025, abs=1e-4)
        assert one["largest_after_mm"] <= 0.003
        assert np.radians(one["tilt_deg"]) == pytest.approx(lean, abs=1e-5)
    # At 1.25 mm, the middle, the wall is to stand 11.0 um farther in; the lean about the tip moves it there by
    # z tan(lean) - R (1 / cos(lean) - 1) farther out. The first wall's normal is +Y, the second's -X.
    wall = found(directory, "tilted")["wall"]["stretches"]
    means = [np.mean(one["before_mm"]) for one in wall]
    moved = -means[0] - 1.25 * np.tan(lean) + 5.0 * (1 / np.cos(lean) - 1)
    path = nc.read(directory / "tilted.nc").toolpath
    plain = nc.parse(APART).toolpath
    assert path.end[2, 1] - plain.end[2, 1] == pytest.approx(moved, abs=2e-4)
    assert path.end[-2, 0] - plain.end[-2, 0] == pytest.approx(-moved, abs=2e-4)
    page = (directory / "tilted" / "simulation.html").read_text(encoding="utf-8")
    assert "Tilted tool" in page


def test_shifted_contour(directory, capsys):
    """Without an axis to tilt: 25 um at 0.5 mm fall by the mean over the heights, what leans stays."""
    assert run(directory, "corner.nc", "plain.toml", "shifted", *heights(), "--shifted", "shifted.nc") == 0
    assert "shifted     walls from 25.0 " in capsys.readouterr().out
    shifted = found(directory, "shifted")["shifted"]
    before = found(directory, "shifted")["wall"]["stretches"][0]["before_mm"]
    assert shifted["largest_before_mm"] == pytest.approx(0.025, abs=1e-4)
    # The closed loop gives a little back: a smaller cut bends less.
    assert shifted["largest_after_mm"] == pytest.approx(before[0] - np.mean(before), abs=2e-4)
    path, plain = (nc.parse(t).toolpath for t in ((directory / "shifted.nc").read_text(), CORNER))
    moved = path.end[-2, 1] - plain.end[-2, 1], path.start[3, 1] - plain.start[3, 1]
    assert moved == pytest.approx((0.0, -np.mean(before)), abs=2e-4)
    assert shifted["path_moved_mm"] == pytest.approx(np.mean(before), abs=2e-4)
    # Its path no longer shows what the part should be: whoever corrects it has to say.
    (directory / "points.csv").write_text("x,y,z\n-20,-5,1\n-10,-5,1\n-5,-5,1\n")
    arguments = ["--program", str(directory / "shifted.nc"), "--tool-diameter", "10", "--side", "left"]
    measured = ["--measured", str(directory / "points.csv"), "--points", "contact"]
    assert main(["correct", *arguments, *measured, "--output", str(directory / "next.nc")]) != 0
    assert "--nominal" in capsys.readouterr().err


@pytest.mark.thorough
def test_both_at_once_with_inertia(directory):
    """The corners of plunge and wall are slowed in one program, the walls are tilted on the real path in another."""
    words = ["--tilted", "t.nc", "--slowed", "s.nc", "--corner-error", "0.01"]
    assert run(directory, "apart.nc", "both.toml", "both", *heights(), *words) == 0
    assert (directory / "t.nc").exists() and (directory / "s.nc").exists()
    # At the slow starts and stops more is left than 3 um, as much as the remedy was said to leave.
    wall = found(directory, "both")["wall"]["stretches"]
    for one, said in zip(found(directory, "both")["tilted"]["stretches"], wall, strict=True):
        assert one["largest_after_mm"] <= said["largest_mm"]["tilted"] + 1e-4


@pytest.mark.few(4)
@pytest.mark.parametrize(
    "program, setup, words, status, message",
    [
        ("fast.nc", "inert.toml", ["--slowed", "new.nc"], 2, "--corner-error"),
        ("fast.nc", "inert.toml", ["--corner-error", "0.02"], 2, "--slowed"),
        ("fast.nc", "stiff.toml", ["--slowed", "new.nc", "--corner-error", "0.02"], 2, "acceleration_time_x_ms"),
        ("fast.nc", "inert.toml", ["--slowed", "new.nc", "--corner-error", "0"], 2, "corner bound 0"),
        ("fast.nc", "inert.toml", ["--slowed", "new.nc", "--corner-error", "1e-6"], 4, "fast.nc:4"),
        ("fast.nc", "inert.toml", ["--slowed", "fast.nc", "--corner-error", "0.02"], 2, "the original must stay"),
        ("apart.nc", "tilt.toml", ["--tilted", "new.nc"], 2, "--heights"),
        ("corner.nc", "plain.toml", ["--shifted", "new.nc"], 2, "--heights"),
        ("apart.nc", "plain.toml", [*heights(), "--tilted", "new.nc"], 4, "no [tilt] table"),
        ("corner.nc", "tilt.toml", [*heights(), "--tilted", "new.nc"], 4, "line 5: the tool has to turn"),
        ("apart.nc", "tilt.toml", ["--identify", "position_gain_per_s"], 2, "--trace"),
        ("apart.nc", "tilt.toml", ["--trace", "none.csv"], 3, "none.csv"),
    ],
)
def test_what_is_refused_writes_nothing(directory, capsys, program, setup, words, status, message):
    assert run(directory, program, setup, "refused", *words) == status
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and message in said
    assert not (directory / "refused").exists() and not (directory / "new.nc").exists()
    assert (directory / "fast.nc").read_text() == FAST


def log(directory, name, text, columns, noise, contour=None, seed=3):
    """A log of the corner, cut by ramps of 50 and 60 ms and a gain of 40/s, begun at 7 s, in steps of 2 ms."""
    control = Control(AxisDynamics(0.05, kv=40.0), AxisDynamics(0.06, kv=40.0), AxisDynamics(0.06, kv=40.0), contour)
    m = motion(nc.parse(text).toolpath, control, step=0.002)
    rng = np.random.default_rng(seed)
    values = np.column_stack([m.x, m.y]) if columns == "t,x,y" else 60.0 * m.feed[:, None]
    rows = np.column_stack([m.t + 7.0, values + noise * rng.standard_normal(values.shape)])
    np.savetxt(directory / name, rows, fmt="%.6f", delimiter=",", header=columns, comments="")


@pytest.mark.thorough
def test_machine_by_its_log(directory, capsys):
    """Constants that made a log with 1 um of noise, each within four of its standard uncertainties (1 in 16000)."""
    log(directory, "log.csv", FAST, "t,x,y", 0.001)
    assert run(directory, "fast.nc", "stiff.toml", "log", "--trace", "log.csv") == 0
    said = capsys.readouterr().out
    known = found(directory, "log")["identified"]
    assert known["residual_unit"] == "mm" and known["residual"] == pytest.approx(0.001, rel=0.1)
    for key, value in (
        ("acceleration_time_x_ms", 50.0),
        ("acceleration_time_y_ms", 60.0),
        ("position_gain_per_s", 40.0),
    ):
        one = known["machine"][key]
        assert abs(one["value"] - value) < 4 * one["uncertainty"] < 0.2 * value
        assert re.search(rf"{key} = [\d.]+  # \+- [\d.]+", said)
    # The simulation runs with them: in the corner both axes are under way.
    assert found(directory, "log")["feed_mm_min"]["min"] < 0.8 * 900.0
    assert "Machine by its log" in (directory / "log" / "simulation.html").read_text(encoding="utf-8")


@pytest.mark.thorough
def test_what_the_setup_states_is_known(directory, capsys):
    log(directory, "feed.csv", FAST, "t,feed", 1.0)
    text = (directory / "inert.toml").read_text(encoding="utf-8")
    (directory / "gain.toml").write_text(text.replace("y_ms = 50.0", "y_ms = 60.0"), encoding="utf-8")
    assert run(directory, "fast.nc", "gain.toml", "gain", "--trace", "log.csv") == 0
    assert list(found(directory, "gain")["identified"]["machine"]) == ["position_gain_per_s"]
    wanted = ["--identify", "acceleration_time_x_ms", "--identify", "position_gain_per_s"]
    assert run(directory, "fast.nc", "gain.toml", "feed", "--trace", "feed.csv", *wanted) == 0
    assert found(directory, "feed")["identified"]["residual_unit"] == "mm/s"
    capsys.readouterr()
    # The walls apart are another program.
    log(directory, "other.csv", "G90 G17 G21 F900\nG0 X0 Y0\nG1 Y-30\nG1 X-30\n", "t,x,y", 0.001)
    assert run(directory, "fast.nc", "stiff.toml", "refused", "--trace", "other.csv") == 4
    assert "not one of this program" in capsys.readouterr().err
    assert not (directory / "refused").exists()


@pytest.mark.thorough
def test_speed_change_at_corners_by_a_log(directory):
    """2 mm/s are allowed, the setup begins at 200 mm/min: found within four standard uncertainties of 120."""
    log(directory, "contour.csv", FAST, "t,x,y", 0.001, ContourControl(speed_change=2.0))
    known = "position_gain_per_s = 40.0\ncontour_control = true\ncontour_speed_change_mm_min = 200.0\n"
    text = (directory / "inert.toml").read_text(encoding="utf-8").replace("y_ms = 50.0\n", f"y_ms = 60.0\n{known}")
    (directory / "contour.toml").write_text(text, encoding="utf-8")
    wanted = ["--trace", "contour.csv", "--identify", "contour_speed_change_mm_min"]
    assert run(directory, "fast.nc", "contour.toml", "contour", *wanted) == 0
    one = found(directory, "contour")["identified"]["machine"]["contour_speed_change_mm_min"]
    assert abs(one["value"] - 120.0) < 4 * one["uncertainty"] < 12.0
