# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of an NC program taken apart into words, without asking what they mean.

A *word* is a letter and a number. Whole programs are taken apart at once with numpy; only lines that hold
more than plain words (variables, expressions, keywords) are read one by one.
"""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.errors import FormatError
from millcorr.toolpath import Floats, Ints, named_tool

Bytes = NDArray[np.uint8]

LARGEST = 1e9
"""Numbers beyond this are no coordinates, codes or line numbers."""

MOST_DECIMALS = 127
"""Digits behind a point are counted up to this: more than a double has."""

COMMENT = re.compile(rb"\([^()\r\n]*\)|;[^\r\n]*")
_TOOL = rb'(?<![A-Za-z_])[Tt](?:(?:\d*[ \t]*=)?[ \t]*"(?P<quoted>[^"\r\n]*)"|\d*[ \t]*=[ \t]*(?P<bare>[^\s"=(;]+))'
"""A tool by its name: T="ROUGH 8", T1="ROUGH 8" of the first spindle, T=ROUGH_8 (Siemens), T"ROUGH 8" (Heidenhain)."""
_COMMENT_OR_TEXT = re.compile(rb"\([^()\r\n]*\)|;[^\r\n]*|" + _TOOL + rb'|"[^"\r\n]*"')
_PERCENT = re.compile(rb"(?m)^[ \t]*(?:[nN][ \t]*\d+[ \t]*)?%[^\r\n]*")
_COLON = re.compile(rb"(?m)^([ \t]*):(?=[ \t]*\d)")
"""Program number as the ISO code of older controls writes it."""
_BLOCK_DELETE = re.compile(rb"(?m)^([ \t]*(?:[nN][ \t]*\d+[ \t]*)?)/[1-9]?")
_BLOCK_END = re.compile(rb"(?m)\*[ \t]*(?=\r?$)")

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


@dataclass(frozen=True, slots=True)
class OddLine:
    """A line that holds more than plain words.

    Parameters
    ----------
    line : int
        Its index, from 0.
    reason : str
        Why it cannot be followed.
    effect : str
        "" nothing but its own words, "frame" the coordinate frame may change, "call" a subprogram moves the
        machine, "flow" the order of the lines is not that of the text from here on.
    words : tuple of (str, float)
        Its words; NaN where the number is computed.
    """

    line: int
    reason: str
    effect: str
    words: tuple[tuple[str, float], ...]


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


def take_apart(data: bytes, starts: Ints, name: str) -> tuple[Words, tuple[OddLine, ...]]:
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
    tuple of OddLine

    Raises
    ------
    FormatError
        If a word is malformed.
    """
    plain = _plain_text(data)
    buffer = np.frombuffer(plain, np.uint8)
    marks, kinds, line, length = _marks(buffer)
    odd = _odd_lines(buffer, marks, kinds, line, length)
    found: list[OddLine] = []
    if len(odd):
        blanked = buffer.copy()
        newlines = marks[kinds == _NEWLINE]
        for i in odd.tolist():
            blanked[(newlines[i - 1] + 1 if i else 0) : newlines[i]] = 32
            found.append(_read_odd_line(data[starts[i] : starts[i + 1]], i, name))
        keep = ~np.isin(line, odd) | (kinds == _NEWLINE)
        marks, kinds, line, length = marks[keep], kinds[keep], line[keep], length[keep]
        plain = blanked.tobytes()
    word = np.flatnonzero(kinds == _LETTER)
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)
        try:
            value = np.fromstring(plain.translate(_TO_BLANK), sep=" ")
        except (DeprecationWarning, ValueError):
            value = np.empty(0)
    if len(value) != len(word):
        raise FormatError("the numbers of this program cannot be read; is it an NC program?", name)
    at, width = marks[word], length[word]
    points = np.append(np.flatnonzero(buffer == ord(".")), len(buffer)).astype(at.dtype)
    behind: Ints = at + width - points[np.searchsorted(points[:-1], at)]
    decimals = np.clip(behind, -1, MOST_DECIMALS).astype(np.int8)
    large = np.flatnonzero(~(abs(value) <= LARGEST))
    if len(large):
        raise FormatError("number too large: correct it", name, int(line[word[large[0]]]) + 1)
    letter = np.bitwise_and(buffer[at], np.uint8(0xDF))
    words = Words(letter, value, line[word], decimals)
    return (_merge(words, found) if found else words), tuple(found)


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
        percents = [found.start() for found in _PERCENT.finditer(text)]
        if len(percents) > 1 and not text[: percents[0]].strip():
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


def _merge(words: Words, odd: list[OddLine]) -> Words:
    extra = [(ord(letter), value, o.line) for o in odd for letter, value in o.words]
    if not extra:
        return words
    letters, values, lines = (np.array(column) for column in zip(*extra, strict=True))
    line = np.concatenate([words.line, lines.astype(words.line.dtype)])
    order = np.argsort(line, kind="stable")
    return Words(
        np.concatenate([words.letter, letters.astype(np.uint8)])[order],
        np.concatenate([words.value, values.astype(np.float64)])[order],
        line[order],
        np.concatenate([words.decimals, np.full(len(lines), -1, np.int8)])[order],
    )


