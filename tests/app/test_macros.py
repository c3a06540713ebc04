# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros without a window: each ends with a file that can be used."""

from __future__ import annotations

import re
from pathlib import Path

import FreeCAD
import pytest

from millcorr import nc
from millcorr.app import batch, compat, rounds
from millcorr.process import setup_file

MACROS = Path(__file__).resolve().parents[2] / "resources" / "macros"


def run(name, directory, **constants):
    """Run a macro in FreeCADCmd, with other constants in its lines."""
    text = (MACROS / f"{name}.FCMacro").read_text(encoding="utf-8")
    for constant, value in constants.items():
        text, count = re.subn(rf"(?m)^{constant} = [^#\n]*", f"{constant} = {value!r}  ", text)
        assert count == 1, constant
    text = text.replace('DOCUMENT, OUTPUT = "JOB.FCStd", ', f"DOCUMENT, OUTPUT = {str(directory / 'JOB.FCStd')!r}, ")
    for output in ('"JOB-corrected.FCStd"', '"probe.ngc"'):
        text = text.replace(output, repr(str(directory / output.strip('"'))))
    exec(compile(text, name, "exec"), {"__name__": name})


@pytest.fixture
def job(part_files, tmp_path):
    """A copy of the demonstration in a directory whose name a careless macro would trip over."""
    directory = tmp_path / 'shop\'s "own"'
    directory.mkdir()
    (directory / "JOB.FCStd").write_bytes(part_files[0].read_bytes())
    return directory


def test_correct_document(job, measured_file):
    run("CorrectDocument", job, DOCUMENT=str(job / "JOB.FCStd"), MEASURED=str(measured_file[0]))
    assert (job / "JOB-report" / "report.html").exists() and "millcorr" in (job / "JOB-corrected.nc").read_text()
    assert (job / "JOB-corrected.FCStd").exists()


def test_correct_selected_operation(job, measured_file):
    run("CorrectSelectedOperation", job, MEASURED=str(measured_file[0]), POINTS="contact")
    doc = FreeCAD.openDocument(str(job / "JOB-corrected.FCStd"))
    top = batch.find_operation(doc)
    assert top.Label == "Profile corrected" and len(rounds.parts_of(top)) == 1


def test_measuring_program(job):
    run("MeasuringProgram", job)
    low = nc.read(job / "probe.ngc").toolpath.end[:, 2]
    assert min(z for z in low if z == z) == 6.0


def test_the_setup_of_the_demonstration_fits_it(part_files):
    setup = setup_file.load(MACROS.parent / "setups" / "demonstration.toml")
    doc = FreeCAD.openDocument(str(part_files[0]))
    controller = compat.tool_controller(batch.find_operation(doc))
    assert setup.tool.diameter_mm == controller.Tool.Diameter.Value
    assert setup.tool.spindle_rpm == controller.SpindleSpeed
    assert setup.stock.axial_depth_mm == doc.getObject("Part").Shape.BoundBox.ZLength


def test_a_report_needs_no_post(part_files, measured_file, tmp_path, monkeypatch):
    from millcorr.app import dressup, measurement_object

    doc = FreeCAD.openDocument(str(part_files[0]))
    obj = dressup.create(batch.find_operation(doc), measurement_object.create(doc, measured_file[0], "contact"))
    doc.recompute()

    def no_post(*given, **named):
        raise AttributeError("ToolType")

    monkeypatch.setattr(compat, "post", no_post)
    batch.export_report(obj, tmp_path / "report")
    page = (tmp_path / "report" / "report.html").read_text(encoding="utf-8")
    assert "gave no program (ToolType)" in page and "as FreeCAD posted it" not in page
