# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wheel scrolls a form; it changes a field only where the field has the focus."""

from __future__ import annotations

from typing import Any

from .qt import QtCore, QtWidgets


class _Guard(QtCore.QObject):
    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Hand the wheel on to what lies below a field without the focus."""
        if event.type() != QtCore.QEvent.Type.Wheel or watched.hasFocus():
            return False
        event.ignore()
        return True


_KINDS = (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox, QtWidgets.QAbstractSlider)


def calm(widget: Any) -> Any:
    """Keep the wheel from a number, a choice or a slider that has not the focus; gives the widget."""
    if isinstance(widget, _KINDS):
        # By default the wheel itself gives the focus.
        widget.setFocusPolicy(QtCore.Qt.FocusPolicy.StrongFocus)
        widget.installEventFilter(_Guard(widget))
    return widget
