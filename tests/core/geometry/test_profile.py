# SPDX-License-Identifier: LGPL-2.1-or-later
import json
import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.special import ellipe

from millcorr.errors import FormatError, InputError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile, join
from millcorr.virtual.simulated_machine import reference_contour
from tests.core.sweeps import examples


def circle(radius=10.0, centre=(3.0, -2.0), sweep=2 * np.pi):
    c = np.array(centre)
    start = c + [radius, 0]
    return Profile.from_contours([join([NurbsCurve.arc(start, start, c, sweep)])])


def ellipse(a, b):
    arc = NurbsCurve.arc((1, 0), (1, 0), (0, 0), 2 * np.pi)
    curve = NurbsCurve(2, arc.poles * [a, b], arc.weights, arc.knots, arc.multiplicities)
    return Profile.from_contours([join([curve])])


def polygon(points, closed=True):
    points = [np.array(p, dtype=float) for p in points]
    ends = [*points[1:], points[0]] if closed else points[1:]
    return Profile.from_contours([join([NurbsCurve.line(a, b) for a, b in zip(points, ends, strict=False)])])


def rounded_square(side=20.0, radius=4.0):
    h, r = side / 2, side / 2 - radius
    curves = []
    for k in range(4):
        turn = np.linalg.matrix_power(np.array([[0, -1], [1, 0]]), k)
        p = [turn @ np.array(q, float) for q in ((-r, -h), (r, -h), (h, -r), (r, -r))]
        curves += [NurbsCurve.line(p[0], p[1]), NurbsCurve.arc(p[1], p[2], p[3], np.pi / 2)]
    return Profile.from_contours([join(curves)])


