# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trend and jump in a series of parts told apart, with a fixed rate of false alarms.

What is looked at is what the machine does: the measured deviation less what the program commands. A correction of
e shows in it only by the share ``-b e`` that an elastic machine gives back, ``b = MS / (1 + MS)``, which is not known:
a change counts as one only if it is significant whatever b is, from 0 to `MOST_GIVEN_BACK`. Wear and a new tool are.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats
from millcorr.correction.transfer_function import IMPLAUSIBLE
from millcorr.messages import phrase, um

FALSE_ALARMS = 0.01
"""Largest probability of a false alarm a part, all quantities together."""

WINDOW = 25
"""Parts that are looked back on."""

LEAST_PARTS = 5
"""Fewer parts show neither trend nor jump."""

RESOLUTION = 1e-4
"""Scatter in mm below which no series is believed to be: the last digit of measured files."""

MOST_GIVEN_BACK = IMPLAUSIBLE / (1 + IMPLAUSIBLE)
"""Largest share of a correction that an elastic machine may give back."""

COMPONENTS = ("mean", "place X", "place Y")
_SAID = {
    "mean": phrase("mean"),
    "place X": phrase("place X"),
    "place Y": phrase("place Y"),
    "form": phrase("form"),
}
"""What changes, as it is said."""
"""What a deviation is taken apart into: size of the part, and displacement of the part."""

FORM = "form"
"""What is left of it, as a share in what the parts have in common; see `form.shared_form`."""


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


def examine(
    value: Floats, commanded: Floats | None = None, *, trending: bool = False, false_alarms: float = FALSE_ALARMS
) -> Change | None:
    """Trend or jump in one quantity of consecutive parts, or None.

    Student's test of the slope, and of the difference of means before and after every possible place of a jump,
    the second with Bonferroni's factor for the number of places; each has half of `false_alarms`, which is so
    kept whatever the number of parts. Where both are significant the model that leaves the smaller sum of
    squares, weighed with Akaike's corrected criterion, is named.

    Parameters
    ----------
    value : (n,) float64
        mm; a part is left out where it is NaN.
    commanded : (n,) float64, optional
        The same quantity of what the program of each part commanded, mm; a share of up to `MOST_GIVEN_BACK` of it may
        have come back. By default the same on all parts.
    trending : bool
        A trend is known; only a jump away from its line is looked for.
    false_alarms : float
        Largest probability that a series of independent normal values is called a trend or a jump.
    """
    rows = np.flatnonzero(np.isfinite(value))
    y, n = value[rows], len(rows)
    if n < LEAST_PARTS:
        return None
    given = np.zeros(n) if commanded is None else commanded[rows]
    time = rows.astype(np.float64)
    line = np.column_stack([np.ones(n), time - time.mean()])
    after = np.arange(1, n)
    steps = (np.arange(n)[:, None] >= after).astype(np.float64)
    jumps = _Added.of(line if trending else line[:, :1], steps, y, given)
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
    slope = _Added.of(line[:, :1], line[:, 1:], y, given)
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


def changes(
    value: Floats, commanded: Floats | None = None, *, false_alarms: float = FALSE_ALARMS
) -> tuple[Change, ...]:
    """Follow one quantity from part to part, as it would have been seen at the time.

    After a jump that two parts show, what was before is forgotten. A trend is stated once, with the last part
    that it was seen at.

    Parameters
    ----------
    value, commanded : (n,) float64
        mm; see `examine`.
    false_alarms : float
        For each part; see `examine`.
    """
    commanded = np.zeros(len(value)) if commanded is None else commanded
    out: list[Change] = []
    first, trend = 0, False
    for end in range(1, len(value) + 1):
        begin = max(first, end - WINDOW)
        found = examine(value[begin:end], commanded[begin:end], trending=trend, false_alarms=false_alarms)
        if out and not out[-1].settled:
            # A single part far off: the next one has shown whether it was a jump.
            out.pop()
        if found is None:
            if trend:
                out[-1] = _with_last(out[-1], value, commanded, end - 1)
            continue
        found = Change(found.kind, found.part + begin, found.last + begin, found.size, found.error, found.probability)
        out.append(found)
        trend = found.kind == "trend" or (trend and not found.settled)
        if found.kind == "jump" and found.settled:
            first = found.part
    return tuple(out)


