# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs that are stated otherwise than by centre or radius: by a point on them, a tangent, an opening angle."""

from __future__ import annotations

import math

import numpy as np

from millcorr.arrays import Floats

_STRAIGHT = 1e-12
"""Sine below which three points lie on a line, or a tangent leads straight to the end."""

Arc = tuple[Floats, float]
"""Centre in the plane (2,) in mm, and signed sweep in rad."""


def point(start: Floats, inner: Floats, end: Floats) -> Arc | None:
    """Arc from start through a point to end (Siemens CIP); None where they lie on a line.

    Examples
    --------
    >>> centre, sweep = point(np.array([1.0, 0.0]), np.array([0.0, 1.0]), np.array([-1.0, 0.0]))
    >>> bool(abs(centre).max() < 1e-12), round(sweep, 6)
    (True, 3.141593)
    """
    u, v = inner - start, end - start
    cross = u[0] * v[1] - u[1] * v[0]
    if not abs(cross) > _STRAIGHT * math.hypot(*u) * math.hypot(*v):
        return None
    uu, vv = float(u @ u), float(v @ v)
    centre = start + np.array([v[1] * uu - u[1] * vv, u[0] * vv - v[0] * uu]) / (2 * cross)
    return centre, _sweep(start, end, centre, clockwise=bool(cross < 0))


def leaving(start: Floats, end: Floats, centre: Floats, sweep: float) -> Floats:
    """Direction in which a line (sweep 0) or an arc arrives at its end, (2,)."""
    if sweep == 0:
        return end - start
    arm = end - centre
    return np.array([-arm[1], arm[0]]) * math.copysign(1.0, sweep)


def tangent(start: Floats, out: Floats, end: Floats) -> Arc | None:
    """Arc that leaves its start in a direction (Siemens CT); None where it would be a line."""
    length = math.hypot(*out)
    if not length > 0:
        return None
    left = np.array([-out[1], out[0]]) / length
    chord = end - start
    aside = float(chord @ left)
    if not abs(aside) > _STRAIGHT * math.hypot(*chord):
        return None
    centre = start + left * float(chord @ chord) / (2 * aside)
    return centre, _sweep(start, end, centre, clockwise=aside < 0)


def opening(start: Floats, end: Floats, angle: float, clockwise: bool) -> Arc | None:
    """Arc with an opening angle in rad (Siemens AR=); None for one that is none."""
    chord = end - start
    length = math.hypot(*chord)
    if not (length > 0 and 0 < angle < 2 * math.pi):
        return None
    rise = 0.5 * length / math.tan(angle / 2)
    left = np.array([-chord[1], chord[0]]) / length
    centre = 0.5 * (start + end) + left * (-rise if clockwise else rise)
    return centre, -angle if clockwise else angle


def _sweep(start: Floats, end: Floats, centre: Floats, clockwise: bool) -> float:
    a, b = start - centre, end - centre
    angle = math.atan2(a[0] * b[1] - a[1] * b[0], float(a @ b))
    if clockwise:
        return angle if angle < 0 else angle - 2 * math.pi
    return angle if angle > 0 else angle + 2 * math.pi
