# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an elastic machine leaves of a stated depth: deviations that large are expected, not suspicious.

With a transfer function MS a cut of depth H leaves ``H MS / (1 + MS)`` (petrakov-2025, eq. 3): 0.1 mm of 2 mm, more
than most mistakes make. Whether a large deviation is one can then only be told from what no elastic machine does.
"""

from __future__ import annotations

import numpy as np

PLAUSIBLE = 0.15
"""Largest transfer function that is believed without a look; published are 0.05 to 0.08."""

LESS = 0.005
"""More than this, in mm, no elastic machine removes beside what it is told to: noise of points, not more."""

BALLS = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0)
"""Radii in mm that probes have: a constant deviation of just that size is a ball that was not taken off."""

LIKE_A_BALL = 0.05
"""Within this share of a ball's radius a deviation is of just that size."""


def most_left(depth: float) -> float:
    """Largest deviation in mm that is expected of a depth in mm along the normal."""
    return depth * PLAUSIBLE / (1.0 + PLAUSIBLE)


def expected(low: float, high: float, depth: float) -> bool:
    """Whether all deviations between two, in mm, are what an elastic machine may leave of a depth; 0: not known."""
    return depth > 0 and low >= -LESS and high <= most_left(depth)


def like_a_ball(offset: float) -> bool:
    """Whether an offset in mm is the radius of a probe's ball."""
    radii = np.array(BALLS)
    return bool((np.abs(offset - radii) < LIKE_A_BALL * radii).any())


def transfer(offset: float, depth: float) -> float:
    """Transfer function that leaves an offset of a depth: ``delta / (H - delta)`` (eq. 4)."""
    return offset / (depth - offset)
