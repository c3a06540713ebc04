# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where and how a touch probe measures a contour, and whether it gets there."""

from .planning import TOUCHES, Placement, ProbingPlan, Touch, TouchProbe, places, plan, touch_directions

__all__ = ["Placement", "ProbingPlan", "TOUCHES", "Touch", "TouchProbe", "places", "plan", "touch_directions"]
