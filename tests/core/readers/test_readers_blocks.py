# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is read many lines at a time is what is read line by line: the same points, or the same refusal."""

from __future__ import annotations

import random

import numpy as np
import pytest

from millcorr.errors import FormatError, UsageError
from millcorr.readers import decoding, dmis, dprnt, mapped, msr
from millcorr.readers.decimal_columns import decimal_words
from millcorr.readers.names import Names
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
    # Small enough for points to be cut in two by the end of a piece, and for damage to leave whole pieces.
    monkeypatch.setattr(decoding, "_PIECE", 150)
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


DROPPED = b"\x00\x11\x12\x13\x14\x1a"


def in_one(read, *arguments):
    try:
        return read(*arguments)
    except FormatError as error:
        return str(error)


@pytest.mark.parametrize("drop", (b"", DROPPED))
@pytest.mark.parametrize("size", (1, 3, 7, 64, 10_000))
def test_pieces_are_whole_lines_of_the_same_text(size, drop, monkeypatch):
    monkeypatch.setattr(decoding, "_PIECE", size)
    generator = random.Random(size)
    parts = [b"ab", b"c" * 50, b"\n", b"\r\n", b"\r", b" ", b"\x12", b"\x00", b"\x1a", b"\xb5", b"\x07", b"<xml "]
    weights = [9, 1, 4, 4, 2, 2, 1, 0.3, 0.3, 0.1, 0.1, 0.1]
    read = refused = 0
    for _ in range(1500):
        data = b"".join(generator.choices(parts, weights, k=generator.randrange(1, 40)))
        wanted = in_one(decoding.decode, data, "file", drop)
        found = in_one(lambda *of: list(decoding.pieces(*of)), data, "file", drop)
        if isinstance(found, str):
            refused += 1
        else:
            read += 1
            assert all(piece.endswith("\n") for piece in found[:-1]), data
            found = "".join(found)
        assert found == wanted, data
    assert read > 300 and refused > 30


def test_plain_bytes_are_the_same_text():
    generator = random.Random(5)
    parts = [b"ab", b"\n", b"\r\n", b"\r", b" ", b"\x1a", b"\xb5", b"\x07", b"<xml "]
    own = 0
    for _ in range(1500):
        data = b"".join(generator.choices(parts, [9, 4, 4, 0.5, 2, 0.3, 0.1, 0.1, 0.1], k=generator.randrange(1, 40)))
        wanted, found = (in_one(read, data, "file") for read in (decoding.decode, decoding.plain))
        own += found is data
        assert found == wanted or found.decode().replace("\r\n", "\n") == wanted, data
    assert 300 < own < 1400


def test_a_name_a_point_is_as_a_tuple_of_them():
    several = ("P1", "", "Öse", "12", "\udc80")
    names = Names(iter(several))
    assert names == several and several == names and names != several[:4] and names != Names(several[:4])
    assert names == Names(several) and hash(names) == hash(several) and len(names) == 5
    assert names[-1] == several[-1] and names[2] == "Öse" and names[1:3] == several[1:3] and list(names) == [*several]
    assert names != (*several[:4], "x")
    for beyond in (5, -6):
        with pytest.raises(IndexError):
            names[beyond]
