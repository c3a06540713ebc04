# SPDX-License-Identifier: LGPL-2.1-or-later
"""Touches of a ball that moves along an axis, and what the control makes of its radius.

The touches are solved here without the package's geometry: a ball of radius r moves until its centre lies r from a
straight edge, an arc or a spline (scipy), the latter by the offset curve's crossing with the line of travel.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from millcorr import nc, pipeline, plausibility, readers
from millcorr.comparison import alignment
from millcorr.comparison.ball_radius import axis_signature, contact_known, numbered_as_read
from millcorr.comparison.deviation import deviations
from millcorr.errors import DistrustError, FormatError, InputError, UsageError
from millcorr.geometry.profile import Contour, Profile
from millcorr.readers import probe_file
from millcorr.readers.mapping import TextMapping
from millcorr.readers.measurement import Measurement, Probe
from millcorr.readers.transform import Transform
from tests.core import measurement_files
from tests.core.contours import (
    Element,
    closed_spline,
    pocket,
    profile_of,
    rectangle,
    scipy_closed_spline,
    spline_poles,
)
from tests.core.sweeps import examples

EXACT = 1e-9
AXES = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])


def measured(points, *, shifted=None, travel=None, normals=None, ball=0.0, probe=None, **more) -> Measurement:
    def flat(a):
        return None if a is None else np.column_stack([np.reshape(a, (-1, 2)), np.zeros(len(np.reshape(a, (-1, 2))))])

    xyz = flat(np.asarray(points, dtype=float))
    radii = (shifted, shifted) if isinstance(shifted, float) else shifted
    return Measurement(
        xyz, flat(normals), ball, np.arange(1, len(xyz) + 1), "part.csv", "0" * 64,
        axis_radii=radii, travel=flat(travel), probe=probe, **more,
    )  # fmt: skip


def edge(slope: float, length: float = 400.0) -> tuple[Profile, np.ndarray]:
    """Straight edge through the origin with the material on its left, and its outward normal; slope in rad."""
    way = np.array([np.cos(slope), np.sin(slope)])
    line = Element(-length / 2 * way, length / 2 * way)
    return profile_of([line], closed=False), np.array([way[1], -way[0]])


def touch_of_edge(normal, start, direction, radius, excess=0.0):
    """Ball centre where it touches a straight edge through the origin: n . c = r + excess on the line of travel."""
    way = (radius + excess - start @ normal) / (direction @ normal)
    return start + way * direction


def nearer_axis(normal):
    """Direction of travel of petrakov-2018 against a normal."""
    k = int(np.argmax(np.abs(normal)))
    out = np.zeros(2)
    out[k] = -np.sign(normal[k])
    return out


# --- straight edges: closed forms -------------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [*range(0, 44), *range(47, 91)])
def test_slopes_from_0_to_90_degrees(degrees):
    radius = 3.0
    profile, normal = edge(np.radians(degrees))
    direction = nearer_axis(normal)
    theta = np.arccos(-direction @ normal)
    assert np.degrees(theta) == pytest.approx(min(degrees, 90 - degrees), abs=1e-9)
    excess = 0.017
    centre = touch_of_edge(normal, 5.0 * normal, direction, radius, excess)
    reported = centre + radius * direction
    plain = deviations(measured(reported), profile).value[0]
    # Taken for a contact point the reading errs along the normal by r (1 - cos theta), along the axis by
    # r (1 / cos theta - 1): nothing at multiples of 90 degrees.
    assert plain - excess == pytest.approx(radius * (1 - np.cos(theta)), abs=EXACT)
    along_axis = (reported @ normal - excess) / (-direction @ normal)
    assert along_axis == pytest.approx(radius * (1 / np.cos(theta) - 1), abs=EXACT)
    if degrees == 30:
        assert plain - excess == pytest.approx(0.401923788646684, abs=1e-9)
    if degrees in (0, 90):
        assert plain == pytest.approx(excess, abs=1e-12)
    for travel in (None, direction):
        known = contact_known(measured(reported, shifted=radius, travel=travel), profile)
        np.testing.assert_allclose(known.points[0, :2], centre, atol=1e-12)
        found = deviations(known, profile)
        assert known.ball_radius == radius and found.value[0] == pytest.approx(excess, abs=EXACT)
        # The contact point is the foot and the deviation along the normal.
        np.testing.assert_allclose((found.foot + found.components)[0], centre - radius * normal, atol=EXACT)


@pytest.mark.parametrize("degrees", [44.01, 45.0, 45.99])
def test_near_45_degrees_the_rule_does_not_decide(degrees):
    profile, normal = edge(np.radians(degrees))
    for direction in (np.array([np.copysign(1.0, -normal[0]), 0.0]), np.array([0.0, np.copysign(1.0, -normal[1])])):
        centre = touch_of_edge(normal, 5.0 * normal, direction, 3.0, 0.01)
        reported = centre + 3.0 * direction
        for normals in (None, normal):
            with pytest.raises(InputError, match="too near to 45 degrees"):
                contact_known(measured(reported, shifted=3.0, normals=normals), profile)
        # With the direction it is as exact as anywhere.
        known = contact_known(measured(reported, shifted=3.0, travel=direction), profile)
        assert deviations(known, profile).value[0] == pytest.approx(0.01, abs=EXACT)


@settings(max_examples=examples(150), deadline=None, derandomize=True)
@given(
    slope=st.floats(-np.pi, np.pi),
    radius=st.floats(0.25, 10.0),
    angle=st.floats(-1.39, 1.39),
    excess=st.floats(-0.3, 0.3),
    along=st.floats(-50.0, 50.0),
    normals=st.booleans(),
)
def test_any_direction_of_travel_on_any_slope_from_either_side(slope, radius, angle, excess, along, normals):
    """Up to 80 degrees between travel and normal; slopes all round put the material on either side."""
    profile, normal = edge(slope)
    c, s = np.cos(angle), np.sin(angle)
    direction = -np.array([c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]])
    start = along * np.array([-normal[1], normal[0]]) + 3 * radius * normal
    centre = touch_of_edge(normal, start, direction, radius, excess)
    assume(np.hypot(*centre) < 190.0)
    touched = measured(
        centre + radius * direction, shifted=radius, travel=direction, normals=normal if normals else None
    )
    found = deviations(contact_known(touched, profile), profile)
    # Coordinates of 200 mm carry 3e-14 each.
    assert found.value[0] == pytest.approx(excess, abs=EXACT)
    plain = deviations(measured(centre + radius * direction), profile, reach=20.0).value[0]
    assert plain == pytest.approx(excess + radius * (1 - np.cos(angle)), abs=EXACT)


@settings(max_examples=examples(150), deadline=None, derandomize=True)
@given(slope=st.floats(-np.pi, np.pi), radius=st.floats(0.25, 10.0), excess=st.floats(-0.3, 0.3), normals=st.booleans())
def test_the_rule_on_any_slope(slope, radius, excess, normals):
    profile, normal = edge(slope)
    off = abs(np.arctan2(abs(normal[1]), abs(normal[0])) - np.pi / 4)
    assume(off > np.radians(1.01))
    direction = nearer_axis(normal)
    centre = touch_of_edge(normal, 2 * radius * normal, direction, radius, excess)
    touched = measured(centre + radius * direction, shifted=radius, normals=normal if normals else None)
    assert deviations(contact_known(touched, profile), profile).value[0] == pytest.approx(excess, abs=EXACT)


def test_formulas_1_and_2_of_petrakov_2018():
    """(1) for 3 pi / 2 <= alpha <= 7 pi / 4, touched along X, (2) beyond, along Y; signs for travel in +X and -Y.

    What is printed is right for the coordinate along the axis of travel. The other one is printed as measured, while
    the ball touches r sin theta beside it, so the printed pair errs along the normal by r sin(theta)^2.
    """
    radius = 3.0
    for alpha in np.radians([*range(270, 314, 3), *range(317, 361, 3)]):
        profile, normal = edge(alpha)
        # Material on the left: seen along the contour it lies in +X and +Y.
        along_x = alpha <= 7 * np.pi / 4
        direction = np.array([1.0, 0.0]) if along_x else np.array([0.0, 1.0])
        centre = touch_of_edge(normal, 8 * normal, direction, radius)
        stop = centre + radius * direction
        found = deviations(contact_known(measured(stop, shifted=radius), profile), profile)
        contact = (found.foot + found.components)[0]
        turned = alpha - 3 * np.pi / 2
        if along_x:
            printed = np.array([stop[0] - radius * (1 - np.cos(turned)), stop[1]])
            theta = turned
        else:
            printed = np.array([stop[0], stop[1] - radius * (1 - np.sin(turned))])
            theta = np.pi / 2 - turned
        axis = 0 if along_x else 1
        assert contact[axis] == pytest.approx(printed[axis], abs=EXACT)
        assert abs(contact[1 - axis] - printed[1 - axis]) == pytest.approx(radius * np.sin(theta), abs=EXACT)
        assert abs(printed @ normal) == pytest.approx(radius * np.sin(theta) ** 2, abs=EXACT)


# --- arcs and splines -------------------------------------------------------------------------------------


def disc(radius: float, hollow: bool) -> Profile:
    start = np.array([radius, 0.0])
    arc = Element(start, start, np.zeros(2), -2 * np.pi if hollow else 2 * np.pi)
    return profile_of([arc])


@settings(max_examples=examples(100), deadline=None, derandomize=True)
@given(
    big=st.floats(6.0, 80.0),
    radius=st.floats(0.25, 5.0),
    where=st.floats(-0.95, 0.95),
    k=st.integers(0, 3),
    hollow=st.booleans(),
    excess=st.floats(-0.2, 0.2),
)
def test_arcs_touched_along_an_axis(big, radius, where, k, hollow, excess):
    """|c| = R + r + d outside, R - r - d inside a hole, on a line parallel to an axis."""
    reach = big - radius - excess if hollow else big + radius + excess
    direction = AXES[k]
    aside = np.array([-direction[1], direction[0]])
    half = np.sqrt(1 - where**2)
    # From outside the ball meets the near side of the disc, from inside the far side of the hole.
    centre = reach * (where * aside + (half if hollow else -half) * direction)
    touched = measured(centre + radius * direction, shifted=radius, travel=direction)
    profile = disc(big, hollow)
    assert deviations(contact_known(touched, profile), profile).value[0] == pytest.approx(excess, abs=EXACT)
    # Without the direction: exact where the other three would be touches of no slope of theirs, else refused.
    others = centre + radius * direction - radius * AXES[np.arange(4) != k]
    far = np.hypot(*others.T)
    normal = (-1 if hollow else 1) * others / far[:, None]
    towards = -(normal * AXES[np.arange(4) != k]).sum(axis=1)
    off = (big - far if hollow else far - big) - radius
    assume((np.abs(towards - np.cos(np.radians(46))) > 1e-6).all() and abs(half - np.cos(np.radians(46))) > 1e-6)
    assume((np.abs(np.abs(off) - 1.0) > 1e-6).all())
    count = ((towards > np.cos(np.radians(46))) & (np.abs(off) < 1.0)).sum() + (half > np.cos(np.radians(46)))
    ruled = replace(touched, travel=None)
    if count == 1 and half > np.cos(np.radians(46)):
        assert deviations(contact_known(ruled, profile), profile).value[0] == pytest.approx(excess, abs=EXACT)
    elif count != 1:
        with pytest.raises(InputError, match="along X (or|nor) along Y"):
            contact_known(ruled, profile)


def touches_of_spline(poles, radius, excess, levels, direction):
    """Ball centres that first touch a closed spline with an excess of material, on lines of travel at the levels.

    The centre lies on the curve r + d outside: brentq on its coordinate across the travel, the outermost crossing.
    """
    curve = scipy_closed_spline(poles)
    slope = curve.derivative()
    axis = int(np.flatnonzero(direction)[0])

    def normal(u):
        t = slope(u)
        t = t / np.hypot(*np.atleast_2d(t).T).reshape(-1, 1) if np.ndim(u) else t / np.hypot(*t)
        return np.stack([t[..., 1], -t[..., 0]], axis=-1)

    def offset(u):
        return curve(u) + (radius + excess) * normal(u)

    grid = np.linspace(0.0, len(poles), 2001)
    across = offset(grid)[:, 1 - axis]
    centres, normals = [], []
    for level in levels:
        found = []
        for i in np.flatnonzero((across[:-1] - level) * (across[1:] - level) < 0):
            u = brentq(lambda u, y=level: offset(u)[1 - axis] - y, grid[i], grid[i + 1], xtol=1e-14, rtol=1e-15)
            found.append((offset(u)[axis] * direction[axis], u))
        if found:
            u = min(found)[1]
            centres.append(offset(u))
            normals.append(normal(u))
    return np.array(centres).reshape(-1, 2), np.array(normals).reshape(-1, 2)


@settings(max_examples=examples(12), deadline=None, derandomize=True)
@given(poles=spline_poles(), radius=st.sampled_from([0.5, 1.0, 3.0]), excess=st.floats(-0.1, 0.1), k=st.integers(0, 3))
def test_a_spline_touched_along_an_axis(poles, radius, excess, k):
    direction = AXES[k]
    centres, normals = touches_of_spline(poles, radius, excess, np.linspace(-22.0, 22.0, 23), direction)
    steep = -(normals @ direction)
    centres, steep = centres[steep > 0.2], steep[steep > 0.2]
    assert len(centres) >= 10
    profile = Profile.from_contours([Contour((closed_spline(poles),), True)])
    reported = centres + radius * direction
    touched = measured(reported, shifted=radius, travel=np.tile(direction, (len(centres), 1)))
    known = contact_known(touched, profile)
    np.testing.assert_allclose(known.points[:, :2], centres, atol=1e-13)
    found = deviations(known, profile)
    assert len(found) >= 0.7 * len(centres)
    np.testing.assert_allclose(found.value, excess, atol=EXACT)
    # By the rule alone: what is not left out is exact.
    kept = steep > np.cos(np.radians(44))
    assume(kept.sum() >= 3)
    try:
        known = contact_known(measured(reported[kept], shifted=radius), profile)
    except InputError:
        return
    left = np.delete(np.arange(kept.sum()), [row for row, _ in known.left_out])
    np.testing.assert_allclose(known.points[:, :2], centres[kept][left], atol=1e-13)


def test_the_rule_decides_most_points_of_a_large_spline():
    poles = 60.0 * np.stack([np.cos(a := np.arange(12) * np.pi / 6), 0.7 * np.sin(a)], axis=1)
    profile = Profile.from_contours([Contour((closed_spline(poles),), True)])
    reported, truth = [], []
    for direction in AXES:
        centres, normals = touches_of_spline(poles, 1.0, 0.01, np.linspace(-50.0, 50.0, 401), direction)
        use = -(normals @ direction) > np.cos(np.radians(45))
        reported.append(centres[use] + direction)
        truth.append(centres[use])
    reported, truth = np.concatenate(reported), np.concatenate(truth)
    known = contact_known(measured(reported, shifted=1.0), profile)
    gone = [row for row, _ in known.left_out]
    assert 0 < len(gone) < 0.1 * len(reported)
    np.testing.assert_allclose(known.points[:, :2], np.delete(truth, gone, axis=0), atol=1e-13)
    found = numbered_as_read(deviations(known, profile), known)
    np.testing.assert_allclose(found.value, 0.01, atol=EXACT)
    assert sorted([*found.index, *(r.index for r in found.rejected)]) == list(range(len(reported)))
    assert {r.index for r in found.rejected} >= set(gone)
    # Alone or among many, the search for feet goes another way.
    many = contact_known(measured(np.tile(reported, (12, 1)), shifted=1.0), profile)
    np.testing.assert_allclose(many.points[: len(known)], known.points, atol=1e-12)


def test_wrong_travel_is_left_out_and_said():
    profile, normal = edge(0.3)
    direction = nearer_axis(normal)
    centre = touch_of_edge(normal, 5 * normal, direction, 2.0)
    way = np.array([-normal[1], normal[0]])
    points = np.stack([centre + 2 * direction, centre + 2 * direction + 9 * way])
    travel = np.stack([direction, -direction])
    known = contact_known(measured(points, shifted=2.0, travel=travel), profile)
    assert known.left_out == ((1, "the probe did not travel towards the material here"),)
    np.testing.assert_array_equal(known.lines, [1])
    with pytest.raises(InputError, match="part.csv: .* none of 2 points, most are the probe did not travel"):
        contact_known(measured(points, shifted=2.0, travel=-direction * np.ones((2, 1))), profile)
    with pytest.raises(InputError, match="touched neither along X nor along Y"):
        contact_known(measured(points + 40 * normal, shifted=2.0), profile)


def test_both_sides_of_a_wall_and_of_a_pocket():
    for part, inwards in ((rectangle(60.0, 40.0), 1.0), (pocket(60.0, 40.0), -1.0)):
        # A ball of 2 mm outside the block, or inside the pocket, 0.01 mm of material too much.
        off = inwards * 2.01
        centres = np.array([[-off, 20.0], [60 + off, 20.0], [30.0, -off], [30.0, 40 + off]])
        known = contact_known(measured(centres + 2 * inwards * AXES, shifted=2.0), part.profile)
        np.testing.assert_allclose(deviations(known, part.profile).value, 0.01, atol=1e-12)


def test_stock_left_on_the_part_stays_on_top():
    """A ball radius beside the shift is an allowance: the surface lies that far over the profile."""
    profile, normal = edge(0.4)
    direction = nearer_axis(normal)
    centre = touch_of_edge(normal, 9 * normal, direction, 2.0, 0.5 + 0.02)
    for travel in (None, direction):
        touched = measured(centre + 2 * direction, shifted=2.0, travel=travel, ball=0.5)
        known = contact_known(touched, profile)
        assert known.ball_radius == 2.5
        assert deviations(known, profile).value[0] == pytest.approx(0.02, abs=EXACT)


# --- calibrated probe -------------------------------------------------------------------------------------

THREE_LOBES = np.radians(np.arange(0.0, 360.0, 30.0))


def lobed(angle):
    """Effective radius of a probe with three springs, mm."""
    return 2.994 + 0.004 * np.cos(3 * angle - 0.7) - 0.001 * np.sin(angle)


def test_trigonometric_interpolation_goes_through_the_table_and_is_exact_for_its_harmonics():
    for directions in (THREE_LOBES, 0.2 + 2 * np.pi * np.arange(11) / 11):
        probe = Probe(2.994, directions.copy(), lobed(directions), "trigonometric")
        np.testing.assert_allclose(probe.effective(directions), lobed(directions), atol=1e-15)
        angle = np.linspace(-7.0, 7.0, 500)
        np.testing.assert_allclose(probe.effective(angle), lobed(angle), atol=1e-14)


@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(
    radii=st.lists(st.floats(2.95, 3.05), min_size=3, max_size=16),
    kind=st.sampled_from(["linear", "trigonometric"]),
    turn=st.floats(-6.0, 6.0),
)
def test_interpolation_goes_through_every_table_and_turns_with_it(radii, kind, turn):
    directions = 0.1 + 2 * np.pi * np.arange(len(radii)) / len(radii)
    probe = Probe(3.0, directions.copy(), np.array(radii), kind, (0.3, -0.2))
    np.testing.assert_allclose(probe.effective(directions), radii, atol=1e-12)
    np.testing.assert_allclose(probe.effective(directions + 2 * np.pi), radii, atol=1e-12)
    if kind == "linear":
        middle = directions + np.pi / len(radii)
        np.testing.assert_allclose(probe.effective(middle), (np.array(radii) + np.roll(radii, -1)) / 2, atol=1e-12)
    turned = Transform((5.0, 6.0), turn).measurement(measured([[1.0, 2.0]], ball=3.0, probe=probe)).probe
    angle = np.linspace(0.0, 7.0, 50)
    np.testing.assert_allclose(turned.effective(angle + turn), probe.effective(angle), atol=1e-12)
    np.testing.assert_allclose(turned.offset, Transform((0.0, 0.0), turn).matrix @ probe.offset, atol=1e-15)


@pytest.mark.parametrize("kind", ["centre", "axis"])
@pytest.mark.parametrize("interpolation", ["linear", "trigonometric"])
def test_lobing_and_stylus_offset_are_undone(kind, interpolation):
    """All round a disc, a hole and a spline, a ball that acts with another radius in every direction."""
    probe = Probe(2.994, THREE_LOBES.copy(), lobed(THREE_LOBES), interpolation, (0.012, -0.031))
    angle = np.linspace(0.0, 2 * np.pi, 72, endpoint=False) + 0.01
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    poles = np.stack([35 * np.cos(a := np.arange(12) * np.pi / 6), 28 * np.sin(a)], axis=1)
    curve = scipy_closed_spline(poles)
    tangent = curve.derivative()(np.linspace(0, 12, 72, endpoint=False))
    tangent /= np.hypot(*tangent.T)[:, None]
    spline = Profile.from_contours([Contour((closed_spline(poles),), True)])
    for profile, surface, normal in (
        (disc(30.0, False), 30 * out, out),
        (disc(30.0, True), 30 * out, -out),
        (spline, curve(np.linspace(0, 12, 72, endpoint=False)), np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)),
    ):
        d = 0.02 * np.sin(5 * angle)
        acting = probe.effective(np.arctan2(-normal[:, 1], -normal[:, 0]))
        seen = surface + (d + acting)[:, None] * normal - probe.offset
        touched = measured(seen, ball=probe.radius, probe=probe)
        if kind == "axis":
            # The control shifts by 3 mm, whatever the probe does.
            travel = np.array([nearer_axis(n) for n in normal])
            touched = measured(seen + 3.0 * travel, shifted=3.0, travel=travel, probe=probe)
        plain = deviations(replace(touched, axis_radii=None, travel=None, probe=None), profile)
        assert np.abs(plain.value - d[plain.index]).max() > 0.02
        for m in (touched, Transform((3.0, -8.0), 2.0).measurement(touched)):
            # The part and the machine turned together give the same deviations.
            moved = profile
            if m is not touched:
                moved = turned_profile(profile, Transform((3.0, -8.0), 2.0))
            known = contact_known(m, moved)
            assert known.probe is None and known.ball_radius == probe.radius and contact_known(known, moved) is known
            np.testing.assert_allclose(deviations(known, moved).value, d, atol=EXACT)


def turned_profile(profile: Profile, by: Transform) -> Profile:
    return Profile.from_contours(
        Contour(tuple(replace(c, poles=by.points(c.poles)) for c in contour.curves), contour.closed)
        for contour in profile.contours
    )


def test_a_radius_for_x_and_another_one_for_y():
    """Renishaw's O9803 keeps XRAD and YRAD: touches along each axis are shifted by their own."""
    probe = Probe(2.99, control_radii=(2.995, 2.983))
    profile = rectangle(60.0, 40.0, 12.0).profile
    centres = np.array([[-2.99 - 0.01, 20.0], [30.0, -2.99 - 0.01]])
    travel = np.array([[1.0, 0.0], [0.0, 1.0]])
    reported = centres + travel * [2.995, 2.983]
    for given_travel in (None, travel):
        touched = measured(reported, shifted=(2.995, 2.983), travel=given_travel, probe=probe)
        np.testing.assert_allclose(deviations(contact_known(touched, profile), profile).value, 0.01, atol=1e-12)
    oblique = measured(reported, shifted=(2.995, 2.983), travel=np.array([[0.6, 0.8], [0.0, 1.0]]), probe=probe)
    with pytest.raises(InputError, match="part.csv:1: the probe travelled along no axis"):
        contact_known(oblique, profile)
    with pytest.raises(InputError, match="two radii"):
        contact_known(measured(reported, shifted=(2.995, 2.983)), profile)


