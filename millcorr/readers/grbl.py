# SPDX-License-Identifier: LGPL-2.1-or-later
"""GRBL probe reports ``[PRB:x,y,z:1]``, out of whatever log they stand in.

They are machine positions of the uncompensated ball, in mm (inches after ``$13=1``); the digit behind the colon is 0
for a touch that failed. The work frame's origin comes from the caller, from ``WCO:`` of the status reports in the
log, or from the ``$#`` report: active G54 to G59, plus G92, plus the tool length (GRBL 1.1 interface document).
"""

from __future__ import annotations

import re
from array import array

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import UsageError, unsaid
from millcorr.messages import option, phrase, remedy
from millcorr.readers.measurement import Measurement

from .parts import parts_by_place, rows_of_part
from .source import MM_PER_INCH, Source, shown
from .touches import remark, slow_touches

_DECIMAL = r"[+-]?(?:\d+\.?\d*|\.\d+)"
_TUPLE = rf"{_DECIMAL}(?:,{_DECIMAL}){{2,5}}"
_PROBE = re.compile(rf"\[PRB:({_TUPLE}):([01])\]", re.ASCII)
_WORK_OFFSET = re.compile(rf"[|<]WCO:({_TUPLE})(?=[|>])", re.ASCII)
_STORED = re.compile(rf"\[(G5[4-9]|G92|TLO):({_DECIMAL}(?:,{_DECIMAL}){{0,5}})\]", re.ASCII)
_MODES = re.compile(r"\[GC:[^\]]*?\b(G5[4-9])\b", re.ASCII)
_INCHES = re.compile(r"(?:^|\s|>)\$13=([01])\b", re.ASCII)
_SAME = 1e-3
_NO_INCHES = 200.0
"""Machine coordinates beyond this are no inches: 5 m are more than any machine that GRBL drives travels."""


def recognises(data: bytes) -> bool:
    """Whether a file holds a probe report."""
    return b"[PRB:" in data[:4194304].replace(b"\x00", b"")


def read(source: Source) -> Measurement:
    """Ball centres of the touches in a GRBL log, in the work frame.

    Parameters
    ----------
    source : Source
        Must give the radius of the ball, and the work offset where the log does not hold it.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a report is damaged, a touch failed, or there are none; names the line.
    UsageError
        If radius or work offset are missing or contradict the log, or several parts are in it and none is chosen.
    """
    log = _Log(source)
    for number, line in source.lines(drop=b"\x11\x13\x18\x1b"):
        log.line(number, line)
    return log.measurement()


