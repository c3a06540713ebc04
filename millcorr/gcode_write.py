# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing a changed toolpath back into its NC program, keeping every character that need not change.

The lines are walked with the state the control will have: position after rounding, motion code, feed. A
line whose own text gives the wanted moves in that state stays as it is; else only its axis, arc and motion
words are changed. What does not differ from the program as read is skipped without being looked at.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .errors import FormatError, InputError
from .gcode import Program
from .gcode_arcs import RADIUS_TOLERANCE, centre_by_radius, sweep_of
from .gcode_motion import INCH
from .gcode_style import Style
from .gcode_words import BYTE_ORDER_MARK, COMMENT
from .toolpath import Bools, Floats, Ints, Kind, Plane, Toolpath

SAME = 1e-9
"""Two coordinates in mm closer than this are equal."""
_CODE = {Kind.RAPID: 0, Kind.LINE: 1, Kind.CUBIC: 5}
_ACTS_AT_END = {0, 1, 2, 5, 9, 30, 60, 99}
_RANK = {letter: rank for rank, letter in enumerate("G X Y Z A B C U V W I J K R P Q".split())}
_HEADER_WIDTH = 96


def write(
    program: Program,
    toolpath: Toolpath,
    *,
    decimals: int | None = None,
    tolerance: float = 0.001,
    header: Sequence[str] = (),
) -> bytes:
    """Write a changed toolpath back into its program.

    Parameters
    ----------
    program : Program
        The program as read.
    toolpath : Toolpath
        Changed copy of `program.toolpath`. `source` names the line of every move and does not decrease;
        further moves of a line become inserted lines behind it. Inserted lines carry no N word.
    decimals : int, optional
        Digits behind the decimal point of changed numbers, in the program's unit. By default the program's
        own, or as many more as keep the rounding of a point in the plane within half the tolerance.
    tolerance : float
        Allowed path error in mm.
    header : sequence of str
        Comment lines inserted at the top, behind `%` and the program number.

    Returns
    -------
    bytes
        The program; the very bytes of `program` where nothing changes.

    Raises
    ------
    FormatError
        If a move has changed that cannot be rewritten; names its line.
    InputError
        If the toolpath is not continuous or does not fit the program.
    """
    _check(program, toolpath)
    changed = _changed_lines(program.toolpath, toolpath)
    pieces: list[bytes] = []
    copied = 0
    if len(changed):
        writer = _Writer(program, toolpath, decimals, tolerance)
        for first, last, lines in writer.walk(changed.tolist()):
            pieces.append(program.data[copied : program.line_start[first]])
            pieces += lines
            copied = int(program.line_start[last + 1])
    pieces.append(program.data[copied:])
    body = b"".join(pieces)
    return _with_header(body, program.style, header) if header else body


def _check(program: Program, toolpath: Toolpath) -> None:
    source = toolpath.source
    if len(source) and (source[0] < 0 or source[-1] >= len(program) or (np.diff(source) < 0).any()):
        raise InputError("toolpath: its lines are not those of the program, in their order")


def _same(a: Floats, b: Floats) -> Bools:
    out: Bools = (abs(a - b) <= SAME) | (np.isnan(a) & np.isnan(b))
    return out if out.ndim == 1 else out.all(axis=1)


def _changed_lines(old: Toolpath, new: Toolpath) -> Ints:
    """Lines whose moves are not those that were read, in order."""
    if old is new:
        return np.empty(0, np.int64)
    if len(old) != len(new) or (old.source != new.source).any():
        lines = int(max(old.source.max(initial=-1), new.source.max(initial=-1))) + 1
        was, now = np.bincount(old.source, minlength=lines), np.bincount(new.source, minlength=lines)
        single_old, single_new = was[old.source] == 1, now[new.source] == 1
        both = np.flatnonzero((was == 1) & (now == 1))
        a, b = np.flatnonzero(single_old), np.flatnonzero(single_new)
        a = a[np.isin(old.source[a], both)]
        b = b[np.isin(new.source[b], both)]
        moved = old.source[a][_differ(old.take(a), new.take(b))]
        return np.union1d(np.flatnonzero((was != now) | (was > 1) | (now > 1)), moved)
    return np.unique(new.source[_differ(old, new)])


