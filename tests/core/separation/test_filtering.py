# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.errors import InputError, UsageError
from millcorr.separation import Filter, filtered
from millcorr.separation.gaussian_regression import ALPHA, local_line, local_line_on_grid
from tests.core.sweeps import examples

KINDS = ["none", "mean:5", "mean:1,2,3,2,1", "gauss:9", "robust:9"]


def run(s, d, text, *, length, closed):
    return filtered(s, d, length=length, closed=closed, filter=Filter.parse(text))


def operator(s, text, *, length, closed):
    """The matrix of a linear filter, column by column."""
    return np.stack([run(s, unit, text, length=length, closed=closed).determined for unit in np.eye(len(s))], axis=1)


# --- parsing


@pytest.mark.parametrize(
    "text", ["", "mean", "mean:4", "mean:1,2", "mean:1,-2,1", "mean:0", "mean:1,nan,1", "gauss:0", "gauss:-1",
             "gauss:x", "gauss:1,2", "robust:", "auto:3", "none:", "nan"]
)  # fmt: skip
def test_illegal_filters_are_usage_errors(text):
    with pytest.raises(UsageError, match="legal filters"):
        Filter.parse(text)


@pytest.mark.parametrize("text", KINDS)
def test_text_of_a_filter_reads_back(text):
    assert Filter.parse(str(Filter.parse(text))) == Filter.parse(text)


def test_five_ones():
    assert Filter.parse("mean:5").mask == (1.0,) * 5


# --- input


@pytest.mark.parametrize(
    ("s", "d"), [([], []), ([0, 1], [0]), ([0, math.nan], [0, 0]), ([0, 1], [0, math.inf]), ([0, 99], [0, 0])]
)
def test_input_that_cannot_be_used(s, d):
    with pytest.raises(InputError):
        run(s, d, "none", length=10.0, closed=False)


@pytest.mark.parametrize("text", KINDS)
@pytest.mark.parametrize("closed", [True, False])
def test_single_point_is_taken_as_it_is(text, closed):
    result = run([3.0], [0.25], text, length=10.0, closed=closed)
    assert result.determined == pytest.approx([0.25], rel=1e-15)
    assert math.isnan(result.random_std)
    assert "single point" in result.warnings[-1]


@pytest.mark.parametrize("text", KINDS)
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("n", range(2, 14))
def test_few_points(text, closed, n):
    rng = np.random.default_rng(n)
    s = rng.uniform(0, 10, n)
    result = run(s, rng.normal(size=n), text, length=10.0, closed=closed)
    assert np.isfinite(result.determined).all()
    # Under a distrusted point at an end the line is extrapolated, which may cost more than the point itself.
    assert 0.0 < result.variance_factor < (2.0 if text == "robust:9" else 1.0 + 1e-9)


# --- moving average


def test_moving_average_by_hand():
    # Werner 2018, eqs. (4)(5): mask 1,2,1 over 1, 5, 9, 3.
    d = [1.0, 5.0, 9.0, 3.0]
    closed = run([0, 1, 2, 3], d, "mean:1,2,1", length=4.0, closed=True)
    np.testing.assert_allclose(closed.determined, [10 / 4, 20 / 4, 26 / 4, 16 / 4], rtol=1e-15)
    opened = run([0, 1, 2, 3], d, "mean:1,2,1", length=3.0, closed=False)
    np.testing.assert_allclose(opened.determined, [7 / 3, 20 / 4, 26 / 4, 15 / 3], rtol=1e-15)


@pytest.mark.parametrize("waves", [1, 7, 20, 40, 63])
def test_moving_average_transmits_by_the_dirichlet_kernel(waves):
    n, m = 200, 5
    s = np.arange(n) * 1.12
    wave = np.cos(2 * np.pi * waves * np.arange(n) / n + 0.4)
    x = np.pi * waves / n
    transmission = math.sin(m * x) / (m * math.sin(x))
    result = run(s, wave, "mean:5", length=n * 1.12, closed=True)
    np.testing.assert_allclose(result.determined, transmission * wave, atol=1e-14)


