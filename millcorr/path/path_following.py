# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which moves of a toolpath follow the profile, and where on it.

A move follows where all of it lies at the cutter's radius from a piece of the nominal, on a piece's straight
continuation (the path runs past a convex corner or past an open end), or on the arc about a convex corner.
Leads, links, ramps beside the contour, roughing passes and rapids do not follow. Where the program carries a
correction, all this is meant of the nominal with that correction.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.theoretical_contour import cutting_runs
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import GAP
from millcorr.nc.toolpath import Toolpath
from millcorr.path.reconstruction import CompensatedContour

SAMPLES = np.linspace(0.0, 1.0, 9)
BESIDE = 0.02
"""A move whose distance from the profile varies by less than this, in mm, runs along it."""

NOWHERE = np.iinfo(np.int64).min


@dataclass(frozen=True, eq=False, slots=True)
class Following:
    """Parts of moves that follow the nominal profile, in the order of the path; one row a part.

    Parameters
    ----------
    row : (e,) int64
        Row of the toolpath; a row has several parts where it passes from piece to piece.
    piece : (e,) int64
        Piece of the contour, or ``-1 - j`` on the arc about joint j.
    first, last : (e,) float64
        Arc length on the piece, mm, at the part's first and last sample; NaN about a joint.
    begin, end : (e,) float64
        Fractions of the move between which the part lies.
    middle : (e,) float64
        Arc length on the piece, mm, in the middle of the part; NaN about a joint.
    way : (e,) float64
        1 where the part runs in the profile's direction, -1 against it; 0 about a joint.
    chain : (e,) int64
        Parts of connected moves share a number.
    error : (n,) float64
        For every row of the toolpath the distance in mm by which it is off the nominal's exact parallel at
        most; NaN for rows that do not follow.
    beside : (n,) bool
        For every row of the toolpath, whether it runs along the profile at another distance.
    distance : float
        Of the feed moves that do not follow, the smallest typical distance from the profile, mm.
    """

    row: Ints
    piece: Ints
    first: Floats
    last: Floats
    begin: Floats
    end: Floats
    middle: Floats
    way: Floats
    chain: Ints
    error: Floats
    beside: Bools
    distance: float


