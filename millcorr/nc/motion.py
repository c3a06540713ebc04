# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meaning of an NC program: its words followed through the modal groups to moves."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, CompactColumns, Floats, Ints
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import Kind, Plane, Toolpath

from . import arcs_by
from .arcs import read_arcs
from .codes import (
    CALL_CODES,
    CANCEL_CYCLE,
    CYCLES,
    EXTENDED_OFFSETS,
    FRAME_OFF,
    FRAME_ON,
    GROUPS,
    HARMLESS,
    HOMING,
    INCH,
    INITIAL,
    LENGTH_OFFSETS,
    LOCAL_SHIFT,
    MACHINE,
    NOT_A_TARGET,
    OFFSETS,
    OKUMA_LENGTHS,
    OKUMA_OFFSET,
    PATHS,
    POSITION_SURVIVES,
    PROGRAM_ENDS,
    SHIFTS,
    SIEMENS_ARCS,
    UNSTATED,
)
from .corners import Corner, rounded
from .order import Run
from .statements import INCREMENTS, POSITIONS
from .words import Words


@dataclass(frozen=True, eq=False, slots=True)
class Modal(CompactColumns):
    """Modal state after each block of a program, arrays of shape (blocks,).

    Parameters
    ----------
    motion : int64
        Number of the motion code in force times ten (G1 is 10, G5 is 50); `UNSTATED` where none is known.
    plane, distance, arc_distance, unit : int64
        17, 18 or 19; 90 or 91; 90 or 91 for G90.1 or G91.1; 20 or 21.
    feed_word : float64
        Number of the F word in force, in the program's own unit; NaN before any.
    shift : (blocks, 3) float64
        What TRANS adds to stated positions, mm.
    """

    motion: Ints
    plane: Ints
    distance: Ints
    arc_distance: Ints
    unit: Ints
    feed_word: Floats
    shift: Floats


@dataclass(frozen=True, slots=True)
class Stretch:
    """Lines that cannot be corrected because their motion is not plain.

    Parameters
    ----------
    first, last : int
        Indices of the lines, from 0, both included.
    reason : str
        What makes them so.
    """

    first: int
    last: int
    reason: str


_ONCE = "XYZIJKRFxyzuvwijkarcdshotq"
_AXES = "XYZxyzuvw"
_CENTRES = "IJKRijkalmn"
_ARCS = (20, 30, *SIEMENS_ARCS)


def follow(run: Run, name: str) -> tuple[Toolpath, Modal, tuple[Stretch, ...]]:
    """Follow a program block by block to its moves.

    Parameters
    ----------
    run : Run
        The program as it runs.
    name : str
        Name of the program for messages.

    Returns
    -------
    Toolpath
    Modal
    tuple of Stretch
        What cannot be corrected, in the order of the lines.

    Raises
    ------
    FormatError
        If words contradict each other or an arc is impossible.
    """
    return _Follower(run, name).result()


def _last_index(stated: Bools) -> Ints:
    """Index of the last True at or before each place; -1 before the first."""
    index = np.where(stated, np.arange(len(stated)), -1)
    return np.maximum.accumulate(index, out=index)


def _held(stated: Bools, value: Floats, initial: float) -> Floats:
    """Value last stated at or before each line, `initial` before the first statement."""
    index = _last_index(stated)
    return np.where(index < 0, initial, value[index])


