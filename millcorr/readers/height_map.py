# SPDX-License-Identifier: LGPL-2.1-or-later
"""Height maps that senders probe for levelling: bCNC's ``.probe`` and OpenCNCPilot's XML.

bCNC writes three lines, ``xmin xmax xn``, ``ymin ymax yn`` and ``zmin zmax feed``, and then x y z of the grid, x
first. OpenCNCPilot writes the corners and the size of the grid as attributes of ``heightmap`` and every height in a
``point`` with its place in the grid. Both are where the tip of a tool stood that came down along Z.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_columns
from .decoding import beginning
from .fields import NUMBER
from .source import Source, shown, slices
from .xml_events import Element, parse

NOTE = phrase("a height map, touched along Z: it shows the height of a surface and nothing of a contour")

_LARGEST = 1e9
_MOST = 1_000_000
"""More places than this along a side has no grid."""
_DIGITS = 1e-5
"""bCNC prints six digits: places miss their grid by this share of the largest coordinate."""
_SIZES = ("MinX", "MinY", "MaxX", "MaxY", "SizeX", "SizeY")
_ROOT = re.compile(rb"<heightmap[\s>]")


def recognises(data: bytes) -> bool:
    """Whether a file is the XML of a height map, or begins with the three lines of one and its first place."""
    head = beginning(data, 4096)
    if _ROOT.search(head):
        return True
    rows = [line.split() for line in head.decode("latin-1").splitlines() if line.strip()][:4]
    if len(rows) < 4 or not all(len(row) == 3 and all(NUMBER.fullmatch(field) for field in row) for row in rows):
        return False
    (left, right, across), (low, high, along), _, (x, y, _) = ([float(field) for field in row] for row in rows)
    whole = all(n == int(n) and 2 <= n <= _MOST for n in (across, along))
    return whole and left < right and low < high and (x, y) == (left, low)


def read(source: Source) -> Measurement:
    """Heights of a map.

    Parameters
    ----------
    source : Source
        The file says that its points are places of the tip; its unit is mm unless the caller says otherwise.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a number is spoilt, or a place is not on the grid that the head announces; names the line.
    UsageError
        If the caller contradicts the file.
    """
    if _ROOT.search(beginning(source.data, 4096)):
        document = _Map(source)
        parse(source, "heightmap", document.root)
        document.refuse_repeated()
        points = np.array(document.points).reshape(-1, 3)
        lines, announced = np.array(document.lines, dtype=np.int64), document.size[0] * document.size[1]
    else:
        points, lines, announced = _rows(source)
    if not len(points):
        raise source.error(phrase("no height in the map: it was not probed yet"))
    notes = [NOTE]
    if len(points) < announced:
        notes.append(phrase("{} of {} places were not touched", announced - len(points), announced))
    return source.measurement(
        "height-map", points, lines, ball_radius=source.ball_radius(centres=False), unit=source.unit(None),
        notes=notes,
    )  # fmt: skip


def _number(source: Source, text: str, line: int) -> float:
    text = text.strip()
    if not NUMBER.fullmatch(text) or not abs(float(text)) < _LARGEST:
        raise source.error(phrase("{} is no coordinate", shown(text)), line)
    return float(text)


def _counts(source: Source, numbers: Sequence[float], line: int) -> tuple[int, int]:
    if not all(n == int(n) and 2 <= n <= _MOST for n in numbers):
        raise source.error(phrase("{:g} by {:g} places are no grid", numbers[0], numbers[1]), line)
    return int(numbers[0]), int(numbers[1])


def _rows(source: Source) -> tuple[Floats, Ints, int]:
    """Points (n, 3), their lines, and how many places bCNC's head announces."""
    whole = decimal_columns(source.plain(), None, 3, (0, 1, 2))
    if whole is not None and max(whole[0].max(), -whole[0].min()) < _LARGEST:
        return _on_grid(source, *whole)
    values, lines = array("d"), array("q")
    for number, line in source.lines():
        fields = line.split()
        if not fields:
            continue
        if len(fields) != 3:
            raise source.error(phrase("{} numbers where a height map has three in a line", len(fields)), number)
        values.extend([_number(source, field, number) for field in fields])
        lines.append(number)
    return _on_grid(source, np.array(values).reshape(-1, 3), np.array(lines, dtype=np.int64))


