# SPDX-License-Identifier: LGPL-2.1-or-later
"""Correction wholly a priori: against closed forms, the paper's part and the simulated machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.correction.settings import Settings
from millcorr.errors import FormatError, RefusedError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.cutting import average_force
from millcorr.process.engagement import stock_of
from millcorr.process.kinematics import AxisDynamics, Control, arc_shrinkage, motion
from millcorr.process.prediction import simulate
from millcorr.process.prediction.cutter_reach import profile_of_path, reachable
from millcorr.process.prediction.elastic_pass import elastic_pass
from millcorr.process.prediction.real_feed import EVEN, RealFeed, control_of, times
from millcorr.process.setup_file import from_dict
from millcorr.virtual.simulated_machine import SimulatedMachine
from tests.core.paper_2023 import LEFT, RADIUS, as_cut, cut_again, nominal, program, setup, softer

WALL = Profile.from_contours([Contour((NurbsCurve.line((60, -10), (-60, -10)),), False)])
"""Material below y = -10."""

STRAIGHT = "G21 G90 G17\nG0 X-60 Y0\nG0 Z5\nG1 Z-10 F400\nG1 X60\nG0 Z20\nM30\n"


def predicted(text=None, its=None, profile=None, **chosen):
    source = program() if text is None else program(text)
    wanted = replace(LEFT, method="predicted", **chosen)
    return pipeline.correct(pipeline.Request(source, RADIUS, None, profile, wanted, setup=its or setup()))


# --- closed forms


def test_wall_is_corrected_by_its_own_force():
    """The path goes as much deeper as the force of the whole depth bends: delta = F(45.57 degrees) / k, exactly."""
    entry = np.pi - np.arccos(1 - 3.0 / 10.0)
    its = setup()
    fz = 400 / 60 / its.tool.tooth_frequency
    bends = average_force(entry, np.pi, 10.0, fz, 6, its.material)[1] / 1200.0
    result = predicted(STRAIGHT, profile=WALL, iterate=5e-4)
    middle = np.abs(result.deviation.foot[:, 0]) < 30
    applied = result.correction.at(result.deviation.stretch, result.deviation.s, result.nominal)
    # The bound, and the depth that it changes the force by.
    assert applied[middle] == pytest.approx(-bends, abs=6e-4)
    assert np.abs(result.predicted[middle]).max() <= 5e-4
    # Not iterated: MS of what stays, carried to the whole depth, is that but for the curve of force over depth.
    once = predicted(STRAIGHT, profile=WALL)
    applied = once.correction.at(once.deviation.stretch, once.deviation.s, once.nominal)
    assert applied[middle] == pytest.approx(-bends, rel=0.02)


def test_profile_of_a_shifted_path_is_shifted():
    """An even displacement stays what it is, on a line and round a circle."""
    ring = Profile.from_contours([Contour((NurbsCurve.arc((30, 0), (30, 0), (0, 0), 2 * np.pi),), True)])
    for profile in (WALL, ring):
        s = np.arange(0.25, float(profile.total[0]), 0.5)
        got = profile_of_path(profile, np.zeros(len(s), dtype=np.int64), s, np.full(len(s), -0.2), 10.0)[2]
        # Steps of uneven length at the ring's seam turn the normals by some 1e-4 rad: R 1e-8 / 2.
        assert got == pytest.approx(-0.2, abs=1e-6)


def test_profile_of_an_inclined_path():
    """A path that runs off at a slope m has its surface at R / cos = R sqrt(1 + m^2) below it: v = m s + R - that."""
    s = np.arange(0.25, 120.0, 0.25)
    m = 0.05
    got = profile_of_path(WALL, np.zeros(len(s), dtype=np.int64), s, m * (s - 60.0) / 10.0, 10.0)[2][: len(s)]
    wanted = m * (s - 60.0) / 10.0 + 10.0 * (1.0 - np.sqrt(1 + (m / 10.0) ** 2))
    inner = (s > 5) & (s < 115)
    assert got[inner] == pytest.approx(wanted[inner], abs=1e-7)


def test_crease_is_rounded_by_the_cutter():
    """Of a V of slopes -m and m a cutter leaves R m^2 / 2 at the tip (to second order), and touches the flanks."""
    s = np.arange(0.0, 120.01, 0.125)
    m, radius = 0.04, 10.0
    v = m * np.abs(s - 60.0)
    got = reachable(WALL, np.zeros(len(s), dtype=np.int64), s, v, radius)
    left = got - v
    assert left.min() >= -1e-12
    # A share of 0.9 of the curvature, and softened twice over steps of h, which adds curvature times h^2 / 2.
    exact = radius * m**2 / 2
    assert exact < left.max() < exact / 0.9 + 0.9 / radius * 0.125**2 / 2 * 1.05
    assert np.abs(left[np.abs(s - 60.0) > radius * m / 0.9 + 0.5]).max() < 1e-12
    assert np.gradient(np.gradient(got, s), s).max() <= 1.0 / radius


# --- the paper's part, and another program


def test_paper_a_priori():
    assert as_cut().largest == pytest.approx(0.3, abs=0.005)
    once = predicted()
    assert once.prediction.after[-1].largest <= 0.09
    result = predicted(iterate=0.01)
    assert cut_again(result.text, setup()).largest <= 0.0105
    assert result.prediction.after[-1].largest <= 0.01
    assert result.verification.path_error_max <= 0.001
    summary = result.summary()
    assert summary["foreseen"]["predicted_before"] == pytest.approx(0.3, abs=0.005)
    assert summary["points"]["used"] == len(result.deviation)
    # Nothing was measured, and the program says so.
    assert b"PREDICTED FROM PETRAKOV-2023.TOML" in result.text.upper()


def test_simulated_machine_agrees():
    """Another program closes the loop by delta = MS (H - delta), with MS from the rigid force: within 2 %."""
    from millcorr.process.cutting import cutting
    from millcorr.process.engagement import engagement

    its = softer(3000.0, 2000.0)
    source = program(STRAIGHT)
    simulation = simulate(source, its, WALL)
    rigid = cutting(engagement(source.toolpath, its, stock_of(its, WALL)), its)
    ms = float((rigid.force[20] / (3000.0, 2000.0))[1]) / 3.0
    machine = SimulatedMachine(allowance=3.0, transfer=ms)
    inside = np.abs(simulation.deviation.foot[:, 0]) < 40
    other = machine.cut(source.toolpath, RADIUS, WALL, seed=1).deviation(0, simulation.deviation.s)
    assert other[inside].min() > 0.03
    assert np.abs(simulation.deviation.value / other - 1)[inside].max() < 0.02
    # And the corrected program leaves next to nothing on that machine, too.
    corrected = predicted(STRAIGHT, its, WALL, iterate=1e-3)
    again = machine.cut(nc.parse(corrected.text, "c.nc").toolpath, RADIUS, WALL, seed=1)
    assert np.abs(again.deviation(0, simulation.deviation.s)[inside]).max() < 0.02 * other.max() + 1e-3


def test_sharp_inner_corner():
    """Where the cutter stands in a corner the load is 5.71 times as large: (1 - cos 135.57) / (1 - cos 45.57)."""
    text = STRAIGHT.replace("G1 X60\n", "G1 X0\nG1 Y60\n")
    result = predicted(text, softer(6000.0, 6000.0))
    e = result.prediction.before.elastic
    # acos(0.7) and 90 degrees more; a little less on a machine that gives way.
    assert np.degrees(e.engagement.phi.max()) == pytest.approx(135.57, abs=0.5)
    assert result.prediction.before.largest > 0.1
    assert result.prediction.after[-1].largest < 0.03


def test_bound_that_cannot_be_reached_is_refused():
    """A crease that the cutter rounds stays: 0.2 um are not to be had on this part."""
    with pytest.raises(RefusedError, match="more than --iterate 0.0002"):
        predicted(iterate=0.0002)


# --- real feed


def test_real_feed_keeps_the_path():
    """The parts of the moves put together are the program; each runs at the mean of the actual motion's speed."""
    source = program().toolpath
    control = Control.alike(AxisDynamics(time=0.1, kv=30.0))
    moved = motion(source, control)
    real = RealFeed.of(source, moved)
    feeds = np.isfinite(real.toolpath.feed)
    assert len(real.toolpath) > len(source)
    assert real.toolpath.length()[feeds].sum() == pytest.approx(source.length()[np.isfinite(source.feed)].sum())
    joined = np.flatnonzero(np.diff(real.move) == 0)
    assert real.toolpath.end[joined] == pytest.approx(real.toolpath.start[joined + 1], abs=1e-12)
    arcs = np.flatnonzero(real.toolpath.sweep)
    assert real.toolpath.sweep[arcs].sum() == pytest.approx(source.sweep.sum())
    # At steady speed the feed is the programmed one; it begins from standstill.
    first = np.flatnonzero(real.move == int(np.flatnonzero(source.kind > 0)[1]))
    assert real.toolpath.feed[first[0]] < 0.85 * 400 / 60
    longest = first[np.argmax((real.end - real.begin)[first])]
    assert real.toolpath.feed[longest] == pytest.approx(400 / 60, rel=EVEN)


