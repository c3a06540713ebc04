# SPDX-License-Identifier: LGPL-2.1-or-later
"""One contour with rounded corners, cut at three depths under G41, as every family of controls writes it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from hypothesis import strategies as st

DEPTHS = (-2.0, -4.0, -6.0)


@dataclass(frozen=True)
class Edge:
    """An edge to a vertex: straight, or an arc about a centre; what is made of the corner at its end."""

    end: tuple[float, float]
    centre: tuple[float, float] | None = None
    clockwise: bool = True
    corner: tuple[str, float] | None = None


@dataclass(frozen=True)
class Contour:
    """A closed contour, clockwise, that begins and ends within its first edge."""

    start: tuple[float, float]
    outside: tuple[float, float]
    edges: tuple[Edge, ...]

    def explicit(self) -> tuple[Edge, ...]:
        """The same with moves in place of corners: closed forms of fillet and chamfer between lines."""
        out = []
        at = self.start
        for k, edge in enumerate(self.edges):
            if edge.corner is None:
                out.append(edge)
            else:
                vertex, after = np.array(edge.end), np.array(self.edges[k + 1].end)
                u, v = (vertex - at) / math.dist(vertex, at), (after - vertex) / math.dist(vertex, after)
                turn = math.atan2(u[0] * v[1] - u[1] * v[0], u @ v)
                kind, size = edge.corner
                cut = size * math.tan(abs(turn) / 2) if kind == "R" else size
                a, b = vertex - cut * u, vertex + cut * v
                centre = a + size * np.sign(turn) * np.array([-u[1], u[0]])
                out.append(Edge(tuple(a)))
                out.append(Edge(tuple(b), tuple(centre) if kind == "R" else None, bool(turn < 0)))
            at = edge.end
        return tuple(out)


@st.composite
def contours(draw: Callable) -> Contour:
    """A star-shaped polygon with straight and bent edges, its corners rounded or broken."""
    count = draw(st.integers(4, 7))
    whole = st.integers(0, 10**6)
    angles = [-2 * math.pi * (k + 0.3 * draw(whole) / 1e6) / count for k in range(count)]
    radii = [22 + 12 * draw(whole) / 1e6 for _ in range(count)]
    vertices = [(round(r * math.cos(a), 3), round(r * math.sin(a), 3)) for a, r in zip(angles, radii, strict=True)]
    bent = [False] + [draw(st.integers(0, 3)) == 0 for _ in range(count - 1)]
    start = tuple(round(0.5 * (vertices[-1][i] + vertices[0][i]), 3) for i in (0, 1))
    edges = []
    at = start
    for k, vertex in enumerate(vertices):
        straight = not bent[k] and not bent[(k + 1) % count]
        corner = draw(st.sampled_from([None, ("R", 2.0), ("R", 3.5), ("C", 1.5)])) if straight else None
        if bent[k]:
            middle, chord = np.add(at, vertex) / 2, np.subtract(vertex, at)
            length = math.hypot(*chord)
            # The centre to the right of the way, where the inside is.
            rise = 1.3 * length
            centre = middle + rise * np.array([chord[1], -chord[0]]) / length
            edges.append(Edge(vertex, tuple(centre), True))
        else:
            edges.append(Edge(vertex, corner=corner))
        at = vertex
    edges.append(Edge(start))
    away = np.subtract(vertices[0], vertices[-1])
    outside = np.add(start, 9 * np.array([-away[1], away[0]]) / math.hypot(*away))
    return Contour(start, (round(float(outside[0]), 3), round(float(outside[1]), 3)), tuple(edges))


def number(value: float) -> str:
    """Decimals enough for a billionth of a millimetre."""
    text = f"{value:.11f}".rstrip("0")
    return text


def moves(contour: Contour, at: str, family: str) -> list[str]:
    """Lines from where the tool stands outside, around the contour and back."""
    lines = [f"G41 D1 G1 X{number(contour.start[0])} Y{number(contour.start[1])} F400."]
    words = family not in ("plain", "Okuma", "LinuxCNC")
    place = contour.start
    for edge in contour.edges if words else contour.explicit():
        line = f"X{number(edge.end[0])} Y{number(edge.end[1])}"
        if edge.centre is None:
            line = "G1 " + line
        else:
            i, j = np.subtract(edge.centre, place)
            radius = math.dist(edge.centre, place)
            if family == "Siemens":
                line = f"G2 {line} CR={number(radius)}" if edge.clockwise else f"G3 {line} I{number(i)} J{number(j)}"
            else:
                line = f"G{2 if edge.clockwise else 3} {line} I{number(i)} J{number(j)}"
        if edge.corner and words:
            kind, size = edge.corner
            named = {"R": " RND=", "C": " CHR="}[kind] if family == "Siemens" else f",{kind}"
            line += f"{named}{number(size)}"
        lines.append(line)
        place = edge.end
    lines.append(f"G40 G1 {at}")
    return lines


def all_rounded(contour: Contour) -> list[str]:
    """Siemens' lines around the contour: RNDM= where the radius of the corners changes, chamfers on their own.

    Corners have a feed of their own.
    """
    lines, modal = [f"G41 D1 G1 X{number(contour.start[0])} Y{number(contour.start[1])} F400."], 0.0
    for edge in contour.edges:
        line = f"X{number(edge.end[0])} Y{number(edge.end[1])}"
        if edge.centre is None:
            line = "G1 " + line
        else:
            line = f"G{2 if edge.clockwise else 3} {line} I=AC({number(edge.centre[0])}) J=AC({number(edge.centre[1])})"
        kind, size = edge.corner or ("R", 0.0)
        if kind == "C":
            line += f" CHR={number(size)}"
        elif size != modal:
            line, modal = f"{line} RNDM={number(size)}", size
        lines.append(line)
    lines[0] += " FRCM=150"
    return [*lines, f"G40 G1 X{number(contour.outside[0])} Y{number(contour.outside[1])} RNDM=0 FRCM=0"]


def about_poles(contour: Contour) -> list[str]:
    """Siemens' lines around the contour, every place by its polar angle and radius."""
    lines = [f"G41 D1 G1 X{number(contour.start[0])} Y{number(contour.start[1])} F400."]
    at, pole, last = contour.start, None, 0.0
    for k, edge in enumerate(contour.edges):
        if edge.centre is not None:
            x, y = np.subtract(edge.centre, at)
            lines.append(f"G110 X{number(x)} Y{number(y)}")
        elif pole != (3.0, -4.0):
            lines += ["G111 X1.5 Y=0", "G112 X1.5 Y-4."]
        before, pole = pole, edge.centre or (3.0, -4.0)
        x, y = np.subtract(edge.end, pole)
        angle = math.degrees(math.atan2(y, x))
        said = f"AP=IC({number(angle - last)})" if pole == before and k % 2 else f"AP={number(angle)}"
        line = f"G{1 if edge.centre is None else 2 if edge.clockwise else 3} {said} RP={number(math.hypot(x, y))}"
        if edge.corner:
            line += f" {'RND' if edge.corner[0] == 'R' else 'CHR'}={number(edge.corner[1])}"
        lines.append(line)
        at, last = edge.end, angle
    return [*lines, f"G40 G1 X{number(contour.outside[0])} Y{number(contour.outside[1])}"]


