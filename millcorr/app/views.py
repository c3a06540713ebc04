# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the window side leaves word how objects are shown; without a window nobody does.

The objects know only this table, so that nothing here depends on the window.
"""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from . import compat

MAKERS: dict[str, Callable[[Any], Any]] = {}
"""Maker of the view provider by kind of object: "measurement", "dressup", "profile"."""

_STATE = "GuiDocument.xml"


def attach(obj: Any, kind: str) -> bool:
    """Give an object its view if FreeCAD has a window and the object has no view yet.

    Documents written without a window hold no views; opened with one, their objects get them here.

    Parameters
    ----------
    obj : document object
    kind : str
        Key of `MAKERS`.

    Returns
    -------
    bool
        Whether it got one now.
    """
    if not compat.has_window() or kind not in MAKERS:
        return False
    vobj = obj.ViewObject
    if vobj is None or getattr(vobj, "Proxy", None):
        return False
    MAKERS[kind](vobj)
    return True


def carry_over(source: Path, written: Path) -> None:
    """Give a document written without a window the views (colours, visibility) of the one it came from.

    Parameters
    ----------
    source : Path
        The original .FCStd.
    written : Path
        The new one; left alone if it has views.
    """
    if not (zipfile.is_zipfile(source) and zipfile.is_zipfile(written)):
        return
    with zipfile.ZipFile(source) as old:
        names = old.namelist()
        with zipfile.ZipFile(written, "a", zipfile.ZIP_DEFLATED) as new:
            there = set(new.namelist())
            if _STATE in there or _STATE not in names:
                return
            # FreeCAD reads in the order of the archive: the views and their files come after everything else.
            for name in names[names.index(_STATE) :]:
                if name not in there:
                    with old.open(name) as data, new.open(name, "w") as copy:
                        shutil.copyfileobj(data, copy)
