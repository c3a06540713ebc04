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

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.profile import Profile, Step
from millcorr.messages import at_z, joined, message, mm, option, phrase, remedy
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath
from millcorr.readers.measurement import Measurement
from millcorr.tolerances import EXACT

from .deviation import REACH, require_heights
from .path_distance import PathDistance
from .theoretical_contour import SAME_POINT, CutContour, cut_contours, cutting_runs

FEW = 0.02
"""A contour that made a smaller share of the points is not the one that was measured: that many may be outliers."""

SAMPLE = 2000
"""So many points, evenly taken, tell which contours were measured."""

CENTRED = 0.25
"""Centres of a ball as large as the cutter, but for this in mm, lie on the path: parts are off by so much."""

CLEARED = 0.01
"""Where another pass comes nearer to a wall than this, in mm, less than the radius, it takes the wall away."""

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
    left, bottom, right, top = boxes(toolpath).T
    low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
    out: Bools = (left <= high[0]) & (bottom <= high[1]) & (right >= low[0]) & (top >= low[1])
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
            progress.step()
            place = foot[active] + t[active, None] * normal[active]
            step = np.full(len(active), np.inf)
            for radius, path in parts:
                progress.step()
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
) -> Bools:
    """Whether the material lies to the right of the direction of travel of every move; (n,).

    Passes back and forth along a contour have it on one side by turns: each run of moves is asked by itself.

    Parameters
    ----------
    toolpath : Toolpath
    usable : (n,) bool
        Moves that may be corrected.
    side : {'auto', 'left', 'right'}
        Side of the contour on which the cutter runs, seen in its direction; auto: from G41 or G42, else from the
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
        return np.full(len(toolpath), side == "left")
    if (toolpath.compensation[usable] != Compensation.OFF).any():
        compensated: Bools = toolpath.compensation == Compensation.LEFT
        return compensated
    out = np.zeros(len(toolpath), dtype=bool)
    if measurement is None:
        return out
    runs = cutting_runs(toolpath)
    if not runs:
        raise InputError(phrase("the program has no feed move in the XY plane that could follow a contour"))
    every = np.concatenate(runs)
    run_of = np.zeros(len(toolpath), dtype=np.int64)
    run_of[every] = np.repeat(np.arange(len(runs)), [len(run) for run in runs])
    step = max(1, len(measurement) // SAMPLE)
    points = measurement.points[::step, :2]
    rows = every[(usable & rows_near(toolpath, points, radius + 3 * REACH))[every]]
    rows = rows if len(rows) else every[usable[every]]
    finishing = _finishing(toolpath, rows, run_of)
    distance, row, u = PathDistance(toolpath, finishing).nearest(points)
    expected = path_radius - measurement.ball_radius
    near = np.abs(distance - abs(expected)) < REACH
    if near.sum() < 0.5 * len(near) or abs(expected) < 2 * REACH:
        near = distance < radius + 2 * REACH
    ahead = toolpath.direction(row, u)
    away = points - toolpath.place(row, u)
    centred = abs(expected) < CENTRED
    if centred:
        normals = None if measurement.normals is None else measurement.normals[::step, :2]
        away = _left_by_the_path(toolpath, rows, row, u, radius) if normals is None else -normals
    vote = np.sign(away[:, 0] * ahead[:, 1] - away[:, 1] * ahead[:, 0])
    near &= vote != 0
    right, count = int((vote[near] > 0).sum()), int(near.sum())
    mostly = 2 * right > count
    votes = np.bincount(run_of[row[near]], vote[near], minlength=len(runs))
    asked = np.bincount(run_of[row[near]], minlength=len(runs))
    # A few points tell nothing of a run: they may be outliers.
    tell = asked > FEW * count
    sides = np.where(tell, votes > 0, mostly)
    if centred and 2 * count < len(vote):
        raise InputError(
            phrase(
                "{}: the ball is as large as the cutter, so its centres lie on the path and do not tell the "
                "side of the material: say {} or {}",
                measurement.source,
                remedy("side", "left"),
                remedy("side", "right"),
            ),
        )
    if count == 0 or (sides[run_of[row[near]]] == (vote[near] > 0)).sum() < 0.9 * count:
        raise InputError(
            phrase(
                "{}: the points lie on both sides of the path or far from it ({} right and {} left of {}): "
                "say {} or {}, and check {}, the unit and the work frame",
                measurement.source,
                right,
                count - right,
                len(distance),
                remedy("side", "left"),
                remedy("side", "right"),
                option("tool_diameter"),
            ),
        )
    others = finishing[~tell[run_of[finishing]]]
    if len(others) and (sides != mostly).any():
        # What no point is nearest to, as a pass above another one, goes as those beside it do, or against them.
        told = finishing[tell[run_of[finishing]]]
        middle, along = np.full(len(others), 0.5), PathDistance(toolpath, told)
        _, beside, at = along.nearest(toolpath.place(others, middle))
        with_it = (toolpath.direction(others, middle) * toolpath.direction(beside, at)).sum(axis=1) > 0
        total = np.bincount(run_of[others], np.where(with_it == sides[run_of[beside]], 1, -1), minlength=len(runs))
        sides = np.where(tell | (total == 0), sides, total > 0)
    out[every] = sides[run_of[every]]
    return out


def _left_by_the_path(toolpath: Toolpath, rows: Ints, row: Ints, u: Floats, radius: float) -> Floats:
    """From places on moves towards the side where a wall is left, (n, 2); 0 where there is one on both or on none.

    Where the other passes clear one side there is none.
    """
    ahead, place, path = toolpath.direction(row, u), toolpath.place(row, u), PathDistance(toolpath, rows)
    left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    stays = [path(place + side * radius * left) > radius - CLEARED for side in (1.0, -1.0)]
    out: Floats = (stays[0].astype(np.float64) - stays[1])[:, None] * left
    return out


def _finishing(toolpath: Toolpath, rows: Ints, run_of: Ints) -> Ints:
    """Of rows those at the lowest height of their runs: on the way down a ramp may go to and fro."""
    height = np.nan_to_num(np.fmax(toolpath.start[rows, 2], toolpath.end[rows, 2]), nan=-np.inf)
    lowest = np.full(int(run_of.max(initial=0)) + 1, np.inf)
    np.minimum.at(lowest, run_of[rows], height)
    out: Ints = rows[height <= lowest[run_of[rows]] + EXACT]
    return out


def nominal_of(
    toolpath: Toolpath,
    usable: Bools,
    path_radius: float,
    material_right: bool | Bools,
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
        raise InputError(f"{name}: ", trouble[0] if trouble else phrase("the program cuts no contour in the XY plane"))
    if measurement is None:
        found = [c for c in found if not c.aside]
        return Profile.from_contours([c.contour for c in found]), [], found
    count = _made_points(found, measurement)
    stays = [k for k, one in enumerate(found) if not one.aside or count[k] > FEW * count.sum()]
    found, rows, left = _in_steps([found[k] for k in stays], count[stays], path_radius)
    made = [found[k] for k in rows]
    if not made:
        everything = Profile.from_contours([c.contour for c in found])
        if doubt is not None:
            doubt(everything)
        feet = FootPointSearch(everything).find(measurement.points[:, :2])
        typical = float(np.median(np.abs(feet.distance - measurement.ball_radius)))
        raise InputError(
            phrase(
                "{}: the points lie typically {} off the nearest contour that {} cuts: check {}, {}, {}, {}, "
                "and the work frame",
                measurement.source,
                mm(typical, ".3f"),
                name,
                option("tool_diameter"),
                option("side"),
                option("points"),
                option("units"),
            ),
        )
    for wall in {c.contour.step.wall for c in found if c.contour.step is not None}:
        steps = [c.contour for c in found if c.contour.step is not None and c.contour.step.wall == wall]
        require_heights(measurement, Profile.from_contours(steps))
    nominal = Profile.from_contours([c.contour for c in made])
    x_low, y_low, x_high, y_high = nominal.bounding_box()
    # What runs round the whole measured part clears the stock round it.
    away = sum(x0 > x_low or y0 > y_low or x1 < x_high or y1 < y_high for x0, y0, x1, y1 in far)
    others = away + _elsewhere(found, made, 2 * path_radius)
    words: list[str] = []
    if left:
        listed = joined([message(at_z(z)) for z in sorted(left, reverse=True)])
        words.append(phrase("steps of the wall without measured points, down to {}: left as they are", listed))
    if others:
        contours = phrase("another contour") if others == 1 else phrase("{} other contours", others)
        words.append(phrase("the program cuts {} without measured points: left as it is", contours))
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
        progress.step()
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
            if not step.bottom + EXACT < above < step.top:
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
        progress.step()
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
            steps = [i for i in steps if _deepest(found[i]) < _deepest(found[k]) - EXACT] + [k]
    return steps


def _contours_near(
    toolpath: Toolpath,
    usable: Bools,
    path_radius: float,
    material_right: bool | Bools,
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
                trouble.append(error.message)
    return _different(sorted(found, key=_deepest)), trouble, far


def _deepest(cut: CutContour) -> float:
    """Lowest height in mm of the moves that cut a contour; without bound where it is not stated."""
    return float(np.nan_to_num(cut.path.end[:, 2], nan=-np.inf).min())


def _different(cut: list[CutContour]) -> list[CutContour]:
    """Contours without repetitions: passes at several depths cut the same one. The lowest of them stands for all."""
    kept: list[tuple[CutContour, Profile]] = []
    for one in cut:
        profile = Profile.from_contours([one.contour])
        probe, _ = profile.at(0, np.linspace(0.0, float(profile.total[0]), 17))
        for _, other in kept:
            if abs(float(other.total[0] - profile.total[0])) < 0.01:
                boxes = np.array([profile.bounding_box(), other.bounding_box()])
                if np.ptp(boxes, axis=0).max() < 0.01:
                    if np.abs(FootPointSearch(other).find(probe).distance).max() < 1e-3:
                        break
        else:
            kept.append((one, profile))
    return [one for one, _ in kept]


def _made_points(cut: list[CutContour], measurement: Measurement) -> Ints:
    """How many points each contour made, (n,): of those near a point the one that goes deepest into the material.

    What is cut aside, as on the way to one, made only points that no other is near to.
    """
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
            high[k] = z < _deepest(one) - EXACT
    # What does not go down to a point made it only if nothing does.
    low = np.where(high, -np.inf, over)
    over = np.where(np.isfinite(low).any(axis=0), low, over)
    aside = np.array([one.aside for one in cut])
    over[np.ix_(aside, np.isfinite(over[~aside]).any(axis=0))] = -np.inf
    owner = np.where(np.isfinite(over).any(axis=0), over.argmax(axis=0), -1)
    return np.bincount(owner[owner >= 0], minlength=len(cut))
