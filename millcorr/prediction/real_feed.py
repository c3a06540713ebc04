# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program at the feeds that the machine really runs: the same path, cut where the feed changes.

The path stays the commanded one, arcs stay arcs; only the feed of each part is that of the actual motion
(`millcorr.kinematics`). Chip and force follow the real feed (dat-2025), not the one in the program.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.errors import FormatError
from millcorr.kinematics import AxisDynamics, ContourControl, Control, Motion
from millcorr.read_only import ReadOnlyArrays
from millcorr.setup_file import Setup
from millcorr.toolpath import Kind, Plane, Toolpath

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

SPACING = 0.25
"""The feed is looked at in steps of about this length along a move, in mm."""

EVEN = 0.005
"""Parts of a move whose feeds differ by less than this share of the programmed feed stay together."""

SHORTEST_TIME = 1.0
"""Acceleration and deceleration of an axis take 0 or at least this time, in ms."""


@dataclass(frozen=True, eq=False, slots=True)
class RealFeed(ReadOnlyArrays):
    """A toolpath at real feeds.

    Parameters
    ----------
    toolpath : Toolpath
        Parts of the program's moves in order, each at its real feed in mm/s.
    move : (n,) int64
        Move of the program that each part belongs to.
    begin, end : (n,) float64
        Shares of that move's length between which the part lies.
    """

    toolpath: Toolpath
    move: Ints
    begin: Floats
    end: Floats

    def place(self, part: Ints, share: Floats) -> Floats:
        """Places at shares of the length of parts, counted in moves as `course` counts them; (k,)."""
        out: Floats = self.move[part] + self.begin[part] + share * (self.end - self.begin)[part]
        return out

    @staticmethod
    def programmed(toolpath: Toolpath) -> RealFeed:
        """The program as it stands, for a machine without inertia."""
        n = len(toolpath)
        return RealFeed(toolpath, np.arange(n), np.zeros(n), np.ones(n))

    @staticmethod
    def of(toolpath: Toolpath, motion: Motion) -> RealFeed:
        """The program at the feeds of its actual motion.

        Parameters
        ----------
        toolpath : Toolpath
        motion : Motion
            Of this toolpath.
        """
        n = len(toolpath)
        length = _lengths(toolpath)
        split = (
            (np.isin(toolpath.kind, (Kind.LINE, Kind.ARC)))
            & (toolpath.plane == Plane.XY)
            & np.isfinite(toolpath.feed)
            & np.isfinite(length)
            & (length > SPACING)
        )
        count = np.ones(n, dtype=np.int64)
        count[split] = np.ceil(length[split] / SPACING).astype(np.int64)
        row = np.repeat(np.arange(n), count)
        k = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
        begin, end = k / count[row], (k + 1) / count[row]
        feed = toolpath.feed[row].copy()
        place, speed = course(toolpath, motion)
        rows = np.flatnonzero(np.isfinite(feed) & np.isin(row, motion.move))
        feed[rows] = np.interp(row[rows] + (begin + end)[rows] / 2, place, speed)
        # A feed of exactly 0 would take no chip and no time.
        feed = np.maximum(feed, 1e-3 * toolpath.feed[row])
        first = np.ones(len(row), dtype=bool)
        first[1:] = (row[1:] != row[:-1]) | (np.abs(np.diff(feed)) > EVEN * toolpath.feed[row[1:]])
        start = np.flatnonzero(first)
        parts = np.diff(np.append(start, len(row)))
        mean = np.add.reduceat(feed, start) / parts
        kept, low, high = row[start], begin[start], end[start + parts - 1]
        return RealFeed(_cut(toolpath, kept, low, high, mean), kept, low, high)


def course(toolpath: Toolpath, motion: Motion) -> tuple[Floats, Floats]:
    """Actual feed over the place along the program, counted in moves.

    Parameters
    ----------
    toolpath : Toolpath
    motion : Motion
        Of this toolpath.

    Returns
    -------
    place : (n,) float64
        Number of the move and share of its length, increasing.
    feed : (n,) float64
        mm/s.
    """
    return _place(toolpath, motion), np.asarray(motion.feed)


