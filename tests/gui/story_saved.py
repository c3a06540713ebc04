# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that was corrected without a window is opened with one: looked at, refused, posted, undone, deleted."""

import os
import sys

import FreeCAD
import FreeCADGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from paths import difference
from window import VERSION, active, check, equal, found, path, play, select, shot, tidy, top, tree, wait


def story():
    from millcorr.app import compat

    check("MillcorrWorkbench" in FreeCADGui.listWorkbenches(), "there is no workbench")
    document = FreeCAD.openDocument(path("corrected.FCStd"))
    obj = document.getObject("DressupMillcorr")
    before = obj.Path.toGCode()
    equal([obj.Visibility, obj.Base.Visibility], [True, False], "visible")
    tidy()
    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    wait(500)
    top()
    equal(type(obj.Proxy).__name__, "DressupMillcorr", "proxy")
    equal(type(obj.ViewObject.Proxy).__name__, "DressupView", "view")
    equal([child.Label for child in obj.ViewObject.Proxy.claimChildren()], ["Profile"], "children")
    proxies = [getattr(o.ViewObject, "Proxy", None) for o in document.Objects]
    ours = [proxy for proxy in proxies if "millcorr" in type(proxy).__module__]
    check(len(ours) == 2 and all(os.path.exists(proxy.getIcon()) for proxy in ours), "icons")
    obj.touch()
    document.recompute()
    check("Invalid" not in obj.State, f"not valid: {obj.getStatusString()}")
    # Headless and with a window FreeCAD may have different numpys.
    check(difference(before, obj.Path.toGCode()) <= 1e-5, "recomputing changed the path")
    select(obj)
    names = [name for name in FreeCADGui.listCommands() if name.startswith("Millcorr_")]
    check(len(names) >= 5 and all(active(name) for name in names), f"not all are usable: {names}")
    FreeCADGui.runCommand("Millcorr_Profile", 0)
    wait(300)
    profile = document.getObject("MillcorrProfile")
    check(profile is not None and len(profile.Shape.Edges) == 1, "no compensated profile")
    document.undo()
    check(document.getObject("MillcorrProfile") is None, "the profile is still there after undo")
    labels = tree()
    equal(labels.get("Profile corrected"), ["Profile"], "operation below the dressup in the tree")
    below_job = [labels.get(child, []) for child in labels.get("Job", [])]
    check(
        any("Profile corrected" in children for children in below_job), "the tree does not show the dressup in the job"
    )
    shot("saved")
    FreeCADGui.activateWorkbench("CAMWorkbench" if "CAMWorkbench" in FreeCADGui.listWorkbenches() else "PathWorkbench")
    wait(800)
    select(obj)
    shot("saved-cam")
    text = compat.post(compat.parent_job(obj))
    equal(text.count("begin operation: " + obj.Label), 1, "posted so many times")
    check("millcorr" in text and text.count("G2 "), "the posted program is not the corrected one")
    obj.Limit = 1e-4
    document.recompute()
    check("Invalid" in obj.State and not obj.Path.Commands, "a refused correction leaves a path")
    shot("saved-refused")
    obj.Limit = 0.5
    document.recompute()
    select(obj)
    FreeCADGui.runCommand("Std_Delete", 0)
    wait(500)
    equal([o.Label for o in compat.operations(compat.jobs(document)[0])], ["Profile"], "operations after deleting")
    found["figures"]["version"] = VERSION


play(story)
