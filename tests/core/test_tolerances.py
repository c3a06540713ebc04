# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers by which the core decides: each has its reason, and the documentation has all of them."""

from __future__ import annotations

import ast
import importlib.util
from importlib.machinery import SourceFileLoader
from pathlib import Path

import pytest

from millcorr import tolerances

REPOSITORY = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def tool():
    loader = SourceFileLoader("tolerances_tool", str(REPOSITORY / "tools" / "tolerances"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def test_every_number_has_its_reason(tool):
    rows = [(module, *row) for module, found in tool.modules().items() for row in found]
    assert len(rows) > 150
    assert [f"{module}.{name}" for module, name, _, reason in rows if not reason] == []


def test_the_page_is_what_the_code_has(tool):
    # Where this fails: tools/tolerances writes the page anew.
    assert tool.PAGE.read_text(encoding="utf-8") == tool.page()


def test_what_the_page_is_made_of(tool):
    text = 'A = 1.5\n"""Why."""\nB = 2\nC = (1, -3.0)\n"""Both."""\nD = 7\nE = "word"\nF = A * 2\n_G = 1\n'
    assert tool.constants(ast.parse(text)) == [
        ("A", "1.5", "Why."), ("B", "2", "Both."), ("C", "(1, -3.0)", "Both."), ("D", "7", ""),
    ]  # fmt: skip


def test_lengths_that_are_the_same_are_far_below_what_a_text_states():
    """0.01 um is the finest digit that programs have; a double of 10 m is exact to 2e-12 mm."""
    assert 100 * 2e-12 <= tolerances.ARITHMETIC < tolerances.ALIKE < tolerances.EXACT <= 1e-5 / 10
