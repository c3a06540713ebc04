# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options are declared once: command line, README, FreeCAD's properties and panels say what the declaration says."""

from __future__ import annotations

import ast
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from millcorr.cli.arguments import EXAMPLES, verbs
from millcorr.correction.settings import METHODS, Settings
from millcorr.errors import UsageError
from millcorr.messages import flag
from millcorr.options import options_of
from millcorr.readers.reading import Reading

REPOSITORY = Path(__file__).resolve().parents[3]
DECLARED = options_of(Settings) | options_of(Reading)
ON_THE_LINE = [one for one in DECLARED.values() if one.key != "leave_stock"]
"""What a first cut leaves comes from `split --depth` and `--at`."""

PROPERTIES = {
    "Side": ("Enumeration", ("auto", "left", "right")),
    "Align": ("String", "none"),
    "Accept": ("StringList", []),
    "Filter": ("String", "auto"),
    "Method": ("Enumeration", ("mirror", "transfer", "combined", "predicted")),
    "Iterate": ("Length", 0.0),
    "Depth": ("FloatList", []),
    "NextDepth": ("Length", 0.0),
    "DepthAlong": ("Enumeration", ("normal", "x", "y")),
    "TransferFunction": ("Enumeration", ("smooth", "one", "points")),
    "Allowance": ("FloatList", []),
    "LeaveStock": ("Length", 0.0),
    "Gain": ("Float", 1.0),
    "Limit": ("Length", 0.5),
    "DeadBand": ("Length", 0.0),
    "UnmeasuredShare": ("Float", 0.6),
    "Tools": ("StringList", []),
    "KeepAllowance": ("Bool", False),
    "Tolerance": ("Length", 0.001),
    "OutputMoves": ("Enumeration", ("keep", "lines", "arcs")),
    "CutterCompensation": ("Enumeration", ("contour", "wear")),
}
"""Properties that documents store, as the first version wrote them: a file format."""


