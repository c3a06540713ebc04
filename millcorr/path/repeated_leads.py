# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leads on lines that run several times: alike in all runs, as their one text must be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from millcorr.nc import Program
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.tolerances import ARITHMETIC

from .moves import Regeneration


def leads_alike(program: Program, toolpath: Toolpath, regeneration: Regeneration) -> Regeneration:
    """Where a lead stays in one run of its line and goes along with the contour in another, it stays in all.

    The way between two depths goes along with both contours; before the first and behind the last of them it ends at a
    rapid, which stays. Only straight moves are changed that make no surface; whether the leads cut into anything now is
    for the proof to say.

    Parameters
    ----------
    program : Program
    toolpath : Toolpath
        Its moves, divided where a contour begins on one of them.
    regeneration : Regeneration
        The moves as displaced.

    Returns
    -------
    Regeneration
    """
    if program.run.line is None:
        return regeneration
    new, origin = regeneration.toolpath, regeneration.origin
    end, start = new.end.copy(), new.start.copy()
    shift = np.hypot(*(new.end - toolpath.end[origin])[:, :2].T)
    single = np.bincount(origin, minlength=len(toolpath))[origin] == 1
    free = single & ~regeneration.following & (new.kind <= Kind.LINE)
    # What comes next starts there: it must be free to do so.
    free[:-1] &= ~regeneration.following[1:] & (new.kind[1:] <= Kind.LINE)
    rank = np.arange(len(new)) - np.searchsorted(new.source, new.source)
    line = program.lines_of(new.source)
    order = np.lexsort((rank, line))
    same = (np.diff(line[order]) == 0) & (np.diff(rank[order]) == 0)
    for runs in np.split(order, np.flatnonzero(~same) + 1):
        stays = shift[runs] <= ARITHMETIC
        if len(runs) > 1 and stays.any() and not stays.all() and free[runs[~stays]].all():
            moved = runs[~stays]
            end[moved, :2] = toolpath.end[origin[moved], :2]
            behind = moved[moved + 1 < len(new)] + 1
            start[behind, :2] = end[behind - 1, :2]
    return replace(regeneration, toolpath=new.with_moves(start=start, end=end))
