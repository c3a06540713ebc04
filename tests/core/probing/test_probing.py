# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plans of touches: places, directions, room for the ball, ways between touches."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.errors import RefusedError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Contour, Profile
from millcorr.probing import Placement, ProbingPlan, TouchProbe, places, plan, touch_directions
from millcorr.probing.links import clear
from millcorr.probing.space import Space, into_fillets
from tests.core.contours import (
    Element,
    Part,
    closed_spline,
    distance_to,
    facetted_circle,
    parts,
    pocket,
    polyline,
    profile_of,
    rectangle,
    spline_poles,
)
from tests.core.sweeps import examples, slow

BALL = TouchProbe(2.5)


def ring(radius: float, hollow: bool = False) -> Profile:
    east, west = np.array([radius, 0.0]), np.array([-radius, 0.0])
    halves = [Element(east, west, np.zeros(2), np.pi), Element(west, east, np.zeros(2), np.pi)]
    return profile_of([e.reversed() for e in reversed(halves)] if hollow else halves)


def stadium(length: float, radius: float) -> list[Element]:
    """Two straights joined by half circles, anticlockwise."""
    a, b = np.array([0.0, -radius]), np.array([length, -radius])
    c, d = np.array([length, radius]), np.array([0.0, radius])
    return [
        Element(a, b), Element(b, c, np.array([length, 0.0]), np.pi),
        Element(c, d), Element(d, a, np.array([0.0, 0.0]), np.pi),
    ]  # fmt: skip


def test_points_on_a_circle_are_even() -> None:
    for by_curvature in (False, True):
        contour, s, left_out = places(ring(30.0), Placement(count=12, by_curvature=by_curvature), 3.0)
        assert not left_out and not contour.any()
        gap = np.diff(np.sort(s), append=np.sort(s)[0] + 60.0 * np.pi)
        assert np.allclose(gap, 60.0 * np.pi / 12, atol=1e-6)


def test_spacing_is_the_largest_distance() -> None:
    _, s, _ = places(ring(30.0), Placement(spacing=7.0), 3.0)
    assert len(s) == int(np.ceil(60.0 * np.pi / 7.0))
    assert np.diff(np.sort(s)).max() <= 7.0


def test_half_of_the_points_go_by_turning() -> None:
    """On a stadium all turning is in the bends: they get half of the points, and their share of the other half."""
    length, radius, count = 100.0, 10.0, 400
    profile = profile_of(stadium(length, radius))
    total = 2 * length + 2 * np.pi * radius
    share = 2 * np.pi * radius / total
    for by_curvature, expected in ((False, share), (True, 0.5 + 0.5 * share)):
        _, s, _ = places(profile, Placement(count=count, by_curvature=by_curvature), 3.0)
        points, _ = profile.at(0, s)
        bent = (points[:, 0] < 0) | (points[:, 0] > length)
        # Four borders between straight and bend: a point more or less at each, and a sample where both mix.
        assert abs(bent.sum() - expected * count) <= 5


def test_turning_at_facets_counts_as_turning() -> None:
    """A facetted circle bends at its joints only; points go round as on the circle."""
    facets = Profile.from_contours([Contour((polyline(np.vstack([facetted_circle(30.0, 90)] * 2)[:91]),), True)])
    _, s, _ = places(facets, Placement(count=30, by_curvature=True), 3.0)
    side = float(facets.total[0]) / 90
    assert np.diff(np.sort(s)).max() < float(facets.total[0]) / 30 + side


def test_one_stretch_only() -> None:
    profile = rectangle(60, 40).profile
    made = plan(profile, Placement(count=8, stretch=2), BALL)
    assert len(made) == 8 and np.allclose(made.contact[:, 0], 60.0)
    assert (made.contact[:, 1] > 3.0).all() and (made.contact[:, 1] < 37.0).all()
    for stretch in (0, 5):
        with pytest.raises(UsageError, match="4 smooth stretches"):
            plan(profile, Placement(count=8, stretch=stretch), BALL)


