# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations of measured points: sign, size, and which points are believed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.comparison.deviation import Deviation, deviations, statistics
from millcorr.errors import InputError
from millcorr.geometry.profile import Contour, Profile
from millcorr.readers.measurement import Measurement
from tests.core.contours import (
    Element,
    Part,
    closed_spline,
    facetted_circle,
    moved_sides,
    parts,
    pocket,
    polyline,
    profile_of,
    rectangle,
    scipy_closed_spline,
    spline_poles,
    turns,
)
from tests.core.sweeps import examples

EXACT = 1e-9


def measured(points, normals=None, ball: float = 0.0, z=0.0) -> Measurement:
    points = np.asarray(points, dtype=float).reshape(-1, 2)
    full = np.column_stack([points, np.broadcast_to(z, len(points))])
    if normals is not None:
        normals = np.column_stack([np.broadcast_to(normals, points.shape), np.zeros(len(points))])
    return Measurement(full, normals, ball, np.arange(1, len(points) + 1), "part.csv", "0" * 64)


def reasons(d: Deviation) -> dict[int, str]:
    return {r.index: r.reason for r in d.rejected}


# Value, sign, components


@settings(max_examples=examples(25), deadline=None, derandomize=True)
@given(poles=spline_poles(), seed=st.integers(0, 99), ball=st.sampled_from([0.0, 1.0]), reverse=st.booleans())
def test_displaced_points_of_a_spline_give_their_displacement(poles, seed, ball, reverse):
    """Points moved along scipy's normal by d, and further by the ball for centres."""
    oracle = scipy_closed_spline(poles)
    rng = np.random.default_rng(seed)
    u = rng.uniform(0.0, len(poles), 50)
    tangent = oracle.derivative()(u)
    tangent /= np.hypot(*tangent.T)[:, None]
    out = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
    d = rng.uniform(-0.3, 0.3, 50)
    curve = closed_spline(poles)
    if reverse:
        # The same line with the material outside.
        curve, out = curve.reversed(), -out
    profile = Profile.from_contours([Contour((curve,), True)])
    # A ball of 1 mm touches where the hollow is wider than it.
    result = deviations(measured(oracle(u) + (d + ball)[:, None] * out, ball=ball), profile)
    assert result.rejected == ()
    np.testing.assert_allclose(result.value, d, atol=EXACT)
    np.testing.assert_allclose(result.foot, oracle(u), atol=EXACT)
    np.testing.assert_allclose(result.normal, out, atol=1e-8)
    # werner-2018, eq. 1, and eq. 2 with the foot: the measured point again.
    np.testing.assert_allclose(result.components, d[:, None] * out, atol=EXACT)
    np.testing.assert_allclose(result.foot + result.components, oracle(u) + d[:, None] * out, atol=EXACT)


def test_excess_is_positive_inside_and_outside():
    for part, grown in ((rectangle(60.0, 40.0), -0.02), (pocket(60.0, 40.0), 0.02)):
        # 0.02 mm of material too much: a larger block, a smaller pocket.
        result = deviations(measured([[30.0, grown], [60.0 - grown, 20.0]]), part.profile)
        np.testing.assert_allclose(result.value, 0.02, atol=1e-12)


def test_order_start_and_direction_do_not_matter():
    rng = np.random.default_rng(3)
    profile = rectangle(60.0, 40.0, 8.0).profile
    s = rng.uniform(0.0, float(profile.total[0]), 300)
    p, n = profile.at(0, s)
    points = p + rng.normal(0, 0.01, 300)[:, None] * n
    first = deviations(measured(points), profile)
    mixed = rng.permutation(300)
    again = deviations(measured(points[mixed]), profile)
    np.testing.assert_array_equal(again.value, first.value[mixed])
    np.testing.assert_array_equal(again.s, first.s[mixed])
    np.testing.assert_allclose(first.s, s, atol=1e-8)
    # Alone or among many, by another way through the search.
    many = np.concatenate([points, np.repeat(points, 100, axis=0)])
    np.testing.assert_allclose(deviations(measured(many), profile).value[:300], first.value, atol=1e-12)


def test_levels_are_kept_apart():
    z = np.array([-1.0, -1.01, -4.0, -1.0])
    result = deviations(measured([[10, 0.0], [20, 0.01], [30, 0], [40, 0]], z=z), rectangle(60.0, 40.0).profile)
    np.testing.assert_array_equal(result.level, [1, 1, 0, 1])
    np.testing.assert_array_equal(result.z, z)


