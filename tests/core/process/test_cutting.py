# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting forces and the closed elastic loop, against closed forms, published numbers and another program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc
from millcorr.comparison.deviation import Deviation
from millcorr.errors import RefusedError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.cutting import (
    average_force,
    chip_thickness,
    cutting,
    force_at,
    force_over_turn,
    surface_location_error,
)
from millcorr.process.engagement import engagement, stock_of
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.prediction import elastic_pass as elastic_pass_module
from millcorr.process.prediction.elastic_pass import (
    cutting_stiffness,
    deviation_along,
    elastic_pass,
    predicted_deviation,
)
from millcorr.process.setup_file import Machine, Material, Setup, Stock, Tool, load
from millcorr.virtual.simulated_machine import SimulatedMachine, reference_contour
from tests.core.sweeps import examples

SETUPS = Path(__file__).resolve().parents[3] / "resources" / "setups"
ALTINTAS = Material("", 767.01, 168.8, 27.7, 26.6)
CHIP_ONLY = Material("", 2000.0, 600.0)


def path(text):
    return nc.parse("G90 G17 G21 F600\n" + text).toolpath


def contour(*curves, closed=False):
    return Profile.from_contours([Contour(tuple(curves), closed)])


WALL = contour(NurbsCurve.line((500, 0), (-500, 0)))
"""Material below y = 0."""


def setup(kx=20_000.0, ky=20_000.0, material=CHIP_ONLY, rotation="clockwise", allowance=1.0, depth=5.0):
    tool = Tool(10.0, 4, 3000.0, rotation=rotation)
    return Setup(tool, material, Machine(kx, ky), Stock(allowance_mm=allowance, axial_depth_mm=depth))


# --- forces


def test_slotting_forces_of_altintas():
    """N a c / 4 Krc + N a / pi Kre and N a c / 4 Ktc + N a / pi Kte."""
    fx, fy = average_force(0.0, np.pi, 2.0, 0.05, 4, ALTINTAS)
    assert (round(fx, 1), round(fy, 1)) == (-84.6, 147.2)
    assert fx == pytest.approx(-(0.1 * 168.8 + 8 / np.pi * 26.6), rel=1e-14)
    assert fy == pytest.approx(0.1 * 767.01 + 8 / np.pi * 27.7, rel=1e-14)


def test_slotting_forces_along_a_program():
    its = load(SETUPS / "altintas-slot.toml")
    toolpath = path("G0 X0 Y0 Z5\nG1 Z-2\nG1 X30\nG1 Y30")
    found = cutting(engagement(toolpath, its, stock_of(its)), its)
    along, across = found.force[5], found.force[-5]
    assert along == pytest.approx([-84.616, 147.238], abs=1e-3)
    # The second move goes along Y: everything turned by 90 degrees.
    assert across == pytest.approx([-147.238, -84.616], abs=1e-3)
    assert np.isnan(found.wall[5]).all()


angles = st.floats(0.0, np.pi)


@given(angles, angles, st.floats(0.01, 0.3), st.sampled_from([ALTINTAS, CHIP_ONLY]))
@settings(max_examples=examples(50), deadline=None, derandomize=True)
def test_average_is_the_integral(a, b, chip, material):
    """Gauss quadrature of the element's force; 40 nodes integrate these sines to the last digits."""
    entry, exit_ = min(a, b), max(a, b)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    phi = entry + (nodes + 1) / 2 * (exit_ - entry)
    wanted = 4 / (2 * np.pi) * 3.0 * (weights / 2 * (exit_ - entry)) @ force_at(phi, chip, material)
    assert average_force(entry, exit_, 3.0, chip, 4, material) == pytest.approx(wanted, abs=1e-9, rel=1e-9)


