# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first line of every result: use it, measure again, or look at a place."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from millcorr.messages import Message, phrase, um, xy

OPEN = 0.05
"""From this share of a contour without points on a word is said: what tags and clamps cover is less."""

MANY_OUTLIERS = 0.1
"""From this share on a word is said of outliers (`millcorr.plausibility.separated`): below it every file has them."""


def what_to_do(summary: Mapping[str, Any]) -> tuple[Message, Message]:
    """What a machinist is to do, and why.

    Parameters
    ----------
    summary : mapping
        Contents of report.json.

    Returns
    -------
    (Message, Message)
        *Look at X… Y…* where a finding was accepted or more than a tenth of the points are outliers; *measure again*
        where what does not repeat is larger than all that does, mean and form together; else *use it*.
    """
    points, outliers, largest = summary["points"], summary["outliers"], summary["correction"]
    found = points["read"] - len(points["rejected"])
    place = xy(*largest["place"])
    if summary["accepted"]:
        first = summary["accepted"][0]
        there = xy(*first["place"]) if first["place"] else place
        return phrase("look at {}", there), phrase("{} was accepted and is not resolved", first["finding"])
    if len(outliers) > MANY_OUTLIERS * max(found, 1):
        worst = max(outliers, key=lambda row: abs(row["value"] - row["expected"]))
        return (
            phrase("look at {}", xy(worst["x"], worst["y"])),
            phrase("{} of {} points are outliers, there the largest", len(outliers), found),
        )
    foreseen = summary["foreseen"]
    predicted = foreseen is not None and foreseen["combined"] is None
    systematic, random = summary["filtered"], summary["random_std"]
    if found and not predicted and random is not None and math.isfinite(random):
        repeats = math.hypot(systematic["mean"], systematic["std"])
        if random > repeats:
            return (
                phrase("measure again or average parts"),
                phrase("{} do not repeat, only {} do", um(random), um(repeats)),
            )
    if not summary["moves"]["changed"]:
        doing = phrase("nothing is to be corrected, the program stays as it is")
    elif abs(largest["largest"]) < 5e-9:
        doing = phrase("only the path's own error changes")
    elif largest["largest"] < 0.0:
        doing = phrase("the cut moves up to {} into the material, most at {}", um(-largest["largest"]), place)
    else:
        doing = phrase("the cut moves up to {} away from the part, most at {}", um(largest["largest"]), place)
    if summary["unmeasured"] > OPEN:
        doing = phrase("{}; {:.0f} % of the contour rests on no points", doing, 100 * summary["unmeasured"])
    if predicted:
        return phrase("use it, and measure the first part"), phrase("{}, by the model alone", doing)
    if summary["warnings"]:
        return phrase("use it if what the warnings ask is answered"), doing
    return phrase("use it"), doing
