# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings about measurements that do not mean what they seem to: each stops the correction, or says so."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.errors import DistrustError, InputError, MillcorrError, RefusedError, UsageError
from millcorr.plausibility import NAMES
from millcorr.readers.measurement import Measurement
from millcorr.virtual.simulated_machine import reference_contour
from tests.core.loop_programs import measured
from tests.core.stages.test_pipeline import PROGRAM

NOMINAL = reference_contour()


def wave(k: int, s: np.ndarray) -> np.ndarray:
    return 0.01 + 0.004 * np.sin(6 * np.pi * s / NOMINAL.total[0])


def changed(points: np.ndarray, ball: float = 0.0) -> Measurement:
    return Measurement(points, None, ball, np.arange(1, len(points) + 1), "part.csv", "ab" * 32)


def run(measurement: Measurement, **settings: object) -> pipeline.Result:
    chosen = pipeline.Settings(**({"filter": "mean:5"} | settings))  # type: ignore[arg-type]
    return pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))


PLAIN = measured(NOMINAL, wave).points
CENTRES = measured(NOMINAL, lambda k, s: wave(k, s) + 1.0).points

DANGEROUS = {
    "unit": (changed(PLAIN / 25.4), "--units inch"),
    "mirrored": (changed(PLAIN * [-1, 1, 1]), "x reversed"),
    "ball-not-compensated": (changed(CENTRES), r"ball of about that radius: --points centre"),
    "compensated-twice": (changed(PLAIN, 1.0), "--points contact"),
    "diameter-for-radius": (changed(CENTRES, 2.0), "--probe-radius 1"),
    "radius-for-diameter": (changed(CENTRES, 0.5), "--probe-radius 1"),
    "wrong-side": (changed(measured(NOMINAL, lambda k, s: wave(k, s) + 10.0).points), "--side"),
    "constant-offset": (changed(measured(NOMINAL, lambda k, s: wave(k, s) - 0.3).points), "-0.290 mm"),
    "turned": (changed(PLAIN @ [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]), "turned by -90 degrees"),
    "misalignment": (changed(PLAIN + [0.12, -0.05, 0.0]), r"X\+1[12]\d um Y-[45]\d um"),
}


@pytest.mark.parametrize("name", DANGEROUS)
def test_dangerous_findings_stop_the_correction_and_name_the_remedy(name: str) -> None:
    measurement, remedy = DANGEROUS[name]
    with pytest.raises(DistrustError, match=remedy) as caught:
        run(measurement)
    assert f"--accept {name}" in str(caught.value)
    assert str(caught.value).startswith("part.csv: ")


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["constant-offset", "misalignment"])
def test_accepted_findings_are_recorded(name: str) -> None:
    result = run(DANGEROUS[name][0], accept=(name,))
    assert any(w.startswith(f"accepted {name}: ") for w in result.warnings)
    assert name in result.request.settings.in_words()
    assert [one["finding"] for one in result.summary()["accepted"]] == [name]


def test_the_units_the_other_way() -> None:
    with pytest.raises(DistrustError, match="divided by 25.4"):
        run(changed(PLAIN * 25.4))


def test_an_honest_measurement_raises_nothing() -> None:
    assert run(changed(PLAIN)).warnings == ()


def test_zero_deviations_are_noticed() -> None:
    result = run(measured(NOMINAL, lambda k, s: np.zeros(len(s))))
    assert any("nominal was probably exported" in w for w in result.warnings)


def test_some_points_below_the_cut_are_noticed() -> None:
    points = PLAIN.copy()
    points[::4, 2] = -7.5
    assert any(
        "56 points (from Z-7.500) lie below the deepest pass at Z-5.000" in w for w in run(changed(points)).warnings
    )


def test_some_points_above_the_cut_are_noticed() -> None:
    points = PLAIN.copy()
    points[::4, 2] = 40.0
    assert any("56 points (up to Z40.000) lie above Z2.000" in w for w in run(changed(points)).warnings)


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("z", "words"),
    [
        (-7.5, r"Z-5.000 to Z2.000: check the height"),
        (-80.0, r"divided by 25.4 they would lie there"),
        (4.0, r"with z reversed they would lie there"),
    ],
)
def test_all_points_at_a_wrong_height_stop_the_correction(z: float, words: str) -> None:
    points = PLAIN.copy()
    points[:, 2] = z
    with pytest.raises(DistrustError, match=words) as caught:
        run(changed(points))
    assert "--accept wrong-level" in str(caught.value)
    assert any(w.startswith("accepted wrong-level") for w in run(changed(points), accept=("wrong-level",)).warnings)


def test_a_small_shift_is_only_a_warning() -> None:
    result = run(changed(PLAIN + [0.04, 0.0, 0.0]))
    assert any("shift of X+" in w for w in result.warnings)


def test_a_tool_error_is_no_shift() -> None:
    result = run(measured(NOMINAL, lambda k, s: 0.02 + 0.005 * np.cos(2 * np.pi * s / NOMINAL.total[0])))
    assert not any("shift" in w for w in result.warnings)


