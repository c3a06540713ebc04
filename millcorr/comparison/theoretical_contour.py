# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour that a program cuts with an ideal machine: the cutter's path offset by its radius.

The path around a convex corner of the part may be an arc or run to a sharp corner: both give the corner. At a
concave corner the two sides are continued to the corner of the drawing; the fillet of the cutter's radius that
stays in it is no deviation that a correction could remove. (petrakov-2018: path, equidistant, theoretical
contour.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import InputError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import CORNER_ANGLE, GAP, Contour, Profile
from millcorr.messages import mm, option, phrase, xy
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath
from millcorr.tolerances import EXACT

from .path_distance import PathDistance, chords_of_cubic

SAME_POINT = 2e-4
"""Path points closer than this, in mm, are the same vertex (programs round to 0.001 or finer)."""
TAB_SHARE = 0.25
"""Holding tabs take no more of a contour than this; what is run above the cut over a longer way is a way back."""
SAMPLED = 0.05
"""Whether a parallel is on the surface is asked at every such share of the radius."""
ON_THE_MOVE = 2e-3
"""A vertex this near, in mm, lies on a move: on a slope the ends of moves are rounded, down to 0.0001 inch."""


@dataclass(frozen=True, eq=False, slots=True)
class CutContour:
    """A contour cut by one row of moves.

    Parameters
    ----------
    contour : Contour
        What an ideal machine leaves, run with the material on the left.
    rows : (n,) int64
        Rows of the toolpath that cut it, in the order of the program.
    closed : bool
    path : Toolpath
        The moves that cut it, from where it begins to where it ends.
    aside : bool
        Cut on the way to a closed one or away from it: a lead, or a wall of its own where points lie on no other.
    """

    contour: Contour
    rows: Ints
    closed: bool
    path: Toolpath
    aside: bool = False


@dataclass(slots=True)
class _Piece:
    """A line, an arc or a cubic of the path while it is being offset; `low` and `high` trim it."""

    p0: Floats
    p1: Floats
    centre: Floats | None = None
    sweep: float = 0.0
    low: float = 0.0
    high: float = 1.0
    control: Floats | None = None
    """Inner Bezier points of a cubic, (2, 2); a cubic is neither offset nor trimmed."""

    @staticmethod
    def arc(p0: Floats, p1: Floats, centre: Floats, sweep: float) -> _Piece:
        """Arc that meets both its ends: a program's rounding leaves them at slightly different radii."""
        chord = p1 - p0
        size2 = float(chord @ chord)
        if size2 > 1e-18:
            centre = centre - chord * ((centre - (p0 + p1) / 2) @ chord / size2)
            a, b = p0 - centre, p1 - centre
            exact = float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))
            sweep = exact + 2 * np.pi * round((sweep - exact) / (2 * np.pi))
        return _Piece(p0, p1, centre, sweep)

    def reversed(self) -> _Piece:
        control = None if self.control is None else self.control[::-1]
        return _Piece(self.p1, self.p0, self.centre, -self.sweep, control=control)

    def at(self, u: float) -> tuple[Floats, Floats]:
        """Point and derivative at parameter u, continued outside 0..1."""
        if self.centre is None:
            d = self.p1 - self.p0
            return self.p0 + u * d, d
        x, y = self.p0 - self.centre
        c, s = np.cos(self.sweep * u), np.sin(self.sweep * u)
        arm = np.array([x * c - y * s, x * s + y * c])
        return self.centre + arm, self.sweep * np.array([-arm[1], arm[0]])

    def tangent(self, u: float) -> Floats:
        d = self.at(u)[1]
        out: Floats = d / np.hypot(d[0], d[1])
        return out

    def places(self, u: Floats) -> Floats:
        """Points at several parameters; (n, 2)."""
        if self.centre is None:
            return np.asarray(self.p0 + u[:, None] * (self.p1 - self.p0))
        x, y = self.p0 - self.centre
        c, s = np.cos(self.sweep * u), np.sin(self.sweep * u)
        return np.asarray(self.centre + np.stack([x * c - y * s, x * s + y * c], axis=1))

    def offset_left(self, distance: float) -> _Piece | None:
        """Parallel piece to the left; None where it shrinks to a point or turns inside out."""
        n0, n1 = _left(self.tangent(0.0)), _left(self.tangent(1.0))
        if self.centre is not None and self.sweep > 0 and np.hypot(*(self.p0 - self.centre)) - distance <= 2e-3:
            return None
        return _Piece(self.p0 + distance * n0, self.p1 + distance * n1, self.centre, self.sweep)

    def curve(self) -> NurbsCurve:
        if self.control is not None:
            poles = np.vstack([self.p0, self.control, self.p1])
            return NurbsCurve(3, poles, np.ones(4), np.array([0.0, 1.0]), np.array([4, 4]))
        a, b = self.at(self.low)[0], self.at(self.high)[0]
        if self.centre is None:
            return NurbsCurve.line(a, b)
        return NurbsCurve.arc(a, b, self.centre, self.sweep * (self.high - self.low))


