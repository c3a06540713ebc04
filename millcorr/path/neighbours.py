# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof that a moved pass leaves the walls alone that others have made.

A cutter has a back: what it does not correct may stand 0.01 mm beside it. The walls that other passes leave lie their
radius to either side of their paths, wherever nothing else cuts deeper; none of that may be cut by what has moved.
"""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.commanded_surface import CommandedSurface, rows_near
from millcorr.comparison.path_distance import PathDistance
from millcorr.errors import LimitError
from millcorr.messages import phrase, um, xy
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.passes import FEW_HEIGHTS
from millcorr.path.path_following import length_in_plane

ONE_WALL = 0.866
"""Where a moved pass meets a wall at more than 30 degrees (cosine between their normals) it moves the edge between two
walls, as it should; below that the two are as good as one wall, and it cuts into it."""


def refuse_cut_neighbours(
    original: CommandedSurface,
    written: CommandedSurface,
    changed: tuple[Bools, Bools],
    leads: Bools,
    *,
    shift: float,
    tolerance: float,
) -> None:
    """LimitError where a move that changed cuts into a wall that a move which did not change has made.

    Parameters
    ----------
    original, written : CommandedSurface
        All passes of the program before, and of the text as it is read back.
    changed : (n,) bool, (m,) bool
        Moves of either that are not as they were.
    leads : (n,) bool
        Moves of the program before that lead onto what is corrected and off it: what they cut is no wall.
    shift : float
        How far any of them has moved at most, mm.
    tolerance : float
        mm.

    Raises
    ------
    LimitError
        Names place, amount and both lines.
    """
    then, now = (np.flatnonzero(_cuts(s) & c) for s, c in zip((original, written), changed, strict=True))
    if shift <= tolerance or not len(then) or not len(now):
        return
    reach = 2 * float(np.nanmax(original.radius)) + shift
    others = np.flatnonzero(_cuts(original) & ~changed[0] & ~leads)
    others = others[_near(original.toolpath, others, then, reach)]
    row, place, normal = _sides(original, others, tolerance)
    step = 0.5 + shift
    beside = _in_cells(place, _outline(written, now, step), step)
    row, place, normal = row[beside], place[beside], normal[beside]
    bottom = _bottom(original.toolpath)
    lowest = _bottom(written.toolpath)[now]
    heights = np.unique(lowest)
    # Passes that lie on each other at few heights are looked at one by one; of a helix the move that comes nearest is.
    levels = heights if len(heights) <= FEW_HEIGHTS else [None]
    worst = (tolerance, -1, -1)
    for level in levels:
        mine = now if level is None else now[lowest == level]
        depth, cutting = _depth(written, mine, place)
        deep = np.flatnonzero((depth > tolerance) & (depth <= shift + tolerance))
        if not len(deep):
            continue
        _, at, u = PathDistance(written.toolpath, mine).nearest(place[deep])
        away = place[deep] - written.toolpath.place(at, u)
        cosine = -(away * normal[deep]).sum(axis=1) / np.maximum(np.hypot(*away.T), 1e-12)
        deep = deep[cosine > ONE_WALL]
        if not len(deep):
            continue
        close = np.flatnonzero(_cuts(original) & rows_near(original.toolpath, place[deep], reach))
        # A wall is cut where it stands and the moved cutter comes down to.
        z = np.maximum(bottom[row[deep]], _bottom(written.toolpath)[cutting[deep]])
        for height in np.unique(z):
            here = deep[z == height]
            cut = close[bottom[close] <= height + 1e-6]
            # What the moved passes made together with others is theirs, and what is cut deeper is no wall.
            own = _depth(original, cut[changed[0][cut]], place[here])[0]
            wall = (_depth(original, cut, place[here])[0] <= tolerance) & (own < -tolerance)
            if wall.any():
                k = here[wall][int(np.argmax(depth[here[wall]]))]
                worst = max(worst, (float(depth[k]), int(k), int(cutting[k])))
    amount, k, by = worst
    if k < 0:
        return
    x, y = place[k]
    raise LimitError(
        phrase(
            "line {} of the corrected program would cut {} into another wall at {}, which line {} of "
            "the program has made and which is not corrected: measure it, too, or correct less there",
            written.toolpath.line(by),
            um(amount, ".1f"),
            xy(x, y),
            original.toolpath.line(row[k]),
        ),
        place=(float(x), float(y)),
        figure=amount,
    )


def _cuts(surface: CommandedSurface) -> Bools:
    """Moves that cut with a cutter of known radius."""
    known = np.isfinite(surface.toolpath.start[:, :2] + surface.toolpath.end[:, :2]).all(axis=1)
    out: Bools = (surface.toolpath.kind != Kind.RAPID) & (np.nan_to_num(surface.radius) > 0) & known
    return out


def _bottom(toolpath: Toolpath) -> Floats:
    """Height in mm that all of a move goes down to; below everything where it is not stated."""
    return np.nan_to_num(np.fmax(toolpath.start[:, 2], toolpath.end[:, 2]), nan=-np.inf)


def _near(toolpath: Toolpath, rows: Ints, moved: Ints, reach: float) -> Bools:
    """Which moves come within reach of moved ones, at least; by cells, so that a long program costs nothing."""
    which, share = _shares(np.ceil(2 * length_in_plane(toolpath.take(moved)) / reach).astype(np.int64) + 1)
    middle = toolpath.place(rows, np.full(len(rows), 0.5))
    out: Bools = _in_cells(middle, toolpath.place(moved[which], share), reach)
    return out | (length_in_plane(toolpath.take(rows)) > reach)


def _in_cells(places: Floats, marks: Floats, size: float) -> Bools:
    """Places that lie in the cell of a mark or in one beside it or beside that."""
    cells = np.unique(np.floor(marks / size).astype(np.int64), axis=0)
    steps = np.stack(np.meshgrid(np.arange(-2, 3), np.arange(-2, 3)), axis=-1).reshape(-1, 2)
    key = np.array([1 << 31, 1])
    out: Bools = np.isin(np.floor(places / size).astype(np.int64) @ key, (cells[:, None] + steps).reshape(-1, 2) @ key)
    return out


def _shares(count: Ints) -> tuple[Ints, Floats]:
    """Index of a move and fraction of it, for so many places evenly taken on every move."""
    which = np.repeat(np.arange(len(count)), count)
    return which, (np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count) + 0.5) / count[which]


def _outer_length(surface: CommandedSurface, rows: Ints) -> Floats:
    """Length in mm of the longer side of what moves cut."""
    toolpath = surface.toolpath
    turned = np.abs(np.nan_to_num(toolpath.sweep[rows]))
    out: Floats = length_in_plane(toolpath.take(rows)) + surface.radius[rows] * turned
    return out


def _outline(surface: CommandedSurface, rows: Ints, step: float) -> Floats:
    """Places round what moves cut, and some within it, no farther from each other than a step, mm."""
    toolpath, radius = surface.toolpath, surface.radius[rows]
    which, share = _shares(np.ceil(_outer_length(surface, rows) / step).astype(np.int64))
    centre, ahead = toolpath.place(rows[which], share), toolpath.direction(rows[which], share)
    across = radius[which, None] * np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    out = [centre + across, centre - across]
    # About its ends, and where it turns, the cutter leaves a round.
    zero, one = np.zeros(len(rows)), np.ones(len(rows))
    leaves, comes = toolpath.direction(rows, one)[:-1], toolpath.direction(rows, zero)[1:]
    straight = (np.diff(rows) == 1) & ((leaves * comes).sum(axis=1) > np.cos(step / (4 * radius[1:])))
    for ends, own in (
        (toolpath.end[rows[np.append(~straight, True)], :2], radius[np.append(~straight, True)]),
        (toolpath.start[rows[np.append(True, ~straight)], :2], radius[np.append(True, ~straight)]),
    ):
        which, share = _shares(np.ceil(2 * np.pi * own / step).astype(np.int64))
        turn = 2 * np.pi * share
        out.append(ends[which] + own[which, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1))
    return np.concatenate(out)


def _sides(surface: CommandedSurface, rows: Ints, tolerance: float) -> tuple[Ints, Floats, Floats]:
    """Places on both sides of moves where their cutter ends, so close that no cut between them is deeper than it shows.

    Returns the move, the place in mm, and the unit normal that points to the cutter.
    """
    radius, length = surface.radius[rows], _outer_length(surface, rows)
    # Between two places s apart a disc goes in deeper by s^2 / 8r at most.
    which, share = _shares(np.ceil(length / np.sqrt(4 * radius * tolerance)).astype(np.int64))
    row = rows[which]
    ahead, centre = surface.toolpath.direction(row, share), surface.toolpath.place(row, share)
    normal = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    normal = np.concatenate([normal, -normal])
    place = np.concatenate([centre, centre]) - np.tile(radius[which], 2)[:, None] * normal
    return np.tile(row, 2), place, normal


def _depth(surface: CommandedSurface, rows: Ints, places: Floats) -> tuple[Floats, Ints]:
    """How deep places lie in what moves cut, mm, negative outside, and the move that cuts deepest."""
    depth, by = np.full(len(places), -np.inf), np.full(len(places), -1)
    own = surface.radius[rows]
    for radius in np.unique(own):
        distance, row, _ = PathDistance(surface.toolpath, rows[own == radius]).nearest(places)
        better = radius - distance > depth
        depth, by = np.where(better, radius - distance, depth), np.where(better, row, by)
    return depth, by
