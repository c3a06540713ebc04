# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says and does without a window: figures, remedies, work in the background, drafts."""

from __future__ import annotations

import pickle
import re
import threading
import time
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from millcorr import nc, pipeline, plausibility, progress
from millcorr.app import wording
from millcorr.app.draft import Draft, in_python, lines_to_change, lines_to_create, values_of
from millcorr.app.wording import worded
from millcorr.cli.verbs.words import in_words
from millcorr.correction.settings import Settings
from millcorr.errors import DistrustError, FormatError, LimitError, MillcorrError, UsageError, unsaid
from millcorr.gui.background import STAGES, Work
from millcorr.gui.figures import figures_of, length
from millcorr.gui.remedies import Remedy, accepted_by, first_field, remedies_in
from millcorr.messages import message, message_of, option, phrase, remedy, um, xy
from millcorr.readers.measurement import Measurement
from millcorr.report.length_unit import INCH
from millcorr.report.page import page
from millcorr.report.picture import correction as overlay
from millcorr.report.verdict import what_to_do
from millcorr.whole_file import write_whole


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
    program, chosen = nc.parse(text, "disc.nc"), Settings(side="left", **settings)
    given = pipeline.nominal_from_program(program, 5.0, chosen, None) if nominal else None
    return pipeline.Request(program, 5.0, measurement, given, chosen)


def refusal(measurement, **settings):
    with pytest.raises(MillcorrError) as raised:
        pipeline.correct(request(measurement, nominal=True, **settings))
    return raised.value.message


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
    assert accepted_by(message) == name and name in plausibility.NAMES
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
    assert first_field(raised.value.message) == field


def refusals():
    """What a window may have to say: of settings, of files, of measurements, of a whole correction."""
    wrong = (
        {"gain": 5.0}, {"limit": -1.0}, {"dead_band": -0.1}, {"tolerance": 1.0}, {"align": "sideways"},
        {"tools": ("x",)}, {"unmeasured_share": 2.0}, {"method": "transfer"}, {"filter": "mean:4"},
        {"iterate": 0.01, "gain": 0.5, "method": "combined"}, {"depth": (1.0,)}, {"side": "up"}, {"next_depth": 0.5},
    )  # fmt: skip
    for settings in wrong:
        with pytest.raises(MillcorrError) as raised:
            Settings(**settings)
        yield raised.value.message
    measured = disc()
    gap = replace(measured, points=measured.points[:30], lines=measured.lines[:30])
    cases = (
        (disc(1 / 25.4), {}), (disc(ball=3.0), {}), (disc(offset=1.5, ball=3.0), {}), (disc(offset=2.0, ball=1.0), {}),
        (disc(offset=2.0), {}), (disc(offset=-0.5), {}), (disc(offset=0.6), {}), (disc(), {"limit": 0.002}),
        (disc(), {"method": "predicted"}), (disc(), {"leave_stock": 0.1}), (disc(), {"accept": ("no-such",)}),
        (disc(offset=30.0), {}), (disc(offset=-10.0), {}), (gap, {}),
        (disc(), {"method": "transfer", "depth": (30.0,)}),
        (disc(), {"method": "transfer", "depth": (0.5,), "allowance": (0.3,)}),
    )  # fmt: skip
    for measurement, settings in cases:
        try:
            yield from pipeline.correct(request(measurement, nominal=True, **settings)).warnings
        except MillcorrError as error:
            yield error.message
    yield unsaid("the file does not say", option("units", of="mm|inch"), option("points", "contact")).message
    turned = replace(measured, nominal=1.01 * measured.points, ball_radius=80.0)
    for finding in (*plausibility.examine_file(turned), *plausibility.examine_points(turned, nominal(), 5.0)):
        yield finding.text
    for accepted in ({"accept": ("unmeasured",)}, {"align": "rigid"}, {"filter": "gauss:0.5"}, {"gain": 0.5}):
        result = pipeline.correct(request(gap, nominal=True, **({"unmeasured_share": 0.9} | accepted)))
        yield from (*result.warnings, *result.advice, *what_to_do(result.summary()))


def nominal():
    return request(None, nominal=True).nominal


def test_no_words_of_the_command_line_in_the_window():
    said = [message_of(text) for text in refusals()]
    assert len(said) > 40 and sum("--" in text for text in said) > 20
    for text in said:
        assert re.search(r"--\w|\bLOG\b|`|\baccept ", worded(text)) is None, worded(text)


