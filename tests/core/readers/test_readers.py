# SPDX-License-Identifier: LGPL-2.1-or-later
import math
import os
import time
from dataclasses import replace
from hashlib import sha256

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, MillcorrError, UsageError
from millcorr.readers import read, text
from millcorr.readers.measurement import Measurement, Probe
from millcorr.readers.preview import preview
from tests.core.sweeps import examples


@pytest.fixture
def points_file(tmp_path):
    """Function that writes content to a file and returns its path."""

    def make(content, name="points.csv"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
        return path

    return make


def contact(path, **options):
    return read(path, points="contact", **options)


# --- what is accepted -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "content",
    [
        "x,y,z\n1.5,2,3\n4,5,6.25\n",
        "X;Y;Z\n1.5;2;3\n4;5;6.25\n",
        "x\ty\tz\n1.5\t2\t3\n4\t5\t6.25\n",
        "x y z\n1.5 2 3\n4 5 6.25\n",
        "  x   y  z \n  1.5  2   3\n 4   5   6.25 \n",
        "x, y, z\n1.5, 2, 3\n4, 5, 6.25\n",
        "x,y,z\n1.5 2 3\n4 5 6.25\n",
        "x;y;z\n1,5;2;3\n4;5;6,25\n",
        "x\ty\tz\n1,5\t2\t3\n4\t5\t6,25\n",
        "x y z\n1,5 2 3\n4 5 6,25\n",
        "1.5,2,3\n4,5,6.25\n",
        "1,5 2 3\n4 5 6,25\n",
        "1.5 2 3\r\n4 5 6.25\r\n",
        "x,y,z\r1.5,2,3\r4,5,6.25\r",
        "x,y,z\n1.5,2,3\n4,5,6.25",
        "\ufeffx,y,z\n1.5,2,3\n4,5,6.25\n",
        '"x","y","z"\n"1.5","2","3"\n"4","5","6.25"\n',
        '"x";"y";"z"\n"1,5";"2";"3"\n"4";"5";"6,25"\n',
        '"1,5";"2,0";"3,0"\n"4,0";"5,0";"6,25"\n',
        'name;x;y;z\n"P 1";"1,5";"2";"3"\n"P 2";"4";"5";"6,25"\n',
        '"x"\t"y"\t"z"\n"1,5"\t"2"\t"3"\n4\t5\t"6,25"\n',
        "x,y,z,\n1.5,2,3,\n4,5,6.25,\n",
        "x,y,z\n1.5,2,3,\n4,5,6.25,\n",
        "# made by a machine\n\nx,y,z\n\n1.5,2,3\n// between\n4,5,6.25 # behind\n",
        "# x y z\n1.5 2 3\n4 5 6.25\n",
        "Report of part 12\nMachine: CMM\nx,y,z\n1.5,2,3\n4,5,6.25\n",
        "x,y,z\n+1.5e0,2.,3\n4,.5E1,6.25\n",
        "name,z,y,x,dev\nP1,3,2,1.5,\nP2,6.25,5,4,0.1\n",
        "name;z;y;x\nP 1;3;2;1,5\nP 2;6,25;5;4\n",
        "x,y,z\n1.5,2,3\n4,5,6.25\n,,\n ,,\n",
        "x,y,z\n1.5,2,3\n4,5,6.25\n\x1a",
        "x\u00a0y\u00a0z\n1.5\u00a02\u00a03\n4\u00a05\u00a06.25\n",
    ],
)
def test_one_table_in_many_dresses(points_file, content):
    m = contact(points_file(content))
    np.testing.assert_array_equal(m.points, [[1.5, 2, 3], [4, 5, 6.25]])
    assert m.normals is None and m.ball_radius == 0 and m.has_z


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "cp1252"])
def test_encodings(points_file, encoding):
    m = contact(points_file("# Prüfling Ø10 µm\nx;y;z\n1,5;−2;3\n".replace("−", "-").encode(encoding)))
    np.testing.assert_array_equal(m.points, [[1.5, -2, 3]])


def test_typographic_minus(points_file):
    assert contact(points_file("x,y\n\u22121.5,2\n")).points[0, 0] == -1.5


def test_two_columns_have_no_z(points_file):
    for content in ("x,y\n1.5,2\n", "1.5 2\n"):
        m = contact(points_file(content))
        assert not m.has_z
        np.testing.assert_array_equal(m.points, [[1.5, 2, 0]])


