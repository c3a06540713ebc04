# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tilt of the tool as A and B words in the program, for machines that say they have such axes.

The tool turns on the move before a wall, never along it. Only words are inserted; every other character stays.
"""

from __future__ import annotations

import math
import re

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import RefusedError
from millcorr.nc import Program
from millcorr.nc.toolpath import Kind
from millcorr.process.setup_file import Tilt

from .height_error import HeightError
from .tilt import Remedy

_COMMENT = re.compile(r"[(;]|\r?\n|\r")
_ROTARY = re.compile(r"[ABC]\s*[-+=\d.#\[]", re.IGNORECASE)


def words(axes: Tilt, normal: Floats, lean: float) -> dict[str, float]:
    """Angles in degrees that lean the tool's upper end along a normal.

    Parameters
    ----------
    axes : Tilt
    normal : (2,) float64
        Unit normal out of the part.
    lean : float
        rad, positive out of the part.

    Returns
    -------
    dict
        Of the axes that the machine has, rounded.

    Raises
    ------
    RefusedError
        If the machine lacks the axis, or its limit is exceeded.
    """
    x, y = math.sin(lean) * float(normal[0]), math.sin(lean) * float(normal[1])
    z = math.cos(lean)
    # Tool axis (x, y, z): first the carrying axis turns it, so the carried one is undone last.
    if axes.order.startswith("A"):
        a, b = math.atan2(-y, z), math.asin(x)
    else:
        a, b = math.asin(-y), math.atan2(x, z)
    out = {}
    for letter, angle, sign in (("A", a, axes.a_sign), ("B", b, axes.b_sign)):
        degrees = round(sign * math.degrees(angle), axes.decimals) + 0.0
        if letter in axes.order:
            out[letter] = degrees
        elif degrees != 0.0:
            raise RefusedError(
                f"tilt: a wall with the normal ({normal[0]:.3f}, {normal[1]:.3f}) needs {letter}{degrees:g}, and "
                f"the machine has no axis {letter}: nothing is written"
            )
        if abs(degrees) > axes.limit_deg:
            raise RefusedError(
                f"tilt: {letter}{degrees:g} is beyond [tilt] limit_deg {axes.limit_deg:g}: nothing is written"
            )
    return out


def tilted(program: Program, error: HeightError, remedy: Remedy, axes: Tilt | None) -> bytes:
    """Program with the words that tilt the tool before every wall, and stand it upright behind.

    The shift of the contour is not in it: it is a correction like any other (`tilt.mean_shift`), and comes first;
    `remedy` and `error` are those of the shifted program's moves.

    Parameters
    ----------
    program : Program
        Of straight walls, each with a straight or rapid move before it.
    error : HeightError
        Of this program.
    remedy : Remedy
    axes : Tilt or None

    Returns
    -------
    bytes
        The program; only words have been inserted.

    Raises
    ------
    RefusedError
        If the machine has no `[tilt]` table, the control does not keep the tip, a wall is made by an arc or a spline,
        no move comes before a wall, the machine lacks an axis, or a line has rotary words already.
    FormatError
        If a line to be changed cannot be, as `Program.require_plain`.
    """
    if axes is None:
        raise RefusedError(
            "tilt: the setup has no [tilt] table that names the machine's A and B axes: the angles are reported only, "
            "and nothing is written"
        )
    if not axes.tool_centre_point:
        raise RefusedError(
            "tilt: turning A or B swings the tip away unless the control keeps it: run with tool centre point control "
            "and say [tilt] tool_centre_point = true"
        )
    at = _angles(program, error, remedy, axes)
    kind, line = program.toolpath.kind, program.toolpath.line(np.arange(len(program.toolpath)))
    upright = dict.fromkeys(axes.order, 0.0)
    now, insert, last = upright, {}, -1
    for move in range(len(kind)):
        wanted = at.get(move)
        if wanted is not None and wanted != now:
            carrier = next((k for k in range(move - 1, last, -1) if kind[k] in (Kind.RAPID, Kind.LINE)), None)
            if carrier is None or carrier in insert:
                raise RefusedError(
                    f"{program.name}: line {line[move]}: the tool has to turn before this wall, and there is no "
                    "straight or rapid move before it: lead in to each wall on its own"
                )
            insert[carrier], now = wanted, wanted
        if wanted is not None:
            last = move
        elif now != upright and last == move - 1 and not _goes_on(at, now, move, kind):
            if kind[move] not in (Kind.RAPID, Kind.LINE):
                raise RefusedError(f"{program.name}: line {line[move]}: lead out of each wall on a straight line")
            insert[move], now = upright, upright
    if now != upright:
        raise RefusedError(f"{program.name}: the program ends on a wall: retract behind it")
    return _inserted(program, insert)


def _goes_on(at: dict[int, dict[str, float]], now: dict[str, float], move: int, kind: Ints) -> bool:
    """Whether the next wall is tilted alike, and only feed moves come before it."""
    for k in range(move, len(kind)):
        if kind[k] == Kind.RAPID:
            return False
        if k in at:
            return at[k] == now
    return False


def _angles(program: Program, error: HeightError, remedy: Remedy, axes: Tilt) -> dict[int, dict[str, float]]:
    """Words of every move that makes a wall of the nominal."""
    model, toolpath = error.model, program.toolpath
    move = model.path.move[model.engagement.move]
    makes = remedy.step >= 0
    share = np.bincount(move, makes, minlength=len(toolpath)) / np.maximum(
        np.bincount(move, minlength=len(toolpath)), 1
    )
    out = {}
    for k in np.flatnonzero(share > 0.5):
        if toolpath.kind[k] != Kind.LINE:
            raise RefusedError(
                f"{program.name}: line {toolpath.line(int(k))}: a wall that bends needs the tilt to turn along it: "
                "only straight walls are tilted"
            )
        rows = np.flatnonzero(makes & (move == k))
        along = toolpath.end[k, :2] - toolpath.start[k, :2]
        normal = np.array([-along[1], along[0]]) / np.hypot(*along)
        normal = normal * np.sign(model.wall[rows].sum(axis=0) @ normal)
        row = int(np.bincount(remedy.step[rows]).argmax())
        out[int(k)] = words(axes, normal, float(remedy.lean[row]))
    return out


def _inserted(program: Program, insert: dict[int, dict[str, float]]) -> bytes:
    """Program with words at the end of the lines of moves, before their comments."""
    toolpath = program.toolpath
    stands = toolpath.line(np.arange(len(toolpath))) - 1
    changed = np.zeros(len(toolpath), dtype=bool)
    changed[list(insert)] = True
    program.require_plain(changed)
    lines = [program.line(k) for k in range(len(program))]
    for move, words in insert.items():
        number = int(stands[move])
        text = lines[number].decode("latin-1")
        end = found.start() if (found := _COMMENT.search(text)) else len(text)
        body = text[:end].rstrip()
        where = f"{program.name}: line {number + 1}"
        if (stands == number).sum() > 1 or _ROTARY.search(body):
            raise RefusedError(f"{where}: several moves or rotary words on the line: nothing is written")
        if program.modal.distance[toolpath.source[move]] == 91:
            raise RefusedError(f"{where}: G91 is in force: state absolute positions for tilted walls")
        gap = " " if " " in body else ""
        added = "".join(f"{gap}{letter}{angle:.10g}" for letter, angle in words.items())
        lines[number] = (body + added + text[len(body) :]).encode("latin-1")
    return b"".join(lines)
