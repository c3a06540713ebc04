# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transfer function of the machining system: algebra, uncertainty, guards, and the whole loop on an elastic machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from millcorr import nc, pipeline, report
from millcorr.correction.transfer_function import (
    LEAST_REMOVED,
    along_axis,
    examine,
    from_line,
    identify,
    line_over_depth,
    one_value,
)
from millcorr.errors import InputError, RefusedError, UsageError
from millcorr.production.split import split
from millcorr.virtual.simulated_machine import ErrorField, SimulatedMachine, reference_contour
from tests.core import loop_programs as programs
from tests.core.sweeps import slow

depths = st.floats(0.05, 5.0)
ms_values = st.floats(0.0, 2.0)
offsets = st.floats(-0.2, 0.2)


# ---------------------------------------------------------------------------------------------------- the algebra


@given(ms_values, depths)
def test_the_loop_is_identified_from_what_it_leaves(ms: float, depth: float) -> None:
    """delta/h = MS/(1 + MS), petrakov-2025 eq. (3), solved by eq. (4)."""
    delta = depth * ms / (1 + ms)
    found = identify([delta], depth)
    assert found.ms[0] == pytest.approx(ms, rel=1e-12, abs=1e-12)
    assert found.share[0] == pytest.approx(delta / depth, rel=1e-12, abs=1e-15)
    assert found.error(depth)[0] == pytest.approx(delta, rel=1e-12, abs=1e-15)


@given(ms_values, offsets, depths)
def test_a_corrected_path_leaves_nothing_at_any_depth(ms: float, offset: float, next_depth: float) -> None:
    """e + a + b (H - e) = 0 with a taken out (1 + MS)-fold; without the factor a MS/(1 + MS) would stay."""
    b = ms / (1 + ms)
    found = from_line(np.array([offset]), np.array([b]), slope_std=0.0, level_std=0.0, depth=1.0)
    shift = found.correction(next_depth)
    assert shift[0] + offset + b * (next_depth - shift[0]) == pytest.approx(0.0, abs=1e-12)
    assert found.left(next_depth, shift)[0] == pytest.approx(0.0, abs=1e-12)
    plain = -offset - next_depth * ms
    assert found.left(next_depth, plain)[0] == pytest.approx(offset * b, abs=1e-12)


def test_published_numbers_and_what_a_mirror_leaves() -> None:
    """H = 0.5, delta = 0.02: MS = 0.0416667, command 0.5208333; a mirror leaves 0.8 um."""
    found = identify([0.02], 0.5)
    assert found.ms[0] == pytest.approx(0.0416667, abs=5e-8)
    assert 0.5 - found.correction(0.5)[0] == pytest.approx(0.5208333, abs=5e-8)
    assert found.left(0.5, -0.02)[0] == pytest.approx(0.0008, abs=1e-12)


@given(ms_values, depths, st.floats(-0.3, 0.3))
def test_identified_the_same_whatever_correction_was_in_force(ms: float, depth: float, offset: float) -> None:
    """A path put e over the nominal commands H - e and leaves its share of that: MS does not know of the history."""
    commanded = depth - offset
    if commanded < 0.01:
        return
    machine = commanded * ms / (1 + ms)
    assert identify([machine], commanded).ms[0] == pytest.approx(ms, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("delta", "depth"), [(0.1, 2.0), (0.02, 0.3), (-0.001, 1.0), (0.3, 0.5)])
def test_uncertainty_is_the_derivative(delta: float, depth: float) -> None:
    step = 1e-6
    slope = (identify([delta + step], depth).ms[0] - identify([delta - step], depth).ms[0]) / (2 * step)
    found = identify([delta], depth, 0.001)
    # Central differences err by step^2 times the third derivative, far below 1e-6 here.
    assert found.ms_std[0] == pytest.approx(0.001 * slope, rel=1e-6)


