# SPDX-License-Identifier: LGPL-2.1-or-later
"""DMIS output files (ISO 22093): nominal ``F(L)=FEAT/...`` and actual ``FA(L)=FEAT/...``, paired by their label.

Statements are taken apart by keyword, not by column, since writers differ: a label, a major word, and minor words
between commas. ``$`` at the end of a line continues the statement, ``$$`` begins a comment. No public output file
of a measuring machine was available: what is known comes from the standard's grammar.
"""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Iterator, Sequence

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import unsaid
from millcorr.messages import phrase, remedy
from millcorr.readers.measurement import Measurement

from .source import Source, shown

_RECOGNISED = re.compile(
    rb"(?:^|\n|\r)[ \t]*(?:DMISM[ND]/|FA[ \t]*\([^()\r\n]{1,80}\)[ \t]*=[ \t]*FEAT[ \t]*/)", re.IGNORECASE
)
_LABELLED = re.compile(r"(FA?)\s*\(\s*([^()]{1,80}?)\s*\)\s*=\s*FEAT\s*/\s*(.*)", re.ASCII | re.DOTALL)
_CELL = r"([+-]?(?:\d+\.?\d*|\.\d+))"
_TURN = r"([+-]?(?:\d+\.?\d*|\.\d+)(?::\d+(?::\d+\.?\d*)?)?)"
_CELLS = rf"(CART|POL),{_CELL},{_TURN},{_CELL}(?:,{_CELL},{_CELL},{_CELL})?[ \t]*"
_PLAIN = re.compile(rf"(FA?)\(([^()$]{{1,80}})\)=FEAT/POINT,{_CELLS}", re.ASCII)
_PLAIN_OF_CURVE = re.compile(rf"PTDATA/{_CELLS}", re.ASCII)
"""Points as nearly all are written, in capitals and without blanks."""
_STATEMENT = re.compile(r"([A-Z]+)\s*/\s*(.*)", re.ASCII | re.DOTALL)
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[ED][+-]?\d+)?", re.ASCII)
_SEXAGESIMAL = re.compile(r"([+-]?)(\d+):(\d+)(?::(\d+\.?\d*))?", re.ASCII)

_POINTS = ("POINT", "EDGEPT")
_CURVES = ("GCURVE", "GSURF")
_UNITS = {"MM": "mm", "INCH": "inch"}
_ANGLES = {"ANGDEC": math.radians(1.0), "ANGRAD": 1.0, "ANGDMS": math.radians(1.0)}
_PLANES = {"XYPLAN": (0, 1, 2), "YZPLAN": (1, 2, 0), "ZXPLAN": (2, 0, 1)}
_LONGEST = 20_000
_FARTHEST = 1e9

_NO_VECTOR = (math.nan,) * 3


def recognises(data: bytes) -> bool:
    """Whether a file holds an actual feature, or begins as a DMIS program."""
    return bool(_RECOGNISED.search(data[:1048576].replace(b"\x00", b"")))


def read(source: Source) -> Measurement:
    """Actual points of a DMIS output file.

    Parameters
    ----------
    source : Source
        The file says by PRCOMP whether its points are compensated, if at all.

    Returns
    -------
    Measurement
        Nominals and normals from F where they are there, else normals from FA.

    Raises
    ------
    FormatError
        If a statement is spoilt, units change, a label has two actuals, or there are none; names the line.
    UsageError
        If the file names no unit, or the caller contradicts it or does not say what it leaves open.
    """
    output = _Output(source)
    for line, statement in statements(source):
        output.take(line, statement)
    return output.measurement()


def statements(source: Source) -> Iterator[tuple[int, str]]:
    """Statements in capitals with the line each begins in; labels keep what they are but for the case."""
    begun, parts, length = 0, list[str](), 0
    for number, raw in source.lines():
        line = raw.split("$$", 1)[0].strip() if "$$" in raw else raw.strip()
        begun = begun or number
        more = line.endswith("$")
        parts.append(line[:-1].rstrip() if more else line)
        length += len(line)
        if length > _LONGEST:
            raise source.error(phrase("a statement of more than {} characters", _LONGEST), begun)
        if not more:
            whole = "".join(parts)
            if whole:
                yield begun, whole.upper()
            begun, parts, length = 0, [], 0
    if any(parts):
        raise source.error(phrase("the file ends in the middle of a statement: it was cut off"), begun)


class _Rows:
    """Points x, y, z, i, j, k with their lines, and the slice that each label has; NaN where there is no vector."""

    def __init__(self) -> None:
        self.values = array("d")
        self.lines = array("q")
        self.begin: dict[str, int] = {}
        self.count: dict[str, int] = {}

    def open(self, label: str) -> None:
        self.begin[label], self.count[label] = len(self.lines), 0

    def add(self, label: str, line: int, values: Sequence[float]) -> None:
        self.values.extend(values)
        self.lines.append(line)
        self.count[label] += 1

    def names(self) -> Iterator[str]:
        """Names of the points: their label, with a number behind it where several have it."""
        for label, count in self.count.items():
            yield from (f"{label}.{k}" for k in range(1, count + 1)) if count != 1 else (label,)

    def table(self) -> Floats:
        return np.frombuffer(self.values).reshape(-1, 6)


