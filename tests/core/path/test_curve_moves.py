# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves in place of a displaced path: nowhere farther from it than the tolerance, however short what bends it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc
from millcorr.comparison.path_distance import PathDistance
from millcorr.nc.toolpath import Kind
from millcorr.path.curve_moves import Intervals, fit_moves
from millcorr.path.displacement import DisplacedPath
from tests.core.sweeps import examples

TOLERANCE = 4e-4

SHAPES = {"line": "G1 X100 F300", "arc": "G3 X100 Y0 I50 J60 F300"}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("kind", [Kind.LINE, Kind.ARC, Kind.CUBIC])
@settings(max_examples=examples(60), deadline=None)
@given(at=st.floats(0.001, 0.999), height=st.floats(-0.05, 0.05), width=st.floats(0.2, 2.0))
def test_a_short_hump_on_a_long_move_is_followed(
    shape: str, kind: Kind, at: float, height: float, width: float
) -> None:
    """A hump far narrower than a fifteenth of its move, where it could hide between places evenly shared."""
    toolpath = nc.parse(f"G21 G90\nG0 X0 Y0 Z0\n{SHAPES[shape]}\n").toolpath
    row = np.flatnonzero(toolpath.kind != Kind.RAPID)
    length = float(toolpath.take(row).length()[0])
    half = width / 2 / length
    node_u = np.unique(np.clip([0.0, at - half, at, at + half, 1.0], 0.0, 1.0))
    node_row = np.zeros(len(node_u), dtype=np.int64)
    ahead = toolpath.direction(row[node_row], node_u)
    size = np.where(node_u == at, height, 0.0)
    path = DisplacedPath(toolpath, row, node_row, node_u, size[:, None] * np.stack([ahead[:, 1], -ahead[:, 0]], axis=1))
    zero, one, piece = np.zeros(1), np.ones(1), np.zeros(1, dtype=np.int64)
    whole = Intervals(piece, piece, zero, one * path.length, path.at(piece, zero), path.at(piece, one), zero, zero,
                      np.array([int(kind)]), np.zeros(1, dtype=bool))  # fmt: skip
    moves, _, error = fit_moves(whole, path, TOLERANCE)
    u = np.unique(np.concatenate([node_u, np.linspace(0.0, 1.0, 400)]))
    off = PathDistance(moves, np.arange(len(moves)))(path.at(np.zeros(len(u), dtype=np.int64), u))
    # Between nodes a displaced arc is no arc any more, if only by the square of the hump's height.
    assert error <= TOLERANCE and off.max() <= 1.01 * TOLERANCE
