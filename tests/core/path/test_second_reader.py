# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof's reader sees what the program's reader sees, and what LinuxCNC sees, though they share nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from millcorr import nc
from millcorr.errors import FormatError
from millcorr.nc.codes import HARMLESS
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.reading import FAMILIAR, PlainMoves
from millcorr.path.second_reader import moves_of
from tests.core import loop_programs, rs274
from tests.core.nc.test_gcode_linuxcnc import compare, motions_of
from tests.core.nc_programs import Made, programs
from tests.core.sweeps import examples

DATA = Path(__file__).parents[2] / "data" / "nc"
TEXTS = {name: text.encode() for name, text in vars(loop_programs).items() if name.isupper() and isinstance(text, str)}
TEXTS |= {path.stem: path.read_bytes() for path in sorted(DATA.glob("*.nc"))}
FAMILIES = [
    "M98 P2 L3|G0 Z9|M30|O2|G91 G1 Z-1|G90 X5|X0|M99",
    "M98 P30002|G0 Z9|M30|O2|G91 G1 Z-1|G90 X5|X0|M99",
    "M97 P500 L2|G0 Z9|M30|N500 G91 G1 Z-1|G90 X5|X0|M99",
    "M98 P2|M30|O2|M98 P3 L2|G1 X9|M99|O3|G91 X1|G90|M99",
    "G0 Z5|M98 P2 L2|X1|M30|O2|G91 Z-1 M99",
    "#1=0|WHILE [#1 GT -3] DO1|#1=#1-1|G1 Z#1 F10|X5|X0|END1|G0 X7",
    "#1=5 (DEPTH)|N10 #1=#1-1|G1 X[#1*2] Y-#1|IF [#1 GT 0] GOTO 10|G0 X[SQRT[#1+16]+SIN[30]]",
    "IF [1 EQ 2] GOTO 7|G1 X3|N7 X4|GOTO 9|X99|N9 Y3",
    "#100=3|#2=#100/4|G1 X#2 F#100|IF [#2 LT 1] THEN #2=8|X#2",
    "o100 sub|G1 X#1 Y[#2*2]|o100 endsub|o100 call [3] [4]|o200 repeat [2]|G91 X1|o200 endrepeat|G90",
    "#<depth> = 0|o1 while [#<depth> gt -2]|#<depth> = [#<depth> - 0.5]|G1 Z#<depth>|o1 endwhile|X1",
    "o1 if [1 gt 2]|G1 X1|o1 else|G1 X2|o1 endif|Y1",
    "G0 X=AC(10) Y=5 Z=IC(2)|R1=3|R2=R1*2|G1 X=R2+1 F=R1|G2 X=AC(0) Y5 CR=20|G3 X=IC(4) I=AC(2) J=AC(5)",
    "G52 X10 Y5|G1 X1 Y1 Z0|G52 X3|X2|G91 X1|G90|G52 X0 Y0|X3|G2 X5 Y6 I1|G52 C3|X9|G52 C0|X1 Y1 Z1",
    "TRANS X10 Z=1+2|G1 X1 Z0|ATRANS Y5|X2 Y2|G3 X5 I=AC(3.5) J=AC(2)|TRANS|G1 X1 Y1",
    "G1 X1 Y1|CIP X3 Y1 I1=AC(2) J1=2|CT X5 Y1|CT X7 Y1.5|G1 X3 Y0|G2 X=IC(2) AR=90|G3 X9 I2 TURN=1",
    "R1=2|ANF:|G1 X=R1 Y0|R1=R1-1|IF R1>0 GOTOB ANF|X9",
    "FOR R1=1 TO 3|G91 G1 X=R1|ENDFOR|G90 Y2|WHILE R1>2|R1=R1-1|X=R1|ENDWHILE",
    'ANF:|G91 G1 X1|MITTE_2:|Y1|REPEAT ANF MITTE_2 P=2|G90 X0|N7 REPEATB MITTE_2 P2|MSG("x")|Y0',
    "VC1=3|NLOOP G1 X=VC1|VC1=VC1-1|IF [VC1 GT 0] GOTO 5|N5 Y2",
    "VC1=3|NLOOP G1 X=VC1|VC1=VC1-1|IF [VC1 GT 0] NLOOP|GOTO NEND|X9|NEND|Y2",
    "R1=7|MCALL CYCLE81(5,0,2,-5)|G0 X9 Y9|X8|MCALL|X3|G1 Y2 Z-1|X=R1 F5|X5",
    "G0 X0|CALL OSB1|CALL OSB1 Q2|M02|OSB1 (SUB)|G91 G1 X1 F5|G90|RTS",
    "CALL O20 Q2|G1 X5|M30|O20|G91 G1 X1 Y1|G90|RTS",
    "DEF REAL TIEFE=-3, NN|G1 Z=TIEFE|NN=2|X=NN*3 KONTT CDOF|G500 G0 X2|G710",
    "L20 P2|G1 X5|M30|%_N_L20_SPF|G91 G1 X1 Y1|G90|M17",
    "G1 X10 ,R2|Y20 ,C1|X30 RND=3|G2 X40 Y10 R10 ,R1|G1 X30 Y0 CHF=.5|X20 Y-9 CHR=.7|"
    "Y-20,R1.|G3 X30 Y-10 R10 ,R.5|G3 X40 Y-20 R10 F5",
    "G1 X10 ,R2|G3 X10 Y20 R10 ,R3|G1 X0,R1|G2 X-10 Y20 R5",
    "G1 X10 Y0,A30.|Y20,A90.|,A180.|X-5 Y0,A45.|G3 X-10 Y5 R9 F3",
    "G20|G1 X1 ANG=45|TRANS X1|G1 Y2 ANG=90|ANG=120|X0 Y5 ANG=150 ,R.1|G1 X-9 Y5",
    "G1 X10,A30. ,R2.|Y20,A100.|X0 ,A180",
    "G111 X30 Y40|G1 RP=20 AP=30|N7 AP=60|G1 X10 Y10|X20|N9 G110 X-5|G3 RP=5 AP=90|G1 X1 Y1",
    "G1 X10 RNDM=2|Y10|X20 Y5 RNDM=0|Y-20",
    "#5=#6|G1 X#5|Y1|X1|IF [#7 EQ 1] GOTO 5|X2|N5 X3",
    "G1 X5 (A B) Y1|#1=2 (TWO)|X[#1] (THREE)|X=AC (7) ; X9",
]
HEAD = "G21 G17 G90\nG0 X0 Y0 Z0\nF100\n"
LINES = [
    "x 1 0 y- .5 g1",
    "G1 X5 (a G1 X9) Y3 ;foo G0",
    "G0 G80 X1",
    "G2 X10 Y0 I5.006",
    "G2 X10 Y0 R4.999",
    "G2 X10 Y0 R-7",
    "G3 X0 Y0 I5",
    "G43 H2 G0 Z5|G1 X3|G49 X4|G1 Z3",
    "G20 G1 X1|G21 X1",
    "N5/1G1X1Y2Z-.5F20*",
    "/ G1 X2 *",
    "G3 X0 Y0 Z4 I1 J1 P3",
    "G1 X+1. Y-2.|G91 X1|Y1 Z.5|G90 X0",
    "G5 X10 Y0 I3 J3 P-3 Q3|G5 X20 Y0 P-3 Q3",
    "G1 X1|G4 X5|X2",
    "G81 X1 Y1 Z-5 R2 F50|X2|G80|G0 X5 Z9",
    "G28 G91 Z0|G90 G1 X5|Z2|Y3",
    "G54 G0 X1|G55 G0 X1|Y2|Z3|G1 X2",
    "G54.1 P3 G0 X1 Y1 Z1",
    "G0 G90 G110 X1 Y2|Z5|G111|X6 Y7",
    "G0 G153 Z0|G1 X5|G90 G153 X9 Y9|X2 Y3",
    "T3|G1 X1|M6|X2|T4 M06|X3",
    'T="ROUGH 8" D1|M6|G1 X1|T = "FINE" M6|X2|T1="Rough 8"|M6|X3|T="5" M6|X4|T5 M6|X5',
    'T=ROUGH_8 M6|G1 X1|N5T=FINE|N6M6|X2|T=7 M6|X3|T5 "P" M6|X4 (T=Q T="R")',
    'T"MILL D8" G17 S900*|G1 X1*|T "B" G17*|X2*|;T="C"|X3',
    'T="" M6|G1 X1|T="A M6|X2|IF T==5 GOTOF E|R1T="A"|X3',
    "G93 G1 X1 F2|X2 F2|G94 X3|X4 F60",
    "G41 D1 G1 X1|G40 X2|G42.1 D5 X3",
    "G18 G2 X10 Z0 I5 K0|G19 G3 Y10 Z0 J5|G17",
    "G90.1 G3 X10 Y0 I5 J0|G91.1 G3 X20 Y0 I5",
    'G1 X1 "text G1 X9"|Y2',
    "#1=5|G1 X#1|Y3|X[#1+2] Z1|X2",
    "G1 X5 Y5, R2|X9|Y3 X2",
    "G92 X3|G1 X4|G92.1|G1 X2 Y2",
    "M98 P100|G90 G1 X1|Y1|Z1",
    'MSG ("X9")|G1 X1',
    "G1 X1234567.12345678|Y0.000000123456789012",
    "G1 X1|M30|X5",
]


