# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour of a Profile operation from its base geometry."""

from __future__ import annotations

import FreeCAD
import numpy as np
import Part
import pytest

from millcorr.app import base_geometry, compat, demonstration, motion
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.nc.toolpath import Compensation, Kind

V = FreeCAD.Vector


def plate_with_hole():
    outer = Part.makeBox(60, 40, 10)
    slot = Part.Face(Part.Wire([Part.Ellipse(V(40, 20, 0), 12, 9).toShape()])).extrude(V(0, 0, 10))
    return outer.cut(slot).cut(Part.makeCylinder(7, 10, V(15, 20, 0)))


def operation_on(document, shape, base=None, **properties):
    """A Profile operation on a part; `base` chooses sub-elements of the model by a test on each face or edge."""
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    job = compat.make_job(document, [part])
    compat.set_end_mill(job.Tools.Group[0], demonstration.TOOL_DIAMETER)
    operation = compat.make_profile(job)
    if base is not None:
        clone = job.Model.Group[0]
        names = [f"Face{k + 1}" for k, f in enumerate(clone.Shape.Faces) if base(f)]
        names += [f"Edge{k + 1}" for k, e in enumerate(clone.Shape.Edges) if base(e)]
        operation.Base = [(clone, tuple(names))]
    for name, value in ({"Side": "Outside"} | properties).items():
        setattr(operation, name, value)
    document.recompute()
    return operation


def top(sub):
    return isinstance(sub, Part.Face) and sub.BoundBox.ZMin > 9.9


def side(sub):
    return isinstance(sub, Part.Face) and sub.BoundBox.ZLength > 9.9 and sub.BoundBox.XLength in (0.0, 60.0)


def profile_and_path(operation):
    program = motion.program_of_path(compat.path_of(operation), operation.Label)
    return base_geometry.profile_of_operation(operation, program.toolpath), program.toolpath


def assert_path_follows(profile, toolpath, radius, tolerance):
    """All moves at the lowest level lie at the radius outside the material."""
    cutting = toolpath.take((toolpath.kind != Kind.RAPID) & (np.hypot(*(toolpath.end - toolpath.start)[:, :2].T) > 0.1))
    points = cutting.position(np.linspace(0, 1, 9))[:, :, :2].reshape(-1, 2)
    feet = FootPointSearch(profile, margin=radius + 2).find(points)
    assert np.abs(feet.distance - radius).max() < tolerance


def test_whole_model(document):
    operation = operation_on(document, plate_with_hole())
    profile, toolpath = profile_and_path(operation)
    assert profile.signed_areas() == pytest.approx([2400.0])
    assert_path_follows(profile, toolpath, 5.0, 1e-3)


def test_spline_is_taken_exactly(document):
    job = demonstration.build(document)
    profile, toolpath = profile_and_path(compat.operations(job)[0])
    assert profile.contours[0].curves[0].periodic
    assert_path_follows(profile, toolpath, 5.0, 0.03)


def test_inside(document):
    shape = Part.makeBox(100, 80, 10).cut(Part.makeBox(60, 40, 10, V(20, 20, 0)))
    operation = operation_on(
        document, shape, lambda s: isinstance(s, Part.Edge) and s.BoundBox.ZMin > 9 and 20 <= s.BoundBox.XMin
        and s.BoundBox.XMax <= 80, Side="Inside",
    )  # fmt: skip
    profile, toolpath = profile_and_path(operation)
    assert profile.signed_areas() == pytest.approx([-2400.0])
    assert_path_follows(profile, toolpath, 5.0, 1e-3)


@pytest.mark.parametrize(
    ("perimeter", "holes", "circles", "areas"),
    [
        (True, False, False, [2400.0]),
        (True, True, False, [2400.0, -np.pi * 12 * 9]),
        (False, False, True, [-np.pi * 49]),
        (True, True, True, [2400.0, -np.pi * 12 * 9, -np.pi * 49]),
    ],
)
def test_level_face(document, perimeter, holes, circles, areas):
    operation = operation_on(
        document, plate_with_hole(), top, processPerimeter=perimeter, processHoles=holes, processCircles=circles
    )
    profile, toolpath = profile_and_path(operation)
    assert sorted(profile.signed_areas()) == pytest.approx(sorted(areas))
    # An ellipse is a spline to FreeCAD, which it approximates.
    assert_path_follows(profile, toolpath, 5.0, 0.05)


