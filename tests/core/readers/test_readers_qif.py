# SPDX-License-Identifier: LGPL-2.1-or-later
import contextlib
import gc
import re
import time
import tracemalloc

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.sweeps import examples

PART = files.ellipse(5, decimals=None)


@pytest.fixture
def qif_file(tmp_path):
    def make(content, name="part.qif"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return make


@pytest.mark.parametrize(
    "dress",
    [
        {},
        {"version": 2},
        {"prefix": "q"},
        {"compensated": True},
        {"inch": True},
        {"inch": True, "version": 2, "compensated": True},
        {"comments": True},
        {"sets": False, "compensated": True},
        {"stated": False},
        {"version": 2, "listed": True},
        {"version": 2, "listed": True, "inch": True, "stated": False, "comments": True},
        {"version": 2, "listed": True, "compensated": True, "stated": False},
        {"listed": True, "prefix": "q", "stated": False},
    ],
)
def test_point_features(qif_file, dress):
    m = readers.read(qif_file(files.qif(PART, **dress)))
    compensated = dress.get("compensated", False)
    assert m.format == "qif" and m.unit == ("inch" if dress.get("inch") else "mm")
    assert m.ball_radius == pytest.approx(0.0 if compensated else PART.radius, abs=1e-12)
    np.testing.assert_allclose(m.points, PART.contact if compensated else PART.centres, atol=1e-12)
    np.testing.assert_allclose(m.nominal, PART.nominal, atol=1e-12)
    np.testing.assert_allclose(m.normals, PART.normals, atol=1e-12)
    np.testing.assert_allclose(m.from_nominal(), PART.deviations, atol=1e-12)
    if dress.get("stated", True):
        np.testing.assert_allclose(m.stated, PART.deviations, atol=1e-12)
    assert m.elements == PART.names


@pytest.mark.parametrize("binary", ["", "<f8", "<f4"])
@pytest.mark.parametrize("comments", [False, True])
def test_scans(qif_file, binary, comments):
    m = readers.read(qif_file(files.qif(PART, scan=True, binary=binary, comments=comments)))
    exact = 1e-5 if binary == "<f4" else 1e-14
    np.testing.assert_allclose(m.points, PART.centres, atol=exact)
    np.testing.assert_allclose(m.normals, PART.normals, atol=exact)
    assert m.ball_radius == PART.radius and m.nominal is None and m.stated is None
    assert m.elements[:2] == ("9.1", "9.2")


@pytest.mark.parametrize("kind", ["PointDefinedCurve", "Circle"])
def test_touches_in_the_feature(qif_file, kind):
    text = files.qif(PART, scan=True, version=2, listed=True, inch=True).replace("PointDefinedCurve", kind)
    path = qif_file(text)
    m = readers.read(path)
    np.testing.assert_allclose(m.points, PART.centres, atol=1e-12)
    np.testing.assert_allclose(m.normals, PART.normals, atol=1e-14)
    assert m.ball_radius == pytest.approx(PART.radius, abs=1e-12) and m.elements[1] == "of feature 8.2"
    first = text[: text.index("<MeasurePoint ")].count("\n") + 1
    assert (np.diff(m.lines) == 2).all() and m.lines[0] == first
    # What the file says is no contradiction, what it does not say is.
    assert len(readers.read(path, points="centre")) == 5
    with pytest.raises(UsageError, match="contradicts"):
        readers.read(path, points="contact")


def test_a_radius_that_only_other_touches_say(qif_file):
    text = files.qif(PART, scan=True, version=2, listed=True)
    path = qif_file(re.sub("<ProbeRadius>.*?</ProbeRadius>", "", text, count=1))
    with pytest.raises(UsageError, match="--probe-radius"):
        readers.read(path)
    assert readers.read(path, probe_radius=PART.radius).ball_radius == PART.radius


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("<Point>.*?</Point>", "", "MeasurePoint of feature 8 has no Point"),
        ("<Point>.*?</Point>", "<Point>1 2</Point>", "element 8: 2 numbers where 3"),
        ("<Compensated>.*?</Compensated>", "", "lacks Compensated, or all others do"),
        ("<Compensated>.*?</Compensated>", "<Compensated>no</Compensated>", "'no' is not true or false"),
        ("<ProbeRadius>.*?</ProbeRadius>", "<ProbeRadius>0</ProbeRadius>", "is not positive"),
    ],
)
def test_spoilt_touches_are_refused(qif_file, old, new, says):
    with pytest.raises(FormatError, match=says):
        readers.read(qif_file(re.sub(old, new, files.qif(PART, scan=True, version=2, listed=True), count=1)))


