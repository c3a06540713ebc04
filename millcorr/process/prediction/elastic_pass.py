# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed elastic loop: the force bends tool and machine, which changes the engagement, which changes the force.

petrakov-2023, section 5.1: two stiffnesses, mean forces, no dynamics. The deflections of all steps together are the
fixed point of ``delta = F(delta) / k``. Later passes cut what the deflected earlier ones have left.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import REACH, Deviation, deviations
from millcorr.errors import RefusedError, UsageError
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.messages import at_z, mm, phrase, um, xy
from millcorr.nc.toolpath import Toolpath
from millcorr.process.cutting import Cutting, cutting
from millcorr.process.engagement import STEP, CutterPath, Engagement, GivenWay, arcs_of, engaged
from millcorr.process.engagement.path_pieces import Pieces, arcs_through
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.fixed_point import FixedPoint
from millcorr.process.setup_file import Setup
from millcorr.process.stiffness import compliance_at
from millcorr.readers.measurement import Measurement

TOLERANCE = 1e-7
"""The loop is closed when force over stiffness and deflection agree within this, in mm."""

ROUNDS = 40
"""Rounds in which all steps are brought nearer at once; what is still open is then settled step by step."""

MARCHES = 8
"""So often is a stretch settled step by step: what a later pass finds of it may open others."""

LONGEST = 1000
"""More steps than these are not settled one by one: it would take minutes, and what does not settle on so much of a
program is no matter of a place."""

AHEAD = 8
"""Steps settled beyond the last one that is open: those just before them have moved."""

_ON_SURFACE = 1e-9
"""A point nearer than this to where the cutter has been, in mm, is on the surface it leaves."""

_AT_END = 1e-9
"""An arc that ends nearer than this to 0 or pi, in rad, ends at the wall it makes."""


@dataclass(frozen=True, eq=False, slots=True)
class ElasticPass:
    """A program cut by a machine that gives way, one row a step.

    Parameters
    ----------
    path : CutterPath
    cutting : Cutting
        Engagement and forces of the closed loop.
    deflection : (n, 2) float64
        Of the cutter's centre from where it is commanded, along X and Y, mm.
    residual : float
        Largest difference of force over stiffness and deflection, mm.
    contraction : float
        Ratio of the residuals of one round to the next, in the mean of all rounds.
    bound : float
        Cutting stiffness over machine stiffness, bound of the contraction by the chip alone.
    """

    path: CutterPath
    cutting: Cutting
    deflection: Floats
    residual: float
    contraction: float
    bound: float

    @property
    def engagement(self) -> Engagement:
        """Engagement of the closed loop."""
        return self.cutting.engagement

    @property
    def centre(self) -> Floats:
        """Where the cutter's centre really is, mm; (n, 2)."""
        out: Floats = self.path.steps.centre + self.deflection
        return out

    @property
    def normal_deflection(self) -> Floats:
        """Deflection along the normal of the wall in mm, positive where it leaves material; (n,), NaN without wall."""
        out: Floats = (self.deflection * self.cutting.wall).sum(axis=1)
        return out

    def runs(self, height: float) -> Ints:
        """Number of the row of steps without a gap that each step belongs to; -1 above a height in mm. (n,)."""
        deep = self.path.position[:, 2] <= height + 1e-6
        links = _Links.of(self.path)
        begins = np.ones(len(deep), dtype=bool)
        begins[1:] = (np.diff(links.run) != 0) | ~deep[1:] | ~deep[:-1]
        return np.where(deep, np.cumsum(begins), -1)

    @property
    def accuracy(self) -> float:
        """Error of the deflections in mm: all that further rounds would still add, as long as they contract so."""
        return self.residual / (1.0 - self.contraction)


