# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour a program cuts: the part from which its path was made in closed form comes back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from millcorr.comparison.theoretical_contour import CutContour, closed_loops, cut_contours, cutting_runs, path_profile
from millcorr.errors import InputError
from millcorr.geometry.profile import Contour, Profile
from millcorr.nc.toolpath import Compensation, Toolpath
from tests.core.contours import (
    Element,
    Part,
    Path,
    distance_to,
    facetted_circle,
    filleted,
    moved_sides,
    parts,
    pocket,
    polyline,
    rectangle,
    reversed_elements,
    started_at,
)
from tests.core.sweeps import examples

R = 5.0
EXACT = 1e-9


def samples(contour: Contour, count: int = 13) -> np.ndarray:
    return np.vstack([c.evaluate(np.linspace(c.knots[0], c.knots[-1], count)) for c in contour.curves])


def check_same(found: Contour, elements: list[Element], closed: bool = True, within: float = EXACT) -> None:
    """The found contour is the row of elements: on it everywhere, as long, the same way round."""
    assert found.closed == closed
    assert distance_to(elements, samples(found)).max() < within
    profile = Profile.from_contours([found])
    # A length differs by no more than its ends can move.
    assert abs(profile.total[0] - sum(e.length for e in elements)) < within * 4 * len(elements)
    if closed:
        want = Profile.from_contours([Contour(tuple(e.curve() for e in elements), True)]).signed_areas()[0]
        assert abs(profile.signed_areas()[0] - want) < within * profile.total[0]


def only(toolpath: Toolpath, radius: float = R, material_right: bool = False) -> CutContour:
    found = [one for one in cut_contours(toolpath, radius, material_right) if not one.aside]
    assert len(found) == 1
    return found[0]


def path_for(elements: list[Element], **start: float) -> Path:
    x, y = elements[0].p0
    return Path(here=(float(x), float(y), 0.0), **start).along(elements)


@settings(max_examples=examples(120), deadline=None, derandomize=True)
@given(
    part=parts(cutter=R),
    mitre=st.booleans(),
    climb=st.booleans(),
    index=st.integers(0, 12),
    fraction=st.sampled_from([0.0, 0.0, 0.37, 0.5, 0.999]),
)
def test_part_comes_back(part, mitre, climb, index, fraction):
    elements = part.path(R, mitre)
    if climb:
        elements = reversed_elements(elements)
    elements = started_at(elements, index, fraction)
    toolpath = path_for(elements).toolpath()
    found = only(toolpath, R, climb)
    check_same(found.contour, part.elements)
    np.testing.assert_array_equal(found.rows, np.arange(len(toolpath)))


@settings(max_examples=examples(80), deadline=None, derandomize=True)
@given(part=parts(cutter=R), mitre=st.booleans(), decimals=st.sampled_from([3, 4]))
def test_rounded_programs_come_back_to_their_rounding(part, mitre, decimals):
    """Programs round every number, so tangents are broken by micrometres over short moves."""
    rounded = []
    for e in part.path(R, mitre):
        p0, p1 = np.round(e.p0, decimals), np.round(e.p1, decimals)
        centre, sweep = None, 0.0
        if e.centre is not None:
            centre = p0 + np.round(e.centre - e.p0, decimals)
            a, b = p0 - centre, p1 - centre
            sweep = float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))
            assume(abs(sweep - e.sweep) < 0.01)
        rounded.append(Element(p0, p1, centre, sweep))
    found = only(path_for(rounded).toolpath())
    # A corner of the path moves by half a unit in x and y; a short line turns by a unit over its length and
    # carries that to its offset, where two sides meet under at least 0.25 rad.
    unit = 10.0**-decimals
    shortest = min(e.length for e in rounded)
    allowed = 1.5 * unit * (1 + R / shortest) / np.sin(0.125)
    assert distance_to(part.elements, samples(found.contour)).max() < allowed
    profile = Profile.from_contours([found.contour])
    corners = np.array([e.p0 for e in part.elements])
    from millcorr.geometry.footpoint import FootPointSearch

    assert np.abs(FootPointSearch(profile).find(corners).distance).max() < allowed


