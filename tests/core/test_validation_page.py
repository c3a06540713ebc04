# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every row of docs/validation.md names tests that are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
PAGE = (HERE.parents[1] / "docs" / "validation.md").read_text(encoding="utf-8")
COMMANDS = sorted(set(re.findall(r"`T/(\w+/test_\w+\.py)(?: -k (\"[^\"]+\"|\w+))?`", PAGE)))
PAPERS = (
    "Werner 2018", "Petrakov and Shupletsov 2018", "Petrakov 2025", "Petrakov and Romanov 2023", "Dat and Phuc 2025",
)  # fmt: skip


@pytest.mark.parametrize("file, words", COMMANDS)
def test_a_command_selects_tests(file, words):
    names = re.findall(r"^def (test_\w+)", (HERE / file).read_text(encoding="utf-8"), re.MULTILINE)
    for word in words.strip('"').split(" or "):
        assert any(word in name for name in names), f"{file} has no test of {word}"


def test_every_paper_has_claims_and_says_where_it_differs():
    parts = re.split(r"^## ", PAGE, flags=re.MULTILINE)
    for paper in PAPERS:
        (part,) = (p for p in parts if p.startswith(paper))
        rows = [line for line in part.splitlines() if line.startswith("| ")]
        assert len(rows) >= 6 and "**Where we differ.**" in part
        for row in rows[1:]:
            # Claim, source, kind, ours, theirs, and a command.
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
            assert len(cells) == 6 and cells[0] and cells[3] and cells[5].startswith("`")