def test_times_are_those_of_the_motion():
    """A move of 50 mm at 400 mm/min takes 7.5 s, and the tool is late by the mean delay."""
    source = program().toolpath
    control = Control.alike(AxisDynamics(time=0.1, kv=30.0))
    moved = motion(source, control)
    row = float(np.flatnonzero(source.kind > 0)[1])
    t = times(source, moved, np.array([row + 0.25, row + 0.75]))
    assert np.diff(t) == pytest.approx(25.0 / (400 / 60), abs=2e-3)


def test_load_follows_the_real_feed():
    """Force is in proportion to the chip where there is no edge force: half the feed, half the force."""
    its = setup()
    slow = STRAIGHT.replace("F400", "F200")
    a, b = (simulate(program(text), softer(1e6, 1e6), WALL).elastic for text in (STRAIGHT, slow))
    assert b.cutting.resultant[20] == pytest.approx(a.cutting.resultant[20] / 2, rel=1e-3)
    lagging = replace(its, machine=replace(its.machine, acceleration_time_x_ms=200.0, acceleration_time_y_ms=200.0))
    found = simulate(program(STRAIGHT), lagging, WALL)
    e = found.elastic.engagement
    assert found.motion is not None
    assert e.feed_per_tooth[0] < 0.85 * e.feed_per_tooth[20]
    assert e.feed_per_tooth[20] == pytest.approx(400 / 60 / its.tool.tooth_frequency, rel=1e-3)


