# SPDX-License-Identifier: LGPL-2.1-or-later
"""A second, small reader of ISO program text, for the proof; it shares no code with the one that wrote the text.

The text is cut into pieces of whole lines, letters are found by a table, numbers are summed digit by digit, and
modal groups are carried forward as whole columns. What a control would compute (variables, expressions) makes the
coordinate unknown (NaN); nothing is refused here.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bools, Bytes, CompactColumns, Floats, Ints, ReadOnlyArrays
from millcorr.nc.toolpath import COLUMNS, Kind, Plane, Toolpath, named_tool
from millcorr.tolerances import ARITHMETIC

from .corner_moves import broken, complex_of, way
from .unrolled import ADDRESS, unrolled

_PIECE = 1 << 18
"""Bytes of text that are taken apart at once: columns of single digits then fit into the cache."""
_BY_POINT, _TANGENT = 90000, 90001
"""Motion of Siemens' CIP and CT."""
_EXACT_DIGITS = 15
"""A number of so many digits is a whole float64 over a power of ten, so that one division rounds it right."""
_PATHS = {0: Kind.RAPID, 10: Kind.LINE, 20: Kind.ARC, 30: Kind.ARC, 50: Kind.CUBIC}
_NO_PATH = (330, *range(380, 390), 730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890)
_CYCLES = (730, 740, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890)
_NO_TARGET = (
    40, 71, 100, 110, 281, 301, 500, 501, 510, 511, 520, 650, 660, 680, 682, 683, 684, 685,
    920, 921, 922, 923, 925, 1070,
)  # fmt: skip
"""Tenths of G codes beside which axis words are no target: dwell, frames, macros."""
_LOCAL = 520
_POLAR = ("RP", "RP=IC", "AP", "AP=AC", "AP=IC")
_OFFSETS = (*range(540, 600), 1540, *range(1100, 1300, 10), 5000, *range(5050, 6000, 10))
_FRAMES = (
    ((920, 923), (921, 922)),
    ((680, 681, 682, 683, 684), (690, 691)),
    ((685,), (695,)),
    ((925,), ()),
    ((2540,), (2550,)),
    ((510,), (500,)),
    ((511,), (501,)),
    ((1010,), (1000,)),
    ((121,), (131,)),
    ((1120,), (1130,)),
    ((434, 435), (430, 490)),
    ((2340,), (2350,)),
    ((660,), (670,)),
)
"""Codes that put places elsewhere, and those that end it."""
_HOME = (280, 300)
_MACHINE = (530, 1530)
FAMILIAR = frozenset(
    [
        *_PATHS, *_CYCLES, *_NO_TARGET, *_OFFSETS, *_HOME, *_MACHINE, *(c for on, off in _FRAMES for c in (*on, *off)),
        170, 180, 190, 200, 210, 700, 710, 7000, 7100, 900, 901, 910, 911, 400, 410, 411, 420, 421, 431, 432, 440,
        800, 930, 940, 950, 980, 990, 70, 80, 150, 160, 51, 90, 600, 601, 610, 611, 620, 630, 640, 960, 970,
        1030, 1870, 4500, 4510, 6010, 6020, 6030, 6410, 6420, 6430, 6440, 6450,
    ]
)  # fmt: skip
"""Codes behind which the machine stands where the text says; behind any other it may stand anywhere."""

_SKIPPED = re.compile(
    rb'\([^()\n]*\)|;[^\n]*|((?<![A-Z_])T(?:\d*[ \t]*=)?[ \t]*)?"([^"\n]*)"'
    rb'|(?<![A-Z_])T\d*[ \t]*=[ \t]*([^\s"=(;]+)'
)
"""Comments, texts, and tools that are called by a name."""
_BLANKS = b" \t\r\x0b\x0c\x1a"
_PERCENT = re.compile(rb"(?m)^(?:[Nn]\d+)?%[^\n]*|\A\$[^\n]*%(?=\n)")
_OPENING = re.compile(rb"(?m)^((?:N\d+)?)(?:/[1-9]?|:(?=\d))")
_ODD_WORD = re.compile(rb"([A-Z\xc0-\xde])([-+]?(?:\d+\.?\d*|\.\d+)(?![\d.=#])|[-+]?#|=)")

_DIGIT, _POINT, _SIGN, _OTHER, _LETTER, _NEWLINE = range(6)
_CLASS = np.full(256, _OTHER, np.uint8)
_CLASS[ord("0") : ord("9") + 1] = _DIGIT
_CLASS[ord(".")] = _POINT
_CLASS[[ord("+"), ord("-")]] = _SIGN
_CLASS[ord("A") : ord("Z") + 1] = _LETTER
_CLASS[[ord(c) for c in ADDRESS.values()]] = _LETTER
_CLASS[ord("\n")] = _NEWLINE
_POWERS = 10.0 ** np.arange(_EXACT_DIGITS + 1)


@dataclass(frozen=True, eq=False, slots=True)
class PlainMoves(CompactColumns):
    """Moves of a program's text in their order, up to its end (M2, M30, M99).

    Parameters
    ----------
    kind : (n,) int64
        `Kind`; a canned cycle, a G28 and a move before any motion code are `Kind.RAPID`.
    start, end : (n, 3) float64
        x, y, z in mm; NaN where the text has not stated them, or where the control computes them.
    centre : (n, 2) float64
        Centre of an arc in its plane (first, second axis), mm; NaN for other moves.
    sweep : (n,) float64
        Signed angle of an arc in rad, positive for G3, more than a turn with P; 0 for other moves, NaN for an arc
        whose words give no centre.
    control : (n, 4) float64
        Inner points x1, y1, x2, y2 of a G5 in mm; NaN for other moves.
    plane : (n,) int64
        17, 18 or 19.
    feed : (n,) float64
        mm/s; NaN for rapids, where none was stated, and under G93 and G95.
    tool : (n,) int64
        T in the spindle, -1 before any.
    compensation : (n,) int64
        0 for G40, 1 for G41, -1 for G42.
    offset : (n,) int64
        Work offset: tenths of its G code times 1000, plus P (G54.1) or H (G15) where they choose; 540000 at first.
    line : (n,) int64
        Block of the text, from 0, not decreasing: its line where every line runs once.
    """

    kind: Ints
    start: Floats
    end: Floats
    centre: Floats
    sweep: Floats
    control: Floats
    plane: Ints
    feed: Floats
    tool: Ints
    compensation: Ints
    offset: Ints
    line: Ints

    def __len__(self) -> int:
        return len(self.kind)

    def toolpath(self) -> Toolpath:
        """The same moves as a `Toolpath`; arcs out of the XY plane, whose centre nothing asks for, have none."""
        flat = (self.plane == Plane.XY) & (self.kind == Kind.ARC)
        centre = np.where(flat[:, None], np.column_stack([self.centre, self.start[:, 2]]), np.nan)
        arrays = {name: getattr(self, name) for name in COLUMNS if name not in ("centre", "source")}
        return Toolpath(**arrays, centre=centre, source=self.line)


