# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print-outs of Renishaw's inspection cycles: a heading a feature, a POSN line an axis.

A point is a feature with POSN lines of X and Y, and Z where they all have it, and without SIZE. Every line is
checked by DEV = ACTUAL less nominal. The layout is that of the results a common CAM's post writes for these cycles:
``ACTUAL NaN`` is an axis that a cycle did not measure.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

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
_BESIDES = 1.07
"""A deviation may miss the difference of two rounded numbers by all roundings, and a bit for the binary."""


@dataclass(slots=True)
class _Feature:
    """Feature of a part: per axis the nominal and the actual value."""

    name: str
    component: str
    line: int
    axes: dict[str, tuple[float, float]] = field(default_factory=dict)
    sized: bool = False
    unmeasured: bool = False
    """Whether an axis is there that was not measured."""


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
    features: list[_Feature] = []
    for number, raw in source.lines(drop=_CONTROLS):
        text = raw.strip().upper()
        found = _HEADING.search(text)
        if found:
            features.append(_Feature(f"{found[1]}.{found[2]}", found[1], number))
        elif text.startswith("POSN"):
            _position(source, features, number, text)
        elif text.startswith("SIZE") and features:
            features[-1].sized = True
    return _measurement(source, _of_part(source, features), ball)


def _of_part(source: Source, features: list[_Feature]) -> list[_Feature]:
    """Features of the component that the caller wants: each number is a part."""
    components: dict[str, list[_Feature]] = {}
    for feature in features:
        components.setdefault(feature.component, []).append(feature)
    if not components:
        return features
    titles = [phrase("component {}, {}", n, titled(np.array([f.line for f in own]))) for n, own in components.items()]
    return list(components.values())[chosen_part(source, titles)]


def _position(source: Source, features: list[_Feature], number: int, text: str) -> None:
    if _UNMEASURED.match(text) and features:
        features[-1].unmeasured = True
        return
    found = _POSITION.match(text)
    if found is None:
        raise source.error(phrase("{} is no whole POSN line: print the results again", shown(text)), number)
    if not features:
        raise source.error(phrase("a POSN line without COMPONENT NO and FEATURE NO above it"), number)
    axis, fields = found[1], [found[k] for k in (2, 3, 5)]
    nominal, actual, deviation = (float(re.sub(r"\s", "", f)) for f in fields)
    if not max(abs(nominal), abs(actual), abs(deviation)) <= _LARGEST:
        raise source.error(phrase("a value is no length that a machine can travel"), number)
    # Nominal and actual are printed alike, perhaps without last zeros, the deviation sometimes finer.
    places = [len(f.partition(".")[2]) for f in fields]
    rounding = 10.0 ** -max(places[:2]) + 10.0 ** -max(places) / 2
    if abs(deviation - (actual - nominal)) > _BESIDES * rounding:
        raise source.error(phrase("axis {}: DEV is not ACTUAL less nominal, the line is damaged", axis), number)
    if axis in features[-1].axes:
        raise source.error(phrase("axis {} of feature {} is there twice", axis, features[-1].name), number)
    features[-1].axes[axis] = (nominal, actual)


def _measurement(source: Source, features: list[_Feature], ball: float) -> Measurement:
    points = [f for f in features if not f.sized and {"X", "Y"} <= f.axes.keys()]
    lone = [f for f in features if not f.sized and len(f.axes.keys() & {"X", "Y", "Z"}) == 1]
    if not points:
        raise source.error(
            phrase(
                "none of {} features has POSN X and POSN Y without SIZE: measure the contour by points", len(features)
            ),
            features[0].line if features else None,
        )
    heights = [f for f in points if "Z" in f.axes]
    if heights and len(heights) < len(points):
        other = next(f for f in points if "Z" not in f.axes)
        raise source.error(phrase("feature {} has no POSN Z, others have", other.name), other.line)
    names = [f.name for f in points]
    if len(set(names)) < len(names):
        again = next(f for k, f in enumerate(points) if f.name in names[:k])
        raise source.error(
            phrase("component and feature {} are there twice: keep one print-out", again.name), again.line
        )
    notes = []
    if lone:
        notes.append(
            phrase(
                "{} features left out: measured along one axis only, as feature {} (line {}); print where "
                "the ball stood",
                len(lone),
                lone[0].name,
                lone[0].line,
            )
        )
    sized = sum(f.sized for f in features)
    if sized:
        notes.append(phrase("{} features with a size left out", sized))
    unmeasured = sum(f.unmeasured for f in features)
    if unmeasured:
        notes.append(phrase("{} features have an axis that was not measured (ACTUAL NaN)", unmeasured))
    rest = len(features) - len(points) - len(lone) - sized
    if rest:
        notes.append(phrase("{} features without POSN of X and Y left out", rest))
    table = np.array([[f.axes.get(a, (0.0, 0.0)) for a in "XYZ"] for f in points])
    return source.measurement(
        "renishaw", table[:, :, 1], [f.line for f in points], ball_radius=ball, unit=source.unit(None),
        nominal=table[:, :, 0], elements=names, has_z=bool(heights), notes=notes,
    )  # fmt: skip