class _Output:
    """State of reading: unit, angles, plane and the curve that is open; what was read."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.unit: str | None = None
        self.angle = "ANGDEC"
        self.plane = _PLANES["XYPLAN"]
        self.compensated: bool | None = None
        self.nominal = _Rows()
        self.actual = _Rows()
        self.curve: tuple[_Rows, str] | None = None
        self.again: list[tuple[str, int, tuple[float, ...]]] = []
        self.others: dict[str, int] = {}
        self.ended = False

    def take(self, line: int, statement: str) -> None:
        plain = _PLAIN.fullmatch(statement)
        if plain:
            self.curve = None
            self._point(line, plain[1], plain[2].strip(), self._plain_values(line, *plain.groups()[2:]))
            return
        plain = _PLAIN_OF_CURVE.fullmatch(statement) if self.curve is not None else None
        if plain and self.curve is not None:
            rows, label = self.curve
            rows.add(label, line, self._plain_values(line, *plain.groups()))
            return
        found = _LABELLED.fullmatch(statement)
        if found:
            self._feature(line, found[1], found[2], _words(found[3]))
            return
        found = _STATEMENT.fullmatch(statement)
        if found is None:
            self.ended = self.ended or statement == "ENDFIL"
            if re.match(r"FA?\s*\(|PTDATA", statement):
                raise self.source.error(
                    phrase("{} is no whole statement: export the file again", shown(statement)), line
                )
            self.curve = None
            return
        words = _words(found[2])
        if found[1] == "PTDATA":
            self._point_of_curve(line, words)
            return
        self.curve = None
        if found[1] == "UNITS":
            self._units(line, words)
        elif found[1] == "WKPLAN":
            if words[0] not in _PLANES:
                raise self.source.error(phrase("work plane {} is not known", shown(words[0])), line)
            self.plane = _PLANES[words[0]]
        elif found[1] == "PRCOMP":
            compensated = words[0] != "OFF"
            if self.compensated not in (None, compensated) and self.actual.lines:
                raise self.source.error(phrase("ball compensation changes between the points: export them apart"), line)
            self.compensated = compensated

    def _units(self, line: int, words: list[str]) -> None:
        if words[0] not in _UNITS:
            raise self.source.error(phrase("UNITS/{}: only MM and INCH are read", words[0][:20]), line)
        if self.unit not in (None, _UNITS[words[0]]):
            raise self.source.error(phrase("the unit changes: export the points in one"), line)
        self.unit = _UNITS[words[0]]
        for word in words[1:]:
            if word in _ANGLES:
                self.angle = word

    def _feature(self, line: int, role: str, label: str, words: list[str]) -> None:
        kind, self.curve = words[0], None
        rows = self.nominal if role == "F" else self.actual
        if kind in _CURVES:
            if role == "FA" and label in rows.begin:
                raise self.source.error(phrase("FA({}) is there twice: export every curve once", label[:40]), line)
            rows.open(label)
            self.curve = (rows, label)
            return
        if kind not in _POINTS:
            if role == "FA":
                self.others[kind[:20].lower()] = self.others.get(kind[:20].lower(), 0) + 1
            return
        self._point(line, role, label, self._coordinates(line, f"{role}({label[:40]})", words[1:]))

    def _point(self, line: int, role: str, label: str, values: tuple[float, ...]) -> None:
        rows = self.nominal if role == "F" else self.actual
        if role == "FA" and label in rows.begin:
            if rows.count[label] != 1:
                raise self.source.error(phrase("FA({}) is a point and a curve", label[:40]), line)
            self.again.append((label, line, values))
            return
        rows.open(label)
        rows.add(label, line, values)

    def _point_of_curve(self, line: int, words: list[str]) -> None:
        if self.curve is None:
            raise self.source.error(phrase("PTDATA without a curve or surface above it"), line)
        rows, label = self.curve
        rows.add(label, line, self._coordinates(line, phrase("PTDATA of {}", label[:40]), words))

    def _coordinates(self, line: int, what: str, words: list[str]) -> tuple[float, ...]:
        """Values x, y, z, i, j, k behind CART or POL, polar ones turned into Cartesian ones."""
        kind = next((k for k, w in enumerate(words) if w in ("CART", "POL")), None)
        if kind is None:
            raise self.source.error(phrase("{}: neither CART nor POL", what), line)
        polar = words[kind] == "POL"
        fields = words[kind + 1 :]
        if len(fields) < 3 or len(fields) not in (3, 6, 9):
            raise self.source.error(phrase("{}: {} numbers where 3 or 6 were expected", what, len(fields)), line)
        values = [self._angle(line, f) if polar and k == 1 else self._number(line, f) for k, f in enumerate(fields)]
        if polar:
            values[:3] = self._placed(*values[:3])
        return (*values[:3], *(values[3:6] or _NO_VECTOR))

    def _plain_values(self, line: int, kind: str, *cells: str | None) -> tuple[float, ...]:
        """Values x, y, z, i, j, k of cells that are numbers, the second maybe an angle; NaN for a vector not there."""
        x, y, z, *vector = cells
        assert x is not None and y is not None and z is not None
        polar = kind == "POL"
        if ":" in y or polar:
            turn = self._angle(line, y) if polar else self._number(line, y)
            place = self._placed(float(x), turn, float(z))
        else:
            place = (float(x), float(y), float(z))
        values = (*place, *(_NO_VECTOR if vector[0] is None else [float(v) for v in vector if v is not None]))
        if max(map(abs, place)) > _FARTHEST or max(map(abs, values[3:])) > _FARTHEST:
            # Says which.
            for cell in (x, *([] if polar else [y]), z, *vector):
                self._number(line, cell or "0")
        return values

    def _placed(self, radius: float, turn: float, height: float) -> tuple[float, float, float]:
        """Polar coordinates of the work plane as Cartesian ones."""
        place = [0.0, 0.0, 0.0]
        for axis, value in zip(self.plane, (radius * math.cos(turn), radius * math.sin(turn), height), strict=True):
            place[axis] = value
        return place[0], place[1], place[2]

    def _number(self, line: int, text: str) -> float:
        if not _NUMBER.fullmatch(text):
            raise self.source.error(phrase("{} is no number", shown(text)), line)
        value = float(text.replace("D", "E"))
        if not abs(value) <= _FARTHEST:
            raise self.source.error(phrase("{} is no length that a machine can travel", shown(text)), line)
        return value

    def _angle(self, line: int, text: str) -> float:
        """Angle in radians."""
        parts = _SEXAGESIMAL.fullmatch(text) if self.angle == "ANGDMS" else None
        if parts is None:
            return self._number(line, text) * _ANGLES[self.angle]
        degrees = float(parts[2]) + float(parts[3]) / 60 + float(parts[4] or "0") / 3600
        return math.radians(-degrees if parts[1] == "-" else degrees)

    def measurement(self) -> Measurement:
        source, actual, nominal = self.source, self.actual, self.nominal
        measured, ideal = actual.table(), nominal.table()
        for label, line, values in self.again:
            first = actual.begin[label]
            if not np.array_equal(measured[first], np.array(values), equal_nan=True):
                raise source.error(
                    phrase(
                        "FA({}) lies elsewhere than in line {}: export every point once",
                        label[:40],
                        actual.lines[first],
                    ),
                    line,
                )
        if not len(measured):
            others = phrase(", only {}", ", ".join(sorted(self.others)[:5])) if self.others else ""
            raise source.error(phrase("no measured points FA(...)=FEAT/POINT in the file{}", others))
        notes = []
        if not self.ended:
            notes.append(phrase("no ENDFIL: points may be missing at the end of the file"))
        if self.again:
            notes.append(phrase("{} repetitions of points left out: they are equal", len(self.again)))
        if self.others:
            left = ", ".join(f"{n} {kind}" for kind, n in sorted(self.others.items())[:5])
            notes.append(phrase("measured features left out: {}", left))
        unmeasured = sum(n for label, n in nominal.count.items() if label not in actual.begin)
        if unmeasured:
            notes.append(phrase("{} nominal points were not measured", unmeasured))
        if self.unit is None and source.units is None:
            raise unsaid(
                phrase("{} has no UNITS statement", source.name),
                remedy("units", "mm"),
                remedy("units", "inch"),
            )
        partner = np.full(len(measured), -1)
        for label, begin in actual.begin.items():
            count = actual.count[label]
            if nominal.count.get(label) == count:
                partner[begin : begin + count] = np.arange(nominal.begin[label], nominal.begin[label] + count)
        paired = partner >= 0
        wanted = np.full((len(measured), 3), np.nan)
        wanted[paired] = ideal[partner[paired], :3]
        normals = measured[:, 3:].copy()
        directed = paired.copy()
        directed[paired] = ~np.isnan(ideal[partner[paired], 3:]).any(axis=1)
        normals[directed] = ideal[partner[directed], 3:]
        without = int(np.isnan(normals).any(axis=1).sum())
        if 0 < without < len(measured):
            notes.append(phrase("{} of {} points have no normal: normals are not used", without, len(measured)))
        ball = source.ball_radius(centres=None if self.compensated is None else not self.compensated)
        return source.measurement(
            "dmis", measured[:, :3], actual.lines, ball_radius=ball, unit=source.unit(self.unit),
            normals=None if without else normals, nominal=wanted if paired.any() else None,
            elements=actual.names(), notes=notes,
        )  # fmt: skip


def _words(text: str) -> list[str]:
    return [word.strip() for word in text.split(",")]
