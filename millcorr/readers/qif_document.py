# SPDX-License-Identifier: LGPL-2.1-or-later
"""What matters of a QIF document: features, point sets, profile values and units, as they stand in the file."""

from __future__ import annotations

import base64
import binascii
import math
import re
from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import repeat
from typing import NoReturn

import numpy as np

from millcorr.arrays import Floats
from millcorr.messages import phrase

from .fields import NUMBER
from .source import Source, shown
from .xml_events import NOTHING, Element

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
_KEYS = {name: key for key, names in _SAID.items() for name in names}
_FLAGS = {"true": 1.0, "1": 1.0, "false": 0.0, "0": 0.0}
_OWN = " "
"""No id begins so, but those under which the touches that stand in a feature are kept."""
_UNSAID = (math.nan,)
_FOREIGN_FRAMES = ("CoordinateSystemId", "TransformId", "TranformId", "Units")
"""Children of a point set that give it a frame or unit of its own; the schema of 3.0 has the third, misspelt."""

_NUMBER_CHARACTERS = str.maketrans("", "", "0123456789+-.eE \t\n\r")
_BLOCK = 1 << 18
_LARGEST = 1e9

Vector = tuple[float, float, float]
NO_VECTOR = (math.nan, math.nan, math.nan)


class Features:
    """Point features in one of their roles, or all features that were measured: a row each.

    Columns, for there are hundreds of thousands: an object each would take longer than the file's XML.

    Attributes
    ----------
    rows : dict of str to int
        Row by id.
    kinds, references, names, units : list of str
        Empty where the file says none.
    lines, results : array of int
        Results: which of the document's holds it; -1 for none.
    locations, normals : array of float
        Three a row; NaN where the file says none.
    """

    def __init__(self) -> None:
        self.rows: dict[str, int] = {}
        self.kinds: list[str] = []
        self.references: list[str] = []
        self.names: list[str] = []
        self.units: list[str] = []
        self.lines, self.results = array("q"), array("q")
        self.locations, self.normals = array("d"), array("d")

    def __len__(self) -> int:
        return len(self.lines)


class References:
    """Points `first` to `last`, from 1, of the point set `ids` that a row of the measured `features` refers to.

    `last` is 0 for all of them.
    """

    def __init__(self) -> None:
        self.ids: list[str] = []
        self.features, self.lines = array("q"), array("q")
        self.first, self.last = array("q"), array("q")

    def add(self, feature: int, label: str, line: int, first: int = 1, last: int = 0) -> None:
        """Add a reference."""
        self.ids.append(label)
        self.features.append(feature)
        self.lines.append(line)
        self.first.append(first)
        self.last.append(last)


class PointSets:
    """Measured point sets: a row each, of `counts` rows from `first` of the document's `Touches`."""

    def __init__(self) -> None:
        self.rows: dict[str, int] = {}
        self.units: list[str] = []
        self.lines, self.results = array("q"), array("q")
        self.counts, self.first = array("q"), array("q")

    def __len__(self) -> int:
        return len(self.lines)

    def add(self, label: str, line: int, result: int, unit: str, count: int, first: int) -> None:
        """Add a set."""
        self.rows[label] = len(self.lines)
        self.units.append(unit)
        self.lines.append(line)
        self.results.append(result)
        self.counts.append(count)
        self.first.append(first)


