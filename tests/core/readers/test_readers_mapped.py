# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text files whose columns a mapping explains."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.__main__ import main
from millcorr.errors import FormatError, UsageError
from millcorr.readers import mapping as mappings
from millcorr.readers.mapping import COLUMNS, TextMapping
from tests.core import measurement_files as files
from tests.core.sweeps import examples

REPOSITORY = Path(__file__).resolve().parents[3]
READY = sorted((REPOSITORY / "resources" / "mappings").glob("*.toml"))
XYZ = {"x": "x", "y": "y", "z": "z"}
NUMBERED = {"x": 1, "y": 2, "z": 3}
CONTACT = [[30.012, 0, -4], [0, 20.0085, -4], [-29.993, 0, -4], [0, -20.011, -4]]
DEVIATIONS = [0.012, 0.0085, -0.007, 0.011]


@pytest.fixture
def read(tmp_path):
    """Function that writes content to a file and reads it by a mapping of these keys."""

    def make(content, options=None, **keys):
        path = tmp_path / "points.txt"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        keys = {"columns": XYZ, "points": "contact"} | keys
        return readers.read(path, mapping=TextMapping(**keys), **(options or {}))

    return make


@pytest.fixture
def toml(tmp_path):
    def make(content):
        path = tmp_path / "layout.toml"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


# --- ready mappings ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("layout", READY, ids=lambda p: p.stem)
def test_ready_mappings_read_their_examples(layout):
    mapping = mappings.load(layout)
    options = {} if mapping.points == "contact" else {"points": "contact"}
    centres = mapping.points == "centre"
    if centres:
        options = {"probe_radius": 1.0}
    m = readers.read(layout.parent / "examples" / f"{layout.stem}.txt", mapping=layout, **options)
    assert len(m) == 4 and m.format == "mapped" and m.unit == "mm" and m.elements is not None
    assert mapping.name in m.notes[0]
    wanted = np.array(CONTACT)
    if centres:
        wanted[:, :2] += m.ball_radius * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
    np.testing.assert_array_equal(m.points, wanted)
    if m.normals is not None:
        np.testing.assert_allclose(m.from_nominal(), DEVIATIONS, atol=1e-12)
        np.testing.assert_allclose(m.stated, DEVIATIONS, atol=1e-12)
    elif not centres:
        np.testing.assert_array_equal(m.nominal[0], [30, 0, -4])


def test_there_is_a_mapping_for_each_program_named_in_the_documentation():
    page = (REPOSITORY / "docs" / "formats" / "mapped.md").read_text(encoding="utf-8")
    assert len(READY) == 5 and all(p.name in page for p in READY)


# --- what is accepted -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "keys"),
    [
        ("x,y,z\n1.5,2,3\n4,5,6.25\n", {}),
        ("Z|Y|X\n3|2|1.5\n6.25|5|4\n", {"separator": "|"}),
        ("report\n\nno x y z\n 1 1.5 2 3\n 2 4 5 6.25\n", {"separator": "blank"}),
        ("1.5\t2\t3\n4\t5\t6.25\n", {"separator": "tab", "columns": {"x": 1, "y": 2, "z": 3}}),
        ("A\n# B\n1,5;2;3\n4;5;6,25\n", {"columns": NUMBERED, "skip": 1, "decimal": "comma", "separator": ";"}),
        ("x y z\n[mm] [mm] [mm]\n1.5 2 3\n4 5 6.25\n", {"separator": "blank", "skip": 2}),
        ("x,y,z\nx,y,z\n1.5,2,3\n4,5,6.25\n", {"header": 2}),
        ("x,y,z\n1.5,2,3\n4,5,6.25\n7,8\nEND,1\n", {"end": "7,"}),
        ("x,y,z\n1.5,2,3 % one\n% two\n4,5,6.25,,\n", {"comments": ("%",)}),
        ('"x";"y";"z";"note"\n"1,5";2;3;"a;b"\n4;5;"6,25";""\n', {"separator": "semicolon", "decimal": "comma"}),
        ("f,x,y,z\npoint,1.5,2,3\nplane,1\nPOINT,4,5,6.25\nmean\n", {"only": {"F": ("Point",)}}),
        ("f,x,y,z\npoint,1.5,2,3\nplane,1\nEdge,4,5,6.25\n", {"only": {"1": ("Point", "edge")}}),
        ("x,y,z\r1.5,2,3\r4,5,6.25\r", {}),
        ("\ufeffx,y,z\n1.5,2,3\n4,5,6.25\n".encode("utf-16"), {}),
        ("Größe,x,y,z\nä,1.5,2,3\nö,4,5,6.25\n".encode("cp1252"), {}),
        ("# x,y,z\n1.5,2,3\n4,5,6.25\n", {}),
        ("x,y,z\n1.5e0,2.,3\n4,.5E1,6.25\n", {}),
    ],
)  # fmt: skip
def test_one_table_in_many_dresses(read, content, keys):
    m = read(content, **keys)
    np.testing.assert_array_equal(m.points, [[1.5, 2, 3], [4, 5, 6.25]])
    assert m.normals is None and m.ball_radius == 0 and m.has_z


