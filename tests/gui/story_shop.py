# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shop floor: program files, measuring programs, transfer function, split, batch, history, plots, help."""

import json
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from window import (
    SETUP,
    active,
    check,
    choose,
    equal,
    found,
    painted,
    path,
    play,
    screen,
    select,
    shot,
    theme,
    tidy,
    tooltip,
    top,
    until,
    view,
    wait,
    window,
)

METHOD_FIELDS = ("Setup", "Iterate", "Depth", "NextDepth", "DepthAlong", "TransferFunction", "Allowance")
recorded = []


def record():
    """Note every line that goes through the macro recorder."""
    run = FreeCADGui.doCommand

    def noted(line):
        recorded.append(line)
        return run(line)

    FreeCADGui.doCommand = noted


def dialog(kind):
    """The open window of a task."""
    found_ = [w for w in QtGui.QApplication.allWidgets() if w.objectName() == f"Millcorr{kind}" and w.isVisible()]
    check(found_, f"no window {kind}")
    return found_[0]


def child(widget, name, kind=QtCore.QObject):
    return widget.findChild(kind, name)


def put(task, **values):
    for name, value in values.items():
        task.fields[name].show_value(value)
    task.changed()


def program_file():
    FreeCADGui.runCommand("Millcorr_Program", 0)
    here = dialog("CorrectTask")
    task = here.task
    put(task, Program=path("demo.nc"), Measured=path("cmm.csv"), ToolDiameter=10.0, Filter="mean:5")
    task._program_changed()
    until(lambda: not task.busy, "check of a program")
    # The file does not say what its points are: beside the field, and no figures.
    check("points" in task.fields["Points"].note.text().lower() or task.message.text(), "nothing is said of the points")
    shot("program-asked")
    put(task, Points="contact")
    until(lambda: not task.busy, "check of a program")
    figure = child(task.form, "Greatest 1", QtGui.QLabel)
    equal(task.wrong, "", "what is wrong with the program")
    check(figure is not None and 0.001 < float(figure.text()) < 0.1, f"no figures: {figure and figure.text()}")
    shot("program")
    output = path("demo-corrected.nc")
    equal(task.fields["Output"].value, output, "name of the corrected program")
    put(task, Report=path("program-report"))
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: not task.writing, "writing of a program")
    written = os.path.exists(output) and os.path.exists(path("program-report/report.html"))
    check(written, f"nothing written: {task.wrong}")
    check(any("programs.correct" in line for line in recorded), "the program's correction is not recorded")
    shot("program-written")
    by_model(task, here)
    child(here, "Help", QtGui.QPushButton).click()
    wait(500)
    guide = dialog("Guide")
    check("NC programs" in guide.windowTitle(), guide.windowTitle())
    shot("help")
    guide.close()
    here.close()
    wait(200)


def by_model(task, here):
    """Each method shows the fields that it needs, and says beside them what is missing."""
    shown = {}
    for method in ("mirror", "transfer", "combined", "predicted"):
        choose(task, method)
        shown[method] = [name for name in METHOD_FIELDS if task.fields[name].widget.isVisible()]
    equal(shown["mirror"], ["Allowance"], "fields of mirror")
    equal(shown["transfer"], ["Depth", "NextDepth", "DepthAlong", "TransferFunction", "Allowance"], "of transfer")
    equal(shown["combined"], ["Setup", "Iterate", "Depth", "Allowance"], "fields of combined")
    equal(shown["predicted"], ["Setup", "Iterate"], "fields of predicted")
    choose(task, "combined")
    until(lambda: not task.busy, "combined without a setup")
    check(task.fields["Setup"].note.isVisible(), f"no word beside the setup that is missing: {task.wrong}")
    shot("program-combined-asked")
    with open(path("setup.toml"), "w", encoding="utf-8") as stream:
        stream.write(SETUP)
    put(task, Setup=path("setup.toml"), Output=path("demo-combined.nc"), Report="")
    until(lambda: not task.busy, "combined", 120)
    equal(task.wrong, "", "what is wrong with the combined method")
    check(not task.fields["Setup"].note.isVisible(), "the word stays beside the setup")
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: not task.writing, "writing by the combined method", 120)
    check(os.path.exists(path("demo-combined.nc")), f"nothing written: {task.wrong}")
    check(any("method='combined'" in line and "setup.toml" in line for line in recorded), "the setup is not recorded")
    shot("program-combined")


