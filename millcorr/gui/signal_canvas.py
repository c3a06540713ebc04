# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals over time, one above the other, with an upright that runs along; imported only where matplotlib is there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure

from millcorr.app.text import translate
from millcorr.report.picture.simulation import Trace

from .qt import QtCore


class SignalCanvas(FigureCanvasQTAgg):
    """A figure with axes for each signal.

    Parameters
    ----------
    colours : mapping of str to str
        By role, as `millcorr.report.plots.COLOURS` has them.
    sought : callable
        Gets the time in s that is clicked or dragged to.
    """

    def __init__(self, colours: dict[str, str], sought: Callable[[float], None]) -> None:
        super().__init__(Figure(layout="constrained"))
        self.setMinimumSize(300, 260)
        self._sought = sought
        self._traces: Sequence[Trace] = ()
        self.recolour(colours)
        self._uprights: list[Any] = []
        self._still: Any = None
        self._time = 0.0
        self.mpl_connect("draw_event", self._drawn)
        self.mpl_connect("button_press_event", self._seek)
        self.mpl_connect("motion_notify_event", self._seek)

    def sizeHint(self) -> Any:
        """As much as beside a 3-D view; matplotlib asks for its own figure's size."""
        return QtCore.QSize(380, 420)

    def recolour(self, colours: dict[str, str]) -> None:
        """Take other colours, and draw what is drawn in them."""
        self.colours = colours
        self.figure.set_facecolor(colours["paper"])
        if self._traces:
            self.fill(self._traces)

    def fill(self, traces: Sequence[Trace]) -> None:
        """Draw signals in place of those before."""
        self.figure.clear()
        self._traces = traces
        self._uprights, self._still = [], None
        c = self.colours
        rows = self.figure.subplots(len(traces), 1, sharex=True)
        for axes, trace in zip(rows, traces, strict=True):
            axes.set_facecolor(c["paper"])
            axes.grid(True, color=c["faint"], linewidth=0.8)
            axes.tick_params(colors=c["soft"], labelsize=7)
            for spine in axes.spines.values():
                spine.set_color(c["soft"])
            axes.plot(trace.t, trace.value, color=c["ink"], linewidth=1.0)
            # Above, where there is room for a long word; beside, it is cut off.
            axes.set_title(
                f"{translate('Millcorr', trace.name)}, {trace.unit}", color=c["soft"], fontsize=8, loc="left", pad=2
            )
            axes.margins(x=0)
            self._uprights.append(axes.axvline(0, color=c["undercut"], linewidth=1.4, animated=True))
        rows[-1].set_xlabel(translate("Millcorr", "time, s"), color=c["soft"], fontsize=8)
        self.draw_idle()

    def show_time(self, time: float) -> None:
        """Move the uprights."""
        self._time = time
        if self._still is None:
            return
        # Only the uprights are drawn anew: the signals stay as they are.
        self.restore_region(self._still)
        self._draw_uprights()
        self.blit(self.figure.bbox)

    def _draw_uprights(self) -> None:
        for upright in self._uprights:
            upright.set_xdata([self._time, self._time])
            upright.axes.draw_artist(upright)

    def _drawn(self, event: Any) -> None:
        self._still = self.copy_from_bbox(self.figure.bbox)
        # Qt is painting already: what is drawn now comes to the screen with the rest.
        self._draw_uprights()

    def _seek(self, event: Any) -> None:
        if event.button == 1 and event.xdata is not None:
            self._sought(float(event.xdata))
