# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the values of a form to the options of a call by name, and to the line of Python that a macro records."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from millcorr.correction.settings import Settings
from millcorr.options import options_of
from millcorr.readers.reading import Reading

AS_FILE = "as the file says"
"""Choice of a form where the measured file itself tells."""

READING = {one.field: key for key, one in options_of(Reading).items() if one.count == 1}
"""Fields that say how a measured file is to be read, and their names in `millcorr.readers.Reading`."""


def reading_options(values: Mapping[str, Any]) -> dict[str, Any]:
    """How a measured file is to be read, from the values of a form; what it leaves to the file is left out."""
    said = {option: values.get(name) for name, option in READING.items()}
    return {option: value for option, value in said.items() if value and value != AS_FILE}


def setting_options(values: Mapping[str, Any]) -> dict[str, Any]:
    """How to correct, from the values of a form; what is as usual is left out, and what belongs to another method."""
    out = {}
    for key, one in options_of(Settings).items():
        value = values.get(one.field) if one.counts_with(values.get("Method", "mirror")) else None
        value = tuple(value) if isinstance(value, list) else value
        if value is None or value == one.default or (one.default is None and not value):
            continue
        out[key] = value
    return out


def call(function: str, *given: Any, **options: Any) -> str:
    """A call as a line of Python; options that are None are left out.

    Parameters
    ----------
    function : str
    *given, **options
        Anything whose repr is Python, or an `Expression`.
    """
    words = [repr(value) for value in given]
    words += [f"{name}={value!r}" for name, value in options.items() if value is not None]
    return f"{function}({', '.join(words)})"


class Expression:
    """A piece of Python that stands for itself in `call`."""

    def __init__(self, text: str) -> None:
        self._text = text

    def __repr__(self) -> str:
        return self._text
