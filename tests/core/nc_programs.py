# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs made at random together with the moves they mean, for the tests of reader and writer."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from hypothesis import strategies as st

from millcorr.nc.toolpath import Kind, Plane, Toolpath

# Points of a circle of radius 5 on the grid: arcs between them end on it exactly.
CIRCLE = [
    (5, 0),
    (4, 3),
    (3, 4),
    (0, 5),
    (-3, 4),
    (-4, 3),
    (-5, 0),
    (-4, -3),
    (-3, -4),
    (0, -5),
    (3, -4),
    (4, -3),
]


@dataclass
class Dialect:
    """How a made program is written."""

    inch: bool = False
    incremental: bool = False
    arcs: str = "ij"
    blanks: bool = True
    lower: bool = False
    leading_zero: bool = False
    trailing_zeros: bool = True
    omit_motion: bool = False
    omit_axes: bool = False
    numbered: bool = False
    comments: bool = False
    ending: str = "\n"
    plane: int = 17
    decimals: int = 3

    @property
    def unit(self) -> float:
        """Smallest step in mm."""
        return 10.0**-self.decimals * (25.4 if self.inch else 1.0)


@dataclass
class Made:
    """A program and the moves it means."""

    dialect: Dialect
    text: bytes
    moves: list[dict] = field(default_factory=list)


dialects = st.builds(
    Dialect,
    inch=st.booleans(),
    incremental=st.booleans(),
    arcs=st.sampled_from(["ij", "r", "absolute"]),
    blanks=st.booleans(),
    lower=st.booleans(),
    leading_zero=st.booleans(),
    trailing_zeros=st.booleans(),
    omit_motion=st.booleans(),
    omit_axes=st.booleans(),
    numbered=st.booleans(),
    comments=st.booleans(),
    ending=st.sampled_from(["\n", "\r\n"]),
    plane=st.sampled_from([17, 18, 19]),
    decimals=st.integers(2, 5),
)
_coordinate = st.integers(-200000, 200000)
_steps = st.one_of(
    st.tuples(st.just("line"), _coordinate, _coordinate, _coordinate, st.integers(1, 7)),
    st.tuples(st.just("rapid"), _coordinate, _coordinate, _coordinate, st.integers(1, 7)),
    st.tuples(
        st.just("arc"),
        st.integers(0, 11),
        st.integers(0, 11),
        st.integers(20, 20000),
        st.booleans(),
        _coordinate,
    ),
)


def _number(dialect: Dialect, steps: int) -> str:
    text = f"{steps / 10**dialect.decimals:.{dialect.decimals}f}"
    if not dialect.trailing_zeros:
        text = text.rstrip("0").rstrip(".") if "." in text else text
        text = "0" if text in ("-0", "") else text
    return text


