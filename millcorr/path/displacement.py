# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a program displaced in place: where its own contour is the nominal, vertices and arcs move along normals.

What the program writes stays what it is: its facets, its arcs, its rounding. A place of the path moves by as much as
the surface that is wanted before it has moved, and by more where a disc could not follow that without cutting into
the surface beside it. Where the moved path is no longer a line or an arc within the tolerance, it is divided.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import is_corner
from millcorr.comparison.theoretical_contour import SAME_POINT, cutting_runs
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.curve_moves import Intervals, fit_moves
from millcorr.path.leads import carry_along, own_work
from millcorr.path.moves import BAND, FIT_SHARE, KEEP_SHARE, Regeneration, put_together, wanted_kind
from millcorr.path.path_following import length_in_plane
from millcorr.tolerances import EXACT

from .wanted_surface import WantedSurface, meeting

STEP = 0.3
"""The displacement is looked at every so many mm along the path at least: no correction has shorter waves."""

BENT, HALVINGS = 5e-5, 8
"""Between two places it is taken as straight where it is off that by no more than this, in mm; else halfway is looked
at, too: in inside corners a short way along the path is a long one on the surface."""

INSET = 1e-3
"""Beside a corner a side is looked at so far from it, in mm, that the other side has no part in it."""

SMOOTH = 0.2
"""Where the path turns less, in rad, its vertices move along one normal: facets of 0.01 mm chord error on a radius of
2 mm turn by so much."""

ALIGNED, ABOUT = 0.3, 1e-3
"""A place of the path makes a surface where its own normal and the way to the contour differ by less, in rad: at
facets, and at a corner. Past a convex corner the cutter touches nothing."""

PASSING = 0.01
"""Where a line passes a corner, its side is looked at so many mm before: farther than `ABOUT` of any cutter."""

ROUND = 0.05
"""A path that keeps its distance from a corner within so many mm goes about it: arcs that CAM systems fit are off by
less, and one that passes a corner on its tangent leaves it."""

STEPS_OVER = 0.01
"""Moves beside the contour whose distances from it differ by more, in mm, are of two passes: chords and rounding of one
differ by less."""

FEW_ROUNDS = 4
"""Steps after which a disc beside a corner rests on what it meets there, or something else is in the way."""


class DisplacedPath:
    """The moved path of following moves, as a function of the move and the fraction on it.

    Parameters
    ----------
    toolpath : Toolpath
    rows : (k,) int64
        Following moves, in order.
    shift : Floats
        Displacement at the nodes, (m, 2) mm.
    node_row, node_u : (m,)
        Index into `rows` and fraction of every node, increasing within a move, 0 and 1 included.
    """

    def __init__(self, toolpath: Toolpath, rows: Ints, node_row: Ints, node_u: Floats, shift: Floats) -> None:
        self.toolpath, self.rows = toolpath, rows
        self.length = np.maximum(length_in_plane(toolpath.take(rows)), 1e-9)
        self._key = 2.0 * node_row + node_u
        # Along and across the move: what is moved out evenly stays an arc about its centre.
        self._shift = _turned(shift, toolpath.direction(rows[node_row], node_u), -1.0)

    def at(self, piece: Ints, u: Floats) -> Floats:
        """Places of the moved path, (n, 2) mm, for indices into `rows` and fractions."""
        key, row = 2.0 * piece + u, self.rows[piece]
        moved = np.stack([np.interp(key, self._key, self._shift[:, k]) for k in (0, 1)], axis=1)
        out: Floats = self.toolpath.place(row, u) + _turned(moved, self.toolpath.direction(row, u), 1.0)
        return out

    def evaluate(self, piece: Ints, sigma: Floats) -> tuple[Floats, Floats, Floats]:
        """Points, normals to the right of travel, and speed, at lengths in mm along the moves as they were."""
        length = self.length[piece]
        u, h = sigma / length, 1e-5
        low, high = np.maximum(u - h, 0.0), np.minimum(u + h, 1.0)
        ahead = (self.at(piece, high) - self.at(piece, low)) / ((high - low) * length)[:, None]
        speed = np.maximum(np.hypot(*ahead.T), 1e-12)
        return self.at(piece, u), np.stack([ahead[:, 1], -ahead[:, 0]], axis=1) / speed[:, None], speed

    def bends(self, piece: Ints, sigma0: Floats, sigma1: Floats) -> tuple[Ints, Floats]:
        """Nodes between two lengths along moves: index into these, rising, and length, mm."""
        length = self.length[piece]
        first = np.searchsorted(self._key, 2.0 * piece + sigma0 / length, side="right")
        count = np.maximum(np.searchsorted(self._key, 2.0 * piece + sigma1 / length, side="left") - first, 0)
        owner = np.repeat(np.arange(len(piece)), count)
        node = np.arange(len(owner)) + np.repeat(first - (np.cumsum(count) - count), count)
        return owner, (self._key[node] - 2.0 * piece[owner]) * length[owner]


