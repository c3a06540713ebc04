# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distrust before correction: signs that the measured points do not mean what they seem to mean.

Each finding has a name, a figure, and the option that resolves it. A dangerous one stops the correction; a user
who knows better accepts it by name, and the report records it.
"""

from .deviations import CutHeights, examine_deviations
from .file import examine_file, resolution
from .findings import NAMES, Finding, named, refuse_dangerous
from .parts import examine_parts, examine_program
from .points import SAMPLE, examine_points
from .separated import Gap, examine_separated, gaps, unmeasured

__all__ = [
    "NAMES",
    "SAMPLE",
    "CutHeights",
    "Finding",
    "Gap",
    "examine_deviations",
    "examine_file",
    "examine_parts",
    "examine_points",
    "examine_program",
    "examine_separated",
    "gaps",
    "named",
    "refuse_dangerous",
    "resolution",
    "unmeasured",
]