def test_uncertainty_of_two_depths_against_many_trials() -> None:
    """200 000 trials know a standard deviation to 1/sqrt(2 n) = 0.16 %; five times that, and curvature, are allowed."""
    rng = np.random.default_rng(7)
    sigma, a, b, n = 0.001, 0.01, 0.05, 200_000
    h = np.array([[1.0], [2.0]])
    values = a + b * h + sigma * rng.standard_normal((2, n))
    line = line_over_depth(values, np.broadcast_to(h, (2, n)))
    level = values.mean(axis=0)
    found = from_line(level - 1.5 * line.slope, line.slope, slope_std=0.0, level_std=0.0, depth=1.5)
    stated = from_line(
        np.array([a]),
        np.array([b]),
        slope_std=sigma / np.sqrt(line.spread[:1]),
        level_std=sigma / np.sqrt(2),
        depth=1.5,
    )
    assert stated.ms_std[0] == pytest.approx(found.ms.std(), rel=0.01)
    assert stated.offset_std[0] == pytest.approx(found.offset.std(), rel=0.01)
    assert stated.covariance[0] == pytest.approx(np.cov(found.ms, found.offset)[0, 1], rel=0.02)
    for next_depth in (0.5, 1.5, 4.0):
        assert stated.correction_std(next_depth)[0] == pytest.approx(found.correction(next_depth).std(), rel=0.01)
    # In the middle of the depths measured a correction is known better than anywhere else.
    spread = [stated.correction_std(d)[0] for d in (0.5, 1.5, 4.0)]
    assert spread[1] < spread[0] and spread[1] < spread[2]


