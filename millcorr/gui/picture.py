# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction in the 3-D view: the overlay's arrays in scene-graph nodes, a line set for each part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCADGui
from pivy import coin

from millcorr.pipeline import Result
from millcorr.scene import correction as overlay
from millcorr.scene.correction import Look, Overlay

from .legend import Legend

PARTS: dict[str, tuple[tuple[str, float, int], ...]] = {
    "Band": (("band", 1.0, 0xFFFF),),
    "Profiles": (("nominal", 2.0, 0xFFFF), ("compensated", 2.0, 0xFFFF)),
    "Paths": (("before", 1.0, 0xFFFF), ("after", 2.0, 0xFFFF)),
    "Whiskers": (("whiskers", 2.0, 0xFFFF),),
    "RejectedPoints": (("rejected", 3.0, 0xFFFF),),
}
"""For each switch the overlay's lines, with their width in pixels and dash pattern, in the order of drawing."""

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
    lists : dict of str to tuple of lists
        Vertices, colours and indices of each of the overlay's lines: pivy takes lists ten times faster than arrays.
    """

    result: Result
    overlay: Overlay
    look: Look
    lists: dict[str, tuple[list[Any], list[int], list[int]]]


def draw(result: Result, look: Look) -> Drawn:
    """Everything about a picture that needs no scene graph, for a thread beside the window."""
    drawn = overlay.overlay_of(result, look)
    lines = {name: getattr(drawn, name) for rows in PARTS.values() for name, _, _ in rows}
    lists = {k: (v.vertices.tolist(), v.colours.tolist(), v.index.tolist()) for k, v in lines.items()}
    return Drawn(result, drawn, look, lists)


def look_of(values: Any) -> Look:
    """How to draw, from the properties of a view or of a draft."""
    band = values.ToleranceBand
    return Look(float(values.Magnification), float(getattr(band, "Value", band)))


def view_of(document: Any) -> Any:
    """A 3-D view of a document, the active one if it is one; None where there is none."""
    window = FreeCADGui.getDocument(document.Name)
    views = window.mdiViewsOfType("Gui::View3DInventor")
    active = window.ActiveView
    return active if any(view == active for view in views) else (views or [None])[0]


def remove(view: Any, picture: Picture) -> None:
    """Take a picture out of a view; nothing where the view was closed."""
    try:
        view.getSceneGraph().removeChild(picture.node)
    except RuntimeError:
        pass


class Picture:
    """Nodes of one overlay, under one switch."""

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        self.node.setName("MillcorrPicture")
        self.node.whichChild = coin.SO_SWITCH_NONE
        # Drawn last and over everything: undercut lies inside the part.
        front = coin.SoAnnotation()
        self.node.addChild(front)
        light, pick = coin.SoLightModel(), coin.SoPickStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        # FreeCAD must not look through all whiskers whenever the mouse moves.
        pick.style = coin.SoPickStyle.UNPICKABLE
        front.addChild(light)
        front.addChild(pick)
        self._switches: dict[str, Any] = {}
        self._lines: dict[str, tuple[Any, Any]] = {}
        for part, rows in PARTS.items():
            switch = self._switches[part] = coin.SoSwitch()
            switch.whichChild = coin.SO_SWITCH_ALL
            front.addChild(switch)
            for name, width, pattern in rows:
                switch.addChild(self._line_set(name, width, pattern))
        self.legend = Legend()
        self._switches["Legend"] = self.legend.node
        self.node.addChild(self.legend.node)
        self._searched = {name: self._alone(name) for name in ("rejected", "whiskers")}
        self.drawn: Drawn | None = None

    def _line_set(self, name: str, width: float, pattern: int) -> Any:
        group, style = coin.SoSeparator(), coin.SoDrawStyle()
        style.lineWidth = width
        style.linePattern = pattern
        vertices, lines = coin.SoVertexProperty(), coin.SoIndexedLineSet()
        vertices.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        lines.vertexProperty = vertices
        for node in (style, lines):
            group.addChild(node)
        self._lines[name] = (vertices, lines)
        return group

    def _alone(self, name: str) -> Any:
        """A graph of one line set and a place for a camera, to search under the mouse."""
        root = coin.SoSeparator()
        root.addChild(coin.SoOrthographicCamera())
        root.addChild(self._lines[name][1])
        return root

    def fill(self, drawn: Drawn, values: Any) -> None:
        """Show a correction in place of the one before, and those parts of it that the values ask for."""
        self.drawn = drawn
        for name, (vertices, lines) in self._lines.items():
            for field, numbers in zip(
                (vertices.vertex, vertices.orderedRGBA, lines.coordIndex), drawn.lists[name], strict=True
            ):
                field.setNum(len(numbers))
                if numbers:
                    field.setValues(0, len(numbers), numbers)
        self.choose(values)
        self.node.whichChild = coin.SO_SWITCH_ALL

    def unhide(self) -> None:
        """Show again what was hidden."""
        self.node.whichChild = coin.SO_SWITCH_ALL

    def hide(self) -> None:
        """Show nothing."""
        self.node.whichChild = coin.SO_SWITCH_NONE

    @property
    def shown(self) -> bool:
        """Whether anything is shown."""
        return bool(self.node.whichChild.getValue() == coin.SO_SWITCH_ALL)

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
