# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots as arrays, and the way between a place of the plot, the part, and the view."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from millcorr import nc, pipeline
from millcorr.correction.settings import Settings
from millcorr.probing import Placement, TouchProbe, plan
from millcorr.production.process_control import Control
from millcorr.readers.measurement import Measurement
from millcorr.report.picture import plots as plot_arrays
from millcorr.report.picture.probing import BALL, OVER, TOUCH, WAY, joined
from millcorr.report.picture.probing import overlay_of as probing_lines
from tests.core.production.test_serial import Shop

RADIUS = 40.0


def corrected(noise=0.0, count=360, gap=None, wrong=None, filter="gauss:10", form=0.003):
    """A disc of radius 40, cut with 3 cos 2a + 5 um too much left on, or another form, and some noise.

    Without the points between two angles in degrees, and with one point 80 um off.
    """
    text = "G21 G90 G17\nG0 X45 Y0 Z5\nG1 Z-8 F100\nG2 X-45 Y0 I-45 J0 F300\nG2 X45 Y0 I45\nG0 Z5\nM2"
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    rng = np.random.default_rng(7)
    radius = RADIUS + 0.005 + form * np.cos(2 * angle) + noise * rng.standard_normal(count)
    if wrong is not None:
        radius[wrong] += 0.08
    points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(count, -4.0)])
    if gap is not None:
        points = points[(angle < np.radians(gap[0])) | (angle > np.radians(gap[1]))]
    measurement = Measurement(points, None, 0.0, np.arange(1, len(points) + 1), "disc.csv", "0", has_z=True)
    chosen = Settings(side="left", filter=filter)
    return pipeline.correct(pipeline.Request(nc.parse(text, "disc.nc"), 5.0, measurement, None, chosen))


@pytest.fixture(scope="module")
def result():
    return corrected()


def from_above(left, right, bottom, top):
    """Matrix of a view from above that shows a rectangle of the XY plane, as Coin has it: points are rows."""
    matrix = np.eye(4)
    matrix[0, 0], matrix[1, 1], matrix[2, 2] = 2 / (right - left), 2 / (top - bottom), -0.01
    matrix[3, 0], matrix[3, 1] = -(right + left) / (right - left), -(top + bottom) / (top - bottom)
    return matrix.tolist()


def angle_of(result, x):
    """Polar angle of a place of the axis: the disc's centre is the origin."""
    ring, stroke = np.split(plot_arrays.mark(result, x).vertices.astype(float), [33])
    middle = stroke.mean(axis=0)
    assert ring[:-1].mean(axis=0) == pytest.approx(middle, abs=1e-4)
    return np.arctan2(middle[1], middle[0])


def test_deviations_lie_where_they_were_measured(result):
    plot = plot_arrays.along(result)
    assert plot.total == pytest.approx(2 * np.pi * RADIUS, abs=1e-9) and plot.starts.tolist() == [0.0]
    for row in range(0, 360, 17):
        # The picture's vertices are single precision: 4e-6 of 40 mm.
        assert np.cos(angle_of(result, plot.x[row]) - np.radians(row)) == pytest.approx(1.0, abs=1e-9)
        assert plot.raw[row] == pytest.approx(5 + 3 * np.cos(2 * np.radians(row)), abs=1e-6)
        assert plot_arrays.nearest(plot, plot.x[row]) == row


def test_courses_span_the_axis_once(result):
    plot = plot_arrays.along(result)
    ends = sorted((float(course.x[0]), float(course.x[-1])) for course in plot.courses)
    assert ends[0][0] == 0.0 and ends[-1][1] == pytest.approx(plot.total, abs=1e-9)
    assert all(b[0] == pytest.approx(a[1], abs=1e-9) for a, b in zip(ends, ends[1:], strict=False))
    first, last = plot.courses[0], plot.courses[-1]
    # Interpolated on both sides of the seam to the same value.
    assert first.value[0] == pytest.approx(last.value[-1], abs=1e-9)
    for course in plot.courses:
        assert (np.diff(course.x) >= 0).all()
        known = np.isfinite(course.low)
        assert (course.low[known] <= course.value[known]).all() and (course.value[known] <= course.high[known]).all()


