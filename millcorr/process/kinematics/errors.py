# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the actual path lies from the commanded one: at corners, on arcs, and along the whole path."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.nc.toolpath import Kind, Plane, Toolpath

from .control import Control
from .motion import STEP, blocks, grid, response_between
from .response import Response
from .schedule import Halts, Schedule, schedule

LEAST_TURN = math.radians(1.0)
"""Changes of direction below this, in rad, are no corners: facets of a curve."""
_SCAN = 32
_HALVINGS = 24
_CANDIDATES = 48
_STILL = 1e-10
_MATCHES = 12


@dataclass(frozen=True, eq=False, slots=True)
class CornerErrors(ReadOnlyArrays):
    """How near the tool comes to the corners of its path, one row a corner that it passes without a stop.

    Parameters
    ----------
    move : (n,) int64
        Move of the toolpath that ends at the corner.
    vertex : (n, 3) float64
        The corner in mm.
    turn : (n,) float64
        Change of direction in rad, 0 to pi.
    feed : (n, 2) float64
        Commanded feed in mm/s just before and just behind it.
    error : (n,) float64
        Closest approach of the actual path to the corner, in mm.
    nearest : (n, 3) float64
        Place of the actual path that is nearest, in mm.
    t : (n,) float64
        When the tool is there, in s.
    """

    move: Ints
    vertex: Floats
    turn: Floats
    feed: Floats
    error: Floats
    nearest: Floats
    t: Floats

    def __len__(self) -> int:
        return len(self.move)


@dataclass(frozen=True, eq=False, slots=True)
class ArcErrors(ReadOnlyArrays):
    """How arcs are changed, one row an arc that is followed.

    Parameters
    ----------
    move : (n,) int64
        Move of the toolpath.
    radius : (n,) float64
        In mm.
    shrinkage : (n,) float64
        Radius lost in the middle of the arc, in mm.
    worst : (n,) float64
        Largest distance from the arc, in mm, of where the tool is while it is on the arc, its ends included.
    """

    move: Ints
    radius: Floats
    shrinkage: Floats
    worst: Floats

    def __len__(self) -> int:
        return len(self.move)


@dataclass(frozen=True, eq=False, slots=True)
class PathError(ReadOnlyArrays):
    """Distance of the actual path from the commanded one along its normal in the XY plane, one row a sample.

    Parameters
    ----------
    t : (n,) float64
        Time in s.
    s : (n,) float64
        Commanded path length of the foot point in mm.
    move : (n,) int64
        Move of the toolpath that the foot point lies on.
    foot : (n, 2) float64
        Nearest place of the commanded path, in mm.
    normal : (n, 2) float64
        Unit normal of the commanded path there, to the left of its direction.
    value : (n,) float64
        ``(actual - foot) . normal`` in mm, positive to the left. With the cutter left of the contour this is the
        deviation of the part (positive where material is left), with the cutter right of it its negative, as far
        as one place of the cutter makes one place of the part.
    """

    t: Floats
    s: Floats
    move: Ints
    foot: Floats
    normal: Floats
    value: Floats

    def __len__(self) -> int:
        return len(self.t)


def corner_errors(
    toolpath: Toolpath,
    control: Control,
    *,
    halts: Halts | None = None,
    least_turn: float = LEAST_TURN,
    name: str = "program",
) -> CornerErrors:
    """How near the tool comes to each corner that it passes without a stop.

    For a corner of 90 degrees between long lines at the feed v without contour control this is
    ``sqrt(2) v T / 8`` for linear acc/dec of time T alone and ``0.50886 v / Kv`` for a servo alone.

    Parameters
    ----------
    toolpath : Toolpath
    control : Control
    halts : Halts, optional
    least_turn : float
        Smallest change of direction that counts as a corner, in rad.
    name : str
        Name of the program for messages.

    Returns
    -------
    CornerErrors
        In the order of the path; empty where there are none.

    Raises
    ------
    FormatError, InputError
        As `schedule`.
    """
    plan = schedule(toolpath, control, halts, name)
    first, last = (d[plan.row] for d in plan.moves.directions())
    across = np.sqrt((np.cross(last[:-1], first[1:]) ** 2).sum(axis=1))
    turn = np.arctan2(across, (last[:-1] * first[1:]).sum(axis=1))
    corner = np.flatnonzero((turn >= least_turn) & ~plan.stop[:-1])
    vertex = plan.moves.toolpath.end[plan.row[corner]]
    begin = plan.begin[corner + 1]
    # Behind a corner the tool comes nearest about a mean delay later, and never later than it needs to settle.
    until = begin + 2.0 * max(axis.box + 4.0 * sum(c for _, c in axis.lags) for axis in control.axes)
    t, nearest = np.empty(len(corner)), np.empty((len(corner), 3))
    for low, high in blocks(plan):
        progress.step()
        these = np.flatnonzero((begin >= low) & (begin < high))
        if len(these):
            response = response_between(plan, low, float(until[these].max()))
            t[these], nearest[these] = _closest(response, vertex[these], begin[these], until[these])
    error = np.sqrt(((nearest - vertex) ** 2).sum(axis=1))
    feed = np.column_stack([plan.speed[corner, 2], plan.speed[corner + 1, 0]])
    return CornerErrors(plan.row[corner], vertex, turn[corner], feed, error, nearest, t)


