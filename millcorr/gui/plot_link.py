# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot and 3-D view linked: the camera follows the zoom of the plot, the plot the camera, and both the mouse."""

from __future__ import annotations

from typing import Any

from pivy import coin

from millcorr.report.picture import plots as plot_arrays

from .layer import view_of
from .qt import QtCore

LOOK = 150
"""The camera is looked at every so many milliseconds."""

REST = 60
"""Zooming and pointing count once they rest for so many milliseconds."""

SLACK = 1e-3
"""Changes of the camera smaller than this are none."""


class PlotLink(QtCore.QObject):
    """Links the plot of a dock to the view of its document.

    Parameters
    ----------
    plots : Plots
    """

    def __init__(self, plots: Any) -> None:
        super().__init__(plots)
        self._plots = plots
        self._view: Any = None
        self._callback: Any = None
        self._matrix: Any = None
        self._wanted: tuple[float, float] | None = None
        self._mouse: tuple[int, int] | None = None
        self._look = QtCore.QTimer(self)
        self._look.setInterval(LOOK)
        self._look.timeout.connect(self._follow_camera)
        self._rest = QtCore.QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST)
        self._rest.timeout.connect(self._rested)

    def start(self) -> None:
        """Begin, with the view of the document that is plotted."""
        self.stop()
        self._view = view_of(self._plots.obj.Document)
        if self._view is None or self._plots.pages["along"].canvas is None:
            return
        kind = coin.SoLocation2Event.getClassTypeId()
        self._callback = self._view.addEventCallbackPivy(kind, self._moved)
        self._matrix = self.matrix()
        self._look.start()

    def stop(self) -> None:
        """Link no more."""
        self._look.stop()
        self._rest.stop()
        if self._callback is not None:
            try:
                self._view.removeEventCallbackPivy(coin.SoLocation2Event.getClassTypeId(), self._callback)
            except RuntimeError:
                # The view was closed.
                pass
        self._callback = self._view = None

    def forget_view(self) -> None:
        """Link no more, with a view that is being closed: it must not be touched."""
        self._callback = self._view = None
        self.stop()

    def matrix(self) -> Any:
        """From the frame of the job to the view's, -1 to 1; None where the view was closed."""
        try:
            camera, region = self._view.getCameraNode(), self._region()
        except RuntimeError:
            self.stop()
            return None
        aspect = region.getViewportAspectRatio()
        volume = camera.getViewVolume(aspect)
        if aspect < 1:
            # As Coin does it: what fits is the width then.
            volume.scale(1.0 / aspect)
        return [list(row) for row in volume.getMatrix().getValue()]

    def _region(self) -> Any:
        return self._view.getViewer().getSoRenderManager().getViewportRegion()

    # From the plot to the view -----------------------------------------------------------------------

    def zoom_view(self, low: float, high: float) -> None:
        """Bring a part of the axis into view, once the zoom rests."""
        if self._view is not None and self._plots.linked.isChecked():
            self._wanted = (low, high)
            self._rest.start()

    def _rested(self) -> None:
        if self._wanted is not None and self._view is not None:
            low, high = (min(max(x, 0.0), self._plots.along.total) for x in self._wanted)
            self._wanted = None
            if high > low:
                self._frame(plot_arrays.stretch_points(self._plots.result, low, high))
        elif self._mouse is not None:
            self._tell()

    def _frame(self, points: Any) -> None:
        node, place, dots = coin.SoSeparator(), coin.SoCoordinate3(), coin.SoPointSet()
        place.point.setValues(0, len(points), points.tolist())
        node.addChild(place)
        node.addChild(dots)
        node.ref()
        self._view.getCameraNode().viewAll(node, self._region(), 1.2)
        node.unref()
        self._matrix = self.matrix()

    # From the view to the plot -----------------------------------------------------------------------

    def _follow_camera(self) -> None:
        matrix = self.matrix()
        if matrix is None or self._plots.result is None or not self._plots.linked.isChecked():
            return
        if _same(matrix, self._matrix):
            return
        self._matrix = matrix
        low, high = plot_arrays.seen(self._plots.result, self._plots.along, matrix)
        if high > low:
            self._plots.pages["along"].canvas.show_range(low, high)

    def _moved(self, callback: Any) -> None:
        place = callback.getEvent().getPosition()
        self._mouse = (int(place[0]), int(place[1]))
        if self._wanted is None:
            self._rest.start()

    def _tell(self) -> None:
        matrix = self.matrix()
        if matrix is None or self._mouse is None or not self._plots.linked.isChecked():
            return
        pixels = self._region().getViewportSizePixels()
        u, v = (2.0 * at / pixels[k] - 1.0 for k, at in enumerate(self._mouse))
        self._mouse = None
        self._plots.point_at(plot_arrays.place_under(self._plots.result, matrix, u, v))


def _same(a: Any, b: Any) -> bool:
    # Not the third column: near and far plane move whenever something is drawn.
    return b is not None and all(abs(r[k] - s[k]) < SLACK for r, s in zip(a, b, strict=True) for k in (0, 1, 3))
