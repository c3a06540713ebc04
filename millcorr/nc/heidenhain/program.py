# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plain-language program (Klartext, .H) of HEIDENHAIN controls: its text, and the toolpath that it makes."""

from __future__ import annotations

import gc
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import ClassVar, TypedDict

import numpy as np

from millcorr.arrays import Ints
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.codes import UNSTATED
from millcorr.nc.motion import Modal, Stretch
from millcorr.nc.order import Run
from millcorr.nc.program import Program
from millcorr.nc.style import Style
from millcorr.nc.ties import Tie, beside
from millcorr.nc.toolpath import Toolpath, named_tool
from millcorr.nc.words import Words, line_starts

from .blocks import APPROACHES, CORNERS, DEPARTURES, MOTIONS, Block, blocks_of
from .machine import ENDS, Machine, Row

_BEGIN = re.compile(rb"(?:\xef\xbb\xbf)?[\s%]*(?:\d+[ \t]+)?BEGIN[ \t]+PGM\b", re.IGNORECASE)
_PLAIN = re.compile(
    rb"(?im)^[ \t]*(?:\d+[ \t]+)?"
    rb"(?:BLK[ \t]+FORM|TOOL[ \t]+CALL|END[ \t]+PGM|(?:L|LP|C|CC)[ \t]+I?[XYZP][RA]?[ \t]*[-+]?\d)"
)
MOST_BLOCKS = 5_000_000
"""More blocks than this are no part program: a loop without end."""
DEEPEST = 32
"""Calls within calls beyond this never return; controls allow 19 or fewer."""
NO_WORDS = Words(np.zeros(0, np.uint8), np.zeros(0), np.zeros(0, np.int64), np.zeros(0, np.int8))
_BEFORE = 2000
"""Bytes at the top of a text in which its language shows."""
_NUMBERS = re.compile(r"(?<![A-Z])I?[XYZ][ \t]*([+-]?)[ \t]*(\d*)(?:([.,])(\d*))?")


def recognises(data: bytes) -> bool:
    """Whether a text is a plain-language program, or a piece of one."""
    return bool(
        _BEGIN.match(data)
        or (_PLAIN.search(data[:_BEFORE]) and not re.search(rb"(?im)^N?\d*[ \t]*G\d", data[:_BEFORE]))
    )


@dataclass(frozen=True, slots=True)
class Course:
    """The blocks of a program and how they run.

    Parameters
    ----------
    text : list of Block
        As they stand in the text.
    blocks : list of Block
        As they run.
    at : list of int
        Index of each run, as moves are filed under.
    owner : list of int
        Which block of the text each of them is.
    """

    text: list[Block]
    blocks: list[Block]
    at: list[int]
    owner: list[int]


@dataclass(frozen=True, eq=False, slots=True)
class KlartextProgram(Program):
    """A plain-language program; `modal` holds unit and feed only, `led` are approaches and departures: APPR, DEP."""

    plain_moves: ClassVar[str] = "plain L, CC, C and CR blocks"

    def comments(self) -> list[tuple[int, str]]:
        """All comments: index of the line from 0, and the text without its mark."""
        out = []
        for i in range(len(self)):
            line = self.line(i)
            if b";" in line:
                bare = re.sub(rb'"[^"]*"', lambda m: b" " * len(m.group()), line)
                if (place := bare.find(b";")) >= 0:
                    out.append((i, line[place + 1 :].decode("latin-1").strip()))
        return out

    def as_they_run(self) -> Course:
        """The blocks of the text, and in the order in which they run."""
        text = list(blocks_of(self.data, self.line_start, self.name))
        by_line = {block.first: k for k, block in enumerate(text)}
        at = [i for i in range(self.run.blocks) if self.line_of(i) in by_line]
        owner = [by_line[self.line_of(i)] for i in at]
        return Course(text, [text[k] for k in owner], at, owner)

    def words(self) -> Words:
        """M codes and dwells (cycle 9) as words of ISO code, by the block that runs."""
        letters, values, lines, decimals = [], [], [], []
        course = self.as_they_run()
        for at, block in zip(course.at, course.blocks, strict=True):
            found = [("M", float(w.value)) for w in block.words if w.name == "M" and w.value.isdigit()]
            dwell = re.match(r"9\.1[ \t]+\D*([\d.,]+)", block.rest) if block.kind == "CYCL DEF" else None
            if dwell is not None:
                found += [("G", 4.0), ("X", float(dwell[1].replace(",", ".")))]
            for letter, value in found:
                letters.append(ord(letter))
                values.append(value)
                lines.append(at)
                # Seconds, as X of a G4 is with a decimal point.
                decimals.append(1)
        return Words(
            np.array(letters, np.uint8), np.array(values), np.array(lines, np.int64), np.array(decimals, np.int8)
        )

    def tool(self, number: int) -> str:
        """A tool as the command line takes it: its number, or its name where the program calls it by one."""
        for found in re.finditer(rb'(?i)TOOL[ \t]+CALL[ \t]+"([^"\r\n]*)"', self.data):
            if named_tool(found[1]) == number:
                return found[1].decode("latin-1")
        return str(number)


