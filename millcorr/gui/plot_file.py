# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measured file beside the plots: the lines about the one that a place of the picture comes from."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from millcorr.app.text import translate
from millcorr.errors import FormatError
from millcorr.readers.decoding import decode

from .qt import QtGui, QtWidgets

ABOUT = 100
"""So many lines before and behind the one looked for are shown."""


class FilePage(QtWidgets.QPlainTextEdit):
    """Some lines of a file, each behind its number; one of them stands out."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("File")
        self.setReadOnly(True)
        self.setLineWrapMode(QtWidgets.QPlainTextEdit.LineWrapMode.NoWrap)
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        self.empty()

    def empty(self) -> None:
        """Show no file."""
        self.setExtraSelections([])
        self.setPlainText(
            translate("Millcorr", "Click at a place of the picture or the plot to see its line of the file.")
        )

    def show_line(self, file: Path, line: int) -> str:
        """Show the lines about one, counted from 1, and give that one; empty where the file is no text."""
        try:
            lines = _lines(str(file), file.stat().st_mtime_ns)
        except (FormatError, OSError):
            self.setExtraSelections([])
            self.setPlainText(translate("Millcorr", "The measured file is no plain text."))
            return ""
        first = max(line - ABOUT, 1)
        last = min(line + ABOUT, len(lines))
        width = len(str(last))
        self.setPlainText("\n".join(f"{number:>{width}}  {lines[number - 1]}" for number in range(first, last + 1)))
        cursor = QtGui.QTextCursor(self.document().findBlockByNumber(line - first))
        self.setTextCursor(cursor)
        self.centerCursor()
        chosen = QtWidgets.QTextEdit.ExtraSelection()
        chosen.cursor = cursor
        chosen.format.setBackground(self.palette().highlight())
        chosen.format.setForeground(self.palette().highlightedText())
        chosen.format.setProperty(QtGui.QTextFormat.Property.FullWidthSelection, True)
        self.setExtraSelections([chosen])
        return lines[line - 1] if line <= len(lines) else ""


@lru_cache(maxsize=1)
def _lines(file: str, changed: int) -> list[str]:
    """Lines of a file in a state that its time stands for."""
    path = Path(file)
    return decode(path.read_bytes(), path.name).split("\n")
