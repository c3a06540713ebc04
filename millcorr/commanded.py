# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program itself commands: its side, the contour it cuts, and the surface that all its passes leave.

A measured deviation is the sum of the program's own offset from the nominal, known exactly, and of what the
machine added. Only the second is separated; the first may be a correction in force or a CAM system's error.

A program is passes. At a height the surface is what all passes that reach it leave together, the union of the
cutter's discs. So the pass that made a place is the one whose distance less its radius is the smallest, and no offset
curve is needed to know where the surface is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from .comparison.path_distance import PathDistance
from .compensation import Correction
from .deviation import REACH, Deviation, require_heights
from .errors import InputError, LimitError
from .footpoint import FootPointSearch, Place
from .measurement import Measurement
from .profile import SAME_HEIGHT, Profile, Step
from .read_only import ReadOnlyArrays
from .reconstruction import CompensatedContour
from .regeneration import BAND
from .regeneration.carried import carried_correction
from .regeneration.leads import sections
from .regeneration.path_following import follow, length_in_plane
from .theoretical_contour import SAME_POINT, CutContour, cut_at_vertices, cut_contours, cutting_runs
from .toolpath import Compensation, Kind, Plane, Toolpath

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

EXACT = 1e-6
"""A program off by less than this everywhere, in mm, commands the nominal."""

ALONG = 2.0
"""Moves nearer to a path than so many times the program's rounding run on it: of two rounded points each is off by once
as much at most."""

SPACING, PARALLEL = 1.0, 0.2
"""Moves are compared with a path every so many mm, and run along it where their directions differ by less, in rad: the
facets of one contour differ by so much."""

COVERS = 0.5
"""A pass that runs on less of a path than this share does not cut it again: it leads onto it."""

ROUGHED, UNEVEN = 0.005, 2.0
"""A pass roughs if it leaves over most of a lap more than this, in mm, and than so many times what the surface itself
wanders about a drawing: of two passes that wander alike one leaves on the other half as much as that."""

MANY, CELL, FEW_HEIGHTS = 20_000, 0.02, 50
"""Of more points than this, at few heights, the surface is looked at once in every cell of so many mm: facets are
longer, and what rounding and chords do to them is straight between."""

FEW = 0.02
"""A contour that made a smaller share of the points is not the one that was measured: that many may be outliers."""

SAMPLE = 2000
"""So many points, evenly taken, tell which contours were measured."""

NORMAL_MAD = 1.4826
"""Standard deviation of normal values in units of their median absolute deviation."""

ROUNDS = 60
"""Steps of the search for the surface; each is as long as the surface is far, so that five are usual."""


def boxes(toolpath: Toolpath) -> Floats:
    """Left, bottom, right, top of every move in mm, no arc reaching out; (n, 4)."""
    a, b = toolpath.start[:, :2], toolpath.end[:, :2]
    low, high = np.minimum(a, b), np.maximum(a, b)
    bent = np.flatnonzero(toolpath.kind == Kind.ARC)
    centre = toolpath.centre[bent, :2]
    r = np.hypot(*(a[bent] - centre).T)[:, None]
    flat = toolpath.plane[bent] == Plane.XY
    low[bent[flat]] = np.fmin(low[bent], centre - r)[flat]
    high[bent[flat]] = np.fmax(high[bent], centre + r)[flat]
    curved = np.flatnonzero(toolpath.kind == Kind.CUBIC)
    inner = toolpath.control[curved].reshape(-1, 2, 2)
    low[curved] = np.minimum(low[curved], inner.min(axis=1))
    high[curved] = np.maximum(high[curved], inner.max(axis=1))
    return np.hstack([low, high])


def rows_near(toolpath: Toolpath, points: Floats, reach: float) -> Bools:
    """Moves that come nearer than `reach` mm to the bounding box of points; (n,)."""
    box = boxes(toolpath)
    low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
    out: Bools = (box[:, :2] <= high).all(axis=1) & (box[:, 2:] >= low).all(axis=1)
    return out