def test_lines_names_and_gaps(read):
    content = "#\nid,x,y,z,i,j,k,a,b,c,d\nP1,1,2,3,1,0,0,1,2,3,\n\nP 2,4,5,6,0,1,0,,,,0.5\n"
    places = "x y z i j k nominal_x nominal_y nominal_z deviation".split()
    columns = {"id": "ID", **dict(zip(places, "x y z i j k a b c d".split(), strict=True))}
    m = read(content, columns=columns)
    assert m.elements == ("P1", "P 2")
    np.testing.assert_array_equal(m.lines, [3, 5])
    np.testing.assert_array_equal(m.nominal, [[1, 2, 3], [np.nan] * 3])
    np.testing.assert_array_equal(m.stated, [np.nan, 0.5])
    assert m.origin(1).endswith("points.txt:5 (P 2)")


def test_inch_and_ball(read):
    m = read("x,y\n1,2\n", columns={"x": 1, "y": 2}, skip=1, units="inch", points="centre", probe_radius=1.5)
    np.testing.assert_allclose(m.points, [[25.4, 50.8, 0]], rtol=1e-15)
    assert m.ball_radius == 1.5 and not m.has_z and m.unit == "inch"


def test_what_the_caller_must_say_and_must_not(read):
    with pytest.raises(UsageError, match="say --points"):
        read("x,y,z\n1,2,3\n", points=None)
    with pytest.raises(UsageError, match="need --probe-radius"):
        read("x,y,z\n1,2,3\n", points="centre")
    assert read("x,y,z\n1,2,3\n", {"probe_radius": 2.0}, points="centre").ball_radius == 2
    for options in ({"points": "contact"}, {"probe_radius": 1.0}, {"units": "inch"}):
        with pytest.raises(UsageError, match="contradicts the mapping"):
            read("x,y,z\n1,2,3\n", options, points="centre", probe_radius=2.0, units="mm")
    with pytest.raises(UsageError, match="leave --format text out"):
        read("x,y,z\n1,2,3\n", {"format": "text"})


def test_encoding(read):
    m = read("größe,x,y,z\nä,1.5,2,3\n".encode("cp850"), encoding="cp850", columns=XYZ | {"id": "Größe"})
    assert m.elements == ("ä",)


