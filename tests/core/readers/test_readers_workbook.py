# SPDX-License-Identifier: LGPL-2.1-or-later
"""Workbooks, where openpyxl and odfpy are installed."""

import datetime
import importlib
import io
import zipfile

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from millcorr.readers import workbook
from millcorr.readers.mapping import TextMapping

PLACES = [[10.123456789, 20.5, -3.0], [1 / 3, -7.25, -3.0], [14.0, 21.125, -3.0]]


def bare(parts):
    """A container of the parts' text by name, that lists a workbook."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as container:
        for name, content in {"xl/workbook.xml": "<workbook/>", **parts}.items():
            container.writestr(name, content)
    return out.getvalue()


@pytest.fixture
def saved(tmp_path):
    """Function that saves sheets of rows as a workbook; the last one is shown."""
    library = pytest.importorskip("openpyxl")

    def make(sheets):
        book = library.Workbook()
        book.remove(book.active)
        for title, rows in sheets.items():
            sheet = book.create_sheet(title)
            for row in rows:
                sheet.append(row)
        book.active = len(sheets) - 1
        path = tmp_path / "points.xlsx"
        book.save(path)
        return path

    return make


def test_columns_of_a_sheet(saved):
    path = saved({"Notes": [["made by hand"]], "Points": [["Plate 12"], [], ["Nr", "X", "Y", "Z"]] + [
        [f"P{k}", *place] for k, place in enumerate(PLACES)
    ]})  # fmt: skip
    m = readers.read(path, points="contact")
    # Every digit of every number.
    np.testing.assert_array_equal(m.points, PLACES)
    np.testing.assert_array_equal(m.lines, [4, 5, 6])
    assert m.format == "text" and m.notes[0] == "sheet 'Points' of the workbook, the one shown of 2"
    mapping = TextMapping({"id": "Nr", "x": "X", "y": "Y"}, separator="tab")
    assert readers.read(path, points="contact", mapping=mapping).elements == ("P0", "P1", "P2")


def test_a_sheet_without_a_header(saved):
    m = readers.read(saved({"Points": PLACES}), points="contact")
    np.testing.assert_array_equal(m.points, PLACES)


def test_a_number_that_became_a_date_is_refused(saved):
    rows = [["x", "y"], [1.5, 2.5], [datetime.datetime(2024, 5, 12), 3.5]]
    with pytest.raises(FormatError, match="is a date: a spreadsheet has spoilt the number") as caught:
        readers.read(saved({"Points": rows}), points="contact")
    assert caught.value.line == 3


def test_an_empty_sheet_and_a_damaged_workbook(saved):
    path = saved({"Points": PLACES, "Empty": []})
    with pytest.raises(FormatError, match="sheet 'Empty' is empty"):
        readers.read(path, points="contact")
    data = saved({"Points": PLACES}).read_bytes()
    for damaged in (data[: len(data) // 2] + b"xl/workbook.xml", data.replace(b"xl/worksheets", b"xl/worksheetz")):
        path.write_bytes(damaged)
        with pytest.raises(FormatError, match="damaged|cannot read it"):
            readers.read(path, points="contact")


@pytest.mark.parametrize(
    ("parts", "says"),
    [
        ({"xl/a.xml": '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY b "c">]><a/>'}, "document type"),
        ({"xl/a.xml": " " * 4_000_000}, "absurd sizes"),
    ],
)
def test_dangerous_containers_are_refused_before_the_library_sees_them(tmp_path, monkeypatch, parts, says):
    monkeypatch.setattr(importlib, "import_module", lambda name: None)
    with pytest.raises(FormatError, match=says):
        workbook.as_text(bare(parts), "points.xlsx")


def test_a_missing_library_is_named(tmp_path, monkeypatch):
    def missing(name):
        raise ImportError(name)

    monkeypatch.setattr(importlib, "import_module", missing)
    path = tmp_path / "points.xlsx"
    path.write_bytes(bare({}))
    with pytest.raises(UsageError, match="pip install openpyxl, or save the points as CSV"):
        readers.read(path, points="contact")


@pytest.fixture
def open_document(tmp_path):
    """Function that saves sheets of rows as an OpenDocument workbook; the sheet named is shown."""
    pytest.importorskip("odf")

    def make(sheets, active):
        from odf import config, opendocument, table, text

        book = opendocument.OpenDocumentSpreadsheet()
        for title, rows in sheets.items():
            sheet = table.Table(name=title)
            for row in rows:
                line = table.TableRow()
                for value in row:
                    if isinstance(value, float):
                        cell = table.TableCell(valuetype="float", value=repr(value))
                        cell.addElement(text.P(text=f"{value:.2f}"))
                    elif isinstance(value, datetime.date):
                        cell = table.TableCell(valuetype="date", datevalue=value.isoformat())
                    elif value is None:
                        cell = table.TableCell(numbercolumnsrepeated=2)
                    else:
                        cell = table.TableCell(valuetype="string")
                        cell.addElement(text.P(text=value))
                    line.addElement(cell)
                line.addElement(table.TableCell(numbercolumnsrepeated=16000))
                sheet.addElement(line)
            sheet.addElement(table.TableRow(numberrowsrepeated=2))
            book.spreadsheet.addElement(sheet)
        blank = table.TableRow(numberrowsrepeated=1_000_000)
        blank.addElement(table.TableCell(numbercolumnsrepeated=16_384))
        sheet.addElement(blank)
        item = config.ConfigItem(name="ActiveTable", type="string")
        item.addText(active)
        items = config.ConfigItemSet(name="ooo:view-settings")
        items.addElement(item)
        book.settings.addElement(items)
        path = tmp_path / "points.ods"
        book.save(str(path))
        return path

    return make


def test_columns_of_an_open_document_sheet_with_all_digits(open_document):
    rows = [["Plate 12"], [], ["Nr", "X", "Y", "Z"]] + [[f"P {k}", *place] for k, place in enumerate(PLACES)]
    path = open_document({"Notes": [["made by hand"]], "Points": rows, "Other": [["x"]]}, "Points")
    m = readers.read(path, points="contact")
    np.testing.assert_array_equal(m.points, PLACES)
    np.testing.assert_array_equal(m.lines, [4, 5, 6])
    assert m.notes[0] == "sheet 'Points' of the workbook, the one shown of 3"
    mapping = TextMapping({"id": "Nr", "x": "X", "y": "Y"}, separator="tab")
    assert readers.read(path, points="contact", mapping=mapping).elements == ("P 0", "P 1", "P 2")


def test_an_open_document_date_is_no_coordinate_and_blank_cells_are_counted(open_document):
    path = open_document({"A": [["x", "y", "z"], [1.5, datetime.date(2024, 2, 29), 3.5]]}, "A")
    with pytest.raises(FormatError, match="date") as caught:
        readers.read(path, points="contact")
    assert caught.value.line == 2
    path = open_document({"A": [["x", "y", "a", "b", "z"], [1.5, 2.5, None, 3.5], [2.5, 2.5, None, 3.25]]}, "A")
    np.testing.assert_array_equal(readers.read(path, points="contact").points, [[1.5, 2.5, 3.5], [2.5, 2.5, 3.25]])


def test_a_damaged_open_document_and_a_missing_library(open_document, monkeypatch):
    path = open_document({"A": [["x", "y"], [1.5, 2.5]]}, "A")
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    with pytest.raises(FormatError, match="damaged"):
        readers.read(path, points="contact")
    path.write_bytes(data)
    original = importlib.import_module

    def without(name, *rest):
        if name.startswith("odf"):
            raise ImportError(name)
        return original(name, *rest)

    monkeypatch.setattr(importlib, "import_module", without)
    with pytest.raises(UsageError, match="pip install odfpy"):
        readers.read(path, points="contact")