def _closest(response: Response, vertex: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Times within bounds at which the tool is nearest to places, and where it then is."""

    def look(t: Floats) -> tuple[Floats, Floats, Floats]:
        position, speed = response.actual(t)
        off = position - vertex
        return (off**2).sum(axis=1), (off * speed).sum(axis=1), position

    best, where = np.full(len(vertex), np.inf), low.copy()
    step = (high - low) / _SCAN
    for k in range(_SCAN + 1):
        t = low + k * step
        distance = look(t)[0]
        nearer = distance < best
        best[nearer], where[nearer] = distance[nearer], t[nearer]
    a, b = np.maximum(where - step, low), np.minimum(where + step, high)
    for _ in range(_HALVINGS):
        t = (a + b) / 2
        away = look(t)[1] > 0
        a, b = np.where(away, a, t), np.where(away, t, b)
    t = (a + b) / 2
    # At a minimum the halving stays; elsewhere the scan knows better.
    distance, _, position = look(t)
    scanned = look(where)
    worse = distance > scanned[0]
    return np.where(worse, where, t), np.where(worse[:, None], scanned[2], position)


def arc_errors(toolpath: Toolpath, control: Control, *, halts: Halts | None = None, name: str = "program") -> ArcErrors:
    """Radius lost on each arc of a program; see `arc_shrinkage` for the closed form of a long one.

    Parameters
    ----------
    toolpath : Toolpath
    control : Control
    halts : Halts, optional
    name : str
        Name of the program for messages.

    Returns
    -------
    ArcErrors
        In the order of the path; empty where there are none.

    Raises
    ------
    FormatError, InputError
        As `schedule`.
    """
    plan = schedule(toolpath, control, halts, name)
    path = plan.moves.toolpath
    arcs = np.flatnonzero(path.kind[plan.row] == Kind.ARC)
    move = plan.row[arcs]
    axes = np.array([Plane(p).axes[:2] for p in (17, 18, 19)])[path.plane[move] - 17]
    centre = np.take_along_axis(path.centre[move], axes, axis=1)
    radius = np.sqrt(((np.take_along_axis(path.start[move], axes, axis=1) - centre) ** 2).sum(axis=1))
    shares = np.linspace(0.0, 1.0, _SCAN + 1)
    lost = np.empty((len(arcs), len(shares)))
    duration = plan.phase[arcs, :3].sum(axis=1)
    for low, high in blocks(plan):
        progress.step()
        these = np.flatnonzero((plan.begin[arcs] >= low) & (plan.begin[arcs] < high))
        if not len(these):
            continue
        t = plan.begin[arcs[these], None] + duration[these, None] * shares + control.delay
        response = response_between(plan, low, float(t.max()))
        position = response.actual(t.ravel())[0].reshape(len(these), len(shares), 3)
        inside = np.take_along_axis(position, axes[these, None, :], axis=2) - centre[these, None, :]
        lost[these] = radius[these, None] - np.sqrt((inside**2).sum(axis=2))
    return ArcErrors(move, radius, lost[:, _SCAN // 2].copy(), np.abs(lost).max(axis=1, initial=0.0))


def path_errors(
    toolpath: Toolpath,
    control: Control,
    *,
    halts: Halts | None = None,
    step: float = STEP,
    name: str = "program",
) -> PathError:
    """Normal distance of the actual path from the commanded one, sampled along the feed moves.

    The foot point of each sample is the nearest place that was commanded since as long ago as the axes remember
    more than a thousandth: what the path does elsewhere does not count.

    Parameters
    ----------
    toolpath : Toolpath
    control : Control
    halts : Halts, optional
    step : float
        Time between samples in s.
    name : str
        Name of the program for messages.

    Returns
    -------
    PathError
        Without samples whose foot point lies on a rapid, or where the path does not run in X or Y.

    Raises
    ------
    FormatError, InputError
        As `schedule`.
    UsageError
        If the step is no time.
    """
    plan = schedule(toolpath, control, halts, name)
    grid(0.0, 0.0, step)
    span = max(axis.box + 7.0 * sum(c for _, c in axis.lags) for axis in control.axes)
    back = int(np.ceil(span / step)) + 1
    parts = []
    for low, high in blocks(plan):
        progress.step()
        first, end = grid(low, high, step)
        if end > first:
            response = response_between(plan, low - back * step, high)
            parts.append(_feet(plan, response, first, end, step, back))
    columns = [np.concatenate(c) for c in zip(*parts, strict=True)]
    return PathError(*columns)


def _feet(
    plan: Schedule, response: Response, first: int, end: int, step: float, back: int
) -> tuple[Floats, Floats, Ints, Floats, Floats, Floats]:
    """Columns of a `PathError` for the samples `first` to `end`."""
    n = end - first
    grid_times = np.arange(first - back, end, dtype=np.float64) * step
    t = grid_times[back:]
    command = response.commanded(grid_times)
    actual = response.actual(t)[0]
    best, ago = np.full(n, np.inf), np.zeros(n, np.int64)
    stride = max(1, back // _CANDIDATES)
    for k in range(0, back + 1, stride):
        distance = ((actual - command[back - k : back - k + n]) ** 2).sum(axis=1)
        nearer = distance < best
        best[nearer], ago[nearer] = distance[nearer], k
    coarse = ago.copy()
    for k in range(1 - stride, stride):
        near = np.clip(coarse + k, 0, back)
        distance = ((actual - command[np.arange(back, back + n) - near]) ** 2).sum(axis=1)
        nearer = distance < best
        best[nearer], ago[nearer] = distance[nearer], near[nearer]
    best, when = np.full(n, np.inf), np.zeros(n)
    for shift in (-1, 0, 1):
        guess = np.clip(t - (ago + shift) * step, 0.0, t)
        found, distance = _project(plan, response, actual, guess, t)
        nearer = distance < best
        best[nearer], when[nearer] = distance[nearer], found[nearer]
    at, s = plan.where(when)
    velocity = response.commanded_speed(_inside(plan, when, at))
    direction, speed = velocity[:, :2], np.hypot(*velocity[:, :2].T)
    move = plan.row[at]
    good = (speed > 1e-9 * np.abs(velocity[:, 2])) & (plan.moves.toolpath.kind[move] != Kind.RAPID)
    unit = direction[good] / speed[good, None]
    normal = np.column_stack([-unit[:, 1], unit[:, 0]])
    foot = response.commanded(when[good])[:, :2]
    value = ((actual[good, :2] - foot) * normal).sum(axis=1)
    return t[good], s[good], move[good], foot, normal, value


def _bounds(plan: Schedule, at: Ints) -> tuple[Floats, Floats]:
    """Times between which scheduled moves are interpolated."""
    return plan.begin[at], plan.begin[at] + plan.phase[at, :3].sum(axis=1)


def _inside(plan: Schedule, t: Floats, at: Ints) -> Floats:
    """Times a little inside their moves, where a direction is one move's own and not zero."""
    low, high = _bounds(plan, at)
    margin = 1e-6 * (high - low)
    out: Floats = np.clip(t, low + margin, high - margin)
    return out


def _project(plan: Schedule, response: Response, actual: Floats, guess: Floats, now: Floats) -> tuple[Floats, Floats]:
    """Times near a guess, within its move, at which the command is nearest, and the squared distance."""
    at, _ = plan.where(guess)
    low, high = _bounds(plan, at)
    high = np.minimum(high, now)
    t = np.clip(guess, low, high)
    moving = np.arange(len(t))
    for _ in range(_MATCHES):
        now_at = t[moving]
        speed = response.commanded_speed(_inside(plan, now_at, at[moving]))
        off = actual[moving] - response.commanded(now_at)
        step = (off * speed).sum(axis=1) / np.maximum((speed**2).sum(axis=1), 1e-12)
        t[moving] = np.clip(now_at + step, low[moving], high[moving])
        moving = moving[np.abs(t[moving] - now_at) > _STILL]
    distance = ((actual - response.commanded(t)) ** 2).sum(axis=1)
    return t, distance
