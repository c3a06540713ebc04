# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole loop: program and exact measurement in, corrected program with its proof out."""

from __future__ import annotations

import re

import numpy as np
import pytest
from scipy.spatial import cKDTree
from shapely import LinearRing, LineString, Point, distance
from shapely import points as shapely_points

from millcorr import nc, pipeline
from millcorr.comparison.deviation import statistics
from millcorr.comparison.theoretical_contour import cutting_runs
from millcorr.errors import FormatError, InputError, LimitError, RefusedError, UsageError
from millcorr.readers.measurement import Measurement
from millcorr.virtual.simulated_machine import SimulatedMachine, reference_contour
from tests.core import loop_programs as programs
from tests.core.sweeps import slow

CASES = {
    # name: (text, tool radius, material right of the path, distance kept from inner corners)
    "mitres": (programs.RECTANGLE, 5.0, False, 0.0),
    "rounds": (programs.ROUNDED, 5.0, False, 0.0),
    "pocket": (programs.POCKET, 5.0, False, 5.1),
    "helix": (programs.HELIX, 5.0, False, 0.0),
    "levels": (programs.LEVELS, 5.0, False, 0.0),
    "tabs": (programs.TABS, 5.0, False, 0.0),
    "edge": (programs.EDGE, 8.0, False, 0.0),
    "contour": (programs.CONTOUR_LEFT, 5.0, False, 0.0),
    "inch": (programs.INCH_INCREMENTAL, 5.08, False, 0.0),
}


def nominal_of(name: str):
    text, radius, right, _ = CASES[name]
    program = nc.parse(text, f"{name}.nc")
    settings = pipeline.Settings(side="left" if right else "right")
    return program, pipeline.nominal_from_program(program, radius, settings, None)


def corrected(name: str, deviation, **settings):
    program, nominal = nominal_of(name)
    measurement = programs.measured(nominal, deviation, clear=CASES[name][3])
    chosen = pipeline.Settings(**({"filter": "none"} | settings))
    return pipeline.correct(pipeline.Request(program, CASES[name][1], measurement, None, chosen)), nominal


@pytest.mark.few(10)
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("moves", ["keep", "lines", "arcs", "nurbs"])
def test_every_kind_of_program_is_corrected_within_tolerance(name: str, moves: str) -> None:
    def wave(k: int, s: np.ndarray) -> np.ndarray:
        return 0.01 + 0.005 * np.sin(2 * np.pi * s / 60.0)

    result, _ = corrected(name, wave, output_moves=moves)
    assert result.verification.path_error_max <= 0.001
    assert not result.deviation.rejected
    # On the last millimetre before a corner, where the correction runs out level, a slope of 0.2 um/mm leaves 0.1 um.
    assert np.abs(result.predicted).max() < 2e-4
    assert np.quantile(np.abs(result.predicted), 0.9) < 5e-5
    assert statistics(result.deviation.value)["max"] == pytest.approx(0.015, abs=1e-4)
    if moves == "lines":
        cut = result.regeneration.toolpath.take(np.flatnonzero(result.regeneration.following))
        assert set(cut.kind.tolist()) == {1}


@pytest.mark.few(4)
@pytest.mark.parametrize("name", CASES)
def test_zero_deviations_give_the_program_back_byte_for_byte(name: str) -> None:
    result, _ = corrected(name, lambda k, s: np.zeros(len(s)))
    assert result.text == result.request.program.data
    assert result.regeneration.changed == 0


def test_constant_excess_shifts_coordinates_only() -> None:
    result, _ = corrected("mitres", lambda k, s: np.full(len(s), 0.02))
    lines = [line for line in result.text.decode().splitlines() if not line.startswith("(")]
    assert lines == [
        "G0 X-20 Y-4.98",
        "G0 Z5",
        "G1 Z-5 F100",
        "G1 X0 Y-4.98 F300",
        "G1 X104.98",
        "Y54.98",
        "X-4.98",
        "Y-4.98",
        "X0",
        "G1 X0 Y-19.98",
        "G0 Z20",
    ]


