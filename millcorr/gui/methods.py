# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each method of correction must be told: fields that are shown with it and count with it alone."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .remedies import first_field

FIELDS: dict[str, tuple[str, ...]] = {
    "mirror": ("Allowance",),
    "transfer": ("Depth", "NextDepth", "DepthAlong", "TransferFunction", "Allowance"),
    "combined": ("Setup", "Iterate", "Depth", "Allowance"),
    "predicted": ("Setup", "Iterate"),
}
"""Fields of each method."""

NAMES = ("Setup", "Iterate", "Depth", "NextDepth", "DepthAlong", "TransferFunction", "Allowance")
"""Fields that belong to some method, in the order of a form."""


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
    if "Setup" in FIELDS[method]:
        begins = (setup, Path(setup).name) if setup else ()
        if "needs --setup" in text or text.startswith(begins):
            return "Setup"
    first = "Depth" if "needs --depth" in text else first_field(text)
    return first if first in FIELDS[method] else ""
