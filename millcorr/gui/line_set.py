# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coloured polylines in the 3-D view."""

from __future__ import annotations

from typing import Any

from pivy import coin

from millcorr.scene.correction import Lines

from .layer import Layer, over_everything, scene_of

AT_ONCE = 5000
"""So many rows of an array become a list in one call, during which the window cannot run."""

Lists = tuple[list[Any], list[int], list[int]]
"""Vertices, colours and indices in the form that the scene graph takes ten times faster than arrays."""


def lists_of(lines: Lines) -> Lists:
    """Polylines for the scene graph; in a thread where they are many."""
    vertices: list[Any] = []
    for at in range(0, len(lines.vertices), AT_ONCE):
        # Tuples: lists would be looked through again and again by the collector of garbage.
        vertices.extend(zip(*lines.vertices[at : at + AT_ONCE].T.tolist(), strict=True))
    return vertices, lines.colours.tolist(), lines.index.tolist()


class LineSet:
    """A node that draws polylines.

    Parameters
    ----------
    width : float
        Pixels.
    """

    def __init__(self, width: float = 2.0) -> None:
        self.node, style = coin.SoSeparator(), coin.SoDrawStyle()
        style.lineWidth = width
        self.lines, self._vertices = coin.SoIndexedLineSet(), coin.SoVertexProperty()
        self._vertices.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        self.lines.vertexProperty = self._vertices
        self.node.addChild(style)
        self.node.addChild(self.lines)

    def fill(self, lists: Lists) -> None:
        """Draw polylines in place of those before."""
        fields = (self._vertices.vertex, self._vertices.orderedRGBA, self.lines.coordIndex)
        for field, numbers in zip(fields, lists, strict=True):
            field.setNum(len(numbers))
            if numbers:
                field.setValues(0, len(numbers), numbers)


class LineLayer(Layer):
    """Polylines drawn over everything in a view of a document; where it has none nothing is drawn.

    Parameters
    ----------
    document : FreeCAD document
    width : float
        Pixels.
    """

    def __init__(self, document: Any, width: float = 2.0) -> None:
        super().__init__()
        self._set = LineSet(width)
        front = over_everything()
        front.addChild(self._set.node)
        self.node.addChild(front)
        self.hang(scene_of(document))

    def fill(self, lines: Lines) -> None:
        """Show polylines in place of those before."""
        self._set.fill(lists_of(lines))
        self.unhide()
