# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a displaced path to moves: which moves follow a contour, what replaces them, and what goes along."""

from .moves import BAND, OUTPUT_MOVES, Regeneration

__all__ = ["BAND", "OUTPUT_MOVES", "Regeneration"]