def test_short_stretches_are_named() -> None:
    made = plan(rectangle(60, 5.9).profile, Placement(count=10), BALL)
    assert {round(left.x) for left in made.left_out} == {0, 60}
    assert all("5.900 mm" in left.reason and "6 mm" in left.reason for left in made.left_out)
    with pytest.raises(RefusedError, match="X.*Y.*smaller ball"):
        plan(rectangle(5.0, 5.0).profile, Placement(count=4), BALL)


@pytest.mark.parametrize("degrees", np.arange(0.0, 360.0, 7.5))
def test_direction_by_the_rule_of_the_paper(degrees: float) -> None:
    """Along X where the normal is nearer X, along Y where nearer Y, else along the normal (petrakov-2018)."""
    angle = np.radians(degrees)
    normal = np.array([[np.cos(angle), np.sin(angle)]])
    found = touch_directions(normal)[0]
    off = degrees % 90.0
    if off == 45.0:
        assert np.allclose(found, -normal[0])
    else:
        nearest = np.radians(90.0 * round(degrees / 90.0))
        assert np.allclose(found, [-np.cos(nearest), -np.sin(nearest)], atol=1e-12)
    assert np.count_nonzero(touch_directions(normal, "axis")) == 1
    assert np.array_equal(touch_directions(normal, "normal"), -normal)


def polygon(part: Part) -> shapely.Polygon:
    ring = np.concatenate([e.at(np.linspace(0, 1, 2 if e.centre is None else 400)[:-1]) for e in part.elements])
    return shapely.Polygon(ring)


def along(way: np.ndarray, steps: int) -> np.ndarray:
    """Points along a polyline."""
    u = np.linspace(0, 1, steps)[:, None]
    return np.concatenate([a + u * (b - a) for a, b in zip(way[:-1], way[1:], strict=True)])


def check(made: ProbingPlan, elements: list[Element], inside: shapely.Polygon, hollow: bool) -> None:
    """What every plan promises, by closed forms."""
    probe = made.probe
    r, c = probe.ball_radius, probe.clearance
    # The ball touches the nominal in the intended point, and in no other.
    assert np.abs(distance_to(elements, made.contact)).max() < 1e-9
    assert np.abs(distance_to(elements, made.centre) - r).max() < 2e-3
    assert np.allclose(made.centre - made.contact, r * made.normal, atol=1e-12)
    # Start, contact and target lie in a row, in the direction of travel.
    for a, b in ((made.start, made.centre), (made.centre, made.target)):
        way = b - a
        assert (np.hypot(*way.T) > 0).all()
        assert np.allclose(way / np.hypot(*way.T)[:, None], made.direction, atol=1e-9)
    slope = -(made.normal * made.direction).sum(axis=1)
    assert (slope > np.cos(np.radians(46.1))).all()
    assert np.allclose(((made.centre - made.target) * made.normal).sum(axis=1), probe.overtravel)
    assert (distance_to(elements, made.start) >= r + probe.stock + c / 2 - 1e-9).all()
    backed = ((made.start - made.centre) * made.normal).sum(axis=1)
    assert (backed >= probe.stock + c - 1e-9).all()
    assert all(inside.contains(shapely.Point(p)) == hollow for p in made.start)
    # Ways at measuring height keep half of the clearance, everywhere.
    for k, link in enumerate(made.links):
        if link is None:
            continue
        assert np.array_equal(link[0], made.start[k]) and np.array_equal(link[-1], made.start[k + 1])
        fine = along(link, 200)
        assert distance_to(elements, fine).min() >= r + probe.stock + c / 2 - 1e-9
        assert shapely.LineString(link).distance(inside.exterior) > r if not hollow else True
        if hollow:
            assert inside.contains(shapely.LineString(link))
        else:
            assert not inside.intersects(shapely.LineString(link))


