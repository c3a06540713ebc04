# SPDX-License-Identifier: LGPL-2.1-or-later
"""What resolves a finding or an error, in terms of the window: fields and values in place of command-line options.

The core's messages name the options that resolve them. Whoever works in the window reads the field's name
there, and gets a button where the message says the value, too.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from .text import label_of, translate

FIELDS = {
    "units": "Unit",
    "probe-radius": "BallRadius",
    "work-rotation": "WorkRotation",
    "measured": "Measurement",
    "tool": "Tools",
    "unmeasured": "UnmeasuredShare",
}
"""Properties whose option is called otherwise."""

SWITCHES = ("keep-allowance",)
"""Options that are there or not: to name one is to propose it."""

_VALUE = r"(?:contact|centre|axis|mm\b|inch|left\b|right\b|shift\b|rigid\b|auto\b|\d+(?:\.\d+)?(?:e[-+]\d+)?(?![\w=]))"
_OPTION = re.compile(rf"--([a-z]+(?:-[a-z]+)*)(?: ({_VALUE})| (?:MM|SHARE)\b)?")
_ACCEPT = re.compile(r"\s*\(if it is right as it is: --accept ([a-z-]+)\)")


@dataclass(frozen=True, slots=True)
class Remedy:
    """A change that resolves something.

    Parameters
    ----------
    field : str
        Name of the property.
    value : str, float, bool or None
        What to set; None where the user must know.
    """

    field: str
    value: str | float | bool | None = None

    def in_words(self) -> str:
        """Text of the button."""
        if self.value is None:
            return translate("Millcorr", "Go to {}").format(label_of(self.field))
        if self.value is True:
            return translate("Millcorr", "Switch on {}").format(label_of(self.field))
        value = f"{self.value:g}" if isinstance(self.value, float) else self.value
        return translate("Millcorr", "Set {} to {}").format(label_of(self.field), value)


def field_of(option: str) -> str:
    """Property of an option: ``dead-band`` is ``DeadBand``."""
    return FIELDS.get(option) or option.title().replace("-", "")


def accepted_by(message: str) -> str:
    """Name of the finding that stopped a correction and can be accepted; empty where there is none."""
    found = _ACCEPT.search(message)
    return found.group(1) if found else ""


def remedies_in(message: str) -> tuple[Remedy, ...]:
    """Changes that a message proposes, in its order, each field once; those with a value first."""
    found: dict[str, Remedy] = {}
    for option, value in _OPTION.findall(_ACCEPT.sub("", message)):
        field = field_of(option)
        if value or field not in found:
            found[field] = Remedy(field, True if option in SWITCHES else _number(value) if value else None)
    return tuple(sorted(found.values(), key=lambda remedy: remedy.value is None))


def _number(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def worded(message: str) -> str:
    """A message with fields in place of options."""

    def in_words(match: re.Match[str]) -> str:
        label = label_of(field_of(match.group(1)))
        return f"\u201c{label}\u201d" + (f" {match.group(2)}" if match.group(2) else "")

    return _OPTION.sub(in_words, _ACCEPT.sub("", message))


def first_field(message: str) -> str:
    """Property that a message is about first; empty where it names none."""
    found = _OPTION.search(message)
    return field_of(found.group(1)) if found else ""
