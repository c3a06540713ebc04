# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the cutter's centre really goes: the actual motion of the axes, and on top of it what the force bends.

The axes cut corners and run arcs smaller (dat-2025, section 2; `millcorr.kinematics`). Engagement and force are those
of the commanded path at the real feed; only the place where the cutter stands is changed here, so that the surface
it leaves is the envelope of its circle on the path that it really runs.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from millcorr.kinematics import Motion
from millcorr.nurbs import NurbsCurve
from millcorr.profile import Contour, Profile
from millcorr.read_only import ReadOnlyArrays
from millcorr.toolpath import Toolpath

from .elastic_pass import ElasticPass
from .real_feed import RealFeed, course

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

WITHIN = 5e-5
"""The run path is thinned to lines within this, in mm."""

_SAME_PLACE = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class RunPath(ReadOnlyArrays):
    """Samples of the actual motion of one program or several in a row.

    Parameters
    ----------
    place : (m,) float64
        Place along the programs, counted in moves as `real_feed.course` does, not decreasing.
    centre : (m, 2) float64
        Actual place of the cutter's centre without deflection, mm.
    step : (n,) float64
        Places of the steps of the elastic pass, in the same count.
    """

    place: Floats
    centre: Floats
    step: Floats

    @staticmethod
    def of(programs: list[tuple[Toolpath, RealFeed, Motion]], elastic: ElasticPass) -> RunPath:
        """Run path of programs that an elastic pass has cut one after the other."""
        e = elastic.engagement
        places, centres, step = [], [], np.full(len(e), np.nan)
        moves = parts = 0
        for toolpath, feed, moved in programs:
            along = course(toolpath, moved)[0]
            # Where the tool waits it settles: the last sample counts.
            last = np.append(np.diff(along) > 1e-12, True)
            places.append(along[last] + moves)
            centres.append(np.column_stack([moved.x, moved.y])[last])
            mine = np.flatnonzero((e.move >= parts) & (e.move < parts + len(feed.move)))
            step[mine] = feed.place(e.move[mine] - parts, e.t[mine]) + moves
            moves, parts = moves + len(toolpath), parts + len(feed.move)
        return RunPath(np.concatenate(places), np.concatenate(centres), step)

    def at_steps(self, deflection: Floats) -> Floats:
        """Where the cutter's centre really is at the steps, with their deflections (n, 2) in mm."""
        known = np.isfinite(self.centre).all(axis=1)
        return deflection + np.column_stack(
            [np.interp(self.step, self.place[known], self.centre[known, k]) for k in (0, 1)]
        )

    def profile(self, elastic: ElasticPass, height: float) -> Profile | None:
        """Path of the cutter's centre up to a height in mm, as lines; None where nothing is run there."""
        run = elastic.runs(height)
        first = np.searchsorted(self.step, self.place - _SAME_PLACE)
        last = np.searchsorted(self.step, self.place + _SAME_PLACE, side="right") - 1
        inside = (first < len(run)) & (last >= 0) & np.isfinite(self.centre).all(axis=1)
        owner = np.full(len(self.place), -1, dtype=np.int64)
        a, b = run[first[inside]], run[last[inside]]
        owner[inside] = np.where(a == b, a, -1)
        bent = np.column_stack([np.interp(self.place, self.step, elastic.deflection[:, k]) for k in (0, 1)])
        points = self.centre + bent
        contours = []
        for rows in np.split(np.arange(len(owner)), np.flatnonzero(np.diff(owner) != 0) + 1):
            if len(rows) < 2 or owner[rows[0]] < 0:
                continue
            line = shapely.get_coordinates(shapely.simplify(shapely.linestrings(points[rows]), WITHIN))
            far = np.append(True, np.hypot(*np.diff(line, axis=0).T) > _SAME_PLACE)
            if far.sum() > 1:
                contours.append(Contour((_lines(line[far]),), False))
        return Profile.from_contours(contours) if contours else None


def _lines(points: Floats) -> NurbsCurve:
    """Lines through points as one curve."""
    knots = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    multiplicities = np.ones(len(points), dtype=np.int64)
    multiplicities[[0, -1]] = 2
    return NurbsCurve(1, points, np.ones(len(points)), knots, multiplicities)
