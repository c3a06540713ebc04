# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proof that a corrected program differs from its original in nothing but the places of its moves in the plane.

Lines that were not to change stand in the written text byte for byte and in their order; between them, where lines
were to change, the written ones may be more or fewer, but everything in them that is no coordinate of the plane comes
in the order and with the numbers of the original, and height, feed, tool, compensation and kind of motion follow one
another as the control saw them before. Whether the new places are right is for the proof of the surface.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import LimitError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind
from millcorr.tolerances import ARITHMETIC, EXACT

from .reading import PlainMoves, Reading, line_starts, read
from .unrolled import ADDRESS

_UNKNOWN = 1e30
"""A height that the text has not stated, as a number that equals itself."""
_ON_CIRCLE, _ON_CIRCLE_RELATIVE = 0.0127, 0.001
"""By how much the radii at both ends of an arc may differ before a control stops, mm and share: LinuxCNC's values."""

_TOKEN = re.compile(
    r"(?P<comment>\([^()]*\)|;.*|\"[^\"]*\"?)|(?P<skip>/[1-9]?)|(?P<end>\*[ \t]*$)"
    r"|(?P<letter>[A-Za-z\xc0-\xde])[ \t]*(?P<number>[-+]?(?:[ \t]*[0-9.])+)|(?P<other>[^ \t\r\n\x0b\x0c\x1a])"
)
_PATH_CODES = (0.0, 1.0, 2.0, 3.0, 5.0)
_PATH_WORD = re.compile(rb"[Gg]0?[01235](?![0-9.])")
_PLACE_ONLY = re.compile(rb"(?:[ \t]*(?:[Gg]0?[01235](?![0-9.])|[XYxy][ \t]*[-+]?[0-9.]+))*[ \t\r\n]*")
_OWN_AXES = (4, 10, 28, 28.1, 30, 30.1, 50, 50.1, 51, 51.1, 52, 53, 65, 66, 68, 68.2, 92, 92.1, 92.2, 92.3, 7.1, 107)
"""Codes whose axis words are no place of a path: they stay as they are."""
_COMMENT_LINE = re.compile(rb"[ \t]*(?:\([^()\r\n]*\)|;[^\r\n]*)[ \t]*")
_OPENING = re.compile(
    rb"[ \t]*(?:%[^\r\n]*|\$[^\r\n]*%|(?:[oO]|:)[ \t]*\d+[ \t]*(?:\([^()\r\n]*\))?|;\$[^\r\n]*)?[ \t]*"
)
_SHOWN = 40
_HEIGHTS = ("Z", ADDRESS["Z=IC"], ADDRESS["Z=AC"])
_CENTRES = tuple(ADDRESS[name] for name in ("I=AC", "J=AC"))
_PLACES = tuple(
    ADDRESS[name]
    for name in "X=IC Y=IC X=AC Y=AC RND CHR CHF RNDM FRC ANG AR I1 J1 K1 ARC AP AP=AC AP=IC RP RP=IC".split()
)
_OWN_WORDS = (ADDRESS["FRAME"], ADDRESS["POLE"])
_NOT_THERE = "{} of a move that was not to change is not what it was"


@dataclass(frozen=True, eq=False, slots=True)
class TextProof(ReadOnlyArrays):
    """What the written text is, beside its original.

    Parameters
    ----------
    moves : PlainMoves
        Moves of the written text, for the proof of the surface.
    source : (lines,) int64
        Line of the original that each written line is; -1 for the header, and for lines that hold nothing but a
        place in the plane where lines were to change, since several of them may stand for several.
    untouched : (lines,) bool
        Written lines that are byte for byte lines of the original that were not to change.
    header : int
        Comment lines added at the top.
    largest_shift : float
        Largest distance in the plane, in mm, between the place of a line with more than a place and a number on it
        (a height, a feed, a code) before and after; 0 without any. The place is where its move starts; where an M code
        may act at its end, its moves may have come before it.
    line : (blocks,) int64
        Line of the written text that each of its blocks runs.
    unplaced : (lines of the original,) bool, or None
        Lines whose place the control computes: `largest_shift` leaves them out. None where there are no such lines.
    """

    moves: PlainMoves
    source: Ints
    untouched: Bools
    header: int
    largest_shift: float
    line: Ints
    unplaced: Bools | None = None


