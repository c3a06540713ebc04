# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies under the mouse in the 3-D view: told while it rests there, and kept on a click."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pivy import coin

from .picture import Pick, Picture
from .qt import QtCore, QtGui, QtWidgets

REST = 60
"""The mouse rests when it has not moved for so many milliseconds."""


class Hover:
    """Watches the mouse in one view.

    Parameters
    ----------
    view : 3-D view
    picture : Picture
    picked : callable
        Gets what is clicked.
    """

    def __init__(self, view: Any, picture: Picture, picked: Callable[[Pick], None]) -> None:
        self._view, self._picture, self._picked = view, picture, picked
        self._place = (0, 0)
        self._told = False
        self._rest = QtCore.QTimer()
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST)
        self._rest.timeout.connect(self._tell)
        self._callbacks = [
            (kind, view.addEventCallbackPivy(kind, function))
            for kind, function in (
                (coin.SoLocation2Event.getClassTypeId(), self._moved),
                (coin.SoMouseButtonEvent.getClassTypeId(), self._pressed),
            )
        ]

    def _moved(self, callback: Any) -> None:
        self._place = callback.getEvent().getPosition().getValue()
        self._rest.start()

    def _pressed(self, callback: Any) -> None:
        event = callback.getEvent()
        if event.getButton() == coin.SoMouseButtonEvent.BUTTON1 and event.getState() == coin.SoButtonEvent.DOWN:
            pick = self._picture.pick_at(self._view, *event.getPosition().getValue())
            if pick is not None:
                self._picked(pick)

    def _tell(self) -> None:
        if not QtWidgets.QApplication.mouseButtons() == QtCore.Qt.MouseButton.NoButton:
            return
        pick = self._picture.pick_at(self._view, *self._place)
        if pick is not None:
            QtWidgets.QToolTip.showText(QtGui.QCursor.pos(), pick.text)
        elif self._told:
            # What another picture in the same view tells stays.
            QtWidgets.QToolTip.hideText()
        self._told = pick is not None

    def end(self) -> None:
        """Watch no more."""
        self._rest.stop()
        for kind, function in self._callbacks:
            try:
                self._view.removeEventCallbackPivy(kind, function)
            except RuntimeError:
                # The view was closed.
                pass
        self._callbacks = []