# --- what cannot be


BAD = [
    ("machine", "kx_n_per_mm", 0.0, "kx_n_per_mm"),
    ("machine", "ky_n_per_mm", 1.2, "ky_n_per_mm"),
    ("tool", "overhang_mm", 4.0, "overhang_mm"),
    ("machine", "acceleration_time_x_ms", 0.05, "acceleration_time_x_ms"),
    ("machine", "position_gain_per_s", 2000.0, "position_gain_per_s"),
]


@pytest.mark.parametrize("table, key, value, named", BAD)
def test_bad_setups_name_the_key(table, key, value, named):
    """Zero stiffness, stiffness in N/um, overhang shorter than the cut, seconds for milliseconds."""
    with pytest.raises((FormatError, RefusedError, UsageError)) as raised:
        simulate(program(), with_key(table, key, value), nominal())
    assert named in str(raised.value) and "\n" not in str(raised.value)


def test_missing_stock_and_stiffness_are_named():
    with pytest.raises(FormatError, match=r"\[stock\]"):
        with_key("stock", "allowance_mm", None)
    with pytest.raises(UsageError, match=r"^setup\.toml: \[machine\] kx_n_per_mm is missing"):
        simulate(program(), with_key("machine", "kx_n_per_mm", None), nominal())


def with_key(table, key, value):
    import tomllib

    from tests.core.paper_2023 import SETUP

    data = tomllib.loads(SETUP.read_text(encoding="utf-8"))
    if value is None:
        del data[table][key]
    else:
        data[table][key] = value
    return from_dict(data, "setup.toml")


