# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text files whose columns a `millcorr.readers.mapping.TextMapping` explains: nothing is guessed."""

from __future__ import annotations

import csv
import re
from array import array
from dataclasses import dataclass, replace
from difflib import get_close_matches

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import FormatError
from millcorr.messages import message, mm, phrase
from millcorr.readers.measurement import Basis, Measurement

from .decimal_columns import decimal_tables
from .decoding import decode, lines_of
from .fields import COMMA_NUMBER, NUMBER, mixed_marks, split, why_no_number
from .mapping import DECIMALS, PLANES, SEPARATORS, TextMapping, axes_of
from .names import Names
from .source import Source, shown, unit_vectors
from .truncation import check_last_number

_HEADER_DEPTH = 1000
_LINE_LIMIT = 20_000
_MAY_BE_EMPTY = ("nominal_x", "nominal_y", "nominal_z", "deviation")
_TEXTS = {"id", "travel"}
"""Columns that hold no numbers."""
_TRAVEL = {
    f"{axis}{sign}"[::way]: tuple(float(f"{sign}1") if other == axis else 0.0 for other in "xyz")
    for axis in "xyz"
    for sign in "+-"
    for way in (1, -1)
}
"""Unit vector of each way to write a direction along an axis: X+ or +X."""


@dataclass(frozen=True, slots=True)
class _Table:
    """Where in a text the rows are, and which field of a row is what."""

    columns: dict[str, int]
    """Field of each column, from 0."""
    only: dict[int, frozenset[str]]
    """Texts, in small letters, of which these fields must hold one."""
    first: int
    """Index from 0 of the first line that can be a row."""
    width: int | None
    """Fields that the header has."""


def read(source: Source, mapping: TextMapping) -> Measurement:
    """Measured points from a text file whose columns are known.

    Parameters
    ----------
    source : Source
    mapping : TextMapping

    Returns
    -------
    Measurement
        Points in mm.

    Raises
    ------
    FormatError
        If the file is not as the mapping says, or a row cannot be trusted.
    UsageError
        If the caller contradicts the mapping, or neither says what the points are.
    """
    told = replace(source, name=phrase("the mapping {}", mapping.source) if mapping.source else phrase("the mapping"))
    kind = told.kind(mapping.points)
    told = replace(told, points=kind)
    # A radius in the mapping is of use only if the points are no contact points.
    ball_radius = told.ball_radius(radius=mapping.probe_radius if kind == "centre" else None)
    axis_radii = told.axis_radii(mapping.probe_radius) if kind == "axis" else None
    unit = told.unit("mm" if mapping.factor is not None else mapping.units)
    by_mapping = Basis("said", told.name)
    source.bases.update({key: by_mapping for key, basis in source.bases.items() if basis.how == "stated"})
    if mapping.points is not None:
        source.bases["points"] = by_mapping
    text = _text(source, mapping)
    table = _table(text, source, mapping)
    rows = _Rows(source, mapping, table)
    values, lines, names = _read_whole(text, table, mapping) or rows.read(text)
    if not (mapping.end or mapping.only):
        check_last_number(source.data, source.name)
    column = dict(zip([c for c in table.columns if c not in _TEXTS], values.T, strict=True))

    def vectors(*keys: str) -> Floats | None:
        if not column.keys() & set(keys):
            return None
        order = [keys["xyz".index(axis)] for axis in axes_of(mapping.plane)]
        found = np.column_stack([column.get(key, np.zeros(len(values))) for key in order])
        found[:, 2] *= PLANES[mapping.plane]
        return found

    points = vectors("x", "y", "z")
    travel = vectors("travel_x", "travel_y", "travel_z")
    assert points is not None
    if travel is not None:
        travel = unit_vectors(travel, lines, source.name, phrase("direction of travel"))
    elif rows.travel:
        travel = np.array(rows.travel)[:, ["xyz".index(axis) for axis in axes_of(mapping.plane)]]
        travel[:, 2] *= PLANES[mapping.plane]
    measurement = source.measurement(
        "mapped", points, lines, ball_radius=ball_radius, unit=unit,
        normals=vectors("i", "j", "k"),
        nominal=vectors("nominal_x", "nominal_y", "nominal_z"),
        stated=column["deviation"].copy() if "deviation" in column else None,
        elements=names,
        has_z=axes_of(mapping.plane)[2] in column,
        factor=mapping.factor,
        notes=[
            phrase(
                "columns by {}{}",
                mapping.source or phrase("a mapping"),
                f" ({mapping.name})" if mapping.name else "",
            ),
            *([phrase("converted from a unit of {}", mm(mapping.factor, "g"))] if mapping.factor is not None else []),
        ],
    )  # fmt: skip
    return measurement if axis_radii is None else replace(measurement, axis_radii=axis_radii, travel=travel)


