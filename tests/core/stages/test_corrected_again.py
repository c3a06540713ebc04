# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that carry a correction are corrected again, up to the limit of a correction and however it varies."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from millcorr import nc, pipeline
from millcorr.errors import LimitError, RefusedError
from millcorr.geometry.correction import Correction
from millcorr.path.earlier_correction import earlier_correction
from millcorr.path.moves import BAND
from millcorr.path.reconstruction import CompensatedContour
from tests.core import loop_programs as programs
from tests.core.sweeps import examples

CASES = {
    # name: (text, tool radius, side of the cutter, distance kept from inner corners)
    "mitres": (programs.RECTANGLE, 5.0, "right", 1.0),
    "rounds": (programs.ROUNDED, 5.0, "right", 1.0),
    "pocket": (programs.POCKET, 5.0, "right", 5.6),
    "helix": (programs.HELIX, 5.0, "right", 1.0),
    "levels": (programs.LEVELS, 5.0, "right", 1.0),
    "tabs": (programs.TABS, 5.0, "right", 1.0),
    "edge": (programs.EDGE, 8.0, "right", 1.0),
    "contour": (programs.CONTOUR_LEFT, 5.0, "right", 1.0),
    "inch": (programs.INCH_INCREMENTAL, 5.08, "right", 1.0),
}
ACCEPTED = ("earlier-program", "constant-offset", "ball-not-compensated", "wrong-side", "misalignment", "scale")
"""Machine errors of this size are none that anybody should correct without a look."""


def start(name: str):
    text, radius, side, clear = CASES[name]
    program = nc.parse(text, f"{name}.nc")
    nominal = pipeline.nominal_from_program(program, radius, pipeline.Settings(side=side), None)
    return program, nominal, radius, clear


def again(program, nominal, radius, deviation, loop, clear=0.0, **chosen):
    measurement = programs.measured(nominal, deviation, clear=clear, digest=f"{loop:02d}" * 32)
    settings = pipeline.Settings(**({"filter": "none", "accept": ACCEPTED} | chosen))
    return pipeline.correct(pipeline.Request(program, radius, measurement, nominal, settings))


def wave(mean: float, swing: float, waves: int, total: float):
    return lambda k, s: mean + swing * np.sin(2 * np.pi * waves * s / total + k)


@pytest.mark.thorough
@settings(max_examples=examples(30), deadline=None, derandomize=True)
@given(
    name=st.sampled_from(sorted(CASES)),
    mean=st.floats(-0.45, 0.45),
    share=st.floats(0.0, 1.0),
    waves=st.integers(1, 2),
    second=st.floats(-0.04, 0.04),
)
@example(name="contour", mean=0.0, share=0.7395780493051004, waves=1, second=0.02134915540026698)
@example(name="levels", mean=0.19125311524629957, share=0.008529386942264907, waves=2, second=0.0)
def test_three_corrections_up_to_the_limit(name: str, mean: float, share: float, waves: int, second: float) -> None:
    """What the program carries is known to a micrometre before the second and the third, and all add up."""
    program, nominal, radius, clear = start(name)
    total = float(nominal.total[0])
    # A side that swings more bulges into a cutter that stands in an inner corner: refused as a gouge at the first part.
    swing = share * min(0.45 - abs(mean), 0.1 if name == "pocket" else 0.45)
    asked = [wave(mean, swing, waves, total), wave(second, 0.003, 1, total), wave(-0.5 * second, 0.005, 1, total)]
    carried: list = []
    for loop, deviation in enumerate(asked):
        result = again(program, nominal, radius, deviation, loop, clear)
        d = result.deviation
        before = -sum((f(0, d.s) for f in carried), np.zeros(len(d)))
        # The path keeps its tolerance of 1 um; between points, 1 mm apart, a spline of such waves errs by far less.
        # Next to an end or a corner the correction runs out level, and the path cuts round corners as it must.
        inside = far_from_corners(nominal, d, radius)
        assert np.abs(result.commanded - before)[inside].max() < 0.003
        assert result.verification.path_error_max <= 0.001
        assert not d.rejected
        carried.append(deviation)
        wanted = -sum(f(0, d.s) for f in carried)
        got = result.correction.at(d.stretch, d.s, nominal)
        assert np.abs(got - wanted)[inside].max() < 0.003
        program = nc.parse(result.text, f"loop{loop}.nc")


def far_from_corners(nominal, d, radius):
    stretches = nominal.stretches()
    inside = np.ones(len(d), dtype=bool)
    for k, one in enumerate(stretches):
        if not one.closed:
            local = np.mod(d.s - one.begin, nominal.total[one.contour])
            inside &= (d.stretch != k) | ((local > 3.0) & (local < one.length - 3.0))
    return inside


def chained(stock: float) -> str:
    """A roughing pass `stock` mm off, then the finishing pass, in one go, about 100 x 50."""
    low, right, top = -5 - stock, 105 + stock, 55 + stock
    return (
        f"G21 G90\nG0 X-20 Y-20\nG0 Z5\nG1 Z-5 F100\nG1 X{low:.3f} Y{low:.3f} F300\nX{right:.3f}\nY{top:.3f}\n"
        f"X{low:.3f}\nY{low:.3f}\nX-5 Y-5\nX105\nY55\nX-5\nY-5\nY-9\nG0 Z20\nM30\n"
    )


