# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations are drawn so much larger that they are seen, and never so much that a contour is turned inside out."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.errors import UsageError
from millcorr.report.magnification import GREATEST, KEPT, bound_of, checked, magnification_for
from millcorr.report.picture.parallel import index_of, unfolded
from tests.core.contours import distance_to, parts, pocket, rectangle
from tests.core.sweeps import examples

HERE = np.zeros(1, dtype=np.int64)


def walked(profile, spacing=0.25):
    """Spans, points and normals along a profile, and how far along it they lie."""
    span, t = profile.samples(spacing)
    point, _, _ = profile.evaluate(span, t)
    return span, point, profile.normals(span, t), profile.arc_length(span, t)


def turns(points, centre):
    """How often a closed row of points goes round a place."""
    closed = np.concatenate([points, points[:1]]) - centre
    angle = np.unwrap(np.arctan2(closed[:, 1], closed[:, 0]))
    return (angle[-1] - angle[0]) / (2 * np.pi)


@settings(deadline=None)
@given(
    width=st.floats(4.0, 200.0),
    height=st.floats(4.0, 200.0),
    material_outside=st.booleans(),
    mean=st.floats(-1.0, 1.0),
    waves=st.integers(0, 9),
    size=st.floats(1e-3, 1.0),
)
def test_at_the_bound_a_contour_still_goes_round_its_middle(width, height, material_outside, mean, waves, size):
    part = (pocket if material_outside else rectangle)(width, height)
    profile = part.profile
    span, point, normal, s = walked(profile)
    off = size * (mean + np.cos(2 * np.pi * waves * s / profile.total[0]))
    bound = bound_of(profile, [(profile.contour[span], off)])
    moved = point + bound * off[:, None] * normal
    # Corners make the row of points jump from one side's end to the next one's start: beside the middle, not over it.
    way = np.concatenate([np.linspace(a, b, 20) for a, b in zip(moved, np.roll(moved, -1, axis=0), strict=True)])
    assert turns(way, [width / 2, height / 2]) == pytest.approx(-1.0 if material_outside else 1.0)
    # It is no caution for its own sake: a quarter more may reach the middle, or leave the part by its size.
    inward, room = (off if material_outside else -off).max(), min(width, height) / 2
    allowed = min(KEPT * room / inward if inward > 0 else GREATEST, max(width, height) / np.abs(off).max())
    assert max(1.0, 0.98 * allowed) <= bound <= max(1.0, allowed * (1 + 1e-9))


def test_the_bound_of_a_hole_is_its_own():
    # A hole's normal points to its middle: material left has little room there, undercut only the part's size.
    hole = pocket(10.0, 10.0).profile
    assert bound_of(hole, [(HERE, np.array([0.45]))]) == pytest.approx(10.0, rel=3e-3)
    assert bound_of(hole, [(HERE, np.array([-0.5]))]) == pytest.approx(20.0)


def test_nothing_off_the_contour_bounds_nothing():
    assert bound_of(rectangle(10.0, 10.0).profile, []) == GREATEST
    assert bound_of(rectangle(10.0, 10.0).profile, [(HERE, np.array([np.nan]))]) == GREATEST


def test_deviations_larger_than_the_part_are_drawn_as_they_are():
    assert bound_of(rectangle(10.0, 10.0).profile, [(HERE, np.array([-30.0]))]) == 1.0


@pytest.mark.parametrize(
    ("largest", "bound", "expected"),
    [(0.0, 1e6, 500), (0.02, 1e6, 500), (0.02, 499, 200), (0.5, 1e6, 20), (0.5, 12.0, 10), (0.5, 1.0, 1), (90, 1e6, 1)],
)
def test_what_is_chosen_is_round_and_below_the_bound(largest, bound, expected):
    assert magnification_for(rectangle(100.0, 50.0).profile, largest, bound) == expected


@pytest.mark.parametrize("wrong", [0.0, 0.99, -2023.0, 1.1e6, float("nan"), float("inf")])
def test_a_magnification_that_is_none_is_refused(wrong):
    with pytest.raises(UsageError, match="from 1 to 1000000"):
        checked(wrong)


@settings(deadline=None, max_examples=examples(30))
@given(part=parts(), share=st.floats(-0.4, 0.4))
def test_what_would_be_folded_is_left_out(part, share):
    profile = part.profile
    span, point, normal, _ = walked(profile)
    off = np.full(len(span), share * profile.total[0] / 8)
    drawn = unfolded(profile, span, point, normal, off)
    # The exact distance to the part's own lines and arcs: a place that is folded is nearer to others.
    away = distance_to(part.elements, point + off[:, None] * normal)
    assert (away[drawn] >= 0.985 * np.abs(off[drawn]) - 1e-6).all()
    assert (away[~drawn] <= 0.995 * np.abs(off[~drawn])).all()


def test_a_run_is_joined_over_a_fold_and_parted_at_a_wide_gap():
    points = np.column_stack([np.arange(8.0) * 0.4, np.zeros(8)])
    owner = np.array([0, 0, 0, 0, 0, 0, 1, 1])
    drawn = np.array([1, 1, 0, 1, 1, 1, 1, 1], dtype=bool)
    assert index_of(points, owner, drawn).tolist() == [0, 1, 3, 4, 5, -1, 6, 7, -1]
    drawn[3] = False
    assert index_of(points, owner, drawn).tolist() == [0, 1, -1, 4, 5, -1, 6, 7, -1]
    assert index_of(points, owner, np.zeros(8, dtype=bool)).tolist() == []
    # One place alone is no line.
    assert index_of(points, owner, np.array([1, 0, 0, 0, 0, 0, 1, 1], dtype=bool)).tolist() == [6, 7, -1]
