# SPDX-License-Identifier: LGPL-2.1-or-later
"""The actual motion of a program: where the tool is, and how fast, at every time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.errors import UsageError
from millcorr.nc.toolpath import Toolpath

from .control import Control
from .response import Response
from .schedule import Halts, Schedule, schedule

STEP = 0.001
"""Time in s between samples of a motion where none is asked for."""
LARGEST = 20_000_000
"""A motion with more samples is not made as a whole."""
_BLOCK = 8192
"""Moves whose pieces are held at a time."""


@dataclass(frozen=True, eq=False, slots=True)
class Motion(ReadOnlyArrays):
    """Actual motion of the tool, sampled; every sample is exact for the model.

    Parameters
    ----------
    t : (n,) float64
        Time in s from the start of the first move that is followed, increasing.
    x, y, z : (n,) float64
        Actual position in mm; NaN where the program has not stated the coordinate yet.
    feed : (n,) float64
        Actual speed of the tool along its path in mm/s.
    s : (n,) float64
        Path length in mm, along the commanded path from its start without left-out moves, of the place that was
        commanded one mean delay before: where the tool is, exactly so at constant speed. Not decreasing.
    move : (n,) int64
        Move of the toolpath at that place.
    omitted : (k,) int64
        Moves of the toolpath that were not followed; see `Schedule`.
    """

    t: Floats
    x: Floats
    y: Floats
    z: Floats
    feed: Floats
    s: Floats
    move: Ints
    omitted: Ints

    def __len__(self) -> int:
        return len(self.t)

    @property
    def points(self) -> Floats:
        """Actual positions (n, 3) in mm."""
        return np.column_stack([self.x, self.y, self.z])

    def mean_feed(self, moves: int) -> Floats:
        """Mean actual feed in mm/s on each of a number of moves, (moves,); NaN where no sample lies on one."""
        count = np.bincount(self.move, minlength=moves)
        total = np.bincount(self.move, weights=self.feed, minlength=moves)
        out: Floats = np.divide(total, count, out=np.full(len(count), np.nan), where=count > 0)
        return out

    @staticmethod
    def concatenate(parts: list[Motion]) -> Motion:
        """One stretch of motion after another."""
        names = [item.name for item in fields(Motion) if item.name != "omitted"]
        arrays = {name: np.concatenate([getattr(part, name) for part in parts]) for name in names}
        return Motion(**arrays, omitted=parts[0].omitted)


def motion(
    toolpath: Toolpath,
    control: Control,
    *,
    halts: Halts | None = None,
    step: float = STEP,
    name: str = "program",
) -> Motion:
    """Actual motion of a program.

    Parameters
    ----------
    toolpath : Toolpath
        Path of the cutter's centre.
    control : Control
    halts : Halts, optional
        Exact stops, dwells and opaque moves of the program.
    step : float
        Time between samples in s.
    name : str
        Name of the program for messages.

    Returns
    -------
    Motion
        From the first move to standstill behind the last one.

    Raises
    ------
    FormatError, InputError
        As `schedule`.
    UsageError
        If the step is no time, or makes more than `LARGEST` samples.
    """
    plan = schedule(toolpath, control, halts, name)
    if plan.duration > LARGEST * step > 0:
        raise UsageError(
            f"{name}: {plan.duration:.0f} s in steps of {step:g} s are too many samples: take a longer step, or "
            "`motions` stretch by stretch"
        )
    return Motion.concatenate(list(motions(plan, step=step)))


def motions(plan: Schedule, *, step: float = STEP) -> Iterator[Motion]:
    """Actual motion of a scheduled program, stretch by stretch, in memory that its length does not matter to.

    Parameters
    ----------
    plan : Schedule
    step : float
        Time between samples in s.

    Yields
    ------
    Motion
        Together all samples, each once.

    Raises
    ------
    UsageError
        If the step is no time.
    """
    for low, high in blocks(plan):
        progress.step()
        first, end = grid(low, high, step)
        t = np.arange(first, end, dtype=np.float64) * step
        if high == plan.duration:
            t = np.append(t[t < high], high)
        if len(t):
            yield _sampled(plan, response_between(plan, low, high), t)


def grid(low: float, high: float, step: float) -> tuple[int, int]:
    """Numbers of the first sample at or behind `low` and at or behind `high`; UsageError if the step is no time.

    The same rounding at both ends of a stretch: no sample twice, none lost.
    """
    if not step > 0:
        raise UsageError(f"step {step:g} s: state a time above 0")
    return int(np.ceil(low / step)), int(np.ceil(high / step))


def blocks(plan: Schedule) -> Iterator[tuple[float, float]]:
    """Times from and to of stretches of the program that are worked on at once."""
    for first in range(0, len(plan), _BLOCK):
        progress.step()
        last = first + _BLOCK
        yield float(plan.begin[first]), float(plan.begin[last]) if last < len(plan) else plan.duration


def response_between(plan: Schedule, low: float, high: float) -> Response:
    """Response that holds between two times: it begins so long before that what came earlier is forgotten."""
    first = int(np.searchsorted(plan.begin, low - plan.control.memory, side="right")) - 1
    last = int(np.searchsorted(plan.begin, high, side="right"))
    return Response(plan, max(first, 0), max(last, 1))


def evaluate(plan: Schedule, t: Floats) -> tuple[Floats, Floats]:
    """Actual motion of a scheduled program at any times.

    Parameters
    ----------
    plan : Schedule
    t : (n,) float64
        Times in s in any order; before and behind the program the machine stands still.

    Returns
    -------
    position : (n, 3) float64
        In mm.
    speed : (n, 3) float64
        Of the axes, in mm/s.
    """
    position, speed = np.empty((len(t), 3)), np.empty((len(t), 3))
    order = np.argsort(t, kind="stable")
    done = 0
    for low, high in blocks(plan):
        progress.step()
        end = len(t) if high == plan.duration else int(np.searchsorted(t, high, sorter=order))
        if end > done:
            these = order[done:end]
            position[these], speed[these] = response_between(plan, low, high).actual(t[these])
            done = end
    return position, speed


def _sampled(plan: Schedule, response: Response, t: Floats) -> Motion:
    position, speed = response.actual(t)
    at, s = plan.where(t - plan.control.delay)
    move = plan.row[at]
    position[plan.moves.unknown[move]] = np.nan
    x, y, z = (np.ascontiguousarray(c) for c in position.T)
    return Motion(t, x, y, z, np.sqrt((speed**2).sum(axis=1)), s, move, plan.omitted)
