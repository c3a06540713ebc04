# SPDX-License-Identifier: LGPL-2.1-or-later
"""HEIDENHAIN's ISO code case by case: what its words mean, how they are written back, what is refused.

Examples marked with a page are those of HEIDENHAIN's manual for ISO programming of TNC 426, TNC 425, TNC 415 B and
TNC 407 (280 580); those marked TNC 640 of its user's manual for DIN/ISO programming (34059x-05, 1/2015).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from millcorr import nc, pipeline
from millcorr.errors import FormatError, LimitError
from millcorr.nc.toolpath import Kind
from millcorr.path import din_proof, din_reading
from tests.core.din_programs import as_din
from tests.core.klartext_programs import Made, programs
from tests.core.klartext_programs import same_moves as as_made
from tests.core.nc.test_controls import same_moves
from tests.core.nc.test_klartext_random import RADIUS, measured, outcome
from tests.core.path.test_second_reader import check
from tests.core.sweeps import examples

START = "G01 G40 G90 X+0 Y+0 Z+0 F600"


def text_of(*lines: str, unit: int = 71) -> bytes:
    blocks = [f"%A G{unit} *", *(f"N{10 * i + 10} {line} *" for i, line in enumerate(lines)), f"N99999999 %A G{unit} *"]
    return "\n".join([*blocks, ""]).encode()


def read(*lines: str, unit: int = 71) -> nc.Program:
    """A program of some blocks, the second reader's agreement, and the same bytes again."""
    text = text_of(*lines, unit=unit)
    program = nc.parse(text, "a.i")
    if not program.opaque:
        check(text, din_reading.read(text).moves)
    assert nc.write(program, program.toolpath.with_moves()) == text
    return program


