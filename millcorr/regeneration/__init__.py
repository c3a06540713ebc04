# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a correction to moves: the path laid anew on the exact parallel of the compensated contour."""

from .moves import BAND, OUTPUT_MOVES, Regeneration, regenerate

__all__ = ["BAND", "OUTPUT_MOVES", "Regeneration", "regenerate"]
