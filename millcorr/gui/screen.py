# SPDX-License-Identifier: LGPL-2.1-or-later
"""Windows that fit on the screen, whatever its size."""

from __future__ import annotations

from typing import Any

from .qt import QtWidgets

FRAME = 60
"""Room for the frame of a window, pixels."""


def fit(window: Any, width: int, height: int) -> None:
    """Give a window a size in pixels, or as much of it as the screen has."""
    screen = QtWidgets.QApplication.primaryScreen().availableGeometry()
    window.resize(min(width, screen.width() - FRAME), min(height, screen.height() - FRAME))
