# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement of the cutter along a program, with the stock carried forward."""

from .steps import STEP, CutterPath, Engagement, GivenWay, arcs_of, engaged, engagement, load_ratio, stock_of

__all__ = ["CutterPath", "Engagement", "GivenWay", "STEP", "arcs_of", "engaged", "engagement", "load_ratio", "stock_of"]
