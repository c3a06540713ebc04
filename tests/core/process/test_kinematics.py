# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real feed and path: closed forms, published numbers, a convolution by hand, and what must hold for every program."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq, minimize_scalar
from scipy.signal import lfilter

from millcorr.errors import FitError, FormatError, InputError, UsageError
from millcorr.nc import parse
from millcorr.nc.toolpath import Kind
from millcorr.process.kinematics import (
    AxisDynamics,
    ContourControl,
    Control,
    Trace,
    arc_errors,
    arc_shrinkage,
    corner_errors,
    evaluate,
    halts_of,
    identify,
    maintenance_regression,
    motion,
    motions,
    path_errors,
    read_trace,
    schedule,
)
from millcorr.process.kinematics.response import _psi
from tests.core.sweeps import examples, slow

HEAD = "G90 G21 G17|G0 X0 Y0 Z0|"


def program(text: str):
    return parse((HEAD + text).replace("|", "\n") + "\n", "t.nc")


def path(text: str):
    return program(text).toolpath


def linear(time: float, kv: float = math.inf) -> Control:
    return Control.alike(AxisDynamics(time, "linear", kv))


# -- closed forms -----------------------------------------------------------------------------------------------


def test_corner_of_linear_acc_dec():
    # sqrt(2) v T / 8 at v 50 mm/s, T 50 ms; both blocks last longer than T.
    found = corner_errors(path("G1 X20 F3000|Y20"), linear(0.05))
    assert found.error[0] == pytest.approx(math.sqrt(2) * 50 * 0.05 / 8, abs=1e-9)
    assert found.error[0] == pytest.approx(0.4419, abs=5e-5)
    assert found.turn[0] == pytest.approx(math.pi / 2)
    assert found.move.tolist() == [1]


def servo_corner() -> float:
    """Closest approach of a servo to a corner of 90 degrees, times Kv / v: a minimum found by calculus."""
    slope = lambda u: -math.exp(-2 * u) + (u - 1 + math.exp(-u)) * (1 - math.exp(-u))  # noqa: E731
    u = brentq(slope, 0.1, 3.0, xtol=1e-15)
    return math.hypot(math.exp(-u), u - 1 + math.exp(-u))


def test_corner_of_a_servo():
    assert servo_corner() == pytest.approx(0.50886, abs=5e-6)
    # The block before lasts 72 time constants, so its start is forgotten (exp(-36) of it is 2e-16).
    found = corner_errors(path("G1 X20 F1000|Y20"), linear(0.0, 30.0))
    assert found.error[0] == pytest.approx(servo_corner() * (1000 / 60) / 30, abs=1e-9)
    assert found.error[0] == pytest.approx(0.283, abs=5e-4)


def test_corner_and_arc_of_bell_shaped_acc_dec():
    """Its kernel is the triangle over T: sqrt(2) v int_0^(T/2) u w(u) du = sqrt(2) v T / 12; T^2 / 48 v^2 / r."""
    axis = AxisDynamics(0.05, "bell")
    found = corner_errors(path("G1 X30 F3000|Y30"), Control.alike(axis))
    assert found.error[0] == pytest.approx(math.sqrt(2) * 50.0 * 0.05 / 12, abs=1e-9)
    shrunk = 10.0 * (1 - np.sinc(50.0 / 10.0 * 0.025 / (2 * np.pi)) ** 2)
    assert arc_shrinkage(10.0, 50.0, axis) == pytest.approx(shrunk, rel=1e-12)
    assert shrunk == pytest.approx(0.05**2 / 48 * 50.0**2 / 10.0, rel=2e-3)


def test_bell_shaped_acc_dec_limits_the_jerk():
    """From standstill to 50 mm/s in 50 ms: acceleration up to 2 v / T, jerk 4 v / T^2; the way is v (t - T / 2)."""
    plan = schedule(path("G1 X30 F3000"), Control.alike(AxisDynamics(0.05, "bell")))
    t = np.array([0.0125, 0.025, 0.0375, 0.05, 0.3])
    position, speed = evaluate(plan, t)
    jerk = 4 * 50.0 / 0.05**2
    up, down = jerk * t[:2] ** 2 / 2, 50.0 - jerk * (0.05 - t[2:4]) ** 2 / 2
    assert speed[:4, 0] == pytest.approx([*up, *down], abs=1e-8)
    assert position[:2, 0] == pytest.approx(jerk * t[:2] ** 3 / 6, abs=1e-10)
    assert position[4, 0] == pytest.approx(50.0 * (0.3 - 0.025), abs=1e-9)


def test_bell_shaped_acc_dec_after_half_an_hour():
    """Integrals over 1800 s lose no more than 10 nm in the longest numbers, wherever the machine stands."""
    program = path("|".join(["G1 X100 F600|X0"] * 90 + ["G1 X30 F3000"]))
    plan = schedule(program, Control.alike(AxisDynamics(0.05, "bell")))
    begin = plan.begin[-1]
    position, _ = evaluate(plan, np.array([begin + 0.2]))
    assert begin == pytest.approx(1800.0, abs=1e-6)
    assert position[0, 0] == pytest.approx(50.0 * (0.2 - 0.025), abs=1e-5)


