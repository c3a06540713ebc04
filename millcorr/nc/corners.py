# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners that the control rounds or breaks: Fanuc's ,R and ,C; Siemens' RND=, RNDM=, CHR= and CHF=."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.nc.toolpath import Kind, Plane, Toolpath

_TANGENT = 1e-9
"""Sine of the turn below which there is no corner."""

Vector = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Corner:
    """What is to be done at the end of a move.

    Parameters
    ----------
    row : int
        The move.
    kind : str
        "r" a radius, "c" what is cut off each side, "d" the length of the chamfer.
    size : float
        mm.
    feed : float
        Feed in the corner, mm/s; NaN where none is known.
    """

    row: int
    kind: str
    size: float
    feed: float


@dataclass(frozen=True, eq=False, slots=True)
class _Made:
    """The move in place of a corner: a chamfer has no centre."""

    corner: Corner
    start: Floats
    end: Floats
    centre: Vector | None
    sweep: float


def rounded(toolpath: Toolpath, corners: list[Corner]) -> tuple[Toolpath, list[int]]:
    """Moves with their corners rounded or broken.

    Parameters
    ----------
    toolpath : Toolpath
        As programmed, through the corners.
    corners : list of Corner
        By rising row.

    Returns
    -------
    Toolpath
        With a move more for every corner, of the line whose end it is.
    list of int
        Rows whose corner cannot be made: the control would stop, or it is not followed.
    """
    start, end, sweep = toolpath.start.copy(), toolpath.end.copy(), toolpath.sweep.copy()
    failed: list[int] = []
    made: list[_Made] = []
    for corner in corners:
        i, j = corner.row, corner.row + 1
        found = _corner(toolpath, start, end, sweep, corner) if _can(toolpath, i, j) else None
        if found is None:
            failed.append(i)
            continue
        if not found:
            continue
        first, last, centre, turn = found[0]
        height = end[i, 2]
        a, b = np.array([*first, height]), np.array([*last, height])
        for row, place, at in ((i, a, end), (j, b, start)):
            if toolpath.kind[row] == Kind.ARC:
                from_, to = (start[row, :2], place[:2]) if row == i else (place[:2], end[row, :2])
                sweep[row] = _turn(from_, to, toolpath.centre[row, :2], float(sweep[row]))
            at[row] = place
        made.append(_Made(corner, a, b, centre, turn))
    return _inserted(toolpath.with_moves(start=start, end=end, sweep=sweep), made), failed


def _can(toolpath: Toolpath, i: int, j: int) -> bool:
    """Whether both moves cut in the XY plane at one height, one behind the other."""
    if j >= len(toolpath):
        return False
    rows = [i, j]
    flat = (toolpath.plane[rows] == Plane.XY).all() and np.isin(toolpath.kind[rows], (Kind.LINE, Kind.ARC)).all()
    z = toolpath.start[rows, 2], toolpath.end[rows, 2]
    level = bool((np.isnan(z[0]) & np.isnan(z[1]) | (np.abs(z[0] - z[1]) < 1e-9)).all())
    known = np.isfinite(toolpath.start[rows, :2]).all() and np.isfinite(toolpath.end[rows, :2]).all()
    turns = np.isfinite(toolpath.sweep[rows]).all()
    return bool(flat and level and known and turns)


def _corner(
    toolpath: Toolpath, start: Floats, end: Floats, sweep: Floats, corner: Corner
) -> list[tuple[Vector, Vector, Vector | None, float]] | None:
    """Begin, end, centre and sweep of the move in place of a corner; empty where there is none, None if impossible."""
    i, j = corner.row, corner.row + 1
    vertex = end[i, :2]
    arriving, leaving = (
        _direction(toolpath, row, vertex, float(sweep[row]), start[row, :2], end[row, :2]) for row in (i, j)
    )
    cross = arriving[0] * leaving[1] - arriving[1] * leaving[0]
    dot = arriving[0] * leaving[0] + arriving[1] * leaving[1]
    if not corner.size > 0 or not np.isfinite([*arriving, *leaving]).all():
        return [] if corner.size == 0 else None
    if abs(cross) < _TANGENT:
        return [] if dot > 0 else None
    side = math.copysign(1.0, cross)
    if corner.kind != "r":
        if toolpath.kind[i] != Kind.LINE or toolpath.kind[j] != Kind.LINE:
            return None
        half = 0.5 * math.acos(max(-1.0, min(1.0, dot)))
        cut = corner.size if corner.kind == "c" else corner.size / (2 * math.cos(half))
        if cut > math.dist(start[i, :2], vertex) or cut > math.dist(vertex, end[j, :2]):
            return None
        first, last = vertex - cut * np.array(arriving), vertex + cut * np.array(leaving)
        return [(_pair(first), _pair(last), None, 0.0)]
    shapes = [
        _offset(toolpath, row, vertex, direction, float(sweep[row]), side * corner.size)
        for row, direction in ((i, arriving), (j, leaving))
    ]
    if shapes[0] is None or shapes[1] is None:
        return None
    centres = _meeting(shapes[0], shapes[1])
    if not centres:
        return None
    centre = min(centres, key=lambda c: math.dist(c, vertex))
    feet = [_foot(toolpath, row, vertex, direction, centre) for row, direction in ((i, arriving), (j, leaving))]
    if not (
        _on(toolpath, i, feet[0], start[i, :2], vertex, float(sweep[i]))
        and _on(toolpath, j, feet[1], vertex, end[j, :2], float(sweep[j]))
    ):
        return None
    turn = _turn(np.array(feet[0]), np.array(feet[1]), np.array(centre), side)
    return [(feet[0], feet[1], centre, turn)]