def test_mean_of_five_keeps_a_fifth_of_the_variance():
    rng = np.random.default_rng(5)
    result = run(np.arange(20000.0), rng.normal(size=20000), "mean:5", length=20000.0, closed=True)
    assert result.variance_factor == pytest.approx(0.2, abs=1e-12)
    # Sampling error of a variance, correlated over 5: sqrt(2 * 3.4 / 20000) = 1.8 %; 4 of them.
    assert np.var(result.determined) == pytest.approx(0.2, rel=0.074)
    # sqrt(1 / (2 * 20000)) = 0.5 %, twice that for the correlation.
    assert result.random_std == pytest.approx(1.0, rel=0.03)


def test_uneven_spacing_is_said():
    s = np.array([0.0, 1, 2, 3, 7, 8])
    assert "unevenly spaced" in run(s, s, "mean:3", length=8.0, closed=False).warnings[0]
    assert not run(np.arange(9.0), np.ones(9), "mean:3", length=9.0, closed=True).warnings


def test_mask_longer_than_the_row():
    d = np.array([1.0, 2.0, 6.0, 3.0])
    closed = run(np.arange(4.0), d, "mean:9", length=4.0, closed=True)
    np.testing.assert_allclose(closed.determined, [2.0, 3.0, 11 / 3, 10 / 3])
    assert "cut to" in closed.warnings[0]
    opened = run(np.arange(4.0), d, "mean:9", length=3.0, closed=False)
    np.testing.assert_allclose(opened.determined, [3.0] * 4)


def test_truncated_mask_that_sums_to_nothing():
    # At the first point only -1, 1 is left of 3,-1,1 ... its mirror at the last one keeps 3,-1.
    result = run(np.arange(4.0), [1.0, 2.0, 4.0, 8.0], "mean:3,-1,1", length=3.0, closed=False)
    assert result.determined[0] == pytest.approx(1.0)
    assert result.determined[3] == pytest.approx((3 * 4.0 - 8.0) / 2)
    assert any("sums to 0" in warning for warning in result.warnings)
    assert any("not symmetric" in warning for warning in result.warnings)


def test_long_masks_agree_with_short_ones():
    rng = np.random.default_rng(0)
    s, d = np.arange(300.0), rng.normal(size=300)
    padded = "mean:" + ",".join(["0"] * 40 + ["1"] * 5 + ["0"] * 40)
    for closed in (True, False):
        np.testing.assert_allclose(
            run(s, d, padded, length=300.0, closed=closed).determined,
            run(s, d, "mean:5", length=300.0, closed=closed).determined,
            atol=1e-13,
        )


def test_half_transmission_is_named():
    # sin(5x) / (5 sin x) = 0.5 at x = 0.3835..., so 8.19 spacings.
    x = 0.3
    for _ in range(60):
        x -= (math.sin(5 * x) / (5 * math.sin(x)) - 0.5) / -3.0
    text = run(np.arange(50.0), np.zeros(50), "mean:5", length=50.0, closed=True).description
    assert f"wavelength of {np.pi / x:.3g} mm" in text
    assert "nothing below 2 mm" in text


# --- Gaussian


@pytest.mark.parametrize("ratio", [0.5, 0.8, 1.0, 1.5, 4.0])
def test_gaussian_transmission(ratio):
    # ISO 16610-21: exp(-pi (alpha cutoff / wavelength)^2), one half at the cutoff.
    n, waves = 240, 6
    s = np.arange(n) * 0.5
    wavelength = 120.0 / waves
    wave = np.sin(2 * np.pi * s / wavelength + 0.3)
    cutoff = wavelength / ratio
    result = run(s, wave, f"gauss:{cutoff}", length=120.0, closed=True)
    transmission = math.exp(-math.pi * (ALPHA / ratio) ** 2)
    # Sampling the weighting function every h adds 2 exp(-pi (alpha cutoff / h)^2) < 1e-40.
    np.testing.assert_allclose(result.determined, transmission * wave, atol=1e-9)
    if ratio == 1.0:
        assert transmission == pytest.approx(0.5, rel=1e-15)