def test_half_a_program_is_refused() -> None:
    whole = PROGRAM.data.splitlines(keepends=True)
    half = nc.parse(b"".join(whole[: len(whole) // 3]), "cut.nc")
    with pytest.raises(DistrustError, match="is the program whole"):
        pipeline.correct(pipeline.Request(half, 5.0, changed(PLAIN), None, pipeline.Settings(side="right")))


def test_the_same_points_saved_differently_are_the_same_measurement() -> None:
    first = changed(PLAIN)
    reversed_ = Measurement(PLAIN[::-1].copy(), None, 0.0, np.arange(1, len(PLAIN) + 1), "again.csv", "ef" * 32)
    program = nc.parse(run(first).text, "second.nc")
    with pytest.raises(RefusedError, match="applied on"):
        pipeline.correct(pipeline.Request(program, 5.0, reversed_, NOMINAL))


def test_names_to_accept_must_exist() -> None:
    with pytest.raises(UsageError, match="no such finding"):
        run(changed(PLAIN), accept=("everything",))
    assert set(DANGEROUS) <= set(NAMES)


@pytest.mark.thorough
def test_alignment_takes_a_shift_out_and_says_so() -> None:
    turned = np.radians(0.3)
    rotation = np.array([[np.cos(turned), -np.sin(turned), 0], [np.sin(turned), np.cos(turned), 0], [0, 0, 1]])
    moved = changed(PLAIN @ rotation.T + [0.4, -0.2, 0.0])
    with pytest.raises((DistrustError, InputError)):
        run(moved)
    plain, aligned = run(changed(PLAIN)), run(moved, align="rigid")
    assert aligned.alignment is not None
    # A rigid fit also takes up what looks like a motion in the deviations themselves.
    own = run(changed(PLAIN), align="rigid")
    assert aligned.deviation.value == pytest.approx(own.deviation.value, abs=1e-6)
    assert np.abs(own.deviation.value - plain.deviation.value).max() < 0.004
    summary = aligned.summary()["alignment"]
    assert summary["rotation_deg"] == pytest.approx(-0.3, abs=0.01)
    assert nc.parse(aligned.text)


ELASTIC = {
    # What MS leaves of 2 or 4 mm: as large as mistakes, but never negative and never more than MS 0.15 leaves.
    "constant-offset": (lambda k, s: 0.21 + 0.002 * np.sin(s / 9.0), 4.0),
    "scale": (None, 2.0),
    "misalignment": (None, 2.0),
}


def elastic(name: str) -> Measurement:
    if ELASTIC[name][0] is not None:
        return measured(NOMINAL, ELASTIC[name][0])
    left, bottom, right, top = NOMINAL.bounding_box()
    size = max(right - left, top - bottom) / 2

    def softer_walls(k: int, s: np.ndarray) -> np.ndarray:
        c, n = NOMINAL.at(k, s)
        if name == "scale":
            return 0.02 + 0.13 * ((c - [(left + right) / 2, (bottom + top) / 2]) * n).sum(axis=1) / size
        return 0.15 * n[:, 0]

    whole = measured(NOMINAL, softer_walls)
    if name == "scale":
        return whole
    # Seen all round a shift leaves too little on one side; on the half that was measured it does not.
    normals = measured(NOMINAL, lambda k, s: np.ones(len(s))).points - measured(NOMINAL, lambda k, s: 0 * s).points
    return changed(whole.points[normals[:, 0] > 0.05])


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ELASTIC)
def test_what_an_elastic_machine_leaves_is_dangerous_only_without_its_depth(name: str) -> None:
    with pytest.raises(DistrustError, match=f"--accept {name}|--accept ball-not-compensated"):
        run(elastic(name), filter="auto")
    result = run(elastic(name), filter="auto", method="transfer", depth=ELASTIC[name][1])
    said = [
        w for w in result.warnings if "transfer function of 0.055 leaves of 4 mm" in w or "deviations are what" in w
    ]
    assert len(said) == (name == "constant-offset")


@pytest.mark.few(5)
@pytest.mark.parametrize(
    ("name", "depth"),
    [
        *((name, 2.0) for name in DANGEROUS if name != "ball-not-compensated"),
        *(("ball-not-compensated", depth) for depth in (0.5, 2.0, 4.0, 7.0)),
    ],
)
def test_a_depth_excuses_no_mistake(name: str, depth: float) -> None:
    measurement, remedy = DANGEROUS[name]
    with pytest.raises(DistrustError, match=remedy):
        run(measurement, method="transfer", depth=depth)


@pytest.mark.few(2)
@pytest.mark.parametrize("radius", [0.25, 0.5, 1.0, 2.0])
def test_a_ball_not_taken_off_is_seen_at_every_depth_that_would_leave_as_much(radius: float) -> None:
    """At the depth of which MS 0.15 leaves just the radius, and beyond, the size alone tells it."""
    # No deeper than the cutter is wide.
    for depth in (1.0, min(7.67 * radius, 10.0), min(15.0 * radius, 10.0)):
        left = radius + 0.02 * radius
        with pytest.raises(DistrustError, match="--accept ball-not-compensated"):
            run(measured(NOMINAL, lambda k, s, left=left: np.full(len(s), left)), method="transfer", depth=depth)


@pytest.mark.few(6)
@pytest.mark.parametrize("allowance", [0.1, 0.3, 0.8])
@pytest.mark.parametrize("radius", [0.0, 1.0])
@pytest.mark.parametrize("said", [0.1, 1.0, 10.0, None])
def test_an_allowance_that_was_forgotten_or_mistyped_is_refused(
    allowance: float, radius: float, said: float | None
) -> None:
    """A first cut of as much again as it leaves; a stiff machine leaves 1/21 of that on top."""
    left = allowance * (1.0 + 0.05 / 1.05)
    part = measured(NOMINAL, lambda k, s: radius + left + 0.001 * np.sin(s / 9.0))
    part = changed(part.points.copy(), radius)
    given = {} if said is None else {"allowance": said * allowance}
    if said == 1.0:
        assert run(part, method="transfer", depth=allowance, **given).text
        return
    with pytest.raises(MillcorrError) as caught:
        run(part, method="transfer", depth=allowance, **given)
    text = str(caught.value)
    # Without an allowance 0.1 mm more than all that was to be cut off are no elasticity; else the option is named.
    assert "--allowance" in text or (allowance == 0.1 and said in (None, 0.1) and "depth" in text), text
    assert "radius seems" not in text