def elastic_pass(
    toolpath: Toolpath, setup: Setup, stock: StockRegion, *, nominal: Profile | None = None, step: float = STEP
) -> ElasticPass:
    """Cut a program with the elastic loop closed at every step.

    Parameters
    ----------
    toolpath : Toolpath
        Path of the cutter's centre.
    setup : Setup
    stock : StockRegion
    nominal : Profile, optional
        Needed where the machine's stiffness changes along it.
    step : float
        Largest distance between steps in mm.

    Returns
    -------
    ElasticPass

    Raises
    ------
    UsageError
        If the setup has no stiffness, or a move that cuts has no feed; and as `compliance_at`.
    InputError
        As `millcorr.process.engagement.engagement`.
    RefusedError
        If the cut is stiffer than the machine, so that the loop need not settle, or it does not settle.
    """
    setup.machine.stiffness(setup.source)
    path = CutterPath.of(toolpath, setup, step)
    stiffness = 1.0 / compliance_at(setup, nominal, path.steps.centre)
    rigid = engaged(path, setup, arcs_of(path, setup, stock))
    least = float(stiffness.min())
    bound = cutting_stiffness(rigid, setup) / least
    if bound >= 1.0:
        raise RefusedError(
            phrase(
                "elastic loop: the cut is {:.2f} times as stiff as the machine ({:g} N/mm): it need not "
                "settle; check [machine] kx_n_per_mm and ky_n_per_mm, feed, axial depth and [material]",
                bound,
                least,
            )
        )
    forces = cutting(rigid, setup)
    deflection = forces.force / stiffness
    links, last = _Links.of(path), len(path.steps) - 1

    def answer(deflection: Floats, only: Ints | None = None) -> Cutting:
        arcs = arcs_of(path, setup, stock, links.given_way(path, deflection), only)
        return cutting(engaged(path, setup, arcs), setup, arcs.layer)

    first = 0.0
    course = FixedPoint(np.arange(last + 1), last + 1, depth=1)
    for turn in range(ROUNDS + MARCHES):
        progress.step()
        forces = answer(deflection)
        bent = forces.force / stiffness
        off = np.abs(bent - deflection).max(axis=1)
        residual = float(off.max(initial=0.0))
        first = first or residual
        if residual <= TOLERANCE:
            contraction = (residual / first) ** (1.0 / turn) if turn else 0.0
            return ElasticPass(path, forces, deflection, residual, contraction, bound)
        if turn < ROUNDS:
            deflection = course.step(deflection, bent)
        else:
            still = np.flatnonzero(off > TOLERANCE)
            begin, end = int(still[0]), min(int(still[-1]) + AHEAD, last)
            if end - begin > LONGEST:
                break
            deflection = _marched(deflection, begin, end, answer, stiffness)
    x, y, _ = path.position[int(np.argmax(off))]
    raise RefusedError(
        phrase(
            "elastic loop: it does not settle near {}, where force and deflection still differ by {}; "
            "check [machine] stiffness, feed and [material]",
            xy(x, y),
            um(residual, ".3g"),
        )
    )


def _marched(
    deflection: Floats, first: int, last: int, answer: Callable[[Floats, Ints], Cutting], stiffness: Floats
) -> Floats:
    """Deflections with those of steps `first` to `last` settled one after the other.

    A step's force depends on its own deflection and on those before it: settled in order, each is two equations.
    """
    deflection = deflection.copy()
    for step in range(first, last + 1):
        progress.step()
        only, course = np.array([step]), FixedPoint(np.zeros(1, dtype=np.int64), 1, depth=2)
        for _ in range(ROUNDS):
            bent = answer(deflection, only).force[only] / stiffness[only]
            if np.abs(bent - deflection[only]).max() <= TOLERANCE / 4:
                break
            deflection[only] = course.step(deflection[only], bent)
    return deflection


