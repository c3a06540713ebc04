# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that a macro printed with DPRNT: a line of words a point, ``X   12.530Y    0.000Z   -5.000``.

DPRNT pads between letter and number, ends lines with CR alone, and a control may send DC2 and DC4 around it all.
N numbers the points, I J K are a normal. What the coordinates are is up to the macro that printed them.
"""

from __future__ import annotations

import re
from array import array

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_words
from .decoding import beginning, blocks_of
from .parts import SAME_PLACE, parts_by_place, parts_by_repetition, point_keys, rows_of_part
from .source import LONGEST_LINE, MM_PER_INCH, Source, shown

_WORD = re.compile(r"([XYZIJKN])[ \t]*=?[ \t]*([+-]?)[ \t]*((?:\d+\.?\d*|\.\d+))[ \t,;]*", re.ASCII)
_CONTROLS = b"\x00\x11\x12\x13\x14\x1a"
_HEADING = re.compile(r"[A-Z]{4,}.*|O\d+.*|\(.*\)|%|POPEN|PCLOS", re.ASCII)
_RECOGNISED = re.compile(
    rb"(?:N[ \t]*\d+\.?[ \t]*)?X[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[ \t,;]*Y[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[^GMFST]*"
)
_LARGEST = 1e9
_BLOCK = 1 << 16
"""Characters that are read in one go: a heading costs no more than these."""


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
    number = 1
    for piece in blocks_of(source.text(drop=_CONTROLS), _BLOCK):
        rows = piece.removesuffix("\n").split("\n")
        if not printed.alike(number, piece):
            for further, raw in enumerate(rows):
                if len(raw) > LONGEST_LINE:
                    raise source.error(
                        phrase("a line of {} characters: no print-out, or damaged", len(raw)), number + further
                    )
                printed.line(number + further, raw)
        number += len(rows)
    if not printed.places:
        raise source.error(phrase("no points in the file"))
    table, lines = np.frombuffer(printed.values).reshape(-1, 6), np.frombuffer(printed.places, dtype=np.int64)
    named, blocks = np.frombuffer(printed.numbers), np.frombuffer(printed.blocks, dtype=np.int64)
    chosen = rows_of_part(source, lines, _parts(source, table, named, blocks, lines))
    table, lines = table[chosen], lines[chosen]
    names = ["" if np.isnan(n) else f"N{n:g}" for n in named[chosen]]
    height, normals = table[:, 2], table[:, 3:]
    partly = np.flatnonzero(np.isnan(height) != np.isnan(height[:1]).any())
    if len(partly):
        raise source.error(phrase("Z stands in some lines and not in others"), int(lines[partly[0]]))
    has_z = not np.isnan(height).any()
    flat = np.isnan(normals[:, 2]) & ~np.isnan(normals[:, :2]).any(axis=1)
    normals[flat, 2] = 0.0
    missing = np.isnan(normals).any(axis=1)
    notes = [phrase("{} of {} points have no normal: normals are not used", int(missing.sum()), len(table))]
    return source.measurement(
        "dprnt", np.nan_to_num(table[:, :3]), lines, ball_radius=ball, unit=source.unit(None),
        normals=None if missing.any() else normals, elements=names if any(names) else None, has_z=has_z,
        notes=notes if missing.any() and not missing.all() else (),
    )  # fmt: skip


class _Printed:
    """What was read of a print-out: places, normals, numbers, and the block that headings set apart."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.values = array("d")
        self.places = array("q")
        self.numbers = array("d")
        self.blocks = array("q")
        self.block = 0

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
        table = np.full((len(values), 6), np.nan)
        for k, letter in enumerate("XYZIJK"):
            if letter in names:
                table[:, k] = values[:, names.index(letter)]
        numbers = values[:, names.index("N")] if "N" in names else np.full(len(values), np.nan)
        self.values.frombytes(table.tobytes())
        self.places.frombytes((number + np.arange(len(values), dtype=np.int64)).tobytes())
        self.numbers.frombytes(np.ascontiguousarray(numbers).tobytes())
        self.blocks.frombytes(np.full(len(values), self.block, dtype=np.int64).tobytes())
        return True

    def line(self, number: int, raw: str) -> None:
        """Take one line: a heading or a point."""
        text = raw.strip().upper()
        if not text or _HEADING.fullmatch(text):
            self.block += bool(text)
            return
        words = _words(self.source, number, text)
        for letter in "XY":
            if letter not in words:
                raise self.source.error(phrase("{} is missing: the line is incomplete", letter), number)
        self.values.extend([words.get(c, np.nan) for c in "XYZIJK"])
        self.places.append(number)
        self.blocks.append(self.block)
        self.numbers.append(words.get("N", np.nan))


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


def _parts(source: Source, table: Floats, numbers: Floats, blocks: Ints, lines: Ints) -> Ints:
    """Part of every point, from 0: by the numbers of the points, else by the places touched."""
    points = np.nan_to_num(table[:, :3]) * (MM_PER_INCH if source.unit(None) == "inch" else 1.0)
    if np.isnan(numbers).any():
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
