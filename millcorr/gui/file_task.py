# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks on files, in a window of their own: they look at once, and write when they are told to.

What is written is written in the background and recorded as the line of Python that does the same without a window.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.errors import InputError

from . import guide, recorder
from .panel import Panel
from .qt import QtCore, QtGui, QtWidgets
from .remedies import accepted_by, first_field, remedies_in, worded
from .text import translate
from .worker import Worker

ASIDE = 440
"""Width of a window beside the 3-D view, pixels."""

_open: dict[str, Any] = {}
"""Windows that are open, by title: Python must hold on to them."""


@dataclass(frozen=True, slots=True)
class Job:
    """What is written, as lines of a macro and as a function.

    Parameters
    ----------
    lines : list of str
        What does it without a window.
    module, name : module, str
        The function that those lines call.
    function : callable
        Does it now, in a thread; gives what was done, in a few lines.
    """

    lines: list[str]
    module: ModuleType
    name: str
    function: Callable[[], str]


class FileTask(Panel):
    """A panel without a document.

    Parameters
    ----------
    title : str
        Translated.
    icon_name : str
    page : str
        Page of the documentation that explains it.
    """

    verb = ""
    """Text of the button that writes, to be translated; empty where there is nothing to write."""

    home = ""
    """Name of the document that it is about: its window closes with it."""

    aside = False
    """Whether its window stands at the left, because the 3-D view shows something of it."""

    def __init__(self, title: str, icon_name: str, page: str) -> None:
        super().__init__(None, title, icon_name)
        self.page = page
        self._writer = Worker(self.form, self._written, self._failed, self._progressed)
        self.written = ""
        self.ready: Callable[[bool], None] = lambda ready: None

    # What a task is made of --------------------------------------------------------------------------

    def job(self) -> Job:
        """What writes; raises MillcorrError where something is missing."""
        raise NotImplementedError

    def complete(self) -> bool:
        """Whether everything is said that looking needs."""
        raise NotImplementedError

    @property
    def values(self) -> dict[str, Any]:
        """What the form says, by field; raises ValueError for what is no number."""
        return {name: field.value for name, field in self.fields.items()}

    # What happens ------------------------------------------------------------------------------------

    @property
    def writing(self) -> bool:
        """Whether something is being written."""
        return self._writer.busy

    def changed(self) -> None:
        """Look again, once enough is said."""
        self.written = ""
        if self.complete():
            super().changed()
            return
        self.wrong = ""
        self.worker.cancel()
        self._pause.stop()
        self._show_progress(False)
        self.say("")

    def write(self) -> None:
        """Write, in the background."""
        try:
            job = self.job()
        except (OSError, ValueError) as error:
            self._failed(error)
            return
        self._pause.stop()
        self.worker.cancel()
        self.ready(False)
        self.show_progress(translate("Millcorr", "Writing"), 0.0)

        self._writer.start(lambda: (job, job.function()))

    def _written(self, outcome: tuple[Job, str]) -> None:
        job, self.written = outcome
        recorder.record(job.lines, job.module, job.name, self.written)
        self._show_progress(False)
        self.ready(True)
        self.show_written(self.written)

    def show_written(self, text: str) -> None:
        """Show what was written."""
        self.say(worded(spaced(text)), "good")

    def _failed(self, error: BaseException) -> None:
        self.ready(True)
        # What the file system refuses is told like any other refusal.
        super()._failed(InputError(str(error)) if isinstance(error, OSError) else error)

    def show_failure(self, text: str) -> None:
        """Beside the field that is at fault, or at the top, with buttons for what resolves it."""
        remedies = [remedy for remedy in remedies_in(text) if remedy.field in self.fields]
        name, first = accepted_by(text), first_field(text)
        # A message that begins with an option is about the value that it has.
        wrong = first if text.startswith("--") else remedies[0].field if remedies and remedies[0].value is None else ""
        if wrong in self.fields and not name:
            self.say("")
            self.fields[wrong].complain(worded(text))
            return
        self.say(worded(text), "wrong")
        for remedy in remedies:
            if remedy.value is not None:
                self.offer(
                    remedy.in_words(), lambda r=remedy: self.set_field(r.field, r.value), f"Remedy {remedy.field}"
                )
        if name and "Accept" in self.fields:
            accepted = [*self.fields["Accept"].value, name]
            text = translate("Millcorr", "It is right as it is")
            self.offer(text, lambda: self.set_field("Accept", accepted), f"Accept {name}")

    def set_field(self, name: str, value: Any) -> None:
        """Give a field a value as if the user had."""
        self.fields[name].show_value(value)
        self.changed()

    def stop_all(self) -> None:
        """Stop whatever goes on."""
        self.close()
        self._writer.cancel()


