# SPDX-License-Identifier: LGPL-2.1-or-later
import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import lfilter

from millcorr.errors import InputError, UsageError
from millcorr.filtering import Filter, separate
from millcorr.filtering.gaussian_regression import ALPHA, local_line, local_line_on_grid
from millcorr.filtering.spatial_correlation import moran_test, neighbour_links
from tests.core.sweeps import examples, slow

KINDS = ["none", "mean:5", "mean:1,2,3,2,1", "gauss:9", "robust:9", "auto"]


def run(s, d, text, *, length, closed):
    return separate(s, d, length=length, closed=closed, filter=Filter.parse(text))


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


@pytest.mark.parametrize("text", ["gauss:8", "gauss:500", "robust:8", "auto"])
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
    for text in ("gauss:10", "robust:10", "auto"):
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


@pytest.mark.parametrize(("text", "limit"), [("robust:30", 0.33), ("auto", 0.33)])
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


def test_short_real_error_is_no_outlier():
    # A dwell mark ten points wide and ten deviations high must be corrected, not thrown away.
    s = np.arange(200.0)
    truth = 10 * np.exp(-(((s - 80) / 4) ** 2))
    result = run(s, truth + np.random.default_rng(1).normal(size=200), "auto", length=200.0, closed=True)
    assert np.all(result.weights[76:85] > 0.9)
    assert abs(result.determined[80] - 10) < 2.5


# --- Moran's I


def test_morans_i_against_the_double_sum():
    rng = np.random.default_rng(2)
    x = np.cumsum(rng.normal(size=30))
    e = x - x.mean()
    weights = np.zeros((30, 30))
    for i in range(30):
        for j in range(30):
            weights[i, j] = i != j and min(abs(i - j), 30 - abs(i - j)) <= 2
    links = neighbour_links(30, np.ones(30, dtype=bool), 2)
    np.testing.assert_array_equal(links.toarray(), weights)
    direct = 30 / weights.sum() * sum(
        weights[i, j] * e[i] * e[j] for i in range(30) for j in range(30)
    ) / np.sum(e**2)  # fmt: skip
    from scipy.sparse import csr_array

    moran = moran_test(e, links, csr_array(np.ones((30, 1))))
    assert moran.index == pytest.approx(direct, rel=1e-12)
    assert moran.expectation == pytest.approx(-1 / 29, rel=1e-12)


def test_links_do_not_cross_gaps():
    joined = np.array([True, True, False, True])
    links = neighbour_links(5, joined, 2).toarray()
    expected = np.zeros((5, 5))
    for i, j in [(0, 1), (1, 2), (0, 2), (3, 4)]:
        expected[i, j] = expected[j, i] = 1
    np.testing.assert_array_equal(links, expected)


def test_moments_of_morans_i_against_monte_carlo():
    from scipy.sparse import csr_array

    rng = np.random.default_rng(4)
    n, k, draws = 40, 7, 40000
    design = np.column_stack([np.linspace(-1, 1, n) ** p for p in range(k)])
    projection = np.eye(n) - design @ np.linalg.pinv(design)
    links = neighbour_links(n, np.ones(n - 1, dtype=bool), 2)
    e = rng.normal(size=(draws, n)) @ projection
    index = n / links.sum() * np.einsum("ij,ij->i", e @ links.toarray(), e) / np.einsum("ij,ij->i", e, e)
    moran = moran_test(e[0], links, csr_array(design))
    assert moran.index == pytest.approx(index[0], rel=1e-10)
    # Four standard errors of a mean and of a variance (normal law: sqrt(2 / draws)).
    assert moran.expectation == pytest.approx(index.mean(), abs=4 * math.sqrt(moran.variance / draws))
    assert moran.variance == pytest.approx(index.var(), rel=4 * math.sqrt(2 / draws))
    # What the plain -1/(n - 1) would miss.
    assert moran.expectation < -3 / (n - 1)