def _text(source: Source, mapping: TextMapping) -> str:
    if mapping.encoding is None:
        return source.text()
    try:
        recoded = source.data.decode(mapping.encoding).encode()
    except (UnicodeError, ValueError) as error:
        raise source.error(phrase("no text in {}, which the mapping says", mapping.encoding)) from error
    return decode(recoded, source.name)


def _table(text: str, source: Source, mapping: TextMapping) -> _Table:
    places: dict[str, str | int] = {**mapping.columns}
    wanted = [p for p in places.values() if isinstance(p, str)] + [k for k in mapping.only if not k.isdecimal()]
    names = list(dict.fromkeys(name.strip().casefold() for name in wanted))
    header: int | None = None
    found: list[str] = []
    if names or mapping.header is not None:
        header, found = _header(text, names, source, mapping)

    def index(place: str | int) -> int:
        if isinstance(place, int):
            return place - 1
        return found.index(place.strip().casefold())

    first = max(mapping.skip, 0 if header is None else header + 1)
    return _Table(
        {key: index(place) for key, place in places.items()},
        {
            index(int(key) if key.isdecimal() else key): frozenset(t.strip().casefold() for t in texts)
            for key, texts in mapping.only.items()
        },
        first,
        # Without names the line may be anything.
        len(found) if names else None,
    )


def _header(text: str, names: list[str], source: Source, mapping: TextMapping) -> tuple[int, list[str]]:
    """Index of the line with the names, and its fields in small letters."""
    best: tuple[int, int, list[str]] | None = None
    told = {p.strip().casefold(): p.strip() for p in (*mapping.columns.values(), *mapping.only) if isinstance(p, str)}
    for number, raw in enumerate(lines_of(text, 0), 1):
        if mapping.header is not None and number < mapping.header:
            continue
        if number > _HEADER_DEPTH and mapping.header is None:
            break
        bare = raw.strip()
        for mark in mapping.comments:
            bare = bare.removeprefix(mark)
        shapes = [f.strip().strip("\"'") for f in _split(bare, SEPARATORS.get(mapping.separator, mapping.separator))]
        while shapes and not shapes[-1]:
            shapes.pop()
        fields = [f.casefold() for f in shapes]
        there = sum(name in fields for name in names)
        if there == len(names):
            for name in names:
                if fields.count(name) > 1:
                    raise source.error(
                        phrase("two columns are named {}: give their numbers in the mapping", shown(name)), number
                    )
            return number - 1, fields
        if best is None or there > best[0]:
            best = (there, number, shapes)
        if mapping.header is not None:
            break
    if best is None:
        raise source.error(phrase("the file ends before line {}, where the mapping has the header", mapping.header))
    there_are = {f.casefold(): f for f in best[2] if f}
    missing = next(name for name in names if name not in there_are)
    near = get_close_matches(missing, there_are.keys() - set(names), n=1, cutoff=0.5)
    meant = phrase(" (is it {}?)", shown(there_are[near[0]])) if near else ""
    lacking = message(shown(told.get(missing, missing)), meant)
    by = mapping.source or phrase("the mapping")
    if mapping.header is not None:
        told_of = phrase("line {} does not name all columns of {}; lacking: {}", mapping.header, by, lacking)
    else:
        told_of = phrase("no line names all columns of {}; lacking: {}", by, lacking)
    raise source.error(
        told_of,
        best[1] if best[0] or mapping.header else None,
    )


def _split(line: str, separator: str | None) -> list[str]:
    if '"' not in line:
        return split(line, separator)
    try:
        row = next(csv.reader([line], delimiter=separator or " ", skipinitialspace=True), [])
    except csv.Error:
        return split(line, separator)
    return [f.strip() for f in row if separator is not None or f.strip()]


def _read_whole(text: str, table: _Table, mapping: TextMapping) -> tuple[Floats, Ints, Names | None] | None:
    """Rows in one go where all wanted cells but names are numbers; None where there is more to it."""
    if mapping.only or mapping.end or "travel" in table.columns or '"' in text:
        return None
    if any(mark in text for mark in mapping.comments):
        return None
    begin = 0
    for _ in range(table.first):
        begin = text.find("\n", begin) + 1
        if not begin:
            return None
    separator = SEPARATORS.get(mapping.separator, mapping.separator)
    width = table.width
    if width is None:
        width = len(_split(next(lines_of(text, begin)), separator))
    if max(table.columns.values()) >= width or (mapping.decimal == "comma" and separator == ","):
        return None
    columns = [place for column, place in table.columns.items() if column not in _TEXTS]
    found = decimal_tables(
        text, separator, width, [columns], begin=begin, first=table.first + 1, mark=DECIMALS[mapping.decimal]
    )
    if found is None:
        return None
    (values,), lines = found
    if "id" not in table.columns:
        return values, lines, None
    place = table.columns["id"]
    rows = (line.split(separator, place + 1) for line in lines_of(text, begin) if line.strip())
    # Rows are as wide as the header: the table has been read.
    return values, lines, Names(row[place].strip() for row in rows)


