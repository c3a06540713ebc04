# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a plain-language program taken apart into blocks and words, without asking what they mean."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from millcorr.arrays import Ints
from millcorr.errors import FormatError
from millcorr.messages import phrase

PATHS = ("L", "LP", "C", "CP", "CR", "CT", "CTP")
"""Blocks that are one contour element."""
CORNERS = ("RND", "CHF")
APPROACHES = tuple(f"APPR {form}" for form in ("LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"))
DEPARTURES = tuple(f"DEP {form}" for form in ("LT", "LN", "CT", "LCT", "PLCT"))
MOTIONS = (*PATHS, *CORNERS, *APPROACHES, *DEPARTURES)
MOVING = frozenset((*MOTIONS, "", "LN"))
"""Blocks that may move; "" are words without one."""
SILENT = ("COMMENT", "BLK FORM", "TOOL DEF", "CC", "Q", "FN", "LBL", "STOP", "EMPTY", "QUIET")
"""Blocks that may stand between a contour element and the next one."""

_OPENING = re.compile(r"(?:[\xcf\xef]\xbb\xbf)?[ \t]*(?:/[ \t]*)?(?:(\d+)(?=[ \t/;*]|$)[ \t]*)?(?:/[ \t]*)?")
_KIND = re.compile(
    r"(BEGIN[ \t]+PGM|END[ \t]+PGM|BLK[ \t]+FORM|TOOL[ \t]+CALL|TOOL[ \t]+DEF|CALL[ \t]+LBL|CALL[ \t]+PGM"
    r"|CYCL[ \t]+DEF|CYCL[ \t]+CALL|TCH[ \t]+PROBE|APPR[ \t]+P?(?:LT|LN|CT|LCT)|DEP[ \t]+P?(?:LT|LN|CT|LCT)"
    r"|LBL|STOP|FN[ \t]*\d+(?=[ \t]*:)|Q[LRS]?\d+(?=[ \t]*=)"
    r"|LP|LN|L|CTP|CT|CP|CR|CC|C|RND|CHF|M(?=[ \t]*\d)|[A-Z][A-Z_0-9]*)(?![A-Z_])"
)
_WORD = re.compile(
    r"[ \t\r\n~\x1a]*(?P<word>(?P<comp>R0|RL|RR|R[+-](?![ \t]*[Q\d.,]))(?![\d.,])"
    r"|(?P<feed>F)[ \t]*(?P<mode>MAX|AUTO)(?![A-Z])"
    r"|(?P<turn>DR)(?P<sense>[+-])(?![\d.,Q])"
    r"|(?P<name>CHF|I?(?:PR|PA)|I?[XYZABCUVW]|LEN|CCA|F[UZT]|F|R|MB|M)"
    r"(?:[ \t]*(?P<value>[+-]?[ \t]*(?:\d+(?:[.,]\d*)?|[.,]\d+|Q[LR]?\d+)|MAX)(?![\d.,])|(?![A-Z\d.,])))"
)
_PLACES = frozenset(("X", "Y", "Z", "PR", "PA"))
_SHORT = re.compile(r"(?:I?[XYZABCUVW])[ \t]*[+-]?[ \t]*[Q\d.,]|M[ \t]*\d")
WITH_MORE = (101, 103, 118, 120, 128, 138, 140, 142, 143)
"""Numbers of M codes that take words of their own behind them."""


@dataclass(slots=True)
class Word:
    """A word of a block.

    Parameters
    ----------
    name : str
        X, PR, R, LEN, F, M, COMP (R0, RL, RR), DR; without the I of an increment.
    value : str
        Number or parameter with its sign, blanks and decimal comma taken out; MAX, AUTO, L, R, 0, +, -; or nothing.
    start, stop : int
        Where it stands in the block's text.
    incremental : bool
    """

    name: str
    value: str
    start: int
    stop: int
    incremental: bool = False


@dataclass(slots=True)
class Block:
    """One block: a line of text, or several of them.

    Parameters
    ----------
    first, last : int
        Its lines, from 0.
    text : str
        Without the ending of its last line.
    ending : str
    kind : str
        One of `MOTIONS`, `SILENT`, or the words that a block begins with; "" for words without one.
    number : (int, int)
        Where its number stands in the text; equal without one.
    head : int
        Where `kind` begins.
    body : int
        Where the words begin.
    stop : int
        Where they end: before the comment.
    hidden : bool
        Marked with `/`.
    words : list of Word
        Of motions only.
    odd : str
        What of a motion is no word that is known.
    increments : bool
        Whether coordinates that are added to it, or behind it, are increments: G91 of an ISO program is in force.
    """

    first: int
    last: int
    text: str
    ending: str
    kind: str
    number: tuple[int, int]
    head: int
    body: int
    stop: int
    hidden: bool = False
    words: list[Word] = field(default_factory=list)
    odd: str = ""
    increments: bool = False

    @property
    def rest(self) -> str:
        """What stands behind the kind, upper case, without comments and the marks of continued lines."""
        lines = self.text[self.body :].split("\n")
        return " ".join(line[: comment_of(line, 0)].rstrip(" \t\r~") for line in lines).upper().strip()

    @property
    def names(self) -> list[str]:
        """Names of its words, in their order."""
        return [word.name for word in self.words]

    @property
    def moves(self) -> bool:
        """Whether it is a contour element: words alone (M8, R0) state no place."""
        if self.kind in ("L", "LP", ""):
            return not _PLACES.isdisjoint(self.names)
        return self.kind in PATHS

    def find(self, name: str) -> Word | None:
        """Return the first word of a name."""
        for word in self.words:
            if word.name == name:
                return word
        return None


