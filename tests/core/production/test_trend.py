# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trend and jump: closed forms without noise, and rates of detection and false alarm on simulated series."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from millcorr.production import trend

UM = 1e-3


def noise(seed, n, sigma=UM):
    return np.random.default_rng(seed).normal(0.0, sigma, n)


def test_a_straight_rise_is_a_trend_with_its_slope():
    change = trend.examine(2 * UM + 1.5 * UM * np.arange(8))
    assert change.kind == "trend" and change.size == pytest.approx(1.5 * UM) and (change.part, change.last) == (0, 7)


@pytest.mark.parametrize("after", [1, 2, 4, 7])
def test_a_step_is_a_jump_with_its_place_and_height(after):
    change = trend.examine(np.where(np.arange(8) < 8 - after, 3 * UM, -9 * UM))
    assert change.kind == "jump" and change.part == 8 - after and change.size == pytest.approx(-12 * UM)
    assert change.settled == (after > 1)


def test_equal_values_and_few_parts_show_nothing():
    assert trend.examine(np.full(12, 7 * UM)) is None
    assert trend.examine(np.full(12, 7 * UM) + 1e-13 * (np.arange(12) > 6)) is None
    assert trend.examine(np.arange(trend.LEAST_PARTS - 1) * UM) is None
    assert trend.examine(np.full(20, np.nan)) is None


def test_the_tests_are_students():
    """The slope's probability is scipy's regression; the jump's is scipy's t test times the number of places."""
    y = noise(3, 12) + 9 * UM * (np.arange(12) >= 5)
    change = trend.examine(y)
    assert change.kind == "jump" and change.part == 5
    assert change.probability == pytest.approx(11 * stats.ttest_ind(y[:5], y[5:]).pvalue, rel=1e-9)
    y = noise(3, 12) + 2 * UM * np.arange(12)
    change, line = trend.examine(y), stats.linregress(np.arange(12), y)
    assert change.kind == "trend" and change.probability == pytest.approx(line.pvalue, rel=1e-9)
    assert (change.size, change.error) == pytest.approx((line.slope, line.stderr), rel=1e-12)


@pytest.mark.parametrize("n", [5, 8, 15, 25])
@pytest.mark.parametrize("trending", [False, True])
def test_false_alarms_are_no_more_than_promised(n, trending):
    """4000 series of nothing but noise at 5 %: at most 200 are expected; 5 standard deviations of a count are 69."""
    values = np.random.default_rng(n).normal(0.0, UM, (4000, n))
    alarms = sum(trend.examine(row, trending=trending, false_alarms=0.05) is not None for row in values)
    assert alarms <= 200 + 69
    # Bonferroni's factor is cautious, but the test must not be blind either.
    assert alarms >= 40


@pytest.mark.parametrize("share", [0.0, 0.04, 0.2, 1 / 3])
@pytest.mark.parametrize("trending", [False, True])
def test_what_comes_back_of_corrections_raises_no_alarm(share, trending):
    """As above, with corrections of 5 and 40 um of which a share comes back."""
    commanded = -5 * UM * (np.arange(15) >= 4) - 40 * UM * (np.arange(15) >= 9)
    values = np.random.default_rng(1).normal(0.0, UM, (1000, 15)) - share * commanded
    alarms = sum(trend.examine(row, commanded, trending=trending, false_alarms=0.05) is not None for row in values)
    # At most 50 are expected: 5 standard deviations of a count are 35.
    assert alarms <= 50 + 35


def test_more_comes_back_than_any_machine_gives_is_a_jump():
    commanded = -30 * UM * (np.arange(12) >= 6)
    back = noise(4, 12, 0.5 * UM) - 0.5 * commanded
    change = trend.examine(back, commanded)
    assert change.kind == "jump" and change.part == 6 and change.size == pytest.approx(15 * UM, abs=UM)
    # Student's test of what a third of the correction does not explain.
    left = back + commanded / 3
    assert change.probability == pytest.approx(11 * stats.ttest_ind(left[:6], left[6:]).pvalue, rel=1e-9)


def test_wear_that_is_corrected_all_the_time_is_a_trend():
    """1 um a part, each corrected on the next: a tenth of it comes back, which the wear outweighs."""
    wear = UM * np.arange(14)
    commanded = np.concatenate([[0.0], -wear[:-1]])
    change = trend.examine(wear - 0.1 * commanded + noise(6, 14, 0.3 * UM), commanded)
    assert change.kind == "trend" and change.size == pytest.approx(1.1 * UM, abs=0.1 * UM)


