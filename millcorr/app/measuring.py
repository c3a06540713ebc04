# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measuring programs of operations in a document: for the window, scripts and macros.

Example
-------
>>> from millcorr.app import measuring
>>> operation = FreeCAD.ActiveDocument.getObject("Profile")
>>> print(measuring.write(operation, "PROBE.nc", dialect="linuxcnc-protected", probe={"ball_radius": 2.5}))
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from millcorr.cli import measuring_task
from millcorr.cli.measuring_task import save as written
from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import option, phrase
from millcorr.nc import Program
from millcorr.probing.controls import MeasuringProgram
from millcorr.probing.heights import Cleared
from millcorr.probing.workpiece import Workpiece

from . import base_geometry, compat, convert, motion

FACETS = 0.01
"""Facets of the model lie so near to it, mm: less than any margin of a probe."""


def contour_of(operation: Any, nominal: Any = None) -> tuple[Profile, Program, float]:
    """What an operation or a dressup cuts, its path as a program, and the tool's radius.

    Parameters
    ----------
    operation : document object
    nominal : document object, optional
        What to measure instead of the operation's own contour.

    Returns
    -------
    profile : Profile
        Material on the left.
    program : Program
        Under G41 or G42 where the control holds the radius.
    radius : float
        mm.

    Raises
    ------
    InputError, UsageError
        If the operation has no contour of its own and no nominal is given, or no path.
    """
    bottom = compat.bottom_operation(operation)
    path = compat.path_of(operation)
    program = motion.program_of_path(path, operation.Label)
    profile = base_geometry.nominal_of(bottom, program.toolpath, nominal)
    if profile is None:
        raise UsageError(
            phrase(
                "{} is no Profile or Pocket operation: give the contour with {}",
                bottom.Label,
                option("nominal", of="#LABEL"),
            )
        )
    if base_geometry.leaves_radius_to_control(bottom):
        side = base_geometry.side_of_path(profile, program.toolpath)
        program = motion.program_of_path(path, operation.Label, side)
    return profile, program, compat.tool_diameter(operation) / 2


def workpiece_of(operation: Any) -> Workpiece | None:
    """The solids of the model that an operation's job machines, in the job's frame; None where it has none."""
    job = compat.parent_job(operation)
    models = [] if job is None else list(job.Model.Group)
    solids = [solid for model in models for solid in compat.shape_in_document(model).Solids]
    return Workpiece(np.concatenate([convert.facets_of(solid, FACETS) for solid in solids]), FACETS) if solids else None


def prepared(
    operation: Any,
    *,
    dialect: str,
    probe: Mapping[str, Any],
    placement: Mapping[str, Any] | None = None,
    nominal: Any = None,
    output: str | Path = "PROBE.nc",
    **options: Any,
) -> Callable[[], MeasuringProgram]:
    """Do now what needs FreeCAD, and give what plans and writes: it needs none and may be called in any thread.

    Parameters
    ----------
    operation : document object
        Operation or dressup that cuts the contour.
    dialect : str
        Name from `millcorr.probing.controls.DIALECTS`.
    probe, placement : mapping
        Fields of `millcorr.probing.TouchProbe` and `Placement`; 40 points where nothing is said.
    nominal : document object, optional
        What to measure instead of the operation's own contour.
    output : str or Path
        File that it will be written to; program and log are named after it.
    **options
        ``z, safe_z, feed, positioning, tool, log, name`` as in `millcorr.cli.measuring_task.prepared`.

    Returns
    -------
    callable
        Gives the program; raises MillcorrError where nothing can be touched.

    Raises
    ------
    MillcorrError
        If the operation or an option cannot be used.
    """
    profile, program, radius = contour_of(operation, nominal)
    return measuring_task.prepared(
        profile,
        Cleared(program.toolpath, radius, True),
        Path(output),
        dialect=dialect,
        probe=probe,
        placement=placement or {},
        source=operation.Label,
        workpiece=workpiece_of(operation),
        **options,
    )


def write(operation: Any, output: str | Path, **options: Any) -> str:
    """Write a program that measures what an operation cuts; what else the control needs is written beside it.

    Parameters
    ----------
    operation : document object
    output : str or Path
    **options
        As `prepared`.

    Returns
    -------
    str
        What was written, and how to read back what the control will log.

    Raises
    ------
    MillcorrError
        If no point can be touched; nothing is written then.
    """
    return written(prepared(operation, output=output, **options)(), Path(output))
