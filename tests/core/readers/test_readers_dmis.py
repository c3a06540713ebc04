# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.sweeps import examples

OUTPUT = """DMISMN/'PLATE',05.2
UNITS/MM,ANGDEC
PRCOMP/ON
F(PT1)=FEAT/POINT,CART,10,0,-5,1,0,0
FA(PT1)=FEAT/POINT,CART,10.03,0,-5,1,0,0
F(PT2)=FEAT/POINT,CART,0,10,-5,0,1,0
FA(PT2)=FEAT/POINT,CART,0,9.96,-5,0,1,0
ENDFIL
"""


@pytest.fixture
def output_file(tmp_path):
    def make(content, name="part.dmo"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


def test_two_points(output_file):
    m = readers.read(output_file(OUTPUT))
    assert m.format == "dmis" and m.unit == "mm" and m.ball_radius == 0 and m.notes == ()
    np.testing.assert_array_equal(m.points, [[10.03, 0, -5], [0, 9.96, -5]])
    np.testing.assert_array_equal(m.nominal, [[10, 0, -5], [0, 10, -5]])
    np.testing.assert_array_equal(m.normals, [[1, 0, 0], [0, 1, 0]])
    np.testing.assert_array_equal(m.lines, [5, 7])
    np.testing.assert_allclose(m.from_nominal(), [0.03, -0.04], atol=1e-14)
    assert m.elements == ("PT1", "PT2")


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.lower(),
        lambda t: t.replace(",", " , ").replace("FA(PT1)=", "FA( PT1 ) = "),
        lambda t: t.replace("10.03,", "10.03,$\n   "),
        lambda t: t.replace("F(PT1)", "$$ F(PT1)=FEAT/POINT,CART,9,9,9,9,9,9\nF(PT1)"),
        lambda t: t.replace("\n", "\r\n"),
        lambda t: t.replace("CART,10.03,0", "POL,10.03,0"),
        lambda t: t.replace("10.03", "1.003D+01"),
        lambda t: t.replace("FEAT/POINT,CART,10,0,-5,1,0,0", "FEAT/EDGEPT,CART,10,0,-5,1,0,0,0,0,1"),
        lambda t: t + "FA(PT1)=FEAT/POINT,CART,10.03,0,-5,1,0,0\n",
        lambda t: t.replace("PRCOMP/ON", "PRCOMP/ON\nTEXT/OPER,'a, b / c'\nIF/(1)\nSNSLCT/S(1)"),
    ],
)
def test_dresses_of_the_same_points(output_file, change):
    m = readers.read(output_file(change(OUTPUT)))
    assert m.format == "dmis"
    np.testing.assert_allclose(m.points, [[10.03, 0, -5], [0, 9.96, -5]], atol=1e-14)
    np.testing.assert_allclose(m.from_nominal(), [0.03, -0.04], atol=1e-14)


def test_polar_coordinates_in_every_plane(output_file):
    for plane, place in (("XYPLAN", [0, 10, 3]), ("YZPLAN", [3, 0, 10]), ("ZXPLAN", [10, 3, 0])):
        m = readers.read(output_file(f"UNITS/MM,ANGDEC\nPRCOMP/ON\nWKPLAN/{plane}\nFA(P)=FEAT/POINT,POL,10,90,3\n"))
        np.testing.assert_allclose(m.points, [place], atol=1e-14)
    for unit, angle in (("ANGDEC", "-30.5"), ("ANGRAD", repr(float(np.radians(-30.5)))), ("ANGDMS", "-30:30:0")):
        m = readers.read(output_file(f"UNITS/MM,{unit}\nPRCOMP/ON\nFA(P)=FEAT/POINT,POL,10,{angle},3\n"))
        np.testing.assert_allclose(m.points[0, 1], -10 * np.sin(np.radians(30.5)), atol=1e-14)


def test_curves(output_file):
    part = files.ellipse(5)
    m = readers.read(output_file(files.dmis(part, curve=True)))
    np.testing.assert_allclose(m.points, part.contact, atol=1e-11)
    np.testing.assert_allclose(m.nominal, part.nominal, atol=1e-11)
    assert m.elements[:2] == ("CURVE.1", "CURVE.2") and m.notes == ("measured features left out: 1 circle",)


def test_what_pairs_and_what_does_not(output_file):
    text = OUTPUT.replace("F(PT1)=FEAT/POINT,CART,10,0,-5,1,0,0\n", "F(PT9)=FEAT/POINT,CART,1,1,1,1,0,0\n")
    m = readers.read(output_file(text))
    assert np.isnan(m.nominal[0]).all() and m.nominal[1].tolist() == [0, 10, -5]
    assert m.notes == ("1 nominal points were not measured",)
    m = readers.read(output_file(OUTPUT.replace(",1,0,0", "")))
    assert m.normals is None and "1 of 2 points have no normal" in m.notes[0]


