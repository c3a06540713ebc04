# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC probe logs, written between ``(PROBEOPEN file)`` and ``(PROBECLOSE)``.

Nine numbers a touch, X Y Z A B C U V W, in the program's unit and the active work frame, without a header. They
are where the controlled point stood: the ball is not compensated. Equal touches that follow each other are logged
once (LinuxCNC manual, G38.n).
"""

from __future__ import annotations

import re

import numpy as np

from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_columns
from .decoding import beginning
from .parts import parts_by_place, rows_of_part
from .source import MM_PER_INCH, Source, shown
from .touches import remark, slow_touches

_ROW = re.compile(rb"[ \t]*(?:[+-]?\d+\.\d+[ \t]+){8}[+-]?\d+\.\d+[ \t]*\r?")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_COLUMNS = "XYZABCUVW"
_STILL = 1e-6
"""A rotary or second axis that moves less than this, in its unit, stands still."""


def recognises(data: bytes) -> bool:
    """Whether the first two lines hold nine decimal numbers each, and nothing else."""
    lines = [line for line in beginning(data, 4096).replace(b"\r", b"\n").split(b"\n") if line.strip()]
    # The last of the lines may be cut off by the look at the beginning only.
    lines = lines[:-1] if len(data) > 4096 else lines
    return bool(lines) and all(_ROW.fullmatch(line) for line in lines[:2])


def read(source: Source) -> Measurement:
    """Ball centres of a LinuxCNC probe log.

    Parameters
    ----------
    source : Source
        Must give the radius of the ball; the unit is mm unless it says otherwise.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a row has not nine numbers, or a rotary or second linear axis moved; names the line.
    UsageError
        If the radius is missing, the caller says that the points are contact points, or several parts were logged to
        the file (PROBEOPEN begins it anew, LOGAPPEND does not) and none is chosen.
    """
    whole = decimal_columns(source.plain(), None, 9, range(9))
    if whole is None or not np.isfinite(whole[0]).all():
        _name_the_wrong(source)
        raise source.error(phrase("a number is too large, or not nine in a row"))
    values, lines_of = whole
    # What the format says of its points holds only if the file is one.
    ball = source.ball_radius(centres=True)
    others = np.ptp(values[:, 3:], axis=0)
    if (others > _STILL).any():
        axis = _COLUMNS[3 + int(others.argmax())]
        row = int(np.abs(values[:, 3 + int(others.argmax())] - values[0, 3 + int(others.argmax())]).argmax())
        raise source.error(
            phrase("axis {} moved between the touches: probe with X, Y and Z only", axis), int(lines_of[row])
        )
    away = [f"{c}{v:g}" for c, v in zip(_COLUMNS[3:], values[0, 3:], strict=True) if abs(v) > _STILL]
    notes = [phrase("other axes stood at {}", " ".join(away))] if away else []
    unit = source.unit(None)
    factor = MM_PER_INCH if unit == "inch" else 1.0
    points = values[:, :3].copy()
    del values, whole  # Nine numbers a touch, of which three count from here on.
    slow = slow_touches(points * factor)
    points, lines_of = points[slow], lines_of[slow]
    chosen = rows_of_part(source, lines_of, parts_by_place(points * factor))
    return source.measurement(
        "linuxcnc", points[chosen], lines_of[chosen], ball_radius=ball, unit=unit, notes=[*notes, *remark(slow)]
    )


def _name_the_wrong(source: Source) -> None:
    """FormatError for the first row that has not nine numbers, if there is one."""
    for number, line in source.lines():
        fields = line.split()
        if fields and len(fields) != 9:
            raise source.error(
                phrase("{} numbers where X Y Z A B C U V W make nine: the row is damaged or cut off", len(fields)),
                number,
            )
        for field in fields:
            if not _NUMBER.fullmatch(field) or not abs(float(field)) < 1e9:
                raise source.error(phrase("{} is no coordinate", shown(field)), number)
