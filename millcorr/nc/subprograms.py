# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where subprograms stand: heads of programs in one file, and files beside it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from millcorr.arrays import Ints

from .statements import Statement
from .words import HEAD, Words, line_starts, take_apart

SUFFIXES = frozenset(" .nc .cnc .txt .tap .ngc .min .sub .ssb .mpf .spf .eia .iso .prg .ncc .h .i .mzk".split(" "))
"""Suffixes of NC programs, and none."""
_NAMED = re.compile(rb"(?m)^[ \t]*([Oo][A-Za-z][A-Za-z0-9_]*|<[^>\r\n]+>)[ \t]*(?:\([^()\r\n]*\))?[ \t]*\r?$")
"""Programs with a name: Okuma's OSUB1, Fanuc's <SUB>."""


def heads(data: bytes, starts: Ints) -> dict[int, str]:
    """Lines that begin a program under a name, and the names, in capitals."""
    found = {}
    for pattern in (re.compile(rb"(?m)^" + HEAD.pattern, re.IGNORECASE), _NAMED):
        if b"%_N_" not in data.upper() and pattern is not _NAMED:
            continue
        for head in pattern.finditer(data):
            line = int(np.searchsorted(starts, head.start(), side="right")) - 1
            found[line] = head.group(1).decode("latin-1").upper()
    return found


class Beside:
    """Subprograms in files beside a program.

    Parameters
    ----------
    folder : Path or None
        Where the program stands; None: there are no files.
    name : str
        Name of the program, which does not call itself.
    """

    def __init__(self, folder: Path | None, name: str) -> None:
        self.folder = folder
        self.name = name
        self.read: list[tuple[str, bytes]] = []

    def __call__(self, name: str) -> tuple[Words, Mapping[int, Statement], int, str] | None:
        """Words, statements, number of lines and name of the file of a subprogram; None without one."""
        path = self._find(name)
        if path is None:
            return None
        try:
            data = path.read_bytes()
        except OSError:
            return None
        starts = line_starts(data)
        words, statements = take_apart(data, starts, str(path))
        self.read.append((str(path), data))
        return words, statements, len(starts) - 1, str(path)

    def _find(self, name: str) -> Path | None:
        if self.folder is None or not self.folder.is_dir():
            return None
        own = Path(self.name)
        wanted = {name, name.removeprefix("O")} if re.fullmatch(r"O\d+", name) else {name}
        for path in sorted(self.folder.iterdir()):
            stem = path.stem if path.suffix.lower() in (SUFFIXES | {own.suffix.lower()}) else path.name
            plain = re.sub(r"^([OL]?)0+(?=\d)", r"\1", stem.upper())
            if plain in wanted and path.name != own.name and path.is_file():
                return path
        return None
