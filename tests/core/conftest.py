# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles of property-based tests: those of hypothesis's "ci", the same in every run, with fewer examples.

How many of its first draws a generator turns down depends on constants that hypothesis takes from the project's source:
another line of code would fail a test that has nothing to do with it.
"""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, settings

from tests.core.sweeps import thin

_CI = settings.get_profile("ci")
for _name, _examples in (("quick", 25), ("brief", 10)):
    settings.register_profile(
        _name,
        _CI,
        max_examples=_examples,
        suppress_health_check=[*_CI.suppress_health_check, HealthCheck.filter_too_much],
    )


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Before what is marked thorough is left out."""
    thin(items)