def test_arcs_stay_arcs_about_the_same_centres() -> None:
    result, _ = corrected("rounds", lambda k, s: np.full(len(s), 0.02))
    before, after = result.request.program.toolpath, result.regeneration.toolpath
    assert len(before) == len(after)
    arcs = np.flatnonzero((before.kind == 2) & result.regeneration.following)
    assert len(arcs) == 2
    radius = np.hypot(*(before.start - before.centre)[arcs, :2].T)
    moved = np.hypot(*(after.start - after.centre)[arcs, :2].T)
    # Both arcs are convex: 10 + 5 shrinks with the part; the one about a sharp corner keeps the cutter's radius.
    # The surface is drawn by chords that are off it by 0.1 um.
    assert moved - radius == pytest.approx([-0.02, 0.0], abs=1e-4)


def test_path_error_against_an_independent_offset() -> None:
    """The emitted path of a pocket lies on shapely's offset of the compensated profile."""
    result, _ = corrected("pocket", lambda k, s: 0.01 + 0.004 * np.sin(2 * np.pi * s / 37.0))
    emitted = nc.parse(result.text).toolpath
    profile = result.compensated
    span, t = profile.samples(0.01)
    c, _, _ = profile.evaluate(span, t)
    run = [r for r in cutting_runs(emitted) if len(r) > 5][0]
    following = run[result.regeneration.following[run]]
    p = emitted.take(following).position(np.linspace(0, 1, 21))[:, :, :2].reshape(-1, 2)
    away = distance(shapely_points(p), LinearRing(c))
    # The ring's chords of 0.01 mm on corrections of 4 um per 37 mm are exact to a nanometre.
    assert np.abs(away - 5.0).max() < 0.001


def test_every_line_that_is_not_rewritten_is_the_same_text() -> None:
    result, _ = corrected("rounds", lambda k, s: np.full(len(s), 0.02))
    before = result.request.program.data.decode().splitlines()
    after = [x for x in result.text.decode().splitlines() if "millcorr" not in x.lower()]
    for text in ("%", "O0001 (PART)", "N10 G21 G90 G17", "N30 G1 Z-5. F100.", "N150 G0 Z20.", "N160 M30"):
        assert text in before and text in after


@pytest.mark.thorough
def test_reference_contour_through_three_loops_on_an_elastic_machine() -> None:
    """A mirror leaves MS/(1+MS) of the first deviation after one loop, its square after two."""
    nominal = reference_contour()
    ms, wanted = 0.25, 0.02
    machine = SimulatedMachine(allowance=wanted * (1 + ms) / ms, transfer=ms)
    program = spline_program(nominal, 5.0)
    left = []
    s = np.arange(100) * nominal.total[0] / 100
    for loop in range(3):
        part = machine.cut(program.toolpath, 5.0, nominal, seed=1)
        left.append(part.deviation(0, s).mean())
        measurement = part.measure(200, noise=0.0, seed=loop)
        result = pipeline.correct(
            pipeline.Request(program, 5.0, measurement, nominal, pipeline.Settings(filter="auto"))
        )
        program = nc.parse(result.text, f"loop{loop}.nc")
    part = machine.cut(program.toolpath, 5.0, nominal, seed=1)
    left.append(part.deviation(0, s).mean())
    share = ms / (1 + ms)
    # The path itself is exact to the tolerance of a micrometre.
    assert left == pytest.approx([wanted * share**k for k in range(4)], abs=0.0005)


def spline_program(nominal, radius: float, count: int = 800):
    """Short lines along the exact parallel of a closed contour, with leads along its normal."""
    s = np.arange(count) * nominal.total[0] / count
    c, n = nominal.at(0, s)
    q = c + radius * n
    lead = q[0] + 20 * n[0]
    lines = ["G21 G90", f"G0 X{lead[0]:.4f} Y{lead[1]:.4f}", "G0 Z2", "G1 Z-5 F100"]
    lines += [f"G1 X{x:.4f} Y{y:.4f} F300" for x, y in (*q, q[0])]
    lines += [f"G1 X{lead[0]:.4f} Y{lead[1]:.4f}", "G0 Z20", "M30", ""]
    return nc.parse("\n".join(lines), "spline.nc")


