# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corrections that a setup helps to make: wholly a priori, or combined with touches (petrakov-2023).

A predicted surface is treated as a measured one. Touches give the size of the load's effect, the engagement how it
varies along the contour; the machine that leaves what was touched then cuts the corrected program in the model.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from millcorr import nc
from millcorr.arrays import Floats
from millcorr.comparison.deviation import Deviation
from millcorr.correction.settings import Settings
from millcorr.correction.transfer_function import TransferFunction
from millcorr.correction.wanted_displacement import Elastic, Part, WantedDisplacement, displacement_without_noise
from millcorr.errors import UsageError
from millcorr.geometry.correction import Correction
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import Place, option, phrase, remedy, um, xy
from millcorr.path.emission import Emission
from millcorr.process.cutting import cutting
from millcorr.process.engagement import engagement, stock_of
from millcorr.process.engagement.contact_steps import Contacts
from millcorr.process.setup_file import Setup
from millcorr.process.stiffness import compliance_at, weights_at
from millcorr.separation.parts import averaged

from .combined_control import AxisTransfer, Machine, identify, identify_machine
from .simulated import Aim, Simulation, at_real_feed, one_after_another, settle, simulate

LEAST_DEPTH = 0.5
"""A predicted deviation above this share of the depth is mirrored: no share of the depth is worth carrying."""


@dataclass(frozen=True, eq=False, slots=True)
class Prediction:
    """What the model says of a program before and after its correction.

    Parameters
    ----------
    before : Simulation
        The program as it came, on the machine of the setup or on the one that the touches show.
    after : tuple of Simulation
        The corrected program, one a round; the last one is the one written.
    axes : AxisTransfer or None
        Transfer functions of both axes from touches; None where nothing was measured.
    machine : Machine or None
        Stiffness from touches.
    """

    before: Simulation
    after: tuple[Simulation, ...]
    axes: AxisTransfer | None = None
    machine: Machine | None = None

    def summary(self) -> dict[str, Any]:
        """What report.json says of it; mm and N/mm, uncertainties are standard ones."""
        out: dict[str, Any] = {
            "setup": self.before.setup.source,
            "predicted_before": self.before.largest,
            "predicted_after": [one.largest for one in self.after],
            "stiffness": list(self.before.setup.machine.stiffness()),
            "stiffness_along": [list(row) for row in self.before.setup.machine.stiffness_along],
            "combined": None,
        }
        if self.axes is not None and self.machine is not None:
            std = self.axes.ms_std
            out["combined"] = {
                "msx": float(self.axes.ms[0]),
                "msy": float(self.axes.ms[1]),
                "msx_uncertainty": float(std[0]),
                "msy_uncertainty": float(std[1]),
                "axes_told_apart": self.axes.separate,
                "depth": self.axes.depth,
                "area": self.axes.area,
                "misfit": self.machine.misfit,
            }
        return out

    def left_at(self, work: WantedDisplacement) -> Floats:
        """What the model expects at the points of a measurement after the correction, random part too, mm; (n,)."""
        d = work.deviation
        expected = self.after[-1].error_at(d.contour, d.s)
        out: Floats = np.nan_to_num(expected) + d.value - work.filtered
        return out

    def advice(self) -> tuple[str, ...]:
        """What to expect, and how far to trust it."""
        said = [
            phrase(
                "the model leaves at most {} before and {} after the correction{}",
                um(self.before.largest),
                um(self.after[-1].largest),
                phrase(", in {} rounds", len(self.after)) if len(self.after) > 1 else "",
            )
        ]
        if self.axes is None:
            said.append(
                phrase("nothing was measured: the size of the correction is the model's alone; touch the first part")
            )
        else:
            x, y = self.axes.ms
            said.append(phrase("transfer function of the axes at the first touch: MSx {:.4f}, MSy {:.4f}", x, y))
        return tuple(said)


def require_setup(setup: Setup | None, settings: Settings, radius: float) -> Setup:
    """The setup of a correction that needs one; UsageError where it is missing or of another tool."""
    if setup is None:
        raise UsageError(
            phrase(
                "{} needs {}: tool, material, machine and stock",
                option("method", settings.method),
                option("setup", of="SETUP.toml"),
            ),
        )
    if abs(setup.tool.radius - radius) > 1e-9:
        raise UsageError(
            phrase(
                "{}: [tool] diameter_mm {:g} is not the tool diameter of the program, {:g}",
                Place(setup.source or "setup"),
                setup.tool.diameter_mm,
                2 * radius,
            ),
        )
    return setup


def predicted_displacement(
    part: Part, nominal: Profile, setup: Setup, settings: Settings, corrected_before: bool
) -> WantedDisplacement:
    """Displacement of a predicted surface, which is treated as a measured one.

    Parameters
    ----------
    part : Part
        The predicted surface.
    nominal : Profile
    setup : Setup
    settings : Settings
        Its filter counts only where it was chosen: a model has no random part for `auto` to find.
    corrected_before : bool

    Returns
    -------
    WantedDisplacement
        By the transfer function point by point where the stock is an even allowance and little of it stays, else by
        mirroring.
    """
    depth = setup.stock.allowance_mm
    chosen = replace(settings, method="mirror", iterate=None)
    machine = part.machine
    if depth is not None and depth > 0 and machine.min(initial=0.0) >= 0 and machine.max() <= LEAST_DEPTH * depth:
        chosen = replace(chosen, method="transfer", depth=(depth,))
    return displacement_without_noise(part, nominal, chosen, corrected_before)


