# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that cut known contours, and exact measurements of them, for tests of the whole loop."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from millcorr.geometry.profile import Profile
from millcorr.readers.measurement import Measurement

RADIUS = 5.0

RECTANGLE = """G0 X-20 Y-5
G0 Z5
G1 Z-5 F100
G1 X0 Y-5 F300
G1 X105
Y55
X-5
Y-5
X0
G1 X0 Y-20
G0 Z20
"""
"""Outside of 100 x 50 with mitred corners, tangential lead-in, 5 mm beyond the seam."""

ROUNDED = """%
O0001 (PART)
N10 G21 G90 G17
N20 G0 X50. Y-30. Z5.
N30 G1 Z-5. F100.
N40 G1 X40. Y-15. F300.
N50 G3 X50. Y-5. I10. J0.
N60 G1 X90. Y-5.
N70 G3 X105. Y10. I0. J15.
N80 G1 Y55.
N90 X-5.
N100 Y0.
N110 G3 X0. Y-5. I5. J0.
N120 G1 X50.
N130 G3 X60. Y-15. I0. J-10.
N140 G1 Y-30.
N150 G0 Z20.
N160 M30
%
"""
"""Outside with one R10 corner, two mitres, one round about a sharp corner; arc leads; numbered, with points."""

POCKET = """G0 X50 Y20
G1 Z-5 F100
G1 X50 Y5 F300
G1 X5
Y45
X95
Y5
X50
G1 X50 Y20
G0 Z20
"""
"""Inside of a rectangle, clockwise, the material on the left: four inner corners."""

HELIX = """G0 X30 Y0
G0 Z1
G1 Z0 F100
G1 X20 F300
G3 X20 Y0 Z-2 I-20 J0
G3 X20 Y0 Z-4 I-20 J0
G3 X20 Y0 I-20 J0
G1 X30 Y0
G0 Z10
"""
"""Outside of a circle of radius 15 on a helix, then a full turn at depth."""

LEVELS = """G0 X-20 Y-5
G0 Z5
G1 Z-5 F100
G1 X-5 F300
X105
Y55
X-5
Y-5
G1 Z-10 F100
X105 F300
Y55
X-5
Y-5
Y-20
G0 Z20
"""
"""Two passes at different depths, from corner to corner."""

TABS = """G0 X-20 Y-5
G1 Z-5 F100
G1 X-5 F300
X40
G1 X42 Z-3
X50
X52 Z-5
X105
Y55
X-5
Y-5
Y-20
G0 Z20
"""
"""A holding tab: the cutter rises while it follows."""

EDGE = """T46M6
G15H5G0B0
S2580M3
G0X5Y53.582
G56H46G90Z100
G0Z3M51
G1Z-15F400
G1X105Y111.947F516
G0Z200M9M5
G30P5
M2
"""
"""Table 1 of petrakov-2025: one inclined edge, cutter of 16 mm."""

CONTOUR_LEFT = """G21 G90
G0 X-20 Y-20
G0 Z5
G1 Z-5 F100
G42 D1 G1 X0 Y0 F300
G1 X100
Y50
X0
Y0
G40 G1 X-20 Y-20
G0 Z20
M30
"""
"""The contour itself, the control offsets to the right (G42), anticlockwise."""

INCH_INCREMENTAL = """G20 G90
G0 X-1 Y-.2
G91
G1 Z-.2 F10
G1 X.8 F12
X4.4
Y2.4
X-4.4
Y-2.4
X-1
G0 Z.4
M30
"""
"""Inch and increments: outside of 4 x 2 inch with a cutter of 0.4 inch."""


def measured(
    nominal: Profile,
    deviation: Callable[[int, np.ndarray], np.ndarray],
    *,
    spacing: float = 1.0,
    clear: float = 0.0,
    z: float = -3.0,
    digest: str = "ab" * 32,
) -> Measurement:
    """Exact contact points of a part with a known deviation; `clear` keeps them away from corners, in mm."""
    points, lines = [], 0
    for k, total in enumerate(nominal.total):
        count = max(8, int(total / spacing))
        s = (np.arange(count) + 0.3) * total / count
        joints = np.flatnonzero(np.abs(np.nan_to_num(nominal.turn)) > 1e-3)
        for j in joints[nominal.contour[joints] == k]:
            at = nominal.begin[j] + nominal.length[j]
            away = np.abs((s - at + total / 2) % total - total / 2)
            s = s[away > clear]
        c, n = nominal.at(k, s)
        points.append(np.column_stack([c + deviation(k, s)[:, None] * n, np.full(len(s), z)]))
        lines += len(s)
    return Measurement(np.concatenate(points), None, 0.0, np.arange(1, lines + 1), "part.csv", digest)
