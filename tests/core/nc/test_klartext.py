# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain-language programs (Klartext) case by case: what their words mean, how they are written back, what is refused.

Examples marked with a section are those of HEIDENHAIN's manuals: iTNC 530, conversational programming, 340 49x-03 to
60642x-04, chapter "Programming contours"; TNC7, 81762x-16, for approaches.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from millcorr import nc
from millcorr.errors import FormatError, InputError, LimitError
from millcorr.nc.toolpath import Kind
from millcorr.path import klartext_proof, klartext_reading
from millcorr.process.kinematics.program import halts_of
from tests.core.nc.test_subprograms import PLAIN, same_moves
from tests.core.stages.test_shop_programs import corrected, rectangle

START = "L X+0 Y+0 Z+0 R0 F600"


def read(*lines: str, unit: str = "MM") -> nc.Program:
    """A program of some blocks, and the second reader's agreement."""
    text = "\n".join([f"BEGIN PGM A {unit}", *lines, f"END PGM A {unit}", ""])
    program = nc.parse(text, "a.h")
    second = klartext_reading.read(text.encode()).moves.toolpath()
    if not program.opaque:
        assert len(second) == len(program.toolpath)
        for name in ("kind", "start", "end", "centre", "sweep", "plane", "feed", "compensation", "tool", "source"):
            a, b = getattr(second, name), getattr(program.toolpath, name)
            # Out of the XY plane nothing asks the second reader for centres.
            flat = program.toolpath.plane == 17 if name == "centre" else slice(None)
            np.testing.assert_allclose(a[flat], b[flat], rtol=0, atol=1e-9, err_msg=name)
    assert nc.write(program, program.toolpath.with_moves()) == text.encode()
    return program


def ends(program: nc.Program) -> list[list[float]]:
    return program.toolpath.end[:, :2].round(6).tolist()


