# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conversions between FreeCAD's shapes and profiles, with OCCT as the oracle."""

from __future__ import annotations

import FreeCAD
import numpy as np
import Part
import pytest

from millcorr.app import convert, demonstration, sources
from millcorr.errors import FormatError, InputError
from millcorr.geometry.footpoint import FootPointSearch

V = FreeCAD.Vector
Z = V(0, 0, 1)


def rational_spline():
    spline = Part.BSplineCurve()
    poles = [V(0, 0, 0), V(10, 15, 0), V(25, 12, 0), V(30, -5, 0), V(45, 3, 0)]
    spline.buildFromPolesMultsKnots(poles, [4, 1, 4], [0, 0.4, 1], False, 3, [1, 2, 0.7, 1.5, 1])
    return spline


def periodic_rational():
    spline = Part.BSplineCurve()
    poles = [V(20 * np.cos(a), 12 * np.sin(a), 0) for a in np.arange(8) * np.pi / 4]
    spline.buildFromPolesMultsKnots(poles, [1] * 9, list(range(9)), True, 3, [1, 2, 1, 0.5, 1, 2, 1, 0.5])
    return spline


def bezier():
    curve = Part.BezierCurve()
    curve.setPoles([V(0, 0, 0), V(5, 20, 0), V(30, -10, 0), V(40, 10, 0)])
    return curve


EDGES = {
    "line": Part.makeLine(V(1, 2, 3), V(4, 8, 3)),
    "circle": Part.makeCircle(7, V(1, 2, 0)),
    "arc": Part.makeCircle(7, V(1, 2, 5), Z, 20, 300),
    "arc seen from below": Part.makeCircle(7, V(1, 2, 0), V(0, 0, -1), 20, 300),
    "ellipse": Part.Ellipse(V(0, 0, 0), 20, 8).toShape(),
    "arc of ellipse": Part.ArcOfEllipse(Part.Ellipse(V(3, 1, 0), 20, 8), 0.3, 4).toShape(),
    "parabola": Part.Parabola().toShape(-3, 5),
    "rational": rational_spline().toShape(),
    "rational trimmed": rational_spline().toShape(0.1, 0.8),
    "periodic": demonstration.contour_curve().toShape(),
    "periodic trimmed": demonstration.contour_curve().toShape(2.3, 11.7),
    "periodic across the seam": demonstration.contour_curve().toShape(12.5, 18.25),
    "periodic rational": periodic_rational().toShape(),
    "bezier": bezier().toShape(),
    "offset curve": Part.OffsetCurve(rational_spline(), -2.0, Z).toShape(0.0, 1.0),
}


def placed(edge):
    """The edge turned and moved, so that its location counts."""
    moved = edge.copy()
    moved.Placement = FreeCAD.Placement(V(11, -7, 2), FreeCAD.Rotation(Z, 33))
    return moved


def assert_same_curve(profile, edge, tolerance):
    """Positions, foot points, normals and length agree with OCCT."""
    first, last = edge.ParameterRange
    parameters = np.linspace(first, last, 53)[1:-1]
    points = np.array([tuple(edge.valueAt(u))[:2] for u in parameters])
    search = FootPointSearch(profile)
    feet = search.find(points)
    assert np.abs(feet.distance).max() < tolerance
    tangent = np.array([tuple(edge.tangentAt(u))[:2] for u in parameters])
    normal = profile.normals(feet.span, feet.t)
    assert np.abs((tangent * normal).sum(axis=1)).max() < max(1e-8, tolerance)
    assert abs(profile.total.sum() - edge.Length) < 1e-7 * edge.Length
    off = points + 0.4 * normal
    feet = search.find(off)
    curve_distance = [edge.distToShape(Part.Vertex(V(x, y, edge.valueAt(first).z)))[0] for x, y in off]
    assert np.abs(np.abs(feet.distance) - curve_distance).max() < max(tolerance, 2e-7)


