# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation in a window beside FreeCAD's, page by page, as it lies in the addon."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCADGui

from millcorr.app.text import translate

from .qt import QtCore, QtGui, QtWidgets
from .screen import fit

DIRECTORY = Path(__file__).resolve().parents[2] / "docs"
"""Directory of the pages."""

PAGES = {
    "Millcorr_Measurement": "measurement-files.md",
    "Millcorr_Dressup": "freecad.md",
    "Millcorr_Picture": "freecad.md",
    "Millcorr_Profile": "freecad.md",
    "Millcorr_Report": "report.md",
    "Millcorr_Transfer": "transfer-function.md",
    "Millcorr_Split": "transfer-function.md",
    "Millcorr_Probe": "measuring-programs.md",
    "Millcorr_Plots": "report.md",
    "Millcorr_Simulate": "simulate.md",
    "Millcorr_Program": "nc-programs.md",
    "Millcorr_Batch": "batch.md",
    "Millcorr_History": "serial-production.md",
    "Millcorr_Help": "README.md",
}
"""The page that explains each command."""

_open: list[Any] = []


class Guide(QtWidgets.QDialog):
    """A page, with links to the others."""

    def __init__(self) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("MillcorrGuide")
        self.setWindowTitle(translate("Millcorr", "Millcorr help"))
        self.setWindowFlag(QtCore.Qt.WindowType.WindowContextHelpButtonHint, False)
        fit(self, 820, 700)
        layout = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        self.text = QtWidgets.QTextBrowser()
        self.text.setObjectName("Page")
        self.text.setOpenLinks(False)
        self.text.anchorClicked.connect(self._follow)
        self._pages: list[Path] = []
        for name, text, action in (
            ("Back", translate("Millcorr", "Back"), self.back),
            ("Contents", translate("Millcorr", "Contents"), lambda: self.go(DIRECTORY / "README.md")),
        ):
            button = QtWidgets.QPushButton(text)
            button.setObjectName(name)
            button.setAutoDefault(False)
            button.clicked.connect(lambda *_, act=action: act())
            row.addWidget(button)
        row.addStretch()
        layout.addLayout(row)
        layout.addWidget(self.text)

    def go(self, page: Path) -> None:
        """Show a page."""
        self._pages.append(page)
        self._show(page)

    def back(self) -> None:
        """Show the page before."""
        if len(self._pages) > 1:
            self._pages.pop()
            self._show(self._pages[-1])

    def _show(self, page: Path) -> None:
        lines = page.read_text(encoding="utf-8").splitlines()
        # What is for tools and not for readers.
        text = "\n".join(line for line in lines if not line.startswith("<!--"))
        self.text.setSearchPaths([str(page.parent)])
        self.text.setMarkdown(text)
        self.setWindowTitle(f"{lines[1].lstrip('# ') if len(lines) > 1 else page.name} \u2013 Millcorr")

    def _follow(self, link: Any) -> None:
        place = (self._pages[-1].parent / link.path()).resolve()
        if not link.scheme() and place.suffix == ".md" and place.is_file():
            self.go(place)
        else:
            QtGui.QDesktopServices.openUrl(link if link.scheme() else QtCore.QUrl.fromLocalFile(str(place)))

    def done(self, result: int) -> None:
        """Forget the window."""
        _open.clear()
        super().done(result)


def show(page: str = "README.md") -> Guide:
    """Show a page of the documentation."""
    if not _open:
        _open.append(Guide())
    guide: Guide = _open[0]
    guide.go(DIRECTORY / page)
    guide.show()
    guide.raise_()
    return guide


def whats_this(name: str, menu: str, tooltip: str) -> str:
    """What Qt's What's-this mode shows for a command, with a link to its page.

    Parameters
    ----------
    name : str
        Of the command.
    menu, tooltip : str
        To be translated.
    """
    page = PAGES.get(name, "README.md")
    more = translate("Millcorr", "More in the documentation")
    title, text = translate(name, menu).rstrip("\u2026"), translate(name, tooltip)
    return f"<p><b>{title}</b></p><p>{text}.</p><p><a href='{page}'>{more}</a></p>"


class _Links(QtCore.QObject):
    """Opens the page behind a link in a What's-this text: FreeCAD would look for it in its own documentation."""

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Qt asks for it."""
        if event.type() == QtCore.QEvent.Type.WhatsThisClicked and event.href() in PAGES.values():
            show(event.href())
            return True
        return False


_links: list[_Links] = []


def watch_links() -> None:
    """Open our pages from our buttons in What's-this mode; menus are made anew all the time."""
    if _links:
        return
    _links.append(_Links())
    window = FreeCADGui.getMainWindow()
    bars = [bar for bar in window.findChildren(QtWidgets.QToolBar) if bar.objectName().startswith("Millcorr")]
    for bar in bars:
        for widget in bar.findChildren(QtWidgets.QToolButton):
            widget.installEventFilter(_links[0])