def test_exponential_acc_dec_is_a_lag():
    lag = Control.alike(AxisDynamics(0.04, "exponential"))
    found = corner_errors(path("G1 X40 F1800|Y40"), lag)
    assert found.error[0] == pytest.approx(servo_corner() * 30 * 0.04, abs=1e-9)


@given(st.floats(5.0, 175.0))
@settings(max_examples=examples(25), deadline=None)
def test_corner_of_any_angle(degrees):
    # By symmetry a moving mean is nearest half its width behind: |v T / 8 (u2 - u1)| = v T / 4 sin(turn / 2).
    a = math.radians(degrees)
    text = f"G1 X30 F3000|X{30 + 30 * math.cos(a):.9f} Y{30 * math.sin(a):.9f}"
    found = corner_errors(path(text), linear(0.05))
    # A sharp reversal has the vertex's nearest point elsewhere only beyond 120 degrees.
    nearest = minimize_scalar(
        lambda u: np.hypot(
            *(np.array([-1.0, 0.0]) * (1 - u) ** 2 / 2 + np.array([math.cos(a), math.sin(a)]) * u**2 / 2)
        ),
        bounds=(0.0, 1.0),
        method="bounded",
        options={"xatol": 1e-12},
    )
    assert found.error[0] == pytest.approx(50 * 0.05 * nearest.fun, abs=1e-8)
    if degrees < 120:
        assert found.error[0] == pytest.approx(50 * 0.05 / 4 * math.sin(a / 2), abs=1e-8)


def test_arc_shrinkage_and_its_order():
    axis = AxisDynamics(0.064, "linear", 30.0)
    second = (0.064**2 / 24 + (1 / 30) ** 2 / 2) * 50**2 / 10
    assert second == pytest.approx(0.18156, abs=5e-6)
    w = 50 / 10
    sinc = math.sin(w * 0.032) / (w * 0.032)
    exact = 10 * (1 - sinc / math.sqrt(1 + (w / 30) ** 2))
    assert arc_shrinkage(10, 50, axis) == pytest.approx(exact, abs=1e-13)
    # The remainder is of fourth order in the feed: a tenth of the feed, a ten-thousandth of it.
    rest = [second * f**2 - arc_shrinkage(10, 50 * f, axis) for f in (0.2, 0.02)]
    assert rest[0] / rest[1] == pytest.approx(1e4, rel=0.05)
    found = arc_errors(path("G0 X10|G3 I-10 F3000|I-10"), linear(0.064, 30.0))
    # Half a turn is 19 time constants of the servo: exp(-19) of 1.7 mm is 1e-8.
    assert found.shrinkage == pytest.approx([exact, exact], abs=2e-8)
    assert found.radius == pytest.approx([10, 10])


def test_settling_of_a_servo():
    plan = schedule(path("G1 X20 F1800"), linear(0.0, 40.0))
    # 30 mm/s are 0.75 mm behind; within 0.01 mm after ln(75) time constants.
    assert plan.phase[0, 3] == pytest.approx(math.log(75) / 40, abs=1e-9)
    assert plan.duration == pytest.approx(20 / 30 + math.log(75) / 40, abs=1e-9)
    assert evaluate(plan, np.array([plan.duration]))[0][0, 0] == pytest.approx(20 - 0.01, abs=1e-9)


def test_settling_of_linear_acc_dec():
    plan = schedule(path("G1 X20 F1800"), linear(0.05))
    # The last (T - w)^2 v / (2 T) of the way.
    assert plan.phase[0, 3] == pytest.approx(0.05 - math.sqrt(2 * 0.05 * 0.01 / 30), abs=1e-9)


def test_settling_counts_what_came_before_a_short_last_move():
    """X is 0.75 mm behind when its move ends; 0.01 mm of Y later, which only takes 1/3 ms, it still is, nearly."""
    plan = schedule(path("G1 X20 F1800|Y0.01"), linear(0.0, 40.0))
    # Y needs no wait at all: 0.01 mm is the window.
    assert plan.phase[1, 3] == pytest.approx(math.log(75) / 40 - 0.01 / 30, abs=1e-9)
    assert evaluate(plan, np.array([plan.duration]))[0][0, 0] == pytest.approx(20 - 0.01, abs=1e-9)


def test_a_piece_that_takes_no_time_leaves_nothing():
    axis = linear(0.05, 40.0).axes[0]
    none, some = np.array([0.01]), np.array([0.03])
    assert axis.left_of_piece(some, 2 * some, none, none).tolist() == [0.0]
    # Split anywhere, a ramp leaves what it leaves whole.
    whole = axis.left_of_piece(np.array([10.0]), np.array([30.0]), some, none)
    halves = axis.left_of_piece(
        np.array([10.0, 20.0]), np.array([20.0, 30.0]), np.array([0.03, 0.02]), np.array([0.02, 0.01])
    )
    assert halves.sum() == pytest.approx(whole[0], rel=1e-12)


