# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first line of every result: use it, measure again, or look at a place."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

OPEN = 0.05
"""From this share of a contour without points on a word is said: what tags and clamps cover is less."""

MANY_OUTLIERS = 0.1
"""From this share on a word is said of outliers (`millcorr.plausibility.separated`): below it every file has them."""

_ACCEPTED = re.compile(r"(?:^|: )accepted ([a-z-]+): ")
_PLACE = re.compile(r"X-?\d+\.\d+ Y-?\d+\.\d+")


def what_to_do(summary: Mapping[str, Any]) -> str:
    """One line a machinist can act on.

    Parameters
    ----------
    summary : mapping
        Contents of report.json.

    Returns
    -------
    str
        ``look at X… Y…`` where a finding was accepted or more than a tenth of the points are outliers; ``measure
        again`` where what does not repeat is larger than all that does, mean and form together; else ``use it``.
    """
    used, outliers, largest = summary["points"]["used"], summary["outliers"], summary["correction"]
    at = "X{:.3f} Y{:.3f}".format(*largest["place"])
    for text in summary["warnings"]:
        if accepted := _ACCEPTED.search(text):
            found = _PLACE.search(text)
            return f"look at {found[0] if found else at}: {accepted[1]} was accepted and is not resolved"
    if len(outliers) > MANY_OUTLIERS * max(used, 1):
        worst = max(outliers, key=lambda row: abs(row["value"] - row["expected"]))
        where = f"X{worst['x']:.3f} Y{worst['y']:.3f}"
        return f"look at {where}: {len(outliers)} of {used} points are outliers, there the largest"
    foreseen = summary["foreseen"]
    predicted = foreseen is not None and foreseen["combined"] is None
    systematic, random = summary["filtered"], summary["random_std"]
    if used and not predicted and random is not None and math.isfinite(random):
        repeats = math.hypot(systematic["mean"], systematic["std"])
        if random > repeats:
            return (
                f"measure again or average parts: {random * 1000:.1f} um do not repeat, only {repeats * 1000:.1f} um do"
            )
    if not summary["moves"]["changed"]:
        doing = "nothing is to be corrected, the program stays as it is"
    elif abs(largest["largest"]) < 5e-9:
        doing = "only the path's own error changes"
    else:
        doing = f"the contour moves by up to {largest['largest'] * 1000:+.1f} um, most at {at}"
    if summary["unmeasured"] > OPEN:
        doing += f"; {100 * summary['unmeasured']:.0f} % of the contour rests on no points"
    if predicted:
        return f"use it, and measure the first part: {doing}, by the model alone"
    return f"use it{' if what the warnings ask is answered' if summary['warnings'] else ''}: {doing}"