def _pair(point: Floats) -> Vector:
    return float(point[0]), float(point[1])


def _direction(toolpath: Toolpath, row: int, at: Floats, sweep: float, start: Floats, end: Floats) -> Vector:
    """Unit vector of travel of a move at one of its ends."""
    if toolpath.kind[row] == Kind.ARC:
        arm = (at - toolpath.centre[row, :2]) * math.copysign(1.0, sweep)
        way = np.array([-arm[1], arm[0]])
    else:
        way = end - start
    length = math.hypot(*way)
    return (float(way[0] / length), float(way[1] / length)) if length > 0 else (math.nan, math.nan)


Shape = tuple[str, Vector, Vector, float]
"""A line (point, direction) or a circle (centre, -, radius)."""


def _offset(toolpath: Toolpath, row: int, vertex: Floats, way: Vector, sweep: float, left: float) -> Shape | None:
    """A move's line or circle, moved to its left."""
    if toolpath.kind[row] == Kind.LINE:
        return "line", (vertex[0] - left * way[1], vertex[1] + left * way[0]), way, 0.0
    centre = toolpath.centre[row, :2]
    radius = math.dist(vertex, centre) - math.copysign(left, left * sweep)
    return ("circle", _pair(centre), (0.0, 0.0), radius) if radius > 0 else None


def _meeting(a: Shape, b: Shape) -> list[Vector]:
    """Points that two lines or circles have in common."""
    if a[0] == b[0] == "line":
        (px, py), (ux, uy), (qx, qy), (vx, vy) = a[1], a[2], b[1], b[2]
        cross = ux * vy - uy * vx
        t = ((qx - px) * vy - (qy - py) * vx) / cross
        return [(px + t * ux, py + t * uy)]
    if a[0] == "circle" and b[0] == "circle":
        return _two_circles(a[1], a[3], b[1], b[3])
    line, circle = (a, b) if a[0] == "line" else (b, a)
    (px, py), (ux, uy), (cx, cy) = line[1], line[2], circle[1]
    along = (cx - px) * ux + (cy - py) * uy
    off = circle[3] ** 2 - (cx - px - along * ux) ** 2 - (cy - py - along * uy) ** 2
    if off < 0:
        return []
    return [(px + (along + s * math.sqrt(off)) * ux, py + (along + s * math.sqrt(off)) * uy) for s in (-1, 1)]


def _two_circles(p: Vector, r: float, q: Vector, s: float) -> list[Vector]:
    d = math.dist(p, q)
    if d == 0:
        return []
    along = (d * d + r * r - s * s) / (2 * d)
    off = r * r - along * along
    if off < 0:
        return []
    ux, uy = (q[0] - p[0]) / d, (q[1] - p[1]) / d
    h = math.sqrt(off)
    return [(p[0] + along * ux - k * h * uy, p[1] + along * uy + k * h * ux) for k in (-1, 1)]


def _foot(toolpath: Toolpath, row: int, vertex: Floats, way: Vector, centre: Vector) -> Vector:
    """Where a circle about a centre touches a move."""
    if toolpath.kind[row] == Kind.LINE:
        t = (centre[0] - vertex[0]) * way[0] + (centre[1] - vertex[1]) * way[1]
        return vertex[0] + t * way[0], vertex[1] + t * way[1]
    c = toolpath.centre[row, :2]
    radius, d = math.dist(vertex, c), math.dist(centre, c)
    return c[0] + (centre[0] - c[0]) * radius / d, c[1] + (centre[1] - c[1]) * radius / d


def _on(toolpath: Toolpath, row: int, foot: Vector, start: Floats, end: Floats, sweep: float) -> bool:
    """Whether a place lies on a move, its ends included."""
    if toolpath.kind[row] == Kind.LINE:
        way = end - start
        t = float((np.array(foot) - start) @ way) / float(way @ way)
        return -1e-9 <= t <= 1 + 1e-9
    turn = _turn(start, np.array(foot), toolpath.centre[row, :2], sweep)
    return abs(turn) <= abs(sweep) + 1e-9 or abs(abs(turn) - 2 * math.pi) < 1e-9


def _turn(start: Floats, end: Floats, centre: Floats, sense: float) -> float:
    """Angle from one place to another about a centre, of the sign of `sense`, up to a turn."""
    a, b = start - centre, end - centre
    angle = math.atan2(a[0] * b[1] - a[1] * b[0], float(a @ b))
    if sense > 0:
        return angle if angle >= 0 else angle + 2 * math.pi
    return angle if angle <= 0 else angle - 2 * math.pi


def _inserted(toolpath: Toolpath, made: list[_Made]) -> Toolpath:
    """Moves with others inserted behind some of them."""
    if not made:
        return toolpath
    rows: Ints = np.array([m.corner.row for m in made], np.int64)
    centre = np.full((len(rows), 3), np.nan)
    for k, m in enumerate(made):
        if m.centre is not None:
            centre[k] = [*m.centre, m.start[2]]
    more = toolpath.take(rows).with_moves(
        kind=np.array([Kind.LINE if m.centre is None else Kind.ARC for m in made], np.int64),
        start=np.array([m.start for m in made]),
        end=np.array([m.end for m in made]),
        centre=centre,
        sweep=np.array([m.sweep for m in made]),
        feed=np.array([m.corner.feed for m in made]),
        control=np.full((len(rows), 4), np.nan),
    )
    order = np.argsort(np.concatenate([np.arange(len(toolpath)), rows]), kind="stable")
    return Toolpath.merged(toolpath, np.arange(len(toolpath)), more, order)
