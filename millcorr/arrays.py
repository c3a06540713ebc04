# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of arrays, and nouns made of them: frozen dataclasses whose arrays nobody writes to either."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Bytes = NDArray[np.uint8]
"""Arrays of lengths and other numbers, of rows and counts, of what holds or not, and of text."""

SHORT = 4096
"""A column shorter than this is kept as it is: it takes less than a page of memory for each noun it stands in."""


@dataclass(frozen=True, eq=False, slots=True)
class ReadOnlyArrays:
    """Base of a frozen dataclass: every array among its fields is made read-only, not copied."""

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if isinstance(value, np.ndarray):
                value.flags.writeable = False


@dataclass(frozen=True, eq=False, slots=True)
class CompactColumns:
    """Base of a frozen dataclass of columns of one length: each of them `compact`."""

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, compact(getattr(self, item.name)))


def compact(column: NDArray[Any]) -> NDArray[Any]:
    """The same values; a long column of one value over and over takes the memory of one.

    Parameters
    ----------
    column : (n,) or (n, k) array

    Returns
    -------
    array
        Of the same shape, read-only.
    """
    out = column
    if len(column) >= SHORT and column.strides[0]:
        first = column[:1]
        # Most columns that vary do so at once.
        if _equal(column[1:64], first) and _equal(column, first):
            out = np.broadcast_to(first.copy(), column.shape)
    out.flags.writeable = False
    return out


def _equal(column: NDArray[Any], first: NDArray[Any]) -> bool:
    same = column == first
    if column.dtype.kind == "f":
        same |= np.isnan(column) & np.isnan(first)
    return bool(same.all())