def test_classes_hold_all_points():
    noisy = corrected(noise=0.004)
    plot = plot_arrays.distribution(noisy)
    assert plot.before.sum() == plot.predicted.sum() == 360
    width = np.diff(plot.edges)
    assert width == pytest.approx(width[0])
    # The bell's area is the points' times the width of a class, but for the tails beyond 4 sigma (6e-5).
    area = (np.diff(plot.bell_x) * (plot.bell[1:] + plot.bell[:-1]) / 2).sum()
    assert area == pytest.approx(360 * width[0], rel=1e-4)


def test_a_bell_narrower_than_a_class_is_left_out():
    plot = plot_arrays.distribution(corrected(form=0.03))
    assert plot.before.sum() == 360 and not len(plot.bell)


@pytest.mark.parametrize(("low", "high"), [(30.0, 150.0), (120.0, 250.0), (300.0, 350.0), (-40.0, 20.0)])
def test_a_view_of_a_part_of_the_contour_shows_that_part_of_the_axis(result, low, high):
    # A rectangle that holds the points from one angle to the other: everything beyond the chord between them.
    a, b = np.radians(low), np.radians(high)
    turn = (a + b) / 2 - np.pi / 2
    c, s = np.cos(turn), np.sin(turn)
    spin = np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    cut = RADIUS * np.cos((b - a) / 2)
    matrix = spin @ np.array(from_above(-100, 100, cut, 100))
    plot = plot_arrays.along(result)
    seen = plot_arrays.seen(result, plot, matrix.tolist())
    if low < np.degrees(angle_of(result, 0.0)) % 360 < high:
        # What is seen runs past the seam.
        assert seen == (0.0, plot.total)
        return
    # Looked at in a thousand places.
    assert seen[1] - seen[0] == pytest.approx(np.radians(high - low) * RADIUS, abs=2 * plot.total / 1000)
    assert np.degrees(angle_of(result, sum(seen) / 2)) % 360 == pytest.approx((low + high) / 2, abs=0.5)


def test_the_whole_axis_where_everything_or_nothing_is_seen(result):
    plot = plot_arrays.along(result)
    for view in (from_above(-90, 90, -90, 90), from_above(200, 210, 200, 210)):
        assert plot_arrays.seen(result, plot, view) == (0.0, plot.total)


@given(share=st.floats(0.001, 0.999), beside=st.floats(-3.0, 3.0))
def test_what_is_drawn_at_a_place_is_found_there(result, share, beside):
    plot = plot_arrays.along(result)
    x = share * plot.total
    angle, radius = angle_of(result, x), RADIUS + beside
    view = from_above(-90, 90, -60, 60)
    u, v = radius * np.cos(angle) / 90, radius * np.sin(angle) / 60
    found = plot_arrays.place_under(result, view, u, v)
    # Single precision of the picture, from which the angle was taken.
    assert found == pytest.approx(x, abs=1e-3)


def test_nothing_is_found_far_from_the_contour(result):
    view = from_above(-90, 90, -60, 60)
    assert plot_arrays.place_under(result, view, 0.0, 0.0) is None
    flat = np.eye(4)
    flat[2, 2] = 0.0
    assert plot_arrays.place_under(result, flat.tolist(), 0.4, 0.0) is None


def test_points_of_a_stretch_lie_on_it(result):
    points = plot_arrays.stretch_points(result, 10.0, 30.0)
    assert np.hypot(points[:, 0], points[:, 1]) == pytest.approx(RADIUS, abs=1e-9)
    assert points[:, 2] == pytest.approx(-4.0)
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(20.0, rel=1e-3)


