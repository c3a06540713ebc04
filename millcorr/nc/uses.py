# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who uses the variables of a program: a number may take the place of one that nothing else uses."""

from __future__ import annotations

import re
from collections import Counter

from millcorr.messages import phrase

from .order import Run
from .statements import Piece

_NAME = re.compile(r"#\s*\d+|#\s*<[^>]*>|#\s*[\[#]|\$?[A-Z_][A-Z_0-9]*\s*(?![\[(\w])|(?:R|VC|V|Q)\s*[\[(]")


def names(expression: str) -> list[str]:
    """Variables of an expression; one with a computed index as its sign and a bracket."""
    return [re.sub(r"\s", "", found) for found in _NAME.findall(expression)]


class Uses:
    """Variables of a program and the lines that use them.

    Parameters
    ----------
    run : Run
        The program as it runs.
    """

    def __init__(self, run: Run) -> None:
        self.count: Counter[str] = Counter()
        self.where: dict[str, list[int]] = {}
        self.set: dict[str, int] = {}
        for line, statement in run.statements.items():
            texts = [p.expression for p in statement.pieces if p.expression]
            texts += [expression for _, expression in statement.assigned] + [statement.flow]
            for name in (n for text in texts for n in names(text)):
                self.count[name] += 1
                self.where.setdefault(name, []).append(line)
            for target, _ in statement.assigned:
                for name in names(target)[:1]:
                    self.set.setdefault(name, line)

    def shared(self, piece: Piece) -> str:
        """What else uses the variables of a word; "" where nothing does."""
        for name in names(piece.expression):
            if name[-1] in "[(#":
                return phrase("which variable it is, is computed; state the number here")
            if self.count[name] > 1:
                there = sorted({line + 1 for line in self.where[name]})
                came = phrase("{}, set in line {},", name, self.set[name] + 1) if name in self.set else name
                listed = ", ".join(map(str, there))
                return phrase(
                    "{} is used {} times (line {}); state the numbers in these lines", came, self.count[name], listed
                )
        return ""
