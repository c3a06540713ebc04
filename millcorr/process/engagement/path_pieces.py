# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and arcs in the plane, as arrays: what a cutter's path or a contour is made of for engagement.

Arcs stay arcs. Cubics and NURBS become arcs through three of their points, within `ARC_TOLERANCE`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase, xy
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath

ARC_TOLERANCE = 1e-7
"""Largest distance in mm between a cubic or NURBS and the arcs that stand for it."""

LONGEST_SWEEP = 2 * np.pi / 3
"""Arcs are cut into pieces that turn no more than this, in rad."""

_FLAT = 1e-9
"""Three points whose middle lies nearer to the chord than this, in mm, are a line."""

_HALVINGS = 14


@dataclass(frozen=True, eq=False, slots=True)
class Pieces(ReadOnlyArrays):
    """Lines and arcs, one row a piece, in order.

    Parameters
    ----------
    start, end : (n, 2) float64
        mm.
    centre : (n, 2) float64
        Centre of an arc in mm; NaN for a line.
    radius : (n,) float64
        Radius of an arc in mm; inf for a line.
    sweep : (n,) float64
        Signed angle of an arc in rad, positive anticlockwise; 0 for a line.
    owner : (n,) int64
        Move or span that the piece belongs to.
    t0, t1 : (n,) float64
        Part of the owner, 0..1 from its start to its end.
    z0, z1 : (n,) float64
        Heights of the tip at start and end in mm; NaN where not known.
    """

    start: Floats
    end: Floats
    centre: Floats
    radius: Floats
    sweep: Floats
    owner: Ints
    t0: Floats
    t1: Floats
    z0: Floats
    z1: Floats

    def __len__(self) -> int:
        return len(self.start)

    def take(self, index: Ints | Bools | slice) -> Pieces:
        """Pieces chosen by index or mask, in that order."""
        return Pieces(**{f.name: getattr(self, f.name)[index].copy() for f in fields(self)})

    @staticmethod
    def concatenate(parts: list[Pieces]) -> Pieces:
        """One row of pieces after another."""
        return Pieces(**{f.name: np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(Pieces)})

    @property
    def is_arc(self) -> Bools:
        """True for arcs; (n,)."""
        out: Bools = np.isfinite(self.radius)
        return out

    @property
    def length(self) -> Floats:
        """Length in the plane in mm; (n,)."""
        straight = np.hypot(*(self.end - self.start).T)
        out: Floats = np.where(self.is_arc, np.where(self.is_arc, self.radius, 0.0) * np.abs(self.sweep), straight)
        return out

    def point(self, row: Ints, u: Floats) -> Floats:
        """Points at parts u (0 at the start, 1 at the end, which are met exactly) of pieces; (k, 2) in mm."""
        u = np.asarray(u, dtype=float)
        a, b = self.start[row], self.end[row]
        out = a + u[:, None] * (b - a)
        k = np.flatnonzero(self.is_arc[row] & (u > 0) & (u < 1))
        if len(k):
            rows = row[k]
            arm = self.start[rows] - self.centre[rows]
            angle = np.arctan2(arm[:, 1], arm[:, 0]) + self.sweep[rows] * u[k]
            out[k] = self.centre[rows] + self.radius[rows, None] * np.stack([np.cos(angle), np.sin(angle)], 1)
        out[u == 1.0] = b[u == 1.0]
        return out

    def tangent(self, row: Ints, u: Floats) -> Floats:
        """Unit tangents at parts u of pieces; (k, 2). A piece without length has the tangent (1, 0)."""
        d = self.end[row] - self.start[row]
        k = np.flatnonzero(self.is_arc[row])
        if len(k):
            rows = row[k]
            arm = self.start[rows] - self.centre[rows]
            angle = np.arctan2(arm[:, 1], arm[:, 0]) + self.sweep[rows] * np.asarray(u, dtype=float)[k]
            d[k] = np.sign(self.sweep[rows])[:, None] * np.stack([-np.sin(angle), np.cos(angle)], 1)
        size = np.hypot(*d.T)
        d[size == 0] = (1.0, 0.0)
        out: Floats = d / np.where(size == 0, 1.0, size)[:, None]
        return out

    def distance(self, row: Ints, point: Floats) -> Floats:
        """Distances in mm of points (k, 2) from pieces, pair by pair; (k,)."""
        a, b = self.start[row], self.end[row]
        ends = np.minimum(np.hypot(*(point - a).T), np.hypot(*(point - b).T))
        d = b - a
        size = np.hypot(*d.T)
        d = d / np.where(size == 0, 1.0, size)[:, None]
        v = point - a
        along = (v * d).sum(axis=1)
        out = np.where((along > 0) & (along < size), np.abs(v[:, 0] * d[:, 1] - v[:, 1] * d[:, 0]), ends)
        k = np.flatnonzero(self.is_arc[row])
        if len(k):
            rows = row[k]
            arm, first = point[k] - self.centre[rows], a[k] - self.centre[rows]
            turn = np.arctan2(arm[:, 1], arm[:, 0]) - np.arctan2(first[:, 1], first[:, 0])
            inside = np.mod(np.sign(self.sweep[rows]) * turn, 2 * np.pi) <= np.abs(self.sweep[rows])
            out[k] = np.where(inside, np.abs(np.hypot(*arm.T) - self.radius[rows]), ends[k])
        return out

    def part(self, u0: Floats, u1: Floats) -> Pieces:
        """The part from u0 to u1 of every piece, both (n,) in 0..1."""
        rows = np.arange(len(self))
        return Pieces(
            self.point(rows, u0),
            self.point(rows, u1),
            self.centre.copy(),
            self.radius.copy(),
            self.sweep * (u1 - u0),
            self.owner.copy(),
            self.t0 + u0 * (self.t1 - self.t0),
            self.t0 + u1 * (self.t1 - self.t0),
            self.z0 + u0 * (self.z1 - self.z0),
            self.z0 + u1 * (self.z1 - self.z0),
        )


