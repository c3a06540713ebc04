# SPDX-License-Identifier: LGPL-2.1-or-later
"""Third stage: how far the contour is to be moved, by one of the methods."""

from __future__ import annotations

from dataclasses import dataclass, replace

from millcorr import plausibility, progress
from millcorr.comparison.deviation import deviations
from millcorr.correction.wanted_displacement import (
    Part,
    WantedDisplacement,
    carried_along,
    correction_through,
    smoothed_over_parts,
    wanted_displacement,
)
from millcorr.geometry.correction import Correction
from millcorr.process.prediction import Aim, Simulation, simulate
from millcorr.process.prediction.combined_control import AxisTransfer, Machine
from millcorr.process.prediction.predicted_correction import (
    FirstCut,
    aim_of,
    combined_displacement,
    predicted_displacement,
)

from .compared import Compared
from .prepared import Prepared
from .request import Request


@dataclass(frozen=True, eq=False, slots=True)
class Modelled:
    """A correction that a model of the cut settles, from the simulation of the program as it came.

    Parameters
    ----------
    aim : Aim
    before : Simulation
    first : FirstCut or None
        What cut the touched part of a single piece.
    axes : AxisTransfer or None
    machine : Machine or None
        What touches say of the machine.
    """

    aim: Aim
    before: Simulation
    first: FirstCut | None = None
    axes: AxisTransfer | None = None
    machine: Machine | None = None


@dataclass(frozen=True, eq=False, slots=True)
class Aimed:
    """What the contour is to be moved by.

    Parameters
    ----------
    request : Request
        With the predicted surface in place of a measurement, where a model made it.
    work : WantedDisplacement
        Deviations at the points and what became of them.
    correction : Correction
        Zero where a model settles it.
    carried : Correction or None
        What the program carries already, put right at the points.
    modelled : Modelled or None
    notes : tuple of str
    """

    request: Request
    work: WantedDisplacement
    correction: Correction
    carried: Correction | None
    modelled: Modelled | None
    notes: tuple[str, ...]


def aim(prepared: Prepared, compared: Compared, first: FirstCut | None) -> Aimed:
    """Displacement of the contour by the method that the settings name.

    Parameters
    ----------
    prepared : Prepared
    compared : Compared
    first : FirstCut or None
        What cut the touched part of a single piece, for the combined method.

    Raises
    ------
    MillcorrError
        As the method's own function; each names the place.
    """
    if prepared.request.settings.method == "predicted":
        return _predicted(prepared)
    if not compared.parts:
        return _laid(prepared)
    return _measured(prepared, compared) if prepared.setup is None else _combined(prepared, compared, first)


def _laid(prepared: Prepared) -> Aimed:
    """Nothing was measured: the path is laid on the nominal, or moved by what is known beforehand."""
    request, nominal = prepared.request, prepared.passes.nominal
    shift = request.shift or Correction.even(nominal, request.settings.leave_stock)
    return Aimed(request, WantedDisplacement.empty(), shift, None, None, ())


def _predicted(prepared: Prepared) -> Aimed:
    """By the simulated surface of the program, without a measurement."""
    request, nominal = prepared.request, prepared.passes.nominal
    assert prepared.setup is not None
    progress.stage("simulate")
    before = simulate(request.program, prepared.setup, nominal)
    request = replace(request, measurement=before.surface())
    deviation = deviations(before.surface(), nominal, cutter_radius=request.radius)
    offset = prepared.commanded_at(deviation)
    part = Part(deviation, offset, deviation.value - offset)
    work = predicted_displacement(part, nominal, before.setup, request.settings, bool(prepared.history.marks))
    return Aimed(request, work, Correction.none(nominal), None, Modelled(aim_of(work), before), work.notes)


def _measured(prepared: Prepared, compared: Compared) -> Aimed:
    """By what repeats of measured deviations: mirrored, or through the machining system's transfer function."""
    request, nominal, settings = prepared.request, prepared.passes.nominal, prepared.request.settings
    progress.stage("separate")
    work = wanted_displacement(list(compared.parts), nominal, settings, bool(prepared.history.marks))
    notes = list(work.notes)
    if work.separated is not None:
        seen = plausibility.examine_separated(work.deviation, work.separated, nominal, settings.unmeasured_share)
        notes += plausibility.refuse_dangerous(seen, settings.accept, request.measurements[0].source)
    if request.smoothed is not None:
        work = smoothed_over_parts(work, request.smoothed, nominal, settings)
    carried = None if prepared.rest is None else carried_along(prepared.rest, work, nominal)
    rest = prepared.rest if work.smoothed is None else carried
    correction, said = correction_through(work, nominal, settings, rest)
    return Aimed(request, work, correction, carried, None, (*notes, *said))


def _combined(prepared: Prepared, compared: Compared, first: FirstCut | None) -> Aimed:
    """By touches and a model of the cut."""
    request, nominal, settings = prepared.request, prepared.passes.nominal, prepared.request.settings
    assert prepared.setup is not None
    progress.stage("simulate")
    work, target, before, axes, machine = combined_displacement(
        list(compared.parts), request.program, nominal, prepared.setup, settings, bool(prepared.history.marks), first,
        prepared.commanded_at,
    )  # fmt: skip
    if request.smoothed is not None:
        work = smoothed_over_parts(work, request.smoothed, nominal, settings)
    modelled = Modelled(target, before, first, axes, machine)
    return Aimed(request, work, Correction.none(nominal), None, modelled, work.notes)
