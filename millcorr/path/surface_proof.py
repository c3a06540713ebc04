# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a displaced path: the surface that all passes of the written program leave is where it was to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.commanded import CommandedSurface
from millcorr.comparison.path_distance import PathDistance, SegmentTree
from millcorr.errors import LimitError
from millcorr.profile import SAME_HEIGHT
from millcorr.regeneration.path_following import length_in_plane
from millcorr.toolpath import Kind, Toolpath
from millcorr.verification import Verification

from .wanted_surface import WantedSurface

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

BELOW = 2 * SAME_HEIGHT
"""So far below a height, in mm, nothing that only cuts at it has come."""

REACHED = 0.01
"""A place where the program left more than this over the nominal, in mm, was never reached by the cutter: an inner
corner. Facets of 0.01 mm chord error are the coarsest that finish a surface."""


def prove_surface(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    before: WantedSurface,
    after: WantedSurface,
    radius: float,
    *,
    tolerance: float,
) -> tuple[Verification, tuple[float, tuple[float, float]]]:
    """Compare the surface of a written program with that of the original and with what was wanted.

    Parameters
    ----------
    original, written : CommandedSurface
        All passes of the program before, and of the text as it is read back.
    made_by : (n,) bool, (m,) bool
        Moves of either that make the surface and are corrected.
    before, after : WantedSurface
        What the original makes, and what the written one is to make.
    radius : float
        Distance in mm from contour to path.
    tolerance : float
        mm.

    Returns
    -------
    Verification
    stays : (float, (float, float))
        The most that stays of what was wanted because the cutter cannot reach it, mm, and where.

    Raises
    ------
    LimitError
        If the surface is farther off than the tolerance: names place, amount and, where a pass that stays cuts into it,
        its line.
    """
    wanted = after.moved - before.moved
    rest = _out_of_reach(after, radius) if radius > 0 else np.zeros(len(wanted))
    error = np.zeros(len(wanted))
    own = np.full(len(wanted), np.inf)
    reached = np.zeros(len(wanted), dtype=bool)
    for z in _heights(written.toolpath, made_by[1], after):
        was = original.only(made_by[0]).offset(before.nominal, before.normal, z)
        now = written.only(made_by[1]).offset(after.nominal, after.normal, z)
        made = np.isfinite(was) & ~after.at_corner & (was - before.moved < REACHED)
        _refuse_lost(made, now, after)
        known = np.isfinite(was) & np.isfinite(now) & ~after.at_corner
        here = known & made
        reached |= here
        own = np.where(here, np.fmin(own, was), own)
        # What was off before stays: rounding and chords of the program itself. What it left, as beside an inside
        # corner, may go; into the wanted surface nothing may cut.
        change, over = now - was - wanted, now - after.moved
        off = np.where(change > 0, np.where(here, np.maximum(change - rest, 0.0), 0.0), np.maximum(change, over))
        off = np.where(known, np.where(change > 0, off, np.minimum(off, 0.0)), 0.0)
        error = np.where(np.abs(off) > np.abs(error), off, error)
    worst = int(np.argmax(np.abs(error)))
    x, y = after.place[worst]
    length = float(length_in_plane(written.toolpath.take(made_by[1])).sum())
    result = Verification(float(abs(error[worst])), (float(x), float(y)), float(max(0.0, -error.min())), length)
    if abs(error[worst]) > tolerance:
        raise LimitError(
            f"the corrected surface would be {abs(error[worst]) * 1000:.2f} um off at X{x:.3f} Y{y:.3f}, more than "
            f"the tolerance of {tolerance * 1000:g} um"
            + (" (the cutter gouges there)" if error[worst] < 0 else ": where that does no harm, a larger --tolerance")
        )
    if radius > 0:
        _refuse_gouging_others(original, written, made_by, after, own, wanted, tolerance)
    # What was out of reach before, as the corners of facets are, is no matter of the correction.
    more = np.where(reached, rest - (_out_of_reach(before, radius) if radius > 0 else 0.0), 0.0)
    most = int(np.argmax(more))
    x, y = after.place[most]
    return result, (float(more[most]), (float(x), float(y)))


