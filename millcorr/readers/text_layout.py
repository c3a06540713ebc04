# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the rows of a text file are made: separator, columns and unit, by its header or by its first row of numbers."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice, pairwise

from millcorr.errors import FormatError
from millcorr.messages import option, phrase

from .decoding import lines_of
from .fields import COMMENT, is_number, split, why_no_number
from .source import shown

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

_WORD = re.compile(r"(?!(?:nan|inf|infinity|null|none|n/a|na)$)(?=.*[^\W\d_]).+", re.IGNORECASE)
"""What can name a point: letters are among it, and it says not that something is missing."""
_COUNT = re.compile(r"\d{1,9}", re.ASCII)
_SAMPLE = 1000
"""So many rows show what a column is."""

_EXPECTED = phrase(
    "expected a header x,y,z or x,y,z,i,j,k above the numbers (or say {})", option("mapping", of="FILE.toml")
)
_SEPARATOR_NAMES = {"\t": "tab", ";": "semicolon", ",": "comma", None: "blank"}
_LOOKED_AT = 20
"""Rows below a line that show what it is the header of."""
_LONGEST_NAME = 24
_HEADER_DEPTH = 1000
LINE_LIMIT = 20_000
_FEWEST = 3
"""Fewer numbers in a row do not count up."""


@dataclass(frozen=True, slots=True)
class Layout:
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
    name: int | None = None
    """Column of words that name the points, where no header says so."""
    note: str = ""
    """What was taken for what without a header."""


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


def find_layout(text: str, name: str) -> Layout:
    """Layout of a text by its first lines; FormatError names the line that is neither comment, header nor numbers."""
    unit: str | None = None
    first_text: tuple[int, str] | None = None
    header: tuple[int, list[tuple[str, str | None]], bool] | None = None
    for index, raw in _head_lines(text):
        if len(raw) > LINE_LIMIT:
            raise FormatError(phrase("a line of {} characters: {}", len(raw), _EXPECTED), name, index + 1)
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
                raise FormatError(_found(text, *first_text), name, first_text[0] + 1)
            return _layout_without_header(text, numeric[0], numeric[1], index, unit, name)
        if first_text is None:
            layout = _layout_of_named_rows(text, content, index, unit)
            if layout is not None:
                return layout
        first_text = first_text or (index, content)
    if header is not None:
        raise FormatError(phrase("no points below the header"), name, header[0] + 1)
    if first_text is None:
        raise FormatError(phrase("no points: the file holds only comments"), name)
    index, content = first_text
    if _split_like_numbers(content):
        _refuse_field(content, name, index + 1)
    raise FormatError(_found(text, index, content), name, index + 1)


def _found(text: str, index: int, content: str) -> str:
    """What to say of a line that is no header here, with a mapping to copy if numbers stand in columns below it."""
    told = phrase("{}, found {}", _EXPECTED, shown(content))
    lines = [line for line in islice(lines_of(text), index + 1, index + 1 + _LOOKED_AT) if line.strip()]
    for separator in _SEPARATORS:
        names = split(content, separator)
        rows = [split(line, separator) for line in lines]
        row = next((r for r in rows if len(r) == len(names) and sum(is_number(f, separator) for f in r) >= 2), None)
        if row is not None and (separator is None or separator in content):
            return phrase("{}; a mapping for it: {}", told, _mapping_lines(separator, row, names))
    return told


def _mapping_lines(separator: str | None, row: list[str], names: list[str] | None = None) -> str:
    """Lines of a mapping that reads rows as this one, bars between them; columns by their names where these say it."""
    numbers = [place for place, field in enumerate(row) if is_number(field, separator)]
    comma = any("," in row[place] for place in numbers)
    columns = dict(zip("xyz", (str(place + 1) for place in numbers), strict=False))
    if names is not None:
        folded = [name.casefold() for name in names]
        named = {
            axis: next(
                (place for place in numbers if re.search(rf"(?<![a-z]){axis}|{axis}(?![a-z])", folded[place])), -1
            )
            for axis in "xyz"
        }
        there = [place for place in named.values() if place >= 0]
        plain = all(folded.count(folded[p]) == 1 and len(names[p]) <= _LONGEST_NAME for p in there)
        if min(named["x"], named["y"]) >= 0 and len(set(there)) == len(there) and plain:
            columns = {
                axis: json.dumps(names[place], ensure_ascii=False) for axis, place in named.items() if place >= 0
            }
    lines = [
        f'separator = "{_SEPARATOR_NAMES[separator]}"', *(['decimal = "comma"'] if comma else []),
        "columns = { " + ", ".join(f"{axis} = {place}" for axis, place in columns.items()) + " }",
    ]  # fmt: skip
    return " | ".join(lines)


