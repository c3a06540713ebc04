# SPDX-License-Identifier: LGPL-2.1-or-later
"""Workbooks of Excel (``.xlsx``) and OpenDocument (``.ods``) as text: the cells of one sheet, tabs between them.

The other readers take that on. Read by openpyxl and odfpy, which are needed for nothing else. Numbers keep all their
digits, dates stay dates and are refused where a coordinate should be.
"""

from __future__ import annotations

import importlib
import io
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import date, time
from itertools import islice
from typing import Any

from millcorr.errors import FormatError, UsageError
from millcorr.messages import phrase

from .source import shown

_MAGIC = b"PK\x03\x04"
_EXCEL = b"xl/workbook.xml"
_OPEN_DOCUMENT = b"mimetypeapplication/vnd.oasis.opendocument.spreadsheet"
_LARGEST = 1 << 30
_TIGHTEST = 200
"""XML of numbers is packed to a tenth; what is packed to less than a 200th is no workbook of points."""
_WIDEST = 16_384
"""Columns that a sheet has at most."""


@dataclass(frozen=True, slots=True)
class _Sheet:
    """Title of a sheet, the texts of its rows' cells, and how many sheets the workbook has."""

    title: str
    rows: list[list[str]]
    count: int


@dataclass(frozen=True, slots=True)
class _Kind:
    """Kind of workbook: what it is called, the library that reads it as Python and as PyPI call it, and how."""

    name: str
    module: str
    package: str
    sheet: Callable[[Any, bytes], _Sheet]


def recognises(data: bytes) -> bool:
    """Whether a file is a ZIP container of an Excel or OpenDocument workbook."""
    return _kind(data) is not None


def as_text(data: bytes, name: str) -> tuple[bytes, str]:
    """Cells of the sheet that the workbook shows first, as UTF-8 text, a line a row; and a note about it.

    Raises
    ------
    FormatError
        If the workbook is damaged, declares a document type, or its sheet is empty.
    UsageError
        If the library that reads it is not installed.
    """
    kind = _kind(data)
    if kind is None:
        raise FormatError(phrase("no workbook"), name)
    try:
        library = importlib.import_module(kind.module)
    except ImportError as error:
        raise UsageError(
            phrase(
                "{} workbooks are read by the Python package {}, which is not installed: pip install {}, or "
                "save the points as CSV",
                kind.name,
                kind.package,
                kind.package,
            )
        ) from error
    refuse_dangerous(data, name, "workbook")
    try:
        sheet = kind.sheet(library, data)
    except Exception as error:  # noqa: BLE001 - whatever a foreign library raises, the file is the cause
        reason = shown(" ".join(str(error).split()) or type(error).__name__)
        raise FormatError(
            phrase("{} cannot read it, {}: the workbook is damaged or cut off", kind.package, reason), name
        ) from error
    rows = ["\t".join(row).rstrip("\t") for row in sheet.rows]
    while rows and not rows[-1]:
        rows.pop()
    if not rows:
        raise FormatError(
            phrase("sheet {} is empty: save the workbook with the sheet of the points shown", shown(sheet.title)), name
        )
    shown_of = phrase(", the one shown of {}", sheet.count) if sheet.count > 1 else ""
    return ("\n".join(rows) + "\n").encode(), phrase("sheet {} of the workbook{}", shown(sheet.title), shown_of)


def _of_excel(library: Any, data: bytes) -> _Sheet:
    book = library.load_workbook(io.BytesIO(data), read_only=True, data_only=True)
    try:
        sheet = book.active
        rows = [[_cell(value) for value in row] for row in sheet.iter_rows(values_only=True)]
        return _Sheet(str(sheet.title), rows, len(book.sheetnames))
    finally:
        book.close()


def _of_open_document(library: Any, data: bytes) -> _Sheet:
    book = library.load(io.BytesIO(data))
    tables = list(_named(book.spreadsheet, "table"))
    active = next((_text(item) for item in _items(book.settings) if item.getAttribute("name") == "ActiveTable"), "")
    table = next((t for t in tables if t.getAttribute("name") == active), tables[0])
    rows: list[list[str]] = []
    blank = 0
    for row in _named(table, "table-row"):
        cells = list(islice(_cells(row), _WIDEST))
        while cells and not cells[-1]:
            cells.pop()
        times = int(row.getAttribute("numberrowsrepeated") or 1)
        if not cells:
            # A sheet ends in a million blank rows.
            blank += times
            continue
        rows += [[]] * blank + [cells] * times
        blank = 0
    return _Sheet(str(table.getAttribute("name")), rows, len(tables))


def _named(element: Any, *names: str) -> Iterator[Any]:
    """Elements below one with these local names, in the order of the document."""
    for child in element.childNodes:
        if getattr(child, "qname", ("", ""))[1] in names:
            yield child
        elif child.hasChildNodes():
            yield from _named(child, *names)


def _items(settings: Any) -> Iterator[Any]:
    yield from _named(settings, "config-item")


def _cells(row: Any) -> Iterator[str]:
    """Texts of a row's cells, repeated ones as often as they are there."""
    for cell in _named(row, "table-cell", "covered-table-cell"):
        times = min(int(cell.getAttribute("numbercolumnsrepeated") or 1), _WIDEST)
        kind = cell.getAttribute("valuetype")
        told = {"float": "value", "percentage": "value", "currency": "value", "date": "datevalue", "time": "timevalue"}
        text = cell.getAttribute(told[kind]) if kind in told else " ".join(_text(p) for p in _named(cell, "p"))
        yield from [" ".join(str(text or "").split())] * times


def _text(element: Any) -> str:
    """All text in an element."""
    return "".join(_text(child) if child.hasChildNodes() else str(getattr(child, "data", "")) for child in
                   element.childNodes)  # fmt: skip


_EXCEL_BOOK = _Kind("Excel", "openpyxl", "openpyxl", _of_excel)
_OPEN_DOCUMENT_BOOK = _Kind("OpenDocument", "odf.opendocument", "odfpy", _of_open_document)


def _kind(data: bytes) -> _Kind | None:
    if not data.startswith(_MAGIC):
        return None
    if _OPEN_DOCUMENT in data[:256]:
        return _OPEN_DOCUMENT_BOOK
    return _EXCEL_BOOK if _EXCEL in data else None


def _cell(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (date, time)):
        return value.isoformat()
    return " ".join(str(value).split())


def refuse_dangerous(data: bytes, name: str, what: str) -> None:
    """FormatError for a ZIP container that unpacks to absurd sizes or holds XML with a document type."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as container:
            size = sum(entry.file_size for entry in container.infolist())
            if size > min(_LARGEST, _TIGHTEST * len(data)):
                raise FormatError(phrase("the {} unpacks to absurd sizes: not one of points", what), name)
            for entry in container.infolist():
                with container.open(entry) as part:
                    if b"<!DOCTYPE" in part.read(4096):
                        raise FormatError(phrase("the {}'s XML declares a document type: save it again", what), name)
    except FormatError:
        raise
    except Exception as error:  # noqa: BLE001 - a damaged container raises half a dozen kinds
        raise FormatError(phrase("the {} is damaged or cut off: save it again", what), name) from error
