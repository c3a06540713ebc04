# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of a measuring program, its masks and its log, after the file it is written to.

On the control two programs of one name replace each other, and so do their masks, in which the ball's radius stands.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from zlib import crc32

MOST = 16
"""Letters of a name that all controls with names take."""


class Names(NamedTuple):
    """Name of a program, or its number; and of the file that the control writes, None where it has no say in it."""

    name: str
    log: str | None


def names_of(dialect: str, stem: str) -> Names:
    """Names of a program and its log.

    Parameters
    ----------
    dialect : str
        Name from `millcorr.probing.controls.DIALECTS`.
    stem : str
        Of the file that the program is written to.

    Returns
    -------
    Names
        Letters A to Z, digits and underscores, the first a letter, 2 to 16 of them. A longer stem is cut and a sum
        of the whole of it put behind, so that ``HOUSING_FIRST_SIDE_1`` and ``HOUSING_FIRST_SIDE_2`` stay apart.
        On Fanuc and Haas the last number of the stem below 9000 (where the cycles are), else 8100.
    """
    name = re.sub(r"[^A-Z0-9_]", "_", stem.upper())
    if not re.match(r"[A-Z][A-Z0-9_]", name):
        name = f"P_{name}"
    if len(name) > MOST:
        name = f"{name[: MOST - 5]}_{crc32(stem.upper().encode('utf-8', 'backslashreplace')) & 0xFFFF:04X}"
    if dialect in ("fanuc", "haas"):
        numbers = [int(digits) for digits in re.findall(r"[0-9]+", stem)]
        return Names(str(next((n for n in reversed(numbers) if 0 < n < 9000), 8100)), None)
    if dialect == "okuma":
        return Names(name if re.fullmatch(r"[A-Z0-9]{1,4}", name) else "PRB1", f"{name}.TXT")
    if dialect == "siemens":
        # Without an ending of its own the log would be the program itself: WRITE takes both for main programs.
        return Names(name, f"{name}LOG")
    if dialect == "heidenhain":
        return Names(name, f"{name}.TXT")
    return Names(name, f"{name.lower()}.txt" if dialect.startswith("linuxcnc") else None)
