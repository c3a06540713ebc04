# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each method of correction must be told: fields that are shown with it and count with it alone."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from millcorr.correction.settings import METHODS, WITH_SETUP, Settings
from millcorr.messages import message_of
from millcorr.options import field_name, options_of, options_with

_SETUP = "Setup"

NAMES = (_SETUP, *(one.field for one in options_of(Settings).values() if one.methods))
"""Fields that belong to some method, in the order of a form."""

FIELDS: dict[str, tuple[str, ...]] = {
    method: (*((_SETUP,) if method in WITH_SETUP else ()), *(one.field for one in options_with(Settings, method)))
    for method in METHODS
}
"""Fields of each method."""


def counts(name: str, method: str) -> bool:
    """Whether a field counts with a method: those of no method always do."""
    return name not in NAMES or name in FIELDS[method]


def show(fields: Mapping[str, Any], method: str) -> None:
    """Show the fields of a method, hide those of the others."""
    for name in NAMES:
        if name in fields:
            fields[name].set_shown(name in FIELDS[method])


def at_fault(text: str, method: str, setup: str) -> str:
    """Field of a method that a refusal is about; empty where it is about something else.

    Parameters
    ----------
    text : str
        The core's message.
    method : str
    setup : str
        Path of the setup; empty where there is none.
    """
    said = message_of(text)
    if "Setup" in FIELDS[method] and setup and Path(said.file).name == Path(setup).name:
        return "Setup"
    named = [*said.missing, *(option.key for option in said.options)]
    return next((field for field in map(field_name, named[:1]) if field in FIELDS[method]), "")