CASES = {
    "L, section 6.4: increments": (
        ["L X+10 Y+40 RL F200 M3", "L IX+20 IY-15", "L X+60 IY-10"],
        [(10, 40), (30, 25), (60, 15)],
    ),
    "CC and C, section 6.4": (["CC X+25 Y+25", "L X+45 Y+25 RR F200 M3", "C X+45 Y+25 DR+"], [(45, 25), (45, 25)]),
    "pole where the tool is": (["L X+30 Y+0", "CC", "L X+40 Y+0", "C X+20 Y+0 DR+"], [(30, 0), (40, 0), (20, 0)]),
    "pole by increments": (["L X+30 Y+0", "CC IX-10 IY+0", "C X+10 Y+0 DR-"], [(30, 0), (10, 0)]),
    "CR, section 6.4": (["L X+40 Y+40 RL F200 M3", "CR X+70 Y+40 R+20 DR-"], [(40, 40), (70, 40)]),
    "CT, section 6.4": (
        ["L X+0 Y+25 RL F300 M3", "L X+25 Y+30", "CT X+45 Y+20", "L Y+0"],
        [(0, 25), (25, 30), (45, 20), (45, 0)],
    ),
    "LP, section 6.5": (
        ["CC X+45 Y+25", "LP PR+30 PA+0 RR F300 M3", "LP PA+60", "LP IPA+60", "LP PA+180"],
        [(75, 25), (60, 50.980762), (30, 50.980762), (15, 25)],
    ),
    "CP, section 6.5": (["CC X+25 Y+25", "LP PR+20 PA+0 RR F250 M3", "CP PA+180 DR+"], [(45, 25), (5, 25)]),
    "CTP, section 6.5": (
        ["CC X+40 Y+35", "L X+0 Y+35 RL F250 M3", "LP PR+25 PA+120", "CTP PR+30 PA+30", "L Y+0"],
        [(0, 35), (27.5, 56.650635), (65.980762, 50), (65.980762, 0)],
    ),
    "CHF, section 6.4": (
        ["L X+0 Y+30 RL F300 M3", "L X+40 IY+0", "CHF 12 F250", "L IX+0 Y+0"],
        [(0, 30), (28, 30), (40, 18), (40, 0)],
    ),
    "RND of a right angle": (["L X+40", "RND R5", "L Y+40"], [(35, 0), (40, 5), (40, 40)]),
    "axis words alone": (["X+10 F200", "IY+5"], [(10, 0), (10, 5)]),
    "decimal comma and blanks": (["L  X +10,5  Y- 3,25 R0F500M8"], [(10.5, -3.25)]),
    "block in two lines": (["L X+1 ~", "  Y+2"], [(1, 2)]),
    "hidden block": (["/ L X+1 Y+2"], [(1, 2)]),
    "parameters": (
        ["Q1 = 5", "FN 1: Q2 = +Q1 + +2.5", "L X+Q1 Y-Q2", "Q3 = SQRT ( Q1 * 5 )", "L X+Q3"],
        [(5, -7.5), (5, -7.5)],
    ),
    "words that change nothing": (["L X+10 R F M"], [(10, 0)]),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_what_blocks_mean(case: str) -> None:
    lines, wanted = CASES[case]
    program = read(START, *lines)
    assert not program.opaque
    np.testing.assert_allclose(program.toolpath.end[1:, :2], wanted, atol=1e-6)


def test_the_four_arcs_of_one_radius() -> None:
    """Section 6.4: the sign of R chooses the smaller or the larger arc, DR the sense."""
    for radius, sense, centre, sweep in (
        ("+20", "-", -1, -1), ("+20", "+", 1, 1), ("-20", "-", 1, -1), ("-20", "+", -1, 1)
    ):  # fmt: skip
        arc = read("L X+40 Y+40 R0 F200", f"CR X+70 Y+40 R{radius} DR{sense}").toolpath.take(slice(1, 2))
        small = 2 * math.asin(15 / 20)
        assert abs(arc.sweep[0] - sweep * (small if radius == "+20" else 2 * math.pi - small)) < 1e-9
        assert abs(arc.centre[0, 1] - (40 + centre * math.sqrt(20**2 - 15**2))) < 1e-9


def test_a_helix_turns_as_often_as_it_says() -> None:
    path = read(START, "CC X+40 Y+0", "CP IPA-1080 IZ-3 DR-").toolpath
    assert abs(path.sweep[1] + 6 * math.pi) < 1e-12
    assert path.end[1].round(9).tolist() == [0, 0, -3]


APPROACHES = {
    # TNC7: PS (40, 10), PA (10, 20), contour on to (20, 35), cutter on the right; LT to (20, 20) and on to (35, 35).
    "APPR LT X+20 Y+20 Z-10 LEN15 RR F100|L X+35 Y+35": [(20 - 15 / math.sqrt(2),) * 2, (20, 20), (35, 35)],
    "APPR LN X+10 Y+20 Z-10 LEN15 RR F100|L X+20 Y+35": [
        (10 + 15 * 15 / math.hypot(10, 15), 20 - 15 * 10 / math.hypot(10, 15)), (10, 20), (20, 35),
    ],
    "APPR CT X+10 Y+20 Z-10 CCA180 R+10 RR F100|L X+20 Y+35": [
        (10 + 20 * 15 / math.hypot(10, 15), 20 - 20 * 10 / math.hypot(10, 15)), (10, 20), (20, 35),
    ],
}  # fmt: skip


@pytest.mark.parametrize("text", APPROACHES)
def test_approaches_end_where_the_manual_says(text: str) -> None:
    path = read("L X+40 Y+10 R0 F300 M3", *text.split("|")).toolpath
    (h, end, on), z = APPROACHES[text], path.end[:, 2]
    np.testing.assert_allclose(path.end[1, :2], h, atol=1e-9)
    np.testing.assert_allclose(path.end[-2:, :2], [end, on], atol=1e-9)
    assert z[-1] == -10
    assert path.compensation.tolist() == [0, *[-1] * (len(path) - 1)]
    assert path.feed[1] == 5.0 and path.feed[-1] == 100 / 60
    if "CT" in text:
        assert abs(path.sweep[-2] + math.pi) < 1e-12


def test_an_approach_from_a_line_touches_its_arc_and_the_contour() -> None:
    path = read("L X+40 Y+10 R0 F300", "APPR LCT X+10 Y+20 Z-10 R10 RR F100", "L X+20 Y+35").toolpath
    line, arc = path.take(slice(1, 2)), path.take(slice(2, 3))
    way = (line.end - line.start)[0, :2]
    arm = (arc.start - arc.centre)[0, :2]
    assert abs(way @ arm) < 1e-9 and abs(np.hypot(*arm) - 10) < 1e-9
    assert arc.sweep[0] < 0
    ahead = np.array([10.0, 15.0])
    assert abs((arc.end - arc.centre)[0, :2] @ ahead) < 1e-9


def test_a_departure_under_compensation_leaves_the_place_open() -> None:
    path = read(START, "L X+40 Y+0 RR", "L X+20 Y+20", "DEP LN LEN20 F100", "L Z+100 FMAX M2").toolpath
    np.testing.assert_allclose(path.end[3, :2], 20 + 20 / math.sqrt(2), atol=1e-9)
    assert np.isnan(path.start[4, :2]).all()
    assert path.compensation.tolist() == [0, -1, -1, -1, 0]


def test_feeds() -> None:
    text = [
        "TOOL CALL 5 Z S1000 F250",
        "L X+0 Y+0 FMAX",
        "L X+1",
        "L X+2 F100",
        "L X+3 FMAX",
        "L X+4",
        "L X+5 FAUTO",
        "L X+6 FZ0.1",
    ]
    np.testing.assert_allclose(
        read(*text).toolpath.feed * 60, [np.nan, 250, 100, np.nan, 100, 250, np.nan], equal_nan=True
    )
    # Tenths of an inch a minute.
    np.testing.assert_allclose(read(*text, unit="INCH").toolpath.feed[2] * 60, 100 * 2.54)
    corner = read(START, "L X+40", "RND R5 F100", "L Y+40").toolpath
    np.testing.assert_allclose(corner.feed * 60, [600, 600, 100, 600])


def test_tools_by_name_and_the_plane_of_their_axis() -> None:
    program = read('TOOL CALL "END 8" Y S1000', "L X+0 Y+0 Z+0 F100", "CC X+5 Z+0", "C X+10 Z+0 DR+")
    path = program.toolpath
    assert path.plane.tolist() == [18, 18] and program.tool(int(path.tool[0])) == "END 8"
    np.testing.assert_allclose(path.centre[1], [5, 0, 0])


CYCLE = ["CYCL DEF 200 DRILLING ~", "  Q200=2    ;SET-UP CLEARANCE ~", "  Q201=-20  ;DEPTH", "L X+50 Y+40 FMAX M99"]


def test_cycles_pass_through() -> None:
    program = read(START, *CYCLE, "L X+60 Y+40", "L X+Q200 Z+5")
    assert not program.opaque
    np.testing.assert_allclose(program.toolpath.end[1:], [(50, 40, 0), (60, 40, np.nan), (2, 40, 5)])


def test_dwells_and_stops_for_the_feed_model() -> None:
    program = read(START, "L X+5 M8", "CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL 1.5", "L X+9")
    halts = halts_of(program)
    assert halts.stop.tolist() == [False, True, False] and halts.dwell.tolist() == [0, 1.5, 0]


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        (["FL X+10 AN+30", "L X+0 Y+0"], "FK"),
        (["LN X+1 Y+1 Z+1 NX0 NY0 NZ1", "L X+0 Y+0"], "LN"),
        (["L X+Q7 Y+0"], "Q7, whose value is not known"),
        (["FN 18: SYSREAD Q7 = ID20 NR1", "L X+Q7 Y+0"], "Q7, set in line 3, whose value is not known"),
        (["L X+5 C+90"], "rotary"),
        (["L Z-1 R0 FMAX M91"], "machine frame"),
        (["CYCL DEF 10.0 ROTATION", "CYCL DEF 10.1 ROT+30", "L X+5"], "rotates"),
        (["PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY", "L X+5"], "tilts"),
        (["M128", "L X+5"], "M128"),
        (["CALL LBL 7", "L X+5"], "no LBL 7"),
        (["LBL 1", "L X+5", "FN 9: IF +Q3 EQU +0 GOTO LBL 1", "L X+0"], "jump depends"),
        (["CALL PGM SUB.H", "L X+5"], "another program"),
        (["L X+5 Y+0", "RND R9", "L X+5 Y+3"], "does not fit"),
        (["L X+5 R+ F100"], "lengthens"),
    ],
)
def test_what_cannot_be_corrected_is_told_and_kept(lines: list[str], reason: str) -> None:
    program = read(START, *lines)
    assert any(reason in stretch.reason for stretch in program.opaque), program.opaque


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("L X+5 Y+3 R0 FMAX\n", 1, "without BEGIN PGM"),
        ("BEGIN PGM A\nL X+1\n", 1, "MM or INCH"),
        ("BEGIN PGM A MM\nL X+0 Y+0\nCC X+5 Y+0\nC X+9 Y+0 DR+\n", 4, "not on its circle"),
        ("BEGIN PGM A MM\nL X+0 Y+0\nCR X+9 Y+0 R+2 DR+\n", None, None),
        ("BEGIN PGM A MM\nL X+0 X+5\n", 2, "two X words"),
        ("BEGIN PGM A MM\nL X+0 Y+0\nCC X+5 Y+0\nC X+10 Y+0\n", 4, "DR"),
    ],
)
def test_refused_with_line_and_remedy(text: str, line: int | None, what: str | None) -> None:
    if what is None:
        assert "shorter than half the way" in nc.parse(text).opaque[0].reason
        return
    with pytest.raises(FormatError, match=what) as caught:
        nc.parse(text, "a.h")
    assert caught.value.line == line