@dataclass(frozen=True, eq=False, slots=True)
class Reading(ReadOnlyArrays):
    """A text read to its moves, and what the proof wants of its lines.

    Parameters
    ----------
    text : bytes
        The text as it runs, a line a block.
    starts : (lines + 1,) int64
        Offset of every line in it, and its length.
    plain : bytes
        The same with the numbers that the program computes, in words of one letter.
    plain_starts : (lines + 1,) int64
        Offset of every line in it, and its length.
    line : (lines,) int64
        Line of the file of every block.
    motion : (lines,) int64
        Tenths of the motion code in force behind each line, -1 before any.
    in_plane : (lines,) bool
        X or Y is stated.
    feed_word : (lines,) float64
        Number of the F word in force behind each line.
    corner_feed : (moves,) float64
        Number of an F word for corners that have a feed of their own; NaN for other moves.
    moves : PlainMoves
    """

    text: bytes
    starts: Ints
    plain: bytes
    plain_starts: Ints
    line: Ints
    motion: Ints
    in_plane: Bools
    feed_word: Floats
    corner_feed: Floats
    moves: PlainMoves


def line_starts(data: bytes) -> Ints:
    """Offset of every line of a text, and its length, (lines + 1,); CR ends a line only where there is no LF."""
    end = b"\n" if b"\n" in data or b"\r" not in data else b"\r"
    starts = np.flatnonzero(np.frombuffer(data, np.uint8) == ord(end)) + 1
    closed = len(starts) > 0 and starts[-1] == len(data)
    return np.concatenate([[0], starts, [] if closed else [len(data)]]).astype(np.int64)


def read(data: bytes, beside: Sequence[tuple[str, bytes]] = ()) -> Reading:
    """Read a program's text: its moves and what the proof wants of its lines."""
    starts = line_starts(data)
    progress.step()
    found = unrolled(data, starts, beside)
    if found is None:
        lines = np.arange(len(starts) - 1)
        return _Follower(data, starts, data, starts, lines, _words(data, starts)).reading()
    raw, raw_starts = _joined(found.raw)
    plain, plain_starts = _joined(found.plain)
    words = _pieces(plain, plain_starts, len(found.line))

    def upto(block: int, words: tuple[Bytes, Floats, Ints]) -> _Follower:
        return _Follower(raw, raw_starts[: block + 1], plain, plain_starts, found.line, words)

    words = _with_ends_of_angles(_with_polar_ends(words, upto, len(found.line)), upto)
    return upto(len(found.line), words).reading()


def _with_polar_ends(
    words: tuple[Bytes, Floats, Ints], upto: Callable[[int, tuple[Bytes, Floats, Ints]], _Follower], blocks: int
) -> tuple[Bytes, Floats, Ints]:
    """Words in which lines with Siemens' polar positions state their ends, and arcs their centre, too."""
    letter, value, line = words
    names = {ord(c): name for name, c in ADDRESS.items()}
    polar = np.isin(letter, [ord(ADDRESS[name]) for name in (*_POLAR, "POLE")])
    if not polar[~np.isin(letter, ord(ADDRESS["POLE"]))].any():
        return words
    whole = upto(blocks, words)
    flat = whole.group({170: 17, 180: 18, 190: 19}, 17) == 17
    inch = whole.group({200: 20, 210: 21, 700: 20, 710: 21, 7000: 20, 7100: 21}, 21) == 20
    counted = whole.group({900: 90, 910: 91}, 90) == 91
    bent = np.isin(whole.group({c: c for c in (*_NO_PATH, *_PATHS)}, -1), (20, 30))
    moved = np.cumsum(whole.having(*_OFFSETS) | (False if (frame := whole.of("FRAME")) is None else frame[0]))
    more: list[tuple[int, float, int]] = []

    def before_block(block: int) -> tuple[Bytes, Floats, Ints]:
        """Words of the lines before one, with those found so far."""
        found = np.array(more, np.float64).reshape(-1, 3)
        lines = np.concatenate([line, found[:, 2].astype(line.dtype)])
        order = np.argsort(lines, kind="stable")
        order = order[lines[order] < block]
        letters = np.concatenate([letter, found[:, 0].astype(np.uint8)])
        return letters[order], np.concatenate([value, found[:, 1]])[order], lines[order]

    pole, defined, radius, angle, before = 0j, False, np.nan, np.nan, 0
    for block in np.unique(line[polar]).tolist():
        here = slice(*np.searchsorted(line, [block, block + 1]).tolist())
        said = {
            names.get(c, chr(c)): float(v) for c, v in zip(letter[here].tolist(), value[here].tolist(), strict=True)
        }
        scale = 25.4 if inch[block] else 1.0
        if defined and moved[block] != moved[before]:
            pole = complex(np.nan, np.nan)
        before = block
        if "POLE" in said:
            way = complex(said.get("PX", 0.0), said.get("PY", 0.0))
            how, by_angle = int(said["POLE"]), [name for name in _POLAR if name in said]
            if by_angle in (["RP", "AP"], ["RP", "AP=AC"]) and how and not {"PX", "PY"} & set(said):
                way = said["RP"] * np.exp(1j * np.radians(said[by_angle[1]]))
            elif by_angle or (how == 1 and not {"PX", "PY"} <= set(said)):
                way = complex(np.nan, np.nan)
            if not flat[block]:
                way = complex(np.nan, np.nan)
            if how == 0:
                follower = upto(block, _with_ends_of_angles(before_block(block), upto))
                shift = follower.shift(np.where(inch[:block], 25.4, 1.0))
                ends = follower.reading().moves.end
                pole = complex(*(ends[-1, :2] - shift[-1, :2])) if len(ends) else complex(np.nan, np.nan)
            pole, defined, radius, angle = (0j if how == 1 else pole) + way * scale, True, np.nan, np.nan
            continue
        radius = np.nan if "RP=IC" in said else said["RP"] * scale if "RP" in said else radius
        if "AP=IC" in said:
            angle += said["AP=IC"]
        elif "AP=AC" in said or "AP" in said:
            angle = said["AP=AC"] if "AP=AC" in said else np.nan if counted[block] else said["AP"]
        if {"X", "Y", "X=AC", "X=IC", "Y=AC", "Y=IC"} & set(said):
            continue
        known = radius > 0 and flat[block]
        end = (pole + radius * np.exp(1j * np.radians(angle)) if known else complex(np.nan, np.nan)) / scale
        more += [(ord(ADDRESS["X=AC"]), end.real, block), (ord(ADDRESS["Y=AC"]), end.imag, block)]
        if bent[block] and not {"I", "J", "K", "R", "I=AC", "J=AC", "K=AC", "AR"} & set(said):
            centre = pole / scale
            more += [(ord(ADDRESS["I=AC"]), centre.real, block), (ord(ADDRESS["J=AC"]), centre.imag, block)]
    return before_block(blocks)


