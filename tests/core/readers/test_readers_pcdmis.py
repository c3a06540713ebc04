# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.sweeps import examples

REPORT = """PART NAME  : PLATE
DIM LOC1= LOCATION OF POINT PNT1  UNITS=MM
AX    NOMINAL     +TOL     -TOL     MEAS      DEV   OUTTOL
X      10.000    0.100    0.100   10.030    0.030    0.000 ----#----
Y      -5.000    0.100    0.100   -5.010   -0.010    0.000 ---#-----
Z       0.000    0.100    0.100    0.000    0.000    0.000 ----#----
T       0.000    0.100    0.100    0.030    0.030    0.000 ----#----
V       1.000    0.000    0.000        -        -        -
END OF DIMENSION LOC1
"""


@pytest.fixture
def written(tmp_path):
    def make(content, name="part.txt"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode("cp1252"))
        return path

    return make


def contact(path, **options):
    return readers.read(path, points="contact", **options)


# --- XYZIJK -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("separator", [",", ", ", " ", "\t", "   "])
@pytest.mark.parametrize("inch", [False, True])
@pytest.mark.parametrize("normals", [False, True])
@pytest.mark.parametrize("names", [False, True])
def test_xyzijk(written, separator, inch, normals, names):
    part = files.ellipse(4)
    m = contact(written(files.xyzijk(part, inch=inch, normals=normals, separator=separator, names=names)))
    assert m.format == "xyzijk" and m.unit == ("inch" if inch else "mm")
    np.testing.assert_allclose(m.points, part.contact, atol=2e-8)
    np.testing.assert_array_equal(m.lines, [2, 3, 4, 5])
    assert (m.normals is not None) == normals and m.elements == (part.names if names else None)


def test_xyzijk_without_metric_is_inch(written):
    assert contact(written("XYZIJK\n1,2,3\n")).points.tolist() == [[25.4, 50.8, pytest.approx(76.2)]]
    assert contact(written("XYZIJK    METRIC\n1,2,3\n")).points.tolist() == [[1, 2, 3]]
    assert "taken for inch" in contact(written("XYZIJK\n1,2,3\n")).notes[-1]
    # Without METRIC the file says nothing: the caller may.
    said = contact(written("XYZIJK\n1,2,3\n"), units="mm")
    assert said.points.tolist() == [[1, 2, 3]] and said.unit == "mm" and not said.notes
    with pytest.raises(UsageError, match="contradicts"):
        contact(written("XYZIJK    METRIC\n1,2,3\n"), units="inch")


def test_xyzijk_metric_elsewhere_is_asked_about(written):
    path = written("XYZIJK METRIC\nPT_1\t10\t5\t0\n")
    with pytest.raises(UsageError, match="column 8"):
        contact(path)
    m = contact(path, units="mm")
    assert m.points.tolist() == [[10, 5, 0]] and m.elements == ("PT_1",)


def test_xyzijk_rows_of_all_lengths(written):
    rows = ["1,2,3", "1,2,3,9", "4,5,6,0,0", "7,8,9,0,0,1", "7,8,9,0,0,1,5", "7,8,10,0,0,1,0,0"]
    m = contact(written("\n".join(["XYZIJK    METRIC", *rows])))
    np.testing.assert_array_equal(m.points, [[1, 2, 3], [4, 5, 6], [7, 8, 9], [7, 8, 10]])
    np.testing.assert_array_equal(m.lines, [2, 4, 5, 7])
    assert m.normals is None
    assert m.notes == (
        "2 circles left out: rows of 4 or 7 numbers are no points",
        "2 of 4 points have no normal: normals are not used",
    )


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("XYZIJK    METRIC\n", 1, "no points"),
        ("XYZIJK    METRIC\n1,2,3,4\n", 1, "only circles"),
        ("XYZIJK    METRIC\n1,2\n", 2, "2 numbers"),
        ("XYZIJK    METRIC\n1,2,3\n1,2,3,4,5,6,7,8,9\n", 3, "9 numbers"),
        ("XYZIJK    METRIC\n1,2,x\n", 2, "'x' is no number"),
        ("XYZIJK    METRIC\n1,2,nan\n", 2, "no number"),
        ("XYZIJK    METRIC\n1,2,1e400\n", 2, "no length"),
        ("XYZIJK    METRIC\n#1,2,3\n", 2, "no number"),
        ("XYZIJK    METRIC\n1,2,3,1,1,1\n", 2, "length 1.73"),
        ("XYZIJK    METRIC\n1,5 2,5 3,5\n", 2, "length"),
        ("XYZIJK    INCH\n1,2,3\n", 1, "only METRIC"),
    ],
)
def test_xyzijk_refused_with_the_line(written, text, line, says):
    with pytest.raises(FormatError, match=says) as caught:
        contact(written(text))
    assert caught.value.line == line


