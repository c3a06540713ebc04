# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the smoke test does inside FreeCAD's window; run.py starts it and reads what it found."""

import json
import os
import re
import sys
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

WORK = os.environ["MILLCORR_WORK"]
SHOTS = os.environ["MILLCORR_SHOTS"]
VERSION = ".".join(FreeCAD.Version()[:2])
found = {"version": VERSION}


def wait(milliseconds):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    getattr(loop, "exec", None)() if hasattr(loop, "exec") else loop.exec_()


def shot(name):
    wait(400)
    FreeCADGui.getMainWindow().grab().save(os.path.join(SHOTS, f"{VERSION}-{name}.png"))
    # The grabbed window lacks the drawing in 0.20.
    FreeCADGui.ActiveDocument.ActiveView.saveImage(os.path.join(SHOTS, f"{VERSION}-{name}-view.png"), 900, 600)


def tree():
    """Labels in the tree, each with the labels below it."""
    out = {}

    def walk(item, above):
        label = item.text(0)
        out.setdefault(label, []).extend(item.child(k).text(0) for k in range(item.childCount()))
        for k in range(item.childCount()):
            walk(item.child(k), label)

    for widget in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget):
        for k in range(widget.topLevelItemCount()):
            widget.expandAll()
            walk(widget.topLevelItem(k), None)
    return out


def difference(before, after):
    """Largest difference between the numbers of two paths, infinite where they differ in anything else."""
    number = re.compile(r"(?<=[XYZIJF])-?[0-9.]+")
    if number.sub("", before) != number.sub("", after):
        return 1e9
    pairs = zip(number.findall(before), number.findall(after), strict=True)
    return max(abs(float(a) - float(b)) for a, b in pairs)


def smoke():
    from millcorr.app import compat

    found["workbench"] = "MillcorrWorkbench" in FreeCADGui.listWorkbenches()
    document = FreeCAD.openDocument(os.path.join(WORK, "corrected.FCStd"))
    obj = document.getObject("DressupMillcorr")
    before = obj.Path.toGCode()
    found["visible"] = [obj.Visibility, obj.Base.Visibility]
    for dock in FreeCADGui.getMainWindow().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Combo View", "Model", "Tree view"):
            dock.show()
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    wait(500)
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    found["commands"] = [name for name in FreeCADGui.listCommands() if name.startswith("Millcorr_")]
    found["proxy"] = type(obj.Proxy).__name__
    found["view"] = type(obj.ViewObject.Proxy).__name__
    found["children"] = [child.Label for child in obj.ViewObject.Proxy.claimChildren()]
    proxies = [getattr(o.ViewObject, "Proxy", None) for o in document.Objects]
    ours = [proxy for proxy in proxies if "millcorr" in type(proxy).__module__]
    found["icons"] = len(ours) == 2 and all(os.path.exists(proxy.getIcon()) for proxy in ours)
    obj.touch()
    document.recompute()
    found["valid"] = "Invalid" not in obj.State
    found["why"] = [obj.getStatusString(), obj.Base.State, len(obj.Base.Path.Commands)]
    found["same"] = difference(before, obj.Path.toGCode())
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    wait(200)
    command = FreeCADGui.Command.get("Millcorr_Profile")
    found["active"] = {name: FreeCADGui.Command.get(name).isActive() for name in found["commands"]}
    command.run()
    wait(300)
    profile = document.getObject("MillcorrProfile")
    found["profile"] = profile is not None and len(profile.Shape.Edges)
    document.undo()
    found["undone"] = document.getObject("MillcorrProfile") is None
    found["tree"] = tree()
    shot("millcorr")
    name = "CAMWorkbench" if "CAMWorkbench" in FreeCADGui.listWorkbenches() else "PathWorkbench"
    FreeCADGui.activateWorkbench(name)
    wait(800)
    found["cam"] = FreeCADGui.activeWorkbench().name()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    shot("cam")
    text = compat.post(compat.parent_job(obj))
    found["posted"] = text.count("begin operation: " + obj.Label), "millcorr" in text, text.count("G2 ")
    obj.Limit = 1e-4
    document.recompute()
    found["refused"] = "Invalid" in obj.State and not obj.Path.Commands
    shot("refused")
    obj.Limit = 0.5
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    FreeCADGui.runCommand("Std_Delete", 0)
    wait(500)
    found["deleted"] = [o.Label for o in compat.operations(compat.jobs(document)[0])]


def main():
    try:
        smoke()
    # Whatever it is, the one who started this must read it.
    except BaseException:  # noqa: BLE001
        found["error"] = traceback.format_exc()
    with open(os.path.join(WORK, "found.json"), "w", encoding="utf-8") as stream:
        json.dump(found, stream, indent=1)
    sys.stdout.flush()
    os._exit(0)


QtCore.QTimer.singleShot(3000, main)