@pytest.mark.parametrize("helix", [0.0, 1e-6, 5.0, 30.0, 60.0])
@pytest.mark.parametrize("entry, exit_", [(0.0, np.pi), (2.3, np.pi), (0.0, 1.1), (0.7, 1.9)])
def test_mean_over_a_turn_does_not_depend_on_the_helix(helix, entry, exit_):
    """20000 angles: the edges of a straight tooth's cut are met to within one of them."""
    tool = Tool(10.0, 4, 3000.0, helix)
    turn = (np.arange(20_000) + 0.5) / 20_000 * 2 * np.pi
    force = force_over_turn(turn, entry, exit_, 1.0, 4.0, 0.05, tool, ALTINTAS)
    wanted = average_force(entry, exit_, 3.0, 0.05, 4, ALTINTAS)
    assert np.abs(force.mean(axis=0) - wanted).max() < 1e-3 * np.abs(force).max()


@pytest.mark.parametrize("entry, exit_", [(np.pi - np.arccos(0.8), np.pi), (0.0, np.arccos(0.8))])
def test_straight_edges_without_edge_force_leave_no_error(entry, exit_):
    """Up and down milling: the chip is nothing where the surface is made (Schmitz and Mann 2006)."""
    tool = Tool(10.0, 4, 3000.0)
    height = np.linspace(0.0, 3.0, 7)
    error = surface_location_error(height, entry, exit_, 3.0, 0.05, 1000.0, tool, CHIP_ONLY)
    assert (error == 0.0).all()
    edge = replace(CHIP_ONLY, kre_n_per_mm=10.0)
    # Only the radial edge force stands across the wall there: 10 N/mm over 3 mm away from it.
    error = surface_location_error(height, entry, exit_, 3.0, 0.05, 1000.0, tool, edge)
    assert error == pytest.approx(np.full(7, 0.03), rel=1e-12)
    assert (
        surface_location_error(height, entry, exit_, 3.0, 0.05, 1000.0, Tool(10.0, 4, 3000.0, 30.0), CHIP_ONLY) != 0.0
    ).any()


def test_a_slot_has_no_one_wall():
    with pytest.raises(UsageError, match="one of them"):
        surface_location_error(0.0, 0.0, np.pi, 1.0, 0.05, 1000.0, Tool(10.0, 4, 3000.0), CHIP_ONLY)


def test_down_milling_pushes_off_the_wall_and_up_milling_draws_in():
    toolpath = path("G0 X-30 Y5\nG1 X30")
    down, up = (
        cutting(engagement(toolpath, its, stock_of(its, WALL)), its)
        for its in (setup(), setup(rotation="anticlockwise"))
    )
    assert np.abs(down.wall - (0.0, 1.0)).max() < 1e-12 and np.abs(up.wall - (0.0, 1.0)).max() < 1e-12
    assert (down.normal_force > 0).all() and (up.normal_force < 0).all()
    # Mirrored spindle: the force along the feed swaps entry with exit, the size stays.
    fx, fy = average_force(down.engagement.entry[3], np.pi, 5.0, 0.05, 4, CHIP_ONLY)
    assert down.force[3] == pytest.approx([fx, fy], rel=1e-12)
    fx, fy = average_force(0.0, up.engagement.exit[3], 5.0, 0.05, 4, CHIP_ONLY)
    assert up.force[3] == pytest.approx([fx, -fy], rel=1e-12)


def test_a_move_without_feed_is_refused():
    toolpath = nc.parse("G90 G17 G21\nG0 X0 Y5\nG1 X30").toolpath
    its = setup()
    with pytest.raises(UsageError, match="has no feed"):
        cutting(engagement(toolpath, its, stock_of(its, WALL)), its)


@given(st.lists(st.floats(-0.05, 0.05), min_size=1, max_size=8), st.floats(0.0, 0.1))
@settings(max_examples=examples(100), deadline=None, derandomize=True)
def test_chips_of_teeth_that_run_out_add_up(offsets, sweep):
    """Whatever each takes, a turn takes N f_t sin(phi); each against the surface that the last ones left."""
    n = len(offsets)
    chip = chip_thickness(np.full(n, sweep), np.arange(n), tuple(offsets))
    assert chip.sum() == pytest.approx(n * sweep, abs=1e-12)
    # The surface advances towards the axis by one sweep a tooth; each leaves the deeper of it and its own circle.
    surface = -1.0
    for j in range(6 * n):
        surface -= sweep
        taken = max(offsets[j % n] - surface, 0.0)
        surface = max(surface, offsets[j % n])
        if j >= 5 * n:
            assert taken == pytest.approx(chip[j % n], abs=1e-12)


