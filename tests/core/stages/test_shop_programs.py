# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs as shops write them, with parts whose errors are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.errors import FormatError
from millcorr.nc.toolpath import Kind
from millcorr.readers.measurement import Measurement


def part(points: np.ndarray) -> Measurement:
    """Contact points of a part, (n, 2) in mm."""
    return Measurement(np.column_stack([points, np.zeros(len(points))]), None, 0.0, np.arange(len(points)), "m", "ab")


def circle(radius: float, centre: tuple[float, float] = (0.0, 0.0)) -> np.ndarray:
    """Points of a circle, (90, 2)."""
    angle = np.deg2rad(np.arange(0.0, 360.0, 4.0))
    return np.array(centre) + radius * np.column_stack([np.cos(angle), np.sin(angle)])


def rectangle(x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    """Points on the edges of a rectangle, away from its corners, (n, 2)."""
    u = np.linspace(0.05, 0.95, 40)
    x, y = x0 + (x1 - x0) * u, y0 + (y1 - y0) * u
    edges = [(x, y0 + 0 * x), (x, y1 + 0 * x), (x0 + 0 * y, y), (x1 + 0 * y, y)]
    return np.concatenate([np.column_stack(edge) for edge in edges])


def corrected(text: str, points: np.ndarray, tool: float = 10.0, **settings) -> tuple[nc.Program, list[str]]:
    """The corrected program, and its lines without the header."""
    program = nc.parse(text, "part.nc")
    chosen = pipeline.Settings(**({"filter": "none"} | settings))
    result = pipeline.correct(pipeline.Request(program, tool / 2, part(points), None, chosen))
    lines = result.text.decode().splitlines()
    return nc.parse(result.text, "out.nc"), [line for line in lines if not line.lower().startswith("(m")]


@pytest.mark.few(6)
@pytest.mark.parametrize("code", ["G2", "G3"])
@pytest.mark.parametrize("radius", [11.98, 12.02, 12.05])
@pytest.mark.parametrize("start", [0.9055, 0.1234, 0.7071])
def test_a_full_circle_keeps_its_direction(code: str, radius: float, start: float) -> None:
    """Climb milling must not become conventional milling, wherever rounding leaves start and end."""
    centre = (1.9685 * 25.4, start * 25.4 + 17.0)
    text = f"G20G90\nG0X1.9685Y{start - 0.2:.4f}\nG1Z-.2F10.\nY{start}F30.\n{code}X1.9685Y{start}J{17 / 25.4:.6f}\n"
    program, _ = corrected(text + f"G1Y{start - 0.2:.4f}\nG0Z1.\n", circle(radius, centre))
    arcs = program.toolpath.take(program.toolpath.kind == Kind.ARC)
    assert len(arcs)
    assert (np.sign(arcs.sweep) == (-1 if code == "G2" else 1)).all()
    r = np.hypot(*(arcs.start - arcs.centre)[:, :2].T)
    np.testing.assert_allclose(r, 17.0 - (radius - 12.0), atol=1e-3)


HOME = """%
:1234
N10 G21 G90 G40
N20 G0 X-15. Y-15.
N30 Z2.
N40 G1 Z-3. F200.
N50 X-10. Y10. F600.
N60 G3 X-5. Y15. R5.
N70 G1 Y45.
N80 X65.
N90 Y-5.
N100 X-5.
N110 Y15.
N120 G3 X-10. Y20. R5.
N130 G0 Z25. M9
N140 {home}
N150 G28 X0. Y0.
N160 M30
%
"""


@pytest.mark.parametrize("home", ["G91 G28 Z0.", "G28 G91 Z0.", "G28 Z30.", "G30 Z30.", "G0 Z#500", "G53 G0 Z0."])
def test_homing_behind_the_lead_out_stays_as_it_is(home: str) -> None:
    """From where the lead ends the tool goes home; nothing about that can or must be rewritten."""
    text = HOME.format(home=home)
    _, lines = corrected(text, rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0])
    assert lines[-4:] == text.splitlines()[-4:]
    assert "N120 G3 X-10.03 Y20. R5." in lines
    assert "N80 X64.97" in lines
    assert lines[1] == ":1234"


@pytest.mark.parametrize(
    "cycle",
    [
        "G12 I5. D1 F100.",
        "G47 P0 X-50. Y0. I45. J3. R1. Z-.2 F50. (TEXT)",
        "G31 X-40. F50.",
        "G91 G81 X5. Z-3. R-1. L3 F50.\nG80 G90",
        "G99 G81 X-50. Y0. Z-3. R2. F50.\nG80",
        "CYCLE81(5,0,2,-5)\nG0 Z30.",
        'CYCLE800(1,"TC",0,57,0,0,0,0,0,30,0,0,0,1)\nG90 G0 X5. Y5.\nCYCLE800()',
    ],
)
def test_what_is_not_followed_elsewhere_does_no_harm(cycle: str) -> None:
    """Pockets, engraving, a skip, drilling: where the machine stands behind them no reader knows, and none has to."""
    text = HOME.replace("N140 {home}", f"N132 G0 X-40. Y0.\nN134 G1 Z-1. F50.\nN136 {cycle}\nN138 G0 Z25.")
    _, lines = corrected(text, rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0])
    assert f"N136 {cycle}" in "\n".join(lines) and "N80 X64.97" in lines


