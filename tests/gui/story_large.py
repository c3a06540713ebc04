# SPDX-License-Identifier: LGPL-2.1-or-later
"""A million points: the window lives on while they are read, corrected, stopped, drawn and accepted."""

import os
import sys
import threading
import time

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from heart import Heart
from window import VERSION, check, equal, found, path, play, select, shot, tidy, top, until, view, wait, write

POINTS = int(os.environ.get("MILLCORR_POINTS", 1_000_000))


STOPPED = 1.0
"""Stopped work ends within this, in s: twice what a quiet machine takes at most, as other tests run beside this one."""


def working():
    """Whether work is going on in a thread, wanted or not."""
    return any(thread.name == "millcorr" for thread in threading.enumerate())


def measured(document):
    """A file of points on the operation's contour, with a slow error and a little noise."""
    import numpy as np

    from millcorr.app import correction, draft, dressup

    values = draft.defaults(dressup.PROPERTIES) | {"Base": document.getObject("Profile")}
    profile = correction.request_of(draft.Draft("", values))[0].nominal
    rng = np.random.default_rng(7)
    s = np.linspace(0.0, profile.total[0], POINTS, endpoint=False)
    point, normal = profile.at(np.zeros(POINTS, dtype=int), s)
    error = 0.006 + 0.004 * np.cos(4 * np.pi * s / profile.total[0]) + rng.normal(0.0, 0.001, POINTS)
    rows = np.column_stack([point + error[:, None] * normal, np.full(POINTS, 6.0)])
    file = path("million.csv")
    with open(file, "w", encoding="utf-8") as stream:
        stream.write("x,y,z\n")
        np.savetxt(stream, rows, fmt="%.5f", delimiter=",")
    return file


def story():
    from millcorr.gui import dressup_panel, import_dialog, panel

    document = FreeCAD.openDocument(path("demo.FCStd"))
    document.UndoMode = 1
    # What FreeCAD 1.1 computes anew after opening is not ours.
    document.recompute()
    tidy()
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    top()
    file = measured(document)
    before = [obj.Name for obj in document.Objects]
    select(document.getObject("Profile"))
    heart = Heart()
    heart.prove()

    dialog = import_dialog.show(document, document.getObject("Profile"))
    dialog.fields["Points"].show_value("contact")
    wait(300)
    heart.begin()
    dialog.set_file(file)
    until(lambda: not dialog.busy, "reading", 300)
    heart.end("reading")
    check(str(POINTS) in dialog.found.text(), f"found: {dialog.found.text()}")
    heart.begin()
    dialog.accept()
    wait(50)
    heart.end("importing")
    equal(document.Objects[-1].Count, POINTS, "points in the document")
    before.append(document.Objects[-1].Name)

    heart.begin()
    made = dressup_panel.new(document.getObject("Profile"))
    panel.show(made)
    until(lambda: made.bar.value() > 5, "progress", 60)
    wait(2500)
    check(made.busy and made.bar.isVisible() and "%" in made.bar.text(), f"progress: {made.bar.text()!r}")
    shot("large-progress")
    heart.begin()
    # By the clock, or by what all threads but the window's had of a processor: other work on the machine is no fault.
    begun = time.perf_counter(), time.process_time() - time.thread_time()
    made.stop.click()
    until(lambda: not working(), "the end of stopped work", 10)
    stopped = min(time.perf_counter() - begun[0], time.process_time() - time.thread_time() - begun[1])
    found["figures"]["work stopped after, s"] = round(stopped, 3)
    heart.end("stopping")
    check(stopped < STOPPED, f"stopped work went on for {stopped:.2f} s")
    check(not made.busy and made.outcome is None and made.message.isVisible(), "stopped")
    equal([obj.Name for obj in document.Objects], before, "objects after stopping")
    heart.begin()
    write(made.fields["Filter"].widget.lineEdit(), "gauss:20")
    until(lambda: not made.busy, "correcting", 500)
    heart.end("correcting")
    equal(made.wrong, "", "correcting")
    equal(made.values["Points used"][0].text(), f"{POINTS} / {POINTS}", "points used")
    check(len(made.picture.drawn.overlay.rows) <= 100_000, "too many whiskers")
    begun = time.perf_counter()
    for _ in range(5):
        view().redraw()
        QtGui.QApplication.processEvents()
    found["figures"]["one frame, by software"] = round((time.perf_counter() - begun) / 5, 3)
    shot("large")
    begun = time.perf_counter()
    made.picture.pick_at(view(), 700, 200)
    found["figures"]["what is under the mouse"] = round(time.perf_counter() - begun, 3)
    heart.begin()
    check(made.accept(), "OK")
    FreeCADGui.Control.closeDialog()
    heart.end("accepting")
    obj = document.getObject("DressupMillcorr")
    equal([obj.PointsUsed, "Invalid" in obj.State], [POINTS, False], "dressup")
    found["figures"]["version"] = VERSION


play(story, 800)
