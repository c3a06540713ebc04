# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick profile of property-based tests: those of hypothesis's "ci", the same in every run, a quarter as many."""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("quick", settings.get_profile("ci"), max_examples=25)
