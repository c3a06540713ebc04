# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps over many seeds or examples: the first of them in every run, the others only in exhaustive runs.

`make test` leaves out what is marked slow and takes the profile "quick" of tests/core/conftest.py.
"""

from __future__ import annotations

import math

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
