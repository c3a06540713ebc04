# SPDX-License-Identifier: LGPL-2.1-or-later
"""A batch from a script in FreeCADCmd: documents and programs mixed."""

from __future__ import annotations

import io

import FreeCAD
import pytest

from millcorr.cli import jobs


@pytest.mark.thorough
def test_batch_of_document_and_program_from_freecad(part_files, measured_file, tmp_path):
    path = tmp_path / "night.toml"
    path.write_text(
        f"[defaults]\npoints = 'contact'\nmeasured = {str(measured_file[0])!r}\n"
        f"[[job]]\nname = 'document'\ndocument = {str(part_files[0])!r}\noutput = 'out.FCStd'\n"
        f"[[job]]\nname = 'program'\nprogram = {str(part_files[1])!r}\ntool-diameter = 10\noutput = 'out.nc'\n"
        f"[[job]]\nname = 'wrong'\ndocument = {str(part_files[0])!r}\noperation = 'None'\noutput = 'no.FCStd'\n"
    )
    done = jobs.run(path, out=io.StringIO())
    assert [(o.name, o.status) for o in done] == [("document", 0), ("program", 0), ("wrong", 2)], [o.text for o in done]
    assert "no operations called None" in done[2].text
    doc = FreeCAD.openDocument(str(tmp_path / "out.FCStd"))
    assert doc.getObject("DressupMillcorr") is not None
    assert "millcorr" in (tmp_path / "out.nc").read_text()
    assert not (tmp_path / "no.FCStd").exists()
