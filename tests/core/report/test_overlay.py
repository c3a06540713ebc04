# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction on a disc, where every magnified line is a circle known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.errors import UsageError
from millcorr.readers.measurement import Measurement
from millcorr.report.length_unit import INCH, MM
from millcorr.report.magnification import KEPT
from millcorr.report.picture import correction as overlay
from millcorr.report.picture.scale import Look, Scale

DISC, CUTTER = 40.0, 5.0
SINGLE = 4e-6
"""Rounding of coordinates up to 64 mm to single precision."""


def corrected(error, count=72, z=(-3.0,), extra=(), **settings):
    """A disc whose points are off by `error` (of the angle), corrected; extra points are added as they are."""
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radius = DISC + error(angle)
    rings = [np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(count, h)]) for h in z]
    points = np.concatenate([*rings, np.reshape(extra, (-1, 3))])
    path = DISC + CUTTER
    text = "\n".join(
        [
            "G21 G90 G17",
            f"G0 X{path} Y0 Z5",
            "G1 Z-8 F100",
            f"G2 X{-path} Y0 I{-path} J0 F300",
            f"G2 X{path} Y0 I{path}",
            "G0 Z5",
            "M2",
        ]
    )
    measurement = Measurement(points, None, 0.0, np.arange(2, len(points) + 2), "disc.csv", "0")
    chosen = pipeline.Settings(**({"filter": "none", "side": "left"} | settings))
    return pipeline.correct(pipeline.Request(nc.parse(text, "disc.nc"), CUTTER, measurement, settings=chosen))


def radii(lines):
    return np.hypot(lines.vertices[:, 0], lines.vertices[:, 1])


@pytest.fixture(scope="module")
def even():
    return corrected(lambda angle: np.full(len(angle), 0.012))


def test_everything_is_magnified_along_the_normal(even):
    picture = overlay.overlay_of(even, Look(500.0))
    # 0.012 mm of material left: whiskers out by 6 mm, what is to be cut in by 6 mm, band 5 mm to both sides.
    ends = radii(picture.whiskers).reshape(-1, 2)
    np.testing.assert_allclose(ends, np.tile([40.0, 46.0], (72, 1)), atol=5e-5)
    np.testing.assert_allclose(radii(picture.nominal), 40.0, atol=SINGLE)
    np.testing.assert_allclose(radii(picture.compensated), 34.0, atol=1e-3)
    half = len(picture.band.vertices) // 2
    np.testing.assert_allclose(radii(picture.band)[:half], 45.0, atol=SINGLE)
    np.testing.assert_allclose(radii(picture.band)[half:], 35.0, atol=SINGLE)
    # The operation's path lies on the exact parallel, the corrected one 0.012 mm inside it, to the tolerance of 1 um.
    np.testing.assert_allclose(radii(picture.before), 45.0, atol=500 * 1e-6)
    np.testing.assert_allclose(radii(picture.after), 39.0, atol=500 * 0.001)


def test_lines_lie_at_the_height_they_belong_to(even):
    picture = overlay.overlay_of(even)
    for lines in (picture.whiskers, picture.nominal, picture.band, picture.compensated):
        np.testing.assert_allclose(lines.vertices[:, 2], -3.0)
    np.testing.assert_allclose(picture.before.vertices[:, 2], -8.0)
    two = overlay.overlay_of(corrected(lambda a: 0.01 * np.cos(a), z=(-6.0, -2.0)))
    assert sorted(set(two.nominal.vertices[:, 2].tolist())) == [-6.0, -2.0]
    assert len(two.whiskers) == 144


