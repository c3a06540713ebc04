# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction in the 3-D view: the overlay's arrays in scene-graph nodes, a line set for each part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pivy import coin

from millcorr.pipeline import Result
from millcorr.scene import correction as overlay
from millcorr.scene.correction import Look, Overlay

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
    """

    result: Result
    overlay: Overlay
    look: Look
    lists: dict[str, Lists]


def draw(result: Result, look: Look) -> Drawn:
    """Everything about a picture that needs no scene graph, for a thread beside the window."""
    drawn = overlay.overlay_of(result, look)
    lists = {name: lists_of(getattr(drawn, name)) for rows in PARTS.values() for name, *_ in rows}
    return Drawn(result, drawn, look, lists)


def look_of(values: Any) -> Look:
    """How to draw, from the properties of a view or of a draft."""
    band = values.ToleranceBand
    return Look(float(values.Magnification), float(getattr(band, "Value", band)))


class Picture(Layer):
    """One overlay and its legend."""

    def __init__(self) -> None:
        super().__init__()
        front = over_everything()
        self.node.addChild(front)
        self._switches: dict[str, Any] = {}
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
        self._searched = {name: self._alone(name) for name in ("rejected", "whiskers")}
        self.drawn: Drawn | None = None

    def _alone(self, name: str) -> Any:
        """A graph of one line set and a place for a camera, to search under the mouse."""
        root = coin.SoSeparator()
        root.addChild(coin.SoOrthographicCamera())
        root.addChild(self._lines[name].lines)
        return root

    def fill(self, drawn: Drawn, values: Any) -> None:
        """Show a correction in place of the one before, and those parts of it that the values ask for."""
        self.drawn = drawn
        for name, lines in self._lines.items():
            lines.fill(drawn.lists[name])
        self.choose(values)
        self.unhide()

    def choose(self, values: Any) -> None:
        """Show the parts that the properties of a view or of a draft ask for."""
        for part, switch in self._switches.items():
            switch.whichChild = coin.SO_SWITCH_ALL if getattr(values, part) else coin.SO_SWITCH_NONE
        if self.drawn is not None:
            self.legend.fill(self.drawn.overlay, self.drawn.look, [part for part in PARTS if getattr(values, part)])

    def text_at(self, view: Any, x: int, y: int) -> str:
        """What is drawn at a pixel of a view, counted from its lower left; empty where nothing is."""
        if self.drawn is None or not self.shown:
            return ""
        result = self.drawn.result
        for name, switch in (("rejected", "RejectedPoints"), ("whiskers", "Whiskers")):
            if self._switches[switch].whichChild.getValue() != coin.SO_SWITCH_ALL:
                continue
            number = _polyline_at(self._searched[name], view, x, y)
            if number is not None and name == "rejected":
                return overlay.rejected_text(result, number)
            if number is not None:
                return overlay.whisker_text(result, int(self.drawn.overlay.rows[number]))
        return ""


def _polyline_at(root: Any, view: Any, x: int, y: int) -> int | None:
    """Number of the polyline nearest to the viewer at a pixel."""
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
        nearest = int(coin.cast(picked.getDetail(), "SoLineDetail").getLineIndex())
    return nearest