def test_contour_and_stretch_of_each_point():
    a, b = rectangle(60.0, 40.0), Part(rectangle(30.0, 20.0).vertices + [100.0, 0.0], (0.0,) * 4)
    profile = Profile.from_contours([Contour(tuple(e.curve() for e in p.elements), True) for p in (a, b)])
    result = deviations(measured([[30, 0], [60, 10], [130, 10], [115, 20]]), profile)
    np.testing.assert_array_equal(result.contour, [0, 0, 1, 1])
    np.testing.assert_array_equal(result.stretch, [0, 1, 5, 6])
    np.testing.assert_allclose(result.s, [30, 70, 40, 65], atol=EXACT)


def test_statistics():
    value = np.array([0.003, 0.017, 0.010, 0.012])
    assert statistics(value) == pytest.approx(
        {"mean": 0.0105, "min": 0.003, "max": 0.017, "height": 0.014, "std": np.sqrt(0.000101 / 3)}
    )
    one = statistics(np.array([0.5]))
    assert one == {"mean": 0.5, "min": 0.5, "max": 0.5, "height": 0.0, "std": 0.0}
    assert all(np.isnan(v) for v in statistics(np.zeros(0)).values())


# Corners


def test_corner_without_normals_is_rejected():
    result = deviations(measured([[30, -0.01], [-0.01, -0.01], [60.02, -0.005]]), rectangle(60.0, 40.0).profile)
    np.testing.assert_array_equal(result.index, [0])
    assert "at a corner" in reasons(result)[1] and "at a corner" in reasons(result)[2]


@pytest.mark.parametrize("ball", [0.0, 1.5])
@pytest.mark.parametrize("index", range(4))
def test_corner_with_normals_belongs_to_the_measured_side(index, ball):
    """Just beyond a corner: the normal of the file tells the side, its deviation and its stretch."""
    profile = rectangle(60.0, 40.0).profile
    v = rectangle(60.0, 40.0).vertices
    outward = np.array([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])
    before, after = outward[index - 1], outward[index]
    points, normals = [], []
    for n, other, d in ((before, after, 0.03), (after, before, -0.0)):
        # d of excess along the side's normal, 0.01 mm past the corner along the side.
        points.append(v[index] + (d + ball) * n + 0.01 * other)
        normals.append(n)
    result = deviations(measured(points, np.array(normals), ball), profile)
    assert result.rejected == ()
    np.testing.assert_allclose(result.value, [0.03, 0.0], atol=1e-12)
    np.testing.assert_allclose(result.normal, normals, atol=1e-12)
    np.testing.assert_array_equal(result.stretch, [(index - 1) % 4, index])
    total = 200.0
    at = (profile.stretches()[index].begin) % total
    assert np.abs((result.s - at + 1) % total - 1).max() < 1e-9


def test_normal_that_fits_neither_side_of_a_corner_is_no_help():
    n = np.array([[-np.sqrt(0.5), -np.sqrt(0.5)]])
    result = deviations(measured([[-0.01, -0.01], [30, 0]], np.vstack([n, [[0, -1]]])), rectangle(60.0, 40.0).profile)
    assert "at a corner" in reasons(result)[0]


def test_undercut_next_to_a_corner_goes_by_the_normal():
    """0.025 mm inside the bottom side, 0.01 mm from the right side: only the normal tells which."""
    p = [[59.99, 0.025]]
    profile = rectangle(60.0, 40.0).profile
    filler = [[10.0, 0.0], [20.0, 0.0]]
    down, right = [0.0, -1.0], [1.0, 0.0]
    for normal, value, stretch in ((down, -0.025, 0), (right, -0.01, 1)):
        result = deviations(measured(p + filler, np.array([normal, down, down])), profile)
        assert result.index[0] == 0 and result.stretch[0] == stretch
        np.testing.assert_allclose(result.value[0], value, atol=1e-12)
    result = deviations(measured(p + filler), profile)
    assert "two branches" in reasons(result)[0]


def test_large_undercut_next_to_a_corner_is_not_taken_for_a_small_one():
    """The bottom lies 0.08 mm too deep everywhere, the right side is good; no normals.

    A point of the bottom 0.015 mm from the right side lies there nearer: as its deviation -0.015 would be wrong
    by 0.065 mm or by 0.015 mm, nobody can say which; it must not be used.
    """
    x = np.concatenate([np.linspace(1.0, 59.0, 50), [59.985]])
    points = np.column_stack([x, np.full(51, 0.08)])
    result = deviations(measured(points), rectangle(60.0, 40.0).profile)
    assert "two branches" in reasons(result)[50]
    np.testing.assert_allclose(result.value, -0.08, atol=1e-12)


