# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans saved as STL: the corners of the mesh are the points, and the facets round a corner give its normal.

Binary: a head of 80 bytes, the count of facets, and for each its normal, three corners and two bytes, little endian
32-bit numbers. ASCII: ``solid``, ``facet normal``, ``outer loop``, three ``vertex``. The normals written in the file
are not used: the corners of a facet run anticlockwise seen from outside, which says the same and is never left blank.
"""

from __future__ import annotations

import re

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decoding import beginning, decode
from .source import Source, shown

_HEAD = 84
_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_ASCII = re.compile(rb"\s*solid\b[^\r\n]*[\r\n]+\s*facet\s+normal\b", re.IGNORECASE)
_NUMBER = r"([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)"
_WORDS = re.compile(
    r"\s*facet\s+normal(?:\s+\S{1,40}){3}\s+outer\s+loop"
    + rf"\s+vertex\s+{_NUMBER}\s+{_NUMBER}\s+{_NUMBER}" * 3
    + r"\s+endloop\s+endfacet",
    re.IGNORECASE | re.ASCII,
)
_BETWEEN = re.compile(r"\s*endsolid\b[^\n]*(?:\n\s*solid\b[^\n]*)?", re.IGNORECASE)
"""End of a solid, and the head of a further one."""
_SHARP = 0.05
"""Where the facets round a corner cancel to less than this share of their area there is no normal: a sliver's tip."""


def recognises(data: bytes) -> bool:
    """Whether a file is an STL mesh: facets in words, or a head with a count and bytes for so many."""
    if _ASCII.match(beginning(data, 4096)):
        return True
    if len(data) <= _HEAD:
        return False
    return len(data) == _HEAD + _FACET.itemsize * int.from_bytes(data[80:_HEAD], "little")


def read(source: Source) -> Measurement:
    """Corners of a mesh with their normals, each corner once.

    Parameters
    ----------
    source : Source
        Must say what the points are; the unit is mm unless it says otherwise.

    Returns
    -------
    Measurement
        Its lines are the numbers of the facets, from 1, in which the corners come first.

    Raises
    ------
    FormatError
        If the file is damaged, cut off or holds no facets.
    UsageError
        If the caller does not say what the points are.
    """
    ball_radius, unit = source.ball_radius(), source.unit(None)
    corners = facets(source)
    binary = not _ASCII.match(beginning(source.data, 4096))
    step = float(np.spacing(np.float32(np.abs(corners).max(initial=0.0)))) if binary else 0.0
    points, normals, lines, lost = _joined(corners)
    notes = [
        phrase("the {} corners of a mesh of {} facets are taken as points, with its normals", len(points), len(corners))
    ]
    if lost:
        notes.append(phrase("{} corners without a normal left out", lost))
    if step:
        notes.append(phrase("coordinates are stored in steps of {:.2g} {}, at the farthest", step, unit))
    return source.measurement(
        "stl", points, lines, ball_radius=ball_radius, unit=unit, normals=normals if len(points) else None, notes=notes
    )


def facets(source: Source) -> Floats:
    """Corners of the facets in the file's unit, (n, 3, 3), anticlockwise seen from outside.

    Raises
    ------
    FormatError
        If the file is damaged or cut off.
    """
    if _ASCII.match(beginning(source.data, 4096)):
        corners = _of_words(source)
    elif recognises(source.data):
        corners = np.frombuffer(source.data, _FACET, offset=_HEAD)["corners"].astype(np.float64)
    else:
        raise source.error(phrase("no STL file, or one that was cut off: its size does not fit its count of facets"))
    whole = np.isfinite(corners).all(axis=(1, 2))
    if not whole.all():
        raise source.error(phrase("a corner is no place"), int(np.flatnonzero(~whole)[0]) + 1)
    return corners


def _of_words(source: Source) -> Floats:
    """Corners (n, 3, 3) of the facets of an ASCII file."""
    text = decode(source.data, source.name)
    position = text.index("\n") + 1
    values: list[tuple[str, ...]] = []
    while True:
        found = _WORDS.match(text, position)
        if found is not None:
            values.append(found.groups())
        else:
            found = _BETWEEN.match(text, position)
            if found is None:
                break
        position = found.end()
    rest = text[position:].strip()
    if rest or not re.search(r"endsolid\b[^\n]*\s*$", text[-4096:], re.IGNORECASE):
        line = text.count("\n", 0, position) + 1
        raise source.error(
            phrase("{} is no whole facet: damaged or cut off", shown(rest[:60]) if rest else phrase("the end")), line
        )
    return np.array(values, dtype=np.float64).reshape(-1, 3, 3)


def _joined(corners: Floats) -> tuple[Floats, Floats, Ints, int]:
    """Places, normals and first facets of the corners, each place once, and how many have no normal."""
    flat = np.ascontiguousarray(corners.reshape(-1, 3)) + 0.0
    keys = flat.view([("", flat.dtype)] * 3).ravel()
    _, first, group = np.unique(keys, return_index=True, return_inverse=True)
    with np.errstate(over="ignore", invalid="ignore"):
        facets = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        sums = np.column_stack([np.bincount(group, facets[:, c].repeat(3)) for c in range(3)])
        area = np.bincount(group, np.linalg.norm(facets, axis=1).repeat(3))
        length = np.linalg.norm(sums, axis=1)
        kept = np.flatnonzero((length > _SHARP * area) & np.isfinite(length))
    # In the order of the file.
    kept = kept[np.argsort(first[kept])]
    normals = sums[kept] / length[kept, None]
    return flat[first[kept]], normals, first[kept] // 3 + 1, len(first) - len(kept)
