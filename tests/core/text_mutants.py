# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of a program's text: one number, or the order of lines, changed at a time."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

_NUMBER = re.compile(rb"([A-Za-z]?)([ \t]*)([-+]?)([0-9]+\.?[0-9]*|\.[0-9]+)")
_COMMENT = re.compile(rb"\([^()]*\)|;.*")
_NAME = re.compile(rb"[Nn][ \t]*[0-9]+|^[ \t]*/[1-9]?")
_PLACES = b"XYIJR"
_DIRECTIONS = (1, 2, 3, 5)


class Mutant(NamedTuple):
    """A text with one change.

    Parameters
    ----------
    data : bytes
        Never the text itself.
    description : str
        What was changed, with the line from 1.
    kind : str
        "place" where a coordinate in the plane or the sense of a curve was changed, or lines that hold nothing else
        were deleted, doubled or exchanged: the surface tells whether that does harm. "word" for everything else.
    lines : tuple of int
        Lines of the text that it concerns, from 0.
    """

    data: bytes
    description: str
    kind: str
    lines: tuple[int, ...]


def mutants(data: bytes, seed: int, count: int) -> Iterator[Mutant]:
    """Mutants of a text, drawn at random."""
    random = np.random.default_rng(seed)
    lines = data.splitlines(keepends=True)
    made = 0
    while made < count:
        i = int(random.integers(len(lines)))
        done = _number(lines, i, random) if random.random() < 0.7 else _order(lines, i, random)
        if done is None:
            continue
        changed, what, kind = done
        text = b"".join(changed)
        if text != data:
            made += 1
            both = (i, i + 1) if what.endswith("next") else (i,)
            yield Mutant(text, f"line {i + 1}: {what}", kind, both)


def _number(lines: list[bytes], i: int, random: np.random.Generator) -> tuple[list[bytes], str, str] | None:
    """One number of a line by one in its last digit, ten times as large or small, or with another sign."""
    numbers = list(_NUMBER.finditer(lines[i]))
    if not numbers:
        return None
    found = numbers[int(random.integers(len(numbers)))]
    letter, blank, sign, digits = found.groups()
    how = int(random.integers(4))
    if how == 0:
        sign = b"" if sign == b"-" else b"-"
    elif how == 1:
        last = re.search(rb"[0-9](?=\.?$)", digits)
        k = last.start()
        digit = (digits[k] - 48 + int(random.choice([-1, 1]))) % 10
        digits = digits[:k] + str(digit).encode() + digits[k + 1 :]
    elif how == 2:
        whole, point, part = digits.partition(b".")
        digits = whole + (part[:1] or b"0") + point + part[1:]
    else:
        k = int(random.integers(len(digits)))
        if digits[k : k + 1] == b".":
            return None
        digits = digits[:k] + str(int(random.integers(10))).encode() + digits[k + 1 :]
    new = letter + blank + sign + digits
    old = found.group()
    inside = any(c.start() <= found.start() < c.end() for c in _COMMENT.finditer(lines[i]))
    if not inside and float(sign + digits) == float(found[3] + found[4]):
        # The same number in other digits is no mutant.
        return None
    kind = "word"
    if not inside and letter.upper() in (b"X", b"Y", b"I", b"J", b"R"):
        kind = "place"
    elif not inside and letter.upper() in (b"P", b"Q") and _splines(lines[i]):
        kind = "place"
    elif not inside and letter.upper() == b"G":
        was, now = float(found[3] + found[4]), float(sign + digits)
        if was in _DIRECTIONS and now in _DIRECTIONS:
            kind = "place"
    text = lines[i][: found.start()] + new + lines[i][found.end() :]
    return [*lines[:i], text, *lines[i + 1 :]], f"{old.decode('latin-1')} to {new.decode('latin-1')}", kind


def _order(lines: list[bytes], i: int, random: np.random.Generator) -> tuple[list[bytes], str, str] | None:
    """A line deleted, doubled, or exchanged with the next."""
    how = int(random.integers(3))
    shown = lines[i].strip().decode("latin-1")
    # A number names a move, and goes with it.
    bare = [_NAME.sub(b"", line) for line in lines[i : i + 2]]
    if how == 0:
        return lines[:i] + lines[i + 1 :], f"'{shown}' deleted", _kind(bare[0], (0, *_DIRECTIONS))
    if how == 1:
        return lines[: i + 1] + lines[i:], f"'{shown}' doubled", _kind(lines[i], (0, *_DIRECTIONS))
    if i + 1 == len(lines):
        return None
    kind = "place" if all(_kind(line, _DIRECTIONS) == "place" for line in bare) else "word"
    return [*lines[:i], lines[i + 1], lines[i], *lines[i + 2 :]], f"'{shown}' exchanged with the next", kind


def _splines(line: bytes) -> bool:
    """Whether P and Q of a line are those of a spline."""
    return re.search(rb"[Pp][ \t]*[-+.0-9]", line) is not None and re.search(rb"[Qq][ \t]*[-+.0-9]", line) is not None


def _kind(line: bytes, codes: tuple[int, ...]) -> str:
    """ "place" of a line that holds a place in the plane, with or without one of these G codes, and nothing else."""
    letters = _PLACES + (b"PQ" if _splines(line) else b"")

    def keep(found: re.Match[bytes]) -> bytes:
        place = found[1] and found[1].upper() in letters
        path = found[1].upper() == b"G" and float(found[4]) in codes
        return b"" if place or path else found.group()

    return "word" if _NUMBER.sub(keep, line).strip(b" \t\r\n*") else "place"
