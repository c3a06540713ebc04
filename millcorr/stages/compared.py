# SPDX-License-Identifier: LGPL-2.1-or-later
"""Second stage: measured parts against the nominal and what the program commands, and whether to believe them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from millcorr import plausibility, progress
from millcorr.arrays import Ints
from millcorr.comparison import alignment
from millcorr.comparison.ball_radius import axis_residue, contact_known, numbered_as_read
from millcorr.comparison.deviation import deviations, require_heights
from millcorr.correction import provenance
from millcorr.correction.wanted_displacement import Part
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase
from millcorr.readers.measurement import Measurement

from .prepared import Prepared
from .request import Request

LEAST_UNDER = 0.05
"""A first cut leaves its allowance and what the machine yields, never less by more than this, in mm."""


@dataclass(frozen=True, eq=False, slots=True)
class Compared:
    """Measured parts with their deviations.

    Parameters
    ----------
    parts : tuple of Part
    aligned : Alignment or None
        What the best fit of the first part moved; None without one.
    noted : tuple of (24,) int64
        Deviations of each part that the corrected program notes, to recognise the part by.
    notes : tuple of str
        What may be wrong.
    """

    parts: tuple[Part, ...]
    aligned: alignment.Alignment | None
    noted: tuple[Ints, ...]
    notes: tuple[str, ...]


@dataclass(frozen=True, eq=False, slots=True)
class _Compared:
    part: Part
    aligned: alignment.Alignment | None
    noted: Ints


def compare(prepared: Prepared) -> Compared:
    """Deviations of every measured part, aligned where that is asked for.

    Raises
    ------
    InputError
        If a part was not cut by the program, or with another allowance.
    RefusedError, DistrustError
        If a part is in the program already, or a finding is dangerous and not accepted.
    """
    request, nominal = prepared.request, prepared.passes.nominal
    heights = plausibility.CutHeights.of(prepared.passes.divided.toolpath, prepared.passes.divided.following, nominal)
    notes: list[str] = []
    found = []
    for row in range(len(prepared.surfaces)):
        one, said = _compared(prepared, row, heights)
        found.append(one)
        notes += [note for note in said if note not in notes]
    if request.settings.method != "combined" and found:
        with_points = [(m, one.part.deviation) for m, one in zip(request.measurements, found, strict=True)]
        at_first = request.settings.method == "transfer"
        together = plausibility.examine_parts(with_points, nominal, at_first=at_first)
        notes += plausibility.refuse_dangerous(together, request.settings.accept, request.measurements[0].source)
    aligned = next((one.aligned for one in found if one.aligned), None)
    return Compared(tuple(one.part for one in found), aligned, tuple(one.noted for one in found), tuple(notes))


def _compared(prepared: Prepared, row: int, heights: plausibility.CutHeights) -> tuple[_Compared, tuple[str, ...]]:
    """One part against the nominal and the program, and what is said of it."""
    request, history, nominal = prepared.request, prepared.history, prepared.passes.nominal
    settings, read, surface = request.settings, request.measurements[row], prepared.surfaces[row]
    depth, allowance = prepared.depths[row], prepared.allowances[row]
    naming = partial(plausibility.named, read.source if len(prepared.surfaces) > 1 else "")
    notes = list(naming(plausibility.refuse_dangerous(plausibility.examine_file(read), settings.accept, read.source)))
    _refuse_wrong_allowance(surface, nominal, allowance)
    progress.stage("fit")
    moved, aligned, said = _believed(surface, nominal, request, depth, allowance)
    notes += said
    progress.stage("compare")
    # A cutter that leaves an allowance reaches the nominal where one larger by it would.
    deviation = numbered_as_read(deviations(moved, nominal, cutter_radius=request.radius + allowance), moved)
    deviation = replace(deviation, step=plausibility.resolution(read))
    noted = provenance.values_of(deviation, nominal)
    # Parts of a series come back to the same size by wear; its journal knows which it has seen.
    if history.again is None and not request.in_series:
        otherwise = provenance.recognised(history.marks, noted, deviation.step)
        if otherwise is not None:
            provenance.refuse_mark(otherwise, request.program.name)
    # A first cut that millcorr wrote runs on the exact parallel; what this program is off by came after it.
    by_another = bool(allowance) or history.again is not None
    offset = np.zeros(len(deviation)) if by_another else prepared.commanded_at(deviation, surface.has_z)
    if len(lost := np.flatnonzero(np.isnan(offset))):
        deviation = deviation.without(lost, "where another move of the program cuts the profile away")
        offset = np.delete(offset, lost)
    machine = deviation.value - offset
    if request.nominal is None and not by_another:
        # The nominal is what the passes leave; the profile only says where and which way.
        deviation, offset = replace(deviation, value=machine), np.zeros(len(machine))
    progress.stage("examine")
    findings = plausibility.examine_deviations(
        deviation,
        nominal,
        request.radius,
        ball_radius=moved.ball_radius - allowance,
        heights=heights if surface.has_z else None,
        step=deviation.step,
        depth=depth,
    )
    if history.marks and not by_another:
        findings += plausibility.examine_program(deviation, offset, provenance.gain(request.program.comments()))
    if len(prepared.surfaces) > 1:
        # One part without a deviation is a warning; among several it would take its share of the others'.
        same = "identical-to-nominal"
        findings = tuple(replace(f, dangerous=f.dangerous or f.name == same) for f in findings)
    notes += naming(plausibility.refuse_dangerous(findings, settings.accept, surface.source))
    return _Compared(Part(deviation, offset, machine, allowance), aligned, noted), tuple(notes)


def _refuse_wrong_allowance(surface: Measurement, nominal: Profile, allowance: float) -> None:
    """InputError where the points lie on the nominal itself and not an allowance over it."""
    if not allowance:
        return
    points = surface.points[:: max(1, len(surface) // plausibility.SAMPLE), :2]
    over = FootPointSearch(nominal, margin=surface.ball_radius + 1.0).find(points).distance - surface.ball_radius
    if np.median(over) < -LEAST_UNDER:
        raise InputError(
            phrase(
                "{}: the points lie {} off the profile and not {} over it: check {}; it belongs to a part "
                "with stock left on it, and {} is then the program that finishes it",
                surface.source,
                mm(np.median(over) + allowance, "+.3f"),
                mm(allowance, "g"),
                option("allowance"),
                option("program"),
            ),
        )


def _believed(
    measurement: Measurement, nominal: Profile, request: Request, depth: float, allowance: float
) -> tuple[Measurement, alignment.Alignment | None, tuple[str, ...]]:
    """The measurement, aligned if that is asked for, after looking whether it can be what it is said to be; notes."""
    settings = request.settings
    require_heights(measurement, nominal)
    freedom = alignment.Freedom.parse(settings.align)
    known = contact_known(measurement, nominal)
    residue = axis_residue(measurement, known, nominal)
    findings = plausibility.examine_points(known, nominal, request.radius, depth, allowance)
    if residue is not None:
        findings = (plausibility.Finding(*residue), *findings)
    notes = tuple(plausibility.refuse_dangerous(findings, settings.accept, known.source))
    if not any(freedom.free):
        return known, None, notes
    moved, aligned = alignment.align(known, nominal, freedom)
    return moved, aligned, (*notes, *aligned.warnings)
