# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path that the cutter's centre really runs, as short lines, each with its real feed.

With the constants of a control it is the actual motion (`process.kinematics`); without them it is the program's
own path at its own feeds. Forces, chips and maps that go by time or by feed read it, not the program.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError, UsageError
from millcorr.geometry.profile import CORNER_ANGLE
from millcorr.messages import phrase
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath
from millcorr.process.engagement.path_pieces import pieces_of_toolpath
from millcorr.process.kinematics import Control, Halts, motions, schedule

SPACING = 0.02
"""Longest line in mm: the corner of 300 mm/min and 50 ms of acc/dec, 0.25 mm, gets a dozen of them."""

_JOINED = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class RealPath(ReadOnlyArrays):
    """Short lines in order, and between them the moves that do not cut in the plane, as they were programmed.

    Parameters
    ----------
    toolpath : Toolpath
        Feeds are the real ones, mm/s; rapids are left out.
    move : (n,) int64
        Move of the program of each row.
    short : (n,) bool
        True for the short lines.
    begin, end : (n,) float64
        Times in s of each short line from the start of the program; NaN for other moves. Without a control the times
        between cutting moves are not known: they count from the start of each move's run, one run after the other.
    """

    toolpath: Toolpath
    move: Ints
    short: Bools
    begin: Floats
    end: Floats

    def __len__(self) -> int:
        return len(self.move)

    def shifted(self, value: Floats) -> Toolpath:
        """The path with its short lines moved to their left.

        Parameters
        ----------
        value : (n,) float64
            mm. Where lines follow one another without a corner their common end is moved by the mean of both, so that
            they keep together; at a corner each line is moved along its own normal.

        Returns
        -------
        Toolpath
        """
        t = self.toolpath
        start, end = t.start[:, :2], t.end[:, :2]
        along = end - start
        along = along / np.maximum(np.hypot(*along.T), 1e-300)[:, None]
        left = np.stack([-along[:, 1], along[:, 0]], axis=1) * value[:, None]
        left[~self.short] = 0.0
        straight = (along[1:] * along[:-1]).sum(axis=1) > np.cos(CORNER_ANGLE)
        joined = self.short[1:] & self.short[:-1] & straight & (np.hypot(*(start[1:] - end[:-1]).T) <= _JOINED)
        middle = (left[1:] + left[:-1]) / 2
        new_start, new_end = t.start.copy(), t.end.copy()
        new_start[:, :2] += left
        new_end[:, :2] += left
        new_end[:-1, :2][joined] = end[:-1][joined] + middle[joined]
        new_start[1:, :2][joined] = start[1:][joined] + middle[joined]
        return t.with_moves(start=new_start, end=new_end)


def real_path(
    toolpath: Toolpath,
    control: Control | None = None,
    *,
    halts: Halts | None = None,
    spacing: float = SPACING,
    name: str = "program",
) -> RealPath:
    """Path of the cutter's centre with its real feed.

    Parameters
    ----------
    toolpath : Toolpath
        Path of the cutter's centre.
    control : Control, optional
        Acc/dec, contour control and servos; without it the path and the feeds are those of the program.
    halts : Halts, optional
        Exact stops and dwells, with a control.
    spacing : float
        Longest line in mm.
    name : str
        Name of the program for messages.

    Returns
    -------
    RealPath

    Raises
    ------
    UsageError
        If the spacing is not positive.
    InputError
        If no move cuts in the XY plane at constant height; else as `millcorr.process.kinematics.schedule`.
    """
    if not (np.isfinite(spacing) and spacing > 0):
        raise UsageError(f"real path: a spacing of {spacing!r} mm is not positive")
    flat = flat_cuts(toolpath)
    if not flat.any():
        raise InputError(phrase("{}: no move cuts in the XY plane at constant height", name))
    start, end, move, begin, finish = (
        _as_programmed(toolpath, flat, spacing, name)
        if control is None
        else _as_run(toolpath, flat, control, halts, spacing, name)
    )
    feed = np.hypot(*(end - start).T) / (finish - begin) if control is not None else toolpath.feed[move]
    other = np.flatnonzero(~flat & (toolpath.kind != Kind.RAPID))
    height = toolpath.end[move, 2]
    n = len(move)
    lines = toolpath.take(move).with_moves(
        kind=np.full(n, int(Kind.LINE)),
        start=np.column_stack([start, height]),
        end=np.column_stack([end, height]),
        centre=np.full((n, 3), np.nan),
        sweep=np.zeros(n),
        control=np.full((n, 4), np.nan),
        plane=np.full(n, int(Plane.XY)),
        feed=feed,
    )
    key = np.concatenate([move, other])
    order = np.argsort(key, kind="stable")
    nothing = np.full(len(other), np.nan)
    return RealPath(
        Toolpath.concatenate([lines, toolpath.take(other)]).take(order),
        key[order],
        np.concatenate([np.ones(n, dtype=bool), np.zeros(len(other), dtype=bool)])[order],
        np.concatenate([begin, nothing])[order],
        np.concatenate([finish, nothing])[order],
    )


