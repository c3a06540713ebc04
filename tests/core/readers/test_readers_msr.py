# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.sweeps import examples

TWO = """START
G800 N1 X10 Y0 Z-5 I1 J0 K0 O0 U0.01 L-0.01
G801 N1 X12.53 Y0 Z-5 R2.5
G800 N2 X0 Y10 Z-5 I0 J1 K0 O0 U0.01 L-0.01
G801 N2 X0 Y12.46 Z-5 R2.5
END
"""


@pytest.fixture
def msr_file(tmp_path):
    def make(content, name="part.msr"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


def turn(a, b, c):
    """Turn about x, then y, then z, each fixed, by multiplying what each alone does."""

    def about(axis, degrees):
        cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        m = np.eye(3)
        i, j = ((1, 2), (2, 0), (0, 1))[axis]
        m[i, i] = m[j, j] = cos
        m[i, j], m[j, i] = -sin, sin
        return m

    return about(2, c) @ about(1, b) @ about(0, a)


def test_two_points(msr_file):
    path = msr_file(TWO)
    m = readers.read(path)
    assert m.format == "msr" and m.unit == "mm" and m.ball_radius == 2.5 and m.notes == ()
    np.testing.assert_array_equal(m.points, [[12.53, 0, -5], [0, 12.46, -5]])
    np.testing.assert_array_equal(m.nominal, [[10, 0, -5], [0, 10, -5]])
    np.testing.assert_array_equal(m.normals, [[1, 0, 0], [0, 1, 0]])
    np.testing.assert_array_equal(m.lines, [3, 5])
    np.testing.assert_allclose(m.contact(), [[10.03, 0, -5], [0, 9.96, -5]], atol=1e-14)
    np.testing.assert_allclose(m.from_nominal(), [0.03, -0.04], atol=1e-14)
    assert m.origin(1) == f"{path}:5 (N2)"


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace(" X", "X").replace(" Y", "Y").replace(" Z", "Z").replace(" R", "R"),
        lambda t: t.replace(" ", ""),
        lambda t: t.replace("X", "X  ").replace("Y", "  Y   "),
        lambda t: t.replace("\n", "\r"),
        lambda t: t.replace("\n", "\r\n"),
        lambda t: "\x12%\r\n" + t.replace("\n", "\x12\r\n") + "%\x14",
        lambda t: t.lower(),
        lambda t: t.replace("START\n", "START\nSTART\n"),
        lambda t: t.replace("G800 N2", "END\nSTART\nG800 N2"),
        lambda t: t.replace("START\n", "START\nRESULTSFILE 1001-RESULTS\nDOCUMENTID abc\nTOOLPATHID 3.00001\n"),
        lambda t: t.replace("START\n", "START\n;SequenceItem CV\n(made by hand)\nG331 N0 A0 B0 C0 X0 Y0 Z0\n"),
        lambda t: t.replace("L-0.01", "L0.01"),
        lambda t: t.replace("Y0 ", "Y-.0 ").replace("X0 ", "X0. "),
        lambda t: t.replace("K0", "K-1E-05"),
        lambda t: t.replace("START\n", "START\nG330 N0 A0.0 B0.0 C0.0 X0.0 Y0.0 Z0.0 I0 R0\n"),
        lambda t: t.replace("START\n", "START\n;Prüfling Ø10\n"),
    ],
)  # fmt: skip
def test_dresses_of_the_same_points(msr_file, change):
    m = readers.read(msr_file(change(TWO).encode("cp1252")))
    assert m.format == "msr"
    np.testing.assert_allclose(m.points, [[12.53, 0, -5], [0, 12.46, -5]], atol=1e-12)
    np.testing.assert_allclose(m.from_nominal(), [0.03, -0.04], atol=1e-4)


def test_g330_turns_and_shifts_what_follows_it(msr_file):
    # A workplane whose x is the work frame's y: its point (10, 0, 0) lies at (0, 10, 0), then shifted.
    m = readers.read(
        msr_file(
            "START\nG330 N0 A0 B0 C90 X1 Y2 Z3 I0 R0\nG800 N1 X10 Y0 Z0 I1 J0 K0\nG801 N1 X11.5 Y0 Z0 R1.5\n"
            "G330 N1 A0 B0 C0 X0 Y0 Z0 I0 R0\nG800 N2 X10 Y0 Z0 I1 J0 K0\nG801 N2 X11.5 Y0 Z0 R1.5\nEND\n"
        )
    )
    np.testing.assert_allclose(m.points, [[1, 13.5, 3], [11.5, 0, 0]], atol=1e-14)
    np.testing.assert_allclose(m.nominal, [[1, 12, 3], [10, 0, 0]], atol=1e-14)
    np.testing.assert_allclose(m.normals, [[0, 1, 0], [1, 0, 0]], atol=1e-14)
    assert m.notes[0] == "1 points turned back by G330" and "1 points shifted" in m.notes[1]