RUNS_OUT = Tool(10.0, 4, 3000.0, helix_deg=30.0, runout_mm=0.03, runout_deg=20.0)


@pytest.mark.parametrize("helix", [0.0, 30.0])
def test_mean_force_of_teeth_that_run_out(helix):
    """The mean over a whole turn of the course tooth by tooth; teeth that take nothing have no edge force."""
    its = replace(RUNS_OUT, helix_deg=helix)
    entry, exit_, chip = np.pi - 1.2, np.pi, 0.02
    turn = (np.arange(7200) + 0.5) / 7200 * 2 * np.pi
    course = force_over_turn(turn, entry, exit_, 0.0, 3.0, chip, its, ALTINTAS)
    mean = average_force(entry, exit_, 3.0, chip, 4, ALTINTAS, its.tooth_offsets)
    assert mean == pytest.approx(course.mean(axis=0), rel=2e-3)
    # Chips alone: as without run-out. A tooth's peak is more than that of an even one.
    assert average_force(entry, exit_, 3.0, chip, 4, CHIP_ONLY, its.tooth_offsets) == pytest.approx(
        average_force(entry, exit_, 3.0, chip, 4, CHIP_ONLY), rel=1e-14
    )
    even = force_over_turn(turn, entry, exit_, 0.0, 3.0, chip, replace(its, runout_mm=0.0), ALTINTAS)
    assert np.hypot(*course.T).max() > 1.2 * np.hypot(*even.T).max()
    assert mean != pytest.approx(average_force(entry, exit_, 3.0, chip, 4, ALTINTAS), rel=0.05)


def test_a_cutter_that_is_larger_and_runs_out_cuts_deeper():
    """Surface: less the radius error and the outermost tooth. Engagement: acos(1 - (a + both) / (R + both))."""
    its = setup(1e7, 1e7)
    its = replace(its, tool=replace(its.tool, radius_error_mm=0.02, runout_mm=0.01, runout_deg=0.0))
    found = elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL))
    left = predicted_deviation(found, WALL)
    assert left.value == pytest.approx(-0.03, abs=1e-4)
    assert found.engagement.phi[200] == pytest.approx(np.arccos(1 - 1.03 / 5.03), abs=1e-4)
    smaller = replace(its, tool=replace(its.tool, radius_error_mm=-0.02, runout_mm=0.0))
    left = predicted_deviation(elastic_pass(path("G0 X-60 Y5\nG1 X60"), smaller, stock_of(its, WALL)), WALL)
    assert left.value == pytest.approx(0.02, abs=1e-4)


def test_difference_from_petrakovs_model():
    """His one tooth, eqs. (1) to (4), at the end of the arc; the mean over the arc by Simpson's rule. As documented."""
    straight, arc = np.arccos(0.7), np.arccos(0.19)
    kt, kr, chip, teeth = 1180.0, 354.0, 400 / 9000, 6
    his, mean, simpson = [], [], []
    for phi in (straight, arc):
        # Along the feed and across the wall of down milling, psi counted from the wall.
        def tooth(psi):
            return np.stack([kt * np.cos(psi) - kr * np.sin(psi), kt * np.sin(psi) + kr * np.cos(psi)], -1)

        his.append(10.0 * chip * (1 - np.cos(phi)) * tooth(phi))
        psi = np.linspace(0.0, phi, 2001)
        weight = np.ones(2001)
        weight[1:-1:2], weight[2:-1:2] = 4.0, 2.0
        area = chip * np.sin(psi)[:, None] * tooth(psi)
        simpson.append(10.0 * (weight[:, None] * area).sum(axis=0) * phi / 2000 / 3)
        whole = average_force(np.pi - phi, np.pi, 10.0, chip, teeth, Material("", kt, kr))
        mean.append(whole / (teeth / (2 * np.pi)))
    his, mean = np.array(his), np.array(mean)
    assert np.abs(mean) == pytest.approx(np.abs(simpson), rel=1e-9)
    size = np.hypot(*his.T) / np.hypot(*mean.T)
    assert size == pytest.approx([1.018, 1.056], abs=5e-4)
    both = np.array([straight, arc])
    c, el = (1 - np.cos(2 * both)) / 4, (2 * both - np.sin(2 * both)) / 4
    assert np.hypot(*mean.T) == pytest.approx(np.hypot(kt, kr) * 10.0 * chip * np.hypot(c, el), rel=1e-12)
    assert np.degrees(np.arctan2(el, c)) == pytest.approx([30.09, 51.07], abs=5e-3)
    turned = np.degrees(np.arctan2(*his.T[::-1]) - np.arctan2(*mean.T[::-1]))
    assert turned == pytest.approx([15.5, 28.0], abs=0.05)
    assert np.hypot(*his.T)[1] / np.hypot(*his.T)[0] == pytest.approx(2.70, abs=5e-3)
    assert np.hypot(*mean.T)[1] / np.hypot(*mean.T)[0] == pytest.approx(2.60, abs=5e-3)
    assert his[1, 1] / his[0, 1] == pytest.approx(3.03, abs=5e-3)
    assert mean[1, 1] / mean[0, 1] == pytest.approx(3.30, abs=5e-3)
    assert his[:, 1] / mean[:, 1] == pytest.approx([1.24, 1.14], abs=5e-3)