@given(st.integers(2, 6), st.integers(0, 10_000))
def test_line_over_depth_is_the_least_squares_line(parts: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    h = np.cumsum(rng.uniform(0.2, 1.0, parts))
    values = rng.normal(0.05, 0.02, (parts, 7))
    line = line_over_depth(values, np.broadcast_to(h[:, None], values.shape))
    oracle = np.polyfit(h, values, 1)
    np.testing.assert_allclose(line.slope, oracle[0], atol=1e-12)
    np.testing.assert_allclose(line.depth, h.mean())
    if parts > 2:
        residual = values - np.polynomial.polynomial.polyval(h, oracle[::-1]).T
        assert line.std == pytest.approx(np.sqrt((residual**2).sum() / (7 * (parts - 2))), rel=1e-9)
    else:
        assert np.isnan(line.std)


def test_line_where_parts_say_nothing() -> None:
    values = np.array([[0.1, 0.1, np.nan], [0.2, np.nan, 0.2]])
    h = np.array([[1.0] * 3, [3.0] * 3])
    line = line_over_depth(values, h)
    assert line.slope[0] == pytest.approx(0.05)
    assert np.isnan(line.slope[1:]).all()
    with pytest.raises(InputError, match="different places"):
        line_over_depth(values[:, 1:], h[:, 1:])


def test_one_value_is_the_mean_with_the_uncertainty_of_a_mean() -> None:
    value, trust = np.array([0.04, 0.05, 0.06, 9.0]), np.array([1.0, 1.0, 1.0, 0.0])
    mean, std = one_value(value, trust, np.full(4, 0.003))
    assert (mean, std) == (pytest.approx(0.05), pytest.approx(0.003 / np.sqrt(3)))
    rng = np.random.default_rng(1)
    many = rng.normal(0.05, 0.01, 10_000)
    mean, std = one_value(many, np.ones(10_000), np.full(10_000, np.nan))
    assert std == pytest.approx(many.std(ddof=1) / 100, rel=1e-9)


def test_along_an_axis() -> None:
    angle = np.radians([30.0, 59.0])
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    foot = np.array([[1.0, 2.0], [3.0, 4.0]])
    np.testing.assert_allclose(along_axis(normal, foot, "y"), 1 / np.cos(angle))
    np.testing.assert_allclose(along_axis(-normal, foot, "y"), 1 / np.cos(angle))
    np.testing.assert_allclose(along_axis(normal, foot, "normal"), 1.0)
    with pytest.raises(RefusedError, match=r"at X1.000 Y2.000: the normal is 60 degrees off X.*--depth-along normal"):
        along_axis(np.array([[0.4999, 0.866]]), foot[:1], "x")


# ---------------------------------------------------------------------------------------------------- guards


def test_a_depth_that_stays_is_refused() -> None:
    place = np.array([[0.0, 0.0], [10.0, 20.0]])
    assert identify([0.5 * (1 - LEAST_REMOVED) - 1e-9], 0.5).ms[0] == pytest.approx(1 / LEAST_REMOVED - 1)
    for delta in (0.5 * (1 - LEAST_REMOVED) + 1e-6, 0.5, 0.6, np.nan):
        with pytest.raises(RefusedError, match=r"^at X10.000 Y20.000: .* of a commanded depth of 0.5000 mm stayed"):
            identify([0.02, delta], 0.5, place=place)
    with pytest.raises(InputError, match=r"^at X10.000 Y20.000: the commanded depth is -0.1000 mm"):
        identify([0.02, 0.02], [0.5, -0.1], place=place)
    with pytest.raises(RefusedError, match="95 % of the difference"):
        from_line(np.zeros(1), np.array([0.95]), slope_std=0.0, level_std=0.0, depth=1.0)


def test_negative_stiffness_is_refused_beyond_its_uncertainty() -> None:
    place = np.array([[0.0, 0.0], [10.0, 20.0]])
    assert examine(identify([0.02, -0.0005], 0.5, 0.0005), place) == ()
    with pytest.raises(RefusedError, match=r"^at X10.000 Y20.000 the transfer function would be -0.0099, negative"):
        examine(identify([0.02, -0.005], 0.5, 0.0005), place)


def test_noise_of_a_rigid_machine_is_seldom_refused() -> None:
    """One in a hundred measurements by construction; 2000 of 100 points refuse 20 +- 4.5."""
    rng = np.random.default_rng(5)
    refused = 0
    for noise in rng.normal(0.0, 0.001, (2000, 100)):
        try:
            examine(identify(noise, 1.0, 0.001), np.zeros((100, 2)))
        except RefusedError:
            refused += 1
    assert refused == pytest.approx(20, abs=5 * 4.5)


def test_an_implausible_one_is_reported() -> None:
    (warning,) = examine(identify([0.02, 0.2], 0.5, 0.001), np.array([[0.0, 0.0], [10.0, 20.0]]))
    assert "0.667 at X10.000 Y20.000: 40 % of the depth stays" in warning
    assert examine(identify([0.16], 0.5, 0.001), np.zeros((1, 2))) == ()


# ---------------------------------------------------------------------------------------------------- settings


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ({"method": "transfer"}, "needs --depth"),
        ({"depth": 1.0}, "--depth belongs to --method transfer"),
        ({"next_depth": 1.0}, "--next-depth belongs"),
        ({"depth_along": "y"}, "--depth-along belongs"),
        ({"transfer_function": "one"}, "--transfer-function belongs"),
        ({"method": "transfer", "depth": 0.0}, "--depth 0: must be"),
        ({"method": "transfer", "depth": (1.0, -1.0)}, "--depth -1: must be"),
        ({"method": "transfer", "depth": 1.0, "next_depth": 0.0}, "--next-depth 0"),
        ({"method": "transfer", "depth": 1.0, "depth_along": "z"}, "--depth-along z: choose"),
        ({"method": "transfer", "depth": 1.0, "transfer_function": "two"}, "--transfer-function two: choose"),
        ({"allowance": -0.5}, "--allowance -0.5"),
    ],
)
def test_settings_that_contradict_each_other(bad: dict[str, object], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        pipeline.Settings(**bad)  # type: ignore[arg-type]


def test_settings_in_words() -> None:
    words = pipeline.Settings(method="transfer", depth=[2.0, 1], next_depth=0.5, allowance=0.25).in_words()
    assert words.startswith("method transfer depth 2 1 next depth 0.5 along normal taken smooth allowance 0.25 filter")
    assert "depth" not in pipeline.Settings().in_words()


# ---------------------------------------------------------------------------------------------------- the loop

NOMINAL = reference_contour()
LENGTH = float(NOMINAL.total[0])
S = np.arange(500) * LENGTH / 500


def spline_program(radius: float = 5.0, count: int = 1600) -> nc.Program:
    s = np.arange(count) * LENGTH / count
    c, n = NOMINAL.at(0, s)
    q = c + radius * n
    lead = q[0] + 20 * n[0]
    lines = ["G21 G90", f"G0 X{lead[0]:.5f} Y{lead[1]:.5f}", "G0 Z2", "G1 Z-5 F100"]
    lines += [f"G1 X{x:.5f} Y{y:.5f} F300" for x, y in (*q, q[0])]
    lines += [f"G1 X{lead[0]:.5f} Y{lead[1]:.5f}", "G0 Z20", "M30", ""]
    return nc.parse("\n".join(lines), "spline.nc")


PROGRAM = spline_program()


def varying(s: np.ndarray) -> np.ndarray:
    """MS from 0.02 to 0.15 along the contour."""
    return 0.085 + 0.065 * np.cos(4 * np.pi * np.asarray(s) / LENGTH + 0.3)


def loop(machine: SimulatedMachine, next_stock: object = None, seed: int = 1, **settings: object):
    """Deviations of a part cut at the next depth by the first program, and by the corrected one; and the result."""
    measurement = machine.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=seed).measure(200, seed=seed)
    chosen = pipeline.Settings(**({"tolerance": 0.0002, "output_moves": "nurbs"} | settings))  # type: ignore[arg-type]
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))
    again = machine if next_stock is None else replace(machine, allowance=next_stock)
    before = again.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=seed + 1).deviation(0, S)
    after = again.cut(nc.parse(result.text).toolpath, 5.0, NOMINAL, seed=seed + 1).deviation(0, S)
    return before, after, result


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


