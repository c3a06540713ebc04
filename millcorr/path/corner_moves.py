# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners that the control makes, for the second reader: the ball that rolls into the corner, found by Newton's steps.

A move is a complex number that runs along its line or circle; where the path turns by an angle, the centre of the
rounding is as far to the inside of what comes as of what goes.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats

_STRAIGHT = 1e-9
_STEPS = 50
_CLOSE = 1e-13


@dataclass(frozen=True, slots=True)
class _Way:
    """A line or circle through a corner: where it is and where it goes, `u` mm behind the corner."""

    at: complex
    towards: complex
    bend: float
    reach: float

    def direction(self, u: float) -> complex:
        return self.towards * cmath.exp(1j * self.bend * u)

    def place(self, u: float) -> complex:
        if self.bend == 0:
            return self.at + self.towards * u
        return self.at + self.towards * (cmath.exp(1j * self.bend * u) - 1) / (1j * self.bend)


def way(start: complex, end: complex, centre: complex, sweep: float, corner: complex) -> _Way:
    """A move as a way through one of its ends."""
    if sweep == 0:
        length = abs(end - start)
        return _Way(corner, (end - start) / length if length else 0j, 0.0, length)
    arm = corner - centre
    sense = math.copysign(1.0, sweep)
    return _Way(corner, 1j * sense * arm / abs(arm), sense / abs(arm), abs(sweep) * abs(arm))


def broken(comes: _Way, goes: _Way, kind: str, size: float) -> tuple[complex, complex, complex, float] | None:
    """Begin, end, centre and sweep of the move in place of a corner; None where there is none, or none can be made.

    Parameters
    ----------
    comes, goes : _Way
        The moves before and behind the corner.
    kind : str
        "RND" a radius, "CHR" what is cut off each side, "CHF" the length of the chamfer.
    size : float
        mm.

    Returns
    -------
    tuple or None
        The centre is NaN and the sweep 0 of a chamfer.
    """
    nan = complex(math.nan, math.nan)
    turn = cmath.phase(goes.towards / comes.towards) if comes.towards and goes.towards else math.nan
    if size == 0 or abs(turn) < _STRAIGHT:
        return None
    if not size > 0 or math.isnan(turn) or abs(abs(turn) - math.pi) < _STRAIGHT:
        return None
    if kind != "RND":
        cut = size if kind == "CHR" else size / (2 * math.cos(turn / 2))
        if comes.bend or goes.bend or cut > min(comes.reach, goes.reach):
            return None
        return comes.place(-cut), goes.place(cut), nan, 0.0
    left = 1j * math.copysign(size, turn)
    u = v = size * math.tan(abs(turn) / 2)
    for _ in range(_STEPS):
        a, b = comes.direction(-u), goes.direction(v)
        gap = comes.place(-u) + left * a - goes.place(v) - left * b
        if abs(gap) < _CLOSE * max(size, 1.0):
            break
        # How the centre moves with the place it stands beside, on either way.
        columns = np.array([-a * (1 + left * 1j * comes.bend), -b * (1 + left * 1j * goes.bend)])
        try:
            du, dv = np.linalg.solve(np.array([columns.real, columns.imag]), [-gap.real, -gap.imag])
        except np.linalg.LinAlgError:
            return None
        u, v = u + float(du), v + float(dv)
    if not (abs(gap) < 1e-9 and -1e-9 <= u <= comes.reach + 1e-9 and -1e-9 <= v <= goes.reach + 1e-9):
        return None
    first, last = comes.place(-u), goes.place(v)
    swept = cmath.phase(goes.direction(v) / comes.direction(-u))
    swept += 2 * math.pi * (round((turn - swept) / (2 * math.pi)) if swept * turn < 0 else 0)
    return first, last, first + left * comes.direction(-u), swept


def complex_of(points: Floats) -> list[complex]:
    """Places in the plane as complex numbers."""
    return [complex(x, y) for x, y in points[:, :2].tolist()]