# --- the noun ---------------------------------------------------------------------------------------------


def test_a_turned_measurement_turns_its_travel():
    travel = np.array([[1.0, 0.0], [0.0, -1.0]])
    m = measured([[1.0, 2.0], [3.0, 4.0]], shifted=2.0, travel=travel)
    np.testing.assert_allclose(Transform((1, 1), np.pi / 2).measurement(m).travel[:, :2], [[0, 1], [1, 0]], atol=1e-16)
    ruled = replace(m, travel=None)
    assert Transform((1.0, 1.0)).measurement(ruled).axis_radii == (2.0, 2.0)
    assert Transform((0.0, 0.0), np.pi / 2).measurement(ruled).axis_radii == (2.0, 2.0)
    both = replace(m, axis_radii=(2.0, 2.1), travel=None, probe=Probe(2.0))
    assert Transform((0.0, 0.0), -np.pi / 2).measurement(both).axis_radii == (2.1, 2.0)
    assert Transform((0.0, 0.0), np.pi).measurement(both).axis_radii == (2.0, 2.1)
    for unknown in (ruled, both, replace(both, travel=m.travel)):
        with pytest.raises(InputError, match="turned by 30 degrees"):
            Transform((0.0, 0.0), np.radians(30)).measurement(unknown)


def test_the_fingerprint_is_that_of_the_points_as_read():
    points = [[1.0, 2.0], [3.0, 4.0]]
    plain = measured(points)
    shifted = measured(points, shifted=2.0, travel=[[1.0, 0.0], [0.0, 1.0]], probe=Probe(2.0, offset=(0.1, 0.0)))
    assert plain.fingerprint == shifted.fingerprint
    assert shifted.contact() is None and shifted.from_nominal() is None


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"travel": [[1.0, 0.0]]}, "directions of travel are for"),
        ({"shifted": 0.0}, "above 0 mm"),
        ({"shifted": (2.0, np.nan)}, "above 0 mm"),
        ({"shifted": 2.0, "travel": [[1.0, 0.1]]}, "part.csv:1: the direction of travel has not length 1"),
        ({"shifted": 2.0, "travel": [[np.nan, 0.1]]}, "length 1"),
        ({"shifted": 2.0, "travel": [[1.0, 0.0]] * 2}, r"must have shape \(1, 3\)"),
    ],
)
def test_a_measurement_that_contradicts_itself(more, says):
    with pytest.raises(InputError, match=says):
        measured([[1.0, 2.0]], **more)


