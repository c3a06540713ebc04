# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dressup that is not in the document yet, or not yet as it will be: what a preview corrects.

A draft has the dressup's properties, as plain Python values, so that `correction` takes it for one. Nothing in
the document changes until its lines are run, and the lines are what a macro records.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

SETTING_GROUPS = ("Base", "Correction", "Transfer function")
"""Groups of the dressup's properties that are no results."""


class Draft:
    """Properties of an object by name.

    Parameters
    ----------
    label : str
        What messages call it.
    values : mapping of str to object
        Lengths in mm and angles in degrees as numbers, enumerations as text, links as document objects.
    """

    def __init__(self, label: str, values: Mapping[str, Any]) -> None:
        self.Label = label
        self.__dict__.update(values)

    def value(self, name: str) -> Any:
        """Value of a property."""
        return self.__dict__[name]

    def change(self, name: str, value: Any) -> bool:
        """Set a property; tells whether that changes it."""
        if self.__dict__[name] == value:
            return False
        self.__dict__[name] = value
        return True


def plain(value: Any) -> Any:
    """A property's value without FreeCAD: quantities as numbers."""
    value = getattr(value, "Value", value)
    return list(value) if isinstance(value, tuple | list) else value


def defaults(table: Sequence[Any], groups: Sequence[str] = SETTING_GROUPS) -> dict[str, Any]:
    """Values that a new object has, from its table of properties."""
    chosen = [row for row in table if row.group in groups]
    return {row.name: _default(row) for row in chosen}


def _default(row: Any) -> Any:
    if row.kind == "Enumeration":
        return row.default[0]
    return "" if row.kind == "FileIncluded" else plain(row.default)


def values_of(obj: Any, table: Sequence[Any], groups: Sequence[str] = SETTING_GROUPS) -> dict[str, Any]:
    """Values that an object has."""
    return {row.name: plain(getattr(obj, row.name)) for row in table if row.group in groups}


def in_python(value: Any) -> str:
    """A property's value as Python text; document objects by their names in the active document."""
    if hasattr(value, "TypeId"):
        return f"App.ActiveDocument.getObject({value.Name!r})"
    if isinstance(value, list):
        return "[" + ", ".join(map(in_python, value)) + "]"
    return repr(value)


def lines_to_create(draft: Draft, table: Sequence[Any]) -> list[str]:
    """Python lines that make the dressup of a draft."""
    usual = defaults(table)
    base, measurement = in_python(draft.value("Base")), in_python(draft.value("Measurement"))
    chosen = [
        f"{name}={in_python(draft.value(name))}"
        for name, value in usual.items()
        if name not in ("Base", "Measurement") and draft.value(name) != value
    ]
    return [
        "from millcorr.app import dressup",
        f"dressup.create({', '.join([base, measurement, *chosen])})",
        "App.ActiveDocument.recompute()",
    ]


def lines_to_change(draft: Draft, obj: Any, before: Mapping[str, Any], part: Any = None) -> list[str]:
    """Python lines that give a dressup the values of a draft; none where it has them.

    Parameters
    ----------
    draft : Draft
    obj : document object
    before : mapping of str to object
        What the dressup has, or will have once the part is added.
    part : document object, optional
        A newly measured part to add.
    """
    own, off = in_python(obj), {one.Name for one in before["SwitchedOff"]}
    changed = {name: value for name in before if (value := draft.value(name)) != before[name]}
    now = changed.pop("SwitchedOff", before["SwitchedOff"])
    turned = [one for one in [*before["SwitchedOff"], *now] if (one.Name in off) != (one in now)]
    lines = [f"{own}.{name} = {in_python(value)}" for name, value in changed.items()]
    if part is not None:
        chosen = [f"{name}={in_python(value)}" for name, value in changed.items()]
        lines = [f"dressup.add({', '.join([own, in_python(part), *chosen])})"]
    lines += [f"dressup.switch({own}, {in_python(one)}, {one not in now})" for one in turned]
    if any(line.startswith("dressup.") for line in lines):
        lines.insert(0, "from millcorr.app import dressup")
    return [*lines, "App.ActiveDocument.recompute()"] if lines else []
