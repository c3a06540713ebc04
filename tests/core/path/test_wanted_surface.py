# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface that is wanted, against closed forms."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from millcorr.geometry.correction import Correction
from millcorr.path.wanted_surface import WantedSurface
from tests.core.contours import Part, moved_sides, profile_of


@given(
    half=st.floats(0.2, 1.2),
    length=st.floats(20.0, 80.0),
    turned=st.floats(0.0, 6.3),
    begin=st.integers(0, 6),
    amount=st.floats(-0.05, 0.05),
)
def test_the_only_corner_of_a_contour_goes_to_where_its_sides_meet(
    half: float, length: float, turned: float, begin: int, amount: float
) -> None:
    """A triangle of one sharp corner and two rounded ones: one stretch, whose two ends meet there."""
    tips = np.array([0.0, length * np.exp(-1j * half), length * np.exp(1j * half)]) * np.exp(1j * turned)
    triangle = Part(np.column_stack([tips.real, tips.imag]), (0.0, 0.05 * length, 0.05 * length))
    sides = [piece for e in triangle.elements for piece in (e.split(0.4) if e.centre is None else (e,))]
    begin %= len(sides)
    profile = profile_of(sides[begin:] + sides[:begin])
    surface = WantedSurface(profile, Correction.even(profile, amount))
    found = surface.corner_shift(np.zeros((1, 2)))[0]
    np.testing.assert_allclose(found, moved_sides(triangle.vertices, amount)[0], rtol=0, atol=1e-7)
