# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contour elements in the working plane, and what the control makes of them: corners, tangents, approaches.

Places are complex numbers, mm; the plane's first axis is real.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace

SAME = 1e-9
"""Two places in mm closer than this are the same programmed point."""
_STRAIGHT = 1e-6
"""A corner that turns by less, in rad, is none."""
_TURN = 2 * math.pi


class Impossible(Exception):
    """A contour element that cannot be; says why."""


@dataclass(frozen=True, slots=True)
class Element:
    """A line, or an arc where it has a centre.

    Parameters
    ----------
    start, end : complex
        mm.
    centre : complex, optional
    sweep : float
        Signed angle in rad, positive anticlockwise; 0 for a line.
    """

    start: complex
    end: complex
    centre: complex | None = None
    sweep: float = 0.0

    def direction(self, at_end: bool) -> complex:
        """Unit vector of travel at an end; 0 where nothing travels."""
        if self.centre is None:
            way = self.end - self.start
        else:
            way = ((self.end if at_end else self.start) - self.centre) * (1j if self.sweep > 0 else -1j)
        return way / abs(way) if abs(way) > SAME else 0j

    def cut_at_end(self, place: complex) -> Element:
        """The element up to a place on it."""
        return replace(self, end=place, sweep=self._angle(self.start, place))

    def cut_at_start(self, place: complex) -> Element:
        """The element from a place on it."""
        return replace(self, start=place, sweep=self._angle(place, self.end))

    def _angle(self, a: complex, b: complex) -> float:
        if self.centre is None or abs(b - a) <= SAME:
            return 0.0
        return angle_between(a, b, self.centre, self.sweep > 0)


def angle_between(a: complex, b: complex, centre: complex, anticlockwise: bool) -> float:
    """Signed angle about a centre from one place to another; a whole turn where they are the same."""
    if abs(b - a) <= SAME:
        return _TURN if anticlockwise else -_TURN
    angle = cmath.phase((b - centre) / (a - centre)) % _TURN
    angle = angle or _TURN
    return angle if anticlockwise else angle - _TURN


def by_radius(start: complex, end: complex, radius: float, anticlockwise: bool) -> Element:
    """Arc stated by its radius, below zero for more than half a turn (CR)."""
    chord = end - start
    if abs(chord) <= SAME:
        raise Impossible("CR ends where it starts: write a full circle with CC and C")
    rise = (radius / abs(chord)) ** 2 - 0.25
    if rise < 0:
        # Ends on a half circle are rounded like all others.
        if abs(chord) / 2 - abs(radius) > max(0.0127, 0.001 * abs(chord) / 2):
            raise Impossible("the radius of CR is shorter than half the way to its end: correct R")
        rise = 0.0
    left = 1.0 if anticlockwise == (radius > 0) else -1.0
    centre = start + chord * (0.5 + 1j * left * math.sqrt(rise))
    return Element(start, end, centre, angle_between(start, end, centre, anticlockwise))


def tangential(start: complex, end: complex, direction: complex) -> Element:
    """Arc from a place in a direction to another place (CT); a line where that lies straight ahead."""
    chord = end - start
    if abs(chord) <= SAME:
        raise Impossible("CT ends where it starts")
    if direction == 0:
        raise Impossible("nothing that moves stands before CT")
    turn = cmath.phase(chord / direction)
    if abs(turn) < _STRAIGHT:
        return Element(start, end)
    if abs(abs(turn) - math.pi) < _STRAIGHT:
        raise Impossible("CT ends straight behind its start")
    centre = start + direction * 1j * abs(chord) / (2 * math.sin(turn))
    return Element(start, end, centre, 2 * turn)


def rounded(first: Element, second: Element, radius: float) -> tuple[Element, Element, Element]:
    """Two elements that meet in a corner, and the arc that rounds it between them (RND)."""
    corner = first.end
    turn = _turn(first, second)
    if abs(turn) < _STRAIGHT:
        raise Impossible("RND between elements that meet without a corner")
    if abs(abs(turn) - math.pi) < _STRAIGHT or radius <= 0:
        raise Impossible("no arc of this radius rounds this corner: correct R of RND")
    side = 1.0 if turn > 0 else -1.0
    best: tuple[complex, complex, complex] | None = None
    for centre in _meetings(_beside(first, side * radius), _beside(second, side * radius)):
        a, b = _foot(first, centre, corner), _foot(second, centre, corner)
        if a is None or b is None or not (_holds(first, a) and _holds(second, b)):
            continue
        if best is None or abs(centre - corner) < abs(best[0] - corner):
            best = centre, a, b
    if best is None:
        raise Impossible("the arc of RND does not fit between its neighbours: a smaller R would")
    centre, a, b = best
    arc = Element(a, b, centre, angle_between(a, b, centre, side > 0))
    return first.cut_at_end(a), arc, second.cut_at_start(b)


def chamfered(first: Element, second: Element, length: float) -> tuple[Element, Element, Element]:
    """Two lines that meet in a corner, and the line that cuts it off at one length from it on both (CHF)."""
    if first.centre is not None or second.centre is not None:
        raise Impossible("CHF stands between straight lines only")
    if abs(_turn(first, second)) < _STRAIGHT or length <= 0:
        raise Impossible("CHF between lines that meet without a corner")
    if length > min(abs(first.end - first.start), abs(second.end - second.start)) + SAME:
        raise Impossible("the chamfer is longer than its neighbours: a shorter CHF would fit")
    a = first.end - length * first.direction(at_end=True)
    b = second.start + length * second.direction(at_end=False)
    return first.cut_at_end(a), Element(a, b), second.cut_at_start(b)


