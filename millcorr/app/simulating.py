# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations of a document simulated with a setup: for the window, scripts and macros.

Example
-------
>>> from millcorr.app import simulating
>>> print(simulating.write(FreeCAD.ActiveDocument.getObject("Profile"), "setup.toml", "simulated/"))
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from millcorr import pipeline
from millcorr.correction.settings import Settings
from millcorr.process import setup_file
from millcorr.process.prediction.signals import Signals
from millcorr.production.simulation import simulated, study
from millcorr.report.picture.simulation import Played
from millcorr.report.reader import read_by

from . import base_geometry, compat, measuring, wording


def request_of(operation: Any, setup: str | Path) -> pipeline.Request:
    """What is asked of the pipeline: the operation's path, its contour, and a setup.

    Parameters
    ----------
    operation : document object
        Operation or dressup with a path.
    setup : str or Path
        TOML file; see `millcorr.process.setup_file`.

    Returns
    -------
    pipeline.Request
        With method ``predicted``.

    Raises
    ------
    MillcorrError
        If operation or setup cannot be used.
    """
    profile, program, tool_radius = measuring.contour_of(operation)
    radius = base_geometry.path_radius(compat.bottom_operation(operation), tool_radius)
    chosen = setup_file.load(setup)
    return pipeline.Request(program, radius, None, profile, Settings(method="predicted"), setup=chosen)


def prepared(operation: Any, setup: str | Path) -> Callable[[], Played]:
    """Do now what needs FreeCAD, and give what simulates: it needs none and may be called in any thread.

    Parameters
    ----------
    operation, setup
        As `request_of`.

    Returns
    -------
    callable
        Gives what was cut, before and after a correction of the predicted error; raises MillcorrError.

    Raises
    ------
    MillcorrError
        If operation or setup cannot be used.
    """
    request = request_of(operation, setup)

    def finish() -> Played:
        before, after, refused = simulated(request)
        return Played(Signals.of(before, request.program), before, after, refused)

    return finish


def write(operation: Any, setup: str | Path, directory: str | Path) -> str:
    """Simulate an operation and write the report of it; see `written`."""
    return written(request_of(operation, setup), directory)


def written(request: pipeline.Request, directory: str | Path) -> str:
    """Simulate, and write the report of it; see `millcorr.report.simulation.write`. Needs nothing of FreeCAD."""
    # Imported when it is wanted: the plots take their time to load.
    from millcorr.report import simulation as report_simulation

    with read_by(wording.reader()):
        return report_simulation.write(study(request), Path(directory))
