# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrected toolpath: new moves in place of those on the contour, the others as they were or carried along.

Each move keeps its place in the sequence, its feed and its neighbours; leads, ramps and links go along rigidly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.nc.toolpath import Kind, Toolpath

BAND = 0.1
"""A following move is at most this far, in mm, from the exact parallel of what the program is to follow."""

KEEP_SHARE = 0.4
"""A move already within this share of the tolerance from where it should be stays as it is."""

FIT_SHARE = 0.4
"""Share of the tolerance that replacing the exact path by lines and arcs may use; rounding needs the rest."""


@dataclass(frozen=True, eq=False, slots=True)
class Regeneration:
    """A corrected toolpath and where it came from.

    Parameters
    ----------
    toolpath : Toolpath
        The corrected moves; `source` as in the original.
    origin : (m,) int64
        Row of the original toolpath of each corrected move.
    following : (m,) bool
        Moves that follow the contour.
    changed : int
        Number of original moves that changed.
    original_error : float
        Largest distance in mm of the original following moves from the nominal's parallel.
    fit_error : float
        Largest distance in mm between the new moves and the exact path, before rounding.
    largest_shift : float
        Largest displacement of a vertex of the path, mm.
    lines : (k,) int64
        Lines of the program (`source`) whose moves, or their starts, are not where they were.
    """

    toolpath: Toolpath
    origin: Ints
    following: Bools
    changed: int
    original_error: float
    fit_error: float
    largest_shift: float
    lines: Ints


def put_together(
    toolpath: Toolpath,
    following: Bools,
    replaced: Ints,
    fitted: Toolpath,
    owner: Ints,
    shift0: Floats,
    shift1: Floats,
    errors: tuple[float, float],
) -> Regeneration:
    """The corrected toolpath: new moves in place of some, the others displaced with their neighbours.

    Parameters
    ----------
    toolpath : Toolpath
        As it was.
    following : (n,) bool
        Moves that follow the contour.
    replaced : (k,) int64
        Rows that new moves stand for; the order of those of one row counts.
    fitted : Toolpath
        The new moves.
    owner : (m,) int64
        Which of `replaced` each new move belongs to.
    shift0, shift1 : (n, 2) float64
        Displacement of every move's start and end, mm; NaN where a place is not known.
    errors : (float, float)
        `original_error` and `fit_error` of the `Regeneration`.
    """
    rewritten = np.zeros(len(toolpath), dtype=bool)
    rewritten[replaced] = True
    shifted = (shift0 != 0).any(axis=1) | (shift1 != 0).any(axis=1)
    rigid, rest = np.flatnonzero(shifted & ~rewritten), np.flatnonzero(~shifted & ~rewritten)
    along = _moved_rigidly(toolpath.take(rigid), shift0[rigid], shift1[rigid])
    new = Toolpath.concatenate([along, _dressed(fitted, toolpath, replaced[owner])])
    origin = np.concatenate([rest, rigid, replaced[owner]])
    # Fitted moves come part by part and in order within a part; a stable sort restores the program's order.
    order = np.argsort(origin, kind="stable")
    shift = np.concatenate([shift0[np.isfinite(shift0).all(axis=1)], shift1[np.isfinite(shift1).all(axis=1)]])
    changed = rewritten | (np.abs(shift0) > 0).any(axis=1) | (np.abs(shift1) > 0).any(axis=1)
    return Regeneration(
        Toolpath.merged(toolpath, rest, new, order),
        origin[order],
        following[origin[order]],
        int(changed.sum()),
        *errors,
        float(np.hypot(*shift.T).max(initial=0.0)),
        np.unique(toolpath.source[changed]),
    )


def wanted_kind(kind: Ints, z0: Floats, z1: Floats, output_moves: str) -> Ints:
    """Kind of move to write in place of each, from heights at its ends in mm."""
    if output_moves == "keep":
        return kind.copy()
    wanted = {"lines": Kind.LINE, "arcs": Kind.ARC, "nurbs": Kind.CUBIC}[output_moves]
    out = np.full(len(kind), int(wanted))
    # A spline block (G5) moves in the plane only; a rising move takes arcs.
    out[(out == Kind.CUBIC) & (z0 != z1)] = int(Kind.ARC)
    return out


def _dressed(fitted: Toolpath, toolpath: Toolpath, row: Ints) -> Toolpath:
    """Fitted moves with feed, plane, source and modes of the moves they replace."""
    return fitted.with_moves(
        plane=toolpath.plane[row].copy(),
        feed=toolpath.feed[row].copy(),
        source=toolpath.source[row].copy(),
        compensation=toolpath.compensation[row].copy(),
        tool=toolpath.tool[row].copy(),
    )


def _moved_rigidly(toolpath: Toolpath, shift0: Floats, shift1: Floats) -> Toolpath:
    """Moves with displaced ends; an arc whose ends move alike moves as a whole, else it is turned and scaled."""
    start, end = toolpath.start.copy(), toolpath.end.copy()
    centre, control = toolpath.centre.copy(), toolpath.control.copy()
    start[:, :2] += shift0
    end[:, :2] += shift1
    for i in np.flatnonzero((toolpath.kind == Kind.ARC) | (toolpath.kind == Kind.CUBIC)):
        old0, old1 = complex(*toolpath.start[i, :2]), complex(*toolpath.end[i, :2])
        new0, new1 = complex(*start[i, :2]), complex(*end[i, :2])
        same = abs((new1 - new0) - (old1 - old0)) < 1e-12 or abs(old1 - old0) < 1e-9
        factor = 1.0 if same else (new1 - new0) / (old1 - old0)

        centre[i, :2] = _carried(toolpath.centre[i, :2], old0, new0, factor)
        control[i, :2] = _carried(toolpath.control[i, :2], old0, new0, factor)
        control[i, 2:] = _carried(toolpath.control[i, 2:], old0, new0, factor)
    return toolpath.with_moves(start=start, end=end, centre=centre, control=control)


def _carried(point: Floats, old: complex, new: complex, factor: complex) -> tuple[float, float]:
    """A point carried along by the similarity that takes `old` to `new`."""
    z = new + factor * (complex(point[0], point[1]) - old)
    return z.real, z.imag
