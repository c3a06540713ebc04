# SPDX-License-Identifier: LGPL-2.1-or-later
"""Serial production from documents: judged, kept or corrected, recorded in a journal."""

from __future__ import annotations

from pathlib import Path

import FreeCAD
import numpy as np
import pytest

from millcorr import freecad_process, nc
from millcorr.__main__ import main
from millcorr.app import batch, compat, convert, correction, demonstration, documents, motion, process
from millcorr.errors import InputError, LimitError, RefusedError, UsageError
from millcorr.production import journal
from millcorr.readers import text
from millcorr.virtual.simulated_machine import ErrorField, SimulatedMachine


def files(directory: Path) -> set[str]:
    return {str(p.relative_to(directory)) for p in directory.rglob("*")}


class Series:
    """The demonstration's document, part after part: cut, measured, and given to the journal."""

    def __init__(self, document: Path, directory: Path, **options) -> None:
        self.document, self.directory, self.options, self.count = Path(document), directory, options, 0
        self.journal = directory / "shop.journal"

    def program(self) -> nc.Program:
        """What the document cuts now."""
        with documents.opened(self.document) as doc:
            top = batch.find_operation(doc)
            return motion.program_of_path(compat.path_of(top), top.Label)

    def next(self, excess: float, **changed):
        """A part with so much excess, um; the document for the next one."""
        self.count += 1
        toolpath = self.program().toolpath
        machine = SimulatedMachine(ErrorField(constant=excess * 1e-3, harmonics=((2, 1e-3, 0.3),)))
        with documents.opened(self.document) as doc:
            nominal = convert.profile_of_shape(doc.getObjectsByLabel("Part")[0].Shape)
        part = machine.cut(toolpath, demonstration.TOOL_DIAMETER / 2, nominal, seed=1)
        points = part.measure(200, z=-0.5 - 1e-3 * self.count, seed=self.count)
        measured = self.directory / f"part-{self.count}.csv"
        text.write(measured, points)
        output = self.directory / f"JOB-{self.count}.FCStd"
        options = {"points": "contact", "journal": self.journal, "control": "ewma:2", "control_limit": 0.004}
        try:
            return batch.correct_document(
                self.document, measured=measured, output=output, **(options | self.options | changed)
            )
        finally:
            if output.exists():
                self.document = output

    @property
    def entries(self):
        (chain,) = journal.read(self.journal)
        return chain.entries


def test_a_series_of_documents(part_files, tmp_path):
    """20 um of excess, and 3, 5, 6 um more: corrected, kept, kept, corrected by 4.625 um."""
    series = Series(part_files[0], tmp_path)
    first = series.next(20.0, gcode=tmp_path / "1.nc", report=tmp_path / "report")
    assert first.correction.largest == pytest.approx(0.021, abs=1e-3)
    assert "part 1" in (tmp_path / "report" / "report.html").read_text(encoding="utf-8")
    kept = series.next(23.0, gcode=tmp_path / "2.nc", report=tmp_path / "kept")
    assert "NOT CORRECTED" in (tmp_path / "kept" / "report.html").read_text(encoding="utf-8")
    assert (tmp_path / "JOB-2.FCStd").read_bytes() == (tmp_path / "JOB-1.FCStd").read_bytes()
    assert kept.advice[0].startswith("NOT CORRECTED") and "very bytes of JOB-1.FCStd" in kept.advice[0]
    moves = [nc.read(tmp_path / f"{n}.nc").toolpath for n in (1, 2)]
    # Documents keep six decimals: what is posted from a stored path may differ in its fourth one.
    np.testing.assert_allclose(moves[0].end, moves[1].end, rtol=0, atol=1.01e-4)
    series.next(25.0)
    fourth = series.next(26.0)
    assert [e.decision for e in series.entries] == ["direct", "keep", "keep", "smoothed"]
    assert [e.corrected for e in series.entries] == [True, False, False, True]
    assert [round(float(np.median(e.state)) * 1000, 1) for e in series.entries] == pytest.approx(
        [0.0, 1.5, 3.2, 0.0], abs=0.3
    )
    # Both corrections together; the waves of 1 um are corrected once and are not seen again.
    assert float(np.median(series.entries[3].correction)) == pytest.approx(-0.0246, abs=5e-4)
    # What was smoothed is in the document: FreeCAD may compute it again, and the journal is not asked.
    series.journal.rename(tmp_path / "elsewhere")
    doc = FreeCAD.openDocument(str(tmp_path / "JOB-4.FCStd"))
    top = batch.find_operation(doc)
    before = [line for line in motion.program_of_path(compat.path_of(top), "x").text.splitlines() if line[0] != "("]
    top.touch()
    doc.recompute()
    after = [line for line in motion.program_of_path(compat.path_of(top), "x").text.splitlines() if line[0] != "("]
    assert after == before and fourth.regeneration.changed > 0
    # With another part it is that part's own deviation again.
    place, seen = top.Smoothed, correction.correct(top).result
    assert np.median(seen.correction.courses[0](np.arange(200.0))[0]) == pytest.approx(-0.0246, abs=5e-4)
    top.Smoothed = place.replace('"measured": ["', '"measured": ["0')
    own = correction.correct(top).result
    assert np.median(own.correction.courses[0](np.arange(200.0))[0]) == pytest.approx(-0.026, abs=5e-4)


