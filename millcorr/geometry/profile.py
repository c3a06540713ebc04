# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nominal profile: contours made of NURBS curves, with arc length, normals and curvature.

Direction and sign: a contour runs with the material on its left, so its normal, the tangent turned right by
90 degrees, points out of the material.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import comb
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from millcorr import progress
from millcorr.arrays import Floats, Ints, ReadOnlyArrays
from millcorr.errors import FormatError, InputError
from millcorr.messages import mm, phrase, xy
from millcorr.tolerances import EXACT

from .nurbs import NurbsCurve

CORNER_ANGLE = np.radians(10.0)
"""Joints that turn more are corners: filters stop there. Joints that turn less (facets of a dense program,
arcs rounded to the program's decimals) belong to one stretch."""

SMOOTH_ANGLE = 1e-6
"""Joints that turn less than this, in rad, count as tangent continuous."""

GAP = 2e-3
"""Largest gap in mm between the end of one curve and the start of the next that still counts as joined."""

_ARC_ORDER = 16


@dataclass(frozen=True, slots=True)
class Step:
    """Where in height a contour is the part's: a step of a wall that is cut in steps, or a wall below a rebate.

    Parameters
    ----------
    wall : int
        Number of the wall that it is a step of. Steps of one wall are so near to each other that only its height tells
        which of them a point lies on.
    bottom, top : float
        Heights in mm between which the part has this contour: from the lowest of its passes to that of the pass above,
        which takes it away; infinite where there is none.
    """

    wall: int
    bottom: float
    top: float


@dataclass(frozen=True, eq=False, slots=True)
class Contour:
    """One connected row of curves, each starting where the one before ends.

    Parameters
    ----------
    curves : tuple of NurbsCurve
        In order, run with the material on the left.
    closed : bool
        True where the last curve ends at the start of the first.
    step : Step, optional
        Where the part has another contour at other heights; by default this one is its at all heights.
    """

    curves: tuple[NurbsCurve, ...]
    closed: bool
    step: Step | None = None

    def reversed(self) -> Contour:
        """The same contour run the other way, that is with the material on the other side."""
        return replace(self, curves=tuple(c.reversed() for c in reversed(self.curves)))


@dataclass(frozen=True, slots=True)
class Stretch:
    """A part of a contour without corners.

    Parameters
    ----------
    contour : int
    begin : float
        Arc length in mm of its start, from the contour's start.
    length : float
        mm; it may run past the contour's seam.
    closed : bool
        True where the stretch is a whole closed contour without any corner.
    """

    contour: int
    begin: float
    length: float
    closed: bool


@dataclass(frozen=True, eq=False, slots=True)
class Sections:
    """The cross-sections of a part: which contours it has at a height.

    Parameters
    ----------
    bounds : (k,) float64
        Heights in mm where one section ends and the next begins.
    contours : tuple of k + 1 (m,) int64
        Contours of every section, from the lowest up.
    """

    bounds: Floats
    contours: tuple[Ints, ...]

    @staticmethod
    def of(contours: Sequence[Contour]) -> Sections:
        """Sections of a part with these contours."""
        always = [k for k, contour in enumerate(contours) if contour.step is None]
        walls: dict[int, list[tuple[Step, int]]] = {}
        for k, contour in enumerate(contours):
            if contour.step is not None:
                walls.setdefault(contour.step.wall, []).append((contour.step, k))
        # Below its lowest step a wall goes on as that one, and above its highest where none of another wall begins.
        rows = [sorted(steps, key=lambda row: row[0].bottom) for steps in walls.values()]
        begins = {step.bottom for steps in rows for step, _ in steps}
        ends = [step.bottom for steps in rows for step, _ in steps[1:]]
        ends += [steps[-1][0].top for steps in rows if steps[-1][0].top in begins]
        bounds = np.unique(ends)
        chosen = []
        for low in [-np.inf, *bounds]:
            reached = [([row for row in steps if row[0].bottom <= low] or steps[:1])[-1] for steps in rows]
            there = [k for step, k in reached if low < step.top or step.top not in begins]
            chosen.append(np.array(sorted([*always, *there]), dtype=np.int64))
        return Sections(bounds, tuple(chosen))

    def at(self, z: Floats) -> Ints:
        """Number of the section at each height in mm, (n,); -1 where the height is not known."""
        out = np.searchsorted(self.bounds, z + EXACT, side="right")
        return np.where(np.isnan(z), -1, out)

    def split(self, points: Floats) -> list[tuple[int, Ints]]:
        """Sections that points lie in, each with the rows of its points; -1 for points without a height.

        Parameters
        ----------
        points : (n, 2) or (n, 3) float64
            mm.
        """
        if points.shape[1] < 3:
            return [(-1, np.arange(len(points)))]
        number = self.at(points[:, 2])
        return [(int(k), np.flatnonzero(number == k)) for k in np.unique(number)]