def test_features_of_a_part_of_a_set(qif_file):
    text = files.qif(PART, scan=True)
    some = (
        '<PointList n="2"><SinglePointSetId index="1">9</SinglePointSetId>'
        '<RangePointSetId range="4 5">9</RangePointSetId></PointList>'
    )
    m = readers.read(qif_file(text.replace(files.SET_NINE, some)))
    np.testing.assert_array_equal(m.points, PART.centres[[0, 3, 4]])
    for span in ("0 2", "4 6", "3 2", "1 2 3", "x"):
        with pytest.raises(FormatError, match="point"):
            readers.read(qif_file(text.replace(files.SET_NINE, some.replace("4 5", span))))


def test_flags_and_radii_one_a_point(qif_file):
    flags = "true false false false false"
    radii = " ".join(["2.5"] * 5)
    text = files.qif(PART, scan=True)
    text = re.sub("<Compensated>.*?</Compensated>", f"<Compensations>{flags}</Compensations>", text)
    text = re.sub("<ProbeRadius>.*?</ProbeRadius>", f"<ProbeRadii>{radii}</ProbeRadii>", text)
    path = qif_file(text)
    m = readers.read(path)
    # The contact point stays, the centres come to it along their normals.
    assert m.ball_radius == 0 and "another probe ball" in m.notes[0]
    np.testing.assert_allclose(m.points[0], PART.centres[0], atol=1e-14)
    np.testing.assert_allclose(m.points[1:], PART.centres[1:] - 2.5 * PART.normals[1:], atol=1e-14)
    for points in ("contact", "centre"):
        with pytest.raises(UsageError, match="contradicts"):
            readers.read(path, points=points, probe_radius=2.5 if points == "centre" else None)


def test_sets_of_other_features_only_where_there_is_nothing_better(qif_file):
    scan = files.qif(PART, scan=True).replace("PointDefinedCurve", "Circle")
    assert len(readers.read(qif_file(scan))) == 5
    extra = (
        '<MeasuredPointSet id="77" count="1"><Points>1 2 3</Points><Compensated>true</Compensated></MeasuredPointSet>'
    )
    circle = (
        '<CircleFeatureMeasurement id="78"><PointList><WholePointSetId>77</WholePointSetId></PointList>'
        "</CircleFeatureMeasurement>"
    )
    both = files.qif(PART).replace("<MeasuredPointSets>", "<MeasuredPointSets>" + extra)
    m = readers.read(qif_file(both.replace("<MeasuredFeatures>", "<MeasuredFeatures>" + circle)))
    assert len(m) == 5 and m.notes == ("points left out: 1 of circle features",)


def test_location_moved_by_the_radius_is_a_contact_point(qif_file):
    text = files.qif(PART, stated=False)
    for centre, contact in zip(PART.centres.tolist(), PART.contact.tolist(), strict=True):
        old, new = (" ".join(map(repr, v)) for v in (centre, contact))
        text = text.replace(f"<Location>{old}</Location>", f"<Location>{new}</Location>")
    m = readers.read(qif_file(text))
    assert m.ball_radius == 0
    np.testing.assert_allclose(m.from_nominal(), PART.deviations, atol=1e-12)


