# SPDX-License-Identifier: LGPL-2.1-or-later
"""Combined control against closed forms and the figures of petrakov-2023."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc, pipeline
from millcorr.correction.settings import Settings
from millcorr.errors import DistrustError, InputError, RefusedError, UsageError
from millcorr.process.engagement import engagement, stock_of
from millcorr.process.engagement.contact_steps import Contacts
from millcorr.process.prediction import simulate
from millcorr.process.prediction.combined_control import identify, identify_machine
from millcorr.production import split
from tests.core.paper_2023 import LEFT, RADIUS, as_cut, cut_again, nominal, program, setup, softer, touched
from tests.core.sweeps import examples

X, Y = (1.0, 0.0), (0.0, 1.0)
SLOPE = (0.6, 0.8)


def identified(deltas, normals, depth=3.0, area=1.0):
    n = len(deltas)
    normal = np.array(normals, dtype=float)
    h, sq = np.broadcast_to(depth, n) * np.ones(n), np.broadcast_to(area, n) * np.ones(n)
    return identify(np.array(deltas), h, h, sq, normal, np.zeros((n, 2)))


def corrected(measurement, method="combined", its=None, **chosen):
    wanted = replace(LEFT, method=method, **chosen)
    return pipeline.correct(pipeline.Request(program(), RADIUS, measurement, None, wanted, setup=its or setup()))


# --- identification


def test_two_axis_parallel_touches():
    """Eq. (9) on each axis: MS = delta / (h - delta)."""
    found = identified([0.3, 0.15], [X, Y])
    assert found.ms == pytest.approx([0.3 / 2.7, 0.15 / 2.85], rel=1e-14)
    assert found.separate and np.isnan(found.ms_std).all()


def test_one_inclined_touch():
    """Eq. (7): its components give the same MS on both axes, whatever the slope."""
    for normal in (X, Y, SLOPE):
        found = identified([0.3], [normal])
        assert found.ms == pytest.approx([0.3 / 2.7] * 2, rel=1e-14)
        assert not found.separate
        # Carried back to the place of the touch it commands h (1 + MS).
        assert found.correction(np.array([1.0]), np.array([normal])) == pytest.approx(-3.0 * 0.3 / 2.7, rel=1e-14)


def test_carried_by_the_load():
    """Eqs. (10), (11): MS_c = MS k, k = sq / sq*; the correction is that part of the depth."""
    found = identified([0.09], [Y], area=2.0)
    area = np.array([2.0, 5.4])
    assert found.load(area) == pytest.approx([1.0, 2.7])
    assert found.correction(area, np.array([Y, X])) == pytest.approx(-0.09 / 2.91 * 3.0 * np.array([1.0, 2.7]))


@given(st.floats(0.0, 0.4), st.floats(0.0, 0.4), st.integers(0, 2**31))
@settings(max_examples=examples(40), deadline=None, derandomize=True)
def test_least_squares_gives_back_what_made_the_touches(cx, cy, seed):
    """Any number of touches of any slope, load and depth: whole = sq (Cx nx^2 + Cy ny^2), delta = whole h/(h+whole)."""
    rng = np.random.default_rng(seed)
    angle, area, depth = rng.uniform(0, 2 * np.pi, 12), rng.uniform(0.5, 2.0, 12), rng.uniform(1.0, 4.0, 12)
    normal = np.column_stack([np.cos(angle), np.sin(angle)])
    normal[:2] = X, Y
    whole = area * (normal**2 @ [cx, cy])
    found = identified(whole * depth / (depth + whole), normal, depth, area)
    assert found.separate
    assert found.ms * depth[0] / area[0] == pytest.approx([cx, cy], abs=1e-12)
    assert found.correction(area, normal) == pytest.approx(-whole, abs=1e-12)
    assert found.scatter == pytest.approx(0.0, abs=1e-12)


def test_uncertainty_is_the_scatter_of_many_measurements():
    """The stated standard uncertainty against the spread of 400 repetitions, which is known to 1/sqrt(800) = 3.5 %."""
    rng = np.random.default_rng(1)
    angle = np.linspace(0, np.pi, 20)
    normal = np.column_stack([np.cos(angle), np.sin(angle)])
    whole = normal**2 @ [0.2, 0.1]
    true = whole * 3.0 / (3.0 + whole)
    runs = [identified(true + 0.002 * rng.standard_normal(20), normal) for _ in range(400)]
    spread = np.std([run.ms for run in runs], axis=0, ddof=1)
    stated = np.sqrt(np.mean([run.ms_std**2 for run in runs], axis=0))
    assert stated == pytest.approx(spread, rel=0.11)
    along = np.array([run.correction(np.ones(1), np.array([SLOPE]))[0] for run in runs])
    std = np.sqrt(np.mean([run.correction_std(np.ones(1), np.array([SLOPE]))[0] ** 2 for run in runs]))
    assert std == pytest.approx(along.std(ddof=1), rel=0.11)


def test_touches_that_cannot_be():
    with pytest.raises(RefusedError, match="has no meaning there"):
        identified([2.8], [Y])
    with pytest.raises(InputError, match="takes nothing off the stock"):
        identified([0.1], [Y], area=0.0)


def test_stiffness_of_linear_springs():
    """Forces that do not change with the deflection: two equations, two springs."""
    forces = np.array([[100.0, -40.0], [30.0, 200.0]])
    normal = np.array([X, Y])

    def force(machine):
        if machine is None:
            return np.zeros(2), forces
        return (forces * normal) @ [1 / machine.kx, 1 / machine.ky], forces

    found = identify_machine(np.array([0.05, 0.04]), normal, force)
    assert (found.kx, found.ky) == pytest.approx((2000.0, 5000.0), rel=1e-9)
    with pytest.raises(RefusedError, match="against the force of the model"):
        identify_machine(np.array([-0.05, 0.04]), normal, force)


def test_contacts_are_where_the_cutter_touches():
    its = setup()
    e = engagement(program().toolpath, its, stock_of(its, nominal()))
    foot = np.array([[0.03, -10.0], [35.0, 33.3], [500.0, 500.0]])
    found = Contacts.of(e, foot, np.array([(0.0, 1.0), (-1.0, 0.0), (0.0, 1.0)]))
    centre = found.take(e.position)
    assert centre[0] == pytest.approx([0.03, 0.0, -10.0], abs=1e-9)
    assert centre[1] == pytest.approx([25.0, 33.3, -10.0], abs=1e-9)
    assert found.cut.tolist() == [True, True, False]


# --- the paper's part


def test_one_touch_takes_the_error_of_the_paper_down_to_the_papers():
    """0.3 mm before; "the maximum error measured by the normal is 0.09 mm" after, from MS of one touch and k[i]."""
    assert as_cut().largest == pytest.approx(0.30, abs=0.005)
    result = corrected(touched(as_cut(), (0.0, -10.0)))
    again = cut_again(result.text, setup())
    assert again.largest <= 0.09
    # Neither stiffness nor force of the setup are used up to there: any others give the same program.
    unknown = softer(4000.0, 2500.0)
    unknown = replace(unknown, material=replace(unknown.material, ktc_n_per_mm2=2360.0, krc_n_per_mm2=708.0))
    assert corrected(touched(as_cut(), (0.0, -10.0)), its=unknown).correction.largest == pytest.approx(
        result.correction.largest, rel=1e-6
    )


@pytest.mark.parametrize("ratio", [0.2, 0.5])
def test_more_than_three_times_smaller_whatever_the_radial_force(ratio):
    """ "Decreases more than 3 times": not a matter of the Krc/Ktc = 0.3 and the kx that the setup has fitted."""
    its = softer(1600.0, 1600.0)
    its = replace(its, material=replace(its.material, krc_n_per_mm2=ratio * its.material.ktc_n_per_mm2))
    before = simulate(program(), its, nominal())
    result = corrected(touched(before, (0.0, -10.0)), its=its)
    assert result.prediction.after[-1].largest < before.largest / 3.0


def test_iterated_it_is_below_a_hundredth():
    result = corrected(touched(as_cut(), (0.0, -10.0)), iterate=0.01)
    assert result.prediction.machine.kx == pytest.approx(1200.0, rel=2e-3)
    assert cut_again(result.text, setup()).largest <= 0.0105
    # Forces twice as large on a machine twice as stiff are the same to everything that can be measured.
    its = setup()
    double = replace(its, material=replace(its.material, ktc_n_per_mm2=2360.0, krc_n_per_mm2=708.0))
    again = corrected(touched(as_cut(), (0.0, -10.0)), its=double, iterate=0.01)
    assert again.prediction.machine.kx == pytest.approx(2400.0, rel=2e-3)
    assert cut_again(again.text, its).largest <= 0.0105


@pytest.mark.thorough
def test_axes_of_different_stiffness_need_two_touches():
    true = softer(1100.0, 2200.0)
    cut = simulate(program(), true, nominal())
    result = corrected(touched(cut, (0.0, -10.0), (35.0, 30.0)), iterate=0.01)
    machine = result.prediction.machine
    assert machine.separate
    assert (machine.kx, machine.ky) == pytest.approx((1100.0, 2200.0), rel=5e-3)
    assert cut_again(result.text, true).largest <= 0.0105


THIN = ((0.0, 1500.0, 1500.0), (55.0, 3000.0, 3000.0), (128.0, 1500.0, 1500.0))
"""Two walls that are softer towards their ends; arc length of the paper's contour."""


