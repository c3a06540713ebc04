# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of a form that is folded away until it is wanted."""

from __future__ import annotations

from typing import Any

from .qt import QtCore, QtWidgets


class Fold(QtWidgets.QWidget):
    """A heading with an arrow, and below it what it hides; the space bar opens and closes it.

    Parameters
    ----------
    title : str
    inner : QWidget
    """

    def __init__(self, title: str, inner: Any) -> None:
        super().__init__()
        self._button = QtWidgets.QToolButton()
        self._button.setText(title)
        self._button.setCheckable(True)
        self._button.setAutoRaise(True)
        self._button.setToolButtonStyle(QtCore.Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._button.setFocusPolicy(QtCore.Qt.FocusPolicy.StrongFocus)
        self._button.setArrowType(QtCore.Qt.ArrowType.RightArrow)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._button)
        layout.addWidget(inner)
        inner.hide()
        self._inner = inner
        self._button.toggled.connect(self._toggled)

    def _toggled(self, opened: bool) -> None:
        arrows = QtCore.Qt.ArrowType
        self._button.setArrowType(arrows.DownArrow if opened else arrows.RightArrow)
        self._inner.setVisible(opened)

    def isChecked(self) -> bool:
        """Whether it is open."""
        return bool(self._button.isChecked())

    def setChecked(self, opened: bool) -> None:
        """Open or close it."""
        self._button.setChecked(opened)