@dataclass(frozen=True, eq=False, slots=True, weakref_slot=True)
class Profile(ReadOnlyArrays):
    """One or more contours in the XY plane of the work frame, cut into spans for computation.

    Make one with `Profile.from_contours`. A span is a rational polynomial of a local parameter t in 0..1.

    Attributes
    ----------
    contours : tuple of Contour
        The curves as given.
    coefficient : (p + 1, 3, m) float64
        Power-basis coefficients of (w x, w y, w), lowest power first.
    polynomial : bool
        True where every weight is 1.
    contour, curve, stretch : (m,) int64
        Contour of each span; index of the curve in its contour; smooth stretch (numbered through all contours).
    bounds : (m, 2) float64
        Parameters of the curve at the span's ends.
    begin, length : (m,) float64
        Arc length in mm at the span's start, counted from the contour's start, and the span's own.
    arc : (m, 18) float64
        Chebyshev coefficients of the arc length over the local parameter.
    turn : (m,) float64
        Angle in rad by which the tangent turns at the span's end, positive to the left; NaN at an open end.
    first : (k + 1,) int64
        First span of each contour, and m.
    """

    contours: tuple[Contour, ...]
    coefficient: Floats
    polynomial: bool
    contour: Ints
    curve: Ints
    stretch: Ints
    bounds: Floats
    begin: Floats
    length: Floats
    arc: Floats
    turn: Floats
    first: Ints

    @staticmethod
    def from_contours(contours: Iterable[Contour]) -> Profile:
        """Profile of the given contours.

        Raises
        ------
        InputError
            If there is no contour, a contour has no length, or two curves that should meet are apart.
        """
        contours = tuple(contours)
        if not contours:
            raise InputError(phrase("the profile has no contour"))
        power_of: list[Floats] = []
        owner_of: list[Ints] = []
        bounds_of: list[Floats] = []
        degree = max((c.degree for contour in contours for c in contour.curves), default=1)
        for k, contour in enumerate(contours):
            for j, nurbs in enumerate(contour.curves):
                knots, bezier = nurbs.bezier()
                poles = bezier[:, :, :2] / bezier[:, :, 2:]
                long = np.ptp(poles, axis=1).max(axis=1) > 1e-9
                power_of.append(_raise_degree(_power_basis(bezier[long]), degree))
                owner_of.append(np.tile(np.array([k, j], dtype=np.int64), (int(long.sum()), 1)))
                bounds_of.append(np.stack([knots[:-1], knots[1:]], axis=1)[long])
        if not any(map(len, power_of)):
            raise InputError(phrase("the profile has no length"))
        power, owner, bounds = np.concatenate(power_of), np.concatenate(owner_of), np.concatenate(bounds_of)
        power, owner, bounds, arc = _split_until_arc_length_is_exact(power, owner, bounds)
        standing = _speed(power, np.array([0.0, 1.0])).min(axis=1) < 1e-9 * _chebyshev_sum(arc, np.ones(len(arc)))
        if standing.any():
            x, y = power[np.argmax(standing), 0, :2] / power[np.argmax(standing), 0, 2]
            raise InputError(
                phrase("the profile has a cusp or a point where its parametrisation stands still near {}", xy(x, y))
            )
        contour_of = owner[:, 0]
        first = np.searchsorted(contour_of, np.arange(len(contours) + 1))
        if (np.diff(first) == 0).any():
            raise InputError(
                phrase("contour {} of the profile has no length", int(np.flatnonzero(np.diff(first) == 0)[0]))
            )
        length = _chebyshev_sum(arc, np.ones(len(arc)))
        begin = np.concatenate(
            [np.cumsum(length[a:b]) - length[a:b] for a, b in zip(first[:-1], first[1:], strict=True)]
        )
        turn = _turns(power, contours, first)
        stretch = np.zeros(len(power), dtype=np.int64)
        count = 0
        for k, (a, b) in enumerate(zip(first[:-1], first[1:], strict=True)):
            corner = np.abs(turn[a:b]) > CORNER_ANGLE
            local = np.concatenate([[0], np.cumsum(corner[:-1])])
            if contours[k].closed and not corner[-1] and local[-1] > 0:
                local[local == local[-1]] = 0
            stretch[a:b] = count + local
            count += int(local.max()) + 1
        return Profile(
            contours,
            np.ascontiguousarray(power.transpose(1, 2, 0)),
            bool(np.all(power[:, 0, 2] == 1) and not power[:, 1:, 2].any()),
            contour_of,
            owner[:, 1],
            stretch,
            bounds,
            begin,
            length,
            arc,
            turn,
            first,
        )

    @property
    def spans(self) -> int:
        """Number of spans."""
        return len(self.length)

    @property
    def total(self) -> Floats:
        """Length of each contour in mm, shape (k,)."""
        last = self.first[1:] - 1
        return self.begin[last] + self.length[last]

    def stretches(self) -> list[Stretch]:
        """Smooth stretches by their number."""
        out = []
        order = np.argsort(self.stretch, kind="stable")
        number = self.stretch[order]
        for spans in np.split(order, np.flatnonzero(np.diff(number)) + 1):
            k = int(self.contour[spans[0]])
            turn = self.turn[self.neighbour(spans, -1)]
            after_corner = np.isnan(turn) | (np.abs(turn) > CORNER_ANGLE)
            start = int(spans[np.argmax(after_corner)])
            whole = len(spans) == int(self.first[k + 1] - self.first[k])
            closed = whole and self.contours[k].closed and not after_corner.any()
            length = float(self.length[spans].sum())
            out.append(Stretch(k, float(self.begin[start]) % float(self.total[k]), length, closed))
        return out

    @property
    def sections(self) -> Sections:
        """Which of the contours the part has at a height."""
        return Sections.of(self.contours)

    @property
    def steps(self) -> tuple[tuple[int, ...], ...]:
        """Contours that are steps of one wall, from the lowest up; one row a wall."""
        walls: dict[int, list[int]] = {}
        for k, contour in enumerate(self.contours):
            if contour.step is not None:
                walls.setdefault(contour.step.wall, []).append(k)
        return tuple(tuple(sorted(row, key=lambda k: self._step(k).bottom)) for row in walls.values())

    def _step(self, contour: int) -> Step:
        step = self.contours[contour].step
        assert step is not None
        return step

    def heights(self, contour: Ints) -> tuple[Floats, Floats]:
        """Heights in mm between which the part has each of some contours, (n,) each; infinite where it always does."""
        steps = [contour.step for contour in self.contours]
        bottom = np.array([-np.inf if step is None else step.bottom for step in steps])
        top = np.array([np.inf if step is None else step.top for step in steps])
        return bottom[contour], top[contour]

    def part(self, contours: Ints) -> Profile:
        """Some of the contours, in their order, as they are here."""
        spans = np.flatnonzero(np.isin(self.contour, contours))
        _, number = np.unique(self.contour[spans], return_inverse=True)
        _, stretch = np.unique(self.stretch[spans], return_inverse=True)
        return Profile(
            tuple(self.contours[k] for k in np.unique(contours)),
            np.ascontiguousarray(self.coefficient[:, :, spans]),
            self.polynomial,
            number.astype(np.int64),
            self.curve[spans],
            stretch.astype(np.int64),
            self.bounds[spans],
            self.begin[spans],
            self.length[spans],
            self.arc[spans],
            self.turn[spans],
            np.searchsorted(number, np.arange(int(number[-1]) + 2)),
        )

    def reversed(self) -> Profile:
        """The same contours with the material on the other side."""
        return Profile.from_contours(c.reversed() for c in self.contours)

    def signed_areas(self) -> Floats:
        """Area enclosed by each contour in mm2, positive where it runs anticlockwise; shape (k,)."""
        out = np.zeros(len(self.contours))
        nodes, weights = np.polynomial.legendre.leggauss(16)
        span = np.repeat(np.arange(self.spans), 16)
        t = np.tile((nodes + 1) / 2, self.spans)
        c, d1, _ = self.evaluate(span, t)
        piece = (c[:, 0] * d1[:, 1] - c[:, 1] * d1[:, 0]).reshape(-1, 16) @ (weights / 4)
        np.add.at(out, self.contour, piece)
        for k, contour in enumerate(self.contours):
            if not contour.closed:
                a, b = self.ends(k)
                out[k] += (b[0] * a[1] - b[1] * a[0]) / 2
        return out

    def ends(self, contour: int) -> tuple[Floats, Floats]:
        """First and last point of a contour, each (2,) in mm."""
        a, b = int(self.first[contour]), int(self.first[contour + 1]) - 1
        c, _, _ = self.evaluate(np.array([a, b]), np.array([0.0, 1.0]))
        return c[0], c[1]

    def evaluate(self, span: Ints, t: Floats) -> tuple[Floats, Floats, Floats]:
        """Point and first two derivatives over the local parameter.

        Parameters
        ----------
        span : (n,) int64
        t : (n,) float64
            Local parameters; outside 0..1 the span is continued by its own polynomial.

        Returns
        -------
        c, d1, d2 : (n, 2) float64 each
            mm, and mm per unit of the local parameter.
        """
        x, y, dx, dy, ddx, ddy = self._derivatives(span, t)
        return np.stack([x, y], 1), np.stack([dx, dy], 1), np.stack([ddx, ddy], 1)

    def _derivatives(self, span: Ints, t: Floats) -> tuple[Floats, ...]:
        progress.step()
        coefficient = self.coefficient
        p = len(coefficient) - 1
        axes = 2 if self.polynomial else 3
        values = []
        for axis in range(axes):
            # Horner's rule for the value and two derivatives, without the steps that only handle zeros.
            f = coefficient[p, axis].take(span)
            d = f.copy() if p > 0 else np.zeros_like(f)
            f *= t
            f += coefficient[p - 1, axis].take(span)
            dd = d.copy() if p > 1 else np.zeros_like(f)
            for k in range(p - 2, -1, -1):
                if k < p - 2:
                    dd *= t
                    dd += d
                d *= t
                d += f
                f *= t
                f += coefficient[k, axis].take(span)
            dd *= 2.0
            values.append((f, d, dd))
        if self.polynomial:
            (x, dx, ddx), (y, dy, ddy) = values
            return x, y, dx, dy, ddx, ddy
        (ax, adx, addx), (ay, ady, addy), (w, dw, ddw) = values
        x, y = ax / w, ay / w
        dx, dy = (adx - dw * x) / w, (ady - dw * y) / w
        ddx, ddy = (addx - 2 * dw * dx - ddw * x) / w, (addy - 2 * dw * dy - ddw * y) / w
        return x, y, dx, dy, ddx, ddy

    def normals(self, span: Ints, t: Floats) -> Floats:
        """Directional cosines (cos alpha, cos beta) of the outward normal; shape (n, 2)."""
        _, _, dx, dy, _, _ = self._derivatives(span, t)
        speed = np.hypot(dx, dy)
        return np.stack([dy / speed, -dx / speed], axis=1)

    def curvature(self, span: Ints, t: Floats) -> Floats:
        """Signed curvature in 1/mm, positive where the contour turns left (bulges out); shape (n,)."""
        _, _, dx, dy, ddx, ddy = self._derivatives(span, t)
        out: Floats = (dx * ddy - dy * ddx) / np.hypot(dx, dy) ** 3
        return out

    def arc_length(self, span: Ints, t: Floats) -> Floats:
        """Arc length in mm from the contour's start; outside 0..1 it goes on at the end's speed."""
        inside = np.clip(t, 0.0, 1.0)
        s = self.begin[span]
        # In blocks, for the series of a million points would fill the memory.
        for a in range(0, len(s), 8192):
            s[a : a + 8192] += _chebyshev_sum(self.arc[span[a : a + 8192]], inside[a : a + 8192])
        out = t - inside
        beyond = np.flatnonzero(out)
        if len(beyond):
            _, d1, _ = self.evaluate(span[beyond], inside[beyond])
            s[beyond] += out[beyond] * np.hypot(*d1.T)
        return s

    def locate(self, contour: ArrayLike, s: ArrayLike) -> tuple[Ints, Floats]:
        """Spans and local parameters at arc lengths.

        Parameters
        ----------
        contour : int or (n,) int
        s : (n,) float64
            mm from the contour's start; taken round a closed contour, clipped at the ends of an open one.

        Returns
        -------
        span : (n,) int64
        t : (n,) float64
        """
        s = np.atleast_1d(np.asarray(s, dtype=float))
        contours = np.broadcast_to(np.asarray(contour, dtype=np.int64), s.shape)
        span = np.empty(s.shape, dtype=np.int64)
        t = np.empty(s.shape)
        total = self.total
        for k in np.unique(contours):
            rows = np.flatnonzero(contours == k)
            here = np.mod(s[rows], total[k]) if self.contours[k].closed else np.clip(s[rows], 0.0, total[k])
            a, b = int(self.first[k]), int(self.first[k + 1])
            span[rows] = a + np.clip(np.searchsorted(self.begin[a:b], here, side="right") - 1, 0, b - a - 1)
            t[rows] = self.parameter(span[rows], here - self.begin[span[rows]])
        return span, t

    def parameter(self, span: Ints, distance: Floats) -> Floats:
        """Local parameters at arc lengths from each span's start, clipped to 0..1; (n,)."""
        t = np.clip(distance / self.length[span], 0.0, 1.0)
        for _ in range(20):
            error = _chebyshev_sum(self.arc[span], t) - distance
            _, _, dx, dy, _, _ = self._derivatives(span, t)
            new = np.clip(t - error / np.hypot(dx, dy), 0.0, 1.0)
            if np.abs(new - t).max(initial=0.0) < 1e-14:
                return new
            t = new
        return t

    def at(self, contour: ArrayLike, s: ArrayLike) -> tuple[Floats, Floats]:
        """Points and outward normals at arc lengths; each (n, 2), mm."""
        span, t = self.locate(contour, s)
        c, _, _ = self.evaluate(span, t)
        return c, self.normals(span, t)

    def neighbour(self, span: Ints, step: int | Ints) -> Ints:
        """Span after (`step` 1) or before (-1) each span of its contour; the span itself at an open end."""
        k = self.contour[span]
        low, high = self.first[k], self.first[k + 1]
        moved = span + step
        closed = np.array([c.closed for c in self.contours])[k]
        wrapped = low + np.mod(moved - low, high - low)
        out: Ints = np.where(closed, wrapped, np.clip(moved, low, high - 1))
        return out

    def samples(self, spacing: float) -> tuple[Ints, Floats]:
        """Spans and local parameters of points along the whole profile, ends of spans included.

        Parameters
        ----------
        spacing : float
            Largest step in mm (by mean speed of each span).
        """
        count = np.maximum(1, np.ceil(self.length / spacing).astype(np.int64))
        count = np.maximum(count, 4 if len(self.coefficient) > 2 else 1)
        span = np.repeat(np.arange(self.spans), count + 1)
        offset = np.arange(len(span)) - np.repeat(np.cumsum(count + 1) - (count + 1), count + 1)
        return span, offset / count[span]

    def bounding_box(self) -> tuple[float, float, float, float]:
        """Left, bottom, right, top in mm of the sampled profile (exact to a few micrometres)."""
        span, t = self.samples(max(float(self.total.sum()) / 2000, 1e-3))
        c, _, _ = self.evaluate(span, t)
        return float(c[:, 0].min()), float(c[:, 1].min()), float(c[:, 0].max()), float(c[:, 1].max())

    def as_dict(self) -> dict[str, Any]:
        """The profile as plain numbers for JSON (millimetres, material on the left)."""
        return {
            "unit": "mm",
            "material": "left",
            "contours": [
                {"closed": c.closed, "curves": [n.as_dict() for n in c.curves]} | _step_as_dict(c.step)
                for c in self.contours
            ],
        }

    @staticmethod
    def from_dict(data: dict[str, Any]) -> Profile:
        """Profile from the numbers that `as_dict` gives.

        Raises
        ------
        InputError
            If something is missing or contradicts itself.
        """
        try:
            if data.get("unit", "mm") != "mm" or data.get("material", "left") != "left":
                raise InputError(phrase("profile: unit must be mm and material left"))
            return Profile.from_contours(
                Contour(
                    tuple(NurbsCurve.from_dict(n) for n in c["curves"]), bool(c["closed"]), _step_from(c.get("step"))
                )
                for c in data["contours"]
            )
        except (KeyError, TypeError, AttributeError) as error:
            raise InputError(phrase("profile: {!r} is missing or of the wrong kind", error)) from error

    @staticmethod
    def read_json(path: str | Path) -> Profile:
        """Profile from a `profile.json`; FormatError if it is none."""
        try:
            return Profile.from_dict(json.loads(Path(path).read_text(encoding="utf-8")))
        except OSError as error:
            raise FormatError(error.strerror or str(error), path) from error
        except (ValueError, UnicodeDecodeError) as error:
            raise FormatError(phrase("not a millcorr profile: {}", error), path) from error


