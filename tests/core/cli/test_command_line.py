# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line's contract: exit status, one line on stderr, everything written or nothing."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.__main__ import main
from millcorr.comparison.path_distance import PathDistance
from millcorr.nc.toolpath import Kind
from millcorr.readers import text
from tests.core import loop_programs as programs

REPOSITORY = Path(__file__).resolve().parents[3]
DONE, USAGE, INPUT, REFUSED = 0, 2, 3, 4


def wave(k, s):
    return 0.008 + 0.004 * np.sin(2 * np.pi * s / 60.0)


def snapshot(directory):
    return {p.relative_to(directory): p.read_bytes() if p.is_file() else None for p in directory.rglob("*")}


class Shop:
    """A directory with a program and a measured part, and the command line run in it."""

    def __init__(self, directory, monkeypatch, capsys):
        self.directory, self.capsys = directory, capsys
        monkeypatch.chdir(directory)
        self.program = directory / "part.nc"
        self.program.write_text(programs.RECTANGLE)
        self.nominal = pipeline.nominal_from_program(
            nc.read(self.program), programs.RADIUS, pipeline.Settings(side="right"), None
        )
        self.measure("cmm.csv", wave)

    def measure(self, name, deviation, change=lambda xyz: xyz):
        measurement = programs.measured(self.nominal, deviation)
        lines = ["x,y,z", *(f"{x:.7f},{y:.7f},{z:.3f}" for x, y, z in change(measurement.points.copy()))]
        (self.directory / name).write_text("\n".join(lines) + "\n")
        return name

    def run(self, line):
        status = None
        try:
            status = main(line.split())
        except SystemExit as ended:
            status = ended.code
        self.out, self.err = self.capsys.readouterr()
        return status

    def correct(self, extra="", measured="cmm.csv", points="--points contact", output="out.nc", program="part.nc"):
        return self.run(
            f"correct --program {program} --tool-diameter 10 --measured {measured} {points} --output {output} {extra}"
        )

    def fails(self, status, *says, **arguments):
        """The command ends with this status, says why in one line, and leaves the directory as it was."""
        before = snapshot(self.directory)
        assert self.correct(**arguments) == status, self.err
        assert snapshot(self.directory) == before
        assert self.out == ""
        lines = self.err.splitlines()
        assert len(lines) == 1, self.err
        assert lines[0].startswith("millcorr: ")
        for words in says:
            assert words in lines[0]


@pytest.fixture
def shop(tmp_path, monkeypatch, capsys):
    return Shop(tmp_path, monkeypatch, capsys)


# Done ------------------------------------------------------------------------------------------------


def test_correct_writes_program_and_report(shop):
    assert shop.correct("--report report") == DONE
    assert shop.err == ""
    assert (shop.directory / "out.nc").read_bytes() != shop.program.read_bytes()
    files = {p.name for p in (shop.directory / "report").iterdir()}
    assert files >= {"report.html", "report.json", "deviations.csv", "profile.json"}
    report = json.loads((shop.directory / "report" / "report.json").read_text())
    assert report["deviation"]["mean"] == pytest.approx(0.008, abs=1e-4)
    assert report["verification"]["path_error_max"] <= 0.001
    assert report["points"]["used"] + report["points"]["left_out"] == report["points"]["read"]


def test_exports_stand_in_the_report(shop):
    assert shop.correct("--report report --export dfq --export qif --export csv --zone 0.05") == DONE
    files = {p.name for p in (shop.directory / "report").iterdir()}
    assert files >= {"deviations.dfq", "deviations.qif", "deviations-comma.csv", "report.html"}
    for line, what in (("--export dfq", "--report DIR"), ("--report r2 --export qif", "--zone MM")):
        assert shop.correct(line) == USAGE
        assert what in shop.err and not (shop.directory / "r2").exists()