@pytest.mark.parametrize("w", [0.0, 1e-6, 0.3, 0.999, 1.0, 4.0, 60.0])
def test_psi_is_its_integral(w):
    nodes, weights = np.polynomial.legendre.leggauss(60)
    q, dq = (nodes + 1) / 2, weights / 2
    integral = [(w * np.exp(-w * (1 - q)) * q**k * dq).sum() for k in range(6)]
    # Sixty terms of size up to w, each rounded.
    assert _psi(np.array([w]), 5)[:, 0] == pytest.approx(integral, abs=5e-15 * (10 + w))


# -- against a convolution by hand --------------------------------------------------------------------------------


def by_hand(t, times, points, axes, dt=1e-5):
    """Lags as sampled recursions for linear inputs, moving means as differences of sums: a polyline at given times."""
    grid = np.arange(-2.0, times[-1] + 2.0, dt)
    out = np.empty((len(t), 3))
    for k, axis in enumerate(axes):
        y = np.interp(grid, times, points[:, k]) - points[0, k]
        lags = [axis.time] if axis.shape == "exponential" and axis.time else []
        for constant in lags + ([1 / axis.kv] if math.isfinite(axis.kv) else []):
            e = math.exp(-dt / constant)
            f = constant / dt * (1 - e)
            y = lfilter([1 - f, f - e], [1, -e], y)
        means = {"linear": [axis.time], "bell": [axis.time / 2] * 2, "exponential": []}[axis.shape]
        for width in means if axis.time else []:
            total = np.concatenate([[0.0], np.cumsum((y[1:] + y[:-1]) / 2 * dt)])
            y = (total - np.interp(grid - width, grid, total, left=0.0)) / width
        out[:, k] = np.interp(t, grid, y) + points[0, k]
    return out


@pytest.mark.parametrize(
    "axes",
    [
        [AxisDynamics(0.05)] * 3,
        [AxisDynamics(0.05, "linear", 40), AxisDynamics(0.03, "exponential", 30), AxisDynamics(0.02, "exponential")],
        [AxisDynamics(1 / 30, "exponential", 30), AxisDynamics(0.0, "linear", 25), AxisDynamics()],
        [AxisDynamics(0.06, "bell"), AxisDynamics(0.05, "bell", 40), AxisDynamics(0.02, "linear", 30)],
    ],
)
def test_lines_and_arcs_against_a_convolution(axes):
    toolpath = path("G1 X5 Z1 F3000|G3 X8 Y3 I0 J3|G1 Y3.02|Y3.05 X8.01|Y9 F1200|X0 Z0")
    t_arc = np.linspace(0, 1, 4001)
    pieces, times, now = [np.zeros((1, 3))], [np.zeros(1)], 0.0
    for i in range(1, len(toolpath)):
        one = toolpath.take(np.array([i]))
        share = t_arc if one.kind[0] == Kind.ARC else np.array([0.0, 1.0])
        duration = one.length()[0] / one.feed[0]
        pieces.append(one.position(share)[0][1:])
        times.append(now + duration * share[1:])
        now += duration
    plan = schedule(toolpath, Control(*axes))
    t = np.linspace(0, now + 0.3, 401)
    wanted = by_hand(t, np.concatenate(times), np.concatenate(pieces), axes)
    # By hand: the chords of the arc err by 1e-7 mm, a grid of 10 us at kinks of 50 mm/s by v dt^2 / T / 8 = 2e-8 mm.
    assert evaluate(plan, t)[0] == pytest.approx(wanted, abs=3e-7)


def test_speed_is_the_derivative():
    axes = AxisDynamics(0.05, "linear", 40), AxisDynamics(0.03, "exponential", 30), AxisDynamics(0.05, "bell", 60)
    for contour in (None, ContourControl(5.0)):
        toolpath = path("G1 X5 F3000|G3 X8 Y3 I0 J3|G5 I0 J2 P-1 Q-2 X10 Y9 F1500|G1 X0 Z1")
        plan = schedule(toolpath, Control(*axes, contour))
        t = np.linspace(0.0, plan.duration, 300)[1:-1]
        h = 1e-6
        ahead, behind = evaluate(plan, t + h)[0], evaluate(plan, t - h)[0]
        # The speed's slope is at most 2 v / T: over 1 us that is 0.005 mm/s at a kink.
        assert evaluate(plan, t)[1] == pytest.approx((ahead - behind) / (2 * h), abs=6e-3)


def test_spline_runs_at_its_feed():
    toolpath = path("G5 I3 J10 P-8 Q1 X20 Y3 F1200")
    plan = schedule(toolpath, Control.alike(AxisDynamics()))
    points = toolpath.position(np.linspace(0, 1, 200_001))[1]
    length = np.hypot(*np.diff(points[:, :2], axis=0).T).sum()
    assert plan.moves.length[1] == pytest.approx(length, abs=1e-7)
    t = np.linspace(0.001, length / 20 - 0.001, 50)
    assert np.sqrt((evaluate(plan, t)[1] ** 2).sum(axis=1)) == pytest.approx(np.full(50, 20.0), abs=1e-3)


