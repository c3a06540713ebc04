# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calypso's tables of characteristics (``_chr.txt``) and of features (``_fet.txt``).

Characteristics are a row each, X and Y of a feature in rows of their own: rows of one ``featureid`` with ``xValue`` and
``yValue`` (and ``zValue``, in all or in none) are a point. A feature that has any other characteristic, a diameter
above all, is a circle or something else and left out. Features are a row each and name their kind: points and space
points are read, with the nominal and the normal that stand beside them. The head of a plan (``_hdr.txt``) begins with
the same columns and holds no point.
"""

from __future__ import annotations

import math
import re
import sys
from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from millcorr.messages import option, phrase
from millcorr.readers.measurement import Measurement

from .decoding import beginning
from .fields import COMMA_NUMBER, NUMBER
from .parts import chosen_part, titled
from .source import Source, shown

_ALWAYS = {"planid", "partnb"}
_NEEDED = ("partnb", "idsymbol", "actual", "nominal", "featureid")
_OTHERS = ("deviation", "unit")
_OF_FEATURES = ("partnb", "id", "idsymbol", "x", "y", "z")
_POINTS = ("point", "spacepoint")
_VECTORS = ("x_nom", "y_nom", "z_nom", "nx", "ny", "nz")
_UNKNOWN = [math.nan] * 3
_THREE = re.compile(r"-?\d{1,8}\.\d+(?:\t-?\d{1,8}\.\d+){2}", re.ASCII)
"""As nearly all are written; the others are looked at one by one."""
_AXES = {"xvalue": 0, "yvalue": 1, "zvalue": 2}
_UNITS = {"mm": "mm", "inch": "inch", "in": "inch"}
_LARGEST = 1e9
_BESIDES = 1.07
"""A deviation may miss the difference of two rounded numbers by all roundings, and a bit for the binary."""


@dataclass(slots=True)
class _Feature:
    """What the table has of one feature: per axis nominal and actual value, None where it was not measured."""

    name: str
    line: int
    axes: list[tuple[float, float | None] | None] = field(default_factory=lambda: [None] * 3)
    others: tuple[str, ...] = ()

    @property
    def is_point(self) -> bool:
        return not self.others and None not in self.axes[:2]

    @property
    def is_measured(self) -> bool:
        return all(axis is None or axis[1] is not None for axis in self.axes)


def recognises(data: bytes) -> bool:
    """Whether a file's first line names the columns that all tables of Calypso begin with."""
    names = re.split(rb"[\r\n]", beginning(data, 8192).lstrip(), maxsplit=1)[0].lower().split(b"\t")
    return _ALWAYS <= {name.strip().decode("latin-1") for name in names}


def read(source: Source) -> Measurement:
    """Points of a table of characteristics, with their nominals.

    Parameters
    ----------
    source : Source
        Must say what the points are.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If it is another table of Calypso's, a number is spoilt, a deviation does not add up, or no feature is a point;
        names the line.
    UsageError
        If the caller contradicts the file, does not say what the points are, or which of several parts.
    """
    lines = ((number, line) for number, line in source.lines() if line.strip())
    number, head = next(lines, (1, ""))
    names = [name.strip().lower() for name in head.split("\t")]
    place = {name: k for k, name in enumerate(names) if name}
    for needed, others, table in ((_NEEDED, _OTHERS, _characteristics), (_OF_FEATURES, _VECTORS, _features)):
        if all(names.count(name) == 1 for name in needed):
            return table(source, _rows(source, lines, place, needed, (*needed, *others)))
    missing = next(name for name in _NEEDED if names.count(name) != 1)
    raise source.error(
        phrase(
            "no single column {}: not Calypso's table of characteristics or features; give the file that "
            "ends in _chr.txt or _fet.txt, or say by {} what the columns are and which rows are points",
            missing,
            option("mapping", of="FILE.toml"),
        ),
        number,
    )


_Rows = Iterator[tuple[int, list[str]]]
"""Line number and cells of the columns that are read, "" where there is no such column or the row ends before it."""