# --- the probe's file -------------------------------------------------------------------------------------

GOOD = """
name = "40 mm stylus"
control_radius = [2.995, 2.993]
offset = [0.012, -0.008]
directions = [0, 90, 180, 270]
radii = [2.991, 2.993, 2.995, 2.993]
interpolation = "trigonometric"
"""


def test_a_probe_from_its_file(tmp_path):
    path = tmp_path / "probe.toml"
    path.write_text(GOOD)
    probe = probe_file.load(path)
    assert probe.radius == pytest.approx(2.993, abs=1e-15) and probe.source == str(path)
    assert probe.control_radii == (2.995, 2.993) and probe.offset == (0.012, -0.008)
    np.testing.assert_allclose(probe.effective(np.radians([180.0, -90.0])), [2.995, 2.993], atol=1e-15)
    path.write_text("radius = 3\ncontrol_radius = 2.99")
    probe = probe_file.load(path)
    assert (probe.radius, probe.control_radii, probe.directions) == (3.0, (2.99, 2.99), None)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("", "radius is missing"),
        ("raduis = 3", "did you mean radius"),
        ("colour = 3", "a probe has name, radius"),
        ("radius = -3", "radius is a number from 0 to 100, not '-3'"),
        ("radius = 0", "radius must be a length in mm above 0"),
        ("radius = true", "radius is a number"),
        ("radius = [3]", "radius is a number"),
        ("radius = nan", "radius is a number"),
        ("radius = '3'", "radius is a number"),
        ("name = 3\nradius = 3", "name is a text"),
        ("radius = 3\noffset = [1]", "offset is a list of 2 numbers"),
        ("radius = 3\noffset = 1", "offset is a list of 2 numbers"),
        ("radius = 3\ncontrol_radius = [1, 2, 3]", "control_radius is a number or a list of 2 numbers"),
        ("radius = 3\ncontrol_radius = 1.5", "control_radius must be within 0.1 mm"),
        ("radii = [3, 3, 3]", "directions is missing"),
        ("directions = [0, 120, 240]", "radii is missing"),
        ("radii = [3, 3]\ndirections = [0, 180]", "radii is a list of at least 3"),
        ("radii = [3, 3, 3]\ndirections = [0, 90, 180, 270]", "radii must be as many as directions"),
        ("radii = [3, 3, 3]\ndirections = [0, 240, 120]", "directions must be angles that increase"),
        ("radii = [3, 3, 3, 3]\ndirections = [0, 120, 240, 360]", "within one turn"),
        ("radii = [3, 3, 1.5]\ndirections = [0, 120, 240]", "radii must be lengths in mm within 0.1"),
        ("radius = 1.5\nradii = [3, 3, 3]\ndirections = [0, 120, 240]", "radii must be lengths in mm within 0.1"),
        ("radii = [3, 3, 3]\ndirections = [0, 90, 240]\ninterpolation = 'trigonometric'", "must be linear"),
        ("radius = 3\ninterpolation = 'cubic'", "interpolation is linear or trigonometric"),
        ("radius = ", "no TOML"),
        ("[radius]\nx = 1", "radius is a number"),
    ],
)
def test_a_wrong_probe_names_file_and_key(tmp_path, content, says):
    path = tmp_path / "probe.toml"
    path.write_text(content)
    with pytest.raises(FormatError, match=says) as caught:
        probe_file.load(path)
    assert str(caught.value).startswith(f"{path}:") and str(caught.value).count(str(path)) == 1
    assert "\n" not in str(caught.value)