# -- what holds for every program ----------------------------------------------------------------------------------

shapes = st.sampled_from(["linear", "exponential"])
times = st.just(0.0) | st.floats(1e-3, 0.1)
gains = st.just(math.inf) | st.floats(15.0, 200.0)
dynamics = st.builds(AxisDynamics, times, shapes, gains)
contours = st.none() | st.builds(ContourControl, st.floats(0.5, 50.0))
points = st.tuples(*[st.integers(-2000, 2000).map(lambda k: k / 100)] * 3)


@st.composite
def polylines(draw):
    vertices = draw(st.lists(points, min_size=1, max_size=8))
    feeds = draw(st.lists(st.integers(60, 6000), min_size=len(vertices), max_size=len(vertices)))
    lines = [f"G1 X{x} Y{y} Z{z} F{f}" for (x, y, z), f in zip(vertices, feeds, strict=True)]
    toolpath = path("|".join(lines))
    return toolpath if toolpath.length()[1:].max() > 0.02 else path("G1 X1 F600")


@given(polylines(), dynamics, dynamics, dynamics, contours)
@settings(max_examples=examples(60), deadline=None)
def test_displacement_is_conserved_and_time_runs_on(toolpath, x, y, z, contour):
    control = Control(x, y, z, contour)
    plan = schedule(toolpath, control)
    rest = np.array([-1.0, plan.duration + control.memory + 1.0])
    position, speed = evaluate(plan, rest)
    assert position[0] == pytest.approx([0, 0, 0], abs=1e-9)
    assert position[1] == pytest.approx(toolpath.end[-1], abs=1e-9)
    assert np.abs(speed).max() < 1e-9
    m = motion(toolpath, control, step=0.01)
    assert (np.diff(m.t) > 0).all() and m.t[0] == 0 and m.t[-1] == plan.duration
    assert (np.diff(m.s) >= -1e-9).all() and m.s[-1] <= toolpath.length()[1:].sum() + 1e-9
    assert (np.diff(m.move) >= 0).all()
    assert np.abs(m.points[-1] - toolpath.end[-1]).max() <= control.in_position + 1e-9
    # Kernels of unit area: no faster than the command.
    limit = np.nanmax(toolpath.feed[1:]) * math.sqrt(3)
    assert m.feed.max() <= limit * (1 + 1e-9)


@given(st.lists(st.integers(1, 3000), min_size=1, max_size=6, unique=True), dynamics, contours)
@settings(max_examples=examples(30), deadline=None)
def test_straight_lines_stay_straight_where_axes_are_equal(places, axis, contour):
    lines = [f"G1 X{3 * p / 100:.2f} Y{4 * p / 100:.2f} Z{-p / 100:.2f} F{300 + p}" for p in places]
    m = motion(path("|".join(lines)), Control.alike(axis, contour), step=0.005)
    across = np.cross(m.points, np.array([3.0, 4.0, -1.0]) / math.sqrt(26.0))
    assert np.abs(across).max() < 1e-9


@given(polylines(), st.floats(8e-3, 0.2), gains, contours)
@settings(max_examples=examples(40), deadline=None, derandomize=True)
def test_bell_shaped_acc_dec_arrives_and_speeds_add_up(toolpath, time, kv, contour):
    """At rest before and behind; never faster than commanded, its kernel is positive. 1e-8 mm: see `SHORTEST_BELL`."""
    control = Control.alike(AxisDynamics(time, "bell", kv), contour)
    plan = schedule(toolpath, control)
    position, speed = evaluate(plan, np.array([-1.0, plan.duration + control.memory + 1.0]))
    assert position[0] == pytest.approx([0, 0, 0], abs=1e-9)
    assert position[1] == pytest.approx(toolpath.end[-1], abs=1e-8)
    assert np.abs(speed).max() < 1e-7
    m = motion(toolpath, control, step=0.01)
    assert m.feed.max() <= np.nanmax(toolpath.feed[1:]) * math.sqrt(3) * (1 + 1e-6)


@given(polylines(), dynamics, st.sampled_from([0.5, 2.0, 4.0]))
@settings(max_examples=examples(30), deadline=None)
def test_twice_as_large_and_twice_as_fast_is_twice_the_motion(toolpath, axis, k):
    control = Control.alike(axis)
    larger = toolpath.with_moves(start=toolpath.start * k, end=toolpath.end * k, feed=toolpath.feed * k)
    a, b = schedule(toolpath, control), schedule(larger, control)
    t = np.linspace(0.0, a.duration, 50)
    assert evaluate(b, t)[0] == pytest.approx(k * evaluate(a, t)[0], abs=1e-9)


