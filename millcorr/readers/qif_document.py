# SPDX-License-Identifier: LGPL-2.1-or-later
"""What matters of a QIF document: features, point sets, profile values and units, as they stand in the file."""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import NoReturn

import numpy as np

from millcorr.arrays import Bools, Floats, Ints

from .fields import NUMBER
from .source import Source, shown

POINTS = frozenset({"Point", "EdgePoint"})
"""Kinds of features whose location is a point that was measured."""

_FEATURE = re.compile(r"(\w*?)Feature(Nominal|Item|Measurement|Actual)", re.ASCII)
_PROFILE_VALUE = re.compile(r"PointProfileCharacteristic(?:Measurement|Actual)", re.ASCII)
_FEATURE_FIELDS = {"Location", "Normal", "FeatureNominalId", "FeatureItemId", "FeatureName"}
_SET_FIELDS = {
    "Points", "BinaryPoints", "Normals", "BinaryNormals", "Compensated", "Compensations", "BinaryCompensated",
    "ProbeRadius", "ProbeRadii", "BinaryProbeRadii",
}  # fmt: skip
_TOUCH_FIELDS = {"Point", "Normal", "Compensated", "ProbeRadius"}
"""Children of a MeasurePoint, in which documents of 2.x give every touch of a feature."""
_FOREIGN_FRAMES = ("CoordinateSystemId", "TransformId", "TranformId", "Units")
"""Children of a point set that give it a frame or unit of its own; the schema of 3.0 has the third, misspelt."""

_NUMBER_CHARACTERS = str.maketrans("", "", "0123456789+-.eE \t\n\r")
_BLOCK = 1 << 20
_LARGEST = 1e9


@dataclass(frozen=True, slots=True)
class Reference:
    """Points `first` to `last`, from 1, of a point set; `last` is 0 for all of them."""

    id: str
    line: int
    first: int = 1
    last: int = 0


@dataclass(slots=True)
class Touch:
    """MeasurePoint of a feature; None is what it does not say."""

    line: int
    point: tuple[float, float, float] | None = None
    normal: tuple[float, float, float] | None = None
    compensated: bool | None = None
    radius: float | None = None


@dataclass(slots=True)
class Feature:
    """Point feature in one of its roles, or any feature that was measured."""

    kind: str
    id: str
    line: int
    location: tuple[float, float, float] | None = None
    normal: tuple[float, float, float] | None = None
    reference: str = ""
    name: str = ""
    sets: list[Reference] = field(default_factory=list)
    touches: list[Touch] = field(default_factory=list)
    unit: str = ""
    result: int = -1
    """Which of the document's results holds it; -1 for none."""


@dataclass(slots=True)
class PointSet:
    """Measured point set; `compensated` and `radius` are one for all points or one a point, None if not said.

    A radius is NaN where only other points say theirs.
    """

    id: str
    line: int
    count: int
    points: Floats | None = None
    normals: Floats | None = None
    compensated: Floats | None = None
    radius: Floats | None = None
    unit: str = ""
    result: int = -1
    lines: Ints | None = None
    """Line of each point where it has one of its own."""

    def only(self, rows: slice | Bools) -> PointSet:
        """Some points of the set."""
        assert self.points is not None

        def kept(values: Floats | None) -> Floats | None:
            return values if values is None or len(values) != self.count else values[rows]

        points = self.points[rows]
        return replace(
            self, count=len(points), points=points, normals=kept(self.normals), compensated=kept(self.compensated),
            radius=kept(self.radius), lines=None if self.lines is None else self.lines[rows],
        )  # fmt: skip


@dataclass(slots=True)
class ProfileValue:
    """Stored value of a point profile, and the feature measurement it belongs to."""

    line: int
    features: list[str] = field(default_factory=list)
    value: float | None = None


@dataclass(slots=True)
class Unit:
    """Unit of length: its name, and its factor to metres."""

    name: str = ""
    factor: float = 1.0
    primary: bool = True
    line: int = 0


