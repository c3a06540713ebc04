# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof's reader sees what the program's reader sees, and what LinuxCNC sees, though they share nothing."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from millcorr import gcode
from millcorr.path.reading import PlainMoves, read_moves
from millcorr.toolpath import Kind, Toolpath
from tests.core import loop_programs, rs274
from tests.core.nc_programs import Made, programs
from tests.core.sweeps import examples
from tests.core.test_gcode_linuxcnc import compare, motions_of

DATA = Path(__file__).parents[1] / "data" / "nc"
TEXTS = {name: text.encode() for name, text in vars(loop_programs).items() if name.isupper() and isinstance(text, str)}
TEXTS |= {path.stem: path.read_bytes() for path in sorted(DATA.glob("*.nc"))}
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
    program = gcode.parse(texts)
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
    check(text, read_moves(text))


@pytest.mark.parametrize("line", LINES)
def test_lines(line: str) -> None:
    text = (HEAD + line.replace("|", "\n") + "\nG1 X7 Y7\nM2\n").encode()
    check(text, read_moves(text))


@settings(max_examples=examples(200), deadline=None)
@given(programs(max_moves=20))
def test_random_programs(made: Made) -> None:
    check(made.text, read_moves(made.text))


def test_pieces_of_a_long_text_are_one() -> None:
    random = np.random.default_rng(0)
    at = random.uniform(-100, 100, (60_000, 2)).round(3)
    text = "%\nG21 G90\nG0 X0 Y0 Z1\nG1 Z-1 F60\n" + "".join(f"X{x:.3f} Y{y:.3f} (P)\n" for x, y in at)
    moves = read_moves((text + "M30\n%\nX9\n").encode())
    np.testing.assert_array_equal(moves.end[2:, :2], at)
    np.testing.assert_array_equal(moves.line, np.arange(len(at) + 2) + 2)


def test_work_offsets() -> None:
    text = b"G0 X1\nG55 X1\nG54.1 P3 X1\nG59.3 X1\nG15 H7 X1\n"
    assert read_moves(text).offset.tolist() == [540000, 550000, 541003, 593000, 150007]


def test_an_unknown_centre_is_no_arc() -> None:
    assert np.isnan(read_moves(b"G0 X0 Y0\nG2 X1 Y1\nG2 X2 R1").sweep[1:2]).all()


@pytest.mark.linuxcnc
@pytest.mark.skipif(rs274.RS274 is None, reason=rs274.MISSING)
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(programs(max_moves=20))
def test_linuxcnc_sees_the_same(made: Made) -> None:
    m = read_moves(made.text)
    centre = np.full((len(m), 3), np.nan)
    axes = np.array([(0, 1), (2, 0), (1, 2)])[m.plane - 17]
    np.put_along_axis(centre, axes, m.centre, axis=1)
    path = Toolpath(m.kind, m.start, m.end, centre, m.sweep, m.control, m.plane, m.feed, m.line, m.compensation, m.tool)
    compare(path, motions_of(made.text))
