# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first rows of a measured file, as a person looks at them who has to say what the columns are."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from millcorr.errors import FormatError

from . import FORMATS, recognised
from .decoding import decode
from .fields import split
from .mapping import SEPARATORS, TextMapping
from .text_layout import find_layout

HEAD = 65536
"""So many bytes of a file are enough to look at."""

_NUMBER = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?")
_COMMA = re.compile(r"[+-]?\d*,\d+")


@dataclass(frozen=True, slots=True)
class Preview:
    """The beginning of a file.

    Parameters
    ----------
    format : str
        Name from `readers.FORMATS`.
    lines : tuple of str
        First lines; none of a binary file.
    cells : tuple of tuple of str
        Their fields; none where the format is not a plain table.
    separator : str
        Name from `mapping.SEPARATORS`.
    decimal : {"point", "comma"}
    first : int
        Index from 0 of the line where numbers begin.
    columns : dict of str to int
        Column from 1 of x, y, z, i, j, k where the file itself tells; empty where it does not.
    """

    format: str
    lines: tuple[str, ...] = ()
    cells: tuple[tuple[str, ...], ...] = ()
    separator: str = "comma"
    decimal: str = "point"
    first: int = 0
    columns: Mapping[str, int] | None = None

    @property
    def is_table(self) -> bool:
        """Whether its columns can be given a meaning."""
        return bool(self.cells)

    def mapped(self, columns: Mapping[str, int]) -> TextMapping:
        """Mapping that gives columns, counted from 1, their meaning; FormatError where it makes no sense."""
        return TextMapping(dict(columns), self.separator, self.decimal, skip=self.first)


def preview(head: bytes, name: str, rows: int = 12) -> Preview:
    """What a file begins with.

    Parameters
    ----------
    head : bytes
        Its first bytes, `HEAD` of them or all.
    name : str
    rows : int
        So many lines.

    Returns
    -------
    Preview
        Whatever the file is: one that is no text has no lines.
    """
    kind = recognised(head)
    try:
        text = decode(head, name)
    except FormatError:
        return Preview(kind)
    lines = text.split("\n")
    # The last line may be cut off.
    lines = (lines[:-1] if len(lines) > 1 else lines)[:200]
    if kind != list(FORMATS)[-1]:
        return Preview(kind, tuple(lines[:rows]))
    separator, first = _table(lines)
    sample = lines[first : first + rows]
    fields = [split(line, SEPARATORS[separator]) for line in sample]
    comma = separator != "comma" and any(_COMMA.fullmatch(field) for row in fields for field in row)
    columns: dict[str, int] = {}
    try:
        columns = {key: at + 1 for key, at in find_layout("\n".join(lines) + "\n", name).columns.items()}
    except FormatError:
        # That it does not tell is no error here: the user will.
        pass
    shown = tuple(lines[:rows])
    cells = tuple(tuple(split(line, SEPARATORS[separator])) for line in shown)
    return Preview(kind, shown, cells, separator, "comma" if comma else "point", first, columns)


def _table(lines: list[str]) -> tuple[str, int]:
    """Separator by name, and index of the first line of numbers: the separator under which most lines are rows."""
    best: tuple[int, str, int] | None = None
    for name, character in (("tab", "\t"), ("semicolon", ";"), ("comma", ","), ("blank", None)):
        rows = [
            k
            for k, line in enumerate(lines)
            if (character is None or character in line) and _is_row(split(line, character))
        ]
        if rows and (best is None or len(rows) > best[0]):
            best = len(rows), name, rows[0]
    return ("comma", 0) if best is None else best[1:]


def _is_row(fields: list[str]) -> bool:
    """Whether at least two fields of a line are numbers."""
    return sum(_NUMBER.fullmatch(field) is not None for field in fields) >= 2
