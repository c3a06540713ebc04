# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts that the user reads: translated where FreeCAD is there, as they stand where it is not (in tests)."""

from __future__ import annotations

import re

try:
    from FreeCAD import Qt
except ImportError:

    def translate(context: str, text: str) -> str:
        """The text itself."""
        return text

    def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
        """The text itself, to be found by the tool that collects texts."""
        return text
else:
    translate = Qt.translate
    QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP

__all__ = ["QT_TRANSLATE_NOOP", "label_of", "translate"]


_OTHERWISE = {"Tolerance": QT_TRANSLATE_NOOP("App::Property", "Path tolerance")}
"""What properties are called in forms whose names are too short beside others, the picture's limits of tolerance."""


def label_of(name: str) -> str:
    """What a property is called in a form: ``DeadBand`` is "Dead band"."""
    if name in _OTHERWISE:
        return translate("App::Property", _OTHERWISE[name])
    return translate("App::Property", words_of(name))


def words_of(name: str) -> str:
    """Name of a property in English words."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return words[:1] + words[1:].lower()
