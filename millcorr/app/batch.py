# SPDX-License-Identifier: LGPL-2.1-or-later
"""Correct a FreeCAD document from a measured part, without a window: for scripts, macros and night runs.

Example
-------
>>> from millcorr.app import batch
>>> batch.correct_document("JOB.FCStd", operation="Profile", measured="cmm.csv", points="contact",
...                        output="JOB-corrected.FCStd", gcode="part.nc", report="report/")
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any
from uuid import uuid4

import FreeCAD

from millcorr import nc, pipeline
from millcorr import report as reports
from millcorr.errors import FormatError, InputError, LimitError, MillcorrError, RefusedError, UsageError
from millcorr.messages import message_of, option, phrase
from millcorr.path import verification
from millcorr.production import series as production
from millcorr.production.process_control import ACCEPTED, LIMITS
from millcorr.readers import Reading
from millcorr.report.reader import read_by
from millcorr.whole_file import refuse_places

from . import (
    base_geometry,
    candidates,
    compat,
    correction,
    documents,
    dressup,
    measurement_object,
    sources,
    views,
    wording,
)

# FreeCAD brings a document's objects to life only if their modules are there before it is opened.
from . import profile_object as profile_object


def correct_document(
    document: Any,
    operation: Any = None,
    measured: str | Path | Sequence[str | Path] | None = None,
    *,
    nominal: Any = None,
    output: str | Path | None = None,
    gcode: str | Path | None = None,
    report: str | Path | None = None,
    journal: str | Path | None = None,
    control: str | None = None,
    export: Sequence[str] = (),
    zone: float | None = None,
    **options: Any,
) -> pipeline.Result:
    """Correct one operation of a document from a measured part.

    Nothing is written unless everything succeeds, and every file is replaced as a whole. A document given as
    a file is left as it is; an open document keeps the dressup if the
    correction succeeds and is as before if it does not.

    Parameters
    ----------
    document : str, Path or FreeCAD document
        The document, as a file or open.
    operation : str or document object, optional
        Label or name of the operation; may be left out where the document has one Profile.
    measured : str, Path or sequence of them, optional
        The measured file, or one of each of several parts, whose deviations are averaged; without it the path
        is made exact and nothing is corrected.
    nominal : str, Path or document object, optional
        Nominal profile: object of the document, ``"#Label"`` of one, or a file (see `sources.nominal_shape`),
        which is then kept in the document; default the operation's own geometry.
    output : str or Path, optional
        Document to write.
    gcode : str or Path, optional
        Program to write, made by the job's own post processor and read back to prove it.
    report : str or Path, optional
        Directory for the report.
    journal : str or Path, optional
        Journal of the series, see `millcorr.production.series`; for a document that is a file, with an output. Where
        the rules say no correction the output is the very bytes of the document.
    control : str, optional
        ``"ewma:K"``, with the limits of `process_control.LIMITS` among the options.
    export, zone
        What is exported beside the report, see `millcorr.report.Exports`.
    **options
        ``tool_diameter`` in mm, how to read the measured files (fields of `millcorr.readers.Reading`: ``points,
        probe_radius, units, format, mapping, part, work_offset, ...``) and how to correct (fields of
        `millcorr.pipeline.Settings`: ``align, filter, gain, ...``).

    Returns
    -------
    pipeline.Result

    Raises
    ------
    UsageError
        If a setting is unknown, or the operation is not found or not unique.
    MillcorrError
        If the input cannot be trusted or the correction is refused.
    """
    reading = Reading.taken_from(options)
    limits = {name: options.pop(name) for name in LIMITS if name in options}
    rules = production.control_from(control, options.get("dead_band") or 0.0, journal=journal is not None, **limits)
    accepted: tuple[str, ...] = ()
    if rules is not None and ACCEPTED in (options.get("accept") or ()):
        # It is about this part and no setting of the dressup.
        accepted = (ACCEPTED,)
        options["accept"] = [name for name in options["accept"] if name != ACCEPTED]
    chosen = correction.properties_of(options)
    compat.prepare_modules()
    source = Path(document) if isinstance(document, str | Path) else None
    files = [] if measured is None else [measured] if isinstance(measured, str | Path) else list(measured)
    exports = reports.Exports(tuple(export), zone)
    _refuse_inputs(source, files, output, gcode, report, exports)
    if journal is not None and (source is None or output is None):
        raise UsageError(
            phrase(
                "{} belongs to a document that is a file, and to an {}: it records both",
                option("journal"),
                option("output"),
            ),
        )
    with ExitStack() as stack:
        here = stack.enter_context(documents.opened(document))
        stack.enter_context(_all_or_nothing(here))
        base = find_operation(here, operation)
        parts = [measurement_object.create(here, file, **reading.as_dict()) for file in files]
        if nominal is not None:
            chosen["Nominal"] = sources.nominal_object(here, nominal)
        chosen["FurtherParts"] = parts[1:]
        obj = _dressed(base, parts[0] if parts else None, chosen)
        part: production.Judged | None = None
        if journal is not None and source is not None and output is not None:
            request, _ = correction.request_of(obj)
            settings = replace(request.settings, accept=request.settings.accept + accepted)
            cut_with = (source.name, sha256(source))
            part = stack.enter_context(
                production.judged(replace(request, settings=settings), Path(journal), rules, before=cut_with)
            )
            if not part.corrected:
                return _kept(part, source, operation, Path(output), gcode, report, exports)
            obj.Smoothed = part.smoothed
        corrected = correction.correct(obj)
        # Only what is new: another FreeCAD would lay the operation's own path anew, and the part was cut with
        # the one that is stored.
        for new in (*parts, obj):
            new.recompute()
        _require_valid(obj)
        text = None if gcode is None else _posted(obj)
        if text is not None:
            corrected = proved(obj, text, corrected)
        if part is not None:
            corrected = replace(corrected, result=_with_words(corrected.result, part.result))
        _write(here, source, corrected, text, output, gcode, report, part, exports)
        return corrected.result


def _with_words(result: pipeline.Result, judged: pipeline.Result) -> pipeline.Result:
    """A result with what the series says of it."""
    return replace(result, advice=judged.advice, warnings=judged.warnings)


def _kept(
    part: production.Judged,
    source: Path,
    operation: Any,
    output: Path,
    gcode: Any,
    directory: Any,
    exports: reports.Exports,
) -> pipeline.Result:
    """Write what a part leads to that is not corrected: the very bytes of the document, its program and the report."""
    text: str | None = None
    if gcode is not None:
        # Of the document as it is stored, without the dressup that was tried.
        with documents.opened(source) as stored:
            text = _posted(find_operation(stored, operation))
    with ExitStack() as stack:
        ready: list[tuple[Path, Path]] = []
        if gcode is not None and text is not None:
            ready.append((stack.enter_context(_beside(Path(gcode))), Path(gcode)))
            ready[-1][0].write_bytes(text.encode("utf-8"))
        ready.append((stack.enter_context(_beside(output)), output))
        shutil.copyfile(source, ready[-1][0])
        written = {"document": str(output)} | ({} if gcode is None else {"program": str(gcode)})
        _put(ready, part, part.result, directory, written, [], exports)
    return part.result


def export_report(obj: Any, directory: str | Path) -> None:
    """Write the report of a dressup.

    Parameters
    ----------
    obj : document object
        The dressup.
    directory : str or Path
        Made if it is not there.

    Raises
    ------
    MillcorrError
        If the correction cannot be made; nothing is written then. A job that cannot be posted is told in the report.
    """
    corrected = correction.correct(obj)
    notes = ["Check only: no program was written."]
    try:
        corrected = proved(obj, _posted(obj), corrected)
        notes.append(_READ_BACK)
    # Posts are anybody's code, and end as they like; the report is about the path.
    except (Exception, SystemExit) as error:  # noqa: BLE001
        notes.append(
            phrase("The path error is that of the path itself: the job's post processor gave no program ({}).", error)
        )
    with read_by(wording.reader()):
        _put([], None, corrected.result, directory, {}, notes, reports.NO_EXPORTS)


_READ_BACK = "The path error is that of the program as FreeCAD posted it, read back."


def _refuse_inputs(
    source: Path | None, measured: Sequence[Any], output: Any, gcode: Any, report: Any, exports: reports.Exports
) -> None:
    """UsageError where something to write would replace what is read."""
    inputs = {f"measured file {n}": Path(file) for n, file in enumerate(measured, 1)}
    written = {what: None if place is None else Path(place) for what, place in (("output", output), ("gcode", gcode))}
    files = reports.FILES + reports.files_of(exports)
    refuse_places(written, {"document": source, **inputs}, None if report is None else Path(report), files)


@contextmanager
def _all_or_nothing(document: Any) -> Iterator[None]:
    """Take back everything done to the document if it fails; undo is on for as long."""
    mode = document.UndoMode
    document.UndoMode = 1
    FreeCAD.setActiveDocument(document.Name)
    document.openTransaction("Correct from measurement")
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    else:
        document.commitTransaction()
    finally:
        document.UndoMode = mode


def find_operation(document: Any, name: Any = None) -> Any:
    """Operation to correct: the uppermost dressup over the one that is named.

    Parameters
    ----------
    document : FreeCAD document
    name : str or document object, optional
        Label or name; without it the only Profile of the document.

    Returns
    -------
    document object

    Raises
    ------
    UsageError
        If it is not found, or not unique; names those there are.
    """
    stacks = [(top, _below(top)) for job in compat.jobs(document) for top in compat.operations(job)]
    if name is None:
        tops = [top for top, below in stacks if base_geometry.is_profile_operation(below[-1])]
    elif isinstance(name, str):
        tops = [top for top, below in stacks if any(name == obj.Label for obj in below)] or [
            top for top, below in stacks if any(name == obj.Name for obj in below)
        ]
    else:
        tops = [top for top, below in stacks if any(name.Name == obj.Name for obj in below)]
    if len(tops) == 1:
        return tops[0]
    called = getattr(name, "Label", name)
    what = phrase("Profile operations") if name is None else phrase("operations called {}", called)
    there = ", ".join(top.Label for top, _ in stacks) or phrase("none")
    raise UsageError(phrase("the document has {} {}; its operations are: {}", len(tops) or phrase("no"), what, there))


def _below(obj: Any) -> list[Any]:
    """A dressup and everything under it."""
    out = [obj]
    while compat.is_dressup(out[-1]):
        out.append(out[-1].Base)
    return out


def _dressed(base: Any, measurement: Any, chosen: dict[str, Any]) -> Any:
    """The dressup with the measured part: a new one, or the one that has measured parts already."""
    try:
        if measurement is not None and candidates.is_correction(base) and base.Measurement is not None:
            return dressup.add(base, measurement, **chosen)
        return dressup.create(base, measurement, **chosen)
    except ValueError as error:
        if isinstance(error, MillcorrError):
            raise
        raise UsageError(phrase("a setting is not possible: {}", message_of(error))) from error


def _require_valid(obj: Any) -> None:
    if "Invalid" in obj.State or not obj.Path.Commands:
        raise RefusedError(phrase("{}: FreeCAD could not recompute the corrected path", obj.Label))


def _posted(obj: Any) -> str:
    """The job's program; with four decimals where the job leaves their number open."""
    job = compat.parent_job(obj)
    # FreeCAD's default of three rounds by half a micrometre, as much as the whole path may err.
    return compat.post(job, wish="" if "--precision" in job.PostProcessorArgs else "--precision 4")


