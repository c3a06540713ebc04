# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dressup: an operation of a job with its path corrected from a measured part."""

from __future__ import annotations

import re
from datetime import datetime
from math import isfinite
from typing import Any

import Part
import Path

from millcorr.correction.settings import Settings
from millcorr.errors import InputError
from millcorr.messages import Message, phrase
from millcorr.options import options_of

from . import compat, correction, draft, rounds, views, wording
from .properties import HIDDEN, QT_TRANSLATE_NOOP, READ_ONLY, Property, of_option, store
from .stored import Proxy

_text = QT_TRANSLATE_NOOP
_SETTINGS = options_of(Settings)
CORRECTION, TRANSFER = "Correction", "Transfer function"
"""Headings in the property editor."""

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
        "LinkList",
        "EarlierParts",
        "Correction",
        _text(
            "App::Property", "Parts measured in earlier rounds, oldest first; the later ones were cut with their path"
        ),
        [],
        READ_ONLY,
    ),
    Property(
        "LinkList",
        "SwitchedOff",
        "Correction",
        _text("App::Property", "Measured parts that count for nothing"),
        [],
    ),
    Property(
        "StringList",
        "EarlierRounds",
        "Correction",
        _text("App::Property", "Number of parts and settings of each earlier round"),
        [],
        HIDDEN,
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
        zero=_text("Millcorr", "the tool controller's"),
    ),
    of_option(
        _SETTINGS["side"],
        CORRECTION,
        _text("App::Property", "Side of the contour on which the tool runs, along its direction"),
    ),
    of_option(
        _SETTINGS["align"],
        CORRECTION,
        _text(
            "App::Property",
            "Best fit of the measured points before comparing: none, shift, rigid, or some of x, y, turn joined by +",
        ),
    ),
    of_option(
        _SETTINGS["accept"],
        CORRECTION,
        _text("App::Property", "Findings about the measurement that are accepted by name"),
    ),
    of_option(
        _SETTINGS["filter"],
        CORRECTION,
        _text(
            "App::Property",
            "What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto",
        ),
    ),
    of_option(_SETTINGS["method"], CORRECTION, _text("App::Property", "How the path answers a deviation")),
    Property(
        "FileIncluded",
        "Setup",
        "Correction",
        _text("App::Property", "TOML file with tool, material, machine and stock, kept in the document"),
    ),
    of_option(
        _SETTINGS["iterate"],
        CORRECTION,
        _text("App::Property", "Correct again in the model until the error to expect is at most this; 0: only once"),
        zero=_text("Millcorr", "only once"),
    ),
    of_option(
        _SETTINGS["depth"],
        TRANSFER,
        _text("App::Property", "Depth along the normal that the measured part was cut at; one, or one a part"),
    ),
    of_option(
        _SETTINGS["next_depth"],
        TRANSFER,
        _text("App::Property", "Depth that the corrected path will cut; 0: that of the measured part"),
        zero=_text("Millcorr", "that of the measured part"),
    ),
    of_option(
        _SETTINGS["depth_along"],
        TRANSFER,
        _text("App::Property", "How deviations are taken: along the normal, or along one axis"),
    ),
    of_option(
        _SETTINGS["transfer_function"],
        TRANSFER,
        _text("App::Property", "Smooth along the contour, one value, or one a point"),
    ),
    of_option(
        _SETTINGS["allowance"],
        TRANSFER,
        _text("App::Property", "Stock that the path of the measured part left on the nominal"),
    ),
    of_option(
        _SETTINGS["leave_stock"],
        CORRECTION,
        _text("App::Property", "Stock that the path leaves on the part: a first cut, before anything is measured"),
    ),
    of_option(_SETTINGS["gain"], CORRECTION, _text("App::Property", "Share of the deviation taken back")),
    of_option(_SETTINGS["limit"], CORRECTION, _text("App::Property", "Largest correction; a larger one is refused")),
    of_option(_SETTINGS["dead_band"], CORRECTION, _text("App::Property", "Deviations up to this are left alone")),
    of_option(
        _SETTINGS["unmeasured_share"],
        CORRECTION,
        _text("App::Property", "Largest share of a contour without points near that is corrected all the same"),
    ),
    of_option(
        _SETTINGS["tools"],
        CORRECTION,
        _text("App::Property", "Diameters of other tools of the path, each as 3=16 or ROUGH=16"),
    ),
    of_option(
        _SETTINGS["keep_allowance"],
        CORRECTION,
        _text("App::Property", "Passes that rough along the contour are moved with it"),
    ),
    of_option(
        _SETTINGS["tolerance"], CORRECTION, _text("App::Property", "Largest distance of the path from the exact one")
    ),
    of_option(
        _SETTINGS["output_moves"],
        CORRECTION,
        _text("App::Property", "Moves of the corrected path: as the operation's, only lines, or arcs"),
        ("keep", "lines", "arcs"),
    ),
    of_option(
        _SETTINGS["cutter_compensation"],
        CORRECTION,
        _text("App::Property", "What a path under G41 or G42 is: the contour itself, or the centre path"),
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
        "StringList",
        "Noted",
        "Origin",
        _text("App::Property", "Warnings that were there when the user last looked at the correction"),
        [],
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
    if row.group in ("Result", "Origin") and row.name not in ("Corrected", "Smoothed", "Noted", "CutPath")
)


