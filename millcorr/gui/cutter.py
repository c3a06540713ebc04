# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter in the 3-D view, to be moved along."""

from __future__ import annotations

from typing import Any

from pivy import coin

from .layer import Layer, scene_of


class Cutter(Layer):
    """A cylinder that stands on its tip; where the document has no view nothing is drawn.

    Parameters
    ----------
    document : FreeCAD document
    """

    def __init__(self, document: Any) -> None:
        super().__init__()
        group = coin.SoSeparator()
        look, upright, lift, pick = coin.SoMaterial(), coin.SoRotationXYZ(), coin.SoTranslation(), coin.SoPickStyle()
        look.diffuseColor = (0.85, 0.7, 0.1)
        look.transparency = 0.4
        pick.style = coin.SoPickStyle.UNPICKABLE
        upright.axis, upright.angle = coin.SoRotationXYZ.X, 1.5707963267948966
        self._place, self._body, self._lift = coin.SoTranslation(), coin.SoCylinder(), lift
        # Coin's cylinder lies along Y about its middle; ours stands along Z on its end.
        for child in (pick, look, self._place, lift, upright, self._body):
            group.addChild(child)
        self.node.addChild(group)
        self.hang(scene_of(document))

    def size(self, radius: float, height: float) -> None:
        """Size in mm."""
        self._body.radius, self._body.height = radius, height
        self._lift.translation = (0.0, 0.0, height / 2)

    def move(self, x: float, y: float, z: float) -> None:
        """Place of the tip's centre in mm."""
        self._place.translation = (x, y, z)
        self.unhide()

    @property
    def place(self) -> tuple[float, float, float]:
        """Where it stands."""
        where = self._place.translation.getValue()
        return float(where[0]), float(where[1]), float(where[2])