@pytest.mark.few(1)
@pytest.mark.parametrize("parts", [4, slow(20)])
@pytest.mark.parametrize(("filter_", "bound"), [("auto", 1.1), ("mean:5", 1.15), ("none", 1.5)])
def test_residual_after_one_correction(filter_: str, bound: float, parts: int) -> None:
    """On 20 seeds, without measurement noise: auto leaves at most 1.1 sigma_r, a mean of 5 1.10, raw data 1.41."""
    nominal = reference_contour()
    sigma = 0.0015
    machine = SimulatedMachine(errors=SimulatedMachine.reference().errors, process_noise=sigma, measurement_noise=0.0)
    ratio = []
    for seed in range(parts):
        first = machine.follow(nominal, seed=2 * seed)
        measurement = first.measure(200, noise=0.0, seed=seed)
        result = pipeline.correct(
            pipeline.Request(PROGRAM, 5.0, measurement, nominal, pipeline.Settings(filter=filter_))
        )
        places = result.deviation.stretch[:1]

        def shift(k: int, at: np.ndarray, result=result, places=places) -> np.ndarray:
            return result.correction.at(np.full(len(at), places[0]), at, nominal)

        second = machine.follow(nominal, shift, seed=2 * seed + 1)
        ratio.append(np.std(second.deviation(0, result.deviation.s)) / sigma)
    expected = {"auto": 1.03, "mean:5": 1.095, "none": 1.414}[filter_]
    assert np.mean(ratio) <= bound
    assert np.mean(ratio) == pytest.approx(expected, abs=0.08)


PROGRAM = spline_program(reference_contour(), 5.0, 400)


def test_the_programs_own_error_is_removed_and_kept_apart() -> None:
    """A program of coarse chords errs by itself; a part cut with it on a perfect machine comes out right."""
    nominal = reference_contour()
    program = spline_program(nominal, 5.0, 150)
    part = SimulatedMachine(errors=SimulatedMachine.reference().errors).cut(program.toolpath, 5.0, nominal, seed=1)
    measurement = part.measure(200, noise=0.0, seed=1)
    result = pipeline.correct(pipeline.Request(program, 5.0, measurement, nominal, pipeline.Settings(filter="auto")))
    assert np.ptp(result.commanded) > 0.01
    again = nc.parse(result.text)
    s = np.arange(333) * nominal.total[0] / 333
    after = SimulatedMachine(errors=SimulatedMachine.reference().errors).cut(again.toolpath, 5.0, nominal, seed=1)
    # What is left: the tolerance of the path and what the spline regression does not follow.
    assert np.abs(after.deviation(0, s)).max() < 0.001 + 2e-4


def test_gain_and_dead_band() -> None:
    result, nominal = corrected("mitres", lambda k, s: np.full(len(s), 0.02), gain=0.5)
    assert result.correction.largest == pytest.approx(0.01)
    result, _ = corrected("mitres", lambda k, s: np.full(len(s), 0.004), dead_band=0.005)
    assert result.text == result.request.program.data


def test_correcting_again_adds_up() -> None:
    first, nominal = corrected("mitres", lambda k, s: np.full(len(s), 0.02))
    program = nc.parse(first.text, "second.nc")
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.003), digest="cd" * 32)
    second = pipeline.correct(pipeline.Request(program, 5.0, measurement, nominal, pipeline.Settings(filter="none")))
    assert second.correction.largest == pytest.approx(0.023, abs=1e-6)
    assert b"Y54.977" in second.text
    half = pipeline.correct(
        pipeline.Request(program, 5.0, measurement, nominal, pipeline.Settings(filter="none", gain=0.5))
    )
    assert half.correction.largest == pytest.approx(0.0215, abs=1e-6)


def test_the_same_measurement_twice_is_refused() -> None:
    first, nominal = corrected("mitres", lambda k, s: np.full(len(s), 0.02))
    program = nc.parse(first.text, "second.nc")
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.02))
    with pytest.raises(RefusedError, match=r"second.nc:1: .* applied on .* already"):
        pipeline.correct(pipeline.Request(program, 5.0, measurement, nominal))