def test_a_probe_that_is_not_there(tmp_path):
    with pytest.raises(FormatError, match="the probe cannot be read"):
        readers.read(tmp_path / "points.csv", points="centre", probe=tmp_path / "probe.toml")


# --- readers ----------------------------------------------------------------------------------------------


@pytest.fixture
def file(tmp_path):
    def make(content, name="points.txt"):
        path = tmp_path / name
        path.write_text(content)
        return path

    return make


TABLE = "x,y,z,axis\n1,2,-3,X+\n4,5,-3,-y\n7,8,-3, x -\n9,9,-3,+Z\n2,2,-3,Y\u22121\n"
XYZ = {"x": "x", "y": "y", "z": "z"}


def test_directions_of_travel_in_words(file):
    mapping = TextMapping(XYZ | {"travel": "axis"}, points="axis", probe_radius=2.5)
    path = file(TABLE.replace("\u22121", "\u2212"))
    m = readers.read(path, mapping=mapping)
    assert m.axis_radii == (2.5, 2.5) and m.ball_radius == 0
    np.testing.assert_array_equal(m.travel, [[1, 0, 0], [0, -1, 0], [-1, 0, 0], [0, 0, 1], [0, -1, 0]])
    np.testing.assert_array_equal(m.points[1], [4, 5, -3])
    with pytest.raises(FormatError, match="points.txt:6: .* is no direction of travel"):
        readers.read(file(TABLE), mapping=mapping)


