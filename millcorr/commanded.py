# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program itself commands: its side, the contour it cuts, and how far that is off the nominal.

A measured deviation is the sum of the program's own offset from the nominal, known exactly, and of what the
machine added. Only the second is filtered; the first may be a correction in force or a CAM system's error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .deviation import REACH, Deviation
from .errors import InputError, LimitError
from .footpoint import FootPointSearch, Place
from .measurement import Measurement
from .profile import Contour, Profile
from .reconstruction import CompensatedContour
from .regeneration import BAND
from .regeneration.carried import carried_correction
from .regeneration.path_following import follow
from .theoretical_contour import SAME_POINT, CutContour, cut_at_vertices, cut_contours, cutting_runs, path_profile
from .toolpath import Compensation, Kind, Toolpath

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

EXACT = 1e-6
"""A program off by less than this everywhere, in mm, commands the nominal."""


def choose_side(
    toolpath: Toolpath,
    usable: Bools,
    side: str,
    measurement: Measurement | None,
    radius: float,
    path_radius: float,
) -> bool:
    """Whether the material lies to the right of the direction of travel.

    Parameters
    ----------
    toolpath : Toolpath
    usable : (n,) bool
        Moves that may be corrected.
    side : {'auto', 'left', 'right'}
        Side of the contour the cutter runs on, seen in its direction; auto: from G41 or G42, else from the
        measured points.
    measurement : Measurement or None
    radius, path_radius : float
        Cutter radius, and distance from path to contour, mm.

    Raises
    ------
    InputError
        If the side cannot be told.
    """
    if side != "auto":
        return side == "left"
    modes = np.unique(toolpath.compensation[usable])
    modes = modes[modes != Compensation.OFF]
    if len(modes) == 1:
        return bool(modes[0] == Compensation.LEFT)
    if len(modes) > 1:
        raise InputError("the program uses both G41 and G42: say --side left or --side right")
    if measurement is None:
        return False
    profiles = _paths(toolpath, usable)
    if not profiles:
        raise InputError("the program has no feed move in the XY plane that could follow a contour")
    feet = FootPointSearch(Profile.from_contours(profiles)).find(measurement.points[:, :2])
    expected = path_radius - measurement.ball_radius
    near = np.abs(np.abs(feet.distance) - abs(expected)) < REACH
    if near.sum() < 0.5 * len(near) or abs(expected) < 2 * REACH:
        near = np.abs(feet.distance) < radius + 2 * REACH
    right = int((feet.distance[near] > 0).sum())
    count = int(near.sum())
    if count == 0 or max(right, count - right) < 0.9 * count:
        raise InputError(
            f"{measurement.source}: the points lie on both sides of the path or far from it ({right} right and "
            f"{count - right} left of {len(feet.distance)}): say --side left or --side right, and check "
            "--tool-diameter, the unit and the work frame"
        )
    return 2 * right > count


def _paths(toolpath: Toolpath, usable: Bools) -> list[Contour]:
    out: list[Contour] = []
    for run in cutting_runs(toolpath):
        for part in np.split(run, np.flatnonzero(np.diff(usable[run].astype(int))) + 1):
            if usable[part[0]]:
                out += path_profile(toolpath, part, False).contours
    return out