@dataclass(frozen=True, eq=False, slots=True)
class Language:
    """How the lines of a program are read.

    Parameters
    ----------
    read : callable
        Text, and the files beside it, to `Reading`.
    content : callable
        What line i of a text holds beside places in the plane.
    restated : callable
        Whether a written line is one of the original that only states besides what was in force there, from the two
        lines without blanks.
    opening, comment : re.Pattern
        A line above which no comment is added, and a line of comment.
    """

    read: Callable[[bytes, Sequence[tuple[str, bytes]]], Reading]
    content: Callable[[Text, int], Content]
    restated: Callable[[bytes, bytes], bool]
    opening: re.Pattern[bytes]
    comment: re.Pattern[bytes]


def prove_text(
    original: bytes,
    written: bytes,
    may_change: Bools | Ints | Sequence[int],
    *,
    header: Sequence[str] = (),
    reach: float = math.inf,
    tolerance: float = 0.001,
    beside: Sequence[tuple[str, bytes]] = (),
    language: Language | None = None,
    unplaced: Bools | None = None,
) -> TextProof:
    r"""Prove that a written program keeps everything of its original but places in the plane of some lines.

    Parameters
    ----------
    original, written : bytes
        The program before and after.
    may_change : (lines,) bool, or sorted indices
        Lines of the original, however often they run, whose X, Y, I, J, R (and I, J, P, Q of splines) and motion code
        may change, and which may become several lines or, where they hold nothing else, none. A line whose move starts
        elsewhere than before is one of them.
    header : sequence of str
        Comments that were to be added at the top, in any case and wrapped anyhow.
    reach : float
        Largest distance in mm by which the place of such a line as `TextProof.largest_shift` tells may have moved,
        so that no feed and no code comes earlier or later on the path than it did.
    tolerance : float
        By how much the heights at which a rising move was divided may be off its even rise, in mm.
    beside : sequence of (str, bytes)
        Names and texts of files that hold subprograms of the program; they stay as they are.
    language : Language, optional
        ISO code by default.
    unplaced : (lines,) bool, optional
        Lines of the original whose place the control computes: `reach` does not hold for them.

    Returns
    -------
    TextProof

    Raises
    ------
    LimitError
        If anything else differs; names the line of the written text and what differs.

    Examples
    --------
    >>> prove_text(b"G1 Z-5 F300\nG1 X9 Y9\n", b"G1 Z-9 F300\nG1 X9 Y8.99\n", [1])
    Traceback (most recent call last):
    millcorr.errors.LimitError: the written program differs where it must not: line 1: Z-9 in place of Z-5
    """
    language = ISO if language is None else language
    if original == written:
        same = language.read(written, beside)
        everything = np.arange(len(same.line))
        return TextProof(same.moves, everything, np.ones(len(everything), np.bool_), 0, 0.0, same.line, unplaced)
    mark = b"\xef\xbb\xbf"
    if original.startswith(mark) and written.startswith(mark):
        original, written = original[len(mark) :], written[len(mark) :]
    top, added = _header_lines(original, written, header, language)
    starts = line_starts(written)
    body = written[: starts[top]] + written[starts[top + added] :] if added else written
    prover = _Prover((original, body), may_change, top, added, reach, tolerance, beside, language)
    prover.prove()
    shift, line = prover.largest_shift(unplaced)
    if shift > reach:
        prover.refuse(line, f"it stands {shift:.4f} mm from where it did, more than {reach:.4f} mm")
    moves = prover.new.moves
    source: Ints = np.insert(prover.source, top, np.full(added, -1))
    fixed: Bools = np.insert(prover.fixed, top, np.zeros(added, np.bool_))
    moves = replace(moves, line=moves.line + np.where(moves.line >= top, added, 0))
    line_of: Ints = prover.new.reading.line
    line_of = np.insert(line_of + np.where(line_of >= top, added, 0), top, np.arange(top, top + added))
    return TextProof(moves, source, fixed, added, shift, line_of, unplaced)


@dataclass(frozen=True, slots=True)
class Content:
    """What a line holds beside places in the plane.

    Parameters
    ----------
    rest : tuple of str
        Words, comments and marks that stay, in their order, blanks taken out of words.
    feed, height : str or None
        Number of its F and Z word.
    turns : str or None
        Number of P of an arc.
    skip : str
        Mark of block delete.
    stray : bool
        Words of an arc stand on a straight move.
    """

    rest: tuple[str, ...]
    feed: str | None
    height: str | None
    turns: str | None
    skip: str
    stray: bool

    @property
    def bare(self) -> bool:
        """Whether the line holds nothing but a place."""
        return not self.rest and self.feed is None and self.height is None

    @property
    def droppable(self) -> bool:
        """Whether nothing is lost with the line when its move is: its number names a move."""
        return self.feed is None and self.height is None and all(w[0] in "Nn" for w in self.rest)

    @property
    def late(self) -> bool:
        """Whether an M code may act when all moves of the line are done, so that moves may come before the line."""
        return any(w[0] in "Mm" for w in self.rest)


