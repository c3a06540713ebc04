# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error of a wall over its height: closed forms, other formulas of the project, and a march through time."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from millcorr import nc
from millcorr.errors import InputError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.cutting import force_at, surface_location_error
from millcorr.process.deflection.cantilever import Cantilever
from millcorr.process.deflection.height_deviation import predicted_deviation
from millcorr.process.deflection.height_error import WallModel
from millcorr.process.deflection.real_path import real_path
from millcorr.process.engagement import engagement, stock_of
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.kinematics import AxisDynamics, Control, motion
from millcorr.process.prediction.real_feed import RealFeed
from millcorr.process.setup_file import Machine, Material, Setup, Stock, load
from tests.core.sweeps import examples

PAPER = load(Path(__file__).resolve().parents[3] / "resources" / "setups" / "dat-2025.toml")
HEIGHTS = np.array([0.5, 1.0, 1.5, 2.0])
DEGREE = np.pi / 180


def contour(*curves, closed=False):
    return Profile.from_contours([Contour(tuple(curves), closed)])


WALL = contour(NurbsCurve.line((500, 0), (-500, 0)))
"""Material below y = 0."""
HOLLOW = contour(NurbsCurve.line((5, 60), (5, -5)), NurbsCurve.line((5, -5), (-60, -5)))
"""Inner corner of the part, to the right of a path along +X, then +Y."""
ROUND = contour(NurbsCurve.line((-60, 5), (-5, 5)), NurbsCurve.line((-5, 5), (-5, 60)))
"""Outer corner of the part, to the left of the same path."""
HEAD = "G90 G17 G21 F300\n"
CORNER = HEAD + "G0 X-25 Y0 Z5\nG1 Z0\nG1 X0\nG1 Y25"


def path(text):
    return nc.parse(HEAD + text).toolpath


def straight(length=20.0, y=5.0):
    return path(f"G0 X{-length / 2} Y{y}\nG1 X{length / 2}")


def model(its, nominal=WALL, toolpath=None, spacing=0.25, **other):
    toolpath = straight() if toolpath is None else toolpath
    return WallModel.of(real_path(toolpath, spacing=spacing, **other), its, stock_of(its, nominal))


def tool(**words):
    return replace(PAPER, tool=replace(PAPER.tool, **words))