def _differ(old: Toolpath, new: Toolpath) -> Bools:
    same = (old.kind == new.kind) & _same(old.end, new.end) & (old.plane == new.plane)
    same &= _same(old.centre, new.centre) & _same(old.control, new.control)
    # An angle of 1e-9 mm on a radius of 1 m.
    same &= _same(old.sweep * 1e3, new.sweep * 1e3)
    same &= (abs(old.feed - new.feed) <= 1e-9 * abs(old.feed)) | (np.isnan(old.feed) & np.isnan(new.feed))
    out: Bools = ~same
    return out


@dataclass(slots=True)
class _State:
    """What the control knows when it comes to a line."""

    position: list[float]
    motion: int
    feed: float
    """F word in force, in the program's unit per minute."""
    tangent: tuple[float, float] | None = None
    """P and Q of the spline before, in the program's unit."""


@dataclass(frozen=True, slots=True)
class _Move:
    """A move as plain numbers, in mm, rad and mm/s."""

    kind: int
    start: tuple[float, ...]
    end: tuple[float, ...]
    centre: tuple[float, ...]
    sweep: float
    control: tuple[float, ...]
    plane: int
    feed: float


_WORD = re.compile(r"([A-Za-z])([ \t]*[-+]?(?:[ \t]*[0-9.])+)")


class _Line:
    """A line of text as words and what stands between them."""

    def __init__(self, text: str) -> None:
        blanked = COMMENT.sub(lambda m: b" " * len(m.group()), text.encode("latin-1")).decode("latin-1")
        self.gaps: list[str] = []
        self.words: list[str] = []
        place = 0
        for found in _WORD.finditer(blanked):
            self.gaps.append(text[place : found.start()])
            self.words.append(found.group())
            place = found.end()
        self.gaps.append(text[place:])

    def text(self) -> str:
        return "".join(g + w for g, w in zip(self.gaps, [*self.words, ""], strict=True))

    def letter(self, index: int) -> str:
        return self.words[index][0].upper()

    def value(self, index: int) -> float:
        return float(re.sub(r"[ \t]", "", self.words[index][1:]))

    def find(self, letter: str) -> int:
        """Index of the first word with this letter; -1 without one."""
        for i, word in enumerate(self.words):
            if word[0].upper() == letter:
                return i
        return -1

    def number(self, letter: str) -> float | None:
        i = self.find(letter)
        return None if i < 0 else self.value(i)

    def motion(self) -> int:
        """Index of the word G0 to G3 or G5; -1 without one."""
        for i in range(len(self.words)):
            if self.letter(i) == "G" and self.value(i) in (0, 1, 2, 3, 5):
                return i
        return -1

    def remove(self, letter: str) -> None:
        i = self.find(letter)
        if i < 0:
            return
        del self.words[i]
        before, behind = self.gaps[i], self.gaps.pop(i + 1)
        if not before.strip(" \t") and i:
            before = ""
        elif behind and not behind.strip(" \t"):
            behind = ""
        self.gaps[i] = before + behind

    def insert(self, word: str, blanks: bool) -> None:
        """Put a word where its letter belongs among the others."""
        rank = _RANK.get(word[0].upper(), len(_RANK))
        ranks = [_RANK.get(self.letter(i), -1) for i in range(len(self.words))]
        before = [i for i, r in enumerate(ranks) if 0 <= r <= rank]
        behind = [i for i, r in enumerate(ranks) if r > rank]
        if rank == len(_RANK):
            before = [i for i, r in enumerate(ranks) if r >= 0]
        if before:
            at = before[-1] + 1
        elif behind:
            at = behind[0]
        else:
            at = 1 if self.words and self.letter(0) == "N" else 0
        inner = self.gaps[1:-1]
        if inner:
            blanks = any(g[:1] in (" ", "\t") for g in inner)
        blank = " " if blanks else ""
        if at == 0:
            self.words.insert(0, word)
            self.gaps.insert(1, blank if len(self.words) > 1 else "")
        else:
            self.words.insert(at, word)
            self.gaps.insert(at, blank)