def _turns(path: DisplacedPath, given: Bools) -> tuple[Floats, Floats]:
    """By how much, in rad, the path turns at the starts and at the ends of its moves that others lead to; (n,) each."""
    out = np.zeros((2, len(given)))
    rows, toolpath = path.rows, path.toolpath
    beside = np.pad(given, 1)
    step = np.minimum(STEP / path.length, 1.0)
    for k, alone in ((0, ~beside[rows]), (1, ~beside[rows + 2])):
        piece = np.flatnonzero(alone)
        a, b = (np.zeros(len(piece)), step[piece]) if k == 0 else (1.0 - step[piece], np.ones(len(piece)))
        was = toolpath.place(rows[piece], b) - toolpath.place(rows[piece], a)
        out[k, rows[piece]] = _turn(was, path.at(piece, b) - path.at(piece, a))
    return out[0], out[1]


def _turned(vectors: Floats, ahead: Floats, way: float) -> Floats:
    """Vectors (n, 2) given along and to the left of directions, from these for way 1, or so given for way -1."""
    x, y = vectors.T
    c, s = ahead[:, 0], way * ahead[:, 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=1)


def displace(
    toolpath: Toolpath,
    following: Bools,
    before: WantedSurface | None,
    after: WantedSurface,
    nominal: Profile,
    radius: float,
    *,
    along: tuple[Bools, WantedSurface] | None = None,
    tolerance: float = 0.001,
    output_moves: str = "keep",
    original_error: float = 0.0,
    undivided: Bools | None = None,
) -> Regeneration:
    """Move the following moves of a toolpath by as much as the wanted surface has moved.

    Parameters
    ----------
    toolpath : Toolpath
    following : (n,) bool
        Moves that make the surface.
    before : WantedSurface or None
        What the toolpath makes, chords and rounding of its own apart, which stay; None: the path is laid on the exact
        parallel of `after`.
    after : WantedSurface
        What it is to make.
    nominal : Profile
        What both were moved from.
    radius : float
        Distance in mm from contour to path; 0 where the program states the contour itself (G41, G42).
    along : ((n,) bool, WantedSurface), optional
        Moves beside the contour that go along with it, so that what they leave over it stays, and what the toolpath
        makes; none by default.
    tolerance : float
        Largest distance in mm between written and exact path, rounding included.
    output_moves : {'keep', 'lines', 'arcs', 'nurbs'}
    original_error : float
        How far the moves are off what they follow so far, mm, for `Regeneration`.
    undivided : (n,) bool, optional
        Moves of which only the ends can be moved, as the control computes what is between them; none by default.

    Returns
    -------
    Regeneration

    Raises
    ------
    FitError
        If the moved path cannot be written within the tolerance.
    """
    order = np.concatenate(cutting_runs(toolpath)) if following.any() else np.zeros(0, dtype=np.int64)
    rows = order[following[order]]
    shift0, shift1 = np.zeros((len(toolpath), 2)), np.zeros((len(toolpath), 2))
    made = before if along is None else along[1]
    known = _nodes(toolpath, rows, nominal, before, after, radius, made)
    node_row, node_u = known.row, known.u
    if before is None:
        known = _where_it_should_be(known, len(rows), KEEP_SHARE * tolerance)
    shift = _at_the_ends(toolpath, rows, known, before, after, radius, made)
    if along is not None and along[0].any():
        passes = _displaced_passes(toolpath, order[along[0][order]], nominal, along[1], after, radius)
        rows, node_row, node_u, shift = _in_order(toolpath, [(rows, node_row, node_u, shift), *passes])
    shift[np.hypot(*shift.T) <= EXACT] = 0.0
    path = DisplacedPath(toolpath, rows, node_row, node_u, shift)
    moved = np.zeros(len(rows), dtype=bool)
    np.logical_or.at(moved, node_row, shift.any(axis=1))
    first, last = node_u == 0.0, node_u == 1.0
    shift0[rows], shift1[rows] = shift[first], shift[last]
    given = np.zeros(len(toolpath), dtype=bool)
    given[rows] = True
    carry_along(toolpath, given, own_work(toolpath, given), shift0, shift1, _turns(path, given))
    if undivided is not None:
        moved &= ~undivided[rows]
    pick = np.flatnonzero(moved)
    intervals = _intervals(toolpath, path, pick, output_moves)
    fitted, owner, fit_error = fit_moves(intervals, path, FIT_SHARE * tolerance)
    errors = original_error, fit_error
    return put_together(toolpath, following, rows[pick], fitted, owner, shift0, shift1, errors)


