# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coloured polylines in the 3-D view, beside everything that belongs to the document."""

from __future__ import annotations

from typing import Any

from pivy import coin

from millcorr.scene.correction import Lines

from .picture import view_of


class LineSet:
    """Polylines drawn over everything in a view of a document; where it has none nothing is drawn.

    Parameters
    ----------
    document : FreeCAD document
    width : float
        Pixels.
    """

    def __init__(self, document: Any, width: float = 2.0) -> None:
        self.node = coin.SoSwitch()
        self.node.whichChild = coin.SO_SWITCH_NONE
        front = coin.SoAnnotation()
        light, pick, style = coin.SoLightModel(), coin.SoPickStyle(), coin.SoDrawStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        pick.style = coin.SoPickStyle.UNPICKABLE
        style.lineWidth = width
        self._vertices, self._lines = coin.SoVertexProperty(), coin.SoIndexedLineSet()
        self._vertices.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        self._lines.vertexProperty = self._vertices
        for child in (light, pick, style, self._lines):
            front.addChild(child)
        self.node.addChild(front)
        # The root lives as long as it is held here; the view may be half gone when this is removed.
        view = view_of(document)
        self._root: Any = None if view is None else view.getSceneGraph()
        if self._root is not None:
            self._root.addChild(self.node)

    def fill(self, drawn: Lines) -> None:
        """Show polylines in place of those before."""
        # Lists, not arrays: pivy takes them ten times faster.
        for field, values in (
            (self._vertices.vertex, drawn.vertices),
            (self._vertices.orderedRGBA, drawn.colours),
            (self._lines.coordIndex, drawn.index),
        ):
            field.setNum(len(values))
            if len(values):
                field.setValues(0, len(values), values.tolist())
        self.node.whichChild = coin.SO_SWITCH_ALL

    def hide(self) -> None:
        """Show nothing."""
        self.node.whichChild = coin.SO_SWITCH_NONE

    @property
    def shown(self) -> bool:
        """Whether anything is shown."""
        return bool(self.node.whichChild.getValue() == coin.SO_SWITCH_ALL)

    def remove(self) -> None:
        """Take it out of the view."""
        self.hide()
        if self._root is not None:
            self._root.removeChild(self.node)
            self._root = None