@pytest.mark.parametrize("text", ["gauss:8", "gauss:500", "robust:8"])
def test_straight_line_is_left_alone_at_open_ends(text):
    rng = np.random.default_rng(3)
    s = rng.uniform(0, 100, 80)
    line = 0.004 + 2e-4 * s
    result = run(s, line, text, length=100.0, closed=False)
    np.testing.assert_allclose(result.determined, line, atol=1e-10)


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("cutoff", [0.3, 3.0, 30.0, 80.0, 250.0])
def test_sums_against_the_full_matrix(closed, cutoff):
    rng = np.random.default_rng(7)
    n, length = 250, 100.0
    s = np.sort(rng.uniform(0, length, n))
    d, w = rng.normal(size=n), rng.uniform(0.5, 1.5, n)
    s0 = s1 = s2 = 0.0
    kernels = []
    for image in range(-20, 21) if closed else [0]:
        u = s[None, :] - s[:, None] + image * length
        g = w * np.exp(-np.pi * (u / (ALPHA * cutoff)) ** 2)
        kernels.append((u, g))
        s0, s1, s2 = s0 + g.sum(1), s1 + (g * u).sum(1), s2 + (g * u * u).sum(1)
    full = sum(g * (s2[:, None] - s1[:, None] * u) for u, g in kernels) / (s0 * s2 - s1 * s1)[:, None]
    fit = local_line(s, d, w, cutoff=cutoff, length=length, closed=closed)
    # Truncation at exp(-5.25^2) = 1e-12, against a determinant of no less than 1e-8.
    np.testing.assert_allclose(fit.values, full @ d, atol=1e-8)
    np.testing.assert_allclose(fit.own_weight, np.diag(full), atol=1e-8)
    np.testing.assert_allclose(fit.squared_weights, (full**2).sum(1), atol=1e-8)


def test_many_points_to_a_box_against_pairs():
    rng = np.random.default_rng(8)
    s = np.sort(rng.uniform(0, 50, 4000))
    d = rng.normal(size=4000)
    u = s[None, :] - s[1000:1010, None]
    u -= 50.0 * np.round(u / 50.0)
    g = np.exp(-np.pi * (u / (ALPHA * 5.0)) ** 2)
    s0, s1, s2 = g.sum(1), (g * u).sum(1), (g * u * u).sum(1)
    expected = (s2 * (g @ d) - s1 * ((g * u) @ d)) / (s0 * s2 - s1**2)
    fit = local_line(s, d, np.ones(4000), cutoff=5.0, length=50.0, closed=True)
    np.testing.assert_allclose(fit.values[1000:1010], expected, atol=1e-10)


def test_gaussian_is_an_integral_not_a_count():
    # Twice as many points over one half must not pull the wave: compare with the even sampling.
    even = np.arange(100) * 1.0
    s = np.sort(np.append(even, even[:50] + 0.5))

    def wave(x):
        return np.cos(2 * np.pi * x / 50)

    result = run(s, wave(s), "gauss:20", length=100.0, closed=True)
    transmission = math.exp(-math.pi * (ALPHA * 20 / 50) ** 2)
    # The cells change size twice: an error of a few (h/wavelength)^2 = 4e-4 of the amplitude is left.
    np.testing.assert_allclose(result.determined, transmission * wave(s), atol=2e-3)


@pytest.mark.parametrize("text", ["mean:5", "mean:-1,3,-1", "gauss:7", "gauss:120"])
@pytest.mark.parametrize("closed", [True, False])
def test_variance_factor_and_freedom_from_the_operator(text, closed):
    rng = np.random.default_rng(11)
    s = np.append(rng.uniform(0, 60, 45), [12.0, 12.0, 12.0])
    matrix = operator(s, text, length=60.0, closed=closed)
    d = rng.normal(size=s.size)
    result = run(s, d, text, length=60.0, closed=closed)
    np.testing.assert_allclose(result.determined, matrix @ d, atol=1e-10)
    assert result.variance_factor == pytest.approx((matrix**2).sum() / s.size, rel=1e-8)
    rest = np.eye(s.size) - matrix
    expected = math.sqrt(np.sum((rest @ d) ** 2) / np.sum(rest**2))
    assert result.random_std == pytest.approx(expected, rel=1e-8)


