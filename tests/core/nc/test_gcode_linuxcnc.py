# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's own interpreter makes the same motions of a program as our reader."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from millcorr.errors import FormatError
from millcorr.nc import parse, read, write
from millcorr.nc.toolpath import Kind, Plane, Toolpath
from tests.core import rs274
from tests.core.nc_programs import Made, displaced, programs
from tests.core.sweeps import examples

pytestmark = [
    pytest.mark.linuxcnc,
    pytest.mark.skipif(rs274.RS274 is None, reason=rs274.MISSING),
]
DATA = Path(__file__).parents[2] / "data" / "nc"
NAMES = {Kind.RAPID: "rapid", Kind.LINE: "line", Kind.ARC: "arc", Kind.CUBIC: "spline"}
# G91 adds up what LinuxCNC prints with four decimals; a centre found from R is as good as its square root.
SLACK = 1e-6


def compare(path: Toolpath, motions: list[rs274.Motion]) -> None:
    """Kinds, ends, centres and turns agree; what we hold for unknown is not compared."""
    leaves = np.flatnonzero(np.isnan(path.end).all(axis=1))
    count = int(leaves[0]) if len(leaves) else len(path)
    origin = rs274.Motion("rapid", (0.0, 0.0, 0.0))
    motions = [origin, *motions]
    j = 1
    for i in range(count):
        # A line with G0 or G1 alone is a motion to where the machine stands: no move to us.
        while _stands_still(motions[j - 1], motions[j]) and not _stays(path, i, motions[j]):
            j += 1
        theirs = motions[j]
        j += 1
        assert NAMES[Kind(int(path.kind[i]))] == theirs.kind, f"move {i}"
        if theirs.end is None:
            continue
        known = np.isfinite(path.end[i])
        allowed = theirs.rounding + SLACK
        assert np.abs(path.end[i][known] - np.array(theirs.end)[known]).max() <= allowed, f"move {i}"
        if theirs.centre is not None:
            a, b, _ = Plane(int(path.plane[i])).axes
            assert path.plane[i] == theirs.plane
            assert np.abs(path.centre[i, [a, b]] - theirs.centre).max() <= allowed, f"move {i}"
            assert math.ceil(abs(path.sweep[i]) / (2 * math.pi) - 1e-9) == abs(theirs.turns)
            assert (path.sweep[i] > 0) == (theirs.turns > 0)


def motions_of(text: bytes) -> list[rs274.Motion]:
    """Motions of a random program; LinuxCNC refuses arcs of a few thousandths, which say nothing about us."""
    try:
        return rs274.motions(text)
    except rs274.Refused as error:
        assume("Zero-radius arc" not in str(error))
        raise


def _stands_still(before: rs274.Motion, motion: rs274.Motion) -> bool:
    return motion.kind in ("rapid", "line") and motion.end == before.end


def _stays(path: Toolpath, i: int, motion: rs274.Motion) -> bool:
    off = np.abs(path.end[i] - motion.end)
    return bool((off[np.isfinite(off)] < motion.rounding + SLACK).all())


@pytest.mark.parametrize(
    "name", ["fanuc", "haas", "freecad-linuxcnc", "inch-incremental", "metric-incremental", "splines"]
)
def test_samples(name: str) -> None:
    program = read(DATA / f"{name}.nc")
    compare(program.toolpath, rs274.motions(program.data))


