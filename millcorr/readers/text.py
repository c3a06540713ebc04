# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of numbers: ``x,y,z`` or ``x,y,z,i,j,k`` under a header, and what instruments make of that.

A file of nothing but numbers is read as a whole; whatever that stumbles over is read again as a text, and line by
line, to name the line.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import FormatError, UsageError
from millcorr.messages import joined, option, phrase
from millcorr.readers.measurement import Measurement, Probe
from millcorr.whole_file import write_whole

from .decimal_columns import decimal_tables
from .decoding import decode
from .fields import COMMA_NUMBER, COMMENT, NUMBER, mixed_marks, split, why_no_number
from .source import MM_PER_INCH, Source, shown, unit_normals
from .text_layout import Layout, find_layout

_HEAD = 1 << 18
"""Bytes at the beginning that show how the rows are made."""
_PIECE = 1 << 16


def recognises(data: bytes) -> bool:
    """True whatever the bytes are: this module takes, or refuses, what the other formats leave over."""
    return True


def read(source: Source) -> Measurement:
    """Measured points from a text file.

    Parameters
    ----------
    source : Source
        Its unit is what the header says, else mm; text never says whether points are contact points.

    Returns
    -------
    Measurement
        Points in mm; normals of length 1 where the file has them.

    Raises
    ------
    FormatError
        If anything in the file cannot be trusted.
    UsageError
        If the caller contradicts the header, or does not say what the points are.
    """
    ball_radius, name = source.ball_radius(), source.name
    layout, tables, lines = _rows_of_bytes(source) or _rows_of_text(source)
    if source.units is not None and layout.unit is not None and source.units != layout.unit:
        raise UsageError(
            phrase("{} contradicts {}, whose header says {}", option("units", source.units), name, layout.unit)
        )
    unit = source.unit(layout.unit)
    points, normals = tables[0], tables[1] if len(tables) > 1 else None
    if unit == "inch":
        points *= MM_PER_INCH
    if not np.isfinite(points).all():
        row = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
        raise FormatError(phrase("a coordinate is too large"), name, int(lines[row]))
    if normals is not None:
        # In place, piece by piece: a million rows are large.
        for k in range(0, len(normals), _PIECE):
            normals[k : k + _PIECE] = unit_normals(normals[k : k + _PIECE], lines[k : k + _PIECE], name)
    return Measurement(
        points, normals, ball_radius, lines, name, source.digest, "z" in layout.columns, unit=unit, format="text",
        elements=_names(source, layout, lines), notes=(layout.note,) if layout.note else (),
    )  # fmt: skip


def _names(source: Source, layout: Layout, lines: Ints) -> tuple[str, ...] | None:
    """What a column of words without a header calls the points."""
    if layout.name is None:
        return None
    rows = source.text().replace('"', "").split("\n")
    return tuple(split(rows[line - 1].strip(" "), layout.separator)[layout.name] for line in lines.tolist())


def write(path: str | Path, measurement: Measurement, *, comments: Sequence[str] = ()) -> Path:
    """Write a measurement as a text file that `millcorr.readers.read` takes back.

    Parameters
    ----------
    path : str or Path
        Replaced as a whole.
    measurement : Measurement
        Written in mm as x,y[,z][,i,j,k] with 9 decimals (normals with 12).
    comments : sequence of str
        Lines put above the header behind ``#``.

    Returns
    -------
    Path

    Raises
    ------
    UsageError
        If such a file cannot say what the points are: shifted along an axis, or ball centres whose probe has an
        offset or radii by direction.
    """
    if measurement.axis_radii is not None:
        raise UsageError(
            phrase(
                "points shifted along an axis are kept in the file they came from: leave {} out",
                option("points", "axis"),
            )
        )
    probe = measurement.probe
    lost = _lost(probe)
    if probe is not None and lost:
        raise UsageError(
            phrase(
                "a text file cannot keep the {} of {}, and the points are wrong without: say {} in its place "
                "here, and {} with the written file",
                lost,
                probe.source or phrase("the probe"),
                option("probe_radius"),
                option("probe"),
            ),
        )
    columns, formats = ["x", "y"], ["%.9f", "%.9f"]
    table = measurement.points[:, :2]
    if measurement.has_z:
        columns, formats, table = [*columns, "z"], [*formats, "%.9f"], measurement.points
    if measurement.normals is not None:
        columns, formats = [*columns, "i", "j", "k"], [*formats, "%.12f", "%.12f", "%.12f"]
        table = np.hstack([table, measurement.normals])
    kind = "contact points"
    if measurement.ball_radius:
        kind = f"centres of a probe ball, radius {measurement.ball_radius:g} mm"
    notes = [line for text in (*comments, f"{kind}; unit mm") for line in text.splitlines() or [""]]
    head = [f"# {line}".rstrip() for line in notes]
    row = ",".join(formats)
    body = [row % tuple(values) for values in table.tolist()]
    return write_whole(Path(path), "\n".join([*head, ",".join(columns), *body, ""]))


def _lost(probe: Probe | None) -> str:
    """What a text file does not keep of a probe's calibration; "" for nothing."""
    if probe is None:
        return ""
    kept = {phrase("offset"): any(probe.offset), phrase("radii by direction"): probe.directions is not None}
    return joined((what for what, there in kept.items() if there), phrase(" and "))


_QUOTED_COMMA = r'"\s*[+-]?\d+,\d+[^"\n]*"'
_BETWEEN_COMMAS = re.compile(rf"{_QUOTED_COMMA}[ ]*,|,[ ]*{_QUOTED_COMMA}")


