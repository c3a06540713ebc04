# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proof of a corrected plain-language program: as of ISO code, with block numbers, CC blocks and leads of its own kind.

Block numbers count on where blocks were inserted. A CC holds nothing but a place; what arcs and polar blocks make of
it is compared. Where an approach (APPR) begins and a departure (DEP) ends, the control computes anew from the moved
contour: there the words are compared, and the surface, but no place.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Ints
from millcorr.errors import LimitError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind

from .klartext_reading import read, without_numbers
from .reading import line_starts
from .text_proof import Content, Language, Text, TextProof, prove_text

_OPENING = re.compile(rb"[ \t%]*(?:BEGIN[ \t]+PGM[^\r\n]*)?[ \t]*", re.IGNORECASE)
_COMMENT = re.compile(rb"[ \t]*;[^\r\n]*")
_BLOCK = re.compile(
    r"[ \t]*(/?)[ \t]*(APPR[ \t]+P?[LCNT]+|DEP[ \t]+P?[LCNT]+|CTP|CT|CP|CR|CC|C|LP|L|RND|CHF)(?![A-Z])", re.IGNORECASE
)
_AXIS_FIRST = re.compile(r"[ \t]*(/?)[ \t]*(?=I?[XYZ][ \t]*[-+]?[\dQ.,])", re.IGNORECASE)
_NUMBER = r"[ \t]*[-+]?[ \t]*(?:Q[LR]?\d+|\d+[.,]?\d*|[.,]\d+)"
_PIECE = re.compile(
    rf"(?P<comment>;.*)|(?P<place>I?(?:X|Y|PR|PA){_NUMBER}|DR[-+])|I?Z(?P<height>{_NUMBER})|(?P<radius>R{_NUMBER})"
    rf"|(?P<word>F[ \t]*(?:MAX|AUTO)|R0(?![\d.,])|RL|RR|[A-Z]+(?:{_NUMBER})?|[^ \t])",
    re.IGNORECASE,
)
_FEED = re.compile(rb"F[\d.,]+")


@dataclass(frozen=True, slots=True)
class Script:
    """One of HEIDENHAIN's two ways to write a program, as the proof takes it.

    Parameters
    ----------
    language : Language
    without_numbers : callable
        A text without its block numbers, and these.
    led_lines : callable
        Lines of a text whose place the control computes, (lines,) bool.
    pole : re.Pattern
        Beginning of a block that states a pole.
    numbers_fit : callable
        Whether block numbers of the written text may be what they are, beside those of the original.
    """

    language: Language
    without_numbers: Callable[[bytes], tuple[bytes, list[int]]]
    led_lines: Callable[[bytes], Bools]
    pole: re.Pattern[bytes]
    numbers_fit: Callable[[list[int], list[int]], bool]

    def prove(
        self,
        original: bytes,
        written: bytes,
        may_change: Ints,
        *,
        header: Sequence[str] = (),
        reach: float = math.inf,
        tolerance: float = 0.001,
        beside: Sequence[tuple[str, bytes]] = (),
    ) -> TextProof:
        """Prove that a written program keeps everything of its original but places in the plane of some blocks.

        Parameters
        ----------
        original, written, header, reach, tolerance
            As of `prove_text`.
        may_change : sorted indices
            Lines whose places may change; blocks of poles and leads are added to them.
        beside : sequence of (str, bytes)
            Not looked at.

        Returns
        -------
        TextProof

        Raises
        ------
        LimitError
            If anything else differs; names the line of the written text and what differs.
        """
        led = self.led_lines(original)
        if original == written:
            return prove_text(original, written, may_change, language=self.language, unplaced=led)
        (old, was), (new, now) = self.without_numbers(original), self.without_numbers(written)
        if not self.numbers_fit(was, now):
            raise LimitError(
                phrase("the written program differs where it must not: its block numbers do not follow one another")
            )
        free = led.copy()
        free[may_change] = True
        starts = line_starts(old)
        free[[i for i in range(len(free)) if self.pole.match(old[starts[i] : starts[i + 1]])]] = True
        return prove_text(
            old, new, free, header=header, reach=reach, tolerance=tolerance, language=self.language, unplaced=led
        )


