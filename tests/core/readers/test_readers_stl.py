# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scans saved as STL."""

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files

WALL = files.cylinder_mesh(24)


@pytest.fixture
def mesh(tmp_path):
    def make(data, name="scan.stl"):
        path = tmp_path / name
        path.write_bytes(data)
        return path

    return make


@pytest.mark.parametrize("binary", [False, True])
def test_corners_with_the_normals_of_their_facets(mesh, binary):
    path = mesh(files.stl(WALL, binary=binary))
    m = readers.read(path, points="contact")
    assert m.format == "stl" and len(m) == 48 and m.notes[0].startswith("the 48 corners of a mesh of 48 facets")
    assert {tuple(p) for p in m.points.tolist()} == {tuple(p) for p in WALL.reshape(-1, 3).tolist()}
    radial = m.points * [1, 1, 0] / np.hypot(m.points[:, 0], m.points[:, 1])[:, None]
    # Two facets on one side and one on the other turn the mean by a sixth of the angle between the sides.
    assert np.degrees(np.arccos((m.normals * radial).sum(axis=1))).max() < 15 / 6 + 0.1
    np.testing.assert_array_equal(m.lines[:3], [1, 1, 1])
    assert any("steps of 1.9e-06 mm" in note for note in m.notes) == binary
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)


def test_a_mesh_in_inch_and_turned_inside_out(mesh):
    m = readers.read(mesh(files.stl(WALL[:, ::-1])), points="contact", units="inch")
    assert (m.normals * m.points)[:, :2].sum(axis=1).max() < 0
    assert np.hypot(*m.points[:, :2].T).max() == pytest.approx(20 * 25.4)


def test_facets_without_area_give_no_normal(mesh):
    flat = np.array([[[5.0, 5.0, 0.0], [6.0, 6.0, 0.0], [7.0, 7.0, 0.0]]])
    m = readers.read(mesh(files.stl(np.concatenate([flat, WALL]))), points="contact")
    assert len(m) == 48 and "3 corners without a normal left out" in m.notes


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (lambda t: t.replace(b"vertex 20.0", b"vertex 2O.0", 1), "no whole facet"),
        (lambda t: t.replace(b"endloop", b"", 1), "no whole facet"),
        (lambda t: t[: t.rindex(b"endsolid")], "no whole facet: damaged or cut off"),
        (lambda t: t[: len(t) // 2], "damaged or cut off"),
    ],
)
def test_damaged_text(mesh, damage, says):
    with pytest.raises(FormatError, match=says):
        readers.read(mesh(damage(files.stl(WALL, binary=False))), points="contact")


def test_damaged_binary(mesh):
    data = files.stl(WALL)
    with pytest.raises(FormatError, match="cut off: its size does not fit"):
        readers.read(mesh(data[:-7]), points="contact", format="stl")
    spoilt = bytearray(data)
    spoilt[84 + 50 + 12 : 84 + 50 + 16] = np.float32(np.nan).tobytes()
    with pytest.raises(FormatError, match="no place") as caught:
        readers.read(mesh(bytes(spoilt)), points="contact")
    assert caught.value.line == 2


def test_several_solids_in_a_file(mesh):
    text = files.stl(WALL[:24], binary=False) + files.stl(WALL[24:], binary=False)
    assert len(readers.read(mesh(text), points="contact")) == 48
