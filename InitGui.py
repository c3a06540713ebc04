# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's door with a window: registers the workbench, nothing else."""

import FreeCADGui

import millcorr.gui.viewproviders  # noqa: F401  objects find their views through it


class MillcorrWorkbench(FreeCADGui.Workbench):
    def __init__(self):
        # FreeCAD runs this file inside a function: only imports within methods are seen there.
        from FreeCAD import Qt

        from millcorr.gui.icons import icon

        self.__class__.Icon = icon("Millcorr")
        self.__class__.MenuText = Qt.translate("Workbench", "Millcorr")
        self.__class__.ToolTip = Qt.translate("Workbench", "Correct milling toolpaths from measured parts")

    def Initialize(self):
        from millcorr.gui import commands

        names = commands.register()
        self.appendToolbar("Millcorr", names)
        self.appendMenu("Millcorr", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(MillcorrWorkbench())