# --- elastic loop


def paper(machine=None):
    nominal = contour(
        NurbsCurve.line((35, 300), (35, 5)),
        NurbsCurve.arc((35, 5), (20, -10), (20, 5), -np.pi / 2),
        NurbsCurve.line((20, -10), (-300, -10)),
    )
    toolpath = path("G0 X-60 Y0 Z5\nG1 Z-10 F400\nG1 X20\nG3 X25 Y5 I0 J5\nG1 Y80")
    its = load(SETUPS / "petrakov-2023.toml")
    its = its if machine is None else replace(its, machine=machine)
    return toolpath, nominal, its


def test_part_of_petrakov_2023_before_correction():
    """Figures 5 and 8: 150 N on the straights, 400 N in the arc, at most 0.3 mm left along the normal."""
    toolpath, nominal, its = paper()
    found = elastic_pass(toolpath, its, stock_of(its, nominal))
    assert found.cutting.resultant[[20, -20]] == pytest.approx(150.0, rel=0.01)
    assert found.cutting.resultant.max() == pytest.approx(400.0, rel=0.03)
    deviation = predicted_deviation(found, nominal, spacing=0.25)
    assert isinstance(deviation, Deviation)
    assert deviation.value.max() == pytest.approx(0.3, abs=0.005)
    # On the straights it is the deflection across the wall, everywhere the same.
    straight = deviation.foot[:, 0] < 5
    assert np.ptp(deviation.value[straight]) < 1e-6
    assert deviation.value[straight] == pytest.approx(found.normal_deflection[20], abs=1e-6)


@pytest.mark.parametrize("k", [400.0, 300.0])
def test_a_surface_of_more_than_a_millimetre_is_whole(k):
    """No hole where most is left; the surface is the envelope of the discs by shapely, through the steps."""
    toolpath, nominal, its = paper(Machine(k, k))
    found = elastic_pass(toolpath, its, stock_of(its, nominal))
    deviation = predicted_deviation(found, nominal, spacing=0.25)
    assert np.diff(deviation.s).max() < 0.2501
    bends = float(np.hypot(*found.deflection.T).max())
    # The path ends on both straights, and what bends the cutter carries its end along.
    assert deviation.s.min() < 300.0 - 80.0 + bends + 0.25
    assert deviation.s.max() > float(nominal.total[0]) - (300.0 - 60.0) - bends - 0.25
    assert deviation.value.max() > (1.0 if k == 300.0 else 0.8)
    joined = np.flatnonzero(np.diff(found.engagement.s) > 0)
    line = shapely.linestrings(found.centre[np.append(joined, len(found.centre) - 1)])
    q = deviation.foot + deviation.value[:, None] * deviation.normal
    away = shapely.distance(shapely.points(q), line)
    # Chords of 0.25 mm cut a path of radius 5 by up to 0.25^2 / 8 / 5 mm.
    inner = slice(8, -8)
    assert away[inner] == pytest.approx(10.0, abs=0.25**2 / 8 / 5 * 1.5)


