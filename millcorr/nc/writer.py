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

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind, Toolpath

from .codes import CYCLES, INCH
from .comment_texts import comment_texts
from .emit import SAME, Emitter, Form, Move, State
from .line import Line
from .program import Program
from .repeated import agreed, one_text_a_line
from .style import Style
from .uses import Uses
from .words import BYTE_ORDER_MARK, COMMENT

_LEAVES_FRAME = (28, 30, 53, 153)
"""G codes whose axis words are no places in the work frame."""
PIECE = 1 << 16
"""Moves that are compared at once: their columns fit into the cache."""


def write(
    program: Program,
    toolpath: Toolpath,
    *,
    decimals: int | None = None,
    tolerance: float = 0.001,
    header: Sequence[str] = (),
) -> bytes:
    """Write a changed toolpath back into its program in ISO code; see `millcorr.nc.write`."""
    program.require_fits(toolpath)
    repeated = program.run.line is not None
    if repeated and toolpath is not program.toolpath:
        toolpath = agreed(program, toolpath, tolerance)
    changed = _changed_blocks(program.toolpath, toolpath)
    pieces: list[bytes] = []
    copied = 0
    if len(changed):
        writer = _Writer(program, toolpath, decimals, tolerance)
        runs = writer.walk(program.written_out(changed).tolist())
        for first, last, lines in one_text_a_line(program, runs) if repeated else runs:
            pieces.append(program.data[copied : program.line_start[first]])
            pieces += lines
            copied = int(program.line_start[last + 1])
    pieces.append(program.data[copied:])
    body = b"".join(pieces)
    return _with_header(body, program.style, header) if header else body


def _same(a: Floats, b: Floats) -> Bools:
    same = (np.abs(a - b) <= SAME) | (np.isnan(a) & np.isnan(b))
    out: Bools = np.logical_and.reduce(np.reshape(same, (len(a), -1)), axis=1)
    return out


def _changed_blocks(old: Toolpath, new: Toolpath) -> Ints:
    """Blocks whose moves are not those that were read, in order."""
    progress.step()
    if old is new:
        return np.empty(0, np.int64)
    if len(old) != len(new) or (old.source != new.source).any():
        lines = int(max(old.source.max(initial=-1), new.source.max(initial=-1))) + 1
        was, now = np.bincount(old.source, minlength=lines), np.bincount(new.source, minlength=lines)
        progress.step()
        single_old, single_new = was[old.source] == 1, now[new.source] == 1
        both = np.flatnonzero((was == 1) & (now == 1))
        a, b = np.flatnonzero(single_old), np.flatnonzero(single_new)
        a = a[np.isin(old.source[a], both)]
        b = b[np.isin(new.source[b], both)]
        moved = old.source[a[_differ(old, new, a, b)]]
        return np.union1d(np.flatnonzero((was != now) | (was > 1) | (now > 1)), moved)
    rows = np.arange(len(new))
    return np.unique(new.source[_differ(old, new, rows, rows)])


def _differ(old: Toolpath, new: Toolpath, a: Ints, b: Ints) -> Bools:
    """Whether moves `a` of one toolpath are other ones than moves `b` of another, one by one."""
    out = np.empty(len(a), np.bool_)
    for k in range(0, len(a), PIECE):
        progress.step()
        i, j = a[k : k + PIECE], b[k : k + PIECE]
        same = (old.kind[i] == new.kind[j]) & _same(old.end[i], new.end[j]) & (old.plane[i] == new.plane[j])
        same &= _same(old.centre[i], new.centre[j]) & _same(old.control[i], new.control[j])
        # An angle of 1e-9 mm on a radius of 1 m.
        same &= _same(old.sweep[i] * 1e3, new.sweep[j] * 1e3)
        was, now = old.feed[i], new.feed[j]
        same &= (abs(was - now) <= 1e-9 * abs(was)) | (np.isnan(was) & np.isnan(now))
        out[k : k + PIECE] = ~same
    return out