def test_side_must_be_known():
    with pytest.raises(UsageError, match="--side"):
        pipeline.correct(pipeline.Request(program(), RADIUS, None, None, Settings(method="predicted"), setup=setup()))


def test_contour_control_of_a_setup():
    """slope in ms per mm/min is 0.06 s per mm/s; the corner feed keeps each axis within the speed change allowed."""
    its = setup()
    its = replace(its, machine=replace(its.machine, contour_control=True, contour_speed_change_mm_min=120.0))
    control = control_of(its)
    assert control is not None and control.contour is not None
    # dat-2025, eq. 1: 0.0062 * 300 + 39.226 ms.
    assert control.contour.time(300.0 / 60.0) == pytest.approx(41.086e-3, rel=1e-12)
    square = nc.parse("G21 G90 G17\nG0 X0 Y0\nG1 X20 F1200\nG1 Y20\n")
    moved = motion(square.toolpath, control)
    corner = np.argmin(np.hypot(moved.x - 20.0, moved.y))
    # Both axes change by the whole feed at a right angle: 120 mm/min of 1200; within a sample of 1 ms of the ramp.
    assert moved.feed[corner] == pytest.approx(2.0, abs=18.0 / (0.0062 * 1200 + 39.226))
    assert moved.feed.max() == pytest.approx(20.0, rel=1e-9)


def test_exponential_acceleration_of_a_setup():
    its = setup()
    its = replace(its, machine=replace(its.machine, acceleration_time_x_ms=20.0, acceleration_shape="exponential"))
    control = control_of(its)
    assert control is not None and control.x.shape == "exponential" and control.x.delay == pytest.approx(0.02)


def test_loop_of_the_simulation_is_the_elastic_pass():
    its = setup()
    alone = elastic_pass(program().toolpath, its, stock_of(its, nominal()))
    assert as_cut().elastic.deflection == pytest.approx(alone.deflection, abs=1e-12)


# --- what the axes leave


def light(radius=3.0, **machine):
    """A cut that bends nothing to speak of, on a machine with inertia."""
    return from_dict(
        {
            "tool": {"diameter_mm": 2 * radius, "flutes": 4, "spindle_rpm": 12000},
            "material": {"ktc_n_per_mm2": 600, "krc_n_per_mm2": 200},
            "machine": {"kx_n_per_mm": 1e7, "ky_n_per_mm": 1e7, **machine},
            "stock": {"allowance_mm": 0.5, "axial_depth_mm": 2},
        }
    )


TURNS = "G21 G90 G17\nG0 X10 Y0\nG0 Z0\nG3 X10 Y0 I-10 J0 F3000\nG3 X10 Y0 I-10 J0\nG3 X10 Y0 I-10 J0\nG0 Z5\n"
INERTIA = {"acceleration_time_x_ms": 64.0, "acceleration_time_y_ms": 64.0, "position_gain_per_s": 30.0}


@pytest.mark.few(1)
@pytest.mark.parametrize("side, sign", [("left", 1.0), ("right", -1.0)])
def test_arcs_shrink_by_the_closed_form(side, sign):
    """r (1 - |H(v / r)|) = 0.17809 mm, within 0.1 um: left of a hole's wall too much stays, right of a disc too little.

    The first turn, in which the axes still speed up, is cut again.
    """
    circle = nc.parse(TURNS, "turns.nc")
    profile = pipeline.nominal_from_program(circle, 3.0, Settings(side=side), None)
    found = simulate(circle, light(**INERTIA), profile)
    wanted = sign * float(arc_shrinkage(10.0, 50.0, AxisDynamics(0.064, kv=30.0)))
    # Start and end of the path lie at X10: there the tool speeds up and settles.
    away = found.deviation.foot[:, 0] < 0.0
    assert away.sum() > 100
    assert found.kinematic[away] == pytest.approx(wanted, abs=1e-4)
    assert found.deviation.value[away] == pytest.approx(wanted, abs=3e-4)
    assert np.median(np.hypot(*found.centre.T)) == pytest.approx(10.0 - abs(wanted), abs=1e-4)


