# SPDX-License-Identifier: LGPL-2.1-or-later
import time

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile, join
from millcorr.virtual.simulated_machine import reference_contour
from tests.core.sweeps import examples

EXACT = 1e-9
FILL = 4000
"""Points that, put among a few, make a search take the way for many."""


def arc_loop(radius, centre, sweep=2 * np.pi):
    start = np.array(centre, dtype=float) + [radius, 0]
    return join([NurbsCurve.arc(start, start, centre, sweep)])


def ellipse(a, b):
    arc = NurbsCurve.arc((1, 0), (1, 0), (0, 0), 2 * np.pi)
    curve = NurbsCurve(2, arc.poles * [a, b], arc.weights, arc.knots, arc.multiplicities)
    return Profile.from_contours([join([curve])])


def polygon(points, closed=True):
    points = [np.array(p, dtype=float) for p in points]
    ends = [*points[1:], points[0]] if closed else points[1:]
    return Profile.from_contours([join([NurbsCurve.line(a, b) for a, b in zip(points, ends, strict=False)])])


def random_spline(seed, count=9, size=40.0, weights=False):
    """Closed cubic B-spline about the origin, star-shaped poles, anticlockwise."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * (np.arange(count) + rng.uniform(-0.3, 0.3, count)) / count
    radius = size * rng.uniform(0.6, 1.3, count)
    poles = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    w = rng.uniform(0.5, 2, count) if weights else np.ones(count)
    curve = NurbsCurve(3, poles, w, np.arange(count + 1.0), np.ones(count + 1, dtype=int), periodic=True)
    return Profile.from_contours([Contour((curve,), True)])


def find_both_ways(profile, points):
    """Foot points as found for few points and, the same, among many and without a look at other branches."""
    points = np.asarray(points, dtype=float)
    few = FootPointSearch(profile).find(points, rivals=True)
    n = len(points)
    fill = np.tile(points, (FILL // n + 10, 1))
    fill += np.random.default_rng(0).normal(0, 0.03, fill.shape)
    search = FootPointSearch(profile)
    many = search.find(np.vstack([points, fill]), rivals=True)
    assert max(grid.known.sum() for grid in search._steps.grids.values()) > 1
    certain = few.rival > 1e-6
    for same in (many, FootPointSearch(profile).find(points)):
        np.testing.assert_allclose(same.distance[:n], few.distance, atol=EXACT)
        np.testing.assert_allclose(same.foot[:n][certain], few.foot[certain], atol=1e-7)
        np.testing.assert_array_equal(same.place[:n][certain], few.place[certain])
    return few


def brute_force_distance(profile, point):
    """Distance by dense sampling and minimisation about the lowest samples, without derivatives."""
    best = np.inf
    for k in range(len(profile.contours)):
        total = float(profile.total[k])
        s = np.linspace(0, total, 4001)
        d = np.hypot(*(profile.at(k, s)[0] - point).T)
        best = min(best, float(d.min()))
        lowest = np.flatnonzero((d <= np.roll(d, 1)) & (d <= np.roll(d, -1)))
        for i in lowest[np.argsort(d[lowest])[:4]]:
            step = s[1]
            bounds = (s[i] - step, s[i] + step)
            if not profile.contours[k].closed:
                bounds = (max(bounds[0], 0.0), min(bounds[1], total))

            def distance(v, k=k):
                return float(np.hypot(*(profile.at(k, [v])[0][0] - point)))

            best = min(best, minimize_scalar(distance, bounds=bounds, method="bounded",
                                             options={"xatol": 1e-10}).fun)  # fmt: skip
    return best


# --- closed forms -----------------------------------------------------------------------------------------


@given(
    radius=st.floats(0.5, 200),
    centre=st.tuples(st.floats(-300, 300), st.floats(-300, 300)),
    polar=st.lists(st.tuples(st.floats(0, 2 * np.pi), st.floats(0.05, 1.95)), min_size=1, max_size=20),
    hole=st.booleans(),
)
@settings(deadline=None)
def test_circle(radius, centre, polar, hole):
    profile = Profile.from_contours([arc_loop(radius, centre, -2 * np.pi if hole else 2 * np.pi)])
    angle, share = np.array(polar).T
    direction = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    feet = FootPointSearch(profile).find(np.array(centre) + radius * share[:, None] * direction)
    sign = -1 if hole else 1
    np.testing.assert_allclose(feet.distance, sign * radius * (share - 1), atol=EXACT)
    np.testing.assert_allclose(feet.foot, np.array(centre) + radius * direction, atol=1e-8)
    np.testing.assert_allclose(feet.normal, sign * direction, atol=1e-8)
    assert (feet.place == Place.SMOOTH).all()


@given(
    a=st.floats(5, 100),
    flat=st.floats(0.2, 1),
    where=st.lists(st.tuples(st.floats(0, 2 * np.pi), st.floats(-0.95, 3)), min_size=1, max_size=20),
)
@settings(deadline=None)
def test_ellipse(a, flat, where):
    b = a * flat
    theta, share = np.array(where).T
    foot = np.stack([a * np.cos(theta), b * np.sin(theta)], axis=1)
    normal = np.stack([b * np.cos(theta), a * np.sin(theta)], axis=1)
    normal /= np.hypot(*normal.T)[:, None]
    # Inside, a point nearer than the smallest radius of curvature has one foot.
    d = share * b * b / a
    feet = FootPointSearch(ellipse(a, b)).find(foot + d[:, None] * normal)
    np.testing.assert_allclose(feet.distance, d, atol=EXACT)
    np.testing.assert_allclose(feet.foot, foot, atol=1e-7)


def test_square_from_outside_and_inside():
    profile = polygon([(0, 0), (20, 0), (20, 20), (0, 20)])
    points = np.array([[10, -3], [23, 24], [-5, -12], [10, 19], [19, 12], [20, 20], [10, 0], [20.3, 20]])
    feet = find_both_ways(profile, points)
    np.testing.assert_allclose(feet.distance, [3, 5, 13, -1, -1, 0, 0, 0.3], atol=EXACT)
    assert feet.place.tolist() == [0, 1, 1, 0, 0, 1, 0, 1]
    np.testing.assert_allclose(feet.normal[1], [0.6, 0.8], atol=1e-12)
    np.testing.assert_allclose(feet.normal[0], [0, -1], atol=1e-15)
    # On the very corner the normal is the bisector.
    np.testing.assert_allclose(feet.normal[5], np.sqrt([0.5, 0.5]), atol=1e-12)


def test_concave_corner_from_the_material_side():
    # An L: the corner at (10, 10) is concave.
    profile = polygon([(0, 0), (30, 0), (30, 10), (10, 10), (10, 30), (0, 30)])
    points = np.array([[12.0, 13.0], [9.0, 9.5], [7.0, 6.0]])
    feet = find_both_ways(profile, points)
    np.testing.assert_allclose(feet.distance, [2, -np.hypot(1, 0.5), -5], atol=EXACT)
    assert feet.place.tolist()[:2] == [Place.SMOOTH, Place.JOINT]
    np.testing.assert_allclose(feet.normal[1], np.array([1, 0.5]) / np.hypot(1, 0.5), atol=1e-12)


def test_ends_of_open_contours():
    profile = polygon([(0, 0), (10, 0)], closed=False)
    points = np.array([[-3.0, 4.0], [13.0, -4.0], [5.0, 1.0], [0.0, 2.0], [10.0, -2.0], [-1e-3, 1.0]])
    feet = find_both_ways(profile, points)
    assert feet.place.tolist() == [Place.END, Place.END, 0, 0, 0, Place.END]
    np.testing.assert_allclose(feet.foot[:2], [[0, 0], [10, 0]], atol=1e-15)
    # Material on the left of +x: above the line is inside.
    np.testing.assert_allclose(feet.distance[2:5], [-1, -2, 2], atol=EXACT)


def test_plate_with_holes():
    profile = Profile.from_contours(
        [
            polygon([(0, 0), (60, 0), (60, 40), (0, 40)]).contours[0],
            arc_loop(8.0, (15, 20), -2 * np.pi),
            arc_loop(8.0, (40, 20), -2 * np.pi),
        ]
    )
    points = np.array([[15, 13.0], [15, 11.0], [33.0, 20.0], [31, 20.0], [30, 0.5], [30, -0.5], [15.5, 20.0]])
    feet = find_both_ways(profile, points)
    np.testing.assert_allclose(feet.distance, [1, -1, 1, -1, -0.5, 0.5, 7.5], atol=EXACT)
    assert profile.contour[feet.span].tolist() == [1, 1, 2, 2, 0, 0, 1]


# --- oracles ----------------------------------------------------------------------------------------------


@settings(max_examples=examples(12), deadline=None)
@given(seed=st.integers(0, 10**6), weights=st.booleans())
def test_random_splines_against_brute_force(seed, weights):
    profile = random_spline(seed, weights=weights)
    points = np.random.default_rng(seed).uniform(-60, 60, (12, 2))
    feet = FootPointSearch(profile).find(points)
    wanted = [brute_force_distance(profile, p) for p in points]
    np.testing.assert_allclose(np.abs(feet.distance), wanted, atol=EXACT)
    np.testing.assert_allclose(np.hypot(*(points - feet.foot).T), wanted, atol=EXACT)


@pytest.mark.few(1)
@pytest.mark.parametrize("profile", [reference_contour(), ellipse(40.0, 12.0), random_spline(11, weights=True)])
def test_distance_and_sign_against_shapely(profile):
    s = np.linspace(0, profile.total[0], 50_001)[:-1]
    ring = profile.at(0, s)[0]
    area = shapely.Polygon(ring)
    box = np.array(area.bounds).reshape(2, 2) + [[-10, -10], [10, 10]]
    points = np.random.default_rng(2).uniform(*box, (2000, 2))
    feet = find_both_ways(profile, points)
    wanted = shapely.distance(area.exterior, shapely.points(points))
    # The chord of 5 um leaves less than a nanometre on radii above 5 mm.
    np.testing.assert_allclose(np.abs(feet.distance), wanted, atol=3e-6)
    inside = shapely.contains_xy(area, points)
    clear = wanted > 1e-5
    np.testing.assert_array_equal((feet.distance < 0)[clear], inside[clear])


@settings(max_examples=examples(15), deadline=None)
@given(seed=st.integers(0, 10**6), near=st.booleans())
def test_few_and_many_points_go_different_ways_to_one_result(seed, near):
    profile = random_spline(seed)
    rng = np.random.default_rng(seed)
    if near:
        point, normal = profile.at(0, rng.uniform(0, profile.total[0], 200))
        points = point + rng.normal(0, 0.01, (200, 1)) * normal
    else:
        points = rng.uniform(-60, 60, (200, 2))
    feet = find_both_ways(profile, points)
    # The way back: from the foot along the normal to the point.
    np.testing.assert_allclose(feet.foot + feet.distance[:, None] * feet.normal, points, atol=1e-8)
    assert ((feet.t >= 0) & (feet.t <= 1)).all()


def test_deviations_put_on_come_back():
    profile = reference_contour()
    rng = np.random.default_rng(5)
    s = rng.uniform(0, profile.total[0], 200_000)
    d = rng.normal(0, 0.01, len(s))
    point, normal = profile.at(0, s)
    feet = FootPointSearch(profile).find(point + d[:, None] * normal, rivals=True)
    np.testing.assert_allclose(feet.distance, d, atol=1e-12)
    gap = profile.arc_length(feet.span, feet.t) - s
    gap -= profile.total[0] * np.round(gap / profile.total[0])
    np.testing.assert_allclose(gap, 0, atol=1e-9)
    assert np.isinf(feet.rival).all() or feet.rival.min() > 1


def test_line_and_arc_contour_against_shapely():
    # A slot with round ends, closed form through its centre line.
    slot = Profile.from_contours(
        [
            join(
                [
                    NurbsCurve.line((0, -5), (30, -5)),
                    NurbsCurve.arc((30, -5), (30, 5), (30, 0), np.pi),
                    NurbsCurve.line((30, 5), (0, 5)),
                    NurbsCurve.arc((0, 5), (0, -5), (0, 0), np.pi),
                ]
            )
        ]
    )
    points = np.random.default_rng(3).uniform((-15, -15), (45, 15), (3000, 2))
    points = points[np.abs(points[:, 1]) > 0.1]
    feet = find_both_ways(slot, points)
    x = np.clip(points[:, 0], 0, 30)
    wanted = np.hypot(points[:, 0] - x, points[:, 1]) - 5
    np.testing.assert_allclose(feet.distance, wanted, atol=EXACT)
    # Joints without a turn are no places of their own.
    assert (feet.place == Place.SMOOTH).all()


# --- places where the nearest point is not the right one, or not one --------------------------------------


def strip(width):
    return polygon([(0, 0), (50, 0), (50, width), (0, width)])


def test_thin_wall_with_measured_normals():
    # A wall 0.4 mm thick, cut 0.25 mm too deep from below: those points lie nearer to the upper side.
    profile = strip(0.4)
    x = np.linspace(5, 45, 40)
    points = np.stack([x, np.full(40, 0.25)], axis=1)
    down = np.tile([0.0, -1.0], (40, 1))
    search = FootPointSearch(profile)
    feet = search.find(points, rivals=True)
    np.testing.assert_allclose(feet.distance, -0.15, atol=EXACT)
    np.testing.assert_allclose(feet.rival, 0.1, atol=EXACT)
    right = search.on_the_side_of(points, down, feet)
    np.testing.assert_allclose(right.distance, -0.25, atol=EXACT)
    np.testing.assert_allclose(right.foot, np.stack([x, np.zeros(40)], axis=1), atol=EXACT)
    np.testing.assert_allclose(right.normal, down, atol=1e-12)
    # Normals that agree, or none, change nothing.
    for normals in (-down, np.zeros((40, 2))):
        same = search.on_the_side_of(points, normals, feet)
        np.testing.assert_array_equal(same.distance, feet.distance)


def test_rival_branches():
    profile = strip(10.0)
    feet = find_both_ways(profile, [[25, 5], [25, 4], [25, 4.999], [25, -1], [25, 0.2]])
    np.testing.assert_allclose(feet.rival[:3], [0, 2, 0.002], atol=1e-7)
    assert feet.rival[3] >= 9 and feet.rival[4] > 1
    circle = Profile.from_contours([arc_loop(10.0, (0, 0))])
    assert FootPointSearch(circle).find(np.zeros((1, 2))).distance[0] == pytest.approx(-10, abs=EXACT)


@pytest.mark.parametrize("offset", [0.0, 1e-9, -1e-9, 1e-4])
def test_points_on_the_medial_axis(offset):
    profile = ellipse(40.0, 12.0)
    # Inside the evolute's cusps the points of the major axis have two feet, mirror images of each other.
    x = np.linspace(-30, 30, 31)
    feet = find_both_ways(profile, np.stack([x, np.full(31, offset)], axis=1))
    cosine = x * 40 / (40**2 - 12**2)
    wanted = -np.hypot(x - 40 * cosine, 12 * np.sqrt(1 - cosine**2) - abs(offset))
    np.testing.assert_allclose(feet.distance, wanted, atol=max(EXACT, abs(offset) * 0.2))


def test_far_away():
    profile = reference_contour()
    points = np.array([[1e4, 2e4], [-5e5, 0.0], [50.0, 1e6]])
    feet = FootPointSearch(profile).find(points)
    wanted = [brute_force_distance(profile, p) for p in points]
    np.testing.assert_allclose(feet.distance, wanted, rtol=1e-13)
    many = FootPointSearch(profile).find(np.tile(points, (20_000, 1)))
    np.testing.assert_allclose(many.distance[:3], wanted, rtol=1e-13)


def test_no_points():
    feet = FootPointSearch(reference_contour()).find(np.empty((0, 2)))
    assert len(feet.distance) == 0 and feet.foot.shape == (0, 2)


def test_a_hundred_thousand_facets():
    n = 100_000
    angle = 2 * np.pi * np.arange(n + 1) / n
    points = 50 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points[-1] = points[0]
    mult = np.ones(n + 1, dtype=int)
    mult[[0, -1]] = 2
    profile = Profile.from_contours([join([NurbsCurve(1, points, np.ones(n + 1), np.arange(n + 1.0), mult)])])
    rng = np.random.default_rng(4)
    for count in (100, 20_000):
        theta = rng.uniform(0, 2 * np.pi, count)
        r = 50 + rng.normal(0, 0.05, count)
        start = time.perf_counter()
        feet = FootPointSearch(profile).find(r[:, None] * np.stack([np.cos(theta), np.sin(theta)], axis=1))
        assert time.perf_counter() - start < 20
        # The facets leave the circle by R (1 - cos(pi / n)) = 2.5e-8 mm.
        np.testing.assert_allclose(feet.distance, r - 50, atol=2.6e-8)


@settings(max_examples=examples(25), deadline=None)
@given(seed=st.integers(0, 10**6), closed=st.booleans(), spread=st.sampled_from([0.01, 0.3, 2.0]))
def test_sharp_corners_hide_nothing(seed, closed, spread):
    # Random polygons with acute spikes and wedges of both kinds, and random open polylines that cross themselves.
    rng = np.random.default_rng(seed)
    if closed:
        count = int(rng.integers(3, 20))
        angle = np.sort(rng.uniform(0, 2 * np.pi, count))
        if np.diff(angle).min() < 0.02:
            return
        corners = rng.uniform(10, 50, (count, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    else:
        corners = np.cumsum(rng.normal(0, 10, (10, 2)), axis=0)
    profile = polygon(corners, closed=closed)
    s = rng.uniform(0, profile.total[0], 6000)
    point, normal = profile.at(0, s)
    points = point + rng.normal(0, spread, (6000, 1)) * normal
    many = FootPointSearch(profile).find(points, rivals=True)
    line = shapely.LinearRing(corners) if closed else shapely.LineString(corners)
    wanted = shapely.distance(line, shapely.points(points))
    np.testing.assert_allclose(np.abs(many.distance)[many.place != Place.END],
                               wanted[many.place != Place.END], atol=EXACT)  # fmt: skip
    np.testing.assert_allclose(np.hypot(*(points - many.foot).T), wanted, atol=EXACT)
    search = FootPointSearch(profile)
    few = [search.find(points[a : a + 1500], rivals=True) for a in range(0, 6000, 1500)]
    rival = np.concatenate([f.rival for f in few])
    limit = np.clip(wanted, 0.02, 2.0)
    np.testing.assert_array_equal(many.rival < limit, rival < limit)


@pytest.mark.parametrize("count", [60, 400, 3000])
def test_facets_from_inside(count):
    angle = 2 * np.pi * np.arange(count) / count + np.random.default_rng(0).uniform(0, 0.5 / count, count)
    ring = 30 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rng = np.random.default_rng(1)
    theta, r = rng.uniform(0, 2 * np.pi, 10_000), 30 - rng.uniform(0, 2, 10_000)
    points = r[:, None] * np.stack([np.cos(theta), np.sin(theta)], axis=1)
    wanted = shapely.distance(shapely.LinearRing(ring), shapely.points(points))
    feet = FootPointSearch(polygon(ring)).find(points)
    np.testing.assert_allclose(np.abs(feet.distance), wanted, atol=EXACT)
