# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compensated contour: T = C + c n everywhere, corners at intersections, a NURBS that is really there."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar
from scipy.spatial import cKDTree

from millcorr.correction.compensation import correction_from
from millcorr.errors import FitError, LimitError
from millcorr.geometry.correction import Correction, Course
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.path.reconstruction import FIT, CompensatedContour
from tests.core.contours import (
    Element,
    Part,
    closed_spline,
    distance_to,
    facetted_circle,
    filleted,
    moved_sides,
    parts,
    pocket,
    polyline,
    profile_of,
    rectangle,
    scipy_closed_spline,
    spline_poles,
    started_at,
    turns,
)
from tests.core.sweeps import examples

EXACT = 1e-9


def constant(profile: Profile, *values: float) -> Correction:
    stretches = tuple(profile.stretches())
    values = values * len(stretches) if len(values) == 1 else values
    courses = tuple(Course.constant(v, t.length, t.closed) for v, t in zip(values, stretches, strict=True))
    return Correction(stretches, courses)


def waves(profile: Profile, size: float, wavelength: float) -> Correction:
    """Smooth correction on every stretch, with about ten points a wave."""
    stretches = tuple(profile.stretches())
    courses = []
    for k, stretch in enumerate(stretches):
        count = max(4, int(10 * stretch.length / wavelength))
        n = max(1, round(stretch.length / wavelength))
        s = np.arange(count) * stretch.length / count if stretch.closed else np.linspace(0, stretch.length, count)
        value = size * np.sin(2 * np.pi * n * s / stretch.length + k) + size / 3
        courses.append(Course.through(s, value, stretch.length, stretch.closed))
    return Correction(stretches, tuple(courses))


def spline_profile(poles: np.ndarray) -> Profile:
    return Profile.from_contours([Contour((closed_spline(poles),), True)])


def dense(contour: CompensatedContour, spacing: float = 0.1) -> np.ndarray:
    """Points of the exact compensated contour, ends of pieces and places next to them included."""
    out = []
    for piece in range(len(contour.length)):
        low, high = contour.low[piece], contour.high[piece]
        s = np.linspace(low, high, max(50, int((high - low) / spacing)))
        s = np.concatenate([s, low + np.array([1e-7, 1e-4]), high - np.array([1e-7, 1e-4])])
        out.append(contour.evaluate(np.full(len(s), piece), s)[0])
    return np.concatenate(out)


def check_fit(contour: CompensatedContour, within: float = FIT, tightest: float = 1.0) -> Profile:
    """NURBS and exact contour are no farther apart than promised, both ways."""
    found, residual = contour.to_profile()
    points = dense(contour)
    off = np.abs(FootPointSearch(found).find(points).distance)
    assert off.max() <= within
    assert off.max() <= residual * 1.3 + 1e-7
    assert residual <= within
    # The other way: the NURBS has no loops and spikes between those points.
    span, t = found.samples(0.1)
    back = distance_to_rows(_rows(contour, 0.01 * tightest**0.5), found.evaluate(span, t)[0])
    # A polyline 0.01 mm fine is off a curve of radius 1 mm by h^2 / 8; likewise for other radii.
    assert back.max() <= within + 0.01**2 / 8
    for curve in (c for k in found.contours for c in k.curves):
        check_valid(curve)
    return found


def _rows(contour: CompensatedContour, spacing: float) -> list[np.ndarray]:
    """Points of every piece, close together."""
    rows = []
    for piece in range(len(contour.length)):
        count = max(50, int(contour.length[piece] / spacing))
        s = np.linspace(contour.low[piece], contour.high[piece], count)
        rows.append(contour.evaluate(np.full(count, piece), s)[0])
    return rows


def distance_to_rows(rows: list[np.ndarray], points: np.ndarray) -> np.ndarray:
    """Distance of points from the nearest of the lines between consecutive points of the rows."""
    a, b = np.concatenate([r[:-1] for r in rows]), np.concatenate([r[1:] for r in rows])
    _, near = cKDTree((a + b) / 2).query(points, k=3)
    d = b[near] - a[near]
    away = points[:, None] - a[near]
    u = np.clip((away * d).sum(axis=2) / np.maximum((d * d).sum(axis=2), 1e-300), 0.0, 1.0)
    gap = away - u[:, :, None] * d
    return np.hypot(gap[:, :, 0], gap[:, :, 1]).min(axis=1)