@settings(max_examples=examples(12), deadline=None, derandomize=True)
@given(mean=st.floats(-0.15, 0.4), share=st.floats(0.0, 1.0))
def test_a_roughing_pass_is_never_taken_for_the_finishing_pass(mean: float, share: float) -> None:
    """0.3 mm of stock: whatever the finishing pass carries, the roughing pass keeps its every word."""
    _, nominal, _, _ = start("mitres")
    program = nc.parse(chained(0.3), "chained.nc")
    roughing = [line for line in chained(0.3).splitlines() if ".3" in line]
    total = float(nominal.total[0])
    swing = share * min(0.45 - abs(mean), mean + 0.15)
    for loop, deviation in enumerate((wave(mean, swing, 1, total), wave(0.004, 0.0, 1, total))):
        result = again(program, nominal, 5.0, deviation, loop, 1.0)
        lines = result.text.decode().splitlines()
        assert [line for line in lines if ".3" in line and line in roughing] == roughing
        # Four sides that grow or shrink by the correction, and the 4 mm behind the seam; the roughing pass has 342.4.
        cut = result.regeneration.toolpath.take(np.flatnonzero(result.regeneration.following))
        assert float(np.nansum(cut.length())) == pytest.approx(2 * (110 + 60) + 4, abs=8 * 0.46)
        program = nc.parse(result.text, f"loop{loop}.nc")


def test_without_a_mark_nothing_is_looked_for_beyond_the_band() -> None:
    """The roughing pass of an uncorrected program, alone, follows nothing; with a mark it would."""
    program, nominal, _, _ = start("mitres")
    high = nc.parse(programs.RECTANGLE.replace("-5", "-5.3").replace("105", "105.3").replace("55", "55.3"), "high.nc")
    with pytest.raises(LimitError, match=r"no move of the program follows the profile at 5 mm: .* 0\.300 mm off"):
        again(high, nominal, 5.0, wave(0.01, 0.0, 1, 300.0), 0)
    plain = CompensatedContour(nominal, Correction.none(nominal))
    everything = np.ones(len(high.toolpath), dtype=bool)
    carried = earlier_correction(high.toolpath, plain, 5.0, everything, band=BAND, reach=0.6)
    s = np.linspace(0.0, 299.0, 50)
    stretch = np.searchsorted([100.0, 150.0, 250.0], s)
    assert carried.at(stretch, s, nominal) == pytest.approx(np.full(50, 0.3), abs=1e-9)


def test_a_step_at_another_height_is_not_guessed() -> None:
    """Two passes off the nominal, the deeper one higher up: a correction or a rebate, nobody can tell."""
    _, nominal, _, _ = start("mitres")
    text = "(millcorr 0.1 corrected 2026-01-01 measurement " + "ef" * 8 + " source " + "01" * 8 + ")\n"
    text += "G0 X-20 Y-4.7\nG1 Z-2 F100\nX104.7 F300\nY54.7\nX-4.7\nY-4.7\nX0\nG0 Z5\n"
    text += "G0 X-20 Y-4.85\nG1 Z-5 F100\nX104.85 F300\nY54.85\nX-4.85\nY-4.85\nX0\nG0 Z5\n"
    program = nc.parse(text, "rebate.nc")
    with pytest.raises(LimitError, match=r"-0\.300 mm off the profile at Z-2\.000 and -0\.150 mm off it at Z-5"):
        again(program, nominal, 5.0, wave(0.01, 0.0, 1, 300.0), 0)


@pytest.mark.few(1)
@pytest.mark.parametrize("depth", [2.0, 4.0])
def test_transfer_function_three_times(depth: float) -> None:
    """An elastic machine of MS 0.055: one correction of -MS H takes all out; what is carried then changes nothing."""
    program, nominal, radius, _ = start("rounds")
    ms, carried = 0.055, 0.0
    for loop in range(3):
        left = carried + ms / (1 + ms) * (depth - carried)
        measured = wave(left, 0.002, 1 + loop, float(nominal.total[0]))
        result = again(program, nominal, radius, measured, loop, 1.0, method="transfer", depth=depth)
        d = result.deviation
        carried = float(result.correction.at(d.stretch, d.s, nominal).mean())
        assert carried == pytest.approx(-ms * depth, abs=1e-4)
        assert result.verification.path_error_max <= 0.001
        program = nc.parse(result.text, f"loop{loop}.nc")


def test_one_side_alone_is_moved_with_its_corners() -> None:
    """Neighbours that lie where they should end at the moved corner: one word changes, and no move is added."""
    program, nominal, _, _ = start("mitres")
    result = again(program, nominal, 5.0, lambda k, s: np.where((s > 100) & (s < 150), 0.02, 0.0), 0)
    words = [line for line in result.text.decode().splitlines() if not line.startswith("(")]
    before = programs.RECTANGLE.splitlines()
    assert len(words) == len(before)
    changed = [
        new for new, old in zip(words, before, strict=True) if new.removeprefix("G1 ") != old.removeprefix("G1 ")
    ]
    assert changed == ["G1 X104.98"]


def test_checking_a_measurement_that_was_applied_warns_and_shows_it_as_it_was() -> None:
    """`check` writes nothing, so it may look; `correct` refuses. The deviations are those of the first look."""
    program, nominal, radius, _ = start("mitres")
    swell = wave(0.3, 0.05, 1, 300.0)
    first = again(program, nominal, radius, swell, 0)
    carrying = nc.parse(first.text, "corrected.nc")
    request = pipeline.Request(carrying, radius, first.request.measurement, nominal, first.request.settings)
    with pytest.raises(RefusedError, match="applied on"):
        pipeline.correct(request)
    seen = pipeline.correct(request, check=True)
    assert any("carries the correction from this measurement already" in w for w in seen.warnings)
    assert seen.deviation.value == pytest.approx(first.deviation.value, abs=1e-12)
    # As if the program carried nothing: the same correction as the one that it carries, not twice as much.
    assert seen.correction.largest == pytest.approx(first.correction.largest, abs=1e-9)
    assert np.abs(seen.commanded).max() == 0.0