def test_normals_by_either_name_and_brought_to_length_one(points_file):
    for header in ("x,y,z,i,j,k", "X,Y,Z,NX,NY,NZ"):
        m = contact(points_file(f"{header}\n1,2,3,0.603,0.804,0\n"))
        np.testing.assert_allclose(m.normals, [[0.6, 0.8, 0]], atol=1e-15)
    m = contact(points_file("x,y,i,j\n1,2,0.6,-0.8\n"))
    np.testing.assert_allclose(m.normals, [[0.6, -0.8, 0]], atol=1e-15)
    m = contact(points_file("1 2 3 0 0 1.0\n"))
    np.testing.assert_array_equal(m.normals, [[0, 0, 1]])


def test_line_numbers_count_everything(points_file):
    m = contact(points_file("# one\r\nx,y,z\r\n\r\n1,2,3\r\n// five\r\n4,5,6\r\n7,8,9"))
    np.testing.assert_array_equal(m.lines, [4, 6, 7])
    m = contact(points_file("x,y,note\n\n1,2,a\n\n3,4,b\n"))
    np.testing.assert_array_equal(m.lines, [3, 5])
    m = contact(points_file("x,y\n1,2\n3,4\n"))
    np.testing.assert_array_equal(m.lines, [2, 3])


def test_source_and_digest(points_file):
    content = b"\xef\xbb\xbfx,y\r\n1,2\r\n"
    path = points_file(content)
    m = contact(path)
    assert m.source == str(path)
    assert m.digest == sha256(content).hexdigest()


@pytest.mark.parametrize(
    "content",
    [
        "x [inch],y [inch],z [inch]\n1,2,3\n",
        "x[in] y[in] z[in]\n1 2 3\n",
        "X (Inch);Y (Inch);Z (Inch)\n1;2;3\n",
        "x_in,y_in,z_in\n1,2,3\n",
        "# units: inch\nx,y,z\n1,2,3\n",
        "Unit = INCH\nx,y,z\n1,2,3\n",
    ],
)
def test_the_header_says_inch(points_file, content):
    path = points_file(content)
    np.testing.assert_allclose(contact(path).points, [[25.4, 50.8, 76.2]], rtol=1e-15)
    with pytest.raises(UsageError, match="contradicts"):
        contact(path, units="mm")


def test_inch_on_request_leaves_normals_and_the_ball_alone(points_file):
    path = points_file("x,y,z,i,j,k\n1,2,3,0,1,0\n")
    m = read(path, points="centre", probe_radius=1.5, units="inch")
    np.testing.assert_allclose(m.points, [[25.4, 50.8, 76.2]], rtol=1e-15)
    np.testing.assert_array_equal(m.normals, [[0, 1, 0]])
    assert m.ball_radius == 1.5
    assert contact(points_file("x [mm],y [mm]\n1,2\n")).points[0, 0] == 1.0


# --- what is asked of the caller --------------------------------------------------------------------------


def test_contact_or_centre_has_no_default(points_file):
    path = points_file("x,y\n1,2\n")
    with pytest.raises(UsageError, match="say --points contact or --points centre"):
        read(path)


@pytest.mark.parametrize(
    "options",
    [
        {"points": "centre"},
        {"points": "centre", "probe_radius": 0.0},
        {"points": "centre", "probe_radius": -1.0},
        {"points": "centre", "probe_radius": float("nan")},
        {"points": "ball"},
        {"points": "contact", "units": "cm"},
        {"points": "contact", "format": "punch card"},
    ],
)
def test_requests_that_make_no_sense(points_file, options):
    with pytest.raises(UsageError):
        read(points_file("x,y\n1,2\n"), **options)


