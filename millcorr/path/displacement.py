# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a program displaced in place: where its own contour is the nominal, vertices and arcs move along normals.

What the program writes stays what it is: its facets, its arcs, its rounding. A place of the path moves by as much as
the surface that is wanted before it has moved, and by more where a disc could not follow that without cutting into
the surface beside it. Where the moved path is no longer a line or an arc within the tolerance, it is divided.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.deviation import is_corner
from millcorr.footpoint import FootPointSearch, Place
from millcorr.profile import SAME_HEIGHT, Profile
from millcorr.regeneration.curve_moves import Intervals, fit_moves
from millcorr.regeneration.leads import carry_along, own_work
from millcorr.regeneration.moves import FIT_SHARE, Regeneration, put_together, wanted_kind
from millcorr.regeneration.path_following import length_in_plane
from millcorr.theoretical_contour import cutting_runs
from millcorr.toolpath import Toolpath

from .wanted_surface import WantedSurface, meeting

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

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

STILL = 1e-6
"""What would be displaced by no more than this, in mm, stays as it is."""


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
        self._shift = shift

    def at(self, piece: Ints, u: Floats) -> Floats:
        """Places of the moved path, (n, 2) mm, for indices into `rows` and fractions."""
        key = 2.0 * piece + u
        moved = np.stack([np.interp(key, self._key, self._shift[:, k]) for k in (0, 1)], axis=1)
        out: Floats = self.toolpath.place(self.rows[piece], u) + moved
        return out

    def evaluate(self, piece: Ints, sigma: Floats, offset: float = 0.0) -> tuple[Floats, Floats, Floats]:
        """Points, normals to the right of travel, and speed, at lengths in mm along the moves as they were."""
        length = self.length[piece]
        u, h = sigma / length, 1e-5
        low, high = np.maximum(u - h, 0.0), np.minimum(u + h, 1.0)
        ahead = (self.at(piece, high) - self.at(piece, low)) / ((high - low) * length)[:, None]
        speed = np.maximum(np.hypot(*ahead.T), 1e-12)
        return self.at(piece, u), np.stack([ahead[:, 1], -ahead[:, 0]], axis=1) / speed[:, None], speed


