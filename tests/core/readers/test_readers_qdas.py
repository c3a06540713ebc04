# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.__main__ import main
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.sweeps import examples

PART = files.ellipse(5)
CENTRES = {"points": "centre", "probe_radius": 1.5}


@pytest.fixture
def dfq(tmp_path):
    def make(content, name="part.dfq"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


@settings(max_examples=examples(80), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    lines=st.booleans(),
    names=st.sampled_from(
        ["{}.X", "{}_X", "{} X", "{}X", "X {}", "X_{}", "{}.X-Wert", "X-Wert {}", "Point/{}:X value"]
    ),
    key=st.sampled_from([2001, 2002]),
    inch=st.booleans(),
    has_z=st.booleans(),
    nominal=st.booleans(),
    ending=st.sampled_from(["\n", "\r\n", "\r"]),
    encoding=st.sampled_from(["utf-8", "utf-16", "cp1252"]),
    seed=st.integers(0, 99),
)
def test_written_and_read_back(tmp_path, seed, encoding, **dress):
    part = files.ellipse(5, seed=seed)
    path = tmp_path / "any.dfq"
    path.write_bytes(files.qdas([part], **dress).encode(encoding))
    m = readers.read(path, **CENTRES)
    assert m.format == "qdas" and m.has_z == dress["has_z"] and m.unit == ("inch" if dress["inch"] else "mm")
    flat = [1, 1, dress["has_z"]]
    np.testing.assert_allclose(m.points, part.centres * flat, atol=2e-8)
    if dress["nominal"]:
        np.testing.assert_allclose(m.nominal, part.nominal * flat, atol=2e-8)
    else:
        assert m.nominal is None
    assert [e.removeprefix("Point/") for e in m.elements] == list(part.names) and m.ball_radius == 1.5
    assert "1 characteristics are no coordinate" in m.notes[0]


@pytest.mark.parametrize("lines", [False, True])
def test_several_measured_parts_are_chosen_by_number(dfq, capsys, lines):
    several = [files.ellipse(5, seed=k) for k in range(3)]
    path = dfq(files.qdas(several, lines=lines))
    with pytest.raises(UsageError, match=r"holds 3 measured parts \(1 to 3: part '4711'\): say which with --part N"):
        readers.read(path, **CENTRES)
    for k, part in enumerate(several, 1):
        m = readers.read(path, part=k, **CENTRES)
        np.testing.assert_allclose(m.points, part.centres, atol=1e-9)
        assert m.notes[0] == f"measured part {k}"
    for k in (0, 4):
        with pytest.raises(UsageError, match="counted from 1"):
            readers.read(path, part=k, **CENTRES)
    assert main(["inspect", str(path), "--points", "contact", "--part", "2"]) == 0
    assert "measured part 2" in capsys.readouterr().out


def test_parts_of_their_own_characteristics(dfq):
    def block(part, first, values):
        fields = [f"K1001/{part} P{part}"]
        for index, (axis, value) in enumerate(zip("XYXY", values, strict=True), first):
            fields += [f"K2001/{index} A{1 + (index - first) // 2}.{axis}", f"K0001/{index} {value}"]
        return "\n".join(fields) + "\n"

    path = dfq("K0100 8\n" + block(1, 1, (1, 2, 3, 4)) + block(2, 5, (5, 6, 7, 8)))
    assert readers.read(path, points="contact", part=1).points[:, :2].tolist() == [[1, 2], [3, 4]]
    second = readers.read(path, points="contact", part=2)
    assert second.points[:, :2].tolist() == [[5, 6], [7, 8]] and second.elements == ("A1", "A2")
    with pytest.raises(UsageError, match="1: part 'P1'; 2: part 'P2'"):
        readers.read(path, points="contact")


def test_part_is_for_files_of_several_parts(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("x,y\n1,2\n")
    with pytest.raises(UsageError, match="holds one measured part"):
        readers.read(path, points="contact", part=1)


def test_points_that_were_not_measured(dfq):
    whole = files.qdas([PART], lines=True)
    value = f"{PART.centres[0, 1]:.9f}"
    for damaged in (f"{value}\x14255", "\x140"):
        m = readers.read(dfq(whole.replace(f"{value}\x140", damaged)), **CENTRES)
        assert len(m) == 4 and m.elements[0] == "P2" and "1 points were not measured" in m.notes[-1]


def test_decimal_commas_and_lines(dfq):
    m = readers.read(dfq("K0100 2\nK2002/1 A X\nK2002/2 A Y\n\n1,5\x0f-2,25\n"), points="contact")
    assert m.points.tolist() == [[1.5, -2.25, 0]] and m.lines.tolist() == [5]


HEAD = "K0100 2\nK2001/1 A.X\nK2001/2 A.Y\n"


@pytest.mark.parametrize(
    ("content", "line", "says"),
    [
        ("K0100 2\nK2001/1 Diameter\nK2001/2 Length\nK0001/1 1\nK0001/2 2\n", None, "such as P1.X"),
        ("K0100 2\nK2001/1 A.X\nK2001/2 A.Z\nK0001/1 1\nK0001/2 2\n", None, "such as P1.X"),
        ("K0100 3\nK2001/1 A.X\nK2001/2 A.Y\nK0001/1 1\nK0001/2 2\n", 1, "cut off"),
        ("K0100 none\nK0100 2\nK2001/1 A.X\n", 1, "no number of characteristics"),
        (HEAD, None, "no values"),
        (HEAD + "1.5\n", 4, "1 values for 2"),
        (HEAD + "1.5\x0f2\x0f3\n", 4, "3 values for 2"),
        (HEAD + "1.5\x0fabc\n", 4, "'abc' is no number"),
        (HEAD + "K0001/1 nan\n", 4, "no measured value"),
        (HEAD + "K0001/1 1e999\n", 4, "too large"),
        (HEAD + "K0001/1 9e9\nK0001/2 1\n", 4, "no length"),
        (HEAD + "K0001/3 1\n", 4, "characteristic 3"),
        (HEAD + "KA\n", 4, "neither"),
        (HEAD + "K0001/1 1\n", 3, "Y of point 'A' has 0 of 1 values"),
        (HEAD + "K2001/1 B.X\n", 4, "twice"),
        (HEAD.replace("A.Y", "A.X") + "1\x0f2\n", 3, "X of point 'A' is there twice"),
        (HEAD + "K2142/1 µm\n1\x0f2\n", 2, "only mm and inch"),
        (HEAD + "K2142/1 mm\nK2142/2 inch\n1\x0f2\n", 3, "in mm and in inch"),
        (HEAD + "K2101/1 x\n1\x0f2\n", 4, "no number"),
        (
            "K0100 5\nK2001/1 A.X\nK2001/2 A.Y\nK2001/3 A.Z\nK2001/4 B.X\nK2001/5 B.Y\n1\x0f2\x0f3\x0f4\x0f5\n",
            5,
            "'B' has no Z",
        ),
    ],
)
def test_refused_with_place_and_reason(dfq, content, line, says):
    path = dfq(content)
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(path, points="contact")
    assert caught.value.line == line and caught.value.file == str(path)


def test_the_file_does_not_say_what_its_points_are(dfq):
    with pytest.raises(UsageError, match="say --points"):
        readers.read(dfq(files.qdas([PART])))