def _turn(first: Element, second: Element) -> float:
    u, v = first.direction(at_end=True), second.direction(at_end=False)
    if u == 0 or v == 0:
        raise Impossible("a corner needs a way before it and behind it")
    return cmath.phase(v / u)


_Curve = tuple[complex, complex | None, float]
"""A place and a direction, or a centre and a radius."""


def _beside(element: Element, left: float) -> _Curve:
    if element.centre is None:
        u = element.direction(at_end=False)
        return element.start + left * 1j * u, u, 0.0
    return element.centre, None, abs(element.start - element.centre) - (left if element.sweep > 0 else -left)


def _meetings(a: _Curve, b: _Curve) -> list[complex]:
    """Where two lines or circles meet."""
    if a[1] is not None and b[1] is not None:
        cross = (a[1].conjugate() * b[1]).imag
        if abs(cross) < 1e-12:
            return []
        return [a[0] + a[1] * ((b[0] - a[0]).conjugate() * b[1]).imag / cross]
    if a[1] is None and b[1] is not None:
        a, b = b, a
    if b[2] < 0 or (a[1] is None and a[2] < 0):
        return []
    if a[1] is not None:
        foot = a[0] + a[1] * ((b[0] - a[0]) * a[1].conjugate()).real
        rise = b[2] ** 2 - abs(b[0] - foot) ** 2
        if rise < -SAME:
            return []
        half = math.sqrt(max(rise, 0.0))
        return [foot + half * a[1], foot - half * a[1]]
    gap = abs(b[0] - a[0])
    if gap < SAME:
        return []
    u = (b[0] - a[0]) / gap
    along = (gap**2 + a[2] ** 2 - b[2] ** 2) / (2 * gap)
    rise = a[2] ** 2 - along**2
    if rise < -SAME:
        return []
    half = math.sqrt(max(rise, 0.0))
    return [a[0] + u * (along + 1j * half), a[0] + u * (along - 1j * half)]


def _foot(element: Element, place: complex, corner: complex) -> complex | None:
    """Nearest place to another one on an element's line or circle."""
    if element.centre is None:
        u = element.direction(at_end=False)
        return element.start + u * ((place - element.start) * u.conjugate()).real
    way = place - element.centre
    if abs(way) < SAME:
        return None
    return element.centre + way / abs(way) * abs(corner - element.centre)


def _holds(element: Element, place: complex) -> bool:
    """Whether a place of its line or circle is on the element."""
    if element.centre is None:
        whole = element.end - element.start
        share = ((place - element.start) * whole.conjugate()).real / abs(whole) ** 2
        return -1e-9 <= share <= 1 + 1e-9
    if min(abs(place - element.start), abs(place - element.end)) <= SAME:
        return True
    return abs(angle_between(element.start, place, element.centre, element.sweep > 0)) <= abs(element.sweep) + 1e-9


@dataclass(frozen=True, slots=True)
class Lead:
    """How a contour is reached or left: straight elements and arcs between the contour and where the tool is free.

    Parameters
    ----------
    form : str
        LT, LN, CT or LCT.
    length, radius : float
        LEN and R, mm.
    angle : float
        CCA, rad.
    side : float
        1 where the cutter is left of the contour, -1 right.
    """

    form: str
    length: float
    radius: float
    angle: float
    side: float

    def approach(self, start: complex, contour: complex, ahead: complex) -> list[Element]:
        """From where the tool is to the first place of the contour, which goes on in a direction."""
        if self.form == "LT":
            helper = contour - self.length * ahead
        elif self.form == "LN":
            helper = contour + self.length * 1j * self.side * ahead
        else:
            helper, arc = self._arc(start, contour, ahead)
            return [Element(start, helper), arc]
        return [Element(start, helper), Element(helper, contour)]

    def departure(self, contour: complex, ahead: complex, end: complex | None) -> list[Element]:
        """From the last place of the contour, reached in a direction, to where the tool is free."""
        if self.form == "LT":
            return [Element(contour, contour + self.length * ahead)]
        if self.form == "LN":
            return [Element(contour, contour + self.length * 1j * self.side * ahead)]
        # The way back: what is approached from its end.
        helper, arc = self._arc(end, contour, -ahead, -self.side)
        out = [Element(contour, helper, arc.centre, -arc.sweep)]
        return [*out, Element(helper, end)] if end is not None else out

    def _arc(
        self, start: complex | None, contour: complex, ahead: complex, side: float | None = None
    ) -> tuple[complex, Element]:
        """Where the arc begins, and the arc; the line from `start`, if there is one, runs into it on its tangent."""
        side = self.side if side is None else side
        left = side if self.radius > 0 else -side
        radius = abs(self.radius)
        if radius <= SAME or ahead == 0:
            raise Impossible("an approach on an arc needs its radius R and a contour behind it")
        centre = contour + 1j * left * radius * ahead
        if self.form == "CT":
            helper = centre + (contour - centre) * cmath.exp(-1j * left * self.angle)
            return helper, Element(helper, contour, centre, left * self.angle)
        assert start is not None
        way = start - centre
        if abs(way) < radius - SAME:
            raise Impossible("the approach begins within its own arc: a smaller R would leave it room")
        # Seen from the centre the helper lies so far from the start, in the arc's sense ahead of it.
        helper = centre + radius * way / abs(way) * cmath.exp(1j * left * math.acos(min(radius / abs(way), 1.0)))
        return helper, Element(helper, contour, centre, angle_between(helper, contour, centre, left > 0))
