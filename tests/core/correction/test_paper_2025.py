# SPDX-License-Identifier: LGPL-2.1-or-later
"""Petrakov & Romanov 2025, recomputed from its raw numbers: touch points, programs and measured ball centres.

Cutter of 16 mm, ball of radius 3; y of tables 2, 3, 6 and 7 is that of the ball's centre at x = 35, 50, 65, 80.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.correction.transfer_function import identify
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.readers.measurement import Measurement
from tests.core.loop_programs import EDGE as TABLE_1

X = np.array([35.0, 50.0, 65.0, 80.0])
CUTTER, BALL = 8.0, 3.0
TOUCHED = ((24.0, 59.114), (86.0, 95.299))
"""Ball centres on the rough edge, fig. 2."""

COMMANDED_2 = np.array([62.987, 71.741, 80.496, 89.250])
MEASURED_2 = np.array([63.091, 71.845, 80.601, 89.353])
COMMANDED_6 = np.array([64.639, 73.396, 82.154, 90.911])
MEASURED_6 = np.array([64.714, 73.471, 82.229, 90.987])
MS_2, MS_6 = ("0.05485", "0.05485", "0.05541", "0.05430"), ("0.08108", "0.08108", "0.08108", "0.08225")

SLOPE = (TOUCHED[1][1] - TOUCHED[0][1]) / (TOUCHED[1][0] - TOUCHED[0][0])
ALPHA = np.arctan(SLOPE)


def program(start: str, end: str) -> str:
    """The paper's program with other Y words."""
    return TABLE_1.replace("Y53.582", f"Y{start}").replace("Y111.947", f"Y{end}")


SERIAL = program("51.266", "109.631")
"""Table 1, H = 2 mm."""
FIRST_HALF = program("52.913", "111.301")
"""Table 5."""
FINISH = program("51.755", "110.143")
"""The second half without a correction: the first half's program 1 mm deeper along the normal, 1/cos alpha along Y."""
FIGURE_4 = program("51.661", "110.049")


def line(text: str) -> tuple[float, float]:
    """Y at X0 and slope of the path that a program cuts."""
    (y0,), ((x1, y1),) = re.findall(r"G0X5Y([\d.]+)", text), re.findall(r"G1X([\d.]+)Y([\d.]+)F516", text)
    slope = (float(y1) - float(y0)) / (float(x1) - 5.0)
    return float(y0) - 5.0 * slope, slope


def ball_centres(text: str) -> np.ndarray:
    """Where the ball's centre would be on the edge that a program cuts without an error, at X."""
    y, slope = line(text)
    return y + slope * X - (CUTTER - BALL) * np.hypot(1.0, slope)


def corrected(text: str, y: np.ndarray, **settings: object) -> pipeline.Result:
    points = np.column_stack([X, y, np.full(4, -10.0)])
    measurement = Measurement(points, None, BALL, np.arange(1, 5), "probe.csv", "ab" * 32)
    chosen = pipeline.Settings(
        **({"method": "transfer", "depth_along": "y", "transfer_function": "one", "filter": "none"} | settings)  # type: ignore[arg-type]
    )
    return pipeline.correct(pipeline.Request(nc.parse(text, "edge.nc"), CUTTER, measurement, None, chosen))


def body(result: pipeline.Result) -> str:
    """The program without the comments that name its correction."""
    return "".join(t for t in result.text.decode().splitlines(keepends=True) if not t.startswith("("))


def test_angle_of_the_part() -> None:
    assert np.degrees(ALPHA) == pytest.approx(30.269, abs=5e-4)


def test_programs_of_table_1() -> None:
    """Eqs. (1) and (2): a path R - r - H off the touched edge. The paper rounds alpha to 30.27 and so to 2 um."""
    for x, printed in ((5.0, 53.582), (105.0, 111.947)):
        y = TOUCHED[0][1] + (x - TOUCHED[0][0]) * SLOPE + (CUTTER - BALL - 0.2) / np.cos(ALPHA)
        assert y == pytest.approx(printed, abs=0.002)
        # The 2 mm are cut after the 0.2 mm: the path moves by 2/cos alpha along Y, to the printed digit.
        assert f"Y{printed - 2.0 / np.cos(ALPHA):.3f}" in SERIAL


@pytest.mark.parametrize(
    ("text", "printed", "within"),
    # The single piece's y lie on a line of slope 0.58382, its program has 0.58388: 3 um over the length measured.
    [(SERIAL, COMMANDED_2, 0.001), (FIRST_HALF, COMMANDED_6, 0.0032)],
)
def test_commanded_ball_centres(text: str, printed: np.ndarray, within: float) -> None:
    np.testing.assert_allclose(ball_centres(text), printed, atol=within)
    # The same from millcorr's own contour: the printed centres are a ball's radius over it.
    nominal = pipeline.nominal_from_program(nc.parse(text), CUTTER, pipeline.Settings(side="left"), None)
    feet = FootPointSearch(nominal, margin=5.0).find(np.column_stack([X, printed]))
    np.testing.assert_allclose(feet.distance, BALL, atol=within)


@pytest.mark.parametrize(
    ("measured", "commanded", "depth", "printed", "mean"),
    [(MEASURED_2, COMMANDED_2, 2.0, MS_2, "0.05485"), (MEASURED_6, COMMANDED_6, 1.0, MS_6, "0.08137")],
)
def test_transfer_function_to_the_printed_digit(measured, commanded, depth, printed, mean) -> None:
    """Tables 2 and 6, eq. (4) with delta along Y and H along the normal."""
    ms = identify(measured - commanded, depth).ms
    assert tuple(f"{value:.5f}" for value in ms) == printed
    assert f"{ms.mean():.5f}" == mean


