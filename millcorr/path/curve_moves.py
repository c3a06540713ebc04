# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines, arcs and cubics in place of an exact curve, within a tolerance, as few as it needs."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Protocol

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import FitError
from millcorr.messages import mm, phrase, xy
from millcorr.nc.toolpath import Kind, Plane, Toolpath
from millcorr.path.path_following import length_in_plane

PROBES = (np.arange(15) + 1) / 16
"""Shares of an interval at which a move is compared with the path, beside where the path bends."""

LARGEST_RADIUS = 5000.0
"""An arc of larger radius, in mm, is written as a line where the tolerance allows: controls refuse or round it."""

ROUNDS = 24
"""A stretch is halved as often at most: a metre is then shorter than 0.1 um."""


class ExactPath(Protocol):
    """A path made of pieces, each a function of one parameter."""

    def evaluate(self, piece: Ints, sigma: Floats, /) -> tuple[Floats, Floats, Floats]:
        """Points (n, 2) in mm, unit normals to the right of growing sigma, and length per unit of sigma."""

    def bends(self, piece: Ints, sigma0: Floats, sigma1: Floats, /) -> tuple[Ints, Floats]:
        """Where it bends between two parameters of pieces: index into these (n,), rising, and parameter (n,)."""


@dataclass(frozen=True, eq=False, slots=True)
class Intervals:
    """Pieces of exact path to be replaced by moves; one row a piece.

    Parameters
    ----------
    owner : (e,) int64
        What the resulting moves belong to.
    piece : (e,) int64
        Piece of the path.
    sigma0, sigma1 : (e,) float64
        Parameter of the piece at start and end, rising, mm.
    start, end : (e, 2) float64
        Ends that the moves must meet exactly, mm.
    z0, z1 : (e,) float64
        Heights at the ends, mm.
    kind : (e,) int64
        `Kind` to use.
    whole : (e,) bool
        True where the interval is a full turn, ending where it starts.
    """

    owner: Ints
    piece: Ints
    sigma0: Floats
    sigma1: Floats
    start: Floats
    end: Floats
    z0: Floats
    z1: Floats
    kind: Ints
    whole: Bools

    def take(self, index: Ints | Bools) -> Intervals:
        """Rows chosen by index or mask."""
        return Intervals(**{f.name: getattr(self, f.name)[index] for f in fields(self)})


def fit_moves(intervals: Intervals, path: ExactPath, tolerance: float) -> tuple[Toolpath, Ints, float]:
    """Replace intervals of the exact path by moves.

    Parameters
    ----------
    intervals : Intervals
    path : ExactPath
    tolerance : float
        Largest distance in mm between moves and exact path.

    Returns
    -------
    moves : Toolpath
        In the order of the owners, and along the path within one.
    owner : (m,) int64
    error : float
        Largest distance found between moves and exact path, mm.

    Raises
    ------
    FitError
        If the tolerance cannot be reached.
    """
    moves: list[tuple[Ints, Floats, Toolpath]] = []
    largest = 0.0
    rest = intervals
    for _ in range(ROUNDS):
        if not len(rest.owner):
            break
        probes = _Probes.of(rest, path)
        done = np.zeros(len(rest.owner), dtype=bool)
        for kind, attempt in ((Kind.LINE, _lines), (Kind.ARC, _arcs), (Kind.CUBIC, _cubics)):
            rows = np.flatnonzero(rest.kind == kind)
            if len(rows):
                error, found = attempt(rest.take(rows), probes.take(rows), tolerance, path)
                ok = error <= tolerance
                done[rows[ok]] = True
                largest = max(largest, float(error[ok].max(initial=0.0)))
                moves += found
        rest = _halves(rest.take(~done), path)
    if len(rest.owner):
        x, y = rest.start[0]
        raise FitError(phrase("the corrected path near {} cannot be written within {}", xy(x, y), mm(tolerance, "g")))
    if not moves:
        empty = np.zeros((0, 2))
        return _moves(empty, empty, np.zeros(0), np.zeros(0), Kind.LINE), np.zeros(0, dtype=np.int64), 0.0
    owner = np.concatenate([m[0] for m in moves])
    place = np.concatenate([m[1] for m in moves])
    order = np.lexsort((place, owner))
    return _risen_evenly(Toolpath.concatenate([m[2] for m in moves]).take(order), owner[order]), owner[order], largest


