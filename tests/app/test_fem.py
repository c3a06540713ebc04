# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stiffness along a contour from FEM results that are made by hand: a wall of 80 by 2 mm, 20 mm high."""

from __future__ import annotations

import numpy as np
import Part
import pytest
from FreeCAD import Vector

from millcorr.app import fem
from millcorr.errors import InputError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Profile, join

Fem, ObjectsFem = pytest.importorskip("Fem"), pytest.importorskip("ObjectsFem")
LENGTH, THICK, HIGH = 80.0, 2.0, 20.0
CORNERS = np.array([[0.0, 0.0], [LENGTH, 0.0], [LENGTH, THICK], [0.0, THICK], [0.0, 0.0]])


@pytest.fixture
def wall(document):
    box = document.addObject("Part::Box", "Wall")
    box.Length, box.Width, box.Height = LENGTH, THICK, HIGH
    document.recompute()
    return box


@pytest.fixture
def profile():
    return Profile.from_contours(
        [join([NurbsCurve.line(a, b) for a, b in zip(CORNERS[:-1], CORNERS[1:], strict=True)])]
    )


def edge_at(box, x):
    """Name of the upright edge of the box at x on the side y = 0."""
    edges = box.Shape.Edges
    return next(
        f"Edge{k}" for k, e in enumerate(edges, 1) if {(round(v.X), round(v.Y)) for v in e.Vertexes} == {(x, 0)}
    )


def result_of(document, box, place, direction, moved, newtons=10.0):
    """A result of an analysis that loads a part of the box, all of whose nodes move by `moved`."""
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(box, place)]
    # A quantity since FreeCAD 0.21: a number would be thousandths of a newton.
    force.Force = newtons if isinstance(force.Force, float) else f"{newtons} N"
    document.recompute()
    force.DirectionVector = Vector(*direction)
    mesh = Fem.FemMesh()
    places = [(x, y, z) for x in (0.0, 40.0, LENGTH) for y in (0.0, THICK) for z in (0.0, 10.0, HIGH)]
    for number, p in enumerate(places, 1):
        mesh.addNode(*p, number)
    meshed = ObjectsFem.makeMeshResult(document, "Mesh")
    meshed.FemMesh = mesh
    result = ObjectsFem.makeResultMechanical(document, "Result")
    result.Mesh = meshed
    result.NodeNumbers = list(range(1, len(places) + 1))
    # Other nodes move elsewhere: only those that are loaded count.
    loaded = box.getSubObject(place)
    near = [loaded.distToShape(Part.Vertex(Vector(*p)))[0] < 1e-6 for p in places]
    result.DisplacementVectors = [Vector(*moved) if own else Vector(9.0, 9.0, 9.0) for own in near]
    for member in (force, result):
        analysis.addObject(member)
    return result


def test_a_row_for_every_place_that_was_loaded(document, wall, profile):
    results = [
        result_of(document, wall, edge_at(wall, 80), (0.0, 1.0, 0.0), (0.3, 0.01, 0.2)),
        result_of(document, wall, edge_at(wall, 0), (0.0, -1.0, 0.0), (0.0, -0.004, 0.0)),
        result_of(document, wall, edge_at(wall, 0), (1.0, 0.0, 0.0), (0.001, 0.5, 0.0), newtons=20.0),
    ]
    rows = fem.stiffness_along(results, profile, 8000.0, 5000.0)
    # 0.1, 0.4 and 0.05 um/N of the wall, and 0.125 and 0.2 of the machine.
    wanted = [
        (0.0, 1 / (1 / 8000 + 0.001 / 20), 1 / (1 / 5000 + 0.004 / 10)),
        (80.0, 8000.0, 1 / (1 / 5000 + 0.01 / 10)),
    ]
    np.testing.assert_allclose(rows, wanted, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda r, f: setattr(f, "DirectionVector", Vector(0.0, 0.5**0.5, 0.5**0.5)), "neither along X nor along Y"),
        (lambda r, f: setattr(f, "DirectionVector", Vector(0.0, -1.0, 0.0)), "moves against its load"),
        (lambda r, f: setattr(f, "References", [(f.References[0][0], ("Edge1", "Edge2"))]), "acts on 2 places"),
        (lambda r, f: setattr(r, "NodeNumbers", [n + 100 for n in r.NodeNumbers]), "calculate it again"),
        (lambda r, f: setattr(r, "DisplacementVectors", [Vector()]), "calculate it again"),
        (lambda r, f: r.getParentGroup().addObject(ObjectsFem.makeConstraintPressure(r.Document)), "has 2 loads"),
        (lambda r, f: r.getParentGroup().addObject(ObjectsFem.makeConstraintSelfWeight(r.Document)), "has 2 loads"),
        (lambda r, f: r.getParentGroup().removeObject(f), "has 0 loads"),
    ],
)
def test_what_is_no_load_of_one_place_is_refused(document, wall, profile, change, says):
    result = result_of(document, wall, edge_at(wall, 80), (0.0, 1.0, 0.0), (0.0, 0.01, 0.0))
    force = result.getParentGroup().Group[0]
    change(result, force)
    with pytest.raises(InputError, match=says):
        fem.stiffness_along([result], profile, 8000.0, 5000.0)


def test_a_load_beside_the_contour_and_a_place_loaded_twice_are_refused(document, wall, profile):
    result = result_of(document, wall, edge_at(wall, 80), (0.0, 1.0, 0.0), (0.0, 0.01, 0.0))
    again = result_of(document, wall, edge_at(wall, 80), (0.0, 1.0, 0.0), (0.0, 0.02, 0.0))
    with pytest.raises(InputError, match="another result loads the place at 80.000 mm along Y"):
        fem.stiffness_along([result, again], profile, 8000.0, 5000.0)
    far = Profile.from_contours(
        [join([NurbsCurve.line(a, b) for a, b in zip(CORNERS[:-1] + 5, CORNERS[1:] + 5, strict=True)])]
    )
    with pytest.raises(InputError, match="is not on the contour"):
        fem.stiffness_along([result], far, 8000.0, 5000.0)