class Document:
    """Collects from the stream of elements the few that matter; a `millcorr.readers.xml_events.Handler`."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.nominals: dict[str, Feature] = {}
        self.items: dict[str, Feature] = {}
        self.measured: dict[str, Feature] = {}
        self.sets: dict[str, PointSet] = {}
        self.values: list[ProfileValue] = []
        self.units: list[Unit] = []
        self.results: list[tuple[str, int]] = []
        """Id and line of every MeasurementResults."""
        self.record: Feature | PointSet | ProfileValue | Unit | None = None
        self.depth = 0
        self.span = ""
        """Which points of a set a reference means, as it stands there."""

    def begin(self, path: Sequence[str], attributes: dict[str, str], line: int) -> bool:
        """Open a record, or say whether the text of this element is wanted."""
        name = path[-1]
        if self.record is None:
            if name == "MeasurementResults":
                self.results.append((attributes.get("id", "").strip()[:40], line))
            self.record = self._opened(path, attributes, line)
            self.depth = len(path)
            return False
        below = len(path) - self.depth
        if isinstance(self.record, PointSet):
            if below == 1 and name in _FOREIGN_FRAMES:
                self._refuse(
                    f"point set {self.record.id} has its own {name}: export the points in the common frame and unit",
                    line,
                )
            return below == 1 and name in _SET_FIELDS
        if isinstance(self.record, Feature):
            if below == 1 and name == "Location" and "linearUnit" in attributes:
                self.record.unit = attributes["linearUnit"]
            if below == 2 and name.endswith("PointSetId"):
                self.span = attributes.get("range", attributes.get("index", ""))
                return True
            if below == 2 and name == "MeasurePoint" and path[-2] == "PointList":
                self.record.touches.append(Touch(line))
            if below == 3:
                return path[-2] == "MeasurePoint" and bool(self.record.touches) and name in _TOUCH_FIELDS
            return below == 1 and name in _FEATURE_FIELDS
        if isinstance(self.record, Unit):
            return name in ("UnitName", "Factor")
        return (below == 1 and name == "Value") or (below == 2 and name == "Id" and path[-2].startswith("Feature"))

    def text(self, path: Sequence[str], content: str, line: int) -> None:
        """Put the text of a wanted element where it belongs."""
        name, record = path[-1], self.record
        if isinstance(record, PointSet):
            self._set_field(record, name, content, line)
        elif isinstance(record, Feature):
            if path[-2] == "MeasurePoint":
                self._touch_field(record, record.touches[-1], name, content, line)
            elif name in ("Location", "Normal"):
                vector = self._three(content, record.id, line)
                if name == "Location":
                    record.location = vector
                else:
                    record.normal = vector
            elif name == "FeatureName":
                record.name = content.strip()
            elif name.endswith("PointSetId"):
                record.sets.append(self._referred(content.strip(), line))
            else:
                record.reference = content.strip()
        elif isinstance(record, ProfileValue):
            if name == "Id":
                record.features.append(content.strip())
            else:
                record.value = float(self._numbers(content, "", line, 1)[0])
        elif isinstance(record, Unit):
            if name == "UnitName":
                record.name = content.strip()
            else:
                record.factor = float(self._numbers(content, "", line, 1)[0])
                if not 1e-9 <= record.factor <= 1e3:
                    self._refuse(f"{record.factor:g} m is no unit of length", line)

    def end(self, path: Sequence[str]) -> None:
        """Close the record whose element ends."""
        if self.record is None or len(path) != self.depth:
            return
        record, self.record = self.record, None
        if isinstance(record, Feature):
            role = _role(path[-1])
            assert role is not None
            group = {"Nominal": self.nominals, "Item": self.items}.get(role[2], self.measured)
            self._once(record.id, group, record.line)
            group[record.id] = record
            if record.touches and group is self.measured:
                self._add_touches(record)
        elif isinstance(record, PointSet):
            self._once(record.id, self.sets, record.line)
            self._check_set(record)
            self.sets[record.id] = record
        elif isinstance(record, ProfileValue):
            self.values.append(record)
        else:
            self.units.append(record)

    def _opened(
        self, path: Sequence[str], attributes: dict[str, str], line: int
    ) -> Feature | PointSet | ProfileValue | Unit | None:
        name = path[-1]
        found = _role(name)
        if found and found[1] and (found[1] in POINTS or found[2] in ("Measurement", "Actual")):
            return Feature(found[1], self._id(name, attributes, line), line, result=self._result(path))
        if name == "MeasuredPointSet":
            label = self._id(name, attributes, line)
            count = attributes.get("count", "")
            if not re.fullmatch(r"\d{1,9}", count, re.ASCII):
                self._refuse(f"point set {label} has no count", line)
            return PointSet(label, line, int(count), unit=attributes.get("linearUnit", ""), result=self._result(path))
        if _PROFILE_VALUE.fullmatch(name):
            return ProfileValue(line)
        if name == "LinearUnit" and "FileUnits" in path:
            return Unit(primary="PrimaryUnits" in path, line=line)
        return None

    def _result(self, path: Sequence[str]) -> int:
        return len(self.results) - 1 if "MeasurementResults" in path else -1

    def _id(self, name: str, attributes: dict[str, str], line: int) -> str:
        if not attributes.get("id", "").strip():
            self._refuse(f"{shown(name)} has no id", line)
        return attributes["id"].strip()[:40]

    def _once(self, label: str, group: dict[str, Feature] | dict[str, PointSet], line: int) -> None:
        if label in group:
            self._refuse(f"id {shown(label)} is there twice, first in line {group[label].line}", line)

    def _referred(self, label: str, line: int) -> Reference:
        if not self.span.strip():
            return Reference(label, line)
        ends = self.span.split()
        if not all(re.fullmatch(r"\d{1,9}", end, re.ASCII) for end in ends) or len(ends) > 2:
            self._refuse(f"{shown(self.span)} is no range of points of set {label}", line)
        return Reference(label, line, int(ends[0]), int(ends[-1]))

    def _touch_field(self, record: Feature, touch: Touch, name: str, content: str, line: int) -> None:
        if name == "Compensated":
            if content.strip() not in ("true", "1", "false", "0"):
                self._refuse(f"feature {record.id}: Compensated {shown(content)} is not true or false", line)
            touch.compensated = content.strip() in ("true", "1")
        elif name == "ProbeRadius":
            touch.radius = float(self._numbers(content, record.id, line, 1)[0])
        else:
            vector = self._three(content, record.id, line)
            if name == "Point":
                touch.point = vector
            else:
                touch.normal = vector

    def _add_touches(self, record: Feature) -> None:
        """Put the touches that stand in a feature among the point sets, and refer to them."""
        touches, label = record.touches, f"of feature {record.id}"
        for t in touches:
            if t.point is None:
                self._refuse(f"a MeasurePoint of feature {record.id} has no Point", t.line)
            if t.compensated is not touches[0].compensated and None in (t.compensated, touches[0].compensated):
                self._refuse(f"a MeasurePoint of feature {record.id} lacks Compensated, or all others do", t.line)
        normals = [t.normal for t in touches if t.normal is not None]
        radii = np.array([np.nan if t.radius is None else t.radius for t in touches])
        found = PointSet(
            label, record.line, len(touches), np.array([t.point for t in touches]),
            np.array(normals) if len(normals) == len(touches) else None,
            None if touches[0].compensated is None else np.array([float(bool(t.compensated)) for t in touches]),
            None if np.isnan(radii).all() else radii, record.unit, record.result,
            np.array([t.line for t in touches], dtype=np.int64),
        )  # fmt: skip
        self._check_set(found)
        self.sets[label] = found
        record.sets.append(Reference(label, record.line))
        record.touches = []

    def _set_field(self, record: PointSet, name: str, content: str, line: int) -> None:
        n = record.count
        if name in ("Compensated", "Compensations"):
            words = content.split()
            if not words or not {"true", "false", "1", "0"}.issuperset(words) or len(words) not in (1, n):
                self._refuse(f"point set {record.id}: {name} {shown(content)} is not true or false", line)
            record.compensated = np.array([w in ("true", "1") for w in words], dtype=np.float64)
        elif name in ("ProbeRadius", "ProbeRadii"):
            record.radius = self._numbers(content, record.id, line, 1 if name == "ProbeRadius" else n)
        elif name.startswith("Binary"):
            self._binary_field(record, name, content, line)
        else:
            vectors = self._numbers(content, record.id, line, 3 * n).reshape(n, 3)
            if name == "Points":
                record.points = vectors
            else:
                record.normals = vectors

    def _binary_field(self, record: PointSet, name: str, content: str, line: int) -> None:
        n = record.count
        try:
            data = base64.b64decode("".join(content.split()), validate=True)
        except (binascii.Error, ValueError):
            self._refuse(f"point set {record.id}: {name} is no base64", line)
        if name == "BinaryCompensated":
            if len(data) != n:
                self._refuse(f"point set {record.id}: {name} has {len(data)} bytes for {n} points", line)
            record.compensated = (np.frombuffer(data, np.uint8) != 0).astype(np.float64)
            return
        width = n if name == "BinaryProbeRadii" else 3 * n
        if not width or len(data) not in (4 * width, 8 * width):
            self._refuse(f"point set {record.id}: {name} has {len(data)} bytes for {n} points", line)
        numbers = np.frombuffer(data, "<f8" if len(data) == 8 * width else "<f4").astype(np.float64)
        self._refuse_absurd(numbers, f"point set {record.id}: ", line)
        if name == "BinaryProbeRadii":
            record.radius = numbers
        elif name == "BinaryPoints":
            record.points = numbers.reshape(n, 3)
        else:
            record.normals = numbers.reshape(n, 3)

    def _check_set(self, record: PointSet) -> None:
        if record.points is None:
            self._refuse(f"point set {record.id} has no Points", record.line)
        if record.radius is not None and (record.radius <= 0).any() and not self._all_compensated(record):
            self._refuse(f"point set {record.id}: its ProbeRadius is not positive", record.line)

    @staticmethod
    def _all_compensated(record: PointSet) -> bool:
        return record.compensated is not None and bool(record.compensated.all())

    def _numbers(self, text: str, label: str, line: int, count: int) -> Floats:
        """Exactly `count` numbers; long lists by the block, for the memory's sake."""
        owner = f"element {label}: " if label else ""
        few = self._few(text, count) if count <= 3 else None
        if few is not None:
            return np.array(few)
        blocks = []
        position = 0
        while position < len(text):
            end = position + _BLOCK
            while end < len(text) and not text[end].isspace():
                end += 1
            block = text[position:end]
            position = end
            spoilt = block.translate(_NUMBER_CHARACTERS)
            try:
                blocks.append(np.array(block.split(), dtype=np.float64) if not spoilt else np.zeros(0))
            except ValueError:
                spoilt = block
            if spoilt:
                word = next((w for w in block.split() if not _is_number(w)), spoilt)
                self._refuse(f"{owner}{shown(word)} is no number", line)
        numbers = np.concatenate(blocks) if blocks else np.zeros(0)
        if len(numbers) != count:
            self._refuse(f"{owner}{len(numbers)} numbers where {count} were expected", line)
        self._refuse_absurd(numbers, owner, line)
        return numbers

    def _few(self, text: str, count: int) -> list[float] | None:
        """So few numbers that most documents hold nothing else; None where they are not so many, or are none."""
        if text.translate(_NUMBER_CHARACTERS):
            return None
        try:
            numbers = list(map(float, text.split()))
        except ValueError:
            return None
        return numbers if len(numbers) == count and max(map(abs, numbers)) <= _LARGEST else None

    def _three(self, text: str, label: str, line: int) -> tuple[float, float, float]:
        x, y, z = self._few(text, 3) or self._numbers(text, label, line, 3).tolist()
        return x, y, z

    def _refuse_absurd(self, numbers: Floats, owner: str, line: int) -> None:
        wrong = numbers[~(np.abs(numbers) <= _LARGEST)]
        if len(wrong):
            self._refuse(f"{owner}{wrong[0]:g} is no length that a machine can travel", line)

    def _refuse(self, message: str, line: int) -> NoReturn:
        raise self.source.error(message, line)


@lru_cache(maxsize=1024)
def _role(name: str) -> re.Match[str] | None:
    """Kind and role of a feature's element; None of another element."""
    return _FEATURE.fullmatch(name)


def _is_number(word: str) -> bool:
    return NUMBER.fullmatch(word) is not None
