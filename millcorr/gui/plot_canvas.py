# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots drawn by matplotlib; imported only where it is there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg, NavigationToolbar2QT
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy import isfinite

from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.report.length_unit import MM
from millcorr.report.picture.plots import Along, Distribution, Series

from .qt import QtCore, QtWidgets

ENTRY = 190
"""Width of an entry of the legend, pixels."""


class Canvas(FigureCanvasQTAgg):
    """A figure with one pair of axes.

    Parameters
    ----------
    colours : mapping of str to str
        By role, as `millcorr.report.plots.COLOURS` has them.
    """

    def __init__(self, colours: dict[str, str]) -> None:
        super().__init__(Figure(layout="constrained"))
        self.colours = colours
        self.axes = self.figure.add_subplot()
        self.setMinimumHeight(90)
        self.figure.set_facecolor(colours["paper"])
        self.pointed: Callable[[float | None], None] = lambda x: None
        self.zoomed: Callable[[float, float], None] = lambda low, high: None
        self.clicked: Callable[[float], None] = lambda x: None
        self._mark: Any = None
        self._pin: Any = None
        self._told = False
        self.mpl_connect("motion_notify_event", self._moved)
        self.mpl_connect("button_release_event", self._released)
        self.mpl_connect("axes_leave_event", lambda event: self.pointed(None))

    def recolour(self, colours: dict[str, str]) -> None:
        """Take other colours; what is drawn has the old ones until it is drawn anew."""
        self.colours = colours
        self.figure.set_facecolor(colours["paper"])
        self.axes.set_facecolor(colours["paper"])
        self.draw_idle()

    def empty(self) -> None:
        """Show nothing."""
        self.clear("", "").set_axis_off()
        self.draw_idle()

    def clear(self, below: str, beside: str) -> Any:
        """Empty axes with their names and colours; gives them."""
        axes, c = self.axes, self.colours
        axes.clear()
        axes.set_axis_on()
        self._mark = self._pin = None
        axes.set_facecolor(c["paper"])
        axes.grid(True, color=c["faint"], linewidth=0.8)
        axes.set_axisbelow(True)
        axes.tick_params(colors=c["soft"], labelsize=8)
        for spine in axes.spines.values():
            spine.set_color(c["soft"])
        axes.set_xlabel(below, color=c["soft"], fontsize=9)
        axes.set_ylabel(beside, color=c["soft"], fontsize=9)
        axes.callbacks.connect("xlim_changed", self._limits)
        return axes

    def legend(self) -> None:
        """Legend above the axes, where it covers nothing."""
        handles, labels = self.axes.get_legend_handles_labels()
        if not handles:
            return
        columns = max(1, min(len(handles), self.width() // ENTRY))
        made = self.axes.legend(
            handles,
            labels,
            fontsize=8,
            ncols=columns,
            loc="lower left",
            bbox_to_anchor=(0, 1),
            frameon=False,
            borderpad=0.2,
        )
        for text in made.get_texts():
            text.set_color(self.colours["ink"])

    def along(self, plot: Along) -> None:
        """Deviations along the contour."""
        shown = unit()
        below = translate("Millcorr", "arc length s, {}").format(shown.name)
        axes = self.clear(below, translate("Millcorr", "deviation, {}").format(shown.fine))
        _count_in(axes.xaxis, shown.mm)
        _count_in(axes.yaxis, shown.fine_mm / MM.fine_mm)
        c = self.colours
        size = 6 if len(plot.rows) < 1000 else 2
        told = translate("Millcorr", "uncertainty, k = {:g}").format(plot.coverage)
        for course in plot.courses:
            axes.fill_between(course.x, course.whole_low, course.whole_high, color=c["ink"], alpha=0.08, linewidth=0)
            axes.fill_between(course.x, course.low, course.high, color=c["ink"], alpha=0.16, linewidth=0, label=told)
            told = ""
        x = plot.x[plot.rows]
        axes.scatter(x, plot.raw[plot.rows], s=size, color=c["raw"], label=translate("Millcorr", "measured"), zorder=2)
        expected = translate("Millcorr", "expected next")
        axes.scatter(x, plot.predicted[plot.rows], s=size, color=c["predicted"], label=expected, zorder=2)
        looks = {
            False: (c["ink"], "-", translate("Millcorr", "determined part")),
            True: (c["undercut"], ":", translate("Millcorr", "no points near")),
        }
        for course in plot.courses:
            colour, line, told = looks[course.bare]
            axes.plot(course.x, course.value, color=colour, linestyle=line, linewidth=1.6, label=told, zorder=3)
            looks[course.bare] = colour, line, ""
        far = plot.outliers
        if len(far):
            # They do not set the scale: those beyond it stand at its edge.
            low, high = axes.get_ylim()
            told = translate("Millcorr", "outlier")
            place = plot.raw[far].clip(low, high)
            cross = {"marker": "x", "color": c["undercut"], "clip_on": False}
            axes.scatter(plot.x[far], place, s=40, label=told, zorder=4, **cross)
            axes.set_ylim(low, high)
        axes.axhline(0, color=c["soft"], linewidth=1)
        for corner in plot.corners:
            axes.axvline(corner, color=c["soft"], linewidth=0.8, linestyle=":")
        for start in plot.starts[1:]:
            axes.axvline(start, color=c["soft"], linewidth=1)
        self.legend()
        self.show_range(0.0, plot.total)

    def distribution(self, plot: Distribution) -> None:
        """Histogram of the deviations."""
        shown = unit()
        axes = self.clear(translate("Millcorr", "deviation, {}").format(shown.fine), translate("Millcorr", "points"))
        _count_in(axes.xaxis, shown.fine_mm / MM.fine_mm)
        c = self.colours
        for counts, colour, name in (
            (plot.before, c["raw"], translate("Millcorr", "measured")),
            (plot.predicted, c["predicted"], translate("Millcorr", "expected next")),
        ):
            axes.stairs(counts, plot.edges, fill=True, color=colour, alpha=0.45, label=name)
        if len(plot.bell):
            name = translate("Millcorr", "normal law of the scatter")
            axes.plot(plot.bell_x, plot.bell, color=c["ink"], linewidth=1.2, linestyle="--", label=name)
        axes.axvline(0, color=c["soft"], linewidth=1)
        self.legend()
        self.draw_idle()

    def history(self, plot: Series) -> None:
        """Parts of a series."""
        shown = unit()
        axes = self.clear(translate("Millcorr", "part"), translate("Millcorr", "deviation, {}").format(shown.fine))
        _count_in(axes.yaxis, shown.fine_mm / MM.fine_mm)
        c = self.colours
        name = translate("Millcorr", "range of the points")
        axes.vlines(plot.part, plot.low, plot.high, color=c["raw"], linewidth=2, label=name)
        name = translate("Millcorr", "mean and standard deviation")
        axes.errorbar(
            plot.part, plot.mean, plot.std, fmt="o-", color=c["predicted"], markersize=4, capsize=3, label=name
        )
        for values, look, name in (
            (plot.form, {"color": c["excess"], "marker": "s"}, translate("Millcorr", "form, root mean square")),
            (plot.smoothed, {"color": c["ink"]}, translate("Millcorr", "smoothed, largest")),
        ):
            if isfinite(values).any():
                axes.plot(plot.part, values, linewidth=1.2, markersize=4, label=name, **look)
        name = translate("Millcorr", "limits")
        for sign in (1.0, -1.0):
            if isfinite(plot.limit).any():
                axes.plot(plot.part, sign * plot.limit, color=c["undercut"], linewidth=1.2, linestyle="--", label=name)
                name = ""
        axes.axhline(0, color=c["soft"], linewidth=1)
        name = translate("Millcorr", "program corrected")
        for part in plot.part[plot.corrected]:
            axes.axvline(part + 0.5, color=c["soft"], linewidth=0.8, linestyle=":", label=name)
            name = ""
        axes.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
        # As in the report: a few parts do not fill the axis.
        axes.set_xlim(plot.part.min() - 0.6, max(plot.part.max(), plot.part.min() + 9) + 0.6)
        self.legend()
        self.draw_idle()

    def mark(self, x: float | None) -> None:
        """An upright at a place; none where it is None."""
        if self._mark is None:
            if x is None:
                return
            self._mark = self.axes.axvline(x, color=self.colours["undercut"], linewidth=1.4)
        self._mark.set_visible(x is not None)
        if x is not None:
            self._mark.set_xdata([x, x])
        self.draw_idle()

    def pin(self, x: float | None) -> None:
        """A broad upright at a place that was picked, until another one is; none where it is None."""
        if self._pin is not None:
            self._pin.remove()
            self._pin = None
        if x is not None:
            self._pin = self.axes.axvline(x, color=self.colours["undercut"], linewidth=5, alpha=0.35, zorder=1)
        self.draw_idle()

    def show_range(self, low: float, high: float) -> None:
        """Show a part of the axis; nobody is told."""
        self._told = True
        self.axes.set_xlim(low, high)
        self._told = False
        self.draw_idle()

    @property
    def shown_range(self) -> tuple[float, float]:
        """Part of the axis that is shown."""
        low, high = self.axes.get_xlim()
        return float(low), float(high)

    def _limits(self, axes: Any) -> None:
        if not self._told:
            self.zoomed(*self.shown_range)

    def _released(self, event: Any) -> None:
        # While the toolbar pans or zooms, a click is none.
        if event.button == 1 and event.inaxes is self.axes and not self.widgetlock.locked():
            self.clicked(float(event.xdata))

    def _moved(self, event: Any) -> None:
        self.pointed(event.xdata if event.inaxes is self.axes else None)


class _Ticks(MaxNLocator):
    """Ticks at round numbers of another unit than that of the data.

    Parameters
    ----------
    size : float
        Of that unit, in the data's.
    """

    def __init__(self, size: float) -> None:
        super().__init__(nbins="auto", steps=[1, 2, 2.5, 5, 10])
        self._size = size

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the ticks, in the data's unit."""
        return self._size * super().tick_values(vmin / self._size, vmax / self._size)


def _count_in(axis: Any, size: float) -> None:
    """Let an axis count in a unit of a size, in the data's."""
    if size != 1.0:
        axis.set_major_locator(_Ticks(size))
        axis.set_major_formatter(FuncFormatter(lambda at, _: f"{round(at / size, 9):z.6g}".replace("-", "\u2212")))


def toolbar(canvas: Canvas, parent: Any) -> Any:
    """The toolbar of matplotlib: back, pan, zoom, save."""
    made = NavigationToolbar2QT(canvas, parent, coordinates=False)
    made.setObjectName("PlotTools")
    made.setIconSize(QtCore.QSize(18, 18))
    made.setSizePolicy(QtWidgets.QSizePolicy.Policy.Maximum, QtWidgets.QSizePolicy.Policy.Fixed)
    return made
