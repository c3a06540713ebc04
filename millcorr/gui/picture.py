# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction in the 3-D view: the overlay's arrays in scene-graph nodes, a line set for each part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from pivy import coin

from millcorr.app import compat
from millcorr.app.unit import unit
from millcorr.app.wording import worded
from millcorr.pipeline import Result
from millcorr.report.picture import correction as overlay
from millcorr.report.picture.correction import Overlay
from millcorr.report.picture.plots import row_near
from millcorr.report.picture.scale import Look
from millcorr.report.picture.wall import Wall, wall_of

from .face_set import Faces, FaceSet, faces_of
from .layer import Layer, over_everything
from .legend import Legend
from .line_set import LineSet, Lists, lists_of

PARTS: dict[str, tuple[tuple[str, float, bool], ...]] = {
    "Band": (("band", 1.0, False),),
    "Profiles": (("nominal", 2.0, True), ("compensated", 2.0, False)),
    "Paths": (("before", 1.0, False), ("after", 2.0, False)),
    "Whiskers": (("whiskers", 2.0, False),),
    "RejectedPoints": (("rejected", 3.0, True),),
}
"""For each switch the overlay's lines, with their width in pixels, and whether a light rim shows them on a dark
background, in the order of drawing."""

REACH = (7.0, 2.5, 1.0)
"""A line is picked within so many pixels; where there is one, the nearest: the search narrows."""


@dataclass(frozen=True, eq=False, slots=True)
class Drawn:
    """A correction as it is to be shown, in the form that the scene graph takes at once.

    Parameters
    ----------
    result : Result
    overlay : Overlay
    look : Look
    lists : dict of str to Lists
        Each of the overlay's lines.
    wall : Wall
    faces : Faces
        Those of the wall.
    """

    result: Result
    overlay: Overlay
    look: Look
    lists: dict[str, Lists]
    wall: Wall
    faces: Faces


@dataclass(frozen=True, slots=True)
class Pick:
    """What lies at a pixel.

    Parameters
    ----------
    text : str
        What it is; a line each.
    row : int
        Row of the deviations; -1 at a point that is left out.
    index : int
        Point of the measurement.
    """

    text: str
    row: int
    index: int


def draw(result: Result, look: Look, top: float | None = None) -> Drawn:
    """Everything about a picture that needs no scene graph, for a thread beside the window.

    Parameters
    ----------
    result : Result
    look : Look
    top : float, optional
        Height at which cutting began, as `top_of` gives it.
    """
    drawn = overlay.overlay_of(result, look)
    lists = {name: lists_of(getattr(drawn, name)) for rows in PARTS.values() for name, *_ in rows}
    wall = wall_of(result, drawn.scale, top)
    return Drawn(result, drawn, look, lists, wall, faces_of(wall))


def top_of(operation: Any) -> float | None:
    """Height in mm at which an operation, dressed up or not, begins to cut; None where it does not say."""
    depth = getattr(compat.bottom_operation(operation), "StartDepth", None)
    return None if depth is None else float(depth.Value)


def look_of(values: Any) -> Look:
    """How to draw, from the properties of a view or of a draft."""
    upper, lower = (getattr(limit, "Value", limit) for limit in (values.UpperLimit, values.LowerLimit))
    return Look(
        None if values.AutomaticMagnification else float(values.Magnification),
        float(lower),
        float(upper),
        str(values.MaterialLeft),
    )


class Picture(Layer):
    """One overlay and its legend."""

    def __init__(self) -> None:
        super().__init__()
        self._switches: dict[str, Any] = {}
        # Not over everything: what lies behind the part is hidden by it.
        wall = self._switches["Wall"] = coin.SoSwitch()
        self._wall = FaceSet()
        wall.addChild(self._wall.node)
        self.node.addChild(wall)
        front = over_everything()
        self.node.addChild(front)
        self._lines: dict[str, LineSet] = {}
        for part, rows in PARTS.items():
            switch = self._switches[part] = coin.SoSwitch()
            switch.whichChild = coin.SO_SWITCH_ALL
            front.addChild(switch)
            for name, width, halo in rows:
                self._lines[name] = LineSet(width, halo)
                switch.addChild(self._lines[name].node)
        self.legend = Legend()
        self._switches["Legend"] = self.legend.node
        self.node.addChild(self.legend.node)
        lines = {name: self._lines[name].lines for name in ("rejected", "whiskers")}
        self._searched = {name: _alone(node) for name, node in (lines | {"wall": self._wall.faces}).items()}
        self.drawn: Drawn | None = None

    def fill(self, drawn: Drawn, values: Any) -> None:
        """Show a correction in place of the one before, and those parts of it that the values ask for."""
        self.drawn = drawn
        for name, lines in self._lines.items():
            lines.fill(drawn.lists[name])
        self._wall.fill(drawn.faces)
        self.choose(values)
        self.unhide()

    def choose(self, values: Any) -> None:
        """Show the parts that the properties of a view or of a draft ask for."""
        for part, switch in self._switches.items():
            switch.whichChild = coin.SO_SWITCH_ALL if getattr(values, part) else coin.SO_SWITCH_NONE
        if self.drawn is not None:
            self.legend.fill(self.drawn, [part for part in ("Wall", *PARTS) if getattr(values, part)])

    def pick_at(self, view: Any, x: int, y: int) -> Pick | None:
        """What is drawn at a pixel of a view, counted from its lower left; None where nothing is."""
        if self.drawn is None or not self.shown:
            return None
        result, d = self.drawn.result, self.drawn.result.deviation
        for name, switch in (("rejected", "RejectedPoints"), ("whiskers", "Whiskers"), ("wall", "Wall")):
            if self._switches[switch].whichChild.getValue() != coin.SO_SWITCH_ALL:
                continue
            picked = _picked_at(self._searched[name], view, x, y)
            if picked is None:
                continue
            if name == "wall":
                row = row_near(result, np.array(picked.getPoint().getValue()))
            else:
                number = int(coin.cast(picked.getDetail(), "SoLineDetail").getLineIndex())
                if name == "rejected":
                    index = result.left_out[number].index
                    rows = np.flatnonzero(d.index == index)
                    text = worded(overlay.rejected_text(result, number, unit()))
                    return Pick(text, int(rows[0]) if len(rows) else -1, index)
                row = int(self.drawn.overlay.rows[number])
            return Pick(worded(overlay.whisker_text(result, row, unit())), row, int(d.index[row]))
        return None


def _alone(shape: Any) -> Any:
    """A graph of one shape and a place for a camera, to search under the mouse."""
    root = coin.SoSeparator()
    root.addChild(coin.SoOrthographicCamera())
    root.addChild(shape)
    return root


def _picked_at(root: Any, view: Any, x: int, y: int) -> Any:
    """What of a shape is nearest to a pixel and to the viewer there; None where nothing is near."""
    manager = view.getViewer().getSoRenderManager()
    root.replaceChild(0, view.getCameraNode())
    action = coin.SoRayPickAction(manager.getViewportRegion())
    action.setPoint(coin.SbVec2s(int(x), int(y)))
    nearest = None
    for radius in REACH:
        action.setRadius(radius)
        action.apply(root)
        picked = action.getPickedPoint()
        if picked is None:
            break
        nearest = picked.copy()
    return nearest