def plain_language(contour: Contour) -> list[str]:
    """Blocks of HEIDENHAIN plain language, from where the tool stands outside, around the contour and back."""
    lines = [f"L X{number(contour.start[0])} Y{number(contour.start[1])} RL F400"]
    for edge in contour.edges:
        end = f"X{number(edge.end[0])} Y{number(edge.end[1])}"
        if edge.centre is None:
            lines.append(f"L {end}")
        else:
            lines += [
                f"CC X{number(edge.centre[0])} Y{number(edge.centre[1])}",
                f"C {end} DR{'-' if edge.clockwise else '+'}",
            ]
        if edge.corner:
            kind, size = edge.corner
            lines.append(f"{'RND R' if kind == 'R' else 'CHF '}{number(size)}")
    return [*lines, f"L X{number(contour.outside[0])} Y{number(contour.outside[1])} R0"]


def din_iso(contour: Contour) -> list[str]:
    """Blocks of HEIDENHAIN's ISO code, from where the tool stands outside, around the contour and back."""
    lines = [f"G01 G41 X{number(contour.start[0])} Y{number(contour.start[1])} F400"]
    for edge in contour.edges:
        end = f"X{number(edge.end[0])} Y{number(edge.end[1])}"
        if edge.centre is None:
            lines.append(f"G01 {end}")
        else:
            lines += [f"I{number(edge.centre[0])} J{number(edge.centre[1])}", f"G0{2 if edge.clockwise else 3} {end}"]
        if edge.corner:
            kind, size = edge.corner
            lines.append(f"G2{5 if kind == 'R' else 4} R{number(size)}")
    return [*lines, f"G01 G40 X{number(contour.outside[0])} Y{number(contour.outside[1])}"]