def test_sign_of_equation_5() -> None:
    """Fig. 4 follows from the first half's program with 1 + MS; the printed 1 - MS gives another program."""
    ms = float(identify(MEASURED_6 - COMMANDED_6, 1.0).ms.mean())
    _, slope = line(FIRST_HALF)
    for start, printed, misprint in ((52.913, "51.661", "51.849"), (111.301, "110.049", "110.237")):
        assert f"{start - (1.0 + ms) * np.hypot(1.0, slope):.3f}" == printed
        assert f"{start - (1.0 - ms) * np.hypot(1.0, slope):.3f}" == misprint


def test_single_piece_program_of_figure_4() -> None:
    """The second half's program comes back with only its Y words changed, to the printed digit."""
    y = ball_centres(FIRST_HALF) + (MEASURED_6 - COMMANDED_6)
    result = corrected(FINISH, y, depth=1.0, next_depth=1.0, allowance=1.0)
    assert body(result) == FIGURE_4
    assert result.elastic is not None
    # The finishing program's words are rounded to 1 um, a thousandth of the depth and of 1 + MS.
    assert result.elastic.transfer.ms == pytest.approx(np.full(4, 0.08137), abs=1e-3 * 1.081 * 0.08)
    assert result.verification.path_error_max <= 0.001


def test_single_piece_program_from_the_measured_centres_alone() -> None:
    """Against its own program, not against table 6, the part shows up to 3 um less: so does the corrected program."""
    result = corrected(FINISH, MEASURED_6, depth=1.0, next_depth=1.0, allowance=1.0)
    delta = MEASURED_6 - ball_centres(FIRST_HALF)
    along_y = (1.0 + float(identify(delta, 1.0).ms.mean())) * np.hypot(1.0, line(FIRST_HALF)[1])
    expected = [52.913 - along_y, 111.301 - along_y]
    words = [float(w) for w in re.findall(r"Y([\d.]+)", body(result))]
    assert words == pytest.approx(expected, abs=0.001)
    assert words == pytest.approx([51.661, 110.049], abs=0.003)


def test_serial_program() -> None:
    """The program of the next parts, which the paper does not print: eq. (5), with its sign put right, on table 1."""
    y = ball_centres(SERIAL) + (MEASURED_2 - COMMANDED_2)
    result = corrected(SERIAL, y, depth=2.0)
    ms = float(identify(MEASURED_2 - COMMANDED_2, 2.0).ms.mean())
    words = [f"{start - 2.0 * (1.0 + ms) / np.cos(ALPHA):.3f}" for start in (53.582, 111.947)]
    assert words == ["51.139", "109.504"]
    assert body(result) == program(*words)


def test_along_the_normal_the_same_data_mean_less() -> None:
    """With delta and H in one direction MS = delta cos alpha / (H - delta cos alpha), 0.0470 in place of 0.0549."""
    y = ball_centres(SERIAL) + (MEASURED_2 - COMMANDED_2)
    result = corrected(SERIAL, y, depth=2.0, depth_along="normal")
    delta = 0.104 * np.cos(ALPHA)
    assert result.elastic is not None
    assert result.elastic.transfer.ms == pytest.approx(np.full(4, delta / (2 - delta)), abs=2e-5)
    assert delta / (2 - delta) == pytest.approx(0.0470, abs=5e-5)
    axis = corrected(SERIAL, y, depth=2.0)
    # 2 mm times 0.054852 - 0.047022.
    assert any("by 15.7 um more on average than --depth-along normal" in note for note in axis.advice)


def test_second_pass_shows_a_constant_offset() -> None:
    """Of the 0.104 mm that the first pass left an elastic machine keeps MS/(1 + MS): 5.4 um. Measured were 15.5."""
    found = identify([0.104], 2.0)
    assert found.error(0.104)[0] == pytest.approx(0.0054, abs=5e-5)


@pytest.mark.parametrize(
    ("text", "commanded", "measured", "printed", "within"),
    [
        # Table 3: a second pass with the same program.
        (SERIAL, COMMANDED_2, [63.003, 71.757, 80.511, 89.265], [0.016, 0.016, 0.015, 0.015], 0.001),
        # Table 7: what the corrected second half left, against the finished edge; the program's slope is 3 um off.
        (
            FINISH,
            [63.481, 72.238, 80.996, 89.753],
            [63.492, 72.249, 81.008, 89.764],
            [0.011, 0.011, 0.012, 0.011],
            0.0032,
        ),
    ],
    ids=["table 3", "table 7"],
)
def test_what_was_left_is_what_a_check_shows(text, commanded, measured, printed, within) -> None:
    """The printed delta, along Y, from the program and the measured ball centres alone."""
    np.testing.assert_allclose(np.subtract(measured, commanded), printed, atol=1e-9)
    result = corrected(text, np.array(measured), method="mirror", depth_along="normal", transfer_function="smooth")
    along_y = result.deviation.value * np.hypot(1.0, line(text)[1])
    np.testing.assert_allclose(along_y, printed, atol=within)


def test_table_4_falls_to_an_eighth() -> None:
    """Serial production: from 0.104 to 0.0125 mm, the eighth that the paper states."""
    left = np.subtract([63.727, 72.475, 81.224, 89.974], [63.714, 72.463, 81.212, 89.961])
    np.testing.assert_allclose(left, [0.013, 0.012, 0.012, 0.013], atol=1e-9)
    assert 8 < (MEASURED_2 - COMMANDED_2).mean() / left.mean() < 8.5
