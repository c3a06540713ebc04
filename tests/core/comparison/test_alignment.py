# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alignment against closed forms and scipy's general optimisers, which know which element each point belongs to."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares, linprog, minimize

from millcorr.comparison import alignment
from millcorr.comparison.alignment import Alignment, Freedom, Transform, align
from millcorr.errors import FitError, InputError, UsageError
from millcorr.geometry.profile import Contour, Profile
from millcorr.readers.measurement import Measurement
from tests.core.contours import (
    Element,
    Part,
    closed_spline,
    facetted_circle,
    parts,
    pocket,
    polyline,
    profile_of,
    rectangle,
    scipy_closed_spline,
)
from tests.core.sweeps import examples, seeds, slow

MICRON = 1e-3
REACHED = 0.1 * MICRON
"""What the alignment must reach, mm; and the same for the turn, 0.1 arc second."""
REACHED_TURN = math.radians(0.1 / 3600)


def measured(points, normals=None, ball_radius=0.0):
    n = len(points)
    xyz = np.column_stack([points, np.linspace(-5.0, 0.0, n)])
    ijk = None if normals is None else np.column_stack([normals, np.zeros(n)])
    return Measurement(xyz, ijk, ball_radius, np.arange(1, n + 1), "part.csv", "0" * 64)


@dataclass
class Sample:
    """Measured points in their true place, the element each lies on, and what is wrong with them."""

    elements: list[Element]
    owner: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    outlier: np.ndarray
    ball_radius: float = 0.0

    def deviation(self, xy):
        """Closed form: distance to the element's whole line or circle, positive outside, and its gradient."""
        d, g = np.empty(len(xy)), np.empty((len(xy), 2))
        for k, e in enumerate(self.elements):
            rows = self.owner == k
            p = xy[rows]
            if e.centre is None:
                u = (e.p1 - e.p0) / np.hypot(*(e.p1 - e.p0))
                n = np.array([u[1], -u[0]])
                d[rows], g[rows] = (p - e.p0) @ n, n
            else:
                arm = p - e.centre
                far = np.hypot(*arm.T)
                sign = np.sign(e.sweep)
                d[rows] = sign * (far - np.hypot(*(e.p0 - e.centre)))
                g[rows] = sign * arm / far[:, None]
        return d - self.ball_radius, g

    def measurement(self, pose: Transform, normals=False):
        """As the machine has them when `pose` would put them right."""
        back = pose.inverse()
        return measured(back.points(self.points), back.directions(self.normals) if normals else None, self.ball_radius)


def sample(elements, n, seed=0, noise=2 * MICRON, outliers=0.02, ball_radius=0.0, offset=0.0, margin=0.5, form=None):
    """Points along the elements, `margin` mm clear of their ends; 2 % of them far off."""
    rng = np.random.default_rng(seed)
    length = np.array([e.length for e in elements])
    assert (length > 2 * margin).all()
    room = length - 2 * margin
    s = np.sort(rng.uniform(0, room.sum(), n))
    owner = np.minimum(np.searchsorted(np.cumsum(room), s, side="right"), len(elements) - 1)
    within = (s - np.cumsum(room)[owner] + room[owner] + margin) / length[owner]
    out = Sample(list(elements), owner, np.empty((n, 2)), np.empty((n, 2)), np.zeros(n, dtype=bool), ball_radius)
    for k, e in enumerate(elements):
        out.points[owner == k] = e.at(within[owner == k])
    _, out.normals = out.deviation(out.points)
    d = offset + rng.normal(0, noise, n) + (0.0 if form is None else form(s / room.sum()))
    out.outlier[rng.choice(n, round(outliers * n), replace=False)] = True
    d[out.outlier] += rng.choice([-1, 1], n)[out.outlier] * rng.uniform(0.05, 1.5, n)[out.outlier]
    out.points += (d + ball_radius)[:, None] * out.normals
    return out


def optimum(sample, measurement, truth, free, rows):
    """The least squares optimum by scipy's general optimiser, started at the truth."""
    free = np.flatnonzero(free)
    xy = measurement.points[rows, :2]
    part = Sample(sample.elements, sample.owner[rows], xy, xy, sample.outlier[rows], sample.ball_radius)
    full = np.array([*truth.shift, truth.rotation])

    def residual(q):
        p = np.zeros(3)
        p[free] = q
        return part.deviation(Transform((p[0], p[1]), p[2]).points(xy))[0]

    found = least_squares(
        residual, full[free], x_scale=np.array([1, 1, 0.02])[free], xtol=1e-15, ftol=1e-15, gtol=1e-15, jac="3-point"
    )
    p = np.zeros(3)
    p[free] = found.x
    return Transform((p[0], p[1]), p[2])