def measuring(document):
    select(document.getObject("Profile"))
    check(active("Millcorr_Probe"), tooltip("Millcorr_Probe"))
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    here = dialog("MeasuringTask")
    task = here.task
    put(task, BallRadius=2.5, Output=path("probe.ngc"))
    until(lambda: not task.busy, "plan of touches")
    equal(task.wrong, "", "what is wrong with the measuring program")
    check("G38" in task.text.toPlainText(), "no measuring program")
    check(task.picture.shown, "touches are not drawn")
    equal((task.fields["Z"].value, task.fields["SafeZ"].value > 12), (6.0, True), "heights from the model")
    task.fields["Z"].widget.setValue(-0.5)
    until(lambda: not task.busy, "refusal of a height")
    check("--z" in task.wrong and not task.picture.shown, f"a touch below the part is planned: {task.wrong}")
    task.fields["Z"].widget.setValue(6.0)
    until(lambda: not task.busy, "plan of touches")
    equal(task.wrong, "", "what is wrong with the measuring program")
    shot("measuring")
    put(task, Dialect="fanuc")
    until(lambda: not task.busy, "plan for Fanuc")
    check("Renishaw" in task.checked.text() and "P9811" in task.text.toPlainText(), task.text.toPlainText()[:300])
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: not task.writing, "writing of a measuring program")
    check(os.path.exists(path("probe.ngc")), f"nothing written: {task.wrong}")
    put(task, FreeWidth=1.0)
    until(lambda: not task.busy, "refusal of a width")
    check(task.fields["FreeWidth"].note.text(), "a space narrower than the ball is not refused")
    check(not task.picture.shown, "touches that are refused are drawn")
    here.close()
    wait(300)


def split(document):
    select(document.getObject("Profile"))
    FreeCADGui.runCommand("Millcorr_Split", 0)
    from millcorr.gui import transfer_panel  # noqa: F401

    panel = task_panel("SplitPanel")
    until(lambda: not panel.busy, "split")
    check(panel.fields["Stock"].note.text(), "nothing asks for the allowance")
    panel.fields["Stock"].show_value(0.8)
    panel._settings_changed()
    until(lambda: not panel.busy, "split")
    check("0.4" in panel.left.text(), panel.left.text())
    shot("split")
    check(panel.accept(), "the split is not accepted")
    FreeCADGui.Control.closeDialog()
    wait(300)
    obj = document.getObject("DressupMillcorr")
    check(obj is not None and obj.LeaveStock.Value == 0.4 and obj.Path.Commands, "no first cut")
    return obj


def task_panel(kind):
    """The panel in the task view; FreeCAD does not hand it out."""
    import gc

    found_ = [o for o in gc.get_objects() if type(o).__name__ == kind and not o.closed]
    check(found_, f"no panel {kind}")
    return found_[-1]


