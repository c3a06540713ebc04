# SPDX-License-Identifier: LGPL-2.1-or-later
"""How leads, ramps and plunges go along with a corrected contour, and where that ends.

What leads onto a contour and off it is displaced rigidly with it, and turned with it where it is tangential: else it
would cut into a wall that turns with its correction. What is work of its own, another contour, a
roughing pass, a helical entry, stays where it is: one move between takes up the difference.
"""

from __future__ import annotations

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.theoretical_contour import closed_loops, cutting_runs
from millcorr.nc.toolpath import Kind, Toolpath

TANGENTIAL = 0.02
"""An arc is a lead on the tangent where it meets the contour under less than this angle, in rad."""

CUTS_IN = 2e-4
"""A lead of radius r that keeps its direction cuts e^2 r / 2 into a straight wall that turns by e, and up to four times
that into a pocket's; where e^2 r is less than this, in mm, it stays as it is: turned, its far end would move by e r."""

REACH = 30.0
"""Leads are at most this long, in mm; what is chained on farther away stays where it is."""


def own_work(toolpath: Toolpath, following: Bools) -> Bools:
    """Moves that cut something else than the corrected contour.

    Parameters
    ----------
    toolpath : Toolpath
    following : (n,) bool
        Moves on the contour that is corrected.

    Returns
    -------
    (n,) bool
    """
    progress.step()
    out = np.zeros(len(toolpath), dtype=bool)
    section = sections(toolpath)
    touched = np.zeros(int(section.max(initial=0)) + 1, dtype=bool)
    touched[section[following]] = True
    for run in cutting_runs(toolpath):
        # What a rapid lies between is never displaced.
        if not touched[section[run]].any():
            continue
        for a, b in closed_loops(toolpath, run):
            if not following[run[a:b]].any():
                out[run[a:b]] = True
    return out


def sections(toolpath: Toolpath) -> Ints:
    """Number of each move's section; a rapid in the plane begins a new one; (n,)."""
    travel = np.nan_to_num(toolpath.end[:, :2] - toolpath.start[:, :2], nan=1.0)
    jump: Ints = ((toolpath.kind == int(Kind.RAPID)) & (np.abs(travel).max(axis=1) > 0)).astype(np.int64)
    return np.cumsum(jump)


def carry_along(
    toolpath: Toolpath,
    following: Bools,
    own: Bools,
    shift0: Floats,
    shift1: Floats,
    turns: tuple[Floats, Floats] | None = None,
) -> None:
    """Hand the displacement of following moves on to their leads. In place.

    Parameters
    ----------
    toolpath : Toolpath
    following, own : (n,) bool
        Moves on the contour; moves that must stay.
    shift0, shift1 : (n, 2) float64
        Displacement in mm of every move's start and end; given for following moves, filled in for the others.
    turns : ((n,) float64, (n,) float64), optional
        By how much, in rad, the start and the end of following moves turn; by default not at all.
    """
    n = len(toolpath)
    position = np.hstack([toolpath.start[:, :2], toolpath.end[:, :2]])
    broken = np.asarray(~np.isfinite(position).all(axis=1))
    travel = np.nan_to_num(toolpath.length())
    flat = np.nan_to_num(np.hypot(*(toolpath.end[:, :2] - toolpath.start[:, :2]).T))
    flat = np.where(toolpath.sweep != 0, travel, flat)
    jump = np.asarray((toolpath.kind == int(Kind.RAPID)) & (flat > 1e-9))
    # An arc of which one end moves bulges: it goes along whole, and a straight move takes up the difference.
    straight = np.asarray((flat > 1e-9) & (toolpath.sweep == 0))
    rows = np.flatnonzero(following)
    heads = rows[np.concatenate([[True], np.diff(rows) > 1])]
    tails = rows[np.concatenate([np.diff(rows) > 1, [True]])]
    for tail, head in zip([-1, *tails.tolist()], [*heads.tolist(), n], strict=True):
        gap = np.arange(tail + 1, head)
        if not len(gap):
            continue
        stops = gap[jump[gap] | broken[gap] | own[gap]]
        if tail >= 0 and head < n and not len(stops):
            _take_up(gap, flat, straight, shift1[tail], shift0[head], shift0, shift1)
            continue
        if tail >= 0:
            end = int(stops[0]) if len(stops) else n
            outward, moved = np.arange(tail + 1, end), shift1[tail]
            if turns is not None:
                outward, moved = _turned(toolpath, tail, outward, moved, turns[1][tail], shift0, shift1, 1)
            _release(outward, end, n, flat, straight, jump, broken, moved, shift0, shift1, 1)
        if head < n:
            begin = int(stops[-1]) if len(stops) else -1
            outward, moved = np.arange(head - 1, begin, -1), shift0[head]
            if turns is not None:
                outward, moved = _turned(toolpath, head, outward, moved, turns[0][head], shift0, shift1, -1)
            _release(outward, begin, n, flat, straight, jump, broken, moved, shift0, shift1, -1)


