# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said to the user, as data: phrases with places for values, some of which are options, lengths, or ways out.

A message is a string, worded in English for the command line. A front that speaks another language, calls options
otherwise, or shows lengths in another unit words the pieces itself (`Message.in_words`) and never reads the text.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from numbers import Integral, Real
from string import Formatter
from typing import Any, get_args

FLAGS = {"unmeasured_share": "unmeasured", "tools": "tool", "probe_tool": "tool"}
"""Options that the command line calls otherwise than by their key."""

AS_DATA = "MILLCORR_AS_DATA"
"""Variable of the environment: where it is set, the command line says errors as data (`as_data`)."""


@dataclass(frozen=True, slots=True)
class Option:
    """An option within a message.

    Parameters
    ----------
    key : str
        Its name in Python, such as ``"dead_band"``.
    value : object
        The value it has, or should have; None where it is only named.
    proposed : bool
        Whether the value resolves what the message is about.
    of : str
        What stands for a value that only the user knows, such as ``"MM"``; empty where none is asked for.
    """

    key: str
    value: object = None
    proposed: bool = False
    of: str = ""

    @property
    def shown(self) -> str:
        """The value in words; empty where there is none, or where it is a switch."""
        if self.value is None or self.value is True:
            return ""
        return f"{self.value:g}" if isinstance(self.value, float) else str(self.value)

    def __str__(self) -> str:
        return f"{flag(self.key)} {self.shown or self.of}".rstrip()


@dataclass(frozen=True, slots=True)
class Accept:
    """The way to go on in spite of a finding: to accept it, by its name."""

    finding: str

    def __str__(self) -> str:
        return f" (if it is right as it is: {flag('accept')} {self.finding})"


@dataclass(frozen=True, slots=True)
class Accepted:
    """Name of a finding that was accepted, and the place in XY, mm, that it is about, where it is about one."""

    finding: str
    place: tuple[float, float] | None = None

    def __str__(self) -> str:
        return self.finding


@dataclass(frozen=True, slots=True)
class Place:
    """File, and line from 1 where it is known, that a message is about."""

    file: str
    line: int | None = None

    def __str__(self) -> str:
        if self.line is None:
            return self.file
        return f"{self.file}:{self.line}" if self.file else f"line {self.line}"


@dataclass(frozen=True, slots=True)
class Length:
    """A length within a message.

    Parameters
    ----------
    mm : float
    form : str
        Python's format of its number.
    fine : bool
        Whether it is said in micrometres, as deviations are.
    """

    mm: float
    form: str
    fine: bool = False

    def __str__(self) -> str:
        return f"{1e3 * self.mm:{self.form}} um" if self.fine else f"{self.mm:{self.form}} mm"


@dataclass(frozen=True, slots=True)
class Coordinates:
    """A place within a message: letters of axes, and where on each, mm."""

    axes: str
    values: tuple[float, ...]

    def __str__(self) -> str:
        return " ".join(f"{axis}{value:.3f}" for axis, value in zip(self.axes, self.values, strict=True))


@dataclass(frozen=True, slots=True)
class Phrase:
    """A text with places for values, which a front may say in another language.

    Parameters
    ----------
    template : str
        With a ``{}`` for each value, as Python's `str.format` takes it.
    values : tuple
        Pieces, messages, or anything that can be formatted.
    """

    template: str
    values: tuple[object, ...]

    def __str__(self) -> str:
        return self.template.format(*self.values)


Piece = str | Option | Accept | Accepted | Place | Length | Coordinates | Phrase


class Wording:
    """How a front says what messages are made of; as it stands, the command line's."""

    def template(self, text: str) -> str:
        """Text of a phrase."""
        return text

    def piece(self, piece: Option | Accept | Accepted | Place | Length | Coordinates) -> str:
        """What is no text."""
        return str(piece)


def phrase(template: str, *values: object) -> Message:
    """A message of one phrase; parameters as of `Phrase`."""
    return Message(Phrase(template, values))


def mm(value: float, form: str = ".3f") -> Length:
    """A length in mm, and Python's format of its number."""
    return Length(float(value), form)


def um(value: float, form: str = ".1f") -> Length:
    """A length in mm that is said in micrometres."""
    return Length(float(value), form, fine=True)


def xy(x: float, y: float) -> Coordinates:
    """A place in the plane, mm."""
    return Coordinates("XY", (float(x), float(y)))


def at_z(value: float) -> Coordinates:
    """A height, mm."""
    return Coordinates("Z", (float(value),))


def flag(key: str) -> str:
    """What the command line calls an option: ``dead_band`` is ``--dead-band``."""
    return "--" + FLAGS.get(key, key).replace("_", "-")


def option(key: str, value: object = None, *, of: str = "") -> Option:
    """An option that a message is about: with the value it has, or with what stands `of` one that is missing."""
    return Option(key, value, of=of)


def remedy(key: str, value: object = True) -> Option:
    """An option with the value that resolves what the message is about; True switches it on."""
    return Option(key, value, proposed=True)