# --- regression with Moran's stop

CASES = {
    "nothing": (lambda x: 0 * x, 0.15),
    "few": (lambda x: 3 * np.cos(2 * np.pi * x) + 2 * np.sin(4 * np.pi * x) + np.cos(6 * np.pi * x), 0.33),
    "fifth": (lambda x: 3 * np.cos(2 * np.pi * x) + 0.8 * np.cos(10 * np.pi * x), 0.36),
    "eighth": (lambda x: 3 * np.cos(2 * np.pi * x) + 0.8 * np.cos(16 * np.pi * x), 0.42),
}


@pytest.mark.parametrize("rows", [4, slow(20)])
@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("sigma", [1.0, 0.002])
def test_regression_finds_the_determined_part(case, closed, sigma, rows):
    truth, limit = CASES[case]
    s = np.arange(200) * 1.12 if closed else np.linspace(0, 224, 200)
    errors, deviations = [], []
    for seed in range(rows):
        noise = np.random.default_rng(seed).normal(size=200)
        result = run(s, sigma * (truth(s / 224) + noise), "auto", length=224.0, closed=closed)
        errors.append(np.mean((result.determined / sigma - truth(s / 224)) ** 2))
        deviations.append(result.random_std / sigma)
        # Five standard errors of a deviation from 200 points.
        assert deviations[-1] == pytest.approx(1.0, abs=5 / math.sqrt(2 * 170))
    assert np.mean(np.sqrt(errors)) < limit
    # What one correction leaves on the next part, in units of what does not repeat: at most 1.1.
    assert np.mean(np.sqrt(1 + np.array(errors))) <= 1.1
    # Four standard errors of the mean of so many deviations.
    assert np.mean(deviations) == pytest.approx(1.0, rel=4 / math.sqrt(2 * 170 * rows))


def test_variance_factor_of_the_regression_is_its_share_of_parameters():
    s = np.arange(200.0)
    d = np.random.default_rng(0).normal(size=200) + 5 * np.cos(2 * np.pi * s / 100)
    result = run(s, d, "auto", length=200.0, closed=True)
    parameters = result.variance_factor * 200
    if np.all(result.weights == 1.0):
        assert parameters == pytest.approx(round(parameters), abs=1e-4)
    assert f"{round(parameters)} parameters" in result.description


@pytest.mark.parametrize("closed", [True, False])
def test_regression_bridges_a_gap_tamely(closed):
    s = np.arange(200.0)
    s = s[(s < 60) | (s > 100)]
    truth = 3 * np.cos(2 * np.pi * s / 200) + 2 * np.sin(4 * np.pi * s / 200)
    errors = []
    for seed in range(10):
        d = truth + np.random.default_rng(seed).normal(size=s.size)
        result = run(s, d, "auto", length=200.0, closed=closed)
        assert np.max(np.abs(result.determined - truth)) < 2.0
        errors.append(np.sqrt(np.mean((result.determined - truth) ** 2)))
    assert np.mean(errors) < 0.4


@pytest.mark.parametrize("closed", [True, False])
def test_regression_of_clustered_points(closed):
    s = np.concatenate([np.linspace(0, 1, 300), np.linspace(1, 99, 100)])
    truth = 3 * np.cos(2 * np.pi * s / 100) + 2 * np.sin(4 * np.pi * s / 100)
    d = truth + np.random.default_rng(0).normal(size=s.size)
    result = run(s, d, "auto", length=100.0, closed=closed)
    assert np.sqrt(np.mean((result.determined - truth)[300:] ** 2)) < 0.8
    assert result.random_std == pytest.approx(1.0, rel=0.12)


def test_correlation_that_the_points_cannot_follow_is_said():
    # Eight points allow no knots at all, and one wave round them is no noise.
    s = np.arange(8.0)
    result = run(s, np.cos(2 * np.pi * s / 8), "auto", length=8.0, closed=True)
    assert any("still correlated" in warning for warning in result.warnings)


