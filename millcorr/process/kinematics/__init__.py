# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real feed and path of a program: what acc/dec, contour control and servos make of the command (dat-2025)."""

from .control import AxisDynamics, ContourControl, Control, arc_shrinkage
from .errors import ArcErrors, CornerErrors, PathError, arc_errors, corner_errors, path_errors
from .identification import Constant, Identification, identify, maintenance_regression
from .motion import Motion, evaluate, motion, motions
from .program import halts_of
from .schedule import Halts, Schedule, schedule
from .trace import Trace, read_trace

__all__ = [
    "ArcErrors",
    "AxisDynamics",
    "Constant",
    "ContourControl",
    "Control",
    "CornerErrors",
    "Halts",
    "Identification",
    "Motion",
    "PathError",
    "Schedule",
    "Trace",
    "arc_errors",
    "arc_shrinkage",
    "corner_errors",
    "evaluate",
    "halts_of",
    "identify",
    "maintenance_regression",
    "motion",
    "motions",
    "path_errors",
    "read_trace",
    "schedule",
]
