# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which part of a cutter's circle lies where an earlier cutter has been: closed forms for lines and arcs.

A disc of radius r about c covers of the circle of radius R about O the angles within
``acos((d^2 + R^2 - r^2) / (2 d R))`` of the direction from O to c, d the distance. Along a piece of path this
interval moves without a jump, so a piece that stays within reach covers one interval. Its ends belong to ends of
the piece or to where the circle meets the piece's parallels at distance r.
"""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Bools, Floats, Ints

SAME_PLACE = 1e-9
"""A cutter that was here before, within this in mm, leaves nothing."""

WHOLE = 4.0
"""Half an interval that covers the whole circle, in rad: more than pi."""


def wrapped(angle: Floats) -> Floats:
    """Angles in -pi..pi."""
    out: Floats = angle - 2 * np.pi * np.round(angle / (2 * np.pi))
    return out


def half_width(d2: Floats, radius: float, swept: Floats | float) -> Floats:
    """Half of what a disc at squared distance `d2` covers, in rad: 0 where it does not reach, pi where all."""
    d = np.sqrt(np.maximum(d2, 1e-300))
    with np.errstate(over="ignore"):
        c = (d2 + (radius - swept) * (radius + swept)) / (2 * d * radius)
    out: Floats = np.arccos(np.clip(c, -1.0, 1.0))
    return out


def covered_by_lines(
    ox: Floats, oy: Floats, radius: float, ax: Floats, ay: Floats, bx: Floats, by: Floats, swept: float
) -> tuple[Ints, Floats, Floats]:
    """Angles of circles that discs moving along lines cover.

    Parameters
    ----------
    ox, oy : (n,) float64
        Centres of the circles in mm.
    radius : float
        Radius of the circles in mm.
    ax, ay, bx, by : (n,) float64
        Ends of the lines in mm; both may be the same point.
    swept : float
        Radius of the moving disc in mm.

    Returns
    -------
    row : (m,) int64
        Pair that the interval belongs to; rows without one are left out, a smaller disc can give two.
    middle, half : (m,) float64
        Interval ``middle +- half`` in rad; a half above pi is the whole circle.
    """
    ex, ey = bx - ax, by - ay
    length = np.hypot(ex, ey)
    point = length == 0
    scale = 1.0 / np.where(point, 1.0, length)
    ex, ey = np.where(point, 1.0, ex * scale), ey * scale
    vx, vy = ax - ox, ay - oy
    low = vx * ex + vy * ey
    across = ex * vy - ey * vx
    h = np.abs(across)
    high = low + length
    # Angles are counted from the direction to the line's foot, positive towards the line's end.
    side = np.where(across >= 0, 1.0, -1.0)
    foot = np.arctan2(side * ex, -side * ey)
    reach2 = (radius + swept) ** 2 - h * h
    reach = np.sqrt(np.maximum(reach2, 0.0))
    row = np.arange(len(ox))
    row, low, high, whole = _reaching(row, low, high, reach, reach2 > 0, h * h, radius, swept)
    if swept >= radius:
        whole |= (h[row] <= SAME_PLACE) & (low <= SAME_PLACE) & (high >= -SAME_PLACE)
    h, side, foot = h[row], side[row], foot[row]
    first = np.arctan2(low, h)
    last = np.arctan2(high, h)
    w0, w1 = half_width(low * low + h * h, radius, swept), half_width(high * high + h * h, radius, swept)
    lo, hi = np.minimum(first - w0, last - w1), np.maximum(first + w0, last + w1)
    c = np.clip((h - swept) / radius, -1.0, 1.0)
    edge, at = np.arccos(c), radius * np.sqrt(1 - c * c)
    hi = np.where((low <= at) & (at <= high), np.maximum(hi, edge), hi)
    lo = np.where((low <= -at) & (-at <= high), np.minimum(lo, -edge), lo)
    if swept < radius:
        c = (h + swept) / radius
        meets = c <= 1
        c = np.minimum(c, 1.0)
        edge, at = np.arccos(c), radius * np.sqrt(1 - c * c)
        lo = np.where(meets & (low <= at) & (at <= high), np.minimum(lo, edge), lo)
        hi = np.where(meets & (low <= -at) & (-at <= high), np.maximum(hi, -edge), hi)
    # The direction of the line lies clockwise of a foot on its left.
    middle = foot - side * (lo + hi) / 2
    return row, middle, np.where(whole, WHOLE, (hi - lo) / 2)


def covered_by_arcs(
    ox: Floats,
    oy: Floats,
    radius: float,
    cx: Floats,
    cy: Floats,
    rho: Floats,
    angle: Floats,
    sweep: Floats,
    swept: float,
) -> tuple[Ints, Floats, Floats]:
    """Angles of circles that discs moving along arcs cover.

    Parameters
    ----------
    ox, oy, radius, swept
        As for lines.
    cx, cy, rho : (n,) float64
        Centres and radii of the arcs in mm.
    angle, sweep : (n,) float64
        Direction of the arc's start seen from its centre, and signed turn of less than pi, rad.

    Returns
    -------
    row, middle, half
        As for lines.
    """
    dx, dy = ox - cx, oy - cy
    distance = np.hypot(dx, dy)
    outward = np.arctan2(dy, dx)
    begin = angle - outward
    shift = 2 * np.pi * np.round((begin + sweep / 2) / (2 * np.pi))
    b0 = np.minimum(begin, begin + sweep) - shift
    b1 = np.maximum(begin, begin + sweep) - shift
    row = np.arange(len(ox))
    # The farthest point of the circle of the arc is where it is cut, so that one window is enough.
    left, right = np.flatnonzero(b0 < -np.pi), np.flatnonzero(b1 > np.pi)
    row = np.concatenate([row, left, right])
    b0, b1 = (
        np.concatenate([np.maximum(b0, -np.pi), b0[left] + 2 * np.pi, np.full(len(right), -np.pi)]),
        np.concatenate([np.minimum(b1, np.pi), np.full(len(left), np.pi), b1[right] - 2 * np.pi]),
    )
    distance, rho, outward = distance[row], rho[row], outward[row]
    gap2 = (distance - rho) ** 2
    chord = np.maximum(4 * distance * rho, 1e-300)
    half_sine2 = ((radius + swept) ** 2 - gap2) / chord
    window = 2 * np.arcsin(np.sqrt(np.clip(half_sine2, 0.0, 1.0)))
    inner = 2 * np.arcsin(np.sqrt(np.clip(((radius - swept) ** 2 - gap2) / chord, 0.0, 1.0)))
    near = half_sine2 > 0
    b0, b1 = np.maximum(b0, -window), np.minimum(b1, window)
    keep = near & (b0 <= b1)
    whole = np.zeros(len(row), dtype=bool)
    if swept != radius:
        inside = keep & ((radius - swept) ** 2 > gap2)
        if swept > radius:
            whole = inside & (b0 < inner) & (b1 > -inner)
        else:
            left = np.flatnonzero(inside & (b0 < -inner))
            right = np.flatnonzero(inside & (b1 > inner))
            keep &= ~inside
            pick = np.concatenate([np.flatnonzero(keep), left, right])
            b0 = np.concatenate([b0[keep], b0[left], np.maximum(b0[right], inner[right])])
            b1 = np.concatenate([b1[keep], np.minimum(b1[left], -inner[left]), b1[right]])
            row, distance, rho, outward, gap2, chord = (v[pick] for v in (row, distance, rho, outward, gap2, chord))
            keep, whole = np.ones(len(pick), dtype=bool), np.zeros(len(pick), dtype=bool)
    row, distance, rho, outward, gap2, chord, b0, b1, whole = (
        v[keep] for v in (row, distance, rho, outward, gap2, chord, b0, b1, whole)
    )
    lo, hi = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    within = distance < rho
    if swept >= radius:
        slack = SAME_PLACE / rho
        whole |= (np.abs(distance - rho) <= SAME_PLACE) & (b0 <= slack) & (b1 >= -slack)

    def take(b: Floats) -> None:
        s, c = rho * np.sin(b), rho * np.cos(b)
        # From the nearest point of the arc's circle: seen from inside it lies outward, from outside inward.
        psi = np.where(within, np.arctan2(s, c - distance), np.arctan2(-s, distance - c))
        w = half_width(gap2 + chord * np.sin(b / 2) ** 2, radius, swept)
        np.minimum(lo, psi - w, out=lo)
        np.maximum(hi, psi + w, out=hi)

    take(b0)
    take(b1)
    d = np.maximum(distance, 1e-300)
    for q, there in ((rho + swept, np.ones(len(row), dtype=bool)), (rho - swept, rho > swept)):
        q = np.where(there, q, 1.0)
        with np.errstate(over="ignore"):
            c = (d * d + q * q - radius * radius) / (2 * d * q)
        b = np.arccos(np.clip(c, -1.0, 1.0))
        there = there & (np.abs(c) <= 1)
        if there.any():
            take(np.where(there, np.clip(b, b0, b1), b0))
            take(np.where(there, np.clip(-b, b0, b1), b0))
    reference = np.where(within, outward, outward + np.pi)
    middle = reference + (lo + hi) / 2
    return row, middle, np.where(whole, WHOLE, (hi - lo) / 2)


def _reaching(
    row: Ints, low: Floats, high: Floats, reach: Floats, near: Bools, h2: Floats, radius: float, swept: float
) -> tuple[Ints, Floats, Floats, Bools]:
    """Parts of lines whose discs meet the circle: up to two where the disc is smaller and can lie inside it."""
    a, b = np.maximum(low, -reach), np.minimum(high, reach)
    keep = near & (a <= b)
    whole = np.zeros(len(row), dtype=bool)
    if swept == radius:
        return row[keep], a[keep], b[keep], whole[keep]
    inner2 = (radius - swept) ** 2 - h2
    inner = np.sqrt(np.maximum(inner2, 0.0))
    inside = keep & (inner2 > 0)
    if swept > radius:
        whole = inside & (a < inner) & (b > -inner)
        return row[keep], a[keep], b[keep], whole[keep]
    left, right = np.flatnonzero(inside & (a < -inner)), np.flatnonzero(inside & (b > inner))
    keep &= ~inside
    return (
        np.concatenate([row[keep], left, right]),
        np.concatenate([a[keep], a[left], np.maximum(a[right], inner[right])]),
        np.concatenate([b[keep], np.minimum(b[left], -inner[left]), b[right]]),
        np.zeros(int(keep.sum()) + len(left) + len(right), dtype=bool),
    )


def behind(radius: float, rho: Floats, sweep: Floats) -> tuple[Floats, Floats]:
    """What a cutter covers of its own circle by the piece of path that ends where it is.

    Parameters
    ----------
    radius : float
        Cutter radius R in mm.
    rho, sweep : (n,) float64
        Radius in mm (inf for a line) and signed turn in rad of the piece.

    Returns
    -------
    middle, half : (n,) float64
        Interval in rad from the direction of travel: the rear half, and where the path turns tighter than R
        on its inner side up to ``phi / 2 + acos(rho sin(phi / 2) / R)`` from straight back.
    """
    turn = np.abs(sweep)
    tight = rho < radius
    s = np.where(tight, rho, 0.0) * np.sin(turn / 2) / radius
    extra = np.where(tight, turn / 2 + np.arccos(np.clip(s, -1.0, 1.0)) - np.pi / 2, 0.0)
    # A path that turns left has its inner side on the left, clockwise of straight back.
    return np.pi - np.sign(sweep) * extra / 2, np.pi / 2 + extra / 2
