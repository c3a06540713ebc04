# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction: how much larger it is drawn, in which colours, between which limits."""

import os
import re
import sys

import FreeCAD
import FreeCADGui
import numpy
from PySide import QtCore, QtGui

sys.path.insert(0, os.environ["MILLCORR_TESTS"])

from window import (
    SETUP,
    VERSION,
    check,
    colours,
    equal,
    found,
    like,
    path,
    play,
    select,
    shot,
    theme,
    tidy,
    tooltip,
    top,
    until,
    view,
    wait,
    write,
)

Key = QtCore.Qt.Key


def settled(panel):
    until(lambda: not panel.busy, "computing")
    wait(100)


def measured(document):
    from millcorr.app import measurement_object

    return measurement_object.create(document, path("cmm.csv"), "contact")


def opened(document):
    """The panel of a new correction, with its picture's fields shown."""
    from millcorr.gui import dressup_panel, panel

    made = dressup_panel.new(document.getObject("Profile"), measured(document))
    panel.show(made)
    settled(made)
    equal(made.wrong, "", "first result")
    fold = made.fields["Magnification"].widget
    while not hasattr(fold, "setChecked"):
        fold = fold.parentWidget()
    fold.setChecked(True)
    wait(100)
    return made


def put(made, **values):
    """Set fields as the user does."""
    for name, value in values.items():
        made.fields[name].show_value(value)
    made._look_changed()
    settled(made)


def longest(made):
    """Longest whisker over the largest deviation."""
    drawn = made.picture.drawn
    ends = drawn.overlay.whiskers.vertices.reshape(-1, 2, 3).astype(float)
    length = numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return float(length.max() / numpy.abs(drawn.result.deviation.value).max())


def magnified(made):
    """By itself, as the user wants, and never so much that the profile is turned inside out."""
    automatic, number = made.fields["AutomaticMagnification"], made.fields["Magnification"]
    check(automatic.value and not number.widget.isEnabled(), "the magnification is not chosen by itself")
    chosen = number.value
    equal(chosen, made.picture.drawn.overlay.magnification, "magnification in the form and of the picture")
    check(abs(longest(made) / chosen - 1) < 1e-3, f"whiskers are drawn at {longest(made)} instead of {chosen}")
    put(made, AutomaticMagnification=False)
    check(number.widget.isEnabled(), "the magnification cannot be written")
    write(number.widget.lineEdit(), f"{chosen - 50:.0f}")
    settled(made)
    check(abs(longest(made) / (chosen - 50) - 1) < 1e-3, f"whiskers are drawn at {longest(made)}")
    check(not number.note.isVisible(), f"a word beside a sound magnification: {number.note.text()}")
    write(number.widget.lineEdit(), "900000")
    settled(made)
    bound = made.picture.drawn.overlay.bound
    check(bound < 900000 and abs(longest(made) / bound - 1) < 1e-3, f"{longest(made)} is not the bound {bound}")
    check(number.note.isVisible() and "inside out" in number.note.text(), "no word beside too large a magnification")
    write(number.widget.lineEdit(), "-2023")
    settled(made)
    check(number.value >= 1, f"a magnification of {number.value}")
    put(made, AutomaticMagnification=True)
    equal(number.value, chosen, "magnification chosen again")
    found["figures"]["magnification"] = chosen


def coloured(made):
    """Material left blue or red, limits of their own for both directions."""
    from millcorr.report.picture import scale

    top()
    for name in ("blue", "red"):
        put(made, MaterialLeft=name)
        counted = colours(f"material-{name}")
        drawn = made.picture.drawn.overlay.scale
        above, below = drawn.shades[: drawn.within], drawn.shades[drawn.within + 1 :]
        blue, red = (sum(like(counted, shade) for shade in shades) for shades in _by_colour(above, below, name))
        check(blue > 300 and red > 150, f"material left {name}: {blue} blue and {red} red pixels")
        first = scale.BLUE if name == "blue" else scale.RED
        equal(hex(int(above[0])), hex(int(scale._packed(numpy.array([first[1]]))[0])), "colour of most material left")
    shot("picture-red")
    put(made, MaterialLeft="blue", UpperLimit=0.02, LowerLimit=0.015)
    settled(made)
    check(made.fields["LowerLimit"].note.text() == "", "limits that are sound are refused")
    put(made, UpperLimit=0.01)
    check("upper" in made.fields["LowerLimit"].note.text(), "an upper limit below the lower one is taken")
    put(made, UpperLimit=0.004, LowerLimit=-0.02)
    equal(made.picture.drawn.overlay.scale.steps[4:6].tolist(), [0.004, -0.02], "limits of the picture")
    value = made.picture.drawn.result.deviation.value
    green = (made.picture.drawn.overlay.whiskers.colours[::2] == made.picture.drawn.overlay.scale.shades[4]).sum()
    equal(int(green), int(((value <= 0.004) & (value >= -0.02)).sum()), "whiskers in tolerance")
    for name in ("dark", "light"):
        theme(name)
        shot(f"picture-{name}")
    theme("")


