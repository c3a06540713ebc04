# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dressup: an operation of a job with its path corrected from a measured part."""

from __future__ import annotations

from datetime import datetime
from math import isfinite
from typing import Any

import Part
import Path

from millcorr.errors import InputError

from . import compat, correction, views
from .properties import HIDDEN, QT_TRANSLATE_NOOP, READ_ONLY, Property, complete, store

_text = QT_TRANSLATE_NOOP
PROPERTIES = (
    Property("Link", "Base", "Base", _text("App::Property", "The operation whose path is corrected")),
    Property(
        "Link",
        "Measurement",
        "Correction",
        _text("App::Property", "The measured part; without one the path is made exact and nothing is corrected"),
    ),
    Property(
        "LinkList",
        "FurtherParts",
        "Correction",
        _text("App::Property", "Measurements of further parts cut with the same path; deviations are averaged"),
        [],
    ),
    Property(
        "Link",
        "Nominal",
        "Correction",
        _text("App::Property", "Nominal profile; without one the operation's own geometry, or else its path"),
    ),
    Property(
        "Length",
        "ToolDiameter",
        "Correction",
        _text("App::Property", "Diameter of the tool; 0 takes it from the tool controller"),
        0.0,
    ),
    Property(
        "Enumeration",
        "Side",
        "Correction",
        _text("App::Property", "Side of the contour on which the tool runs, along its direction"),
        ("auto", "left", "right"),
    ),
    Property(
        "String",
        "Align",
        "Correction",
        _text(
            "App::Property",
            "Best fit of the measured points before comparing: none, shift, rigid, or some of x, y, turn joined by +",
        ),
        "none",
    ),
    Property(
        "StringList",
        "Accept",
        "Correction",
        _text("App::Property", "Findings about the measurement that are accepted by name"),
        [],
    ),
    Property(
        "String",
        "Filter",
        "Correction",
        _text(
            "App::Property",
            "What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto",
        ),
        "auto",
    ),
    Property(
        "Enumeration",
        "Method",
        "Correction",
        _text("App::Property", "How the path answers a deviation"),
        ("mirror", "transfer", "combined", "predicted"),
    ),
    Property(
        "FileIncluded",
        "Setup",
        "Correction",
        _text("App::Property", "TOML file with tool, material, machine and stock, kept in the document"),
    ),
    Property(
        "Length",
        "Iterate",
        "Correction",
        _text("App::Property", "Correct again in the model until the error to expect is at most this; 0: only once"),
        0.0,
    ),
    Property(
        "FloatList",
        "Depth",
        "Transfer function",
        _text("App::Property", "Depth in mm along the normal that the measured part was cut at; one, or one a part"),
        [],
    ),
    Property(
        "Length",
        "NextDepth",
        "Transfer function",
        _text("App::Property", "Depth that the corrected path will cut; 0: that of the measured part"),
        0.0,
    ),
    Property(
        "Enumeration",
        "DepthAlong",
        "Transfer function",
        _text("App::Property", "How deviations are taken: along the normal, or along one axis"),
        ("normal", "x", "y"),
    ),
    Property(
        "Enumeration",
        "TransferFunction",
        "Transfer function",
        _text("App::Property", "Smooth along the contour, one value, or one a point"),
        ("smooth", "one", "points"),
    ),
    Property(
        "FloatList",
        "Allowance",
        "Transfer function",
        _text("App::Property", "Stock in mm that the path of the measured part left on the nominal"),
        [],
    ),
    Property(
        "Length",
        "LeaveStock",
        "Correction",
        _text("App::Property", "Stock that the path leaves on the part: a first cut, before anything is measured"),
        0.0,
    ),
    Property("Float", "Gain", "Correction", _text("App::Property", "Share of the deviation taken back"), 1.0),
    Property(
        "Length",
        "Limit",
        "Correction",
        _text("App::Property", "Largest correction; a larger one is refused"),
        0.5,
    ),
    Property(
        "Length",
        "DeadBand",
        "Correction",
        _text("App::Property", "Deviations up to this are left alone"),
        0.0,
    ),
    Property(
        "Float",
        "UnmeasuredShare",
        "Correction",
        _text("App::Property", "Largest share of a contour without points near that is corrected all the same"),
        0.6,
    ),
    Property(
        "StringList",
        "Tools",
        "Correction",
        _text("App::Property", "Diameters of other tools of the path, each as 3=16 or ROUGH=16"),
        [],
    ),
    Property(
        "Bool",
        "KeepAllowance",
        "Correction",
        _text("App::Property", "Passes that rough along the contour are moved with it"),
        False,
    ),
    Property(
        "Length",
        "Tolerance",
        "Correction",
        _text("App::Property", "Largest distance of the path from the exact one"),
        0.001,
    ),
    Property(
        "Enumeration",
        "OutputMoves",
        "Correction",
        _text("App::Property", "Moves of the corrected path: as the operation's, only lines, or arcs"),
        ("keep", "lines", "arcs"),
    ),
    Property(
        "Enumeration",
        "CutterCompensation",
        "Correction",
        _text("App::Property", "What a path under G41 or G42 is: the contour itself, or the centre path"),
        ("contour", "wear"),
    ),
    Property("Distance", "DeviationMean", "Result", _text("App::Property", "Mean deviation"), 0.0, READ_ONLY),
    Property("Distance", "DeviationMin", "Result", _text("App::Property", "Least deviation"), 0.0, READ_ONLY),
    Property("Distance", "DeviationMax", "Result", _text("App::Property", "Greatest deviation"), 0.0, READ_ONLY),
    Property("Distance", "DeviationHeight", "Result", _text("App::Property", "Greatest less least"), 0.0, READ_ONLY),
    Property("Distance", "DeviationStd", "Result", _text("App::Property", "Standard deviation"), 0.0, READ_ONLY),
    Property(
        "Distance",
        "RandomStd",
        "Result",
        _text("App::Property", "Standard deviation of what the filter takes for scatter"),
        0.0,
        READ_ONLY,
    ),
    Property(
        "Distance",
        "LargestCorrection",
        "Result",
        _text("App::Property", "Largest correction"),
        0.0,
        READ_ONLY,
    ),
    Property(
        "Distance",
        "PathError",
        "Result",
        _text("App::Property", "Largest distance of the path from the exact offset of the compensated profile"),
        0.0,
        READ_ONLY,
    ),
    Property("Integer", "PointsUsed", "Result", _text("App::Property", "Points used"), 0, READ_ONLY),
    Property("Integer", "PointsRejected", "Result", _text("App::Property", "Points left out"), 0, READ_ONLY),
    Property("StringList", "Warnings", "Result", _text("App::Property", "What to know"), [], READ_ONLY),
    Property(
        "String",
        "Source",
        "Origin",
        _text("App::Property", "Measured file of this correction"),
        "",
        READ_ONLY,
    ),
    Property("String", "Digest", "Origin", _text("App::Property", "SHA-256 of that file"), "", READ_ONLY),
    Property("String", "Corrected", "Origin", _text("App::Property", "When the correction was made"), "", READ_ONLY),
    Property(
        "String",
        "Smoothed",
        "Origin",
        _text(
            "App::Property",
            "Deviation smoothed over the parts of a series, which is taken out in place of the measured one",
        ),
        "",
        HIDDEN,
    ),
    Property(
        "String",
        "CutPath",
        "Origin",
        _text("App::Property", "SHA-256 of the measurement, and of the operation's path when it came"),
        "",
        HIDDEN,
    ),
)

