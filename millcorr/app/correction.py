# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a dressup's properties to the pipeline's request, and its result back to FreeCAD."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import Path

from millcorr import pipeline
from millcorr.arrays import Floats
from millcorr.errors import InputError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase
from millcorr.nc.toolpath import Compensation
from millcorr.options import field_name, options_of
from millcorr.production.places import field_of_text
from millcorr.readers.measurement import Measurement

from . import base_geometry, compat, motion
from .measurement_object import reader_of
from .rounds import Round, rounds_of, setup_of


@dataclass(frozen=True, eq=False, slots=True)
class Correction:
    """What was asked of the pipeline and what it answered.

    Parameters
    ----------
    request : pipeline.Request
    result : pipeline.Result
    commands : list of Path.Command
        Commands of the path that is corrected, in the job's frame: the operation's, or what earlier rounds left.
    header : tuple of str
        Comments that mark the corrected path: they name the points, and a million of them take their time.
    cuts : tuple of (str, str)
        Of each round, oldest first, what `CutPath` said and what it would say now.
    """

    request: pipeline.Request
    result: pipeline.Result
    commands: list[Any]
    header: tuple[str, ...]
    cuts: tuple[tuple[str, str], ...] = ()

    @property
    def otherwise_cut(self) -> bool:
        """Whether a measured part was cut with another path than the one that is corrected from it now."""
        return any(was and was.split()[0] == now.split()[0] and was != now for was, now in self.cuts)

    def path(self) -> Any:
        """The corrected FreeCAD path."""
        regeneration = self.result.regeneration
        return motion.path_of_toolpath(
            self.commands,
            self.request.program.toolpath,
            regeneration.toolpath,
            self.header if regeneration.changed else (),
        )


def properties_of(options: Mapping[str, Any]) -> dict[str, Any]:
    """Properties of a dressup by name: settings, the tool's diameter, the setup's file; None leaves one as it is.

    Raises
    ------
    UsageError
        If a name is none of a setting.
    """
    known = ("tool_diameter", "setup", *options_of(pipeline.Settings))
    unknown = sorted(set(options) - set(known))
    if unknown:
        raise UsageError(phrase("unknown setting {}; known are {}", unknown[0], ", ".join(known)))
    return {field_name(name): value for name, value in options.items() if value is not None}


def settings_of(obj: Any) -> pipeline.Settings:
    """Settings of a dressup."""
    return pipeline.Settings(
        **{key: _value(obj, key, one.default) for key, one in options_of(pipeline.Settings).items()}
    )


def _value(obj: Any, name: str, default: Any) -> Any:
    """Value of a setting; what is optional has the property 0 or an empty list where it is left out."""
    # A setting that the dressup does not offer has its default.
    value = getattr(obj, field_name(name), default)
    value = getattr(value, "Value", value)
    if isinstance(value, list):
        value = tuple(value)
    return value or None if default is None else value


def request_of(obj: Any) -> tuple[pipeline.Request, list[Any]]:
    """Request of a dressup's newest round with its measurements read, and the commands of the path it begins with.

    Raises
    ------
    UsageError
        If it has no operation below it.
    MillcorrError
        If operation, profile or measurement cannot be used, or an earlier round is refused.
    """
    asked, commands, _ = _described(obj).newest()
    return asked, commands


@dataclass(frozen=True, eq=False, slots=True)
class _Asked:
    """What FreeCAD was asked for a correction; the rest needs it no more.

    Parameters
    ----------
    request : pipeline.Request
        Of the operation's own path, without a measurement.
    commands : list of Path.Command
    side : Compensation
        Side on which the control holds the radius, where the path is the contour itself.
    settings : callable
        Settings that the operation leaves of those of a round.
    rounds : list of (Round, list of callable)
        Rounds that count, oldest first, and what reads their measurements.
    """

    request: pipeline.Request
    commands: list[Any]
    side: Compensation
    settings: Callable[[Any], pipeline.Settings]
    rounds: list[tuple[Round, list[Callable[[], Measurement]]]]

    def newest(self) -> tuple[pipeline.Request, list[Any], tuple[tuple[str, str], ...]]:
        """Request of the newest round, the commands it begins with, and what each round's path was and is."""
        request, commands, cuts = self.request, self.commands, []
        base, last = request.program.digest, len(self.rounds) - 1
        # What a part was cut with is not computed again while nothing below it has changed.
        kept = [k for k, (one, _) in enumerate(self.rounds[:-1]) if one.left and one.begun == base]
        begin = kept[-1] + 1 if kept and request.nominal is not None else 0
        if begin:
            request, commands = self._continued(request, Path.Path(self.rounds[begin - 1][0].left))
            cuts = [(one.cut, one.cut) for one, _ in self.rounds[:begin]]
        for number, (one, readers) in enumerate(self.rounds[begin:], begin):
            request = replace(request, settings=self.settings(one.values), setup=one.setup)
            request = _measured(request, readers, one.smoothed)
            cuts.append((one.cut, cut_with(request)))
            if number < last:
                request, commands = self._after(request, commands)
        return request, commands, tuple(cuts)

    def _continued(self, request: pipeline.Request, path: Any) -> tuple[pipeline.Request, list[Any]]:
        """What is asked of a path that a round has left, and its commands."""
        program = motion.program_of_path(path, request.program.name, self.side)
        next_ = replace(request, program=program, smoothed=None, further=(), measurement=None)
        return next_, list(path.Commands)

    def _after(self, request: pipeline.Request, commands: list[Any]) -> tuple[pipeline.Request, list[Any]]:
        """What is asked of the path that a round has left, and its commands."""
        key = _key(request)
        kept = _paths.get(key)
        if kept is None:
            result, header = _corrected(request)
            path = Correction(request, result, commands, header).path()
            for old in list(_paths)[: 1 - _KEPT_PATHS]:
                _paths.pop(old, None)
            # The measurements stay, that no others take their places in the key.
            kept = _paths[key] = (path, result.nominal, request.measurements)
        path, nominal, _ = kept
        following, left = self._continued(request, path)
        own = request.nominal is None or request.nominal_is_first_program
        return replace(following, nominal=nominal, nominal_is_first_program=own), left


