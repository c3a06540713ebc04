# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way of a user: open the job, import the file, look, change, accept, undo, save, open again, post."""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from window import (
    SETUP,
    VERSION,
    active,
    check,
    choose,
    colours,
    equal,
    found,
    like,
    path,
    play,
    press,
    select,
    shot,
    theme,
    tidy,
    tooltip,
    top,
    tree,
    until,
    view,
    wait,
    window,
    write,
)

Key = QtCore.Qt.Key
recorded = []


def record():
    """Note every line that goes through the macro recorder."""
    run = FreeCADGui.doCommand

    def noted(line):
        recorded.append(line)
        return run(line)

    FreeCADGui.doCommand = noted


def menus():
    """Texts of all commands in the menu bar, by the menu they are in."""
    out = {}
    for action in window().menuBar().actions():
        if action.menu() is not None:
            out[action.text().replace("&", "")] = [a.text().replace("&", "") for a in action.menu().actions()]
    return out


def commands(document):
    """Workbench, toolbar, menu, and when commands can be used."""
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    wait(500)
    bars = [bar for bar in window().findChildren(QtGui.QToolBar) if bar.windowTitle() == "Millcorr"]
    check(bars and len([a for a in bars[0].actions() if a.text()]) >= 5, "the toolbar lacks commands")
    check("Compensated toolpath\u2026" in menus().get("Millcorr", []), f"menu: {menus().get('Millcorr')}")
    select()
    for name in ("Millcorr_Picture", "Millcorr_Profile", "Millcorr_Report"):
        check(not active(name), f"{name} can be used without a compensated toolpath")
        check("Needs:" in tooltip(name) and "make one first" in tooltip(name), f"tooltip {tooltip(name)}")
    # The only operation needs no selecting.
    check(active("Millcorr_Dressup") and "Needs:" not in tooltip("Millcorr_Dressup"), "the only operation is not taken")
    select(document.getObject("ToolBit") or document.Objects[0])
    check(active("Millcorr_Measurement"), "import cannot be used")
    if hasattr(FreeCADGui, "addWorkbenchManipulator"):
        FreeCADGui.activateWorkbench("CAMWorkbench")
        wait(1000)
        check("Compensated toolpath\u2026" in menus().get("CAM", []), f"CAM's menu: {menus().get('CAM')}")
        FreeCADGui.activateWorkbench("MillcorrWorkbench")
        wait(500)


def file_import(document):
    """Import by keyboard; nothing is taken for granted, and a wrong unit is found and resolved."""
    from millcorr.gui import import_dialog

    before, undone = len(document.Objects), document.UndoCount
    FreeCADGui.runCommand("Millcorr_Measurement", 0)
    dialog = import_dialog._open[0]
    check(not dialog.ok.isEnabled(), "import without a file")
    write(dialog.path, path("inch.csv"))
    until(lambda: not dialog.busy, "first look at the file")
    equal(dialog.table.item(1, 0).text(), "x", "header in the preview")
    equal(dialog.table.cellWidget(0, 2).currentData(), "z", "meaning of the third column")
    points = dialog.fields["Points"]
    equal(points.value, "as the file says", "kind of points that was not said")
    check(points.note.isVisible() and "ball" in points.note.text(), "no word beside the field that is missing")
    check(not dialog.ok.isEnabled(), "import of what nobody knows")
    shot("import-asks")
    press(points.widget, Key.Key_Down)
    equal(points.value, "contact", "kind of points by keyboard")
    until(lambda: not dialog.busy, "reading")
    check("201" in dialog.found.text(), f"found: {dialog.found.text()}")
    button = dialog.findChild(QtGui.QPushButton, "Remedy Unit")
    if check(button is not None, "a file in inches is taken for millimetres"):
        shot("import-doubts")
        press(button, Key.Key_Space, text=" ")
        equal(dialog.fields["Unit"].value, "inch", "unit after the button")
        until(lambda: not dialog.busy, "reading in inches")
        check(dialog.findChild(QtGui.QPushButton, "Remedy Unit") is None, "the doubt is still there")
    dialog.table.set_column(3, "")
    until(lambda: not dialog.busy, "reading without z")
    check("Z" not in dialog.found.text(), "the column left out is still read")
    dialog.table.set_column(3, "z")
    until(lambda: not dialog.busy, "reading with z")
    equal(len(document.Objects), before, "objects before the import")
    shot("import-ready")
    press(dialog, Key.Key_Return, text="\r")
    wait(500)
    measurement = document.Objects[-1]
    equal([len(document.Objects), document.UndoCount], [before + 1, undone + 1], "objects and undo after the import")
    equal([measurement.Count, measurement.Unit, measurement.Points], [201, "inch", "contact"], "measurement")
    document.undo()
    equal(len(document.Objects), before, "objects after undo of the import")
    document.redo()
    wait(300)
    equal(document.Objects[-1].Count, 201, "points after redo of the import")
    check(not import_dialog._open, "the dialog is still open")