def middle(value):
    return value[len(value) // 2]


# --- closed forms


def test_a_wall_that_bends_over_its_height():
    """A stiff tool on a rigid machine: the error at z is the force of its moment over the wall's stiffness there."""
    stiff = replace(PAPER.tool, stiffness_n_per_mm=1e7)
    rows = ((0.0, 4000.0, 4000.0), (2.5, 800.0, 800.0))
    its = Setup(stiff, PAPER.material, Machine(wall_over_height=rows), PAPER.stock)
    found = middle(model(its).errors(HEIGHTS).value)
    entry = np.pi - np.arccos(1 - 2.0 / 5.0)
    chip = 5.0 / stiff.tooth_frequency
    for z, value in zip(HEIGHTS, found, strict=True):
        k = 1.0 / np.interp(z, [0.0, 2.5], [1 / 4000.0, 1 / 800.0])
        (wanted,) = surface_location_error([z], entry, np.pi, 2.5, chip, k, stiff, its.material)
        # The shank adds 1e-7 mm/N to 2.5e-4 and more.
        assert value == pytest.approx(wanted, rel=5e-4)
    # On top of the tool and the machine, not in their place.
    both = middle(model(replace(PAPER, machine=replace(PAPER.machine, wall_over_height=rows))).errors(HEIGHTS).value)
    assert both == pytest.approx(middle(model(PAPER).errors(HEIGHTS).value) + found, rel=1e-3)


def test_a_wall_that_bends_along_its_length_and_over_its_height():
    """Each place is as on a machine that has its stiffness everywhere; compliance is linear between the rows."""
    rows = ((0.0, 900.0, 900.0), (500.0, 300.0, 300.0), (1000.0, 900.0, 900.0))
    over = ((0.0, 9000.0, 9000.0), (2.5, 5000.0, 5000.0))
    machine = replace(PAPER.machine, kx_n_per_mm=900.0, ky_n_per_mm=900.0, wall_over_height=over)
    its = replace(PAPER, machine=replace(machine, stiffness_along=rows))
    way = real_path(path("G0 X-240 Y5\nG1 X240"), spacing=0.25)
    found = WallModel.of(way, its, stock_of(its, WALL), WALL).errors(HEIGHTS)
    x = found.model.engagement.position[:, 0]
    for place in (-200.0, -55.0, 0.0, 130.0):
        row = int(np.abs(x - place).argmin())
        # The nominal begins at X500 and runs along -X.
        k = 1.0 / np.interp(500.0 - x[row], [0.0, 500.0, 1000.0], [1 / 900, 1 / 300, 1 / 900])
        even = replace(PAPER, machine=replace(machine, kx_n_per_mm=k, ky_n_per_mm=k))
        wanted = middle(
            WallModel.of(real_path(straight(), spacing=0.25), even, stock_of(even, WALL)).errors(HEIGHTS).value
        )
        # The loop is closed to 1e-6 mm; a place differs from its neighbours by 1e-5 mm a step.
        assert found.value[row] == pytest.approx(wanted, abs=1e-5)
    assert np.ptp(found.value[:, 0][np.isfinite(found.value[:, 0])]) > 0.01


def test_a_row_that_is_stiffer_than_the_tool_alone_is_refused():
    alone = Cantilever.of_tool(PAPER.tool).tip_stiffness
    rows = ((0.0, 900.0, 900.0), (500.0, 2 * alone, 900.0))
    its = replace(PAPER, machine=replace(PAPER.machine, kx_n_per_mm=900.0, ky_n_per_mm=900.0, stiffness_along=rows))
    way = real_path(straight(), spacing=0.25)
    with pytest.raises(UsageError, match="tool alone"):
        WallModel.of(way, its, stock_of(its, WALL), WALL)
    with pytest.raises(UsageError, match="nominal of one contour"):
        WallModel.of(way, its, stock_of(its, WALL))


def test_the_outermost_of_straight_teeth_makes_the_wall():
    """No edge force, one tooth in the cut: passing the wall its chip is nothing; the wall is off by its run-out."""
    its = tool(helix_deg=0.0, flutes=2, runout_mm=0.012, runout_deg=120.0, radius_error_mm=0.005)
    found = model(its).errors(HEIGHTS)
    assert middle(found.value) == pytest.approx(-0.012 * 0.5 - 0.005, abs=1e-9)


def test_run_out_agrees_with_the_one_stiffness_formula():
    """Helix, six teeth that run out: the integral over bands against 64 places of each edge, on a soft holder."""
    k = 2000.0
    stiff = replace(
        PAPER.tool, stiffness_n_per_mm=1e7, flutes=6, helix_deg=40.0, runout_mm=0.01, runout_deg=35.0,
        radius_error_mm=-0.004,
    )  # fmt: skip
    its = Setup(stiff, PAPER.material, Machine(k, k), Stock(allowance_mm=0.5, axial_depth_mm=2.5))
    entry = np.pi - np.arccos(1 - (0.5 + stiff.oversize) / stiff.cutting_radius)
    chip = 5.0 / stiff.tooth_frequency
    wanted = surface_location_error(HEIGHTS, entry, np.pi, 2.5, chip, k, stiff, its.material)
    even = surface_location_error(HEIGHTS, entry, np.pi, 2.5, chip, k, replace(stiff, runout_mm=0.0), its.material)
    assert np.abs(wanted - even).min() > 5e-3
    # A sixty-fourth of the edge more or less in the cut: 2 % of the deflection.
    assert middle(model(its).errors(HEIGHTS).value) == pytest.approx(wanted, abs=3e-4)


@pytest.mark.parametrize("rotation", ["clockwise", "anticlockwise"])
@pytest.mark.parametrize("flutes", [2, 4])
def test_straight_edges_without_edge_force_leave_no_error(rotation, flutes):
    """Up and down milling: exactly 0, at every height, loop closed (Schmitz and Mann 2006)."""
    found = model(tool(helix_deg=0.0, rotation=rotation, flutes=flutes)).errors(np.linspace(0.0, 2.5, 6))
    assert (found.value == 0.0).all()


def test_straight_edges_with_edge_force():
    """The radial edge force alone stands across the wall there: Kre over the depth, bent as a distributed load."""
    its = replace(tool(helix_deg=0.0), material=replace(PAPER.material, kre_n_per_mm=10.0))
    found = model(its).errors(HEIGHTS)
    bent = Cantilever.of(its)
    wanted = [10.0 * quad(lambda a, z=z: float(bent.compliance(z, a)), 0.0, 2.5)[0] for z in HEIGHTS]
    assert middle(found.value) == pytest.approx(wanted, rel=1e-9)


def by_hand(its, z, depth, radial, down):
    """The integral over the edge, tooth by tooth, by adaptive quadrature and plain loops."""
    t = its.tool
    lag = np.tan(np.radians(t.helix_deg)) / t.radius
    phi_in = np.arccos(1 - radial / t.radius)
    entry, exit_ = (np.pi - phi_in, np.pi) if down else (0.0, phi_in)
    chip = 5.0 / t.tooth_frequency
    bent = Cantilever.of(its)
    total = 0.0
    for tooth in range(-2 * t.flutes, 2 * t.flutes + 1):
        at = (np.pi if down else 0.0) + tooth * 2 * np.pi / t.flutes

        def pushed(a, at=at):
            phi = at + lag * (z - a)
            if not entry <= phi <= exit_:
                return 0.0
            return float(force_at(np.array(phi), chip, its.material)[1] * bent.compliance(z, a))

        ends = sorted({0.0, z, depth, *(np.clip(z + (at - end) / lag, 0.0, depth) for end in (entry, exit_))})
        total += sum(quad(pushed, a, b, epsabs=1e-12)[0] for a, b in zip(ends[:-1], ends[1:], strict=True))
    return total if down else -total


@given(st.floats(0.0, 1.0), st.floats(5.0, 60.0), st.sampled_from([1, 2, 4, 6]), st.booleans(), st.floats(0.3, 4.5))
@settings(max_examples=examples(25), deadline=None, derandomize=True)
def test_the_integral_over_the_edge(part, helix, flutes, down, radial):
    """Open loop, any height, helix, number of teeth, up and down; 1e-6 of the part that the loop closes is left out."""
    material = replace(PAPER.material, kte_n_per_mm=12.0, kre_n_per_mm=20.0)
    its = Setup(
        replace(PAPER.tool, helix_deg=helix, flutes=flutes, rotation="clockwise" if down else "anticlockwise"),
        material, Machine(), Stock(allowance_mm=radial, axial_depth_mm=2.5),
    )  # fmt: skip
    m = model(its, toolpath=straight(3.0))
    step = len(m.engagement) // 2
    z = part * 2.5
    bent = m.deflection(np.array([step]), np.array([z]), np.array([np.pi if down else 0.0]))
    # Where an edge stands right at the end of an arc the two may differ on which side it is: not at these numbers.
    assert bent[0] @ m.wall[step] == pytest.approx(by_hand(its, z, 2.5, radial, down), rel=1e-6, abs=1e-9)


def test_agrees_with_the_one_stiffness_formula():
    """A tool that only tilts with its holder: a soft machine, a shank far stiffer, gives the error of one stiffness."""
    k = 2000.0
    stiff = replace(PAPER.tool, stiffness_n_per_mm=1e7)
    its = Setup(stiff, PAPER.material, Machine(k, k), PAPER.stock)
    m = model(its)
    found = m.errors(HEIGHTS)
    entry = np.pi - np.arccos(1 - 2.0 / 5.0)
    wanted = surface_location_error(HEIGHTS, entry, np.pi, 2.5, 5.0 / stiff.tooth_frequency, k, stiff, its.material)
    # 1 / k is shared by machine and shank: 2e-4 of it is the shank's, which bends a little less above its tip.
    assert middle(found.value) == pytest.approx(wanted, rel=1e-4)


def test_kx_and_ky():
    """Along X the force across the wall does not push; a wall along Y gives way by kx."""
    stiff = replace(PAPER.tool, stiffness_n_per_mm=1e7)
    its = Setup(stiff, PAPER.material, Machine(1000.0, 4000.0), PAPER.stock)
    wall_y = contour(NurbsCurve.line((0, -500), (0, 500)))
    along_x = middle(model(its).errors(HEIGHTS).value)
    along_y = middle(model(its, wall_y, path("G0 X5 Y10\nG1 Y-10")).errors(HEIGHTS).value)
    assert along_y == pytest.approx(4 * along_x, rel=1e-3)


# --- the closed loop


def march(its, heights, slices=25, turn_step=DEGREE, teeth=60):
    """Wall left by a tool that bends, stepped through time: chips from where the tooth before really was.

    Straight wall, down milling, one pass. At every angle the deflection and the chips that it leaves are solved for
    together, a linear system for the edges that are in the cut; these are found in turn.
    """
    t, m = its.tool, its.material
    lag = np.tan(np.radians(t.helix_deg)) / t.radius
    pitch = 2 * np.pi / t.flutes
    depth, radial = its.stock.axial_depth_mm, its.stock.allowance_mm
    z = (np.arange(slices) + 0.5) * depth / slices
    give = Cantilever.of(its).compliance(z[:, None], z[None, :]) * depth / slices
    chip = 5.0 / t.tooth_frequency
    per_pitch = round(pitch / turn_step)
    old = np.zeros((per_pitch, slices, 2))
    wall = np.full((per_pitch, len(heights)), np.nan)
    d = np.zeros((slices, 2))
    for k in range(teeth * per_pitch):
        tip = k * pitch / per_pitch
        phi = np.mod(tip - lag * z[:, None] + pitch * np.arange(t.flutes), 2 * np.pi)
        # Along feed and to the left: to the edge, and the force on the tool per chip.
        reach = np.stack([np.sin(phi), np.cos(phi)], axis=-1)
        ktc, krc = m.ktc_n_per_mm2, m.krc_n_per_mm2
        force = np.stack([-ktc * np.cos(phi) - krc * np.sin(phi), ktc * np.sin(phi) - krc * np.cos(phi)], axis=-1)
        last = old[k % per_pitch] if k >= per_pitch else d
        for _ in range(20):
            # The stock's face is `radial` off the wall: an edge is in the cut where it reaches below it.
            below = -t.radius * np.cos(phi) - d[:, 1, None] >= t.radius - radial
            h = chip * np.sin(phi) + ((d - last)[:, None] * reach).sum(axis=-1)
            cuts = below & (phi <= np.pi) & (h > 0)
            # d = give @ sum of force (chip sin(phi) + (d - last) . reach) over the edges in the cut.
            gain = np.einsum("stf,stg,st->sfg", force, reach, cuts.astype(float))
            rest = np.einsum("stf,st,st->sf", force, chip * np.sin(phi), cuts.astype(float))
            rest = rest - np.einsum("sfg,sg->sf", gain, last)
            system = np.eye(2 * slices) - np.einsum("is,sfg->ifsg", give, gain).reshape(2 * slices, -1)
            new = np.linalg.solve(system, (give @ rest).ravel()).reshape(slices, 2)
            if np.abs(new - d).max() < 1e-9:
                break
            d = new
        old[k % per_pitch] = d
        wall[k % per_pitch] = [np.interp(height, z, d[:, 1]) for height in heights]
    # The edge at a height is at the wall when its tip has turned on by its lag.
    turn = np.arange(per_pitch + 1) * pitch / per_pitch
    at = np.mod(np.pi + lag * np.asarray(heights), pitch)
    return np.array([np.interp(a, turn, np.append(w, w[0])) for a, w in zip(at, wall.T, strict=True)])


def test_a_march_through_time_comes_to_the_same():
    """In the steady state the chips are `f_t sin(phi)`, whatever the tool bends; the fit to the paper's 25 um holds."""
    found = middle(model(PAPER).errors(HEIGHTS).value)
    assert found[0] == pytest.approx(0.025, abs=5e-6)
    # Steps of 1 degree and 0.1 mm of height: 0.04 um at the most here, a third of that with half the steps.
    assert found == pytest.approx(march(PAPER, HEIGHTS, teeth=20), abs=6e-5)
    fine = march(PAPER, HEIGHTS, teeth=20, turn_step=np.radians(0.5), slices=50)
    assert found == pytest.approx(fine, abs=2e-5)


def test_the_loop_is_closed():
    """A soft tool of six teeth: as the wall is made the next tooth enters the cut, and how far it reaches into the
    stock depends on what the tool bends at that moment, at every height.
    """
    radial = 5.0 * (1 - np.cos(np.radians(61.0)))
    its = Setup(
        replace(PAPER.tool, flutes=6, helix_deg=10.0), Material("", 1500.0, 900.0), Machine(),
        Stock(allowance_mm=radial, axial_depth_mm=2.5),
    )  # fmt: skip
    m = model(its, toolpath=straight(2.0))
    closed = middle(m.errors(HEIGHTS).value)
    opened = m.deflection(np.full(4, len(m.engagement) // 2), HEIGHTS, np.full(4, np.pi))[:, 1]
    wanted = march(its, HEIGHTS, teeth=12)
    assert np.abs(opened - wanted).min() > 6e-3
    # Where the edge enters is known by bands in which it turns 0.02 rad: 1 % of the 2 rad in which force rises.
    assert closed == pytest.approx(wanted, abs=4e-4)


# --- real feed, deviations, refusals


def test_the_real_feed_sets_the_chip():
    """Half the feed in the program, half the error; the same through a control that has nothing to do on a line."""
    its = PAPER
    full = middle(model(its).errors(HEIGHTS).value)
    half = straight().with_moves(feed=straight().feed / 2)
    assert middle(model(its, toolpath=half).errors(HEIGHTS).value) == pytest.approx(full / 2, rel=1e-6)
    slow = Control.alike(AxisDynamics(0.05, "linear", 40.0))
    assert middle(model(its, control=slow).errors(HEIGHTS).value) == pytest.approx(full, rel=1e-6)


def test_real_path_follows_the_motion():
    """Corner of linear acc/dec: closest approach sqrt(2) v T / 8 (5 mm/s, 50 ms: 0.0442 mm); lines as asked."""
    toolpath = nc.parse(CORNER).toolpath
    found = real_path(toolpath, Control.alike(AxisDynamics(0.05, "linear")), spacing=0.01)
    lines = found.toolpath.take(found.short)
    assert np.hypot(*lines.end[:, :2].T).min() == pytest.approx(np.sqrt(2) * 5 * 0.05 / 8, abs=2e-3)
    assert np.hypot(*(lines.end - lines.start)[:, :2].T).max() <= 0.01 * (1 + 1e-9)
    # Half way through the corner both axes run at half their speed.
    corner = np.abs(lines.end[:, :2]).max(axis=1) < 1.0
    assert lines.feed[corner].min() == pytest.approx(5.0 / np.sqrt(2), rel=0.02)
    still = real_path(toolpath, spacing=0.5)
    assert still.toolpath.take(still.short).length().sum() == pytest.approx(50.0, rel=1e-12)


def test_deviation_by_height():
    """One level a height at foot points of the nominal; the elastic error of the straight wall, corner left out."""
    toolpath = nc.parse(CORNER).toolpath
    found = model(PAPER, HOLLOW, toolpath).errors(HEIGHTS)
    deviation = predicted_deviation(found, HOLLOW)
    assert set(deviation.level) == {0, 1, 2, 3}
    assert set(deviation.stretch) == {0, 1}
    for level, height in enumerate(HEIGHTS):
        rows = deviation.level == level
        assert deviation.z[rows] == pytest.approx(height)
        assert deviation.value[rows] == pytest.approx(middle(found.value)[level], abs=1e-9)


def test_the_overlap_of_an_outer_corner_is_left_out():
    """With acc/dec the path turns inside an outer corner: what is cut away again is no surface."""
    toolpath = nc.parse(CORNER).toolpath
    up = model(PAPER, ROUND, toolpath, control=Control.alike(AxisDynamics(0.05, "linear")), spacing=0.02)
    found = up.errors(HEIGHTS)
    assert not up.down[np.isfinite(up.wall[:, 0])].any()
    deviation = predicted_deviation(found, ROUND)
    # Path error across the corner: the part's corner is cut by at most the closest approach.
    assert deviation.value.min() > -0.05
    # Up milling makes the wall at immersion 0.
    for level, height in enumerate(HEIGHTS):
        wanted = by_hand(PAPER, height, 2.5, 2.0, down=False)
        assert np.median(deviation.value[deviation.level == level]) == pytest.approx(wanted, abs=1e-5)


@pytest.mark.few(1)
@pytest.mark.parametrize("radial, overhang", [(0.0, 60.0), (0.3, 50.0), (0.5, 60.0)])
def test_an_outer_corner_in_up_milling_is_as_the_straight_wall(radial, overhang):
    """From the corner on the cutter meets the same 2 mm at the same angles: the wall of six flutes errs as a straight.

    The place at which the wall begins is no other: neighbours that make no wall once stood still beside it, and the
    kink counted as a change of its angles, ninefold.
    """
    its = Setup(
        replace(PAPER.tool, flutes=6, helix_deg=30.0, overhang_mm=overhang),
        Material("", 1800.0, radial * 1800.0), Machine(), Stock(allowance_mm=2.0, axial_depth_mm=5.0),
    )  # fmt: skip
    found = model(its, ROUND, path("G0 X-8 Y0\nG1 X0\nG1 Y12")).errors(HEIGHTS)
    up = replace(its, tool=replace(its.tool, rotation="anticlockwise"))
    straight_wall = middle(model(up).errors(HEIGHTS).value)
    made = np.isfinite(found.value).all(axis=1) & (found.model.engagement.position[:, 1] > 4.9)
    assert made.sum() == 29 and found.residual <= 1e-7
    # Displacements of up to 0.1 mm change the angles along a secant: by its curvature the two are 2e-4 mm apart.
    assert found.value[made] == pytest.approx(np.broadcast_to(straight_wall, (made.sum(), 4)), abs=2e-4)


@pytest.mark.parametrize("feed, ratio, degrees", [(300, 1.00, 140.0), (3000, 1.29, 101.0)])
def test_load_of_the_commanded_corner_is_that_of_the_actual_one_or_more(feed, ratio, degrees):
    """The commanded cutter stands in the corner, 143.13 degrees engaged, 90 + acos(3 / 5); the actual one rounds it."""
    control = Control.alike(AxisDynamics(0.05, "linear", 40.0))
    toolpath = nc.parse(CORNER.replace("F300", f"F{feed}")).toolpath
    at_real_feed = RealFeed.of(toolpath, motion(toolpath, control)).toolpath
    commanded = engagement(at_real_feed, PAPER, stock_of(PAPER, HOLLOW), step=0.05)
    actual = engagement(real_path(toolpath, control).toolpath, PAPER, stock_of(PAPER, HOLLOW), step=0.05)
    assert np.degrees(commanded.phi.max()) == pytest.approx(90 + np.degrees(np.arccos(0.6)), abs=1e-6)
    assert np.degrees(actual.phi.max()) == pytest.approx(degrees, abs=1.0)
    assert np.nanmax(commanded.area) / np.nanmax(actual.area) == pytest.approx(ratio, abs=0.01)
    # Elsewhere both meet the same.
    assert np.median(actual.phi) == pytest.approx(np.median(commanded.phi), abs=1e-6)
    # What a simulation goes along, thinned to lines within 5e-5 mm, against the samples every 0.02 mm.
    moved = motion(toolpath, control)
    simulated = engagement(RealFeed.of(toolpath, moved).run(toolpath, moved).toolpath, PAPER, stock_of(PAPER, HOLLOW))
    assert simulated.phi.max() == pytest.approx(actual.phi.max(), abs=0.01)
    # The feed is that in the middle of parts of 0.25 mm, on which it changes by a few hundredths at the vertex.
    assert np.nanmax(simulated.area) == pytest.approx(np.nanmax(actual.area), rel=0.04)


def test_two_passes_have_their_own_heights():
    """Each pass makes the wall of its own depth; the second starts where the first has ended."""
    passes = path("G0 X-10 Y5 Z5\nG1 Z-2.5\nG1 X10\nG0 Z5\nG0 X-10\nG1 Z-5\nG1 X10")
    its = replace(PAPER, stock=Stock(allowance_mm=2.0, top_z_mm=0.0))
    found = model(its, toolpath=passes).errors([0.5, 1.0, 3.0, 3.5])
    one = middle(model(PAPER).errors([0.5, 1.0]).value)
    made = [found.value[np.isfinite(found.value[:, k]), k] for k in range(4)]
    assert found.z == pytest.approx([-4.5, -4.0, -2.0, -1.5])
    for values, wanted in zip(made, [*one, *one], strict=True):
        assert np.median(values) == pytest.approx(wanted, rel=1e-6)


def test_refusals():
    with pytest.raises(UsageError, match="overhang_mm is missing"):
        model(tool(overhang_mm=None))
    with pytest.raises(UsageError, match="no wall 4 mm above"):
        model(PAPER).errors([4.0])
    slot = Setup(PAPER.tool, PAPER.material, Machine(), Stock(solid=True, axial_depth_mm=2.5))
    with pytest.raises(InputError, match="makes no wall"):
        WallModel.of(real_path(straight()), slot, StockRegion())
    with pytest.raises(UsageError, match="spacing"):
        real_path(straight(), spacing=0.0)
    assert "factor of two" in model(PAPER).errors([0.5]).caution
