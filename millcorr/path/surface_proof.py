# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a displaced path: the surface that all passes of the written program leave is where it was to be."""

from __future__ import annotations

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.commanded_surface import CommandedSurface
from millcorr.comparison.deviation import REACH
from millcorr.comparison.path_distance import PathDistance, SegmentTree
from millcorr.comparison.theoretical_contour import SAME_POINT
from millcorr.errors import LimitError
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.messages import phrase, remedy, um, xy
from millcorr.nc.toolpath import Toolpath
from millcorr.path.moves import BAND
from millcorr.path.path_following import length_in_plane
from millcorr.path.verification import Verification, sampled, too_far_off
from millcorr.tolerances import EXACT

from .wanted_surface import ROUNDS, WantedSurface

BELOW = 2 * EXACT
"""So far below a height, in mm, nothing that only cuts at it has come."""

Held = tuple[float, tuple[float, float], int]
"""Amount in mm, place, and line from 1 of a move that cuts into a wall."""

NOT_HELD: Held = (0.0, (0.0, 0.0), 0)

REACHED = 0.01
"""A place where the program left more than this over the nominal, in mm, was never reached by the cutter: an inner
corner. Facets of 0.01 mm chord error are the coarsest that finish a surface."""


def prove_surface(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    origin: Ints,
    before: WantedSurface,
    after: WantedSurface,
    radius: float,
    *,
    tolerance: float,
    exact: bool = False,
    beyond: Bools | None = None,
) -> tuple[Verification, tuple[float, tuple[float, float]], Held]:
    """Compare the surface of a written program with that of the original and with what was wanted.

    Parameters
    ----------
    original, written : CommandedSurface
        All passes of the program before, and of the text as it is read back.
    made_by : (n,) bool, (m,) bool
        Moves of either that make the surface and are corrected.
    origin : (m,) int64
        Move of the original that each written one comes from.
    before, after : WantedSurface
        What the original makes, and what the written one is to make.
    radius : float
        Distance in mm from contour to path.
    tolerance : float
        mm.
    exact : bool
        Whether the path was laid on the exact parallel of the wanted surface; else it keeps what the original is off.
    beyond : (k,) bool, optional
        Places of `after` beyond the ends of what was measured: leads look like the contour there. By default none.

    Returns
    -------
    Verification
    stays : (float, (float, float))
        The most that stays of what was wanted because the cutter cannot reach it, mm, and where.
    held : (float, (float, float), int)
        The most that a pass which stays cuts into the surface beyond what was measured.

    Raises
    ------
    LimitError
        If the surface is farther off than the tolerance: names place, amount and, where a pass that stays cuts into it,
        its line.
    """
    rest = _out_of_reach(after, radius) if radius > 0 else np.zeros(len(after.moved))
    if exact:
        error, places, reached, own = _off_the_parallel(original, written, made_by, before, after, radius)
        wanted = after.moved - own
    else:
        error, reached, own = _change_in_error(original, written, made_by, before, after, rest)
        wanted, places = after.moved - before.moved, after.place
    worst = int(np.argmax(np.abs(error)))
    x, y = places[worst]
    length = float(length_in_plane(written.toolpath.take(made_by[1])).sum())
    result = Verification(float(abs(error[worst])), (float(x), float(y)), float(max(0.0, -error.min())), length)
    if abs(error[worst]) > tolerance:
        raise too_far_off("surface", float(error[worst]), (float(x), float(y)), tolerance)
    held = NOT_HELD
    if radius > 0:
        none = np.zeros(len(own), dtype=bool)
        held = _refuse_gouging_others(
            original, written, made_by, origin, after, own, wanted, tolerance, none if beyond is None else beyond
        )
    # What was out of reach before, as the corners of facets are, is no matter of the correction.
    was = _out_of_reach(before, radius) if radius > 0 else np.zeros(len(rest))
    matters = reached & np.isfinite(was)
    more = np.zeros(len(rest))
    more[matters] = rest[matters] - was[matters]
    most = int(np.argmax(more))
    x, y = after.place[most]
    return result, (float(more[most]), (float(x), float(y))), held


