# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window of a measuring program: probe, control, places; the touches in the 3-D view, the program as text."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from millcorr.app import candidates, draft, measuring
from millcorr.app.properties import QT_TRANSLATE_NOOP, Property
from millcorr.app.text import translate
from millcorr.app.wording import worded
from millcorr.errors import UsageError
from millcorr.messages import option, phrase
from millcorr.probing import TOUCHES
from millcorr.report.picture.probing import overlay_of

from . import file_task, preferences
from .line_set import LineLayer
from .options import Expression, call
from .program_task import PROGRAMS
from .qt import QtWidgets

_text = QT_TRANSLATE_NOOP

CHECKED = {
    "linuxcnc": _text("Millcorr", "Run in LinuxCNC's own interpreter. Moves between touches are unprotected."),
    "linuxcnc-protected": _text(
        "Millcorr", "Run in LinuxCNC's own interpreter. Moves between touches stop at contact. Prefer it."
    ),
    "grbl": _text(
        "Millcorr", "Run in an interpreter written after GRBL's documentation. Moves between touches are unprotected."
    ),
    "fanuc": _text(
        "Millcorr", "Run in an interpreter written after Renishaw's description of its cycles; result variables "
        "compared with public tables."
    ),
    "haas": _text(
        "Millcorr", "Run in an interpreter written after Renishaw's description of its cycles; result variables "
        "compared with public tables."
    ),
    "okuma": _text(
        "Millcorr", "Run in an interpreter written after public descriptions. No manual with the names of the "
        "arguments was at hand: compare with yours."
    ),
    "heidenhain": _text("Millcorr", "Run in an interpreter written after the description of TCH PROBE cycle 3."),
    "siemens": _text("Millcorr", "Run in an interpreter written after the programming manual of MEAS."),
}  # fmt: skip
"""What was checked of each dialect."""

_CONTROL = (
    Property(
        "Enumeration", "Dialect", "", _text("App::Property", "Control that runs it"), preferences.CHOICES["Dialect"]
    ),
    Property("SaveFile", "Output", "", _text("App::Property", "Measuring program to write"), PROGRAMS),
)
_PROBE = (
    Property(
        "Length", "BallRadius", "", _text("App::Property", "Radius at which the probe triggers, as calibrated"), 0.0
    ),
    Property(
        "Integer",
        "PointsCount",
        "",
        _text("App::Property", "Number of points; 0: by their distance"),
        40,
        zero=_text("Millcorr", "by their distance"),
    ),
    Property(
        "Length",
        "Spacing",
        "",
        _text("App::Property", "Distance of points along the contour"),
        0.0,
        zero=_text("Millcorr", "by their number"),
    ),
    Property("Bool", "Curvature", "", _text("App::Property", "Denser where the contour bends"), False),
    Property(
        "Enumeration",
        "Touch",
        "",
        _text("App::Property", "Along an axis where the slope allows it, always along an axis, or along the normal"),
        TOUCHES,
    ),
)
_ROOM = (
    Property("Distance", "Z", "", _text("App::Property", "Height to measure at"), 0.0),
    Property("Distance", "SafeZ", "", _text("App::Property", "Height at which the probe passes over everything"), 0.0),
    Property("Length", "Clearance", "", _text("App::Property", "Distance from which a touch begins"), 2.0),
    Property("Length", "Overtravel", "", _text("App::Property", "How far behind the surface a touch gives up"), 1.0),
    Property("Length", "Stock", "", _text("App::Property", "Stock that is still on the contour"), 0.0),
    Property(
        "Length",
        "FreeWidth",
        "",
        _text("App::Property", "How far beside the contour it is free; 0: everywhere"),
        0.0,
        zero=_text("Millcorr", "everywhere"),
    ),
)
_MORE = (
    Property("Link", "Nominal", "", _text("App::Property", "Contour to measure, where it is not the operation's own")),
    Property("Feed", "Feed", "", _text("App::Property", "Feed of the touch"), 100.0),
    Property("Feed", "PositioningFeed", "", _text("App::Property", "Feed of moves at measuring height"), 1000.0),
    Property(
        "Integer",
        "ProbeTool",
        "",
        _text("App::Property", "Number of the probe in the magazine; 0: it is in use"),
        0,
        zero=_text("Millcorr", "it is in use"),
    ),
    Property("String", "Log", "", _text("App::Property", "Name of the file the control writes; empty: as usual"), ""),
)


