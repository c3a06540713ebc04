# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from millcorr.errors import InputError
from millcorr.geometry.nurbs import NurbsCurve
from tests.core.sweeps import examples

angles = st.floats(0.01, 2 * np.pi) | st.floats(-2 * np.pi, -0.01)


@given(
    centre=st.tuples(st.floats(-500, 500), st.floats(-500, 500)),
    radius=st.floats(0.1, 300),
    first=st.floats(-7, 7),
    sweep=angles,
)
def test_arc_is_a_circle(centre, radius, first, sweep):
    c = np.array(centre)
    start = c + radius * np.array([np.cos(first), np.sin(first)])
    end = c + radius * np.array([np.cos(first + sweep), np.sin(first + sweep)])
    arc = NurbsCurve.arc(start, end, c, sweep)
    p = arc.evaluate(np.linspace(0, 1, 97)) - c
    np.testing.assert_allclose(np.hypot(*p.T), radius, rtol=1e-12, atol=1e-12)
    turned = np.diff(np.unwrap(np.arctan2(p[:, 1], p[:, 0])))
    assert (np.sign(turned) == np.sign(sweep)).all()
    assert turned.sum() == pytest.approx(sweep, abs=1e-9 * max(1, 500 / radius))
    np.testing.assert_array_equal(arc.evaluate([0.0])[0], start)
    np.testing.assert_array_equal(arc.evaluate([1.0])[0], end)


def test_line():
    line = NurbsCurve.line((1, 2), (4, 6))
    np.testing.assert_allclose(line.evaluate([0, 0.25, 1]), [[1, 2], [1.75, 3], [4, 6]], rtol=1e-15)
    np.testing.assert_allclose(line.evaluate([-1, 2]), [[1, 2], [4, 6]])


def random_curve(rng, degree, count, periodic, rational):
    poles = rng.uniform(-50, 50, (count, 2))
    weights = rng.uniform(0.3, 3, count) if rational else np.ones(count)
    if periodic:
        mult = []
        while sum(mult) < count:
            mult.append(int(rng.integers(1, min(degree, count - sum(mult)) + 1)))
        mult = [*mult, mult[0]]
    else:
        mult = [degree + 1]
        while sum(mult) < count:
            mult.append(int(rng.integers(1, min(degree, count - sum(mult)) + 1)))
        mult = [*mult, degree + 1]
    knots = np.cumsum(rng.uniform(0.2, 1.5, len(mult)))
    return NurbsCurve(degree, poles, weights, knots, np.array(mult), periodic)


@settings(max_examples=examples(80), deadline=None)
@given(
    seed=st.integers(0, 2**32),
    degree=st.integers(1, 5),
    extra=st.integers(1, 12),
    periodic=st.booleans(),
    rational=st.booleans(),
)
def test_evaluation_against_scipy(seed, degree, extra, periodic, rational):
    curve = random_curve(np.random.default_rng(seed), degree, degree + extra, periodic, rational)
    u = np.linspace(curve.knots[0], curve.knots[-1], 203)[1:-1]
    flat = curve.flat_knots
    count = len(flat) - degree - 1
    homogeneous = np.column_stack([curve.poles * curve.weights[:, None], curve.weights])
    wanted = BSpline(flat, homogeneous[np.arange(count) % len(homogeneous)], degree)(u)
    np.testing.assert_allclose(curve.evaluate(u), wanted[:, :2] / wanted[:, 2:], atol=1e-10)


@settings(max_examples=examples(60), deadline=None)
@given(seed=st.integers(0, 2**32), degree=st.integers(1, 5), extra=st.integers(2, 12), rational=st.booleans())
def test_a_periodic_curve_closes_on_itself(seed, degree, extra, rational):
    curve = random_curve(np.random.default_rng(seed), degree, degree + extra, True, rational)
    bounds, points = curve.bezier()
    assert bounds[0] == curve.knots[0] and bounds[-1] == curve.knots[-1]
    first, last = points[0, 0], points[-1, -1]
    np.testing.assert_allclose(first, last, atol=1e-10)
    flat = curve.flat_knots
    period = curve.knots[-1] - curve.knots[0]
    assert len(flat) == len(np.repeat(curve.knots, curve.multiplicities)) + 2 * (degree + 1 - curve.multiplicities[0])
    # The knots before the start repeat the ones before the end.
    low = flat[flat < curve.knots[0]]
    np.testing.assert_allclose(low, flat[(flat < curve.knots[-1])][-len(low) :] - period if len(low) else low)


@settings(max_examples=examples(60), deadline=None)
@given(
    seed=st.integers(0, 2**32),
    degree=st.integers(1, 5),
    extra=st.integers(1, 12),
    periodic=st.booleans(),
    rational=st.booleans(),
)
def test_reversed_runs_through_the_same_points(seed, degree, extra, periodic, rational):
    curve = random_curve(np.random.default_rng(seed), degree, degree + extra, periodic, rational)
    back = curve.reversed()
    u = np.linspace(curve.knots[0], curve.knots[-1], 101)[1:-1]
    np.testing.assert_allclose(back.evaluate(curve.knots[0] + curve.knots[-1] - u), curve.evaluate(u), atol=1e-9)
    np.testing.assert_allclose(back.reversed().evaluate(u), curve.evaluate(u), atol=1e-9)


def test_as_dict_and_back():
    curve = random_curve(np.random.default_rng(3), 3, 9, True, True)
    other = NurbsCurve.from_dict(curve.as_dict())
    u = np.linspace(curve.knots[0], curve.knots[-1], 50)
    np.testing.assert_array_equal(other.evaluate(u), curve.evaluate(u))
    data = curve.as_dict()
    del data["knots"]
    with pytest.raises(InputError):
        NurbsCurve.from_dict(data)


@pytest.mark.parametrize(
    "change",
    [
        {"degree": 0},
        {"poles": np.zeros((4, 3))},
        {"weights": np.array([1.0, 1, 0, 1])},
        {"weights": np.ones(3)},
        {"knots": np.array([1.0, 0.0])},
        {"multiplicities": np.array([4, 3])},
        {"poles": np.full((4, 2), np.nan)},
        {"periodic": True},
    ],
)
def test_contradictions(change):
    good = {
        "degree": 3,
        "poles": np.arange(8.0).reshape(4, 2),
        "weights": np.ones(4),
        "knots": np.array([0.0, 1.0]),
        "multiplicities": np.array([4, 4]),
    }
    NurbsCurve(**good)
    if change == {"periodic": True}:
        change = {"periodic": True, "multiplicities": np.array([3, 3])}
    with pytest.raises(InputError):
        NurbsCurve(**{**good, **change})


def test_arrays_cannot_be_written():
    curve = NurbsCurve.line((0, 0), (1, 0))
    with pytest.raises(ValueError):
        curve.poles[0, 0] = 5
