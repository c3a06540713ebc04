# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first line of a result says what to do."""

from __future__ import annotations

from typing import Any

import pytest

from millcorr.report.verdict import what_to_do


def summary(**changed: Any) -> dict[str, Any]:
    out: dict[str, Any] = {
        "points": {"read": 21, "used": 20, "left_out": 1, "rejected": [{"index": 5, "reason": "far"}]},
        "outliers": [],
        "unmeasured": 0.0,
        "correction": {"largest": -0.0123, "place": [1.5, -2.0]},
        "accepted": [],
        "warnings": [],
        "foreseen": None,
        "filtered": {"mean": 0.003, "std": 0.004},
        "random_std": 0.002,
        "moves": {"changed": 7},
    }
    return out | changed


def outliers(count: int) -> list[dict[str, float]]:
    return [{"x": float(k), "y": 0.5, "z": 0.0, "value": 0.01 * k, "expected": 0.0} for k in range(count)]


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ({}, "use it: the cut moves up to 12.3 um into the material, most at X1.500 Y-2.000"),
        ({"moves": {"changed": 0}}, "use it: nothing is to be corrected, the program stays as it is"),
        (
            {"correction": {"largest": 0.0004, "place": [1.5, -2.0]}},
            "use it: the cut moves up to 0.4 um away from the part, most at X1.500 Y-2.000",
        ),
        ({"unmeasured": 0.04}, "use it: the cut moves up to 12.3 um into the material, most at X1.500 Y-2.000"),
        (
            {"unmeasured": 0.32},
            "use it: the cut moves up to 12.3 um into the material, most at X1.500 Y-2.000; 32 % of the contour "
            "rests on no points",
        ),
        ({"warnings": ["the wall leans"]}, "use it if what the warnings ask is answered: the cut moves"),
        ({"outliers": outliers(2)}, "use it: "),
        ({"outliers": outliers(3)}, "look at X2.000 Y0.500: 3 of 20 points are outliers, there the largest"),
        # Mean and form together are 5 um.
        ({"random_std": 0.0049}, "use it: "),
        ({"random_std": 0.0051}, "measure again or average parts: 5.1 um do not repeat, only 5.0 um do"),
        ({"random_std": float("nan")}, "use it: "),
        (
            {"accepted": [{"finding": "unmeasured", "place": [3.0, 4.5]}, {"finding": "scale", "place": None}]},
            "look at X3.000 Y4.500: unmeasured was accepted and is not resolved",
        ),
        (
            {"accepted": [{"finding": "scale", "place": None}]},
            "look at X1.500 Y-2.000: scale was accepted and is not resolved",
        ),
        ({"foreseen": {"combined": None}, "random_std": 1.0}, "use it, and measure the first part: the cut moves"),
    ],
)
def test_what_to_do(changed: dict[str, Any], expected: str) -> None:
    said = ": ".join(what_to_do(summary(**changed)))
    assert said.startswith(expected) and ("rests on no points" in said) == ("rests on no points" in expected)
