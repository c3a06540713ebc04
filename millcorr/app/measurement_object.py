# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement in a document: the measured file itself, with what must be known to read it.

The file's bytes are kept in the document, so that a correction can be made again anywhere; everything else is
read from them when it is needed.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from millcorr.errors import FormatError, InputError, MillcorrError
from millcorr.messages import phrase
from millcorr.readers import Reading
from millcorr.readers.measurement import Measurement

from . import views
from .properties import HIDDEN, QT_TRANSLATE_NOOP, READ_ONLY, Property, store
from .stored import Proxy
from .wording import shown_by_freecad

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
        (AS_FILE, "contact", "centre", "axis"),
    ),
    Property(
        "Length",
        "BallRadius",
        "Measurement",
        _text("App::Property", "Radius of the probe's ball where the points are centres; 0: as the file says"),
        0.0,
        zero=_text("Millcorr", "as the file says"),
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
    Property(
        "FileIncluded",
        "Mapping",
        "Measurement",
        _text("App::Property", "TOML file that says what the columns of a text file are, kept in the document"),
    ),
    Property(
        "FileIncluded",
        "Probe",
        "Measurement",
        _text("App::Property", "TOML file with the calibration of the probe, kept in the document"),
    ),
    Property(
        "Integer",
        "Part",
        "Measurement",
        _text("App::Property", "Which of several measured parts in the file, from 1; 0: it holds one"),
        0,
        zero=_text("Millcorr", "the only one"),
    ),
    Property(
        "Vector",
        "WorkOffset",
        "Measurement",
        _text("App::Property", "Origin of the work frame in the frame of the file, mm"),
    ),
    Property(
        "Bool",
        "WorkOffsetGiven",
        "Measurement",
        _text("App::Property", "The work offset holds; otherwise what the file says"),
        False,
    ),
    Property(
        "Angle",
        "WorkRotation",
        "Measurement",
        _text("App::Property", "Turn of the work frame in the frame of the file, anticlockwise"),
        0.0,
    ),
    Property("String", "Source", "Origin", _text("App::Property", "Name of the file"), "", READ_ONLY),
    Property("String", "Digest", "Origin", _text("App::Property", "SHA-256 of the file"), "", READ_ONLY),
    Property("Integer", "Count", "Origin", _text("App::Property", "Number of points"), 0, READ_ONLY),
    Property("Integer", "Levels", "Origin", _text("App::Property", "Number of Z levels"), 0, READ_ONLY),
    Property("Bool", "HasZ", "Origin", _text("App::Property", "The file has a Z coordinate"), False, HIDDEN),
)


class MeasurementObject(Proxy):
    """Proxy of a measurement: reads the file again on every recompute and states what it holds."""

    properties, view = PROPERTIES, "measurement"

    def execute(self, obj: Any) -> None:
        """Read the file and fill the read-only properties; raises FormatError or InputError."""
        for name in ("Count", "Levels"):
            store(obj, name, 0)
        with shown_by_freecad():
            measurement = measurement_of(obj)
        store(obj, "Digest", measurement.digest)
        store(obj, "Count", len(measurement))
        store(obj, "Levels", level_count(measurement))
        store(obj, "HasZ", measurement.has_z)


def create(
    document: Any,
    source: str | Path | bytes,
    points: str | None = None,
    *,
    name: str | None = None,
    **reading: Any,
) -> Any:
    """New measurement in a document.

    Parameters
    ----------
    document : FreeCAD document
    source : str, Path or bytes
        The measured file, or its content (give a `name` then).
    points : {"contact", "centre", "axis"}, optional
        What the coordinates are; only where the file itself says it can it be left out.
    name : str, optional
        What to call it; default the file's name.
    **reading
        How the file is to be read: fields of `millcorr.readers.Reading`.

    Returns
    -------
    document object

    Raises
    ------
    FormatError
        If the file cannot be read; no object remains then.
    UsageError
        If the file does not say what it must, or contradicts what is said here.
    """
    said = Reading.from_dict(reading | {"points": points})
    obj = document.addObject("App::FeaturePython", "Measurement")
    try:
        MeasurementObject(obj)
        views.attach(obj, "measurement")
        load(obj, source, name)
        obj.Points = said.points or AS_FILE
        obj.BallRadius = said.probe_radius or 0.0
        obj.Unit = said.units or AS_FILE
        obj.Format = said.format or ""
        obj.Part = said.part or 0
        obj.WorkOffsetGiven = said.work_offset is not None
        obj.WorkOffset = said.work_offset or (0.0, 0.0, 0.0)
        obj.WorkRotation = said.work_rotation or 0.0
        for kept, path in (("Mapping", said.mapping), ("Probe", said.probe)):
            if path is not None:
                _keep(obj, kept, path.name, _content(path))
        measurement_of(obj)
    except (MillcorrError, ValueError):
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
        data = _content(Path(source))
    _keep(obj, "File", name, data)
    obj.Source = name


