# SPDX-License-Identifier: LGPL-2.1-or-later
"""PC-DMIS ``.xyz`` files: ``XYZIJK`` in the first line, rows of three to eight numbers below it.

Columns 1 to 6 of the first line hold ``XYZIJK``, columns 11 to 16 ``METRIC``; without it the unit is inch. Three or
five numbers in a row are a point, six or eight a point with its normal, four and seven a circle with its diameter
(PC-DMIS 2019 Core manual, "Notes on XYZ Files" and "Importing an XYZ File as CAD Data").
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import unsaid
from millcorr.messages import phrase, remedy
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_columns
from .source import Source, shown

_HEADER = re.compile(rb"^(?:\xef\xbb\xbf)?XYZIJK(?![A-Za-z])")
_SEPARATOR = re.compile(r"[ \t]*[,;][ \t]*|[ \t]+")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_FIRST_ROW = re.compile(r"^.*\S.*$", re.MULTILINE)
_NAME = re.compile(r"^[ \t]*([^\W\d_][^ \t,;\n]*)[ \t]*[ \t,;]", re.MULTILINE)
"""In front of the numbers of a row, as `_SEPARATOR` takes it off."""
_POINT, _VECTOR_POINT, _CIRCLE = (3, 5), (6, 8), (4, 7)
_METRIC_COLUMNS = slice(10, 16)


def recognises(data: bytes) -> bool:
    """Whether the first line begins with XYZIJK."""
    return bool(_HEADER.match(data) or _HEADER.match(data[:64].lstrip(b"\xff\xfe").replace(b"\x00", b"")))


def read(source: Source) -> Measurement:
    """Points of a PC-DMIS XYZ file.

    Parameters
    ----------
    source : Source
        The file does not say whether its points are contact points.

    Returns
    -------
    Measurement
        Normals where every row has one.

    Raises
    ------
    FormatError
        If a row is no point or circle; names the line.
    UsageError
        If METRIC does not stand where it must and the caller gives no unit, or the caller contradicts the file.
    """
    text = source.text()
    head = text[: text.index("\n")] if "\n" in text else text
    if not head.startswith("XYZIJK"):
        raise source.error(phrase("the first line does not begin with XYZIJK"), 1)
    unit = _unit(source, head)
    begin = len(head) + 1
    values, numbers, names, circles = _whole(text, begin) or _row_by_row(source, text[begin:].split("\n"))
    del text  # As large as the file.
    notes = [phrase("{} circles left out: rows of 4 or 7 numbers are no points", circles)] if circles else []
    if "METRIC" not in head and source.units is None:
        notes.append(
            phrase(
                "no METRIC in the first line: taken for inch, as PC-DMIS does; {} says otherwise", remedy("units", "mm")
            )
        )
    if not len(values):
        raise source.error(phrase("no points in the file{}", phrase(", only circles") if circles else ""), 1)
    normals = values[:, 3:]
    with_normal = np.full(len(values), normals.size > 0) & ~np.isnan(normals).any(axis=1)
    if with_normal.any() and not with_normal.all():
        notes.append(
            phrase("{} of {} points have no normal: normals are not used", int((~with_normal).sum()), len(values))
        )
    return source.measurement(
        "xyzijk", values[:, :3], numbers, ball_radius=source.ball_radius(), unit=unit,
        normals=normals if with_normal.all() else None, elements=names, notes=notes,
    )  # fmt: skip


def _unit(source: Source, head: str) -> str:
    rest = head[6:].strip()
    if rest == "METRIC" and head[_METRIC_COLUMNS] == "METRIC":
        return source.unit("mm")
    if not rest:
        # Without METRIC PC-DMIS takes inch, but the file does not say so.
        return source.unit(None, "inch", phrase("no METRIC in the first line, which PC-DMIS takes for inch"))
    if rest != "METRIC":
        raise source.error(phrase("{} behind XYZIJK: only METRIC may stand there, in columns 11 to 16", shown(rest)), 1)
    if source.units is None:
        raise unsaid(
            phrase(
                "METRIC stands in column {} of {}, not 11, where PC-DMIS takes the file for inch",
                head.index("METRIC") + 1,
                source.name,
            ),
            remedy("units", "mm"),
            remedy("units", "inch"),
        )
    return source.unit(None)


_Rows = tuple[Floats, Ints, Sequence[str] | None, int]
"""Numbers x,y,z,i,j,k with NaN where there is no normal, or x,y,z where no row has one; line numbers, names if
any, count of circles."""


def _whole(text: str, begin: int) -> _Rows | None:
    """Rows in one go where all have the same three or six numbers; None where anything is otherwise."""
    found = _FIRST_ROW.search(text, begin)
    if found is None:
        return None
    first = found[0].strip()
    separator = "," if "," in first else None
    named = int(first[0].isalpha())
    width = len(first.split(separator)) - named
    if width not in (3, 6):
        return None
    table = decimal_columns(text, separator, named + width, range(named, named + width), begin=begin, first=2)
    if table is None or not np.isfinite(table[0]).all():
        return None
    values, numbers = table
    names = _NAME.findall(text, begin) if named else None
    if names is not None and len(names) != len(values):
        return None
    return values, numbers, names, 0


def _row_by_row(source: Source, lines: list[str]) -> _Rows:
    """Rows one by one: for mixed rows and names before the numbers, and to name the line that is wrong."""
    values, numbers, names, circles = array("d"), array("q"), [], 0
    for number, line in enumerate(lines, 2):
        fields = _SEPARATOR.split(line.strip())
        if fields and fields[-1] == "":
            fields.pop()
        if not fields:
            continue
        name = "" if _NUMBER.fullmatch(fields[0]) else fields.pop(0)
        if name and not name[0].isalpha():
            raise source.error(phrase("{} is no number", shown(name)), number)
        if not all(map(_NUMBER.fullmatch, fields)):
            wrong = next(field for field in fields if not _NUMBER.fullmatch(field))
            raise source.error(phrase("{} is no number", shown(wrong)), number)
        if len(fields) in _CIRCLE:
            circles += 1
            continue
        if len(fields) not in _POINT + _VECTOR_POINT:
            raise source.error(phrase("{} numbers: a point has 3, or 6 with its normal", len(fields)), number)
        count = 3 if len(fields) in _POINT else 6
        values.extend(map(float, fields[:count]))
        values.extend([np.nan] * (6 - count))
        numbers.append(number)
        names.append(name)
    table = np.array(values, dtype=np.float64).reshape(-1, 6)
    return table, np.array(numbers, dtype=np.int64), names if any(names) else None, circles
