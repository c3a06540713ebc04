# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds of scanners and topographies: PLY, PCD, E57 and X3P, each through the library that is kept for it.

The libraries are optional and imported when a file of theirs is read. None of the formats says whether its points are
contact points; a scanner's are, a probe's need not be.
"""

from __future__ import annotations

import importlib
import io
import re
import struct
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Floats
from millcorr.errors import FormatError, UsageError
from millcorr.messages import Length, mm, phrase, um
from millcorr.readers.measurement import Measurement

from .source import FARTHEST, Source, shown
from .workbook import refuse_dangerous

MM_PER_METRE = 1000.0

_PLY = re.compile(rb"ply[ \t]*[\r\n]")
_PCD = re.compile(rb"(?:[ \t]*(?:#[^\n]*)?\n)*[ \t]*VERSION[ \t]+[.\d]+\s*\n", re.ASCII)
_E57 = re.compile(rb"ASTM-E57")
_X3P = re.compile(rb"PK\x03\x04.*main\.xml", re.DOTALL)
_PLY_ELEMENT = re.compile(rb"^element[ \t]+\S+[ \t]+(\d+)", re.MULTILINE)
_PCD_KEY = re.compile(rb"^[ \t]*(SIZE|COUNT|POINTS|WIDTH|HEIGHT|DATA)[ \t]+([^\r\n]*)\r?\n", re.MULTILINE)

_MOST = 100_000_000
_SMALLEST_PACKED = 300
"""No compression here makes a point's coordinates smaller than the file by more than this."""
_NUMBERS_OF_A_POINT = 4096


@dataclass(frozen=True, slots=True)
class _Points:
    """What a library gave: coordinates and normals in the file's unit, and the steps in which it counts."""

    points: Floats
    normals: Floats | None
    step: float
    """Distance of neighbouring numbers at the largest coordinate, in the file's unit; 0 if negligible."""
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PointCloud:
    """One format of point clouds, with the interface of a module in `millcorr.readers.FORMATS`.

    Parameters
    ----------
    name : str
    package : str
        Library that reads it, as Python and PyPI call it.
    magic : pattern
        How such files begin.
    load : callable
        Points of a file's bytes by the imported library.
    metres : bool
        Whether the format is in metres by definition; else the unit is what the caller says, else mm.
    """

    name: str
    package: str
    magic: re.Pattern[bytes]
    load: Callable[[Any, Source], _Points]
    metres: bool = False

    def recognises(self, data: bytes) -> bool:
        """Whether a file begins as this format does; a container lists at its end what is in it."""
        return self.magic.match(data[:65536] + data[-65536:]) is not None

    def read(self, source: Source) -> Measurement:
        """Points of the file, in its order.

        Parameters
        ----------
        source : Source
            Says whether the points are contact points, and the unit of PLY and PCD.

        Returns
        -------
        Measurement
            Its lines are the numbers of the points in the file, from 1.

        Raises
        ------
        FormatError
            If the file is damaged or holds no points.
        UsageError
            If the library is not installed, or the caller does not say what the points are.
        """
        ball_radius = source.ball_radius()
        unit = source.unit("mm" if self.metres else None)
        if not self.recognises(source.data):
            raise source.error(phrase("no {} file", self.name.upper()))
        try:
            library = importlib.import_module(self.package)
        except ImportError as error:
            raise UsageError(
                phrase(
                    "{} files are read by the Python package {}, which is not installed: pip install {}",
                    self.name.upper(),
                    self.package,
                    self.package,
                )
            ) from error
        try:
            with np.errstate(all="ignore"):
                found = self.load(library, source)
        except FormatError:
            raise
        except Exception as error:  # noqa: BLE001 - whatever a foreign library raises, the file is the cause
            reason = shown(" ".join(str(error).split()) or type(error).__name__)
            raise source.error(
                phrase("{} cannot read it, {}: the file is damaged or cut off", self.package, reason)
            ) from error
        return self._measurement(source, found, ball_radius, unit)

    def _measurement(self, source: Source, found: _Points, ball_radius: float, unit: str) -> Measurement:
        factor = MM_PER_METRE if self.metres else {"mm": 1.0, "inch": 25.4}[unit]
        numbers = np.arange(1, len(found.points) + 1)
        valid = np.isfinite(found.points).all(axis=1)
        points, normals, notes = found.points, found.normals, list(found.notes)
        if not valid.all():
            notes.append(phrase("{} points without a place left out", np.count_nonzero(~valid)))
            points, numbers = points[valid], numbers[valid]
            normals = None if normals is None else normals[valid]
        largest = np.abs(points).max(initial=0.0) * factor
        if found.step and largest <= FARTHEST:
            notes.append(
                phrase(
                    "coordinates are stored in steps of {}, at {}", _in_words(found.step * factor), mm(largest, ".6g")
                )
            )
        return source.measurement(
            self.name, points, numbers, ball_radius=ball_radius, unit=unit, factor=factor, normals=normals, notes=notes
        )


