# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of numbers as text, against Python's own formatting of each number."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr.decimal_text import lines

POWERS = 10.0 ** np.arange(-45, 25)
RANDOM = np.random.default_rng(1)
N = 20_000

NUMBERS = {
    "as measured": np.round(RANDOM.normal(0, 100, N), 4),
    "coordinates": RANDOM.normal(0, 100, N),
    "deviations": RANDOM.normal(0, 0.01, N),
    "any size": 10 ** RANDOM.uniform(-45, 20, N) * RANDOM.choice([-1, 1], N),
    "any bits": RANDOM.integers(-(2**63), 2**63, N).view(np.float64),
    "powers of ten, and all but": np.concatenate([POWERS * (1 + k) for k in (0, 1e-12, -1e-12, 5e-13, -5e-13, -1e-16)]),
    "middles between two texts": np.concatenate([np.arange(N) / 2**k for k in (13, 17, 30, 40)]),
    "directional cosines": np.cos(np.arange(0, 721) * np.pi / 180),
    "special": np.array([0.0, -0.0, np.inf, -np.inf, 5e-324, 1.7e308, 0.99999999999999, 9999999.99999999, 1e7]),
    "even": np.full(3, -3.0),
}


@pytest.mark.parametrize("digits", [12, 9])
@pytest.mark.parametrize("kind", NUMBERS)
def test_numbers_are_written_as_python_writes_them(kind, digits):
    values = NUMBERS[kind]
    expected = [f"{value:.{digits}g}" if value == value else "" for value in values.tolist()]
    assert b"".join(lines([values], (digits,))).decode().splitlines() == expected


def test_columns_are_parted_by_commas():
    columns = (np.arange(9000, dtype=np.int64), np.full(9000, np.nan), np.zeros(9000, "S3"), np.arange(9000) / 8)
    columns[1][8999] = -1e-7
    columns[2][0] = b'"a"'
    text = b"".join(lines(columns)).decode().splitlines()
    assert text[0] == '0,,"a",0' and text[1] == "1,,,0.125" and text[8999] == "8999,-1e-07,,1124.875"
    assert len(text) == 9000


def test_a_first_column_may_be_empty():
    assert b"".join(lines([np.full(2, np.nan), np.array([1e300, 0.5])])) == b",1e+300\n,0.5\n"


def test_no_rows_are_no_lines():
    assert list(lines([np.zeros(0), np.zeros(0, "S1")])) == []
