# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines beside a profile, farther off it than the curve of a corner lets them: what would be folded is left out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Bools, Floats, Ints
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile

Indices = NDArray[np.int32]

SLACK = 0.01
"""A place is folded where its line is nearer to another place of its contour by more than this share."""

NOTHING = 1e-6
"""Distances that differ by less, in mm, are the same."""

GAP = 1.0
"""Places at both ends of a fold are joined where they are no farther from each other than this, mm."""


def unfolded(profile: Profile, span: Ints, point: Floats, normal: Floats, offset: Floats) -> Bools:
    """Whether places that stand off a profile along its normal have their nearest point of the contour there, (n,).

    Beyond the centre of a curve that is tighter than the offset, and beyond the middle of a neck, they have not: a
    line through them would run backwards.

    Parameters
    ----------
    profile : Profile
    span : (n,) int64
    point, normal : (n, 2) float64
        Of the profile; mm and directional cosines.
    offset : (n,) float64
        mm.
    """
    search = FootPointSearch(profile)
    out = np.ones(len(span), dtype=bool)
    contour = profile.contour[span]
    for k in np.unique(contour):
        rows = np.flatnonzero((contour == k) & (np.abs(offset) > 0))
        if len(rows):
            moved = point[rows] + offset[rows, None] * normal[rows]
            # Another contour that is near is none of its folds.
            away = np.abs(search.among(k)[0].find(moved).distance)
            out[rows] = away >= (1.0 - SLACK) * np.abs(offset[rows]) - NOTHING
    return out


def index_of(points: Floats, owner: Ints, drawn: Bools) -> Indices:
    """Vertices of one polyline after the other, -1 behind each: one for each owner, and one between wide gaps.

    Parameters
    ----------
    points : (n, 2) float64
        mm, those of one owner one after the other.
    owner : (n,) int64
    drawn : (n,) bool
    """
    rows = np.flatnonzero(drawn)
    if not len(rows):
        return np.zeros(0, dtype=np.int32)
    left_out = np.diff(rows) > 1
    far = np.hypot(*(points[rows[1:]] - points[rows[:-1]]).T) > GAP
    ends = np.flatnonzero((np.diff(owner[rows]) != 0) | (left_out & far)) + 1
    pieces = [piece for piece in np.split(rows, ends) if len(piece) > 1]
    if not pieces:
        return np.zeros(0, dtype=np.int32)
    flat = np.concatenate(pieces)
    out: Indices = np.insert(flat, np.cumsum([len(piece) for piece in pieces]), -1).astype(np.int32)
    return out