@pytest.mark.parametrize("sweep", [2 * np.pi, -2 * np.pi])
@pytest.mark.parametrize("material_right", [False, True])
def test_full_circle(sweep, material_right):
    toolpath = Path(here=(20.0, 0.0, 0.0)).arc((20.0, 0.0), (0.0, 0.0), sweep).toolpath()
    found = only(toolpath, R, material_right)
    # Anticlockwise with the material on the left, or clockwise with it on the right, is a boss.
    boss = (sweep > 0) != material_right
    p = np.array([15.0 if boss else 25.0, 0.0])
    check_same(found.contour, [Element(p, p, np.zeros(2), 2 * np.pi if boss else -2 * np.pi)])


def test_circle_of_two_halves_and_many_lines():
    v = facetted_circle(30.0, 2000)
    moved = moved_sides(v, R)
    toolpath = path_for(filleted(moved, (0.0,) * 2000)).toolpath()
    found = only(toolpath)
    check_same(found.contour, filleted(v, (0.0,) * 2000))
    assert len(found.contour.curves) == 1


LEADS = ["line", "arc", "perpendicular", "same point"]


@pytest.mark.parametrize("lead", LEADS)
@pytest.mark.parametrize("start", ["corner", "mid-line", "mid-arc"])
@pytest.mark.parametrize("material_right", [False, True])
def test_leads_are_no_part_of_the_contour(lead, start, material_right):
    part = Part(rectangle(60.0, 40.0).vertices, (0.0, 6.0, 0.0, 6.0))
    elements = part.path(R, True)
    if material_right:
        elements = reversed_elements(elements)
    arc = next(i for i, e in enumerate(elements) if e.centre is not None)
    index, fraction = {"corner": (0, 0.0), "mid-line": (0, 0.4), "mid-arc": (arc, 0.5)}[start]
    if start == "corner":
        index = next(i for i, e in enumerate(elements) if np.hypot(*(e.p0 - part.path(R, True)[0].p0)) < 1e-9)
    elements = started_at(elements, index, fraction)
    e = elements[0]
    p0 = e.p0
    ahead = e.at(np.array([1e-7]))[0] - p0
    t = ahead / np.hypot(*ahead)
    # Away from the part: to the right where the material is left.
    out = np.array([t[1], -t[0]]) * (-1 if material_right else 1)
    p = Path()
    if lead == "line":
        begin, finish = p0 - 7 * t + 2 * out, p0 + 7 * t + 2 * out
        p.rapid(*begin).plunge(-5.0).line(*p0).along(elements).line(*finish)
    elif lead == "arc":
        centre = p0 + 3 * out
        turn = np.pi / 2 * (1 if material_right else -1)
        p.rapid(*(centre - 3 * t)).plunge(-5.0).arc(p0, centre, turn).along(elements).arc(centre + 3 * t, centre, turn)
    elif lead == "perpendicular":
        p.rapid(*(p0 + 9 * out)).plunge(-5.0).line(*p0).along(elements).line(*(p0 + 9 * out))
    else:
        p.rapid(*(p0 + 4 * out - 6 * t)).plunge(-5.0).line(*(p0 + 4 * out)).line(*p0).along(elements)
        p.line(*(p0 + 4 * out)).line(*(p0 + 4 * out - 6 * t))
    found = only(p.toolpath(), R, material_right)
    check_same(found.contour, part.elements)


def test_leads_that_cross_each_other():
    part = rectangle(60.0, 40.0, 8.0)
    elements = started_at(part.path(R, False), 0, 0.5)
    x, y = elements[0].p0
    p = Path().rapid(x + 8, y - 8).plunge(-5).line(x, y).along(elements).line(x - 8, y - 8)
    check_same(only(p.toolpath()).contour, part.elements)


def test_lead_that_runs_over_the_start():
    part = rectangle(60.0, 40.0, 8.0)
    elements = started_at(part.path(R, False), 0, 0.5)
    x, y = elements[0].p0
    p = Path().rapid(x, y - 8).plunge(-5).line(x, y).along(elements).line(x + 4, y).line(x + 4, y - 8)
    check_same(only(p.toolpath()).contour, part.elements)


