# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filters that separate what repeats from what is random."""

from .filters import Filter, Separation, separate

__all__ = ["Filter", "Separation", "separate"]
