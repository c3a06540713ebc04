# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every story does inside FreeCAD's window: wait, look, press keys, count colours, and tell what is wrong.

A story is a function that calls `check`; `play` runs it and writes found.json. A modal window that nobody expects
would wait for ever: after a while the screen is saved and FreeCAD ends.
"""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

WORK = os.environ["MILLCORR_WORK"]
SHOTS = os.environ["MILLCORR_SHOTS"]
STORY = os.environ["MILLCORR_STORY"]
VERSION = ".".join(FreeCAD.Version()[:2])
SETUP = (Path(__file__).resolve().parents[2] / "resources" / "setups" / "demonstration.toml").read_text("utf-8")
"""A setup of the demonstration's cutter."""

found = {"version": VERSION, "wrong": [], "figures": {}}


def check(condition, text):
    """Note what is wrong, and go on."""
    if not condition:
        found["wrong"].append(str(text))
    return condition


def equal(seen, expected, text):
    return check(seen == expected, f"{text}: {seen!r} instead of {expected!r}")


def wait(milliseconds):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    getattr(loop, "exec", None)() if hasattr(loop, "exec") else loop.exec_()


def until(condition, text, seconds=60):
    """Let the window live until something is so."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return check(False, f"{text}: not within {seconds} s")
        wait(20)
    return True


def path(name):
    return os.path.join(WORK, name)


def window():
    return FreeCADGui.getMainWindow()


def tidy():
    """Only what a user of this workbench looks at."""
    for dock in window().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Combo View", "Model", "Tree view", "Tasks"):
            dock.show()
        else:
            dock.hide()
    window().showMaximized()
    wait(300)


def screen():
    """The whole screen, with the drawing of the 3-D view."""
    return QtGui.QApplication.primaryScreen().grabWindow(0)


def shot(name):
    for dock in window().findChildren(QtGui.QDockWidget):
        if dock.objectName() == "Report view":
            dock.hide()
    wait(400)
    screen().save(os.path.join(SHOTS, f"{VERSION}-{name}.png"))


def theme(name):
    """A dark window with a dark 3-D view, a light one with a light one, or the usual ones."""
    sheets = {
        "dark": "QWidget { background-color: #2b2b2b; color: #e6e6e6; }",
        "light": "QWidget { background-color: #f5f5f5; color: #1a1a1a; }",
    }
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    backgrounds = {"dark": 0x2B2B2BFF, "light": 0xFAFAFAFF}
    if name:
        group.SetUnsigned("BackgroundColor", backgrounds[name])
    group.SetBool("Simple", bool(name))
    group.SetBool("Gradient", not name)
    QtGui.QApplication.instance().setStyleSheet(sheets.get(name, ""))
    wait(700)


def painted(widget, x=4, y=4):
    """Lightness, 0 to 255, of a pixel of a widget as it is on the screen."""
    wait(100)
    return widget.grab().toImage().pixelColor(x, y).lightness()


def view():
    return FreeCADGui.ActiveDocument.mdiViewsOfType("Gui::View3DInventor")[0]


def top():
    view().viewTop()
    view().fitAll()
    wait(300)


def colours(name):
    """How many pixels of the 3-D view have each colour, as 0xRRGGBB."""
    file = os.path.join(SHOTS, f"{VERSION}-{name}-view.png")
    view().saveImage(file, 900, 600, "Current")
    image = QtGui.QImage(file)
    out = {}
    for y in range(image.height()):
        for x in range(image.width()):
            colour = image.pixel(x, y) & 0xFFFFFF
            out[colour] = out.get(colour, 0) + 1
    return out


def like(counted, rgba, off=12):
    """Pixels within a little of a colour 0xRRGGBBAA."""
    wanted = [(int(rgba) >> k) & 255 for k in (24, 16, 8)]
    return sum(
        n
        for colour, n in counted.items()
        if all(abs(((colour >> k) & 255) - w) <= off for k, w in zip((16, 8, 0), wanted, strict=True))
    )


def tree():
    """Labels in the tree, each with the labels below it."""
    out = {}

    def walk(item):
        out.setdefault(item.text(0), []).extend(item.child(k).text(0) for k in range(item.childCount()))
        for k in range(item.childCount()):
            walk(item.child(k))

    for widget in window().findChildren(QtGui.QTreeWidget):
        widget.expandAll()
        for k in range(widget.topLevelItemCount()):
            walk(widget.topLevelItem(k))
    return out


def press(widget, *keys, text=""):
    """Press keys on a widget, as a user without a mouse does."""
    plain = QtCore.Qt.KeyboardModifier.NoModifier
    for key in keys:
        for kind in (QtCore.QEvent.Type.KeyPress, QtCore.QEvent.Type.KeyRelease):
            QtGui.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, key, plain, text))
    wait(30)


def write(widget, text):
    """Type a text and Return."""
    widget.selectAll()
    for character in text:
        press(widget, QtCore.Qt.Key.Key_A, text=character)
    press(widget, QtCore.Qt.Key.Key_Return, text="\r")


def choose(panel, method):
    """Choose a method in a form, as a user does."""
    box = panel.fields["Method"].widget
    box.setCurrentIndex(box.findData(method))
    wait(50)


def select(*objects):
    FreeCADGui.Selection.clearSelection()
    for obj in objects:
        FreeCADGui.Selection.addSelection(obj)
    wait(300)


def active(name):
    return FreeCADGui.Command.get(name).isActive()


def tooltip(name):
    return FreeCADGui.Command.get(name).getAction()[0].toolTip()


def play(story, seconds=240):
    """Run a story and end FreeCAD."""

    def end():
        with open(path("found.json"), "w", encoding="utf-8") as stream:
            json.dump(found, stream, indent=1)
        sys.stdout.flush()
        os._exit(0)

    def hung():
        names = [type(w).__name__ for w in QtGui.QApplication.topLevelWidgets() if w.isVisible()]
        check(False, f"the story did not end within {seconds} s; open windows: {names}")
        screen().save(os.path.join(SHOTS, f"{VERSION}-{STORY}-hung.png"))
        end()

    def begin():
        try:
            story()
        # Whatever it is, the one who started this must read it.
        except BaseException:  # noqa: BLE001
            found["wrong"].append(traceback.format_exc())
            screen().save(os.path.join(SHOTS, f"{VERSION}-{STORY}-error.png"))
        end()

    QtCore.QTimer.singleShot(seconds * 1000, hung)
    QtCore.QTimer.singleShot(2500, begin)