def apart(a: Transform, b: Transform, points):
    """Largest distance in mm between two motions of the same points, and between their turns in rad."""
    return np.hypot(*(a.points(points) - b.points(points)).T).max(), abs(a.rotation - b.rotation)


def open_contour():
    """A straight, an arc and a slope: open, and every direction determined."""
    p = [np.array(v, dtype=float) for v in ([0, 0], [60, 0], [80, 20], [80, 70], [55, 95])]
    return [
        Element(p[0], p[1]),
        Element(p[1], p[2], np.array([60.0, 20.0]), math.pi / 2),
        Element(p[2], p[3]),
        Element(p[3], p[4]),
    ]


def flattened_circle():
    """Nearly round: a circle of 30 mm with a flat 0.4 mm deep, which alone tells the turn."""
    half = math.acos(1 - 0.4 / 30)
    a, b = (30 * np.array([math.cos(t), math.sin(t)]) for t in (half, -half))
    return [Element(b, a), Element(a, b, np.zeros(2), 2 * math.pi - 2 * half)]


CONTOURS = {
    "closed": Part(
        np.array([[-20.0, 0], [50, -10], [70, 40], [20, 55], [-25, 45]]), (6.0, 8.0, 5.0, 10.0, 7.0)
    ).elements,
    "sharp": rectangle(80, 50).elements,
    "pocket": pocket(70, 45, 8.0).elements,
    "open": open_contour(),
    "nearly round": flattened_circle(),
}
OFF = Transform.about(math.radians(1.0), (12.0, 34.0), (1.6, -1.2))
"""1 degree and 2 mm off."""


def profile(name):
    return profile_of(CONTOURS[name], closed=name != "open")


# ---- the motion ---------------------------------------------------------------------------------------------

motions = st.builds(
    Transform,
    st.tuples(st.floats(-500, 500), st.floats(-500, 500)),
    st.floats(-math.pi, math.pi),
)


def test_quarter_turns_are_exact():
    xy = np.array([[12.345, -6.789], [1e-3, 250.0]])
    x, y = xy.T
    for k, expected in enumerate(([x, y], [-y, x], [-x, -y], [y, -x])):
        assert np.array_equal(Transform(rotation=math.radians(90 * k)).points(xy), np.transpose(expected))


def test_turn_about_a_centre_then_shift():
    pose = Transform.about(math.radians(90), (10.0, 0.0), (1.0, 2.0))
    assert np.array_equal(pose.points(np.array([[10.0, 0.0], [11.0, 0.0]])), [[11.0, 2.0], [11.0, 3.0]])


def test_work_offset_takes_machine_coordinates_into_the_work_frame():
    # G54 X100 Y-50 turned by 30 degrees: the work point (20, 10) stands at 100 + 20 cos 30 - 10 sin 30, ...
    c, s = math.sqrt(3) / 2, 0.5
    machine = measured(np.array([[100 + 20 * c - 10 * s, -50 + 20 * s + 10 * c]]), np.array([[c, s]]))
    work, done = alignment.given(machine, Transform((100.0, -50.0), math.radians(30)).inverse())
    assert work.points[0, :2] == pytest.approx([20, 10], abs=1e-13)
    assert work.points[0, 2] == machine.points[0, 2]
    assert work.normals[0] == pytest.approx([1, 0, 0], abs=1e-15)
    assert done.method == "given" and math.degrees(done.rotation) == pytest.approx(-30)
    assert (work.source, work.digest, work.ball_radius) == (machine.source, machine.digest, machine.ball_radius)


@given(motions, motions, st.floats(-100, 100), st.floats(-100, 100))
def test_motions_compose_and_invert(a, b, x, y):
    # Coordinates stay below 2000 mm: a dozen roundings of 2**-53 each are below 1e-11.
    p = np.array([[x, y]])
    assert a.then(b).points(p) == pytest.approx(b.points(a.points(p)), abs=1e-11)
    assert a.then(a.inverse()).points(p) == pytest.approx(p, abs=1e-11)
    assert a.inverse().then(a).points(p) == pytest.approx(p, abs=1e-11)
    turned = a.directions(np.array([[0.6, 0.8, 0.0]]))
    assert np.hypot(*turned[0, :2]) == pytest.approx(1.0, abs=1e-14) and turned[0, 2] == 0


