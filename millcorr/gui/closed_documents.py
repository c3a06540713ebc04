# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be done when FreeCAD closes a document: windows about it end with it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD


class _Documents:
    """What FreeCAD tells of documents."""

    def __init__(self) -> None:
        self.told: list[Callable[[str], None]] = []

    def slotDeletedDocument(self, document: Any) -> None:
        """Pass the name on."""
        for tell in self.told:
            tell(document.Name)


_documents: list[_Documents] = []


def when_closed(tell: Callable[[str], None]) -> None:
    """Have a function called, from now on, with the name of each document that is closed; once, however often asked."""
    if not _documents:
        _documents.append(_Documents())
        FreeCAD.addDocumentObserver(_documents[0])
    if tell not in _documents[0].told:
        _documents[0].told.append(tell)
