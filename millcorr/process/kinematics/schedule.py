# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commanded motion: when the interpolator runs each move, and how fast."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Compensation, Kind, Toolpath

from .control import Control
from .moves import Moves, refuse, unknown_moves

_SAME = 1e-9
"""Two places in mm nearer than this are one."""
_AT_REST = 1e-6
"""Where moves between cannot be followed, the machine counts as standing when it is within this, in mm."""


@dataclass(frozen=True, eq=False, slots=True)
class Halts(ReadOnlyArrays):
    """Where a program stops between its moves, and which moves its text does not show.

    Parameters
    ----------
    stop : (n,) bool
        The move ends in an exact stop.
    dwell : (n,) float64
        Time in s waited behind the move.
    opaque : (n,) bool
        The move is not what the toolpath says (canned cycles and the like).

    Raises
    ------
    InputError
        If the arrays disagree in length.
    """

    stop: Bools
    dwell: Floats
    opaque: Bools

    def __post_init__(self) -> None:
        if not len(self.stop) == len(self.dwell) == len(self.opaque):
            raise InputError("halts: the arrays disagree in length")
        ReadOnlyArrays.__post_init__(self)


@dataclass(frozen=True, eq=False, slots=True)
class Schedule(ReadOnlyArrays):
    """Moves in the order and at the times at which the interpolator runs them.

    Parameters
    ----------
    moves : Moves
    control : Control
    row : (m,) int64
        Move of the toolpath; moves without length do not appear.
    begin : (m,) float64
        Time in s at which the move begins.
    phase : (m, 4) float64
        Durations in s of speeding up, constant speed, slowing down, and waiting behind the move.
    speed : (m, 3) float64
        Speed along the path in mm/s at the start, in the middle, at the end.
    jump : (m, 3) float64
        From the end of the move before to the start of this one, in mm: 0 but where moves between are left out.
    stop : (m,) bool
        The machine stands still behind the move.
    omitted : (k,) int64
        Moves of the toolpath that cannot be followed: from or to an unknown place, opaque, or rapids of unknown
        speed. The machine stands before and behind them, and their time does not count.
    """

    moves: Moves
    control: Control
    row: Ints
    begin: Floats
    phase: Floats
    speed: Floats
    jump: Floats
    stop: Bools
    omitted: Ints

    def __len__(self) -> int:
        return len(self.row)

    @property
    def duration(self) -> float:
        """Time of the program in s, up to standstill behind its last move, without the omitted moves."""
        return float(self.begin[-1] + self.phase[-1].sum())

    @property
    def path(self) -> Floats:
        """Commanded path length in mm at the start of every move, and at the end of the last, (m + 1,)."""
        return np.concatenate([[0.0], np.cumsum(self.moves.length[self.row])])

    def where(self, t: Floats) -> tuple[Ints, Floats]:
        """Which move is interpolated at times in s, as an index into `row`, and the commanded path length in mm."""
        at = np.clip(np.searchsorted(self.begin, t, side="right") - 1, 0, len(self) - 1)
        rest = np.maximum(t - self.begin[at], 0.0)
        travelled = np.zeros(len(t))
        for k, (low, high) in enumerate(((0, 1), (1, 1), (1, 2))):
            h = self.phase[at, k]
            inside = np.minimum(rest, h)
            first, last = self.speed[at, low], self.speed[at, high]
            slope = np.divide(last - first, h, out=np.zeros(len(t)), where=h > 0)
            travelled += inside * (first + slope * inside / 2)
            rest = rest - inside
        length = self.moves.length[self.row[at]]
        return at, self.path[at] + np.minimum(travelled, length)