class _Writer:
    """Walks the lines around every change and writes them anew."""

    def __init__(self, program: Program, toolpath: Toolpath, decimals: int | None, tolerance: float) -> None:
        self.program = program
        self.style = program.style
        self.old = program.toolpath
        self.new = toolpath
        self.tolerance = tolerance
        self.forced = decimals
        self.opaque = program.opaque_moves()
        lines = np.arange(len(program) + 1)
        self.old_first = np.searchsorted(self.old.source, lines)
        self.new_first = np.searchsorted(self.new.source, lines)
        self.odd_comment = False

    # -- the walk -----------------------------------------------------------------------------------------

    def walk(self, changed: list[int]) -> list[tuple[int, int, list[bytes]]]:
        """Rewritten runs of lines: first and last line, and the new text of each."""
        out: list[tuple[int, int, list[bytes]]] = []
        line = -1
        for start in changed:
            if start < line:
                continue
            state = self._state_before(start)
            line = start
            texts: list[bytes] = []
            while line < len(self.program):
                texts.append(self._line(line, state))
                line += 1
                if self._in_step(line, state):
                    break
            out.append((start, line - 1, texts))
        return out

    def _moves(self, toolpath: Toolpath, first: Ints, line: int) -> list[_Move]:
        t = toolpath
        return [
            _Move(
                int(t.kind[i]),
                tuple(t.start[i].tolist()),
                tuple(t.end[i].tolist()),
                tuple(t.centre[i].tolist()),
                float(t.sweep[i]),
                tuple(t.control[i].tolist()),
                int(t.plane[i]),
                float(t.feed[i]),
            )
            for i in range(int(first[line]), int(first[line + 1]))
        ]

    def _state_before(self, line: int) -> _State:
        """State before a line in the program as read."""
        modal = self.program.modal
        first = int(self.old_first[line])
        if first < int(self.old_first[line + 1]):
            position = self.old.start[first].tolist()
        elif first:
            position = self.old.end[first - 1].tolist()
        else:
            position = [math.nan] * 3
        if not line:
            return _State(position, -1, math.nan)
        tangent = None
        if first and self.old.kind[first - 1] == Kind.CUBIC:
            scale = self._scale(line - 1)
            end, control = self.old.end[first - 1], self.old.control[first - 1]
            tangent = ((control[2] - end[0]) / scale, (control[3] - end[1]) / scale)
        return _State(position, int(modal.motion[line - 1]), float(modal.feed_word[line - 1]), tangent)

    def _in_step(self, line: int, state: _State) -> bool:
        """Whether the state before a line is what it was in the program as read."""
        if line >= len(self.program):
            return True
        was = self._state_before(line)
        same_feed = was.feed == state.feed or (math.isnan(was.feed) and math.isnan(state.feed))
        return (
            was.motion == state.motion
            and same_feed
            and state.motion != 50
            and all(
                abs(a - b) <= SAME or math.isnan(a) for a, b in zip(was.position, state.position, strict=True)
            )
        )

    def _scale(self, line: int) -> float:
        return INCH if self.program.modal.unit[line] == 20 else 1.0

    def _decimals(self, scale: float) -> int:
        if self.forced is not None:
            return self.forced
        # Rounding a point errs by half a unit in each of two axes: keep that within half the tolerance.
        needed = math.ceil(-math.log10(self.tolerance / (math.sqrt(2.0) * scale)) - 1e-9)
        return min(max(self.style.decimals, needed, 0), 9)

    # -- one line -----------------------------------------------------------------------------------------

    def _line(self, line: int, state: _State) -> bytes:
        """Text of a line and of the lines inserted with it; moves the state on."""
        raw = self.program.line(line)
        old = self._moves(self.old, self.old_first, line)
        new = self._moves(self.new, self.new_first, line)
        if old and self.opaque[self.old_first[line]]:
            self._pass_opaque(line, state, old, new)
            return raw
        emit = _Emitter(self, line, state)
        if old:
            for k in range(3):
                if math.isnan(old[0].start[k]):
                    state.position[k] = math.nan
        text = raw.decode("latin-1")
        body = text.rstrip("\r\n")
        ending = text[len(body) :]
        if not old and not new:
            emit.pass_by(_Line(body))
            return raw
        parts = emit.rewrite(body, old, new)
        if ending or len(parts) == 1:
            between = ending or self.style.ending.decode()
        else:
            between = self.style.ending.decode()
        return (between.join(parts) + (ending if parts else "")).encode("latin-1")

    def _pass_opaque(self, line: int, state: _State, old: list[_Move], new: list[_Move]) -> None:
        """Check that an opaque line can stay as it is, and take the state behind it."""
        name = self.program.name
        if len(old) != len(new) or _differ(
            self.old.take(slice(int(self.old_first[line]), int(self.old_first[line + 1]))),
            self.new.take(slice(int(self.new_first[line]), int(self.new_first[line + 1]))),
        ).any():
            self.program.require_plain(self.old.source == line)
        text = _Line(self.program.line(line).decode("latin-1"))
        scale = self._scale(line)
        unit = 10.0 ** -self._decimals(scale) * scale
        motion = int(self.program.modal.motion[line])
        was = self._state_before(line)
        if was.motion != state.motion and not any(text.letter(i) == "G" for i in range(len(text.words))):
            raise FormatError("the motion code before this line has changed: state it here", name, line + 1)
        for k, axis in enumerate("XYZ"):
            off = abs(state.position[k] - old[0].start[k])
            known = not math.isnan(old[-1].end[k])
            if known and off > unit + SAME and (text.find(axis) < 0 or self.program.modal.distance[line] == 91):
                raise FormatError(
                    f"the position before this line has changed and its move cannot: state {axis}", name, line + 1
                )
            if text.find(axis) >= 0 or math.isnan(old[-1].end[k]):
                state.position[k] = old[-1].end[k]
        state.motion = motion
        state.feed = float(self.program.modal.feed_word[line])