class _Writer:
    """Walks the lines around every change and writes them anew."""

    def __init__(self, program: Program, toolpath: Toolpath, decimals: int | None, tolerance: float) -> None:
        progress.step()
        self.program = program
        self.style = program.style
        self.old = program.toolpath
        self.new = toolpath
        self.tolerance = tolerance
        self.forced = decimals
        self.opaque = program.opaque_moves()
        self.uses = Uses(program.run)
        lines = np.arange(program.run.blocks + 1)
        self.old_first = np.searchsorted(self.old.source, lines)
        self.new_first = np.searchsorted(self.new.source, lines)

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
            while line < self.program.run.blocks:
                texts.append(self._line(line, state))
                line += 1
                if self._in_step(line, state):
                    break
            out.append((start, line - 1, texts))
        return out

    def _state_before(self, line: int) -> State:
        """State before a line in the program as read."""
        progress.step()
        modal = self.program.modal
        first = int(self.old_first[line])
        if first < int(self.old_first[line + 1]):
            position = self.old.start[first].tolist()
        elif first:
            position = self.old.end[first - 1].tolist()
        else:
            position = [math.nan] * 3
        if not line:
            return State(position, -1, math.nan)
        tangent = None
        if first and self.old.kind[first - 1] == Kind.CUBIC:
            scale = self._scale(line - 1)
            end, control = self.old.end[first - 1], self.old.control[first - 1]
            tangent = ((control[2] - end[0]) / scale, (control[3] - end[1]) / scale)
        return State(position, int(modal.motion[line - 1]), float(modal.feed_word[line - 1]), tangent)

    def _in_step(self, line: int, state: State) -> bool:
        """Whether the state before a line is what it was in the program as read."""
        if line >= self.program.run.blocks:
            return True
        was = self._state_before(line)
        same_feed = was.feed == state.feed or (math.isnan(was.feed) and math.isnan(state.feed))
        return (
            was.motion == state.motion
            and same_feed
            and state.motion != 50
            and all(abs(a - b) <= SAME or math.isnan(a) for a, b in zip(was.position, state.position, strict=True))
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

    def _line(self, line: int, state: State) -> bytes:
        """Text of a block's line and of the lines inserted with it; moves the state on."""
        progress.step()
        raw = self.program.block(line)
        old_rows = slice(int(self.old_first[line]), int(self.old_first[line + 1]))
        new_rows = slice(int(self.new_first[line]), int(self.new_first[line + 1]))
        moving = old_rows.start < old_rows.stop
        if moving:
            for k in np.flatnonzero(np.isnan(self.old.start[old_rows.start])).tolist():
                state.position[k] = math.nan
            if self.opaque[old_rows.start]:
                self._pass_opaque(line, state, old_rows, new_rows)
                return raw
        emitter = Emitter(self._form(line), state)
        text = raw.decode("latin-1")
        body = text.rstrip("\r\n")
        ending = text[len(body) :]
        if not moving and new_rows.start == new_rows.stop:
            return (emitter.pass_by(body) + ending).encode("latin-1")
        parts = emitter.rewrite(body, moving, _moves(self.new, new_rows))
        between = ending or self.style.ending.decode()
        return (between.join(parts) + (ending if parts else "")).encode("latin-1")

    def _form(self, line: int) -> Form:
        modal = self.program.modal
        scale = self._scale(line)
        return Form(
            program=self.program.name,
            line=self.program.line_of(line),
            style=self.style,
            scale=scale,
            decimals=self._decimals(scale),
            tolerance=self.tolerance,
            incremental=bool(modal.distance[line] == 91),
            absolute_arcs=bool(modal.arc_distance[line] == 90),
            plane=int(modal.plane[line]),
            motion=int(modal.motion[line]),
            shift=tuple(modal.shift[line].tolist()),
            pieces=self.program.run.pieces(line),
            shared=self.uses.shared,
        )

    def _pass_opaque(self, line: int, state: State, old: slice, new: slice) -> None:
        """Check that an opaque line can stay as it is, and take the state behind it."""
        a, b = self.old.take(old), self.new.take(new)
        name, form = self.program.name, self._form(line)
        text = Line(self.program.block(line).decode("latin-1").rstrip("\r\n"), form.pieces)
        travel = np.nan_to_num(b.end - b.start)[:, :2]
        bare = (
            text.axis("X")[0] < 0
            and text.axis("Y")[0] < 0
            and form.motion not in CYCLES
            and not (np.abs(travel) > SAME).any()
        )
        if bare and len(a) == len(b) == 1 and a.kind[0] == b.kind[0] == Kind.RAPID:
            # A retraction along Z alone, G28 Z0 too, starts wherever the path before it now ends.
            a = a.with_moves(start=_at(a.start, b.start), end=_at(a.end, b.end))
        rows = np.arange(len(a))
        if len(a) != len(b) or _differ(a, b, rows, rows).any():
            self.program.require_plain(self.old.source == line)
        codes = [i for i in range(len(text.words)) if text.letter(i) == "G"]
        before = self._state_before(line)
        if not codes and before.motion != state.motion:
            raise FormatError(
                phrase("the motion code before this line has changed: state it here"), name, form.line + 1
            )
        if text.find("F") < 0 and before.feed != state.feed and not math.isnan(before.feed):
            raise FormatError(phrase("the feed before this line has changed: state it here"), name, form.line + 1)
        for k, axis in enumerate("XYZ"):
            end = float(a.end[0, k])
            off = abs(state.position[k] - float(a.start[0, k]))
            # The Z of a canned cycle is the bottom of its hole, not where it ends.
            i, incremental = text.axis(axis)
            stated = i >= 0 and not (axis == "Z" and form.motion in CYCLES)
            counted = form.incremental if incremental is None else incremental
            if not math.isnan(end) and off > form.unit + SAME and (counted or not stated):
                leaves = any(text.value(code) in _LEAVES_FRAME for code in codes)
                remedy = (
                    phrase("lead the cut out to a stated {} on a line before it", axis)
                    if leaves
                    else phrase("state {} here", axis)
                )
                message = phrase("the position before this line has changed, but not its move: {}", remedy)
                raise FormatError(message, name, form.line + 1)
            if stated or math.isnan(end):
                state.position[k] = end
        state.motion = form.motion
        state.feed = float(self.program.modal.feed_word[line])
        state.tangent = None


def _at(point: Floats, place: Floats) -> Floats:
    """Points with another place in the plane, where theirs is known; (n, 3)."""
    out: Floats = np.where(np.isnan(point) | [False, False, True], point, place)
    return out


def _moves(toolpath: Toolpath, rows: slice) -> list[Move]:
    progress.step()
    t = toolpath
    return [
        Move(
            int(t.kind[i]),
            tuple(t.start[i].tolist()),
            tuple(t.end[i].tolist()),
            tuple(t.centre[i].tolist()),
            float(t.sweep[i]),
            tuple(t.control[i].tolist()),
            int(t.plane[i]),
            float(t.feed[i]),
        )
        for i in range(rows.start, rows.stop)
    ]


_TOP = re.compile(
    rb"[ \t]*(?:%[^\r\n]*|\$[^\r\n]*%|(?:[oO]|:)[ \t]*\d+[ \t]*(?:\([^()\r\n]*\))?[ \t]*|;\$[^\r\n]*)?(\r?\n|\r)"
)


def _with_header(data: bytes, style: Style, header: Sequence[str]) -> bytes:
    """Program with comment lines behind its opening lines."""
    progress.step()
    place = len(BYTE_ORDER_MARK) if data.startswith(BYTE_ORDER_MARK) else 0
    top = place
    while (found := _TOP.match(data, place)) and found.end() > place:
        place = found.end()
        if found.group().strip():
            top = place
    old = b"".join(COMMENT.findall(data)[:200])
    upper = old.upper() == old and old.lower() != old
    lines = []
    for text in comment_texts(header):
        shown = (text.upper() if upper else text).replace("(", "[").replace(")", "]")
        lines.append((f"({shown})" if style.parentheses else f"; {shown}").encode() + style.ending)
    return data[:top] + b"".join(lines) + data[top:]