def test_lines_of_a_measuring_program(result):
    touches = plan(result.nominal, Placement(count=12), TouchProbe(ball_radius=2.0))
    drawn = probing_lines(touches, -3.0, 20.0)
    assert len(drawn) == 12 + 12 + 11
    ends = np.split(drawn.vertices, np.flatnonzero(drawn.index < 0)[:-1] - np.arange(len(drawn) - 1))
    assert [len(e) for e in ends[:12]] == [2] * 12
    assert np.allclose([e[1, :2] for e in ends[:12]], touches.contact, atol=1e-4)
    for k, ball in enumerate(ends[12:24]):
        assert np.allclose(np.hypot(*(ball[:, :2] - touches.centre[k]).T), 2.0, atol=1e-4)
    assert set(drawn.colours.tolist()) <= {TOUCH, BALL, WAY, OVER}
    over = [link is None for link in touches.links]
    assert (drawn.colours == OVER).sum() == 4 * sum(over)


def test_no_lines_at_all():
    drawn = joined([])
    assert len(drawn) == 0 and drawn.vertices.shape == (0, 3)


@pytest.mark.thorough
def test_a_series_has_parts_mean_form_and_limits(tmp_path):
    shop = Shop(tmp_path, Control(2, 0.004))
    sizes = [20, 3, 5, 6]
    for size in sizes:
        shop.next(shop.measure(size))
    found = plot_arrays.series(shop.entries)
    assert found.part.tolist() == [1, 2, 3, 4]
    np.testing.assert_allclose(found.mean, sizes, atol=0.01)
    np.testing.assert_allclose(found.limit, 4.0)
    # After the first part's correction the control begins at 0 and goes half the way to every part.
    np.testing.assert_allclose(found.smoothed[1:], [1.5, 3.25, 4.625], atol=0.01)
    assert found.corrected.tolist() == [True, False, False, True]
    # A wave that all parts share: 6 um along the contour are 6 / sqrt(2) root mean square.
    waved = Shop(tmp_path / "waved", Control(2, 0.030))
    waved.directory.mkdir()
    total = waved.nominal.total
    for mean in (3, 4, 5, 3):
        waved.next(waved.measure(lambda k, s, mean=mean: 1e-3 * (mean + 6 * np.sin(6 * np.pi * s / total[k]))))
    form = plot_arrays.series(waved.entries).form
    assert np.isfinite(form).any()
    np.testing.assert_allclose(form[np.isfinite(form)], 6 / np.sqrt(2), rtol=0.15)


def test_a_series_without_a_control_has_no_limit(tmp_path):
    shop = Shop(tmp_path)
    shop.next(shop.measure(20))
    found = plot_arrays.series(shop.entries)
    assert np.isnan(found.limit).all() and np.isnan(found.smoothed).all()


def test_a_gap_is_drawn_with_what_is_milled_there_and_outliers_apart():
    """Of 360 points those between 200 and 290 degrees are missing, one is off by 80 um."""
    result = corrected(noise=0.001, gap=(200, 290), wrong=20, filter="auto")
    plot = plot_arrays.along(result)
    assert plot.outliers.tolist() == np.flatnonzero(result.outlier).tolist() and len(plot.outliers) == 1
    assert not set(plot.outliers.tolist()) & set(plot.rows.tolist())
    bare = [course for course in plot.courses if course.bare]
    x = np.sort(plot.x)
    before = int(np.argmax(np.diff(x)))
    assert bare and all(x[before] < course.x[0] and course.x[-1] < x[before + 1] for course in bare)
    near = [course for course in plot.courses if not course.bare]
    # In the gap less is known than where points are, and the band for all of the contour is wider than that of a place.
    known = np.median(np.concatenate([c.high - c.low for c in near]))
    assert max((c.high - c.low).max() for c in bare) > 2.0 * known
    assert all((c.whole_low < c.low).all() and (c.high < c.whole_high).all() for c in plot.courses)