def test_what_the_file_does_not_say_is_asked_for(qif_file):
    path = qif_file(files.qif(PART, sets=False, stated=False))
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)
    with pytest.raises(UsageError, match="--probe-radius"):
        readers.read(path, points="centre")
    assert readers.read(path, points="centre", probe_radius=1.5).ball_radius == 1.5
    assert readers.read(path, points="contact").ball_radius == 0
    path = qif_file(re.sub("<FileUnits>.*</FileUnits>", "", files.qif(PART), flags=re.DOTALL))
    with pytest.raises(UsageError, match="--units"):
        readers.read(path)
    assert readers.read(path, units="mm").unit == "mm"


def test_a_file_without_points_says_so_before_a_unit_is_asked_for(qif_file):
    empty = re.sub("<MeasuredFeatures>.*</MeasuredPointSets>", "", files.qif(PART), flags=re.DOTALL)
    with pytest.raises(FormatError, match="no measured points"):
        readers.read(qif_file(re.sub("<FileUnits>.*</FileUnits>", "", empty, flags=re.DOTALL)))


def test_contradictions(qif_file):
    path = qif_file(files.qif(PART))
    for options in ({"points": "contact"}, {"points": "centre", "probe_radius": 2.0}, {"units": "inch"}):
        with pytest.raises(UsageError, match="contradicts"):
            readers.read(path, **options)
    assert len(readers.read(path, points="centre", probe_radius=1.5, units="mm")) == 5


def test_other_units(qif_file):
    metres = files.qif(PART, stated=False).replace("<Factor>0.001</Factor>", "<Factor>1</Factor>")
    metres = metres.replace("<UnitName>mm<", "<UnitName>m<")
    m = readers.read(qif_file(metres.replace(repr(PART.radius), "0.0015")), units="mm")
    np.testing.assert_allclose(m.points, PART.centres * 1000, rtol=1e-15)
    assert m.ball_radius == 1.5 and "1000 mm" in m.notes[0]
    other = files.qif(PART, scan=True).replace(
        "</FileUnits>",
        "<OtherUnits><LinearUnit><UnitName>inch</UnitName><UnitConversion><Factor>0.0254</Factor></UnitConversion>"
        "</LinearUnit></OtherUnits></FileUnits>",
    )
    m = readers.read(qif_file(other.replace('id="9" ', 'id="9" linearUnit="inch" ')))
    np.testing.assert_allclose(m.points, PART.centres * 25.4, rtol=1e-15)
    assert m.ball_radius == pytest.approx(1.5 * 25.4)


@pytest.mark.parametrize(("name", "factor"), [("inch", "0.001"), ("mm", "0.0254"), ("MM", "1"), ("Metre", "0.001")])
def test_a_unit_whose_name_contradicts_its_factor(qif_file, name, factor):
    content = (
        files.qif(PART).replace("<UnitName>mm<", f"<UnitName>{name}<").replace("<Factor>0.001<", f"<Factor>{factor}<")
    )
    with pytest.raises(FormatError, match=f"unit named '{name}' has the factor {factor} to metres, not"):
        readers.read(qif_file(content))
    readers.read(
        qif_file(content.replace(f"<UnitName>{name}<", "<UnitName>own<")), units="inch" if factor == "0.0254" else "mm"
    )


BOMB = (
    """<?xml version="1.0"?>
<!DOCTYPE lolz [
 <!ENTITY lol "lol">
"""
    + "".join(f' <!ENTITY lol{k} "{f"&lol{k - 1 or str()};" * 10}">\n' for k in range(1, 10))
    + """]>
<QIFDocument>&lol9;</QIFDocument>
"""
)


