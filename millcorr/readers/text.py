# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of numbers: ``x,y,z`` or ``x,y,z,i,j,k`` under a header, and what instruments make of that.

A file that numpy can take as a whole is read so; whatever it stumbles over is read again line by line, to
name the line.
"""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from millcorr.errors import FormatError, UsageError
from millcorr.measurement import Measurement

from .decimal_columns import decimal_columns
from .fields import COMMA_NUMBER, COMMENT, NUMBER, is_number, mixed_marks, split, why_no_number
from .source import MM_PER_INCH, Source, shown, unit_normals

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_NAMES = {
    **{n: n for n in "xyzijk"},
    **{"nx": "i", "ny": "j", "nz": "k", "n_x": "i", "n_y": "j", "n_z": "k"},
}
_UNITS = {
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres", "metric"), "mm"),
    **dict.fromkeys(("inch", "inches", "in", '"', "''"), "inch"),
}
_FOREIGN_UNITS = ("m", "cm", "um", "µm", "μm", "nm", "mil", "thou", "ft", "feet", "micron", "microns", "deg")

_STATED_UNIT = re.compile(r"\bunits?\b\W+(\w+)", re.IGNORECASE)
_BRACKETS = re.compile(r"\s*[\[(]\s*([^\])]*?)\s*[\])]")

_SEPARATORS = ("\t", ";", ",", None)
_SEPARATOR_NAMES = {"\t": "tab", ";": "semicolon", ",": "comma", None: "blank"}

_EXPECTED = "expected a header x,y,z or x,y,z,i,j,k above the numbers"
_HEADER_DEPTH = 1000
_LINE_LIMIT = 20_000
_TRUNCATION_ROWS = 20


@dataclass(frozen=True, slots=True)
class _Layout:
    """How the rows of a file are made."""

    separator: str | None
    width: int
    columns: dict[str, int]
    """Column of x, y, z, i, j, k, as far as there."""
    first: int
    """Index from 0 of the line where rows begin."""
    header: int | None
    """Line number from 1 of the header."""
    unit: str | None
    """What header or preamble say."""


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
    ball_radius = source.ball_radius()
    name = source.name
    text = source.text()
    if '"' in text:
        text = _unquoted(text, name)
    layout = _find_layout(text, name)
    if source.units is not None and layout.unit is not None and source.units != layout.unit:
        raise UsageError(f"--units {source.units} contradicts {name}, whose header says {layout.unit}")
    unit = source.unit(layout.unit)
    values, lines = _read_whole(text, layout) or _read_lines(text, layout, name)
    check_last_number(text, name, int(lines[-1]))
    column = {c: values[:, n] for n, c in enumerate(layout.columns)}
    if tuple(layout.columns) == ("x", "y", "z"):
        points = values
    else:
        points = np.column_stack([column.get(c, np.zeros(len(values))) for c in "xyz"])
    if unit == "inch":
        points *= MM_PER_INCH
    if not np.isfinite(points).all():
        row = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
        raise FormatError("a coordinate is too large", name, int(lines[row]))
    normals = None
    if "i" in column:
        k = column.get("k", np.zeros(len(values)))
        normals = unit_normals(np.stack([column["i"], column["j"], k], axis=1), lines, name)
    return Measurement(
        points, normals, ball_radius, lines, name, source.digest, "z" in column, unit=unit, format="text"
    )


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
    """
    path = Path(path)
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
    replace_whole(path, "\n".join([*head, ",".join(columns), *body, ""]))
    return path


