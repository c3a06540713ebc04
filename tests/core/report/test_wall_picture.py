# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wall in the colours of its deviation, on a disc where that is known everywhere in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import pipeline
from millcorr.report.picture import plots
from millcorr.report.picture.scale import Look, Scale
from millcorr.report.picture.wall import UNKNOWN, wall_heights, wall_of
from tests.core.report.test_overlay import CUTTER, DISC, corrected
from tests.core.sweeps import examples

LOOK = Look(lower=-0.004, upper=0.004)


def wall(result, **options):
    return wall_of(result, Scale.of(LOOK, result.deviation.value), **options)


def angles(found):
    return np.arctan2(found.vertices[:, 1], found.vertices[:, 0]).astype(float)


@pytest.fixture(scope="module")
def waved():
    """Measured at two heights: at the upper one the deviation is the other way round."""
    upper = corrected(lambda a: -0.02 * np.cos(a), z=(-2.0,)).request.measurement.points
    return corrected(lambda a: 0.02 * np.cos(a), z=(-6.0,), extra=upper)


def test_the_wall_stands_on_the_nominal_between_the_heights_of_its_cut(waved):
    found = wall(waved, top=3.0)
    np.testing.assert_allclose(np.hypot(found.vertices[:, 0], found.vertices[:, 1]), DISC, atol=4e-6)
    assert (found.vertices[:, 2].min(), found.vertices[:, 2].max()) == (-8.0, 3.0)
    # The normal points out of the material, level.
    np.testing.assert_allclose(found.normals[:, :2], found.vertices[:, :2] / DISC, atol=1e-6)
    assert (found.normals[:, 2] == 0).all() and len(found.colours) == len(found.vertices)


def test_faces_are_whole_and_cover_the_wall(waved):
    found = wall(waved, top=2.0)
    corners = found.index.reshape(-1, 5)
    assert (corners[:, 4] == -1).all() and corners[:, :4].min() == 0 and corners[:, :4].max() < len(found.vertices)
    a, b, c, d = (found.vertices[corners[:, k]].astype(float) for k in range(4))
    area = (np.linalg.norm(np.cross(b - a, d - a), axis=1) + np.linalg.norm(np.cross(b - c, d - c), axis=1)) / 2
    assert area.sum() == pytest.approx(2 * np.pi * DISC * 10.0, rel=1e-3)
    # Seen from outside they run anticlockwise: their own normal is the wall's.
    outward = np.cross(b - a, d - a)
    assert ((outward * found.normals[corners[:, 0]]).sum(axis=1) > 0).all()


def test_colours_are_those_of_the_deviation_at_the_height(waved):
    scale = Scale.of(LOOK, waved.deviation.value)
    found = wall_of(waved, scale, top=0.0)
    # From +1 at the lower height and below, to -1 at the upper one and above, straight between.
    share = np.interp(found.vertices[:, 2], [-6.0, -2.0], [1.0, -1.0])
    value = 0.02 * np.cos(angles(found)) * share
    # Points stand 5 degrees apart: between two of them a straight line is off by up to 20 um (5 degrees)^2 / 8.
    clear = np.abs(value[:, None] - scale.steps[None, :]).min(axis=1) > 5e-5
    assert clear.mean() > 0.9 and not found.bare
    assert (found.colours[clear] == scale.colours(value)[clear]).all()


def test_where_no_point_is_near_the_wall_is_grey():
    def gap(angle):
        return np.where(np.abs(angle - np.pi) < 0.6, 5.0, 0.001)

    found = wall(corrected(gap, accept=("many-rejected",)))
    grey = found.colours == UNKNOWN
    inside = np.abs(np.abs(angles(found)) - np.pi) < 0.5
    outside = np.abs(np.abs(angles(found)) - np.pi) > 0.8
    assert found.bare and grey[inside].all() and not grey[outside].any()


def test_a_wall_of_no_known_height_is_a_strip():
    # One pass at Z-8, points at Z-3: the wall is what lies between. Points at the pass's own height: 5 % of 80 mm.
    assert wall_heights(corrected(lambda a: 0.001 * np.cos(a))) == (-8.0, -3.0)
    assert wall_heights(corrected(lambda a: 0.001 * np.cos(a), z=(-8.0,))) == pytest.approx((-8.0, -4.0))
    assert wall_heights(corrected(lambda a: 0.001 * np.cos(a), z=(-8.0,)), 12.0) == (-8.0, 12.0)
    assert wall_heights(corrected(lambda a: 0.001 * np.cos(a)), -5.0) == (-8.0, -3.0)


def test_without_a_measurement_there_is_no_wall():
    request = corrected(lambda angle: 0 * angle).request
    result = pipeline.correct(pipeline.Request(request.program, CUTTER, None, settings=pipeline.Settings(side="left")))
    assert len(wall(result)) == 0 and not wall(result).bare


@settings(deadline=None, max_examples=examples(20))
@given(turn=st.floats(0.0, 6.28), z=st.floats(-10.0, 5.0))
def test_a_place_of_the_wall_leads_to_the_point_measured_there(waved, turn, z):
    d = waved.deviation
    row = plots.row_near(waved, np.array([DISC * np.cos(turn), DISC * np.sin(turn), z]))
    away = np.abs((np.arctan2(d.foot[row, 1], d.foot[row, 0]) - turn + np.pi) % (2 * np.pi) - np.pi)
    assert away <= np.pi / 72 + 1e-9
    assert d.z[row] == (-6.0 if z < -4.0 else -2.0) or abs(z + 4.0) < 1e-6
    assert plots.place_of(waved, row) == pytest.approx(d.s[row])
