# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says and does without a window: figures, remedies, work in the background, drafts."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest

from millcorr import distrust, gcode, pipeline
from millcorr.app.draft import Draft, in_python, lines_to_change, lines_to_create
from millcorr.errors import MillcorrError
from millcorr.gui.background import STAGES, Cancelled, Work, stage_of
from millcorr.gui.figures import figures_of, length
from millcorr.gui.remedies import Remedy, accepted_by, first_field, remedies_in, worded
from millcorr.measurement import Measurement
from millcorr.settings import Settings


def disc(scale=1.0, offset=0.0, ball=0.0, count=90):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    points = (
        scale
        * (40.0 + offset + 0.004 * np.cos(2 * angle))[:, None]
        * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    )
    return Measurement(points, None, ball, np.arange(1, count + 1), "disc.csv", "0", has_z=False)


def request(measurement, nominal=False, **settings):
    text = "G21 G90 G17\nG0 X45 Y0 Z5\nG1 Z-8 F100\nG2 X-45 Y0 I-45 J0 F300\nG2 X45 Y0 I45\nG0 Z5\nM2"
    program, chosen = gcode.parse(text, "disc.nc"), Settings(side="left", **settings)
    given = pipeline.nominal_from_program(program, 5.0, chosen, None) if nominal else None
    return pipeline.Request(program, 5.0, measurement, given, chosen)


def refusal(measurement, **settings):
    with pytest.raises(MillcorrError) as raised:
        pipeline.correct(request(measurement, nominal=True, **settings))
    return str(raised.value)


@pytest.mark.parametrize(
    ("measurement", "remedy", "name"),
    [
        (disc(1 / 25.4), Remedy("Unit", "inch"), "unit"),
        (disc(ball=3.0), Remedy("Points", "contact"), "compensated-twice"),
        (disc(offset=1.5, ball=3.0), Remedy("BallRadius", 1.5), "diameter-for-radius"),
        (disc(offset=2.0, ball=1.0), Remedy("BallRadius", 2.0), "radius-for-diameter"),
        (disc(offset=2.0), Remedy("Points", "centre"), "ball-not-compensated"),
    ],
)
def test_a_button_for_what_the_file_was_taken_for(measurement, remedy, name):
    message = refusal(measurement)
    assert remedies_in(message)[0] == remedy
    assert accepted_by(message) == name and name in distrust.NAMES
    assert "--" not in worded(message) and "accept" not in worded(message)
    assert remedy.in_words().startswith("Set ") and str(remedy.value).split(".")[0] in remedy.in_words()


@pytest.mark.parametrize(
    ("settings", "field"),
    [
        ({"gain": 5.0}, "Gain"),
        ({"limit": -1.0}, "Limit"),
        ({"dead_band": -0.1}, "DeadBand"),
        ({"tolerance": 1.0}, "Tolerance"),
        ({"align": "sideways"}, "Align"),
        ({"tools": ("x",)}, "Tools"),
        ({"unmeasured_share": 2.0}, "UnmeasuredShare"),
        ({"method": "transfer"}, "Method"),
    ],
)
def test_a_wrong_setting_is_told_beside_its_field(settings, field):
    with pytest.raises(MillcorrError) as raised:
        Settings(**settings)
    assert first_field(str(raised.value)) == field


def test_a_remedy_without_a_value_leads_to_its_field():
    found = remedies_in("check --tool-diameter, --points, --units, and --points contact")
    assert found == (Remedy("Points", "contact"), Remedy("ToolDiameter"), Remedy("Unit"))
    assert found[1].in_words() == "Go to Tool diameter"
    assert worded("check --tool-diameter.") == "check \u201cTool diameter\u201d."
    assert remedies_in("as --tool 3=16, or --unmeasured SHARE") == (Remedy("Tools"), Remedy("UnmeasuredShare"))
    assert remedies_in("too little stock; --keep-allowance moves it") == (Remedy("KeepAllowance", True),)
    assert remedies_in("nothing to do") == () and first_field("nothing") == "" and accepted_by("nothing") == ""


def test_figures_are_those_of_the_summary():
    result = pipeline.correct(request(disc()))
    shown = {figure.label: figure.shown for figure in figures_of(result.summary())}
    # Deviations are 0.004 cos 2a: mean 0, standard deviation 0.004 / sqrt 2 (n / (n - 1) under the root); of 90 places
    # in steps of 4 degrees none is at exactly 90 degrees.
    assert shown["Mean"][0] == "0.0000" and shown["Greatest"][0] == "+0.0040"
    assert shown["Std. dev."][0] == f"{0.004 / np.sqrt(2) * np.sqrt(90 / 89):.4f}"
    assert shown["Height"][0] == f"{0.004 + 0.004 * np.cos(2 * np.pi / 90):.4f}"
    # All of it is determined and taken back.
    assert [shown[name][1] for name in ("Mean", "Least", "Greatest")] == ["0.0000"] * 3
    assert shown["Largest correction"] == ("0.0040",)
    assert shown["Points used"] == ("90 / 90",) and shown["Points left out"] == ("0",)
    assert float(shown["Path error after"][0].split()[0]) <= 0.001


