# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots as the report draws them, where matplotlib is missing."""

from __future__ import annotations

from typing import Any

from PySide import QtSvg

from .qt import QtCore, QtGui, QtWidgets


class Drawing(QtWidgets.QWidget):
    """An SVG drawing, as large as there is room, in its own proportions."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumSize(200, 90)
        self._drawing: Any = None
        self._paper = QtGui.QColor("white")

    def show_svg(self, text: str, paper: str) -> None:
        """Show a drawing on paper of a colour."""
        self._drawing = QtSvg.QSvgRenderer(QtCore.QByteArray(text.encode("utf-8")))
        self._paper = QtGui.QColor(paper)
        self.update()

    def empty(self) -> None:
        """Show nothing."""
        self._drawing = None
        self.update()

    @property
    def drawn(self) -> bool:
        """Whether there is a drawing."""
        return self._drawing is not None and self._drawing.isValid()

    def paintEvent(self, event: Any) -> None:
        """Qt asks for it."""
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), self._paper)
        if self.drawn:
            size = QtCore.QSizeF(self._drawing.defaultSize())
            size.scale(QtCore.QSizeF(self.size()), QtCore.Qt.AspectRatioMode.KeepAspectRatio)
            left, top = (self.width() - size.width()) / 2, (self.height() - size.height()) / 2
            self._drawing.render(painter, QtCore.QRectF(left, top, size.width(), size.height()))
        painter.end()
