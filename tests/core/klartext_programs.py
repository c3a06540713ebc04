# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours made at random, as plain-language programs in many forms, together with the moves that they mean."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field

import numpy as np
from hypothesis import strategies as st

from millcorr.nc.toolpath import Kind, Toolpath

LEAD = 15.0


@dataclass
class Made:
    """A program, the moves it means as (kind, end, centre, sweep, height), and what can be measured of its part."""

    lines: list[str] = field(default_factory=list)
    moves: list[tuple[int, complex, complex | None, float, float]] = field(default_factory=list)
    following: list[int] = field(default_factory=list)
    inch: bool = False
    numbered: bool = True
    ending: str = "\n"

    def add(self, text: str) -> None:
        self.lines.append(text)

    @property
    def text(self) -> bytes:
        unit = "INCH" if self.inch else "MM"
        whole = [f"BEGIN PGM MADE {unit}", *self.lines, f"END PGM MADE {unit}"]
        if self.numbered:
            whole = [f"{i} {line}" for i, line in enumerate(whole)]
        return "".join(line + self.ending for line in whole).encode()


@dataclass
class Habit:
    """How a made program writes its numbers and its moves."""

    decimals: int
    comma: bool
    plus: bool
    zeros: bool
    scale: float
    forms: object

    def number(self, value: float, decimals: int | None = None, scale: bool = True) -> str:
        decimals = self.decimals if decimals is None else decimals
        text = f"{value / (self.scale if scale else 1.0):.{decimals}f}"
        if not self.zeros and "." in text:
            text = text.rstrip("0").rstrip(".")
        text = "0" if text in ("-0", "-0." + "0" * decimals) else text
        text = ("+" if self.plus and not text.startswith("-") else "") + text
        return text.replace(".", ",") if self.comma else text

    def on_grid(self, place: complex) -> complex:
        step = self.scale * 10.0**-self.decimals
        return complex(round(place.real / step) * step, round(place.imag / step) * step)


