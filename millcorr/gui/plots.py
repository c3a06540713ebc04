# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots beside the 3-D view: along the contour, distribution, history; what is pointed at shows in both.

With matplotlib, pointing and zooming are linked to the view. Without it the report's own drawings are shown.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app import candidates, correction
from millcorr.errors import MillcorrError
from millcorr.report import history as report_history
from millcorr.report import plots as report_plots
from millcorr.report.posterior import posteriors
from millcorr.scene import plots as plot_arrays

from .line_set import LineLayer
from .plot_link import PlotLink
from .qt import QtCore, QtWidgets
from .text import translate
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
        self._last: tuple[str, Any, Any] | None = None
        if has_matplotlib():
            from . import plot_canvas  # noqa: F401

            self.canvas = plot_canvas.Canvas(colours())
            self._tools = plot_canvas.toolbar(self.canvas, self)
            tint(self._tools, colours()["soft"])
            layout.addWidget(self._tools)
            layout.addWidget(self.canvas, 1)
        else:
            from .plot_drawing import Drawing

            self.drawing = Drawing()
            layout.addWidget(self.drawing, 1)
        self._watch = ThemeWatch(self, self._recolour)

    def _recolour(self) -> None:
        """Draw what is drawn in the window's new colours; the part of it that is shown stays."""
        if self.canvas is not None:
            tint(self._tools, colours()["soft"])
            self.canvas.recolour(colours())
        if self._last is not None:
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
        self.obj: Any = None
        self.result: Any = None
        self.along: Any = None
        self._mark: LineLayer | None = None
        inner = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(inner)
        layout.setContentsMargins(2, 2, 2, 2)
        self.told = QtWidgets.QLabel()
        self.told.setObjectName("Told")
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
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.told, 1)
        row.addWidget(self.linked)
        layout.addLayout(row)
        self.pages = {
            "along": Page("Along"),
            "distribution": Page("Distribution"),
            "history": Page("History"),
        }
        self.tabs = QtWidgets.QTabWidget()
        self.tabs.setObjectName("Tabs")
        for name, title in (
            ("along", translate("Millcorr", "Along the contour")),
            ("distribution", translate("Millcorr", "Distribution")),
            ("history", translate("Millcorr", "History of parts")),
        ):
            self.tabs.addTab(self.pages[name], title)
        layout.addWidget(self.tabs, 1)
        self.setWidget(inner)
        self._worker = Worker(self, self._computed, self._failed)
        self.link = PlotLink(self)
        canvas = self.pages["along"].canvas
        if canvas is not None:
            canvas.pointed = self.point_at
            canvas.zoomed = self.link.zoom_view
        self.linked.setVisible(canvas is not None)
        self.visibilityChanged.connect(self._shown)

    def open_up(self, page: str) -> None:
        """Show the dock with a page; the 3-D view keeps most of the room."""
        self.tabs.setCurrentWidget(self.pages[page])
        self.show()
        self.raise_()
        window = FreeCADGui.getMainWindow()
        window.resizeDocks([self], [window.height() // 3], QtCore.Qt.Orientation.Vertical)

    def show_correction(self, obj: Any) -> None:
        """Plot the correction of a dressup; empty where it is None."""
        self._forget()
        self.obj = obj
        if obj is None:
            self.told.setText(translate("Millcorr", "Select a compensated toolpath"))
            return
        try:
            finish = correction.prepared(obj)
        except MillcorrError as error:
            self._failed(error)
            return
        self.told.setText(translate("Millcorr", "Computing"))

        def function() -> Any:
            result = finish().result
            return result, plot_arrays.along(result), plot_arrays.distribution(result)

        self._worker.start(function)

    def _computed(self, outcome: Any) -> None:
        self.result, self.along, distribution = outcome
        result = self.result
        if not len(result.deviation):
            self.told.setText(translate("Millcorr", "{}: nothing was measured").format(self.obj.Label))
            return
        self.told.setText(self.obj.Label)
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
        self.told.setText(str(error))

    def show_history(self, chains: Sequence[Any]) -> None:
        """Plot the parts of the first series that has some."""
        entries = next((chain.entries for chain in chains if chain.entries), ())
        if entries:
            self.pages["history"].draw(
                "history", plot_arrays.series(entries), lambda: report_history.deviations(entries)
            )

    # Linked to the view ------------------------------------------------------------------------------

    def point_at(self, x: float | None) -> None:
        """Mark a place in plot and view, and tell what was measured there; None marks nothing."""
        canvas = self.pages["along"].canvas
        if self.result is None or self._mark is None or canvas is None:
            return
        if x is None or not 0 <= x <= self.along.total:
            self._mark.hide()
            canvas.mark(None)
            self.told.setText(self.obj.Label)
            return
        canvas.mark(x)
        row = plot_arrays.nearest(self.along, x)
        told = translate("Millcorr", "s {:.2f} mm: measured {:+.1f} \u00b5m, expected next {:+.1f} \u00b5m")
        # A rounded zero has no sign.
        values = (round(float(array[row]), 1) + 0.0 for array in (self.along.raw, self.along.predicted))
        self.told.setText(told.format(self.along.x[row], *values))
        if self.linked.isChecked():
            self._mark.fill(plot_arrays.mark(self.result, x))

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


class _Watch:
    """What FreeCAD tells of the selection, of documents, and of recomputed objects."""

    def addSelection(self, document: str, name: str, *more: Any) -> None:
        """Plot a dressup when it is selected."""
        obj = FreeCAD.getDocument(document).getObject(name)
        if _dock and _dock[0].isVisible() and obj is not None and candidates.is_correction(obj):
            _dock[0].show_correction(obj)

    def slotRecomputedObject(self, obj: Any) -> None:
        """Plot anew what is plotted when it was computed anew."""
        if _dock and _dock[0].isVisible() and _dock[0].obj is not None and obj.Name == _dock[0].obj.Name:
            _dock[0].show_correction(obj)

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


def show_history(chains: Sequence[Any]) -> None:
    """Show the history of parts."""
    plots = dock()
    plots.open_up("history")
    plots.show_history(chains)