class Message(str):
    """A text with its parts.

    Parameters
    ----------
    *parts : Piece
        In order; a message among them brings its own.

    Examples
    --------
    >>> found = phrase("the file is in inches: {}", remedy("units", "inch"))
    >>> found
    'the file is in inches: --units inch'
    >>> class German(Wording):
    ...     def template(self, text):
    ...         return "die Datei ist in Zoll: {}"
    ...
    ...     def piece(self, piece):
    ...         return f"\u201eEinheit\u201c {piece.shown}"
    >>> found.in_words(German())
    'die Datei ist in Zoll: \u201eEinheit\u201c inch'
    """

    parts: tuple[Piece, ...]

    def __new__(cls, *parts: Piece) -> Message:
        """Put the text together."""
        flat: list[Piece] = []
        for part in parts:
            flat += part.parts if isinstance(part, Message) else (part,)
        out = super().__new__(cls, "".join(map(str, flat)))
        out.parts = tuple(flat)
        return out

    def __add__(self, other: str) -> Message:
        return Message(self, other)

    def __radd__(self, other: str) -> Message:
        return Message(other, self)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """What it says in order, with the texts and the values of its phrases one by one."""
        return tuple(_pieces(self.parts))

    @property
    def options(self) -> tuple[Option, ...]:
        """Options that it names, in their order."""
        return tuple(piece for piece in self.pieces if isinstance(piece, Option))

    @property
    def subject(self) -> str:
        """Key of the option that it begins with, whose value it is about; empty where it begins otherwise."""
        first = next((piece for piece in self.pieces if piece != ""), None)
        return first.key if isinstance(first, Option) else ""

    @property
    def missing(self) -> tuple[str, ...]:
        """Keys of options that it asks for."""
        return tuple(one.key for one in self.options if one.of)

    @property
    def file(self) -> str:
        """File that it is about; empty where it is about none."""
        return next((piece.file for piece in self.pieces if isinstance(piece, Place)), "")

    @property
    def finding(self) -> str:
        """Name of the finding that stops a correction and can be accepted; empty where there is none."""
        return next((piece.finding for piece in self.pieces if isinstance(piece, Accept)), "")

    @property
    def accepted(self) -> tuple[Accepted, ...]:
        """Findings of which it says that they were accepted."""
        return tuple(piece for piece in self.pieces if isinstance(piece, Accepted))

    def in_words(self, wording: Wording) -> str:
        """The text as a front says it."""
        return "".join(_worded(part, wording) for part in self.parts)


def _pieces(parts: tuple[object, ...]) -> Iterator[Piece]:
    """Pieces without phrases and messages around them."""
    for part in parts:
        if isinstance(part, Message):
            yield from _pieces(part.parts)
        elif isinstance(part, Phrase):
            values = iter(part.values)
            for text, field, form, conversion in Formatter().parse(part.template):
                if text:
                    yield text
                if field is not None:
                    value = next(values)
                    mark = f"!{conversion}" if conversion else ""
                    shown = value if isinstance(value, Piece) else f"{{{mark}:{form}}}".format(value)
                    yield from _pieces((shown,))
        elif isinstance(part, Piece):
            yield part


def _worded(part: object, wording: Wording) -> str:
    """What a front makes of a piece."""
    if isinstance(part, Message):
        return part.in_words(wording)
    if isinstance(part, Phrase):
        values = [_worded(value, wording) if isinstance(value, Piece) else value for value in part.values]
        return wording.template(part.template).format(*values)
    return part if isinstance(part, str) else wording.piece(part)  # type: ignore[arg-type]


def joined(texts: Iterable[Piece], by: Piece = ", ") -> Message:
    """A message of several with something between them."""
    return Message(*[part for text in texts for part in (by, text)][1:])


def message(*parts: Piece) -> Message:
    """A message of parts."""
    return Message(*parts)


def message_of(said: object) -> Message:
    """What an error, or a text, says, with its pieces where it has them."""
    said = getattr(said, "message", said)
    return said if isinstance(said, Message) else Message(str(said))


_KINDS: dict[str, type] = {kind.__name__: kind for kind in get_args(Piece) if kind is not str}


def as_data(said: object) -> object:
    """What an error, or a text, says, as JSON takes it: for a front in another process, which words it."""
    return [_piece_as_data(part) for part in message_of(said).parts]


def of_data(data: object) -> Message:
    """The message that `as_data` made data of; raises ValueError for any other."""
    if not isinstance(data, list):
        raise ValueError(f"no message: {data!r}")
    try:
        return Message(*map(_piece_of_data, data))
    except (TypeError, KeyError, AttributeError) as error:
        raise ValueError(f"no message: {error}") from error


def _piece_as_data(part: object) -> object:
    if isinstance(part, Message):
        return {"Message": as_data(part)}
    name = type(part).__name__
    if name in _KINDS:
        values = {one.name: getattr(part, one.name) for one in fields(part)}  # type: ignore[arg-type]
        return {name: {key: _piece_as_data(value) for key, value in values.items()}}
    if isinstance(part, tuple):
        return {"tuple": [_piece_as_data(value) for value in part]}
    if isinstance(part, Real) and not isinstance(part, bool):
        # Numbers of numpy are none of JSON's.
        return int(part) if isinstance(part, Integral) else float(part)
    return part if part is None or isinstance(part, bool) else str(part)


def _piece_of_data(data: Any) -> Any:
    if not isinstance(data, dict):
        return data
    ((name, inner),) = data.items()
    if name == "Message":
        return of_data(inner)
    if name == "tuple":
        return tuple(map(_piece_of_data, inner))
    return _KINDS[name](**{key: _piece_of_data(value) for key, value in inner.items()})
