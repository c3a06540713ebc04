# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a task on files stands: in a window of its own, or docked where FreeCAD's tree and tasks are.

What shows something of itself in the 3-D view is docked: it covers neither the view nor the tree.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from millcorr.app.text import translate

from . import guide
from .qt import QtCore, QtWidgets
from .screen import fit

WIDTH = 440
"""Width of a dock, pixels."""

_FREECADS = ("Combo View", "Model", "Tree view", "Tasks")
"""Docks of FreeCAD's versions with the tree and the tasks."""


def _contents(task: Any, close: Callable[[], Any]) -> Any:
    """The form of a task that scrolls, and below it what writes, explains and closes."""
    inner = QtWidgets.QWidget()
    scroll = QtWidgets.QScrollArea()
    scroll.setWidgetResizable(True)
    scroll.setFrameShape(QtWidgets.QFrame.Shape.NoFrame)
    scroll.setWidget(task.form)
    layout = QtWidgets.QVBoxLayout(inner)
    layout.addWidget(scroll)
    box = QtWidgets.QDialogButtonBox
    buttons = box()
    if task.verb:
        write = buttons.addButton(translate("Millcorr", task.verb), box.ButtonRole.ApplyRole)
        write.setObjectName("Write")
        write.clicked.connect(lambda *_: task.write())
        task.applied_by(write)
    explain = buttons.addButton(translate("Millcorr", "Help"), box.ButtonRole.HelpRole)
    explain.setObjectName("Help")
    explain.clicked.connect(lambda *_: guide.show(task.page))
    shut = buttons.addButton(translate("Millcorr", "Close"), box.ButtonRole.RejectRole)
    shut.setObjectName("Close")
    for button in (explain, shut):
        button.setAutoDefault(False)
    buttons.rejected.connect(close)
    layout.addWidget(buttons)
    return inner


class Window(QtWidgets.QDialog):
    """A window.

    Parameters
    ----------
    task : FileTask
    closed : callable
        Called when it is closed.
    """

    def __init__(self, task: Any, closed: Callable[[], None]) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.task, self._closed = task, closed
        self.setObjectName(f"Millcorr{type(task).__name__}")
        self.setWindowTitle(task.title)
        self.setWindowIcon(task.form.windowIcon())
        self.setWindowFlag(QtCore.Qt.WindowType.WindowContextHelpButtonHint, False)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(_contents(task, self.reject))
        hint = task.form.sizeHint()
        fit(self, max(480, hint.width() + 60), hint.height() + 120)

    def done(self, result: int) -> None:
        """Stop everything, however the window is closed."""
        self.task.stop_all()
        self._closed()
        super().done(result)
        self.deleteLater()


class Dock(QtWidgets.QDockWidget):
    """A dock beside the 3-D view; parameters as of `Window`."""

    def __init__(self, task: Any, closed: Callable[[], None]) -> None:
        main = FreeCADGui.getMainWindow()
        super().__init__(task.title, main)
        self.task, self._closed, self._ended = task, closed, False
        self.setObjectName(f"Millcorr{type(task).__name__}")
        self.setWidget(_contents(task, self.close))
        beside = self._freecads(main)
        self._before = None if beside is None else beside.width()
        if beside is None:
            main.addDockWidget(QtCore.Qt.DockWidgetArea.LeftDockWidgetArea, self)
        else:
            main.addDockWidget(main.dockWidgetArea(beside), self)
            main.tabifyDockWidget(beside, self)
        main.resizeDocks([self], [WIDTH], QtCore.Qt.Orientation.Horizontal)

    @staticmethod
    def _freecads(main: Any) -> Any:
        """The dock with the tree; None where there is none to be seen."""
        for name in _FREECADS:
            for dock in main.findChildren(QtWidgets.QDockWidget, name):
                if dock.isVisible() and not dock.isFloating():
                    return dock
        return None

    def keyPressEvent(self, event: Any) -> None:
        """Escape closes, as it does a window."""
        if event.key() == QtCore.Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    def closeEvent(self, event: Any) -> None:
        """Stop everything, and give FreeCAD's docks their width back."""
        if not self._ended:
            self._ended = True
            self.task.stop_all()
            self._closed()
            # Not while it closes: FreeCAD looks after its docks in the same moment.
            QtCore.QTimer.singleShot(0, self._remove)
        super().closeEvent(event)

    def _remove(self) -> None:
        main = FreeCADGui.getMainWindow()
        beside = self._freecads(main)
        main.removeDockWidget(self)
        if beside is not None and self._before is not None:
            main.resizeDocks([beside], [self._before], QtCore.Qt.Orientation.Horizontal)
        self.deleteLater()
