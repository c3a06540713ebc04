# SPDX-License-Identifier: LGPL-2.1-or-later
"""One block being written anew: its words changed in place, everything else kept."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from millcorr.nc.style import Style

from .blocks import Block

_RANK = {name: rank for rank, name in enumerate("X Y Z A B C U V W PR PA LEN R CCA DR COMP F M".split())}
_PLACES = frozenset(("X", "Y", "Z", "PR", "PA"))


@dataclass(frozen=True, slots=True)
class Numbers:
    """How numbers are written.

    Parameters
    ----------
    style : Style
    scale : float
        mm per unit of the program.
    decimals : int
        Digits behind the point of changed numbers.
    mark : str
        Decimal point or comma.
    """

    style: Style
    scale: float
    decimals: int
    mark: str

    @property
    def unit(self) -> float:
        """Smallest step of a changed number, mm."""
        return self.scale * 10.0**-self.decimals

    def round(self, length: float) -> float:
        """A length in mm as the number in the program's unit that is written."""
        steps: float = 10.0**self.decimals
        return round(length / self.scale * steps) / steps

    def text(self, value: float, decimals: int | None = None, signed: bool = True) -> str:
        """Write a number of the program's unit."""
        decimals = self.decimals if decimals is None else decimals
        steps = round(value * 10**decimals)
        digits = f"{abs(steps):0{decimals + 1}d}"
        whole, part = digits[: len(digits) - decimals], digits[len(digits) - decimals :]
        if not self.style.trailing_zeros:
            part = part.rstrip("0")
        if part and not self.style.leading_digit and whole == "0":
            whole = ""
        sign = "-" if steps < 0 else "+" if self.style.plus and signed else ""
        return f"{sign}{whole}{self.mark if part or self.style.point else ''}{part}"


@dataclass(slots=True)
class _Piece:
    gap: str
    name: str
    text: str
    value: str
    incremental: bool


class Draft:
    """A block as its opening, its words with what stands between them, and its end.

    Parameters
    ----------
    opening : str
        Number and blanks before the block's first word.
    kind : str
        L, C, CR and so on.
    increments : bool
        Whether coordinates that are put into it are increments.

    `own` tells the draft of a block of the program from one that is inserted.
    """

    def __init__(self, opening: str, kind: str, increments: bool = False) -> None:
        self.opening = opening
        self.kind = kind
        self.increments = increments
        self.own = False
        self.pieces: list[_Piece] = []
        self.end = ""

    @staticmethod
    def of(block: Block) -> Draft:
        """The draft of a block as it stands."""
        out = Draft(block.text[: block.head], block.text[block.head : block.body], block.increments)
        out.own = True
        place = block.body
        for word in block.words:
            text = block.text[word.start : word.stop]
            out.pieces.append(_Piece(block.text[place : word.start], word.name, text, word.value, word.incremental))
            place = word.stop
        out.end = block.text[place:]
        if not block.kind:
            out.kind = ""
        return out

    def copy(self) -> Draft:
        """Another draft of the same words."""
        out = Draft(self.opening, self.kind, self.increments)
        out.own = self.own
        out.pieces = [replace(piece) for piece in self.pieces]
        out.end = self.end
        return out

    def text(self) -> str:
        """The block as it now reads."""
        return self.opening + self.kind + "".join(p.gap + p.text for p in self.pieces) + self.end

    def find(self, name: str) -> _Piece | None:
        """The first word of a name."""
        return next((p for p in self.pieces if p.name == name), None)

    def put(self, name: str, number: str, value: str) -> None:
        """Give a word another number, or put it where it belongs."""
        piece = self.find(name)
        if piece is not None:
            letters = re.match(r"[A-Za-z]*[ \t]*", piece.text)
            piece.text, piece.value = (letters.group() if letters else name) + number, value
            return
        rank = _RANK[name]
        place = 0
        for i, other in enumerate(self.pieces):
            if _RANK.get(other.name, len(_RANK)) <= rank:
                place = i + 1
        gap = " " if self.kind or place else ""
        more = self.increments and name in _PLACES
        self.pieces.insert(place, _Piece(gap, name, ("I" if more else "") + name + number, value, more))
        if not gap and len(self.pieces) > 1 and not self.pieces[1].gap:
            self.pieces[1].gap = " "

    def counts_on(self, name: str) -> bool:
        """Whether the number of a word, or of one that would be put, is an increment."""
        piece = self.find(name)
        return self.increments and name in _PLACES if piece is None else piece.incremental

    def remove(self, *names: str) -> None:
        """Take words away."""
        self.pieces = [p for p in self.pieces if p.name not in names]

    def take(self, *names: str) -> list[_Piece]:
        """Take words away and return them."""
        out = [p for p in self.pieces if p.name in names]
        self.pieces = [p for p in self.pieces if p.name not in names]
        return out
