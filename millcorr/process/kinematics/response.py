# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's exact answer to a commanded motion that is piecewise polynomial in time.

On a piece of duration h the command is ``x(s) = sum c_k s**k``, s from 0 to 1. A lag of time constant tau answers

    y(s) = exp(-z s) y(0) + sum c_k s**k psi_k(z s),   z = h / tau,   psi_k(w) = w int_0^1 exp(-w (1 - q)) q**k dq

where all psi lie between 0 and 1, so that nothing cancels. Since ``tau y' = x - y``, the integral of y is that of x
less tau y. A moving mean over the last T of a motion p is ``(P(t) - P(t - T)) / T`` with the integral P of p; two of
width b are ``(Q(t) - 2 Q(t - b) + Q(t - 2 b)) / b**2`` with the integral Q of P. So every position and speed is a
closed form at any time; no step of time is involved. Q grows with the square of the time: it is kept in the longest
floating-point numbers of the platform.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Floats, Ints
from millcorr.errors import InputError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind

from .control import AxisDynamics
from .schedule import Schedule

_CURVED = 5
"""Degree of the polynomials that stand for pieces of arcs and splines."""
ACCURACY = 1e-8
"""Largest distance in mm of such a polynomial from its curve."""
_DEEPEST = 40
_SERIES = 17
_FORGOTTEN = 1e-30
_SAMPLES = (1.0 - np.cos(np.pi * np.arange(_CURVED + 1) / _CURVED)) / 2
_CHECKS = (1.0 - np.cos(np.pi * (np.arange(_CURVED) + 0.5) / _CURVED)) / 2
_FROM_SAMPLES = np.linalg.inv(np.vander(_SAMPLES, increasing=True))
_AT_CHECKS = np.vander(_CHECKS, _CURVED + 1, increasing=True)


Longs = NDArray[np.longdouble]


@dataclass(frozen=True, eq=False, slots=True)
class _State:
    """Command and single lags of one axis at some times."""

    command: Floats
    speed: Floats
    integral: Floats
    lagged: tuple[Floats, ...]


