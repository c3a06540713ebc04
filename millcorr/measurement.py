# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement: points that a machine touched on a part, with their origin."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, eq=False, slots=True)
class Measurement:
    """Measured points of one part.

    Parameters
    ----------
    points : (n, 3) float64
        Positions in mm in the work frame. Contact points, or ball centres when `ball_radius` is not 0.
    normals : (n, 3) float64 or None
        Measured or nominal unit normals out of the material where the file has them, exact to the digits printed.
    ball_radius : float
        Radius in mm that still lies between point and surface; 0 for contact points.
    lines : (n,) int64
        Line number in the file (from 1) that each point came from.
    source : str
        Name of the file.
    digest : str
        SHA-256 of the file's bytes in hexadecimal; recognises a measurement that was applied before.
    has_z : bool
        False where the file has no third coordinate; z is then 0.
    nominal : (n, 3) float64 or None
        Nominal points on the surface in mm, as the file gives them; NaN in the rows of points without one.
    elements : tuple of n str, or None
        What the file calls each point: label, number or element id.
    stated : (n,) float64 or None
        Deviations in mm that the file itself states, positive outwards; NaN where it states none.
    unit : {"mm", "inch"}
        Unit of the file's numbers. Everything here is in mm.
    format : str
        Name of the format the file was read as; empty for points that come from no file.
    notes : tuple of str
        What the reader did or left out beyond copying numbers: frames applied, features not read.
    """

    points: Floats
    normals: Floats | None
    ball_radius: float
    lines: Ints
    source: str
    digest: str
    has_z: bool = True
    nominal: Floats | None = None
    elements: tuple[str, ...] | None = None
    stated: Floats | None = None
    unit: str = "mm"
    format: str = ""
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.points.ndim != 2 or self.points.shape[1] != 3:
            raise InputError(f"{self.source}: points must have shape (n, 3), not {self.points.shape}")
        if not np.isfinite(self.points).all():
            row = int(np.flatnonzero(~np.isfinite(self.points).all(axis=1))[0])
            raise InputError(f"{self.source}:{self.lines[row]}: a coordinate is not a finite number")
        if self.ball_radius < 0:
            raise InputError(f"{self.source}: ball radius {self.ball_radius} mm is negative")
        n = len(self.points)
        for what, array, shape in (
            ("points", self.points, (n, 3)),
            ("normals", self.normals, (n, 3)),
            ("lines", self.lines, (n,)),
            ("nominal points", self.nominal, (n, 3)),
            ("stated deviations", self.stated, (n,)),
        ):
            if array is None:
                continue
            if array.shape != shape:
                raise InputError(f"{self.source}: {what} must have shape {shape}, not {array.shape}")
            array.flags.writeable = False
        if self.elements is not None and len(self.elements) != n:
            raise InputError(f"{self.source}: {len(self.elements)} names for {n} points")

    def __len__(self) -> int:
        return len(self.points)

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the points to 0.1 um in any order: the same measurement, however it was saved."""
        rounded = np.round(self.points * 1e4).astype(np.int64)
        ordered = rounded[np.lexsort(rounded.T)]
        return hashlib.sha256(np.ascontiguousarray(ordered, dtype="<i8").tobytes()).hexdigest()

    def origin(self, row: int) -> str:
        """Where a point comes from: file, line and, where the file names it, its name; `row` counts from 0."""
        name = "" if self.elements is None else f" ({self.elements[row]})"
        return f"{self.source}:{self.lines[row]}{name}"

    def contact(self) -> Floats | None:
        """Contact points in mm, (n, 3): ball centre less radius times normal; None if a normal is needed and missing.

        What MSR files mean by the surface point: the normal is the file's own.
        """
        if not self.ball_radius:
            return self.points
        if self.normals is None:
            return None
        out: Floats = self.points - self.ball_radius * self.normals
        return out

    def from_nominal(self) -> Floats | None:
        """Deviations in mm, (n,), of the contact points from the file's own nominal points along its normals.

        ``(P - N) . n - r``, positive outwards; NaN where a nominal is missing, None where all are, or the normals.
        """
        if self.nominal is None or self.normals is None:
            return None
        out: Floats = ((self.points - self.nominal) * self.normals).sum(axis=1) - self.ball_radius
        return out

    def levels(self, gap: float = 0.05) -> Ints:
        """Number the Z levels from the lowest up.

        Parameters
        ----------
        gap : float
            Points whose heights differ by more than this, in mm, with none between, are on different levels.

        Returns
        -------
        (n,) int64
            Level of each point, from 0.
        """
        if not len(self):
            return np.zeros(0, dtype=np.int64)
        order = np.argsort(self.points[:, 2], kind="stable")
        steps = np.diff(self.points[order, 2], prepend=self.points[order[0], 2]) > gap
        level = np.empty(len(self), dtype=np.int64)
        level[order] = np.cumsum(steps)
        return level
