# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the Python part of every stored object has in common.

A document stores the module and the name of a proxy's class: those stay where they are, this base may move.
"""

from __future__ import annotations

from typing import Any, ClassVar

from . import views
from .properties import Property, complete


class NothingStored:
    """Base of what FreeCAD keeps with an object or its view: nothing but properties is stored."""

    def dumps(self) -> None:
        """Nothing."""

    def loads(self, state: Any) -> None:
        """Nothing."""

    __getstate__ = dumps
    __setstate__ = loads


class Proxy(NothingStored):
    """Python part of a document object, of which nothing but the properties is stored."""

    properties: ClassVar[tuple[Property, ...]]
    """Its properties."""

    view: ClassVar[str]
    """Key of its view in `views.MAKERS`."""

    def __init__(self, obj: Any) -> None:
        complete(obj, self.properties)
        obj.Proxy = self

    def onDocumentRestored(self, obj: Any) -> None:
        """Add the properties that an earlier version did not have, and the view where a window is new."""
        self.completed(obj, complete(obj, self.properties))
        if views.attach(obj, self.view):
            self.shown(obj)

    def completed(self, obj: Any, added: list[str]) -> None:
        """Called on restore with the names of properties that an earlier version did not have."""

    def shown(self, obj: Any) -> None:
        """Called where a restored object got a view."""
