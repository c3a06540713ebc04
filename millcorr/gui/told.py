# SPDX-License-Identifier: LGPL-2.1-or-later
"""What came of something without a window of its own: where it was written, with a button that opens it, or why not."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app.text import translate

from .qt import QtCore, QtGui, QtWidgets

_box: list[Any] = []


def done(title: str, written: Sequence[str] = ()) -> None:
    """It is done; a button for each place that was written, where there are any."""
    if not written:
        FreeCAD.Console.PrintMessage(f"{title}: {translate('Millcorr', 'done')}\n")
        return
    box = _make(title, QtWidgets.QMessageBox.Icon.Information, "\n".join(written))
    for place in written:
        text = translate("Millcorr", "Open {}").format(Path(place).name)
        button = box.addButton(text, QtWidgets.QMessageBox.ButtonRole.ActionRole)
        button.setObjectName(f"Open {Path(place).name}")
        button.clicked.connect(lambda *_, place=place: show(place))
    box.show()


def failed(title: str, reason: str) -> None:
    """It could not be done."""
    FreeCAD.Console.PrintError(f"{title}: {reason}\n")
    _make(title, QtWidgets.QMessageBox.Icon.Critical, reason).show()


def show(place: str) -> None:
    """Open a file, or the page of a report, with what the system opens it with."""
    page = Path(place) / "report.html"
    found = page if page.is_file() else Path(place)
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(found.resolve())))


def _make(title: str, icon: Any, text: str) -> Any:
    """A message that waits for nobody; it takes the place of the one before."""
    for old in _box:
        old.close()
    box = QtWidgets.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName("MillcorrTold")
    box.setModal(False)
    box.setIcon(icon)
    box.setWindowTitle(title)
    box.setText(text)
    box.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    box.addButton(QtWidgets.QMessageBox.StandardButton.Close)
    _box[:] = [box]
    return box