def replace_whole(path: Path, content: str) -> None:
    """Write a text file that is never there in part: the old one stays until the new one is complete."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(content)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _unquoted(text: str, name: str) -> str:
    """Text without quotation marks; FormatError where one hides a comma in a number."""
    found = re.search(r'"\s*[+-]?\d+,\d+[^"\n]*"', text)
    if found:
        line = text.count("\n", 0, found.start()) + 1
        raise FormatError(
            f"{found[0]} can be a decimal comma or a thousands separator: export with decimal points",
            name,
            line,
        )
    return text.replace('"', "")


def _numeric_separator(line: str) -> tuple[str | None, list[str]] | None:
    """Separator and fields of a line that consists of at least two numbers, else None."""
    for separator in _SEPARATORS:
        if separator is not None and separator not in line:
            continue
        fields = split(line, separator)
        if separator is not None and fields and fields[-1] == "":
            fields = fields[:-1]
        if len(fields) >= 2 and all(is_number(f, separator) for f in fields):
            return separator, fields
    return None


def _head_lines(text: str) -> Iterator[tuple[int, str]]:
    """The first lines with their index, without cutting up the whole text."""
    position = 0
    for index in range(_HEADER_DEPTH):
        end = text.find("\n", position)
        yield index, text[position : end if end >= 0 else len(text)]
        if end < 0:
            return
        position = end + 1


def _find_layout(text: str, name: str) -> _Layout:
    unit: str | None = None
    first_text: tuple[int, str] | None = None
    header: tuple[int, list[tuple[str, str | None]], bool] | None = None
    for index, raw in _head_lines(text):
        if len(raw) > _LINE_LIMIT:
            raise FormatError(f"a line of {len(raw)} characters: {_EXPECTED}", name, index + 1)
        bare = raw.strip()
        if not bare:
            continue
        commented = bare.startswith(("#", "//"))
        content = bare.lstrip("#/ \t") if commented else COMMENT.sub("", raw).strip(" ")
        stated = _STATED_UNIT.search(content)
        if stated and header is None:
            unit = _known_unit(stated[1], name, index + 1) or unit
        if commented:
            named = _header_columns(content)
            if named and header is None:
                header = (index, named, True)
            continue
        if not content.strip():
            continue
        numeric = _numeric_separator(content)
        if numeric is None and (header is None or header[2]):
            named = _header_columns(content)
            if named:
                header = (index, named, False)
                continue
        if header is not None:
            return _layout_under_header(header[0], header[1], content, index, unit, name)
        if numeric is not None:
            if first_text is not None:
                raise FormatError(f"{_EXPECTED}, found {shown(first_text[1])}", name, first_text[0] + 1)
            return _layout_without_header(text, numeric[0], numeric[1], index, unit, name)
        first_text = first_text or (index, content)
    if header is not None:
        raise FormatError("no points below the header", name, header[0] + 1)
    if first_text is None:
        raise FormatError("no points: the file holds only comments", name)
    index, content = first_text
    if _split_like_numbers(content):
        _refuse_field(content, name, index + 1)
    raise FormatError(f"{_EXPECTED}, found {shown(content)}", name, index + 1)


def _split_like_numbers(content: str) -> bool:
    """True where a first line is meant as numbers, one of them spoilt."""
    for separator in _SEPARATORS:
        if separator is None or separator in content:
            fields = split(content, separator)
            if sum(is_number(f, separator) for f in fields) * 2 >= len(fields) >= 2:
                return True
    return False


def _refuse_field(content: str, name: str, line: int) -> None:
    for separator in _SEPARATORS:
        if separator is None or separator in content:
            for field in split(content, separator):
                if not is_number(field, separator):
                    raise FormatError(why_no_number(field, separator), name, line)


def _header_columns(content: str) -> list[tuple[str, str | None]] | None:
    """Names and units of a line that names at least x and y, else None."""
    for separator in _SEPARATORS:
        if separator is not None and separator not in content:
            continue
        # A unit in brackets belongs to the name before it, also where blanks separate the names.
        joined = _BRACKETS.sub(lambda m: "[" + m[1].replace(" ", "") + "]", content)
        named: list[tuple[str, str | None]] = []
        for field in split(joined, separator):
            match = re.fullmatch(r"(.*?)(?:\[([^\]]*)\])?", field.lower())
            assert match is not None
            plain, unit = match[1].strip().strip("'"), match[2]
            if unit is None:
                suffix = re.fullmatch(r"([xyz])[_/ ](mm|inch|inches|in)", plain)
                if suffix:
                    plain, unit = suffix[1], suffix[2]
            named.append((_NAMES.get(plain, plain), unit))
        while len(named) > 1 and named[-1][0] == "":
            named.pop()
        names = [n for n, _ in named]
        if "x" in names and "y" in names:
            return named
        if separator is not None and len(named) > 1:
            return None
    return None


def _known_unit(text: str, name: str, line: int) -> str | None:
    word = text.strip().lower()
    if word in _FOREIGN_UNITS:
        raise FormatError(f"unit {text}: only mm and inch are read, convert the file", name, line)
    return _UNITS.get(word)


def _columns(named: list[tuple[str, str | None]], name: str, line: int) -> dict[str, int]:
    names = [n for n, _ in named]
    for c in "xyzijk":
        if names.count(c) > 1:
            raise FormatError(f"column {c} appears twice: rename the one that was not measured", name, line)
    columns = {c: names.index(c) for c in "xyzijk" if c in names}
    if len({"i", "j", "k"} & columns.keys()) not in (0, 3) and not {"i", "j"} <= columns.keys():
        missing = next(c for c in "ij" if c not in columns)
        raise FormatError(f"column {missing} is missing: a normal needs i,j,k", name, line)
    if "k" in columns and "i" not in columns:
        raise FormatError("columns i and j are missing: a normal needs i,j,k", name, line)
    return columns


def _layout_under_header(
    header: int, named: list[tuple[str, str | None]], content: str, first: int, unit: str | None, name: str
) -> _Layout:
    line = header + 1
    columns = _columns(named, name, line)
    units = {_known_unit(u, name, line) for c, u in named if c in "xyz" and c and u}
    units.discard(None)
    if len(units) > 1:
        raise FormatError("the header gives the columns different units", name, line)
    if units:
        unit = units.pop()
    separator = _separator_for(content, len(named), [columns[c] for c in columns])
    return _Layout(separator, len(named), columns, first, line, unit)


def _separator_for(content: str, width: int, used: list[int]) -> str | None:
    """Separator of a first row that should have `width` fields; the likeliest one where none fits."""
    present = [s for s in _SEPARATORS if s is None or s in content]
    for separator in present:
        fields = split(content, separator)
        if len(fields) == width + 1 and fields[-1] == "":
            fields = fields[:-1]
        if len(fields) == width and all(is_number(fields[c], separator) for c in used):
            return separator
    for separator in present:
        if len(split(content, separator)) >= width:
            return separator
    return present[0]


def _layout_without_header(
    text: str, separator: str | None, fields: list[str], first: int, unit: str | None, name: str
) -> _Layout:
    width = len(fields)
    if width not in (2, 3, 6):
        raise FormatError(f"{width} columns without a header: {_EXPECTED}", name, first + 1)
    if separator == "," and width != 3 and "." not in COMMENT.sub("", text):
        raise FormatError(
            "commas without a header can be decimal commas or separators: export with decimal points, or put "
            "a header x,y,z above the numbers",
            name,
            first + 1,
        )
    return _Layout(separator, width, {c: n for n, c in enumerate("xyzijk"[:width])}, first, None, unit)


def _begin(text: str, layout: _Layout) -> int:
    """Where in the text the rows begin."""
    position = 0
    for _ in range(layout.first):
        position = text.index("\n", position) + 1
    return position


def _read_whole(text: str, layout: _Layout) -> tuple[Floats, Ints] | None:
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
    columns = list(layout.columns.values())
    return decimal_columns(text, layout.separator, layout.width, columns, begin=begin, first=layout.first + 1)


def _read_lines(text: str, layout: _Layout, name: str) -> tuple[Floats, Ints]:
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
                raise FormatError(f"{shown(field)} is too large", name, number)
            row.append(value)
        rows.append(row)
        lines.append(number)
    if not rows:
        raise FormatError("no points below the header", name, layout.header)
    return np.array(rows, dtype=np.float64), np.array(lines, dtype=np.int64)


def _why_ragged(fields: list[str], layout: _Layout, content: str) -> str:
    found = f"{len(fields)} columns where {layout.width} were expected"
    if layout.separator == "," and len(fields) > layout.width:
        return f"{found}: decimal commas between commas? Export with decimal points, or semicolons between"
    if len(fields) < layout.width:
        return f"{found}: the row is incomplete or the file was cut off; {shown(content)}"
    return f"{found}: {shown(content)}"


def check_last_number(text: str, name: str, last: int) -> None:
    """FormatError where a file of fixed decimals ends in mid-number: it was cut off."""
    if text.endswith("\n"):
        return
    tail = text[-_LINE_LIMIT:].split("\n")[1:]
    ends = [re.search(r"[.,](\d+)[ \t]*$", line) for line in tail if line.strip()]
    if len(ends) <= _TRUNCATION_ROWS or not all(ends[:-1]):
        return
    decimals = {len(m[1]) for m in ends[:-1] if m is not None}
    end = ends[-1]
    if len(decimals) == 1 and (end is None or len(end[1]) < max(decimals)):
        raise FormatError("the file ends within a number: it was cut off, export it again", name, last)
