# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first rows of a file, with what each column means above it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from millcorr.app.text import translate
from millcorr.readers.mapping import COLUMNS
from millcorr.readers.preview import Preview

from .qt import QtGui, QtWidgets
from .wheel import calm


class FilePreview(QtWidgets.QTableWidget):
    """A table whose first row says what the columns are.

    Parameters
    ----------
    changed : callable
        Called when the user gives a column another meaning.
    """

    def __init__(self, changed: Callable[[], None]) -> None:
        super().__init__()
        self._changed = changed
        self._boxes: list[Any] = []
        self._told: dict[str, int] = {}
        self.setObjectName("Preview")
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.NoSelection)
        # Tab goes on to the next field of the dialog; arrows move in the table.
        self.setTabKeyNavigation(False)
        self.setMinimumHeight(150)

    def fill(self, seen: Preview) -> None:
        """Show the beginning of a file."""
        self.clear()
        self._boxes = []
        self._told = dict(seen.columns or {})
        if not seen.is_table:
            self.setColumnCount(1)
            self.setRowCount(len(seen.lines))
            self.setHorizontalHeaderLabels([seen.format or translate("Millcorr", "no file yet")])
            self.setVerticalHeaderLabels([str(k + 1) for k in range(len(seen.lines))])
            for k, line in enumerate(seen.lines):
                self.setItem(k, 0, QtWidgets.QTableWidgetItem(line[:400]))
            self.resizeColumnsToContents()
            return
        width = max(len(row) for row in seen.cells)
        self.setColumnCount(width)
        self.setRowCount(len(seen.cells) + 1)
        self.setHorizontalHeaderLabels([str(k + 1) for k in range(width)])
        self.setVerticalHeaderLabels(["", *(str(k + 1) for k in range(len(seen.cells)))])
        meaning = {at: name for name, at in self._told.items()}
        for column in range(width):
            box = calm(QtWidgets.QComboBox())
            box.setObjectName(f"Column {column + 1}")
            box.setAccessibleName(translate("Millcorr", "Meaning of column {}").format(column + 1))
            box.addItem(translate("Millcorr", "not used"), "")
            for name in COLUMNS:
                box.addItem(name, name)
            box.setCurrentIndex(max(0, box.findData(meaning.get(column + 1, ""))))
            box.currentIndexChanged.connect(lambda *_: self._changed())
            self.setCellWidget(0, column, box)
            self._boxes.append(box)
        grey = self.palette().brush(QtGui.QPalette.ColorGroup.Disabled, QtGui.QPalette.ColorRole.Text)
        for k, row in enumerate(seen.cells):
            for column, text in enumerate(row):
                item = QtWidgets.QTableWidgetItem(text[:200])
                if k < seen.first:
                    item.setForeground(grey)
                self.setItem(k + 1, column, item)
        self.resizeColumnsToContents()

    def set_column(self, number: int, meaning: str) -> None:
        """Give a column, from 1, a meaning as if the user had."""
        box = self._boxes[number - 1]
        box.setCurrentIndex(box.findData(meaning))

    def changed_columns(self) -> dict[str, int] | None:
        """Column, from 1, of each meaning, where that is not what the file itself tells; else None."""
        chosen = {box.currentData(): k for k, box in enumerate(self._boxes, 1) if box.currentData()}
        return None if chosen == self._told or not chosen else chosen