def test_end_is_missed(msr_file):
    assert "no END" in readers.read(msr_file(TWO.replace("END\n", ""))).notes[0]


def test_two_balls_are_made_one(msr_file):
    m = readers.read(msr_file(TWO.replace("Y12.46 Z-5 R2.5", "Y10.96 Z-5 R1")))
    assert m.ball_radius == 2.5
    np.testing.assert_allclose(m.from_nominal(), [0.03, -0.04], atol=1e-14)
    assert "another probe ball" in m.notes[0]


def test_inch_is_believed_when_said(msr_file):
    m = readers.read(msr_file(TWO), units="inch")
    assert m.ball_radius == pytest.approx(63.5) and m.points[0, 0] == pytest.approx(12.53 * 25.4)


@pytest.mark.parametrize(
    ("options", "says"),
    [({"points": "contact"}, "contradicts"), ({"points": "centre", "probe_radius": 3.0}, "2.5 mm")],
)
def test_contradictions(msr_file, options, says):
    path = msr_file(TWO)
    with pytest.raises(UsageError, match=says):
        readers.read(path, **options)
    assert len(readers.read(path, points="centre", probe_radius=2.5)) == 2


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("G801 N1 X12.53 Y0 Z-5 R2.5\n", "", 3, "G801 of point 1 is missing"),
        ("G800 N1 X10 Y0 Z-5 I1 J0 K0 O0 U0.01 L-0.01\n", "", 2, "without its G800"),
        ("G801 N2 X0 Y12.46 Z-5 R2.5\nEND\n", "", 4, "cut off"),
        ("G801 N2", "G801 N3", 5, "lines were lost"),
        ("X12.53", "X12.53 X1", 3, "letter X twice"),
        ("X12.53", "X12,53", 3, "no letter with a number"),
        ("X12.53", "X", 3, "no letter with a number"),
        ("X12.53", "", 3, "lacks X"),
        (" R2.5\nG800 N2", "\nG800 N2", 3, "lacks R"),
        ("I1 ", "", 2, "lacks I"),
        ("G801 N1 ", "G801 ", 3, "lacks N"),
        ("N1 X10", "N1.5 X10", 2, "no number of a point"),
        ("R2.5", "R-2.5", 3, "negative"),
        ("X12.53", "X1E8", 3, "no length"),
        ("X12.53", "X1E999", 3, "no length"),
        ("I1 ", "I0.5 ", 3, "length 0.5"),
        ("G801 N1", "G8O1 N1", 3, "missing"),
        ("END", "8", 6, "no line of an MSR file"),
        ("START\n", "START\nG330 N0 A0 B0 X0 Y0 Z0\n", 2, "lacks C"),
        ("START\n", "START\nG330 N0 A0 B0 C0 C1\n", 2, "twice"),
        ("X12.53", "X12\xb7.53", 3, "0xB7"),
        ("G801", "\xc6G801", 3, "0xC6"),
    ],
)  # fmt: skip
def test_refused_with_the_line(msr_file, old, new, line, says):
    assert old in TWO
    path = msr_file(TWO.replace(old, new, 1).encode("latin-1"))
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(path)
    assert caught.value.file == str(path) and caught.value.line == line
    assert "\n" not in str(caught.value)


def test_no_points(msr_file):
    with pytest.raises(FormatError, match="no measured points"):
        readers.read(msr_file("START\nG330 N0 A0 B0 C0\nEND\n"))


angle = st.floats(-180, 180).map(lambda v: round(v, 6))


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(1, 9),
    seed=st.integers(0, 99),
    turns=st.lists(st.tuples(angle, angle, angle), max_size=3),
    shift=st.tuples(angle, angle, angle),
    dense=st.booleans(),
)
def test_written_and_read_back(tmp_path, n, seed, turns, shift, dense):
    part = files.ellipse(n, seed=seed)
    text = files.msr(
        part,
        rotations=tuple(turn(*t) for t in turns),
        angles=tuple(turns),
        shifts=(shift,) * len(turns),
        dense=dense,
    )
    path = tmp_path / "round.msr"
    path.write_text(text)
    m = readers.read(path)
    np.testing.assert_allclose(m.points, part.centres, atol=1e-5)
    np.testing.assert_allclose(m.nominal, part.nominal, atol=1e-5)
    np.testing.assert_allclose(m.normals, part.normals, atol=1e-7)
    np.testing.assert_allclose(m.from_nominal(), part.deviations, atol=1e-5)
    assert m.ball_radius == part.radius