@pytest.mark.parametrize("link", ["plunge", "lift", "helix"])
def test_passes_at_several_depths(link):
    part = Part(rectangle(60.0, 40.0).vertices, (0.0, 6.0, 0.0, 6.0))
    elements = started_at(part.path(R, False), 0, 0.25)
    x, y = elements[0].p0
    p = Path().rapid(x, y - 9, 5.0).plunge(0.0).line(x, y)
    for k in range(3):
        if link == "plunge":
            p.plunge(-1.0 - k).along(elements)
        elif link == "lift":
            p.plunge(-1.0 - k).along(elements).rapid(x, y, 5.0)
        else:
            p.along(elements, depth=1.0)
    if link == "helix":
        p.along(elements)
    # A lead with a plunge behind it is a run of its own; it is open.
    found = [f for f in cut_contours(p.toolpath(), R, False) if f.closed]
    assert len(found) == (4 if link == "helix" else 3)
    for one in found:
        check_same(one.contour, part.elements)
    rows = np.concatenate([f.rows for f in found])
    assert len(np.unique(rows)) == len(rows)


def test_contours_linked_by_a_feed_move_and_a_roughing_pass_beside():
    a, b = rectangle(60.0, 40.0, 6.0), Part(rectangle(30.0, 20.0).vertices + [100.0, 0.0], (0.0,) * 4)
    first, second = a.path(R, False), b.path(R, True)
    rough = a.path(R + 0.3, False)
    p = Path(here=(*rough[0].p0, 0.0)).along(rough).line(*first[0].p0).along(first).line(*second[0].p0).along(second)
    found = [one for one in cut_contours(p.toolpath(), R, False) if not one.aside]
    assert len(found) == 3
    check_same(found[1].contour, a.elements)
    check_same(found[2].contour, b.elements)
    grown = filleted(moved_sides(a.vertices, 0.3), (6.3,) * 4)
    check_same(found[0].contour, grown)


@pytest.mark.parametrize("material_right", [False, True])
def test_open_contour(material_right):
    """Line, tangent arcs both ways, line; path by hand."""
    part = [
        Element(np.array([0.0, 0.0]), np.array([20.0, 0.0])),
        Element(np.array([20.0, 0.0]), np.array([30.0, 10.0]), np.array([20.0, 10.0]), np.pi / 2),
        Element(np.array([30.0, 10.0]), np.array([42.0, 22.0]), np.array([42.0, 10.0]), -np.pi / 2),
        Element(np.array([42.0, 22.0]), np.array([70.0, 22.0])),
    ]
    path = [
        Element(np.array([0.0, -5.0]), np.array([20.0, -5.0])),
        Element(np.array([20.0, -5.0]), np.array([35.0, 10.0]), np.array([20.0, 10.0]), np.pi / 2),
        Element(np.array([35.0, 10.0]), np.array([42.0, 17.0]), np.array([42.0, 10.0]), -np.pi / 2),
        Element(np.array([42.0, 17.0]), np.array([70.0, 17.0])),
    ]
    if material_right:
        path = reversed_elements(path)
    found = only(path_for(path).toolpath(), R, material_right)
    check_same(found.contour, part, closed=False)
    ends = samples(found.contour)[[0, -1]]
    np.testing.assert_allclose(ends, [[0, 0], [70, 22]], atol=EXACT)


@pytest.mark.parametrize(("mode", "right"), [(Compensation.LEFT, True), (Compensation.RIGHT, False)])
def test_compensated_by_the_control_programs_the_contour_itself(mode, right):
    part = rectangle(60.0, 40.0, 6.0)
    elements = started_at(part.elements, 0, 0.5)
    if right:
        elements = reversed_elements(elements)
    x, y = elements[0].p0
    p = Path(here=(x, y - 20, 0.0))
    p.compensation = int(mode)
    p.line(x, y).along(elements)
    p.compensation = 0
    p.line(x, y - 20)
    t = p.toolpath()
    found = list(cut_contours(t, 0.0, right, t.compensation != Compensation.OFF))
    assert len(found) == 1
    check_same(found[0].contour, part.elements)


def test_open_contour_of_the_control_leaves_the_starting_move_out():
    p = Path(here=(-10.0, -10.0, 0.0))
    p.compensation = int(Compensation.RIGHT)
    p.line(0, 0).line(30, 0).line(30, 30)
    found = only(p.toolpath(), 0.0, False)
    points = [np.array(v, dtype=float) for v in ([0, 0], [30, 0], [30, 30])]
    check_same(found.contour, [Element(points[0], points[1]), Element(points[1], points[2])], closed=False)