def rows():
    """Cells of the README's tables of options."""
    text = (REPOSITORY / "README.md").read_text(encoding="utf-8")
    text = text[text.index("## Options of `correct`") : text.index("| exit status")]
    return [
        [cell.replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        for line in text.splitlines()
        if line.startswith("| `")
    ]


def actions(verb):
    return {option: action for action in verbs()[verb]._actions for option in action.option_strings}


@pytest.mark.parametrize("one", ON_THE_LINE, ids=lambda one: one.key)
def test_the_readme_says_what_is_declared(one):
    names = [row for row in rows() if re.search(rf"{flag(one.key)}(?![\w-])", row[0])]
    assert len(names) == 1, f"{flag(one.key)} stands in {len(names)} rows"
    cell, text = names[0]
    said = re.search(rf"{flag(one.key)}(?: ([^`]*))?`", cell)
    if one.choices and len(one.choices) > 1 and "|" in (said[1] or ""):
        assert set(said[1].split("|")) == set(one.choices)
    if one.type is bool:
        assert said[1] is None
    alone = cell.count("--") == 1
    if alone and isinstance(one.default, float):
        assert re.search(rf"(?<![\d.]){one.default:g}(?![\d.]*\d)", text), f"default {one.default:g}"


def test_every_option_of_correct_is_in_the_readme():
    told = " ".join(row[0] for row in rows())
    missing = [
        option for option, action in actions("correct").items()
        if option.startswith("--") and option != "--help" and f"{option}" not in told
    ]  # fmt: skip
    # The rules of a series have a page of their own.
    page = (REPOSITORY / "docs" / "serial-production.md").read_text(encoding="utf-8")
    text = " ".join(" ".join(row) for row in rows())
    assert [option for option in missing if option not in page and option not in text] == []


@pytest.mark.parametrize("one", ON_THE_LINE, ids=lambda one: one.key)
def test_the_command_line_takes_what_is_declared(one):
    for verb in ("correct", "check"):
        action = actions(verb)[flag(one.key)]
        assert action.dest == one.key
        assert action.default == (list(one.default) if one.several else one.default)
        assert (action.choices or ()) == one.choices
        assert one.type is bool or action.type is one.type
        assert action.container.title == one.group


def test_help_shows_units_defaults_headings_and_an_example():
    for name, verb in verbs().items():
        text = " ".join(verb.format_help().split())
        assert f"example: python3 -m millcorr {name} {EXAMPLES[name]}" in text
        # What is shown is a line that it takes.
        verb.parse_args(EXAMPLES[name].split())
    text = verbs()["correct"].format_help()
    assert "--limit MM" in text and "(default 0.5)" in text and "\ntransfer function:\n" in text


def documented(module, table):
    """Calls in the tuple `table` of a module that only FreeCAD can import."""
    for node in ast.parse((REPOSITORY / "millcorr" / module).read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == table:
            return node.value.elts
    raise AssertionError(table)


def test_freecad_s_properties_stay_what_documents_hold():
    """Their names, kinds and defaults; the same function makes them in FreeCAD, where `Qt` is at hand."""
    sys.modules.setdefault("FreeCAD", type(sys)("FreeCAD")).Qt = type("Qt", (), {"QT_TRANSLATE_NOOP": None})
    try:
        from millcorr.app.properties import of_option
    finally:
        del sys.modules["FreeCAD"], sys.modules["millcorr.app.properties"]
    made = {}
    for call in documented("app/dressup.py", "PROPERTIES"):
        if call.func.id == "of_option":
            key, offered = call.args[0].slice.value, call.args[3] if len(call.args) > 3 else None
            choices = () if offered is None else ast.literal_eval(offered)
            row = of_option(options_of(Settings)[key], "", "", choices)
            made[row.name] = row.kind, row.default
    assert made == PROPERTIES


def test_the_properties_of_a_measurement_offer_what_is_declared():
    rows = {call.args[1].value: call for call in documented("app/measurement_object.py", "PROPERTIES")}
    for one in options_of(Reading).values():
        row = rows[one.field]
        if one.choices:
            assert [getattr(choice, "value", choice) for choice in row.args[4].elts[1:]] == list(one.choices)
        else:
            kinds = {"WorkOffset": "Vector", "WorkRotation": "Angle", "BallRadius": "Length"}
            usual = {int: "Integer", str: "String", Path: "FileIncluded"}
            assert row.args[0].value == kinds.get(one.field, usual.get(one.type))


@given(method=st.sampled_from(METHODS), data=st.data())
def test_bounds_hold_whatever_is_given(method, data):
    """A number within the declared bounds is taken, one outside is refused beside its option."""
    number = st.floats(allow_nan=True, allow_infinity=True)
    one = data.draw(st.sampled_from([o for o in DECLARED.values() if o.above is not None or o.least is not None]))
    value = data.draw(number)
    inside = math.isfinite(value) and (value > one.above if one.above is not None else value >= one.least)
    inside = inside and (one.most is None or value <= one.most)
    try:
        one.refuse((value,) if one.several else value)
        taken = True
    except UsageError as error:
        assert error.about == one.key and str(error).startswith(flag(one.key))
        taken = False
    assert taken == inside


@pytest.mark.parametrize(("line", "wanted"), [("correct --meth", "--method"), ("correct --method com", "combined")])
def test_the_shell_completes_verbs_options_and_choices(line, wanted):
    pytest.importorskip("argcomplete")
    typed = f"millcorr {line}"
    environment = os.environ | {
        "_ARGCOMPLETE": "1",
        "_ARGCOMPLETE_IFS": "\n",
        "_ARGCOMPLETE_STDOUT_FILENAME": "/dev/stdout",
        "COMP_LINE": typed,
        "COMP_POINT": str(len(typed)),
        "COMP_TYPE": "9",
    }
    done = subprocess.run(
        [sys.executable, "-m", "millcorr"], env=environment, capture_output=True, text=True, cwd=REPOSITORY, check=False
    )
    assert wanted in done.stdout
