# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that a macro printed with DPRNT: a line of words a point, ``X   12.530Y    0.000Z   -5.000``.

DPRNT pads between letter and number, ends lines with CR alone, and a control may send DC2 and DC4 around it all.
N numbers the points, I J K are a normal. What the coordinates are is up to the macro that printed them.
"""

from __future__ import annotations

import re
from array import array

import numpy as np

from millcorr.measurement import Measurement

from .source import Source, shown

_WORD = re.compile(r"([XYZIJKN])[ \t]*=?[ \t]*([+-]?)[ \t]*((?:\d+\.?\d*|\.\d+))[ \t,;]*", re.ASCII)
_CONTROLS = b"\x00\x11\x12\x13\x14\x1a"
_HEADING = re.compile(r"[A-Z]{4,}.*|O\d+.*|\(.*\)|%|POPEN|PCLOS", re.ASCII)
_RECOGNISED = re.compile(
    rb"(?:N[ \t]*\d+\.?[ \t]*)?X[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[ \t,;]*Y[ \t]*=?[ \t]*[+-]?[ \t]*[\d.]+[^GMFST]*"
)
_LARGEST = 1e9


def recognises(data: bytes) -> bool:
    """Whether every line of the beginning, headings apart, is made of X and Y words, and not of an NC program's."""
    head = data[:4096].translate(None, _CONTROLS).lstrip(b"\xef\xbb\xbf").replace(b"\r", b"\n").upper()
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
        If a line is neither a heading nor a point; names the line.
    UsageError
        If the caller does not say what the points are.
    """
    ball = source.ball_radius()
    values, lines, names = array("d"), array("q"), []
    for number, raw in source.lines(drop=_CONTROLS):
        text = raw.strip().upper()
        if not text or _HEADING.fullmatch(text):
            continue
        words = _words(source, number, text)
        for letter in "XY":
            if letter not in words:
                raise source.error(f"{letter} is missing: the line is incomplete", number)
        values.extend([words.get(c, np.nan) for c in "XYZIJK"])
        lines.append(number)
        names.append(f"N{words['N']:g}" if "N" in words else "")
    table = np.array(values, dtype=np.float64).reshape(-1, 6)
    height, normals = table[:, 2], table[:, 3:]
    partly = np.flatnonzero(np.isnan(height) != np.isnan(height[:1]).any())
    if len(partly):
        raise source.error("Z stands in some lines and not in others", lines[partly[0]])
    has_z = not np.isnan(height).any()
    flat = np.isnan(normals[:, 2]) & ~np.isnan(normals[:, :2]).any(axis=1)
    normals[flat, 2] = 0.0
    missing = np.isnan(normals).any(axis=1)
    notes = [f"{int(missing.sum())} of {len(table)} points have no normal: normals are not used"]
    return source.measurement(
        "dprnt", np.nan_to_num(table[:, :3]), np.array(lines), ball_radius=ball, unit=source.unit(None),
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