@pytest.mark.parametrize(
    ("text", "free", "zone", "robust"),
    [
        ("none", (0, 0, 0), 0, 1),
        ("shift", (1, 1, 0), 0, 1),
        ("rigid", (1, 1, 1), 0, 1),
        ("rigid:zone", (1, 1, 1), 1, 1),
        ("x+turn:all", (1, 0, 1), 0, 0),
        (" Turn ", (0, 0, 1), 0, 1),
    ],
)
def test_freedom_from_text(text, free, zone, robust):
    freedom = Freedom.parse(text)
    assert freedom.free == tuple(map(bool, free)) and freedom.zone == zone and freedom.robust == robust


@pytest.mark.parametrize("text", ["", "all", "x+", "x+x", "rigid+x", "shift:zones", "z"])
def test_freedom_refuses_other_text(text):
    with pytest.raises(UsageError, match="--align"):
        Freedom.parse(text)


# ---- the optimum --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", seeds(3, quick=1))
@pytest.mark.parametrize("n", [60, 400, 5000])
@pytest.mark.parametrize("name", CONTOURS)
def test_reaches_the_noise_limited_optimum(name, n, seed):
    points = sample(CONTOURS[name], n, seed)
    measurement = points.measurement(OFF)
    moved, found = align(measurement, profile(name))
    best = optimum(points, measurement, OFF, (1, 1, 1), ~points.outlier)
    distance, turn = apart(found.transform, best, measurement.points[:, :2])
    assert distance < REACHED and turn < REACHED_TURN
    assert not found.undetermined
    assert not found.weight[points.outlier].any()
    assert len(found.outliers) <= points.outlier.sum() + n // 1000
    assert np.array_equal(moved.points, found.transform.points(measurement.points))
    # 2 um of noise: the estimate of sigma scatters by sigma / sqrt(2 n), five of those.
    assert found.residual_std == pytest.approx(2 * MICRON, rel=5 / math.sqrt(2 * 0.98 * n) + 0.01)


@pytest.mark.parametrize("name", CONTOURS)
def test_ball_centres_and_their_normals(name):
    radius = 1.5
    points = sample(CONTOURS[name], 300, 7, ball_radius=radius, margin=2.5)
    measurement = points.measurement(OFF, normals=True)
    moved, found = align(measurement, profile(name))
    best = optimum(points, measurement, OFF, (1, 1, 1), ~points.outlier)
    distance, turn = apart(found.transform, best, measurement.points[:, :2])
    assert distance < REACHED and turn < REACHED_TURN
    assert moved.ball_radius == radius
    assert moved.normals == pytest.approx(found.transform.directions(measurement.normals), abs=0)
    assert np.hypot(*moved.normals[:, :2].T) == pytest.approx(1.0, abs=1e-14)


def spline_poles():
    angle = 2 * np.pi * np.arange(15) / 15
    return facetted_circle(32.0, 15) * (1 + 0.12 * np.cos(2 * angle) + 0.07 * np.sin(3 * angle))[:, None]


def test_closed_spline_against_scipy():
    poles = spline_poles() + [100.0, -40.0]
    nominal = Profile.from_contours([Contour((closed_spline(poles),), True)])
    curve = scipy_closed_spline(poles)
    first, second = curve.derivative(), curve.derivative(2)
    rng = np.random.default_rng(3)
    n = 400
    u = rng.uniform(0, 15, n)

    def normal_at(v):
        d = first(np.mod(v, 15))
        return np.stack([d[:, 1], -d[:, 0]], axis=1) / np.hypot(*d.T)[:, None]

    d = rng.normal(0, 2 * MICRON, n)
    bad = rng.random(n) < 0.02
    d[bad] += rng.uniform(0.1, 1.0, bad.sum())
    measurement = measured(OFF.inverse().points(curve(u) + d[:, None] * normal_at(u)))
    good = measurement.points[~bad, :2]

    def residual(q):
        xy, v = Transform((q[0], q[1]), q[2]).points(good), u[~bad].copy()
        for _ in range(6):
            e, t, b = curve(np.mod(v, 15)) - xy, first(np.mod(v, 15)), second(np.mod(v, 15))
            v -= (e * t).sum(1) / ((t * t).sum(1) + (e * b).sum(1))
        return ((xy - curve(np.mod(v, 15))) * normal_at(v)).sum(1)

    best = least_squares(residual, [*OFF.shift, OFF.rotation], x_scale=[1, 1, 0.01], xtol=1e-15, ftol=1e-15, gtol=1e-15)
    _, found = align(measurement, nominal)
    distance, turn = apart(found.transform, Transform((best.x[0], best.x[1]), best.x[2]), good)
    assert distance < REACHED and turn < REACHED_TURN