def _displaced_passes(
    toolpath: Toolpath, rows: Ints, nominal: Profile, before: WantedSurface, after: WantedSurface, radius: float
) -> list[tuple[Ints, Ints, Floats, Floats]]:
    """Rows and nodes, as of `DisplacedPath`, of each pass beside a contour, moved at its own distance from it."""
    share = np.tile([0.25, 0.5, 0.75], len(rows))
    feet = FootPointSearch(nominal, margin=radius + 2.0).find(toolpath.place(np.repeat(rows, 3), share))
    distance = np.median(np.abs(feet.distance).reshape(-1, 3), axis=1)
    ends = (np.diff(rows) > 1) | (np.abs(np.diff(distance)) > STEPS_OVER)
    out = []
    for part in np.split(np.arange(len(rows)), np.flatnonzero(ends) + 1):
        # Where the program states the contour, the control keeps the distance.
        own = 0.0 if radius == 0 else float(np.median(distance[part]))
        known = _nodes(toolpath, rows[part], nominal, before, after, own, before)
        shift = _at_the_ends(toolpath, rows[part], known, before, after, own, before)
        out.append((rows[part], known.row, known.u, shift))
    return out


def _in_order(toolpath: Toolpath, parts: list[tuple[Ints, Ints, Floats, Floats]]) -> tuple[Ints, Ints, Floats, Floats]:
    """Rows and nodes of several paths in the program's order; where two meet the first of the list decides."""
    count = [len(part[0]) for part in parts]
    first_row = np.cumsum([0, *count[:-1]])
    rows, node_u, shift = (np.concatenate([part[k] for part in parts]) for k in (0, 2, 3))
    node_row = np.concatenate([part[1] + k for part, k in zip(parts, first_row, strict=True)])
    order = np.argsort(rows, kind="stable")
    rank = np.empty(len(rows), dtype=np.int64)
    rank[order] = np.arange(len(rows))
    path = np.repeat(np.arange(len(parts)), count)[order]
    by_row = np.argsort(rank[node_row], kind="stable")
    rows, node_row, node_u, shift = rows[order], rank[node_row][by_row], node_u[by_row], shift[by_row]
    begin, end = np.flatnonzero(node_u == 0.0), np.flatnonzero(node_u == 1.0)
    this, after = _vertices(toolpath, rows)
    earlier, later = path[this] < path[after], path[this] > path[after]
    shift[begin[after[earlier]]] = shift[end[this[earlier]]]
    shift[end[this[later]]] = shift[begin[after[later]]]
    return rows, node_row, node_u, shift


@dataclass(frozen=True, eq=False, slots=True)
class _Nodes:
    """Where on every move the displacement is known.

    Index of the move, fraction, direction and amount in mm of the displacement, what its own place on the contour alone
    asks for, in mm, the normal of the move, whether it touches the contour there, and whether that is a corner.
    """

    row: Ints
    u: Floats
    way: Floats
    amount: Floats
    own: Floats
    normal: Floats
    touching: Bools
    corner: Bools

    @property
    def local(self) -> Floats:
        """Displacement across and along the move, (n, 2) mm."""
        return _turned(self.amount[:, None] * self.way, self.normal, -1.0)

    def take(self, index: Ints) -> _Nodes:
        return _Nodes(*(getattr(self, name)[index] for name in _Nodes.__slots__))

    def put(self, index: Ints, other: _Nodes) -> _Nodes:
        out = {name: getattr(self, name).copy() for name in _Nodes.__slots__}
        for name, values in out.items():
            values[index] = getattr(other, name)
        return _Nodes(**out)

    def with_more(self, other: _Nodes) -> _Nodes:
        return _Nodes(*(np.concatenate([getattr(self, name), getattr(other, name)]) for name in _Nodes.__slots__))


