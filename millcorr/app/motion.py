# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's Path commands to a program and back.

Path commands are written as NC text, as precise as FreeCAD saves them, and read by `millcorr.nc`, so that
one interpreter decides what a program means, wherever it comes from.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import Path

from millcorr import nc
from millcorr.errors import InputError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath

_PREAMBLE = "G17 G21 G40 G49 G80 G90 G91.1 G94"
"""What FreeCAD's commands mean when they do not say otherwise, as the first line of the text."""

_LETTERS = "XYZABCUVWIJKRQPLSTHD"
_RAPIDS = ("G0", "G00")
FEEDS = ("G1", "G01", "G2", "G02", "G3", "G03")
"""Commands that cut."""
_COMPENSATION = {Compensation.OFF: "G40", Compensation.LEFT: "G41", Compensation.RIGHT: "G42"}


def _number(value: float) -> str:
    # FreeCAD saves paths with six decimals: with the same here, saving changes nothing.
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-", "-0") else text


def line_of_command(command: Any) -> str:
    """NC line of a Path command.

    Parameters
    ----------
    command : Path.Command
        Lengths in mm, feed in mm/s.

    Returns
    -------
    str
        Without line ending; feed in mm/min. Rapids lose their feed: FreeCAD states it, no control keeps it.
    """
    name = command.Name
    if name.startswith("("):
        return name if name.endswith(")") else name + ")"
    words = [name]
    parameters = command.Parameters
    for letter in _LETTERS:
        if letter in parameters:
            words.append(letter + _number(parameters[letter]))
    if "F" in parameters and name not in _RAPIDS and parameters["F"] > 0:
        words.append("F" + _number(round(parameters["F"], 6) * 60.0))
    return " ".join(words)


def program_of_path(path: Any, name: str, compensation: Compensation = Compensation.OFF) -> nc.Program:
    """Program of a FreeCAD path.

    Parameters
    ----------
    path : Path.Path
    name : str
        What messages call it: the operation's label.
    compensation : Compensation
        Side of the line on which the control holds the cutter, for a path that is the contour itself.

    Returns
    -------
    nc.Program
        Its line k + 1, counted from 0, is command k; the first line is the preamble.

    Raises
    ------
    FormatError
        If a command cannot be followed.
    """
    preamble = _PREAMBLE.replace("G40", _COMPENSATION[compensation])
    return nc.parse("\n".join([preamble, *map(line_of_command, path.Commands)]) + "\n", name)


def path_of_toolpath(commands: Sequence[Any], before: Toolpath, after: Toolpath, marks: Sequence[str] = ()) -> Any:
    """FreeCAD path after its moves have changed.

    Parameters
    ----------
    commands : sequence of Path.Command
        The commands that `program_of_path` read.
    before : Toolpath
        Their moves.
    after : Toolpath
        The corrected moves; `source` tells which line of the program they replace.
    marks : sequence of str
        Comments that go first, without parentheses.

    Returns
    -------
    Path.Path
        Commands whose moves are the same are the very same commands.

    Raises
    ------
    InputError
        If a changed move cannot be a Path command.
    """
    out = [Path.Command(f"({mark.replace('(', '[').replace(')', ']')})") for mark in marks]
    count = len(commands) + 1
    old = np.searchsorted(before.source, np.arange(count + 1))
    new = np.searchsorted(after.source, np.arange(count + 1))
    for k in range(count):
        a, b = slice(old[k], old[k + 1]), slice(new[k], new[k + 1])
        if _same(before, a, after, b):
            if k:
                out.append(commands[k - 1])
        else:
            template = commands[k - 1] if k else None
            out.extend(_command(after, row, template) for row in range(b.start, b.stop))
    return Path.Path(out)


def _same(before: Toolpath, a: slice, after: Toolpath, b: slice) -> bool:
    """Whether the same words still describe the moves: an arc's centre is stated from its start."""
    if a.stop - a.start != b.stop - b.start:
        return False
    names = ["kind", "end", "sweep", "feed", "plane"]
    if (before.kind[a] >= Kind.ARC).any():
        names += ["start", "centre", "control"]
    return all(np.array_equal(getattr(before, n)[a], getattr(after, n)[b], equal_nan=True) for n in names)


def _command(toolpath: Toolpath, row: int, template: Any) -> Any:
    """Path command of one move; words that say nothing about motion are kept from the command it replaces."""
    kind, end = toolpath.kind[row], toolpath.end[row]
    if kind == Kind.CUBIC or (kind == Kind.ARC and toolpath.plane[row] != Plane.XY):
        raise InputError(phrase("the corrected path has a move that FreeCAD's Path cannot hold: use lines or arcs"))
    parameters = {a: float(v) for a, v in zip("XYZ", end, strict=True) if np.isfinite(v)}
    if kind == Kind.ARC:
        offset = toolpath.centre[row] - toolpath.start[row]
        parameters["I"], parameters["J"] = float(offset[0]), float(offset[1])
        name = "G3" if toolpath.sweep[row] > 0 else "G2"
        turns = int(np.ceil(abs(toolpath.sweep[row]) / (2 * np.pi) - 1e-9))
        if turns > 1:
            parameters["P"] = float(turns)
    else:
        name = "G0" if kind == Kind.RAPID else "G1"
    if kind == Kind.RAPID:
        if template is not None and template.Name in _RAPIDS and "F" in template.Parameters:
            parameters["F"] = template.Parameters["F"]
    elif np.isfinite(toolpath.feed[row]):
        parameters["F"] = float(toolpath.feed[row])
    if template is not None:
        for letter in "ABCSTHD":
            if letter in template.Parameters:
                parameters[letter] = template.Parameters[letter]
    return Path.Command(name, parameters)
