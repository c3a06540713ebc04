# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are written anew together, because the words of some take their meaning from others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Ints
from millcorr.nc.toolpath import Toolpath

from .codes import TANGENT_CIRCLE
from .words import Words


@dataclass(frozen=True, slots=True)
class Tie:
    """Blocks that follow others: where one of these is written anew, all of them are.

    Parameters
    ----------
    leading, following : tuple of int
    """

    leading: tuple[int, ...]
    following: tuple[int, ...]


def together(changed: Ints, ties: Sequence[Tie]) -> Ints:
    """Blocks that are written anew where some change.

    Parameters
    ----------
    changed : (k,) int64
        Blocks, sorted.
    ties : sequence of Tie

    Returns
    -------
    (m,) int64
        Sorted; the changed ones among them.

    Examples
    --------
    >>> together(np.array([3]), [Tie((5,), (7,)), Tie((3,), (5,)), Tie((8,), (9,))]).tolist()
    [3, 5, 7]
    """
    if not len(ties):
        return changed
    led_by: dict[int, list[int]] = {}
    for k, tie in enumerate(ties):
        for block in tie.leading:
            led_by.setdefault(block, []).append(k)
    out = set(changed.tolist())
    waiting, done = list(out), set[int]()
    while waiting:
        for k in led_by.get(waiting.pop(), ()):
            if k not in done:
                done.add(k)
                more = out.symmetric_difference(ties[k].following).difference(out)
                out |= more
                waiting += more
    return np.array(sorted(out), np.int64)


def beside(blocks: Ints, toolpath: Toolpath) -> list[tuple[int, int]]:
    """The blocks that move before and behind each of some; itself where there is none."""
    moving = np.unique(toolpath.source)
    if not len(moving):
        return [(block, block) for block in blocks.tolist()]
    before = np.searchsorted(moving, blocks) - 1
    behind = np.searchsorted(moving, blocks, side="right")
    first = np.where(before < 0, blocks, moving[np.maximum(before, 0)])
    last = np.where(behind < len(moving), moving[np.minimum(behind, len(moving) - 1)], blocks)
    return list(zip(first.tolist(), last.tolist(), strict=True))


def ties_of(words: Words, toolpath: Toolpath) -> tuple[Tie, ...]:
    """What corners, angles and tangent arcs tie together.

    Parameters
    ----------
    words : Words
        By block.
    toolpath : Toolpath
    """
    corner = np.isin(words.letter, [ord(c) for c in "rcdg"])
    tangent = (words.letter == ord("G")) & (words.value == TANGENT_CIRCLE)
    blocks = np.unique(words.line[corner | tangent]).astype(np.int64)
    places = zip(blocks.tolist(), beside(blocks, toolpath), strict=True)
    return tuple(Tie((before, block, behind), (block, behind)) for block, (before, behind) in places) + tuple(
        _rounded_alike(words, toolpath)
    )


def _rounded_alike(words: Words, toolpath: Toolpath) -> list[Tie]:
    """Contours whose corners are all rounded (RNDM): what one of their moves states holds only while all are."""
    modal = words.of("s")
    ends = np.append(modal.line, np.iinfo(modal.line.dtype).max)[1:]
    moving = np.unique(toolpath.source)
    out = []
    for begin, end, size in zip(modal.line.tolist(), ends.tolist(), modal.value.tolist(), strict=True):
        own = moving[(moving >= begin) & (moving < end)]
        if size == 0 or not len(own):
            continue
        contour = np.union1d(own, [begin])
        (before, _), (_, behind) = beside(contour[[0, -1]], toolpath)
        following = (*contour.tolist(), behind)
        out.append(Tie((before, *following), following))
    return out
