# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session that goes on: a second part, parts switched off and on, and what a mouse and a key can do wrong."""

import json
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from paths import difference
from window import check, equal, path, play, press, select, shot, tidy, top, tree, until, wait, window, write

Key = QtCore.Qt.Key
recorded = []


def record():
    """Note every line that goes through the macro recorder."""
    run = FreeCADGui.doCommand

    def noted(line):
        recorded.append(line)
        return run(line)

    FreeCADGui.doCommand = noted


def settled(panel):
    until(lambda: not panel.busy, "computing")
    wait(100)


def the_panel():
    """The panel in the task view; FreeCAD does not hand it out."""
    from millcorr.gui import panel

    check(panel._shown, "no panel is open")
    return panel._shown[0]


def labels(made):
    checked = QtCore.Qt.CheckState.Checked
    items = [made.parts.item(k) for k in range(made.parts.count())]
    return [(item.text(), item.checkState() == checked) for item in items]


def tick(made, row, on):
    """Click the box of a part."""
    state = QtCore.Qt.CheckState.Checked if on else QtCore.Qt.CheckState.Unchecked
    made.parts.item(row).setCheckState(state)
    settled(made)


def accept(made):
    check(made.accept(), f"OK is refused: {made.wrong}")
    FreeCADGui.Control.closeDialog()
    wait(300)


def words(obj):
    """The path without its comments."""
    return "\n".join(c.toGCode() for c in obj.Path.Commands if not c.Name.startswith("("))


def same(obj, program):
    """Whether a dressup has this path; documents keep six decimals."""
    return difference(words(obj), program) <= 2e-6


def second_part(document, obj):
    """On a corrected operation a newly measured part is added; the first correction stays, and is in the tree once."""
    from millcorr.app import measurement_object

    once = words(obj)
    FreeCAD.setActiveDocument(document.Name)
    document.openTransaction("import")
    lines = [
        "from millcorr.app import measurement_object",
        f"measurement_object.create(App.ActiveDocument, {path('second.csv')!r}, 'contact')",
        "App.ActiveDocument.recompute()",
    ]
    for line in lines:
        FreeCADGui.doCommand(line)
    document.commitTransaction()
    check(measurement_object is not None, "")
    select(obj)
    FreeCADGui.runCommand("Millcorr_Dressup", 0)
    made = the_panel()
    settled(made)
    equal(labels(made), [("cmm.csv", True), ("second.csv", True)], "parts in the panel")
    equal(made.wrong, "", "what is wrong with a second part")
    shot("second-part")
    undone = document.UndoCount
    accept(made)
    equal(obj.Label, "Profile corrected, 2 parts", "label")
    equal(tree().get("Profile corrected, 2 parts"), ["Profile"], "tree")
    equal([o.Name for o in document.Objects if o.Name.startswith("Dressup")], ["DressupMillcorr"], "dressups")
    equal(document.UndoCount - undone, 1, "steps of undo")
    twice = words(obj)
    check(not same(obj, once), "the second part changes nothing")
    document.undo()
    wait(300)
    equal([obj.Label, same(obj, once)], ["Profile corrected", True], "after undo")
    document.redo()
    wait(300)
    equal([obj.Label, same(obj, twice)], ["Profile corrected, 2 parts", True], "after redo")
    return once, twice


def off_and_on(document, obj, once, twice):
    made = obj.ViewObject.Proxy.panel()
    from millcorr.gui import panel

    panel.show(made)
    settled(made)
    equal(labels(made), [("cmm.csv", True), ("second.csv", True)], "parts at a double click")
    tick(made, 1, False)
    equal(made.wrong, "", "what is wrong with a part switched off")
    shot("part-off")
    accept(made)
    equal([obj.Label, same(obj, once)], ["Profile corrected, 1 of 2 parts", True], "after switching off")
    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    equal(labels(made), [("cmm.csv", True), ("second.csv", False)], "parts after switching off")
    tick(made, 1, True)
    accept(made)
    equal([obj.Label, same(obj, twice)], ["Profile corrected, 2 parts", True], "after switching on")