def _nodes(
    toolpath: Toolpath,
    rows: Ints,
    nominal: Profile,
    before: WantedSurface | None,
    after: WantedSurface,
    radius: float,
    made: WantedSurface | None,
) -> _Nodes:
    """Nodes at the ends of every move, just inside them, and as close between as the displacement bends."""
    feet = FootPointSearch(nominal, margin=radius + 2.0)
    side = np.zeros(len(rows))

    # A move makes the wall at the height that it has come down to.
    z = np.fmax(*_heights_of(toolpath, rows))
    least = np.full(len(rows), np.cos(ALIGNED))

    def at(row: Ints, u: Floats) -> _Nodes:
        nonlocal side
        place = np.column_stack([toolpath.place(rows[row], u), z[row]])
        way, amount, own, corner = _along_normals(place, feet, before, after, nominal, radius)
        ahead = toolpath.direction(rows[row], u)
        right = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
        across = (right * way).sum(axis=1)
        if not side.all():
            # A way to and fro has the material on either side.
            side = np.where(np.bincount(row, across, minlength=len(rows)) >= 0, 1.0, -1.0)
        across *= side[row]
        line = toolpath.kind[rows[row]] != Kind.ARC
        # Past where a side ends now a line runs straight on.
        amount = np.where(line & ~corner, np.maximum(amount, own), amount)
        passing = np.flatnonzero(corner & line & (least[row] > np.cos(ALIGNED)) & (across >= np.cos(ABOUT)))
        if radius > 0:
            for step in (-PASSING, PASSING):
                # Where the side ends it asks for what it does just before, whatever the other one does.
                inside = place[passing] + step * np.pad(ahead[passing], ((0, 0), (0, 1)))
                _, _, of_side, still = _along_normals(inside, feet, before, after, nominal, radius)
                amount[passing[~still]] = own[passing[~still]] = of_side[~still]
        touching = across >= np.where(corner, least[row], np.cos(ALIGNED))
        if made is not None and radius > 0:
            # A move past a corner, as a ramp from pass to pass across it, may be square to the way there by chance.
            past = np.flatnonzero(corner & touching)
            touching[past] = made.distance(place[past]) < radius + BAND
        found = _Nodes(row, u, way, amount, own, side[row, None] * right, touching, corner)
        return _out_of_the_way(found, place, after, radius)

    length = np.maximum(length_in_plane(toolpath.take(rows)), 1e-9)
    count = np.maximum(2, np.ceil(length / STEP).astype(np.int64))
    # 0, inset, inner nodes, 1 - inset, 1.
    total = count + 3
    row = np.repeat(np.arange(len(rows)), total)
    number = np.arange(len(row)) - np.repeat(np.cumsum(total) - total, total)
    inset = np.minimum(INSET / length, 0.1)[row]
    u = (number - 1) / count[row]
    u = np.where(number == 0, 0.0, np.where(number == 1, inset, u))
    u = np.where(number == total[row] - 1, 1.0, np.where(number == total[row] - 2, 1.0 - inset, u))
    found = at(row, u)
    least = _about_a_corner(toolpath, rows, z, found, feet, made)
    again = np.flatnonzero(found.corner)
    found = found.put(again, at(row[again], u[again]))
    left = np.flatnonzero((found.row[1:] == found.row[:-1]) & (number[:-1] > 0) & (number[1:] < total[row[1:]] - 1))
    a, b = found.take(left), found.take(left + 1)
    for _ in range(HALVINGS):
        progress.step()
        middle = at(a.row, (a.u + b.u) / 2)
        off = np.hypot(*(middle.local - (a.local + b.local) / 2).T)
        seen = a.touching | middle.touching | b.touching
        bent = np.flatnonzero(seen & (off > BENT) & ((b.u - a.u) * length[a.row] > 4 * INSET))
        if not len(bent):
            break
        middle, a, b = middle.take(bent), a.take(bent), b.take(bent)
        found = found.with_more(middle)
        a, b = a.with_more(middle), middle.with_more(b)
    found = found.take(np.lexsort((found.u, found.row)))
    found = replace(found, corner=found.corner & found.touching)
    place = np.column_stack([toolpath.place(rows[found.row], found.u), z[found.row]])
    return _about_corners(found, place, feet, before, after, radius, made)