def test_corners_are_rounded_by_the_envelope_of_the_cutter():
    """The lowest of all circles along the sampled motion, 10 um apart; the tool is off by sqrt 2 v T / 8 = 0.147 mm."""
    square = nc.parse("G21 G90 G17\nG0 X-20 Y0\nG0 Z0\nG1 X0 F1000\nG1 Y20\nG0 Z5\n", "square.nc")
    profile = pipeline.nominal_from_program(square, 3.0, Settings(side="left"), None)
    found = simulate(square, light(acceleration_time_x_ms=50.0, acceleration_time_y_ms=50.0), profile)
    moved = motion(square.toolpath, Control.alike(AxisDynamics(0.05)), step=0.01 / (1000 / 60))
    d = found.deviation
    wall = np.flatnonzero((d.normal[:, 1] > 0.9) & (d.foot[:, 0] > -2.0))
    assert len(wall) > 10
    for row in wall:
        beside = moved.x - d.foot[row, 0]
        near = np.abs(beside) < 3.0
        lowest = (moved.y[near] - np.sqrt(9.0 - beside[near] ** 2)).min() + 3.0
        assert found.kinematic[row] == pytest.approx(lowest, abs=1e-4)
    # What the cutter's radius leaves of it at the end of the wall, far below the tool's own error.
    assert 0.015 < found.kinematic[wall].max() < 0.5 * np.sqrt(2) * (1000 / 60) * 0.05 / 8
    assert found.kinematic[np.abs(d.foot).max(axis=1) > 5.0] == pytest.approx(0.0, abs=1e-4)


def test_correction_takes_out_what_arcs_lose():
    """A hole's wall: 0.178 mm of shrinkage, corrected until at most 10 um are left."""
    circle = nc.parse(TURNS, "turns.nc")
    wanted = Settings(side="left", method="predicted", iterate=0.01)
    slow = light(**{**INERTIA, "position_gain_per_s": 60.0})
    done = pipeline.correct(pipeline.Request(circle, 3.0, None, None, wanted, setup=slow)).prediction
    assert done is not None
    assert done.before.largest > 0.05 and done.after[-1].largest <= 0.01


def test_without_inertia_the_axes_leave_nothing():
    assert not as_cut().kinematic.any()
    assert (as_cut().centre == as_cut().elastic.centre).all()


def test_a_height_that_is_never_stated_changes_nothing():
    """The same path with and without a Z word: what the axes leave of the wall, corner and arc included."""
    text = "G21 G90 G17\nG0 X0 Y0\nG0 Z0\nG1 X20 F900\nG1 Y20\nG3 X15 Y25 I-5 J0\nG1 X0\n"
    inert = light(acceleration_time_x_ms=50.0, acceleration_time_y_ms=50.0, position_gain_per_s=40.0)
    found = []
    for source in (text, text.replace("G0 Z0\n", "")):
        part = nc.parse(source, "part.nc")
        found.append(simulate(part, inert, pipeline.nominal_from_program(part, 3.0, Settings(side="left"), None)))
    stated, never = found
    assert never.kinematic == pytest.approx(stated.kinematic, abs=1e-6)
    assert 0.0 < stated.kinematic.max() < 0.1


@pytest.mark.thorough
def test_what_the_axes_leave_at_a_corner_is_named():
    """No moved path takes out what a corner loses within a few tenths of a millimetre: the remedy is the feed."""
    square = nc.parse("G21 G90 G17\nG0 X-20 Y0\nG0 Z0\nG1 X0 F1000\nG1 Y20\nG0 Z5\n", "square.nc")
    inert = light(acceleration_time_x_ms=50.0, acceleration_time_y_ms=50.0)
    wanted = Settings(side="left", method="predicted", iterate=0.002)
    with pytest.raises(RefusedError, match=r"more than --iterate 0\.002, which the axes leave: lower the feed"):
        pipeline.correct(pipeline.Request(square, 3.0, None, None, wanted, setup=inert))