def _unquoted(text: str, name: str) -> str:
    """Text without quotation marks; FormatError where these tell a comma in a number from one between numbers."""
    found = _BETWEEN_COMMAS.search(text)
    if found:
        line = text.count("\n", 0, found.start()) + 1
        raise FormatError(
            phrase(
                "{} can be a decimal comma or a thousands separator: export with decimal points, or with "
                "semicolons between the columns",
                shown(found[0].strip(", ")),
            ),
            name,
            line,
        )
    return text.replace('"', "")


_Rows = tuple[Layout, list[Floats], Ints]
"""Layout; points and, where the file has them, normals; line numbers."""


def _tables(layout: Layout) -> list[list[int | None]]:
    """Columns of points and normals; None for a third one that is not there."""
    wanted = ["xyz", "ijk"] if "i" in layout.columns else ["xyz"]
    return [[layout.columns.get(c) for c in names] for names in wanted]


def _rows_of_bytes(source: Source) -> _Rows | None:
    """Rows of numbers as they stand in the file, without a copy of it; None where anything is not as it should be."""
    data = source.data
    head = data[: data.rfind(b"\n", 0, _HEAD) + 1] or data[:_HEAD]
    if b'"' in head:
        return None
    try:
        layout = find_layout(decode(head, source.name), source.name)
    except FormatError:
        # Only the whole text shows what is wrong.
        return None
    begin = 0
    for _ in range(layout.first):
        begin = data.find(b"\n", begin) + 1
    if begin == 0 < layout.first or data.count(b"\r", 0, begin) != data.count(b"\r\n", 0, begin):
        return None
    mark = "," if layout.separator != "," and data.find(b",", begin) >= 0 else "."
    found = decimal_tables(
        data, layout.separator, layout.width, _tables(layout), begin=begin, first=layout.first + 1, mark=mark
    )
    if found is None:
        return None
    return layout, *found


def _rows_of_text(source: Source) -> _Rows:
    """Rows of a text in any encoding, with comments, quotation marks and columns of words."""
    text = source.text()
    if '"' in text:
        text = _unquoted(text, source.name)
    layout = find_layout(text, source.name)
    found = _read_whole(text, layout)
    if found is None:
        values, lines = _read_lines(text, layout, source.name)
        place = {column: k for k, column in enumerate(layout.columns.values())}
        tables = [
            np.column_stack([np.zeros(len(values)) if c is None else values[:, place[c]] for c in table])
            for table in _tables(layout)
        ]
        found = tables, lines
    return layout, *found


def _begin(text: str, layout: Layout) -> int:
    """Where in the text the rows begin."""
    position = 0
    for _ in range(layout.first):
        position = text.index("\n", position) + 1
    return position


def _read_whole(text: str, layout: Layout) -> tuple[list[Floats], Ints] | None:
    """Rows in one go; None where anything is not as it should be."""
    begin = _begin(text, layout)
    # Only what needs it is copied: a million rows are large.
    if layout.separator != "," and text.find(",", begin) >= 0:
        if text.find(".", begin) >= 0:
            return None
        text, begin = text[begin:].replace(",", "."), 0
    if text.find("#", begin) >= 0 or text.find("//", begin) >= 0:
        text, begin = COMMENT.sub("", text[begin:]), 0
    head = text[begin : text.find("\n", begin)] if text.find("\n", begin) >= 0 else text[begin:]
    if layout.separator is not None and len(split(head, layout.separator)) == layout.width + 1:
        text, begin = re.sub(r"[,;\t][ \t]*$", "", text[begin:], flags=re.MULTILINE), 0
    return decimal_tables(text, layout.separator, layout.width, _tables(layout), begin=begin, first=layout.first + 1)


def _read_lines(text: str, layout: Layout, name: str) -> tuple[Floats, Ints]:
    """Rows one by one: for columns of text between the numbers, and to name the line that is wrong."""
    rows: list[list[float]] = []
    lines: list[int] = []
    mark: str | None = None
    separator, width = layout.separator, layout.width
    for number, raw in enumerate(text[_begin(text, layout) :].split("\n"), layout.first + 1):
        content = COMMENT.sub("", raw) if "#" in raw or "//" in raw else raw
        if not content.strip():
            continue
        fields = split(content, separator)
        if len(fields) == width + 1 and fields[-1] == "":
            fields.pop()
        if not any(fields):
            continue
        if len(fields) != width:
            raise FormatError(_why_ragged(fields, layout, content), name, number)
        row = []
        for column in layout.columns.values():
            field = fields[column]
            if not NUMBER.fullmatch(field):
                if separator == "," or not COMMA_NUMBER.fullmatch(field):
                    raise FormatError(why_no_number(field, separator), name, number)
                if mark == ".":
                    raise FormatError(mixed_marks(field), name, number)
                mark = ","
                field = field.replace(",", ".")
            elif "." in field:
                if mark == ",":
                    raise FormatError(mixed_marks(field), name, number)
                mark = "."
            value = float(field)
            if not np.isfinite(value):
                raise FormatError(phrase("{} is too large", shown(field)), name, number)
            row.append(value)
        rows.append(row)
        lines.append(number)
    if not rows:
        raise FormatError(phrase("no points below the header"), name, layout.header)
    return np.array(rows, dtype=np.float64), np.array(lines, dtype=np.int64)


def _why_ragged(fields: list[str], layout: Layout, content: str) -> str:
    found = phrase("{} columns where {} were expected", len(fields), layout.width)
    if layout.separator == "," and len(fields) > layout.width:
        return phrase("{}: decimal commas between commas? Export with decimal points, or semicolons between", found)
    if len(fields) < layout.width:
        return phrase("{}: the row is incomplete or the file was cut off; {}", found, shown(content))
    return phrase("{}: {}", found, shown(content))