CASES = {
    "G01, G90 and G91 in one block, page 5-19": (["G01 G91 X+5 G90 Y-5", "X+7"], [(5, -5), (7, -5)]),
    "G91 holds on": (["G91 X+5 Y+1", "X+5", "G90 X+1"], [(5, 1), (10, 1), (1, 1)]),
    "I, J and G03": (["X+45 Y+25", "I+25 J+25", "G03 X+45 Y+25"], [(45, 25), (45, 25)]),
    "G29, pole where the tool is": (["X+30 Y+0", "G29", "X+40", "G03 X+20 Y+0"], [(30, 0), (40, 0), (20, 0)]),
    "pole by increments": (["X+30", "G91 I-10 J+0", "G90 G02 X+10 Y+0"], [(30, 0), (10, 0)]),
    "G05 turns as the arc before": (["I+5 J+0", "G02 X+10 Y+0", "I+15 J+0", "G05 X+20 Y+0"], [(10, 0), (20, 0)]),
    "G02 with R": (["X+40 Y+40", "G02 X+70 Y+40 R+20"], [(40, 40), (70, 40)]),
    "the motion code holds on": (["G02 X+10 Y+0 R+5", "X+20 Y+0 R+5", "G01 X+30"], [(10, 0), (20, 0), (30, 0)]),
    "G06, page 5-25": (
        ["G01 G41 X+50 Y+0 F100", "X+10 Y+40", "G06 X+50 Y+50", "G01 X+100"],
        [(50, 0), (10, 40), (50, 50), (100, 50)],
    ),
    "G11, H and R": (
        ["I+45 J+25", "G11 G42 R+30 H+0 F300", "H+60", "G91 H+60", "G90 H+180"],
        [(75, 25), (60, 50.980762), (30, 50.980762), (15, 25)],
    ),
    "G13, TNC 640": (["I+25 J+25", "G11 G42 R+20 H+0 F250 M3", "G13 H+180"], [(45, 25), (5, 25)]),
    "G16, TNC 640": (
        ["I+40 J+35", "G01 G42 X+0 Y+35 F250 M3", "G11 R+25 H+120", "G16 R+30 H+30", "G01 Y+0"],
        [(0, 35), (27.5, 56.650635), (65.980762, 50), (65.980762, 0)],
    ),
    "Z under G11": (["I+0 J+0", "G11 R+5 H+90", "Z-1", "H+0"], [(0, 5), (0, 5), (5, 0)]),
    "G24": (
        ["X+0 Y+30", "G01 G41 X+40 G91 Y+0", "G24 R12 F250", "X+5 G90 Y+0"],
        [(0, 30), (28, 30), (41.972788, 18.163273), (45, 0)],
    ),
    "G25": (["X+40", "G25 R5 F100", "Y+40"], [(35, 0), (40, 5), (40, 40)]),
    "no blanks, comma, lower case": (["g01x+10,5y-3,25f500m8"], [(10.5, -3.25)]),
    "D00, D01 and formulas": (
        ["D00 Q1 P01 +5", "D01 Q2 P01 +Q1 P02 +2,5", "X+Q1 Y-Q2", "Q3 = SQRT ( Q1 * 5 )", "X+Q3 Y+0"],
        [(5, -7.5), (5, 0)],
    ),
    "D12 jumps": (
        ["D00 Q1 P01 +0", "G98 L1", "D01 Q1 P01 +Q1 P02 +1", "G91 X+2", "D12 P01 +Q1 P02 +3 P03 1"],
        [(2, 0), (4, 0), (6, 0)],
    ),
    "L1,2 repeats twice": (["G98 L1", "G91 X+2", "L1,2"], [(2, 0), (4, 0), (6, 0)]),
    "L1,0 calls": (["L1,0", "G90 X+9", "G38 M2", "G98 L1", "G91 X+2", "G98 L0"], [(2, 0), (9, 0)]),
    "a subprogram runs under what its caller set": (
        ["G91", "L1", "G90", "L1", "G00 Z+9 M2", "G98 L1", "X+2", "Y+3", "G98 L0"],
        [(2, 0), (2, 3), (2, 3), (2, 3), (2, 3)],
    ),
    "hidden block and comment": (["X+1 ; there"], [(1, 0)]),
    "F and M alone": (["F100", "M8", "X+1"], [(1, 0)]),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_what_blocks_mean(case: str) -> None:
    lines, wanted = CASES[case]
    program = read(START, *lines)
    assert not program.opaque
    np.testing.assert_allclose(program.toolpath.end[1:, :2], wanted, atol=1e-6)


CHAMFERS = [
    "G30 G17 X+0 Y+0 Z-20", "G31 G90 X+100 Y+100 Z+0", "G99 T1 L+0 R+10", "T1 G17 S4000", "G00 G40 G90 Z+250",
    "X-10 Y-10", "Z-5 M3", "G01 G41 X+5 Y+5 F300", "G26 R5 F150", "Y+95", "X+95", "G24 R10", "Y+5", "G24 R20", "X+5",
    "G27 R5 F500", "G00 G40 X-20 Y-20", "Z+250 M2",
]  # fmt: skip


def test_a_soft_approach_touches_its_arc_and_the_contour() -> None:
    """As page 5-6 structures it: G26 behind the first contour point, G27 behind the last, outside without G41."""
    program = read(*CHAMFERS)
    assert not program.opaque
    t = program.toolpath
    assert t.tool.tolist()[-1] == 1
    cuts = np.flatnonzero(t.compensation == 1)
    onto, off = cuts[1], cuts[-2]
    assert t.kind[[onto, off]].tolist() == [Kind.ARC, Kind.ARC]
    for row, contour in ((onto, t.end[onto]), (off, t.start[off])):
        # A radius of 5 to the left of the contour, which goes up there, or comes from the right.
        assert abs(math.dist(t.centre[row, :2], contour[:2]) - 5) < 1e-9
    np.testing.assert_allclose(t.centre[onto, :2], (0, 5), atol=1e-9)
    np.testing.assert_allclose(t.centre[off, :2], (5, 0), atol=1e-9)
    for line, arc, at in ((onto - 1, onto, t.start[onto]), (off + 1, off, t.end[off])):
        way, arm = t.end[line] - t.start[line], at - t.centre[arc]
        assert abs(way[:2] @ arm[:2]) < 1e-9


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        (["G07 X+5", "X+9"], "'G07' is not followed"),
        (["G02 X+5 Y+0 I+2 J+0"], "I and J beside a motion: state the pole in a block of its own"),
        (["G11 X+5"], "X and Y under G11"),
        (["H+5"], "H without a polar motion code"),
        (["G03 X+5 Y+5"], "no pole (I, J) is stated before"),
        (["G43 X+5"], "R+ lengthens or shortens the way"),
        (["M8", "G26 R5"], "'G26' is not followed"),
        (["X+5 Y+5", "G26 R5"], "G26 without G41 or G42 in the block before"),
        (["X+5", "G25 R9", "Y+5"], "the arc of G25 does not fit"),
        (["X+Q5"], "X comes from Q5, whose value is not known"),
        (["%OTHER", "X+5"], "another program is called"),
        (["G73 G90 H+45", "X+5"], "cycle 10 rotates the frame"),
        (["D09 P01 +Q1 P02 +Q2 P03 1", "X+5", "G98 L1"], "a jump depends on a parameter"),
        (["L7,0", "X+5"], "no G98 L7 is there to go to"),
        (["X+5 A+3"], "a rotary or parallel axis"),
        (["X+5 M91"], "M91 or M92"),
    ],
)
def test_what_cannot_be_corrected_is_told_and_kept(lines: list[str], reason: str) -> None:
    program = read(START, *lines)
    assert any(reason in s.reason for s in program.opaque), program.opaque
    with pytest.raises(FormatError, match="G01, and G02 or G03"):
        program.require_plain(program.opaque_moves() | np.isin(program.toolpath.source, [program.opaque[0].first]))


