# SPDX-License-Identifier: LGPL-2.1-or-later
"""Families of controls behind one interface: whose program a text is, and what reads and writes it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Toolpath

from . import heidenhain, program, writer
from .program import Program


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
        raise FormatError(phrase("cannot be read: {}", error.strerror or error), path) from error
    return parse(data, str(path), folder=Path(path).parent)


def parse(data: bytes | str, name: str = "program", *, folder: Path | None = None) -> Program:
    """Read an NC program from its text, as the control reads it that it is written for.

    Parameters
    ----------
    data : bytes or str
        The program.
    name : str
        Its name, for messages.
    folder : Path, optional
        Where subprograms are looked for that the program calls and does not hold.

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
        raise FormatError(phrase("the file is empty"), name)
    if b"\0" in data:
        raise FormatError(phrase("this is a binary file or UTF-16 text: save the program as plain text"), name)
    if heidenhain.din_program.recognises(data):
        return heidenhain.din_program.parse(data, name)
    if heidenhain.program.recognises(data):
        return heidenhain.program.parse(data, name)
    return program.parse(data, name, folder=folder)


def write(
    program: Program,
    toolpath: Toolpath,
    *,
    decimals: int | None = None,
    tolerance: float = 0.001,
    header: Sequence[str] = (),
) -> bytes:
    """Write a changed toolpath back into its program, in the language of its control.

    Parameters
    ----------
    program : Program
        The program as read.
    toolpath : Toolpath
        Changed copy of `program.toolpath`. `source` names the line of every move and does not decrease;
        further moves of a line become inserted lines behind it, without an N word.
    decimals : int, optional
        Digits behind the decimal point of changed numbers, in the program's unit. By default the program's
        own, or as many more as keep the rounding of a point in the plane within half the tolerance.
    tolerance : float
        Allowed path error in mm.
    header : sequence of str
        Comment lines inserted at the top, behind the program's opening lines.

    Returns
    -------
    bytes
        The program; the very bytes of `program` where nothing changes.

    Raises
    ------
    FormatError
        If a move has changed that cannot be rewritten; names its line.
    InputError
        If the toolpath is not continuous or does not fit the program.
    """
    if isinstance(program, heidenhain.DinProgram):
        return heidenhain.din_writer.write(program, toolpath, decimals=decimals, tolerance=tolerance, header=header)
    if isinstance(program, heidenhain.KlartextProgram):
        return heidenhain.writer.write(program, toolpath, decimals=decimals, tolerance=tolerance, header=header)
    return writer.write(program, toolpath, decimals=decimals, tolerance=tolerance, header=header)
