# SPDX-License-Identifier: LGPL-2.1-or-later
"""An operation simulated before it is cut: the cutter runs along, its signals in step, the contours it would leave."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from millcorr.app import draft, simulating
from millcorr.app.properties import QT_TRANSLATE_NOOP, Property
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.report import simulation_view
from millcorr.report.picture import simulation as simulation_arrays
from millcorr.report.picture.simulation import Played
from millcorr.report.reader import Reader, read_by

from . import file_task, plots
from .cutter import Cutter
from .line_set import LineLayer
from .magnification import MagnificationFields
from .options import Expression, call
from .qt import QtCore, QtWidgets
from .theme import ThemeWatch, colours, theme
from .wheel import calm

_text = QT_TRANSLATE_NOOP

TICK = 40
"""Milliseconds from one place of the cutter to the next."""

STEPS = 2000
"""Places of the slider."""

SPEEDS = (0.2, 1.0, 2.0, 5.0, 10.0)
"""So many times faster than the machine."""

_ROWS = (
    Property(
        "OpenFile",
        "Setup",
        "",
        _text("App::Property", "Tool, material, machine and stock"),
        _text("Millcorr", "Setups (*.toml);;All files (*)"),
    ),
    Property(
        "Bool",
        "AutomaticMagnification",
        "",
        _text("App::Property", "Errors and the part's size decide how much larger errors are drawn"),
        True,
    ),
    Property("Float", "Magnification", "", _text("App::Property", "So many times larger errors are drawn"), 100.0),
    Property("Directory", "Report", "", _text("App::Property", "Directory for the report with all signals")),
)

SIGNALS = (
    _text("Millcorr", "force"),
    _text("Millcorr", "engaged arc"),
    _text("Millcorr", "feed"),
    _text("Millcorr", "deflection"),
)
"""Names of signals, for the tool that collects texts."""


class SimulateTask(file_task.FileTask):
    """The simulation of an operation.

    Parameters
    ----------
    operation : document object
    """

    verb = _text("Millcorr", "Write report")
    aside = True

    def __init__(self, operation: Any) -> None:
        super().__init__(translate("Millcorr", "Simulation"), "Millcorr_Simulate", "simulate.md")
        self.operation, self.home = operation, operation.Document.Name
        self.played: Played | None = None
        self.time = 0.0
        self.contours, self.cutter = LineLayer(operation.Document), Cutter(operation.Document)
        self.group(operation.Label, _ROWS, self.changed)
        self.fields["AutomaticMagnification"].show_value(True)
        self.magnification = MagnificationFields(self.fields)
        self.magnification.chosen()
        self.fields["AutomaticMagnification"].widget.toggled.connect(lambda *_: self.magnification.chosen())
        self.found = QtWidgets.QLabel(
            translate("Millcorr", "Name the setup: tool, material, machine and stock, as a TOML file.")
        )
        self.found.setObjectName("Found")
        self.found.setWordWrap(True)
        self.layout.addWidget(self.found)
        self._make_player()
        self.canvas: Any = None
        self.drawing: Any = None
        if plots.has_matplotlib():
            from .signal_canvas import SignalCanvas

            self.canvas = SignalCanvas(colours(), self.seek)
            self.layout.addWidget(self.canvas, 1)
        else:
            from .plot_drawing import Drawing

            self.drawing = Drawing()
            self.layout.addWidget(self.drawing, 1)
        self._watch = ThemeWatch(self.form, self._recolour)
        self._clock = QtCore.QTimer(self.form)
        self._clock.setInterval(TICK)
        self._clock.timeout.connect(self._tick)

    def _make_player(self) -> None:
        row = QtWidgets.QHBoxLayout()
        self.play = QtWidgets.QPushButton(translate("Millcorr", "Play"))
        self.play.setObjectName("Play")
        self.play.setAutoDefault(False)
        self.play.setEnabled(False)
        self.play.clicked.connect(lambda *_: self.toggle())
        self.slider = calm(QtWidgets.QSlider(QtCore.Qt.Orientation.Horizontal))
        self.slider.setObjectName("Time")
        self.slider.setAccessibleName(translate("Millcorr", "time, s"))
        self.slider.setRange(0, STEPS)
        self.slider.setEnabled(False)
        self.slider.valueChanged.connect(self._slid)
        self.speed = calm(QtWidgets.QComboBox())
        self.speed.setObjectName("Speed")
        self.speed.setToolTip(translate("Millcorr", "So many times faster than the machine"))
        for speed in SPEEDS:
            self.speed.addItem(f"{speed:g}\u00d7", speed)
        self.speed.setCurrentIndex(SPEEDS.index(5.0))
        for widget in (self.play, self.slider, self.speed):
            row.addWidget(widget)
        self.layout.addLayout(row)
        self.now = QtWidgets.QLabel()
        self.now.setObjectName("Now")
        self.now.setWordWrap(True)
        self.layout.addWidget(self.now)

    # The work ----------------------------------------------------------------------------------------

    def missing(self) -> list[str]:
        """The setup."""
        return [] if self.fields["Setup"].value else ["Setup"]

    def work(self) -> Callable[[], Any]:
        """Simulate, and prepare what is drawn."""
        finish = simulating.prepared(self.operation, self.fields["Setup"].value)
        wanted, shown = self.magnification.wanted, unit()

        def function() -> Any:
            played = finish()
            times = simulation_arrays.magnification(played, wanted)
            return played, times, simulation_arrays.traces(played, shown), simulation_arrays.lines(played, times)

        return function

    def show_outcome(self, outcome: Any) -> None:
        """Contours, signals, and the player at its start."""
        self.played, times, self.traces, lines = outcome
        self.magnification.show(times)
        played = self.played
        self.contours.fill(lines)
        radius = played.before.setup.tool.radius
        self.cutter.size(radius, 5 * radius)
        shown = unit()
        text = translate("Millcorr", "Largest predicted error {} {}").format(
            shown.fine_number(played.before.largest, ""), shown.fine
        )
        if played.after is not None:
            after = shown.fine_number(played.after.largest, "")
            text += translate("Millcorr", ", corrected {} {}").format(after, shown.fine)
        text += "<br>" + translate(
            "Millcorr",
            "<span style='color:#888'>\u2014</span> commanded path, <span style='color:#c00'>\u2014</span> machined "
            "contour, <span style='color:#2e9a1c'>\u2014</span> corrected contour, errors {:g}:1",
        ).format(times)
        cautions = [*played.before.cautions, *([played.refused] if played.refused else [])]
        self.found.setText("<br>".join([text, *map(worded, cautions)]))
        self._draw()
        for widget in (self.play, self.slider):
            widget.setEnabled(True)
        self.seek(0.0)

    def _draw(self) -> None:
        """Draw the signals."""
        if self.canvas is not None:
            self.canvas.fill(self.traces)
        elif self.played is not None:
            with read_by(Reader(unit())):
                drawn = simulation_view.load_plot(self.played.signals)
            self.drawing.show_svg(plots.report_plots.standalone(drawn, theme()), colours()["paper"])

    def _recolour(self) -> None:
        """Draw in the window's new colours."""
        if self.canvas is not None:
            self.canvas.recolour(colours())
        else:
            self._draw()

    def show_failure(self, text: str) -> None:
        """Nothing to play, and why."""
        self._stop_playing()
        self.played = None
        self.contours.hide()
        for widget in (self.play, self.slider):
            widget.setEnabled(False)
        super().show_failure(text)

    def job(self) -> file_task.Job:
        """Write the report."""
        values = self.values
        if not (values["Setup"] and values["Report"]):
            raise UsageError(phrase("name the setup and the directory for the report"))
        setup, directory = file_task.absolute([values["Setup"], values["Report"]])
        made = call("simulating.write", Expression(draft.in_python(self.operation)), setup, directory)
        request = simulating.request_of(self.operation, setup)
        return file_task.Job(
            ["from millcorr.app import simulating", f"print({made})"],
            simulating,
            "write",
            lambda: simulating.written(request, directory),
        )

    # The player --------------------------------------------------------------------------------------

    def toggle(self) -> None:
        """Play, or pause."""
        if self._clock.isActive():
            self._stop_playing()
            return
        if self.played is not None:
            if self.time >= self.played.duration:
                self.seek(0.0)
            self._clock.start()
            self.play.setText(translate("Millcorr", "Pause"))

    def _stop_playing(self) -> None:
        self._clock.stop()
        self.play.setText(translate("Millcorr", "Play"))

    def _tick(self) -> None:
        if self.played is None:
            return
        self.seek(self.time + TICK / 1000.0 * self.speed.currentData())
        if self.time >= self.played.duration:
            self._stop_playing()

    def _slid(self, step: int) -> None:
        if self.played is not None:
            self._show(step / STEPS * self.played.duration)

    def seek(self, time: float) -> None:
        """Go to a time from the first step, in s."""
        if self.played is None:
            return
        time = min(max(time, 0.0), self.played.duration)
        before = self.slider.blockSignals(True)
        self.slider.setValue(round(time / self.played.duration * STEPS) if self.played.duration else 0)
        self.slider.blockSignals(before)
        self._show(time)

    def _show(self, time: float) -> None:
        assert self.played is not None
        self.time = time
        self.cutter.move(*self.played.cutter_at(time))
        row = self.played.row_at(time)
        values = [f"{translate('Millcorr', t.name)} {t.now[row]:.3g} {t.unit}" for t in self.traces]
        line = int(self.played.signals.line[row])
        told = translate("Millcorr", "{:.2f} s, line {}: ").format(time, line)
        self.now.setText(told + ", ".join(values))
        if self.canvas is not None:
            self.canvas.show_time(time)

    def stop_all(self) -> None:
        """Take everything out of the 3-D view."""
        self._stop_playing()
        self.contours.remove()
        self.cutter.remove()
        super().stop_all()