def cutting_stiffness(engagement: Engagement, setup: Setup) -> float:
    """How much the chip's mean force grows with depth, at most, in N/mm.

    Where a stock boundary runs beside the path, a depth more by da lengthens the arc by ``da / (R sin phi)``, and
    the tooth there takes ``f_t sin phi``: the force grows by ``N b f_t K / (2 pi R)`` with
    ``K = sqrt(Ktc^2 + Krc^2)``, whatever phi is; a slot has two such boundaries. Edge forces are not in it.
    """
    e, m = engagement, setup.material
    if not len(e.arc_entry):
        return 0.0
    free = (e.arc_entry > _AT_END).astype(float) + (e.arc_exit < np.pi - _AT_END)
    step = e.arc_step
    per_arc = e.arc_depth * np.nan_to_num(e.feed_per_tooth[step]) * np.maximum(free, 1.0)
    whole = float(np.bincount(step, per_arc).max())
    k = float(np.hypot(m.ktc_n_per_mm2, m.krc_n_per_mm2))
    return setup.tool.flutes * whole * k / (2 * np.pi * e.radius)


@dataclass(frozen=True, eq=False, slots=True)
class _Links:
    """How steps hang together: which lead to the next without a break, and by which commanded middle.

    `joined` (n,) is true for steps that the step before leads to; `middle` (n, 2) lies halfway; `run` (n,) numbers
    rows of steps without a gap, corners included; `known` (n,) is the first step of those that have just led to each.
    """

    joined: Bools
    middle: Floats
    run: Ints
    known: Ints

    @staticmethod
    def of(path: CutterPath) -> _Links:
        steps, pieces = path.steps, path.pieces
        n = len(steps)
        same = np.zeros(n, dtype=bool)
        same[1:] = steps.piece[1:] == steps.piece[:-1]
        joined = same | (steps.u > 0)
        joined[0] = False
        begin = np.where(same, np.roll(steps.u, 1), 0.0)
        middle = pieces.point(steps.piece, (begin + steps.u) / 2)
        near = np.zeros(n, dtype=bool)
        near[1:] = np.hypot(*(steps.centre[1:] - steps.centre[:-1]).T) <= np.diff(path.s) + 1e-6
        run = np.cumsum(~near)
        lap = float(np.diff(path.s).max(initial=0.0))
        # Just now: within one step, and along the same run.
        key = path.s + run * (path.s[-1] + 10 * lap + 1.0)
        known = np.searchsorted(key, key - lap - 1e-9)
        known = np.maximum(known, np.searchsorted(run, run))
        return _Links(joined, middle, run.astype(np.int64), known.astype(np.int64))

    def given_way(self, path: CutterPath, deflection: Floats) -> GivenWay:
        """The path of the cutter, every bit an arc through its ends and its middle, which give way alike."""
        centre = path.steps.centre + deflection
        k = np.flatnonzero(self.joined)
        start, end = centre[k - 1], centre[k]
        middle = self.middle[k] + (deflection[k - 1] + deflection[k]) / 2
        arc, radius, sweep = arcs_through(start, middle, end)
        zero, nothing = np.zeros(len(k)), np.full(len(k), np.nan)
        pieces = Pieces(start, end, arc, radius, sweep, k, zero, zero + 1.0, nothing, nothing.copy())
        return GivenWay(centre, pieces, np.searchsorted(k, self.known, side="right"))


def predicted_deviation(
    elastic: ElasticPass,
    nominal: Profile,
    *,
    spacing: float = 1.0,
    z: float | None = None,
) -> Deviation:
    """Deviation from the nominal of the surface that an elastic pass leaves, as if it were measured.

    Parameters
    ----------
    elastic : ElasticPass
    nominal : Profile
    spacing : float
        Distance of the points along the profile in mm.
    z : float, optional
        Height looked at: passes with the tip at or below it cut. By default the deepest.

    Returns
    -------
    Deviation
        At points of the profile that the commanded cutter leaves within `REACH`, however far it gives way where that
        is half of it; corners and what the cutter cannot reach left out.

    Raises
    ------
    UsageError
        If the spacing is not positive, or nothing cuts at the height.
    InputError
        If the cutter comes near no point of the profile.
    RefusedError
        If what the cutter leaves at one of these points is not to be found.
    """
    return deviation_along(elastic, nominal, None, spacing=spacing, z=z)[0]


