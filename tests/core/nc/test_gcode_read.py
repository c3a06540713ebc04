# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading NC programs: what the words mean, what is refused, and that nothing else ever happens."""

from __future__ import annotations

import hashlib
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from millcorr.errors import FormatError
from millcorr.nc import Program, parse, read
from millcorr.nc.toolpath import Compensation, Kind
from tests.core.nc_programs import Made, programs
from tests.core.sweeps import examples

DATA = Path(__file__).parents[2] / "data" / "nc"
SAMPLES = sorted(DATA.glob("*.nc"))


def moves(text: str) -> Program:
    """Program from lines parted by '/', as MNVR("G1X1/G1Y1")."""
    return parse("\n".join(text.split("|")), "t.nc")


def ends(text: str) -> list[list[float]]:
    return moves(text).toolpath.end.tolist()


def same(a: object, b: object, tolerance: float = 1e-9) -> None:
    np.testing.assert_allclose(np.array(a, float), np.array(b, float), rtol=0, atol=tolerance)


# -- random programs ---


@settings(max_examples=examples(300), deadline=None)
@given(programs())
def test_random_program_means_its_moves(made: Made) -> None:
    program = parse(made.text)
    path = program.toolpath
    assert not program.opaque
    assert len(path) == len(made.moves)
    by_radius = made.dialect.arcs == "r"
    for i, move in enumerate(made.moves):
        assert path.source[i] == move["line"]
        assert path.kind[i] == move["kind"]
        same(path.start[i], move["start"])
        same(path.end[i], move["end"])
        if move["kind"] == Kind.ARC:
            # A centre found from R loses digits where the chord is nearly the diameter.
            same(path.centre[i], move["centre"], 1e-5 if by_radius else 1e-9)
            same(path.sweep[i], move["sweep"], 1e-6 if by_radius else 1e-9)


@settings(max_examples=examples(300), deadline=None)
@given(st.binary(max_size=200))
@example(b"G1X" + b"9" * 400)
@example(b"G" + b"9" * 400)
@example(b"T" + b"9" * 30)
@example(b"\xff\xfeG\x001\x00")
@example(b"G10 L[")
@example(b"G2X1R1e")
def test_any_bytes_are_read_or_refused(data: bytes) -> None:
    try:
        program = parse(data)
    except FormatError:
        return
    assert program.data == data
    assert b"".join(program.line(i) for i in range(len(program))) == data


TOKENS = """G 0 1 2 3 5 90 91 .1 X Y Z I J K R P Q F - + . ( ) ; # [ ] = % / * O , M98 M30 G28 G92 G52 G68 G69
G10 L2 G54 G81 G80 G41 D1 G20 G21 G18 G19 G17 T1 M6 N10 CALL IF " 1000000000 G53 G5 G93 G94 A E 10.5
G99 H1 G43""".split()


@settings(max_examples=examples(500), deadline=None)
@given(st.lists(st.sampled_from([*TOKENS, " ", "\n", "\n", "\n", "\r\n"]), max_size=60))
def test_mutated_programs_are_read_or_refused(tokens: list[str]) -> None:
    data = "".join(tokens).encode()
    try:
        program = parse(data)
        program.opaque_moves()
        program.comments()
    except FormatError:
        return
    assert len(program.toolpath) <= len(program)


# -- the language ---


def test_words_run_together_and_paper_style() -> None:
    path = read(DATA / "okuma.nc").toolpath
    line = np.flatnonzero(path.kind == Kind.LINE)
    same(path.end[line[1]], [105, 111.947, -15])
    same(path.start[line[1]], [5, 53.582, -15])
    same(path.feed[line], np.array([400, 516]) / 60)
    assert set(path.tool.tolist()) == {46}


def test_blanks_inside_numbers_as_linuxcnc() -> None:
    same(ends("G0 X0 Y0 Z0|x 1 0 y- .5 g1")[1], [10, -0.5, 0])


def test_missing_axis_is_the_last_value_and_unknown_before() -> None:
    path = moves("G0 Z5|G1 X10|Y3").toolpath
    assert np.isnan(path.start[0]).all()
    same(path.end[2], [10, 3, 5])
    assert np.isnan(path.end[0, :2]).all()


def test_plus_point_and_case() -> None:
    same(ends("g0 x+5. y-.5 z1")[0], [5, -0.5, 1])


def test_inch_and_back() -> None:
    path = moves("G20 G0 X1 Y0 Z0|G1 X2 F60|G21 X2").toolpath
    same(path.end[:, 0], [25.4, 50.8, 2.0])
    same(path.feed[1], 25.4)