def _step_as_dict(step: Step | None) -> dict[str, Any]:
    """JSON has no infinity: a step without an end has none there."""
    if step is None:
        return {}
    ends = {"bottom": step.bottom, "top": step.top}
    return {"step": {"wall": step.wall} | {name: z for name, z in ends.items() if np.isfinite(z)}}


def _step_from(data: dict[str, Any] | None) -> Step | None:
    if data is None:
        return None
    return Step(int(data["wall"]), float(data.get("bottom", -np.inf)), float(data.get("top", np.inf)))


def join(curves: Sequence[NurbsCurve], closed: bool | None = None) -> Contour:
    """Contour of curves that already follow each other; closed where the ends meet unless stated."""
    if closed is None:
        a = curves[0].evaluate([curves[0].knots[0]])[0]
        b = curves[-1].evaluate([curves[-1].knots[-1]])[0]
        closed = bool(np.hypot(*(a - b)) <= GAP)
    return Contour(tuple(curves), closed)


def _power_basis(bezier: Floats) -> Floats:
    """Power-basis coefficients (m, p + 1, 3) of Bezier control points of the same shape."""
    p = bezier.shape[1] - 1
    matrix = np.zeros((p + 1, p + 1))
    for k in range(p + 1):
        for i in range(k + 1):
            matrix[k, i] = comb(p, k) * comb(k, i) * (-1) ** (k - i)
    out: Floats = np.einsum("ki,mid->mkd", matrix, bezier)
    return out


