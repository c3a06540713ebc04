# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in Ukrainian and German: commands, forms and properties speak them."""

import os
import sys

import FreeCAD
import FreeCADGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from story_shop import dialog
from window import check, equal, path, play, shot, tidy, wait

SAID = {
    "Ukrainian": ("Вимірювальна програма…", "Зона нечутливості", "Деталь"),
    "German": ("Messprogramm…", "Totband", "Teil"),
}


def story():
    from millcorr.app.text import label_of, translate

    FreeCAD.openDocument(path("demo.FCStd"))
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


play(story)
