# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulated program does at every step: the signals of the virtual oscilloscope (petrakov-2023, figs. 5, 6)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.nc import Program

from .real_feed import course, times
from .simulated import Simulation

COLUMNS = (
    "s_mm", "t_s", "line", "x_mm", "y_mm", "z_mm", "x_actual_mm", "y_actual_mm", "feed_programmed_mm_min",
    "feed_mm_min", "feed_per_tooth_mm", "arc_deg", "area_mm2", "mrr_mm3_s", "force_n", "fx_n", "fy_n", "dx_mm",
    "dy_mm", "deflection_normal_mm",
)  # fmt: skip
"""Columns of signals.csv; later versions only append."""


@dataclass(frozen=True, eq=False, slots=True)
class Signals(ReadOnlyArrays):
    """Signals along the cutting moves of a program, one row a step.

    Parameters
    ----------
    s : (n,) float64
        Path length in mm, over cutting moves alone.
    t : (n,) float64
        Time in s: of the actual motion, or over cutting moves alone where the setup names no inertia.
    line : (n,) int64
        Line of the program, from 1.
    commanded : (n, 3) float64
        Cutter's tip as commanded, mm.
    actual : (n, 2) float64
        Where its centre really is, mm.
    programmed, feed : (n,) float64
        Feed in the program, and the real one, mm/s.
    feed_per_tooth : (n,) float64
        mm, at the real feed.
    arc : (n,) float64
        Engaged arc in rad.
    area : (n,) float64
        Undeformed area in mm^2.
    mrr : (n,) float64
        Removal rate in mm^3/s.
    force : (n, 2) float64
        Mean cutting force along X and Y in N.
    deflection : (n, 2) float64
        Along X and Y in mm.
    normal_deflection : (n,) float64
        Along the normal of the wall in mm, positive where it leaves material; NaN without a wall.
    """

    s: Floats
    t: Floats
    line: Ints
    commanded: Floats
    actual: Floats
    programmed: Floats
    feed: Floats
    feed_per_tooth: Floats
    arc: Floats
    area: Floats
    mrr: Floats
    force: Floats
    deflection: Floats
    normal_deflection: Floats

    def __len__(self) -> int:
        return len(self.s)

    @property
    def resultant(self) -> Floats:
        """Size of the mean force in N; (n,)."""
        out: Floats = np.hypot(*self.force.T)
        return out

    @staticmethod
    def of(simulation: Simulation, program: Program) -> Signals:
        """Signals of a simulated program.

        Parameters
        ----------
        simulation : Simulation
            Without an earlier program.
        program : Program
            The one that was simulated.
        """
        elastic, feed = simulation.elastic, simulation.feed
        e = elastic.engagement
        move = feed.move[e.move]
        place = feed.place(e.move, e.t)
        real = feed.toolpath.feed[e.move]
        if simulation.motion is None:
            step = np.diff(e.s, prepend=e.s[0])
            t = np.cumsum(step / real)
        else:
            real = np.interp(place, *course(program.toolpath, simulation.motion))
            t = times(program.toolpath, simulation.motion, place)
        return Signals(
            s=e.s.copy(),
            t=t,
            line=program.toolpath.line(move),
            commanded=np.column_stack([simulation.commanded, e.position[:, 2]]),
            actual=simulation.centre.copy(),
            programmed=program.toolpath.feed[move],
            feed=real.copy(),
            feed_per_tooth=e.feed_per_tooth.copy(),
            arc=e.phi.copy(),
            area=e.area.copy(),
            mrr=e.mrr.copy(),
            force=elastic.cutting.force.copy(),
            deflection=elastic.deflection.copy(),
            normal_deflection=elastic.normal_deflection.copy(),
        )

    def table(self) -> Floats:
        """All signals in the units of `COLUMNS`; (n, 20)."""
        return np.column_stack(
            [
                self.s, self.t, self.line, self.commanded, self.actual, 60 * self.programmed, 60 * self.feed,
                self.feed_per_tooth, np.degrees(self.arc), self.area, self.mrr, self.resultant, self.force,
                self.deflection, self.normal_deflection,
            ]
        )  # fmt: skip


def csv_lines(signals: Signals) -> Iterator[str]:
    """Lines of signals.csv, the header first; empty cells where there is no number."""
    yield ",".join(COLUMNS) + "\n"
    for row in signals.table().tolist():
        yield ",".join("" if value != value else f"{value:.9g}" for value in row) + "\n"