@settings(max_examples=examples(60), deadline=None)
@given(
    part=parts(cutter=4.0),
    count=st.integers(1, 60),
    by_curvature=st.booleans(),
    touch=st.sampled_from(["auto", "axis", "normal"]),
    radius=st.sampled_from([0.5, 1.5, 3.0]),
    stock=st.sampled_from([0.0, 0.4]),
)
def test_every_plan_keeps_its_promises(
    part: Part, count: int, by_curvature: bool, touch: str, radius: float, stock: float
) -> None:
    probe = TouchProbe(radius, stock=stock, touch=touch)
    hollow = float(part.profile.signed_areas()[0]) < 0
    try:
        made = plan(part.profile, Placement(count=count, by_curvature=by_curvature), probe)
    except RefusedError as error:
        assert "can be touched" in str(error)
        return
    assert 1 <= len(made) <= count and len(made.links) == len(made) - 1
    check(made, part.elements, polygon(part), hollow)
    # Corners are kept clear of by the ball and its margin.
    sharp = part.vertices[[r == 0 for r in part.radii]]
    if len(sharp):
        gap = np.hypot(*(made.contact[:, None] - sharp[None]).transpose(2, 0, 1))
        # Along the contour; past a fillet the straight way is shorter.
        assert gap.min() > radius * 0.99


@settings(max_examples=examples(15), deadline=None)
@given(poles=spline_poles(), touch=st.sampled_from(["auto", "normal"]))
def test_plans_on_splines(poles: np.ndarray, touch: str) -> None:
    profile = Profile.from_contours([Contour((closed_spline(poles),), True)])
    made = plan(profile, Placement(count=40, by_curvature=True), TouchProbe(1.0, touch=touch))
    search = FootPointSearch(profile, margin=10.0)
    feet = search.find(made.centre)
    assert np.abs(feet.distance - 1.0).max() < 2e-3
    assert np.hypot(*(feet.foot - made.contact).T).max() < 0.1
    assert (search.find(made.start).distance >= 2.0 - 1e-9).all()
    for link in made.links:
        if link is not None:
            assert search.find(along(link, 50)).distance.min() >= 2.0 - 1e-9


def test_ball_larger_than_the_hollow_is_left_out() -> None:
    with pytest.raises(RefusedError, match="can be touched"):
        plan(ring(2.0, hollow=True), Placement(count=4), TouchProbe(2.5, clearance=0.1))
    assert len(plan(ring(8.0, hollow=True), Placement(count=4), BALL)) == 4


def test_fillets_smaller_than_the_ball_are_left_out() -> None:
    made = plan(pocket(60, 40, 2.0).profile, Placement(spacing=0.5), BALL)
    reasons = {left.reason for left in made.left_out}
    assert any("too hollow" in r or "no room" in r for r in reasons)
    # No contact within a fillet, nor where the ball would touch the wall beside it.
    away = np.minimum(made.contact, np.array([60.0, 40.0]) - made.contact).max(axis=1)
    assert away.min() >= BALL.ball_radius


def test_acute_inner_corners_keep_the_margin() -> None:
    """In a corner of 60 degrees a ball touches both walls r / tan 30 deg away; a point nearer, or little farther."""
    height = 80.0 * np.sqrt(3) / 2
    triangle = Part(np.array([[0.0, 0.0], [40.0, height], [80.0, 0.0]]), (0.0,) * 3)
    probe = TouchProbe(2.5, margin=1.0, touch="normal")
    made = plan(triangle.profile, Placement(spacing=0.2), probe)
    walls = np.sort([e.distance(made.centre) for e in triangle.elements], axis=0)
    assert np.allclose(walls[0], 2.5)
    assert walls[1].min() >= 2.5 + 0.5 - 1e-9
    refused = [left for left in made.left_out if "another wall is too near" in left.reason]
    # Both walls touched at r / tan 30 deg = 4.33 mm from a corner; places nearer than that are kept off by 3.5 mm.
    gaps = [np.hypot(*(np.array([left.x, left.y]) - triangle.vertices).T).min() for left in refused]
    assert max(gaps) > 2.5 / np.tan(np.radians(30.0)) + 0.2


