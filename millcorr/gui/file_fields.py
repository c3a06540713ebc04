# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form fields for files: to read, to write, several, or a directory."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from millcorr.app.text import QT_TRANSLATE_NOOP, translate

from . import fields, preferences
from .fields import Field
from .qt import QtWidgets

KEPT = QT_TRANSLATE_NOOP("Millcorr", "Settings (*.toml);;All files (*)")
"""Files that a document keeps beside the measured one."""


class FileField(Field):
    """A file, with a button that opens FreeCAD's file dialog; the row's default is the filter of names."""

    def _make(self, row: Any) -> Any:
        """A line of text and a button."""
        self._kinds = row.default or (KEPT if row.kind == "FileIncluded" else "All files (*)")
        self._changed: Callable[[], None] = lambda: None
        box = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(box)
        layout.setContentsMargins(0, 0, 0, 0)
        self.line = QtWidgets.QLineEdit()
        self.line.setObjectName(f"{row.name}Path")
        self.line.setMinimumWidth(120)
        self.line.setAccessibleName(fields.label_of(row.name))
        button = QtWidgets.QToolButton()
        button.setText("\u2026")
        button.setObjectName(f"{row.name}Browse")
        button.setAccessibleName(translate("Millcorr", "Choose"))
        button.clicked.connect(lambda *_: self._browse())
        layout.addWidget(self.line)
        layout.addWidget(button)
        box.setFocusProxy(self.line)
        return box

    def _connect(self, changed: Callable[[], None]) -> None:
        """Call back when the line was edited or a file chosen."""
        self._changed = changed
        self.line.editingFinished.connect(lambda: changed())

    def _get(self) -> Any:
        """Path as text; empty where there is none."""
        return str(self.line.text()).strip()

    def _put(self, value: Any) -> None:
        """Show a path."""
        self.line.setText(str(value or ""))

    def _start(self) -> str:
        """Where the file dialog begins: at the chosen file, or where the last one was."""
        return self.line.text().split(";")[0].strip() or str(preferences.get("LastDirectory"))

    def _browse(self) -> None:
        chosen = self.ask(self.widget, fields.label_of(self.name), self._start())
        if chosen:
            preferences.put("LastDirectory", Path(chosen[0]).parent)
            self._put("; ".join(chosen))
            self._changed()

    def ask(self, parent: Any, title: str, start: str) -> list[str]:
        """What the user chooses in a file dialog; empty where nothing."""
        chosen, _ = QtWidgets.QFileDialog.getOpenFileName(parent, title, start, translate("Millcorr", self._kinds))
        return [chosen] if chosen else []


class FilesField(FileField):
    """One file or several, separated by semicolons."""

    def _get(self) -> Any:
        """Paths as a list."""
        return [word.strip() for word in self.line.text().split(";") if word.strip()]

    def _put(self, value: Any) -> None:
        """Show paths."""
        self.line.setText(value if isinstance(value, str) else "; ".join(value))

    def ask(self, parent: Any, title: str, start: str) -> list[str]:
        """Several files."""
        chosen, _ = QtWidgets.QFileDialog.getOpenFileNames(parent, title, start, translate("Millcorr", self._kinds))
        return list(chosen)


class SaveField(FileField):
    """A file to write."""

    def ask(self, parent: Any, title: str, start: str) -> list[str]:
        """A file that may or may not be there."""
        chosen, _ = QtWidgets.QFileDialog.getSaveFileName(parent, title, start, translate("Millcorr", self._kinds))
        return [chosen] if chosen else []


class DirectoryField(FileField):
    """A directory."""

    def ask(self, parent: Any, title: str, start: str) -> list[str]:
        """A directory."""
        chosen = QtWidgets.QFileDialog.getExistingDirectory(parent, title, start)
        return [chosen] if chosen else []