def proved(obj: Any, text: str, corrected: correction.Correction) -> correction.Correction:
    """Read a posted program back and compare it with the compensated profile.

    Parameters
    ----------
    obj : document object
        The dressup.
    text : str
        The whole program of the job.
    corrected : Correction

    Returns
    -------
    Correction
        With the verification of the stretch of the program that the dressup made.

    Raises
    ------
    InputError
        If the post processor left the stretch out.
    LimitError
        If it rounds more than the tolerance allows.
    """
    post = compat.parent_job(obj).PostProcessor or "linuxcnc"
    posted, unstated = _read_back(text, post)
    emitted = posted.toolpath.take(_stretch(posted, obj.Label))
    result = corrected.result
    planned = result.regeneration
    tolerance = corrected.request.settings.tolerance
    if coarse := posted.resolution > tolerance:
        tolerance += posted.resolution
    try:
        following = verification.following_by_place(emitted, planned.toolpath, planned.following)
    except LimitError as error:
        raise LimitError(
            phrase(
                "FreeCAD's post processor {} does not write the path as it is: {}; post with another one",
                post,
                message_of(error),
            )
        ) from error
    proof = verification.verify(
        emitted, result.compensated, result.path_radius, following=following, tolerance=tolerance
    )
    if coarse:
        fine, within = (f"{length * 1000:.1f} um" for length in (posted.resolution, tolerance))
        said = f"the post writes places no finer than {fine}: the posted program is proven within {within}"
        result = replace(result, advice=(*result.advice, said))
    if unstated:
        said = "the post states no unit: the posted program is right for a control that is set to inches only"
        result = replace(result, advice=(*result.advice, said))
    return replace(corrected, result=replace(result, verification=proof))