def test_refusals_name_the_words_of_iso_code() -> None:
    with pytest.raises(FormatError, match=r"a\.i:4: arc whose end is not on its circle: correct it or its pole"):
        nc.parse(b"%A G71 *\nG01 G90 X+0 Y+0 *\nI+5 J+0 *\nG02 X+3 Y+0 *\n", "a.i")


def test_feeds_units_and_tools() -> None:
    program = read('T"END 8" G17 S900 F300', "G00 G90 X1 Y0", "G01 Z-1", "X2 F50", unit=70)
    t = program.toolpath
    np.testing.assert_allclose(t.end[-1], np.array([2, 0, -1]) * 25.4)
    np.testing.assert_allclose(t.feed[1:] * 60, [762, 127])
    assert program.tool(int(t.tool[0])) == "END 8"


def shifted(program: nc.Program, by: float, all_of_it: bool = False) -> bytes:
    """The program with what is under compensation, or all of it, moved in X."""
    t = program.toolpath
    end, centre, start = t.end.copy(), t.centre.copy(), t.start.copy()
    cut = (t.compensation != 0) | all_of_it
    end[cut, 0] += by
    centre[cut, 0] += by
    start[1:] = np.where(np.isfinite(end[:-1]), end[:-1], start[1:])
    return nc.write(program, t.with_moves(end=end, centre=centre, start=start))


def test_only_what_must_change_does() -> None:
    lines = ["T1 G17", START, "G41 X+5 F200 ; in", "Y+20 M8", "I+10 J+20", "G02 X+15 Y+20", "G01 G91 X+5", "G25 R1",
             "G90 Y+5", "G00 G40 X+0", "Z+9 M2"]  # fmt: skip
    program = read(*lines)
    wanted = ["T1 G17", START, "G41 X+5.5 F200 ; in", "Y+20 M8", "I+10.5 J+20", "G02 X+15.5 Y+20", "G01 G91 X+5",
              "G25 R1", "G90 Y+5", "G00 G40 X+0", "Z+9 M2"]  # fmt: skip
    assert shifted(program, 0.5) == text_of(*wanted)


def test_a_pole_that_a_polar_line_has_used_stays_and_the_arc_gets_its_own() -> None:
    program = read(START, "I+25 J+25", "G11 G42 R+20 H+0 F250", "G13 H+180")
    t = program.toolpath
    new = nc.parse(shifted(program, 0.01))
    np.testing.assert_allclose(new.toolpath.end[1:, 0], t.end[1:, 0] + 0.01, atol=1e-9)
    assert new.data.count(b"I+25") == 2


def test_a_letter_without_a_number_is_named() -> None:
    assert any("'G' is not followed" in s.reason for s in read(START, "G X+5").opaque)


def test_a_block_states_what_it_no_longer_inherits() -> None:
    """Where a line becomes an arc the next one says G01 again; where blocks are inserted numbers count on."""
    program = read(START, "X+10", "Y+10", "G91 X+5", "Y+5")
    t = program.toolpath
    rows = [0, 1, 2, 2, 3, 4]
    moved = t.take(np.array(rows))
    end, start, kind = moved.end.copy(), moved.start.copy(), moved.kind.copy()
    centre, sweep = moved.centre.copy(), moved.sweep.copy()
    kind[2], centre[2], sweep[2], end[2] = Kind.ARC, (15, 0, 0), math.pi / 2, (15, -5, 0)
    centre[2], sweep[2] = (15, 0, 0), math.pi / 2
    start[3] = end[2]
    new = nc.write(program, moved.with_moves(kind=kind, start=start, end=end, centre=centre, sweep=sweep))
    lines = [START, "X+10", "G03 X+15 Y-5 R+5", "G01 X+10 Y+10", "G91 X+5", "Y+5"]
    assert new == text_of(*lines)
    same = nc.parse(new).toolpath
    np.testing.assert_allclose(same.end, end, atol=1e-9)
    # An arc that ends a block: the block behind inherits G03 no more.
    kind, end, centre, sweep = (v.copy() for v in (t.kind, t.end, t.centre, t.sweep))
    kind[2], centre[2], sweep[2] = Kind.ARC, (10, 5, 0), math.pi
    new = nc.write(program, t.with_moves(kind=kind, centre=centre, sweep=sweep))
    assert [line.split(" ", 1)[1] for line in new.decode().splitlines()[3:6]] == [
        "G03 X+15 Y+5 R+5 *", "X+10 Y+10 R+5 *", "G01 G91 X+5 *",
    ]  # fmt: skip


