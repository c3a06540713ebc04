# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proof of the text lets pass, what it refuses, and how it says so."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr.errors import LimitError
from millcorr.path.text_proof import TextProof, prove_text
from tests.core.stages.test_pipeline import CASES, corrected

BEFORE = "G21 G90|T1 M6|G0 X0 Y0 Z5|G1 Z-5 F100|X10 F300|Y10|X0|G0 Z5|M30"
FREE = [4, 5, 6, 7]


def proven(after: str, before: str = BEFORE, free: object = FREE, **more: object) -> TextProof:
    """Proof of programs whose lines are parted by '|'."""
    old, new = (text.replace("|", "\n").encode() + b"\n" for text in (before, after))
    return prove_text(old, new, free, **more)


@pytest.mark.parametrize(
    "after",
    [
        "G21 G90|T1 M6|G0 X0 Y0 Z5|G1 Z-5 F100|X10.01 F300|Y10.01|X-.01|G0 Z5|M30",
        "G21 G90|T1 M6|G0 X0 Y0 Z5|G1 Z-5 F100|X5 Y.01 F300|X10|Y10.01|G3 X9 Y11 J1|G1 X-.01|G0 Z5|M30",
        "G21 G90|T1 M6|G0 X0 Y0 Z5|G1 Z-5 F100|X10.01 F300|X-.01|G0 Z5|M30",
        "G21 G90|T1 M6|G0 X0 Y0 Z5|G1 Z-5 F100|X10.01 F300|Y10.01|X0 Y10.01|G0 X0 Z5|M30",
    ],
    ids=["moved", "divided", "vanished", "restated"],
)
def test_places_may_change(after: str) -> None:
    proof = proven(after)
    assert proof.untouched.sum() == 5
    assert proof.moves.end[-1, 2] == 5


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Z-5 F100", "Z-9 F100", "line 4: Z-9 in place of Z-5"),
        ("X10 F300", "X10 F3000", "line 5: F3000 in place of F300"),
        ("T1 M6", "T2 M6", "line 2: T2 in place of T1"),
        ("M30", "M3", "line 9: M3 in place of M30"),
        ("|G0 Z5", "|G0 Z6", "line 8: Z6 in place of Z5"),
        ("|G0 Z5", "|G1 Z5", "line 8: "),
        ("|G0 Z5", "", "line 8: 'M30' in place of 'G0 Z5'"),
        ("Y10|", "Y10|Z-6|", "line 7: "),
        ("Y10|", "Y10|G0 X1|", "line 7: "),
        ("Y10|", "Y10 M5|", "line 6: "),
        ("Y10|", "Y10 F299|", "line 6: "),
        ("Y10|", "Y10 G41 D1|", "line 6: "),
        ("Y10|", "/Y10|", "line "),
        ("Y10|", "G3 Y10|", "line 6: no arc"),
        ("Y10|", "Y10 I5|", "line 6: a centre or radius on a straight move"),
        ("Y10|", "Y10 (MIND)|", "line 6: "),
        ("|M30", "", "line 9: the text ends where 'M30' is to come"),
        ("|M30", "|M30|M30", "line 10: 'M30' is not in the original"),
        ("G21", "G20", "line 1: G20 in place of G21"),
        ("X0 Y0 Z5", "X0 Y.1 Z5", "line 3: Y.1 in place of Y0"),
    ],
)
def test_nothing_else_may(old: str, new: str, said: str) -> None:
    with pytest.raises(LimitError) as refused:
        proven(BEFORE.replace(old, new, 1))
    assert said in str(refused.value)


def test_a_feed_stays_at_its_place() -> None:
    before = BEFORE.replace("X0|", "X0 F200|Y5|")
    swapped = BEFORE.replace("Y10|X0|", "X0 F200|Y10|Y5|")
    assert proven(swapped, before, [4, 5, 6, 7, 8]).largest_shift == 10
    with pytest.raises(LimitError, match="line 6: it stands 10.0000 mm from where it did"):
        proven(swapped, before, [4, 5, 6, 7, 8], reach=0.5)