# --- what is refused --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "keys", "line", "says"),
    [
        ("", {}, None, "empty"),
        ("x,y,z\n", {}, 1, "no points"),
        ("x,y,z\n# 1\n", {}, 1, "no points"),
        ("x,y\n1,2\n", {}, 1, "all columns.*'z'"),
        ("a,b\n1,2\n", {}, None, "all columns"),
        ("a,b\nx,y\n1,2\n", {"header": 1}, 1, "does not name"),
        ("a,b\n", {"header": 7}, None, "ends before line 7"),
        ("x,y,z,X\n1,2,3,4\n", {}, 1, "two columns are named 'x'"),
        ("x,y,z\n1,2,3\n4,5\n", {}, 3, "cut off"),
        ("x,y,z\n1,2,3\n4,5,6,7\n", {}, 3, "4 columns"),
        ("x,y,z\n1,,3\n", {}, 2, "missing"),
        ("x,y,z\n1,2,NaN\n", {}, 2, "no measured value"),
        ("x,y,z\n1,2,1e999\n", {}, 2, "too large"),
        ("x,y,z\n1,2,3e7\n", {}, 2, "no length"),
        ("x;y;z\n1,5;2;3\n", {"separator": ";"}, 2, "the mapping says decimal = 'point'"),
        ("x;y;z\n1.5;2;3\n", {"separator": ";", "decimal": "comma"}, 2, "the mapping says decimal = 'comma'"),
        ("x;y;z\n1,5;2;3\n262.018;1;2\n", {"separator": ";", "decimal": "comma"}, 3, "spreadsheet"),
        ("x;y;z\n1.262,5;2;3\n", {"separator": ";", "decimal": "comma"}, 2, "no number"),
        ("x y z\n1 2 12.05.2023\n", {"separator": "blank"}, 2, "date"),
        ("1 2 3\n", {"columns": {"x": 1, "y": 2, "z": 4}, "separator": "blank"}, 1, "takes column 4"),
        ("f,x,y,z\nplane,1,2,3\n", {"only": {"f": ("point",)}}, None, "no row holds 'point'.*'plane'"),
        ("x,y,z,i,j,k\n1,2,3,0,0,0\n", {"columns": {**XYZ, "i": 4, "j": 5, "k": 6}}, 2, "length zero"),
        ("x,y,z\n1,2,3\n", {"encoding": "utf-32"}, None, "no text in utf-32"),
        (b"\xff\x00\x01" * 9, {}, None, "."),
        ("x,y,z\n1,2," + "3" * 30_000, {}, 2, "characters"),
        ("x,y,z\n" + "\n".join(["1.25,2.25,3.25"] * 40)[:-1], {}, 41, "cut off"),
    ],
)
def test_refused_with_place_and_reason(read, content, keys, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        read(content, **keys)
    assert caught.value.file and caught.value.file.endswith("points.txt")
    if line is not None:
        assert caught.value.line == line
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("", "columns.* is missing"),
        ("seperator = 'tab'\n[columns]\nx=1\ny=2", "'seperator' is no key.*did you mean separator"),
        ("qqq = 1\n[columns]\nx=1\ny=2", "'qqq' is no key.*a mapping has columns"),
        ("columns = 3", "columns is a table"),
        ("[columns]\nx = 1", "y is missing"),
        ("[columns]\nx = 1\ny = 2\nw = 3", "'w' is none of"),
        ("[columns]\nx = 1\ny = 0", "columns.y is a name"),
        ("[columns]\nx = 1\ny = true", "columns.y is a name"),
        ("[columns]\nx = 1\ny = ' '", "columns.y is a name"),
        ("[columns]\nx = 'A'\ny = 'a'", "two are the same"),
        ("[columns]\nx = 1\ny = 2\ni = 3", "j is missing"),
        ("[columns]\nx = 1\ny = 2\nk = 3", "i is missing"),
        ("[columns]\nx = 1\ny = 2\nnominal_z = 3", "nominal_x is missing"),
        ("[columns]\nx = 1\ny = 2\nz = 3\nnominal_x = 4\nnominal_y = 5", "go together"),
        ("separator = 'x'\n[columns]\nx=1\ny=2", "separator is comma"),
        ("separator = 1\n[columns]\nx=1\ny=2", "separator is comma"),
        ("decimal = ','\n[columns]\nx=1\ny=2", "decimal is point or comma"),
        ("decimal = 'comma'\n[columns]\nx=1\ny=2", "cannot both"),
        ("header = 0\n[columns]\nx=1\ny=2", "header is the number"),
        ("header = '1'\n[columns]\nx=1\ny=2", "header is the number"),
        ("skip = -1\n[columns]\nx=1\ny=2", "skip is a number"),
        ("end = 1\n[columns]\nx=1\ny=2", "end is a text"),
        ("comments = '#'\n[columns]\nx=1\ny=2", "comments is a list"),
        ("comments = ['']\n[columns]\nx=1\ny=2", "comments is a list"),
        ("encoding = 'klingon'\n[columns]\nx=1\ny=2", "encoding is the name"),
        ("encoding = 'base64'\n[columns]\nx=1\ny=2", "encoding is the name"),
        ("units = 'cm'\n[columns]\nx=1\ny=2", "units is mm or inch"),
        ("points = 'ball'\n[columns]\nx=1\ny=2", "points is contact or centre"),
        ("probe_radius = -1.0\n[columns]\nx=1\ny=2", "probe_radius is the radius"),
        ("probe_radius = nan\n[columns]\nx=1\ny=2", "probe_radius is the radius"),
        ("points = 'contact'\nprobe_radius = 1\n[columns]\nx=1\ny=2", "contact points need none"),
        ("only = 1\n[columns]\nx=1\ny=2", "only is a table"),
        ("[columns]\nx=1\ny=2\n[only]\nF = 3", "'F' is a text"),
        ("[columns]\nx=1\ny=2\n[only]\nF = []", "'F' is a text"),
        ("[columns]\nx=1\ny=2\n[only]\n0 = 'a'", "'0' is no column"),
        ("[columns\n", "no TOML"),
        (b"\xff\xfe", "UTF-8"),
    ],
)
def test_a_wrong_mapping_names_file_and_key(toml, content, says):
    path = toml(content)
    with pytest.raises(FormatError, match=says) as caught:
        mappings.load(path)
    assert caught.value.file == str(path) and "\n" not in str(caught.value)


