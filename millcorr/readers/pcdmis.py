# SPDX-License-Identifier: LGPL-2.1-or-later
"""PC-DMIS text reports: locations of points as blocks of axes, with nominal, measured value and deviation.

Columns are found by the words of the ``AX`` line above them. Every row is checked by DEV = MEAS - NOMINAL, which a
value in the wrong column does not pass.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from millcorr.measurement import Measurement

from .source import Source, shown

_RECOGNISED = re.compile(rb"(?:^|\n|\r)[ \t]*DIM[ \t]+[^\r\n=]{1,60}=[^\r\n]{1,80}[ \t]OF[ \t]", re.IGNORECASE)
_DIMENSION = re.compile(r"\s*DIM\s+(?P<dim>[^\s=]+)\s*=\s*(?P<what>\S.*?)\s+OF\s+(?P<rest>.*)", re.IGNORECASE)
_PLAIN_POINT = re.compile(r"DIM ([^\s=]+)= ?LOCATION OF POINT ([^\s,$]+) +UNITS=(MM|IN)[ \t]*")
_UNITS = re.compile(r"\bUNITS\s*=\s*([A-Z]+)", re.IGNORECASE)
_END = re.compile(r"\s*END\s+OF\s+DIMENSION\b", re.IGNORECASE)
_HEADING = re.compile(r"\s*AX\s+\S", re.IGNORECASE)
_AXIS = re.compile(r"\s*([XYZTV])\s+(?=[\d.,+-])", re.IGNORECASE)
_VALUE = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?![\w.,])", re.ASCII)
_GRAPH = re.compile(r"\s[<>\-#=|]{2,}(?:\s|$)|\s[#<>]")
"""Where the bar of deviation or an arrow begins behind the numbers."""

_PLAIN_NUMBERS = "0123456789.+-"
_BARS = "<>-#=|"
_AXES = ("X", "Y", "Z", "T", "V")
_CHECKED = ("NOMINAL", "MEAS", "DEV")
_LARGEST = 1e9
_STEPS = 1.6
"""Last digits by which a deviation may miss the difference of two rounded numbers."""

_WORDS = {
    "NOM": "NOMINAL", "NOMINAL": "NOMINAL", "MEAS": "MEAS", "MEASURED": "MEAS", "ACTUAL": "MEAS", "DEV": "DEV",
    "DEVIATION": "DEV",
}  # fmt: skip
_UNIT_NAMES = {"MM": "mm", "IN": "inch", "INCH": "inch", "INCHES": "inch"}


@dataclass(slots=True)
class _Location:
    """Location of one point: per axis nominal, measured value, deviation."""

    feature: str
    line: int
    unit: str
    axes: dict[str, tuple[float, float]] = field(default_factory=dict)
    normal: tuple[float, float, float] | None = None
    along: float = float("nan")


def recognises(data: bytes) -> bool:
    """Whether a file holds a line ``DIM name= ... OF ...`` and a line of column heads."""
    head = data[:262144].replace(b"\x00", b"")
    return bool(_RECOGNISED.search(head) and re.search(rb"(?:^|\n|\r)[ \t]*AX[ \t]", head, re.IGNORECASE))


def read(source: Source) -> Measurement:
    """Points of a PC-DMIS text report.

    Parameters
    ----------
    source : Source
        The report does not say whether its points were compensated.

    Returns
    -------
    Measurement
        Nominals; normals where every point has its V row; deviations of the T rows as stated ones.

    Raises
    ------
    FormatError
        If a row is spoilt, its DEV is not MEAS - NOMINAL, units are mixed, or no point has all its axes.
    UsageError
        If the caller contradicts the file, or does not say what the points are.
    """
    report = _Report(source)
    for number, line in source.lines(drop=b"\x0c"):
        report.line(number, line)
    return report.measurement()


class _Report:
    """State of reading: the column heads and the location that are open, what was read."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.heading: list[tuple[str, int]] = []
        self.headings: dict[str, list[tuple[str, int]]] = {}
        self.wanted: tuple[int, int, int] | None = None
        """Places of nominal, measured value and deviation in a row, if all are columns."""
        self.slices: list[tuple[int, int]] = []
        """Where the cell of each column begins and ends."""
        self.open: _Location | None = None
        self.foreign = False
        self.locations: list[_Location] = []
        self.others: dict[str, int] = {}

    def line(self, number: int, text: str) -> None:
        if self._plain(number, text):
            return
        found = _DIMENSION.match(text)
        if found:
            self._dimension(number, found)
        elif _END.match(text):
            self.open, self.foreign = None, False
        elif _HEADING.match(text):
            self._columns(number, text)
        elif self.open is not None:
            axis = _AXIS.match(text)
            if axis:
                self._row(number, axis[1].upper(), text, axis.end())
            elif re.match(r"\s*[XYZ](?:\s|$)", text):
                raise self.source.error(f"{shown(text)} is no row of an axis: export the report again", number)

    def _plain(self, number: int, text: str) -> bool:
        """Take a line as nearly all are: a point's head, or a row with nothing blank or spoilt that adds up."""
        if text.startswith("DIM "):
            found = _PLAIN_POINT.fullmatch(text)
            if found is not None:
                self.open, self.heading, self.wanted = _Location(found[2], number, _UNIT_NAMES[found[3]]), [], None
                self.locations.append(self.open)
            return found is not None
        if "," in text:
            text = text.replace(",", ".")
        cells, location = text.split(), self.open
        if location is None or not cells or cells[0] not in _AXES:
            return not cells
        axis = cells[0]
        if axis != "V" and (self.wanted is None or axis in location.axes):
            return False
        count = 4 if axis == "V" else len(self.heading) + 1
        # Behind the numbers there may be bars and arrows, at most.
        values, rest = cells[1:count], "".join(cells[count:])
        if axis != "V" and (len(cells) < count or values[-1].strip(_BARS) == ""):
            # A column is blank: every number ends where the word above it ends.
            values = [text[begin:end].strip() for begin, end in self.slices]
            rest = text[self.slices[-1][1] :].strip()
        if len(values) != count - 1 or "".join(values).strip(_PLAIN_NUMBERS) or rest.strip(_BARS):
            return False
        try:
            numbers = [float(v) if v else 0.0 for v in values]
        except ValueError:
            return False
        if max(numbers) >= _LARGEST or min(numbers) <= -_LARGEST:
            return False
        if axis == "V":
            location.normal = (numbers[0], numbers[1], numbers[2])
            return True
        assert self.wanted is not None
        a, b, c = self.wanted
        nominal, measured, deviation = numbers[a], numbers[b], numbers[c]
        places = len(values[a].partition(".")[2])
        if not places == len(values[b].partition(".")[2]) == len(values[c].partition(".")[2]):
            return False
        if not (values[a] and values[b] and values[c]) or abs(measured - nominal - deviation) > _STEPS * 10.0**-places:
            return False
        if axis == "T":
            location.along = deviation
        else:
            location.axes[axis] = (nominal, measured)
        return True

    def _dimension(self, number: int, found: re.Match[str]) -> None:
        self.open, self.heading, self.wanted = None, [], None
        what = found["what"].upper().split()
        rest = re.split(r"\bUNITS\b", found["rest"], maxsplit=1, flags=re.IGNORECASE)[0].strip().rstrip(",$ ")
        words = rest.split()
        if what != ["LOCATION"] or not words or "POINT" not in (w.upper() for w in words[:-1]):
            kind = f"{found['what'].lower()} of {' '.join(words[:-1]).lower() or 'something'}"
            self.others[kind[:40]] = self.others.get(kind[:40], 0) + 1
            return
        unit = _UNITS.search(found["rest"])
        name = _UNIT_NAMES.get(unit[1].upper()) if unit else ""
        if name is None:
            assert unit is not None
            raise self.source.error(f"unit {shown(unit[1])}: only MM and IN are read", number)
        self.open = _Location(words[-1], number, name)
        self.locations.append(self.open)

    def _columns(self, number: int, text: str) -> None:
        heading = self.headings.get(text)
        if heading is None:
            words = list(re.finditer(r"\S+", text))[1:]
            heading = self.headings[text] = [(_WORDS.get(m[0].upper(), m[0].upper()), m.end()) for m in words]
        self.heading = heading
        names = [name for name, _ in heading]
        if all(names.count(name) == 1 for name in _CHECKED):
            self.wanted = names.index("NOMINAL"), names.index("MEAS"), names.index("DEV")
            ends = [2, *(end for _, end in heading)]
            self.slices = list(pairwise(ends))
        else:
            self.wanted = None
        if self.open is not None:
            for needed in ("NOMINAL", "MEAS"):
                if names.count(needed) != 1:
                    raise self.source.error(
                        f"no single column {needed}: print nominal, measured value and deviation", number
                    )

    def _row(self, number: int, axis: str, text: str, start: int) -> None:
        location, source = self.open, self.source
        assert location is not None
        if not self.heading:
            raise source.error("a row of an axis without column heads (AX NOMINAL ...) above it", number)
        graph = _GRAPH.search(text, start)
        end = graph.start() if graph else len(text)
        spoilt = _VALUE.sub(" ", text[start:end]).strip(" \t-\xb0")
        if spoilt:
            raise source.error(f"{shown(spoilt)} among the values of axis {axis}: export the report again", number)
        cells = list(_VALUE.finditer(text, start, end))
        values = [_number(m[0]) for m in cells]
        if any(not abs(v) < _LARGEST for v in values):
            raise source.error("a value is no length", number)
        if axis == "V":
            if len(values) < 3:
                raise source.error("the vector V has no three components", number)
            location.normal = (values[0], values[1], values[2])
            return
        columns = self._assigned(cells, values)
        if columns is None:
            raise source.error(
                f"axis {axis}: DEV is not MEAS - NOMINAL in any way the columns can be read: export it again", number
            )
        if axis == "T":
            location.along = columns.get("DEV", columns["MEAS"] - columns["NOMINAL"])
            return
        if axis in location.axes:
            raise source.error(f"axis {axis} of {shown(location.feature)} is there twice", number)
        location.axes[axis] = (columns["NOMINAL"], columns["MEAS"])

    def _assigned(self, cells: list[re.Match[str]], values: list[float]) -> dict[str, float] | None:
        """Values by column: in order where none is blank, else by the column each ends under; None if neither fits."""
        names = [name for name, _ in self.heading]
        step = 10.0 ** -max((len(m[0].replace(",", ".").partition(".")[2]) for m in cells), default=0)
        if len(values) == len(names):
            in_order = dict(zip(names, values, strict=True))
            if _adds_up(in_order, "DEV" in names, step):
                return in_order
        nearest = [min(range(len(names)), key=lambda k: abs(self.heading[k][1] - m.end())) for m in cells]
        below = {names[k]: v for k, v in zip(nearest, values, strict=True)}
        return below if len(set(nearest)) == len(nearest) and _adds_up(below, "DEV" in names, step) else None

    def measurement(self) -> Measurement:
        source = self.source
        whole, notes = [], []
        seen: dict[str, _Location] = {}
        for location in self.locations:
            missing = "XYZ" if not location.axes else "".join(a for a in "XYZ" if a not in location.axes)
            if missing:
                notes.append((location, missing))
                continue
            first = seen.setdefault(location.feature, location)
            if first is location:
                whole.append(location)
            elif first.axes != location.axes:
                raise source.error(
                    f"{shown(location.feature)} lies elsewhere than in line {first.line}: report every point once, "
                    "in one alignment",
                    location.line,
                )
        remarks = []
        if notes:
            first, missing = notes[0]
            text = f"{shown(first.feature)} lacks {', '.join(missing)} and is no point"
            if not whole:
                raise source.error(f"no point has all its axes: {text}; report X, Y and Z", first.line)
            remarks.append(f"{len(notes)} locations left out: {text} (line {first.line})")
        if self.others:
            kinds = ", ".join(f"{n} {kind}" for kind, n in sorted(self.others.items())[:5])
            remarks.append(f"dimensions left out: {kinds}")
        if not whole:
            raise source.error("no LOCATION OF POINT in the report: report the points' X, Y and Z")
        units = {location.unit for location in whole}
        if len(units) > 1:
            other = next(o for o in whole if o.unit != whole[0].unit)
            raise source.error("points in different units: export them in one", other.line)
        unit = source.unit(units.pop() or None)
        table = np.array([[location.axes[a] for a in "XYZ"] for location in whole])
        normals = [location.normal for location in whole if location.normal is not None]
        if normals and len(normals) < len(whole):
            remarks.append(f"{len(whole) - len(normals)} of {len(whole)} points have no V: normals are not used")
        stated = np.array([location.along for location in whole])
        return source.measurement(
            "pcdmis", table[:, :, 1], [location.line for location in whole], ball_radius=source.ball_radius(),
            unit=unit, normals=np.array(normals) if len(normals) == len(whole) else None, nominal=table[:, :, 0],
            stated=None if np.isnan(stated).all() else stated, elements=[location.feature for location in whole],
            notes=remarks,
        )  # fmt: skip


def _number(text: str) -> float:
    return float(text.replace(",", "."))


def _adds_up(columns: dict[str, float], has_deviation: bool, step: float) -> bool:
    """Whether the deviation is measured less nominal value, to the last digit printed."""
    if not {"NOMINAL", "MEAS"} <= columns.keys() or (has_deviation and "DEV" not in columns):
        return False
    nominal, measured = columns["NOMINAL"], columns["MEAS"]
    # A setting of PC-DMIS lets deviations of negative coordinates count away from zero.
    expected = (measured - nominal, abs(measured) - abs(nominal))
    return not has_deviation or min(abs(columns["DEV"] - e) for e in expected) <= _STEPS * step
