# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement of the cutter along a program: which part of its circle cuts, and how much it takes.

Source: petrakov-2023, section 5.1: cutting arc and undeformed area at every step, the stock carried forward.
Works for flank milling with a cylindrical cutter, in passes at constant height (ramps and helices in steps of the
program's heights). Only feed moves cut.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from millcorr import nc, progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import at_z, phrase, xy
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.process.setup_file import STOCK_ENDS, Setup

from .path_pieces import Pieces, pieces_of_toolpath
from .stock_region import StockRegion, Swept, prolonged
from .uncut_arc import JOINED, NOTHING, Past, Steps, layer, past_of, uncut

STEP = 0.25
"""Largest distance between steps along the path, in mm."""

LEVEL = 1e-3
"""Heights that differ by less than this, in mm, are one."""

MOST_LEVELS = 400
"""A program with more heights is no program of flank milling."""

SMOOTH = np.radians(1.0)
"""A joint that turns less has one step, in the direction of the move that ends there; a corner has two."""


@dataclass(frozen=True, eq=False, slots=True)
class Engagement(ReadOnlyArrays):
    """Engagement at steps along a program, one row a step.

    Immersion angles are counted in the sense of the spindle from the side where a tooth's chip is nil: for a
    clockwise spindle from the left of the direction of travel (0) over the front (pi/2) to the right (pi), so
    that the chip is ``f_t sin(angle)``; up milling starts at 0, down milling ends at pi.

    Parameters
    ----------
    s : (n,) float64
        Length of cutting moves so far, mm.
    position : (n, 3) float64
        Cutter centre and tip in mm.
    direction : (n,) float64
        Direction of travel in rad.
    move : (n,) int64
        Row of the toolpath.
    t : (n,) float64
        Part of the move behind, 0..1.
    feed_per_tooth : (n,) float64
        f_t in mm.
    entry, exit : (n,) float64
        First and last immersion angle in rad; NaN in air.
    phi : (n,) float64
        Engaged arc in rad, gaps left out: the largest of all heights; 0 in air.
    area : (n,) float64
        Undeformed area ``b f_t (cos entry - cos exit)`` in mm^2, over all arcs and heights
        (petrakov-2023, eq. 4; for one arc from 0 it is ``b f_t (1 - cos phi_max)``).
    mrr : (n,) float64
        Material removal rate in mm^3/s.
    first : (n + 1,) int64
        Arcs of step i are rows first[i] to first[i + 1] of the next three.
    arc_entry, arc_exit : (m,) float64
        Immersion angles of every engaged arc in rad.
    arc_low, arc_high : (m,) float64
        Heights in mm between which the arc is engaged.
    clockwise : bool
        Sense of the spindle.
    radius : float
        Radius in mm that the program was made for.
    oversize : float
        How much farther than that the cutter cuts, mm: what is engaged is so much more.
    """

    s: Floats
    position: Floats
    direction: Floats
    move: Ints
    t: Floats
    feed_per_tooth: Floats
    entry: Floats
    exit: Floats
    phi: Floats
    area: Floats
    mrr: Floats
    first: Ints
    arc_entry: Floats
    arc_exit: Floats
    arc_low: Floats
    arc_high: Floats
    clockwise: bool
    radius: float
    oversize: float

    def __len__(self) -> int:
        return len(self.s)

    @property
    def arc_step(self) -> Ints:
        """Step of every engaged arc; (m,)."""
        return np.repeat(np.arange(len(self)), np.diff(self.first))

    @property
    def arc_depth(self) -> Floats:
        """Height b over which every arc is engaged, mm; (m,)."""
        out: Floats = self.arc_high - self.arc_low
        return out


@dataclass(frozen=True, eq=False, slots=True)
class CutterPath:
    """The moves of a program that can cut, as pieces, with the steps at which they are looked at.

    Parameters
    ----------
    toolpath : Toolpath
    pieces : Pieces
    steps : Steps
    position : (n, 3) float64
        Place of every step in mm.
    s, t : (n,) float64
        Path length in mm, and part of the move, of every step.
    levels : (k,) float64
        Heights of the slices' lower faces in mm, ascending.
    top : float
        Height of the stock's face, mm.
    """

    toolpath: Toolpath
    pieces: Pieces
    steps: Steps
    position: Floats
    s: Floats
    t: Floats
    levels: Floats
    top: float

    @staticmethod
    def of(toolpath: Toolpath, setup: Setup, step: float = STEP) -> CutterPath:
        """Pieces and steps of a program; errors as `engagement`."""
        if not (np.isfinite(step) and step > 0):
            raise UsageError(f"engagement: a step of {step!r} mm is not positive")
        known = np.isfinite(toolpath.end[:, :2]).all(axis=1)
        rows = np.flatnonzero((toolpath.kind != Kind.RAPID) & known)
        moving = (toolpath.start[rows] != toolpath.end[rows]).any(axis=1) | (toolpath.sweep[rows] != 0)
        tools = np.unique(toolpath.tool[rows[moving]])
        if len(tools) > 1:
            names = ", ".join(f"T{t}" if t >= 0 else "none called" for t in tools)
            raise InputError(
                phrase("engagement: the program cuts with several tools ({}): give the moves of one", names)
            )
        pieces = pieces_of_toolpath(toolpath, rows[moving])
        levels, top, pieces = _levels(pieces, setup)
        length = pieces.length
        if not (length > 0).any():
            raise InputError(phrase("engagement: the program has no cutting move in the XY plane"))
        piece, u = _places(pieces, length, step)
        centre = pieces.point(piece, u)
        tangent = pieces.tangent(piece, u)
        z = pieces.z0[piece] + u * (pieces.z1 - pieces.z0)[piece]
        before = np.cumsum(length) - length
        return CutterPath(
            toolpath,
            pieces,
            Steps(centre, np.arctan2(tangent[:, 1], tangent[:, 0]), piece, u),
            np.column_stack([centre, z]),
            before[piece] + u * length[piece],
            pieces.t0[piece] + u * (pieces.t1 - pieces.t0)[piece],
            levels,
            top,
        )

    def feed_per_tooth(self, setup: Setup) -> Floats:
        """Feed per tooth at every step in mm; (n,), NaN where the program states no feed."""
        out: Floats = self.toolpath.feed[self.pieces.owner[self.steps.piece]] / setup.tool.tooth_frequency
        return out

    def slices(self) -> list[tuple[float, float, Bools, Bools, Pieces]]:
        """For every height: lower and upper face in mm, the steps and the pieces that reach it, pieces cut to it."""
        faces = np.append(self.levels, self.top)
        out = []
        for low, high in zip(faces[:-1], faces[1:], strict=True):
            middle = (low + high) / 2
            z0, z1 = self.pieces.z0, self.pieces.z1
            here = np.minimum(z0, z1) <= middle
            pieces = self.pieces
            ramp = here & (np.maximum(z0, z1) > middle)
            if ramp.any():
                u = (middle - z0) / np.where(ramp, z1 - z0, 1.0)
                pieces = pieces.part(np.where(ramp & (z0 > middle), u, 0.0), np.where(ramp & (z1 > middle), u, 1.0))
            out.append((float(low), float(high), self.position[:, 2] <= middle, here, pieces))
        return out


def engagement(toolpath: Toolpath, setup: Setup, stock: StockRegion, *, step: float = STEP) -> Engagement:
    """Engagement along every feed move of a program.

    Parameters
    ----------
    toolpath : Toolpath
        Path of the cutter's centre.
    setup : Setup
        Tool and heights.
    stock : StockRegion
        What is there before; see `stock_of`.
    step : float
        Largest distance between steps in mm. Every move has steps at its ends; at a corner there is one for each
        direction.

    Returns
    -------
    Engagement

    Raises
    ------
    InputError
        If the program has no cutting move, uses G41 or G42, cuts arcs out of the XY plane or from an unknown place,
        has too many heights, or cuts with several tools.
    UsageError
        If the step is not positive.
    """
    path = CutterPath.of(toolpath, setup, step)
    return engaged(path, setup, arcs_of(path, setup, stock))


@dataclass(frozen=True, eq=False, slots=True)
class GivenWay:
    """Where a cutter that gives way really is, in place of the commanded path.

    Parameters
    ----------
    centre : (n, 2) float64
        Its centre at every step, mm.
    pieces : Pieces
        Its path; `owner` is the step that a piece leads to.
    known : (n,) int64
        Pieces before this row are behind a step, not counting those that have just led to it: what these cover is
        taken from the commanded path, whose direction does not jump with the force.
    """

    centre: Floats
    pieces: Pieces
    known: Ints


@dataclass(frozen=True, eq=False, slots=True)
class Arcs:
    """Engaged arcs, in the order of steps, all (m,).

    Parameters
    ----------
    step : int64
    low, high : float64
        Angles in rad from the direction of travel, positive to its left.
    low_z, high_z : float64
        Heights in mm between which the arc is engaged.
    layer : float64
        Thickness in mm of the material before the arc's middle, at most a feed per tooth; inf for a rigid cutter.
    """

    step: Ints
    low: Floats
    high: Floats
    low_z: Floats
    high_z: Floats
    layer: Floats


def arcs_of(
    path: CutterPath, setup: Setup, stock: StockRegion, actual: GivenWay | None = None, only: Ints | None = None
) -> Arcs:
    """Engaged arcs of every step, or `only` of some, ascending."""
    radius = setup.tool.cutting_radius
    found = []
    for low, high, cutting, here, clipped in path.slices():
        progress.step()
        rows = np.flatnonzero(cutting) if only is None else only[cutting[only]]
        steps = path.steps.take(rows)
        past = past_of(steps, clipped, here, radius)
        if actual is not None:
            steps = replace(steps, centre=actual.centre[rows])
            reach = path.position[actual.pieces.owner, 2] <= (low + high) / 2
            known = np.concatenate([[0], np.cumsum(reach)])[actual.known[rows]]
            past = Past(actual.pieces.take(reach), known, past.own)
        arc = uncut(steps, past, radius, stock, (low + high) / 2)
        thick = np.full(len(arc[0]), np.inf)
        if actual is not None:
            thick = layer(steps, past, radius, arc, float(np.nanmax(path.feed_per_tooth(setup), initial=0.0)))
        found.append((rows[arc[0]], arc[1], arc[2], np.full(len(thick), low), np.full(len(thick), high), thick))
    columns = [np.concatenate([f[i] for f in found]) for i in range(6)]
    order = np.lexsort((columns[1], columns[3], columns[0]))
    return Arcs(*(c[order] for c in columns))


def engaged(path: CutterPath, setup: Setup, arcs: Arcs) -> Engagement:
    """Engagement of arcs that `arcs_of` found."""
    step, low, high, low_z, high_z = arcs.step, arcs.low, arcs.high, arcs.low_z, arcs.high_z
    n = len(path.steps)
    clockwise = setup.tool.rotation == "clockwise"
    begin, end = (np.pi / 2 - high, np.pi / 2 - low) if clockwise else (np.pi / 2 + low, np.pi / 2 + high)
    begin, end = np.maximum(begin, 0.0), np.minimum(end, np.pi)
    per_tooth = path.feed_per_tooth(setup)
    depth = high_z - low_z
    width = depth * (np.cos(begin) - np.cos(end))
    width = np.bincount(step, width, minlength=n)
    entry, exit_ = np.full(n, np.inf), np.full(n, -np.inf)
    np.minimum.at(entry, step, begin)
    np.maximum.at(exit_, step, end)
    # The arc of one height: arcs of a step are sorted by height.
    new = np.ones(len(step), dtype=bool)
    new[1:] = (step[1:] != step[:-1]) | (low_z[1:] != low_z[:-1])
    phi = np.zeros(n)
    if len(step):
        group = np.flatnonzero(new)
        np.maximum.at(phi, step[group], np.add.reduceat(end - begin, group))
    air = phi <= NOTHING
    return Engagement(
        path.s.copy(),
        path.position.copy(),
        path.steps.direction.copy(),
        path.pieces.owner[path.steps.piece],
        path.t.copy(),
        per_tooth,
        np.where(air, np.nan, entry),
        np.where(air, np.nan, exit_),
        phi,
        np.where(width > 0, per_tooth * width, 0.0),
        np.where(width > 0, per_tooth * setup.tool.tooth_frequency * setup.tool.cutting_radius * width, 0.0),
        np.concatenate([[0], np.cumsum(np.bincount(step, minlength=n))]).astype(np.int64),
        begin,
        end,
        low_z,
        high_z,
        clockwise,
        setup.tool.radius,
        setup.tool.oversize,
    )


def load_ratio(engagement: Engagement, at: int | ArrayLike) -> Floats:
    """Load along the path over the load where the part was touched, ``k[i] = sq[i] / sq*``.

    Parameters
    ----------
    engagement : Engagement
    at : int or (x, y)
        Step of the touch; or a place in mm: then the step whose cutter is nearest to touching it.

    Returns
    -------
    (n,) float64
        Source: petrakov-2023, eq. 11.

    Raises
    ------
    UsageError
        If there is no such step, or the cutter takes nothing there.
    """
    step = int(at) if np.ndim(at) == 0 else _touching(engagement, np.asarray(at, dtype=float))  # type: ignore[arg-type]
    if not -len(engagement) <= step < len(engagement):
        raise UsageError(f"load ratio: there is no step {step}, the engagement has {len(engagement)}")
    reference = float(engagement.area[step])
    if not reference > 0:
        x, y, _ = engagement.position[step]
        raise UsageError(phrase("load ratio: the cutter takes nothing at {}, where the part was touched", xy(x, y)))
    out: Floats = engagement.area / reference
    return out


def _touching(engagement: Engagement, place: Floats) -> int:
    away = np.hypot(*(engagement.position[:, :2] - place).T)
    cutting = np.flatnonzero(engagement.area > 0)
    if not len(cutting):
        raise UsageError(phrase("load ratio: the program cuts only air"))
    return int(cutting[np.argmin(np.abs(away[cutting] - engagement.radius))])


def stock_of(setup: Setup, nominal: Profile | None = None) -> StockRegion:
    """The stock that a setup describes.

    Parameters
    ----------
    setup : Setup
    nominal : Profile, optional
        Needed for an even allowance.

    Raises
    ------
    UsageError
        If the allowance has no nominal profile.
    FormatError
        If a file of the setup cannot be read.
    """
    stock = setup.stock
    if stock.allowance_mm is not None:
        if nominal is None:
            raise UsageError(phrase("setup: [stock] allowance_mm needs the nominal profile it lies on"))
        return StockRegion(_ended(nominal, setup), stock.allowance_mm)
    if stock.contour is not None:
        return StockRegion(_ended(Profile.read_json(stock.contour), setup))
    if stock.program is not None:
        before = nc.read(stock.program).toolpath
        rows = np.flatnonzero((before.kind != Kind.RAPID) & np.isfinite(before.end[:, :2]).all(axis=1))
        pieces = pieces_of_toolpath(before, rows, where=str(stock.program))
        radius = stock.program_tool_diameter_mm / 2 if stock.program_tool_diameter_mm else setup.tool.cutting_radius
        return StockRegion(None, 0.0, (Swept(pieces, radius),))
    return StockRegion()


def _ended(profile: Profile, setup: Setup) -> Profile:
    """A contour of the stock as it ends, or goes on farther than a cutter at its ends can reach."""
    if setup.stock.end == STOCK_ENDS[0]:
        return profile
    return prolonged(profile, 2.0 * setup.tool.diameter_mm + (setup.stock.allowance_mm or 0.0))


def _levels(pieces: Pieces, setup: Setup) -> tuple[Floats, float, Pieces]:
    """Heights of the passes and of the stock's face; heights never stated become the lowest one."""
    z = np.concatenate([pieces.z0, pieces.z1])
    stated = np.isfinite(z)
    stock = setup.stock
    lowest = float(z[stated].min()) if stated.any() else 0.0
    if not stated.any() and stock.axial_depth_mm is None:
        raise InputError(
            phrase("engagement: the program states no Z: give [stock] axial_depth_mm in place of top_z_mm")
        )
    top = lowest + stock.axial_depth_mm if stock.axial_depth_mm is not None else float(stock.top_z_mm or 0.0)
    heights = np.unique(z[stated & (z < top - LEVEL)]) if stated.any() else np.array([lowest])
    if not len(heights):
        raise InputError(
            phrase(
                "engagement: the program stays above the stock's face at {}: check [stock] top_z_mm",
                at_z(top),
            )
        )
    heights = heights[np.concatenate([[True], np.diff(heights) > LEVEL])]
    if len(heights) > MOST_LEVELS:
        raise InputError(
            phrase(
                "engagement: the program cuts at {} heights, more than {}: it is no flank milling",
                len(heights),
                MOST_LEVELS,
            )
        )
    setup.require_overhang(top - lowest)

    def snapped(values: Floats) -> Floats:
        values = np.where(np.isfinite(values), values, lowest)
        k = np.clip(np.searchsorted(heights, values + LEVEL, side="right") - 1, 0, len(heights) - 1)
        out: Floats = np.where(np.abs(values - heights[k]) <= LEVEL, heights[k], values)
        return out

    moved = Pieces(
        pieces.start, pieces.end, pieces.centre, pieces.radius, pieces.sweep, pieces.owner, pieces.t0, pieces.t1,
        snapped(pieces.z0), snapped(pieces.z1),
    )  # fmt: skip
    return heights, top, moved


def _places(pieces: Pieces, length: Floats, step: float) -> tuple[Ints, Floats]:
    """Pieces and parts of the steps: evenly along every piece, both ends included, smooth joints once."""
    count = np.where(length > 0, np.ceil(length / step - 1e-9), -1).astype(np.int64)
    count = np.where(length > 0, np.maximum(count, 1), -1)
    piece = np.repeat(np.arange(len(pieces)), count + 1)
    k = np.arange(len(piece)) - np.repeat(np.cumsum(count + 1) - (count + 1), count + 1)
    u = k / count[piece]
    rows = np.arange(len(pieces))
    first, last = pieces.tangent(rows, np.zeros(len(rows))), pieces.tangent(rows, np.ones(len(rows)))
    turn = np.abs(
        np.arctan2(last[:-1, 0] * first[1:, 1] - last[:-1, 1] * first[1:, 0], (last[:-1] * first[1:]).sum(axis=1))
    )
    joined = np.hypot(*(pieces.start[1:] - pieces.end[:-1]).T) <= JOINED
    smooth = np.concatenate([[False], joined & (turn < SMOOTH) & (length[1:] > 0) & (length[:-1] > 0)])
    keep = ~((k == 0) & smooth[piece])
    return piece[keep], u[keep]
