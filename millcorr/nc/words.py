# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of an NC program taken apart into words, without asking what they mean.

A *word* is a letter and a number. Whole programs are taken apart at once with numpy; only lines that hold
more than plain words (variables, expressions, keywords) are read one by one.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bytes, Floats, Ints
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import named_tool

from .statements import LARGEST, Statement, is_title, pole_of, take_line_apart

MOST_DECIMALS = 127
"""Digits behind a point are counted up to this: more than a double has."""

COMMENT = re.compile(rb"\([^()\r\n]*\)|;[^\r\n]*")
_TOOL = rb'(?<![A-Za-z_])[Tt](?:(?:\d*[ \t]*=)?[ \t]*"(?P<quoted>[^"\r\n]*)"|\d*[ \t]*=[ \t]*(?P<bare>[^\s"=(;]+))'
"""A tool by its name: T="ROUGH 8", T1="ROUGH 8" of the first spindle, T=ROUGH_8 (Siemens), T"ROUGH 8" (Heidenhain)."""
_COMMENT_OR_TEXT = re.compile(rb"\([^()\r\n]*\)|;[^\r\n]*|" + _TOOL + rb'|"[^"\r\n]*"')
_PERCENT = re.compile(rb"(?m)^[ \t]*(?:[nN][ \t]*\d+[ \t]*)?%[^\r\n]*|\A[ \t]*\$[^\r\n]*%[ \t]*(?=\r?\n)")
"""Marks of begin and end of a program; Okuma begins with the name of the file."""
HEAD = re.compile(rb"[ \t]*%_N_(\w+?)_(?:MPF|SPF)\b", re.IGNORECASE)
"""Head of one program among others in a file of Siemens."""
_COLON = re.compile(rb"(?m)^([ \t]*):(?=[ \t]*\d)")
"""Program number as the ISO code of older controls writes it."""
_BLOCK_DELETE = re.compile(rb"(?m)^([ \t]*(?:[nN][ \t]*\d+[ \t]*)?)/[1-9]?")
_BLOCK_END = re.compile(rb"(?m)\*[ \t]*(?=\r?$)")

_FIRST_CODE = re.compile(rb"(?im)^(?:[^(;\r\n]*[^(;\r\nA-Z_])?[GM][ \t]*\d")

_DIGIT, _POINT, _SIGN, _OTHER, _LETTER, _NEWLINE = range(6)
_CLASS = np.full(256, _OTHER, np.uint8)
_CLASS[48:58] = _DIGIT
_CLASS[ord(".")] = _POINT
_CLASS[[ord("+"), ord("-")]] = _SIGN
_CLASS[65:91] = _LETTER
_CLASS[97:123] = _LETTER
_CLASS[10] = _NEWLINE
_TO_BLANK = bytes(32 if c in (_LETTER, _NEWLINE) else i for i, c in enumerate(_CLASS))
_BLANKS = b" \t\r\x0b\x0c\x1a"
BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_NAMED_PLACE = re.compile(rb"(?i)(?<![A-Z_])(?:[AR]P|[XY])[ \t]*=")
_POLE = re.compile(rb"(?im)^[^(;\r\n]*?(?<![A-Z_])G11[012](?!\d)")


@dataclass(frozen=True, eq=False, slots=True)
class Words:
    """Words of a program in their order.

    Parameters
    ----------
    letter : (m,) uint8
        ASCII code of the letter, upper case.
    value : (m,) float64
        The number; NaN where the program computes it.
    line : (m,) int32, or int64 in texts of 2 GB and more
        Line of the word, from 0, not decreasing.
    decimals : (m,) int8
        Digits behind the decimal point; -1 for a number without one.
    """

    letter: Bytes
    value: Floats
    line: Ints
    decimals: NDArray[np.int8]

    def of(self, letter: str) -> Words:
        """Only the words with this letter."""
        return self.take(np.flatnonzero(self.letter == ord(letter)))

    def take(self, index: Ints) -> Words:
        """Words chosen by index."""
        return Words(self.letter[index], self.value[index], self.line[index], self.decimals[index])

    def numbers(self, line: int) -> dict[str, float]:
        """Numbers of one line by their letters."""
        here = slice(*np.searchsorted(self.line, [line, line + 1]).tolist())
        return dict(zip(map(chr, self.letter[here].tolist()), self.value[here].tolist(), strict=True))

    def and_also(self, more: Sequence[tuple[int, str, float]]) -> Words:
        """These and others, given by line, letter and number: behind those of their line, numbers without a point."""
        if not more:
            return self
        line = np.concatenate([self.line, np.array([m[0] for m in more], self.line.dtype)])
        order = np.argsort(line, kind="stable")
        return Words(
            np.concatenate([self.letter, np.array([ord(m[1]) for m in more], np.uint8)])[order],
            np.concatenate([self.value, np.array([m[2] for m in more], np.float64)])[order],
            line[order],
            np.concatenate([self.decimals, np.full(len(more), -1, np.int8)])[order],
        )


