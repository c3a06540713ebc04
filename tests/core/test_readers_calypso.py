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


def test_other_tables_of_calypso_are_named(table):
    """The table of features has columns x, y and z, of circles and planes as well."""
    features = "planid\tpartnb\tgeotype\tid\tx\ty\tz\tnx\tny\tnz\nGate\t815\tCircle\tBore\t40.0\t20.0\t0.0\t0\t0\t1\n"
    with pytest.raises(FormatError, match=r"give the file that ends in _chr.txt, or say by --mapping"):
        readers.read(table(features, "plan_fet.txt"), points="contact")
