# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the text of an NC program makes the machine stop between its moves."""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import FormatError, UsageError
from millcorr.messages import phrase
from millcorr.nc import Program
from millcorr.nc.words import Words

from .schedule import Halts

DWELL_UNITS = {"s": 1.0, "ms": 1e-3}

_EXACT_STOP, _DWELL, _STOP_MODE = 9.0, 4.0, 61.0
_CUTTING_MODES = (62.0, 63.0, 64.0)


def halts_of(program: Program, dwell_unit: str | None = None) -> Halts:
    """Exact stops, dwells and opaque moves of a program.

    The machine stops behind the moves of a line with G9 or under G61 (up to G62, G63 or G64), at a dwell, and at
    every line with an M code: the next block waits for the machine's answer to it, whose time is not known and
    does not count.

    Parameters
    ----------
    program : Program
    dwell_unit : {"s", "ms"}, optional
        What the number of G4 P counts, and of G4 X or U without a decimal point; with one X and U are seconds on
        every control.

    Returns
    -------
    Halts
        One row a move of `program.toolpath`.

    Raises
    ------
    UsageError
        If `dwell_unit` is neither.
    FormatError
        If a dwell's time cannot be read, or its unit is not given; names the line.
    """
    if dwell_unit is not None and dwell_unit not in DWELL_UNITS:
        raise UsageError(f"the unit of dwells is s or ms, not {dwell_unit!r}")
    words = program.words()
    source = program.toolpath.source
    lines = program.run.blocks
    codes = words.of("G")
    stop_line = np.zeros(lines, np.bool_)
    stop_line[codes.line[codes.value == _EXACT_STOP]] = True
    with_m = np.zeros(lines, np.bool_)
    with_m[words.of("M").line] = True
    stop_line |= with_m | _in_stop_mode(codes, lines)
    dwell_line = _dwells(words, codes, program, dwell_unit)
    dwelling = np.zeros(lines, np.bool_)
    dwelling[codes.line[codes.value == _DWELL]] = True
    moving = np.zeros(lines, np.bool_)
    moving[source] = True
    # G9 and G61 act on the moves of their lines; M codes and dwells between moves on the move before them.
    between = dwelling | (~moving & with_m)
    owner = np.searchsorted(source, np.arange(lines), side="right") - 1
    stop = stop_line[source]
    known = between & (owner >= 0)
    stop[owner[known]] = True
    dwell = np.zeros(len(source))
    np.add.at(dwell, owner[known], dwell_line[known])
    return Halts(stop, dwell, program.opaque_moves())


def _in_stop_mode(codes: Words, lines: int) -> Bools:
    """Lines under G61."""
    modal = np.isin(codes.value, (_STOP_MODE, *_CUTTING_MODES))
    state = np.zeros(lines, np.int64)
    state[codes.line[modal]] = np.where(codes.value[modal] == _STOP_MODE, 2, 1)
    index: Ints = np.maximum.accumulate(np.where(state > 0, np.arange(lines), -1))
    out: Bools = (index >= 0) & (state[index] == 2)
    return out


def _dwells(words: Words, codes: Words, program: Program, unit: str | None) -> Floats:
    """Time in s that each line dwells."""
    out = np.zeros(program.run.blocks)
    for line in np.unique(codes.line[codes.value == _DWELL]).tolist():
        low, high = np.searchsorted(words.line, [line, line + 1])
        here = words.take(np.arange(low, high)[np.isin(words.letter[low:high], [ord(c) for c in "PXUFS"])])
        letters = [chr(letter) for letter in here.letter]
        if not letters:
            # On controls that know it this is an exact stop.
            continue
        letter, value = letters[0], float(here.value[0])
        if len(letters) > 1 or letter in "FS" or not value >= 0:
            raise FormatError(
                phrase("this dwell cannot be read: state one of P, X or U"), program.name, program.line_of(line) + 1
            )
        if letter != "P" and here.decimals[0] >= 0:
            out[line] = value
        elif unit is None and value > 0:
            raise FormatError(
                phrase(
                    "controls differ on whether {}{:g} are seconds or milliseconds: state the unit of dwells",
                    letter,
                    value,
                ),
                program.name,
                program.line_of(line) + 1,
            )
        else:
            out[line] = value * DWELL_UNITS[unit or "s"]
    return out