def test_directions_of_travel_in_numbers(file):
    path = file("x,y,z,u,v,w\n1,2,-3,0.6,0.8,0\n4,5,-3,0,-0.999,0\n")
    columns = XYZ | {"travel_x": "u", "travel_y": "v", "travel_z": "w"}
    m = readers.read(path, points="axis", probe_radius=2.5, mapping=TextMapping(columns))
    np.testing.assert_allclose(m.travel, [[0.6, 0.8, 0], [0, -1, 0]], atol=1e-15)
    # Said to be something else, the columns do not count.
    assert readers.read(path, points="contact", mapping=TextMapping(columns)).travel is None
    with pytest.raises(FormatError, match="points.txt:2: the direction of travel has length 0.7"):
        readers.read(file("x,y,z,u,v,w\n1,2,-3,0.7,0,0\n"), points="axis", probe_radius=1, mapping=TextMapping(columns))


@pytest.mark.parametrize(
    ("columns", "points", "says"),
    [
        ({"travel": "a"}, "contact", "directions of travel are for points = 'axis'"),
        ({"travel_x": "u", "travel_y": "v"}, "centre", "directions of travel are for points = 'axis'"),
        ({"travel": "a", "travel_x": "u", "travel_y": "v"}, "axis", "say the same twice"),
        ({"travel_x": "u"}, "axis", "travel_y is missing"),
        ({"travel": "X"}, "axis", "two are the same column"),
    ],
)
def test_a_mapping_that_contradicts_itself(columns, points, says):
    with pytest.raises(FormatError, match=says):
        TextMapping(XYZ | columns, points=points)