# --- what is refused --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "line", "says"),
    [
        ("", None, "empty"),
        (" \n\n \n", None, "blanks"),
        ("\x00\x00\x00\x00", None, "blanks"),
        ("# only a comment\n", None, "comments"),
        ("x,y,z\n", 1, "no points"),
        ("x,y,z", 1, "no points"),
        ("\n# c\nx,y,z\n\n# c\n", 3, "no points"),
        ("x,y,z\n,,\n", 1, "no points"),
        ("x,y,z\n1,2,3\n4,5\n", 3, "cut off"),
        ("x,y,z\n1,2,3\n4,5,6,7\n", 3, "4 columns"),
        ("x y z\n1 2 3\n4 5\n", 3, "2 columns"),
        ("1.5 2 3\n4 5\n", 2, "2 columns"),
        ("x,y,z\n1,2,3\n4,,6\n", 3, "missing"),
        ("x,y,z\n1,2,3\nend\n", 3, "1 columns"),
        ("x,y,z\n1,2,3\nx,y,z\n4,5,6\n", 3, "'x' is no number"),
        ("x,y,z\n1,2,NaN\n", 2, "no measured value"),
        ("x,y,z\n1,2,3\n1,inf,3\n", 3, "no measured value"),
        ("x,y,z\n1,2,****\n", 2, "no measured value"),
        ("x,y,z\n1,2,1.#QNAN\n", 2, "no measured value"),
        ("x,y,z\n1,2,-1.#IND\n", 2, "no number|no measured"),
        ("x,y,z\n1,2,1e999\n", 2, "too large"),
        ("x,y,z\n1,2,1_000\n", 2, "no number"),
        ("x,y,z\n1,2,0x10\n", 2, "no number"),
        ("x,y,z\n1,2,\u0663\n", 2, "no number"),
        ("x,y,z\n1,2,3mm\n", 2, "no number"),
        # Excel
        ("x;y;z\n262.018;2.5;3\n262,018;2.5;3\n", 3, "spreadsheet"),
        ("x;y;z\n1,262.018;2.5;3\n", 2, "thousands"),
        ("x;y;z\n1,262,018;2,5;3\n", 2, "thousands"),
        ("x,y,z\n1.5,2.5,12.05.2023\n", 2, "date"),
        ("x;y;z\n1,5;2,5;05. Mai\n", 2, "date"),
        ("x,y,z\n1.5,2.5,2023-05-12\n", 2, "date"),
        ("x,y,z\n1.5,2.5,12-May\n", 2, "date"),
        ('x,y,z\n"1,234","5,6",3\n', 2, "decimal comma"),
        ('"1,5","2,3"\n', 1, "with semicolons between"),
        ('x,y\n1.5, "2,3"\n', 2, "export with decimal points"),
        ('"x";"y"\n"1,5";"2.3"\n', 2, "decimal points and decimal commas"),
        ("x,y,z\n1,234,5,678,9,012\n", 2, "decimal comma"),
        ("x,y\n1,234,5,678\n", 2, "decimal comma"),
        ("1,234\n5,678\n", 1, "decimal comma"),
        ("1,234,5,678,9,012\n", 1, "decimal comma"),
        # columns
        ("x,z\n1,2\n", 1, "expected a header"),
        ("a,b,c\n1,2,3\n", 1, "expected a header"),
        ("x,y,x\n1,2,3\n", 1, "twice"),
        ("x,y,z,i,nx,j\n1,2,3,0,0,1\n", 1, "twice"),
        ("x,y,z,i,k\n1,2,3,0,1\n", 1, "missing"),
        ("x,y,z,k\n1,2,3,1\n", 1, "missing"),
        ("1 2 3 4\n", 1, "4 columns"),
        ("1 2 3 4 5 6 7\n", 1, "7 columns"),
        ("1\n2\n", 1, "header"),
        ("Some words\n1 2 3\n", 1, "header"),
        ("1 2 3\nx y z\n4 5 6\n", 2, "no number"),
        ("1.5,abc,3\n", 1, "'abc' is no number"),
        # units
        ("x [um],y [um]\n1,2\n", 1, "only mm and inch"),
        ("x [mm],y [inch]\n1,2\n", 1, "different units"),
        # normals
        ("x,y,z,i,j,k\n1,2,3,0,0,1\n1,2,3,0,0,0\n", 3, "length zero"),
        ("x,y,z,i,j,k\n1,2,3,0,0,1.02\n", 2, "length 1.02"),
        ("x,y,z,i,j,k\n1,2,3,0,0,nan\n", 2, "no measured value"),
        # other things
        ("<?xml version='1.0'?>\n<a/>", None, "XML"),
        ("<!DOCTYPE html><html>", None, "XML"),
        ("\n<QIFDocument versionQIF='3.0.0'>\n", None, "XML"),
        ("%PDF-1.7\n", None, "PDF"),
        (b"PK\x03\x04\x14\x00\x06\x00", None, "ZIP"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(50), None, "Excel"),
        (b"\x1f\x8b\x08\x00", None, "gzip"),
        (b"\x89PNG\r\n\x1a\n", None, "PNG"),
        ("ISO-10303-21;\nHEADER;\n", None, "STEP"),
        ("%\nG21 G90\nG1 X1 Y2 F100\nM2\n%\n", 1, "header"),
        ('{"points": [[1, 2, 3]]}', 1, "header"),
        (b"x,y,z\n1,2,3\n\x00\x01\x02\n", 3, "binary"),
        (b"x,y,z\n1,2,\x81\n", 2, "binary"),
        ("x,y,z\n1.5,2,3\n".encode("utf-16")[:-1], None, "truncated"),
        (bytes(range(256)) * 40, None, "."),
        (b"\xff" * 100, None, "."),
        ("x" * 100_000, 1, "characters"),
    ],
)
def test_refused_with_place_and_reason(points_file, content, line, says):
    path = points_file(content)
    with pytest.raises(FormatError, match=says) as caught:
        contact(path)
    assert caught.value.file == str(path)
    if line is not None:
        assert caught.value.line == line
        assert str(caught.value).startswith(f"{path}:{line}: ")
    assert "\n" not in str(caught.value)