# -- writing ---------------------------------------------------------------------------------------------------


def moved(program: nc.Program, by: tuple[float, float] = (0.01, 0.02), rows: slice = slice(None)) -> bytes:
    """The program with some of its moves shifted, and what leads to them."""
    path = program.toolpath
    start, end, centre = path.start.copy(), path.end.copy(), path.centre.copy()
    start[rows, :2] += by
    end[rows, :2] += by
    centre[rows, :2] += by
    start[1:] = np.where(np.isnan(start[1:]), start[1:], end[:-1])
    return nc.write(program, path.with_moves(start=start, end=end, centre=centre))


WRITTEN = {
    "L X+10 Y+5 ; c|L X+10,5": "L X+10,01 Y+5,02 ; c|L X+10,51",
    "L IX+10|L IY+5 R0": "L IX+10|L IY+5 R0",
    "CC X+5 Y+0|C X+10 DR+ M8": "CC X+5.01 Y+0.02|C X+10.01 DR+ M8",
    "CR X+10 R+6 DR-": "CR X+10.01 R+6 DR-",
    "L X+40|RND R5 F100|L Y+40": "L X+40.01|RND R5 F100|L Y+40.02",
    "L X+40|CHF 5|L Y+40": "L X+40.01|CHF 5|L Y+40.02",
    "L X+20|CT X+30 Y+10": "L X+20.01|CT X+30.01 Y+10.02",
    "APPR LT X+20 Y+20 LEN5 RL|L Y+40": "APPR LT X+20.01 Y+20.02 LEN5 RL|L Y+40.02",
    "Q1 = 5|L X+Q1": "Q1 = 5|L X+5.01",
}


