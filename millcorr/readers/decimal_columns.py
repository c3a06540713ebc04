# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain decimal numbers in columns or behind letters, read many at a time; exact, or left to a slower way.

Most measured files hold nothing but digits, signs and points between separators. Eight characters of such numbers
are one 64-bit word, whose digits three multiplications put together (Lemire, Number parsing at a gigabyte per
second, 2021). A whole number below 2^53 divided by a power of ten up to 10^22 is the nearest double to the
decimal, since both are exact and division rounds once (Clinger, How to read floating point numbers accurately,
1990); for up to 19 digits the exact remainder corrects it. A few unusual numbers are read one by one; a block of
rows with more of them, or anything else, is left to `numpy.loadtxt`.

The bytes of a file are read where they are, a block at a time: neither a text nor a second copy of it is made.

No library takes its place: of 300,000 rows of three numbers `numpy.loadtxt` takes 1.8 times as long from the bytes
and 2.2 times from lines, `numpy.array` of the words and `float` 3.4 times; a pattern for letters and numbers takes 3.5
times as long as `decimal_words`. `loadtxt` also passes over empty lines without telling which, and the line of every
point is kept; and it knows no decimal comma. `benchmarks/reading.py` compares whole files.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Bools, Bytes, Floats, Ints

from .fields import NUMBER

Words = NDArray[np.uint64]

_BLOCK = 1 << 18
"""Characters of a block: many, for what a call of numpy costs; not more, for its arrays to stay in the cache."""
_MARGIN = 32
"""Characters in front of the text that may be looked at, and mean nothing."""
_LONGEST = 19
"""Digits that a 64-bit word can add up."""
_LARGEST_SIGNED = (1 << 63) - 1
"""Signed numbers are made doubles faster."""
_EXACT = np.uint64(1 << 53)
_FEW = 0.1
"""Share of numbers in a block that may be unusual: longer, or with an exponent."""

_TAB, _NEWLINE, _BLANK, _PLUS, _MINUS, _POINT, _ZERO, _A = 9, 10, 32, 43, 45, 46, 48, 65

_TENS = np.array([float(10**k) for k in range(_LONGEST + 2)])
_WHOLE_TENS = 10 ** np.arange(_LONGEST + 1, dtype=np.uint64)
_ZEROS = np.uint64(0x3030303030303030)
_ABOVE_NINE = np.uint64(0x7676767676767676)
_HIGH = np.uint64(0x8080808080808080)
_NIBBLES = np.uint64(0x0F0F0F0F0F0F0F0F)
_LAST = np.array([0] + [(1 << 64) - (1 << (64 - 8 * k)) for k in range(1, 9)], dtype=np.uint64)
"""Mask of the last k of a word's characters; the last one is the highest byte."""
_DIGITS = _LAST & _NIBBLES
_FOREIGN = re.compile(rb'[\x00-\x08\x0e-\x1b\x7f"#]|//')
"""What needs a look at the text before it is a table: control characters, quotation marks, comments."""


@dataclass(frozen=True, slots=True)
class _Fields:
    """Places of the fields of a block's rows, one after the other."""

    begins: Ints
    """Where the number begins, behind its sign."""
    points: Ints
    """The end where there is none."""
    ends: Ints
    signed: Bools
    minus: Bools
    digits: bool
    """Whether there are nothing but digits before and behind the point."""

    @classmethod
    def of(cls, text: Bytes, starts: Ints, points: Ints, ends: Ints, *, digits: bool) -> _Fields:
        """Fields that begin at `starts`, which become the places behind their signs."""
        head = text[starts]
        minus = head == _MINUS
        signed = minus | (head == _PLUS)
        starts += signed
        return cls(starts, points, ends, signed, minus, digits)