class Response:
    """Commanded and actual motion during a run of scheduled moves; both stand still before and behind it.

    Parameters
    ----------
    plan : Schedule
    first, last : int
        Moves of the schedule, `last` not included.
    """

    def __init__(self, plan: Schedule, first: int, last: int) -> None:
        self.control = plan.control
        begin, duration, coefficients = _pieces(plan, first, last)
        joins = first + 1 + np.flatnonzero((plan.jump[first + 1 : last] != 0).any(axis=1))
        self.joins = plan.begin[joins]
        self.shift = np.concatenate([np.zeros((1, 3)), np.cumsum(plan.jump[joins], axis=0)])
        rest = self.control.memory + 1.0
        still = np.zeros((2, *coefficients.shape[1:]))
        still[0, 0], still[1, 0] = coefficients[0, 0], coefficients[-1].sum(axis=0)
        self.duration = np.concatenate([[rest], duration, [rest]])
        self.begin = np.concatenate([begin[:1] - rest, begin, begin[-1:] + duration[-1:]])
        # Near zero the sums lose least.
        self.origin = coefficients[0, 0].copy()
        self.coefficients = np.concatenate([still[:1], coefficients, still[1:]])
        self.coefficients[:, 0] -= self.origin
        orders = np.arange(1, self.coefficients.shape[1] + 1)
        area = (self.coefficients / orders[:, None]).sum(axis=1) * self.duration[:, None]
        self.integral = np.cumsum(area, axis=0) - area
        self.long = self._integrals() if any(len(axis.boxes) == 2 for axis in self.control.axes) else None
        self.lagged = [
            [self._states(k, constant) for _, constant in axis.lags] for k, axis in enumerate(self.control.axes)
        ]

    def _states(self, k: int, constant: float) -> Floats:
        """Answer of a single lag at the start of every piece: a linear recurrence, solved by doubling."""
        z = self.duration / constant
        c = self.coefficients[:, :, k]
        gain = np.exp(-z[:-1])
        state = (c[:-1] * _psi(z[:-1], c.shape[1] - 1).T).sum(axis=1)
        state[0] += c[0, 0] * gain[0]
        step = 1
        while step < len(state):
            state[step:] += gain[step:] * state[:-step]
            gain[step:] = gain[step:] * gain[:-step]
            step *= 2
            if not (gain[step:] > _FORGOTTEN).any():
                break
        return np.concatenate([c[:1, 0], state])

    def commanded(self, t: Floats) -> Floats:
        """Commanded positions (n, 3) in mm at times (n,) in s."""
        piece, s = self._locate(t)
        c = self.coefficients
        out = c[piece, -1]
        for order in range(c.shape[1] - 2, -1, -1):
            out = out * s[:, None] + c[piece, order]
        result: Floats = out + self.origin
        return self._rejoined(t, result)

    def commanded_speed(self, t: Floats) -> Floats:
        """Commanded speeds of the axes (n, 3) in mm/s."""
        piece, s = self._locate(t)
        return np.column_stack([self._speed(k, piece, s) for k in range(3)])

    def actual(self, t: Floats) -> tuple[Floats, Floats]:
        """Actual positions in mm and speeds of the axes in mm/s, (n, 3) each, at times (n,) in s."""
        position, speed = np.empty((len(t), 3)), np.empty((len(t), 3))
        now = self._locate(t)
        for k, axis in enumerate(self.control.axes):
            state = self._state(k, axis, *now)
            if not axis.boxes:
                position[:, k], speed[:, k] = _lagged(axis, state)
                continue
            if len(axis.boxes) == 2:
                width = axis.boxes[0]
                (q0, p0), (q1, p1), (q2, p2) = (self._twice(k, axis, t, j * width) for j in range(3))
                position[:, k] = (q0 - 2 * q1 + q2) / np.longdouble(width) ** 2
                speed[:, k] = (p0 - 2 * p1 + p2) / width**2
                continue
            before = self._state(k, axis, *self._locate(t - axis.box))
            mean = state.integral - before.integral
            for (weight, constant), a, b in zip(axis.lags, state.lagged, before.lagged, strict=True):
                mean = mean - weight * constant * (a - b)
            position[:, k] = mean / axis.box
            speed[:, k] = (_lagged(axis, state)[0] - _lagged(axis, before)[0]) / axis.box
        position += self.origin
        return self._rejoined(t, position), speed

    def _integrals(self) -> tuple[Longs, Longs, Longs]:
        """First and second integral of the command at the start of every piece, (p, 3), and these starts in s."""
        c, h = self.coefficients.astype(np.longdouble), self.duration.astype(np.longdouble)
        orders = np.arange(1, c.shape[1] + 1)[:, None]
        area = (c / orders).sum(axis=1) * h[:, None]
        first = np.cumsum(area, axis=0) - area
        area2 = (c / (orders * (orders + 1))).sum(axis=1) * h[:, None] ** 2 + first * h[:, None]
        # Starts to the digits of the integrals: those rounded to doubles would leave steps between the pieces.
        return first, np.cumsum(area2, axis=0) - area2, self.begin[0] + np.cumsum(h) - h

    def _twice(self, k: int, axis: AxisDynamics, t: Floats, before: float) -> tuple[Longs, Longs]:
        """Second and first integral of the position of axis k behind its lags, `before` s before the times."""
        assert self.long is not None
        first, second, begin = self.long
        piece, s = self._locate(t - before)
        since = t.astype(np.longdouble) - before - begin[piece]
        share = since / self.duration[piece]
        p, q, power = first[piece, k].copy(), second[piece, k] + first[piece, k] * since, since.copy()
        for order in range(self.coefficients.shape[1]):
            term = self.coefficients[piece, order, k] * power
            p += term / (order + 1)
            q += term * since / ((order + 1) * (order + 2))
            power *= share
        state = self._state(k, axis, piece, s)
        # Lags of weights that add up to 1: the integral of y is that of x less tau y.
        y = [(weight, constant, at) for (weight, constant), at in zip(axis.lags, state.lagged, strict=True)]
        q -= sum((weight * constant * (p - constant * at) for weight, constant, at in y), np.zeros_like(p))
        p -= sum((weight * constant * at for weight, constant, at in y), np.zeros_like(p))
        return q, p

    def _rejoined(self, t: Floats, position: Floats) -> Floats:
        """Positions with the ways of left-out moves added, which the pieces leave out."""
        if len(self.joins):
            position += self.shift[np.searchsorted(self.joins, t, side="right")]
        return position

    def _locate(self, t: Floats) -> tuple[Ints, Floats]:
        piece = np.clip(np.searchsorted(self.begin, t, side="right") - 1, 0, len(self.begin) - 1)
        s = np.clip((t - self.begin[piece]) / self.duration[piece], 0.0, 1.0)
        return piece, s

    def _speed(self, k: int, piece: Ints, s: Floats) -> Floats:
        c = self.coefficients[:, :, k]
        out = np.zeros(len(s))
        for order in range(c.shape[1] - 1, 0, -1):
            out = out * s + order * c[piece, order]
        result: Floats = out / self.duration[piece]
        return result

    def _state(self, k: int, axis: AxisDynamics, piece: Ints, s: Floats) -> _State:
        c = self.coefficients[piece, :, k]
        powers = np.empty_like(c)
        powers[:, 0] = 1.0
        for order in range(1, c.shape[1]):
            powers[:, order] = powers[:, order - 1] * s
        terms = c * powers
        orders = np.arange(1, c.shape[1] + 1)
        h = self.duration[piece]
        integral = self.integral[piece, k] + (terms / orders).sum(axis=1) * s * h
        lagged = []
        for number, (_, constant) in enumerate(axis.lags):
            w = h * s / constant
            own = (terms * _psi(w, c.shape[1] - 1).T).sum(axis=1)
            lagged.append(np.exp(-w) * self.lagged[k][number][piece] + own)
        return _State(terms.sum(axis=1), self._speed(k, piece, s), integral, tuple(lagged))