def schedule(toolpath: Toolpath, control: Control, halts: Halts | None = None, name: str = "program") -> Schedule:
    """When the interpolator runs each move.

    Without contour control every move runs at its feed and the next one follows without a gap (cutting mode, G64);
    with it the feed falls and rises along the path (see `ContourControl`). The machine stops at `halts`, and
    before and behind rapids.

    Parameters
    ----------
    toolpath : Toolpath
        Path of the cutter's centre.
    control : Control
    halts : Halts, optional
        From `halts_of`; without it there are no exact stops and dwells, and every move is taken as it is.
    name : str
        Name of the program for messages.

    Returns
    -------
    Schedule

    Raises
    ------
    FormatError
        If cutter compensation is on, or a feed is not known; names the line.
    InputError
        If no move is left to follow, or the halts are not those of this toolpath.
    """
    if halts is not None and len(halts.stop) != len(toolpath):
        raise InputError(f"halts: {len(halts.stop)} moves, but the toolpath has {len(toolpath)}")
    rapid = toolpath.kind == Kind.RAPID
    omitted = unknown_moves(toolpath)
    if halts is not None:
        omitted |= halts.opaque
    rates = [axis.rapid for axis in control.axes]
    if any(rate is None for rate in rates):
        omitted |= rapid
    cutting = ~omitted & ~rapid
    refuse(
        toolpath,
        cutting & (toolpath.compensation != Compensation.OFF),
        "with G41 or G42 the program does not state where the cutter's centre goes: state the centre path with G40",
        name,
    )
    moves = Moves.of(toolpath.with_moves(kind=np.where(omitted, Kind.RAPID, toolpath.kind)))
    kept = ~omitted & (moves.length > _SAME)
    refuse(toolpath, cutting & kept & ~(toolpath.feed > 0), "the feed is not known in mm/min: state F with G94", name)
    row = np.flatnonzero(kept)
    if not len(row):
        raise InputError(phrase("{}: no move can be followed", name))
    first, last = (d[row] for d in moves.directions())
    start, end = moves.toolpath.start[row], moves.toolpath.end[row]
    jump = np.zeros((len(row), 3))
    jump[1:] = start[1:] - end[:-1]
    broken: Bools = np.logical_or.reduce(np.abs(jump) > _SAME, axis=1)
    jump[~broken] = 0.0
    feed = toolpath.feed[row].copy()
    fast: Bools = rapid[row]
    if fast.any():
        limit = np.array(rates, dtype=float)
        with np.errstate(divide="ignore"):
            feed[fast] = (limit / np.abs(first[fast])).min(axis=1)
    apart = _passed(omitted, row)
    stop, dwell = _stops(toolpath, row, halts)
    stop[:-1] |= fast[:-1] | fast[1:] | broken[1:] | apart[:-1]
    stop[-1] = True
    length = moves.length[row]
    phase = np.zeros((len(row), 4))
    speed, rate = _speeds(control, length, feed, fast, stop, first, last)
    phase[:, :3] = _durations(length, speed, rate)
    at_rest = np.flatnonzero(stop)
    window = np.where(np.append(broken[1:] | apart[:-1], False)[at_rest], _AT_REST, control.in_position)
    phase[at_rest, 3] = _settling(control, phase[:, :3], speed, last, at_rest, window)
    phase[:, 3] += dwell
    total = phase.sum(axis=1)
    begin = np.concatenate([[0.0], np.cumsum(total)[:-1]])
    return Schedule(moves, control, row, begin, phase, speed, jump, stop, np.flatnonzero(omitted))


def _passed(omitted: Bools, row: Ints) -> Bools:
    """Whether omitted moves stand behind each kept one."""
    count = np.cumsum(omitted)
    following = np.append(row[1:], len(omitted) - 1)
    out: Bools = count[following] > count[row]
    return out


def _stops(toolpath: Toolpath, row: Ints, halts: Halts | None) -> tuple[Bools, Floats]:
    """Exact stops and dwells behind the kept moves, those of moves without length included."""
    stop, dwell = np.zeros(len(row), np.bool_), np.zeros(len(row))
    if halts is not None:
        owner = np.searchsorted(row, np.arange(len(toolpath)), side="right") - 1
        behind = owner >= 0
        np.logical_or.at(stop, owner[behind], (halts.stop | (halts.dwell > 0))[behind])
        np.add.at(dwell, owner[behind], halts.dwell[behind])
    return stop, dwell


