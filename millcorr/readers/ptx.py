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
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_tables
from .decoding import beginning
from .fields import NUMBER
from .source import LONGEST_LINE, Source, shown

_WIDTHS = (3, 4, 6, 7)
_POSE = 8
"""Lines of a PTX scan between the size of its grid and its points."""
_ROTATION = 1e-3
"""Rows of the matrix that turns are unit vectors at right angles to within this."""
_BLOCK = 1 << 18
_NEWLINE = 10
_BLANKS = b" \t\n\v\f\r\x1c\x1d\x1e\x1f"
"""What `str.strip` takes for blanks."""
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
    lines = _Lines(source)
    points: list[Floats] = []
    numbers: list[Ints] = []
    position = missed = 0
    while position < len(lines):
        count, turn, shift, position = _head(source, lines, position)
        table = _rows(source, lines, position, count)
        met = np.flatnonzero(table.any(axis=1))
        if len(met) < count:
            missed += count - len(met)
            table = table[met]
        if (turn != np.eye(3)).any() or shift.any():
            table = table @ turn
            table += shift
        points.append(table)
        met += position + 1
        numbers.append(met)
        position += count
    notes = [phrase("{} scans put together", len(points))] if len(points) > 1 else []
    if missed:
        notes.append(phrase("{} rays that met nothing left out", missed))
    if not points:
        raise source.error(phrase("no measured points in the file"))
    one = len(points) == 1
    return source.measurement(
        "ptx", points[0] if one else np.concatenate(points), numbers[0] if one else np.concatenate(numbers),
        ball_radius=ball_radius, unit=unit, notes=notes,
    )  # fmt: skip


class _Lines:
    """Lines of a file by their number from 0, without cutting it up; blank ones at its end do not count."""

    def __init__(self, source: Source) -> None:
        self.data = source.plain()
        end = len(self.data)
        while end and self.data[end - 1] in _BLANKS:
            end -= 1
        ends = [
            begin + np.flatnonzero(np.frombuffer(self.data, np.uint8)[begin : min(begin + _BLOCK, end)] == _NEWLINE)
            for begin in range(0, end, _BLOCK)
        ]
        self._ends: Ints = np.concatenate([[-1], *ends, [end]])
        longest = int(np.diff(self._ends).argmax())
        if len(self[longest]) > LONGEST_LINE:
            raise source.too_long(len(self[longest]), longest + 1)

    def __len__(self) -> int:
        return len(self._ends) - 1 if self._ends[-1] else 0

    def __getitem__(self, number: int) -> str:
        return self.data[self._ends[number] + 1 : self._ends[number + 1]].decode("utf-8", "surrogatepass")

    def span(self, first: int, last: int) -> tuple[int, int]:
        """Where in the data lines begin and end, from one to before another."""
        return int(self._ends[first]) + 1, int(self._ends[last])


def _head(source: Source, lines: _Lines, position: int) -> tuple[int, Floats, Floats, int]:
    """Number of points of the scan that begins here, its turn (3, 3) and shift (3,), and where its points begin."""

    def count(at: int) -> int:
        text = lines[at].strip() if at < len(lines) else ""
        if not _COUNT.fullmatch(text):
            raise source.error(phrase("{} is no number of points: lines are missing or too many", shown(text)), at + 1)
        return int(text)

    size = count(position)
    if position + 1 >= len(lines) or len(lines[position + 1].split()) != 1:
        return size, np.eye(3), np.zeros(3), position + 1
    size *= count(position + 1)
    cells = [lines[at].split() for at in range(position + 2, min(position + 2 + _POSE, len(lines)))]
    if [len(row) for row in cells] != [3] * 4 + [4] * 4 or not all(NUMBER.fullmatch(c) for row in cells for c in row):
        raise source.error(
            phrase("the head of a scan is not whole: four lines of three numbers, four of four"), position + 3
        )
    matrix = np.array(cells[4:], dtype=np.float64)
    turn = matrix[:3, :3]
    with np.errstate(over="ignore", invalid="ignore"):
        proper = np.abs(turn @ turn.T - np.eye(3)).max() <= _ROTATION and np.linalg.det(turn) > 0
    if not proper or (matrix[:, 3] != (0, 0, 0, 1)).any():
        raise source.error(phrase("the matrix of a scan is no turn and shift"), position + 7)
    return size, turn, matrix[3, :3], position + 2 + _POSE


def _rows(source: Source, lines: _Lines, begin: int, count: int) -> Floats:
    """Coordinates (count, 3) of the points from a line on."""
    if begin + count > len(lines):
        raise source.error(
            phrase("{} points where {} are announced: the file was cut off", len(lines) - begin, count), max(begin, 1)
        )
    if not count:
        return np.zeros((0, 3))
    first, last = lines.span(begin, begin + count)
    width = len(lines[begin].split())
    if width in _WIDTHS:
        # All fields are numbers, though three are wanted; blank lines would be missing rays.
        found = decimal_tables(lines.data, None, width, [range(3), range(3, width)], begin=first, end=last)
        if found is not None and len(found[1]) == count and all(np.isfinite(table).all() for table in found[0]):
            return found[0][0]
    for at in range(begin, begin + count):
        row, number = lines[at], at + 1
        cells = row.split()
        spoilt = next((cell for cell in cells if not NUMBER.fullmatch(cell)), None)
        if spoilt is not None or len(cells) != width or width not in _WIDTHS:
            why = (
                phrase("{} is no number", shown(spoilt))
                if spoilt
                else phrase("{} numbers are no point: {}", len(cells), shown(row))
            )
            raise source.error(why, number)
    raise source.error(phrase("a number is too large"), begin + 1)
