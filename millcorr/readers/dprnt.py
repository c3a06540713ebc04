# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that a macro printed with DPRNT: a line of words a point, ``X   12.530Y    0.000Z   -5.000``.

DPRNT pads between letter and number, ends lines with CR alone, and a control may send DC2 and DC4 around it all.
N numbers the points, I J K are a normal. What the coordinates are is up to the macro that printed them.
"""

from __future__ import annotations

import re
from array import array

import numpy as np
from numpy.typing import NDArray

from millcorr.measurement import Measurement

from .decoding import beginning
from .parts import SAME_PLACE, parts_by_place, parts_by_repetition, point_keys, rows_of_part
from .source import MM_PER_INCH, Source, shown

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

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
    values, places, numbers, blocks = array("d"), array("q"), array("d"), array("q")
    block = 0
    for line, raw in source.lines(drop=_CONTROLS):
        text = raw.strip().upper()
        if not text or _HEADING.fullmatch(text):
            block += bool(text)
            continue
        words = _words(source, line, text)
        for letter in "XY":
            if letter not in words:
                raise source.error(f"{letter} is missing: the line is incomplete", line)
        values.extend([words.get(c, np.nan) for c in "XYZIJK"])
        places.append(line)
        blocks.append(block)
        numbers.append(words.get("N", np.nan))
    if not places:
        raise source.error("no points in the file")
    table, lines, named = np.array(values).reshape(-1, 6), np.array(places), np.array(numbers)
    chosen = rows_of_part(source, lines, _parts(source, table, named, np.array(blocks), lines))
    table, lines = table[chosen], lines[chosen]
    names = ["" if np.isnan(n) else f"N{n:g}" for n in named[chosen]]
    height, normals = table[:, 2], table[:, 3:]
    partly = np.flatnonzero(np.isnan(height) != np.isnan(height[:1]).any())
    if len(partly):
        raise source.error("Z stands in some lines and not in others", int(lines[partly[0]]))
    has_z = not np.isnan(height).any()
    flat = np.isnan(normals[:, 2]) & ~np.isnan(normals[:, :2]).any(axis=1)
    normals[flat, 2] = 0.0
    missing = np.isnan(normals).any(axis=1)
    notes = [f"{int(missing.sum())} of {len(table)} points have no normal: normals are not used"]
    return source.measurement(
        "dprnt", np.nan_to_num(table[:, :3]), lines, ball_radius=ball, unit=source.unit(None),
        normals=None if missing.any() else normals, elements=names if any(names) else None, has_z=has_z,
        notes=notes if missing.any() and not missing.all() else (),
    )  # fmt: skip


def _words(source: Source, number: int, text: str) -> dict[str, float]:
    words: dict[str, float] = {}
    position = 0
    while position < len(text):
        found = _WORD.match(text, position)
        if found is None:
            raise source.error(f"{shown(text[position:])} is no word of a printed point", number)
        if found[1] in words:
            raise source.error(f"the letter {found[1]} is there twice: two lines ran together", number)
        words[found[1]] = float(found[2] + found[3])
        if abs(words[found[1]]) > _LARGEST:
            raise source.error(f"{found[1]}{shown(found[3])} is no coordinate", number)
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
            f"point N{numbers[again]:g} is there twice, first in line {lines[first]}: keep one of them, or give every "
            "point a number of its own",
            int(lines[again]),
        )
    return part_of
