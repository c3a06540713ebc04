# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels of what yields: the transfer function of a measured cut, and the split of an allowance in two cuts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui

from millcorr.app import candidates, correction, draft, dressup, rounds
from millcorr.app.properties import QT_TRANSLATE_NOOP, Property
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.errors import RefusedError, UsageError
from millcorr.messages import phrase

from .figure_table import FigureTable
from .figures import COLUMNS, figures_of
from .panel import Panel, clear
from .qt import QtCore, QtWidgets
from .remedies import remedies_in
from .transfer_figures import transfer_figures

_text = QT_TRANSLATE_NOOP


class DraftPanel(Panel):
    """A panel that changes some properties of a dressup: it computes on a draft, and OK changes the dressup.

    Parameters
    ----------
    document : FreeCAD document
    title, icon_name : str
    values : draft.Draft
    """

    def __init__(self, document: Any, title: str, icon_name: str, values: draft.Draft) -> None:
        super().__init__(document, title, icon_name)
        self.draft = values

    def explain(self, text: str) -> None:
        """Say at the top what this is about."""
        label = QtWidgets.QLabel(text)
        label.setObjectName("Explanation")
        label.setWordWrap(True)
        self.layout.addWidget(label)

    def work(self) -> Callable[[], Any]:
        """Correct the draft."""
        finish = correction.prepared(self.draft)
        return lambda: finish().result

    def show_failure(self, text: str) -> None:
        """Beside the field that is at fault, or at the top."""
        self.show_outcome(None)
        for remedy in remedies_in(text):
            if remedy.field in self.fields:
                self.say("")
                self.fields[remedy.field].complain(worded(text))
                return
        self.say(worded(text), "wrong")


class TransferPanel(DraftPanel):
    """Correct by the transfer function: depth that was cut, depth that will be, and what follows from them.

    Parameters
    ----------
    obj : document object
        A dressup with a measurement.
    """

    def __init__(self, obj: Any) -> None:
        values = draft.Draft(obj.Label, draft.values_of(obj, dressup.PROPERTIES))
        super().__init__(obj.Document, translate("Millcorr", "Transfer function"), "Millcorr_Transfer", values)
        self.obj = obj
        left = values.value("LeaveStock")
        if left:
            # The measured part is the one that the first cut made.
            values.change("Allowance", [left])
            values.change("LeaveStock", 0.0)
        values.change("Method", "transfer")
        self.explain(
            translate(
                "Millcorr",
                "The machine yields in proportion to what it cuts. From the depth H of the measured part and its "
                "error \u03b4 follows the transfer function <b>MS = \u03b4 / (H \u2212 \u03b4)</b>; the next path "
                "commands <b>H \u00b7 (1 + MS)</b>, and removes H. That also holds at another depth, where a "
                "mirrored error does not.",
            )
        )
        rows = [row for row in dressup.PROPERTIES if row.group == "Transfer function"]
        self.group(translate("Millcorr", "Depths"), rows, self._settings_changed)
        for name, field in self.fields.items():
            field.show_value(values.value(name))
        self.system = FigureTable(translate("Millcorr", "Machining system"), transfer_figures(None))
        self.table = FigureTable(translate("Millcorr", "Deviations, {}").format(unit().name), figures_of(None), COLUMNS)
        self.layout.addWidget(self.system)
        self.layout.addWidget(self.table)
        self.notes = QtWidgets.QVBoxLayout()
        self.layout.addLayout(self.notes)
        self.layout.addStretch()
        self.start()

    def _settings_changed(self) -> None:
        for name, field in self.fields.items():
            try:
                self.draft.change(name, field.value)
            except ValueError:
                field.complain(translate("Millcorr", "not a number"))
                return
        self.changed()

    def show_outcome(self, outcome: Any) -> None:
        """MS, and what the next part will show."""
        summary = None if outcome is None else outcome.summary()
        self.system.fill(transfer_figures(summary))
        self.table.fill(figures_of(summary))
        clear(self.notes)
        for kind, key in (("doubt", "warnings"), ("note", "advice")):
            for text in () if summary is None else summary[key]:
                label = QtWidgets.QLabel(worded(text))
                label.setWordWrap(True)
                label.setProperty("millcorr", kind)
                self.notes.addWidget(label)

    def lines(self) -> list[str]:
        """Change the dressup."""
        return draft.lines_to_change(self.draft, self.obj, draft.values_of(self.obj, dressup.PROPERTIES))

    def applied(self) -> None:
        """Nothing that FreeCAD could not recompute remains."""
        if "Invalid" in self.obj.State:
            raise RefusedError(f"{self.obj.Label}: {self.obj.getStatusString()}")