def _lagged(axis: AxisDynamics, state: _State) -> tuple[Floats, Floats]:
    """Position and speed behind the lags of an axis."""
    if not axis.lags:
        return state.command, state.speed
    position, speed = np.zeros(len(state.command)), np.zeros(len(state.command))
    for (weight, constant), y in zip(axis.lags, state.lagged, strict=True):
        position += weight * y
        speed += weight * (state.command - y) / constant
    return position, speed


def _psi(w: Floats, degree: int) -> Floats:
    """psi_0 to psi_degree, shape (degree + 1, n), of w >= 0.

    From ``psi_k = 1 - k / w psi_(k-1)``: upward where w is 1 or more, and downward, from the series of the last
    one, below, so that errors do not grow.
    """
    out = np.empty((degree + 1, len(w)))
    out[0] = -np.expm1(-w)
    small = w < 1.0
    v = np.where(small, 1.0, w)
    for k in range(1, degree + 1):
        out[k] = 1.0 - k / v * out[k - 1]
    if degree and small.any():
        v = w[small]
        term = v
        last = term / (degree + 1)
        for n in range(1, _SERIES):
            term = term * v / n
            last += term / (degree + 1 + n)
        low = last * np.exp(-v)
        out[degree, small] = low
        for k in range(degree, 1, -1):
            low = v / k * (1.0 - low)
            out[k - 1, small] = low
    return out


