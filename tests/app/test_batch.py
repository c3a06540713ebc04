# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a document file to a corrected document, a program and a report."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import FreeCAD
import numpy as np
import pytest

from millcorr import freecad_process, nc
from millcorr.app import batch, compat, convert, demonstration, documents, process, sources, views
from millcorr.cli import measuring_task
from millcorr.errors import FormatError, LimitError, RefusedError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.nc.toolpath import Kind


def files(directory: Path) -> set[str]:
    return {str(p.relative_to(directory)) for p in directory.rglob("*")}


def test_end_to_end(part_files, measured_file, tmp_path):
    original = part_files[0].read_bytes()
    output, program, report = tmp_path / "out.FCStd", tmp_path / "out.nc", tmp_path / "report"
    result = batch.correct_document(
        str(part_files[0]), operation="Profile", measured=str(measured_file[0]), points="contact",
        output=str(output), gcode=str(program), report=str(report),
    )  # fmt: skip
    assert part_files[0].read_bytes() == original
    assert not FreeCAD.listDocuments()
    assert {"report.html", "report.json", "deviations.csv", "profile.json"} <= files(report)
    assert not [name for name in files(tmp_path) if "millcorr-" in name]
    summary = json.loads((report / "report.json").read_text(encoding="utf-8"))
    assert summary["points"]["used"] == 200
    assert 0 < summary["verification"]["path_error_max"] <= 0.001

    # The posted program, read back by us, lies at the radius from the profile in the report.
    compensated = Profile.read_json(report / "profile.json")
    toolpath = nc.read(program).toolpath
    arcs = toolpath.take(toolpath.kind == Kind.ARC)
    points = arcs.position(np.linspace(0, 1, 33))[:, :, :2].reshape(-1, 2)
    off = FootPointSearch(compensated, margin=7.0).find(points).distance - 5.0
    assert np.abs(off).max() < 1e-3
    assert "millcorr" in program.read_text() and toolpath.feed[toolpath.kind == Kind.ARC] == pytest.approx(5.0)

    doc = FreeCAD.openDocument(str(output))
    assert [obj.Label for obj in compat.operations(compat.jobs(doc)[0])] == ["Profile corrected"]
    assert result.verification.path_error_max <= 0.001


def test_check_writes_the_report_only(part_files, measured_file, tmp_path):
    batch.correct_document(part_files[0], measured=measured_file[0], points="contact", report=tmp_path / "r")
    assert files(tmp_path) == {"r", *(f"r/{n}" for n in files(tmp_path / "r"))}


def test_open_document_keeps_the_dressup(part_files, measured_file):
    doc = FreeCAD.openDocument(str(part_files[0]))
    batch.correct_document(doc, measured=measured_file[0], points="contact")
    assert doc.getObject("DressupMillcorr") is not None
    with pytest.raises(RefusedError, match="already"):
        batch.correct_document(doc, measured=measured_file[0], points="contact")
    assert len([o for o in doc.Objects if o.Name.startswith(("Dressup", "Measurement"))]) == 2


FAILURES = {
    "unknown operation": ({"operation": "None"}, UsageError),
    "unknown setting": ({"speed": 3}, UsageError),
    "impossible setting": ({"output_moves": "circles"}, UsageError),
    "kind of points missing": ({"points": None}, UsageError),
    "missing measurement": ({"measured": "none.csv"}, FormatError),
    "over the limit": ({"limit": 1e-4}, LimitError),
    "wrong diameter": ({"tool_diameter": 6.0}, LimitError),
    "unknown nominal": ({"nominal": "#None"}, UsageError),
}


@pytest.mark.parametrize("name", FAILURES)
def test_failure_leaves_nothing(part_files, measured_file, tmp_path, name):
    change, error = FAILURES[name]
    (tmp_path / "out.nc").write_text("as it was")
    arguments = {"operation": "Profile", "measured": measured_file[0], "points": "contact"} | change
    places = {"output": tmp_path / "out.FCStd", "gcode": tmp_path / "out.nc", "report": tmp_path / "report"}
    doc = FreeCAD.openDocument(str(part_files[0]))
    before = [obj.Name for obj in doc.Objects]
    for document in (doc, str(part_files[0])):
        with pytest.raises(error) as caught:
            batch.correct_document(document, **arguments, **places)
        assert "\n" not in str(caught.value)
        assert files(tmp_path) == {"out.nc"} and (tmp_path / "out.nc").read_text() == "as it was"
        if document is doc:
            assert [obj.Name for obj in doc.Objects] == before
            assert [obj.Label for obj in compat.operations(compat.jobs(doc)[0])] == ["Profile"]
            FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("content", [None, b"", b"no archive", b"PK\x03\x04 cut off"])
def test_bad_document_is_refused(tmp_path, measured_file, content):
    path = tmp_path / "bad.FCStd"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(FormatError, match="bad.FCStd"):
        batch.correct_document(path, measured=measured_file[0], points="contact")
    assert not FreeCAD.listDocuments()