def figure(panel, name, column=0):
    return panel.values[name][column].text()


def settled(panel):
    until(lambda: not panel.busy, "computing")
    wait(100)


def pictures(name, wanted):
    """Whether the view shows blue, green and red whiskers."""
    import numpy

    from millcorr.report.picture.scale import Look, Scale

    counted = colours(name)
    shades = Scale.of(Look(), numpy.array([0.03])).shades
    blue = sum(like(counted, shade) for shade in shades[:4])
    green, red = like(counted, shades[4]), sum(like(counted, shade) for shade in shades[5:])
    found["figures"][f"pixels {name}"] = [blue, green, red]
    enough = blue > 300 and green > 300 and red > 150
    check(enough == wanted, f"{name}: {blue} blue, {green} green, {red} red pixels")


def preview(document):
    """The panel changes nothing before OK; figures follow the settings, errors stand beside their field."""
    from millcorr.gui import dressup_panel, panel

    state = [len(document.Objects), document.UndoCount]
    select(document.getObject("Profile"))
    top()
    pictures("before", False)
    made = dressup_panel.new(document.getObject("Profile"))
    panel.show(made)
    settled(made)
    equal(made.wrong, "", "first result")
    equal(figure(made, "Points used"), "200 / 201", "points used")
    equal(figure(made, "Points left out"), "1", "points left out")
    largest = float(figure(made, "Largest correction"))
    check(0.004 < largest < 0.012, f"largest correction {largest}")
    check(float(figure(made, "Std. dev.", 1)) < 0.2 * float(figure(made, "Std. dev.")), "residual")
    shot("panel")
    pictures("panel", True)
    for name, usable in (("Dressup", False), ("Split", False), ("Plots", False), ("Help", True), ("Program", True)):
        action = FreeCADGui.Command.get(f"Millcorr_{name}").getAction()[0]
        equal(action.isEnabled(), usable, f"{name} while a task is open")
    check("open task" in tooltip("Millcorr_Dressup"), f"tooltip while a task is open: {tooltip('Millcorr_Dressup')}")
    check("make one first" in tooltip("Millcorr_Plots"), f"tooltip of plots: {tooltip('Millcorr_Plots')}")
    for name in ("dark", "light"):
        theme(name)
        shot(f"panel-{name}")
        pictures(f"panel-{name}", True)
        rimmed(name)
    theme("")
    picked(made)
    gain = made.fields["Gain"]
    write(gain.widget.lineEdit(), "5")
    settled(made)
    check(gain.note.isVisible() and "Gain" in gain.note.text(), "no word beside the wrong gain")
    equal(figure(made, "Mean"), "\u2013", "figures of a wrong setting")
    equal(made.accept(), False, "OK with a wrong setting")
    shot("panel-wrong")
    pictures("panel-wrong", False)
    write(gain.widget.lineEdit(), "0.5")
    settled(made)
    check(not gain.note.isVisible(), "the word stays beside the gain")
    half = float(figure(made, "Largest correction"))
    check(abs(half - largest / 2) < 0.0006, f"half the gain: {half} of {largest}")
    made.fields["Filter"].widget.lineEdit().setText("mean:4")
    press(made.fields["Filter"].widget.lineEdit(), Key.Key_Return, text="\r")
    settled(made)
    check(made.fields["Filter"].note.isVisible(), "no word beside the wrong filter")
    write(made.fields["Filter"].widget.lineEdit(), "auto")
    methods(made)
    write(made.fields["Limit"].widget.lineEdit(), "0.001")
    settled(made)
    check(made.message.isVisible() and "0.001" in made.message.text(), f"refusal: {made.message.text()!r}")
    shot("panel-refused")
    equal([len(document.Objects), document.UndoCount], state, "document while the panel is open")
    made.reject()
    FreeCADGui.Control.closeDialog()
    wait(300)
    equal([len(document.Objects), document.UndoCount], state, "document after Cancel")
    pictures("cancelled", False)


