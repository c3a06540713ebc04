# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots beside the 3-D view: along the contour, distribution, history; what is pointed at shows in both.

With matplotlib, pointing and zooming are linked to the view. Without it the report's own drawings are shown.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import candidates, correction
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.errors import MillcorrError
from millcorr.report import history as report_history
from millcorr.report import plots as report_plots
from millcorr.report.picture import plots as plot_arrays
from millcorr.report.posterior import posteriors

from .icons import qt_icon
from .line_set import LineLayer
from .plot_file import FilePage
from .plot_link import PlotLink
from .qt import QtCore, QtWidgets
from .theme import ThemeWatch, colours, theme, tint
from .worker import Worker

_dock: list[Any] = []


def has_matplotlib() -> bool:
    """Whether matplotlib can draw here."""
    try:
        from . import plot_canvas  # noqa: F401
    # Its backends complain in many ways about a Qt they do not know.
    except (ImportError, RuntimeError, AttributeError, ValueError):
        return False
    return True


class Page(QtWidgets.QWidget):
    """One plot with its tools."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        self.canvas: Any = None
        self.drawing: Any = None
        self.tools: Any = None
        self._last: tuple[str, Any, Any] | None = None
        if has_matplotlib():
            from . import plot_canvas  # noqa: F401

            self.canvas = plot_canvas.Canvas(colours())
            self.tools = plot_canvas.toolbar(self.canvas, self)
            tint(self.tools, colours()["soft"])
            layout.addWidget(self.canvas, 1)
        else:
            from .plot_drawing import Drawing

            self.drawing = Drawing()
            layout.addWidget(self.drawing, 1)
        self._watch = ThemeWatch(self, self._recolour)
        self.empty()

    def empty(self) -> None:
        """Show nothing: what was drawn belongs to what is plotted no more."""
        self._last = None
        (self.drawing if self.canvas is None else self.canvas).empty()

    def _recolour(self) -> None:
        """Draw what is drawn in the window's new colours; the part of it that is shown stays."""
        if self.canvas is not None:
            tint(self.tools, colours()["soft"])
            self.canvas.recolour(colours())
        if self._last is None:
            self.empty()
        else:
            shown = None if self.canvas is None else self.canvas.shown_range
            self.draw(*self._last)
            if shown is not None:
                self.canvas.show_range(*shown)

    def draw(self, name: str, arrays: Any, plot: Any) -> None:
        """Draw arrays where matplotlib is there, else the report's drawing, which `plot` makes."""
        self._last = name, arrays, plot
        if self.canvas is not None:
            getattr(self.canvas, name)(arrays)
        else:
            paper = colours()["paper"]
            self.drawing.show_svg(report_plots.standalone(plot(), theme()), paper)


