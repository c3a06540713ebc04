# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings on what is used together: filter and points, parts and parts, a part and its program."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from millcorr import nc, pipeline, plausibility
from millcorr.comparison.ball_radius import axis_residue, contact_known
from millcorr.comparison.deviation import deviations
from millcorr.correction.wanted_displacement import Part, wanted_displacement
from millcorr.errors import DistrustError, RefusedError
from millcorr.readers.measurement import Measurement
from tests.core.loop_programs import measured
from tests.core.plausibility.test_distrust import NOMINAL, PLAIN, PROGRAM, changed, wave


def correct(
    first: Measurement, *further: Measurement, program: nc.Program = PROGRAM, **chosen: object
) -> pipeline.Result:
    settings = pipeline.Settings(**({"filter": "none"} | chosen))
    return pipeline.correct(pipeline.Request(program, 5.0, first, NOMINAL, settings, further))


def noisy(seed: int) -> Measurement:
    rng = np.random.default_rng(seed)
    found = measured(NOMINAL, lambda k, s: wave(k, s) + 0.001 * rng.standard_normal(len(s)))
    return replace(found, source=f"part-{seed}.csv")


def examined(measurement: Measurement) -> tuple[plausibility.Finding, ...]:
    """What the model says of one part."""
    d = deviations(measurement, NOMINAL)
    work = wanted_displacement([Part(d, np.zeros(len(d)), d.value)], NOMINAL, pipeline.Settings(), False)
    assert work.separated is not None
    return plausibility.examine_separated(d, work.separated, NOMINAL, 0.6)


