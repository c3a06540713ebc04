# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calypso's table of characteristics."""

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files

PART = files.ellipse(4)


@pytest.fixture
def table(tmp_path):
    def make(content, name="plan_chr.txt"):
        path = tmp_path / name
        path.write_bytes(content.encode())
        return path

    return make


@pytest.mark.parametrize("inch", [False, True])
@pytest.mark.parametrize("has_z", [False, True])
def test_points_of_a_table(table, inch, has_z):
    m = readers.read(table(files.calypso(PART, inch=inch, has_z=has_z)), points="contact")
    axes = 3 if has_z else 2
    # Seven decimals, of an inch.
    np.testing.assert_allclose(m.points[:, :axes], PART.contact[:, :axes], atol=1.3e-6)
    np.testing.assert_allclose(m.nominal[:, :axes], PART.nominal[:, :axes], atol=1.3e-6)
    assert m.format == "calypso" and m.elements == PART.names and m.has_z == has_z
    assert m.unit == ("inch" if inch else "mm") and m.bases["unit"].how == "stated"
    assert m.notes == (
        "4 features with X and Y and no size are taken for points: the table does not name their kind",
        "2 other features left out: diameter",
    )
    assert m.lines[0] == 2
    with pytest.raises(UsageError, match="--points"):
        readers.read(table(files.calypso(PART)))


def test_a_place_of_a_bore_alone_is_no_point(table):
    with pytest.raises(FormatError, match="none of 1 features has xValue and yValue"):
        text = files.calypso(files.ellipse(1)).splitlines()
        readers.read(table("\n".join([text[0], *text[4:]])), points="contact")


def test_parts_by_their_number(table):
    parts = [files.ellipse(4, seed=seed) for seed in (1, 2)]
    texts = [files.calypso(part, number=number) for number, part in enumerate(parts, 7)]
    path = table(texts[0].replace("END\r\n", "") + texts[1].partition("\r\n")[2])
    with pytest.raises(UsageError, match=r"2 measured parts \(1: part '7', .*; 2: part '8', .*"):
        readers.read(path, points="contact")
    for number, part in enumerate(parts, 1):
        np.testing.assert_allclose(readers.read(path, points="contact", part=number).points, part.contact, atol=1e-7)


def test_a_point_that_was_not_measured_is_left_out(table):
    lines = files.calypso(PART, others=False).splitlines()
    cells = lines[1].split("\t")
    cells[5] = cells[9] = ""
    m = readers.read(table("\n".join([lines[0], "\t".join(cells), *lines[2:]])), points="contact")
    assert m.elements == PART.names[1:] and "1 points were not measured" in m.notes


@pytest.mark.parametrize(
    ("column", "new", "says"),
    [
        ("actual", "1.O00", "'1.O00' of axis X is no coordinate"),
        ("actual", "99.0", "deviation is not actual less nominal"),
        ("unit", "um", "only mm and inch"),
        ("unit", "", "different units"),
    ],
)
def test_refused_with_the_line(table, column, new, says):
    lines = files.calypso(PART, others=False).splitlines()
    rows = [1] if column != "unit" or not new else range(1, 13)
    for k in rows:
        cells = lines[k].split("\t")
        cells[files.CALYPSO.index(column)] = new
        lines[k] = "\t".join(cells)
    with pytest.raises(FormatError, match=says) as caught:
        readers.read(table("\n".join(lines)), points="contact")
    assert caught.value.line in (2, 3)


@pytest.mark.parametrize("normals", [True, False])
def test_points_of_a_table_of_features(table, normals):
    path = table(files.calypso_features(PART, normals=normals), "plan_fet.txt")
    m = readers.read(path, points="contact")
    np.testing.assert_allclose(m.points, PART.contact, atol=6e-8)
    np.testing.assert_allclose(m.nominal, PART.nominal, atol=6e-8)
    if normals:
        np.testing.assert_allclose(m.normals, PART.normals, atol=1e-7)
    assert (m.normals is None) != normals
    assert m.format == "calypso" and m.elements == PART.names and m.bases["unit"].how == "assumed"
    assert m.notes == ("2 other features left out: Circle",) and m.lines.tolist() == [2, 4, 5, 6]
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)


def test_parts_of_a_table_of_features(table):
    parts = [files.ellipse(4, seed=seed) for seed in (1, 2)]
    texts = [files.calypso_features(part, number=number) for number, part in enumerate(parts, 7)]
    path = table(texts[0].replace("END\r\n", "") + texts[1].partition("\r\n")[2])
    with pytest.raises(UsageError, match=r"2 measured parts \(1: part '7', .*; 2: part '8', .*"):
        readers.read(path, points="contact")
    for number, part in enumerate(parts, 1):
        np.testing.assert_allclose(readers.read(path, points="contact", part=number).points, part.contact, atol=1e-7)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("\tP2\t", "\tP1\t", "'P1' is there twice, first in line 2"),
        ("SpacePoint", "Plane", "no row of the kind Point or SpacePoint, only 'Circle', 'Plane'"),
        ("-4.0000000\t", "-4.O\t", "no coordinate"),
    ],
)
def test_spoilt_tables_of_features(table, old, new, says):
    text = files.calypso_features(PART).replace(old, new)
    if new == "Plane":
        text = text.replace("\tPoint\t", "\tPlane\t")
    with pytest.raises(FormatError, match=says):
        readers.read(table(text), points="contact")


def test_features_without_coordinates_were_not_measured(table):
    lines = files.calypso_features(PART, others=False).splitlines()
    cells = lines[1].split("\t")
    cells[8:11] = ["", "", ""]
    m = readers.read(table("\n".join([lines[0], "\t".join(cells), *lines[2:]])), points="contact")
    assert m.elements == PART.names[1:] and m.notes == ("1 points were not measured",)


def test_a_table_as_an_older_calypso_writes_it(table):
    """No column of units, characteristics of two features, and a result that belongs to none."""
    columns = [name for name in files.CALYPSO if name != "unit"]
    base = dict.fromkeys(columns, "") | {"planid": "RING", "partnb": "10", "deviation": "0.0000000"}

    def row(kind, feature, value):
        cells = base | {"idsymbol": kind, "featureid": feature, "actual": value, "nominal": value}
        return "\t".join(cells[name] for name in columns)

    others = [
        row("gdtFlat", "Plane_A", "0.0"), row("distance2d", "P1,P2", "0.03"), row("resultElementLength", "", "1.0")
    ]  # fmt: skip
    path = table("\n".join(["\t".join(columns) + "\t", *others, "END", ""]))
    with pytest.raises(FormatError, match="none of 2 features has xValue and yValue"):
        readers.read(path, points="contact")
    points = [row("xValue", "P1", "1.0"), row("yValue", "P1", "2.0")]
    m = readers.read(table("\n".join(["\t".join(columns) + "\t", *others, *points, "END", ""])), points="contact")
    assert m.points.tolist() == [[1.0, 2.0, 0.0]] and m.bases["unit"].how == "assumed"


def test_other_tables_of_calypso_are_named(table):
    """The head of a plan begins with the same columns."""
    head = "planid\tpartnb\tfilename\toperid\tdate\nGate\t815\tgate\tMaster\t2024-02-29\n"
    with pytest.raises(FormatError, match=r"give the file that ends in _chr.txt or _fet.txt, or say by --mapping"):
        readers.read(table(head, "plan_hdr.txt"), points="contact")