def _rows(
    source: Source, lines: Iterator[tuple[int, str]], place: dict[str, int], needed: tuple[str, ...],
    columns: tuple[str, ...],
) -> _Rows:  # fmt: skip
    """Rows below the header, which may be shorter than it."""
    last = max(place[name] for name in needed)
    at = [place.get(name, sys.maxsize) for name in columns]
    for number, line in lines:
        cells = line.split("\t")
        width = len(cells)
        if cells[0].strip().upper() == "END" and not any(cell.strip() for cell in cells[1:]):
            continue
        if width <= last:
            raise source.error(phrase("{} columns: the row is incomplete; {}", width, shown(line)), number)
        yield number, [cells[k].strip() if k < width else "" for k in at]


def _number(source: Source, number: int, text: str, axis: str) -> float:
    plain = text.replace(",", ".") if "," in text and COMMA_NUMBER.fullmatch(text) else text
    value = float(plain) if NUMBER.fullmatch(plain) else math.inf
    if not abs(value) < _LARGEST:
        raise source.error(phrase("{} of axis {} is no coordinate", shown(text), axis), number)
    return value


def _vector(source: Source, number: int, texts: list[str]) -> Sequence[float]:
    if _THREE.fullmatch("\t".join(texts)):
        return list(map(float, texts))
    return [_number(source, number, text, axis) for text, axis in zip(texts, "XYZ", strict=True)]


def _of_part(source: Source, parts: dict[str, dict[str, int]]) -> str:
    """Part number that the caller wants; `parts` are the lines of each part's features, by their names."""
    if not parts:
        raise source.error(phrase("no rows below the header"))
    titles = [phrase("part {}, {}", shown(n), titled(np.array(list(own.values())))) for n, own in parts.items()]
    return list(parts)[chosen_part(source, titles)]


def _features(source: Source, rows: _Rows) -> Measurement:
    """Points of a table of features."""
    parts: dict[str, dict[str, int]] = {}
    found: dict[str, array[float]] = {}
    others: dict[str, dict[str, int]] = {}
    unmeasured: dict[str, int] = {}
    for number, (part, name, kind, *texts) in rows:
        if kind.lower() not in _POINTS:
            left = others.setdefault(part, {})
            left[kind] = left.get(kind, 0) + 1
            continue
        lines = parts.setdefault(part, {})
        if name in lines:
            raise source.error(phrase("feature {} is there twice, first in line {}", shown(name), lines[name]), number)
        if not any(texts[:3]):
            unmeasured[part] = unmeasured.get(part, 0) + 1
            continue
        lines[name] = number
        place = _vector(source, number, texts[:3])
        others_of = [_vector(source, number, own) if all(own) else _UNKNOWN for own in (texts[3:6], texts[6:])]
        found.setdefault(part, array("d")).extend([*place, *others_of[0], *others_of[1]])
    if not found:
        kinds = sorted({shown(kind) for left in others.values() for kind in left})
        raise source.error(
            phrase("no row of the kind Point or SpacePoint, only {}", ", ".join(kinds[:5]) or phrase("a header"))
        )
    part = _of_part(source, {part: parts[part] for part in found})
    points, nominal, normals = np.frombuffer(found[part]).reshape(-1, 3, 3).swapaxes(0, 1)
    # A direction that the table does not know is written as zeros.
    without = int((np.isnan(normals).any(axis=1) | ~normals.any(axis=1)).sum())
    notes = [phrase("{} points were not measured", unmeasured[part])] if part in unmeasured else []
    if part in others:
        kinds = sorted(others[part])
        notes.append(phrase("{} other features left out: {}", sum(others[part].values()), ", ".join(kinds[:5])))
    if 0 < without < len(points):
        notes.append(phrase("{} of {} points have no normal: normals are not used", without, len(points)))
    return source.measurement(
        "calypso", points, list(parts[part].values()), ball_radius=source.ball_radius(), unit=source.unit(None),
        nominal=None if np.isnan(nominal).all() else nominal, normals=None if without else normals,
        elements=parts[part], notes=notes,
    )  # fmt: skip


