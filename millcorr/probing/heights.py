# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heights that a milling program leaves to a probe: how deep it cut beside the contour, how high it passes over all.

What the program does elsewhere, a hole through the part, says nothing about the floor beside the contour.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.errors import UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import at_z, mm, option, phrase, remedy
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath

from .planning import TouchProbe

BESIDE = 1.0
"""A move follows the contour where it runs within this, in mm, of the contour's parallel that the program gives."""

_SAMPLES = np.array([0.25, 0.5, 0.75])
_LITTLE = 1e-6
_DIGIT = 1e-5
"""Programs give heights with fewer digits, mm."""


@dataclass(frozen=True, slots=True)
class Cleared:
    """What a milling program cuts, for a probe that comes after it.

    Parameters
    ----------
    toolpath : Toolpath
    radius : float
        Of the cutter, mm.
    contour_programmed : bool
        Moves under G41 or G42 give the contour, and the control moves the cutter off it by its radius; else all moves
        give the centre of the cutter.
    """

    toolpath: Toolpath
    radius: float
    contour_programmed: bool = False

    def offset(self, moves: Toolpath) -> Floats:
        """Distance in mm that the program keeps with each of the moves from the contour beside it, (n,)."""
        given = (moves.compensation != Compensation.OFF) & self.contour_programmed
        return np.where(given, 0.0, self.radius)


@dataclass(frozen=True, slots=True)
class Room:
    """Heights between which a probe measures and above which it passes over everything, in mm; NaN is unknown.

    Parameters
    ----------
    floor : float
        Lowest cut beside the contour; where several contours are cut to different depths, that of the shallowest.
    level : float
        Highest cut beside the contour, and where there are several, that of the lowest: so high the wall has stood.
    cut : float
        Highest place of any feed move that travels in XY.
    passing : float
        Lowest rapid that travels in XY.
    highest : float
        Highest rapid.
    """

    floor: float
    level: float
    cut: float
    passing: float
    highest: float

    @property
    def least(self) -> float:
        """Lowest safe height that the program itself vouches for, mm."""
        return float(np.fmax(self.cut, self.passing))

    def shown(self, probe: TouchProbe) -> float:
        """Highest place at which passes show a wall to a ball, mm; inf where there are none."""
        lowest = self.floor + probe.ball_radius + probe.margin
        return float(np.fmax(lowest, self.level)) if np.isfinite(self.floor) else float(np.inf)

    def height(self, probe: TouchProbe) -> float | None:
        """Height to measure at, mm: the middle of what passes show of the wall; None where they show nothing.

        A single pass shows the wall only just above its floor.
        """
        lowest = self.floor + probe.ball_radius + probe.margin
        return float(np.fmax(lowest, (self.floor + self.level) / 2)) if np.isfinite(self.floor) else None

    def safe(self, probe: TouchProbe, top: float = np.nan) -> float | None:
        """Height above which a probe passes over everything, mm; None where no rapid shows one.

        The highest rapid, and above the `top` of a model, however the probe's length was set.
        """
        least = np.fmax(self.least, top + probe.ball_radius + probe.margin)
        return float(np.fmax(self.highest, least)) if np.isfinite(self.highest) else None

    def refuse(self, z: float, safe_z: float, probe: TouchProbe, top: float = np.nan) -> None:
        """UsageError where a probe would go into the floor beside the contour, or pass too low over the part.

        Parameters
        ----------
        z, safe_z : float
        probe : TouchProbe
        top : float
            Highest place of the model, mm.
        """
        lowest = self.floor + probe.margin
        if z < lowest - _DIGIT:
            raise UsageError(
                phrase(
                    "{} lies below {}, a margin of {} above the deepest that the program cuts beside the "
                    "contour: say {} or higher",
                    option("z", z),
                    at_z(lowest),
                    mm(probe.margin, "g"),
                    remedy("z", lowest + probe.ball_radius),
                ),
            )
        over = top + probe.ball_radius + probe.margin
        for least, what in (
            (self.passing, phrase("the program's lowest rapid across the part")),
            (self.cut, phrase("the program's highest cut")),
            (over, phrase("the top of the model and the ball above it")),
        ):
            if safe_z < least - _DIGIT:
                needed = np.nanmax([self.least, over, least])
                raise UsageError(
                    phrase(
                        "{} lies below {}, {}: say {} or higher",
                        option("safe_z", safe_z),
                        at_z(least),
                        what,
                        remedy("safe_z", float(needed)),
                    ),
                )


