# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that run several times, as a contour in a subprogram at three depths: corrected once, all runs alike."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from millcorr import nc
from millcorr.errors import FormatError, LimitError
from millcorr.nc import order
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.text_proof import prove_text
from tests.core.stages.test_shop_programs import corrected, rectangle

CONTOUR = "G90G1X-15.Y10.F400.\nG3X-5.Y20.R10.\nG1Y45.\nX65.\nY-5.\nX-5.\nY20.\nG3X-15.Y30.R10.\nG1X-20.Y20.\n"
HEAD = "G21G90G17G40\nG0X-20.Y20.\nG0Z0.\n"
PLAIN = HEAD + ("G91G1Z-2.F200.\n" + CONTOUR) * 3 + "G90G0Z50.\nM30\n"
DEPTHS = {
    "Fanuc": "%\nO1\n" + HEAD + "M98P2L3\nG90G0Z50.\nM30\nO2\nG91G1Z-2.F200.\n" + CONTOUR + "M99\n%\n",
    "Fanuc, count in P": HEAD + "M98P30002\nG90G0Z50.\nM30\nO0002\nG91G1Z-2.F200.\n" + CONTOUR + "M99\n",
    "Haas": HEAD + "M97P100L3\nG90G0Z50.\nM30\nN100G91G1Z-2.F200.\n" + CONTOUR + "M99\n",
    "Fanuc, two levels": HEAD + "M98P2L3\nG90G0Z50.\nM30\nO2\nG91G1Z-2.F200.\nM98P3\nM99\nO3\n" + CONTOUR + "M99\n",
    "Fanuc macro": HEAD + "#1=0\nWHILE[#1LT3]DO1\nG91G1Z-2.F200.\n" + CONTOUR + "#1=#1+1\nEND1\nG90G0Z50.\nM30\n",
    "Mazak": HEAD + "#1=-2.\nN5G1Z#1F200.\n" + CONTOUR + "#1=#1-2.\nIF[#1GE-6.]GOTO5\nG0Z50.\nM30\n",
    "Okuma": "$O1.MIN%\nO1\n" + HEAD + "CALL O2 Q3\nG90G0Z50.\nM30\nO2\nG91G1Z-2.F200.\n" + CONTOUR + "RTS\n",
    "Okuma, names": "$O1.MIN%\nOPART\n" + HEAD + "VC1=3\nNLOOP CALL OSB1\nVC1=VC1-1\nIF [VC1 GT 0] NLOOP\n"
    "G90G0Z50.\nM02\nOSB1\nG91G1Z-2.F200.\n" + CONTOUR + "RTS\n",
    "LinuxCNC": "o100 sub\nG91G1Z-2.F200.\n" + CONTOUR + "o100 endsub\n" + HEAD + "o101 repeat [3]\no100 call\n"
    "o101 endrepeat\nG90G0Z50.\nM30\n",
    "Siemens": "%_N_PART_MPF\n" + HEAD + "L100 P3\nG90G0Z50.\nM30\n%_N_L100_SPF\nG91G1Z-2.F200.\n"
    + CONTOUR.replace("R10.", "CR=10.") + "M17\n",
    "Siemens jump": HEAD + "R1=-2\nANF:\nG1Z=R1 F200.\n" + CONTOUR.replace("R10.", "CR=10.")
    + "R1=R1-2\nIF R1>=-6 GOTOB ANF\nG0Z50.\nM30\n",
    "Siemens shift": HEAD + "L100 P3\nTRANS\nG90G0Z50.\nM30\n%_N_L100_SPF\nATRANS Z-2.\nG90G1Z0.F200.\n"
    + CONTOUR.replace("R10.", "CR=10.") + "RET\n",
}  # fmt: skip


def same_moves(a: Toolpath, b: Toolpath) -> None:
    for name in ("kind", "start", "end", "centre", "sweep", "feed", "compensation", "plane"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=0, atol=1e-9, err_msg=name)


@pytest.mark.parametrize("family", DEPTHS)
def test_the_same_moves_as_written_out(family: str) -> None:
    program = nc.parse(DEPTHS[family])
    assert not program.opaque
    same_moves(program.toolpath, nc.parse(PLAIN).toolpath)
    assert nc.write(program, program.toolpath.with_moves()) == program.data