def deviation_along(
    elastic: ElasticPass,
    nominal: Profile,
    meant: Floats | None,
    *,
    spacing: float,
    z: float | None = None,
) -> tuple[Deviation, Floats]:
    """As `predicted_deviation`, for a cutter that the axes did not lead where it is commanded.

    Parameters
    ----------
    elastic, nominal, spacing, z
        As there.
    meant : (n, 2) float64 or None
        Where the cutter's centre is commanded at every step of a pass along the path that the axes run, mm; None where
        they lead it as commanded.

    Returns
    -------
    Deviation
    kinematic : (n,) float64
        What of it is left by the axes, mm.

    Raises
    ------
    UsageError, InputError, RefusedError
        As there.
    """
    if not (np.isfinite(spacing) and spacing > 0):
        raise UsageError(phrase("predicted deviation: a spacing of {!r} mm is not positive", spacing))
    height = float(elastic.path.levels[0] if z is None else z)
    radius = elastic.engagement.radius
    points, normals = [], []
    for k, total in enumerate(nominal.total):
        count = max(1, int(np.ceil(float(total) / spacing)))
        c, n = nominal.at(k, (np.arange(count) + 0.5) * (float(total) / count))
        points.append(c)
        normals.append(n)
    point, normal = np.concatenate(points), np.concatenate(normals)
    commanded = elastic.path.steps.centre if meant is None else meant
    wanted, found, within = surface_along(_path_through(elastic, commanded, height), radius, point, normal)
    rows = np.flatnonzero(found & within)
    if not len(rows):
        raise UsageError(phrase("predicted deviation: the program does not cut the nominal profile: check both"))
    point, normal = point[rows], normal[rows]
    # Where a lead or another pass crosses the contour its end is no matter of what bends.
    wanted = wanted[rows]
    own = np.abs(wanted) <= REACH / 2

    def left(path: Profile, centre: Floats) -> tuple[Floats, Bools, float]:
        # Where the path is off by so much the surface is, too; by twice that where it is met at 60 degrees. It is
        # looked for from there on only: deeper down another pass may have been.
        off = float(np.hypot(*(centre - commanded).T).max())
        room = abs(elastic.engagement.oversize) + 2.0 * off + _ON_SURFACE
        begin = np.where(own, wanted - room, -REACH)
        x, found, within = surface_along(path, radius + elastic.engagement.oversize, point, normal, begin, REACH + room)
        # Corners that the axes round off are no more; what bends only moves them.
        if meant is None and (lost := np.flatnonzero(within & ~found & own)).size:
            px, py = point[lost[0]]
            raise RefusedError(
                phrase(
                    "predicted deviation: what the cutter leaves at {} is not to be found within {}; it is up "
                    "to {} off its path: check [machine] stiffness and inertia",
                    xy(px, py),
                    mm(REACH + room, ".3f"),
                    mm(off, ".3f"),
                )
            )
        return x, within & found, REACH + room

    bends = commanded + elastic.deflection
    bent, cut, reach = left(_path_through(elastic, bends, height), bends)
    out = bent
    if meant is not None:
        out, also, reach = left(_path_through(elastic, elastic.centre, height), elastic.centre)
        cut &= also
    if not cut.any():
        raise UsageError(phrase("predicted deviation: the program does not cut the nominal profile: check both"))
    rows = np.flatnonzero(cut)
    xyz = np.column_stack([point[rows] + out[rows, None] * normal[rows], np.full(len(rows), height)])
    ijk = np.column_stack([normal[rows], np.zeros(len(rows))])
    touched = Measurement(xyz, ijk, 0.0, np.arange(1, len(rows) + 1), "predicted surface", "")
    deviation = deviations(touched, nominal, reach=reach, cutter_radius=radius)
    return deviation, (out - bent)[rows][deviation.index]