def _with_ends_of_angles(
    words: tuple[Bytes, Floats, Ints], upto: Callable[[int, tuple[Bytes, Floats, Ints]], _Follower]
) -> tuple[Bytes, Floats, Ints]:
    """Words in which lines that state an angle state their ends, too."""
    letter, value, line = words
    angle, x, y = (ord(ADDRESS[name]) for name in ("ANG", "X=AC", "Y=AC"))
    angled = np.unique(line[letter == angle]).tolist()
    for k, block in enumerate(angled):
        earlier = upto(block, tuple(column[line < block] for column in (letter, value, line)))
        if not block or earlier.group({900: 90, 910: 91}, 90)[-1] == 91:
            continue
        scale = 25.4 if earlier.group({200: 20, 210: 21, 700: 20, 710: 21, 7000: 20, 7100: 21}, 21)[-1] == 20 else 1.0
        moved = earlier.shift(np.full(block, scale))[-1]
        moves = earlier.reading().moves
        if not len(moves):
            continue
        start = (complex(*moves.end[-1, :2]) - complex(*moved[:2])) / scale
        said = [
            {c: float(v) for c, v in zip(letter[line == b].tolist(), value[line == b].tolist(), strict=True)}
            for b in (block, angled[k + 1] if k + 1 < len(angled) else block)
        ]
        way = np.exp(1j * np.radians(said[0][angle]))
        stated = [said[0].get(ord(c), said[0].get(own)) for c, own in (("X", x), ("Y", y))]
        if stated == [None, None]:
            # Seen along the first line, the second one comes back to it.
            onward = np.exp(1j * np.radians(said[1][angle])) / way
            target = (complex(said[1].get(ord("X"), np.nan), said[1].get(ord("Y"), np.nan)) - start) / way
            share = target.real - target.imag * onward.real / onward.imag if abs(onward.imag) > ARITHMETIC else np.nan
        elif stated[0] is not None and stated[1] is None and abs(way.real) > ARITHMETIC:
            share = (stated[0] - start.real) / way.real
        elif stated[1] is not None and stated[0] is None and abs(way.imag) > ARITHMETIC:
            share = (stated[1] - start.imag) / way.imag
        else:
            continue
        end = start + way * share
        more = [(c, v) for c, own, v in ((x, stated[0], end.real), (y, stated[1], end.imag)) if own is None]
        place = int(np.searchsorted(line, block + 1))
        letter = np.insert(letter, place, [c for c, _ in more]).astype(np.uint8)
        value = np.insert(value, place, [v for _, v in more])
        line = np.insert(line, place, [block] * len(more))
    return letter, value, line


def _joined(lines: Sequence[bytes]) -> tuple[bytes, Ints]:
    """Lines one behind another, and where each begins."""
    lengths = np.array([len(line) for line in lines], np.int64)
    return b"".join(lines), np.concatenate([[0], np.cumsum(lengths)])


# -- words ----------------------------------------------------------------------------------------------------


def _words(data: bytes, starts: Ints) -> tuple[Bytes, Floats, Ints]:
    """Letter (ASCII, upper case), number (NaN where computed) and line of every word of the program."""
    lines = len(starts) - 1
    marks = [int(np.searchsorted(starts, m.start(), "right")) - 1 for m in re.finditer(rb"%", data)]
    marks = [i for i in dict.fromkeys(marks) if data[starts[i] : starts[i + 1]].lstrip().startswith(b"%")]
    if len(marks) > 1 and not data[: starts[marks[0]]].removeprefix(b"\xef\xbb\xbf").strip():
        lines = marks[1]
    letter, value, line = _pieces(data, starts, lines)
    ends = line[(letter == ord("M")) & np.isin(value, (2, 30, 99))]
    keep = slice(0, int(np.searchsorted(line, ends[0], "right")) if len(ends) else len(line))
    return letter[keep], value[keep], line[keep]


def _pieces(data: bytes, starts: Ints, lines: int) -> tuple[Bytes, Floats, Ints]:
    """Words of the first lines of a text."""
    pieces = []
    first = 0
    while first < lines:
        progress.step()
        last = max(int(np.searchsorted(starts, starts[first] + _PIECE)), first + 1)
        last = min(last, lines)
        letter, value, line = _piece(data[starts[first] : starts[last]])
        pieces.append((letter, value, line.astype(np.int32) + first))
        first = last
    if not pieces:
        return np.empty(0, np.uint8), np.empty(0), np.empty(0, np.int64)
    letter, value, line = (np.concatenate(column) for column in zip(*pieces, strict=True))
    return letter, value, line


