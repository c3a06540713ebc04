# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a control and its drives turn a commanded motion into the real one: the constants of a machine.

Every axis is a chain of linear filters of unit gain on the commanded position: acceleration and deceleration
behind the interpolator, then the servo. Linear acc/dec of time T is the mean over the last T, bell-shaped acc/dec
twice the mean over the last T/2, so that the jerk is limited; exponential acc/dec of time constant T and a servo of
gain Kv are lags of first order, of time constants T and 1/Kv.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from millcorr.arrays import Floats, Ints
from millcorr.errors import UsageError
from millcorr.messages import mm, phrase

SHAPES = ("linear", "bell", "exponential")
SHORTEST = 1e-3
"""No acc/dec and no servo is faster than this, in s; sums would lose digits."""

SHORTEST_BELL = 8e-3
"""The same for bell-shaped acc/dec, whose position is a second difference of sums: they lose 1e-8 mm in ten minutes."""

_NEARLY_EQUAL = 1e-5
"""Relative difference of two lags below which they are spread by this: it changes a path by 1e-10 of it."""
_DECAY = 40.0
"""Time constants after which a lag has forgotten: exp(-40) is 4e-18."""


@dataclass(frozen=True, slots=True)
class AxisDynamics:
    """Constants of one axis.

    Parameters
    ----------
    time : float
        Acc/dec behind the interpolator, in s: the duration of a change of speed if linear or bell-shaped, the time
        constant if exponential; 0 for none.
    shape : {"linear", "bell", "exponential"}
        Acceleration is constant; or rises and falls along lines (jerk 4 dv / T^2); or dies away.
    kv : float
        Servo gain in 1/s (at constant speed the axis is speed / kv behind); infinite for an ideal servo.
    rapid : float, optional
        Rapid speed in mm/s; where it is not known, rapids are left out and the time of a program is without them.

    Raises
    ------
    UsageError
        If a constant is no such number.
    """

    time: float = 0.0
    shape: str = "linear"
    kv: float = math.inf
    rapid: float | None = None

    def __post_init__(self) -> None:
        if self.shape not in SHAPES:
            raise UsageError(f"acc/dec is {' or '.join(SHAPES)}, not {self.shape!r}")
        shortest = SHORTEST_BELL if self.shape == "bell" else SHORTEST
        if not (self.time == 0 or shortest <= self.time < math.inf):
            raise UsageError(phrase("acc/dec time {:g} s: state 0, or {:g} s or more", self.time, shortest))
        if not (0 < self.kv <= 1 / SHORTEST or self.kv == math.inf):
            raise UsageError(
                phrase(
                    "servo gain {:g} 1/s: state a gain above 0 up to {:g}, or leave it out for an ideal servo",
                    self.kv,
                    1 / SHORTEST,
                )
            )
        if self.rapid is not None and not (math.isfinite(self.rapid) and self.rapid > 0):
            raise UsageError(phrase("rapid speed {:g} mm/s: state a speed above 0, or leave it out", self.rapid))

    @property
    def boxes(self) -> tuple[float, ...]:
        """Widths in s of the moving means, one behind the other."""
        if self.time == 0 or self.shape == "exponential":
            return ()
        return (self.time,) if self.shape == "linear" else (self.time / 2, self.time / 2)

    @property
    def box(self) -> float:
        """Time in s that the moving means look back; 0 for none."""
        return sum(self.boxes)

    @property
    def lags(self) -> tuple[tuple[float, float], ...]:
        """Weights and time constants in s of the lags whose sum is the chain without its moving mean.

        Two lags one after the other are (a A - b B) / (a - b) for the single lags A and B of time constants a, b.
        """
        exponential = self.time if self.shape == "exponential" else 0.0
        constants = [c for c in (exponential, 1.0 / self.kv) if c > 0]
        if len(constants) < 2:
            return tuple((1.0, c) for c in constants)
        a, b = constants
        if abs(a - b) < _NEARLY_EQUAL * (a + b):
            a, b = (a + b) / 2 * (1 + _NEARLY_EQUAL), (a + b) / 2 * (1 - _NEARLY_EQUAL)
        return (a / (a - b), a), (b / (b - a), b)

    @property
    def delay(self) -> float:
        """Mean delay in s: at constant speed the axis is speed times this behind the command."""
        return self.time / (1.0 if self.shape == "exponential" else 2.0) + 1.0 / self.kv

    @property
    def memory(self) -> float:
        """Time in s after which an earlier command is forgotten, to the precision of numbers."""
        return self.box + _DECAY * sum(c for _, c in self.lags)

    def response(self, omega: ArrayLike) -> NDArray[np.complex128]:
        """Frequency response at angular frequencies in rad/s: actual over commanded position."""
        s = 1j * np.asarray(omega, dtype=float)
        out = np.exp(-s * self.box / 2)
        for box in self.boxes:
            out = out * np.sinc(s.imag * box / (2 * np.pi))
        exponential = self.time if self.shape == "exponential" else 0.0
        result: NDArray[np.complex128] = out / ((1 + s * exponential) * (1 + s / self.kv))
        return result

    def left(self, wait: ArrayLike) -> Floats:
        """Way still to go, a unit of speed, `wait` s after a long move at constant speed has been commanded."""
        return self._tail(np.asarray(wait, dtype=float), 1, self.boxes)

    def left_of_ramp(self, wait: ArrayLike) -> Floats:
        """Way still to go, a unit of deceleration, `wait` s after a long ramp to standstill has been commanded."""
        return self._tail(np.asarray(wait, dtype=float), 2, self.boxes)

    def left_of_piece(self, first: Floats, last: Floats, since_first: Floats, since_last: Floats) -> Floats:
        """Way still to go of a command whose speed went along a line from `first` to `last`, so many s ago each."""
        lasted = since_first - since_last
        # A piece that takes no time leaves nothing, and has no slope.
        slope = np.divide(first - last, lasted, out=np.zeros_like(lasted), where=lasted > 0)
        out: Floats = last * self.left(since_last) - first * self.left(since_first)
        out += slope * (self.left_of_ramp(since_last) - self.left_of_ramp(since_first))
        out[lasted <= 0] = 0.0
        return out

    def _tail(self, wait: Floats, order: int, boxes: tuple[float, ...]) -> Floats:
        """What is left `wait` s after the command has ended: once or twice integrated answer to a step."""
        if not boxes:
            return self._lag_tail(wait, order)
        box, rest = boxes[0], boxes[1:]
        out: Floats = (self._tail(wait - box, order + 1, rest) - self._tail(wait, order + 1, rest)) / box
        return out

    def _lag_tail(self, wait: Floats, order: int) -> Floats:
        """Integral of order `order` from `wait` to infinity of one minus the lags' answer to a step at 0.

        The answer's complement is 1 before 0 and a sum of exponentials behind it.
        """
        behind = np.maximum(wait, 0.0)
        before = np.minimum(wait, 0.0)
        out = (-before) ** order / math.factorial(order)
        for weight, constant in self.lags:
            out = out + weight * constant**order * np.exp(-behind / constant)
            for k in range(1, order):
                out = out + weight * constant**k * (-before) ** (order - k) / math.factorial(order - k)
        return out