def test_report_has_the_keys_of_the_contract(shop):
    shop.run("check --program part.nc --tool-diameter 10 --measured cmm.csv --points contact --report r")
    report = json.loads((shop.directory / "r" / "report.json").read_text())
    five = {"mean", "min", "max", "height", "std"}
    assert report["unit"] == "mm"
    assert five <= report["deviation"].keys() and five <= report["filtered"].keys()
    assert {"max", "limited"} <= report["correction"].keys()
    assert {"shift", "rotation_deg"} <= report["alignment"].keys()
    assert {"degree", "poles", "weights", "knots", "multiplicities", "periodic"} <= report["profile"].keys()
    assert {"millcorr", "points", "verification", "warnings"} <= report.keys()
    header = (shop.directory / "r" / "deviations.csv").read_text().splitlines()[0]
    assert header.startswith("s,x,y,z,nx,ny,deviation,filtered,used")


def test_check_writes_the_report_and_nothing_else(shop):
    before = snapshot(shop.directory)
    line = "check --program part.nc --tool-diameter 10 --measured cmm.csv --points contact"
    assert shop.run(line) == DONE
    assert snapshot(shop.directory) == before
    assert shop.run(f"{line} --report r") == DONE
    new = snapshot(shop.directory).keys() - before.keys()
    assert {p.parts[0] for p in new} == {"r"}


def test_no_deviation_gives_the_program_back_byte_for_byte(shop):
    shop.measure("perfect.csv", lambda k, s: np.zeros(len(s)))
    assert shop.correct(measured="perfect.csv") == DONE
    assert (shop.directory / "out.nc").read_bytes() == shop.program.read_bytes()


def test_existing_output_is_replaced_as_a_whole(shop):
    out = shop.directory / "out.nc"
    out.write_text("G0 X0\n" * 100_000)
    out.chmod(0o640)
    handle = out.open("rb")
    assert shop.correct() == DONE
    assert out.stat().st_mode & 0o777 == 0o640
    assert b"MILLCORR" in out.read_bytes().upper()
    # Who had it open keeps the old file whole: a new one took its place.
    assert len(handle.read()) == 600_000
    handle.close()
    assert not [p for p in shop.directory.iterdir() if p.name.startswith(".")]


def test_contact_points_and_ball_centres_agree(shop):
    shop.measure("centres.csv", lambda k, s: wave(k, s) + 1.0)
    assert shop.correct() == DONE
    contact = nc.read(shop.directory / "out.nc").toolpath
    assert shop.correct(measured="centres.csv", points="--points centre --probe-radius 1", output="c.nc") == DONE
    centre = nc.read(shop.directory / "c.nc").toolpath
    assert len(contact) == len(centre)
    np.testing.assert_allclose(contact.end, centre.end, atol=0.0011)


def test_inch_points(shop):
    shop.measure("inch.csv", wave, lambda xyz: xyz / 25.4)
    assert shop.correct() == DONE
    assert shop.correct(extra="--units inch", measured="inch.csv", output="i.nc") == DONE
    mm, inch = (nc.read(shop.directory / f).toolpath for f in ("out.nc", "i.nc"))
    np.testing.assert_allclose(mm.end, inch.end, atol=0.0011)


def test_correct_again_with_the_first_program_as_nominal(shop):
    assert shop.correct() == DONE
    shop.measure("second.csv", lambda k, s: 0.05 * wave(k, s))
    assert shop.correct("--nominal part.nc", "second.csv", program="out.nc", output="twice.nc") == DONE
    assert (shop.directory / "twice.nc").read_bytes() != (shop.directory / "out.nc").read_bytes()


# Usage: 2 --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "line",
    [
        "",
        "mill",
        "correct",
        "correct --program part.nc --measured cmm.csv --points contact",
        "correct --measured cmm.csv --points contact --tool-diameter 10 --output out.nc",
        "correct --program part.nc --document a.FCStd --measured cmm.csv --points contact --output out.nc",
        "correct --program part.nc --tool-diameter wide --measured cmm.csv --points contact --output out.nc",
        "correct --program part.nc --tool-diameter 10 --measured cmm.csv --points contact --output out.nc --gai 1",
        "correct --program part.nc --tool-diameter 10 --measured cmm.csv --points middle --output out.nc",
    ],
)
def test_usage_of_the_options(shop, line):
    before = snapshot(shop.directory)
    assert shop.run(line) == USAGE
    assert snapshot(shop.directory) == before
    assert shop.out == "" and "Traceback" not in shop.err


