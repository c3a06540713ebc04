# SPDX-License-Identifier: LGPL-2.1-or-later
"""The toolpath: where the cutter goes, move by move, with arcs kept as arcs."""

from __future__ import annotations

import zlib
from dataclasses import dataclass, fields, replace
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Bools, Floats, Ints, compact
from millcorr.errors import InputError


class Kind(IntEnum):
    """Kind of a move."""

    RAPID = 0
    LINE = 1
    ARC = 2
    CUBIC = 3


class Plane(IntEnum):
    """Plane of arcs, by its G code; the axis is the one normal to it."""

    XY = 17
    ZX = 18
    YZ = 19

    @property
    def axes(self) -> tuple[int, int, int]:
        """Indices of first, second and normal axis, right-handed."""
        return {Plane.XY: (0, 1, 2), Plane.ZX: (2, 0, 1), Plane.YZ: (1, 2, 0)}[self]


class Compensation(IntEnum):
    """Cutter radius compensation by the control."""

    OFF = 0
    LEFT = 1
    """G41: the cutter is left of the programmed line."""
    RIGHT = -1
    """G42: the cutter is right of the programmed line."""


def named_tool(name: bytes) -> int:
    """Number that stands for a tool by its name: below -1, or the name itself where it is a number.

    Capitals and small letters are the same. Two names of a program share a number once in 5e8 pairs.

    Parameters
    ----------
    name : bytes
        As the program writes it.

    Examples
    --------
    >>> named_tool(b"5"), named_tool(b"Rough") == named_tool(b"ROUGH") < -1
    (5, True)
    """
    name = name.strip()
    return int(name) if name.isdigit() else -2 - (zlib.crc32(name.upper()) & 0x1FFF_FFFF)