def _risen_evenly(moves: Toolpath, owner: Ints) -> Toolpath:
    """Moves of which those of one owner rise by their share of its way: the path was displaced since it was divided."""
    begins = np.diff(owner, prepend=-1) != 0
    first, last = np.flatnonzero(begins), np.append(begins[1:], True)
    low, high = moves.start[first, 2], moves.end[last, 2]
    if not (low != high).any():
        return moves
    group = np.cumsum(begins) - 1
    gone = np.cumsum(length_in_plane(moves))
    before = np.concatenate([[0.0], gone])[first]
    total = np.maximum(np.append(before[1:], gone[-1]) - before, 1e-12)
    share = (gone - before[group]) / total[group]
    start, end = moves.start.copy(), moves.end.copy()
    end[:, 2] = np.where(last, high[group], low[group] + (high - low)[group] * share)
    start[1:, 2] = np.where(begins[1:], start[1:, 2], end[:-1, 2])
    centre = moves.centre.copy()
    centre[:, 2] = np.where(np.isfinite(centre[:, 0]), start[:, 2], centre[:, 2])
    return moves.with_moves(start=start, end=end, centre=centre)


def _moves(start: Floats, end: Floats, z0: Floats, z1: Floats, kind: Kind, **more: Floats) -> Toolpath:
    n = len(start)
    centre = np.full((n, 3), np.nan)
    if "centre" in more:
        centre[:, :2] = more["centre"]
        centre[:, 2] = z0
    return Toolpath(
        kind=np.full(n, int(kind)),
        start=np.column_stack([start, z0]),
        end=np.column_stack([end, z1]),
        centre=centre,
        sweep=more.get("sweep", np.zeros(n)),
        control=more.get("control", np.full((n, 4), np.nan)),
        plane=np.full(n, int(Plane.XY)),
        feed=np.full(n, np.nan),
        source=np.zeros(n, dtype=np.int64),
        compensation=np.zeros(n, dtype=np.int64),
        tool=np.zeros(n, dtype=np.int64),
    )


@dataclass(frozen=True, eq=False, slots=True)
class _Probes:
    """Places of the exact path within intervals, at which moves are compared with it.

    Evenly shared ones, (e, 15, 2) mm, and all in the order of the intervals: whose it is, its parameter and point.
    """

    even: Floats
    row: Ints
    sigma: Floats
    point: Floats

    @staticmethod
    def of(rows: Intervals, path: ExactPath) -> _Probes:
        """Evenly shared places of each interval, and where the path bends."""
        sigma = (rows.sigma0[:, None] + (rows.sigma1 - rows.sigma0)[:, None] * PROBES).ravel()
        bent, at = path.bends(rows.piece, rows.sigma0, rows.sigma1)
        row, sigma = np.concatenate([np.repeat(np.arange(len(rows.piece)), len(PROBES)), bent]), np.append(sigma, at)
        point = path.evaluate(rows.piece[row], sigma)[0]
        even = point[: len(point) - len(bent)].reshape(-1, len(PROBES), 2)
        order = np.argsort(row, kind="stable")
        return _Probes(even, row[order], sigma[order], point[order])

    def take(self, index: Ints) -> _Probes:
        """Those of intervals chosen by rising index."""
        name = np.full(len(self.even), -1)
        name[index] = np.arange(len(index))
        mine = name[self.row] >= 0
        return _Probes(self.even[index], name[self.row[mine]], self.sigma[mine], self.point[mine])

    def largest(self, values: Floats) -> Floats:
        """Largest of the values at all places of each interval, (e,)."""
        out: Floats = np.maximum.reduceat(values, np.searchsorted(self.row, np.arange(len(self.even))))
        return out


def _lines(
    rows: Intervals, probes: _Probes, tolerance: float, path: ExactPath
) -> tuple[Floats, list[tuple[Ints, Floats, Toolpath]]]:
    error = np.where(rows.whole, np.inf, _off_chord(rows, probes))
    good = rows.take(error <= tolerance)
    moves = _moves(good.start, good.end, good.z0, good.z1, Kind.LINE)
    return error, [(good.owner, good.sigma0, moves)]


def _off_chord(rows: Intervals, probes: _Probes) -> Floats:
    chord = rows.end - rows.start
    size = np.maximum(np.hypot(*chord.T), 1e-12)
    away, along = probes.point - rows.start[probes.row], chord[probes.row]
    out: Floats = probes.largest(np.abs(away[:, 0] * along[:, 1] - away[:, 1] * along[:, 0])) / size
    return out


