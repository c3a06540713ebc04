# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who reads a report: the unit in which lengths are shown to them, and how messages are worded."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

from millcorr.messages import Accept, Accepted, Coordinates, Length, Option, Place, Wording, message_of, mm, um

from .length_unit import MM, LengthUnit


@dataclass(frozen=True, slots=True)
class Reader:
    """A reader.

    Parameters
    ----------
    unit : LengthUnit
    wording : Wording
        By default the command line's.
    """

    unit: LengthUnit = MM
    wording: Wording = Wording()


_PLAIN = Reader()
_reader: ContextVar[Reader] = ContextVar("reader", default=_PLAIN)


@contextmanager
def read_by(reader: Reader) -> Iterator[None]:
    """Pages and plots that are made within are for this reader."""
    before = _reader.set(reader)
    try:
        yield
    finally:
        _reader.reset(before)


def unit() -> LengthUnit:
    """The reader's unit."""
    return _reader.get().unit


def fine() -> str:
    """Name of the reader's small unit, in which deviations are."""
    return unit().fine


def coarse() -> str:
    """Name of the reader's unit, in which coordinates and lengths are."""
    return unit().name


def fine_per_mm() -> float:
    """So many of the reader's small units are a millimetre."""
    return 1.0 / unit().fine_mm


def length(value: float, form: str = "g") -> str:
    """A length given in mm, with the name of the reader's unit."""
    return unit().said(mm(value, form)).replace("-", "\N{MINUS SIGN}")


def shown(value: float, form: str = ".2f") -> str:
    """A deviation given in mm, with the name of the reader's small unit."""
    return small(value, form).replace("-", "\N{MINUS SIGN}")


def small(value: float, form: str) -> str:
    """The same as a terminal shows it."""
    return unit().said(um(value, form))


def feed() -> str:
    """Name of the reader's unit of feeds."""
    return f"{coarse()}/min"


def feed_in_unit(value: Any) -> Any:
    """Feeds given in mm/s, in the reader's unit."""
    return 60.0 * value / unit().mm


class _InUnit(Wording):
    """A reader's wording, with lengths in their unit."""

    def template(self, text: str) -> str:
        return _reader.get().wording.template(text)

    def piece(self, piece: Option | Accept | Accepted | Place | Length | Coordinates) -> str:
        if isinstance(piece, Length):
            return unit().said(piece)
        return unit().coordinates(piece) if isinstance(piece, Coordinates) else _reader.get().wording.piece(piece)


_IN_UNIT = _InUnit()


def worded(said: object) -> str:
    """A message in the reader's words and unit."""
    return message_of(said).in_words(_IN_UNIT)