def test_gap_is_named():
    s = np.append(np.arange(40.0), np.arange(70.0, 100.0))
    for text in ("gauss:10", "robust:10"):
        result = run(s, 3 * np.sin(s / 4), text, length=100.0, closed=False)
        assert any("gap" in warning and "31 mm" in warning for warning in result.warnings), text


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("per_cutoff", [20, 100])
def test_lines_on_a_grid_against_the_exact_ones(closed, per_cutoff):
    rng = np.random.default_rng(1)
    n, length = 20000, 300.0
    s = np.sort(rng.uniform(0, length, n))
    s = s[(s < 100) | (s > 120)]
    d, w = rng.normal(size=s.size), rng.uniform(0.5, 1.0, s.size)
    cutoff = per_cutoff * length / n
    grid = local_line_on_grid(s, d, w, cutoff=cutoff, length=length, closed=closed)
    exact = local_line(s, d, w, cutoff=cutoff, length=length, closed=closed)
    # The third moments: 0.125^3 / 6 times the third derivative, 0.0016 of the scatter a point, less in their mean.
    assert np.sqrt(np.mean((grid.values - exact.values) ** 2)) < 1e-3
    assert grid.own_weight.sum() == pytest.approx(exact.own_weight.sum(), rel=2e-3)
    assert grid.squared_weights.sum() == pytest.approx(exact.squared_weights.sum(), rel=2e-3)


def test_rows_that_a_grid_does_not_suit():
    s = np.append(np.linspace(0, 1, 5000), np.linspace(2, 100, 50))
    assert local_line_on_grid(s, s, np.ones(5050), cutoff=0.5, length=100.0, closed=False) is None
    assert local_line_on_grid(s, s, np.ones(5050), cutoff=90.0, length=100.0, closed=False) is None