def displace(
    toolpath: Toolpath,
    following: Bools,
    before: WantedSurface,
    after: WantedSurface,
    nominal: Profile,
    radius: float,
    *,
    tolerance: float = 0.001,
    output_moves: str = "keep",
) -> Regeneration:
    """Move the following moves of a toolpath by as much as the wanted surface has moved.

    Parameters
    ----------
    toolpath : Toolpath
    following : (n,) bool
        Moves that make the surface.
    before, after : WantedSurface
        What the toolpath makes, and what it is to make.
    nominal : Profile
        What both were moved from.
    radius : float
        Distance in mm from contour to path; 0 where the program states the contour itself (G41, G42).
    tolerance : float
        Largest distance in mm between written and exact path, rounding included.
    output_moves : {'keep', 'lines', 'arcs', 'nurbs'}

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
    known = _nodes(toolpath, rows, nominal, before, after, radius)
    node_row, node_u = known.row, known.u
    shift = _at_the_ends(toolpath, rows, known)
    shift[np.hypot(*shift.T) <= STILL] = 0.0
    path = DisplacedPath(toolpath, rows, node_row, node_u, shift)
    moved = np.zeros(len(rows), dtype=bool)
    np.logical_or.at(moved, node_row, shift.any(axis=1))
    first, last = node_u == 0.0, node_u == 1.0
    shift0[rows], shift1[rows] = shift[first], shift[last]
    carry_along(toolpath, following, own_work(toolpath, following, np.zeros(len(toolpath), dtype=bool)), shift0, shift1)
    pick = np.flatnonzero(moved)
    intervals = _intervals(toolpath, path, pick, output_moves)
    fitted, owner, fit_error = fit_moves(intervals, path, 0.0, FIT_SHARE * tolerance)
    return put_together(
        toolpath, following, rows[pick], fitted, owner, shift0, shift1, original_error=0.0, fit_error=fit_error
    )


@dataclass(frozen=True, eq=False, slots=True)
class _Nodes:
    """Where on every move the displacement is known.

    Index of the move, fraction, direction away from the contour, amount in mm, and whether the contour's nearest place
    is a corner.
    """

    row: Ints
    u: Floats
    way: Floats
    amount: Floats
    corner: Bools

    def take(self, index: Ints) -> _Nodes:
        return _Nodes(*(getattr(self, name)[index] for name in _Nodes.__slots__))

    def with_more(self, other: _Nodes) -> _Nodes:
        return _Nodes(*(np.concatenate([getattr(self, name), getattr(other, name)]) for name in _Nodes.__slots__))


def _nodes(
    toolpath: Toolpath, rows: Ints, nominal: Profile, before: WantedSurface, after: WantedSurface, radius: float
) -> _Nodes:
    """Nodes at the ends of every move, just inside them, and as close between as the displacement bends."""
    feet = FootPointSearch(nominal, margin=radius + 2.0)
    # A move makes the wall at the height that it has come down to.
    z = np.fmax(toolpath.start[rows, 2], toolpath.end[rows, 2])

    def at(row: Ints, u: Floats) -> _Nodes:
        place = np.column_stack([toolpath.place(rows[row], u), z[row]])
        return _Nodes(row, u, *_along_normals(place, feet, before, after, nominal, radius))

    length = np.maximum(length_in_plane(toolpath.take(rows)), 1e-9)
    count = np.maximum(2, np.ceil(length / STEP).astype(np.int64))
    # 0, inset, inner nodes, 1 - inset, 1.
    total = count + 3
    row = np.repeat(np.arange(len(rows)), total)
    number = np.arange(len(row)) - np.repeat(np.cumsum(total) - total, total)
    out = max(float((after.moved - before.moved).max()), 0.0)
    away = np.minimum(_beside_corners(toolpath, rows, out) / length, 0.1)
    u = (number - 1) / count[row]
    u = np.where(number == 0, 0.0, np.where(number == 1, np.minimum(away[0], 0.5 / count)[row], u))
    last = 1.0 - np.minimum(away[1], 0.5 / count)[row]
    u = np.where(number == total[row] - 1, 1.0, np.where(number == total[row] - 2, last, u))
    found = at(row, u)
    left = np.flatnonzero((found.row[1:] == found.row[:-1]) & (number[:-1] > 0) & (number[1:] < total[row[1:]] - 1))
    a, b = found.take(left), found.take(left + 1)
    for _ in range(HALVINGS):
        middle = at(a.row, (a.u + b.u) / 2)
        between = (a.amount[:, None] * a.way + b.amount[:, None] * b.way) / 2
        off = np.hypot(*(middle.amount[:, None] * middle.way - between).T)
        bent = np.flatnonzero((off > BENT) & ((b.u - a.u) * length[a.row] > 4 * INSET))
        if not len(bent):
            break
        middle, a, b = middle.take(bent), a.take(bent), b.take(bent)
        found = found.with_more(middle)
        a, b = a.with_more(middle), middle.with_more(b)
    return found.take(np.lexsort((found.u, found.row)))


def _beside_corners(toolpath: Toolpath, rows: Ints, most: float) -> Floats:
    """How far from the start and the end of every move, (2, k) mm, the side past the vertex has no part in it.

    Where that side comes out by so many mm at most, a disc beside an inside corner meets it until it is as far from it
    again; what lies between is cut off by the corner.
    """
    this, after = _vertices(toolpath, rows)
    ends, starts = np.ones(len(this)), np.zeros(len(after))
    turn = _turn(toolpath.direction(rows[this], ends), toolpath.direction(rows[after], starts))
    steep = np.where(np.abs(turn) < np.pi / 2, np.abs(np.sin(turn)), 1.0)
    room = np.where(np.abs(turn) > SMOOTH, most / np.maximum(steep, np.sin(SMOOTH)), 0.0)
    out = np.full((2, len(rows)), INSET)
    out[1, this] += room
    out[0, after] += room
    return out


def _along_normals(
    place: Floats, search: FootPointSearch, before: WantedSurface, after: WantedSurface, nominal: Profile, radius: float
) -> tuple[Floats, Floats, Bools]:
    """Unit vectors from the contour to places (n, 3) of the path, how far the centre moves along them, and corners."""
    feet = search.find(place)
    corner = (feet.place == Place.JOINT) & is_corner(nominal, feet)
    if radius == 0:
        stretch, s = nominal.stretch[feet.span], nominal.arc_length(feet.span, feet.t)
        correction = [_interpolated(surface, stretch, s) for surface in (before, after)]
        return feet.normal, correction[1] - correction[0], corner
    away = place[:, :2] - feet.foot
    size = np.hypot(*away.T)
    way = np.where((size > 1e-9)[:, None], away / np.maximum(size, 1e-12)[:, None], feet.normal)
    guess = radius - size
    was = before.clearance(place, way, radius, guess)
    now = after.clearance(place, way, radius, was)
    return way, now - was, corner


def _interpolated(surface: WantedSurface, stretch: Ints, s: Floats) -> Floats:
    """What a surface was moved by at places of the profile, mm."""
    out = np.zeros(len(s))
    for k in np.unique(stretch):
        mine, there = stretch == k, surface.stretch == k
        order = np.argsort(surface.s[there], kind="stable")
        out[mine] = np.interp(s[mine], surface.s[there][order], surface.moved[there][order])
    return out


def _at_the_ends(toolpath: Toolpath, rows: Ints, known: _Nodes) -> Floats:
    """Displacement at every node, (m, 2) mm: the same for both moves at a vertex, both sides kept at a corner."""
    node_row, node_u, way, amount = known.row, known.u, known.way, known.amount
    ahead = toolpath.direction(rows[node_row], node_u)
    right = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    across = (right * way).sum(axis=1)
    # The side of the material is one for the whole path.
    side = 1.0 if np.median(across) >= 0 else -1.0
    normal = side * right
    # Beside a corner itself only an arc about it, whose normal it is that points there, touches.
    touching = side * across >= np.where(known.corner, np.cos(ABOUT), np.cos(ALIGNED))
    amount = _held(node_row, node_u, amount, touching)
    # A node that touches moves along its way to the contour, another along the move's own normal.
    shift = amount[:, None] * np.where(touching[:, None], way, normal)
    lost = np.isnan(amount)
    shift[lost] = 0.0

    first = np.flatnonzero(node_u == 0.0)
    last = np.flatnonzero(node_u == 1.0)
    this, after = _vertices(toolpath, rows)
    turn = _turn(ahead[last[this]], ahead[first[after]])
    sharp = np.abs(turn) > SMOOTH
    # Just inside its ends a move knows nothing of the corner there.
    side0 = np.where(np.isnan(amount[last - 1]), np.nan, amount[last - 1])
    side1 = np.where(np.isnan(amount[first + 1]), np.nan, amount[first + 1])
    for a, b, is_sharp in ((this[sharp], after[sharp], True), (this[~sharp], after[~sharp], False)):
        end, begin = last[a], first[b]
        if is_sharp:
            c0, c1 = side0[a], side1[b]
            corner = meeting(normal[end], normal[begin], np.nan_to_num(c0), np.nan_to_num(c1))
            only0, only1 = np.isnan(c1) & ~np.isnan(c0), np.isnan(c0) & ~np.isnan(c1)
            corner[only0] = c0[only0, None] * normal[end[only0]]
            corner[only1] = c1[only1, None] * normal[begin[only1]]
        else:
            known0, known1 = ~lost[end], ~lost[begin]
            corner = np.where(known0[:, None], shift[end], np.where(known1[:, None], shift[begin], 0.0))
        shift[end], shift[begin] = corner, corner
        if is_sharp:
            _run_up(shift, node_row, node_u, normal, end, corner, toolpath, rows)
            _run_up(shift, node_row, node_u, normal, begin, corner, toolpath, rows)
    return _floating(shift, lost, first, last)


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


def _vertices(toolpath: Toolpath, rows: Ints) -> tuple[Ints, Ints]:
    """Pairs of following moves (indices into `rows`) of which the second begins where the first ends; seams too."""
    start, end = toolpath.start[rows, :2], toolpath.end[rows, :2]
    # The next pass may begin where this one ends, but deeper.
    down = np.nan_to_num(toolpath.start[rows[1:], 2] - toolpath.end[rows[:-1], 2])
    meets = (np.hypot(*(start[1:] - end[:-1]).T) < 1e-6) & (np.abs(down) < SAME_HEIGHT)
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


def _run_up(
    shift: Floats,
    node_row: Ints,
    node_u: Floats,
    normal: Floats,
    vertex: Ints,
    corner: Floats,
    toolpath: Toolpath,
    rows: Ints,
) -> None:
    """The node just inside a corner slides along its own move as the corner does. In place."""
    inner = np.where(node_u[vertex] == 0.0, vertex + 1, vertex - 1)
    along = corner - (corner * normal[vertex]).sum(axis=1)[:, None] * normal[vertex]
    shift[inner] += along


def _floating(shift: Floats, lost: Bools, first: Ints, last: Ints) -> Floats:
    """Moves that touch nothing take their ends' displacement, straight between."""
    whole = np.flatnonzero(lost[first])
    for k in whole:
        a, b = first[k], last[k]
        share = np.linspace(0.0, 1.0, b - a + 1)[:, None]
        shift[a : b + 1] = shift[a] * (1 - share) + shift[b] * share
    return shift


def _intervals(toolpath: Toolpath, path: DisplacedPath, pick: Ints, output_moves: str) -> Intervals:
    rows = path.rows[pick]
    zero, one = np.zeros(len(pick)), np.ones(len(pick))
    start, end = path.at(pick, zero), path.at(pick, one)
    z0, z1 = toolpath.start[rows, 2], toolpath.end[rows, 2]
    return Intervals(
        owner=np.arange(len(pick)),
        piece=pick,
        sigma0=zero,
        sigma1=path.length[pick],
        start=start,
        end=end,
        z0=z0,
        z1=z1,
        kind=wanted_kind(toolpath.kind[rows], z0, z1, output_moves),
        corner=np.full((len(pick), 2), np.nan),
        whole=np.hypot(*(end - start).T) < 1e-9,
        sweep_sign=np.sign(toolpath.sweep[rows]),
    )
