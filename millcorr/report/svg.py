# SPDX-License-Identifier: LGPL-2.1-or-later
"""Just enough SVG for plots: a canvas, linear axes with round ticks, markers, thinning.

Looks are left to style sheets: every element carries class names only, so one drawing serves light, dark and
paper.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from html import escape

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats

MARKERS = (
    "m-2.2 0a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0-4.4 0",
    "m-2-2h4v4h-4z",
    "m0-2.6l2.4 4.2h-4.8z",
    "m0-2.8l2.4 2.8l-2.4 2.8l-2.4-2.8z",
    "m-2.4 0h4.8m-2.4-2.4v4.8",
    "m-2-2l4 4m-4 0l4-4",
)
"""Outlines round a point, told apart without colour: circle, square, triangle, diamond, plus, cross."""


@dataclass(slots=True)
class Canvas:
    """Elements of one drawing, in user units (CSS pixels), y downward.

    Parameters
    ----------
    width, height : float
    title : str
        What the drawing shows, for those who cannot see it.
    """

    width: float
    height: float
    title: str
    parts: list[str] = field(default_factory=list)

    def add(self, element: str) -> None:
        """Append an element as text."""
        self.parts.append(element)

    def line(self, x0: float, y0: float, x1: float, y1: float, css: str) -> None:
        """Straight line."""
        self.add(f'<path class="{css}" d="M{_n(x0)} {_n(y0)}L{_n(x1)} {_n(y1)}"/>')

    def rect(self, x: float, y: float, width: float, height: float, css: str) -> None:
        """Rectangle."""
        self.add(f'<rect class="{css}" x="{_n(x)}" y="{_n(y)}" width="{_n(width)}" height="{_n(height)}"/>')

    def text(self, x: float, y: float, text: str, css: str = "label", anchor: str = "start", turn: float = 0) -> None:
        """Text with its base line at a point; `turn` in degrees clockwise."""
        turned = f' transform="rotate({turn:g} {_n(x)} {_n(y)})"' if turn else ""
        self.add(f'<text class="{css}" x="{_n(x)}" y="{_n(y)}" text-anchor="{anchor}"{turned}>{escape(text)}</text>')

    def path(self, data: str, css: str, clip: str = "") -> None:
        """Path from its data; nothing where there are none."""
        if data:
            clipped = f' clip-path="url(#{clip})"' if clip else ""
            self.add(f'<path class="{css}" d="{data}"{clipped}/>')

    def clip(self, name: str, x: float, y: float, width: float, height: float) -> None:
        """Define a rectangle to clip by."""
        size = f'width="{_n(width)}" height="{_n(height)}"'
        # Renderers that know of no clipping (Qt's) draw the rectangle.
        self.add(f'<clipPath id="{name}"><rect fill="none" x="{_n(x)}" y="{_n(y)}" {size}/></clipPath>')

    def legend(self, x: float, y: float, entries: Iterable[tuple[str, Sequence[tuple[str, str]]]]) -> None:
        """Row of entries: text, and what stands before it as (class, path data round its middle)."""
        for text, shapes in entries:
            for css, data in shapes:
                self.add(f'<path class="{css}" d="M{_n(x + 10)} {_n(y - 4)}{data}"/>')
            self.text(x + 24, y, text, "legend")
            x += 24 + 5.7 * len(text) + 18

    def __str__(self) -> str:
        size = f"0 0 {_n(self.width)} {_n(self.height)}"
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{size}" role="img">'
            f"<title>{escape(self.title)}</title>{''.join(self.parts)}</svg>"
        )


@dataclass(frozen=True, slots=True)
class Axis:
    """Linear map from a quantity to the canvas.

    Parameters
    ----------
    low, high : float
        Range of the quantity.
    start, end : float
        Where its ends lie on the canvas.
    """

    low: float
    high: float
    start: float
    end: float

    def __call__(self, value: ArrayLike) -> Floats:
        """Places on the canvas."""
        share = (np.asarray(value, dtype=np.float64) - self.low) / (self.high - self.low)
        out: Floats = self.start + share * (self.end - self.start)
        return out

    def scaled(self, factor: float) -> Axis:
        """The axis of the quantity in another unit, so many of which are one of its own."""
        return Axis(self.low * factor, self.high * factor, self.start, self.end)

    def at(self, value: float) -> float:
        """Place of one value."""
        return float(self(value))

    def ticks(self, most: int) -> list[float]:
        """Round values within the range, at most about `most`."""
        step = round_step((self.high - self.low) / max(most, 1))
        first = math.ceil(self.low / step - 1e-9)
        last = math.floor(self.high / step + 1e-9)
        return [round(k * step, 12) for k in range(first, last + 1)]


def round_step(least: float) -> float:
    """Smallest 1, 2 or 5 times a power of ten that is not below `least`."""
    if not (least > 0 and math.isfinite(least)):
        return 1.0
    power = 10.0 ** math.floor(math.log10(least))
    for factor in (1.0, 2.0, 5.0):
        if factor * power >= least * (1 - 1e-9):
            return factor * power
    return 10.0 * power


def round_down(most: float) -> float:
    """Largest 1, 2 or 5 times a power of ten that is not above `most` (positive)."""
    power = 10.0 ** math.floor(math.log10(most) + 1e-12)
    return max(factor * power for factor in (1.0, 2.0, 5.0) if factor == 1.0 or factor * power <= most * (1 + 1e-9))


def number(value: float) -> str:
    """A tick's number, with a real minus sign."""
    return f"{value:.10g}".replace("-", "\N{MINUS SIGN}")


def polyline(x: Floats, y: Floats, closed: bool = False) -> str:
    """Path data through points; '' for fewer than two."""
    if len(x) < 2:
        return ""
    return "M" + "L".join(f"{a} {b}" for a, b in _pairs(x, y)) + ("z" if closed else "")


def markers(x: Floats, y: Floats, shape: int) -> str:
    """Path data of one marker at every point."""
    outline = MARKERS[shape % len(MARKERS)]
    return "".join(f"M{a} {b}{outline}" for a, b in _pairs(x, y))


def bars(x: Floats, low: Floats, high: Floats) -> str:
    """Path data of one upright stroke a column, at least half a pixel high."""
    high = np.where(np.abs(high - low) < 0.5, low + 0.5, high)
    return "".join(f"M{a} {b}V{c}" for (a, b), c in zip(_pairs(x, low), _strings(high), strict=True))


def columns(x: Floats, values: Sequence[Floats]) -> tuple[Floats, list[tuple[Floats, Floats, Floats]]]:
    """Gather points by pixel column.

    Parameters
    ----------
    x : (n,) float64
        Places on the canvas.
    values : sequence of (n,) float64

    Returns
    -------
    middle : (c,) float64
        Middles of the columns that have points.
    list of (low, mean, high)
        Of each row of values, each (c,).
    """
    column, inverse = np.unique(np.floor(x).astype(np.int64), return_inverse=True)
    count = np.bincount(inverse)
    order = np.argsort(inverse, kind="stable")
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    out = []
    for value in values:
        ordered: Floats = value[order]
        low: Floats = np.minimum.reduceat(ordered, first)
        mean: Floats = np.add.reduceat(ordered, first) / count
        high: Floats = np.maximum.reduceat(ordered, first)
        out.append((low, mean, high))
    return column.astype(np.float64) + 0.5, out


def _n(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _strings(x: Floats) -> list[str]:
    return [_n(v) for v in x.tolist()]


def _pairs(x: Floats, y: Floats) -> list[tuple[str, str]]:
    return list(zip(_strings(x), _strings(y), strict=True))
