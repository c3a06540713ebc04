# SPDX-License-Identifier: LGPL-2.1-or-later
"""From file names to files: read, correct, prove, and only then write everything as a whole."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from . import distrust, freecad_process, pipeline, setup_file
from . import gcode as nc
from . import report as reports
from .deviation import statistics
from .errors import InputError, UsageError
from .measurement import Measurement
from .profile import Profile
from .readers import Reading, text
from .report import history as report_history
from .report import simulation as report_simulation
from .report.remedies import Asked
from .report.simulation import NOTHING
from .series import history as histories
from .series import journal as journals
from .series import production as serial
from .series.process_control import Control
from .whole_file import refuse_places, replaced_whole, write_whole

UNSAID = Reading()
"""Everything is as the measured file says."""

CAD_SUFFIXES = (".fcstd", ".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".dxf")


def correct_program(
    program: Path,
    *,
    measured: Sequence[Path],
    reading: Reading = UNSAID,
    nominal: str | None = None,
    tool_diameter: float | None = None,
    output: Path | None = None,
    report: Path | None = None,
    settings: pipeline.Settings | None = None,
    setup: Path | None = None,
    table: bool = False,
    journal: str | None = None,
    once: bool = False,
    control: str | None = None,
    **limits: float | None,
) -> str:
    """Correct an NC program from a measured file; without `output`, only check.

    Parameters
    ----------
    program : Path
        NC program.
    measured : sequence of Path
        Measured points of one part, or of several whose deviations are averaged.
    reading : Reading
        How the measured files are to be read.
    nominal : str, optional
        Drawing or first program; by default the contour that the program cuts.
    tool_diameter : float
        mm.
    output : Path, optional
        Corrected program.
    report : Path, optional
        Directory for the report.
    settings : pipeline.Settings, optional
    setup : Path, optional
        Setup for the methods that simulate; it may name the tool's diameter.
    table : bool
        Whether every used point is to be listed, see `contour_check.table`.
    journal : str, optional
        Journal of the series; '' for the one beside the nominal or the program.
    once : bool
        Whether the very run that the journal has already, with its output in place, is done and no error.
    control, **limits
        Process control: see `serial.control_from`.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        See `pipeline.correct` and `serial.corrected`; nothing is written then.
    """
    first = None if nominal is None else Path(nominal.partition("#")[0])
    inputs = _named_inputs(measured, reading)
    chosen = settings or pipeline.Settings()
    require_measured(measured, setup, chosen)
    rules = serial.control_from(control, chosen.dead_band, journal=journal is not None, **limits)
    book = None if journal is None else Path(journal) if journal else serial.default_journal(program, nominal)
    outside = {"--output": output, "--journal": book}
    refuse_places(outside, {"program": program, "nominal": first, "setup": setup, **inputs}, report, reports.FILES)
    request = program_request(program, measured, reading, nominal, tool_diameter, chosen, setup)
    outputs: dict[str, str] = {}
    if output is not None:
        outputs["program"] = str(output)
    try:
        with _judged(request, output, book, rules) as (result, part, notes), replaced_whole(output, result.text):
            if book is not None:
                outputs["journal"] = f"{book}, part {part}"
            if report is not None:
                reports.write(result, report, outputs=outputs, notes=notes)
                outputs["report"] = str(report / "report.html")
    except journals.RepeatedError as error:
        if not (once and output is not None and error.is_same_run(request.program.digest, output)):
            raise
        return f"done before: {output} is in its place; {error}"
    words = in_words(result.summary(), outputs, checked_only=output is None)
    if not table:
        return words
    from . import contour_check

    return f"{contour_check.table(contour_check.touched_points(result))}\n{words}"


def _named_inputs(measured: Sequence[Path], reading: Reading) -> dict[str, Path | None]:
    """Files that say what was measured, by what they are."""
    files: dict[str, Path | None] = {f"measured file {n}": path for n, path in enumerate(measured, 1)}
    return files | {"file of --mapping": reading.mapping, "file of --probe": reading.probe}


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
        raise UsageError("--program needs --tool-diameter: the program does not say how large the cutter is")
    parts = tuple(map(reading.read, measured))
    measurement = parts[0] if parts else None
    source, radius = nc.read(program), tool_diameter / 2
    profile = None if nominal is None else read_nominal(nominal, radius, settings, measurement)
    return pipeline.Request(source, radius, measurement, profile, settings, parts[1:], setup=known)


@contextmanager
def _judged(
    request: pipeline.Request, output: Path | None, journal: Path | None, control: Control | None
) -> Iterator[tuple[pipeline.Result, int, tuple[str, ...]]]:
    """The result, the number of the part in its journal (0 without one), and notes for the report."""
    if output is None:
        yield pipeline.correct(request, check=True), 0, ("Check only: no program was written.",)
    elif journal is None:
        yield pipeline.correct(request), 0, ()
    else:
        with serial.corrected(request, output, journal, control) as outcome:
            yield outcome.result, outcome.part, outcome.notes


def history(journal: Path | None = None, *, csv: Path | None = None, report: Path | None = None) -> str:
    """What a journal of a series holds, as a table; and as files.

    Parameters
    ----------
    journal : Path, optional
        By default the only ``*.journal`` in the current directory.
    csv : Path, optional
        File for every entry.
    report : Path, optional
        Directory for history.html and history.csv.

    Raises
    ------
    MillcorrError
        If the journal cannot be read, or a place cannot be written to.
    """
    if journal is None:
        found = sorted(Path().glob("*.journal"))
        if len(found) != 1:
            there = ", ".join(path.name for path in found) or "none"
            raise UsageError(f"name the journal: in this directory there is {there}")
        journal = found[0]
    refuse_places({"--csv": csv}, {"journal": journal}, report, report_history.FILES)
    if csv is not None:
        histories.refuse_other_file(csv)
    chains = journals.read(journal)
    lines = [histories.table(chains)]
    if csv is not None:
        write_whole(csv, "".join(histories.csv_lines(chains)))
        lines.append(f"csv         {csv}")
    if report is not None:
        lines.append(f"report      {report_history.write(chains, journal, report)[0]}")
    return "\n".join(lines)


def correct_document(
    document: Path,
    *,
    measured: Sequence[Path],
    reading: Reading = UNSAID,
    operation: str | None = None,
    nominal: str | None = None,
    tool_diameter: float | None = None,
    output: Path | None = None,
    gcode: Path | None = None,
    report: Path | None = None,
    settings: pipeline.Settings | None = None,
    setup: Path | None = None,
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
    measured, reading, nominal, tool_diameter, output, report, settings, setup
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
    require_measured(measured, setup, settings or pipeline.Settings())
    if tool_diameter is not None and not 0 < tool_diameter < float("inf"):
        raise UsageError(f"--tool-diameter {tool_diameter:g}: must be a length above 0")
    if output is not None and output.suffix.lower() != ".fcstd":
        raise UsageError(f"--output {output}: a corrected document is an .FCStd file; its program goes to --gcode")
    first = None if nominal is None or nominal.startswith("#") else Path(nominal.partition("#")[0])
    inputs = {"document": document, "nominal": first, "setup": setup, **_named_inputs(measured, reading)}
    refuse_places({"--output": output, "--gcode": gcode}, inputs, report, reports.FILES)
    places = {"output": output, "gcode": gcode, "report": report}
    summary = freecad_process.call(
        "correct",
        {
            "document": str(document.resolve()),
            "operation": operation,
            "measured": [str(path.resolve()) for path in measured],
            "nominal": nominal,
            "tool_diameter": tool_diameter,
            "setup": None if setup is None else str(setup.resolve()),
            **{name: None if place is None else str(place.resolve()) for name, place in places.items()},
            **reading.as_dict(),
            **asdict(settings or pipeline.Settings()),
        },
    )
    outputs = {
        name: str(place / "report.html" if name == "report" else place)
        for name, place in (("document", output), ("program", gcode), ("report", report))
        if place is not None
    }
    return in_words(summary, outputs, checked_only=output is None)


def require_measured(measured: Sequence[Path], setup: Path | None, settings: pipeline.Settings) -> None:
    """UsageError where measured files or a setup are missing, or given to a method that takes none."""
    method = settings.method
    if method == "predicted":
        if measured:
            raise UsageError("--method predicted takes no --measured: with touches use --method combined")
    elif not measured:
        raise UsageError(f"--method {method} needs --measured FILE, the measured points of a part")
    if settings.with_setup and setup is None:
        raise UsageError(f"--method {method} needs --setup SETUP.toml: tool, material, machine and stock")
    if setup is not None and not settings.with_setup:
        raise UsageError(f"--setup belongs to --method combined or predicted, not to --method {method}")


def split_program(
    program: Path,
    *,
    tool_diameter: float,
    depth: float,
    output: Path,
    at: float = 0.5,
    nominal: str | None = None,
    settings: pipeline.Settings | None = None,
) -> str:
    """Write the program of a first cut, which leaves a part of the allowance on the finished contour.

    Parameters
    ----------
    program : Path
        Program that finishes the part.
    tool_diameter, depth : float
        Cutter, and whole allowance over the finished contour, mm.
    at : float
        Share of the allowance that the first cut takes.
    nominal : str, optional
        Profile, where the program cannot show it.
    output : Path
    settings : pipeline.Settings, optional

    Returns
    -------
    str
        What was done, and how to go on.

    Raises
    ------
    MillcorrError
        See `split.split`; nothing is written then.
    """
    from . import split

    first = None if nominal is None else Path(nominal.partition("#")[0])
    refuse_places({"--output": output}, {"program": program, "nominal": first})
    chosen, radius = settings or pipeline.Settings(), tool_diameter / 2
    profile = None if nominal is None else read_nominal(nominal, radius, chosen, None)
    done = split.split(nc.read(program), radius, depth, at, settings=chosen, nominal=profile)
    proof = done.result.verification
    side = "" if chosen.side == "auto" else f" --side {chosen.side}"
    with replaced_whole(output, done.result.text):
        pass
    return "\n".join(
        [
            f"first cut   takes {done.depth:g} mm and leaves {done.left:g} mm of {depth:g} mm",
            f"proof       emitted path within {_um(proof.path_error_max)} um of its exact parallel",
            f"then        measure, and correct --program {program} --tool-diameter {tool_diameter:g}{side} "
            f"--measured FILE --points KIND --method transfer --depth {done.depth:g} --allowance {done.left:g} "
            "--output SECOND.nc",
            f"program     {output}",
        ]
    )


def simulate_program(
    program: Path | None = None,
    *,
    document: Path | None = None,
    operation: str | None = None,
    setup: Path,
    report: Path,
    nominal: str | None = None,
    settings: pipeline.Settings,
    heights: Sequence[float] = (),
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
    heights : sequence of float
        mm above the tool's tip at which the wall is wanted; none leaves it out.
    asked : Asked, optional
        Remedies to write as programs, and a log of the machine.

    Returns
    -------
    str
        What was found, in a few lines.

    Raises
    ------
    MillcorrError
        If program or setup cannot be used, or a remedy is refused; nothing is written then.
    """
    first = None if nominal is None or nominal.startswith("#") else Path(nominal.partition("#")[0])
    inputs = {"program": program, "document": document, "nominal": first, "setup": setup, "log": asked.trace}
    refuse_places({"--slowed": asked.slowed, "--tilted": asked.tilted}, inputs, report, report_simulation.FILES)
    if program is not None:
        if operation is not None:
            raise UsageError("--operation belongs to --document")
        request = program_request(program, (), UNSAID, nominal, None, settings, setup)
    elif document is None:
        raise UsageError("--program or --document is needed: what is to be cut")
    else:
        if asked.slowed is not None or asked.tilted is not None:
            raise UsageError("--slowed and --tilted belong to --program: give the program that the job is posted as")
        request = _operation_request(document, operation, nominal, settings, setup)
    return report_simulation.write(request, report, heights=heights, asked=asked)