def escape(document, obj):
    """Escape in the panel is Cancel; what was ticked and typed is gone."""
    from millcorr.gui import panel

    before = [words(obj), obj.Label, document.UndoCount]
    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    made.parts.item(0).setCheckState(QtCore.Qt.CheckState.Unchecked)
    write(made.fields["Gain"].widget.lineEdit(), "0.3")
    made.reject()
    FreeCADGui.Control.closeDialog()
    wait(300)
    equal([words(obj), obj.Label, document.UndoCount], before, "after Cancel")


def ok_button():
    """OK of the task view."""
    boxes = [box for box in window().findChildren(QtGui.QDialogButtonBox) if box.isVisible()]
    buttons = [box.button(QtGui.QDialogButtonBox.Ok) for box in boxes]
    return next(button for button in buttons if button is not None)


def refused(document, obj):
    """While a correction is refused there is no OK, the reason stands beside it, and what was measured is drawn."""
    from millcorr.gui import panel

    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    check(ok_button().isEnabled() and not made.points.shown, "OK of a sound correction")
    write(made.fields["Limit"].widget.lineEdit(), "0.0005")
    settled(made)
    check(not ok_button().isEnabled(), "OK of a refused correction")
    check("0.0005" in ok_button().toolTip(), f"no reason at OK: {ok_button().toolTip()!r}")
    check(
        made.message.isVisible() and "0.0005" in made.message.text(), f"no reason in the panel: {made.message.text()}"
    )
    until(lambda: made.points.shown, "measured points of a refused correction")
    check(not made.picture.shown, "the picture of what is refused")
    shot("refused-points")
    # A setting that is wrong in itself.
    write(made.fields["Limit"].widget.lineEdit(), "0.5")
    write(made.fields["Filter"].widget.lineEdit(), "mean:4")
    settled(made)
    check(not ok_button().isEnabled() and "Filter" in ok_button().toolTip(), f"wrong filter: {ok_button().toolTip()!r}")
    check(made.message.isVisible(), "nothing at the top tells of the wrong filter")
    write(made.fields["Filter"].widget.lineEdit(), "auto")
    settled(made)
    check(ok_button().isEnabled() and not ok_button().toolTip() and not made.points.shown, "sound again")
    made.reject()
    FreeCADGui.Control.closeDialog()
    wait(300)


def icon_of(obj):
    return os.path.basename(obj.ViewObject.Proxy.getIcon())


def doubted(document, obj):
    """The operation was changed after the part was measured: a mark in the tree, a line in the panel, until OK."""
    from millcorr.gui import panel

    equal(icon_of(obj), "Millcorr_Dressup.svg", "icon before")
    base = obj.Base
    before = base.FinalDepth.Value
    document.openTransaction("depth")
    base.setExpression("FinalDepth", None)
    base.FinalDepth = before - 1.0
    document.recompute()
    document.commitTransaction()
    wait(300)
    equal(icon_of(obj), "Millcorr_Doubt.svg", f"icon after the operation was changed: {list(obj.Warnings)}")
    shot("doubt-tree")
    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    check(
        made.message.isVisible() and "cut with" in made.message.text(), f"no line in the panel: {made.message.text()!r}"
    )
    check(ok_button().isEnabled(), "a doubt forbids OK")
    shot("doubt-panel")
    accept(made)
    equal(icon_of(obj), "Millcorr_Dressup.svg", "icon once the user knows")
    document.undo()
    document.recompute()
    wait(300)
    equal([base.FinalDepth.Value, obj.Label], [before, "Profile corrected, 2 parts"], "after undo of the depth")


