# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' modal rounding, feeds of corners and polar positions, as the programming manuals describe them.

SINUMERIK 840D/840Di/810D, Fundamentals, 10.2004, 6FC5 298-7AB00-0BP1; 840D sl, 11/2006, 6FC5398-1BP10-2BA0; SINUMERIK
ONE, 12/2019, 6FC5398-2EP40-0BA0. The numbers are other ones than theirs.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from millcorr import nc
from millcorr.errors import LimitError
from millcorr.nc.toolpath import Kind
from millcorr.path.second_reader import moves_of
from millcorr.path.text_proof import prove_text
from tests.core.nc.test_controls import same_moves
from tests.core.nc.test_gcode_write import moved
from tests.core.path.test_second_reader import check
from tests.core.stages.test_shop_programs import corrected, rectangle

HEAD = "G17 G90 G71\nG0 X0 Y0 Z0\n"


def alike(text: str, explicit: str) -> nc.Program:
    """A program whose moves are those of another one, for both readers."""
    program = nc.parse(text)
    assert not program.opaque
    same_moves(program.toolpath, nc.parse(explicit).toolpath)
    check(text.encode(), moves_of(text.encode()))
    assert nc.write(program, program.toolpath.with_moves()) == text.encode()
    return program


# -- RNDM= ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("modal", "corners"),
    [
        # From the block that states it, on its own line too, to the last one before RNDM=0.
        ("X40 RNDM=2|Y20|X20|Y40 RNDM=0|X0", "X40 RND=2|Y20 RND=2|X20 RND=2|Y40|X0"),
        ("RNDM=2|X40|Y20|RNDM=0|X20", "X40 RND=2|Y20 RND=2|X20"),
        ("X40 RNDM=2|Y20 RNDM=3|X20|Y40 RNDM=0", "X40 RND=2|Y20 RND=3|X20 RND=3|Y40"),
        # A corner with a word of its own is made as that says.
        ("X40 RNDM=2|Y20 RND=5|X20 CHR=1|Y40 RNDM=0", "X40 RND=2|Y20 RND=5|X20 CHR=1|Y40"),
        # No corner of the plane: before and behind a plunge, where the contour goes on straight.
        ("X40 RNDM=2|Z-1|Y20|Y30|X20|Z0|G0 Z9|X9 RNDM=0", "X40|Z-1|Y20|Y30 RND=2|X20|Z0|G0 Z9|X9"),
        # Between lines and arcs.
        ("X40 RNDM=2|G3 X40 Y20 CR=10|G1 X20|RNDM=0", "X40 RND=2|G3 X40 Y20 CR=10 RND=2|G1 X20"),
        ("R1=1|X40 RNDM=R1*2|Y20 RNDM=0", "X40 RND=2|Y20"),
    ],
)
def test_every_corner_is_rounded(modal: str, corners: str) -> None:
    alike(*(HEAD + "G1 F100\n" + text.replace("|", "\n") + "\nM30\n" for text in (modal, corners)))


def test_rounded_corners_are_written_out_and_no_more_rounded() -> None:
    text = HEAD + "G1 X40 RNDM=2 F100\nY20\nX20 ; END\nN9 RNDM=0\nX0 Y40\nM30\n"
    out = moved(text, [1, 2, 3])
    assert out == HEAD + (
        "G1 X38.03 RNDM=0 F100\nG3 X40.03 Y2 I0 J2\nG1 Y18\nG3 X38 Y20 I-2.0299 J-0.0001\n"
        "G1 X20.8284 ; END\nG2 X19.4142 Y20.5858 I0 J2\nN9 RNDM=0\nG1 X0 Y40\nM30\n"
    )