def _about_a_corner(
    toolpath: Toolpath, rows: Ints, z: Floats, found: _Nodes, search: FootPointSearch, made: WantedSurface | None
) -> Floats:
    """Cosine between a move's normal and the way to a corner from which on it touches that; (k,).

    A path that keeps its distance, in arcs or facets, goes about it; one that runs past it leaves it, and touches
    nothing but where the side ends.
    """
    out = np.full(len(rows), np.cos(ABOUT))
    nodes = np.flatnonzero(found.corner)
    if not len(nodes):
        return out
    row = found.row[nodes]
    place = toolpath.place(rows[row], found.u[nodes])
    corner = search.find(np.column_stack([place, z[row]])).foot
    other = np.hypot(*np.diff(corner, axis=0).T) > SAME_POINT
    begin = np.flatnonzero(np.concatenate([[True], (np.diff(nodes) > 1) | other]))
    end = np.append(begin[1:], len(nodes)) - 1
    if made is not None:
        corner = corner + made.corner_shift(corner)
    away = place - corner
    size = np.hypot(*away.T)
    spread = np.maximum.reduceat(size, begin) - np.minimum.reduceat(size, begin)
    # A line turns about nothing, however short it is.
    turned = np.abs(_turn(found.normal[nodes[begin]], found.normal[nodes[end]]))
    # Two lines that meet past a corner run by it, however little they turn: what goes about it has a move there alone.
    whole = _only_at_corners(found, len(rows))[row]
    about = (spread < ROUND) & (turned > 0.5 * np.abs(_turn(away[begin], away[end])))
    about &= np.logical_or.reduceat(whole, begin)
    every = np.ones(len(rows), dtype=bool)
    np.logical_and.at(every, row, np.repeat(about, end - begin + 1))
    out[every & (np.bincount(row, minlength=len(rows)) > 0)] = np.cos(ALIGNED)
    return out


def _along_normals(
    place: Floats,
    search: FootPointSearch,
    before: WantedSurface | None,
    after: WantedSurface,
    nominal: Profile,
    radius: float,
) -> tuple[Floats, Floats, Floats, Bools]:
    """Unit vectors from the contour to places (n, 3) of the path, how far the centre moves along them, and corners.

    Beside how far it moves: how far for its own place on the contour alone.
    """
    feet = search.find(place)
    corner = (feet.place == Place.JOINT) & is_corner(nominal, feet)
    stretch, s = nominal.stretch[feet.span], nominal.arc_length(feet.span, feet.t)
    off = feet.distance if before is None else _interpolated(before, stretch, s)
    own = _interpolated(after, stretch, s) - off
    if radius == 0:
        return feet.normal, own, own, corner
    away = place[:, :2] - feet.foot
    size = np.hypot(*away.T)
    way = np.where((size > 1e-9)[:, None], away / np.maximum(size, 1e-12)[:, None], feet.normal)
    guess = radius - size
    was = np.zeros(len(place)) if before is None else before.clearance(place, way, radius, guess)
    own = own if before is not None else radius + _interpolated(after, stretch, s) - size
    # Where its own place asks it to go it is clear also of what is beside it: from where it was that may be in the way.
    now = after.clearance(place, way, radius, own if before is None else was + own)
    return way, now - was, own, corner


def _out_of_the_way(found: _Nodes, place: Floats, after: WantedSurface, radius: float) -> _Nodes:
    """Nodes of which those that come clear nowhere along their normals go where a disc does that is moved out of all.

    Beside an inside corner the other side is in the way: the places there go to the new corner.
    """
    blocked = np.flatnonzero(np.isnan(found.amount))
    shift = after.outside(place[blocked], radius) - place[blocked, :2]
    size = np.hypot(*shift.T)
    way, amount = found.way.copy(), found.amount.copy()
    amount[blocked] = size
    some = blocked[size > 0]
    way[some] = shift[size > 0] / size[size > 0, None]
    return replace(found, way=way, amount=amount)