def test_coarse_posting_is_noticed(part_files, measured_file, tmp_path):
    doc = FreeCAD.openDocument(str(part_files[0]))
    compat.jobs(doc)[0].PostProcessorArgs = "--precision 2"
    with pytest.raises(LimitError):
        batch.correct_document(doc, measured=measured_file[0], points="contact", gcode=tmp_path / "out.nc")
    assert not files(tmp_path)


def test_nominal_from_files_and_objects(part_files, measured_file, tmp_path):
    curve = demonstration.contour_curve().toShape()
    curve.exportBrep(str(tmp_path / "nominal.brep"))
    curve.exportStep(str(tmp_path / "nominal.step"))
    profile = convert.profile_of_shape(curve)
    (tmp_path / "nominal.json").write_text(json.dumps(profile.as_dict()), encoding="utf-8")
    results = []
    written = [tmp_path / f"nominal.{suffix}" for suffix in ("brep", "step", "json")]
    for nominal in (None, "Part", "#Part", f"{part_files[0]}#Part", *written):
        results.append(
            batch.correct_document(part_files[0], measured=measured_file[0], points="contact", nominal=nominal)
        )
    wanted = results[0].summary()["deviation"]
    for result in results[1:]:
        assert result.summary()["deviation"] == pytest.approx(wanted, abs=1e-7)


def test_profile_of_file_and_object(part_files, tmp_path):
    part = sources.profile_of_object(part_files[0], "Part")
    assert part.total[0] == pytest.approx(223.978, abs=1e-3)
    (tmp_path / "bad.step").write_text("nothing")
    with pytest.raises(FormatError, match="bad.step"):
        sources.profile_of_file(tmp_path / "bad.step")


def test_requests_from_another_process(part_files, measured_file, tmp_path):
    answer = tmp_path / "answer.json"

    def ask(function, **arguments):
        process.answer({"function": function, "arguments": arguments}, str(answer))
        return json.loads(answer.read_text(encoding="utf-8"))

    good = ask("correct", document=str(part_files[0]), measured=str(measured_file[0]), points="contact")
    assert good["value"]["points"]["used"] == 200
    refused = ask("correct", document=str(part_files[0]), measured=str(measured_file[0]), points="contact", limit=1e-4)
    assert refused["error"] == "LimitError"
    assert ask("correct", document="none.FCStd")["error"] == "FormatError"
    assert ask("nothing")["error"] == "UsageError"
    assert ask("correct", document=str(part_files[0]), measured=3)["error"] == "MillcorrError"


def test_views_are_carried_over(tmp_path):
    old, new = tmp_path / "old.FCStd", tmp_path / "new.FCStd"
    with zipfile.ZipFile(old, "w") as archive:
        for name in ("Document.xml", "Shape.brp", "GuiDocument.xml", "Colour"):
            archive.writestr(name, f"old {name}")
    with zipfile.ZipFile(new, "w") as archive:
        for name in ("Document.xml", "Shape.brp", "Points.csv"):
            archive.writestr(name, f"new {name}")
    views.carry_over(old, new)
    views.carry_over(old, new)
    with zipfile.ZipFile(new) as archive:
        assert archive.namelist() == ["Document.xml", "Shape.brp", "Points.csv", "GuiDocument.xml", "Colour"]
        assert archive.read("Document.xml") == b"new Document.xml"


def test_several_parts_are_averaged_and_kept_in_the_document(part_files, measured_file, tmp_path):
    second = tmp_path / "second.csv"
    lines = measured_file[0].read_text(encoding="utf-8").splitlines()
    # The same part measured 20 um higher: the mean is the same, the file another.
    higher = [line.rsplit(",", 1)[0] + ",6.02" for line in lines[1:]]
    second.write_text("\n".join([lines[0], *higher]) + "\n", encoding="utf-8")
    output = tmp_path / "corrected.FCStd"
    both = batch.correct_document(
        part_files[0], measured=[measured_file[0], second], points="contact", filter="none", output=output
    )
    one = batch.correct_document(part_files[0], measured=measured_file[0], points="contact", filter="none")
    assert both.summary()["deviation"] == pytest.approx(one.summary()["deviation"], abs=1e-9)
    assert both.random_std == pytest.approx(0.0, abs=1e-9)
    with documents.opened(output) as document:
        (dressup,) = [obj for obj in document.Objects if obj.Name.startswith("DressupMillcorr")]
        assert len(dressup.FurtherParts) == 1
        assert dressup.FurtherParts[0].Digest != dressup.Measurement.Digest


