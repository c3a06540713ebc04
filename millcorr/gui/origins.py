# SPDX-License-Identifier: LGPL-2.1-or-later
"""How unit, points, radius and frame of a measured file are known, in the user's language."""

from __future__ import annotations

from millcorr.app.text import QT_TRANSLATE_NOOP, translate
from millcorr.app.wording import worded
from millcorr.readers.measurement import Basis

_WHATS = {
    "unit": QT_TRANSLATE_NOOP("Millcorr", "unit"),
    "points": QT_TRANSLATE_NOOP("Millcorr", "points"),
    "radius": QT_TRANSLATE_NOOP("Millcorr", "radius"),
    "frame": QT_TRANSLATE_NOOP("Millcorr", "frame"),
}
_HOWS = {
    "stated": QT_TRANSLATE_NOOP("Millcorr", "stated"),
    "said": QT_TRANSLATE_NOOP("Millcorr", "said"),
    "inferred": QT_TRANSLATE_NOOP("Millcorr", "inferred"),
    "assumed": QT_TRANSLATE_NOOP("Millcorr", "assumed"),
}


def in_words(what: str, basis: Basis) -> str:
    """One line: what it is about, how it is known, and why."""
    line = f"{translate('Millcorr', _WHATS.get(what, what))}: {translate('Millcorr', _HOWS[basis.how])}"
    return f"{line}: {worded(basis.why)}" if basis.why else line