def arcs_through(start: Floats, middle: Floats, end: Floats) -> tuple[Floats, Floats, Floats]:
    """Arcs through three points each; a line where the middle lies on the chord.

    Parameters
    ----------
    start, middle, end : (n, 2) float64
        mm.

    Returns
    -------
    centre : (n, 2) float64
        mm; NaN for a line.
    radius : (n,) float64
        mm; inf for a line.
    sweep : (n,) float64
        Signed angle in rad; 0 for a line.
    """
    a, b = middle - start, end - start
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    chord = np.hypot(*b.T)
    straight = np.abs(cross) <= _FLAT * np.maximum(chord, _FLAT)
    safe = np.where(straight, 1.0, 2 * cross)
    a2, b2 = (a * a).sum(axis=1), (b * b).sum(axis=1)
    offset = np.stack([b[:, 1] * a2 - a[:, 1] * b2, a[:, 0] * b2 - b[:, 0] * a2], 1) / safe[:, None]
    radius = np.hypot(*offset.T)
    # Half the turn is the angle between the chords from the start and from the end to the middle.
    c = end - middle
    half = np.arctan2(a[:, 0] * c[:, 1] - a[:, 1] * c[:, 0], (a * c).sum(axis=1))
    sweep = np.where(straight, 0.0, 2 * half)
    centre = np.where(straight[:, None], np.nan, start + offset)
    return centre, np.where(straight, np.inf, radius), sweep


def pieces_of_toolpath(toolpath: Toolpath, rows: Ints, *, where: str = "program") -> Pieces:
    """Lines and arcs of the moves of a cutter-centre path, seen along Z.

    Parameters
    ----------
    toolpath : Toolpath
    rows : (k,) int64
        Moves to take, in order. A move along Z alone becomes a piece without length.
    where : str
        Name for messages.

    Returns
    -------
    Pieces
        `owner` is the move's row; arcs are cut at `LONGEST_SWEEP`.

    Raises
    ------
    InputError
        If a move has radius compensation by the control, is an arc out of the XY plane or starts nowhere.
    """
    if (toolpath.compensation[rows] != Compensation.OFF).any():
        raise InputError(
            phrase(
                "{}: the program cuts with G41 or G42, so it does not say where the cutter's centre "
                "goes: give a program of the centre path",
                where,
            )
        )
    arc = toolpath.kind[rows] == Kind.ARC
    if (arc & (toolpath.plane[rows] != Plane.XY)).any():
        raise InputError(
            phrase("{}: engagement needs arcs in the XY plane (G17); the program has others that cut", where)
        )
    a, b = toolpath.start[rows], toolpath.end[rows]
    unknown = ~(np.isfinite(a[:, :2]).all(axis=1) & np.isfinite(b[:, :2]).all(axis=1))
    if unknown.any():
        line = toolpath.line(rows[np.flatnonzero(unknown)[0]])
        raise InputError(
            phrase(
                "{}: line {} cuts from a place the program has not stated: state X and Y before it",
                where,
                line,
            )
        )
    n = len(rows)
    centre, radius, sweep = np.full((n, 2), np.nan), np.full(n, np.inf), np.zeros(n)
    k = np.flatnonzero(arc)
    if len(k):
        centre[k], radius[k], sweep[k] = _meeting_both_ends(
            a[k, :2], b[k, :2], toolpath.centre[rows[k], :2], toolpath.sweep[rows[k]]
        )
    zero, one = np.zeros(n), np.ones(n)
    whole = Pieces(
        a[:, :2].copy(), b[:, :2].copy(), centre, radius, sweep, rows.astype(np.int64), zero, one,
        a[:, 2].copy(), b[:, 2].copy(),
    )  # fmt: skip
    cubic = toolpath.kind[rows] == Kind.CUBIC
    if not cubic.any():
        return _cut(whole)
    k = np.flatnonzero(cubic)
    curved = _cubics(toolpath, rows[k])
    joined = Pieces.concatenate([_cut(whole.take(~cubic)), curved])
    return joined.take(np.lexsort((joined.t0, joined.owner)))