def set_name(label: str) -> str:
    """What to call a point set: its id, or the feature whose own touches it holds."""
    return phrase("of feature {}", label.removeprefix(_OWN)) if label.startswith(_OWN) else label


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
        self.nominals, self.items, self.measured = Features(), Features(), Features()
        self.references = References()
        self.sets = PointSets()
        self.touches = Touches()
        self.values: dict[str, float] = {}
        """Stored profile value by the feature measurement: the farthest from 0 where there are several."""
        self.units: list[Unit] = []
        self.results: list[tuple[str, int]] = []
        """Id and line of every MeasurementResults."""
        self.result = -1
        self.id, self.line, self.unit = "", 0, ""
        """Of the feature or point set that is open."""
        self.count = 0
        """Points of the point set that is open."""
        self.before = 0
        """Touches before the feature that is open."""
        self.said: dict[str, str] = {}
        """Text of the elements inside the record that is open, by their names."""
        self.touch: dict[str, str] = {}
        """As `said`, of the MeasurePoint that is open inside a feature."""
        self.valued: list[str] = []
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
            fields = self._kept(self.said, *(name for names in _SAID.values() for name in names))
            inside = fields | {name: self._foreign(name) for name in _FOREIGN_FRAMES}
            return Element(inside.get, begin=self._open_set, end=partial(self._close_set, fields))
        if _PROFILE_VALUE.fullmatch(name):
            ids = Element({"Id": Element(text=self.valued.append)}.get)
            value = self._kept(self.said, "Value")["Value"]
            return Element(
                lambda name: value if name == "Value" else ids if name.startswith("Feature") else None,
                begin=self._open_value, end=partial(self._close_value, value),
            )  # fmt: skip
        if name == "FileUnits":
            return self._units(primary=False)
        if name == "MeasurementResults":
            return Element(self._anywhere, begin=self._open_result, end=self._close_result)
        return self.root

    @staticmethod
    def _kept(said: dict[str, str], *names: str) -> dict[str, Element]:
        """Elements whose text is kept by their names until their record ends."""
        return {name: Element(text=partial(said.__setitem__, name)) for name in names}

    def _units(self, *, primary: bool) -> Element:
        """FileUnits, or the PrimaryUnits among them."""
        factor = Element(text=lambda content: self._take_factor(content, factor.line))
        fields = {"UnitName": Element(text=self._take_unit_name), "Factor": factor}
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
        fields = self._kept(self.said, "Location", "Normal", "FeatureNominalId", "FeatureItemId", "FeatureName")
        fields["Location"].begin = self._open_location
        inside, others = dict(fields), NOTHING
        if name == "measured":
            referred = Element(begin=self._open_reference, text=lambda content: self._take_set(content, referred.line))

            def refers(name: str) -> Element | None:
                return referred if name.endswith("PointSetId") else None

            told = self._kept(self.touch, "Point", "Normal", "Compensated", "ProbeRadius")
            touch = Element(told.get, begin=self._open_touch)
            touch.end = partial(self._close_touch, touch, told)
            inside["PointList"] = Element(lambda name: touch if name == "MeasurePoint" else refers(name))
            others = Element(refers)

        def begin(attributes: dict[str, str], line: int) -> None:
            self.said.clear()
            self.id, self.line, self.unit = self._id(attributes, line), line, ""
            self.before = len(self.touches)

        def end() -> None:
            said, label, group = self.said, self.id, getattr(self, name)
            self._once(label, group.rows, group.lines)
            location, normal = said.get("Location"), said.get("Normal")
            group.locations.extend(
                NO_VECTOR if location is None else self._three(location, label, fields["Location"].line)
            )
            group.normals.extend(NO_VECTOR if normal is None else self._three(normal, label, fields["Normal"].line))
            reference = said.get("FeatureItemId") or said.get("FeatureNominalId", "")
            group.references.append(reference.strip())
            group.names.append(said.get("FeatureName", "").strip())
            group.kinds.append(kind)
            group.units.append(self.unit)
            if len(self.touches) > self.before:
                self._add_own_set(len(group))
            group.rows[label] = len(group)
            group.results.append(self.result)
            group.lines.append(self.line)

        return Element(lambda name: inside.get(name, others), begin=begin, end=end)

    # What is done with elements.

    def _open_result(self, attributes: dict[str, str], line: int) -> None:
        self.results.append((attributes.get("id", "").strip()[:40], line))
        self.result = len(self.results) - 1

    def _close_result(self) -> None:
        self.result = -1

    def _open_location(self, attributes: dict[str, str], _: int) -> None:
        if "linearUnit" in attributes:
            self.unit = attributes["linearUnit"]

    def _open_reference(self, attributes: dict[str, str], _: int) -> None:
        self.span = attributes.get("range", attributes.get("index", ""))

    def _take_set(self, content: str, line: int) -> None:
        label, ends = content.strip(), self.span.split()
        if not all(re.fullmatch(r"\d{1,9}", end, re.ASCII) for end in ends) or len(ends) > 2:
            self._refuse(phrase("{} is no range of points of set {}", shown(self.span), label), line)
        self.references.add(len(self.measured), label, line, *(int(end) for end in (ends[:1] + ends[-1:])))

    def _open_value(self, *_: object) -> None:
        self.valued.clear()
        self.said.clear()

    def _close_value(self, element: Element) -> None:
        content = self.said.get("Value")
        if content is not None:
            value = self._number(content, "", element.line)
            for label in map(str.strip, self.valued):
                if abs(value) >= abs(self.values.get(label, 0.0)):
                    self.values[label] = value

    def _take_unit_name(self, content: str) -> None:
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

    def _once(self, label: str, rows: dict[str, int], lines: array[int]) -> None:
        if label in rows:
            self._refuse(phrase("id {} is there twice, first in line {}", shown(label), lines[rows[label]]), self.line)

    # A MeasurePoint, in which documents of 2.x give every touch of a feature.

    def _open_touch(self, *_: object) -> None:
        self.touch.clear()

    def _close_touch(self, element: Element, fields: dict[str, Element]) -> None:
        said, label, table = self.touch, self.id, self.touches
        point, normal, flag, radius = map(said.get, fields)
        if point is None:
            self._refuse(phrase("a MeasurePoint of feature {} has no Point", label), element.line)
        table.points.extend(self._three(point, label, fields["Point"].line))
        table.normals.extend(NO_VECTOR if normal is None else self._three(normal, label, fields["Normal"].line))
        if flag is not None and flag.strip() not in _FLAGS:
            self._refuse(
                phrase("feature {}: Compensated {} is not true or false", label, shown(flag)),
                fields["Compensated"].line,
            )
        table.compensated.append(math.nan if flag is None else _FLAGS[flag.strip()])
        table.radius.append(math.nan if radius is None else self._number(radius, label, fields["ProbeRadius"].line))
        table.lines.append(element.line)

    def _add_own_set(self, feature: int) -> None:
        """Put the touches that stand in a feature among the point sets, and refer to them."""
        first, label = self.before, _OWN + self.id
        count = len(self.touches) - first
        unsaid = list(map(math.isnan, self.touches.compensated[first:]))
        if 0 < sum(unsaid) < count:
            self._refuse(
                phrase("a MeasurePoint of feature {} lacks Compensated, or all others do", self.id),
                self.touches.lines[first + unsaid.index(not unsaid[0])],
            )
        self.sets.add(label, self.line, self.result, self.unit, count, first)
        self.references.add(feature, label, self.line)

    # A MeasuredPointSet.

    def _open_set(self, attributes: dict[str, str], line: int) -> None:
        label, count = self._id(attributes, line), attributes.get("count", "")
        if not count.isdecimal() or not count.isascii() or len(count) > 9:
            self._refuse(phrase("point set {} has no count", label), line)
        self.id, self.line, self.unit, self.count = label, line, attributes.get("linearUnit", ""), int(count)
        self.said.clear()

    def _close_set(self, fields: dict[str, Element]) -> None:
        """Put what the set has said among the touches."""
        label, n, table = self.id, self.count, self.touches
        self._once(label, self.sets.rows, self.sets.lines)
        said: dict[str, Sequence[float]] = {}
        for name in list(self.said):
            # A long text is let go of once its numbers are there.
            said[_KEYS[name]] = self._set_field(name, self.said.pop(name), fields[name].line)
        if "Points" not in said:
            self._refuse(phrase("point set {} has no Points", label), self.line)
        self.sets.add(label, self.line, self.result, self.unit, n, len(table))
        points = said.pop("Points")
        if isinstance(points, array) and not table.points:
            table.points = points
        else:
            table.points.extend(points)
        table.normals.extend(said.pop("Normals") if "Normals" in said else repeat(math.nan, 3 * n))
        for key, column in (("Compensated", table.compensated), ("ProbeRadius", table.radius)):
            values = said.get(key, _UNSAID)
            column.extend(values if len(values) == n else repeat(values[0], n))
        table.lines.extend(repeat(self.line, n))

    def _foreign(self, name: str) -> Element:
        def refuse(_: dict[str, str], line: int) -> None:
            self._refuse(
                phrase("point set {} has its own {}: export the points in the common frame and unit", self.id, name),
                line,
            )

        return Element(begin=refuse)

    def _set_field(self, name: str, content: str, line: int) -> Sequence[float]:
        """Numbers of a child of the point set that is open: one, or as many as its points have."""
        if name == "Points" and self.count == 1:
            return self._three(content, self.id, line)
        if name == "ProbeRadius":
            return (self._number(content, self.id, line),)
        key = _KEYS[name]
        n = self.count if key in ("Compensated", "ProbeRadius") else 3 * self.count
        if name.startswith("Binary"):
            return self._binary(name, content, line, n)
        if key != "Compensated":
            return self._numbers(content, self.id, line, n)
        if content in _FLAGS:
            return (_FLAGS[content],)
        words = content.split()
        if not words or not _FLAGS.keys() >= set(words) or len(words) not in (1, self.count):
            self._refuse(phrase("point set {}: {} {} is not true or false", self.id, name, shown(content)), line)
        return array("d", map(_FLAGS.__getitem__, words))

    def _binary(self, name: str, content: str, line: int, width: int) -> array[float]:
        n, label = self.count, self.id
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
