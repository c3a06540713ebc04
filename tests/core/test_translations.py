# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the window is there in German and Ukrainian, with what is put into it, and compiled."""

from __future__ import annotations

import ast
import importlib.util
import re
from importlib.machinery import SourceFileLoader
from pathlib import Path

import pytest

TOOL = Path(__file__).resolve().parents[2] / "tools" / "translations"


@pytest.fixture(scope="module")
def tool():
    loader = SourceFileLoader("translations_tool", str(TOOL))
    spec = importlib.util.spec_from_loader(loader.name, loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def test_the_tool_finds_texts_of_every_kind(tool):
    wanted = tool.texts()
    for text in (
        ("Millcorr_Probe", "Measuring program\u2026"),
        ("App::Property", "Dead band"),
        ("App::Property", "Share of the deviation taken back"),
        ("Millcorr", "mirror"),
        ("Millcorr", "New corrections"),
        ("Workbench", "Correct milling toolpaths from measured parts"),
        ("Millcorr_Macro", "Correct document"),
    ):
        assert text in wanted


def test_labels_are_those_of_the_forms(tool):
    from millcorr.app.text import label_of

    assert all(tool.label_of(name) == label_of(name) for name in ("DeadBand", "X", "NextDepth", "Setup"))


@pytest.mark.parametrize("language", ["de", "uk"])
def test_every_text_is_translated(tool, language):
    # Where this fails: tools/translations brings the files up to date, a person fills in what is new.
    assert [line for line in tool.missing(tool.texts()) if line.startswith(f"{language}:")] == []


@pytest.mark.parametrize("language", ["de", "uk"])
def test_what_is_put_into_a_text_is_kept(tool, language):
    kept = re.compile(r"\{[^}]*\}|<[^>]*>|\*\.\w+|;;")
    for (_, text), translated in tool.read(language).items():
        assert sorted(kept.findall(text)) == sorted(kept.findall(translated)), text
        assert text[-1:] not in "\u2026: " or text[-1:] == translated[-1:], text


@pytest.mark.parametrize("language", ["de", "uk"])
def test_the_compiled_file_has_what_the_text_file_has(tool, language):
    # Qt's .qm holds translations as UTF-16, big endian.
    compiled = (tool.DIRECTORY / f"millcorr_{language}.qm").read_bytes()
    for translated in tool.read(language).values():
        assert translated.encode("utf-16-be") in compiled, translated


def test_what_a_user_meets_is_phrases(tool):
    """Errors of these rooms are built of phrases: a plain sentence would show in English in any language."""
    plain = []
    for room in ("readers", "nc", "probing", "production", "comparison", "correction", "plausibility", "stages"):
        for file in sorted((tool.REPOSITORY / "millcorr" / room).rglob("*.py")):
            if "heidenhain" not in file.parts:
                plain += [f"{room}/{file.name}:{line}: {text!r}" for line, text in _plain_errors(file)]
    # What only a caller of the code can do wrong: arrays whose shapes do not belong together.
    assert [one for one in plain if "shape" not in one and ", not " not in one and "toolpath.py" not in one] == []


ERRORS = {
    "FormatError",
    "InputError",
    "UsageError",
    "RefusedError",
    "LimitError",
    "FitError",
    "unsaid",
    "error",
    "_error",
}


def _plain_errors(file):
    """Line and text of words in an error's message that stand in no phrase."""
    for call in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(call, ast.Call) and getattr(call.func, "attr", getattr(call.func, "id", "")) in ERRORS:
            for argument in call.args:
                yield from (
                    (call.lineno, text) for text in _outside_phrases(argument) if re.search("[a-z]{2}.* ", text)
                )


def _outside_phrases(node):
    if isinstance(node, ast.Call):
        return
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    for child in ast.iter_child_nodes(node):
        yield from _outside_phrases(child)
