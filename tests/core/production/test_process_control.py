# SPDX-License-Identifier: LGPL-2.1-or-later
"""When a series is corrected: the published sequence, the properties of the average, and the order of the limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from millcorr.errors import LimitError, UsageError
from millcorr.production.process_control import Control, decide, refuse_beyond, weights

UM = 1e-3
lengths = st.floats(-0.3, 0.3)
kept = st.floats(1, 50)


def ewma(z, deviation, weight):
    """One part further."""
    (own,), rest = weights(1, weight)
    return own * np.asarray(deviation) + rest * np.asarray(z)


def run(sizes, control):
    """Smoothed values and decisions of parts that follow each other, one place."""
    z, out = np.zeros(()), []
    for size in sizes:
        decision = decide(ewma(z, size, control.weight), size, control)
        z = decision.state
        out.append((float(decision.smoothed), decision.kind))
    return out


def test_the_sequence_of_the_requirement():
    control = Control(2, 4 * UM)
    seen = run(np.array([3, 5, 6, 2, 4, 5, 5, 3, 7, 7]) * UM, control)
    assert [z / UM for z, _ in seen] == pytest.approx(
        [1.5, 3.25, 4.625, 1, 2.5, 3.75, 4.375, 1.5, 4.25, 3.5], abs=1e-12
    )
    assert [number for number, (_, kind) in enumerate(seen, 1) if kind == "smoothed"] == [3, 7, 9]
    assert {kind for _, kind in seen} == {"keep", "smoothed"}


def test_along_the_contour_each_place_is_smoothed_and_one_of_them_decides():
    control = Control(2, 4 * UM)
    d = np.array([3, -3, 1]) * UM
    first = decide(d / 2, d, control)
    assert first.kind == "keep"
    assert first.state / UM == pytest.approx([1.5, -1.5, 0.5])
    d = np.array([1, -8, 1]) * UM
    second = decide(ewma(first.state, d, 2), d, control)
    assert second.kind == "smoothed"
    assert second.smoothed / UM == pytest.approx([1.25, -4.75, 0.75])
    assert not second.state.any()


@given(st.lists(lengths, min_size=1, max_size=30), kept, lengths)
def test_the_average_is_the_sum_of_its_weights(sizes, weight, begun):
    """z_n = sum of D_i (1/k) (1 - 1/k)^(n - i) + z_0 (1 - 1/k)^n: the same step by step and at once."""
    z = begun
    for size in sizes:
        z = ewma(z, size, weight)
    own, rest = weights(len(sizes), weight)
    assert float(z) == pytest.approx(float(own @ sizes + rest * begun), abs=1e-12)
    assert own.sum() + rest == pytest.approx(1.0, abs=1e-12) and (np.diff(own) >= 0).all()


@given(hnp.arrays(float, 5, elements=lengths), hnp.arrays(float, 5, elements=lengths), kept)
def test_the_average_lies_between_what_was_and_what_is(z, d, weight):
    out = ewma(z, d, weight)
    assert (out >= np.minimum(z, d) - 1e-15).all() and (out <= np.maximum(z, d) + 1e-15).all()


@given(hnp.arrays(float, 4, elements=lengths), hnp.arrays(float, 4, elements=lengths), kept, st.floats(0.1, 9))
def test_the_average_is_linear_and_places_do_not_mix(z, d, weight, factor):
    assert np.allclose(ewma(factor * z, factor * d, weight), factor * ewma(z, d, weight), atol=1e-13)
    assert ewma(z[2], d[2], weight) == ewma(z, d, weight)[2]


@given(st.lists(st.floats(-4e-3, 4e-3), min_size=1, max_size=40), kept)
def test_parts_within_the_limit_never_lead_to_a_correction(sizes, weight):
    assert {kind for _, kind in run(sizes, Control(weight, 4.0000001e-3))} == {"keep"}


@given(st.floats(4.2e-3, 0.1), kept, st.sampled_from([-1, 1]))
def test_a_lasting_deviation_beyond_the_limit_is_corrected_when_the_average_reaches_it(size, weight, sign):
    """Closed form: z_n = D (1 - (1 - 1/k)^n) passes the limit L at the first n with (1 - 1/k)^n < 1 - L/D."""
    limit = 4e-3
    rest = 1 - 1 / weight
    due = 1 if rest == 0 else math.floor(math.log(1 - limit / size) / math.log(rest)) + 1
    kinds = [kind for _, kind in run([sign * size] * (due + 1), Control(weight, limit))]
    first = kinds.index("smoothed") + 1
    # Where the average meets the limit exactly rounding decides.
    exactly = abs(size * (1 - rest ** (due - 1)) - limit) < 1e-12 or abs(size * (1 - rest**due) - limit) < 1e-12
    assert first == due or exactly


def test_the_first_part_of_an_uncorrected_program_is_corrected_by_its_own_deviation():
    control = Control(4, 4 * UM)
    first = decide(5 * UM, 5 * UM, control, alone=True)
    assert first.kind == "direct" and "first correction" in first.reason and first.state == 0
    kept = decide(3 * UM, 3 * UM, control, alone=True)
    assert kept.kind == "keep" and float(kept.state) == pytest.approx(3 * UM)
    assert decide(5 * UM, 5 * UM, control).kind == "smoothed"


def test_tolerance_alarm_abort():
    control = Control(4, 4 * UM, dead_band=UM, tolerance=10 * UM, alarm=30 * UM, abort=100 * UM)
    assert decide(-9 / 4 * UM, -9 * UM, control).kind == "keep"
    beyond = decide(-2 * UM, -11 * UM, control)
    assert beyond.kind == "direct" and beyond.state == 0 and "11.00 um" in beyond.reason
    with pytest.raises(LimitError, match="--control-alarm 0.03: .*--accept difference"):
        decide(0.0, 31 * UM, control)
    assert decide(0.0, 31 * UM, control, accepted=True).kind == "direct"
    with pytest.raises(LimitError, match="--control-abort 0.1: this cannot be a part"):
        decide(0.0, 101 * UM, control, accepted=True)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"dead_band": 4 * UM}, "--dead-band 0.004 must be below --control-limit 0.004"),
        ({"tolerance": 3 * UM}, "--control-limit 0.004 must be below --control-tolerance 0.003"),
        ({"tolerance": 9 * UM, "alarm": 8 * UM}, "--control-tolerance 0.009 must be below --control-alarm 0.008"),
        ({"tolerance": 9 * UM, "abort": 9 * UM}, "--control-tolerance 0.009 must be below --control-abort"),
        ({"alarm": 2 * UM}, "--control-limit 0.004 must be below --control-alarm"),
        ({"step_limit": 0.0}, "--step-limit 0: must be above 0"),
        ({"sum_limit": math.nan}, "--sum-limit nan: must be above 0"),
        ({"step_limit": 0.2, "sum_limit": 0.1}, "--step-limit 0.2 must not be above --sum-limit 0.1"),
        ({"dead_band": -1.0}, "--dead-band -1: must not be negative"),
    ],
)
def test_limits_out_of_order_are_refused(options, said):
    with pytest.raises(UsageError, match=said):
        Control(2, 4 * UM, **options)


@pytest.mark.parametrize("weight", [0.99, 0.0, -2.0, math.nan, math.inf])
def test_weights_that_smooth_nothing_sensible_are_refused(weight):
    with pytest.raises(UsageError, match="K must be 1 or more"):
        Control(weight, 4 * UM)


def test_the_text_of_the_option():
    assert Control.parse("ewma:2") == 2 and Control.parse(" EWMA:2.5 ") == 2.5
    for text in ("ewma", "ewma:", "ewma:two", "mean:2", ""):
        with pytest.raises(UsageError, match="write ewma:K"):
            Control.parse(text)


def test_steps_and_sums_beyond_their_limits_are_refused_whole():
    control = Control(2, 4 * UM, step_limit=0.01, sum_limit=0.05)
    refuse_beyond(control, np.array([0.01, -0.01]), -0.05)
    with pytest.raises(LimitError, match="10.01 um, more than --step-limit 0.01:"):
        refuse_beyond(control, np.array([0.0, -0.01001]), 0.0)
    with pytest.raises(LimitError, match="50.10 um, more than --sum-limit 0.05:"):
        refuse_beyond(control, 0.0, 0.0501)
