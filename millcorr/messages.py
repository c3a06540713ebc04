# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said to the user, as data: a text in pieces, some of which name an option, its value, or a way out.

A message is a string, worded for the command line. A front that calls options otherwise words the pieces itself
(`Message.in_words`) and never reads the text.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

FLAGS = {"unmeasured_share": "unmeasured", "tools": "tool", "probe_tool": "tool"}
"""Options that the command line calls otherwise than by their key."""


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
class Place:
    """File, and line from 1 where it is known, that a message is about."""

    file: str
    line: int | None = None

    def __str__(self) -> str:
        if self.line is None:
            return self.file
        return f"{self.file}:{self.line}" if self.file else f"line {self.line}"


Piece = str | Option | Accept | Place


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
    """A text with its pieces.

    Parameters
    ----------
    *pieces : str, Option or Accept
        In order; a message among them brings its own.

    Examples
    --------
    >>> found = Message("the file is in inches: ", remedy("units", "inch"))
    >>> found
    'the file is in inches: --units inch'
    >>> found.in_words(lambda piece: f"\u201c{piece.key}\u201d {piece.shown}")
    'the file is in inches: \u201cunits\u201d inch'
    """

    pieces: tuple[Piece, ...]

    def __new__(cls, *pieces: Piece) -> Message:
        """Put the text together."""
        flat: list[Piece] = []
        for piece in pieces:
            flat += piece.pieces if isinstance(piece, Message) else (piece,)
        out = super().__new__(cls, "".join(map(str, flat)))
        out.pieces = tuple(flat)
        return out

    def __add__(self, other: str) -> Message:
        return Message(self, other)

    def __radd__(self, other: str) -> Message:
        return Message(other, self)

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

    def in_words(self, name: Callable[[Option], str]) -> str:
        """The text with options in a front's own words, which has its own way to accept a finding."""
        return "".join(
            name(piece) if isinstance(piece, Option) else "" if isinstance(piece, Accept) else str(piece)
            for piece in self.pieces
        )


def message(*pieces: Piece) -> Message:
    """A message of pieces."""
    return Message(*pieces)


def message_of(said: object) -> Message:
    """What an error, or a text, says, with its pieces where it has them."""
    said = getattr(said, "message", said)
    return said if isinstance(said, Message) else Message(str(said))
