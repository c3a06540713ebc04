# SPDX-License-Identifier: LGPL-2.1-or-later
"""From file names to a measuring program: `millcorr probe`."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

from millcorr import nc, pipeline
from millcorr.correction.settings import Settings
from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import message, option, remedy
from millcorr.nc.toolpath import Compensation
from millcorr.probing import Placement, TouchProbe
from millcorr.probing import controls as measuring_programs
from millcorr.probing.controls import MeasuringProgram
from millcorr.probing.heights import Cleared
from millcorr.probing.workpiece import Workpiece
from millcorr.readers import stl
from millcorr.readers.source import Source
from millcorr.whole_file import refuse_places, replaced_whole

from .verbs.inputs import nominal_file, operation_and_model, read_nominal

POINTS = 40
"""So many points where nothing is said."""


def measuring_program(
    *,
    dialect: str,
    probe: Mapping[str, Any],
    placement: Mapping[str, Any],
    output: Path,
    program: Path | None = None,
    document: Path | None = None,
    operation: str | None = None,
    nominal: str | None = None,
    model: Path | None = None,
    tool_diameter: float | None = None,
    side: str = "auto",
    cutter_compensation: str = "contour",
    **options: Any,
) -> str:
    """Write a program that measures a contour on the machine.

    Parameters
    ----------
    dialect : str
        Name from `measuring_programs.DIALECTS`.
    probe, placement : mapping
        Fields of `probing.TouchProbe` and `probing.Placement`.
    output : Path
        Measuring program; what else the control needs is written beside it.
    program, document : Path, optional
        What cuts the contour: an NC program, or a FreeCAD document with the label of its `operation`.
    nominal : str, optional
        The contour itself, as `verbs.read_nominal` takes it; with a program or without.
    model : Path, optional
        The finished part as STL in mm, in the program's frame; a document has its own.
    tool_diameter : float, optional
        Cutter in mm, with `program`.
    side, cutter_compensation : str
        As in `settings.Settings`.
    **options
        ``z, safe_z, feed, positioning, tool, log`` as in `prepared`.

    Returns
    -------
    str
        What was written, and how to read back what the control will log.

    Raises
    ------
    UsageError
        If an option has no such value or one is missing.
    MillcorrError
        If an input cannot be used or no point can be touched; nothing is written then.
    """
    first = nominal_file(nominal)
    inputs = {"program": program, "document": document, "nominal": first, "model": model}
    refuse_places({"output": output}, inputs)
    settings = Settings(side=side, cutter_compensation=cutter_compensation)
    profile, cleared, workpiece = _contour(program, document, operation, nominal, tool_diameter, settings)
    if model is not None:
        workpiece = Workpiece(stl.facets(Source(model.read_bytes(), str(model), "")))
    source = next(path.name for path in (program, document, first) if path is not None)
    plan = prepared(
        profile, cleared, output, dialect=dialect, probe=probe, placement=placement, source=source,
        workpiece=workpiece, **options,
    )  # fmt: skip
    return save(plan(), output, inputs)


def prepared(
    profile: Profile,
    cleared: Cleared | None,
    output: Path,
    *,
    dialect: str,
    probe: Mapping[str, Any],
    placement: Mapping[str, Any],
    source: str,
    z: float | None = None,
    safe_z: float | None = None,
    workpiece: Workpiece | None = None,
    **options: Any,
) -> Callable[[], MeasuringProgram]:
    """Look at what is asked now, and give what plans and writes.

    Parameters
    ----------
    profile : Profile
        The contour to measure.
    cleared : Cleared or None
        What cuts it.
    output : Path
        File that it will be written to; program and log are named after it.
    dialect, source : str
    probe, placement : mapping
        As in `measuring_program`; `POINTS` points where nothing is said.
    z, safe_z : float, optional
        Heights in mm; by default what `cleared` and `workpiece` suggest.
    workpiece : Workpiece, optional
        The finished part.
    **options
        ``feed, positioning, tool, log, name`` of `measuring_programs.measuring_program`; None leaves one as it is.

    Returns
    -------
    callable
        Gives the program; raises MillcorrError where nothing can be touched.

    Raises
    ------
    UsageError
        If an option has no such value or one is missing.
    """
    touch_probe, where = TouchProbe(**probe), wanted_at(placement)
    if z is None or safe_z is None:
        low, high = measuring_programs.heights(profile, where, touch_probe, cleared, workpiece)
        z, safe_z = low if z is None else z, high if safe_z is None else safe_z
    if z is None:
        raise UsageError(
            option("z"),
            ": say at which height to measure; neither model nor passes show a wall that is high enough for ",
            "the ball whether its length is set to the tip or the centre",
        )
    if safe_z is None:
        raise UsageError(option("safe_z"), ": say at which height the probe passes over everything; no rapid shows one")
    names = measuring_programs.names_of(dialect, output.stem)
    return partial(
        measuring_programs.measuring_program,
        profile,
        dialect=dialect,
        probe=touch_probe,
        placement=where,
        z=z,
        safe_z=safe_z,
        source=source,
        cleared=cleared,
        workpiece=workpiece,
        **{"name": names.name, "log": names.log} | {k: v for k, v in options.items() if v is not None},
    )


def wanted_at(placement: Mapping[str, Any]) -> Placement:
    """Where points are wanted, `POINTS` of them where nothing is said."""
    said = placement.get("count") is not None or placement.get("spacing") is not None
    return Placement(**(dict(placement) if said else {**placement, "count": POINTS}))


def save(made: MeasuringProgram, output: Path, inputs: Mapping[str, Path | None] | None = None) -> str:
    """Write a measuring program and what it needs beside it, as a whole; says what was written.

    Raises
    ------
    UsageError
        If a file beside it would take the place of the program, of one of the `inputs` (by what they are), or of
        what is not the older state of the same program. Nothing is written then.
    """
    places = {output.with_name(name): text for name, text in made.companions.items()}
    for place, text in places.items():
        _refuse_beside(output, place, text, inputs or {})
    with ExitStack() as stack:
        for place, text in {output: made.text, **places}.items():
            stack.enter_context(replaced_whole(place, text.encode("ascii")))
    written = [f"program     {output}", *(f"with it     {place}" for place in places)]
    return "\n".join([made.words(), *written])


def _refuse_beside(output: Path, place: Path, text: str, inputs: Mapping[str, Path | None]) -> None:
    """UsageError where a file that the program needs beside it would replace what does not belong to the program."""
    try:
        refuse_places(
            {message(option("output", output), " needs a file beside it:"): place}, {"output": output, **inputs}
        )
    except UsageError as error:
        raise UsageError(error.message, "; choose another name for ", option("output")) from error
    if not place.exists() or place.read_bytes() == text.encode("ascii"):
        return
    older = output.read_text(encoding="latin-1") if output.is_file() else ""
    # A control's name for the file ends at its own end: ONE.A is not called by a program that prints through BONE.A.
    calls = re.search(rf"(?<![A-Za-z0-9_]){re.escape(place.name)}(?![A-Za-z0-9_])", older)
    if measuring_programs.HEADLINE not in older or calls is None:
        raise UsageError(
            option("output", output),
            f" needs {place.name} beside it, and {place} belongs to another program: choose another ",
            "name for ",
            option("output"),
            ", or move that file away",
        )


def _contour(
    program: Path | None,
    document: Path | None,
    operation: str | None,
    nominal: str | None,
    tool_diameter: float | None,
    settings: Settings,
) -> tuple[Profile, Cleared | None, Workpiece | None]:
    """The contour to measure, what cuts it, and the part where a document has it."""
    given = settings.cutter_compensation == "contour"
    if operation is not None and document is None:
        raise UsageError(option("operation"), " belongs to ", option("document"))
    if document is not None:
        own, path, radius, workpiece = operation_and_model(document, operation)
        chosen = own if nominal is None else read_nominal(nominal, radius, settings, None, document)
        return chosen, Cleared(path.toolpath, radius, given), workpiece
    if program is None:
        if nominal is None:
            raise UsageError(
                "say what to measure: ", option("program"), ", ", option("document"), " or ", option("nominal")
            )
        if Path(nominal.partition("#")[0]).suffix.lower() in (".nc", ".ngc", ".tap", ".gcode"):
            raise UsageError(
                option("nominal", nominal),
                ": give a program as ",
                option("program"),
                ", with ",
                option("tool_diameter"),
            )
        return read_nominal(nominal, 0.0, settings, None), None, None
    if tool_diameter is None or not 0 < tool_diameter < float("inf"):
        raise UsageError(
            option("program"), " needs ", option("tool_diameter"), ": the program does not say how large the cutter is"
        )
    source, radius = nc.read(program), tool_diameter / 2
    if nominal is not None:
        return read_nominal(nominal, radius, settings, None), Cleared(source.toolpath, radius, given), None
    if settings.side == "auto" and not (source.toolpath.compensation != Compensation.OFF).any():
        raise UsageError(
            remedy("side", "left"),
            " or ",
            remedy("side", "right"),
            ": the program has no G41 or G42 that tells on which side the part is",
        )
    profile = pipeline.nominal_from_program(source, radius, settings, None)
    return profile, Cleared(source.toolpath, radius, given), None