@pytest.mark.parametrize(
    ("taken", "next_depth"),
    [
        ("smooth", 0.5),
        ("points", 0.15),
        slow("smooth", 0.15),
        slow("smooth", 0.3),
        slow("points", 0.3),
        slow("points", 0.5),
    ],
)
def test_another_depth_is_cut_right_the_first_time(taken: str, next_depth: float) -> None:
    """MS varies from 0.02 to 0.15 along the contour; the paper reached 1/8 and 1/6 of the error, the bound is 1/20."""
    machine = SimulatedMachine(allowance=0.3, transfer=varying)
    before, after, result = loop(
        machine, next_depth, method="transfer", depth=0.3, next_depth=next_depth, transfer_function=taken
    )
    assert np.abs(after).max() <= np.abs(before).max() / 20
    assert rms(after) <= rms(before) / 40
    # What the report expects of the next part is what it does.
    assert np.abs(result.predicted).max() < 2e-4
    _, mirrored, _ = loop(machine, next_depth, method="mirror")
    share = varying(S) / (1 + varying(S))
    # A mirror takes out what the first depth has left: (H2 - H) b stays, and b of the shift comes back.
    expected = (next_depth - 0.3) * share + 0.3 * share**2
    np.testing.assert_allclose(mirrored, expected, atol=4e-4)
    assert rms(mirrored) > 5 * rms(after)


def test_one_value_leaves_what_varies_along_the_contour() -> None:
    machine = SimulatedMachine(allowance=0.3, transfer=varying)
    _, after, result = loop(machine, method="transfer", depth=0.3, transfer_function="one")
    assert result.elastic is not None
    # The mean of MS over the contour is 0.085, the wave cancels; chords of the program err by less than 0.2 um.
    assert result.elastic.transfer.ms == pytest.approx(np.full(200, 0.085), abs=2e-4)
    expected = 0.3 * (varying(S) - 0.085) / (1 + varying(S))
    np.testing.assert_allclose(after, expected, atol=3e-4)


def test_with_noise_what_is_left_is_what_chance_allows() -> None:
    """The random part is 1 um a part: no correction of any method leaves less than that."""
    machine = SimulatedMachine(allowance=0.3, transfer=varying, process_noise=0.001)
    before, after, result = loop(machine, 0.5, method="transfer", depth=0.3, next_depth=0.5)
    assert rms(before) > 0.03
    assert rms(after) < 0.0015
    assert result.elastic is not None
    ms = result.elastic.transfer
    pull = (ms.ms - varying(result.deviation.s)) / ms.ms_std
    # Standard uncertainties hold within a factor of two or three, from one part.
    assert 0.3 < rms(pull) < 2.0
    applied = result.correction.at(result.deviation.stretch, result.deviation.s, NOMINAL)
    pull = (applied + 0.5 * varying(result.deviation.s)) / result.correction_uncertainty
    assert 0.3 < rms(pull) < 2.0
    assert report.summary(result)["correction"]["uncertainty_max"] == result.correction_uncertainty.max()


