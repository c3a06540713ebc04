# SPDX-License-Identifier: LGPL-2.1-or-later
"""How millcorr's objects look in the tree; they draw nothing of their own."""

from __future__ import annotations

from typing import Any

from millcorr.app.views import MAKERS

from .icons import icon


class View:
    """View provider of one kind of object; subclasses say which icon and which children."""

    icon_name = "Millcorr"

    def __init__(self, vobj: Any) -> None:
        self.Object = vobj.Object
        vobj.Proxy = self

    def attach(self, vobj: Any) -> None:
        """Remember the object; called on creation and on restore."""
        self.Object = vobj.Object

    def getIcon(self) -> str:
        """Path of the icon."""
        return icon(self.icon_name)

    def claimChildren(self) -> list[Any]:
        """Objects shown below this one in the tree; changes nothing."""
        return []

    def dumps(self) -> None:
        """Nothing is stored."""
        return None

    def loads(self, state: Any) -> None:
        """Nothing is stored."""
        return None

    __getstate__ = dumps
    __setstate__ = loads


class MeasurementView(View):
    """A measurement."""

    icon_name = "Millcorr_Measurement"


class DressupView(View):
    """A dressup, with the operation below it."""

    icon_name = "Millcorr_Dressup"

    def claimChildren(self) -> list[Any]:
        """The operation that is corrected."""
        base = self.Object.Base
        return [] if base is None else [base]

    def onDelete(self, vobj: Any, subelements: Any = None) -> bool:
        """Give the operation its place in the job back."""
        return bool(vobj.Object.Proxy.onDelete(vobj.Object, subelements))


class ProfileView(View):
    """A compensated profile."""

    icon_name = "Millcorr_Profile"

    def getDisplayModes(self, vobj: Any) -> list[str]:
        """No modes but those of the shape."""
        return []

    def getDefaultDisplayMode(self) -> str:
        """Edges only: the profile is a wire."""
        return "Wireframe"

    def setDisplayMode(self, mode: str) -> str:
        """Modes are FreeCAD's own."""
        return mode


MAKERS.update(measurement=MeasurementView, dressup=DressupView, profile=ProfileView)
