# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error of a wall at every height: the tool's deflection at the moment in which an edge makes the surface there.

With a helix the edge makes the wall from the bottom up while other parts of it are still, or again, in the cut. At
each height counts the deflection at the moment when the edge at that height stands at immersion pi (down milling) or 0
(up milling): the force then acting at every height a, times what the tool bends at z per force at a (dat-2025, eqs. 2
and 3, with the force spread over the edge rather than at one height).

The elastic loop is closed in its steady state, pass after pass alike: the chip between two teeth that bend alike is
``f_t sin(phi)``, whatever they bend, and what the deflection changes is where an edge enters (or leaves) the stock. The
transition of the first few teeth after a change, and chatter, are not in it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError, RefusedError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import joined, mm, phrase, um, xy
from millcorr.process.cutting import chip_thickness, cutting, force_at, force_of_chip
from millcorr.process.engagement import Engagement, engagement
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.fixed_point import FixedPoint
from millcorr.process.setup_file import Setup
from millcorr.process.stiffness import compliance_at

from .cantilever import Cantilever
from .real_path import RealPath

TOLERANCE = 1e-7
"""The loop is closed when deflections change by less than this from one round to the next, in mm."""

ROUNDS = 60

BAND = 0.05
"""An engaged arc is cut into bands of height, no higher than this part of the overhang: within one, the tool bends
alike to 8 %, and where its edge enters the stock follows its middle."""

LAG = 0.02
"""The edge turns by no more than this over a band, in rad: force rises from nothing to all while an edge enters."""

NEAR_END = 0.2
"""An edge farther than this from where it enters or leaves the stock, in rad, feels nothing of how that moves."""

NODES = 3
"""Gauss nodes on either side of the height looked at, in every band: exact for the cantilever's cubic, and for sines
over `LAG` but for its sixth power."""

PORTION = 4096
"""So many queries are integrated at once, to bound the memory."""

_WALL = 1e-6
"""An arc that ends nearer than this to 0 or pi, in rad, makes a wall."""

_AT = 1e-9
_SHIFT = (1e-3, 0.05)


@dataclass(frozen=True, eq=False, slots=True)
class Arcs:
    """Engaged arcs in bands of height, one row a band.

    Parameters
    ----------
    step : (m,) int64
        Step of the engagement, not decreasing.
    entry, exit : (m,) float64
        Immersion angles in rad.
    low, high : (m,) float64
        Heights above the tip in mm.
    """

    step: Ints
    entry: Floats
    exit: Floats
    low: Floats
    high: Floats

    def __len__(self) -> int:
        return len(self.step)

    @property
    def middle(self) -> Floats:
        """Height of the middle above the tip in mm; (m,)."""
        out: Floats = (self.low + self.high) / 2
        return out


