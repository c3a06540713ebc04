# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every post processor of this FreeCAD makes a program that is read back, or fails by name."""

from __future__ import annotations

import FreeCAD
import pytest

from millcorr.app import batch, compat
from millcorr.errors import InputError, LimitError

VERSION = tuple(map(int, FreeCAD.Version()[:2]))
READ = "linuxcnc grbl mach3_mach4 centroid smoothie uccnc dynapath fablin marlin rrf KineticNCBeamicon2".split()
NO_CODE = "post processor {} makes is no G-code .* .{} .* as linuxcnc or grbl"
FAILING = {
    "comparams": "post processor comparams fails",
    "opensbp": NO_CODE.format("opensbp", "its line 1:"),
    "nccad": NO_CODE.format("nccad", "(the numbers|its line 1:)"),
    "rml": NO_CODE.format("rml", "its line 1:"),
    "dxf": NO_CODE.format("dxf", "its line 1:"),
}
OTHERWISE = "post processor {} does not write the path as it is: the posted program lacks the move to"
if VERSION < (1, 0):
    FAILING["fanuc"] = "post processor fanuc fails .*ToolType"
    FAILING["heidenhain"] = "post processor heidenhain fails .*Proxy"
    FAILING["jtech"] = "post processor jtech fails .*pythonopen"
    FAILING["philips"] = "post processor philips fails"
else:
    READ += "fanuc jtech estlcam refactored_linuxcnc refactored_grbl refactored_centroid refactored_mach3_mach4".split()
    READ += ["refactored_test"]
    FAILING["heidenhain"] = "post processor heidenhain fails .*ProfileEdges"
    FAILING["generic"] = NO_CODE.format("generic", "the numbers")
    # Wire cutting: no Z.
    FAILING["fangling"], FAILING["wedm"] = OTHERWISE.format("fangling"), OTHERWISE.format("wedm")
    FAILING["philips"] = "post processor philips fails .*getMainWindow"
if VERSION >= (1, 1):
    READ += ["refactored_masso_g3"]
    FAILING["svg"] = NO_CODE.format("svg", "its line 1:")
    FAILING["snapmaker"] = "post processor snapmaker fails .*an argument that is missing"
    FAILING["dynapath_4060"] = NO_CODE.format("dynapath_4060", "its line 5:")
    # Y and Z change places, for a horizontal machine.
    FAILING["philips"] = OTHERWISE.format("philips")


def posted(name, arguments, part_files, measured_file, gcode):
    doc = FreeCAD.openDocument(str(part_files[0]))
    job = compat.jobs(doc)[0]
    job.PostProcessor = name
    job.PostProcessorArgs = arguments
    return batch.correct_document(doc, measured=measured_file[0], points="contact", gcode=gcode)


@pytest.mark.parametrize("name", READ)
def test_posts_are_read_back(name, part_files, measured_file, tmp_path, monkeypatch):
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    result = posted(name, "", part_files, measured_file, tmp_path / "out.nc")
    assert 0 < result.verification.path_error_max <= 0.001
    # Nothing but the program is left, whatever name a post writes to.
    assert not list((tmp_path / "here").iterdir())


@pytest.mark.parametrize("name", FAILING)
def test_posts_that_fail_are_named(name, part_files, measured_file, tmp_path):
    with pytest.raises((InputError, LimitError), match=FAILING[name]):
        posted(name, "", part_files, measured_file, tmp_path / "out.nc")
    assert not list(tmp_path.iterdir())


def test_inches_with_four_decimals_are_proven_as_fine_as_they_are(part_files, measured_file, tmp_path):
    result = posted("linuxcnc", "--inches", part_files, measured_file, tmp_path / "out.nc")
    assert 0.001 < result.verification.path_error_max <= 0.0028
    assert "the posted program is proven within 2.8 um" in result.advice[-1]


def test_an_argument_that_a_post_does_not_know_is_said(part_files, measured_file, tmp_path):
    with pytest.raises(
        InputError, match="marlin fails on this job .an argument that is missing or"
    ):
        posted("marlin", "--inches", part_files, measured_file, tmp_path / "out.nc")


def test_uccnc_in_inches_is_read_as_its_comment_says(part_files, measured_file, tmp_path):
    """It states no G20: the control's profile has the unit. It is asked for four decimals."""
    if VERSION >= (1, 1):
        # That of 1.1 leaves I and J in millimetres.
        with pytest.raises(LimitError, match=OTHERWISE.format("uccnc")):
            posted("uccnc", "--inches", part_files, measured_file, tmp_path / "out.nc")
        return
    result = posted("uccnc", "--inches", part_files, measured_file, tmp_path / "out.nc")
    assert "G20" not in (tmp_path / "out.nc").read_text()
    assert 0 < result.verification.path_error_max <= 0.0028
    assert "states no unit" in result.advice[-1] and "no finer than" in result.advice[-2]