def flat_cuts(toolpath: Toolpath) -> Bools:
    """Feed moves in the XY plane at constant height, or at a height never stated."""
    z0, z1 = toolpath.start[:, 2], toolpath.end[:, 2]
    level = (z0 == z1) | (np.isnan(z0) & np.isnan(z1))
    known = np.isfinite(toolpath.start[:, :2]).all(axis=1) & np.isfinite(toolpath.end[:, :2]).all(axis=1)
    moving = (toolpath.start[:, :2] != toolpath.end[:, :2]).any(axis=1) | (toolpath.sweep != 0)
    in_plane = (toolpath.kind != Kind.ARC) | (toolpath.plane == Plane.XY)
    plain = toolpath.compensation == Compensation.OFF
    out: Bools = (toolpath.kind != Kind.RAPID) & level & known & moving & in_plane & plain
    return out


def _as_programmed(
    toolpath: Toolpath, flat: Bools, spacing: float, name: str
) -> tuple[Floats, Floats, Ints, Floats, Floats]:
    pieces = pieces_of_toolpath(toolpath, np.flatnonzero(flat), where=name)
    count = np.maximum(np.ceil(pieces.length / spacing - 1e-9), 1).astype(np.int64)
    row = np.repeat(np.arange(len(pieces)), count)
    k = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    start, end = (pieces.point(row, (k + i) / count[row]) for i in (0, 1))
    move = pieces.owner[row]
    length = np.hypot(*(end - start).T)
    finish = np.cumsum(length / toolpath.feed[move])
    begin = np.concatenate([[0.0], finish[:-1]])
    return start, end, move, begin, finish


def _as_run(
    toolpath: Toolpath, flat: Bools, control: Control, halts: Halts | None, spacing: float, name: str
) -> tuple[Floats, Floats, Ints, Floats, Floats]:
    plan = schedule(toolpath, control, halts, name)
    fastest = float(plan.speed[flat[plan.row]].max(initial=0.0))
    if not fastest > 0:
        raise InputError(phrase("{}: no move that cuts in the XY plane can be followed", name))
    # Twice as dense as asked for, then thinned to one in half a spacing: no line is longer than the spacing.
    kept: list[tuple[Floats, Floats, Ints, Ints]] = []
    total, run, last = 0.0, 0, None
    for part in motions(plan, step=spacing / (2 * fastest)):
        cuts = flat[part.move]
        point = np.column_stack([part.x, part.y])
        before = np.vstack([point[:1] if last is None else last[0], point[:-1]])
        was = np.concatenate([[cuts[0] if last is None else last[1]], cuts[:-1]])
        way = total + np.cumsum(np.where(cuts & was, np.hypot(*(point - before).T), 0.0))
        number = run + np.cumsum(cuts != was)
        cell = np.floor(2.0 * way / spacing)
        edge = np.ones(len(cell), dtype=bool)
        edge[1:-1] = (cell[1:-1] != cell[:-2]) | (number[1:-1] != number[:-2]) | (number[1:-1] != number[2:])
        keep = np.flatnonzero(edge & cuts)
        kept.append((part.t[keep], point[keep], part.move[keep], number[keep]))
        total, run, last = float(way[-1]), int(number[-1]), (point[-1], cuts[-1])
    t, point, move, number = (np.concatenate([k[i] for k in kept]) for i in range(4))
    same = (number[1:] == number[:-1]) & (np.hypot(*(point[1:] - point[:-1]).T) > _JOINED)
    k = np.flatnonzero(same)
    return point[k], point[k + 1], move[k + 1], t[k], t[k + 1]