def times(toolpath: Toolpath, motion: Motion, place: Floats) -> Floats:
    """Times in s at which the tool is at places counted in moves, as `course` counts them; (k,)."""
    along = _place(toolpath, motion)
    keep = np.concatenate([[True], np.diff(along) > 1e-12])
    out: Floats = np.interp(place, along[keep], motion.t[keep])
    return out


def _lengths(toolpath: Toolpath) -> Floats:
    """Lengths of the moves in mm, where the height was never stated those in the plane; NaN from unknown places."""
    start, end = toolpath.start.copy(), toolpath.end.copy()
    never = np.isnan(start[:, 2]) & np.isnan(end[:, 2])
    start[never, 2] = end[never, 2] = 0.0
    return toolpath.with_moves(start=start, end=end).length()


def _place(toolpath: Toolpath, motion: Motion) -> Floats:
    length = np.nan_to_num(_lengths(toolpath))
    length[motion.omitted] = 0.0
    before = np.cumsum(length) - length
    share = (motion.s - before[motion.move]) / np.maximum(length[motion.move], 1e-12)
    return np.maximum.accumulate(motion.move + np.clip(share, 0.0, 1.0))


def _cut(toolpath: Toolpath, row: Ints, begin: Floats, end: Floats, feed: Floats) -> Toolpath:
    """Parts of moves, by shares of their length."""
    out = toolpath.take(row)
    whole = (begin == 0) & (end == 1)
    start_at, end_at = out.start.copy(), out.end.copy()
    sweep = np.where(whole, out.sweep, out.sweep * (end - begin))
    for share, ends, keep in ((begin, start_at, begin == 0), (end, end_at, end == 1)):
        rows = np.flatnonzero(~keep)
        ends[rows] = _at(out, rows, share[rows])
    return out.with_moves(start=start_at, end=end_at, sweep=sweep, feed=feed)


def _at(moves: Toolpath, rows: Ints, share: Floats) -> Floats:
    """Places at shares of the length of lines and of arcs in the XY plane; (k, 3)."""
    a, b = moves.start[rows], moves.end[rows]
    out = a + (b - a) * share[:, None]
    arc = np.flatnonzero(moves.kind[rows] == Kind.ARC)
    if len(arc):
        i = rows[arc]
        radial, last = moves.start[i, :2] - moves.centre[i, :2], moves.end[i, :2] - moves.centre[i, :2]
        f = share[arc]
        radius = np.hypot(*radial.T) * (1 - f) + np.hypot(*last.T) * f
        angle = np.arctan2(radial[:, 1], radial[:, 0]) + moves.sweep[i] * f
        out[arc, :2] = moves.centre[i, :2] + radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return out


def control_of(setup: Setup) -> Control | None:
    """Control and drives of a setup's machine; None where it names neither inertia nor contour control.

    Raises
    ------
    FormatError
        If a time is too short for an axis; names the key.
    """
    machine = setup.machine
    for name in ("acceleration_time_x_ms", "acceleration_time_y_ms"):
        value = getattr(machine, name)
        if 0 < value < SHORTEST_TIME:
            raise FormatError(f"[machine] {name} {value:g} is neither 0 nor at least 1 (ms)", setup.source or None)
    kv = machine.position_gain_per_s
    if kv is not None and kv > 1000.0:
        raise FormatError(f"[machine] position_gain_per_s {kv:g} is above 1000 (1/s)", setup.source or None)
    tx, ty = machine.acceleration_time_x_ms / 1000.0, machine.acceleration_time_y_ms / 1000.0
    gain = np.inf if kv is None else kv
    contour: ContourControl | None = None
    if machine.contour_control:
        slope, offset = machine.contour_time_slope_ms_per_mm_min, machine.contour_time_offset_ms
        if not (slope or offset):
            raise FormatError(
                "[machine] contour_time_offset_ms and contour_time_slope_ms_per_mm_min are both 0: contour control "
                "takes its time",
                setup.source or None,
            )
        change = machine.contour_speed_change_mm_min
        assert change is not None
        contour = ContourControl(change / 60.0, slope * 0.06, offset / 1000.0)
    if not (tx or ty or kv is not None or contour):
        return None
    x, y = (AxisDynamics(t, machine.acceleration_shape, gain) for t in (tx, ty))
    return Control(x, y, AxisDynamics(max(tx, ty), machine.acceleration_shape, gain), contour)