def rimmed(name):
    """The nominal, which is nearly black, has a light rim: it stands out on any background."""
    from millcorr.report.picture import correction as overlay

    counted = colours(f"rim-{name}")
    dark, light = like(counted, overlay.NOMINAL), like(counted, 0xF6F6F6FF, 3)
    check(dark > 300 and light > 300, f"{name}: {dark} pixels of the nominal, {light} of its rim")


def methods(made):
    """A method's fields are there where it needs them; what is missing is told beside them, and counts for it alone."""
    choose(made, "transfer")
    settled(made)
    check(made.fields["Depth"].note.isVisible(), f"no word beside the depth that is missing: {made.wrong}")
    check(not made.fields["Setup"].widget.isVisible(), "transfer asks for a setup")
    write(made.fields["Depth"].widget, "0,4")
    settled(made)
    equal([made.wrong, made.draft.Depth], ["", [0.4]], "transfer")
    choose(made, "combined")
    settled(made)
    check(made.fields["Setup"].note.isVisible(), f"no word beside the setup that is missing: {made.wrong}")
    shot("panel-setup-asked")
    check(not made.fields["Setup"].note.visibleRegion().isEmpty(), "what is missing is out of sight")
    with open(path("setup.toml"), "w", encoding="utf-8") as stream:
        stream.write(SETUP)
    write(made.fields["Setup"].line, path("setup.toml"))
    settled(made)
    equal(made.wrong, "", "combined")
    check(not made.fields["Setup"].note.isVisible(), "the word stays beside the setup")
    shot("panel-combined")
    choose(made, "mirror")
    settled(made)
    equal([made.wrong, made.draft.Depth, made.draft.Setup], ["", [], ""], "mirror after transfer")


def picked(made):
    """The point of a whisker, and the reason at a point that is left out, where the picture shows them."""
    drawn, result = made.picture.drawn.overlay, made.picture.drawn.result
    on_screen = getattr(view(), "getPointOnViewport", None) or view().getPointOnScreen
    row = int(abs(result.deviation.value).argmax())
    number = drawn.rows.tolist().index(row)
    foot, tip = drawn.whiskers.vertices[2 * number], drawn.whiskers.vertices[2 * number + 1]
    place = on_screen(*((foot + 7 * tip) / 8).tolist())
    text = made.picture.pick_at(view(), *place).text
    line = int(result.request.measurement.lines[result.deviation.index[row]])
    check(text.endswith(f"inch.csv:{line}") and "deviation" in text and "cos" in text, f"picked: {text!r}, line {line}")
    text = made.picture.pick_at(view(), *on_screen(*drawn.rejected.vertices[2].tolist())).text
    check(text.startswith("left out: farther than"), f"picked a rejected point: {text!r}")
    equal(made.picture.pick_at(view(), 5, 5), None, "picked in the corner")


