# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program cut in the model of a setup, as it is and corrected, and what can be done about its error."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from millcorr.errors import RefusedError, UsageError
from millcorr.messages import option, phrase
from millcorr.pipeline import Request, correct, nominal_from_program
from millcorr.process.engagement import Engagement, engagement
from millcorr.process.kinematics import read_trace
from millcorr.process.prediction import Simulation, simulate
from millcorr.process.prediction.corner_feed import CornerFeeds
from millcorr.process.prediction.logged_machine import LoggedMachine, logged_machine
from millcorr.process.prediction.predicted_correction import require_setup
from millcorr.process.prediction.signals import Signals

from .remedy_programs import ShiftedProgram, TiltedProgram, shifted_program, slowed, tilted_program
from .wall import Wall, heights_of, wall_of


@dataclass(frozen=True, eq=False, slots=True)
class Asked:
    """What a study is asked for beside the signals of the cut.

    Parameters
    ----------
    heights : sequence of float
        mm above the tool's tip at which the wall is wanted; none leaves it out.
    slowed, shifted, tilted : Path, optional
        Programs to write.
    corner_error : float, optional
        Largest distance in mm between a corner and the path of the tool, for `slowed`.
    trace : Path, optional
        Log of the program, from which keys of the machine are identified; the simulation then runs with them.
    identify : tuple of str
        Which keys, from `process.prediction.logged_machine.KEYS`; by default those that the setup does not state.
    """

    heights: Sequence[float] = ()
    slowed: Path | None = None
    corner_error: float | None = None
    shifted: Path | None = None
    tilted: Path | None = None
    trace: Path | None = None
    identify: tuple[str, ...] = ()


NOTHING = Asked()
"""The signals alone."""


@dataclass(frozen=True, eq=False, slots=True)
class Study:
    """A program cut in the model of a setup, and what was asked for beside; None for what was not.

    Parameters
    ----------
    request : Request
        With the machine that a log shows, where there is one.
    asked : Asked
    before : Simulation
        Of the program as it is.
    after : Simulation or None
        Of the corrected program; None where the correction is refused.
    refused : str
        Why there is no `after`.
    signals : Signals
        Of the program as it is.
    rigid : Engagement
        On a machine that does not give way.
    wall : Wall or None
    slowed : CornerFeeds or None
    shifted : ShiftedProgram or None
    tilted : TiltedProgram or None
    machine : LoggedMachine or None
    """

    request: Request
    asked: Asked
    before: Simulation
    after: Simulation | None
    refused: str
    signals: Signals
    rigid: Engagement
    wall: Wall | None
    slowed: CornerFeeds | None
    shifted: ShiftedProgram | None
    tilted: TiltedProgram | None
    machine: LoggedMachine | None

    def programs(self) -> dict[Path, bytes]:
        """Programs to write, by their place."""
        asked = self.asked
        made = ((asked.slowed, self.slowed), (asked.shifted, self.shifted), (asked.tilted, self.tilted))
        return {place: found.data for place, found in made if place is not None and found is not None}


def study(request: Request, asked: Asked = NOTHING) -> Study:
    """Cut a program and its correction in the model of a setup, and make what is asked for beside.

    Parameters
    ----------
    request : Request
        With a setup and method ``predicted``.
    asked : Asked, optional

    Returns
    -------
    Study

    Raises
    ------
    MillcorrError
        If program or setup cannot be used, or a remedy is refused. A correction that is refused is only not there.
    """
    heights = heights_of(asked.heights)
    if asked.tilted is not None and len(heights) < 2:
        raise UsageError(
            phrase(
                "{} needs {} at two heights at least: the tool leans by the wall's slope",
                option("tilted"),
                option("heights", of="MM"),
            ),
        )
    if asked.shifted is not None and not len(heights):
        raise UsageError(
            phrase(
                "{} needs {}: the contour is moved by the wall's mean error over them",
                option("shifted"),
                option("heights", of="MM"),
            ),
        )
    request, machine = _as_logged(request, asked)
    before, after, refused = simulated(request)
    wall = wall_of(request.program, before, heights) if len(heights) else None
    return Study(
        request=request,
        asked=asked,
        before=before,
        after=after,
        refused=refused,
        signals=Signals.of(before, request.program),
        rigid=engagement(before.feed.toolpath, before.setup, before.stock),
        wall=wall,
        slowed=_slowed(request, before, asked),
        shifted=None if wall is None or asked.shifted is None else shifted_program(request, before, wall.before),
        tilted=None if wall is None or asked.tilted is None else _tilted(request, before, wall),
        machine=machine,
    )


def simulated(request: Request) -> tuple[Simulation, Simulation | None, str]:
    """Simulate a program and its correction.

    Parameters
    ----------
    request : Request
        With a setup and method ``predicted``.

    Returns
    -------
    before : Simulation
        Of the program as it is.
    after : Simulation or None
        Of the corrected program; None where the correction is refused.
    refused : str
        Why there is no `after`.

    Raises
    ------
    MillcorrError
        If program or setup cannot be used.
    """
    try:
        prediction = correct(request).prediction
    except RefusedError as error:
        setup, nominal = require_setup(request.setup, request.settings, request.radius), request.nominal
        if nominal is None:
            nominal = nominal_from_program(request.program, request.radius, request.settings, None)
        return simulate(request.program, setup, nominal), None, error.message
    assert prediction is not None
    return prediction.before, prediction.after[-1], ""


def _as_logged(request: Request, asked: Asked) -> tuple[Request, LoggedMachine | None]:
    """The request with the machine that a log shows."""
    if asked.trace is None or request.setup is None:
        if asked.identify:
            raise UsageError(
                phrase("{} belongs to {}, the log that tells", option("identify"), option("trace", of="TRACE.csv"))
            )
        return request, None
    machine = logged_machine(request.setup, request.program, read_trace(asked.trace), asked.identify)
    return replace(request, setup=machine.setup), machine


def _slowed(request: Request, before: Simulation, asked: Asked) -> CornerFeeds | None:
    if asked.slowed is None:
        if asked.corner_error is not None:
            raise UsageError(
                phrase(
                    "{} belongs to {}, the program that keeps it", option("corner_error"), option("slowed", of="OUT.nc")
                )
            )
        return None
    return slowed(request.program, before.setup, asked.corner_error, request.settings.tolerance)


def _tilted(request: Request, before: Simulation, wall: Wall) -> TiltedProgram:
    if wall.remedy is None:
        raise RefusedError(phrase("tilt: {}", wall.note))
    return tilted_program(request, before, wall.before, wall.remedy)