def _only_at_corners(found: _Nodes, count: int) -> Bools:
    """Moves of which all but their ends are nearest to a corner; (count,)."""
    inner = (found.u > 0) & (found.u < 1)
    total = np.bincount(found.row[inner], minlength=count)
    out: Bools = np.bincount(found.row[inner], found.corner[inner], minlength=count) > 0.9 * total
    return out


def _about_corners(
    found: _Nodes,
    place: Floats,
    search: FootPointSearch,
    before: WantedSurface | None,
    after: WantedSurface,
    radius: float,
    made: WantedSurface | None,
) -> _Nodes:
    """Nodes of which those on moves about a corner go with the corner, as far as nothing else is in their way."""
    count = int(found.row.max(initial=-1)) + 1
    rows = np.flatnonzero(_only_at_corners(found, count)[found.row])
    if radius == 0 or not len(rows):
        return replace(found, corner=np.zeros(len(found.u), dtype=bool))
    place = place[rows]
    foot = search.find(place).foot
    shift, room = after.corner_shift(foot), np.full(len(rows), radius)
    about = foot if made is None else foot + made.corner_shift(foot)
    away = place[:, :2] - about
    away /= np.maximum(np.hypot(*away.T), 1e-12)[:, None]
    if before is None:
        shift += foot - place[:, :2] + radius * away
    else:
        shift -= before.corner_shift(foot)
        room = before.distance(place)
    for _ in range(FEW_ROUNDS):
        progress.step()
        # Where a side turns with its correction, the disc meets it beside the corner.
        off = room - after.distance(np.column_stack([place[:, :2] + shift, place[:, 2]]))
        shift += off[:, None] * away
    size = np.hypot(*shift.T)
    blocked = np.bincount(found.row[rows], (np.abs(off) > BENT) | (size <= EXACT), minlength=count) > 0
    free = ~blocked[found.row[rows]]
    rows = rows[free]
    way, amount, corner = found.way.copy(), found.amount.copy(), np.zeros(len(found.u), dtype=bool)
    way[rows], amount[rows], corner[rows] = shift[free] / size[free, None], size[free], True
    return replace(found, way=way, amount=amount, corner=corner, touching=found.touching | corner)


def _where_it_should_be(known: _Nodes, count: int, allowed: float) -> _Nodes:
    """Nodes of moves that are all over within so many mm of where they should be: these stay."""
    largest = np.zeros(count)
    np.maximum.at(largest, known.row, np.abs(known.amount))
    return replace(known, amount=np.where(largest[known.row] <= allowed, 0.0, known.amount))


def _interpolated(surface: WantedSurface, stretch: Ints, s: Floats) -> Floats:
    """What a surface was moved by at places of the profile, mm."""
    out = np.zeros(len(s))
    for k in np.unique(stretch):
        mine, there = stretch == k, surface.stretch == k
        order = np.argsort(surface.s[there], kind="stable")
        out[mine] = np.interp(s[mine], surface.s[there][order], surface.moved[there][order])
    return out


