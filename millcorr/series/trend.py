# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trend and jump in a series of parts told apart, with a fixed rate of false alarms.

What is looked at is what the machine does: the measured deviation less what the program commands. Corrections do
not show in it, wear and a new tool do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import stdtr

Floats = NDArray[np.float64]

FALSE_ALARMS = 0.01
"""Largest probability of a false alarm a part, all quantities together."""

WINDOW = 25
"""Parts that are looked back on."""

LEAST_PARTS = 5
"""Fewer parts show neither trend nor jump."""

RESOLUTION = 1e-4
"""Scatter in mm below which no series is believed to be: the last digit of measured files."""

COMPONENTS = ("mean", "place X", "place Y")
"""What a deviation is taken apart into: size of the part, and displacement of the part."""


@dataclass(frozen=True, slots=True)
class Change:
    """A trend or a jump.

    Parameters
    ----------
    kind : {'trend', 'jump'}
    part : int
        Index of the first part of the trend, or of the first part after the jump.
    last : int
        Index of the last part looked at.
    size : float
        mm a part of a trend, mm of a jump.
    error : float
        Its standard deviation, mm.
    probability : float
        Of a series as uneven as this one where nothing changes; at most.
    """

    kind: str
    part: int
    last: int
    size: float
    error: float
    probability: float

    @property
    def settled(self) -> bool:
        """False for a jump that one part alone shows: it may as well be a bad measurement."""
        return self.kind == "trend" or self.last > self.part


def components(deviation: Floats, normal: Floats) -> Floats:
    """Mean of a deviation and displacement of the part, by least squares over the places.

    Parameters
    ----------
    deviation : (n,) float64
        mm; NaN where unknown.
    normal : (n, 2) float64
        Directional cosines.

    Returns
    -------
    (3,) float64
        ``d = mean + X cos alpha + Y cos beta``, mm. X and Y are NaN where the contour does not tell them from the
        mean (an edge); the mean is then the plain one.
    """
    known = np.isfinite(deviation)
    design = np.column_stack([np.ones(int(known.sum())), normal[known]])
    if not len(design):
        return np.full(3, np.nan)
    singular = np.linalg.svd(design, compute_uv=False)
    if len(singular) < 3 or singular[-1] < 0.2 * np.sqrt(len(design)):
        return np.array([float(deviation[known].mean()), np.nan, np.nan])
    out: Floats = np.asarray(np.linalg.lstsq(design, deviation[known], rcond=None)[0], dtype=np.float64)
    return out


def examine(value: Floats, *, trending: bool = False, false_alarms: float = FALSE_ALARMS) -> Change | None:
    """Trend or jump in one quantity of consecutive parts, or None.

    Student's test of the slope, and of the difference of means before and after every possible place of a jump,
    the second with Bonferroni's factor for the number of places; each has half of `false_alarms`, which is so
    kept whatever the number of parts. Where both are significant the model that leaves the smaller sum of
    squares, weighed with Akaike's corrected criterion, is named.

    Parameters
    ----------
    value : (n,) float64
        mm; a part is left out where it is NaN.
    trending : bool
        A trend is known; only a jump away from its line is looked for.
    false_alarms : float
        Largest probability that a series of independent normal values is called a trend or a jump.
    """
    rows = np.flatnonzero(np.isfinite(value))
    y, n = value[rows], len(rows)
    if n < LEAST_PARTS:
        return None
    time = rows.astype(np.float64)
    line = np.column_stack([np.ones(n), time - time.mean()])
    after = np.arange(1, n)
    steps = (np.arange(n)[:, None] >= after).astype(np.float64)
    jumps = _Added.of(line if trending else line[:, :1], steps, y)
    best = int(np.argmin(jumps.probability))
    jump = Change(
        "jump",
        int(rows[after[best]]),
        int(rows[-1]),
        float(jumps.size[best]),
        float(jumps.error[best]),
        min(1.0, float(jumps.probability[best]) * (n - 1)),
    )
    if trending:
        return jump if jump.probability <= false_alarms else None
    slope = _Added.of(line[:, :1], line[:, 1:], y)
    trend = Change(
        "trend",
        int(rows[0]),
        int(rows[-1]),
        float(slope.size[0]),
        float(slope.error[0]),
        float(slope.probability[0]),
    )
    found = [change for change in (trend, jump) if change.probability <= false_alarms / 2]
    if len(found) < 2:
        return found[0] if found else None
    # Variance and constant, and the slope or the height and the place of the jump.
    score = [_akaike(slope.rest[0], n, 3), _akaike(jumps.rest[best], n, 4)]
    return trend if score[0] <= score[1] else jump