def check(texts: bytes, moves: PlainMoves) -> None:
    """Every move that the program's reader can follow is the same, to the last bits."""
    program = nc.parse(texts)
    path = program.toolpath
    np.testing.assert_array_equal(moves.line, path.source)
    plain = ~program.opaque_moves()
    for name in ("kind", "plane", "tool", "compensation"):
        np.testing.assert_array_equal(getattr(moves, name)[plain], getattr(path, name)[plain], name)
    for name in ("start", "end", "control", "feed", "sweep"):
        ours, theirs = getattr(moves, name)[plain], getattr(path, name)[plain]
        np.testing.assert_allclose(ours, theirs, rtol=1e-12, atol=1e-9, err_msg=name)
    arcs = np.flatnonzero(plain & (path.kind == Kind.ARC))
    axes = np.array([(0, 1), (2, 0), (1, 2)])[path.plane[arcs] - 17]
    np.testing.assert_allclose(moves.centre[arcs], path.centre[arcs[:, None], axes], rtol=1e-9, atol=1e-8)


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("ending", [b"\n", b"\r\n", b"\r"])
def test_samples(name: str, ending: bytes) -> None:
    text = TEXTS[name].replace(b"\r\n", b"\n").replace(b"\n", ending)
    check(text, moves_of(text))