def _raise_degree(power: Floats, degree: int) -> Floats:
    missing = degree + 1 - power.shape[1]
    return np.pad(power, ((0, 0), (0, missing), (0, 0))) if missing else power


def _halves(power: Floats) -> tuple[Floats, Floats]:
    """Coefficients of the first and second half of each span."""
    p = power.shape[1] - 1
    first = power * (0.5 ** np.arange(p + 1))[None, :, None]
    shift = np.zeros((p + 1, p + 1))
    for k in range(p + 1):
        for i in range(k, p + 1):
            shift[k, i] = comb(i, k)
    return first, np.einsum("ki,mid->mkd", shift, first)


def _speed(power: Floats, t: Floats) -> Floats:
    """Speed |C'(t)| in mm per unit of the local parameter, shape (m, k)."""
    p = power.shape[1] - 1
    values = np.einsum("mid,ki->mkd", power, t[:, None] ** np.arange(p + 1))
    slope = t[:, None] ** np.maximum(np.arange(p + 1) - 1, 0) * np.arange(p + 1)
    derivative = np.einsum("mid,ki->mkd", power, slope)
    w = values[:, :, 2]
    dx = (derivative[:, :, 0] - derivative[:, :, 2] * values[:, :, 0] / w) / w
    dy = (derivative[:, :, 1] - derivative[:, :, 2] * values[:, :, 1] / w) / w
    speed: Floats = np.hypot(dx, dy)
    return speed


