# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the files of a command hold: the request that a program makes, the nominal, and what must not be missing."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from millcorr import freecad_process, nc, pipeline
from millcorr.errors import InputError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import message, option, remedy
from millcorr.probing.workpiece import Workpiece
from millcorr.process import setup_file
from millcorr.readers import Reading
from millcorr.readers.measurement import Measurement

UNSAID = Reading()
"""Everything is as the measured file says."""

CAD_SUFFIXES = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".dxf")


def require_measured(measured: Sequence[Path], setup: Path | None, settings: pipeline.Settings) -> None:
    """UsageError where measured files or a setup are missing, or given to a method that takes none."""
    method = settings.method
    if method == "predicted":
        if measured:
            raise UsageError(
                option("method", "predicted"),
                " takes no ",
                option("measured"),
                ": with touches use ",
                remedy("method", "combined"),
            )
    elif not measured:
        raise UsageError(
            option("method", method), " needs ", option("measured", of="FILE"), ", the measured points of a part"
        )
    if settings.with_setup and setup is None:
        raise UsageError(
            option("method", method), " needs ", option("setup", of="SETUP.toml"), ": tool, material, machine and stock"
        )
    if setup is not None and not settings.with_setup:
        raise UsageError(
            option("setup"),
            " belongs to ",
            option("method", "combined"),
            " or predicted, not to ",
            option("method", method),
        )


def measured_inputs(measured: Sequence[Path], reading: Reading) -> dict[str, Path | None]:
    """Files that say what was measured, by what they are."""
    files: dict[str, Path | None] = {f"measured file {n}": path for n, path in enumerate(measured, 1)}
    return files | {
        message("file of ", option("mapping")): reading.mapping,
        message("file of ", option("probe")): reading.probe,
    }


def nominal_file(nominal: str | None) -> Path | None:
    """File that a nominal is read from; None where it is an object of the document itself, ``#LABEL``."""
    return None if nominal is None or nominal.startswith("#") else Path(nominal.partition("#")[0])


def program_request(
    program: Path,
    measured: Sequence[Path],
    reading: Reading,
    nominal: str | None,
    tool_diameter: float | None,
    settings: pipeline.Settings,
    setup: Path | None = None,
) -> pipeline.Request:
    """What a correction of an NC program asks of the pipeline, its files read; parameters as `correct_program`.

    Raises
    ------
    MillcorrError
        If the tool's diameter is missing or a file cannot be read.
    """
    known = None if setup is None else setup_file.load(setup)
    if tool_diameter is None and known is not None:
        tool_diameter = known.tool.diameter_mm
    if tool_diameter is None:
        raise UsageError(
            option("program"), " needs ", option("tool_diameter"), ": the program does not say how large the cutter is"
        )
    parts = tuple(map(reading.read, measured))
    measurement = parts[0] if parts else None
    source, radius = nc.read(program), tool_diameter / 2
    profile = None if nominal is None else read_nominal(nominal, radius, settings, measurement)
    first = nominal is not None and _is_program(nominal)
    return pipeline.Request(
        source, radius, measurement, profile, settings, parts[1:], setup=known, nominal_is_first_program=first
    )


def _is_program(nominal: str) -> bool:
    """Whether a nominal is the first program, and neither a drawing nor a profile."""
    suffix = Path(nominal.partition("#")[0]).suffix.lower()
    return suffix != ".json" and suffix not in CAD_SUFFIXES


def operation_contour(document: Path, operation: str | None) -> tuple[Profile, nc.Program, float]:
    """What an operation of a FreeCAD document cuts.

    Parameters
    ----------
    document : Path
    operation : str or None
        Its label; may be left out where the document has one Profile.

    Returns
    -------
    profile : Profile
    program : Program
        Its path.
    radius : float
        Of the cutter, mm.

    Raises
    ------
    MillcorrError
        If FreeCAD is not there, or the operation is not found or has no contour.
    """
    return operation_and_model(document, operation, False)[:3]


def operation_and_model(
    document: Path, operation: str | None, model: bool = True
) -> tuple[Profile, nc.Program, float, Workpiece | None]:
    """What an operation of a FreeCAD document cuts, as `operation_contour`, and if asked for its job's model.

    The model is None where the job has no solid.
    """
    asked = {"document": str(document.resolve()), "operation": operation, "model": model}
    found = freecad_process.call("operation_contour", asked)
    path = nc.parse(found["path"], operation or document.name)
    part = found["model"] and Workpiece(np.array(found["model"]["facets"]), found["model"]["tolerance"])
    return Profile.from_dict(found["profile"]), path, found["tool_diameter"] / 2, part


def read_nominal(
    source: str,
    radius: float,
    settings: pipeline.Settings,
    measurement: Measurement | None,
    document: Path | None = None,
) -> Profile:
    """Nominal profile from a file: a profile.json, a CAD file (through FreeCAD), or the first program.

    Parameters
    ----------
    source : str
        ``FILE``, ``FILE#LABEL``, or ``#LABEL`` of an object of `document`.
    radius, settings, measurement
        As in `pipeline.nominal_from_program`.
    document : Path, optional
        FreeCAD document that the command is about.

    Raises
    ------
    InputError
        If the file cannot be read or holds no profile.
    """
    if document is not None and source.startswith("#"):
        source = f"{document}{source}"
    name, _, label = source.partition("#")
    path = Path(name)
    if not path.is_file():
        raise InputError(f"{source}: ", option("nominal"), " names a file that does not exist")
    suffix = path.suffix.lower()
    if suffix == ".json":
        return _nominal_in_json(path)
    if suffix in CAD_SUFFIXES:
        place = str(path.resolve())
        if suffix == ".fcstd":
            return Profile.from_dict(freecad_process.call("profile", {"document": place, "label": label}))
        return Profile.from_dict(freecad_process.call("file_profile", {"path": place}))
    return pipeline.nominal_from_program(nc.read(path), radius, settings, measurement)


def _nominal_in_json(path: Path) -> Profile:
    profile = Profile.read_json(path)
    if json.loads(path.read_text(encoding="utf-8")).get("compensated"):
        raise InputError(
            f"{path}: this is the compensated profile of a report, which is off the nominal on purpose: give the "
            "nominal.json beside it"
        )
    return profile
