# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the columns of a text file mean, written down once as TOML and used for every file of that layout."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.whole_file import write_whole

from .reading import KINDS
from .source import LARGEST_BALL, shown
from .toml_table import toml_table

COLUMNS = ("x", "y", "z", "i", "j", "k", "nominal_x", "nominal_y", "nominal_z", "deviation", "id")
"""What a column can be."""

TRAVEL_COLUMNS = ("travel", "travel_x", "travel_y", "travel_z")
"""What else a column can be where a control shifted the points along the axis of travel."""

SEPARATORS = {"comma": ",", "semicolon": ";", "tab": "\t", "blank": None}
"""Separators by name; any other single character that is no part of a number can be given itself."""

DECIMALS = {"point": ".", "comma": ","}

PLANES = {"xy": 1.0, "yz": 1.0, "zx": 1.0, "xz": -1.0, "zy": -1.0, "yx": -1.0}
"""Sign of the third axis behind the two of the contour, by the names of these two."""

_LAST_LINE = 1_000_000
_LAST_COLUMN = 10_000


@dataclass(frozen=True, slots=True)
class TextMapping:
    r"""Layout of a text file with one measured point a row.

    Parameters
    ----------
    columns : dict of str to (str or int)
        For each of `COLUMNS` and `TRAVEL_COLUMNS` that the file has, the column's name in the header, or its number
        from 1.
    separator : str
        Name from `SEPARATORS`, or one character.
    decimal : {"point", "comma"}
        Decimal mark.
    header : int, optional
        Number of the line with the names, from 1; by default the first that has all of them.
    skip : int
        So many lines at the head of the file are no rows.
    end : str
        The first line below the header that begins with this, and all behind it, are no rows; empty: none.
    comments : tuple of str
        From one of these on, at the start of a line or behind a blank, comma or semicolon, a line is no data.
    encoding : str, optional
        Python's name of the encoding, where it is not UTF-8, UTF-16 or Windows-1252.
    units : {"mm", "inch"}, optional
        Unit of coordinates and deviations.
    factor : float, optional
        Millimetres in the unit of coordinates and deviations, where that is another: 0.001 for micrometres.
    plane : {"xy", "xz", "yx", "yz", "zx", "zy"}
        Columns of the file that are the contour's X and Y; the third becomes its Z, of the sign that keeps the frame
        right-handed. Contour instruments measure in "xz".
    points : {"contact", "centre", "axis"}, optional
        What the coordinates are.
    probe_radius : float, optional
        Radius of the probe ball in mm, whatever the unit of the file.
    only : dict of str to tuple of str
        Only rows count in which these columns, by name or number, hold one of these texts, in upper or lower case.
    name : str
        What the layout is called.
    source : str
        File that the mapping came from.
    """

    columns: dict[str, str | int]
    separator: str = "comma"
    decimal: str = "point"
    header: int | None = None
    skip: int = 0
    end: str = ""
    comments: tuple[str, ...] = ("#", "//")
    encoding: str | None = None
    units: str | None = None
    factor: float | None = None
    plane: str = "xy"
    points: str | None = None
    probe_radius: float | None = None
    only: dict[str, tuple[str, ...]] = field(default_factory=dict)
    name: str = ""
    source: str = field(default="", compare=False)

    def __post_init__(self) -> None:
        for item in fields(self):
            if item.name in _CHECKS:
                _check(item.name, getattr(self, item.name), self.source)
        _check_together(self)


def load(path: str | Path) -> TextMapping:
    """Mapping from a TOML file.

    Raises
    ------
    FormatError
        If the file cannot be read, or a key is unknown or has no such value; names the file and the key.
    """
    known = [item.name for item in fields(TextMapping) if item.name != "source"]
    return _from_table(toml_table(path, phrase("mapping"), known), str(path))


def save(path: str | Path, mapping: TextMapping) -> Path:
    """Write a mapping as TOML that `load` takes back; the file is replaced as a whole."""
    head, tables = ["# SPDX-License-Identifier: LGPL-2.1-or-later"], []
    for item in fields(mapping):
        value = getattr(mapping, item.name)
        if item.name == "source" or value is None or value == "":
            continue
        if isinstance(value, dict):
            rows = [f"{_quoted(key)} = {_in_toml(v)}" for key, v in value.items()]
            tables += ["", f"[{item.name}]", *rows] if rows else []
        else:
            head.append(f"{item.name} = {_in_toml(value)}")
    return write_whole(Path(path), "\n".join([*head, *tables, ""]))


def _in_toml(value: object) -> str:
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, tuple):
        return "[" + ", ".join(map(_quoted, value)) + "]"
    return repr(value)


def axes_of(plane: str) -> str:
    """Names of the file's axes that are the contour's X, Y and Z."""
    return plane + next(axis for axis in "xyz" if axis not in plane)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _from_table(table: dict[str, Any], name: str) -> TextMapping:
    if "columns" not in table:
        raise FormatError(phrase("[columns] is missing: it says at least which columns are x and y"), name)
    values = dict(table)
    if isinstance(values.get("comments"), list):
        values["comments"] = tuple(values["comments"])
    if isinstance(values.get("probe_radius"), int) and not isinstance(values["probe_radius"], bool):
        values["probe_radius"] = float(min(values["probe_radius"], 10**9))
    if isinstance(values.get("factor"), int) and not isinstance(values["factor"], bool):
        values["factor"] = float(min(values["factor"], 10**9))
    if isinstance(values.get("only"), dict):
        values["only"] = {key: _texts(value) for key, value in values["only"].items()}
    return TextMapping(**values, source=name)