@given(polylines(), st.floats(0.5, 50.0))
@settings(max_examples=examples(60), deadline=None)
def test_contour_control_keeps_its_limits(toolpath, change):
    contour = ContourControl(change)
    plan = schedule(toolpath, Control.alike(AxisDynamics(), contour))
    start, middle, end = plan.speed.T
    length, feed = plan.moves.length[plan.row], toolpath.feed[plan.row]
    ways = plan.phase[:, 0] * (start + middle) / 2 + plan.phase[:, 1] * middle + plan.phase[:, 2] * (middle + end) / 2
    assert ways == pytest.approx(length, rel=1e-9)
    assert start[0] == 0 and end[-1] == 0
    assert end[:-1] == pytest.approx(start[1:], abs=1e-9)
    assert (middle <= feed * (1 + 1e-12)).all()
    first, last = (d[plan.row] for d in plan.moves.directions())
    jump = np.abs(end[:-1, None] * last[:-1] - start[1:, None] * first[1:])
    assert jump.max(initial=0.0) <= change * (1 + 1e-9)
    # No ramp is shorter than the share of the maintenance time that its change of speed is of the whole one.
    for k, other in ((0, start), (2, end)):
        full = plan.phase[:, k] >= contour.time(feed) * (middle - other) / feed * (1 - 1e-9)
        assert full.all()


def test_blocks_do_not_show(monkeypatch):
    text = "|".join(f"G1 X{math.cos(a) * 5:.4f} Y{math.sin(a) * 5:.4f} F1500" for a in np.linspace(0, 6, 120))
    toolpath = path(text + "|G0 X0 Y20|G1 X5|G3 X8 Y23 J3")
    control = Control.alike(AxisDynamics(0.03, "exponential", 40.0, 100.0), ContourControl(3.0))
    whole = motion(toolpath, control), corner_errors(toolpath, control), path_errors(toolpath, control)
    monkeypatch.setattr(sys.modules["millcorr.process.kinematics.motion"], "_BLOCK", 7)
    parts = motion(toolpath, control), corner_errors(toolpath, control), path_errors(toolpath, control)
    assert len(list(motions(schedule(toolpath, control)))) > 10
    for a, b in zip(whole, parts, strict=True):
        for name in a.__slots__:
            # What is forgotten is below 1e-17 of it; sums begin elsewhere.
            assert getattr(b, name) == pytest.approx(getattr(a, name), abs=1e-9, nan_ok=True), name


# -- path errors ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("contour", [None, ContourControl(4.0)])
def test_path_error_is_the_distance_from_the_path(contour):
    toolpath = path("G1 X5 F3000|G3 X8 Y3 J3|G1 Y6|G5 I0 J3 P0 Q-4 X15 Y15 F2000|G1 X20 Y14|X30 Y20 F4000")
    control = Control.alike(AxisDynamics(0.05, "linear", 40.0), contour)
    found = path_errors(toolpath, control)
    line = shapely.LineString(toolpath.take(np.arange(1, 7)).position(np.linspace(0, 1, 2001))[:, :, :2].reshape(-1, 2))
    actual = evaluate(schedule(toolpath, control), found.t)[0][:, :2]
    wanted = shapely.distance(line, shapely.points(actual))
    # Chords of 2000 to a curve of 15 mm err by less than 2e-6 mm.
    assert np.abs(found.value) == pytest.approx(wanted, abs=2e-6)
    assert found.foot + found.value[:, None] * found.normal == pytest.approx(actual, abs=2e-6)
    assert (np.diff(found.move) >= 0).all()


def test_path_error_of_a_corner_and_its_sign():
    # The corner turns left, so the path is cut on the left: v T / 8 off either line.
    found = path_errors(path("G1 X20 F3000|Y20"), linear(0.05))
    assert found.value.max() == pytest.approx(50 * 0.05 / 8, abs=1e-5)
    assert found.value.min() > -1e-9
    assert path_errors(path("G1 X20 F3000|Y-20"), linear(0.05)).value.min() == pytest.approx(-50 * 0.05 / 8, abs=1e-5)


