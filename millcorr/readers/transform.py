# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid motions of the plane: work offsets, rotations, and what an alignment finds."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import InputError
from millcorr.messages import phrase

from .measurement import Measurement, Probe


@dataclass(frozen=True, slots=True)
class Transform:
    """Motion of the plane: a turn about the origin, then a shift; ``p' = Rot(rotation) p + shift``.

    Parameters
    ----------
    shift : (float, float)
        mm.
    rotation : float
        rad, positive anticlockwise. At multiples of 90 degrees sine and cosine are exact.
    """

    shift: tuple[float, float] = (0.0, 0.0)
    rotation: float = 0.0

    @staticmethod
    def about(
        rotation: float, centre: tuple[float, float] = (0.0, 0.0), shift: tuple[float, float] = (0.0, 0.0)
    ) -> Transform:
        """Turn about a centre, then a shift: ``p' = Rot(rotation) (p - centre) + centre + shift``.

        A work offset G54 with rotation places the work frame in the machine: this maps work to machine, and
        its `inverse` lays points measured in machine coordinates into the work frame.

        Parameters
        ----------
        rotation : float
            rad, positive anticlockwise.
        centre, shift : (float, float)
            mm.
        """
        (a, b), (x, y) = Transform((0.0, 0.0), rotation)._turned(*centre), centre
        return Transform((float(shift[0] + (x - a)), float(shift[1] + (y - b))), rotation)

    @property
    def matrix(self) -> Floats:
        """Rotation matrix, (2, 2)."""
        quarters = self.rotation / (math.pi / 2)
        if quarters == round(quarters):
            c, s = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
        else:
            c, s = math.cos(self.rotation), math.sin(self.rotation)
        return np.array([[c, -s], [s, c]])

    def _turned(self, x: Any, y: Any) -> tuple[Any, Any]:
        (c, minus_s), (s, _) = self.matrix
        return c * x + minus_s * y, s * x + c * y

    def points(self, xy: Floats) -> Floats:
        """Moved points; (n, 2) or (n, 3) in mm, a third coordinate stays."""
        out = np.array(xy, dtype=np.float64)
        x, y = self._turned(xy[:, 0], xy[:, 1])
        out[:, 0], out[:, 1] = x + self.shift[0], y + self.shift[1]
        return out

    def directions(self, vectors: Floats) -> Floats:
        """Turned vectors; (n, 2) or (n, 3), a third component stays."""
        out = np.array(vectors, dtype=np.float64)
        out[:, 0], out[:, 1] = self._turned(vectors[:, 0], vectors[:, 1])
        return out

    def measurement(self, measurement: Measurement) -> Measurement:
        """The measurement moved, its normals, directions of travel and probe turned with it.

        Raises
        ------
        InputError
            If the points are shifted along an axis of the machine that the turn would leave unknown.
        """
        normals, travel, probe = measurement.normals, measurement.travel, measurement.probe
        return dataclasses.replace(
            measurement,
            points=self.points(measurement.points),
            normals=None if normals is None else self.directions(normals),
            axis_radii=self._axis_radii(measurement),
            travel=None if travel is None else self.directions(travel),
            probe=None if probe is None else self._probe(probe),
        )

    def _axis_radii(self, measurement: Measurement) -> tuple[float, float] | None:
        """Radii of a shift along X and Y after the turn, which exchanges the axes or leaves none of them."""
        radii = measurement.axis_radii
        if radii is None or not self.rotation:
            return radii
        (c, s), _ = np.abs(self.matrix)
        if radii[0] == radii[1] and (measurement.travel is not None or 0.0 in (c, s)):
            return radii
        if 0.0 not in (c, s):
            raise InputError(
                phrase(
                    "{}: the points are shifted along an axis of the machine and are to be turned by {:g} "
                    "degrees: give the direction of travel of each point, and one radius",
                    measurement.source,
                    math.degrees(self.rotation),
                )
            )
        return radii if s == 0.0 else (radii[1], radii[0])

    def _probe(self, probe: Probe) -> Probe:
        """The calibration in the turned frame."""
        x, y = self._turned(*probe.offset)
        directions = None if probe.directions is None else probe.directions + self.rotation
        # By now the control's radii are the measurement's.
        return dataclasses.replace(probe, offset=(float(x), float(y)), directions=directions, control_radii=None)

    def inverse(self) -> Transform:
        """The motion that takes this one back."""
        back = Transform((0.0, 0.0), -self.rotation)
        x, y = back._turned(*self.shift)
        return Transform((0.0 - float(x), 0.0 - float(y)), 0.0 - self.rotation)

    def then(self, other: Transform) -> Transform:
        """The motion that another one follows."""
        x, y = other._turned(*self.shift)
        return Transform((float(x) + other.shift[0], float(y) + other.shift[1]), self.rotation + other.rotation)
