# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's door with a window: registers the workbench, nothing else."""

import FreeCADGui

import millcorr.gui.viewproviders  # noqa: F401  objects find their views through it
from millcorr.gui import cam_menu, commands, macros, preferences, translations

translations.add()
preferences.add_page()
# Here and not in Initialize: CAM's menu offers them before this workbench was ever shown.
commands.register()
macros.register()
cam_menu.add()


class MillcorrWorkbench(FreeCADGui.Workbench):
    def __init__(self):
        # FreeCAD runs this file inside a function: only imports within methods are seen there.
        from FreeCAD import Qt

        from millcorr.gui.icons import icon

        self.__class__.Icon = icon("Millcorr")
        self.__class__.MenuText = Qt.translate("Workbench", "Millcorr")
        self.__class__.ToolTip = Qt.translate("Workbench", "Correct milling toolpaths from measured parts")

    def Initialize(self):
        from FreeCAD import Qt

        from millcorr.gui import commands, macros

        names = list(commands.NAMES)
        self.appendToolbar("Millcorr", names)
        self.appendToolbar("Millcorr macros", list(macros.NAMES))
        self.appendMenu("Millcorr", names)
        self.appendMenu(["Millcorr", Qt.translate("Workbench", "Macros")], list(macros.NAMES))

    def Activated(self):
        from millcorr.gui import guide, packages

        guide.watch_links()
        packages.tell_once()

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(MillcorrWorkbench())