def cutting_runs(toolpath: Toolpath) -> list[Ints]:
    """Rows of connected feed moves that travel in the XY plane, one array a run, in program order.

    A rapid, a move along Z alone, an arc out of the XY plane, an unknown position or a change of the control's
    radius compensation ends a run. A point stated twice does not.
    """
    progress.step()
    delta = toolpath.end - toolpath.start
    travels = (np.hypot(delta[:, 0], delta[:, 1]) > 1e-9) | (toolpath.sweep != 0)
    flat = (toolpath.kind != Kind.ARC) | (toolpath.plane == Plane.XY)
    known = np.isfinite(delta[:, :2]).all(axis=1)
    good = (toolpath.kind != Kind.RAPID) & travels & flat & known
    rows = np.flatnonzero(good)
    if not len(rows):
        return []
    same_height = (delta[:, 2] == 0) | np.isnan(toolpath.start[:, 2] + toolpath.end[:, 2])
    idle = (toolpath.kind != Kind.RAPID) & ~travels & known & same_height
    place = np.cumsum(~idle)
    breaks = (np.diff(place[rows]) != 1) | (np.diff(toolpath.compensation[rows]) != 0)
    return np.split(rows, np.flatnonzero(breaks) + 1)


def closed_loops(toolpath: Toolpath, run: Ints) -> list[tuple[int, int]]:
    """Closed loops among connected moves: first and past-the-last position in `run`, in order.

    The innermost are taken, so that a lead that starts where another ends is no part of them, and a path that
    only goes out and back is none.
    """
    points = np.vstack([toolpath.start[run[:1], :2], toolpath.end[run, :2]])
    name = _vertices(points)
    order = np.lexsort((np.arange(len(name)), name))
    same = name[order[1:]] == name[order[:-1]]
    first, last = order[:-1][same], order[1:][same]
    ring = toolpath.take(run).position(np.array([0.0, 0.25, 0.5, 0.75]))[:, :, :2].reshape(-1, 2)
    ring = np.vstack([ring, points[-1:]]) - points.mean(axis=0)
    swept = np.cumsum(ring[:-1, 0] * ring[1:, 1] - ring[:-1, 1] * ring[1:, 0])
    swept = np.concatenate([[0.0], swept[3::4]])
    area = (swept[last] - swept[first]) / 2
    shortest = np.lexsort((first, last - first))
    shortest = shortest[np.abs(area[shortest]) > 1e-6]
    taken = np.zeros(len(run), dtype=bool)
    loops = []
    for a, b in zip(first[shortest].tolist(), last[shortest].tolist(), strict=True):
        if not taken[a:b].any():
            taken[a:b] = True
            loops.append((a, b))
    return sorted(loops)


def _vertices(points: Floats) -> Ints:
    """Number of each point's vertex; points closer than `SAME_POINT` share one."""
    progress.step()
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    # Passes repeat their points exactly: only different points are compared.
    different, number = np.unique(points, axis=0, return_inverse=True)
    near = cKDTree(different).query_pairs(SAME_POINT, output_type="ndarray")
    graph = coo_matrix((np.ones(len(near)), (near[:, 0], near[:, 1])), shape=(len(different),) * 2)
    vertex: Ints = connected_components(graph, directed=False)[1][number.ravel()].astype(np.int64)
    return vertex