def _pieces(plan: Schedule, first: int, last: int) -> tuple[Floats, Floats, Floats]:
    """Start times, durations and coefficients (p, degree + 1, 3) of the pieces of moves, in order of time."""
    rows = np.arange(first, last)
    phase, speed = plan.phase[rows], plan.speed[rows]
    length = plan.moves.length[plan.row[rows]]
    number = np.repeat(rows, 4)
    begin = (plan.begin[rows][:, None] + np.cumsum(phase, axis=1) - phase).ravel()
    initial = np.column_stack([speed[:, 0], speed[:, 1], speed[:, 1], np.zeros(len(rows))])
    final = np.column_stack([speed[:, 1], speed[:, 1], speed[:, 2], np.zeros(len(rows))])
    way = (initial + final) / 2 * phase
    come = np.cumsum(way, axis=1) - way
    # What rounding leaves of a move is not lost.
    come[:, 3] = length
    h, v, slope = phase.ravel(), initial.ravel(), (final - initial).ravel()
    pieces = np.flatnonzero(h > 0)
    number, begin = number[pieces], begin[pieces]
    h, v, slope, come = h[pieces], v[pieces], slope[pieces], come.ravel()[pieces]
    # Shares of the move at the piece's start and their first and second powers of s.
    total = plan.moves.length[plan.row[number]]
    share = np.column_stack([come, v * h, slope * h / 2]) / total[:, None]
    # Left-out moves do not move the machine: their jumps are taken off here and added again to the answer.
    shift = np.cumsum(plan.jump[first:last], axis=0)[number - first] - plan.jump[first]
    move = plan.row[number]
    curved = (plan.moves.toolpath.kind[move] >= Kind.ARC) & (share[:, 1:] != 0).any(axis=1)
    straight = np.flatnonzero(~curved)
    path = plan.moves.toolpath
    line_start = np.where(
        (path.kind[move] >= Kind.ARC)[:, None], plan.moves.at(move, np.minimum(share[:, 0], 1.0)), path.start[move]
    )
    delta = np.where((path.kind[move] >= Kind.ARC)[:, None], 0.0, path.end[move] - path.start[move])
    line = np.zeros((len(move), 3, 3))
    line[:, 0] = line_start + delta * np.minimum(share[:, :1], 1.0)
    line[:, 1:] = share[:, 1:, None] * delta[:, None, :]
    line[:, 0] -= shift
    if not curved.any():
        return begin, h, line
    c_rows = np.flatnonzero(curved)
    part, low, high, bent = _divide(plan, move[c_rows], share[c_rows])
    bent[:, 0] -= shift[c_rows[part]]
    padded = np.zeros((len(straight), _CURVED + 1, 3))
    padded[:, :3] = line[straight]
    all_begin = np.concatenate([begin[straight], begin[c_rows[part]] + low * h[c_rows[part]]])
    all_h = np.concatenate([h[straight], (high - low) * h[c_rows[part]]])
    order = np.argsort(all_begin, kind="stable")
    return all_begin[order], all_h[order], np.concatenate([padded, bent])[order]


def _divide(plan: Schedule, move: Ints, share: Floats) -> tuple[Ints, Floats, Floats, Floats]:
    """Pieces of curves cut until each is a polynomial within `ACCURACY`: owner, bounds of s, coefficients."""
    part, low, high = np.arange(len(move)), np.zeros(len(move)), np.ones(len(move))
    done: list[tuple[Ints, Floats, Floats, Floats]] = []
    for _ in range(_DEEPEST):
        at = np.concatenate([_SAMPLES, _CHECKS])
        s = low[:, None] + (high - low)[:, None] * at
        f = share[part, :1] + s * (share[part, 1:2] + s * share[part, 2:])
        places = plan.moves.at(np.repeat(move[part], len(at)), np.clip(f, 0.0, 1.0).ravel())
        places = places.reshape(len(part), len(at), 3)
        inner = places[:, : _CURVED + 1] - places[:, :1]
        c = np.einsum("ij,pjk->pik", _FROM_SAMPLES, inner)
        c[:, 0] = places[:, 0]
        off = np.einsum("ij,pjk->pik", _AT_CHECKS, c) - places[:, _CURVED + 1 :]
        good = np.abs(off).max(axis=(1, 2)) <= ACCURACY
        done.append((part[good], low[good], high[good], c[good]))
        part, low, high = part[~good], low[~good], high[~good]
        if not len(part):
            break
        middle = (low + high) / 2
        part = np.concatenate([part, part])
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    else:
        line = plan.moves.toolpath.line(move[part[0]])
        raise InputError(
            phrase("line {}: this curve bends too sharply to be followed; write it as lines or arcs", line)
        )
    columns = [np.concatenate(c) for c in zip(*done, strict=True)]
    return columns[0], columns[1], columns[2], columns[3]