def along(table):
    its = setup()
    return replace(its, machine=replace(its.machine, stiffness_along=table))


@pytest.mark.thorough
def test_a_thin_wall_from_touches_at_several_places():
    """Three touches, three factors: the table is found again, off by 1.4, 0.8 and 0.7, and the error is taken out."""
    factors = (1.4, 0.8, 0.7)
    true = along(tuple((s, kx * f, ky * f) for (s, kx, ky), f in zip(THIN, factors, strict=True)))
    cut = simulate(program(), true, nominal())
    places = [tuple(nominal().at(0, np.array([s]))[0][0]) for s in (5.0, 45.0, 105.0)]
    result = corrected(touched(cut, *places), its=along(THIN), iterate=0.01)
    machine = result.prediction.machine
    assert machine.separate and machine.misfit <= 1e-3
    found = np.array(machine.along)[:, 1] / np.array(THIN)[:, 1]
    # Model and touches agree within 0.1 um or a thousandth; two rows of the table share each touch.
    assert found == pytest.approx(factors, rel=0.01)
    left = cut_again(result.text, true).largest
    assert cut.largest > 0.1 and left <= 0.0105
    # With one stiffness for the whole wall more is left of it.
    even = corrected(touched(cut, *places), iterate=0.01)
    assert cut_again(even.text, true).largest > 1.5 * left


