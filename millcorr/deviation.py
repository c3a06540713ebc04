# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations: how far each measured point lies from the profile along its normal, and which points to believe.

Sign: positive is excess material, negative is undercut (werner-2018).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .errors import InputError
from .footpoint import FootPoints, FootPointSearch, Place
from .measurement import Measurement
from .profile import CORNER_ANGLE, Profile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

REACH = 1.0
"""A point farther than this from the profile, in mm, does not belong to it."""

BRANCH_GAP = 0.02
"""A point whose next branch is no more than this farther, in mm, has no certain foot point."""


@dataclass(frozen=True, slots=True)
class Rejected:
    """A measured point that is not used, and why; `index` counts the measurement's points from 0."""

    index: int
    reason: str


@dataclass(frozen=True, eq=False, slots=True)
class Deviation:
    """Signed normal deviations, one row a used point, in the order of the measurement.

    Parameters
    ----------
    index : (n,) int64
        Row of the measurement.
    contour, stretch, level : (n,) int64
        Contour and smooth stretch of the profile, Z level of the measurement.
    s : (n,) float64
        Arc length of the foot point from the contour's start, mm.
    z : (n,) float64
        Height of the point, mm.
    foot, normal : (n, 2) float64
        Nominal point in mm and directional cosines (cos alpha, cos beta).
    value : (n,) float64
        Deviation d in mm, ``(P - C(s)) . n`` less the ball radius (werner-2018, fig. 1).
    rejected : tuple of Rejected
    """

    index: Ints
    contour: Ints
    stretch: Ints
    level: Ints
    s: Floats
    z: Floats
    foot: Floats
    normal: Floats
    value: Floats
    rejected: tuple[Rejected, ...]

    def __len__(self) -> int:
        return len(self.index)

    @property
    def components(self) -> Floats:
        """Components dx = d cos alpha, dy = d cos beta in mm, (n, 2) (werner-2018, eq. 1)."""
        out: Floats = self.value[:, None] * self.normal
        return out


def statistics(value: Floats) -> dict[str, float]:
    """Mean, min, max, height (max - min) and standard deviation (n - 1), all in the unit of `value`."""
    if not len(value):
        return dict.fromkeys(("mean", "min", "max", "height", "std"), float("nan"))
    return {
        "mean": float(value.mean()),
        "min": float(value.min()),
        "max": float(value.max()),
        "height": float(np.ptp(value)),
        "std": float(value.std(ddof=1)) if len(value) > 1 else 0.0,
    }