def test_a_surface_that_is_not_to_be_found_is_refused_with_its_place(monkeypatch):
    """A bent path 5 mm beside where its steps are leaves no surface within reach."""
    its = setup()
    found = elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL))
    # The axes' own path may leave places out: corners that it rounds off are no more, and it may end before.
    shorter = elastic_pass(path("G0 X-40 Y5\nG1 X40"), its, stock_of(its, WALL))
    longer = shorter.path.steps.centre * [1.5, 1.0]
    left, _ = deviation_along(shorter, WALL, longer, spacing=1.0)
    assert 39.0 <= np.abs(left.foot[:, 0]).max() <= 40.0
    through, beside = elastic_pass_module._path_through, contour(NurbsCurve.line((-60, 10), (60, 10)))
    commanded = found.path.steps.centre
    monkeypatch.setattr(
        elastic_pass_module, "_path_through", lambda e, c, z: through(e, c, z) if c is commanded else beside
    )
    with pytest.raises(RefusedError, match=r"leaves at X\S+ Y0\.000 is not to be found within 1\.0"):
        predicted_deviation(found, WALL)


def test_the_loop_is_closed():
    """Force over stiffness is the deflection, with the engagement the deflection leaves."""
    toolpath = path("G0 X-60 Y5\nG1 X60")
    its = setup(2000.0, 3000.0, ALTINTAS)
    found = elastic_pass(toolpath, its, stock_of(its, WALL))
    k = len(found.deflection) // 2
    depth = 1.0 - found.deflection[k, 1]
    entry = np.pi - np.arccos(1 - depth / 5.0)
    assert found.engagement.entry[k] == pytest.approx(entry, abs=1e-9)
    force = average_force(entry, np.pi, 5.0, 0.05, 4, ALTINTAS)
    assert found.deflection[k] == pytest.approx(force / (2000.0, 3000.0), abs=2e-7)
    assert found.accuracy < 1e-6 and found.contraction < 1.0
    # The rigid cutter would bend more: what is left standing is not cut.
    rigid = cutting(engagement(toolpath, its, stock_of(its, WALL)), its).force[k, 1] / 3000.0
    assert 0 < found.deflection[k, 1] < rigid


def test_a_wall_that_is_soft_in_its_middle():
    """At every step force over the stiffness there, compliance linear in between; the closed form of the straight."""
    table = ((0.0, 8000.0, 8000.0), (60.0, 2000.0, 1000.0), (120.0, 8000.0, 8000.0))
    its = setup(5000.0, 5000.0, ALTINTAS)
    its = replace(its, machine=replace(its.machine, stiffness_along=table))
    wall = contour(NurbsCurve.line((60, 0), (-60, 0)))
    found = elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL), nominal=wall)
    x = found.engagement.position[:, 0]
    soft = 1 - np.abs(x) / 60.0
    compliance = (1 / 8000.0 + soft * (1 / 2000.0 - 1 / 8000.0), 1 / 8000.0 + soft * (1 / 1000.0 - 1 / 8000.0))
    for k in range(40, len(x) - 40, 40):
        entry = np.pi - np.arccos(1 - (1.0 - found.deflection[k, 1]) / 5.0)
        force = average_force(entry, np.pi, 5.0, 0.05, 4, ALTINTAS)
        assert found.deflection[k] == pytest.approx(force * (compliance[0][k], compliance[1][k]), abs=1e-6)
    with pytest.raises(UsageError, match="stiffness_along needs a nominal of one contour"):
        elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL))
    with pytest.raises(UsageError, match=r"goes to 120 mm, the contour is 100\.000 mm long"):
        short = contour(NurbsCurve.line((50, 0), (-50, 0)))
        elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL), nominal=short)