def turn(widget):
    """The wheel over a widget."""
    core = QtCore
    middle = core.QPointF(widget.rect().center())
    event = QtGui.QWheelEvent(
        middle, core.QPointF(widget.mapToGlobal(widget.rect().center())), core.QPoint(0, 0), core.QPoint(0, -120),
        core.Qt.NoButton, core.Qt.NoModifier, core.Qt.NoScrollPhase, False,
    )  # fmt: skip
    QtGui.QApplication.sendEvent(widget, event)
    wait(10)


def value_of(widget):
    return widget.currentText() if isinstance(widget, QtGui.QComboBox) else widget.value()


def wheel(name, root):
    """No number, choice or slider of a window takes the wheel before it has the focus."""
    kinds = (QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QSlider)
    fields = [child for kind in kinds for child in root.findChildren(kind)]
    fields = [field for field in fields if "qt_" not in field.objectName()]
    check(len(fields) > 0, f"{name}: no fields")
    for field in fields:
        field.clearFocus()
        before = value_of(field)
        turn(field)
        equal(value_of(field), before, f"{name}: wheel over {field.objectName()}")
    return len(fields)


def entered(name, here):
    """Return in a field ends its entry: it neither closes a window nor writes what lacks something."""
    for line in here.findChildren(QtGui.QLineEdit):
        if line.isVisible() and line.isEnabled():
            press(line, Key.Key_Return, text="\r")
    check(here.isVisible(), f"{name}: Return in a field closes it")
    task = getattr(here, "task", None)
    check(task is None or not (task.writing or task.written), f"{name}: Return in a field writes")


def wheels(document, obj):
    from millcorr.gui import file_task, import_dialog, panel
    from millcorr.gui.transfer_panel import SplitPanel, TransferPanel

    counted = {}
    for name, make in (
        ("panel", obj.ViewObject.Proxy.panel),
        ("transfer", lambda: TransferPanel(obj)),
        ("split", lambda: SplitPanel(obj)),
    ):
        made = make()
        panel.show(made)
        settled(made)
        counted[name] = wheel(name, made.form)
        # Return that ends the entry of another number computes anew, and is not OK.
        box = next(box for box in made.form.findChildren(QtGui.QDoubleSpinBox) if box.isVisible() and box.isEnabled())
        write(box.lineEdit(), f"{box.value() + box.singleStep():.6f}")
        check(not made.closed and FreeCADGui.Control.activeDialog(), f"{name}: Return in a field is taken for OK")
        settled(made)
        if name == "panel":
            # With the focus it counts.
            gain = made.fields["Gain"].widget
            gain.setFocus()
            wait(50)
            if gain.hasFocus():
                before = gain.value()
                turn(gain)
                check(gain.value() != before, "the wheel over a field with the focus does nothing")
        made.reject()
        FreeCADGui.Control.closeDialog()
        wait(200)
    select(obj)
    for command in ("Program", "Probe", "Simulate", "Batch", "History", "Measurement"):
        FreeCADGui.runCommand(f"Millcorr_{command}", 0)
        wait(300)
        here = import_dialog._open[0] if command == "Measurement" else list(file_task._open.values())[-1]
        counted[command] = wheel(command, here) if command not in ("Batch", "History") else 0
        room = QtGui.QApplication.primaryScreen().availableGeometry()
        check(here.height() <= room.height() - 40 and here.width() <= room.width(), f"{command} is {here.size()}")
        if command in ("Probe", "Simulate"):
            # Tree and toolbars are where they were.
            check(isinstance(here, QtGui.QDockWidget) and not here.isFloating(), f"{command} is not docked")
            shot(f"docked-{command.lower()}")
        entered(command, here)
        name = here.objectName()
        press(here, Key.Key_Escape)
        wait(200)
        there = [w for w in QtGui.QApplication.allWidgets() if w.objectName() == name and w.isVisible()]
        check(not there and not file_task._open, f"Escape does not close {command}")
    check(sum(counted.values()) > 40, f"fields: {counted}")