class Plots(QtWidgets.QDockWidget):
    """The dock."""

    def __init__(self) -> None:
        super().__init__(translate("Millcorr", "Millcorr plots"), FreeCADGui.getMainWindow())
        self.setObjectName("MillcorrPlots")
        self.setWindowIcon(qt_icon("Millcorr_Plots"))
        self.obj: Any = None
        self.result: Any = None
        self.along: Any = None
        self._mark: LineLayer | None = None
        self._picked = ""
        inner = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(inner)
        layout.setContentsMargins(2, 2, 2, 2)
        self.told = QtWidgets.QLabel()
        self.told.setObjectName("Told")
        # Of what belongs to the document, and of a series, which belongs to its journal.
        self._said = {"document": "", "series": ""}
        self.series = QtWidgets.QComboBox()
        self.series.setObjectName("Series")
        self.series.setAccessibleName(translate("Millcorr", "Series"))
        self.series.currentIndexChanged.connect(self._draw_series)
        self._chains: Sequence[Any] = ()
        self.linked = QtWidgets.QCheckBox(translate("Millcorr", "Linked to the 3-D view"))
        self.linked.setObjectName("Linked")
        self.linked.setChecked(True)
        self.linked.setToolTip(
            translate(
                "Millcorr",
                "What is pointed at in the plot shows in the 3-D view and the other way round; the view follows the "
                "zoom of the plot, the plot that of the view",
            )
        )
        self.pages = {
            "along": Page("Along"),
            "distribution": Page("Distribution"),
            "history": Page("History"),
        }
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.told, 1)
        row.addWidget(self.series)
        # In one row with what is told: at the foot of a small screen a plot needs all the height there is.
        for tools in (page.tools for page in self.pages.values() if page.tools is not None):
            row.addWidget(tools)
        row.addWidget(self.linked)
        layout.addLayout(row)
        self.tabs = QtWidgets.QTabWidget()
        self.tabs.setObjectName("Tabs")
        self.file = FilePage()
        for name, title in (
            ("along", translate("Millcorr", "Along the contour")),
            ("distribution", translate("Millcorr", "Distribution")),
            ("history", translate("Millcorr", "History of parts")),
        ):
            self.tabs.addTab(self.pages[name], title)
        self.tabs.insertTab(2, self.file, translate("Millcorr", "Measured file"))
        self.tabs.currentChanged.connect(lambda *_: self._front())
        layout.addWidget(self.tabs, 1)
        self.setWidget(inner)
        self._worker = Worker(self, self._computed, self._failed)
        self.link = PlotLink(self)
        canvas = self.pages["along"].canvas
        if canvas is not None:
            canvas.pointed = self.point_at
            canvas.clicked = self.pick_place
            canvas.zoomed = self.link.zoom_view
        self.visibilityChanged.connect(self._shown)
        # Once FreeCAD is done with what it does now.
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(lambda: self.show_correction(self.obj))
        self._say("document", translate("Millcorr", "Select a compensated toolpath"))
        self._say("series", translate("Millcorr", "A journal's parts are plotted from the window History of parts"))

    def open_up(self, page: str) -> None:
        """Show the dock with a page; the 3-D view keeps most of the room."""
        self.tabs.setCurrentWidget(self.pages[page])
        self.show()
        self.raise_()
        window = FreeCADGui.getMainWindow()
        window.resizeDocks([self], [window.height() // 3], QtCore.Qt.Orientation.Vertical)

    def _say(self, of: str, text: str) -> None:
        """Tell something of the document's correction, or of the series."""
        self._said[of] = text
        self._front()

    def _front(self) -> None:
        """What belongs to the page in front."""
        series = self.tabs.currentWidget() is self.pages["history"]
        self.told.setText(self._said["series" if series else "document"])
        self.series.setVisible(series and self.series.count() > 1)
        for page in self.pages.values():
            if page.tools is not None:
                page.tools.setVisible(self.tabs.currentWidget() is page)
        self.linked.setVisible(not series and self.pages["along"].canvas is not None)

    def refresh_soon(self) -> None:
        """Plot anew what is plotted."""
        self._soon.start(0)

    def show_correction(self, obj: Any) -> None:
        """Plot the correction of a dressup; empty where it is None."""
        self._forget()
        self.obj = obj
        if obj is None:
            self._say("document", translate("Millcorr", "Select a compensated toolpath"))
            return
        try:
            finish = correction.prepared(obj)
        except MillcorrError as error:
            self._failed(error)
            return
        self._say("document", translate("Millcorr", "Computing"))

        def function() -> Any:
            result = finish().result
            return result, plot_arrays.along(result), plot_arrays.distribution(result)

        self._worker.start(function)

    def _computed(self, outcome: Any) -> None:
        self.result, self.along, distribution = outcome
        result = self.result
        if not len(result.deviation):
            self._say("document", translate("Millcorr", "{}: nothing was measured").format(self.obj.Label))
            return
        self._say("document", self.obj.Label)
        d = result.deviation
        self.pages["along"].draw(
            "along",
            self.along,
            lambda: report_plots.along_contour(
                result.nominal,
                d,
                result.filtered,
                result.predicted,
                result.uncertainty,
                posteriors(result),
                result.outlier,
            ),
        )
        self.pages["distribution"].draw(
            "distribution",
            distribution,
            lambda: report_plots.histogram(d.value, result.predicted, result.random_std),
        )
        self._mark = LineLayer(self.obj.Document, 3.0)
        self.link.start()

    def _failed(self, error: BaseException) -> None:
        self._say("document", f"{self.obj.Label}: {worded(error)}")

    def show_history(self, chains: Sequence[Any]) -> None:
        """Plot the parts of a journal's series, the first of them at first."""
        self._chains = [chain for chain in chains if chain.entries]
        before = self.series.blockSignals(True)
        self.series.clear()
        self.series.addItems([chain.name for chain in self._chains])
        self.series.blockSignals(before)
        self._draw_series()

    def _draw_series(self, *_: Any) -> None:
        at = self.series.currentIndex()
        if not 0 <= at < len(self._chains):
            self.pages["history"].empty()
            self._say("series", translate("Millcorr", "The journal has no part yet"))
            return
        chain = self._chains[at]
        self.pages["history"].draw(
            "history", plot_arrays.series(chain.entries), lambda: report_history.deviations(chain.entries)
        )
        self._say("series", translate("Millcorr", "{}, parts: {}").format(chain.name, len(chain.entries)))

    # Linked to the view ------------------------------------------------------------------------------

    def point_at(self, x: float | None) -> None:
        """Mark a place in plot and view, and tell what was measured there; None marks nothing."""
        canvas = self.pages["along"].canvas
        if self.result is None or self._mark is None or canvas is None:
            return
        if x is None or not 0 <= x <= self.along.total:
            self._mark.hide()
            canvas.mark(None)
            self._say("document", self._picked or self.obj.Label)
            return
        canvas.mark(x)
        self._say("document", self._told(plot_arrays.nearest(self.along, x)))
        if self.linked.isChecked():
            self._mark.fill(plot_arrays.mark(self.result, x))

    def _told(self, row: int) -> str:
        """What was measured at a deviation's place."""
        shown = unit()
        told = translate("Millcorr", "s {0:.{1}f} {2}: measured {3} {5}, expected next {4} {5}")
        values = (shown.fine_number(1e-3 * float(array[row])) for array in (self.along.raw, self.along.predicted))
        place = float(self.along.x[row]) / shown.mm
        return told.format(place, shown.digits - 2, shown.name, *values, shown.fine)

    def pick_place(self, x: float) -> None:
        """Keep the deviation that is nearest to a place of the plot."""
        if self.result is not None and len(self.result.deviation):
            row = plot_arrays.nearest(self.along, x)
            self.pick(self.obj, row, int(self.result.deviation.index[row]))

    def pick(self, obj: Any, row: int, index: int) -> None:
        """Keep a point that was picked: its place in plot and view, and its line of the measured file.

        Parameters
        ----------
        obj : document object
            The dressup whose picture it was picked in.
        row : int
            Of the deviations; -1 at a point that is left out, which has no place in the plot.
        index : int
            Of the measurement's points.
        """
        if self.result is None or obj is not self.obj or not self.isVisible():
            return
        measurement = self.result.request.measurement
        there = 0 <= row < len(self.result.deviation)
        line = "" if measurement is None else self._line(measurement, index)
        self._picked = "   ".join([*([self._told(row)] if there else []), *([line] if line else [])])
        self._say("document", self._picked)
        canvas = self.pages["along"].canvas
        if canvas is not None:
            canvas.pin(plot_arrays.place_of(self.result, row) if there else None)
        if there and self._mark is not None and self.linked.isChecked():
            self._mark.fill(plot_arrays.mark(self.result, plot_arrays.place_of(self.result, row)))

    def _line(self, measurement: Any, index: int) -> str:
        """Show the line of the file that a point comes from, and say what it says."""
        if not 0 <= index < len(measurement.lines):
            return ""
        number = int(measurement.lines[index])
        text = self.file.show_line(Path(self.obj.Measurement.File), number)
        return f"{measurement.origin(index)}: {text.strip()}" if text else measurement.origin(index)

    def _shown(self, shown: bool) -> None:
        if shown and self.result is not None:
            self.link.start()
        else:
            self.link.stop()
            if self._mark is not None:
                self._mark.hide()

    def _forget(self) -> None:
        self.link.stop()
        if self._mark is not None:
            self._mark.remove()
        self._mark = self.result = self.along = None
        self._picked = ""
        self._worker.cancel()
        for page in (self.pages["along"], self.pages["distribution"], self.file):
            page.empty()


class _Watch:
    """What FreeCAD tells of the selection, of documents, and of recomputed objects."""

    def addSelection(self, document: str, name: str, *more: Any) -> None:
        """Plot a dressup when it is selected."""
        obj = FreeCAD.getDocument(document).getObject(name)
        if _dock and _dock[0].isVisible() and obj is not None and candidates.is_correction(obj):
            _dock[0].show_correction(obj)

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Plot anew what is plotted when its path was computed anew, or taken away because it is refused."""
        if name == "Path" and _dock and _dock[0].isVisible() and _dock[0].obj is obj:
            _dock[0].refresh_soon()

    def slotActivateDocument(self, document: Any) -> None:
        """Plot nothing of a document that is not the one in front; its only dressup where it has one."""
        if not _dock or _dock[0].obj is None or _dock[0].obj.Document.Name == document.Name:
            return
        here = [obj for obj in document.Objects if candidates.is_correction(obj)]
        _dock[0].show_correction(here[0] if len(here) == 1 and _dock[0].isVisible() else None)

    def slotDeletedDocument(self, document: Any) -> None:
        """Forget what lay in a document that is closed."""
        if _dock and _dock[0].obj is not None and _dock[0].obj.Document.Name == document.Name:
            _dock[0].link.forget_view()
            _dock[0].show_correction(None)

    def slotDeletedObject(self, obj: Any) -> None:
        """Forget a dressup that is deleted."""
        if _dock and _dock[0].obj is not None and _dock[0].obj.Name == obj.Name:
            _dock[0].show_correction(None)


def dock() -> Plots:
    """The dock, made when it is first asked for."""
    if not _dock:
        made = Plots()
        _dock.append(made)
        watch = _Watch()
        FreeCADGui.Selection.addObserver(watch)
        FreeCAD.addDocumentObserver(watch)
        FreeCADGui.getMainWindow().addDockWidget(QtCore.Qt.DockWidgetArea.BottomDockWidgetArea, made)
        made.hide()
    found: Plots = _dock[0]
    return found


def toggle(obj: Any) -> None:
    """Show the plots of a dressup, or hide them where they are shown."""
    plots = dock()
    if plots.isVisible():
        plots.hide()
        return
    plots.open_up("along")
    plots.show_correction(obj)


def pick(obj: Any, row: int, index: int) -> None:
    """Keep a point that was picked in the picture of a dressup, where the plots are shown; as `Plots.pick`."""
    if _dock:
        _dock[0].pick(obj, row, index)


def show_history(chains: Sequence[Any]) -> None:
    """Show the history of parts."""
    plots = dock()
    plots.open_up("history")
    plots.show_history(chains)