def test_lengths_are_said_in_the_unit_of_the_window(monkeypatch):
    monkeypatch.setattr(wording, "unit", lambda: INCH)
    said = refusal(disc(), limit=0.002)
    assert "0.0040 mm is needed at X" in said and "--limit 0.002;" in said
    assert "0.000157 in is needed at X" in worded(said) and "\u201cLimit\u201d 7.874e-05 in;" in worded(said)
    said = worded(refusal(disc(offset=1.5, ball=3.0)))
    assert " in off the profile" in said and re.search(r"\d mm", said) is None
    assert worded(phrase("{} and {}", um(0.0254), xy(25.4, -50.8))) == "1.000 thou and X1.00000 Y-2.00000"


def test_what_is_said_is_said_in_german(monkeypatch):
    known = {text: said for context, text, said in _translations("de") if context == "Millcorr_Said"}
    monkeypatch.setattr(wording, "translate", lambda context, text: known[text])
    assert worded(refusal(disc(1 / 25.4))).startswith("disc.csv: ") and "liegen am Profil" in worded(
        refusal(disc(1 / 25.4))
    )
    for text in refusals():
        # Whatever is a phrase has a translation that takes its values.
        worded(text)


def _translations(language):
    file = Path(__file__).resolve().parents[3] / "resources" / "translations" / f"millcorr_{language}.ts"
    for context in ElementTree.parse(file).getroot().iter("context"):
        for one in context.iter("message"):
            yield context.findtext("name"), one.findtext("source"), one.findtext("translation")


def test_a_point_that_is_left_out_is_counted_once():
    """Far off the profile, and an outlier: used and left out are all that were read, on every front."""
    measured = disc(count=180)
    points = measured.points.copy()
    points[7] *= 1.2
    points[60] *= 1.0 + 0.3 / 40.0
    result = pipeline.correct(request(replace(measured, points=points), nominal=True))
    counts = result.summary()["points"]
    assert len(result.deviation.rejected) == 1 and result.outlier.sum() == 1
    assert (counts["read"], counts["used"], counts["left_out"]) == (180, 178, 2)
    shown = {figure.label: figure.shown for figure in figures_of(result.summary())}
    assert shown["Points used"] == ("178 / 180",) and shown["Points left out"] == ("2",)
    assert "178 used of 180, 2 left out" in in_words(result.summary(), {}, checked_only=False)
    assert "178 used, 2 left out" in page(result)
    assert len(overlay.overlay_of(result).rejected) == 2 and "outlier" in overlay.rejected_text(result, 1)


def test_a_remedy_without_a_value_leads_to_its_field():
    said = message(
        "check ", option("tool_diameter"), ", ", option("points"), ", ", option("units"), ", and ",
        remedy("points", "contact"),
    )  # fmt: skip
    assert said == "check --tool-diameter, --points, --units, and --points contact"
    found = remedies_in(said)
    assert found == (Remedy("Points", "contact"), Remedy("ToolDiameter"), Remedy("Unit"))
    assert found[1].in_words() == "Go to Tool diameter"
    assert worded(message("check ", option("tool_diameter"), ".")) == "check \u201cTool diameter\u201d."
    asked = message("as ", option("tools", of="3=16"), ", or ", option("unmeasured_share", of="SHARE"))
    assert asked == "as --tool 3=16, or --unmeasured SHARE"
    assert worded(asked) == "as \u201cTools\u201d, or \u201cUnmeasured share\u201d"
    assert remedies_in(asked) == (Remedy("Tools"), Remedy("UnmeasuredShare"))
    moves = message("too little stock; ", remedy("keep_allowance"), " moves it")
    assert remedies_in(moves) == (Remedy("KeepAllowance", True),)
    assert remedies_in("nothing to do") == () and first_field("nothing") == "" and accepted_by("nothing") == ""


def test_the_value_that_something_has_is_no_remedy():
    """What names the limit as it is only leads to its field."""
    said = message("more than ", option("limit", 0.5))
    assert said == "more than --limit 0.5" and worded(said) == "more than \u201cLimit\u201d 0.5 mm"
    assert remedies_in(said) == (Remedy("Limit"),)


def test_a_message_keeps_its_pieces_wherever_it_goes():
    said = "part.csv: " + message("in inches: ", remedy("units", "inch"))
    error = UsageError(said, "; look")
    assert str(error) == "part.csv: in inches: --units inch; look" and remedies_in(error.message)[0].value == "inch"
    assert remedies_in(pickle.loads(pickle.dumps(error)).message) == remedies_in(said) == (Remedy("Unit", "inch"),)


