# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all task panels share: fields from a table of properties, work in the background, one transaction on OK.

A panel changes nothing in the document before OK. What OK does is a list of Python lines, run through FreeCAD's
macro recorder; Cancel has nothing to take back.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app.text import translate
from millcorr.app.wording import worded
from millcorr.errors import MillcorrError
from millcorr.messages import message_of

from . import told
from .closed_documents import when_closed
from .field_kinds import field_for
from .fields import Field
from .fold import Fold
from .icons import qt_icon
from .keys import keep
from .qt import QtCore, QtWidgets
from .theme import FADED, STYLE, mark
from .worker import Worker

PAUSE = 250
"""Work begins so many milliseconds after the last change."""


class Panel:
    """A task panel.

    Parameters
    ----------
    document : FreeCAD document
    title : str
        Translated; also the name of the transaction.
    icon_name : str
    """

    def __init__(self, document: Any, title: str, icon_name: str) -> None:
        self.document, self.title = document, title
        self._home = "" if document is None else document.Name
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("MillcorrPanel")
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(qt_icon(icon_name))
        self.form.setStyleSheet(STYLE)
        keep(self.form, lambda: self.busy)
        self.layout = QtWidgets.QVBoxLayout(self.form)
        self.layout.setContentsMargins(2, 2, 2, 2)
        self.fields: dict[str, Field] = {}
        self.wrong = ""
        self.closed = False
        self._pause = QtCore.QTimer(self.form)
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE)
        self._pause.timeout.connect(self._begin)
        self._accepting = False
        self.applying: Any = None
        self.worker = Worker(self.form, self._done, self._failed, self._progressed)
        self._make_state()

    # What a panel is made of -------------------------------------------------------------------------

    def _make_state(self) -> None:
        """The line at the top: what is going on, how far, and a button to stop it."""
        self.message = QtWidgets.QLabel()
        self.message.setObjectName("Message")
        self.message.setWordWrap(True)
        self.message.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.buttons = QtWidgets.QVBoxLayout()
        self.bar = QtWidgets.QProgressBar()
        self.bar.setObjectName("Progress")
        self.bar.setRange(0, 100)
        self.bar.setTextVisible(True)
        self.stop = QtWidgets.QPushButton(translate("Millcorr", "Stop"))
        self.stop.setObjectName("Stop")
        self.stop.setAutoDefault(False)
        self.stop.clicked.connect(self._stopped)
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.bar)
        row.addWidget(self.stop)
        self.layout.addWidget(self.message)
        self.layout.addLayout(self.buttons)
        self.layout.addLayout(row)
        self._show_progress(False)
        self.message.hide()

    def group(self, title: str, rows: Sequence[Any], changed: Callable[[], None], folded: bool = False) -> Any:
        """A titled box with a field for each property; a folded one shows them when it is opened."""
        inner = QtWidgets.QWidget()
        form = QtWidgets.QFormLayout(inner)
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(3)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.RowWrapPolicy.WrapLongRows)
        form.setFieldGrowthPolicy(QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for row in rows:
            field = self.fields[row.name] = field_for(row, changed)
            field.add_to(form)
        if folded:
            box = Fold(title, inner)
        else:
            box = QtWidgets.QGroupBox(title)
            outer = QtWidgets.QVBoxLayout(box)
            # Without room above, some styles write the title over the first row.
            outer.setContentsMargins(6, 8, 6, 4)
            outer.addWidget(inner)
        self.layout.addWidget(box)
        return box

    # What happens ------------------------------------------------------------------------------------

    def work(self) -> Callable[[], Any]:
        """Work that belongs to the settings as they are, to be done in a thread; raises MillcorrError."""
        raise NotImplementedError

    def show_outcome(self, outcome: Any) -> None:
        """Show what the work gave."""
        raise NotImplementedError

    def show_failure(self, text: str) -> None:
        """Show why there is no outcome; the text is the core's."""
        raise NotImplementedError

    def lines(self) -> list[str]:
        """Python lines that OK runs."""
        raise NotImplementedError

    def applied(self) -> None:
        """Called after the lines, within the transaction."""

    def changed(self) -> None:
        """A setting was changed: work begins in a moment."""
        self.wrong = ""
        self.judge()
        self.worker.cancel()
        for field in self.fields.values():
            field.complain("")
        self.show_progress(translate("Millcorr", "Computing"), 0.0)
        self._pause.start()

    def start(self) -> None:
        """Begin work at once."""
        self._pause.stop()
        self._begin()

    @property
    def busy(self) -> bool:
        """Whether an outcome is still to come."""
        return self.worker.busy or self._pause.isActive()

    def _begin(self) -> None:
        try:
            function = self.work()
        except (MillcorrError, ValueError) as error:
            self._failed(error)
            return
        self.show_progress(translate("Millcorr", "Computing"), 0.0)
        self.worker.start(function)

    def _progressed(self, stage: str, share: float) -> None:
        self.show_progress(translate("Millcorr", stage or "Computing"), share)

    def show_progress(self, text: str, share: float) -> None:
        """Say what is going on."""
        self._show_progress(True)
        self.bar.setValue(round(100 * share))
        self.bar.setFormat(f"{text} \u2026 %p %")

    def _show_progress(self, shown: bool) -> None:
        self.bar.setVisible(shown)
        self.stop.setVisible(shown)

    def _done(self, outcome: Any) -> None:
        self._show_progress(False)
        self.say("")
        self.show_outcome(outcome)
        self.judge()
        if self._accepting:
            self.accept()

    def _failed(self, error: BaseException) -> None:
        self._show_progress(False)
        self._accepting = False
        if not isinstance(error, MillcorrError | ValueError):
            self.say(translate("Millcorr", "Internal error, see the report view"), "wrong")
            self.wrong = str(error) or type(error).__name__
            import traceback

            FreeCAD.Console.PrintError("".join(traceback.format_exception(error)))
            self.judge()
            return
        self.wrong = message_of(error)
        self.show_failure(self.wrong)
        if not self.message.text():
            at_fault = [field.label.text() for field in self.fields.values() if field.note.text()]
            self.say(translate("Millcorr", "Not possible yet: see {}").format(", ".join(at_fault)), "wrong")
        self.judge()

    def lacking(self) -> str:
        """Why what is shown cannot be applied; empty where it can."""
        return self.message.text() if self.wrong else ""

    def applied_by(self, button: Any) -> None:
        """Take a button for the one that applies."""
        button.setStyleSheet(FADED)
        self.applying = button
        self.judge()

    def judge(self) -> None:
        """Switch the button that applies on or off, its reason as a tooltip."""
        if self.applying is not None and not self.closed:
            lacking = self.lacking()
            self.applying.setEnabled(not lacking)
            self.applying.setToolTip(lacking)

    def _stopped(self) -> None:
        self._pause.stop()
        self.worker.cancel()
        self._accepting = False
        self._show_progress(False)
        self.wrong = translate("Millcorr", "Stopped: change a setting to compute again")
        self.say(self.wrong)
        self.judge()

    def say(self, text: str, kind: str = "note") -> None:
        """Say something at the top: a note, a "doubt", or what is "wrong"."""
        clear(self.buttons)
        mark(self.message, kind)
        self.message.setText(text)
        self.message.setVisible(bool(text))

    def offer(self, text: str, action: Callable[[], None], name: str) -> None:
        """A button under the message."""
        button = QtWidgets.QPushButton(text)
        button.setObjectName(name)
        button.setAutoDefault(False)
        button.clicked.connect(lambda *_: action())
        self.buttons.addWidget(button)

    # What FreeCAD asks -------------------------------------------------------------------------------

    def modifyStandardButtons(self, box: Any) -> None:
        """FreeCAD's OK and Cancel: OK is there while there is something sound to apply."""
        self.applied_by(box.button(QtWidgets.QDialogButtonBox.StandardButton.Ok))

    def accept(self) -> bool:
        """OK: run the lines in one transaction; the panel stays where there is nothing sound to apply."""
        if self.busy:
            # What is applied is what was shown: OK waits for it, and the window does not.
            self._accepting = True
            return False
        if self.wrong:
            return False
        waited, self._accepting = self._accepting, False
        if not run(self.document, self.title, self.lines(), self.applied):
            return False
        self.close()
        if waited:
            FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        """Cancel: nothing was done."""
        self.close()
        return True

    def close(self) -> None:
        """Stop everything; called once, whichever way the panel ends."""
        self.closed = True
        self._pause.stop()
        self.worker.cancel()
        if _shown and _shown[0] is self:
            _shown.clear()

    def forsake(self, name: str) -> None:
        """A document was closed: without its own the panel ends, and touches nothing of it."""
        if name == self._home:
            self.document = None
            self.close()
            FreeCADGui.Control.closeDialog()


_shown: list[Panel] = []
"""The panel in the task view."""


def _forsake(name: str) -> None:
    """Close the panel that is about a document."""
    for panel in list(_shown):
        panel.forsake(name)


def narrow(label: Any) -> Any:
    """A label that gives way where the task view is narrow, and shows all of its text in its tooltip."""
    label.setMinimumWidth(40)
    label.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored, QtWidgets.QSizePolicy.Policy.Preferred)
    return label


def clear(layout: Any) -> None:
    """Remove a layout's widgets."""
    while layout.count():
        widget = layout.takeAt(0).widget()
        if widget is not None:
            widget.setParent(None)
            widget.deleteLater()


def run(document: Any, title: str, lines: Sequence[str], after: Callable[[], None] = lambda: None) -> bool:
    """Run Python lines through the macro recorder in one transaction; on failure nothing of them remains.

    Returns
    -------
    bool
        Whether they ran; the reason why not is in the report view.
    """
    if not lines:
        after()
        return True
    FreeCAD.setActiveDocument(document.Name)
    document.openTransaction(title)
    try:
        for line in lines:
            FreeCADGui.doCommand(line)
        after()
    except MillcorrError as error:
        document.abortTransaction()
        told.failed(title, worded(error))
        return False
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    return True


def show(panel: Any) -> bool:
    """Show a panel in the task view, unless one is open."""
    if FreeCADGui.Control.activeDialog():
        FreeCAD.Console.PrintWarning(translate("Millcorr", "Close the open task first") + "\n")
        return False
    when_closed(_forsake)
    FreeCADGui.Control.showDialog(panel)
    _shown[:] = [panel]
    return True