@dataclass(frozen=True, eq=False, slots=True)
class CommandedSurface(ReadOnlyArrays):
    """The surface that all passes of a program leave together, on an ideal machine.

    Parameters
    ----------
    toolpath : Toolpath
    radius : (n,) float64
        Radius of the cutter of every move, mm; NaN where it is not known: such moves leave no surface here. 0 where
        the program states the contour itself (G41, G42).
    """

    toolpath: Toolpath
    radius: Floats

    def only(self, rows: Bools) -> CommandedSurface:
        """What some of the moves leave by themselves."""
        return CommandedSurface(self.toolpath, np.where(rows, self.radius, np.nan))

    def offset(self, foot: Floats, normal: Floats, z: Floats | None = None, *, reach: float = REACH) -> Floats:
        """How far the surface lies from places along their normals.

        Parameters
        ----------
        foot, normal : (n, 2) float64
            Places in mm, and unit normals out of the material.
        z : (n,) float64, optional
            Heights in mm: only passes that go so low make the surface there. None: all passes do.
        reach : float
            Moves farther than this, in mm, and the radius from all places are not looked at.

        Returns
        -------
        (n,) float64
            mm; positive where material is left. NaN where no pass comes near.
        """
        if not len(foot):
            return np.zeros(0)
        cuts = (self.toolpath.kind != Kind.RAPID) & np.isfinite(self.radius)
        largest = float(np.nanmax(self.radius, initial=0.0))
        rows = np.flatnonzero(cuts & rows_near(self.toolpath, foot, 2 * largest + 2 * reach))
        # A height that the program has not stated is below everything.
        lowest = np.nan_to_num(np.fmax(self.toolpath.start[rows, 2], self.toolpath.end[rows, 2]), nan=-np.inf)
        heights = np.unique(lowest)
        at = len(heights) if z is None else np.searchsorted(heights, z + 1e-6, side="right")
        # A point below all that is cut belongs to the deepest pass; what it means is not for this place to say.
        at = np.where(np.broadcast_to(at, len(foot)) == 0, len(heights), at)
        out = np.full(len(foot), np.nan)
        for number in np.unique(at):
            mine = np.flatnonzero(at == number)
            deep = rows[lowest <= heights[number - 1]] if len(heights) else rows
            out[mine] = self._found(deep, foot[mine], normal[mine], reach)
        lost = np.flatnonzero(np.isnan(out) & (at < len(heights)))
        if len(lost):
            # Nothing near goes so low: what made the place cannot be told by its height.
            out[lost] = self._found(rows, foot[lost], normal[lost], reach)
        return out

    def made_by(self, places: Floats) -> Ints:
        """Move of which the cutter is nearest to places (n, 2) of the surface, mm; (n,)."""
        rows = np.flatnonzero((self.toolpath.kind != Kind.RAPID) & np.isfinite(self.radius))
        least, out = np.full(len(places), np.inf), np.full(len(places), -1)
        for radius in np.unique(self.radius[rows]):
            distance, row, _ = PathDistance(self.toolpath, rows[self.radius[rows] == radius]).nearest(places)
            nearer = distance - radius < least
            least[nearer], out[nearer] = (distance - radius)[nearer], row[nearer]
        return out

    def _found(self, rows: Ints, foot: Floats, normal: Floats, reach: float) -> Floats:
        own = self.radius[rows]
        parts = [(float(r), PathDistance(self.toolpath, rows[own == r])) for r in np.unique(own)]
        t = np.zeros(len(foot))
        active = np.arange(len(foot))
        for _ in range(ROUNDS):
            place = foot[active] + t[active, None] * normal[active]
            step = np.full(len(active), np.inf)
            for radius, path in parts:
                distance, row, u = path.nearest(place)
                if radius == 0:
                    # The path is the contour: a place beyond it is in the air.
                    distance = ((self.toolpath.place(row, u) - place) * normal[active]).sum(axis=1)
                step = np.minimum(step, distance - radius)
            # The distance changes by no more than the place does, so the surface is never jumped over.
            t[active] += step
            done = (np.abs(step) < 1e-10) | (np.abs(t[active]) > reach)
            active = active[~done]
            if not len(active):
                break
        return np.where(np.abs(t) <= reach, t, np.nan)


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
    runs = cutting_runs(toolpath)
    if not runs:
        raise InputError("the program has no feed move in the XY plane that could follow a contour")
    every = np.concatenate(runs)
    points = measurement.points[:: max(1, len(measurement) // SAMPLE), :2]
    rows = every[(usable & rows_near(toolpath, points, radius + 3 * REACH))[every]]
    rows = rows if len(rows) else every[usable[every]]
    distance, row, u = PathDistance(toolpath, rows).nearest(points)
    expected = path_radius - measurement.ball_radius
    near = np.abs(distance - abs(expected)) < REACH
    if near.sum() < 0.5 * len(near) or abs(expected) < 2 * REACH:
        near = distance < radius + 2 * REACH
    ahead = toolpath.direction(row, u)
    away = points - toolpath.place(row, u)
    right = int((ahead[:, 0] * away[:, 1] - ahead[:, 1] * away[:, 0] < 0)[near].sum())
    count = int(near.sum())
    if count == 0 or max(right, count - right) < 0.9 * count:
        raise InputError(
            f"{measurement.source}: the points lie on both sides of the path or far from it ({right} right and "
            f"{count - right} left of {len(distance)}): say --side left or --side right, and check "
            "--tool-diameter, the unit and the work frame"
        )
    return 2 * right > count


def nominal_of(
    toolpath: Toolpath,
    usable: Bools,
    path_radius: float,
    material_right: bool,
    measurement: Measurement | None,
    name: str,
    doubt: Callable[[Profile], None] | None = None,
    *,
    resolution: float = 0.0,
) -> tuple[Profile, list[str], list[CutContour]]:
    """The nominal profile that a program shows: the contours that made the measured points.

    Of a wall in steps it has those that made points, and the steps between: they are one wall, and each is it at its
    own heights. Where no contour is near, `doubt` is asked first, with all contours: it may know why, and refuse with
    that.

    Returns
    -------
    Profile
    words : list of str
        What it cuts beside that.
    cut : list of CutContour
        What cuts each contour of the profile.

    Raises
    ------
    InputError
        If no contour of the program is near the measured points, or they have no height and lie on a wall in steps.
    """
    found, trouble, far = _contours_near(toolpath, usable, path_radius, material_right, measurement, resolution)
    if not found and measurement is not None:
        # Points far from everything: whatever the program cuts tells what may be wrong with them.
        found, trouble, far = _contours_near(toolpath, usable, path_radius, material_right, None, resolution)
    if not found:
        raise InputError(f"{name}: {trouble[0] if trouble else 'the program cuts no contour in the XY plane'}")
    if measurement is None:
        return Profile.from_contours([c.contour for c in found]), [], found
    found, rows, left = _in_steps(found, _made_points(found, measurement), path_radius)
    made = [found[k] for k in rows]
    if not made:
        everything = Profile.from_contours([c.contour for c in found])
        if doubt is not None:
            doubt(everything)
        feet = FootPointSearch(everything).find(measurement.points[:, :2])
        typical = float(np.median(np.abs(feet.distance - measurement.ball_radius)))
        raise InputError(
            f"{measurement.source}: the points lie typically {typical:.3f} mm off the nearest contour that {name} "
            "cuts: check --tool-diameter, --side, --points, --units, and the work frame"
        )
    for wall in {c.contour.step.wall for c in found if c.contour.step is not None}:
        steps = [c.contour for c in found if c.contour.step is not None and c.contour.step.wall == wall]
        require_heights(measurement, Profile.from_contours(steps))
    nominal = Profile.from_contours([c.contour for c in made])
    x_low, y_low, x_high, y_high = nominal.bounding_box()
    # What runs round the whole measured part clears the stock round it.
    away = sum(x0 > x_low or y0 > y_low or x1 < x_high or y1 < y_high for x0, y0, x1, y1 in far)
    others = away + _elsewhere(found, made, 2 * path_radius)
    words = []
    if left:
        listed = ", ".join(f"Z{z:g}" for z in sorted(left, reverse=True))
        words.append(f"steps of the wall without measured points, down to {listed}: left as they are")
    if others:
        contours = "another contour" if others == 1 else f"{others} other contours"
        words.append(f"the program cuts {contours} without measured points: left as it is")
    return nominal, words, made


def _probes(profile: Profile) -> tuple[Floats, Floats]:
    """Places all along a profile's first contour and the normals there, (33, 2) each: enough to tell walls apart."""
    return profile.at(0, np.linspace(0.0, float(profile.total[0]), 33))


def _elsewhere(found: list[CutContour], made: list[CutContour], reach: float) -> int:
    """How many contours are walls of their own, and no passes that rough beside a measured one.

    Such a pass faces as the wall does, or as the pass between, nearer than the width of the cut.
    """
    probes = {}
    for k, one in enumerate(found):
        if not any(one is m for m in made):
            profile = Profile.from_contours([one.contour])
            probes[k] = _probes(profile)
    beside = [one.contour for one in made]
    while beside and probes:
        search = FootPointSearch(Profile.from_contours(beside))
        beside = []
        for k, (places, normal) in list(probes.items()):
            feet = search.find(places)
            along = (np.abs(feet.distance) < max(reach, REACH)) & ((feet.normal * normal).sum(axis=1) > 0.5)
            if along.mean() > 0.5:
                beside.append(found[k].contour)
                del probes[k]
    return len(probes)


def _in_steps(found: list[CutContour], count: Ints, radius: float) -> tuple[list[CutContour], list[int], list[float]]:
    """Contours with the heights at which they are the part's, and which of them were measured.

    Parameters
    ----------
    found : list of CutContour
    count : (n,) int64
        How many points each made.
    radius : float
        Distance in mm from contour to path.

    Returns
    -------
    found : list of CutContour
        Steps of a wall of which one made points know their heights, and so do walls below a rebate.
    made : list of int
        Which make the nominal: those that made points, and the steps between two of them.
    left : list of float
        Heights in mm down to which further steps are cut, above and below all that made points.
    """
    found, total = list(found), max(1, int(count.sum()))
    made: list[int] = []
    left: list[float] = []
    seen: set[int] = set()

    @cache
    def profile(k: int) -> Profile:
        return Profile.from_contours([found[k].contour])

    for k in np.flatnonzero(count).tolist():
        if k in seen:
            continue
        steps = _steps_of_wall(found, profile, k)
        if k not in steps or len(steps) < 2:
            made += [k] if count[k] > FEW * total else []
            continue
        seen |= set(steps)
        # Of many steps each made a small share of the points; none is an outlier at another height.
        measured = [n for n, i in enumerate(steps) if count[i] > FEW / len(steps) * total]
        if count[steps].sum() <= FEW * total or not measured:
            continue
        heights = [_deepest(found[i]) for i in steps] + [np.inf]
        for n, i in enumerate(steps):
            step = Step(k, heights[n], heights[n + 1])
            found[i] = replace(found[i], contour=replace(found[i].contour, step=step))
            if measured[0] <= n <= measured[-1]:
                made.append(i)
            else:
                left.append(heights[n])
    _end_below_rebates(found, made, radius)
    return found, sorted(made), left


def _end_below_rebates(found: list[CutContour], made: list[int], radius: float) -> None:
    """Say of walls of the nominal where a pass of another one above takes them away. In place.

    A rebate narrower than the cutter is cut by a disc that stands over the wall below.
    """
    for k in made:
        contour = found[k].contour
        profile = Profile.from_contours([contour])
        places, _ = _probes(profile)
        step = contour.step or Step(k, _deepest(found[k]), np.inf)
        for other in made:
            above = _deepest(found[other])
            if not step.bottom + SAME_HEIGHT < above < step.top:
                continue
            path = found[other].path
            away = PathDistance(path, np.arange(len(path)))(places)
            if (away < radius - SAME_POINT).mean() > 0.5:
                step = replace(step, top=above)
                found[k] = replace(found[k], contour=replace(contour, step=step))
                upper = found[other].contour
                upper = replace(upper, step=upper.step or Step(other, above, np.inf))
                found[other] = replace(found[other], contour=upper)


def _steps_of_wall(found: list[CutContour], profile: Callable[[int], Profile], first: int) -> list[int]:
    """Contours that make a wall together with one of them, each at heights of its own, from the lowest up.

    They run along each other; of those that go down to a height the one deepest in the material is the wall there.
    What others cut away again, as a roughing pass, is no step.
    """

    def over(k: int, other: int) -> float:
        """How far one lies over another in mm, on average; NaN where it does not run along it."""
        places, normal = _probes(profile(k))
        feet = FootPointSearch(profile(other)).find(places)
        beside = (np.abs(feet.distance) < REACH) & ((feet.normal * normal).sum(axis=1) > 0.9)
        return float(feet.distance[beside].mean()) if beside.mean() > 0.5 else np.nan

    boxes = np.array([profile(k).bounding_box() for k in range(len(found))])
    wall, new = {first}, [first]
    while new:
        k = new.pop()
        near = (boxes[:, :2] < boxes[k, 2:] + REACH).all(axis=1) & (boxes[:, 2:] > boxes[k, :2] - REACH).all(axis=1)
        for other in np.flatnonzero(near).tolist():
            if other not in wall and np.isfinite(over(other, k)) and np.isfinite(over(k, other)):
                wall.add(other)
                new.append(other)
    steps: list[int] = []
    for k in sorted(wall, key=lambda k: _deepest(found[k])):
        if all(not over(k, lower) >= 0.0 for lower in steps):
            # Of two that go equally deep only the inner one is left of the wall.
            steps = [i for i in steps if _deepest(found[i]) < _deepest(found[k]) - SAME_HEIGHT] + [k]
    return steps


def _contours_near(
    toolpath: Toolpath,
    usable: Bools,
    path_radius: float,
    material_right: bool,
    measurement: Measurement | None,
    resolution: float,
) -> tuple[list[CutContour], list[str], set[tuple[float, ...]]]:
    """Different contours near the points; what was wrong with others; and the boxes of those far away."""
    found: list[CutContour] = []
    trouble: list[str] = []
    far: set[tuple[float, ...]] = set()
    near = np.ones(len(toolpath), dtype=bool)
    if measurement is not None:
        near = rows_near(toolpath, measurement.points[:, :2], path_radius + measurement.ball_radius + 2 * REACH)
    runs = cutting_runs(toolpath)
    chosen = np.zeros(len(toolpath), dtype=bool)
    for run in runs:
        if near[run].any() and usable[run].any():
            chosen[run] = usable[run]
        elif usable[run].any():
            ends = np.vstack([toolpath.start[run, :2], toolpath.end[run, :2]])
            far.add(tuple(np.round(np.concatenate([ends.min(axis=0), ends.max(axis=0)]), 3).tolist()))
    try:
        found = list(cut_contours(toolpath, path_radius, material_right, chosen, resolution=resolution))
    except InputError:
        # What is wrong with one run of moves is no reason to give up the others.
        found = []
        for run in runs:
            if not chosen[run].any():
                continue
            only = np.zeros(len(toolpath), dtype=bool)
            only[run] = chosen[run]
            try:
                found += list(cut_contours(toolpath, path_radius, material_right, only, resolution=resolution))
            except InputError as error:
                trouble.append(str(error))
    return _different(sorted(found, key=_deepest)), trouble, far


def _deepest(cut: CutContour) -> float:
    """Lowest height in mm of the moves that cut a contour; without bound where it is not stated."""
    return float(np.nan_to_num(cut.path.end[:, 2], nan=-np.inf).min())


def _different(cut: list[CutContour]) -> list[CutContour]:
    """Contours without repetitions: passes at several depths cut the same one. The lowest of them stands for all."""
    kept: list[tuple[CutContour, Profile, Callable[[], FootPointSearch]]] = []
    for one in cut:
        profile = Profile.from_contours([one.contour])
        probe, _ = profile.at(0, np.linspace(0.0, float(profile.total[0]), 17))
        for _, other, search in kept:
            if abs(float(other.total[0] - profile.total[0])) < 0.01:
                box, there = np.array(profile.bounding_box()), np.array(other.bounding_box())
                if np.abs(box - there).max() < 0.01 and np.abs(search().find(probe).distance).max() < 1e-3:
                    break
        else:
            kept.append((one, profile, cache(lambda p=profile: FootPointSearch(p))))
    return [one for one, _, _ in kept]


def _made_points(cut: list[CutContour], measurement: Measurement) -> Ints:
    """How many points each contour made, (n,): of those near a point the one that goes deepest into the material."""
    rows = np.arange(0, len(measurement), max(1, len(measurement) // SAMPLE))
    points, z = measurement.points[rows, :2], measurement.points[rows, 2]
    over = np.full((len(cut), len(rows)), -np.inf)
    high = np.zeros(over.shape, dtype=bool)
    for k, one in enumerate(cut):
        feet = FootPointSearch(Profile.from_contours([one.contour])).find(points)
        off = feet.distance - measurement.ball_radius
        here = (np.abs(off) < REACH) & (feet.place != Place.END)
        over[k, here] = off[here]
        if measurement.has_z:
            high[k] = z < _deepest(one) - SAME_HEIGHT
    # What does not go down to a point made it only if nothing does.
    low = np.where(high, -np.inf, over)
    over = np.where(np.isfinite(low).any(axis=0), low, over)
    owner = np.where(np.isfinite(over).any(axis=0), over.argmax(axis=0), -1)
    return np.bincount(owner[owner >= 0], minlength=len(cut))


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
    ends = np.vstack([toolpath.start[following, :2], toolpath.end[following, :2]])
    return _cut_at(toolpath, ~following, ends)


def _cut_at(toolpath: Toolpath, rows: Bools, vertices: Floats) -> tuple[Toolpath, Ints]:
    """Some of the feed moves cut where vertices lie on them."""
    feeds = np.zeros(len(toolpath), dtype=bool)
    for run in cutting_runs(toolpath):
        feeds[run] = True
    cut, rest = np.flatnonzero(feeds & rows), np.flatnonzero(~feeds | ~rows)
    parts, part_of = cut_at_vertices(toolpath.take(cut), vertices)
    if len(parts) == len(cut):
        return toolpath, np.arange(len(toolpath))
    row = np.concatenate([rest, cut[part_of]])
    order = np.argsort(row, kind="stable")
    return Toolpath.concatenate([toolpath.take(rest), parts]).take(order), row[order]


def beside_the_path(toolpath: Toolpath, following: Bools) -> Bools:
    """Moves that hang together with following moves: all between the rapids around them; (n,).

    A retraction to an unknown height (G28 Z0) goes along without being rewritten.
    """
    section = sections(toolpath)
    rapid = np.diff(section, prepend=0) > 0
    unknown = (toolpath.kind == int(Kind.RAPID)) & np.isnan(toolpath.end[:, 2])
    out: Bools = np.isin(section, section[following]) & ~rapid & ~unknown
    return out


def on_the_path(toolpath: Toolpath, usable: Bools, cut: list[CutContour], resolution: float) -> Bools:
    """Moves that run on the path of contours: the passes that cut them, at every depth, and spring passes.

    Parameters
    ----------
    toolpath : Toolpath
    usable : (n,) bool
        Moves that may be corrected.
    cut : list of CutContour
    resolution : float
        What the program's coordinates are rounded to, mm.

    Returns
    -------
    (n,) bool
        A move that runs onto the path and along it in one is among them.
    """
    band = max(ALONG * resolution, SAME_POINT)
    vertices = np.vstack([np.vstack([one.path.start[:, :2], one.path.end[:, :2]]) for one in cut])
    same = np.zeros(len(toolpath), dtype=bool)
    for tool, compensation in np.unique(
        np.concatenate([np.stack([one.path.tool, one.path.compensation], axis=1) for one in cut]), axis=0
    ):
        same |= (toolpath.tool == tool) & (toolpath.compensation == compensation)
    runs = cutting_runs(toolpath)
    rows = np.concatenate(runs) if runs else np.zeros(0, dtype=np.int64)
    rows = rows[(same & usable & rows_near(toolpath, vertices, band))[rows]]
    length = length_in_plane(toolpath.take(rows))
    count = np.clip(np.ceil(length / SPACING), 9, 400).astype(np.int64)
    which = np.repeat(np.arange(len(rows)), count)
    u = (np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count) + 0.5) / count[which]
    places, ahead = toolpath.place(rows[which], u), toolpath.direction(rows[which], u)
    section = sections(toolpath)[rows]
    out = np.zeros(len(toolpath), dtype=bool)
    for one in cut:
        distance, row, at = PathDistance(one.path, np.arange(len(one.path))).nearest(places)
        there = one.path.direction(row, at)
        parallel = np.abs(ahead[:, 0] * there[:, 1] - ahead[:, 1] * there[:, 0]) < PARALLEL
        share = np.bincount(which[(distance <= band) & parallel], minlength=len(rows)) / count
        # What only meets the path, as the lead of another pass does, covers little of it.
        covered = np.bincount(section, share * length, minlength=int(section.max(initial=0)) + 1)
        out[rows[(share > 0) & (covered[section] > COVERS * float(length_in_plane(one.path).sum()))]] = True
    return out


def roughing(
    surface: CommandedSurface,
    rows: Bools,
    nominal: Profile,
    resolution: float,
    limit: float,
    carried: Correction | None = None,
) -> Bools:
    """Moves along a profile that leave stock which others take away at the same height.

    Parameters
    ----------
    surface : CommandedSurface
    rows : (n,) bool
        Moves to look at.
    nominal : Profile
    resolution : float
        What the program's coordinates are rounded to, mm.
    limit : float
        What leaves more than this over the profile, in mm, clears and does not rough it.
    carried : Correction, optional
        What the surface is off a drawing on purpose; by default the profile is what the program itself cuts.

    Returns
    -------
    (n,) bool
        Those that run along the profile and of which no other than a small part is on the surface that all passes
        leave.
    """
    toolpath = surface.toolpath
    out = np.zeros(len(toolpath), dtype=bool)
    widest = float(np.nanmax(surface.radius, initial=0.0)) + limit
    x0, y0, x1, y1 = nominal.bounding_box()
    near = rows_near(toolpath, np.array([[x0, y0], [x1, y1]]), widest)
    cuts = (toolpath.kind != Kind.RAPID) & np.isfinite(surface.radius)
    row = np.flatnonzero(rows & cuts & near)
    if not len(row):
        return out
    u = (np.arange(9) + 0.5) / 9
    which, share = np.repeat(np.arange(len(row)), 9), np.tile(u, len(row))
    place, ahead = toolpath.place(row[which], share), toolpath.direction(row[which], share)
    z = np.fmax(toolpath.start[row, 2], toolpath.end[row, 2])[which]
    feet = FootPointSearch(nominal, margin=widest + 2.0).find(np.column_stack([place, z]))
    own = feet.distance - surface.radius[row[which]]
    parallel = np.abs((ahead * feet.normal).sum(axis=1)) < PARALLEL
    along = parallel & (feet.place == Place.SMOOTH) & (own <= limit)
    over = np.zeros(len(which), dtype=bool)
    made = surface.offset(feet.foot[along], feet.normal[along], np.nan_to_num(z[along], nan=np.inf))
    left = own[along] - made
    least = max(ALONG * resolution, ROUGHED)
    of_lap = _median_of_laps(toolpath, row[which[along]], nominal, feet.span[along], feet.t[along], left)
    wanders = 0.0
    if carried is not None and along.any():
        stretch, s = nominal.stretch[feet.span[along]], nominal.arc_length(feet.span[along], feet.t[along])
        off = made - carried.at(stretch, s, nominal)
        wanders = NORMAL_MAD * float(np.nanmedian(np.abs(off - np.nanmedian(off))))
    over[along] = (left > least) & (of_lap > max(least, UNEVEN * wanders))
    count = np.bincount(which, along, minlength=len(row))
    # Where a move touches the contour's parallel in passing, as a lead does, it does not run along it.
    out[row] = (np.bincount(which, over, minlength=len(row)) > 0.5 * count) & (count > 2)
    # What goes round a corner between two such moves belongs to them.
    corner = np.zeros(len(toolpath), dtype=bool)
    corner[row] = np.bincount(which, feet.place == Place.JOINT, minlength=len(row)) > 4
    for run in cutting_runs(toolpath) if (out & ~corner).any() and corner.any() else []:
        told = np.flatnonzero(~corner[run])
        if len(told):
            behind = told[np.clip(np.searchsorted(told, np.arange(len(run)), side="right") - 1, 0, None)]
            ahead_of = told[np.clip(np.searchsorted(told, np.arange(len(run))), None, len(told) - 1)]
            out[run] = out[run[behind]] & out[run[ahead_of]]
    return out & rows


def _median_of_laps(
    toolpath: Toolpath, row: Ints, nominal: Profile, span: Ints, t: Floats, values: Floats
) -> Floats:
    """For samples along moves, in order, the median of values over all of their lap along a contour; (n,)."""
    if not len(row):
        return values
    contour, s = nominal.contour[span], nominal.arc_length(span, t)
    total = nominal.total[contour]
    run = np.zeros(len(toolpath), dtype=np.int64)
    for k, rows in enumerate(cutting_runs(toolpath)):
        run[rows] = k
    # A lap ends with its run, too, and where the path goes from one pass to another beside it.
    step = np.abs(np.diff(s))
    step = np.minimum(step, np.abs(total[1:] - step))
    begins = np.concatenate([[True], (np.diff(run[row]) != 0) | (np.diff(contour) != 0)])
    gone = np.cumsum(np.concatenate([[0.0], step]))
    gone -= gone[begins][np.cumsum(begins) - 1]
    _, lap = np.unique(np.stack([np.cumsum(begins), np.floor(gone / total)]), axis=1, return_inverse=True)
    lap = lap.ravel()
    order = np.lexsort((values, lap))
    first = np.searchsorted(lap[order], np.arange(lap.max() + 1))
    middle = (first + np.append(first[1:], len(order))) // 2
    out: Floats = values[order[middle]][lap]
    return out


@dataclass(frozen=True, eq=False, slots=True)
class Commanded:
    """The program's own following path, where the nominal was given apart from it.

    Parameters
    ----------
    following : (n,) bool
        Moves that follow the nominal.
    expected : CompensatedContour
        Contour that they follow within `BAND`: the nominal, with the correction that the program carries.
    error : float
        By how much, in mm, they are off its exact parallel at most.
    """

    following: Bools
    expected: CompensatedContour
    error: float

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
        following = np.zeros(len(toolpath), dtype=bool)
        following[parts.row] = True
        return Commanded(following, expected, float(np.nanmax(parts.error)))


CUT_AWAY = 0.01
"""Where other moves cut deeper than those that make the profile by more than this, in mm, they make another surface:
leads run out of facets by less."""


def commanded_offset(
    surface: CommandedSurface,
    deviation: Deviation,
    z: Floats | None = None,
    expected: CompensatedContour | None = None,
    following: Bools | None = None,
) -> Floats:
    """Offset in mm, along the normal, of the surface the program commands from the nominal at measured points.

    Parameters
    ----------
    surface : CommandedSurface
    deviation : Deviation
    z : (n,) float64, optional
        Heights in mm that tell which passes made the points; by default all passes did.
    expected : CompensatedContour, optional
        Contour that the program follows within `BAND`; by default any within `REACH` of the nominal will do.
    following : (m,) bool, optional
        Moves that make the profile; by default all do.

    Returns
    -------
    (n,) float64
        Positive where the program leaves material; NaN where it does not cut the profile, or others cut it away.

    Raises
    ------
    InputError
        If most points were measured where the program does not cut the profile.
    """
    out = _at_points(surface, deviation, z)
    if expected is not None:
        there = expected.correction.at(deviation.stretch, deviation.s, expected.profile)
        out[np.abs(out - there) > 2 * BAND + SAME_POINT] = np.nan
    if following is not None:
        # A lead that cuts into the wall makes a surface of its own there.
        low = np.flatnonzero(out < -CUT_AWAY)
        made = surface.only(following).offset(deviation.foot[low], deviation.normal[low], None if z is None else z[low])
        out[low[out[low] < made - CUT_AWAY]] = np.nan
    lost = np.flatnonzero(np.isnan(out))
    # Of a program that makes the measured surface a lead may cut away a part; of another one most is elsewhere.
    if 2 * len(lost) > len(out):
        x, y = deviation.foot[lost[0]]
        raise InputError(
            f"the program does not cut the profile near X{x:.3f} Y{y:.3f}, where points were measured: give the "
            "--operation that cuts it, or only the points that belong to it"
        )
    return out


def _at_points(surface: CommandedSurface, deviation: Deviation, z: Floats | None) -> Floats:
    """Offset of a surface at measured points; of very many at one in every cell of a contour, straight between."""
    height, group = np.unique(np.zeros(len(deviation)) if z is None else z, return_inverse=True)
    if len(deviation) <= MANY or len(height) > FEW_HEIGHTS:
        return surface.offset(deviation.foot, deviation.normal, z)
    order = np.lexsort((deviation.s, group, deviation.stretch))
    row = np.stack([deviation.stretch, group, np.floor(deviation.s / CELL).astype(np.int64)], axis=1)[order]
    new = np.concatenate([[True], (np.diff(row, axis=0) != 0).any(axis=1)])
    # The last of every row of cells, too, so that nothing lies beyond.
    last = np.concatenate([(np.diff(row[:, :2], axis=0) != 0).any(axis=1), [True]])
    chosen = order[new | last]
    found = surface.offset(deviation.foot[chosen], deviation.normal[chosen], None if z is None else z[chosen])
    out = np.empty(len(deviation))
    for k, h in np.unique(row[new, :2], axis=0):
        mine = (deviation.stretch == k) & (group == h)
        there = mine[chosen]
        out[mine] = np.interp(deviation.s[mine], deviation.s[chosen][there], found[there])
    return out
