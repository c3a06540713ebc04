# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nouns made of arrays: frozen dataclasses whose arrays nobody writes to either."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np


@dataclass(frozen=True, eq=False, slots=True)
class ReadOnlyArrays:
    """Base of a frozen dataclass: every array among its fields is made read-only, not copied."""

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if isinstance(value, np.ndarray):
                value.flags.writeable = False