def _by_colour(above, below, material_left):
    """Shades that are blue, and those that are red."""
    return (above, below) if material_left == "blue" else (below, above)


def kept(document, made):
    """A dressup keeps how it is looked at; a document of an earlier version has its band as two limits."""
    check(made.accept(), "OK")
    FreeCADGui.Control.closeDialog()
    wait(300)
    obj = document.getObject("DressupMillcorr")
    vobj = obj.ViewObject
    equal([vobj.UpperLimit.Value, vobj.LowerLimit.Value, vobj.MaterialLeft], [0.004, -0.02, "blue"], "view")
    equal(vobj.getEditorMode("Magnification"), ["ReadOnly"], "editor of what is chosen by itself")
    vobj.AutomaticMagnification = False
    equal(vobj.getEditorMode("Magnification"), [], "editor of a magnification")
    vobj.Magnification = 100.0
    until(lambda: obj.ViewObject.Proxy._picture.drawn.overlay.magnification == 100.0, "magnification of the view")
    # What documents had before there were two limits.
    vobj.addProperty("App::PropertyLength", "ToleranceBand", "Picture", "")
    vobj.ToleranceBand = 0.006
    document.saveAs(path("picture.FCStd"))
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path("picture.FCStd"))
    obj = document.getObject("DressupMillcorr")
    until(lambda: obj.ViewObject.Proxy._picture is not None, "picture after opening")
    vobj = obj.ViewObject
    equal([vobj.UpperLimit.Value, vobj.LowerLimit.Value, vobj.Magnification], [0.006, -0.006, 100.0], "view reopened")
    check("ToleranceBand" not in vobj.PropertiesList, "the earlier version's property is still there")
    return document


def simulated(document):
    """Also in the simulation: by itself, and no number that is none."""
    from millcorr.gui import simulation_task

    with open(path("setup.toml"), "w", encoding="utf-8") as stream:
        stream.write(SETUP)
    task = simulation_task.SimulateTask(document.getObject("Profile"))
    task.fields["Setup"].show_value(path("setup.toml"))
    task.changed()
    until(lambda: not task.busy, "simulation", 120)
    equal(task.wrong, "", "what is wrong with the simulation")
    number = task.fields["Magnification"]
    check(number.value >= 1 and not number.widget.isEnabled(), "the simulation's magnification is not chosen by itself")
    check(f"{number.value:g}:1" in task.found.text(), f"its figure is not told: {task.found.text()}")
    found["figures"]["simulation"] = number.value
    task.fields["AutomaticMagnification"].widget.setChecked(False)
    write(number.widget.lineEdit(), "-2023")
    until(lambda: not task.busy, "simulation", 120)
    check(number.value >= 1, f"the simulation takes a magnification of {number.value}")
    write(number.widget.lineEdit(), "1000000")
    until(lambda: not task.busy, "simulation", 120)
    check("inside out" in number.note.text(), "no word beside too large a magnification of the simulation")
    task.stop_all()


