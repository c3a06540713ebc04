# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planar NURBS curves, in the form CAD systems exchange them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats, Ints
from millcorr.errors import InputError


@dataclass(frozen=True, eq=False, slots=True)
class NurbsCurve:
    """A NURBS curve in the plane, with distinct knots and multiplicities as in STEP and OCCT.

    Parameters
    ----------
    degree : int
        Degree of the basis functions, at least 1.
    poles : (n, 2) float64
        Control points in mm.
    weights : (n,) float64
        Positive weights.
    knots : (m,) float64
        Distinct knots, increasing.
    multiplicities : (m,) int64
        Multiplicity of each knot.
    periodic : bool
        A periodic curve has as many poles as the multiplicities without the last one add up to; another
        curve has ``degree + 1`` fewer than their sum.

    Raises
    ------
    InputError
        If the numbers contradict each other.
    """

    degree: int
    poles: Floats
    weights: Floats
    knots: Floats
    multiplicities: Ints
    periodic: bool = False

    def __post_init__(self) -> None:
        for name, dtype in (
            ("poles", np.float64),
            ("weights", np.float64),
            ("knots", np.float64),
            ("multiplicities", np.int64),
        ):
            array = np.array(getattr(self, name), dtype=dtype)
            array.flags.writeable = False
            object.__setattr__(self, name, array)
        if self.degree < 1:
            raise InputError(f"NURBS curve: degree {self.degree} is below 1")
        if self.poles.ndim != 2 or self.poles.shape[1] != 2:
            raise InputError(f"NURBS curve: poles must have shape (n, 2), not {self.poles.shape}")
        if self.weights.shape != (len(self.poles),) or not (self.weights > 0).all():
            raise InputError("NURBS curve: every pole needs one positive weight")
        if len(self.knots) != len(self.multiplicities) or not (np.diff(self.knots) > 0).all():
            raise InputError("NURBS curve: knots must increase and have one multiplicity each")
        total = int(self.multiplicities[:-1].sum()) if self.periodic else int(self.multiplicities.sum())
        wanted = len(self.poles) + (0 if self.periodic else self.degree + 1)
        if total != wanted:
            raise InputError(f"NURBS curve: multiplicities add up to {total}, expected {wanted}")
        if not (np.isfinite(self.poles).all() and np.isfinite(self.knots).all()):
            raise InputError("NURBS curve: a pole or knot is not a finite number")

    @staticmethod
    def line(start: ArrayLike, end: ArrayLike) -> NurbsCurve:
        """Straight line between two points in mm."""
        return NurbsCurve(1, np.array([start, end], dtype=float), np.ones(2), np.array([0.0, 1.0]), [2, 2])  # type: ignore[arg-type]

    @staticmethod
    def arc(start: ArrayLike, end: ArrayLike, centre: ArrayLike, sweep: float) -> NurbsCurve:
        """Circular arc.

        Parameters
        ----------
        start, end, centre : (2,)
            Points in mm; the radius is taken from `start`, and `end` is met exactly where it lies on the circle.
        sweep : float
            Signed angle in rad, positive anticlockwise, at most one turn.
        """
        begin, last, middle_point = (np.asarray(p, dtype=float) for p in (start, end, centre))
        pieces = max(1, int(np.ceil(abs(sweep) / (np.pi / 2) - 1e-9)))
        step = sweep / pieces
        angle = np.arctan2(begin[1] - middle_point[1], begin[0] - middle_point[0]) + step * np.arange(pieces + 1)
        radius = float(np.hypot(*(begin - middle_point)))
        on = middle_point + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        on[0] = begin
        if np.hypot(*(on[-1] - last)) < 1e-9 * max(1.0, radius):
            on[-1] = last
        middle = angle[:-1] + step / 2
        weight = float(np.cos(step / 2))
        off = middle_point + radius / weight * np.stack([np.cos(middle), np.sin(middle)], axis=1)
        poles = np.empty((2 * pieces + 1, 2))
        poles[0::2], poles[1::2] = on, off
        weights = np.ones(2 * pieces + 1)
        weights[1::2] = weight
        knots = np.arange(pieces + 1) / pieces
        mult = np.full(pieces + 1, 2)
        mult[[0, -1]] = 3
        return NurbsCurve(2, poles, weights, knots, mult)

    @property
    def flat_knots(self) -> Floats:
        """Knots with their multiplicity written out, extended round the seam where periodic."""
        flat = np.repeat(self.knots, self.multiplicities)
        if not self.periodic:
            return flat
        period = self.knots[-1] - self.knots[0]
        extra = self.degree + 1 - int(self.multiplicities[0])
        body = np.repeat(self.knots[:-1], self.multiplicities[:-1])
        turns = extra // len(body) + 2
        before = np.concatenate([body - k * period for k in range(turns, 0, -1)])[-extra:] if extra > 0 else body[:0]
        # The first of them is the last knot again, whatever rounding makes of it.
        after = np.concatenate([body + k * period for k in range(1, turns + 1)])[self.multiplicities[0] :]
        last = np.repeat(self.knots[-1:], self.multiplicities[-1:])
        return np.concatenate([before, body, last, after[:extra]])

    def bezier(self) -> tuple[Floats, Floats]:
        """Bezier pieces of the curve.

        Returns
        -------
        bounds : (m + 1,) float64
            Parameters where the pieces meet.
        points : (m, degree + 1, 3) float64
            Homogeneous control points (w x, w y, w) of each piece.
        """
        p = self.degree
        flat = self.flat_knots
        count = len(flat) - p - 1
        homogeneous = np.column_stack([self.poles * self.weights[:, None], self.weights])
        homogeneous = homogeneous[np.arange(count) % len(homogeneous)]
        inside = (flat[:-1] < flat[1:]) & (flat[:-1] >= self.knots[0]) & (flat[1:] <= self.knots[-1])
        spans = np.flatnonzero(inside)
        a, b = flat[spans], flat[spans + 1]
        points = np.empty((len(spans), p + 1, 3))
        offset = np.arange(-p, 1)
        for j in range(p + 1):
            d = homogeneous[spans[:, None] + offset]
            for r in range(1, p + 1):
                t = (b if r <= j else a)[:, None]
                i = spans[:, None] + np.arange(-p + r, 1)
                low, high = flat[i], flat[i + p + 1 - r]
                weight = ((t - low) / (high - low))[:, :, None]
                d = d[:, :-1] * (1 - weight) + d[:, 1:] * weight
            points[:, j] = d[:, 0]
        return np.append(a, b[-1]), points

    def evaluate(self, u: ArrayLike) -> Floats:
        """Points at parameters.

        Parameters
        ----------
        u : (k,)
            Parameters, clipped to the curve's range.

        Returns
        -------
        (k, 2) float64
            Points in mm.
        """
        bounds, points = self.bezier()
        at = np.clip(np.asarray(u, dtype=float), bounds[0], bounds[-1])
        span = np.clip(np.searchsorted(bounds, at, side="right") - 1, 0, len(points) - 1)
        t = ((at - bounds[span]) / (bounds[span + 1] - bounds[span]))[:, None, None]
        d = points[span]
        while d.shape[1] > 1:
            d = d[:, :-1] * (1 - t) + d[:, 1:] * t
        out: Floats = d[:, 0, :2] / d[:, 0, 2:]
        return out

    def reversed(self) -> NurbsCurve:
        """The same curve run through the other way."""
        poles, weights = self.poles[::-1], self.weights[::-1]
        if self.periodic:
            # Reversing renumbers the basis; the pole that was first must stay tied to the same knots.
            shift = 1 + self.degree - int(self.multiplicities[0])
            shift = shift % len(self.poles)
            poles, weights = np.roll(poles, shift, axis=0), np.roll(weights, shift)
        return NurbsCurve(
            self.degree,
            poles,
            weights,
            self.knots[0] + self.knots[-1] - self.knots[::-1],
            self.multiplicities[::-1],
            self.periodic,
        )

    def clamped(self) -> NurbsCurve:
        """The same curve not periodic, its ends interpolated, by knot insertion at the seam (Boehm)."""
        if not self.periodic:
            return self
        p = self.degree
        flat = self.flat_knots
        poles = np.column_stack([self.poles * self.weights[:, None], self.weights])
        poles = poles[np.arange(len(flat) - p - 1) % len(poles)]
        for end, side in ((self.knots[0], 1), (self.knots[-1], 0)):
            for _ in range(p - int((flat == end).sum())):
                # The span on the curve's side of the knot.
                k = int(np.searchsorted(flat, end, side="right" if side else "left")) - 1
                i = np.arange(k - p + 1, k + 1)
                share = ((end - flat[i]) / (flat[i + p] - flat[i]))[:, None]
                new = (1 - share) * poles[i - 1] + share * poles[i]
                poles = np.vstack([poles[: k - p + 1], new, poles[k:]])
                flat = np.insert(flat, k + 1, end)
        first = int(np.searchsorted(flat, self.knots[0], side="left"))
        inner = int(self.multiplicities[1:-1].sum()) if len(self.knots) > 2 else 0
        kept = poles[first - 1 : first + inner + p]
        mult = self.multiplicities.copy()
        mult[[0, -1]] = p + 1
        return NurbsCurve(p, kept[:, :2] / kept[:, 2:], kept[:, 2], self.knots, mult)

    def as_dict(self) -> dict[str, object]:
        """The curve as plain numbers for JSON."""
        return {
            "degree": self.degree,
            "poles": self.poles.tolist(),
            "weights": self.weights.tolist(),
            "knots": self.knots.tolist(),
            "multiplicities": self.multiplicities.tolist(),
            "periodic": self.periodic,
        }

    @staticmethod
    def from_dict(data: dict[str, object]) -> NurbsCurve:
        """Curve from the numbers that `as_dict` gives; InputError if they are incomplete."""
        try:
            return NurbsCurve(
                int(data["degree"]),  # type: ignore[call-overload]
                np.asarray(data["poles"], dtype=float),
                np.asarray(data["weights"], dtype=float),
                np.asarray(data["knots"], dtype=float),
                np.asarray(data["multiplicities"], dtype=np.int64),
                bool(data["periodic"]),
            )
        except (KeyError, TypeError, ValueError) as error:
            raise InputError(f"NURBS curve: {error}") from error