def test_many_points_with_outliers_on_the_grid():
    rng = np.random.default_rng(2)
    n, length = 40000, 400.0
    s = rng.uniform(0, length, n)
    truth = 5 * np.cos(2 * np.pi * s / 100)
    d = truth + rng.normal(size=n)
    bad = rng.choice(n, n // 50, replace=False)
    d[bad] += 15.0
    result = run(s, d, "robust:0.5", length=length, closed=True)
    assert np.all(result.weights[bad] < 0.05)
    # 1 / sqrt(50 points to the cutoff) would be 0.14; a biweight and uneven points cost some more.
    assert np.sqrt(np.mean((result.determined - truth) ** 2)) < 0.25
    assert result.random_std == pytest.approx(1.0, rel=0.05)


# --- outliers


@pytest.mark.parametrize(("text", "limit"), [("robust:30", 0.33)])
def test_outliers_are_ignored(text, limit):
    s = np.arange(200.0)
    truth = 3 * np.cos(2 * np.pi * s / 200)
    errors, deviations = [], []
    for seed in range(10):
        rng = np.random.default_rng(seed)
        d = truth + rng.normal(size=200)
        bad = rng.choice(200, 4, replace=False)
        d[bad] += rng.choice([-10.0, 10.0], 4)
        result = run(s, d, text, length=200.0, closed=True)
        assert np.all(result.weights[bad] < 0.05)
        # An inlier of a normal law is beyond three deviations once in 370.
        assert np.count_nonzero(result.weights < 0.05) <= 12
        assert any("outlier" in warning for warning in result.warnings)
        errors.append(np.sqrt(np.mean((result.determined - truth) ** 2)))
        deviations.append(result.random_std)
    assert np.mean(errors) < limit
    assert np.mean(deviations) == pytest.approx(1.0, rel=0.05)


def test_two_levels_measured_at_the_same_places():
    s = np.repeat(np.arange(100.0), 2)
    truth = 4 * np.cos(2 * np.pi * s / 100)
    d = truth + np.random.default_rng(3).normal(size=200)
    for text in ("robust:30", "gauss:30"):
        result = run(s, d, text, length=100.0, closed=True)
        assert np.sqrt(np.mean((result.determined - truth) ** 2)) < 0.5
        assert result.random_std == pytest.approx(1.0, rel=0.15)
        np.testing.assert_allclose(result.determined[::2], result.determined[1::2], atol=1e-14)


# --- symmetries

rows = st.integers(2, 60).flatmap(
    lambda n: st.tuples(
        st.lists(st.integers(0, 999), min_size=n, max_size=n),
        st.lists(st.floats(-0.1, 0.1), min_size=n, max_size=n),
        st.integers(0, 2**32 - 1),
        st.integers(1, 999),
    )
)
LINEAR = ["mean:5", "mean:1,2,3,2,1", "gauss:9"]


@pytest.mark.parametrize("text", KINDS)
@pytest.mark.parametrize("closed", [True, False])
@settings(max_examples=examples(25), deadline=None)
@given(row=rows)
def test_order_of_the_points_does_not_matter(text, closed, row):
    s, d, seed, _ = np.array(row[0]) / 10, np.array(row[1]), row[2], row[3]
    shuffled = np.random.default_rng(seed).permutation(s.size)
    one = run(s, d, text, length=100.0, closed=closed)
    two = run(s[shuffled], d[shuffled], text, length=100.0, closed=closed)
    np.testing.assert_allclose(one.determined[shuffled], two.determined, atol=1e-12)
    assert one.variance_factor == pytest.approx(two.variance_factor, rel=1e-6)


@pytest.mark.parametrize("text", LINEAR)
@settings(max_examples=examples(25), deadline=None)
@given(row=rows)
def test_start_and_direction_of_a_contour_do_not_matter(text, row):
    s, d, shift = np.array(row[0]) / 10, np.array(row[1]), row[3] / 10
    one = run(s, d, text, length=100.0, closed=True)
    two = run(np.mod(s + shift, 100.0), d, text, length=100.0, closed=True)
    back = run(100.0 - s, d, text, length=100.0, closed=True)
    np.testing.assert_allclose(one.determined, two.determined, atol=1e-8)
    np.testing.assert_allclose(one.determined, back.determined, atol=1e-8)


@pytest.mark.parametrize("text", ["robust:40"])
@pytest.mark.parametrize("seed", range(8))
def test_start_and_direction_do_not_matter_to_the_choice(text, seed):
    rng = np.random.default_rng(seed)
    s = np.mod(np.arange(150) * (200 / 150) + rng.uniform(-0.4, 0.4, 150), 200)
    d = 3 * np.cos(2 * np.pi * s / 200) + rng.normal(size=150)
    one = run(s, d, text, length=200.0, closed=True)
    two = run(np.mod(s + 77.7, 200), d, text, length=200.0, closed=True)
    back = run(200 - s, d, text, length=200.0, closed=True)
    np.testing.assert_allclose(one.determined, two.determined, atol=1e-7)
    np.testing.assert_allclose(one.determined, back.determined, atol=1e-7)
    opened = run(s, d, text, length=200.0, closed=False)
    turned = run(200 - s, d, text, length=200.0, closed=False)
    np.testing.assert_allclose(opened.determined, turned.determined, atol=1e-7)


@pytest.mark.parametrize("text", KINDS)
@pytest.mark.parametrize("closed", [True, False])
@settings(max_examples=examples(25), deadline=None)
@given(row=rows, value=st.floats(-1.0, 1.0))
def test_constants_come_back(text, closed, row, value):
    s = np.array(row[0]) / 10
    result = run(s, np.full(s.size, value), text, length=100.0, closed=closed)
    np.testing.assert_allclose(result.determined, value, rtol=1e-14)


def test_results_are_read_only():
    result = run([0.0, 1.0], [0.0, 1.0], "none", length=2.0, closed=False)
    with pytest.raises(ValueError, match="read-only"):
        result.determined[0] = 1.0