def test_a_mapping_that_is_not_there(tmp_path):
    for path in (tmp_path / "missing.toml", tmp_path):
        with pytest.raises(FormatError):
            mappings.load(path)


# --- command line -----------------------------------------------------------------------------------------


def test_inspect_and_convert_by_a_mapping(toml, tmp_path, capsys):
    layout = toml("separator = 'semicolon'\npoints = 'contact'\n[columns]\nx = 2\ny = 1\n")
    file, out = tmp_path / "points.txt", tmp_path / "points.csv"
    file.write_text("1;2\n3;4\n")
    assert main(["inspect", str(file), "--mapping", str(layout)]) == 0
    assert "format      mapped" in capsys.readouterr().out
    assert main(["convert", str(file), "--mapping", str(layout), "-o", str(out)]) == 0
    assert readers.read(out, points="contact").points.tolist() == [[2, 1, 0], [4, 3, 0]]
    capsys.readouterr()
    layout.write_text("[columns]\nx = 2\n")
    assert main(["inspect", str(file), "--mapping", str(layout)]) == 3
    said = capsys.readouterr().err
    assert "layout.toml: columns: y is missing" in said and said.count("\n") == 1


# --- properties -------------------------------------------------------------------------------------------

texts = st.text(st.characters(exclude_characters="\r\n", exclude_categories=["Cs"]), min_size=1, max_size=8)
labels = texts.filter(lambda t: t.strip() and not t.isdecimal())