def _speeds(
    control: Control, length: Floats, feed: Floats, fast: Bools, stop: Bools, first: Floats, last: Floats
) -> tuple[Floats, Floats]:
    """Speeds at start, middle and end of moves (m, 3), and rates of speeding up and slowing down (m, 2)."""
    speed = np.repeat(feed[:, None], 3, axis=1)
    rate = np.zeros((len(feed), 2))
    if control.contour is None:
        return speed, rate
    turn = np.abs(first[1:] - last[:-1]).max(axis=1)
    cap = np.zeros(len(feed) + 1)
    with np.errstate(divide="ignore"):
        cap[1:-1] = np.minimum(np.minimum(feed[:-1], feed[1:]), control.contour.speed_change / turn)
    cap[1:][stop] = 0.0
    time = control.contour.time(feed)
    ahead, low_ahead = _ramps(length, feed, time, cap)
    back, low_back = _ramps(length[::-1], feed[::-1], time[::-1], cap[::-1])
    back, low_back = back[::-1], low_back[::-1]
    join = np.minimum(ahead, back)
    rate[:, 0] = np.maximum(feed - low_ahead[:-1], 0.0) / time
    rate[:, 1] = np.maximum(feed - low_back[1:], 0.0) / time
    speed[:, 0], speed[:, 2] = join[:-1], join[1:]
    rate[speed[:, 0] >= feed, 0] = 0.0
    rate[speed[:, 2] >= feed, 1] = 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        up, down = 0.5 / rate[:, 0], 0.5 / rate[:, 1]
        both = (length + speed[:, 0] ** 2 * up + speed[:, 2] ** 2 * down) / (up + down)
        only_up = speed[:, 0] ** 2 + 2 * rate[:, 0] * length
        only_down = speed[:, 2] ** 2 + 2 * rate[:, 1] * length
    peak = np.select([(rate > 0).all(axis=1), rate[:, 0] > 0, rate[:, 1] > 0], [both, only_up, only_down], np.inf)
    speed[:, 1] = np.maximum(np.minimum(np.sqrt(peak), feed), speed[:, [0, 2]].max(axis=1))
    speed[fast] = feed[fast, None]
    rate[fast] = 0.0
    return speed, rate


def _ramps(length: Floats, feed: Floats, time: Floats, cap: Floats) -> tuple[Floats, Floats]:
    """Speeds that can be reached at the joints coming from one side, and the speed that each ramp began at.

    A ramp from `low` to a move's feed takes that move's accuracy-maintenance time, whatever the moves are long.
    """
    speed, low = cap.tolist(), cap.tolist()
    now, base = speed[0], low[0]
    for i, (way, top, duration) in enumerate(zip(length.tolist(), feed.tolist(), time.tolist(), strict=True), 1):
        reach = (now * now + 2.0 * max(top - base, 0.0) / duration * way) ** 0.5
        if reach < speed[i]:
            speed[i] = now = reach
            low[i] = base
        else:
            now = base = speed[i]
    return np.array(speed), np.array(low)


def _settling(control: Control, phase: Floats, speed: Floats, last: Floats, at_rest: Ints, window: Floats) -> Floats:
    """Times (k,) in s that the moves `at_rest` wait; every move counts in the direction in which it ends.

    What the stop before has left, less than its own window, does not count.
    """
    stop = np.searchsorted(at_rest, np.arange(len(phase)))
    end = np.cumsum(phase.sum(axis=1))
    behind = end[at_rest][stop] - end
    felt = np.flatnonzero(behind < control.memory)
    # From the beginnings of the phases, and from the end of the last one, to the end of the run.
    ahead = behind[felt, None] + np.cumsum(np.insert(phase[felt, ::-1], 0, 0.0, axis=1), axis=1)[:, ::-1]
    ahead = np.stack([ahead[:, :-1], ahead[:, 1:]], axis=2)
    speeds = speed[felt][:, [[0, 1], [1, 1], [1, 2]], None] * last[felt, None, None, :]
    return control.settling(np.repeat(stop[felt], 3), speeds.reshape(-1, 2, 3), ahead.reshape(-1, 2), window)


def _durations(length: Floats, speed: Floats, rate: Floats) -> Floats:
    """Durations (m, 3) of speeding up, constant speed, slowing down."""
    out = np.zeros((len(length), 3))
    for k, (end, which) in enumerate(((0, 0), (2, 1))):
        change = speed[:, 1] - speed[:, end]
        out[:, 2 * k] = np.divide(change, rate[:, which], out=np.zeros(len(length)), where=rate[:, which] > 0)
    ramps = out[:, 0] * (speed[:, 0] + speed[:, 1]) / 2 + out[:, 2] * (speed[:, 1] + speed[:, 2]) / 2
    out[:, 1] = np.maximum(length - ramps, 0.0) / speed[:, 1]
    return out
