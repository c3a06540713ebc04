# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was done in the background goes into the macro that is being recorded, as the lines that do it anew.

FreeCAD's recorder runs every line that it records. Work that is done already must not be done twice, so the function
that a line calls gives what it gave before, just while the line is recorded.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import Any

import FreeCADGui


def record(lines: Sequence[str], module: ModuleType, function: str, outcome: Any) -> None:
    """Record lines without doing their work again.

    Parameters
    ----------
    lines : sequence of str
    module : module
        Where the function is that does the work.
    function : str
        Its name.
    outcome : object
        What it has given.
    """
    real = getattr(module, function)
    setattr(module, function, lambda *given, **options: outcome)
    try:
        for line in lines:
            FreeCADGui.doCommand(line)
    finally:
        setattr(module, function, real)
