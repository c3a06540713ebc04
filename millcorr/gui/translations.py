# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in other languages: FreeCAD is told where they lie, before any text is asked for."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui

DIRECTORY = Path(__file__).resolve().parents[2] / "resources" / "translations"
"""Directory of the .ts files, to be edited, and of the .qm files that are made of them."""


def add() -> None:
    """Make FreeCAD look for our texts in its own language."""
    FreeCADGui.addLanguagePath(str(DIRECTORY))
    FreeCADGui.updateLocale()