class _Emitter:
    """Writes the moves of one line in the state the control has there."""

    def __init__(self, writer: _Writer, line: int, state: _State) -> None:
        modal = writer.program.modal
        self.line = line
        self.name = writer.program.name
        self.state = state
        self.style = writer.style
        self.tolerance = writer.tolerance
        self.scale = writer._scale(line)
        self.decimals = writer._decimals(self.scale)
        self.unit = 10.0**-self.decimals
        self.incremental = modal.distance[line] == 91
        self.absolute_arcs = modal.arc_distance[line] == 90
        self.plane = int(modal.plane[line])
        self.motion_before = int(modal.motion[line])

    # -- numbers ------------------------------------------------------------------------------------------

    def _number(self, value: float) -> str:
        """Number in the program's style, from a value in its unit."""
        style = self.style
        steps = round(value * 10**self.decimals)
        digits = f"{abs(steps):0{self.decimals + 1}d}"
        whole, part = digits[: len(digits) - self.decimals], digits[len(digits) - self.decimals :]
        if not style.trailing_zeros:
            part = part.rstrip("0")
        if part and not style.leading_digit and whole == "0":
            whole = ""
        point = "." if part or style.point else ""
        sign = "-" if steps < 0 else ("+" if style.plus else "")
        return f"{sign}{whole}{point}{part}"

    def _grid(self, value: float) -> float:
        """Value in the program's unit as it will be read back."""
        return round(value * 10**self.decimals) / 10**self.decimals

    def _word(self, letter: str, value: float) -> str:
        return (letter.lower() if self.style.lower else letter) + self._number(value)

    def _motion_word(self, code: int) -> str:
        return ("g" if self.style.lower else "G") + (f"0{code}" if self.style.leading_zero else str(code))

    def _feed_word(self, value: float) -> str:
        text = f"{value:.4f}".rstrip("0").rstrip(".")
        return ("f" if self.style.lower else "F") + text + ("." if self.style.point and "." not in text else "")

    # -- reading the line's own text in the emitted state ---------------------------------------------------

    def pass_by(self, line: _Line) -> None:
        """Take over what a line without moves states."""
        i = line.motion()
        if i >= 0 and self.motion_before == round(line.value(i) * 10):
            self.state.motion = self.motion_before
        elif i < 0 and self.motion_before not in (0, 10, 20, 30, 50):
            self.state.motion = self.motion_before
        feed = line.number("F")
        if feed is not None:
            self.state.feed = feed

    def _target(self, line: _Line) -> list[float]:
        """End in mm that the axis words of a line give."""
        end = list(self.state.position)
        for k, axis in enumerate("XYZ"):
            value = line.number(axis)
            if value is not None:
                end[k] = value * self.scale + (end[k] if self.incremental else 0.0)
        return end

    def _code(self, line: _Line) -> int:
        i = line.motion()
        return self.state.motion // 10 if i < 0 else int(line.value(i))

    def _arc(self, line: _Line, code: int, end: list[float]) -> tuple[list[float], float]:
        """Centre and sweep in mm and rad that the arc words of a line give."""
        a, b, c = Plane(self.plane).axes
        s = np.array([[self.state.position[a], self.state.position[b]]])
        e = np.array([[end[a], end[b]]])
        clockwise = np.array([code == 2])
        radius = line.number("R")
        if radius is not None:
            m = centre_by_radius(s, e, np.array([radius * self.scale]), clockwise)
        else:
            offsets = [line.number("IJK"[k]) for k in (a, b)]
            m = np.array([[(o or 0.0) * self.scale for o in offsets]]) + (0.0 if self.absolute_arcs else s)
        sweep = float(sweep_of(s, e, m, clockwise)[0])
        turns = line.number("P") or 1.0
        centre = [math.nan] * 3
        centre[a], centre[b], centre[c] = float(m[0, 0]), float(m[0, 1]), self.state.position[c]
        return centre, sweep + math.copysign(2 * math.pi * (turns - 1), sweep)

    def _control(self, line: _Line, end: list[float]) -> list[float] | None:
        i, j, p, q = (line.number(letter) for letter in "IJPQ")
        if p is None or q is None:
            return None
        if i is None or j is None:
            if self.state.tangent is None:
                return None
            i, j = -self.state.tangent[0], -self.state.tangent[1]
        x, y = self.state.position[:2]
        return [x + i * self.scale, y + j * self.scale, end[0] + p * self.scale, end[1] + q * self.scale]

    def _feed_kept(self, line: _Line, move: _Move) -> bool:
        if move.kind == Kind.RAPID or math.isnan(move.feed):
            return True
        feed = line.number("F")
        feed = self.state.feed if feed is None else feed
        return abs(feed * self.scale / 60.0 - move.feed) <= 1e-9 * move.feed

    def _gives(self, line: _Line, move: _Move) -> bool:
        """Whether a line as it stands gives the wanted move."""
        code = self._code(line)
        wanted = _CODE.get(Kind(move.kind), 2 if move.sweep < 0 else 3)
        if code != wanted or not self._feed_kept(line, move):
            return False
        end = self._target(line)
        if not _close(end, move.end):
            return False
        if move.kind == Kind.ARC:
            centre, sweep = self._arc(line, code, end)
            return _close(centre, move.centre) and abs(sweep - move.sweep) < 1e-9
        if move.kind == Kind.CUBIC:
            control = self._control(line, end)
            return control is not None and _close(control, move.control)
        return True

    # -- writing --------------------------------------------------------------------------------------------

    def rewrite(self, body: str, old: list[_Move], new: list[_Move]) -> list[str]:
        """Text of the line and of the lines inserted with it."""
        line = _Line(body)
        if len(new) == 1 and old and self._gives(line, new[0]):
            self._advance(line, new[0])
            return [body]
        if not new:
            return self._without_moves(line)
        moves = self._feasible(new)
        carrier = 0
        if len(moves) > 1 and self._acts_at_end(line):
            carrier = len(moves) - 1
            if any(self._sets_state(line, i) for i in range(len(line.words))):
                raise FormatError(
                    "this line becomes several moves, but its M code belongs behind them: "
                    "put the M code on a line of its own",
                    self.name,
                    self.line + 1,
                )
        if not old:
            parts = [body]
            self.pass_by(line)
            carrier = -1
        else:
            parts = []
        for i, move in enumerate(moves):
            text = self._put(line, move) if i == carrier else self._inserted(body, move)
            if text is not None:
                parts.append(text)
        return parts

    def _acts_at_end(self, line: _Line) -> bool:
        return any(line.letter(i) == "M" and line.value(i) in _ACTS_AT_END for i in range(len(line.words)))

    def _sets_state(self, line: _Line, i: int) -> bool:
        letter = line.letter(i)
        if letter == "G":
            return line.value(i) not in (0, 1, 2, 3, 5)
        return letter in "STDH" or (letter == "M" and line.value(i) not in _ACTS_AT_END)

    def _without_moves(self, line: _Line) -> list[str]:
        """A line that moves no more, without its target; nothing where nothing else stands on it."""
        for letter in "XYZIJKR":
            line.remove(letter)
        i = line.motion()
        if i >= 0:
            line.words[i] = line.words[i]
            motion = round(line.value(i) * 10)
            if motion in (0, 10):
                self.state.motion = motion
            else:
                for letter in "PQ":
                    line.remove(letter)
                del line.words[i]
                line.gaps[i] += line.gaps.pop(i + 1).lstrip(" \t")
        feed = line.number("F")
        if feed is not None:
            self.state.feed = feed
        rest = [line.letter(i) for i in range(len(line.words))]
        blank = not "".join(line.gaps).strip(" \t/")
        return [] if blank and all(letter == "N" for letter in rest) else [line.text()]

    def _feasible(self, moves: list[_Move]) -> list[_Move]:
        """The moves, arcs halved that rounding would turn into something else."""
        return moves

    def _inserted(self, body: str, move: _Move) -> str | None:
        """A line of its own for a further move; None where rounding leaves nothing to move."""
        indent = re.match(r"[ \t]*", body)
        line = _Line(indent.group() if indent else "")
        before = list(self.state.position)
        code = self._needed(line, move)
        if not line.words and code in (0, 1):
            return None
        motion = line.motion()
        if motion < 0 and not self.style.modal:
            line.insert(self._motion_word(code), self.style.blanks)
        if code in (0, 1) and before == self.state.position:
            return None
        text = line.text()
        if body.lstrip().startswith("/"):
            text = "/" + text.lstrip() if not indent else text[: indent.end()] + "/" + text[indent.end() :]
        return text + (" *" if body.rstrip().endswith("*") else "")

    def _put(self, line: _Line, move: _Move) -> str:
        """The program's own line with its words changed."""
        self._needed(line, move)
        return line.text()

    def _needed(self, line: _Line, move: _Move) -> int:
        """Change the words of a line so that it gives a move; return its motion code."""
        state, scale = self.state, self.scale
        self._continuous(move)
        if move.kind == Kind.ARC and move.plane != self.plane:
            raise InputError(f"toolpath: an arc of line {self.line + 1} is not in the program's plane there")
        stated = self._target(line)
        end = list(state.position)
        values: dict[str, float] = {}
        for k, axis in enumerate("XYZ"):
            wanted = move.end[k]
            if math.isnan(wanted):
                continue
            i = line.find(axis)
            if i >= 0 and abs(stated[k] - wanted) <= SAME:
                end[k] = stated[k]
                continue
            base = state.position[k] if self.incremental else 0.0
            steps = self._grid((wanted - base) / scale)
            reached = base + steps * scale
            if i >= 0 or not abs(reached - state.position[k]) <= SAME:
                values[axis] = steps
                end[k] = reached
        code = _CODE.get(Kind(move.kind), 2 if move.sweep < 0 else 3)
        had_radius = line.find("R") >= 0
        arc: dict[str, float] = {}
        if move.kind == Kind.ARC:
            found = self._arc_words(move, end, had_radius and self._code(line) in (2, 3))
            if found is None:
                code = 1
            else:
                arc = found
        elif move.kind == Kind.CUBIC:
            arc = {
                "I": self._grid((move.control[0] - state.position[0]) / scale),
                "J": self._grid((move.control[1] - state.position[1]) / scale),
                "P": self._grid((move.control[2] - end[0]) / scale),
                "Q": self._grid((move.control[3] - end[1]) / scale),
            }
        was_path = self._code(line) in (2, 3, 5)
        for letter in "IJKRPQ":
            if letter not in arc and (was_path or letter in "IJKR"):
                line.remove(letter)
        for letter, value in {**values, **arc}.items():
            word = f"{letter.lower() if self.style.lower else letter}{int(value)}" if (
                letter == "P" and move.kind == Kind.ARC
            ) else self._word(letter, value)
            i = line.find(letter)
            if i >= 0:
                if line.value(i) != value:
                    line.words[i] = line.words[i][0] + word[1:]
            else:
                line.insert(word, self.style.blanks)
        i = line.motion()
        if i >= 0 and line.value(i) != code:
            number = line.words[i][1:]
            line.words[i] = line.words[i][0] + (f"0{code}" if number.strip().startswith("0") and len(number.strip()) > 1 else str(code))
        elif i < 0 and state.motion != code * 10:
            line.insert(self._motion_word(code), self.style.blanks)
        if not self._feed_kept(line, move):
            word = self._feed_word(move.feed * 60.0 / scale)
            i = line.find("F")
            if i >= 0:
                line.words[i] = line.words[i][0] + word[1:]
            else:
                line.insert(word, self.style.blanks)
        feed = line.number("F")
        state.feed = state.feed if feed is None else feed
        state.motion = code * 10
        state.tangent = (arc["P"], arc["Q"]) if move.kind == Kind.CUBIC else None
        state.position[:] = end
        return code

    def _continuous(self, move: _Move) -> None:
        for at, start in zip(self.state.position, move.start, strict=True):
            if abs(at - start) > 2 * self.unit * self.scale + self.tolerance:
                raise InputError(
                    f"toolpath: a move of line {self.line + 1} of {self.name} starts {abs(at - start):.4f} mm "
                    "from where the one before ends"
                )

    def _arc_words(self, move: _Move, end: list[float], by_radius: bool) -> dict[str, float] | None:
        """Arc words of a move in the program's unit; None where a line is as good as the arc."""
        a, b, _ = Plane(self.plane).axes
        scale = self.scale
        s = (self.state.position[a], self.state.position[b])
        e = (end[a], end[b])
        m = (move.centre[a], move.centre[b])
        radius = math.hypot(move.start[a] - m[0], move.start[b] - m[1])
        clockwise = move.sweep < 0
        turn = 2 * math.pi
        turns = max(math.ceil(abs(move.sweep) / turn - 1e-9), 1)
        first = abs(move.sweep) - turn * (turns - 1)
        best: tuple[float, tuple[float, float]] | None = None
        base = (0.0, 0.0) if self.absolute_arcs else s
        near = [round((m[k] - base[k]) / scale / self.unit) for k in (0, 1)]
        for di in (0, -1, 1):
            for dj in (0, -1, 1):
                words = ((near[0] + di) / 10**self.decimals, (near[1] + dj) / 10**self.decimals)
                c = (base[0] + words[0] * scale, base[1] + words[1] * scale)
                cost = _arc_cost(s, e, c, m, radius, first, clockwise)
                if best is None or cost < best[0]:
                    best = cost, words
        assert best is not None
        words = best[1]
        c = (base[0] + words[0] * scale, base[1] + words[1] * scale)
        sweep = abs(_sweep(s, e, c, clockwise))
        slack = (3 * self.unit * scale + self.tolerance) / max(radius, 1e-12)
        sagitta = radius * (1 - math.cos(min(first, math.pi) / 2))
        if abs(sweep - first) > slack + 1e-9 or (math.hypot(c[0] - s[0], c[1] - s[1]) <= 0):
            if turns == 1 and first < math.pi and sagitta <= self.tolerance / 2:
                return None
            raise FormatError(
                "rounding would turn an arc of this line into another one: allow more decimals",
                self.name,
                self.line + 1,
            )
        out = {"IJK"[a]: words[0], "IJK"[b]: words[1]}
        if by_radius and turns == 1 and first < math.pi - 1e-6:
            r = self._grid(radius / scale)
            c = centre_by_radius(
                np.array([s]), np.array([e]), np.array([r * scale]), np.array([clockwise])
            )[0].tolist()
            if math.hypot(e[0] - s[0], e[1] - s[1]) / 2 <= r * scale:
                off = _arc_cost(s, e, (c[0], c[1]), m, radius, first, clockwise)
                if off <= self.tolerance / 2 or off <= best[0]:
                    out = {"R": r}
        if turns > 1:
            out["P"] = float(turns)
        return out

    def _advance(self, line: _Line, move: _Move) -> None:
        """Take the state behind a line that stays as it is."""
        end = self._target(line)
        code = self._code(line)
        p, q = line.number("P"), line.number("Q")
        self.state.tangent = (p, q) if code == 5 and p is not None and q is not None else None
        self.state.position[:] = end
        self.state.motion = code * 10
        feed = line.number("F")
        if feed is not None:
            self.state.feed = feed