def test_a_file_that_ends_in_mid_number(points_file):
    rows = [f"{k}.125,{k}.250,{k}.500" for k in range(40)]
    whole = "x,y,z\n" + "\n".join(rows)
    assert len(contact(points_file(whole))) == 40
    for cut in (1, 2):
        with pytest.raises(FormatError, match="cut off") as caught:
            contact(points_file(whole[:-cut]))
        assert caught.value.line == 41
    # Numbers of different length are no sign of anything.
    free = "x,y,z\n" + "\n".join(f"1,2,{k / 8!r}" for k in range(41))
    assert len(contact(points_file(free))) == 41


def test_what_is_no_file(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (tmp_path / "missing.csv", tmp_path, pipe, "a\0b"):
        with pytest.raises(FormatError):
            contact(path)


# --- properties -------------------------------------------------------------------------------------------

finite = st.floats(-1e5, 1e5, allow_nan=False)


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    rows=st.lists(st.tuples(finite, finite, finite, st.floats(0, 6.28)), min_size=1, max_size=30),
    has_z=st.booleans(),
    normals=st.booleans(),
    ball=st.sampled_from([0.0, 1.5]),
)
def test_written_and_read_back(tmp_path, rows, has_z, normals, ball):
    table = np.array(rows)
    points = table[:, :3].copy()
    if not has_z:
        points[:, 2] = 0.0
    n = np.stack([np.cos(table[:, 3]), np.sin(table[:, 3]), np.zeros(len(table))], axis=1)
    lines = np.arange(1, len(table) + 1)
    m = Measurement(points, n if normals else None, ball, lines, "here", "0" * 64, has_z)
    path = text.write(tmp_path / "out.csv", m, comments=["simulated part"])
    back = read(path, points="centre" if ball else "contact", probe_radius=ball or None)
    np.testing.assert_allclose(back.points, points, atol=0.6e-9)
    assert back.has_z == has_z and back.ball_radius == ball
    if normals:
        np.testing.assert_allclose(back.normals, n, atol=1e-11)
    else:
        assert back.normals is None
    assert path.read_text().startswith("# simulated part\n")
    assert list(tmp_path.iterdir()) == [path]


