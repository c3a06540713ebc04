# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predicted deviations of a wall at several heights, as if they were measured there.

Where the real path puts the surface, plus what the bent tool leaves at each height; at foot points of the nominal, one
level a height, so that everything made for measured deviations takes them.
"""

from __future__ import annotations

import numpy as np
import shapely

from millcorr.arrays import Bools, Floats
from millcorr.comparison.deviation import REACH, Deviation, deviations
from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.readers.measurement import Measurement

from .height_error import HeightError

CUT_AGAIN = 2e-4
"""A place of the wall that another part of the path comes nearer to than the radius less this, in mm, is not left."""


def predicted_deviation(error: HeightError, nominal: Profile, *, spacing: float = 0.1) -> Deviation:
    """Deviation from the nominal of the wall that a bent tool leaves.

    Parameters
    ----------
    error : HeightError
    nominal : Profile
    spacing : float
        Least distance of the points along the path in mm.

    Returns
    -------
    Deviation
        Rows by height, then along the path. Places that the path cuts away again, corners and hollows that the cutter
        does not reach are left out.

    Raises
    ------
    UsageError
        If the spacing is not positive, or the program does not cut the nominal.
    InputError
        As `millcorr.comparison.deviation.deviations`.
    """
    if not (np.isfinite(spacing) and spacing > 0):
        raise UsageError(f"predicted deviation: a spacing of {spacing!r} mm is not positive")
    e = error.model.engagement
    wall = error.model.wall
    row = np.flatnonzero(np.isfinite(error.value).any(axis=1))
    cell = np.floor(e.s[row] / spacing)
    row = row[np.concatenate([[True], cell[1:] != cell[:-1]])]
    contact = e.position[row, :2] - e.radius * wall[row]
    row = row[left_standing(error.model.path.toolpath, contact, e.radius)]
    if not len(row):
        raise UsageError(phrase("predicted deviation: the path cuts away again all that it makes"))
    points, normals = [], []
    for k, z in enumerate(error.z):
        here = row[np.isfinite(error.value[row, k])]
        n = wall[here]
        place = e.position[here, :2] - e.radius * n + error.value[here, k, None] * n
        points.append(np.column_stack([place, np.full(len(here), z)]))
        normals.append(np.column_stack([n, np.zeros(len(here))]))
    xyz = np.concatenate(points)
    touched = Measurement(
        xyz, np.concatenate(normals), 0.0, np.arange(1, len(xyz) + 1), "predicted wall, tool deflection", ""
    )
    # What belongs to the nominal is for the path to say, not for how far the tool bends.
    reach = REACH + float(np.nanmax(np.abs(error.value)))
    return deviations(touched, nominal, reach=reach, cutter_radius=e.radius)


def left_standing(path: Toolpath, contact: Floats, radius: float) -> Bools:
    """Places of a wall that no line of a path comes nearer to than the radius.

    Parameters
    ----------
    path : Toolpath
        Lines; other moves are passed over.
    contact : (n, 2) float64
        mm.
    radius : float
        mm.

    Returns
    -------
    (n,) bool
    """
    cuts = path.kind == Kind.LINE
    lines = shapely.linestrings(np.stack([path.start[cuts, :2], path.end[cuts, :2]], axis=1))
    tree = shapely.STRtree(lines)
    near, _ = tree.query(shapely.points(contact), predicate="dwithin", distance=radius - CUT_AGAIN)
    out = np.ones(len(contact), dtype=bool)
    out[near] = False
    return out