def _change_in_error(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    before: WantedSurface,
    after: WantedSurface,
    rest: Floats,
) -> tuple[Floats, Bools, Floats]:
    """What the change of the surface is off the wanted one, mm; where it was made before; and what was left there."""
    wanted = after.moved - before.moved
    error = np.zeros(len(wanted))
    own = np.full(len(wanted), np.inf)
    reached = np.zeros(len(wanted), dtype=bool)
    # A first cut leaves more than a correction moves.
    reach = REACH + float(np.abs(after.moved).max())
    for z in _heights(written.toolpath, made_by[1], after):
        progress.step()
        was = original.only(made_by[0]).offset(before.nominal, before.normal, z)
        now = written.only(made_by[1]).offset(after.nominal, after.normal, z, reach=reach)
        made = np.isfinite(was) & ~after.at_corner & (was - before.moved < REACHED)
        made &= ~_rounded(written.toolpath, made_by[1], after, now)
        _refuse_lost(made, now, after)
        known = np.isfinite(was) & np.isfinite(now) & ~after.at_corner
        here = known & made
        reached |= here
        own = np.where(here, np.fmin(own, was), own)
        # What was off before stays: rounding and chords of the program itself. What it left, as beside an inside
        # corner, may go; into the wanted surface nothing may cut.
        change, over = now - was - wanted, now - after.moved
        off = np.where(change > 0, np.where(here, np.maximum(change - rest, 0.0), 0.0), np.maximum(change, over))
        off = np.where(known, np.where(change > 0, off, np.minimum(off, 0.0)), 0.0)
        error = np.where(np.abs(off) > np.abs(error), off, error)
    return error, reached, own


def _rounded(toolpath: Toolpath, made_by: Bools, after: WantedSurface, now: Floats) -> Bools:
    """Places that are only made by the round which a cutter leaves about a free end of its path; (n,)."""
    from scipy.spatial import cKDTree

    out = np.zeros(len(now), dtype=bool)
    rows = np.flatnonzero(made_by)
    if not len(rows):
        return out
    zero, one = np.zeros(len(rows)), np.ones(len(rows))
    end = np.concatenate([toolpath.start[rows, :2], toolpath.end[rows, :2]])
    ahead = np.concatenate([-toolpath.direction(rows, zero), toolpath.direction(rows, one)])
    meets = cKDTree(end).query_ball_point(end, SAME_POINT, return_length=True)
    end, ahead = end[meets == 1], ahead[meets == 1]
    known = np.flatnonzero(np.isfinite(now))
    if not len(end) or not len(known):
        return out
    place = after.nominal[known] + now[known, None] * after.normal[known]
    distance, which = cKDTree(end).query(place)
    beyond = ((place - end[which]) * ahead[which]).sum(axis=1) > SAME_POINT
    nearest = PathDistance(toolpath, rows)(place)
    out[known] = beyond & (distance < nearest + 1e-9)
    return out


def _off_the_parallel(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    before: WantedSurface,
    after: WantedSurface,
    radius: float,
) -> tuple[Floats, Floats, Bools, Floats]:
    """What a path is off the exact parallel, mm, and where; which places it made before, and what was left there."""
    places, _ = sampled(written.toolpath, np.flatnonzero(made_by[1]))
    feet = FootPointSearch(after.profile, margin=radius + 2.0).find(places)
    off = after.distance(places) - radius
    if radius == 0:
        # Past an open end the path runs straight on.
        across = ((places - feet.foot) * after.profile.normals(feet.span, feet.t)).sum(axis=1)
        off = np.where(feet.place == Place.END, np.fmin(np.abs(off), np.abs(across)), off)
    else:
        # Past a convex corner and an open end the cutter may be farther away.
        off = np.where((feet.place == Place.SMOOTH) & ~after.nearest_a_joint(places), off, np.minimum(off, 0.0))
    own = original.only(made_by[0]).offset(before.nominal, before.normal)
    made = np.isfinite(own) & (np.abs(own - before.moved) < BAND)
    return off, places, made, np.where(made, own, np.inf)


def _refuse_lost(made: Bools, now: Floats, after: WantedSurface) -> None:
    """LimitError where the written program does not cut what the original did, or nothing can be compared."""
    lost = np.flatnonzero(made & np.isnan(now))
    if len(lost) or not made.any():
        x, y = after.place[lost[0] if len(lost) else 0]
        raise LimitError(phrase("the written program leaves no surface near {} that could be proven", xy(x, y)))


def _heights(toolpath: Toolpath, made_by: Bools, surface: WantedSurface) -> list[Floats | None]:
    """Heights at which the surface is looked at: where only the deepest pass cuts, and where all that make it do.

    A step of a wall is looked at where it begins and right below the next one.
    """
    z = toolpath.end[made_by, 2]
    known = z[np.isfinite(z)]
    if not len(known):
        return [None]
    low, high = surface.bottom, surface.top - BELOW
    return [np.clip(height, low, high) for height in sorted({float(known.min()), float(known.max())})]


