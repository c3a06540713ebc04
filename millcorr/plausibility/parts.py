# SPDX-License-Identifier: LGPL-2.1-or-later
"""What several parts show beside each other, and a part beside the program that is said to have cut it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats
from millcorr.comparison.deviation import Deviation
from millcorr.geometry.profile import Profile
from millcorr.messages import option, phrase, um
from millcorr.readers.measurement import Measurement
from millcorr.separation.parts import interpolated

from .file import resolution
from .findings import Finding

SAME = 5e-4
"""Points of two parts this near to each other, in mm, are equal: no process repeats so well everywhere."""

MOST = 0.8
"""A larger share of equal points is one part."""

REPRINTED = 0.98
"""... and a larger share of points that are equal in the digits of the coarser file: ties may round either way."""

UNUSED = 0.1
"""A larger share of a further part's points at places that the first says nothing of is worth another order."""

LEAST_OFFSET = 5e-4
"""A program whose own offset varies by less than this along the part, in mm, shows nothing: paths are written to 1 um,
and a constant alone may as well be another tool."""

SLOPE = 0.15
"""What is measured, over what the program takes away, is 1 within this before it did so, MS / (1 + MS) after."""

CERTAIN = 5.0
"""So many standard deviations the slope must be from 0: by chance once in a million parts."""

EXPLAINED = 0.5
"""Share of the squared deviations, less those of the noise, that the earlier error must explain."""

LEAST_SIGNAL = 0.3
"""Where noise makes up all but this share of what the program takes away, its shape is not known."""


def examine_parts(
    parts: Sequence[tuple[Measurement, Deviation]], profile: Profile, *, at_first: bool = False
) -> tuple[Finding, ...]:
    """Parts that are one part measured, or exported, twice; parts that reach farther than the first.

    Parameters
    ----------
    parts : sequence of (Measurement, Deviation)
        Each part as read, and its used points, numbered as read.
    profile : Profile
    at_first : bool
        Whether only places of the first part are used, as for a transfer function.

    Returns
    -------
    tuple of Finding
    """
    progress.step()
    if len(parts) < 2:
        return ()
    from scipy.spatial import cKDTree

    found = []
    points = [np.column_stack([d.foot + d.value[:, None] * d.normal, d.z]) for _, d in parts]
    trees = [cKDTree(p) for p in points]
    for later in range(1, len(parts)):
        for earlier in range(later):
            few, many = (earlier, later) if len(points[earlier]) < len(points[later]) else (later, earlier)
            if not len(points[few]):
                continue
            share, within = float((trees[many].query(points[few])[0] < SAME).mean()), SAME
            if share <= MOST:
                share, within = _in_coarser_digits(parts[few], parts[many])
            if share > (MOST if within == SAME else REPRINTED):
                text = phrase(
                    "{:.0f} % of the points of {} lie within {} of those of {}: the same part again, and no mean "
                    "of two; give each part once",
                    100 * share,
                    parts[few][0].source,
                    um(within, ".2g"),
                    parts[many][0].source,
                )
                found.append(Finding("same-part", text, True))
    name, first = parts[0][0].source, parts[0][1]
    for read, other in parts[1:] if at_first else ():
        source = read.source
        ahead = interpolated(other, first, first.value, profile)
        unused = float((~np.isfinite(ahead)).mean()) if len(other) else 0.0
        # Where nothing at all is shared, averaging says so.
        if UNUSED < unused < 1.0:
            text = phrase(
                "{:.0f} % of the points of {} lie where {} has none, and only places of the first part tell "
                "the transfer function: name first the part that was measured all round ({})",
                100 * unused,
                source,
                name,
                option("measured", source),
            )
            found.append(Finding("first-part", text, True))
    return tuple(found)


def _in_coarser_digits(few: tuple[Measurement, Deviation], many: tuple[Measurement, Deviation]) -> tuple[float, float]:
    """Share of the points of one file that another gives with more or fewer digits, and how far they then lie, mm."""
    from scipy.spatial import cKDTree

    coarse, fine = sorted((resolution(few[0]), resolution(many[0])), reverse=True)
    if fine == coarse:
        return 0.0, 0.0
    # What was rounded twice is off by half of either step in each coordinate, and not only by the coarser one's.
    within = 0.5 * (coarse + fine) + 1e-9
    one, other = (read.points[deviation.index, :2] for read, deviation in (few, many))
    near = cKDTree(other).query(one, p=np.inf)[0] <= within
    return float(near.mean()), within


def examine_program(deviation: Deviation, offset: Floats, gain: float = 1.0) -> tuple[Finding, ...]:
    """Whether a part was cut by an earlier program than the one to correct.

    Parameters
    ----------
    deviation : Deviation
        Used points.
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
    progress.step()
    if len(deviation) < 8 or gain <= 0:
        return ()
    order = np.lexsort((deviation.s, deviation.stretch, deviation.level))
    value, offset = np.clip(deviation.value, *np.percentile(deviation.value, [2, 98]))[order], offset[order]
    shape, seen = offset - offset.mean(), value - value.mean()
    noise, of_offset = point_to_point(value) ** 2, point_to_point(offset) ** 2
    variance = float(shape @ shape) / len(shape)
    if variance - of_offset < max(LEAST_OFFSET**2, LEAST_SIGNAL * variance):
        return ()
    # Noise of the part that was corrected from is in the offset, too, and would make the slope too small.
    slope = -gain * float((seen * shape).mean()) / (variance - of_offset)
    left = value + slope / gain * offset
    of_slope = gain * float(left.std()) / np.sqrt(len(left) * (variance - of_offset))
    if abs(slope - 1.0) > SLOPE + 2.0 * of_slope or slope < CERTAIN * of_slope:
        return ()
    # What two parts differ by at random says nothing of their programs.
    random = noise + of_offset * (slope / gain) ** 2
    unexplained = max(
        (float((left**2).mean()) - random) / max(float((value**2).mean()) - noise, 1e-12),
        (float(left.var()) - random) / max(float(value.var()) - noise, 1e-12),
    )
    explained = min(1.0, 1.0 - unexplained)
    if explained < EXPLAINED:
        return ()
    text = phrase(
        "the part shows {:.0f} % of just the errors (up to {}) that the program takes away already, "
        "{:.0f} % of its deviations: was it cut with this program, and not with the earlier one? "
        "Measure a part cut with this program, or give the program that cut this one",
        100 * slope,
        um(np.abs(offset).max(), ".0f"),
        100 * explained,
    )
    return (Finding("earlier-program", text, True),)


def point_to_point(value: Floats) -> float:
    """Standard deviation in mm of values in order, from second differences: what is smooth drops out."""
    progress.step()
    if len(value) < 5:
        return 0.0
    second = value[1:-1] - 0.5 * (value[:-2] + value[2:])
    return float(1.482602 * np.median(np.abs(second)) / np.sqrt(1.5))
