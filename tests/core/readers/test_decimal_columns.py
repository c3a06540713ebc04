# SPDX-License-Identifier: LGPL-2.1-or-later
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.readers import decimal_columns as module
from millcorr.readers.decimal_columns import decimal_columns
from tests.core.sweeps import examples

number = st.one_of(
    st.from_regex(r"[+-]?[0-9]{1,9}\.[0-9]{0,4}", fullmatch=True),
    st.from_regex(r"[+-]?[0-9]{0,3}\.[0-9]{1,17}", fullmatch=True),
    st.from_regex(r"[+-]?[0-9]{1,20}", fullmatch=True),
    st.floats(-1e6, 1e6).map(repr),
    st.sampled_from(
        ["-0.0", "+.5", "5.", "-0", "9007199254740993", "0.9007199254740993", "900719925.4740993", "1e-7", "2.5E3"]
    ),
)


@pytest.mark.parametrize("block", [1 << 17, 64])
@settings(max_examples=examples(150), deadline=None)
@given(data=st.data(), width=st.integers(1, 4), separator=st.sampled_from([",", ";", "\t", None]))
def test_every_number_is_the_nearest_double(block, data, width, separator):
    rows = data.draw(st.lists(st.lists(number, min_size=width, max_size=width), min_size=1, max_size=12))
    between = " " if separator is None else separator
    pads = st.sampled_from(["", "", "", " ", "   "])
    lines = [between.join(data.draw(pads) + field + data.draw(pads) for field in row) for row in rows]
    kept, original = module._BLOCK, "\n".join(lines) + data.draw(st.sampled_from(["", "\n", "\n\n"]))
    module._BLOCK = block
    try:
        found = decimal_columns(original, separator, width, range(width), first=5)
    finally:
        module._BLOCK = kept
    values, numbers = found
    wanted = np.array([[float(f) for f in row] for row in rows])
    np.testing.assert_array_equal(values, wanted)
    np.testing.assert_array_equal(np.signbit(values), np.signbit(wanted))
    np.testing.assert_array_equal(numbers, np.arange(5, 5 + len(rows)))


@settings(max_examples=examples(500), deadline=None)
@given(
    text=st.text(alphabet="0123456789..,,\n\n -+e;x", max_size=60),
    separator=st.sampled_from([",", ";", None]),
    width=st.integers(1, 3),
)
def test_what_is_no_table_is_left_alone(text, separator, width):
    rows = [line.split(separator) for line in text.split("\n") if line.strip()]
    plain = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*")
    regular = bool(rows) and all(len(r) == width and all(plain.fullmatch(f) for f in r) for r in rows)
    found = decimal_columns(text, separator, width, range(width))
    if found is None:
        return
    assert regular
    np.testing.assert_array_equal(found[0], [[float(f) for f in row] for row in rows])


def test_only_the_wanted_columns_need_to_be_numbers():
    rows = "".join(f"P{k}.;{k}.5;Größe;{-k}.25\n" for k in range(50))
    values, lines = decimal_columns(rows, ";", 4, [3, 1])
    np.testing.assert_array_equal(values[7], [-7.25, 7.5])
    np.testing.assert_array_equal(lines, np.arange(1, 51))
    assert decimal_columns(rows, ";", 4, [2]) is None
    assert decimal_columns(rows, ";", 3, [1]) is None


def test_blank_lines_and_odd_numbers_cost_their_block_only(monkeypatch):
    monkeypatch.setattr(module, "_BLOCK", 200)
    rows = [f"{k}.5,{k}.25" for k in range(300)]
    rows[100], rows[200] = "1e2,-1.5E-3", "\n" + rows[200]
    values, lines = decimal_columns("header\n" + "\n".join(rows), ",", 2, [0, 1], begin=7, first=2)
    np.testing.assert_array_equal(values[100], [100, -0.0015])
    np.testing.assert_array_equal(lines, np.delete(np.arange(2, 303), 200))


@pytest.mark.parametrize("text", ["", "\n\n", "1.0,2.0\n3.0\n", "1.0,2.0,3.0\n", "1.0,nan\n", "1.0,2_0.0\n", "1.0,\n"])
def test_none_where_there_is_no_such_table(text):
    assert decimal_columns(text, ",", 2, [0, 1]) is None


def test_ties_and_their_neighbours():
    # Halfway between two doubles, and one digit in the last place beside it.
    random = np.random.default_rng(5)
    halves = [(int(k) | 1) * 125 for k in random.integers(2**53, 2**54, 20_000)]
    texts = [f"{n + d}"[:8] + "." + f"{n + d}"[8:] for n in halves for d in (-1, 0, 1)]
    values, _ = decimal_columns("\n".join(texts), ",", 1, [0])
    np.testing.assert_array_equal(values[:, 0], [float(t) for t in texts])


def test_every_digit_that_python_prints(monkeypatch):
    monkeypatch.setattr(module, "_by_numpy", None)
    random = np.random.default_rng(6)
    table = 10 ** random.uniform(-2.5, 5, (5000, 3)) * random.choice([-1, 1], (5000, 3))
    table[7] = 1e-7, -2.5e300, 0.0
    values, _ = decimal_columns("\n".join(";".join(map(repr, row)) for row in table.tolist()), ";", 3, [0, 1, 2])
    np.testing.assert_array_equal(values, table)