def cut_contours(
    toolpath: Toolpath,
    radius: float,
    material_right: bool | Bools,
    rows: Bools | None = None,
    *,
    resolution: float = 0.0,
) -> Iterator[CutContour]:
    """Contours that the feed moves of a program leave.

    Parameters
    ----------
    toolpath : Toolpath
    radius : float
        Distance in mm between the programmed path and the contour: the tool radius, or 0 where the contour
        itself is programmed (G41, G42).
    material_right : bool or (n,) bool
        True where the material lies to the right of the direction of travel: of all moves, or of each, the same
        throughout a run.
    rows : (n,) bool, optional
        Moves that may be used; all by default.
    resolution : float
        What the program's coordinates are rounded to, mm: lines that differ from a longer one by no more are drawn as
        that one. Facets of a hundredth of a millimetre have no direction of their own otherwise.

    Yields
    ------
    CutContour
        Closed loops first found first, and aside what the same moves cut before, between and after them; a run without
        a loop as one open contour.

    Raises
    ------
    InputError
        If the path leaves nothing of a contour, or what it leaves does not hang together.
    """
    parts: list[Ints] = []
    right = np.broadcast_to(material_right, len(toolpath))
    for run in cutting_runs(toolpath):
        usable = np.ones(len(run), dtype=bool) if rows is None else rows[run]
        stretches = np.split(np.arange(len(run)), np.flatnonzero(np.diff(usable.astype(int))) + 1)
        parts += [run[stretch] for stretch in stretches if usable[stretch[0]]]
    for chain in _joined_on_the_spot(toolpath, parts):
        together = np.concatenate(chain)
        closed = all(closed_loops(toolpath, part) for part in chain)
        if not closed and _over_tabs(toolpath, chain) and closed_loops(toolpath, together):
            # The cutter rises on the spot: the stretches between the tabs are closed only together.
            chain = [together]
        for part in chain:
            yield from _contours_of_run(toolpath, part, radius, bool(right[part[0]]), resolution)


def _over_tabs(toolpath: Toolpath, chain: list[Ints]) -> bool:
    """Whether runs at several heights are one pass with holding tabs, and not one with a way back above the part."""
    if len(chain) == 1:
        return False
    height = np.array([toolpath.end[run[-1], 2] for run in chain])
    length = np.array([np.nan_to_num(toolpath.take(run).length()).sum() for run in chain])
    return bool(length[height > height.min() + 1e-6].sum() <= TAB_SHARE * length.sum())


def _joined_on_the_spot(toolpath: Toolpath, runs: list[Ints]) -> list[list[Ints]]:
    """Runs between which the cutter only rises or plunges at feed, with the compensation in force, listed together."""
    delta = toolpath.end[:, :2] - toolpath.start[:, :2]
    still = (toolpath.kind == Kind.LINE) & (np.abs(np.nan_to_num(delta, nan=1.0)) < 1e-9).all(axis=1)
    moving = np.cumsum(~still)
    chains: list[list[Ints]] = []
    for run in runs:
        before = chains[-1][-1][-1] if chains else 0
        same = toolpath.compensation[before] == toolpath.compensation[run[0]]
        if chains and same and run[0] > before + 1 and moving[run[0]] == moving[before] + 1:
            chains[-1].append(run)
        else:
            chains.append([run])
    return chains


def _contours_of_run(
    toolpath: Toolpath, run: Ints, radius: float, material_right: bool, resolution: float
) -> Iterator[CutContour]:
    moves, origin = toolpath.take(run), run
    loops = closed_loops(moves, np.arange(len(moves)))
    if not loops:
        # A path that starts within an edge and ends some way beyond that point has no vertex twice.
        meetings = [moves.start[:, :2], moves.end[-1:, :2]]
        if radius:
            # Nor has one that runs past its first corner at both ends, as the cutter may and the contour may not.
            meetings.append(_crossings(moves))
        moves, row = cut_at_vertices(moves, np.vstack(meetings))
        origin = run[row]
        loops = closed_loops(moves, np.arange(len(moves)))
    nothing: list[InputError] = []
    for a, b in loops:
        try:
            found = _offset(moves, np.arange(a, b), radius, material_right, True, resolution)
        except InputError as error:
            # Where a lead crosses the contour it makes a loop that leaves nothing on the contour's side.
            nothing.append(error)
            continue
        yield replace(found, rows=np.unique(origin[a:b]))
    if loops and len(nothing) == len(loops):
        raise nothing[0]
    # The control moves onto the contour during the first compensated move.
    first = int(toolpath.compensation[run[0]] != Compensation.OFF and len(run) > 1)
    if not loops:
        yield _offset(toolpath, run[first:], radius, material_right, False, resolution)
        return
    ends = [first, *(end for loop in loops for end in loop), len(moves)]
    for a, b in zip(ends[::2], ends[1::2], strict=True):
        if np.nan_to_num(moves.take(np.arange(a, b)).length()).sum() > radius:
            try:
                found = _offset(moves, np.arange(a, b), radius, material_right, False, resolution)
            except InputError:
                # A lead need not leave a wall.
                continue
            yield replace(found, rows=np.unique(origin[a:b]), aside=True)


