# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walk of docs/tutorial.md from a clean profile, and the pictures of it: tools/screenshots puts them in docs."""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from story_shop import dialog, put
from window import SETUP, SHOTS, check, path, play, screen, select, tidy, top, until, wait, window


def picture(name):
    """The whole screen, small enough for a page."""
    wait(500)
    made = screen().toImage().scaledToWidth(960, QtCore.Qt.TransformationMode.SmoothTransformation)
    # Quality 0 is the smallest file; nothing is lost.
    made.save(os.path.join(SHOTS, f"tutorial-{name}.png"), "PNG", 0)


def accepted(panel):
    until(lambda: not panel.busy, "computing")
    check(panel.accept(), f"not accepted: {panel.wrong}")
    FreeCADGui.Control.closeDialog()
    wait(500)


def plain():
    """A plain background: gradients make large files."""
    values = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    values.SetBool("Simple", True)
    values.SetBool("Gradient", False)
    values.SetBool("RadialGradient", False)
    values.SetUnsigned("BackgroundColor", 0xE8ECF2FF)


def story():
    plain()
    document = FreeCAD.openDocument(path("demo.FCStd"))
    wait(500)
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    tidy()
    document.Stock.ViewObject.Visibility = False
    document.getObject("Part").ViewObject.Visibility = False
    top()
    select(document.getObject("Profile"))
    picture("job")

    from millcorr.gui import import_dialog, plots

    FreeCADGui.runCommand("Millcorr_Measurement", 0)
    asked = import_dialog._open[0]
    asked.set_file(path("part-1.csv"))
    until(lambda: not asked.busy, "reading")
    asked.fields["Points"].show_value("contact")
    asked._changed()
    until(lambda: not asked.busy, "reading")
    picture("import")
    asked.accept()
    wait(500)

    from millcorr.gui import dressup_panel, panel

    select(document.getObject("Profile"))
    made = dressup_panel.new(document.getObject("Profile"))
    panel.show(made)
    until(lambda: not made.busy, "computing")
    picture("panel")
    accepted(made)
    obj = document.getObject("DressupMillcorr")
    check(obj is not None and obj.Path.Commands, "no corrected path")
    select(obj)
    picture("corrected")

    FreeCADGui.runCommand("Millcorr_Plots", 0)
    dock = plots.dock()
    until(lambda: dock.result is not None, "plots")
    wait(600)
    dock.point_at(0.62 * dock.along.total)
    picture("plots")
    dock.hide()

    select(obj)
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    task = dialog("MeasuringTask").task
    put(task, BallRadius=2.5)
    until(lambda: not task.busy, "plan of touches")
    picture("measuring")
    dialog("MeasuringTask").close()

    with open(path("setup.toml"), "w", encoding="utf-8") as stream:
        stream.write(SETUP)
    obj.ViewObject.ShowPicture = False
    select(document.getObject("Profile"))
    FreeCADGui.runCommand("Millcorr_Simulate", 0)
    task = dialog("SimulateTask").task
    put(task, Setup=path("setup.toml"))
    until(lambda: not task.busy, "simulation", 120)
    task.slider.setValue(1450)
    picture("simulation")
    FreeCAD.closeDocument(document.Name)
    wait(300)
    left = [w.objectName() for w in QtGui.QApplication.topLevelWidgets() if w.isVisible()]
    check("MillcorrSimulateTask" not in left, "the simulation outlives its document")

    FreeCADGui.runCommand("Millcorr_Program", 0)
    task = dialog("CorrectTask").task
    put(task, Program=path("demo.nc"), Measured=path("part-1.csv"), ToolDiameter=10.0, Points="contact")
    until(lambda: not task.busy, "check of a program")
    picture("program")
    dialog("CorrectTask").close()
    check(window().isVisible(), "the window is gone")


play(story)
