# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wall of a simulated program over its height: its error, and what shift and tilt leave.

dat-2025, figs. 12 and 13.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.errors import InputError, RefusedError, UsageError
from millcorr.messages import message_of, mm, option, phrase
from millcorr.nc import Program
from millcorr.process.deflection.height_error import HeightError, WallModel
from millcorr.process.deflection.tilt import Remedy, remedies
from millcorr.process.prediction import Simulation
from millcorr.tolerances import ARITHMETIC

from .remedy_programs import path_as_run


@dataclass(frozen=True, eq=False, slots=True)
class Wall(ReadOnlyArrays):
    """The wall of a simulated program at some heights, one row a step of the path.

    Parameters
    ----------
    before : HeightError
        Of the program as it came.
    tilted : HeightError or None
        With the shift and the tilt of `remedy`; NaN too where no stretch of the nominal is made.
    remedy : Remedy or None
        None where none can be given; `note` says why.
    t : (n,) float64
        Time in s as in `RealPath`.
    line : (n,) int64
        Line of the program, from 1.
    note : str
    """

    before: HeightError
    tilted: HeightError | None
    remedy: Remedy | None
    t: Floats
    line: Ints
    note: str = ""

    @property
    def largest(self) -> tuple[float, ...]:
        """Largest absolute error in mm; where there is a remedy, of its stretches: as they are, shifted, and tilted."""
        if self.remedy is None:
            return (float(np.nanmax(np.abs(self.before.value))),)
        return tuple(self.remedy.worst.max(axis=0).tolist())

    @property
    def rows(self) -> Ints:
        """Steps that make a wall at one of the heights."""
        return np.flatnonzero(np.isfinite(self.before.value).any(axis=1))

    @property
    def stretch(self) -> Ints:
        """Number of the nominal's stretch that each step makes, from 1; 0 for none, or where there is no remedy."""
        out = np.zeros(len(self.t), dtype=np.int64)
        if self.remedy is not None:
            made = self.remedy.step >= 0
            out[made] = self.remedy.number[self.remedy.step[made]] + 1
        return out


def heights_of(values: Sequence[float]) -> Floats:
    """Heights to look at, in order and each once.

    Parameters
    ----------
    values : sequence of float
        mm above the tip of the deepest pass.

    Returns
    -------
    (k,) float64

    Raises
    ------
    UsageError
        If one is negative or no number.
    """
    for value in values:
        if not (math.isfinite(value) and value >= 0):
            raise UsageError(
                phrase("{}: heights count from the tool's tip upwards, in mm: give 0 or more", option("heights", value))
            )
    return np.unique(np.asarray(values, dtype=float))


def wall_of(program: Program, simulation: Simulation, heights: Floats) -> Wall:
    """Error of the wall at heights, its shift and its tilt.

    Parameters
    ----------
    program : Program
    simulation : Simulation
        Of this program: its setup, stock and nominal.
    heights : (k,) float64
        As `heights_of`.

    Returns
    -------
    Wall

    Raises
    ------
    UsageError
        If a height is above the cut; and as `WallModel.of`: the tool has no overhang.
    InputError
        As `WallModel.of`: the program makes no wall.
    RefusedError
        If the elastic loop does not settle.
    """
    setup = simulation.setup
    path = path_as_run(program, setup)
    model = WallModel.of(path, setup, simulation.stock, simulation.nominal)
    step = model.arcs.step
    top = float((model.arcs.high + model.tip[step])[np.isfinite(model.wall[step, 0])].max())
    for height in heights:
        if height > top + ARITHMETIC:
            raise UsageError(
                phrase(
                    "{}: {} cuts its wall up to {} above the tool's tip: give 0 to {:g}, or correct [stock] in {}",
                    option("heights", height),
                    program.name,
                    mm(top, "g"),
                    top,
                    setup.source or phrase("the setup"),
                ),
            )
    before = model.errors(heights)
    e = model.engagement
    t = path.begin[e.move] + e.t * (path.end - path.begin)[e.move]
    line = program.toolpath.line(path.move[e.move])
    if len(heights) < 2:
        return Wall(
            before,
            None,
            None,
            t,
            line,
            phrase("No remedy: a slope needs two heights at least, give {} again.", option("heights")),
        )
    try:
        remedy = remedies(before, simulation.nominal)
    except (InputError, RefusedError) as error:
        return Wall(before, None, None, t, line, phrase("No remedy: {}", message_of(error)))
    offset, lean = (np.where(remedy.step >= 0, v[remedy.step], 0.0) for v in (remedy.offset, remedy.lean))
    tilted = model.errors(heights, offset=offset, lean=lean, about=remedy.about)
    # Elsewhere the tool stands as before: that is no place of the contour, or cut away again.
    value = np.where((remedy.step >= 0)[:, None], tilted.value, np.nan)
    return Wall(before, replace(tilted, value=value), remedy, t, line)
