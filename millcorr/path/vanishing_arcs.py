# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs of a path that vanish when the path is moved: replaced by the corner in which their neighbours meet."""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.errors import LimitError
from millcorr.messages import option
from millcorr.nc.toolpath import Kind, Plane, Toolpath
from millcorr.tolerances import EXACT

NEARLY_GONE = 1e-3
"""An arc that would keep a smaller radius than this, in mm, is no move that a control runs well."""


def without_vanishing_arcs(
    toolpath: Toolpath, rows: Bools, material_right: Bools, shift: float
) -> tuple[Toolpath, Bools]:
    """The toolpath with sharp corners in place of the arcs that a shift away from the material would turn over.

    The path that is parallel to the result is the same: at an inner corner the neighbours' parallels are cut where
    they meet, long before they reach the arc.

    Parameters
    ----------
    toolpath : Toolpath
    rows : (n,) bool
        Moves that will be moved.
    material_right : (n,) bool
        Whether the material lies to the right of the direction of travel.
    shift : float
        How far the path will be moved away from the material, mm.

    Returns
    -------
    Toolpath
        The same one where no arc vanishes.
    kept : (n,) bool
        Moves of the given toolpath that it still has.

    Raises
    ------
    LimitError
        If the neighbours of such an arc do not meet, or are such arcs themselves; names the place.
    """
    radius = np.hypot(*(toolpath.start - toolpath.centre)[:, :2].T)
    inward = (toolpath.sweep > 0) == material_right
    gone = (toolpath.kind == Kind.ARC) & (toolpath.plane == Plane.XY) & rows & inward & (radius < shift + NEARLY_GONE)
    if not gone.any():
        return toolpath, ~gone
    start, end, sweep = toolpath.start.copy(), toolpath.end.copy(), toolpath.sweep.copy()
    for k in np.flatnonzero(gone).tolist():
        before, after = k - 1, k + 1
        if before < 0 or after >= len(toolpath) or gone[before] or gone[after] or not (rows[before] and rows[after]):
            raise _no_corner(toolpath, k, shift)
        gaps = np.abs([start[k, :2] - end[before, :2], end[k, :2] - start[after, :2]])
        corner = _meeting(toolpath, before, after, 0.5 * (start[k, :2] + end[k, :2]))
        if corner is None or gaps.max() > EXACT:
            raise _no_corner(toolpath, k, shift)
        end[before, :2] = start[after, :2] = corner
        for row in (before, after):
            sweep[row] = _sweep(toolpath, row, start[row, :2], end[row, :2])
    return toolpath.with_moves(start=start, end=end, sweep=sweep).take(~gone), ~gone


def _no_corner(toolpath: Toolpath, row: int, shift: float) -> LimitError:
    x, y = toolpath.start[row, :2]
    return LimitError(
        f"the path's arc at X{x:.3f} Y{y:.3f} is smaller than the {shift:g} mm it must be moved, ",
        "and its neighbours do not meet in a corner: leave less for the second cut (",
        option("at"),
        " nearer to 1), or take a smaller tool",
    )


def _meeting(toolpath: Toolpath, first: int, second: int, near: Floats) -> Floats | None:
    """Intersection nearest to a point of the lines or circles that two moves lie on; None without one."""
    found = []
    kinds = toolpath.kind[first], toolpath.kind[second]
    if not all(kind in (Kind.LINE, Kind.ARC) for kind in kinds):
        return None
    if kinds == (Kind.LINE, Kind.LINE):
        a, u = _line(toolpath, first)
        b, v = _line(toolpath, second)
        across = u[0] * v[1] - u[1] * v[0]
        if abs(across) > 1e-9:
            gap = b - a
            found.append(a + (gap[0] * v[1] - gap[1] * v[0]) / across * u)
    elif Kind.LINE in kinds:
        straight, round_ = (first, second) if kinds[0] == Kind.LINE else (second, first)
        a, u = _line(toolpath, straight)
        centre, radius = _circle(toolpath, round_)
        along = float((centre - a) @ u)
        room = radius**2 - float(((centre - a) ** 2).sum()) + along**2
        if room >= 0:
            found += [a + (along + sign * np.sqrt(room)) * u for sign in (-1.0, 1.0)]
    else:
        (p, r), (q, t) = _circle(toolpath, first), _circle(toolpath, second)
        away = float(np.hypot(*(q - p)))
        if away > 0:
            along = (away**2 + r**2 - t**2) / (2 * away)
            if abs(along) <= r:
                u = (q - p) / away
                height = np.sqrt(r**2 - along**2)
                found += [p + along * u + sign * height * np.array([-u[1], u[0]]) for sign in (-1.0, 1.0)]
    return min(found, key=lambda point: float(np.hypot(*(point - near))), default=None)


def _line(toolpath: Toolpath, row: int) -> tuple[Floats, Floats]:
    a, b = toolpath.start[row, :2], toolpath.end[row, :2]
    return a, (b - a) / max(float(np.hypot(*(b - a))), 1e-300)


def _circle(toolpath: Toolpath, row: int) -> tuple[Floats, float]:
    centre = toolpath.centre[row, :2]
    return centre, float(np.hypot(*(toolpath.start[row, :2] - centre)))


def _sweep(toolpath: Toolpath, row: int, start: Floats, end: Floats) -> float:
    """Angle of a move whose ends were moved along its circle, near to what it was; 0 for a straight one."""
    if toolpath.kind[row] != Kind.ARC:
        return 0.0
    a, b = start - toolpath.centre[row, :2], end - toolpath.centre[row, :2]
    angle = float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))
    turns = np.round((toolpath.sweep[row] - angle) / (2 * np.pi))
    return float(angle + 2 * np.pi * turns)