@st.composite
def programs(draw: st.DrawFn, max_moves: int = 12) -> Made:
    """Random program in a random dialect, starting from a stated position."""
    d = draw(dialects)
    at = [draw(_coordinate) for _ in range(3)]
    scale = d.unit
    lines: list[str] = []
    moves: list[dict] = []
    motion, feed = None, None

    def put(words: list[str], comment: str = "") -> None:
        if d.numbered:
            words = [f"N{10 * (len(lines) + 1)}", *words]
        text = (" " if d.blanks else "").join(words)
        text = text.lower() if d.lower else text
        lines.append(text + comment)

    g = "G0{}" if d.leading_zero else "G{}"
    if d.comments:
        lines.append("(A PROGRAM G1 X99)")
    put(["G20" if d.inch else "G21", "G90", f"G{d.plane}", "G90.1" if d.arcs == "absolute" else "G91.1"])
    put([g.format(0), *(f"{c}{_number(d, v)}" for c, v in zip("XYZ", at, strict=True))])
    moves.append({"kind": Kind.RAPID, "start": [math.nan] * 3, "end": [v * scale for v in at], "line": len(lines) - 1})
    if d.incremental:
        put(["G91"])
    motion = 0
    a, b, c = Plane(d.plane).axes
    for step in draw(st.lists(_steps, min_size=1, max_size=max_moves)):
        end = list(at)
        words: list[str] = []
        move: dict = {"start": [v * scale for v in at]}
        stated = 7
        extra: list[str] = []
        if step[0] == "arc":
            _, i, j, size, clockwise, along = step
            code = 2 if clockwise else 3
            u, v = CIRCLE[i], CIRCLE[j]
            centre = list(at)
            centre[a] -= u[0] * size
            centre[b] -= u[1] * size
            end[a], end[b] = centre[a] + v[0] * size, centre[b] + v[1] * size
            if along % 3 == 0:
                end[c] = along
            first, last = math.atan2(u[1], u[0]), math.atan2(v[1], v[0])
            angle = (first - last if clockwise else last - first) % (2 * math.pi)
            angle = 2 * math.pi if i == j else angle
            move |= {"kind": Kind.ARC, "sweep": -angle if clockwise else angle}
            move["centre"] = [value * scale for value in centre]
            if d.arcs == "r" and i != j and abs(angle - math.pi) > 0.1:
                extra = [f"R{_number(d, 5 * size if angle < math.pi else -5 * size)}"]
            else:
                origin = [0, 0, 0] if d.arcs == "absolute" else at
                extra = [f"{'IJK'[k]}{_number(d, centre[k] - origin[k])}" for k in sorted((a, b))]
        else:
            code = 1 if step[0] == "line" else 0
            stated = step[4]
            for k in range(3):
                if stated & (1 << k):
                    end[k] = step[1 + k]
            move["kind"] = Kind.LINE if code else Kind.RAPID
        move["end"] = [v * scale for v in end]
        axes = [k for k in range(3) if stated & (1 << k)]
        if d.omit_axes:
            axes = [k for k in axes if end[k] != at[k]] or axes[:1]
        if not (d.omit_motion and motion == code):
            words.append(g.format(code))
        words += [f"{'XYZ'[k]}{_number(d, end[k] - at[k] if d.incremental else end[k])}" for k in axes]
        words += extra
        if code and feed is None:
            feed = 100
            words.append("F100")
        move["line"] = len(lines)
        put(words, " (G1 X7) ; note" if d.comments and len(lines) % 3 == 0 else "")
        moves.append(move)
        motion, at = code, end
    put(["M2"])
    return Made(d, (d.ending.join(lines) + d.ending).encode(), moves)


def displaced(toolpath: Toolpath, shift: np.ndarray) -> Toolpath:
    """Toolpath with the end of every move shifted, arcs keeping their sweep.

    `shift` is (n, 3) in mm. A full circle moves with its start.
    """
    start, end, centre = toolpath.start.copy(), toolpath.end.copy(), toolpath.centre.copy()
    moved = shift.copy()
    for i in range(len(toolpath)):
        if i:
            start[i] = end[i - 1]
        if toolpath.kind[i] == Kind.ARC:
            a, b, c = Plane(int(toolpath.plane[i])).axes
            sweep = toolpath.sweep[i]
            if abs(math.remainder(sweep, 2 * math.pi)) < 1e-9:
                moved[i] = start[i] - toolpath.start[i]
                end[i] = toolpath.end[i] + moved[i]
                centre[i] = toolpath.centre[i] + moved[i]
                end[i, [a, b]] = start[i, [a, b]]
                continue
            end[i] = toolpath.end[i] + moved[i]
            chord = end[i, [a, b]] - start[i, [a, b]]
            middle = (end[i, [a, b]] + start[i, [a, b]]) / 2
            centre[i, [a, b]] = middle + np.array([-chord[1], chord[0]]) / (2 * math.tan(sweep / 2))
            centre[i, c] = start[i, c]
        else:
            end[i] = toolpath.end[i] + moved[i]
    return toolpath.with_moves(start=start, end=end, centre=centre)