@pytest.mark.parametrize("name", EDGES)
@pytest.mark.parametrize("change", ["as it is", "reversed", "placed", "copied reversed"])
def test_edge_is_the_same_curve(name, change):
    edge = EDGES[name]
    if change == "reversed":
        edge = edge.reversed() if hasattr(edge, "reversed") else edge.copy()
    elif change == "copied reversed":
        edge = edge.copy()
        edge.reverse()
    elif change == "placed":
        edge = placed(edge)
    nurbs = convert.curve_of_edge(edge)
    profile = convert.profile_of_edges([edge], "left")
    # An offset curve is no B-spline: OCCT approximates it, within its own tolerance.
    assert_same_curve(profile, edge, 1e-3 if name == "offset curve" else 1e-9)
    assert nurbs.periodic == (name in ("periodic", "periodic rational"))


@pytest.mark.parametrize("name", [n for n in EDGES if n not in ("circle", "ellipse") and "periodic" != n[:8]])
def test_direction_is_the_edge_s(name):
    edge = EDGES[name].copy()
    edge.reverse()
    nurbs = convert.curve_of_edge(edge)
    start = nurbs.evaluate([nurbs.knots[0]])[0]
    end = nurbs.evaluate([nurbs.knots[-1]])[0]
    assert np.hypot(*(start - tuple(edge.lastVertex(False).Point)[:2])) < 1e-9
    assert np.hypot(*(end - tuple(edge.firstVertex(False).Point)[:2])) < 1e-9


def test_edge_that_climbs_is_refused():
    with pytest.raises(InputError, match="not level"):
        convert.profile_of_edges([Part.makeLine(V(0, 0, 0), V(10, 0, 0.001))])


def test_circle_on_its_side_is_refused():
    with pytest.raises(InputError, match="not level"):
        convert.profile_of_edges([Part.makeCircle(5, V(0, 0, 0), V(1, 0, 0))])


def test_edges_join_in_any_order_and_direction():
    corners = [V(0, 0, 0), V(40, 0, 0), V(40, 25, 0), V(10, 30, 0)]
    edges = [Part.makeLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]
    flipped = [edges[2], Part.makeLine(corners[1], corners[0]), edges[3], edges[1]]
    profile = convert.profile_of_edges(flipped)
    assert [c.closed for c in profile.contours] == [True]
    assert profile.signed_areas()[0] == pytest.approx(Part.Face(Part.Wire(edges)).Area)


def test_open_edges_stay_open():
    profile = convert.profile_of_edges([Part.makeLine(V(5, 0, 0), V(9, 3, 0)), Part.makeLine(V(0, 0, 0), V(5, 0, 0))])
    assert [c.closed for c in profile.contours] == [False]
    assert profile.total[0] == pytest.approx(10.0)


def test_branching_edges_are_refused():
    edges = [Part.makeLine(V(0, 0, 0), V(*end)) for end in ((9, 0, 0), (0, 9, 0), (-9, -9, 0))]
    with pytest.raises(InputError, match="3 edges"):
        convert.profile_of_edges(edges)


def test_no_edge_is_refused():
    with pytest.raises(InputError):
        convert.profile_of_edges([])
    with pytest.raises(InputError):
        convert.profile_of_shape(Part.Shape())


def test_face_with_holes_has_material_between():
    outer = Part.Face(Part.Wire([Part.makeCircle(20)]))
    face = outer.cut(Part.Face(Part.Wire([Part.makeCircle(4, V(8, 0, 0))])))
    profile = convert.profile_of_shape(face)
    assert sorted(np.sign(profile.signed_areas())) == [-1, 1]
    assert profile.signed_areas().sum() == pytest.approx(face.Area)
    assert convert.profile_of_shape(face, "outside").signed_areas().sum() == pytest.approx(-face.Area)


def prism():
    return Part.Face(Part.Wire([demonstration.contour_curve().toShape()])).extrude(V(0, 0, 12))


def test_outline_of_a_prism_is_its_exact_edge():
    profile = convert.profile_of_shape(prism())
    curve = profile.contours[0].curves[0]
    wanted = np.array(demonstration.CONTROL_VERTICES)
    assert curve.periodic
    assert sorted(map(tuple, curve.poles.round(9))) == sorted(map(tuple, wanted))


