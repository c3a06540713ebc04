# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting forces of an end mill from its engagement, and the surface that a tool which bends leaves.

Linear-edge model (Altintas, Manufacturing Automation, 2nd ed., chapter 2): on an edge element of height
dz at immersion angle phi

    dFt = (Ktc f_t sin phi + Kte) dz      against the cutting motion
    dFr = (Krc f_t sin phi + Kre) dz      towards the axis

so that along the feed and to its left (clockwise spindle), as forces on the tool,

    dFx = -dFt cos phi - dFr sin phi,   dFy = dFt sin phi - dFr cos phi.

Both have elementary integrals over phi. Averages over a turn do not depend on the helix; the course over a turn
does.

Petrakov's model (2023, eqs. 1 to 4) is another one, with the same coefficients: one tooth, without edge forces, whose
force ``sqrt(kt^2 + kr^2) b f_t (1 - cos phi)`` acts undivided at the far end of the arc of angle phi. Here it is
averaged over the arc and over the teeth. Engaged from 0 to phi, with ``C = (1 - cos 2 phi) / 4`` and
``L = (2 phi - sin 2 phi) / 4``, the mean is ``N / (2 pi) sqrt(kt^2 + kr^2) b f_t sqrt(C^2 + L^2)`` and acts at
``atan(L / C)``. On the paper's straight and arc (phi 45.57 and 79.05 degrees) his force is, but for the constant
N / (2 pi), 1.8 and 5.6 % larger and turned by 15.5 and 28.0 degrees more towards the wall; from straight to arc it
grows 2.70-fold (here 2.60-fold, his figure 2.67) and its part across the wall, at kr = 0.3 kt, 3.03-fold (here 3.30).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats, Ints
from millcorr.errors import UsageError
from millcorr.messages import phrase, xy

from .engagement import Engagement
from .setup_file import Material, Setup, Tool

_NODES = 64
"""Heights at which edges of teeth that run out are looked at: where they begin to cut is met to 1 % of the depth."""

_WALL = 1e-6
"""An arc that ends nearer than this to 0 or pi, in rad, makes a wall."""


def force_at(phi: Floats, feed_per_tooth: Floats | float, material: Material) -> Floats:
    """Force of an edge element per height, along the feed and to its left (clockwise spindle).

    Parameters
    ----------
    phi : (...) float64
        Immersion angle in rad.
    feed_per_tooth : (...) or float
        f_t in mm.
    material : Material

    Returns
    -------
    (..., 2) float64
        N/mm, on the tool.
    """
    # Counted from the nearer side, so that the chip at pi is exactly nothing.
    return force_of_chip(phi, feed_per_tooth * np.sin(np.minimum(phi, np.pi - phi)), material)


def force_of_chip(phi: Floats, chip: Floats, material: Material) -> Floats:
    """Force of an edge element per height that takes a chip, as `force_at`; chip (...) in mm."""
    sine, cosine = np.sin(np.minimum(phi, np.pi - phi)), np.cos(phi)
    tangential = material.ktc_n_per_mm2 * chip + material.kte_n_per_mm
    radial = material.krc_n_per_mm2 * chip + material.kre_n_per_mm
    return np.stack([-tangential * cosine - radial * sine, tangential * sine - radial * cosine], axis=-1)


def force_integral(phi: Floats, feed_per_tooth: Floats | float, material: Material) -> Floats:
    """Antiderivative over phi of `force_at`; same shapes, N/mm rad."""
    s, c = np.sin(phi), np.cos(phi)
    chip_t, chip_r = material.ktc_n_per_mm2 * feed_per_tooth, material.krc_n_per_mm2 * feed_per_tooth
    double, lens = np.cos(2 * phi) / 4, (2 * phi - np.sin(2 * phi)) / 4
    return np.stack(
        [
            chip_t * double - chip_r * lens - material.kte_n_per_mm * s + material.kre_n_per_mm * c,
            chip_t * lens + chip_r * double - material.kte_n_per_mm * c - material.kre_n_per_mm * s,
        ],
        axis=-1,
    )


