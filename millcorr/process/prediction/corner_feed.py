# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners that the machine rounds off too much, run slower in the program itself (dat-2025, fig. 5).

A corner A-C-E becomes A-B-C-D-E: B before and D behind the corner C, with a lower feed on BC and CD. The move B-C
lasts as long as the control needs to change the feed, so that at C only the low feed is left to mix, and the error
at a corner is proportional to the feed there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import LimitError, UsageError
from millcorr.messages import mm, phrase, um
from millcorr.nc import Program, parse, write
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.process.kinematics import Control, Halts, corner_errors, halts_of, schedule
from millcorr.process.kinematics.errors import LEAST_TURN
from millcorr.process.kinematics.moves import Moves

TRANSIENT = 0.05
"""Share of the bound that the change of feed at B may still add at C."""
_AIM = 0.98
"""Share of the bound that the first try aims at."""
_ROUNDS = 8
_FEED_STEP = {21: 1.0 / 60.0, 20: 0.1 * 25.4 / 60.0}
"""New feeds are whole mm/min, or tenths of an inch/min, here in mm/s, by the code of the unit."""


@dataclass(frozen=True, slots=True)
class Untreated:
    """A corner over the bound that stays as it is: line from 1, predicted error in mm, and why."""

    line: int
    error: float
    reason: str


@dataclass(frozen=True, eq=False, slots=True)
class CornerFeeds(ReadOnlyArrays):
    """A program whose corners run slower, and what it is predicted to do.

    Parameters
    ----------
    data : bytes
        The program; the bytes as read where no corner is over the bound.
    line : (k,) int64
        Line of the program as read that ends at each treated corner, from 1.
    vertex : (k, 3) float64
        Corner in mm.
    feed : (k,) float64
        Feed at the corner in mm/s.
    before, after : (k,) float64
        Closest approach to the corner in mm, predicted for the program as read and for the emitted one.
    duration : tuple of float
        Predicted time in s of the program as read and of the emitted one.
    untreated : tuple of Untreated
    """

    data: bytes
    line: Ints
    vertex: Floats
    feed: Floats
    before: Floats
    after: Floats
    duration: tuple[float, float]
    untreated: tuple[Untreated, ...]


def slow_corners(
    program: Program,
    control: Control,
    bound: float,
    *,
    dwell_unit: str | None = None,
    least_turn: float = LEAST_TURN,
    partial: bool = False,
    tolerance: float = 0.001,
    header: Sequence[str] = (),
) -> CornerFeeds:
    """Slow a program down at the corners whose predicted error exceeds a bound.

    Parameters
    ----------
    program : Program
    control : Control
    bound : float
        Largest distance in mm between a corner and the path of the tool.
    dwell_unit : {"s", "ms"}, optional
        As `halts_of`.
    least_turn : float
        Smallest change of direction that counts as a corner, in rad.
    partial : bool
        Leave corners that cannot be treated as they are, and name them, in place of refusing the program.
    tolerance : float
        Allowed path error of the emitted text in mm.
    header : sequence of str
        Comment lines for the top of a changed program.

    Returns
    -------
    CornerFeeds
        Verified: the emitted program has been read back and its motion predicted with the same model.

    Raises
    ------
    UsageError
        If the bound is no length.
    LimitError
        If a corner cannot be brought within the bound: blocks too short, a spline beside it, or a feed below the
        smallest; names the line. Also if the emitted program does not read back to what was wanted.
    FormatError, InputError
        As `schedule` and `write`.
    """
    if not bound > 0:
        raise UsageError(phrase("corner bound {}: state a length above 0", mm(bound, "g")))
    halts = halts_of(program, dwell_unit)
    path = program.toolpath
    found = corner_errors(path, control, halts=halts, least_turn=least_turn, name=program.name)
    duration = schedule(path, control, halts, program.name).duration
    wrong = np.flatnonzero(found.error > bound)
    plan = _Plan(program, control, bound, halts, found.move[wrong], found.error[wrong], found.feed[wrong])
    while True:
        progress.step()
        expanded, own_halts, corner = plan.expanded()
        after = plan.errors(expanded, own_halts, corner, least_turn)
        if not plan.slower(after):
            break
    if plan.untreated and not partial:
        first = plan.untreated[0]
        raise LimitError(
            phrase(
                "{}:{}: the corner is off by {} and cannot be slowed: {}; lower the feed there, raise the "
                "bound, or accept it as it is",
                program.name,
                first.line,
                um(first.error, ".1f"),
                first.reason,
            )
        )
    kept = plan.active
    if not kept.any():
        none = np.zeros(0)
        return CornerFeeds(
            program.data, np.zeros(0, np.int64), np.zeros((0, 3)), none, none, none, (duration,) * 2,
            tuple(plan.untreated),
        )  # fmt: skip
    data = write(program, expanded, tolerance=tolerance, header=header)
    back = parse(data, program.name)
    _same_moves(back, expanded, tolerance)
    back_halts = halts_of(back, dwell_unit)
    after = plan.errors(back.toolpath, back_halts, corner, least_turn)
    if (after > bound).any():
        worst = int(np.argmax(after))
        raise LimitError(
            phrase(
                "{}:{}: the slowed corner is still off by {}, more than {}",
                program.name,
                path.line(plan.move[kept][worst]),
                um(after[worst], ".2f"),
                um(bound, "g"),
            )
        )
    move = plan.move[kept]
    return CornerFeeds(
        data,
        path.line(move),
        path.end[move].copy(),
        plan.feed[kept],
        plan.before[kept],
        after,
        (duration, schedule(back.toolpath, control, back_halts, program.name).duration),
        tuple(plan.untreated),
    )