def test_path_error_of_a_circle():
    found = path_errors(path("G0 X10|G3 I-10 F3000"), linear(0.064, 30.0))
    middle = found.value[len(found) // 2]
    assert middle == pytest.approx(arc_shrinkage(10, 50, AxisDynamics(0.064, "linear", 30.0)), abs=2e-8)


# -- the paper --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("feed", "time"), [(300, 0.041086), (900, 0.044806)])
def test_first_stage_takes_the_published_time(feed, time):
    contour = ContourControl(2.0)
    assert contour.time(feed / 60) == pytest.approx(time, abs=1e-12)
    # X to Y by 90 degrees as in the paper: down to the corner feed before C, up again behind it.
    plan = schedule(path(f"G1 X30 F{feed}|Y30"), Control.alike(AxisDynamics(0.03), contour))
    assert plan.speed[0, 2] == pytest.approx(2.0)
    assert plan.phase[0, 2] == pytest.approx(time)
    assert plan.phase[1, 0] == pytest.approx(time)
    # Two stages: the command falls to the corner feed along X, then the axes' own acc/dec overlap.
    found = corner_errors(path(f"G1 X30 F{feed}|Y30"), Control.alike(AxisDynamics(0.03), contour))
    assert found.error[0] < math.sqrt(2) * feed / 60 * 0.03 / 8


def test_five_points_without_contour_control_match_three_points_with_it():
    # dat-2025, fig. 6. BC and CD last longer than the overlap of 30 ms, so only the corner feed mixes at C. With
    # contour control the mixing ramps add a T^2 / 24 at either side, which feeds constant over BC do not.
    five = corner_errors(path("G1 X29.9 F300|X30 F120|Y0.1|Y30 F300"), linear(0.03))
    assert five.error[0] == pytest.approx(math.sqrt(2) * 2.0 * 0.03 / 8, abs=1e-9)
    three = corner_errors(path("G1 X30 F300|Y30"), Control.alike(AxisDynamics(0.03), ContourControl(2.0)))
    ramp = 3.0 / ContourControl(2.0).time(5.0)
    u = 0.015
    # Half the overlap before C is still on the ramp: mean of v u + a u^2 / 2 over it.
    expected = math.sqrt(2) * (2.0 * u**2 / 2 + ramp * u**3 / 6) / 0.03
    assert three.error[0] == pytest.approx(expected, abs=1e-9)
    assert three.error[0] == pytest.approx(five.error[0], rel=0.2)


# -- stops, dwells, what is left out ----------------------------------------------------------------------------------


def test_exact_stop_takes_the_corner_off_the_list():
    for text in ("G61|G1 X20 F3000|Y20|G64", "G1 G9 X20 F3000|Y20", "G1 X20 F3000|M8|Y20", "G1 X20 F3000|G4 X0.5|Y20"):
        p = program(text)
        halts = halts_of(p)
        assert not len(corner_errors(p.toolpath, linear(0.05), halts=halts)), text
        assert np.abs(path_errors(p.toolpath, linear(0.05), halts=halts).value).max() <= 0.01
    p = program("G61|G1 X20 F3000|G64|Y20|X0")
    assert corner_errors(p.toolpath, linear(0.05), halts=halts_of(p)).move.tolist() == [2]


def test_dwell_takes_its_time():
    def duration(text, unit=None):
        p = program(text)
        return schedule(p.toolpath, linear(0.05), halts_of(p, unit)).duration

    stopped = duration("G1 X20 F3000|G9 X20|G4|Y20")
    assert duration("G1 X20 F3000|G4 X1.5|Y20") == pytest.approx(stopped + 1.5)
    assert duration("G1 X20 F3000|G4 P1500|Y20", "ms") == pytest.approx(stopped + 1.5)
    assert duration("G1 X20 F3000|G4 P2|Y20", "s") == pytest.approx(stopped + 2.0)
    with pytest.raises(FormatError, match=r"t\.nc:4: controls differ on whether P1500"):
        duration("G1 X20 F3000|G4 P1500|Y20")
    with pytest.raises(FormatError, match=r"t\.nc:4: this dwell"):
        duration("G1 X20 F3000|G4 P1 X1.|Y20", "s")
    with pytest.raises(UsageError, match="dwells is s or ms"):
        duration("G1 X20 F3000", "min")


def test_rapids_count_where_their_speed_is_known():
    toolpath = path("G1 X10 F600|G0 X10 Y30 Z40|G1 X20")
    without = motion(toolpath, linear(0.05))
    assert without.omitted.tolist() == [0, 2]
    known = Control(AxisDynamics(0.05, rapid=100.0), AxisDynamics(0.05, rapid=60.0), AxisDynamics(0.05, rapid=50.0))
    within = schedule(toolpath, known)
    assert within.omitted.tolist() == [0]
    # Z is the slower axis of 40 mm at 50 mm/s; Y would need 0.5 s.
    assert within.phase[1, :3].sum() == pytest.approx(0.8)
    # The machine stands at both sides of what is left out, and goes on from there.
    assert without.points[-1] == pytest.approx([20, 30, 40], abs=0.011)
    assert set(np.round(without.y[without.move == 3], 5)) == {30.0}


def test_unknown_places_are_not_invented():
    p = parse("G90 G21\nG1 Z5 F300\nX1 Y1\nX5\nY5\n", "t.nc")
    m = motion(p.toolpath, linear(0.02))
    assert m.omitted.tolist() == [0, 1]
    assert np.isfinite(m.x).all()
    p = parse("G90 G21\nG0 X0 Y0\nG1 X5 F300\n", "t.nc")
    assert np.isnan(motion(p.toolpath, linear(0.02)).z).all()


def test_refusals_name_the_line():
    with pytest.raises(FormatError, match=r"t\.nc:4: with G41"):
        schedule(path("G1 X1 F600|G41 D1 X5 Y5|X9"), linear(0.05), name="t.nc")
    with pytest.raises(FormatError, match=r"t\.nc:3: the feed is not known"):
        schedule(path("G1 X10"), linear(0.05), name="t.nc")
    with pytest.raises(InputError, match="no move can be followed"):
        schedule(path("G0 X10"), linear(0.05))
    with pytest.raises(InputError, match="halts"):
        schedule(path("G1 X10 F100"), linear(0.05), halts_of(program("G1 X1 F100|X2")))
    with pytest.raises(UsageError, match="longer step"):
        motion(path("G1 X10 F1"), linear(0.05), step=1e-6)
    for wrong in (
        lambda: motion(path("G1 X1 F60"), linear(0.05), step=0.0),
        lambda: path_errors(path("G1 X1 F60"), linear(0.05), step=-1.0),
        lambda: AxisDynamics(-1.0),
        lambda: AxisDynamics(0.1, "round"),
        lambda: AxisDynamics(1e-4),
        lambda: AxisDynamics(4e-3, "bell"),
        lambda: AxisDynamics(kv=0.0),
        lambda: AxisDynamics(kv=1e5),
        lambda: AxisDynamics(rapid=-1.0),
        lambda: ContourControl(0.0),
        lambda: ContourControl(1.0, 0.0, 0.0),
        lambda: Control.alike(AxisDynamics(), None, 0.0),
    ):
        with pytest.raises(UsageError):
            wrong()


def test_mean_feed_of_moves():
    m = motion(path("G1 X40 F3000|X40.5|X80"), linear(0.05))
    mean = m.mean_feed(4)
    assert math.isnan(mean[0])
    assert mean[2] == pytest.approx(50.0, abs=1e-9)


# -- traces and constants -----------------------------------------------------------------------------------------

CORNER = path("G1 X10 F3000|Y10")


def logged(control, *, feed=False, step=0.004, noise=0.002, outliers=0, toolpath=CORNER):
    rng = np.random.default_rng(5)
    plan = schedule(toolpath, control)
    t = np.arange(-0.1, plan.duration + 0.2, step)
    position, speed = evaluate(plan, t)
    position += rng.normal(size=position.shape) * noise
    position[rng.integers(0, len(t), outliers)] += 0.5
    position[:, 2] = np.nan
    actual = np.hypot(speed[:, 0], speed[:, 1]) + rng.normal(size=len(t)) * 50 * noise
    none = np.full(len(t), np.nan)
    return Trace(t + 17.3, np.full((len(t), 3), np.nan) if feed else position, actual if feed else none, "log.csv")


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("truth", "guess", "fit", "wanted"),
    [
        (linear(0.05, 40), linear(0.03, 60), ("time", "kv"), (0.05, 40.0)),
        (
            Control(AxisDynamics(0.05), AxisDynamics(0.06), AxisDynamics()),
            linear(0.02),
            ("x.time", "y.time"),
            (0.05, 0.06),
        ),
        (
            Control.alike(AxisDynamics(0.05, "exponential", 40.0)),
            Control.alike(AxisDynamics(0.02, "exponential", 40.0)),
            ("time",),
            (0.05,),
        ),
        (
            Control.alike(AxisDynamics(0.05), ContourControl(8.0)),
            Control.alike(AxisDynamics(0.03), ContourControl(5.0, 0.0, 0.03)),
            ("time", "contour.time", "contour.speed_change"),
            (0.05, 50 * 0.0062e-3 * 60 + 0.039226, 8.0),
        ),
    ],
)
@pytest.mark.parametrize("feed", [slow(False), True])
def test_constants_are_found_again(truth, guess, fit, wanted, feed):
    constants_are_found_again(truth, guess, fit, wanted, feed)