@pytest.mark.parametrize("before", WRITTEN)
def test_only_what_must_change_does(before: str) -> None:
    lines = before.split("|")
    program = read(START, *lines)
    assert moved(program).decode().splitlines()[2:-1] == WRITTEN[before].split("|")


def test_a_corner_that_the_control_cannot_make_is_written_out() -> None:
    """An arc that is not on the tangents is no RND; a feed of its own holds in its block only."""
    program = read(START, "L X+40", "RND R5 F100", "L Y+40")
    path = program.toolpath
    centre = path.centre + [0.05, -0.05, 0]
    new = nc.write(program, path.with_moves(centre=centre)).decode().splitlines()
    assert new[2:-1] == ["L X+35", "CR X+40 Y+5 R+4.9503 DR+ F100", "L Y+40 F600"]
    wider = read(START, "L X+40", "RND R5", "L Y+40"), read(START, "L X+40", "RND R+6", "L Y+40").toolpath
    new = nc.write(wider[0], wider[1]).decode().splitlines()
    assert new[2:-1] == ["L X+40", "RND R6", "L Y+40"]


def test_a_circle_stays_closed_and_a_shared_pole_gets_company() -> None:
    lines = ["CC X+0 Y+0", "C X+0 Y+10 DR+", "L X+0 Y+12", "L X-10 Y+0", "C IX+0 IY+0 DR+"]
    program = read("L X+10 Y+0 Z+0 R0 F600", *lines)
    new = moved(program, rows=slice(3, None)).decode().splitlines()
    assert new[1:-1] == [
        "L X+10 Y+0 Z+0 R0 F600", *lines[:3], "L X-9.99 Y+0.02", "CC X+0.01 Y+0.02", "C IX+0 IY+0 DR+",
    ]  # fmt: skip
    assert abs(nc.parse("\n".join(new)).toolpath.sweep[-1] - 2 * math.pi) < 1e-12


def test_blocks_count_on_where_others_were_inserted() -> None:
    text = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 F600\n2 L X+10 M9\n3 L Y+5\n4 END PGM A MM\n"
    program = nc.parse(text)
    path = program.toolpath
    two = path.take(np.array([0, 1, 1, 2]))
    end, start = two.end.copy(), two.start.copy()
    end[1], start[2] = [5, 0.01, 0], [5, 0.01, 0]
    new = nc.write(program, two.with_moves(start=start, end=end), header=["millcorr: made", "twice"])
    assert new.decode().splitlines() == [
        "0 BEGIN PGM A MM", "1 ; millcorr: made", "2 ; twice", "3 L X+0 Y+0 Z+0 F600", "4 L X+5 Y+0.01",
        "5 L X+10 Y+0 M9", "6 L Y+5", "7 END PGM A MM",
    ]  # fmt: skip


