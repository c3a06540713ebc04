# SPDX-License-Identifier: LGPL-2.1-or-later
"""From deviations to the correction: a smooth function of arc length that says what it cannot know."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from millcorr.correction.compensation import correction_from, dead_band
from millcorr.errors import LimitError
from millcorr.geometry.correction import Correction, Course, along
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.tolerances import ALIKE
from tests.core.contours import Element, profile_of, rectangle, started_at
from tests.core.sweeps import examples

CIRCLE = 50.0
"""Radius of the circle; its length is 100 pi."""


def circle() -> Profile:
    p = np.array([CIRCLE, 0.0])
    return profile_of([Element(p, p, np.zeros(2), 2 * np.pi)])


def line(length: float = 100.0) -> Profile:
    return profile_of([Element(np.zeros(2), np.array([length, 0.0]))], closed=False)


def corrected(profile: Profile, s, value, number=None, limit: float = 1.0) -> tuple[Correction, tuple[str, ...]]:
    s, value = np.asarray(s, dtype=float), np.asarray(value, dtype=float)
    number = np.zeros(len(s), dtype=np.int64) if number is None else np.asarray(number)
    return correction_from(profile, number, s, value, limit=limit)


def differences(course: Course, s: np.ndarray, h: float = 1e-4) -> tuple[np.ndarray, np.ndarray]:
    """Slope and second derivative from values alone."""
    a, b, c = course(s - h)[0], course(s)[0], course(s + h)[0]
    return (c - a) / (2 * h), (c - 2 * b + a) / h**2


# The course


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("count", [2, 3, 4, 25])
def test_course_meets_its_values_and_is_smooth(closed, count):
    rng = np.random.default_rng(count)
    s = np.sort(rng.uniform(1.0, 99.0, count))
    s += np.arange(count) * 0.5
    value = rng.normal(0, 0.01, count)
    course = Course.through(s, value, 120.0, closed)
    np.testing.assert_allclose(course(s)[0], value, atol=1e-13)
    if closed:
        np.testing.assert_allclose(course(s - 120.0)[0], value, atol=1e-12)
        np.testing.assert_allclose(course(s + 240.0)[0], value, atol=1e-12)
    at = np.linspace(-30.0, 150.0, 777)
    slope, bend = differences(course, at)
    # Differences of values near 0.01 over 1e-4 mm carry rounding of 1e-14 and, where the third derivative
    # jumps, that jump over the step.
    third = np.abs(course.coefficient[3]).max() * 6
    assert np.abs(course(at)[1] - slope).max() < 1e-10 + third * 1e-8
    if not closed:
        at = at[(np.abs(at - s[0]) > 1e-3) & (np.abs(at - s[-1]) > 1e-3)]
        bend = differences(course, at)[1]
    assert np.abs(course.derivatives(at)[2] - bend).max() < 1e-5 + third * 1e-4


def test_periodic_course_is_scipys():
    rng = np.random.default_rng(0)
    s = np.linspace(3.0, 97.0, 40)
    value = rng.normal(0, 0.01, 40)
    oracle = CubicSpline(np.append(s, 103.0), np.append(value, value[0]), bc_type="periodic")
    at = np.linspace(3.0, 103.0, 999, endpoint=False)
    np.testing.assert_allclose(Course.through(s, value, 100.0, True)(at)[0], oracle(at), atol=1e-15)


def test_open_course_holds_its_ends_without_a_kink():
    s, value = np.array([10.0, 20.0, 40.0]), np.array([0.01, 0.05, -0.02])
    course = Course.through(s, value, 50.0, False)
    out, slope = course(np.array([-5.0, 0.0, 9.999999, 40.000001, 80.0]))
    np.testing.assert_allclose(out, [0.01, 0.01, 0.01, -0.02, -0.02], atol=1e-12)
    np.testing.assert_array_equal(slope, 0.0)
    # Just inside the slope is still next to nothing: the parallel curve at R has no kink to speak of.
    assert np.abs(course(np.array([10.0 + 1e-6, 40.0 - 1e-6]))[1]).max() < 1e-8


@pytest.mark.parametrize("closed", [False, True])
def test_constants_stay_constants(closed):
    for course in (
        Course.constant(0.02, 30.0, closed),
        Course.through(np.array([7.0]), np.array([0.02]), 30.0, closed),
        Course.through(np.linspace(0, 29, 30), np.full(30, 0.02), 30.0, closed),
    ):
        assert course.is_constant
        value, slope = course(np.linspace(-40.0, 70.0, 12))
        np.testing.assert_array_equal(value, 0.02)
        np.testing.assert_array_equal(slope, 0.0)


def test_what_varies_by_more_than_a_tenth_of_a_nanometre_is_no_constant():
    s = np.linspace(0.0, 20.0, 21)
    wave = np.sin(s)
    assert Course.through(s, 0.02 + 0.4 * ALIKE * wave, 20.0, False).is_constant
    assert not Course.through(s, 0.02 + 2 * ALIKE * wave, 20.0, False).is_constant
    # One bump between equal values.
    assert not Course.through(s, np.where(s == 10.0, 3 * ALIKE, 0.0), 20.0, False).is_constant


@settings(max_examples=examples(40), deadline=None, derandomize=True)
@given(st.lists(st.floats(-0.1, 0.1), min_size=1, max_size=12), st.booleans())
def test_extreme_of_a_course(values, closed):
    course = Course.through(np.arange(len(values)) * 3.0 + 1.0, np.array(values), 40.0, closed)
    at, value = course.extreme
    dense = course(np.linspace(0.0, 40.0, 20_001))[0]
    # Between samples 2 um apart a cubic rises by its second derivative times the step squared over 8.
    rise = np.abs(course.derivatives(np.linspace(0.0, 40.0, 2001))[2]).max() * 0.002**2 / 8 * 1.1
    assert abs(value) >= np.abs(dense).max() - 1e-15
    assert abs(value) <= np.abs(dense).max() + rise + 1e-15
    assert abs(course(np.array([at]))[0][0] - value) < 1e-14


# Dead band


def test_dead_band():
    x = np.linspace(-0.1, 0.1, 200_001)
    y = dead_band(x, 0.02)
    np.testing.assert_array_equal(y[np.abs(x) <= 0.02], 0.0)
    outside = np.abs(x) >= 0.04
    np.testing.assert_array_equal(y[outside], x[outside])
    np.testing.assert_allclose(y, -y[::-1], atol=1e-15)
    # Continuous, monotonous, and with a continuous slope: d/dv of v x^2 (3 - 2 x) with x = v/b - 1 is at most
    # 2.6, its own slope at most 2 * 6 / b + 2 * 6 / b.
    slope = np.diff(y) / np.diff(x)
    assert slope.min() > -1e-9 and slope.max() < 4.0
    assert np.abs(np.diff(slope)).max() < 24 / 0.02 * 1e-6
    assert dead_band(x, 0.0) is x


# Correction from points


def test_zero_correction():
    profile = rectangle(60.0, 40.0, 5.0).profile
    correction = Correction.none(profile)
    assert correction.largest == 0.0
    assert all(c.is_constant for c in correction.courses)


@pytest.mark.parametrize("make", [circle, line])
def test_smooth_deviations_are_followed_to_the_order_of_a_cubic(make):
    profile = make()
    total = float(profile.total[0])
    closed = profile.contours[0].closed
    for count in (40, 80):
        s = (np.arange(count) + (0.0 if closed else 0.5)) * total / count
        w = 2 * np.pi * 3 / total

        def wave(x, w=w):
            # Level at the ends of the open profile.
            return 0.01 * np.cos(w * x)

        correction, warnings = corrected(profile, s, wave(s))
        assert warnings == ()
        at = np.linspace(0.0, total, 5000)
        if not closed:
            # Before the first and behind the last point the value is held by intent.
            at = at[(at > 3 * total / count) & (at < total - 3 * total / count)]
        error = np.abs(correction.at(np.zeros(len(at), dtype=np.int64), at, profile) - wave(at)).max()
        # Error bound of cubic spline interpolation, de Boor: 5/384 h^4 |f''''|; the held ends spread inwards by
        # a factor of 0.27 a point.
        bound = 5 / 384 * (total / count) ** 4 * 0.01 * w**4
        if not closed:
            bound += 0.27**2 * 0.01 * (w * total / count) ** 2 / 4
        assert error < bound * 1.01


@settings(max_examples=examples(30), deadline=None, derandomize=True)
@given(st.integers(0, 1000), st.booleans())
def test_order_and_start_do_not_matter(seed, closed):
    profile = circle() if closed else line(300.0)
    rng = np.random.default_rng(seed)
    s = rng.uniform(0.0, float(profile.total[0]), 60)
    value = rng.normal(0, 0.003, 60)
    mixed = rng.permutation(60)
    a, _ = corrected(profile, s, value)
    b, _ = corrected(profile, s[mixed], value[mixed])
    at = np.linspace(0.0, float(profile.total[0]), 400)
    zero = np.zeros(400, dtype=np.int64)
    np.testing.assert_allclose(a.at(zero, at, profile), b.at(zero, at, profile), atol=1e-12)


@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(
    seed=st.integers(0, 10_000),
    closed=st.booleans(),
    scans=st.integers(1, 6),
    jitter=st.sampled_from([0.0, 1e-9, 1e-5, 1e-3, 0.05]),
)
def test_repeated_scans_make_no_slope_of_their_noise(seed, closed, scans, jitter):
    """Several scans over the same places: close supports would turn micrometres of noise into steep waves."""
    profile = circle() if closed else line(300.0)
    total = float(profile.total[0])
    rng = np.random.default_rng(seed)
    base = (np.arange(80) + 0.001) * total / 80
    s = np.concatenate([base + rng.uniform(-jitter, jitter, 80) for _ in range(scans)])
    s = np.mod(s, total) if closed else np.clip(s, 0.0, total)
    value = rng.uniform(-0.003, 0.003, len(s))
    correction, _ = corrected(profile, s, value)
    course = correction.courses[0]
    # Scans 0.1 mm wide count as one point; else every point may stand for itself, 3.75 mm / scans apart at best.
    step = np.diff(course.breaks).min()
    assert step > 0.25 * total / 80 / scans * (1 - 0.05)
    # Through values within +-a with supports at least h apart, slopes at supports are at most 6 a / h (diagonal
    # dominance of the spline's equations, 3 times the steepest chord), between them half a chord's more.
    at = np.linspace(0.0, total, 4000)
    assert np.abs(course(at)[1]).max() <= (6 + 3) * 0.003 / step


def test_coinciding_points_are_averaged():
    correction, _ = corrected(line(), np.repeat([10.0, 30.0, 50.0, 70.0], 3), np.tile([0.01, 0.02, 0.06], 4))
    assert correction.courses[0].is_constant
    assert abs(correction.largest - 0.03) < 1e-15
    for apart in (1e-12, 1e-6, 1e-3, 1.0):
        correction, _ = corrected(line(), [50.0, 50.0 + apart], [0.01, 0.03])
        assert correction.courses[0].is_constant and abs(correction.largest - 0.02) < 1e-15


def test_points_that_coincide_across_the_seam_are_averaged():
    profile = circle()
    total = float(profile.total[0])
    s = np.append(np.arange(40) * total / 40, total - 1e-5)
    value = np.append(np.zeros(40), 0.01)
    correction, _ = corrected(profile, s, value)
    value, slope = correction.courses[0](np.linspace(-5.0, 5.0, 2001))
    assert abs(value.max() - 0.005) < 1e-4
    # Half the noise over a spacing of 7.85 mm; two supports 10 nm apart would give a slope of 1000.
    assert np.abs(slope).max() < 3 * 0.005 / (total / 40)


def test_dense_and_sparse_regions_keep_their_detail():
    """A scanned millimetre among touched points is not melted into one point."""
    s = np.concatenate([np.arange(0.0, 40.0, 2.0), np.arange(40.0, 44.0, 0.01), np.arange(46.0, 100.0, 2.0)])
    value = np.where((s > 40) & (s < 44), 0.01 * np.sin(np.pi / 2 * (s - 40)), 0.0)
    correction, _ = corrected(line(), s, value)
    at = np.linspace(40.5, 43.5, 301)
    error = correction.at(np.zeros(301, dtype=np.int64), at, line()) - 0.01 * np.sin(np.pi / 2 * (at - 40))
    # Only next to the sparse points do up to eight points melt; 0.5 mm further in a spline through points 0.01 mm
    # apart is exact to 5/384 h^4 f^(4).
    assert np.abs(error).max() < 1e-9


def test_gap_is_bridged_straight_and_reported():
    s = np.concatenate([np.arange(0.5, 30.0), np.arange(70.5, 100.0)])
    value = np.where(s < 50, 0.01, 0.03)
    correction, warnings = corrected(line(), s, value)
    assert len(warnings) == 1
    assert "41.00 mm between X29.500 Y0.000 and X70.500 Y0.000" in warnings[0]
    at = np.linspace(30.0, 70.0, 400)
    straight = 0.01 + 0.02 * (at - 29.5) / 41.0
    out = correction.at(np.zeros(400, dtype=np.int64), at, line())
    # Rounding of the two knees: slope times spacing over 6 at most.
    assert np.abs(out - straight).max() < 0.02 / 41 / 6


def test_gap_across_the_seam():
    profile = circle()
    total = float(profile.total[0])
    s = np.arange(30.0, total - 30.0)
    correction, warnings = corrected(profile, s, np.where(s < total / 2, 0.01, 0.02))
    assert len(warnings) == 1 and "no usable point on 6" in warnings[0]
    p, _ = profile.at(0, np.array([s[-1], s[0]]))
    assert f"X{p[0, 0]:.3f} Y{p[0, 1]:.3f} and X{p[1, 0]:.3f} Y{p[1, 1]:.3f}" in warnings[0]
    middle = correction.at(np.zeros(1, dtype=np.int64), np.array([(30.0 - (total - s[-1])) / 2]), profile)
    np.testing.assert_allclose(middle, 0.015, atol=1e-5)


def test_long_open_ends_hold_and_are_reported():
    s = np.arange(40.0, 60.0)
    correction, warnings = corrected(line(), s, 0.01 + 0.001 * (s - 40))
    assert "40.00 mm between X0.000 Y0.000 and X40.000 Y0.000 and 1 shorter gaps" in warnings[0] or (
        "41.00 mm between X59.000 Y0.000 and X100.000 Y0.000 and 1 shorter gaps" in warnings[0]
    )
    out = correction.at(np.zeros(2, dtype=np.int64), np.array([0.0, 100.0]), line())
    np.testing.assert_allclose(out, [0.01, 0.029], atol=1e-12)
    assert abs(correction.largest - 0.029) < 0.001 / 2


def test_single_place_is_reported():
    correction, warnings = corrected(line(), [50.0], [0.01])
    assert correction.courses[0].is_constant and abs(correction.largest - 0.01) < 1e-15
    assert len(warnings) == 1 and "X50.000 Y0.000" in warnings[0] and "+0.0100 mm" in warnings[0]


def test_no_point_at_all():
    correction, warnings = corrected(circle(), [], [])
    assert correction.largest == 0.0
    assert len(warnings) == 1 and "not corrected" in warnings[0]


def sides(profile: Profile, values: dict[int, float]) -> tuple[Correction, tuple[str, ...]]:
    stretches = profile.stretches()
    s, value, number = [], [], []
    for k, v in values.items():
        at = stretches[k].begin + np.linspace(0.05, 0.95, 19) * stretches[k].length
        s.append(np.mod(at, profile.total[0]))
        value.append(np.full(19, v))
        number.append(np.full(19, k))
    return corrected(profile, np.concatenate(s), np.concatenate(value), np.concatenate(number))


def test_every_side_has_its_own_correction():
    profile = rectangle(60.0, 40.0).profile
    correction, warnings = sides(profile, {0: 0.01, 1: -0.02, 2: 0.03, 3: 0.0})
    assert warnings == ()
    assert [round(float(c.coefficient[0, 0]), 12) for c in correction.courses] == [0.01, -0.02, 0.03, 0.0]
    assert all(c.is_constant for c in correction.courses)


def test_unmeasured_sides_lead_from_neighbour_to_neighbour():
    profile = rectangle(60.0, 40.0).profile
    correction, warnings = sides(profile, {0: 0.01, 3: 0.06})
    assert len(warnings) == 2 and "60.000 mm near X30.000 Y40.000" in " ".join(warnings)
    right, top = correction.courses[1], correction.courses[2]
    # From the end of the bottom to the start of the left side over 40 + 60 mm in one line.
    ends = [float(c(np.array([x]))[0][0]) for c, x in ((right, 0.0), (right, 40.0), (top, 0.0), (top, 60.0))]
    np.testing.assert_allclose(ends, [0.01, 0.03, 0.03, 0.06], atol=1e-12)


def test_unmeasured_contour_is_not_corrected():
    a, b = rectangle(60.0, 40.0), rectangle(30.0, 20.0)
    profile = Profile.from_contours(
        [
            Contour(tuple(e.curve() for e in a.elements), True),
            Contour(tuple(NurbsCurve.line(e.p0 + [100, 0], e.p1 + [100, 0]) for e in b.elements), True),
        ]
    )
    correction, warnings = sides(profile, {0: 0.01, 1: 0.01, 2: 0.01, 3: 0.01})
    assert len(warnings) == 4 and all("not corrected" in w for w in warnings)
    assert [float(c.coefficient[0, 0]) for c in correction.courses] == pytest.approx([0.01] * 4 + [0.0] * 4)


def test_stretch_that_crosses_the_seam_is_one():
    """The contour starts in the middle of the bottom: points left and right of it belong together."""
    part = rectangle(60.0, 40.0)
    profile = profile_of(started_at(part.elements, 0, 0.5))
    number, stretch = next(
        (k, t) for k, t in enumerate(profile.stretches()) if abs(t.length - 60) < 1e-9 and t.begin + t.length > 200
    )
    x = np.linspace(1.0, 59.0, 59)
    s = np.mod(x - 30.0, 200.0)
    value = 0.01 + 0.0005 * x
    correction, warnings = corrected(profile, s, value, np.full(59, number), limit=0.1)
    assert not any("between" in w for w in warnings)
    np.testing.assert_allclose(along(stretch, s, profile), x, atol=1e-9)
    at = np.linspace(5.0, 55.0, 501)
    out = correction.at(np.full(501, number), np.mod(at - 30.0, 200.0), profile)
    # The level ends spread inwards by a factor of 0.27 a point: 0.0005 / 4 * 0.27^4.
    np.testing.assert_allclose(out, 0.01 + 0.0005 * at, atol=1e-6)


def test_rounding_at_the_start_of_a_stretch_is_no_whole_turn():
    profile = rectangle(60.0, 40.0).profile
    for k, stretch in enumerate(profile.stretches()):
        s = np.mod(stretch.begin + np.array([-1e-9, 0.0, 1e-9, stretch.length, stretch.length + 1e-9]), 200.0)
        local = along(stretch, s, profile)
        np.testing.assert_allclose(local, [0, 0, 0, stretch.length, stretch.length], atol=2e-9, err_msg=str(k))


def test_the_end_of_a_stretch_as_long_as_its_contour_is_not_its_start():
    """A drop whose only corner is the seam: the two sides of the corner are its two ends."""
    tip, r = np.array([0.0, -30.0]), 10.0
    a = np.arcsin(1 / 3)
    right = r * np.array([np.cos(a), -np.sin(a)])
    left = right * [-1, 1]
    profile = profile_of([Element(tip, right), Element(right, left, np.zeros(2), np.pi + 2 * a), Element(left, tip)])
    (stretch,) = profile.stretches()
    assert not stretch.closed
    total = float(profile.total[0])
    s = np.array([0.0, 5.0, total - 5.0, total])
    np.testing.assert_allclose(along(stretch, s, profile), s)


def test_limit_names_the_place():
    said = r"-0\.6000 mm is needed at X30\.000 Y0\.000 \(2 points\), more than --limit 0\.5"
    with pytest.raises(LimitError, match=said):
        corrected(line(), [10.0, 20.0, 30.0, 40.0], [0.1, 0.51, -0.6, 0.2], limit=0.5)
    corrected(line(), [10.0, 20.0, 30.0], [0.5, 0.5, 0.5], limit=0.5)


def test_limit_on_the_right_contour_and_stretch():
    part = rectangle(60.0, 40.0)
    with pytest.raises(LimitError, match=r"X60\.000 Y20\.000"):
        corrected(part.profile, [10.0, 80.0], [0.1, 0.7], [0, 1], limit=0.5)


def test_swing_between_points_beyond_the_limit_is_refused():
    """Values within the limit, a spline beyond it: the cutter would go where the limit forbids."""
    s = np.arange(0.0, 101.0, 10.0)
    value = np.where(np.arange(11) % 4 < 2, 0.5, -0.5)
    with pytest.raises(LimitError, match=r"between the points .* X\d+\.\d+ Y0\.000.*--filter"):
        corrected(line(), s, value, limit=0.5)


def test_a_million_points_take_no_loop():
    import time

    profile = circle()
    rng = np.random.default_rng(0)
    s = rng.uniform(0.0, float(profile.total[0]), 1_000_000)
    begin = time.process_time()
    corrected(profile, s, 0.01 * np.sin(s / CIRCLE))
    assert time.process_time() - begin < 5.0