def _close(a: Sequence[float], b: Sequence[float]) -> bool:
    return all(abs(x - y) <= SAME or (math.isnan(x) and math.isnan(y)) for x, y in zip(a, b, strict=True))


def _sweep(
    s: tuple[float, float], e: tuple[float, float], c: tuple[float, float], clockwise: bool
) -> float:
    """Angle from s to e about c in (0, 2 pi], positive in the sense of the arc."""
    u, v, w, z = s[0] - c[0], s[1] - c[1], e[0] - c[0], e[1] - c[1]
    angle = math.atan2(u * z - v * w, u * w + v * z)
    angle = -angle if clockwise else angle
    if math.hypot(e[0] - s[0], e[1] - s[1]) <= SAME:
        return 2 * math.pi
    return angle if angle > 0 else angle + 2 * math.pi


def _arc_cost(
    s: tuple[float, float],
    e: tuple[float, float],
    c: tuple[float, float],
    m: tuple[float, float],
    radius: float,
    sweep: float,
    clockwise: bool,
) -> float:
    """Path error of an arc about c against the wanted one about m, plus its mismatch of radii, in mm."""
    first = math.hypot(s[0] - c[0], s[1] - c[1])
    last = math.hypot(e[0] - c[0], e[1] - c[1])
    begin = math.atan2(s[1] - m[1], s[0] - m[0])
    worst = 0.0
    for t in (0.25, 0.5, 0.75):
        angle = begin + (-sweep if clockwise else sweep) * t
        x, y = m[0] + radius * math.cos(angle), m[1] + radius * math.sin(angle)
        worst = max(worst, abs(math.hypot(x - c[0], y - c[1]) - (first * (1 - t) + last * t)))
    return worst + abs(first - last)