def test_a_hole_drilled_where_the_lead_ends_is_not_moved() -> None:
    """A canned cycle at the end of a lead would go along unseen: that is refused with its line."""
    text = HOME.format(home="G81 Z-5. R2. F100.")
    with pytest.raises(FormatError, match="part.nc:16: .*canned cycle"):
        corrected(text, rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0])


OVERLAP = """G90G21
G0X20.Y-20.
Z5.
G1Z-2.F100.
G1X20.Y-15.F300.
G3X30.Y-5.R10.
{around}
G1X33.
G3X43.Y-15.R10.
G1Y-20.
G0Z5.
M30
"""
EDGES = {
    "mitred": "G1X65.\nY45.\nX-5.\nY-5.",
    "rolled": "G1X60.\nG3X65.Y0.R5.\nG1Y40.\nG3X60.Y45.R5.\nG1X0.\nG3X-5.Y40.R5.\nG1Y0.\nG3X0.Y-5.R5.",
    "points stated twice": "G1X65.\nX65.Y-5.\nY45.\nY45.\nX-5.\nX-5.Y45.Z-2.\nY-5.",
}


@pytest.mark.parametrize("around", EDGES)
def test_a_contour_that_ends_beyond_its_start_within_an_edge(around: str) -> None:
    """Start and end of the pass are no vertex twice: the contour is closed nevertheless."""
    text = OVERLAP.format(around=EDGES[around])
    excess = 0.03
    program, lines = corrected(text, rectangle(-excess, -excess, 60 + excess, 40 + excess))
    assert "G0X20.Y-19.97" in lines  # the leads go along
    assert "G3X43.Y-14.97R10." in lines
    cut = program.toolpath.take(program.toolpath.kind != Kind.RAPID)
    points = cut.position(np.linspace(0, 1, 9))[:, :, :2].reshape(-1, 2)
    assert points[:, 0].max() == pytest.approx(64.97, abs=1e-3)
    assert points[:, 0].min() == pytest.approx(-4.97, abs=1e-3)
    assert points[:, 1].max() == pytest.approx(44.97, abs=1e-3)


def test_an_arc_that_ends_beyond_its_start() -> None:
    """A ring of two half turns, started within the first and ended beyond it."""
    text = "G0X0Y-20\nZ5\nG1Z-2F100\nG1X0Y-15F300\nG3X0Y15I0J15\nG3X-9Y-12I0J-15\nG3X12Y-9I9J12\nG1X16Y-12\nG0Z5\n"
    program, _ = corrected(text, circle(10.02))
    arcs = program.toolpath.take(program.toolpath.kind == Kind.ARC)
    r = np.hypot(*arcs.position(np.linspace(0, 1, 17))[:, :, :2].reshape(-1, 2).T)
    np.testing.assert_allclose(r, 14.98, atol=1e-3)


STRAIGHT_IN = """%
O7
G21 G90 G17 G40
G0 X-5. Y-20.
G1 Z-3. F200.
Y50. F500.
G2 X10. Y65. R15.
G1 X70.
G2 X85. Y50. R15.
G1 Y10.
G2 X70. Y-5. R15.
G1 X10.
G2 X-5. Y10. R15.
G1 Y20.
G0 Z5.
M30
%
"""


def rounded(excess: float) -> np.ndarray:
    """Points of an 80 x 60 rectangle with corners of radius 10, this much larger, (n, 2)."""
    u = np.linspace(0.0, 1.0, 40)
    a = u[1:-1] * np.pi / 2
    x, y, r = 10 + 60 * u, 10 + 40 * u, 10 + excess
    edges = [(x, -excess + 0 * x), (x, 60 + excess + 0 * x), (-excess + 0 * y, y), (80 + excess + 0 * y, y)]
    corners = [(70, 50, 0), (10, 50, 1), (10, 10, 2), (70, 10, 3)]
    edges += [(cx + r * np.cos(a + k * np.pi / 2), cy + r * np.sin(a + k * np.pi / 2)) for cx, cy, k in corners]
    return np.concatenate([np.column_stack(edge) for edge in edges])


