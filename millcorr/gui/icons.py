# SPDX-License-Identifier: LGPL-2.1-or-later
"""The icons: where they lie, and as Qt has them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCADGui

DIRECTORY = Path(__file__).resolve().parents[2] / "resources" / "icons"
"""Directory of the SVG icons, beside the package in the addon."""


def icon(name: str) -> str:
    """Path of an icon by its name without suffix."""
    return str(DIRECTORY / f"{name}.svg")


def qt_icon(name: str) -> Any:
    """An icon for a window, read by FreeCAD: a Qt without its SVG plugin has none, and FreeCAD shows "?" then."""
    return FreeCADGui.getIcon(icon(name))