@dataclass(frozen=True, eq=False, slots=True)
class WallModel:
    """A program and a tool, ready to be asked for the error of its wall.

    Parameters
    ----------
    path : RealPath
    engagement : Engagement
        Of the rigid tool on it.
    arcs : Arcs
    opening, closing : (m,) float64
        Change of the first and the last immersion angle per displacement of the tool out of the part, rad/mm.
    wall : (n, 2) float64
        Normal out of the part at each step; NaN where no one wall is made.
    down : (n,) bool
        The wall is made at immersion pi (down milling), else at 0.
    cantilever : Cantilever
    gives : (n, 2) float64
        What machine and part give way along X and Y at each step, mm/N, the same at every height.
    setup : Setup
    """

    path: RealPath
    engagement: Engagement
    arcs: Arcs
    opening: Floats
    closing: Floats
    wall: Floats
    down: Bools
    cantilever: Cantilever
    gives: Floats
    setup: Setup

    @property
    def uneven(self) -> bool:
        """Whether the teeth run out."""
        offsets = self.setup.tool.tooth_offsets
        return max(offsets) > min(offsets)

    @property
    def tip(self) -> Floats:
        """Height of the tip above the deepest one at every step, mm; (n,)."""
        z = self.engagement.position[:, 2]
        out: Floats = z - z.min()
        return out

    @staticmethod
    def of(path: RealPath, setup: Setup, stock: StockRegion, nominal: Profile | None = None) -> WallModel:
        """Model of a path.

        Parameters
        ----------
        path : RealPath
            With its real feed, which sets the feed per tooth.
        setup : Setup
            Tool with its overhang, material, machine, heights.
        stock : StockRegion
            What is there before, see `millcorr.process.engagement.stock_of`.
        nominal : Profile, optional
            Needed where the machine's stiffness changes along it.

        Raises
        ------
        UsageError
            If the tool has no overhang, or a move that cuts has no feed; and as `compliance_at`.
        InputError
            As `millcorr.process.engagement.engagement`; and if the program makes no wall.
        """
        tool = Cantilever.of(setup)
        lines = path.toolpath.end[path.short, :2] - path.toolpath.start[path.short, :2]
        longest = 10.0 * float(np.hypot(*lines.T).max())
        found = engagement(path.toolpath, setup, stock, step=longest)
        forces = cutting(found, setup)
        makes = np.isfinite(forces.wall).all(axis=1) & path.short[found.move]
        if not makes.any():
            raise InputError(phrase("wall error: the program makes no wall: it cuts only slots or air"))
        left = np.stack([-np.sin(found.direction), np.cos(found.direction)], axis=1)
        to_left = np.where(makes, np.sign((forces.wall * left).sum(axis=1)), 0.0)
        down = found.exit > np.pi - _WALL
        lag = np.tan(np.radians(setup.tool.helix_deg)) / setup.tool.radius
        arcs, parent = _bands(found, min(tool.overhang * BAND, LAG / max(float(lag), 1e-9)))
        wall = np.where(makes[:, None], forces.wall, np.nan)
        if setup.machine.stiffness_along:
            gives = tool.rest(compliance_at(setup, nominal, found.position[:, :2]), setup.source)
        else:
            gives = np.tile(tool.machine, (len(found), 1))
        rigid = WallModel(path, found, arcs, np.zeros(len(arcs)), np.zeros(len(arcs)), wall, down, tool, gives, setup)
        # How the arcs change where the tool stands off the wall: a secant about as long as the tool bends.
        given = _across(rigid.deflection(arcs.step, arcs.middle, _free_end(arcs, down)), wall[arcs.step])
        by = float(np.clip(np.nanmedian(np.abs(given)), *_SHIFT)) if np.isfinite(given).any() else _SHIFT[0]
        # Lines beside a wall that make none go along: a kink in the path would count as a change of the angles.
        moved = engagement(path.shifted(by * _nearest_wall(found.move, to_left, len(path))), setup, stock, step=longest)
        opening, closing = _changes(found, moved, by)
        return WallModel(path, found, arcs, opening[parent], closing[parent], wall, down, tool, gives, setup)

    def wall_gives(self, height: Floats) -> Floats:
        """Compliance of the part's wall along X and Y at heights (q,) in mm above the deepest tip; (q, 2) in mm/N."""
        if not (rows := np.array(self.setup.machine.wall_over_height)).size:
            return np.zeros((len(height), 2))
        return np.column_stack([np.interp(height, rows[:, 0], 1.0 / rows[:, k]) for k in (1, 2)])

    def deflection(self, step: Ints, height: Floats, phi: Floats, arcs: Arcs | None = None, tooth: int = 0) -> Floats:
        """Deflection of the tool at a height when its edge at that height stands at an immersion angle.

        Parameters
        ----------
        step : (q,) int64
        height : (q,) float64
            mm above the tip.
        phi : (q,) float64
            rad.
        arcs : Arcs, optional
            By default those of the rigid tool.
        tooth : int
            Whose edge it is that stands there, of `Tool.tooth_offsets`.

        Returns
        -------
        (q, 2) float64
            Along X and Y in mm.
        """
        arcs = self.arcs if arcs is None else arcs
        bounds = np.searchsorted(arcs.step, np.arange(len(self.engagement) + 1))
        out = np.zeros((len(step), 2))
        for begin in range(0, len(step), PORTION):
            progress.step()
            k = slice(begin, begin + PORTION)
            out[k] = self._portion(step[k], height[k], phi[k], arcs, bounds, tooth)
        return out

    def _portion(self, step: Ints, height: Floats, phi: Floats, arcs: Arcs, bounds: Ints, tooth: int) -> Floats:
        tool, e = self.setup.tool, self.engagement
        lag = float(np.tan(np.radians(tool.helix_deg)) / tool.radius)
        pitch = 2 * np.pi / tool.flutes
        count = bounds[step + 1] - bounds[step]
        query = np.repeat(np.arange(len(step)), count)
        arc = np.arange(len(query)) - np.repeat(np.cumsum(count) - count, count) + bounds[step][query]
        # Every tooth whose edge can be in the arc somewhere along its height.
        z = height[query]
        least = phi[query] + lag * (z - arcs.high[arc]) - arcs.exit[arc]
        most = phi[query] + lag * (z - arcs.low[arc]) - arcs.entry[arc]
        first = np.ceil(-most / pitch - _AT).astype(np.int64)
        teeth = np.maximum(np.floor(-least / pitch + _AT).astype(np.int64) - first + 1, 0)
        pair = np.repeat(np.arange(len(query)), teeth)
        number = np.arange(len(pair)) - np.repeat(np.cumsum(teeth) - teeth, teeth) + first[pair]
        query, arc = query[pair], arc[pair]
        z, at = height[query], phi[query] + pitch * number
        low, high = arcs.low[arc], arcs.high[arc]
        if lag > 0:
            low = np.clip(z + (at - arcs.exit[arc]) / lag, low, high)
            high = np.clip(z + (at - arcs.entry[arc]) / lag, low, high)
        chip = e.feed_per_tooth[step[query]]
        turn = 1.0 if e.clockwise else -1.0
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        bent, force = np.zeros((len(arc), 2)), np.zeros((len(arc), 2))
        for a, b in ((low, np.clip(z, low, high)), (np.clip(z, low, high), high)):
            where = a[:, None] + (b - a)[:, None] * (nodes + 1) / 2
            angle = np.clip(at[:, None] + lag * (z[:, None] - where), arcs.entry[arc, None], arcs.exit[arc, None])
            if self.uneven:
                # The teeth ahead have cut before; one that takes no chip has no force.
                takes = chip_thickness(chip[:, None] * np.sin(angle), (tooth - number)[:, None], tool.tooth_offsets)
                per = force_of_chip(angle, takes, self.setup.material) * (takes > 0)[..., None]
            else:
                per = force_at(angle, chip[:, None], self.setup.material)
            per = per * (weights * (b - a)[:, None] / 2)[..., None]
            force += per.sum(axis=1)
            bent += (per * self.cantilever.compliance(z[:, None], where)[..., None]).sum(axis=1)
        wall = (self.gives[step] + self.wall_gives(height + self.tip[step]))[query]
        direction = e.direction[step[query]]
        c, s = np.cos(direction), np.sin(direction)
        out = np.zeros((len(step), 2))
        for along, left, give in (
            (bent[:, 0], turn * bent[:, 1], (1.0, 1.0)),
            (force[:, 0], turn * force[:, 1], wall.T),
        ):
            out[:, 0] += np.bincount(query, give[0] * (along * c - left * s), minlength=len(step))
            out[:, 1] += np.bincount(query, give[1] * (along * s + left * c), minlength=len(step))
        return out

    def closed(
        self, offset: Floats | float = 0.0, lean: Floats | float = 0.0, about: float = 0.0, tooth: int = 0
    ) -> tuple[Arcs, float]:
        """Arcs of the tool that bends, with the loop closed.

        Parameters
        ----------
        offset, lean : (n,) float64 or float
            Displacement of the tool out of the part in mm at the height `about`, and rad by which its upper end leans
            out of the part, of each step.
        about : float
            mm above the deepest tip.
        tooth : int
            Which makes the wall.

        Returns
        -------
        arcs : Arcs
        residual : float
            Change of the deflections in the last round, mm.

        Raises
        ------
        RefusedError
            If the deflections do not settle.
        """
        arcs, n = self.arcs, len(self.engagement)
        there = np.isfinite(self.wall[arcs.step, 0])
        # The loop needs rounds only where what it changes is in the cut as the wall is made.
        k = np.flatnonzero(self._matters()[arcs.step])
        step, middle, wall = arcs.step[k], arcs.middle[k], self.wall[arcs.step[k]]
        shift, angle = (np.broadcast_to(np.asarray(v, dtype=float), n)[arcs.step] for v in (offset, lean))
        moved = np.where(there, shift + angle * (arcs.middle + self.tip[arcs.step] - about), 0.0)
        given = np.zeros((len(arcs), 2))
        residual, course = 0.0, FixedPoint(arcs.step, n, depth=2)
        for _ in range(ROUNDS):
            progress.step()
            entry = np.clip(arcs.entry + self.opening * (moved + given[:, 0]), 0.0, np.pi)
            exit_ = np.clip(arcs.exit + self.closing * (moved + given[:, 1]), 0.0, np.pi)
            ends = Arcs(arcs.step, np.minimum(entry, exit_), exit_, arcs.low, arcs.high)
            bent = np.zeros((len(arcs), 2))
            for row, end, change in ((0, ends.entry, self.opening), (1, ends.exit, self.closing)):
                if change[k].any():
                    bent[k, row] = _across(self.deflection(step, middle, end[k], ends, tooth), wall)
            moving = np.abs(bent - given).max(axis=1)
            residual = float(moving.max(initial=0.0))
            if residual <= TOLERANCE:
                return ends, residual
            given = course.step(given, bent)
        x, y, _ = self.engagement.position[step[int(np.argmax(moving[k]))]]
        raise RefusedError(
            phrase(
                "wall error: the deflection does not settle near {}, it still changes by {}; check [tool] "
                "overhang_mm, [material] and the radial depth of cut",
                xy(x, y),
                um(residual, ".3g"),
            )
        )

    def _matters(self) -> Bools:
        """Steps at which, while the wall is made somewhere along the height, an edge stands near a free end of an arc.

        At a height z the edge at a height a then stands at ``wall + lag (z - a)``, other teeth a pitch apart.
        """
        arcs, n = self.arcs, len(self.engagement)
        lag = float(np.tan(np.radians(self.setup.tool.helix_deg)) / self.setup.tool.radius)
        pitch = 2 * np.pi / self.setup.tool.flutes
        lowest, highest = np.full(n, np.inf), np.full(n, -np.inf)
        np.minimum.at(lowest, arcs.step, arcs.low)
        np.maximum.at(highest, arcs.step, arcs.high)
        at = np.where(self.down[arcs.step], np.pi, 0.0)
        first = at + lag * (lowest[arcs.step] - arcs.high) - NEAR_END
        last = at + lag * (highest[arcs.step] - arcs.low) + NEAR_END
        out = np.zeros(n, dtype=bool)
        for end, change in ((arcs.entry, self.opening), (arcs.exit, self.closing)):
            # Some tooth's range holds the end: a whole number of pitches lies between.
            meets = np.floor((end - first) / pitch) >= np.ceil((end - last) / pitch)
            out[arcs.step[meets & (change != 0.0)]] = True
        return out & np.isfinite(self.wall[:, 0])

    def errors(
        self, heights: ArrayLike, *, offset: Floats | float = 0.0, lean: Floats | float = 0.0, about: float = 0.0
    ) -> HeightError:
        """Error of the wall at heights.

        Parameters
        ----------
        heights : (k,)
            mm above the tip of the deepest pass.
        offset, lean, about
            As `closed`: where the tool is put, on top of which it bends.

        Returns
        -------
        HeightError

        Raises
        ------
        UsageError
            If the program makes no wall at any of the heights.
        RefusedError
            As `closed`.
        """
        wanted = np.atleast_1d(np.asarray(heights, dtype=float))
        if not self.uneven:
            value, residual = self._made_by(0, wanted, offset, lean, about)
        else:
            # What the tooth that goes deepest leaves, of those that may be it.
            each = [self._made_by(k, wanted, offset, lean, about) for k in range(self.setup.tool.flutes)]
            value = np.min([v - d for (v, _), d in zip(each, self.setup.tool.tooth_offsets, strict=True)], axis=0)
            residual = max(r for _, r in each)
        value = value - self.setup.tool.radius_error_mm
        if not np.isfinite(value).any():
            raise UsageError(
                phrase(
                    "wall error: the program makes no wall {} above its deepest tip",
                    joined([mm(h, "g") for h in wanted]),
                )
            )
        return HeightError(self, wanted, float(self.engagement.position[:, 2].min()) + wanted, value, residual)

    def _made_by(
        self, tooth: int, wanted: Floats, offset: Floats | float, lean: Floats | float, about: float
    ) -> tuple[Floats, float]:
        """Deflection of the tool out of the part as a tooth makes the wall, (n, k) in mm, and the loop's residual."""
        arcs, residual = self.closed(offset, lean, about, tooth)
        n, tip = len(self.engagement), self.tip
        made = np.isfinite(self.wall[arcs.step, 0]) & np.where(
            self.down[arcs.step], self.arcs.exit == np.pi, self.arcs.entry == 0.0
        )
        shift, angle = (np.broadcast_to(np.asarray(v, dtype=float), n) for v in (offset, lean))
        value = np.full((n, len(wanted)), np.nan)
        for k, height in enumerate(wanted):
            above = height - tip[arcs.step]
            at = made & (arcs.low - _AT <= above) & (above <= arcs.high + _AT)
            step, first = np.unique(arcs.step[at], return_index=True)
            if not len(step):
                continue
            phi = np.where(self.down[step], np.pi, 0.0)
            z = above[at][first]
            bent = _across(self.deflection(step, z, phi, arcs, tooth), self.wall[step])
            value[step, k] = bent + shift[step] + angle[step] * (height - about)
        return value, residual


