# SPDX-License-Identifier: LGPL-2.1-or-later
"""One line of an NC program, its words changed in place."""

from __future__ import annotations

import re
from collections.abc import Sequence

from .codes import CIRCLE_BY_POINT, TANGENT_CIRCLE
from .statements import CENTRES, INCREMENTS, POSITIONS, Piece
from .words import COMMENT

_RANK = {letter: rank for rank, letter in enumerate("G X Y Z A B C U V W I J K R P Q".split())}

_MOTIONS = (0, 1, 2, 3, 5, CIRCLE_BY_POINT, TANGENT_CIRCLE)

_WORD = re.compile(r"([A-Za-z])([ \t]*[-+]?(?:[ \t]*[0-9.])+)")


class Line:
    """A line of text as words and what stands between them.

    Parameters
    ----------
    text : str
        The line without its ending.
    pieces : sequence of Piece
        Words and places of a line that holds more than plain words.
    """

    def __init__(self, text: str, pieces: Sequence[Piece] = ()) -> None:
        self.gaps: list[str] = []
        self.words: list[str] = []
        self.values: list[float] = []
        self.letters = ""
        self.pieces: list[Piece | None] = []
        if pieces:
            self._take(text, pieces)
            return
        blanked = text
        if "(" in text or ";" in text:
            marked = COMMENT.sub(lambda m: b" " * len(m.group()), text.encode("latin-1"))
            blanked = marked.decode("latin-1")
        place = 0
        for found in _WORD.finditer(blanked):
            self.gaps.append(text[place : found.start()])
            self.words.append(found.group())
            self.letters += found.group(1).upper()
            self.values.append(_value(found.group(2)))
            place = found.end()
        self.gaps.append(text[place:])

    def _take(self, text: str, pieces: Sequence[Piece]) -> None:
        place = 0
        for piece in sorted(pieces, key=lambda p: p.start):
            if piece.start == piece.end:
                continue
            self.gaps.append(text[place : piece.start])
            self.words.append(text[piece.start : piece.end])
            self.letters += piece.letter
            self.values.append(piece.value)
            self.pieces.append(piece)
            place = piece.end
        self.gaps.append(text[place:])

    def axis(self, axis: str) -> tuple[int, bool | None]:
        """Index of the word of an axis, and whether it states an increment; -1 without one, None where G90, G91 say."""
        i = self.letters.find(axis)
        if i >= 0 or not self.pieces:
            return i, None
        i = self.letters.find(INCREMENTS[axis])
        return (i, True) if i >= 0 else (self.letters.find(POSITIONS[axis]), False)

    @property
    def stated_centre(self) -> bool:
        """Whether the centre of an arc is stated as positions, whatever is in force."""
        return any(letter in self.letters for letter in CENTRES)

    def text(self) -> str:
        """Return the line as it now reads."""
        return "".join([piece for pair in zip(self.gaps, self.words, strict=False) for piece in pair]) + self.gaps[-1]

    def letter(self, index: int) -> str:
        """Letter of a word, upper case."""
        return self.letters[index]

    def value(self, index: int) -> float:
        """Return the number of a word."""
        return self.values[index]

    def find(self, letter: str) -> int:
        """Index of the first word with this letter; -1 without one."""
        return self.letters.find(letter)

    def number(self, letter: str) -> float | None:
        """Return the number of the first word with this letter; None without one."""
        i = self.letters.find(letter)
        return None if i < 0 else self.values[i]

    def motion(self) -> int:
        """Index of the word G0 to G3 or G5; -1 without one."""
        i = self.letters.find("G")
        while i >= 0 and self.values[i] not in _MOTIONS:
            i = self.letters.find("G", i + 1)
        return i

    def set_number(self, index: int, number: str) -> None:
        """Give a word another number."""
        piece = self.pieces[index] if self.pieces else None
        if piece is None or len(piece.before) == 1:
            self.words[index] = self.words[index][0] + number
        elif piece.letter == "G":
            self.words[index] = ("g" if self.words[index].islower() else "G") + number
        else:
            before, after = piece.before, piece.after
            self.words[index] = (before.lower() if self.words[index].islower() else before) + number + after
        self.values[index] = _value(number)

    def remove(self, letter: str) -> None:
        """Take the first word with this letter away, if there is one, with a blank beside it."""
        i = self.find(letter)
        if i >= 0:
            self.remove_at(i)

    def remove_at(self, index: int) -> None:
        """Take a word away with a blank beside it."""
        del self.words[index], self.values[index]
        if self.pieces:
            del self.pieces[index]
        self.letters = self.letters[:index] + self.letters[index + 1 :]
        before, behind = self.gaps[index], self.gaps.pop(index + 1)
        if index and not before.strip(" \t"):
            before = ""
        elif not behind.strip(" \t"):
            behind = ""
        self.gaps[index] = before + behind

    def insert(self, word: str, blanks: bool) -> None:
        """Put a word (X5 or X=5) where its letter belongs among the others."""
        letter = word[0].upper()
        rank = _RANK.get(letter, len(_RANK))
        ranks = [_RANK.get(c, -1) for c in self.letters]
        before = [(r, i) for i, r in enumerate(ranks) if 0 <= r <= rank]
        behind = [i for i, r in enumerate(ranks) if r > rank]
        if before:
            at = max(i for _, i in before) + 1 if rank == len(_RANK) else max(before)[1] + 1
        elif behind:
            at = behind[0]
        else:
            at = 1 if self.letters.startswith("N") else 0
        inner = self.gaps[1:-1]
        if inner:
            blanks = any(g[:1] in (" ", "\t") for g in inner)
        blank = " " if blanks else ""
        if at == 0:
            self.gaps.insert(1, blank if self.words else "")
        else:
            self.gaps.insert(at, blank)
        self.words.insert(at, word)
        if self.pieces:
            self.pieces.insert(at, None)
        self.values.insert(at, _value(word[1:].removeprefix("=")))
        self.letters = self.letters[:at] + letter + self.letters[at:]


def _value(number: str) -> float:
    try:
        return float(number)
    except ValueError:
        return float(re.sub(r"[ \t]", "", number))
