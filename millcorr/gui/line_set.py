# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coloured polylines in the 3-D view."""

from __future__ import annotations

from typing import Any

from pivy import coin

from millcorr.report.picture.correction import Lines

from .layer import Layer, over_everything, scene_of

AT_ONCE = 5000
"""So many rows of an array become a list in one call, during which the window cannot run."""

Lists = tuple[list[Any], list[int], list[int]]
"""Vertices, colours and indices in the form that the scene graph takes ten times faster than arrays."""


def lists_of(lines: Lines) -> Lists:
    """Polylines for the scene graph; in a thread where they are many."""
    return rows_as_tuples(lines.vertices), lines.colours.tolist(), lines.index.tolist()


def rows_as_tuples(array: Any) -> list[Any]:
    """Rows of an array, (n, k), as tuples: lists are looked through again and again by the collector of garbage."""
    out: list[Any] = []
    for at in range(0, len(array), AT_ONCE):
        out.extend(zip(*array[at : at + AT_ONCE].T.tolist(), strict=True))
    return out


HALO, RIM = 0xF6F6F6FF, 1.0
"""Colour 0xRRGGBBAA of what is drawn about lines, and how far it stands out at each side, in pixels."""


class LineSet:
    """A node that draws polylines.

    Parameters
    ----------
    width : float
        Pixels.
    halo : bool
        Whether each line has a light rim: dark lines can be read on a dark background, too.
    """

    def __init__(self, width: float = 2.0, halo: bool = False) -> None:
        self.node = coin.SoSeparator()
        self._halo = self._add(width + 2 * RIM, coin.SoVertexProperty.OVERALL) if halo else None
        self.lines = self._add(width, coin.SoVertexProperty.PER_VERTEX_INDEXED)

    def _add(self, width: float, binding: int) -> Any:
        style, lines, vertices = coin.SoDrawStyle(), coin.SoIndexedLineSet(), coin.SoVertexProperty()
        style.lineWidth = width
        vertices.materialBinding = binding
        lines.vertexProperty = vertices
        self.node.addChild(style)
        self.node.addChild(lines)
        return lines

    def fill(self, lists: Lists) -> None:
        """Draw polylines in place of those before."""
        vertices, colours, index = lists
        if self._halo is not None:
            _put(self._halo, vertices, [HALO], index)
        _put(self.lines, vertices, colours, index)


def _put(lines: Any, vertices: list[Any], colours: list[int], index: list[int]) -> None:
    drawn = lines.vertexProperty.getValue()
    for field, numbers in ((drawn.vertex, vertices), (drawn.orderedRGBA, colours), (lines.coordIndex, index)):
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
        self._set = LineSet(width, halo=True)
        front = over_everything()
        front.addChild(self._set.node)
        self.node.addChild(front)
        self.hang(scene_of(document))

    def fill(self, lines: Lines) -> None:
        """Show polylines in place of those before."""
        self._set.fill(lists_of(lines))
        self.unhide()