def test_splines_under_compensation_stay_exact():
    p = Path(here=(0.0, 0.0, 0.0))
    p._add(3, (30.0, 10.0), None, control=(10.0, 20.0, 20.0, -10.0))
    for right in (False, True):
        found = only(p.toolpath(), 0.0, right)
        u = np.linspace(0, 1, 4001)[:, None]
        q = [np.array(v, dtype=float) for v in ([0, 0], [10, 20], [20, -10], [30, 10])]
        exact = q[0] * (1 - u) ** 3 + 3 * q[1] * u * (1 - u) ** 2 + 3 * q[2] * u**2 * (1 - u) + q[3] * u**3
        from millcorr.geometry.footpoint import FootPointSearch

        feet = FootPointSearch(Profile.from_contours([found.contour])).find(exact[1:-1])
        assert np.abs(feet.distance).max() < EXACT
        np.testing.assert_allclose(samples(found.contour)[0], exact[-1] if right else exact[0], atol=EXACT)


def test_a_spline_leaves_what_its_chords_leave():
    """The parallel of a spline is none; the contour lies a radius from the exact curve all the same."""
    p = Path(here=(0.0, 0.0, 0.0))
    p._add(3, (30.0, 10.0), None, control=(10.0, 20.0, 20.0, -10.0))
    found, toolpath = only(p.toolpath()), p.toolpath()
    exact = toolpath.position(np.linspace(0.0, 1.0, 200_001))[0, :, :2]
    away = cKDTree(exact).query(samples(found.contour))[0]
    assert np.abs(away - R).max() < 1e-3


def test_loop_closes_within_the_rounding_of_a_program():
    """A closing gap below the smallest step that counts, wherever it lies on the grid."""
    part = rectangle(60.0, 40.0, 6.0)
    for shift in np.linspace(0.0, 2e-4, 17):
        elements = [
            Element(e.p0 + shift, e.p1 + shift, None if e.centre is None else e.centre + shift, e.sweep)
            for e in started_at(part.path(R, False), 0, 0.5)
        ]
        p = path_for(elements)
        last = p.rows[-1]["end"]
        p.rows[-1]["end"] = (last[0], last[1] + 1e-4, last[2])
        assert closed_loops(p.toolpath(), np.arange(len(p.rows))) == [(0, len(p.rows))]


def test_a_turn_tighter_than_the_cutter_leaves_a_sharp_corner():
    """The path turns left with 3 mm, the part lies left: a cutter of 5 mm takes the sides to where they meet."""
    p = Path(here=(0.0, 0.0, 0.0)).line(30, 0).arc((33, 3), (30, 3), np.pi / 2).line(33, 30).line(0, 30).line(0, 0)
    corners = samples(only(p.toolpath()).contour)
    assert np.hypot(*(corners - [28.0, 5.0]).T).min() < 1e-9
    assert corners.max() == pytest.approx(28.0, abs=1e-9)
    # To the right it is a fillet of 8 mm.
    check_same(
        only(p.toolpath(), R, True).contour,
        reversed_elements(
            [
                Element(np.array([0.0, -5.0]), np.array([30.0, -5.0])),
                Element(np.array([30.0, -5.0]), np.array([38.0, 3.0]), np.array([30.0, 3.0]), np.pi / 2),
                Element(np.array([38.0, 3.0]), np.array([38.0, 35.0])),
                Element(np.array([38.0, 35.0]), np.array([-5.0, 35.0])),
                Element(np.array([-5.0, 35.0]), np.array([-5.0, -5.0])),
                Element(np.array([-5.0, -5.0]), np.array([0.0, -5.0])),
            ]
        ),
    )


def test_side_too_short_for_the_cutter_is_refused():
    """The path leaves 6 mm where the part would need more than the cutter's 10."""
    p = Path(here=(0.0, 0.0, 0.0)).line(60, 0).line(60, 40).line(54, 40).line(54, 50).line(0, 50).line(0, 0)
    only(p.toolpath())
    p = Path(here=(0.0, 0.0, 0.0)).line(60, 0).line(60, 6).line(0, 6).line(0, 0)
    with pytest.raises(InputError, match="there is no contour; check --tool-diameter"):
        only(p.toolpath())


@pytest.mark.parametrize("material_right", [False, True])
def test_path_that_retraces_itself_leaves_a_slot(material_right):
    """Out and back on one line: no loop; both walls and the round end of the slot remain."""
    p = Path(here=(0.0, 0.0, 0.0)).line(30, 20).line(0, 0)
    assert closed_loops(p.toolpath(), np.arange(2)) == []
    found = only(p.toolpath(), R, material_right)
    tip, t = np.array([30.0, 20.0]), np.array([30.0, 20.0]) / np.hypot(30, 20)
    side = R * np.array([t[1], -t[0]])
    wall = [
        Element(-side, tip - side),
        Element(tip - side, tip + side, tip, -np.pi),
        Element(tip + side, side),
    ]
    check_same(found.contour, wall if not material_right else wall, closed=False)