def line_starts(data: bytes) -> Ints:
    """Offset of the first byte of every line, and of the end of the text.

    Parameters
    ----------
    data : bytes
        The program. Lines end with LF or CR LF, or with CR where the text holds no LF at all.

    Returns
    -------
    (lines + 1,) int64
    """
    end = 10 if b"\n" in data or b"\r" not in data else 13
    ends = np.flatnonzero(np.frombuffer(data, np.uint8) == end) + 1
    last = [] if len(ends) and ends[-1] == len(data) else [len(data)]
    return np.concatenate([[0], ends, last]).astype(np.int64)


def take_apart(data: bytes, starts: Ints, name: str) -> tuple[Words, dict[int, Statement]]:
    """Words of a program.

    Parameters
    ----------
    data : bytes
        The program.
    starts : (lines + 1,) int64
        From `line_starts`.
    name : str
        Name of the program for messages.

    Returns
    -------
    Words
        All the words, those of odd lines included.
    dict of int to Statement
        Lines that hold more than plain words, by index.

    Raises
    ------
    FormatError
        If a word is malformed.
    """
    plain = _plain_text(data)
    buffer = np.frombuffer(plain, np.uint8)
    progress.step()
    marks, kinds, line, length = _marks(buffer)
    progress.step()
    odd = _odd_lines(buffer, marks, kinds, line, length)
    poles = _poles(data, starts)
    odd = np.union1d(odd, poles)
    found: dict[int, Statement] = {}
    if len(odd):
        blanked = buffer.copy()
        newlines = marks[kinds == _NEWLINE]
        code = _FIRST_CODE.search(data)
        first_code = np.searchsorted(starts, code.start(), side="right") - 1 if code else len(starts)
        for i in odd.tolist():
            blanked[(newlines[i - 1] + 1 if i else 0) : newlines[i]] = 32
            raw = data[starts[i] : starts[i + 1]].removeprefix(BYTE_ORDER_MARK)
            before = data[starts[i - 1] : starts[i]] if i else b""
            title = i < first_code and is_title(raw.decode("latin-1"), before.decode("latin-1"))
            found[i] = title or take_line_apart(raw.decode("latin-1"), name, i)
            if i in poles:
                found[i] = pole_of(found[i])
        keep = ~np.isin(line, odd) | (kinds == _NEWLINE)
        marks, kinds, line, length = marks[keep], kinds[keep], line[keep], length[keep]
        plain = blanked.tobytes()
    progress.step()
    word = np.flatnonzero(kinds == _LETTER)
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)
        try:
            value = np.fromstring(plain.translate(_TO_BLANK), sep=" ")
        except (DeprecationWarning, ValueError):
            value = np.empty(0)
    if len(value) != len(word):
        raise FormatError(phrase("the numbers of this program cannot be read; is it an NC program?"), name)
    progress.step()
    at, width = marks[word], length[word]
    points = np.append(np.flatnonzero(buffer == ord(".")), len(buffer)).astype(at.dtype)
    behind: Ints = at + width - points[np.searchsorted(points[:-1], at)]
    decimals = np.clip(behind, -1, MOST_DECIMALS).astype(np.int8)
    large = np.flatnonzero(~(abs(value) <= LARGEST))
    if len(large):
        raise FormatError(phrase("number too large: correct it"), name, int(line[word[large[0]]]) + 1)
    letter = np.bitwise_and(buffer[at], np.uint8(0xDF))
    words = Words(letter, value, line[word], decimals)
    return words.and_also([(i, piece.letter, piece.value) for i, s in found.items() for piece in s.pieces]), found


def _poles(data: bytes, starts: Ints) -> Ints:
    """Lines that state the pole of Siemens' polar positions; elsewhere G110 to G112 are other codes."""
    if b"=" not in data:
        return np.zeros(0, np.int64)
    places = [found.start() for found in _POLE.finditer(data)]
    if not places or not _NAMED_PLACE.search(COMMENT.sub(b"", data)):
        return np.zeros(0, np.int64)
    return np.unique(np.searchsorted(starts, np.array(places, np.int64), side="right") - 1)


