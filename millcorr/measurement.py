# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement: points that a machine touched on a part, with their origin."""

from __future__ import annotations

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
        Measured or nominal unit normals out of the material where the file has them.
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
    """

    points: Floats
    normals: Floats | None
    ball_radius: float
    lines: Ints
    source: str
    digest: str
    has_z: bool = True

    def __post_init__(self) -> None:
        if self.points.ndim != 2 or self.points.shape[1] != 3:
            raise InputError(f"{self.source}: points must have shape (n, 3), not {self.points.shape}")
        if not np.isfinite(self.points).all():
            row = int(np.flatnonzero(~np.isfinite(self.points).all(axis=1))[0])
            raise InputError(f"{self.source}:{self.lines[row]}: a coordinate is not a finite number")
        if self.ball_radius < 0:
            raise InputError(f"{self.source}: ball radius {self.ball_radius} mm is negative")
        for array in (self.points, self.normals, self.lines):
            if array is not None:
                array.flags.writeable = False

    def __len__(self) -> int:
        return len(self.points)

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