def test_smooth_facets_are_no_corners():
    v = facetted_circle(40.0, 2000)
    profile = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    rng = np.random.default_rng(0)
    angle = np.concatenate([rng.uniform(0, 2 * np.pi, 200), np.arange(50) * 2 * np.pi / 2000])
    points = 40.02 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    result = deviations(measured(points), profile)
    assert result.rejected == ()
    # Between corner (exact) and middle of a facet (sagitta 0.05 um).
    assert np.abs(result.value - 0.02).max() < 5e-5


# Thin walls, ends, far points


def test_thin_wall():
    """A wall of 0.5 mm: the nearer side where it is clear, the normal where it is not."""
    wall = rectangle(60.0, 0.5).profile
    result = deviations(measured([[10.0, -0.05], [20.0, 0.52], [30.0, 0.245], [40.0, 0.02]]), wall)
    np.testing.assert_array_equal(result.index, [0, 1, 3])
    np.testing.assert_allclose(result.value, [0.05, 0.02, -0.02], atol=1e-12)
    assert "two branches" in reasons(result)[2]
    result = deviations(measured([[30.0, 0.245], [30.0, 0.3]], np.array([[0.0, -1.0], [0.0, -1.0]])), wall)
    np.testing.assert_allclose(result.value, [-0.245, -0.3], atol=1e-12)
    np.testing.assert_array_equal(result.stretch, [0, 0])


def test_beyond_open_ends():
    profile = profile_of([Element(np.zeros(2), np.array([60.0, 0.0]))], closed=False)
    result = deviations(measured([[-0.1, -0.01], [0.0, -0.02], [30.0, -0.03], [60.0, 0.01], [60.01, 0.0]]), profile)
    np.testing.assert_array_equal(result.index, [1, 2, 3])
    np.testing.assert_allclose(result.value, [0.02, 0.03, -0.01], atol=1e-12)
    assert all("beyond the end" in reasons(result)[i] for i in (0, 4))


def test_points_of_another_side_near_an_open_end_are_told_by_their_normals():
    """The end face of a bar, 0.3 mm off the end of its long side: near the profile, and no deviation of it."""
    profile = profile_of([Element(np.zeros(2), np.array([40.0, 0.0]))], closed=False)
    points = np.array([[10.0, 0.01], [39.9, 0.3], [39.9, -0.4], [20.0, -0.02]])
    side = np.array([0.0, -1.0])
    end = np.array([1.0, 0.0])
    tilted = np.cos(np.radians(50)) * side + np.sin(np.radians(50)) * end
    d = deviations(measured(points, np.stack([side, end, end, tilted])), profile)
    assert d.index.tolist() == [0, 3]
    assert set(reasons(d)) == {1, 2} and all("another surface" in why for why in reasons(d).values())
    # The other way round, and without normals, every point counts: that is for the whole file to say.
    turned = deviations(measured(points, -np.tile(side, (4, 1))), profile)
    assert len(turned.index) == len(deviations(measured(points), profile).index) == 4


def test_far_points_are_called_far_wherever_they_lie():
    """Outside, at the middle between all sides, past a corner."""
    profile = rectangle(60.0, 40.0).profile
    result = deviations(measured([[30.0, -1.5], [30.0, 20.0], [-3.0, -4.0], [30.0, -0.9]]), profile)
    np.testing.assert_array_equal(result.index, [3])
    assert all("farther than 1 mm" in reasons(result)[i] for i in (0, 1, 2))
    result = deviations(measured([[30.0, -1.5], [30.0, 0.0]]), profile, reach=2.0)
    assert result.rejected == () and abs(result.value[0] - 1.5) < 1e-12


def test_no_usable_point():
    with pytest.raises(InputError, match=r"part\.csv: none of the 2 points .* farther than 1 mm .*unit, work frame"):
        deviations(measured([[3000.0, 0.0], [0.0, 700.0]]), rectangle(60.0, 40.0).profile)


def test_rejected_and_used_are_all_points():
    rng = np.random.default_rng(5)
    points = rng.uniform(-3, 63, (400, 2))
    result = deviations(measured(points), rectangle(60.0, 40.0).profile, cutter_radius=5.0)
    index = np.concatenate([result.index, [r.index for r in result.rejected]])
    np.testing.assert_array_equal(np.sort(index), np.arange(400))


# Out of the cutter's reach


