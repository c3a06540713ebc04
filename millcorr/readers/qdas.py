# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q-DAS files (AQDEF, ``.dfq``): characteristics with one number each, put together to points by their names.

``P1.X``, ``P1.Y`` and ``P1.Z`` are one point. A part may have been measured several times, and a file may hold
several parts; each of these is one measured part, and all are counted through from 1.
"""

from __future__ import annotations

import re
import sys
from array import array

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decoding import lines_of
from .fields import NUMBER, why_no_number
from .parts import chosen_part
from .source import Source, shown

_RECOGNISED = re.compile(rb"(?:^|[\r\n])[ \t]*K0100(?:/\d+)?[ \t]+\d+[ \t]*[\r\n]")
_FIELD = re.compile(r"K(\d{4})(?:/(\d{1,6}))?(?:/\d{1,6})?(?:[ \t]+(.*))?", re.ASCII)

# Shift in stands between characteristics, device control 4 within one; no text holds them, so others take their place.
_SEPARATORS = bytes.maketrans(b"\x0f\x14", b"\x1e\x1f")
_CHARACTERISTIC, _ATTRIBUTE = "\x1e", "\x1f"

_AXIS = r"(?P<axis>[XYZ])"
_WORD = r"(?:[\s._:-]*(?:value|wert|actual|ist|coord(?:inate)?|koord(?:inate)?))?"
_NAMES = (
    re.compile(rf"(?P<stem>.*?[^\s._:/-])[\s._:/-]+{_AXIS}{_WORD}", re.IGNORECASE),
    re.compile(rf"(?P<stem>.*?\d){_AXIS}", re.IGNORECASE),
    re.compile(rf"{_AXIS}{_WORD}[\s._:/-]+(?P<stem>\S.*)", re.IGNORECASE),
)
_UNITS = {"mm": "mm", "millimeter": "mm", "inch": "inch", "in": "inch", '"': "inch"}

_NAME, _TEXT, _NOMINAL, _UNIT = 2001, 2002, 2101, 2142
_VALUE, _VALIDITY = 1, 2
_NOT_MEASURED = ("255", "256")
_MOST = 1_000_000


_Point = list[int]
"""Characteristics of X, Y and Z by their places among all; -1 for none."""


def recognises(data: bytes) -> bool:
    """Whether a file has the number of characteristics, K0100, that every Q-DAS file begins with."""
    return bool(_RECOGNISED.search(data[:65536].replace(b"\x00", b"").lstrip(b"\xef\xbb\xbf\xff\xfe")))


def read(source: Source) -> Measurement:
    """Points of one measured part from a Q-DAS file.

    Parameters
    ----------
    source : Source
        Says which part where the file holds several, and what the points are: the file does not.

    Returns
    -------
    Measurement
        With nominal points where all coordinates have one; without normals.

    Raises
    ------
    FormatError
        If no characteristics make points, or a field cannot be trusted.
    UsageError
        If the file holds several parts and `source` does not choose, or chooses one that is not there.
    """
    reading = _Reading(source)
    for number, line in enumerate(lines_of(_text(source)), 1):
        reading.line(number, line)
    return reading.measurement()


def _text(source: Source) -> str:
    data = source.data.translate(_SEPARATORS)
    return Source(data, source.name, source.digest).text()


class _Reading:
    """State of reading: characteristics in the order of the file, and the part that the next ones belong to."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.places: dict[int, int] = {}
        """Place of each characteristic by its number."""
        self.begins = array("q")
        self.part_of = array("q")
        self.texts: dict[int, dict[int, str]] = {key: {} for key in (_NAME, _TEXT, _UNIT)}
        """What K2xxx say, by field and place; -1 for all."""
        self.nominal: dict[int, float] = {}
        self.order: list[int] | None = None
        self.owners = array("q")
        self.values = array("d")
        self.lines = array("q")
        """Place, value (NaN where not measured) and line of all values in the order of the file."""
        self.parts: dict[int, str] = {}
        self.part = 1
        self.stated: tuple[int, int] | None = None

    def line(self, number: int, line: str) -> None:
        bare = line.strip(" \t")
        if not bare:
            return
        if not bare.startswith("K"):
            self._values(number, bare)
            return
        found = _FIELD.fullmatch(bare)
        if found is None:
            raise self.source.error(phrase("{} is neither a K field nor a line of values", shown(bare)), number)
        key, index, content = int(found[1]), int(found[2] or 0), (found[3] or "").strip(" \t")
        if key == 100:
            if not (content.isdecimal() and content.isascii() and 0 < int(content[:9]) <= _MOST):
                raise self.source.error(phrase("K0100 {} is no number of characteristics", shown(content)), number)
            self.stated = int(content), number
        elif 1000 <= key < 2000:
            self.part = index or self.part
            if key in (1001, 1002):
                self.parts[self.part] = self.parts.get(self.part) or content
        elif 2000 <= key < 3000:
            self._property(key, index, content, number)
        elif key == _VALUE:
            if _CHARACTERISTIC in content or not index:
                self._values(number, content)
            else:
                self._value(self._place(index, number), content, number)
        elif key == _VALIDITY and index:
            self._validity(self._place(index, number), content)

    def _property(self, key: int, index: int, content: str, number: int) -> None:
        if index and index not in self.places:
            self.places[index] = len(self.begins)
            self.begins.append(number)
            self.part_of.append(self.part)
            self.order = None
        place = self.places[index] if index else -1
        if key == _NOMINAL and index and content:
            nominal = self._number(content, number)
            if self.nominal.setdefault(place, nominal) != nominal:
                raise self.source.error(phrase("K{}/{} is there twice with different contents", key, index), number)
        elif key in self.texts:
            content = sys.intern(content) if key == _UNIT else content
            if self.texts[key].setdefault(place, content) != content:
                raise self.source.error(phrase("K{}/{} is there twice with different contents", key, index), number)

    def _place(self, index: int, number: int) -> int:
        place = self.places.get(index)
        if place is None:
            raise self.source.error(phrase("a value of characteristic {}, which no K2 field describes", index), number)
        return place

    def _values(self, number: int, line: str) -> None:
        """A line with a value of every characteristic, in the order of their numbers."""
        if self.order is None:
            self.order = [self.places[index] for index in sorted(self.places)]
        fields = line.split(_CHARACTERISTIC)
        if len(fields) == len(self.order) + 1 and not fields[-1].strip():
            fields.pop()
        if len(fields) != len(self.order):
            raise self.source.error(
                phrase(
                    "{} values for {} characteristics: the line is incomplete, or this is no line of values",
                    len(fields),
                    len(self.order),
                ),
                number,
            )
        for place, content in zip(self.order, fields, strict=True):
            value, _, attributes = content.partition(_ATTRIBUTE)
            self._value(place, value, number)
            self._validity(place, attributes.partition(_ATTRIBUTE)[0].strip())

    def _value(self, place: int, content: str, number: int) -> None:
        content = content.partition(_ATTRIBUTE)[0].strip()
        self.owners.append(place)
        self.values.append(self._number(content, number) if content else np.nan)
        self.lines.append(number)

    def _validity(self, place: int, content: str) -> None:
        if content in _NOT_MEASURED and self.owners and self.owners[-1] == place:
            self.values[-1] = np.nan

    def _number(self, content: str, number: int) -> float:
        plain = content.replace(",", ".") if content.count(",") == 1 and "." not in content else content
        if not NUMBER.fullmatch(plain):
            raise self.source.error(why_no_number(content, None), number)
        value = float(plain)
        if not np.isfinite(value):
            raise self.source.error(phrase("{} is too large", shown(content)), number)
        return value

    # --- from characteristics to points -------------------------------------------------------------------

    def measurement(self) -> Measurement:
        source = self.source
        if self.stated is not None and self.stated[0] != len(self.begins):
            raise source.error(
                phrase(
                    "K0100 says {} characteristics, there are {}: the file was cut off or put together",
                    self.stated[0],
                    len(self.begins),
                ),
                self.stated[1],
            )
        points, left_out = self._points()
        # Values sorted by characteristic, each one's in the order of the file.
        owners = np.array(self.owners, dtype=np.int64)
        order = np.argsort(owners, kind="stable")
        first = np.searchsorted(owners[order], np.arange(len(self.begins) + 1))
        chosen, piece = self._choice(points, np.diff(first))
        unit = source.unit(self._unit(points))
        ball_radius = source.ball_radius()
        groups = points[chosen]
        has_z = self._has_z(groups)
        places = np.array(list(groups.values()))[:, : 2 + has_z]
        at = first[places] + piece
        there = at < first[places + 1]
        at = order[np.where(there, at, 0)]
        coordinates = np.where(there, np.array(self.values)[at], np.nan)
        measured = ~np.isnan(coordinates).any(axis=1)
        if not measured.any():
            raise source.error(phrase("none of the points was measured on this part"))
        ideal = np.array([[self.nominal.get(place, np.nan) for place in row] for row in places[measured].tolist()])
        ideal[np.isnan(ideal).any(axis=1)] = np.nan
        names = list(groups)
        notes = [phrase("{} characteristics are no coordinate of a point", left_out)] if left_out else []
        if not measured.all():
            notes.append(phrase("{} points were not measured on this part", np.count_nonzero(~measured)))
        return source.measurement(
            "qdas", _with_z(coordinates[measured]), np.array(self.lines)[at[measured, 0]],
            ball_radius=ball_radius, unit=unit, has_z=has_z, notes=notes,
            elements=[names[row] for row in np.flatnonzero(measured)],
            nominal=None if np.isnan(ideal).all() else _with_z(ideal),
        )  # fmt: skip

    def _points(self) -> tuple[dict[int, dict[str, _Point]], int]:
        """Characteristics by part, name of the point and axis; and how many are none of a point."""
        texts = max(
            (self.texts[key] for key in (_NAME, _TEXT)), key=lambda t: sum(_axis(x) is not None for x in t.values())
        )
        grouped: dict[int, dict[str, _Point]] = {}
        for index in sorted(self.places):
            place = self.places[index]
            found = _axis(texts.get(place, ""))
            if found is None:
                continue
            stem, axis = found
            point = grouped.setdefault(self.part_of[place], {}).setdefault(stem, [-1, -1, -1])
            if point[axis] >= 0:
                raise self.source.error(
                    phrase(
                        "{} of point {} is there twice, first in line {}",
                        "XYZ"[axis],
                        shown(stem),
                        self.begins[point[axis]],
                    ),
                    self.begins[place],
                )
            point[axis] = place
        points: dict[int, dict[str, _Point]] = {}
        used = 0
        for part, groups in grouped.items():
            whole = {stem: group for stem, group in groups.items() if min(group[:2]) >= 0}
            used += sum(3 - group.count(-1) for group in whole.values())
            if whole:
                points[part] = whole
        if not points:
            raise self.source.error(
                phrase("no points: name the characteristics of a point alike with X, Y and Z, such as P1.X, P1.Y, P1.Z")
            )
        return points, len(self.begins) - used

    def _choice(self, points: dict[int, dict[str, _Point]], counts: Ints) -> tuple[int, int]:
        """Part and piece, from 0, that the caller wants; `counts` has the number of values of each place."""
        pieces: list[tuple[int, int]] = []
        titles: list[str] = []
        for part, groups in points.items():
            times = self._times(groups, counts)
            name = self.parts.get(part)
            pieces += [(part, piece) for piece in range(times)]
            titles += [(phrase("part {}", shown(name)) if name else phrase("part {}", part))] * times
        if not pieces:
            raise self.source.error(phrase("no values: the file describes characteristics and holds no results"))
        return pieces[chosen_part(self.source, titles)]

    def _times(self, groups: dict[str, _Point], counts: Ints) -> int:
        """How often a part was measured; FormatError where that is not the same for all its points."""
        named = [
            (stem, axis, place)
            for stem, group in groups.items()
            for axis, place in zip("XYZ", group, strict=True)
            if place >= 0
        ]
        own = counts[[place for _, _, place in named]]
        times = int(own.max())
        if (own < times).any():
            stem, axis, place = named[int(np.flatnonzero(own < times)[0])]
            raise self.source.error(
                phrase(
                    "{} of point {} has {} of {} values: the file was cut off, or K0002 256 is missing for a "
                    "point that was not measured",
                    axis,
                    shown(stem),
                    counts[place],
                    times,
                ),
                self.begins[place],
            )
        return times

    def _unit(self, points: dict[int, dict[str, _Point]]) -> str | None:
        found: dict[str, int] = {}
        texts = self.texts[_UNIT]
        for groups in points.values():
            for place in (place for group in groups.values() for place in group):
                content = texts.get(place, texts.get(-1, ""))
                if place < 0 or not content:
                    continue
                unit = _UNITS.get(content.lower())
                if unit is None:
                    raise self.source.error(
                        phrase("unit {}: only mm and inch are read", shown(content)), self.begins[place]
                    )
                found.setdefault(unit, place)
        if len(found) > 1:
            raise self.source.error(
                phrase("coordinates in mm and in inch in one file"), self.begins[max(found.values())]
            )
        return next(iter(found), None)

    def _has_z(self, groups: dict[str, _Point]) -> bool:
        without = next((stem for stem, group in groups.items() if group[2] < 0), None)
        if without is not None and any(group[2] >= 0 for group in groups.values()):
            raise self.source.error(
                phrase("point {} has no Z, others have", shown(without)), self.begins[groups[without][0]]
            )
        return without is None


def _axis(text: str) -> tuple[str, int] | None:
    """Name of the point, and axis as 0, 1 or 2, of a characteristic with this name."""
    for pattern in _NAMES:
        found = pattern.fullmatch(text[:200])
        if found is not None:
            return found["stem"], "XYZ".index(found["axis"].upper())
    return None


def _with_z(table: Floats) -> Floats:
    return table if table.shape[1] == 3 else np.column_stack([table, np.zeros(len(table))])
