# SPDX-License-Identifier: LGPL-2.1-or-later
"""What matters of a QIF document: features, point sets, profile values and units, as they stand in the file."""

from __future__ import annotations

import base64
import binascii
import math
import re
from array import array
from dataclasses import dataclass
from typing import NoReturn

import numpy as np

from millcorr.arrays import Floats
from millcorr.messages import phrase

from .fields import NUMBER
from .source import Source, shown
from .xml_events import Element

POINTS = frozenset({"Point", "EdgePoint"})
"""Kinds of features whose location is a point that was measured."""

_FEATURE = re.compile(r"(\w*?)Feature(Nominal|Item|Measurement|Actual)", re.ASCII)
_PROFILE_VALUE = re.compile(r"PointProfileCharacteristic(?:Measurement|Actual)", re.ASCII)
_SAID = {
    "Points": ("Points", "BinaryPoints"),
    "Normals": ("Normals", "BinaryNormals"),
    "Compensated": ("Compensated", "Compensations", "BinaryCompensated"),
    "ProbeRadius": ("ProbeRadius", "ProbeRadii", "BinaryProbeRadii"),
}
"""Children of a point set, by what they say."""
_FLAGS = {"true": 1.0, "1": 1.0, "false": 0.0, "0": 0.0}
_OWN = " "
"""No id begins so, but those under which the touches that stand in a feature are kept."""
_UNSAID = array("d", [math.nan])
_FOREIGN_FRAMES = ("CoordinateSystemId", "TransformId", "TranformId", "Units")
"""Children of a point set that give it a frame or unit of its own; the schema of 3.0 has the third, misspelt."""

_NUMBER_CHARACTERS = str.maketrans("", "", "0123456789+-.eE \t\n\r")
_BLOCK = 1 << 18
_LARGEST = 1e9

Vector = tuple[float, float, float]
NO_VECTOR = (math.nan, math.nan, math.nan)


@dataclass(frozen=True, slots=True)
class Reference:
    """Points `first` to `last`, from 1, of a point set; `last` is 0 for all of them."""

    id: str
    line: int
    first: int = 1
    last: int = 0


@dataclass(slots=True)
class Feature:
    """Point feature in one of its roles, or any feature that was measured."""

    kind: str
    id: str
    line: int
    result: int
    """Which of the document's results holds it; -1 for none."""
    location: Vector | None = None
    normal: Vector | None = None
    reference: str = ""
    name: str = ""
    sets: tuple[Reference, ...] = ()
    unit: str = ""


@dataclass(slots=True)
class PointSet:
    """Measured point set: `count` rows from `first` of the document's `Touches`."""

    id: str
    line: int
    count: int
    unit: str
    result: int
    first: int

    @property
    def name(self) -> str:
        """What to call it: its id, or the feature whose own touches it holds."""
        return phrase("of feature {}", self.id.removeprefix(_OWN)) if self.id.startswith(_OWN) else self.id


class Touches:
    """Points of all sets, one after another, as they stand in the file.

    Attributes
    ----------
    points, normals : array of float
        Three a point; NaN for a normal that is not said.
    compensated : array of float
        1 or 0, NaN where it is not said.
    radius : array of float
        NaN where it is not said.
    lines : array of int
    """

    def __init__(self) -> None:
        self.points, self.normals = array("d"), array("d")
        self.compensated, self.radius = array("d"), array("d")
        self.lines = array("q")

    def __len__(self) -> int:
        return len(self.lines)

    def begin(self, line: int) -> None:
        """Begin a touch of which nothing is said yet."""
        self.lines.append(line)
        self.points.extend(NO_VECTOR)
        self.normals.extend(NO_VECTOR)
        self.compensated.append(math.nan)
        self.radius.append(math.nan)


@dataclass(slots=True)
class Unit:
    """Unit of length: its name, and its factor to metres."""

    line: int
    primary: bool
    name: str = ""
    factor: float = 1.0