_RESULTS = tuple(
    row
    for row in PROPERTIES
    if row.group in ("Result", "Origin") and row.name not in ("Corrected", "Smoothed", "CutPath")
)


CHANGED = (
    "the path of {} is not the one the measured part was cut with: the difference between the two counts as an "
    "error of the machine; measure a part cut with the path as it is now"
)


class DressupMillcorr:
    """Proxy of the dressup."""

    def __init__(self, obj: Any) -> None:
        complete(obj, PROPERTIES)
        obj.Proxy = self

    def onDocumentRestored(self, obj: Any) -> None:
        """Add the properties that an earlier version did not have; the path stays as it was saved."""
        complete(obj, PROPERTIES)
        if views.attach(obj, "dressup"):
            job = compat.parent_job(obj)
            if job is not None:
                compat.give_views(job)
            obj.ViewObject.Visibility = True
            if obj.Base is not None:
                obj.Base.ViewObject.Visibility = False

    def execute(self, obj: Any) -> None:
        """Correct the path; on any failure the path is empty and the object is invalid."""
        # Emptied first: whatever goes wrong from here on, no uncorrected path can be posted.
        obj.Path = Path.Path()
        _clear(obj)
        _empty_profiles(obj)
        if obj.Base is None or not compat.is_active(obj.Base):
            return
        corrected = correction.correct(obj)
        obj.Path = corrected.path()
        _state(obj, corrected)
        cut = f"{obj.Digest} {corrected.request.program.digest}"
        if not obj.CutPath.startswith(f"{obj.Digest} "):
            obj.Corrected = datetime.now().astimezone().isoformat(timespec="seconds")
            obj.CutPath = cut
        elif obj.Digest and obj.CutPath != cut:
            obj.Warnings = [*obj.Warnings, CHANGED.format(obj.Base.Label)]

    def onDelete(self, obj: Any, subelements: Any = None) -> bool:
        """Give the operation its place in the job back."""
        base = obj.Base
        if base is not None:
            job = compat.parent_job(obj)
            if job is not None:
                compat.replace_operation(job, obj, base)
            obj.Base = None
            base.Visibility = True
        return True

    def dumps(self) -> None:
        """Nothing but properties is stored."""
        return None

    def loads(self, state: Any) -> None:
        """Nothing but properties is stored."""
        return None

    __getstate__ = dumps
    __setstate__ = loads