def pressed_twice(document, obj):
    """OK is pressed twice while it computes: one step of undo, and nothing is left open."""
    from millcorr.gui import panel

    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    undone = document.UndoCount
    write(made.fields["Gain"].widget.lineEdit(), "0.8")
    check(made.busy, "a changed gain is not computed")
    button = ok_button()
    button.click()
    button.click()
    until(lambda: not FreeCADGui.Control.activeDialog(), "OK that was pressed twice")
    wait(300)
    equal([obj.Gain, document.UndoCount - undone, made.closed], [0.8, 1, True], "after two clicks on OK")
    document.undo()
    document.recompute()
    wait(300)
    equal(obj.Gain, 1.0, "gain after undo")


def written_twice(obj):
    """What writes is clicked twice: it is written once."""
    from millcorr.gui import file_task

    select(obj)
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    here = list(file_task._open.values())[-1]
    task, noted = here.task, len(recorded)
    task.fields["BallRadius"].show_value(2.5)
    task.fields["Output"].show_value(path("twice.ngc"))
    task.changed()
    until(lambda: not task.busy, "plan of touches")
    button = here.findChild(QtGui.QPushButton, "Write")
    button.click()
    button.click()
    until(lambda: not task.writing, "a measuring program")
    wait(200)
    told = [line for line in recorded[noted:] if "twice.ngc" in line]
    check(len(told) == 1 and os.path.exists(path("twice.ngc")), f"two clicks write {len(told)} times: {task.wrong}")
    here.close()
    wait(300)


def closing(document):
    """The document is closed while windows about it, and a panel in the task view, are open."""
    from millcorr.gui import file_task, import_dialog, panel

    obj = document.getObject("DressupMillcorr")
    select(obj)
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    select(obj)
    FreeCADGui.runCommand("Millcorr_Simulate", 0)
    select(obj)
    FreeCADGui.runCommand("Millcorr_Measurement", 0)
    equal([len(file_task._open), len(import_dialog._open)], [2, 1], "windows about the document")
    made = obj.ViewObject.Proxy.panel()
    check(panel.show(made), f"a task is open: {FreeCADGui.Control.activeDialog()}")
    settled(made)
    write(made.fields["Limit"].widget.lineEdit(), "0.0005")
    settled(made)
    check(made.wrong, "a limit that is too small is not refused")
    until(lambda: made.points.shown, "points of a refused correction")
    FreeCAD.closeDocument(document.Name)
    wait(500)
    left = [*file_task._open, *import_dialog._open]
    check(made.closed and not FreeCADGui.Control.activeDialog() and not left, f"windows outlive the document: {left}")


def twice_clicked(obj):
    """Two double clicks open one panel; Enter in a field looks again and is not OK."""
    from millcorr.gui import panel

    view = obj.ViewObject
    check(view.Proxy.doubleClicked(view) and view.Proxy.doubleClicked(view), "double click")
    equal(len(panel._shown), 1, "panels")
    made = panel._shown[0]
    settled(made)
    gain = made.fields["Gain"].widget
    write(gain.lineEdit(), "0.9")
    check(FreeCADGui.Control.activeDialog() and made.busy, "Enter in a field is taken for OK")
    settled(made)
    made.reject()
    FreeCADGui.Control.closeDialog()
    wait(300)
    equal(obj.Gain, 1.0, "gain after Cancel")


def story():
    record()
    document = FreeCAD.openDocument(path("corrected.FCStd"))
    document.UndoMode = 1
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    tidy()
    top()
    obj = document.getObject("DressupMillcorr")
    once, twice = second_part(document, obj)
    off_and_on(document, obj, once, twice)
    escape(document, obj)
    twice_clicked(obj)
    with open(path("verbs.json"), "w", encoding="utf-8") as stream:
        json.dump({"lines": recorded, "label": obj.Label, "path": words(obj)}, stream)
    refused(document, obj)
    doubted(document, obj)
    pressed_twice(document, obj)
    wheels(document, obj)
    written_twice(obj)
    closing(document)


play(story)