def check_valid(curve: NurbsCurve) -> None:
    """What STEP and OCCT ask for: multiplicities within the degree, clamped ends or a period that closes."""
    assert 1 <= curve.degree <= 3
    inner = curve.multiplicities[1:-1]
    assert (inner >= 1).all() and (inner <= curve.degree).all()
    if curve.periodic:
        assert curve.multiplicities[0] == curve.multiplicities[-1] <= curve.degree
    else:
        assert (curve.multiplicities[[0, -1]] == curve.degree + 1).all()
    ends = curve.evaluate(curve.knots[[0, -1]])
    if curve.periodic:
        np.testing.assert_allclose(ends[0], ends[1], atol=1e-10)
        h = 1e-6 * (curve.knots[-1] - curve.knots[0])
        a, b = curve.evaluate([curve.knots[0] + h, curve.knots[-1] - h])
        u, v = a - ends[0], ends[0] - b
        assert abs(u[0] * v[1] - u[1] * v[0]) < 1e-4 * np.hypot(*u) * np.hypot(*v)


# T, its normal and its stretch


@settings(max_examples=examples(15), deadline=None, derandomize=True)
@given(poles=spline_poles(), size=st.sampled_from([0.003, 0.05]), wavelength=st.sampled_from([4.0, 30.0]))
def test_moved_point_is_exact(poles, size, wavelength):
    """Against scipy's B-spline, with arc length by brute force."""
    oracle = scipy_closed_spline(poles)
    profile = spline_profile(poles)
    correction = waves(profile, size, wavelength)
    contour = CompensatedContour(profile, correction)
    u = np.linspace(0.0, len(poles), 13)[1:-1]
    # Arc length by Gauss' rule on every polynomial piece.
    node, weight = np.polynomial.legendre.leggauss(24)
    d = oracle.derivative()

    def length(v: float) -> float:
        edges = np.append(np.arange(0.0, v), v)
        mid, half = (edges[1:] + edges[:-1]) / 2, np.diff(edges) / 2
        at = mid[:, None] + half[:, None] * node
        return float((np.hypot(*np.moveaxis(d(at), -1, 0)) * weight * half[:, None]).sum())

    s = np.array([length(v) for v in u])
    c = correction.courses[0](s)[0]
    tangent = d(u) / np.hypot(*d(u).T)[:, None]
    expected = oracle(u) + c[:, None] * np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
    found, _, _ = contour.evaluate(np.zeros(len(s), dtype=np.int64), s)
    np.testing.assert_allclose(found, expected, atol=EXACT)


@settings(max_examples=examples(25), deadline=None, derandomize=True)
@given(
    poles=spline_poles(),
    offset=st.sampled_from([0.0, 2.0, -1.0]),
    wavelength=st.sampled_from([3.0, 10.0, 40.0]),
    size=st.sampled_from([0.003, 0.05]),
)
def test_normal_and_stretch_against_differences(poles, offset, wavelength, size):
    profile = spline_profile(poles)
    contour = CompensatedContour(profile, waves(profile, size, wavelength))
    rng = np.random.default_rng(0)
    sigma = rng.uniform(0.0, contour.length[0], 60)
    piece = np.zeros(60, dtype=np.int64)
    h = 1e-4
    a, _, _ = contour.evaluate(piece, sigma - h, offset)
    b, _, _ = contour.evaluate(piece, sigma + h, offset)
    p, normal, stretch = contour.evaluate(piece, sigma, offset)
    q, _, _ = contour.evaluate(piece, sigma, 0.0)
    np.testing.assert_allclose(np.hypot(*normal.T), 1.0, atol=1e-14)
    np.testing.assert_allclose(p, q + offset * normal, atol=1e-13)
    forward = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    slope = (b - a) / (2 * h)
    # Central differences over 1e-4 mm: third derivatives of c are (2 pi / 3)^3 size at most, times R once more
    # derived; a kink of c'' within the step adds its jump times h.
    w = 2 * np.pi / wavelength
    error = (1 + abs(offset) * w) * 40 * size * w**3 * h + 1e-8
    assert np.abs((slope * normal).sum(axis=1)).max() < error
    # The term left out is c c' times the rate of the nominal's curvature, below 0.05 per mm^2 here.
    left_out = abs(offset) * size * size * w * 0.05 * 4
    assert np.abs((slope * forward).sum(axis=1) - stretch).max() < error + left_out


