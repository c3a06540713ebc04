# SPDX-License-Identifier: LGPL-2.1-or-later
"""Room of a probe at measuring height: what the nominal, the fillets of the cutter and the model leave free."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats
from millcorr.geometry.footpoint import FootPointSearch

from .workpiece import Obstacles


@dataclass(frozen=True, eq=False, slots=True)
class Space:
    """What a ball keeps clear of.

    Parameters
    ----------
    search : FootPointSearch
        On the nominal.
    cutter_radius : float
        What a cutter of this radius in mm leaves in inner corners is kept clear of as well; 0: it is not known.
    obstacles : Obstacles, optional
        What of the model stands at that height and above.
    """

    search: FootPointSearch
    cutter_radius: float = 0.0
    obstacles: Obstacles | None = None

    def distances(self, points: Floats) -> tuple[Floats, Floats]:
        """Distance in mm of points from the nominal, and from whatever is nearest; (n,) each."""
        own = self.search.find(points).distance
        nearest = np.minimum(own, into_fillets(self.search, points, self.cutter_radius))
        if self.obstacles is not None:
            nearest = np.minimum(nearest, self.obstacles.distance(points))
        return own, nearest


def into_fillets(search: FootPointSearch, points: Floats, cutter_radius: float) -> Floats:
    """Distance of points from what a cutter leaves beside the nominal, mm; a lower bound, inf where it is no matter.

    A cutter leaves its fillet in inner corners. A disc about a point is free of it if some place of the cutter that
    does not touch the nominal covers the disc; the place is looked for by pushing the cutter off the nearest wall.
    (A disc larger than the cutter that is free of the nominal is made of such places.)
    """
    if cutter_radius <= 0:
        return np.full(len(points), np.inf)
    own = search.find(points).distance
    rows = np.flatnonzero(own < cutter_radius)
    out = np.full(len(points), np.inf)
    # Rows whose place still touches the nominal; beside a plain wall one push is enough.
    place, pending = points[rows].copy(), np.arange(len(rows))
    for _ in range(12):
        feet = search.find(place[pending])
        lacking = cutter_radius - feet.distance
        pending, lacking, normal = pending[lacking > 1e-9], lacking[lacking > 1e-9], feet.normal[lacking > 1e-9]
        if not len(pending):
            break
        place[pending] += lacking[:, None] * normal
    covered = cutter_radius - np.hypot(*(place - points[rows]).T)
    if len(pending):
        covered[pending[search.find(place[pending]).distance < cutter_radius - 1e-6]] = -np.inf
    out[rows] = covered
    return out
