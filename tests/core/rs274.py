# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's interpreter as an oracle: the canonical motions it makes of a program."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

RS274 = shutil.which("rs274")
MISSING = "rs274 is not on PATH (Debian package linuxcnc-uspace)"
TOOLS = 60
ROUNDING = 5e-5
"""rs274 prints four decimals, in the unit of the program."""

_CALL = re.compile(r"^\s*\d+ N\S+\s+(\w+)\((.*)\)$")


@dataclass(frozen=True)
class Motion:
    """A canonical motion, lengths in mm."""

    kind: str
    end: tuple[float, float, float] | None
    centre: tuple[float, float] | None = None
    turns: int = 0
    plane: int = 17
    rounding: float = ROUNDING


class Refused(Exception):
    """LinuxCNC does not accept the program."""


def motions(program: bytes) -> list[Motion]:
    """Motions of a program.

    Parameters
    ----------
    program : bytes

    Returns
    -------
    list of Motion
        Traverses, feeds, arcs and splines in order.

    Raises
    ------
    Refused
        With LinuxCNC's own message.
    """
    assert RS274, MISSING
    with tempfile.TemporaryDirectory() as directory:
        folder = Path(directory)
        (folder / "p.ngc").write_bytes(program)
        table = "".join(f"T{i} P{i} Z0 D0\n" for i in range(1, TOOLS))
        (folder / "tool.tbl").write_text(table)
        ran = subprocess.run(
            [RS274, "-t", "tool.tbl", "-g", "p.ngc"],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=60,
        )
    if "PROGRAM_END" not in ran.stdout:
        said = [x for x in ran.stderr.splitlines() if x and x != "executing"]
        raise Refused("; ".join(said[:2]) or ran.stdout[-200:])
    return _canon(ran.stdout)


def _canon(text: str) -> list[Motion]:
    out: list[Motion] = []
    plane, scale = 17, 1.0
    for line in text.splitlines():
        found = _CALL.match(line)
        if found is None:
            continue
        name, arguments = found.groups()
        if name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCH" in arguments else 1.0
        elif name == "SELECT_PLANE":
            plane = {"XY": 17, "XZ": 18, "YZ": 19}[arguments[-2:]]
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            x, y, zz = (float(v) * scale for v in arguments.split(",")[:3])
            kind = "rapid" if name == "STRAIGHT_TRAVERSE" else "line"
            out.append(Motion(kind, (x, y, zz), rounding=ROUNDING * scale))
        elif name == "ARC_FEED":
            v = [float(a) for a in arguments.split(",")]
            a, b, along = v[0] * scale, v[1] * scale, v[5] * scale
            end = {17: (a, b, along), 18: (b, along, a), 19: (along, a, b)}[plane]
            centre = (v[2] * scale, v[3] * scale)
            out.append(Motion("arc", end, centre, int(v[4]), plane, ROUNDING * scale))
        elif name == "NURBS_FEED":
            out.append(Motion("spline", None))
    return out