@dataclass(frozen=True, slots=True)
class ContourControl:
    """Look-ahead that slows down along the path before a corner (two-stage contour control).

    Ahead of a corner the feed falls along the path, without path error, to a corner feed at which no axis changes
    its speed by more than `speed_change`; that first stage takes the accuracy-maintenance time
    ``T = slope * feed + intercept`` (dat-2025, eq. 1). The second stage is the axes' own acc/dec.

    Parameters
    ----------
    speed_change : float
        Largest sudden change of commanded speed of one axis, in mm/s. The paper does not state it; it is a
        parameter of the control.
    slope : float
        In s per mm/s. Default: the paper's 0.0062 ms per mm/min.
    intercept : float
        In s. Default: the paper's 39.226 ms.

    Raises
    ------
    UsageError
        If a constant is no such number.
    """

    speed_change: float
    slope: float = 0.0062e-3 * 60.0
    intercept: float = 39.226e-3

    def __post_init__(self) -> None:
        if not self.speed_change > 0:
            raise UsageError(phrase("speed change at corners {:g} mm/s: state a speed above 0", self.speed_change))
        total = self.slope + self.intercept
        if not (self.slope >= 0 and self.intercept >= 0 and 0 < total < math.inf):
            raise UsageError(phrase("accuracy-maintenance time: slope and intercept are 0 or more, and not both 0"))

    def time(self, feed: ArrayLike) -> Floats:
        """Accuracy-maintenance time in s at programmed feeds in mm/s (dat-2025, eq. 1)."""
        return self.slope * np.asarray(feed, dtype=float) + self.intercept