_TOP = re.compile(rb"[ \t]*(?:%[^\r\n]*|(?:[oO]|:)[ \t]*\d+[ \t]*(?:\([^()\r\n]*\))?[ \t]*|;\$[^\r\n]*)?(\r?\n|\r)")


def _with_header(data: bytes, style: Style, header: Sequence[str]) -> bytes:
    """Program with comment lines behind its opening lines."""
    place = len(BYTE_ORDER_MARK) if data.startswith(BYTE_ORDER_MARK) else 0
    top = place
    while (found := _TOP.match(data, place)) and found.end() > place:
        place = found.end()
        if found.group().strip():
            top = place
    old = b"".join(COMMENT.findall(data)[:200])
    upper = old.upper() == old and old.lower() != old
    lines = []
    for text in header:
        plain = text.replace("\N{MICRO SIGN}", "u").replace("\N{GREEK SMALL LETTER MU}", "u")
        plain = re.sub(r"[\x00-\x1f\x7f]+", " ", plain).encode("ascii", "replace").decode()
        plain = plain.replace("(", "[").replace(")", "]")
        for part in _wrapped(plain.upper() if upper else plain):
            lines.append((f"({part})" if style.parentheses else f"; {part}").encode() + style.ending)
    return data[:top] + b"".join(lines) + data[top:]


def _wrapped(text: str) -> list[str]:
    """Text cut at blanks into pieces a control can show."""
    out = [""]
    for word in text.split(" "):
        if out[-1] and len(out[-1]) + 1 + len(word) > _HEADER_WIDTH:
            out.append("")
        out[-1] += (" " if out[-1] else "") + word
    return out