def nominal_of(
    toolpath: Toolpath,
    usable: Bools,
    path_radius: float,
    material_right: bool,
    measurement: Measurement | None,
    name: str,
    doubt: Callable[[Profile], None] | None = None,
) -> tuple[Profile, int]:
    """The nominal profile that a program shows: the contours it cuts near the measured points.

    Where none is near, `doubt` is asked first, with all contours: it may know why, and refuse with that.

    Returns
    -------
    Profile
    others : int
        How many contours it cuts beside them.

    Raises
    ------
    InputError
        If no contour of the program is near the measured points.
    """
    found: list[CutContour] = []
    trouble: list[str] = []
    try:
        found = list(cut_contours(toolpath, path_radius, material_right, usable))
    except InputError:
        # What is wrong with one run of moves is no reason to give up the others.
        for run in cutting_runs(toolpath):
            only = np.zeros(len(toolpath), dtype=bool)
            only[run] = usable[run]
            try:
                found += list(cut_contours(toolpath, path_radius, material_right, only))
            except InputError as error:
                trouble.append(str(error))
    contours = _different([c.contour for c in found])
    if not contours:
        raise InputError(f"{name}: {trouble[0] if trouble else 'the program cuts no contour in the XY plane'}")
    if measurement is None:
        return Profile.from_contours(contours), 0
    near = _measured(contours, measurement)
    if not near:
        if doubt is not None:
            doubt(Profile.from_contours(contours))
        feet = FootPointSearch(Profile.from_contours(contours)).find(measurement.points[:, :2])
        typical = float(np.median(np.abs(feet.distance - measurement.ball_radius)))
        raise InputError(
            f"{measurement.source}: the points lie typically {typical:.3f} mm off the nearest contour that {name} "
            "cuts: check --tool-diameter, --side, --points, --units, and the work frame"
        )
    return Profile.from_contours(near), len(contours) - len(near)


def _different(contours: list[Contour]) -> list[Contour]:
    """Contours without repetitions: passes at several depths cut the same one."""
    kept: list[tuple[Profile, FootPointSearch]] = []
    for contour in contours:
        profile = Profile.from_contours([contour])
        probe, _ = profile.at(0, np.linspace(0.0, float(profile.total[0]), 17))
        for other, search in kept:
            if abs(float(other.total[0] - profile.total[0])) < 0.01:
                feet = search.find(probe)
                if np.abs(feet.distance).max() < 1e-3:
                    break
        else:
            kept.append((profile, FootPointSearch(profile)))
    return [p.contours[0] for p, _ in kept]


def _measured(contours: list[Contour], measurement: Measurement) -> list[Contour]:
    """Contours that points belong to: nearest within reach."""
    profile = Profile.from_contours(contours)
    feet = FootPointSearch(profile).find(measurement.points[:, :2])
    near = np.abs(feet.distance - measurement.ball_radius) < REACH
    owner = profile.contour[feet.span[near]]
    if not len(owner):
        return []
    count = np.bincount(owner, minlength=len(contours))
    return [c for c, n in zip(contours, count, strict=True) if n > 0.02 * len(owner)]


def cut_onto_the_contour(toolpath: Toolpath, following: Bools) -> tuple[Toolpath, Ints]:
    """Leads that run onto a contour and along it in one move, cut where the contour begins.

    Parameters
    ----------
    toolpath : Toolpath
    following : (n,) bool
        Moves that follow the contour as a whole.

    Returns
    -------
    Toolpath
        With the other feed moves cut at the following moves' ends; the same one where none lies on them.
    row : (m,) int64
        The move that each of its moves comes from.
    """
    feeds = np.zeros(len(toolpath), dtype=bool)
    for run in cutting_runs(toolpath):
        feeds[run] = True
    leads, rest = np.flatnonzero(feeds & ~following), np.flatnonzero(~feeds | following)
    ends = np.vstack([toolpath.start[following, :2], toolpath.end[following, :2]])
    parts, part_of = cut_at_vertices(toolpath.take(leads), ends)
    if len(parts) == len(leads):
        return toolpath, np.arange(len(toolpath))
    row = np.concatenate([rest, leads[part_of]])
    order = np.argsort(row, kind="stable")
    return Toolpath.concatenate([toolpath.take(rest), parts]).take(order), row[order]


def beside_the_path(toolpath: Toolpath, following: Bools) -> Bools:
    """Moves that hang together with following moves: all between the rapids around them; (n,).

    A retraction to an unknown height (G28 Z0) goes along without being rewritten.
    """
    travel = np.nan_to_num(toolpath.end[:, :2] - toolpath.start[:, :2], nan=1.0)
    jump = toolpath.kind == int(Kind.RAPID)
    rapid = jump & (np.abs(travel).max(axis=1) > 0)
    section = np.cumsum(rapid)
    out: Bools = np.isin(section, section[following]) & ~rapid & ~(jump & np.isnan(toolpath.end[:, 2]))
    return out


