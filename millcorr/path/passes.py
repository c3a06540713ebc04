# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which passes of a program run on a contour, which of them rough, and what hangs together with them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.commanded_surface import CommandedSurface, rows_near
from millcorr.comparison.deviation import Deviation
from millcorr.comparison.path_distance import PathDistance
from millcorr.comparison.theoretical_contour import SAME_POINT, CutContour, cut_at_vertices, cutting_runs
from millcorr.errors import InputError, LimitError
from millcorr.geometry.correction import Correction
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, xy
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.earlier_correction import earlier_correction
from millcorr.path.leads import sections
from millcorr.path.moves import BAND
from millcorr.path.path_following import follow, length_in_plane
from millcorr.path.reconstruction import CompensatedContour

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

NORMAL_MAD = 1.4826
"""Standard deviation of normal values in units of their median absolute deviation."""


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
    progress.step()
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
    progress.step()
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
    beside = _Beside.of(surface, rows, nominal, limit)
    if beside is None:
        return np.zeros(len(surface.toolpath), dtype=bool)
    toolpath, along, feet = surface.toolpath, beside.along, beside.feet
    over = np.zeros(len(along), dtype=bool)
    left = beside.left
    least = max(ALONG * resolution, ROUGHED)
    of_lap = _median_of_laps(toolpath, beside.row[beside.which[along]], nominal, feet.span[along], feet.t[along], left)
    wanders = 0.0
    if carried is not None and along.any():
        stretch, s = nominal.stretch[feet.span[along]], nominal.arc_length(feet.span[along], feet.t[along])
        off = beside.made - carried.at(stretch, s, nominal)
        wanders = NORMAL_MAD * float(np.nanmedian(np.abs(off - np.nanmedian(off))))
    over[along] = (left > least) & (of_lap > max(least, UNEVEN * wanders))
    return beside.of_which(over, toolpath) & rows


def sharing(surface: CommandedSurface, rows: Bools, nominal: Profile, resolution: float) -> Bools:
    """Moves that make a part of a profile's surface together with others, as where a smaller cutter clears the corners.

    Parameters
    ----------
    surface : CommandedSurface
    rows : (n,) bool
        Moves to look at.
    nominal : Profile
    resolution : float
        What the program's coordinates are rounded to, mm.

    Returns
    -------
    (n,) bool
        Those that run along the profile and of which the most is on the surface that all passes leave.
    """
    least = max(ALONG * resolution, ROUGHED)
    beside = _Beside.of(surface, rows, nominal, least)
    if beside is None:
        return np.zeros(len(surface.toolpath), dtype=bool)
    on_it = np.zeros(len(beside.along), dtype=bool)
    on_it[beside.along] = beside.left <= least
    return beside.of_which(on_it, surface.toolpath) & rows


@dataclass(frozen=True, eq=False, slots=True)
class _Beside:
    """Moves beside a profile, looked at in nine places each.

    Rows of the moves; of every place the move, its foot point, and whether the move runs along the profile there; of
    those that do, what all passes leave over the profile and how much of it the move would leave over that, mm.
    """

    row: Ints
    which: Ints
    feet: FootPoints
    along: Bools
    made: Floats
    left: Floats

    @staticmethod
    def of(surface: CommandedSurface, rows: Bools, nominal: Profile, reach: float) -> _Beside | None:
        """Of some moves of a surface those that come nearer to a profile than their radius and `reach` mm."""
        toolpath = surface.toolpath
        widest = float(np.nanmax(surface.radius, initial=0.0)) + reach
        x0, y0, x1, y1 = nominal.bounding_box()
        near = rows_near(toolpath, np.array([[x0, y0], [x1, y1]]), widest)
        cuts = (toolpath.kind != Kind.RAPID) & np.isfinite(surface.radius)
        row = np.flatnonzero(rows & cuts & near)
        if not len(row):
            return None
        u = (np.arange(9) + 0.5) / 9
        which, share = np.repeat(np.arange(len(row)), 9), np.tile(u, len(row))
        place, ahead = toolpath.place(row[which], share), toolpath.direction(row[which], share)
        z = np.fmax(toolpath.start[row, 2], toolpath.end[row, 2])[which]
        feet = FootPointSearch(nominal, margin=widest + 2.0).find(np.column_stack([place, z]))
        own = feet.distance - surface.radius[row[which]]
        parallel = np.abs((ahead * feet.normal).sum(axis=1)) < PARALLEL
        along: Bools = parallel & (feet.place == Place.SMOOTH) & (own <= reach)
        made = surface.offset(feet.foot[along], feet.normal[along], np.nan_to_num(z[along], nan=np.inf))
        return _Beside(row, which, feet, along, made, own[along] - made)

    def of_which(self, so: Bools, toolpath: Toolpath) -> Bools:
        """Moves of which most places along the profile are so, and those that go round corners between them; (n,)."""
        row, which, out = self.row, self.which, np.zeros(len(toolpath), dtype=bool)
        count = np.bincount(which, self.along, minlength=len(row))
        # Where a move touches the contour's parallel in passing, as a lead does, it does not run along it.
        out[row] = (np.bincount(which, so, minlength=len(row)) > 0.5 * count) & (count > 2)
        corner = np.zeros(len(toolpath), dtype=bool)
        corner[row] = np.bincount(which, self.feet.place == Place.JOINT, minlength=len(row)) > 4
        for run in cutting_runs(toolpath) if (out & ~corner).any() and corner.any() else []:
            told = np.flatnonzero(~corner[run])
            if len(told):
                behind = told[np.clip(np.searchsorted(told, np.arange(len(run)), side="right") - 1, 0, None)]
                ahead_of = told[np.clip(np.searchsorted(told, np.arange(len(run))), None, len(told) - 1)]
                out[run] = out[run[behind]] & out[run[ahead_of]]
        return out


def _median_of_laps(toolpath: Toolpath, row: Ints, nominal: Profile, span: Ints, t: Floats, values: Floats) -> Floats:
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
            carried = earlier_correction(toolpath, nominal, radius, usable, band=BAND, reach=limit + BAND)
            expected = CompensatedContour(nominal.profile, carried)
        parts = follow(toolpath, expected, radius, band=BAND, rows=usable)
        if not len(parts.row):
            raise LimitError(
                phrase(
                    "no move of the program follows the profile at {}: the nearest runs {} off; check {}, {}, "
                    "stock to leave and the work frame",
                    mm(radius, "g"),
                    mm(parts.distance),
                    option("tool_diameter"),
                    option("side"),
                ),
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
            phrase(
                "the program does not cut the profile near {}, where points were measured: give the {} that "
                "cuts it, or only the points that belong to it",
                xy(x, y),
                option("operation"),
            ),
            place=(float(x), float(y)),
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