@pytest.mark.parametrize(
    "text",
    [
        BOMB,
        '<?xml version="1.0"?>\n<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]>\n<QIFDocument>&b;</QIFDocument>',
        '<?xml version="1.0"?>\n<!DOCTYPE QIFDocument SYSTEM "http://example.org/qif.dtd">\n<QIFDocument/>',
        '<!DOCTYPE a [<!ENTITY % b SYSTEM "http://example.org/x"> %b;]><QIFDocument/>',
        '<!DOCTYPE a [<!ATTLIST QIFDocument idMax CDATA "5">]><QIFDocument/>',
        "<!DOCTYPE QIFDocument><QIFDocument/>",
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_no_entities_ever(qif_file, text, encoding):
    path = qif_file(text.encode(encoding))
    start = time.perf_counter()
    tracemalloc.start()
    with pytest.raises(FormatError, match="declares a document type"):
        readers.read(path, format="qif")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert time.perf_counter() - start < 1 and peak < 1e6


@pytest.mark.parametrize("reference", ["&lol;", "&#x110000;", "&"])
def test_references_to_nothing(qif_file, reference):
    with pytest.raises(FormatError, match="well-formed"):
        readers.read(qif_file(files.qif(PART).replace("P1<", f"{reference}<")))


def test_a_file_of_the_disk_is_not_read_from_within(qif_file, tmp_path):
    (tmp_path / "points.xml").write_text("<Points>1 2 3</Points>")
    text = files.qif(PART, scan=True).replace("<Results>", '<Results xmlns:xi="http://www.w3.org/2001/XInclude">')
    text = re.sub("<Points>.*</Points>", '<xi:include href="points.xml"/>', text, flags=re.DOTALL)
    with pytest.raises(FormatError, match="no Points"):
        readers.read(qif_file(text))


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("<FeatureItemId>101<", "<FeatureItemId>999<", "102 refers to feature item '999'"),
        ("<FeatureNominalId>100<", "<FeatureNominalId>999<", "101 refers to nominal '999'"),
        ('PointFeatureMeasurement id="112"', 'PointFeatureMeasurement id="102"', "twice"),
        ('MeasuredPointSet id="113"', 'MeasuredPointSet id="103"', "twice"),
        ('PointFeatureMeasurement id="112"', "PointFeatureMeasurement", "no id"),
        ('count="1"', 'count="2"', "3 numbers where 6"),
        ('count="1"', "", "no count"),
        ('count="1"', 'count="-1"', "no count"),
        ("<Compensated>false<", "<Compensated>no<", "not true or false"),
        ("<ProbeRadius>1.5<", "<ProbeRadius>-1.5<", "not positive"),
        ("<ProbeRadius>1.5<", "<ProbeRadius>nan<", "'nan' is no number"),
        ("<ProbeRadius>1.5<", "<ProbeRadius>1e8<", "no radius"),
        ("<Value>0.0<", "<Value>zero<", "'zero' is no number"),
        ("<Factor>0.001<", "<Factor>0<", "no unit"),
        ("<Compensated>", "<CoordinateSystemId>5</CoordinateSystemId><Compensated>", "common frame"),
        ("</Results>", "", "well-formed"),
        ("<QIFDocument", "<QIFDocuments", "well-formed|not QIFDocument"),
        ('encoding="UTF-8"', 'encoding="klingon"', "encoding"),
        ('encoding="UTF-8"', 'encoding="utf-7"', "encoding|well-formed"),
    ],
)
def test_refused_with_line_and_id(qif_file, old, new, says):
    text = files.qif(PART)
    assert old in text
    path = qif_file(text.replace(old, new, 1))
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(path, format="qif")
    assert caught.value.file == str(path) and (caught.value.line or "encoding" in says)


@pytest.mark.parametrize(
    ("location", "says"),
    [("1 2", "2 numbers"), ("1 2 3 4", "4 numbers"), ("1 2 NaN", "'NaN'"), ("1 2 1_0", "'1_0'"), ("1 2 1e", "'1e'"),
     ("1 2 \u0663", "no number"), ("1 2 1e400", "no length"), ("1,2,3", "'1,2,3'"), ("", "0 numbers")],
)  # fmt: skip
def test_spoilt_locations(qif_file, location, says):
    text = re.sub(r'(id="102">.*?<Location>).*?(</Location>)', rf"\g<1>{location}\2", files.qif(PART), count=1)
    with pytest.raises(FormatError, match=says):
        readers.read(qif_file(text))


