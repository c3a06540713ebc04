# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a displacement of the cutter's centre to the profile that its circle then stands for.

A deflection is one of the cutter's centre: to cancel it the *path* has to be moved, each of its points along the
normal of the place that it makes. Programs are written as exact parallels of a profile. Where the displacement changes
along the contour the two are not the same: a slope of 0.08 moves the place that a cutter of radius 10 mm touches by
0.8 mm along the contour, and 0.03 mm deep. The parallel of the profile found here is the displaced path.
"""

from __future__ import annotations

import numpy as np
import shapely

from millcorr.arrays import Floats, Ints
from millcorr.geometry.correction import along
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile, Stretch

SHARE = 0.9
"""Share of the curvature that the cutter has room for that a profile may use: courses through points swing a little."""

_NEAR = 1e-6
_TURNS = np.array([0.0, 0.25, 0.5, 0.75, 1.0])
"""A bend of the path is rounded by the cutter: so many of its points are looked at."""


def profile_of_path(
    profile: Profile, stretch: Ints, s: Floats, shift: Floats, radius: float
) -> tuple[Ints, Floats, Floats]:
    """Displacements of a profile whose parallel is a displaced path.

    Parameters
    ----------
    profile : Profile
    stretch : (n,) int64
        Smooth stretch of each point.
    s : (n,) float64
        Arc length from the contour's start, mm.
    shift : (n,) float64
        Displacement along the normal of the cutter's centre where it touches the profile at `s`, mm.
    radius : float
        Of the cutter, mm.

    Returns
    -------
    stretch : (m,) int64
    s : (m,) float64
        The points given, and some beyond the first and last of a stretch, where the cutter touches nothing.
    value : (m,) float64
        Displacement of the profile along its normal, mm: the surface that the circle leaves on the displaced path,
        rounded a little more where it is as hollow as the cutter.
    """
    out = np.array(shift, dtype=np.float64)
    stretches = profile.stretches()
    more_stretch, more_s, more_value = [stretch], [s], []
    for k in np.unique(stretch):
        rows = np.flatnonzero(stretch == k)
        out[rows] = _swept(profile, stretches[k], s[rows], shift[rows], radius)
        if not stretches[k].closed:
            at, value = _held(stretches[k], along(stretches[k], s[rows], profile), out[rows])
            more_stretch.append(np.full(len(at), k))
            more_s.append(at)
            more_value.append(value)
    whole_stretch, whole_s = np.concatenate(more_stretch), np.concatenate(more_s)
    value = np.concatenate([out, *more_value])
    return whole_stretch, whole_s, reachable(profile, whole_stretch, whole_s, value, radius)


def _held(stretch: Stretch, local: Floats, value: Floats) -> tuple[Floats, Floats]:
    """Places from the ends of an open stretch to its first and last point, where that point's value is held.

    A course that runs out at a slope and is held from there on has a crease, and the path beside it turns there.
    """
    order = np.argsort(local)
    usual = float(np.median(np.diff(local[order]))) if len(local) > 1 else stretch.length
    first, last = local[order[0]], local[order[-1]]
    before = np.arange(first - usual, 0.0, -usual)
    behind = np.arange(last + usual, stretch.length, usual)
    at = stretch.begin + np.concatenate([before, behind])
    return at, np.concatenate([np.full(len(before), value[order[0]]), np.full(len(behind), value[order[-1]])])


def _swept(profile: Profile, stretch: Stretch, s: Floats, shift: Floats, radius: float) -> Floats:
    """Surface under a displaced path on one stretch; (n,)."""
    local = along(stretch, s, profile)
    order = np.argsort(local, kind="stable")
    order = order[np.concatenate([[True], np.diff(local[order]) > _NEAR])]
    if len(order) < 3:
        return shift
    x = local[order]
    point, normal = profile.at(np.full(len(x), stretch.contour), s[order])
    centre = point + (radius + shift[order])[:, None] * normal
    if stretch.closed:
        turn = np.arange(-1, len(x) + 1) % len(x)
        centre = centre[turn]
    way = np.diff(centre, axis=0)
    way /= np.maximum(np.hypot(*way.T), 1e-15)[:, None]
    side = np.stack([way[:, 1], -way[:, 0]], axis=1)
    if not stretch.closed:
        side, inner = np.concatenate([side[:1], side, side[-1:]]), centre
    else:
        inner = centre[1:-1]
    before, after = side[:-1], side[1:]
    mixed = before[:, None] * (1 - _TURNS)[:, None] + after[:, None] * _TURNS[:, None]
    mixed /= np.maximum(np.sqrt((mixed**2).sum(axis=2)), 1e-15)[:, :, None]
    swept = (inner[:, None] - radius * mixed).reshape(-1, 2)
    feet = FootPointSearch(profile, margin=float(np.abs(shift).max()) + 1.0).find(swept)
    at = along(stretch, profile.arc_length(feet.span, feet.t), profile)
    value = (swept - feet.foot) * feet.normal
    return _lowest(x, local, at, value.sum(axis=1), profile.stretch[feet.span], shift, stretch)


def _lowest(
    x: Floats, local: Floats, at: Floats, value: Floats, owner: Ints, shift: Floats, stretch: Stretch
) -> Floats:
    """Lowest of the lines between swept points at arc lengths `local`; the displacement itself where there is none."""
    a, b = at[:-1], at[1:]
    # Neither onto another stretch nor across the seam.
    good = (owner[:-1] == owner[1:]) & (np.abs(b - a) < min(0.25 * stretch.length, 20.0 * float(np.diff(x).max())))
    a, b, va, vb = a[good], b[good], value[:-1][good], value[1:][good]
    order = np.argsort(local, kind="stable")
    grid = local[order]
    low, high = np.searchsorted(grid, np.minimum(a, b) - 1e-9), np.searchsorted(grid, np.maximum(a, b) + 1e-9, "right")
    count = high - low
    segment = np.repeat(np.arange(len(a)), count)
    row = np.arange(len(segment)) - np.repeat(np.cumsum(count) - count, count) + np.repeat(low, count)
    width = b[segment] - a[segment]
    share = np.clip((grid[row] - a[segment]) / np.where(np.abs(width) > 1e-12, width, 1.0), 0.0, 1.0)
    found = np.full(len(grid), np.inf)
    np.minimum.at(found, row, va[segment] + share * (vb - va)[segment])
    out = np.empty(len(grid))
    out[order] = np.where(np.isfinite(found), found, shift[order])
    return out


def reachable(profile: Profile, stretch: Ints, s: Floats, value: Floats, radius: float) -> Floats:
    """Displacements of a profile that are nowhere hollower than the cutter, and nowhere below the wanted ones.

    Parameters
    ----------
    profile : Profile
    stretch : (n,) int64
        Smooth stretch of each point.
    s : (n,) float64
        Arc length from the contour's start, mm.
    value : (n,) float64
        Wanted displacement along the normal, mm.
    radius : float
        Of the cutter, mm.

    Returns
    -------
    (n,) float64
        mm. To second order the displaced profile has the curvature ``kappa + d2v/ds2``, hollow where it is below 0, and
        the cutter fits where ``d2v/ds2 <= 1/R + kappa``. With M the second integral of that room, ``v - M`` must be
        concave: the answer is its smallest concave bound, plus M.
    """
    out = np.array(value, dtype=np.float64)
    stretches = profile.stretches()
    for k in np.unique(stretch):
        rows = np.flatnonzero(stretch == k)
        out[rows] = _on_stretch(profile, stretches[k], s[rows], value[rows], radius)
    return out


def _on_stretch(profile: Profile, stretch: Stretch, s: Floats, value: Floats, radius: float) -> Floats:
    local = along(stretch, s, profile)
    order = np.argsort(local, kind="stable")
    x, v = local[order], value[order]
    apart = np.concatenate([[True], np.diff(x) > _NEAR])
    if apart.sum() < 3:
        return value
    group = np.cumsum(apart) - 1
    x, v = x[apart], np.bincount(group, v) / np.bincount(group)
    span, t = profile.locate(np.full(len(x), stretch.contour), s[order][apart])
    room = SHARE * np.maximum(1.0 / radius + profile.curvature(span, t), 0.0)
    # What is softened below must not spread curvature to where there is less room for it.
    for _ in range(3):
        room = np.minimum(room, np.minimum(np.append(room[1:], room[-1]), np.append(room[0], room[:-1])))
    count = len(x)
    if stretch.closed:
        # Three turns: the middle one does not know where the seam is.
        x = np.concatenate([x - stretch.length, x, x + stretch.length])
        v, room = np.tile(v, 3), np.tile(room, 3)
    step = np.diff(x)
    slope = np.concatenate([[0.0], np.cumsum(step * (room[1:] + room[:-1]) / 2)])
    bend = np.concatenate([[0.0], np.cumsum(step * (slope[1:] + slope[:-1]) / 2)])
    w = _concave(x, v - bend) + bend
    for _ in range(2):
        # Softens the changes of curvature, at which a cubic course would swing beyond it.
        inner = (w[:-2] + 2 * w[1:-1] + w[2:]) / 4
        even = np.abs(step[1:] - step[:-1]) < 0.5 * np.minimum(step[1:], step[:-1])
        w[1:-1] = np.where(even, inner, w[1:-1])
    if stretch.closed:
        w = w[count : 2 * count]
    out = np.empty(len(value))
    out[order] = w[group]
    return out


def _concave(x: Floats, y: Floats) -> Floats:
    """Smallest concave function that is nowhere below points; at the same x, increasing."""
    hull = shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(np.column_stack([x, y]))))
    first, last = np.array([x[0], y[0]]), np.array([x[-1], y[-1]])
    way = last - first
    over = (hull[:, 1] - first[1]) * way[0] - (hull[:, 0] - first[0]) * way[1] >= 0
    upper = np.unique(np.concatenate([hull[over], first[None], last[None]]), axis=0)
    out: Floats = np.maximum(np.interp(x, upper[:, 0], upper[:, 1]), y)
    return out