def decimal_columns(
    text: str | bytes, separator: str | None, width: int, columns: Sequence[int], *, begin: int = 0, first: int = 1
) -> tuple[Floats, Ints] | None:
    r"""Some columns of a table of numbers.

    Parameters
    ----------
    text : str or bytes
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
    found = decimal_tables(text, separator, width, [columns], begin=begin, first=first)
    return None if found is None else (found[0][0], found[1])


def decimal_tables(
    text: str | bytes,
    separator: str | None,
    width: int,
    tables: Sequence[Sequence[int | None]],
    *,
    begin: int = 0,
    end: int | None = None,
    first: int = 1,
    mark: str = ".",
) -> tuple[list[Floats], Ints] | None:
    r"""Several groups of columns of a table of numbers, as `decimal_columns` reads them, each an array of its own.

    Parameters
    ----------
    text : str or bytes
        Lines of bytes may end in ``\r\n`` too; bytes that are not ASCII, and control characters, make it no table.
    separator, width, begin, first
        As in `decimal_columns`.
    tables : sequence of sequences of int or None
        Fields wanted for each array; None for a column of zeros.
    end : int, optional
        Where in the text the last row ends, behind its line end; by default at the text's end.
    mark : {".", ","}
        Decimal mark of all numbers.

    Returns
    -------
    tables : list of (n, m) float64
    lines : (n,) int64

    None as in `decimal_columns`.
    """
    if separator is None and isinstance(text, str) and not text.isascii():
        # Blanks of other alphabets separate too.
        return None
    columns = [c for table in tables for c in table if c is not None]
    end = len(text) if end is None else end
    most = newlines(text, begin, end) + 1
    out = [np.empty((most, len(table))) for table in tables]
    lines = np.empty(most, dtype=np.int64)
    rows = passed = 0
    while begin < end:
        data, begin = _block(text, begin, end, mark)
        found = None if data is None else _rows(data, separator, width, columns, isinstance(text, str))
        if found is None:
            return None
        block, numbers, count = found
        here, column = slice(rows, rows + len(block)), 0
        for table, array in zip(tables, out, strict=True):
            for place, wanted in enumerate(table):
                array[here, place] = 0.0 if wanted is None else block[:, column]
                column += wanted is not None
        lines[here] = numbers
        lines[here] += first + passed
        rows, passed = here.stop, passed + count
    return ([array[:rows] for array in out], lines[:rows]) if rows else None


@dataclass(frozen=True, slots=True)
class Lettered:
    """Words of some lines, each a letter and a number.

    Parameters
    ----------
    letters : (n,) uint8
    values : (n,) float64
    digits : (n,) int64
        Characters of each number, without its sign.
    first : (m + 1,) int64
        Place of the first word of each line among all.
    """

    letters: Bytes
    values: Floats
    digits: Ints
    first: Ints


def decimal_words(lines: str) -> Lettered | None:
    r"""Words of lines that hold nothing else, as ``G801 N1 X12.5Y-3``; blanks between them do not count.

    Parameters
    ----------
    lines : str
        In capitals, each line ending in ``\n``.

    Returns
    -------
    Lettered
        None where anything is no word, or has an exponent: the caller has to look at it line by line.
    """
    if not lines.isascii() or not lines:
        return None
    data = b"".join((b"\n" * _MARGIN, lines.encode("ascii"), b"" if lines.endswith("\n") else b"\n"))
    text = np.frombuffer(data, dtype=np.uint8, offset=_MARGIN - 1)
    words = np.ndarray((len(data) - 7,), dtype="<u8", buffer=data, strides=(1,))
    # Control characters, and an E: it may be an exponent.
    if ((text < _BLANK) & (text != _TAB) & (text != _NEWLINE)).any() or "E" in lines:
        return None
    letter = text - np.uint8(_A) < 26
    solid = (text > _BLANK) & ~letter
    change = np.flatnonzero(solid[1:] != solid[:-1]) + 1
    starts, ends = change[::2], change[1::2]
    places = np.flatnonzero(letter)
    if len(places) != len(starts) or not len(places) or (places > starts).any() or (ends[:-1] > places[1:]).any():
        return None
    newlines = np.flatnonzero(text == _NEWLINE)
    first = np.searchsorted(places, newlines)
    if not np.array_equal(first, np.searchsorted(starts, newlines)):
        return None
    fields = _pointed(text, starts, ends)
    values = _decimals(text, words, fields)
    return None if values is None else Lettered(text[places], values, fields.ends - fields.begins, first)


def newlines(text: str | bytes, begin: int, end: int) -> int:
    """Number of line ends; those of bytes by numpy, since counting many by hand takes a tenth of all the time."""
    if isinstance(text, str):
        return text.count("\n", begin, end)
    codes = np.frombuffer(text, dtype=np.uint8)[begin:end]
    return sum(int(np.count_nonzero(codes[k : k + _BLOCK] == _NEWLINE)) for k in range(0, len(codes), _BLOCK))


def _block(text: str | bytes, begin: int, stop: int, mark: str) -> tuple[bytes | None, int]:
    """The next lines behind the margin, ending in newlines and with decimal points, and where those after them begin.

    None instead of lines with a carriage return elsewhere than at a line's end, or with both decimal marks.
    """
    reach = min(begin + _BLOCK, stop)
    if isinstance(text, str):
        end = text.rfind("\n", begin, reach) + 1 or text.find("\n", begin, stop) + 1 or stop
        piece = text[begin:end].encode("utf-8", "surrogatepass")
    else:
        end = text.rfind(b"\n", begin, reach) + 1 or text.find(b"\n", begin, stop) + 1 or stop
        piece = text[begin:end]
    if b"\r" in piece:
        piece = piece.replace(b"\r\n", b"\n")
    if b"\r" in piece or (mark != "." and b"." in piece):
        return None, end
    if mark != ".":
        piece = piece.replace(mark.encode(), b".")
    return b"".join((b"\n" * _MARGIN, piece, b"" if piece.endswith(b"\n") else b"\n")), end


def _rows(
    data: bytes, separator: str | None, width: int, columns: Sequence[int], safe: bool
) -> tuple[Floats, Ints, int] | None:
    """Wanted numbers of a block's rows, their lines from 0, and how many lines there are; None where it is no table.

    What is not `safe` may hold anything, also what is no text or no row.
    """
    # One character before the block, for its first field to begin behind it.
    text = np.frombuffer(data, dtype=np.uint8, offset=_MARGIN - 1)
    # Eight characters from every place on.
    words = np.ndarray((len(data) - 7,), dtype="<u8", buffer=data, strides=(1,))
    fields = _alike(text, separator or " ", width, columns)
    if fields is None:
        if not safe and (not data.isascii() or _FOREIGN.search(data)):
            return None
        fields = _fields(text, separator, width, columns)
    values = None if fields is None else _decimals(text, words, fields)
    if values is not None:
        block = values.reshape(-1, len(columns))
        return block, np.arange(len(block)), len(block)
    return _by_numpy(data[_MARGIN:], separator, width, columns)


def _by_numpy(
    data: bytes, separator: str | None, width: int, columns: Sequence[int]
) -> tuple[Floats, Ints, int] | None:
    """As `_rows`, all fields being numbers that numpy takes; None where one is not."""
    lines = data.decode("utf-8", "surrogatepass").split("\n")[:-1]
    count = len(lines)
    numbers = np.flatnonzero([bool(line.strip()) for line in lines])
    if not len(numbers):
        return np.zeros((0, len(columns))), numbers, count
    if count > len(numbers):
        lines = [lines[k] for k in numbers]
    try:
        values = np.loadtxt(lines, delimiter=separator, comments=None, ndmin=2)
    except (ValueError, OverflowError):
        return None
    if values.shape != (len(numbers), width) or not np.isfinite(values).all():
        return None
    return values[:, list(columns)], numbers, count


def _alike(text: Bytes, mark: str, width: int, columns: Sequence[int]) -> _Fields | None:
    """Fields that have one point each and are digits else, with one mark between them; None where not so."""
    is_point, is_newline = text == _POINT, text == _NEWLINE
    found = np.flatnonzero(is_point | is_newline | (text == ord(mark)))
    # The place before the block is the end of a line.
    points, ends = found[1::2], found[2::2]
    if len(found) % (2 * width) != 1 or not len(ends):
        return None
    newlines = ends[width - 1 :: width]
    if not is_point[points].all() or np.count_nonzero(is_point) != len(points):
        return None
    if not is_newline[newlines].all() or np.count_nonzero(is_newline) != len(newlines) + 1:
        return None
    fields = _Fields.of(text, found[:-1:2] + 1, points, ends, digits=True)
    # Whatever is neither a digit nor a mark nor the sign in front of a number is one too many.
    if np.count_nonzero(text - np.uint8(_ZERO) > 9) != len(found) + np.count_nonzero(fields.signed):
        return None
    if list(columns) == list(range(width)):
        return fields
    wanted = list(columns)
    starts = (fields.begins - fields.signed).reshape(-1, width)[:, wanted].ravel()
    points, ends = (side.reshape(-1, width)[:, wanted].ravel() for side in (points, ends))
    return _Fields.of(text, starts, points, ends, digits=True)


def _fields(text: Bytes, separator: str | None, width: int, columns: Sequence[int]) -> _Fields | None:
    """Fields of any content; None where a row has another number of them."""
    bounds = _fields_by_blanks(text, width) if separator is None else _fields_by_mark(text, ord(separator), width)
    if bounds is None:
        return None
    starts, ends = (side.reshape(-1, width)[:, list(columns)].ravel() for side in bounds)
    return _pointed(text, starts, ends)


def _pointed(text: Bytes, starts: Ints, ends: Ints) -> _Fields:
    """Fields of any content between places, with the first point of each; other points are left out."""
    points = np.flatnonzero(text == _POINT)
    place = np.searchsorted(points, starts)
    found = np.append(points, np.iinfo(np.int64).max)[place]
    return _Fields.of(text, starts, np.where(found < ends, found, ends), ends, digits=False)


def _fields_by_mark(text: Bytes, mark: int, width: int) -> tuple[Ints, Ints] | None:
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


def _without_blanks(text: Bytes, starts: Ints, ends: Ints) -> tuple[Ints, Ints]:
    """Fields without the blanks around them, except where there are very many."""
    for _ in range(_LONGEST):
        before, behind = text[starts] == _BLANK, text[ends - 1] == _BLANK
        if not (before.any() or behind.any()):
            break
        starts, ends = starts + before, ends - behind
    return starts, ends


def _fields_by_blanks(text: Bytes, width: int) -> tuple[Ints, Ints] | None:
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


def _decimals(text: Bytes, words: Words, fields: _Fields) -> Floats | None:
    """Doubles nearest to the numbers that fill the fields; None where one is no number, or many are unusual."""
    # Without a point there are no places; how many are too many does not matter.
    whole, places = fields.points - fields.begins, np.clip(fields.ends - fields.points - 1, 0, _LONGEST + 1)
    few = np.zeros(0, dtype=np.int64)
    parsed = _of_equal_places(words, fields, whole, int(places[0])) if (places == places[0]).all() else None
    if parsed is None:
        parsed, odd = _of_any_places(words, fields, whole, places)
        few = np.flatnonzero(odd)
    tens = _TENS[places[0]] if places.min() == places.max() else _TENS.take(places)
    wholes = parsed.view(np.int64) if parsed.max() <= _LARGEST_SIGNED else parsed
    values = wholes.astype(np.float64)
    values /= tens
    long = np.flatnonzero(parsed >= _EXACT)
    if len(long):
        values[long] = _corrected(values[long], parsed[long], tens[long] if tens.ndim else tens)
    np.negative(values, out=values, where=fields.minus)
    return values if not len(few) or _one_by_one(values, few, text, fields) else None


def _of_equal_places(words: Words, fields: _Fields, whole: Ints, places: int) -> Words | None:
    """Numbers of `places` decimals without their points; None where some are too long for this, or may be none."""
    behind, first = places // 8 * 8, places % 8
    shortest, longest = int(whole.min()), int(whole.max())
    if not fields.digits or not 0 <= shortest <= longest <= 7 - first or shortest + places < 1 or behind > 8:
        return None
    # A word with the point among its last characters: those before it move up into its place.
    found = _ending(words, fields.ends, behind)
    after = found & (_DIGITS[first])
    found <<= np.uint64(8)
    found &= ~_LAST[first]
    found |= after
    del after
    whole += first
    found &= _DIGITS.take(whole)
    parsed = _joined(found)
    for rest in range(behind - 8, -1, -8):
        found = _ending(words, fields.ends, rest)
        found &= _NIBBLES
        parsed *= _WHOLE_TENS[8]
        parsed += _joined(found)
    return parsed


def _of_any_places(words: Words, fields: _Fields, whole: Ints, places: Ints) -> tuple[Words, Bools]:
    """Numbers without their points, and which of them are unusual or none."""
    odd = (whole < 0) | (whole > 8) | (places > _LONGEST) | (whole + places < 1)
    if odd.any():
        whole, places = np.where(odd, 0, whole), np.where(odd, 0, places)
    digits = _ending(words, fields.points, 0) ^ _ZEROS
    digits &= _LAST.take(whole)
    wrong = _beyond_nine(digits)
    parsed = _joined(digits)
    odd |= (parsed != 0) & (whole + places > _LONGEST)
    # Decimal places, eight at a time from the left, the last ones being whole.
    for behind in range((int(places.max()) - 1) // 8 * 8, -1, -8):
        some: Any = np.flatnonzero(places > behind)
        if 2 * len(some) > len(places):
            some = slice(None)
        count = np.clip(places[some] - behind, 0, 8)
        digits = _ending(words, fields.ends[some], behind) ^ _ZEROS
        digits &= _LAST.take(count)
        wrong[some] |= _beyond_nine(digits)
        # One power of ten for all is the common case, and faster.
        tens = _WHOLE_TENS[count[0]] if count.min() == count.max() else _WHOLE_TENS.take(count)
        parsed[some] = parsed[some] * tens + _joined(digits)
    odd |= (wrong & _HIGH) != 0
    return parsed, odd


def _ending(words: Words, ends: Ints, behind: int) -> Words:
    """Words of the eight characters that end `behind` characters before places of the text."""
    found: Words = words[_MARGIN - 9 - behind :][ends]
    return found


def _beyond_nine(digits: Words) -> Words:
    """Bits of `_HIGH` where a byte is no digit."""
    wrong = digits + _ABOVE_NINE
    wrong |= digits
    return wrong


def _joined(digits: Words) -> Words:
    """Whole numbers whose eight digits are the bytes of words, the first one lowest. In place."""
    digits *= np.uint64(2561)
    digits >>= np.uint64(8)
    digits &= np.uint64(0x00FF00FF00FF00FF)
    digits *= np.uint64(6553601)
    digits >>= np.uint64(16)
    digits &= np.uint64(0x0000FFFF0000FFFF)
    digits *= np.uint64(42949672960001)
    digits >>= np.uint64(32)
    return digits


def _one_by_one(values: Floats, few: Ints, text: Bytes, fields: _Fields) -> bool:
    """Put unusual numbers in their places; False where one is no number, or there are too many of them."""
    if len(few) > _FEW * len(values) + 1:
        return False
    for k in few.tolist():
        field = text[fields.begins[k] - fields.signed[k] : fields.ends[k]].tobytes().decode("ascii", "replace")
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