def test_numbers_that_do_not_count_on_are_kept() -> None:
    text = text_of(START, "X+10", "Y+10").replace(b"N20", b"N25")
    program = nc.parse(text)
    t = program.toolpath
    moved = t.take(np.array([0, 1, 1, 2]))
    end, start = moved.end.copy(), moved.start.copy()
    end[1, :2] = start[2, :2] = (5, 1)
    new = nc.write(program, moved.with_moves(start=start, end=end))
    assert [line.split(" ")[0] for line in new.decode().splitlines()] == [
        "%A",
        "N10",
        "N25",
        "X+10",
        "N30",
        "N99999999",
    ]


def test_a_contour_at_three_depths_is_corrected_once() -> None:
    """Three runs of one section under G41, with G26 and G27, corrected as one, and proven."""
    text = text_of("T1 G17 S3000", "G00 G40 G90 X-20 Y-20", "Z+0", "G98 L1", "G91 G00 Z-2", *CHAMFERS[7:15], "G27 R5",
                   "G00 G40 X-20 Y-20", "L1,2", "Z+50 M2").replace(b"G01 G41 X+5", b"G01 G90 G41 X+5")  # fmt: skip
    program = nc.parse(text, "a.i")
    assert not program.opaque
    check(text, din_reading.read(text).moves)
    new = shifted(program, 0.02, all_of_it=True)
    assert new.count(b"X+5.02 Y+5") == 1 and new.count(b"G26 R5 F150") == 1
    proof = din_proof.SCRIPT.prove(text, new, np.arange(2, 18))
    assert proof.largest_shift < 0.03


def test_the_proof_takes_nothing_else() -> None:
    text = text_of(START, "G41 X+10 F200", "Y+10 M8", "G25 R2", "X+0", "Y+0", "G00 G40 Z+9 M2")
    new = text.replace(b"Y+10", b"Y+10.01")
    lines = np.array([3, 4, 5, 6])
    din_proof.SCRIPT.prove(text, new, lines)
    for old, other in (
        (b"M8", b"M9"), (b"F200", b"F300"), (b"Z+9", b"Z+8"), (b"G40", b"G41"), (b"N50", b"N55"), (b"G00", b"G01"),
        (b"G90 X+0", b"G91 X+0"), (b"M2", b""), (b"G41 X+10", b"G41 X+11"),
    ):  # fmt: skip
        assert old in new
        with pytest.raises(LimitError):
            din_proof.SCRIPT.prove(text, new.replace(old, other), lines)


@settings(max_examples=examples(60), deadline=None, suppress_health_check=list(HealthCheck))
@given(programs(leads=False))
def test_plain_language_in_the_words_of_iso_code(made: Made) -> None:
    text = as_din(made.text, len(made.lines))
    program = nc.parse(text, "made.i")
    assert program.opaque == ()
    as_made(made, program.toolpath, 2e-8)
    assert nc.write(program, program.toolpath.with_moves(feed=program.toolpath.feed.copy())) == text
    check(text, din_reading.read(text).moves)


@settings(max_examples=examples(30), deadline=None, suppress_health_check=list(HealthCheck))
@given(programs(leads=False))
def test_corrected_as_in_plain_language(made: Made) -> None:
    path = nc.parse(made.text).toolpath
    radius = 0.0 if (path.compensation != 0).any() else RADIUS
    part = measured(path, made.following, radius, 0.01, 0.002, 1.0)
    plain, din = outcome(made.text, part), outcome(as_din(made.text), part)
    assert isinstance(plain, str) == isinstance(din, str), (plain, din)
    if isinstance(plain, pipeline.Result) and isinstance(din, pipeline.Result):
        a, b = nc.parse(plain.text).toolpath, nc.parse(din.text).toolpath
        same_moves(a, b, 1e-9)