def on_wall(document):
    """The wall has the colours of its deviation; a place of it, or of the plot, leads to plot and file's line."""
    from millcorr.gui import plots

    obj = document.getObject("DressupMillcorr")
    vobj, shown = obj.ViewObject, obj.ViewObject.Proxy._picture
    until(lambda: shown.shown, "picture")
    check(vobj.Wall and vobj.Whiskers, "wall and whiskers are not both shown at first")
    job = next(o for o in document.Objects if hasattr(o, "Operations"))
    job.Stock.Visibility = False
    vobj.UpperLimit, vobj.LowerLimit = 0.01, -0.01
    for name in ("Whiskers", "Band", "Profiles", "Paths", "RejectedPoints"):
        setattr(vobj, name, False)
    until(lambda: shown.drawn.look.upper == 0.01, "limits of the view")
    FreeCADGui.Selection.clearSelection()
    view().viewIsometric()
    view().fitAll()
    wait(500)
    seen = hues("wall")
    check(seen["blue"] > 300 and seen["green"] > 300, f"colours of the wall: {seen}")
    shot("wall")
    vobj.Wall = False
    wait(200)
    gone = hues("no-wall")
    check(gone["blue"] < seen["blue"] / 4, f"the wall cannot be switched off: {gone}")
    vobj.Wall = vobj.Whiskers = vobj.Profiles = True
    select(obj)
    picked(document, obj, plots)


def hues(name):
    """Pixels that are more blue, green or red than anything else: the wall is shaded."""
    file = os.path.join(os.environ["MILLCORR_SHOTS"], f"{VERSION}-{name}-view.png")
    view().saveImage(file, 900, 600, "White")
    image = QtGui.QImage(file)
    out = {"blue": 0, "green": 0, "red": 0}
    # Right of the legend.
    for x in range(300, image.width()):
        for y in range(image.height()):
            r, g, b = ((image.pixel(x, y) >> k) & 255 for k in (16, 8, 0))
            if max(r, g, b) - min(r, g, b) > 60:
                out["red" if r >= max(g, b) else "green" if g >= b else "blue"] += 1
    return out


def picked(document, obj, plots):
    FreeCADGui.runCommand("Millcorr_Plots", 0)
    dock = plots.dock()
    until(lambda: dock.result is not None, "plots")
    wait(500)
    view().viewIsometric()
    view().fitAll()
    wait(500)
    shown, result = obj.ViewObject.Proxy._picture, dock.result
    obj.ViewObject.Whiskers = False
    wait(200)
    # A place of the wall that is turned to the viewer.
    eye = numpy.array(view().getViewDirection())
    row = int((result.deviation.normal @ eye[:2]).argmin())
    x, y = result.deviation.foot[row]
    on_screen = getattr(view(), "getPointOnViewport", None) or view().getPointOnScreen
    place = on_screen(float(x), float(y), float(result.deviation.z[row]))
    pick = shown.pick_at(view(), *place)
    if check(pick is not None, "nothing is picked on the wall"):
        apart = result.deviation.foot[pick.row] - result.deviation.foot[row]
        check(float(numpy.hypot(*apart)) < 1.2, f"picked {apart} mm beside")
        obj.ViewObject.Proxy._picked(pick)
        line = int(result.request.measurement.lines[pick.index])
        check(f"cmm.csv:{line}" in dock.told.text(), f"the line is not told: {dock.told.text()}")
        with open(path("cmm.csv"), encoding="utf-8") as stream:
            text = stream.read().split("\n")[line - 1]
        check(text in dock.told.text(), f"what the line says is not told: {dock.told.text()}")
        equal(dock.file.textCursor().block().text().split(None, 1), [str(line), text], "line that stands out")
        check(dock.pages["along"].canvas._pin is not None, "the place is not kept in the plot")
        check(dock._mark.shown, "the place is not marked in the view")
    shot("wall-picked")
    dock.tabs.setCurrentWidget(dock.file)
    shot("wall-file")
    dock.tabs.setCurrentIndex(0)
    # The other way: a click in the plot.
    middle = 0.5 * dock.along.total
    dock.pick_place(middle)
    line = int(result.request.measurement.lines[result.deviation.index[numpy.abs(dock.along.x - middle).argmin()]])
    check(f"cmm.csv:{line}" in dock.told.text(), f"a click in the plot tells {dock.told.text()}")
    obj.ViewObject.Whiskers = True
    dock.hide()


