# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr correct` and `check`: read, correct, prove, and only then write everything as a whole."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path

from millcorr import freecad_process, pipeline, progress
from millcorr import report as reports
from millcorr.errors import UsageError
from millcorr.messages import option
from millcorr.production import contour_check
from millcorr.production import journal as journals
from millcorr.production import series as serial
from millcorr.production.process_control import Control
from millcorr.readers import Reading
from millcorr.whole_file import refuse_places, replaced_whole

from .inputs import UNSAID, measured_inputs, nominal_file, program_request, require_measured
from .words import in_words


def correct_program(
    program: Path,
    *,
    measured: Sequence[Path],
    reading: Reading = UNSAID,
    nominal: str | None = None,
    tool_diameter: float | None = None,
    output: Path | None = None,
    report: Path | None = None,
    exports: reports.Exports = reports.NO_EXPORTS,
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
    exports : reports.Exports
        What else is written there.
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
    inputs = {"program": program, "nominal": nominal_file(nominal), "setup": setup}
    inputs |= measured_inputs(measured, reading)
    chosen = settings or pipeline.Settings()
    require_measured(measured, setup, chosen)
    rules = serial.control_from(control, chosen.dead_band, journal=journal is not None, **limits)
    book = _book(journal, program, nominal)
    outside = {"output": output, "journal": book}
    _require_report(report, exports)
    refuse_places(outside, inputs, report, reports.FILES + exports.files)
    request = program_request(program, measured, reading, nominal, tool_diameter, chosen, setup)
    outputs: dict[str, str] = {}
    if output is not None:
        outputs["program"] = str(output)
    try:
        with _judged(request, output, book, rules) as (result, part, notes), replaced_whole(output, result.text):
            if book is not None:
                outputs["journal"] = f"{book}, part {part}"
            if report is not None:
                reports.write(result, report, outputs=outputs, notes=notes, exports=exports)
                outputs["report"] = str(report / "report.html")
    except journals.RepeatedError as error:
        if not (once and output is not None and error.is_same_run(request.program.digest, output)):
            raise
        return f"done before: {output} is in its place; {error}"
    words = in_words(result.summary(), outputs, checked_only=output is None)
    if not table:
        return words
    return f"{contour_check.table(contour_check.touched_points(result))}\n{words}"


def _require_report(report: Path | None, exports: reports.Exports) -> None:
    """UsageError where something is to be exported and there is no directory for it."""
    if exports.kinds and report is None:
        raise UsageError(option("export"), " belongs to ", option("report"), " DIR, into which it is written")


def _book(journal: str | None, cut: Path, nominal: str | None) -> Path | None:
    """Place of the journal that was asked for; '' is the one beside the nominal or what was cut."""
    if journal is None:
        return None
    return Path(journal) if journal else serial.default_journal(cut, nominal)


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
    exports: reports.Exports = reports.NO_EXPORTS,
    settings: pipeline.Settings | None = None,
    setup: Path | None = None,
    journal: str | None = None,
    once: bool = False,
    control: str | None = None,
    **limits: float | None,
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
    measured, reading, nominal, tool_diameter, output, report, exports, settings, setup
        As in `correct_program`; `nominal` is the label of an object of the document, as ``#LABEL``, or a file.
    journal, once, control, **limits
        As in `correct_program`; '' is the journal beside the nominal's file.

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
        raise UsageError(option("tool_diameter", tool_diameter), ": must be a length above 0")
    if output is not None and output.suffix.lower() != ".fcstd":
        raise UsageError(
            option("output", output), ": a corrected document is an .FCStd file; its program goes to ", option("gcode")
        )
    first = nominal_file(nominal)
    if journal == "" and first is None:
        raise UsageError(
            option("journal"),
            " with ",
            option("document"),
            " needs a name: every part's document has another one, the journal is that of all",
        )
    serial.control_from(control, (settings or pipeline.Settings()).dead_band, journal=journal is not None, **limits)
    book = _book(journal, document, nominal)
    inputs = {"document": document, "nominal": first, "setup": setup}
    inputs |= measured_inputs(measured, reading)
    _require_report(report, exports)
    outside = {"output": output, "gcode": gcode, "journal": book}
    refuse_places(outside, inputs, report, reports.FILES + exports.files)
    places = {"output": output, "gcode": gcode, "report": report, "journal": book}
    # The other process writes.
    progress.settle()
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
            "control": control,
            "once": once,
            "export": list(exports.kinds),
            "zone": exports.zone,
            **{name: value for name, value in limits.items() if value is not None},
            **reading.as_dict(),
            **asdict(settings or pipeline.Settings()),
        },
    )
    if "done_before" in summary:
        return f"done before: {output} is in its place; {summary['done_before']}"
    outputs = {
        name: str(place / "report.html" if name == "report" else place)
        for name, place in (("document", output), ("program", gcode), ("report", report))
        if place is not None
    }
    if book is not None:
        outputs["journal"] = str(book)
    return in_words(summary, outputs, checked_only=output is None)