def _crossings(moves: Toolpath) -> Floats:
    """Points where lines that do not follow each other cross; (n, 2)."""
    from shapely import STRtree, linestrings

    lines = np.flatnonzero(moves.kind == Kind.LINE)
    a, b = moves.start[lines, :2], moves.end[lines, :2]
    drawn = linestrings(np.stack([a, b], axis=1))
    i, j = STRtree(drawn).query(drawn, predicate="crosses")
    i, j = i[i < j], j[i < j]
    u, v, gap = (b - a)[i], (b - a)[j], (a[j] - a[i])
    share = _cross(gap, v) / np.where(_cross(u, v) == 0, np.inf, _cross(u, v))
    out: Floats = a[i] + share[:, None] * u
    return out


def cut_at_vertices(moves: Toolpath, vertices: Floats) -> tuple[Toolpath, Ints]:
    """Lines and arcs in the XY plane, each cut where one of the vertices lies on it.

    Parameters
    ----------
    moves : Toolpath
    vertices : (n, 2) float64
        Points in mm; on a move are those nearer than `ON_THE_MOVE`, except at its ends.

    Returns
    -------
    Toolpath
    row : (m,) int64
        The move that each part comes from.
    """
    from shapely import STRtree, box, points

    vertex = np.unique(vertices, axis=0)
    arc = moves.kind == Kind.ARC
    arm = moves.start[:, :2] - moves.centre[:, :2]
    r = np.where(arc, np.hypot(*arm.T), 0.0)
    samples = moves.position(np.linspace(0.0, 1.0, 9))[:, :, :2]
    # Between nine points of a full turn the circle reaches 0.08 of its radius beyond their chords.
    reach = (0.1 * r + ON_THE_MOVE)[:, None]
    boxes = box(*(samples.min(axis=1) - reach).T, *(samples.max(axis=1) + reach).T)
    which, row = STRtree(boxes).query(points(vertex))
    at, along = vertex[which] - moves.start[row, :2], (moves.end - moves.start)[row, :2]
    size = np.maximum(np.hypot(*along.T), 1e-12)
    off = np.abs(_cross(along, at)) / size
    u = (at * along).sum(axis=1) / size**2
    spoke = vertex[which] - moves.centre[row, :2]
    turn = np.sign(moves.sweep[row]) * np.arctan2(_cross(arm[row], spoke), (arm[row] * spoke).sum(axis=1))
    off = np.where(arc[row], np.abs(np.hypot(*spoke.T) - r[row]), off)
    u = np.where(arc[row], np.mod(turn, 2 * np.pi) / np.where(arc, np.abs(moves.sweep), 1.0)[row], u)
    within = np.minimum(u, 1 - u) * np.where(arc[row], np.abs(moves.sweep[row]) * r[row], size)
    cut = np.flatnonzero((off < ON_THE_MOVE) & (within > ON_THE_MOVE) & (moves.kind[row] != Kind.CUBIC))
    row = np.concatenate([np.arange(len(moves)), row[cut]])
    u = np.concatenate([np.zeros(len(moves)), u[cut]])
    begin = np.vstack([moves.start[:, :2], vertex[which[cut]]])
    order = np.lexsort((u, row))
    row, u, begin = row[order], u[order], begin[order]
    last = np.append(row[1:] != row[:-1], True)
    finish = np.where(last[:, None], moves.end[row, :2], np.roll(begin, -1, axis=0))
    share = np.where(last, 1.0, np.roll(u, -1)) - u
    out = moves.take(row)
    start, end = out.start.copy(), out.end.copy()
    start[:, :2], end[:, :2] = begin, finish
    rise = end[:, 2] - start[:, 2]
    start[:, 2], end[:, 2] = start[:, 2] + rise * u, np.where(last, end[:, 2], start[:, 2] + rise * (u + share))
    return out.with_moves(start=start, end=end, sweep=out.sweep * share), row


