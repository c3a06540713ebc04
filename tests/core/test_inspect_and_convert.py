# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs inspect and convert, and what a file says twice."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from millcorr import readers
from millcorr.__main__ import main
from millcorr.distrust import examine_file, examine_points
from millcorr.measurement import Measurement
from millcorr.simulated_machine import reference_contour

MSR = """START
G800 N1 X10 Y20 Z-5 I1 J0 K0 O0 U0.01 L-0.01
G801 N1 X12.012 Y20 Z-5 R2
G800 N2 X10 Y30 Z-5 I1 J0 K0 O0 U0.01 L-0.01
G801 N2 X11.997 Y30 Z-5 R2
END
"""


def test_inspect_says_what_is_in_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "probe.msr"
    file.write_text(MSR)
    assert main(["inspect", str(file)]) == 0
    said = capsys.readouterr().out
    assert "format      msr" in said
    assert "points      2, centres of a ball of radius 2" in said
    assert "deviations  -0.0030 to +0.0120, mean +0.0045" in said


def test_inspect_of_text_names_what_is_missing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "cmm.csv"
    file.write_text("x,y\n1,2\n3,4\n")
    assert main(["inspect", str(file)]) == 0
    said = capsys.readouterr().out
    assert "points      2, the file does not say of what: correcting needs --points contact, centre or axis" in said
    assert "no Z" in said


def test_convert_writes_text_that_reads_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, points = tmp_path / "probe.msr", tmp_path / "points.csv"
    file.write_text(MSR)
    assert main(["convert", str(file), "-o", str(points)]) == 0
    assert "--points centre --probe-radius 2" in capsys.readouterr().out
    again = readers.read(points, points="centre", probe_radius=2.0)
    assert again.points == pytest.approx(readers.read(file).points)
    assert again.normals == pytest.approx(np.array([[1.0, 0, 0], [1, 0, 0]]))


@pytest.mark.parametrize("verb", ["inspect", "convert"])
def test_a_damaged_file_ends_in_one_line(verb: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, points = tmp_path / "probe.msr", tmp_path / "points.csv"
    file.write_text(MSR.replace("G801 N1", "G801 N7"))
    assert main([verb, str(file), *(["-o", str(points)] if verb == "convert" else [])]) == 3
    captured = capsys.readouterr()
    assert captured.err.count("\n") == 1 and "probe.msr:" in captured.err and not captured.out
    assert not points.exists()


def test_convert_does_not_overwrite_its_source(tmp_path: Path) -> None:
    file = tmp_path / "cmm.csv"
    file.write_text("x,y\n1,2\n3,4\n")
    assert main(["convert", str(file), "--points", "contact", "-o", str(file)]) == 2
    assert file.read_text() == "x,y\n1,2\n3,4\n"


def test_what_a_file_says_twice_must_agree() -> None:
    nominal = reference_contour()
    c, n = nominal.at(0, np.linspace(0, 200, 50))
    flat, normals = np.column_stack([c, np.zeros(50)]), np.column_stack([n, np.zeros(50)])
    parts = (flat + 0.01 * normals, normals, 0.0, np.arange(1, 51), "cmm.txt", "ab" * 32)
    honest = Measurement(*parts, nominal=flat, stated=np.full(50, 0.01))
    assert examine_points(honest, nominal, 5.0) == ()
    shifted = Measurement(*parts, nominal=flat + [0.0, 0.4, 0.0])
    assert [f.name for f in examine_points(shifted, nominal, 5.0)] == ["other-nominal"]
    wrong = Measurement(*parts, nominal=flat, stated=np.where(np.arange(50) == 7, 0.02, 0.01))
    (finding,) = examine_file(wrong)
    assert finding.name == "stated-deviations" and "cmm.txt:8 states a deviation of +0.0200" in finding.text
