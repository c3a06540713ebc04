# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties of document objects as tables, added on creation and, where a version has more, on restore."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from FreeCAD import Qt

from millcorr.options import Declared

SHOWN, READ_ONLY, HIDDEN = 0, 1, 2
"""Editor modes of FreeCAD."""

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class Property:
    """One property of a document object.

    Parameters
    ----------
    kind : str
        FreeCAD's type without its prefix ``App::Property``.
    name : str
        Name; it is written into documents and stays for good.
    group : str
        Heading in the property editor.
    doc : str
        What it means, in one sentence.
    default : object
        Value on creation; for an Enumeration its allowed values, the first being the default.
    mode : int
        `SHOWN`, `READ_ONLY` or `HIDDEN`.
    zero : str
        What 0 stands for where it is no such number; a form shows that in its place.
    """

    kind: str
    name: str
    group: str
    doc: str
    default: Any = None
    mode: int = SHOWN
    zero: str = ""


_KINDS = {str: "String", bool: "Bool", int: "Integer"}
_LISTS = {str: "StringList", float: "FloatList"}


def of_option(one: Declared, group: str, doc: str, choices: tuple[str, ...] = (), zero: str = "") -> Property:
    """Property of a declared option.

    Parameters
    ----------
    one : Declared
    group, doc : str
        As of `Property`.
    choices : tuple of str, optional
        Those of its choices that the object offers.
    zero : str, optional
        As of `Property`.

    Returns
    -------
    Property
        What may be left out is 0 or empty where it is.
    """
    if one.choices:
        offered = choices or one.choices
        # The first is the default.
        return Property("Enumeration", one.field, group, doc, (one.default, *(c for c in offered if c != one.default)))
    if one.several:
        return Property(_LISTS[one.type], one.field, group, doc, list(one.default))
    kind = _KINDS.get(one.type) or ("Length" if one.unit == "MM" else "Float")
    return Property(kind, one.field, group, doc, 0.0 if one.default is None else one.default, zero=zero)


def complete(obj: Any, table: Sequence[Property]) -> list[str]:
    """Add the properties that an object does not have yet.

    Parameters
    ----------
    obj : document object
    table : sequence of Property

    Returns
    -------
    list of str
        Names of those added.
    """
    added = []
    for row in table:
        if row.name not in obj.PropertiesList:
            obj.addProperty(f"App::Property{row.kind}", row.name, row.group, row.doc)
            added.append(row.name)
            if row.default is not None:
                if row.kind == "Enumeration":
                    setattr(obj, row.name, list(row.default))
                    setattr(obj, row.name, row.default[0])
                else:
                    setattr(obj, row.name, row.default)
        elif row.kind == "Enumeration" and obj.getEnumerationsOfProperty(row.name) != list(row.default):
            # A later version offers more; what the user chose stays chosen.
            chosen = getattr(obj, row.name)
            setattr(obj, row.name, list(row.default))
            setattr(obj, row.name, chosen if chosen in row.default else row.default[0])
        obj.setEditorMode(row.name, row.mode)
    return added


def store(obj: Any, name: str, value: Any) -> None:
    """Set a property only where its value changes, so that an unchanged object stays untouched."""
    old = getattr(obj, name)
    old = getattr(old, "Value", old)
    if isinstance(old, tuple | list):
        old = list(old)
    if old != value:
        setattr(obj, name, value)
