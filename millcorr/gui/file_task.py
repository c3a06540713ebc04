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

from millcorr.app.text import label_of, translate
from millcorr.app.wording import worded
from millcorr.errors import InputError

from . import recorder
from .closed_documents import when_closed
from .panel import Panel
from .qt import QtCore, QtGui, QtWidgets
from .remedies import accepted_by, remedies_in, wrong_field
from .task_window import Dock, Window
from .worker import Worker

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
    """Whether it is docked, because the 3-D view shows something of it."""

    def __init__(self, title: str, icon_name: str, page: str) -> None:
        super().__init__(None, title, icon_name)
        self.page = page
        self._writer = Worker(self.form, self._written, self._could_not, self._progressed, self._not_written)
        self.written = ""
        # What was refused when it was looked at cannot be written; what could not be written can be tried again.
        self._unfit = False

    # What a task is made of --------------------------------------------------------------------------

    def job(self) -> Job:
        """What writes; raises MillcorrError where something is missing."""
        raise NotImplementedError

    def missing(self) -> list[str]:
        """Names of fields that must be filled in first."""
        raise NotImplementedError

    def complete(self) -> bool:
        """Whether everything is said that looking needs."""
        return not self.missing()

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
        self.judge()

    def lacking(self) -> str:
        """Why nothing can be written; empty where it can."""
        missing = [label_of(name) for name in self.missing()]
        if missing:
            return translate("Millcorr", "Needs: {}").format(", ".join(missing))
        return super().lacking() if self._unfit else ""

    def ready(self, ready: bool) -> None:
        """Whether something else may be written, or is being written."""
        if ready:
            self.judge()
        elif self.applying is not None:
            self.applying.setEnabled(False)

    def write(self) -> None:
        """Write, in the background."""
        try:
            job = self.job()
        except (OSError, ValueError) as error:
            self._could_not(error)
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

    def _stopped(self) -> None:
        """Stop what goes on; what is being put in its place already is written, and said to be."""
        if self.writing:
            self._writer.stop()
        else:
            super()._stopped()

    def _not_written(self) -> None:
        self._show_progress(False)
        self.ready(True)
        self.say(translate("Millcorr", "Stopped; nothing was written"))

    def show_written(self, text: str) -> None:
        """Show what was written."""
        self.say(spaced(worded(text)), "good")

    def _failed(self, error: BaseException) -> None:
        self._unfit = True
        super()._failed(_told(error))

    def _could_not(self, error: BaseException) -> None:
        """It was not written."""
        self._unfit = False
        super()._failed(_told(error))

    def show_failure(self, text: str) -> None:
        """Beside the field that is at fault, or at the top, with buttons for what resolves it."""
        remedies = [remedy for remedy in remedies_in(text) if remedy.field in self.fields]
        name, first = accepted_by(text), wrong_field(text)
        # A message that begins with an option is about the value that it has.
        wrong = first or (remedies[0].field if remedies and remedies[0].value is None else "")
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
        """Stop whatever goes on; what has been written by then is still recorded."""
        self.close()
        self._writer.finish()


def _close_of(name: str) -> None:
    """Close the windows that are about a document."""
    for window in list(_open.values()):
        if window.task.home == name:
            window.close()


def open_window(task: Callable[[], FileTask], title: str) -> Window | Dock:
    """Open the window of a task, or bring it forward if it is open; gives it."""
    when_closed(_close_of)
    if title not in _open:
        made = task()
        _open[title] = (Dock if made.aside else Window)(made, lambda: _open.pop(title, None))
    window: Window | Dock = _open[title]
    window.show()
    window.raise_()
    return window


def _told(error: BaseException) -> BaseException:
    """What the file system refuses is told like any other refusal."""
    return InputError(str(error)) if isinstance(error, OSError) else error


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