@pytest.mark.parametrize("gain", [slow(1.0), 0.5])
def test_correcting_again_does_not_need_to_know_the_history(gain: float) -> None:
    """Whatever the program in force commands, its part gives the same MS, and the path goes to -MS H."""
    machine = SimulatedMachine(allowance=0.3, transfer=varying)
    _, after, first = loop(machine, method="transfer", depth=0.3, gain=gain)
    share = varying(S) / (1 + varying(S))
    np.testing.assert_allclose(after, (1 - gain) * 0.3 * share, atol=5e-4)
    program = nc.parse(first.text, "second.nc")
    measurement = machine.cut(program.toolpath, 5.0, NOMINAL, seed=4).measure(200, seed=4)
    settings = pipeline.Settings(method="transfer", depth=0.3, tolerance=0.0002, output_moves="nurbs")
    second = pipeline.correct(pipeline.Request(program, 5.0, measurement, NOMINAL, settings))
    assert second.elastic is not None
    np.testing.assert_allclose(second.elastic.system.ms, varying(second.deviation.s), atol=0.001)
    applied = second.correction.at(np.zeros(500, dtype=np.int64), S, NOMINAL)
    np.testing.assert_allclose(applied, -0.3 * varying(S), atol=5e-4)


OFFSETS = ErrorField(constant=0.004, harmonics=((1, 0.003, 0.5),))


@pytest.mark.parametrize("taken", ["smooth", slow("points"), "one"])
def test_two_depths_tell_the_offset_from_what_gives_way(taken: str) -> None:
    """delta = a + b h with a varying from 1 to 7 um: one depth carries it wrongly to another, two carry it right."""
    ms = 0.06 if taken == "one" else varying
    machine = SimulatedMachine(errors=OFFSETS, allowance=0.15, transfer=ms)
    parts = [
        replace(machine, allowance=h).cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=k).measure(200, seed=k)
        for k, h in enumerate((0.15, 0.3))
    ]
    settings = pipeline.Settings(
        method="transfer",
        depth=(0.15, 0.3),
        next_depth=0.6,
        tolerance=0.0002,
        output_moves="nurbs",
        transfer_function=taken,
    )
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, parts[0], NOMINAL, settings, (parts[1],)))
    elastic = result.elastic
    assert elastic is not None and elastic.transfer.offset_known
    truth = OFFSETS(result.deviation.s, result.deviation.normal, LENGTH, True)
    np.testing.assert_allclose(elastic.transfer.offset, truth, atol=3e-4)
    deep = replace(machine, allowance=0.6)
    before = deep.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=9).deviation(0, S)
    after = deep.cut(nc.parse(result.text).toolpath, 5.0, NOMINAL, seed=9).deviation(0, S)
    assert np.abs(after).max() < np.abs(before).max() / 20
    one_depth = replace(settings, depth=0.15)
    alone = pipeline.correct(pipeline.Request(PROGRAM, 5.0, parts[0], NOMINAL, one_depth))
    wrong = deep.cut(nc.parse(alone.text).toolpath, 5.0, NOMINAL, seed=9).deviation(0, S)
    assert np.abs(wrong).max() > 5 * np.abs(after).max()
    assert any("one depth cannot tell" in note for note in alone.advice)
    assert not any("one depth cannot tell" in note for note in result.advice)
    assert any("2 parts cut 0.15, 0.3 mm deep" in warning for warning in result.warnings)
    summary = report.summary(result)["transfer"]
    assert summary["offset"]["mean"] == pytest.approx(truth.mean(), abs=2e-4)
    assert (summary["depth"], summary["next_depth"]) == ([0.15, 0.3], 0.6)


