# SPDX-License-Identifier: LGPL-2.1-or-later
"""The windows of many parts: a batch and how its jobs do, and the history of a series."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite
from pathlib import Path
from typing import Any

from millcorr.app import programs
from millcorr.app.properties import QT_TRANSLATE_NOOP, Property
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.cli import jobs
from millcorr.errors import MillcorrError
from millcorr.production import history, journal

from . import file_task, recorder
from .batch_run import BatchRun
from .options import call
from .qt import QtCore, QtWidgets

_text = QT_TRANSLATE_NOOP

POLL = 150
"""A batch is looked at every so many milliseconds."""

_BATCH = (
    Property(
        "OpenFile",
        "Batch",
        "",
        _text("App::Property", "Jobs to run"),
        _text("Millcorr", "Batches (*.toml);;All files (*)"),
    ),
    Property("Bool", "Again", "", _text("App::Property", "Also run what an earlier run has done"), False),
)
_HISTORY = (
    Property(
        "OpenFile",
        "Journal",
        "",
        _text("App::Property", "Journal of a series"),
        _text("Millcorr", "Journals (*.journal);;All files (*)"),
    ),
    Property("Directory", "Report", "", _text("App::Property", "Directory for the report and the table of all parts")),
)

_COLUMNS = (_text("Millcorr", "Job"), _text("Millcorr", "State"), _text("Millcorr", "Time"), _text("Millcorr", "Told"))

_PARTS = (
    _text("Millcorr", "Series"),
    _text("Millcorr", "Part"),
    _text("Millcorr", "Measured"),
    _text("Millcorr", "Mean, {}"),
    _text("Millcorr", "Std. deviation, {}"),
    _text("Millcorr", "Height, {}"),
    _text("Millcorr", "Correction, {}"),
    _text("Millcorr", "Decision"),
)


def _table(name: str, headings: tuple[str, ...]) -> Any:
    table = QtWidgets.QTableWidget(0, len(headings))
    table.setObjectName(name)
    table.setHorizontalHeaderLabels([translate("Millcorr", heading).format(unit().fine) for heading in headings])
    table.verticalHeader().hide()
    table.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
    table.horizontalHeader().setStretchLastSection(True)
    table.setTabKeyNavigation(False)
    table.setMinimumSize(620, 180)
    return table


def _put(table: Any, row: int, texts: list[str]) -> None:
    for column, text in enumerate(texts):
        item = QtWidgets.QTableWidgetItem(text)
        item.setToolTip(text)
        table.setItem(row, column, item)


class BatchTask(file_task.FileTask):
    """A batch: its jobs in a table, each with its state."""

    verb = _text("Millcorr", "Run")

    def __init__(self) -> None:
        super().__init__(translate("Millcorr", "Batch"), "Millcorr_Batch", "batch.md")
        self.group(translate("Millcorr", "Batch"), _BATCH, self.changed)
        self.table = _table("Jobs", _COLUMNS)
        self.layout.addWidget(self.table, 1)
        self.run: BatchRun | None = None
        self._ended: list[jobs.Outcome] = []
        self._timer = QtCore.QTimer(self.form)
        self._timer.setInterval(POLL)
        self._timer.timeout.connect(self._look)

    def missing(self) -> list[str]:
        """The batch file."""
        return [] if self.fields["Batch"].value else ["Batch"]

    def work(self) -> Callable[[], Any]:
        """Check the file."""
        path = self.fields["Batch"].value
        return lambda: jobs.load(path)

    def show_outcome(self, outcome: Any) -> None:
        """The jobs, before they run."""
        self.table.setRowCount(len(outcome))
        for row, job in enumerate(outcome):
            _put(self.table, row, [job.name, translate("Millcorr", "waits"), "", " ".join(job.argv)])
        self.table.resizeColumnsToContents()

    def write(self) -> None:
        """Run the batch."""
        if self.run is not None:
            return
        path = file_task.absolute([self.fields["Batch"].value])[0]
        try:
            self.run = BatchRun(path, self.fields["Again"].value)
        except (MillcorrError, OSError) as error:
            self._failed(error)
            return
        again = self.fields["Again"].value or None
        recorder.record(["from millcorr.cli import jobs", call("jobs.run", path, again=again)], jobs, "run", None)
        self._ended = []
        self._rows = {name: row for row, name in enumerate(self.run.names)}
        self.table.setRowCount(len(self._rows))
        for name, row in self._rows.items():
            _put(self.table, row, [name, translate("Millcorr", "waits"), "", ""])
        self.say("")
        self.ready(False)
        self._timer.start()
        self._look()

    def _look(self) -> None:
        run = self.run
        if run is None:
            return
        for event in run.news():
            self._ended.append(event)
            told = worded(event.text) if event.status else ""
            _put(self.table, self._rows[event.name], [event.name, _state(event), f"{event.seconds:.1f} s", told])
        told = translate("Millcorr", "{} of {} jobs").format(len(self._ended), len(self._rows))
        self.show_progress(told, len(self._ended) / max(1, len(self._rows)))
        if run.running:
            return
        self._timer.stop()
        self._show_progress(False)
        self.table.resizeColumnsToContents()
        self.run = None
        self.ready(True)
        if run.cancelled:
            self.say(translate("Millcorr", "Stopped; run it again to go on"), "doubt")
        elif len(self._ended) == len(self._rows):
            self._sum_up()
        else:
            self.say(worded(run.said), "wrong")

    def _sum_up(self) -> None:
        """How many jobs are done, and which failed."""
        failed = [event.name for event in self._ended if event.status]
        done = len(self._ended) - len(failed)
        told = [translate("Millcorr", "Jobs done: {} of {}").format(done, len(self._ended))]
        if before := sum(event.before for event in self._ended):
            told.append(translate("Millcorr", "Done in an earlier run: {}").format(before))
        if failed:
            told.append(translate("Millcorr", "Failed: {}").format(", ".join(failed)))
        self.say("\n".join(told), "wrong" if failed else "good")

    def _stopped(self) -> None:
        if self.run is None:
            super()._stopped()
        else:
            self.run.cancel()

    def stop_all(self) -> None:
        """Stop the jobs, too."""
        if self.run is not None:
            self.run.cancel()
        self._timer.stop()
        super().stop_all()


def _state(event: jobs.Outcome) -> str:
    if event.before:
        return translate("Millcorr", "done before")
    if event.status == 0:
        return translate("Millcorr", "done")
    return translate("Millcorr", "failed ({})").format(event.status)


class HistoryTask(file_task.FileTask):
    """The parts of a series, from its journal."""

    verb = _text("Millcorr", "Write report")

    def __init__(self) -> None:
        super().__init__(translate("Millcorr", "History of parts"), "Millcorr_History", "serial-production.md")
        self.group(translate("Millcorr", "Journal"), _HISTORY, self.changed)
        self.table = _table("Parts", _PARTS)
        self.layout.addWidget(self.table, 1)
        self.text = file_task.monospaced("Trends", 3)
        self.layout.addWidget(self.text)
        self.chains: Any = ()
        plots = QtWidgets.QPushButton(translate("Millcorr", "Show as plot"))
        plots.setObjectName("Plot")
        plots.setAutoDefault(False)
        plots.clicked.connect(lambda *_: self._plot())
        self.layout.addWidget(plots)

    def missing(self) -> list[str]:
        """The journal."""
        return [] if self.fields["Journal"].value else ["Journal"]

    def work(self) -> Callable[[], Any]:
        """Read the journal."""
        path = Path(self.fields["Journal"].value)
        return lambda: journal.read(path)

    def show_outcome(self, outcome: Any) -> None:
        """Every part."""
        self.chains = outcome
        rows = [(chain, entry) for chain in outcome for entry in chain.entries]
        self.table.setRowCount(len(rows))
        for row, (chain, entry) in enumerate(rows):
            s = entry.statistics
            deviation = s["deviation"]
            fine, decimals = unit().fine_mm, unit().fine_digits + 1
            numbers = [deviation["mean"], deviation["std"], deviation["height"], s["correction"]]
            shown = [f"{v / fine:.{decimals}f}" if isfinite(v) else "\u2013" for v in numbers]
            decision = worded(history.decision_in_words(entry))
            names = " ".join(name for name, _ in entry.measurements)
            _put(self.table, row, [chain.name, str(entry.part), names, *shown, decision])
        self.table.resizeColumnsToContents()
        self.text.setPlainText(
            "\n".join(worded(line) for chain in outcome for line, _ in history.series(chain.entries))
        )

    def _plot(self) -> None:
        from . import plots

        plots.show_history(self.chains)

    def job(self) -> file_task.Job:
        """Write the report."""
        path, directory = file_task.absolute([self.fields["Journal"].value, self.fields["Report"].value or "history"])
        lines = ["from millcorr.app import programs", f"print({call('programs.history', path, report=directory)})"]
        return file_task.Job(lines, programs, "history", lambda: programs.history(path, report=directory))

    def show_written(self, text: str) -> None:
        """Where the report is; the table itself is shown already."""
        super().show_written(text.splitlines()[-1])
