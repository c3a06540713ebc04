# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that a macro printed with DPRNT: a line of words a point, ``X   12.530Y    0.000Z   -5.000``.

DPRNT pads between letter and number, ends lines with CR alone, and a control may send DC2 and DC4 around it all.
N numbers the points, I J K are a normal. What the coordinates are is up to the macro that printed them.
"""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Set

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_words
from .decoding import beginning
from .names import Names
from .parts import SAME_PLACE, parts_by_place, parts_by_repetition, point_keys, rows_of_part
from .source import LONGEST_LINE, MM_PER_INCH, Source, shown

_WORD = re.compile(r"([XYZIJKN])[ \t]*=?[ \t]*([+-]?)[ \t]*((?:\d+\.?\d*|\.\d+))[ \t,;]*", re.ASCII)
_CONTROLS = b"\x00\x11\x12\x13\x14\x1a"
_HEADING = re.compile(r"[A-Z]{4,}.*|O\d+.*|\(.*\)|%|POPEN|PCLOS", re.ASCII)
_RECOGNISED = re.compile(
    rb"(?:N[ \t]*\d+\.?[ \t]*)?X[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[ \t,;]*Y[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[^GMFST]*"
)
_LARGEST = 1e9


def recognises(data: bytes) -> bool:
    """Whether every line of the beginning, headings apart, is made of X and Y words, and not of an NC program's."""
    head = beginning(data, 4096).translate(None, _CONTROLS).replace(b"\r", b"\n").upper()
    lines = [line.strip() for line in head.split(b"\n") if line.strip()]
    lines = lines[:-1] if len(data) > 4096 else lines
    rows = [line for line in lines if not _HEADING.fullmatch(line.decode("latin-1"))]
    return bool(rows) and all(_RECOGNISED.fullmatch(line) for line in rows)


def read(source: Source) -> Measurement:
    """Points of a DPRNT print-out.

    Parameters
    ----------
    source : Source
        Must say what the points are; the unit is mm unless it says otherwise.

    Returns
    -------
    Measurement
        Without z where no line has one; normals where every line has one.

    Raises
    ------
    FormatError
        If a line is neither a heading nor a point, or a point is there twice; names the line.
    UsageError
        If the caller does not say what the points are, or which of several parts.
    """
    ball = source.ball_radius()
    printed = _Printed(source)
    for number, piece in source.pieces(drop=_CONTROLS):
        if printed.alike(number, piece):
            continue
        for further, raw in enumerate(piece.split("\n")):
            if len(raw) > LONGEST_LINE:
                raise source.error(
                    phrase("a line of {} characters: no print-out, or damaged", len(raw)), number + further
                )
            printed.line(number + further, raw)
    if not printed.lines:
        raise source.error(phrase("no points in the file"))
    lines, named, blocks = np.frombuffer(printed.lines, dtype=np.int64), printed.column("N"), printed.blocks()
    points, normals = printed.vectors("XYZ"), printed.vectors("IJK")
    assert points is not None
    chosen = rows_of_part(source, lines, _parts(source, points, named, blocks, lines))
    del blocks
    if not chosen.all():
        points, lines = points[chosen], lines[chosen]
        named = None if named is None else named[chosen]
        normals = None if normals is None else normals[chosen]
    height = points[:, 2]
    partly = np.flatnonzero(np.isnan(height) != np.isnan(height[:1]).any())
    if len(partly):
        raise source.error(phrase("Z stands in some lines and not in others"), int(lines[partly[0]]))
    has_z = not np.isnan(height).any()
    if not has_z:
        height[:] = 0.0
    missing = len(points)
    if normals is not None:
        flat = np.isnan(normals[:, 2]) & ~np.isnan(normals[:, :2]).any(axis=1)
        normals[flat, 2] = 0.0
        missing = int(np.isnan(normals).any(axis=1).sum())
    notes = [phrase("{} of {} points have no normal: normals are not used", missing, len(points))]
    names = None
    if named is not None and not np.isnan(named).all():
        names = Names("" if n != n else f"N{n:g}" for n in named)
    return source.measurement(
        "dprnt", points, lines, ball_radius=ball, unit=source.unit(None),
        normals=None if missing else normals, elements=names, has_z=has_z,
        notes=notes if 0 < missing < len(points) else (),
    )  # fmt: skip