class _Plan:
    """Feeds at the corners that are too far off, lowered until all are within the bound."""

    def __init__(
        self, program: Program, control: Control, bound: float, halts: Halts, move: Ints, error: Floats, feed: Floats
    ) -> None:
        self.program, self.control, self.bound, self.halts = program, control, bound, halts
        self.path = program.toolpath
        self.moves = Moves.of(self.path)
        self.first, self.last = self.moves.directions()
        self.move, self.before = move, error
        self.behind = self._following(move)
        self.active = np.ones(len(move), np.bool_)
        self.untreated: list[Untreated] = []
        self.rounds = 0
        units = program.modal.unit[self.path.source[move]]
        self.step = np.where(units == 20, _FEED_STEP[20], _FEED_STEP[21])
        # A corner between unequal feeds is off by less than one between two of the higher: the first try is high.
        self.feed = self._rounded(feed.max(axis=1) * np.minimum(_AIM * bound / error, 1.0))
        spline = (self.path.kind[self.move] == Kind.CUBIC) | (self.path.kind[self.behind] == Kind.CUBIC)
        self._drop(spline, phrase("one of its blocks is a spline"))
        self._drop(self.feed <= 0, phrase("the feed would be below the smallest step of a feed"))
        self._check_room()

    def _following(self, move: Ints) -> Ints:
        """Moves behind the corners, those without length left aside."""
        long = np.flatnonzero(self.moves.length > 1e-9)
        out: Ints = long[np.searchsorted(long, move, side="right")]
        return out

    def _rounded(self, feed: Floats) -> Floats:
        out: Floats = np.floor(feed / self.step + 1e-9) * self.step
        return out

    def _drop(self, wrong: Bools, reason: str) -> None:
        for k in np.flatnonzero(wrong & self.active).tolist():
            line = int(self.path.line(self.move[k]))
            self.untreated.append(Untreated(line, float(self.before[k]), reason))
        self.active &= ~wrong
        self.untreated.sort(key=lambda u: u.line)

    def _lengths(self) -> tuple[Floats, Floats]:
        """Lengths of BC and CD in mm; 0 where a block is slow enough already."""
        out = []
        for row, direction in ((self.move, self.last[self.move]), (self.behind, self.first[self.behind])):
            change = np.maximum(self.path.feed[row] - self.feed, 0.0)
            # As after a long move at the speed that changes.
            long = np.tile([self.control.memory, 0.0], (len(row), 1))
            steady = np.repeat((change[:, None] * direction)[:, None], 2, axis=1)
            window = np.full(len(row), TRANSIENT * self.bound)
            time = self.control.settling(np.arange(len(row)), steady, long, window)
            time = np.maximum(time, max(axis.box for axis in self.control.axes))
            out.append(np.where((change > 1e-9) & self.active, self.feed * time, 0.0))
        return out[0], out[1]

    def _check_room(self) -> None:
        """Drop corners whose blocks have no room for B and D, until the rest has."""
        while True:
            bc, cd = self._lengths()
            need = np.zeros(len(self.path))
            np.add.at(need, self.move, bc)
            np.add.at(need, self.behind, cd)
            short = need > self.moves.length * (1 - 1e-9)
            wrong = self.active & (short[self.move] & (bc > 0) | short[self.behind] & (cd > 0))
            if not wrong.any():
                return
            self._drop(wrong, phrase("its blocks are too short for the control to change the feed in them"))

    def slower(self, after: Floats) -> bool:
        """Lower the feeds of corners that are still too far off; whether there were any."""
        active = np.flatnonzero(self.active)
        still = after > self.bound
        self.rounds += 1
        if not still.any():
            return False
        these = active[still]
        if self.rounds > _ROUNDS:
            wrong = np.zeros(len(self.move), np.bool_)
            wrong[these] = True
            self._drop(wrong, phrase("its error does not fall with the feed"))
            return True
        wanted = self.feed.copy()
        wanted[these] *= _AIM * self.bound / after[still]
        self.feed[these] = np.minimum(self._rounded(wanted)[these], self.feed[these] - self.step[these])
        self._drop(self.feed <= self.step * 0.5, phrase("the feed would be below the smallest step of a feed"))
        self._check_room()
        return True

    def expanded(self) -> tuple[Toolpath, Halts, Ints]:
        """Toolpath with B and D, its halts, and the moves of it that end at the treated corners."""
        bc, cd = self._lengths()
        path, n = self.path, len(self.path)
        cut_d, cut_b = np.zeros(n), np.zeros(n)
        feed_d, feed_b = np.full(n, np.nan), np.full(n, np.nan)
        with_cd, with_bc = cd > 0, bc > 0
        cut_d[self.behind[with_cd]], feed_d[self.behind[with_cd]] = cd[with_cd], self.feed[with_cd]
        cut_b[self.move[with_bc]], feed_b[self.move[with_bc]] = bc[with_bc], self.feed[with_bc]
        length = np.maximum(self.moves.length, 1e-12)
        bounds = np.column_stack([np.zeros(n), cut_d / length, 1 - cut_b / length, np.ones(n)])
        feeds = np.column_stack([feed_d, path.feed, feed_b])
        there = np.column_stack([cut_d > 0, np.ones(n, np.bool_), cut_b > 0])
        row, part = np.nonzero(there)
        low, high = bounds[row, part], bounds[row, part + 1]
        out = path.take(row)
        start, end, centre = out.start.copy(), out.end.copy(), out.centre.copy()
        inner_low, inner_high = np.flatnonzero(low > 0), np.flatnonzero(high < 1)
        places_low = self.moves.at(row[inner_low], low[inner_low])
        places_high = self.moves.at(row[inner_high], high[inner_high])
        unknown = self.moves.unknown
        start[inner_low] = np.where(unknown[row[inner_low]], np.nan, places_low)
        end[inner_high] = np.where(unknown[row[inner_high]], np.nan, places_high)
        arcs = np.flatnonzero(out.kind == Kind.ARC)
        normal = np.array([2, 1, 0])[out.plane[arcs] - 17]
        centre[arcs, normal] = start[arcs, normal]
        toolpath = out.with_moves(
            start=start, end=end, centre=centre, sweep=out.sweep * (high - low), feed=feeds[row, part]
        )
        final = np.append(row[1:] != row[:-1], True)
        halts = Halts(self.halts.stop[row] & final, np.where(final, self.halts.dwell[row], 0.0), self.halts.opaque[row])
        last_of = np.flatnonzero(final)
        return toolpath, halts, last_of[self.move[self.active]]

    def errors(self, toolpath: Toolpath, halts: Halts, corner: Ints, least_turn: float) -> Floats:
        """Predicted errors at the treated corners."""
        if not len(corner):
            return np.zeros(0)
        found = corner_errors(toolpath, self.control, halts=halts, least_turn=least_turn / 2, name=self.program.name)
        place = np.searchsorted(found.move, corner)
        if (place >= len(found)).any() or (found.move[np.minimum(place, len(found) - 1)] != corner).any():
            raise LimitError(phrase("{}: a corner is lost in the slowed program; raise the bound", self.program.name))
        out: Floats = found.error[place]
        return out


def _same_moves(back: Program, wanted: Toolpath, tolerance: float) -> None:
    """Refuse an emitted program that does not read back to the wanted moves and feeds."""
    got = back.toolpath
    same = len(got) == len(wanted) and bool((got.kind == wanted.kind).all())
    if same:
        t = np.linspace(0.0, 1.0, 9)
        off = np.abs(got.position(t) - wanted.position(t))
        feed = np.abs(got.feed - wanted.feed) > 1e-6 * np.abs(wanted.feed)
        same = not ((off > tolerance).any() or feed.any())
    if not same:
        raise LimitError(
            phrase("{}: the slowed program does not read back as it was meant; raise the bound", back.name)
        )
