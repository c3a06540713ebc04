# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr correct` and `check`: read, correct, prove, and only then write everything as a whole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
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


@dataclass(frozen=True, slots=True)
class CorrectionAsked:
    """What a correction is made of and where it goes.

    Parameters
    ----------
    measured : sequence of Path
        Measured points of one part, or of several whose deviations are averaged.
    reading : Reading
        How the measured files are to be read.
    nominal : str, optional
        Drawing or first program; by default the contour that the program cuts. With a document it is the label of an
        object of it, as ``#LABEL``, or a file.
    tool_diameter : float, optional
        mm.
    output : Path, optional
        Corrected program or document; without it, the measurement is only checked.
    report : Path, optional
        Directory for the report.
    exports : Exports
        What else is written there.
    settings : Settings
    setup : Path, optional
        Setup for the methods that simulate; it may name the tool's diameter.
    journal : str, optional
        Journal of the series; '' for the one beside the nominal or the program.
    once : bool
        Whether the very run that the journal has already, with its output in place, is done and no error.
    control : str, optional
    limits : mapping of str to float
        Process control: see `serial.control_from`.
    """

    measured: Sequence[Path]
    reading: Reading = UNSAID
    nominal: str | None = None
    tool_diameter: float | None = None
    output: Path | None = None
    report: Path | None = None
    exports: reports.Exports = reports.NO_EXPORTS
    settings: pipeline.Settings = field(default_factory=pipeline.Settings)
    setup: Path | None = None
    journal: str | None = None
    once: bool = False
    control: str | None = None
    limits: Mapping[str, float] = field(default_factory=dict)

    def rules(self) -> Control | None:
        """Process control of the series; UsageError where it contradicts itself or nothing can be exported."""
        require_measured(self.measured, self.setup, self.settings)
        if self.exports.export and self.report is None:
            raise UsageError(option("export"), " belongs to ", option("report"), " DIR, into which it is written")
        in_series = self.journal is not None
        return serial.control_from(self.control, self.settings.dead_band, journal=in_series, **self.limits)

    def book(self, cut: Path) -> Path | None:
        """Place of the journal that was asked for; '' is the one beside the nominal or what was cut."""
        if self.journal is None:
            return None
        return Path(self.journal) if self.journal else serial.default_journal(cut, self.nominal)

    def refuse_places(self, inputs: Mapping[str, Path | None], outputs: Mapping[str, Path | None]) -> None:
        """OverwriteError where something would be written over what is read."""
        read = {**inputs, "nominal": nominal_file(self.nominal), "setup": self.setup}
        read |= measured_inputs(self.measured, self.reading)
        refuse_places(dict(outputs), read, self.report, reports.FILES + reports.files_of(self.exports))


def correct_program(program: Path, asked: CorrectionAsked, *, table: bool = False) -> str:
    """Correct an NC program from a measured file; without an output, only check.

    Parameters
    ----------
    program : Path
        NC program.
    asked : CorrectionAsked
    table : bool
        Whether every used point is to be listed, see `contour_check.table`.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        See `pipeline.correct` and `serial.corrected`; nothing is written then.
    """
    rules, book, output, report = asked.rules(), asked.book(program), asked.output, asked.report
    asked.refuse_places({"program": program}, {"output": output, "journal": book})
    request = program_request(
        program, asked.measured, asked.reading, asked.nominal, asked.tool_diameter, asked.settings, asked.setup
    )
    outputs: dict[str, str] = {}
    if output is not None:
        outputs["program"] = str(output)
    try:
        with _judged(request, output, book, rules) as (result, part, notes), replaced_whole(output, result.text):
            if book is not None:
                outputs["journal"] = f"{book}, part {part}"
            if report is not None:
                reports.write(result, report, outputs=outputs, notes=notes, exports=asked.exports)
                outputs["report"] = str(report / "report.html")
    except journals.RepeatedError as error:
        if not (asked.once and output is not None and error.is_same_run(request.program.digest, output)):
            raise
        return f"done before: {output} is in its place; {error}"
    words = in_words(result.summary(), outputs, checked_only=output is None)
    if not table:
        return words
    return f"{contour_check.table(contour_check.touched_points(result))}\n{words}"


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
    document: Path, asked: CorrectionAsked, *, operation: str | None = None, gcode: Path | None = None
) -> str:
    """Correct an operation of a FreeCAD document, in a process of FreeCAD's command line.

    Parameters
    ----------
    document : Path
        FreeCAD document with a job.
    asked : CorrectionAsked
    operation : str, optional
        Label of the operation; may be left out where the document has one Profile.
    gcode : Path, optional
        Posted program.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        See `pipeline.correct`; nothing is written then.
    """
    asked.rules()
    diameter, output, report, setup = asked.tool_diameter, asked.output, asked.report, asked.setup
    if diameter is not None and not 0 < diameter < float("inf"):
        raise UsageError(option("tool_diameter", diameter), ": must be a length above 0")
    if output is not None and output.suffix.lower() != ".fcstd":
        raise UsageError(
            option("output", output), ": a corrected document is an .FCStd file; its program goes to ", option("gcode")
        )
    if asked.journal == "" and nominal_file(asked.nominal) is None:
        raise UsageError(
            option("journal"),
            " with ",
            option("document"),
            " needs a name: every part's document has another one, the journal is that of all",
        )
    book = asked.book(document)
    places = {"output": output, "gcode": gcode, "journal": book}
    asked.refuse_places({"document": document}, places)
    # The other process writes.
    progress.settle()
    summary = freecad_process.call(
        "correct",
        {
            "document": str(document.resolve()),
            "operation": operation,
            "measured": [str(path.resolve()) for path in asked.measured],
            "nominal": asked.nominal,
            "tool_diameter": diameter,
            **{
                name: None if place is None else str(place.resolve())
                for name, place in {**places, "report": report, "setup": setup}.items()
            },
            "control": asked.control,
            "once": asked.once,
            **asked.limits,
            **asdict(asked.exports),
            **asked.reading.as_dict(),
            **asdict(asked.settings),
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
