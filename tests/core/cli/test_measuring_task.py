# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr probe`: options, files, refusals. What the programs do is tested in test_measuring_programs."""

from __future__ import annotations

import json

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.__main__ import main
from millcorr.correction.settings import Settings
from millcorr.probing import controls as measuring_programs
from tests.core import loop_programs as programs


@pytest.fixture
def shop(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text(programs.ROUNDED)
    return tmp_path


def run(line):
    try:
        return main(line.split())
    except SystemExit as ended:
        return ended.code


PROBE = "probe --program part.nc --tool-diameter 10 --side right --probe-radius 2 --output probe.nc"


@pytest.mark.parametrize("dialect", measuring_programs.DIALECTS)
def test_every_dialect_is_written(shop, capsys, dialect):
    assert run(f"{PROBE} --dialect {dialect} --points-count 15") == 0
    said = capsys.readouterr().out
    assert "15 touches" in said and "program     probe.nc" in said and "--measured" in said
    text = (shop / "probe.nc").read_text(encoding="ascii")
    assert text.upper().count("POINT ") >= 15 and "part.nc" in text.lower()
    listed = {line.split()[-1] for line in said.splitlines() if line.startswith("with it")}
    assert {p.name for p in shop.iterdir()} == {"part.nc", "probe.nc", *listed}


def test_heights_come_from_the_program_or_the_user(shop):
    assert run(f"{PROBE} --dialect linuxcnc") == 0
    touching = nc.parse((shop / "probe.nc").read_bytes()).toolpath.end[:, 2]
    assert np.nanmin(touching) == -2.5 and np.nanmax(touching) == 20.0
    assert run(f"{PROBE} --dialect linuxcnc --z -4 --safe-z 33") == 0
    touching = nc.parse((shop / "probe.nc").read_bytes()).toolpath.end[:, 2]
    assert np.nanmin(touching) == -4.0 and np.nanmax(touching) == 33.0


def test_profile_alone_is_enough_with_heights(shop):
    nominal = pipeline.nominal_from_program(nc.read(shop / "part.nc"), 5.0, Settings(side="right"), None)
    (shop / "profile.json").write_text(json.dumps(nominal.as_dict()))
    line = "probe --nominal profile.json --probe-radius 2 --dialect grbl --output probe.nc"
    assert run(line) == 2
    assert run(f"{line} --z -2 --safe-z 30 --spacing 10 --curvature --touch normal") == 0


@pytest.mark.parametrize(
    ("line", "status", "says"),
    [
        (PROBE.replace(" --side right", "") + " --dialect haas", 2, "--side left or --side right"),
        (PROBE.replace(" --tool-diameter 10", "") + " --dialect haas", 2, "--tool-diameter"),
        (PROBE.replace("--output probe.nc", "--output part.nc") + " --dialect haas", 2, "must stay untouched"),
        (PROBE + " --dialect mazak", 2, "--dialect is one of linuxcnc"),
        (PROBE + " --dialect haas --points-count 0", 2, "--points-count 0"),
        (PROBE + " --dialect haas --spacing -1", 2, "--spacing -1"),
        (PROBE + " --dialect haas --spacing 5 --points-count 9", 2, "not allowed with"),
        (PROBE + " --dialect haas --z -5", 2, "--z -5 lies below Z-4.500, a margin"),
        (PROBE + " --dialect haas --safe-z 4", 2, "--safe-z 4 lies below Z5"),
        (PROBE + " --dialect haas --operation P", 2, "--operation belongs to --document"),
        (PROBE.replace("radius 2", "radius 0") + " --dialect haas", 2, "--probe-radius 0"),
        ("probe --probe-radius 2 --dialect haas --output probe.nc", 2, "say what to measure"),
        ("probe --nominal part.nc --probe-radius 2 --dialect haas --output probe.nc", 2, "give a program as --program"),
        (PROBE.replace("part.nc", "none.nc") + " --dialect haas", 3, "none.nc"),
    ],
)
def test_what_cannot_be_measured_is_refused_in_one_line(shop, capsys, line, status, says):
    assert run(line) == status
    err = capsys.readouterr().err
    assert says in err
    assert {p.name for p in shop.iterdir()} == {"part.nc"}


def with_masks(name, radius=2):
    return run(
        f"probe --program part.nc --tool-diameter 10 --side right --probe-radius {radius} --dialect heidenhain "
        f"--output {name} --points-count 9"
    )


def test_programs_side_by_side_keep_their_own_masks(shop):
    """The radius stands in the mask: a second program with another ball leaves the first one's as it is."""
    assert with_masks("left.h", 2) == 0 and with_masks("right-side.h", 3) == 0
    assert {p.name for p in shop.iterdir()} == {
        "part.nc", "left.h", "LEFT.A", "LEFT_END.A", "right-side.h", "RIGHT_SIDE.A", "RIGHT_SIDE_END.A",
    }  # fmt: skip
    assert 'R2."' in (shop / "LEFT.A").read_text() and 'R3."' in (shop / "RIGHT_SIDE.A").read_text()
    text = (shop / "right-side.h").read_text()
    assert "BEGIN PGM RIGHT_SIDE MM" in text and r"F-PRINT TNC:\RIGHT_SIDE.A / TNC:\RIGHT_SIDE.TXT" in text
    # The same program once more, with another ball: it and its masks are replaced together.
    assert with_masks("left.h", 2.5) == 0
    assert 'R2.5"' in (shop / "LEFT.A").read_text()


@pytest.mark.parametrize(
    ("before", "output", "says"),
    [
        ({"PROBE.A": "mine\n"}, "probe.h", "belongs to another program"),
        ({"PROBE.A": "mine\n", "probe.h": "BEGIN PGM X MM\nPROBE.A\n"}, "probe.h", "belongs to another program"),
        ({}, "PROBE.A", "is the output itself"),
    ],
)
def test_files_beside_the_program_replace_nothing_else(shop, capsys, before, output, says):
    for name, text in before.items():
        (shop / name).write_text(text)
    assert with_masks(output) == 2
    err = capsys.readouterr().err
    assert says in err and "choose another name for --output" in err
    assert {p.name: p.read_text() for p in shop.iterdir()} == {"part.nc": programs.ROUNDED, **before}


def test_masks_of_a_program_with_a_like_name_are_not_taken(shop, capsys):
    assert with_masks("a-b.h", 2) == 0 and with_masks("a_b.h", 2) == 0
    assert with_masks("a+b.h", 3) == 2
    assert "A_B.A" in capsys.readouterr().err and 'R2."' in (shop / "A_B.A").read_text()


def test_a_mask_does_not_replace_an_input(shop, capsys):
    (shop / "PROBE.A").write_text(programs.ROUNDED)
    line = PROBE.replace("part.nc", "PROBE.A").replace("probe.nc", "probe.h")
    assert run(f"{line} --dialect heidenhain") == 2
    assert "is the program itself" in capsys.readouterr().err
    assert (shop / "PROBE.A").read_text() == programs.ROUNDED