@dataclass(frozen=True, slots=True)
class Control:
    """Control and drives of a machine.

    Parameters
    ----------
    x, y, z : AxisDynamics
    contour : ContourControl, optional
        None: no contour control, blocks follow one another at their full feeds and the axes' acc/dec overlap.
    in_position : float
        At exact stops, dwells and rapids the control waits until every axis is this near, in mm.

    Raises
    ------
    UsageError
        If `in_position` is not above 0.
    """

    x: AxisDynamics
    y: AxisDynamics
    z: AxisDynamics
    contour: ContourControl | None = None
    in_position: float = 0.01

    def __post_init__(self) -> None:
        if not self.in_position > 0:
            raise UsageError(phrase("in-position width {}: state a width above 0", mm(self.in_position, "g")))

    @staticmethod
    def alike(axis: AxisDynamics, contour: ContourControl | None = None, in_position: float = 0.01) -> Control:
        """Control whose three axes have the same constants."""
        return Control(axis, axis, axis, contour, in_position)

    @property
    def axes(self) -> tuple[AxisDynamics, AxisDynamics, AxisDynamics]:
        """The three axes."""
        return self.x, self.y, self.z

    @property
    def delay(self) -> float:
        """Mean delay in s of the slowest axis."""
        return max(axis.delay for axis in self.axes)

    @property
    def memory(self) -> float:
        """Time in s after which all axes have forgotten an earlier command."""
        return max(axis.memory for axis in self.axes)

    def settling(self, stop: Ints, speed: Floats, ahead: Floats, window: Floats) -> Floats:
        """Time from the commanded ends of runs of moves until all axes are within a window of them.

        What an axis has still to go is the command of the time before, weighted with how much of a step the axis
        has not answered yet (`AxisDynamics.left`); every piece of command counts, because a short last move of one
        axis leaves another one where an earlier move brought it.

        Parameters
        ----------
        stop : (m,) int64
            Run that each piece of command belongs to.
        speed : (m, 2, 3) float64
            Speeds of the axes in mm/s at the piece's beginning and end, in between along a line.
        ahead : (m, 2) float64
            Times in s from the piece's beginning and end to the commanded end of its run.
        window : (n,) float64
            In mm, of each run.

        Returns
        -------
        (n,) float64
            In s. Speeds count without their sign, so that it is never too short.
        """
        out = np.zeros(len(window))
        for k, axis in enumerate(self.axes):
            felt = (ahead[:, 0] > ahead[:, 1]) & (ahead[:, 1] < axis.memory) & (speed[:, :, k] != 0).any(axis=1)
            run, (v0, v1), (t0, t1) = stop[felt], np.abs(speed[felt, :, k]).T, ahead[felt].T
            low, high = np.zeros(len(window)), np.full(len(window), axis.memory)
            there = np.bincount(run, axis.left_of_piece(v0, v1, t0, t1), len(window)) <= window
            for _ in range(60):
                middle = (low + high) / 2
                wait = middle[run]
                near = np.bincount(run, axis.left_of_piece(v0, v1, t0 + wait, t1 + wait), len(window)) <= window
                low, high = np.where(near, low, middle), np.where(near, middle, high)
            out = np.maximum(out, np.where(there, 0.0, high))
        return out


def arc_shrinkage(radius: ArrayLike, feed: ArrayLike, axis: AxisDynamics) -> Floats:
    """How much smaller the axes run an arc at constant feed, after the way in has been forgotten.

    Parameters
    ----------
    radius : float or array
        In mm.
    feed : float or array
        In mm/s.
    axis : AxisDynamics
        Constants of both axes of the arc's plane.

    Returns
    -------
    float64 of the common shape
        ``r (1 - |H(v / r)|)`` in mm, exact for the model. For linear acc/dec T1 and a servo of 1/Kv = T2 this is
        ``(T1**2 / 24 + T2**2 / 2) v**2 / r`` but for terms of order ``v**4 T**4 / r**3``; bell-shaped acc/dec
        counts half as much, exponential acc/dec as T2 does.
    """
    r, v = np.asarray(radius, dtype=float), np.asarray(feed, dtype=float)
    out: Floats = r * (1.0 - np.abs(axis.response(v / r)))
    return out
