# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in FreeCAD's words: its language, its fields in place of options, its unit of length."""

from __future__ import annotations

from millcorr.messages import Accept, Coordinates, Length, Option, Place, Wording, message_of
from millcorr.options import field_name

from .text import label_of, translate
from .unit import unit


class InFreeCAD(Wording):
    """The wording of windows, of what FreeCAD shows of objects, and of reports that it writes."""

    def template(self, text: str) -> str:
        """The phrase in FreeCAD's language, where it has been translated."""
        return translate("Millcorr_Said", text)

    def piece(self, piece: Option | Accept | Place | Length | Coordinates) -> str:
        """Options by their fields; accepting a finding is a button, and no words."""
        match piece:
            case Option():
                label = label_of(field_name(piece.key))
                return f"\u201c{label}\u201d {piece.shown}".rstrip()
            case Accept():
                return ""
            case Place(line=int() as line) if piece.file:
                return translate("Millcorr", "{}, line {}").format(piece.file, line)
            case Place(line=int() as line):
                return translate("Millcorr", "line {}").format(line)
            case Length():
                return unit().said(piece)
            case Coordinates():
                return unit().coordinates(piece)
        return str(piece)


IN_FREECAD = InFreeCAD()


def worded(said: object) -> str:
    """A message, or what an error says, in FreeCAD's words."""
    return message_of(said).in_words(IN_FREECAD)
