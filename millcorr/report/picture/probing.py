# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a measuring program: touches, the ball where it touches, and the ways between, as polylines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats
from millcorr.probing import ProbingPlan

from .correction import Lines

TOUCH, BALL, WAY, OVER = 0xCC0000FF, 0x3465A4FF, 0x4E9A06FF, 0xC4A000FF
"""Colours 0xRRGGBBAA of touches, of the ball, and of ways at measuring height and over the safe height."""

MOST_BALLS = 400
"""With more touches than this, balls are drawn at every so many of them only."""

_ROUND = 24


def overlay_of(plan: ProbingPlan, z: float, safe_z: float) -> Lines:
    """What to draw of a plan.

    Parameters
    ----------
    plan : ProbingPlan
    z, safe_z : float
        Height of measuring, and height of ways over everything, mm.

    Returns
    -------
    Lines
        Each touch from its start to the contour's point, the ball there as a circle, and the ways between.
    """
    n = len(plan)
    every = max(1, n // MOST_BALLS)
    angle = np.linspace(0.0, 2 * np.pi, _ROUND + 1)
    circle = plan.probe.ball_radius * np.column_stack([np.cos(angle), np.sin(angle)])
    pieces = [(np.stack([plan.start[k], plan.contact[k]]), TOUCH) for k in range(n)]
    pieces += [(centre + circle, BALL) for centre in plan.centre[::every]]
    flat = [(_at(points, z), colour) for points, colour in pieces]
    for k, link in enumerate(plan.links):
        if link is None:
            a, b = plan.start[k], plan.start[k + 1]
            way = np.array([[*a, z], [*a, safe_z], [*b, safe_z], [*b, z]])
            flat.append((way, OVER))
        elif len(link) > 1:
            flat.append((_at(link, z), WAY))
    return joined(flat)


def _at(points: Floats, z: float) -> Floats:
    return np.column_stack([points, np.full(len(points), z)])


def joined(pieces: Sequence[tuple[Floats, int]]) -> Lines:
    """Polylines of any numbers of points, (k, 3) in mm each, with a colour 0xRRGGBBAA for each.

    Parameters
    ----------
    pieces : sequence of ((k, 3) float64, int)
    """
    counts = np.array([len(points) for points, _ in pieces], dtype=np.int64)
    total = int(counts.sum())
    index = np.insert(np.arange(total), np.cumsum(counts), -1)
    return Lines(
        np.concatenate([np.zeros((0, 3)), *(points for points, _ in pieces)]).astype(np.float32),
        np.repeat(np.array([colour for _, colour in pieces], dtype=np.uint32), counts),
        index.astype(np.int32),
    )