def parse(data: bytes, name: str) -> KlartextProgram:
    r"""Read a plain-language program from its text.

    Parameters
    ----------
    data : bytes
    name : str
        For messages.

    Returns
    -------
    KlartextProgram

    Raises
    ------
    FormatError
        If a block cannot be read or an arc is impossible.

    Examples
    --------
    >>> text = b"0 BEGIN PGM A MM\n1 L X+0 Y+0 FMAX\n2 L X+5 Y+0 F600\n3 RND R1\n4 L Y+4\n5 END PGM A MM\n"
    >>> parse(text, "A.H").toolpath.end[:, :2].tolist()
    [[0.0, 0.0], [4.0, 0.0], [5.0, 1.0], [5.0, 4.0]]
    """
    if not _BEGIN.match(data):
        message = "a plain-language program without BEGIN PGM: its first block names it and states MM or INCH"
        raise FormatError(message, name, 1)
    starts = line_starts(data)
    with nothing_collected():
        blocks = list(blocks_of(data, starts, name))
        followed = Follower(blocks, name, len(starts) - 1)
        parts = parts_of(followed)
    return KlartextProgram(name, data, starts, style=style_of(data, blocks), **parts)


def parts_of(followed: Follower) -> Parts:
    """What a program holds of one run of it."""
    count, lines = len(followed.feed_words), followed.lines()
    toolpath = toolpath_of(followed.rows)
    modal = Modal(
        motion=np.full(count, UNSTATED),
        plane=np.full(count, 17),
        distance=np.full(count, 90),
        arc_distance=np.full(count, 90),
        unit=np.full(count, 20 if followed.machine.scale != 1.0 else 21),
        feed_word=np.array(followed.feed_words),
        shift=np.zeros((count, 3)),
    )
    return Parts(
        toolpath=toolpath.with_lines(lines),
        modal=modal,
        opaque=tuple(followed.stretches),
        run=Run(lines, NO_WORDS, (), count, {}, {}),
        ties=followed.ties(toolpath),
        led=np.array(followed.led, np.int64),
    )


