# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected, and what a command misses in it."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import candidates, compat
from millcorr.app.rounds import parts_of
from millcorr.app.text import QT_TRANSLATE_NOOP

_text = QT_TRANSLATE_NOOP


def operation() -> Any:
    """The operation to correct: the selected one, or the only one of the document; None where there is none."""
    if FreeCAD.ActiveDocument is None:
        return None
    selected = FreeCADGui.Selection.getSelection()
    for obj in selected:
        if candidates.can_be_corrected(obj):
            return obj
    if any(compat.is_operation(obj) for obj in selected):
        return None
    there = [obj for job in compat.jobs(FreeCAD.ActiveDocument) for obj in compat.operations(job)]
    return there[0] if len(there) == 1 else None


def correction() -> Any:
    """The selected dressup of ours, or the only one of the document; None where there is none."""
    if FreeCAD.ActiveDocument is None:
        return None
    for obj in FreeCADGui.Selection.getSelection():
        if candidates.is_correction(obj):
            return obj
    there = [obj for obj in FreeCAD.ActiveDocument.Objects if candidates.is_correction(obj)]
    return there[0] if len(there) == 1 else None


def measurement() -> Any:
    """The selected measurement, or the document's last one; None where there is none."""
    known = candidates.measurements(FreeCAD.ActiveDocument)
    chosen = [obj for obj in known if obj in FreeCADGui.Selection.getSelection()]
    return (chosen or known or [None])[-1]


def new_measurement() -> Any:
    """The selected measurement, or the last one that no correction has yet; None where there is none."""
    known = candidates.measurements(FreeCAD.ActiveDocument)
    used = [part for obj in FreeCAD.ActiveDocument.Objects if candidates.is_correction(obj) for part in parts_of(obj)]
    chosen = [obj for obj in known if obj in FreeCADGui.Selection.getSelection()]
    return (chosen or [obj for obj in known if obj not in used] or [None])[-1]


def lacks_document() -> str:
    """What is missing where a document is needed."""
    return "" if FreeCAD.ActiveDocument else _text("Millcorr", "an open document")


def lacks_operation() -> str:
    """What is missing where an operation is to be corrected."""
    if lacks_document() or operation() is not None:
        return lacks_document()
    jobs = compat.jobs(FreeCAD.ActiveDocument)
    if not any(compat.operations(job) for job in jobs):
        return _text("Millcorr", "a job with an operation, such as a Profile")
    if any(compat.is_operation(obj) for obj in FreeCADGui.Selection.getSelection()):
        return _text("Millcorr", "an operation that stands in a job, without a dressup over it: select the dressup")
    return _text("Millcorr", "an operation selected in the tree")


def lacks_correction() -> str:
    """What is missing where a compensated toolpath is needed."""
    if lacks_document() or correction() is not None:
        return lacks_document()
    if any(candidates.is_correction(obj) for obj in FreeCAD.ActiveDocument.Objects):
        return _text("Millcorr", "a compensated toolpath selected in the tree")
    return _text("Millcorr", "a compensated toolpath: make one first")
