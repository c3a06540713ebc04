# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many cases of a sweep a run takes: few in `make test`, more in `.ci/run`, all in `make exhaustive`.

`make test` leaves out what is marked slow or thorough and takes the profile "brief" of tests/core/conftest.py;
`.ci/run` leaves out what is slow and takes the profile "quick".
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest
from hypothesis import settings


def slow(*values: object):
    """A case of a parametrised test that is left out by ``-m "not slow"``."""
    return pytest.param(*values, marks=pytest.mark.slow)


def seeds(count: int, *, quick: int) -> list:
    """Seeds 0 to count - 1, those from `quick` on slow."""
    return [seed if seed < quick else slow(seed) for seed in range(count)]


def examples(count: int) -> int:
    """So many examples of a property, fewer or more as the profile has fewer or more than the usual hundred."""
    return math.ceil(count * settings.default.max_examples / 100)


def thin(items: Sequence[pytest.Item]) -> None:
    """Of the cases of a test marked ``few(n)``, all but n of those that are not slow are thorough, evenly spread."""
    cases: dict[str, list[pytest.Item]] = {}
    for item in items:
        if item.get_closest_marker("few") and not item.get_closest_marker("slow"):
            cases.setdefault(item.nodeid.partition("[")[0], []).append(item)
    for found in cases.values():
        wanted = found[0].get_closest_marker("few").args[0]
        kept = {(2 * k + 1) * len(found) // (2 * wanted) for k in range(wanted)}
        for row, item in enumerate(found):
            if len(found) > wanted and row not in kept:
                item.add_marker(pytest.mark.thorough)
