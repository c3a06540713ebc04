# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of plain decimal numbers, read many at a time; exact, or left to a slower way.

Most measured files hold nothing but digits, signs and points between separators. Eight characters of such numbers
are one 64-bit word, whose digits three multiplications put together (Lemire, Number parsing at a gigabyte per
second, 2021). A whole number below 2^53 divided by a power of ten up to 10^22 is the nearest double to the
decimal, since both are exact and division rounds once (Clinger, How to read floating point numbers accurately,
1990). Whatever does not fit that, a block of rows at a time, is left to `numpy.loadtxt`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Words = NDArray[np.uint64]

_BLOCK = 1 << 17
"""Characters of a block: its arrays stay within a processor's cache."""
_MARGIN = 16
"""Characters in front of the text that may be looked at, and mean nothing."""
_LONGEST = 18
"""More digits than a 64-bit word can add up."""
_EXACT = np.uint64(1 << 53)

_NEWLINE, _BLANK, _PLUS, _MINUS, _POINT = 10, 32, 43, 45, 46

_TENS = 10.0 ** np.arange(_LONGEST + 1)
_WHOLE_TENS = 10 ** np.arange(_LONGEST + 1, dtype=np.uint64)
_ZEROS = np.uint64(0x3030303030303030)
_ABOVE_NINE = np.uint64(0x7676767676767676)
_HIGH = np.uint64(0x8080808080808080)
_BITS = np.arange(64, -8, -8).astype(np.uint64)
"""By how much a word is shifted so that its last k characters remain."""


def decimal_columns(
    text: str, separator: str | None, width: int, columns: Sequence[int], first: int = 1
) -> tuple[Floats, Ints] | None:
    r"""Some columns of a table of numbers.

    Parameters
    ----------
    text : str
        Rows, each ending in ``\n`` (the last one may lack it). Rows of nothing but blanks do not count.
    separator : str or None
        One ASCII character between the fields; None for runs of blanks.
    width : int
        Fields in every row.
    columns : sequence of int
        Fields wanted, counted from 0. Only these need to be numbers, in plain rows.
    first : int
        Line number of the first row.

    Returns
    -------
    values : (n, len(columns)) float64
        The double nearest to each decimal.
    lines : (n,) int64
        Line number of each row.

    None where there are no rows, or any is not as it should be: the caller has to look at it line by line.
    """
    if separator is None and not text.isascii():
        # Blanks of other alphabets separate too.
        return None
    data = b"\n" * _MARGIN + text.encode("utf-8", "surrogatepass")
    if not data.endswith(b"\n"):
        data += b"\n"
    rows, lines, position = [], [], _MARGIN
    while position < len(data):
        end = data.rfind(b"\n", position, position + _BLOCK) + 1 or data.index(b"\n", position) + 1
        block = _plain(data, position, end, separator, width, columns)
        if block is None:
            found = _by_numpy(data[position:end], separator, width, columns)
            if found is None:
                return None
            block, numbers = found
            passed = data.count(b"\n", position, end)
        else:
            passed = len(block)
            numbers = np.arange(passed)
        rows.append(block)
        lines.append(numbers + first)
        first += passed
        position = end
    if not sum(map(len, rows)):
        return None
    return np.concatenate(rows), np.concatenate(lines).astype(np.int64, copy=False)


def _by_numpy(data: bytes, separator: str | None, width: int, columns: Sequence[int]) -> tuple[Floats, Ints] | None:
    """Rows of a block and their lines from 0, all fields being numbers that numpy takes; None where one is not."""
    lines = data.decode("utf-8", "surrogatepass").split("\n")[:-1]
    numbers = np.flatnonzero([bool(line.strip()) for line in lines])
    if not len(numbers):
        return np.zeros((0, len(columns))), numbers
    if len(lines) > len(numbers):
        lines = [lines[k] for k in numbers]
    try:
        values = np.loadtxt(lines, delimiter=separator, comments=None, ndmin=2)
    except (ValueError, OverflowError):
        return None
    if values.shape != (len(numbers), width) or not np.isfinite(values).all():
        return None
    return values[:, list(columns)], numbers


def _plain(
    data: bytes, begin: int, end: int, separator: str | None, width: int, columns: Sequence[int]
) -> Floats | None:
    """Rows of a block without blank lines, the wanted fields being plain decimals; None where anything else is."""
    size = end - begin
    # One character before the block, for its first field to begin somewhere.
    text = np.frombuffer(data, dtype=np.uint8, count=size + 1, offset=begin - 1)
    bounds = _fields_by_blanks(text, width) if separator is None else _fields_by_mark(text, ord(separator), width)
    if bounds is None:
        return None
    starts, ends = (side.reshape(-1, width)[:, list(columns)].ravel() for side in bounds)
    points = np.flatnonzero(text == _POINT)
    if len(points) != len(starts) or not ((starts <= points) & (points < ends)).all():
        points = _points_within(points, starts, ends)
    # Words of eight characters at every place; index k of the block is index k + _MARGIN - 8 - 1 of these.
    words = np.ndarray((size + _MARGIN - 7,), dtype="<u8", buffer=data, offset=begin - _MARGIN, strides=(1,))
    values = _decimals(text, words, starts, points, ends)
    return None if values is None else values.reshape(-1, len(columns))