def test_a_post_before_the_wall_is_not_reached_over() -> None:
    """A post 0.4 mm thin, 3 mm off the wall: behind it there is room to start, but the ball would meet the post."""
    wall, post = rectangle(60, 40), rectangle(50, 0.4)
    both = [wall.profile.contours[0], _moved(post, 5.0, -3.4)]
    made = plan(Profile.from_contours(both), Placement(count=60), TouchProbe(0.5, margin=0.1))
    in_front = (np.abs(made.contact[:, 1]) < 1e-9) & (made.contact[:, 0] > 5) & (made.contact[:, 0] < 55)
    assert len(made) > 20 and not in_front.any()
    assert any("in the way" in left.reason for left in made.left_out)


def test_narrow_slots_and_free_width() -> None:
    # A ball of 5 mm, 2 mm to back off and 1 mm to the wall behind make 8 mm.
    with pytest.raises(RefusedError, match="no room"):
        plan(pocket(60, 7.9).profile, Placement(count=6), BALL)
    assert len(plan(pocket(60, 8.1).profile, Placement(count=6), BALL)) > 0
    block = rectangle(60, 40).profile
    # 2 mm clearance and the ball's 5 mm need 7 mm of free space.
    assert len(plan(block, Placement(count=6), TouchProbe(2.5, free_width=7.01))) == 6
    with pytest.raises(RefusedError, match="no room"):
        plan(block, Placement(count=6), TouchProbe(2.5, free_width=6.9))


def test_ways_lead_round_a_corner_and_over_what_is_in_the_way() -> None:
    made = plan(rectangle(60, 40).profile, Placement(count=4), BALL)
    assert [len(link) if link is not None else 0 for link in made.links].count(0) == 0
    assert max(len(link) for link in made.links if link is not None) > 3
    slim = plan(rectangle(60, 40).profile, Placement(count=4), TouchProbe(2.5, free_width=7.01))
    # No room to swing round the corners on the chords: over the safe height.
    assert all(link is None for link in slim.links)
    contours = [rectangle(60, 40).profile.contours[0], _moved(pocket(30, 20), 15.0, 10.0)]
    apart_profile = Profile.from_contours(contours)
    apart = plan(apart_profile, Placement(count=12), BALL)
    crossing = np.flatnonzero(np.diff(apart.contour))
    only = plan(apart_profile, Placement(count=7, contour=2), TouchProbe(1.5))
    assert len(only) + len(only.left_out) == 7 and len(only) > 4 and (only.contour == 1).all()
    with pytest.raises(UsageError, match="2 contours"):
        plan(apart_profile, Placement(count=5, contour=3), BALL)
    assert len(crossing) == 1 and apart.links[crossing[0]] is None


def _moved(part: Part, x: float, y: float) -> Contour:
    return Part(part.vertices + np.array([x, y]), part.radii).profile.contours[0]


@pytest.mark.parametrize("cutter", [2.0, 6.0, 14.0])
def test_distance_from_fillets_in_a_rectangular_pocket(cutter: float) -> None:
    """In a square corner the bound is the distance from the filleted pocket, closed form."""
    search = FootPointSearch(pocket(60, 40).profile)
    points = np.random.default_rng(5).uniform([0.1, 0.1], [59.9, 39.9], (400, 2))
    found = np.minimum(search.find(points).distance, into_fillets(search, points, cutter))
    filleted = pocket(60, 40, cutter)
    inside = shapely.contains_xy(polygon(filleted), points[:, 0], points[:, 1])
    exact = np.where(inside, 1.0, -1.0) * distance_to(filleted.elements, points)
    deep = cutter - np.hypot(*(np.minimum(points, np.array([60.0, 40.0]) - points) - cutter).T)
    corner = (np.minimum(points, np.array([60.0, 40.0]) - points) < cutter).all(axis=1)
    assert np.allclose(found[corner], deep[corner], atol=1e-6)
    assert np.allclose(found[~corner], exact[~corner], atol=1e-6)
    assert np.isinf(into_fillets(search, points, 0.0)).all()


