# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC program files corrected and split from a script, with options by name: what the window records in macros.

Needs nothing of FreeCAD, unless a nominal comes from a CAD file.

Example
-------
>>> from millcorr.app import programs
>>> print(programs.correct("part.nc", "cmm.csv", tool_diameter=10, points="contact", output="corrected.nc"))
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from millcorr import pipeline
from millcorr.cli import verbs
from millcorr.correction.settings import Settings
from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.production.process_control import LIMITS
from millcorr.readers import Reading
from millcorr.report.reader import read_by

from .wording import reader

_MEASURED = str | Path | Sequence[str | Path]


def correct(
    program: str | Path,
    measured: _MEASURED,
    *,
    tool_diameter: float | None = None,
    nominal: str | None = None,
    setup: str | Path | None = None,
    output: str | Path | None = None,
    report: str | Path | None = None,
    journal: str | None = None,
    **options: Any,
) -> str:
    """Correct an NC program from measured parts; without `output`, only check.

    Parameters
    ----------
    program : str or Path
    measured : str, Path or sequence of them
        One file a part; deviations of several are averaged.
    tool_diameter : float
        mm.
    nominal : str, optional
        As `millcorr.cli.verbs.correct_program`.
    setup : str or Path, optional
        Tool, material, machine and stock, for the methods that simulate; it may name the tool's diameter.
    output, report : str or Path, optional
        Program to write, and directory for the report.
    journal : str, optional
        Journal of the series; '' for the one beside the nominal or the program.
    **options
        Fields of `millcorr.readers.Reading` and of `millcorr.correction.settings.Settings`, and the process
        control: ``control`` and `millcorr.production.process_control.LIMITS`.

    Returns
    -------
    str
        What was found and done, in a few lines.

    Raises
    ------
    MillcorrError
        If an option is unknown, a file cannot be used, or the correction is refused; nothing is written then.
    """
    control = options.pop("control", None)
    limits = {name: options.pop(name) for name in LIMITS if name in options}
    reading, settings = _said(options)
    with read_by(reader()):
        asked = verbs.CorrectionAsked(
            _files(measured),
            reading,
            nominal,
            tool_diameter,
            output=None if output is None else Path(output),
            report=None if report is None else Path(report),
            settings=settings,
            setup=None if setup is None else Path(setup),
            journal=journal,
            control=control,
            limits={name: value for name, value in limits.items() if value is not None},
        )
        return verbs.correct_program(Path(program), asked)


def history(journal: str | Path, *, report: str | Path) -> str:
    """Write the report of a series from its journal.

    Parameters
    ----------
    journal : str or Path
    report : str or Path
        Directory of the report.

    Returns
    -------
    str
        The parts, and where the report is.

    Raises
    ------
    MillcorrError
        If the journal cannot be read or the report cannot be written.
    """
    with read_by(reader()):
        return verbs.history(Path(journal), report=Path(report))


def check(
    program: str | Path,
    measured: _MEASURED,
    *,
    tool_diameter: float | None = None,
    nominal: str | None = None,
    setup: str | Path | None = None,
    **options: Any,
) -> pipeline.Result:
    """The correction itself, as an object; nothing is written. Parameters and errors as `correct`."""
    reading, settings = _said(options)
    known = None if setup is None else Path(setup)
    files = _files(measured)
    verbs.require_measured(files, known, settings)
    return pipeline.correct(
        verbs.program_request(Path(program), files, reading, nominal, tool_diameter, settings, known)
    )


def split(
    program: str | Path,
    *,
    tool_diameter: float,
    depth: float,
    output: str | Path,
    at: float = 0.5,
    nominal: str | None = None,
    **options: Any,
) -> str:
    """Write the program of a first cut; see `millcorr.cli.verbs.split_program`, with `Settings` by name."""
    reading, settings = _said(options)
    if reading != Reading():
        raise UsageError(phrase("a first cut is made before anything is measured"))
    return verbs.split_program(
        Path(program),
        tool_diameter=tool_diameter,
        depth=depth,
        at=at,
        nominal=nominal,
        output=Path(output),
        settings=settings,
    )


def _files(measured: _MEASURED) -> list[Path]:
    return [Path(measured)] if isinstance(measured, str | Path) else [Path(path) for path in measured]


def _said(options: Mapping[str, Any]) -> tuple[Reading, Settings]:
    """How to read and how to correct, from options by name; None leaves one as it is."""
    rest = dict(options)
    reading = Reading.from_dict({k: rest.pop(k) for k in list(rest) if k in Reading.__slots__})
    unknown = sorted(set(rest) - set(Settings.__slots__))
    if unknown:
        raise UsageError(phrase("unknown setting {}; known are {}", unknown[0], ", ".join(Settings.__slots__)))
    return reading, Settings(**{name: value for name, value in rest.items() if value is not None})