def _arcs(
    rows: Intervals, probes: _Probes, tolerance: float, path: ExactPath
) -> tuple[Floats, list[tuple[Ints, Floats, Toolpath]]]:
    """One arc through the ends and the middle; a line where that is as good and the radius is huge."""
    middle = len(PROBES) // 2
    second = np.where(rows.whole[:, None], probes.even[:, 2 * len(PROBES) // 3], rows.end)
    first = np.where(rows.whole[:, None], probes.even[:, len(PROBES) // 3], probes.even[:, middle])
    centre, r = _circle(rows.start, first, second)
    error = np.abs(np.hypot(*(probes.point - centre[probes.row]).T) - r[probes.row])
    round_error = np.where(r <= LARGEST_RADIUS, probes.largest(error), np.inf)
    fits = round_error <= tolerance
    sweep = _sweep(rows.start, first, second, centre, rows.whole)
    flat_error = np.where(rows.whole, np.inf, _off_chord(rows, probes))
    # A line is taken before an arc only where the path is straight to a hundredth of the tolerance.
    straight = (flat_error <= tolerance) & (~fits | (flat_error <= 0.01 * tolerance))
    arc = fits & ~straight
    a, b = rows.take(arc), rows.take(straight)
    found = [
        (a.owner, a.sigma0, _moves(a.start, a.end, a.z0, a.z1, Kind.ARC, centre=centre[arc], sweep=sweep[arc])),
        (b.owner, b.sigma0, _moves(b.start, b.end, b.z0, b.z1, Kind.LINE)),
    ]
    return np.where(straight, flat_error, round_error), found


def _circle(a: Floats, b: Floats, c: Floats) -> tuple[Floats, Floats]:
    """Centre and radius of the circle through three points; a huge radius where they are in line."""
    u, v = b - a, c - a
    det = 2 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    det = np.where(np.abs(det) < 1e-300, 1e-300, det)
    uu, vv = (u * u).sum(axis=1), (v * v).sum(axis=1)
    rel = np.stack([v[:, 1] * uu - u[:, 1] * vv, u[:, 0] * vv - v[:, 0] * uu], axis=1) / det[:, None]
    return a + rel, np.hypot(*rel.T)


def _sweep(start: Floats, middle: Floats, end: Floats, centre: Floats, whole: Bools) -> Floats:
    """Signed angle of the arcs from start through middle to end, or of the whole circle that runs this way."""
    angle = [np.arctan2(p[:, 1] - centre[:, 1], p[:, 0] - centre[:, 0]) for p in (start, middle, end)]
    half = np.mod(angle[1] - angle[0], 2 * np.pi)
    turn = np.mod(angle[2] - angle[0], 2 * np.pi)
    left = half <= turn
    return np.where(left, np.where(whole, 2 * np.pi, turn), np.where(whole, 0.0, turn) - 2 * np.pi)


def _cubics(
    rows: Intervals, probes: _Probes, tolerance: float, path: ExactPath
) -> tuple[Floats, list[tuple[Ints, Floats, Toolpath]]]:
    """One Bezier cubic with the path's tangents at its ends."""
    length = rows.sigma1 - rows.sigma0
    step = length[:, None] / 3
    # Just inside: where the curvature jumps, each side has its own speed.
    inside = 1e-6 * length
    _, n0, f0 = path.evaluate(rows.piece, rows.sigma0 + inside)
    _, n1, f1 = path.evaluate(rows.piece, rows.sigma1 - inside)
    p1 = rows.start + step * np.stack([-n0[:, 1], n0[:, 0]], 1) * f0[:, None]
    p2 = rows.end - step * np.stack([-n1[:, 1], n1[:, 0]], 1) * f1[:, None]
    at = probes.row
    u = ((probes.sigma - rows.sigma0[at]) / length[at])[:, None]
    curve = (
        rows.start[at] * (1 - u) ** 3
        + 3 * p1[at] * u * (1 - u) ** 2
        + 3 * p2[at] * u**2 * (1 - u)
        + rows.end[at] * u**3
    )
    _, normal, _ = path.evaluate(rows.piece[at], probes.sigma)
    gap = curve - probes.point
    across = probes.largest(np.abs((gap * normal).sum(axis=1)))
    # Running ahead along the path costs only its square over the radius of curvature.
    ahead = probes.largest(np.hypot(*gap.T))
    error = np.where(rows.whole | (ahead > 0.05 * length), np.inf, across)
    ok = error <= tolerance
    good = rows.take(ok)
    moves = _moves(good.start, good.end, good.z0, good.z1, Kind.CUBIC, control=np.column_stack([p1[ok], p2[ok]]))
    return error, [(good.owner, good.sigma0, moves)]


def _halves(rows: Intervals, path: ExactPath) -> Intervals:
    """Each interval cut in the middle of its arc length."""
    if not len(rows.owner):
        return rows
    middle = (rows.sigma0 + rows.sigma1) / 2
    point = path.evaluate(rows.piece, middle)[0]
    height = (rows.z0 + rows.z1) / 2
    none = np.zeros(len(rows.owner), dtype=bool)
    first = {f.name: getattr(rows, f.name) for f in fields(rows)}
    second = dict(first)
    first.update(sigma1=middle, end=point, z1=height, whole=none)
    second.update(sigma0=middle, start=point, z0=height, whole=none)
    return Intervals(**{name: np.concatenate([first[name], second[name]]) for name in first})
