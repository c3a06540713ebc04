# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' polar positions (AP=, RP=) and their poles (G110, G111, G112): where these lines end.

What the manuals leave open, or state differently from one edition to the next, has no value: a radius or an angle that
no line has stated for this pole, increments of a radius, a plain angle under G91, a pole relative to a place that is
not known, a pole behind a change of the frame.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import numpy as np

from millcorr.messages import phrase

from .angles import straightened
from .codes import FRAME_OFF, FRAME_ON, GROUPS, INCH, INITIAL, LOCAL_SHIFT, OFFSETS, PATHS, SHIFTS, TANGENT_CIRCLE
from .motion import follow
from .order import OddBlock, Run
from .ties import Tie

_NOWHERE = complex(math.nan, math.nan)
_POSITION = "hotq"
_FRAMES = (*FRAME_ON, *FRAME_OFF, *OFFSETS, *SHIFTS, LOCAL_SHIFT)


def placed(run: Run, name: str) -> tuple[Run, tuple[Tie, ...]]:
    """A run in which lines with polar positions state where they end, and arcs their centre.

    Parameters
    ----------
    run : Run
    name : str
        Name of the program, for messages.

    Returns
    -------
    Run
        The same where there are none. Words of positions (X=AC(), I=AC()) are added to those of the text.
    tuple of Tie
        Lines that rely on a radius, an angle or a place stated before.
    """
    letters = run.words.letter
    if not np.isin(letters, [ord(c) for c in _POSITION]).any():
        return run, ()
    return _Poles(run, name).result()


class _Poles:
    """One walk along the lines that state poles and polar positions."""

    def __init__(self, run: Run, name: str) -> None:
        self.run, self.name = run, name
        g = run.words.of("G")
        known = np.isfinite(g.value)
        self.code, self.code_line = np.rint(g.value[known] * 10).astype(np.int64), g.line[known]
        self.more: list[tuple[int, str, float]] = []
        self.odd: list[OddBlock] = []
        self.ties: list[Tie] = []
        self.pole = 0j
        """mm, from the zero of the work frame."""
        self.radius = self.angle = math.nan
        self.leading: tuple[int, ...] = ()
        """Blocks on whose places the pole hangs."""
        self.last = -1
        """Block of the last polar position about this pole."""

    def result(self) -> tuple[Run, tuple[Tie, ...]]:
        words = self.run.words
        polar = np.unique(words.line[np.isin(words.letter, [ord(c) for c in "b" + _POSITION])]).tolist()
        frames = np.unique(self.code_line[np.isin(self.code, _FRAMES)])
        done = -1
        for block in polar:
            if self._defined() and np.searchsorted(frames, done, "right") < np.searchsorted(frames, block, "right"):
                self._move_pole(_NOWHERE, ())
            done = block
            numbers = words.numbers(block)
            if "b" in numbers:
                self._define(block, numbers)
            else:
                self._place(block, numbers)
        run = replace(self.run, words=words.and_also(self.more), odd=(*self.run.odd, *self.odd))
        return run, tuple(self.ties)

    def _defined(self) -> bool:
        return self.pole != 0 or bool(self.leading)

    def _in_force(self, group: str, block: int) -> int:
        """Code of a modal group that holds in a block."""
        members = GROUPS[group]
        before = self.code[: int(np.searchsorted(self.code_line, block, side="right"))]
        stated = before[np.isin(before, list(members))]
        return int(members[int(stated[-1])]) if len(stated) else INITIAL[group]

    def _scale(self, block: int) -> float:
        return INCH if self._in_force("unit", block) == 20 else 1.0

    def _move_pole(self, pole: complex, leading: tuple[int, ...]) -> None:
        self.pole, self.leading = pole, leading
        self.radius = self.angle = math.nan
        self.last = -1

    def _define(self, block: int, numbers: dict[str, float]) -> None:
        """Take over a pole."""
        scale = self._scale(block)
        angle = numbers.get("t", numbers.get("h"))
        if numbers.keys() & set("uvxyo") or self._in_force("plane", block) != 17:
            self._move_pole(_NOWHERE, ())
            return
        if angle is not None and "q" in numbers and not numbers.keys() & {"e", "f"} and numbers["b"] != 110:
            way = cmath.rect(numbers["q"], math.radians(angle))
        elif numbers.keys() & set("htq") or (numbers["b"] == 111 and not {"e", "f"} <= numbers.keys()):
            way = _NOWHERE
        else:
            way = complex(numbers.get("e", 0.0), numbers.get("f", 0.0))
        if numbers["b"] == 111:
            self._move_pole(way * scale, ())
        elif numbers["b"] == 112:
            self._move_pole(self.pole + way * scale, self.leading)
        else:
            place, before = self._position(block)
            self._move_pole(place + way * scale, (before,))

    def _position(self, block: int) -> tuple[complex, int]:
        """Where the lines before a block end in the work frame, mm, and the last of them that moves."""
        earlier = self.run.until(block)
        earlier = replace(earlier, words=earlier.words.and_also(self.more), odd=(*earlier.odd, *self.odd))
        path, modal, _ = follow(straightened(earlier, self.name), self.name)
        if not len(path):
            return _NOWHERE, block
        return complex(*(path.end[-1, :2] - modal.shift[-1, :2])), int(path.source[-1])

    def _place(self, block: int, numbers: dict[str, float]) -> None:
        """State where a line ends, and about which centre."""
        incremental = self._in_force("distance", block) == 91
        scale = self._scale(block)
        if "o" in numbers:
            self.angle += numbers["o"]
        elif "t" in numbers or "h" in numbers:
            self.angle = numbers["t"] if "t" in numbers else math.nan if incremental else numbers["h"]
        if "q" in numbers:
            self.radius = numbers["q"] * scale
        flat = self._in_force("plane", block) == 17
        known = flat and self.radius > 0 and math.isfinite(self.angle)
        end = self.pole + cmath.rect(self.radius, math.radians(self.angle)) if known else _NOWHERE
        motion = self._in_force("motion", block)
        twice = bool(numbers.keys() & set("XYxyuv"))
        if not cmath.isfinite(end):
            effect = "call" if twice else ""
            self.odd.append(OddBlock(block, phrase("where this polar position is, is not known"), effect))
        if not twice:
            self.more += [(block, "u", end.real / scale), (block, "v", end.imag / scale)]
        if motion in (20, 30) and not numbers.keys() & set("IJRijka"):
            self.more += [(block, "i", self.pole.real / scale), (block, "j", self.pole.imag / scale)]
        elif motion not in (*PATHS, round(10 * TANGENT_CIRCLE)):
            self.odd.append(OddBlock(block, phrase("a polar position of this motion code is not followed"), ""))
        relies = self.last >= 0 and not ("q" in numbers and numbers.keys() & {"h", "t"})
        if leading := ((self.last,) if relies else ()) + self.leading:
            self.ties += [Tie((source,), (block,)) for source in leading]
        self.last = block