@pytest.mark.parametrize(("metric", "inch"), [("G71", "G70")])
def test_siemens_units(metric: str, inch: str) -> None:
    same(np.array(ends(f"{inch} G0 X1|{metric} X1"))[:, 0], [25.4, 1.0])


def test_incremental_follows_absolute() -> None:
    same(ends("G90 G0 X1 Y1 Z1|G91 G1 X.1|X.1 Y1|G90 X5|G91 Y1")[-1], [5, 3, 1])


def test_incremental_from_nowhere_stays_unknown() -> None:
    assert np.isnan(ends("G91 G1 X1|X1")[1]).all()


@pytest.mark.parametrize(
    ("radius", "sweep"),
    [("5", -math.pi), ("10", -math.pi / 3), ("-10", -5 * math.pi / 3)],
)
def test_radius_arcs(radius: str, sweep: float) -> None:
    path = moves(f"G0 X0 Y0 Z0|G2 X10 R{radius}").toolpath
    same(path.sweep[1], sweep, 1e-7)
    same(path.centre[1, 0], 5)


def test_full_circle_turns_and_helix() -> None:
    path = moves("G0 X0 Y0 Z0|G3 I5|G2 I5 Z-1|G2 X10 I5 P3 Z-3").toolpath
    same(path.sweep[1:], [2 * math.pi, -2 * math.pi, -5 * math.pi])
    same(path.end[-1], [10, 0, -3])
    same(path.centre[2], [5, 0, 0])


@pytest.mark.parametrize(("plane", "words", "centre"), [
    ("G17", "X2 Y0 I1 J0", [1, 0, 0]), ("G18", "Z2 X0 K1 I0", [0, 0, 1]), ("G19", "Y2 Z0 J1 K0", [0, 1, 0]),
])  # fmt: skip
def test_planes(plane: str, words: str, centre: list[float]) -> None:
    path = moves(f"G0 X0 Y0 Z0|{plane} G3 {words}").toolpath
    same(path.centre[1], centre)
    same(path.sweep[1], math.pi)


def test_absolute_centres() -> None:
    same(moves("G0 X10 Y10 Z0|G90.1 G3 X12 I11 J10").toolpath.centre[1], [11, 10, 0])


def test_cubic_and_its_mirrored_tangent() -> None:
    path = moves("G0 X0 Y0 Z0|G5 I0 J3 P0 Q-3 X1 Y1|P0 Q-3 X2 Y2 (NEXT)").toolpath
    assert path.kind.tolist() == [0, 3, 3]
    same(path.control[1:], [[0, 3, 1, -2], [1, 4, 2, -1]])


def test_high_speed_switch_is_no_spline() -> None:
    program = moves("G0 X0 Y0|G05 P10000|G1 X1 F1|X2|G5.1 Q1|X3")
    assert program.toolpath.kind.tolist() == [0, 1, 1, 1]
    assert not program.opaque


def test_compensation_tool_and_feed() -> None:
    path = moves("T5 M6|G0 X0 Y0 Z0|G41 D5 G1 X1 F60|T7|X2|G42 X3|G40 X4|M6|X5|G95 X6 F.1|G94 X7|X8 F6").toolpath
    left, right, off = Compensation.LEFT, Compensation.RIGHT, Compensation.OFF
    assert path.compensation.tolist() == [off, left, left, right, off, off, off, off, off]
    assert path.tool.tolist() == [5, 5, 5, 5, 5, 7, 7, 7, 7]
    same(path.feed, [np.nan, 1, 1, 1, 1, 1, np.nan, np.nan, 0.1])


def test_tool_without_change_word() -> None:
    assert moves("T3|G0 X1|T4|X2").toolpath.tool.tolist() == [3, 4]


def test_comments_percent_and_block_delete() -> None:
    program = moves("%|O1000 (A)|N10 /G0 X1 (X2) ; X3|/2 X4|%|")
    same(program.toolpath.end[:, 0], [1, 4])
    assert program.comments() == [(1, "A"), (2, "X2"), (2, " X3")]


def test_text_behind_the_second_percent_is_no_program() -> None:
    assert len(moves("%|G0 X1|%|G0 X2|garbage!|").toolpath) == 1


def test_siemens_keywords() -> None:
    program = moves('G54 G90 G64 FFWON|G0 X1 Y1 Z1|CYCLE832(0.01)|MSG("side")|G0 SUPA Z0 D0|G1 X3 F1')
    assert program.opaque_moves().tolist() == [False, True, False]
    assert np.isnan(program.toolpath.end[2, 2])


