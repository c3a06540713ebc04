# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a displaced path: the surface that all passes of the written program leave is where it was to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.commanded import CommandedSurface
from millcorr.comparison.path_distance import PathDistance, SegmentTree
from millcorr.errors import LimitError
from millcorr.verification import Verification

from .wanted_surface import WantedSurface

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

REACHED = 0.01
"""A place where the program left more than this over the nominal, in mm, was never reached by the cutter: an inner
corner. Facets of 0.01 mm chord error are the coarsest that finish a surface."""


def prove_surface(
    original: CommandedSurface,
    written: CommandedSurface,
    before: WantedSurface,
    after: WantedSurface,
    radius: float,
    following: Ints,
    *,
    tolerance: float,
) -> tuple[Verification, tuple[float, tuple[float, float]]]:
    """Compare the surface of a written program with that of the original and with what was wanted.

    Parameters
    ----------
    original, written : CommandedSurface
        All passes of the program before, and of the text as it is read back.
    before, after : WantedSurface
        What the original makes, and what the written one is to make.
    radius : float
        Distance in mm from contour to path.
    following : (k,) int64
        Rows of the written program that make the surface.
    tolerance : float
        mm.

    Returns
    -------
    Verification
    stays : (float, (float, float))
        The most that the cutter cannot reach of what was wanted, mm, and where.

    Raises
    ------
    LimitError
        If the surface is farther off than the tolerance: names place, amount and, where a pass that stays cuts into it,
        its line.
    """
    lowest = float(np.nanmin(np.append(written.toolpath.end[following, 2], np.inf)))
    heights: list[float | None] = [None]
    if np.isfinite(lowest):
        heights.append(lowest)
    wanted = after.moved - before.moved
    rest = _out_of_reach(after, radius) if radius > 0 else np.zeros(len(wanted))
    error = np.zeros(len(wanted))
    reached = np.zeros(len(wanted), dtype=bool)
    for height in heights:
        z = None if height is None else np.full(len(wanted), height)
        was = original.offset(before.nominal, before.normal, z)
        now = written.offset(after.nominal, after.normal, z)
        known = np.isfinite(was) & np.isfinite(now) & ~after.at_corner
        here = known & (was - before.moved < REACHED)
        reached |= here
        # What was there before stays: rounding and chords of the program itself.
        off = np.where(here, now - was - wanted, np.where(known, np.minimum(now - after.moved, 0.0), 0.0))
        off = np.where(off > 0, np.maximum(off - rest, 0.0), off)
        error = np.where(np.abs(off) > np.abs(error), off, error)
    worst = int(np.argmax(np.abs(error)))
    x, y = after.place[worst]
    length = float(written.toolpath.take(following).length().sum()) if len(following) else 0.0
    result = Verification(
        float(abs(error[worst])), (float(x), float(y)), float(max(0.0, -error.min())), float(np.nan_to_num(length))
    )
    if abs(error[worst]) > tolerance:
        raise LimitError(_refusal(written, after, worst, float(error[worst]), following, tolerance))
    most = int(np.argmax(np.where(reached, rest, 0.0)))
    x, y = after.place[most]
    return result, (float(rest[most]) if reached[most] else 0.0, (float(x), float(y)))


def _out_of_reach(after: WantedSurface, radius: float) -> Floats:
    """What the cutter has to leave over the wanted surface, mm; (n,)."""
    centre = after.clearance(after.nominal, after.normal, radius, radius + after.moved)
    path = after.nominal + centre[:, None] * after.normal
    a, b = after.chords.T
    joined = np.hypot(*(path[b] - path[a]).T) < 2 * radius
    tree = SegmentTree(path[a[joined]], path[b[joined]])
    return np.maximum(tree.distance(after.place) - radius, 0.0)


def _refusal(
    written: CommandedSurface, after: WantedSurface, worst: int, error: float, following: Ints, tolerance: float
) -> str:
    x, y = after.place[worst]
    place = after.place[worst : worst + 1]
    cuts = np.flatnonzero(np.isfinite(written.radius) & (written.toolpath.kind != 0))
    _, row, _ = PathDistance(written.toolpath, cuts).nearest(place)
    if error < 0 and len(row) and row[0] not in following:
        line = int(written.toolpath.source[row[0]]) + 1
        return (
            f"line {line}, which is not corrected, would cut {-error * 1000:.1f} um into the corrected surface at "
            f"X{x:.3f} Y{y:.3f}: it leaves too little for it; --keep-allowance moves such passes along"
        )
    return (
        f"the corrected surface would be {abs(error) * 1000:.2f} um off at X{x:.3f} Y{y:.3f}, more than the "
        f"tolerance of {tolerance * 1000:g} um"
        + (" (the cutter gouges there)" if error < 0 else ": where that does no harm, a larger --tolerance")
    )