def inches(document):
    """FreeCAD's schema of inches holds in form, legend, text and plots; what is not touched stays as it was."""
    from millcorr.gui import panel, plots
    from millcorr.report.length_unit import INCH

    obj = document.getObject("DressupMillcorr")
    schema(3)
    made = obj.ViewObject.Proxy.panel()
    panel.show(made)
    settled(made)
    limit = made.fields["Limit"]
    check(limit.widget.text().endswith(" in"), f"the limit is in {limit.widget.text()}")
    equal([limit.value, made.fields["Tolerance"].value], [obj.Limit.Value, obj.Tolerance.Value], "lengths in mm")
    equal(made.lines(), [], "changes of a form that was only opened")
    write(limit.widget.lineEdit(), "0.02")
    settled(made)
    check(abs(made.draft.Limit - 0.508) < 1e-9, f"0.02 in are {made.draft.Limit} mm")
    mean = float(made.values["Mean"][0].text())
    check(abs(mean * 25.4 - obj.DeviationMean.Value) < 2e-5, f"mean {mean} in, {obj.DeviationMean} mm")
    pick = made.picture.drawn.result
    from millcorr.report.picture import correction as overlay

    check(" in" in overlay.whisker_text(pick, 0, INCH), "text of a whisker")
    shot("inch-panel")
    write(limit.widget.lineEdit(), "0.00001")
    settled(made)
    told = made.message.text()
    check(" in is needed at X" in told and " 1e-05 in" in told and " mm" not in told, f"a refusal in inches: {told!r}")
    made.reject()
    FreeCADGui.Control.closeDialog()
    wait(300)
    select(obj)
    FreeCADGui.runCommand("Millcorr_Plots", 0)
    dock = plots.dock()
    until(lambda: dock.result is not None, "plots in inches")
    wait(300)
    axes = dock.pages["along"].canvas.axes
    check("in" in axes.get_xlabel() and "thou" in axes.get_ylabel(), f"{axes.get_xlabel()}, {axes.get_ylabel()}")
    dock.point_at(25.4)
    check("thou" in dock.told.text() and "s 0.9" in dock.told.text(), dock.told.text())
    axes.figure.canvas.draw()
    ticks = [text.get_text() for text in axes.get_xticklabels()]
    check("2" in ticks or "2.5" in ticks, f"ticks in inches: {ticks}")
    shot("inch-plots")
    dock.hide()
    from millcorr.app import batch

    batch.export_report(obj, path("inches"))
    with open(os.path.join(path("inches"), "report.html"), encoding="utf-8") as stream:
        text = re.sub("<style>.*?</style>|<[^>]*>", " ", stream.read(), flags=re.DOTALL)
    check(" thou" in text and not re.search("\\d mm|\u00b5m|--[a-z]", text), "a report in millimetres, or with options")
    schema(6)


def schema(number):
    """Choose FreeCAD's units."""
    FreeCAD.Units.setSchema(number)
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", number)


def series_in_inches(document):
    """A journal is in mm; its table, its lines, its plot and the feeds of a measuring program are in inches."""
    from millcorr.gui import file_task, plots
    from millcorr.production import journal

    schema(3)
    select(document.getObject("DressupMillcorr"))
    FreeCADGui.runCommand("Millcorr_History", 0)
    here = list(file_task._open.values())[-1]
    task = here.task
    task.fields["Journal"].show_value(path("series.journal"))
    task.changed()
    until(lambda: not task.busy and task.table.rowCount() == 4, "history in inches")
    heads = [task.table.horizontalHeaderItem(k).text() for k in range(3, 7)]
    check(all(head.endswith(", thou") for head in heads), f"heads of the history: {heads}")
    mean = journal.read(path("series.journal"))[0].entries[0].statistics["deviation"]["mean"]
    check(abs(float(task.table.item(0, 3).text()) * 0.0254 - mean) < 5e-6, f"mean {task.table.item(0, 3).text()} thou")
    said = task.text.toPlainText()
    check(not re.search("\\d (mm|um|\u00b5m)", said), f"trends in millimetres: {said!r}")
    plots.show_history(task.chains)
    wait(300)
    label = plots.dock().pages["history"].canvas.axes.get_ylabel()
    check("thou" in label, f"a history in {label!r}")
    shot("inch-history")
    plots.dock().hide()
    here.close()
    wait(200)
    FreeCADGui.runCommand("Millcorr_Probe", 0)
    here = list(file_task._open.values())[-1]
    feed = here.task.fields["Feed"]
    equal([feed.widget.text(), feed.value], ["3.937 in/min", 100.0], "feed of a touch")
    here.close()
    wait(200)
    schema(6)