@settings(max_examples=examples(300), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(content=st.binary(max_size=200))
def test_any_bytes_end_in_points_or_a_format_error(tmp_path, content):
    path = tmp_path / "any"
    path.write_bytes(content)
    try:
        m = contact(path)
    except UsageError:
        assert readers.recognised(content) != "text"
    except FormatError as error:
        assert error.file == str(path)
    else:
        assert len(m) and np.isfinite(m.points).all()


@settings(max_examples=examples(500), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(content=st.text(alphabet="xyzij,;\t .\n\r#/-+0123456789eE\"[]*%nainf'", max_size=80), header=st.booleans())
def test_any_text_ends_in_points_or_a_format_error(tmp_path, content, header):
    path = tmp_path / "any"
    path.write_text(("x,y,z\n" if header else "") + content, newline="")
    try:
        m = contact(path)
    except MillcorrError as error:
        assert isinstance(error, FormatError)
    else:
        assert len(m) and np.isfinite(m.points).all()
        assert (np.diff(m.lines) > 0).all()


@settings(max_examples=examples(200), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    rows=st.lists(st.tuples(finite, finite, finite), min_size=1, max_size=8),
    blank=st.lists(st.integers(0, 8), max_size=3),
    separator=st.sampled_from([",", ";", "\t", " "]),
    comma=st.booleans(),
    ending=st.sampled_from(["\n", "\r\n", "\r"]),
    header=st.booleans(),
    encoding=st.sampled_from(["utf-8", "utf-16", "cp1252"]),
)
def test_whole_and_line_by_line_agree(tmp_path, rows, blank, separator, comma, ending, header, encoding):
    comma = comma and separator != ","
    lines = [separator.join(f"{v:.5f}" for v in row) for row in rows]
    if comma:
        lines = [line.replace(".", ",") for line in lines]
    for b in blank:
        lines.insert(min(b, len(lines)), "")
    if header:
        lines.insert(0, separator.join("xyz"))
    path = tmp_path / "any"
    path.write_bytes((ending.join(lines) + ending).encode(encoding))
    m = contact(path)
    np.testing.assert_allclose(m.points, np.array(rows), atol=0.51e-5)
    layout = text.find_layout("\n".join(lines) + "\n", "any")
    slow, numbers = text._read_lines("\n".join(lines) + "\n", layout, "any")
    np.testing.assert_array_equal(slow, m.points)
    np.testing.assert_array_equal(numbers, m.lines)
    np.testing.assert_array_equal(numbers, [i for i, v in enumerate(lines, 1) if v][header:])


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
@pytest.mark.parametrize("separator", [",", ";", " "])
def test_bytes_and_text_give_the_same(points_file, monkeypatch, ending, separator):
    # Also where the first block is taken from the bytes and a later one needs the text.
    rows = [f"{k}.5 {-k}.125 4.0 0.6 -0.8 0.0".replace(" ", separator) for k in range(2000)]
    header = separator.join("xyzijk")
    for extra in ("", "# remark", "1e2 2 3 0 1 0".replace(" ", separator), '"5.5" 6 7 0 1 0'.replace(" ", separator)):
        lines = [header, *rows[:1500], extra, *rows[1500:], ""]
        m = contact(points_file(ending.join(lines)))
        monkeypatch.setattr(text, "_rows_of_bytes", lambda source: None)
        slow = contact(points_file(ending.join(lines)))
        monkeypatch.undo()
        np.testing.assert_array_equal(m.points, slow.points)
        np.testing.assert_array_equal(m.normals, slow.normals)
        np.testing.assert_array_equal(m.lines, slow.lines)
        assert len(m) == 2000 + (extra[:1] in '15"' and bool(extra))


@pytest.mark.thorough
def test_a_million_lines(tmp_path):
    rng = np.random.default_rng(1)
    values = np.round(rng.uniform(-300, 300, (1_000_000, 3)), 4)
    body = "\n".join(map("%.4f,%.4f,%.4f".__mod__, map(tuple, values.tolist())))
    path = tmp_path / "big.csv"
    path.write_text(f"x,y,z\n{body}\n")
    start = time.perf_counter()
    m = contact(path)
    took = time.perf_counter() - start
    np.testing.assert_array_equal(m.points, values)
    assert m.lines[-1] == 1_000_001
    start = time.perf_counter()
    np.loadtxt(path, delimiter=",", skiprows=1)
    assert took < 8 * (time.perf_counter() - start) + 0.5


def test_known_transform_lays_points_normals_and_nominal_into_the_work_frame(tmp_path):
    path = tmp_path / "turned.csv"
    path.write_text("x,y,z,i,j,k\n110,250,7,0,1,0\n90,200,5,-1,0,0\n")
    m = readers.read(path, points="contact", work_offset=(100.0, 200.0, 5.0), work_rotation=90.0)
    # Work x runs along the file's y, work y against the file's x.
    np.testing.assert_array_equal(m.points, [[50.0, -10.0, 2.0], [0.0, 10.0, 0.0]])
    np.testing.assert_array_equal(m.normals, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    assert "X100 Y200 Z5, turned by 90 deg" in m.notes[-1]


@pytest.mark.parametrize("angle", [math.inf, math.nan])
def test_rotation_of_the_work_frame_must_be_an_angle(tmp_path, angle):
    path = tmp_path / "points.csv"
    path.write_text("x,y,z\n1,2,3\n")
    with pytest.raises(UsageError, match="--work-rotation"):
        readers.read(path, points="contact", work_rotation=angle)


@pytest.mark.parametrize(
    "content",
    [
        "Id,X Actual,Y Actual\n0,1.0,-0.02\n",
        "X-Ist\tY-Ist\tZ-Ist\n1.0\t-0.02\t-2.5\n",
        "1 1.0 -0.02 -2.5\n2 2.5 -0.02 -2.5\n",
    ],
)
def test_columns_that_a_mapping_would_explain(tmp_path, content):
    path = tmp_path / "points.csv"
    path.write_text(content)
    with pytest.raises(FormatError, match="--mapping FILE.toml"):
        readers.read(path, points="contact")


def test_a_calibration_that_text_cannot_keep_is_not_dropped(tmp_path):
    points = np.arange(6.0).reshape(2, 3)
    measurement = Measurement(points, None, 3.0, np.array([1, 2]), "centres.log", "")
    written = tmp_path / "centres.csv"
    turns = np.arange(4) * math.pi / 2
    for probe, lost in (
        (Probe(3.0, offset=(0.02, 0.0), source="ball.toml"), "offset"),
        (
            Probe(3.0, directions=turns, radii=np.array([3.0, 3.004, 3.0, 2.996]), source="ball.toml"),
            "radii by direction",
        ),
    ):
        with pytest.raises(UsageError, match=f"cannot keep the {lost} of ball.toml.*--probe with the written file"):
            text.write(written, replace(measurement, probe=probe))
        assert not written.exists()
    text.write(written, replace(measurement, probe=Probe(3.0)))
    assert readers.read(written, points="centre", probe_radius=3.0).points.tolist() == points.tolist()


def test_content_is_looked_at_before_what_a_format_says(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y,z\n1,2,3\n")
    for name, says in (("linuxcnc", "1 numbers where X Y Z"), ("grbl", "no probe report")):
        with pytest.raises(FormatError, match=says):
            readers.read(path, points="contact", format=name)


PLACES = [(10.25, 20.5, -3.0), (12.5, 20.75, -3.0), (14.0, 21.125, -3.0)]


def columns(first, width, separator, mark=".", quote=""):
    """Rows of what is in the first column and the first `width` coordinates of each place."""
    places = [[f"{v:.4f}".replace(".", mark) for v in place[:width]] for place in PLACES]
    rows = [[str(head), *place] for head, place in zip(first, places, strict=True)]
    return "".join(separator.join(f"{quote}{field}{quote}" for field in row) + "\n" for row in rows)


@pytest.mark.parametrize("first", [(1, 2, 3), (0, 1, 2), (17, 18, 19), ("P0", "P1", "P2"), ("P 5", "P 6", "7a")])
@pytest.mark.parametrize("width", [2, 3])
@pytest.mark.parametrize(
    ("separator", "mark", "quote"), [(",", ".", ""), (";", ",", '"'), ("\t", ".", ""), (" ", ".", "")]
)
def test_numbers_and_names_before_the_columns(tmp_path, first, width, separator, mark, quote):
    if separator == " " and first[0] == "P 5":
        first = ("P5", "P6", "7a")
    path = tmp_path / "points.txt"
    path.write_text(columns(first, width, separator, mark, quote))
    m = readers.read(path, points="contact")
    np.testing.assert_array_equal(m.points[:, :width], np.array(PLACES)[:, :width])
    assert m.has_z == (width == 3)
    named = isinstance(first[0], str)
    assert m.elements == (first if named else None)
    assert m.notes == (
        f"no header: the first column {'holds words' if named else f'counts up from {first[0]}'}: the points' "
        f"{'names' if named else 'numbers'}, then {'x y z' if width == 3 else 'x y'}; a header says otherwise",
    )
    seen = preview(path.read_bytes(), path.name)
    if not quote:
        assert seen.columns == dict(zip("xyz"[:width], range(2, 2 + width), strict=True))


@pytest.mark.parametrize(
    "content",
    [
        # No decimals beside: places on a grid of 1 mm are places.
        "1 10 20\n2 10 20\n3 10 20\n",
        # Steps that are not 1, decimals, or too few.
        "10 10.5 20.5\n20 10.5 20.5\n30 10.5 20.5\n",
        "1.0 10.5 20.5\n2.0 10.5 20.5\n3.0 10.5 20.5\n",
        "1 10.5 20.5\n2 10.5 20.5\n",
        "3 10.5 20.5\n2 10.5 20.5\n1 10.5 20.5\n",
        "# x y z\n1 10.5 20.5\n2 10.5 20.5\n3 10.5 20.5\n",
    ],
)
def test_a_first_coordinate_is_no_number_of_a_point(tmp_path, content):
    path = tmp_path / "points.txt"
    path.write_text(content)
    m = readers.read(path, points="contact")
    assert m.has_z and m.notes == () and m.points[0, 0] == float(content.replace("# x y z\n", "").split()[0])


@pytest.mark.parametrize(
    "content",
    [
        "nan 1.5 2.5 3.5\nnan 1.5 2.5 3.5\n",
        "**** 1.5 2.5 3.5\n**** 1.5 2.5 3.5\n",
        "P0 1.5 2.5 3.5\n2 1.5 2.5 3.5\n",
        "P0 1.5 2.5 3.5\nP1 1.5 2.5\n",
        "P0 1.5 2.5 3.5\nP1 1.5 2.5 x\n",
        "P0 1.5 2.5 3.5\n",
        "P0 1.5 2.5 3.5 0.1\nP1 1.5 2.5 3.5 0.1\n",
        "Date 1.5 2.5\n1.5 2.5 3.5\n",
    ],
)
def test_words_that_are_no_names_are_refused(tmp_path, content):
    path = tmp_path / "points.txt"
    path.write_text(content)
    with pytest.raises(FormatError):
        readers.read(path, points="contact")


def test_a_row_that_is_made_otherwise_far_below_names_its_line(tmp_path):
    path = tmp_path / "points.txt"
    path.write_text("".join(f"P{k};1,5;2,5;3,5\n" for k in range(1500)) + "P1500;1,5;2,5\n")
    with pytest.raises(FormatError, match="3 columns where 4") as caught:
        readers.read(path, points="contact")
    assert caught.value.line == 1501


def test_a_solid_that_is_no_mesh_is_text(tmp_path):
    path = tmp_path / "points.txt"
    path.write_text("# solid\nx,y\n1,2\n")
    assert len(readers.read(path, points="contact")) == 1


@pytest.mark.parametrize(
    ("content", "wanted"),
    [
        ("Nr;X ist;Y ist;Z ist\nP1;1,5;2,5;3,5\nP2;1,5;3,5;3,5\n", [1.5, 2.5, 3.5]),
        ("Report 7\nName\tXm\tYm\tDev\nP1\t1.5\t2.5\t0.1\nP2\t1.5\t3.5\t0.1\n", None),
        ("Name\tXm\tYm\tDev\nP1\t1.5\t2.5\t0.1\nP2\t1.5\t3.5\t0.1\n", [1.5, 2.5, 0.0]),
        ("a b c\n1.5 2.5 3.5\n1.5 3.5 3.5\n", [1.5, 2.5, 3.5]),
        ("1.5;2.5;3.5;4.5\n1.5;3.5;3.5;4.5\n", [1.5, 2.5, 3.5]),
    ],
)
def test_a_refused_table_is_told_with_the_mapping_that_reads_it(tmp_path, content, wanted):
    path, mapping = tmp_path / "table.txt", tmp_path / "table.toml"
    path.write_text(content)
    with pytest.raises(FormatError) as caught:
        readers.read(path, points="contact")
    _, _, lines = str(caught.value).partition("a mapping for it: ")
    assert (not lines) == (wanted is None)
    if wanted is not None:
        # A header of letters is one line that is no row.
        skip = "" if content[0].isdigit() else "skip = 1\n"
        mapping.write_text(skip + lines.replace(" | ", "\n") + "\n")
        m = readers.read(path, points="contact", mapping=mapping)
        assert m.points[0].tolist() == wanted and len(m) == 2