@pytest.mark.parametrize("wavelength", [2.0, 5.0])
def test_hollows_that_only_the_correction_makes_are_seen(wavelength):
    """On a straight line the parallel turns inside out where the correction bends more than 1 / R."""
    profile = profile_of([Element(np.zeros(2), np.array([60.0, 0.0]))], closed=False)
    w = 2 * np.pi / wavelength
    R = 8.0
    s = np.linspace(0.0, 60.0, 3001)
    for factor, tight in ((0.8, False), (1.2, True)):
        size = factor / (R * w * w)
        course = Course.through(s, size * np.cos(w * s), 60.0, False)
        contour = CompensatedContour(profile, Correction(tuple(profile.stretches()), (course,)))
        sigma = np.linspace(5.0, 55.0, 5001)
        _, _, stretch = contour.evaluate(np.zeros(5001, dtype=np.int64), sigma, R)
        assert (stretch.min() < 0) == tight
        slope, bend = -size * w * np.sin(w * sigma), -size * w * w * np.cos(w * sigma)
        # Second derivatives of the spline are straight between its supports: (0.02 w)^2 / 8 of the largest.
        np.testing.assert_allclose(stretch, np.hypot(1, slope) - R * bend / (1 + slope**2), atol=1e-3)


@settings(max_examples=examples(20), deadline=None, derandomize=True)
@given(poles=spline_poles(), offset=st.sampled_from([0.0, 3.0]))
def test_distance_off_against_brute_force(poles, offset):
    profile = spline_profile(poles)
    contour = CompensatedContour(profile, waves(profile, 0.01, 20.0))
    rng = np.random.default_rng(1)
    sigma = rng.uniform(0.0, contour.length[0], 5)
    zero = np.zeros(5, dtype=np.int64)
    at, normal, _ = contour.evaluate(zero, sigma, offset)
    points = at + rng.uniform(-0.1, 0.1, 5)[:, None] * normal + rng.uniform(-0.3, 0.3, (5, 1)) * normal[:, ::-1]
    off, foot = contour.distance_off(zero, sigma, points, offset)

    for i in range(5):

        def gap(x: float, i=i) -> float:
            return float(np.hypot(*(contour.evaluate(zero[:1], foot[i] + np.array([x]), offset)[0][0] - points[i])))

        # About the found foot, where the search for a minimum has all its digits.
        best = minimize_scalar(gap, bounds=(-2.0, 2.0), method="bounded", options={"xatol": 1e-10})
        assert abs(abs(off[i]) - best.fun) < 1e-9
        assert abs(gap(0.0) - best.fun) < 1e-9


def test_pieces_go_on_straight_or_round():
    """Beyond its ends a line goes on as its line, an arc as its circle, by arc length."""
    elements = [
        Element(np.array([0.0, 0.0]), np.array([30.0, 0.0])),
        Element(np.array([30.0, 0.0]), np.array([30.0, 20.0]), np.array([30.0, 10.0]), np.pi),
    ]
    elements.append(Element(np.array([30.0, 20.0]), np.array([0.0, 0.0])))
    profile = profile_of(elements)
    contour = CompensatedContour(profile, constant(profile, 0.02))
    # Line into arc is smooth: one piece from the sharp corner at the origin round to the corner at (30, 20).
    assert len(contour.length) == 2
    first = int(np.argmax(contour.length))
    n = np.full(3, first)
    p, normal, _ = contour.evaluate(n, np.array([-3.0, -1.0, 0.0]), 2.0)
    np.testing.assert_allclose(p, [[-3, -2.02], [-1, -2.02], [0, -2.02]], atol=1e-12)
    beyond = np.array([1.0, 4.0, 9.0])
    p, normal, stretch = contour.evaluate(n, contour.length[first] + beyond, 2.0)
    angle = np.pi / 2 + beyond / 10
    np.testing.assert_allclose(p, [30, 10] + 12.02 * np.stack([np.cos(angle), np.sin(angle)], 1), atol=1e-11)
    np.testing.assert_allclose(stretch, 1.202, atol=1e-12)


