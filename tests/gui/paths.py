# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far apart two paths run that were computed with two numpys."""

import math
import re

WORD = re.compile(r"([A-Z])(-?[0-9.]+)")


def difference(one, other):
    """Largest distance in mm between the same moves of two paths in FreeCAD's words; infinite where they differ else.

    The centre of a flat arc is far away and says little: two arcs are compared at their ends and in their middle.
    """
    if WORD.sub(r"\1", one) != WORD.sub(r"\1", other):
        return math.inf
    return max(
        (
            math.dist(a, b)
            for places in zip(_places(one), _places(other), strict=True)
            for a, b in zip(*places, strict=True)
        ),
        default=0.0,
    )


def _places(text):
    """For every line the numbers of its words but I and J, and the middle of an arc."""
    x, y = 0.0, 0.0
    for line in text.splitlines():
        code, *words = WORD.findall(line) or [("", "0")]
        word = {letter: float(number) for letter, number in words}
        end = word.get("X", x), word.get("Y", y)
        places = [(value,) for letter, value in word.items() if letter not in "IJ"]
        if code in (("G", "2"), ("G", "3")):
            i, j = word.get("I", 0.0), word.get("J", 0.0)
            begin, finish = math.atan2(-j, -i), math.atan2(end[1] - y - j, end[0] - x - i)
            turn = (finish - begin) % math.tau if code[1] == "3" else -((begin - finish) % math.tau)
            middle = begin + (turn or math.tau) / 2
            places.append((x + i + math.hypot(i, j) * math.cos(middle), y + j + math.hypot(i, j) * math.sin(middle)))
        yield [*places, (float(code[1]),)]
        x, y = end