@st.composite
def programs(draw, leads: bool = True, compensated: bool = True) -> Made:
    """A convex outside contour, run clockwise, its corners sharp, rounded or cut off, its sides straight or bulged."""
    inch = draw(st.booleans())
    habit = Habit(
        decimals=draw(st.integers(4, 5) if inch else st.integers(3, 4)),
        comma=draw(st.booleans()),
        plus=draw(st.booleans()),
        zeros=draw(st.booleans()),
        scale=25.4 if inch else 1.0,
        forms=draw,
    )
    out = Made(inch=inch, numbered=draw(st.booleans()), ending=draw(st.sampled_from(["\n", "\r\n"])))
    count = draw(st.integers(3, 7))
    jitter = [draw(st.floats(-0.15, 0.15)) for _ in range(count)]
    size = draw(st.floats(35.0, 60.0))
    middle = complex(draw(st.floats(-40.0, 40.0)), draw(st.floats(-40.0, 40.0)))
    squeeze = draw(st.floats(0.75, 1.0))
    angles = [-2 * math.pi * (k + jitter[k]) / count - math.pi / 2 for k in range(count)]
    corners = [habit.on_grid(middle + complex(size * math.cos(a), size * squeeze * math.sin(a))) for a in angles]
    side = draw(st.sampled_from(["R0", "R0", "RR"])) if compensated else "R0"
    # The contour begins in the middle of the last side.
    begin = habit.on_grid((corners[-1] + corners[0]) / 2)
    places = [begin, *corners, begin]
    feed = draw(st.sampled_from([250, 400, 1200]))

    def xy(place: complex, at: complex | None = None, omit: bool = True) -> str:
        words = []
        for letter, value, was in (("X", place.real, at and at.real), ("Y", place.imag, at and at.imag)):
            if at is not None and was == value and omit and draw(st.booleans()):
                continue
            if at is not None and draw(st.integers(0, 3)) == 0:
                words.append(f"I{letter}{habit.number(value - was)}")
            else:
                words.append(f"{letter}{habit.number(value)}")
        return " ".join(words) or f"X{habit.number(place.real)}"

    z, safe = habit.on_grid(complex(-3.0, 20.0)).real, habit.on_grid(complex(-3.0, 20.0)).imag
    tool = draw(st.sampled_from(["7", '"END 8"']))
    out.add("; made at random")
    out.add(f"TOOL CALL {tool} Z S4000")
    out.add(f"L Z{habit.number(safe)} R0 FMAX M3")
    out.moves.append((Kind.RAPID, complex(math.nan, math.nan), None, 0.0, safe))
    ahead = (corners[0] - begin) / abs(corners[0] - begin)
    left = 1j * ahead
    lead = draw(st.sampled_from(["plain", "LT", "LN", "CT", "LCT"])) if leads else "plain"
    if lead == "plain":
        start = habit.on_grid(begin + LEAD * left)
        out.add(f"L {xy(start)} FMAX")
        out.add(f"L Z{habit.number(z)} F{feed}")
        out.add(f"L {xy(begin)} {side}")
        out.moves += [
            (Kind.RAPID, start, None, 0.0, safe),
            (Kind.LINE, start, None, 0.0, z),
            (Kind.LINE, begin, None, 0.0, z),
        ]
    else:
        # The tool is right of the contour where APPR counts it to be: the other way round it would cut into the part.
        start = habit.on_grid(begin + 2 * LEAD * left - 2 * LEAD * ahead)
        out.add(f"L {xy(start)} FMAX")
        out.add(f"L Z{habit.number(z)} F{feed}")
        out.moves += [(Kind.RAPID, start, None, 0.0, safe), (Kind.LINE, start, None, 0.0, z)]
        if side == "RR" or lead in ("LN", "CT", "LCT"):
            # Clockwise outside: the cutter is left of its way.
            side = "RL"
        size_of = habit.on_grid(complex(10.0, 8.0))
        if lead == "LT":
            helper = begin - size_of.real * ahead
            words = f"LEN{habit.number(size_of.real)}"
        elif lead == "LN":
            helper = begin + size_of.real * left
            words = f"LEN{habit.number(size_of.real)}"
        elif lead == "CT":
            centre = begin + size_of.imag * left
            helper = centre + (begin - centre) * cmath.exp(-1j * math.pi / 2)
            words = f"CCA90 R{habit.number(size_of.imag)}"
        else:
            centre = begin + size_of.imag * left
            way = start - centre
            helper = centre + way / abs(way) * size_of.imag * cmath.exp(1j * math.acos(size_of.imag / abs(way)))
            words = f"R{habit.number(size_of.imag)}"
        out.add(f"APPR {lead} {xy(begin)} {words} {side}")
        out.moves.append((Kind.LINE, helper, None, 0.0, z))
        if lead in ("CT", "LCT"):
            turn = cmath.phase((begin - centre) / (helper - centre)) % (2 * math.pi)
            out.moves.append((Kind.ARC, begin, centre, turn, z))
        else:
            out.moves.append((Kind.LINE, begin, None, 0.0, z))
    first = len(out.moves)
    kinds = [(what, habit.on_grid(size + 0j).real) for what, size in _corner_kinds(draw, places)]
    at = begin
    straight = True
    for k in range(1, len(places)):
        a, b = places[k - 1], places[k]
        corner = kinds[k - 1] if k < len(places) - 1 else ("", 0.0)
        bulged = corner[0] == "" and kinds[k - 2 if k >= 2 else 0][0] == "" and 2 <= k < len(places) - 1 and straight
        bulge = bulged and draw(st.integers(0, 2)) == 0
        if bulge:
            centre, turn = _bulge(habit, draw, a, b, out, xy)
            out.moves.append((Kind.ARC, b, centre, turn, z))
        else:
            u = (b - a) / abs(b - a)
            end = b
            if corner[0]:
                v = (places[k + 1] - b) / abs(places[k + 1] - b)
                end = b - u * (corner[1] if corner[0] == "CHF" else corner[1] * math.tan(abs(cmath.phase(v / u)) / 2))
            _line(habit, draw, a, b, out, xy)
            out.moves.append((Kind.LINE, end, None, 0.0, z))
            if corner[0] == "CHF":
                out.add(f"CHF {habit.number(corner[1]).lstrip('+')}")
                out.moves.append((Kind.LINE, b + corner[1] * v, None, 0.0, z))
            elif corner[0] == "RND":
                out.add(f"RND R{habit.number(corner[1])}")
                turn = cmath.phase(v / u)
                centre = end + corner[1] * 1j * u * (1 if turn > 0 else -1)
                out.moves.append((Kind.ARC, centre + (end - centre) * cmath.exp(1j * turn), centre, turn, z))
        at = b
        if draw(st.integers(0, 6)) == 0:
            out.add(draw(st.sampled_from(["; a comment", "* - a heading", "M8", "Q5 = 3 * Q7"])))
    out.following = list(range(first, len(out.moves)))
    arrive = (places[-1] - places[-2]) / abs(places[-1] - places[-2])
    if lead == "plain":
        far = habit.on_grid(at + LEAD * 1j * arrive)
        out.add(f"L {xy(far)} R0")
        out.moves.append((Kind.LINE, far, None, 0.0, z))
    else:
        out.add(f"DEP LT LEN{habit.number(habit.on_grid(10 + 0j).real)}")
        far = at + habit.on_grid(10 + 0j).real * arrive
        out.moves.append((Kind.LINE, far, None, 0.0, z))
        if side != "R0":
            far = complex(math.nan, math.nan)
    out.add(f"L Z{habit.number(safe)} FMAX M30")
    out.moves.append((Kind.RAPID, far, None, 0.0, safe))
    return out