class _Log:
    """What was read of a log: touches, and the offsets that were in force."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.values = array("d")
        self.lines = array("q")
        self.offset_lines: list[int] = []
        self.offsets: list[tuple[float, float, float]] = []
        self.stored: dict[str, tuple[float, ...]] = {}
        self.active = "G54"
        self.inches: bool | None = None
        self.decimals: set[int] = set()
        self.after_lengths = False
        """The report of ``$#`` repeats the last touch behind the tool length."""

    def line(self, number: int, line: str) -> None:
        # Logs that lost a line end hold several reports in a line.
        begun = line.find("[PRB:")
        while begun >= 0:
            touch = _PROBE.match(line, begun)
            if touch is None:
                raise self.source.error(phrase("{} is damaged: log the touches again", shown(line[begun:])), number)
            self._touch(number, touch)
            begun = line.find("[PRB:", begun + 1)
        if "WCO:" in line:
            for found in _WORK_OFFSET.finditer(line):
                offset = _three(found[1])
                if not self.offsets or offset != self.offsets[-1]:
                    self.offsets.append(offset)
                    self.offset_lines.append(number)
        if "[G" in line or "[T" in line:
            for found in _STORED.finditer(line):
                self.stored[found[1]] = tuple(map(float, found[2].split(",")))
            modes = _MODES.search(line)
            if modes:
                self.active = modes[1]
        self.after_lengths = "[TLO:" in line or (self.after_lengths and not line.strip())
        inches = _INCHES.search(line) if "$13=" in line else None
        if inches:
            self.inches = inches[1] == "1"

    def _touch(self, number: int, found: re.Match[str]) -> None:
        place = _three(found[1])
        if self.after_lengths and (not self.values or tuple(self.values[-3:]) == place):
            return
        if found[2] == "0":
            raise self.source.error(
                phrase("the touch failed, the ball met nothing: delete the line or measure the point again"), number
            )
        self.decimals |= {len(cell.partition(".")[2]) for cell in found[1].split(",")[:3]}
        self.values.extend(place)
        self.lines.append(number)

    def measurement(self) -> Measurement:
        source = self.source
        points = np.array(self.values, dtype=np.float64).reshape(-1, 3)
        if not len(points):
            raise source.error(phrase("no probe report [PRB:x,y,z:1] in the log"))
        ball = source.ball_radius(centres=True)
        unit = self._unit()
        factor = MM_PER_INCH if unit == "inch" else 1.0
        origin, note = self._origin(factor)
        points, lines = points - origin, np.array(self.lines)
        slow = slow_touches(points * factor)
        points, lines = points[slow], lines[slow]
        chosen = rows_of_part(source, lines, parts_by_place(points * factor))
        return source.measurement(
            "grbl", points[chosen], lines[chosen], ball_radius=ball, unit=unit, notes=[note, *remark(slow)]
        )

    def _unit(self) -> str:
        """Unit by ``$13``, else by the decimals, of which GRBL prints three in mm and four in inch."""
        far = bool(self.values) and max(map(abs, self.values)) > _NO_INCHES
        if self.inches is None and self.decimals == {4} and self.source.units is None and not far:
            raise unsaid(
                phrase(
                    "{} does not hold $13 and gives four decimals, as GRBL prints inches, and some builds of it mm",
                    self.source.name,
                ),
                remedy("units", "inch"),
                remedy("units", "mm"),
            )
        told = None if self.inches is None else "inch" if self.inches else "mm"
        shows = phrase("three decimals, as GRBL prints mm") if self.decimals == {3} else ""
        if far:
            shows = phrase("places farther out than such machines go in inches")
        return self.source.unit(told, "mm", shows)

    def _origin(self, factor: float) -> tuple[Floats, str]:
        """Origin of the work frame for every touch, (n, 3) or (3,), in the log's unit, and where it comes from."""
        source, given = self.source, self.source.work_offset
        if self.offsets:
            table = np.array(self.offsets)
            latest = np.searchsorted(np.array(self.offset_lines), np.array(self.lines), side="right") - 1
            known, text = table[np.maximum(latest, 0)], phrase("WCO of the log")
        elif self.stored:
            g92 = (*self.stored.get("G92", ()), 0.0, 0.0, 0.0)[:3]
            length = self.stored.get("TLO", (0.0,))
            # One number is the length along Z; some builds report it for every axis.
            lengths = (0.0, 0.0, length[0]) if len(length) < 3 else length[:3]
            work = self.stored.get(self.active)
            if work is None or len(work) < 3:
                raise source.error(phrase("the $# report in the log does not hold the active {}", self.active))
            known, text = np.array(work[:3]) + np.array(g92) + np.array(lengths), phrase("{} of the log", self.active)
        elif given is None:
            raise unsaid(
                phrase("{} is in the machine frame and does not hold the work offset", source.name),
                option("work_offset", of="X Y Z"),
            )
        else:
            return np.array(given) / factor, phrase("machine frame, work offset as given")
        if given is not None and (np.abs(known * factor - np.array(given)) > _SAME).any():
            raise UsageError(
                phrase("{} contradicts {}, which holds {}: leave it out", option("work_offset"), source.name, text)
            )
        return known, phrase("machine frame, work offset by {}", text)


def _three(text: str) -> tuple[float, float, float]:
    x, y, z = map(float, text.split(",")[:3])
    return x, y, z