def chip_thickness(sweep: Floats, tooth: Ints, offsets: tuple[float, ...]) -> Floats:
    """Chip of a tooth that runs out, behind the teeth that cut before it.

    Parameters
    ----------
    sweep : (...) float64
        ``f_t sin(phi)`` in mm, what a tooth without run-out takes.
    tooth : (...) int64
        Number of the tooth; any whole number, they repeat.
    offsets : tuple of float
        `Tool.tooth_offsets`, mm.

    Returns
    -------
    (...) float64
        ``min over m of m f_t sin(phi) + rho_j - rho_(j - m)``, m = 1 to N, and 0 where that is below: the tooth m
        before it has gone deepest. mm; over N teeth it adds up to ``N f_t sin(phi)``, whatever they run out.
    """
    rho, n = np.array(offsets), len(offsets)
    out = np.full(np.broadcast_shapes(np.shape(sweep), np.shape(tooth)), np.inf)
    for m in range(1, n + 1):
        out = np.minimum(out, m * sweep + rho[tooth % n] - rho[(tooth - m) % n])
    chip: Floats = np.maximum(out, 0.0)
    return chip


def _least_sweep(offsets: tuple[float, ...]) -> list[float]:
    """For every tooth the ``f_t sin(phi)`` above which it cuts at all, mm."""
    n = len(offsets)
    return [max((offsets[j - m] - offsets[j]) / m for m in range(1, n + 1)) for j in range(n)]


def average_force(
    entry: ArrayLike,
    exit: ArrayLike,
    depth: ArrayLike,
    feed_per_tooth: ArrayLike,
    flutes: int,
    material: Material,
    offsets: tuple[float, ...] = (0.0,),
) -> Floats:
    """Mean force over a turn of engaged arcs, along the feed and to its left (clockwise spindle).

    Parameters
    ----------
    entry, exit : (...)
        Immersion angles in rad.
    depth, feed_per_tooth : (...)
        mm.
    flutes : int
    material : Material
    offsets : tuple of float
        `Tool.tooth_offsets`, mm. The chips of all teeth together are what they would be without run-out; a tooth that
        takes none has no edge force.

    Returns
    -------
    (..., 2) float64
        N, on the tool.
    """
    c, first, last = (np.asarray(v, dtype=float) for v in (feed_per_tooth, entry, exit))
    whole = force_integral(last, c, material) - force_integral(first, c, material)
    if max(offsets) > min(offsets) and (material.kte_n_per_mm > 0 or material.kre_n_per_mm > 0):
        edge = replace(material, ktc_n_per_mm2=0.0, krc_n_per_mm2=0.0)
        missed = np.zeros_like(whole)
        for least in _least_sweep(offsets):
            if least <= 0:
                continue
            share = least / np.maximum(c, 1e-300)
            begin = np.where(share < 1.0, np.arcsin(np.minimum(share, 1.0)), np.pi / 2)
            # It rubs before begin and behind pi - begin.
            for a, b in ((first, np.clip(begin, first, last)), (np.clip(np.pi - begin, first, last), last)):
                missed = missed + force_integral(b, c, edge) - force_integral(a, c, edge)
        whole = whole - missed / len(offsets)
    out: Floats = flutes / (2 * np.pi) * np.asarray(depth, dtype=float)[..., None] * whole
    return out