class Window(QtWidgets.QDialog):
    """The window of a task."""

    def __init__(self, task: FileTask) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.task = task
        self.setObjectName(f"Millcorr{type(task).__name__}")
        self.setWindowTitle(task.title)
        self.setWindowIcon(task.form.windowIcon())
        scroll = QtWidgets.QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QtWidgets.QFrame.Shape.NoFrame)
        scroll.setWidget(task.form)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addWidget(scroll)
        box = QtWidgets.QDialogButtonBox
        buttons = box()
        self.write = None
        if task.verb:
            self.write = buttons.addButton(translate("Millcorr", task.verb), box.ButtonRole.ApplyRole)
            self.write.setObjectName("Write")
            self.write.clicked.connect(lambda *_: task.write())
            task.ready = self.write.setEnabled
        explain = buttons.addButton(translate("Millcorr", "Help"), box.ButtonRole.HelpRole)
        explain.setObjectName("Help")
        explain.clicked.connect(lambda *_: guide.show(task.page))
        close = buttons.addButton(translate("Millcorr", "Close"), box.ButtonRole.RejectRole)
        close.setObjectName("Close")
        for button in (explain, close):
            button.setAutoDefault(False)
        buttons.rejected.connect(self.reject)
        layout.addWidget(buttons)
        hint = task.form.sizeHint()
        # Beside the 3-D view there is little room.
        wide = ASIDE if task.aside else max(480, hint.width() + 60)
        self.resize(wide, min(820, hint.height() + 120))

    def done(self, result: int) -> None:
        """Stop everything, however the window is closed."""
        self.task.stop_all()
        _open.pop(self.task.title, None)
        super().done(result)
        self.deleteLater()


class _Documents:
    """What FreeCAD tells of documents."""

    def slotDeletedDocument(self, document: Any) -> None:
        """Close the windows that are about a document when it is closed."""
        for window in list(_open.values()):
            if window.task.home == document.Name:
                window.close()


_documents: list[_Documents] = []


def open_window(task: Callable[[], FileTask], title: str) -> Window:
    """Open the window of a task, or bring it forward if it is open; gives it."""
    if not _documents:
        _documents.append(_Documents())
        FreeCAD.addDocumentObserver(_documents[0])
    if title not in _open:
        _open[title] = Window(task())
    window: Window = _open[title]
    if window.task.aside:
        main = FreeCADGui.getMainWindow()
        window.move(main.mapToGlobal(QtCore.QPoint(4, 60)))
    window.show()
    window.raise_()
    return window


def monospaced(name: str, lines: int) -> Any:
    """A read-only text of fixed pitch."""
    text = QtWidgets.QPlainTextEdit()
    text.setObjectName(name)
    text.setReadOnly(True)
    text.setLineWrapMode(QtWidgets.QPlainTextEdit.LineWrapMode.NoWrap)
    font = QtGui.QFont("monospace")
    font.setStyleHint(QtGui.QFont.StyleHint.TypeWriter)
    text.setFont(font)
    text.setMinimumHeight(lines * QtGui.QFontMetrics(font).lineSpacing() + 12)
    text.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding, QtWidgets.QSizePolicy.Policy.Expanding)
    text.setTabChangesFocus(True)
    text.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAsNeeded)
    return text


def spaced(text: str) -> str:
    """Lines that the console aligns, for a font that does not: ``name     rest`` is "name: rest"."""
    return re.sub(r"(?m)^(\S+(?: \S+)?) {2,}", r"\1: ", text)


def beside(path: str, ending: str) -> str:
    """A name beside a file, for what is made of it; empty where there is no file."""
    if not path:
        return ""
    file = Path(path)
    return str(file.with_name(file.stem + ending + file.suffix))


def absolute(paths: Sequence[str]) -> list[str]:
    """Paths as they are from anywhere: a recorded macro runs in another directory."""
    return [str(Path(path).expanduser().resolve()) for path in paths]