def transfer(document, obj):
    check(not active("Millcorr_Transfer"), "transfer can be used without a measured part")
    check("measured part" in tooltip("Millcorr_Transfer"), tooltip("Millcorr_Transfer"))
    for line in (
        "from millcorr.app import measurement_object",
        f"measured = measurement_object.create(App.ActiveDocument, {path('cmm.csv')!r}, 'contact')",
        f"App.ActiveDocument.{obj.Name}.Measurement = measured",
        f"App.ActiveDocument.{obj.Name}.LeaveStock = 0.0",
        "App.ActiveDocument.recompute()",
    ):
        FreeCADGui.doCommand(line)
    select(obj)
    check(active("Millcorr_Transfer"), tooltip("Millcorr_Transfer"))
    FreeCADGui.runCommand("Millcorr_Transfer", 0)
    panel = task_panel("TransferPanel")
    until(lambda: not panel.busy, "transfer without a depth")
    check(panel.wrong, "a transfer function without a depth is not refused")
    shot("transfer-asked")
    panel.fields["Depth"].show_value([0.4])
    panel._settings_changed()
    until(lambda: not panel.busy, "transfer")
    equal(panel.wrong, "", "what is wrong with the transfer function")
    ms = child(panel.form, "MS, mean 1", QtGui.QLabel)
    check(ms is not None and 0.001 < float(ms.text()) < 0.2, ms and ms.text())
    shot("transfer")
    check(panel.accept(), "the transfer function is not accepted")
    FreeCADGui.Control.closeDialog()
    wait(300)
    equal(obj.Method, "transfer", "method")
    equal(list(obj.Depth), [0.4], "depth")
    program = obj.Path.toGCode()
    document.undo()
    equal(obj.Method, "mirror", "method after undo")
    return program


def simulate(document):
    select(document.getObject("Profile"))
    check(active("Millcorr_Simulate"), tooltip("Millcorr_Simulate"))
    FreeCADGui.runCommand("Millcorr_Simulate", 0)
    here = dialog("SimulateTask")
    task = here.task
    put(task, Setup=path("setup.toml"), Report=path("simulated"))
    until(lambda: not task.busy, "simulation", 120)
    equal(task.wrong, "", "what is wrong with the simulation")
    played = task.played
    check(played.before.largest > 5 * played.after.largest, f"{played.before.largest} to {played.after.largest}")
    check(task.contours.shown, "contours are not drawn")
    # Scrubbed to the middle: the cutter stands on the path, its wall on the contour.
    task.slider.setValue(1000)
    wait(300)
    equal(round(task.time, 6), round(played.duration / 2, 6), "time in the middle")
    check(max(abs(a - b) for a, b in zip(task.cutter.place, played.cutter_at(task.time), strict=True)) < 1e-3, "cutter")
    shot("simulation")
    for name, dark in (("dark", True), ("light", False)):
        theme(name)
        equal(painted(task.canvas) < 128, dark, f"dark signals in a {name} window")
        shot(f"simulation-{name}")
    theme("")
    child(here, "Play", QtGui.QPushButton).click()
    wait(800)
    check(task.time > played.duration / 2 + 0.5, f"it does not play: {task.time}")
    child(here, "Play", QtGui.QPushButton).click()
    still = task.time
    wait(300)
    equal(task.time, still, "time while paused")
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: not task.writing, "report of the simulation", 120)
    check(os.path.exists(path("simulated/simulation.html")), f"nothing written: {task.wrong}")
    check(any("simulating.write" in line for line in recorded), "the simulation is not recorded")
    here.close()
    wait(300)


def plots(document, obj):
    from millcorr.gui import plots as module

    select(obj)
    top()
    check(active("Millcorr_Plots"), tooltip("Millcorr_Plots"))
    FreeCADGui.runCommand("Millcorr_Plots", 0)
    dock = module.dock()
    until(lambda: dock.result is not None, "plots")
    canvas = dock.pages["along"].canvas
    check(canvas is not None, "matplotlib is not used")
    found["figures"]["plotted"] = len(dock.along.x)
    wait(600)
    total = dock.along.total
    dock.point_at(0.3 * total)
    wait(300)
    check("measured" in dock.told.text(), dock.told.text())
    check(dock._mark.shown, "the place is not marked in the view")
    shot("plots")
    before = view().getCameraNode().height.getValue()
    canvas.axes.set_xlim(0.2 * total, 0.4 * total)
    wait(700)
    after = view().getCameraNode().height.getValue()
    check(after < 0.7 * before, f"the view does not follow the plot: {before} to {after}")
    low, high = canvas.shown_range
    check(low > 0 and high < total, f"the plot shows {low} to {high} of {total}")
    shot("plots-zoomed")
    view().fitAll()
    wait(900)
    low, high = canvas.shown_range
    check(high - low > 0.95 * total, f"the plot does not follow the view: {low} to {high} of {total}")
    # The mouse in the view, over the contour.
    x, y = view().getPointOnScreen(*dock.result.nominal.at(0, [0.5 * total])[0][0], 0)
    dock.link._mouse = (x, y)
    dock.link._tell()
    check(f"s {0.5 * total:.0f}"[:4] in dock.told.text(), f"{dock.told.text()} at {0.5 * total}")
    dock.tabs.setCurrentIndex(1)
    shot("plots-distribution")
    drawing(dock)
    dock.tabs.setCurrentIndex(0)
    canvas.show_range(0.2 * total, 0.6 * total)
    for name, dark in (("dark", True), ("light", False)):
        theme(name)
        equal(painted(canvas) < 128, dark, f"a dark plot in a {name} window")
        low, high = canvas.shown_range
        check(abs(low - 0.2 * total) < 1e-6 and abs(high - 0.6 * total) < 1e-6, f"the zoom is lost: {low} to {high}")
        shot(f"plots-{name}")
    theme("")
    FreeCADGui.runCommand("Millcorr_Plots", 0)
    check(not dock.isVisible(), "plots are not hidden")


