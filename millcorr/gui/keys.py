# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys that belong to a form: FreeCAD's own shortcuts without a modifier would take them, the space bar first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .qt import QtCore

_OURS = (QtCore.Qt.KeyboardModifier.NoModifier, QtCore.Qt.KeyboardModifier.ShiftModifier)
_RETURN = (QtCore.Qt.Key.Key_Return, QtCore.Qt.Key.Key_Enter)


class _Keeper(QtCore.QObject):
    def __init__(self, form: Any, busy: Callable[[], bool]) -> None:
        super().__init__(form)
        self._busy = busy

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Tell Qt that a plain key is no shortcut, and keep Return while something is being computed."""
        kind = event.type()
        if kind == QtCore.QEvent.Type.ShortcutOverride and event.modifiers() in _OURS:
            event.accept()
            return True
        # Fields pass Return on when they have taken it.
        return bool(kind == QtCore.QEvent.Type.KeyPress and event.key() in _RETURN and self._busy())


def keep(form: Any, busy: Callable[[], bool]) -> None:
    """Let a form and all in it have plain keys for themselves.

    Return ends the entry of a field. It means OK only where that changed nothing: what is accepted was looked at.
    """
    form.installEventFilter(_Keeper(form, busy))