@pytest.mark.few(4)
@pytest.mark.parametrize("family", DEPTHS)
def test_a_contour_at_three_depths_is_corrected_once(family: str) -> None:
    points = rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0]
    program, lines = corrected(DEPTHS[family], points)
    plain, _ = corrected(PLAIN, points)
    same_moves(program.toolpath, plain.toolpath)
    before = DEPTHS[family].splitlines()
    lines = [line for line in lines if line[:1] not in "(;"]
    changed = [(a, b) for a, b in zip(before, lines, strict=True) if a != b]
    assert 5 <= len(changed) <= 8
    assert sum(line.startswith("X64.97") for line in lines) == 1


def test_a_run_that_wants_another_correction_is_named() -> None:
    """The last depth moved on its own: no text of the line does for all runs."""
    program = nc.parse(DEPTHS["Fanuc"], "part.nc")
    path = program.toolpath
    low = (path.end[:, 2] == -6) & (path.kind != Kind.RAPID) & (path.end[:, 0] == 65)
    end, start = path.end.copy(), path.start.copy()
    end[low, 0] += 0.05
    start[1:][low[:-1], 0] += 0.05
    with pytest.raises(FormatError, match=r"part.nc:\d+: .* run 1 at Z-2 and run 3 at Z-6 want .* 0.0500 mm"):
        nc.write(program, path.with_moves(end=end, start=start))


def test_a_subprogram_in_a_file_beside_is_read_and_stays(tmp_path: Path) -> None:
    main, _, sub = DEPTHS["Fanuc"].partition("O2\n")
    (tmp_path / "PART.NC").write_text(main)
    (tmp_path / "O0002.nc").write_text("O2\n" + sub)
    program = nc.read(tmp_path / "PART.NC")
    same_moves(program.toolpath, nc.parse(PLAIN).toolpath)
    assert program.data == main.encode()
    with pytest.raises(FormatError, match=r"O0002.nc:2: .*file beside the program"):
        program.require_plain(program.toolpath.kind != Kind.RAPID)


def test_what_never_runs_and_what_steers_must_stay() -> None:
    """The proof compares the text as it runs, and the rest as it stands."""
    text = "O1\nM98P2L2\nM30\nO2\nG91G1Z-1.F9.\nG90X5.Y1.\nM99\nO3\nG1X7.\nM99\n"
    free = [5]
    prove_text(text.encode(), text.replace("X5.Y1.", "X5.01Y1.").encode(), free)
    for a, b in (("L2", "L3"), ("X7.", "X8."), ("Z-1.", "Z-2."), ("F9.", "F8."), ("M98P2", "M98P3")):
        with pytest.raises(LimitError):
            prove_text(text.encode(), text.replace("X5.Y1.", "X5.01Y1.").replace(a, b).encode(), free)


HAAS = """%
O00017 (STEPS)
T3 M06
G00 G90 G54 X10. Y5. S4000 M03
G43 H03 Z5.
G01 Z0 F150.
M97 P700 L4 (FOUR TIMES THE LINES FROM N700)
{more}G00 G90 Z5.
M30
N700 (A COMMENT BEHIND THE NUMBER)
G01 G91 Z-0.25
G90 X32.
G91 Z-0.25
G90 X10.
M99
%
"""


def test_steps_by_a_local_subprogram_as_haas_has_them() -> None:
    """M97 as in the Haas mill operator's manual (96-8000): N700 holds only a comment, G90 and G91 take turns."""
    program = nc.parse(HAAS.format(more=""))
    assert not program.opaque
    path = program.toolpath
    steps = path.take(path.kind != Kind.RAPID)
    np.testing.assert_allclose(steps.end[1::2, 2], -0.25 * np.arange(1, 9), atol=1e-12)
    np.testing.assert_allclose(steps.end[2::2, 0], [32.0, 10.0] * 4, atol=1e-12)
    # Behind L4 once more, by M98 of a program beside it, which is not there.
    more = nc.parse(HAAS.format(more="M98 P1234 L2\n"))
    assert "O1234" in more.opaque[0].reason and len(more.toolpath) == len(path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("G1X1Y1Z1F9\nM98P5\nX2\n", "O5 is called, which is neither in the file nor beside it"),
        ("N1G1X1Y1Z1F9\nGOTO1\nX2\n", "does not end"),
        ("O1\nG1X1F9\nM98P1\nX2\n", "call each other without end"),
        ("G1X1F9\nIF[#5 EQ 1]GOTO7\nX2\nN7X3\n", "#5 has no value"),
        ("G1X1F9\nGOTO7\nX2\n", "no line N7"),
        ("WHILE[#1LT3]DO1\nG1X1F9\n", "#1 has no value"),
    ],
)
def test_what_is_not_known_is_told(text: str, reason: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(order, "MOST_STEPS", 5_000)
    program = nc.parse(text)
    assert any(reason in stretch.reason for stretch in program.opaque)