def test_a_contour_in_a_subprogram_is_corrected_under_the_rounding_of_its_caller() -> None:
    text = (
        "%_N_PART_MPF\nG21 G90 G17 G40\nG0 X-20 Y20\nZ0\nRNDM=4\nL2 P2\nRNDM=0\nG0 Z50\nM30\n%_N_L2_SPF\n"
        "G91 G1 Z-2 F200\nG90 X-15 Y20\nX-5\nY45\nX65\nY-5\nX-5\nY10\nX-20 Y20\nM17\n"
    )
    # The side where the lead meets the contour is rounded there, too.
    points = rectangle(0.0, 0.0, 60.0, 40.0)
    points = points[points[:, 0] > 1] + [0.03, 0.0]
    program, lines = corrected(text, points)
    assert lines.count("RNDM=0") == 2 and not any("RNDM=4" in line for line in lines)
    path = program.toolpath
    bends = (path.kind == Kind.ARC) & (path.end[:, 0] > 50)
    radius = np.hypot(*(path.start[bends] - path.centre[bends])[:, :2].T)
    # Two corners at two depths.
    assert (abs(radius - 4) < 0.3).sum() >= 4
    assert abs(path.end[:, 0] - 64.97).min() < 0.002


def test_what_the_manual_leaves_open_is_not_corrected() -> None:
    """A radius that a side is too short for would be made smaller, by how much is not said."""
    for line in (
        "X40 RNDM=30|Y20",
        "X40 RND=2 CHR=2|Y20",
        "X40 RNDM=R9|Y20",
        "G0 X9 RNDM=1|Y2",
    ):
        program = nc.parse(HEAD + "G1 F100\n" + line.replace("|", "\n") + "\nX-50\nM30\n")
        assert program.opaque_moves()[1:3].all(), line


# -- FRC=, FRCM= ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("slowed", "feeds"),
    [
        # Modal, from a line of its own too, to FRCM=0; once, beside that; F holds again behind the corner.
        ("FRCM=50|X40 RND=2|Y20 CHR=1|X20|Y40|FRCM=0|X0", [100, 50, 100, 50, 100, 100, 100]),
        ("X40 RNDM=2 FRCM=50|Y20|X20 Y30 RNDM=0 FRCM=0|X0", None),
        ("X40 RND=2 FRC=50|Y20 RND=3 FRC=50|X20 FRC=50|Y40", [100, 50, 100, 50, 100, 100]),
        ("FRCM=30|X40 RND=2 FRC=50|Y20 FRC=50|X0", [100, 50, 100, 100]),
        ("R5=50|X40 RND=2 FRC=R5|Y20 FRC=R5|X0", [100, 50, 100, 100]),
        ("F=R9|R9=7|F100 X40 RND=2|Y20", [100, 100, 100]),
        ("G70|FRCM=5|X4 RND=.2 F100|Y2|G71", [2540, 127, 2540]),
    ],
)
def test_a_corner_runs_at_its_own_feed(slowed: str, feeds: list[float] | None) -> None:
    text = HEAD + "G1 F100\n" + slowed.replace("|", "\n") + "\nM30\n"
    program = nc.parse(text)
    check(text.encode(), moves_of(text.encode()))
    assert nc.write(program, program.toolpath.with_moves()) == text.encode()
    if feeds is None:
        assert program.opaque
    else:
        assert not program.opaque
        np.testing.assert_allclose(program.toolpath.feed[1:] * 60, feeds, rtol=1e-12)


@pytest.mark.parametrize(
    "line",
    [
        # Machine data decide whether the block before the corner, or the one behind it, gives its feed.
        "X40 RND=2 FRC=50|Y20",
        "X40 RND=2|Y20 FRC=50",
        "X40 RND=2|Y20 F200",
        "X40 RNDM=2 FRCM=50|Y20 FRCM=0",
        "FRCM=R9|X40 RND=2|Y20",
        "FRCM=-1|X40 RND=2|Y20",
        "G95|FRCM=.1|X40 RND=2 F.2|Y20",
    ],
)
def test_a_corner_whose_feed_the_program_leaves_open_is_not_corrected(line: str) -> None:
    program = nc.parse(HEAD + "G1 F100\n" + line.replace("|", "\n") + "\nX-50\nM30\n")
    assert program.opaque_moves()[1:3].all() and any("feed" in s.reason for s in program.opaque)
    assert not program.opaque_moves()[-1]