@pytest.mark.parametrize("excess", [0.03, -0.02])
def test_a_lead_that_runs_along_the_first_edge_in_one_move(excess: float) -> None:
    """The stretch of it that cuts the edge is corrected like the others, and the lead goes along."""
    program, lines = corrected(STRAIGHT_IN, rounded(excess))
    assert f"G0 X{-5 + excess:g} Y-20." in lines
    cut = program.toolpath.take(program.toolpath.kind != Kind.RAPID)
    points = cut.position(np.linspace(0.0, 1.0, 33))[:, :, :2].reshape(-1, 2)
    edge = points[(points[:, 0] < 5) & (points[:, 1] > 10) & (points[:, 1] < 50)]
    np.testing.assert_allclose(edge[:, 0], -5 + excess, atol=1e-3)
    assert np.ptp(edge[:, 1]) > 35


def test_a_lead_that_runs_along_the_first_edge_stays_one_line_without_a_correction() -> None:
    _, lines = corrected(STRAIGHT_IN, rounded(0.0), accept=("identical-to-nominal",))
    assert lines == STRAIGHT_IN.splitlines()


@pytest.mark.parametrize("end", ["X-20.\nG0Z5.\nM30", "X-20.\nG91G28Z0.\nG28X0.Y0.\nM30"])
def test_a_path_that_runs_past_its_first_corner_at_both_ends(end: str) -> None:
    """Start below the corner, end beside it: the edges cross and no point is stated twice."""
    text = f"G21G90G40\nG0X-5.Y-20.\nG0Z5.\nG1Z-2.F100.\nG1Y45.F300.\nX65.\nY-5.\n{end}\n"
    program, lines = corrected(text, rectangle(-0.03, -0.01, 60.02, 40.04))
    cut = program.toolpath.end[program.toolpath.kind == Kind.LINE][:, :2]
    expected = [(-4.97, -20.0), (-4.97, 44.96), (64.98, 44.96), (64.98, -4.99), (-20.0, -4.99)]
    np.testing.assert_allclose(cut[: len(expected)], expected, atol=5e-4)
    assert lines[-len(end.splitlines()) :] == end.splitlines()


TABS = """G21G90
G0X-5.Y-20.Z5.
G1Z-3.F200.
{first}.F500.
Z-1.5
Y26.
Z-3.
Y50.
G2X10.Y65.I15.J0.
G1X70.
G2X85.Y50.I0.J-15.
G1Y34.
Z-1.5
Y28.
Z-3.
Y10.
G2X70.Y-5.I-15.J0.
G1X10.
G2X-5.Y10.I0.J15.
{last}
G0Z5.
M2
"""


@pytest.mark.parametrize(("first", "last"), [("Y10.F500.\nY20", "G1X-20."), ("Y20", "G1Y20.\nX-20.")])
def test_tabs_over_which_the_cutter_rises_on_the_spot(first: str, last: str) -> None:
    """The stretches between the tabs are one closed contour, with all of them on the exact parallel."""
    program, _ = corrected(TABS.format(first=first, last=last), rounded(0.03))
    cut = program.toolpath.take(program.toolpath.kind != Kind.RAPID)
    points = cut.position(np.linspace(0.0, 1.0, 33))[:, :, :2].reshape(-1, 2)
    edge = points[(points[:, 1] > 10) & (points[:, 1] < 50) & (points[:, 0] > -5.1)]
    left = edge[:, 0] < 40
    np.testing.assert_allclose(edge[left, 0], -4.97, atol=1e-3)
    np.testing.assert_allclose(edge[~left, 0], 84.97, atol=1e-3)
    assert (program.toolpath.end[:, 2] == -1.5).sum() == 4


def test_the_way_back_above_an_open_edge_is_no_part_of_the_contour() -> None:
    """Two passes over an L-shaped edge, with the way back at feed above the part."""
    once = "Y45.F300.\nX65.\nZ5.\nX-5.Y-5.F2000.\n"
    text = f"G21G90\nG0X-5.Y-5.Z5.\nG1Z-2.F100.\n{once}Z-4.F100.\n{once}G0Z20.\nM2\n"
    y, x = np.linspace(0.5, 39.5, 40), np.linspace(0.5, 64.5, 65)
    points = np.concatenate([np.column_stack([0 * y - 0.02, y]), np.column_stack([x, 0 * x + 40.03])])
    _, lines = corrected(text, points)
    assert lines.count("Y44.97F300.") == 2
    assert [line for line in lines if line.startswith("X-")] == ["X-4.98Y-5.F2000.", "X-5.Y-5.F2000."]


def test_a_contour_in_a_subprogram_that_is_not_there_is_refused_at_its_call() -> None:
    """The line that calls it is named, with what to do; not that nothing is there."""
    text = "O1\nG21G90\nG0X-15.Y-5.\nG1Z-2.F200.\nM98P2\nG90G0Z50.\nM30\n"
    with pytest.raises(
        FormatError, match="part.nc:5: .*O2 is called, which is neither.*write the moves in place of this line"
    ):
        corrected(text, rectangle(0.0, 0.0, 60.0, 40.0))