def changes(value: Floats, *, false_alarms: float = FALSE_ALARMS) -> tuple[Change, ...]:
    """Follow one quantity from part to part, as it would have been seen at the time.

    After a jump that two parts show, what was before is forgotten. A trend is stated once, with the last part
    that it was seen at.

    Parameters
    ----------
    value : (n,) float64
        mm.
    false_alarms : float
        For each part; see `examine`.
    """
    out: list[Change] = []
    first, trend = 0, False
    for end in range(1, len(value) + 1):
        begin = max(first, end - WINDOW)
        found = examine(value[begin:end], trending=trend, false_alarms=false_alarms)
        if out and not out[-1].settled:
            # A single part far off: the next one has shown whether it was a jump.
            out.pop()
        if found is None:
            if trend:
                out[-1] = _with_last(out[-1], value, end - 1)
            continue
        found = Change(found.kind, found.part + begin, found.last + begin, found.size, found.error, found.probability)
        out.append(found)
        trend = found.kind == "trend" or (trend and not found.settled)
        if found.kind == "jump" and found.settled:
            first = found.part
    return tuple(out)


def _with_last(change: Change, value: Floats, last: int) -> Change:
    """The trend with its slope through all parts up to the last one."""
    if change.kind != "trend":
        return change
    rows = np.arange(change.part, last + 1)[np.isfinite(value[change.part : last + 1])]
    time = rows - rows.mean()
    slope = _Added.of(np.ones((len(rows), 1)), time[:, None], value[rows])
    return Change("trend", change.part, last, float(slope.size[0]), float(slope.error[0]), float(slope.probability[0]))


@dataclass(frozen=True, eq=False, slots=True)
class _Added:
    """One more column in a regression, tried one at a time: its coefficient, and what is left over."""

    size: Floats
    error: Floats
    probability: Floats
    rest: Floats

    @staticmethod
    def of(base: Floats, columns: Floats, y: Floats) -> _Added:
        """Regress y on `base` and each of the columns; Student's test of the column, two-sided."""
        q, _ = np.linalg.qr(base)
        y = y - q @ (q.T @ y)
        columns = columns - q @ (q.T @ columns)
        square = (columns**2).sum(axis=0)
        size = (columns * y[:, None]).sum(axis=0) / square
        rest = ((y[:, None] - columns * size) ** 2).sum(axis=0)
        freedom = len(y) - base.shape[1] - 1
        error = np.sqrt(np.maximum(rest / freedom, RESOLUTION**2) / square)
        probability = 2 * stdtr(freedom, -np.abs(size / error))
        return _Added(size, error, probability, rest)


def _akaike(rest: float, n: int, parameters: int) -> float:
    variance = max(rest / n, RESOLUTION**2)
    return float(n * np.log(variance) + 2 * parameters * n / max(n - parameters - 1, 0.5))


_CAUSES = {
    ("trend", "mean"): "tool wear or warming",
    ("trend", "place X"): "warming of the machine or of the fixture",
    ("trend", "place Y"): "warming of the machine or of the fixture",
    ("jump", "mean"): "a new tool, another offset or another batch of material",
    ("jump", "place X"): "a chip at the stop, another clamping or another datum",
    ("jump", "place Y"): "a chip at the stop, another clamping or another datum",
}


def in_words(change: Change, component: str, numbers: list[int]) -> str:
    """One line about a change; `numbers` are the parts' own, by index."""
    size, cause = f"{change.size * 1000:+.2f} um", _CAUSES[change.kind, component]
    if change.kind == "trend":
        return (
            f"drift of the {component} by {size} a part from part {numbers[change.part]} to {numbers[change.last]} "
            f"(+- {change.error * 1000:.2f}, p {change.probability:.1g}): {cause}"
        )
    words = f"jump of the {component} by {size} before part {numbers[change.part]} (p {change.probability:.1g}): "
    return words + (cause if change.settled else f"{cause}; one part shows it so far, measure another")