SLOWED = HEAD + "FRCM=50\nN5 G1 X40 RND=2 F100\nY20 CHR=1 FRC=40\nN7 X20 FRC=40\nY40 F90\nX0 FRCM=0\nM30\n"
WRITTEN_OUT = HEAD + (
    "FRCM=50\nN5 G1 X38.03 F100\nG3 X40.03 Y2 I0 J2 F50\nG1 Y19 F100\nX39 Y20 F40\n"
    "N7 X20 F100\nY40 F90\nX0 FRCM=0\nM30\n"
)


def test_a_corner_written_out_states_its_feed_and_the_line_behind_it_the_one_before() -> None:
    text = SLOWED.replace("Y20 CHR=1 FRC=40", "Y20 CHR=1").replace("N7 X20 FRC=40", "N7 X20")
    out = moved(text, [1, 2, 3])
    assert out == WRITTEN_OUT.replace("F40", "F50")
    prove_text(text.encode(), out.encode(), [3, 4, 5])


def test_the_proof_holds_the_feed_of_every_corner() -> None:
    slowed = SLOWED.replace("N5 G1 X40 RND=2 F100", "N5 G1 X40 RND=2 F100 FRC=40")
    written = WRITTEN_OUT.replace("J2 F50", "J2 F40")
    prove_text(slowed.encode(), written.encode(), [3, 4, 5], reach=0.1)
    for old, new in (
        ("J2 F40", "J2 F41"),
        ("J2 F40", "J2"),
        ("Y19 F100", "Y19"),
        ("Y20 F40", "Y20"),
        ("N7 X20 F100", "N7 X20"),
        ("FRCM=50", "FRCM=60"),
        ("FRCM=0", "FRCM=1"),
        ("Y40 F90", "Y40"),
    ):
        with pytest.raises(LimitError):
            prove_text(slowed.encode(), written.replace(old, new).encode(), [3, 4, 5], reach=0.1)
    # A corner that stays.
    with pytest.raises(LimitError):
        prove_text(slowed.encode(), slowed.replace("CHR=1 FRC=40", "CHR=1").encode(), [3, 4, 5], reach=0.1)


def test_a_feed_before_a_line_that_stays_is_not_changed() -> None:
    """Behind the corner comes a cycle, whose feed is the one in force."""
    text = HEAD + "FRCM=50\nG1 X40 RND=2 F100\nY20\nG81 X9 Y9 Z-5 R2\nG80\nM30\n"
    out = moved(text, [1, 2, 3])
    assert "Y20 F100\nG81" in out


# -- AP=, RP= -------------------------------------------------------------------------------------------------

C, S = math.cos(math.radians(30)), math.sin(math.radians(30))


@pytest.mark.parametrize(
    ("polar", "ends"),
    [
        # Without a pole the zero of the work frame is it.
        ("G1 AP=30 RP=10", [(10 * C, 5)]),
        # Relative to the zero, to the last pole, to the last position programmed.
        ("G111 X20 Y10|G1 AP=90 RP=5", [(20, 15)]),
        ("G111 X20 Y10|G112 X-5 Y5|G1 AP=180 RP=5", [(10, 15)]),
        ("G1 X7 Y8|G110 X3 Y-8|G1 AP=-90 RP=5", [(7, 8), (10, -5)]),
        ("G111 AP=90 RP=20|G112 AP=0 RP=5|G1 AP=180 RP=10", [(-5, 20)]),
        # Neither G90 nor G91 has to do with the pole.
        ("G91|G111 X20 Y10|G90|G1 AP=0 RP=1", [(21, 10)]),
        # Radius and angle stay until others are stated; IC() counts from the last angle.
        ("G111 X1 Y2|G1 AP=0 RP=10|AP=90|RP=5|AP=IC(90)|AP=IC(-180) RP=2", [(11, 2), (1, 12), (1, 7), (-4, 2), (3, 2)]),
        # An arc turns about the pole.
        ("G111 X10 Y0|G3 AP=90 RP=10|AP=0|G2 AP=IC(-90)", [(10, 10), (20, 0), (10, -10)]),
        ("R1=30|G111 X=R1 Y=AC(4) Z=IC(1)|G111 X=R1 Y=4 Z3|G1 AP=R1*3 RP=6", [(30, 10)]),
        ("TRANS X100|G111 X20 Y10|G1 AP=90 RP=5 Z-1", [(120, 15)]),
        ("G70|G1 AP=0 RP=1|G71", [(25.4, 0)]),
    ],
)  # fmt: skip
def test_polar_positions(polar: str, ends: list[tuple[float, float]]) -> None:
    text = (HEAD + polar.replace("|", "\n") + "\nM30\n").encode()
    program = nc.parse(text)
    assert not program.opaque
    np.testing.assert_allclose(program.toolpath.end[1:, :2], ends, rtol=0, atol=1e-9)
    check(text, moves_of(text))
    assert nc.write(program, program.toolpath.with_moves()) == text