@pytest.mark.parametrize("free", ["x", "y", "turn", "x+y", "x+turn", "y+turn", "x+y+turn"])
@pytest.mark.parametrize("name", ["closed", "open"])
def test_locked_degrees_of_freedom_stay_at_zero(name, free):
    freedom = Freedom.parse(free)
    points = sample(CONTOURS[name], 300, 5)
    truth = Transform(
        (0.7 if freedom.shift_x else 0.0, -0.4 if freedom.shift_y else 0.0), 0.01 if freedom.rotation else 0.0
    )
    measurement = points.measurement(truth)
    _, found = align(measurement, profile(name), freedom)
    best = optimum(points, measurement, truth, freedom.free, ~points.outlier)
    assert apart(found.transform, best, measurement.points[:, :2])[0] < REACHED
    for value, is_free, row in zip([*found.shift, found.rotation], freedom.free, range(3), strict=True):
        assert is_free or value == 0
        assert (found.covariance[row, row] > 0) == is_free
        assert is_free or not found.covariance[row].any()


def test_all_points_count_on_demand():
    points = sample(CONTOURS["closed"], 300, 2)
    measurement = points.measurement(OFF)
    _, found = align(measurement, profile("closed"), Freedom.parse("rigid:all"))
    best = optimum(points, measurement, OFF, (1, 1, 1), np.ones(300, dtype=bool))
    # An outlier of 1.5 mm may have its foot point past the end of its element, which the closed form does not see.
    assert apart(found.transform, best, measurement.points[:, :2])[0] < 0.02
    assert (found.weight[found.taking_part] == 1).all()


@settings(
    max_examples=examples(25), deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much]
)
@given(parts(), st.floats(-3, 3), st.floats(-3, 3), st.floats(-3, 3), st.integers(0, 99))
def test_finds_back_from_anywhere_near(part, dx, dy, angle, seed):
    elements = part.elements
    assume(min(e.length for e in elements) > 1.2)
    points = sample(elements, 400, seed)
    away = Transform.about(math.radians(angle), tuple(part.vertices.mean(axis=0)), (dx, dy))
    start = points.measurement(Transform())
    _, near = align(start, part.profile)
    _, far = align(points.measurement(away), part.profile)
    # Both minimise the same sum from different starts: they meet to rounding, 1e-9 mm a step's end, unless a
    # point on the brink of a corner or of a limit of weight changes sides, which shifts the optimum by some
    # noise / n = 2 um / 400 a point.
    distance, _ = apart(away.inverse().then(far.transform), near.transform, points.points)
    same = np.array_equal(near.taking_part, far.taking_part)
    assert distance < (1e-7 if same else 0.05 * MICRON)


def test_order_of_the_points_does_not_matter():
    points = sample(CONTOURS["closed"], 900, 4)
    measurement = points.measurement(OFF)
    order = np.random.default_rng(1).permutation(900)
    other = measured(measurement.points[order, :2])
    a, b = align(measurement, profile("closed"))[1], align(other, profile("closed"))[1]
    assert apart(a.transform, b.transform, measurement.points[:, :2])[0] < 1e-7
    assert b.weight == pytest.approx(a.weight[order], abs=1e-6)


def test_form_error_is_kept():
    # A wave of the fifth order on a circle's flat cousin: no rigid motion takes it away.
    points = sample(CONTOURS["closed"], 2000, 1, form=lambda f: 0.017 * np.sin(2 * np.pi * 9 * f))
    _, found = align(points.measurement(OFF), profile("closed"))
    kept = points.deviation(points.points)[0][~points.outlier]
    assert found.after.rms == pytest.approx(np.sqrt(np.mean(kept**2)), rel=0.02)


@pytest.mark.parametrize("thickness", [2.0, 3.0])
def test_short_ends_hold_a_long_wall(thickness):
    # Two points in a hundred lie on the ends, which alone tell the shift along the wall: seen from 1 mm away they
    # look like outliers.
    elements = rectangle(100.0, thickness).elements
    points = sample(elements, 500, 6, outliers=0.0, margin=0.2)
    away = Transform.about(math.radians(0.4), (50.0, 1.0), (0.9, 0.3))
    measurement = points.measurement(away)
    _, found = align(measurement, profile_of(elements))
    best = optimum(points, measurement, away, (1, 1, 1), np.ones(500, dtype=bool))
    assert apart(found.transform, best, measurement.points[:, :2])[0] < REACHED