def written(contour: Contour, family: str) -> str:
    """The program of one family."""
    if family == "Heidenhain ISO":
        at = f"X{number(contour.outside[0])} Y{number(contour.outside[1])}"
        blocks = [
            "T1 G17 S3000", f"G00 G40 G90 {at}", "Z0.", "G98 L1", "G01 G91 Z-2. F200", "G90",
            *din_iso(contour), f"L1,{len(DEPTHS) - 1}", "G00 Z50. M30",
        ]  # fmt: skip
        whole = ["%PART G71 *", *(f"N{10 * i + 10} {block} *" for i, block in enumerate(blocks))]
        return "\n".join([*whole, "N99999999 %PART G71 *"]) + "\n"
    if family == "Heidenhain":
        at = f"X{number(contour.outside[0])} Y{number(contour.outside[1])}"
        blocks = [
            "BEGIN PGM PART MM", "TOOL CALL 1 Z S3000", f"L {at} FMAX", "L Z0. FMAX", "LBL 1", "L IZ-2. F200",
            *plain_language(contour), f"CALL LBL 1 REP {len(DEPTHS) - 1}", "L Z50. FMAX M30", "END PGM PART MM",
        ]  # fmt: skip
        return "\n".join(f"{i} {block}" for i, block in enumerate(blocks)) + "\n"
    at = f"X{number(contour.outside[0])} Y{number(contour.outside[1])}"
    other = {"Siemens, all rounded": all_rounded, "Siemens, polar": about_poles}.get(family)
    body = other(contour) if other else moves(contour, at, family)
    head = ["G21 G17 G90 G40", "T1 M6", f"G0 {at}", "Z0."]
    tail = ["G90 G0 Z50.", "M30"]
    sub = ["G91 G1 Z-2. F200.", "G90", *body]
    lines = {
        "plain": lambda: [*head, *(line for _ in DEPTHS for line in sub), *tail],
        "Fanuc": lambda: ["%", "O1000 (PART)", *head, "M98 P2000 L3", *tail, "O2000", *sub, "M99", "%"],
        "Haas": lambda: ["%", "O01000", "G103 P1", *head, "M97 P50 L3", *tail, "N50 " + sub[0], *sub[1:], "M99", "%"],
        "Mazak": lambda: ["O1", *head, "#1=3", "WHILE[#1GT0]DO1", *sub, "#1=#1-1", "END1", *tail],
        "Okuma": lambda: ["$PART.MIN%", "O1", *head, "CALL O2 Q3", *tail, "O2", *sub, "RTS"],
        "LinuxCNC": lambda: ["o1 sub", *sub, "o1 endsub", *head, "o2 repeat [3]", "o1 call", "o2 endrepeat", *tail],
        "Siemens": lambda: [
            "%_N_PART_MPF", ";$PATH=/_N_WKS_DIR", 'MSG("PART") ; first', *head, "L2 P3", *tail,
            "%_N_L2_SPF", *sub, "M17",
        ],
    }[family.partition(",")[0]]()  # fmt: skip
    return "\n".join(lines) + "\n"


FAMILIES = (
    "Fanuc", "Haas", "Mazak", "Okuma", "LinuxCNC", "Siemens", "Siemens, all rounded", "Siemens, polar",
    "Heidenhain", "Heidenhain ISO",
)  # fmt: skip
