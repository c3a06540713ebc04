# SPDX-License-Identifier: LGPL-2.1-or-later
"""From file names to a measuring program: `millcorr probe`."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

from . import gcode as nc
from . import measuring_programs, pipeline
from .errors import UsageError
from .measuring_programs import MeasuringProgram
from .probing import Placement, TouchProbe
from .probing.heights import Cleared
from .profile import Profile
from .session.inputs import nominal_file, operation_contour, read_nominal
from .settings import Settings
from .toolpath import Compensation
from .whole_file import refuse_places, replaced_whole

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
        The contour itself, as `session.read_nominal` takes it; with a program or without.
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
    inputs = {"program": program, "document": document, "nominal": first}
    refuse_places({"--output": output}, inputs)
    settings = Settings(side=side, cutter_compensation=cutter_compensation)
    profile, cleared = _contour(program, document, operation, nominal, tool_diameter, settings)
    source = next(path.name for path in (program, document, first) if path is not None)
    plan = prepared(
        profile, cleared, output, dialect=dialect, probe=probe, placement=placement, source=source, **options
    )
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
        Heights in mm; by default what `cleared` suggests.
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
    suggested = None if cleared is None else measuring_programs.heights(cleared, profile, placement.get("contour"))
    low, high = suggested or (z, safe_z)
    z, safe_z = low if z is None else z, high if safe_z is None else safe_z
    if z is None or safe_z is None:
        raise UsageError("say --z and --safe-z: what the contour comes from shows no cut beside it, or no rapid above")
    where = dict(placement)
    if where.get("count") is None and where.get("spacing") is None:
        where["count"] = POINTS
    names = measuring_programs.names_of(dialect, output.stem)
    return partial(
        measuring_programs.measuring_program,
        profile,
        dialect=dialect,
        probe=TouchProbe(**probe),
        placement=Placement(**where),
        z=z,
        safe_z=safe_z,
        source=source,
        cleared=cleared,
        **{"name": names.name, "log": names.log} | {k: v for k, v in options.items() if v is not None},
    )


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
        refuse_places({f"--output {output} needs a file beside it:": place}, {"output": output, **inputs})
    except UsageError as error:
        raise UsageError(f"{error}; choose another name for --output") from error
    if not place.exists() or place.read_bytes() == text.encode("ascii"):
        return
    older = output.read_text(encoding="latin-1") if output.is_file() else ""
    # A control's name for the file ends at its own end: ONE.A is not called by a program that prints through BONE.A.
    calls = re.search(rf"(?<![A-Za-z0-9_]){re.escape(place.name)}(?![A-Za-z0-9_])", older)
    if measuring_programs.HEADLINE not in older or calls is None:
        raise UsageError(
            f"--output {output} needs {place.name} beside it, and {place} belongs to another program: "
            "choose another name for --output, or move that file away"
        )


def _contour(
    program: Path | None,
    document: Path | None,
    operation: str | None,
    nominal: str | None,
    tool_diameter: float | None,
    settings: Settings,
) -> tuple[Profile, Cleared | None]:
    """The contour to measure, and what cuts it."""
    given = settings.cutter_compensation == "contour"
    if operation is not None and document is None:
        raise UsageError("--operation belongs to --document")
    if document is not None:
        own, path, radius = operation_contour(document, operation)
        chosen = own if nominal is None else read_nominal(nominal, radius, settings, None, document)
        return chosen, Cleared(path.toolpath, radius, given)
    if program is None:
        if nominal is None:
            raise UsageError("say what to measure: --program, --document or --nominal")
        if Path(nominal.partition("#")[0]).suffix.lower() in (".nc", ".ngc", ".tap", ".gcode"):
            raise UsageError(f"--nominal {nominal}: give a program as --program, with --tool-diameter")
        return read_nominal(nominal, 0.0, settings, None), None
    if tool_diameter is None or not 0 < tool_diameter < float("inf"):
        raise UsageError("--program needs --tool-diameter: the program does not say how large the cutter is")
    source, radius = nc.read(program), tool_diameter / 2
    if nominal is not None:
        return read_nominal(nominal, radius, settings, None), Cleared(source.toolpath, radius, given)
    if settings.side == "auto" and not (source.toolpath.compensation != Compensation.OFF).any():
        raise UsageError(
            "--side left or --side right: the program has no G41 or G42 that tells on which side the part is"
        )
    return pipeline.nominal_from_program(source, radius, settings, None), Cleared(source.toolpath, radius, given)