def test_increments_add_up() -> None:
    before = "G0 X0 Y0 Z0|G91|G1 X1 F60|X1|X1|X1|Y2|G90|X0"
    assert proven("G0 X0 Y0 Z0|G91|G1 X1.1 F60|X.9|X1|X1|Y2|G90|X0", before, [2, 3]).untouched.sum() == 7
    with pytest.raises(LimitError, match="line 5: place of a move"):
        proven("G0 X0 Y0 Z0|G91|G1 X1.1 F60|X1|X1|X1|Y2|G90|X0", before, [2, 3])


def test_the_motion_code_behind_a_block_is_stated_again() -> None:
    before = "G0 X0 Y0|G1 X5 F60|M8|Y5|X9"
    assert proven("G0 X0 Y0|G3 X5 Y0 I2.5 F60|M8|G1 Y5|X9", before, [1]).source.tolist() == [0, 1, 2, 3, 4]
    with pytest.raises(LimitError, match="kind of motion"):
        proven("G0 X0 Y0|G3 X5 Y0 I2.5 F60|M8|Y5|X9", before, [1])


def test_a_ramp_that_is_divided_rises_evenly() -> None:
    before = "G0 X0 Y0 Z0|G1 X10 Z-2 F60|X20"
    divided = "G0 X0 Y0 Z0|G1 X5 Z-{} F60|X10 Z-2|X20"
    assert proven(divided.format("1.0004"), before, [1]).source.tolist() == [0, 1, -1, 2]
    for height in ("1.002", "0.9", "2.5", "0"):
        with pytest.raises(LimitError):
            proven(divided.format(height), before, [1])


def test_moves_come_before_what_acts_at_their_end() -> None:
    before = "G0 X0 Y0 Z0|G1 X10 F60 M9|X20"
    assert proven("G0 X0 Y0 Z0|G1 X5 Y.1 F60|X10 Y0 F60 M9|X20", before, [1]).source.tolist() == [0, -1, 1, 2]
    with pytest.raises(LimitError):
        proven("G0 X0 Y0 Z0|G1 X5 Y.1 F50|X10 Y0 F60 M9|X20", before, [1])


def test_what_acts_at_the_end_of_a_move_stays_with_it() -> None:
    before = "G0 X0 Y0 Z0|G1 X5 F60|X10|Y10 M9|X20"
    early = "G0 X0 Y0 Z0|G1 X5 F60|X10 Y10 M9|X10 Y0|X20 Y10"
    assert proven(early, before, [1, 2, 3, 4]).largest_shift == 5
    divided = "G0 X0 Y0 Z0|G1 X5 F60|X10|Y5|Y10.01 M9|X20"
    assert proven(divided, before, [1, 2, 3, 4]).largest_shift < 0.011


def test_header() -> None:
    before = "%|O1 (PART)|(DRAWING 7)|G0 X0"
    after = "%|O1 (PART)|(MILLCORR 1 GAIN)|(1.5)|(DRAWING 7)|G0 X0"
    proof = proven(after, before, [], header=["millcorr 1", "gain 1.5"])
    assert (proof.header, proof.source.tolist()) == (2, [0, 1, -1, -1, 2, 3])
    assert proof.moves.line.tolist() == [5]
    for wrong in (after.replace("1.5", "1.6"), after.replace("(1.5)|", "(1.5)|(DRAWING 7)|"), before + "|"):
        with pytest.raises(LimitError):
            proven(wrong, before, [], header=["millcorr 1", "gain 1.5"])


def test_order_mark_and_line_endings() -> None:
    before, after = (b"\xef\xbb\xbfG0 X0\rG1 X1 F5\r", b"\xef\xbb\xbf(m)\rG0 X0\rG1 X1.1 F5\r")
    assert prove_text(before, after, np.array([False, True]), header=["m"]).untouched.tolist() == [False, True, False]
    with pytest.raises(LimitError):
        prove_text(before, after.replace(b"\r", b"\n"), [1], header=["m"])


@pytest.mark.few(3)
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("moves", ["keep", "lines", "arcs", "nurbs"])
def test_corrected_programs_are_proven(name: str, moves: str) -> None:
    result, _ = corrected(name, lambda k, s: 0.01 + 0.005 * np.sin(2 * np.pi * s / 60.0), output_moves=moves)
    program = result.request.program
    header = [line.decode() for line in result.text.splitlines() if line.startswith((b"(", b";"))]
    header = [line for line in header if line.encode() not in program.data]
    proof = prove_text(program.data, result.text, program.toolpath.source, header=header, reach=0.1)
    assert proof.header == len(header)