LENS = [
    # Two arcs of radius 25 through (-20, 0) and (20, 0): centres at (0, 15) and (0, -15).
    Element(np.array([-20.0, 0.0]), np.array([20.0, 0.0]), np.array([0.0, 15.0]), 2 * np.arctan2(20, 15)),
    Element(np.array([20.0, 0.0]), np.array([-20.0, 0.0]), np.array([0.0, -15.0]), 2 * np.arctan2(20, 15)),
]


@pytest.mark.parametrize("mitre", [False, True])
def test_corners_between_arcs(mitre):
    if mitre:
        # Circles of radius 30 about the same centres meet at x = +-sqrt(30^2 - 15^2).
        x = np.sqrt(675.0)
        a, b = np.array([-x, 0.0]), np.array([x, 0.0])
        sweep = 2 * np.arctan2(x, 15)
        path = [Element(a, b, np.array([0.0, 15.0]), sweep), Element(b, a, np.array([0.0, -15.0]), sweep)]
    else:
        path = []
        for e, corner in zip(LENS, (LENS[0].p1, LENS[1].p1), strict=True):
            p0, p1 = (e.centre + 1.2 * (p - e.centre) for p in (e.p0, e.p1))
            path.append(Element(p0, p1, e.centre, e.sweep))
            other = LENS[1].centre if e is LENS[0] else LENS[0].centre
            turn = np.pi - e.sweep
            path.append(Element(p1, other + 1.2 * (corner - other), corner, turn))
    check_same(only(path_for(path).toolpath()).contour, LENS)


def test_concave_corner_between_arcs():
    """The lens as a pocket: the path turns before the corner, the contour goes into it."""
    inside = reversed_elements(LENS)
    x = np.sqrt(400.0 - 225.0)
    a, b = np.array([-x, 0.0]), np.array([x, 0.0])
    sweep = 2 * np.arctan2(x, 15)
    path = [Element(b, a, np.array([0.0, 15.0]), -sweep), Element(a, b, np.array([0.0, -15.0]), -sweep)]
    check_same(only(path_for(path).toolpath()).contour, inside)


def test_concave_corner_goes_to_the_corner_of_the_drawing():
    part = pocket(60.0, 40.0)
    check_same(only(path_for(part.path(R, False)).toolpath()).contour, part.elements)


def test_runs_end_at_rapids_plunges_and_changes_of_compensation():
    p = Path().line(1, 0).line(2, 0).plunge(-1).line(3, 0).rapid(5, 0).line(6, 0)
    p.compensation = 1
    p.line(7, 0).line(8, 0)
    assert [r.tolist() for r in cutting_runs(p.toolpath())] == [[0, 1], [3], [5], [6, 7]]
    assert cutting_runs(Path().rapid(1, 1).toolpath()) == []


def test_only_chosen_rows():
    part = rectangle(60.0, 40.0, 6.0)
    elements = part.path(R, False)
    p = path_for(elements).line(200, 0)
    rows = np.ones(len(p.rows), dtype=bool)
    rows[-1] = False
    found = list(cut_contours(p.toolpath(), R, False, rows))
    assert len(found) == 1
    check_same(found[0].contour, part.elements)
    rows[:] = False
    assert list(cut_contours(p.toolpath(), R, False, rows)) == []


def test_path_profile_is_the_path():
    elements = rectangle(60.0, 40.0, 6.0).path(R, False)
    t = path_for(elements).toolpath()
    for right in (False, True):
        contour = path_profile(t, np.arange(len(t)), right).contours[0]
        check_same(contour, reversed_elements(elements) if right else elements)


def test_many_vertices_do_not_cost_their_square():
    import time

    v = facetted_circle(30.0, 20_000)
    moved = moved_sides(v, R)
    p = Path(here=(*moved[0], 0.0))
    for _ in range(3):
        for x, y in np.vstack([moved[1:], moved[:1]]):
            p.line(x, y)
    t = p.toolpath()
    begin = time.process_time()
    loops = closed_loops(t, np.arange(len(t)))
    assert time.process_time() - begin < 5.0
    assert loops == [(0, 20_000), (20_000, 40_000), (40_000, 60_000)]


