# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of measured points. `read` goes by the content, not by the suffix.

One module a format. Each offers ``recognises(data)`` and ``read(source)``; the last, `millcorr.readers.text`,
takes what no other module claims. Text whose columns a mapping explains goes to `millcorr.readers.mapped`.
"""

from __future__ import annotations

import math
import stat
from hashlib import sha256
from pathlib import Path
from typing import Protocol

from millcorr.errors import FormatError, UsageError
from millcorr.measurement import Measurement

from . import dmis, dprnt, grbl, linuxcnc, mapped, msr, pcdmis, qdas, qif, renishaw, text, xyzijk
from .mapping import TextMapping, load
from .point_clouds import E57, PCD, PLY
from .source import Source


class Format(Protocol):
    """What a module that reads one format offers."""

    def recognises(self, data: bytes) -> bool:
        """Whether the bytes of a file are of this format."""

    def read(self, source: Source) -> Measurement:
        """Measured points of the file.

        Raises
        ------
        FormatError
            If anything in the file cannot be trusted.
        UsageError
            If the caller contradicts the file, or does not say what the file leaves open.
        """


__all__ = ["FORMATS", "Source", "read", "recognised"]

FORMATS: dict[str, Format] = {
    "msr": msr,
    "qif": qif,
    "xyzijk": xyzijk,
    "pcdmis": pcdmis,
    "dmis": dmis,
    "linuxcnc": linuxcnc,
    "grbl": grbl,
    "dprnt": dprnt,
    "renishaw": renishaw,
    "qdas": qdas,
    "ply": PLY,
    "pcd": PCD,
    "e57": E57,
    "text": text,
}
"""Module of each format by the name that ``--format`` takes; the last one takes whatever is left."""

_POINTS = ("contact", "centre")
_UNITS = ("mm", "inch")
_SEVERAL_PARTS = ("qdas",)
"""Formats whose files can hold several measured parts."""


def read(
    path: str | Path,
    *,
    points: str | None = None,
    probe_radius: float | None = None,
    units: str | None = None,
    format: str | None = None,
    work_offset: tuple[float, float, float] | None = None,
    mapping: str | Path | TextMapping | None = None,
    part: int | None = None,
) -> Measurement:
    """Measured points from a file.

    Parameters
    ----------
    path : str or Path
    points : {"contact", "centre"}
        Whether the coordinates are contact points or centres of the probe ball. Has no default where the file
        does not say.
    probe_radius : float, optional
        Radius of the probe ball in mm, whatever the file's unit; needed for ball centres where the file does not
        say it.
    units : {"mm", "inch"}, optional
        Unit of the coordinates. By default what the file says, else mm.
    format : str, optional
        Name from `FORMATS`; by default recognised from the content.
    work_offset : tuple of 3 float, optional
        Origin of the work frame in the machine frame, in mm, for files in the machine frame.
    mapping : str, Path or TextMapping, optional
        What the columns of a text file are, or the TOML file that says it; takes the place of a format.
    part : int, optional
        Which of several measured parts in one file, counted from 1.

    Returns
    -------
    Measurement
        Points in mm, in the order of the file.

    Raises
    ------
    UsageError
        If `points` or `probe_radius` is missing and the file does not say it, an argument has no such value, or
        contradicts the file.
    FormatError
        If the file cannot be read or trusted; names the file, the line where there is one, and the remedy.
    """
    if points is not None and points not in _POINTS:
        raise UsageError(f"--points is contact or centre, not {points!r}")
    if units is not None and units not in _UNITS:
        raise UsageError(f"--units is mm or inch, not {units!r}")
    if format is not None and format not in FORMATS:
        raise UsageError(f"--format is one of {', '.join(FORMATS)}, not {format!r}")
    if probe_radius is not None and not (math.isfinite(probe_radius) and probe_radius > 0):
        raise UsageError(f"--probe-radius {probe_radius:g} is no radius in mm")
    if work_offset is not None and not all(map(math.isfinite, work_offset)):
        raise UsageError(f"--work-offset {work_offset} is no place")
    if mapping is not None and format is not None:
        raise UsageError(f"--mapping is for text that no format covers: leave --format {format} out")
    layout = load(mapping) if isinstance(mapping, (str, Path)) else mapping
    data = _content(path)
    source = Source(data, str(path), sha256(data).hexdigest(), points, probe_radius, units, work_offset, part)
    name = "mapped" if layout is not None else format or recognised(data)
    if part is not None and name not in _SEVERAL_PARTS:
        raise UsageError(f"--part {part}: {path} holds one measured part")
    if layout is not None:
        return mapped.read(source, layout)
    return FORMATS[name].read(source)


def recognised(data: bytes) -> str:
    """Name of the format of a file's bytes; the last of `FORMATS` where no other claims them."""
    return next((name for name, module in FORMATS.items() if module.recognises(data)), list(FORMATS)[-1])


def _content(path: str | Path) -> bytes:
    """Bytes of a regular file; FormatError for anything else, so that no pipe or device is waited for."""
    try:
        path = Path(path)
        if not stat.S_ISREG(path.stat().st_mode):
            raise FormatError("not a file", path)
        return path.read_bytes()
    except (OSError, ValueError) as error:
        if isinstance(error, FormatError):
            raise
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise FormatError(f"cannot be read: {reason}", path) from error