def room_of(cleared: Cleared, profile: Profile | None = None, contour: int | None = None) -> Room:
    """Heights that a milling program shows.

    Parameters
    ----------
    cleared : Cleared
    profile : Profile, optional
        The contour to measure, material on the left; without it every cut counts as one beside it.
    contour : int, optional
        Only beside this contour of the profile, counted from 1.

    Returns
    -------
    Room
    """
    path = cleared.toolpath
    across = _across(path)
    rapid = path.kind == Kind.RAPID
    z = np.stack([path.start[:, 2], path.end[:, 2]])
    lowest, highest = np.fmin(*z), np.fmax(*z)
    cuts = np.flatnonzero(~rapid & across & np.isfinite(lowest))
    if profile is None:
        floor, level = _lowest(lowest[cuts]), -_lowest(-lowest[cuts])
    else:
        floor, level = _beside(cleared, profile, path.take(cuts), contour)
    return Room(floor, level, -_lowest(-highest[cuts]), _lowest(lowest[rapid & across]), -_lowest(-path.end[rapid, 2]))


def _beside(cleared: Cleared, profile: Profile, cuts: Toolpath, contour: int | None) -> tuple[float, float]:
    """Lowest cut beside the contours, that of the shallowest, and highest, that of the lowest; NaN for none.

    A move counts where most of it runs beside the contour on the free side: one that only crosses does not.
    """
    stated = np.isfinite(np.column_stack([cuts.start[:, :2], cuts.end]))
    known: Bools = np.logical_and.reduce(stated, axis=1)
    points = cuts.take(known).position(_SAMPLES)
    # A start without a height is that of its end: the program has stated no other.
    points[:, :, 2] = np.where(np.isfinite(points[:, :, 2]), points[:, :, 2], cuts.end[known, 2][:, None])
    reach = cleared.radius + BESIDE
    left, bottom, right, top = profile.bounding_box()
    x, y = points[:, :, 0], points[:, :, 1]
    near = ((x > left - reach) & (x < right + reach) & (y > bottom - reach) & (y < top + reach)).any(axis=1)
    if not near.any():
        return np.nan, np.nan
    points, off = points[near], cleared.offset(cuts.take(known))[near]
    feet = FootPointSearch(profile, margin=reach).find(points.reshape(-1, 3))
    beside = np.abs(feet.distance.reshape(-1, len(_SAMPLES)) - off[:, None]) <= BESIDE
    beside &= beside.sum(axis=1, keepdims=True) >= 2
    which = profile.contour[feet.span].reshape(beside.shape)
    numbers = range(len(profile.contours))
    chosen = [n for n in numbers if n + 1 == contour] or numbers
    heights = [points[:, :, 2][beside & (which == n)] for n in chosen]
    return max(map(_lowest, heights), key=_known_first), -max((_lowest(-z) for z in heights), key=_known_first)


def _across(path: Toolpath) -> Bools:
    """Moves that travel in X or Y; a start that is unknown counts as another place."""
    way = path.end[:, :2] - path.start[:, :2]
    moved = (~(np.abs(way) <= _LITTLE)).any(axis=1) & np.isfinite(path.end[:, :2]).any(axis=1)
    out: Bools = np.where((path.kind == Kind.ARC) & (path.plane == Plane.XY), True, moved)
    return out


def _known_first(z: float) -> float:
    return z if np.isfinite(z) else -np.inf


def _lowest(z: Floats) -> float:
    known = z[np.isfinite(z)]
    return float(known.min()) if len(known) else np.nan
