# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shift and tilt of a wall: the paper's corner, geometry of the axes, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc
from millcorr.errors import InputError, LimitError, RefusedError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.deflection.height_error import WallModel
from millcorr.process.deflection.real_path import real_path
from millcorr.process.deflection.tilt import mean_shift, remedies
from millcorr.process.deflection.tilt_axes import tilted, words
from millcorr.process.engagement import stock_of
from millcorr.process.kinematics import AxisDynamics, Control
from millcorr.process.setup_file import Tilt, load
from tests.core.sweeps import examples

PAPER = load(Path(__file__).resolve().parents[3] / "resources" / "setups" / "dat-2025.toml")
HEIGHTS = np.array([0.5, 1.0, 1.5, 2.0])
HOLLOW = Profile.from_contours(
    [Contour((NurbsCurve.line((5, 60), (5, -5)), NurbsCurve.line((5, -5), (-60, -5))), False)]
)
"""Inner corner of the part, to the right of the paper's path along +X, then +Y."""
CORNER = "G90 G17 G21 F300\nG0 X-25 Y0 Z5\nG1 Z0\nG1 X0\nG1 Y25\nG0 Z5\n"
APART = (
    "%\nG90 G17 G21 F300\nG0 X-25 Y0 Z5\nG1 Z0\nG1 X-4 (first wall)\nG0 Z5\n"
    "G0 X0 Y6\nG1 Z0\nG1 Y25 ; second\nG0 Z5\nM2\n%\n"
)
BOTH = Tilt("AB", tool_centre_point=True)


def error_of(text, control=None, heights=HEIGHTS):
    path = real_path(nc.parse(text).toolpath, control, spacing=0.1 if control is None else 0.02)
    return WallModel.of(path, PAPER, stock_of(PAPER, HOLLOW)).errors(heights)


def test_paper_corner_25_um_fall_to_3():
    error = error_of(CORNER)
    found = remedies(error, HOLLOW)
    assert len(found.number) == 2
    assert found.before[:, 0] == pytest.approx([0.025, 0.025], abs=1e-4)
    # Error over the height falls towards the top: a falling curve, as in figure 13 without correction.
    assert (np.diff(found.before, axis=1) < 0).all()
    assert found.worst[:, 0].max() == pytest.approx(0.025, abs=1e-4)
    assert found.worst[:, 1].max() > 0.010
    assert found.worst[:, 2].max() <= 0.003
    assert np.abs(found.after.mean(axis=1)).max() < 1e-6
    # The wall leans by its own slope: what a straight line through the errors has.
    slope = np.polyfit(HEIGHTS, found.before[0], 1)[0]
    assert found.lean == pytest.approx(-slope, rel=0.02)
    assert found.floor == pytest.approx(5.0 * np.sin(found.lean), rel=1e-12)
    assert "tilt +0.9" in found.lines()[0]


def test_a_straight_error_is_tilted_away_altogether():
    """Two heights: a line goes through them, so that nothing is left but what the closed loop leaves."""
    found = remedies(error_of(CORNER, heights=[0.5, 2.0]), HOLLOW)
    assert found.worst[:, 2].max() < 2e-6


def test_with_acceleration_the_corner_itself_keeps_an_error():
    """Where the tool is slow its chips are thin, and it bends less than the tilt of the stretch allows for."""
    slow = error_of(CORNER, Control.alike(AxisDynamics(0.05, "linear", 40.0)))
    feed = slow.model.engagement.feed_per_tooth
    # Both axes at half their speed: 1 / sqrt 2 of the feed is the least in a corner of 90 degrees.
    assert feed.min() < 0.075 * 0.75 and feed.max() == pytest.approx(0.075, rel=1e-3)
    least = int(np.argmin(feed[50:-50])) + 50
    assert slow.value[least, 0] < 0.8 * np.nanmax(slow.value[:, 0])
    found = remedies(slow, HOLLOW)
    assert np.abs(found.after).max() <= 0.003
    assert found.worst[:, 2].max() > 0.003


def test_mean_shift_is_a_correction():
    error = error_of(CORNER)
    correction, _ = mean_shift(error, HOLLOW, limit=0.5)
    s = np.array([45.0, 75.0])
    value = correction.at(np.array([0, 1]), s, HOLLOW)
    # The shift makes the cut deeper by what it takes: less than a thousandth more than the mean here.
    assert value == pytest.approx(-np.nanmean(error.value, axis=1)[100], rel=2e-3)
    with pytest.raises(LimitError):
        mean_shift(error, HOLLOW, limit=0.005)