def force_over_turn(
    turn: ArrayLike,
    entry: ArrayLike,
    exit: ArrayLike,
    low: ArrayLike,
    high: ArrayLike,
    feed_per_tooth: float,
    tool: Tool,
    material: Material,
) -> Floats:
    """Force on the tool as it turns, all teeth and their helix together.

    Parameters
    ----------
    turn : (k,)
        Immersion angle in rad of the tip of the first tooth of `Tool.tooth_offsets`.
    entry, exit : (m,)
        Engaged arcs, immersion angles in rad.
    low, high : (m,)
        Heights above the tip between which each arc is engaged, mm.
    feed_per_tooth : float
        mm.
    tool : Tool
    material : Material

    Returns
    -------
    (k, 2) float64
        N, along the feed and to its left (clockwise spindle).
    """
    begin, end, bottom, top = (np.atleast_1d(np.asarray(v, dtype=float)) for v in (entry, exit, low, high))
    lag = np.tan(np.radians(tool.helix_deg)) / tool.radius
    pitch = 2 * np.pi / tool.flutes
    # Higher up an edge lags behind its tip: teeth that have passed may still cut there.
    more = int(np.ceil(lag * float(top.max(initial=0.0)) / pitch))
    tip = np.mod(np.atleast_1d(np.asarray(turn, dtype=float)), pitch)[:, None, None]
    number = np.arange(tool.flutes + more)[None, :, None]
    tip = tip + pitch * number
    if max(tool.tooth_offsets) > min(tool.tooth_offsets):
        # The tooth ahead by a pitch has cut before.
        turned = np.floor(np.atleast_1d(np.asarray(turn, dtype=float)) / pitch).astype(np.int64)[:, None, None]
        return _uneven(tip, turned - number, begin, end, bottom, top, feed_per_tooth, tool, material)
    if lag * float((top - bottom).max(initial=0.0)) < 1e-12:
        cutting = (begin <= tip) & (tip <= end)
        force = force_at(tip, feed_per_tooth, material) * np.where(cutting, top - bottom, 0.0)[..., None]
    else:
        first = np.clip(tip - lag * top, begin, end)
        last = np.clip(tip - lag * bottom, begin, end)
        force = force_integral(last, feed_per_tooth, material) - force_integral(first, feed_per_tooth, material)
        force = force / lag
    out: Floats = force.sum(axis=(1, 2))
    return out


def _uneven(
    tip: Floats,
    tooth: Ints,
    begin: Floats,
    end: Floats,
    bottom: Floats,
    top: Floats,
    feed_per_tooth: float,
    tool: Tool,
    material: Material,
) -> Floats:
    """`force_over_turn` of teeth that run out, tooth by tooth: by Gauss over each edge; (k, 2) in N."""
    lag = np.tan(np.radians(tool.helix_deg)) / tool.radius
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    out = np.zeros((len(tip), 2))
    for node, weight in zip(nodes, weights, strict=True):
        height = bottom + (top - bottom) * (node + 1) / 2
        phi = tip - lag * height
        chip = chip_thickness(feed_per_tooth * np.sin(np.clip(phi, 0.0, np.pi)), tooth, tool.tooth_offsets)
        cuts = (begin <= phi) & (phi <= end) & (chip > 0.0)
        out += (force_of_chip(phi, chip, material) * (cuts * weight * (top - bottom) / 2)[..., None]).sum(axis=(1, 2))
    return out


def surface_location_error(
    height: ArrayLike,
    entry: float,
    exit: float,
    depth: float,
    feed_per_tooth: float,
    stiffness: float,
    tool: Tool,
    material: Material,
) -> Floats:
    """Where a wall ends up when the tool bends: the deflection at the moment in which an edge makes the surface.

    The surface at a height is made when an edge passes the wall there: at immersion pi in down milling, at 0 in up
    milling. With one straight tooth in the cut its chip is then nothing, and without edge force so is the error. Of
    teeth that run out the one counts that goes deepest.

    Parameters
    ----------
    height : (k,)
        mm above the tip, within the cut.
    entry, exit : float
        Engaged arc in rad; it begins at 0 (up milling) or ends at pi (down milling).
    depth, feed_per_tooth : float
        mm.
    stiffness : float
        Across the wall, N/mm.
    tool : Tool
    material : Material

    Returns
    -------
    (k,) float64
        mm, positive where material is left.

    Raises
    ------
    UsageError
        If the arc makes no wall, or both (a slot).
    """
    down, up = bool(abs(exit - np.pi) < 1e-9), bool(abs(entry) < 1e-9)
    if down == up:
        raise UsageError("surface location error: the engaged arc must begin at 0 or end at pi, one of them")
    lag = np.tan(np.radians(tool.helix_deg)) / tool.radius
    tip = (exit if down else entry) + lag * np.atleast_1d(np.asarray(height, dtype=float))
    uneven = max(tool.tooth_offsets) > min(tool.tooth_offsets)
    left = []
    for number, offset in enumerate(tool.tooth_offsets if uneven else (0.0,)):
        # As this tooth stands at the wall the first one is so many pitches ahead.
        turn = tip + number * 2 * np.pi / tool.flutes
        across = force_over_turn(turn, entry, exit, 0.0, depth, feed_per_tooth, tool, material)[:, 1]
        # The wall of down milling lies on the right of a clockwise cutter: to the left is away from it.
        left.append((across if down else -across) / stiffness - offset - tool.radius_error_mm)
    made: Floats = np.min(left, axis=0)
    return made


