# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measurement: points that a machine touched on a part, with their origin, and the probe that touched them."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.errors import FormatError, InputError
from millcorr.messages import joined, mm, phrase

INTERPOLATIONS = ("linear", "trigonometric")

UNIT_LENGTH = 1e-6
"""A direction of travel has length 1 to within this."""

LARGEST_LOBING = 0.1
"""Effective radii of one probe differ by less than this, in mm: its pre-travel is a few hundredths."""


BASES = ("stated", "said", "inferred", "assumed")
"""How something about a measured file is known: from the file or its format, the caller, its figures, or not at all."""


@dataclass(frozen=True, slots=True)
class Basis:
    """How something about a measured file is known.

    Parameters
    ----------
    how : str
        One of `BASES`.
    why : str
        What says so, or what is assumed; empty where there is nothing to add.
    """

    how: str
    why: str = ""

    def __str__(self) -> str:
        return f"{self.how}: {self.why}" if self.why else self.how


@dataclass(frozen=True, eq=False, slots=True)
class Probe:
    """Calibrated touch probe: how large its ball acts in each direction, and where it sits below the spindle.

    Parameters
    ----------
    radius : float
        Effective radius in mm: distance from where the control sees the ball's centre to the surface touched.
    directions : (k,) float64, optional
        Directions of touch in rad, from X+ anticlockwise, increasing, within one turn: the way from the ball's
        centre to the surface, which is where the ball travels if it travels along the normal.
    radii : (k,) float64, optional
        Effective radius in mm in each of `directions`; in the others interpolated.
    interpolation : {"linear", "trigonometric"}
        Between `directions`, round the whole turn; trigonometric needs even spacing.
    offset : (float, float)
        Ball's centre less the position that the control reports, mm, in the frame of the points.
    control_radii : (float, float), optional
        Radii in mm by which the control shifts touches along X and along Y, where they are known.
    source : str
        File that the calibration came from.
    """

    radius: float
    directions: Floats | None = None
    radii: Floats | None = None
    interpolation: str = "linear"
    offset: tuple[float, float] = (0.0, 0.0)
    control_radii: tuple[float, float] | None = None
    source: str = ""

    def __post_init__(self) -> None:
        for key, lengths in (("radius", (self.radius,)), ("control_radius", self.control_radii or ())):
            if not all(math.isfinite(r) and r > 0 for r in lengths):
                raise self._error(key, phrase("a length in mm above 0"))
        if not all(map(math.isfinite, self.offset)):
            raise self._error("offset", phrase("two lengths in mm"))
        if self.interpolation not in INTERPOLATIONS:
            raise self._error("interpolation", joined(INTERPOLATIONS, phrase(" or ")))
        if any(abs(r - self.radius) > LARGEST_LOBING for r in self.control_radii or ()):
            raise self._error("control_radius", phrase("within {} of the effective radius", mm(LARGEST_LOBING, "g")))
        if self.directions is None or self.radii is None:
            if self.directions is not self.radii:
                raise self._error("directions", phrase("given together with radii"))
            return
        self._check_table(self.directions, self.radii)
        self.directions.flags.writeable = self.radii.flags.writeable = False

    def _error(self, key: str, wanted: str) -> FormatError:
        return FormatError(phrase("{} must be {}", key, wanted), self.source or "probe")

    def _check_table(self, directions: Floats, radii: Floats) -> None:
        k = len(directions)
        if directions.shape != (k,) or radii.shape != (k,) or k < 3:
            raise self._error("radii", phrase("as many as directions, at least three"))
        if not np.isfinite(directions).all() or (np.diff(directions) <= 0).any() or np.ptp(directions) >= 2 * np.pi:
            raise self._error("directions", phrase("angles that increase and stay within one turn"))
        if not (np.abs(radii - self.radius) <= LARGEST_LOBING).all():
            raise self._error(
                "radii", phrase("lengths in mm within {} of the effective radius", mm(LARGEST_LOBING, "g"))
            )
        even = directions[0] + 2 * np.pi * np.arange(k) / k
        if self.interpolation == "trigonometric" and np.abs(directions - even).max() > 1e-9:
            raise self._error(
                "interpolation", phrase("linear where the directions are not evenly spaced round the turn")
            )

    def effective(self, direction: Floats) -> Floats:
        """Effective radius in mm by direction of touch in rad; (n,).

        Trigonometric interpolation goes through all radii and bends least: harmonics up to half their number.
        """
        if self.directions is None or self.radii is None:
            return np.full(len(direction), self.radius)
        if self.interpolation == "linear":
            return np.interp(direction, self.directions, self.radii, period=2 * np.pi)
        k = len(self.radii)
        harmonics = np.fft.rfft(self.radii) / k
        # Harmonics but the first, and the last of an even number, stand for themselves and their mirror image.
        harmonics[1 : (k + 1) // 2] *= 2
        out = np.full(len(direction), harmonics[0].real)
        for order, harmonic in enumerate(harmonics[1:], 1):
            phase = order * (direction - self.directions[0])
            out += harmonic.real * np.cos(phase) - harmonic.imag * np.sin(phase)
        return out


@dataclass(frozen=True, eq=False, slots=True)
class Measurement:
    """Measured points of one part.

    Parameters
    ----------
    points : (n, 3) float64
        Positions in mm in the work frame. Contact points, or ball centres when `ball_radius` is not 0. Where
        `axis_radii` is given, ball centres that the control shifted along the axis of travel; `ball_radius` is then
        what lies between point and surface where the slope is a multiple of 90 degrees.
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
    elements : sequence of n str, or None
        What the file calls each point: label, number or element id.
    stated : (n,) float64 or None
        Deviations in mm that the file itself states, positive outwards; NaN where it states none.
    unit : {"mm", "inch"}
        Unit of the file's numbers. Everything here is in mm.
    format : str
        Name of the format the file was read as; empty for points that come from no file.
    notes : tuple of str
        What the reader did or left out beyond copying numbers: frames applied, features not read.
    axis_radii : (float, float), optional
        Radii in mm by which the control shifted touches along X and along Y towards the material, which
        `millcorr.comparison.ball_radius.contact_known` has still to take back; None where it did not shift.
    travel : (n, 3) float64, optional
        Unit directions of travel towards the material, of points that were shifted.
    probe : Probe, optional
        Calibration that `millcorr.comparison.ball_radius.contact_known` has still to apply.
    left_out : tuple of (int, str)
        Rows of the file's points, from 0 and increasing, that are not here, each with the reason.
    bases : dict of str to Basis
        How "unit", "points" (contact or centre), "radius" and "frame" are known; empty for points that come from no
        file.
    """

    points: Floats
    normals: Floats | None
    ball_radius: float
    lines: Ints
    source: str
    digest: str
    has_z: bool = True
    nominal: Floats | None = None
    elements: Sequence[str] | None = None
    stated: Floats | None = None
    unit: str = "mm"
    format: str = ""
    notes: tuple[str, ...] = ()
    axis_radii: tuple[float, float] | None = None
    travel: Floats | None = None
    probe: Probe | None = None
    left_out: tuple[tuple[int, str], ...] = ()
    bases: Mapping[str, Basis] = field(default_factory=dict)
    _fingerprint: str = field(default="", init=False, repr=False)

    def __post_init__(self) -> None:
        if self.points.ndim != 2 or self.points.shape[1] != 3:
            raise InputError(f"{self.source}: points must have shape (n, 3), not {self.points.shape}")
        if not np.isfinite(self.points).all():
            row = int(np.flatnonzero(~np.isfinite(self.points).all(axis=1))[0])
            raise InputError(phrase("{}:{}: a coordinate is not a finite number", self.source, self.lines[row]))
        if self.ball_radius < 0:
            raise InputError(phrase("{}: ball radius {} is negative", self.source, mm(self.ball_radius, "g")))
        n = len(self.points)
        for what, array, shape in (
            ("points", self.points, (n, 3)),
            ("normals", self.normals, (n, 3)),
            ("lines", self.lines, (n,)),
            ("nominal points", self.nominal, (n, 3)),
            ("stated deviations", self.stated, (n,)),
            ("directions of travel", self.travel, (n, 3)),
        ):
            if array is None:
                continue
            if array.shape != shape:
                raise InputError(f"{self.source}: {what} must have shape {shape}, not {array.shape}")
            array.flags.writeable = False
        if self.elements is not None and len(self.elements) != n:
            raise InputError(phrase("{}: {} names for {} points", self.source, len(self.elements), n))
        self._check_axis()

    def _check_axis(self) -> None:
        """InputError where what is said of a shift along the axis of travel contradicts itself."""
        if self.axis_radii is None:
            if self.travel is not None:
                raise InputError(phrase("{}: directions of travel are for points shifted along an axis", self.source))
            return
        if not all(math.isfinite(r) and r > 0 for r in self.axis_radii):
            raise InputError(phrase("{}: the radii of a shift along an axis must be above 0 mm", self.source))
        if self.travel is not None:
            wrong = np.flatnonzero(~(np.abs(np.sqrt((self.travel**2).sum(axis=1)) - 1.0) <= UNIT_LENGTH))
            if len(wrong):
                raise InputError(phrase("{}: the direction of travel has not length 1", self.origin(int(wrong[0]))))

    def __len__(self) -> int:
        return len(self.points)

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the points to 0.1 um in any order: the same measurement, however it was saved."""
        progress.step()
        if not self._fingerprint:
            rounded = np.round(self.points * 1e4).astype(np.int64)
            ordered = rounded[np.lexsort(rounded.T)]
            digest = hashlib.sha256(np.ascontiguousarray(ordered, dtype="<i8").tobytes()).hexdigest()
            object.__setattr__(self, "_fingerprint", digest)
        return self._fingerprint

    def origin(self, row: int) -> str:
        """Where a point comes from: file, line and, where the file names it, its name; `row` counts from 0."""
        name = "" if self.elements is None else f" ({self.elements[row]})"
        return f"{self.source}:{self.lines[row]}{name}"

    def contact(self) -> Floats | None:
        """Contact points in mm, (n, 3): ball centre less radius times normal; None if a normal is needed and missing.

        What MSR files mean by the surface point: the normal is the file's own. None also for points that are
        still shifted along an axis.
        """
        if self.axis_radii is not None:
            return None
        if not self.ball_radius:
            return self.points
        if self.normals is None:
            return None
        out: Floats = self.points - self.ball_radius * self.normals
        return out

    def from_nominal(self) -> Floats | None:
        """Deviations in mm, (n,), of the contact points from the file's own nominal points along its normals.

        ``(P - N) . n - r``, positive outwards; NaN where a nominal is missing, None where all are, or the normals,
        or where the points are still shifted along an axis.
        """
        if self.nominal is None or self.normals is None or self.axis_radii is not None:
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