def follow(
    toolpath: Toolpath,
    contour: CompensatedContour,
    radius: float,
    *,
    band: float,
    rows: Bools | None = None,
) -> Following:
    """Find the moves that follow a contour.

    Parameters
    ----------
    toolpath : Toolpath
    contour : CompensatedContour
        What the program is expected to follow: the nominal, with the correction that the program carries.
    radius : float
        Distance in mm between path and contour.
    band : float
        How far, in mm, a following move may be off.
    rows : (n,) bool, optional
        Moves that may follow; all by default.

    Returns
    -------
    Following
    """
    runs = cutting_runs(toolpath)
    index = np.concatenate(runs) if runs else np.zeros(0, dtype=np.int64)
    if rows is not None:
        index = index[rows[index]]
    error = np.full(len(toolpath), np.nan)
    none = np.zeros(0, dtype=np.int64)
    if not len(index):
        empty = np.zeros(0)
        beside = np.zeros(len(toolpath), dtype=bool)
        return Following(none, none, empty, empty, empty, empty, empty, empty, none, error, beside, np.inf)
    points = toolpath.take(index).position(SAMPLES).reshape(-1, 3)
    k = len(SAMPLES)
    label, sigma, off = _label(points, contour, radius, band)
    points = points[:, :2]
    label, sigma, off = label.reshape(-1, k), sigma.reshape(-1, k), off.reshape(-1, k)
    inner = slice(1, k - 1)
    _prefer_one_piece(label, sigma, off, points.reshape(-1, k, 2), contour, radius, band)
    good = (label[:, inner] != NOWHERE).all(axis=1) & _steady(label, sigma, contour)
    ends_on_piece = _ends_on_their_piece(label, sigma, points.reshape(-1, k, 2), contour, radius)
    advance = _advance(label, sigma, contour)
    row, piece, first, last, begin, end, middle, way = [], [], [], [], [], [], [], []
    for i in np.flatnonzero(good):
        names = label[i, inner]
        cuts = np.flatnonzero(np.diff(names)) + 1
        edges = np.concatenate([[0], cuts, [k - 2]])
        for a, b in zip(edges[:-1], edges[1:], strict=True):
            row.append(index[i])
            piece.append(names[a])
            first.append(ends_on_piece[i, 0] if a == 0 else sigma[i, a + 1])
            last.append(ends_on_piece[i, 1] if b == k - 2 else sigma[i, b])
            middle.append(sigma[i, (a + b + 1) // 2])
            way.append(np.sign(advance[i, a + 1 : b].sum()))
            begin.append(0.0 if a == 0 else float(SAMPLES[a] + SAMPLES[a + 1]) / 2)
            end.append(1.0 if b == k - 2 else float(SAMPLES[b] + SAMPLES[b + 1]) / 2)
        seen = label[i] != NOWHERE
        error[index[i]] = float(np.abs(off[i, seen]).max())
    row_array = np.array(row, dtype=np.int64)
    joined = np.zeros(len(row_array), dtype=bool)
    if len(row_array) > 1:
        # A plunge or retract on the spot does not part two moves.
        delta = np.nan_to_num(toolpath.end[:, :2] - toolpath.start[:, :2], nan=1.0)
        travelled = np.concatenate([[0.0], np.cumsum(np.hypot(*delta.T) + np.abs(toolpath.sweep))])
        between = travelled[row_array[1:]] - travelled[row_array[:-1] + 1]
        meets = np.hypot(*(toolpath.start[row_array[1:], :2] - toolpath.end[row_array[:-1], :2]).T) < 1e-9
        joined[1:] = (row_array[1:] == row_array[:-1]) | (meets & (np.abs(between) < 1e-9))
    beside = np.zeros(len(toolpath), dtype=bool)
    along = (np.ptp(off, axis=1) < BESIDE) & (np.abs(off).max(axis=1) < max(3 * radius, 10.0))
    beside[index[along & ~good & (toolpath.take(index).length() > 2.0)]] = True
    distance = np.median(np.abs(off), axis=1)
    apart = distance[~good]
    return Following(
        row_array,
        np.array(piece, dtype=np.int64),
        np.array(first),
        np.array(last),
        np.array(begin),
        np.array(end),
        np.array(middle),
        np.array(way),
        np.cumsum(~joined) - 1,
        error,
        beside,
        float(apart.min()) if len(apart) else np.inf,
    )


def length_in_plane(toolpath: Toolpath) -> Floats:
    """Length of every move in mm as seen from above, known where the height is not; (n,)."""
    level = [np.column_stack([end[:, :2], np.zeros(len(toolpath))]) for end in (toolpath.start, toolpath.end)]
    return toolpath.with_moves(start=level[0], end=level[1]).length()


def _label(points: Floats, contour: CompensatedContour, radius: float, band: float) -> tuple[Ints, Floats, Floats]:
    """Piece (or joint, or NOWHERE), arc length on it, and distance off the nominal's parallel at each point."""
    profile = contour.profile
    feet = FootPointSearch(profile, margin=radius + 2.0).find(points)
    points = points[:, :2]
    piece, sigma = contour.position_on_piece(feet.span, feet.t)
    off = feet.distance - radius
    ends = np.flatnonzero(feet.place == Place.END)
    if len(ends):
        normal = profile.normals(feet.span[ends], feet.t[ends])
        arm = points[ends] - feet.foot[ends]
        off[ends] = (arm * normal).sum(axis=1) - radius
        sigma[ends] += arm[:, 1] * normal[:, 0] - arm[:, 0] * normal[:, 1]
    label = np.where(np.abs(off - contour.correction_on(piece, sigma)) <= band, piece, NOWHERE)
    _label_at_joints(points, feet, piece, label, sigma, off, contour, radius, band)
    return label, sigma, off


def _label_at_joints(
    points: Floats,
    feet: FootPoints,
    piece: Ints,
    label: Ints,
    sigma: Floats,
    off: Floats,
    contour: CompensatedContour,
    radius: float,
    band: float,
) -> None:
    """Points about corners: on the continuation of either side, or on the arc about the corner. In place."""
    joints = contour.joints
    if not len(joints.before):
        return
    rows, which, own = _near_joints(feet, piece, sigma, contour, radius)
    before, after = joints.before[which], joints.after[which]
    length = contour.length[before]
    arm = points[rows] - joints.point[which]
    na, nb = contour.nominal_normal(before, length), contour.nominal_normal(after, np.zeros(len(which)))
    on_a, on_b = own == before, own == after
    # A foot that lies on a side, not at the corner, is exact on a curved side, too.
    along_a = np.where(on_a, sigma[rows] - length, _cross(na, arm))
    along_b = np.where(on_b, sigma[rows], _cross(nb, arm))
    off_a = np.where(on_a, off[rows], (arm * na).sum(axis=1) - radius)
    off_b = np.where(on_b, off[rows], (arm * nb).sum(axis=1) - radius)
    side = np.where(feet.distance[rows] < 0, -1.0, 1.0)
    corner = points[rows] - contour.evaluate(before, contour.high[before])[0]
    options = np.abs(
        np.stack(
            [
                off_a - contour.correction_on(before, length + along_a),
                off_b - contour.correction_on(after, along_b),
                side * np.hypot(*corner.T) - radius,
            ]
        )
    )
    options[0, ~on_a & (along_a < -1e-9)] = np.inf
    options[1, ~on_b & (along_b > 1e-9)] = np.inf
    options[2, (_cross(na, corner) < -1e-6) | (_cross(nb, corner) > 1e-6)] = np.inf
    # The arc about the corner only where neither side's continuation fits as well.
    options[2] += 1e-6
    best, pick = options.argmin(axis=0), np.arange(len(which))
    off[rows] = np.stack([off_a, off_b, side * np.hypot(*arm.T) - radius])[best, pick]
    sigma[rows] = np.stack([length + along_a, along_b, np.full(len(which), np.nan)])[best, pick]
    label[rows] = np.where(options[best, pick] <= band, np.stack([before, after, -1 - which])[best, pick], NOWHERE)


def _near_joints(
    feet: FootPoints, piece: Ints, sigma: Floats, contour: CompensatedContour, radius: float
) -> tuple[Ints, Ints, Ints]:
    """Points about a corner, its joint, and the piece that their foot lies on (-1 at the corner itself).

    Beside those whose foot is the corner: where a correction moves a convex corner back into the material, those
    with the foot between the moved corner and the nominal one.
    """
    joints = contour.joints
    at = np.flatnonzero(feet.place == Place.JOINT)
    joint = _joint_at(contour, feet.foot[at])
    rows, which, own = [at[joint >= 0]], [joint[joint >= 0]], [np.full(int((joint >= 0).sum()), -1)]
    smooth = feet.place == Place.SMOOTH
    for side, beyond in (
        (joints.before, sigma - contour.high[piece] > 1e-9),
        (joints.after, contour.low[piece] - sigma > 1e-9),
    ):
        joint_of = np.full(len(contour.length), -1)
        joint_of[side] = np.arange(len(side))
        joint = joint_of[piece]
        found = np.flatnonzero(smooth & beyond & (joint >= 0) & (joints.turn[joint] > 0) & (radius > 0))
        rows.append(found)
        which.append(joint[found])
        own.append(piece[found])
    return np.concatenate(rows), np.concatenate(which), np.concatenate(own)


def _cross(normal: Floats, arm: Floats) -> Floats:
    """Length of arms along the contour whose normals are given; (n,)."""
    out: Floats = arm[:, 1] * normal[:, 0] - arm[:, 0] * normal[:, 1]
    return out


def _prefer_one_piece(
    label: Ints, sigma: Floats, off: Floats, points: Floats, contour: CompensatedContour, radius: float, band: float
) -> None:
    """A move that one piece and its continuation explain whole is given to that piece. In place."""
    k = label.shape[1]
    inner = slice(1, k - 1)
    for i in np.flatnonzero((label[:, inner] != label[:, 1:2]).any(axis=1) & (label[:, inner] != NOWHERE).all(axis=1)):
        for piece in np.unique(label[i, inner][label[i, inner] >= 0]):
            known = np.flatnonzero(label[i] == piece)
            nearest = known[np.abs(np.arange(k)[:, None] - known[None]).argmin(axis=1)]
            names = np.full(k, piece)
            away, along = contour.distance_off(names, sigma[i, nearest], points[i], radius, corrected=False)
            if (np.abs(away - contour.correction_on(names, along)) <= band).all():
                label[i], sigma[i], off[i] = piece, along, away
                break


def _ends_on_their_piece(
    label: Ints, sigma: Floats, points: Floats, contour: CompensatedContour, radius: float
) -> Floats:
    """Arc lengths (m, 2) of every move's ends on the piece that its inside next to them follows."""
    k = label.shape[1]
    out = sigma[:, [0, k - 1]].copy()
    for column, end, inside in ((0, 0, 1), (1, k - 1, k - 2)):
        piece = np.maximum(label[:, inside], 0)
        # At the only corner of a contour the foot may lie at the piece's other end.
        jumps = ~contour.closed[piece] & (np.abs(sigma[:, end] - sigma[:, inside]) > contour.length[piece] / 2)
        rows = np.flatnonzero(((label[:, end] != label[:, inside]) | jumps) & (label[:, inside] >= 0))
        if len(rows):
            step = sigma[rows, inside] - sigma[rows, 2 * inside - end]
            guess = sigma[rows, inside] + np.where(np.isfinite(step), step, 0.0)
            _, out[rows, column] = contour.distance_off(
                label[rows, inside], guess, points[rows, end], radius, corrected=False
            )
    return out


def _joint_at(contour: CompensatedContour, foot: Floats) -> Ints:
    """Joint at each foot point, -1 where there is none (a turn too small to be one)."""
    from scipy.spatial import cKDTree

    distance, which = cKDTree(contour.joints.point).query(foot)
    return np.where(distance < GAP, which, -1).astype(np.int64)


def _advance(label: Ints, sigma: Floats, contour: CompensatedContour) -> Floats:
    """Arc length gained from sample to sample on the same piece, mm; 0 elsewhere; (m, k - 1)."""
    same = (label[:, 1:] == label[:, :-1]) & (label[:, 1:] >= 0)
    piece = np.maximum(label[:, 1:], 0)
    step = np.diff(sigma, axis=1)
    length = contour.length[piece]
    step = np.where(contour.closed[piece], (step + length / 2) % length - length / 2, step)
    return np.where(same, step, 0.0)


def _steady(label: Ints, sigma: Floats, contour: CompensatedContour) -> Bools:
    """Rows that run along their pieces one way: no move across the contour passes for one along it."""
    step = _advance(label, sigma, contour)
    same = (label[:, 1:] == label[:, :-1]) & (label[:, 1:] >= 0)
    inner = slice(1, same.shape[1] - 1)
    forward = ((step > 0) | ~same)[:, inner].all(axis=1)
    backward = ((step < 0) | ~same)[:, inner].all(axis=1)
    out: Bools = forward | backward
    return out