def accepted(document):
    """OK in one step that can be undone and redone; the picture stays with the dressup."""
    from millcorr.app import compat
    from millcorr.gui import dressup_panel, panel

    undone = document.UndoCount
    made = dressup_panel.new(document.getObject("Profile"))
    panel.show(made)
    write(made.fields["Filter"].widget.lineEdit(), "mean:5")
    # At once, while it computes: OK waits, the window does not.
    made.accept()
    until(lambda: not FreeCADGui.Control.activeDialog(), "OK while it computes")
    wait(300)
    obj = document.getObject("DressupMillcorr")
    if not check(obj is not None, "no dressup after OK"):
        return None
    equal([obj.Filter, "Invalid" in obj.State, document.UndoCount - undone], ["mean:5", False, 1], "dressup after OK")
    job = compat.jobs(document)[0]
    equal([o.Label for o in compat.operations(job)], ["Profile corrected"], "job after OK")
    equal(tree().get("Profile corrected"), ["Profile"], "tree after OK")
    top()
    shot("accepted")
    pictures("accepted", True)
    program = obj.Path.toGCode()
    document.undo()
    wait(300)
    check(document.getObject("DressupMillcorr") is None, "dressup after undo")
    equal([o.Label for o in compat.operations(job)], ["Profile"], "job after undo")
    pictures("undone", False)
    document.redo()
    wait(800)
    obj = document.getObject("DressupMillcorr")
    equal(obj.Path.toGCode() == program, True, "path after redo")
    equal([o.Label for o in compat.operations(job)], ["Profile corrected"], "job after redo")
    pictures("redone", True)
    return obj


def edited(document, obj):
    """A double click opens the panel with the dressup's settings; a change is one step of undo."""
    made = obj.ViewObject.Proxy.panel()
    from millcorr.gui import panel

    check(panel.show(made) and not panel.show(made), "two panels at once")
    settled(made)
    equal(made.fields["Filter"].value, "mean:5", "filter in the panel")
    write(made.fields["Gain"].widget.lineEdit(), "0.5")
    settled(made)
    undone, largest = document.UndoCount, obj.LargestCorrection.Value
    check(made.accept(), "OK of a change")
    FreeCADGui.Control.closeDialog()
    equal([obj.Gain, document.UndoCount - undone], [0.5, 1], "after the change")
    check(abs(obj.LargestCorrection.Value - largest / 2) < 1e-4, "correction after the change")
    document.undo()
    equal(obj.Gain, 1.0, "gain after undo")
    document.recompute()
    select(obj)
    FreeCADGui.runCommand("Millcorr_Picture", 0)
    wait(300)
    pictures("hidden", False)
    FreeCADGui.runCommand("Millcorr_Picture", 0)
    until(lambda: obj.ViewObject.Proxy._picture.shown, "picture switched on")
    taken_out(document, obj)


def taken_out(document, obj):
    """Compensated profile and report: a step of undo for what is in the document, none for a file."""
    objects, undone = len(document.Objects), document.UndoCount
    select(obj)
    FreeCADGui.runCommand("Millcorr_Profile", 0)
    wait(300)
    equal([len(document.Objects), document.UndoCount], [objects + 1, undone + 1], "objects and undo after the profile")
    document.undo()
    equal(len(document.Objects), objects, "objects after undo of the profile")
    document.redo()
    wait(200)
    profile = document.Objects[-1]
    check(profile.Shape.Edges and profile.Shape.Edges[0].Curve.TypeId.endswith("BSplineCurve"), "no NURBS")
    equal(profile.Name, "MillcorrProfile", "name of the profile")
    select(obj)
    ask = QtGui.QFileDialog.getExistingDirectory
    QtGui.QFileDialog.getExistingDirectory = staticmethod(lambda *given: path("exported"))
    try:
        FreeCADGui.runCommand("Millcorr_Report", 0)
    finally:
        QtGui.QFileDialog.getExistingDirectory = ask
    check(os.path.exists(path("exported/report.html")), "no report is exported")
    told_of(path("exported"))
    # A directory that cannot be made is told otherwise, and in no panel.
    QtGui.QFileDialog.getExistingDirectory = staticmethod(lambda *given: path("demo.nc"))
    try:
        FreeCADGui.runCommand("Millcorr_Report", 0)
    finally:
        QtGui.QFileDialog.getExistingDirectory = ask
    from millcorr.gui import told

    equal(told._box[0].icon(), QtGui.QMessageBox.Critical, "icon of a failure")
    shot("export-failed")
    told._box[0].close()
    recorded[:] = [line for line in recorded if "demo.nc" not in line]
    equal(document.UndoCount, undone + 1, "undo after the report")