_BARE = Content((), None, None, None, "", False)


def _content(text: bytes, motion: int) -> Content:
    """Take a line apart; `motion` is the motion code in force behind it, in tenths."""
    if _PLACE_ONLY.fullmatch(text):
        return _BARE
    rest: list[str] = []
    bent = False
    feed = height = turns = None
    skip = ""
    tokens = list(_TOKEN.finditer(text.decode("latin-1").rstrip("\r\n")))
    words = [(m["letter"].upper(), re.sub(r"[ \t]", "", m["number"])) if m["letter"] else None for m in tokens]
    codes = {_float(w[1]) for w in words if w and w[0] == "G"}
    own = bool(codes.intersection(_OWN_AXES)) or any(w and w[0] in _OWN_WORDS for w in words)
    for found, word in zip(tokens, words, strict=True):
        if word is None:
            if found["skip"]:
                skip = found["skip"]
            elif not found["end"]:
                rest.append(found.group())
            continue
        letter, number = word
        plain = letter + number
        if own:
            rest.append(plain)
        elif letter == "F" and feed is None:
            feed = number
        elif letter in _HEIGHTS and height is None:
            height = number
        elif letter in "IJR" or letter in _CENTRES or (letter == "K" and _float(number) == 0 and motion in (20, 30)):
            bent = True
        elif letter == ADDRESS["TURN"] or (letter == "P" and motion in (20, 30)):
            turns = plain
        elif not (
            letter in "XY"
            or letter in _PLACES
            or (letter in "PQ" and motion == 50)
            or (letter == "G" and _float(number) in _PATH_CODES)
        ):
            rest.append(plain)
    return Content(tuple(rest), feed, height, turns, skip, bent and motion in (0, 10))


def _number(number: str | None) -> float | None:
    return None if number is None else _float(number)


def _float(number: str) -> float:
    try:
        return float(number)
    except ValueError:
        return math.nan


@dataclass(frozen=True, eq=False, slots=True)
class Text:
    """A text as it runs, its reading, and which of its moves belong to each line."""

    data: bytes
    reading: Reading
    first: Ints
    language: Language

    @staticmethod
    def of(data: bytes, language: Language, beside: Sequence[tuple[str, bytes]]) -> Text:
        """Read a text."""
        reading = language.read(data, beside)
        lines = len(reading.starts) - 1
        return Text(reading.text, reading, np.searchsorted(reading.moves.line, np.arange(lines + 1)), language)

    def __len__(self) -> int:
        return len(self.reading.starts) - 1

    def line(self, i: int) -> bytes:
        """Line by its index."""
        return self.data[self.reading.starts[i] : self.reading.starts[i + 1]]

    def run(self, first: int, last: int) -> bytes:
        """Lines from one to before another."""
        return self.data[self.reading.starts[first] : self.reading.starts[last]]

    def content(self, i: int) -> Content:
        """What a line holds beside places in the plane."""
        return self.language.content(self, i)

    def never_run(self, data: bytes) -> list[bytes]:
        """Lines of the file that do not run."""
        starts = line_starts(data)
        runs = np.zeros(len(starts) - 1, np.bool_)
        runs[self.reading.line[self.reading.line < len(runs)]] = True
        return [data[starts[i] : starts[i + 1]] for i in np.flatnonzero(~runs).tolist()]

    @property
    def moves(self) -> PlainMoves:
        """Its moves."""
        return self.reading.moves

    def feed(self, rows: Ints) -> Floats:
        """Number of the F word at which some moves run; NaN before any."""
        own = self.reading.corner_feed[rows]
        return np.where(np.isnan(own), self.reading.feed_word[self.moves.line[rows]], own)

    def start(self, i: int) -> Floats:
        """Position before a line; NaN where unknown."""
        row = int(self.first[i])
        here = row < len(self.moves) and self.moves.line[row] == i
        out: Floats = self.moves.start[row] if here else (self.moves.end[row - 1] if row else np.full(3, np.nan))
        return out

    def end(self, i: int) -> Floats:
        """Position behind a line; NaN where unknown."""
        row = int(self.first[i + 1])
        out: Floats = self.moves.end[row - 1] if row else np.full(3, np.nan)
        return out