def led_lines(data: bytes) -> Bools:
    """Lines of a plain-language program whose place the control computes: leads, and what follows a departure.

    Returns
    -------
    (lines,) bool
    """
    starts = line_starts(data)
    out = np.zeros(len(starts) - 1, np.bool_)
    adrift: set[str] = set()
    for i in range(len(out)):
        text = data[starts[i] : starts[i + 1]].decode("latin-1").split(";")[0].upper()
        found = re.match(r"[ \t]*/?[ \t]*(?:\d+[ \t]+)?(APPR|DEP)[ \t]+(\w+)", text)
        if found is not None:
            out[i] = True
            adrift = {"X", "Y"} if found[1] == "DEP" and "LCT" not in found[2] else set()
        elif adrift and re.match(r"[ \t]*/?[ \t]*(?:\d+[ \t]+)?[LC]", text):
            out[i] = True
            adrift -= set(re.findall(r"(?<![IA-Z])([XY])[ \t]*[-+\dQ]", text))
    return out


def _numbers_fit(was: list[int], now: list[int]) -> bool:
    """Whether blocks that count on by one do so still, and others have the numbers that they had."""
    if was and was == list(range(was[0], was[0] + len(was))):
        return now == list(range(was[0], was[0] + len(now)))
    rest = iter(was)
    return all(number in rest for number in now)


def _content(text: Text, i: int) -> Content:
    line = text.line(i).decode("latin-1").rstrip("\r\n\x1a")
    found = _BLOCK.match(line) or _AXIS_FIRST.match(line)
    if found is None:
        bare = line.strip()
        return Content((bare,) if bare else (), None, None, None, "", False)
    rest: list[str] = []
    height = None
    kind = found[2].upper() if found.re is _BLOCK else ""
    led = kind.startswith(("APPR", "DEP"))
    if led:
        rest.append(re.sub(r"[ \t]+P?", " ", kind))
    for piece in _PIECE.finditer(line, found.end()):
        word = re.sub(r"[ \t]", "", piece.group()).upper()
        if piece["comment"]:
            rest.append(piece.group().strip())
        elif piece["height"]:
            height = word
        elif piece["place"] or (piece["radius"] and not led) or re.match(r"F[\d.,Q]", word):
            continue
        elif kind == "CHF" and re.fullmatch(r"[-+]?[\dQ.,]+", word):
            continue
        elif kind == "CHF" and not piece["radius"] and re.fullmatch(r"[\d.,+-]", word):
            continue
        else:
            rest.append(word)
    return Content(tuple(rest), feed_of(text, i), height, None, found[1], False)


def feed_of(text: Text, i: int) -> str | None:
    """Feed of a line's moves, where it is another one than that of the feed move before."""
    m, first = text.moves, text.first
    rows = np.arange(first[i], first[i + 1])
    if not len(rows) or (m.kind[rows] == Kind.RAPID).all():
        return None
    word = float(text.reading.feed_word[i])
    row = int(first[i]) - 1
    while row >= 0 and m.kind[row] == Kind.RAPID:
        row -= 1
    before = float(text.reading.feed_word[m.line[row]]) if row >= 0 else math.nan
    if word == before or (math.isnan(word) and math.isnan(before)):
        return None
    return f"{word:.9g}" if not math.isnan(word) else "nan"


def _feed_restated(old: bytes, new: bytes) -> bool:
    bare = re.split(rb"[;\"]", new)[0]
    return any(bare[: m.start()] + bare[m.end() :] + new[len(bare) :] == old for m in _FEED.finditer(bare))


KLARTEXT = Language(read=read, content=_content, restated=_feed_restated, opening=_OPENING, comment=_COMMENT)
SCRIPT = Script(KLARTEXT, without_numbers, led_lines, re.compile(rb"[ \t]*CC(?![A-Z])", re.IGNORECASE), _numbers_fit)