class MeasuringTask(file_task.FileTask):
    """A measuring program of an operation.

    Parameters
    ----------
    operation : document object
        Operation or dressup that cuts the contour.
    """

    verb = _text("Millcorr", "Write program")
    aside = True

    def __init__(self, operation: Any) -> None:
        super().__init__(translate("Millcorr", "Measuring program"), "Millcorr_Probe", "measuring-programs.md")
        self.operation, self.home = operation, operation.Document.Name
        self.picture = LineLayer(operation.Document)
        warned = QtWidgets.QLabel(
            translate(
                "Millcorr",
                "No program of millcorr has run on a real machine. Run the first one above the part, then with the "
                "feed override low and a hand on feed hold.",
            )
        )
        warned.setWordWrap(True)
        warned.setProperty("millcorr", "doubt")
        self.layout.addWidget(warned)
        self.group(translate("Millcorr", "Control"), _CONTROL, self.changed)
        self.checked = QtWidgets.QLabel()
        self.checked.setObjectName("Checked")
        self.checked.setWordWrap(True)
        self.layout.addWidget(self.checked)
        self.group(translate("Millcorr", "Probe and points on {}").format(operation.Label), _PROBE, self.changed)
        self.group(translate("Millcorr", "Room"), _ROOM, self.changed, folded=True)
        self.group(translate("Millcorr", "More settings"), _MORE, self.changed, folded=True)
        self.text = file_task.monospaced("Program", 9)
        self.layout.addWidget(self.text)
        self._show_values()
        self.changed()

    def _show_values(self) -> None:
        for row in (*_PROBE, *_ROOM, *_MORE):
            if row.default is not None:
                usual = row.default[0] if row.kind == "Enumeration" else row.default
                self.fields[row.name].show_value(usual)
        for name in ("BallRadius", "Dialect", "PositioningFeed"):
            self.fields[name].show_value(preferences.get(name))
        self.fields["Feed"].show_value(preferences.get("TouchFeed"))
        shapes = candidates.shapes(self.operation.Document)
        self.fields["Nominal"].offer(shapes, translate("Millcorr", "the operation's own contour"))
        # Heights follow from probe and part until the user says others.
        self._said: set[str] = set()
        for name in ("Z", "SafeZ"):
            self.fields[name].show_value(0.0)
            self.fields[name].widget.valueChanged.connect(lambda *_, name=name: self._said.add(name))

    def set_field(self, name: str, value: Any) -> None:
        """Give a field a value as if the user had."""
        self._said.add(name)
        super().set_field(name, value)

    def changed(self) -> None:
        """Look again, and say what was checked of the dialect."""
        self.checked.setText(translate("Millcorr", CHECKED[self.fields["Dialect"].value]))
        super().changed()

    def missing(self) -> list[str]:
        """The probe's ball."""
        return [] if self.fields["BallRadius"].value > 0 else ["BallRadius"]

    def _options(self) -> dict[str, Any]:
        v = self.values
        probe = {
            "ball_radius": v["BallRadius"],
            "clearance": v["Clearance"],
            "overtravel": v["Overtravel"],
            "stock": v["Stock"],
            "touch": v["Touch"],
        }
        if v["FreeWidth"]:
            probe["free_width"] = v["FreeWidth"]
        placement: dict[str, Any] = {"count": v["PointsCount"]} if v["PointsCount"] else {"spacing": v["Spacing"]}
        if v["Curvature"]:
            placement["by_curvature"] = True
        return {
            "dialect": v["Dialect"],
            "probe": probe,
            "placement": placement,
            "nominal": v["Nominal"],
            "z": v["Z"] if "Z" in self._said else None,
            "safe_z": v["SafeZ"] if "SafeZ" in self._said else None,
            "feed": v["Feed"],
            "positioning": v["PositioningFeed"],
            "tool": v["ProbeTool"] or None,
            "log": v["Log"] or None,
            "output": v["Output"] or "PROBE.nc",
        }

    def work(self) -> Callable[[], Any]:
        """Plan and write, in memory."""
        return measuring.prepared(self.operation, **self._options())

    def show_outcome(self, outcome: Any) -> None:
        """What is touched, what is not and why, and the program."""
        self.say(file_task.spaced(worded(outcome.words())), "doubt" if outcome.warnings else "good")
        self.text.setPlainText(outcome.text)
        self.fields["Z"].show_value(outcome.z)
        self.fields["SafeZ"].show_value(outcome.safe_z)
        self.picture.fill(overlay_of(outcome.plan, outcome.z, outcome.safe_z))

    def show_failure(self, text: str) -> None:
        """No program, and why."""
        self.text.setPlainText("")
        self.picture.hide()
        # The tool of a measuring program is the probe.
        super().show_failure(text)

    def job(self) -> file_task.Job:
        """Write the program and what it needs beside it."""
        if not self.fields["Output"].value:
            raise UsageError(phrase("{} needs a name: the measuring program is written there", option("output")))
        if not self.complete():
            raise UsageError(phrase("{}: say the radius at which the probe triggers", option("probe_radius")))
        output = file_task.absolute([self.fields["Output"].value])[0]
        options = self._options()
        made = measuring.prepared(self.operation, **options)
        del options["output"]
        said = options | {"nominal": None if options["nominal"] is None else _named(options["nominal"])}
        lines = [
            "from millcorr.app import measuring",
            f"print({call('measuring.write', _named(self.operation), output, **said)})",
        ]
        return file_task.Job(lines, measuring, "write", lambda: measuring.written(made(), Path(output)))

    def stop_all(self) -> None:
        """Take the touches out of the 3-D view, too."""
        self.picture.remove()
        super().stop_all()


def _named(obj: Any) -> Expression:
    return Expression(draft.in_python(obj))
