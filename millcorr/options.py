# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options, each declared once: on the field of the noun that holds it.

From the declaration come the option of the command line, the property of FreeCAD's object and whether a panel shows it,
the check of its value, and the test of the tables in the documentation.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from typing import Any

from .errors import UsageError
from .messages import option, phrase


@dataclass(frozen=True, slots=True)
class Declared:
    """What is known of an option.

    Parameters
    ----------
    key : str
        Its name in Python.
    default : object
        A tuple for one that may be given several times.
    help : str
        What it is for, in one phrase.
    type : type
        Of its value: float, str, bool, int or Path.
    unit : str
        ``"MM"``, or another word that stands for a value.
    choices : tuple of str
        Words that it takes; empty where it takes others.
    above, least, most : float or None
        Bounds of a number, the first not itself allowed.
    group : str
        Heading under which it stands.
    methods : tuple of str
        Methods of correction that it belongs to; empty for all.
    count : int
        So many values at once.
    """

    key: str
    default: Any
    help: str
    type: type
    unit: str
    choices: tuple[str, ...]
    above: float | None
    least: float | None
    most: float | None
    group: str
    methods: tuple[str, ...]
    count: int

    @property
    def several(self) -> bool:
        """Whether it may be given several times."""
        return isinstance(self.default, tuple)

    @property
    def field(self) -> str:
        """What a property or a field of a form is called: ``dead_band`` is ``DeadBand``."""
        return field_name(self.key)

    @property
    def bounds(self) -> str:
        """What a number must be, in words."""
        if self.least is not None and self.most is not None:
            return phrase("must be from {:g} to {:g}", self.least, self.most)
        low = phrase("above {:g}", self.above) if self.above is not None else phrase("at least {:g}", self.least)
        return phrase("must be {}{}", low, "" if self.most is None else phrase(" and at most {:g}", self.most))

    def counts_with(self, method: str) -> bool:
        """Whether it belongs to a method of correction."""
        return not self.methods or method in self.methods

    def refuse(self, value: Any) -> None:
        """UsageError where a value is none of its choices or out of its bounds."""
        for word in value if self.several else (value,):
            if self.choices and word is not None and word not in self.choices:
                raise UsageError(phrase("{}: choose one of {}", option(self.key, word), ", ".join(self.choices)))
        if self.above is None and self.least is None:
            return
        for number in value if isinstance(value, Sequence) else () if value is None else (value,):
            if not self._allows(number):
                raise UsageError(option(self.key, float(number)), ": ", self.bounds)

    def _allows(self, number: float) -> bool:
        low = number > self.above if self.above is not None else number >= (self.least or 0.0)
        return low and math.isfinite(number) and number <= (math.inf if self.most is None else self.most)


PROPERTIES = {"units": "Unit", "probe_radius": "BallRadius", "measured": "Measurement"}
"""Properties of FreeCAD's objects that are called otherwise than their option: names that documents store."""


def field_name(key: str) -> str:
    """Property of an option, and field of a form: ``dead_band`` is ``DeadBand``."""
    return PROPERTIES.get(key) or key.title().replace("_", "")


def declared(
    default: Any,
    help: str,
    *,
    type: type = float,
    unit: str = "",
    choices: tuple[str, ...] = (),
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
    group: str,
    methods: tuple[str, ...] = (),
    count: int = 1,
) -> Any:
    """A field of a dataclass that is an option; parameters as of `Declared`."""
    what = {
        "help": help, "type": str if choices else type, "unit": unit, "choices": choices, "above": above,
        "least": least, "most": most, "group": group, "methods": methods, "count": count,
    }  # fmt: skip
    return field(default=default, metadata=what)


@cache
def options_of(noun: type) -> dict[str, Declared]:
    """Options that a dataclass declares on its fields, by key, in their order."""
    return {
        item.name: Declared(item.name, None if item.default is MISSING else item.default, **item.metadata)
        for item in fields(noun)
        if "help" in item.metadata
    }


def options_with(noun: type, method: str) -> Iterator[Declared]:
    """Options of a noun that belong to a method of correction and not to all of them."""
    return (one for one in options_of(noun).values() if one.methods and method in one.methods)