def test_a_corrected_program_needs_its_nominal() -> None:
    first, nominal = corrected("mitres", lambda k, s: np.full(len(s), 0.02))
    program = nc.parse(first.text, "second.nc")
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.003), digest="cd" * 32)
    with pytest.raises(InputError, match="--nominal"):
        pipeline.correct(pipeline.Request(program, 5.0, measurement))


def test_over_the_limit_is_refused_with_its_place() -> None:
    with pytest.raises(LimitError, match=r"X\d+.* --limit 0\.5;"):
        corrected("mitres", lambda k, s: np.where(s < 10, 0.6, 0.0))


def test_a_hollow_that_is_too_narrow_is_cut_as_far_as_the_cutter_goes() -> None:
    """A dent that a cutter of this radius cannot follow: it comes as near as it can, cuts in nowhere, and says so."""
    nominal = reference_contour()

    def dent(k: int, s: np.ndarray) -> np.ndarray:
        return 0.3 * np.exp(-(((s - 50.0) / 0.8) ** 2))

    measurement = programs.measured(nominal, dent, spacing=0.05)
    settings = pipeline.Settings(filter="none")
    result = pipeline.correct(pipeline.Request(PROGRAM, 5.0, measurement, nominal, settings))
    s = np.arange(40.0, 60.0, 0.005)
    place, normal = nominal.at(0, s)
    moved = result.correction.at(np.zeros(len(s), dtype=np.int64), s, nominal)
    np.testing.assert_allclose(moved, -dent(0, s), atol=0.003)
    wanted = LineString(place + moved[:, None] * normal)
    emitted = nc.parse(result.text).toolpath
    path = emitted.position(np.linspace(0, 1, 9))[result.regeneration.following][:, :, :2].reshape(-1, 2)
    near = path[distance(wanted, shapely_points(path)) < 6.0]
    near = near[np.abs(near - nominal.at(0, 50.0)[0]).max(axis=1) < 8.0]
    # The program has four decimals, and chords of the wanted surface lie 0.3 um inside it at most.
    assert distance(wanted, shapely_points(near)).min() > 5.0 - 0.001
    # A disc rests on both edges of the dent; of a centre line over it, the dent's middle is nearest.
    free = LineString(near).distance(Point(nominal.at(0, 50.0)[0] - 0.3 * nominal.at(0, 50.0)[1])) - 5.0
    assert free > 0.1
    (said,) = [w for w in result.warnings if "too narrow" in w]
    # What the correction differs from the dent by, and the tolerance.
    assert abs(float(said.split(" mm stays")[0]) - free) < 0.004


def test_wrong_tool_diameter_is_refused() -> None:
    program, nominal = nominal_of("mitres")
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.01))
    with pytest.raises((InputError, LimitError)):
        pipeline.correct(pipeline.Request(program, 8.0, measurement))
    with pytest.raises(LimitError, match="no move of the program follows"):
        pipeline.correct(pipeline.Request(program, 6.0, measurement, nominal))


def test_levels_are_kept_apart() -> None:
    program, nominal = nominal_of("mitres")
    high = programs.measured(nominal, lambda k, s: np.full(len(s), 0.01), z=-1.0)
    low = programs.measured(nominal, lambda k, s: np.full(len(s), 0.03), z=-4.0, spacing=1.3)
    both = Measurement(
        np.concatenate([high.points, low.points]), None, 0.0, np.arange(len(high) + len(low)), "two.csv", "ef" * 32
    )
    result = pipeline.correct(pipeline.Request(program, 5.0, both, None, pipeline.Settings(filter="mean:5")))
    assert set(result.deviation.level.tolist()) == {0, 1}
    assert result.correction.largest == pytest.approx(0.02, abs=1e-6)
    assert any("the wall leans: at Z-4.000 it has 20.0 um more than at Z-1.000 all along" in w for w in result.warnings)