def plotted(document):
    """Plots show the document in front, and nothing of one that is closed or lies behind."""
    from millcorr.gui import plots

    select(document.getObject("DressupMillcorr"))
    FreeCADGui.runCommand("Millcorr_Plots", 0)
    dock = plots.dock()
    until(lambda: dock.result is not None, "plots")
    wait(300)
    canvas = dock.pages["along"].canvas
    equal([len(canvas.axes.collections) > 0, canvas.axes.axison], [True, True], "drawn")
    check(not dock.windowIcon().isNull(), "the dock has no icon")
    other = FreeCAD.newDocument("Other")
    wait(500)
    equal([dock.result, dock.obj], [None, None], "plotted while another document is in front")
    equal([len(canvas.axes.collections), canvas.axes.axison], [0, False], "drawn of the document behind")
    equal(len(dock.pages["distribution"].canvas.axes.patches), 0, "distribution drawn of the document behind")
    check("Select" in dock.told.text(), f"told of the document behind: {dock.told.text()}")
    shot("plots-empty")
    FreeCAD.setActiveDocument(document.Name)
    FreeCADGui.ActiveDocument = FreeCADGui.getDocument(document.Name)
    FreeCAD.closeDocument(other.Name)
    select(document.getObject("DressupMillcorr"))
    until(lambda: dock.result is not None, "plots again")
    series(dock)
    limit = document.getObject("DressupMillcorr").Limit.Value
    document.getObject("DressupMillcorr").Limit = 1e-4
    document.recompute()
    until(lambda: "\u201cLimit\u201d" in dock.told.text(), "a refusal in the plots", 20)
    equal(len(canvas.axes.collections), 0, "drawn of a correction that is refused")
    document.getObject("DressupMillcorr").Limit = limit
    document.recompute()
    until(lambda: dock.result is not None, "plots after the refusal")
    dock.hide()


def series(dock):
    """Parts, mean, form and limits of the series of a journal, one to choose where it has several."""
    from pathlib import Path

    from millcorr.production import journal

    dock.open_up("history")
    check("journal" in dock.told.text(), f"told without a journal: {dock.told.text()}")
    dock.show_history(journal.read(Path(path("series.journal"))))
    canvas = dock.pages["history"].canvas
    told = [text.get_text() for text in canvas.axes.get_legend().get_texts()]
    for name in ("range of the points", "mean and standard deviation", "form, root mean square", "limits"):
        check(name in told, f"the history does not show {name}: {told}")
    equal(canvas.axes.get_xlim(), (0.4, 10.6), "parts on the axis")
    check(not dock.linked.isVisible() and dock.told.text().startswith("demo.nc"), dock.told.text())
    shot("plots-history")
    dock.tabs.setCurrentIndex(0)
    check("demo.nc" not in dock.told.text(), f"the series is told on another page: {dock.told.text()}")


def tips(document):
    """A command's tooltip says what it does once, whatever the language; windows have icons."""
    from millcorr.gui import commands, icons

    FreeCADGui.activateWorkbench("MillcorrWorkbench")
    for language in ("German", "English"):
        FreeCADGui.setLocale(language)
        # FreeCAD asks its commands once something happens.
        select(document.getObject("Profile"))
        wait(1000)
        for command in commands.COMMANDS:
            said = FreeCAD.Qt.translate(command.name, command.tooltip)
            shown = tooltip(command.name)
            check(shown.count(said) == 1, f"the tooltip of {command.name} does not say once what it does: {shown}")
            text = FreeCADGui.Command.get(command.name).getAction()[0].whatsThis()
            check(".md" in text and said in text, f"What's this of {command.name}: {text}")
        check(not icons.qt_icon("Millcorr_Plots").isNull(), "no icon for windows")


def automatic(made):
    """Where 0 stands for something, the field says what."""
    for name, text in (("ToolDiameter", "the tool controller's"), ("NextDepth", "that of the measured part")):
        box = made.fields[name].widget
        equal([box.value(), box.text()], [0.0, text], f"field {name}")


def story():
    document = FreeCAD.openDocument(path("demo.FCStd"))
    document.UndoMode = 1
    tidy()
    select(document.getObject("Profile"))
    top()
    made = opened(document)
    automatic(made)
    magnified(made)
    coloured(made)
    document = kept(document, made)
    on_wall(document)
    inches(document)
    plotted(document)
    series_in_inches(document)
    simulated(document)
    tips(document)
    found["figures"]["version"] = VERSION


play(story)
