# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs: the text kept exactly as it is, and the toolpath it makes."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Ints
from millcorr.errors import FormatError, InputError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Toolpath

from .angles import straightened
from .codes import INCH
from .motion import Modal, Stretch, follow
from .order import Run, run
from .polar import placed
from .style import Style, style_of
from .subprograms import Beside, heads
from .ties import Tie, ties_of, together
from .words import Words, comments, line_starts, take_apart, tool_names


@dataclass(frozen=True, eq=False, slots=True)
class Program:
    """An NC program.

    Parameters
    ----------
    name : str
        File name, for messages.
    data : bytes
        The program exactly as it stands in the file.
    line_start : (lines + 1,) int64
        Offset in `data` of every line, and its length.
    toolpath : Toolpath
        The moves; `source` is the index of the block, from 0.
    modal : Modal
        Modal state after each block.
    style : Style
        How the program writes its words.
    opaque : tuple of Stretch
        Blocks whose motion cannot be followed or corrected, with the reason.
    run : Run
        The lines in the order in which they run, and the numbers that the program computes. A *block* is one run of
        one line; where every line runs once the index of a block is that of its line.
    ties : tuple of Tie
        Blocks whose words take their meaning from others: corners, tangent arcs, polar positions.
    led : (k,) int64
        Blocks whose way the control computes from the contour beside them: none of their moves can become several.
    beside : tuple of (str, bytes)
        Files of subprograms beside the program: their lines count on behind those of the program.
    folder : Path, optional
        Where the program stands.
    """

    name: str
    data: bytes
    line_start: Ints
    toolpath: Toolpath
    modal: Modal
    style: Style
    opaque: tuple[Stretch, ...]
    run: Run
    ties: tuple[Tie, ...]
    beside: tuple[tuple[str, bytes], ...] = ()
    folder: Path | None = None
    led: Ints = field(default_factory=lambda: np.zeros(0, np.int64))

    plain_moves: ClassVar[str] = phrase("plain G0 to G3 moves")
    """What can always be corrected, in the words of the program's language."""

    @property
    def digest(self) -> str:
        """SHA-256 of the bytes, hexadecimal."""
        return hashlib.sha256(self.data).hexdigest()

    @property
    def text(self) -> str:
        """The program as text: UTF-8 where it is, else Latin-1; `data` is what counts."""
        try:
            return self.data.decode("utf-8-sig")
        except UnicodeDecodeError:
            return self.data.decode("latin-1")

    def __len__(self) -> int:
        """Return the number of lines."""
        return len(self.line_start) - 1

    @property
    def resolution(self) -> float:
        """How far in mm the program's rounding may put a point off: half a unit in each of two axes.

        A program whose numbers happen to be rounder has no fewer than three decimals in mm, and four in inches.
        """
        inch = bool((self.modal.unit == 20).any())
        return float(np.sqrt(0.5) * (INCH if inch else 1.0) * 10.0 ** -max(self.style.decimals, 4 if inch else 3))

    def line(self, index: int) -> bytes:
        """Line by index from 0, with its line ending."""
        return self.data[self.line_start[index] : self.line_start[index + 1]]

    def block(self, index: int) -> bytes:
        """Line that a block runs, by index of the block from 0, with its line ending."""
        return self.line(self.line_of(index))

    def words(self) -> Words:
        """All words in the order in which they run; `line` is the index of the block."""
        words, statements = take_apart(self.data, self.line_start, self.name)
        beside = Beside(self.folder, self.name)
        return run(words, statements, len(self), heads(self.data, self.line_start), beside).words

    def line_of(self, block: int) -> int:
        """Index of the line that a block runs."""
        return block if self.run.line is None else int(self.run.line[block])

    def lines_of(self, blocks: Ints) -> Ints:
        """Indices of the lines that blocks run, one a block."""
        return self.run.lines(blocks)

    def written_out(self, changed: Ints) -> Ints:
        """Blocks that are written anew where some change: those too that take their meaning from these.

        Parameters
        ----------
        changed : (k,) int64
            Blocks, sorted.

        Returns
        -------
        (m,) int64
        """
        return together(changed, self.ties)

    def comments(self) -> list[tuple[int, str]]:
        """All comments: index of the line from 0, and the text without its marks."""
        return [(line, text.decode("latin-1")) for line, text in comments(self.data, self.line_start)]

    def tool(self, number: int) -> str:
        """A tool as the command line takes it: its number, or its name where the program calls it by one."""
        return tool_names(self.data).get(number, str(number))

    def opaque_moves(self) -> Bools:
        """Moves that cannot be corrected, shape (moves,)."""
        blocks = np.zeros(self.run.blocks + 1, np.int64)
        for stretch in self.opaque:
            blocks[stretch.first] += 1
            blocks[stretch.last + 1] -= 1
        out: Bools = np.cumsum(blocks)[self.toolpath.source] > 0
        return out | (self.lines_of(self.toolpath.source) >= len(self))

    def require_fits(self, toolpath: Toolpath) -> None:
        """Refuse moves that are none of this program's.

        Raises
        ------
        InputError
            If a move has no block of the program, or the blocks are not in their order.
        """
        source = toolpath.source
        if len(source) and (source[0] < 0 or source[-1] >= self.run.blocks or (np.diff(source) < 0).any()):
            raise InputError(phrase("toolpath: its lines are not those of the program, in their order"))

    def require_plain(self, moves: Bools) -> None:
        """Refuse moves that cannot be corrected.

        Parameters
        ----------
        moves : (moves,) bool
            The moves that are to be changed.

        Raises
        ------
        FormatError
            If one of them is opaque; names its line and what to do.
        """
        blocks = self.toolpath.source[moves & self.opaque_moves()]
        if not len(blocks):
            return
        block = int(blocks[0])
        line = self.line_of(block)
        if line >= len(self):
            raise FormatError(
                phrase(
                    "this move cannot be corrected: it stands in a file beside the program; put the subprogram "
                    "into the program's own file"
                ),
                *self._place_beside(line),
            )
        why = next(s for s in self.opaque if s.first <= block <= s.last)
        since = "" if why.first == block else phrase(" since line {}", self.line_of(why.first) + 1)
        raise FormatError(
            phrase("this move cannot be corrected: {}{}; write the stretch as {}", why.reason, since, self.plain_moves),
            self.name,
            line + 1,
        )

    def _place_beside(self, line: int) -> tuple[str, int]:
        """File beside the program and number of the line in it."""
        line -= len(self)
        for name, data in self.beside:
            lines = len(line_starts(data)) - 1
            if line < lines:
                return name, line + 1
            line -= lines
        return self.name, line + 1


def parse(data: bytes, name: str = "program", *, folder: Path | None = None) -> Program:
    """Read a program in ISO code from its text; see `millcorr.nc.parse`."""
    starts = line_starts(data)
    progress.step()
    words, statements = take_apart(data, starts, name)
    progress.step()
    beside = Beside(folder, name)
    ran, poles = placed(run(words, statements, len(starts) - 1, heads(data, starts), beside), name)
    ran = straightened(ran, name)
    progress.step()
    toolpath, modal, stretches = follow(ran, name)
    progress.step()
    style = style_of(data, starts, words, modal.motion, toolpath.source, ran.line)
    return Program(
        name,
        data,
        starts,
        toolpath.with_lines(ran.line),
        modal,
        style,
        stretches,
        ran.without_words(),
        poles + ties_of(ran.words, toolpath),
        tuple(beside.read),
        folder,
    )
