# SPDX-License-Identifier: LGPL-2.1-or-later
"""Logs of probing on the machine: LinuxCNC, GRBL, DPRNT, Renishaw."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from millcorr.plausibility import examine_file
from tests.core import measurement_files as files
from tests.core.sweeps import examples

PART = files.ellipse(4)


@pytest.fixture
def log_file(tmp_path):
    def make(content, name="probe.log"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


# --- LinuxCNC ---------------------------------------------------------------------------------------------


def test_linuxcnc(log_file):
    path = log_file(files.linuxcnc(PART))
    m = readers.read(path, probe_radius=1.5)
    assert m.format == "linuxcnc" and m.ball_radius == 1.5 and m.unit == "mm" and m.normals is None
    np.testing.assert_allclose(m.points, PART.centres, atol=1e-9)
    np.testing.assert_array_equal(m.lines, [1, 2, 3, 4])
    inches = readers.read(log_file(files.linuxcnc(PART, inch=True)), probe_radius=1.5, units="inch")
    np.testing.assert_allclose(inches.points, PART.centres, atol=2e-5)
    with pytest.raises(UsageError, match="--probe-radius"):
        readers.read(path)
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(path, points="contact")


def test_linuxcnc_other_axes(log_file):
    m = readers.read(log_file(files.linuxcnc(PART, others=(0, 0, 90, 0, 0, 0))), probe_radius=1.5)
    assert m.notes == ("other axes stood at C90",)
    rows = files.linuxcnc(PART).splitlines()
    rows[2] = rows[2].replace(" 0.000000 0.000000", " 0.000000 5.000000", 1)
    with pytest.raises(FormatError, match="axis B moved") as caught:
        readers.read(log_file("\n".join(rows)), probe_radius=1.5)
    assert caught.value.line == 3


@pytest.mark.parametrize(
    ("row", "says"),
    [("1.0 2.0 3.0", "3 numbers"), ("1.0 2.0 nan 0.0 0.0 0.0 0.0 0.0 0.0", "'nan' is no coordinate"),
     ("1.0 2.0 3.0 0.0 0.0 0.0 0.0 0.0", "8 numbers"), ("1e300 2.0 3.0 0.0 0.0 0.0 0.0 0.0 0.0", "no length")],
)  # fmt: skip
def test_linuxcnc_refused_with_the_line(log_file, row, says):
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(log_file(files.linuxcnc(PART) + row + "\n"), probe_radius=1.5)
    assert caught.value.line == 5


# --- GRBL -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "dress",
    [
        {"wco": True, "offset": (-100.0, -50.0, 5.0)},
        {"stored": True, "offset": (-100.0, -50.0, 5.0)},
        {"wco": True, "offset": (-100.0, -50.0, 5.0), "axes": 4},
        {"wco": True, "offset": (-254.0, -50.8, 25.4), "inch": True},
    ],
)
def test_grbl_with_the_offset_in_the_log(log_file, dress):
    path = log_file(files.grbl(PART, **dress))
    m = readers.read(path, probe_radius=1.5)
    assert m.format == "grbl" and m.ball_radius == 1.5 and m.unit == ("inch" if dress.get("inch") else "mm")
    np.testing.assert_allclose(m.points, PART.centres, atol=2e-5)
    assert "machine frame" in m.notes[0]
    assert len(readers.read(path, probe_radius=1.5, work_offset=dress["offset"])) == 4
    with pytest.raises(UsageError, match="--work-offset contradicts"):
        readers.read(path, probe_radius=1.5, work_offset=(0.0, 0.0, 0.0))


def test_grbl_without_the_offset(log_file):
    offset = (-100.0, -50.0, 5.0)
    path = log_file("".join(f"{line}\n" for line in files.grbl(PART, offset=offset).splitlines() if "PRB" in line))
    with pytest.raises(UsageError, match="--work-offset"):
        readers.read(path, probe_radius=1.5)
    m = readers.read(path, probe_radius=1.5, work_offset=offset)
    np.testing.assert_allclose(m.points, PART.centres, atol=1e-6)
    with pytest.raises(UsageError, match="--probe-radius"):
        readers.read(path, work_offset=offset)


def test_grbl_the_latest_offset_counts(log_file):
    log = "[PRB:1,2,3:1]\n<Idle|MPos:0,0,0|WCO:1,0,0>\n[PRB:1,2,3.5:1]\n<Idle|WCO:2,0,0|FS:0,0>\n[PRB:1,2,3:1]\n"
    m = readers.read(log_file(log), probe_radius=1)
    np.testing.assert_array_equal(m.points[:, 0], [0, 0, -1])


def test_grbl_repeats_of_the_last_touch_are_not_touches(log_file):
    log = "[PRB:1,2,3:1]\n[G54:0,0,0]\n[G92:0,0,0]\n[TLO:0]\n[PRB:1,2,3:1]\nok\n[PRB:4,2,3:1]\n"
    m = readers.read(log_file(log), probe_radius=1)
    np.testing.assert_array_equal(m.lines, [1, 7])


@pytest.mark.parametrize(
    ("line", "says"),
    [("[PRB:1.000,2.000,3.000:0]", "failed"), ("[PRB:1.000,2.000:1]", "damaged"), ("[PRB:1.000,2.000,3.0", "damaged"),
     ("[PRB:nan,2.000,3.000:1]", "damaged"), ("[PRB:1e9,2,3:1]", "damaged"),
     ("[PRB:9999999999,2,3:1]", "no length")],
)  # fmt: skip
def test_grbl_refused_with_the_line(log_file, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(log_file(f"$H\n[PRB:1,1,1:1]\n{line}\n"), probe_radius=1, work_offset=(0, 0, 0))
    assert caught.value.line == 3


# --- two touches of one place ------------------------------------------------------------------------------

LOGS = {
    "grbl": lambda part: files.grbl(part, wco=True),
    "grbl in inches": lambda part: files.grbl(part, wco=True, inch=True),
    "linuxcnc": files.linuxcnc,
}


def touched_twice(part, fast=0.3, once=()):
    """The part with a fast touch, that far into the material, before each slow one but those of the places `once`."""
    centres = []
    for k, (centre, normal) in enumerate(zip(part.centres, part.normals, strict=True)):
        centres += [centre] if k in once else [centre - fast * normal, centre]
    return replace(part, centres=np.array(centres))


@pytest.mark.parametrize("once", [(), (0, 3, 11)])
@pytest.mark.parametrize("kind", LOGS)
def test_of_two_touches_of_a_place_the_slow_one_counts(log_file, kind, once):
    part = files.ellipse(12)
    path = log_file(LOGS[kind](touched_twice(part, once=once)))
    m = readers.read(path, probe_radius=1.5)
    np.testing.assert_allclose(m.points, part.centres, atol=6e-5)
    assert f"{12 - len(once)} places touched twice: the second" in m.notes[-1]
    first = readers.read(log_file(LOGS[kind](part), "once"), probe_radius=1.5)
    assert len(first) == 12 and not any("twice" in note for note in first.notes)


@pytest.mark.parametrize("kind", LOGS)
def test_several_parts_of_places_touched_twice(log_file, kind):
    parts = [files.ellipse(12, seed=seed) for seed in (1, 2)]
    path = log_file("".join(LOGS[kind](touched_twice(part)) for part in parts))
    for number, part in enumerate(parts, 1):
        m = readers.read(path, probe_radius=1.5, part=number)
        np.testing.assert_allclose(m.points, part.centres, atol=6e-5)


@pytest.mark.parametrize(
    "along",
    [
        np.arange(30) * 0.4,
        # Fine in a corner only; and fine everywhere but for one step.
        np.cumsum(np.r_[np.full(10, 2.0), np.full(6, 0.3), np.full(10, 2.0)]),
        np.cumsum(np.r_[np.full(10, 0.3), 4.0, np.full(10, 0.3)]),
        # Three touches of each place: which of them measures is not known.
        (np.arange(12) * 3.0).repeat(3) + np.tile([0.0, 0.1, 0.05], 12),
        # A few places touched again.
        np.arange(12) * 3.0 + np.tile([0.0, -2.7, 0.0, 0.0], 3),
    ],
)
def test_points_in_short_steps_all_stay(log_file, along):
    part = files.ellipse(4)
    row = replace(part, centres=np.column_stack([along, np.zeros((len(along), 2))]))
    assert len(readers.read(log_file(files.linuxcnc(row)), probe_radius=1.5)) == len(along)


# --- height maps -------------------------------------------------------------------------------------------

HEIGHTS = np.array([[0.01, 0.02, -0.03], [0.04, 0.05, 0.06]])


@pytest.mark.parametrize("write", [files.bcnc, files.open_cnc_pilot])
def test_height_maps(log_file, write):
    path = log_file(write(HEIGHTS))
    m = readers.read(path)
    grid = {(x, y): HEIGHTS[j, i] for i, x in enumerate((0.0, 15.0, 30.0)) for j, y in enumerate((-5.0, 20.0))}
    assert {(x, y): z for x, y, z in m.points.tolist()} == grid
    assert m.format == "height-map" and m.ball_radius == 0 and "nothing of a contour" in m.notes[0]
    (finding,) = [f for f in examine_file(m) if f.name == "height-map"]
    assert finding.dangerous
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(path, points="centre", probe_radius=1.0)


def test_a_height_map_that_is_not_whole(log_file):
    lines = files.bcnc(HEIGHTS).splitlines()
    m = readers.read(log_file("\n".join(lines[:-1]) + "\n"))
    assert len(m) == 5 and m.notes[1] == "1 of 6 places were not touched"
    with pytest.raises(FormatError, match="where the grid has X15 Y-5") as caught:
        readers.read(log_file("\n".join([*lines[:6], *lines[7:]]) + "\n"))
    assert caught.value.line == 7
    for old, new, says in (('Y="1"', 'Y="2"', "not on the grid"), ("0.0400", "x", "no coordinate"),
                           ('SizeX="3"', 'SizeX="1"', "no grid"), ('MinX="0"', "", "no coordinate")):  # fmt: skip
        with pytest.raises(FormatError, match=says):
            readers.read(log_file(files.open_cnc_pilot(HEIGHTS).replace(old, new, 1)))


def test_columns_that_only_begin_like_a_map(log_file):
    assert readers.read(log_file("0 10 2\n0 20 2\n-5 1 50\n1 0 0.01\n"), points="contact").format == "text"


# --- DPRNT ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("normals", [False, True])
@pytest.mark.parametrize("number", [False, True])
@pytest.mark.parametrize("ending", ["\r", "\n", "\r\n"])
@pytest.mark.parametrize("heads", [False, True])
def test_dprnt(log_file, normals, number, ending, heads):
    path = log_file(files.dprnt(PART, normals=normals, number=number, ending=ending, heads=heads))
    m = readers.read(path, points="contact")
    assert m.format == "dprnt" and m.has_z
    np.testing.assert_allclose(m.points, PART.contact, atol=1e-4)
    assert (m.normals is not None) == normals and m.elements == (("N1", "N2", "N3", "N4") if number else None)
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)


def test_dprnt_without_z(log_file):
    m = readers.read(log_file("X  1.5Y  -2.\nX- 1.5Y2.5 I1J0\n"), points="contact")
    np.testing.assert_array_equal(m.points, [[1.5, -2, 0], [-1.5, 2.5, 0]])
    assert not m.has_z and m.normals is None and "1 of 2" in m.notes[0]


@pytest.mark.parametrize(
    ("line", "says"),
    [("X1.Z3.", "Y is missing"), ("X1.Y2.X3.", "twice"), ("X1.Y2.", "Z stands in some"), ("X1.Y2,5 Z3.", "no word"),
     ("X1.Y2.Z***", "no word"), ("G1 X1.Y2.Z3.", "no word"), ("X1.Y2.Z" + "9" * 20, "no coordinate")],
)  # fmt: skip
def test_dprnt_refused_with_the_line(log_file, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(log_file(f"X1.Y2.Z3.\nX1.Y3.Z3.\n{line}\n"), points="contact", format="dprnt")
    assert caught.value.line == 3


@pytest.mark.parametrize("program", ["%\nG21 G90\nG1 X1 Y2 F100\nM2\n%\n", "G0 X1 Y1\nX2 Y2\n", "N10 G1 X1 Y2\n"])
def test_nc_programs_are_no_measurements(log_file, program):
    assert readers.recognised(program.encode()) == "text"
    with pytest.raises(FormatError):
        readers.read(log_file(program), points="contact")


# --- Renishaw ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("tight", [False, True])
@pytest.mark.parametrize("has_z", [False, True])
def test_renishaw(log_file, tight, has_z):
    path = log_file(files.renishaw(PART, tight=tight, has_z=has_z))
    m = readers.read(path, points="contact")
    assert m.format == "renishaw" and m.has_z == has_z and m.elements == ("12.1", "12.2", "12.3", "12.4")
    axes = 3 if has_z else 2
    np.testing.assert_allclose(m.points[:, :axes], PART.contact[:, :axes], atol=1e-4)
    np.testing.assert_allclose(m.nominal[:, :axes], PART.nominal[:, :axes], atol=1e-4)
    assert "one axis only, as feature 12.901" in m.notes[0] and "1 features with a size" in m.notes[1]
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)


def test_results_of_inspection_and_of_probing_cycles(log_file):
    m = readers.read(log_file(files.mixed_results(PART)))
    assert m.format == "msr" and len(m) == 4 and m.ball_radius == PART.radius
    np.testing.assert_allclose(m.points, PART.centres, atol=6e-5)
    assert m.notes == ("5 features of probing cycles left out: COMPONENT, SIZE and POSN blocks",)
    whole = files.mixed_results(PART)
    with pytest.raises(FormatError, match="no line of an MSR file"):
        readers.read(log_file(whole.replace("SIZE D12.", "SI2E D12."), "spoilt"))


def test_results_of_probing_cycles_alone(log_file):
    path = log_file(files.mixed_results(PART, inspected=False))
    m = readers.read(path, points="contact")
    assert m.format == "renishaw" and m.elements == ("1.4",)
    np.testing.assert_array_equal(m.points, [[1.0101, 1.9899, 0.0]])
    assert any("1 features have an axis that was not measured (ACTUAL NaN)" in note for note in m.notes)
    with pytest.raises(FormatError, match="DEV is not ACTUAL"):
        readers.read(log_file(path.read_text().replace("-0.010127", "-0.010327")), points="contact")


@pytest.mark.parametrize("measured", [False, True])
def test_results_without_an_inspected_point_say_so(log_file, measured):
    path = log_file(files.mixed_results(PART, inspected=False, measured=measured))
    only = ", only 5 features of probing cycles" if measured else ""
    with pytest.raises(FormatError, match=f"no measured points G800 and G801 in the file{only}: "):
        readers.read(path, format="msr")
    if not measured:
        assert readers.recognised(path.read_bytes()) == "msr" == readers.recognised(b"START\r\nEND\r\n")


FEATURE = """COMPONENT NO 1 FEATURE NO 2
POSN X 10.0000 ACTUAL 10.0300 TOL 0.1000 DEV 0.0300
POSN Y 5.0000 ACTUAL 4.9900 TOL 0.1000 DEV -0.0100
"""


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("DEV 0.0300", "DEV 0.3000", 2, "DEV is not"),
        ("ACTUAL 10.0300", "ACTUAL 10.O300", 2, "no whole POSN"),
        ("ACTUAL 10.0300", "ACTUAL ******", 2, "no whole POSN"),
        ("POSN Y", "POSN X", 3, "twice"),
        ("POSN Y", "POSN Z", 1, "none of 1 features"),
        ("-0.0100\n", "-0.0100\n" + FEATURE, 4, "twice"),
        (
            "-0.0100\n",
            "-0.0100\n" + FEATURE.replace("NO 2", "NO 3") + "POSN Z 1.0 ACTUAL 1.0 DEV 0.0\n",
            1,
            "no POSN Z",
        ),
    ],
)
def test_renishaw_refused_with_the_line(log_file, old, new, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(log_file(FEATURE.replace(old, new, 1)), points="contact")
    assert caught.value.line == line


# --- round trips ------------------------------------------------------------------------------------------


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(1, 9),
    seed=st.integers(0, 99),
    kind=st.sampled_from(["linuxcnc", "grbl", "dprnt", "renishaw"]),
    inch=st.booleans(),
    offset=st.tuples(*[st.integers(-500, 500).map(float)] * 3),
)
def test_written_and_read_back(tmp_path, n, seed, kind, inch, offset):
    part = files.ellipse(n, seed=seed)
    path = tmp_path / "round"
    if kind in ("dprnt", "renishaw"):
        path.write_text(files.dprnt(part) if kind == "dprnt" else files.renishaw(part), newline="")
        m = readers.read(path, points="contact")
    elif kind == "linuxcnc":
        path.write_text(files.linuxcnc(part, inch=inch))
        m = readers.read(path, probe_radius=1.5, units="inch" if inch else "mm")
    else:
        path.write_text(files.grbl(part, offset=offset, inch=inch), newline="")
        m = readers.read(path, probe_radius=1.5, work_offset=offset)
    assert m.format == kind
    np.testing.assert_allclose(m.points, part.contact if m.ball_radius == 0 else part.centres, atol=1e-4)


@pytest.mark.parametrize(("places", "asked"), [(("-3.1250", "-1.2500"), True), (("-312.5000", "-125.0000"), False)])
def test_grbl_four_decimals_are_asked_about_only_where_they_may_be_inches(tmp_path, places, asked):
    log = tmp_path / "probe.log"
    x, y = places
    rows = [f"[PRB:{x},{y},-{1.5 + 0.01 * k:.4f}:1]" for k in range(5)]
    log.write_text("\n".join([*rows, ""]))
    said = {"probe_radius": 1.0, "work_offset": (0.0, 0.0, 0.0)}
    if asked:
        with pytest.raises(UsageError, match="--units inch or --units mm"):
            readers.read(log, **said)
        return
    m = readers.read(log, **said)
    assert m.unit == "mm" and m.bases["unit"].how == "inferred" and m.points[0, 0] == float(x)