def test_two_levels_measured_at_the_same_places():
    s = np.repeat(np.arange(100.0), 2)
    truth = 4 * np.cos(2 * np.pi * s / 100)
    d = truth + np.random.default_rng(3).normal(size=200)
    for text in ("auto", "gauss:30"):
        result = run(s, d, text, length=100.0, closed=True)
        assert np.sqrt(np.mean((result.determined - truth) ** 2)) < 0.5
        assert result.random_std == pytest.approx(1.0, rel=0.15)
        np.testing.assert_allclose(result.determined[::2], result.determined[1::2], atol=1e-14)


def test_many_points_are_gathered_without_harm():
    n = 20000
    s = np.random.default_rng(0).uniform(0, 1000, n)
    truth = 3 * np.cos(2 * np.pi * s / 1000) + np.sin(2 * np.pi * 40 * s / 1000)
    for closed in (True, False):
        d = truth + np.random.default_rng(1).normal(size=n)
        result = run(s, d, "auto", length=1000.0, closed=closed)
        parameters = result.variance_factor * n
        error = np.sqrt(np.mean((result.determined - truth) ** 2))
        assert error < 1.5 * math.sqrt(parameters / n)
        assert error < 0.15
        assert result.random_std == pytest.approx(1.0, rel=5 / math.sqrt(2 * n))


# --- noise that is correlated along the contour

LENGTH = 224.0


def three_harmonics(s):
    x = 2 * np.pi * s / LENGTH
    return 3 * np.cos(x) + 2 * np.sin(2 * x) + np.cos(3 * x)


def process_noise(n, memory, seed):
    """Unit noise whose correlation falls as exp(-distance / memory in mm)."""
    a = math.exp(-LENGTH / n / memory)
    e = np.random.default_rng(seed).normal(size=n)
    e[0] /= math.sqrt(1 - a * a)
    return lfilter([math.sqrt(1 - a * a)], [1, -a], e)


def number_of_fits(result):
    return int(re.search(r"(\d+) fits", result.description).group(1))


@pytest.mark.parametrize("rows", [2, slow(10)])
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize(("n", "memory"), [(200, 2.0), (5000, 0.1), (5000, 1.0), (20000, 0.1), (20000, 1.0)])
def test_correlated_noise_is_not_followed(n, memory, closed, rows):
    s = np.arange(n) * (LENGTH / n) if closed else np.linspace(0, LENGTH, n)
    # Such noise has length / (2 memory) independent values. Three harmonics take a spline of 8 parameters, each
    # of which catches the variance of one value; a bend whose lack costs less than that cannot be proven, and
    # chance adds a few parameters: three times 8. Raw data, or a spline that follows the noise, err by 1.
    expected = math.sqrt(3 * 8 * 2 * memory / LENGTH)
    errors, deviations, warned = [], [], 0
    for seed in range(rows):
        result = run(s, three_harmonics(s) + process_noise(n, memory, seed), "auto", length=LENGTH, closed=closed)
        errors.append(np.mean((result.determined - three_harmonics(s)) ** 2))
        deviations.append(result.random_std)
        warned += any("stay correlated over" in warning for warning in result.warnings)
        assert number_of_fits(result) <= 300
    assert math.sqrt(np.mean(errors)) < expected
    # Every memory twice over is one value: that many values tell the deviation to 1 / sqrt(2 values).
    assert np.mean(deviations) == pytest.approx(1.0, abs=5 * math.sqrt(memory / LENGTH / rows) + 0.05)
    assert warned >= (1.0 if n > 200 else 0.8) * rows


