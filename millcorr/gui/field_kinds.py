# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which field each kind of property has in a form."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import fields, file_fields

_KINDS: dict[str, type[fields.Field]] = {
    "Length": fields.NumberField,
    "Distance": fields.NumberField,
    "Angle": fields.NumberField,
    "Feed": fields.NumberField,
    "Float": fields.NumberField,
    "Integer": fields.IntegerField,
    "Enumeration": fields.ChoiceField,
    "String": fields.TextField,
    "FloatList": fields.ListField,
    "StringList": fields.ListField,
    "Bool": fields.SwitchField,
    "Link": fields.LinkField,
    "LinkList": fields.LinksField,
    "FileIncluded": file_fields.FileField,
    "OpenFile": file_fields.FileField,
    "OpenFiles": file_fields.FilesField,
    "SaveFile": file_fields.SaveField,
    "Directory": file_fields.DirectoryField,
}


def field_for(row: Any, changed: Callable[[], None]) -> fields.Field:
    """Field of a property; `changed` is called whenever the user changes it."""
    return _KINDS[row.kind](row, changed)