def _characteristics(source: Source, rows: _Rows) -> Measurement:
    """Points of a table of characteristics."""
    table = _Table(source, rows)
    features = table.of_part()
    points = [f for f in features if f.is_point and f.is_measured]
    if not points:
        raise source.error(
            phrase("none of {} features has xValue and yValue and no other characteristic", len(features))
        )
    heights = [f.axes[2] is not None for f in points]
    if any(heights) and not all(heights):
        flat = points[heights.index(False)]
        raise source.error(phrase("{} has no zValue, others have", shown(flat.name)), flat.line)
    taken = phrase("{} features with X and Y and no size are taken for points", len(points))
    notes = [phrase("{}: the table does not name their kind", taken)]
    spoilt = sum(f.is_point for f in features) - len(points)
    if spoilt:
        notes.append(phrase("{} points were not measured", spoilt))
    if len(features) > len(points) + spoilt:
        kinds = sorted({kind for f in features for kind in f.others})
        told = f": {', '.join(kinds[:5])}" if kinds else ""
        notes.append(phrase("{} other features left out{}", len(features) - len(points) - spoilt, told))
    ball = source.ball_radius()
    values = np.array([[axis or (0.0, 0.0) for axis in f.axes] for f in points], dtype=np.float64)
    return source.measurement(
        "calypso", values[:, :, 1], [f.line for f in points], ball_radius=ball, unit=source.unit(table.unit()),
        nominal=values[:, :, 0], elements=[f.name for f in points], has_z=all(heights), notes=notes,
    )  # fmt: skip


class _Table:
    """Features of every part, put together from the rows of their characteristics."""

    def __init__(self, source: Source, rows: _Rows) -> None:
        self.source = source
        self.units: dict[str, int] = {}
        self.parts: dict[str, dict[str, _Feature]] = {}
        for number, cells in rows:
            self._row(number, *cells)

    def _row(
        self, number: int, part: str, kind: str, actual: str, nominal: str, name: str, deviation: str, unit: str
    ) -> None:
        if not name:
            return
        own = self.parts.setdefault(part, {})
        feature = own.get(name)
        if feature is None:
            feature = own[name] = _Feature(name, number)
        axis = _AXES.get(kind.lower())
        if axis is None:
            if kind not in feature.others:
                feature.others += (kind,)
            return
        letter = "XYZ"[axis]
        wanted = _number(self.source, number, nominal, letter)
        value = _number(self.source, number, actual, letter) if actual else None
        if feature.axes[axis] not in (None, (wanted, value)):
            raise self.source.error(
                phrase("{} of {} is there twice, first from line {}", letter, shown(name), feature.line), number
            )
        if value is not None and deviation:
            stated = _number(self.source, number, deviation, letter)
            texts = [text.replace(",", ".") for text in (nominal, actual, deviation)]
            rounding = sum(10.0 ** -len(text.partition(".")[2]) for text in texts) / 2
            if abs(value - wanted - stated) > _BESIDES * rounding:
                raise self.source.error(
                    phrase("{}: deviation is not actual less nominal, export the table again", letter), number
                )
        feature.axes[axis] = wanted, value
        self.units.setdefault(unit.lower(), number)

    def unit(self) -> str | None:
        """Unit that the table states for its coordinates; None where it states none."""
        if len(self.units) > 1:
            raise self.source.error(
                phrase("coordinates in different units: export them in one"), list(self.units.values())[1]
            )
        ((name, number),) = self.units.items()
        if name and name not in _UNITS:
            raise self.source.error(phrase("unit {}: only mm and inch are read", shown(name)), number)
        return _UNITS.get(name)

    def of_part(self) -> list[_Feature]:
        """Features of the part number that the caller wants."""
        lines = {part: {f.name: f.line for f in own.values()} for part, own in self.parts.items()}
        return list(self.parts[_of_part(self.source, lines)].values())