def test_an_element_where_text_belongs(qif_file):
    with pytest.raises(FormatError, match="'b' stands where the text of an element was expected") as caught:
        readers.read(qif_file(files.qif(PART).replace("<ProbeRadius>1.5", "<ProbeRadius>1<b/>.5")))
    assert caught.value.line


def test_deep_nesting_is_no_measurement(qif_file):
    with pytest.raises(FormatError, match="nested"):
        readers.read(qif_file("<QIFDocument>" + "<a>" * 100_000))


def test_binary_points_of_a_wrong_size(qif_file):
    text = files.qif(PART, scan=True, binary="<f8")
    for damaged, says in ((text.replace('count="5"', 'count="4"'), "120 bytes for 4"), (text.replace("==<", "<"), "")):
        if damaged != text:
            with pytest.raises(FormatError, match=says):
                readers.read(qif_file(damaged))
    with pytest.raises(FormatError, match="base64"):
        readers.read(qif_file(re.sub(r"(sizeElement=.8.>)", r"\1*", text, count=1)))


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(1, 9),
    seed=st.integers(0, 99),
    version=st.sampled_from([2, 3]),
    scan=st.booleans(),
    compensated=st.booleans(),
    binary=st.sampled_from(["", "<f8"]),
    inch=st.booleans(),
    comments=st.booleans(),
    encoding=st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]),
)
def test_written_and_read_back(tmp_path, n, seed, encoding, compensated, **dress):
    part = files.ellipse(n, seed=seed, decimals=None)
    path = tmp_path / "round.qif"
    text = files.qif(part, compensated=compensated, **dress).replace("UTF-8", encoding.removesuffix("-sig"))
    path.write_text(text, encoding=encoding)
    m = readers.read(path)
    np.testing.assert_allclose(m.contact(), part.contact, atol=1e-11)
    np.testing.assert_allclose(m.normals, part.normals, atol=1e-14)
    if not dress["scan"]:
        np.testing.assert_allclose(m.from_nominal(), part.deviations, atol=1e-11)


@pytest.mark.few(1)
@pytest.mark.parametrize("spoilt", [False, True])
def test_records_go_when_the_file_has_been_read(qif_file, spoilt):
    """Also where Python does not look for cycles."""
    readers.read(qif_file(files.qif(PART), "imports what is needed"))
    text = files.qif(files.ellipse(5000))
    path = qif_file(text.replace("</Results>", "") if spoilt else text)
    gc.collect()
    gc.disable()
    tracemalloc.start()
    try:
        with pytest.raises(FormatError) if spoilt else contextlib.nullcontext():
            readers.read(path)
        left = tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
        gc.enable()
    assert left < 0.1 * len(text)


def test_memory_of_a_large_scan(qif_file):
    path = qif_file(files.qif(files.ellipse(30_000), scan=True))
    size = path.stat().st_size
    tracemalloc.start()
    readers.read(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10 * size


def test_what_a_location_is_says_its_own_point_set(qif_file):
    """Two touches of one place, of which only one was compensated."""
    text = files.qif(PART, stated=False)
    place = " ".join(map(repr, PART.centres[0].tolist()))
    other = " ".join(map(repr, PART.centres[1].tolist()))
    text = text.replace(f">{other}<", f">{place}<").replace(f"\n{other}\n", f"\n{place}\n")
    own = "<Compensated>false</Compensated><ProbeRadius>1.5</ProbeRadius>"
    text = text.replace(own, "<Compensated>true</Compensated>", 1)
    m = readers.read(qif_file(text))
    contact = m.points - m.ball_radius * m.normals
    np.testing.assert_allclose(contact[0], PART.centres[0], atol=1e-9)
    np.testing.assert_allclose(contact[1], PART.centres[0] - 1.5 * PART.normals[1], atol=1e-9)