def test_polyline_has_one_curve_for_facets_and_one_per_side_for_corners():
    found = only(path_for(rectangle(60.0, 40.0).path(R, True)).toolpath())
    assert len(found.contour.curves) == 4
    assert polyline(np.array([[0.0, 0.0], [1.0, 0.0]])).degree == 1


def test_sharp_spike_with_its_whole_mitre():
    part = Part(np.array([[0.0, 0.0], [60.0, 0.0], [60.0, 8.0]]), (0.0,) * 3)
    check_same(only(path_for(part.path(R, True)).toolpath()).contour, part.elements, within=1e-8)


def test_a_loop_that_leaves_nothing_hides_no_contour() -> None:
    """An arc and its chord on the way onto a lap: inside of them no cutter leaves anything."""
    path = Path((20.0, 30.0, 0.0)).arc((19.0, 30.0), (19.5, 30.0), np.pi).line(20.0, 30.0)
    for x, y in ((-20.0, 30.0), (-20.0, -30.0), (20.0, -30.0), (20.0, 30.0)):
        path.line(x, y)
    left = [c.contour for c in cut_contours(path.toolpath(), R, False) if c.closed]
    assert [abs(Profile.from_contours([c]).signed_areas()[0]) for c in left] == pytest.approx([30.0 * 50.0])
    with pytest.raises(InputError):
        list(cut_contours(path.toolpath().take(np.arange(2)), R, False))


@pytest.mark.few(2)
@pytest.mark.parametrize("decimals", [3, 4])
@pytest.mark.parametrize("seed", range(8))
def test_facets_whose_rounding_makes_them_parallel(seed: int, decimals: int) -> None:
    """What vanishes between two parallel facets leaves no gap: the circle comes back to the rounding."""
    rng = np.random.default_rng(seed)
    size, steps = 9.0 + R, rng.uniform(0.005, 0.02, 20_000)
    angle = np.cumsum(steps) / size
    angle = np.append(angle[angle < 2 * np.pi - 0.005 / size], 2 * np.pi)
    xy = np.round(size * np.stack([np.cos(angle), np.sin(angle)], axis=1), decimals)
    path = Path((size, 0.0, 0.0))
    for x, y in xy:
        path.line(x, y)
    found = list(cut_contours(path.toolpath(), R, False, resolution=10.0**-decimals / np.sqrt(2)))
    closed = [c for c in found if c.closed]
    assert len(closed) == 1
    off = np.hypot(*samples(closed[0].contour).T) - 9.0
    assert np.abs(off).max() < 3.0 * 10.0**-decimals


@settings(max_examples=examples(60), deadline=None)
@given(
    steps=st.lists(
        st.tuples(st.floats(0.3, 0.7 * R), st.sampled_from([1.0, -1.0]), st.floats(-0.05, 0.05)), min_size=1, max_size=4
    ),
    tread=st.floats(4 * R, 8 * R),
    right=st.booleans(),
)
def test_steps_lower_than_the_cutter_are_in_the_drawing(steps, tread, right):
    """Only a fillet of the cutter is left of a step's wall: the walls beside it, nearly parallel, never meet there."""
    x, y, drawing = 0.0, 0.0, [(0.0, 0.0)]
    for height, way, lean in steps:
        x += tread
        drawing.append((x, y))
        x, y = x + lean, y + way * height
        drawing.append((x, y))
    drawing = np.array([*drawing, (x + tread, y)])
    if right:
        drawing[:, 1] *= -1
    side = -1.0 if right else 1.0
    ahead = np.diff(drawing, axis=0)
    ahead /= np.hypot(*ahead.T)[:, None]
    out = side * np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    turn = out[:-1] + out[1:]
    places = drawing.copy()
    places[[0, -1]] += R * out[[0, -1]]
    places[1:-1] += 2 * R * turn / (turn**2).sum(axis=1)[:, None]
    path = Path().rapid(*places[0]).plunge(-1.0)
    for place in places[1:]:
        path.line(*place)
    found = only(path.toolpath(), R, right)
    corners = np.array([curve.poles[0] for curve in found.contour.curves] + [found.contour.curves[-1].poles[-1]])
    np.testing.assert_allclose(corners, drawing[::-1] if right else drawing, rtol=0, atol=1e-9)
