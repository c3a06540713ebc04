# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of numbers as comma-separated text, a whole column at a time: what ``%.12g`` writes, byte for byte.

A number is scaled to an integer of its significant digits, the integer cut into groups of four digits, and each group
looked up in a table of texts. Every number has a slot of the same width; what it does not need of it holds NUL bytes,
which are left out at the end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Columns = Sequence[NDArray[np.float64] | NDArray[np.int64] | NDArray[np.bytes_]]

DIGITS = 12
"""Significant digits, trailing zeros left out."""

LEAST, MOST = -33, 7
"""Powers of ten between which a number is scaled by exact powers of ten, 1e22 the largest, in no more than two steps;
others, and what is not finite, are written one by one."""

UNSURE = 2.0**-11
"""A scaled number, below 2**40 and two roundings of 2**-14 off at most, that is nearer than this to the middle between
two integers may round to either: it is written one by one."""

_ROWS = 8192
"""Rows at a time: a column and all it is made of stay in the processor's cache."""

_PLAIN, _TRAILING, _LEADING = 0, 10000, 20000
_POINT = ord(".")


def _groups() -> NDArray[np.uint32]:
    """Texts of 0 to 9999 in four digits: plain, without zeros at the end, without zeros at the start."""
    digit = np.arange(10000)[:, None] // [1000, 100, 10, 1] % 10
    plain = (digit + ord("0")).astype(np.uint8)
    ends = np.where(np.logical_or.accumulate(digit[:, ::-1] > 0, axis=1)[:, ::-1], plain, 0)
    starts = np.where(np.logical_or.accumulate(digit > 0, axis=1), plain, 0)
    starts[0, 3] = ord("0")
    return np.ascontiguousarray(np.concatenate([plain, ends, starts]), dtype=np.uint8).view(np.uint32)[:, 0]


_GROUPS = _groups()
# By the exponent's bits: power of ten of the smallest number that has them, kept within the range.
_LOWER = np.clip(np.floor((np.arange(2048) - 1023) * np.log10(2.0)), LEAST - 1, MOST).astype(np.int64) - LEAST
_POWERS = np.array([float(f"1e{k}") for k in range(LEAST, MOST + 2)])
_EXPONENTS = np.array([b"e-%02d" % -k if k < -4 else b"" for k in range(LEAST, MOST + 2)], "S4").view(np.uint32)


def lines(columns: Columns, digits: Sequence[int] = ()) -> Iterator[bytes]:
    """Rows of columns as lines of text, commas between the columns.

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
    b'1,0.1,\\n2,,far off\\n'
    """
    count = len(columns[0]) if columns else 0
    digits = digits or (DIGITS,) * len(columns)
    for at in range(0, count, _ROWS):
        yield _block([column[at : at + _ROWS] for column in columns], digits)


def _block(columns: Columns, digits: Sequence[int]) -> bytes:
    parts: list[NDArray[Any]] = []
    for column, figures in zip(columns, digits, strict=True):
        parts += [column] if column.dtype.kind == "S" else _parts(np.asarray(column, dtype=np.float64), figures)
        parts.append(np.full(len(column), b","))
    parts[-1][:] = b"\n"
    width = sum(part.itemsize for part in parts)
    text = np.empty(len(columns[0]) * width, dtype=np.uint8)
    place = 0
    for part in parts:
        np.ndarray(part.shape, part.dtype, text, place, (width,))[:] = part
        place += part.itemsize
    return text[text != 0].tobytes()


def _parts(value: Floats, digits: int) -> list[NDArray[Any]]:
    """Sign, integer, point, decimals and exponent of numbers: arrays of as many texts, NUL where they are shorter."""
    size = np.abs(value)
    row = _LOWER.take(size.view(np.int64) >> 52)
    row += size >= _POWERS.take(row + 1)
    usual = (size >= _POWERS[0]) & (size < _POWERS[MOST - LEAST])
    size[~usual] = 0.0
    # Significant digits as an integer.
    power = digits - 1 - LEAST - np.arange(len(_POWERS))
    scaled = size * (10.0 ** np.minimum(power, 22)).take(row) * (10.0 ** np.maximum(power - 22, 0)).take(row)
    whole = np.rint(scaled)
    odd = np.abs(scaled - whole) > 0.5 - UNSURE
    carried = whole == 10.0**digits
    if carried.any():
        row += carried
        whole[carried] = 10.0 ** (digits - 1)
    whole *= 10.0 ** (DIGITS - digits)
    # Integer in front of the point, and sixteen decimals behind it; with an exponent as a number from 1 to 10.
    exponent = np.arange(LEAST, MOST + 2)
    shown = np.where(exponent < -4, 0, exponent)
    unit = (10.0 ** (DIGITS - 1 - shown)).take(row)
    front = np.floor(whole / unit)
    behind = ((whole - front * unit) * (10.0 ** (16 - DIGITS + 1 + shown)).take(row)).astype(np.int64)
    parts: list[NDArray[Any]] = [(value.view(np.int64) < 0) * np.uint8(ord("-")), *_integer(front)]
    parts += _decimals(behind)
    if (row < -4 - LEAST).any():
        parts.append(_EXPONENTS.take(row) * usual)
    odd |= ~usual & (value != 0.0)
    return _with_odd(parts, value, np.flatnonzero(odd), digits) if odd.any() else parts


def _integer(front: Floats) -> list[NDArray[np.uint32]]:
    """Texts of integers up to 1e7."""
    low = front.astype(np.uint32)
    high = low // np.uint32(10000)
    if not high.any():
        return [_GROUPS.take(low + np.uint32(_LEADING))]
    low -= high * np.uint32(10000)
    return [
        _GROUPS.take(high + np.uint32(_LEADING)) * (high > 0),
        _GROUPS.take(np.where(high > 0, low, low + np.uint32(_LEADING))),
    ]


def _decimals(behind: NDArray[np.int64]) -> list[NDArray[Any]]:
    """Point and texts of sixteen decimals, zeros at the end left out; groups that none of the numbers has are, too."""
    if not behind.any():
        return []
    upper = behind // 10**8
    groups: list[NDArray[np.uint32]] = []
    for half in (upper, behind - upper * 10**8):
        eight = half.astype(np.uint32)
        four = eight // np.uint32(10000)
        groups += [four, eight - four * np.uint32(10000)]
    parts: list[NDArray[Any]] = []
    last = np.ones(len(behind), dtype=bool)
    for group in reversed(groups):
        if parts or group.any():
            parts.append(_GROUPS.take(group + last * np.uint32(_TRAILING)))
            last &= group == 0
    parts.append(~last * np.uint8(_POINT))
    return parts[::-1]


def _with_odd(parts: list[NDArray[Any]], value: Floats, rows: NDArray[np.int64], digits: int) -> list[NDArray[Any]]:
    """Parts with the texts of numbers that are written one by one, across all parts; NaN has none."""
    for part in parts:
        part[rows] = 0
    rows = rows[~np.isnan(value[rows])]
    if not len(rows):
        return parts
    texts = [b"%.*g" % (digits, number) for number in value[rows].tolist()]
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
