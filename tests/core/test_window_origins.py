# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the import window says of how a file's meaning is known: every reason of a reader is among its texts."""

from __future__ import annotations

import ast
from pathlib import Path

from millcorr.gui import origins
from millcorr.readers.measurement import BASES, Basis

READERS = Path(__file__).resolve().parents[2] / "millcorr" / "readers"


def reasons() -> set[str]:
    """Texts by which readers infer or assume: of Basis, of Source.unit's last argument, and of names for these."""
    out = set()
    for file in READERS.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                texts = [a.value for a in node.args if isinstance(a, ast.Constant) and isinstance(a.value, str)]
                if name == "Basis" and texts[:1] in (["inferred"], ["assumed"]):
                    out |= set(texts[1:])
                if name == "unit" and len(node.args) == 3:
                    out |= set(texts) - {"mm", "inch"}
            elif isinstance(node, ast.Assign):
                target = node.targets[0]
                if getattr(target, "attr", getattr(target, "id", "")) in ("inferred", "shows"):
                    out |= {
                        n.value
                        for n in ast.walk(node.value)
                        if isinstance(n, ast.Constant) and isinstance(n.value, str)
                    } - {""}
    return out


def test_every_reason_can_be_translated():
    assert set(origins.REASONS) == reasons() and len(origins.REASONS) >= 7


def test_a_line_says_what_how_and_why():
    assert origins.in_words("unit", Basis("assumed", "the file does not say")) == "unit: assumed: the file does not say"
    assert [origins.in_words("frame", Basis(how)) for how in BASES] == [f"frame: {how}" for how in BASES]
