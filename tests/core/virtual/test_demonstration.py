# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration: the published table, what it judges, and the whole of it where FreeCAD is installed."""

from __future__ import annotations

import ast
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from millcorr import freecad_process, nc
from millcorr.errors import UsageError
from millcorr.virtual import demonstration
from millcorr.virtual.simulated_machine import REFERENCE_POLES, SimulatedMachine, reference_contour

REPOSITORY = Path(__file__).resolve().parents[3]
GOOD = {"mean": 0.0018, "min": 0.0, "max": 0.005, "height": 0.005, "std": 0.0008}


def constants(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {
        node.targets[0].id: ast.literal_eval(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant | ast.Tuple)
    }


def test_freecad_makes_the_contour_that_the_machine_knows():
    made = constants(REPOSITORY / "millcorr" / "app" / "demonstration.py")
    assert made["CONTROL_VERTICES"] == REFERENCE_POLES
    assert len(REFERENCE_POLES) == 15
    assert made["TOOL_DIAMETER"] == demonstration.TOOL_DIAMETER


def test_published_table_is_consistent():
    for column in demonstration.PUBLISHED.values():
        # Printed to 0.1 or 1 um.
        assert column["max"] - column["min"] == pytest.approx(column["height"], abs=0.0006)
        assert column["min"] < column["mean"] < column["max"]


def test_what_is_judged():
    assert demonstration.missing(GOOD) == []
    assert demonstration.missing(GOOD | {"mean": -0.0018}) == []
    for name, bad in (("mean", 0.0029), ("mean", -0.0029), ("height", 0.0061), ("std", 0.00091), ("std", float("nan"))):
        (line,) = demonstration.missing(GOOD | {name: bad})
        assert line.startswith(name)


def test_table_shows_what_there_is():
    rows = [demonstration.Row("one", None, GOOD, None), demonstration.Row("second row", GOOD, GOOD, GOOD)]
    lines = demonstration.table(rows).splitlines()
    assert lines[1].split() == 3 * ["mean", "min", "max", "height", "std"]
    assert lines[2].split() == ["one", "1.8", "0.0", "5.0", "5.0", "0.80"]
    assert lines[3].split()[2:] == 3 * ["1.8", "0.0", "5.0", "5.0", "0.80"]
    # Columns stand below each other.
    assert lines[2].index("0.80") == lines[3].index("0.80", lines[3].index("0.80") + 1)


def test_the_reference_machine_splits_randomness_so_that_the_paper_can_be_reached():
    """White noise of equal size in both measurements could not give the paper's 0.9 / 1.8."""
    machine = SimulatedMachine.reference()
    r, m = machine.process_noise, machine.measurement_noise
    raw, filtered = np.hypot(r, np.hypot(r, m)), np.hypot(r, np.sqrt(0.2) * np.hypot(r, m))
    assert filtered < 0.0009 < raw
    assert np.hypot(raw, m) == pytest.approx(demonstration.PUBLISHED["none"]["std"], abs=0.0001)
    nominal = reference_contour()
    part = machine.follow(nominal, seed=3)
    seen = demonstration.of_points(part.measure(demonstration.POINTS, seed=3), nominal)
    assert seen.mean() == pytest.approx(demonstration.PUBLISHED["before"]["mean"], abs=0.0002)
    assert seen.std() == pytest.approx(demonstration.PUBLISHED["before"]["std"], abs=0.0003)


def test_without_freecad_it_says_so(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("FREECADCMD", "/nonexistent/freecadcmd")
    assert demonstration.main([str(tmp_path)]) == 1
    assert "FREECADCMD" in capsys.readouterr().err


def has_freecad():
    try:
        return bool(freecad_process.command())
    except UsageError:
        return False


@pytest.mark.thorough
@pytest.mark.skipif(not has_freecad(), reason="FreeCAD is not installed")
def test_the_whole_demonstration(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(demonstration, "PARTS", 2)
    monkeypatch.chdir(tmp_path)
    assert demonstration.main(["demo"]) == 0
    shown = capsys.readouterr().out
    assert "SIMULATED" in shown and "published" in shown and "Reached" in shown
    for name in ("corrected-mean-5.FCStd", "corrected-mean-5.nc", "report-mean-5/report.html", "loop.png"):
        file = Path("demo") / name
        assert str(file) in shown and file.stat().st_size > 1000
    before = nc.read(Path("demo/demo.nc")).toolpath
    after = nc.read(Path("demo/corrected-auto.nc")).toolpath
    assert len(after) >= len(before)
    # A second time over the first, and a machine that is too bad to be corrected.
    monkeypatch.setattr(demonstration, "FILTERS", {"mean:5": "after, mean of 5", "auto": "after, auto"})
    bad = SimulatedMachine(process_noise=0.003)
    monkeypatch.setattr(SimulatedMachine, "reference", staticmethod(lambda: bad))
    assert demonstration.main(["demo"]) == 1
    assert "NOT reached" in capsys.readouterr().err
    assert os.path.isfile("demo/corrected-mean-5.FCStd") and shutil.which(freecad_process.command())
