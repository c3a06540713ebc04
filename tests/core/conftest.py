# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles of property-based tests: those of hypothesis's "ci", the same in every run, with fewer examples."""

from __future__ import annotations

import pytest
from hypothesis import settings

from tests.core.sweeps import thin

settings.register_profile("quick", settings.get_profile("ci"), max_examples=25)
settings.register_profile("brief", settings.get_profile("ci"), max_examples=10)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Before what is marked thorough is left out."""
    thin(items)
