# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations: how far each measured point lies from the profile along its normal, and which points to believe.

Sign: positive is excess material, negative is undercut (werner-2018).
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import CORNER_ANGLE, Profile
from millcorr.messages import mm, option, phrase
from millcorr.readers.measurement import Measurement

REACH = 1.0
"""A point farther than this from the profile, in mm, does not belong to it."""

BRANCH_GAP = 0.02
"""A point whose next branch is no more than this farther, in mm, has no certain foot point."""

USUAL = 1.5
"""Times what 19 of 20 points that belong to one branch alone are off by: deviations of this part are no larger."""

ACROSS = 0.5
"""Cosine of 60 degrees: a point whose own normal is farther than that off the profile's lies on another surface. The
probe touches within some 10 degrees of the normal, or along an axis that is at most 45 degrees off it."""

REACHED = 1e-3
"""A cutter that touches the profile at one place and cuts into it elsewhere by no more than this, in mm, reaches
that place: a hollow joint of facets of 0.02 rad keeps a cutter of radius 5 mm only 0.25 um away."""


UNREACHED = phrase("in an inner corner or hollow that the cutter cannot reach")
"""Why points in fillets that the cutter leaves are not used; they say nothing against the program."""


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
    step : float
        Step in mm in which the file states coordinates; 0 where it is not known.
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
    step: float = 0.0

    def __len__(self) -> int:
        return len(self.index)

    def without(self, rows: Ints, reason: str) -> Deviation:
        """The same without some of its points, (k,), which are rejected for a reason."""
        kept = np.delete(np.arange(len(self)), rows)
        listed = (*self.rejected, *(Rejected(int(i), reason) for i in self.index[rows]))
        rejected = tuple(sorted(listed, key=lambda one: one.index))
        names = [field.name for field in fields(self) if field.name not in ("rejected", "step")]
        return replace(self, rejected=rejected, **{name: getattr(self, name)[kept] for name in names})

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
    if measurement.axis_radii is not None or measurement.probe is not None:
        raise InputError(
            phrase(
                "{}: the probe's radius is not taken off yet: comparison.ball_radius.contact_known comes first",
                measurement.source,
            )
        )
    points = measurement.points[:, :2]
    search = FootPointSearch(profile, margin=max(reach, 1.0) + measurement.ball_radius)
    feet = search.find(measurement.points, rivals=True)
    normals = None if measurement.normals is None else measurement.normals[:, :2]
    if normals is not None:
        feet = search.on_the_side_of(measurement.points, normals, feet)
    value = feet.distance - measurement.ball_radius
    normal, span, t = feet.normal.copy(), feet.span.copy(), feet.t.copy()
    reasons = np.full(len(points), -1)

    at_corner = np.flatnonzero((feet.place == Place.JOINT) & is_corner(profile, feet))
    if len(at_corner):
        reasons[at_corner] = 2
        if normals is not None:
            rows, side_span, side_t = _measured_side(profile, normals, feet, at_corner)
            span[rows], t[rows] = side_span, side_t
            normal[rows] = profile.normals(span[rows], t[rows])
            value[rows] = ((points[rows] - feet.foot[rows]) * normal[rows]).sum(axis=1) - measurement.ball_radius
            reasons[rows] = -1
    reasons[np.abs(value) > reach] = 0
    reasons[feet.place == Place.END] = 1
    # Another branch competes where it is about as near, or where this measurement shows deviations that large:
    # an undercut of 0.1 mm on one side of a corner can lie 0.01 mm off the other.
    alone = np.isinf(feet.rival) & (np.abs(value) <= reach)
    usual = USUAL * float(np.quantile(np.abs(value[alone]), 0.95)) if alone.any() else 0.0
    unsure = (feet.rival < np.maximum(BRANCH_GAP, np.abs(value))) | (np.abs(value) + feet.rival <= usual)
    if normals is not None:
        length = np.hypot(*normals.T)
        along = (normals * normal).sum(axis=1)
        unsure &= along < 0.9 * np.maximum(length, 1e-12)
        # Normals the wrong way round are the whole file's matter, not a point's.
        across = (length > 0.5) & (np.abs(along) < ACROSS * length)
        reasons[across & (reasons < 0)] = 5
    reasons[unsure & (reasons < 0)] = 3
    if cutter_radius > 0:
        # In a sharp corner the fillet is farther from the sides than points are believed to be off.
        rows = np.flatnonzero((reasons < 0) | ((reasons == 0) & (value > 0) & (value < cutter_radius)))
        z = measurement.points[rows, 2]
        reasons[rows[_out_of_reach(profile, span[rows], t[rows], z, cutter_radius)]] = 4
    texts = (
        phrase("farther than {} from the profile", mm(reach, "g")),
        phrase("beyond the end of the open profile"),
        phrase("at a corner, where the profile has no single normal and the file gives none"),
        phrase("two branches of the profile are equally near and the file gives no normal"),
        UNREACHED,
        phrase("touched on another surface: its own normal is more than 60 degrees off the profile's there"),
    )
    used = np.flatnonzero(reasons < 0)
    rejected = tuple(Rejected(int(i), texts[reasons[i]]) for i in np.flatnonzero(reasons >= 0))
    if not len(used):
        counts = {t: int((reasons == k).sum()) for k, t in enumerate(texts)}
        why = max(counts, key=lambda t: counts[t])
        raise InputError(
            phrase(
                "{}: none of the {} points can be used, most are {}; check unit, work frame, {} and {}",
                measurement.source,
                len(points),
                why,
                option("points"),
                option("nominal"),
            ),
        )
    span, t = span[used], t[used]
    return Deviation(
        used.astype(np.int64),
        profile.contour[span],
        profile.stretch[span],
        _levels(measurement, profile, profile.contour[span], used),
        profile.arc_length(span, t),
        measurement.points[used, 2],
        feet.foot[used],
        normal[used],
        value[used],
        rejected,
    )