class Document:
    """Collects from the stream of elements the few that matter: `root` says what is done with which."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.nominals: dict[str, Feature] = {}
        self.items: dict[str, Feature] = {}
        self.measured: dict[str, Feature] = {}
        self.sets: dict[str, PointSet] = {}
        self.touches = Touches()
        self.values: dict[str, float] = {}
        """Stored profile value by the feature measurement: the farthest from 0 where there are several."""
        self.units: list[Unit] = []
        self.results: list[tuple[str, int]] = []
        """Id and line of every MeasurementResults."""
        self.result = -1
        self.feature = Feature("", "", 0, -1)
        self.own = Touches()
        """Touches that stand in the feature that is open."""
        self.set = PointSet("", 0, 0, "", -1, 0)
        self.said: dict[str, array[float]] = {}
        """What the point set that is open has said."""
        self.valued: list[str] = []
        self.value: float | None = None
        self.span = ""
        """Which points of a set a reference means, as it stands there."""
        self.root = Element(self._anywhere)

    def forget(self) -> None:
        """Let go of all records, once they are not needed: else they stay until Python looks for cycles.

        The elements refer to the document, and the document to them.
        """
        vars(self).clear()

    # Where elements stand: what is done with those inside an element, by their names.

    def _anywhere(self, name: str) -> Element:
        """Elements that open a record, wherever they stand outside one."""
        role = _FEATURE.fullmatch(name)
        if role and role[1] and (role[1] in POINTS or role[2] in ("Measurement", "Actual")):
            return self._feature(role[1], {"Nominal": "nominals", "Item": "items"}.get(role[2], "measured"))
        if name == "MeasuredPointSet":
            fields = {name: self._set_field(key, name) for key, names in _SAID.items() for name in names}
            fields |= {name: self._foreign(name) for name in _FOREIGN_FRAMES}
            return Element(fields.get, begin=self._open_set, end=self._close_set)
        if _PROFILE_VALUE.fullmatch(name):
            ids = Element({"Id": Element(text=lambda content, _: self.valued.append(content.strip()))}.get)
            value = Element(text=self._take_value)
            return Element(
                lambda name: value if name == "Value" else ids if name.startswith("Feature") else None,
                begin=self._open_value, end=self._close_value,
            )  # fmt: skip
        if name == "FileUnits":
            return self._units(primary=False)
        if name == "MeasurementResults":
            return Element(self._anywhere, begin=self._open_result, end=self._close_result)
        return self.root

    def _units(self, *, primary: bool) -> Element:
        """FileUnits, or the PrimaryUnits among them."""
        fields = {"UnitName": Element(text=self._take_unit_name), "Factor": Element(text=self._take_factor)}
        unit = Element(lambda name: fields.get(name, unit_part))
        unit_part = Element(unit.inside)
        unit.begin, unit.idle = lambda _, line: self.units.append(Unit(line, primary)), False

        def inside(name: str) -> Element:
            if name == "LinearUnit":
                return unit
            return self._units(primary=True) if name == "PrimaryUnits" else units

        units = Element(inside)
        return units

    def _feature(self, kind: str, name: str) -> Element:
        def begin(attributes: dict[str, str], line: int) -> None:
            self.feature = Feature(kind, self._id(attributes, line), line, self.result)

        def end() -> None:
            feature, group = self.feature, getattr(self, name)
            self._once(feature.id, group, feature.line)
            group[feature.id] = feature
            if self.own:
                if name == "measured":
                    self._add_touches(feature)
                self.own = Touches()

        fields = {
            "Location": Element(begin=self._open_location, text=self._take_location),
            "Normal": Element(text=self._take_normal),
            "FeatureNominalId": Element(text=self._take_reference),
            "FeatureItemId": Element(text=self._take_reference),
            "FeatureName": Element(text=self._take_name),
        }
        referred = Element(begin=self._open_reference, text=self._take_set)

        def refers(name: str) -> Element | None:
            return referred if name.endswith("PointSetId") else None

        touched = {
            "Point": Element(text=self._take_touch),
            "Normal": Element(text=self._take_direction),
            "Compensated": Element(text=self._take_touch_flag),
            "ProbeRadius": Element(text=self._take_touch_radius),
        }
        touch = Element(touched.get, begin=lambda _, line: self.own.begin(line))
        fields["PointList"] = Element(lambda name: touch if name == "MeasurePoint" else refers(name))
        others = Element(refers)
        return Element(lambda name: fields.get(name, others), begin=begin, end=end)

    # What is done with elements.

    def _open_result(self, attributes: dict[str, str], line: int) -> None:
        self.results.append((attributes.get("id", "").strip()[:40], line))
        self.result = len(self.results) - 1

    def _close_result(self) -> None:
        self.result = -1

    def _open_location(self, attributes: dict[str, str], _: int) -> None:
        if "linearUnit" in attributes:
            self.feature.unit = attributes["linearUnit"]

    def _take_location(self, content: str, line: int) -> None:
        self.feature.location = self._three(content, self.feature.id, line)

    def _take_normal(self, content: str, line: int) -> None:
        self.feature.normal = self._three(content, self.feature.id, line)

    def _take_reference(self, content: str, _: int) -> None:
        self.feature.reference = content.strip()

    def _take_name(self, content: str, _: int) -> None:
        self.feature.name = content.strip()

    def _open_reference(self, attributes: dict[str, str], _: int) -> None:
        self.span = attributes.get("range", attributes.get("index", ""))

    def _take_set(self, content: str, line: int) -> None:
        self.feature.sets += (self._referred(content.strip(), line),)

    def _open_value(self, *_: object) -> None:
        self.valued.clear()
        self.value = None

    def _take_value(self, content: str, line: int) -> None:
        self.value = self._number(content, "", line)

    def _close_value(self) -> None:
        if self.value is not None:
            for label in self.valued:
                if abs(self.value) >= abs(self.values.get(label, 0.0)):
                    self.values[label] = self.value

    def _take_unit_name(self, content: str, _: int) -> None:
        self.units[-1].name = content.strip()

    def _take_factor(self, content: str, line: int) -> None:
        factor = self.units[-1].factor = self._number(content, "", line)
        if not 1e-9 <= factor <= 1e3:
            self._refuse(phrase("{:g} m is no unit of length", factor), line)

    def _id(self, attributes: dict[str, str], line: int) -> str:
        label = attributes.get("id", "").strip()
        if not label:
            self._refuse(phrase("a feature or point set has no id"), line)
        return label[:40]

    def _once(self, label: str, group: dict[str, Feature] | dict[str, PointSet], line: int) -> None:
        if label in group:
            self._refuse(phrase("id {} is there twice, first in line {}", shown(label), group[label].line), line)

    def _referred(self, label: str, line: int) -> Reference:
        if not self.span.strip():
            return Reference(label, line)
        ends = self.span.split()
        if not all(re.fullmatch(r"\d{1,9}", end, re.ASCII) for end in ends) or len(ends) > 2:
            self._refuse(phrase("{} is no range of points of set {}", shown(self.span), label), line)
        return Reference(label, line, int(ends[0]), int(ends[-1]))

    # Children of a MeasurePoint, in which documents of 2.x give every touch of a feature.

    def _take_touch(self, content: str, line: int) -> None:
        self.own.points[-3:] = array("d", self._three(content, self.feature.id, line))

    def _take_direction(self, content: str, line: int) -> None:
        self.own.normals[-3:] = array("d", self._three(content, self.feature.id, line))

    def _take_touch_radius(self, content: str, line: int) -> None:
        self.own.radius[-1] = self._number(content, self.feature.id, line)

    def _take_touch_flag(self, content: str, line: int) -> None:
        flag = _FLAGS.get(content.strip())
        if flag is None:
            self._refuse(
                phrase("feature {}: Compensated {} is not true or false", self.feature.id, shown(content)), line
            )
        self.own.compensated[-1] = flag

    def _add_touches(self, feature: Feature) -> None:
        """Put the touches that stand in a feature among the point sets, and refer to them."""
        own, label = self.own, _OWN + feature.id
        self.set = PointSet(label, feature.line, len(own), feature.unit, feature.result, len(self.touches))
        unsaid = [math.isnan(flag) for flag in own.compensated]
        for x, line, flagless in zip(own.points[::3], own.lines, unsaid, strict=True):
            if math.isnan(x):
                self._refuse(phrase("a MeasurePoint of feature {} has no Point", feature.id), line)
            if flagless != unsaid[0]:
                self._refuse(
                    phrase("a MeasurePoint of feature {} lacks Compensated, or all others do", feature.id), line
                )
        self.said.update(zip(_SAID, (own.points, own.normals, own.compensated, own.radius), strict=True))
        self.touches.lines.extend(own.lines)
        self._add_set()
        feature.sets += (Reference(label, feature.line),)

    def _open_set(self, attributes: dict[str, str], line: int) -> None:
        label, count = self._id(attributes, line), attributes.get("count", "")
        if not count.isdecimal() or not count.isascii() or len(count) > 9:
            self._refuse(phrase("point set {} has no count", label), line)
        self.set = PointSet(
            label, line, int(count), attributes.get("linearUnit", ""), self.result, len(self.touches)
        )  # fmt: skip
        self.said.clear()

    def _close_set(self) -> None:
        found = self.set
        self._once(found.id, self.sets, found.line)
        if "Points" not in self.said:
            self._refuse(phrase("point set {} has no Points", found.id), found.line)
        self.touches.lines.extend(array("q", [found.line]) * found.count)
        self._add_set()

    def _add_set(self) -> None:
        """Put what the set that is open has said among the touches."""
        found, said = self.set, self.said
        compensated, radius = said.get("Compensated", _UNSAID), said.get("ProbeRadius", _UNSAID)
        if not all(compensated) or compensated is _UNSAID:
            for r in radius:
                if r <= 0:
                    self._refuse(phrase("point set {}: its ProbeRadius is not positive", found.name), found.line)
        table, n = self.touches, found.count
        if len(table.points):
            table.points.extend(said.pop("Points"))
        else:
            table.points = said.pop("Points")
        table.normals.extend(said.pop("Normals") if "Normals" in said else array("d", NO_VECTOR) * n)
        table.compensated.extend(compensated if len(compensated) == n else compensated * n)
        table.radius.extend(radius if len(radius) == n else radius * n)
        self.sets[found.id] = found
        said.clear()

    def _foreign(self, name: str) -> Element:
        def refuse(_: dict[str, str], line: int) -> None:
            self._refuse(
                phrase(
                    "point set {} has its own {}: export the points in the common frame and unit", self.set.id, name
                ),
                line,
            )

        return Element(begin=refuse)

    def _set_field(self, key: str, name: str) -> Element:
        said = self.said
        width = 1 if key in ("Compensated", "ProbeRadius") else 3

        def take_binary(content: str, line: int) -> None:
            said[key] = self._binary(name, content, line, width * self.set.count)

        def take_flags(content: str, line: int) -> None:
            words = content.split()
            if not words or not _FLAGS.keys() >= set(words) or len(words) not in (1, self.set.count):
                self._refuse(
                    phrase("point set {}: {} {} is not true or false", self.set.id, name, shown(content)), line
                )
            said[key] = array("d", [_FLAGS[word] for word in words])

        def take_radius(content: str, line: int) -> None:
            said[key] = array("d", (self._number(content, self.set.id, line),))

        def take_numbers(content: str, line: int) -> None:
            n, label = width * self.set.count, self.set.id
            said[key] = array("d", self._three(content, label, line)) if n == 3 == width else self._numbers(
                content, label, line, n
            )  # fmt: skip

        if name.startswith("Binary"):
            return Element(text=take_binary)
        if key == "Compensated":
            return Element(text=take_flags)
        return Element(text=take_radius if name == "ProbeRadius" else take_numbers)

    def _binary(self, name: str, content: str, line: int, width: int) -> array[float]:
        n, label = self.set.count, self.set.id
        try:
            data = base64.b64decode("".join(content.split()), validate=True)
        except (binascii.Error, ValueError):
            self._refuse(phrase("point set {}: {} is no base64", label, name), line)
        if name == "BinaryCompensated":
            if len(data) != n:
                self._refuse(phrase("point set {}: {} has {} bytes for {} points", label, name, len(data), n), line)
            return array("d", (np.frombuffer(data, np.uint8) != 0).astype(np.float64).tobytes())
        if not width or len(data) not in (4 * width, 8 * width):
            self._refuse(phrase("point set {}: {} has {} bytes for {} points", label, name, len(data), n), line)
        numbers = np.frombuffer(data, "<f8" if len(data) == 8 * width else "<f4").astype(np.float64)
        self._refuse_absurd(numbers, phrase("point set {}: ", label), line)
        return array("d", numbers.tobytes())

    def _numbers(self, text: str, label: str, line: int, count: int) -> array[float]:
        """Exactly `count` numbers; long lists by the block, for the memory's sake."""
        owner = phrase("element {}: ", label) if label else ""
        out = array("d")
        position = 0
        while position < len(text):
            end = position + _BLOCK
            while end < len(text) and not text[end].isspace():
                end += 1
            block = text[position:end]
            position = end
            spoilt = block.translate(_NUMBER_CHARACTERS)
            try:
                numbers = np.array(block.split(), dtype=np.float64) if not spoilt else np.zeros(0)
            except ValueError:
                spoilt = block
            if spoilt:
                word = next((w for w in block.split() if not _is_number(w)), spoilt)
                self._refuse(phrase("{}{} is no number", owner, shown(word)), line)
            self._refuse_absurd(numbers, owner, line)
            out.frombytes(numbers.tobytes())
        if len(out) != count:
            self._refuse(phrase("{}{} numbers where {} were expected", owner, len(out), count), line)
        return out

    def _number(self, text: str, label: str, line: int) -> float:
        try:
            number = float(text)
        except ValueError:
            number = math.inf
        if -_LARGEST <= number <= _LARGEST and text.isascii() and "_" not in text:
            return number
        return self._numbers(text, label, line, 1)[0]

    def _three(self, text: str, label: str, line: int) -> Vector:
        """Most documents hold nothing but these, by the hundred thousand."""
        try:
            x, y, z = map(float, text.split())
        except ValueError:
            x = y = z = math.inf
        if (
            -_LARGEST <= x <= _LARGEST and -_LARGEST <= y <= _LARGEST and -_LARGEST <= z <= _LARGEST
            and text.isascii() and "_" not in text
        ):  # fmt: skip
            return x, y, z
        x, y, z = self._numbers(text, label, line, 3)
        return x, y, z

    def _refuse_absurd(self, numbers: Floats, owner: str, line: int) -> None:
        wrong = numbers[~(np.abs(numbers) <= _LARGEST)]
        if len(wrong):
            self._refuse(phrase("{}{:g} is no length that a machine can travel", owner, wrong[0]), line)

    def _refuse(self, message: str, line: int) -> NoReturn:
        raise self.source.error(message, line)


def _is_number(word: str) -> bool:
    return NUMBER.fullmatch(word) is not None