def test_two_depths_from_programs_that_leave_different_allowances() -> None:
    """One piece cut 0.4 deep by the first-half program, which leaves 0.4; another 0.2 deep by the finishing program."""
    machine = SimulatedMachine(errors=OFFSETS, allowance=0.8, transfer=varying)
    half = machine.follow(NOMINAL, lambda k, s: np.full(len(s), 0.4), seed=1).measure(200, seed=1)
    whole = replace(machine, allowance=0.2).follow(NOMINAL, seed=2).measure(200, seed=2)
    settings = pipeline.Settings(method="transfer", depth=(0.4, 0.2), allowance=(0.4, 0.0), next_depth=0.3)
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, half, NOMINAL, settings, (whole,)))
    assert result.elastic is not None
    s = result.deviation.s
    np.testing.assert_allclose(result.elastic.transfer.ms, varying(s), atol=0.003)
    np.testing.assert_allclose(
        result.elastic.transfer.offset, OFFSETS(s, result.deviation.normal, LENGTH, True), atol=5e-4
    )
    assert np.abs(result.predicted).max() < 5e-4


def test_two_depths_where_the_second_part_was_not_measured_everywhere() -> None:
    """Where only one depth is known the neighbours' transfer function serves, and nothing jumps."""
    machine = SimulatedMachine(errors=ErrorField(constant=0.004), allowance=0.2, transfer=0.08)
    first = machine.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=0).measure(200, seed=0)
    most = np.arange(0.0, 0.92 * LENGTH, 1.0)
    second = replace(machine, allowance=0.5).cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=1).measure(s=most, seed=1)
    settings = pipeline.Settings(method="transfer", depth=(0.2, 0.5), next_depth=0.3, filter="gauss:20")
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, first, NOMINAL, settings, (second,)))
    assert result.elastic is not None
    np.testing.assert_allclose(result.elastic.transfer.ms, 0.08, atol=2e-4)
    np.testing.assert_allclose(result.elastic.transfer.offset, 0.004, atol=1e-4)


def test_parts_of_one_depth_are_averaged() -> None:
    machine = SimulatedMachine(allowance=0.3, transfer=0.1, process_noise=0.001, noise_length=0.1)
    parts = [machine.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=k).measure(200, seed=k) for k in range(4)]
    settings = pipeline.Settings(method="transfer", depth=0.3, transfer_function="one")
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, parts[0], NOMINAL, settings, tuple(parts[1:])))
    assert result.elastic is not None
    ms, std = result.elastic.transfer.ms[0], result.elastic.transfer.ms_std[0]
    # One point of the mean of four: sigma/2; of 200 independent points: sigma/(2 sqrt(200)); times (1 + MS)^2/h.
    assert std == pytest.approx(0.001 / 2 / np.sqrt(200) * 1.1**2 / 0.3, rel=0.15)
    assert abs(ms - 0.1) < 4 * std + 1e-4


def test_the_second_half_of_an_allowance_is_cut_from_the_real_surface() -> None:
    """Single piece: first cut with 0.4 mm left, measured; the second takes off what is really there."""
    stock, left = 0.8, 0.4
    machine = SimulatedMachine(allowance=stock, transfer=varying)
    first = machine.follow(NOMINAL, lambda k, s: np.full(len(s), left), seed=1)
    measurement = first.measure(200, seed=1)
    second = replace(machine, allowance=lambda s: first.deviation(0, s))

    def finish(**settings: object) -> tuple[np.ndarray, pipeline.Result]:
        chosen = pipeline.Settings(tolerance=0.0002, output_moves="nurbs", allowance=left, **settings)  # type: ignore[arg-type]
        result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))
        return second.cut(nc.parse(result.text).toolpath, 5.0, NOMINAL, seed=2).deviation(0, S), result

    b = varying(S) / (1 + varying(S))
    uncorrected = second.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=2).deviation(0, S)
    np.testing.assert_allclose(uncorrected, (left + (stock - left) * b) * b, atol=3e-4)
    after, result = finish(method="transfer", depth=stock - left)
    assert np.abs(after).max() < np.abs(uncorrected).max() / 20
    assert result.elastic is not None
    np.testing.assert_allclose(result.elastic.next_depth, left + result.filtered, atol=1e-12)
    # The paper carries H and not A + delta to the second half: delta b stays.
    paper, _ = finish(method="transfer", depth=stock - left, next_depth=left)
    # Moves within 0.4 um of where they should be stay; in this the machine yields by (1 + b) of it.
    np.testing.assert_allclose(paper, (stock - left) * b * b, atol=5e-4)
    mirrored, _ = finish(method="mirror")
    assert rms(after) < rms(mirrored) / 5