@dataclass(frozen=True, eq=False, slots=True)
class Commanded:
    """The program's own following path.

    Parameters
    ----------
    path : Profile
        The cutter's path, run with the material on the left.
    radius : float
        Distance from path to contour, mm.
    following : (n,) bool
        Moves that follow the nominal.
    error : float
        Largest distance in mm of a following move from the nominal's exact parallel.
    expected : CompensatedContour
        Contour that they follow within `BAND`: the nominal, with the correction that the program carries.
    """

    path: Profile
    radius: float
    following: Bools
    error: float
    expected: CompensatedContour

    @staticmethod
    def find(
        toolpath: Toolpath, nominal: CompensatedContour, radius: float, usable: Bools, limit: float = 0.0
    ) -> Commanded:
        """Following moves of a program.

        Parameters
        ----------
        toolpath : Toolpath
        nominal : CompensatedContour
            The nominal without a correction.
        radius : float
            Distance from path to contour, mm.
        usable : (n,) bool
            Moves that may be corrected.
        limit : float
            Largest correction in mm that the program may carry; 0 for a program that was not corrected.

        Raises
        ------
        LimitError
            If no move follows the nominal, or it cannot be told which pass carries the correction.
        """
        expected = nominal
        if limit > 0:
            carried = carried_correction(toolpath, nominal, radius, usable, band=BAND, reach=limit + BAND)
            expected = CompensatedContour(nominal.profile, carried)
        parts = follow(toolpath, expected, radius, band=BAND, rows=usable)
        if not len(parts.row):
            raise LimitError(
                f"no move of the program follows the profile at {radius:g} mm: the nearest runs "
                f"{parts.distance:.3f} mm off; check --tool-diameter, --side, stock to leave and the work frame"
            )
        contours: list[Contour] = []
        for number in np.unique(parts.chain):
            mine = np.flatnonzero(parts.chain == number)
            rows = np.unique(parts.row[mine])
            backward = bool(parts.way[mine].sum() < 0)
            contours += path_profile(toolpath, rows, backward).contours
        following = np.zeros(len(toolpath), dtype=bool)
        following[parts.row] = True
        path = Profile.from_contours(_different(contours))
        return Commanded(path, radius, following, float(np.nanmax(parts.error)), expected)


def commanded_offset(commanded: Commanded, deviation: Deviation) -> Floats:
    """Offset in mm, along the normal, of the contour the program commands from the nominal at measured points.

    Parameters
    ----------
    commanded : Commanded
    deviation : Deviation

    Returns
    -------
    (n,) float64
        Positive where the program leaves material.

    Raises
    ------
    InputError
        If points were measured where the program does not cut the profile.
    """
    if not len(deviation):
        return np.zeros(0)
    # The cutter leaves what is a radius away from its path: the envelope, not the path shifted by a radius.
    search = FootPointSearch(commanded.path, margin=commanded.radius + 1.0)
    expected = commanded.expected.correction.at(deviation.stretch, deviation.s, commanded.expected.profile)
    out = expected.copy()
    for _ in range(12):
        feet = search.find(deviation.foot + out[:, None] * deviation.normal)
        step = -feet.distance - commanded.radius
        if commanded.radius == 0:
            # Beyond a corner that a correction moved back nothing is commanded any more: the side's value holds on.
            step[feet.place == Place.JOINT] = 0.0
        out += np.clip(step, -BAND, BAND)
        if np.abs(step).max() < 1e-10:
            break
    if np.abs(out - expected).max() > 2 * BAND + SAME_POINT:
        worst = int(np.argmax(np.abs(out - expected)))
        x, y = deviation.foot[worst]
        raise InputError(
            f"the program does not cut the profile near X{x:.3f} Y{y:.3f}, where points were measured: give the "
            "--operation that cuts it, or only the points that belong to it"
        )
    return np.zeros(len(deviation)) if commanded.error < EXACT else out