def test_everything_said_of_a_file_stays_with_it_in_the_document(part_files, measured_file, tmp_path):
    """A mapped file in another frame gives the correction that the plain one gives, and again after reopening."""
    plain = batch.correct_document(part_files[0], measured=measured_file[0], points="contact", filter="none")
    rows = np.loadtxt(measured_file[0], delimiter=",", skiprows=1)
    turned = np.column_stack([100.0 - rows[:, 1], 200.0 + rows[:, 0], rows[:, 2]])
    strange = tmp_path / "strange.txt"
    strange.write_text("\n".join(f"P{k};{z:.9f};{y:.9f};{x:.9f}" for k, (x, y, z) in enumerate(turned)))
    mapping = tmp_path / "layout.toml"
    mapping.write_text('separator = "semicolon"\npoints = "contact"\n[columns]\nid = 1\nz = 2\ny = 3\nx = 4\n')
    output = tmp_path / "out.FCStd"
    result = batch.correct_document(
        part_files[0], measured=strange, mapping=mapping, work_offset=(100.0, 200.0, 0.0), work_rotation=90.0,
        filter="none", output=output,
    )  # fmt: skip
    # Nine decimals went into the file.
    np.testing.assert_allclose(result.deviation.value, plain.deviation.value, atol=2e-9)
    mapping.unlink()
    doc = FreeCAD.openDocument(str(output))
    dressup = doc.getObject("DressupMillcorr")
    dressup.touch()
    doc.recompute()
    assert dressup.DeviationMean.Value == pytest.approx(result.deviation.value.mean(), abs=1e-12)


def test_unknown_option_is_named(part_files, measured_file):
    with pytest.raises(UsageError, match="unknown setting colour"):
        batch.correct_document(part_files[0], measured=measured_file[0], points="contact", colour="red")


def test_operation_contour_for_a_measuring_program(part_files):
    """The exact profile of the operation, not the one its approximated path would show."""
    found = process.operation_contour(str(part_files[0]), None, False)
    profile = Profile.from_dict(found["profile"])
    assert found["tool_diameter"] == 10.0
    toolpath = nc.parse(found["path"].encode(), "path").toolpath
    arcs = toolpath.take(toolpath.kind == Kind.ARC)
    points = arcs.position(np.linspace(0, 1, 17))[:, :, :2].reshape(-1, 2)
    off = np.abs(FootPointSearch(profile, margin=7.0).find(points).distance - 5.0)
    assert 0.01 < np.median(np.sort(off)[-50:]) < 0.04
    with pytest.raises(UsageError, match="no operations called None"):
        process.operation_contour(str(part_files[0]), "None", False)


def test_a_measuring_program_of_a_document_takes_its_own_objects_as_nominal(part_files, tmp_path, monkeypatch):
    """The part's object and the operation's contour are the same curve: the same touches."""
    monkeypatch.setattr(freecad_process, "call", lambda name, arguments: process.FUNCTIONS[name](**arguments))
    written = []
    for nominal in (None, "#Part"):
        output = tmp_path / "probe.nc"
        told = measuring_task.measuring_program(
            document=part_files[0], nominal=nominal, dialect="linuxcnc", output=output,
            probe={"ball_radius": 1.0}, placement={"count": 12},
        )  # fmt: skip
        # The part stands from Z0 to Z12, and its path runs at Z-1.
        assert f"program     {output}" in told and "measured at Z6.000" in told
        written.append(nc.read(output).toolpath)
    assert len(written[0]) == len(written[1]) > 24
    ends = [np.nan_to_num(path.end) for path in written]
    # The object's outline may begin elsewhere: the same places to within the spacing that 12 points have.
    assert np.ptp(ends[0], axis=0) == pytest.approx(np.ptp(ends[1], axis=0), abs=np.ptp(ends[0], axis=0).max() / 4)
    with pytest.raises(UsageError, match="no objects called None"):
        measuring_task.measuring_program(
            document=part_files[0], nominal="#None", dialect="linuxcnc", output=tmp_path / "no.nc",
            probe={"ball_radius": 1.0}, placement={},
        )  # fmt: skip


def test_no_touch_where_the_model_has_no_wall(part_files, tmp_path, monkeypatch):
    """Half of the path's depth below Z0 is a height below the part."""
    monkeypatch.setattr(freecad_process, "call", lambda name, arguments: process.FUNCTIONS[name](**arguments))
    asked = {"dialect": "linuxcnc", "probe": {"ball_radius": 2.5}, "placement": {"count": 12}}
    with pytest.raises(RefusedError, match="no wall stands there"):
        measuring_task.measuring_program(document=part_files[0], output=tmp_path / "probe.nc", z=-0.5, **asked)
    with pytest.raises(UsageError, match="--safe-z 13 lies below"):
        measuring_task.measuring_program(document=part_files[0], output=tmp_path / "probe.nc", safe_z=13.0, **asked)
    assert not list(tmp_path.glob("probe*"))


def test_no_input_is_replaced(part_files, measured_file, tmp_path):
    own = tmp_path / "own.FCStd"
    own.write_bytes(part_files[0].read_bytes())
    with pytest.raises(UsageError, match="must stay untouched"):
        batch.correct_document(own, measured=measured_file[0], points="contact", output=own)
    with pytest.raises(UsageError, match="must stay untouched"):
        batch.correct_document(own, measured=measured_file[0], points="contact", gcode=measured_file[0])
    assert own.read_bytes() == part_files[0].read_bytes()
