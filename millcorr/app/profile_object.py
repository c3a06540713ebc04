# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compensated profile as a FreeCAD shape, for any operation to use."""

from __future__ import annotations

from typing import Any

import Part

from millcorr.errors import UsageError

from . import convert, correction, views
from .properties import QT_TRANSLATE_NOOP, READ_ONLY, Property, complete, store

_text = QT_TRANSLATE_NOOP
PROPERTIES = (
    Property(
        "Link",
        "Correction",
        "Profile",
        _text("App::Property", "The dressup whose compensated profile this is"),
    ),
    Property(
        "Enumeration",
        "Shown",
        "Profile",
        _text("App::Property", "The profile to cut so that the part comes out right, or the nominal one"),
        ("compensated", "nominal"),
    ),
    Property("Distance", "Height", "Profile", _text("App::Property", "Z of the profile"), 0.0),
    Property("Integer", "Degree", "Result", _text("App::Property", "Highest degree"), 0, READ_ONLY),
    Property("Integer", "Poles", "Result", _text("App::Property", "Number of poles"), 0, READ_ONLY),
    Property("Length", "ContourLength", "Result", _text("App::Property", "Length"), 0.0, READ_ONLY),
)


class ProfileObject:
    """Proxy of the compensated profile."""

    def __init__(self, obj: Any) -> None:
        complete(obj, PROPERTIES)
        obj.Proxy = self

    def onDocumentRestored(self, obj: Any) -> None:
        """Add the properties that an earlier version did not have."""
        complete(obj, PROPERTIES)
        views.attach(obj, "profile")

    def execute(self, obj: Any) -> None:
        """Make the shape; on any failure it is empty and the object is invalid."""
        obj.Shape = Part.Shape()
        for name in ("Degree", "Poles", "ContourLength"):
            store(obj, name, 0)
        if obj.Correction is None:
            raise UsageError(f"{obj.Label}: the profile has no dressup")
        result = correction.correct(obj.Correction).result
        profile = result.compensated if obj.Shown == "compensated" else result.nominal
        obj.Shape = convert.shape_of_profile(profile, obj.Height.Value)
        curves = [c for contour in profile.contours for c in contour.curves]
        store(obj, "Degree", max(c.degree for c in curves))
        store(obj, "Poles", sum(len(c.poles) for c in curves))
        store(obj, "ContourLength", float(profile.total.sum()))

    def dumps(self) -> None:
        """Nothing but properties is stored."""
        return None

    def loads(self, state: Any) -> None:
        """Nothing but properties is stored."""
        return None

    __getstate__ = dumps
    __setstate__ = loads


def create(dressup: Any) -> Any:
    """New compensated profile of a dressup.

    Parameters
    ----------
    dressup : document object

    Returns
    -------
    document object
        Not yet recomputed.
    """
    obj = dressup.Document.addObject("Part::FeaturePython", "MillcorrProfile")
    ProfileObject(obj)
    obj.Correction = dressup
    obj.Label = f"{dressup.Label} profile"
    views.attach(obj, "profile")
    return obj