# Corners


@settings(max_examples=examples(50), deadline=None, derandomize=True)
@given(part=parts(), data=st.data())
def test_corners_of_polygons_with_a_constant_on_every_side(part, data):
    part = Part(part.vertices, (0.0,) * len(part.vertices))
    profile = part.profile
    c = [data.draw(st.floats(-0.3, 0.3)) for _ in part.vertices]
    contour = CompensatedContour(profile, constant(profile, *c))
    found, residual = contour.to_profile()
    assert residual < 1e-12
    v = moved_sides(part.vertices, np.array(c))
    corners = np.array([k.evaluate([k.knots[0]])[0] for k in found.contours[0].curves])
    np.testing.assert_allclose(corners, v, atol=EXACT)
    np.testing.assert_allclose(found.signed_areas(), [signed_area(v)], atol=1e-7)


def signed_area(v: np.ndarray) -> float:
    w = np.roll(v, -1, axis=0)
    return float((v[:, 0] * w[:, 1] - v[:, 1] * w[:, 0]).sum() / 2)


@settings(max_examples=examples(50), deadline=None, derandomize=True)
@given(part=parts(), c=st.floats(-0.3, 0.3), index=st.integers(0, 9), fraction=st.sampled_from([0.0, 0.4]))
def test_constant_correction_keeps_lines_lines_and_arcs_arcs(part, c, index, fraction):
    """All fillets change their radius by c, all sides move by c: the closed form of the exact parallel."""
    assume(abs(c) > 1e-6)
    elements = part.elements
    profile = profile_of(started_at(elements, index, fraction))
    moved = moved_sides(part.vertices, c)
    signs = np.sign(turns(part.vertices))
    radii = [r + s * c if r else 0.0 for r, s in zip(part.radii, signs, strict=True)]
    expected = filleted(moved, radii)
    found, residual = CompensatedContour(profile, constant(profile, c)).to_profile()
    assert residual < 1e-10
    span, t = found.samples(0.5)
    assert distance_to(expected, found.evaluate(span, t)[0]).max() < EXACT
    np.testing.assert_allclose(found.total[0], sum(e.length for e in expected), atol=1e-8)
    for curve in found.contours[0].curves:
        check_valid(curve)
        assert curve.degree == (1 if len(curve.poles) == 2 else 2)


@pytest.mark.parametrize("make", [rectangle, pocket])
@pytest.mark.parametrize("c", [0.2, -0.2])
def test_rectangle_against_shapely(make, c):
    part = make(60.0, 40.0)
    found, _ = CompensatedContour(part.profile, constant(part.profile, c)).to_profile()
    grown = c if make is rectangle else -c
    oracle = shapely.Polygon(part.vertices).buffer(grown, join_style="mitre")
    corners = [k.evaluate([k.knots[0]])[0] for k in found.contours[0].curves]
    assert shapely.Polygon(corners).symmetric_difference(oracle).area < 1e-9


def test_corners_between_arcs_with_different_corrections():
    """A lens: circles of radius 25 + a and 25 + b about (0, 15) and (0, -15)."""
    sweep = 2 * np.arctan2(20, 15)
    ends = np.array([-20.0, 0.0]), np.array([20.0, 0.0])
    lens = [
        Element(ends[0], ends[1], np.array([0.0, 15.0]), sweep),
        Element(ends[1], ends[0], np.array([0.0, -15.0]), sweep),
    ]
    profile = profile_of(lens)
    for a, b in ((0.3, -0.2), (0.02, 0.02), (-0.4, 0.1)):
        contour = CompensatedContour(profile, constant(profile, a, b))
        found, residual = contour.to_profile()
        r, q = 25 + a, 25 + b
        y = (q * q - r * r) / (4 * 15.0)
        x = np.sqrt(r * r - (y - 15) ** 2)
        corners = sorted(tuple(k.evaluate([k.knots[0]])[0]) for k in found.contours[0].curves)
        np.testing.assert_allclose(corners, [[-x, y], [x, y]], atol=EXACT)
        points = found.evaluate(*found.samples(0.3))[0]
        off = np.minimum(np.abs(np.hypot(*(points - [0, 15]).T) - r), np.abs(np.hypot(*(points - [0, -15]).T) - q))
        assert off.max() < EXACT
        # The two ends of neighbours are one point.
        curves = found.contours[0].curves
        np.testing.assert_allclose(curves[0].poles[-1], curves[1].poles[0], atol=1e-10)


