# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deviations are drawn: how much larger, between which limits they are in tolerance, and in which colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Floats
from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.report.magnification import checked

Colours = NDArray[np.uint32]

BLUE = ((0.42, 0.71, 1.0), (0.05, 0.29, 1.0))
RED = ((1.0, 0.50, 0.30), (0.88, 0.02, 0.06))
"""Red, green, blue of deviations outside the limits, from just outside to the largest."""

WITHIN = (0.10, 0.66, 0.24)
"""Between the limits: green."""

MATERIAL_LEFT = ("blue", "red")
"""Colours that material left can have; undercut has the other one. Measuring machines' programs show it red."""

SHADES = 4
"""Shades of blue and of red."""


@dataclass(frozen=True, slots=True)
class Look:
    """How to draw.

    Parameters
    ----------
    magnification : float or None
        Deviations are drawn so many times longer than they are, as far as no contour is turned inside out by it; None
        where deviations and the part's size decide.
    lower, upper : float
        Deviations between these, in mm, are in tolerance; positive where material is left.
    material_left : {"blue", "red"}
        Colour of material left; undercut has the other one.
    """

    magnification: float | None = None
    lower: float = -0.01
    upper: float = 0.01
    material_left: str = "blue"

    def __post_init__(self) -> None:
        if self.magnification is not None:
            checked(self.magnification)
        if not -10 <= self.lower <= self.upper <= 10:
            raise UsageError(
                phrase(
                    "limits {:g} and {:g}: must be from -10 to 10 mm, the upper one above the lower",
                    self.lower,
                    self.upper,
                ),
                about="lower_limit",
            )
        if self.material_left not in MATERIAL_LEFT:
            raise UsageError(
                phrase("material left {}: must be {}", self.material_left, " or ".join(MATERIAL_LEFT)),
                about="material_left",
            )


@dataclass(frozen=True, eq=False, slots=True)
class Scale:
    """Colours of deviations.

    Parameters
    ----------
    steps : (k,) float64
        Bounds in mm between the shades, from the greatest deviation down.
    shades : (k - 1,) uint32
        0xRRGGBBAA of each; the one between the limits holds both.
    within : int
        Which of them that is.
    """

    steps: Floats
    shades: Colours
    within: int

    @staticmethod
    def of(look: Look, value: Floats) -> Scale:
        """Scale of some deviations in mm, (n,): as far on both sides of the limits as the farthest of them lies."""
        room = max(float(value.max(initial=look.upper)) - look.upper, look.lower - float(value.min(initial=look.lower)))
        if not room > 0:
            return Scale(np.array([look.upper, look.lower]), _packed(np.array([WITHIN])), 0)
        outside = room * np.arange(1, SHADES + 1) / SHADES
        excess, undercut = (BLUE, RED) if look.material_left == "blue" else (RED, BLUE)
        colours = [_shaded(*excess)[::-1], np.array([WITHIN]), _shaded(*undercut)]
        steps = np.concatenate([look.upper + outside[::-1], [look.upper, look.lower], look.lower - outside])
        return Scale(steps, _packed(np.concatenate(colours)), SHADES)

    def colours(self, value: Floats) -> Colours:
        """Colours 0xRRGGBBAA of deviations in mm, (n,); what lies beyond the scale has its last colour."""
        below = np.searchsorted(-self.steps[1:-1], -value, side="right")
        # The lower limit itself is in tolerance, as the upper one is.
        below[value == self.steps[self.within + 1]] = self.within
        return self.shades[below]


def _shaded(near: tuple[float, ...], far: tuple[float, ...]) -> Floats:
    """Shades from near to far, (SHADES, 3)."""
    share = np.linspace(0.0, 1.0, SHADES)[:, None]
    out: Floats = np.array(near) + share * (np.array(far) - np.array(near))
    return out


def _packed(rgb: Floats) -> Colours:
    parts = np.round(rgb * 255).astype(np.uint32)
    return ((parts[:, 0] << 24) | (parts[:, 1] << 16) | (parts[:, 2] << 8) | 255).astype(np.uint32)
