# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compensated profile as a FreeCAD shape, for any operation to use, and the contour check's other shapes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import Part

from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.pipeline import Result
from millcorr.production import contour_check

from . import convert, correction, views
from .properties import QT_TRANSLATE_NOOP, READ_ONLY, Property, store
from .stored import Proxy
from .wording import shown_by_freecad

_text = QT_TRANSLATE_NOOP


def _path(result: Result, obj: Any) -> Any:
    return convert.shape_of_profile(contour_check.path_contours(result), obj.Height.Value)


def _vertices(points: Any) -> Any:
    return Part.Compound([Part.Vertex(*row) for row in points.tolist()])


def _measured(result: Result, obj: Any) -> Any:
    return _vertices(contour_check.touched_points(result).measured)


def _contact(result: Result, obj: Any) -> Any:
    points = contour_check.touched_points(result)
    return _vertices(np.column_stack([points.contact, points.measured[:, 2]]))


def _deviations(result: Result, obj: Any) -> Any:
    points = contour_check.touched_points(result)
    tips = points.foot + (obj.Magnification * points.error)[:, None] * points.normal
    z = points.measured[:, 2]
    ends = zip(np.column_stack([points.foot, z]).tolist(), np.column_stack([tips, z]).tolist(), strict=True)
    return Part.Compound([Part.makeLine(tuple(a), tuple(b)) for a, b in ends if a != b])


_SHAPES: dict[str, Callable[[Result, Any], Any]] = {
    "compensated": lambda result, obj: convert.shape_of_profile(result.compensated, obj.Height.Value),
    "nominal": lambda result, obj: convert.shape_of_profile(result.nominal, obj.Height.Value),
    "path": _path,
    "measured points": _measured,
    "contact points": _contact,
    "deviations": _deviations,
}
"""What can be shown, and the shape of it; the first is shown where nothing else is chosen."""

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
        _text(
            "App::Property",
            "The profile to cut so that the part comes out right, the nominal one, the operation's path along it, "
            "the points as measured, those on the surface, or the deviations as lines along the normal",
        ),
        tuple(_SHAPES),
    ),
    Property(
        "Float",
        "Magnification",
        "Profile",
        _text("App::Property", "So many times longer than they are the deviations are drawn"),
        500.0,
    ),
    Property("Distance", "Height", "Profile", _text("App::Property", "Z of the profile"), 0.0),
    Property("Integer", "Degree", "Result", _text("App::Property", "Highest degree"), 0, READ_ONLY),
    Property("Integer", "Poles", "Result", _text("App::Property", "Number of poles"), 0, READ_ONLY),
    Property("Length", "ContourLength", "Result", _text("App::Property", "Length"), 0.0, READ_ONLY),
)


class ProfileObject(Proxy):
    """Proxy of the compensated profile."""

    properties, view = PROPERTIES, "profile"

    def execute(self, obj: Any) -> None:
        """Make the shape; on any failure it is empty and the object is invalid."""
        obj.Shape = Part.Shape()
        for name in ("Degree", "Poles", "ContourLength"):
            store(obj, name, 0)
        if obj.Correction is None:
            raise UsageError(phrase("{}: the profile has no dressup", obj.Label))
        with shown_by_freecad():
            result = correction.correct(obj.Correction).result
        profile = result.compensated if obj.Shown == "compensated" else result.nominal
        obj.Shape = _SHAPES[obj.Shown](result, obj)
        curves = [c for contour in profile.contours for c in contour.curves]
        store(obj, "Degree", max(c.degree for c in curves))
        store(obj, "Poles", sum(len(c.poles) for c in curves))
        store(obj, "ContourLength", float(profile.total.sum()))


def create(dressup: Any, shown: str = "compensated") -> Any:
    """New compensated profile of a dressup.

    Parameters
    ----------
    dressup : document object
    shown : str
        A value of the property Shown.

    Returns
    -------
    document object
        Not yet recomputed.
    """
    obj = dressup.Document.addObject("Part::FeaturePython", "MillcorrProfile")
    ProfileObject(obj)
    obj.Correction = dressup
    obj.Shown = shown
    obj.Label = f"{dressup.Label} {'profile' if shown == 'compensated' else shown}"
    views.attach(obj, "profile")
    return obj