class _Follower:
    """One reading of one program: columns of words, modal groups, positions, moves."""

    def __init__(self, run: Run, name: str) -> None:
        self.name = name
        self.run = run
        words = run.words
        self.lines = run.blocks
        self.stretches: list[Stretch] = []
        last = self._last_line(words)
        if last < self.lines - 1:
            behind = np.searchsorted(words.line, last + 1)
            if np.isin(words.letter[behind:], [ord(c) for c in "XYZIJKR"]).any():
                self.stretches.append(Stretch(last + 1, self.lines - 1, phrase("behind the end of the program")))
            words = words.take(np.arange(behind))
        self.odd = [o for o in run.odd if o.line <= last]
        self.words = words
        self.columns: dict[str, tuple[Bools, Floats]] = {}
        g = words.of("G")
        plain = np.flatnonzero(np.isfinite(g.value))
        self.code = np.rint(g.value[plain] * 10).astype(np.int64)
        self.code_line = g.line[plain]
        tenths = g.value[plain] * 10
        bad = np.flatnonzero((tenths < 0) | (tenths > 99999) | (abs(tenths - self.code) > 1e-6))
        if len(bad):
            raise self._error(int(self.code_line[bad[0]]), phrase("G{:g} is not a G code", tenths[bad[0]] / 10))
        present = np.flatnonzero(np.bincount(self.code))
        self.present = frozenset(present.tolist())

    def _error(self, line: int, message: str) -> FormatError:
        return FormatError(message, self.name, self.run.number(line))

    def _last_line(self, words: Words) -> int:
        if self.run.line is not None:
            return self.lines - 1
        m = words.of("M")
        ends = m.line[np.isin(m.value, PROGRAM_ENDS)]
        return int(ends[0]) if len(ends) else self.lines - 1

    # -- columns and groups -------------------------------------------------------------------------------

    def column(self, letter: str) -> tuple[Bools, Floats]:
        """Whether and with which number a letter stands on each line, twice (lines,)."""
        if letter not in self.columns:
            these = self.words.of(letter)
            if not len(these.line):
                return np.broadcast_to(np.False_, self.lines), np.broadcast_to(np.nan, self.lines)
            twice = np.flatnonzero(these.line[1:] == these.line[:-1])
            if len(twice) and letter in _ONCE:
                message = phrase("two {} words on one line: keep the one that is meant", letter)
                raise self._error(int(these.line[twice[0]]), message)
            stated = np.zeros(self.lines, np.bool_)
            value = np.full(self.lines, np.nan)
            stated[these.line] = True
            value[these.line] = these.value
            self.columns[letter] = stated, value
        return self.columns[letter]

    def any_of(self, letters: str) -> Bools:
        """Lines that hold one of these letters, (lines,)."""
        out = np.zeros(self.lines, np.bool_)
        for letter in letters:
            out |= self.column(letter)[0]
        return out

    def lines_with(self, codes: Iterable[int]) -> Ints:
        """Indices of the lines that hold one of these G codes."""
        wanted = self.present.intersection(codes)
        if not wanted:
            return np.empty(0, np.int64)
        table = np.zeros(int(self.code.max()) + 1, np.bool_)
        table[list(wanted)] = True
        return np.unique(self.code_line[table[self.code]])

    def marked(self, codes: Iterable[int]) -> Bools:
        """Lines that hold one of these G codes, (lines,)."""
        out = np.zeros(self.lines, np.bool_)
        out[self.lines_with(codes)] = True
        return out

    def group(self, what: str, without: Bools | None = None) -> tuple[Bools, Ints]:
        """Lines that state a modal group, and the state after every line."""
        members = GROUPS[what]
        if not self.present.intersection(members):
            return np.broadcast_to(np.False_, self.lines), np.broadcast_to(np.int64(INITIAL[what]), self.lines)
        stated = np.zeros(self.lines, np.bool_)
        state = np.full(self.lines, INITIAL[what], np.int64)
        table = np.full(int(self.code.max()) + 1, -9, np.int64)
        for code, value in members.items():
            if code < len(table):
                table[code] = value
        values = table[self.code]
        these = np.flatnonzero(values != -9)
        if what == "motion" and CANCEL_CYCLE in self.present:
            # G0 G80 is a customary safety line: the other code of the line decides.
            cancel = values[these] == CANCEL_CYCLE
            others = self.code_line[these[~cancel]]
            these = these[~(cancel & np.isin(self.code_line[these], others))]
        line = self.code_line[these]
        clash = np.flatnonzero((line[1:] == line[:-1]) & (values[these][1:] != values[these][:-1]))
        if len(clash):
            a, b = self.code[these][clash[0] : clash[0] + 2] / 10
            raise self._error(int(line[clash[0]]), phrase("G{:g} and G{:g} on one line contradict each other", a, b))
        stated[line] = True
        state[line] = values[these]
        if without is not None:
            stated &= ~without
        index = _last_index(stated)
        return stated, np.where(index < 0, INITIAL[what], state[index])

    # -- what is not plain --------------------------------------------------------------------------------

    def _mark(self, lines: Ints, reason: str) -> None:
        """Note lines, runs of neighbours as one stretch."""
        if len(lines):
            breaks = np.flatnonzero(np.diff(lines) > 1)
            firsts = lines[np.concatenate([[0], breaks + 1])]
            lasts = lines[np.concatenate([breaks, [len(lines) - 1]])]
            for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True):
                self.stretches.append(Stretch(first, last, reason))

    def _frames(self, lost: Bools) -> None:
        """Stretches between a code that changes the frame and the one that ends it."""
        events: list[tuple[int, int, bool]] = []
        on = {code: reason for code, reason in FRAME_ON.items() if code in self.present}
        for code in on:
            for line in self.lines_with([code]).tolist():
                events.append((line, code, self._turns_on(code, line)))
        for code, ended in FRAME_OFF.items():
            if code in self.present and any(e in on for e in ended):
                for line in self.lines_with([code]).tolist():
                    events += [(line, e, False) for e in ended if e in on]
        since: dict[int, int] = {}
        for line, code, turns_on in sorted(events, key=lambda e: (e[0], e[2])):
            if turns_on:
                since.setdefault(code, line)
            elif code in since:
                self.stretches.append(Stretch(since.pop(code), line, on[code]))
            else:
                continue
            if code not in POSITION_SURVIVES:
                lost[line] = True
        for code, line in since.items():
            self.stretches.append(Stretch(line, self.lines - 1, on[code]))

    def _turns_on(self, code: int, line: int) -> bool:
        """Whether a frame code really changes the frame by the words beside it."""

        def number(letter: str) -> float:
            stated, value = self.column(letter)
            return float(value[line]) if stated[line] else 0.0

        if code == LOCAL_SHIFT:
            return any(number(axis) != 0 for axis in "ABC")
        if code == 71 or code == 1070:
            return number("C") != 0
        if code == 100:
            # Without any word it ends what Okuma's G11 has begun.
            return number("L") in (0, 2, 20) and bool(self.any_of("XYZLPR")[line])
        if code == 110:
            return bool(self.any_of("XYZP")[line])
        if code == 160:
            return not self.column("H")[0][line]
        return True

    def _offset_changes(self, lost: Bools) -> None:
        """A change of work offset or tool length: what is not stated afresh is unknown."""
        h_stated, h = self.column("H")
        p = self.column("P")[1]
        offset, length = "G54", "G49"
        codes = {*OFFSETS, *LENGTH_OFFSETS, OKUMA_OFFSET}
        pick = np.isin(self.code, list(codes))
        for code, line in zip(self.code[pick].tolist(), self.code_line[pick].tolist(), strict=True):
            if code == OKUMA_OFFSET and not h_stated[line]:
                continue
            if code in LENGTH_OFFSETS or (code in OKUMA_LENGTHS and h_stated[line]):
                new = "G49" if code == 490 else f"G{code / 10:g} H{h[line]}"
                lost[line, 2] |= new != length
                length = new
            else:
                new = f"G{code / 10:g}"
                if code == OKUMA_OFFSET or code in EXTENDED_OFFSETS:
                    new += f" {h[line] if code == OKUMA_OFFSET else p[line]}"
                lost[line] |= new != offset
                offset = new

    def _calls(self, motion_stated: Bools, distance_stated: Bools) -> tuple[Bools, Bools]:
        """Lines behind which nothing is known, and lines whose motion code is not known."""
        lost = np.zeros(self.lines, np.bool_)
        doubtful = np.zeros(self.lines, np.bool_)
        calls: list[tuple[int, str]] = [
            (line, CALL_CODES[c]) for c in CALL_CODES for line in self.lines_with([c]).tolist()
        ]
        for o in self.odd:
            if o.effect == "flow":
                self.stretches.append(Stretch(o.line, self.lines - 1, o.reason))
                break
            if o.effect == "call":
                calls.append((o.line, o.reason))
            elif o.reason:
                last = self.lines - 1 if o.effect == "frame" else o.line
                self.stretches.append(Stretch(o.line, last, o.reason))
        motions, distances = np.flatnonzero(motion_stated), np.flatnonzero(distance_stated)
        for line, reason in calls:
            lost[line] = True
            until = _next(motions, line, self.lines)
            doubtful[line:until] = True
            until = _next(distances, line, self.lines)
            self.stretches.append(
                Stretch(line, until - 1, phrase("{}, G90 or G91 is not stated afresh behind it", reason))
            )
        return lost, doubtful

    def _strange(self, xy: Bools, motion_stated: Bools) -> tuple[Bools, Bools]:
        """Lines with unknown codes, and lines whose motion code they leave unknown."""
        progress.step()
        strange = np.zeros(self.lines, np.bool_)
        doubtful = np.zeros(self.lines, np.bool_)
        motions = np.flatnonzero(motion_stated)
        for code in sorted(self.present - HARMLESS):
            lines = self.lines_with([code])
            self._mark(lines, phrase("G{:g} is not followed", code / 10))
            strange[lines] = True
        quadratic = self.marked([51]) & xy
        self._mark(np.flatnonzero(quadratic), phrase("G5.1 with a target is not followed"))
        strange |= quadratic
        for line in np.flatnonzero(strange).tolist():
            doubtful[line : _next(motions, line, self.lines)] = True
        return strange, doubtful

    def _unknown_axes(self, homing: Bools, cycle: Bools, back_to_r: Bools, absolute: Bools) -> dict[str, Bools]:
        """Axes whose position is unknown behind a line although it may name them, three times (lines,)."""
        machine = self.marked(MACHINE)
        none_named = homing & ~self.any_of("XYZ")
        repeated = cycle & ~absolute & self.any_of("KL")
        unknown = {axis: ((homing | machine) & self.column(axis)[0]) | none_named for axis in "XYZ"}
        unknown["Z"] |= cycle & back_to_r
        unknown["X"] |= repeated
        unknown["Y"] |= repeated
        return unknown

    # -- positions ----------------------------------------------------------------------------------------

    def _positions(
        self,
        target: Bools,
        hole: Bools,
        lost: Bools,
        unknown: dict[str, Bools],
        absolute: Bools,
        scale: Floats,
        shift: Floats,
    ) -> tuple[Floats, Floats, Bools]:
        """Position before and after each line in mm, and whether it was stated before, (lines, 3) each."""
        progress.step()
        before = np.full((self.lines, 3), np.nan)
        after = np.empty((self.lines, 3))
        ever = np.zeros((self.lines, 3), np.bool_)
        modal = absolute
        named = [[letter for letter in (INCREMENTS[a], POSITIONS[a]) if self.column(letter)[0].any()] for a in "XYZ"]
        for k, axis in enumerate("XYZ"):
            stated, value = self.column(axis)
            absolute = modal
            for letter in named[k]:
                here, own = self.column(letter)
                stated, value = stated | here, np.where(here, own, value)
                absolute = np.where(here, letter == POSITIONS[axis], absolute)
            incremental = not absolute.all()
            stated = stated & target
            if axis == "Z":
                stated &= ~hole
            value = np.where(stated, value * scale, np.nan)
            if shift[:, k].any():
                value[absolute] += shift[absolute, k]
            value[unknown[axis]] = np.nan
            fixed = lost[:, k] | unknown[axis] | (stated & absolute)
            if incremental:
                step = np.where(stated & ~absolute, value, 0.0)
                fixed |= np.isnan(step)
                value[~absolute] = np.nan
                step[fixed] = 0.0
            index = _last_index(fixed)
            position = np.where(index < 0, np.nan, value[index])
            if incremental:
                sums = np.cumsum(step)
                position += sums - sums[np.maximum(index, 0)]
            after[:, k] = position
            before[1:, k] = position[:-1]
            before[lost[:, k], k] = np.nan
            ever[1:, k] = index[:-1] >= 0
        return before, after, ever

    def _shifts(self, scale: Floats) -> Floats:
        """What TRANS, ATRANS and G52 add to stated positions behind each line, mm, (lines, 3)."""
        lines = self.lines_with((*SHIFTS, LOCAL_SHIFT))
        if not len(lines):
            return np.broadcast_to(0.0, (self.lines, 3))
        shift = np.zeros((self.lines, 3))
        more, local = self.marked([SHIFTS[1]]), self.marked([LOCAL_SHIFT])
        for line, until in zip(lines.tolist(), [*lines[1:].tolist(), self.lines], strict=True):
            now = shift[line - 1].copy() if line and (more[line] or local[line]) else np.zeros(3)
            for k, axis in enumerate("XYZ"):
                stated, value = self.column(axis)
                if stated[line]:
                    now[k] = value[line] * scale[line] + (0.0 if local[line] else now[k])
            shift[line:until] = now
        return shift

    def _feed(self, stated_mode: Bools, mode: Ints, scale: Floats) -> tuple[Floats, Floats]:
        """Number of the F word in force, and the feed in mm/s, after every line."""
        stated, value = self.column("F")
        feed = np.where(mode == 94, value * scale / 60.0, np.nan)
        changed = stated_mode & (np.diff(mode, prepend=94) != 0)
        return _held(stated, value, np.nan), _held(stated | changed, feed, np.nan)

    def _tool(self) -> Ints:
        """Number of the tool in the spindle after every line."""
        stated, number = self.column("T")
        chosen = _held(stated, number, -1.0)
        m = self.words.of("M")
        change = np.zeros(self.lines, np.bool_)
        change[m.line[m.value == 6]] = True
        if change.any():
            chosen = _held(change, chosen, -1.0)
        usable = np.isfinite(chosen) & (abs(chosen) < 2**53)
        return np.where(usable, chosen, -1.0).astype(np.int64)

    # -- the whole ----------------------------------------------------------------------------------------

    def result(self) -> tuple[Toolpath, Modal, tuple[Stretch, ...]]:
        """Moves, modal state and stretches that cannot be corrected."""
        progress.step()
        xyz, arc_words = self.any_of(_AXES), self.any_of(_CENTRES)
        # Fanuc's G5 P10000 tunes the control; a spline has its end on the line.
        tuning = self.marked([50]) & ~xyz & ~arc_words
        motion_stated, motion = self.group("motion", without=tuning)
        _, plane = self.group("plane")
        distance_stated, distance = self.group("distance")
        _, arc_distance = self.group("arc distance")
        _, unit = self.group("unit", without=self.marked([700, 710]) & self.any_of("IJKLijk"))
        _, compensation = self.group("compensation")
        mode_stated, mode = self.group("feed mode")
        _, cycle_return = self.group("cycle return")
        scale = np.where(unit == 20, INCH, 1.0)
        absolute = distance == 90

        lost = np.zeros((self.lines, 3), np.bool_)
        self._frames(lost)
        self._offset_changes(lost)
        behind_call, doubtful = self._calls(motion_stated, distance_stated)
        strange, doubtful_too = self._strange(xyz, motion_stated)
        motion = np.where(doubtful | doubtful_too, UNSTATED, motion)
        homing = self.marked(HOMING)
        target = ~self.marked(NOT_A_TARGET)
        cycle = np.isin(motion, CYCLES)
        unknown = self._unknown_axes(homing, cycle & xyz, cycle_return == 99, absolute)
        endless = self.any_of("a") & self.any_of("IJKijk")
        for axis in "XYZ":
            unknown[axis] |= strange | behind_call | (endless if axis != "Z" else False)
        shift = self._shifts(scale)
        before, after, ever = self._positions(target, cycle, lost, unknown, absolute, scale, shift)

        arc = np.isin(motion, _ARCS)
        moving = ((xyz | (arc & arc_words)) & target) | homing
        ordinary = moving & ~homing
        on_path = ordinary & np.isin(motion, (*PATHS, *SIEMENS_ARCS))
        turning = self.any_of("ABCUVW") & on_path & (motion > 0)
        for lines, reason in (
            (turning, phrase("a rotary or parallel axis moves with this line")),
            (ordinary & (motion == UNSTATED), phrase("no motion code is in force")),
            (ordinary & (motion == CANCEL_CYCLE), phrase("axis words behind G80")),
            (ordinary & cycle, phrase("canned cycle, never rewritten")),
            (homing, phrase("G28 or G30 leaves the work frame")),
            (self.marked(MACHINE), phrase("G53 moves in the machine frame")),
        ):
            self._mark(np.flatnonzero(lines), reason)

        rows = np.flatnonzero(moving)
        kind = np.zeros(len(rows), np.int64)
        for code, value in ((10, Kind.LINE), *((code, Kind.ARC) for code in _ARCS), (50, Kind.CUBIC)):
            kind[on_path[rows] & (motion[rows] == code)] = value
        start, end = before[rows], after[rows]
        del before, after
        centre, sweep = self._arcs(rows, kind, start, end, plane, motion, arc_distance == 90, scale, ever[rows], shift)
        control = self._cubics(rows, kind, start, end, plane, motion, scale)
        feed_word, feed = self._feed(mode_stated, mode, scale)
        toolpath = Toolpath(
            kind=kind,
            start=start,
            end=end,
            centre=centre,
            sweep=sweep,
            control=control,
            plane=plane[rows],
            feed=np.where(kind == Kind.RAPID, np.nan, feed[rows]),
            source=rows,
            compensation=compensation[rows],
            tool=self._tool()[rows],
        )
        toolpath = self._cornered(toolpath, scale, mode == 94)
        modal = Modal(motion, plane, distance, arc_distance, unit, feed_word, shift)
        return toolpath, modal, tuple(sorted(self.stretches, key=lambda s: (s.first, s.last)))

    def _cornered(self, toolpath: Toolpath, scale: Floats, per_minute: Bools) -> Toolpath:
        """Moves with the corners that the control rounds or breaks."""
        if not self.any_of("rcds").any():
            return toolpath
        source = toolpath.source
        found: list[tuple[int, str, float]] = []
        for letter in "rcd":
            stated, size = self.column(letter)
            # A word on a line that does not move is the one of the corner before it.
            for line in np.flatnonzero(stated).tolist():
                row = int(np.searchsorted(source, line, side="right")) - 1
                if row >= 0 and source[row] == line:
                    found.append((row, letter, float(size[line] * scale[line])))
                else:
                    self._mark(np.array([line]), phrase("a corner word without a move"))
        stated, size = self.column("s")
        if stated.any():
            own = {row for row, *_ in found}
            held = _held(stated, np.where(stated, size * scale, 0.0), 0.0)[source]
            # Between moves that leave the plane, or plunge, there are no corners to be rounded.
            z = np.nan_to_num([toolpath.start[:, 2], toolpath.end[:, 2]], nan=np.inf)
            flat = (toolpath.plane == Plane.XY) & (z[0] == z[1])
            rows = np.flatnonzero((held[:-1] != 0) & flat[:-1] & flat[1:])
            found += [(k, "r", float(held[k])) for k in rows.tolist() if k not in own]
        feed, known = self._feeds_of_corners(toolpath, scale, per_minute)
        corners: list[Corner] = []
        for row, letter, size_of in sorted(found):
            lines = np.unique(source[row : row + 2])
            pair = slice(row, row + 2)
            if corners and corners[-1].row == row:
                self._mark(lines, phrase("two corner words on one line"))
                continue
            if not known[pair].all():
                self._mark(lines, phrase("the feed of the corner is not known"))
            elif not (feed[pair] == feed[row]).all() and not np.isnan(feed[pair]).all():
                self._mark(lines, phrase("the control's settings decide which of two feeds holds in the corner"))
            corners.append(Corner(row, letter, size_of, float(feed[row])))
        toolpath, failed = rounded(toolpath, corners)
        for row in failed:
            lines = np.unique(source[row : row + 2])
            self._mark(lines, phrase("a corner rounding or chamfer that is not followed"))
        return toolpath

    def _feeds_of_corners(self, toolpath: Toolpath, scale: Floats, per_minute: Bools) -> tuple[Floats, Bools]:
        """Feed of a corner that a move begins or ends, by what its line says, mm/s, and whether it is known, (moves,).

        FRC= of the line, else FRCM= in force, else F. Machine data 20201 decides whether what the line before the
        corner says holds in it, or what the line behind it says.
        """
        lines = toolpath.source
        (once, own), (modal_stated, modal) = self.column("!"), self.column("&")
        held = _held(modal_stated, modal * scale, 0.0)[lines]
        stated = once[lines] | (held != 0)
        value = np.where(once[lines], own[lines] * scale[lines], held) / 60.0
        # Where F is not known, what is stated for the corner would hold on behind it.
        known = per_minute[lines] & np.isfinite(toolpath.feed) & (value > 0)
        return np.where(stated, value, toolpath.feed), known | ~stated

    def _opaque(self) -> Bools:
        progress.step()
        opaque = np.zeros(self.lines, np.bool_)
        for s in self.stretches:
            opaque[s.first : s.last + 1] = True
        return opaque

    def _refuse(self, lines: Ints, message: str) -> None:
        if len(lines):
            raise self._error(int(lines[0]), message)

    def _arcs(
        self,
        rows: Ints,
        kind: Ints,
        start: Floats,
        end: Floats,
        plane: Ints,
        motion: Ints,
        absolute: Bools,
        scale: Floats,
        ever: Bools,
        shift: Floats,
    ) -> tuple[Floats, Floats]:
        """Centre (n, 3) and sweep (n,) of all moves."""
        progress.step()
        sweep = np.zeros(len(rows))
        arcs = np.flatnonzero(kind == Kind.ARC)
        if not len(arcs):
            return np.broadcast_to(np.nan, (len(rows), 3)), sweep
        centre = np.full((len(rows), 3), np.nan)
        lines = rows[arcs]
        opaque = self._opaque()[lines]
        axes = np.array([Plane(p).axes[:2] for p in (17, 18, 19)])[plane[lines] - 17]
        unknown = ~np.isfinite(np.take_along_axis(start[arcs], axes, axis=1)).all(axis=1)
        never = ~np.take_along_axis(ever[arcs], axes, axis=1).all(axis=1)
        message = phrase("arc from an unknown start: state the position before it")
        self._refuse(lines[never & unknown & ~opaque], message)
        self._mark(lines[unknown & ~opaque], phrase("arc from an unknown start"))
        sweep[arcs[unknown | opaque]] = np.nan
        plain = ~(unknown | opaque)
        arcs = arcs[plain]
        named = np.isin(motion[rows[arcs]], SIEMENS_ARCS) | self.any_of("a")[rows[arcs]]
        others, arcs = arcs[named], arcs[~named]
        lines = rows[arcs]

        def word(letter: str) -> tuple[Bools, Floats]:
            stated, value = self.column(letter)
            if letter in "IJK" and self.column(letter.lower())[0].any():
                # I=AC(): written as the way from the start, in the program's unit.
                here, own = self.column(letter.lower())
                k = "IJK".index(letter)
                stated, value = stated | here, value.copy()
                at = here[lines]
                base = np.where(absolute[lines], 0.0, start[arcs, k] - shift[lines, k])
                value[lines[at]] = (own[lines] - base / scale[lines])[at]
            if letter == "P" and self.column("p")[0].any():
                more = self.column("p")
                stated, value = stated | more[0], np.where(more[0], more[1] + 1.0, value)
            return stated[lines], value[lines]

        offsets = [word(letter) for letter in "IJK"]
        if shift.any():
            offsets = [
                (s, np.where(absolute[lines], v + shift[lines, k] / scale[lines], v))
                for k, (s, v) in enumerate(offsets)
            ]
        centre[arcs], sweep[arcs], strange = read_arcs(
            start[arcs],
            end[arcs],
            plane[lines],
            motion[lines] == 20,
            (offsets[0], offsets[1], offsets[2]),
            word("R"),
            word("P"),
            absolute[lines],
            scale[lines],
            lambda mask, message: self._refuse(lines[mask], message),
        )
        self._mark(lines[strange], phrase("arc with a pitch word along its axis"))
        if len(others):
            self._named_arcs(others, rows, kind, start, end, plane, motion, scale, shift, centre, sweep)
        return centre, sweep

    def _named_arcs(
        self,
        arcs: Ints,
        rows: Ints,
        kind: Ints,
        start: Floats,
        end: Floats,
        plane: Ints,
        motion: Ints,
        scale: Floats,
        shift: Floats,
        centre: Floats,
        sweep: Floats,
    ) -> None:
        """Siemens' arcs by opening angle, by a point on them, and tangent to the move before; filled in in order."""
        for k in arcs.tolist():
            line = int(rows[k])
            a, b, c = Plane(int(plane[line])).axes
            s, e = start[k, [a, b]], end[k, [a, b]]
            numbers = {x: self.column(x)[1][line] for x in "almnIJKijk" if self.column(x)[0][line]}
            found: tuple[Floats, float] | None = None
            if motion[line] == SIEMENS_ARCS[0]:
                inner = np.array([numbers.get("lmn"[i], np.nan) for i in (a, b)]) * scale[line]
                if self.group("distance")[1][line] == 90:
                    found = arcs_by.point(s, inner + shift[line, [a, b]], e)
            elif motion[line] == SIEMENS_ARCS[1]:
                before = k - 1 if k and kind[k - 1] in (Kind.LINE, Kind.ARC) else -1
                if before >= 0:
                    out = arcs_by.leaving(
                        start[before, [a, b]], end[before, [a, b]], centre[before, [a, b]], sweep[before]
                    )
                    found = arcs_by.tangent(s, out, e)
            elif not set(numbers) - {"a"}:
                found = arcs_by.opening(s, e, float(np.radians(numbers["a"])), motion[line] == 20)
            if found is None or not np.isfinite(found[0]).all():
                sweep[k] = np.nan
                self._mark(np.array([line]), phrase("this way to state an arc is not followed"))
                continue
            centre[k, [a, b]], centre[k, c], sweep[k] = found[0], start[k, c], found[1]

    def _cubics(
        self, rows: Ints, kind: Ints, start: Floats, end: Floats, plane: Ints, motion: Ints, scale: Floats
    ) -> Floats:
        """Inner control points (n, 4) of all moves, in mm."""
        cubics = np.flatnonzero(kind == Kind.CUBIC)
        if len(cubics):
            cubics = cubics[~self._opaque()[rows[cubics]]]
        if not len(cubics):
            return np.broadcast_to(np.nan, (len(rows), 4))
        control = np.full((len(rows), 4), np.nan)
        lines = rows[cubics]
        i, j, p, q = (self.column(letter) for letter in "IJPQ")
        self._refuse(lines[plane[lines] != 17], phrase("G5 works in the XY plane only: state G17"))
        self._refuse(lines[i[0][lines] != j[0][lines]], phrase("G5 needs both I and J, or neither behind another G5"))
        self._refuse(lines[~(p[0] & q[0])[lines]], phrase("G5 needs P and Q"))
        self._refuse(lines[self.column("Z")[0][lines]], phrase("G5 moves X and Y only: move Z on a line of its own"))
        free = ~i[0][lines]
        previous = np.concatenate([[-1], cubics[:-1]])
        chained = previous == cubics - 1
        unbroken = np.zeros(len(cubics), np.bool_)
        for k in np.flatnonzero(free & chained).tolist():
            unbroken[k] = bool((motion[rows[previous[k]] : rows[cubics[k]] + 1] == 50).all())
        self._refuse(lines[free & ~unbroken], phrase("the first G5 of a row needs I and J"))
        ends = np.column_stack([p[1][lines], q[1][lines]]) * scale[lines, None]
        begins = np.column_stack([i[1][lines], j[1][lines]]) * scale[lines, None]
        begins[free] = -np.roll(ends, 1, axis=0)[free]
        control[cubics, :2] = start[cubics, :2] + begins
        control[cubics, 2:] = end[cubics, :2] + ends
        unknown = ~np.isfinite(control[cubics]).all(axis=1)
        self._refuse(lines[unknown], phrase("spline from an unknown start: state the position before it"))
        return control


def _next(lines: Ints, line: int, otherwise: int) -> int:
    """First of the sorted lines behind `line`."""
    place = int(np.searchsorted(lines, line, side="right"))
    return int(lines[place]) if place < len(lines) else otherwise
