# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a dressup's properties to the pipeline's request, and its result back to FreeCAD."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from millcorr import pipeline, setup_file
from millcorr.errors import InputError, UsageError
from millcorr.measurement import Measurement
from millcorr.series.places import field_of_text
from millcorr.setup_file import Setup

from . import base_geometry, compat, motion
from .measurement_object import reader_of


@dataclass(frozen=True, eq=False, slots=True)
class Correction:
    """What was asked of the pipeline and what it answered.

    Parameters
    ----------
    request : pipeline.Request
    result : pipeline.Result
    commands : list of Path.Command
        Commands of the operation that is corrected, in the job's frame.
    header : tuple of str
        Comments that mark the corrected path: they name the points, and a million of them take their time.
    """

    request: pipeline.Request
    result: pipeline.Result
    commands: list[Any]
    header: tuple[str, ...]

    def path(self) -> Any:
        """The corrected FreeCAD path."""
        regeneration = self.result.regeneration
        return motion.path_of_toolpath(
            self.commands,
            self.request.program.toolpath,
            regeneration.toolpath,
            self.header if regeneration.changed else (),
        )


_FIELDS = {field.name: field.default for field in fields(pipeline.Settings)}


def _property(name: str) -> str:
    """Name of the dressup's property for a setting: ``dead_band`` is ``DeadBand``."""
    return name.title().replace("_", "")


def properties_of(options: Mapping[str, Any]) -> dict[str, Any]:
    """Properties of a dressup by name: settings, the tool's diameter, the setup's file; None leaves one as it is.

    Raises
    ------
    UsageError
        If a name is none of a setting.
    """
    known = ("tool_diameter", "setup", *_FIELDS)
    unknown = sorted(set(options) - set(known))
    if unknown:
        raise UsageError(f"unknown setting {unknown[0]}; known are {', '.join(known)}")
    return {_property(name): value for name, value in options.items() if value is not None}


def settings_of(obj: Any) -> pipeline.Settings:
    """Settings of a dressup."""
    return pipeline.Settings(**{name: _value(obj, name, default) for name, default in _FIELDS.items()})


def _value(obj: Any, name: str, default: Any) -> Any:
    """Value of a setting; what is optional has the property 0 or an empty list where it is left out."""
    # A setting that the dressup does not offer has its default.
    value = getattr(obj, _property(name), default)
    value = getattr(value, "Value", value)
    if isinstance(value, list):
        value = tuple(value)
    return value or None if default is None else value


def request_of(obj: Any) -> tuple[pipeline.Request, list[Any]]:
    """Request of a dressup with its measurements read, and the commands of the operation below it.

    Raises
    ------
    UsageError
        If it has no operation below it.
    InputError
        If operation, profile or measurement cannot be used.
    """
    request, commands, readers = _described(obj)
    return _measured(request, readers, _smoothed(obj)), commands


def _smoothed(obj: Any) -> str:
    """Property of a dressup; empty on what is none."""
    return getattr(obj, "Smoothed", "")


def _described(obj: Any) -> tuple[pipeline.Request, list[Any], list[Callable[[], Measurement]]]:
    """Request without measurements, commands, and what reads the measurements."""
    if obj.Base is None:
        raise UsageError(f"{obj.Label}: the dressup has no operation below it")
    path = compat.path_of(obj.Base)
    commands = list(path.Commands)
    if not commands:
        raise InputError(f"{obj.Base.Label}: the operation has no path; recompute it")
    program = motion.program_of_path(path, obj.Base.Label)
    operation = compat.bottom_operation(obj.Base)
    tool_radius = (_value(obj, "tool_diameter", None) or compat.tool_diameter(obj.Base)) / 2
    nominal = base_geometry.nominal_of(operation, program.toolpath, obj.Nominal)
    settings = settings_of(obj)
    if base_geometry.is_profile_operation(operation):
        # The operation itself says whether its path is the contour or the centre's, whatever G41 a dressup adds.
        given = base_geometry.leaves_radius_to_control(operation)
        settings = replace(settings, cutter_compensation="contour" if given else "wear")
        if given and nominal is not None:
            side = base_geometry.side_of_path(nominal, program.toolpath)
            program = motion.program_of_path(path, obj.Base.Label, side)
    request = pipeline.Request(
        program=program,
        radius=base_geometry.path_radius(operation, tool_radius),
        measurement=None,
        nominal=nominal,
        settings=settings,
        setup=_setup(obj),
    )
    parts = [] if obj.Measurement is None else [obj.Measurement, *obj.FurtherParts]
    return request, commands, [reader_of(part) for part in parts]


def _setup(obj: Any) -> Setup | None:
    """Setup of a dressup where its method needs one; named by its file alone, which lies elsewhere every time."""
    place = getattr(obj, "Setup", "")
    if not place or obj.Method not in ("combined", "predicted"):
        return None
    return replace(setup_file.load(place), source=Path(place).name)


def _measured(request: pipeline.Request, readers: list[Callable[[], Measurement]], smoothed: str) -> pipeline.Request:
    """The request with its measurements, and with what a series has smoothed up to these very ones, if it has."""
    parts = [read() for read in readers]
    if not parts:
        return request
    field = field_of_text(smoothed, [part.fingerprint for part in parts]) if smoothed else None
    return replace(request, measurement=parts[0], further=tuple(parts[1:]), smoothed=field)


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
    return prepared(obj)()


def prepared(obj: Any) -> Callable[[], Correction]:
    """Do now what needs FreeCAD, and give what does the rest: it needs none and may be called in any thread.

    Parameters
    ----------
    obj : document object
        Anything with the dressup's properties.

    Returns
    -------
    callable
        Reads and corrects; raises MillcorrError as `correct`.

    Raises
    ------
    MillcorrError
        If operation or settings cannot be used.
    """
    request, commands, readers = _described(obj)
    smoothed = _smoothed(obj)

    def finish() -> Correction:
        asked = _measured(request, readers, smoothed)
        result, header = _corrected(asked)
        return Correction(asked, result, commands, header)

    return finish


_KEPT = 2
"""So many results are kept: what was shown before it was accepted is not computed again."""

_results: dict[tuple[Any, ...], tuple[pipeline.Result, tuple[str, ...]]] = {}


def _corrected(request: pipeline.Request) -> tuple[pipeline.Result, tuple[str, ...]]:
    """Result of a request and the path's header; the very ones from before if nothing differs."""
    nominal = None if request.nominal is None else pickle.dumps(request.nominal.as_dict())
    setup = repr(request.setup)
    smoothed = None if request.smoothed is None else pickle.dumps(request.smoothed)
    # Measurements are the same objects as long as their files are: a kept result holds on to them.
    measured = tuple(map(id, request.measurements))
    program = request.program
    key = (program.name, program.data, request.radius, measured, nominal, request.settings, setup, smoothed)
    kept = _results.get(key)
    if kept is None:
        result = pipeline.correct(request)
        kept = result, result.header()
        for old in list(_results)[: 1 - _KEPT]:
            _results.pop(old, None)
        _results[key] = kept
    return kept
