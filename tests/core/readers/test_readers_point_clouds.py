# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLY, PCD and E57, where the libraries that read them are installed."""

from __future__ import annotations

import importlib
import io

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files
from tests.core.measurement_files import e57, pcd, ply
from tests.core.sweeps import examples

PART = files.ellipse(6, decimals=None)
PACKAGES = {"ply": "plyfile", "pcd": "pypcd4", "e57": "pye57"}
STEP = 2**-19
"""Of 32-bit numbers between 16 and 32."""


def library(format):
    return pytest.importorskip(PACKAGES[format], reason=f"{PACKAGES[format]} is not installed")


@pytest.fixture
def read(tmp_path):
    def make(data, **options):
        path = tmp_path / "cloud.bin"
        path.write_bytes(data)
        return readers.read(path, **({"points": "contact"} | options))

    return make


# --- PLY --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["ascii", "binary", "big"])
@pytest.mark.parametrize("number", ["double", "float"])
@pytest.mark.parametrize("normals", [True, False])
def test_ply(read, kind, number, normals):
    library("ply")
    m = read(ply(PART, kind=kind, number=number, normals=normals))
    exact = number == "double"
    np.testing.assert_allclose(m.points, PART.contact, rtol=0, atol=0 if exact else STEP)
    assert m.format == "ply" and m.unit == "mm" and m.ball_radius == 0
    np.testing.assert_array_equal(m.lines, np.arange(1, 7))
    if normals:
        np.testing.assert_allclose(m.normals, PART.normals, atol=1e-15 if exact else 1e-7)
    else:
        assert m.normals is None
    largest = np.abs(m.points).max()
    steps = () if exact else (f"coordinates are stored in steps of 0.0019 um, at {largest:.6g} mm",)
    assert m.notes == steps


def test_ply_by_its_own_library(read):
    plyfile = library("ply")
    rows = np.array([tuple(p) for p in PART.contact.tolist()], dtype=[("x", "f8"), ("y", "f8"), ("z", "f8")])
    for text in (True, False):
        stream = io.BytesIO()
        plyfile.PlyData([plyfile.PlyElement.describe(rows, "vertex")], text=text).write(stream)
        m = read(stream.getvalue())
        np.testing.assert_allclose(m.points, PART.contact, atol=1e-12)


def test_ply_of_a_mesh_in_inch_with_a_ball(read):
    library("ply")
    m = read(ply(PART, mesh=True), units="inch", points="centre", probe_radius=1.5)
    np.testing.assert_allclose(m.points, PART.contact * 25.4, rtol=1e-15)
    assert m.ball_radius == 1.5 and "corners of a mesh" in m.notes[0]


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (lambda d: d[:-3], "cut off"),
        (lambda d: d.replace(b"element vertex 6", b"element vertex 99999999999999"), "more elements"),
        (lambda d: d.replace(b"double x", b"double a"), "instead of x, y, z"),
        (lambda d: d.replace(b"vertex", b"corner"), "no element named vertex"),
        (lambda d: d.replace(b"end_header", b"end"), "cannot read it"),
        (lambda d: d.replace(b"element vertex 6", b"element vertex 0"), "no measured points"),
        (lambda d: d.replace(b"double nx", b"list uchar double nx"), "."),
    ],
)
def test_damaged_ply(read, damage, says):
    library("ply")
    with pytest.raises(FormatError, match=says):
        read(damage(ply(PART)))


# --- PCD --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["ascii", "binary"])
@pytest.mark.parametrize("number", ["double", "float"])
def test_pcd(read, kind, number):
    library("pcd")
    m = read(pcd(PART, kind=kind, number=number))
    exact = number == "double"
    np.testing.assert_allclose(m.points, PART.contact, rtol=0, atol=1e-12 if exact else STEP)
    np.testing.assert_allclose(m.normals, PART.normals, atol=1e-15 if exact else 1e-7)
    assert m.format == "pcd" and len(m.notes) == (0 if exact else 1)