def _read_back(text: str, post: str) -> tuple[nc.Program, bool]:
    """The program that a post made, and whether it is in inches without a word that says so."""
    # So FreeCAD's post for UCCNC has it, whose profile has the unit.
    unstated = re.search(r"(?m)^\(Units: 'in' ", text) is not None and not re.search(r"(?m)^(?:N\d+ *)?G20\b", text)
    try:
        return nc.parse(f"G20\n{text}" if unstated else text, f"program of FreeCAD's post {post}"), unstated
    except FormatError as error:
        line = "" if error.line is None else f"its line {error.line}: "
        raise InputError(
            phrase(
                "what FreeCAD's post processor {} makes is no G-code that can be read back and proven "
                "({}{}): choose a post processor of G-code in the job, as linuxcnc or grbl",
                post,
                line,
                error.said,
            )
        ) from error


def _stretch(posted: nc.Program, label: str) -> Any:
    """Moves between the comments that FreeCAD's posts write around an operation; all moves without them."""
    lines = posted.text.splitlines()
    begin = [k for k, line in enumerate(lines) if re.search(r"begin operation: *" + re.escape(label), line)]
    end = [k for k, line in enumerate(lines) if re.search(r"finish operation: *" + re.escape(label), line)]
    source = posted.lines_of(posted.toolpath.source)
    rows = source >= 0
    if len(begin) == 1 and len(end) == 1:
        rows = (source > begin[0]) & (source < end[0])
    if not rows.any():
        raise InputError(phrase("{}: the posted program has no move of this operation", label))
    return rows