def _meeting_both_ends(start: Floats, end: Floats, centre: Floats, sweep: Floats) -> tuple[Floats, Floats, Floats]:
    """Arcs whose rounded centre is moved onto the chord's bisector, so that both ends are met."""
    chord = end - start
    size2 = (chord**2).sum(axis=1)
    closed = size2 < 1e-18
    along = ((centre - (start + end) / 2) * chord).sum(axis=1) / np.where(closed, 1.0, size2)
    centre = np.where(closed[:, None], centre, centre - chord * along[:, None])
    a, b = start - centre, end - centre
    exact = np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(axis=1))
    exact = exact + 2 * np.pi * np.round((sweep - exact) / (2 * np.pi))
    return centre, np.hypot(*a.T), np.where(closed, sweep, exact)


def _cut(pieces: Pieces) -> Pieces:
    """Arcs cut into even parts of at most `LONGEST_SWEEP`."""
    count = np.maximum(1, np.ceil(np.abs(pieces.sweep) / LONGEST_SWEEP - 1e-12)).astype(np.int64)
    if (count == 1).all():
        return pieces
    row = np.repeat(np.arange(len(pieces)), count)
    k = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    many = count[row].astype(float)
    return pieces.take(row).part(k / many, (k + 1) / many)


def _cubics(toolpath: Toolpath, rows: Ints) -> Pieces:
    p = np.stack(
        [toolpath.start[rows, :2], toolpath.control[rows, :2], toolpath.control[rows, 2:], toolpath.end[rows, :2]], 1
    )

    def at(k: Ints, t: Floats) -> Floats:
        t = t[:, None]
        q, u = p[k], 1 - t
        out: Floats = q[:, 0] * u**3 + 3 * q[:, 1] * u * u * t + 3 * q[:, 2] * u * t * t + q[:, 3] * t**3
        return out

    k, t0, t1, (start, end, centre, radius, sweep) = _by_arcs(at, len(rows))
    z0, z1 = toolpath.start[rows[k], 2], toolpath.end[rows[k], 2]
    return Pieces(
        start, end, centre, radius, sweep, rows[k].astype(np.int64), t0, t1, z0 + t0 * (z1 - z0), z0 + t1 * (z1 - z0)
    )


def pieces_of_profile(profile: Profile) -> Pieces:
    """Lines and arcs of a profile in its direction; `owner` is the span. Lines and circles are exact."""

    def at(k: Ints, t: Floats) -> Floats:
        return profile.evaluate(k, t)[0]

    if len(profile.coefficient) == 2 and profile.polynomial:
        k = np.arange(profile.spans)
        zero, one = np.zeros(len(k)), np.ones(len(k))
        start, end = at(k, zero), at(k, one)
        centre, radius, sweep = np.full((len(k), 2), np.nan), np.full(len(k), np.inf), np.zeros(len(k))
        t0, t1 = zero, one
    else:
        k, t0, t1, (start, end, centre, radius, sweep) = _by_arcs(at, profile.spans)
    nothing = np.full(len(k), np.nan)
    return Pieces(start, end, centre, radius, sweep, k.astype(np.int64), t0, t1, nothing, nothing.copy())


def _by_arcs(at: Callable[[Ints, Floats], Floats], count: int) -> tuple[Ints, Floats, Floats, tuple[Floats, ...]]:
    """Halve curves until arcs through three points stay within the tolerance at their quarters."""
    k, t0, t1 = np.arange(count), np.zeros(count), np.ones(count)
    done: list[tuple[NDArray[np.generic], ...]] = []
    for depth in range(_HALVINGS + 1):
        progress.step()
        width = t1 - t0
        start, middle, end = at(k, t0), at(k, t0 + width / 2), at(k, t1)
        centre, radius, sweep = arcs_through(start, middle, end)
        arc = np.isfinite(radius)
        error = np.zeros(len(k))
        for part in (0.25, 0.75):
            q = at(k, t0 + part * width)
            chord = end - start
            size = np.maximum(np.hypot(*chord.T), 1e-300)
            beside = np.abs(chord[:, 0] * (q - start)[:, 1] - chord[:, 1] * (q - start)[:, 0]) / size
            round_ = np.abs(np.hypot(*(q - centre).T) - radius, where=arc, out=beside.copy())
            error = np.maximum(error, np.where(arc, round_, beside))
        good = (error <= ARC_TOLERANCE / 2) & (np.abs(sweep) <= LONGEST_SWEEP)
        if depth == _HALVINGS:
            if not good.all():
                x, y = start[np.flatnonzero(~good)[0]]
                raise InputError(phrase("the curve near {} bends too sharply to be followed", xy(x, y)))
        done.append(tuple(v[good] for v in (k, t0, t1, start, end, centre, radius, sweep)))
        k, t0, t1 = k[~good], t0[~good], t1[~good]
        if not len(k):
            break
        half = (t0 + t1) / 2
        k, t0, t1 = np.concatenate([k, k]), np.concatenate([t0, half]), np.concatenate([half, t1])
    joined = [np.concatenate([d[i] for d in done]) for i in range(8)]
    order = np.lexsort((joined[1], joined[0]))
    kk, a, b, *rest = (v[order] for v in joined)
    return kk, a, b, tuple(rest)