@pytest.mark.parametrize("rows", [3, slow(10)])
def test_variance_factor_for_correlated_noise(rows):
    # The variance that 2 memory / length of it a parameter leave in the determined part.
    n, memory = 20000, 0.5
    s = np.arange(n) * (LENGTH / n)
    ratios = []
    for seed in range(rows):
        result = run(s, process_noise(n, memory, seed), "auto", length=LENGTH, closed=True)
        parameters = re.search(r"of (\d+) parameters", result.description)
        ratios.append(result.variance_factor / (2 * memory / LENGTH) / (int(parameters[1]) if parameters else 1))
    assert np.mean(ratios) == pytest.approx(1.0, rel=0.25)


@pytest.mark.parametrize("rows", [1, slow(5)])
@pytest.mark.parametrize("closed", [True, False])
def test_short_waves_and_marks_stand_out_of_correlated_noise(closed, rows):
    n, memory = 20000, 0.1
    s = np.arange(n) * (LENGTH / n) if closed else np.linspace(0, LENGTH, n)
    shapes = (np.cos(2 * np.pi * 40 * s / LENGTH), 8 * np.exp(-(((s - 80) / 2) ** 2)))
    for shape in shapes:
        truth = three_harmonics(s) + shape
        errors = []
        for seed in range(rows):
            result = run(s, truth + process_noise(n, memory, seed), "auto", length=LENGTH, closed=closed)
            errors.append(np.sqrt(np.mean((result.determined - truth) ** 2)))
            assert np.max(np.abs(result.determined - truth)) < 5.0
        # Knots every 1 mm follow either to a thousandth: 224 parameters, in steps of a quarter up to 280.
        assert np.median(errors) < math.sqrt(300 * 2 * memory / LENGTH)


@pytest.mark.parametrize("n", [200, 5000, 20000])
def test_noise_as_wide_as_the_form_is_followed_and_said(n):
    # Correlated over 5 mm it has no flat spectrum below the three harmonics: nothing tells it from them.
    s = np.arange(n) * (LENGTH / n)
    for seed in range(5):
        result = run(s, three_harmonics(s) + process_noise(n, 5.0, seed), "auto", length=LENGTH, closed=True)
        assert any("second part" in warning for warning in result.warnings)
        assert number_of_fits(result) <= 300


def test_dense_white_noise_is_not_called_correlated():
    n = 20000
    s = np.arange(n) * (LENGTH / n)
    for seed in range(10):
        noise = np.random.default_rng(seed).normal(size=n)
        result = run(s, three_harmonics(s) + noise, "auto", length=LENGTH, closed=True)
        assert not result.warnings
        assert np.sqrt(np.mean((result.determined - three_harmonics(s)) ** 2)) < math.sqrt(30 / n)
        assert result.random_std == pytest.approx(1.0, rel=5 / math.sqrt(2 * n))


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
    # The mean that is taken off first is summed in the order of the input: rounding only.
    np.testing.assert_allclose(one.determined[shuffled], two.determined, atol=1e-8)
    assert one.variance_factor == pytest.approx(two.variance_factor, rel=1e-6)


@pytest.mark.parametrize("row", [[22, 4, 5, 14, 2, 0, 1, 3, 21], [8, 2, 4, 5, 6, 0, 1, 3, 7]])
def test_few_points_on_a_short_part_of_a_contour(row):
    # The peak of the first harmonic, where the knots begin, may fall into the long empty part.
    s = np.array(row) / 10
    for seed in range(40):
        d = np.random.default_rng(seed).normal(size=s.size)
        result = run(s, d, "auto", length=100.0, closed=True)
        np.testing.assert_allclose(
            run(s[::-1], d[::-1], "auto", length=100.0, closed=True).determined[::-1], result.determined, atol=1e-8
        )


def test_search_goes_on_where_outliers_leave_few_places():
    s = np.array([22, 4, 5, 14, 2, 0, 1, 3, 21]) / 10
    d = [-0.09375, 0.0, 0.0, -0.0625, 0.0625, 0.0, 0.0, 0.0, -0.09375]
    assert np.isfinite(run(s, d, "auto", length=100.0, closed=True).determined).all()


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


@pytest.mark.parametrize("text", ["auto", "robust:40"])
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
