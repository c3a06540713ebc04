# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along moves by their share of the move's arc length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import FormatError
from millcorr.nc.toolpath import Kind, Plane, Toolpath

_PARTS = 16
"""Parts in which the length of a cubic is integrated, each with eight Gauss nodes."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_NEWTON_STEPS = 6


@dataclass(frozen=True, eq=False, slots=True)
class Moves:
    """Moves whose coordinates are known, with their exact lengths.

    Parameters
    ----------
    toolpath : Toolpath
        Coordinates that never become known are 0.
    length : (n,) float64
        Arc length of each move in mm.
    cubic : (n,) int64
        Row of a cubic in `table`; -1 for other moves.
    table : (c, parts + 1) float64
        Arc length of each cubic up to even steps of its parameter.
    unknown : (n, 3) bool
        Coordinates that the program has not stated.
    """

    toolpath: Toolpath
    length: Floats
    cubic: Ints
    table: Floats
    unknown: Bools

    @staticmethod
    def of(toolpath: Toolpath) -> Moves:
        """Moves of a toolpath; what is unknown at both ends of a move counts as standing still at 0."""
        filled = toolpath.with_moves(start=np.nan_to_num(toolpath.start), end=np.nan_to_num(toolpath.end))
        rows = np.flatnonzero(filled.kind == Kind.CUBIC)
        cubic = np.full(len(filled), -1)
        cubic[rows] = np.arange(len(rows))
        bounds = np.linspace(0.0, 1.0, _PARTS + 1)
        table = np.zeros((len(rows), _PARTS + 1))
        length = filled.with_moves(kind=np.where(cubic >= 0, Kind.LINE, filled.kind)).length()
        if len(rows):
            poles = _poles(filled, rows)
            for k in range(_PARTS):
                low, high = np.full(len(rows), bounds[k]), np.full(len(rows), bounds[k + 1])
                table[:, k + 1] = table[:, k] + _bezier_length(poles, low, high)
            length[rows] = table[:, -1]
        return Moves(filled, length, cubic, table, np.isnan(toolpath.start) | np.isnan(toolpath.end))

    def at(self, row: Ints, share: Floats) -> Floats:
        """Positions on moves.

        Parameters
        ----------
        row : (k,) int64
            Move of each place.
        share : (k,) float64
            Share of the move's arc length, 0 to 1.

        Returns
        -------
        (k, 3) float64
            In mm.
        """
        path = self.toolpath
        s = share[:, None]
        out: Floats = path.start[row] * (1 - s) + path.end[row] * s
        kind = path.kind[row]
        for plane in Plane:
            these = np.flatnonzero((kind == Kind.ARC) & (path.plane[row] == plane))
            if len(these):
                a, b, _ = plane.axes
                begin, r, sweep = self._arc(row[these], a, b)
                f = share[these]
                radius = r[0] * (1 - f) + r[1] * f
                angle = begin + sweep * f
                out[these, a] = path.centre[row[these], a] + radius * np.cos(angle)
                out[these, b] = path.centre[row[these], b] + radius * np.sin(angle)
        these = np.flatnonzero(kind == Kind.CUBIC)
        if len(these):
            rows = row[these]
            poles = _poles(path, rows)
            out[these, :2] = _bezier(poles, self._parameter(rows, poles, share[these]))
        return out

    def _arc(self, rows: Ints, a: int, b: int) -> tuple[Floats, tuple[Floats, Floats], Floats]:
        """Angle at the start, radii at both ends, sweep of arcs in the plane of axes a and b."""
        path = self.toolpath
        u, v = (path.start[rows, k] - path.centre[rows, k] for k in (a, b))
        last = np.hypot(*(path.end[rows, k] - path.centre[rows, k] for k in (a, b)))
        return np.arctan2(v, u), (np.hypot(u, v), last), path.sweep[rows]

    def _parameter(self, rows: Ints, poles: Floats, share: Floats) -> Floats:
        """Parameter of cubics at shares of their length: Newton on the length, from the table."""
        table = self.table[self.cubic[rows]]
        wanted = share * table[:, -1]
        part = np.clip((table < wanted[:, None]).sum(axis=1) - 1, 0, _PARTS - 1)
        low, high = part / _PARTS, (part + 1) / _PARTS
        each = np.arange(len(rows))
        before, within = table[each, part], table[each, part + 1] - table[each, part]
        with np.errstate(invalid="ignore", divide="ignore"):
            u = low + (high - low) * np.nan_to_num((wanted - before) / within)
        for _ in range(_NEWTON_STEPS):
            excess = before + _bezier_length(poles, low, u) - wanted
            speed = np.hypot(*_bezier_derivative(poles, u).T)
            u = np.clip(u - excess / np.maximum(speed, 1e-12), low, high)
        out: Floats = u
        return out

    def directions(self) -> tuple[Floats, Floats]:
        """Unit tangents (n, 3) at the start and at the end of every move; 0 where a move has no length."""
        path = self.toolpath
        first: Floats = path.end - path.start
        last = first.copy()
        for plane in Plane:
            rows = np.flatnonzero((path.kind == Kind.ARC) & (path.plane == plane))
            if len(rows):
                a, b, c = plane.axes
                begin, radius, sweep = self._arc(rows, a, b)
                for out, angle, r in ((first, begin, radius[0]), (last, begin + sweep, radius[1])):
                    out[rows, a] = -np.sin(angle) * r * sweep
                    out[rows, b] = np.cos(angle) * r * sweep
                    out[rows, c] = path.end[rows, c] - path.start[rows, c]
        rows = np.flatnonzero(path.kind == Kind.CUBIC)
        if len(rows):
            poles = _poles(path, rows)
            first[rows, :2] = _end_tangent(poles)
            last[rows, :2] = -_end_tangent(poles[:, ::-1])
        for out in (first, last):
            size = np.sqrt((out**2).sum(axis=1))[:, None]
            np.divide(out, size, out=out, where=size > 0)
        return first, last


def unknown_moves(toolpath: Toolpath) -> Bools:
    """Moves whose way cannot be known: a coordinate is stated at one end only, or an arc or spline is not."""
    half = np.isnan(toolpath.start) != np.isnan(toolpath.end)
    axes = np.array([Plane(p).axes[:2] for p in (17, 18, 19)])[toolpath.plane - 17]
    centre = np.isnan(np.take_along_axis(toolpath.centre, axes, axis=1)).any(axis=1) | np.isnan(toolpath.sweep)
    control = np.isnan(toolpath.control).any(axis=1)
    out: Bools = half.any(axis=1) | ((toolpath.kind == Kind.ARC) & centre) | ((toolpath.kind == Kind.CUBIC) & control)
    return out


def refuse(toolpath: Toolpath, wrong: Bools, message: str, name: str) -> None:
    """Refuse the first of some moves by its line, if there is one; FormatError."""
    rows = np.flatnonzero(wrong)
    if len(rows):
        raise FormatError(message, name, int(toolpath.line(rows[0])))


def _poles(path: Toolpath, rows: Ints) -> Floats:
    return np.stack([path.start[rows, :2], path.control[rows, :2], path.control[rows, 2:], path.end[rows, :2]], axis=1)


def _bezier(poles: Floats, u: Floats) -> Floats:
    t = u[:, None]
    b = poles.transpose(1, 0, 2)
    out: Floats = b[0] * (1 - t) ** 3 + 3 * b[1] * t * (1 - t) ** 2 + 3 * b[2] * t**2 * (1 - t) + b[3] * t**3
    return out


def _bezier_derivative(poles: Floats, u: Floats) -> Floats:
    t = u[:, None]
    d = np.diff(poles, axis=1).transpose(1, 0, 2)
    out: Floats = 3 * (d[0] * (1 - t) ** 2 + 2 * d[1] * t * (1 - t) + d[2] * t**2)
    return out


def _bezier_length(poles: Floats, low: Floats, high: Floats) -> Floats:
    """Arc length between parameters, (k,)."""
    half = (high - low) / 2
    out = np.zeros(len(low))
    for node, weight in zip(_NODES, _WEIGHTS, strict=True):
        out += weight * np.hypot(*_bezier_derivative(poles, (low + high) / 2 + node * half).T)
    return out * half


def _end_tangent(poles: Floats) -> Floats:
    """Direction at the first pole, from the next that differs."""
    out: Floats = poles[:, 1] - poles[:, 0]
    for k in (2, 3):
        still = np.hypot(*out.T) < 1e-9
        out[still] = poles[still, k] - poles[still, 0]
    return out