_SPLIT = (
    Property("Length", "Stock", "", _text("App::Property", "Whole allowance over the finished contour"), 0.0),
    Property("Float", "Share", "", _text("App::Property", "Share of the allowance that the first cut takes"), 0.5),
)


class SplitPanel(DraftPanel):
    """A first cut that leaves a part of the allowance.

    Parameters
    ----------
    base : document object
        The operation that finishes the part, or a dressup of ours over it.
    """

    def __init__(self, base: Any) -> None:
        self.obj = base if candidates.is_correction(base) else None
        usual = draft.defaults(dressup.PROPERTIES) | {"Base": base}
        values = usual if self.obj is None else draft.values_of(self.obj, dressup.PROPERTIES)
        # What was measured before counts for nothing in a first cut, and stays in the list.
        values |= {"SwitchedOff": [] if self.obj is None else rounds.parts_of(self.obj), "Method": "mirror"}
        super().__init__(
            base.Document,
            translate("Millcorr", "Split allowance"),
            "Millcorr_Split",
            draft.Draft(f"{base.Label} first cut", values),
        )
        self.explain(
            translate(
                "Millcorr",
                "The first cut leaves a part of the allowance on the finished contour. Measure the part then, import "
                "the measurement, and correct with the transfer function: the second cut comes out right.",
            )
        )
        self.group(base.Label, _SPLIT, self._settings_changed)
        self.fields["Share"].show_value(0.5)
        self.left = QtWidgets.QLabel()
        self.left.setObjectName("Left")
        self.left.setWordWrap(True)
        self.layout.addWidget(self.left)
        files = QtWidgets.QPushButton(translate("Millcorr", "A program file instead\u2026"))
        files.setObjectName("ProgramFile")
        files.setAutoDefault(False)
        files.clicked.connect(lambda *_: self._files())
        self.layout.addWidget(files)
        self.layout.addStretch()
        self.start()

    def _settings_changed(self) -> None:
        # To 0.1 um, as lengths are entered: the next cut must know the very same number.
        stock, share = self.fields["Stock"].value, self.fields["Share"].value
        self.draft.change("LeaveStock", round(stock * (1.0 - share), 4))
        self.changed()

    def _files(self) -> None:
        from . import file_task
        from .program_task import SplitTask

        QtCore.QTimer.singleShot(0, lambda: (self.reject(), FreeCADGui.Control.closeDialog()))
        file_task.open_window(SplitTask, translate("Millcorr", "Split allowance"))

    def work(self) -> Callable[[], Any]:
        """Lay the path of the first cut."""
        if not 0 < self.fields["Share"].value < 1:
            raise UsageError(phrase("Share: the first cut takes more than 0 and less than 1 of the allowance"))
        if not self.fields["Stock"].value > 0:
            raise UsageError(phrase("Stock: say how much stands on the finished contour"))
        return super().work()

    def show_outcome(self, outcome: Any) -> None:
        """What is taken, what is left, and the proof."""
        if outcome is None:
            self.left.setText("")
            return
        shown = unit()
        left, stock = self.draft.value("LeaveStock"), self.fields["Stock"].value
        self.left.setText(
            translate(
                "Millcorr",
                "The first cut takes {0} {2} and leaves {1} {2}. Its path is within {3} {4} of the exact parallel.",
            ).format(
                f"{round((stock - left) / shown.mm, shown.digits):g}",
                f"{round(left / shown.mm, shown.digits):g}",
                shown.name,
                f"{outcome.verification.path_error_max / shown.fine_mm:.{shown.fine_digits + 1}f}",
                shown.fine,
            )
        )

    def show_failure(self, text: str) -> None:
        """Beside the field that is at fault, or at the top."""
        name, colon, said = text.partition(": ")
        if colon and name in self.fields:
            self.show_outcome(None)
            self.say("")
            self.fields[name].complain(said)
            return
        super().show_failure(text)

    def lines(self) -> list[str]:
        """Make the dressup, or change it."""
        if self.obj is None:
            return draft.lines_to_create(self.draft, dressup.PROPERTIES)
        return draft.lines_to_change(self.draft, self.obj, draft.values_of(self.obj, dressup.PROPERTIES))