def _piece(text: bytes) -> tuple[Bytes, Floats, Ints]:
    """Words of some whole lines; lines count from 0."""
    text = text.removeprefix(b"\xef\xbb\xbf").upper()
    if b"\n" not in text:
        text = text.replace(b"\r", b"\n")
    if any(mark in text for mark in (b"(", b";", b'"', b"=")):
        text = _SKIPPED.sub(_numbered_tool, text)
    text = text.translate(None, _BLANKS)
    if b"%" in text or b"$" in text:
        text = _PERCENT.sub(b"", text)
    if b"/" in text or b":" in text:
        text = _OPENING.sub(lambda m: m[1] + (b"O" if m[0].endswith(b":") else b""), text)
    # Every character belongs to a mark: the letter or the newline before it. A newline begins its line.
    text = b"\n" + text.replace(b"*\n", b"\n").removesuffix(b"*") + b"\n"
    buffer = np.frombuffer(text, np.uint8)
    kind = _CLASS[buffer]
    marked = kind >= _LETTER
    mark = np.flatnonzero(marked)
    owner = np.cumsum(marked, dtype=np.int32) - np.int32(1)
    newline = kind[mark] == _NEWLINE
    line_of = np.cumsum(newline) - 1
    word = np.flatnonzero(~newline)
    follows = np.append(mark[1:], len(buffer))

    at = np.flatnonzero(kind == _DIGIT)
    own = owner[at]
    digits = np.bincount(own, minlength=len(mark))
    power = np.cumsum(digits)[own] - np.arange(1, len(at) + 1)
    total = np.bincount(own, (buffer[at] - 48.0) * _POWERS[np.minimum(power, _EXACT_DIGITS)], len(mark))
    points = np.flatnonzero(kind == _POINT)
    pointed = np.bincount(owner[points], minlength=len(mark))
    decimals = np.zeros(len(mark), np.int64)
    decimals[owner[points]] = follows[owner[points]] - points - 1
    signs = np.flatnonzero(kind == _SIGN)
    value = total / _POWERS[np.minimum(decimals, _EXACT_DIGITS)]
    value[owner[signs[buffer[signs] == ord("-")]]] *= -1.0
    for i in word[digits[word] > _EXACT_DIGITS].tolist():
        try:
            value[i] = float(text[mark[i] + 1 : follows[i]])
        except ValueError:
            value[i] = np.nan

    # A line is plain where every letter has one number: sign in front, one point at most, nothing else between.
    wrong = np.where(newline, follows - mark > 1, (digits == 0) | (pointed > 1))
    places = (np.flatnonzero(kind == _OTHER), signs[kind[signs - 1] != _LETTER])
    odd = np.unique(np.concatenate([line_of[wrong], *(line_of[owner[some]] for some in places)]))
    letter, number, line = buffer[mark[word]], value[word], line_of[word]
    if not len(odd):
        return letter, number, line
    plain = ~np.isin(line, odd)
    rows = text.split(b"\n")
    more = [(*w, int(i)) for i in odd for w in _odd_words(rows[i + 1])]
    extra = np.array(more, np.float64).reshape(-1, 3)
    letter = np.concatenate([letter[plain], extra[:, 0].astype(np.uint8)])
    number = np.concatenate([number[plain], extra[:, 1]])
    line = np.concatenate([line[plain], extra[:, 2].astype(np.int64)])
    order = np.argsort(line, kind="stable")
    return letter[order], number[order], line[order]


def _numbered_tool(found: re.Match[bytes]) -> bytes:
    """T word of a tool that is called by a name; nothing in place of what is skipped."""
    name = found[2] if found[1] else found[3]
    return b"T%d" % named_tool(name) if name else b""


def _odd_words(text: bytes) -> list[tuple[int, float]]:
    """Words of a line that holds more than letters with numbers; NaN for a number that the control computes."""
    while (shorter := re.sub(rb"\[[^\[\]]*\]|<[^<>]*>|#+\d+", b"#", text)) != text:
        text = shorter
    if re.search(rb"[A-Z_]{2}", text):
        # A cycle by its name, marked as a call that is not followed.
        return [(ord("M"), 98.0)] if text.startswith(b"M98") else []
    words = []
    for m in _ODD_WORD.finditer(text):
        try:
            words.append((m[1][0], float(m[2])))
        except ValueError:
            words.append((m[1][0], float("nan")))
    return words


# -- moves ----------------------------------------------------------------------------------------------------


def _held(stated: Bools, value: NDArray[Any], initial: float) -> NDArray[Any]:
    """Value last stated at or before each line."""
    places = np.flatnonzero(stated)
    if not len(places):
        return np.broadcast_to(value.dtype.type(initial), len(stated))
    runs = np.diff(np.concatenate([[0], places, [len(stated)]]))
    return np.repeat(np.concatenate([[initial], value[places]]), runs)


