# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program at the feeds that the machine really runs, on the commanded path or on the one that the axes run.

Chip and force follow the real feed (dat-2025), not the one in the program, and engagement the path that is really run:
the axes cut corners and run arcs smaller (`millcorr.process.kinematics`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind, Plane, Toolpath
from millcorr.process.deflection.real_path import flat_cuts
from millcorr.process.kinematics import AxisDynamics, ContourControl, Control, Motion
from millcorr.process.setup_file import Setup

SPACING = 0.25
"""The feed is looked at in steps of about this length along a move, in mm."""

EVEN = 0.005
"""Parts of a move whose feeds differ by less than this share of the programmed feed stay together."""

WITHIN = 5e-5
"""The path that the axes run is thinned to lines within this, in mm."""

_SAME_PLACE = 1e-9

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

    def run(self, program: Toolpath, motion: Motion) -> RealFeed:
        """The same on the path that the axes run, as lines; moves that do not cut in the plane as they were programmed.

        Parameters
        ----------
        program : Toolpath
            What this is of.
        motion : Motion
            Of the program.
        """
        place = _place(program, motion)
        # Where the tool waits it settles: the last sample counts.
        last = np.append(np.diff(place) > 1e-12, True) & np.isfinite(motion.x) & np.isfinite(motion.y)
        place, centre = place[last], np.column_stack([motion.x, motion.y])[last]
        low, high = self.move + self.begin, self.move + self.end
        # A move that is too short for a sample is run as well.
        rows = np.flatnonzero(flat_cuts(program)[self.move] & ~np.isin(self.move, motion.omitted))
        if not len(rows) or not len(place):
            return self
        first, beyond = np.searchsorted(place, low[rows], "right"), np.searchsorted(place, high[rows])
        count = np.maximum(beyond - first, 0) + 2
        owner = np.repeat(np.arange(len(rows)), count)
        k = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
        along = place[np.clip(np.repeat(first, count) + k - 1, 0, len(place) - 1)]
        along = np.where(k == 0, low[rows][owner], np.where(k == count[owner] - 1, high[rows][owner], along))
        points = np.column_stack([*(np.interp(along, place, centre[:, c]) for c in (0, 1)), along])
        lines = shapely.simplify(shapely.linestrings(points, indices=owner), WITHIN, preserve_topology=False)
        points, owner = shapely.get_coordinates(lines, include_z=True, return_index=True)
        far = (owner[1:] == owner[:-1]) & (np.hypot(*np.diff(points[:, :2], axis=0).T) > _SAME_PLACE)
        begins = np.flatnonzero(far)
        part = rows[owner[begins]]
        move = self.move[part]
        height = self.toolpath.end[part, 2]
        n = len(part)
        cut = self.toolpath.take(part).with_moves(
            kind=np.full(n, int(Kind.LINE)),
            start=np.column_stack([points[begins, :2], height]),
            end=np.column_stack([points[begins + 1, :2], height]),
            centre=np.full((n, 3), np.nan),
            sweep=np.zeros(n),
            control=np.full((n, 4), np.nan),
            plane=np.full(n, int(Plane.XY)),
        )
        other = np.setdiff1d(np.arange(len(self.move)), rows)
        order = np.argsort(np.concatenate([part, other]), kind="stable")
        return RealFeed(
            Toolpath.concatenate([cut, self.toolpath.take(other)]).take(order),
            np.concatenate([move, self.move[other]])[order],
            np.concatenate([points[begins, 2] - move, self.begin[other]])[order],
            np.concatenate([points[begins + 1, 2] - move, self.end[other]])[order],
        )


def commanded(toolpath: Toolpath, place: Floats) -> Floats:
    """Where the cutter's centre is commanded at places counted in moves, on lines and arcs of the XY plane; (k, 2).

    NaN on other moves.
    """
    move = np.clip(np.floor(place).astype(np.int64), 0, len(toolpath) - 1)
    plain = (toolpath.kind[move] == Kind.LINE) | (
        (toolpath.kind[move] == Kind.ARC) & (toolpath.plane[move] == Plane.XY)
    )
    out = np.full((len(place), 2), np.nan)
    out[plain] = _at(toolpath, move[plain], (place - move)[plain])[:, :2]
    return out


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
            raise FormatError(
                phrase("[machine] {} {:g} is neither 0 nor at least 1 (ms)", name, value), setup.source or None
            )
    kv = machine.position_gain_per_s
    if kv is not None and kv > 1000.0:
        raise FormatError(phrase("[machine] position_gain_per_s {:g} is above 1000 (1/s)", kv), setup.source or None)
    tx, ty = machine.acceleration_time_x_ms / 1000.0, machine.acceleration_time_y_ms / 1000.0
    gain = np.inf if kv is None else kv
    contour: ContourControl | None = None
    if machine.contour_control:
        slope, offset = machine.contour_time_slope_ms_per_mm_min, machine.contour_time_offset_ms
        if not (slope or offset):
            raise FormatError(
                phrase(
                    "[machine] contour_time_offset_ms and contour_time_slope_ms_per_mm_min are both 0: contour "
                    "control takes its time"
                ),
                setup.source or None,
            )
        change = machine.contour_speed_change_mm_min
        assert change is not None
        contour = ContourControl(change / 60.0, slope * 0.06, offset / 1000.0)
    if not (tx or ty or kv is not None or contour):
        return None
    x, y = (AxisDynamics(t, machine.acceleration_shape, gain) for t in (tx, ty))
    return Control(x, y, AxisDynamics(max(tx, ty), machine.acceleration_shape, gain), contour)