@dataclass(frozen=True, eq=False, slots=True)
class Toolpath:
    """Moves of a program in order, one row a move.

    Parameters
    ----------
    kind : (n,) int64
        `Kind` of each move.
    start, end : (n, 3) float64
        Programmed positions x, y, z in mm, in the work frame active at the move. A coordinate that the
        program has not stated yet is NaN (a start is never invented).
    centre : (n, 3) float64
        Centre of an arc in mm; NaN for other moves. The coordinate along the plane's normal is the start's.
    sweep : (n,) float64
        Signed angle of an arc in rad, positive anticlockwise seen from the tip of the plane's normal axis
        (so G3 is positive); a full circle is +-2 pi, further turns add to it; 0 for other moves.
    control : (n, 4) float64
        For a cubic (G5) the two inner Bezier points x1, y1, x2, y2 in mm; NaN for other moves.
    plane : (n,) int64
        `Plane` of each move.
    feed : (n,) float64
        Feed in mm/s; NaN for rapids, for inverse-time or per-revolution feed, and where none was stated.
    source : (n,) int64
        Index (from 0) of the block or command that made the move; not decreasing.
    compensation : (n,) int64
        `Compensation` in force during the move.
    tool : (n,) int64
        Number of the tool in the spindle, `named_tool` of one with a name; -1 where the program has not called one.
    lines : (blocks,) int64 or None
        Line of the file, from 0, that each block runs; None where blocks are lines.

    Raises
    ------
    InputError
        If the arrays disagree in length.
    """

    kind: Ints
    start: Floats
    end: Floats
    centre: Floats
    sweep: Floats
    control: Floats
    plane: Ints
    feed: Floats
    source: Ints
    compensation: Ints
    tool: Ints
    lines: Ints | None = None

    def __post_init__(self) -> None:
        n = len(self.kind)
        for name in COLUMNS:
            if (rows := len(getattr(self, name))) != n:
                raise InputError(f"toolpath: {name} has {rows} rows, expected {n}")
            object.__setattr__(self, name, compact(getattr(self, name)))

    def __len__(self) -> int:
        return len(self.kind)

    def line(self, row: Ints | int) -> Ints:
        """Numbers of the lines of the file that some moves stand on, from 1, (k,)."""
        block = self.source[row]
        out: Ints = (block if self.lines is None else self.lines[block]) + 1
        return out

    def take(self, index: Ints | Bools | slice) -> Toolpath:
        """Moves chosen by index or mask, in that order; most of them in one piece are no copy."""
        if not isinstance(index, slice) and index.dtype == np.bool_:
            rows = np.flatnonzero(index)
            in_one = len(rows) > 0 and rows[-1] - rows[0] + 1 == len(rows)
            index = slice(int(rows[0]), int(rows[-1]) + 1) if in_one else rows
        out = {name: getattr(self, name)[index] for name in COLUMNS}
        if isinstance(index, slice) and 2 * len(out["kind"]) < len(self):
            # A few moves do not hold the memory of all.
            out = {name: values.copy() for name, values in out.items()}
        return Toolpath(**out, lines=self.lines)

    def with_moves(self, **arrays: NDArray[np.generic]) -> Toolpath:
        """Copy with some of the arrays replaced."""
        return replace(self, **arrays)  # type: ignore[arg-type]

    def with_lines(self, lines: Ints | None) -> Toolpath:
        """Copy whose blocks run these lines."""
        return replace(self, lines=lines)

    @staticmethod
    def concatenate(parts: list[Toolpath]) -> Toolpath:
        """One toolpath after another, all of them of the blocks of the first."""
        columns = {n: np.concatenate([getattr(p, n) for p in parts]) for n in COLUMNS}
        return Toolpath(**columns, lines=parts[0].lines)

    @staticmethod
    def merged(first: Toolpath, rows: Ints, second: Toolpath, order: Ints) -> Toolpath:
        """Rows of one toolpath and then all of another, in an order of both."""
        columns = {n: np.concatenate([getattr(first, n)[rows], getattr(second, n)])[order] for n in COLUMNS}
        return Toolpath(**columns, lines=first.lines)

    def position(self, t: Floats) -> Floats:
        """Positions along every move.

        Parameters
        ----------
        t : (k,) float64
            Fractions of a move, 0 at its start, 1 at its end.

        Returns
        -------
        (n, k, 3) float64
            Positions in mm; ends are exact.
        """
        t = np.asarray(t, dtype=np.float64)
        points = self.start[:, None, :] * (1 - t)[:, None] + self.end[:, None, :] * t[:, None]
        for plane in Plane:
            rows = np.flatnonzero((self.kind == Kind.ARC) & (self.plane == plane))
            if not len(rows):
                continue
            a, b, _ = plane.axes
            radial = self.start[rows][:, [a, b]] - self.centre[rows][:, [a, b]]
            last = self.end[rows][:, [a, b]] - self.centre[rows][:, [a, b]]
            radius = np.hypot(*radial.T)[:, None] * (1 - t) + np.hypot(*last.T)[:, None] * t
            angle = np.arctan2(radial[:, 1], radial[:, 0])[:, None] + self.sweep[rows][:, None] * t
            inner = (t > 0) & (t < 1)
            row, column = rows[:, None], np.flatnonzero(inner)[None, :]
            points[row, column, a] = (self.centre[rows, a][:, None] + radius * np.cos(angle))[:, inner]
            points[row, column, b] = (self.centre[rows, b][:, None] + radius * np.sin(angle))[:, inner]
        rows = np.flatnonzero(self.kind == Kind.CUBIC)
        if len(rows):
            p0, p3 = self.start[rows][:, None, :2], self.end[rows][:, None, :2]
            p1, p2 = self.control[rows][:, None, :2], self.control[rows][:, None, 2:]
            u = t[None, :, None]
            points[rows, :, :2] = p0 * (1 - u) ** 3 + 3 * p1 * u * (1 - u) ** 2 + 3 * p2 * u**2 * (1 - u) + p3 * u**3
        return points

    def place(self, row: Ints, u: Floats) -> Floats:
        """Places in the plane at one fraction of each of some moves.

        Parameters
        ----------
        row : (n,) int64
        u : (n,) float64
            0 at a move's start, 1 at its end.

        Returns
        -------
        (n, 2) float64
            mm; ends are exact.
        """
        a, b, share = self.start[row, :2], self.end[row, :2], u[:, None]
        out: Floats = a * (1 - share) + b * share
        inner = (u > 0) & (u < 1)
        bent = np.flatnonzero(inner & (self.kind[row] == Kind.ARC) & (self.plane[row] == Plane.XY))
        if len(bent):
            centre, v = self.centre[row[bent], :2], u[bent]
            arm0, arm1 = a[bent] - centre, b[bent] - centre
            r = np.hypot(*arm0.T) * (1 - v) + np.hypot(*arm1.T) * v
            angle = np.arctan2(arm0[:, 1], arm0[:, 0]) + self.sweep[row[bent]] * v
            out[bent] = centre + r[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        curved = np.flatnonzero(inner & (self.kind[row] == Kind.CUBIC))
        if len(curved):
            v, control = share[curved], self.control[row[curved]]
            out[curved] = a[curved] * (1 - v) ** 3 + b[curved] * v**3
            out[curved] += 3 * control[:, :2] * v * (1 - v) ** 2 + 3 * control[:, 2:] * v**2 * (1 - v)
        return out

    def direction(self, row: Ints, u: Floats) -> Floats:
        """Unit vectors of travel in the plane, one fraction of each of some moves, (n, 2); 0 where nothing travels."""
        h = 1e-6
        ahead = self.place(row, np.minimum(u + h, 1.0)) - self.place(row, np.maximum(u - h, 0.0))
        out: Floats = ahead / np.maximum(np.hypot(*ahead.T), 1e-15)[:, None]
        return out

    def length(self) -> Floats:
        """Length of every move in mm, shape (n,); arcs with their helix."""
        delta = self.end - self.start
        out: Floats = np.sqrt((delta**2).sum(axis=1))
        for plane in Plane:
            rows = np.flatnonzero((self.kind == Kind.ARC) & (self.plane == plane))
            if len(rows):
                a, b, c = plane.axes
                radius = np.hypot(
                    self.start[rows, a] - self.centre[rows, a], self.start[rows, b] - self.centre[rows, b]
                )
                out[rows] = np.hypot(radius * self.sweep[rows], delta[rows, c])
        rows = np.flatnonzero(self.kind == Kind.CUBIC)
        if len(rows):
            samples = self.take(rows).position(np.linspace(0.0, 1.0, 65))
            out[rows] = np.sqrt((np.diff(samples, axis=1) ** 2).sum(axis=2)).sum(axis=1)
        return out


COLUMNS = tuple(item.name for item in fields(Toolpath) if item.name != "lines")
"""Names of the arrays of a toolpath that have a row a move."""