def test_text_behind_the_end_moves_nothing() -> None:
    program = moves("G0 X1|M30|X2")
    assert len(program.toolpath) == 1
    assert program.opaque[0].first == 2


def test_dwell_homing_cycles() -> None:
    program = moves("G0 X1 Y1 Z9|G4 X2|G81 X5 Y5 Z-3 R1 F50|X6|G80|G0 Z20|G28 G91 Z0|G90 X9")
    path = program.toolpath
    same(path.end[:4, :2], [[1, 1], [5, 5], [6, 5], [6, 5]])
    assert (path.kind == Kind.RAPID).all()
    assert np.isnan(path.end[-1, 2])
    assert program.opaque_moves().tolist() == [False, True, True, False, True, False]


def test_work_offset_forgets_what_was_stated_in_the_other() -> None:
    path = moves("G54 G0 X1 Y1 Z1|G55 X2|G1 Y3 Z1|G55 X3").toolpath
    assert np.isnan(path.start[1]).all()
    assert np.isnan(path.end[1, 1:]).all()
    same(path.end[3], [3, 3, 1])


def test_bytes_digest_and_endings_are_kept() -> None:
    data = b"\xef\xbb\xbf%\r\nG0 X1\r\n\r\n(\xe4)\r\n%\x1a"
    program = parse(data)
    assert program.data == data
    assert program.digest == hashlib.sha256(data).hexdigest()
    same(program.toolpath.end[:, 0], [1])


def test_carriage_returns_alone_end_lines() -> None:
    assert parse(b"G0 X1\rX2\r").toolpath.source.tolist() == [0, 1]


# -- what cannot be corrected ---


@pytest.mark.parametrize(
    ("text", "opaque"),
    [
        ("G0 X0 Y0|G92 X1|G1 X2 F1|G92.1|X3", [0, 1, 0]),
        ("G0 X0 Y0|G52 X1 C5|G1 X2 F1|G52 X0 C0|X3", [0, 1, 0]),
        ("G0 X0 Y0|G68 X0 Y0 R30|G1 X2 F1|G69|X3", [0, 1, 0]),
        ("G0 X0 Y0|G10 L2 P1 X5|G1 X2 F1|G54|X3", [0, 1, 0]),
        ("G0 X0 Y0|G10 L1 P1 R5|G1 X2 F1", [0, 0]),
        ("G0 X0 Y0|#1=5|G1 X2 F1", [0, 0]),
        ("G0 X0 Y0|R1=5|G1 X2 F1", [0, 0]),
        ("G0 X0 Y0|G1 X[#1+2] F1|X3", [0, 1, 0]),
        ("G0 X0 Y0|G1 X#1 F1|X3", [0, 1, 0]),
        ("G0 X0 Y0|G1 X=R1 F1|X3", [0, 1, 0]),
        ("G0 X0 Y0|M98 P100|G1 X2 F1|G90 X3", [0, 1, 0]),
        ("G0 X0 Y0|G65 P9810 X2|G90 G1 X3 F1", [0, 0]),
        ("o100 sub|G1 X1 F1|o100 endsub|G1 X2", [0]),
        ("G0 X0|IF [#1 EQ 1] GOTO 5|G1 X1 F1", [0, 1]),
        ("G0 X0|G33 Z1 K1|G1 X1 F1", [0, 1, 0]),
        ("G0 X0|G53 X5|G1 X1 F1", [0, 1, 0]),
        ("G0 X0|G16|G1 X1 Y30 F1|G15|X2", [0, 1, 0]),
        ("G0 X0|G93 G1 X1 F1|G94 X2 F9", [0, 1, 1]),
        ("G0 X0 A0|G1 X1 A5 F1|X2", [0, 1, 0]),
        ("G0 X0|G1 X5 ,C1 F1|X7", [0, 1, 1]),
        ("X1 Y2|G0 X1", [1, 0]),
        ("G0 X0|CYCLE800(1)|G90 G0 X5", [0, 0]),
        ("G0 X0 Y0|G92.2|G92.3|G1 X2 F1|G92.1|X3", [0, 1, 0]),
        ('G0 X0 Y0|CYCLE800(1,"TC",0,57,0,0,0,0,0,30,0,0,0,1)|G90 G1 X2 F1|CYCLE800()|G90 G1 X3', [0, 1, 0]),
        ('G0 X0 Y0|CYCLE800(1,"TC",0,57,0,0,0,0.,0,0,0,0,0,1)|G90 G1 X2 F1', [0, 0]),
        ('G0 X0 Y0|CYCLE800(1,"TC",0,57,0,0,0,0,0,R5,0,0,0,1)|G90 G1 X2 F1', [0, 1]),
        # Mazak's and Haas's frames; Okuma's, which G10 alone ends.
        ("G0 X0 Y0|G68.5 X0 Y0 Z0 I0 J0 K1 R90|G1 X2 F1|G69.5|X3", [0, 1, 0]),
        ("G0 X0 Y0|G254|G1 X2 F1|G255|X3", [0, 1, 0]),
        ("G0 X0 Y0|G11 X10 Y5 P30|G1 X2 F1|G10|X3", [0, 1, 0]),
        ("G0 X0 Y0|G11|G1 X2 F1", [0, 0]),
        # A call that begins at a line within the subprogram.
        ("G0 X0 Y0|M98 P2 Q3 L2|G90 G1 X2 F1|M30|O2|G1 X5|N3 Y5|M99", [0, 0]),
    ],
)
def test_opaque_moves(text: str, opaque: list[int]) -> None:
    program = moves(text)
    assert program.opaque_moves().astype(int).tolist() == opaque
    program.require_plain(~program.opaque_moves())
    if any(opaque):
        with pytest.raises(FormatError, match=r"t\.nc:\d+: this move cannot be corrected"):
            program.require_plain(np.ones(len(opaque), bool))


