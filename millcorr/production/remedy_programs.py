# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that carry a remedy of the simulation: corners run slower, a tool that leans against its own bending.

dat-2025, figs. 5 and 13. Each is read back and predicted again with the model that asked for it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from millcorr import __version__, nc, pipeline
from millcorr.arrays import Floats
from millcorr.correction.settings import Settings
from millcorr.errors import FormatError, LimitError, UsageError
from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import Profile
from millcorr.messages import Place, option, phrase
from millcorr.process.deflection.height_error import HeightError, WallModel
from millcorr.process.deflection.real_path import SPACING, RealPath, real_path
from millcorr.process.deflection.tilt import NEAR, Remedy, even_shift, mean_shift, on_nominal, remedies, tip_shifts
from millcorr.process.deflection.tilt_axes import tilted
from millcorr.process.kinematics import halts_of
from millcorr.process.prediction import Simulation, halts_and_notes
from millcorr.process.prediction.corner_feed import CornerFeeds, slow_corners
from millcorr.process.prediction.real_feed import control_of
from millcorr.process.setup_file import Setup
from millcorr.tolerances import ARITHMETIC

EVEN_SPACING = 0.1
"""Steps along a path whose feed is the programmed one, in mm: only what is engaged changes along it."""


def path_as_run(program: nc.Program, setup: Setup) -> RealPath:
    """Path that the machine of a setup really runs; errors as `real_path`."""
    control = control_of(setup)
    halts = None if control is None else halts_and_notes(program)[0]
    spacing = EVEN_SPACING if control is None else SPACING
    return real_path(program.toolpath, control, halts=halts, spacing=spacing, name=program.name)


def slowed(program: nc.Program, setup: Setup, bound: float | None, tolerance: float) -> CornerFeeds:
    """Program that runs its corners slower where the machine of a setup rounds them off more than a bound.

    Parameters
    ----------
    program : Program
    setup : Setup
        Its machine names inertia.
    bound : float or None
        Largest distance in mm between a corner and the path of the tool.
    tolerance : float
        Path error of the written text, mm.

    Returns
    -------
    CornerFeeds
        The very bytes of the program where no corner is over the bound.

    Raises
    ------
    UsageError
        If the setup names no inertia, or there is no bound.
    MillcorrError
        As `slow_corners`.
    """
    if bound is None:
        raise UsageError(
            phrase("{} needs {}, how far the tool may pass a corner", option("slowed"), option("corner_error", of="MM"))
        )
    control = control_of(setup)
    if control is None:
        raise UsageError(
            phrase(
                "{}: {} needs [machine] acceleration_time_x_ms, acceleration_time_y_ms or "
                "position_gain_per_s: without inertia no corner is rounded off",
                Place(setup.source or "setup"),
                option("slowed"),
            ),
        )
    try:
        halts_of(program)
        unit = None
    except FormatError:
        unit = "s"
    header = (f"millcorr {__version__} slowed at corners, tool within {bound:g} mm of them in the model",)
    return slow_corners(program, control, bound, dwell_unit=unit, tolerance=tolerance, header=header)


@dataclass(frozen=True, eq=False, slots=True)
class ShiftedProgram:
    """A program whose contour is moved by the mean error of its walls over the heights, and what it is to leave.

    Parameters
    ----------
    data : bytes
    largest : float
        Largest move of the contour, mm.
    before, after : float
        Largest absolute error over all heights in mm: of the program as it came, and of the written one read back.
    """

    data: bytes
    largest: float
    before: float
    after: float


def shifted_program(request: pipeline.Request, simulation: Simulation, error: HeightError) -> ShiftedProgram:
    """Program whose contour is moved by the mean error of its walls over the heights.

    Parameters
    ----------
    request : Request
        The program, how to understand and how to write it.
    simulation : Simulation
        Of this program.
    error : HeightError

    Returns
    -------
    ShiftedProgram

    Raises
    ------
    MillcorrError
        As `mean_shift` and `pipeline.correct`.
    """
    nominal = simulation.nominal
    correction, _ = mean_shift(error, nominal, limit=request.settings.limit)
    made = on_nominal(error, nominal)[0] >= 0
    shifted = _moved(request, nominal, correction)
    setup = simulation.setup
    found = WallModel.of(path_as_run(shifted, setup), setup, simulation.stock, nominal).errors(error.heights)
    number, s = on_nominal(found, nominal, NEAR + correction.largest)
    rows = np.flatnonzero(number >= 0)
    left = found.value[rows] + correction.at(number[rows], s[rows], nominal)[:, None]
    before = float(np.nanmax(np.abs(error.value[made])))
    return ShiftedProgram(shifted.data, correction.largest, before, float(np.nanmax(np.abs(left))))