def _content(path: Path) -> bytes:
    try:
        if not path.is_file():
            raise FormatError(phrase("no such file"), path)
        return path.read_bytes()
    except OSError as error:
        raise FormatError(phrase("cannot be read: {}", error.strerror or error), path) from error


def _keep(obj: Any, prop: str, name: str, data: bytes) -> None:
    """Put a file's content in the document."""
    with tempfile.TemporaryDirectory() as directory:
        copy = os.path.join(directory, Path(name).name)
        Path(copy).write_bytes(data)
        setattr(obj, prop, copy)


def reading_of(obj: Any) -> Reading:
    """How the file of a measurement is to be read."""
    x, y, z = obj.WorkOffset
    return Reading(
        points=None if obj.Points == AS_FILE else obj.Points,
        probe_radius=float(obj.BallRadius.Value) or None,
        units=None if obj.Unit == AS_FILE else obj.Unit,
        format=obj.Format or None,
        mapping=Path(obj.Mapping) if obj.Mapping else None,
        part=obj.Part or None,
        work_offset=(x, y, z) if obj.WorkOffsetGiven else None,
        work_rotation=float(obj.WorkRotation.Value) or None,
        probe=Path(obj.Probe) if obj.Probe else None,
    )


def measurement_of(obj: Any) -> Measurement:
    """The points of a measurement in a document, whether or not its proxy is alive.

    Raises
    ------
    FormatError
        If the stored file cannot be read in the way the properties say.
    InputError
        If no file is stored.
    """
    return reader_of(obj)()


def reader_of(obj: Any) -> Callable[[], Measurement]:
    """What reads the points of a measurement without asking FreeCAD again, so that any thread may call it.

    A file that was read before in the same way is not read again.

    Raises
    ------
    InputError
        If no file is stored.
    """
    if not obj.File:
        raise InputError(phrase("{}: the measurement holds no file", obj.Label))
    return reader_of_file(Path(obj.File), reading_of(obj), obj.Source)


def reader_of_file(file: Path, reading: Reading, source: str) -> Callable[[], Measurement]:
    """What reads a measured file in some way, calling it `source`; in any thread, and no content twice."""
    files = (file, reading.mapping, reading.probe)
    return lambda: _read(tuple(map(_digest, files)), _At(file, reading), source)


def _digest(path: Path | None) -> str:
    """SHA-256 of a file; empty where there is none."""
    if path is None or not path.is_file():
        return ""
    state = path.stat()
    return _digest_of(str(path), state.st_size, state.st_mtime_ns)


@lru_cache(maxsize=16)
def _digest_of(path: str, size: int, changed: int) -> str:
    """SHA-256 of a file in a state that size and time stand for."""
    with open(path, "rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


@dataclass(frozen=True, eq=False, slots=True)
class _At:
    """A file and how to read it; where it and its helpers lie makes no difference, their content does."""

    file: Path
    reading: Reading

    def key(self) -> Reading:
        return replace(self.reading, mapping=None, probe=None)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _At) and self.key() == other.key()

    def __hash__(self) -> int:
        return hash(self.key())


@lru_cache(maxsize=12)
def _read(digests: tuple[str, ...], at: _At, source: str) -> Measurement:
    """Points of a file; the digests stand for its content and that of mapping and probe."""
    try:
        measurement = at.reading.read(at.file)
    except FormatError as error:
        # The stored copy lies in a temporary place that means nothing to the user.
        raise FormatError(error.said, source, error.line) from error
    return replace(measurement, source=source)


@lru_cache(maxsize=4)
def level_count(measurement: Measurement) -> int:
    """Number of Z levels of a measurement."""
    return int(measurement.levels().max(initial=-1)) + 1


def described(measurement: Measurement) -> tuple[int, list[float], list[float]]:
    """Number of Z levels of a measurement, its least and its greatest coordinates in mm; in any thread."""
    points = measurement.points
    return level_count(measurement), points.min(axis=0).tolist(), points.max(axis=0).tolist()
