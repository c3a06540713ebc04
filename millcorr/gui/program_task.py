# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC program files, corrected or split without any document."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from millcorr.app import dressup, measurement_object, programs
from millcorr.app.properties import QT_TRANSLATE_NOOP, Property, of_option
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.correction.settings import Settings
from millcorr.errors import UsageError
from millcorr.messages import option, phrase
from millcorr.options import options_of

from . import file_task, methods, preferences
from .figure_table import FigureTable
from .figures import COLUMNS, figures_of
from .options import call, reading_options, setting_options
from .panel import clear
from .qt import QtWidgets

_text = QT_TRANSLATE_NOOP

PROGRAMS = _text("Millcorr", "NC programs (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;All files (*)")
CONTOURS = _text(
    "Millcorr",
    "Contours (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;All files (*)",
)

_ROWS = {row.name: row for row in (*measurement_object.PROPERTIES, *dressup.PROPERTIES)}

_PROGRAM = (
    Property("OpenFile", "Program", "", _text("App::Property", "NC program that cut the measured part"), PROGRAMS),
    Property("Length", "ToolDiameter", "", _text("App::Property", "Diameter of the cutter"), 0.0),
    Property(
        "OpenFile",
        "Nominal",
        "",
        _text("App::Property", "Contour the part should have: a drawing, or the first program; empty: the program's"),
        CONTOURS,
    ),
)
_MEASURED = (
    Property(
        "OpenFiles",
        "Measured",
        "",
        _text("App::Property", "Measured points, one file a part; deviations of several parts are averaged"),
        _text("Millcorr", "All files (*)"),
    ),
    *(_ROWS[name] for name in ("Points", "BallRadius", "Unit")),
)
_READING = tuple(_ROWS[name] for name in ("Format", "Part", "WorkRotation", "Mapping", "Probe"))
_CORRECTION = tuple(_ROWS[name] for name in ("Filter", "Align", "Gain", "Limit", "DeadBand"))
_METHOD = tuple(_ROWS[name] for name in ("Method", *methods.NAMES))
_MORE = (
    *(
        _ROWS[name]
        for name in ("Side", "CutterCompensation", "Tools", "KeepAllowance", "UnmeasuredShare", "Tolerance", "Accept")
    ),
    of_option(
        options_of(Settings)["output_moves"],
        "",
        _text("App::Property", "Moves of the corrected program: as the program's, only lines, arcs, or NURBS"),
    ),
)
_WRITTEN = (
    Property("SaveFile", "Output", "", _text("App::Property", "Corrected program to write"), PROGRAMS),
    Property("Directory", "Report", "", _text("App::Property", "Directory for the report; empty: none")),
    Property("Bool", "Journal", "", _text("App::Property", "Record the part in the journal of its series"), False),
)