def decoded(data: bytes) -> str:
    """The text, a character a byte."""
    return data.decode("latin-1")


def blocks_of(data: bytes, starts: Ints, name: str) -> Iterator[Block]:
    """Blocks of a program in their order.

    Parameters
    ----------
    data : bytes
    starts : (lines + 1,) int64
        Offsets of its lines.
    name : str
        Of the program, for messages.
    """
    text = decoded(data)
    bounds = starts.tolist()
    lines = len(bounds) - 1
    numbered = False
    i = 0
    while i < lines:
        last = i
        # A tilde goes on with the next line; so does a line without a number among numbered ones, as older controls
        # print their longer blocks.
        while last + 1 < lines and (
            _goes_on(text[bounds[last] : bounds[last + 1]])
            or (numbered and _belongs(text[bounds[last + 1] : bounds[last + 2]]))
        ):
            last += 1
        whole = text[bounds[i] : bounds[last + 1]]
        block = read_block(whole, i, last, name)
        numbered = numbered or (block.kind == "BEGIN PGM" and block.number[1] > block.number[0])
        yield block
        i = last + 1


def _goes_on(line: str) -> bool:
    if "~" not in line:
        return False
    bare = line.split(";")[0].rstrip() if not line.rstrip().endswith("~") else line.rstrip()
    return bare.endswith("~")


def _belongs(line: str) -> bool:
    """Whether a line without a number goes on with the block before it."""
    bare = line.strip(" \t\r\n\x1a")
    return bool(bare) and not bare[0].isdigit() and bare[0] not in ";*/%>" and line[0] in " \t"


def read_block(whole: str, first: int, last: int, name: str) -> Block:
    """Take one block apart; `whole` with its line ending."""
    text = whole.rstrip("\r\n")
    ending = whole[len(text) :]
    upper = text.upper()
    opening = _OPENING.match(upper)
    assert opening is not None
    number = opening.span(1) if opening.group(1) else (0, 0)
    head = opening.end()
    newline = text.rfind("\n") + 1
    stop = comment_of(text, max(head, newline))
    hidden = "/" in opening.group()
    bare = upper[head:stop].strip(" \t\x1a")
    if not bare:
        return Block(first, last, text, ending, "COMMENT" if stop < len(text) else "EMPTY", number, head, head, stop)
    if bare[0] in "*%":
        return Block(first, last, text, ending, "COMMENT", number, head, head, stop, hidden)
    found = None if _SHORT.match(upper, head, stop) else _KIND.match(upper, head, stop)
    kind = "" if found is None else " ".join(found.group().split())
    body = head if found is None else found.end()
    if kind.startswith("FN"):
        kind = "FN"
        body = head
    elif kind[:1] == "Q" and kind[-1].isdigit():
        kind = "Q"
        body = head
    elif kind == "M":
        kind, body = "", head
    if kind == "CHF":
        # Its length stands behind it as behind the letter of a word.
        body = head
    block = Block(first, last, text, ending, kind, number, head, body, stop, hidden)
    if kind in MOVING or kind in ("CC", "STOP"):
        _read_words(block, upper)
        if block.odd and kind == "" and not block.words:
            shown = text[head:stop].strip()[:20].encode("ascii", "replace").decode()
            raise FormatError(phrase("cannot read '{}': is this a plain-language block?", shown), name, first + 1)
    return block


def comment_of(text: str, place: int) -> int:
    """Where the comment begins; the end of the text without one."""
    if ";" not in text:
        return len(text.rstrip(" \t\x1a"))
    quoted = False
    for i in range(place, len(text)):
        if text[i] == '"':
            quoted = not quoted
        elif text[i] == ";" and not quoted:
            return i
    return len(text)


def _read_words(block: Block, upper: str) -> None:
    """Words of a motion; what is none of them is its `odd`: a comment between its lines, too."""
    place = block.body
    while found := _WORD.match(upper, place, block.stop):
        place = found.end()
        start, stop = found.span("word")
        comp, feed, mode, turn, sense, word, value = found.groups()[1:]
        if comp:
            block.words.append(Word("COMP", comp[1:], start, stop))
        elif feed:
            block.words.append(Word("F", mode, start, stop))
        elif turn:
            block.words.append(Word("DR", sense, start, stop))
        else:
            value = (value or "").replace(" ", "").replace("\t", "").replace(",", ".")
            incremental = word[0] == "I"
            block.words.append(Word(word[1:] if incremental else word, value, start, stop, incremental))
            if word == "M" and value.isdigit() and int(value) in WITH_MORE:
                return
    block.odd = next(iter(upper[place : block.stop].replace("~", " ").replace("\x1a", " ").split()), "")[:20]