def is_corner(profile: Profile, feet: FootPoints) -> Bools:
    """Foot points at joints where the profile turns by more than `CORNER_ANGLE`; those at other places mean nothing."""
    progress.step()
    before = np.where(feet.t == 1.0, feet.span, profile.neighbour(feet.span, -1))
    out: Bools = np.abs(np.nan_to_num(profile.turn[before])) > CORNER_ANGLE
    return out


def require_heights(measurement: Measurement, profile: Profile) -> None:
    """InputError where points without a height lie on a wall in steps: on which of them, cannot be told."""
    wall = next((wall for wall in profile.steps if len(wall) > 1), ())
    if measurement.has_z or not wall:
        return
    down_to = ", ".join(f"Z{z:g}" for z in profile.heights(np.array(wall[::-1]))[0])
    raise InputError(
        phrase(
            "{}: the program cuts the wall in steps down to {}, and the points have no height: on which "
            "of them each lies cannot be told; give the file with its third coordinate",
            measurement.source,
            down_to,
        )
    )


def _levels(measurement: Measurement, profile: Profile, contour: Ints, used: Ints) -> Ints:
    """Height that each used point was measured at, numbered from the lowest; steps of a wall are different ones."""
    level = measurement.levels()[used]
    stepped = np.array([c.step is not None for c in profile.contours])
    if not stepped.any():
        return level
    # A scan that goes down a wall without a break is one height to the measurement.
    step = np.where(stepped[contour], contour, -1)
    z = measurement.points[used, 2]
    key, group = np.unique(np.stack([level, step], axis=1), axis=0, return_inverse=True)
    mean = np.bincount(group.ravel(), z) / np.bincount(group.ravel())
    rank = np.empty(len(key), dtype=np.int64)
    rank[np.argsort(mean, kind="stable")] = np.arange(len(key))
    out: Ints = rank[group.ravel()]
    return out


def _out_of_reach(profile: Profile, span: Ints, t: Floats, z: Floats, radius: float) -> Bools:
    """Places that a cutter cannot touch: hollows tighter than it, and where it would cut into another side."""
    progress.step()
    foot, first, second = profile.evaluate(span, t)
    speed = np.hypot(*first.T)
    centre = foot + radius * np.stack([first[:, 1] / speed, -first[:, 0] / speed], axis=1)
    curvature = (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / speed**3
    room = FootPointSearch(profile, margin=radius + 1.0).find(np.column_stack([centre, z])).distance
    out: Bools = (room < radius - REACHED) | (1.0 + radius * curvature < 1e-6)
    return out


def _measured_side(profile: Profile, normals: Floats, feet: FootPoints, rows: Ints) -> tuple[Ints, Ints, Floats]:
    """Of feet at corners those whose measured normal matches a neighbouring side; its span and parameter there."""
    span = feet.span[rows]
    before = np.where(feet.t[rows] == 1.0, span, profile.neighbour(span, -1))
    after = profile.neighbour(before, 1)
    ones, zeros = np.ones(len(rows)), np.zeros(len(rows))
    sides = np.stack([profile.normals(before, ones), profile.normals(after, zeros)])
    unit = normals[rows] / np.maximum(np.hypot(*normals[rows].T), 1e-12)[:, None]
    match = (sides * unit).sum(axis=2)
    first = match[0] >= match[1]
    good = match.max(axis=0) > 0.9
    return rows[good], np.where(first, before, after)[good], np.where(first, ones, zeros)[good]
