# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands, one entry each. What computes is imported when a command runs, not when FreeCAD starts."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from millcorr.app import candidates
from millcorr.app.text import QT_TRANSLATE_NOOP, translate

from . import selection, shop_commands
from .command import Command
from .qt import QtWidgets

_text = QT_TRANSLATE_NOOP


def _import() -> None:
    from . import import_dialog

    import_dialog.show(FreeCAD.ActiveDocument, selection.operation())


def _correct() -> None:
    from . import dressup_panel, panel

    chosen = selection.operation()
    if candidates.is_correction(chosen):
        made = dressup_panel.edit(chosen, selection.new_measurement())
    else:
        made = dressup_panel.new(chosen, selection.measurement())
    if made is not None and not panel.show(made):
        made.reject()


def _profile() -> None:
    from . import panel

    dressup = selection.correction()
    lines = [
        "from millcorr.app import profile_object",
        f"profile_object.create(App.ActiveDocument.getObject({dressup.Name!r}))",
        "App.ActiveDocument.recompute()",
    ]
    panel.run(FreeCAD.ActiveDocument, translate("Millcorr_Profile", "Compensated profile"), lines)


def _report() -> None:
    from . import macros

    dressup = selection.correction()
    title = translate("Millcorr_Report", "Directory for the report")
    directory = QtWidgets.QFileDialog.getExistingDirectory(FreeCADGui.getMainWindow(), title)
    if directory:
        lines = [
            "from millcorr.app import batch",
            f"batch.export_report(App.ActiveDocument.getObject({dressup.Name!r}), {directory!r})",
        ]
        macros.run(translate("Millcorr_Report", "Export report"), lines, directory)


def _picture() -> None:
    view = selection.correction().ViewObject
    view.ShowPicture = not view.ShowPicture


COMMANDS = (
    Command(
        "Millcorr_Measurement",
        _text("Millcorr_Measurement", "Import measurement\u2026"),
        _text("Millcorr_Measurement", "Read the measured points of a part and keep the file in the document"),
        selection.lacks_document,
        _import,
        "M, I",
    ),
    Command(
        "Millcorr_Dressup",
        _text("Millcorr_Dressup", "Compensated toolpath\u2026"),
        _text("Millcorr_Dressup", "Correct the path of the selected operation from a measured part"),
        selection.lacks_operation,
        _correct,
        "M, C",
    ),
    Command(
        "Millcorr_Picture",
        _text("Millcorr_Picture", "Show deviations"),
        _text("Millcorr_Picture", "Show or hide deviations, profiles and paths of the selected compensated toolpath"),
        selection.lacks_correction,
        _picture,
        "M, D",
    ),
    Command(
        "Millcorr_Profile",
        _text("Millcorr_Profile", "Compensated profile"),
        _text("Millcorr_Profile", "Make the profile to cut, as a NURBS for any operation"),
        selection.lacks_correction,
        _profile,
        "M, P",
    ),
    Command(
        "Millcorr_Report",
        _text("Millcorr_Report", "Export report\u2026"),
        _text("Millcorr_Report", "Write the report of the selected compensated toolpath to a directory"),
        selection.lacks_correction,
        _report,
        "M, R",
    ),
    *shop_commands.COMMANDS,
)
"""All commands, in the order of menu and toolbar."""

NAMES = tuple(command.name for command in COMMANDS)


def register() -> None:
    """Make the commands known to FreeCAD."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.name, command)