def told_of(place):
    """It is said where it was written, with a button that opens it."""
    from millcorr.gui import told

    box = told._box[0]
    equal([box.icon(), box.text()], [QtGui.QMessageBox.Information, place], "what is said of the report")
    opened = []
    real, told.QtGui.QDesktopServices.openUrl = told.QtGui.QDesktopServices.openUrl, opened.append
    try:
        box.findChild(QtGui.QPushButton, "Open exported").click()
    finally:
        told.QtGui.QDesktopServices.openUrl = real
    check(opened and opened[0].toLocalFile().endswith("report.html"), f"opened: {opened}")


def kept(document, obj):
    """Saved, closed, opened: path and picture are there; posted is the corrected path."""
    from millcorr.app import compat

    program = obj.Path.toGCode()
    document.saveAs(path("story.FCStd"))
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path("story.FCStd"))
    obj = document.getObject("DressupMillcorr")
    equal(obj.Path.toGCode() == program, True, "path after opening")
    until(lambda: obj.ViewObject.Proxy._picture is not None, "picture after opening")
    wait(500)
    top()
    pictures("reopened", True)
    shot("reopened")
    text = compat.post(compat.parent_job(obj))
    equal(text.count("begin operation: Profile corrected"), 1, "posted so many times")
    with open(path("recorded.json"), "w", encoding="utf-8") as stream:
        import json

        json.dump({"lines": recorded, "path": program}, stream)
    return document


def closed(document):
    """A document is closed while a panel and its picture are open: the panel goes with it, FreeCAD stays."""
    from millcorr.gui import panel, plots

    for over in (document.getObject("DressupMillcorr"), None):
        made = over.ViewObject.Proxy.panel() if over else dressup_panel_of(document)
        panel.show(made)
        settled(made)
        check(made.picture.shown, "no picture in the panel")
        select(document.getObject("DressupMillcorr"))
        FreeCADGui.runCommand("Millcorr_Plots", 0)
        until(lambda: plots.dock().result is not None, "plots")
        FreeCAD.closeDocument(document.Name)
        wait(500)
        check(made.closed and not FreeCADGui.Control.activeDialog(), "the panel outlives its document")
        check(plots.dock().result is None, "the plots outlive their document")
        plots.dock().hide()
        document = FreeCAD.openDocument(path("story.FCStd"))
        wait(500)
    until(lambda: document.getObject("DressupMillcorr").ViewObject.Proxy._picture is not None, "picture at the end")
    FreeCAD.closeDocument(document.Name)
    wait(500)


def dressup_panel_of(document):
    from millcorr.gui import dressup_panel

    return dressup_panel.new(document.getObject("Profile"))


def story():
    record()
    document = FreeCAD.openDocument(path("demo.FCStd"))
    document.UndoMode = 1
    tidy()
    commands(document)
    file_import(document)
    preview(document)
    obj = accepted(document)
    if obj is not None:
        edited(document, obj)
        closed(kept(document, obj))
    found["figures"]["version"] = VERSION


play(story)