def _empty_profiles(obj: Any) -> None:
    """Empty the compensated profiles that hang on a dressup: FreeCAD does not recompute them if it fails."""
    for dependent in obj.InList:
        if getattr(dependent, "Correction", None) == obj and hasattr(dependent, "Shape"):
            dependent.Shape = Part.Shape()


def _clear(obj: Any) -> None:
    for row in _RESULTS:
        store(obj, row.name, row.default)


def _state(obj: Any, corrected: correction.Correction) -> None:
    """Write the result to the read-only properties."""
    summary = corrected.result.summary()
    deviation = summary["deviation"]
    for name, key in (("Mean", "mean"), ("Min", "min"), ("Max", "max"), ("Height", "height"), ("Std", "std")):
        store(obj, f"Deviation{name}", _known(deviation.get(key)))
    store(obj, "RandomStd", _known(summary["random_std"]))
    store(obj, "LargestCorrection", _known(summary["correction"]["max"]))
    store(obj, "PathError", _known(summary["verification"]["path_error_max"]))
    store(obj, "PointsUsed", int(summary["points"]["used"]))
    store(obj, "PointsRejected", len(summary["points"]["rejected"]))
    store(obj, "Warnings", list(summary["warnings"]))
    measurement = corrected.request.measurement
    if measurement is not None:
        store(obj, "Source", measurement.source)
        store(obj, "Digest", measurement.digest)


def _known(value: float | None) -> float:
    """A number for a property, which cannot be empty: 0 where there is none."""
    return float(value) if value is not None and isfinite(value) else 0.0


def create(base: Any, measurement: Any = None, **settings: Any) -> Any:
    """New dressup on an operation, in the operation's place in its job.

    Parameters
    ----------
    base : document object
        Operation or dressup that stands in a job.
    measurement : document object, optional
        Measurement; without one the path is made exact and nothing is corrected.
    **settings
        Properties of the dressup by name, such as ``Filter="mean:5"``.

    Returns
    -------
    document object
        Not yet recomputed.

    Raises
    ------
    InputError
        If the operation does not stand in a job, or a dressup lies on it already.
    """
    job = compat.parent_job(base)
    if job is None:
        raise InputError(f"{base.Label}: the operation stands in no job")
    if base.Name not in [obj.Name for obj in compat.operations(job)]:
        raise InputError(f"{base.Label}: a dressup lies on this operation; choose the dressup")
    obj = base.Document.addObject("Path::FeaturePython", "DressupMillcorr")
    DressupMillcorr(obj)
    obj.Base = base
    obj.Measurement = measurement
    for name, value in settings.items():
        setattr(obj, name, value)
    compat.replace_operation(job, base, obj)
    obj.Label = f"{base.Label} corrected"
    views.attach(obj, "dressup")
    base.Visibility = False
    return obj
