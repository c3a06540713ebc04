# SPDX-License-Identifier: LGPL-2.1-or-later
"""A coloured surface in the 3-D view."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from millcorr.report.picture.wall import Wall

from .line_set import rows_as_tuples

Faces = tuple[list[Any], list[int], list[int]]
"""Vertices, colours and indices in the form that the scene graph takes fastest."""

LIGHT = np.array([-0.6, -0.8, 0.0])
"""Direction from which light falls, as the front of FreeCAD's isometric view has it."""

SHADE = 0.3
"""Share of its brightness that a wall turned away from the light lacks: its shape is seen, and its colour."""


def faces_of(wall: Wall) -> Faces:
    """A surface for the scene graph; in a thread where it is large."""
    return (
        rows_as_tuples(wall.vertices),
        _shaded(wall).tolist(),
        wall.index.tolist(),
    )


def _shaded(wall: Wall) -> Any:
    """Colours 0xRRGGBBAA of a surface that light falls on from one side, (m,).

    Not by the view's light: FreeCAD adds the colour of the selection to all that is lit, and none could be read then.
    """
    share = 1.0 - SHADE * (1.0 - wall.normals @ LIGHT) / 2.0
    parts = [np.round(((wall.colours >> bits) & 255) * share).astype(np.uint32) << bits for bits in (24, 16, 8)]
    return parts[0] | parts[1] | parts[2] | np.uint32(255)


class FaceSet:
    """A node that draws a surface, seen from both sides, in front of what lies in the same place."""

    def __init__(self) -> None:
        self.node = coin.SoSeparator()
        pick, hints, offset = coin.SoPickStyle(), coin.SoShapeHints(), coin.SoPolygonOffset()
        # FreeCAD would look through all faces whenever the mouse moves.
        pick.style = coin.SoPickStyle.UNPICKABLE
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        hints.faceType = coin.SoShapeHints.CONVEX
        # The part's own face is there, too.
        offset.factor, offset.units = -2.0, -2.0
        style, light = coin.SoDrawStyle(), coin.SoLightModel()
        style.style = coin.SoDrawStyle.FILLED
        light.model = coin.SoLightModel.BASE_COLOR
        self.faces = coin.SoIndexedFaceSet()
        drawn = coin.SoVertexProperty()
        drawn.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        self.faces.vertexProperty = drawn
        for child in (pick, hints, offset, style, light, self.faces):
            self.node.addChild(child)

    def fill(self, faces: Faces) -> None:
        """Draw a surface in place of the one before."""
        vertices, colours, index = faces
        drawn = self.faces.vertexProperty.getValue()
        fields = (drawn.vertex, drawn.orderedRGBA, self.faces.coordIndex)
        for field, numbers in zip(fields, (vertices, colours, index), strict=True):
            field.setNum(len(numbers))
            if numbers:
                field.setValues(0, len(numbers), numbers)
