# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of plain decimal numbers, read many at a time; exact, or left to a slower way.

Most measured files hold nothing but digits, signs and points between separators. Eight characters of such numbers
are one 64-bit word, whose digits three multiplications put together (Lemire, Number parsing at a gigabyte per
second, 2021). A whole number below 2^53 divided by a power of ten up to 10^22 is the nearest double to the
decimal, since both are exact and division rounds once (Clinger, How to read floating point numbers accurately,
1990); for up to 19 digits the exact remainder corrects it. A few unusual numbers are read one by one; a block of
rows with more of them, or anything else, is left to `numpy.loadtxt`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .fields import NUMBER

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Words = NDArray[np.uint64]

_BLOCK = 1 << 17
"""Characters of a block: its arrays stay within a processor's cache."""
_MARGIN = 32
"""Characters in front of the text that may be looked at, and mean nothing."""
_LONGEST = 19
"""Digits that a 64-bit word can add up."""
_EXACT = np.uint64(1 << 53)
_FEW = 0.1
"""Share of numbers in a block that may be unusual: longer, or with an exponent."""

_NEWLINE, _BLANK, _PLUS, _MINUS, _POINT = 10, 32, 43, 45, 46

_TENS = np.array([float(10**k) for k in range(_LONGEST + 1)])
_WHOLE_TENS = 10 ** np.arange(_LONGEST + 1, dtype=np.uint64)
_ZEROS = np.uint64(0x3030303030303030)
_ABOVE_NINE = np.uint64(0x7676767676767676)
_HIGH = np.uint64(0x8080808080808080)
_LAST = np.array([0] + [(1 << 64) - (1 << (64 - 8 * k)) for k in range(1, 9)], dtype=np.uint64)
"""Mask of the last k of a word's characters; the last one is the highest byte."""


