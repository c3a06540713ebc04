# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath laid on the exact parallel of a moved profile, as the pipeline does it where a drawing is given."""

from __future__ import annotations

import numpy as np

from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import Profile
from millcorr.nc.toolpath import Toolpath
from millcorr.path.displacement import displace
from millcorr.path.moves import Regeneration
from millcorr.path.passes import Commanded
from millcorr.path.reconstruction import CompensatedContour
from millcorr.path.wanted_surface import WantedSurface


def laid(
    toolpath: Toolpath, profile: Profile, correction: Correction, radius: float, output_moves: str = "keep"
) -> Regeneration:
    plain = CompensatedContour(profile, Correction.none(profile))
    commanded = Commanded.find(toolpath, plain, radius, np.ones(len(toolpath), dtype=bool))
    wanted = WantedSurface(profile, correction)
    return displace(toolpath, commanded.following, None, wanted, profile, radius, output_moves=output_moves)