def _plain_text(data: bytes) -> bytes:
    """Text without comments, blanks and marks that carry no word; the same number of newlines."""
    text = data.removeprefix(BYTE_ORDER_MARK)
    if b"\n" not in text:
        text = text.replace(b"\r", b"\n")
    if b'"' in text or b"=" in text:
        text = _COMMENT_OR_TEXT.sub(_tool_word, text)
    elif b"(" in text or b";" in text:
        text = COMMENT.sub(b"", text)
    if b"%" in text:
        percents = [found.start() for found in _PERCENT.finditer(text) if not HEAD.match(found.group())]
        if len(percents) > 1 and not text[: percents[0]].strip() and not text.lstrip().startswith(b"$"):
            # What stands behind the second mark is not part of the program.
            text = text[: percents[1]] + b"\n" * text.count(b"\n", percents[1])
        text = _PERCENT.sub(b"", text)
    if b":" in text:
        text = _COLON.sub(rb"\1O", text)
    if b"/" in text:
        text = _BLOCK_DELETE.sub(rb"\1", text)
    if b"*" in text:
        text = _BLOCK_END.sub(b"", text)
    text = text.translate(None, _BLANKS)
    return text if text.endswith(b"\n") else text + b"\n"


def _tool_name(found: re.Match[bytes]) -> bytes | None:
    """Name of the tool that a piece of text calls; None where it is a comment or a text."""
    quoted: bytes | None = found["quoted"]
    return found["bare"] if quoted is None else quoted


def _tool_word(found: re.Match[bytes]) -> bytes:
    """A tool's name as a plain word; of comments and texts nothing."""
    name = _tool_name(found)
    return b"T%d " % named_tool(name) if name else b""


def tool_names(data: bytes) -> dict[int, str]:
    """Names of the tools that a program calls by name, by the number that stands for each."""
    names = filter(None, map(_tool_name, _COMMENT_OR_TEXT.finditer(data)))
    return {named_tool(name): name.decode("utf-8", "replace") for name in names}


def _marks(buffer: Bytes) -> tuple[Ints, Bytes, Ints, Ints]:
    """Letters and newlines: offset, class, line, and number of bytes up to the next one."""
    # Half as wide where that is enough: these are the largest arrays of a program.
    size = "i4" if len(buffer) < 2**31 else "i8"
    kinds = _CLASS[buffer]
    marks: Ints = np.flatnonzero(kinds >= _LETTER).astype(size)
    kinds = kinds[marks]
    newline = kinds == _NEWLINE
    line: Ints = np.cumsum(newline, dtype=size)
    line -= newline
    length = np.empty_like(marks)
    length[:-1] = marks[1:] - marks[:-1] - 1
    length[-1:] = 0
    return marks, kinds, line, length


def _odd_lines(buffer: Bytes, marks: Ints, kinds: Bytes, line: Ints, length: Ints) -> Ints:
    """Indices of the lines that are not a plain row of letters with numbers."""
    bad = [line[(kinds == _LETTER) & (length == 0)], line[(kinds == _NEWLINE) & (length != 0)] + 1]
    if marks[0] != 0:
        bad.append(np.zeros(1, np.int64))
    classes = _CLASS[buffer]
    # A sign stands directly behind its letter; behind a sign or point alone there is no number.
    sign = np.flatnonzero(classes == _SIGN)
    stray = sign[classes[np.maximum(sign - 1, 0)] != _LETTER]
    other = np.flatnonzero(classes == _OTHER)
    point = np.flatnonzero(classes == _POINT)
    owner = np.searchsorted(marks, point.astype(marks.dtype))
    twice = point[1:][owner[1:] == owner[:-1]]
    bare = sign[classes[np.minimum(sign + 1, len(buffer) - 1)] >= _LETTER]
    lone = point[(classes[point - 1] != _DIGIT) & (classes[np.minimum(point + 1, len(buffer) - 1)] != _DIGIT)]
    for places in (stray, other, twice, bare, lone):
        if len(places):
            bad.append(line[np.searchsorted(marks, places.astype(marks.dtype))])
    return np.unique(np.concatenate(bad))


def comments(data: bytes, starts: Ints) -> list[tuple[int, bytes]]:
    """Line index and text, without its marks, of every comment."""
    if b"(" not in data and b";" not in data:
        return []
    found = [(mark.start(), mark.group()) for mark in COMMENT.finditer(data)]
    line = np.searchsorted(starts, np.array([place for place, _ in found], dtype=np.int64), side="right") - 1
    texts = (text[1:-1] if text.startswith(b"(") else text[1:] for _, text in found)
    return list(zip(line.tolist(), texts, strict=True))
