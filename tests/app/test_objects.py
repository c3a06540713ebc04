# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measurement, dressup and profile through a document's life."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import FreeCAD
import numpy as np
import Part
import pytest

from millcorr.app import (
    batch,
    candidates,
    compat,
    convert,
    correction,
    demonstration,
    dressup,
    measurement_object,
    motion,
    profile_object,
    properties,
)
from millcorr.errors import FormatError, InputError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.nc.toolpath import Kind


@pytest.fixture
def corrected(part_files, measured_file):
    """The demonstration document, opened, with a dressup and a profile on it."""
    doc = FreeCAD.openDocument(str(part_files[0]))
    doc.UndoMode = 1
    base = batch.find_operation(doc)
    measurement = measurement_object.create(doc, measured_file[0], "contact")
    obj = dressup.create(base, measurement, Filter="mean:5")
    profile = profile_object.create(obj)
    doc.recompute()
    return doc, obj, profile


def valid(obj):
    return "Invalid" not in obj.State


def order(doc):
    return [obj.Label for obj in compat.operations(compat.jobs(doc)[0])]


def words(obj):
    return obj.Path.toGCode()


def reopened(doc, tmp_path):
    path = str(tmp_path / "again.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    return FreeCAD.openDocument(path)


def test_dressup_corrects(corrected, measured_file):
    doc, obj, profile = corrected
    assert valid(obj) and valid(profile)
    assert order(doc) == ["Profile corrected"]
    error = measured_file[1]
    # What was measured is the machine's error on top of what FreeCAD's path itself is off.
    assert obj.DeviationMean.Value == pytest.approx(error.mean(), abs=1e-3)
    assert obj.PointsUsed == len(error) and obj.PointsRejected == 0
    assert 0 < obj.PathError.Value <= 0.001
    assert obj.Source == "cmm.csv" and len(obj.Digest) == 64 and obj.Corrected
    assert any("millcorr" in c.Name for c in obj.Path.Commands)


def test_corrected_path_is_the_offset_of_the_compensated_profile(corrected):
    _, obj, profile = corrected
    target = convert.profile_of_shape(profile.Shape)
    toolpath = motion.program_of_path(obj.Path, "corrected").toolpath
    arcs = toolpath.take(toolpath.kind == Kind.ARC)
    points = arcs.position(np.linspace(0, 1, 21))[:, :, :2].reshape(-1, 2)
    feet = FootPointSearch(target, margin=7.0).find(points)
    assert np.abs(feet.distance - 5.0).max() < 1e-3


def test_without_measurement_the_path_becomes_exact(part_files):
    doc = FreeCAD.openDocument(str(part_files[0]))
    obj = dressup.create(batch.find_operation(doc))
    doc.recompute()
    assert valid(obj) and obj.PathError.Value <= 0.001 and obj.LargestCorrection.Value == 0
    nominal = convert.profile_of_shape(demonstration.contour_curve().toShape())
    toolpath = motion.program_of_path(obj.Path, "exact").toolpath
    arcs = toolpath.take(toolpath.kind == Kind.ARC)
    points = arcs.position(np.linspace(0, 1, 21))[:, :, :2].reshape(-1, 2)
    assert np.abs(FootPointSearch(nominal, margin=7.0).find(points).distance - 5.0).max() < 1e-3


@pytest.mark.parametrize("case", ["inside", "control holds the radius", "several depths", "stock to leave", "climb"])
def test_kinds_of_operation(document, case):
    job = demonstration.build(document, side="Inside" if case == "inside" else "Outside")
    operation = compat.operations(job)[0]
    distance, inward = 5.0, -1.0 if case == "inside" else 1.0
    if case == "control holds the radius":
        operation.UseComp, distance = False, 0.0
    elif case == "several depths":
        operation.StepDown = 4.0
    elif case == "stock to leave":
        operation.OffsetExtra, distance = 0.25, 5.25
    elif case == "climb":
        operation.Direction = "CCW" if operation.Direction == "CW" else "CW"
    document.recompute()
    assert operation.Path.Commands
    obj = dressup.create(operation)
    document.recompute()
    assert valid(obj), obj.getStatusString() if hasattr(obj, "getStatusString") else ""
    nominal = convert.profile_of_shape(demonstration.contour_curve().toShape())
    toolpath = motion.program_of_path(obj.Path, case).toolpath
    arcs = toolpath.take(toolpath.kind == Kind.ARC)
    assert len(arcs) and (case != "several depths" or len(np.unique(arcs.end[:, 2].round(3))) == 4)
    points = arcs.position(np.linspace(0, 1, 21))[:, :, :2].reshape(-1, 2)
    off = FootPointSearch(nominal, margin=7.0).find(points).distance - inward * distance
    assert np.abs(off).max() < 1e-3


def test_survives_saving(corrected, tmp_path):
    doc, obj, _ = corrected
    before, digest = words(obj), obj.Digest
    doc = reopened(doc, tmp_path)
    obj = doc.getObject("DressupMillcorr")
    assert isinstance(obj.Proxy, dressup.DressupMillcorr)
    assert words(obj) == before and obj.Digest == digest
    assert isinstance(doc.getObject("MillcorrProfile").Proxy, profile_object.ProfileObject)
    obj.touch()
    doc.recompute()
    assert valid(obj) and words(obj) == before


def test_recompute_is_repeatable_and_follows_its_inputs(corrected):
    doc, obj, profile = corrected
    first, length = words(obj), profile.Shape.Length
    obj.touch()
    doc.recompute()
    assert words(obj) == first
    obj.Gain = 0.5
    doc.recompute()
    assert words(obj) != first and profile.Shape.Length != length
    obj.Gain = 1.0
    doc.recompute()
    assert words(obj) == first


def test_new_measurement_is_taken_up(corrected, tmp_path):
    doc, obj, _ = corrected
    before, digest = words(obj), obj.Digest
    lines = Path(obj.Measurement.File).read_text(encoding="utf-8").splitlines()
    other = tmp_path / "other.csv"
    other.write_text("\n".join([lines[0], *lines[1::2]]) + "\n", encoding="utf-8")
    measurement_object.load(obj.Measurement, other)
    doc.recompute()
    assert obj.Digest != digest and obj.Source == "other.csv" and words(obj) != before
    assert obj.Measurement.Count == 100


def test_other_path_than_the_measured_one_is_noticed(corrected):
    doc, obj, _ = corrected
    obj.Base.setExpression("FinalDepth", None)
    obj.Base.FinalDepth = 2.0
    doc.recompute()
    assert valid(obj) and any("is not the one" in warning for warning in obj.Warnings)


def test_undo_and_redo(corrected):
    doc, obj, _ = corrected
    first = words(obj)
    doc.openTransaction("gain")
    obj.Gain = 0.5
    doc.recompute()
    doc.commitTransaction()
    second = words(obj)
    doc.undo()
    doc.recompute()
    assert obj.Gain == 1.0 and words(obj) == first
    doc.redo()
    doc.recompute()
    assert obj.Gain == 0.5 and words(obj) == second


def test_undo_of_the_dressup_gives_the_operation_back(part_files, measured_file):
    doc = FreeCAD.openDocument(str(part_files[0]))
    doc.UndoMode = 1
    doc.openTransaction("dressup")
    measurement = measurement_object.create(doc, measured_file[0], "contact")
    dressup.create(batch.find_operation(doc), measurement)
    doc.recompute()
    doc.commitTransaction()
    assert order(doc) == ["Profile corrected"]
    doc.undo()
    doc.recompute()
    assert order(doc) == ["Profile"]
    doc.redo()
    doc.recompute()
    assert order(doc) == ["Profile corrected"]
    obj = doc.getObject("DressupMillcorr")
    assert valid(obj) and obj.Path.Commands


def test_deleting_puts_the_operation_back(corrected):
    doc, obj, profile = corrected
    doc.removeObject(profile.Name)
    obj.Proxy.onDelete(obj)
    doc.removeObject(obj.Name)
    doc.recompute()
    assert order(doc) == ["Profile"]


def test_place_among_other_operations_is_kept(part_files):
    doc = FreeCAD.openDocument(str(part_files[0]))
    job = compat.jobs(doc)[0]
    last = compat.make_profile(job, "Last")
    base = compat.operations(job)[0]
    obj = dressup.create(base)
    assert order(doc) == [obj.Label, last.Label]
    obj.Proxy.onDelete(obj)
    assert order(doc) == [base.Label, last.Label]


@pytest.mark.parametrize(
    ("setting", "value"), [("Limit", 1e-4), ("Gain", 9.0), ("Filter", "nonsense"), ("ToolDiameter", 6.0)]
)
def test_failure_clears_the_path_and_shows(corrected, setting, value):
    doc, obj, profile = corrected
    setattr(obj, setting, value)
    doc.recompute()
    assert not valid(obj) and not obj.Path.Commands
    assert obj.DeviationMean.Value == 0 and not obj.Warnings and not obj.Source
    assert profile.Shape.isNull()


def test_failure_is_not_posted(corrected):
    doc, obj, _ = corrected
    obj.Limit = 1e-4
    doc.recompute()
    text = compat.post(compat.jobs(doc)[0])
    assert "G2 " not in text and "G1 " not in text


def test_inactive_operation_gives_an_empty_path(corrected):
    doc, obj, _ = corrected
    obj.Base.Active = False
    doc.recompute()
    assert valid(obj) and not obj.Path.Commands
    obj.Base.Active = True
    doc.recompute()
    assert obj.Path.Commands


def test_posted_once_and_only_the_corrected_path(corrected, part_files):
    doc, obj, _ = corrected
    text = compat.post(compat.jobs(doc)[0], "--precision 4")
    assert text.count("M6 T1") == 1
    assert text.count("begin operation: Profile corrected") == 1
    assert "begin operation: Profile\n" not in text
    assert "millcorr" in text


def test_dressup_does_not_carry_tool_or_coolant(corrected):
    _, obj, _ = corrected
    assert not {"ToolController", "CoolantMode", "Active", "Group"} & set(obj.PropertiesList)
    assert "Dressup" in obj.Name


def test_second_dressup_needs_a_new_measurement(corrected):
    doc, obj, _ = corrected
    second = dressup.create(obj, obj.Measurement)
    doc.recompute()
    assert not valid(second) and not second.Path.Commands
    assert valid(obj)


def test_dressup_on_a_dressed_operation_is_refused(corrected):
    _, obj, _ = corrected
    with pytest.raises(InputError, match="dressup"):
        dressup.create(obj.Base)


def test_properties_of_older_documents_are_completed(corrected, tmp_path):
    doc, obj, _ = corrected
    obj.removeProperty("DeadBand")
    obj.removeProperty("Warnings")
    doc = reopened(doc, tmp_path)
    obj = doc.getObject("DressupMillcorr")
    assert {"DeadBand", "Warnings"} <= set(obj.PropertiesList)
    for row in dressup.PROPERTIES:
        assert row.name in obj.PropertiesList and obj.getGroupOfProperty(row.name) == row.group


def test_only_what_can_be_a_nominal_is_offered_for_one(corrected):
    doc, obj, compensated = corrected
    drawing, origin = doc.addObject("Part::Box", "Drawing"), doc.addObject("App::Part", "Assembly").Origin
    empty = doc.addObject("Part::Feature", "Empty")
    doc.recompute()
    job = compat.parent_job(obj)
    names = {obj.Name for obj in candidates.shapes(doc)}
    assert {drawing.Name, "Part", job.Model.Group[0].Name} <= names
    tool = job.Tools.Group[0].Tool
    junk = [
        *origin.OriginFeatures,
        job.Stock,
        job.Model,
        tool,
        *tool.OutListRecursive,
        compensated,
        empty,
        obj,
        obj.Base,
    ]
    assert not names & {obj.Name for obj in junk}


def test_every_property_is_documented():
    for table in (dressup.PROPERTIES, measurement_object.PROPERTIES, profile_object.PROPERTIES):
        assert len({row.name for row in table}) == len(table)
        assert all(isinstance(row, properties.Property) and row.doc for row in table)


# Measurement ------------------------------------------------------------------------------------------------


def test_measurement_keeps_the_file_s_bytes(document, measured_file, tmp_path):
    obj = measurement_object.create(document, measured_file[0], "contact")
    document.recompute()
    assert obj.Count == 200 and obj.Levels == 1 and obj.Source == "cmm.csv"
    doc = reopened(document, tmp_path)
    obj = doc.getObject("Measurement")
    assert Path(obj.File).read_bytes() == measured_file[0].read_bytes()
    assert len(measurement_object.measurement_of(obj)) == 200


def test_measurement_from_memory(document):
    obj = measurement_object.create(document, b"x,y\n1,2\n3,4\n5,6\n", "contact", name="probe.csv")
    document.recompute()
    assert obj.Count == 3 and obj.Label == "probe.csv"


@pytest.mark.parametrize("data", [b"", b"x,y,z\n", b"\0\1\2", b"x,y,z\n1,2,three\n", b"x,y,z\n1,2,NaN\n"])
def test_bad_measurement_leaves_nothing(document, tmp_path, data):
    path = tmp_path / "bad.csv"
    path.write_bytes(data)
    with pytest.raises(FormatError, match="bad.csv") as caught:
        measurement_object.create(document, path, "contact")
    assert "tmp" not in str(caught.value).replace(str(tmp_path), "")
    assert not document.Objects


def test_measurement_without_kind_of_points_is_refused(document, measured_file):
    with pytest.raises(UsageError):
        measurement_object.create(document, measured_file[0])
    assert not document.Objects


def test_missing_measurement_is_refused(document, tmp_path):
    with pytest.raises(FormatError, match="no such file"):
        measurement_object.create(document, tmp_path / "none.csv", "contact")


# Documents of other places --------------------------------------------------------------------------------------

WITHOUT_ADDON = """
import FreeCAD
import Part
doc = FreeCAD.openDocument({document!r})
obj = doc.getObject("DressupMillcorr")
before = obj.Path.toGCode()
obj.touch()
doc.recompute()
after = obj.Path.toGCode()
doc.saveAs({saved!r})
with open({result!r}, "w") as stream:
    stream.write(repr((obj.Proxy is None, len(before), before == after)))
"""


def test_document_keeps_its_path_without_the_addon(corrected, tmp_path):
    doc, obj, _ = corrected
    before = words(obj)
    doc.saveAs(str(tmp_path / "doc.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    script, result = tmp_path / "without_addon.py", tmp_path / "result"
    script.write_text(
        WITHOUT_ADDON.format(
            document=str(tmp_path / "doc.FCStd"), saved=str(tmp_path / "saved.FCStd"), result=str(result)
        ),
        encoding="utf-8",
    )
    (tmp_path / "user").mkdir()
    environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    environment["FREECAD_USER_DATA"] = str(tmp_path / "user")
    subprocess.run(
        ["freecadcmd", str(script)], env=environment, stdin=subprocess.DEVNULL, capture_output=True, check=False
    )
    assert result.read_text() == repr((True, len(before), True))
    doc = FreeCAD.openDocument(str(tmp_path / "saved.FCStd"))
    assert words(doc.getObject("DressupMillcorr")) == before


def test_document_of_another_version(part_files, measured_file, tmp_path):
    """Every version leaves a document; every version corrects those of the others, dead proxies and all."""
    store = Path(os.environ["MILLCORR_DOCUMENTS"])
    own = "".join(FreeCAD.Version()[:2])
    for path in sorted(store.glob("job-*.FCStd")):
        doc = FreeCAD.openDocument(str(path))
        base = batch.find_operation(doc)
        if "-020" in path.name and own != "020":
            assert base.Proxy is None
        program = motion.program_of_path(compat.path_of(base), base.Label)
        sys.path.insert(0, str(Path(__file__).parent))
        points = tmp_path / f"{path.stem}.csv"
        from conftest import write_measurement

        write_measurement(points, program, demonstration.TOOL_DIAMETER / 2)
        FreeCAD.closeDocument(doc.Name)
        output, gcode = tmp_path / path.name, tmp_path / f"{path.stem}.nc"
        result = batch.correct_document(path, measured=points, points="contact", output=output, gcode=gcode)
        assert result.verification.path_error_max <= 0.001
        assert "G2 " in gcode.read_text() and output.exists()
    target = store / f"job-{own}.FCStd"
    if not target.exists():
        target.write_bytes(part_files[0].read_bytes())


def test_contour_check_as_shapes(corrected):
    """Path, contour, points and magnified deviations of the operation, each where it must lie."""
    doc, obj, _ = corrected
    shapes = {}
    for shown in ("nominal", "path", "measured points", "contact points", "deviations"):
        shape = profile_object.create(obj, shown)
        shape.Magnification = 100.0
        doc.recompute()
        assert valid(shape)
        shapes[shown] = shape.Shape
    count = obj.PointsUsed
    measured = measurement_object.measurement_of(obj.Measurement).points
    assert len(shapes["measured points"].Vertexes) == len(shapes["contact points"].Vertexes) == count == len(measured)
    nominal = shapes["nominal"]
    for vertex in shapes["path"].Vertexes[::7]:
        flat = Part.Vertex(vertex.X, vertex.Y, 0.0)
        # FreeCAD's own arcs along the spline err by up to 22 um.
        assert abs(nominal.distToShape(flat)[0] - 5.0) < 0.04
    for k in range(0, count, 29):
        contact, line = shapes["contact points"].Vertexes[k], shapes["deviations"].Edges[k]
        off = nominal.distToShape(Part.Vertex(contact.X, contact.Y, 0.0))[0]
        assert line.Length == pytest.approx(100 * off, abs=2e-4)


def distances(doc, obj):
    """Distance of the dressup's contour-following moves from the exact profile of the demonstration part."""
    program = motion.program_of_path(obj.Path, "now")
    toolpath = program.toolpath
    cutting = toolpath.take((toolpath.kind == Kind.ARC) | (toolpath.kind == Kind.CUBIC))
    points = cutting.position(np.linspace(0, 1, 9))[:, :, :2].reshape(-1, 2)
    profile = correction.correct(obj).result.nominal
    return FootPointSearch(profile, margin=8.0).find(points).distance


def test_single_piece_in_two_stages_of_one_dressup(part_files, tmp_path):
    """First cut leaves 0.4 mm; what was measured then goes into the same dressup, which finishes the part."""
    doc = FreeCAD.openDocument(str(part_files[0]))
    base = batch.find_operation(doc)
    obj = dressup.create(base, LeaveStock=0.4, OutputMoves="arcs")
    doc.recompute()
    assert valid(obj)
    far = distances(doc, obj)
    # Leads of arcs end elsewhere; what follows the contour is within a micrometre of its parallel.
    following = np.abs(far - 5.4) < 0.1
    assert following.mean() > 0.9 and np.abs(far[following] - 5.4).max() < 0.0011
    assert "first cut, leaves 0.4 mm" in words(obj)

    # A machine that yields by a tenth of what it cuts left 0.44 mm.
    profile = correction.correct(obj).result.nominal
    s = np.linspace(0.0, float(profile.total[0]), 150, endpoint=False)
    points, normals = profile.at(0, s)
    points = points + 0.44 * normals
    path = tmp_path / "first.csv"
    path.write_text("x,y,z\n" + "\n".join(f"{x:.6f},{y:.6f},-0.5" for x, y in points))
    obj.Measurement = measurement_object.create(doc, path, "contact")
    doc.recompute()
    assert not valid(obj) and not obj.Path.Commands, "a first cut is made before anything is measured"
    obj.LeaveStock, obj.Method, obj.Depth, obj.Allowance = 0.0, "transfer", [0.4], [0.4]
    doc.recompute()
    assert valid(obj)
    near = distances(doc, obj)
    # delta/(H - delta) = 0.04/0.36 of the 0.44 mm that are really left.
    wanted = 5.0 - 0.44 * 0.04 / 0.36
    following = np.abs(near - wanted) < 0.02
    assert following.mean() > 0.9 and np.abs(near[following] - wanted).max() < 0.0015
