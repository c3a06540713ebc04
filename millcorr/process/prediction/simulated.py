# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program simulated before it is cut: real feed, engagement, force, deflection, and the surface that is left.

What is left is a `Deviation` like a measured one. A correction laid on the program is simulated again, and again
until the surface is as near to the nominal as is asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import PurePath

import numpy as np

from millcorr import nc, progress
from millcorr.arrays import Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.correction.compensation import correction_from
from millcorr.errors import FormatError, LimitError, RefusedError
from millcorr.geometry.correction import Correction
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, xy
from millcorr.nc.toolpath import Toolpath
from millcorr.path.emission import Emission
from millcorr.process.engagement import stock_of
from millcorr.process.engagement.contact_steps import Contacts
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.kinematics import Control, Halts, Motion, halts_of, motion
from millcorr.process.setup_file import Setup
from millcorr.readers.measurement import Measurement

from .cutter_reach import profile_of_path
from .elastic_pass import ElasticPass, deviation_along, elastic_pass
from .real_feed import RealFeed, commanded, control_of

ROUNDS = 8
"""Corrections are simulated at most so many times; each leaves about a tenth of the one before."""

AXES = 0.5
"""Share of an error from which on it is the doing of the axes."""

FINEST, COARSEST = 0.1, 0.5
"""Bounds of the distance of predicted points along the contour, in mm."""


@dataclass(frozen=True, eq=False, slots=True)
class Simulation:
    """A program cut by the model of a setup.

    Parameters
    ----------
    setup : Setup
    nominal : Profile
    stock : StockRegion
        What the program found.
    feed : RealFeed
        The program at real feeds, without earlier ones.
    motion : Motion or None
        Actual motion; None where the setup names no inertia: feeds are then the programmed ones.
    elastic : ElasticPass
        Engagement, force and deflection at every step of the path that the axes run, those of an earlier program first.
    deviation : Deviation
        What is left at points of the nominal, mm: by the deflection, and by axes that do not follow exactly.
    kinematic : (n,) float64
        What of `deviation` the axes leave, mm; 0 where the setup names no inertia.
    commanded : (m, 2) float64
        Where the cutter's centre is commanded at every step, mm.
    cautions : tuple of str
        What the model could not take into account, and how far its numbers can be trusted.
    """

    setup: Setup
    nominal: Profile
    stock: StockRegion
    feed: RealFeed
    motion: Motion | None
    elastic: ElasticPass
    deviation: Deviation
    kinematic: Floats
    commanded: Floats
    cautions: tuple[str, ...]

    @property
    def centre(self) -> Floats:
        """Where the cutter's centre really is at every step, mm: actual motion and deflection; (m, 2)."""
        return self.elastic.centre

    @property
    def largest(self) -> float:
        """Largest predicted error in mm."""
        return float(np.abs(self.deviation.value).max())

    def error_at(self, contour: Ints, s: Floats) -> Floats:
        """Predicted deviation in mm between its points; NaN farther than a spacing from one. (n,)."""
        d = self.deviation
        out = np.full(len(s), np.nan)
        for k in np.unique(contour):
            rows, mine = np.flatnonzero(contour == k), np.flatnonzero(d.contour == k)
            if not len(mine):
                continue
            order = mine[np.argsort(d.s[mine])]
            along = d.s[order]
            period = float(self.nominal.total[k]) if self.nominal.contours[k].closed else None
            out[rows] = np.interp(s[rows], along, d.value[order], period=period)
            away = np.abs(s[rows, None] - along[_nearest(along, s[rows])])
            if period is not None:
                away = np.minimum(away, period - away)
            out[rows[away.min(axis=1) > 1.5 * _spacing(self.elastic.engagement.radius)]] = np.nan
        return out

    def error_of(self, contour: Ints, s: Floats, shift: Floats) -> Floats:
        """Predicted deviation where the cutter really cuts that is commanded to displaced places of the contour.

        Parameters
        ----------
        contour : (n,) int64
        s : (n,) float64
            Arc lengths of places whose cutter is commanded along their normal, mm.
        shift : (n,) float64
            By how much farther out than one radius, mm.

        Returns
        -------
        (n,) float64
            mm; NaN where it is not known. The force along the path deflects the cutter to another place of the contour.
        """
        foot, normal = self.nominal.at(contour, s)
        foot = foot + shift[:, None] * normal
        deflection = Contacts.of(self.elastic.engagement, foot, normal).take(self.elastic.deflection)
        actual = foot + self.elastic.engagement.radius * normal + deflection
        feet = FootPointSearch(self.nominal, margin=self.elastic.engagement.radius + 2.0).find(actual)
        return self.error_at(self.nominal.contour[feet.span], self.nominal.arc_length(feet.span, feet.t))

    def surface(self) -> Measurement:
        """The predicted surface as if it had been measured: contact points with the nominal's normals."""
        d = self.deviation
        points = np.column_stack([d.foot + d.value[:, None] * d.normal, d.z])
        normals = np.column_stack([d.normal, np.zeros(len(d))])
        source = f"predicted from {PurePath(self.setup.source).name or 'a setup'}"
        out = Measurement(points, normals, 0.0, np.arange(1, len(d) + 1), source, "")
        return replace(out, digest=out.fingerprint)