def test_open_ends_move_along_the_normal():
    profile = profile_of([Element(np.zeros(2), np.array([60.0, 0.0]))], closed=False)
    course = Course.through(np.array([0.0, 30.0, 60.0]), np.array([0.01, 0.05, -0.02]), 60.0, False)
    contour = CompensatedContour(profile, Correction(tuple(profile.stretches()), (course,)))
    found = check_fit(contour)
    ends = np.array(found.ends(0))
    np.testing.assert_allclose(ends, [[0.0, -0.01], [60.0, 0.02]], atol=1e-10)


def test_one_corner_on_a_closed_contour():
    """A drop: one smooth piece that meets itself at its only corner."""
    centre, r, tip = np.array([0.0, 0.0]), 10.0, np.array([0.0, -30.0])
    a = np.arcsin(r / 30.0)
    right = r * np.array([np.cos(a), -np.sin(a)])
    left = right * [-1, 1]
    drop = [
        Element(tip, right),
        Element(right, left, centre, np.pi + 2 * a),
        Element(left, tip),
    ]
    for elements in (drop, started_at(drop, 1, 0.5)):
        profile = profile_of(elements)
        for c in (0.1, -0.1):
            found, residual = CompensatedContour(profile, constant(profile, c)).to_profile()
            # Sides parallel to the old ones, tangent to a circle of radius 10 + c: the tip at (10 + c) / sin a.
            new_tip = np.array([0.0, -(r + c) / np.sin(a)])
            points = found.evaluate(*found.samples(0.5))[0]
            assert np.hypot(*(points - new_tip).T).min() < EXACT
            assert residual < 1e-10


def test_piece_that_vanishes_is_refused_with_its_place():
    part = Part(np.array([[0.0, 0.0], [60.0, 0.0], [60.0, 0.2], [40.0, 0.2], [40.0, 30.0], [0.0, 30.0]]), (0.0,) * 6)
    profile = part.profile
    with pytest.raises(LimitError, match=r"0\.200 mm long piece .* X59\.850 Y0\.100"):
        CompensatedContour(profile, constant(profile, -0.15))


def test_corner_inside_one_curve():
    """A closed contour as one B-spline with a corner in it (C0) keeps the corner."""
    square = rectangle(40.0, 40.0).vertices
    poles = np.vstack([square, square[:1]])
    curve = polyline(poles)
    for contour in (Contour((curve,), True), Contour((raised(curve),), True)):
        profile = Profile.from_contours([contour])
        assert len(profile.stretches()) == 4
        found, _ = CompensatedContour(profile, constant(profile, 0.1, 0.2, 0.3, 0.4)).to_profile()
        v = moved_sides(square, np.array([0.1, 0.2, 0.3, 0.4]))
        corners = np.array([k.evaluate([k.knots[0]])[0] for k in found.contours[0].curves])
        np.testing.assert_allclose(corners, v, atol=EXACT)


def raised(curve: NurbsCurve) -> NurbsCurve:
    """The same polyline as a cubic with triple knots."""
    p = curve.poles
    third = np.diff(p, axis=0) / 3
    poles = np.vstack([p[:1], np.stack([p[:-1] + third, p[:-1] + 2 * third, p[1:]], axis=1).reshape(-1, 2)])
    mult = np.full(len(p), 3)
    mult[[0, -1]] = 4
    return NurbsCurve(3, poles, np.ones(len(poles)), np.arange(float(len(p))), mult)


