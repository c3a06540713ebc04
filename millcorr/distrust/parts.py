# SPDX-License-Identifier: LGPL-2.1-or-later
"""What several parts show beside each other, and a part beside the program that is said to have cut it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from millcorr.deviation import Deviation
from millcorr.parts import interpolated
from millcorr.profile import Profile

from .findings import Finding

Floats = NDArray[np.float64]

SAME = 5e-4
"""Points of two parts this near to each other, in mm, are equal: no process repeats so well everywhere."""

MOST = 0.8
"""A larger share of equal points is one part."""

UNUSED = 0.1
"""A larger share of a further part's points at places that the first says nothing of is worth another order."""

LEAST_OFFSET = 0.002
"""A program whose own offset varies by less than this along the part, in mm, shows nothing: a constant alone may as
well be another tool."""

SLOPE = (0.85, 1.15)
"""What is measured, over what the program takes away: 1 before it did so, MS / (1 + MS) and less after."""

EXPLAINED = 0.7
"""Share of the squared deviations that the earlier error must explain."""


def examine_parts(parts: Sequence[tuple[str, Deviation]], profile: Profile) -> tuple[Finding, ...]:
    """Parts that are one part measured, or exported, twice; parts that reach farther than the first.

    Parameters
    ----------
    parts : sequence of (str, Deviation)
        Name of the file and used points of each part; the first one's places are used.
    profile : Profile

    Returns
    -------
    tuple of Finding
    """
    from scipy.spatial import cKDTree

    found = []
    points = [np.column_stack([d.foot + d.value[:, None] * d.normal, d.z]) for _, d in parts]
    trees = [cKDTree(p) for p in points]
    for later in range(1, len(parts)):
        for earlier in range(later):
            few, tree = (earlier, later) if len(points[earlier]) < len(points[later]) else (later, earlier)
            if not len(points[few]):
                continue
            share = float((trees[tree].query(points[few])[0] < SAME).mean())
            if share > MOST:
                text = (
                    f"{100 * share:.0f} % of the points of {parts[few][0]} lie within {SAME * 1000:g} um of those of "
                    f"{parts[earlier + later - few][0]}: the same part again, and no mean of two; give each part once"
                )
                found.append(Finding("same-part", text, True))
    name, first = parts[0]
    for source, other in parts[1:]:
        ahead = interpolated(other, first, first.value, profile)
        unused = float((~np.isfinite(ahead)).mean()) if len(other) else 0.0
        # Where nothing at all is shared, averaging says so.
        if UNUSED < unused < 1.0:
            text = (
                f"{100 * unused:.0f} % of the points of {source} lie where {name} has none, and only places of the "
                f"first part are corrected: name first the part that was measured all round (--measured {source})"
            )
            found.append(Finding("first-part", text, True))
    return tuple(found)


def examine_program(value: Floats, offset: Floats, gain: float = 1.0) -> tuple[Finding, ...]:
    """Whether a part was cut by an earlier program than the one to correct.

    Parameters
    ----------
    value : (n,) float64
        Deviations from the nominal, mm.
    offset : (n,) float64
        The program's own offset from the nominal, mm: less what it takes away.
    gain : float
        Share of the error that the program's correction takes away.

    Returns
    -------
    tuple of Finding

    Notes
    -----
    A program that commands -m to take an error m away leaves next to nothing of m. A part that still shows m all
    along was cut before: adding m to -m again would take twice what is there.
    """
    if len(value) < 3 or gain <= 0 or float(offset.std()) < LEAST_OFFSET:
        return ()
    shape, seen = offset - offset.mean(), value - value.mean()
    if not seen.any():
        return ()
    slope = -gain * float(seen @ shape) / float(shape @ shape)
    left = value + slope / gain * offset
    explained = 1.0 - max(float(left @ left) / float(value @ value), float(left.var()) / float(value.var()))
    if not SLOPE[0] <= slope <= SLOPE[1] or explained < EXPLAINED:
        return ()
    text = (
        f"the part shows {100 * slope:.0f} % of just the errors (up to {np.abs(offset).max() * 1000:.0f} um) that the "
        f"program takes away already, {100 * explained:.0f} % of its deviations: was it cut with this program, and not "
        "with the earlier one? Measure a part cut with this program, or give the program that cut this one"
    )
    return (Finding("earlier-program", text, True),)
