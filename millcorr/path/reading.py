# SPDX-License-Identifier: LGPL-2.1-or-later
"""A second, small reader of ISO program text, for the proof; it shares no code with the one that wrote the text.

The text is cut into pieces of whole lines, letters are found by a table, numbers are summed digit by digit, and
modal groups are carried forward as whole columns. What a control would compute (variables, expressions) makes the
coordinate unknown (NaN); nothing is refused here.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.read_only import ReadOnlyArrays
from millcorr.toolpath import Bools, Floats, Ints, Kind, Plane, Toolpath, named_tool

Bytes = NDArray[np.uint8]

_PIECE = 1 << 18
"""Bytes of text that are taken apart at once: columns of single digits then fit into the cache."""
_EXACT_DIGITS = 15
"""A number of so many digits is a whole float64 over a power of ten, so that one division rounds it right."""
_SAME_POINT = 1e-9
_PATHS = {0: Kind.RAPID, 10: Kind.LINE, 20: Kind.ARC, 30: Kind.ARC, 50: Kind.CUBIC}
_NO_PATH = (330, *range(380, 390), 730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890)
_CYCLES = (730, 740, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890)
_NO_TARGET = (40, 71, 100, 281, 301, 500, 501, 510, 511, 520, 650, 660, 680, 682, 920, 921, 922, 923, 1070)
"""Tenths of G codes beside which axis words are no target: dwell, frames, macros."""
_NEW_FRAME = (100, 500, 501, 510, 511, 520, 650, 680, 681, 682, 690, 691, 920, 921, 922, 923)
_HOME = (280, 300)
_MACHINE = 530

_SKIPPED = re.compile(
    rb'\([^()\n]*\)|;[^\n]*|((?<![A-Z_])T(?:\d*[ \t]*=)?[ \t]*)?"([^"\n]*)"'
    rb'|(?<![A-Z_])T\d*[ \t]*=[ \t]*([^\s"=(;]+)'
)
"""Comments, texts, and tools that are called by a name."""
_BLANKS = b" \t\r\x0b\x0c\x1a"
_PERCENT = re.compile(rb"(?m)^(?:[Nn]\d+)?%[^\n]*")
_OPENING = re.compile(rb"(?m)^((?:N\d+)?)(?:/[1-9]?|:(?=\d))")
_ODD_WORD = re.compile(rb"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+)(?![\d.=#])|[-+]?#|=)")

_DIGIT, _POINT, _SIGN, _OTHER, _LETTER, _NEWLINE = range(6)
_CLASS = np.full(256, _OTHER, np.uint8)
_CLASS[ord("0") : ord("9") + 1] = _DIGIT
_CLASS[ord(".")] = _POINT
_CLASS[[ord("+"), ord("-")]] = _SIGN
_CLASS[ord("A") : ord("Z") + 1] = _LETTER
_CLASS[ord("\n")] = _NEWLINE
_POWERS = 10.0 ** np.arange(_EXACT_DIGITS + 1)


@dataclass(frozen=True, eq=False, slots=True)
class PlainMoves(ReadOnlyArrays):
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
        Line of the text, from 0, increasing.
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
        arrays = {name: getattr(self, name) for name in Toolpath.__slots__ if name not in ("centre", "source")}
        return Toolpath(**arrays, centre=centre, source=self.line)


@dataclass(frozen=True, eq=False, slots=True)
class Reading(ReadOnlyArrays):
    """A text read to its moves, and what the proof wants of its lines.

    Parameters
    ----------
    starts : (lines + 1,) int64
        Offset of every line, and the length of the text.
    motion : (lines,) int64
        Tenths of the motion code in force behind each line, -1 before any.
    in_plane : (lines,) bool
        X or Y is stated.
    feed_word : (lines,) float64
        Number of the F word in force behind each line.
    moves : PlainMoves
    """

    starts: Ints
    motion: Ints
    in_plane: Bools
    feed_word: Floats
    moves: PlainMoves


def line_starts(data: bytes) -> Ints:
    """Offset of every line of a text, and its length, (lines + 1,); CR ends a line only where there is no LF."""
    end = b"\n" if b"\n" in data or b"\r" not in data else b"\r"
    starts = np.flatnonzero(np.frombuffer(data, np.uint8) == ord(end)) + 1
    closed = len(starts) > 0 and starts[-1] == len(data)
    return np.concatenate([[0], starts, [] if closed else [len(data)]]).astype(np.int64)


def read_moves(data: bytes) -> PlainMoves:
    r"""Read the moves of a program's text.

    Parameters
    ----------
    data : bytes

    Returns
    -------
    PlainMoves

    Examples
    --------
    >>> read_moves(b"G0 X1 Y2 Z5\nG1 Z-1 F60\nG3 X3 I1").sweep.round(4).tolist()
    [0.0, 0.0, 3.1416]
    """
    return read(data).moves


def read(data: bytes) -> Reading:
    """Read a program's text: its moves and what the proof wants of its lines."""
    starts = line_starts(data)
    return _Follower(starts, *_words(data, starts)).reading()