def surface_along(
    path: Profile,
    radius: float,
    point: Floats,
    normal: Floats,
    begin: Floats | float = -REACH,
    end: float = REACH,
) -> tuple[Floats, Bools, Bools]:
    """Distance along normals, in mm, at which a cutter that runs along a path leaves the surface.

    Parameters
    ----------
    path : Profile
        Of the cutter's centre.
    radius : float
        mm.
    point, normal : (n, 2) float64
        mm, and unit vectors out of the part.
    begin : (n,) float64 or float
        Where the search begins on each normal, below the surface, mm.
    end : float
        Where it ends, mm.

    Returns
    -------
    x : (n,) float64
        Distance in mm.
    found : (n,) bool
        Whether it is between both.
    within : (n,) bool
        Whether it does so other than by an end of its path.
    """
    first = np.broadcast_to(np.asarray(begin, dtype=float), len(point))
    search = FootPointSearch(path, margin=radius + 2 * max(end, float(-first.min(initial=0.0))))
    x = first.copy()
    rows = np.arange(len(point))
    found, beyond = np.zeros(len(point), dtype=bool), np.zeros(len(point), dtype=bool)
    for _ in range(200):
        q = point[rows] + x[rows, None] * normal[rows]
        feet = search.find(q)
        away = q - feet.foot
        beyond[rows] = feet.place == Place.END
        distance = np.hypot(*away.T)
        gap = distance - radius
        # A step as long as the gap cannot pass the surface; near it Newton's step is the shorter way.
        slope = -(away * normal[rows]).sum(axis=1) / np.maximum(distance, 1e-12)
        step = np.where((slope > 0.5) & (np.abs(gap) < 0.1), gap / np.maximum(slope, 0.5), gap)
        x[rows] += step
        there = np.abs(step) <= 1e-12
        lost = ((x[rows] > end) | (x[rows] < first[rows])) & ~there
        found[rows] = np.abs(gap) <= _ON_SURFACE
        found[rows[lost]] = False
        rows = rows[~there & ~lost]
        if not len(rows):
            break
    return x, found, ~beyond


def _path_through(elastic: ElasticPass, centre: Floats, height: float) -> Profile:
    """Path of the cutter's centre (n, 2) up to a height: cubic splines through the steps, lines where it jumps."""
    path, away = elastic.path, centre - elastic.path.steps.centre
    links = _Links.of(path)
    number = elastic.runs(height)
    contours = []
    for run in np.split(np.arange(len(centre)), np.flatnonzero(np.diff(number) != 0) + 1):
        if len(run) < 2 or number[run[0]] < 0:
            continue
        curves: list[NurbsCurve] = []
        for part in np.split(run, np.flatnonzero(~links.joined[run[1:]]) + 1):
            if curves and np.hypot(*(centre[part[0]] - curves[-1].poles[-1])) > 1e-9:
                curves.append(NurbsCurve.line(curves[-1].poles[-1], centre[part[0]]))
            if len(part) > 1:
                # Every step and the middle before it, which gives way alike.
                points = np.empty((2 * len(part) - 1, 2))
                points[0::2] = centre[part]
                given = away[part]
                points[1::2] = links.middle[part[1:]] + (given[1:] + given[:-1]) / 2
                curves.append(_through(points))
        if curves:
            contours.append(Contour(tuple(curves), False))
    if not contours:
        raise UsageError(phrase("predicted deviation: nothing cuts at or below {}", at_z(height)))
    return Profile.from_contours(contours)


def _through(points: Floats) -> NurbsCurve:
    """Cubic spline through points, by chord length; a parabola through three."""
    from scipy.interpolate import make_interp_spline

    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    degree = min(3, len(points) - 1)
    spline = make_interp_spline(s, points, k=degree)
    knots, count = np.unique(spline.t, return_counts=True)
    poles = np.array(spline.c)
    # The ends are points of the path to the last digit.
    poles[0], poles[-1] = points[0], points[-1]
    return NurbsCurve(degree, poles, np.ones(len(poles)), knots, count.astype(np.int64))