def test_compensation(output_file):
    path = output_file(OUTPUT.replace("ON", "OFF"))
    with pytest.raises(UsageError, match="--probe-radius"):
        readers.read(path)
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(path, points="contact")
    assert readers.read(path, probe_radius=1.5).ball_radius == 1.5
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(output_file(OUTPUT), points="centre", probe_radius=1.0)
    path = output_file(OUTPUT.replace("PRCOMP/ON\n", ""))
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)
    assert readers.read(path, points="contact").ball_radius == 0


def test_units(output_file):
    assert readers.read(output_file(OUTPUT.replace("MM", "INCH"))).points[0, 0] == pytest.approx(10.03 * 25.4)
    path = output_file(OUTPUT.replace("UNITS/MM,ANGDEC\n", ""))
    with pytest.raises(UsageError, match="--units"):
        readers.read(path)
    assert readers.read(path, units="mm").points[0, 0] == 10.03
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(output_file(OUTPUT), units="inch")


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("10.03,0,-5,1,0,0", "10.03,0", 5, "2 numbers"),
        ("10.03,0,-5,1,0,0", "10.03,0,-5,1", 5, "4 numbers"),
        ("10.03", "10,03", 5, "7 numbers"),
        ("10.03", "x", 5, "'X' is no number"),
        ("10.03", "nan", 5, "no number"),
        ("10.03", "1e999", 5, "no length"),
        ("10.03", "", 5, "'' is no number"),
        ("FA(PT1)=FEAT/POINT,CART", "FA(PT1)=FEAT/POINT", 5, "neither CART nor POL"),
        ("FA(PT1)=", "FA(PT1)", 5, "no whole statement"),
        ("FA(PT2)", "FA(PT1)", 7, "lies elsewhere than in line 5"),
        ("F(PT1)=FEAT/POINT,CART,10,0,-5,1,0,0", "F(PT1)=FEAT/POINT,CART,10,0,-5,1,1,0", 5, "length 1.41"),
        ("UNITS/MM", "UNITS/CM", 2, "only MM and INCH"),
        ("F(PT2)", "UNITS/INCH\nF(PT2)", 6, "unit changes"),
        ("F(PT2)", "PRCOMP/OFF\nF(PT2)", 6, "compensation changes"),
        ("F(PT2)", "PTDATA/CART,1,2,3\nF(PT2)", 6, "without a curve"),
        ("PRCOMP/ON", "WKPLAN/AB", 3, "not known"),
        ("ENDFIL\n", "FA(P9)=FEAT/POINT,CART,1,$", 8, "cut off"),
        ("FA(", "TA(", None, "no measured points"),
    ],
)
def test_refused_with_the_line(output_file, old, new, line, says):
    assert old in OUTPUT
    text = OUTPUT.replace(old, new) if line is None else OUTPUT.replace(old, new, 1)
    path = output_file(text)
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(path)
    assert caught.value.file == str(path) and caught.value.line == line


def test_a_program_is_no_result(output_file):
    program = (
        "DMISMN/'P',05.2\nUNITS/MM,ANGDEC\nF(P1)=FEAT/POINT,CART,1,2,3,0,0,1\nMEAS/POINT,F(P1),1\nENDMES\nENDFIL\n"
    )
    with pytest.raises(FormatError, match="no measured points FA"):
        readers.read(output_file(program), points="contact")


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(2, 7),
    seed=st.integers(0, 99),
    inch=st.booleans(),
    polar=st.sampled_from(["", "ANGDEC", "ANGRAD", "ANGDMS"]),
    curve=st.booleans(),
    continued=st.booleans(),
    prcomp=st.sampled_from(["ON", "OFF"]),
)
def test_written_and_read_back(tmp_path, n, seed, prcomp, **dress):
    part = files.ellipse(n, seed=seed)
    path = tmp_path / "round.dmo"
    path.write_text(files.dmis(part, prcomp=prcomp, **dress))
    m = readers.read(path, probe_radius=part.radius if prcomp == "OFF" else None)
    np.testing.assert_allclose(m.points, part.centres if prcomp == "OFF" else part.contact, atol=1e-9)
    np.testing.assert_allclose(m.nominal, part.nominal, atol=1e-9)
    np.testing.assert_allclose(m.from_nominal(), part.deviations, atol=1e-9)
    assert m.unit == ("inch" if dress["inch"] else "mm")


def test_what_is_left_out_is_noted(tmp_path):
    path = tmp_path / "part.dmo"
    point = "FA(P1)=FEAT/POINT,CART,1.0,2.0,3.0\n"
    path.write_text("UNITS/MM\nPRCOMP/ON\n" + point + "ENDFIL\n")
    assert readers.read(path).notes == ()
    path.write_text("UNITS/MM\nPRCOMP/ON\n" + point + point)
    assert readers.read(path).notes == (
        "no ENDFIL: points may be missing at the end of the file", "1 repetitions of points left out: they are equal",
    )  # fmt: skip