def _cross(a: Floats, b: Floats) -> Floats:
    out: Floats = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return out


def _offset(
    toolpath: Toolpath, rows: Ints, radius: float, material_right: bool, closed: bool, resolution: float = 0.0
) -> CutContour:
    pieces = _pieces(toolpath, rows, radius, resolution)
    if material_right:
        pieces = [p.reversed() for p in reversed(pieces)]
    if radius == 0:
        return CutContour(Contour(_merge(pieces), closed), rows, closed, toolpath.take(rows))
    return CutContour(Contour(_merge(_trimmed(pieces, radius, closed)), closed), rows, closed, toolpath.take(rows))


def _pieces(toolpath: Toolpath, rows: Ints, radius: float, resolution: float) -> list[_Piece]:
    """Moves as pieces; rows of lines with the fewest vertices that the program's rounding leaves certain."""
    out: list[_Piece] = []
    chain: list[Floats] = []

    def flush() -> None:
        if chain:
            line = _simplified(np.concatenate(chain), resolution)
            out.extend(_Piece(a, b) for a, b in zip(line[:-1], line[1:], strict=True))
            chain.clear()

    kinds = toolpath.kind[rows]
    edges = np.flatnonzero(np.diff(kinds)) + 1
    for group in np.split(rows, edges):
        progress.step()
        kind = int(toolpath.kind[group[0]])
        if kind == Kind.ARC or (kind == Kind.CUBIC and radius == 0):
            flush()
            for i in group:
                start, end = toolpath.start[i, :2], toolpath.end[i, :2]
                if kind == Kind.ARC:
                    out.append(_Piece.arc(start, end, toolpath.centre[i, :2], float(toolpath.sweep[i])))
                else:
                    out.append(_Piece(start, end, control=toolpath.control[i].reshape(2, 2)))
        elif kind == Kind.CUBIC:
            # The parallel of a spline is none: chords whose error does not matter stand for it.
            for i in group:
                t = np.linspace(0.0, 1.0, chords_of_cubic(toolpath, int(i)) + 1)
                chain.append(toolpath.take(np.array([i])).position(t)[0, :, :2])
        else:
            chain.append(np.vstack([toolpath.start[group[:1], :2], toolpath.end[group, :2]]))
    flush()
    return out


def _simplified(points: Floats, resolution: float) -> Floats:
    """A row of points without those that a straight line replaces within the resolution; (m, 2)."""
    import shapely

    apart = np.concatenate([[True], np.abs(np.diff(points, axis=0)).max(axis=1) > 0])
    points = points[apart]
    if len(points) < 3 or resolution <= 0:
        return points
    line = shapely.simplify(shapely.linestrings(points), resolution, preserve_topology=False)
    out: Floats = shapely.get_coordinates(line)
    return out


def _trimmed(pieces: list[_Piece], radius: float, closed: bool) -> list[_Piece]:
    """What the cutter's disc leaves on the left of a path: offset pieces, cut where others come nearer.

    A place of an offset piece is on the surface where no part of the path is nearer to it than the radius: so
    pieces that vanish, overlap or lie behind others need no rules of their own. Neighbours are continued to their
    intersection, at concave corners too.
    """
    pieces = _continued(pieces, closed)
    offset = [p.offset_left(radius) for p in pieces]
    runs = _on_the_surface(pieces, offset, radius)
    if not runs:
        raise InputError(
            phrase(
                "the path only circles points at the tool radius {}, or turns tighter than it everywhere: "
                "there is no contour; check {} and {}",
                mm(radius, "g"),
                option("tool_diameter"),
                option("side"),
            ),
        )
    # A piece whose two intersections have changed places is a sliver between samples: it vanishes, too.
    while True:
        progress.step()
        out = _joined(pieces, offset, runs, radius, closed)
        lost = [n for n, (_, part) in enumerate(out) if part is not None and _extent(part) < -1e-6]
        if not lost or len(lost) == len(runs):
            break
        number = [n for n, (of_run, _) in enumerate(out) if of_run]
        gone = {number.index(n) for n in lost if n in number}
        if not gone:
            break
        runs = [run for n, run in enumerate(runs) if n not in gone]
    return [part for _, part in out if part is not None and _extent(part) > 1e-6]


