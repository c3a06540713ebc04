# SPDX-License-Identifier: LGPL-2.1-or-later
"""Excel workbooks (``.xlsx``) as text: the cells of one sheet, tabs between them, which the other readers take on.

Read by openpyxl, which is needed for nothing else. Numbers keep all their digits, dates stay dates and are refused
where a coordinate should be.
"""

from __future__ import annotations

import importlib
import io
import zipfile
from datetime import date, time
from typing import Any

from millcorr.errors import FormatError, UsageError

from .source import shown

PACKAGE = "openpyxl"

_MAGIC = b"PK\x03\x04"
_WORKBOOK = b"xl/workbook.xml"
_LARGEST = 1 << 30
_TIGHTEST = 200
"""XML of numbers is packed to a tenth; what is packed to less than a 200th is no workbook of points."""


def recognises(data: bytes) -> bool:
    """Whether a file is a ZIP container that lists an Excel workbook."""
    return data.startswith(_MAGIC) and _WORKBOOK in data


def as_text(data: bytes, name: str) -> tuple[bytes, str]:
    """Cells of the sheet that the workbook shows first, as UTF-8 text, a line a row; and a note about it.

    Raises
    ------
    FormatError
        If the workbook is damaged, declares a document type, or its sheet is empty.
    UsageError
        If openpyxl is not installed.
    """
    try:
        library = importlib.import_module(PACKAGE)
    except ImportError as error:
        raise UsageError(
            f"Excel workbooks are read by the Python package {PACKAGE}, which is not installed: pip install {PACKAGE}, "
            "or save the points as CSV"
        ) from error
    _refuse_dangerous(data, name)
    try:
        book = library.load_workbook(io.BytesIO(data), read_only=True, data_only=True)
        try:
            sheet = book.active
            title, count = str(sheet.title), len(book.sheetnames)
            rows = ["\t".join(_cell(value) for value in row).rstrip("\t") for row in sheet.iter_rows(values_only=True)]
        finally:
            book.close()
    except Exception as error:  # noqa: BLE001 - whatever a foreign library raises, the file is the cause
        reason = shown(" ".join(str(error).split()) or type(error).__name__)
        raise FormatError(f"{PACKAGE} cannot read it, {reason}: the workbook is damaged or cut off", name) from error
    while rows and not rows[-1]:
        rows.pop()
    if not rows:
        raise FormatError(f"sheet {shown(title)} is empty: save the workbook with the sheet of the points shown", name)
    note = f"sheet {shown(title)} of the workbook" + (f", the one shown of {count}" if count > 1 else "")
    return ("\n".join(rows) + "\n").encode(), note


def _cell(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (date, time)):
        return value.isoformat()
    return " ".join(str(value).split())


def _refuse_dangerous(data: bytes, name: str) -> None:
    """FormatError for a container that unpacks to absurd sizes or holds XML with a document type."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as container:
            size = sum(entry.file_size for entry in container.infolist())
            if size > min(_LARGEST, _TIGHTEST * len(data)):
                raise FormatError("the workbook unpacks to absurd sizes: not a table of points", name)
            for entry in container.infolist():
                with container.open(entry) as part:
                    if b"<!DOCTYPE" in part.read(4096):
                        raise FormatError("the workbook's XML declares a document type: save it again", name)
    except FormatError:
        raise
    except Exception as error:  # noqa: BLE001 - a damaged container raises half a dozen kinds
        raise FormatError("the workbook is damaged or cut off: save it again, or as CSV", name) from error
