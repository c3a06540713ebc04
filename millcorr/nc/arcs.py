# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs and splines of NC programs: from the words of a line to centre, sweep and control points."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.messages import phrase
from millcorr.nc.toolpath import Plane

RADIUS_TOLERANCE = 0.0127
"""Accepted difference in mm between the radii at start and end of an arc: half a thousandth of an inch, as
LinuxCNC does; programs in inches with three decimals come close to it."""
RADIUS_TOLERANCE_RELATIVE = 0.001
SAME_POINT = 1e-9
"""Two positions in mm closer than this are the same programmed point."""

Refuse = Callable[[Bools, str], None]
Word = tuple[Bools, Floats]


def centre_by_radius(start: Floats, end: Floats, radius: Floats, clockwise: Bools) -> Floats:
    """Centre of arcs stated by their radius.

    Parameters
    ----------
    start, end : (n, 2) float64
        Ends in the arc's plane, mm.
    radius : (n,) float64
        Radius in mm, negative for the arc of more than half a turn.
    clockwise : (n,) bool
        True for G2.

    Returns
    -------
    (n, 2) float64
        Centres in mm. Where the radius is shorter than half the chord, the middle of the chord.
    """
    chord = end - start
    half = 0.5 * np.hypot(chord[:, 0], chord[:, 1])
    height = np.sqrt(np.maximum(radius**2 - half**2, 0.0))
    side = np.where(clockwise, -1.0, 1.0) * np.where(radius < 0, -1.0, 1.0)
    left = np.column_stack([-chord[:, 1], chord[:, 0]])
    with np.errstate(invalid="ignore", divide="ignore"):
        left = np.where(half[:, None] > 0, left / (2 * half[:, None]), 0.0)
    centre: Floats = 0.5 * (start + end) + left * (side * height)[:, None]
    return centre


def sweep_of(start: Floats, end: Floats, centre: Floats, clockwise: Bools) -> Floats:
    """Signed angle of arcs in rad, in (0, 2 pi] or [-2 pi, 0); a closed arc is a full turn.

    Parameters
    ----------
    start, end, centre : (n, 2) float64
        Points in the arc's plane, mm.
    clockwise : (n,) bool
        True for G2.

    Returns
    -------
    (n,) float64
    """
    a, b = start - centre, end - centre
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    dot = (a * b).sum(axis=1)
    angle = np.mod(np.arctan2(cross, dot), 2 * np.pi)
    angle = np.where(clockwise, np.mod(2 * np.pi - angle, 2 * np.pi), angle)
    closed = np.hypot(*(end - start).T) <= SAME_POINT
    angle = np.where(closed | (angle == 0), 2 * np.pi, angle)
    return np.where(clockwise, -angle, angle)


def read_arcs(
    start: Floats,
    end: Floats,
    plane: Ints,
    clockwise: Bools,
    centre_words: tuple[Word, Word, Word],
    radius_word: Word,
    turns_word: Word,
    absolute: Bools,
    scale: Floats,
    refuse: Refuse,
) -> tuple[Floats, Floats, Bools]:
    """Centre and sweep of arcs.

    Parameters
    ----------
    start, end : (n, 3) float64
        Programmed ends in mm.
    plane : (n,) int64
        `Plane` of each arc.
    clockwise : (n,) bool
        True for G2.
    centre_words : three pairs of (n,) bool and (n,) float64
        Whether I, J, K are stated, and their numbers in the program's unit.
    radius_word, turns_word : pair of (n,) bool and (n,) float64
        The same of R and P.
    absolute : (n,) bool
        True where I, J, K are positions (G90.1).
    scale : (n,) float64
        mm per program unit.
    refuse : callable
        Called with a mask of arcs and a message for arcs that are impossible; raises where the mask holds.

    Returns
    -------
    centre : (n, 3) float64
        mm; the coordinate along the normal is the start's.
    sweep : (n,) float64
        rad.
    strange : (n,) bool
        Arcs with a pitch along the normal, which controls read differently.
    """
    n = len(start)
    centre = np.full((n, 3), np.nan)
    sweep = np.full(n, np.nan)
    strange = np.zeros(n, np.bool_)
    by_radius = radius_word[0]
    for p in Plane:
        a, b, c = p.axes
        here = plane == p
        rows = np.flatnonzero(here)
        if not len(rows):
            continue
        given = centre_words[a][0] | centre_words[b][0]
        refuse(here & given & by_radius, phrase("arc with a radius and a centre: keep one of them"))
        refuse(here & ~given & ~by_radius, phrase("arc without a centre: state I, J, K or R"))
        refuse(
            here & absolute & given & ~(centre_words[a][0] & centre_words[b][0]),
            phrase("arc with an absolute centre (G90.1) needs both of its coordinates"),
        )
        strange |= here & centre_words[c][0] & (centre_words[c][1] != 0)
        s, e = start[rows][:, [a, b]], end[rows][:, [a, b]]
        offset = np.column_stack([np.where(centre_words[k][0], centre_words[k][1], 0.0)[rows] for k in (a, b)])
        middle = offset * scale[rows, None] + np.where(absolute[rows, None], 0.0, s)
        r = by_radius[rows]
        if r.any():
            radius = radius_word[1][rows] * scale[rows]
            half = 0.5 * np.hypot(*(e - s).T)
            short = r & (half - abs(radius) > np.maximum(RADIUS_TOLERANCE, RADIUS_TOLERANCE_RELATIVE * half))
            _refuse_rows(refuse, n, rows, short, phrase("arc radius shorter than half the way to its end: correct R"))
            closed = r & (half <= SAME_POINT)
            _refuse_rows(refuse, n, rows, closed, phrase("arc with R ends where it starts: state I, J for a circle"))
            middle[r] = centre_by_radius(s[r], e[r], radius[r], clockwise[rows][r])
        first, last = np.hypot(*(s - middle).T), np.hypot(*(e - middle).T)
        allowed = np.maximum(RADIUS_TOLERANCE, RADIUS_TOLERANCE_RELATIVE * np.maximum(first, last))
        _refuse_rows(
            refuse,
            n,
            rows,
            ~r & (abs(first - last) > allowed),
            phrase("arc whose end is not on its circle: correct it"),
        )
        _refuse_rows(refuse, n, rows, np.maximum(first, last) == 0, phrase("arc of radius zero: state its centre"))
        centre[rows, a], centre[rows, b] = middle[:, 0], middle[:, 1]
        centre[rows, c] = start[rows, c]
        sweep[rows] = sweep_of(s, e, middle, clockwise[rows])
    turns = np.where(turns_word[0], turns_word[1], 1.0)
    refuse((turns < 1) | (turns != np.rint(turns)), phrase("the number of turns P of an arc is a whole number from 1"))
    return centre, sweep + np.sign(sweep) * 2 * np.pi * (turns - 1), strange


def _refuse_rows(refuse: Refuse, n: int, rows: Ints, bad: Bools, message: str) -> None:
    mask = np.zeros(n, np.bool_)
    mask[rows[bad]] = True
    refuse(mask, message)
