# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the import window says of how a file's meaning is known: every reason of a reader is among its texts."""

from __future__ import annotations

import ast
from pathlib import Path

from millcorr.gui import origins
from millcorr.readers.measurement import BASES, Basis

READERS = Path(__file__).resolve().parents[3] / "millcorr" / "readers"


def reasons() -> list[ast.expr]:
    """What readers infer or assume by: arguments of Basis and of Source.unit, and what stands for these."""
    out = []
    for file in READERS.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                if name == "Basis":
                    out += [a for a in node.args[1:] if not isinstance(a, ast.Name)]
                if name == "unit" and len(node.args) == 3:
                    out.append(node.args[2])
            elif isinstance(node, ast.Assign):
                target = node.targets[0]
                if getattr(target, "attr", getattr(target, "id", "")) in ("inferred", "shows"):
                    out.append(node.value)
    return out


def test_every_reason_is_a_phrase():
    plain = [
        part.value
        for reason in reasons()
        for part in ((reason.body, reason.orelse) if isinstance(reason, ast.IfExp) else (reason,))
        if isinstance(part, ast.Constant) and part.value
    ]  # fmt: skip
    assert len(reasons()) >= 7 and plain == []


def test_a_line_says_what_how_and_why():
    assert origins.in_words("unit", Basis("assumed", "the file does not say")) == "unit: assumed: the file does not say"
    assert [origins.in_words("frame", Basis(how)) for how in BASES] == [f"frame: {how}" for how in BASES]