@pytest.mark.thorough
def test_lag_and_servo_are_found_in_positions():
    constants_are_found_again(linear(0.05, 40), linear(0.03, 60), ("time", "kv"), (0.05, 40.0), False)


def constants_are_found_again(truth, guess, fit, wanted, feed):
    found = identify(logged(truth, feed=feed, outliers=0 if feed else 8), CORNER, guess, fit)
    for name, value in zip(fit, wanted, strict=True):
        constant = found.constants[name]
        assert constant.uncertainty < 0.1 * value
        # Four standard uncertainties: one of 16000 by chance.
        assert abs(constant.value - value) < 4 * constant.uncertainty
    assert found.start == pytest.approx(17.3, abs=1e-3)
    again = corner_errors(CORNER, found.control).error
    assert again == pytest.approx(corner_errors(CORNER, truth).error, rel=0.05)


@pytest.mark.parametrize("fit", [("time",), slow(("kv",)), slow(("time", "kv"))])
def test_constants_of_a_steady_move_are_refused(fit):
    steady = logged(linear(0.05, 40), toolpath=path("G1 X100 F3000"))
    middle = (steady.t > 17.8) & (steady.t < 18.8)
    steady = Trace(steady.t[middle], steady.position[middle], steady.feed[middle], "log.csv")
    with pytest.raises(FitError, match=r"log\.csv: "):
        identify(steady, path("G1 X100 F3000"), linear(0.03, 60), fit)


