# SPDX-License-Identifier: LGPL-2.1-or-later
"""Last stage: the moves of the corrected program, its text, and the proof of both."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath

from millcorr import __version__, progress
from millcorr.arrays import Ints
from millcorr.correction import provenance
from millcorr.geometry.correction import Correction
from millcorr.path.emission import Emission, emit
from millcorr.process.prediction.predicted_correction import Prediction, predict
from millcorr.tolerances import EXACT

from .aimed import Aimed
from .prepared import Prepared
from .request import Request


@dataclass(frozen=True, eq=False, slots=True)
class Written:
    """A corrected program, proven.

    Parameters
    ----------
    emission : Emission
        Its origin: moves of the program as it came.
    correction : Correction
        What it carries.
    prediction : Prediction or None
        What the model of a setup says before and after.
    notes : tuple of str
    """

    emission: Emission
    correction: Correction
    prediction: Prediction | None
    notes: tuple[str, ...]


def write(prepared: Prepared, aimed: Aimed, noted: Sequence[Ints]) -> Written:
    """Lay the program on the moved contour, by as many simulations as a model needs to settle.

    Parameters
    ----------
    prepared : Prepared
    aimed : Aimed
    noted : sequence of (24,) int64
        Deviations that the program notes.

    Raises
    ------
    LimitError, FitError
        If the path would be unsafe, or the text does not prove.
    """
    progress.stage("write")
    passes, settings, program = prepared.passes, aimed.request.settings, aimed.request.program
    title = header(aimed.request, noted)
    notes: list[str] = []

    def lay(correction: Correction) -> Emission:
        moves = passes.divided if correction.largest > EXACT else passes.whole
        emission, said = emit(
            program,
            moves.toolpath,
            moves.following,
            moves.along,
            passes.nominal,
            correction,
            passes.radius,
            passes.cutters[moves.origin],
            settings,
            header=title,
            carried=passes.carried,
            exact=passes.drawn,
            original_error=passes.error,
            measured=aimed.work.deviation if len(aimed.work.deviation) else None,
        )
        notes.extend(note for note in said if note not in notes)
        regeneration = replace(emission.regeneration, origin=moves.origin[emission.regeneration.origin])
        return replace(emission, regeneration=regeneration)

    if aimed.modelled is None:
        return Written(lay(aimed.correction), aimed.correction, None, tuple(notes))
    model = aimed.modelled
    prediction, correction, emission, said = predict(model.aim, model.before, model.first, settings, program.name, lay)
    prediction = replace(prediction, axes=model.axes, machine=model.machine)
    return Written(emission, correction, prediction, tuple(dict.fromkeys((*notes, *said))))


def header(request: Request, noted: Sequence[Ints]) -> tuple[str, ...]:
    """Comment lines that mark the corrected program."""
    program, left = request.program, request.settings.leave_stock
    if left:
        return (f"millcorr {__version__} first cut, leaves {left:g} mm", f"of {PurePath(program.name).name}")
    if request.shift is not None:
        # Marked like any correction: the path no longer shows the nominal.
        moved = f"contour moved against a bending tool by at most {request.shift.largest:.4f} mm"
        digest = hashlib.sha256(f"{program.digest} {moved}".encode()).hexdigest()
        return provenance.header([("nothing, predicted", digest)], (program.name, program.digest), moved)
    if request.measurement is None:
        return (f"millcorr {__version__} path laid on the exact nominal, no correction",)
    return provenance.header(
        [(m.source, m.fingerprint) for m in request.measurements],
        (program.name, program.digest),
        request.settings.in_words(),
        noted,
    )