def test_figures_keep_their_places_when_there_are_none():
    empty = figures_of(None)
    full = figures_of(pipeline.correct(request(disc())).summary())
    assert [(f.label, len(f.shown)) for f in empty] == [(f.label, len(f.shown)) for f in full]
    assert {text for f in empty for text in f.shown} == {"\u2013"}
    widths = [len(f.shown) for f in full]
    assert widths == sorted(widths, reverse=True) and len({f.label for f in full}) == len(full)


@pytest.mark.parametrize(
    ("value", "signed", "text"),
    [(0.01234, True, "+0.0123"), (-0.00001, True, "0.0000"), (float("nan"), True, "\u2013"),
     (None, False, "\u2013"), (0.5, False, "0.5000")],
)  # fmt: skip
def test_lengths(value, signed, text):
    assert length(value, signed) == text


def finished(work):
    until = time.monotonic() + 20
    while not work.done and time.monotonic() < until:
        time.sleep(0.002)
    assert work.done
    return work


def test_work_gives_what_the_function_gives():
    assert finished(Work(lambda: 6 * 7).start()).value == 42


def test_work_raises_what_the_function_raises():
    work = finished(Work(lambda: pipeline.correct(request(disc(), gain=5.0))).start())
    with pytest.raises(MillcorrError, match="--gain"):
        _ = work.value


def test_cancelled_work_stops():
    begun = threading.Event()

    def for_ever():
        begun.set()
        while True:
            time.sleep(0.001)

    work = Work(for_ever).start()
    assert begun.wait(10) and not work.done
    work.cancel()
    assert finished(work).cancelled and work.error is None


def test_progress_is_what_the_core_is_at():
    """Stages come from the modules at work: every one named exists, and a real correction passes through them."""
    import importlib

    for modules, _, _ in STAGES:
        for module in modules:
            importlib.import_module(f"millcorr.{module}")
    assert stage_of(["threading", "millcorr.pipeline", "millcorr.distrust", "millcorr.separation"])[0] == (
        "Looking for doubts"
    )
    assert stage_of(["threading", "json"]) is None
    work, seen = Work(lambda: [pipeline.correct(request(disc(count=20000))) for _ in range(3)]).start(), []
    while not work.done:
        seen.append(work.progress())
        time.sleep(0.001)
    shares = [share for _, share in seen]
    assert shares == sorted(shares) and shares[-1] > 0.2
    assert {text for text, _ in seen} - {""} <= {text for _, text, _ in STAGES}


def test_nobody_catches_a_cancellation_by_mistake():
    assert not issubclass(Cancelled, Exception)


class Row:
    def __init__(self, name, default, kind="Float", group="Correction"):
        self.name, self.default, self.kind, self.group = name, default, kind, group


class Thing:
    TypeId = "App::FeaturePython"

    def __init__(self, name, **values):
        self.Name = name
        self.__dict__.update(values)


TABLE = (
    Row("Base", None, "Link", "Base"),
    Row("Measurement", None, "Link"),
    Row("Gain", 1.0),
    Row("Method", ("mirror", "transfer"), "Enumeration"),
    Row("Accept", [], "StringList"),
    Row("DeviationMean", 0.0, "Distance", "Result"),
)


def test_a_draft_becomes_lines_that_make_it():
    values = {"Base": Thing("Profile"), "Measurement": Thing("Measurement"), "Gain": 0.5, "Method": "mirror"}
    draft = Draft("Profile corrected", values | {"Accept": ["outliers"]})
    assert lines_to_create(draft, TABLE)[1] == (
        "dressup.create(App.ActiveDocument.getObject('Profile'), App.ActiveDocument.getObject('Measurement'), "
        "Gain=0.5, Accept=['outliers'])"
    )


def test_only_what_differs_is_changed():
    base = Thing("Profile")
    obj = Thing("Dressup", Base=base, Measurement=None, Gain=1.0, Method="mirror", Accept=(), DeviationMean=0.004)
    draft = Draft("x", {"Base": base, "Measurement": None, "Gain": 1.0, "Method": "mirror", "Accept": []})
    assert lines_to_change(draft, obj, TABLE) == []
    assert draft.change("Method", "transfer") and not draft.change("Gain", 1.0)
    assert lines_to_change(draft, obj, TABLE) == [
        "App.ActiveDocument.getObject('Dressup').Method = 'transfer'",
        "App.ActiveDocument.recompute()",
    ]
    assert in_python([base, 1.5]) == "[App.ActiveDocument.getObject('Profile'), 1.5]"