def _on_grid(source: Source, table: Floats, lines: Ints) -> tuple[Floats, Ints, int]:
    """Points, lines and places of a map whose numbers, (n, 3), have been read."""
    if len(table) < 3:
        raise source.error(phrase("a height map begins with three lines: x and y from, to and how many, and z"))
    (left, right, _), (low, high, _) = table[:2].tolist()
    across, along = _counts(source, table[:2, 2].tolist(), int(lines[1]))
    points, own = table[3:], lines[3:]
    if len(points) > across * along:
        raise source.error(phrase("more than the {} places of the grid", across * along), int(own[across * along]))
    close = _DIGITS * np.abs(table[:2, :2]).max()
    for rows in slices(points):
        place = np.arange(rows.start, rows.start + len(points[rows]))
        wrong = np.zeros(len(place), dtype=bool)
        for k, (begin, end, count, number) in enumerate(
            ((left, right, across, place % across), (low, high, along, place // across))
        ):
            wrong |= np.abs(points[rows, k] - (begin + (end - begin) / (count - 1) * number)) > close
        off = rows.start + np.flatnonzero(wrong)
        if not len(off):
            continue
        x, y = points[off[0], :2]
        along_y, along_x = divmod(int(off[0]), across)
        wanted_x, wanted_y = left + (right - left) * along_x / (across - 1), low + (high - low) * along_y / (along - 1)
        raise source.error(
            phrase("X{:g} Y{:g} where the grid has X{:g} Y{:g}: lines are missing", x, y, wanted_x, wanted_y),
            int(own[off[0]]),
        )
    return points, own, across * along


class _Map:
    """OpenCNCPilot's document; `root` says what is done with its elements."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.points = array("d")
        self.lines = array("q")
        self.size = (0, 0)
        self.corners = (0.0, 0.0, 0.0, 0.0)
        self.place = (0, 0)
        self.places = array("q")
        self.point = Element(begin=self._open_point, text=self._take_height)
        others = Element(lambda name: self.point if name == "point" else others)
        self.root = Element(others.inside, begin=self._open_map)

    def _open_map(self, attributes: dict[str, str], line: int) -> None:
        numbers = [_number(self.source, attributes.get(name, ""), line) for name in _SIZES]
        self.size = _counts(self.source, numbers[4:], line)
        self.corners = (numbers[0], numbers[1], numbers[2], numbers[3])

    def _open_point(self, attributes: dict[str, str], line: int) -> None:
        i, j = (_number(self.source, attributes.get(name, ""), line) for name in "XY")
        self.place = int(i), int(j)
        if (i, j) != self.place or not (0 <= i < self.size[0] and 0 <= j < self.size[1]):
            raise self.source.error(phrase("point {:g}, {:g} is not on the grid", i, j), line)
        self.places.append(self.place[0] + self.size[0] * self.place[1])

    def refuse_repeated(self) -> None:
        """FormatError where a place of the grid is there twice; names the second line."""
        order = np.argsort(self.places, kind="stable")
        placed = np.array(self.places)[order]
        again = order[1:][placed[1:] == placed[:-1]]
        if len(again):
            row = int(again.min())
            j, i = divmod(self.places[row], self.size[0])
            raise self.source.error(
                phrase("point {}, {} is there twice", i, j), self.lines[row] if row < len(self.lines) else None
            )

    def _take_height(self, content: str) -> None:
        line = self.point.line
        left, low, right, high = self.corners
        x = left + (right - left) * self.place[0] / (self.size[0] - 1)
        y = low + (high - low) * self.place[1] / (self.size[1] - 1)
        self.points.extend((x, y, _number(self.source, content, line)))
        self.lines.append(line)
