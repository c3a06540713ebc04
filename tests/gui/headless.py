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

    from millcorr.app import batch, compat, demonstration, documents, motion
    from millcorr.readers import text
    from millcorr.virtual import demonstration as simulation
    from millcorr.virtual.simulated_machine import SimulatedMachine, reference_contour

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
    make_series(work)
    batch.correct_document(
        work / "demo.FCStd",
        measured=work / "cmm.csv",
        points="contact",
        output=work / "corrected.FCStd",
        filter="mean:5",
    )
    # A part that was cut with the corrected path.
    with documents.opened(work / "corrected.FCStd") as doc:
        program = motion.program_of_path(compat.path_of(batch.find_operation(doc)), "corrected")
    write_measurement(work / "second.csv", program, demonstration.TOOL_DIAMETER / 2, shift=-0.004)


def make_series(work):
    """A journal of four parts, each cut with the program that the one before left, under a control."""
    from millcorr import nc, pipeline
    from millcorr.app import demonstration
    from millcorr.production import series
    from millcorr.production.process_control import Control
    from millcorr.virtual import demonstration as simulation
    from millcorr.virtual.simulated_machine import SimulatedMachine, reference_contour
    from millcorr.whole_file import replaced_whole

    nominal, machine = reference_contour(), SimulatedMachine.reference()
    program = work / "demo.nc"
    for number in range(1, 5):
        part = simulation.cut(machine, nominal, program, worn=0.0, seed=simulation.SEED + number)
        points = part.measure(simulation.POINTS, seed=simulation.SEED + number)
        request = pipeline.Request(nc.read(program), demonstration.TOOL_DIAMETER / 2, points, nominal)
        program = work / f"series-{number}.nc"
        with series.corrected(request, program, work / "series.journal", Control(2, 0.004)) as outcome:
            with replaced_whole(program, outcome.result.text):
                pass


def words(program):
    """A program without its comments: they name the corrected path by its digest, and documents keep six decimals."""
    return "\n".join(line for line in program.splitlines() if not line.startswith("("))


def farthest(one, other):
    """Largest distance in mm of places on the moves of one program from those of another."""
    import numpy as np
    import shapely

    from millcorr import nc

    rows = []
    for text in (one, other):
        path = nc.parse(text).toolpath
        known = path.take(np.isfinite(path.position(np.array([0.0, 1.0]))).all(axis=(1, 2)))
        rows.append(known.position(np.linspace(0.0, 1.0, 33))[:, :, :2])
    chords = shapely.linestrings(np.stack([rows[1][:, :-1], rows[1][:, 1:]], axis=2).reshape(-1, 2, 2))
    places = shapely.points(rows[0].reshape(-1, 2))
    return float(shapely.STRtree(chords).query_nearest(places, return_distance=True, all_matches=False)[1].max())


def same(obj, program):
    """The object has this path: documents keep six decimals, so one arc may become two, which is no other path."""
    ours, wanted = words(obj.Path.toGCode()), words(program)
    apart = difference(ours, wanted)
    if apart > 1e-5:
        apart = max(farthest(ours, wanted), farthest(wanted, ours))
        # Either is within the tolerance of what is wanted, and chords of 1/32 of an arc are off by as much.
        assert apart <= 0.003, apart


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


def replay_session(directory):
    """Run the lines that the window recorded: the same rounds, the same path."""
    from millcorr.app import compat

    compat.prepare_modules()
    work = Path(directory)
    recorded = json.loads((work / "verbs.json").read_text(encoding="utf-8"))
    document = FreeCAD.openDocument(str(work / "corrected.FCStd"))
    FreeCAD.setActiveDocument(document.Name)
    names = {"App": FreeCAD}
    for line in recorded["lines"]:
        exec(line, names)
    obj = document.getObject("DressupMillcorr")
    assert obj.Label == recorded["label"], obj.Label
    same(obj, recorded["path"])


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