class _Rows:
    """Rows line by line: texts between the numbers, rows that do not count, and the line that is wrong."""

    def __init__(self, source: Source, mapping: TextMapping, table: _Table) -> None:
        self.source = source
        self.mapping = mapping
        self.table = table
        self.separator = SEPARATORS.get(mapping.separator, mapping.separator)
        self.width = table.width
        self.mark = DECIMALS[mapping.decimal]
        self.needed = max([*table.columns.values(), *table.only]) + 1
        marks = "|".join(re.escape(m) for m in mapping.comments)
        self.comment = re.compile(rf"(?:^|(?<=[\s,;]))(?:{marks}).*") if marks else None
        self.values = array("d")
        self.lines = array("q")
        self.names: list[str] | None = [] if "id" in table.columns else None
        self.travel: list[tuple[float, ...]] = []
        self.others: dict[str, None] = {}

    def read(self, text: str) -> tuple[Floats, Ints, list[str] | None]:
        number = 0
        for number, raw in enumerate(lines_of(text, 0), 1):
            if number <= self.table.first:
                continue
            if self.mapping.end and raw.lstrip().startswith(self.mapping.end.strip()):
                break
            if len(raw) > _LINE_LIMIT:
                raise self.source.error(phrase("a line of {} characters is no row of numbers", len(raw)), number)
            content = self.comment.sub("", raw) if self.comment else raw
            if content.strip():
                self._line(number, content)
        if not self.lines:
            raise self._nothing(number)
        wide = len(self.table.columns.keys() - _TEXTS)
        return np.array(self.values).reshape(-1, wide), np.array(self.lines, dtype=np.int64), self.names

    def _line(self, number: int, content: str) -> None:
        fields = _split(content, self.separator)
        if not any(fields) or not self._counts(fields):
            return
        width = self.width = self.width or len(fields)
        if len(fields) < width or any(fields[width:]):
            less = (
                phrase("the row is incomplete, or the file was cut off")
                if len(fields) < width
                else phrase("one too many")
            )
            raise self.source.error(
                phrase("{} columns where {} were expected: {}; {}", len(fields), width, less, shown(content)), number
            )
        if width < self.needed:
            raise self.source.error(
                phrase(
                    "{} columns, but the mapping takes column {}: is the separator {}?",
                    width,
                    self.needed,
                    self.mapping.separator,
                ),
                number,
            )  # fmt: skip
        for column, place in self.table.columns.items():
            if column == "id":
                assert self.names is not None
                self.names.append(fields[place])
            elif column == "travel":
                self.travel.append(self._direction(fields[place], number))
            elif not fields[place] and column in _MAY_BE_EMPTY:
                self.values.append(np.nan)
            else:
                self.values.append(self._number(fields[place], number))
        self.lines.append(number)

    def _counts(self, fields: list[str]) -> bool:
        """Whether a row is one of those that the mapping wants."""
        for place, texts in self.table.only.items():
            content = fields[place].casefold() if place < len(fields) else ""
            if content not in texts:
                if len(self.others) < 5 and content:
                    self.others[content] = None
                return False
        return True

    def _direction(self, field: str, number: int) -> tuple[float, ...]:
        # Some controls print a minus that is no hyphen.
        found = _TRAVEL.get("".join(field.split()).replace("\u2212", "-").lower())
        if found is None:
            raise self.source.error(
                phrase("{} is no direction of travel: X+, X-, Y+, Y-, Z+ or Z-", shown(field)), number
            )
        return found

    def _number(self, field: str, number: int) -> float:
        pattern, other = (NUMBER, COMMA_NUMBER) if self.mark == "." else (COMMA_NUMBER, NUMBER)
        plain = re.fullmatch(r"[+-]?\d+", field, re.ASCII) is not None
        if not plain and not pattern.fullmatch(field):
            # An exponent alone needs no mark: 1e3 is the same with either.
            if not (other.fullmatch(field) and not {".", ","} & set(field)):
                raise self.source.error(self._why_no_number(field, other), number)
        value = float(field.replace(",", "."))
        if not np.isfinite(value):
            raise self.source.error(phrase("{} is too large", shown(field)), number)
        return value

    def _why_no_number(self, field: str, other: re.Pattern[str]) -> str:
        if other.fullmatch(field):
            if self.lines:
                return mixed_marks(field)
            if self.mark == ".":
                return phrase(
                    "{} has a decimal comma: the mapping says decimal = {!r}", shown(field), self.mapping.decimal
                )
            return phrase("{} has a decimal point: the mapping says decimal = {!r}", shown(field), self.mapping.decimal)
        return why_no_number(field, self.separator)

    def _nothing(self, last: int) -> FormatError:
        if self.table.only:
            wanted = ", ".join(sorted(t for texts in self.table.only.values() for t in texts))
            there = phrase("; there are {}", ", ".join(map(shown, self.others))) if self.others else ""
            return self.source.error(phrase("no row holds {}, which the mapping asks for{}", shown(wanted), there))
        return self.source.error(phrase("no points below the header"), min(self.table.first, last) or None)