def _rows_below(text: str, first: int, separator: str | None) -> list[list[str]]:
    """Fields of the rows from a line on, as many as show what a column is."""
    begin = 0
    for _ in range(first):
        begin = text.index("\n", begin) + 1
    rows = []
    for line in lines_of(text, begin):
        content = COMMENT.sub("", line).strip(" ")
        if content.strip():
            fields = split(content, separator)
            rows.append(fields[:-1] if separator is not None and fields[-1] == "" else fields)
        if len(rows) == _SAMPLE:
            break
    return rows


def _counts_up(rows: list[list[str]], separator: str | None) -> bool:
    """Whether the first column counts: whole numbers, each one more than the last, beside numbers with decimals."""
    if len(rows) < _FEWEST or not all(_COUNT.fullmatch(row[0]) for row in rows):
        return False
    counts = [int(row[0]) for row in rows]
    marks = "." if separator == "," else ".,"
    decimals = any(mark in field for row in rows for field in row[1:] for mark in marks)
    return decimals and all(b - a == 1 for a, b in pairwise(counts))


def _layout_of_named_rows(text: str, content: str, first: int, unit: str | None) -> Layout | None:
    """Layout of rows of a word and two, three or six numbers; None where one of them is made otherwise."""
    for separator in _SEPARATORS:
        if separator is not None and separator not in content:
            continue
        rows = _rows_below(text, first, separator)
        width = len(rows[0])
        if width - 1 not in (2, 3, 6) or len(rows) < 2:
            continue
        if all(
            len(row) == width and _WORD.fullmatch(row[0]) and all(is_number(f, separator) for f in row[1:])
            for row in rows
        ):
            return _layout_behind_first(separator, width, first, unit, 0, phrase("holds words: the points' names"))
    return None


def _layout_behind_first(
    separator: str | None, width: int, first: int, unit: str | None, name: int | None, what: str
) -> Layout:
    columns = {c: n for n, c in enumerate("xyzijk"[: width - 1], 1)}
    note = phrase("no header: the first column {}, then {}; a header says otherwise", what, " ".join(columns))
    return Layout(separator, width, columns, first, None, unit, name, note)


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
        raise FormatError(phrase("unit {}: only mm and inch are read, convert the file", text), name, line)
    return _UNITS.get(word)


def _columns(named: list[tuple[str, str | None]], name: str, line: int) -> dict[str, int]:
    names = [n for n, _ in named]
    for c in "xyzijk":
        if names.count(c) > 1:
            raise FormatError(phrase("column {} appears twice: rename the one that was not measured", c), name, line)
    columns = {c: names.index(c) for c in "xyzijk" if c in names}
    if len({"i", "j", "k"} & columns.keys()) not in (0, 3) and not {"i", "j"} <= columns.keys():
        missing = next(c for c in "ij" if c not in columns)
        raise FormatError(phrase("column {} is missing: a normal needs i,j,k", missing), name, line)
    if "k" in columns and "i" not in columns:
        raise FormatError(phrase("columns i and j are missing: a normal needs i,j,k"), name, line)
    return columns


def _layout_under_header(
    header: int, named: list[tuple[str, str | None]], content: str, first: int, unit: str | None, name: str
) -> Layout:
    line = header + 1
    columns = _columns(named, name, line)
    units = {_known_unit(u, name, line) for c, u in named if c in "xyz" and c and u}
    units.discard(None)
    if len(units) > 1:
        raise FormatError(phrase("the header gives the columns different units"), name, line)
    if units:
        unit = units.pop()
    separator = _separator_for(content, len(named), [columns[c] for c in columns])
    return Layout(separator, len(named), columns, first, line, unit)


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
) -> Layout:
    width = len(fields)
    if width - 1 in (2, 3, 6) and _counts_up(_rows_below(text, first, separator), separator):
        what = phrase("counts up from {}: the points' numbers", fields[0])
        return _layout_behind_first(separator, width, first, unit, None, what)
    if width not in (2, 3, 6):
        told = phrase(
            "{} columns without a header: {}; a mapping for it: {}", width, _EXPECTED, _mapping_lines(separator, fields)
        )
        raise FormatError(told, name, first + 1)
    if separator == "," and width != 3 and "." not in COMMENT.sub("", text):
        raise FormatError(
            phrase(
                "commas without a header can be decimal commas or separators: export with decimal points, or "
                "put a header x,y,z above the numbers"
            ),
            name,
            first + 1,
        )
    return Layout(separator, width, {c: n for n, c in enumerate("xyzijk"[:width])}, first, None, unit)