def test_outline_of_a_stepped_part_is_its_widest_step():
    part = Part.makeBox(60, 40, 5).fuse(Part.makeCylinder(12, 20, V(30, 20, 0)))
    profile = convert.profile_of_shape(part)
    assert profile.signed_areas() == pytest.approx([2400.0])


def test_outline_with_a_pocket_ignores_it():
    part = Part.makeBox(60, 40, 10).cut(Part.makeBox(20, 20, 5, V(10, 10, 5)))
    assert convert.profile_of_shape(part).signed_areas() == pytest.approx([2400.0])


def test_side_hole_leaves_the_outline():
    part = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(2, 100, V(30, -10, 5), V(0, 1, 0)))
    assert convert.profile_of_shape(part).signed_areas() == pytest.approx([2400.0])


@pytest.mark.parametrize(
    "part",
    [Part.makeSphere(10), Part.makeCone(10, 5, 10), Part.makeCylinder(5, 20, V(0, 0, 0), V(1, 0, 0.2))],
)
def test_part_that_is_not_prismatic_is_refused(part):
    with pytest.raises(InputError, match="not prismatic|height"):
        convert.profile_of_shape(part)


def test_profile_goes_to_a_shape_and_back():
    edges = [
        EDGES["rational"],
        Part.makeLine(V(45, 3, 0), V(45, -30, 0)),
        Part.makeLine(V(45, -30, 0), V(0, 0, 0)),
    ]
    for source in (edges, [EDGES["periodic"]], [EDGES["periodic rational"]], [EDGES["circle"]]):
        profile = convert.profile_of_edges(source)
        shape = convert.shape_of_profile(profile, 3.5)
        assert shape.BoundBox.ZMin == pytest.approx(3.5) and shape.isClosed()
        again = convert.profile_of_shape(shape)
        for a, b in zip(profile.contours[0].curves, again.contours[0].curves, strict=True):
            assert a.degree == b.degree and a.periodic == b.periodic
            assert np.abs(a.poles - b.poles).max() < 1e-12 or len(source) > 1
        assert again.total == pytest.approx(profile.total, abs=1e-9)


def test_occt_reads_the_step_file_of_a_profile(tmp_path):
    from millcorr.geometry import step

    given = convert.profile_of_edges([periodic_rational().toShape()])
    file = tmp_path / "profile.step"
    file.write_text(step.text(given, "part"), encoding="utf-8")
    shape = Part.Shape()
    shape.read(str(file))
    read = convert.profile_of_shape(shape)
    assert read.total == pytest.approx(given.total, abs=1e-9)
    places, _ = given.at(0, np.linspace(0, given.total[0], 101))
    assert np.abs(FootPointSearch(read).find(places).distance).max() < 1e-9


def dxf_of(entities: str) -> str:
    """A DXF file of the oldest kind with one layer."""
    layer = "0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 1 0 LAYER 2 0 70 0 62 7 6 CONTINUOUS 0 ENDTAB 0 ENDSEC"
    words = f"{layer} 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF".split()
    return "".join(f"{code}\n{value}\n" for code, value in zip(words[::2], words[1::2], strict=True))


def test_dxf_file_as_nominal(tmp_path):
    line = "0 LINE 8 0 10 {} 20 {} 30 0 11 {} 21 {} 31 0 "
    arc = "0 ARC 8 0 10 90 20 40 30 0 40 10 50 0 51 90 "
    sides = [(0, 0, 100, 0), (100, 0, 100, 40), (90, 50, 0, 50), (0, 50, 0, 0)]
    file = tmp_path / "part.dxf"
    file.write_text(dxf_of("".join(line.format(*side) for side in sides) + arc), encoding="ascii")
    try:
        profile = sources.profile_of_file(file)
    except FormatError as error:
        assert FreeCAD.Version()[:2] == ["1", "0"], error
        pytest.skip("FreeCAD 1.0 reads no DXF file without a window")
    assert profile.signed_areas() == pytest.approx([5000 - 100 + 25 * np.pi], abs=1e-6)
    file.write_text(dxf_of(""), encoding="ascii")
    with pytest.raises(FormatError, match="part.dxf"):
        sources.profile_of_file(file)