def test_plain_text_goes_by_the_rule(file):
    path = file("x,y,z\n1,2,3\n4,5,6\n")
    m = readers.read(path, points="axis", probe_radius=2.0)
    assert m.axis_radii == (2.0, 2.0) and m.travel is None and m.ball_radius == 0
    with pytest.raises(UsageError, match="need --probe-radius"):
        readers.read(path, points="axis")
    with pytest.raises(UsageError, match="choose one of contact, centre, axis"):
        readers.read(path, points="axes")
    with pytest.raises(UsageError, match="leave --points axis out"):
        readers.text.write(path, m)
    inch = readers.read(path, points="axis", probe_radius=2.0, units="inch")
    assert inch.axis_radii == (2.0, 2.0) and inch.points[0, 0] == 25.4
    with pytest.raises(InputError, match="turned by -30 degrees"):
        readers.read(path, points="axis", probe_radius=2.0, work_rotation=30.0)


MSR = "START\nG800 N1 X10. Y0. Z-3. I1. J0. K0.\nG801 N1 X13.01 Y0. Z-3. R3.\nEND\n"


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (MSR, "centres of the probe ball"),
        (("1.000000 2.000000 3.000000" + " 0.000000" * 6 + "\n") * 2, "centres of the probe ball"),
        ("[PRB:1.000,2.000,3.000:1]\n", "centres of the probe ball"),
        ("$$ DMIS\nDMISMN/'A',05.0\nUNITS/MM,ANGDEC\nPRCOMP/ON\nF(P)=FEAT/POINT,CART,1,2,3,1,0,0\n"
         "FA(P)=FEAT/POINT,CART,1.01,2,3,1,0,0\nENDFIL\n", "contact points"),
    ],
)  # fmt: skip
def test_files_that_state_their_kind_contradict_axis(file, content, told):
    path = file(content)
    with pytest.raises(UsageError, match=f"--points axis contradicts .*{told}"):
        readers.read(path, points="axis", probe_radius=3.0, work_offset=(0.0, 0.0, 0.0) if "PRB" in content else None)


