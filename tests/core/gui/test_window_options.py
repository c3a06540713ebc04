# SPDX-License-Identifier: LGPL-2.1-or-later
"""From forms to calls and macros, batches in a process of their own, figures of the transfer function."""

from __future__ import annotations

import ast
import io
import re
import time
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from millcorr.app import programs
from millcorr.cli import jobs
from millcorr.correction.settings import METHODS, Settings
from millcorr.errors import FormatError, MillcorrError, UsageError
from millcorr.gui import batch_run, methods
from millcorr.gui.figures import NONE
from millcorr.gui.options import AS_FILE, Expression, call, reading_options, setting_options
from millcorr.gui.remedies import first_field
from millcorr.gui.transfer_figures import transfer_figures
from millcorr.messages import AS_DATA, message_of, mm, option, phrase
from millcorr.probing.controls import DIALECTS
from millcorr.readers import Reading

GUI = Path(batch_run.__file__).parent
DISC = "G21 G90 G17\nG0 X45 Y0 Z5\nG1 Z-8 F100\nG2 X-45 Y0 I-45 J0 F300\nG2 X45 Y0 I45\nG0 Z5\nM2\n"


def constant(module, name):
    """Value of a constant in a module that only FreeCAD can import."""
    for node in ast.parse((GUI.parent / module).read_text(encoding="utf-8")).body:
        target = node.targets[0] if isinstance(node, ast.Assign) else getattr(node, "target", None)
        if isinstance(target, ast.Name) and target.id == name:
            return node.value
    raise AssertionError(f"{module} has no {name}")


def test_what_is_left_to_the_file_is_left_out():
    values = {"Points": AS_FILE, "BallRadius": 0.0, "Unit": "inch", "Format": "", "Part": 0, "Filter": "auto"}
    assert reading_options(values) == {"units": "inch"}
    said = {"Points": "centre", "BallRadius": 2.5, "Part": 2, "WorkRotation": 30.0, "Probe": "probe.toml"}
    assert reading_options(said) == {
        "points": "centre", "probe_radius": 2.5, "part": 2, "work_rotation": 30.0, "probe": "probe.toml",
    }  # fmt: skip
    Reading.from_dict(reading_options(said))
    assert ast.literal_eval(constant("app/measurement_object.py", "AS_FILE")) == AS_FILE


def test_only_unusual_settings_are_said():
    assert setting_options({"Filter": "auto", "Gain": 1.0, "Limit": 0.5, "NextDepth": 0.0, "Depth": []}) == {}
    assert setting_options({"DeadBand": 0.002, "OutputMoves": "arcs"}) == {"dead_band": 0.002, "output_moves": "arcs"}
    transfer = {"Method": "transfer", "Depth": [0.4], "NextDepth": 0.2, "Allowance": [0.4]}
    chosen = setting_options(transfer)
    assert Settings(**chosen).depths == (0.4,) and Settings(**chosen).next_depth == 0.2
    # Depths of a method that is no longer chosen do not stop the other one.
    assert "depth" not in setting_options(transfer | {"Method": "mirror"})


UNUSUAL = {
    "Depth": 0.4, "NextDepth": 0.2, "DepthAlong": "x", "TransferFunction": "one", "Allowance": 0.1, "Iterate": 0.01,
}  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
def test_each_method_shows_the_fields_that_the_settings_allow_with_it(method):
    assert {*UNUSUAL, "Setup"} == set(methods.NAMES)
    depth = 0.4 if method == "transfer" else ()
    assert ("Setup" in methods.FIELDS[method]) == Settings(method=method, depth=depth).with_setup
    for name, value in UNUSUAL.items():
        said = {"method": method, "depth": depth} | {methods_option(name): value}
        try:
            Settings(**said)
            allowed = True
        except UsageError as error:
            assert name == first_field(error.message), "a refusal of another field"
            allowed = False
        assert allowed == (name in methods.FIELDS[method])
        values = {"Method": method, name: [value] if name in ("Depth", "Allowance") else value}
        assert (methods_option(name) in setting_options(values)) == allowed


def methods_option(name):
    """Setting of a field: ``NextDepth`` is ``next_depth``."""
    return re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower()