def test_the_least_favourable_share_is_found():
    """Against a fine grid of shares."""
    random = np.random.default_rng(8)
    for _ in range(10):
        commanded = random.normal(0.0, 8 * UM, 10).cumsum()
        value = random.normal(0.0, UM, 10) - random.uniform(0, 0.4) * commanded + 3 * UM * (np.arange(10) >= 5)
        shares = np.linspace(0, 1 / 3, 401)
        grid = max(stats.linregress(np.arange(10), value + b * commanded).pvalue for b in shares)
        base, time = np.ones((10, 1)), np.arange(10.0)[:, None]
        found = trend._Added.of(base, time, value, commanded).probability[0]
        assert found == pytest.approx(grid, rel=0.02) and found >= grid * (1 - 1e-9)


def test_false_alarms_from_part_to_part():
    """100 series of 40 parts at 1 % a part, only parts from the fifth on are tested: at most 36 expected."""
    seen = 0
    for seed in range(100):
        value = noise(seed, 40)
        seen += sum(
            trend.examine(value[max(0, end - trend.WINDOW) : end], false_alarms=0.01) is not None
            for end in range(trend.LEAST_PARTS, 41)
        )
    # Successive parts share their window, so counts come in clusters: 3 standard deviations of clusters of 5.
    assert seen <= 36 + 3 * np.sqrt(36 * 5)


def test_wear_and_new_tools_are_told_apart():
    """Noise of 1 um; 1 um a part over 12 parts is wear, 8 um at once is a new tool: not one in 50 is mistaken."""
    kinds = {"trend": [], "jump": []}
    for seed in range(200):
        kinds["trend"].append(trend.examine(noise(seed, 12) + UM * np.arange(12)))
        kinds["jump"].append(trend.examine(noise(1000 + seed, 12) + 8 * UM * (np.arange(12) >= 6)))
    for kind, found in kinds.items():
        assert sum(c is not None for c in found) >= 198
        assert sum(c is not None and c.kind == kind for c in found) >= 196
    placed = [c.part for c in kinds["jump"] if c is not None and c.kind == "jump"]
    assert np.mean(np.array(placed) == 6) > 0.95
    slopes = np.array([c.size for c in kinds["trend"] if c is not None and c.kind == "trend"])
    # Standard deviation of a slope: 1 um / sqrt(sum of squares of -5.5 .. 5.5) = 0.0836 um; of the mean of 200: 0.006.
    assert slopes.mean() == pytest.approx(UM, abs=0.03 * UM)


def test_a_worn_tool_that_is_changed_shows_as_trend_then_jump():
    """Wear of 1 um a part for 12 parts, then a new tool that starts again."""
    value = np.concatenate([np.arange(12), np.arange(12)]) * UM + noise(5, 24, 0.2 * UM)
    found = trend.changes(value)
    assert [c.kind for c in found] == ["trend", "jump", "trend"]
    worn, changed, again = found
    assert worn.part == 0 and changed.part == 12 and again.part == 12
    assert worn.size == pytest.approx(UM, abs=0.1 * UM) and again.size == pytest.approx(UM, abs=0.1 * UM)
    # Against the line of the wear before: 12 um down from what part 13 would have been.
    assert changed.size == pytest.approx(-12 * UM, abs=1.5 * UM)


def test_one_part_far_off_is_forgotten_when_the_next_one_is_as_before():
    value = noise(7, 14, 0.3 * UM)
    value[9] += 15 * UM
    at_the_time = trend.changes(value[:10])
    assert at_the_time[-1].kind == "jump" and not at_the_time[-1].settled
    assert "measure another" in trend.in_words(at_the_time[-1], "mean", list(range(1, 15)))
    assert trend.changes(value[:11]) == ()


def test_size_and_place_of_the_part():
    angle = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    normal = np.column_stack([np.cos(angle), np.sin(angle)])
    d = 3 * UM + 2 * UM * normal[:, 0] - UM * normal[:, 1] + UM * np.cos(3 * angle)
    assert trend.components(d, normal) == pytest.approx(np.array([3, 2, -1]) * UM)
    d[::7] = np.nan
    smooth = d - UM * np.cos(3 * angle)
    assert trend.components(smooth, normal) == pytest.approx(np.array([3, 2, -1]) * UM)


def test_an_edge_tells_no_place():
    normal = np.tile([0.6, 0.8], (9, 1))
    out = trend.components(np.full(9, 2 * UM), normal)
    assert out[0] == pytest.approx(2 * UM) and np.isnan(out[1:]).all()
    assert np.isnan(trend.components(np.full(9, np.nan), normal)).all()