def _in_words(step: float) -> Length:
    """A length in mm in the unit that suits it."""
    return um(step, ".2g") if step < 0.1 else mm(step, ".2g")


def _step(*columns: NDArray[Any]) -> float:
    """Distance of neighbouring numbers at the largest of these coordinates; 0 for 64-bit numbers and integers."""
    steps = [0.0]
    for column in columns:
        largest = np.abs(column[np.isfinite(column)]).max(initial=0)
        if column.dtype.kind == "f" and column.dtype.itemsize < 8:
            steps.append(float(np.spacing(column.dtype.type(largest))))
    return max(steps)


def _table(source: Source, names: tuple[str, ...], take: Callable[[str], NDArray[Any]]) -> _Points:
    """Points and normals from columns by name."""
    lower = {name.lower(): name for name in names}
    if not {"x", "y", "z"} <= lower.keys():
        raise source.error(
            phrase("no points: it has {} instead of x, y, z", ", ".join(map(shown, names[:8])) or phrase("nothing"))
        )
    columns = [np.asarray(take(lower[c])) for c in "xyz"]
    if any(c.ndim != 1 or c.dtype.kind not in "fiu" for c in columns):
        raise source.error(phrase("x, y and z are no numbers"))
    normals = None
    for triple in (("nx", "ny", "nz"), ("normal_x", "normal_y", "normal_z")):
        if set(triple) <= lower.keys():
            vectors = [np.asarray(take(lower[c])) for c in triple]
            if any(v.ndim != 1 or v.dtype.kind != "f" for v in vectors):
                raise source.error(phrase("the normals are no numbers"))
            normals = np.column_stack(vectors).astype(np.float64)
    return _Points(np.column_stack(columns).astype(np.float64), normals, _step(*columns))


def _load_ply(plyfile: Any, source: Source) -> _Points:
    # A count beyond the file's size would only cost memory.
    header = source.data[: source.data.find(b"end_header") + 1]
    if sum(int(n[:18]) for n in _PLY_ELEMENT.findall(header)) > len(source.data):
        raise source.error(phrase("the header tells of more elements than the file can hold: it was cut off"))
    content = plyfile.PlyData.read(io.BytesIO(source.data))
    names = [element.name for element in content.elements]
    if "vertex" not in names:
        raise source.error(phrase("no points: it has no element named vertex"))
    vertices = content["vertex"].data
    found = _table(source, vertices.dtype.names or (), lambda name: vertices[name])
    mesh = "face" in names and len(content["face"].data) > 0
    notes = (phrase("the corners of a mesh are taken as points"),) if mesh else ()
    return _Points(found.points, found.normals, found.step, notes)


def _load_pcd(pypcd4: Any, source: Source) -> _Points:
    keys = {key: (value.split(), m) for key, value, m in _pcd_header(source.data)}
    if b"DATA" not in keys or b"POINTS" not in keys:
        raise source.error(phrase("the header lacks POINTS or DATA"))
    count = int(keys[b"POINTS"][0][0][:18])
    kind, end = keys[b"DATA"][0][0], keys[b"DATA"][1]
    if count > _SMALLEST_PACKED * len(source.data) or count > _MOST:
        raise source.error(phrase("the header tells of more points than the file can hold: it was cut off"))
    # The library names every number of a point before it looks for one.
    numbers = sum(int(n[:18]) for n in keys.get(b"COUNT", ([], 0))[0])
    if numbers > _NUMBERS_OF_A_POINT:
        raise source.error(phrase("the header tells of {} numbers a point: it is damaged", numbers))
    if kind == b"binary_compressed":
        packed, size = struct.unpack("<II", source.data[end : end + 8])
        if packed > len(source.data) - end - 8 or size > _SMALLEST_PACKED * max(packed, 1):
            raise source.error(phrase("the compressed data are damaged or cut off"))
    # Versions differ in what their headers may leave out; the library knows the last one's name only.
    data = source.data
    if b"COUNT" not in keys and b"SIZE" in keys:
        sizes, at = keys[b"SIZE"]
        data = data[:at] + b"COUNT" + b" 1" * len(sizes) + b"\n" + data[at:]
    data = _PCD_OLDER.sub(rb"\g<1>7", data, count=1)
    cloud = pypcd4.PointCloud.from_fileobj(io.BytesIO(data))
    # Of one point in ASCII the library makes a scalar.
    table = np.atleast_1d(cloud.pc_data)
    if table.shape != (count,):
        raise source.error(phrase("{} points where the header says {}: the file was cut off", len(table), count))
    return _table(source, tuple(cloud.fields), lambda name: table[name])