def _at_the_ends(
    toolpath: Toolpath,
    rows: Ints,
    known: _Nodes,
    before: WantedSurface | None,
    after: WantedSurface,
    radius: float,
    made: WantedSurface | None,
) -> Floats:
    """Displacement at every node, (m, 2) mm: the same for both moves at a vertex, both sides kept at a corner."""
    node_row, node_u, normal = known.row, known.u, known.normal
    first = np.flatnonzero(node_u == 0.0)
    last = np.flatnonzero(node_u == 1.0)
    this, next_one = _vertices(toolpath, rows)
    turn = _turn(normal[last[this]], normal[first[next_one]])
    sharp = np.abs(turn) > SMOOTH
    amount = _held(node_row, node_u, known.amount, known.touching)
    _hand_on(amount, node_row, first, last, this[~sharp], next_one[~sharp])
    # A node that touches moves along its way to the contour, another along the move's own normal.
    shift = amount[:, None] * np.where(known.touching[:, None], known.way, normal)
    lost = np.isnan(amount)
    shift[lost] = 0.0

    # Just inside its ends a move knows nothing of the corner there; what the other side asks for is not its own.
    across = np.where(lost, np.nan, (shift * normal).sum(axis=1))
    across = np.fmin(across, _held(node_row, node_u, known.own, known.touching))
    side0, side1 = across[last - 1], across[first + 1]
    for a, b, is_sharp in ((this[sharp], next_one[sharp], True), (this[~sharp], next_one[~sharp], False)):
        end, begin = last[a], first[b]
        if is_sharp:
            c0, c1 = side0[a], side1[b]
            corner = meeting(normal[end], normal[begin], np.nan_to_num(c0), np.nan_to_num(c1))
            only0, only1 = np.isnan(c1) & ~np.isnan(c0), np.isnan(c0) & ~np.isnan(c1)
            corner[only0] = c0[only0, None] * normal[end[only0]]
            corner[only1] = c1[only1, None] * normal[begin[only1]]
            if radius == 0:
                # A side that the corner cuts off ends where it moves otherwise than at its end.
                place = toolpath.end[rows[a], :2]
                if made is not None:
                    now = after.corners_of(made, place)
                    was = place if before is None else made.corners_of(made, place)
                    corner = np.where(np.isnan(now), corner, now - was)
            else:
                # Where a side turns with its correction, a disc meets it sooner.
                place = np.column_stack([toolpath.end[rows[a], :2], np.fmax(*_heights_of(toolpath, rows[a]))])
                room = np.full(len(a), radius) if before is None else np.minimum(before.distance(place), radius)
                moved = place + np.pad(corner, ((0, 0), (0, 1)))
                known_there = ~(np.isnan(c0) & np.isnan(c1))
                corner[known_there] += (after.outside(moved, room) - moved[:, :2])[known_there]
        else:
            # Where one goes about a corner the other ends where that begins.
            first_counts = ~lost[end] & ~(known.corner[begin] & ~known.corner[end])
            corner = np.where(first_counts[:, None], shift[end], np.where(lost[begin, None], 0.0, shift[begin]))
        shift[end], shift[begin] = corner, corner
        for vertex, other in ((end, begin), (begin, end)):
            slides = np.full(len(vertex), is_sharp) | (known.corner[other] & ~known.corner[vertex])
            _run_up(shift, node_u, normal, vertex[slides], corner[slides])
        if is_sharp:
            _cut_off(shift, node_row, node_u, corner, (a, b), (this, next_one), toolpath, rows)
    joined = np.zeros((2, len(rows)), dtype=bool)
    joined[0, next_one], joined[1, this] = True, True
    return _floating(shift, node_u, lost, first, last, (joined[0], joined[1]))


def _heights_of(toolpath: Toolpath, rows: Ints) -> tuple[Floats, Floats]:
    return toolpath.start[rows, 2], toolpath.end[rows, 2]


def _held(node_row: Ints, node_u: Floats, amount: Floats, touching: Bools) -> Floats:
    """Amounts where a move touches the contour; elsewhere that of the nearest place on it that does, NaN without."""
    key = 4.0 * node_row + node_u
    have = np.flatnonzero(touching)
    if not len(have):
        return np.full(len(amount), np.nan)
    right = np.clip(np.searchsorted(key[have], key), 0, len(have) - 1)
    left = np.maximum(right - 1, 0)
    nearest = have[np.where(np.abs(key[have[left]] - key) <= np.abs(key[have[right]] - key), left, right)]
    out = amount[nearest]
    out[node_row[nearest] != node_row] = np.nan
    return np.where(touching, amount, out)


def _hand_on(amount: Floats, node_row: Ints, first: Ints, last: Ints, this: Ints, next_one: Ints) -> None:
    """What touches nothing moves as much as what it goes on from without a corner, as past a corner. In place."""
    while True:
        progress.step()
        here, there = np.isnan(amount[last[this]]), np.isnan(amount[first[next_one]])
        gives, takes = np.flatnonzero(~here & there), np.flatnonzero(here & ~there)
        if not len(gives) and not len(takes):
            return
        given = np.full(len(first), np.nan)
        given[next_one[gives]] = amount[last[this[gives]]]
        given[this[takes]] = amount[first[next_one[takes]]]
        amount[:] = np.where(np.isnan(amount), given[node_row], amount)


