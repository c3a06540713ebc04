# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second reader of a program's text, and the proof by it, for whichever family of controls it is written."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from millcorr.arrays import Ints

from . import din_proof, din_reading, klartext_proof, klartext_reading, reading
from .reading import PlainMoves, Reading
from .text_proof import TextProof, prove_text


def moves_of(data: bytes, beside: Sequence[tuple[str, bytes]] = ()) -> PlainMoves:
    r"""Moves of a program's text.

    Parameters
    ----------
    data : bytes
    beside : sequence of (str, bytes)
        Names and texts of files that hold its subprograms.

    Returns
    -------
    PlainMoves

    Examples
    --------
    >>> moves_of(b"G0 X1 Y2 Z5\nG1 Z-1 F60\nG3 X3 I1").sweep.round(4).tolist()
    [0.0, 0.0, 3.1416]
    """
    read, _ = _family(data)
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
    _, family = _family(original)
    return family(original, written, may_change, header=header, reach=reach, tolerance=tolerance, beside=beside)


def _family(data: bytes) -> tuple[Callable[..., Reading], Callable[..., TextProof]]:
    """Reader and proof of the family of controls that a text is written for."""
    if din_reading.iso_of_heidenhain(data):
        return din_reading.read, din_proof.SCRIPT.prove
    if klartext_reading.plain_language(data):
        return klartext_reading.read, klartext_proof.SCRIPT.prove
    return reading.read, prove_text