def _moved(request: pipeline.Request, nominal: Profile, correction: Correction) -> nc.Program:
    """The program with its contour moved by a correction known beforehand, read back."""
    asked = request.settings
    settings = Settings(
        side=asked.side,
        cutter_compensation=asked.cutter_compensation,
        tolerance=asked.tolerance,
        output_moves=asked.output_moves,
    )
    wanted = pipeline.Request(request.program, request.radius, None, nominal, settings, shift=correction)
    return nc.parse(pipeline.correct(wanted).text, request.program.name)


@dataclass(frozen=True, eq=False, slots=True)
class TiltedProgram:
    """A program whose walls are made by a leaning tool, and what it is predicted to leave.

    Parameters
    ----------
    data : bytes
    remedy : Remedy
        Of the program as it came.
    shift : (m,) float64
        How far the tip's path has been moved on each stretch of `remedy`, mm, positive out of the part.
    after : (m,) float64
        Largest absolute error over all heights of each stretch, mm, of the written program read back.
    lines : tuple of int
        Lines of the written program with words for the tilt, from 1.
    """

    data: bytes
    remedy: Remedy
    shift: Floats
    after: Floats
    lines: tuple[int, ...]


def tilted_program(
    request: pipeline.Request, simulation: Simulation, error: HeightError, remedy: Remedy
) -> TiltedProgram:
    """Program whose tool leans as the remedy of its wall says, its tip's path moved along.

    Parameters
    ----------
    request : Request
        The program, how to understand and how to write it.
    simulation : Simulation
        Of this program.
    error : HeightError
    remedy : Remedy
        Of this error.

    Returns
    -------
    TiltedProgram

    Raises
    ------
    RefusedError
        As `tilted` and `tip_shifts`.
    LimitError
        If the written program does not read back to what was meant.
    """
    setup, nominal, asked = simulation.setup, simulation.nominal, request.settings
    # Whether it can be done at all is asked before the path is moved.
    tilted(request.program, error, remedy, setup.tilt)
    shift = tip_shifts(error, remedy)
    correction, _ = even_shift(error, remedy, nominal, shift, limit=asked.limit)
    shifted = _moved(request, nominal, correction)
    near = NEAR + correction.largest
    model = WallModel.of(path_as_run(shifted, setup), setup, simulation.stock, nominal)
    found = remedies(model.errors(error.heights), nominal, near=near)
    if not np.array_equal(found.number, remedy.number):
        raise LimitError(
            phrase("{}: the moved path no longer makes the same walls: nothing is written", request.program.name)
        )
    # The tilt is the one that the tip was moved for.
    found = replace(found, lean=remedy.lean)
    data = tilted(shifted, model.errors(error.heights), found, setup.tilt)
    back = nc.parse(data, request.program.name)
    _same_path(back, shifted)
    step = found.step
    left = model.errors(
        error.heights,
        offset=np.where(step >= 0, (remedy.offset - shift)[step], 0.0),
        lean=np.where(step >= 0, remedy.lean[step], 0.0),
        about=remedy.about,
    ).value
    after = np.zeros(len(remedy.number))
    rows = np.flatnonzero((step >= 0) & np.isfinite(left).any(axis=1))
    np.maximum.at(after, step[rows], np.nanmax(np.abs(left[rows] + shift[step[rows], None]), axis=1))
    changed = [k + 1 for k in range(len(back)) if back.line(k) != shifted.line(k)]
    return TiltedProgram(data, remedy, shift, after, tuple(changed))


def _same_path(back: nc.Program, wanted: nc.Program) -> None:
    """LimitError where words for the tilt have changed what the moves read as."""
    a, b = back.toolpath, wanted.toolpath
    same = len(a) == len(b) and all(
        np.allclose(x, y, rtol=0.0, atol=ARITHMETIC, equal_nan=True)
        for x, y in ((a.start, b.start), (a.end, b.end), (a.feed, b.feed))
    )
    if not same:
        raise LimitError(
            phrase("{}: the tilted program does not read back as it was meant: nothing is written", back.name)
        )
