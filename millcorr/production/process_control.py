# SPDX-License-Identifier: LGPL-2.1-or-later
"""Process control of a series of parts: when to correct again, by how much, and what is going on.

Correcting every part at full gain mills the noise of every measurement into the next part (Deming's tampering:
1.41 times the scatter of the process). So deviations are smoothed over the parts, and the program stays as it is
while what is smoothed keeps within a limit. Everything here is pure: numbers in, numbers out.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats
from millcorr.errors import LimitError, UsageError
from millcorr.messages import option, phrase, um

ACCEPTED = "difference"
"""Name by which a part beyond the difference alarm is accepted."""

LIMITS = {
    "control_limit": "limit",
    "control_tolerance": "tolerance",
    "control_alarm": "alarm",
    "control_abort": "abort",
    "step_limit": "step_limit",
    "sum_limit": "sum_limit",
}
"""Fields of `Control` by the option that says them."""

_FINE = ".2f"
"""Micrometres as a decision says them."""


@dataclass(frozen=True, slots=True)
class Control:
    """Rules of a series; lengths in mm, compared with absolute values at every place of the contour.

    ``dead_band < limit < tolerance < alarm < abort``, where given: the order in which controls of machine tools
    judge a measured size.

    Parameters
    ----------
    weight : float
        k of the smoothing; 1 takes each part for itself.
    limit : float
        While the smoothed deviation stays within it, the program stays as it is.
    dead_band : float
        Places within it are left alone when a correction is due; see `compensation.dead_band`.
    tolerance : float
        A part beyond it is corrected at once, by its own deviation: to go on averaging would cut scrap.
    alarm : float
        A part beyond it differs too much from what was expected: refused until it is accepted.
    abort : float
        A part beyond it cannot be a part of this program: refused.
    step_limit, sum_limit : float
        Largest change by one correction, and largest sum of all of them.
    """

    weight: float
    limit: float
    dead_band: float = 0.0
    tolerance: float = math.inf
    alarm: float = math.inf
    abort: float = math.inf
    step_limit: float = math.inf
    sum_limit: float = math.inf

    def __post_init__(self) -> None:
        if not 1 <= self.weight < math.inf:
            raise UsageError(phrase("{}: K must be 1 or more", option("control", f"ewma:{self.weight:g}")))
        row = (
            ("dead_band", self.dead_band),
            ("control_limit", self.limit),
            ("control_tolerance", self.tolerance),
            ("control_alarm", self.alarm),
            ("control_abort", self.abort),
        )
        for key, value in (*row[1:], ("step_limit", self.step_limit), ("sum_limit", self.sum_limit)):
            if not value > 0:
                raise UsageError(phrase("{}: must be above 0", option(key, value)))
        if not 0 <= self.dead_band < math.inf:
            raise UsageError(phrase("{}: must not be negative", option("dead_band", self.dead_band)))
        if not self.limit < math.inf:
            raise UsageError(
                phrase("{} needs {}: the program stays as it is within it", option("control"), option("control_limit"))
            )
        for less, more in pairwise((key, value) for key, value in row if value < math.inf):
            if not less[1] < more[1]:
                raise UsageError(
                    phrase(
                        "{} must be below {}: dead band < limit < tolerance < alarm < abort",
                        option(*less),
                        option(*more),
                    )
                )
        if math.isfinite(self.step_limit) and self.step_limit > self.sum_limit:
            raise UsageError(
                phrase(
                    "{} must not be above {}",
                    option("step_limit", self.step_limit),
                    option("sum_limit", self.sum_limit),
                )
            )

    @staticmethod
    def parse(text: str) -> float:
        """Weight k of ``ewma:K``.

        Raises
        ------
        UsageError
            If the text is anything else.
        """
        kind, colon, argument = text.strip().lower().partition(":")
        try:
            if kind == "ewma" and colon:
                return float(argument)
        except ValueError:
            pass
        raise UsageError(
            phrase(
                "{}: write ewma:K, such as ewma:2, K being how many parts are smoothed over", option("control", text)
            )
        )

    def numbers(self) -> dict[str, float]:
        """The rules that are in force, by name."""
        return {name: value for name in self.__slots__ if (value := getattr(self, name)) < math.inf}


def weights(parts: int, weight: float) -> tuple[Floats, float]:
    """Weights of parts in the exponentially weighted moving average ``z <- D/k + z (1 - 1/k)``.

    Parameters
    ----------
    parts : int
        How many follow each other.
    weight : float
        k >= 1.

    Returns
    -------
    (parts,) float64
        Of D of each part, the oldest first.
    float
        Of z before the first of them; all together are 1.
    """
    kept = 1.0 - 1.0 / weight
    own: Floats = kept ** np.arange(parts - 1, -1, -1.0) / weight
    return own, float(kept**parts)


@dataclass(frozen=True, eq=False, slots=True)
class Decision:
    """What a part leads to.

    Parameters
    ----------
    kind : {'keep', 'smoothed', 'direct'}
        The program stays; it is corrected by the smoothed deviation; by the part's own.
    smoothed : (n,) float64
        z with this part in it, mm.
    state : (n,) float64
        z to go on with: 0 everywhere after a correction.
    reason : str
        One line.
    """

    kind: str
    smoothed: Floats
    state: Floats
    reason: str


def decide(
    smoothed: ArrayLike,
    deviation: ArrayLike,
    control: Control,
    *,
    alone: bool = False,
    accepted: bool = False,
) -> Decision:
    """Judge one part along the contour.

    Parameters
    ----------
    smoothed : (n,) or scalar
        z with this part in it, mm.
    deviation : (n,) or scalar
        Determined deviation of this part, mm; NaN where it was not measured.
    control : Control
    alone : bool
        The part is the only one yet of a program that carries no correction: z is its own deviation.
    accepted : bool
        A difference beyond the alarm is real.

    Raises
    ------
    LimitError
        Beyond abort; beyond the alarm without `accepted`.
    """
    d = np.asarray(deviation, dtype=np.float64)
    seen = _largest(d)
    if seen > control.abort:
        raise LimitError(
            phrase(
                "the part is {} off, more than {}: this cannot be a part of this program; nothing was "
                "recorded or written",
                um(seen, _FINE),
                option("control_abort", control.abort),
            ),
        )
    if seen > control.alarm and not accepted:
        raise LimitError(
            phrase(
                "the part is {} off, more than {}: look for the cause; if it is real and stays (a new tool), "
                "{} corrects it; nothing was recorded or written",
                um(seen, _FINE),
                option("control_alarm", control.alarm),
                option("accept", ACCEPTED),
            ),
        )
    z: Floats = np.asarray(smoothed, dtype=np.float64)
    zero = np.zeros_like(z)
    if seen > control.tolerance:
        return Decision(
            "direct",
            z,
            zero,
            phrase(
                "the part itself is {} off, beyond the tolerance of {}: corrected by its own deviation",
                um(seen, _FINE),
                um(control.tolerance, _FINE),
            ),
        )
    largest = _largest(z)
    beyond = um(largest, _FINE), um(control.limit, _FINE)
    if alone and largest > control.limit:
        return Decision(
            "direct",
            z,
            zero,
            phrase("first correction: the deviation, {} at most, is beyond the limit of {}", *beyond),
        )
    if largest > control.limit:
        reason = phrase("the smoothed deviation, {} at most, is beyond the limit of {}", *beyond)
        return Decision("smoothed", z, zero, reason)
    if alone:
        return Decision("keep", z, z, phrase("the deviation, {} at most, is within the limit of {}", *beyond))
    return Decision("keep", z, z, phrase("the smoothed deviation, {} at most, is within the limit of {}", *beyond))


def refuse_beyond(control: Control, step: ArrayLike, total: ArrayLike) -> None:
    """Refuse a correction beyond the limits on one step and on the sum.

    It is refused and not clipped: a clipped field has flat tops and kinks that nobody measured, and the part
    would pass for corrected.

    Parameters
    ----------
    control : Control
    step : (n,) or scalar
        Change by this correction, mm.
    total : (n,) or scalar
        Sum of all corrections with this one, mm.

    Raises
    ------
    LimitError
    """
    for what, value, limit, key, way_out in (
        (
            phrase("one correction would move the contour"),
            step,
            control.step_limit,
            "step_limit",
            phrase("look for what jumped"),
        ),
        (
            phrase("all corrections together would move the contour"),
            total,
            control.sum_limit,
            "sum_limit",
            phrase("change the tool"),
        ),
    ):
        largest = _largest(np.asarray(value, dtype=np.float64))
        if largest > limit:
            raise LimitError(
                phrase(
                    "{} by {}, more than {}: {}, or raise the limit; nothing was recorded or written",
                    what,
                    um(largest, _FINE),
                    option(key, limit),
                    way_out,
                ),
            )


def _largest(value: Floats) -> float:
    known = value[np.isfinite(value)] if value.ndim else np.atleast_1d(value)
    return float(np.abs(known).max()) if len(known) else 0.0