class _Follower:
    """Columns of one text, carried through the modal groups."""

    def __init__(
        self,
        text: bytes,
        starts: Ints,
        plain: bytes,
        plain_starts: Ints,
        file_line: Ints,
        words: tuple[Bytes, Floats, Ints],
    ) -> None:
        self.text, self.starts, self.plain, self.plain_starts = text, starts, plain, plain_starts
        self.file_line = file_line
        self.lines = len(starts) - 1
        letter, value, line = words
        there = np.bincount(letter, minlength=256)
        names = {c: ord(c) for c in "GMXYZIJKRFTHPQLABC"} | {
            name: ord(c) for name, c in ADDRESS.items() if there[ord(c)]
        }
        self.words = {}
        for name, sign in names.items():
            rows = np.flatnonzero(letter == sign) if there[sign] else np.empty(0, np.int64)
            self.words[name] = line[rows], value[rows]
        where, code = self.words["G"]
        known = np.isfinite(code)
        self.code, self.code_line = np.rint(code[known] * 10).astype(np.int64), where[known]
        self.present = frozenset(np.unique(self.code).tolist())

    def column(self, letter: str) -> tuple[Bools, Floats]:
        progress.step()
        line, value = self.words[letter]
        if not len(line):
            return np.broadcast_to(np.False_, self.lines), np.broadcast_to(np.nan, self.lines)
        stated, column = np.zeros(self.lines, np.bool_), np.full(self.lines, np.nan)
        stated[line], column[line] = True, value
        return stated, column

    def naming(self, letters: str) -> Bools:
        """Lines with a word of these letters."""
        out = np.zeros(self.lines, np.bool_)
        for letter in letters:
            out[self.words[letter][0]] = True
        return out

    def at(self, letter: str, lines: Ints) -> tuple[Bools, Floats]:
        """Whether some lines state a letter, and its number there, the last where there are two."""
        line, value = self.words[letter]
        place = np.searchsorted(line, lines, "right") - 1
        if not len(line):
            return np.zeros(len(lines), np.bool_), np.full(len(lines), np.nan)
        stated: Bools = (place >= 0) & (line[place] == lines)
        return stated, np.where(stated, value[place], np.nan)

    def of(self, name: str) -> tuple[Bools, Floats] | None:
        """Column of a named address; None where the text has none."""
        return self.column(name) if name in self.words else None

    def having(self, *codes: int) -> Bools:
        out = np.zeros(self.lines, np.bool_)
        if not self.present.isdisjoint(codes):
            out[self.code_line[np.isin(self.code, codes)]] = True
        return out

    def group(self, members: dict[int, int], initial: int, without: Bools | None = None) -> Ints:
        progress.step()
        stated, value = np.zeros(self.lines, np.bool_), np.zeros(self.lines, np.int64)
        for code, meaning in members.items():
            here = self.having(code) if without is None else self.having(code) & ~without
            stated |= here
            value[here] = meaning
        return _held(stated, value, initial)

    def reading(self) -> Reading:
        axes = [self.column(c) for c in "XYZ"]
        in_plane = axes[0][0] | axes[1][0]
        named = in_plane | axes[2][0]
        arcs_named = self.naming("IJKR")
        for name in ADDRESS:
            if name in self.words and name[0] in "XYZ":
                named = named | self.column(name)[0]
            elif name in self.words and name.startswith(("I", "J", "K", "AR")):
                arcs_named = arcs_named | self.column(name)[0]
        # G80 beside another motion code is a customary opening; the other one holds. A G5 with nothing to move to
        # tunes the control.
        motion = self.group({800: 800, **{c: c for c in _NO_PATH if c != 800}, **{c: c for c in _PATHS if c != 50}}, -1)
        cubic = self.having(50) & (named | arcs_named)
        if cubic.any():
            stated = cubic | self.having(*_NO_PATH, *_PATHS) & ~self.having(50)
            motion = _held(stated, np.where(cubic, 50, motion), -1)
        if (named_arc := self.of("ARC")) is not None:
            stated = named_arc[0] | self.having(*_NO_PATH, *_PATHS)
            motion = _held(stated, np.where(named_arc[0], _BY_POINT + np.nan_to_num(named_arc[1]), motion), -1)
            motion = motion.astype(np.int64)
        plane = self.group({170: 17, 180: 18, 190: 19}, 17)
        modal_absolute = self.group({900: 90, 910: 91}, 90) == 90
        absolute_arcs = self.group({901: 90, 911: 91}, 91) == 90
        # Okuma's G20 P and the like do not concern the unit; G70, G71 with I, J are hole patterns.
        unit = self.group({200: 20, 210: 21}, 21)
        if self.having(700, 710, 7000, 7100).any():
            patterns = self.naming("IJK") & self.having(700, 710)
            unit = self.group({200: 20, 210: 21, 700: 20, 710: 21, 7000: 20, 7100: 21}, 21, patterns)
        scale = np.where(unit == 20, 25.4, 1.0)

        home, target = self.having(*_HOME), ~self.having(*_NO_TARGET)
        if (framed := self.of("FRAME")) is not None:
            target &= ~framed[0]
        cycle = np.isin(motion, _CYCLES)
        offset, lost = self._frames()
        gone = self._called() | (home & ~named) | self._strange(named)
        machine = self.having(*_MACHINE)
        moving = np.flatnonzero(
            (target & (named | (np.isin(motion, (20, 30, _BY_POINT, _TANGENT)) & arcs_named))) | home
        )
        start, end = np.full((len(moving), 3), np.nan), np.empty((len(moving), 3))
        shift = self.shift(scale)
        endless = self._endless()
        # The columns and words of the axes, which most of a long text is, are not kept beside what follows from them.
        self.words |= dict.fromkeys("XYZ", (np.empty(0, np.int64), np.empty(0)))
        # A cycle that is repeated by increments ends where the control counts; under G99 it ends at R.
        repeated = cycle & ~modal_absolute & self.naming("KL")
        at_r = cycle & named & (self.group({980: 98, 990: 99}, 98) == 99)
        for a in range(3):
            stated, value = axes.pop(0)
            absolute = modal_absolute
            for way_of in ("IC", "AC"):
                if (own := self.of(f"{'XYZ'[a]}={way_of}")) is not None:
                    stated, value = stated | own[0], np.where(own[0], own[1], value)
                    absolute = np.where(own[0], way_of == "AC", absolute)
            unknown = gone | (endless & (a < 2))
            unknown |= (home | machine) & stated
            unknown |= at_r if a == 2 else repeated
            # The Z of a canned cycle is the bottom of its hole, not where it ends.
            stated = stated & (target & ~cycle if a == 2 else target)
            fixed = lost[:, a] | unknown | (stated & (absolute | np.isnan(value)))
            step = np.where(stated & ~fixed, value * scale, 0.0)
            base = np.where(stated & absolute & ~unknown, value * scale + shift[:, a], np.nan)
            at = _held(fixed, base, np.nan)
            if not absolute.all():
                sums = np.cumsum(step)
                at = at + sums - _held(fixed, sums, 0.0)
            end[:, a] = at[moving]
            start[:, a] = np.where((moving == 0) | lost[moving, a], np.nan, at[moving - 1])
        kind = np.zeros(len(moving), np.int64)
        kind[np.isin(motion[moving], (_BY_POINT, _TANGENT))] = Kind.ARC
        for code, meaning in _PATHS.items():
            kind[(motion[moving] == code) & ~home[moving]] = meaning
        centre, sweep = np.broadcast_to(np.nan, (len(kind), 2)), np.zeros(len(kind))
        arcs = np.flatnonzero(kind == Kind.ARC)
        if len(arcs):
            lines = moving[arcs]
            words = [(s, v * scale[lines]) for s, v in (self.at(c, lines) for c in "IJKR")]
            turns_stated, p = self.at("P", lines)
            turns = np.where(turns_stated, p, 1.0)
            if (more := self.of("TURN")) is not None:
                turns = np.where(more[0][lines], more[1][lines] + 1.0, turns)
            for axis, letter in enumerate("IJK"):
                own = self.of(f"{letter}=AC")
                if own is not None:
                    # As the way from where a centre counts from: the start, or the origin under G90.1.
                    from_start = np.where(absolute_arcs[lines], 0.0, start[arcs, axis])
                    s, v = own[0][lines], own[1][lines] * scale[lines] + shift[lines, axis] - from_start
                    words[axis] = (words[axis][0] | s, np.where(s, v, words[axis][1]))
                moved = absolute_arcs[lines] & (True if own is None else ~own[0][lines])
                words[axis] = (words[axis][0], words[axis][1] + np.where(moved, shift[lines, axis], 0.0))
            centre = np.full((len(kind), 2), np.nan)
            centre[arcs], sweep[arcs] = _arcs(
                start[arcs], end[arcs], plane[lines], motion[lines] == 20, words, absolute_arcs[lines], turns
            )
            self._named_arcs(kind, moving, start, end, plane, motion, scale, shift, centre, sweep)
        control = self._cubics(kind, moving, start, end, scale)
        feeding = self.group({930: 93, 940: 94, 950: 95}, 94)
        stated_f, f = self.column("F")
        changed = np.diff(feeding, prepend=94) != 0
        feed = _held(stated_f | changed, np.where(stated_f & (feeding == 94), f * scale / 60.0, np.nan), np.nan)[moving]
        corner_feed = np.broadcast_to(np.nan, len(moving))
        if wanted := self._wanted_corners(moving, kind, scale):
            row, columns = self._corners(wanted, moving, kind, start, end, centre, sweep, plane)
            kind, start, end, centre, sweep = columns
            corner_feed, per_minute = (self._corner_feeds(moving, row, unit) for unit in (np.ones(self.lines), scale))
            moving, control = moving[row], control[row]
            feed = np.where(np.isnan(per_minute), feed[row], per_minute / 60.0)
        moves = PlainMoves(
            kind,
            start,
            end,
            centre,
            sweep,
            control,
            plane[moving],
            np.where(kind == Kind.RAPID, np.nan, feed),
            self._tool()[moving],
            self.group({400: 0, 410: 1, 411: 1, 420: -1, 421: -1}, 0)[moving],
            offset[moving],
            moving,
        )
        return Reading(
            self.text,
            self.starts,
            self.plain,
            self.plain_starts,
            self.file_line,
            motion,
            in_plane,
            _held(stated_f, f, np.nan),
            corner_feed,
            moves,
        )

    def _corner_feeds(self, moving: Ints, row: Ints, scale: Floats) -> Floats:
        """Feed, in units of `scale`, of corners that have their own, by the line before them; NaN for other moves.

        `row` is the move that each one is or, from the second of equal ones on, whose corner it is.
        """
        feed = np.zeros(self.lines)
        if (modal := self.of("FRCM")) is not None:
            feed = _held(modal[0], modal[1] * scale, 0.0)
        if (once := self.of("FRC")) is not None:
            feed = np.where(once[0], once[1] * scale, feed)
        corner = np.diff(row, prepend=-1) == 0
        out: Floats = np.where(corner & (feed[moving[row]] != 0), feed[moving[row]], np.nan)
        return out

    def _wanted_corners(self, moving: Ints, kind: Ints, scale: Floats) -> dict[int, tuple[str, float]]:
        """What is to be made of the corners behind moves, by their rows."""
        wanted: dict[int, tuple[str, float]] = {}
        for name in ("RNDM", "RND", "CHR", "CHF"):
            column = self.of(name)
            if column is None:
                continue
            stated, size = column[0], column[1] * scale
            if name == "RNDM":
                held = _held(stated, size, 0.0)[moving]
                cuts = np.isin(kind, (Kind.LINE, Kind.ARC))
                rounds = np.flatnonzero((np.nan_to_num(held[:-1], nan=1.0) > 0) & cuts[:-1] & cuts[1:])
                wanted |= {n: ("RND", float(held[n])) for n in rounds.tolist()}
            else:
                wanted |= {n: (name, float(size[moving[n]])) for n in np.flatnonzero(stated[moving]).tolist()}
        return wanted

    def _corners(
        self,
        wanted: dict[int, tuple[str, float]],
        moving: Ints,
        kind: Ints,
        start: Floats,
        end: Floats,
        centre: Floats,
        sweep: Floats,
        plane: Ints,
    ) -> tuple[Ints, tuple[Ints, Floats, Floats, Floats, Floats]]:
        """Rows of the moves with those that corners add, and kind, start, end, centre, sweep of all."""
        rows = np.arange(len(kind))
        centre, sweep = np.array(centre), np.array(sweep)
        more = []
        for n in sorted(wanted):
            flat = n + 1 < len(kind) and bool(
                (plane[moving[[n, n + 1]]] == 17).all()
                and np.isin(kind[[n, n + 1]], (Kind.LINE, Kind.ARC)).all()
                and not (np.abs(end[[n, n + 1], 2] - start[[n, n + 1], 2]) > ARITHMETIC).any()
            )
            if not flat:
                continue
            s, e, c = (complex_of(p[[n, n + 1]]) for p in (start, end, centre))
            comes, goes = (way(s[k], e[k], c[k], float(sweep[n + k]), e[0]) for k in (0, 1))
            new = broken(comes, goes, *wanted[n])
            if new is None:
                continue
            first, last, middle, turn = new
            for k, (a, b) in enumerate(((s[0], first), (last, e[1]))):
                if kind[n + k] == Kind.ARC:
                    arc = np.angle((b - c[k]) / (a - c[k]))
                    sweep[n + k] = arc + (2 * np.pi * np.sign(sweep[n + k]) if arc * sweep[n + k] < 0 else 0.0)
            end[n, :2], start[n + 1, :2] = (first.real, first.imag), (last.real, last.imag)
            shape = Kind.LINE if turn == 0 else Kind.ARC
            more.append((n, shape, [*end[n]], [last.real, last.imag, end[n, 2]], [middle.real, middle.imag], turn))
        if not more:
            return rows, (kind, start, end, centre, sweep)
        order = np.argsort(np.concatenate([rows, [m[0] for m in more]]), kind="stable")
        owner = np.concatenate([rows, np.array([m[0] for m in more], np.int64)])[order]
        added = zip(*(m[1:] for m in more), strict=True)
        columns = [
            np.concatenate([old, np.array(new, old.dtype)])[order]
            for old, new in zip((kind, start, end, centre, sweep), added, strict=True)
        ]
        return owner, (columns[0], columns[1], columns[2], columns[3], columns[4])

    def shift(self, scale: Floats) -> Floats:
        """What TRANS and G52 add to positions, mm, (lines, 3)."""
        frame, local = self.of("FRAME"), self.having(_LOCAL)
        if frame is None and not local.any():
            return np.broadcast_to(0.0, (self.lines, 3))
        out = np.zeros((self.lines, 3))
        how = np.where(local, 3, -1) if frame is None else np.where(local, 3, np.where(frame[0], frame[1], -1))
        at = np.flatnonzero(how >= 0)
        now = np.zeros(3)
        for first, last in zip(at.tolist(), [*at[1:].tolist(), self.lines], strict=True):
            stated = np.array([v[first] * scale[first] if s[first] else np.nan for s, v in map(self.column, "XYZ")])
            if how[first] == 3:
                now = np.where(np.isnan(stated), now, stated)
            elif how[first] != 2:
                now = (now if how[first] == 1 else 0.0) + np.nan_to_num(stated)
            out[first:last] = now
        return out

    def _endless(self) -> Bools:
        """Arcs by opening angle and centre, whose end is not stated."""
        opening = self.of("AR")
        out = np.zeros(self.lines, np.bool_)
        if opening is not None:
            for name in ("I", "J", "K", "I=AC", "J=AC", "K=AC"):
                if name in self.words:
                    out |= opening[0] & self.column(name)[0]
        return out

    def _named_arcs(
        self,
        kind: Ints,
        moving: Ints,
        start: Floats,
        end: Floats,
        plane: Ints,
        motion: Ints,
        scale: Floats,
        shift: Floats,
        centre: Floats,
        sweep: Floats,
    ) -> None:
        """Arcs by a point, by their opening angle, and tangent to the move before: with complex numbers, in order."""
        opening = self.of("AR")
        special = np.isin(motion[moving], (_BY_POINT, _TANGENT)) | (
            False if opening is None else (opening[0] & np.isfinite(opening[1]))[moving]
        )
        for n in np.flatnonzero(special & (kind == Kind.ARC)).tolist():
            line = int(moving[n])
            a, b = {17: (0, 1), 18: (2, 0), 19: (1, 2)}[int(plane[line])]
            s, e = (complex(p[n, a], p[n, b]) for p in (start, end))
            middle = complex(np.nan, np.nan)
            turn = np.nan
            if motion[line] == _BY_POINT:
                given = [self.of("IJK"[k] + "1") for k in (a, b)]
                m = complex(*(np.nan if g is None else g[1][line] * scale[line] for g in given))
                m += complex(shift[line, a], shift[line, b])
                # Mapped so that start and end lie at 0 and 1, the centre is where both bisectors meet.
                u = (m - s) / (e - s)
                if u.imag != 0:
                    middle = s + (e - s) * complex(0.5, (abs(u) ** 2 - u.real) / (2 * u.imag))
                    left = u.imag > 0
                    turn = np.angle((e - middle) / (s - middle))
                    turn = turn % (2 * np.pi) - (2 * np.pi if left else 0.0)
            elif motion[line] == _TANGENT and n and kind[n - 1] in (Kind.LINE, Kind.ARC):
                before = complex(start[n - 1, a], start[n - 1, b])
                out = s - before
                if kind[n - 1] == Kind.ARC:
                    out = 1j * np.sign(sweep[n - 1]) * (s - complex(*centre[n - 1]))
                # The chord leaves by half of the turn.
                half = np.angle((e - s) / out)
                turn = 2 * half
                middle = s + (e - s) / 2 + 1j * (e - s) / 2 / np.tan(half) if half != 0 else middle
            elif opening is not None and opening[0][line] and not self._endless()[line]:
                turn = float(np.radians(opening[1][line])) * (-1 if motion[line] == 20 else 1)
                middle = s + (e - s) / (1 - np.exp(1j * turn)) if turn else middle
            centre[n], sweep[n] = (middle.real, middle.imag), turn

    def _strange(self, named: Bools) -> Bools:
        """Lines with codes that are not known, or with a G5.1 that goes somewhere."""
        out: Bools = self.having(*self.present - FAMILIAR) | (self.having(51) & named)
        return out

    def _called(self) -> Bools:
        """Lines behind which a subprogram has left the machine somewhere."""
        out = self.having(650)
        line, number = self.words["M"]
        out[line[np.isin(number, (97, 98, 198))]] = True
        return out

    def _frames(self) -> tuple[Ints, Bools]:
        """Work offset behind each line, and the axes whose position a new frame has made unknown, (lines, 3)."""
        h_stated, h = self.column("H")
        p_stated, p = self.column("P")
        offsets = self.having(*_OFFSETS) & ~(h_stated & self.having(150))
        number = np.zeros(self.lines)
        for code in _OFFSETS:
            if code in self.code:
                number[self.having(code)] = code * 1000
        extended = self.having(541, 1540)
        number[extended] = 541000 + np.where(p_stated, p, 0.0)[extended]
        # Okuma: G15 Hn chooses the offset, and G54 to G59 with H the tool length.
        okuma = self.having(150) & h_stated
        signed = self.having(430, 431, 432, 440, 490)
        lengths = signed | (offsets & h_stated & ~extended & ~signed)
        offsets = offsets & (~lengths | signed)
        number[okuma] = 150000 + h[okuma]
        offset = _held(offsets | okuma, number, 540000.0)
        longer_by = np.where(self.having(490), -1.0, np.nan_to_num(h, nan=0.0))
        for code in (431, 432, 440):
            longer_by = longer_by + 1e4 * code * self.having(code)
        length = _held(lengths, longer_by, -1.0)
        new = self._reframed()
        if (frame := self.of("FRAME")) is not None:
            new |= frame[0] & (frame[1] == 2)
        moved = new | (np.diff(offset, prepend=540000.0) != 0)
        longer = moved | (np.diff(length, prepend=-1.0) != 0)
        return np.nan_to_num(offset).astype(np.int64), np.column_stack([moved, moved, longer])

    def _reframed(self) -> Bools:
        """Lines behind which places are elsewhere: where a frame is put on, and where one that is on ends."""
        l_stated, what = self.column("L")
        bare = ~self.naming("XYZLPR")
        here = self.having(100) & (~l_stated | np.isin(what, (0, 2, 20))) & ~bare
        pairs = [(self.having(*on), self.having(*off)) for on, off in _FRAMES]
        pairs.append((here, self.having(110, *_OFFSETS)))
        # Okuma's shift and turn.
        pairs.append((self.having(110) & self.naming("XYZP"), self.having(100) & bare))
        pairs.append((self.having(160) & ~self.column("H")[0], self.having(150)))
        for codes, letters in (((_LOCAL,), "ABC"), ((71,), "C"), ((1070,), "C")):
            turned = np.zeros(self.lines, np.bool_)
            for letter in letters:
                turned |= np.nan_to_num(self.column(letter)[1]) != 0
            pairs.append((self.having(*codes) & turned, self.having(*codes) & ~turned))
        out = np.zeros(self.lines, np.bool_)
        for on, off in pairs:
            if on.any():
                was = np.concatenate([[False], _held(on | off, on, False)[:-1]])
                out |= on | (off & was)
        return out

    def _tool(self) -> Ints:
        stated, number = self.column("T")
        tool = _held(stated, number, -1.0)
        line, code = self.words["M"]
        if (code == 6).any():
            change = np.zeros(self.lines, np.bool_)
            change[line[code == 6]] = True
            tool = _held(change, tool, -1.0)
        # Numbers of a dozen digits are names of tools on some controls.
        return np.where(np.abs(tool) < 2.0**53, tool, -1.0).astype(np.int64)

    def _cubics(self, kind: Ints, moving: Ints, start: Floats, end: Floats, scale: Floats) -> Floats:
        """Inner points of G5 moves; one without I, J goes on in the direction in which the one before ended."""
        rows = np.flatnonzero(kind == Kind.CUBIC)
        if not len(rows):
            return np.broadcast_to(np.nan, (len(kind), 4))
        control = np.full((len(kind), 4), np.nan)
        lines = moving[rows]
        given = self.at("I", lines)[0]
        leave, arrive = (np.column_stack([self.at(c, lines)[1] * scale[lines] for c in pair]) for pair in ("IJ", "PQ"))
        going_on = ~given[1:] & (np.diff(rows) == 1)
        leave[1:][going_on] = -arrive[:-1][going_on]
        control[rows] = np.column_stack([start[rows, :2] + leave, end[rows, :2] + arrive])
        return control