def _texts(value: object) -> object:
    return (value,) if isinstance(value, str) else tuple(value) if isinstance(value, list) else value


def _is_number(value: object, least: int, most: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def _is_text(value: object) -> bool:
    return isinstance(value, str) and "\n" not in value and "\r" not in value


def _is_encoding(value: object) -> bool:
    try:
        return isinstance(value, str) and b"1".decode(value) is not None
    except UnicodeError:
        return True
    except (LookupError, ValueError, TypeError):
        return False


def _is_separator(value: object) -> bool:
    if not isinstance(value, str):
        return False
    return value in SEPARATORS or (len(value) == 1 and " " < value < "\x7f" and not re.match(r'[\w.+"-]', value))


def _is_place(value: object) -> bool:
    return _is_number(value, 1, _LAST_COLUMN) or (_is_text(value) and bool(str(value).strip()))


def _are_texts(value: object) -> bool:
    return isinstance(value, tuple) and bool(value) and all(map(_is_text, value))


_CHECKS: dict[str, tuple[Callable[[object], bool], str]] = {
    "separator": (_is_separator, phrase("comma, semicolon, tab, blank, or one character that is no part of a number")),
    "decimal": (lambda v: isinstance(v, str) and v in DECIMALS, phrase("point or comma")),
    "header": (lambda v: v is None or _is_number(v, 1, _LAST_LINE), phrase("the number of a line, from 1")),
    "skip": (lambda v: _is_number(v, 0, _LAST_LINE), phrase("a number of lines, from 0")),
    "end": (_is_text, phrase("a text")),
    "comments": (
        lambda v: v == () or (_are_texts(v) and isinstance(v, tuple) and all(t.strip() for t in v)),
        phrase("a list of texts"),
    ),
    "encoding": (lambda v: v is None or _is_encoding(v), phrase("the name of an encoding of text")),
    "units": (lambda v: v is None or v in ("mm", "inch"), phrase("mm or inch")),
    "factor": (
        lambda v: v is None or (isinstance(v, float) and 1e-9 <= v <= 1e3),
        phrase("the millimetres in the unit of the file, such as 0.001"),
    ),
    "plane": (lambda v: v in PLANES, phrase("one of {}", ", ".join(PLANES))),
    "points": (lambda v: v is None or v in KINDS, phrase("contact or centre, or axis")),
    "probe_radius": (
        lambda v: v is None or (isinstance(v, float) and math.isfinite(v) and 0 < v <= LARGEST_BALL),
        phrase("the radius of the probe ball in mm, up to {:g}", LARGEST_BALL),
    ),
    "name": (_is_text, phrase("a text")),
    "columns": (lambda v: isinstance(v, dict), phrase("a table")),
    "only": (lambda v: isinstance(v, dict), phrase("a table")),
}


def _check(key: str, value: object, source: str) -> None:
    test, wanted = _CHECKS[key]
    if not test(value):
        raise FormatError(phrase("{} is {}, not {}", key, wanted, shown(repr(value))), source or None)


def _check_together(mapping: TextMapping) -> None:
    """FormatError where the values of two keys, or of a table, do not go together."""

    def refuse(message: str) -> None:
        raise FormatError(message, mapping.source or None)

    columns = mapping.columns
    for key, place in columns.items():
        if key not in COLUMNS + TRAVEL_COLUMNS:
            refuse(phrase("columns: {} is none of {}", shown(key), ", ".join(COLUMNS + TRAVEL_COLUMNS)))
        if not _is_place(place):
            refuse(phrase("columns.{} is a name in the header or a number from 1, not {}", key, shown(repr(place))))
    if len({str(p).strip().casefold() if isinstance(p, str) else p for p in columns.values()}) < len(columns):
        refuse(phrase("columns: two are the same column of the file"))
    for key, texts in mapping.only.items():
        if not _are_texts(texts):
            refuse(phrase("only: {} is a text or a list of texts, not {}", shown(key), shown(repr(texts))))
        if not key.strip() or (key.isdecimal() and not (key.isascii() and 1 <= int(key[:9]) <= _LAST_COLUMN)):
            refuse(phrase("only: {} is no column", shown(key)))
    groups = (
        ("x", "y", "z"),
        ("i", "j", "k"),
        ("nominal_x", "nominal_y", "nominal_z"),
        TRAVEL_COLUMNS[1:],
    )
    for group in groups:
        first, second, third = (group["xyz".index(axis)] for axis in axes_of(mapping.plane))
        there = {first, second, third} & columns.keys()
        if (there or group[0] == "x") and not {first, second} <= there:
            refuse(phrase("columns: {} is missing", first if first not in there else second))
    height = axes_of(mapping.plane)[2]
    if any(c.startswith("nominal_") for c in columns) and (f"nominal_{height}" in columns) != (height in columns):
        refuse(phrase("columns: {} and nominal_{} go together", height, height))
    if mapping.factor is not None and mapping.units is not None:
        refuse(phrase("units and factor say the same twice"))
    if columns.keys() & TRAVEL_COLUMNS and mapping.points in ("contact", "centre"):
        refuse(phrase("columns: directions of travel are for points = 'axis'"))
    if {"travel", "travel_x"} <= columns.keys():
        refuse(phrase("columns: travel and travel_x say the same twice"))
    if mapping.probe_radius is not None and mapping.points == "contact":
        refuse(phrase("probe_radius is for points = 'centre'; contact points need none"))
    if mapping.decimal == "comma" and mapping.separator in ("comma", ","):
        refuse(phrase("decimal and separator cannot both be the comma"))