def test_a_series_refuses_and_leaves_nothing(part_files, tmp_path):
    series = Series(part_files[0], tmp_path)
    series.next(20.0)
    there = files(tmp_path) | {"part-2.csv"}
    with pytest.raises(LimitError, match="--control-alarm"):
        series.next(50.0, control_alarm=0.02)
    assert files(tmp_path) == there and len(series.entries) == 1
    # The same measurement, for the same output: a second use, or the same run where that is asked for.
    again = {"document": str(part_files[0]), "measured": str(tmp_path / "part-1.csv"), "points": "contact"}
    again |= {"journal": str(series.journal), "output": str(tmp_path / "JOB-1.FCStd")}
    with pytest.raises(RefusedError, match="this measurement is part 1"):
        process.correct(**again)
    assert "part 1" in process.correct(once=True, **again)["done_before"]
    with pytest.raises(RefusedError):
        process.correct(once=True, **(again | {"output": str(tmp_path / "other.FCStd")}))
    # A document that was corrected since.
    series.document = part_files[0]
    with pytest.raises(InputError, match=r"shop.journal goes on from JOB-1.FCStd"):
        series.next(20.0)
    series.document = tmp_path / "JOB-1.FCStd"
    series.next(50.0, control_alarm=0.02, accept=["difference"])
    assert [e.part for e in series.entries] == [1, 2]
    with pytest.raises(UsageError, match="a document that is a file"):
        batch.correct_document(part_files[0], measured=tmp_path / "part-1.csv", points="contact", journal="j")


def test_from_the_command_line(part_files, measured_file, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(freecad_process, "call", lambda name, arguments: process.FUNCTIONS[name](**arguments))
    points = ["--measured", str(measured_file[0]), "--points", "contact", "--output", "JOB-1.FCStd"]
    command = ["correct", "--document", str(part_files[0]), *points, "--journal", "shop.journal"]
    assert main([*command, "--control", "ewma:2", "--control-limit", "0.004"]) == 0
    assert "journal     shop.journal" in capsys.readouterr().out
    assert main(command) == 4 and "this measurement is part 1" in capsys.readouterr().err
    assert main([*command, "--once"]) == 0 and "done before: JOB-1.FCStd is in its place" in capsys.readouterr().out
    assert main([*command[:-1], "--output", "JOB-2.FCStd"]) == 2 and "needs a name" in capsys.readouterr().err
    assert main(["history", "shop.journal"]) == 0
    assert "demo.FCStd (first program" in capsys.readouterr().out
    assert files(tmp_path) == {"JOB-1.FCStd", "shop.journal"}
