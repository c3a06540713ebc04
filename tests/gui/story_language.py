# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in Ukrainian and German: commands, forms, properties, and what is said of a measurement."""

import os
import re
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from story_shop import dialog, put
from window import SETUP, check, equal, path, play, select, shot, theme, tidy, top, until, wait, write

SAID = {
    "Ukrainian": ("Вимірювальна програма…", "Зона нечутливості", "Деталь"),
    "German": ("Messprogramm…", "Totband", "Teil"),
}


ACCENTS = {"@ThemeAccentColor1": "#4aa5ff", "@ThemeAccentColor2": "#b477ff", "@ThemeAccentColor3": "#181d2a"}
"""What FreeCAD 1.0 puts in for these words of its dark style sheet: colours of its preference pack "FreeCAD Dark"."""


def dark():
    """A dark style sheet of FreeCAD's own, where it has one."""
    theme("dark")
    place = os.path.join(FreeCAD.getResourceDir(), "Gui", "Stylesheets")
    for name in ("ProDark.qss", "FreeCAD Dark.qss"):
        file = os.path.join(place, name)
        if os.path.exists(file):
            QtCore.QDir.addSearchPath("qss", place)
            with open(file, encoding="utf-8") as stream:
                sheet = re.sub(r"@ThemeAccentColor\d", lambda found: ACCENTS[found[0]], stream.read())
            QtGui.QApplication.instance().setStyleSheet(sheet)
            break
    wait(500)


def contrast(button):
    """How far a button's text stands out from what it is written on, in lightness 0 to 255; its icon is on the left."""
    wait(200)
    image = button.grab().toImage()
    columns = range(image.width() // 2, image.width() - 8)
    seen = [image.pixelColor(x, y).lightness() for x in columns for y in range(8, image.height() - 8)]
    return max(seen) - min(seen)


def plain_words(where):
    """No text that is shown has words of the command line."""
    for label in QtGui.QApplication.allWidgets():
        text = label.text() if isinstance(label, QtGui.QLabel) and label.isVisible() else ""
        check(re.search(r"--[a-z]", text) is None, f"{where} says {text!r}")


def said_in_german(document):
    """Import, correction, refusal, program and measuring program in German, dark unless a light window is wanted."""
    from millcorr.gui import dressup_panel, import_dialog, packages, panel

    select(document.getObject("Profile"))
    top()
    FreeCADGui.runCommand("Millcorr_Measurement", 0)
    asked = import_dialog._open[0]
    asked.set_file(path("inch.csv"))
    asked.fields["Points"].show_value("contact")
    asked.fields["Unit"].show_value("mm")
    asked._changed()
    until(lambda: not asked.busy, "reading")
    shot("german-import")
    plain_words("the import")
    asked.set_file(path("part-1.csv"))
    until(lambda: not asked.busy, "reading")
    shot("german-import-ready")
    asked.accept()
    wait(500)
    made = dressup_panel.new(document.getObject("Profile"))
    panel.show(made)
    until(lambda: not made.busy, "computing")
    check(made.message.text().startswith("Verwenden"), f"first line in German: {made.message.text()!r}")
    shot("german-panel")
    usable = contrast(made.applying)
    write(made.fields["Limit"].widget.lineEdit(), "0.001")
    until(lambda: not made.busy, "computing")
    check("eine Korrektur von" in made.message.text(), f"refusal in German: {made.message.text()!r}")
    check("\u201c 0.001 mm" in made.message.text(), f"the field in German: {made.message.text()!r}")
    plain_words("the panel")
    check(not made.applying.isEnabled() and made.applying.toolTip() == made.message.text(), "OK while refused")
    faded = contrast(made.applying)
    check(faded < 0.8 * usable, f"OK does not look switched off: its text stands out by {faded}, not {usable}")
    shot("german-refused")
    made.reject()
    FreeCADGui.Control.closeDialog()
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    task = dialog("MeasuringTask").task
    put(task, BallRadius=2.5)
    until(lambda: not task.busy, "plan of touches")
    plain_words("the measuring program")
    check("Punkte:" in task.message.text(), f"measuring program in German: {task.message.text()!r}")
    shot("german-measuring")
    dialog("MeasuringTask").close()
    wait(300)
    with open(path("setup.toml"), "w", encoding="utf-8") as stream:
        stream.write(SETUP)
    FreeCADGui.runCommand("Millcorr_Simulate", 0)
    task = dialog("SimulateTask").task
    put(task, Setup=path("setup.toml"))
    until(lambda: not task.busy, "simulation", 120)
    shot("german-simulation")
    dialog("SimulateTask").close()
    wait(300)
    FreeCADGui.runCommand("Millcorr_Program", 0)
    task = dialog("CorrectTask").task
    put(task, Program=path("demo.nc"), Measured=path("part-1.csv"), ToolDiameter=10.0, Points="contact")
    until(lambda: not task.busy, "check of a program")
    plain_words("the window of programs")
    shot("german-program")
    dialog("CorrectTask").close()
    missing(packages)


def missing(packages):
    """What is missing is said once, with a button; commands are grey and say why."""
    before = list(packages._lack)
    packages._lack[:] = ["shapely>=2.0"]
    packages.tell_once()
    packages.tell_once()
    shown = [w for w in QtGui.QApplication.topLevelWidgets() if w.objectName() == "MillcorrMissing"]
    equal(len(shown), 1, "dialogs of what is missing")
    check(shown[0].installing.isEnabled() and "shapely" in shown[0].text(), f"it says {shown[0].text()!r}")
    # What is selected makes FreeCAD ask its commands again.
    FreeCADGui.Selection.clearSelection()
    wait(500)
    action = FreeCADGui.Command.get("Millcorr_Program").getAction()[0]
    until(lambda: not action.isEnabled(), "a command that cannot work is grey", 10)
    check("shapely" in action.toolTip(), f"tooltip: {action.toolTip()!r}")
    install = packages.install
    packages.install = lambda: "no network here"
    shown[0].installing.click()
    until(lambda: "no network here" in shown[0].informativeText(), "what pip says", 10)
    check(shown[0].installing.isEnabled() and "-m pip install" in shown[0].informativeText(), "what to do instead")
    shot("german-missing")
    packages.install = lambda: ""
    shown[0].installing.click()
    until(lambda: "neu" in shown[0].informativeText(), "that it is installed", 10)
    packages.install = install
    shown[0].close()
    packages._lack[:] = before


def story():
    from millcorr.app.text import label_of, translate

    document = FreeCAD.openDocument(path("demo.FCStd"))
    for language, (command, label, part) in SAID.items():
        FreeCADGui.setLocale(language)
        wait(500)
        FreeCADGui.activateWorkbench("MillcorrWorkbench")
        tidy()
        equal(translate("Millcorr_Probe", "Measuring program\u2026"), command, f"command in {language}")
        equal(label_of("DeadBand"), label, f"property in {language}")
        equal(translate("Millcorr", "Part"), part, f"word in {language}")
        action = FreeCADGui.Command.get("Millcorr_Probe").getAction()[0]
        equal(action.text().replace("&", ""), command, f"menu in {language}")
        FreeCADGui.runCommand("Millcorr_Program", 0)
        here = dialog("CorrectTask")
        check(here.windowTitle() != "Correct NC program file", f"title in {language}: {here.windowTitle()}")
        shot(f"language-{language}")
        here.close()
        wait(200)
    if os.environ["MILLCORR_LOOK"] == "dark":
        dark()
    said_in_german(document)
    theme("")


play(story)
