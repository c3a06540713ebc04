# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several parts of the same nominal: mean, spread, and what is left after one correction."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.comparison.deviation import deviations
from millcorr.errors import InputError, RefusedError, UsageError
from millcorr.readers.measurement import Measurement
from millcorr.separation.parts import averaged
from millcorr.virtual.simulated_machine import SimulatedMachine, reference_contour
from tests.core.loop_programs import measured
from tests.core.stages.test_pipeline import PROGRAM, nominal_of
from tests.core.sweeps import slow

NOMINAL = reference_contour()
SIGMA = 0.0015


def parts_of(count: int, seed: int = 0, points: int = 200) -> tuple[Measurement, ...]:
    machine = SimulatedMachine(errors=SimulatedMachine.reference().errors, process_noise=SIGMA, measurement_noise=0.0)
    seeds = range(100 * seed, 100 * seed + count)
    return tuple(machine.follow(NOMINAL, seed=k).measure(points, noise=0.0, seed=k) for k in seeds)


def test_mean_and_spread_of_known_parts() -> None:
    wave = [lambda k, s, a=a: a + 0.002 * np.sin(4 * np.pi * s / NOMINAL.total[0]) for a in (0.010, 0.012, 0.017)]
    seen = []
    for number, deviation in enumerate(wave):
        d = deviations(measured(NOMINAL, deviation, spacing=0.5 + 0.1 * number), NOMINAL)
        seen.append((d, d.value))
    result = averaged(seen, NOMINAL)
    assert (result.count == 3).all()
    # Linear interpolation errs by h^2/8 times the second derivative: 0.7^2/8 * 0.002 * (4 pi/224)^2.
    assert result.mean == pytest.approx(seen[0][1] + 0.003, abs=1e-6)
    assert result.std == pytest.approx(np.std([10, 12, 17], ddof=1) / 1000, abs=1e-6)


def test_the_spread_is_the_random_part() -> None:
    result = pipeline.correct(
        pipeline.Request(PROGRAM, 5.0, parts_of(5)[0], NOMINAL, pipeline.Settings(filter="none"), parts_of(5)[1:])
    )
    # 200 places, 4 degrees of freedom each: the estimate scatters by 1/sqrt(2 * 800) = 2.5 %; points at the same
    # places, so nothing is interpolated.
    assert result.random_std == pytest.approx(SIGMA, rel=0.08)
    assert result.warnings == () and result.summary()["points"]["parts"] == 5
    again = nc.parse(result.text, "again.nc")
    for part in parts_of(5):
        with pytest.raises(RefusedError, match="applied on"):
            pipeline.correct(pipeline.Request(again, 5.0, part, NOMINAL))


@pytest.mark.few(1)
@pytest.mark.parametrize("trials", [3, slow(8)])
@pytest.mark.parametrize("count", [1, 4])
def test_averaging_lowers_what_is_left(count: int, trials: int) -> None:
    """Raw data of n parts leave sigma_r * sqrt(1 + 1/n).

    The variance of 200 places scatters by 1/sqrt(100) = 10 %, so the root of 1 and it by 2.5 % a trial at most;
    the mean of 8 by 0.9 %, of which somewhat more than four are allowed.
    """
    ratio = []
    for seed in range(trials):
        first, *further = parts_of(count, seed)
        result = pipeline.correct(
            pipeline.Request(PROGRAM, 5.0, first, NOMINAL, pipeline.Settings(filter="none"), tuple(further))
        )
        shift = result.correction.at(result.deviation.stretch, result.deviation.s, NOMINAL)
        truth = SimulatedMachine(errors=SimulatedMachine.reference().errors).follow(NOMINAL, seed=1)
        left = truth.deviation(0, result.deviation.s) + shift
        ratio.append(np.sqrt(SIGMA**2 + left.var()) / SIGMA)
    assert np.mean(ratio) == pytest.approx(np.sqrt(1 + 1 / count), rel=0.04 * np.sqrt(8 / trials))


def test_parts_measured_elsewhere_cannot_be_averaged() -> None:
    program, nominal = nominal_of("edge")
    whole = measured(nominal, lambda k, s: np.full(len(s), 0.01))
    left, right = whole.points[:20].copy(), whole.points[80:].copy()
    make = [Measurement(p, None, 0.0, np.arange(len(p)), "p.csv", d * 64) for p, d in ((left, "a"), (right, "b"))]
    settings = pipeline.Settings(filter="none", accept=("unmeasured",))
    with pytest.raises(InputError, match="other places"):
        pipeline.correct(pipeline.Request(program, 8.0, make[0], None, settings, (make[1],)))


def test_the_same_part_twice_is_no_average() -> None:
    one = parts_of(1)[0]
    with pytest.raises(UsageError, match="given twice"):
        pipeline.correct(pipeline.Request(PROGRAM, 5.0, one, NOMINAL, pipeline.Settings(), (one,)))
