# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repeats and what is chance: measured values along smooth stretches in, the systematic part anywhere out.

`separate` is the model; the moving average and the Gaussian filters are there because papers and drawings prescribe
them. Called by the correction and by the findings on deviations.
"""

from .filters import Filter, Filtered, filtered
from .model import Lean, LevelDifference, Observed, Separated, Stretches, interpolated, separate

__all__ = [
    "Filter",
    "Filtered",
    "Lean",
    "LevelDifference",
    "Observed",
    "Separated",
    "Stretches",
    "filtered",
    "interpolated",
    "separate",
]
