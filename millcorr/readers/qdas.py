# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q-DAS files (AQDEF, ``.dfq``): characteristics with one number each, put together to points by their names.

``P1.X``, ``P1.Y`` and ``P1.Z`` are one point. A part may have been measured several times, and a file may hold
several parts; each of these is one measured part, and all are counted through from 1.
"""

from __future__ import annotations

import math
import re
from array import array
from itertools import compress
from typing import NamedTuple

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .fields import NUMBER, why_no_number
from .names import Names
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
    for first, piece in source.pieces(table=_SEPARATORS):
        for number, line in enumerate(piece.split("\n"), first):
            reading.line(number, line)
    return reading.measurement()


class _Texts:
    """A text for some of many characteristics, by their places; one after another in memory."""

    def __init__(self) -> None:
        self._text = bytearray()
        self._begin, self._end = array("q"), array("q")

    def put(self, place: int, content: str) -> bool:
        """Keep a text; False where the place has another one."""
        if place < len(self._begin) and self._begin[place] >= 0:
            return self[place] == content
        for ends in (self._begin, self._end):
            ends.extend(array("q", (-1,)) * (place + 1 - len(ends)))
        self._begin[place] = len(self._text)
        self._text += content.encode()
        self._end[place] = len(self._text)
        return True

    def __getitem__(self, place: int) -> str:
        """Text of a place, empty where there is none."""
        if place >= len(self._begin) or self._begin[place] < 0:
            return ""
        return self._text[self._begin[place] : self._end[place]].decode()

    def __len__(self) -> int:
        return len(self._begin)


class _Groups(NamedTuple):
    """Points of a part: their names, and the places of X, Y and Z of each, (k, 3), -1 for none."""

    names: Names
    places: Ints


class _Reading:
    """State of reading: characteristics in the order of the file, and the part that the next ones belong to."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.places = array("q")
        """Place of each characteristic by its number; -1 for none."""
        self.begins = array("q")
        self.part_of = array("q")
        self.texts = {_NAME: _Texts(), _TEXT: _Texts()}
        """What K2xxx say, by field and place."""
        self.units: dict[str, int] = {}
        self.unit_of = array("i")
        """Different units, numbered, and by place which one; -1 for none."""
        self.general: dict[int, str] = {}
        """What K2xxx say of all characteristics."""
        self.nominal = array("d")
        """By place; NaN for none."""
        self.order: array[int] | None = None
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
        place = self._known(index) if index else -1
        if index and place < 0:
            place = len(self.begins)
            self.places.extend(array("q", (-1,)) * (index + 1 - len(self.places)))
            self.places[index] = place
            self.begins.append(number)
            self.part_of.append(self.part)
            self.nominal.append(math.nan)
            self.unit_of.append(-1)
            self.order = None
        if key == _NOMINAL and index and content:
            nominal = self._number(content, number)
            if math.isnan(self.nominal[place]):
                self.nominal[place] = nominal
            same = self.nominal[place] == nominal
        elif key not in (*self.texts, _UNIT):
            return
        elif not index:
            same = self.general.setdefault(key, content) == content
        elif key == _UNIT:
            unit = self.units.setdefault(content, len(self.units))
            if self.unit_of[place] < 0:
                self.unit_of[place] = unit
            same = self.unit_of[place] == unit
        else:
            same = self.texts[key].put(place, content)
        if not same:
            raise self.source.error(phrase("K{}/{} is there twice with different contents", key, index), number)

    def _known(self, index: int) -> int:
        """Place of the characteristic with this number; -1 for none."""
        return self.places[index] if index < len(self.places) else -1

    def _place(self, index: int, number: int) -> int:
        place = self._known(index)
        if place < 0:
            raise self.source.error(phrase("a value of characteristic {}, which no K2 field describes", index), number)
        return place

    def _in_order(self) -> Ints:
        """Places of all characteristics in the order of their numbers."""
        places = np.array(self.places, dtype=np.int64)
        return places[places >= 0]

    def _values(self, number: int, line: str) -> None:
        """A line with a value of every characteristic, in the order of their numbers."""
        if self.order is None:
            self.order = array("q", self._in_order().tobytes())
        count, last = line.count(_CHARACTERISTIC) + 1, line.rfind(_CHARACTERISTIC)
        if count == len(self.order) + 1 and not line[last + 1 :].strip():
            count -= 1
        if count != len(self.order):
            raise self.source.error(
                phrase(
                    "{} values for {} characteristics: the line is incomplete, or this is no line of values",
                    count,
                    len(self.order),
                ),
                number,
            )
        end = -1
        for place in self.order:
            # The line may be as long as the file: it is not cut up as a whole.
            begin, end = end + 1, line.find(_CHARACTERISTIC, end + 1)
            value, _, attributes = line[begin : end if end >= 0 else None].partition(_ATTRIBUTE)
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
        owners = np.frombuffer(self.owners, dtype=np.int64)
        order = np.argsort(owners, kind="stable")
        first = np.searchsorted(owners[order], np.arange(len(self.begins) + 1))
        chosen, piece = self._choice(points, np.diff(first))
        unit = source.unit(self._unit(points))
        ball_radius = source.ball_radius()
        groups = points[chosen]
        has_z = self._has_z(groups)
        places = groups.places[:, : 2 + has_z]
        at = first[places] + piece
        there = at < first[places + 1]
        at = order[np.where(there, at, 0)]
        coordinates = np.where(there, np.frombuffer(self.values)[at], np.nan)
        measured = ~np.isnan(coordinates).any(axis=1)
        if not measured.any():
            raise source.error(phrase("none of the points was measured on this part"))
        ideal = np.frombuffer(self.nominal)[places[measured]]
        ideal[np.isnan(ideal).any(axis=1)] = np.nan
        notes = [phrase("{} characteristics are no coordinate of a point", left_out)] if left_out else []
        if not measured.all():
            notes.append(phrase("{} points were not measured on this part", np.count_nonzero(~measured)))
        return source.measurement(
            "qdas", _with_z(coordinates[measured]), np.frombuffer(self.lines, dtype=np.int64)[at[measured, 0]],
            ball_radius=ball_radius, unit=unit, has_z=has_z, notes=notes,
            elements=Names(groups.names[row] for row in np.flatnonzero(measured).tolist()),
            nominal=None if np.isnan(ideal).all() else _with_z(ideal),
        )  # fmt: skip

    def _points(self) -> tuple[dict[int, _Groups], int]:
        """Points by part; and how many characteristics are none of a point."""
        places = self._in_order().tolist()
        named = [texts for texts in self.texts.values() if len(texts)]
        texts = named[0] if len(named) == 1 else max(
            self.texts.values(), key=lambda t: sum(_axis(t[place]) is not None for place in range(len(t)))
        )  # fmt: skip
        rows: dict[int, dict[str, int]] = {}
        tables: dict[int, array[int]] = {}
        for place in places:
            found = _axis(texts[place])
            if found is None:
                continue
            stem, axis = found
            part = self.part_of[place]
            own, table = rows.setdefault(part, {}), tables.setdefault(part, array("q"))
            row = own.setdefault(stem, len(own))
            if 3 * row == len(table):
                table.extend((-1, -1, -1))
            before = table[3 * row + axis]
            if before >= 0:
                raise self.source.error(
                    phrase(
                        "{} of point {} is there twice, first in line {}", "XYZ"[axis], shown(stem), self.begins[before]
                    ),
                    self.begins[place],
                )
            table[3 * row + axis] = place
        points: dict[int, _Groups] = {}
        used = 0
        for part in list(rows):
            own, grouped = rows.pop(part), np.array(tables.pop(part), dtype=np.int64).reshape(-1, 3)
            whole = (grouped[:, :2] >= 0).all(axis=1)
            if whole.any():
                points[part] = _Groups(Names(compress(own, whole.tolist())), grouped[whole])
                used += int((points[part].places >= 0).sum())
        if not points:
            raise self.source.error(
                phrase("no points: name the characteristics of a point alike with X, Y and Z, such as P1.X, P1.Y, P1.Z")
            )
        return points, len(self.begins) - used

    def _choice(self, points: dict[int, _Groups], counts: Ints) -> tuple[int, int]:
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

    def _times(self, groups: _Groups, counts: Ints) -> int:
        """How often a part was measured; FormatError where that is not the same for all its points."""
        named = groups.places >= 0
        own = np.where(named, counts[groups.places], -1)
        times = int(own.max())
        fewer = np.argwhere(named & (own < times))
        if len(fewer):
            row, axis = fewer[0].tolist()
            place = int(groups.places[row, axis])
            raise self.source.error(
                phrase(
                    "{} of point {} has {} of {} values: the file was cut off, or K0002 256 is missing for a "
                    "point that was not measured",
                    "XYZ"[axis],
                    shown(groups.names[row]),
                    counts[place],
                    times,
                ),
                self.begins[place],
            )
        return times

    def _unit(self, points: dict[int, _Groups]) -> str | None:
        places = np.concatenate([groups.places.ravel() for groups in points.values()])
        places = places[places >= 0]
        units, names = np.frombuffer(self.unit_of, dtype=np.intc)[places], list(self.units)
        found: dict[str, int] = {}
        # Each in the order in which points have them first; what is said of all stands where nothing else does.
        for first in np.sort(np.unique(units, return_index=True)[1]).tolist():
            place = int(places[first])
            content = names[units[first]] if units[first] >= 0 else self.general.get(_UNIT, "")
            if not content:
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

    def _has_z(self, groups: _Groups) -> bool:
        without = np.flatnonzero(groups.places[:, 2] < 0)
        if 0 < len(without) < len(groups.places):
            row = int(without[0])
            raise self.source.error(
                phrase("point {} has no Z, others have", shown(groups.names[row])), self.begins[groups.places[row, 0]]
            )
        return not len(without)


def _axis(text: str) -> tuple[str, int] | None:
    """Name of the point, and axis as 0, 1 or 2, of a characteristic with this name."""
    for pattern in _NAMES:
        found = pattern.fullmatch(text[:200])
        if found is not None:
            return found["stem"], "XYZ".index(found["axis"].upper())
    return None


def _with_z(table: Floats) -> Floats:
    return table if table.shape[1] == 3 else np.column_stack([table, np.zeros(len(table))])
