# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calypso's table of characteristics (``_chr.txt``): a row a characteristic, X and Y of a feature in rows of their own.

Rows of one ``featureid`` with ``xValue`` and ``yValue`` (and ``zValue``, in all or in none) are a point. A feature that
has any other characteristic, a diameter above all, is a circle or something else and left out. The table of features
and the head of a plan (``_fet.txt``, ``_hdr.txt``) begin with the same columns and are refused by name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from millcorr.messages import message, option
from millcorr.readers.measurement import Measurement

from .decoding import beginning
from .fields import COMMA_NUMBER, NUMBER
from .parts import chosen_part, titled
from .source import Source, shown

_ALWAYS = {"planid", "partnb"}
_NEEDED = ("partnb", "idsymbol", "actual", "nominal", "featureid")
_AXES = {"xvalue": "X", "yvalue": "Y", "zvalue": "Z"}
_UNITS = {"mm": "mm", "inch": "inch", "in": "inch"}
_LARGEST = 1e9
_BESIDES = 1.07
"""A deviation may miss the difference of two rounded numbers by all roundings, and a bit for the binary."""


@dataclass(slots=True)
class _Feature:
    """What the table has of one feature: per axis nominal and actual value, None where it was not measured."""

    name: str
    line: int
    axes: dict[str, tuple[float, float | None]] = field(default_factory=dict)
    others: set[str] = field(default_factory=set)

    @property
    def is_point(self) -> bool:
        return not self.others and {"X", "Y"} <= self.axes.keys()


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
    table = _Table(source)
    features = table.of_part()
    points = [f for f in features if f.is_point and None not in (actual for _, actual in f.axes.values())]
    if not points:
        raise source.error(f"none of {len(features)} features has xValue and yValue and no other characteristic")
    heights = ["Z" in f.axes for f in points]
    if any(heights) and not all(heights):
        flat = points[heights.index(False)]
        raise source.error(f"{shown(flat.name)} has no zValue, others have", flat.line)
    taken = f"{len(points)} features with X and Y and no size are taken for points"
    notes = [f"{taken}: the table does not name their kind"]
    spoilt = sum(f.is_point for f in features) - len(points)
    if spoilt:
        notes.append(f"{spoilt} points were not measured")
    if len(features) > len(points) + spoilt:
        kinds = sorted({kind for f in features for kind in f.others})
        told = f": {', '.join(kinds[:5])}" if kinds else ""
        notes.append(f"{len(features) - len(points) - spoilt} other features left out{told}")
    ball = source.ball_radius()
    rows = np.array([[f.axes.get(axis, (0.0, 0.0)) for axis in "XYZ"] for f in points], dtype=np.float64)
    return source.measurement(
        "calypso", rows[:, :, 1], [f.line for f in points], ball_radius=ball, unit=source.unit(table.unit()),
        nominal=rows[:, :, 0], elements=[f.name for f in points], has_z=all(heights), notes=notes,
    )  # fmt: skip


class _Table:
    """Features of every part, put together from the rows."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.units: dict[str, int] = {}
        self.parts: dict[str, dict[str, _Feature]] = {}
        lines = ((number, line) for number, line in source.lines() if line.strip())
        number, head = next(lines, (1, ""))
        names = [name.strip().lower() for name in head.split("\t")]
        for needed in _NEEDED:
            if names.count(needed) != 1:
                raise source.error(
                    message(
                        f"no single column {needed}: not Calypso's table of characteristics; give the file that ends ",
                        "in _chr.txt, or say by ",
                        option("mapping", of="FILE.toml"),
                        " what the columns are and which rows are points",
                    ),
                    number,
                )
        self.place = {name: k for k, name in enumerate(names) if name}
        self._rows(lines)

    def _rows(self, lines: Iterator[tuple[int, str]]) -> None:
        for number, line in lines:
            cells = line.split("\t")
            if cells[0].strip().upper() == "END" and not any(cell.strip() for cell in cells[1:]):
                continue
            if len(cells) <= max(self.place[name] for name in _NEEDED):
                raise self.source.error(f"{len(cells)} columns: the row is incomplete; {shown(line)}", number)
            self._row(number, cells)

    def _row(self, number: int, cells: list[str]) -> None:
        def cell(name: str) -> str:
            at = self.place.get(name, len(cells))
            return cells[at].strip() if at < len(cells) else ""

        kind, name = cell("idsymbol"), cell("featureid")
        if not name:
            return
        feature = self.parts.setdefault(cell("partnb"), {}).setdefault(name, _Feature(name, number))
        axis = _AXES.get(kind.lower())
        if axis is None:
            feature.others.add(kind)
            return
        nominal = self._number(number, cell("nominal"), axis)
        actual = self._number(number, cell("actual"), axis) if cell("actual") else None
        if axis in feature.axes and feature.axes[axis] != (nominal, actual):
            raise self.source.error(f"{axis} of {shown(name)} is there twice, first from line {feature.line}", number)
        if actual is not None and cell("deviation"):
            deviation = self._number(number, cell("deviation"), axis)
            texts = [cell(c).replace(",", ".") for c in ("nominal", "actual", "deviation")]
            rounding = sum(10.0 ** -len(text.partition(".")[2]) for text in texts) / 2
            if abs(actual - nominal - deviation) > _BESIDES * rounding:
                raise self.source.error(f"{axis}: deviation is not actual less nominal, export the table again", number)
        feature.axes[axis] = nominal, actual
        self.units.setdefault(cell("unit").lower(), number)

    def _number(self, number: int, text: str, axis: str) -> float:
        plain = text.replace(",", ".") if COMMA_NUMBER.fullmatch(text) else text
        if not NUMBER.fullmatch(plain) or not abs(float(plain)) < _LARGEST:
            raise self.source.error(f"{shown(text)} of axis {axis} is no coordinate", number)
        return float(plain)

    def unit(self) -> str | None:
        """Unit that the table states for its coordinates; None where it states none."""
        if len(self.units) > 1:
            raise self.source.error("coordinates in different units: export them in one", list(self.units.values())[1])
        ((name, number),) = self.units.items()
        if name and name not in _UNITS:
            raise self.source.error(f"unit {shown(name)}: only mm and inch are read", number)
        return _UNITS.get(name)

    def of_part(self) -> list[_Feature]:
        """Features of the part number that the caller wants."""
        if not self.parts:
            raise self.source.error("no characteristics below the header")
        titles = [
            f"part {shown(n)}, {titled(np.array([f.line for f in own.values()]))}" for n, own in self.parts.items()
        ]
        return list(list(self.parts.values())[chosen_part(self.source, titles)].values())