def _arc_coefficients(power: Floats) -> Floats:
    """Chebyshev coefficients in 2 t - 1 of the arc length from the span's start, shape (m, order + 2)."""
    n = _ARC_ORDER + 1
    node = np.cos(np.pi * (np.arange(n) + 0.5) / n)
    speed = _speed(power, (node + 1) / 2)
    transform = np.cos(np.pi * np.outer(np.arange(n), np.arange(n) + 0.5) / n) * (2 / n)
    transform[0] /= 2
    c = speed @ transform.T
    padded = np.pad(c, ((0, 0), (0, 2)))
    out = np.zeros((len(power), n + 1))
    out[:, 1] = c[:, 0] - padded[:, 2] / 2
    k = np.arange(2, n + 1)
    out[:, 2:] = (padded[:, k - 1] - padded[:, k + 1]) / (2 * k)
    out /= 2
    out[:, 0] = -(out[:, 1:] * (-1.0) ** np.arange(1, n + 1)).sum(axis=1)
    return out


def _chebyshev_sum(coefficient: Floats, t: Floats) -> Floats:
    """Clenshaw sum of each row's Chebyshev series at 2 t - 1."""
    x2 = 2 * (2 * t - 1)
    b1 = np.zeros_like(t)
    b2 = np.zeros_like(t)
    for k in range(coefficient.shape[1] - 1, 0, -1):
        b1, b2 = coefficient[:, k] + x2 * b1 - b2, b1
    return coefficient[:, 0] + x2 / 2 * b1 - b2


