# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured points as they are and the nominal, as polylines: what there is to see of a correction that is refused."""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Floats
from millcorr.geometry.profile import Profile

from .correction import CROSS, NOMINAL, Lines
from .probing import joined

POINT = 0xC00000FF
"""Colour 0xRRGGBBAA of a measured point."""

MOST_POINTS = 5000
"""Of more points than this every so many are drawn: it is where they lie that counts."""

_STEPS = 400


def lines_of(nominal: Profile | None, points: Floats) -> Lines:
    """The nominal, and a cross at each point.

    Parameters
    ----------
    nominal : Profile or None
    points : (n, 3) float64
        mm; without a height at Z0.
    """
    points = np.nan_to_num(points[:: max(1, -(-len(points) // MOST_POINTS))])
    z = float(np.median(points[:, 2])) if len(points) else 0.0
    pieces = []
    if nominal is not None:
        for k, total in enumerate(nominal.total):
            on, _ = nominal.at(k, np.linspace(0.0, total, _STEPS + 1))
            pieces.append((np.column_stack([on, np.full(len(on), z)]), NOMINAL))
    for way in ((CROSS, CROSS, 0.0), (CROSS, -CROSS, 0.0)):
        pieces += [(np.stack([point - way, point + way]), POINT) for point in points]
    return joined(pieces)