def _operation_request(
    document: Path, operation: str | None, nominal: str | None, settings: pipeline.Settings, setup: Path
) -> pipeline.Request:
    """What a simulation of an operation asks of the pipeline."""
    known = setup_file.load(setup)
    cut = freecad_process.call("operation_contour", {"document": str(document.resolve()), "operation": operation})
    radius = cut["tool_diameter"] / 2
    profile = Profile.from_dict(cut["profile"])
    if nominal is not None:
        source = f"{document}{nominal}" if nominal.startswith("#") else nominal
        profile = read_nominal(source, radius, settings, None)
    path = nc.parse(cut["path"], operation or document.name)
    return pipeline.Request(path, radius, None, profile, settings, setup=known)


def inspect(measured: Path, reading: Reading = UNSAID) -> str:
    """What a measured file holds, in a few lines.

    Parameters
    ----------
    measured : Path
    reading : Reading
        How it is to be read; `points` may be left out.

    Raises
    ------
    MillcorrError
        If the file cannot be read.
    """
    said = ""
    try:
        measurement = reading.read(measured)
    except UsageError as first:
        if reading.points is not None:
            raise
        try:
            measurement = replace(reading, points="contact", probe=None, probe_radius=None).read(measured)
        except UsageError:
            raise first from None
        said = "  (the file does not say; correcting needs --points contact, centre or axis)"
    low, high = measurement.points.min(axis=0), measurement.points.max(axis=0)
    levels = np.unique(measurement.levels())
    lines = [
        f"file        {measured}",
        f"format      {measurement.format}",
        f"unit        {measurement.unit}" + ("" if measurement.unit == "mm" else "; all lengths here in mm"),
        f"points      {len(measurement)}, {_kind(measurement)}{said}",
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
    lines += [f"note        {note}" for note in measurement.notes]
    lines += [f"finding     {finding.name}: {finding.text}" for finding in distrust.examine_file(measurement)]
    return "\n".join(lines)


def _kind(measurement: Measurement) -> str:
    if measurement.axis_radii is not None:
        radii = " and ".join(f"{radius:g}" for radius in sorted(set(measurement.axis_radii)))
        return f"centres shifted along an axis by the ball's radius {radii}"
    return f"centres of a ball of radius {measurement.ball_radius:g}" if measurement.ball_radius else "contact"


def convert(measured: Path, output: Path, reading: Reading = UNSAID) -> str:
    """Write a measured file's points as text, ``x,y,z`` or ``x,y,z,i,j,k`` in mm.

    Parameters
    ----------
    measured, output : Path
    reading : Reading
        How the file is to be read.

    Raises
    ------
    MillcorrError
        If the file cannot be read, or `output` is the file itself.
    """
    refuse_places({"--output": output}, {"file": measured, **_named_inputs((), reading)})
    measurement = reading.read(measured)
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


def in_words(summary: Mapping[str, Any], outputs: Mapping[str, str], *, checked_only: bool) -> str:
    """What was found and done, in a few lines; micrometres."""
    points, proof = summary["points"], summary["verification"]
    rejected = len(points["rejected"])
    foreseen = summary["foreseen"]
    if foreseen is not None and foreseen["combined"] is None:
        lines = [f"points      {points['used']} of the simulated surface; nothing was measured"]
    else:
        said = f", {rejected} rejected" if rejected else ""
        lines = [f"points      {points['used']} used of {points['read']}{said}"]
    lines.append("um                  mean      min      max   height      std")
    for title, key in (("deviation", "deviation"), ("determined part", "filtered"), ("predicted after", "predicted")):
        row = summary[key]
        values = "".join(f"{_um(row[name]):>9}" for name in ("mean", "min", "max", "height", "std"))
        lines.append(f"{title:<15}{values}")
    random, largest = _um(summary["random_std"]), summary["correction"]
    at = "X{:.3f} Y{:.3f}".format(*largest["place"]) if largest["largest"] else ""
    moved = f"{largest['largest'] * 1000:+.2f} um" + (f" at {at}" if at else "")
    lines.append(f"random part std {random} um; largest correction {moved}")
    lines += _elastic(summary["transfer"])
    lines.append(
        f"proof       emitted path within {_um(proof['path_error_max'])} um of the compensated profile's exact parallel"
    )
    lines += [f"warning     {w}" for w in summary["warnings"]]
    lines += [f"note        {a}" for a in summary["advice"]]
    lines += [f"{name:<11} {path}" for name, path in outputs.items()]
    if checked_only:
        lines.append("check only: no program was written")
    return "\n".join(lines)


def _elastic(transfer: Mapping[str, Any] | None) -> list[str]:
    """Transfer function, and the offset that several depths tell apart from it."""
    if transfer is None:
        return []
    depth = ", ".join(f"{value:g}" for value in transfer["depth"])
    known = transfer["ms_uncertainty"]
    spread = "" if known is None or known != known else f" +- {known:.4f}"
    lines = [
        f"transfer    MS {transfer['ms_mean']:.4f} ({transfer['ms_min']:.4f} to {transfer['ms_max']:.4f}){spread}, "
        f"depth {depth} mm, next {transfer['next_depth']:g} mm, {transfer['taken']} along {transfer['depth_along']}"
    ]
    offset = transfer["offset"]
    if offset:
        lines.append(
            f"offset      {_um(offset['mean'])} um ({_um(offset['min'])} to {_um(offset['max'])}) "
            f"+- {_um(offset['uncertainty'])}, kept apart"
        )
    return lines


def _um(value: float | None) -> str:
    return "-" if value is None or value != value else f"{value * 1000:.2f}"
