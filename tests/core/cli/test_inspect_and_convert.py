# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs inspect and convert, and what a file says twice."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from millcorr import readers
from millcorr.__main__ import main
from millcorr.plausibility import examine_file, examine_points
from millcorr.readers.measurement import Measurement
from millcorr.virtual.simulated_machine import reference_contour

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


GRBL = """>>> $X
<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:1.000,1.000,0.000>
[PRB:11.000,6.000,-5.000:1]
[PRB:21.000,6.000,-5.000:1]
"""


@pytest.mark.parametrize(
    ("name", "content", "options", "unit", "points", "frame"),
    [
        ("a.csv", "x,y\n1,2\n3,4\n", "--points contact", "mm, assumed: the file does not say",
         "2, contact (said: --points)", "assumed: the work frame; the file does not say"),
        ("a.csv", "x [inch],y\n1,2\n3,4\n", "--points centre --probe-radius 1 --work-offset 1 2 3",
         "inch, stated; all lengths here in mm",
         "2, centres of a ball of radius 1 (centres said: --points; radius said: --probe-radius)",
         "said: --work-offset, --work-rotation"),
        ("a.csv", "x,y\n1,2\n3,4\n", "--units inch", "inch, said: --units; all lengths here in mm",
         "2, the file does not say of what", "assumed"),
        ("a.msr", MSR, "", "mm, assumed: the file does not say",
         "2, centres of a ball of radius 2 (centres stated; radius stated)", "stated: what G330 leads back to"),
        ("a.xyz", "XYZIJK\n1,2,3\n2,3,4\n", "--points contact", "inch, inferred: no METRIC in the first line",
         "2, contact", "assumed"),
        ("a.log", GRBL, "--probe-radius 1", "mm, inferred: three decimals, as GRBL prints mm",
         "2, centres of a ball of radius 1 (centres stated; radius said: --probe-radius)", "stated: the machine's"),
    ],
)  # fmt: skip
def test_inspect_says_how_it_knows(
    name: str, content: str, options: str, unit: str, points: str, frame: str,
    tmp_path: Path, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    file = tmp_path / name
    file.write_text(content)
    assert main(["inspect", str(file), *options.split()]) == 0
    said = dict(line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines())
    assert said["unit"].startswith(unit) and said["points"].startswith(points) and said["frame"].startswith(frame)


def test_a_mapping_says_what_the_file_does_not(tmp_path: Path) -> None:
    mapping, file = tmp_path / "m.toml", tmp_path / "a.csv"
    mapping.write_text('separator = "comma"\npoints = "centre"\nprobe_radius = 1.0\n[columns]\nx = 1\ny = 2\n')
    file.write_text("1,2\n3,4\n")
    m = readers.read(file, mapping=mapping)
    assert {key: basis.how for key, basis in m.bases.items()} == {
        "points": "said", "radius": "said", "unit": "assumed", "frame": "assumed",
    }  # fmt: skip
    assert "m.toml" in m.bases["points"].why


def test_four_decimals_of_a_grbl_log_are_asked_about(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.log"
    inches = GRBL.replace("11.000,6.000,-5.000", "0.4331,0.2362,-0.1969")
    file.write_text(inches.replace("21.000,6.000,-5.000", "0.8268,0.2362,-0.1969"))
    assert main(["inspect", str(file), "--probe-radius", "1"]) == 2
    assert "--units inch or --units mm" in capsys.readouterr().err
    m = readers.read(file, probe_radius=1.0, units="inch")
    assert m.points[1, 0] - m.points[0, 0] == pytest.approx((0.8268 - 0.4331) * 25.4)
    file.write_text("$13=1\n" + file.read_text())
    assert readers.read(file, probe_radius=1.0).bases["unit"].how == "stated"


@pytest.mark.parametrize(
    ("content", "options", "finding", "says"),
    [
        # An inch job's results: the radius of 0.0345 is that of a ball of 1.75 mm.
        (MSR.replace("R2", "R.0345"), {}, "implausible-radius", "0.0345 inch are 0.8763 mm"),
        (MSR.replace("R2", "R25"), {}, "implausible-radius", "--probe-radius takes a radius in mm"),
        ("x,y\n0.01,0.02\n0.03,0.04\n0.05,0.01\n", {"points": "contact"}, "implausible-extent", "metres or inches"),
        ("x,y\n1000,2\n90000,4\n5,5\n", {"points": "contact"}, "implausible-extent", "micrometres"),
    ],
)
def test_a_unit_that_makes_no_part_is_a_question(
    content: str, options: dict[str, str], finding: str, says: str, tmp_path: Path
) -> None:
    file = tmp_path / "a.txt"
    file.write_text(content)
    found = {f.name: f for f in examine_file(readers.read(file, **options))}
    assert found[finding].dangerous and says in found[finding].text
    if finding == "implausible-extent":
        # Who says the unit has been asked.
        assert finding not in {f.name for f in examine_file(readers.read(file, units="mm", **options))}
    else:
        file.write_text(content.replace("R25", "R.0345"))
        assert finding not in {f.name for f in examine_file(readers.read(file, units="inch", **options))}


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