def test_a_lean_is_told_with_its_place() -> None:
    """At X50 of the long side the wall has 12 um more at Z-4 than at Z-1, elsewhere as much."""
    program, nominal = nominal_of("mitres")
    rng = np.random.default_rng(4)

    def course(share: float):
        def value(k: int, s: np.ndarray) -> np.ndarray:
            x, y = nominal.at(np.full(len(s), k), s)[0].T
            here = 12e-3 * np.exp(-(((x - 50) / 12) ** 2)) * (y < 1.0)
            return 0.02 + share * here + 1e-3 * rng.standard_normal(len(s))

        return value

    low, high = (programs.measured(nominal, course(v), z=z) for v, z in ((0.5, -4.0), (-0.5, -1.0)))
    both = Measurement(
        np.concatenate([high.points, low.points]), None, 0.0, np.arange(len(high) + len(low)), "two.csv", "ef" * 32
    )
    result = pipeline.correct(pipeline.Request(program, 5.0, both))
    (said,) = (w for w in result.warnings if "the wall leans" in w)
    found = re.search(
        r"at Z-4.000 it has ([0-9.]+) um more than at Z-1.000 at X([0-9.]+) Y0.000, \+[0-9.]+ um on", said
    )
    assert found is not None, said
    # Three standard uncertainties: 1 um of noise on some ten points of each height, and a tenth that smoothing takes.
    assert float(found[1]) == pytest.approx(12.0, abs=2.0) and float(found[2]) == pytest.approx(50.0, abs=4.0)


def test_ball_centres() -> None:
    program, nominal = nominal_of("mitres")
    s = np.linspace(1.0, 299.0, 250)
    s = s[np.min(np.abs(s[:, None] - [100.0, 150.0, 250.0]), axis=1) > 0.5]
    c, n = nominal.at(0, s)
    centre = Measurement(
        np.column_stack([c + (1.5 + 0.012) * n, np.zeros(len(s))]), None, 1.5, np.arange(len(s)), "b.csv", "00" * 32
    )
    result = pipeline.correct(pipeline.Request(program, 5.0, centre, None, pipeline.Settings(filter="none")))
    assert result.deviation.value == pytest.approx(np.full(len(s), 0.012), abs=1e-9)


def test_wear_compensation_reads_the_centre_path() -> None:
    text = programs.RECTANGLE.replace("G1 X0 Y-5 F300", "G42 D1 G1 X0 Y-5 F300").replace("G1 X0 Y-20", "G40 G1 X0 Y-20")
    program = nc.parse(text, "wear.nc")
    settings = pipeline.Settings(cutter_compensation="wear", filter="none")
    nominal = pipeline.nominal_from_program(program, 5.0, settings, None)
    assert nominal.signed_areas() == pytest.approx([5000.0])
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.01))
    result = pipeline.correct(pipeline.Request(program, 5.0, measurement, None, settings))
    assert b"X104.99" in result.text


def test_opaque_stretches_are_refused_with_their_line() -> None:
    text = programs.RECTANGLE.replace("Y55\n", "Y#500\n")
    program = nc.parse(text, "macro.nc")
    nominal = nominal_of("mitres")[1]
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), 0.01))
    with pytest.raises((FormatError, InputError), match="macro.nc"):
        pipeline.correct(pipeline.Request(program, 5.0, measurement, nominal))


@pytest.mark.parametrize(
    "bad",
    [{"gain": 0.0}, {"limit": -1.0}, {"tolerance": 0.0}, {"filter": "mean:4"}, {"output_moves": "x"}, {"side": "up"}],
)
def test_settings_out_of_range(bad: dict[str, object]) -> None:
    with pytest.raises(UsageError):
        pipeline.Settings(**bad)  # type: ignore[arg-type]