def test_side_faces(document):
    operation = operation_on(document, Part.makeBox(60, 40, 10), side)
    profile, _ = profile_and_path(operation)
    assert profile.signed_areas() == pytest.approx([2400.0])


def test_open_edge_has_the_tool_on_the_side_of_the_path(document):
    shape = Part.makeBox(60, 40, 10)
    operation = operation_on(
        document, shape,
        lambda s: isinstance(s, Part.Edge) and s.BoundBox.ZMin > 9 and s.BoundBox.XLength > 1 and s.BoundBox.YMax < 1,
    )  # fmt: skip
    # At the height of the edge itself FreeCAD makes no path.
    operation.setExpression("FinalDepth", None)
    operation.FinalDepth = 0
    document.recompute()
    profile, toolpath = profile_and_path(operation)
    assert not profile.contours[0].closed
    normal = profile.at(0, [30.0])[1][0]
    cutting = toolpath.kind != Kind.RAPID
    assert cutting.any()
    outside = np.nanmean(toolpath.end[cutting, 1]) < 0
    assert normal[1] == pytest.approx(-1.0 if outside else 1.0)


def test_stock_to_leave_is_part_of_the_distance(document):
    operation = operation_on(document, Part.makeBox(60, 40, 10), OffsetExtra=0.3)
    assert base_geometry.path_radius(operation, 5.0) == pytest.approx(5.3)
    profile, toolpath = profile_and_path(operation)
    assert_path_follows(profile, toolpath, 5.3, 1e-3)


def test_path_on_the_contour_leaves_the_radius_to_the_control(document):
    operation = operation_on(document, Part.makeBox(60, 40, 10), UseComp=False)
    profile, toolpath = profile_and_path(operation)
    assert_path_follows(profile, toolpath, 0.0, 1e-3)
    side_ = base_geometry.side_of_path(profile, toolpath)
    area = 0.0
    for a, b in zip(toolpath.start[1:], toolpath.end[1:], strict=True):
        if np.isfinite(a[:2]).all():
            area += (a[0] * b[1] - a[1] * b[0]) / 2
    assert side_ == (Compensation.RIGHT if area > 0 else Compensation.LEFT)


def test_cone_is_refused(document):
    operation = operation_on(document, Part.makeCone(30, 20, 10))
    with pytest.raises(InputError, match="not prismatic"):
        profile_and_path(operation)


def test_motion_goes_to_a_program_and_back(document):
    operation = compat.operations(demonstration.build(document))[0]
    program = motion.program_of_path(operation.Path, "demo")
    assert len(program) == len(operation.Path.Commands) + 1
    same = motion.path_of_toolpath(operation.Path.Commands, program.toolpath, program.toolpath)
    assert same.toGCode() == operation.Path.toGCode()


def test_changed_moves_replace_their_commands_only(document):
    operation = compat.operations(demonstration.build(document))[0]
    before = motion.program_of_path(operation.Path, "demo").toolpath
    row = int(np.flatnonzero(before.kind == Kind.ARC)[3])
    # One arc becomes two.
    after = before.take(np.sort(np.append(np.arange(len(before)), row)))
    middle = before.take(slice(row, row + 1)).position(np.array([0.5]))[0, 0]
    end, start, sweep = after.end.copy(), after.start.copy(), after.sweep.copy()
    end[row], start[row + 1] = middle, middle
    sweep[[row, row + 1]] /= 2
    after = after.with_moves(end=end, start=start, sweep=sweep)
    path = motion.path_of_toolpath(operation.Path.Commands, before, after, ("mark (one)",))
    old, new = operation.Path.Commands, path.Commands
    assert new[0].Name == "(mark [one])"
    at = int(before.source[row]) - 1
    assert [c.toGCode() for c in new[1 : at + 1]] == [c.toGCode() for c in old[:at]]
    assert [c.toGCode() for c in new[at + 3 :]] == [c.toGCode() for c in old[at + 1 :]]
    read = motion.program_of_path(path, "again").toolpath
    assert np.nanmax(np.abs(read.end - after.end)) < 1e-6
    assert np.allclose(read.sweep, after.sweep, atol=1e-6)
    assert np.array_equal(read.feed, after.feed, equal_nan=True) or np.nanmax(np.abs(read.feed - after.feed)) < 1e-7