@settings(max_examples=examples(30), deadline=None, derandomize=True)
@given(part=parts(), side=st.integers(0, 6), end=st.booleans(), R=st.floats(0.5, 5.0))
def test_inner_corners_are_out_of_reach_up_to_the_tangent_point(part, side, end, R):
    """Beside a sharp concave corner turning by w the cutter leaves R tan(w / 2) of either side."""
    part = Part(part.vertices, (0.0,) * len(part.vertices))
    n = len(part.vertices)
    i = side % n
    j = (i + 1) % n
    corner = j if end else i
    turn = float(turns(part.vertices)[corner])
    a, b = part.vertices[i], part.vertices[j]
    along = (b - a) / np.hypot(*(b - a)) * (-1 if end else 1)
    kept_off = R * np.tan(max(-turn, 0.0) / 2)
    # Within REACHED of contact the cutter counts as there: that is 1e-3 / sin(turn) along the side.
    slack = 1e-3 / abs(np.sin(turn)) * 1.01 + 1e-6
    distances = np.array([kept_off - slack, kept_off + slack]) if turn < 0 else np.array([0.02, 0.05])
    points = part.vertices[corner] + distances[:, None] * along
    middle = (a + b) / 2
    normals = np.array([along[1], -along[0]]) * (-1 if end else 1)
    result = deviations(measured([*points, middle], normals), part.profile, cutter_radius=R)
    if turn < 0 and distances[0] > 0:
        assert "cannot reach" in reasons(result)[0]
    # The far end of the side may have a corner of its own.
    if kept_off + slack < 5.0 and R * np.tan(1.1) < 5.0:
        assert 1 in result.index


def test_hollow_tighter_than_the_cutter():
    part = pocket(60.0, 40.0, 6.0)
    profile = part.profile
    corner = np.array([60.0 - 6.0 * (1 - np.sqrt(0.5))] * 2) * [1, 0] + [0, 6.0 * (1 - np.sqrt(0.5))]
    points = [corner, [30.0, 0.0]]
    assert deviations(measured(points), profile, cutter_radius=5.9).rejected == ()
    result = deviations(measured(points), profile, cutter_radius=6.1)
    assert "cannot reach" in reasons(result)[0] and 1 in result.index
    assert deviations(measured(points), profile).rejected == ()


def test_slot_narrower_than_the_cutter():
    """Parallel sides, no corner near: the cutter does not go in."""
    v = [[0, 0], [40, 0], [40, 30], [28, 30], [28, 5], [20, 5], [20, 30], [0, 30]]
    part = Part(np.array(v, dtype=float), (0.0,) * 8)
    points = [[28.0, 20.0], [20.0, 20.0], [40.0, 15.0]]
    result = deviations(measured(points), part.profile, cutter_radius=4.1)
    np.testing.assert_array_equal(result.index, [2])
    assert deviations(measured(points), part.profile, cutter_radius=3.9).rejected == ()
    # Exactly as wide as the cutter it does.
    assert deviations(measured(points), part.profile, cutter_radius=4.0).rejected == ()


def test_hollow_facets_are_within_reach():
    v = facetted_circle(40.0, 2000)[::-1].copy()
    profile = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    angle = np.linspace(0, 2 * np.pi, 700)
    points = 40.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    assert deviations(measured(points), profile, cutter_radius=5.0).rejected == ()


def test_no_loop_over_measured_points():
    import time

    part = rectangle(60.0, 40.0, 8.0)
    profile = part.profile
    s = np.random.default_rng(0).uniform(0.0, float(profile.total[0]), 500_000)
    p, n = profile.at(0, s)
    begin = time.process_time()
    result = deviations(measured(p + 0.01 * n), profile, cutter_radius=5.0)
    assert time.process_time() - begin < 5.0
    np.testing.assert_allclose(result.value, 0.01, atol=EXACT)


@settings(max_examples=examples(20), deadline=None, derandomize=True)
@given(part=parts(), c=st.floats(-0.2, 0.2), seed=st.integers(0, 99))
def test_part_of_a_wrong_size_deviates_by_the_same_all_round(part, c, seed):
    """A polygon cut c too large: every point of its sides that is nobody else's deviates by c."""
    part = Part(part.vertices, (0.0,) * len(part.vertices))
    v = moved_sides(part.vertices, c)
    rng = np.random.default_rng(seed)
    side = rng.integers(0, len(v), 60)
    u = rng.uniform(0.0, 1.0, (60, 1))
    points = v[side] * (1 - u) + np.roll(v, -1, axis=0)[side] * u
    result = deviations(measured(points), part.profile)
    assert len(result) > 30
    np.testing.assert_allclose(result.value, c, atol=EXACT)
    np.testing.assert_array_equal(result.stretch, side[result.index])
