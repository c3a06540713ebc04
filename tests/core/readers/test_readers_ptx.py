# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans as PTS and PTX."""

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError
from tests.core import measurement_files as files

PART = files.ellipse(6)


@pytest.fixture
def scan(tmp_path):
    def make(text):
        path = tmp_path / "scan.ptx"
        path.write_text(text, newline="")
        return path

    return make


@pytest.mark.parametrize("colour", [False, True])
def test_pts(scan, colour):
    m = readers.read(scan(files.pts(PART, colour=colour)), points="contact")
    assert m.format == "ptx" and m.notes == ()
    np.testing.assert_allclose(m.points, PART.contact, atol=6e-7)
    np.testing.assert_array_equal(m.lines, np.arange(2, 8))


@pytest.mark.parametrize("missed", [0, 2])
def test_ptx_where_it_was_registered(scan, missed):
    m = readers.read(scan(files.ptx(PART, missed=missed)), points="contact")
    np.testing.assert_allclose(m.points, PART.contact, atol=3e-9)
    assert m.notes == ((f"{6 * missed} rays that met nothing left out",) if missed else ())
    assert m.lines[0] == 11 and m.bases["unit"].how == "assumed"


@pytest.mark.parametrize("ending", ["\r\n", "\r"])
def test_line_ends_of_other_systems(scan, ending):
    text = files.ptx(PART) * 2
    wanted = readers.read(scan(text), points="contact")
    m = readers.read(scan(text.replace("\n", ending)), points="contact")
    assert len(m) == 12 and m.points.tobytes() == wanted.points.tobytes() and m.lines.tolist() == wanted.lines.tolist()


def test_scans_put_together(scan):
    parts = [files.ellipse(4, seed=seed) for seed in (1, 2)]
    text = files.ptx(parts[0], missed=0) + files.ptx(parts[1], missed=0, turn=-2.0, shift=(50.0, 0.0, 0.0))
    m = readers.read(scan(text), points="contact")
    np.testing.assert_allclose(m.points, np.concatenate([p.contact for p in parts]), atol=3e-9)
    assert m.notes == ("2 scans put together",)
    np.testing.assert_array_equal(m.lines[3:5], [14, 25])


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("9\n1 2 3\n4 5 6\n", 1, "2 points where 9 are announced"),
        ("2\n1 2 3\n4 5 x\n", 3, "'x' is no number"),
        ("2\n1 2 3\n4 5\n", 3, "2 numbers are no point"),
        ("2\n1 2 3\n4 5 6\n7 8 9\n", 4, "is no number of points"),
        ("2\n1 2 3\n4 5 1e999\n", 2, "too large"),
        (files.ptx(PART).replace(" 0\n", " 1\n", 1), 7, "no turn and shift"),
        (files.ptx(PART).replace("1.000000000000 0\n", "2.000000000000 0\n", 1), 7, "no turn and shift"),
        ("1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0\n", 3, "not whole"),
    ],
)
def test_damaged_scans(scan, text, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(scan(text), points="contact")
    assert caught.value.line == line


def test_columns_below_a_number_are_no_scan_with_a_header():
    assert readers.recognised(b"5\nx,y\n1,2\n") == "text"
