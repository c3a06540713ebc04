# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that run more than once, as subprograms at several depths do: they are corrected once, all runs alike."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import FormatError
from millcorr.messages import mm, phrase
from millcorr.nc.toolpath import Toolpath

from .program import Program


def agreed(program: Program, toolpath: Toolpath, tolerance: float) -> Toolpath:
    """The wanted moves, those of lines that run more than once alike in all their runs.

    Parameters
    ----------
    program : Program
        As read.
    toolpath : Toolpath
        The wanted moves.
    tolerance : float
        What runs of one line may differ by, mm.

    Returns
    -------
    Toolpath

    Raises
    ------
    FormatError
        If two runs of a line want different corrections; names the line and the runs.
    """
    old = program.toolpath
    blocks = np.arange(program.run.blocks + 1)
    old_first, new_first = (np.searchsorted(t.source, blocks) for t in (old, toolpath))
    moving = np.flatnonzero(np.diff(old_first) > 0)
    lines = program.lines_of(moving)
    end, centre, control = toolpath.end.copy(), toolpath.centre.copy(), toolpath.control.copy()
    order = np.argsort(lines, kind="stable")
    for runs in np.split(moving[order], np.flatnonzero(np.diff(lines[order])) + 1):
        if len(runs) < 2:
            continue
        first = slice(int(new_first[runs[0]]), int(new_first[runs[0] + 1]))
        for n, block in enumerate(runs[1:].tolist(), 1):
            rows = slice(int(new_first[block]), int(new_first[block + 1]))
            # A run may stand elsewhere, by increments or a shift.
            off = old.end[old_first[block + 1] - 1, :2] - old.end[old_first[runs[0] + 1] - 1, :2]
            off = np.nan_to_num(off)
            if (
                rows.stop - rows.start != first.stop - first.start
                or (toolpath.kind[rows] != toolpath.kind[first]).any()
            ):
                raise _disagree(program, runs, n, phrase("other moves"))
            wanted = end[first, :2] + off
            apart = float(np.nan_to_num(np.abs(end[rows, :2] - wanted)).max(initial=0.0))
            if apart > tolerance:
                raise _disagree(program, runs, n, phrase("corrections that differ by {}", mm(apart, ".4f")))
            end[rows, :2] = np.where(np.isnan(end[rows, :2]), np.nan, wanted)
            centre[rows, :2] = centre[first, :2] + off
            control[rows] = control[first] + np.tile(off, 2)
    return toolpath.with_moves(end=end, start=_joined(toolpath, end), centre=centre, control=control)


def _joined(toolpath: Toolpath, end: Floats) -> Floats:
    """Starts of moves whose ends have moved: each where the one before it ends."""
    start = toolpath.start.copy()
    moved = end[:-1] - toolpath.end[:-1]
    start[1:] += np.where(np.isfinite(moved), moved, 0.0)
    return start


def _disagree(program: Program, runs: Ints, n: int, what: str) -> FormatError:
    def run(k: int) -> str:
        move = int(np.searchsorted(program.toolpath.source, runs[k]))
        height = program.toolpath.end[move, 2]
        return phrase("run {}", k + 1) + ("" if np.isnan(height) else phrase(" at Z{:g}", height))

    line = program.line_of(int(runs[0]))
    return FormatError(
        phrase(
            "this line runs {} times, and its {} and {} want {}: write the runs out, each with lines of its own",
            len(runs),
            run(0),
            run(n),
            what,
        ),
        program.name,
        line + 1,
    )


def one_text_a_line(
    program: Program, runs: Sequence[tuple[int, int, list[bytes]]]
) -> list[tuple[int, int, list[bytes]]]:
    """Text of every line that changes, from the texts of the blocks that were written anew.

    Parameters
    ----------
    program : Program
    runs : sequence of (int, int, list of bytes)
        First and last block of each stretch that was written, and the text of each block.

    Returns
    -------
    list of (int, int, list of bytes)
        The same by line.

    Raises
    ------
    FormatError
        If two runs of a line would be written differently; names the line and the runs.
    """
    written = {first + k: text for first, _, texts in runs for k, text in enumerate(texts)}
    by_line: dict[int, list[int]] = {}
    line_of = program.run.lines(np.arange(program.run.blocks))
    touched = np.unique(line_of[list(written)])
    for block in np.flatnonzero(np.isin(line_of, touched)).tolist():
        by_line.setdefault(int(line_of[block]), []).append(block)
    out = []
    for line in sorted(by_line):
        blocks = by_line[line]
        if line >= len(program):
            continue
        texts = [written.get(block, program.line(line)) for block in blocks]
        other = next((k for k, text in enumerate(texts) if text != texts[0]), None)
        if other is not None:
            raise _disagree(program, np.array(blocks), other, phrase("other words"))
        if texts[0] != program.line(line):
            out.append((line, line, [texts[0]]))
    return out