def test_one_height_has_no_slope():
    with pytest.raises(InputError, match="two heights"):
        remedies(error_of(CORNER, heights=[0.5]), HOLLOW)


def turned(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]] if axis == "A" else [[c, 0, s], [0, 1, 0], [-s, 0, c]])


@given(st.sampled_from(["AB", "BA"]), st.floats(-np.pi, np.pi), st.floats(-0.3, 0.3))
@settings(max_examples=examples(100), deadline=None, derandomize=True)
def test_words_turn_the_tool_along_the_normal(order, direction, lean):
    """Rotations multiplied out: the carrying one on the left."""
    normal = np.array([np.cos(direction), np.sin(direction)])
    angles = words(Tilt(order, limit_deg=30.0, decimals=6), normal, lean)
    axis = turned(order[0], angles[order[0]]) @ turned(order[1], angles[order[1]]) @ [0.0, 0.0, 1.0]
    assert axis == pytest.approx([*(np.sin(lean) * normal), np.cos(lean)], abs=2e-8)


def test_words_in_the_program():
    error = error_of(APART)
    program = nc.parse(APART, "apart.nc")
    text = tilted(program, error, remedies(error, HOLLOW), BOTH).decode()
    changed = [(a, b) for a, b in zip(APART.splitlines(), text.splitlines(), strict=True) if a != b]
    # The first wall's normal is +Y: the tool's upper end leans there by turning -A; the second's is -X: -B.
    angle = changed[0][1].partition(" A")[2].split()[0]
    assert float(angle) == pytest.approx(-0.91, abs=0.01)
    assert [b for _, b in changed] == [
        f"G1 Z0 A{angle} B0",
        "G0 Z5 A0 B0",
        f"G1 Z0 A0 B{angle}",
        "G0 Z5 A0 B0",
    ]


def test_a_b_axis_alone_tilts_walls_along_y_only():
    second = APART.replace("G1 X-4 (first wall)\n", "")
    error = error_of(second)
    only_b = Tilt("B", b_sign=-1, tool_centre_point=True)
    text = tilted(nc.parse(second), error, remedies(error, HOLLOW), only_b).decode()
    assert "G1 Z0 B0.9" in text and " A" not in text
    first = error_of(APART)
    with pytest.raises(RefusedError, match="has no axis A"):
        tilted(nc.parse(APART), first, remedies(first, HOLLOW), only_b)


def test_refusals():
    error = error_of(CORNER)
    remedy = remedies(error, HOLLOW)
    with pytest.raises(RefusedError, match=r"no \[tilt\] table"):
        tilted(nc.parse(CORNER), error, remedy, None)
    with pytest.raises(RefusedError, match="tool centre point"):
        tilted(nc.parse(CORNER), error, remedy, Tilt("AB"))
    with pytest.raises(RefusedError, match="line 5: the tool has to turn before this wall"):
        tilted(nc.parse(CORNER), error, remedy, BOTH)
    with pytest.raises(RefusedError, match="beyond"):
        tilted(nc.parse(CORNER), error, remedy, Tilt("AB", limit_deg=0.5, tool_centre_point=True))


def test_a_wall_that_bends_is_not_tilted():
    text = "G90 G17 G21 F300\nG0 X-25 Y0 Z5\nG1 Z0\nG1 X-5\nG3 X0 Y5 I0 J5\nG1 Y25\nG0 Z5\n"
    round_ = Profile.from_contours(
        [
            Contour(
                (
                    NurbsCurve.line((5, 60), (5, 5)),
                    NurbsCurve.arc((5, 5), (-5, -5), (-5, 5), -np.pi / 2),
                    NurbsCurve.line((-5, -5), (-60, -5)),
                ),
                False,
            )
        ]
    )
    path = real_path(nc.parse(text).toolpath, spacing=0.1)
    error = WallModel.of(path, PAPER, stock_of(PAPER, round_)).errors(HEIGHTS)
    remedy = remedies(error, round_)
    assert len(remedy.number) == 1 and remedy.worst[0, 2] <= 0.003
    with pytest.raises(RefusedError, match="line 5: a wall that bends"):
        tilted(nc.parse(text), error, remedy, BOTH)