@dataclass(frozen=True, eq=False, slots=True)
class HeightError(ReadOnlyArrays):
    """Error of a wall at heights, one row a step of the path.

    Parameters
    ----------
    model : WallModel
    heights : (k,) float64
        mm above the tip of the deepest pass.
    z : (k,) float64
        The same in the program's frame, mm.
    value : (n, k) float64
        mm along the wall's normal from where the real path puts it for a cutter of the radius it was made for, positive
        where material is left; NaN where no wall is made.
    residual : float
        Of the elastic loop, mm.
    """

    model: WallModel
    heights: Floats
    z: Floats
    value: Floats
    residual: float

    @property
    def caution(self) -> str:
        """What to say about forces and stiffness; empty where they were calibrated and not fitted."""
        return joined(self.model.setup.cautions, "; ")


def _across(vector: Floats, normal: Floats) -> Floats:
    out: Floats = (vector * normal).sum(axis=1)
    return out


def _nearest_wall(move: Ints, to_left: Floats, count: int) -> Floats:
    """Side of the wall, 1 left and -1 right, of each of `count` moves: its own, or that of the nearest one with a wall.

    `move` and `to_left` are those of the steps, 0 where they make no wall.
    """
    side = np.zeros(count)
    side[move] = to_left
    makes = np.flatnonzero(side)
    out: Floats = side[makes[np.searchsorted((makes[1:] + makes[:-1]) / 2, np.arange(count))]]
    return out