def test_a_polar_arc_has_its_centre_in_the_pole() -> None:
    path = nc.parse(HEAD + "G111 X10 Y0\nG3 AP=90 RP=10\nM30\n").toolpath
    np.testing.assert_allclose(path.centre[1, :2], [10, 0], rtol=0, atol=1e-9)
    np.testing.assert_allclose(path.sweep[1], 1.5 * math.pi, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    "polar",
    [
        "AP=30",
        "RP=5",
        "G111 X1 Y1|AP=0 RP=5|G111 X2 Y2|AP=9",
        "G91|AP=30 RP=5",
        "AP=0 RP=5|RP=IC(2)",
        "AP=0 RP=0",
        "G110 AP=0 RP=5|AP=1 RP=2",
        "G111 X1|AP=1 RP=2",
        "G111 X1 Y=AC(2)|AP=1 RP=2",
        "G111 X1 Y1|TRANS X5|AP=1 RP=2",
        "G18|AP=1 RP=2",
    ],
)
def test_a_polar_position_that_does_not_follow_is_not_known(polar: str) -> None:
    text = (HEAD + "G1 F9\n" + polar.replace("|", "\n") + "\nX5 Y5 Z5\nM30\n").encode()
    program = nc.parse(text)
    last = len(program.toolpath) - 2
    assert program.opaque_moves()[last] and np.isnan(program.toolpath.end[last, :2]).all()
    check(text, moves_of(text))


def test_polar_positions_are_written_as_places_and_so_are_those_that_rely_on_them() -> None:
    text = (
        HEAD + "G111 X0 Y0\nG1 AP=0 RP=10 F9\nAP=90\nG110 X5\nAP=0 RP=5\nAP=45 RP=7\nX0 Y0\nG110 X1\nRP=3 AP=90\nM30\n"
    )
    out = moved(text, [1])
    assert out == HEAD + (
        "G111 X0 Y0\nG1 X=10.03 F9\nX=0 Y=10\nG110 X5\nX=10\nX=9.9497 Y=14.9497\nX0 Y0\nG110 X1\nRP=3 AP=90\nM30\n"
    )


def test_a_pole_is_told_from_a_work_offset_and_from_polar_interpolation() -> None:
    haas = nc.parse(HEAD + "G110 X1 Y2 (X=1)\nG1 X3 F9\nM30\n")
    assert haas.toolpath.end[1, :2].tolist() == [1, 2]
    fanuc = nc.parse(HEAD + "G112\nG1 X3 Y5 F9\nG113\nM30\n")
    assert "G112" in fanuc.opaque[0].reason


def test_the_proof_holds_poles_and_the_rounding_of_lines_that_stay() -> None:
    text = HEAD + "G111 X1 Y2\nG1 AP=0 RP=9 F9\nX9 Y9\nG112 AP=90 RP=4\nAP=0 RP=3\nX40 RNDM=2\nY30\nRNDM=0\nX0\nM30\n"
    written = text.replace("G1 AP=0 RP=9", "G1 X=10.02 Y=2")
    prove_text(text.encode(), written.encode(), [3, 4])
    for old, new in (
        ("G111 X1", "G111 X2"),
        ("G111", "G110"),
        ("G112 AP=90", "G112 AP=80"),
        ("AP=0 RP=3", "AP=0 RP=4"),
        ("RNDM=2", "RNDM=3"),
        ("RNDM=0", "RNDM=1"),
    ):
        with pytest.raises(LimitError):
            prove_text(text.encode(), written.replace(old, new).encode(), [3, 4])