def deviations(
    measurement: Measurement, profile: Profile, *, reach: float = REACH, cutter_radius: float = 0.0
) -> Deviation:
    """Normal deviations of a measurement from a profile.

    Parameters
    ----------
    measurement : Measurement
        Contact points or ball centres; order, start and direction do not matter.
    profile : Profile
    reach : float
        Points with a larger deviation, in mm, are rejected as not belonging to the profile.
    cutter_radius : float
        Points where a cutter of this radius, in mm, cannot reach the profile are rejected: in inner corners
        and where the profile is more hollow than the cutter.

    Returns
    -------
    Deviation

    Raises
    ------
    InputError
        If no point can be used.
    """
    points = measurement.points[:, :2]
    search = FootPointSearch(profile, margin=max(reach, 1.0) + measurement.ball_radius)
    feet = search.find(points)
    normals = None if measurement.normals is None else measurement.normals[:, :2]
    if normals is not None:
        feet = search.on_the_side_of(points, normals, feet)
    value = feet.distance - measurement.ball_radius
    normal = feet.normal.copy()
    reasons = np.full(len(points), -1)

    at_corner = np.flatnonzero((feet.place == Place.JOINT) & _is_corner(profile, feet))
    if len(at_corner):
        reasons[at_corner] = 2
        if normals is not None:
            _take_the_measured_side(profile, points, normals, feet, at_corner, value, normal, reasons)
            value[at_corner] -= np.where(reasons[at_corner] < 0, measurement.ball_radius, 0.0)
    reasons[feet.place == Place.END] = 1
    unsure = feet.rival < np.maximum(BRANCH_GAP, np.abs(value))
    if normals is not None:
        length = np.hypot(*normals.T)
        unsure &= (normals * feet.normal).sum(axis=1) < 0.9 * np.maximum(length, 1e-12)
    reasons[unsure & (reasons < 0)] = 3
    if cutter_radius > 0:
        reasons[(reasons < 0) & _out_of_reach(profile, feet, cutter_radius)] = 4
    reasons[(np.abs(value) > reach) & (reasons < 1)] = 0
    texts = (
        f"farther than {reach:g} mm from the profile",
        "beyond the end of the open profile",
        "at a corner, where the profile has no single normal and the file gives none",
        "two branches of the profile are equally near and the file gives no normal",
        "in an inner corner or hollow that the cutter cannot reach",
    )
    used = np.flatnonzero(reasons < 0)
    rejected = tuple(Rejected(int(i), texts[reasons[i]]) for i in np.flatnonzero(reasons >= 0))
    if not len(used):
        counts = {t: int((reasons == k).sum()) for k, t in enumerate(texts)}
        why = max(counts, key=lambda t: counts[t])
        raise InputError(
            f"{measurement.source}: none of the {len(points)} points can be used, most are {why}; "
            "check unit, work frame, --points and --nominal"
        )
    span, t = feet.span[used], feet.t[used]
    return Deviation(
        used.astype(np.int64),
        profile.contour[span],
        profile.stretch[span],
        measurement.levels()[used],
        profile.arc_length(span, t),
        measurement.points[used, 2],
        feet.foot[used],
        normal[used],
        value[used],
        rejected,
    )


def _is_corner(profile: Profile, feet: FootPoints) -> NDArray[np.bool_]:
    before = np.where(feet.t == 1.0, feet.span, profile.neighbour(feet.span, -1))
    out: NDArray[np.bool_] = np.abs(np.nan_to_num(profile.turn[before])) > CORNER_ANGLE
    return out


def _out_of_reach(profile: Profile, feet: FootPoints, radius: float) -> NDArray[np.bool_]:
    """Feet where the profile is more hollow than the cutter, or near an inner corner that keeps it away."""
    out: NDArray[np.bool_] = 1.0 + radius * profile.curvature(feet.span, feet.t) < 1e-6
    s = profile.arc_length(feet.span, feet.t)
    contour = profile.contour[feet.span]
    total = profile.total[contour]
    closed = np.array([c.closed for c in profile.contours])[contour]
    # A turn of 0.02 rad keeps a cutter of 5 mm 0.25 um away: less is no corner.
    for joint in np.flatnonzero(np.nan_to_num(profile.turn) < -0.02):
        at = profile.begin[joint] + profile.length[joint]
        away = np.abs(s - at)
        away = np.where(closed, np.minimum(away, np.abs(total - away)), away)
        kept_off = radius * np.tan(min(-float(profile.turn[joint]), 2.8) / 2)
        out |= (contour == profile.contour[joint]) & (away < kept_off)
    return out


def _take_the_measured_side(
    profile: Profile,
    points: Floats,
    normals: Floats,
    feet: FootPoints,
    rows: Ints,
    value: Floats,
    normal: Floats,
    reasons: Ints,
) -> None:
    """At a corner, measure along the neighbouring side whose normal the file's normal matches. In place."""
    span = feet.span[rows]
    before = np.where(feet.t[rows] == 1.0, span, profile.neighbour(span, -1))
    after = profile.neighbour(before, 1)
    sides = np.stack(
        [profile.normals(before, np.ones(len(rows))), profile.normals(after, np.zeros(len(rows)))]
    )
    match = (sides * normals[rows][None]).sum(axis=2)
    best = match.argmax(axis=0)
    good = match.max(axis=0) > 0.9
    chosen = sides[best, np.arange(len(rows))]
    normal[rows[good]] = chosen[good]
    value[rows[good]] = ((points[rows] - feet.foot[rows]) * chosen).sum(axis=1)[good]
    reasons[rows[good]] = -1
