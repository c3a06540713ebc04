# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print-outs of Renishaw's inspection cycles: a heading a feature, a POSN line an axis.

A point is a feature with POSN lines of X and Y, and Z where they all have it, and without SIZE. Every line is
checked by DEV = ACTUAL less nominal. The layout is that of the results a common CAM's post writes for these cycles:
``ACTUAL NaN`` is an axis that a cycle did not measure.
"""

from __future__ import annotations

import math
import re
from array import array

import numpy as np

from millcorr.arrays import Ints
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .names import Names
from .parts import chosen_part, titled
from .source import Source, shown

_HEADING = re.compile(r"COMPONENT\s+NO\.?\s*(\d{1,9})\s+FEATURE\s+NO\.?\s*(\d{1,9})\b", re.ASCII)
_NUMBER = r"([+-]?[ \t]*(?:\d+\.?\d*|\.\d+))(?![\w.,])"
_POSITION = re.compile(
    rf"POSN\s*([A-Z])\s*{_NUMBER}\s+ACTUAL\s*{_NUMBER}(?:\s+TOL\s*(?:TP)?\s*{_NUMBER})?\s+DEV\s*{_NUMBER}", re.ASCII
)
_UNMEASURED = re.compile(rf"POSN\s*[A-Z]\s*{_NUMBER}\s+ACTUAL\s*NAN\b", re.ASCII)
_CONTROLS = b"\x00\x11\x12\x13\x14\x1a"
_LARGEST = 1e6
_NOTHING = (math.nan,) * 6
_BESIDES = 1.07
"""A deviation may miss the difference of two rounded numbers by all roundings, and a bit for the binary."""


def recognises(data: bytes) -> bool:
    """Whether a file holds the heading of a feature."""
    head = data[:65536].translate(None, b"\x00")
    return bool(re.search(rb"COMPONENT\s{1,20}NO\.?\s{0,20}\d{1,9}\s{1,80}FEATURE\s{1,20}NO", head))


def read(source: Source) -> Measurement:
    """Points of a print-out, with their nominals.

    Parameters
    ----------
    source : Source
        Must say what the points are: some cycles compensate the ball, and some only along an axis.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a line is damaged, DEV does not add up, or no feature is a point; names the line.
    UsageError
        If the caller does not say what the points are, or which of several components.
    """
    ball = source.ball_radius()
    printed = _Printed(source)
    for number, raw in source.lines(drop=_CONTROLS):
        text = raw.strip().upper()
        found = _HEADING.search(text)
        if found:
            printed.feature(number, found[1], found[2])
        elif text.startswith("POSN"):
            printed.position(number, text)
        elif text.startswith("SIZE"):
            printed.size()
    return printed.measurement(ball)


class _Printed:
    """Features of a print-out, a column a property."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.lines = array("q")
        self.components: dict[str, int] = {}
        """Places of the components among all, by their numbers as printed."""
        self.titles: list[str] = []
        """These numbers."""
        self.component_of = array("q")
        self.numbers = array("q")
        self.digits = array("b")
        """Number of each feature, and how many digits it was printed with."""
        self.values = array("d")
        """Nominal X, Y, Z and actual X, Y, Z of each feature; NaN where there is none."""
        self.sized = bytearray()
        self.unmeasured = bytearray()
        """Whether each feature has a size, and an axis that was not measured."""
        self.axes: set[str] = set()
        """Axes of the last feature."""

    def feature(self, line: int, component: str, number: str) -> None:
        """Begin a feature."""
        self.lines.append(line)
        if component not in self.components:
            self.components[component] = len(self.titles)
            self.titles.append(component)
        self.component_of.append(self.components[component])
        self.numbers.append(int(number))
        self.digits.append(len(number))
        self.values.extend(_NOTHING)
        self.sized.append(False)
        self.unmeasured.append(False)
        self.axes.clear()

    def size(self) -> None:
        """Take a size of the last feature."""
        if self.sized:
            self.sized[-1] = True

    def position(self, line: int, text: str) -> None:
        """Take a POSN line of the last feature."""
        source = self.source
        if _UNMEASURED.match(text) and self.lines:
            self.unmeasured[-1] = True
            return
        found = _POSITION.match(text)
        if found is None:
            raise source.error(phrase("{} is no whole POSN line: print the results again", shown(text)), line)
        if not self.lines:
            raise source.error(phrase("a POSN line without COMPONENT NO and FEATURE NO above it"), line)
        axis, fields = found[1], [found[k] for k in (2, 3, 5)]
        nominal, actual, deviation = (float(re.sub(r"\s", "", f)) for f in fields)
        if not max(abs(nominal), abs(actual), abs(deviation)) <= _LARGEST:
            raise source.error(phrase("a value is no length that a machine can travel"), line)
        # Nominal and actual are printed alike, perhaps without last zeros, the deviation sometimes finer.
        places = [len(f.partition(".")[2]) for f in fields]
        rounding = 10.0 ** -max(places[:2]) + 10.0 ** -max(places) / 2
        if abs(deviation - (actual - nominal)) > _BESIDES * rounding:
            raise source.error(phrase("axis {}: DEV is not ACTUAL less nominal, the line is damaged", axis), line)
        if axis in self.axes:
            raise source.error(phrase("axis {} of feature {} is there twice", axis, self._name(-1)), line)
        self.axes.add(axis)
        if axis in "XYZ":
            place = "XYZ".index(axis) - len(_NOTHING)
            self.values[place], self.values[place + 3] = nominal, actual

    def _name(self, feature: int) -> str:
        return f"{self.titles[self.component_of[feature]]}.{self.numbers[feature]:0{self.digits[feature]}d}"

    def _of_part(self) -> Ints:
        """Features of the component that the caller wants, by their places: each number is a part."""
        component_of = np.array(self.component_of, dtype=np.int64)
        if not self.components:
            return component_of
        lines = np.array(self.lines)
        titles = [
            phrase("component {}, {}", name, titled(lines[component_of == place]))
            for name, place in self.components.items()
        ]
        return np.flatnonzero(component_of == chosen_part(self.source, titles))

    def measurement(self, ball: float) -> Measurement:
        """Features that are points, and notes about the others."""
        source, own = self.source, self._of_part()
        lines = np.array(self.lines, dtype=np.int64)[own]
        values = np.array(self.values).reshape(-1, 2, 3)[own]
        self.values = array("d")  # They are the most.
        sized = np.array(self.sized, dtype=bool)[own]
        there = ~np.isnan(values[:, 1])
        points = np.flatnonzero(~sized & there[:, :2].all(axis=1))
        lone = np.flatnonzero(~sized & (there.sum(axis=1) == 1))
        if not len(points):
            raise source.error(
                phrase(
                    "none of {} features has POSN X and POSN Y without SIZE: measure the contour by points", len(own)
                ),
                int(lines[0]) if len(own) else None,
            )
        flat = points[~there[points, 2]]
        has_z = len(flat) < len(points)
        if has_z and len(flat):
            raise source.error(
                phrase("feature {} has no POSN Z, others have", self._name(own[flat[0]])), int(lines[flat[0]])
            )
        names = Names(map(self._name, own[points].tolist()))
        again = self._repeated(own[points])
        if again is not None:
            raise source.error(
                phrase("component and feature {} are there twice: keep one print-out", names[again]),
                int(lines[points[again]]),
            )
        notes = []
        if len(lone):
            notes.append(
                phrase(
                    "{} features left out: measured along one axis only, as feature {} (line {}); print where "
                    "the ball stood",
                    len(lone),
                    self._name(own[lone[0]]),
                    int(lines[lone[0]]),
                )
            )
        if sized.any():
            notes.append(phrase("{} features with a size left out", int(sized.sum())))
        unmeasured = int(np.array(self.unmeasured, dtype=bool)[own].sum())
        if unmeasured:
            notes.append(phrase("{} features have an axis that was not measured (ACTUAL NaN)", unmeasured))
        rest = len(own) - len(points) - len(lone) - int(sized.sum())
        if rest:
            notes.append(phrase("{} features without POSN of X and Y left out", rest))
        nominal, actual = values[points, 0], values[points, 1]
        if not has_z:
            nominal[:, 2] = actual[:, 2] = 0.0
        return source.measurement(
            "renishaw", actual, lines[points], ball_radius=ball, unit=source.unit(None), nominal=nominal,
            elements=names, has_z=has_z, notes=notes,
        )  # fmt: skip

    def _repeated(self, features: Ints) -> int | None:
        """Place among features of one component of the first one whose number was there before; None for none."""
        # A number of nine digits at most, told apart by its zeros in front.
        keys = np.array(self.numbers)[features] * 10 + np.array(self.digits)[features]
        order = np.argsort(keys, kind="stable")
        twice = order[1:][keys[order[1:]] == keys[order[:-1]]]
        return int(twice.min()) if len(twice) else None