def _fields_by_mark(text: NDArray[np.uint8], mark: int, width: int) -> tuple[Ints, Ints] | None:
    """First and past-last places of the fields of whole rows, blanks around them left out."""
    ends = np.flatnonzero((text == mark) | (text == _NEWLINE))
    if ends[0]:
        # The place before the block is the end of a line, or the margin.
        ends = np.concatenate([[0], ends])
    starts, ends = ends[:-1] + 1, ends[1:]
    if len(ends) % width:
        return None
    newlines = np.flatnonzero(text[1:] == _NEWLINE) + 1
    if not np.array_equal(newlines, ends[width - 1 :: width]):
        return None
    if (text == _BLANK).any():
        starts, ends = _without_blanks(text, starts, ends)
    return starts, ends


def _without_blanks(text: NDArray[np.uint8], starts: Ints, ends: Ints) -> tuple[Ints, Ints]:
    """Fields without the blanks around them, except where there are very many."""
    for _ in range(_LONGEST):
        before, behind = text[starts] == _BLANK, text[ends - 1] == _BLANK
        if not (before.any() or behind.any()):
            break
        starts, ends = starts + before, ends - behind
    return starts, ends


def _fields_by_blanks(text: NDArray[np.uint8], width: int) -> tuple[Ints, Ints] | None:
    """The same, for runs of blanks between the fields."""
    blank = text <= _BLANK
    change = np.flatnonzero(blank[1:] != blank[:-1]) + 1
    starts, ends = change[::2], change[1::2]
    if len(starts) != len(ends) or not len(ends) or len(ends) % width:
        return None
    newlines = np.flatnonzero(text[1:] == _NEWLINE) + 1
    if len(newlines) * width != len(ends):
        return None
    # Every row ends between its last field and the first field of the next.
    after = np.append(starts[width::width], newlines[-1] + 1)
    if not ((ends[width - 1 :: width] <= newlines) & (newlines < after)).all():
        return None
    return starts, ends


def _points_within(points: Ints, starts: Ints, ends: Ints) -> Ints:
    """Place of the first point of each field, its end where there is none; other points are left out."""
    place = np.searchsorted(points, starts)
    found = np.append(points, np.iinfo(np.int64).max)[place]
    return np.where(found < ends, found, ends)


def _decimals(text: NDArray[np.uint8], words: Words, starts: Ints, points: Ints, ends: Ints) -> Floats | None:
    """Doubles nearest to the decimals that fill the fields; None where one is no plain decimal or too long."""
    head = text[starts]
    minus = head == _MINUS
    starts = starts + (minus | (head == _PLUS))
    whole = points - starts
    places = np.maximum(ends - points - 1, 0)
    digits = whole + places
    if not (whole.min() >= 0 and whole.max() <= 8 and digits.min() >= 1 and digits.max() <= _LONGEST):
        return None
    at = _MARGIN - 8 - 1
    parsed = _number(words[points + at], whole)
    if parsed is None:
        return None
    # The last eight decimal places, and what stands before them.
    few = np.minimum(places, 8)
    last = _number(words[ends + at], few)
    if last is None:
        return None
    if places.max() > 8:
        middle = _number(words[ends + (at - 8)], np.maximum(places - 8, 0))
        if middle is None:
            return None
        parsed = parsed * _WHOLE_TENS[places - few] + middle
    # One power of ten for all is the common case, and faster.
    ten = _WHOLE_TENS[few[0]] if few.min() == few.max() else _WHOLE_TENS[few]
    parsed = parsed * ten + last
    if parsed.max() >= _EXACT:
        return None
    values = parsed.astype(np.float64) / (_TENS[places[0]] if places.min() == places.max() else _TENS[places])
    out: Floats = np.where(minus, -values, values)
    return out


def _number(words: Words, digits: Ints) -> Words | None:
    """Whole numbers that the last `digits` (0 to 8) characters of each word are; None where one is no digit."""
    words = (words ^ _ZEROS) << _BITS[digits]
    if np.bitwise_or.reduce((words + _ABOVE_NINE) | words) & _HIGH:
        return None
    words = words * np.uint64(2561) >> np.uint64(8)
    words = (words & np.uint64(0x00FF00FF00FF00FF)) * np.uint64(6553601) >> np.uint64(16)
    out: Words = (words & np.uint64(0x0000FFFF0000FFFF)) * np.uint64(42949672960001) >> np.uint64(32)
    return out
