# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents opened from files, and what is found in them by label."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import FreeCAD

from millcorr.errors import FormatError, UsageError
from millcorr.messages import phrase


@contextmanager
def opened(document: Any) -> Iterator[Any]:
    """The document, opened and closed here where it is a file; FormatError if it is none."""
    if not isinstance(document, str | Path):
        yield document
        return
    path = Path(document)
    if not path.is_file():
        raise FormatError(phrase("no such file"), path)
    before = FreeCAD.ActiveDocument
    with tempfile.TemporaryDirectory() as directory:
        place = path.resolve()
        if any(doc.FileName and Path(doc.FileName).resolve() == place for doc in FreeCAD.listDocuments().values()):
            # FreeCAD would hand out the open document, with what was changed in it since; the file is meant.
            place = Path(shutil.copy(place, directory))
        try:
            here = FreeCAD.openDocument(str(place))
        except (OSError, RuntimeError, ValueError) as error:
            raise FormatError(phrase("not a FreeCAD document"), path) from error
    # FreeCAD opens an empty document in place of a broken file instead of failing.
    try:
        if not here.Objects:
            raise FormatError(phrase("the document is empty or damaged"), path)
        yield here
    finally:
        FreeCAD.closeDocument(here.Name)
        if before is not None:
            FreeCAD.setActiveDocument(before.Name)


def find_object(document: Any, name: Any) -> Any:
    """Object by label or name; UsageError if there is none or several of that label."""
    if not isinstance(name, str):
        return name
    found = [obj for obj in document.Objects if obj.Label == name] or [
        obj for obj in document.Objects if obj.Name == name
    ]
    if len(found) != 1:
        raise UsageError(phrase("the document has {} objects called {}", len(found) or phrase("no"), name))
    return found[0]