def _extent(piece: _Piece) -> float:
    """Length in mm of a trimmed piece; negative where its ends have changed places."""
    return float((piece.high - piece.low) * np.hypot(*piece.at(0.5)[1]))


def _on_the_surface(pieces: list[_Piece], offset: list[_Piece | None], radius: float) -> list[tuple[int, float, float]]:
    """Pieces of which something is left, in the path's order: number, and the parameters of what is first and last."""
    number, share = [], []
    for i, one in enumerate(offset):
        if one is None:
            continue
        length = float(np.hypot(*one.at(0.5)[1]))
        count = int(np.clip(np.ceil(length / (SAMPLED * radius)), 3, 400))
        inset = min(0.05, 1e-3 / max(length, 1e-9))
        share.append(np.concatenate([[inset], (np.arange(count) + 0.5) / count, [1.0 - inset]]))
        number.append(np.full(count + 2, i, dtype=np.int64))
    if not number:
        return []
    which, u = np.concatenate(number), np.concatenate(share)
    places = np.empty((len(u), 2))
    for begin, end in _groups(which):
        one = offset[which[begin]]
        assert one is not None
        places[begin:end] = one.places(u[begin:end])
    good = np.flatnonzero(_distance_to(pieces, places) >= radius - EXACT)
    return [(int(which[good[a]]), float(u[good[a]]), float(u[good[b - 1]])) for a, b in _groups(which[good])]


def _groups(number: Ints) -> list[tuple[int, int]]:
    """First and past-the-last position of every row of equal numbers."""
    edges = np.flatnonzero(np.diff(number)) + 1
    bounds = [0, *edges.tolist(), len(number)]
    return list(zip(bounds[:-1], bounds[1:], strict=True)) if len(number) else []


def _distance_to(pieces: list[_Piece], points: Floats) -> Floats:
    """Distance in mm of points from the nearest piece of a path; (n,)."""
    n = len(pieces)
    flat = np.zeros((n, 1))
    arcs = np.array([p.centre is not None for p in pieces])
    centre = np.array([(np.nan, np.nan) if p.centre is None else p.centre for p in pieces])
    path = Toolpath(
        kind=np.where(arcs, int(Kind.ARC), int(Kind.LINE)).astype(np.int64),
        start=np.hstack([np.array([p.p0 for p in pieces]), flat]),
        end=np.hstack([np.array([p.p1 for p in pieces]), flat]),
        centre=np.hstack([centre, flat]),
        sweep=np.array([p.sweep for p in pieces], dtype=np.float64),
        control=np.full((n, 4), np.nan),
        plane=np.full(n, int(Plane.XY)),
        feed=np.full(n, np.nan),
        source=np.zeros(n, dtype=np.int64),
        compensation=np.zeros(n, dtype=np.int64),
        tool=np.zeros(n, dtype=np.int64),
    )
    return PathDistance(path, np.arange(n))(points)


def _joined(
    pieces: list[_Piece], offset: list[_Piece | None], runs: list[tuple[int, float, float]], radius: float, closed: bool
) -> list[tuple[bool, _Piece | None]]:
    """Trimmed pieces of the runs, and fillets between them; each with whether it is a run of its own."""
    out: list[tuple[bool, _Piece | None]] = []
    parts: list[_Piece] = []
    for i, low, high in runs:
        one = offset[i]
        assert one is not None
        parts.append(_with_ends(one, low, high))
    for n, (a, (i, _, _)) in enumerate(zip(parts, runs, strict=True)):
        out.append((True, a))
        last = n + 1 == len(parts)
        if last and (not closed or len(parts) == 1):
            break
        b, j = parts[(n + 1) % len(parts)], runs[(n + 1) % len(parts)][0]
        if i == j:
            continue
        adjacent = j == (i + 1) % len(pieces)
        ta, tb = a.tangent(1.0), b.tangent(0.0)
        turn = _turn_at_vertex(ta, tb) if adjacent else _turn(ta, tb)
        if adjacent and abs(turn) < 1e-7:
            continue
        if not adjacent and (between := _hidden_sides(pieces, offset, (a, b), (i, j), radius)):
            out += [(False, one) for one in between]
            continue
        gap = _gap(a, b)
        # A convex corner is cut back however far the path ran past it; a concave one is continued so far only.
        reach = 4 * radius if turn < 0 else np.inf
        if (adjacent or gap > 1e-9) and not _trim_to_each_other(a, b, reach) and gap >= GAP / 2:
            if adjacent and turn < 0:
                # The sides never meet (the path turns back): what the cutter leaves is a fillet of its radius.
                out.append((False, _fillet(pieces, i, radius)))
                continue
            bridge = _Piece(a.at(a.high)[0], b.at(b.low)[0])
            if (
                gap < radius
                and max(abs(_turn(ta, bridge.tangent(0.5))), abs(_turn(bridge.tangent(0.5), tb))) < CORNER_ANGLE
            ):
                # Facets whose rounded ends make them parallel never meet: what vanished between them is as straight.
                out.append((False, bridge))
                continue
            _refuse_gap(a)
    return out