def aim_of(work: WantedDisplacement) -> Aim:
    """Aim through the points of a wanted displacement."""
    d = work.deviation
    return Aim(d.contour, d.stretch, d.s, work.wanted, work.yields)


def predict(
    aim: Aim,
    before: Simulation,
    first: FirstCut | None,
    settings: Settings,
    name: str,
    lay: Callable[[Correction], Emission],
) -> tuple[Prediction, Correction, Emission, tuple[str, ...]]:
    """Correct, and simulate what was written.

    Parameters
    ----------
    aim : Aim
    before : Simulation
        Of the program as it came.
    first : FirstCut or None
    settings : Settings
        Its limit and the bound to iterate to.
    name : str
        Name of the program, for messages.
    lay : callable
        From a correction to the program that carries it.

    Returns
    -------
    Prediction, Correction, Emission
    tuple of str
        What is to be said of it.

    Raises
    ------
    MillcorrError
        As `settle`.
    """

    def cut(emission: Emission) -> Simulation:
        written = nc.parse(emission.text, name)
        earlier = None if first is None else first.program
        return simulate(written, before.setup, before.nominal, stock=before.stock, earlier=earlier)

    radius = before.setup.tool.radius
    _, correction, notes, written, passes = settle(
        aim, before.nominal, lay=lay, cut=cut, radius=radius, limit=settings.limit, bound=settings.iterate
    )
    return Prediction(before, passes), correction, written, (*notes, *before.cautions)


@dataclass(frozen=True, eq=False, slots=True)
class FirstCut:
    """First cut of a single piece: its program, and the profile that it should have left.

    Parameters
    ----------
    program : Program
    profile : Profile
        Nominal with the allowance.
    allowance : float
        mm.
    """

    program: nc.Program
    profile: Profile
    allowance: float


def combined_displacement(
    parts: list[Part],
    program: nc.Program,
    nominal: Profile,
    setup: Setup,
    settings: Settings,
    corrected_before: bool,
    first: FirstCut | None,
    offset_at: Callable[[Deviation], Floats],
) -> tuple[WantedDisplacement, Aim, Simulation, AxisTransfer, Machine]:
    """Displacement of touches that a simulation carries along the whole contour.

    Parameters
    ----------
    parts : list of Part
        Touched parts, all cut alike.
    program : Program
        The one to correct.
    nominal : Profile
    setup : Setup
        Its stock is what the touched parts were cut from.
    settings : Settings
    corrected_before : bool
        Whether the program carries a correction.
    first : FirstCut or None
        What cut the touched part, if not the program.
    offset_at : callable
        Program's own offset at a Deviation's points, mm.

    Returns
    -------
    WantedDisplacement
        At the touches.
    Aim
        Along the whole contour.
    Simulation
        Of the program, on the machine that the touches show.
    AxisTransfer, Machine
    """
    touched = parts[0].deviation
    depth = _depth(parts, setup, settings)
    value = parts[0].machine
    if len(parts) > 1:
        value = averaged([(p.deviation, p.machine) for p in parts], nominal).mean
    removed = depth - parts[0].offset
    stock = stock_of(setup, nominal)
    cut_by = program if first is None else first.program
    allowance = 0.0 if first is None else first.allowance
    place = touched.foot + allowance * touched.normal
    fed = at_real_feed(cut_by, setup)
    rigid = engagement(fed, setup, stock)
    area = Contacts.of(rigid, place, touched.normal).take(rigid.area)
    area = area * depth / np.maximum(removed, 1e-9)
    table = setup.machine.stiffness_along
    whole = np.full(len(value), depth)
    soft = _softness(setup, nominal, touched.foot, touched.normal)
    axes = identify(value, whole, removed, area * soft, touched.normal, touched.foot)
    profile = nominal if first is None else first.profile
    feet = FootPointSearch(profile, margin=2.0).find(place)
    contour, s = profile.contour[feet.span], profile.arc_length(feet.span, feet.t)
    goal = value + parts[0].offset
    cut: list[Simulation] = []

    def force(machine: Machine | None) -> tuple[Floats, Floats]:
        if machine is None:
            contacts = Contacts.of(rigid, place, touched.normal)
            return parts[0].offset, contacts.take(cutting(rigid, setup).force)
        done = simulate(cut_by, machine.of(setup), profile, stock=stock)
        cut[:] = [done]
        bent = done.elastic.cutting
        forces = Contacts.of(bent.engagement, place, touched.normal).take(bent.force)
        left = done.error_at(contour, s)
        if not np.isfinite(left).all():
            x, y = touched.foot[int(np.flatnonzero(~np.isfinite(left))[0])]
            raise UsageError(phrase("at {} a point was touched that the simulated program does not cut", xy(x, y)))
        return left, forces

    share = weights_at(setup, nominal, touched.foot) if table else None
    machine = identify_machine(goal, touched.normal, force, table, share)
    notes: tuple[str, ...] = ()
    if table:
        # How soft each place is, is known now.
        setup = machine.of(setup)
        soft = _softness(setup, nominal, touched.foot, touched.normal)
        axes = identify(value, whole, removed, area * soft, touched.normal, touched.foot)
        if not machine.separate:
            notes += (
                phrase(
                    "the touches do not tell the rows of [machine] stiffness_along apart: all are off by one "
                    "factor; touch at each of its places"
                ),
            )
    if len(touched) > 1 and not axes.separate:
        notes += (phrase("the touches do not tell the axes apart: both are taken as equally stiff"),)
    if first is None:
        before = cut[0]
    else:
        before = simulate(program, machine.of(setup), nominal, stock=stock, earlier=first.program)
    d = before.deviation
    if first is None:
        load, stood = rigid, np.ones(len(d))
    else:
        load = engagement(one_after_another(fed, at_real_feed(program, setup)), setup, stock)
        # The second cut finds what the first one left, too.
        done = Contacts.of(rigid, d.foot + allowance * d.normal, d.normal).take(rigid.area)
        done = done * _softness(setup, nominal, d.foot, d.normal)
        stood = 1.0 + _left(axes, done, d.normal, depth) / allowance
    areas = Contacts.of(load, d.foot, d.normal).take(load.area) * stood
    areas = areas * _softness(setup, nominal, d.foot, d.normal)
    offset = offset_at(d)
    if first is None:
        areas = areas * depth / np.maximum(depth - offset, 1e-9)
    base = offset if corrected_before else np.zeros(len(d))
    yields = 1.0 + axes.along(areas, d.normal) * axes.depth / (depth if first is None else allowance * stood)
    wanted = base - settings.gain * (base - axes.correction(areas, d.normal))
    aim = Aim(d.contour, d.stretch, d.s, wanted, yields)
    work = replace(_touches(parts, value, depth, area * soft, axes), notes=notes)
    return work, aim, before, axes, machine


