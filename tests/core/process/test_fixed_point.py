# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixed points of many small systems, against linear algebra and bisection."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from millcorr.process.fixed_point import FixedPoint


def settled(g, x, system, depth, rounds=60):
    course = FixedPoint(system, int(system.max()) + 1, depth)
    for turn in range(rounds):
        answer = g(x)
        if np.abs(answer - x).max() <= 1e-12:
            return x, turn
        x = course.step(x, answer)
    raise AssertionError(f"still {np.abs(answer - x).max():.1e}")


def test_linear_systems_of_two_unknowns():
    """x = A x + b, solved by linear algebra; A turns and stretches five times, so that plain rounds diverge."""
    rng = np.random.default_rng(3)
    n = 40
    a = rng.uniform(-1.0, 0.3, (n, 2, 2)) * np.array([1.0, 5.0])[rng.integers(0, 2, n), None, None]
    b = rng.standard_normal((n, 2))
    wanted = np.linalg.solve(np.eye(2) - a, b[..., None])[..., 0]
    good = np.abs(np.linalg.eigvals(a) - 1.0).min(axis=1) > 0.2
    a, b, wanted = a[good], b[good], wanted[good]
    assert np.abs(np.linalg.eigvals(a)).max() > 4.0
    x, turns = settled(lambda x: np.einsum("nij,nj->ni", a, x) + b, np.zeros_like(b), np.arange(len(b)), 2)
    assert x == pytest.approx(wanted, abs=1e-9)
    assert turns < 60


def test_force_that_ends_at_once():
    """g falls steeply and is 0 from a place on, as where a tool leaves the cut: the root by Brent's method."""
    slope = np.array([0.3, 2.0, 8.0, 20.0])

    def g(x):
        return np.maximum(0.2 - slope[:, None] * x, 0.0) ** 1.5

    x, _ = settled(g, g(np.zeros((4, 1))), np.arange(4), 1)
    for k, s in enumerate(slope):
        root = brentq(lambda v, s=s: max(0.2 - s * v, 0.0) ** 1.5 - v, 0.0, 1.0, xtol=1e-15)
        assert x[k, 0] == pytest.approx(root, abs=1e-11)


def test_systems_do_not_disturb_each_other():
    """Rows of one system beside another give what they give alone, to the last digit that adding leaves."""

    def g(x):
        return np.cos(x * np.array([1.0, 0.5]))

    start = np.array([[0.1, 0.2], [0.7, -0.4], [0.3, 0.9]])
    both, _ = settled(g, start, np.array([0, 0, 1]), 2)
    alone, _ = settled(g, start[2:], np.array([0]), 2)
    assert both[2:] == pytest.approx(alone, abs=1e-12)
    assert both == pytest.approx(np.cos(both * [1.0, 0.5]), abs=1e-12)
