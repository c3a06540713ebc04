# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement in a document: the measured file itself, with what must be known to read it.

The file's bytes are kept in the document, so that a correction can be made again anywhere; everything else is
read from them when it is needed.
"""

from __future__ import annotations

import os
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

from millcorr import readers
from millcorr.errors import FormatError, InputError
from millcorr.measurement import Measurement

from . import views
from .properties import HIDDEN, QT_TRANSLATE_NOOP, READ_ONLY, Property, complete, store

AS_FILE = "as the file says"
"""Value of Points and Unit where the file itself tells."""

_text = QT_TRANSLATE_NOOP
PROPERTIES = (
    Property(
        "FileIncluded",
        "File",
        "Measurement",
        _text("App::Property", "The measured file, kept in the document"),
    ),
    Property(
        "Enumeration",
        "Points",
        "Measurement",
        _text("App::Property", "What the coordinates are: points on the surface or centres of the probe's ball"),
        (AS_FILE, "contact", "centre"),
    ),
    Property(
        "Length",
        "BallRadius",
        "Measurement",
        _text("App::Property", "Radius of the probe's ball where the points are centres; 0: as the file says"),
        0.0,
    ),
    Property(
        "Enumeration",
        "Unit",
        "Measurement",
        _text("App::Property", "Unit of length in the file"),
        (AS_FILE, "mm", "inch"),
    ),
    Property(
        "String", "Format", "Measurement", _text("App::Property", "Format of the file; empty: by its content"), ""
    ),
    Property("String", "Source", "Origin", _text("App::Property", "Name of the file"), "", READ_ONLY),
    Property("String", "Digest", "Origin", _text("App::Property", "SHA-256 of the file"), "", READ_ONLY),
    Property("Integer", "Count", "Origin", _text("App::Property", "Number of points"), 0, READ_ONLY),
    Property("Integer", "Levels", "Origin", _text("App::Property", "Number of Z levels"), 0, READ_ONLY),
    Property("Bool", "HasZ", "Origin", _text("App::Property", "The file has a Z coordinate"), False, HIDDEN),
)


class MeasurementObject:
    """Proxy of a measurement: reads the file again on every recompute and states what it holds."""

    def __init__(self, obj: Any) -> None:
        complete(obj, PROPERTIES)
        obj.Proxy = self

    def onDocumentRestored(self, obj: Any) -> None:
        """Add the properties that an earlier version did not have."""
        complete(obj, PROPERTIES)
        views.attach(obj, "measurement")

    def execute(self, obj: Any) -> None:
        """Read the file and fill the read-only properties; raises FormatError or InputError."""
        for name in ("Count", "Levels"):
            store(obj, name, 0)
        measurement = measurement_of(obj)
        store(obj, "Digest", measurement.digest)
        store(obj, "Count", len(measurement))
        store(obj, "Levels", int(measurement.levels().max(initial=-1)) + 1)
        store(obj, "HasZ", measurement.has_z)

    def dumps(self) -> None:
        """Nothing but properties is stored."""
        return None

    def loads(self, state: Any) -> None:
        """Nothing but properties is stored."""
        return None

    __getstate__ = dumps
    __setstate__ = loads


def create(
    document: Any,
    source: str | Path | bytes,
    points: str | None = None,
    ball_radius: float | None = None,
    units: str | None = None,
    format: str | None = None,
    name: str | None = None,
) -> Any:
    """New measurement in a document.

    Parameters
    ----------
    document : FreeCAD document
    source : str, Path or bytes
        The measured file, or its content (give a `name` then).
    points : {"contact", "centre"}, optional
        What the coordinates are; only where the file itself says it can it be left out.
    ball_radius : float, optional
        Radius of the probe's ball in mm.
    units : {"mm", "inch"}, optional
        Unit of the file where it does not say.
    format : str, optional
        Name of the file's format; default by its content.
    name : str, optional
        What to call it; default the file's name.

    Returns
    -------
    document object

    Raises
    ------
    FormatError
        If the file cannot be read; no object remains then.
    """
    obj = document.addObject("App::FeaturePython", "Measurement")
    try:
        MeasurementObject(obj)
        views.attach(obj, "measurement")
        load(obj, source, name)
        obj.Points = points or AS_FILE
        obj.BallRadius = ball_radius or 0.0
        obj.Unit = units or AS_FILE
        obj.Format = format or ""
        measurement_of(obj)
    except (InputError, ValueError):
        document.removeObject(obj.Name)
        raise
    obj.Label = obj.Source
    return obj


def load(obj: Any, source: str | Path | bytes, name: str | None = None) -> None:
    """Put a file's content in a measurement in place of what it had.

    Parameters
    ----------
    obj : document object
    source : str, Path or bytes
        The file, or its content.
    name : str, optional
        Its name; default the file's.

    Raises
    ------
    FormatError
        If the file cannot be read.
    """
    if isinstance(source, bytes):
        data, name = source, name or "points.csv"
    else:
        name = name or Path(source).name
        try:
            if not Path(source).is_file():
                raise FormatError("no such file", source)
            data = Path(source).read_bytes()
        except OSError as error:
            raise FormatError(f"cannot be read: {error.strerror or error}", source) from error
    with tempfile.TemporaryDirectory() as directory:
        copy = os.path.join(directory, Path(name).name)
        Path(copy).write_bytes(data)
        obj.File = copy
    obj.Source = name


def measurement_of(obj: Any) -> Measurement:
    """The points of a measurement in a document, whether or not its proxy is alive.

    Raises
    ------
    FormatError
        If the stored file cannot be read in the way the properties say.
    InputError
        If no file is stored.
    """
    if not obj.File:
        raise InputError(f"{obj.Label}: the measurement holds no file")
    stored = Path(obj.File)
    try:
        measurement = readers.read(
            stored,
            points=None if obj.Points == AS_FILE else obj.Points,
            probe_radius=float(obj.BallRadius.Value) or None,
            units=None if obj.Unit == AS_FILE else obj.Unit,
            format=obj.Format or None,
        )
    except FormatError as error:
        # The stored copy lies in a temporary place that means nothing to the user.
        where = str(error.file) if error.line is None else f"{error.file}:{error.line}"
        raise FormatError(str(error).removeprefix(f"{where}: "), obj.Source, error.line) from error
    return replace(measurement, source=obj.Source)