def _gap(a: _Piece, b: _Piece) -> float:
    """Distance in mm between the end of one piece and the beginning of another."""
    return float(np.hypot(*(b.at(b.low)[0] - a.at(a.high)[0])))


def _refuse_gap(a: _Piece) -> NoReturn:
    x, y = a.at(a.high)[0]
    raise InputError(
        phrase(
            "the offset path does not close near {}: check {} and {}, or give the contour with {}",
            xy(x, y),
            option("tool_diameter"),
            option("side"),
            option("nominal"),
        ),
    )


def _fillet(pieces: list[_Piece], i: int, radius: float) -> _Piece:
    """What the disc at the end of a piece leaves on the left of a turn to the right."""
    before, after = pieces[i], pieces[(i + 1) % len(pieces)]
    ta, tb = before.tangent(1.0), after.tangent(0.0)
    vertex = before.p1
    return _Piece(vertex + radius * _left(ta), vertex + radius * _left(tb), vertex, _turn_at_vertex(ta, tb))


def _hidden_sides(
    pieces: list[_Piece],
    offset: list[_Piece | None],
    ends: tuple[_Piece, _Piece],
    numbers: tuple[int, int],
    radius: float,
) -> list[_Piece]:
    """Sides of which only the fillets beside them are left, as of a step lower than the cutter's radius.

    The drawing has them: they are continued to the corners as others are, and both ends cut to them. Where they do not
    meet, the fillets stand for them. None, and nothing is cut, where no fillet is on the surface between both ends.
    """
    i, j = numbers
    between = [k % len(pieces) for k in range(i, j if j > i else j + len(pieces))]
    fillets = [_fillet(pieces, k, radius) for k in between]
    turning = [fillet if fillet.sweep < -1e-7 else None for fillet in fillets]
    seen = _on_the_surface(pieces, turning, radius)
    # What shows of less than a corner is facets' rounding.
    left = [(k, low, high) for k, low, high in seen if (low - high) * fillets[k].sweep > CORNER_ANGLE]
    beside = {between[k] for k, _, _ in left} | {(between[k] + 1) % len(pieces) for k, _, _ in left}
    sides = [offset[k] for k in between[1:] if k in beside]
    whole = [replace(side) for side in sides if side is not None]
    chains = [whole] if len(whole) == len(sides) else []
    chains.append([_with_ends(fillets[k], low, high) for k, low, high in left])
    for chain in chains:
        a, b = (replace(end) for end in ends)
        row = [a, *chain, b]
        meet = all(
            _gap(one, other) <= 1e-9 or _trim_to_each_other(one, other, np.inf)
            for one, other in zip(row[:-1], row[1:], strict=True)
        )
        if chain and meet and all(_extent(one) > 1e-6 for one in row):
            ends[0].high, ends[1].low = a.high, b.low
            return chain
    return []


def _with_ends(piece: _Piece, low: float, high: float) -> _Piece:
    """A piece between the first and the last sample of it that is on the surface; whole where these are its own."""
    return replace(piece, low=0.0 if low < 0.05 else low, high=1.0 if high > 0.95 else high)


def _turn(a: Floats, b: Floats) -> float:
    """Angle from one direction to another, rad, to the left positive."""
    return float(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))


def _turn_at_vertex(a: Floats, b: Floats) -> float:
    """The same where a path turns; straight back is to the right.

    There the cutter leaves a slot's round end; a fin without thickness it cannot.
    """
    turn = _turn(a, b)
    return turn - 2 * np.pi if turn > np.pi - 1e-6 else turn