def _alike(a: NDArray[np.generic], b: NDArray[np.generic], within: float = 0.0) -> Bools:
    """Rows that are equal; NaN equals NaN."""
    x, y = (np.asarray(c, np.float64).reshape(len(c), math.prod(c.shape[1:])) for c in (a, b))
    same = (np.abs(x - y) <= within) | (np.isnan(x) & np.isnan(y))
    out: Bools = np.logical_and.reduce(same, axis=1)
    return out


def _runs(mask: Bools) -> list[tuple[int, int]]:
    """First and last + 1 of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


class _Prover:
    """One comparison of two texts: run by run where nothing was to change, line by line elsewhere."""

    def __init__(
        self,
        files: tuple[bytes, bytes],
        may_change: Bools | Ints | Sequence[int],
        top: int,
        added: int,
        reach: float,
        tolerance: float,
        beside: Sequence[tuple[str, bytes]],
        language: Language,
    ) -> None:
        self.files = files
        self.language = language
        self.old, self.new = (Text.of(data, language, beside) for data in files)
        progress.step()
        given = np.asarray(may_change)
        lines = self.old.reading.line
        may = np.zeros(max(int(lines.max(initial=-1)) + 1, len(line_starts(files[0])) - 1), np.bool_)
        may[np.flatnonzero(given) if given.dtype == np.bool_ else given.astype(np.int64)] = True
        self.free = may[lines]
        self.top, self.added = top, added
        self.reach, self.tolerance = reach, tolerance
        self.source = np.full(len(self.new), -1, np.int64)
        self.fixed = np.zeros(len(self.new), np.bool_)
        self.acts = np.zeros(len(self.new), np.bool_)
        self.late = np.zeros(len(self.new), np.bool_)
        self.rising = np.zeros(len(self.new), np.bool_)
        self.skip_old = np.zeros(len(self.old), np.int64)
        self.skip_new = np.zeros(len(self.new), np.int64)

    def prove(self) -> None:
        """Raise LimitError at the first thing that differs; `source` and `fixed` tell where each line is from."""
        progress.step()
        old, new = (text.never_run(data) for text, data in zip((self.old, self.new), self.files, strict=True))
        if old != new:
            self.refuse(0, "lines that never run are not what they were")
        runs = _runs(self.free)
        stops = [*(first for first, _ in runs), len(self.old)][1:]
        at = runs[0][0] if runs else len(self.old)
        if not self._fits(0, at, 0):
            self._differs_in_run(0, at, range(1))
        self._take(0, at, 0)
        blocks = []
        for (first, last), stop in zip(runs, stops, strict=True):
            until = self._block(first, last, at, stop)
            self._take(last, stop, until)
            blocks.append((first, last, at, until))
            at = until + stop - last
        if at < len(self.new):
            self._differs(at, None)
        self._same_moves()
        for block in blocks:
            progress.step()
            self._same_states(*block)
        self._possible_arcs()
        self._even_ramps()

    # -- lines that were not to change ---------------------------------------------------------------------

    def _take(self, first: int, last: int, at: int) -> None:
        self.source[at : at + last - first] = np.arange(first, last)
        self.fixed[at : at + last - first] = True

    def _fits(self, first: int, last: int, at: int) -> bool:
        """Whether lines of the original stand in the written text from `at` on, and to its end if to their end."""
        count = last - first
        if at + count > len(self.new) or (last == len(self.old) and at + count != len(self.new)):
            return False
        if not count:
            return True
        if self.old.line(first) != self.new.line(at) and not self._restated(first, at):
            return False
        off = self._first_difference(first, last, at)
        if off < count:
            # Behind a block that ends with another kind of motion the next move states its own.
            earlier = self.old.first[first + off] > self.old.first[first]
            if earlier or not self._restated(first + off, at + off):
                return False
            if self.old.run(first + off + 1, last) != self.new.run(at + off + 1, at + count):
                return False
        return self._first_move_fits(first, last, at)

    def _first_difference(self, first: int, last: int, at: int) -> int:
        """Number of lines in which both texts agree from there on."""
        low, high = 0, min(last - first, len(self.new) - at)
        if self.old.run(first, first + high) == self.new.run(at, at + high):
            return high
        while high - low > 1:
            middle = (low + high) // 2
            if self.old.run(first + low, first + middle) == self.new.run(at + low, at + middle):
                low = middle
            else:
                high = middle
        return low

    def _restated(self, i: int, w: int) -> bool:
        """Whether a written line is a line of the original that only states besides what was in force."""
        return self.language.restated(*(re.sub(rb"[ \t]", b"", t.line(k)) for t, k in ((self.old, i), (self.new, w))))

    def _first_move_fits(self, first: int, last: int, at: int) -> bool:
        """Whether the first move of the lines ends where it did, so that equal lines elsewhere are not taken for it."""
        row = int(self.old.first[first])
        if row == int(self.old.first[last]):
            return True
        line = int(self.old.moves.line[row])
        there = int(self.new.first[at + line - first])
        if there == len(self.new.moves) or self.new.moves.line[there] != at + line - first:
            return False
        if not self.old.reading.in_plane[line]:
            return True
        off = self.old.moves.end[row, :2] - self.new.moves.end[there, :2]
        return bool((~(np.abs(off) > EXACT)).all())

    def _same_moves(self) -> None:
        """Every line that was not to change makes the move it made."""
        to_new = np.full(len(self.old), -1, np.int64)
        to_new[self.source[self.fixed]] = np.flatnonzero(self.fixed)
        a, b = self.old.moves, self.new.moves
        rows, there = np.flatnonzero(to_new[a.line] >= 0), np.flatnonzero(self.fixed[b.line])
        lines = b.line[there]
        if len(rows) != len(there) or (to_new[a.line[rows]] != lines).any():
            self.refuse(int(lines[0]) if len(lines) else 0, "moves of lines that were not to change are not the same")
        in_plane = self.old.reading.in_plane[a.line[rows]]
        feed, now = (t.feed(r) for t, r in ((self.old, rows), (self.new, there)))
        off = np.where(in_plane[:, None], a.end[rows, :2] - b.end[there, :2], 0.0)
        bends = np.flatnonzero((a.kind[rows] >= Kind.ARC) & (a.kind[rows] == b.kind[there]))
        shape, bent = (
            np.column_stack([m.centre[r], m.control[r], m.sweep[r]]) for m, r in ((a, rows[bends]), (b, there[bends]))
        )
        same_shape = np.ones(len(rows), np.bool_)
        same_shape[bends] = _alike(shape, bent, EXACT)
        for what, same in (
            ("kind of motion", a.kind[rows] == b.kind[there]),
            ("feed", _alike(feed, now)),
            ("height", _alike(a.end[rows, 2], b.end[there, 2], ARITHMETIC)),
            ("tool", a.tool[rows] == b.tool[there]),
            ("plane", a.plane[rows] == b.plane[there]),
            ("cutter compensation", a.compensation[rows] == b.compensation[there]),
            ("work offset", a.offset[rows] == b.offset[there]),
            ("place", ~(np.abs(off) > EXACT).any(axis=1)),
            ("arc or spline", same_shape),
        ):
            wrong = np.flatnonzero(~same)
            if len(wrong):
                self.refuse(int(lines[wrong[0]]), _NOT_THERE.format(what))

    # -- lines that were to change -------------------------------------------------------------------------

    def _block(self, first: int, last: int, at: int, stop: int) -> int:
        """Go through the written lines that stand for some of the original; return the line behind them."""
        contents = [self.old.content(i) for i in range(first, last)]
        self.skip_old[first:last] = [len(c.skip) for c in contents]
        turns = {c.turns for c in contents}
        strays = any(c.stray for c in contents)
        # Written out, a corner with a feed of its own states it, and the line behind it the one before.
        slowed = self._slowed(first, last)
        waiting = [(i, c) for i, c in enumerate(contents, first) if not c.bare]
        needed = max((k + 1 for k, (_, c) in enumerate(waiting) if not c.droppable), default=0)
        # `goal` is the height that the last line which states one has not reached yet.
        k, w, height, goal = 0, at, float(self.new.start(at)[2]), math.nan
        while not (k >= needed and math.isnan(goal) and self._fits(last, stop, w)):
            wanted = waiting[k] if k < len(waiting) else None
            if w == len(self.new) and (k >= needed or wanted is None):
                self._differs_in_run(last, stop, range(at, w + 1))
            if w == len(self.new) and wanted is not None:
                self._differs(w, wanted[0])
            c, reached = self.new.content(w), float(self.new.end(w)[2])
            j = self._matching(waiting, k, c, w, height, slowed) if math.isnan(goal) and not c.bare else -1
            if j >= 0:
                i, k = waiting[j][0], j + 1
                self.source[w], self.late[w], self.acts[w] = i, c.late, not c.droppable
                goal = float(self.old.end(i)[2]) if c.height is not None else math.nan
            elif not (c.bare or self._inserted(c, wanted, height, reached, goal, slowed)):
                if k < needed and wanted is not None:
                    self._differs(w, wanted[0])
                self._differs_in_run(last, stop, range(at, w + 1))
            if c.turns not in turns and c.turns is not None:
                self.refuse(w, f"an arc of {c.turns} turns which the original has not")
            if c.stray and not strays:
                self.refuse(w, f"a centre or radius on a straight move: '{_shown(self.new.line(w))}'")
            arrived = abs(reached - goal) <= ARITHMETIC
            self.rising[w] = not arrived and (not math.isnan(goal) or (c.height is not None and j < 0))
            goal = math.nan if arrived else goal
            self.skip_new[w] = len(c.skip)
            height = reached
            w += 1
        a, b = (float(t.reading.feed_word[x - 1]) if x else math.nan for t, x in ((self.old, last), (self.new, w)))
        if a != b and not (math.isnan(a) and math.isnan(b)):
            self.refuse(w - 1, f"F{b:g} in force in place of F{a:g}")
        return w

    def _slowed(self, first: int, last: int) -> bool:
        """Whether some lines of the original hold a corner with a feed of its own."""
        return bool(np.isfinite(self.old.reading.corner_feed[self.old.first[first] : self.old.first[last]]).any())

    def _inserted(
        self,
        c: Content,
        wanted: tuple[int, Content] | None,
        height: float,
        reached: float,
        goal: float,
        slowed: bool,
    ) -> bool:
        """Whether a line may stand between those of the original: on the way to a height that one of them states."""
        if c.rest or (c.feed is not None and not slowed and (wanted is None or not _ahead(c, wanted[1]))):
            return False
        to = goal
        if math.isnan(goal) and wanted is not None and wanted[1].height is not None:
            to = float(self.old.end(wanted[0])[2])
        return c.height is None or _between(height, reached, to) or abs(reached - goal) <= ARITHMETIC

    def _matching(
        self, waiting: list[tuple[int, Content]], k: int, c: Content, w: int, height: float, slowed: bool
    ) -> int:
        """Which of the waiting lines a written one is, past such as may have gone with their move; -1 for none."""
        while k < len(waiting):
            i, o = waiting[k]
            restated = slowed and o.feed is None and not o.bare
            same_feed = _number(o.feed) == _number(c.feed) or restated
            if (o.rest, o.skip) == (c.rest, c.skip) and same_feed and self._height_kept(i, o, w, c, height):
                return k
            if not o.droppable:
                break
            k += 1
        return -1

    def _height_kept(self, i: int, o: Content, w: int, c: Content, height: float) -> bool:
        before, target, reached = float(self.old.start(i)[2]), float(self.old.end(i)[2]), float(self.new.end(w)[2])
        if c.height is None:
            # A line whose move has vanished has lost its Z with it.
            return o.height is None or abs(target - before) <= ARITHMETIC
        if o.height is None:
            return False
        if math.isnan(target) or math.isnan(reached):
            return o.height == c.height
        return abs(reached - target) <= ARITHMETIC or _between(height, reached, target)

    def _same_states(self, first: int, last: int, at: int, until: int) -> None:
        """Kind of motion, feed, height and the like follow one another in a block as they did."""
        (was, heights, _, ways), (now, reached, lines, _) = (
            self._states(self.old, self.skip_old, first, last),
            self._states(self.new, self.skip_new, at, until),
        )
        # The feed of a corner stands on no line: only where there was hardly a way has it gone with its move.
        longest = 2 * self.reach if self._slowed(first, last) else math.inf
        if was.shape == now.shape and (was == now).all() and _alike(heights, reached, ARITHMETIC).all():
            return
        i = j = 1
        while i < len(was) or j < len(now):
            progress.step()
            if i < len(was) and (was[i] == was[i - 1]).all() and heights[i] == heights[i - 1]:
                i += 1
                continue
            same = i < len(was) and j < len(now) and bool((was[i] == now[j]).all())
            if same and abs(reached[j] - heights[i]) <= ARITHMETIC:
                i, j = i + 1, j + 1
            elif same and _between(float(reached[j - 1]), float(reached[j]), float(heights[i])):
                j += 1
            elif (
                i + 1 < len(was)
                and not was[i - 1 : i + 2, 0].any()
                and abs(heights[i] - heights[i - 1]) <= ARITHMETIC
                and ways[i] <= longest
            ):
                # The move has vanished among others that cut; what comes next is compared with the one before it.
                was, heights, ways = np.delete(was, i, axis=0), np.delete(heights, i), np.delete(ways, i)
            else:
                w = int(lines[min(j, len(now) - 1)]) if len(lines) else at
                self.refuse(w, "heights, feeds or kinds of motion do not follow one another as in the original")

    def _states(self, text: Text, skip: Ints, first: int, last: int) -> tuple[Floats, Floats, Ints, Floats]:
        """State and height of the move before some lines and of those in them, each run of equal ones once.

        Beside them the line of the first of the run, and how far apart the ends of its moves are in all, mm.
        """
        rows = np.arange(text.first[first] - 1, text.first[last])
        m = text.moves
        if rows[0] < 0:
            rows = rows[1:]
        lines = m.line[rows]
        rapid = (m.kind[rows] == Kind.RAPID) & (np.abs(text.reading.motion[lines]) < 100)
        feed = np.where(rapid, -1.0, np.nan_to_num(text.feed(rows), nan=-2.0))
        state = np.column_stack(
            [rapid, feed, m.tool[rows], m.plane[rows], m.compensation[rows], m.offset[rows], skip[lines]]
        ).astype(np.float64)
        height = np.nan_to_num(m.end[rows, 2], nan=_UNKNOWN)
        ways = np.nan_to_num(np.hypot(*(m.end[rows, :2] - m.start[rows, :2]).T))
        if text.first[first] == 0:
            state = np.vstack([np.full(7, -3.0), state])
            height, lines = np.concatenate([[_UNKNOWN], height]), np.concatenate([[first], lines])
            ways = np.concatenate([[0.0], ways])
        else:
            # The mark of block delete is read only inside of blocks.
            state[0, 6] = -1
        new = np.concatenate([[True], (state[1:] != state[:-1]).any(axis=1) | (height[1:] != height[:-1])])
        return state[new], height[new], lines[new], np.add.reduceat(ways, np.flatnonzero(new))

    def _possible_arcs(self) -> None:
        """Arcs and splines on changed lines are ones that a control can make."""
        m = self.new.moves
        rows = np.flatnonzero((m.kind >= Kind.ARC) & ~self.fixed[m.line])
        a, b = (np.choose(m.plane[rows] - 17, axes) for axes in ((0, 2, 1), (1, 0, 2)))
        radii = [np.hypot(p[rows, a] - m.centre[rows, 0], p[rows, b] - m.centre[rows, 1]) for p in (m.start, m.end)]
        allowed = np.maximum(_ON_CIRCLE, _ON_CIRCLE_RELATIVE * np.maximum(*radii))
        cubic = m.kind[rows] == Kind.CUBIC
        impossible = np.where(
            cubic,
            ~np.isfinite(m.control[rows]).all(axis=1),
            (np.abs(radii[0] - radii[1]) > allowed) | ~np.isfinite(m.sweep[rows]),
        )
        if impossible.any():
            self.refuse(int(m.line[rows[impossible]][0]), "no arc or spline has these words")

    def _even_ramps(self) -> None:
        """Where a rising move has become several, each has risen by its share of the way."""
        m = self.new.moves
        for first, last in _runs(self.rising):
            rows = np.arange(self.new.first[first], self.new.first[last + 1])
            radius = np.hypot(*(m.start[rows, :2] - m.centre[rows]).T)
            arc = (m.kind[rows] == Kind.ARC) & (m.plane[rows] == 17)
            delta = m.end[rows] - m.start[rows]
            way = np.where(arc, np.abs(radius * m.sweep[rows]), np.hypot(delta[:, 0], delta[:, 1]))
            start, height, gone = m.start[rows[0], 2], m.end[rows, 2], np.cumsum(np.hypot(way, delta[:, 2]))
            if not gone[-1] > 0:
                continue
            slope = (height[-1] - start) / gone[-1]
            off = np.abs(height - start - slope * gone)
            worst = int(np.argmax(off))
            if off[worst] > self.tolerance:
                line, at = int(m.line[rows[worst]]), start + slope * gone[worst]
                self.refuse(line, f"height {height[worst]:.4f} where the way rises evenly to {at:.4f}")

    def largest_shift(self, unplaced: Bools | None = None) -> tuple[float, int]:
        """Largest way in the plane between the places of a line that acts before and after, and the line."""
        largest, worst, previous = 0.0, 0, -1
        for w in np.flatnonzero(self.acts).tolist():
            i = int(self.source[w])
            if unplaced is not None and unplaced[self.old.reading.line[i]]:
                continue
            shift = _way(self.old.start(i), self.new.start(w))
            if self.late[w]:
                # Its moves may come before it: the first of them starts where it started, and it ends where it ended.
                begins = min(_way(self.old.start(i), self.new.start(x)) for x in range(previous + 1, w + 1))
                shift = min(shift, max(begins, _way(self.old.end(i), self.new.end(w))))
            if shift > largest:
                largest, worst = shift, w
            previous = w
        return largest, worst

    # -- refusals ------------------------------------------------------------------------------------------

    def refuse(self, w: int, what: str) -> NoReturn:
        line = int(self.new.reading.line[w]) if w < len(self.new) else len(self.new)
        number = line + 1 + (self.added if line >= self.top else 0)
        raise LimitError(phrase("the written program differs where it must not: line {}: {}", number, what))

    def _differs_in_run(self, first: int, last: int, places: range) -> NoReturn:
        """Refuse lines that stand nowhere as they were, at the place where most of them do."""
        agree = {w: self._first_difference(first, last, w) for w in places}
        w = max(agree, key=lambda place: (agree[place], place))
        off = agree[w]
        row = int(self.old.first[first])
        if off == last - first and row < int(self.old.first[last]):
            self.refuse(w + int(self.old.moves.line[row]) - first, _NOT_THERE.format("place"))
        self._differs(w + off, first + off if first + off < last else None)

    def _differs(self, w: int, i: int | None) -> NoReturn:
        """Refuse a written line in place of one of the original."""
        wanted = "" if i is None else _shown(self.old.line(i))
        if w >= len(self.new):
            self.refuse(len(self.new), f"the text ends where '{wanted}' is to come")
        there = _shown(self.new.line(w))
        if i is None:
            self.refuse(w, f"'{there}' is not in the original")
        a, b = ([m.group() for m in _TOKEN.finditer(_shown(t.line(k)))] for t, k in ((self.old, i), (self.new, w)))
        if len(a) == len(b):
            for x, y in zip(a, b, strict=True):
                if x != y:
                    self.refuse(w, f"{y} in place of {x}")
        self.refuse(w, f"'{there}' in place of '{wanted}'")


def _ahead(c: Content, wanted: Content) -> bool:
    """Whether a feed may be stated before its line: the M code of that line acts when all of its moves are done."""
    return _number(c.feed) == _number(wanted.feed) and wanted.late


def _way(a: Floats, b: Floats) -> float:
    """Distance in the plane, 0 where a place is not known."""
    way = math.hypot(b[0] - a[0], b[1] - a[1])
    return 0.0 if math.isnan(way) else way


def _between(start: float, reached: float, target: float) -> bool:
    """Whether a height lies on the way to another."""
    return min(start, target) < reached < max(start, target)


def _shown(line: bytes) -> str:
    text = line.decode("latin-1").strip().encode("ascii", "replace").decode()
    return text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "..."


def _signs(text: str) -> str:
    """Letters and digits of a comment as they may be written: case, blanks and brackets are the program's."""
    plain = text.replace("\N{MICRO SIGN}", "u").replace("\N{GREEK SMALL LETTER MU}", "u")
    return re.sub(r"[^A-Z0-9.+-]", "", plain.encode("ascii", "replace").decode().upper())