def _free_end(arcs: Arcs, down: Bools) -> Floats:
    """The end of each arc that lies in the stock rather than at the wall."""
    return np.where(down[arcs.step], arcs.entry, arcs.exit)


def _bands(found: Engagement, size: float) -> tuple[Arcs, Ints]:
    """Arcs in bands no higher than `size` mm, heights above the tip; and the arc that each is of."""
    step = found.arc_step
    tip = found.position[step, 2]
    low, high = found.arc_low - tip, found.arc_high - tip
    count = np.maximum(np.ceil((high - low) / size - 1e-9), 1).astype(np.int64)
    parent = np.repeat(np.arange(len(step)), count)
    k = np.arange(len(parent)) - np.repeat(np.cumsum(count) - count, count)
    part = ((high - low) / count)[parent]
    bottom = low[parent] + k * part
    # At the wall exactly: there the chip is exactly nothing.
    entry = np.where(found.arc_entry < _WALL, 0.0, found.arc_entry)
    exit_ = np.where(found.arc_exit > np.pi - _WALL, np.pi, found.arc_exit)
    return Arcs(step[parent], entry[parent], exit_[parent], bottom, bottom + part), parent


def _changes(found: Engagement, moved: Engagement, by: float) -> tuple[Floats, Floats]:
    """Change of entry and exit of every arc per mm that the tool stands off the wall; 0 where arcs come or go."""
    opening, closing = np.zeros(len(found.arc_entry)), np.zeros(len(found.arc_entry))
    # Every line has a step at its end, and one at its start where the path bends there.
    mine, other_key = (2 * e.move + (e.t > 0.5) for e in (found, moved))
    there = np.minimum(np.searchsorted(other_key, mine), len(moved) - 1)
    alike = (other_key[there] == mine) & (np.diff(found.first) == np.diff(moved.first)[there])
    step = found.arc_step
    k = np.flatnonzero(alike[step])
    other = moved.first[there[step[k]]] + k - found.first[step[k]]
    same = found.arc_low[k] == moved.arc_low[other]
    k, other = k[same], other[same]
    opening[k] = (moved.arc_entry[other] - found.arc_entry[k]) / by
    closing[k] = (moved.arc_exit[other] - found.arc_exit[k]) / by
    opening[found.arc_entry < _WALL] = 0.0
    closing[found.arc_exit > np.pi - _WALL] = 0.0
    return opening, closing