@pytest.mark.parametrize("line", LINES)
def test_lines(line: str) -> None:
    text = (HEAD + line.replace("|", "\n") + "\nG1 X7 Y7\nM2\n").encode()
    check(text, moves_of(text))


@pytest.mark.parametrize("line", FAMILIES)
@pytest.mark.parametrize("case", [str, str.lower])
def test_what_steers_and_what_is_computed(line: str, case: Callable[[str], str]) -> None:
    """Subprograms, loops, variables and named addresses run alike in both readers."""
    text = case("%\nO1\n" + HEAD + line.replace("|", "\n") + "\nG1 X7 Y7\nM2\n").encode()
    program = nc.parse(text)
    assert len(program.toolpath) > 2
    check(text, moves_of(text))


TITLES = [
    "%\nO1000 BRACKET OP1\nG21 G90 G0 X1\nY2 Z3\nM30\n",
    "%\nO1000\nBRACKET\nN5 T1 M6\nG21 G90 G0 X1\nY2 Z3\nM30\n",
    "BRACKET REV B 2019-05-03\nDRAWN: J. DOE 12.5 X 30\nG21 G90 G0 X1\nY2 Z3\nM98 P7\nM30\nO7\nG1 X2 F1\nM99\n",
    "O0001 PART\nG0 X1 Y1 Z1\nM98 P2 L2\nM30\nO2\nG91 G1 X1 F1\nM99\n",
]


@pytest.mark.parametrize("text", TITLES)
def test_titles_without_brackets_are_text(text: str) -> None:
    program = nc.parse(text)
    assert not program.opaque
    assert nc.write(program, program.toolpath.with_moves()) == text.encode()
    check(text.encode(), moves_of(text.encode()))


@settings(max_examples=examples(200), deadline=None)
@given(programs(max_moves=20))
def test_random_programs(made: Made) -> None:
    check(made.text, moves_of(made.text))


def test_pieces_of_a_long_text_are_one() -> None:
    random = np.random.default_rng(0)
    at = random.uniform(-100, 100, (60_000, 2)).round(3)
    text = "%\nG21 G90\nG0 X0 Y0 Z1\nG1 Z-1 F60\n" + "".join(f"X{x:.3f} Y{y:.3f} (P)\n" for x, y in at)
    moves = moves_of((text + "M30\n%\nX9\n").encode())
    np.testing.assert_array_equal(moves.end[2:, :2], at)
    np.testing.assert_array_equal(moves.line, np.arange(len(at) + 2) + 2)


def test_work_offsets() -> None:
    text = b"G0 X1\nG55 X1\nG54.1 P3 X1\nG59.3 X1\nG15 H7 X1\n"
    assert moves_of(text).offset.tolist() == [540000, 550000, 541003, 593000, 150007]


def test_an_unknown_centre_is_no_arc() -> None:
    assert np.isnan(moves_of(b"G0 X0 Y0\nG2 X1 Y1\nG2 X2 R1").sweep[1:2]).all()


@pytest.mark.linuxcnc
@pytest.mark.skipif(rs274.RS274 is None, reason=rs274.MISSING)
@settings(max_examples=examples(40), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(programs(max_moves=20))
def test_linuxcnc_sees_the_same(made: Made) -> None:
    m = moves_of(made.text)
    centre = np.full((len(m), 3), np.nan)
    axes = np.array([(0, 1), (2, 0), (1, 2)])[m.plane - 17]
    np.put_along_axis(centre, axes, m.centre, axis=1)
    path = Toolpath(m.kind, m.start, m.end, centre, m.sweep, m.control, m.plane, m.feed, m.line, m.compensation, m.tool)
    compare(path, motions_of(made.text))


@pytest.mark.parametrize("places", ["", " X3 Y4"])
def test_both_readers_lose_the_position_behind_the_same_codes(places: str) -> None:
    """What is unknown to one reader only would let a program that is right be refused, or a frame pass unseen."""
    # From 98760 on the first reader has numbers for words that are no G codes.
    for tenths in sorted(code for code in HARMLESS | FAMILIAR | {120, 130, 470, 1500} if code < 98760):
        text = f"G21\nG0 X1 Y2 Z3\nG{tenths / 10:g}{places}\nG90 G1 X5 F100\nG90 G1 X5 Y5 Z5\n"
        try:
            path = nc.parse(text).toolpath
        except FormatError:
            continue
        ends = moves_of(text.encode()).end
        assert ends.shape == path.end.shape, tenths
        np.testing.assert_array_equal(np.isfinite(ends), np.isfinite(path.end), f"G{tenths / 10:g}")