class _Printed:
    """What was read of a print-out: a column a letter, lines, and where headings set blocks apart."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.columns: dict[str, array[float]] = {}
        """Numbers by their letter, NaN where a point has none; of letters that stand in the file."""
        self.lines = array("q")
        self.headings: list[int] = []
        """Points above each heading."""

    def alike(self, number: int, lines: str) -> bool:
        """Take points, the first in line `number`, that all have the same letters; False where they are not so."""
        words = decimal_words(lines.upper())
        if words is None:
            return False
        width = int(words.first[1])
        if not width or (np.diff(words.first) != width).any():
            return False
        letters, values = words.letters.reshape(-1, width), words.values.reshape(-1, width)
        names = letters[0].tobytes().decode("ascii")
        if (letters != letters[0]).any() or len(set(names)) < width or not {"X", "Y"} <= set(names) <= set("XYZIJKN"):
            return False
        if (np.abs(values) > _LARGEST).any():
            return False
        self._open(set(names))
        nothing = np.full(len(values), math.nan)
        for letter, column in self.columns.items():
            column.frombytes((values[:, names.index(letter)] if letter in names else nothing).tobytes())
        self.lines.frombytes((number + np.arange(len(values), dtype=np.int64)).tobytes())
        return True

    def line(self, number: int, raw: str) -> None:
        """Take one line: a heading or a point."""
        text = raw.strip().upper()
        if not text or _HEADING.fullmatch(text):
            if text and (not self.headings or self.headings[-1] < len(self.lines)):
                self.headings.append(len(self.lines))
            return
        words = _words(self.source, number, text)
        for letter in "XY":
            if letter not in words:
                raise self.source.error(phrase("{} is missing: the line is incomplete", letter), number)
        self._open(words.keys())
        for letter, column in self.columns.items():
            column.append(words.get(letter, math.nan))
        self.lines.append(number)

    def _open(self, letters: Set[str]) -> None:
        """Begin columns of letters that come for the first time."""
        for letter in letters - self.columns.keys():
            self.columns[letter] = array("d", (math.nan,)) * len(self.lines)

    def column(self, letter: str) -> Floats | None:
        """Numbers behind a letter, (n,), NaN where there is none; None where it stands nowhere."""
        return np.frombuffer(self.columns[letter]) if letter in self.columns else None

    def vectors(self, letters: str) -> Floats | None:
        """Numbers behind three letters, (n, 3), no longer kept here; None where none of them stands anywhere."""
        if not self.columns.keys() & set(letters):
            return None
        table = np.full((len(self.lines), 3), math.nan)
        for k, letter in enumerate(letters):
            if letter in self.columns:
                table[:, k] = self.columns.pop(letter)
        return table

    def blocks(self) -> Ints:
        """Block of each point, (n,), from 0."""
        sizes = np.diff(np.array([0, *self.headings, len(self.lines)]))
        return np.repeat(np.arange(len(sizes)), sizes)


def _words(source: Source, number: int, text: str) -> dict[str, float]:
    words: dict[str, float] = {}
    position = 0
    while position < len(text):
        found = _WORD.match(text, position)
        if found is None:
            raise source.error(phrase("{} is no word of a printed point", shown(text[position:])), number)
        if found[1] in words:
            raise source.error(phrase("the letter {} is there twice: two lines ran together", found[1]), number)
        words[found[1]] = float(found[2] + found[3])
        if abs(words[found[1]]) > _LARGEST:
            raise source.error(phrase("{}{} is no coordinate", found[1], shown(found[3])), number)
        position = found.end()
    return words


def _parts(source: Source, points: Floats, numbers: Floats | None, blocks: Ints, lines: Ints) -> Ints:
    """Part of every point, from 0: by the numbers of the points, else by the places touched."""
    if np.isnan(points[:, 2]).any():
        points = np.nan_to_num(points)
    if source.unit(None) == "inch":
        points = points * MM_PER_INCH
    if numbers is None or np.isnan(numbers).any():
        return parts_by_place(points)
    # Numbers that begin again can be another contour's: only the same place shows the same point.
    keys = point_keys(numbers, points, SAME_PLACE)
    part_of, twice = parts_by_repetition(keys, blocks + np.cumsum(numbers == numbers[0]))
    if twice is not None:
        first, again = twice
        raise source.error(
            phrase(
                "point N{:g} is there twice, first in line {}: keep one of them, or give every point a "
                "number of its own",
                numbers[again],
                lines[first],
            ),
            int(lines[again]),
        )
    return part_of