@pytest.mark.thorough
def test_constants_that_a_trace_does_not_determine_are_refused():
    truth = linear(0.05, 40)
    whole = logged(truth)
    with pytest.raises(FitError, match="mm: the trace is not one of this program"):
        identify(whole, path("G1 X-10 F3000|Y-10"), linear(0.03, 60), ("time", "kv"))
    # The move along X says nothing on Y.
    only_x = logged(truth, toolpath=path("G1 X3 F3000"))
    with pytest.raises(FitError, match="does not determine y.time"):
        identify(only_x, path("G1 X3 F3000"), linear(0.03, 40), ("x.time", "y.time"))
    with pytest.raises(FitError, match="samples every 0.04 s are too few"):
        identify(logged(truth, step=0.04, noise=1e-5), CORNER, linear(0.03, 40), ("time",))


def test_constants_that_cannot_be_told_apart_are_refused():
    trace = logged(linear(0.05))
    for control, fit, message in (
        (Control.alike(AxisDynamics(0.05, "exponential", 40.0)), ("time", "kv"), "two lags"),
        (linear(0.05), ("jerk",), "no constant"),
        (linear(0.05), ("time", "x.time"), "same constant"),
        (linear(0.05), ("contour.time",), "contour control"),
        (linear(0.05), (), "once"),
        (linear(0.05), ("time", "time"), "once"),
    ):
        with pytest.raises(UsageError, match=message):
            identify(trace, CORNER, control, fit)


def test_regression_of_the_maintenance_time():
    feed = np.array([5.0, 10.0, 15.0, 20.0])
    slope, intercept = maintenance_regression(feed, ContourControl(1.0).time(feed))
    assert slope.value == pytest.approx(0.0062e-3 * 60)
    assert intercept.value == pytest.approx(39.226e-3)
    # Four points, residuals +-1 ms in turn: standard errors by the textbook.
    time = np.array([1.0, -1.0, -1.0, 1.0]) * 1e-3
    slope, intercept = maintenance_regression(feed, time)
    sigma = math.sqrt(4e-6 / 2)
    assert slope.uncertainty == pytest.approx(sigma / math.sqrt(125.0))
    assert intercept.uncertainty == pytest.approx(sigma * math.sqrt(1 / 4 + 12.5**2 / 125.0))
    with pytest.raises(FitError, match="three feeds"):
        maintenance_regression(np.array([5.0, 5.0, 10.0]), np.ones(3))


def written(tmp_path, text):
    file = tmp_path / "log.csv"
    file.write_bytes(text.encode())
    return file


def rows(n=30, form="{t},{x},{y}"):
    return "\n".join(form.format(t=k, x=k * 0.5, y=-k) for k in range(n)) + "\n"


def test_traces_are_read(tmp_path):
    trace = read_trace(written(tmp_path, "# servo log\nx [inch]; Time[ms]; note; y\n" + rows(form="{x};{t};ok;{y}")))
    assert trace.t == pytest.approx(np.arange(30) * 1e-3)
    assert trace.position[:, 0] == pytest.approx(np.arange(30) * 12.7)
    assert trace.position[:, 1] == pytest.approx(-np.arange(30.0))
    assert np.isnan(trace.position[:, 2]).all() and np.isnan(trace.feed).all()
    trace = read_trace(written(tmp_path, "t\tfeed\n" + rows(form="{t}\t{x}")))
    assert trace.feed == pytest.approx(np.arange(30) * 0.5 / 60)
    trace = read_trace(written(tmp_path, "t,v[mm/s]\r\n" + rows(form="{t},{x}\r")))
    assert trace.feed == pytest.approx(np.arange(30) * 0.5)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        ("# only\n", "no samples"),
        ("a,b\n1,2\n", ":1: expected a header"),
        ("t,x\n" + rows(form="{t},{x}"), ":1: expected a header"),
        ("t,t,feed\n", ":1: column t appears twice"),
        ("t[h],feed\n", ":1: unit 'h' of column t"),
        ("t,x,y\n" + rows(5), "5 samples are too few"),
        ("t,x,y\n" + rows() + "31,abc,2\n", ":32: 'abc' is no number"),
        ("t,x,y\n" + rows() + "31,2\n", ":32: 2 fields under a header of 3"),
        ("t,x,y\n" + rows() + "29,1,2\n", ":32: the time does not increase"),
        ("t,x,y\n" + rows() + "90,1,2\n", ":32: samples are missing"),
        ("t,x,y\n" + rows() + "31,1e999,2\n", "too large"),
    ],
)
def test_traces_that_cannot_be_trusted(tmp_path, text, message):
    with pytest.raises(FormatError, match=r"log\.csv") as caught:
        read_trace(written(tmp_path, text))
    assert message in str(caught.value)


def test_a_missing_trace(tmp_path):
    with pytest.raises(FormatError, match="cannot be read"):
        read_trace(tmp_path / "none.csv")
