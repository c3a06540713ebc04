# SPDX-License-Identifier: LGPL-2.1-or-later
"""From file names to files: read, correct, prove, and only then write everything as a whole."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from . import freecad_process, pipeline, readers
from . import gcode as nc
from .deviation import statistics
from .errors import InputError, UsageError
from .measurement import Measurement
from .profile import Profile
from .readers import text

CAD_SUFFIXES = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".dxf")


def correct_program(
    program: Path,
    *,
    measured: Sequence[Path],
    points: str | None = None,
    probe_radius: float | None = None,
    units: str | None = None,
    format: str | None = None,
    mapping: Path | None = None,
    part: int | None = None,
    nominal: str | None = None,
    tool_diameter: float | None = None,
    output: Path | None = None,
    report: Path | None = None,
    settings: Mapping[str, Any] | None = None,
    **reading: Any,
) -> str:
    """Correct an NC program from a measured file; without `output`, only check.

    Parameters
    ----------
    program : Path
        NC program.
    measured : sequence of Path
        Measured points of one part, or of several whose deviations are averaged.
    points : {'contact', 'centre'}, optional
        What the points are, where the file does not say.
    probe_radius, tool_diameter : float, optional
        mm.
    units : {'mm', 'inch'}, optional
        Unit of the measured file.
    format : str, optional
        Format of the measured file; by its content by default.
    mapping : Path, optional
        TOML file that says what the columns of a text file are.
    part : int, optional
        Which of several measured parts in one file, from 1.
    nominal : str, optional
        Drawing or first program; by default the contour that the program cuts.
    output : Path, optional
        Corrected program.
    report : Path, optional
        Directory for the report.
    settings : mapping, optional
        Fields of `pipeline.Settings`.
    **reading
        How the measured files are read: `readers.read`.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        See `pipeline.correct`; nothing is written then.
    """
    if reading.get("points") == "contact" and reading.get("probe_radius") is not None:
        raise UsageError("--probe-radius belongs to --points centre: contact points lie on the part already")
    if tool_diameter is None:
        raise UsageError("--program needs --tool-diameter: the program does not say how large the cutter is")
    first = None if nominal is None else Path(nominal.partition("#")[0])
    inputs = {f"measured file {n}": path for n, path in enumerate(measured, 1)}
    refuse_places({"--output": output}, report, {"program": program, "nominal": first, **inputs})
    chosen = pipeline.Settings(**(settings or {}))
    measurement, *further = (
        readers.read(
            path,
            points=points,
            probe_radius=probe_radius,
            units=units,
            format=format,
            mapping=mapping,
            part=part,
        )
        for path in measured
    )
    source = nc.read(program)
    radius = tool_diameter / 2
    profile = None if nominal is None else read_nominal(nominal, radius, chosen, measurement)
    result = pipeline.correct(pipeline.Request(source, radius, measurement, profile, chosen, tuple(further)))
    outputs: dict[str, str] = {}
    if output is not None:
        outputs["program"] = str(output)
    with replaced_whole(output, result.text):
        if report is not None:
            from . import report as reports

            notes = () if output is not None else ("Check only: no program was written.",)
            reports.write(result, report, outputs=outputs, notes=notes)
            outputs["report"] = str(report / "report.html")
    return in_words(result.summary(), outputs, checked_only=output is None)


def correct_document(
    document: Path,
    *,
    measured: Sequence[Path],
    operation: str | None = None,
    nominal: str | None = None,
    output: Path | None = None,
    gcode: Path | None = None,
    report: Path | None = None,
    settings: Mapping[str, Any] | None = None,
    **reading: Any,
) -> str:
    """Correct an operation of a FreeCAD document, in a process of FreeCAD's command line.

    Parameters
    ----------
    document : Path
        FreeCAD document with a job.
    operation : str, optional
        Label of the operation; may be left out where the document has one Profile.
    gcode : Path, optional
        Posted program.
    measured, nominal, output, report, settings, reading
        As in `correct_program`; `nominal` is the label of an object of the document, as ``#LABEL``, or a file.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        See `pipeline.correct`; nothing is written then.
    """
    inputs = {f"measured file {n}": path for n, path in enumerate(measured, 1)}
    refuse_places({"--output": output, "--gcode": gcode}, report, {"document": document, **inputs})
    for name in ("work_offset", "mapping", "part"):
        if reading.pop(name, None) is not None:
            option = "--" + name.replace("_", "-")
            raise UsageError(
                f"{option} does not go with --document: millcorr convert FILE {option} ... -o POINTS.csv first"
            )
    places = {"output": output, "gcode": gcode, "report": report}
    summary = freecad_process.call(
        "correct",
        {
            "document": str(document.resolve()),
            "operation": operation,
            "measured": [str(path.resolve()) for path in measured],
            "nominal": nominal,
            **{name: None if place is None else str(place.resolve()) for name, place in places.items()},
            **reading,
            **(settings or {}),
        },
    )
    outputs = {
        name: str(place / "report.html" if name == "report" else place)
        for name, place in (("document", output), ("program", gcode), ("report", report))
        if place is not None
    }
    return in_words(summary, outputs, checked_only=output is None)


def inspect(measured: Path, **options: Any) -> str:
    """What a measured file holds, in a few lines.

    Parameters
    ----------
    measured : Path
    **options
        ``format, points, probe_radius, units, mapping, part`` as for `readers.read`; `points` may be left out.

    Raises
    ------
    MillcorrError
        If the file cannot be read.
    """
    said = ""
    try:
        measurement = readers.read(measured, **options)
    except UsageError:
        if options.get("points") is not None:
            raise
        measurement = readers.read(measured, **(options | {"points": "contact"}))
        said = "  (the file does not say; correcting needs --points contact or --points centre)"
    low, high = measurement.points.min(axis=0), measurement.points.max(axis=0)
    levels = np.unique(measurement.levels())
    ball = measurement.ball_radius
    lines = [
        f"file        {measured}",
        f"format      {measurement.format}",
        f"unit        {measurement.unit}" + ("" if measurement.unit == "mm" else "; all lengths here in mm"),
        f"points      {len(measurement)}, " + (f"centres of a ball of radius {ball:g}" if ball else "contact") + said,
        f"normals     {'none' if measurement.normals is None else 'of every point'}",
        f"nominal     {'none' if measurement.nominal is None else 'in the file'}",
        f"extents     X{low[0]:.3f} to {high[0]:.3f}, Y{low[1]:.3f} to {high[1]:.3f}"
        + (f", Z{low[2]:.3f} to {high[2]:.3f} on {len(levels)} levels" if measurement.has_z else ", no Z"),
    ]
    deviation = measurement.from_nominal()
    if deviation is not None:
        row = statistics(deviation[np.isfinite(deviation)])
        spread = f"{row['min']:+.4f} to {row['max']:+.4f}, mean {row['mean']:+.4f}"
        lines.append(f"deviations  {spread} (from the file's nominal)")
    return "\n".join(lines + [f"note        {note}" for note in measurement.notes])


def convert(measured: Path, output: Path, **options: Any) -> str:
    """Write a measured file's points as text, ``x,y,z`` or ``x,y,z,i,j,k`` in mm.

    Parameters
    ----------
    measured, output : Path
    **options
        ``format, points, probe_radius, units, mapping, part`` as for `readers.read`.

    Raises
    ------
    MillcorrError
        If the file cannot be read, or `output` is the file itself.
    """
    if output.resolve() == measured.resolve():
        raise UsageError(f"--output {output} is the file itself; the original must stay untouched")
    measurement = readers.read(measured, **options)
    text.write(output, measurement)
    ball = measurement.ball_radius
    kind = f"ball centres, --points centre --probe-radius {ball:g}" if ball else "contact points, --points contact"
    return f"{len(measurement)} {kind}\npoints      {output}"


def read_nominal(source: str, radius: float, settings: pipeline.Settings, measurement: Measurement | None) -> Profile:
    """Nominal profile from a file: a profile.json, a CAD file (through FreeCAD), or the first program.

    Raises
    ------
    InputError
        If the file cannot be read or holds no profile.
    """
    name, _, label = source.partition("#")
    path = Path(name)
    if not path.exists():
        raise InputError(f"{name}: --nominal names a file that does not exist")
    suffix = path.suffix.lower()
    if suffix == ".json":
        return Profile.read_json(path)
    if suffix in CAD_SUFFIXES:
        place = str(path.resolve())
        if suffix == ".fcstd":
            return Profile.from_dict(freecad_process.call("profile", {"document": place, "label": label}))
        return Profile.from_dict(freecad_process.call("file_profile", {"path": place}))
    return pipeline.nominal_from_program(nc.read(path), radius, settings, measurement)


def refuse_places(outputs: Mapping[str, Path | None], report: Path | None, inputs: Mapping[str, Path | None]) -> None:
    """UsageError where an output would take the place of an input, of a directory or of another output."""
    taken = {place.resolve(): what for what, place in inputs.items() if place is not None}
    for option, place in outputs.items():
        if place is None:
            continue
        what = taken.get(place.resolve())
        if what is not None:
            raise UsageError(f"{option} {place} is the {what} itself; the original must stay untouched")
        if place.is_dir():
            raise UsageError(f"{option} {place} is a directory; name the file to write")
        taken[place.resolve()] = f"file of {option}"
    if report is not None and (report.resolve() in taken or (report.exists() and not report.is_dir())):
        raise UsageError(f"--report {report} is a file; name a directory")


@contextmanager
def replaced_whole(path: Path | None, data: bytes) -> Iterator[None]:
    """Have a file appear, or replace the old one, when it is complete and all that is done meanwhile succeeded."""
    if path is None:
        yield
        return
    # A link stays a link; the file it names is replaced.
    path = path.resolve()
    if not path.parent.is_dir():
        raise UsageError(f"--output {path}: there is no directory {path.parent}")
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as error:
        raise UsageError(f"--output {path}: cannot be written: {error.strerror}") from error
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.chmod(temporary, path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_umask())
        yield
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def in_words(summary: Mapping[str, Any], outputs: Mapping[str, str], *, checked_only: bool) -> str:
    """What was found and done, in a few lines; micrometres."""
    points, proof = summary["points"], summary["verification"]
    rejected = len(points["rejected"])
    lines = [f"points      {points['used']} used of {points['read']}" + (f", {rejected} rejected" if rejected else "")]
    lines.append("um                  mean      min      max   height      std")
    for title, key in (("deviation", "deviation"), ("determined part", "filtered"), ("predicted after", "predicted")):
        row = summary[key]
        values = "".join(f"{_um(row[name]):>9}" for name in ("mean", "min", "max", "height", "std"))
        lines.append(f"{title:<15}{values}")
    random, largest = _um(summary["random_std"]), _um(summary["correction"]["max"])
    lines.append(f"random part std {random} um; largest correction {largest} um")
    lines.append(
        f"proof       emitted path within {_um(proof['path_error_max'])} um of the compensated profile's exact parallel"
    )
    lines += [f"warning     {w}" for w in summary["warnings"]]
    lines += [f"note        {a}" for a in summary["advice"]]
    lines += [f"{name:<11} {path}" for name, path in outputs.items()]
    if checked_only:
        lines.append("check only: no program was written")
    return "\n".join(lines)


def _um(value: float | None) -> str:
    return "-" if value is None or value != value else f"{value * 1000:.2f}"