@pytest.mark.parametrize("kind", ["ascii", "binary"])
@pytest.mark.parametrize(("version", "without"), [(b".6", b"VIEWPOINT"), (b"0.6", b""), (b".5", b"COUNT")])
def test_pcd_of_older_versions(read, kind, version, without):
    library("pcd")
    lines = pcd(PART, kind=kind).replace(b"VERSION 0.7", b"VERSION " + version).split(b"\n")
    lines = [line for line in lines if not (without and line.startswith(without))]
    np.testing.assert_allclose(read(b"\n".join(lines)).points, PART.contact, atol=1e-5)


def test_pcd_compressed_by_its_own_library_and_points_without_a_place(read, tmp_path):
    pypcd4 = library("pcd")
    table = PART.contact.astype(np.float32)
    table[2] = np.nan
    path = tmp_path / "made.pcd"
    for encoding in (pypcd4.Encoding.ASCII, pypcd4.Encoding.BINARY, pypcd4.Encoding.BINARY_COMPRESSED):
        pypcd4.PointCloud.from_xyz_points(table).save(path, encoding=encoding)
        m = read(path.read_bytes())
        np.testing.assert_allclose(m.points, np.delete(table, 2, axis=0), atol=1e-6)
        assert "1 points without a place left out" in m.notes and m.lines.tolist() == [1, 2, 4, 5, 6]


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (lambda d: d[:-3], "."),
        (lambda d: d.replace(b"POINTS 6", b"POINTS 99999999999999"), "more points"),
        (lambda d: d.replace(b"POINTS 6", b"POINTS 7"), "."),
        (lambda d: d.replace(b"x y z", b"a b c"), "instead of x, y, z"),
        (lambda d: d.replace(b"DATA binary", b"DATA binary_compressed"), "damaged"),
        (lambda d: d.replace(b"DATA", b"DATE"), "POINTS or DATA"),
        (lambda d: d.replace(b"COUNT 1", b"COUNT 999999999999"), "numbers a point"),
    ],
)
def test_damaged_pcd(read, damage, says):
    library("pcd")
    with pytest.raises(FormatError, match=says):
        read(damage(pcd(PART, kind="binary")))


# --- E57 --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scans", [1, 2])
def test_e57_is_in_metres(read, tmp_path, scans):
    m = read(e57(PART, tmp_path, scans))
    np.testing.assert_allclose(m.points, PART.contact, rtol=0, atol=2e-6)
    assert m.format == "e57" and m.unit == "mm"
    assert ("2 scans put together" in m.notes) == (scans == 2)
    assert m.notes[-1].startswith("coordinates are stored in steps of 0.0019 um, at 2")
    with pytest.raises(UsageError, match="contradicts"):
        read(e57(PART, tmp_path), units="inch")


def test_damaged_e57(read, tmp_path):
    data = e57(PART, tmp_path)
    for damaged in (data[:-1], data[:2000], data[:1500] + b"!" + data[1501:], data[:8]):
        with pytest.raises(FormatError, match="pye57 cannot read it"):
            read(damaged)


# --- all --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("format", "data"), [("ply", ply(PART)), ("pcd", pcd(PART)), ("e57", b"ASTM-E57" + bytes(40))])
def test_a_missing_library_is_named(read, monkeypatch, format, data):
    assert readers.recognised(data) == format
    package = PACKAGES[format]

    def absent(name):
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)

    monkeypatch.setattr(importlib, "import_module", absent)
    with pytest.raises(UsageError, match=f"pip install {package}$"):
        read(data)
    with pytest.raises(UsageError, match="say --points"):
        read(data, points=None)


@pytest.mark.parametrize("format", PACKAGES)
def test_other_files_are_refused_before_the_library_sees_them(format, read):
    with pytest.raises(FormatError, match=f"no {format.upper()} file"):
        read(b"x,y,z\n1,2,3\n", format=format)


@settings(max_examples=examples(40), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    seed=st.integers(0, 999),
    n=st.integers(1, 40),
    kind=st.sampled_from(["ascii", "binary"]),
    format=st.sampled_from(["ply", "pcd"]),
)
def test_written_and_read_back(read, seed, n, kind, format):
    library(format)
    part = files.ellipse(n, seed=seed, decimals=None)
    m = read({"ply": ply, "pcd": pcd}[format](part, kind=kind))
    np.testing.assert_allclose(m.points, part.contact, rtol=0, atol=1e-12)
    np.testing.assert_allclose(m.normals, part.normals, atol=1e-15)