# -- words ----------------------------------------------------------------------------------------------------


def _words(data: bytes, starts: Ints) -> tuple[Bytes, Floats, Ints]:
    """Letter (ASCII, upper case), number (NaN where computed) and line of every word of the program."""
    lines = len(starts) - 1
    marks = [int(np.searchsorted(starts, m.start(), "right")) - 1 for m in re.finditer(rb"%", data)]
    marks = [i for i in dict.fromkeys(marks) if data[starts[i] : starts[i + 1]].lstrip().startswith(b"%")]
    if len(marks) > 1 and not data[: starts[marks[0]]].removeprefix(b"\xef\xbb\xbf").strip():
        lines = marks[1]
    pieces = []
    first = 0
    while first < lines:
        last = max(int(np.searchsorted(starts, starts[first] + _PIECE)), first + 1)
        last = min(last, lines)
        letter, value, line = _piece(data[starts[first] : starts[last]])
        pieces.append((letter, value, line + first))
        first = last
    if not pieces:
        return np.empty(0, np.uint8), np.empty(0), np.empty(0, np.int64)
    letter, value, line = (np.concatenate(column) for column in zip(*pieces, strict=True))
    ends = line[(letter == ord("M")) & np.isin(value, (2, 30, 99))]
    keep = slice(0, int(np.searchsorted(line, ends[0], "right")) if len(ends) else len(line))
    return letter[keep], value[keep], line[keep]


def _piece(text: bytes) -> tuple[Bytes, Floats, Ints]:
    """Words of some whole lines; lines count from 0."""
    text = text.removeprefix(b"\xef\xbb\xbf").upper()
    if b"\n" not in text:
        text = text.replace(b"\r", b"\n")
    if any(mark in text for mark in (b"(", b";", b'"', b"=")):
        text = _SKIPPED.sub(_numbered_tool, text)
    text = text.translate(None, _BLANKS)
    if b"%" in text:
        text = _PERCENT.sub(b"", text)
    if b"/" in text or b":" in text:
        text = _OPENING.sub(lambda m: m[1] + (b"O" if m[0].endswith(b":") else b""), text)
    text = text.replace(b"*\n", b"\n").removesuffix(b"*") + b"\n"
    buffer = np.frombuffer(text, np.uint8)
    kind = _CLASS[buffer]
    mark = np.flatnonzero(kind >= _LETTER)
    line_of = np.cumsum(kind[mark] == _NEWLINE) - (kind[mark] == _NEWLINE)
    word = np.flatnonzero(kind[mark] == _LETTER)
    owner = np.cumsum(kind >= _LETTER) - 1

    at = np.flatnonzero(kind == _DIGIT)
    digits = np.bincount(owner[at][owner[at] >= 0], minlength=len(mark))
    last = np.cumsum(digits) - 1 + int((owner[at] < 0).sum())
    power = last[owner[at]] - np.arange(len(at))
    weight = (buffer[at] - 48.0) * _POWERS[np.clip(power, 0, _EXACT_DIGITS)]
    total = np.bincount(np.maximum(owner[at], 0), weight, len(mark))
    points = np.flatnonzero(kind == _POINT)
    pointed = np.bincount(np.maximum(owner[points], 0), minlength=len(mark))
    follows = np.append(mark[1:], len(buffer))
    decimals = np.zeros(len(mark), np.int64)
    decimals[owner[points]] = follows[owner[points]] - points - 1
    signs = np.flatnonzero(kind == _SIGN)
    negative = np.zeros(len(mark), np.bool_)
    negative[owner[signs[buffer[signs] == ord("-")]]] = True
    value = total / _POWERS[np.clip(decimals, 0, _EXACT_DIGITS)]
    value[negative] *= -1.0
    for i in word[digits[word] > _EXACT_DIGITS].tolist():
        try:
            value[i] = float(text[mark[i] + 1 : follows[i]])
        except ValueError:
            value[i] = np.nan

    # A line is plain where every letter has one number: sign in front, one point at most, nothing else between.
    letters = kind[mark] == _LETTER
    strange = letters & ((digits == 0) | (pointed > 1))
    # What stands before the first word of a line belongs to the newline before it.
    tail = np.flatnonzero(~letters & (follows - mark > 1))
    stray = [line_of[strange], line_of[tail] + 1, np.zeros(int(kind[0] < _LETTER), np.int64)]
    for places in (np.flatnonzero(kind == _OTHER), signs[kind[np.maximum(signs - 1, 0)] != _LETTER]):
        own = owner[places]
        stray.append(np.where(own < 0, 0, line_of[own] + (kind[mark[own]] == _NEWLINE)))
    odd = np.unique(np.concatenate(stray))
    letter, number, line = buffer[mark[word]], value[word], line_of[word]
    if not len(odd):
        return letter, number, line
    plain = ~np.isin(line, odd)
    rows = text.split(b"\n")
    more = [(*w, int(i)) for i in odd for w in _odd_words(rows[i])]
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
    if b"SUPA" in text:
        text = text.replace(b"SUPA", b"G53")
    text = re.sub(rb"(?:#|^R\d|^Q\d|(?<=\d)[RQ]\d)[^=]*=.*", b"", text) if b"=" in text else text
    while (shorter := re.sub(rb"\[[^\[\]]*\]|<[^<>]*>|#+\d+", b"#", text)) != text:
        text = shorter
    if re.search(rb"[A-Z_]{2}", text):
        return []
    corner = re.search(rb",[A-Z]", text)
    words = []
    for m in _ODD_WORD.finditer(text[: corner.start()] if corner else text):
        try:
            words.append((m[1][0], float(m[2])))
        except ValueError:
            words.append((m[1][0], float("nan")))
    # A corner rounding or chamfer changes where the move ends.
    return [*words, *((ord(axis), float("nan")) for axis in "XYZ")] if corner else words


