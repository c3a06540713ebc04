# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of measurement files, one a format, from made-up points; and mutations that damage them."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Part:
    """Made-up measured part: ball centres, nominal points and normals (n, 3), ball radius, names of the points."""

    centres: np.ndarray
    nominal: np.ndarray
    normals: np.ndarray
    radius: float
    names: tuple[str, ...]

    @property
    def contact(self) -> np.ndarray:
        """What the ball touches: its centre less radius times normal."""
        return self.centres - self.radius * self.normals

    @property
    def deviations(self) -> np.ndarray:
        return ((self.contact - self.nominal) * self.normals).sum(axis=1)


def ellipse(n: int = 12, *, radius: float = 1.5, seed: int = 0, decimals: int | None = 5) -> Part:
    """Points on a slightly wrong ellipse of half axes 30 and 20 at z = -4, touched along its normals."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 2 * np.pi, n, endpoint=False) + 0.1
    nominal = np.column_stack([30 * np.cos(t), 20 * np.sin(t), np.full(n, -4.0)])
    normals = np.column_stack([np.cos(t) / 30, np.sin(t) / 20, np.zeros(n)])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    centres = nominal + (radius + rng.normal(0.03, 0.01, n))[:, None] * normals
    if decimals is not None:
        nominal, centres = np.round(nominal, decimals), np.round(centres, decimals)
    return Part(centres, nominal, normals, radius, tuple(f"P{k}" for k in range(1, n + 1)))


# --- MSR --------------------------------------------------------------------------------------------------


def msr(
    part: Part,
    *,
    rotations: tuple[np.ndarray, ...] = (),
    angles: tuple[tuple[float, float, float], ...] = (),
    shifts: tuple[tuple[float, float, float], ...] = (),
    dense: bool = False,
    digits: int = 9,
    ending: str = "\n",
) -> str:
    """MSR file; with `rotations` R and `shifts` t the points are written as R^T (p - t) after their G330 line."""
    lines = ["START"]
    groups = np.array_split(np.arange(len(part.centres)), max(1, len(rotations)))
    for k, rows in enumerate(groups):
        turn, shift = np.eye(3), np.zeros(3)
        if rotations:
            turn, shift = rotations[k], np.array(shifts[k])
            words = zip("ABCXYZ", (*angles[k], *shifts[k]), strict=True)
            lines.append(f"G330 N{rows[0] if len(rows) else 0} " + " ".join(f"{c}{v:.{digits}f}" for c, v in words))
            lines[-1] += " I0 R0"
        for row in rows:
            p, n, c = (part.nominal[row] - shift) @ turn, part.normals[row] @ turn, (part.centres[row] - shift) @ turn
            for code, letters, numbers, tail in (
                ("G800", "XYZIJK", (*p, *n), ("O0", "U0.01", "L-0.01")),
                ("G801", "XYZR", (*c, part.radius), ()),
            ):
                words = [f"{a}{v:.{digits}f}" for a, v in zip(letters, numbers, strict=True)]
                blank = "" if dense else " "
                lines.append(f"{code}{blank}N{row + 1}{blank}" + blank.join((*words, *tail)))
    return ending.join([*lines, "END", ""])


# --- damage -----------------------------------------------------------------------------------------------

_SPICE = (
    b"\x00", b"\xff", b"\xc6", b"\xef\xbb\xbf", b"\r", b"\n", b"\n\n", b"\x1a", b"'", b'"', b"<", b"&", b">", b"$",
    b"nan", b"inf", b"-inf", b"1e999", b"-1e308", b"1e-320", b"9" * 400, b"0x10", b"1_0", b"--1", b"+", b"-", b".",
    b",", b";", b"(", b")", b"[", b"]", b":", b"=", b"/", b"#", b"****", b"1.#QNAN", b"1,5", b"1.2.3", b" ", b"\t",
    b"\xe2\x88\x92", b"\xd9\xa3", b"\xc2\xa0", b"0", b"-0.0", b"18446744073709551616", b"-5", b"END", b"START",
    b"<!DOCTYPE a [<!ENTITY b 'c'>]>", b"&b;", b"<!-- -->", b"<![CDATA[1]]>", b"</Points>", b"INCH", b"MM", b"CART",
)  # fmt: skip


def damaged(data: bytes, random: random.Random) -> bytes:
    """The same file after one to four accidents: bytes and lines changed, lost, doubled, swapped, cut off."""
    for _ in range(random.choice((1, 1, 1, 2, 3, 4))):
        data = random.choice(_ACCIDENTS)(data, random)
    return data


def _place(data: bytes, random: random.Random) -> int:
    return random.randrange(len(data) + 1)


def _flip(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + bytes([random.randrange(256)]) + data[at + 1 :]


def _spice(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + random.choice(_SPICE) + data[at + random.choice((0, 0, 1, 5)) :]


def _cut(data: bytes, random: random.Random) -> bytes:
    return data[: _place(data, random)]


def _lose(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + data[at + random.choice((1, 2, 8, 60, 500)) :]


def _double(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    piece = data[at : at + random.choice((1, 3, 20, 200))]
    return data[:at] + piece * random.choice((2, 2, 3, 50)) + data[at:]


def _lines(data: bytes, random: random.Random) -> bytes:
    lines = data.split(b"\n")
    a, b = random.randrange(len(lines)), random.randrange(len(lines))
    kind = random.randrange(4)
    if kind == 0:
        lines[a], lines[b] = lines[b], lines[a]
    elif kind == 1:
        del lines[a]
    elif kind == 2:
        lines.insert(a, lines[b])
    else:
        lines[a] = lines[a] + lines[b]
    return b"\n".join(lines)


def _number(data: bytes, random: random.Random) -> bytes:
    """Put something else in the place of a digit: most accidents elsewhere end at the first check."""
    places = [k for k, byte in enumerate(data) if 48 <= byte <= 57]
    if not places:
        return data
    at = random.choice(places)
    return (
        data[:at]
        + random.choice((b"e", b"E9", b"", b"-", b".", b"0", b"99999", b" ", b"nan", b"1e400"))
        + data[at + 1 :]
    )


_ACCIDENTS: tuple[Callable[[bytes, random.Random], bytes], ...] = (_flip, _spice, _cut, _lose, _double, _lines, _number)