@settings(max_examples=examples(40), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(programs(max_moves=20))
def test_random_programs(made: Made) -> None:
    compare(parse(made.text).toolpath, motions_of(made.text))


@settings(max_examples=examples(40), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(programs(max_moves=20), st.integers(0, 2**32 - 1))
def test_rewritten_programs_run(made: Made, seed: int) -> None:
    program = parse(made.text)
    shift = np.random.default_rng(seed).uniform(-0.05, 0.05, (len(program.toolpath), 3))
    shift[0] = 0
    wanted = displaced(program.toolpath, shift)
    text = write(program, wanted, header=["corrected"])
    motions = motions_of(text)
    compare(parse(text).toolpath, motions)
    ends = np.array([m.end for m in motions])
    printed = 2 * max(m.rounding for m in motions)
    assert np.abs(ends - wanted.end).max() <= 0.0005 + printed


def test_rewritten_splines_run() -> None:
    program = read(DATA / "splines.nc")
    path = program.toolpath
    end, start, control = path.end.copy(), path.start.copy(), path.control.copy()
    end[2] += [0.01, 0.02, 0]
    start[3] = end[2]
    control[2] += 0.013
    text = write(program, path.with_moves(end=end, start=start, control=control))
    back = parse(text).toolpath
    np.testing.assert_allclose(back.control, control, atol=0.0002)
    assert [m.kind for m in rs274.motions(text)] == ["rapid", "line", "spline", "spline", "line"]


@pytest.mark.parametrize(
    "line",
    [
        "G2 X10",
        "G80 X1",
        "G1 G0 X1",
        "G1 X1 X2",
        "G2 X1 I.5 R2",
        "G2 X10 Y0 I5.1",
        "G2 X10 Y0 R4.9",
        "G90.1 G2 X1 I2",
        "G3 X10 Y0 I5 P0",
        "G1 X",
        "G1 X1.2.3",
        "G1 X1 (open",
        "G5 X1 Y1 Z2 I1 J1 P1 Q1",
        "G2 X0 Y0 R5",
    ],
)
def test_what_linuxcnc_refuses_is_not_corrected(line: str) -> None:
    text = f"G21 G17 G90\nG0 X0 Y0 Z0\nF100\n{line}\nM2\n".encode()
    with pytest.raises(rs274.Refused):
        rs274.motions(text)
    with pytest.raises(FormatError):
        program = parse(text)
        program.require_plain(np.ones(len(program.toolpath), bool))


@pytest.mark.parametrize(
    "line",
    [
        "x 1 0 y- .5 g1",
        "G1 X5 (a) Y3 ;foo",
        "G0 G80 X1",
        "G2 X10 Y0 I5.006",
        "G2 X10 Y0 R4.999",
        "G2 X0 Y0 I5",
        "G43 H0 G0 Z5",
        "G20 G1 X1",
        "G1X1Y2Z-.5F20",
        "G3 X0 Y0 Z4 I1 J1 P3",
        "G1 X+1. Y-2.",
        "N5 G1 X1",
    ],
)
def test_what_linuxcnc_accepts_is_read_alike(line: str) -> None:
    text = f"G21 G17 G90\nG0 X0 Y0 Z0\nF100\n{line}\nM2\n".encode()
    compare(parse(text).toolpath, rs274.motions(text))


@pytest.mark.parametrize(
    "lines",
    [
        "o100 sub|G1 X#1 Y[#2*2]|o100 endsub|o100 call [3] [4]|o100 call [5] [1]",
        "o200 repeat [3]|G91 G1 X1|Y.5|o200 endrepeat|G90",
        "#<depth> = 0|o1 while [#<depth> gt -2]|#<depth> = [#<depth> - 0.5]|G1 Z#<depth>|X[10+#<depth>]|o1 endwhile",
        "#1=3|o1 if [#1 gt 2]|G1 X1|o1 else|G1 X2|o1 endif|Y1",
        "#1=1|o1 if [#1 gt 2]|G1 X1|o1 elseif [#1 eq 1]|G1 X2|o1 else|G1 X3|o1 endif",
        "#1=5 #2=#1|G1 X#1|#1=[#1+1]|G1 X-#1 Y[SIN[30]*4+SQRT[16]-ABS[-2]]|G1 X[2**3] Y[ATAN[1]/[1]]",
        "#1=2|#1=[#1*3] G1 X#1|X#1",
        "G1 X[1+2*3-4/2] Y[[1+2]*3] Z[7 MOD 4]|X[FIX[2.7]] Y[FUP[2.2]] Z[ROUND[2.5]]",
        "#1=4|G2 X[2*#1] Y0 I#1|G3 X0 Y0 R[#1]",
        "M98 P200 L2|G1 X9|M2|O200|G91 G1 X1 Y1|G90|M99",
        "o1 sub|o2 call|G91 G1 X1|o1 endsub|o2 sub|G90 G1 Y[#31]|o2 endsub|#31=4|o1 call|o1 call|G90",
    ],
)
def test_what_linuxcnc_runs_is_run_alike(lines: str) -> None:
    """Subprograms, loops, choices, variables and expressions."""
    head = "G21 G17 G90|G0 X0 Y0 Z0|F100|"
    text = (head + lines + "|M2|").replace("|", "\n").encode()
    program = parse(text)
    assert not program.opaque
    compare(program.toolpath, rs274.motions(text))