def _turned(
    toolpath: Toolpath, row: int, rows: Ints, moved: Floats, turn: float, shift0: Floats, shift1: Floats, way: int
) -> tuple[Ints, Floats]:
    """An arc on the tangent of the following move `row` turns with it where the wall turns towards it, in place.

    Gives what is beyond it, and its shift.
    """
    if not len(rows) or toolpath.sweep[rows[0]] == 0 or not turn:
        return rows, moved
    near, far = (shift0, shift1) if way > 0 else (shift1, shift0)
    arc, own_end = rows[:1], np.full(1, 1.0 if way > 0 else 0.0)
    here, there = toolpath.direction(np.array([row]), own_end)[0], toolpath.direction(arc, 1.0 - own_end)[0]
    if abs(here[0] * there[1] - here[1] * there[0]) > TANGENTIAL or here @ there < 0:
        return rows, moved
    out, place = way * there, toolpath.place(arc, 1.0 - own_end)[0]
    if turn * float(np.array([-out[1], out[0]]) @ (toolpath.centre[arc[0], :2] - place)) < 0:
        # The wall turns away from the lead, which cuts nothing as it is.
        return rows, moved
    if turn**2 * float(np.hypot(*(toolpath.centre[arc[0], :2] - place))) < CUTS_IN:
        return rows, moved
    near[arc] = moved
    arm = toolpath.place(arc, own_end)[0] - place
    c, s = np.cos(turn), np.sin(turn)
    moved = moved + np.array([c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]]) - arm
    far[arc] = moved
    return rows[1:], moved


def _release(
    rows: Ints,
    stop: int,
    n: int,
    flat: Floats,
    straight: Bools,
    jump: Bools,
    broken: Bools,
    moved: Floats,
    shift0: Floats,
    shift1: Floats,
    way: int,
) -> None:
    """Displace `rows`, listed outward from the contour, up to the move `stop` that stays or jumps. In place."""
    near, far = (shift0, shift1) if way > 0 else (shift1, shift0)
    long = np.flatnonzero(np.cumsum(flat[rows]) > REACH) if len(rows) else np.zeros(0, dtype=np.int64)
    takes_up = np.flatnonzero(straight[rows])
    beyond = not 0 <= stop < n
    if len(long) and len(takes_up):
        rows = rows[: max(long[0], takes_up[0]) + 1]
    elif beyond or jump[stop] or broken[stop]:
        # A rapid goes to wherever the contour now begins; at an end of the program nothing is left to meet.
        near[rows], far[rows] = moved, moved
        if not beyond and not (broken[stop] and way > 0 and not jump[stop]):
            near[stop] = moved
        return
    # The longest move hides the difference best; what lies beyond it stays.
    moving = np.flatnonzero(straight[rows])
    if not len(moving):
        moving = np.flatnonzero(flat[rows] > 1e-9)
    if not len(moving):
        near[rows], far[rows] = moved, moved
        if not beyond:
            near[stop] = moved
        return
    absorber = int(moving[np.argmax(flat[rows[moving]])])
    near[rows[: absorber + 1]] = moved
    far[rows[:absorber]] = moved


def _take_up(
    rows: Ints, flat: Floats, straight: Bools, before: Floats, after: Floats, shift0: Floats, shift1: Floats
) -> None:
    """Between two corrected contours the longest move takes up what they differ by. In place."""
    absorber = int(np.argmax(flat[rows] * np.where(straight[rows].any(), straight[rows], True)))
    shift0[rows[: absorber + 1]] = before
    shift1[rows[:absorber]] = before
    shift1[rows[absorber:]] = after
    shift0[rows[absorber + 1 :]] = after