def changed(operation: str) -> Message:
    """What to know where an operation's path, by its label, is another one by now."""
    return phrase(
        "the path of {} is not the one the measured part was cut with: the difference between the two counts as an "
        "error of the machine; measure a part cut with the path as it is now",
        operation,
    )


class DressupMillcorr(Proxy):
    """Proxy of the dressup."""

    properties, view = PROPERTIES, "dressup"

    def completed(self, obj: Any, added: list[str]) -> None:
        """Of an earlier version what it said when it was saved is known."""
        if "Noted" in added:
            take_note(obj)

    def shown(self, obj: Any) -> None:
        """The job and the operation below get their views, too; the path stays as it was saved."""
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
        with wording.shown_by_freecad():
            corrected = correction.correct(obj)
        obj.Path = corrected.path()
        _state(obj, corrected)
        self._remember(obj, corrected)

    def _remember(self, obj: Any, corrected: correction.Correction) -> None:
        """Note with which path the newest part was cut, and say where a path is another one by now."""
        own = any(rounds.is_on(obj, part) for part in rounds.newest_parts(obj))
        was, now = corrected.cuts[-1] if own else ("", "")
        fresh = own and was.partition(" ")[0] != now.partition(" ")[0]
        if fresh:
            obj.Corrected = datetime.now().astimezone().isoformat(timespec="seconds")
            obj.CutPath = now
        if corrected.otherwise_cut:
            obj.Warnings = [*obj.Warnings, wording.stored(changed(obj.Base.Label))]
        if fresh or not corrected.cuts:
            take_note(obj)

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
    store(obj, "PointsRejected", int(summary["points"]["left_out"]))
    store(obj, "Warnings", list(map(wording.stored, summary["warnings"])))
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
        raise InputError(phrase("{}: the operation stands in no job", base.Label))
    if base.Name not in [obj.Name for obj in compat.operations(job)]:
        raise InputError(phrase("{}: a dressup lies on this operation; choose the dressup", base.Label))
    obj = base.Document.addObject("Path::FeaturePython", "DressupMillcorr")
    DressupMillcorr(obj)
    obj.Base = base
    obj.Measurement = measurement
    for name, value in settings.items():
        setattr(obj, name, value)
    compat.replace_operation(job, base, obj)
    obj.Label = label_of(obj)
    views.attach(obj, "dressup")
    base.Visibility = False
    return obj


def add(obj: Any, measurement: Any, **settings: Any) -> Any:
    """Add a part that was cut with the path of a dressup, and measured: the next round of its correction.

    Parameters
    ----------
    obj : document object
        The dressup; the rounds that it has stay as they are.
    measurement : document object
    **settings
        Properties of the dressup by name that differ in this round.

    Returns
    -------
    document object
        The dressup, not yet recomputed.

    Raises
    ------
    UsageError
        If the part is there already.
    """
    usual = label_of(obj)
    for name, value in added(obj, measurement).items():
        setattr(obj, name, value)
    obj.Smoothed = ""
    for name, value in settings.items():
        setattr(obj, name, value)
    _name(obj, usual)
    return obj


def added(obj: Any, measurement: Any) -> dict[str, Any]:
    """Properties of a dressup that change when a measured part is added, as `add` sets them."""
    return rounds.added(obj, draft.values_of(obj, PROPERTIES), measurement, correction.begun_with(obj))


def switch(obj: Any, measurement: Any, on: bool) -> None:
    """Switch a measured part of a dressup on or off; it is not yet recomputed."""
    usual = label_of(obj)
    rest = [part for part in obj.SwitchedOff if part.Name != measurement.Name]
    obj.SwitchedOff = rest if on else [*rest, measurement]
    _name(obj, usual)


def take_note(obj: Any) -> None:
    """The user knows of all warnings that there are."""
    store(obj, "Noted", list(obj.Warnings))


def doubts_of(obj: Any) -> list[str]:
    """Warnings of a dressup, as it stores them, that came since the user last looked at it, whatever their figures."""
    known = {_bare(text) for text in obj.Noted}
    return [text for text in obj.Warnings if _bare(text) not in known]


def _bare(text: str) -> str:
    """A warning without its figures, which the next computation may give otherwise."""
    return re.sub(r"[-+\u2212]?\d[\d.]*", "", text)


def label_of(obj: Any) -> str:
    """Label of a dressup: what it corrects and, where there are several, from how many measured parts."""
    parts = rounds.parts_of(obj)
    on = sum(rounds.is_on(obj, part) for part in parts)
    label = f"{obj.Base.Label} corrected"
    if on < len(parts):
        return f"{label}, {on} of {len(parts)} parts"
    return f"{label}, {on} parts" if on > 1 else label


def _name(obj: Any, usual: str) -> None:
    """Give a dressup its label anew, where it has the usual one: the user's own stays."""
    if obj.Label == usual:
        obj.Label = label_of(obj)