def test_xyzijk_does_not_say_what_its_points_are(written):
    with pytest.raises(UsageError, match="--points"):
        readers.read(written("XYZIJK    METRIC\n1,2,3\n"))


# --- text report ------------------------------------------------------------------------------------------


def test_report(written):
    m = contact(written(REPORT))
    assert m.format == "pcdmis" and m.unit == "mm" and m.elements == ("PNT1",) and m.notes == ()
    np.testing.assert_array_equal(m.points, [[10.03, -5.01, 0]])
    np.testing.assert_array_equal(m.nominal, [[10, -5, 0]])
    np.testing.assert_array_equal(m.normals, [[1, 0, 0]])
    np.testing.assert_array_equal(m.lines, [2])
    np.testing.assert_allclose(m.from_nominal(), m.stated, atol=1e-12)


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("DEV", "DEVIATION").replace("MEAS", "MEASURED"),
        lambda t: t.replace("\n", "\r\n"),
        lambda t: t.replace("Y    ", f"\x0c\nPART NAME : PLATE 5°   PAGE 2\n\n{t.splitlines()[2]}\nY    "),
        lambda t: t.replace("Y    ", "PAGE 2\nY    "),
        lambda t: t.replace(".", ","),
        lambda t: t.replace("UNITS=MM", "UNITS=MM ,$\nGRAPH=OFF  TEXT=OFF  MULT=10.00  OUTPUT=BOTH"),
        lambda t: t.replace("   -0.010    0.000 ---", "    0.010    0.000 ---"),
        lambda t: t.replace("END OF DIMENSION LOC1", "DIM D2= LOCATION OF CIRCLE C1 UNITS=MM\nX 1 1 1 1 1 1"),
        lambda t: t.lower().replace("pnt1", "PNT1"),
    ],
)  # fmt: skip
def test_dresses_of_the_same_report(written, change):
    m = contact(written(change(REPORT)))
    np.testing.assert_array_equal(m.points, [[10.03, -5.01, 0]])
    assert m.elements == ("PNT1",)


def test_a_blank_bonus_column_shifts_nothing(written):
    text = files.pcdmis(files.ellipse(3), bonus=True)
    np.testing.assert_allclose(contact(written(text)).points, files.ellipse(3).contact, atol=1e-6)


def test_a_location_without_all_axes_is_no_point(written):
    lost = REPORT.replace("PNT1", "PNT2").replace("Z       0", "W       0")
    m = contact(written(REPORT + lost))
    assert len(m) == 1 and m.notes == ("1 locations left out: 'PNT2' lacks Z and is no point (line 11)",)
    with pytest.raises(FormatError, match="lacks Z and is no point") as caught:
        contact(written(lost))
    assert caught.value.line == 2


def test_the_same_point_reported_again_counts_once(written):
    assert len(contact(written(REPORT + REPORT))) == 1
    with pytest.raises(FormatError, match="lies elsewhere than in line 2") as caught:
        contact(written(REPORT + REPORT.replace("10.030    0.030", "10.040    0.040")))
    assert caught.value.line == 11


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("10.030    0.030", "10.030    0.300", 4, "DEV is not MEAS"),
        ("10.000    0.100    0.100   10.030", "10.000    0.100   10.030", 4, "DEV is not MEAS"),
        ("10.030", "1O.030", 4, "among the values"),
        ("10.030", "10,030.5", 4, "among the values"),
        ("10.030", "", 4, "DEV is not MEAS"),
        ("X      10.000", "X      ******", 4, "no row of an axis"),
        ("MEAS ", "XEAS ", 3, "no single column MEAS"),
        ("AX    NOMINAL", "", 4, "without column heads"),
        ("UNITS=MM", "UNITS=FURLONG", 2, "only MM and IN"),
        ("Y      -5", "X      -5", 5, "twice"),
        ("V       1.000    0.000", "V       2.000    0.000", 2, "length 2"),
        ("V       1.000    0.000    0.000", "V       1.000    0.000    -", 8, "three components"),
        ("LOCATION OF POINT", "LOCATION OF CIRCLE", None, "no LOCATION OF POINT"),
    ],
)
def test_report_refused_with_the_line(written, old, new, line, says):
    assert old in REPORT
    with pytest.raises(FormatError, match=says) as caught:
        contact(written(REPORT.replace(old, new, 1)), format="pcdmis")
    assert caught.value.line == line