def test_position_is_unknown_behind_a_variable_until_stated() -> None:
    path = moves("G0 X0 Y0 Z0|G1 X[#1] F1|Y5|X3").toolpath
    assert np.isnan(path.end[2, 0])
    same(path.end[3], [3, 5, 0])


# -- what is refused ---


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("G0 X10,5", 1, "decimal comma"),
        ("G98 L1 *|G0 X1 *|L1,2 *", 3, "calls a label as HEIDENHAIN's ISO programs do"),
        ("G0 X1|G1 X Y5", 2, "not a word"),
        ("G0 X1|G1 X1.2.3", 2, "not a word"),
        ("G0 X1|G1 X--1", 2, "not a word"),
        ("G0 X1|G1 X1 X2", 2, "two X words"),
        ("G0 X1|G0 G1 X2", 2, "contradict"),
        ("G0 X0 Y0|G2 X1", 2, "without a centre"),
        ("G0 X0 Y0|G2 X1 I.5 R1", 2, "keep one"),
        ("G0 X0 Y0|G2 X10 R4", 2, "shorter than half"),
        ("G0 X0 Y0|G2 X10 I5.1", 2, "not on its circle"),
        ("G0 X0 Y0|G2 X0 R5", 2, "ends where it starts"),
        ("G2 X10 I5 F1", 1, "unknown start"),
        ("G0 X0 Y0|G3 X10 I5 P0", 2, "number of turns"),
        ("G0 X0 Y0|G90.1 G2 X1 I2", 2, "both"),
        ("G0 X0 Y0|(open", 2, "comment without"),
        ("G0 X0 Y0|G1 X1 \xa7", 2, "cannot read"),
        ("G0 X0|G5 X1 Y1 P0 Q1", 2, "G5"),
        ("G1 X99999999999999999999", 1, "too large"),
        ("TOOL CALL 1 Z S1000", 1, "plain-language"),
        ("", None, "empty"),
        (" \n\n", None, "empty"),
        ("\0\1", None, "binary"),
    ],
)
def test_refused_with_line_and_remedy(text: str, line: int | None, what: str) -> None:
    with pytest.raises(FormatError, match=what) as caught:
        moves(text)
    assert caught.value.line == line
    assert caught.value.file == "t.nc"
    assert "\n" not in str(caught.value)


def test_missing_file() -> None:
    with pytest.raises(FormatError, match="cannot be read"):
        read("/nonexistent/part.nc")


@pytest.mark.parametrize("path", SAMPLES, ids=lambda p: p.stem)
def test_samples_are_read(path: Path) -> None:
    program = read(path)
    assert len(program.toolpath)
    assert (program.toolpath.kind != Kind.RAPID).any()


def test_a_title_without_brackets_may_name_a_tool() -> None:
    path = parse("%\nO1000 BRACKET REV B\nTOOL 1 END MILL\nG0 X0 Y0 Z0\nG1 X5 F9\nM30\n%\n").toolpath
    assert path.end[:, 0].tolist() == [0, 5]
