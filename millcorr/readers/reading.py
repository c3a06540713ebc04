# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a measured file is to be read: everything that the file may leave unsaid, in one noun."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.options import declared, options_of
from millcorr.readers.measurement import Measurement

KINDS = ("contact", "centre", "axis")
"""What coordinates are: points on the part, centres of the probe's ball, or centres shifted along an axis."""

MEASURED = phrase("the measurement")
"""Heading under which the options stand."""


@dataclass(frozen=True, slots=True)
class Reading:
    """What the user says of a measured file; None leaves it to the file. See `millcorr.readers.read`.

    Parameters
    ----------
    points : {"contact", "centre", "axis"}, optional
    probe_radius : float, optional
        mm.
    units : {"mm", "inch"}, optional
    format : str, optional
    mapping : Path, optional
        TOML file with the meaning of the columns.
    part : int, optional
        From 1.
    work_offset : tuple of 3 float, optional
        Origin of the work frame in the file's frame, mm.
    work_rotation : float, optional
        Turn of the work frame in the file's frame, degrees, positive anticlockwise.
    probe : Path, optional
        TOML file with the probe's calibration.
    """

    points: str | None = declared(
        None,
        "points on the part, centres of the probe's ball, or centres shifted by its radius along an axis",
        choices=KINDS,
        group=MEASURED,
    )
    probe_radius: float | None = declared(
        None, "ball radius, for centres and points shifted along an axis", unit="MM", above=0.0, group=MEASURED
    )
    units: str | None = declared(None, "unit of the measured file", choices=("mm", "inch"), group=MEASURED)
    format: str | None = declared(
        None, "format of the measured file (by content by default)", type=str, unit="NAME", group=MEASURED
    )
    mapping: Path | None = declared(
        None,
        "what the columns of a text file are, for layouts that no format covers",
        type=Path,
        unit="FILE.toml",
        group=MEASURED,
    )
    part: int | None = declared(
        None, "which of several measured parts in one file, from 1", type=int, unit="N", group=MEASURED
    )
    work_offset: tuple[float, float, float] | None = declared(
        None, "origin of the work frame in the frame of the file, mm", unit="X Y Z", count=3, group=MEASURED
    )
    work_rotation: float | None = declared(
        None, "turn of the work frame in the frame of the file, degrees, anticlockwise", unit="DEG", group=MEASURED
    )
    probe: Path | None = declared(
        None,
        "calibration of the probe: effective radius by direction, offset of the stylus",
        type=Path,
        unit="FILE.toml",
        group=MEASURED,
    )

    @classmethod
    def taken_from(cls, options: dict[str, Any]) -> Reading:
        """The reading that some options describe; those options are taken out of the dictionary."""
        return cls(**{name: options.pop(name) for name in FIELDS if name in options})

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Reading:
        """A reading from what `as_dict` gave; UsageError for a name that does not exist."""
        unknown = sorted(set(given) - set(FIELDS))
        if unknown:
            raise UsageError(
                phrase("{} says nothing of how to read a file; known are {}", unknown[0], ", ".join(FIELDS))
            )
        values = {name: value for name, value in given.items() if value is not None}
        for name in ("mapping", "probe"):
            if name in values:
                values[name] = Path(values[name])
        if "work_offset" in values:
            x, y, z = values["work_offset"]
            values["work_offset"] = (float(x), float(y), float(z))
        return cls(**values)

    def as_dict(self) -> dict[str, Any]:
        """What is said, as JSON can hold it; paths absolute."""
        given = {name: getattr(self, name) for name in FIELDS}
        return {
            name: str(value.resolve()) if isinstance(value, Path) else value
            for name, value in given.items()
            if value is not None
        }

    def read(self, path: str | Path) -> Measurement:
        """Measured points of a file, read in this way; raises as `millcorr.readers.read`."""
        from millcorr import readers

        given = {name: getattr(self, name) for name in FIELDS}
        return readers.read(path, **{name: value for name, value in given.items() if value is not None})


FIELDS = tuple(options_of(Reading))
"""Names of everything that can be said."""