def test_a_finished_part_said_to_have_stock_left_is_refused() -> None:
    machine = SimulatedMachine(allowance=0.3, transfer=0.05)
    measurement = machine.cut(PROGRAM.toolpath, 5.0, NOMINAL, seed=1).measure(200, seed=1)
    settings = pipeline.Settings(method="transfer", depth=0.3, allowance=0.6)
    with pytest.raises(InputError, match=r"lie \+0.014 mm off the profile and not 0.6 mm over it: check --allowance"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, settings))


@pytest.mark.parametrize("bad", [{"depth": (0.3, 0.4)}, {"depth": 0.3, "allowance": (0.1, 0.2)}])
def test_depths_and_allowances_are_counted(bad: dict[str, object]) -> None:
    measurement = programs.measured(NOMINAL, lambda k, s: np.full(len(s), 0.01))
    settings = pipeline.Settings(method="transfer", **bad)  # type: ignore[arg-type]
    with pytest.raises(UsageError, match=r"is given 2 times and measured parts 1: give it once"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, settings))


def test_different_depths_need_the_next_one() -> None:
    parts = [programs.measured(NOMINAL, lambda k, s, d=d: np.full(len(s), d)) for d in (0.01, 0.02)]
    settings = pipeline.Settings(method="transfer", depth=(0.2, 0.4))
    with pytest.raises(UsageError, match="--next-depth"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, parts[0], NOMINAL, settings, (parts[1],)))


def test_an_undercut_is_no_elastic_response() -> None:
    measurement = programs.measured(NOMINAL, lambda k, s: 0.005 + 0.02 * np.cos(2 * np.pi * s / LENGTH))
    settings = pipeline.Settings(method="transfer", depth=0.3)
    with pytest.raises(RefusedError, match=r"at X\S+ Y\S+ the transfer function would be -0.0\d+, negative"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, settings))


def test_gain_and_dead_band_act_on_what_the_next_part_would_show() -> None:
    """d = H b is left without a correction; a gain g takes out g of it, a dead band above it nothing."""
    ms, depth = 0.1, 0.3
    measurement = programs.measured(NOMINAL, lambda k, s: np.full(len(s), depth * ms / (1 + ms)))
    common = {"method": "transfer", "depth": depth, "filter": "none"}
    half = pipeline.correct(
        pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, pipeline.Settings(gain=0.5, **common))  # type: ignore[arg-type]
    )
    # The program's own chords err by up to 0.17 um, which is machined away and not elastic.
    assert half.correction.largest == pytest.approx(0.5 * depth * ms, abs=2e-4)
    np.testing.assert_allclose(half.predicted, 0.5 * depth * ms / (1 + ms), atol=2e-4)
    still = pipeline.correct(
        pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, pipeline.Settings(dead_band=0.028, **common))  # type: ignore[arg-type]
    )
    assert still.correction.largest == 0.0


def test_without_a_transfer_function_the_report_says_so() -> None:
    measurement = programs.measured(NOMINAL, lambda k, s: np.full(len(s), 0.01))
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL))
    assert result.elastic is None and report.summary(result)["transfer"] is None


def cut_and_measured(left: float, stock: float, ms: float = 0.06, shift: float = 0.0, seed: int = 1):
    """A part whose program left `left` mm, cut from `stock` mm, with its program moved by `shift` besides."""
    machine = SimulatedMachine(allowance=stock, transfer=ms)
    return machine.follow(NOMINAL, lambda k, s: np.full(len(s), left + shift), seed=seed).measure(200, seed=seed)


def test_wrong_allowance_is_refused_whatever_the_method() -> None:
    measurement = cut_and_measured(0.4, 0.8)
    for settings in ({"method": "mirror"}, {"method": "transfer", "depth": 0.4}):
        chosen = pipeline.Settings(allowance=0.6, **settings)  # type: ignore[arg-type]
        with pytest.raises(InputError, match="check --allowance"):
            pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))


