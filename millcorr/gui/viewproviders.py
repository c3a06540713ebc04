# SPDX-License-Identifier: LGPL-2.1-or-later
"""How millcorr's objects look in the tree and in the 3-D view.

FreeCAD imports this when it starts: what computes and draws is imported when something is drawn.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

from millcorr.app.properties import READ_ONLY, SHOWN, complete, store
from millcorr.app.stored import NothingStored
from millcorr.app.views import MAKERS
from millcorr.errors import MillcorrError

from .icons import icon
from .preferences import LOOK
from .qt import QtCore


class View(NothingStored):
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

    def panel(self) -> Any:
        """Task panel that a double click opens; None where there is none."""
        return None

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the task panel; False where FreeCAD should do what it does."""
        from . import panel

        made = self.panel()
        if made is None:
            return False
        if not panel.show(made):
            made.reject()
        return True


class MeasurementView(View):
    """A measurement."""

    icon_name = "Millcorr_Measurement"


class DressupView(View):
    """A dressup, with the operation below it and, where its view says so, the picture of its correction."""

    icon_name = "Millcorr_Dressup"

    def attach(self, vobj: Any) -> None:
        """Add the properties of the picture; it is drawn when there is something to draw."""
        super().attach(vobj)
        from .picture_properties import PROPERTIES

        self._picture: Any = None
        self._hover: Any = None
        self._worker: Any = None
        self._timer: Any = None
        self._paused = False
        self._fresh = False
        complete(vobj, PROPERTIES)
        self._lock(vobj)

    def _lock(self, vobj: Any) -> None:
        """The magnification can be written where it is not chosen by itself."""
        vobj.setEditorMode("Magnification", READ_ONLY if vobj.AutomaticMagnification else SHOWN)

    def finishRestoring(self) -> None:
        """Take over what an earlier version called otherwise; FreeCAD calls it when all properties are there."""
        vobj = self.Object.ViewObject
        if "ToleranceBand" in vobj.PropertiesList:
            band = vobj.ToleranceBand.Value
            vobj.UpperLimit, vobj.LowerLimit = band, -band
            vobj.removeProperty("ToleranceBand")

    def getIcon(self) -> str:
        """Path of the icon, with a mark where something came up that the user does not know."""
        from millcorr.app import dressup

        known = hasattr(self.Object, "Noted")
        return icon("Millcorr_Doubt" if known and dressup.doubts_of(self.Object) else self.icon_name)

    def claimChildren(self) -> list[Any]:
        """The operation that is corrected."""
        base = self.Object.Base
        return [] if base is None else [base]

    def panel(self) -> Any:
        """Panel of the correction."""
        from . import dressup_panel

        return dressup_panel.edit(self.Object)

    def onDelete(self, vobj: Any, subelements: Any = None) -> bool:
        """Give the operation its place in the job back."""
        self._end_hover()
        return bool(vobj.Object.Proxy.onDelete(vobj.Object, subelements))

    # The picture -------------------------------------------------------------------------------------

    def onChanged(self, vobj: Any, name: str) -> None:
        """Draw anew when the view's properties ask for it."""
        automatic = getattr(vobj, "AutomaticMagnification", False)
        if name == "Magnification" and automatic:
            # It was chosen when the picture was made.
            return
        if name == "AutomaticMagnification" and "Magnification" in vobj.PropertiesList:
            self._lock(vobj)
        if name in ("ShowPicture", "Visibility", *LOOK):
            self._fresh &= name in ("ShowPicture", "Visibility")
            self.refresh_soon()
        elif self._picture is not None and name in vobj.PropertiesList and vobj.getGroupOfProperty(name) == "Picture":
            self._picture.choose(vobj)

    def updateData(self, obj: Any, name: str) -> None:
        """Draw anew when the path was computed anew."""
        if name == "Path":
            self._fresh = False
            self.refresh_soon()
        elif name in ("Warnings", "Noted"):
            obj.ViewObject.signalChangeIcon()

    def pause(self, paused: bool) -> None:
        """Show nothing while a panel shows its preview."""
        self._paused = paused
        self.refresh_soon()

    def take(self, made: Any) -> None:
        """Show a picture that a panel made of this very correction."""
        self._place(made)
        self._fresh = True
        self.refresh_soon()

    def _place(self, made: Any) -> None:
        if self._picture is not None:
            self._end_hover()
            self._picture.remove()
        self._picture = made
        made.hang(self.Object.ViewObject.RootNode)

    def refresh_soon(self) -> None:
        """Draw anew once FreeCAD is done with what it does now; several wishes are one."""
        if self._timer is None:
            self._timer = QtCore.QTimer()
            self._timer.setSingleShot(True)
            self._timer.setInterval(0)
            self._timer.timeout.connect(self._refresh)
        self._timer.start()

    def _wanted(self) -> bool:
        vobj = self.Object.ViewObject
        return bool(vobj.ShowPicture and vobj.Visibility and not self._paused and self.Object.Path.Commands)

    def _refresh(self) -> None:
        from millcorr.app import correction

        from . import picture
        from .worker import Worker

        try:
            wanted = self._wanted()
        except (ReferenceError, AttributeError):
            # The object was deleted in the meantime, or is being restored.
            return
        if not wanted:
            if self._worker is not None:
                self._worker.cancel()
            if self._picture is not None:
                self._picture.hide()
            self._end_hover()
            return
        if self._fresh:
            self._picture.choose(self.Object.ViewObject)
            self._picture.unhide()
            self._begin_hover()
            return
        if self._worker is None:
            self._worker = Worker(None, self._show, self._failed)
        try:
            finish, look = correction.prepared(self.Object), picture.look_of(self.Object.ViewObject)
            top = picture.top_of(self.Object)
        except MillcorrError as error:
            self._failed(error)
            return

        def function() -> Any:
            return picture.draw(finish().result, look, top)

        self._worker.start(function)

    def _failed(self, error: BaseException) -> None:
        from millcorr.app.wording import worded

        if self._picture is not None:
            self._picture.hide()
        self._end_hover()
        FreeCAD.Console.PrintWarning(f"{self.Object.Label}: {worded(error)}\n")

    def _show(self, drawn: Any) -> None:
        from .picture import Picture

        if self._picture is None:
            self._place(Picture())
        vobj = self.Object.ViewObject
        self._picture.fill(drawn, vobj)
        self._fresh = True
        if vobj.AutomaticMagnification:
            store(vobj, "Magnification", drawn.overlay.magnification)
        if self._wanted():
            self._begin_hover()
        else:
            self._picture.hide()

    def _begin_hover(self) -> None:
        from .hover import Hover
        from .layer import view_of

        view = view_of(self.Object.Document) if self._hover is None else None
        if view is not None:
            self._hover = Hover(view, self._picture, self._picked)

    def _picked(self, pick: Any) -> None:
        from . import plots

        FreeCAD.Console.PrintMessage(f"{self.Object.Label}: " + ", ".join(pick.text.splitlines()) + "\n")
        plots.pick(self.Object, pick.row, pick.index)

    def _end_hover(self) -> None:
        if self._hover is not None:
            self._hover.end()
            self._hover = None


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