def decimal_columns(
    text: str, separator: str | None, width: int, columns: Sequence[int], *, begin: int = 0, first: int = 1
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
    begin : int
        Where in the text the first row begins.
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
    most = text.count("\n", begin) + 1
    values, lines = np.empty((most, len(columns))), np.empty(most, dtype=np.int64)
    rows, passed = 0, 0
    while begin < len(text):
        end = text.rfind("\n", begin, begin + _BLOCK) + 1 or text.find("\n", begin) + 1 or len(text)
        # Block by block, so that no second copy of the text is ever held.
        data = b"\n" * _MARGIN + text[begin:end].encode("utf-8", "surrogatepass")
        if end == len(text) and not data.endswith(b"\n"):
            data += b"\n"
        block, numbers = _plain(data, separator, width, columns), None
        if block is None:
            found = _by_numpy(data[_MARGIN:], separator, width, columns)
            if found is None:
                return None
            block, numbers = found
        n = len(block)
        values[rows : rows + n] = block
        lines[rows : rows + n] = (np.arange(n) if numbers is None else numbers) + (first + passed)
        rows += n
        passed += n if numbers is None else data.count(b"\n", _MARGIN)
        begin = end
    return (values[:rows], lines[:rows]) if rows else None


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


def _plain(data: bytes, separator: str | None, width: int, columns: Sequence[int]) -> Floats | None:
    """Rows of a block without blank lines, the wanted fields being plain decimals; None where anything else is."""
    # One character before the block, for its first field to begin behind it.
    text = np.frombuffer(data, dtype=np.uint8, offset=_MARGIN - 1)
    fields = _alike(text, separator or " ", width, columns) or _fields(text, separator, width, columns)
    if fields is None:
        return None
    # Eight characters from every place on. Place k of `text` is the end of number k + _MARGIN - 1 - 8 of them.
    words = np.ndarray((len(data) - 7,), dtype="<u8", buffer=data, strides=(1,))
    values = _decimals(text, words, *fields)
    return None if values is None else values.reshape(-1, len(columns))


def _alike(text: NDArray[np.uint8], mark: str, width: int, columns: Sequence[int]) -> tuple[Ints, Ints, Ints] | None:
    """Starts, points and ends of fields that have one point each, and one mark between them; None where not so."""
    text = text[1:]
    marks = np.flatnonzero((text == ord(mark)) | (text == _NEWLINE) | (text == _POINT))
    if len(marks) % (2 * width):
        return None
    found = marks.reshape(-1, 2 * width)
    pattern = np.array([_POINT, ord(mark)] * (width - 1) + [_POINT, _NEWLINE], dtype=np.uint8)
    if (text[found] != pattern).any():
        return None
    found += 1
    starts = np.empty((len(found), width), dtype=np.int64)
    starts[:, 1:] = found[:, 1:-1:2]
    starts[0, 0] = 0
    starts[1:, 0] = found[:-1, -1]
    starts += 1
    points, ends = found[:, ::2], found[:, 1::2]
    if list(columns) != list(range(width)):
        starts, points, ends = (side[:, list(columns)] for side in (starts, points, ends))
    return starts.ravel(), points.ravel(), ends.ravel()


def _fields(
    text: NDArray[np.uint8], separator: str | None, width: int, columns: Sequence[int]
) -> tuple[Ints, Ints, Ints] | None:
    """Starts, points and ends of the fields; None where a row has another number of them."""
    bounds = _fields_by_blanks(text, width) if separator is None else _fields_by_mark(text, ord(separator), width)
    if bounds is None:
        return None
    starts, ends = (side.reshape(-1, width)[:, list(columns)].ravel() for side in bounds)
    # Place of the first point of each field, its end where there is none; other points are left out.
    points = np.flatnonzero(text == _POINT)
    place = np.searchsorted(points, starts)
    found = np.append(points, np.iinfo(np.int64).max)[place]
    return starts, np.where(found < ends, found, ends), ends


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


def _decimals(text: NDArray[np.uint8], words: Words, starts: Ints, points: Ints, ends: Ints) -> Floats | None:
    """Doubles nearest to the numbers that fill the fields; None where one is no number, or many are unusual."""
    head = text[starts]
    minus = head == _MINUS
    begins = starts + (minus | (head == _PLUS))
    whole = points - begins
    places = np.maximum(ends - points - 1, 0)
    odd = (whole < 0) | (whole > 8) | (places > _LONGEST) | (whole + places < 1)
    if odd.any():
        whole, places = np.where(odd, 0, whole), np.where(odd, 0, places)
    at = _MARGIN - 8 - 1
    parsed, wrong = _number(words[points + at], whole)
    odd |= (parsed != 0) & (whole + places > _LONGEST)
    # Decimal places, eight at a time from the left, the last ones being whole.
    for behind in range((int(places.max()) - 1) // 8 * 8, -1, -8):
        some = np.clip(places - behind, 0, 8)
        more, amiss = _number(words[ends + (at - behind)], some)
        wrong |= amiss
        # One power of ten for all is the common case, and faster.
        parsed = parsed * (_WHOLE_TENS[some[0]] if some.min() == some.max() else _WHOLE_TENS[some]) + more
    odd |= (wrong & _HIGH) != 0
    tens = _TENS[places[0]] if places.min() == places.max() else _TENS[places]
    values = parsed.astype(np.float64) / tens
    if parsed.max() >= _EXACT:
        values = _corrected(values, parsed, tens)
    values = np.where(minus, -values, values)
    few = np.flatnonzero(odd)
    return values if not len(few) or _one_by_one(values, few, text, starts, ends) else None


def _one_by_one(values: Floats, few: Ints, text: NDArray[np.uint8], starts: Ints, ends: Ints) -> bool:
    """Put unusual numbers in their places; False where one is no number, or there are too many of them."""
    if len(few) > _FEW * len(values) + 1:
        return False
    for k in few.tolist():
        field = text[starts[k] : ends[k]].tobytes().decode("ascii", "replace")
        if not NUMBER.fullmatch(field):
            return False
        values[k] = float(field)
    return bool(np.isfinite(values[few]).all())


def _corrected(quotients: Floats, wholes: Words, tens: Floats | np.float64) -> Floats:
    """The doubles nearest to wholes / tens, from quotients that miss them by at most an ulp or two.

    The remainder is exact (product in two parts after Dekker 1971), and what it is divided to is off by less than
    2^-102 of the value, while a decimal of 19 digits that is no tie is at least 2^-99 of it away from one.
    """
    rounded = wholes.astype(np.float64)
    rest = (wholes - rounded.astype(np.uint64)).view(np.int64).astype(np.float64)
    product = quotients * tens
    a, b = _halves(quotients)
    c, d = _halves(tens)
    beyond = ((a * c - product) + a * d + b * c) + b * d
    out: Floats = quotients + ((rounded - product) - beyond + rest) / tens
    return out


def _halves(values: Any) -> tuple[Any, Any]:
    """Doubles as sums of two with 26 bits each."""
    large = values * 134217729.0
    high = large - (large - values)
    return high, values - high


def _number(words: Words, digits: Ints) -> tuple[Words, Words]:
    """Whole numbers that the last `digits` (0 to 8) characters of words are; bits of `_HIGH` where one is no digit."""
    words = (words ^ _ZEROS) & _LAST[digits]
    wrong = (words + _ABOVE_NINE) | words
    words = words * np.uint64(2561) >> np.uint64(8)
    words = (words & np.uint64(0x00FF00FF00FF00FF)) * np.uint64(6553601) >> np.uint64(16)
    return (words & np.uint64(0x0000FFFF0000FFFF)) * np.uint64(42949672960001) >> np.uint64(32), wrong