@dataclass(frozen=True, eq=False, slots=True)
class Cutting:
    """Mean cutting force on the tool at every step of an engagement.

    Parameters
    ----------
    engagement : Engagement
    force : (n, 2) float64
        Along X and Y in N (petrakov-2023, eq. 1).
    wall : (n, 2) float64
        Normal out of the part, (cos alpha, cos beta), at the wall the cutter makes: across the direction of travel,
        away from the side where the arc ends (or begins). NaN in air, in a slot and where it touches no wall.
    """

    engagement: Engagement
    force: Floats
    wall: Floats

    @property
    def normal_force(self) -> Floats:
        """Force along the normal of the wall in N, positive away from the part; (n,), NaN without a wall."""
        out: Floats = (self.force * self.wall).sum(axis=1)
        return out

    @property
    def resultant(self) -> Floats:
        """Size of the mean force in N; (n,) (petrakov-2023, eq. 2)."""
        out: Floats = np.hypot(*self.force.T)
        return out


def cutting(engagement: Engagement, setup: Setup, layer: Floats | None = None) -> Cutting:
    """Mean cutting forces along a program.

    Parameters
    ----------
    engagement : Engagement
    setup : Setup
    layer : (m,) float64, optional
        Thickness in mm of the material before the middle of every arc: where it is less than the chip
        ``f_t sin(angle)``, the arc's force is less in proportion. By default there is enough.

    Returns
    -------
    Cutting

    Raises
    ------
    UsageError
        If a move that cuts has no feed.
    """
    e = engagement
    step = e.arc_step
    feed = e.feed_per_tooth[step]
    if not (np.isfinite(feed) & (feed > 0)).all():
        where = int(step[np.flatnonzero(~(np.isfinite(feed) & (feed > 0)))[0]])
        x, y, _ = e.position[where]
        raise UsageError(phrase("cutting: the move that cuts at {} has no feed in mm/min: state F in G94", xy(x, y)))
    arcs = average_force(
        e.arc_entry,
        e.arc_exit,
        e.arc_depth,
        feed,
        setup.tool.flutes,
        setup.material,
        setup.tool.tooth_offsets,
    )
    if layer is not None:
        chip = feed * np.sin((e.arc_entry + e.arc_exit) / 2)
        arcs = arcs * np.minimum(1.0, layer / np.maximum(chip, 1e-12))[:, None]
    n = len(e)
    turn = 1.0 if e.clockwise else -1.0
    along = np.bincount(step, arcs[:, 0], minlength=n)
    left = turn * np.bincount(step, arcs[:, 1], minlength=n)
    cx, sx = np.cos(e.direction), np.sin(e.direction)
    force = np.stack([along * cx - left * sx, along * sx + left * cx], axis=1)
    with np.errstate(invalid="ignore"):
        down, up = e.exit > np.pi - _WALL, e.entry < _WALL
    side = np.where(down == up, np.nan, np.where(down, turn, -turn))
    return Cutting(e, force, side[:, None] * np.stack([-sx, cx], axis=1))