def test_units_of_a_report(written):
    assert contact(written(REPORT.replace("UNITS=MM", "UNITS=IN"))).points[0, 0] == pytest.approx(10.03 * 25.4)
    with pytest.raises(FormatError, match="different units"):
        contact(written(REPORT + REPORT.replace("PNT1", "PNT2").replace("UNITS=MM", "UNITS=IN")))
    with pytest.raises(UsageError, match="contradicts"):
        contact(written(REPORT), units="inch")


HEAD = "AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL"
PLACES = {"PNT1": (10.03, -5.01, 0.002), "PNT2": (20.04, -6.02, 0.001), "PNT3": (30.01, -7.03, 0.003)}


def block(name, axes="XYZ", head="DIM {0}LOC= LOCATION OF POINT {0}  UNITS=MM"):
    """Lines of one dimension as reports print them, with no line at its end."""
    nominal = [round(v, 1) for v in PLACES.get(name, (1.04, 2.04, 3.04))]
    measured = PLACES.get(name, (1.04, 2.04, 3.04))
    rows = [
        f"{a}  {n:11.3f}      0.400      0.400{m:11.3f}{m - n:11.3f}      0.000 ----#----"
        for a, n, m in zip("XYZ", nominal, measured, strict=True)
        if a in axes
    ]
    return [head.format(name), HEAD, *rows]


def report(*blocks):
    return "\n".join(line for lines in blocks for line in ([lines] if isinstance(lines, str) else lines)) + "\n"


@pytest.mark.parametrize(
    "foreign",
    [
        "DIM #25A LOC12= LOCATION OF PLANE {}  UNITS=MM",
        "DIM #24B#22 LOC4= LOCATION OF CIRCLE {}  UNITS=MM",
        "DIM #27A LOC14= POSITION OF CYLINDER {}  USE AXIS=AVERAGE  REF LENGTH=0.000  UNITS=MM",
        "DIM #10 DIST1= 2D DISTANCE FROM CIRCLE {} TO CIRCLE CIR6 PAR TO   XAXIS,NO_RADIUS  UNITS=MM",
        "DIM ANGL10= 2D ANGLE TO LINE {} FROM LINE LIN3",
        "DIM LOC9= LOCATION OF CIRCLE POINT 7  UNITS=MM",
        "DIM LOC9= LAGE VON KREIS {}  UNITS=MM",
        "FCFLOC1 = POSITION OF {}      FIT TO DATUMS=ON  DEV PERPEN CENTERLINE=ON  UNITS=MM",
        "#20.1#21 LOC1 = POSITION OF {}          FIT TO DATUMS=ON  DEV PERPEN CENTERLINE=ON  UNITS=MM",
        "#100FCFPROF1 = SURFACE PROFILE OF {}  FORMANDLOCATION  UNITS=MM",
    ],
)
def test_rows_of_another_block_are_no_rows_of_the_point_before_it(written, foreign):
    # Each of these would have closed nothing, and given its X, Y or Z to the point, which lacks it or has it already.
    m = contact(written(report(block("PNT1"), block("PNT2", "XY"), block("CIR1", "XZ", foreign), block("PNT3"))))
    assert m.elements == ("PNT1", "PNT3")
    np.testing.assert_array_equal(m.points, [PLACES["PNT1"], PLACES["PNT3"]])
    assert "'PNT2' lacks Z and is no point (line 6)" in m.notes[0]


def test_names_with_blanks(written):
    text = report(
        block("PNT1", head="DIM #25A LOC12= LOCATION OF POINT {}  UNITS=MM"),
        block("PNT2", head="DIM #10,6 OP 20= LOCATION OF POINT READ {}  UNITS=MM ,$"),
        block("PNT3", head="DIM LOC 3 = LOCATION OF VECTOR POINT READ {} UNITS=MM"),
    )
    m = contact(written(text))
    assert m.elements == ("PNT1", "READ PNT2", "READ PNT3")
    np.testing.assert_array_equal(m.points, list(PLACES.values()))


PAGE = "PART NUMBER=CALIPER OF STEEL, POSITION FROM A    DATE=17-Sep-25     TIME=10:09:15 AM           PAGE#=4"


@pytest.mark.parametrize("between", [[PAGE], ["", PAGE, "", HEAD], ["SERIAL NUMBER : AKH 182", PAGE]])
def test_a_page_ends_between_two_rows(written, between):
    lines = block("PNT1")
    m = contact(written(report(lines[:3], between, lines[3:])))
    np.testing.assert_array_equal(m.points, [PLACES["PNT1"]])


