# SPDX-License-Identifier: LGPL-2.1-or-later
"""A simulated program to be played: where the cutter is at any time, its signals, and the contours it leaves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.comparison.deviation import Deviation
from millcorr.process.prediction import Simulation
from millcorr.process.prediction.signals import Signals
from millcorr.report.length_unit import MM, LengthUnit
from millcorr.report.magnification import bound_of, checked, magnification_for

from .correction import Lines
from .probing import joined

COMMANDED, MACHINED, CORRECTED = 0x5A5A5AFF, 0xCC0000FF, 0x2E9A1CFF
"""Colours 0xRRGGBBAA of the path as commanded, and of the contours before and after the correction."""

MOST_STEPS = 4000
"""So many steps of a signal are drawn; of each group of neighbours the one with the largest value."""


@dataclass(frozen=True, eq=False, slots=True)
class Played:
    """A simulated program.

    Parameters
    ----------
    signals : Signals
    before : Simulation
        The program as it is.
    after : Simulation or None
        With the predicted error corrected.
    refused : str
        Why there is no `after`.
    """

    signals: Signals
    before: Simulation
    after: Simulation | None
    refused: str

    @property
    def begin(self) -> float:
        """Time of the first step, s."""
        return float(self.signals.t[0])

    @property
    def duration(self) -> float:
        """From the first step to the last, s."""
        return float(self.signals.t[-1] - self.signals.t[0])

    def row_at(self, time: float) -> int:
        """Step that is reached at a time from the first one, in s."""
        row = int(np.searchsorted(self.signals.t, self.begin + time, side="right")) - 1
        return int(np.clip(row, 0, len(self.signals) - 1))

    def cutter_at(self, time: float) -> tuple[float, float, float]:
        """Centre of the cutter's tip, bent as it is, at a time from the first step in s; mm."""
        t = self.begin + time
        x, y = (float(np.interp(t, self.signals.t, self.signals.actual[:, k])) for k in (0, 1))
        z = float(self.signals.commanded[self.row_at(time), 2])
        return x, y, z


@dataclass(frozen=True, eq=False, slots=True)
class Trace:
    """A signal over time.

    Parameters
    ----------
    name, unit : str
        In English.
    t, value : (m,) float64
        s from the first step.
    now : (n,) float64
        Value at every step.
    """

    name: str
    unit: str
    t: Floats
    value: Floats
    now: Floats


def traces(played: Played, unit: LengthUnit = MM) -> tuple[Trace, ...]:
    """Signals to draw: force, engaged arc, feed, deflection along the wall's normal.

    Parameters
    ----------
    played : Played
    unit : LengthUnit
        In which feed and deflection are given.

    Returns
    -------
    tuple of Trace
    """
    s = played.signals
    values = (
        ("force", "N", s.resultant),
        ("engaged arc", "\N{DEGREE SIGN}", np.degrees(s.arc)),
        ("feed", f"{unit.name}/min", 60.0 * s.feed / unit.mm),
        ("deflection", unit.fine, s.normal_deflection / unit.fine_mm),
    )
    t = s.t - s.t[0]
    out = []
    for name, of, value in values:
        rows = _largest(value, MOST_STEPS)
        out.append(Trace(name, of, t[rows], value[rows], value))
    return tuple(out)


def _largest(value: Floats, most: int) -> Ints:
    """Rows to draw: all, or of each group of neighbours the one with the largest absolute value."""
    n = len(value)
    if n <= most:
        return np.arange(n)
    group = np.arange(n) * most // n
    order = np.lexsort((-np.abs(np.nan_to_num(value)), group))
    rows: Ints = np.sort(order[np.flatnonzero(np.diff(group[order], prepend=-1))])
    return rows


def magnification(played: Played, wanted: float | None) -> float:
    """So many times larger errors are drawn: as wanted, or chosen by their size; no contour is turned inside out.

    Parameters
    ----------
    played : Played
    wanted : float or None

    Raises
    ------
    UsageError
        If what is wanted is not from 1 to 1000000.
    """
    nominal = played.before.nominal
    errors = [one.deviation for one in (played.before, played.after) if one is not None]
    bound = bound_of(nominal, [(d.contour, d.value) for d in errors])
    if wanted is not None:
        return min(checked(wanted), bound)
    return magnification_for(nominal, max(float(np.abs(d.value).max(initial=0.0)) for d in errors), bound)


def lines(played: Played, magnification: float) -> Lines:
    """Path as commanded, contour as machined, contour after the correction; errors magnified along the normal.

    Parameters
    ----------
    played : Played
    magnification : float
        As the function of this name gives it.

    Returns
    -------
    Lines
    """
    signals = played.signals
    pieces = [(rows, COMMANDED) for rows in _unbroken(signals.commanded)]
    for simulation, colour in ((played.before, MACHINED), (played.after, CORRECTED)):
        if simulation is not None:
            pieces += [(points, colour) for points in _contours(simulation.deviation, magnification)]
    return joined(pieces)


def _unbroken(points: Floats) -> list[Floats]:
    """Steps of a path, cut where it goes on elsewhere."""
    step = np.linalg.norm(np.diff(points, axis=0), axis=1)
    usual = float(np.median(step)) if len(step) else 0.0
    return [piece for piece in np.split(points, np.flatnonzero(step > 20 * usual + 1.0) + 1) if len(piece) > 1]


def _contours(d: Deviation, magnification: float) -> list[Floats]:
    out = []
    for k in np.unique(d.contour):
        rows = np.flatnonzero(d.contour == k)
        rows = rows[np.argsort(d.s[rows], kind="stable")]
        points = d.foot[rows] + magnification * d.value[rows, None] * d.normal[rows]
        out.append(np.column_stack([points, d.z[rows]]))
    return out
