# SPDX-License-Identifier: LGPL-2.1-or-later
"""Something that is drawn beside what belongs to the document: a switch of nodes, and where it hangs."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from pivy import coin


def view_of(document: Any) -> Any:
    """A 3-D view of a document, the active one if it is one; None where there is none."""
    window = FreeCADGui.getDocument(document.Name)
    views = window.mdiViewsOfType("Gui::View3DInventor")
    active = window.ActiveView
    return active if any(view == active for view in views) else (views or [None])[0]


def scene_of(document: Any) -> Any:
    """Root of what a 3-D view of a document draws; None where it has no view."""
    view = view_of(document)
    return None if view is None else view.getSceneGraph()


class Layer:
    """Nodes under one switch that is hung somewhere, shown and hidden; at first it hangs nowhere and is hidden."""

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        self.node.setName("MillcorrLayer")
        self.node.whichChild = coin.SO_SWITCH_NONE
        # The root lives as long as it is held here, the view may be closed in the meantime: it is never asked again.
        self._root: Any = None

    def hang(self, root: Any) -> None:
        """Hang it below a node, and nowhere else; where there is none it is not drawn."""
        self.remove()
        self._root = root
        if root is not None:
            root.addChild(self.node)

    def remove(self) -> None:
        """Take it away from where it hangs."""
        if self._root is not None:
            self._root.removeChild(self.node)
            self._root = None

    def unhide(self) -> None:
        """Show it."""
        self.node.whichChild = coin.SO_SWITCH_ALL

    def hide(self) -> None:
        """Show nothing."""
        self.node.whichChild = coin.SO_SWITCH_NONE

    @property
    def shown(self) -> bool:
        """Whether anything is shown."""
        return bool(self.node.whichChild.getValue() == coin.SO_SWITCH_ALL)


def over_everything() -> Any:
    """A group whose children are drawn last, in their own colours, and are never picked by FreeCAD.

    Undercut lies inside the part; and FreeCAD would look through all lines whenever the mouse moves.
    """
    front, light, pick = coin.SoAnnotation(), coin.SoLightModel(), coin.SoPickStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    pick.style = coin.SoPickStyle.UNPICKABLE
    front.addChild(light)
    front.addChild(pick)
    return front