@pytest.mark.parametrize("heading", [[], [HEAD]])
def test_a_line_of_no_report_among_the_rows_is_refused_with_both_lines(written, heading):
    lines = block("PNT1")
    with pytest.raises(FormatError, match=r"row of axis Y .*'Kegelrad 5' in line 4 .*'PNT1' of line 1") as caught:
        contact(written(report(lines[:3], "Kegelrad 5", heading, lines[3:])))
    assert caught.value.line == 5 + len(heading)
    # Between blocks it may stand: operators print remarks.
    assert len(contact(written(report(lines, "Kegelrad 5", block("PNT2"))))) == 2


CHANGES = ("Active alignment changed", "A2         =ALIGNMENT/START,RECALL:A1,LIST=YES", "RECALL/ALIGNMENT,INTERNAL,A2")


@pytest.mark.parametrize("change", CHANGES)
def test_alignments_are_parts_to_choose_from(written, change):
    moved = [line.replace("PNT1", "PNT3") for line in block("PNT1")]
    path = written(report("PART NAME  : ALIGNMENT PLATE", block("PNT1"), change, block("PNT2"), moved))
    with pytest.raises(UsageError, match=r"2 measured parts \(1: 1 points .*; 2: 2 points .*in line 7\)"):
        contact(path)
    assert contact(path, part=1).elements == ("PNT1",)
    second = contact(path, part=2)
    assert second.elements == ("PNT2", "PNT3") and second.notes == ("measured part 2",)
    # The same name in another frame is no contradiction.
    again = written(report(block("PNT1"), change, [line.replace("PNT2", "PNT1") for line in block("PNT2")]), "again")
    assert contact(again, part=2).points[0, 0] == PLACES["PNT2"][0]


def test_an_alignment_that_measures_no_point_is_no_part(written):
    circle = block("CIR1", head="DIM L= LOCATION OF CIRCLE {}")
    text = report(CHANGES[0], block("PNT1"), block("PNT2"), CHANGES[1], circle)
    assert len(contact(written(text))) == 2


def test_a_recalled_alignment_is_the_frame_it_was(written):
    text = report("RECALL/ALIGNMENT,INTERNAL,A1", block("PNT1"), CHANGES[2], block("PNT2"),
                  "RECALL/ALIGNMENT,INTERNAL,A1", block("PNT3"))  # fmt: skip
    assert contact(written(text), part=1).elements == ("PNT1", "PNT3")
    with pytest.raises(UsageError, match="counted from 1"):
        contact(written(text), part=3)


@pytest.mark.parametrize("change", [*CHANGES, "END OF DIMENSION LOC1", "TEMPERATURE = 20.5", "C1 =FEAT/CONTACT/CIRCLE"])
def test_a_row_behind_what_closed_its_point_is_refused_with_both_lines(written, change):
    lines = block("PNT1")
    with pytest.raises(FormatError, match=r"row of axis Z .* in line 5 closed 'PNT1' of line 1") as caught:
        contact(written(report(lines[:4], change, lines[4:], block("PNT2"))))
    assert caught.value.line == 6


def test_what_is_unknown_behind_a_whole_point_takes_its_rows_along(written):
    feature = ["C1 =FEAT/CONTACT/CIRCLE/DEFAULT,CARTESIAN,IN,LEAST_SQR", *block("CIR1", "XZ")[1:]]
    m = contact(written(report(block("PNT1"), feature, block("PNT2"))))
    np.testing.assert_array_equal(m.points, [PLACES["PNT1"], PLACES["PNT2"]])


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(1, 6),
    seed=st.integers(0, 99),
    inch=st.booleans(),
    vectors=st.booleans(),
    bonus=st.booleans(),
    pages=st.booleans(),
    comma=st.booleans(),
    blanks=st.booleans(),
    between=st.booleans(),
    ends=st.booleans(),
)
def test_report_written_and_read_back(tmp_path, n, seed, **dress):
    part = files.ellipse(n, seed=seed)
    path = tmp_path / "round.txt"
    path.write_bytes(files.pcdmis(part, **dress).encode("cp1252"))
    m = contact(path)
    np.testing.assert_allclose(m.points, part.contact, atol=2e-5)
    np.testing.assert_allclose(m.nominal, part.nominal, atol=2e-5)
    assert m.elements == part.names
    if dress["vectors"]:
        np.testing.assert_allclose(m.stated, part.deviations, atol=2e-5)
        np.testing.assert_allclose(m.from_nominal(), part.deviations, atol=5e-5)