def test_colours_say_excess_tolerance_undercut():
    result = corrected(lambda angle: 0.02 * np.cos(angle))
    picture = overlay.overlay_of(result, Look(lower=-0.005, upper=0.005))
    colour = picture.whiskers.colours.reshape(-1, 2)
    assert (colour[:, 0] == colour[:, 1]).all()
    red, green, blue = ((colour[:, 0] >> k) & 255 for k in (24, 16, 8))
    value = result.deviation.value
    assert ((blue > red) & (blue > green))[value > 0.005].all()
    assert ((green > red) & (green > blue))[np.abs(value) <= 0.005].all()
    assert ((red > green) & (red > blue))[value < -0.005].all()
    # The legend has the very colours, and its bounds hold every deviation.
    assert set(colour[:, 0].tolist()) <= set(picture.scale.shades.tolist())
    assert len(picture.scale.steps) == len(picture.scale.shades) + 1 and (np.diff(picture.scale.steps) < 0).all()
    assert picture.scale.steps[0] >= value.max() - 1e-12 and picture.scale.steps[-1] <= value.min() + 1e-12
    for k in range(len(picture.scale.shades)):
        inside = (value < picture.scale.steps[k] - 1e-9) & (value > picture.scale.steps[k + 1] + 1e-9)
        assert (colour[inside, 0] == picture.scale.shades[k]).all()


def test_all_in_tolerance_is_all_green():
    scale = Scale.of(Look(), np.array([0.004, -0.004]))
    assert scale.steps.tolist() == [0.01, -0.01] and len(scale.shades) == 1
    assert set(scale.colours(np.array([0.01, 0.004, -0.004, 0.0, -0.01])).tolist()) == set(scale.shades.tolist())


def test_limits_need_not_lie_evenly_about_zero():
    value = np.array([0.031, 0.03, 0.02, 0.0, -0.005, -0.0051, -0.015])
    scale = Scale.of(Look(lower=-0.005, upper=0.03), value)
    green = scale.shades[scale.within]
    assert (scale.colours(value) == green).tolist() == [False, True, True, True, True, False, False]
    # The farthest lies 10 um outside: so far the scale goes at both ends, in equal steps.
    np.testing.assert_allclose(scale.steps[[0, -1]], [0.04, -0.015])
    np.testing.assert_allclose(np.diff(scale.steps)[[0, 1, 2, 3, 5, 6, 7, 8]], -0.0025)


def test_material_left_is_blue_or_red():
    value = np.array([0.02, 0.0, -0.02])
    ours, theirs = (Scale.of(Look(material_left=colour), value).colours(value) for colour in ("blue", "red"))
    assert ours.tolist() == theirs[::-1].tolist()
    red, _, blue = ((ours >> k) & 255 for k in (24, 16, 8))
    assert blue[0] > red[0] and red[2] > blue[2]


def test_the_magnification_is_chosen_so_that_deviations_are_seen_and_fit():
    # 80 mm across: whiskers of at most 12 %, which is 9.6 mm.
    for error, times in ((0.012, 500.0), (0.2, 20.0), (0.0001, 50_000.0)):
        result = corrected(lambda angle, error=error: np.full(len(angle), error), accept=("ball-not-compensated",))
        assert overlay.overlay_of(result).magnification == times, error


def test_a_magnification_beyond_the_bound_is_the_bound():
    # 0.2 mm of material left: the profile to cut lies inwards of the disc of radius 40, at most by nine tenths of it.
    even = corrected(lambda angle: np.full(len(angle), 0.2), accept=("ball-not-compensated",))
    picture = overlay.overlay_of(even, Look(2023.0))
    assert picture.magnification == picture.bound == pytest.approx(KEPT * DISC / 0.2, rel=3e-3)
    assert picture.bound <= KEPT * DISC / 0.2


def test_polylines_are_whole():
    picture = overlay.overlay_of(corrected(lambda angle: 0.01 * np.sin(3 * angle)))
    for name in ("whiskers", "nominal", "band", "compensated", "before", "after"):
        lines = getattr(picture, name)
        used = lines.index[lines.index >= 0]
        assert lines.index[-1] == -1 and len(lines.colours) == len(lines.vertices), name
        assert sorted(used.tolist()) == list(range(len(lines.vertices))), name
        # A profile's points are close together: no polyline jumps.
        if name in ("nominal", "band"):
            first, second = lines.index[:-1], lines.index[1:]
            both = (first >= 0) & (second >= 0)
            step = np.linalg.norm(lines.vertices[first[both]] - lines.vertices[second[both]], axis=1)
            assert step.max() < 4 * overlay.SPACING, name


