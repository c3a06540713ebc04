# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small table of figures: a name, what it means, and a text in each column."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from millcorr.app.text import translate

from .panel import narrow
from .qt import QtCore, QtWidgets


class FigureTable(QtWidgets.QGroupBox):
    """Figures in rows; their number stays, their texts change.

    Parameters
    ----------
    title : str
        Translated.
    figures : sequence of Figure
    columns : sequence of str
        Headings, to be translated.
    """

    def __init__(self, title: str, figures: Sequence[Any], columns: Sequence[str] = ()) -> None:
        super().__init__(title)
        self.setObjectName("Figures")
        grid = QtWidgets.QGridLayout(self)
        grid.setColumnStretch(0, 1)
        grid.setVerticalSpacing(2)
        right = QtCore.Qt.AlignmentFlag.AlignRight
        for column, heading in enumerate(columns, 1):
            grid.addWidget(QtWidgets.QLabel(f"<b>{translate('Millcorr', heading)}</b>"), 0, column, right)
        self._cells: list[list[Any]] = []
        for row, figure in enumerate(figures, 1):
            name = narrow(QtWidgets.QLabel(figure.label))
            name.setToolTip(figure.meaning)
            grid.addWidget(name, row, 0)
            cells = []
            for column, _ in enumerate(figure.shown, 1):
                cell = QtWidgets.QLabel()
                cell.setToolTip(figure.meaning)
                cell.setObjectName(f"{figure.label} {column}")
                cell.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
                grid.addWidget(cell, row, column, right)
                cells.append(cell)
            self._cells.append(cells)
        self.fill(figures)

    def fill(self, figures: Sequence[Any]) -> None:
        """Show figures in place of those before."""
        for figure, cells in zip(figures, self._cells, strict=True):
            for cell, text in zip(cells, figure.shown, strict=True):
                cell.setText(text)