def test_points_has_no_default(shop):
    shop.fails(USAGE, "--points contact", "--points centre", points="")


def test_ball_centres_need_their_radius(shop):
    shop.fails(USAGE, "--probe-radius", points="--points centre")


@pytest.mark.parametrize("radius", ["0", "-1", "nan", "inf"])
def test_ball_radius_is_a_length(shop, radius):
    shop.fails(USAGE, "--probe-radius", points=f"--points centre --probe-radius {radius}")


def test_program_needs_the_tool(shop):
    before = snapshot(shop.directory)
    line = "correct --program part.nc --measured cmm.csv --points contact --output out.nc"
    assert shop.run(line) == USAGE
    assert "--tool-diameter" in shop.err and len(shop.err.splitlines()) == 1
    assert snapshot(shop.directory) == before


@pytest.mark.parametrize("output", ["part.nc", "./part.nc", "../{name}/part.nc", "link.nc"])
def test_the_original_stays_untouched(shop, output):
    (shop.directory / "link.nc").symlink_to("part.nc")
    shop.fails(USAGE, "--output", output=output.format(name=shop.directory.name))


@pytest.mark.parametrize("output", ["cmm.csv", "first.nc"])
def test_no_input_is_overwritten(shop, output):
    (shop.directory / "first.nc").write_bytes(shop.program.read_bytes())
    shop.fails(USAGE, "--output", output=output, extra="--nominal first.nc")


@pytest.mark.parametrize(
    "extra",
    ["--filter mean:0", "--filter wavelet", "--gain 0", "--gain 3", "--gain nan", "--limit 0", "--limit nan",
     "--tolerance 0", "--tolerance nan", "--dead-band -1", "--dead-band nan", "--operation Profile", "--gcode a.nc",
     "--format nosuch"],
)  # fmt: skip
def test_settings_that_cannot_be(shop, extra):
    shop.fails(USAGE, extra=extra)


@pytest.mark.parametrize("diameter", ["0", "-10", "nan", "inf"])
def test_diameters_that_cannot_be(shop, diameter):
    shop.fails(USAGE, extra=f"--tool-diameter {diameter}")


def test_report_over_a_file(shop):
    (shop.directory / "report").write_text("mine")
    shop.fails(USAGE, "report", extra="--report report")


# Input that cannot be read or trusted: 3 ------------------------------------------------------------


def test_missing_files(shop):
    shop.fails(INPUT, "none.csv", measured="none.csv")
    shop.fails(INPUT, "none.nc", program="none.nc")
    shop.fails(INPUT, "none.step", extra="--nominal none.step")
    shop.fails(INPUT, ".", measured=".")
    shop.fails(INPUT, ".", program=".")


BAD = {
    "empty": (b"", None),
    "header only": (b"x,y,z\n", None),
    "not a number": (b"x,y,z\n1,2,3\n1,zwei,3\n", 3),
    "ragged": (b"x,y,z\n1,2,3\n1,2\n4,5,6\n", 3),
    "truncated": (b"x,y,z\n1.0,2.0,3.0\n4.0,5.0,6.0\n7.0,8", 4),
    "nan": (b"x,y,z\n1,2,3\nnan,2,3\n", 3),
    "starred": (b"x,y,z\n1,2,3\n****,2,3\n", 3),
    "binary": (bytes(range(256)) * 8, None),
    "zip": (b"PK\x03\x04" + bytes(100), None),
    "prose": (b"The part was fine when I last looked at it.\n", None),
}


@pytest.mark.parametrize("name", BAD)
def test_damaged_measured_file(shop, name):
    data, line = BAD[name]
    (shop.directory / "bad.csv").write_bytes(data)
    shop.fails(INPUT, "bad.csv" if line is None else f"bad.csv:{line}", measured="bad.csv")


