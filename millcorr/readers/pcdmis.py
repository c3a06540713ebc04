# SPDX-License-Identifier: LGPL-2.1-or-later
"""PC-DMIS text reports: locations of points as blocks of axes, with nominal, measured value and deviation.

A block begins with a head, ``DIM name= LOCATION OF POINT PNT1`` or ``FCFLOC1 = POSITION OF CIR1``, whose names may
hold blanks, and ends with the next head, its END or a change of alignment; the heads of pages may interrupt it. A row
belongs to the block it stands in or the report is refused. What stands between two changes of alignment is measured in
one frame. Columns are found by the words of the ``AX`` line above them. Every row is checked by DEV = MEAS - NOMINAL,
which a value in the wrong column does not pass.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from millcorr.messages import message, phrase
from millcorr.readers.measurement import Measurement

from .parts import chosen_part, titled
from .source import Source, shown

_RECOGNISED = re.compile(
    rb"(?:^|\n|\r)[ \t]*DIM[ \t]+[^\r\n=]{1,60}=[^\r\n]{1,80}[ \t](?:OF|FROM|TO)[ \t]", re.IGNORECASE
)
_DIMENSION = re.compile(r"\s*DIM\s+[^=]*=\s*(?P<what>.*)", re.IGNORECASE)
_TOLERANCE = re.compile(r"[^=]*=\s*(?P<what>[A-Z][A-Z ]*\s(?:OF|FROM|TO)\s.*)", re.IGNORECASE)
"""Head of a feature control frame, which has no DIM; its name need not hold FCF."""
_KIND = re.compile(r"(?P<kind>\S.*?)\s+(?:OF|FROM|TO)\s+(?P<features>.*)", re.IGNORECASE)
_POINT = re.compile(r"(?:(?:VECTOR|SURFACE|EDGE|CORNER|ANGLE|HIGH)\s+)?POINT[\s,]+(?P<name>\S.*)", re.IGNORECASE)
_PLAIN_POINT = re.compile(r"DIM [^=]+= ?LOCATION OF POINT ([^\s,$]+) +UNITS=(MM|IN)[ \t]*")
_PAGE = re.compile(
    r"\s*$|.*\bPAGE\s*#?\s*=?\s*\d|\s*(?:PART\s+(?:NAME|NUMBER)|REV\s+NUMBER|SER(?:IAL)?\s+NUMBER|STATS\s+COUNT|DATE|TIME)"
    r"\s*[:=]",
    re.IGNORECASE,
)
"""Head of a page, between whatever rows the page ends."""
_OPTIONS = re.compile(r"\s*(?:GRAPH|TEXT|MULT|OUTPUT)\s*=", re.IGNORECASE)
_ALIGNMENT = re.compile(r"\bALIGNMENT\b", re.IGNORECASE)
_RECALLED = re.compile(r"\s*(?:RECALL/ALIGNMENT|ALIGNMENT RECALLED)\W+\w", re.IGNORECASE)
_UNITS = re.compile(r"\bUNITS\s*=\s*([A-Z]+)", re.IGNORECASE)
_END = re.compile(r"\s*END\s+OF\s+DIMENSION\b", re.IGNORECASE)
_HEADING = re.compile(r"\s*AX\s+\S", re.IGNORECASE)
_AXIS = re.compile(r"\s*([XYZTV])\s+(?=[\d.,+-])", re.IGNORECASE)
_OTHER_ROW = re.compile(r"\s*(?:WORST|[A-Z]{1,3}\d?)\s+(?:[\d.,+-]|RFS|MMC|LMC)", re.IGNORECASE)
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
    frame: int
    """Which of the report's alignments it was measured in."""
    axes: dict[str, tuple[float, float]] = field(default_factory=dict)
    normal: tuple[float, float, float] | None = None
    along: float = float("nan")

    @property
    def missing(self) -> str:
        """Axes without a row, for messages; empty for a point."""
        return ", ".join(a for a in "XYZ" if a not in self.axes)


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
        If a row is spoilt or it is open whose it is, its DEV is not MEAS - NOMINAL, units are mixed, or no point has
        all its axes.
    UsageError
        If the caller contradicts the file, or does not say what the points are or in which of several alignments they
        are wanted.
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
        self.continued = False
        """Whether the head goes on in the next line."""
        self.stranger: tuple[int, str] | None = None
        """Line among the rows of the open location that is none of a report's."""
        self.closed: tuple[int, str, _Location] | None = None
        """Line that closed the last location, other than the head of the next block."""
        self.frame = 0
        self.frames: list[str] = [phrase("first alignment")]
        self.recalled: dict[str, int] = {}
        self.locations: list[_Location] = []
        self.others: dict[str, int] = {}

    def line(self, number: int, text: str) -> None:
        if self._plain(number, text):
            return
        continued, self.continued = self.continued, False
        found = _DIMENSION.match(text) or _TOLERANCE.match(text)
        if _HEADING.match(text):
            self._columns(number, text)
        elif continued or _OPTIONS.match(text):
            self.continued = continued and text.rstrip().endswith("$")
        elif _PAGE.match(text) and not _DIMENSION.match(text):
            pass
        elif found:
            self._dimension(number, found["what"])
            self.continued = text.rstrip().endswith("$")
        elif _END.match(text):
            self._close(number, text)
        elif _ALIGNMENT.search(text):
            self._alignment(number, text)
        elif "=" in text:
            # The head of something unknown; behind a point that lacks axes it may be a remark as well.
            if self.open is not None and self.open.missing:
                self._close(number, text)
            else:
                self._open(None)
        else:
            self._other(number, text)

    def _other(self, number: int, text: str) -> None:
        """Take a row, or a line that may stand anywhere but among the rows of a location."""
        axis = _AXIS.match(text)
        if self.open is not None:
            if axis:
                self._row(number, axis[1].upper(), text, axis.end())
            elif re.match(r"\s*[XYZ](?:\s|$)", text):
                raise self.source.error(phrase("{} is no row of an axis: export the report again", shown(text)), number)
            elif not _OTHER_ROW.match(text) and self.stranger is None:
                self.stranger = number, text
        elif self.closed is not None and axis:
            line, by, location = self.closed
            raise self.source.error(
                phrase(
                    "whose row of axis {} is this? {} in line {} closed {} of line {}",
                    axis[1].upper(),
                    shown(by),
                    line,
                    shown(location.feature),
                    location.line,
                ),
                number,
            )

    def _open(self, location: _Location | None) -> None:
        """Begin a block of rows: those of a point, or of what is none."""
        self.open, self.heading, self.wanted, self.stranger, self.closed = location, [], None, None, None
        if location is not None:
            self.locations.append(location)

    def _close(self, number: int, text: str) -> None:
        location = self.open
        self._open(None)
        self.closed = None if location is None else (number, text, location)

    def _alignment(self, number: int, text: str) -> None:
        """From here on another frame, or the one that an alignment of this name had when it was recalled before."""
        self._close(number, text)
        name = " ".join(text.upper().split())
        if _RECALLED.match(text) and name in self.recalled:
            self.frame = self.recalled[name]
            return
        self.frame = len(self.frames)
        self.frames.append(phrase("after {} in line {}", shown(text), number))
        if _RECALLED.match(text):
            self.recalled[name] = self.frame

    def _plain(self, number: int, text: str) -> bool:
        """Take a line as nearly all are: a point's head, or a row with nothing blank or spoilt that adds up."""
        if text.startswith("DIM "):
            found = _PLAIN_POINT.fullmatch(text)
            if found is not None:
                self._open(_Location(found[1], number, _UNIT_NAMES[found[2]], self.frame))
                self.continued = False
            return found is not None
        if "," in text:
            text = text.replace(",", ".")
        cells, location = text.split(), self.open
        if not cells:
            return True
        if location is None or self.continued or self.stranger is not None or cells[0] not in _AXES:
            return False
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

    def _dimension(self, number: int, what: str) -> None:
        unit = _UNITS.search(what)
        parts = _KIND.match(what[: unit.start()] if unit else what)
        point = _POINT.match(parts["features"]) if parts and parts["kind"].upper() == "LOCATION" else None
        name = point["name"].rstrip(",$ \t") if point else ""
        if not name:
            kind = (parts["kind"] if parts else what).lower()
            feature = parts["features"].split()[0].lower() if parts and parts["features"] else ""
            # A feature control frame names the feature without its kind.
            kind = phrase("{} of {}", kind, feature) if feature.isalpha() else kind
            self.others[kind[:40]] = self.others.get(kind[:40], 0) + 1
            self._open(None)
            return
        unit_name = _UNIT_NAMES.get(unit[1].upper()) if unit else ""
        if unit_name is None:
            assert unit is not None
            raise self.source.error(phrase("unit {}: only MM and IN are read", shown(unit[1])), number)
        self._open(_Location(name, number, unit_name, self.frame))

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
                        phrase("no single column {}: print nominal, measured value and deviation", needed), number
                    )

    def _row(self, number: int, axis: str, text: str, start: int) -> None:
        location, source = self.open, self.source
        assert location is not None
        if not self.heading:
            raise source.error(phrase("a row of an axis without column heads (AX NOMINAL ...) above it"), number)
        if self.stranger is not None:
            line, between = self.stranger
            raise source.error(
                phrase(
                    "whose row of axis {} is this? {} in line {} stands between it and {} of line {}: delete "
                    "what is no line of the report",
                    axis,
                    shown(between),
                    line,
                    shown(location.feature),
                    location.line,
                ),
                number,
            )
        graph = _GRAPH.search(text, start)
        end = graph.start() if graph else len(text)
        spoilt = _VALUE.sub(" ", text[start:end]).strip(" \t-\xb0")
        if spoilt:
            raise source.error(
                phrase("{} among the values of axis {}: export the report again", shown(spoilt), axis), number
            )
        cells = list(_VALUE.finditer(text, start, end))
        values = [_number(m[0]) for m in cells]
        if any(not abs(v) < _LARGEST for v in values):
            raise source.error(phrase("a value is no length"), number)
        if axis == "V":
            if len(values) < 3:
                raise source.error(phrase("the vector V has no three components"), number)
            location.normal = (values[0], values[1], values[2])
            return
        columns = self._assigned(cells, values)
        if columns is None:
            raise source.error(
                phrase("axis {}: DEV is not MEAS - NOMINAL in any way the columns can be read: export it again", axis),
                number,
            )
        if axis == "T":
            location.along = columns.get("DEV", columns["MEAS"] - columns["NOMINAL"])
            return
        if axis in location.axes:
            raise source.error(phrase("axis {} of {} is there twice", axis, shown(location.feature)), number)
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

    def _chosen(self) -> list[_Location]:
        """Locations in the alignment that the caller wants, of those that have points."""
        frames = list(dict.fromkeys(location.frame for location in self.locations if not location.missing))
        if not frames:
            return self.locations
        titles = []
        for frame in frames:
            own = np.array([location.line for location in self.locations if location.frame == frame])
            titles.append(message(titled(own), *((", ", self.frames[frame]) if len(frames) > 1 else ())))
        wanted = frames[chosen_part(self.source, titles)]
        return [location for location in self.locations if location.frame == wanted]

    def measurement(self) -> Measurement:
        source = self.source
        whole, notes = [], []
        seen: dict[str, _Location] = {}
        for location in self._chosen():
            if location.missing:
                notes.append((location, location.missing))
                continue
            first = seen.setdefault(location.feature, location)
            if first is location:
                whole.append(location)
            elif first.axes != location.axes:
                raise source.error(
                    phrase(
                        "{} lies elsewhere than in line {}: report every point once",
                        shown(location.feature),
                        first.line,
                    ),
                    location.line,
                )
        remarks = []
        if notes:
            first, missing = notes[0]
            text = phrase("{} lacks {} and is no point", shown(first.feature), missing)
            if not whole:
                raise source.error(phrase("no point has all its axes: {}; report X, Y and Z", text), first.line)
            remarks.append(phrase("{} locations left out: {} (line {})", len(notes), text, first.line))
        if self.others:
            kinds = ", ".join(f"{n} {kind}" for kind, n in sorted(self.others.items())[:5])
            remarks.append(phrase("dimensions left out: {}", kinds))
        if not whole:
            raise source.error(phrase("no LOCATION OF POINT in the report: report the points' X, Y and Z"))
        units = {location.unit for location in whole}
        if len(units) > 1:
            other = next(o for o in whole if o.unit != whole[0].unit)
            raise source.error(phrase("points in different units: export them in one"), other.line)
        unit = source.unit(units.pop() or None)
        table = np.array([[location.axes[a] for a in "XYZ"] for location in whole])
        normals = [location.normal for location in whole if location.normal is not None]
        if normals and len(normals) < len(whole):
            remarks.append(
                phrase("{} of {} points have no V: normals are not used", len(whole) - len(normals), len(whole))
            )
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