def test_a_whisker_tells_what_it_is():
    result = corrected(lambda angle: 0.0125 * np.cos(angle))
    row = int(np.argmax(result.deviation.value))
    text = overlay.whisker_text(result, row)
    assert text.splitlines()[0] == "X 40.0125  Y 0.0000  Z -3.0000 mm"
    assert "deviation +0.0125 mm (material left)" in text
    assert "cos \u03b1 +1.000000  cos \u03b2" in text
    assert text.endswith("disc.csv:2")
    least = overlay.whisker_text(result, int(np.argmin(result.deviation.value)))
    assert "deviation -0.0125 mm (undercut)" in least and least.endswith("disc.csv:38")


def test_lengths_are_told_in_inches_where_they_are_wanted():
    result = corrected(lambda angle: 0.0254 * np.cos(angle), extra=[(44.0, 1.0, -3.0)])
    text = overlay.whisker_text(result, int(np.argmax(result.deviation.value)), INCH)
    assert text.splitlines()[0] == "X 1.575803  Y 0.000000  Z -0.118110 in"
    assert "deviation +0.001000 in (material left)" in text and "mm" not in text
    assert "X 1.732283  Y 0.039370  Z -0.118110 in as measured" in overlay.rejected_text(result, 0, INCH)
    # A thousandth of an inch is 25.4 um.
    assert (INCH.fine_number(0.0254), MM.fine_number(-0.0254)) == ("+1.000", "-25.4")
    assert (MM.number(-1e-9, "+"), MM.fine_number(-1e-9)) == ("+0.0000", "+0.0")


def test_rejected_points_are_marked_with_their_reason():
    result = corrected(lambda angle: 0.001 * np.cos(angle), extra=[(44.0, 1.0, -3.0)])
    assert len(result.deviation.rejected) == 1
    picture = overlay.overlay_of(result)
    assert len(picture.rejected) == 1 and len(picture.whiskers) == 72
    np.testing.assert_allclose(picture.rejected.vertices.mean(axis=0), [44.0, 1.0, -3.0], atol=SINGLE)
    text = overlay.rejected_text(result, 0)
    assert text.startswith("left out: ") and result.deviation.rejected[0].reason in text
    assert text.endswith("disc.csv:74") and "X 44.0000" in text


def test_many_deviations_are_thinned_and_extremes_stay():
    rng = np.random.default_rng(3)
    noise = rng.normal(0.0, 0.001, 3000)
    # Noise is not to be followed by a cutter: the dead band leaves it alone.
    result = corrected(lambda angle: noise, count=3000, dead_band=0.1)
    rows = overlay.thinned(result, 100)
    assert len(rows) == 100 and (np.diff(rows) > 0).all()
    value = result.deviation.value
    assert {int(value.argmax()), int(value.argmin())} <= set(rows.tolist())
    # Points come in order round the disc: each of 100 groups of 30 keeps its largest.
    order = np.argsort(result.deviation.s)
    groups = np.abs(value[order]).reshape(100, 30).max(axis=1)
    np.testing.assert_array_equal(np.sort(np.abs(value[rows])), np.sort(groups))
    assert len(overlay.thinned(result, 3000)) == 3000


def test_without_a_measurement_there_is_only_the_path():
    request = corrected(lambda angle: 0 * angle).request
    result = pipeline.correct(pipeline.Request(request.program, CUTTER, None, settings=pipeline.Settings(side="left")))
    picture = overlay.overlay_of(result)
    assert len(picture.whiskers) == 0 and len(picture.rejected) == 0 and len(picture.after) > 0
    np.testing.assert_allclose(radii(picture.nominal), 40.0, atol=SINGLE)
    np.testing.assert_allclose(picture.nominal.vertices[:, 2], -8.0)


@pytest.mark.parametrize(
    "wrong",
    [
        {"magnification": 0.5},
        {"magnification": -2023.0},
        {"magnification": float("nan")},
        {"lower": 0.02, "upper": 0.01},
        {"lower": float("nan")},
        {"upper": 11.0},
        {"material_left": "green"},
    ],
)
def test_an_impossible_look_is_refused(wrong):
    with pytest.raises(UsageError, match="must be"):
        Look(**wrong)
