# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high the wall stands where a probe is to touch it, and at which heights a ball meets it and nothing else.

A height is that of the probe's controlled point, and whether that is the tip of the ball or its centre is a matter of
how its length was set: so the ball's lowest point lies up to a radius lower, and the touch up to a radius higher.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats

from .planning import TouchProbe
from .workpiece import Obstacles, Walls, Workpiece


@dataclass(frozen=True, slots=True)
class Meets:
    """Whether touches meet a wall, with room above and below, for a length set to the tip of the ball, or its centre.

    Parameters
    ----------
    tip, centre : (n,) bool
    """

    tip: Bools
    centre: Bools


def meets(bottom: Floats, top: Floats, z: float, probe: TouchProbe) -> Meets:
    """Whether a ball at a height meets stretches of wall, each in mm; NaN is a bound that is unknown.

    The ball stays a margin above the bottom, and touches a margin below the top.
    """
    radius, margin = probe.ball_radius, probe.margin
    over, under = np.nan_to_num(bottom, nan=-np.inf) + margin, np.nan_to_num(top, nan=np.inf) - margin
    return Meets((z >= over) & (z + radius <= under), (z - radius >= over) & (z <= under))


@dataclass(frozen=True, eq=False, slots=True)
class Standing:
    """What of a part stands while its contour is measured.

    Parameters
    ----------
    workpiece : Workpiece
    floor : float
        How deep the contour has been cut, mm: below, the stock is still there; NaN where it is not known.
    """

    workpiece: Workpiece
    floor: float = np.nan

    def walls(self, contact: Floats, normal: Floats) -> Walls:
        """Stretches of wall that are cut, at places of the contour."""
        all_of = self.workpiece.walls(contact, normal)
        bottom = np.fmax(all_of.bottom, self.floor)
        cut = bottom < all_of.top
        return Walls(all_of.place[cut], bottom[cut], all_of.top[cut])

    def meets(self, contact: Floats, normal: Floats, z: float, probe: TouchProbe) -> Meets:
        """Whether touches at places of the contour meet a wall."""
        walls = self.walls(contact, normal)
        each = meets(walls.bottom, walls.top, z, probe)
        found = [np.bincount(walls.place[yes], minlength=len(contact)) > 0 for yes in (each.tip, each.centre)]
        return Meets(*found)

    def obstacles(self, z: float, probe: TouchProbe, met: Meets) -> Obstacles:
        """What stands in the ball's way: above its lowest point, wherever that may be.

        Where no touch is right but with a length set to the tip, that is the tip.
        """
        lowest = z - probe.ball_radius if met.centre.any() else z
        return self.workpiece.above(lowest)

    def height(self, contact: Floats, normal: Floats, probe: TouchProbe) -> float | None:
        """Height in mm at which most places meet a wall, however the length was set, and farthest from its ends.

        None where no wall is high enough for that.
        """
        walls = self.walls(contact, normal)
        room = probe.ball_radius + probe.margin
        low, high = walls.bottom + room, walls.top - room
        low, high = np.sort(low[low <= high]), np.sort(high[low <= high])
        if not len(low):
            return None
        ends = np.unique(np.concatenate([low, high]))
        first, last = (ends[:-1], ends[1:]) if len(ends) > 1 else (ends, ends)
        middle = (first + last) / 2
        count = np.searchsorted(low, middle, "right") - np.searchsorted(high, middle, "left")
        best = np.lexsort((last - first, count))[-1]
        return float(middle[best])
