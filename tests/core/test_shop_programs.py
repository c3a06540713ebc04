# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs as shops write them, with parts whose errors are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import gcode, pipeline
from millcorr.errors import FormatError
from millcorr.measurement import Measurement
from millcorr.toolpath import Kind


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


def corrected(text: str, points: np.ndarray, tool: float = 10.0, **settings) -> tuple[gcode.Program, list[str]]:
    """The corrected program, and its lines without the header."""
    program = gcode.parse(text, "part.nc")
    chosen = pipeline.Settings(**({"filter": "none"} | settings))
    result = pipeline.correct(pipeline.Request(program, tool / 2, part(points), None, chosen))
    lines = result.text.decode().splitlines()
    return gcode.parse(result.text, "out.nc"), [line for line in lines if not line.lower().startswith("(m")]


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


def test_a_hole_drilled_where_the_lead_ends_is_not_moved() -> None:
    """A canned cycle at the end of a lead would go along unseen: that is refused with its line."""
    text = HOME.format(home="G81 Z-5. R2. F100.")
    with pytest.raises(FormatError, match="part.nc:16: .*canned cycle"):
        corrected(text, rectangle(0.0, 0.0, 60.0, 40.0) + [0.03, 0.0])
