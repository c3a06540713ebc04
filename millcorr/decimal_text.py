# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of numbers as comma-separated text, a whole column at a time: what ``%.12g`` writes, byte for byte.

A number is scaled to an integer of its significant digits, the integer cut into groups of four digits, and each group
looked up in a table of texts. Every number has a slot of the same width; what it does not need of it holds NUL bytes,
which are left out at the end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

Columns = Sequence[Floats | Ints | NDArray[np.bytes_]]

DIGITS = 12
"""Significant digits, trailing zeros left out."""

LEAST, MOST = -33, 7
"""Powers of ten between which a number is scaled by exact powers of ten, 1e22 the largest, in no more than two steps;
others, and what is not finite, are written one by one."""

UNSURE = 2.0**-11
"""A scaled number, below 2**40 and two roundings of 2**-14 off at most, that is nearer than this to the middle between
two integers may round to either: it is written one by one."""

_ROWS, _ROWS_OF_TEXT = 8192, 2048
"""Rows of a column, and rows of all columns, that stay in the processor's cache with all that is made of them."""

_POINT, _MINUS, _COMMA = b".-,"
_NO_DIGITS, _NEGATIVE = 10000, 10001
_TRAILING = 10000


def lines(columns: Columns, digits: Sequence[int] = ()) -> Iterator[bytes]:
    r"""Rows of columns as lines of text, commas between the columns.

    Parameters
    ----------
    columns : sequence of (n,) arrays
        float64 and int64 are written as ``%.12g``, NaN as nothing; bytes as they are, without NUL.
    digits : sequence of int, optional
        Significant digits of each column, 8 to 12; 12 by default.

    Yields
    ------
    bytes
        Whole lines, each with a line feed behind; as many as rows in all.

    Examples
    --------
    >>> b"".join(lines([np.array([1, 2]), np.array([0.1, np.nan]), np.array([b"", b"far off"])]))
    b'1,0.1,\n2,,far off\n'
    """
    count = len(columns[0]) if columns else 0
    digits = digits or (DIGITS,) * len(columns)
    for at in range(0, count, _ROWS):
        progress.step()
        yield from _block([column[at : at + _ROWS] for column in columns], digits)


def _block(columns: Columns, digits: Sequence[int]) -> Iterator[bytes]:
    rows = len(columns[0])
    parts: list[NDArray[Any]] = []
    for column, figures in zip(columns, digits, strict=True):
        comma = column is not columns[0]
        if column.dtype.kind == "S":
            parts += [np.full(rows, b","), column] if comma else [column]
        else:
            parts += _parts(np.ascontiguousarray(column, dtype=np.float64), figures, comma)
    parts.append(np.full(rows, b"\n"))
    width = sum(part.itemsize for part in parts)
    for at in range(0, rows, _ROWS_OF_TEXT):
        some = [part[at : at + _ROWS_OF_TEXT] for part in parts]
        text = np.empty(len(some[0]) * width, dtype=np.uint8)
        place = 0
        for part in some:
            np.ndarray(part.shape, part.dtype, text, place, (width,))[:] = part
            place += part.itemsize
        shown: NDArray[np.uint8] = text[text != 0]
        yield shown.tobytes()


def _parts(value: Floats, digits: int, comma: bool) -> list[NDArray[Any]]:
    """Text of numbers from the comma to the exponent in pieces: arrays of as many texts, NUL where they are shorter."""
    bits = value.view(np.int64)
    if (bits == bits[0]).all():
        return [np.full(len(value), _text(float(value[0]), digits, comma))]
    scale = _scale(digits)
    size = np.abs(value)
    row = scale.lower.take(size.view(np.int64) >> 52)
    row += size >= scale.power.take(row + 1)
    usual = (size >= scale.power[0]) & (size < scale.power[MOST - LEAST])
    size[~usual] = 0.0
    # Significant digits as an integer.
    scaled = size * scale.once.take(row) * scale.again.take(row)
    whole = np.rint(scaled)
    odd = np.abs(scaled - whole) > 0.5 - UNSURE
    odd |= ~usual & (value != 0.0)
    carried = whole == scale.limit
    if carried.any():
        row += carried
        whole[carried] = scale.limit / 10.0
    # Integer in front of the point, and sixteen decimals behind it; with an exponent as a number from 1 to 10.
    unit = scale.unit.take(row)
    front = np.floor(whole / unit)
    decimals = ((whole - front * unit) * scale.decimal.take(row)).astype(np.int64)
    parts = [*_integer(front, bits < 0, comma), *_decimals(decimals)]
    if (row < -4 - LEAST).any():
        parts.append(scale.exponent.take(row) * usual)
    return _with_odd(parts, value, np.flatnonzero(odd), digits, comma) if odd.any() else parts


def _text(number: float, digits: int, comma: bool) -> bytes:
    return b"," * comma + (b"" if number != number else b"%.*g" % (digits, number))


def _integer(front: Floats, negative: Bools, comma: bool) -> list[NDArray[Any]]:
    """Comma, sign and digits of integers up to 1e7."""
    low = front.astype(np.uint32)
    behind: NDArray[np.uint32] = negative * np.uint32(_NEGATIVE)
    if not (low > 9999).any():
        return [_fronts(comma).take(low + behind)]
    high = low // np.uint32(10000)
    low -= high * np.uint32(10000)
    upper = _fronts(comma).take(np.where(high > 0, high, np.uint32(_NO_DIGITS)) + behind)
    return [upper, np.where(high > 0, _groups().take(low), _leading().take(low))]