# -- moves ----------------------------------------------------------------------------------------------------


def _held(stated: Bools, value: Floats, initial: float) -> Floats:
    """Value last stated at or before each line."""
    place = np.maximum.accumulate(np.where(stated, np.arange(len(stated)), -1))
    return np.where(place < 0, initial, value[place])


class _Follower:
    """Columns of one text, carried through the modal groups."""

    def __init__(self, starts: Ints, letter: Bytes, value: Floats, line: Ints) -> None:
        self.starts = starts
        self.lines = len(starts) - 1
        self.words = {c: (line[letter == ord(c)], value[letter == ord(c)]) for c in "GMXYZIJKRFTHPQ"}
        where, code = self.words["G"]
        known = np.isfinite(code)
        self.code, self.code_line = np.rint(code[known] * 10).astype(np.int64), where[known]

    def column(self, letter: str) -> tuple[Bools, Floats]:
        line, value = self.words[letter]
        stated, column = np.zeros(self.lines, np.bool_), np.full(self.lines, np.nan)
        stated[line], column[line] = True, value
        return stated, column

    def having(self, *codes: int) -> Bools:
        out = np.zeros(self.lines, np.bool_)
        out[self.code_line[np.isin(self.code, codes)]] = True
        return out

    def group(self, members: dict[int, int], initial: int, without: Bools | None = None) -> Ints:
        stated, value = np.zeros(self.lines, np.bool_), np.zeros(self.lines)
        for code, meaning in members.items():
            here = self.having(code) if without is None else self.having(code) & ~without
            stated |= here
            value[here] = meaning
        return _held(stated, value, initial).astype(np.int64)

    def reading(self) -> Reading:
        axes = [self.column(c) for c in "XYZ"]
        i, j, k, r = (self.column(c) for c in "IJKR")
        named = axes[0][0] | axes[1][0] | axes[2][0]
        arcs_named = i[0] | j[0] | k[0] | r[0]
        # G80 beside another motion code is a customary opening; the other one holds. A G5 with nothing to move to
        # tunes the control.
        motion = self.group({800: 800, **{c: c for c in _NO_PATH if c != 800}, **{c: c for c in _PATHS if c != 50}}, -1)
        cubic = self.having(50) & (named | arcs_named)
        if cubic.any():
            stated = cubic | self.having(*_NO_PATH, *_PATHS) & ~self.having(50)
            motion = _held(stated, np.where(cubic, 50, motion).astype(float), -1).astype(np.int64)
        plane = self.group({170: 17, 180: 18, 190: 19}, 17)
        absolute = self.group({900: 90, 910: 91}, 90) == 90
        absolute_arcs = self.group({901: 90, 911: 91}, 91) == 90
        # Okuma's G20 P and the like do not concern the unit; G70, G71 with I, J are hole patterns.
        unit = self.group({200: 20, 210: 21}, 21)
        if self.having(700, 710).any():
            patterns = (i[0] | j[0] | k[0]) & self.having(700, 710)
            unit = self.group({200: 20, 210: 21, 700: 20, 710: 21}, 21, patterns)
        scale = np.where(unit == 20, 25.4, 1.0)

        home, target = self.having(*_HOME), ~self.having(*_NO_TARGET)
        cycle = np.isin(motion, _CYCLES)
        offset, lost = self._frames()
        gone = self._called() | (home & ~named)
        machine = self.having(_MACHINE)
        moving = np.flatnonzero((target & (named | (np.isin(motion, (20, 30)) & arcs_named))) | home)
        start, end = np.full((len(moving), 3), np.nan), np.empty((len(moving), 3))
        for a, (stated, value) in enumerate(axes):
            unknown = gone | ((home | machine) & stated)
            # The Z of a canned cycle is the bottom of its hole, not where it ends.
            stated = stated & (target & ~cycle if a == 2 else target)
            fixed = lost[:, a] | unknown | (stated & (absolute | np.isnan(value)))
            step = np.where(stated & ~fixed, value * scale, 0.0)
            base = np.where(stated & absolute & ~unknown, value * scale, np.nan)
            at = _held(fixed, base, np.nan)
            if not absolute.all():
                sums = np.cumsum(step)
                at += sums - _held(fixed, sums, 0.0)
            end[:, a] = at[moving]
            start[:, a] = np.where((moving == 0) | lost[moving, a], np.nan, at[moving - 1])
        kind = np.zeros(len(moving), np.int64)
        for code, meaning in _PATHS.items():
            kind[(motion[moving] == code) & ~home[moving]] = meaning
        centre, sweep = np.broadcast_to(np.nan, (len(kind), 2)), np.zeros(len(kind))
        arcs = np.flatnonzero(kind == Kind.ARC)
        if len(arcs):
            lines = moving[arcs]
            words = [(s[lines], v[lines] * scale[lines]) for s, v in (i, j, k, r)]
            turns_stated, p = self.column("P")
            turns = np.where(turns_stated, p, 1.0)[lines]
            centre = np.full((len(kind), 2), np.nan)
            centre[arcs], sweep[arcs] = _arcs(
                start[arcs], end[arcs], plane[lines], motion[lines] == 20, words, absolute_arcs[lines], turns
            )
        control = self._cubics(kind, moving, start, end, scale)
        mode = self.group({930: 93, 940: 94, 950: 95}, 94)
        stated_f, f = self.column("F")
        changed = np.diff(mode, prepend=94) != 0
        feed = _held(stated_f | changed, np.where(stated_f & (mode == 94), f * scale / 60.0, np.nan), np.nan)
        moves = PlainMoves(
            kind,
            start,
            end,
            centre,
            sweep,
            control,
            plane[moving],
            np.where(kind == Kind.RAPID, np.nan, feed[moving]),
            self._tool()[moving],
            self.group({400: 0, 410: 1, 411: 1, 420: -1, 421: -1}, 0)[moving],
            offset[moving],
            moving,
        )
        return Reading(self.starts, motion, axes[0][0] | axes[1][0], _held(stated_f, f, np.nan), moves)

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
        offsets = self.having(*range(540, 600)) & ~(h_stated & self.having(150))
        number = np.zeros(self.lines)
        for code in range(540, 600):
            if code in self.code:
                number[self.having(code)] = code * 1000
        extended = self.having(541, 1540)
        number[extended] = 541000 + np.where(p_stated, p, 0.0)[extended]
        # Okuma: G15 Hn chooses the offset, and G54 to G59 with H the tool length.
        okuma = self.having(150) & h_stated
        lengths = self.having(430, 440, 490) | (offsets & h_stated & ~extended & ~self.having(430, 440))
        offsets = offsets & (~lengths | self.having(430, 440, 490))
        number[okuma] = 150000 + h[okuma]
        offset = _held(offsets | okuma, number, 540000.0)
        length = _held(lengths, np.where(self.having(490), -1.0, np.nan_to_num(h, nan=0.0)), -1.0)
        new = self.having(*_NEW_FRAME)
        moved = new | (np.diff(offset, prepend=540000.0) != 0)
        longer = moved | (np.diff(length, prepend=-1.0) != 0)
        return np.nan_to_num(offset).astype(np.int64), np.column_stack([moved, moved, longer])

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
        given = self.column("I")[0][lines]
        leave, arrive = (
            np.column_stack([self.column(c)[1][lines] * scale[lines] for c in pair]) for pair in ("IJ", "PQ")
        )
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
        turn[(np.abs(chord) <= _SAME_POINT) | (turn == 0)] = 2 * np.pi
        turn += 2 * np.pi * (turns[rows] - 1)
        sweep[rows] = np.where(clockwise[rows], -turn, turn)
        centre[rows] = np.column_stack([middle.real, middle.imag])
    return centre, sweep