# Facets


@pytest.mark.few(1)
@pytest.mark.parametrize("c", [0.02, -0.3])
def test_facets_intersect_exactly(c):
    v = facetted_circle(40.0, 2000)
    profile = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    assert len(profile.stretches()) == 1
    found, residual = CompensatedContour(profile, constant(profile, c)).to_profile()
    expected = moved_sides(v, c)
    assert len(found.contours[0].curves) == 1
    poles = found.contours[0].curves[0].poles
    np.testing.assert_allclose(poles[:-1], expected, atol=1e-10)
    np.testing.assert_allclose(poles[-1], expected[0], atol=1e-10)
    assert residual < 1e-10


def test_facets_too_fine_to_be_corners_stay_where_they_are():
    """Facets that turn by 1e-4 rad pass as smooth; together they are no straight line."""
    angle = np.linspace(0.0, 0.2, 2001)
    v = 500.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    profile = Profile.from_contours([Contour((polyline(v),), False)])
    contour = CompensatedContour(profile, constant(profile, 0.02))
    assert len(contour.length) == 1
    found, residual = contour.to_profile()
    points = found.evaluate(*found.samples(0.1))[0]
    # Sagitta of a facet of 0.05 mm: 0.6 nm.
    assert np.abs(np.hypot(*points.T) - 500.02).max() < 2e-9 + residual
    assert residual <= FIT


