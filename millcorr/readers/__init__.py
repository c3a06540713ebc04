# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of measured points. `read` goes by the content, not by the suffix.

One module a format. Each offers ``recognises(data)`` and ``read(source)``; the last, `millcorr.readers.text`,
takes what no other module claims. Text whose columns a mapping explains goes to `millcorr.readers.mapped`.
"""

from __future__ import annotations

import math
import stat
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from typing import Protocol

from millcorr import progress
from millcorr.errors import FormatError, UsageError
from millcorr.messages import message, option, phrase
from millcorr.options import options_of
from millcorr.readers.measurement import Basis, Measurement, Probe

from . import (
    calypso,
    dmis,
    dprnt,
    grbl,
    height_map,
    linuxcnc,
    mapped,
    msr,
    pcdmis,
    ptx,
    qdas,
    qif,
    renishaw,
    stl,
    text,
    workbook,
    xyzijk,
)
from .mapping import TextMapping, load
from .point_clouds import E57, PCD, PLY, X3P
from .probe_file import load as load_probe
from .reading import Reading
from .source import FARTHEST, Source
from .truncation import check_last_number
from .work_frame import laid_in_work_frame


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


__all__ = ["FORMATS", "Reading", "Source", "read", "recognised"]

FORMATS: dict[str, Format] = {
    "msr": msr,
    "qif": qif,
    "xyzijk": xyzijk,
    "pcdmis": pcdmis,
    "dmis": dmis,
    "height-map": height_map,
    "linuxcnc": linuxcnc,
    "grbl": grbl,
    "dprnt": dprnt,
    "renishaw": renishaw,
    "qdas": qdas,
    "calypso": calypso,
    "stl": stl,
    "ptx": ptx,
    "ply": PLY,
    "pcd": PCD,
    "e57": E57,
    "x3p": X3P,
    "text": text,
}
"""Module of each format by the name that ``--format`` takes; the last one takes whatever is left."""

_SEVERAL_PARTS = ("msr", "qif", "pcdmis", "grbl", "linuxcnc", "dprnt", "renishaw", "qdas", "calypso")
"""Formats whose files can hold several measured parts."""
_FRAMES = {
    "msr": Basis("stated", phrase("what G330 leads back to")),
    "qif": Basis("stated", phrase("the document's common frame")),
    "linuxcnc": Basis("stated", phrase("the work frame in force, as LinuxCNC logs it")),
    "grbl": Basis("stated", phrase("the machine's, brought to the work frame by the offset in the log")),
}
"""How the frame of the points is known, by format; that of all others is as the software exported it."""
_AS_EXPORTED = Basis("assumed", phrase("the work frame; the file does not say"))
_MACHINE_FRAME = ("grbl",)
"""Formats in the machine frame, which ask for the work offset where the file does not hold it."""


def read(
    path: str | Path,
    *,
    points: str | None = None,
    probe_radius: float | None = None,
    units: str | None = None,
    format: str | None = None,
    work_offset: tuple[float, float, float] | None = None,
    work_rotation: float | None = None,
    mapping: str | Path | TextMapping | None = None,
    part: int | None = None,
    probe: str | Path | Probe | None = None,
) -> Measurement:
    """Measured points from a file.

    Parameters
    ----------
    path : str or Path
    points : {"contact", "centre", "axis"}
        Whether the coordinates are contact points, centres of the probe ball, or centres that the control shifted
        by the ball's radius along the axis of travel. Has no default where the file does not say.
    probe_radius : float, optional
        Radius of the probe ball in mm, whatever the file's unit, or the radius by which the control shifted the
        points; needed unless points are contact points, where neither file nor `probe` say it.
    units : {"mm", "inch"}, optional
        Unit of the coordinates. By default what the file says, else mm.
    format : str, optional
        Name from `FORMATS`; by default recognised from the content.
    work_offset : tuple of 3 float, optional
        Origin of the work frame in the file's frame (the machine's, a CMM's), in mm.
    work_rotation : float, optional
        Turn of the work frame in the file's frame, degrees, positive anticlockwise, about that origin.
    mapping : str, Path or TextMapping, optional
        What the columns of a text file are, or the TOML file that says it; takes the place of a format.
    part : int, optional
        Which of several measured parts in one file, counted from 1.
    probe : str, Path or Probe, optional
        Calibration of the probe, or the TOML file that says it.

    Returns
    -------
    Measurement
        Points in mm, in the order of the file. What is still to be done with the probe's radius needs a profile:
        `millcorr.comparison.ball_radius.contact_known`.

    Raises
    ------
    UsageError
        If `points` or `probe_radius` is missing and the file does not say it, an argument has no such value, or
        contradicts the file.
    FormatError
        If the file cannot be read or trusted; names the file, the line where there is one, and the remedy.
    """
    declared = options_of(Reading)
    declared["points"].refuse(points)
    declared["units"].refuse(units)
    if format is not None and format not in FORMATS:
        raise UsageError(phrase("{} is one of {}, not {!r}", option("format"), ", ".join(FORMATS), format))
    if probe_radius is not None and not (math.isfinite(probe_radius) and probe_radius > 0):
        raise UsageError(phrase("{} is no radius in mm", option("probe_radius", probe_radius)))
    if points == "contact" and probe_radius is not None:
        raise UsageError(
            phrase(
                "{} belongs to {} or axis: contact points lie on the part already",
                option("probe_radius"),
                option("points", "centre"),
            ),
        )
    if work_offset is not None and not all(abs(value) <= FARTHEST for value in work_offset):
        raise UsageError(
            phrase("{} is no place", option("work_offset", " ".join(f"{value:g}" for value in work_offset)))
        )
    if work_rotation is not None and not math.isfinite(work_rotation):
        raise UsageError(phrase("{} is no angle", option("work_rotation", work_rotation)))
    if mapping is not None and format is not None:
        raise UsageError(
            phrase("{} is for text that no format covers: leave {} out", option("mapping"), option("format", format))
        )
    layout = load(mapping) if isinstance(mapping, (str, Path)) else mapping
    calibrated = load_probe(probe) if isinstance(probe, (str, Path)) else probe
    progress.stage("read")
    data = _content(path)
    digest = sha256(data).hexdigest()
    sheet = ""
    if workbook.recognises(data):
        data, sheet = workbook.as_text(data, str(path))
    source = Source(data, str(path), digest, points, probe_radius, units, work_offset, part, calibrated)
    name = "mapped" if layout is not None else format or recognised(data)
    if part is not None and name not in _SEVERAL_PARTS:
        raise UsageError(phrase("{}: {} holds one measured part", option("part", part), path))
    if layout is None:
        measurement = FORMATS[name].read(source)
        check_last_number(data, str(path))
        if part is not None:
            measurement = replace(measurement, notes=(phrase("measured part {}", part), *measurement.notes))
    else:
        measurement = mapped.read(source, layout)
    if points == "axis" and layout is None:
        if measurement.ball_radius:
            raise UsageError(
                phrase("{} contradicts {}, whose points are centres of the probe ball", option("points", "axis"), path)
            )
        measurement = replace(measurement, axis_radii=source.axis_radii())
    if calibrated is not None:
        measurement = _calibrated(measurement, calibrated)
        source.bases["radius"] = Basis("said", message(option("probe")))
    if sheet:
        measurement = replace(measurement, notes=(sheet, *measurement.notes))
    frame = Basis("said", message(option("work_offset"), ", ", option("work_rotation")))
    if work_offset is None and work_rotation is None:
        frame = _FRAMES.get(name, _AS_EXPORTED)
    measurement = replace(measurement, bases={**source.bases, "frame": frame})
    # A reader of the machine frame needs the offset itself, to compare it with what the file says.
    offset = None if name in _MACHINE_FRAME else work_offset
    return laid_in_work_frame(measurement, offset, work_rotation)


def recognised(data: bytes) -> str:
    """Name of the format of a file's bytes; the last of `FORMATS` where no other claims them."""
    return next((name for name, module in FORMATS.items() if module.recognises(data)), list(FORMATS)[-1])


def _calibrated(measurement: Measurement, probe: Probe) -> Measurement:
    """The measurement with its probe, and ball centres with the probe's effective radius in place of the file's."""
    if measurement.axis_radii is not None:
        return replace(measurement, probe=probe)
    if not measurement.ball_radius:
        raise UsageError(
            phrase(
                "{} belongs to {} or axis: contact points lie on the part already",
                option("probe"),
                option("points", "centre"),
            ),
        )
    return replace(measurement, probe=probe, ball_radius=probe.radius)


def _content(path: str | Path) -> bytes:
    """Bytes of a regular file; FormatError for anything else, so that no pipe or device is waited for."""
    try:
        path = Path(path)
        if not stat.S_ISREG(path.stat().st_mode):
            raise FormatError(phrase("not a file"), path)
        return path.read_bytes()
    except (OSError, ValueError) as error:
        if isinstance(error, FormatError):
            raise
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise FormatError(phrase("cannot be read: {}", reason), path) from error
