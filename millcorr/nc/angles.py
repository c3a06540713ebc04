# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight moves stated by their angle: Fanuc's ,A and Siemens' ANG=, with one axis, or two lines that meet."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from millcorr.arrays import Floats
from millcorr.messages import phrase

from .codes import INCH
from .motion import follow
from .order import OddBlock, Run

_PARALLEL = 1e-9
"""Sine between two directions below which they do not meet."""


def straightened(run: Run, name: str) -> Run:
    """A run in which lines with an angle state their ends.

    Parameters
    ----------
    run : Run
    name : str
        Name of the program, for messages.

    Returns
    -------
    Run
        The same where no line has an angle. The ends are added as words of positions (X=AC(), Y=AC()).
    """
    angled = np.unique(run.words.line[run.words.letter == ord("g")]).tolist()
    for k, block in enumerate(angled):
        end = _end(run, name, block, angled[k + 1] if k + 1 < len(angled) else -1)
        if end is None:
            odd = OddBlock(block, phrase("the angle does not give where this line ends"), "")
            run = replace(run, odd=(*run.odd, odd))
        else:
            run = replace(run, words=run.words.and_also([(block, letter, value) for letter, value in end.items()]))
    return run


def _end(run: Run, name: str, block: int, following: int) -> dict[str, float] | None:
    """Positions of X and Y to be stated in a block, in the program's unit; None where they do not follow."""
    path, modal, _ = follow(run.until(block), name)
    words = run.words.numbers(block)
    if not len(path) or not block or modal.distance[block - 1] == 91:
        return None
    scale = INCH if modal.unit[block - 1] == 20 else 1.0
    shift = modal.shift[block - 1, :2]
    start = (path.end[-1, :2] - shift) / scale
    way = _unit(words["g"])
    x, y = (words.get(axis, words.get(stated)) for axis, stated in (("X", "u"), ("Y", "v")))
    end: Floats | None = None
    if x is not None and y is not None:
        return {}
    if x is not None and abs(way[0]) > _PARALLEL:
        end = start + way * (x - start[0]) / way[0]
    elif y is not None and abs(way[1]) > _PARALLEL:
        end = start + way * (y - start[1]) / way[1]
    elif x is None and y is None and following > block:
        after = run.words.numbers(following)
        target = np.array([after.get("X", math.nan), after.get("Y", math.nan)])
        onward = _unit(after["g"])
        cross = way[0] * onward[1] - way[1] * onward[0]
        if abs(cross) > _PARALLEL:
            gap = target - start
            end = start + way * (gap[0] * onward[1] - gap[1] * onward[0]) / cross
    if end is None or not np.isfinite(end).all():
        return None
    return {
        letter: float(value) for letter, axis, value in (("u", "X", end[0]), ("v", "Y", end[1])) if axis not in words
    }


def _unit(degrees: float) -> Floats:
    return np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])