def test_place_and_figure_are_what_the_text_says():
    with pytest.raises(LimitError) as raised:
        pipeline.correct(request(disc(), nominal=True, limit=0.002))
    error = raised.value
    x, y = error.place
    assert f"{error.figure:+.4f} mm is needed at X{x:.3f} Y{y:.3f}" in str(error)
    # The form is 0.004 cos 2a, material left and undercut alike: the largest is at one of four places on the axes.
    assert abs(error.figure) == pytest.approx(0.004, abs=1e-5) and min(abs(x), abs(y)) < 1e-6 + 40 * np.sin(np.pi / 45)
    with pytest.raises(DistrustError) as raised:
        pipeline.correct(request(disc(offset=1.5, ball=3.0), nominal=True))
    assert raised.value.finding == "diameter-for-radius" and raised.value.figure == pytest.approx(-1.5, abs=0.01)


@pytest.mark.parametrize("name", ["{}.csv", "--points.csv", "a --limit 3", "%s"])
def test_names_of_files_are_never_taken_for_options(name):
    error = FormatError("not a number", name, 3)
    assert error.message.options == () and worded(error.message) == f"{name}, line 3: not a number"
    assert error.message.file == name and error.said == "not a number"


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
        while True:
            progress.step()
            begun.set()
            time.sleep(0.001)

    work = Work(for_ever).start()
    assert begun.wait(10) and not work.done
    work.cancel()
    assert finished(work).cancelled and work.error is None


def test_what_is_being_put_in_its_place_is_written_and_said_to_be(tmp_path):
    begun, go_on = threading.Event(), threading.Event()

    def write():
        write_whole(tmp_path / "part.nc", "G0 X0")
        begun.set()
        assert go_on.wait(10)
        progress.step()
        return "written"

    work = Work(write).start()
    assert begun.wait(10)
    work.cancel()
    go_on.set()
    assert finished(work).value == "written" and not work.cancelled


def test_progress_is_what_the_core_is_at():
    assert set(STAGES) == set(progress.STAGES)
    work, seen = Work(lambda: [pipeline.correct(request(disc(count=20000))) for _ in range(3)]).start(), []
    while not work.done:
        seen.append(work.progress())
        time.sleep(0.001)
    shares = [share for _, share in seen]
    assert shares == sorted(shares) and shares[-1] > 0.2
    assert {text for text, _ in seen} - {""} <= set(STAGES.values())


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
    Row("SwitchedOff", [], "LinkList"),
    Row("DeviationMean", 0.0, "Distance", "Result"),
)


def test_a_draft_becomes_lines_that_make_it():
    values = {"Base": Thing("Profile"), "Measurement": Thing("Measurement"), "Gain": 0.5, "Method": "mirror"}
    draft = Draft("Profile corrected", values | {"Accept": ["outliers"], "SwitchedOff": []})
    assert lines_to_create(draft, TABLE)[1] == (
        "dressup.create(App.ActiveDocument.getObject('Profile'), App.ActiveDocument.getObject('Measurement'), "
        "Gain=0.5, Accept=['outliers'])"
    )


def test_only_what_differs_is_changed():
    base, part, new = Thing("Profile"), Thing("Measurement"), Thing("Measurement001")
    had = {"Base": base, "Measurement": part, "Gain": 1.0, "Method": "mirror", "Accept": [], "SwitchedOff": []}
    obj = Thing("Dressup", DeviationMean=0.004, **had)
    assert values_of(obj, TABLE) == had
    draft = Draft("x", had)
    assert lines_to_change(draft, obj, had) == []
    assert draft.change("Method", "transfer") and not draft.change("Gain", 1.0)
    own = "App.ActiveDocument.getObject('Dressup')"
    assert lines_to_change(draft, obj, had) == [f"{own}.Method = 'transfer'", "App.ActiveDocument.recompute()"]
    # A part that is added, and one that is switched off.
    draft = Draft("x", had | {"Measurement": new, "Gain": 0.5, "SwitchedOff": [part]})
    assert lines_to_change(draft, obj, had | {"Measurement": new}, new) == [
        "from millcorr.app import dressup",
        f"dressup.add({own}, App.ActiveDocument.getObject('Measurement001'), Gain=0.5)",
        f"dressup.switch({own}, App.ActiveDocument.getObject('Measurement'), False)",
        "App.ActiveDocument.recompute()",
    ]
    draft = Draft("x", had)
    assert lines_to_change(draft, obj, had | {"SwitchedOff": [part]})[1].endswith("getObject('Measurement'), True)")
    assert in_python([base, 1.5]) == "[App.ActiveDocument.getObject('Profile'), 1.5]"
