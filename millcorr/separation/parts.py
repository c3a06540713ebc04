# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several parts of the same nominal: their mean deviation, and the spread from part to part.

Averaging parts is the best filter there is: it needs no assumption about the shape of the errors. What differs
from part to part is the random part itself, measured.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.errors import InputError
from millcorr.geometry.correction import along
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase

LEVEL_REACH = 0.5
"""Levels of two parts are the same where their heights differ by less than this, in mm."""

GAP_SPACINGS = 3.0
"""Between points farther apart than so many typical spacings, a part says nothing about the place."""


@dataclass(frozen=True, eq=False, slots=True)
class Parts:
    """Deviations of several parts at the points of the first one.

    Parameters
    ----------
    mean : (n,) float64
        Mean over the parts that say something at the place, mm.
    count : (n,) int64
        How many parts do; at least 1.
    std : float
        Standard deviation from part to part, process and measurement together, mm: the root of the mean
        variance over the places with two parts or more. NaN where there is none.
    values : (m, n) float64
        What every one of the m parts says at the places, mm; NaN where it says nothing.
    """

    mean: Floats
    count: Ints
    std: float
    values: Floats


def same_levels(parts: Sequence[tuple[Ints, Floats]]) -> list[Ints]:
    """Numbers of the levels of each part, so that the same height of the same wall has the same number on all.

    Parameters
    ----------
    parts : sequence of ((k,) int64, (k,) float64)
        Of the levels of each part the step that it belongs to, -1 for none, and its height, mm; NaN where that is not
        known.
    """
    known: list[tuple[int, float]] = []
    out = []
    for number, (steps, heights) in enumerate(parts):
        levels = []
        for step, z in zip(steps.tolist(), heights.tolist(), strict=True):
            apart = [abs(z - other) if step == same else math.inf for same, other in known]
            near = int(np.argmin(apart)) if number > 0 and apart else 0
            # On one part heights are apart already.
            if number == 0 or not apart or not apart[near] < LEVEL_REACH:
                near = len(known)
                known.append((step, z))
            levels.append(near)
        out.append(np.array(levels, dtype=np.int64))
    return out


def averaged(parts: Sequence[tuple[Deviation, Floats]], profile: Profile) -> Parts:
    """Mean over parts at the points of the first.

    Parameters
    ----------
    parts : sequence of (Deviation, (n,) float64)
        Of each part its used points and the values to average, in mm.
    profile : Profile
        Nominal; the values of a part are interpolated along it, linearly, between neighbouring points.

    Returns
    -------
    Parts

    Raises
    ------
    InputError
        If a further part has no point near those of the first.
    """
    first, values = parts[0]
    rows = [values]
    for number, (other, seen) in enumerate(parts[1:], 2):
        at = interpolated(first, other, seen, profile)
        if not np.isfinite(at).any():
            raise InputError(
                phrase("part {} was measured at other places than the first: nothing can be averaged", number)
            )
        rows.append(at)
    table = np.stack(rows)
    count = np.isfinite(table).sum(axis=0)
    mean = np.nansum(table, axis=0) / count
    several = count > 1
    square = np.nansum((table[:, several] - mean[several]) ** 2, axis=0)
    std = float(np.sqrt((square / (count[several] - 1)).mean())) if several.any() else float("nan")
    for array in (mean, count, table):
        array.flags.writeable = False
    return Parts(mean, count, std, table)


def interpolated(first: Deviation, other: Deviation, values: Floats, profile: Profile) -> Floats:
    """Values of another part, mm, at the first one's points, (n,); NaN where it has no point on both sides nearby."""
    out = np.full(len(first), np.nan)
    stretches = profile.stretches()
    for number in np.unique(first.stretch):
        stretch = stretches[number]
        for level in np.unique(first.level[first.stretch == number]):
            here = np.flatnonzero((first.stretch == number) & (first.level == level))
            there = np.flatnonzero(other.stretch == number)
            if len(there):
                height = other.z[there] - float(first.z[here].mean())
                there = there[np.abs(height) < LEVEL_REACH]
            if len(there) < 2:
                continue
            s = along(stretch, other.s[there], profile)
            order = np.argsort(s, kind="stable")
            s, v = s[order], values[there][order]
            typical = float(np.median(np.diff(s)))
            if stretch.closed:
                s, v = np.r_[s[-1] - stretch.length, s, s[0] + stretch.length], np.r_[v[-1], v, v[0]]
            at = along(stretch, first.s[here], profile)
            after = np.clip(np.searchsorted(s, at), 1, len(s) - 1)
            width = s[after] - s[after - 1]
            # Just beyond the outermost point of an open stretch its value still holds.
            inside = (at >= s[0] - typical) & (at <= s[-1] + typical) & (width <= GAP_SPACINGS * max(typical, 1e-9))
            out[here[inside]] = np.interp(at[inside], s, v)
    return out