@pytest.mark.parametrize("compensated", [False, True])
def test_qif_says_it_or_leaves_it_open(file, compensated):
    part = measurement_files.ellipse(6, seed=1)
    told = file(measurement_files.qif(part, compensated=compensated), "told.qif")
    with pytest.raises(UsageError, match="--points axis contradicts"):
        readers.read(told, points="axis", probe_radius=1.5)
    left_open = file(measurement_files.qif(part, sets=False, stated=False), "open.qif")
    assert readers.read(left_open, points="axis", probe_radius=1.5).axis_radii == (1.5, 1.5)


def test_a_mapping_that_states_its_kind_contradicts_the_caller(file):
    path = file("x,y,z\n1,2,3\n")
    for stated, said in (("axis", "centre"), ("axis", "contact"), ("centre", "axis"), ("contact", "axis")):
        with pytest.raises(UsageError, match=f"--points {said} contradicts the mapping"):
            ball = None if said == "contact" else 2.0
            readers.read(path, points=said, probe_radius=ball, mapping=TextMapping(XYZ, points=stated))


def test_which_radius_counts(file):
    path = file("x,y,z\n1,2,3\n")
    probe = Probe(2.994, source="probe.toml")
    assert readers.read(path, points="centre", probe=probe).ball_radius == 2.994
    assert readers.read(path, points="centre", probe=probe, probe_radius=3.0).ball_radius == 2.994
    assert readers.read(path, points="axis", probe=probe).axis_radii == (2.994, 2.994)
    assert readers.read(path, points="axis", probe=probe, probe_radius=3.0).axis_radii == (3.0, 3.0)
    both = replace(probe, control_radii=(2.99, 3.0))
    assert readers.read(path, points="axis", probe=both).axis_radii == (2.99, 3.0)
    assert readers.read(file(MSR, "part.msr"), probe=probe).ball_radius == 2.994
    lobes = Probe(2.994, THREE_LOBES.copy(), lobed(THREE_LOBES))
    for said, options, probe_ in (
        ("--probe belongs to --points centre or axis", {"points": "contact"}, probe),
        ("contradicts probe.toml, which says 2.994", {"points": "centre", "probe_radius": 1.5}, probe),
        ("contradicts control_radius", {"points": "axis", "probe_radius": 3.0}, both),
        ("add --probe-radius", {"points": "axis"}, lobes),
    ):
        with pytest.raises(UsageError, match=said):
            readers.read(path, probe=probe_, **options)


# --- the whole way ----------------------------------------------------------------------------------------


def octagon(half: float = 30.0):
    """Block whose sides lie at 0, 30, 60, 90, ... degrees, anticlockwise, about the origin."""
    angle = np.radians(np.arange(0, 360, 30) + 15.0)
    return half * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def touched_block(radius: float, excess: float, per_side: int = 6):
    """Reported points of a block of 12 sides touched by the rule, with an excess of material, and their lines."""
    vertices = octagon()
    reported = []
    for k, v in enumerate(vertices):
        w = vertices[(k + 1) % len(vertices)]
        way = (w - v) / np.hypot(*(w - v))
        normal = np.array([way[1], -way[0]])
        direction = nearer_axis(normal)
        for u in np.linspace(0.25, 0.75, per_side):
            contact = v + u * (w - v) + excess * normal
            reported.append(contact + radius * normal + radius * direction)
    return np.array(reported)


def block_profile() -> Profile:
    v = octagon()
    return profile_of([Element(a, b) for a, b in zip(v, np.roll(v, -1, axis=0), strict=True)])


def test_the_whole_way_from_file_to_corrected_program(tmp_path):
    cutter, ball, excess = 5.0, 3.0, 0.02
    v = octagon()
    corners = v * (1 + cutter / (30.0 * np.cos(np.radians(15))))
    moves = "\n".join(f"X{x:.6f} Y{y:.6f}" for x, y in [*corners[1:], corners[0]])
    start = f"G0 X{corners[0][0]:.6f} Y{corners[0][1]:.6f}"
    program = tmp_path / "part.nc"
    program.write_text(f"G21 G90 G17 G40\nT1 M6\n{start} Z5\nG1 Z-3 F300\n{moves}\nG0 Z5\nM30\n")
    points = touched_block(ball, excess)
    # One reading that no side explains.
    points = np.insert(points, 5, [100.0, 100.0], axis=0)
    table = tmp_path / "points.csv"
    table.write_text("x,y,z\n" + "".join(f"{x:.9f},{y:.9f},-3\n" for x, y in points))
    measurement = readers.read(table, points="axis", probe_radius=ball)
    request = pipeline.Request(
        nc.read(program), cutter, measurement, None, pipeline.Settings(side="right", filter="none")
    )
    result = pipeline.correct(request)
    # Program and file carry 6 and 9 decimals.
    np.testing.assert_allclose(result.deviation.value, excess, atol=2e-6)
    assert 5 not in result.deviation.index
    assert [(r.index, r.reason[:15]) for r in result.deviation.rejected] == [(5, "touched neither")]
    assert result.summary()["points"] == {
        "parts": 1,
        "read": 73, "used": 72, "left_out": 1,
        "rejected": [{"index": 5, "reason": result.deviation.rejected[0].reason}],
    }  # fmt: skip
    # Taken for contact points, the slopes show 0.42 mm that are not there, and nothing is corrected.
    plain = readers.read(table, points="contact")
    naive = deviations(plain, block_profile()).value
    assert naive.max() == pytest.approx(excess + 3 * (1 - np.cos(np.radians(30))), abs=1e-6)
    with pytest.raises(DistrustError, match="--points axis .*--accept axis-compensated"):
        pipeline.correct(replace(request, measurement=plain))


def test_an_alignment_keeps_what_was_left_out():
    """Shifted by less than the rule's degree can notice: the rule decides as before, the fit finds the shift."""
    points = np.insert(touched_block(3.0, 0.0), 3, [100.0, 100.0], axis=0)
    known = contact_known(measured(points + [0.08, -0.05], shifted=3.0), block_profile())
    moved, found = alignment.align(known, block_profile(), alignment.Freedom.parse("shift"))
    np.testing.assert_allclose(found.transform.shift, [-0.08, 0.05], atol=1e-9)
    deviation = numbered_as_read(deviations(moved, block_profile()), moved)
    np.testing.assert_allclose(deviation.value, 0.0, atol=EXACT)
    np.testing.assert_array_equal(deviation.index, np.delete(np.arange(73), 3))