def _with_last(change: Change, value: Floats, commanded: Floats, last: int) -> Change:
    """The trend with its slope through all parts up to the last one."""
    if change.kind != "trend":
        return change
    rows = np.arange(change.part, last + 1)[np.isfinite(value[change.part : last + 1])]
    time = rows - rows.mean()
    slope = _Added.of(np.ones((len(rows), 1)), time[:, None], value[rows], commanded[rows])
    return Change("trend", change.part, last, float(slope.size[0]), float(slope.error[0]), float(slope.probability[0]))


@dataclass(frozen=True, eq=False, slots=True)
class _Added:
    """One more column in a regression, tried one at a time: its coefficient, and what is left over.

    The probability, and what is left, are those of the share of `commanded` that makes the column least significant.
    """

    size: Floats
    error: Floats
    probability: Floats
    rest: Floats

    @staticmethod
    def of(base: Floats, columns: Floats, y: Floats, commanded: Floats) -> _Added:
        """Regress y on `base` and each of the columns; Student's test of the column, two-sided."""
        from scipy.special import stdtr

        q, _ = np.linalg.qr(base)
        y, given, columns = (v - q @ (q.T @ v) for v in (y, commanded, columns))
        square = (columns**2).sum(axis=0)
        # For y + b given the coefficient is size + b own, and the sum of squares left r0 + 2 r1 b + r2 b^2.
        size, own = columns.T @ y / square, columns.T @ given / square
        r0, r1, r2 = y @ y - square * size**2, y @ given - square * size * own, given @ given - square * own**2
        freedom = len(y) - base.shape[1] - 1

        def rest(b: Floats) -> Floats:
            out: Floats = np.maximum(r0 + 2 * r1 * b + r2 * b**2, 0.0)
            return out

        def error(b: Floats) -> Floats:
            out: Floats = np.sqrt(np.maximum(rest(b) / freedom, RESOLUTION**2) / square)
            return out

        # Their quotient squared has its extremes at the ends of the range, where the coefficient is 0, and at one more.
        with np.errstate(divide="ignore", invalid="ignore"):
            inner = [-size / own, (size * r1 - own * r0) / (own * r1 - size * r2)]
        tried = np.array([np.zeros(len(size)), np.full(len(size), MOST_GIVEN_BACK), *inner])
        tried = np.clip(np.nan_to_num(tried), 0.0, MOST_GIVEN_BACK)
        quotient = np.array([np.abs((size + b * own) / error(b)) for b in tried])
        least = np.argmin(quotient, axis=0)
        each = np.arange(len(size))
        probability = 2 * stdtr(freedom, -quotient[least, each])
        return _Added(size, error(np.zeros(len(size))), probability, rest(tried[least, each]))


def _akaike(rest: float, n: int, parameters: int) -> float:
    variance = max(rest / n, RESOLUTION**2)
    return float(n * np.log(variance) + 2 * parameters * n / max(n - parameters - 1, 0.5))


_CAUSES = {
    ("trend", "mean"): phrase("tool wear or warming"),
    ("trend", "place X"): phrase("warming of the machine or of the fixture"),
    ("trend", "place Y"): phrase("warming of the machine or of the fixture"),
    ("trend", "form"): phrase("wear or warming that is not the same all along the contour"),
    ("jump", "form"): phrase("another tool, another stock, or a clamping that bends the part"),
    ("jump", "mean"): phrase("a new tool, another offset or another batch of material"),
    ("jump", "place X"): phrase("a chip at the stop, another clamping or another datum"),
    ("jump", "place Y"): phrase("a chip at the stop, another clamping or another datum"),
}


def in_words(change: Change, component: str, numbers: list[int]) -> str:
    """One line about a change; `numbers` are the parts' own, by index."""
    size, cause, of = um(change.size, "+.2f"), _CAUSES[change.kind, component], _SAID[component]
    if change.kind == "trend":
        return phrase(
            "drift of the {} by {} a part from part {} to {} (+- {}, p {:.1g}): {}",
            of,
            size,
            numbers[change.part],
            numbers[change.last],
            um(change.error, ".2f"),
            change.probability,
            cause,
        )
    if not change.settled:
        cause = phrase("{}; one part shows it so far, measure another", cause)
    return phrase(
        "jump of the {} by {} before part {} (p {:.1g}): {}", of, size, numbers[change.part], change.probability, cause
    )
