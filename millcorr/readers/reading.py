# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a measured file is to be read: everything that the file may leave unsaid, in one noun."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from millcorr.errors import UsageError
from millcorr.measurement import Measurement


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

    points: str | None = None
    probe_radius: float | None = None
    units: str | None = None
    format: str | None = None
    mapping: Path | None = None
    part: int | None = None
    work_offset: tuple[float, float, float] | None = None
    work_rotation: float | None = None
    probe: Path | None = None

    @classmethod
    def taken_from(cls, options: dict[str, Any]) -> Reading:
        """The reading that some options describe; those options are taken out of the dictionary."""
        return cls(**{name: options.pop(name) for name in FIELDS if name in options})

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Reading:
        """A reading from what `as_dict` gave; UsageError for a name that does not exist."""
        unknown = sorted(set(given) - set(FIELDS))
        if unknown:
            raise UsageError(f"{unknown[0]} says nothing of how to read a file; known are {', '.join(FIELDS)}")
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


FIELDS = tuple(field.name for field in fields(Reading))
"""Names of everything that can be said."""