def _refuse_gouging_others(
    original: CommandedSurface,
    written: CommandedSurface,
    made_by: tuple[Bools, Bools],
    origin: Ints,
    after: WantedSurface,
    own: Floats,
    wanted: Floats,
    tolerance: float,
    beyond: Bools,
) -> Held:
    """LimitError where another move of the written program cuts deeper into the corrected surface than before.

    Beyond what was measured it only says so: what is wanted there is what the wall is expected to do.
    """
    places = np.flatnonzero(np.isfinite(own) & ~after.at_corner)
    through = np.zeros(len(made_by[0]), dtype=bool)
    # What cut deeper than the contour before, as a way over the part does, or a lead that is rounder than an inside
    # corner, makes no wall here: it is not for the contour to say where it may run. Each pass has such leads.
    deeper = places
    while len(deeper):
        progress.step()
        others = original.only(~made_by[0] & ~through)
        was = _left(others, after, deeper)
        rows = np.flatnonzero(was < own[deeper] - tolerance)
        deeper, was = deeper[rows], was[rows]
        through[others.made_by(after.nominal[deeper] + was[:, None] * after.normal[deeper])] = True
    others = written.only(~made_by[1] & ~through[origin])
    now = _left(others, after, places)
    # Where the original left something over what was wanted, there is room.
    over = np.fmax(now - own[places] - wanted[places], now - after.moved[places])
    low = np.flatnonzero(over < -tolerance)
    places, now, over = places[low], now[low], over[low]
    # What it cut into the contour before, within the tolerance, stays.
    was = np.fmin(own[places], _left(original.only(~made_by[0] & ~through), after, places))
    over = np.fmax(over, now - was - wanted[places])
    held = NOT_HELD
    for refused in (True, False):
        cut = np.where(beyond[places] != refused, over, 0.0)
        worst = int(np.argmin(cut)) if len(cut) else -1
        if worst < 0 or cut[worst] >= -tolerance:
            continue
        (x, y), at = after.place[places[worst]].tolist(), places[worst : worst + 1]
        row = others.made_by(after.nominal[at] + now[worst] * after.normal[at])
        held = float(-cut[worst]), (x, y), int(written.toolpath.line(row[0]))
        if refused:
            raise LimitError(
                phrase(
                    "line {} of the corrected program, which is not corrected itself, would cut {} into the "
                    "corrected surface at {}: it leaves too little stock for it; {} moves such passes along",
                    held[2],
                    um(held[0]),
                    xy(x, y),
                    remedy("keep_allowance"),
                ),
                place=(x, y),
                figure=held[0],
            )
    return held


def _left(others: CommandedSurface, after: WantedSurface, places: Ints) -> Floats:
    """How far the surface of moves lies from places of the nominal, mm; NaN where none comes near; (n,)."""
    lowest = np.fmin(others.toolpath.start[:, 2], others.toolpath.end[:, 2])
    out = np.full(len(places), np.nan)
    for top in np.unique(after.top[places]):
        # What only cuts above a step of a wall is no matter of the step.
        rows = np.flatnonzero(after.top[places] == top)
        foot, normal = after.nominal[places[rows]], after.normal[places[rows]]
        out[rows] = others.only(~(lowest >= top - BELOW)).offset(foot, normal)
    return out


def _out_of_reach(after: WantedSurface, radius: float) -> Floats:
    """What the cutter has to leave over the wanted surface, mm; (n,)."""
    z = np.where(np.isfinite(after.bottom), after.bottom, np.nan)
    path = after.outside(np.column_stack([after.place + radius * after.normal, z]), radius)
    # From a corner itself no normal leads to where the cutter goes.
    clear = (after.distance(np.column_stack([path, z])) > radius - EXACT) & ~after.on_a_corner(after.place)
    a, b = after.chords.T
    joined = (np.hypot(*(path[b] - path[a]).T) < 2 * radius) & clear[a] & clear[b]
    out = np.empty(len(path))
    for height in np.unique(after.bottom):
        here = after.bottom == height
        chords = joined & here[a]
        out[here] = _left_along_normals(SegmentTree(path[a[chords]], path[b[chords]]), after, here, radius)
    return out


def _left_along_normals(path: SegmentTree, after: WantedSurface, here: Bools, radius: float) -> Floats:
    """How far along the normals of places a disc led along a path clears the way, mm, as the surface is compared."""
    place, normal = after.place[here], after.normal[here]
    out = np.zeros(len(place))
    active = np.arange(len(out))
    for _ in range(ROUNDS):
        progress.step()
        step = path.distance(place[active] + out[active, None] * normal[active]) - radius
        out[active] += np.maximum(step, 0.0)
        active = active[(step > EXACT) & (out[active] < radius)]
        if not len(active):
            break
    return out