def simulate(
    program: nc.Program,
    setup: Setup,
    nominal: Profile,
    *,
    stock: StockRegion | None = None,
    earlier: nc.Program | None = None,
) -> Simulation:
    """Simulate a program.

    Parameters
    ----------
    program : Program
        Path of the cutter's centre.
    setup : Setup
    nominal : Profile
    stock : StockRegion, optional
        By default the stock of the setup.
    earlier : Program, optional
        Cuts first, with the same tool and machine: what it leaves the program finds.

    Returns
    -------
    Simulation

    Raises
    ------
    MillcorrError
        As `elastic_pass`, `deviation_along` and `kinematics.motion`: no stiffness, no feed, a cut stiffer than the
        machine.
    """
    stock = stock_of(setup, nominal) if stock is None else stock
    control = control_of(setup)
    feed, moved, notes = _at_real_feed(program, control)
    toolpath = feed.toolpath
    cut = [(program.toolpath, feed, moved)]
    if earlier is not None:
        before, run, _ = _at_real_feed(earlier, control)
        toolpath = one_after_another(before.toolpath, toolpath)
        cut.insert(0, (earlier.toolpath, before, run))
    elastic = elastic_pass(toolpath, setup, stock, nominal=nominal)
    meant = _commanded(cut, elastic) if any(led is not None for _, _, led in cut) else None
    found, kinematic = deviation_along(elastic, nominal, meant, spacing=_spacing(setup.tool.radius))
    cautions = (*setup.cautions, *notes)
    where = elastic.path.steps.centre if meant is None else meant
    return Simulation(setup, nominal, stock, feed, moved, elastic, found, kinematic, where, cautions)


def _commanded(programs: list[tuple[Toolpath, RealFeed, Motion | None]], elastic: ElasticPass) -> Floats:
    """Where the cutter's centre is commanded at the steps of a pass along programs one after the other; (n, 2)."""
    e = elastic.engagement
    out = np.array(elastic.path.steps.centre)
    parts = 0
    for toolpath, feed, _ in programs:
        mine = np.flatnonzero((e.move >= parts) & (e.move < parts + len(feed.move)))
        place = feed.place(e.move[mine] - parts, e.t[mine])
        # The end of a move belongs to it, and not to the next.
        ends = np.minimum(place, np.nextafter(feed.move[e.move[mine] - parts] + 1.0, 0.0))
        found = commanded(toolpath, ends)
        known = np.isfinite(found).all(axis=1)
        out[mine[known]] = found[known]
        parts += len(feed.move)
    return out


def at_real_feed(program: nc.Program, setup: Setup) -> Toolpath:
    """Path of a program as the setup's machine really runs it, at its feeds."""
    return _at_real_feed(program, control_of(setup))[0].toolpath


def one_after_another(first: Toolpath, second: Toolpath) -> Toolpath:
    """Two programs in a row."""
    later = second.source + (int(first.source[-1]) + 1 if len(first) else 0)
    return Toolpath.concatenate([first.with_lines(None), second.with_moves(source=later)])


def _at_real_feed(program: nc.Program, control: Control | None) -> tuple[RealFeed, Motion | None, tuple[str, ...]]:
    """A program on the path and at the feeds of its actual motion, that motion, and what was taken for granted."""
    if control is None:
        return RealFeed.programmed(program.toolpath), None, ()
    halts, notes = halts_and_notes(program)
    moved = motion(program.toolpath, control, halts=halts, name=program.name)
    return RealFeed.of(program.toolpath, moved).run(program.toolpath, moved), moved, notes