def test_too_few_touches_scale_the_whole_table():
    true = along(tuple((s, 1.25 * kx, 1.25 * ky) for s, kx, ky in THIN))
    cut = simulate(program(), true, nominal())
    result = corrected(touched(cut, (0.0, -10.0)), its=along(THIN))
    machine = result.prediction.machine
    assert not machine.separate
    assert np.array(machine.along)[:, 1:] == pytest.approx(1.25 * np.array(THIN)[:, 1:], rel=5e-3)
    assert any("stiffness_along apart" in text for text in result.warnings)


@pytest.mark.thorough
def test_origin_does_not_matter():
    """Read as printed, with coordinates in place of depths, eq. (12) would move the path by MSx times 1000 mm."""
    text = program().text
    for word, there in (
        ("X-30 Y0", "X970 Y500"), ("G1 X20", "G1 X1020"), ("X25 Y5", "X1025 Y505"), ("Y60", "Y560"),
    ):  # fmt: skip
        assert word in text
        text = text.replace(word, there)
    m = touched(as_cut(), (0.0, -10.0))
    there = replace(m, points=m.points + (1000.0, 500.0, 0.0))
    moved = program(text)
    chosen = replace(LEFT, method="combined")
    far = pipeline.correct(pipeline.Request(moved, RADIUS, there, None, chosen, setup=setup()))
    assert far.correction.largest == pytest.approx(corrected(m).correction.largest, abs=1e-6)


def test_single_piece():
    """Half of the allowance is cut and touched; the second half finds what the first one left."""
    its = setup()
    first = split.split(program(), RADIUS, 3.0, 0.5, settings=LEFT)
    cut = nc.parse(first.result.text, "first.nc")
    half = simulate(cut, its, first.result.compensated, stock=stock_of(its, nominal()))
    result = corrected(touched(half, (0.0, -8.5)), allowance=(1.5,), iterate=0.01)
    assert result.prediction.machine.kx == pytest.approx(1200.0, rel=5e-3)
    both = simulate(nc.parse(result.text, "second.nc"), its, nominal(), earlier=cut)
    assert both.largest <= 0.0105


# --- what cannot be


def test_what_is_missing_is_named():
    m = touched(as_cut(), (0.0, -10.0))
    with pytest.raises(UsageError, match="--setup"):
        pipeline.correct(pipeline.Request(program(), RADIUS, m, None, replace(LEFT, method="combined")))
    with pytest.raises(UsageError, match="--measured"):
        corrected(None)
    with pytest.raises(UsageError, match="diameter_mm 20 is not the tool diameter"):
        pipeline.correct(pipeline.Request(program(), 8.0, m, None, replace(LEFT, method="combined"), setup=setup()))
    with pytest.raises(UsageError, match="--iterate belongs to"):
        Settings(iterate=0.01)
    with pytest.raises(UsageError, match="neither --gain"):
        Settings(method="predicted", iterate=0.01, gain=0.5)


@pytest.mark.thorough
def test_what_an_elastic_machine_leaves_of_the_allowance_is_no_mistake():
    """Touches 0.28 mm off all along: no ball of 0.28 mm, but MS 0.1 of 3 mm; the whole of it must be believable."""
    along = [(x, -10.0) for x in (-5.0, 0.0, 5.0, 10.0)]
    soft = simulate(program(), softer(350.0, 350.0), nominal())
    result = corrected(touched(soft, *along), gain=0.5)
    assert any("transfer function of 0.10" in text for text in result.warnings)
    m = touched(soft, *along)
    far = replace(m, points=m.points + [0.0, 0.2, 0.0])
    with pytest.raises(DistrustError, match="ball-not-compensated"):
        corrected(far, gain=0.5)
