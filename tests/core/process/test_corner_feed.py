# SPDX-License-Identifier: LGPL-2.1-or-later
"""Five-point corners: within the bound by the model, nothing else changed, refused where there is no room."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.errors import FormatError, LimitError, UsageError
from millcorr.nc import parse
from millcorr.process.kinematics import AxisDynamics, ContourControl, Control, corner_errors, halts_of
from millcorr.process.prediction.corner_feed import slow_corners
from tests.core.sweeps import examples

SQUARE = """%
O100 (SQUARE)
G90 G21 G17
G0 X0 Y0 Z5
G1 Z0 F300 M8
N10 G1 X20 F900 (SIDE)
N20 Y20
N30 G3 X15 Y25 I-5 J0
N40 G1 X0 Y25
N50 Y0 M5
M30
%
"""
LINEAR = Control.alike(AxisDynamics(0.05))


def program(text: str):
    return parse(text, "t.nc")


def line_string(toolpath):
    points = toolpath.position(np.linspace(0, 1, 201))[:, :, :2].reshape(-1, 2)
    return shapely.LineString(points[np.isfinite(points).all(axis=1)])


def same_path(a, b, tolerance):
    """Each path lies wholly within the tolerance of the other (a buffer's polygon lies inside the true one)."""
    one, other = line_string(a), line_string(b)
    return one.buffer(tolerance).covers(other) and other.buffer(tolerance).covers(one)


@pytest.mark.parametrize(
    "control",
    [
        LINEAR,
        Control.alike(AxisDynamics(0.05, "linear", 40.0)),
        Control.alike(AxisDynamics(0.03, "exponential", 40.0)),
        Control.alike(AxisDynamics(0.05), ContourControl(10.0)),
    ],
)
def test_corners_come_within_the_bound(control):
    p = program(SQUARE)
    result = slow_corners(p, control, 0.01)
    assert result.line.tolist() == [6, 9]
    assert (result.before > 0.01).all() and (result.after <= 0.01).all()
    back = program(result.data.decode())
    found = corner_errors(back.toolpath, control, halts=halts_of(back))
    assert found.error.max() <= 0.01
    assert result.duration[1] > result.duration[0]
    # Same path: B and D lie on it to the rounding of their coordinates.
    assert same_path(back.toolpath, p.toolpath, 1e-3)


def test_feed_and_distances_of_the_paper():
    # 900 mm/min, T 50 ms: the error of 132.6 um falls with the feed; BC and CD last T.
    result = slow_corners(program(SQUARE), LINEAR, 0.01)
    feed = result.feed[0]
    assert feed * 60 == pytest.approx(round(feed * 60))
    assert feed == pytest.approx(15 * 0.98 * 0.01 / (math.sqrt(2) * 15 * 0.05 / 8), abs=1 / 60)
    # B and D are rounded to 0.1 um: that is all that differs from the closed form.
    assert result.after == pytest.approx(math.sqrt(2) * result.feed * 0.05 / 8, abs=1e-7)
    text = result.data.decode()
    distance = feed * 0.05
    assert f"N10 G1 X{20 - distance:.4f}".rstrip("0") + " F900 (SIDE)\nX20 F66\n" in text
    assert f"N20 Y{distance:.4f}".rstrip("0") + "\nY20 F900\n" in text


def test_nothing_else_changes():
    result = slow_corners(program(SQUARE), LINEAR, 0.01)
    kept = result.data.decode().splitlines()
    for line in SQUARE.splitlines():
        if not line.startswith(("N10", "N20", "N40", "N50")):
            assert line in kept
    assert "N50 Y0 F900 M5" in kept


def test_a_program_within_the_bound_stays_as_it_is():
    p = program(SQUARE)
    result = slow_corners(p, LINEAR, 0.2, header=("slowed",))
    assert result.data == p.data
    assert not len(result.line)
    assert result.duration[0] == result.duration[1]
    stopped = program(SQUARE.replace("N10 G1", "G61\nN10 G1"))
    assert slow_corners(stopped, LINEAR, 0.001).data == stopped.data


def test_blocks_too_short_are_refused():
    text = SQUARE.replace("N20 Y20", "N20 Y0.02\nN21 X19\nN22 Y20\nX20")
    with pytest.raises(LimitError, match=r"t\.nc:6: the corner is off by .* um and cannot .*: its blocks are too"):
        slow_corners(program(text), LINEAR, 0.01)
    result = slow_corners(program(text), LINEAR, 0.01, partial=True)
    assert [u.line for u in result.untreated] == [6, 7]
    assert len(result.line) and not {6, 7} & set(result.line.tolist())
    assert (result.after <= 0.01).all()


def test_splines_and_vanishing_feeds_are_refused():
    text = SQUARE.replace("N20 Y20", "N20 G5 I0 J5 P5 Q0 X10 Y20").replace("N30 G3 X15 Y25 I-5 J0", "G1 X10 Y25")
    with pytest.raises(LimitError, match="one of its blocks is a spline"):
        slow_corners(program(text), LINEAR, 0.01)
    with pytest.raises(LimitError, match="below the smallest step"):
        slow_corners(program(SQUARE), LINEAR, 1e-5)
    with pytest.raises(UsageError, match="above 0"):
        slow_corners(program(SQUARE), LINEAR, 0.0)
    with pytest.raises(FormatError, match="G41"):
        slow_corners(program(SQUARE.replace("N10 G1", "N10 G41 D1 G1")), LINEAR, 0.01)


def test_arcs_are_divided():
    text = SQUARE.replace("N30 G3 X15 Y25 I-5 J0", "N30 G2 X25 Y25 I5 J0").replace("N40 G1 X0 Y25", "N40 G1 X25 Y40")
    p = program(text)
    assert corner_errors(p.toolpath, LINEAR, halts=halts_of(p)).move.tolist() == [2, 4, 5]
    result = slow_corners(p, LINEAR, 0.01)
    assert 8 in result.line
    back = program(result.data.decode())
    assert result.data.count(b"G2") + result.data.count(b"G02") >= 1
    assert same_path(back.toolpath, p.toolpath, 1e-3)
    assert (result.after <= 0.01).all()


def test_inch_programs():
    text = "G90 G20 G17\nG0 X0 Y0 Z0\nG1 X1. F40.\nY1.\nX0\n"
    result = slow_corners(program(text), LINEAR, 0.01)
    inches = result.feed * 60 / 25.4
    assert inches == pytest.approx(np.round(inches, 1), abs=1e-9)
    assert (result.after <= 0.01).all() and len(result.after) == 2


@given(
    st.lists(st.tuples(st.integers(-40, 40), st.integers(-40, 40)), min_size=3, max_size=6, unique=True),
    st.integers(200, 4000),
    st.sampled_from([0.005, 0.02, 0.1]),
    st.sampled_from([AxisDynamics(0.04), AxisDynamics(0.02, "linear", 50.0), AxisDynamics(0.02, "exponential")]),
)
@settings(max_examples=examples(25), deadline=None)
def test_any_polyline(vertices, feed, bound, axis):
    lines = "".join(f"X{x} Y{y}\n" for x, y in vertices)
    text = f"G90 G21 G17\nG0 X50 Y50 Z0\nG1 F{feed}\n{lines}"
    control = Control.alike(axis)
    p = program(text)
    result = slow_corners(p, control, bound, partial=True)
    back = program(result.data.decode())
    found = corner_errors(back.toolpath, control, halts=halts_of(back))
    over = (found.error > bound).sum()
    assert over <= len(result.untreated)
    assert (result.after <= bound).all()
    if not result.untreated:
        assert found.error.max(initial=0.0) <= bound
