# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is corrected at every place of the measured contours, with its bands, and where it rests on no points."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.correction.wanted_displacement import local
from millcorr.pipeline import Result
from millcorr.plausibility import gaps

PLACES = 700
"""Places a contour: a drawing's width in pixels."""

SAME = 0.2
"""Where the model's uncertainty at the points is off the result's by a larger share, the result is not its own."""


@dataclass(frozen=True, eq=False, slots=True)
class Posterior:
    """The determined part along one smooth stretch.

    Parameters
    ----------
    stretch : int
    s : (k,) float64
        mm from the stretch's start, increasing from there to its end.
    value, std : (k,) float64
        Determined part and its standard uncertainty, mm.
    band : float
        Factor on it for a band that holds along the whole contour with 95 %.
    bare : (k,) bool
        Where no sound point is near.
    """

    stretch: int
    s: Floats
    value: Floats
    std: Floats
    band: float
    bare: Bools


def posteriors(result: Result) -> tuple[Posterior, ...]:
    """Determined part along all stretches of measured contours.

    Parameters
    ----------
    result : Result

    Returns
    -------
    tuple of Posterior
        Empty where nothing was measured, or where more than the model went into the result: parts cut at several
        depths.
    """
    found, d, profile = result.systematic, result.deviation, result.nominal
    if found is None or not len(d):
        return ()
    stretches, at = profile.stretches(), local(profile, d.stretch, d.s)
    mean, std = found.at(d.stretch, at)
    if not np.allclose(result.uncertainty, std, rtol=SAME):
        return ()
    # What the program carries of its own is known at the points.
    own = result.filtered - mean
    bare = gaps(found.separated, profile)
    out = []
    for k, stretch in enumerate(stretches):
        if stretch.contour not in d.contour:
            continue
        total = float(profile.total[stretch.contour])
        s = np.linspace(0.0, stretch.length, max(4, math.ceil(PLACES * stretch.length / total)) + 1)
        value, uncertain = found.at(np.full(len(s), k), s)
        rows = np.flatnonzero(d.stretch == k)
        if len(rows):
            rows = rows[np.argsort(at[rows])]
            value = value + np.interp(s, at[rows], own[rows], period=stretch.length if stretch.closed else None)
        else:
            value = value + own[stretch.contour == d.contour].mean()
        place, without = stretch.begin + s, np.zeros(len(s), dtype=bool)
        for gap in bare:
            if gap.contour == stretch.contour:
                past = place - gap.begin
                past = np.mod(past, total) if profile.contours[stretch.contour].closed else past
                without |= (past >= 0.0) & (past <= gap.end - gap.begin)
        out.append(Posterior(k, s, value, uncertain, found.separated.band, without))
    return tuple(out)


def runs(flags: Bools) -> list[tuple[bool, slice]]:
    """Rows of equal flags one after the other, each run with the first row of the next one."""
    cuts = np.flatnonzero(np.diff(flags)) + 1
    ends = [*cuts.tolist(), len(flags)]
    return [
        (bool(flags[low]), slice(low, min(high + 1, len(flags))))
        for low, high in zip([0, *cuts.tolist()], ends, strict=True)
    ]