def _header_lines(original: bytes, written: bytes, header: Sequence[str], language: Language) -> tuple[int, int]:
    """Line at which comments were added at the top of a text, and their number."""
    old, new = (data[: line_starts(data)[:2000][-1]].splitlines() for data in (original, written))
    top = 0
    while top < min(len(old), len(new)) and old[top] == new[top] and language.opening.fullmatch(old[top]):
        top += 1
    wanted, found, count = _signs("".join(header)), "", 0
    while len(found) < len(wanted):
        line = new[top + count] if top + count < len(new) else b""
        if not language.comment.fullmatch(line):
            break
        found += _signs(line.decode("latin-1"))
        count += 1
    if found != wanted:
        raise LimitError(
            phrase("the written program differs where it must not: line {}: its header is another one", top + 1)
        )
    return top, count


def _iso_content(text: Text, i: int) -> Content:
    starts = text.reading.plain_starts
    return _content(text.reading.plain[starts[i] : starts[i + 1]], int(text.reading.motion[i]))


def _motion_restated(old: bytes, new: bytes) -> bool:
    code = _PATH_WORD.search(re.split(rb"[(;\"]", new)[0])
    return code is not None and new[: code.start()] + new[code.end() :] == old


ISO = Language(
    read=read,
    content=_iso_content,
    restated=_motion_restated,
    opening=_OPENING,
    comment=_COMMENT_LINE,
)