@pytest.mark.thorough
def test_a_very_soft_machine_has_one_answer(monkeypatch):
    """2.2 of 3 mm give way: wherever rounds of all steps leave off, steps settled one by one end in the same place."""
    toolpath, nominal, its = paper(Machine(150.0, 150.0))
    stock = stock_of(its, nominal)
    found = []
    for rounds in (10, 40):
        monkeypatch.setattr(elastic_pass_module, "ROUNDS", rounds)
        found.append(elastic_pass(toolpath, its, stock))
        assert found[-1].residual <= 1e-7
    assert found[0].deflection == pytest.approx(found[1].deflection, abs=1e-6)
    # On the straight the force of what is really cut stands against the spring, by the closed form.
    k = 20
    depth = 3.0 - found[0].deflection[k, 1]
    entry = np.pi - np.arccos(1 - depth / 10.0)
    force = average_force(entry, np.pi, 10.0, 400 / 9000, 6, its.material)
    assert found[0].deflection[k] == pytest.approx(force / 150.0, abs=1e-6)


def test_a_stiff_machine_follows_the_program():
    toolpath, nominal, its = paper(Machine(1e7, 1e7))
    found = elastic_pass(toolpath, its, stock_of(its, nominal))
    assert np.abs(found.deflection).max() < 400 / 1e7 * 1.01
    rigid = engagement(toolpath, its, stock_of(its, nominal))
    assert found.engagement.phi == pytest.approx(rigid.phi, abs=1e-3)