def _write(
    document: Any,
    source: Path | None,
    corrected: correction.Correction,
    text: str | None,
    output: str | Path | None,
    gcode: str | Path | None,
    directory: str | Path | None,
    part: production.Judged | None = None,
    exports: reports.Exports = reports.NO_EXPORTS,
) -> None:
    """Write program and document beside their places, then the report, then put them in place."""
    with ExitStack() as stack:
        ready: list[tuple[Path, Path]] = []
        written = {}
        if gcode is not None and text is not None:
            beside = stack.enter_context(_beside(Path(gcode)))
            beside.write_bytes(text.encode("utf-8"))
            ready.append((beside, Path(gcode)))
            written["program"] = str(gcode)
        if output is not None:
            beside = stack.enter_context(_beside(Path(output)))
            document.saveCopy(str(beside))
            if source is not None:
                views.carry_over(source, beside)
            ready.append((beside, Path(output)))
            written["document"] = str(output)
        notes = [] if written else ["Check only: no program was written."]
        if text is not None:
            notes.append(_READ_BACK)
        _put(ready, part, corrected.result, directory, written, notes, exports)


def _put(
    ready: list[tuple[Path, Path]],
    part: production.Judged | None,
    result: pipeline.Result,
    directory: str | Path | None,
    written: dict[str, str],
    notes: list[str],
    exports: reports.Exports,
) -> None:
    """Write the report, then put files in their places; the document last: by it the journal knows that all is done."""
    with ExitStack() as stack:
        if part is not None:
            beside, output = ready[-1]
            number = stack.enter_context(part.entered(output, sha256(beside)))
            written = {**written, "journal": f"part {number}"}
            notes = [*part.notes, *notes]
        if directory is not None:
            reports.write(result, directory, outputs=written, notes=notes, exports=exports)
        for beside, place in ready:
            os.replace(beside, place)


def sha256(path: Path) -> str:
    """SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


@contextmanager
def _beside(place: Path) -> Iterator[Path]:
    """A temporary name in the same directory and with the same suffix."""
    path = place.absolute().parent / f".millcorr-{uuid4().hex}{place.suffix}"
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)
