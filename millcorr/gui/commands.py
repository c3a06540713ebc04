# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands: data about each, and one class that runs them.

A command asks what it must know, then runs Python lines through FreeCAD's macro recorder, so that recording a
session gives a macro that works.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import compat, dressup
from millcorr.errors import MillcorrError

from .icons import icon
from .qt import QtWidgets

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class Command:
    """A command of the workbench.

    Parameters
    ----------
    name : str
        FreeCAD's name of it, and of its icon.
    menu, tooltip : str
        Texts, to be translated.
    usable : callable
        Whether it can run on what is selected now.
    lines : callable
        Asks what is needed and gives the Python lines to run; none if the user gave up.
    """

    name: str
    menu: str
    tooltip: str
    usable: Callable[[], bool]
    lines: Callable[[], list[str]]

    def GetResources(self) -> dict[str, str]:
        """What FreeCAD shows."""
        return {
            "Pixmap": icon(self.name),
            "MenuText": translate(self.name, self.menu),
            "ToolTip": translate(self.name, self.tooltip),
        }

    def IsActive(self) -> bool:
        """Whether the command can run."""
        return FreeCAD.ActiveDocument is not None and self.usable()

    def Activated(self) -> None:
        """Run the command in one transaction; on failure nothing of it remains."""
        lines = self.lines()
        if not lines:
            return
        document = FreeCAD.ActiveDocument
        document.openTransaction(translate(self.name, self.menu))
        try:
            for line in lines:
                FreeCADGui.doCommand(line)
        except MillcorrError as error:
            document.abortTransaction()
            _tell(self.menu, str(error))
        except BaseException:
            document.abortTransaction()
            raise
        else:
            document.commitTransaction()


def _tell(title: str, text: str) -> None:
    FreeCAD.Console.PrintError(f"{text}\n")
    QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(), title, text)


def selected_operation() -> Any:
    """The selected operation that stands in a job and can be dressed up, or None."""
    for obj in FreeCADGui.Selection.getSelection():
        if compat.is_operation(obj):
            job = compat.parent_job(obj)
            if job is not None and obj.Name in [o.Name for o in compat.operations(job)]:
                return obj
    return None


def selected_dressup() -> Any:
    """The selected dressup of ours, or None."""
    for obj in FreeCADGui.Selection.getSelection():
        if dressup.is_correction(obj):
            return obj
    return None


def _measurements() -> list[Any]:
    return [o for o in FreeCAD.ActiveDocument.Objects if hasattr(o, "BallRadius") and hasattr(o, "Digest")]


def _selected_measurement() -> Any:
    known = _measurements()
    chosen = [o for o in known if o in FreeCADGui.Selection.getSelection()]
    return (chosen or known or [None])[-1]


def _object(obj: Any) -> str:
    return "None" if obj is None else f"App.ActiveDocument.getObject({obj.Name!r})"


def _import_lines() -> list[str]:
    window = FreeCADGui.getMainWindow()
    path, _ = QtWidgets.QFileDialog.getOpenFileName(
        window,
        translate("Millcorr_Measurement", "Measured points"),
        "",
        translate("Millcorr_Measurement", "Measured points (*.csv *.txt *.xyz *.asc *.pts);;All files (*)"),
    )
    if not path:
        return []
    kinds = {
        translate("Millcorr_Measurement", "Points on the surface"): "contact",
        translate("Millcorr_Measurement", "Centres of the probe's ball"): "centre",
    }
    kind, agreed = QtWidgets.QInputDialog.getItem(
        window,
        translate("Millcorr_Measurement", "Measured points"),
        translate("Millcorr_Measurement", "The coordinates are"),
        list(kinds),
        0,
        False,
    )
    if not agreed:
        return []
    radius = 0.0
    if kinds[kind] == "centre":
        radius, agreed = QtWidgets.QInputDialog.getDouble(
            window,
            translate("Millcorr_Measurement", "Measured points"),
            translate("Millcorr_Measurement", "Radius of the probe's ball in mm"),
            1.0,
            0.0001,
            100.0,
            4,
        )
        if not agreed:
            return []
    ball = f", ball_radius={radius!r}" if radius else ""
    return [
        "from millcorr.app import measurement_object",
        f"measurement_object.create(App.ActiveDocument, {path!r}, points={kinds[kind]!r}{ball})",
        "App.ActiveDocument.recompute()",
    ]


def _dressup_lines() -> list[str]:
    return [
        "from millcorr.app import dressup",
        f"dressup.create({_object(selected_operation())}, {_object(_selected_measurement())})",
        "App.ActiveDocument.recompute()",
    ]


def _profile_lines() -> list[str]:
    return [
        "from millcorr.app import profile_object",
        f"profile_object.create({_object(selected_dressup())})",
        "App.ActiveDocument.recompute()",
    ]


def _report_lines() -> list[str]:
    directory = QtWidgets.QFileDialog.getExistingDirectory(
        FreeCADGui.getMainWindow(), translate("Millcorr_Report", "Directory for the report")
    )
    if not directory:
        return []
    return [
        "from millcorr.app import batch",
        f"batch.export_report({_object(selected_dressup())}, {directory!r})",
    ]


COMMANDS = (
    Command(
        "Millcorr_Measurement",
        QT_TRANSLATE_NOOP("Millcorr_Measurement", "Import measurement"),
        QT_TRANSLATE_NOOP("Millcorr_Measurement", "Store the measured points of a part in the document"),
        lambda: True,
        _import_lines,
    ),
    Command(
        "Millcorr_Dressup",
        QT_TRANSLATE_NOOP("Millcorr_Dressup", "Compensated toolpath"),
        QT_TRANSLATE_NOOP(
            "Millcorr_Dressup",
            "Correct the path of the selected operation from the selected, or else the last, measurement",
        ),
        lambda: selected_operation() is not None,
        _dressup_lines,
    ),
    Command(
        "Millcorr_Profile",
        QT_TRANSLATE_NOOP("Millcorr_Profile", "Compensated profile"),
        QT_TRANSLATE_NOOP(
            "Millcorr_Profile",
            "Make the compensated profile of the selected dressup, as a NURBS for any operation",
        ),
        lambda: selected_dressup() is not None,
        _profile_lines,
    ),
    Command(
        "Millcorr_Report",
        QT_TRANSLATE_NOOP("Millcorr_Report", "Export report"),
        QT_TRANSLATE_NOOP("Millcorr_Report", "Write the report of the selected dressup to a directory"),
        lambda: selected_dressup() is not None,
        _report_lines,
    ),
)
"""All commands, in the order of menu and toolbar."""


def register() -> list[str]:
    """Make the commands known to FreeCAD; gives their names."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.name, command)
    return [command.name for command in COMMANDS]
