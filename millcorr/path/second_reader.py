# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second reader of a program's text, and the proof by it, for whichever family of controls it is written."""

from __future__ import annotations

import math
from collections.abc import Sequence

from millcorr.arrays import Ints

from . import klartext_proof, klartext_reading, reading
from .reading import PlainMoves
from .text_proof import TextProof, prove_text


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


def prove(
    original: bytes,
    written: bytes,
    may_change: Ints,
    *,
    header: Sequence[str] = (),
    reach: float = math.inf,
    tolerance: float = 0.001,
    beside: Sequence[tuple[str, bytes]] = (),
) -> TextProof:
    """Prove that a written program keeps everything of its original but places; see `prove_text`.

    Raises
    ------
    LimitError
        If anything else differs; names the line of the written text and what differs.
    """
    family = klartext_proof.prove if klartext_reading.plain_language(original) else prove_text
    return family(original, written, may_change, header=header, reach=reach, tolerance=tolerance, beside=beside)
