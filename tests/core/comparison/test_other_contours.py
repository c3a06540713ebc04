# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other walls of a program are told from passes that rough the measured one."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.readers.measurement import Measurement


def ring(over: float, x0: float = 0.0) -> str:
    """Round a block of 60 x 40 mm at `x0` with a cutter of 10 mm, `over` mm outside of its finish."""
    a, b, low, high = x0 - 5 - over, x0 + 65 + over, -5 - over, 45 + over
    return f"G0 X{a} Y{low - 3}\nG1 Z-10 F500\nG1 Y{low}\nG1 X{b}\nG1 Y{high}\nG1 X{a}\nG1 Y{low}\nG0 Z20\n"


def measured() -> Measurement:
    x, y = np.linspace(3.0, 57.0, 20), np.linspace(3.0, 37.0, 15)
    sides = [(x, 0 * x), (0 * y + 60, y), (x, 0 * x + 40), (0 * y, y)]
    where = np.vstack([np.column_stack(side) for side in sides])
    where = where + np.random.default_rng(0).normal(0.0, 0.002, where.shape)
    points = np.column_stack([where, np.full(len(where), -5.0)])
    return Measurement(points, None, 0.0, np.arange(len(points)), "part.csv", "0" * 64)


@pytest.mark.parametrize(
    ("passes", "said"),
    [
        (ring(0), False),
        (ring(0.3) + ring(0), False),
        (ring(12) + ring(6) + ring(0.3) + ring(0), False),
        (ring(0, 200) + ring(0.3) + ring(0), True),
        # Its wall is 13 mm away and faces the other way.
        (ring(0, 73) + ring(0), True),
    ],
    ids=["alone", "finish", "rings", "far", "neighbour"],
)
def test_only_other_walls_are_called_without_points(passes: str, said: bool) -> None:
    program = nc.parse(f"G21 G90 G17\nG0 Z20\n{passes}M30\n".encode(), "part.nc")
    settings = pipeline.Settings(side="right")
    done = pipeline.correct(pipeline.Request(program, 5.0, measured(), None, settings))
    expected = ("the program cuts another contour without measured points: left as it is",) if said else ()
    assert done.warnings == expected