def _softness(setup: Setup, nominal: Profile, place: Floats, normal: Floats) -> Floats:
    """Compliance along normals at places over that of the setup's kx and ky; (n,), 1 without a table."""
    if not setup.machine.stiffness_along:
        return np.ones(len(place))
    square = normal**2
    here = (square * compliance_at(setup, nominal, place)).sum(axis=1)
    out: Floats = here / (square @ (1.0 / np.array(setup.machine.stiffness(setup.source))))
    return out


def _left(axes: AxisTransfer, area: Floats, normal: Floats, depth: float) -> Floats:
    """What a cut of a depth leaves, mm: of ``delta = C sq (depth - delta) / depth``; (n,)."""
    whole = -axes.correction(area, normal)
    out: Floats = whole * depth / (depth + whole)
    return out


def _depth(parts: list[Part], setup: Setup, settings: Settings) -> float:
    """Depth that the touched parts were cut at, mm."""
    depths, allowances = set(settings.depths), {part.allowance for part in parts}
    if len(depths) > 1 or len(allowances) > 1:
        raise UsageError(
            phrase(
                "{} takes parts of one depth; for several depths use {}",
                option("method", "combined"),
                remedy("method", "transfer"),
            ),
        )
    if depths:
        return depths.pop()
    whole, left = setup.stock.allowance_mm, allowances.pop()
    if whole is None:
        raise UsageError(
            phrase(
                "{} needs {}: the stock of the setup is no even allowance_mm",
                option("method", "combined"),
                option("depth", of="MM"),
            ),
        )
    if not whole > left:
        raise UsageError(
            phrase(
                "{} is no part of [stock] allowance_mm {:g}, which the first cut started from",
                option("allowance", left),
                whole,
            ),
        )
    return whole - left


def _touches(parts: list[Part], value: Floats, depth: float, area: Floats, axes: AxisTransfer) -> WantedDisplacement:
    """Deviations at the touches with what the transfer functions make of them."""
    first = parts[0]
    deviation, offset = first.deviation, first.offset
    if value is not first.machine:
        deviation = replace(deviation, value=offset + value)
    whole = -axes.correction(area, deviation.normal)
    removed = depth - offset
    determined = whole * removed / (depth + whole)
    transfer = _transfer(axes, area, deviation, depth)
    growth = (1.0 + transfer.ms) ** 2
    elastic = Elastic(transfer, transfer, np.full(len(deviation), depth), (depth,), "by axis")
    return WantedDisplacement(
        deviation,
        offset,
        offset + determined,
        transfer.ms_std * removed / growth,
        np.zeros(len(deviation)),
        axes.scatter,
        elastic=elastic,
    )


def _transfer(axes: AxisTransfer, area: Floats, deviation: Deviation, depth: float) -> TransferFunction:
    zero = np.zeros(len(deviation))
    ms = -axes.correction(area, deviation.normal) / depth
    return TransferFunction(ms, axes.correction_std(area, deviation.normal) / depth, zero, zero.copy(), zero.copy())
