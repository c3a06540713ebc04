# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans as text after Leica: PTS, a count and the points, and PTX, a grid of points in the scanner's frame.

A PTX scan begins with the numbers of columns and rows, the scanner's place and axes (four lines of three numbers), and
a matrix of four lines of four: (x, y, z, 1) times it is the registered place. A ray that met nothing is 0 0 0. Behind x
y z stand the intensity, a colour, or both. Several scans follow each other.
"""

from __future__ import annotations

import re

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.readers.measurement import Measurement

from .decoding import beginning
from .fields import NUMBER
from .source import Source, shown

_WIDTHS = (3, 4, 6, 7)
_POSE = 8
"""Lines of a PTX scan between the size of its grid and its points."""
_ROTATION = 1e-3
"""Rows of the matrix that turns are unit vectors at right angles to within this."""
_COUNT = re.compile(r"\d{1,9}", re.ASCII)


def recognises(data: bytes) -> bool:
    """Whether a file begins with a count alone in its line, and points or the head of a grid behind it."""
    head = beginning(data, 4096).decode("latin-1")
    rows = [line.split() for line in head.splitlines()[:3]]
    if len(rows) < 3 or len(rows[0]) != 1 or not _COUNT.fullmatch(rows[0][0]):
        return False
    if len(rows[1]) == 1:
        return bool(_COUNT.fullmatch(rows[1][0])) and len(rows[2]) == 3 and all(map(NUMBER.fullmatch, rows[2]))
    return len(rows[1]) in _WIDTHS and all(map(NUMBER.fullmatch, rows[1]))


def read(source: Source) -> Measurement:
    """Points of all scans of a file, those of PTX where they were registered.

    Parameters
    ----------
    source : Source
        Must say what the points are; the unit is mm unless it says otherwise.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a number is spoilt, a scan is shorter than it says, or a matrix is no turn and shift; names the line.
    UsageError
        If the caller does not say what the points are.
    """
    ball_radius, unit = source.ball_radius(), source.unit(None)
    lines = [line for _, line in source.lines()]
    while lines and not lines[-1].strip():
        lines.pop()
    points: list[Floats] = []
    numbers: list[Ints] = []
    position = missed = 0
    while position < len(lines):
        count, turn, shift, position = _head(source, lines, position)
        table = _rows(source, lines, position, count)
        met = (table != 0).any(axis=1)
        missed += int((~met).sum())
        points.append(table[met] @ turn + shift)
        numbers.append(np.flatnonzero(met) + position + 1)
        position += count
    notes = [f"{len(points)} scans put together"] if len(points) > 1 else []
    if missed:
        notes.append(f"{missed} rays that met nothing left out")
    if not points:
        raise source.error("no measured points in the file")
    return source.measurement(
        "ptx", np.concatenate(points), np.concatenate(numbers), ball_radius=ball_radius, unit=unit, notes=notes
    )


def _head(source: Source, lines: list[str], position: int) -> tuple[int, Floats, Floats, int]:
    """Number of points of the scan that begins here, its turn (3, 3) and shift (3,), and where its points begin."""

    def count(at: int) -> int:
        text = lines[at].strip() if at < len(lines) else ""
        if not _COUNT.fullmatch(text):
            raise source.error(f"{shown(text)} is no number of points: lines are missing or too many", at + 1)
        return int(text)

    size = count(position)
    if position + 1 >= len(lines) or len(lines[position + 1].split()) != 1:
        return size, np.eye(3), np.zeros(3), position + 1
    size *= count(position + 1)
    pose = lines[position + 2 : position + 2 + _POSE]
    cells = [line.split() for line in pose]
    if [len(row) for row in cells] != [3] * 4 + [4] * 4 or not all(NUMBER.fullmatch(c) for row in cells for c in row):
        raise source.error("the head of a scan is not whole: four lines of three numbers, four of four", position + 3)
    matrix = np.array(cells[4:], dtype=np.float64)
    turn = matrix[:3, :3]
    with np.errstate(over="ignore", invalid="ignore"):
        proper = np.abs(turn @ turn.T - np.eye(3)).max() <= _ROTATION and np.linalg.det(turn) > 0
    if not proper or (matrix[:, 3] != (0, 0, 0, 1)).any():
        raise source.error("the matrix of a scan is no turn and shift", position + 7)
    return size, turn, matrix[3, :3], position + 2 + _POSE


def _rows(source: Source, lines: list[str], begin: int, count: int) -> Floats:
    """Coordinates (count, 3) of the points from a line on."""
    if begin + count > len(lines):
        raise source.error(
            f"{len(lines) - begin} points where {count} are announced: the file was cut off", max(begin, 1)
        )
    if not count:
        return np.zeros((0, 3))
    rows = lines[begin : begin + count]
    try:
        table = np.loadtxt(rows, comments=None, ndmin=2)
        if len(table) == count and table.shape[1] in _WIDTHS and np.isfinite(table).all():
            return table[:, :3].copy()
    except (ValueError, OverflowError):
        pass
    width = len(rows[0].split())
    for number, row in enumerate(rows, begin + 1):
        cells = row.split()
        spoilt = next((cell for cell in cells if not NUMBER.fullmatch(cell)), None)
        if spoilt is not None or len(cells) != width or width not in _WIDTHS:
            why = f"{shown(spoilt)} is no number" if spoilt else f"{len(cells)} numbers are no point: {shown(row)}"
            raise source.error(why, number)
    raise source.error("a number is too large", begin + 1)