# ---- what the points do not determine -----------------------------------------------------------------------


def circle(radius=30.0, centre=(0.0, 0.0)):
    c = np.array(centre, dtype=float)
    a, b = c + [radius, 0], c - [radius, 0]
    return [Element(a, b, c, math.pi), Element(b, a, c, math.pi)]


@pytest.mark.parametrize("n", [60, 400, 5000])
@pytest.mark.parametrize("kind", ["circle", "spline", "facets"])
def test_turn_of_a_round_profile_is_undetermined(kind, n):
    centre = np.array([40.0, -25.0])
    elements = circle(30.0, centre)
    if kind == "circle":
        nominal = profile_of(elements)
    elif kind == "spline":
        # Round to 10 nm: the spline's poles scaled so that its mean radius is 30.
        curve = scipy_closed_spline(facetted_circle(1.0, 40))
        scale = 30 / np.hypot(*curve(np.linspace(0, 40, 4001)).T).mean()
        nominal = Profile.from_contours([Contour((closed_spline(facetted_circle(scale, 40) + centre),), True)])
    else:
        # 300 facets as a program with three decimals has them, 1.6 um high.
        v = np.round(facetted_circle(30 / math.cos(math.pi / 300) ** (2 / 3), 300) + centre, 3)
        nominal = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    points = sample(elements, n, 3)
    measurement = points.measurement(OFF)
    _, found = align(measurement, nominal)
    assert found.undetermined == ("turn about X40.0 Y-25.0",)
    assert found.rotation == 0 and found.covariance[2, 2] == 0
    start = np.array(OFF.points(centre[None])[0] - centre)
    best = optimum(points, measurement, Transform((start[0], start[1])), (1, 1, 0), ~points.outlier)
    tolerance = {"circle": REACHED, "spline": REACHED, "facets": 0.3 * MICRON}[kind]
    assert apart(found.transform, best, measurement.points[:, :2])[0] < tolerance
    assert any("do not determine the turn" in w for w in found.warnings)
    assert math.isnan(found.scale) and found.scale_uncertainty == math.inf


@pytest.mark.parametrize("seed", seeds(6, quick=2))
def test_coarse_polygon_for_a_circle_ends(seed):
    # 100 facets 15 um high: the sum of squares has a kink at every joint that a point passes, and hardly any slope
    # over the turn. The shift is that of the circle within what half a facet's height can push it.
    v = facetted_circle(30.0, 100)
    nominal = Profile.from_contours([Contour((polyline(np.vstack([v, v[:1]])),), True)])
    _, found = align(sample(circle(), 1000, seed).measurement(Transform((0.4, -0.3))), nominal)
    turned = Transform(rotation=found.rotation).points(np.array([[0.4, -0.3]]))[0]
    assert found.shift == pytest.approx(tuple(turned), abs=2 * MICRON)


def test_slide_along_a_straight_edge_is_undetermined():
    edge = [Element(np.array([10.0, 20.0]), np.array([90.0, 80.0]))]
    points = sample(edge, 200, 1, margin=8.0)
    away = Transform.about(math.radians(0.5), (50.0, 50.0), (-1.2, 1.6))
    measurement = points.measurement(away)
    _, found = align(measurement, profile_of(edge, closed=False))
    assert found.undetermined == ("shift along 36.9 deg to X",)
    # atan2(60, 80). The point that comes to rest on the middle has not moved along the edge as it was measured.
    middle = np.array([[50.0, 50.0]])
    back = found.transform.inverse()
    slide = (middle - back.points(middle)) @ back.directions(np.array([[0.8, 0.6]]))[0]
    # Foot points on the line give its direction to rounding; the last turn, below 1e-7 rad, times 2 mm.
    assert abs(slide) < 2e-7
    # Residuals are those of a straight line through the points, by the closed form of total least squares.
    good = measurement.points[~points.outlier, :2]
    least = np.linalg.svd(good - good.mean(axis=0))[1][-1]
    assert found.after.rms * math.sqrt(len(good)) == pytest.approx(least, rel=1e-9)
    assert found.offset_hidden == pytest.approx(1.0, abs=1e-12)
    assert any("hides 100 %" in w for w in found.warnings)