# --- recognised -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ball", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("said", ["contact", "centre"])
def test_the_signature_of_a_shift_along_an_axis(ball, said):
    rng = np.random.default_rng(7)
    points = touched_block(ball, 0.01, per_side=12)
    points += rng.normal(0, 0.003, points.shape)
    found = axis_signature(measured(points, ball=ball if said == "centre" else 0.0), block_profile())
    assert found is not None
    name, text, dangerous = found
    finding = plausibility.Finding(name, text, dangerous)
    assert finding.name == "axis-compensated" and finding.dangerous and "--points axis" in finding.text
    assert f"about {ball:.1f}" in text
    # Once it is said, there is nothing to find.
    assert axis_signature(measured(points, shifted=ball), block_profile()) is None
    known = contact_known(measured(points, shifted=ball), block_profile())
    assert axis_signature(known, block_profile()) is None


def test_the_signature_on_a_curved_contour():
    poles = 40.0 * np.stack([np.cos(a := np.arange(12) * np.pi / 6), 0.7 * np.sin(a)], axis=1)
    profile = Profile.from_contours([Contour((closed_spline(poles),), True)])
    reported, centres = [], []
    for direction in AXES:
        c, n = touches_of_spline(poles, 2.0, 0.01, np.linspace(-33.0, 33.0, 67), direction)
        use = -(n @ direction) > np.cos(np.radians(44))
        reported.append(c[use] + 2.0 * direction)
        centres.append(c[use])
    found = axis_signature(measured(np.concatenate(reported)), profile)
    assert found is not None and "about 2.0" in found[1]
    centres = np.concatenate(centres)
    assert axis_signature(measured(centres, ball=2.0), profile) is None
    assert axis_signature(measured(centres), profile) is None


@settings(max_examples=examples(20), deadline=None, derandomize=True)
@given(poles=spline_poles(), seed=st.integers(0, 99), size=st.floats(0.0, 0.1), shift=st.floats(-0.1, 0.1))
def test_no_signature_in_what_machining_leaves(poles, seed, size, shift):
    """Excess, waves up to 0.1 mm, a shifted part and noise on a spline."""
    rng = np.random.default_rng(seed)
    curve = scipy_closed_spline(poles)
    u = np.linspace(0.0, len(poles), 300, endpoint=False)
    tangent = curve.derivative()(u)
    tangent /= np.hypot(*tangent.T)[:, None]
    normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
    d = 0.02 + size * np.sin(2 * np.pi * rng.integers(1, 9) * u / len(poles) + rng.uniform(0, 6))
    points = curve(u) + (d + rng.normal(0, 0.003, 300))[:, None] * normal + [shift, -shift / 2]
    profile = Profile.from_contours([Contour((closed_spline(poles),), True)])
    assert axis_signature(measured(points), profile) is None


def test_no_signature_of_a_ball_too_small_to_tell():
    assert axis_signature(measured(touched_block(0.38, 0.0)), block_profile()) is None
    assert axis_signature(measured(touched_block(0.42, 0.0)), block_profile()) is not None


def test_no_signature_where_slopes_say_nothing():
    profile = rectangle(60.0, 40.0).profile
    x = np.linspace(5.0, 55.0, 40)
    assert axis_signature(measured(np.column_stack([x, np.full(40, -0.3)])), profile) is None
    assert axis_signature(measured(np.zeros((0, 2))), profile) is None


# --- the documentation ------------------------------------------------------------------------------------

PAGE = Path(__file__).resolve().parents[3] / "docs" / "probe-radius.md"


def test_the_figures_of_the_page():
    page = PAGE.read_text(encoding="utf-8")
    rows = {
        row.split("|")[1].strip(): row.split("|")[2:-1]
        for row in page.splitlines()
        if row.startswith(("| θ", "| along the normal", "| along the axis"))
    }
    theta = np.radians([float(cell.strip().rstrip("°")) for cell in rows["θ"]])
    for name, exact in (("normal", 3 * (1 - np.cos(theta))), ("axis", 3 * (1 / np.cos(theta) - 1))):
        printed = [float(cell) for cell in rows[f"along the {name}, mm"]]
        np.testing.assert_allclose(printed, exact, atol=0.5001e-4)


def test_the_example_of_the_page():
    page = PAGE.read_text(encoding="utf-8")
    reported = np.array([float(v) for v in re.search(r"reports X([\d.]+) Y([\d.]+),", page).groups()])
    contact = np.array([float(v) for v in re.search(r"= X([\d.]+) Y([\d.]+), 1.5 mm beside", page).groups()])
    profile, _ = edge(np.radians(30))
    assert f"**+{deviations(measured(reported), profile).value[0]:.6f}**" in page
    found = deviations(contact_known(measured(reported, shifted=3.0), profile), profile)
    # Six decimals are printed.
    assert found.value[0] == pytest.approx(0.0, abs=1e-6)
    np.testing.assert_allclose((found.foot + found.components)[0], contact, atol=1.5e-6)


def test_the_probe_of_the_page(tmp_path):
    page = PAGE.read_text(encoding="utf-8")
    blocks = re.findall(r"```toml\n(.*?)```", page, re.S)
    (calibration,) = [b for b in blocks if "radii" in b]
    (tmp_path / "probe.toml").write_text(calibration)
    probe = probe_file.load(tmp_path / "probe.toml")
    assert probe.control_radii == (2.997, 2.9943) and len(probe.radii) == 12
    keys = "".join(re.findall(r"(?m)^\| (`.*?) \|", page))
    assert set(probe_file.KEYS) == set(re.findall(r"`(\w+)`", keys))