PROGRAMS = {
    "empty": b"",
    "no cut": b"G0 X1 Y1\nM30\n",
    # Known to the control alone: what other programs have left in it.
    "macro": programs.RECTANGLE.replace("G1 X105", "G1 X#500").encode(),
    "binary": bytes(range(256)) * 8,
    "rotated": ("G68 X0 Y0 R10\n" + programs.RECTANGLE).encode(),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_that_are_refused(shop, name):
    (shop.directory / "bad.nc").write_bytes(PROGRAMS[name])
    shop.fails(INPUT, "bad.nc", program="bad.nc")


def test_inch_given_as_mm(shop):
    shop.measure("inch.csv", wave, lambda xyz: xyz / 25.4)
    shop.fails(INPUT, "inch.csv", "unit", measured="inch.csv")


def test_mm_given_as_inch(shop):
    shop.fails(INPUT, "cmm.csv", "unit", extra="--units inch")


def test_other_work_frame(shop):
    shop.measure("moved.csv", wave, lambda xyz: xyz + [300.0, 200.0, 0.0])
    shop.fails(INPUT, "moved.csv", measured="moved.csv")


def test_wrong_side(shop):
    # The points lie a tool diameter away from where this side puts the contour.
    shop.fails(INPUT, "cmm.csv", "wrong side of the path: --side", extra="--side left")


def test_ball_centres_given_as_contact_points(shop):
    shop.measure("centres.csv", lambda k, s: wave(k, s) + 0.5)
    shop.fails(INPUT, "centres.csv", "--points centre", measured="centres.csv")


def test_a_finding_is_accepted_by_name(shop):
    shop.measure("offset.csv", lambda k, s: wave(k, s) + 0.3)
    shop.fails(INPUT, "--accept", measured="offset.csv")
    shop.fails(USAGE, "--accept", measured="offset.csv", extra="--accept anything")
    assert shop.correct("--accept ball-not-compensated --accept constant-offset", "offset.csv") == DONE


def test_corrected_program_does_not_show_the_nominal(shop):
    assert shop.correct() == DONE
    shop.measure("second.csv", wave, lambda xyz: xyz + [0.0, 0.0, 0.001])
    shop.fails(INPUT, "out.nc", "--nominal", program="out.nc", measured="second.csv", output="again.nc")
    shop.fails(INPUT, "out.nc", "first", measured="second.csv", extra="--nominal out.nc", output="again.nc")


@pytest.mark.skipif(os.geteuid() == 0, reason="root writes everywhere")
def test_output_that_cannot_be_written(shop):
    (shop.directory / "locked").mkdir(mode=0o500)
    shop.fails(INPUT, "locked", output="locked/out.nc")


def test_output_in_place_of_a_directory(shop):
    (shop.directory / "folder").mkdir()
    before = snapshot(shop.directory)
    assert shop.correct(output="folder", extra="--report r") in (USAGE, INPUT)
    assert len(shop.err.splitlines()) == 1 and "folder" in shop.err
    assert snapshot(shop.directory) == before


# Refused: 4 -----------------------------------------------------------------------------------------


def test_more_than_the_limit(shop):
    shop.measure("far.csv", lambda k, s: 0.1 + 10 * wave(k, s))
    shop.fails(REFUSED, "limit", measured="far.csv", extra="--limit 0.1")
    shop.fails(REFUSED, "limit", extra="--limit 0.005")


def test_the_same_measurement_twice(shop):
    assert shop.correct() == DONE
    shop.fails(REFUSED, "out.nc", "already", program="out.nc", extra="--nominal part.nc", output="twice.nc")


def test_an_output_in_the_way_survives_a_refusal(shop):
    (shop.directory / "out.nc").write_text("the last good program")
    shop.fails(REFUSED, extra="--limit 0.005")
    assert (shop.directory / "out.nc").read_text() == "the last good program"


# The process ----------------------------------------------------------------------------------------


def process(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-m", "millcorr", *map(str, arguments)],
        cwd=REPOSITORY,
        env=dict(os.environ) | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def test_process_gives_status_and_one_line(shop, tmp_path):
    inputs = ["--program", shop.program, "--tool-diameter", 10, "--points", "contact"]
    done = process("correct", *inputs, "--measured", tmp_path / "cmm.csv", "--output", tmp_path / "out.nc")
    assert done.returncode == DONE and done.stderr == ""
    (tmp_path / "bad.csv").write_text("")
    failed = process("check", *inputs, "--measured", tmp_path / "bad.csv")
    assert failed.returncode == INPUT and len(failed.stderr.splitlines()) == 1 and failed.stdout == ""
    shown = process("check", *inputs, "--measured", tmp_path / "bad.csv", "--debug")
    assert shown.returncode == INPUT and "Traceback" in shown.stderr


def test_documents_without_freecad(tmp_path):
    (tmp_path / "job.FCStd").write_bytes(b"")
    (tmp_path / "cmm.csv").write_text("x,y\n1,2\n")
    done = process(
        "check", "--document", tmp_path / "job.FCStd", "--measured", tmp_path / "cmm.csv", "--points", "contact",
        FREECADCMD="/nonexistent", PATH="",
    )  # fmt: skip
    assert done.returncode in (USAGE, INPUT) and len(done.stderr.splitlines()) == 1
    assert "FREECADCMD" in done.stderr


def test_help_and_version():
    shown = process("correct", "--help")
    assert shown.returncode == DONE
    options = (
        "program document operation measured format points probe-radius units nominal tool-diameter side align filter "
        "method gain limit dead-band tolerance output-moves output gcode report"
    )
    for option in options.split():
        assert f"--{option}" in shown.stdout
    assert process("--version").stdout.startswith("millcorr ")


def test_reading_a_program_needs_no_plots():
    script = "import sys, millcorr.__main__; print([m for m in ('matplotlib', 'scipy', 'shapely') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", script], cwd=REPOSITORY, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_measurement_written_by_millcorr_is_read_by_it(shop):
    text.write(shop.directory / "own.csv", programs.measured(shop.nominal, wave), comments=("made by a test",))
    assert shop.correct(measured="own.csv") == DONE


def test_points_in_another_frame_are_laid_into_the_work_frame(shop):
    assert shop.correct() == DONE
    # Work x runs along the machine's y: (x, y) of the work frame lies at (100 - y, 200 + x) in the machine's.
    shop.measure("machine.csv", wave, lambda xyz: np.column_stack([100 - xyz[:, 1], 200 + xyz[:, 0], xyz[:, 2] + 7]))
    frame = "--work-offset 100 200 7 --work-rotation 90"
    assert shop.correct(frame, measured="machine.csv", output="turned.nc") == DONE
    assert moves_of(shop.directory / "turned.nc") == pytest.approx(moves_of(shop.directory / "out.nc"), abs=2e-4)
    assert shop.correct(measured="machine.csv", output="no.nc") == INPUT


def moves_of(path):
    return np.nan_to_num(nc.read(path).toolpath.end)


def test_series_from_first_part_to_history(shop):
    """Journal and control by the command line: corrected, kept byte for byte, the same part refused, the table."""
    control = "--journal --control ewma:2 --control-limit 0.006"
    assert shop.correct(f"--nominal part.nc {control}", output="p1.nc") == DONE
    assert (shop.directory / "part.nc.journal").exists()
    shop.measure("second.csv", lambda k, s: np.full(len(s), 0.004))
    again = dict(measured="second.csv", program="p1.nc", output="p2.nc")
    assert shop.correct(f"--nominal part.nc {control}", **again) == DONE
    assert "NOT CORRECTED" in shop.out
    assert (shop.directory / "p2.nc").read_bytes() == (shop.directory / "p1.nc").read_bytes()
    assert shop.correct(f"--nominal part.nc {control}", **again) == REFUSED
    assert "part 2" in shop.err
    assert shop.run("history") == DONE
    assert shop.out.count("corrected by its own deviation") == 1 and shop.out.count("NOT CORRECTED") == 1
    assert shop.run("history part.nc.journal --csv all.csv --report shown") == DONE
    assert len((shop.directory / "all.csv").read_text().splitlines()) == 3
    assert (shop.directory / "shown" / "history.html").exists()
    assert shop.run("history part.nc.journal --csv all.csv") == DONE
    (shop.directory / "other.journal").write_text("no journal at all" * 99)
    before = snapshot(shop.directory)
    for name, why in {
        "part.nc.journal": "is the journal itself",
        "other.journal": "is no table of a journal",
        "p1.nc": "is no table of a journal",
        "cmm.csv": "is no table of a journal",
        "shown": "is a directory",
        "none/all.csv": "there is no directory none",
    }.items():
        assert shop.run(f"history part.nc.journal --csv {name}") == USAGE and why in shop.err
    assert shop.run("history part.nc.journal --csv shown/history.csv --report shown") == USAGE
    assert "would replace the file of --csv" in shop.err and snapshot(shop.directory) == before
    assert shop.run("history") == USAGE
    assert "other.journal, part.nc.journal" in shop.err
    assert shop.run("history other.journal") == INPUT


@pytest.mark.parametrize("nominal", ["none.json", "#Part", "."])
def test_a_nominal_that_is_no_file_is_named(shop, nominal):
    shop.fails(INPUT, f"{nominal}: --nominal names a file that does not exist", extra=f"--nominal {nominal}")


def test_a_report_replaces_no_input(shop):
    assert shop.correct("--report rep") == DONE
    before = snapshot(shop.directory)
    deviations = shop.directory / "rep" / "deviations.csv"
    assert (
        shop.run(
            "check --program part.nc --tool-diameter 10 --measured rep/deviations.csv --points contact --report rep"
        )
        == USAGE
    )
    assert "would replace the measured file 1, deviations.csv" in shop.err and deviations.exists()
    assert snapshot(shop.directory) == before


def test_the_compensated_profile_is_no_nominal(shop):
    assert shop.correct("--report rep") == DONE
    assert shop.correct("--nominal rep/profile.json", output="other.nc") == INPUT
    assert "give the nominal.json beside it" in shop.err
    assert shop.correct("--nominal rep/nominal.json", output="other.nc") == DONE
    own, again = (nc.read(shop.directory / name).toolpath for name in ("out.nc", "other.nc"))
    path = PathDistance(again, np.flatnonzero(again.kind != Kind.RAPID))
    # Both are within 1 um of the same surface, and divided where each needs it.
    cut = own.take(own.kind != Kind.RAPID)
    assert path(cut.position(np.linspace(0.0, 1.0, 9))[:, :, :2].reshape(-1, 2)).max() < 2.1e-3


@pytest.mark.parametrize("option", ["--mapping map.toml", "--probe probe.toml"])
def test_what_explains_a_measurement_is_not_overwritten(shop, option):
    for name in ("map.toml", "probe.toml"):
        (shop.directory / name).write_text("radius = 3.0\n")
    before = snapshot(shop.directory)
    assert shop.correct(option, output=option.split()[1]) == USAGE
    assert "must stay untouched" in shop.err and snapshot(shop.directory) == before


def test_usage_errors_are_one_line(shop):
    for line in ("correct", "correct --align", "check --points contac", "nosuch", "split --program x", ""):
        assert shop.run(line) == USAGE
        assert len(shop.err.splitlines()) == 1 and shop.err.startswith("millcorr: "), shop.err


def test_radius_of_contact_points_is_a_contradiction(shop):
    assert shop.correct("--probe-radius 3") == USAGE
    assert "--probe-radius belongs to --points centre" in shop.err


def test_done_is_done_though_nobody_reads_it(shop):
    line = "correct --program part.nc --tool-diameter 10 --measured cmm.csv --points contact --output full.nc"
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "millcorr", *line.split()],
            cwd=shop.directory,
            env=os.environ | {"PYTHONPATH": str(REPOSITORY)},
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode == 0 and not done.stderr and (shop.directory / "full.nc").exists()


def test_document_needs_the_name_of_a_document(shop):
    line = "correct --document job.FCStd --measured cmm.csv --points contact --output out.nc"
    assert shop.run(line) == USAGE and "a corrected document is an .FCStd file" in shop.err
    assert shop.run(line.replace("out.nc", "none/out.FCStd")) == USAGE and "no directory none" in shop.err
    assert shop.run(line.replace("out.nc", "o.FCStd --tool-diameter 0")) == USAGE and "--tool-diameter 0" in shop.err
