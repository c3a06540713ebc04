# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done without a window before and after the stories, in FreeCADCmd."""

import json
import shutil
import sys
from pathlib import Path

import FreeCAD
from paths import difference

REPOSITORY = Path(__file__).resolve().parents[2]

DIGIT = 1.5e-3
"""The last digit of both axes in the programs, mm."""


def prepare(directory):
    """The demonstration, its measured files in millimetres and inches, and the document corrected."""
    sys.path.insert(0, str(REPOSITORY / "tests" / "app"))
    from conftest import write_measurement

    from millcorr import demonstration as simulation
    from millcorr.app import batch, compat, demonstration, documents, motion
    from millcorr.readers import text
    from millcorr.simulated_machine import SimulatedMachine, reference_contour

    work = Path(directory)
    demonstration.make(work / "demo.FCStd", work / "demo.nc")
    with documents.opened(work / "demo.FCStd") as doc:
        program = motion.program_of_path(compat.path_of(batch.find_operation(doc)), "demo")
    write_measurement(work / "cmm.csv", program, demonstration.TOOL_DIAMETER / 2)
    head, *rows = (work / "cmm.csv").read_text(encoding="utf-8").split()
    # One point lies nowhere near the part.
    rows.insert(20, "50,90,6")
    inches = [",".join(f"{float(number) / 25.4:.8f}" for number in row.split(",")) for row in rows]
    (work / "inch.csv").write_text("\n".join([head, *inches, ""]), encoding="utf-8")
    nominal, machine = reference_contour(), SimulatedMachine.reference()
    part = simulation.cut(machine, nominal, work / "demo.nc", worn=0.0, seed=simulation.SEED)
    measurement = part.measure(simulation.POINTS, seed=simulation.SEED)
    text.write(work / "part-1.csv", measurement, comments=(part.describe(),))
    batch.correct_document(
        work / "demo.FCStd",
        measured=work / "cmm.csv",
        points="contact",
        output=work / "corrected.FCStd",
        filter="mean:5",
    )


def same(obj, program):
    """The object has this path; headless and with a window FreeCAD may have different numpys."""
    apart = difference(obj.Path.toGCode(), program)
    assert apart <= 1e-5, apart


def replay_correct(directory):
    """Run the lines that the window recorded: the same path comes out."""
    from millcorr.app import compat

    compat.prepare_modules()
    work = Path(directory)
    recorded = json.loads((work / "recorded.json").read_text(encoding="utf-8"))
    document = FreeCAD.openDocument(str(work / "demo.FCStd"))
    FreeCAD.setActiveDocument(document.Name)
    names = {"App": FreeCAD}
    shutil.rmtree(work / "exported")
    for line in recorded["lines"]:
        exec(line, names)
    # The last change in the window was undone.
    obj = document.getObject("DressupMillcorr")
    obj.Gain = 1.0
    document.recompute()
    same(obj, recorded["path"])
    assert document.getObject("MillcorrProfile").Shape.Edges, "no compensated profile"
    assert (work / "exported" / "report.html").exists(), "no report"


def replay_shop(directory):
    """Run the lines that the windows recorded: the same files come out."""
    from millcorr.app import compat

    compat.prepare_modules()
    work = Path(directory)
    recorded = json.loads((work / "shop.json").read_text(encoding="utf-8"))
    document = FreeCAD.openDocument(str(work / "demo.FCStd"))
    FreeCAD.setActiveDocument(document.Name)
    names = {"App": FreeCAD}
    for name in recorded["files"]:
        (work / name).unlink()
    for line in recorded["lines"]:
        exec(line, names)
    for name, text in recorded["files"].items():
        again = (work / name).read_text(encoding="utf-8")
        # A number that lies between two of its last digits may be rounded either way.
        assert again == text or difference(again, text) <= DIGIT, name
    same(document.getObject("DressupMillcorr"), recorded["path"])
