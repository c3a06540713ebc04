# SPDX-License-Identifier: LGPL-2.1-or-later
"""What resolves a finding or an error, in terms of the window: fields and values in place of options.

The core's messages name options as data (`millcorr.messages`). Whoever works in the window reads the field's name
there, and gets a button where the message proposes a value.
"""

from __future__ import annotations

from dataclasses import dataclass

from millcorr.app.text import label_of, translate
from millcorr.app.wording import value_worded
from millcorr.messages import message_of
from millcorr.options import field_name


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
        return translate("Millcorr", "Set {} to {}").format(label_of(self.field), value_worded(self.field, self.value))


def accepted_by(said: str) -> str:
    """Name of the finding that stopped a correction and can be accepted; empty where there is none."""
    return message_of(said).finding


def remedies_in(said: str) -> tuple[Remedy, ...]:
    """Changes that a message proposes, in its order, each field once; those with a value first."""
    found: dict[str, Remedy] = {}
    for option in message_of(said).options:
        field = field_name(option.key)
        if option.proposed or field not in found:
            value = option.value if option.proposed and isinstance(option.value, str | float) else None
            found[field] = Remedy(field, True if option.proposed and option.value is True else value)
    return tuple(sorted(found.values(), key=lambda remedy: remedy.value is None))


def first_field(said: str) -> str:
    """Property that a message is about first; empty where it names none."""
    return next((field_name(option.key) for option in message_of(said).options), "")


def wrong_field(said: str) -> str:
    """Property whose value a message begins with, because it is wrong in itself; empty where it begins otherwise."""
    subject = message_of(said).subject
    return field_name(subject) if subject else ""
