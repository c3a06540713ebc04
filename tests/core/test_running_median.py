# SPDX-License-Identifier: LGPL-2.1-or-later
"""The running median beside which swarf is seen: over few neighbours, and over tens of thousands."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr.distrust.filter import MOST_NEIGHBOURS, _running_median


@pytest.mark.parametrize("size", [101, MOST_NEIGHBOURS + 2, 20001])
@pytest.mark.parametrize("lump", [10, 40])
def test_a_lump_does_not_lift_the_median_of_a_slope(size, lump):
    n, slope = 100_000, 1e-4
    line = slope * np.arange(n)
    value = line.copy()
    value[n // 2 : n // 2 + lump] += 50.0
    seen = _running_median(value, size, closed=False)
    inside = slice(size, n - size)
    # Each raised point moves the median of a slope by half a point; a group's middle lies within the group.
    assert np.abs(seen - line)[inside].max() <= slope * (lump + -(-size // MOST_NEIGHBOURS))


@pytest.mark.parametrize("size", [101, 20001])
def test_a_closed_contour_has_no_beginning(size):
    n = 100_003
    value = np.cos(2 * np.pi * np.arange(n) / n)
    here = _running_median(value, size, closed=True)
    turned = np.roll(_running_median(np.roll(value, 777), size, closed=True), -777)
    # Groups begin elsewhere: by less than one of them, on the steepest slope.
    assert np.abs(here - turned).max() <= 2 * np.pi / n * 2 * -(-size // MOST_NEIGHBOURS)
