# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our commands in CAM's own menu, where FreeCAD lets workbenches add to each other's (1.0 and later)."""

from __future__ import annotations

import FreeCADGui

from .commands import NAMES

_NEIGHBOUR = "CAM_Post"
"""The command of CAM's menu in whose menu ours are offered; in menus without it nothing is added."""


class CamMenu:
    """What FreeCAD asks whenever it builds the menus of a workbench."""

    def modifyMenuBar(self) -> list[dict[str, str]]:
        """Add our commands at the end of CAM's menu."""
        return [{"append": name, "menuItem": _NEIGHBOUR} for name in NAMES]


def add() -> bool:
    """Offer the commands in CAM; tells whether this FreeCAD can."""
    if not hasattr(FreeCADGui, "addWorkbenchManipulator"):
        return False
    FreeCADGui.addWorkbenchManipulator(CamMenu())
    return True