def test_a_second_pass_cuts_what_the_first_left():
    """Regeneration: the spring pass takes the first one's deflection, and leaves less."""
    one = "G1 Z0\nG1 X60\nG0 Z5\nG0 X-60\n"
    its = setup(3000.0, 3000.0, ALTINTAS)
    found = elastic_pass(path(f"G0 X-60 Y5 Z5\n{one}{one}"), its, stock_of(its, WALL))
    half = len(found.deflection) // 2
    first, second = found.deflection[half // 2, 1], found.deflection[half + half // 2, 1]
    assert 0 < second < first
    # The depth of the second pass is what the first left, less its own deflection.
    entry = np.pi - np.arccos(1 - (first - second) / 5.0)
    assert found.engagement.entry[half + half // 2] == pytest.approx(entry, abs=1e-6)
    force = average_force(entry, np.pi, 5.0, 0.05, 4, ALTINTAS)
    assert second == pytest.approx(force[1] / 3000.0, abs=1e-6)
    left = predicted_deviation(found, WALL).value
    assert left[np.abs(left - second) < 1e-5].size > 80


def test_spring_passes_round_a_pocket_with_sharp_corners():
    """At a corner a later lap finds layers thinner than a chip, whose force fades out with them: the loop settles."""
    lap = "G1 Y35\nG1 X5\nG1 Y5\nG1 X55\nG1 Y20\n"
    corners = [(0, 0), (0, 40), (60, 40), (60, 0), (0, 0)]
    pocket = contour(*(NurbsCurve.line(a, b) for a, b in zip(corners, corners[1:], strict=False)), closed=True)
    its = setup(6000.0, 9000.0, ALTINTAS, allowance=0.5)
    left = []
    for laps in (1, 2, 3):
        text = f"G0 X30 Y20 Z5\nG1 Z-5\nG3 X55 Y20 R12.5\n{lap * laps}G3 X30 Y20 R12.5"
        found = elastic_pass(path(text), its, stock_of(its, pocket))
        assert found.residual <= 1e-7
        left.append(predicted_deviation(found, pocket).value)
    # Every lap takes most of what the one before has left.
    assert left[0].max() > 0.005
    assert left[1].max() < 0.3 * left[0].max() and left[2].max() < 0.5 * left[1].max()


def test_layers_thinner_than_the_chip_have_less_force():
    toolpath = path("G0 X-10 Y5\nG1 X10")
    its = setup()
    e = engagement(toolpath, its, StockRegion(WALL, 1.0))
    chip = e.feed_per_tooth[e.arc_step] * np.sin((e.arc_entry + e.arc_exit) / 2)
    whole = cutting(e, its).force
    assert cutting(e, its, 2.0 * chip).force == pytest.approx(whole, rel=1e-14)
    assert cutting(e, its, 0.25 * chip).force == pytest.approx(0.25 * whole, rel=1e-14)


def test_a_machine_softer_than_the_cut_is_refused():
    its = setup(30.0, 30.0, depth=50.0)
    with pytest.raises(RefusedError, match="times as stiff as the machine"):
        elastic_pass(path("G0 X-60 Y5\nG1 X60"), its, stock_of(its, WALL))


def test_bound_of_the_cutting_stiffness():
    """The derivative of the mean force over depth, by differences, stays below the bound, and near it."""
    its = setup()
    toolpath = path("G0 X-10 Y5\nG1 X10")

    def force(depth):
        return cutting(engagement(toolpath, its, StockRegion(WALL, depth)), its).force[3]

    bound = cutting_stiffness(engagement(toolpath, its, StockRegion(WALL, 1.0)), its)
    slopes = [np.hypot(*(force(d + 1e-6) - force(d - 1e-6))) / 2e-6 for d in (0.01, 0.3, 1.0, 2.0, 4.9)]
    assert max(slopes) <= bound * (1 + 1e-6)
    assert max(slopes) == pytest.approx(bound, rel=1e-6)


# --- another program: the simulated machine closes the loop by its own formula


def transfer_of(toolpath, its, nominal, allowance):
    """MS(s) of the rigid cut: mean force along the normal over stiffness and depth (petrakov-2025, eq. 3)."""
    rigid = cutting(engagement(toolpath, its, StockRegion(nominal, allowance)), its)
    k = np.array(its.machine.stiffness())
    place = rigid.engagement.position[:, :2]
    from millcorr.geometry.footpoint import FootPointSearch

    feet = FootPointSearch(nominal, margin=20.0).find(place)
    s = nominal.arc_length(feet.span, feet.t)
    ms = (rigid.force / k * feet.normal).sum(axis=1) / allowance
    order = np.argsort(s)
    s, ms = s[order], ms[order]
    keep = np.concatenate([[True], np.diff(s) > 1e-6])
    return lambda at: np.interp(at, s[keep], ms[keep])


def test_agrees_with_the_simulated_machine_on_a_wall():
    toolpath = path("G0 X-60 Y5\nG1 X60")
    its = setup(3000.0, 2000.0, CHIP_ONLY, allowance=1.0)
    found = predicted_deviation(elastic_pass(toolpath, its, stock_of(its, WALL)), WALL)
    machine = SimulatedMachine(allowance=1.0, transfer=transfer_of(toolpath, its, WALL, 1.0))
    other = machine.cut(toolpath, 5.0, WALL, seed=1).deviation(0, found.s)
    assert np.abs(found.value).min() > 0.01
    assert np.abs(found.value / other - 1).max() < 0.02


@pytest.mark.parametrize("rotation, radial", [("clockwise", 1800.0), ("anticlockwise", 600.0)])
def test_agrees_with_the_simulated_machine_on_the_reference_contour(rotation, radial):
    """A contour of all directions, kx not ky, up and down milling.

    In up milling the tangential force draws the cutter in; only a large radial one makes a normal force that grows
    nearly in proportion to the depth, as a transfer function has it.
    """
    nominal = reference_contour()
    s = np.linspace(0.0, float(nominal.total[0]), 1801)
    point, normal = nominal.at(0, s)
    centre = point + 5.0 * normal
    text = "".join(f"G1 X{x:.6f} Y{y:.6f}\n" for x, y in centre[1:])
    toolpath = path(f"G0 X{centre[0, 0]:.6f} Y{centre[0, 1]:.6f}\n{text}")
    its = setup(9000.0, 6000.0, Material("", 2000.0, radial), rotation, allowance=0.5)
    found = predicted_deviation(elastic_pass(toolpath, its, stock_of(its, nominal)), nominal)
    machine = SimulatedMachine(allowance=0.5, transfer=transfer_of(toolpath, its, nominal, 0.5))
    # The cutter's first and last contact is not the steady cut that MS is taken from.
    inside = (found.s > 8.0) & (found.s < nominal.total[0] - 8.0)
    other = machine.cut(toolpath, 5.0, nominal, seed=1).deviation(0, found.s)
    assert inside.sum() > 180
    largest = np.abs(other[inside]).max()
    assert largest > 2e-3
    assert np.abs(found.value - other)[inside].max() < 0.02 * largest
