# SPDX-License-Identifier: LGPL-2.1-or-later
"""The import of a measured file: what it begins with, what must be said of it, and what speaks against it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import candidates, doubts, measurement_object
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.errors import MillcorrError
from millcorr.messages import message_of
from millcorr.readers import FORMATS, Reading
from millcorr.readers import mapping as mappings
from millcorr.readers.preview import HEAD, Preview, preview

from . import origins, panel, preferences
from .closed_documents import when_closed
from .field_kinds import field_for
from .fields import Field
from .file_preview import FilePreview
from .fold import Fold
from .icons import qt_icon
from .keys import keep
from .panel import clear
from .qt import QtCore, QtWidgets
from .remedies import Remedy, first_field, remedies_in
from .screen import fit
from .theme import STYLE, mark
from .wheel import calm
from .worker import Worker

_ASKED = ("Points", "BallRadius", "Unit")
_MORE = ("Format", "Part", "Probe", "WorkRotation")
_open: list[Any] = []
"""The dialog that is open: Python must hold on to it."""


class ImportDialog(QtWidgets.QDialog):
    """Asks for a measured file and what must be known to read it.

    Parameters
    ----------
    document : FreeCAD document
    operation : document object or None
        The operation that cut the part: its contour shows doubts that the file alone does not.
    imported : callable
        Gets the new measurement.
    """

    def __init__(self, document: Any, operation: Any, imported: Callable[[Any], None]) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.document, self.operation, self._imported = document, operation, imported
        self.home = document.Name
        self.setObjectName("MillcorrImport")
        self.setWindowTitle(translate("Millcorr", "Import measurement"))
        self.setWindowIcon(qt_icon("Millcorr_Measurement"))
        self.setWindowFlag(QtCore.Qt.WindowType.WindowContextHelpButtonHint, False)
        self.setStyleSheet(STYLE)
        fit(self, 760, 640)
        self.fields: dict[str, Field] = {}
        self.seen = Preview("")
        self.measurement: Any = None
        self._shown = Path()
        self._make()
        for name in ("Points", "BallRadius"):
            self.fields[name].show_value(preferences.get(name))
        self._pause = QtCore.QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(panel.PAUSE)
        self._pause.timeout.connect(self._begin)
        self._worker = Worker(self, self._done, self._failed, self._progressed)
        self._state()
        keep(self, lambda: self.busy)

    # What it is made of ------------------------------------------------------------------------------

    def _make(self) -> None:
        layout = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("Millcorr", "&File"))
        self.path = QtWidgets.QLineEdit()
        self.path.setObjectName("File")
        self.path.setPlaceholderText(translate("Millcorr", "file of a CMM, a probe log, or a table of points"))
        self.path.editingFinished.connect(self._file_changed)
        label.setBuddy(self.path)
        browse = QtWidgets.QPushButton(translate("Millcorr", "&Browse\u2026"))
        browse.setObjectName("Browse")
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        for widget in (label, self.path, browse):
            row.addWidget(widget)
        layout.addLayout(row)
        self.table = FilePreview(self._changed)
        layout.addWidget(self.table, 1)
        rows = {row.name: row for row in measurement_object.PROPERTIES}
        form = QtWidgets.QFormLayout()
        form.setVerticalSpacing(2)
        for name in _ASKED:
            self._add(rows[name], form)
        layout.addLayout(form)
        inner = QtWidgets.QWidget()
        form = QtWidgets.QFormLayout(inner)
        form.setVerticalSpacing(2)
        form.setContentsMargins(0, 0, 0, 0)
        for name in _MORE:
            self._add(rows[name], form)
        self._add_offset(form)
        self.more = Fold(translate("Millcorr", "&More"), inner)
        layout.addWidget(self.more)
        self.found = QtWidgets.QLabel()
        self.found.setObjectName("Found")
        self.found.setWordWrap(True)
        layout.addWidget(self.found)
        self.findings = QtWidgets.QVBoxLayout()
        layout.addLayout(self.findings)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setObjectName("Progress")
        layout.addWidget(self.bar)
        buttons = QtWidgets.QDialogButtonBox()
        self.ok = buttons.addButton(translate("Millcorr", "Import"), QtWidgets.QDialogButtonBox.ButtonRole.AcceptRole)
        self.ok.setObjectName("OK")
        cancel = buttons.addButton(translate("Millcorr", "Cancel"), QtWidgets.QDialogButtonBox.ButtonRole.RejectRole)
        cancel.setAutoDefault(False)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout.addWidget(buttons)

    def _add(self, row: Any, form: Any) -> None:
        field = self.fields[row.name] = field_for(row, self._changed)
        field.add_to(form)
        if row.name == "Format":
            field.widget.addItem(translate("Millcorr", "by its content"), "")
            field.widget.addItems(list(FORMATS))
            field.widget.setEditText("")
            field.widget.lineEdit().setPlaceholderText(translate("Millcorr", "by its content"))

    def _add_offset(self, form: Any) -> None:
        row = QtWidgets.QHBoxLayout()
        self.offset_given = QtWidgets.QCheckBox(
            translate("Millcorr", "Origin of the work frame in the file's, {}").format(unit().name)
        )
        self.offset_given.setObjectName("WorkOffsetGiven")
        self.offset = []
        for axis in "XYZ":
            box = calm(QtWidgets.QDoubleSpinBox())
            box.setRange(-1e6, 1e6)
            box.setDecimals(unit().digits)
            box.setKeyboardTracking(False)
            box.setObjectName(f"WorkOffset{axis}")
            box.setAccessibleName(f"{axis} {unit().name}")
            box.setEnabled(False)
            box.valueChanged.connect(lambda *_: self._changed())
            self.offset_given.toggled.connect(box.setEnabled)
            self.offset.append(box)
            row.addWidget(box)
        self.offset_given.toggled.connect(lambda *_: self._changed())
        form.addRow(self.offset_given)
        form.addRow(row)

    # What the user does ------------------------------------------------------------------------------

    def _browse(self) -> None:
        title, kinds = translate("Millcorr", "Measured points"), translate("Millcorr", "All files (*)")
        chosen, _ = QtWidgets.QFileDialog.getOpenFileName(self, title, self.path.text(), kinds)
        if chosen:
            self.set_file(chosen)

    def set_file(self, path: str) -> None:
        """Take a file as if the user had chosen it."""
        self.path.setText(path)
        self._file_changed()

    def _file_changed(self) -> None:
        path = Path(self.path.text().strip())
        if path == self._shown:
            # Also leaving the field ends editing.
            return
        self._shown = path
        try:
            with open(path, "rb") as stream:
                head = stream.read(HEAD)
        except OSError as error:
            self.seen = Preview("")
            self.table.fill(self.seen)
            self._show_failure(f"{path}: {error.strerror or error}" if str(path) != "." else "")
            return
        self.seen = preview(head, path.name)
        self.table.fill(self.seen)
        self._changed()

    def _changed(self) -> None:
        for field in self.fields.values():
            field.complain("")
        points = self.fields["Points"].value
        self.fields["BallRadius"].set_shown(points in ("centre", "axis") or self.fields["BallRadius"].value > 0)
        if not self.path.text().strip():
            return
        self._worker.cancel()
        self.measurement = None
        self._state(translate("Millcorr", "Reading"), 0.0)
        self._pause.start()

    def set_field(self, remedy: Remedy) -> None:
        """Give a field a value as if the user had; without a value lead there."""
        field = self.fields.get(remedy.field)
        if field is None:
            return
        if remedy.field in _MORE:
            self.more.setChecked(True)
        if remedy.value is None:
            field.widget.setFocus()
            return
        field.show_value(remedy.value)
        self._changed()

    def reading(self) -> Reading:
        """What is said of the file."""
        value = {name: field.value for name, field in self.fields.items()}
        as_file = measurement_object.AS_FILE
        columns, mm = self.table.changed_columns(), unit().mm
        return Reading(
            points=None if value["Points"] == as_file else value["Points"],
            probe_radius=value["BallRadius"] or None,
            units=None if value["Unit"] == as_file else value["Unit"],
            format=value["Format"] or None,
            mapping=None if columns is None else _kept(self.seen, columns),
            part=value["Part"] or None,
            probe=Path(value["Probe"]).expanduser().resolve() if value["Probe"] else None,
            work_offset=tuple(mm * box.value() for box in self.offset) if self.offset_given.isChecked() else None,
            work_rotation=value["WorkRotation"] or None,
        )

    # The work ----------------------------------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """Whether the file is still being looked at."""
        return self._worker.busy or self._pause.isActive()

    def _begin(self) -> None:
        try:
            path, reading = Path(self.path.text().strip()), self.reading()
            look = doubts.prepared(self.operation)
        except (MillcorrError, ValueError) as error:
            self._failed(error)
            return
        read = measurement_object.reader_of_file(path, reading, path.name)

        def function() -> Any:
            measurement = read()
            said = measurement_object.described(measurement)
            try:
                return measurement, said, look(measurement), ""
            except MillcorrError as error:
                return measurement, said, (), error.message

        self._worker.start(function)

    def _progressed(self, stage: str, share: float) -> None:
        self._state(translate("Millcorr", stage or "Reading"), share)

    def _done(self, outcome: Any) -> None:
        self.measurement, (levels, low, high), findings, trouble = outcome
        self._state()
        self._show_found(levels, low, high)
        clear(self.findings)
        if trouble:
            self._show_finding(trouble, True)
        for finding in findings:
            self._show_finding(finding.text, finding.dangerous)

    def _show_found(self, levels: int, low: list[float], high: list[float]) -> None:
        measurement = self.measurement
        axes = "XYZ" if measurement.has_z else "XY"
        shown = unit()
        size = ", ".join(
            f"{a} {least / shown.mm:.3f} \u2026 {most / shown.mm:.3f}"
            for a, least, most in zip(axes, low, high, strict=False)
        )
        text = translate("Millcorr", "Points: {}, heights: {}. {} {}. Format: {}, unit in the file: {}").format(
            len(measurement), levels, size, shown.name, measurement.format, measurement.unit
        )
        self._say("\n".join([text, *_known(measurement), *map(worded, measurement.notes)]), "good")

    def _failed(self, error: BaseException) -> None:
        self._state()
        if not isinstance(error, MillcorrError | ValueError):
            FreeCAD.Console.PrintError(f"{type(error).__name__}: {error}\n")
        self._show_failure(message_of(error), getattr(error, "reason", ""))

    def _show_failure(self, text: str, question: str = "") -> None:
        clear(self.findings)
        self.measurement = None
        self._state()
        field = self.fields.get(first_field(text))
        if field is not None:
            self._say("", "good")
            if field.name in _MORE:
                self.more.setChecked(True)
            field.set_shown(True)
            # What the file leaves open is a question, not an error of the user's.
            field.complain(worded(question or text))
        else:
            self._say(worded(text), "wrong")

    def _show_finding(self, text: str, dangerous: bool) -> None:
        box = QtWidgets.QWidget()
        row = QtWidgets.QVBoxLayout(box)
        row.setContentsMargins(0, 0, 0, 0)
        label = QtWidgets.QLabel(worded(text))
        label.setWordWrap(True)
        label.setProperty("millcorr", "wrong" if dangerous else "doubt")
        row.addWidget(label)
        buttons = QtWidgets.QHBoxLayout()
        for remedy in remedies_in(text):
            if remedy.field in self.fields:
                button = QtWidgets.QPushButton(remedy.in_words())
                button.setObjectName(f"Remedy {remedy.field}")
                button.setAutoDefault(False)
                button.clicked.connect(lambda *_, r=remedy: self.set_field(r))
                buttons.addWidget(button)
        buttons.addStretch()
        row.addLayout(buttons)
        self.findings.addWidget(box)

    def _say(self, text: str, kind: str) -> None:
        mark(self.found, kind)
        self.found.setText(text)
        self.found.setVisible(bool(text))

    def _state(self, text: str = "", share: float = 0.0) -> None:
        self.bar.setVisible(bool(text))
        self.bar.setValue(round(100 * share))
        self.bar.setFormat(f"{text} \u2026 %p %")
        self.ok.setEnabled(self.measurement is not None and not text)

    # The end -----------------------------------------------------------------------------------------

    def lines(self) -> list[str]:
        """Python lines that import the file."""
        path = str(Path(self.path.text().strip()).resolve())
        said = "".join(f", {name}={value!r}" for name, value in self.reading().as_dict().items())
        return [
            "from millcorr.app import measurement_object",
            # Not the whole document: an operation of FreeCAD that it would compute anew takes its time.
            f"measurement_object.create(App.ActiveDocument, {path!r}{said}).recompute()",
        ]

    def accept(self) -> None:
        """Import in one transaction; the dialog stays where that fails."""
        if self.busy or self.measurement is None:
            return
        before = {obj.Name for obj in self.document.Objects}
        if not panel.run(self.document, self.windowTitle(), self.lines()):
            self._say(translate("Millcorr", "Not imported, see the report view"), "wrong")
            return
        new = [obj for obj in candidates.measurements(self.document) if obj.Name not in before]
        super().accept()
        self._imported(new[-1])

    def done(self, result: int) -> None:
        """Stop everything, however the dialog ends."""
        self._pause.stop()
        self._worker.cancel()
        _open.clear()
        super().done(result)


def _known(measurement: Any) -> list[str]:
    """What of a measurement neither its file nor the user said, a line each."""
    bases = measurement.bases.items()
    return [origins.in_words(what, basis) for what, basis in bases if basis.how in ("inferred", "assumed")]


def _kept(seen: Preview, columns: dict[str, int]) -> Path:
    """File with a mapping, in a place that stays: a recorded macro names it."""
    mapping = seen.mapped(columns)
    directory = Path(FreeCAD.getUserAppDataDir()) / "millcorr" / "mappings"
    directory.mkdir(parents=True, exist_ok=True)
    name = "-".join(f"{key}{at}" for key, at in sorted(columns.items()))
    file = directory / f"{mapping.separator}-{mapping.decimal}-{mapping.skip}-{name}.toml"
    return mappings.save(file, mapping)


def _close_of(name: str) -> None:
    """Close the dialog that is about a document."""
    for dialog in list(_open):
        if dialog.home == name:
            dialog.reject()


def show(document: Any, operation: Any = None, imported: Callable[[Any], None] = lambda obj: None) -> ImportDialog:
    """Open the dialog, or bring the open one forward; gives it."""
    when_closed(_close_of)
    if not _open:
        _open.append(ImportDialog(document, operation, imported))
    dialog: ImportDialog = _open[0]
    dialog.show()
    dialog.raise_()
    dialog.path.setFocus()
    return dialog