def test_a_parameter_that_others_use_is_not_replaced() -> None:
    program = read(START, "Q1 = 5", "L X+Q1", "L Y+Q1")
    with pytest.raises(FormatError, match=r"a.h:4: X\+Q1 cannot be corrected: Q1, set in line 3, is used 2 times"):
        moved(program, rows=slice(1, None))


def test_splines_are_not_written() -> None:
    program = read(START, "L X+10")
    path = program.toolpath
    kind, control = path.kind.copy(), path.control.copy()
    kind[1], control[1] = Kind.CUBIC, [3, 1, 6, 1]
    with pytest.raises(InputError, match="no spline"):
        nc.write(program, path.with_moves(kind=kind, control=control))


# -- whole programs --------------------------------------------------------------------------------------------

CONTOUR = """L X-15 Y+10 R0 F400
CC X-15 Y+20
C X-5 Y+20 DR+
L Y+45
L X+65
L Y-5
L X-5
L Y+20
CR X-15 Y+30 R+10 DR+
L X-20 Y+20
"""
HEAD = "BEGIN PGM A MM\nL X-20 Y+20 R0 FMAX\nL Z+0 FMAX\n"
DEPTHS = {
    "repeated section": HEAD + "LBL 1\nL IZ-2 F200\n" + CONTOUR
    + "CALL LBL 1 REP 2\nL Z+50 FMAX M30\nEND PGM A MM\n",
    "subprogram": HEAD + "CALL LBL 1\n" * 3 + "L Z+50 FMAX\nL M30\nLBL 1\nL IZ-2 F200\n" + CONTOUR
    + "LBL 0\nEND PGM A MM\n",
    "in a subprogram": HEAD + 'CALL LBL 1\nL Z+50 FMAX M2\nLBL 1\n'
    + "LBL 2\nL IZ-2 F200\n" + CONTOUR + "CALL LBL 2 REP2\nLBL 0\nEND PGM A MM\n",
    "jump": HEAD + "Q1 = -2\nLBL \"D\"\nL Z+Q1 F200\n" + CONTOUR
    + 'FN 2: Q1 = +Q1 - +2\nFN 11: IF +Q1 GT -6.5 GOTO LBL "D"\nL Z+50 FMAX M2\nEND PGM A MM\n',
}  # fmt: skip


@pytest.mark.few(1)
@pytest.mark.parametrize("how", DEPTHS)
def test_a_contour_at_three_depths_is_corrected_once_as_in_iso(how: str) -> None:
    text = DEPTHS[how]
    program = nc.parse(text)
    assert not program.opaque
    same_moves(program.toolpath, nc.parse(PLAIN).toolpath)
    points = rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0]
    found, lines = corrected(text, points)
    plain, _ = corrected(PLAIN, points)
    cuts = [t.take(t.kind != Kind.RAPID) for t in (found.toolpath, plain.toolpath)]
    for name in ("kind", "start", "end", "feed"):
        np.testing.assert_allclose(*(getattr(t, name) for t in cuts), rtol=0, atol=1e-9, err_msg=name)
    lines = [line for line in lines if not line.startswith("; ")]
    changed = [(a, b) for a, b in zip(text.splitlines(), lines, strict=True) if a != b]
    assert 5 <= len(changed) <= 9, changed


def test_runs_that_want_different_corrections_are_named() -> None:
    program = nc.parse(DEPTHS["subprogram"], "a.h")
    path = program.toolpath
    low = (path.end[:, 2] == -6) & (path.end[:, 0] == 65)
    end, start = path.end.copy(), path.start.copy()
    end[low, 0] += 0.05
    start[1:][low[:-1], 0] += 0.05
    with pytest.raises(FormatError, match=r"a.h:\d+: .* run 1 at Z-2 and run 3 at Z-6 want .* 0.0500 mm"):
        nc.write(program, path.with_moves(end=end, start=start))