def _decimals(decimals: Ints) -> list[NDArray[Any]]:
    """Point and texts of sixteen decimals, zeros at the end left out; groups that none of the numbers has are, too."""
    if not decimals.any():
        return []
    upper = decimals // 10**8
    fours: list[NDArray[np.uint32]] = []
    for half in (upper, decimals - upper * 10**8):
        eight = half.astype(np.uint32)
        four = eight // np.uint32(10000)
        fours += [four, eight - four * np.uint32(10000)]
    parts: list[NDArray[Any]] = []
    last = np.ones(len(decimals), dtype=bool)
    for four in reversed(fours):
        if parts or four.any():
            text = _groups().take((four + last * np.uint32(_TRAILING)).astype(np.uint32, copy=False))
            parts.append(text)
            last &= four == 0
    parts.append(~last * np.uint8(_POINT))
    return parts[::-1]


def _with_odd(parts: list[NDArray[Any]], value: Floats, rows: Ints, digits: int, comma: bool) -> list[NDArray[Any]]:
    """Parts with the texts of numbers that are written one by one, across all parts; NaN has none."""
    for part in parts:
        part[rows] = 0
    parts[0][rows] = _fronts(comma)[_NO_DIGITS]
    rows = rows[~np.isnan(value[rows])]
    if not len(rows):
        return parts
    texts = [_text(number, digits, comma) for number in value[rows].tolist()]
    width = sum(part.itemsize for part in parts)
    longest = max(map(len, texts))
    if longest > width:
        parts, width = [*parts, np.zeros(len(value), dtype=f"S{longest - width}")], longest
    slots = np.array(texts, dtype=f"S{width}").view(np.uint8).reshape(-1, width)
    place = 0
    for part in parts:
        piece = slots[:, place : place + part.itemsize]
        part[rows] = np.ascontiguousarray(piece).view(part.dtype)[:, 0]
        place += part.itemsize
    return parts


class _Scale:
    """Factors by the power of ten of a number, from `LEAST` on.

    `lower` is by the exponent's bits: power of ten of the smallest number that has them, kept within the range.
    """

    def __init__(self, digits: int) -> None:
        powers = range(LEAST, MOST + 2)
        steps = [digits - 1 - k for k in powers]
        shown = [0 if k < -4 else k for k in powers]
        self.lower = np.clip(np.floor((np.arange(2048) - 1023) * np.log10(2.0)), LEAST - 1, MOST).astype(int) - LEAST
        self.power = _tens(powers)
        self.once, self.again = _tens([min(k, 22) for k in steps]), _tens([max(k - 22, 0) for k in steps])
        self.limit = float(10**digits)
        self.unit, self.decimal = _tens([digits - 1 - k for k in shown]), _tens([17 - digits + k for k in shown])
        exponents = [b"e-%02d" % -k if k < -4 else b"" for k in powers]
        self.exponent = np.array(exponents, dtype="S4").view(np.uint32)


_scale = cache(_Scale)


def _tens(exponents: Sequence[int]) -> Floats:
    """Powers of ten, correctly rounded (which a vectorised power is not on every processor)."""
    return np.array([float(f"1e{k}") for k in exponents])


def _digits() -> Ints:
    out: Ints = np.arange(10000)[:, None] // np.array([1000, 100, 10, 1]) % 10
    return out


def _as_groups(digit: Ints, shown: Bools | bool) -> NDArray[np.uint32]:
    return np.where(shown, digit + ord("0"), 0).astype(np.uint8).view(np.uint32)[:, 0]


@cache
def _groups() -> NDArray[np.uint32]:
    """Texts of 0 to 9999 in four digits, and behind them those without the zeros at the end."""
    digit = _digits()
    wanted: Bools = np.logical_or.accumulate(digit[:, ::-1] > 0, axis=1)[:, ::-1]
    return np.concatenate([_as_groups(digit, True), _as_groups(digit, wanted)])


@cache
def _leading() -> NDArray[np.uint32]:
    """Texts of 0 to 9999 on the right of four bytes."""
    digit = _digits()
    wanted = np.logical_or.accumulate(digit > 0, axis=1)
    wanted[0, 3] = True
    return _as_groups(digit, wanted)


@cache
def _fronts(comma: bool) -> NDArray[np.uint64]:
    """Texts from the comma to the units, on the right of eight bytes: 0 to 9999, then no digits; the negative ones.

    Commas stand beside the digits, so that what is copied at the end are few and long runs.
    """
    number = np.arange(_NEGATIVE)
    text = np.zeros((2, _NEGATIVE, 8), dtype=np.uint8)
    text[:, :_NO_DIGITS, 4:] = _leading()[:, None].view(np.uint8)
    before = 7 - (number < _NO_DIGITS) * (1 + (number > 9).astype(int) + (number > 99) + (number > 999))
    text[1, number, before] = _MINUS
    if comma:
        text[0, number, before] = _COMMA
        text[1, number, before - 1] = _COMMA
    return text.reshape(-1, 8).view(np.uint64)[:, 0]
