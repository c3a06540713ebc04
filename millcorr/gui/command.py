# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: they are data, and say in their tooltip what they lack."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import FreeCADGui

from millcorr.app.text import QT_TRANSLATE_NOOP, translate

from . import guide, packages
from .icons import icon

_text = QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class Command:
    """A command of the workbench.

    Parameters
    ----------
    name : str
        FreeCAD's name of it, and of its icon.
    menu, tooltip : str
        Texts, to be translated.
    lacks : callable
        What is missing for it to make sense now, to be translated; empty where nothing is.
    act : callable
        Does it: opens a panel or a dialog, or runs recorded lines with `panel.run`.
    shortcut : str
        Keys, in the way FreeCAD writes them.
    beside : bool
        Whether it can be used while a task is open in the task view: it leaves document and task alone.
    """

    name: str
    menu: str
    tooltip: str
    lacks: Callable[[], str]
    act: Callable[[], Any]
    shortcut: str = ""
    beside: bool = False

    def GetResources(self) -> dict[str, str]:
        """What FreeCAD shows."""
        return {
            "Pixmap": icon(self.name),
            "MenuText": translate(self.name, self.menu),
            "ToolTip": translate(self.name, self.tooltip),
            # FreeCAD appends this to its tooltip: what is to be read is set with ours.
            "WhatsThis": self.name,
            "Accel": self.shortcut,
            # FreeCAD asks even while a task is open, so that the tooltip can say so.
            "CmdType": "ForEdit",
        }

    def IsActive(self) -> bool:
        """Whether the command can run; its tooltip tells what is missing otherwise."""
        busy = not self.beside and bool(FreeCADGui.Control.activeDialog())
        lacking = packages.lacking()
        if not lacking:
            lacking = _text("Millcorr", "the open task ended: OK or Cancel") if busy else self.lacks()
        self._tell(lacking)
        return not lacking

    def _tell(self, lacking: str) -> None:
        text = translate(self.name, self.tooltip)
        if lacking:
            text += "<br><b>" + translate("Millcorr", "Needs:") + "</b> " + translate("Millcorr", lacking)
        keys = f" ({self.shortcut})" if self.shortcut else ""
        tooltip = f"<p><b>{translate(self.name, self.menu)}</b>{keys}<br>{text}</p>"
        for action in FreeCADGui.Command.get(self.name).getAction():
            # FreeCAD makes its own when the language changes.
            if action.toolTip() != tooltip:
                action.setToolTip(tooltip)
                action.setWhatsThis(guide.whats_this(self.name, self.menu, self.tooltip))
                action.setStatusTip(translate("Millcorr", lacking) if lacking else translate(self.name, self.tooltip))

    def Activated(self) -> None:
        """Do it."""
        self.act()