PROVEN = """0 BEGIN PGM A MM
1 ; part
2 TOOL CALL 1 Z S4000 F500
3 L X+0 Y-60 R0 FMAX M3
4 L Z-3 F100
5 L X+0 Y-29 RL F400
6 CC X-34 Y-19
7 L X-34
8 C X-44 Y-19 DR-
9 L Y+29 M8
10 RND R6 F200
11 L X+30
12 L Y-20 Z-4
13 CYCL DEF 200 DRILLING ~
   Q200=2 ;CLEARANCE
14 L X+99 Y+99
15 L Z+50 R0 FMAX M30
16 END PGM A MM
"""


def proven(written: bytes, free: list[int]) -> None:
    klartext_proof.SCRIPT.prove(PROVEN.encode(), written, np.array(free), reach=0.1)


def test_the_proof_takes_what_was_written_and_nothing_else() -> None:
    program = nc.parse(PROVEN)
    rows = slice(2, len(program.toolpath) - 2)
    path = program.toolpath
    shift = np.zeros((len(path), 3))
    shift[rows, :2] = 0.01, 0.02
    start = path.start + np.vstack([np.zeros(3), shift[:-1]])
    new = nc.write(program, path.with_moves(start=start, end=path.end + shift, centre=path.centre + shift))
    free = np.unique(path.source[2:-1]).tolist()
    proven(new, free)
    lines = new.decode().splitlines(keepends=True)
    # What is free to change, X, Y, R and DR, the proof of the surface looks at.
    mutants = [
        new.replace(b"Z-3", b"Z-4"), new.replace(b"F100", b"F101"), new.replace(b"F400", b"F401"),
        new.replace(b" RL", b" RR"), new.replace(b" RL", b""), new.replace(b"M8", b"M9"), new.replace(b"F200", b"F300"),
        new.replace(b"; part", b"; pert"), new.replace(b"Q200=2", b"Q200=3"), new.replace(b"Y-60", b"Y-61"),
        new.replace(b"Z-4", b"Z-5"), new.replace(b"M30", b"M2"), new.replace(b"\n8 ", b"\n9 "),
        new.replace(b" F400\n", b"\n"),
        new.replace(b"TOOL CALL 1", b"TOOL CALL 2"), new.replace(b"R0 FMAX M3", b"R0 M3"),
        "".join(lines[:4] + lines[5:]).encode(), "".join(lines[:5] + lines[4:]).encode(),
    ]  # fmt: skip
    for k, mutant in enumerate(mutants):
        assert mutant != new, k
        with pytest.raises(LimitError):
            proven(mutant, free)


def test_what_corners_join_is_written_together() -> None:
    """Corner by corner, the row that one change reaches; an arc on the tangent goes with the move before it."""
    lines = ["L X+40", "RND R5", "L Y+40", "CHF 3", "L X+80", "L Y+90", "RND R2", "L X+0", "CT X-10 Y+80"]
    program = read(START, *lines)
    assert program.written_out(np.array([5])).tolist() == [2, 3, 4, 5, 6]
    assert program.written_out(np.array([7])).tolist() == [7, 8, 9, 10]
    assert program.written_out(np.array([1])).tolist() == [1]


ROUND = ["X30 Y-5", "X-5", "Y45", "X65", "Y-5", "X30", "X30 Y-60"]
STRAIGHT = {
    "Klartext": "BEGIN PGM A MM\nL X30 Y-60 R0 FMAX\nL Z0 FMAX\nLBL 1\nL IZ-2 F200\n"
    + "".join(f"L {words}\n" for words in ROUND)
    + "CALL LBL 1 REP 2\nL Z50 FMAX M30\nEND PGM A MM\n",
    "ISO": "G90\nG0 X30 Y-60\nG0 Z0\nM98 P2 L3\nG90 G0 Z50\nM30\nO2\nG91 G1 Z-2 F200\nG90\n"
    + "".join(f"{words}\n" for words in ROUND)
    + "M99\n",
}


@pytest.mark.parametrize("family", STRAIGHT)
def test_straight_leads_of_a_contour_at_three_depths_stay_alike(family: str) -> None:
    """Between two depths they would go along with the contour, behind the last they stay: one text cannot do both."""
    points = rectangle(0.0, 0.0, 60.0, 40.0)
    points = points + 0.03 * np.sign(np.round(points - [30, 20], 9)) * np.isclose(np.abs(points - [30, 20]), [30, 20])
    program, lines = corrected(STRAIGHT[family], points)
    text = "\n".join(lines)
    assert "X30 Y-4.97" in text and "X30 Y-60" in text.split("Z-2")[1] and "Y44.97" in text and "X64.97" in text
    assert (program.toolpath.end[:, 2] == -6).any()
