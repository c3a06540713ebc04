# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs: the text kept exactly as it is, and the toolpath it makes."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from millcorr.errors import FormatError
from millcorr.toolpath import Bools, Ints, Toolpath

from .codes import INCH
from .motion import Modal, Stretch, follow
from .style import Style, style_of
from .words import comments, line_starts, take_apart, tool_names


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
        The moves; `source` is the index of the line, from 0.
    modal : Modal
        Modal state after each line.
    style : Style
        How the program writes its words.
    opaque : tuple of Stretch
        Lines whose motion cannot be followed or corrected, with the reason.
    """

    name: str
    data: bytes
    line_start: Ints
    toolpath: Toolpath
    modal: Modal
    style: Style
    opaque: tuple[Stretch, ...]

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

    def comments(self) -> list[tuple[int, str]]:
        """All comments: index of the line from 0, and the text without its marks."""
        return [(line, text.decode("latin-1")) for line, text in comments(self.data, self.line_start)]

    def tool(self, number: int) -> str:
        """A tool as the command line takes it: its number, or its name where the program calls it by one."""
        return tool_names(self.data).get(number, str(number))

    def opaque_moves(self) -> Bools:
        """Moves that cannot be corrected, shape (moves,)."""
        lines = np.zeros(len(self) + 1, np.int64)
        for stretch in self.opaque:
            lines[stretch.first] += 1
            lines[stretch.last + 1] -= 1
        out: Bools = np.cumsum(lines)[self.toolpath.source] > 0
        return out

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
        lines = self.toolpath.source[moves & self.opaque_moves()]
        if not len(lines):
            return
        line = int(lines[0])
        why = next(s for s in self.opaque if s.first <= line <= s.last)
        since = "" if why.first == line else f" since line {why.first + 1}"
        raise FormatError(
            f"this move cannot be corrected: {why.reason}{since}; write the stretch as plain G0 to G3 moves",
            self.name,
            line + 1,
        )


def read(path: str | Path) -> Program:
    """Read an NC program from a file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    Program

    Raises
    ------
    FormatError
        If the file cannot be read or is not an NC program that can be followed.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise FormatError(f"cannot be read: {error.strerror or error}", path) from error
    return parse(data, str(path))


def parse(data: bytes | str, name: str = "program") -> Program:
    """Read an NC program from its text.

    Parameters
    ----------
    data : bytes or str
        The program.
    name : str
        Its name, for messages.

    Returns
    -------
    Program

    Raises
    ------
    FormatError
        If a word is malformed, an arc is impossible, or the data is no text.
    """
    if isinstance(data, str):
        data = data.encode("utf-8", "surrogatepass")
    if not data.strip():
        raise FormatError("the file is empty", name)
    if b"\0" in data:
        raise FormatError("this is a binary file or UTF-16 text: save the program as plain text", name)
    starts = line_starts(data)
    words, odd = take_apart(data, starts, name)
    toolpath, modal, stretches = follow(words, odd, len(starts) - 1, name)
    style = style_of(data, starts, words, modal.motion, toolpath.source)
    return Program(name, data, starts, toolpath, modal, style, stretches)
