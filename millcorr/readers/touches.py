# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two touches of one place: a fast one that finds the surface, and a slow one that measures it."""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.messages import phrase

from .parts import near

_FEWEST = 3
"""Fewer pairs are no habit."""


def slow_touches(points: Floats) -> Bools:
    """Which touches measure, (n,): of two at one place the second, which controls and their manuals make slow.

    Parameters
    ----------
    points : (n, 3) float64
        In mm, in the order of the touches.

    Notes
    -----
    A log has such pairs if there are three, and at least half of its places were touched twice, none more often, and
    any two places that follow each other lie farther apart than `millcorr.readers.parts.SAME_PLACE`. Then it cannot be
    a contour touched in short steps, whose points would all be near the next one.
    """
    # Touches that the next one repeats.
    again = np.append(near(points[1:], points[:-1]), False)
    pairs = int(again.sum())
    if (again[1:] & again[:-1]).any() or pairs < max(_FEWEST, (len(points) - pairs) / 2):
        return np.ones(len(points), dtype=np.bool_)
    return ~again


def remark(kept: Bools) -> list[str]:
    """Note about the touches that `slow_touches` left out, if any."""
    count = int((~kept).sum())
    return [phrase("{} places touched twice: the second touch of each counts, the slow one", count)] if count else []