def _continued(pieces: list[_Piece], closed: bool) -> list[_Piece]:
    """Join neighbours that continue the same line or circle, across the seam of a closed path too."""
    out: list[_Piece] = []
    for p in pieces:
        if np.hypot(*(p.p1 - p.p0)) < 1e-9 and not p.sweep:
            continue
        if out and _continues(out[-1], p):
            out[-1] = _Piece(out[-1].p0, p.p1, p.centre, out[-1].sweep + p.sweep)
        else:
            out.append(p)
    if closed and len(out) > 1 and _continues(out[-1], out[0]):
        out[0] = _Piece(out[-1].p0, out[0].p1, out[0].centre, out[-1].sweep + out[0].sweep)
        out.pop()
    return out


def _continues(a: _Piece, b: _Piece) -> bool:
    if (a.centre is None) != (b.centre is None):
        return False
    if a.centre is None or b.centre is None:
        u, v = a.p1 - a.p0, b.p1 - b.p0
        return bool(abs(u[0] * v[1] - u[1] * v[0]) < 1e-9 * np.hypot(*u) * np.hypot(*v) and u @ v > 0)
    return bool(np.hypot(*(a.centre - b.centre)) < 1e-7 and a.sweep * b.sweep > 0)


def _trim_to_each_other(a: _Piece, b: _Piece, reach: float) -> bool:
    """Cut or extend the end of `a` and the start of `b` to their intersection (Newton from where they are cut so far).

    Returns False, changing nothing, where they do not intersect within `reach` mm.
    """
    u, v = a.high, b.low
    for _ in range(60):
        pa, da = a.at(u)
        pb, db = b.at(v)
        gap = pa - pb
        if np.hypot(*gap) < 1e-12:
            break
        det = -da[0] * db[1] + da[1] * db[0]
        if abs(det) < 1e-9 * np.hypot(*da) * np.hypot(*db):
            break
        u -= (gap[0] * -db[1] + gap[1] * db[0]) / det
        v -= (da[0] * gap[1] - da[1] * gap[0]) / det
    far = max(abs(u - 1.0) * np.hypot(*a.at(1.0)[1]), abs(v) * np.hypot(*b.at(0.0)[1]))
    if far > reach or np.hypot(*(a.at(u)[0] - b.at(v)[0])) > 1e-6:
        return False
    a.high, b.low = u, v
    return True


def _merge(pieces: list[_Piece]) -> tuple[NurbsCurve, ...]:
    """Curves of the pieces; lines that turn by less than a corner become one polyline of degree 1."""
    curves: list[NurbsCurve] = []
    chain: list[Floats] = []

    def flush() -> None:
        if len(chain) > 1:
            n = len(chain)
            mult = np.ones(n, dtype=np.int64)
            mult[[0, -1]] = 2
            curves.append(NurbsCurve(1, np.array(chain), np.ones(n), np.arange(float(n)), mult))
        chain.clear()

    for p in pieces:
        if p.centre is not None or p.control is not None:
            flush()
            curves.append(p.curve())
            continue
        a, b = p.at(p.low)[0], p.at(p.high)[0]
        if np.hypot(*(b - a)) < 1e-9:
            continue
        if len(chain) > 1:
            if abs(_turn(chain[-1] - chain[-2], b - a)) > CORNER_ANGLE:
                flush()
        if not chain:
            chain.append(a)
        chain.append(b)
    flush()
    return tuple(curves)


def path_profile(toolpath: Toolpath, rows: Ints, material_right: bool) -> Profile:
    """The programmed path itself as a profile, run with the material on the left.

    Parameters
    ----------
    toolpath : Toolpath
    rows : (n,) int64
        Connected moves.
    material_right : bool

    Returns
    -------
    Profile
        Distances to it, less the tool radius, are deviations from what the program commands.
    """
    ends_meet = np.hypot(*(toolpath.end[rows[-1], :2] - toolpath.start[rows[0], :2])) <= SAME_POINT
    return Profile.from_contours([_offset(toolpath, rows, 0.0, material_right, bool(ends_meet)).contour])


def _left(tangent: Floats) -> Floats:
    return np.array([-tangent[1], tangent[0]])
