# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr simulate`: a program or an operation cut in the model of a setup."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

from millcorr import pipeline
from millcorr.errors import UsageError
from millcorr.messages import option
from millcorr.process import setup_file
from millcorr.production.simulation import NOTHING, Asked, study
from millcorr.report import simulation as report_simulation
from millcorr.whole_file import refuse_places, replaced_whole

from .inputs import UNSAID, nominal_file, operation_contour, program_request, read_nominal


def simulate_program(
    program: Path | None = None,
    *,
    document: Path | None = None,
    operation: str | None = None,
    setup: Path,
    report: Path,
    nominal: str | None = None,
    settings: pipeline.Settings,
    asked: Asked = NOTHING,
) -> str:
    """Cut a program in the model of a setup, and write what happens: table, plots and an animation.

    Parameters
    ----------
    program : Path, optional
        NC program, or else
    document : Path, optional
        FreeCAD document with the operation.
    operation : str, optional
        Its label; may be left out where the document has one Profile.
    setup : Path
        Tool, material, machine and stock.
    report : Path
        Directory.
    nominal : str, optional
        Profile; by default the contour that the program cuts.
    settings : pipeline.Settings
        For the corrected line.
    asked : Asked, optional
        Heights of the wall, remedies to write as programs, and a log of the machine.

    Returns
    -------
    str
        What was found, in a few lines.

    Raises
    ------
    MillcorrError
        If program or setup cannot be used, or a remedy is refused; nothing is written then.
    """
    inputs = {"program": program, "document": document, "nominal": nominal_file(nominal), "setup": setup}
    inputs |= {"log": asked.trace}
    outputs = {"slowed": asked.slowed, "shifted": asked.shifted, "tilted": asked.tilted}
    refuse_places(outputs, inputs, report, report_simulation.FILES)
    if program is not None:
        if operation is not None:
            raise UsageError(option("operation"), " belongs to ", option("document"))
        request = program_request(program, (), UNSAID, nominal, None, settings, setup)
    elif document is None:
        raise UsageError(option("program"), " or ", option("document"), " is needed: what is to be cut")
    else:
        for name, place in outputs.items():
            if place is not None:
                raise UsageError(
                    option(name), " belongs to ", option("program"), ": give the program that the job is posted as"
                )
        request = _operation_request(document, operation, nominal, settings, setup)
    found = study(request, asked)
    with ExitStack() as programs:
        for place, data in found.programs().items():
            programs.enter_context(replaced_whole(place, data))
        return report_simulation.write(found, report)


def _operation_request(
    document: Path, operation: str | None, nominal: str | None, settings: pipeline.Settings, setup: Path
) -> pipeline.Request:
    """What a simulation of an operation asks of the pipeline."""
    known = setup_file.load(setup)
    profile, path, radius = operation_contour(document, operation)
    if nominal is not None:
        profile = read_nominal(nominal, radius, settings, None, document)
    return pipeline.Request(path, radius, None, profile, settings, setup=known)
