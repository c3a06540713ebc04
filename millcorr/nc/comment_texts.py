# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts as comments of a program: what every control shows."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

_WIDTH = 96
"""Characters of a comment; with a block number or brackets its line stays within 100."""


def comment_texts(said: Sequence[str]) -> list[str]:
    """Texts in ASCII, cut at blanks into pieces a control can show; a word that is longer stays whole.

    Examples
    --------
    >>> comment_texts(["moved by 5 \N{MICRO SIGN}m"])
    ['moved by 5 um']
    """
    out = []
    for text in said:
        plain = text.replace("\N{MICRO SIGN}", "u").replace("\N{GREEK SMALL LETTER MU}", "u")
        plain = re.sub(r"[\x00-\x1f\x7f]+", " ", plain).encode("ascii", "replace").decode()
        out += textwrap.wrap(plain, _WIDTH, break_long_words=False, break_on_hyphens=False) or [""]
    return out