def test_turn_of_an_arc_is_undetermined():
    arc = [Element(np.array([30.0, 0]), np.array([0, 30.0]), np.zeros(2), math.pi / 2)]
    points = sample(arc, 300, 2, margin=4.0)
    measurement = points.measurement(Transform((1.0, 0.8), 0.01))
    _, found = align(measurement, profile_of(arc, closed=False))
    assert found.undetermined == ("turn about X0.0 Y0.0",) and found.rotation == 0
    best = optimum(points, measurement, Transform((1.0, 0.8)), (1, 1, 0), ~points.outlier)
    assert apart(found.transform, best, measurement.points[:, :2])[0] < REACHED


def test_a_turn_seen_through_noise_is_determined_only_where_it_is_certain():
    # A flat 0.4 mm deep holds the turn to about sigma / (slope sqrt(n)); noise of 50 um drowns it.
    elements = flattened_circle()
    fine = sample(elements, 200, 1, noise=2 * MICRON, outliers=0.0)
    rough = sample(elements, 200, 1, noise=50 * MICRON, outliers=0.0)
    assert align(fine.measurement(Transform()), profile_of(elements))[1].undetermined == ()
    found = align(rough.measurement(Transform()), profile_of(elements))[1]
    assert found.rotation == 0 and found.undetermined[0].startswith("turn about")


def test_one_place_tells_one_shift():
    # Fifty touches of one place on the bottom side of a rectangle: only Y is known.
    xy = np.tile([[30.0, 0.2]], (50, 1)) + np.random.default_rng(0).normal(0, 2 * MICRON, (50, 2))
    _, found = align(measured(xy), profile("sharp"))
    assert len(found.undetermined) == 2 and found.rotation == 0 and abs(found.shift[0]) < 1e-9
    assert found.shift[1] == pytest.approx(-xy[:, 1].mean(), abs=1e-9)


# ---- the minimum zone ---------------------------------------------------------------------------------------


def zone_oracle(sample, xy, start, free):
    """Least largest deviation over all points from the closed forms, by linear programmes; and the least rms.

    Where several motions reach it, the least root mean square among them is by scipy's SLSQP.
    """
    free = np.flatnonzero(free)
    p = np.array([*start.shift, start.rotation])

    def linear(p):
        moved = Transform((p[0], p[1]), p[2]).points(xy)
        d, g = sample.deviation(moved)
        arm = moved - p[:2]
        # Unknowns in um and 1e-5 rad, so that both matter alike to the optimisers.
        turn = (g[:, 1] * arm[:, 0] - g[:, 0] * arm[:, 1]) * 1e-5
        return d / MICRON, (np.column_stack([g * MICRON, turn]) / MICRON)[:, free]

    unit = np.array([MICRON, MICRON, 1e-5])[free]
    for _ in range(12):
        d, slope = linear(p)
        ones = np.ones((len(d), 1))
        found = linprog(
            np.append(np.zeros(len(free)), 1.0),
            np.block([[slope, -ones], [-slope, -ones]]),
            np.concatenate([-d, d]),
            bounds=[(-500, 500)] * len(free) + [(0, None)],
            method="highs",
        )
        p[free] += unit * found.x[:-1]
        d, slope = linear(p)
        height = np.abs(d).max()
        near = np.abs(d) > 0.3 * height
        among = minimize(
            lambda z, d=d, slope=slope: np.mean((d + slope @ z) ** 2),
            np.zeros(len(free)),
            jac=lambda z, d=d, slope=slope: 2 * slope.T @ (d + slope @ z) / len(d),
            constraints={
                "type": "ineq",
                "fun": lambda z, d=d[near], a=slope[near], h=height: np.append(h - d - a @ z, h + d + a @ z),
                "jac": lambda z, a=slope[near]: np.vstack([-a, a]),
            },
            method="SLSQP",
            options={"ftol": 1e-14, "maxiter": 500},
        )
    d = d + slope @ among.x
    return height * MICRON, np.sqrt(np.mean(d * d)) * MICRON


@pytest.mark.parametrize("seed", seeds(3, quick=1))
@pytest.mark.parametrize("name", ["closed", "sharp", "pocket", "open"])
def test_minimum_zone_against_linear_programmes(name, seed):
    points = sample(CONTOURS[name], 400, seed, outliers=0.0, noise=4 * MICRON, offset=3 * MICRON)
    measurement = points.measurement(OFF)
    _, found = align(measurement, profile(name), Freedom.parse("rigid:zone"))
    assert found.method == "minimum zone" and np.isnan(found.covariance).all() and not len(found.outliers)
    height, rms = zone_oracle(points, measurement.points[:, :2], OFF, (1, 1, 1))
    # HiGHS holds its constraints to 1e-7 of the scaled deviations, 0.02 mm at most here.
    assert found.after.max == pytest.approx(height, abs=5e-9)
    assert found.after.rms == pytest.approx(rms, abs=1e-7)
    _, squares = align(measurement, profile(name))
    assert found.after.max < squares.after.max and found.after.rms > squares.after.rms


