# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in FreeCAD's words: its language, its fields in place of options, its unit of length."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from millcorr.correction.settings import Settings
from millcorr.errors import MillcorrError
from millcorr.messages import Accept, Accepted, Coordinates, Length, Option, Place, Wording, message_of, mm, phrase
from millcorr.options import field_name, options_of
from millcorr.readers.reading import Reading
from millcorr.report.length_unit import MM, LengthUnit
from millcorr.report.reader import Reader

from .text import label_of, translate, words_of
from .unit import unit

LENGTHS = {one.field for noun in (Settings, Reading) for one in options_of(noun).values() if one.unit == "MM"}
"""Fields of options that are lengths."""


class InFields(Wording):
    """Options by their fields, lengths in FreeCAD's unit, in English."""

    def piece(self, piece: Option | Accept | Accepted | Place | Length | Coordinates) -> str:
        """A piece; accepting a finding is a button, and no words."""
        match piece:
            case Option():
                field = field_name(piece.key)
                quoted = phrase("\u201c{}\u201d", self.label(field)).in_words(self)
                return f"{quoted} {self.value(field, piece.value)}".rstrip()
            case Accept():
                return ""
            case Place(line=int() as line) if piece.file:
                return phrase("{}, line {}", piece.file, line).in_words(self)
            case Place(line=int() as line):
                return phrase("line {}", line).in_words(self)
            case Length():
                return self.unit().said(piece)
            case Coordinates():
                return self.unit().coordinates(piece)
        return str(piece)

    def value(self, field: str, value: object) -> str:
        """What a field shows; empty where that is nothing, or where it is a switch."""
        if field in LENGTHS and isinstance(value, float):
            return self.unit().said(mm(value, "g"))
        return Option(field, value).shown

    def label(self, name: str) -> str:
        """What a field is called."""
        return words_of(name)

    def unit(self) -> LengthUnit:
        """In which lengths are said."""
        raise NotImplementedError


class InDocuments(InFields):
    """The same in mm whoever opens the document."""

    def unit(self) -> LengthUnit:
        """Millimetres."""
        return MM


class InWindow(InFields):
    """The same in the window's language, as far as it is translated."""

    def template(self, text: str) -> str:
        """A phrase in the window's language."""
        return translate("Millcorr_Said", text)

    def label(self, name: str) -> str:
        """What a field is called in forms."""
        return label_of(name)

    def unit(self) -> LengthUnit:
        """With names in the window's language."""
        return unit()


_STORED, _WINDOW = InDocuments(), InWindow()


def worded(said: object) -> str:
    """A message, or what an error says, as the window says it."""
    return message_of(said).in_words(_WINDOW)


def value_worded(field: str, value: object) -> str:
    """What a field of the window shows."""
    return _WINDOW.value(field, value)


def stored(said: object) -> str:
    """A message as a document stores it."""
    return message_of(said).in_words(_STORED)


def reader() -> Reader:
    """FreeCAD's user as the reader of a report: their unit and language, with fields in place of options."""
    return Reader(unit(), _WINDOW)


@contextmanager
def shown_by_freecad() -> Iterator[None]:
    """What goes wrong within is shown by FreeCAD itself, at the object in the tree and in the report view."""
    try:
        yield
    except MillcorrError as error:
        error.args = (worded(error),)
        raise
