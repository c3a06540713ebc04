# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second reader of a program's text, for whichever family of controls it is written."""

from __future__ import annotations

from collections.abc import Sequence

from . import klartext_reading, reading
from .reading import PlainMoves


def moves_of(data: bytes, beside: Sequence[tuple[str, bytes]] = ()) -> PlainMoves:
    """Moves of a program's text.

    Parameters
    ----------
    data : bytes
    beside : sequence of (str, bytes)
        Names and texts of files that hold its subprograms.

    Returns
    -------
    PlainMoves
    """
    read = klartext_reading.read if klartext_reading.plain_language(data) else reading.read
    return read(data, beside).moves
