# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that can be read in a light and in a dark window, and what is to be drawn anew when it changes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from millcorr.report.plots import COLOURS

from . import preferences
from .qt import QtCore, QtGui, QtWidgets

_KINDS = {"wrong": "220, 40, 40", "doubt": "230, 160, 0", "good": "40, 160, 80"}

_LABEL = "background: rgba({0}, 50); border-left: 3px solid rgb({0}); padding: 3px 3px 3px 8px;"

FADED = "QPushButton:disabled { color: rgba(128, 128, 128, 150); }"
"""Style sheet of a button: FreeCAD's dark ones paint a disabled button as, or brighter than, one that can be pressed.

Half of a middle grey is faint on a light button and on a dark one.
"""

STYLE = "\n".join([FADED, *(f'QLabel[millcorr="{kind}"] {{ {_LABEL.format(rgb)} }}' for kind, rgb in _KINDS.items())])
"""Style sheet of a form, with its labels whose property ``millcorr`` says what they are.

The text keeps the window's own colour: style sheets change it without the palette telling, so a tint that lets
the window's background through is all that can be read in both.
"""


def mark(label: Any, kind: str) -> None:
    """Say what a label is that is there already: a note, a "doubt", "good", or what is "wrong"."""
    label.setProperty("millcorr", kind)
    label.style().unpolish(label)
    label.style().polish(label)
    # Qt takes frame and padding of a style sheet anew only when it is told of a change.
    QtWidgets.QApplication.sendEvent(label, QtCore.QEvent(QtCore.QEvent.Type.StyleChange))


def theme() -> str:
    """Light or dark: that of the window, or what the preferences say of plots."""
    chosen = str(preferences.get("Plots"))
    if chosen in COLOURS:
        return chosen
    # The palette does not tell what a style sheet does: what is painted does.
    window = FreeCADGui.getMainWindow()
    pixel = window.statusBar().grab(QtCore.QRect(1, 1, 2, 2)).toImage().pixelColor(0, 0)
    return "dark" if pixel.lightness() < 128 else "light"


def colours() -> dict[str, str]:
    """Colours of plots by role, as `millcorr.report.plots.COLOURS` has them."""
    return COLOURS[theme()]


class ThemeWatch(QtCore.QObject):  # type: ignore[misc]
    """Calls back when the theme has changed since a widget was last painted with it.

    Parameters
    ----------
    widget : QWidget
    changed : callable
    """

    def __init__(self, widget: Any, changed: Callable[[], None]) -> None:
        super().__init__(widget)
        self._seen, self._changed = theme(), changed
        # Once the window has taken on its new looks.
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._look)
        widget.installEventFilter(self)

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Qt tells every event of the widget; none is kept from it."""
        kinds = QtCore.QEvent.Type
        if event.type() in (kinds.StyleChange, kinds.PaletteChange, kinds.Show):
            self._soon.start(0)
        return False

    def _look(self) -> None:
        now = theme()
        if now != self._seen:
            self._seen = now
            self._changed()


def tint(toolbar: Any, colour: str) -> None:
    """Give the icons of a toolbar one colour: those of matplotlib are black for good."""
    for action in toolbar.actions():
        if action.icon().isNull():
            continue
        pixmap = action.icon().pixmap(24, 24)
        painter = QtGui.QPainter(pixmap)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode.CompositionMode_SourceIn)
        painter.fillRect(pixmap.rect(), QtGui.QColor(colour))
        painter.end()
        action.setIcon(QtGui.QIcon(pixmap))