def test_what_a_method_lacks_is_told_beside_its_field(tmp_path):
    def told(function, method, setup=""):
        with pytest.raises(MillcorrError) as caught:
            function()
        return methods.at_fault(caught.value.message, method, setup)

    assert told(lambda: Settings(method="transfer"), "transfer") == "Depth"
    assert told(lambda: Settings(method="combined", iterate=-1.0), "combined") == "Iterate"
    assert told(lambda: Settings(gain=7.0), "mirror") == ""
    program = tmp_path / "disc.nc"
    program.write_text(DISC, encoding="utf-8")
    measured_disc(tmp_path / "cmm.csv", 40.01)
    check = partial(programs.check, program, tmp_path / "cmm.csv", tool_diameter=10.0, points="contact")
    assert told(lambda: check(method="combined"), "combined") == "Setup"
    missing = str(tmp_path / "setup.toml")
    assert told(lambda: check(method="combined", setup=missing), "combined", missing) == "Setup"
    Path(missing).write_text("[tool]\ndiameter_mm = -1\n", encoding="utf-8")
    assert told(lambda: check(method="combined", setup=missing), "combined", missing) == "Setup"
    assert told(lambda: check(method="transfer", depth=(0.1, 0.2)), "transfer") == "Depth"


def test_a_call_is_python_that_says_the_same():
    seen = {}
    text = call("f", "a'b.nc", ["x", "y"], depth=(0.1, 0.2), nothing=None, obj=Expression("thing"))
    eval(text, {"f": lambda *given, **options: seen.update(given=given, **options), "thing": 7})
    assert seen == {"given": ("a'b.nc", ["x", "y"]), "depth": (0.1, 0.2), "obj": 7}


def measured_disc(path, radius):
    """90 points of a disc of this radius in mm."""
    angle = np.linspace(0, 2 * np.pi, 90, endpoint=False)
    rows = [f"{radius * c:.6f},{radius * s:.6f}" for c, s in zip(np.cos(angle), np.sin(angle), strict=True)]
    path.write_text("\n".join(["x,y", *rows, ""]), encoding="utf-8")
    return path


def test_a_program_is_corrected_and_split_by_one_call(tmp_path):
    program, measured = tmp_path / "disc.nc", measured_disc(tmp_path / "disc.csv", 40.01)
    program.write_text(DISC, encoding="utf-8")
    options = {"tool_diameter": 10.0, "points": "contact", "side": "left"}
    checked = programs.check(program, measured, **options)
    # Radius 40 in the program, 10 um of material left all round: the correction takes them off.
    assert checked.correction.largest == pytest.approx(0.010, abs=1e-6)
    told = programs.correct(program, measured, output=tmp_path / "out.nc", report=tmp_path / "report", **options)
    assert (tmp_path / "out.nc").read_bytes() == checked.text and "report.html" in told
    told = programs.split(program, tool_diameter=10.0, depth=0.8, side="left", output=tmp_path / "first.nc")
    assert "leaves 0.4 mm" in told and (tmp_path / "first.nc").exists()
    with pytest.raises(UsageError, match="unknown setting colour"):
        programs.correct(program, measured, colour="red", **options)
    with pytest.raises(UsageError, match="before anything is measured"):
        programs.split(program, tool_diameter=10.0, depth=0.8, output=tmp_path / "x.nc", points="contact")


def test_a_series_is_controlled_by_the_same_call(tmp_path):
    """10 um are corrected; 3 um more are halved by ewma:2 and stay below the limit: the program stays as it is."""
    program, p1, p2 = tmp_path / "disc.nc", tmp_path / "P1.nc", tmp_path / "P2.nc"
    program.write_text(DISC, encoding="utf-8")
    options = {"tool_diameter": 10.0, "points": "contact", "side": "left", "nominal": str(program), "journal": ""}
    rules = {"control": "ewma:2", "control_limit": 0.002, "control_alarm": 0.1, "step_limit": 0.05}
    first, second = measured_disc(tmp_path / "1.csv", 40.01), measured_disc(tmp_path / "2.csv", 40.003)
    assert "part 1" in programs.correct(program, first, output=p1, **options, **rules)
    assert p1.read_bytes() != program.read_bytes()
    assert "NOT CORRECTED" in programs.correct(p1, second, output=p2, **options, **rules)
    assert p2.read_bytes() == p1.read_bytes()
    # Without the rules the same part is corrected.
    del options["journal"]
    programs.correct(p1, second, output=p2, **options)
    assert p2.read_bytes() != p1.read_bytes()
    for given, said in (
        ({"control_limit": 0.002}, "--control-limit belongs to --control"),
        ({"control": "ewma:2", "control_limit": 0.002}, "--control needs --journal"),
        ({"control_colour": 1}, "unknown setting control_colour"),
    ):
        with pytest.raises(UsageError, match=said):
            programs.correct(p1, second, **options, **given)


