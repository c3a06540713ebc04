# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is read many lines at a time is what is read line by line: the same points, or the same refusal."""

from __future__ import annotations

import random

import numpy as np
import pytest

from millcorr.errors import FormatError, UsageError
from millcorr.readers import dmis, dprnt, mapped, msr
from millcorr.readers.decimal_columns import decimal_words
from millcorr.readers.decoding import blocks_of
from tests.core import measurement_files as files
from tests.core import readers_fuzz

SHORTCUTS = {"msr": (msr, "decimal_words"), "dprnt": (dprnt, "decimal_words"), "mapped": (mapped, "decimal_tables")}


def outcome(format, data, options):
    try:
        m = readers_fuzz.read(format, data, options)
    except (FormatError, UsageError) as error:
        return str(error)
    optional = [None if a is None else a.tobytes() for a in (m.normals, m.nominal, m.stated)]
    return m.points.tobytes(), m.lines.tolist(), m.elements, m.notes, m.ball_radius, optional


@pytest.mark.parametrize("format", SHORTCUTS)
def test_damaged_files_come_out_alike(format, monkeypatch):
    generator = random.Random(format)
    module, name = SHORTCUTS[format]
    if hasattr(module, "_BLOCK"):
        # Small enough for points to be cut in two by the end of a block, and for damage to leave whole blocks.
        monkeypatch.setattr(module, "_BLOCK", 150)
    candidates = readers_fuzz.large(format, 12)
    different = refused = 0
    for _ in range(400):
        subject = generator.choice(candidates)
        data = files.damaged(subject.data, generator)
        shortened = outcome(format, data, subject.options)
        with monkeypatch.context() as context:
            context.setattr(module, name, lambda *_, **__: None)
            assert outcome(format, data, subject.options) == shortened, data
        refused += isinstance(shortened, str)
        different += not isinstance(shortened, str)
    assert refused > 20 and different > 20


@pytest.mark.parametrize("format", SHORTCUTS)
def test_the_shortcut_is_taken(format, monkeypatch):
    module, name = SHORTCUTS[format]
    taken = []
    original = getattr(module, name)
    monkeypatch.setattr(module, name, lambda *a, **k: taken.append(original(*a, **k)) or taken[-1])
    for subject in readers_fuzz.large(format, 4000):
        taken.clear()
        readers_fuzz.read(format, subject.data, subject.options)
        assert any(found is not None for found in taken)


def test_plain_dmis_points_come_out_as_by_their_words(monkeypatch):
    generator = random.Random("dmis")
    never = type("Never", (), {"fullmatch": staticmethod(lambda text: None)})
    for _ in range(400):
        subject = generator.choice(readers_fuzz.large("dmis", 6))
        data = files.damaged(subject.data, generator)
        plain = outcome("dmis", data, subject.options)
        with monkeypatch.context() as context:
            context.setattr(dmis, "_PLAIN", never)
            context.setattr(dmis, "_PLAIN_OF_CURVE", never)
            assert outcome("dmis", data, subject.options) == plain, data


def test_words_are_letters_with_one_number_each():
    found = decimal_words("G801N1X-.5 Y+12.25\nG800 N 2X1E\n".replace("E", "0"))
    assert found is not None
    assert found.letters.tobytes() == b"GNXYGNX"
    np.testing.assert_array_equal(found.values, [801, 1, -0.5, 12.25, 800, 2, 10])
    np.testing.assert_array_equal(found.first, [0, 4, 7])
    np.testing.assert_array_equal(found.digits[[0, 2, 3]], [3, 2, 5])


@pytest.mark.parametrize(
    "lines",
    ["", "X", "X1 2\n", "X Y1 2\n", "1X2\n", "X\n1Y2\n", "X1E5\n", "X-\n", "X1,5\n", "X1-2\n", "Xä\n", "X1.2.3\n"],
)
def test_what_is_no_word_is_left_to_the_line(lines):
    assert decimal_words(lines) is None


def test_blocks_are_whole_lines_and_nothing_is_lost():
    text = "ab\n" * 100 + "c" * 50 + "\n\nlast"
    for size in (1, 3, 7, 64, 10_000):
        blocks = list(blocks_of(text, size))
        assert "".join(blocks) == text and all(block.endswith("\n") for block in blocks[:-1])