def _refuse_lost(made: Bools, now: Floats, after: WantedSurface) -> None:
    """LimitError where the written program does not cut what the original did, or nothing can be compared."""
    lost = np.flatnonzero(made & np.isnan(now))
    if len(lost) or not made.any():
        x, y = after.place[lost[0] if len(lost) else 0]
        raise LimitError(f"the written program leaves no surface near X{x:.3f} Y{y:.3f} that could be proven")


def _heights(toolpath: Toolpath, made_by: Bools, surface: WantedSurface) -> list[Floats | None]:
    """Heights at which the surface is looked at: where only the deepest pass cuts, and where all that make it do.

    A step of a wall is looked at where it begins and right below the next one.
    """
    z = toolpath.end[made_by, 2]
    known = z[np.isfinite(z)]
    if not len(known):
        return [None]
    low, high = surface.bottom, surface.top - BELOW
    return [np.clip(height, low, high) for height in sorted({float(known.min()), float(known.max())})]


def _refuse_gouging_others(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    after: WantedSurface,
    own: Floats,
    wanted: Floats,
    tolerance: float,
) -> None:
    """LimitError where another move of the written program cuts deeper into the corrected surface than before."""
    was, now = _left_by_others(original, made_by[0], after), _left_by_others(written, made_by[1], after)
    # Where another move cut deeper than the contour before, as one at another height does, or a lead that is rounder
    # than an inside corner, it is not for the contour to say what it may.
    rows = np.flatnonzero(np.isfinite(own) & np.isfinite(now) & ~after.at_corner & ~(was < own - tolerance))
    over = np.zeros(len(own))
    over[rows] = (now - own - wanted)[rows]
    worst = int(np.argmin(over))
    if over[worst] >= -tolerance:
        return
    x, y = after.place[worst]
    cuts = np.flatnonzero(~made_by[1] & np.isfinite(written.radius) & (written.toolpath.kind != int(Kind.RAPID)))
    _, row, _ = PathDistance(written.toolpath, cuts).nearest(
        after.nominal[worst : worst + 1] + now[worst] * after.normal[worst : worst + 1]
    )
    line = int(written.toolpath.source[row[0]]) + 1
    raise LimitError(
        f"line {line} of the corrected program, which is not corrected itself, would cut {-over[worst] * 1000:.1f} um "
        f"into the corrected surface at X{x:.3f} Y{y:.3f}: it leaves too little stock for it; --keep-allowance moves "
        "such passes along"
    )


def _left_by_others(surface: CommandedSurface, made_by: Bools, after: WantedSurface) -> Floats:
    """How far the surface of all other moves lies from the nominal, mm; NaN where none comes near; (n,)."""
    lowest = np.fmin(surface.toolpath.start[:, 2], surface.toolpath.end[:, 2])
    out = np.full(len(after.moved), np.nan)
    for top in np.unique(after.top):
        # What only cuts above a step of a wall is no matter of the step.
        rows, here = after.top == top, ~made_by & ~(lowest >= top - BELOW)
        out[rows] = surface.only(here).offset(after.nominal[rows], after.normal[rows])
    return out


def _out_of_reach(after: WantedSurface, radius: float) -> Floats:
    """What the cutter has to leave over the wanted surface, mm; (n,)."""
    z = np.where(np.isfinite(after.bottom), after.bottom, np.nan)
    centre = after.clearance(np.column_stack([after.nominal, z]), after.normal, radius, radius + after.moved)
    path = after.nominal + centre[:, None] * after.normal
    a, b = after.chords.T
    joined = np.hypot(*(path[b] - path[a]).T) < 2 * radius
    out = np.empty(len(path))
    for height in np.unique(after.bottom):
        here = after.bottom == height
        chords = joined & here[a]
        out[here] = SegmentTree(path[a[chords]], path[b[chords]]).distance(after.place[here]) - radius
    return np.maximum(out, 0.0)