def drawing(dock):
    """The report's own drawing, as it is shown where matplotlib is missing."""
    from millcorr.gui import plots as module
    from millcorr.gui.plot_drawing import Drawing
    from millcorr.report import plots as report_plots

    result = dock.result
    plot = report_plots.along_contour(result.nominal, result.deviation, result.filtered, result.predicted)
    shown = Drawing()
    shown.resize(760, 280)
    shown.show_svg(report_plots.standalone(plot, "light"), module.colours()["paper"])
    check(shown.drawn, "the report's drawing is not valid")
    image = shown.grab().toImage()
    seen = {image.pixel(x, y) for x in range(0, 760, 3) for y in range(0, 280, 3)}
    check(len(seen) > 5, f"the report's drawing shows {len(seen)} colours")


def batch():
    with open(path("night.toml"), "w", encoding="utf-8") as stream:
        stream.write(
            '[defaults]\ntool-diameter = 10\npoints = "contact"\n\n'
            '[[job]]\nname = "demo"\nprogram = "demo.nc"\nmeasured = "cmm.csv"\noutput = "night-demo.nc"\n'
            'filter = "mean:5"\njournal = "demo.journal"\n\n'
            '[[job]]\nname = "missing file"\nprogram = "demo.nc"\nmeasured = "nothing.csv"\noutput = "night-2.nc"\n'
        )
    FreeCADGui.runCommand("Millcorr_Batch", 0)
    here = dialog("BatchTask")
    task = here.task
    put(task, Batch=path("night.toml"))
    until(lambda: not task.busy and task.table.rowCount() == 2, "jobs of the batch")
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: task.run is None, "batch")
    texts = [[task.table.item(r, c).text() for c in (0, 1, 3)] for r in range(2)]
    check(texts[0][:2] == ["demo", "done"], texts)
    check(texts[1][1].startswith("failed") and "nothing.csv" in texts[1][2], texts)
    check(os.path.exists(path("night-demo.nc")), "the batch has written nothing")
    check(any("jobs.run" in line for line in recorded), "the batch is not recorded")
    shot("batch")
    here.close()
    wait(200)
    FreeCADGui.runCommand("Millcorr_History", 0)
    here = dialog("HistoryTask")
    task = here.task
    put(task, Journal=path("demo.journal"), Report=path("history"))
    until(lambda: not task.busy and task.table.rowCount() == 1, "history")
    equal(task.table.item(0, 7).text(), "corrected", "decision")
    child(here, "Plot", QtGui.QPushButton).click()
    wait(500)
    child(here, "Write", QtGui.QPushButton).click()
    until(lambda: not task.writing, "report of the history")
    check(os.path.exists(path("history/history.html")), f"no history: {task.wrong}")
    check(any("history" in line for line in recorded), "the history is not recorded")
    shot("history")
    here.close()
    from millcorr.gui import plots as module

    module.dock().hide()