@contextmanager
def nothing_collected() -> Iterator[None]:
    """Keep the search for garbage away: what is read all stays, and to look through it again and again took 40 %."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


class Parts(TypedDict):
    """Fields of a program that come from its run."""

    toolpath: Toolpath
    modal: Modal
    opaque: tuple[Stretch, ...]
    run: Run
    ties: tuple[Tie, ...]
    led: Ints


class _Lost(Exception):
    """Which block runs next is not known; says why."""


class Follower:
    """One run of a program, block by block in the order in which the control carries them out.

    Parameters
    ----------
    blocks : sequence of Block
    name : str
        Of the program, for messages.
    lines : int
        Number of lines.
    """

    def __init__(self, blocks: Sequence[Block], name: str, lines: int) -> None:
        self.blocks = blocks
        self.machine = Machine(name)
        self.rows: list[Row] = []
        self.stretches: list[Stretch] = []
        self.feed_words: list[float] = []
        self.order: list[int] = []
        """Index of every block as it runs."""
        self.corners: list[int] = []
        self.tangents: list[int] = []
        self.led: list[int] = []
        self.all_lines = lines
        self._returns: list[int] = []
        self._left: dict[int, int] = {}
        self._labels: dict[str, int] = {}
        for k, block in enumerate(blocks):
            if block.kind == "LBL":
                self._labels.setdefault(block.rest, k)
        self._run()
        self.stretches.sort(key=lambda s: (s.first, s.last))

    def lines(self) -> Ints | None:
        """Line of every block as it runs; None where every line runs once, in the order of the text."""
        out = [line for k in self.order for line in range(self.blocks[k].first, self.blocks[k].last + 1)]
        return None if out == list(range(self.all_lines)) else np.array(out, np.int64)

    def ties(self, toolpath: Toolpath) -> tuple[Tie, ...]:
        """What corners (RND, CHF) and tangents (CT, CTP) tie together."""
        corners, tangents = np.array(self.corners, np.int64), np.array(self.tangents, np.int64)
        joined = zip(corners.tolist(), beside(corners, toolpath), strict=True)
        bent = zip(tangents.tolist(), beside(tangents, toolpath), strict=True)
        rows = [(before, block, behind) for block, (before, behind) in joined]
        return (*(Tie(row, row) for row in rows), *(Tie((before,), (block,)) for block, (before, _) in bent))

    def _run(self) -> None:
        k, lost, ended = 0, -1, False
        while k < len(self.blocks) and not ended:
            self.prepare(k)
            block = self.blocks[k]
            at = self._enter(k)
            self._execute(k, at)
            ended = block.kind == "END PGM" or ends_program(block)
            k += 1
            if lost >= 0:
                continue
            try:
                k = self._following(k - 1)
                if len(self.feed_words) > MOST_BLOCKS:
                    raise _Lost("a loop does not end")
            except _Lost as error:
                lost = at
                self.stretches.append(Stretch(at, -1, str(error)))
        in_order = self.order == list(range(k))
        behind = len(self.feed_words)
        if in_order:
            # Nothing is out of the order of the text: what stands behind the end is listed, too.
            for j in range(k, len(self.blocks)):
                self._enter(j)
            if any(block.kind in MOTIONS for block in list(self.blocks)[k:]):
                self.stretches.append(Stretch(behind, len(self.feed_words) - 1, "behind the end of the program"))
        self.stretches = [s if s.last >= 0 else Stretch(s.first, behind - 1, s.reason) for s in self.stretches]
        for since, reason in self.machine.frames.values():
            self.stretches.append(Stretch(since, behind - 1, reason))

    def prepare(self, k: int) -> None:
        """What there is to do before a block runs."""

    def _enter(self, k: int) -> int:
        """List a block as one that runs; return the index of this run."""
        block, at = self.blocks[k], len(self.feed_words)
        self.order.append(k)
        self.feed_words += [self.machine.feed_word] * (block.last + 1 - block.first)
        return at

    def _execute(self, k: int, at: int) -> None:
        block, machine = self.blocks[k], self.machine
        if block.kind == "BEGIN PGM":
            machine.scale = scale_of(block, machine.name)
        self.rows += machine.execute(self.blocks, k, at)
        if block.kind in CORNERS:
            self.corners.append(at)
        elif block.kind in ("CT", "CTP"):
            self.tangents.append(at)
        elif block.kind in (*APPROACHES, *DEPARTURES):
            self.led.append(at)
        last = at + block.last - block.first
        self.feed_words[at : last + 1] = [machine.feed_word] * (last + 1 - at)
        for reason in dict.fromkeys(machine.reasons):
            self.stretches.append(Stretch(at, last, reason))
        for since, reason in machine.ended:
            self.stretches.append(Stretch(since, last, reason))

    def _following(self, k: int) -> int:
        """The block that runs next."""
        block = self.blocks[k]
        if block.kind == "CALL LBL":
            found = re.fullmatch(r'("[^"]*"|\w+)(?:[ \t]+REP[ \t]*(\d+)(?:[ \t]*/[ \t]*\d+)?)?', block.rest)
            if found is None:
                raise _Lost(f"CALL LBL {block.rest} is not followed")
            label = self._label(found[1])
            if found[2] is None:
                if len(self._returns) >= DEEPEST:
                    raise _Lost("calls within calls never return")
                self._returns.append(k + 1)
                return label
            left = self._left.get(k, int(found[2]))
            if left == 0:
                self._left.pop(k, None)
                return k + 1
            self._left[k] = left - 1
            return label
        if block.kind == "LBL" and block.rest == "0" and self._returns:
            return self._returns.pop()
        if block.kind == "FN" and (jump := self.machine.parameters.jump(block.rest)) is not None:
            name, taken = jump
            if taken is None:
                raise _Lost("a jump depends on a parameter whose value is not known on reading")
            return self._label(name) if taken else k + 1
        return k + 1

    def _label(self, name: str) -> int:
        if re.fullmatch(r"Q[LR]?\d+", name):
            value = self.machine.parameters.number(name)
            name = f"{value:.0f}" if value == value else name
        if name not in self._labels:
            raise _Lost(f"no LBL {name} is there to go to")
        return self._labels[name]


def ends_program(block: Block) -> bool:
    """Whether a block ends the program (M2, M30)."""
    return (block.kind in MOTIONS or block.kind in ("", "STOP")) and any(
        w.name == "M" and w.value.isdigit() and int(w.value) in ENDS for w in block.words
    )


def scale_of(block: Block, name: str) -> float:
    """Millimetres per unit, as the first block states it."""
    found = re.search(r"[ \t](MM|INCH)[ \t]*$", block.rest)
    if found is None:
        raise FormatError(phrase("BEGIN PGM without a unit: state MM or INCH"), name, block.first + 1)
    return 25.4 if found[1] == "INCH" else 1.0


def toolpath_of(rows: Iterable[Row]) -> Toolpath:
    """Rows as a toolpath."""
    rows = list(rows)

    def column(values: list[list[float]]) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        return np.array(values, np.float64).reshape(-1, 3)

    def whole(values: list[int]) -> Ints:
        return np.array(values, np.int64)

    return Toolpath(
        kind=whole([row.kind for row in rows]),
        start=column([row.start for row in rows]),
        end=column([row.end for row in rows]),
        centre=column([row.centre for row in rows]),
        sweep=np.array([row.sweep for row in rows], np.float64),
        control=np.full((len(rows), 4), np.nan),
        plane=whole([row.plane for row in rows]),
        feed=np.array([row.feed for row in rows], np.float64),
        source=whole([row.line for row in rows]),
        compensation=whole([row.compensation for row in rows]),
        tool=whole([row.tool for row in rows]),
    )


def style_of(data: bytes, blocks: list[Block]) -> Style:
    """How the program writes its numbers."""
    places = "\n".join(b.text[b.body : b.stop] for b in blocks if b.words or b.kind == "CC").upper()
    found = [words for words in _NUMBERS.findall(places) if words[1] or words[3]]
    digits = [len(part) if point else -1 for _, _, point, part in found]
    decimals, digits_in_all = max(digits, default=-1), sum(d for d in digits if d > 0)
    plus, unsigned = (sum(sign == s for sign, *_ in found) for s in ("+", ""))
    pointed, bare, short = digits.count(0), digits.count(-1), sum(not whole for _, whole, _, _ in found)
    numbers = [int(block.text[slice(*block.number)]) for block in blocks if block.number[0] < block.number[1]]
    consecutive = 2 * len(numbers) > len(blocks) and numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    return Style(
        decimals=decimals,
        blanks=True,
        lower=False,
        leading_zero=False,
        trailing_zeros=decimals > 0 and digits_in_all > 0.9 * len(found) * decimals,
        leading_digit=short == 0,
        point=pointed > bare,
        number_step=1 if consecutive else 0,
        parentheses=False,
        modal=True,
        plus=plus >= unsigned,
        ending=b"\r\n" if b"\r\n" in data else b"\n" if b"\n" in data or b"\r" not in data else b"\r",
    )
