# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points smoothed over the parts of a series, and separated after.

An exponentially weighted moving average over parts is the best estimate of what wanders from part to part by a random
walk (Muth 1960): a part seen j parts ago tells of today as if its noise were ``(1 - 1/K)^(-j/2)`` times as large. So
the points of all parts of one program are separated together, each part counting ``(1 - 1/K)^j`` times; what is form
and what is noise they say alike, by what they share and what they do not. Points need not lie at the same places.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats
from millcorr.correction.wanted_displacement import staying_share
from millcorr.geometry.profile import Profile
from millcorr.separation import Filter
from millcorr.separation.steps import Systematic

from .journal import Entry
from .places import Places
from .points import Points, together
from .process_control import weights

PARTS = 8
"""So many parts are separated together, by 200 points each within 2 s; what earlier ones have shown is in what was
smoothed up to them. Form and noise are told apart by three."""


LEAST_PARTS = 3
"""Fewer parts of a series that is not smoothed are not looked at together."""

NOTICEABLE = 2.0
"""A form that stays is worth a word where it is more than so many times what the points of a part scatter by: below,
full corrections by single parts mill as much into the next one."""


@dataclass(frozen=True, eq=False, slots=True)
class Smoothed:
    """What the parts of one program show together, at the places; mm.

    Parameters
    ----------
    deviation : (n,) float64
        z, smoothed deviation from the nominal.
    machine : (n,) float64
        What the machine adds, to be taken out of a program that carries no correction.
    parts : int
        Over how many parts.
    """

    deviation: Floats
    machine: Floats
    parts: int


def over_parts(
    former: Sequence[Entry],
    points: Points,
    own: Systematic,
    commanded: Floats,
    weight: float,
    places: Places,
    nominal: Profile,
    filter: Filter,
    *,
    uncorrected: bool,
) -> Smoothed:
    """Smooth the points of a part with those of the parts before it that were cut with the same program.

    Parameters
    ----------
    former : sequence of Entry
        Those parts, in order. Where a journal lacks their points, as older ones do, what they were smoothed to stands
        for them.
    points : Points
        Of this part.
    own : Systematic
        What repeats of this part alone.
    commanded : (n,) float64
        What the program commands at the places, mm; NaN where it is not known.
    weight : float
        K.
    places : Places
    nominal : Profile
    filter : Filter
    uncorrected : bool
        The program carries no correction: z does not begin at 0 but is the weighted mean of its parts.

    Returns
    -------
    Smoothed
    """
    known: list[Points] = []
    for entry in reversed(former[-(PARTS - 1) :]):
        if entry.points is None:
            break
        known.insert(0, entry.points)
    share, rest = weights(len(known) + 1, weight)
    found = own
    if known:
        found = together([*known, points], weight * share, nominal, filter)
    stretch, s = places.along()
    machine, std = found.at(stretch, s)
    shown = np.nan_to_num(commanded) + machine
    # Far from any point the program stays as it is, but for the mean of what is left.
    unknown = np.where(np.isnan(commanded), 1.0, found.unknown(stretch, s))
    near = 1.0 - unknown
    mean = float(near @ shown / near.sum()) if near.sum() > 0 else float(np.mean(shown[np.isfinite(commanded)]))
    deviation = shown + staying_share(unknown) * (mean - shown)
    measured = np.isfinite(std)
    begun = former[len(former) - len(known) - 1].state if len(former) > len(known) else np.zeros(len(places))
    if uncorrected:
        rest = 0.0
    z = np.where(measured, rest * begun + (1.0 - rest) * deviation, begun)
    return Smoothed(z, np.where(measured, machine, 0.0), len(former) + 1)


def form_that_stays(
    former: Sequence[Entry], points: Points | None, applied: Floats, places: Places, nominal: Profile, filter: Filter
) -> tuple[float, float, int] | None:
    """The form that the last parts share and the program for the next one leaves, though every part was corrected.

    Parameters
    ----------
    former : sequence of Entry
        All parts before, whatever their programs.
    points : Points or None
        Of this part.
    applied : (n,) float64
        Sum of all corrections in force for the next part at the places, mm.
    places : Places
    nominal : Profile
    filter : Filter

    Returns
    -------
    (float, float, int) or None
        Its largest distance from its mean, mm; standard deviation of what parts do not share, mm; number of parts.
        None where it is within the band of what is known of it, or not worth a word.
    """
    known = [entry.points for entry in former[-(PARTS - 1) :] if entry.points is not None]
    if points is None or len(known) + 1 < LEAST_PARTS:
        return None
    found = together([*known, points], np.ones(len(known) + 1), nominal, filter)
    stretch, s = places.along()
    machine, _ = found.at(stretch, s)
    unknown = found.unknown(stretch, s)
    near = staying_share(unknown) < 1.0
    if not near.any():
        return None
    # Of the form alone: how far the parts lie apart is no matter of its distance from its mean.
    std = found.separated.sizes.form * np.sqrt(np.maximum(unknown, 0.0))
    band, scatter = found.separated.band, found.separated.random_std
    left = (machine + applied)[near]
    left = np.abs(left - left.mean())
    largest = int(np.argmax(left - band * std[near]))
    if left[largest] <= band * std[near][largest] or left.max() <= NOTICEABLE * scatter:
        return None
    return float(left.max()), scatter, len(known) + 1