def test_points_on_a_small_part_of_the_contour_are_dangerous() -> None:
    (finding,) = examined(changed(PLAIN[:12]))
    assert finding.name == "unmeasured" and finding.dangerous
    assert examined(changed(PLAIN[: len(PLAIN) // 2])) == ()
    assert examined(changed(PLAIN)) == ()


def test_many_outliers_are_said_and_too_many_are_dangerous() -> None:
    found = {}
    for every in (20, 6):
        points = np.array(PLAIN)
        rng = np.random.default_rng(0)
        rows = rng.choice(len(points), len(points) // every, replace=False)
        points[rows, 0] += rng.uniform(0.1, 0.3, len(rows)) * rng.choice([-1, 1], len(rows))
        found[every] = examined(changed(points))
    assert found[20] == ()
    (finding,) = found[6]
    assert finding.name == "outliers" and not finding.dangerous


def half_measured(part: Measurement) -> Measurement:
    rows = np.flatnonzero(part.points[:, 0] < 50.0)
    return replace(part, points=part.points[rows].copy(), lines=part.lines[rows])


def on_the_other_half() -> np.ndarray:
    """Arc lengths 6 mm and more from the half with points; half of 5 % of 224 mm is bridged from either side."""
    s = np.arange(0.0, 224.0, 0.5)
    from_points, _ = NOMINAL.at(0, s)
    return s[from_points[:, 0] > 57.0]


def test_where_nothing_was_measured_the_mean_is_corrected() -> None:
    result = correct(half_measured(noisy(1)))
    d, s = result.deviation, on_the_other_half()
    at_points = result.correction.at(d.stretch, d.s, result.nominal)
    np.testing.assert_allclose(at_points, result.commanded - d.value, atol=5e-5)
    there = result.correction.at(np.zeros(len(s), dtype=int), s, result.nominal)
    assert there.min() > -d.value.max() - 0.005 and there.max() < -d.value.min() + 0.005
    assert result.separated is not None
    _, std = result.separated.at(np.zeros(len(s), dtype=int), s)
    assert std.max() > 2.0 * np.median(result.uncertainty)


@pytest.mark.thorough
def test_where_nothing_was_measured_an_earlier_correction_stays() -> None:
    whole = correct(measured(NOMINAL, wave))
    program = nc.parse(whole.text, "second.nc")
    left = measured(NOMINAL, lambda k, s: 0.004 * np.cos(4 * np.pi * s / NOMINAL.total[0]))
    result = correct(half_measured(left), program=program)
    s = on_the_other_half()
    number = np.zeros(len(s), dtype=int)
    before = whole.correction.at(number, s, whole.nominal)
    assert np.abs(before).max() > 0.01
    # What is left, 4 um at most, goes on from the measured half as far as it hangs together, and with it the earlier
    # form is that of the measured half; beyond, the earlier one stays.
    form = np.abs(before - before.mean()).max()
    np.testing.assert_allclose(result.correction.at(number, s, result.nominal), before, atol=0.004 + form)


def test_a_part_of_the_earlier_program_is_refused() -> None:
    program = nc.parse(correct(noisy(1)).text, "second.nc")
    with pytest.raises(DistrustError, match="--accept earlier-program"):
        correct(noisy(2), program=program)
    small = measured(NOMINAL, lambda k, s: 0.05 * wave(k, s) + 0.001 * np.sin(s))
    assert correct(small, program=program).text


def test_one_part_given_as_two_is_refused() -> None:
    first = noisy(1)
    less = replace(first, points=first.points[1:].copy(), lines=first.lines[1:].copy(), source="less.csv")
    with pytest.raises(DistrustError, match=r"points of less.csv .*--accept same-part"):
        correct(first, less)
    assert correct(first, noisy(2)).text


def test_a_nominal_among_several_parts_is_refused_by_its_name() -> None:
    nominal = replace(measured(NOMINAL, lambda k, s: 0.0 * s), source="nominal.csv")
    with pytest.raises(DistrustError, match=r"^nominal.csv: .*--accept identical-to-nominal"):
        correct(noisy(1), nominal)


@pytest.mark.thorough
def test_parts_may_reach_as_far_as_they_like() -> None:
    """What any of them shows is corrected; only a transfer function is told at the places of the first."""
    whole = noisy(1)
    half = replace(changed(noisy(2).points[: len(PLAIN) // 2].copy()), source="half.csv")
    either = [correct(*parts, filter="auto").correction for parts in ((half, whole), (whole, half))]
    s = np.linspace(0.0, 224.0, 400)
    one, other = (c.at(np.zeros(len(s), dtype=int), s, NOMINAL) for c in either)
    np.testing.assert_allclose(one, other, atol=1e-4)
    with pytest.raises(DistrustError, match="--accept first-part"):
        correct(half, whole, method="transfer", depth=[2.0])
    assert correct(whole, half).text


def test_parts_measured_at_any_places_are_averaged() -> None:
    """Points taken at random leave gaps of several spacings on each part."""
    parts = []
    for seed in (1, 2, 3):
        rows = np.sort(np.random.default_rng(seed).choice(len(PLAIN), 40, replace=False))
        parts.append(replace(changed(noisy(seed).points[rows].copy()), source=f"{seed}.csv"))
    assert correct(*parts, filter="auto").text


@pytest.mark.parametrize(("given", "name"), [(2.0, "axis-radius"), (3.0, None), (4.0, "axis-radius")])
def test_the_radius_of_a_shift_along_the_axis_is_checked(given: float, name: str | None) -> None:
    d = deviations(changed(PLAIN), NOMINAL)
    n = d.normal
    travel = np.where(np.abs(n[:, :1]) > np.abs(n[:, 1:]), [1.0, 0.0], [0.0, 1.0]) * -np.sign(n)
    points = PLAIN[d.index].copy()
    points[:, :2] += 3.0 * (n + travel)
    m = replace(changed(points), axis_radii=(given, given))
    found = axis_residue(m, contact_known(m, NOMINAL), NOMINAL)
    assert (found and found[0]) == name


def test_contact_points_said_to_be_shifted_are_found() -> None:
    m = replace(changed(PLAIN.copy()), axis_radii=(1.0, 1.0))
    found = axis_residue(m, contact_known(m, NOMINAL), NOMINAL)
    assert found is not None and found[0] == "not-axis-compensated" and found[2]


def test_a_finding_is_named_before_it_is_said_that_no_contour_is_near() -> None:
    """3 mm off the contour that the program shows is no contour near; a ball's radius all along it is."""
    centres = changed(measured(NOMINAL, lambda k, s: wave(k, s) + 3.0).points)
    settings = pipeline.Settings(filter="none", side="right")
    with pytest.raises(DistrustError, match="--accept ball-not-compensated"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, centres, None, settings))


def test_what_a_reader_says_of_a_file_is_in_the_result() -> None:
    result = correct(replace(noisy(1), notes=("no END: points may be missing",)))
    assert "part-1.csv: no END: points may be missing" in result.advice


def test_another_frame_is_named_before_the_side_is_asked_for() -> None:
    mirrored = changed(PLAIN * [-1, 1, 1])
    with pytest.raises(DistrustError, match="--accept mirrored"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, mirrored, None, pipeline.Settings(filter="none")))


def inch(m: Measurement) -> Measurement:
    return replace(m, points=np.round(m.points / 25.4, 5) * 25.4, unit="inch")


def coarser(m: Measurement) -> Measurement:
    return replace(m, points=np.round(m.points, 3))


def centres(m: Measurement) -> Measurement:
    d = deviations(m, NOMINAL)
    points = m.points[d.index].copy()
    points[:, :2] += 1.5 * d.normal
    return replace(m, points=np.round(points, 4), ball_radius=1.5, lines=m.lines[d.index])


def turned_round(m: Measurement) -> Measurement:
    return replace(m, points=np.round(m.points[::-1], 3))


@pytest.mark.few(1)
@pytest.mark.parametrize("saved", [inch, coarser, centres, turned_round])
@pytest.mark.parametrize("error", [wave, lambda k, s: np.full(len(s), 0.02)])
def test_a_measurement_saved_otherwise_is_not_applied_twice(saved, error) -> None:
    """In inches, with fewer digits, as centres of a ball, in another order; also where the error has no shape."""
    rng = np.random.default_rng(5)
    found = measured(NOMINAL, lambda k, s: error(k, s) + 0.001 * rng.standard_normal(len(s)))
    first = replace(found, points=np.round(found.points, 4))
    program = nc.parse(correct(first).text, "second.nc")
    with pytest.raises(RefusedError, match=r"second\.nc:\d+: this measurement was applied on"):
        correct(replace(saved(first), source="again.csv"), program=program)
    # What the corrected program leaves is another part, however small its noise.
    left = measured(NOMINAL, lambda k, s: 0.001 * rng.standard_normal(len(s)))
    assert correct(coarser(left), program=program).text
