# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part contours with closed forms, made at random, and the cutter paths that cut them.

A part is a polygon whose corners are sharp or filleted. Its exact parallel is again such a polygon: every side
moved by the cutter radius, every fillet made larger (convex) or smaller (concave) by it. Nothing here uses the
package's own geometry beyond the containers it is to fill.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.nc.toolpath import Kind, Plane, Toolpath


@dataclass(frozen=True)
class Element:
    """A line, or an arc where `centre` is given; `sweep` positive anticlockwise."""

    p0: np.ndarray
    p1: np.ndarray
    centre: np.ndarray | None = None
    sweep: float = 0.0

    def reversed(self) -> Element:
        return Element(self.p1, self.p0, self.centre, -self.sweep)

    @property
    def length(self) -> float:
        if self.centre is None:
            return float(np.hypot(*(self.p1 - self.p0)))
        return float(np.hypot(*(self.p0 - self.centre)) * abs(self.sweep))

    def at(self, fraction: np.ndarray) -> np.ndarray:
        u = np.atleast_1d(fraction)[:, None]
        if self.centre is None:
            return self.p0 + u * (self.p1 - self.p0)
        x, y = self.p0 - self.centre
        c, s = np.cos(self.sweep * u), np.sin(self.sweep * u)
        return self.centre + np.hstack([x * c - y * s, x * s + y * c])

    def split(self, fraction: float) -> tuple[Element, Element]:
        middle = self.at(np.array([fraction]))[0]
        a, b = self.sweep * fraction, self.sweep * (1 - fraction)
        return Element(self.p0, middle, self.centre, a), Element(middle, self.p1, self.centre, b)

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Distance of points, closed form."""
        if self.centre is None:
            d = self.p1 - self.p0
            u = np.clip((points - self.p0) @ d / (d @ d), 0, 1)
            return np.hypot(*(points - self.p0 - u[:, None] * d).T)
        arm = points - self.centre
        r = np.hypot(*(self.p0 - self.centre))
        a0 = np.arctan2(*(self.p0 - self.centre)[::-1])
        turned = np.mod((np.arctan2(arm[:, 1], arm[:, 0]) - a0) * np.sign(self.sweep), 2 * np.pi)
        ends = np.minimum(np.hypot(*(points - self.p0).T), np.hypot(*(points - self.p1).T))
        return np.where(turned <= abs(self.sweep), np.abs(np.hypot(*arm.T) - r), ends)

    def curve(self) -> NurbsCurve:
        if self.centre is None:
            return NurbsCurve.line(self.p0, self.p1)
        return NurbsCurve.arc(self.p0, self.p1, self.centre, self.sweep)


def turns(vertices: np.ndarray) -> np.ndarray:
    """Turning angle at each vertex of a closed polygon, positive to the left."""
    d = np.roll(vertices, -1, axis=0) - vertices
    before = np.roll(d, 1, axis=0)
    return np.arctan2(before[:, 0] * d[:, 1] - before[:, 1] * d[:, 0], (before * d).sum(axis=1))


def filleted(vertices: np.ndarray, radii: Sequence[float]) -> list[Element]:
    """Closed polygon with filleted corners, starting on the side from vertex 0 to vertex 1; None: does not fit."""
    turn = turns(vertices)
    reach = np.asarray(radii) * np.tan(np.abs(turn) / 2)
    d = np.roll(vertices, -1, axis=0) - vertices
    size = np.hypot(*d.T)
    unit = d / size[:, None]
    out: list[Element] = []
    n = len(vertices)
    for i in range(n):
        j = (i + 1) % n
        if size[i] - reach[i] - reach[j] < 1e-6:
            raise ValueError("a fillet does not fit")
        out.append(Element(vertices[i] + reach[i] * unit[i], vertices[j] - reach[j] * unit[i]))
        if radii[j] > 0:
            left = np.array([-unit[i, 1], unit[i, 0]])
            centre = out[-1].p1 + np.sign(turn[j]) * radii[j] * left
            out.append(Element(out[-1].p1, vertices[j] + reach[j] * unit[j], centre, float(turn[j])))
    return out


def moved_sides(vertices: np.ndarray, distance: np.ndarray | float) -> np.ndarray:
    """Polygon whose side i, from vertex i to the next, is moved out (to the right) by `distance[i]`."""
    d = np.roll(vertices, -1, axis=0) - vertices
    unit = d / np.hypot(*d.T)[:, None]
    normal = np.stack([unit[:, 1], -unit[:, 0]], axis=1)
    offset = (vertices * normal).sum(axis=1) + np.broadcast_to(distance, len(vertices))
    before = np.roll(normal, 1, axis=0)
    first = np.roll(offset, 1)
    det = before[:, 0] * normal[:, 1] - before[:, 1] * normal[:, 0]
    x = (first * normal[:, 1] - offset * before[:, 1]) / det
    y = (before[:, 0] * offset - normal[:, 0] * first) / det
    return np.stack([x, y], axis=1)


@dataclass(frozen=True)
class Part:
    """A closed polygon run with the material on its left; fillet radius of each corner, 0 where sharp."""

    vertices: np.ndarray
    radii: tuple[float, ...]

    @property
    def elements(self) -> list[Element]:
        return filleted(self.vertices, self.radii)

    @property
    def profile(self) -> Profile:
        return profile_of(self.elements)

    def path(self, radius: float, mitre: bool) -> list[Element]:
        """Exact path of a cutter; convex corners run round an arc, or sharp with `mitre`."""
        moved = moved_sides(self.vertices, radius)
        radii = []
        for r, turn in zip(self.radii, turns(self.vertices), strict=True):
            if turn > 0:
                radii.append(0.0 if mitre and r == 0 else r + radius)
            else:
                radii.append(r - radius if r > 0 else 0.0)
        if min(radii) < 0:
            raise ValueError("a fillet is smaller than the cutter")
        return filleted(moved, radii)


def profile_of(elements: Sequence[Element], closed: bool = True) -> Profile:
    return Profile.from_contours([Contour(tuple(e.curve() for e in elements), closed)])


def distance_to(elements: Sequence[Element], points: np.ndarray) -> np.ndarray:
    """Distance of points to the nearest element, closed form."""
    return np.min([e.distance(points) for e in elements], axis=0)


def reversed_elements(elements: Sequence[Element]) -> list[Element]:
    return [e.reversed() for e in reversed(elements)]


def started_at(elements: Sequence[Element], index: int, fraction: float) -> list[Element]:
    """Closed row of elements that starts elsewhere: on an element, or at its very start."""
    index %= len(elements)
    if fraction <= 0:
        return [*elements[index:], *elements[:index]]
    a, b = elements[index].split(fraction)
    return [b, *elements[index + 1 :], *elements[:index], a]


@st.composite
def polygons(draw, least: int = 3, most: int = 7) -> np.ndarray:
    """Star-shaped polygon, anticlockwise, with convex and concave corners."""
    n = draw(st.integers(least, most))
    jitter = [draw(st.floats(-0.3, 0.3)) for _ in range(n)]
    size = [draw(st.floats(22.0, 60.0)) for _ in range(n)]
    x0, y0 = draw(st.floats(-50, 50)), draw(st.floats(-50, 50))
    angle = (np.arange(n) + np.array(jitter)) * 2 * np.pi / n
    return np.stack([x0 + np.array(size) * np.cos(angle), y0 + np.array(size) * np.sin(angle)], axis=1)


@st.composite
def parts(
    draw, cutter: float = 0.0, pocket: bool | None = None, fillets: Sequence[float] = (0.0, 0.0, 0.5, 3.0, 8.0)
) -> Part:
    """Part with sharp and filleted corners that a cutter of the given radius can go round."""
    from hypothesis import assume

    vertices = draw(polygons())
    if draw(st.booleans()) if pocket is None else pocket:
        vertices = vertices[::-1].copy()
    turn = turns(vertices)
    assume((np.abs(turn) > 0.25).all() and (np.abs(turn) < 2.2).all())
    radii = []
    for t in turn:
        r = draw(st.sampled_from(fillets))
        radii.append(r if t > 0 or r == 0 else r + cutter)
    part = Part(vertices, tuple(radii))
    try:
        part.elements, part.path(cutter, False), part.path(cutter, True)
    except ValueError:
        assume(False)
    if cutter:
        # Sides keep their direction when moved.
        moved = moved_sides(vertices, cutter)
        before, after = np.roll(vertices, -1, 0) - vertices, np.roll(moved, -1, 0) - moved
        assume(((before * after).sum(axis=1) > 0).all())
    return part


def rectangle(width: float, height: float, radius: float = 0.0) -> Part:
    """Rectangle from the origin; first side is the bottom one."""
    v = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    return Part(v, (radius,) * 4)


def pocket(width: float, height: float, radius: float = 0.0) -> Part:
    """The same rectangle with the material outside."""
    return Part(rectangle(width, height).vertices[::-1].copy(), (radius,) * 4)


def facetted_circle(radius: float, count: int) -> np.ndarray:
    """Vertices of a regular polygon on a circle about the origin."""
    angle = 2 * np.pi * np.arange(count) / count
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def polyline(points: np.ndarray) -> NurbsCurve:
    """Open or closed row of lines as one curve of degree 1."""
    mult = np.ones(len(points), dtype=np.int64)
    mult[[0, -1]] = 2
    return NurbsCurve(1, points, np.ones(len(points)), np.arange(float(len(points))), mult)


def closed_spline(poles: np.ndarray) -> NurbsCurve:
    """Closed uniform cubic B-spline."""
    n = len(poles)
    return NurbsCurve(3, poles, np.ones(n), np.arange(n + 1.0), np.ones(n + 1, dtype=np.int64), True)


def scipy_closed_spline(poles: np.ndarray) -> BSpline:
    """The same curve by scipy; its parameter runs from 0 to the number of poles."""
    n = len(poles)
    return BSpline(np.arange(-3.0, n + 4.0), np.vstack([poles, poles[:3]]), 3)


@st.composite
def spline_poles(draw) -> np.ndarray:
    """Control polygon of a closed curve without loops, anticlockwise, hollow in places."""
    n = draw(st.integers(8, 15))
    size = np.array([draw(st.floats(25.0, 38.0)) for _ in range(n)])
    angle = 2 * np.pi * np.arange(n) / n
    return np.stack([size * np.cos(angle), size * np.sin(angle)], axis=1)


@dataclass
class Path:
    """Toolpath under construction."""

    here: tuple[float, float, float] = (0.0, 0.0, 0.0)
    compensation: int = 0
    rows: list[dict] = field(default_factory=list)

    def _add(self, kind: Kind, end: Sequence[float], z: float | None, **more: object) -> Path:
        last = (float(end[0]), float(end[1]), self.here[2] if z is None else z)
        row = {"kind": int(kind), "start": self.here, "end": last, "centre": (np.nan,) * 3, "sweep": 0.0}
        row |= {"control": (np.nan,) * 4, "compensation": self.compensation} | more
        self.rows.append(row)
        self.here = last
        return self

    def rapid(self, x: float, y: float, z: float | None = None) -> Path:
        return self._add(Kind.RAPID, (x, y), z)

    def line(self, x: float, y: float, z: float | None = None) -> Path:
        return self._add(Kind.LINE, (x, y), z)

    def plunge(self, z: float) -> Path:
        return self._add(Kind.LINE, self.here[:2], z)

    def arc(self, end: Sequence[float], centre: Sequence[float], sweep: float, z: float | None = None) -> Path:
        c = (float(centre[0]), float(centre[1]), self.here[2])
        return self._add(Kind.ARC, end, z, centre=c, sweep=float(sweep))

    def along(self, elements: Sequence[Element], depth: float = 0.0) -> Path:
        """Follow elements, going down by `depth` in all, evenly by length."""
        total = sum(e.length for e in elements)
        z0, done = self.here[2], 0.0
        for e in elements:
            done += e.length
            z = z0 - depth * done / total if depth else None
            if e.centre is None:
                self.line(*e.p1, z)
            else:
                self.arc(e.p1, e.centre, e.sweep, z)
        return self

    def toolpath(self) -> Toolpath:
        n = len(self.rows)

        def column(name: str, dtype: type) -> np.ndarray:
            return np.array([r[name] for r in self.rows], dtype=dtype)

        kind = column("kind", np.int64)
        return Toolpath(
            kind=kind,
            start=column("start", float),
            end=column("end", float),
            centre=column("centre", float),
            sweep=column("sweep", float),
            control=column("control", float),
            plane=np.full(n, int(Plane.XY)),
            feed=np.where(kind == Kind.RAPID, np.nan, 5.0),
            source=np.arange(n),
            compensation=column("compensation", np.int64),
            tool=np.ones(n, dtype=np.int64),
        )
