# SPDX-License-Identifier: LGPL-2.1-or-later
"""Logged traces of a machine: time and actual position, or time and actual feed, from text."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.errors import FormatError
from millcorr.readers.decimal_columns import decimal_columns
from millcorr.readers.decoding import decode
from millcorr.readers.fields import is_number, split, why_no_number
from millcorr.readers.source import MM_PER_INCH, shown

_NAMES = {"t": "t", "time": "t", "x": "x", "y": "y", "z": "z", "feed": "feed", "f": "feed", "v": "feed"}
_LENGTHS = {"mm": 1.0, "inch": MM_PER_INCH, "in": MM_PER_INCH}
_UNITS = {
    "t": {"s": 1.0, "ms": 1e-3},
    "x": _LENGTHS,
    "y": _LENGTHS,
    "z": _LENGTHS,
    "feed": {"mm/min": 1.0 / 60.0, "mm/s": 1.0},
}
_DEFAULTS = {"t": "s", "x": "mm", "y": "mm", "z": "mm", "feed": "mm/min"}
_FIELD = re.compile(r"([a-z]+)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?")
_LEAST = 20
_GAP = 20.0
"""A step of time this many times the usual one means lost samples."""


@dataclass(frozen=True, eq=False, slots=True)
class Trace(ReadOnlyArrays):
    """What a machine logged while it ran a program.

    Parameters
    ----------
    t : (n,) float64
        Time in s, increasing, from any zero.
    position : (n, 3) float64
        Actual position in mm; NaN in columns that were not logged.
    feed : (n,) float64
        Actual feed in mm/s; NaN where it was not logged.
    source : str
        Name of the file.
    """

    t: Floats
    position: Floats
    feed: Floats
    source: str

    def __len__(self) -> int:
        return len(self.t)


def read_trace(path: str | Path) -> Trace:
    """Read a trace from text with a header.

    Columns by name, in any order, others being passed over: ``t`` and ``x``, ``y`` (``z``), or ``t`` and ``feed``;
    separated by comma, semicolon, tab or blanks. Units in brackets behind a name: t [s] or [ms], x, y, z [mm] or
    [inch], feed [mm/min] or [mm/s]; without brackets s, mm and mm/min. Lines before the header may begin with #.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    Trace

    Raises
    ------
    FormatError
        If the file cannot be read or trusted; names the line.
    """
    name = str(path)
    try:
        text = decode(Path(path).read_bytes(), name)
    except OSError as error:
        raise FormatError(f"cannot be read: {error.strerror or error}", name) from error
    begin, number, header = _header(text, name)
    separator = next((c for c in "\t;," if c in header), None)
    columns, factors, width = _columns(header, separator, name, number)
    found = decimal_columns(text, separator, width, list(columns.values()), begin=begin, first=number + 1)
    values, lines = found or _line_by_line(text, begin, number, separator, width, columns, name)
    values = values * np.array([factors[c] for c in columns])
    column = dict(zip(columns, values.T, strict=True))
    _check(values, column["t"], lines, name)
    position = np.full((len(values), 3), np.nan)
    for k, axis in enumerate("xyz"):
        if axis in column:
            position[:, k] = column[axis]
    feed = column["feed"].copy() if "feed" in column else np.full(len(values), np.nan)
    return Trace(column["t"].copy(), position, feed, name)


def _header(text: str, name: str) -> tuple[int, int, str]:
    """Where the rows begin, line number from 1 of the header, and the header in lower case."""
    begin = 0
    for number, line in enumerate(text.split("\n"), 1):
        begin += len(line) + 1
        bare = line.strip()
        if bare and not bare.startswith("#"):
            return begin, number, bare.lower()
    raise FormatError("no samples: expected a header t,x,y or t,feed above the numbers", name)


def _columns(header: str, separator: str | None, name: str, line: int) -> tuple[dict[str, int], dict[str, float], int]:
    """Index and factor of every known column, and the number of columns."""
    joined = re.sub(r"\s*([\[(])\s*([^\])]*?)\s*([\])])", r"\1\2\3", header)
    fields = split(joined, separator)
    columns: dict[str, int] = {}
    factors: dict[str, float] = {}
    for index, field in enumerate(fields):
        match = _FIELD.fullmatch(field)
        what = _NAMES.get(match[1]) if match else None
        if match is None or what is None:
            continue
        if what in columns:
            raise FormatError(f"column {what} appears twice: rename the one that is not meant", name, line)
        unit = match[2] or _DEFAULTS[what]
        if unit not in _UNITS[what]:
            known = ", ".join(_UNITS[what])
            raise FormatError(f"unit {shown(unit)} of column {what}: only {known} are read", name, line)
        columns[what], factors[what] = index, _UNITS[what][unit]
    if "t" not in columns or not ({"x", "y"} <= columns.keys() or "feed" in columns):
        raise FormatError(f"expected a header t,x,y or t,feed, found {shown(header)}", name, line)
    return columns, factors, len(fields)


def _line_by_line(
    text: str, begin: int, header: int, separator: str | None, width: int, columns: dict[str, int], name: str
) -> tuple[Floats, Ints]:
    """Rows one by one: for columns of text between the numbers, and to name the line that is wrong."""
    rows, lines = [], []
    for number, line in enumerate(text[begin:].split("\n"), header + 1):
        if not line.strip():
            continue
        fields = split(line, separator)
        if len(fields) != width:
            raise FormatError(f"{len(fields)} fields under a header of {width}", name, number)
        for index in columns.values():
            if not is_number(fields[index], separator):
                raise FormatError(why_no_number(fields[index], separator), name, number)
        rows.append([float(fields[index].replace(",", ".")) for index in columns.values()])
        lines.append(number)
    return np.array(rows, dtype=float).reshape(len(rows), len(columns)), np.array(lines, dtype=np.int64)


def _check(values: Floats, t: Floats, lines: Ints, name: str) -> None:
    if len(t) < _LEAST:
        raise FormatError(f"{len(t)} samples are too few for a trace: log at least {_LEAST}", name)
    wrong = np.flatnonzero(~np.isfinite(values).all(axis=1))
    if len(wrong):
        raise FormatError("a number is too large", name, int(lines[wrong[0]]))
    step = np.diff(t)
    wrong = np.flatnonzero(step <= 0)
    if len(wrong):
        raise FormatError("the time does not increase: is this one trace?", name, int(lines[wrong[0] + 1]))
    wrong = np.flatnonzero(step > _GAP * np.median(step))
    if len(wrong):
        raise FormatError("samples are missing before this line: log at an even rate", name, int(lines[wrong[0] + 1]))