@settings(max_examples=examples(200), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(data=st.data())
def test_saved_and_loaded_again(tmp_path, data):
    draw = data.draw
    names = draw(st.lists(labels, min_size=12, max_size=12, unique_by=lambda t: t.strip().casefold()))
    columns = dict(zip(COLUMNS, names, strict=False)) | draw(st.sampled_from([{}, {"x": 1, "y": 12}]))
    mapping = TextMapping(
        columns=columns,
        separator=draw(st.sampled_from(["comma", "semicolon", "tab", "blank", "|", "\\"])),
        header=draw(st.none() | st.integers(1, 99)),
        skip=draw(st.integers(0, 99)),
        end=draw(texts | st.just("")),
        comments=tuple(draw(st.lists(labels, max_size=3))),
        encoding=draw(st.sampled_from([None, "cp850", "latin-1"])),
        units=draw(st.sampled_from([None, "mm", "inch"])),
        points=draw(st.sampled_from([None, "centre"])),
        probe_radius=draw(st.none() | st.floats(0.1, 10)),
        only=draw(st.dictionaries(labels, st.lists(texts, min_size=1, max_size=3).map(tuple), max_size=2)),
        name=draw(texts | st.just("")),
    )
    path = mappings.save(tmp_path / "any.toml", mapping)
    assert mappings.load(path) == mapping and mappings.load(path).source == str(path)


@settings(max_examples=examples(150), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    order=st.permutations([*COLUMNS, "-"]),
    separator=st.sampled_from(["comma", "semicolon", "tab", "blank", "|"]),
    comma=st.booleans(),
    named=st.booleans(),
    encoding=st.sampled_from(["utf-8", "utf-16", "cp1252", "utf-8-sig"]),
    ending=st.sampled_from(["\n", "\r\n", "\r"]),
    inch=st.booleans(),
    seed=st.integers(0, 99),
)  # fmt: skip
def test_written_and_read_back(tmp_path, order, separator, comma, named, encoding, ending, inch, seed):
    comma = comma and separator != "comma"
    part = files.ellipse(5, seed=seed)
    content, mapping = files.mapped(part, order, separator=separator, comma=comma, named=named, inch=inch)
    path = tmp_path / "any.txt"
    path.write_bytes(content.replace("\n", ending).encode(encoding))
    m = readers.read(path, mapping=TextMapping(**mapping))
    np.testing.assert_allclose(m.points, part.centres, atol=1e-7)
    np.testing.assert_allclose(m.normals, part.normals, atol=1e-7)
    np.testing.assert_allclose(m.nominal, part.nominal, atol=1e-7)
    np.testing.assert_allclose(m.stated, part.deviations, atol=1e-7)
    assert m.elements == part.names and m.ball_radius == part.radius


@settings(max_examples=examples(100), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    rows=st.lists(st.tuples(*[st.floats(-1e5, 1e5)] * 3), min_size=1, max_size=9), separator=st.sampled_from("|;,\t")
)
def test_whole_and_line_by_line_agree(tmp_path, rows, separator):
    path = tmp_path / "any.txt"
    names = {"\t": "tab"}
    keys = {"columns": {"x": 2, "y": 1, "z": 3}, "points": "contact", "separator": names.get(separator, separator)}
    body = "".join(separator.join(f"{v!r}" for v in row) + "\n" for row in rows)
    path.write_text(body)
    whole = readers.read(path, mapping=TextMapping(**keys))
    path.write_text(body + "# behind\n")
    slow = readers.read(path, mapping=TextMapping(**keys))
    np.testing.assert_array_equal(whole.points, slow.points)
    np.testing.assert_array_equal(whole.lines, slow.lines)
    np.testing.assert_array_equal(whole.points, np.array(rows)[:, [1, 0, 2]])


@pytest.mark.parametrize("seed", range(4))
def test_damaged_files_end_in_points_or_an_error(tmp_path, seed):
    generator = random.Random(seed)
    order = ["id", "x", "y", "z", "i", "j", "k", "nominal_x", "nominal_y", "nominal_z", "deviation"]
    content, keys = files.mapped(
        files.ellipse(6), order, separator="semicolon", comma=seed % 2 == 0, named=seed < 2, inch=False
    )
    layout = tmp_path / "layout.toml"
    plain = mappings.save(layout, TextMapping(**keys)).read_bytes()
    outcomes = {"points": 0, "error": 0, "mapping": 0}
    path = tmp_path / "any.txt"
    for _ in range(200):
        path.write_bytes(files.damaged(content.encode(), generator))
        spoilt = generator.random() < 0.3
        layout.write_bytes(files.damaged(plain, generator) if spoilt else plain)
        try:
            m = readers.read(path, mapping=layout)
        except (FormatError, UsageError) as error:
            assert "\n" not in str(error)
            outcomes["mapping" if spoilt else "error"] += 1
        else:
            assert len(m) and np.isfinite(m.points).all()
            outcomes["points"] += 1
    assert min(outcomes.values()) > 10


def test_a_column_that_is_not_there_names_the_mapping_and_the_nearest(tmp_path):
    (tmp_path / "cam.toml").write_text(
        'separator = "comma"\npoints = "contact"\n[columns]\nx = "X Act"\ny = "Y Actual"\n'
    )
    path = tmp_path / "meas.csv"
    path.write_text("Id,X Actual,Y Actual\n0,1.0,2.0\n")
    with pytest.raises(FormatError, match=r"cam.toml; lacking: 'X Act' \(is it 'X Actual'\?\)") as caught:
        readers.read(path, mapping=tmp_path / "cam.toml")
    assert caught.value.line == 1


@pytest.mark.parametrize(
    ("plane", "expected"),
    [
        ("xy", (1.0, 2.0, 3.0)), ("xz", (1.0, 3.0, -2.0)), ("yz", (2.0, 3.0, 1.0)), ("zx", (3.0, 1.0, 2.0)),
        ("zy", (3.0, 2.0, -1.0)), ("yx", (2.0, 1.0, -3.0)),
    ],
)  # fmt: skip
def test_the_plane_of_a_contour_instrument_becomes_that_of_the_contour(tmp_path, plane, expected):
    path = tmp_path / "profile.txt"
    columns = {c: n for n, c in enumerate(("x", "y", "z", "i", "j", "k"), 1)}
    path.write_text("1000 2000 3000 0.6 0 0.8\n4000 5000 6000 0 1 0\n")
    mapping = TextMapping(columns, separator="blank", factor=0.001, plane=plane, points="contact")
    m = readers.read(path, mapping=mapping)
    np.testing.assert_allclose(m.points[0], expected, atol=1e-15)
    # Turned and not mirrored: the triple product of the points and a normal is kept.
    before = np.linalg.det([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [0.6, 0.0, 0.8]])
    assert np.linalg.det([*m.points, m.normals[0]]) == pytest.approx(before)
    assert m.unit == "mm" and "unit of 0.001 mm" in m.notes[1]


def test_a_profile_has_two_columns_and_comes_out_at_one_level(tmp_path):
    path, said = tmp_path / "profile.txt", tmp_path / "instrument.toml"
    path.write_text("X [um];Z [um]\n0,5;-12,25\n1,0;-12,75\n")
    said.write_text(
        'separator = "semicolon"\ndecimal = "comma"\nfactor = 0.001\nplane = "xz"\npoints = "contact"\n'
        '[columns]\nx = "X [um]"\nz = "Z [um]"\n'
    )
    m = readers.read(path, mapping=said)
    np.testing.assert_allclose(m.points, [[0.0005, -0.01225, 0.0], [0.001, -0.01275, 0.0]], atol=1e-18)
    assert not m.has_z and m.bases["unit"].how == "said"
    loaded = mappings.load(said)
    assert mappings.load(mappings.save(tmp_path / "again.toml", loaded)) == loaded
    with pytest.raises(UsageError, match="mm"):
        readers.read(path, mapping=said, units="inch")


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"plane": "xz"}, "columns: z is missing"), ({"plane": "xx"}, "plane is one of"),
        ({"factor": 0.0}, "factor is the millimetres"), ({"factor": 0.001, "units": "mm"}, "the same twice"),
    ],
)  # fmt: skip
def test_a_plane_or_factor_that_cannot_be(keys, message):
    with pytest.raises(FormatError, match=message):
        TextMapping({"x": 1, "y": 2}, **keys)