class CorrectTask(file_task.FileTask):
    """Correct an NC program file from measured points."""

    verb = _text("Millcorr", "Write program")

    def __init__(self) -> None:
        super().__init__(translate("Millcorr", "Correct NC program file"), "Millcorr_Program", "nc-programs.md")
        self.group(translate("Millcorr", "Program"), _PROGRAM, self._program_changed)
        self.group(translate("Millcorr", "Measured part"), _MEASURED, self.changed)
        self.group(translate("Millcorr", "How the file is read"), _READING, self.changed, folded=True)
        self.table = FigureTable(translate("Millcorr", "Deviations, {}").format(unit().name), figures_of(None), COLUMNS)
        self.layout.addWidget(self.table)
        self.notes = QtWidgets.QVBoxLayout()
        self.layout.addLayout(self.notes)
        self.group(translate("Millcorr", "Correction"), _CORRECTION, self.changed)
        self.group(translate("Millcorr", "Method"), _METHOD, self._method_changed)
        self.group(translate("Millcorr", "More settings"), _MORE, self.changed, folded=True)
        self.group(translate("Millcorr", "What is written"), _WRITTEN, lambda: None)
        self.layout.addStretch()
        for name, value in preferences.form_values().items():
            if name in self.fields:
                self.fields[name].show_value(value)
        for row in (*_CORRECTION, *_METHOD, *_MORE, *_READING, *_MEASURED, *_PROGRAM):
            usual = row.default[0] if row.kind == "Enumeration" else row.default
            known = row.name in preferences.form_values()
            if usual is not None and not known and row.kind not in ("OpenFile", "OpenFiles", "FileIncluded"):
                self.fields[row.name].show_value(usual)
        methods.show(self.fields, self.fields["Method"].value)

    def _program_changed(self) -> None:
        if not self.fields["Output"].value:
            self.fields["Output"].show_value(file_task.beside(self.fields["Program"].value, "-corrected"))
        self.changed()

    def _method_changed(self) -> None:
        methods.show(self.fields, self.fields["Method"].value)
        self.changed()

    def missing(self) -> list[str]:
        """Program, tool and measurement, where the method needs them."""
        values = self.values
        known = {
            "Program": values["Program"],
            "ToolDiameter": values["ToolDiameter"] or self._setup(values),
            "Measured": values["Measured"] or values["Method"] == "predicted",
        }
        return [name for name, said in known.items() if not said]

    def _setup(self, values: dict[str, Any]) -> str | None:
        """Path of the setup where the method needs one and it is named."""
        wanted = values["Setup"] and methods.counts("Setup", values["Method"])
        return file_task.absolute([values["Setup"]])[0] if wanted else None

    def _asked(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        values = self.values
        program, measured = file_task.absolute([values["Program"]])[0], file_task.absolute(values["Measured"])
        options = reading_options(values) | setting_options(values)
        nominal = file_task.absolute([values["Nominal"]])[0] if values["Nominal"] else None
        known = {"tool_diameter": values["ToolDiameter"] or None, "nominal": nominal, "setup": self._setup(values)}
        return (program, measured), known | options

    def work(self) -> Callable[[], Any]:
        """Check."""
        given, options = self._asked()
        return lambda: programs.check(*given, **options).summary()

    def show_outcome(self, outcome: Any) -> None:
        """Figures, warnings and advice."""
        self.table.fill(figures_of(outcome))
        clear(self.notes)
        for kind, key in (("doubt", "warnings"), ("note", "advice")):
            for text in outcome[key]:
                label = QtWidgets.QLabel(worded(text))
                label.setWordWrap(True)
                label.setProperty("millcorr", kind)
                self.notes.addWidget(label)

    def show_failure(self, text: str) -> None:
        """No figures, and why."""
        self.table.fill(figures_of(None))
        clear(self.notes)
        wrong = methods.at_fault(text, self.fields["Method"].value, self.fields["Setup"].value)
        if wrong:
            self.say("")
            self.fields[wrong].complain(worded(text))
            return
        super().show_failure(text)

    def job(self) -> file_task.Job:
        """Write program and report."""
        values = self.values
        if not values["Output"]:
            raise UsageError(phrase("{} needs a name: the corrected program is written there", option("output")))
        given, options = self._asked()
        written = file_task.absolute([values["Output"], values["Report"] or "."])
        options["output"], options["report"] = written[0], written[1] if values["Report"] else None
        options["journal"] = "" if values["Journal"] else None
        lines = ["from millcorr.app import programs", f"print({call('programs.correct', *given, **options)})"]
        return file_task.Job(lines, programs, "correct", lambda: programs.correct(*given, **options))

    def show_written(self, text: str) -> None:
        """The files; the figures are shown already."""
        names = ("program", "journal", "report")
        super().show_written("\n".join(line for line in text.splitlines() if line.startswith(names)))


_SPLIT = (
    Property("OpenFile", "Program", "", _text("App::Property", "NC program that finishes the part"), PROGRAMS),
    Property("Length", "ToolDiameter", "", _text("App::Property", "Diameter of the cutter"), 0.0),
    Property("Length", "Stock", "", _text("App::Property", "Whole allowance over the finished contour"), 0.0),
    Property("Float", "Share", "", _text("App::Property", "Share of the allowance that the first cut takes"), 0.5),
    Property("SaveFile", "Output", "", _text("App::Property", "Program of the first cut"), PROGRAMS),
)


class SplitTask(file_task.FileTask):
    """The program of a first cut, from the program that finishes the part."""

    verb = _text("Millcorr", "Write program")

    def __init__(self) -> None:
        super().__init__(translate("Millcorr", "Split allowance"), "Millcorr_Split", "transfer-function.md")
        told = QtWidgets.QLabel(
            translate(
                "Millcorr",
                "The first cut leaves a part of the allowance. Measure it, then correct the program that finishes "
                "the part with the method \u201ctransfer\u201d: the part itself has shown how far the machine yields.",
            )
        )
        told.setWordWrap(True)
        self.layout.addWidget(told)
        self.group(translate("Millcorr", "Program"), _SPLIT, self._named)
        self.fields["Share"].show_value(0.5)
        self.text = file_task.monospaced("Told", 6)
        self.layout.addWidget(self.text)

    def _named(self) -> None:
        if not self.fields["Output"].value:
            self.fields["Output"].show_value(file_task.beside(self.fields["Program"].value, "-first"))
        self.changed()

    def missing(self) -> list[str]:
        """Program and tool, and what to write."""
        return [name for name in ("Program", "ToolDiameter", "Stock", "Output") if not self.fields[name].value]

    def complete(self) -> bool:
        """Never: there is nothing to look at before it is written."""
        return False

    def job(self) -> file_task.Job:
        """Write the program of the first cut."""
        values = self.values
        if not (values["Program"] and values["Output"]):
            raise UsageError(phrase("name the program that finishes the part, and the one to write"))
        program, output = file_task.absolute([values["Program"], values["Output"]])
        options = {
            "tool_diameter": values["ToolDiameter"],
            "depth": values["Stock"],
            "at": values["Share"],
            "output": output,
        }
        lines = ["from millcorr.app import programs", f"print({call('programs.split', program, **options)})"]
        return file_task.Job(lines, programs, "split", lambda: programs.split(program, **options))

    def show_written(self, text: str) -> None:
        """What was done, and how to go on."""
        super().show_written(translate("Millcorr", "The program of the first cut is written"))
        self.text.setPlainText(text)
