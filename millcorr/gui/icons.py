# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the icons lie."""

from __future__ import annotations

from pathlib import Path

DIRECTORY = Path(__file__).resolve().parents[2] / "resources" / "icons"
"""Directory of the SVG icons, beside the package in the addon."""


def icon(name: str) -> str:
    """Path of an icon by its name without suffix."""
    return str(DIRECTORY / f"{name}.svg")
