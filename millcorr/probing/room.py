# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a probe stays in the space that a milling program has cleared.

Outside of it there may be stock, a clamp or a vise that neither the contour nor the program knows.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from millcorr.arrays import Bools, Floats
from millcorr.nc.toolpath import Compensation, Kind

from .heights import Cleared
from .planning import ProbingPlan

_ARC_STEPS = 33
_LITTLE = 0.01
"""Arcs are taken as chords and discs as polygons: so much of the space, in mm, is not disputed."""


def outside_cleared(plan: ProbingPlan, cleared: Cleared, z: float) -> Floats:
    """Places at measuring height where the ball leaves the space that a cutter has swept.

    Parameters
    ----------
    plan : ProbingPlan
    cleared : Cleared
        Feed moves whose tip stays at or below `z` clear their whole width. Where moves under G41 or G42 give the
        contour, that is the width beside it, but for the moves with which the compensation begins and ends: how a
        control leads in is its own matter.
    z : float
        Height of the lowest point of the ball, mm.

    Returns
    -------
    (k, 2) float64
        Ball centres in mm, starts of touches and corners of ways between them; empty where all is clear.
    """
    toolpath, tool_radius = cleared.toolpath, cleared.radius
    low = np.fmax(toolpath.start[:, 2], toolpath.end[:, 2]) <= z + 1e-9
    known = np.isfinite(toolpath.start[:, :2]).all(axis=1) & np.isfinite(toolpath.end[:, :2]).all(axis=1)
    ways = [plan.start, *(link for link in plan.links if link is not None)]
    ball = np.concatenate([_filled(way) if k else way for k, way in enumerate(ways)])
    reach = tool_radius - plan.probe.ball_radius + _LITTLE
    if reach <= 0:
        return ball
    lines = _centre_paths(cleared, low & known)
    # A ball within one pass of the cutter is clear; one that needs two passes side by side is found by the area.
    swept = shapely.union_all(shapely.buffer(lines, tool_radius + _LITTLE, quad_segs=32))
    room = shapely.buffer(swept, -plan.probe.ball_radius, quad_segs=32)
    shapely.prepare(room)
    out: Floats = ball[~shapely.intersects_xy(room, ball[:, 0], ball[:, 1])]
    return out


def _centre_paths(cleared: Cleared, usable: Bools) -> NDArray[np.object_]:
    """Ways of the cutter's centre as line strings, of those feed moves that are usable."""
    path = cleared.toolpath
    usable = usable & (path.kind != Kind.RAPID)
    along = np.linspace(0.0, 1.0, _ARC_STEPS)
    side = np.where(cleared.contour_programmed, path.compensation, Compensation.OFF)
    # The move that begins the compensation, and the one that ends it, lead from or to a place on no parallel.
    still = (np.abs(path.end[:, :2] - path.start[:, :2]) <= 1e-9).all(axis=1) & (path.sweep == 0)
    rows = np.flatnonzero(~still)
    before = np.concatenate([[Compensation.OFF], side[rows][:-1]]) if len(rows) else side[rows]
    leads = np.zeros(len(path), dtype=bool)
    leads[rows] = side[rows] != before
    plain: NDArray[np.object_] = shapely.linestrings(
        path.take(usable & ~leads & (side == Compensation.OFF)).position(along)[:, :, :2]
    )
    own = np.flatnonzero(~still & (side != Compensation.OFF) & ~leads)
    if not len(own):
        return plain
    points = path.take(own).position(along)[:, :, :2]
    # Each row of moves that follow each other on one side, at one usable depth, is one line with one parallel.
    order = np.searchsorted(rows, own)
    cut = (np.diff(order) != 1) | (np.diff(side[own]) != 0) | (np.diff(usable[own]) != 0)
    parallels = []
    for chain in np.split(np.arange(len(own)), np.flatnonzero(cut) + 1):
        if usable[own[chain[0]]]:
            parallels.append(_parallel(points[chain].reshape(-1, 2), float(side[own[chain[0]]] * cleared.radius)))
    return np.concatenate([plain, np.array(parallels, dtype=object)])


def _parallel(points: Floats, offset: float) -> shapely.Geometry:
    """Where a cutter's centre goes beside a polyline, positive to its left: nowhere nearer to it than the offset.

    Not GEOS' own offset curve, which before 3.12 loses most of a polyline that touches itself.
    """
    step = np.diff(points, axis=0)
    moves = np.hypot(step[:, 0], step[:, 1]) > 1e-9
    start, end, turn = points[:-1][moves], points[1:][moves], np.arctan2(step[moves, 1], step[moves, 0])
    # Round each corner on the shorter way; inside a corner that is too near, and taken away.
    bend = np.diff(turn, append=turn[-1:])
    bend -= 2 * np.pi * np.round(bend / (2 * np.pi))
    angle = turn[:, None] + bend[:, None] * np.linspace(0.0, 1.0, _ARC_STEPS)
    normal = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
    beside = np.concatenate([(start + offset * normal[:, 0])[:, None], end[:, None] + offset * normal], axis=1)
    near = shapely.buffer(
        shapely.linestrings(np.concatenate([start, end[-1:]])), abs(offset) - _LITTLE, quad_segs=32, cap_style="flat"
    )
    return shapely.difference(shapely.linestrings(beside.reshape(-1, 2)), near)


def _filled(way: Floats) -> Floats:
    """Points every millimetre along a polyline, its corners included."""
    pieces = []
    for a, b in zip(way[:-1], way[1:], strict=True):
        count = max(1, int(np.ceil(np.hypot(*(b - a)))))
        pieces.append(a + np.linspace(0.0, 1.0, count + 1)[:, None] * (b - a))
    return np.concatenate(pieces)