def _vertices(toolpath: Toolpath, rows: Ints) -> tuple[Ints, Ints]:
    """Pairs of following moves (indices into `rows`) of which the second begins where the first ends; seams too."""
    start, end = toolpath.start[rows, :2], toolpath.end[rows, :2]
    # The next pass may begin where this one ends, but deeper.
    down = np.nan_to_num(toolpath.start[rows[1:], 2] - toolpath.end[rows[:-1], 2])
    meets = (np.hypot(*(start[1:] - end[:-1]).T) < 1e-6) & (np.abs(down) < EXACT)
    this = np.flatnonzero(meets)
    after = this + 1
    begin = np.concatenate([[0], np.flatnonzero(~meets) + 1])
    finish = np.concatenate([begin[1:] - 1, [len(rows) - 1]]) if len(rows) else begin
    if len(rows):
        closed = np.hypot(*(end[finish] - start[begin]).T) < 1e-3
        this, after = np.concatenate([this, finish[closed]]), np.concatenate([after, begin[closed]])
    return this, after


def _turn(before: Floats, after: Floats) -> Floats:
    out: Floats = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))
    return out


def _run_up(shift: Floats, node_u: Floats, normal: Floats, vertex: Ints, corner: Floats) -> None:
    """The node just inside a corner slides along its own move as the corner does. In place."""
    inner = np.where(node_u[vertex] == 0.0, vertex + 1, vertex - 1)
    along = corner - (corner * normal[vertex]).sum(axis=1)[:, None] * normal[vertex]
    across = (shift[inner] * normal[inner]).sum(axis=1)[:, None] * normal[inner]
    shift[inner] = across + along


def _cut_off(
    shift: Floats,
    node_row: Ints,
    node_u: Floats,
    corner: Floats,
    sides: tuple[Ints, Ints],
    vertices: tuple[Ints, Ints],
    toolpath: Toolpath,
    rows: Ints,
) -> None:
    """What of the two sides of a corner lies beyond where they meet now goes there. In place."""
    length = np.maximum(length_in_plane(toolpath.take(rows)), 1e-9)
    for side, fraction, nearer, farther in ((sides[0], 1.0, *vertices[::-1]), (sides[1], 0.0, *vertices)):
        at = np.full(len(side), fraction)
        ahead = toolpath.direction(rows[side], at)
        new = toolpath.place(rows[side], at) + corner
        shorter = (1.0 - 2.0 * fraction) * (corner * ahead).sum(axis=1)
        # On from move to move, as long as moves are shorter than what goes.
        follows = np.full(len(rows), -1)
        follows[nearer] = farther
        left = shorter > 0
        while left.any():
            progress.step()
            side, new, shorter = side[left], new[left], shorter[left]
            goes, room = np.full((len(rows), 2), np.nan), np.full(len(rows), -1.0)
            goes[side], room[side] = new, shorter
            beyond = np.flatnonzero(np.abs(node_u - fraction) * length[node_row] <= room[node_row])
            shift[beyond] = goes[node_row[beyond]] - toolpath.place(rows[node_row[beyond]], node_u[beyond])
            shorter = shorter - length[side]
            side = follows[side]
            left = (shorter >= 0) & (side >= 0)


def _floating(
    shift: Floats, node_u: Floats, lost: Bools, first: Ints, last: Ints, joined: tuple[Bools, Bools]
) -> Floats:
    """Moves that touch nothing take their ends' displacement, straight between; at a free end that of the other."""
    whole = np.flatnonzero(lost[first])
    for k in whole:
        a, b = first[k], last[k]
        if joined[0][k] != joined[1][k]:
            shift[a : b + 1] = shift[b if joined[1][k] else a]
            continue
        share = node_u[a : b + 1, None]
        shift[a : b + 1] = shift[a] * (1 - share) + shift[b] * share
    return shift


def _intervals(toolpath: Toolpath, path: DisplacedPath, pick: Ints, output_moves: str) -> Intervals:
    rows = path.rows[pick]
    zero, one = np.zeros(len(pick)), np.ones(len(pick))
    start, end = path.at(pick, zero), path.at(pick, one)
    z0, z1 = toolpath.start[rows, 2], toolpath.end[rows, 2]
    whole = np.hypot(*(toolpath.end[rows, :2] - toolpath.start[rows, :2]).T) < 1e-9
    kind = wanted_kind(toolpath.kind[rows], z0, z1, output_moves)
    # Of what has shrunk into a corner only the place is left.
    kind = np.where((np.hypot(*(end - start).T) < 1e-9) & ~whole, int(Kind.LINE), kind)
    return Intervals(
        owner=np.arange(len(pick)),
        piece=pick,
        sigma0=zero,
        sigma1=path.length[pick],
        start=start,
        end=end,
        z0=z0,
        z1=z1,
        kind=kind,
        whole=whole,
    )