_TOKEN = re.compile(
    r"""(?P<number>[A-Z][ ]*[+-]?[ ]*(?:[0-9][0-9 ]*(?:\.[0-9 ]*)?|\.[ ]*[0-9][0-9 ]*)
            (?![0-9.=\[\#]|,\s*[0-9]))
      | (?P<assign>(?:\#\d+|\#<[^>]*>|\#\[[^=]*\]|R\d+|Q\d+)\s*=.*)
      | (?P<variable>[A-Z]\s*[+-]?\s*(?:\#+\s*(?:\d+|<[^>]*>|\[[^;]*\])|Q[LRS]?\d+))
      | (?P<expression>[A-Z]\s*[+-]?\s*(?:\[|<))
      | (?P<equals>[A-Z]+\d*\s*=\s*)
      | (?P<corner>,\s*[A-Z])
      | (?P<keyword>[A-Z_]{2,}[A-Z_0-9]*:?)
    """,
    re.VERBOSE,
)
_CALLS = ("CALL", "CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE")
_QUIET = frozenset(
    "MSG SETAL STOPRE WORKPIECE FFWON FFWOF SOFT BRISK DRIVE DIAMOF CUT2D CFC CFTCP CFIN COMPOF COMPON COMPCAD "
    "COMPCURV CYCLE832 TRAFOOF UPATH SPATH".split()
)
_SHORT_KEYWORDS = ("IF", "DO", "OR", "AC", "IC", "DC", "GE", "GT", "LE", "LT", "EQ", "NE")


def _read_odd_line(raw: bytes, line: int, name: str) -> OddLine:
    """Take one line apart that holds more than plain words."""
    bare = _COMMENT_OR_TEXT.sub(_tool_word, raw.removeprefix(BYTE_ORDER_MARK))
    text = _BLOCK_DELETE.sub(rb"\1", bare).upper().decode("latin-1").rstrip("* \t\r\n\x0b\x0c\x1a")
    words: list[tuple[str, float]] = []
    reasons: list[str] = []
    effect = ""
    place = 0
    while place < len(text):
        if text[place] in " \t\r\x0b\x0c":
            place += 1
            continue
        found = _TOKEN.match(text, place)
        if found is None:
            raise FormatError(_malformed(text[place:]), name, line + 1)
        kind, token = str(found.lastgroup), found.group()
        place = found.end()
        if kind == "number":
            number = float(re.sub(r"\s", "", token[1:]))
            if abs(number) > LARGEST:
                raise FormatError("number too large: correct it", name, line + 1)
            words.append((token[0], number))
            if token[0] == "O":
                reasons.append("an O word steers the program")
                effect = "flow"
        elif kind == "assign":
            reasons.append(f"macro variable set: {token.strip()}")
            system = re.match(r"#(\d+)", token)
            if system and int(system.group(1)[:9]) >= 5000:
                effect = effect or "frame"
        elif kind in ("variable", "expression"):
            reasons.append(f"{token[0]} is computed by a macro expression")
            words.append((token[0], float("nan")))
            if token[0] in "OG":
                effect = "flow"
            if kind == "expression":
                place = _behind_bracket(text, place - 1)
        elif kind == "equals":
            letter = token.rstrip("= \t")
            reasons.append(f"{letter} is assigned with '='")
            if len(letter) == 1 and letter.isalpha() and letter not in "TSFMHD":
                words.append((letter, float("nan")))
            elif letter in ("CR", "AR", "TURN", "I1", "J1", "K1"):
                words.append(("R", float("nan")))
            place = _behind_value(text, place)
        elif kind == "corner":
            reasons.append("a corner rounding or chamfer changes the end of this move")
            words = [w for w in words if w[0] not in "XYZ"] + [(axis, float("nan")) for axis in "XYZ"]
            place = _behind_value(text, place)
        else:
            if len(token.rstrip(":0123456789")) < 3 and token not in _SHORT_KEYWORDS:
                raise FormatError(_malformed(text[found.start() :]), name, line + 1)
            if token in ("BEGIN", "TOOL", "BLK"):
                remedy = "write the program as ISO code (DIN 66025)"
                raise FormatError(f"plain-language programs are not read; {remedy}", name, line + 1)
            if token in _QUIET:
                continue
            if token == "SUPA":
                # Siemens' way to say G53.
                words.append(("G", 53.0))
                continue
            effect = "call" if token.startswith(_CALLS) and effect != "flow" else "flow"
            reasons.append(f"{token} is not plain ISO code")
            break
    return OddLine(line, "; ".join(dict.fromkeys(reasons)), effect, tuple(words))


def _malformed(rest: str) -> str:
    shown = rest[:20].encode("ascii", "replace").decode()
    if re.match(r"[A-Z]\s*[+-]?\s*\d+,\d", rest):
        return f"decimal comma in '{shown}': write numbers with a decimal point"
    if rest.startswith("("):
        return "comment without ')': close it on the same line"
    if rest[0].isascii() and rest[0].isalpha():
        return f"'{shown}' is not a word: a letter needs one number behind it"
    return f"cannot read '{shown}': is this an NC program?"


def _behind_bracket(text: str, place: int) -> int:
    """Place behind the bracket that opens at `place`."""
    opening = text[place]
    closing = "]" if opening == "[" else ">"
    depth = 0
    for i in range(place, len(text)):
        depth += (text[i] == opening) - (text[i] == closing)
        if depth == 0:
            return i + 1
    return len(text)


def _behind_value(text: str, place: int) -> int:
    """Place behind an assigned value: up to the next blank outside brackets."""
    while place < len(text) and text[place] in " \t":
        place += 1
    while place < len(text) and text[place] not in " \t":
        place += 1
    return place


def comments(data: bytes, starts: Ints) -> list[tuple[int, bytes]]:
    """Line index and text, without its marks, of every comment."""
    if b"(" not in data and b";" not in data:
        return []
    found = [(mark.start(), mark.group()) for mark in COMMENT.finditer(data)]
    line = np.searchsorted(starts, np.array([place for place, _ in found], dtype=np.int64), side="right") - 1
    texts = (text[1:-1] if text.startswith(b"(") else text[1:] for _, text in found)
    return list(zip(line.tolist(), texts, strict=True))