def random_spline(seed, count=9, size=40.0):
    """Closed cubic B-spline about the origin, star-shaped poles, anticlockwise."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * (np.arange(count) + rng.uniform(-0.3, 0.3, count)) / count
    radius = size * rng.uniform(0.6, 1.3, count)
    poles = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    curve = NurbsCurve(3, poles, np.ones(count), np.arange(count + 1.0), np.ones(count + 1, dtype=int), periodic=True)
    return Profile.from_contours([Contour((curve,), True)]), curve


def test_circle():
    p = circle(10.0)
    assert p.total[0] == pytest.approx(20 * np.pi, abs=1e-10)
    assert p.signed_areas()[0] == pytest.approx(100 * np.pi, abs=1e-9)
    s = np.linspace(0, 60, 301)
    point, normal = p.at(0, s)
    outward = np.stack([np.cos(s / 10), np.sin(s / 10)], axis=1)
    np.testing.assert_allclose(point, [3, -2] + 10 * outward, atol=1e-10)
    np.testing.assert_allclose(normal, outward, atol=1e-11)
    np.testing.assert_allclose(p.curvature(*p.locate(0, s)), 0.1, rtol=1e-10)
    np.testing.assert_allclose(p.bounding_box(), (-7, -12, 13, 8), atol=1e-5)
    hole = circle(10.0, sweep=-2 * np.pi)
    assert hole.signed_areas()[0] == pytest.approx(-100 * np.pi, abs=1e-9)
    point, normal = hole.at(0, s)
    np.testing.assert_allclose(normal, ([3, -2] - point) / 10, atol=1e-11)
    np.testing.assert_allclose(hole.curvature(*hole.locate(0, s)), -0.1, rtol=1e-10)


@pytest.mark.parametrize(("a", "b"), [(30.0, 20.0), (50.0, 5.0), (7.0, 7.0)])
def test_ellipse(a, b):
    p = ellipse(a, b)
    assert p.total[0] == pytest.approx(4 * a * ellipe(1 - b * b / a / a), abs=1e-9)
    assert p.signed_areas()[0] == pytest.approx(np.pi * a * b, abs=1e-8)
    span, t = p.locate(0, np.linspace(0, p.total[0], 200, endpoint=False))
    c, _, _ = p.evaluate(span, t)
    x, y = c.T
    np.testing.assert_allclose((x / a) ** 2 + (y / b) ** 2, 1, atol=1e-12)
    gradient = np.stack([x / a**2, y / b**2], axis=1)
    np.testing.assert_allclose(p.normals(span, t), gradient / np.hypot(*gradient.T)[:, None], atol=1e-11)
    theta = np.arctan2(y / b, x / a)
    curvature = a * b / np.hypot(a * np.sin(theta), b * np.cos(theta)) ** 3
    np.testing.assert_allclose(p.curvature(span, t), curvature, rtol=1e-9)


def test_line():
    p = polygon([(1, 1), (4, 5)], closed=False)
    assert not p.contours[0].closed
    assert p.total[0] == pytest.approx(5, abs=1e-14)
    point, normal = p.at(0, [-1, 2.5, 9])
    np.testing.assert_allclose(point, [[1, 1], [2.5, 3], [4, 5]], atol=1e-14)
    np.testing.assert_allclose(normal, [[0.8, -0.6]] * 3, atol=1e-15)
    np.testing.assert_array_equal(p.curvature(*p.locate(0, [1.0])), 0)


@settings(max_examples=examples(25), deadline=None)
@given(seed=st.integers(0, 10**6))
def test_arc_length_against_quadrature(seed):
    profile, curve = random_spline(seed)
    poles = np.vstack([curve.poles] * 3)
    count = len(curve.poles)

    def speed(u, k):
        # Uniform cubic B-spline, differentiated by hand.
        q = poles[(k + np.arange(4)) % count]
        b = np.array([-((1 - u) ** 2) / 2, (3 * u * u - 4 * u) / 2, (-3 * u * u + 2 * u + 1) / 2, u * u / 2])
        return np.hypot(*(b @ q))

    total = sum(quad(speed, 0, 1, args=(k,), epsabs=1e-12, epsrel=1e-12, limit=200)[0] for k in range(count))
    assert profile.total[0] == pytest.approx(total, abs=1e-9)


@settings(max_examples=examples(40), deadline=None)
@given(seed=st.integers(0, 10**6), where=st.lists(st.floats(-1.5, 2.5), min_size=1, max_size=20))
def test_locate_inverts_arc_length(seed, where):
    profile, _ = random_spline(seed, size=200.0)
    s = np.array(where) * profile.total[0]
    span, t = profile.locate(0, s)
    assert ((t >= 0) & (t <= 1)).all()
    gap = profile.arc_length(span, t) - np.mod(s, profile.total[0])
    gap -= profile.total[0] * np.round(gap / profile.total[0])
    np.testing.assert_allclose(gap, 0, atol=1e-9)


@settings(max_examples=examples(20), deadline=None)
@given(seed=st.integers(0, 10**6))
def test_derivatives_against_differences(seed):
    profile, _ = random_spline(seed)
    rng = np.random.default_rng(seed)
    span = rng.integers(0, profile.spans, 30)
    t = rng.uniform(0.1, 0.9, 30)
    h = 1e-4
    c, d1, d2 = profile.evaluate(span, t)
    up, down = profile.evaluate(span, t + h)[0], profile.evaluate(span, t - h)[0]
    np.testing.assert_allclose(d1, (up - down) / (2 * h), atol=1e-5)
    np.testing.assert_allclose(d2, (up - 2 * c + down) / h**2, atol=1e-4)
    n = profile.normals(span, t)
    np.testing.assert_allclose((n * d1).sum(axis=1), 0, atol=1e-11)
    np.testing.assert_allclose(np.hypot(*n.T), 1, atol=1e-14)


def test_rational_spans_too():
    profile = ellipse(30.0, 11.0)
    span = np.arange(profile.spans).repeat(3)
    t = np.tile([0.2, 0.5, 0.8], profile.spans)
    h = 1e-4
    c, d1, d2 = profile.evaluate(span, t)
    up, down = profile.evaluate(span, t + h)[0], profile.evaluate(span, t - h)[0]
    np.testing.assert_allclose(d1, (up - down) / (2 * h), atol=1e-5)
    np.testing.assert_allclose(d2, (up - 2 * c + down) / h**2, atol=1e-4)


def test_stretches_end_at_corners():
    square = polygon([(0, 0), (10, 0), (10, 10), (0, 10)])
    stretches = square.stretches()
    np.testing.assert_allclose([s.length for s in stretches], 10, rtol=1e-14)
    assert not any(s.closed for s in stretches)
    np.testing.assert_allclose(square.turn, np.pi / 2)
    smooth = rounded_square().stretches()
    assert len(smooth) == 1 and smooth[0].closed
    assert smooth[0].length == pytest.approx(4 * 12 + 8 * np.pi, abs=1e-10)


def test_a_single_corner_need_not_be_the_seam():
    # A drop: two tangents to a circle meet at (8, 0).
    sides = [NurbsCurve.line((0, -4), (8, 0)), NurbsCurve.line((8, 0), (0, 4))]
    arc = NurbsCurve.arc((0, 4), (0, -4), (-2, 0), 2 * np.pi - 2 * np.arctan2(4, 2))
    for curves in ([*sides, arc], [arc, *sides], [sides[1], arc, sides[0]]):
        drop = Profile.from_contours([join(curves)])
        (stretch,) = drop.stretches()
        assert not stretch.closed
        assert stretch.length == pytest.approx(drop.total[0], rel=1e-14)
        np.testing.assert_allclose(drop.at(0, [stretch.begin])[0], [[8, 0]], atol=1e-9)


def test_a_stretch_may_run_over_the_seam():
    # The contour starts in the middle of a side.
    p = polygon([(5, 0), (10, 0), (10, 10), (0, 10), (0, 0)])
    stretches = p.stretches()
    np.testing.assert_allclose([s.length for s in stretches], 10, rtol=1e-14)
    over = next(s for s in stretches if s.begin + s.length > 41)
    assert over.begin == pytest.approx(35)


def test_facets_are_no_corners():
    angle = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    p = polygon(20 * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    assert len(p.stretches()) == 1 and p.stretches()[0].closed


def test_open_contours_do_not_wrap():
    p = polygon([(0, 0), (10, 0), (10, 10)], closed=False)
    assert np.isnan(p.turn[-1])
    np.testing.assert_allclose(p.at(0, [25.0])[0], [[10, 10]])
    assert p.neighbour(np.array([0, 1]), -1).tolist() == [0, 0]
    assert p.neighbour(np.array([0, 1]), 1).tolist() == [1, 1]


def test_reversed_turns_the_normals_round():
    profile, _ = random_spline(5)
    back = profile.reversed()
    s = np.linspace(0, profile.total[0], 40)
    point, normal = profile.at(0, s)
    other, opposite = back.at(0, profile.total[0] - s)
    np.testing.assert_allclose(other, point, atol=1e-9)
    np.testing.assert_allclose(opposite, -normal, atol=1e-9)
    assert back.signed_areas()[0] == pytest.approx(-profile.signed_areas()[0], rel=1e-12)


def test_json(tmp_path):
    profile, _ = random_spline(5)
    path = tmp_path / "profile.json"
    path.write_text(json.dumps(profile.as_dict()))
    back = Profile.read_json(path)
    s = np.linspace(0, profile.total[0], 40)
    np.testing.assert_array_equal(back.at(0, s)[0], profile.at(0, s)[0])
    for content in ("", "{}", "[]", '{"contours": [{}]}', "\x00", '{"unit": "inch", "contours": []}', "null"):
        path.write_text(content)
        with pytest.raises((FormatError, InputError)):
            Profile.read_json(path)
    with pytest.raises(FormatError):
        Profile.read_json(tmp_path / "missing.json")


def test_contours_that_are_none():
    with pytest.raises(InputError):
        Profile.from_contours([])
    with pytest.raises(InputError):
        polygon([(1, 1), (1, 1)], closed=False)
    with pytest.raises(InputError, match="gap"):
        Profile.from_contours([Contour((NurbsCurve.line((0, 0), (1, 0)), NurbsCurve.line((1.1, 0), (2, 0))), False)])
    with pytest.raises(InputError, match="cusp|stands still"):
        poles = np.array([[0.0, 0], [10, 10], [0, 10], [10, 0]])
        Profile.from_contours(
            [Contour((NurbsCurve(3, poles, np.ones(4), np.array([0.0, 1]), np.array([4, 4])),), False)]
        )


def test_reference_contour():
    p = reference_contour()
    assert p.total[0] == pytest.approx(223.98, abs=0.005)
    curvature = p.curvature(*p.locate(0, np.linspace(0, p.total[0], 20_000)))
    assert 1 / curvature.max() > 8 and -1 / curvature.min() > 8
    assert curvature.max() > 0 > curvature.min()
    assert p.signed_areas()[0] > 0
    assert reference_contour(2.0).total[0] == pytest.approx(2 * p.total[0], rel=1e-12)


def test_a_hundred_thousand_facets():
    angle = 2 * np.pi * np.arange(100_001) / 100_000
    points = 50 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points[-1] = points[0]
    mult = np.ones(100_001, dtype=int)
    mult[[0, -1]] = 2
    start = time.perf_counter()
    p = Profile.from_contours([join([NurbsCurve(1, points, np.ones(100_001), np.arange(100_001.0), mult)])])
    assert time.perf_counter() - start < 10
    assert p.total[0] == pytest.approx(2e5 * 50 * np.sin(np.pi / 1e5), rel=1e-10)
    assert len(p.stretches()) == 1