def _split_until_arc_length_is_exact(power: Floats, owner: Ints, bounds: Floats) -> tuple[Floats, Ints, Floats, Floats]:
    """Halve spans until the tail of their arc length series is below 1e-11 mm."""
    order = np.arange(len(power), dtype=float)
    done: list[tuple[Floats, Ints, Floats, Floats, Floats]] = []
    for depth in range(24):
        arc = _arc_coefficients(power)
        speed_floor = _speed(power, np.linspace(0.0, 1.0, 9)).min(axis=1)
        if (speed_floor <= 1e-12).any() and depth > 12:
            break
        good = np.abs(arc[:, -3:]).max(axis=1) < 1e-11 * np.maximum(1.0, np.abs(arc[:, 0]))
        done.append((power[good], owner[good], bounds[good], arc[good], order[good]))
        power, owner, bounds, order = power[~good], owner[~good], bounds[~good], order[~good]
        if not len(power):
            break
        left, right = _halves(power)
        middle = bounds.mean(axis=1)
        power = np.concatenate([left, right])
        owner = np.concatenate([owner, owner])
        bounds = np.concatenate([np.stack([bounds[:, 0], middle], 1), np.stack([middle, bounds[:, 1]], 1)])
        order = np.concatenate([order, order + 0.5 ** (depth + 1)])
    if len(power):
        raise InputError(phrase("the profile has a cusp or a point where its parametrisation stands still"))
    key = np.argsort(np.concatenate([d[4] for d in done]), kind="stable")
    p, o, b, a = (np.concatenate([d[i] for d in done])[key] for i in range(4))
    return p, o, b, a