@pytest.mark.parametrize("free", ["x", "turn", "x+y", "y+turn"])
def test_minimum_zone_with_locked_degrees_of_freedom(free):
    freedom = Freedom.parse(free + ":zone")
    points = sample(CONTOURS["closed"], 300, 8, outliers=0.0)
    measurement = points.measurement(Transform())
    _, found = align(measurement, profile("closed"), freedom)
    height, rms = zone_oracle(points, measurement.points[:, :2], Transform(), freedom.free)
    assert found.after.max == pytest.approx(height, abs=5e-9)
    assert found.after.rms == pytest.approx(rms, abs=1e-7)
    assert all(is_free or v == 0 for v, is_free in zip([*found.shift, found.rotation], freedom.free, strict=True))


def test_minimum_zone_of_a_lobed_circle_is_its_amplitude():
    # r = 30 + a cos 3 t touches its zone at six alternating places: no shift makes the largest deviation less.
    t = 2 * np.pi * np.arange(3600) / 3600
    r = 30 + 0.02 * np.cos(3 * t)
    xy = np.stack([r * np.cos(t), r * np.sin(t)], axis=1) + [0.5, -0.3]
    _, found = align(measured(xy), profile_of(circle()), Freedom.parse("rigid:zone"))
    assert found.after.max == pytest.approx(0.02, abs=1e-9)
    assert found.shift == pytest.approx((-0.5, 0.3), abs=1e-8)


def test_minimum_zone_leaves_outliers_out():
    points = sample(CONTOURS["closed"], 400, 3)
    measurement = points.measurement(OFF)
    _, found = align(measurement, profile("closed"), Freedom.parse("rigid:zone"))
    assert found.after.max < 5 * 2 * MICRON
    assert set(np.flatnonzero(points.outlier)) <= set(found.outliers)


# ---- uncertainty, and what the fit absorbs ------------------------------------------------------------------


@pytest.mark.few(1)
@pytest.mark.parametrize("trials", [50, slow(150)])
@pytest.mark.parametrize("name", ["closed", "open"])
def test_covariance_against_simulation(name, trials):
    n = 80
    nominal = profile(name)
    normalised, whitened = [], []
    for seed in range(trials):
        points = sample(CONTOURS[name], n, seed, outliers=0.0, noise=3 * MICRON)
        _, found = align(points.measurement(Transform()), nominal)
        error = np.array([*found.shift, found.rotation])
        root = np.linalg.cholesky(found.covariance)
        whitened.append(np.linalg.solve(root, error))
        normalised.append(whitened[-1] @ whitened[-1])
    # With sigma estimated from f = n - 4 or so degrees of freedom, the sum of trials is near chi2 with 3 trials,
    # larger by f / (f - 2); four of its standard deviations.
    expected = 3 * trials * (n - 4) / (n - 6)
    assert np.sum(normalised) == pytest.approx(expected, abs=4 * math.sqrt(2 * 3 * trials))
    spread = np.cov(np.transpose(whitened))
    # Off-diagonal elements of a sample covariance of white numbers scatter by 1 / sqrt(trials), the diagonal by
    # sqrt(2 / trials).
    assert np.abs(spread - np.eye(3) * (n - 4) / (n - 6)).max() < 4.5 * math.sqrt(2 / trials)


def test_reports_what_was_absorbed():
    points = sample(CONTOURS["closed"], 400, 3, offset=10 * MICRON)
    measurement = points.measurement(OFF)
    _, found = align(measurement, profile("closed"))
    assert found.before.rms > 0.5 and found.after.rms == pytest.approx(math.hypot(10, 2) * MICRON, rel=0.02)
    # Excess all round is not hidden by a shift of a closed contour.
    assert found.after.mean == pytest.approx(10 * MICRON, rel=0.03) and found.offset_hidden < 0.05
    assert not any("hides" in w or "size" in w for w in found.warnings)
    data = json.loads(json.dumps(found.as_dict(), allow_nan=False))
    assert data["shift"] == list(found.shift) and data["rotation_deg"] == math.degrees(found.rotation)
    assert "rms" in found.in_words() and "\n" not in found.in_words()