def test_depth_ten_times_too_small_is_refused() -> None:
    measurement = cut_and_measured(0.0, 0.3, ms=0.1)
    chosen = pipeline.Settings(method="transfer", depth=0.03)
    with pytest.raises(RefusedError, match="check --depth"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))


@pytest.mark.parametrize(("depth", "warned"), [(3.0, True), (0.3, False)])
def test_depth_ten_times_too_large_is_warned_of(depth: float, warned: bool) -> None:
    """MS 0.06 of 0.3 mm looks like 0.006 of 3 mm: stiffer than milling machines are."""
    measurement = cut_and_measured(0.0, 0.3, ms=0.06)
    chosen = pipeline.Settings(method="transfer", depth=depth)
    found = pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen)).warnings
    assert any("less than milling machines give way; check --depth" in line for line in found) == warned


def test_a_rigid_machine_is_not_called_stiff_where_nothing_is_known() -> None:
    """1 um of noise over 0.1 mm: MS is anything within 0.01 of 0."""
    value = np.random.default_rng(2).normal(0.0, 0.001, 60)
    assert examine(identify(value, 0.1, 0.001), np.zeros((60, 2))) == ()


@pytest.mark.parametrize("given", [{"depth": 10.5}, {"depth": 1.0, "next_depth": 30.0}])
def test_a_depth_beyond_the_cutters_width_is_refused(given: dict[str, float]) -> None:
    measurement = cut_and_measured(0.0, 0.3, ms=0.06)
    chosen = pipeline.Settings(method="transfer", **given)
    with pytest.raises(UsageError, match="takes no more than its width off"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, NOMINAL, chosen))


def test_allowance_goes_with_the_uncorrected_program() -> None:
    first = cut_and_measured(0.0, 0.4)
    once = pipeline.correct(pipeline.Request(PROGRAM, 5.0, first, NOMINAL, pipeline.Settings()))
    chosen = pipeline.Settings(method="transfer", depth=0.4, allowance=0.4)
    second = cut_and_measured(0.4, 0.8, seed=2)
    with pytest.raises(InputError, match="a first cut of the uncorrected program"):
        pipeline.correct(pipeline.Request(nc.parse(once.text), 5.0, second, NOMINAL, chosen))


def test_fillet_that_the_first_cut_could_not_reach_is_no_elasticity() -> None:
    """A pocket with fillets of 5.3 mm, a cutter of 5 mm: with 0.4 mm left the first cut stays far off in them."""
    path = "G0 X30 Y20\nG1 Z-5 F100\nG1 X30 Y5 F300\nX54.7\nG3 X55 Y5.3 J0.3\nG1 Y35\nX5\nY5\nX30\nG0 Z20\n"
    finish, side = nc.parse(path.encode(), "pocket.nc"), "left"
    done = split(finish, 5.0, 0.8, 0.5, settings=pipeline.Settings(side=side))
    nominal = pipeline.nominal_from_program(finish, 5.0, pipeline.Settings(side=side), None)
    ms = 0.06
    s = np.linspace(0.0, float(nominal.total[0]), 400, endpoint=False)
    # In the three sharp corners nothing round can be measured.
    foot, _ = nominal.at(0, s)
    sharp = np.array([[60.0, 40.0], [0.0, 40.0], [0.0, 0.0]])
    s = s[np.hypot(*(foot[:, None, :] - sharp).T).min(axis=0) > 7.0]
    machine = SimulatedMachine(allowance=0.8, transfer=ms)
    first = machine.cut(nc.parse(done.result.text).toolpath, 5.0, nominal, seed=1)
    measurement = first.measure(s=s, seed=1)
    chosen = pipeline.Settings(method="transfer", depth=0.4, allowance=0.4, side=side)
    result = pipeline.correct(pipeline.Request(finish, 5.0, measurement, settings=chosen))
    assert any("cannot reach" in r.reason for r in result.deviation.rejected)
    # Everywhere -(A + delta) MS, 0.4254 * 0.06 = 25.5 um; what stood in the fillet would have asked for far more.
    shift = result.correction.at(result.deviation.stretch, result.deviation.s, result.nominal)
    left = 0.4 + 0.4 * ms / (1 + ms)
    np.testing.assert_allclose(shift, -left * ms, atol=1e-3)