def _arcs(
    start: Floats,
    end: Floats,
    plane: Ints,
    clockwise: Bools,
    words: list[tuple[Bools, Floats]],
    absolute: Bools,
    turns: Floats,
) -> tuple[Floats, Floats]:
    """Centre in the plane (n, 2) and signed sweep (n,) of arcs, from I, J, K or R in mm."""
    centre, sweep = np.empty((len(plane), 2)), np.empty(len(plane))
    for p, (a, b) in {17: (0, 1), 18: (2, 0), 19: (1, 2)}.items():
        rows = np.flatnonzero(plane == p)
        if not len(rows):
            continue
        # Complex numbers: an arc turns its start about its centre.
        s, e = (x[rows, a] + 1j * x[rows, b] for x in (start, end))
        by_offset = words[a][0][rows] | words[b][0][rows]
        u, v = (np.where(words[k][0], words[k][1], 0.0)[rows] for k in (a, b))
        middle = np.where(absolute[rows], 0.0, s) + u + 1j * v
        by_radius = words[3][0][rows] & ~by_offset
        radius = words[3][1][rows]
        chord = e - s
        with np.errstate(invalid="ignore", divide="ignore"):
            rise = np.sqrt(np.maximum((radius / np.abs(chord)) ** 2 - 0.25, 0.0))
            left = np.where(clockwise[rows] == (radius < 0), 1.0, -1.0)
            middle = np.where(by_radius, s + chord * (0.5 + 1j * left * rise), middle)
            middle[~(by_offset | by_radius)] = np.nan
            turn = np.angle((e - middle) / (s - middle))
        turn = np.where(clockwise[rows], -turn, turn) % (2 * np.pi)
        turn[(np.abs(chord) <= ARITHMETIC) | (turn == 0)] = 2 * np.pi
        turn += 2 * np.pi * (turns[rows] - 1)
        sweep[rows] = np.where(clockwise[rows], -turn, turn)
        centre[rows] = np.column_stack([middle.real, middle.imag])
    return centre, sweep
