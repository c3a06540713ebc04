# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an NC program writes its words, so that new words look like its own."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Ints

from .words import COMMENT, Words

_SAMPLE = 5000
_AXES = np.frombuffer(b"XYZIJKR", np.uint8)


@dataclass(frozen=True, slots=True)
class Style:
    """Habits of a program.

    Parameters
    ----------
    decimals : int
        Most digits behind the decimal point of an axis word; -1 where no axis word has a point.
    blanks : bool
        Words are set apart by blanks.
    lower : bool
        Letters are lower case.
    leading_zero : bool
        G01 in place of G1.
    trailing_zeros : bool
        Numbers keep their zeros at the end: X5.000 in place of X5.
    leading_digit : bool
        X0.5 in place of X.5.
    point : bool
        Whole numbers keep a point: X5. in place of X5.
    number_step : int
        Step of the N words; 0 where lines are not numbered.
    parentheses : bool
        Comments stand in parentheses, else behind a semicolon.
    modal : bool
        G1 is left out while it is in force.
    plus : bool
        Positive numbers carry a sign.
    ending : bytes
        Line ending.
    """

    decimals: int
    blanks: bool
    lower: bool
    leading_zero: bool
    trailing_zeros: bool
    leading_digit: bool
    point: bool
    number_step: int
    parentheses: bool
    modal: bool
    plus: bool
    ending: bytes


def style_of(data: bytes, starts: Ints, words: Words, motion: Ints, moving: Ints, line: Ints | None = None) -> Style:
    """Find the habits of a program.

    Parameters
    ----------
    data : bytes
        The program.
    starts : (lines + 1,) int64
        Offsets of its lines.
    words : Words
        Its words.
    motion : (lines,) int64
        Motion code in force behind each block, times ten.
    moving : (n,) int64
        Blocks that move.
    line : (blocks,) int64, optional
        Line of every block; by default its own index.

    Returns
    -------
    Style
        Number formats from all words, the rest from its first lines.
    """
    axis = np.isin(words.letter, _AXES)
    decimals = int(words.decimals[axis].max(initial=-1))
    sample = data[: int(starts[min(_SAMPLE, len(starts) - 1)])]
    text = COMMENT.sub(b"", sample).decode("latin-1")

    def count(pattern: str) -> int:
        return len(re.findall(pattern, text))

    numbers = [int(n) for n in re.findall(r"(?m)^[ \t]*[Nn][ \t]*(\d{1,9})", text)]
    steps = np.diff(numbers)
    step = int(np.median(steps)) if len(steps) and 2 * len(numbers) > text.count("\n") else 0
    fixed = decimals > 0 and _share(words, axis, decimals) > 0.9
    codes = words.of("G")
    stated = np.isin(moving if line is None else line[moving], codes.line[np.isin(codes.value, (0, 1, 2, 3))])
    repeated = stated & (moving > 0) & (motion[np.maximum(moving - 1, 0)] == motion[moving])
    return Style(
        decimals=decimals,
        blanks=count(r"[0-9.][ \t]+[A-Za-z]") >= count(r"[0-9.][A-Za-z]"),
        lower=count(r"[a-z][ \t]*[-+.0-9]") > count(r"[A-Z][ \t]*[-+.0-9]"),
        leading_zero=count(r"[Gg]0[0-9]") > count(r"[Gg][0-3](?![0-9.])"),
        trailing_zeros=fixed,
        leading_digit=count(r"[XYZIJKRxyzijkr][-+]?\.[0-9]") <= count(r"[XYZIJKRxyzijkr][-+]?0\.[0-9]"),
        point=count(r"[XYZIJKRxyzijkr][-+]?[0-9]+\.(?![0-9])") > count(r"[XYZIJKRxyzijkr][-+]?[0-9]+(?![0-9.])"),
        number_step=step,
        parentheses=not (b";" in sample and sample.count(b";") > sample.count(b"(")),
        modal=bool((~stated).sum() > repeated.sum()),
        plus=count(r"[XYZxyz][ \t]*\+") > count(r"[XYZxyz][ \t]*[0-9.]"),
        ending=b"\r\n" if b"\r\n" in sample else (b"\n" if b"\n" in data or b"\r" not in data else b"\r"),
    )


def _share(words: Words, axis: Bools, decimals: int) -> float:
    """Share of the axis words that carry the full number of decimals."""
    own = words.decimals[axis]
    return float((own == decimals).mean())