def _corner_kinds(draw, places: list[complex]) -> list[tuple[str, float]]:
    """What happens at every corner but the last place: nothing, RND or CHF with its size."""
    out = []
    for _ in places[1:-1]:
        what = draw(st.sampled_from(["", "", "RND", "CHF"]))
        out.append((what, draw(st.sampled_from([5.0, 5.08])) if what else 0.0))
    return out


def _line(habit: Habit, draw, a: complex, b: complex, out: Made, xy) -> None:
    if draw(st.integers(0, 5)) == 0:
        # About a pole in the corner of a triangle with whole sides the place is exact.
        pole = complex(b.real, b.imag - 30.0 * habit.scale)
        if habit.on_grid(pole) == pole:
            out.add(f"CC X{habit.number(pole.real)} Y{habit.number(pole.imag)}")
            out.add(f"LP PR{habit.number(30.0 * habit.scale)} PA{habit.number(90, 3, scale=False)}")
            return
    out.add(f"L {xy(b, a)}")


def _bulge(habit: Habit, draw, a: complex, b: complex, out: Made, xy) -> tuple[complex, float]:
    """A side as an arc of large radius, bent outwards."""
    chord = abs(b - a)
    radius = round(1.6 * chord / habit.scale, 1) * habit.scale
    centre = (a + b) / 2 - 1j * (b - a) / chord * math.sqrt(radius**2 - chord**2 / 4)
    turn = -2 * math.asin(chord / 2 / radius)
    form = draw(st.sampled_from(["CR", "C", "CP"]))
    digits = habit.decimals + 8
    if form == "CR":
        out.add(f"CR {xy(b, a)} R{habit.number(radius)} DR-")
        return centre, turn
    out.add(f"CC X{habit.number(centre.real, digits)} Y{habit.number(centre.imag, digits)}")
    if form == "C":
        out.add(f"C {xy(b, a)} DR-")
    else:
        out.add(f"CP IPA{habit.number(math.degrees(turn), 11, scale=False)} DR-")
    return centre, turn


def same_moves(made: Made, toolpath: Toolpath, within: float) -> None:
    """Assert that a toolpath is what was made."""
    assert len(toolpath) == len(made.moves)
    for i, (kind, end, centre, turn, z) in enumerate(made.moves):
        at = complex(*toolpath.end[i, :2])
        assert toolpath.kind[i] == kind, i
        assert (cmath.isnan(at) and cmath.isnan(end)) or abs(at - end) <= within, (i, at, end)
        assert abs(toolpath.end[i, 2] - z) <= within
        if centre is not None:
            assert abs(complex(*toolpath.centre[i, :2]) - centre) <= 100 * within
            assert abs(toolpath.sweep[i] - turn) <= 100 * within


def as_iso(t: Toolpath) -> str:
    """The same moves as an ISO program with 12 decimals, a line a move."""
    out, compensation, tool, feed = ["G21 G90 G17 G40"], 0, -1, math.nan
    for i in range(len(t)):
        words = []
        if t.tool[i] != tool:
            tool = t.tool[i]
            out.append(f"T{abs(tool)} M6")
        if t.compensation[i] != compensation:
            compensation = t.compensation[i]
            words.append({0: "G40", 1: "G41 D1", -1: "G42 D1"}[compensation])
        arc = t.kind[i] == Kind.ARC
        words.append({Kind.RAPID: "G0", Kind.LINE: "G1"}.get(t.kind[i], "G2" if t.sweep[i] < 0 else "G3"))
        words += [f"{'XYZ'[a]}{t.end[i, a]:.12f}" for a in range(3) if np.isfinite(t.end[i, a])]
        if arc:
            words.append("I{:.12f} J{:.12f}".format(*(t.centre[i] - t.start[i])[:2]))
        if t.kind[i] != Kind.RAPID and t.feed[i] != feed and np.isfinite(t.feed[i]):
            feed = t.feed[i]
            words.append(f"F{feed * 60:.9g}")
        out.append(" ".join(words))
    return "\n".join([*out, "M30", ""])