_PCD_OLDER = re.compile(rb"^(VERSION[ \t]+0?\.)[56](?=\s)", re.MULTILINE)


def _pcd_header(data: bytes) -> list[tuple[bytes, bytes, int]]:
    """Keys, values and ends of the lines of a header, up to DATA."""
    found = []
    for match in _PCD_KEY.finditer(data[:65536]):
        found.append((match[1], match[2], match.end()))
        if match[1] == b"DATA":
            break
    return found


def _load_e57(pye57: Any, source: Source) -> _Points:
    with tempfile.TemporaryDirectory() as folder:
        # The library takes a path only, and removes what it cannot read.
        path = Path(folder) / "scan.e57"
        path.write_bytes(source.data)
        image = pye57.E57(str(path))
        try:
            parts, steps = [], [0.0]
            for index in range(image.scan_count):
                header = image.get_header(index)
                if header.point_count > _SMALLEST_PACKED * len(source.data) or header.point_count > _MOST:
                    raise source.error(phrase("a scan tells of more points than the file can hold"))
                data = image.read_scan(index, ignore_missing_fields=True)
                parts.append(np.column_stack([data[f"cartesian{c}"] for c in "XYZ"]).astype(np.float64))
                steps.append(_e57_step(pye57, header, parts[-1]))
        finally:
            image.close()
    points = np.concatenate(parts) if parts else np.zeros((0, 3))
    notes = (phrase("{} scans put together", len(parts)),) if len(parts) > 1 else ()
    return _Points(points, None, max(steps), notes)


def _e57_step(pye57: Any, header: Any, points: Floats) -> float:
    """Steps of a scan's coordinates where they are stored as 32-bit numbers or as multiples of a length."""
    library = pye57.libe57
    prototype = library.StructureNode(header.points.prototype())
    for field in header.point_fields:
        if field.startswith(("cartesian", "sphericalRange")):
            node = prototype.get(field)
            if node.type() == library.E57_FLOAT and library.FloatNode(node).precision() == library.E57_SINGLE:
                return _step(points.astype(np.float32))
            if node.type() == library.E57_SCALED_INTEGER and field != "sphericalRange":
                return float(library.ScaledIntegerNode(node).scale())
    return 0.0


def _load_x3p(x3pio: Any, source: Source) -> _Points:
    refuse_dangerous(source.data, source.name, phrase("X3P file"))
    file = x3pio.read(io.BytesIO(source.data))
    parts = [np.asarray(layer.points(), dtype=np.float64).reshape(-1, 3) for layer in file.layers]
    points = np.concatenate(parts) if parts else np.zeros((0, 3))
    notes = [phrase("{} layers put together", len(parts))] if len(parts) > 1 else []
    if isinstance(file, x3pio.Profile):
        # The contour lies in the plane of the profile; x, z, -y keeps the frame right-handed.
        points = points[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
        notes.append(phrase("a profile: its X and Z are the contour's X and Y"))
    return _Points(points, None, 0.0, tuple(notes))


PLY = PointCloud("ply", "plyfile", _PLY, _load_ply)
PCD = PointCloud("pcd", "pypcd4", _PCD, _load_pcd)
E57 = PointCloud("e57", "pye57", _E57, _load_e57, metres=True)
X3P = PointCloud("x3p", "x3pio", _X3P, _load_x3p, metres=True)