@pytest.mark.parametrize("half", [30.0, 60.0, 120.0, 175.0])
def test_share_of_an_offset_that_an_arc_hides(half):
    # Shifts push an arc by cos t and sin t: the share of 1 they hide is <1, cos>2 / (<1, 1> <cos, cos>).
    a = math.radians(half)
    p, q = (30 * np.array([math.cos(t), math.sin(t)]) for t in (-a, a))
    arc = [Element(p, q, np.zeros(2), 2 * a)]
    t = np.linspace(-a, a, 20001)[1:-1]
    xy = 30 * np.stack([np.cos(t), np.sin(t)], axis=1)
    _, found = align(measured(xy), profile_of(arc, closed=False), Freedom.parse("shift"))
    expected = (2 * math.sin(a)) ** 2 / (2 * a * (a + math.sin(2 * a) / 2))
    assert found.offset_hidden == pytest.approx(expected, abs=1e-3)


def test_scale_is_estimated_told_and_not_applied():
    points = sample(CONTOURS["closed"], 400, 3)
    warm = Sample(**{**vars(points), "points": points.points * 1.0003})
    measurement = warm.measurement(OFF)
    _, found = align(measurement, profile("closed"))
    assert found.scale == pytest.approx(1.0003, abs=4 * found.scale_uncertainty)
    assert found.scale_uncertainty < 2e-5
    assert any("not applied" in w for w in found.warnings)
    lengths = found.transform.points(measurement.points[:, :2])[[0, 200]]
    assert np.hypot(*(lengths[1] - lengths[0])) == pytest.approx(np.hypot(*(warm.points[200] - warm.points[0])))


def test_a_displaced_side_is_pointed_out():
    points = sample(CONTOURS["closed"], 400, 3, outliers=0.0)
    side = points.owner == 0
    xy = points.points + np.where(side, 0.1, 0.0)[:, None] * points.normals
    _, found = align(measured(xy), profile("closed"))
    assert any("is a side of the part displaced" in w for w in found.warnings)


def test_nothing_free_changes_nothing():
    measurement = sample(CONTOURS["closed"], 50).measurement(OFF)
    same, found = align(measurement, profile("closed"), Freedom.parse("none"))
    assert same is measurement and found.method == "none" and found.transform == Transform()
    assert found.before is found.after and found.before.rms > 0.1
    assert isinstance(found, Alignment) and json.dumps(found.as_dict(), allow_nan=False)


def test_given_motion_tells_what_it_did():
    points = sample(CONTOURS["closed"], 200, 1, outliers=0.0)
    moved, found = alignment.given(points.measurement(OFF), OFF, profile("closed"))
    assert moved.points[:, :2] == pytest.approx(points.points, abs=1e-12)
    assert found.before.rms > 0.5 and found.after.rms == pytest.approx(2 * MICRON, rel=0.2)


# ---- what is refused ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("free", "needed"), [("x", 2), ("shift", 3), ("rigid", 4)])
def test_too_few_points(free, needed):
    xy = np.array([[20.0, 0.0], [80.0, 20.0], [40.0, 50.0], [0.0, 30.0]])
    nominal, freedom = profile("sharp"), Freedom.parse(free)
    with pytest.raises(InputError, match=f"needs at least {needed} points") as error:
        align(measured(xy[: needed - 1]), nominal, freedom)
    assert "\n" not in str(error.value)
    _, found = align(measured(xy[:needed]), nominal, freedom)
    assert found.after.max < 1e-9


def test_no_points_at_all():
    with pytest.raises(InputError, match="needs at least 4 points, there are 0"):
        align(measured(np.zeros((0, 2))), profile("sharp"))


def test_points_of_another_unit():
    points = sample(CONTOURS["closed"], 200).points * 25.4
    with pytest.raises(FitError, match="check unit"):
        align(measured(points), profile("closed"))


@pytest.mark.thorough
def test_points_of_another_part():
    with pytest.raises(FitError, match="farther than 1 mm") as error:
        align(measured(sample(circle(12.0), 300).points + [20, 20]), profile("closed"))
    assert "\n" not in str(error.value)


def test_ball_centres_on_the_wrong_side():
    points = sample(CONTOURS["closed"], 200, 1, ball_radius=2.0, margin=2.5)
    with pytest.raises(FitError, match="farther than 1 mm"):
        align(points.measurement(OFF), profile("closed").reversed())