def test_without_measurement_the_path_is_made_exact() -> None:
    nominal = reference_contour()
    program = spline_program(nominal, 5.0, 150)
    result = pipeline.correct(pipeline.Request(program, 5.0, None, nominal))
    assert result.regeneration.original_error > 0.01
    assert result.verification.path_error_max <= 0.001
    span, t = nominal.samples(0.005)
    c, _, _ = nominal.evaluate(span, t)
    p = nc.parse(result.text).toolpath
    p = p.take(np.flatnonzero(result.regeneration.following)).position(np.linspace(0, 1, 9))[:, :, :2].reshape(-1, 2)
    # The nearest sample is at most 0.0025 mm along the curve from the foot point: 0.6 nm farther off than that.
    assert np.abs(cKDTree(c).query(p)[0] - 5.0).max() < 0.001
    assert Point(p[0]).distance(LineString(c)) > 4.9


def test_order_and_direction_of_the_points_do_not_matter() -> None:
    nominal = reference_contour()
    measurement = programs.measured(nominal, lambda k, s: 0.01 + 0.003 * np.sin(4 * np.pi * s / nominal.total[0]))
    order = np.random.default_rng(3).permutation(len(measurement))
    shuffled = Measurement(measurement.points[order].copy(), None, 0.0, measurement.lines[order].copy(), "p", "ab" * 32)
    texts = {
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, m, nominal, pipeline.Settings(filter="mean:5"))).text.split(
            b"\n", 3
        )[3]
        for m in (measurement, shuffled)
    }
    assert len(texts) == 1


@pytest.mark.few(2)
@pytest.mark.parametrize(("word", "side"), [("G2", "left"), ("G3", "right")])
@pytest.mark.parametrize("halves", [False, True])
def test_full_circles_both_ways(word: str, side: str, halves: bool) -> None:
    turn = f"{word} X25 Y0 I-25 J0\n" if not halves else f"{word} X-25 Y0 I-25 J0\n{word} X25 Y0 I25 J0\n"
    program = nc.parse(f"G0 X35 Y0\nG1 Z-5 F200\nG1 X25 F400\n{turn}G1 X35\nG0 Z20\n", "circle.nc")
    nominal = pipeline.nominal_from_program(program, 5.0, pipeline.Settings(side=side), None)
    assert nominal.signed_areas() == pytest.approx([np.pi * 400])
    measurement = programs.measured(nominal, lambda k, s: 0.01 + 0.004 * np.sin(s / 20.0))
    result = pipeline.correct(pipeline.Request(program, 5.0, measurement, None, pipeline.Settings(filter="none")))
    assert result.verification.path_error_max <= 0.001
    # On the last millimetre before a corner, where the correction runs out level, a slope of 0.2 um/mm leaves 0.1 um.
    assert np.abs(result.predicted).max() < 2e-4
    assert np.quantile(np.abs(result.predicted), 0.9) < 5e-5


CHAINED = """G21 G90
G0 X-20 Y-20
G0 Z5
G1 Z-5 F100
G1 X-5.3 Y-5.3 F300
X105.3
Y55.3
X-5.3
Y-5.3
X-5 Y-5
X105
Y55
X-5
Y-5
Y-9
G1 Z5
G1 X200 Y25
G1 Z-5
G3 X200 Y25 I20 J0
G1 Z5
G0 Z20
M30
"""


def test_other_contours_and_roughing_passes_stay_where_they_are() -> None:
    """A roughing pass, the finishing pass and another contour, chained by feed moves; only the second is measured."""
    program = nc.parse(CHAINED, "chained.nc")
    nominal = nominal_of("mitres")[1]
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), -0.15))
    result = pipeline.correct(pipeline.Request(program, 5.0, measurement, nominal, pipeline.Settings(filter="none")))
    text = [line for line in result.text.decode().splitlines() if not line.startswith("(")]
    kept = ["X105.3", "Y55.3", "X-5.3", "G1 X200 Y25", "G3 X200 Y25 I20 J0"]
    assert [line for line in text if line in kept] == kept
    for line in ("X105.15", "Y55.15", "X-5.15"):
        assert line in text
    before, after = program.toolpath, nc.parse(result.text).toolpath
    # The roughing pass ends where it ended; the link to the finishing pass takes up the difference.
    assert after.end[7].tolist() == before.end[7].tolist()

    def plunges(path):
        return int(((path.kind == 1) & (np.abs(path.end - path.start)[:, :2].max(axis=1) == 0)).sum())

    assert plunges(after) == plunges(before)