def preferences():
    """The page is there, and forms begin with what it says."""
    from millcorr.gui import preferences as module

    equal(module.get("Limit"), 0.5, "limit of the preferences")
    module.put("Limit", 0.25)
    module.put("Points", "centre")
    equal(module.form_values()["Limit"], 0.25, "limit of the preferences")
    equal(module.get("Points"), "centre", "points of the preferences")
    module.put("Limit", 0.5)
    module.put("Points", "as the file says")
    page = FreeCADGui.PySideUic.loadUi(str(module.PAGE))
    names = {child_.objectName() for child_ in page.findChildren(QtGui.QWidget)}
    check(set(module.DEFAULTS) - {"LastDirectory"} <= names, set(module.DEFAULTS) - names)
    page.show()
    wait(300)
    screen().copy(page.frameGeometry()).save(os.path.join(os.environ["MILLCORR_SHOTS"], "page.png"))
    page.close()


def leave_lines(program):
    """For a FreeCAD without a window to run again; a journal would refuse the same part."""
    files = {
        name: open(path(name), encoding="utf-8").read()
        for name in ("demo-corrected.nc", "demo-combined.nc", "probe.ngc", "probe-macro.ngc", "history/history.html")
    }
    lines = [line for line in recorded if "jobs.run" not in line]
    with open(path("shop.json"), "w", encoding="utf-8") as stream:
        json.dump({"lines": lines, "files": files, "path": program}, stream)


def whats_this():
    """What's this of a button says what it does, and its link opens the page."""
    from millcorr.gui import guide

    action = FreeCADGui.Command.get("Millcorr_Probe").getAction()[0]
    check("measuring-programs.md" in action.whatsThis(), f"what's this: {action.whatsThis()}")
    for name, page in guide.PAGES.items():
        check((guide.DIRECTORY / page).is_file(), f"{name} is explained on {page}, which is not there")
    bar = next(bar for bar in window().findChildren(QtGui.QToolBar) if bar.windowTitle() == "Millcorr")
    event = QtGui.QWhatsThisClickedEvent("measuring-programs.md")
    QtGui.QApplication.sendEvent(bar.widgetForAction(action), event)
    wait(300)
    page = dialog("Guide")
    check("Measuring programs" in page.windowTitle(), page.windowTitle())
    page.close()


def macros():
    """The macros are buttons."""
    names = [name for name in FreeCADGui.listCommands() if name.startswith("Millcorr_Macro")]
    equal(len(names), 3, "macros")
    bar = [bar for bar in window().findChildren(QtGui.QToolBar) if bar.windowTitle() == "Millcorr macros"]
    check(bar and len([a for a in bar[0].actions() if a.text()]) == 3, "macros in the toolbar")
    # Without the dialogs that ask.
    here = path("probe-macro.ngc")
    ask = QtGui.QFileDialog.getSaveFileName
    QtGui.QFileDialog.getSaveFileName = staticmethod(lambda *given: (here, ""))
    try:
        FreeCADGui.runCommand("Millcorr_MacroMeasuringProgram", 0)
    finally:
        QtGui.QFileDialog.getSaveFileName = ask
    check(os.path.exists(here), "the macro has written no measuring program")
    check("asked" not in "".join(recorded) and "FCMacro" not in "".join(recorded), "a recorded macro asks")
    from millcorr.gui import told

    equal(told._box[0].text(), here, "what is said of the measuring program")
    told._box[0].close()


def story():
    record()
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    tidy()
    for name in ("Millcorr_Program", "Millcorr_Batch", "Millcorr_History", "Millcorr_Split"):
        check(active(name), f"{name} needs a document")
    check(not active("Millcorr_Probe") and not active("Millcorr_Plots"), "commands that need a document do not")
    program_file()
    batch()
    document = FreeCAD.openDocument(path("demo.FCStd"))
    wait(500)
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    tidy()
    top()
    measuring(document)
    simulate(document)
    whats_this()
    macros()
    obj = split(document)
    leave_lines(transfer(document, obj))
    plots(document, obj)
    preferences()


if os.environ["MILLCORR_STORY"] == "shop":
    play(story)
