# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros of the addon as commands: each file in resources/macros is a button, and can be copied and changed.

A macro says in ``__Name__`` and ``__Comment__`` what it is, as FreeCAD's macros do.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path

import FreeCADGui

from .icons import icon
from .text import translate

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
        """Always: the macro itself says what it misses."""
        return True

    def Activated(self) -> None:
        """Run the macro."""
        text = f"open({str(self.file)!r}, encoding='utf-8').read()"
        FreeCADGui.doCommand(f"exec(compile({text}, {self.file.name!r}, 'exec'))")


MACROS = tuple(Macro(file) for file in sorted(DIRECTORY.glob("*.FCMacro")))
NAMES = tuple(macro.name for macro in MACROS)


def register() -> None:
    """Make the macros known to FreeCAD."""
    for macro in MACROS:
        FreeCADGui.addCommand(macro.name, macro)
