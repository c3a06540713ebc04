# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands of the shop floor: program files, measuring programs, transfer function, batches, series, plots, help."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import candidates, compat
from millcorr.app.text import QT_TRANSLATE_NOOP, translate

from . import selection
from .command import Command

_text = QT_TRANSLATE_NOOP


def _never() -> str:
    return ""


def _program() -> None:
    from . import file_task
    from .program_task import CorrectTask

    file_task.open_window(CorrectTask, translate("Millcorr", "Correct NC program file"))


def lacks_transfer() -> str:
    """What is missing for a correction by the transfer function."""
    lacking = selection.lacks_correction()
    if lacking or selection.correction().Measurement is not None:
        return lacking
    return _text("Millcorr", "a compensated toolpath with a measured part")


def _transfer() -> None:
    from . import panel
    from .transfer_panel import TransferPanel

    panel.show(TransferPanel(selection.correction()))


def to_split() -> Any:
    """What a first cut is made of: a compensated toolpath without a measurement, or else an operation."""
    chosen = selection.correction()
    if chosen is not None and chosen.Measurement is None:
        return chosen
    return selection.operation() if FreeCAD.ActiveDocument is not None else None


def _split() -> None:
    from . import file_task, panel
    from .program_task import SplitTask
    from .transfer_panel import SplitPanel

    base = to_split()
    if base is None:
        file_task.open_window(SplitTask, translate("Millcorr", "Split allowance"))
    else:
        panel.show(SplitPanel(base))


def to_measure() -> Any:
    """Operation or compensated toolpath whose contour can be measured; None where there is none."""
    if FreeCAD.ActiveDocument is None:
        return None
    selected = [obj for obj in FreeCADGui.Selection.getSelection() if compat.is_operation(obj)]
    chosen = selected[0] if selected else selection.correction() or selection.operation()
    if chosen is None or not chosen.Path.Commands:
        return None
    # It needs packages that may be missing when FreeCAD starts.
    from millcorr.app import base_geometry

    return chosen if base_geometry.gives_contour(compat.bottom_operation(chosen)) else None


def lacks_contour() -> str:
    """What is missing for a measuring program or a simulation."""
    if selection.lacks_document() or to_measure() is not None:
        return selection.lacks_document()
    return _text("Millcorr", "a Profile operation with a path, selected in the tree")


def _probe() -> None:
    from . import file_task
    from .measuring_panel import MeasuringTask

    operation = to_measure()
    file_task.open_window(lambda: MeasuringTask(operation), translate("Millcorr", "Measuring program"))


def _simulate() -> None:
    from . import file_task
    from .simulation_task import SimulateTask

    operation = to_measure()
    file_task.open_window(lambda: SimulateTask(operation), translate("Millcorr", "Simulation"))


def _batch() -> None:
    from . import file_task
    from .batch_task import BatchTask

    file_task.open_window(BatchTask, translate("Millcorr", "Batch"))


def _history() -> None:
    from . import file_task
    from .batch_task import HistoryTask

    file_task.open_window(HistoryTask, translate("Millcorr", "History of parts"))


def lacks_plots() -> str:
    """What is missing for plots."""
    there = FreeCAD.ActiveDocument is not None and any(map(candidates.is_correction, FreeCAD.ActiveDocument.Objects))
    return "" if there else _text("Millcorr", "a compensated toolpath: make one first")


def _plots() -> None:
    from . import plots

    plots.toggle(selection.correction())


def _help() -> None:
    from . import guide

    guide.show()


COMMANDS = (
    Command(
        "Millcorr_Transfer",
        _text("Millcorr_Transfer", "Transfer function\u2026"),
        _text("Millcorr_Transfer", "Correct by how far the machine yields, from the depth that was cut"),
        lacks_transfer,
        _transfer,
        "M, T",
    ),
    Command(
        "Millcorr_Split",
        _text("Millcorr_Split", "Split allowance\u2026"),
        _text("Millcorr_Split", "Cut an allowance in two: measure after the first cut, correct the second"),
        _never,
        _split,
        "M, A",
    ),
    Command(
        "Millcorr_Probe",
        _text("Millcorr_Probe", "Measuring program\u2026"),
        _text("Millcorr_Probe", "Write a program that measures the selected operation's contour on the machine"),
        lacks_contour,
        _probe,
        "M, M",
        beside=True,
    ),
    Command(
        "Millcorr_Plots",
        _text("Millcorr_Plots", "Plots"),
        _text("Millcorr_Plots", "Deviations along the contour and their distribution, linked to the 3-D view"),
        lacks_plots,
        _plots,
        "M, L",
        beside=True,
    ),
    Command(
        "Millcorr_Simulate",
        _text("Millcorr_Simulate", "Simulate\u2026"),
        _text("Millcorr_Simulate", "Run the cutter along the selected operation: force, deflection, predicted contour"),
        lacks_contour,
        _simulate,
        "M, S",
        beside=True,
    ),
    Command(
        "Millcorr_Program",
        _text("Millcorr_Program", "Correct NC program file\u2026"),
        _text("Millcorr_Program", "Correct an NC program from a measured part, without any document"),
        _never,
        _program,
        "M, N",
        beside=True,
    ),
    Command(
        "Millcorr_Batch",
        _text("Millcorr_Batch", "Batch\u2026"),
        _text("Millcorr_Batch", "Run many corrections from one file, in the background"),
        _never,
        _batch,
        "M, B",
        beside=True,
    ),
    Command(
        "Millcorr_History",
        _text("Millcorr_History", "History of parts\u2026"),
        _text("Millcorr_History", "Show what the journal of a series holds: parts, corrections, trends"),
        _never,
        _history,
        "M, H",
        beside=True,
    ),
    Command(
        "Millcorr_Help",
        _text("Millcorr_Help", "Millcorr help"),
        _text("Millcorr_Help", "The documentation, page by page"),
        _never,
        _help,
        beside=True,
    ),
)
"""The commands, in the order of menu and toolbar."""