def begun_with(obj: Any) -> str:
    """SHA-256 of the path of the operation below a dressup."""
    return _described(obj).request.program.digest


def cut_with(request: pipeline.Request) -> str:
    """What `CutPath` says of the newest part of a request: the digests of its file and of the path it was cut with."""
    measured = request.measurement
    return "" if measured is None else f"{measured.digest} {request.program.digest}"


def _described(obj: Any) -> _Asked:
    """All that FreeCAD has to say."""
    if obj.Base is None:
        raise UsageError(phrase("{}: the dressup has no operation below it", obj.Label))
    path = compat.path_of(obj.Base)
    commands = list(path.Commands)
    if not commands:
        raise InputError(phrase("{}: the operation has no path; recompute it", obj.Base.Label))
    if not any(command.Name in motion.FEEDS for command in commands):
        raise InputError(
            phrase(
                "{}: the operation cuts along no contour; check its base geometry, and that its FinalDepth "
                "lies below the edges that are selected",
                obj.Base.Label,
            )
        )
    program = motion.program_of_path(path, obj.Base.Label)
    operation = compat.bottom_operation(obj.Base)
    tool_radius = (_value(obj, "tool_diameter", None) or compat.tool_diameter(obj.Base)) / 2
    nominal = base_geometry.nominal_of(operation, program.toolpath, obj.Nominal)
    side, own = Compensation.OFF, {}
    if base_geometry.leaves_radius_to_control(operation) and nominal is not None:
        own = {"cutter_compensation": "contour"}
        side = base_geometry.side_of_path(nominal, program.toolpath)
        program = motion.program_of_path(path, obj.Base.Label, side)
    elif base_geometry.gives_contour(operation) and (program.toolpath.compensation != Compensation.OFF).any():
        # The operation's path is the centre's: the G41 that a dressup adds holds wear only.
        own = {"cutter_compensation": "wear"}

    def settings(values: Any) -> pipeline.Settings:
        return replace(settings_of(values), **own)

    request = pipeline.Request(
        program=program,
        radius=base_geometry.path_radius(operation, tool_radius),
        measurement=None,
        nominal=nominal,
        settings=settings(obj),
        setup=setup_of(obj),
    )
    rounds = [(one, [reader_of(part) for part in one.parts]) for one in rounds_of(obj)]
    return _Asked(request, commands, side, settings, rounds)


def _measured(request: pipeline.Request, readers: list[Callable[[], Measurement]], smoothed: str) -> pipeline.Request:
    """The request with its measurements, and with what a series has smoothed up to these very ones, if it has."""
    parts = [read() for read in readers]
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
    asked = _described(obj)

    def finish() -> Correction:
        request, commands, cuts = asked.newest()
        result, header = _corrected(request)
        return Correction(request, result, commands, header, cuts)

    return finish


def seen(obj: Any) -> Callable[[], tuple[Profile | None, Floats]]:
    """Do now what needs FreeCAD, and give what reads the newest points: what is drawn of a correction that is refused.

    Parameters
    ----------
    obj : document object
        Anything with the dressup's properties.

    Returns
    -------
    callable
        Gives the nominal where the operation itself has one, and the points as they were measured, (n, 3) in mm.
    """
    asked = _described(obj)

    def finish() -> tuple[Profile | None, Floats]:
        points = [read().points for _, readers in asked.rounds[-1:] for read in readers]
        return asked.request.nominal, np.concatenate([np.zeros((0, 3)), *points])

    return finish


_KEPT = 2
"""So many results are kept: what was shown before it was accepted is not computed again."""

_results: dict[tuple[Any, ...], tuple[pipeline.Result, tuple[str, ...]]] = {}

_KEPT_PATHS = 16
"""So many paths of earlier rounds are kept."""

_paths: dict[tuple[Any, ...], tuple[Any, Any, tuple[Measurement, ...]]] = {}


def _key(request: pipeline.Request) -> tuple[Any, ...]:
    """What makes two requests the same."""
    nominal = None if request.nominal is None else pickle.dumps(request.nominal.as_dict())
    setup = repr(request.setup)
    smoothed = None if request.smoothed is None else pickle.dumps(request.smoothed)
    # Measurements are the same objects as long as their files are: a kept result holds on to them.
    measured = tuple(map(id, request.measurements))
    program = request.program
    return (program.name, program.data, request.radius, measured, nominal, request.settings, setup, smoothed)


def _corrected(request: pipeline.Request) -> tuple[pipeline.Result, tuple[str, ...]]:
    """Result of a request and the path's header; the very ones from before if nothing differs."""
    key = _key(request)
    kept = _results.get(key)
    if kept is None:
        result = pipeline.correct(request)
        kept = result, result.header()
        for old in list(_results)[: 1 - _KEPT]:
            _results.pop(old, None)
        _results[key] = kept
    return kept