@pytest.mark.parametrize(
    "outcome",
    [
        jobs.Outcome("bracket", 0, "fine", 0.94),
        jobs.Outcome("cam disc", 0, "", 4.25, before=True),
        jobs.Outcome("bracket", 3, phrase("{} is too small: {}", mm(0.5), option("limit", 0.1)), 0.5),
        jobs.Outcome("bracket  with blanks", -9, "killed", 12345.6),
    ],
)
def test_lines_of_a_batch_are_understood(outcome, monkeypatch):
    monkeypatch.setenv(AS_DATA, "1")
    out = io.StringIO()
    jobs._Progress(3, out).line(outcome)
    seen = batch_run.ended(out.getvalue())
    assert seen == outcome
    # The window words what it names.
    assert seen.text.options == message_of(outcome.text).options


@pytest.mark.parametrize("line", ["2 of 3 jobs done", "[]", "3", '{"name": "a"}'])
def test_other_lines_of_a_batch_are_none_of_a_job(line):
    assert batch_run.ended(line) is None


def test_a_batch_runs_and_is_stopped_with_its_jobs(tmp_path):
    (tmp_path / "disc.nc").write_text(DISC, encoding="utf-8")
    (tmp_path / "first.toml").write_text(
        '[[job]]\nname = "a"\nverb = "split"\nprogram = "disc.nc"\ntool-diameter = 10\ndepth = 0.5\nside = "left"\n'
        'output = "first.nc"\n',
        encoding="utf-8",
    )
    run = batch_run.BatchRun(tmp_path / "first.toml")
    events, end = [], time.monotonic() + 60
    while run.running and time.monotonic() < end:
        events += run.news()
        time.sleep(0.02)
    assert [(e.name, e.status) for e in events] == [("a", 0)] and run.status == 0
    assert (tmp_path / "first.nc").exists() and run.said == "1 of 1 jobs done"
    run = batch_run.BatchRun(tmp_path / "first.toml", again=True)
    run.cancel()
    while run.running and time.monotonic() < end:
        run.news()
        time.sleep(0.02)
    assert run.cancelled and run.status != 0
    (tmp_path / "bad.toml").write_text("", encoding="utf-8")
    with pytest.raises(FormatError, match="at least one table"):
        batch_run.BatchRun(tmp_path / "bad.toml")


def test_every_control_can_be_chosen_and_says_what_was_checked():
    checked = constant("gui/measuring_panel.py", "CHECKED")
    assert {ast.literal_eval(key) for key in checked.keys} == set(DIALECTS)
    choices = ast.literal_eval(constant("gui/preferences.py", "CHOICES"))
    assert set(choices["Dialect"]) == set(DIALECTS)
    defaults = ast.literal_eval(constant("gui/preferences.py", "DEFAULTS"))
    usual = Settings()
    for name, preference in (("filter", "Filter"), ("gain", "Gain"), ("limit", "Limit"), ("dead_band", "DeadBand")):
        assert getattr(usual, name) == defaults[preference]
    assert usual.tolerance == defaults["Tolerance"]


def test_figures_of_a_transfer_function():
    nothing = transfer_figures(None)
    assert len(nothing) == 7 and all(figure.shown == (NONE,) for figure in nothing)
    found = {
        "ms_mean": 0.05, "ms_min": 0.0412, "ms_max": 0.06, "ms_uncertainty": float("nan"), "next_depth": 0.4,
        "correction_uncertainty": None, "offset": None,
    }  # fmt: skip
    shown = [figure.shown[0] for figure in transfer_figures({"transfer": found})]
    assert shown[:4] == ["0.0500", "0.0412", "0.0600", NONE]
    assert shown[4].startswith("0.4000") and shown[5:] == [NONE] * 2
    assert transfer_figures({"transfer": None}) == nothing