def test_facets_with_a_varying_correction():
    v = facetted_circle(40.0, 2000)
    profile = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    correction = waves(profile, 0.01, 40.0)
    contour = CompensatedContour(profile, correction)
    found, residual = contour.to_profile()
    s = np.linspace(0.0, float(profile.total[0]), 3000, endpoint=False)
    angle = s / 40.0
    expected = 40.0 + correction.courses[0](s)[0]
    at = expected[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    # Facets lie 12.3 um / 1000 inside: sagitta 0.1257^2 / (8 * 40) = 0.049 um; the rest is the fit.
    assert np.abs(FootPointSearch(found).find(at).distance).max() < 5e-5 + FIT


# The NURBS


@settings(max_examples=examples(15), deadline=None, derandomize=True)
@given(poles=spline_poles(), size=st.sampled_from([1e-3, 0.01, 0.2]), wavelength=st.sampled_from([5.0, 20.0, 100.0]))
def test_fit_of_closed_splines(poles, size, wavelength):
    profile = spline_profile(poles)
    found = check_fit(CompensatedContour(profile, waves(profile, size, wavelength)))
    (curve,) = found.contours[0].curves
    assert curve.periodic and curve.degree == 3
    assert (curve.multiplicities == 1).all()


@settings(max_examples=examples(25), deadline=None, derandomize=True)
@given(
    part=parts(fillets=(0.0, 0.0, 3.0, 8.0)),
    size=st.sampled_from([1e-3, 0.05]),
    wavelength=st.sampled_from([3.0, 20.0, 100.0]),
    index=st.integers(0, 9),
    fraction=st.sampled_from([0.0, 0.4]),
)
def test_fit_across_lines_and_arcs(part, size, wavelength, index, fraction):
    """Line-arc-line: the curvature jumps, the compensated contour stays tangent there."""
    profile = profile_of(started_at(part.elements, index, fraction))
    check_fit(CompensatedContour(profile, waves(profile, size, wavelength)))


@pytest.mark.parametrize("start", [0.0, 0.5])
def test_smooth_all_round_with_curvature_jumps_is_one_periodic_curve(start):
    part = rectangle(60.0, 40.0, 8.0)
    profile = profile_of(started_at(part.elements, 0, start))
    found = check_fit(CompensatedContour(profile, waves(profile, 0.01, 25.0)))
    (curve,) = found.contours[0].curves
    assert curve.periodic
    # Eight jumps; the one at the seam stands at both ends.
    assert (curve.multiplicities == 2).sum() == 9


def test_both_sides_of_the_seam_use_the_same_slope():
    """The seam in the middle of an arc: rounding of a whole turn must not show it with the line's curvature."""
    angle = 2 * np.pi / 3 * np.arange(3)
    for size in (20.0, 22.0, 23.7, 31.1):
        part = Part(size * np.stack([np.cos(angle), np.sin(angle)], axis=1), (3.0,) * 3)
        for fraction in (0.1, 0.4, 0.7):
            profile = profile_of(started_at(part.elements, 1, fraction))
            check_fit(CompensatedContour(profile, waves(profile, 0.05, 20.0)))


def test_a_bump_between_the_samples_is_not_lost():
    """A long line, corrected on 3 mm of its 500."""
    for closed in (False, True):
        if closed:
            profile = rectangle(500.0, 100.0, 20.0).profile
        else:
            profile = profile_of([Element(np.zeros(2), np.array([500.0, 0.0]))], closed=False)
        stretch = profile.stretches()[0]
        s = np.concatenate([[0.0], np.linspace(301.0, 304.0, 31), [stretch.length - 1.0]])
        value = np.where((s > 301.05) & (s < 303.95), 0.01 * np.sin(np.pi * (s - 301) / 3) ** 2, 0.0)
        s_flat = np.concatenate([np.arange(0.0, 301.0, 0.5), s[1:-1], np.arange(304.5, stretch.length, 0.5)])
        value = np.interp(s_flat, s, value)
        course = Course.through(s_flat, value, stretch.length, stretch.closed)
        contour = CompensatedContour(profile, Correction((stretch,), (course,)))
        found = check_fit(contour)
        p, _, _ = contour.evaluate(np.zeros(1, dtype=np.int64), np.array([302.5]))
        assert abs(FootPointSearch(found).find(p).distance[0]) < FIT


def test_short_pieces_between_long_ones():
    """A side of 0.05 mm and an arc of 0.02 mm radius, both corrected with the rest."""
    v = np.array([[0.0, 0.0], [60.0, 0.0], [60.05, 0.0 + 0.05], [60.05, 40.0], [0.0, 40.0]])
    part = Part(v, (0.0, 0.0, 0.0, 0.02, 0.0))
    profile = part.profile
    contour = CompensatedContour(profile, waves(profile, 0.004, 30.0))
    check_fit(contour, tightest=0.015)


def test_zero_correction_gives_back_the_very_curves():
    profile = rectangle(60.0, 40.0, 8.0).profile
    found, residual = CompensatedContour(profile, Correction.none(profile)).to_profile()
    assert residual == 0.0
    assert found.contours[0] is profile.contours[0]


def test_uncorrected_contour_beside_a_corrected_one():
    a, b = rectangle(60.0, 40.0, 8.0), Part(rectangle(30.0, 20.0).vertices + [100.0, 0.0], (0.0,) * 4)
    contours = [Contour(tuple(e.curve() for e in p.elements), True) for p in (a, b)]
    profile = Profile.from_contours(contours)
    values = [0.05] + [0.0] * 4
    found, _ = CompensatedContour(profile, constant(profile, *values)).to_profile()
    assert found.contours[1] is contours[1]
    assert found.contours[0] is not contours[0]


def test_curves_that_meet_only_to_the_drawings_digits():
    """Ends 1.5 um apart are joined; that is no sign of deviations that change too fast."""
    gap = np.array([0.0, 1.5e-3])
    curves = [
        NurbsCurve.line([0.0, 0.0], [30.0, 0.0]),
        NurbsCurve.arc([30.0, 0.0] + gap, [40.0, 10.0] + gap, [30.0, 10.0] + gap, np.pi / 2),
        NurbsCurve.line([40.0, 10.0], [40.0, 50.0]),
    ]
    profile = Profile.from_contours([Contour(tuple(curves), False)])
    contour = CompensatedContour(profile, waves(profile, 0.01, 20.0))
    found, residual = contour.to_profile()
    off = np.abs(FootPointSearch(found).find(dense(contour)).distance)
    assert off.max() <= 0.75e-3 + FIT
    assert residual >= off.max() * 0.99
    assert residual <= 0.75e-3 + FIT


@pytest.mark.parametrize("gap", [3e-4, -3e-4])
def test_line_and_arc_that_rounding_left_apart_and_not_tangent(gap):
    """They turn by 0.4 mrad and run past each other: no intersection, a gap of 0.3 um, no corner either."""
    turn = 4e-4
    line = NurbsCurve.line([0.0, 0.0], [30.0, 0.0])
    start = np.array([30.0, -gap])
    normal = np.array([-np.sin(turn), np.cos(turn)])
    centre = start + 10.0 * normal
    angle = -np.pi / 2 + turn + 1.0
    end = centre + 10.0 * np.array([np.cos(angle), np.sin(angle)])
    profile = Profile.from_contours([Contour((line, NurbsCurve.arc(start, end, centre, 1.0)), False)])
    for c in (0.02, -0.02):
        contour = CompensatedContour(profile, constant(profile, c))
        a, b = contour.meet(np.array([0]), 5.0)
        p, q = contour.evaluate(np.array([0]), a, 5.0)[0], contour.evaluate(np.array([1]), b, 5.0)[0]
        assert np.hypot(*(p - q).T)[0] < 1.1 * abs(gap)
        assert abs(a[0] - 30.0) < 0.2


def test_noise_that_no_curve_follows_is_refused_with_its_place():
    profile = profile_of([Element(np.zeros(2), np.array([60.0, 0.0]))], closed=False)
    s = np.linspace(0.0, 60.0, 121)
    value = np.random.default_rng(0).normal(0, 0.003, 121)
    # Raw noise every half millimetre is still a curve.
    course = Course.through(s, value, 60.0, False)
    check_fit(CompensatedContour(profile, Correction(tuple(profile.stretches()), (course,))))
    # Steps of 0.2 mm every tenth of a micrometre are not.
    s = 30.0 + np.arange(40) * 1e-4
    course = Course.through(s, np.where(np.arange(40) % 2, 0.2, 0.0), 60.0, False)
    with pytest.raises(FitError, match=r"X30\.000 Y-?0\.\d+.*--filter"):
        CompensatedContour(profile, Correction(tuple(profile.stretches()), (course,))).to_profile()


def test_correction_through_measured_points_to_a_profile():
    """From values at points on two contours, one of them run through its seam, to the NURBS."""
    outer = started_at(rectangle(60.0, 40.0, 8.0).elements, 0, 0.5)
    inner = [Element(np.array([40.0, 20.0]), np.array([40.0, 20.0]), np.array([30.0, 20.0]), -2 * np.pi)]
    profile = Profile.from_contours([Contour(tuple(e.curve() for e in row), True) for row in (outer, inner)])
    s, number, value = [], [], []
    for k in (0, 1):
        at = np.linspace(0.0, float(profile.total[k]), 80, endpoint=False)
        s.append(at)
        number.append(np.full(80, k))
        value.append(0.005 + 0.003 * np.cos(2 * np.pi * at / profile.total[k]))
    correction, warnings = correction_from(
        profile, np.concatenate(number), np.concatenate(s), np.concatenate(value), limit=0.1
    )
    assert warnings == ()
    found = check_fit(CompensatedContour(profile, correction))
    for k in (0, 1):
        p, n = profile.at(k, s[k])
        np.testing.assert_allclose(FootPointSearch(found).find(p + value[k][:, None] * n).distance, 0.0, atol=FIT)


def test_speed_of_facets_and_fine_courses():
    import time

    v = facetted_circle(40.0, 2000)
    profile = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    begin = time.process_time()
    CompensatedContour(profile, waves(profile, 0.01, 40.0)).to_profile()
    assert time.process_time() - begin < 8.0
    profile = spline_profile(30.0 * np.stack([np.cos(np.arange(15) * 0.4189), np.sin(np.arange(15) * 0.4189)], 1))
    total = float(profile.total[0])
    s = np.arange(20_000) * total / 20_000
    course = Course.through(s, 0.01 * np.sin(2 * np.pi * 5 * s / total), total, True)
    begin = time.process_time()
    found, _ = CompensatedContour(profile, Correction(tuple(profile.stretches()), (course,))).to_profile()
    assert time.process_time() - begin < 3.0
    # As many poles as the shape needs, not as many as there were points.
    assert len(found.contours[0].curves[0].poles) < 500
