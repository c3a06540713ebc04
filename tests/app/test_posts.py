# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every post processor of FreeCAD 0.20 makes a program that is read back, or fails by name."""

from __future__ import annotations

import FreeCAD
import pytest

from millcorr.app import batch, compat
from millcorr.errors import InputError

pytestmark = pytest.mark.skipif(FreeCAD.Version()[0] != "0", reason="these are the posts of FreeCAD 0.20")

READ = "linuxcnc grbl mach3_mach4 centroid smoothie uccnc dynapath fablin marlin rrf KineticNCBeamicon2".split()
FAILING = {
    "fanuc": "post processor fanuc fails .*ToolType",
    "heidenhain": "post processor heidenhain fails .*Proxy",
    "jtech": "post processor jtech fails .*pythonopen",
    "philips": "post processor philips fails",
    "comparams": "post processor comparams fails",
    "opensbp": "post processor opensbp makes is no G-code .* .its line 1: .* as linuxcnc or grbl",
    "nccad": "post processor nccad makes is no G-code .* .the numbers .* as linuxcnc or grbl",
    "rml": "post processor rml makes is no G-code .* .its line 1: .* as linuxcnc or grbl",
    "dxf": "post processor dxf makes is no G-code .* .its line 1: .* as linuxcnc or grbl",
}


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
    with pytest.raises(InputError, match=FAILING[name]):
        posted(name, "", part_files, measured_file, tmp_path / "out.nc")
    assert not list(tmp_path.iterdir())


def test_inches_with_four_decimals_are_proven_as_fine_as_they_are(part_files, measured_file, tmp_path):
    result = posted("linuxcnc", "--inches", part_files, measured_file, tmp_path / "out.nc")
    assert 0.001 < result.verification.path_error_max <= 0.0028
    assert "the posted program is proven within 2.8 um" in result.advice[-1]


def test_an_argument_that_a_post_does_not_know_is_said(part_files, measured_file, tmp_path):
    with pytest.raises(InputError, match="marlin fails on this job .an argument it does not know"):
        posted("marlin", "--inches", part_files, measured_file, tmp_path / "out.nc")


def test_uccnc_in_inches_is_read_as_its_comment_says(part_files, measured_file, tmp_path):
    """It states no G20: the control's profile has the unit. It is asked for four decimals."""
    result = posted("uccnc", "--inches", part_files, measured_file, tmp_path / "out.nc")
    assert "G20" not in (tmp_path / "out.nc").read_text()
    assert 0 < result.verification.path_error_max <= 0.0028
    assert "states no unit" in result.advice[-1] and "no finer than" in result.advice[-2]
