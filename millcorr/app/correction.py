# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a dressup's properties to the pipeline's request, and its result back to FreeCAD."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from millcorr import pipeline
from millcorr.errors import InputError, UsageError
from millcorr.profile import Profile

from . import base_geometry, compat, convert, motion
from .measurement_object import measurement_of


@dataclass(frozen=True, eq=False, slots=True)
class Correction:
    """What was asked of the pipeline and what it answered.

    Parameters
    ----------
    request : pipeline.Request
    result : pipeline.Result
    commands : list of Path.Command
        Commands of the operation that is corrected, in the job's frame.
    """

    request: pipeline.Request
    result: pipeline.Result
    commands: list[Any]

    def path(self) -> Any:
        """The corrected FreeCAD path."""
        regeneration = self.result.regeneration
        return motion.path_of_toolpath(
            self.commands,
            self.request.program.toolpath,
            regeneration.toolpath,
            self.result.header() if regeneration.changed else (),
        )


def settings_of(obj: Any) -> pipeline.Settings:
    """Settings of a dressup."""
    return pipeline.Settings(
        side=obj.Side,
        align=obj.Align,
        accept=tuple(obj.Accept),
        filter=obj.Filter,
        method=obj.Method,
        gain=obj.Gain,
        limit=obj.Limit.Value,
        dead_band=obj.DeadBand.Value,
        tolerance=obj.Tolerance.Value,
        output_moves=obj.OutputMoves,
        cutter_compensation=obj.CutterCompensation,
    )


def request_of(obj: Any) -> tuple[pipeline.Request, list[Any]]:
    """Request of a dressup, and the commands of the operation below it.

    Raises
    ------
    UsageError
        If it has no operation below it.
    InputError
        If operation, profile or measurement cannot be used.
    """
    if obj.Base is None:
        raise UsageError(f"{obj.Label}: the dressup has no operation below it")
    path = compat.path_of(obj.Base)
    commands = list(path.Commands)
    if not commands:
        raise InputError(f"{obj.Base.Label}: the operation has no path; recompute it")
    program = motion.program_of_path(path, obj.Base.Label)
    operation = compat.bottom_operation(obj.Base)
    tool_radius = (obj.ToolDiameter.Value or compat.tool_diameter(obj.Base)) / 2
    if base_geometry.leaves_radius_to_control(operation):
        side = base_geometry.side_of_path(_nominal(obj, operation, program), program.toolpath)
        program = motion.program_of_path(path, obj.Base.Label, side)
    request = pipeline.Request(
        program=program,
        radius=base_geometry.path_radius(operation, tool_radius),
        measurement=None if obj.Measurement is None else measurement_of(obj.Measurement),
        nominal=_nominal(obj, operation, program),
        settings=settings_of(obj),
        further=() if obj.Measurement is None else tuple(measurement_of(part) for part in obj.FurtherParts),
    )
    return request, commands


def _nominal(obj: Any, operation: Any, program: Any) -> Profile | None:
    """Nominal profile: the linked one, the operation's own, or None to take it from the path."""
    if obj.Nominal is not None:
        if not hasattr(obj.Nominal, "Shape"):
            raise InputError(f"{obj.Nominal.Label} has no shape to take as nominal profile")
        material = "inside" if getattr(operation, "Side", "Outside") != "Inside" else "outside"
        return convert.profile_of_shape(obj.Nominal.Shape, material)
    if base_geometry.is_profile_operation(operation):
        return base_geometry.profile_of_operation(operation, program.toolpath)
    return None


def correct(obj: Any) -> Correction:
    """Correct the operation below a dressup.

    Parameters
    ----------
    obj : document object
        Anything with the dressup's properties.

    Returns
    -------
    Correction

    Raises
    ------
    MillcorrError
        If it cannot or must not be corrected.
    """
    request, commands = request_of(obj)
    return Correction(request, pipeline.correct(request), commands)
