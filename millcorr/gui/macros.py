# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros of the addon as commands: each file in resources/macros is a button, and can be copied and changed.

A macro says in ``__Name__`` and ``__Comment__`` what it is, as FreeCAD's macros do.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import FreeCADGui

from millcorr.app.text import translate
from millcorr.errors import MillcorrError

from . import packages, told
from .icons import icon

DIRECTORY = Path(__file__).resolve().parents[2] / "resources" / "macros"
"""Directory of the macros."""


@dataclass(frozen=True, slots=True)
class Macro:
    """A macro as a command.

    Parameters
    ----------
    file : Path
    """

    file: Path

    @property
    def name(self) -> str:
        """FreeCAD's name of the command."""
        return f"Millcorr_Macro{self.file.stem}"

    def said(self, name: str) -> str:
        """What the macro says of itself; empty where it says nothing."""
        for node in ast.parse(self.file.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == name:
                return str(ast.literal_eval(node.value))
        return ""

    def GetResources(self) -> dict[str, str]:
        """What FreeCAD shows."""
        return {
            "Pixmap": icon(self.said("__Icon__") or "Millcorr"),
            "MenuText": translate("Millcorr_Macro", self.said("__Name__")),
            "ToolTip": translate("Millcorr_Macro", self.said("__Comment__")),
        }

    def IsActive(self) -> bool:
        """Where there is what millcorr needs; the macro itself says what else it misses."""
        return not packages.lacking()

    def Activated(self) -> None:
        """Run the macro: it asks, and has what it does recorded by `run`, which asks nothing."""
        code = compile(self.file.read_text(encoding="utf-8"), self.file.name, "exec")
        exec(code, {"__name__": self.file.stem})


def run(title: str, lines: Sequence[str], *written: str) -> bool:
    """Run lines of Python through the macro recorder and tell what came of it; gives whether they ran.

    Parameters
    ----------
    title : str
        What is done.
    lines : sequence of str
    *written : str
        Files and directories that there are then.
    """
    try:
        for line in lines:
            FreeCADGui.doCommand(line)
    except (MillcorrError, OSError) as error:
        from millcorr.app.wording import worded

        told.failed(title, worded(error))
        return False
    told.done(title, written)
    return True


MACROS = tuple(Macro(file) for file in sorted(DIRECTORY.glob("*.FCMacro")))
NAMES = tuple(macro.name for macro in MACROS)


def register() -> None:
    """Make the macros known to FreeCAD."""
    for macro in MACROS:
        FreeCADGui.addCommand(macro.name, macro)