def _turns(power: Floats, contours: tuple[Contour, ...], first: Ints) -> Floats:
    """Turning angle at the end of every span; InputError where neighbours do not meet."""
    start = power[:, 0, :2] / power[:, 0, 2:]
    total = power.sum(axis=1)
    end = total[:, :2] / total[:, 2:]
    d0 = (power[:, 1, :2] - power[:, 1, 2:] * start) / power[:, 0, 2:]
    slope = (power * np.arange(power.shape[1])[None, :, None]).sum(axis=1)
    d1 = (slope[:, :2] - slope[:, 2:] * end) / total[:, 2:]
    turn = np.full(len(power), np.nan)
    for k, contour in enumerate(contours):
        a, b = int(first[k]), int(first[k + 1])
        this = np.arange(a, b)
        after = np.roll(this, -1)
        if not contour.closed:
            this, after = this[:-1], after[:-1]
        gap = np.hypot(*(start[after] - end[this]).T)
        if len(gap) and gap.max() > GAP:
            i = int(np.argmax(gap))
            x, y = end[this[i]]
            raise InputError(phrase("contour {} of the profile has a gap of {} at {}", k, mm(gap[i], ".4f"), xy(x, y)))
        cross = d1[this, 0] * d0[after, 1] - d1[this, 1] * d0[after, 0]
        dot = (d1[this] * d0[after]).sum(axis=1)
        turn[this] = np.arctan2(cross, dot)
    return turn
