# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corrected programs run through LinuxCNC's own interpreter, which sees the same motions as millcorr."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc
from tests.core import rs274
from tests.core.nc.test_gcode_linuxcnc import compare
from tests.core.stages.test_pipeline import corrected

pytestmark = [
    pytest.mark.linuxcnc,
    pytest.mark.skipif(rs274.RS274 is None, reason=rs274.MISSING),
]


def ended(text: bytes) -> bytes:
    """The program with an end, which LinuxCNC insists on."""
    return text if b"M30" in text else text + b"M2\n"


@pytest.mark.few(6)
@pytest.mark.parametrize("name", ["mitres", "rounds", "pocket", "helix", "levels", "tabs", "inch"])
@pytest.mark.parametrize("moves", ["keep", "lines", "arcs"])
def test_the_interpreter_sees_the_corrected_path(name: str, moves: str) -> None:
    result, _ = corrected(name, lambda k, s: 0.01 + 0.005 * np.sin(2 * np.pi * s / 60.0), output_moves=moves)
    compare(nc.parse(result.text).toolpath, rs274.motions(ended(result.text)))


def test_splines_are_accepted() -> None:
    result, _ = corrected("mitres", lambda k, s: 0.01 + 0.005 * np.sin(2 * np.pi * s / 60.0), output_moves="nurbs")
    kinds = [m.kind for m in rs274.motions(ended(result.text))]
    assert kinds.count("spline") == int((result.regeneration.toolpath.kind == 3).sum()) > 10
