# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free ends of a straight cut that keep one programmed coordinate.

A correction moves the ends of an open contour along its normal, so that both words of a position change. A straight
cut may begin anywhere along itself: petrakov-2025 keeps X and moves Y by ``H (1 + MS) / cos alpha`` (eq. 5), which
lays the path on the same line and edits only what has to change.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from millcorr.arrays import Floats
from millcorr.comparison.theoretical_contour import SAME_POINT
from millcorr.nc.toolpath import Kind, Toolpath

from .leads import carry_along, own_work
from .moves import Regeneration

LEAST_COSINE = 0.5
"""An end slides only along a cut within 60 degrees of the axis whose coordinate it keeps."""


def keep_coordinate(toolpath: Toolpath, regeneration: Regeneration, axis: int) -> Regeneration:
    """Slide the free ends of straight cuts along themselves until a coordinate is what it was.

    Parameters
    ----------
    toolpath : Toolpath
        The program before the correction.
    regeneration : Regeneration
        The corrected path of an open contour.
    axis : {0, 1}
        Coordinate to keep, x or y.

    Returns
    -------
    Regeneration
        With leads, ramps and plunges taken along. As it was where an end is not straight, not free, or would slide
        farther than twice the correction.
    """
    moves, origin, following = regeneration.toolpath, regeneration.origin, regeneration.following
    rows = np.flatnonzero(following)
    heads = rows[np.concatenate([[True], np.diff(rows) > 1])]
    tails = rows[np.concatenate([np.diff(rows) > 1, [True]])]
    shift0, shift1 = np.zeros((len(moves), 2)), np.zeros((len(moves), 2))
    for head, tail in zip(heads.tolist(), tails.tolist(), strict=True):
        first, last = toolpath.start[origin[head], :2], toolpath.end[origin[tail], :2]
        if np.hypot(*(first - last)) < SAME_POINT:
            continue
        shift0[head] = _slide(moves, head, first[axis] - moves.start[head, axis], axis)
        shift1[tail] = _slide(moves, tail, last[axis] - moves.end[tail, axis], axis)
    if max(np.abs(shift0).max(), np.abs(shift1).max()) > 2 * regeneration.largest_shift:
        return regeneration
    carry_along(moves, following, own_work(moves, following), shift0, shift1)
    bent = (moves.kind == int(Kind.ARC)) | (moves.kind == int(Kind.CUBIC))
    if (bent & (shift0 != shift1).any(axis=1)).any():
        return regeneration
    start, end, centre = moves.start.copy(), moves.end.copy(), moves.centre.copy()
    start[:, :2] += shift0
    end[:, :2] += shift1
    centre[:, :2] += shift0
    control = moves.control + np.tile(shift0, 2)
    return replace(regeneration, toolpath=moves.with_moves(start=start, end=end, centre=centre, control=control))


def _slide(moves: Toolpath, row: int, gap: float, axis: int) -> Floats:
    """Displacement in mm along a straight move that closes a gap in one coordinate; 0 where it cannot."""
    along = moves.end[row, :2] - moves.start[row, :2]
    length = float(np.hypot(*along))
    if moves.kind[row] != int(Kind.LINE) or abs(along[axis]) < LEAST_COSINE * length or length == 0.0:
        return np.zeros(2)
    out: Floats = along * (gap / along[axis])
    return out
