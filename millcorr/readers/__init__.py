# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of measured points. `read` goes by the content, not by the suffix.

One module a format. Each offers ``recognises(data)`` and ``read(data, name, ...)``; so far only
`millcorr.readers.text`, which takes what no other module claims.
"""

from __future__ import annotations

import math
import stat
from hashlib import sha256
from pathlib import Path
from typing import Protocol

from millcorr.errors import FormatError, UsageError
from millcorr.measurement import Measurement

from . import text


class Format(Protocol):
    """What a module that reads one format offers."""

    def recognises(self, data: bytes) -> bool:
        """Whether the bytes of a file are of this format."""

    def read(
        self, data: bytes, name: str, *, digest: str, ball_radius: float, units: str | None
    ) -> Measurement:
        """Measured points, as `millcorr.readers.text.read` does."""


__all__ = ["FORMATS", "read"]

FORMATS: dict[str, Format] = {"text": text}
"""Module of each format by the name that ``--format`` takes; the last one takes whatever is left."""

_POINTS = ("contact", "centre")
_UNITS = ("mm", "inch")


def read(
    path: str | Path,
    *,
    points: str | None = None,
    probe_radius: float | None = None,
    units: str | None = None,
    format: str | None = None,
) -> Measurement:
    """Measured points from a file.

    Parameters
    ----------
    path : str or Path
    points : {"contact", "centre"}
        Whether the coordinates are contact points or centres of the probe ball. Has no default where the file
        does not say.
    probe_radius : float, optional
        Radius of the probe ball in mm, whatever the file's unit; needed for ball centres.
    units : {"mm", "inch"}, optional
        Unit of the coordinates. By default what the file's header says, else mm.
    format : str, optional
        Name from `FORMATS`; by default recognised from the content.

    Returns
    -------
    Measurement
        Points in mm, in the order of the file.

    Raises
    ------
    UsageError
        If `points` is missing, ball centres come without their radius, an argument has no such value, or
        `units` contradicts the header.
    FormatError
        If the file cannot be read or trusted; names the file, the line where there is one, and the remedy.
    """
    if points is None:
        raise UsageError(
            "say --points contact or --points centre: the file does not say whether its coordinates are "
            "contact points or centres of the probe ball"
        )
    if points not in _POINTS:
        raise UsageError(f"--points is contact or centre, not {points!r}")
    if units is not None and units not in _UNITS:
        raise UsageError(f"--units is mm or inch, not {units!r}")
    if format is not None and format not in FORMATS:
        raise UsageError(f"--format is one of {', '.join(FORMATS)}, not {format!r}")
    if probe_radius is not None and not (math.isfinite(probe_radius) and probe_radius > 0):
        raise UsageError(f"--probe-radius {probe_radius:g} is no radius in mm")
    if points == "centre" and probe_radius is None:
        raise UsageError("--points centre needs --probe-radius MM, the radius of the probe ball")
    data = _content(path)
    name = format or next((n for n, m in FORMATS.items() if m.recognises(data)), list(FORMATS)[-1])
    radius = float(probe_radius) if points == "centre" and probe_radius is not None else 0.0
    return FORMATS[name].read(
        data, str(path), digest=sha256(data).hexdigest(), ball_radius=radius, units=units
    )


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