def halts_and_notes(program: nc.Program) -> tuple[Halts, tuple[str, ...]]:
    """Exact stops and dwells of a program, and what was taken for granted of them."""
    try:
        return halts_of(program), ()
    except FormatError:
        note = phrase("{}: the unit of the dwells is not known, they are taken as seconds", program.name)
        return halts_of(program, "s"), (note,)


def _spacing(radius: float) -> float:
    """Distance of predicted points in mm: load changes along the contour over a good part of the cutter's radius."""
    return float(np.clip(radius / 40.0, FINEST, COARSEST))


def _nearest(sorted_s: Floats, s: Floats) -> Ints:
    """Rows of the neighbours of places, wrapping round; (n, 2)."""
    right = np.searchsorted(sorted_s, s)
    out: Ints = np.stack([right - 1, right % len(sorted_s)], axis=1)
    return out


@dataclass(frozen=True, eq=False, slots=True)
class Aim:
    """Where the cutter is to be moved, by the place of the contour that it touches.

    Parameters
    ----------
    contour, stretch : (n,) int64
    s : (n,) float64
        Arc length from the contour's start, mm.
    value : (n,) float64
        Displacement of its centre along the normal there, mm, positive out of the material.
    yields : (n,) float64
        By how much the path must move for the surface to move by one: 1 + MS.
    """

    contour: Ints
    stretch: Ints
    s: Floats
    value: Floats
    yields: Floats

    def correction(self, nominal: Profile, radius: float, limit: float) -> tuple[Correction, tuple[str, ...]]:
        """Correction whose parallel is the displaced path; errors as `correction_from`."""
        stretch, s, value = profile_of_path(nominal, self.stretch, self.s, self.value, radius)
        return correction_from(nominal, stretch, s, value, limit=limit)


def settle(
    aim: Aim,
    nominal: Profile,
    *,
    lay: Callable[[Correction], Emission],
    cut: Callable[[Emission], Simulation],
    radius: float,
    limit: float,
    bound: float | None,
) -> tuple[Aim, Correction, tuple[str, ...], Emission, tuple[Simulation, ...]]:
    """Lay a correction on the program, simulate it, and go on until the predicted error is below a bound.

    The next path is moved by what the last one left, times ``1 + MS``: that solves the loop where force is in
    proportion to depth, and comes ten times nearer each round where it is not.

    Parameters
    ----------
    aim : Aim
    nominal : Profile
    lay : callable
        From a correction to the program that carries it.
    cut : callable
        From a program to its simulation.
    radius : float
        Of the cutter, mm.
    limit : float
        Largest correction in mm.
    bound : float or None
        mm; None simulates once and leaves it at that.

    Returns
    -------
    aim, correction, warnings, emission
        The last ones.
    tuple of Simulation
        One a round.

    Raises
    ------
    RefusedError
        If the bound is not reached; LimitError where what the next round would need cannot be laid.
    MillcorrError
        As `correction_from`, `lay` and `cut`.
    """
    passes: list[Simulation] = []
    for _ in range(1 if bound is None else ROUNDS):
        progress.step()
        try:
            correction, notes = aim.correction(nominal, radius, limit)
            emission = lay(correction)
        except LimitError as error:
            if not passes:
                raise
            raise LimitError(_still_left(passes, bound), ": ", error.message) from error
        done = cut(emission)
        passes.append(done)
        over = np.nan_to_num(done.error_of(aim.contour, aim.s, aim.value))
        if bound is None or done.largest <= bound:
            return aim, correction, notes, emission, tuple(passes)
        aim = replace(aim, value=aim.value - aim.yields * over)
    raise RefusedError(phrase("{}: the cutter cannot follow so quick a change; allow more", _still_left(passes, bound)))


def _still_left(passes: list[Simulation], bound: float | None) -> str:
    """What the last round left, where it is most, and whether that is the doing of the axes."""
    done = passes[-1]
    d = done.deviation
    worst = int(np.argmax(np.abs(d.value)))
    x, y = d.foot[worst]
    rounds = phrase("1 round") if len(passes) == 1 else phrase("{} rounds", len(passes))
    text = phrase(
        "after {} {} are still predicted at {}, more than {}",
        rounds,
        mm(d.value[worst], "+.4f"),
        xy(x, y),
        option("iterate", bound),
    )
    if abs(done.kinematic[worst]) > AXES * abs(d.value[worst]):
        return phrase("{}, which the axes leave: lower the feed there (simulate {})", text, option("slowed"))
    return text