def test_ways_keep_clear_of_fillets() -> None:
    search = FootPointSearch(pocket(60, 40).profile)
    way = np.array([[4.5, 20.0], [4.5, 4.5], [20.0, 4.5]])
    assert clear(Space(search, 0.0), [way], 3.5, np.inf) == [True]
    # Cutter of 14 mm radius: the ball's centre at (4.5, 4.5) has 14 - 9.5 * sqrt(2) = 0.565 mm.
    assert clear(Space(search, 14.0), [way], 3.5, np.inf) == [False]
    assert clear(Space(search, 14.0), [way[:1] + [[0.0, 0.0], [0.0, 5.0]]], 3.5, np.inf) == [True]


@pytest.mark.parametrize("spacing", [2.0, slow(0.5)])
def test_starts_keep_clear_of_fillets(spacing: float) -> None:
    """Corners that are not square, with fillets of a cutter of 14 mm radius."""
    corners = np.array([[0.0, 0.0], [20.0, 40.0], [70.0, 40.0], [60.0, 0.0]])
    sharp = Part(corners, (0.0,) * 4)
    filleted = Part(corners, (14.0,) * 4)
    for touch in ("axis", "normal"):
        made = plan(sharp.profile, Placement(spacing=spacing), TouchProbe(2.5, touch=touch, clearance=4.0), 14.0)
        inside = shapely.contains_xy(polygon(filleted), made.start[:, 0], made.start[:, 1])
        assert inside.all() and distance_to(filleted.elements, made.start).min() >= 2.5 + 2.0 - 1e-4


def test_open_contours_keep_from_their_ends() -> None:
    profile = Profile.from_contours([Contour((polyline(np.array([[0.0, 0.0], [50.0, 0.0]])),), False)])
    made = plan(profile, Placement(count=5), BALL)
    assert np.allclose(made.direction, [0.0, 1.0]) and np.allclose(made.normal, [0.0, -1.0])
    assert made.contact[:, 0].min() >= 3.0 and made.contact[:, 0].max() <= 47.0


@pytest.mark.parametrize(
    "values",
    [
        {"ball_radius": 0.0}, {"ball_radius": float("nan")}, {"clearance": 0.0}, {"overtravel": 0.0},
        {"stock": -0.1}, {"free_width": 5.0}, {"touch": "up"}, {"ball_radius": float("inf")},
    ],
)  # fmt: skip
def test_impossible_probes_are_refused(values: dict[str, object]) -> None:
    with pytest.raises(UsageError, match="--"):
        TouchProbe(**{"ball_radius": 2.5, **values})  # type: ignore[arg-type]


def test_an_impossible_margin_is_refused() -> None:
    """It is no option of the command line."""
    with pytest.raises(UsageError, match="the margin -1 at corners"):
        TouchProbe(ball_radius=1.0, margin=-1.0)


@pytest.mark.parametrize(
    "values", [{}, {"count": 5, "spacing": 1.0}, {"count": 0}, {"spacing": 0.0}, {"spacing": float("nan")}]
)
def test_impossible_placements_are_refused(values: dict[str, float]) -> None:
    with pytest.raises(UsageError, match="--"):
        Placement(**values)  # type: ignore[arg-type]


def test_too_many_points_are_refused() -> None:
    with pytest.raises(UsageError, match="more than"):
        plan(ring(30.0), Placement(spacing=1e-4), BALL)


def test_touches_one_by_one() -> None:
    made = plan(ring(30.0), Placement(count=8), BALL)
    touches = list(made.touches())
    assert [t.number for t in touches] == list(range(1, 9))
    assert np.array_equal([t.start for t in touches], made.start)
    assert np.array_equal([t.centre for t in touches], made.centre)
    assert {t.axis for t in touches} <= {"X", "Y"}
    slanting = list(plan(ring(30.0), Placement(count=4), BALL).touches())
    assert all(t.axis == "" for t in slanting)
    with pytest.raises(ValueError, match="read-only"):
        made.contact[0] = 0.0
