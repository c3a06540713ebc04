# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing changed moves back into a plain-language program, keeping every character that need not change.

The blocks are carried out one after another by a second `Machine`, which is where the control will be after the blocks
as they are now written. A block whose own text gives the wanted moves there stays as it is.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from millcorr.arrays import Bools
from millcorr.errors import FormatError, InputError
from millcorr.messages import message, mm, option, phrase
from millcorr.nc.codes import INCH
from millcorr.nc.comment_texts import comment_texts
from millcorr.nc.repeated import agreed
from millcorr.nc.toolpath import Kind, Plane, Toolpath

from .blocks import APPROACHES, CORNERS, DEPARTURES, SILENT, Block, read_block
from .contour import SAME, Element, Impossible, angle_between, by_radius, chamfered, rounded
from .draft import Draft, Numbers
from .machine import AXES, Machine, Row
from .program import KlartextProgram, scale_of

_ACTS_AT_END = (0, 1, 2, 5, 9, 30, 60, 99)
"""Program stops, spindle and coolant off, cycle calls: they act when the moves of their block are done."""
_ANGLE_DECIMALS = 4
"""Digits of a polar angle in degrees that every control takes: 0.0001 mm on a radius of 100 mm."""
_USES = re.compile(r"(Q[LR]?\d+)(?![ \t]*=)")
"""A parameter where it is used, not set."""
_NEARLY_HALF = 0.95 * math.pi
"""An arc by its radius is well defined up to here."""


def write(
    program: KlartextProgram,
    toolpath: Toolpath,
    *,
    decimals: int | None = None,
    tolerance: float = 0.001,
    header: Sequence[str] = (),
) -> bytes:
    """Write a changed toolpath back into its program; see `millcorr.nc.write`."""
    program.require_fits(toolpath)
    if program.run.line is not None and toolpath is not program.toolpath:
        toolpath = agreed(program, toolpath, tolerance)
    lines = [line for lines in Writer(program, toolpath, decimals, tolerance).lines() for line in lines]
    if header:
        lines = _with_header(lines, program, header)
    elif all(line.as_read for line in lines):
        return program.data
    return _numbered(lines, program).encode("latin-1")


@dataclass(slots=True)
class Line:
    """Text of a block, its ending, and where its number stands; as it was read, or not; its own, or one inserted."""

    text: str
    ending: str
    number: tuple[int, int]
    as_read: bool = True
    own: bool = True


@dataclass(frozen=True, slots=True)
class _Corner:
    """A corner that RND or CHF makes: its place, the number that it needs, and the move behind it."""

    place: complex
    size: float
    behind: Row


@dataclass(slots=True)
class _OpenPole:
    """A CC that no block has used yet: which block that runs it is, and where the tool was."""

    run: int
    block: Block
    position: list[float]


class Writer:
    """Walks the blocks with the state that the control will have."""

    def __init__(self, program: KlartextProgram, toolpath: Toolpath, decimals: int | None, tolerance: float) -> None:
        self.program, self.old, self.new = program, program.toolpath, toolpath
        self.tolerance = tolerance
        self.course = course = program.as_they_run()
        self.text, self.blocks, self.at, self.owner = course.text, course.blocks, course.at, course.owner
        inch = bool((program.modal.unit == 20).any())
        scale = INCH if inch else 1.0
        if decimals is None:
            # Rounding a point errs by half a unit in each of two axes: keep that within half the tolerance.
            needed = math.ceil(-math.log10(tolerance / (math.sqrt(2.0) * scale)) - 1e-9)
            decimals = min(max(program.style.decimals, needed, 0), 9)
        mark = "," if re.search(rb"[XYZ][-+]?\d+,\d", program.data) else "."
        self.numbers = Numbers(program.style, scale, decimals, mark)
        self.machine = Machine(program.name)
        self.machine.scale = scale
        self.out: list[list[Line]] = []
        """What stands for every block that runs."""
        self.pole: _OpenPole | None = None
        lines = np.arange(program.run.blocks + 1)
        self.old_first = np.searchsorted(self.old.source, lines)
        self.new_first = np.searchsorted(self.new.source, lines)
        self.opaque = set(self.old.source[program.opaque_moves()].tolist())
        self.changed = self._changed()
        self.loose = False
        """The control computes where the tool is: behind a departure, until the place is stated."""

    def lines(self) -> list[list[Line]]:
        """What stands for every block of the text, for each of them."""
        as_read = [[Line(block.text, block.ending, block.number)] for block in self.text]
        if not self.changed:
            return as_read
        k = 0
        while k < len(self.blocks):
            k = self._from(k)
        first: dict[int, int] = {}
        for k, owner in enumerate(self.owner):
            if owner not in first:
                first[owner] = k
                as_read[owner] = self.out[k]
            elif not _alike(self.out[k], as_read[owner]):
                self._refuse_runs(first[owner], k)
        return as_read

    def _refuse_runs(self, a: int, b: int) -> NoReturn:
        runs = [k for k, owner in enumerate(self.owner) if owner == self.owner[a]]

        def named(k: int) -> str:
            row = int(self.old_first[self.at[k]])
            height = float(self.old.end[row, 2]) if row < len(self.old) else math.nan
            return f"run {runs.index(k) + 1}" + ("" if math.isnan(height) else f" at Z{height:g}")

        raise FormatError(
            phrase(
                "this line runs {} times, and its {} and {} want other words: write the runs out, each "
                "with lines of its own",
                len(runs),
                named(a),
                named(b),
            ),
            self.program.name,
            self.blocks[a].first + 1,
        )

    # -- what has changed ----------------------------------------------------------------------------------

    def _changed(self) -> set[int]:
        """Lines whose moves are not those that were read."""
        if self.old is self.new:
            return set()
        was, now = np.diff(self.old_first), np.diff(self.new_first)
        out = set(np.flatnonzero(was != now).tolist())
        same = (was == now) & (was > 0)
        a = np.flatnonzero(same[self.old.source])
        b = np.flatnonzero(same[self.new.source])
        out |= set(self.old.source[a][_differ(self.old.take(a), self.new.take(b))].tolist())
        return out

    def _wanted(self, line: int) -> list[Row]:
        t = self.new
        return [_row(t, i) for i in range(int(self.new_first[line]), int(self.new_first[line + 1]))]

    # -- the walk ------------------------------------------------------------------------------------------

    def _from(self, k: int) -> int:
        """Write a block, with those that corners join to it; return the one behind."""
        block = self.blocks[k]
        if block.kind == "BEGIN PGM":
            self.machine.scale = scale_of(block, self.program.name)
        at = self.at[k]
        moves = self.old_first[at] < self.old_first[at + 1]
        wanted = self.new_first[at] < self.new_first[at + 1]
        if not moves and not wanted:
            if block.kind == "CC":
                self.pole = _OpenPole(len(self.out), block, list(self.machine.position))
            self.machine.execute(self.blocks, k)
            self._keep(block)
            return k + 1
        if at in self.opaque:
            self._opaque(k)
            return k + 1
        if block.kind in APPROACHES:
            self._approach(k)
            return k + 1
        if block.kind in DEPARTURES:
            self._departure(k)
            return k + 1
        last = self._chain(k)
        if last > k:
            if self._keep_chain(k, last):
                return last + 1
            corners = self._corners(k, last)
            for j in range(k, last + 1):
                if self.old_first[self.at[j]] == self.old_first[self.at[j] + 1]:
                    self.machine.execute(self.blocks, j)
                    self._keep(self.blocks[j])
                elif j in corners:
                    self._corner(j, corners[j])
                else:
                    behind = self._behind(j)
                    self._explicit(j, corners.get(behind) if behind is not None else None)
            return last + 1
        if not self._as_it_is(k):
            self._explicit(k)
        return k + 1

    def _keep(self, block: Block) -> None:
        self.out.append([Line(block.text, block.ending, block.number)])

    def _chain(self, k: int) -> int:
        """Last block that corners (RND, CHF) join to a contour element."""
        last = k
        if not self.blocks[k].moves:
            return k
        while True:
            corner = self._behind(last)
            if corner is None or self.blocks[corner].kind not in CORNERS or self.at[corner] in self.opaque:
                return last
            element = self._behind(corner)
            if element is None:
                return last
            last = element

    def _behind(self, k: int) -> int | None:
        """The next block that moves."""
        for j in range(k + 1, len(self.blocks)):
            kind = self.blocks[j].kind
            if self.blocks[j].moves or kind in CORNERS:
                return j
            if kind not in (*SILENT, "L", ""):
                return None
        return None

    def _corners(self, first: int, last: int) -> dict[int, _Corner]:
        """Corners between blocks that remain what they are, in other places: RND and CHF with the sizes they need."""
        out = {}
        before = first
        for k in range(first, last + 1):
            block = self.blocks[k]
            if block.kind in CORNERS:
                behind = self._behind(k)
                assert behind is not None
                rows = [self._wanted(self.at[j]) for j in (before, k, behind)]
                if all(rows) and len(rows[1]) == 1:
                    found = self._corner_between(block, rows[0][-1], rows[1][0], rows[2][0])
                    if found is not None:
                        out[k] = found
            elif block.moves:
                before = k
        return out

    def _corner_between(self, block: Block, before: Row, move: Row, behind: Row) -> _Corner | None:
        """Place and size of a corner between two lines, if rounding leaves the wanted moves within the tolerance."""
        if before.kind != Kind.LINE or behind.kind != Kind.LINE:
            return None
        assert before.element is not None and behind.element is not None and move.element is not None
        u, v = before.element.direction(at_end=True), behind.element.direction(at_end=False)
        cross = (u.conjugate() * v).imag
        if (move.kind == Kind.ARC) != (block.kind == "RND") or abs(cross) < 1e-6:
            return None
        way = behind.element.start - before.element.end
        exact = before.element.end + u * (way.conjugate() * v).imag / cross
        place = complex(*(self.numbers.round(x) * self.numbers.scale for x in (exact.real, exact.imag)))
        if move.element.centre is not None:
            length = abs(move.element.start - move.element.centre)
        else:
            length = (abs(before.element.end - exact) + abs(behind.element.start - exact)) / 2
        size = self.numbers.round(length)
        make = rounded if block.kind == "RND" else chamfered
        try:
            parts = make(
                Element(before.element.start, place), Element(place, behind.element.end), size * self.numbers.scale
            )
        except Impossible:
            return None
        middle = _middle(Row(move.kind, [], [], parts[1], move.plane, 0.0, 0, 0, 0))
        gaps = (
            abs(parts[1].start - move.element.start),
            abs(parts[1].end - move.element.end),
            abs(middle - _middle(move)),
        )
        if max(gaps) > self.tolerance / 4:
            return None
        return _Corner(place, size, behind)

    def _corner(self, k: int, corner: _Corner) -> None:
        """Write an RND or CHF with the size that its corner needs."""
        block = self.blocks[k]
        self.out.append([])
        draft = Draft.of(block)
        name = "R" if block.kind == "RND" else "CHF"
        piece = draft.find(name)
        if piece is not None and self.machine.parameters.number(piece.value) != corner.size:
            self._free(draft, name)
            draft.put(name, self.numbers.text(corner.size, signed=piece.value[:1] in "+-"), repr(corner.size))
        self._add(block, [draft])
        a, b, _ = corner.behind.plane.axes
        onward = Draft("", "L")
        for axis in (a, b):
            value = self.numbers.round(corner.behind.end[axis])
            onward.put(AXES[axis], self.numbers.text(value), repr(value))
        ahead = [read_block(text, block.first, block.last, self.program.name) for text in (draft.text(), onward.text())]
        self.machine.execute(ahead, 0)

    def _keep_chain(self, first: int, last: int) -> bool:
        """Keep blocks that corners join, where all of them give what is wanted."""
        here = range(first, last + 1)
        if any(self.at[k] in self.changed for k in here):
            return False
        trial = self.machine.copy()
        rows: list[Row] = []
        for k in here:
            rows += trial.execute(self.blocks, k)
        wanted = [row for k in here for row in self._wanted(self.at[k])]
        if not self._gives(rows, wanted, trial, start=True):
            return False
        for k in here:
            self._use_pole(self.blocks[k])
            self._keep(self.blocks[k])
        self.machine = trial
        return True

    def _as_it_is(self, k: int) -> bool:
        """Keep a block whose own text gives the wanted moves."""
        block = self.blocks[k]
        if block.kind in CORNERS:
            return False
        trial = self.machine.copy()
        try:
            rows = trial.execute(self.blocks, k)
        except FormatError:
            return False
        if trial.reasons or not self._gives(rows, self._wanted(self.at[k]), trial):
            return False
        self.machine = trial
        self._use_pole(block)
        self._keep(block)
        self.loose = self.loose and not _states_place(block)
        return True

    def _gives(self, rows: list[Row], wanted: list[Row], machine: Machine, start: bool = False) -> bool:
        if len(rows) != len(wanted):
            return False
        slack = self.numbers.unit + self.tolerance if self.loose else 0.0
        for row, goal in zip(rows, wanted, strict=True):
            if row.kind != goal.kind or not _close(row.end, goal.end, SAME, loose=slack):
                return False
            if start and not _close(row.start, goal.start, SAME):
                return False
            if row.kind == Kind.ARC and not (
                _close(row.centre, goal.centre, SAME) and abs(row.sweep - goal.sweep) <= 1e-9
            ):
                return False
            if row.kind != Kind.RAPID and not _same_feed(row.feed, goal.feed):
                return False
        return True

    def _free(self, draft: Draft, name: str) -> None:
        """Refuse to state the number of a word whose parameter anything else uses."""
        piece = draft.find(name)
        found = re.search(r"Q[LR]?\d+", piece.value) if piece is not None else None
        if found is None:
            return
        q = found.group()
        used = [b.first + 1 for b in self.text for n in _USES.findall(b.rest if b.kind else b.text.upper()) if n == q]
        used += [b.first + 1 for b in self.text for w in b.words if w.name == "M" and w.value == q]
        if len(used) > 1:
            origin = self.machine.parameters.origin.get(q)
            came = q if origin is None else f"{q}, set in line {origin + 1},"
            listed = ", ".join(map(str, sorted(set(used))))
            raise FormatError(
                phrase(
                    "{}{} cannot be corrected: {} is used {} times (line {}); state the numbers in these lines",
                    name,
                    piece.value if piece else "",
                    came,
                    len(used),
                    listed,
                ),
                self.program.name,
                self.blocks[len(self.out) - 1].first + 1,
            )

    def _use_pole(self, block: Block) -> None:
        if block.kind in ("C", "LP", "CP", "CTP"):
            self.pole = None

    # -- opaque blocks and leads ---------------------------------------------------------------------------

    def _opaque(self, k: int) -> None:
        """A block that cannot be corrected stays, if it still goes where it went."""
        block = self.blocks[k]
        line = self.at[k]
        old = [_row(self.old, i) for i in range(int(self.old_first[line]), int(self.old_first[line + 1]))]
        rows = self.machine.execute(self.blocks, k)
        self.pole = None
        goal = self._wanted(line)
        a, b, _ = self.machine.plane.axes
        still = [abs(r.end[j] - r.start[j]) for r in old for j in (a, b)]
        # A retraction along the tool axis starts wherever the path before it now ends.
        retracts = len(old) == 1 and all(not way > SAME for way in still) and block.find("X") is block.find("Y") is None
        if not retracts and (line in self.changed or len(goal) != len(old)):
            self.program.require_plain(self.old.source == line)
        for row, was in zip(rows, old, strict=False):
            off = [abs(x - y) for x, y in zip(row.end, was.end, strict=True)]
            if not retracts and any(way > self.numbers.unit + SAME for way in off):
                axis = AXES[int(np.nanargmax(off))]
                said = f"the position before this line has changed, but not its move: state {axis} here"
                raise FormatError(said, self.program.name, block.first + 1)
        self._keep(block)

    def _approach(self, k: int) -> None:
        """An approach leads to the contour's first place; its own way the control computes anew."""
        block = self.blocks[k]
        wanted = self._wanted(self.at[k])
        if not wanted:
            self.program.require_plain(self.old.source == self.at[k])
        goal = wanted[-1]
        trial = self.machine.copy()
        end = trial.end_of_lead(block)
        self._use_pole(block)
        if _close(end, goal.end, SAME):
            self._keep(block)
        else:
            self.out.append([])
            draft = Draft.of(block)
            end = self._put_end(draft, block, goal, polar="P" in block.kind.split()[1])
            self._add(block, [draft])
        self.machine.take_lead(block, end, goal)
        self.loose = False

    def _departure(self, k: int) -> None:
        block = self.blocks[k]
        wanted = self._wanted(self.at[k])
        text: list[Draft] | None = None
        if wanted and "LCT" in block.kind:
            trial = self.machine.copy()
            if not _close(trial.end_of_lead(block), wanted[-1].end, SAME):
                text = [Draft.of(block)]
                self._put_end(text[0], block, wanted[-1], polar="P" in block.kind.split()[1])
        if text is None:
            self._keep(block)
            self.machine.execute(self.blocks, k)
        else:
            self.out.append([])
            self._add(block, text)
            self.machine.execute([read_block(text[0].text(), block.first, block.last, self.program.name)], 0)
            self.loose = False
        self._use_pole(block)
        self.loose = text is None and "LCT" not in block.kind

    # -- blocks written anew -------------------------------------------------------------------------------

    def _add(self, block: Block, drafts: list[Draft]) -> None:
        between = block.ending or self.program.style.ending.decode()
        for draft in drafts:
            text = draft.text()
            if self.out[-1]:
                self.out[-1][-1].ending = between
            ending = block.ending
            span = read_block(text, block.first, block.last, self.program.name).number
            self.out[-1].append(Line(text, ending, span, as_read=False, own=draft.own))

    def _explicit(self, k: int, corner: _Corner | None = None) -> None:
        """Write the moves of a block as lines and arcs of its own, the last one up to the corner behind it."""
        block = self.blocks[k]
        wanted = self._wanted(self.at[k])
        self.out.append([])
        self._require_continuous(block, wanted)
        if not wanted:
            self._without_moves(block)
            return
        parts = [part for move in wanted for part in self._divided(block, move)]
        if corner is not None:
            parts[-1] = _up_to(parts[-1], corner.place)
        late = [w for w in block.words if w.name == "M" and w.value.isdigit() and int(w.value) in _ACTS_AT_END]
        for i, part in enumerate(parts):
            draft = Draft.of(block) if i == 0 else Draft(self._opening(block), "", block.increments)
            if i == 0 and len(parts) > 1 and late:
                kept = draft.take("M")
                ending = [p for p in kept if p.value.isdigit() and int(p.value) in _ACTS_AT_END]
                draft.pieces += [p for p in kept if p not in ending]
            if i == len(parts) - 1 and i and late:
                draft.pieces += ending
            self._write(block, draft, part, first=i == 0)
        self.loose = False

    def _opening(self, block: Block) -> str:
        """Number and blanks of a block that is inserted behind another one."""
        if block.number[0] == block.number[1] or self.program.style.number_step == 1:
            return block.text[: block.head]
        return block.text[: block.number[0]]

    def _without_moves(self, block: Block) -> None:
        """A block that moves no more, without its target; nothing where nothing else stands on it."""
        draft = Draft.of(block)
        draft.remove(*AXES, "PR", "PA", "R", "DR", "CHF")
        if draft.pieces or block.stop < len(block.text):
            draft.kind = "L"
            self._add(block, [draft])
            self.machine.execute([read_block(draft.text(), block.first, block.last, self.program.name)], 0)

    def _require_continuous(self, block: Block, wanted: list[Row]) -> None:
        allowed = 2 * self.numbers.unit + self.tolerance
        at = self.machine.start()
        for move in wanted:
            off = [abs(x - y) for x, y in zip(at, move.start, strict=True)]
            if not self.loose and any(way > allowed for way in off):
                raise InputError(
                    phrase(
                        "toolpath: a move of line {} of {} starts {} from where the one before ends",
                        block.first + 1,
                        self.program.name,
                        mm(np.nanmax(off), ".4f"),
                    )
                )
            at = move.end

    def _divided(self, block: Block, move: Row) -> list[Row]:
        """An arc that its words could not state well as two."""
        if move.kind == Kind.CUBIC:
            said = message(
                "plain-language programs have no spline block: let ", option("output_moves"), " be arcs or lines"
            )
            raise FormatError(said, self.program.name, block.first + 1)
        if move.kind != Kind.ARC or abs(move.sweep) <= _NEARLY_HALF or self._by_centre(block, move):
            return [move]
        a, b, c = move.plane.axes
        count = math.ceil(abs(move.sweep) / _NEARLY_HALF)
        assert move.element is not None and move.element.centre is not None
        centre, arm = move.element.centre, move.element.start - move.element.centre
        ends = [centre + arm * cmath.exp(1j * move.sweep * i / count) for i in range(1, count)]
        out, at = [], move.start
        for i in range(count):
            to = list(move.end)
            if i < count - 1:
                to[a], to[b] = ends[i].real, ends[i].imag
                to[c] = move.start[c] + (move.end[c] - move.start[c]) * (i + 1) / count
            out.append(_arc(move, at, to, move.sweep / count))
            at = to
        return out

    def _by_centre(self, block: Block, move: Row) -> bool:
        """Whether an arc is written about its centre: where the block is one, and its pole may move with it."""
        return block.kind in ("C", "CP") and self._pole_may_move(block, move)

    def _pole_may_move(self, block: Block, move: Row) -> bool:
        """Whether no other block relies on the pole as it is."""
        a, b, _ = move.plane.axes
        centre = move.centre
        near = abs(self.machine.pole[a] - centre[a]) <= SAME and abs(self.machine.pole[b] - centre[b]) <= SAME
        if near:
            return True
        for at, other in zip(self.at[len(self.out) :], self.blocks[len(self.out) :], strict=True):
            if other.kind == "CC":
                break
            if other.kind in ("LP", "CTP", *(k for k in (*APPROACHES, *DEPARTURES) if " P" in k)):
                return False
            if other.kind in ("C", "CP") and at not in self.changed:
                return False
        return True

    def _write(self, block: Block, draft: Draft, move: Row, first: bool) -> None:
        """Change a draft so that it makes a move, and carry it out."""
        kind = block.kind if first else ""
        polar = kind in ("LP", "CP")
        if first and kind in ("CT", "CTP") and (tangent := self._tangential(draft, block, move)) is not None:
            draft = tangent
        elif move.kind == Kind.ARC:
            if first and kind == "CP" and self._by_centre(block, move):
                self._put_pole(block, move)
                self._put_polar_arc(draft, move)
                polar = False
            elif first and kind == "C" and self._by_centre(block, move):
                self._put_arc_about_centre(draft, block, move)
                polar = False
            else:
                if not self._put_arc_by_radius(draft, block, move, first):
                    # Too flat to be an arc within the tolerance.
                    self._put_line(draft, block, move, polar and first)
        else:
            self._put_line(draft, block, move, kind == "LP")
        self._put_feed(draft, move)
        text = draft.text()
        read = read_block(text, block.first, block.last, self.program.name)
        rows = self.machine.execute([read], 0)
        if self.machine.reasons or len(rows) > 1:
            raise FormatError(
                phrase("'{}' would not be read: {}", text.strip(), self.machine.reasons),
                self.program.name,
                block.first + 1,
            )
        off = [abs(x - y) for row in rows for x, y in zip(row.end, move.end, strict=True)]
        if not self.loose and any(way > 2 * self.numbers.unit + self.tolerance for way in off):
            raise InputError(phrase("toolpath: line {} of {} cannot be written", block.first + 1, self.program.name))
        if not rows and not first:
            return
        if first or rows:
            self._add(block, [draft])

    def _tangential(self, draft: Draft, block: Block, move: Row) -> Draft | None:
        """The block with another end, where its arc on the tangent is the wanted one."""
        out = draft.copy()
        if block.kind == "CT":
            self._put_axes(out, move)
        else:
            self._put_polar(out, move)
        trial = self.machine.copy()
        rows = trial.execute([read_block(out.text(), block.first, block.last, self.program.name)], 0)
        if trial.reasons or len(rows) != 1 or rows[0].kind != move.kind:
            return None
        gaps = [
            abs(_middle(rows[0]) - _middle(move)),
            *(abs(x - y) for x, y in zip(rows[0].end, move.end, strict=True)),
        ]
        return out if all(not gap > self.tolerance / 4 for gap in gaps) else None

    def _put_line(self, draft: Draft, block: Block, move: Row, polar: bool) -> None:
        draft.remove("R", "DR", "CHF", "CCA")
        if polar and self._polar_is_fine(move):
            draft.kind = "LP"
            self._put_polar(draft, move)
            return
        if draft.kind.upper() != "L" and not (draft.kind == "" and any(p.name in AXES for p in draft.pieces)):
            draft.kind = "L"
        draft.remove("PR", "PA")
        self._put_axes(draft, move)

    def _put_axes(self, draft: Draft, move: Row) -> list[float]:
        """State X, Y and Z where they are not what the tool's place or the words already give."""
        at = self.machine.position
        end = list(at)
        for k, axis in enumerate(AXES):
            wanted = move.end[k]
            piece = draft.find(axis)
            if math.isnan(wanted):
                continue
            base = at[k] if draft.counts_on(axis) else 0.0
            if piece is not None:
                stated = self.machine.parameters.number(piece.value) * self.numbers.scale + base
                if abs(stated - wanted) <= SAME:
                    end[k] = stated
                    continue
            value = self.numbers.round(wanted - base)
            reached = base + value * self.numbers.scale
            still = abs(move.end[k] - move.start[k]) <= SAME and (
                self.loose or abs(reached - end[k]) <= self.numbers.unit
            )
            if piece is not None or not (still or abs(reached - end[k]) <= SAME):
                self._free(draft, axis)
                draft.put(axis, self.numbers.text(value), repr(value))
                end[k] = reached
        return end

    def _put_end(self, draft: Draft, block: Block, move: Row, polar: bool) -> list[float]:
        """State the end of an approach or departure."""
        if polar and self._polar_is_fine(move):
            self._put_polar(draft, move)
        else:
            if polar:
                draft.kind = draft.kind.replace(" P", " ").replace(" p", " ")
                draft.remove("PR", "PA")
            self._put_axes(draft, move)
        read = read_block(draft.text(), block.first, block.last, self.program.name)
        return self.machine.copy().end_of_lead(read)

    def _polar_is_fine(self, move: Row) -> bool:
        a, b, _ = move.plane.axes
        way = complex(move.end[a] - self.machine.pole[a], move.end[b] - self.machine.pole[b])
        if cmath.isnan(way) or abs(way) < SAME:
            return False
        return abs(way) * math.radians(0.5 * 10.0**-_ANGLE_DECIMALS) <= self.tolerance / 4

    def _put_polar(self, draft: Draft, move: Row) -> None:
        # What is written about a pole holds it where it is.
        self.pole = None
        a, b, c = move.plane.axes
        pole = complex(self.machine.pole[a], self.machine.pole[b])
        here = complex(self.machine.position[a], self.machine.position[b])
        way = complex(move.end[a], move.end[b]) - pole
        radius, angle = abs(way), math.degrees(cmath.phase(way))
        base = abs(here - pole) if draft.counts_on("PR") else 0.0
        value = self.numbers.round(radius - base)
        draft.put("PR", self.numbers.text(value), repr(value))
        piece = draft.find("PA")
        angle -= math.degrees(cmath.phase(here - pole)) if draft.counts_on("PA") else 0.0
        if piece is not None:
            was = self.machine.parameters.number(piece.value)
            # The turn that the program counts from stays.
            angle += 360.0 * round((was - angle) / 360.0)
        digits = max(_ANGLE_DECIMALS, self.numbers.decimals)
        draft.put("PA", self.numbers.text(angle, digits), repr(round(angle, digits)))
        self._put_height(draft, move, c)

    def _put_height(self, draft: Draft, move: Row, c: int) -> None:
        axis, piece = AXES[c], draft.find(AXES[c])
        at = self.machine.position[c]
        base = at if draft.counts_on(axis) else 0.0
        if math.isnan(move.end[c]):
            return
        if (
            piece is not None
            and abs(self.machine.parameters.number(piece.value) * self.numbers.scale + base - move.end[c]) <= SAME
        ):
            return
        if piece is not None or abs(move.end[c] - at) > SAME:
            value = self.numbers.round(move.end[c] - base)
            draft.put(axis, self.numbers.text(value), repr(value))

    def _put_polar_arc(self, draft: Draft, move: Row) -> None:
        """CP: the angle it turns by, about the pole."""
        a, b, c = move.plane.axes
        pole = complex(self.machine.pole[a], self.machine.pole[b])
        here = complex(self.machine.position[a], self.machine.position[b])
        start = math.degrees(cmath.phase(here - pole))
        there = complex(move.end[a], move.end[b])
        turns = math.degrees(move.sweep)
        exact = start + math.degrees(angle_between(here, there, pole, move.sweep > 0))
        exact += 360.0 * round((start + turns - exact) / 360.0)
        piece = draft.find("PA")
        angle = exact - (start if draft.counts_on("PA") else 0.0)
        if piece is not None and not piece.incremental:
            angle += 360.0 * round((self.machine.parameters.number(piece.value) - angle) / 360.0)
        digits = max(_ANGLE_DECIMALS, self.numbers.decimals)
        draft.remove("PR")
        draft.put("PA", self.numbers.text(angle, digits), repr(round(angle, digits)))
        draft.put("DR", "+" if move.sweep > 0 else "-", "+" if move.sweep > 0 else "-")
        self._put_height(draft, move, c)

    def _put_pole(self, block: Block, move: Row) -> None:
        """Have the pole where an arc has its centre."""
        a, b, _ = move.plane.axes
        start = self.machine.start()
        s, e = complex(start[a], start[b]), complex(move.end[a], move.end[b])
        e = complex(*(self.numbers.round(v) * self.numbers.scale for v in (e.real, e.imag))) if abs(e - s) > SAME else s
        centre = self._centre_on_grid(move, s, e)
        self._set_pole(block, centre, move.plane)

    def _put_arc_about_centre(self, draft: Draft, block: Block, move: Row) -> None:
        a, b, _ = move.plane.axes
        start = self.machine.start()
        s = complex(start[a], start[b])
        closed = abs(abs(move.sweep) - 2 * math.pi) < 1e-9
        if closed:
            move = _arc(
                move,
                move.start,
                [s.real if j == a else s.imag if j == b else move.end[j] for j in range(3)],
                move.sweep,
            )
        end = self._put_axes(draft, move)
        if closed:
            for k in (a, b):
                # Its end is exactly where the tool stands.
                piece = draft.find(AXES[k])
                if piece is not None and abs(end[k] - start[k]) > SAME:
                    draft.remove(AXES[k])
                end[k] = start[k]
        e = complex(end[a], end[b])
        centre = self._centre_on_grid(move, s, e)
        sweep = angle_between(s, e, centre, move.sweep > 0)
        slack = (3 * self.numbers.unit + self.tolerance) / max(abs(s - centre), 1e-12)
        if abs(sweep - move.sweep) > slack:
            raise FormatError(
                phrase("rounding would make another arc of this one: allow more decimals"),
                self.program.name,
                block.first + 1,
            )
        self._set_pole(block, centre, move.plane)
        draft.put("DR", "+" if move.sweep > 0 else "-", "+" if move.sweep > 0 else "-")

    def _set_pole(self, block: Block, centre: complex, plane: Plane) -> None:
        """Change the CC before, where nothing has used it, or insert one."""
        a, b, _ = plane.axes
        pole = self.machine.pole
        if abs(complex(pole[a], pole[b]) - centre) <= SAME:
            self.pole = None
            return
        if self.pole is not None:
            draft = Draft.of(self.pole.block)
            position, place = self.pole.position, self.pole.run
        else:
            draft, position, place = Draft(self._opening(block), "CC", block.increments), self.machine.position, -1
        for k, value in ((a, centre.real), (b, centre.imag)):
            piece = draft.find(AXES[k])
            base = position[k] if draft.counts_on(AXES[k]) else 0.0
            number = self.numbers.round(value - base)
            if piece is None or self.machine.parameters.number(piece.value) != number:
                self._free(draft, AXES[k])
                draft.put(AXES[k], self.numbers.text(number), repr(number))
            value = base + number * self.numbers.scale
            self.machine.pole[k] = value
        if place >= 0 and self.pole is not None:
            old = self.out[place][0]
            self.out[place] = [Line(draft.text(), old.ending, self.pole.block.number, as_read=False)]
        else:
            self._add(block, [draft])
        self.machine.polar_radius = math.nan
        self.pole = None

    def _centre_on_grid(self, move: Row, s: complex, e: complex) -> complex:
        """Of the centres near the wanted one that numbers can state the one whose radii at both ends agree best."""
        assert move.element is not None and move.element.centre is not None
        wanted = move.element.centre
        arm = move.element.start - wanted
        middle = [wanted + arm * cmath.exp(1j * move.sweep * t) for t in (0.25, 0.5, 0.75)]
        best, out = math.inf, wanted
        steps = 10.0**self.numbers.decimals
        scale = self.numbers.scale
        for di, dj in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            centre = complex(
                (round(wanted.real / scale * steps) + di) / steps * scale,
                (round(wanted.imag / scale * steps) + dj) / steps * scale,
            )
            first, last = abs(s - centre), abs(e - centre)
            off = [
                abs(abs(p - centre) - (first + (last - first) * t))
                for p, t in zip(middle, (0.25, 0.5, 0.75), strict=True)
            ]
            cost = max(off) + abs(first - last)
            if cost < best:
                best, out = cost, centre
            if best <= 0.5 * self.numbers.unit:
                break
        return out

    def _put_arc_by_radius(self, draft: Draft, block: Block, move: Row, first: bool) -> bool:
        """CR: the end, the radius and the sense of rotation; False where a line is as good."""
        a, b, _ = move.plane.axes
        assert move.element is not None and move.element.centre is not None
        radius = abs(move.element.start - move.element.centre)
        trial = draft.copy()
        trial.kind = "CR"
        trial.remove("PR", "PA", "CHF")
        end = self._put_axes(trial, move)
        start = self.machine.start()
        s, e = complex(start[a], start[b]), complex(end[a], end[b])
        sagitta = radius * (1 - math.cos(min(abs(move.sweep), math.pi) / 2))
        number = self.numbers.round(radius)
        try:
            arc = by_radius(s, e, number * self.numbers.scale, move.sweep > 0)
        except Impossible:
            arc = None
        if arc is not None and arc.centre is not None:
            arm = move.element.start - move.element.centre
            middle = move.element.centre + arm * cmath.exp(0.5j * move.sweep)
            if (
                abs(abs(middle - arc.centre) - abs(s - arc.centre)) <= self.tolerance / 2
                and abs(arc.sweep - move.sweep) < 1
            ):
                trial.put("R", self.numbers.text(number), repr(number))
                trial.put("DR", "+" if move.sweep > 0 else "-", "+" if move.sweep > 0 else "-")
                draft.kind, draft.pieces = trial.kind, trial.pieces
                return True
        if sagitta <= self.tolerance / 2:
            return False
        raise FormatError(
            phrase("rounding would make another arc of this one: allow more decimals"),
            self.program.name,
            block.first + 1,
        )

    def _put_feed(self, draft: Draft, move: Row) -> None:
        if move.kind == Kind.RAPID:
            if draft.find("F") is None or draft.find("F").value != "MAX":  # type: ignore[union-attr]
                draft.put("F", "MAX", "MAX")
            return
        piece = draft.find("F")
        if math.isnan(move.feed):
            return
        stated = math.nan
        if piece is not None and piece.value not in ("", "MAX", "AUTO"):
            stated = self.machine.speed(self.machine.parameters.number(piece.value))
        elif piece is not None and piece.value == "AUTO":
            stated = self.machine.speed(self.machine.tool_feed)
        elif piece is None or not piece.value:
            stated = self.machine.feed
        if not _same_feed(stated, move.feed):
            number = move.feed * 60.0 / (INCH / 10 if self.numbers.scale != 1.0 else 1.0)
            text = f"{number:.6f}".rstrip("0").rstrip(".").replace(".", self.numbers.mark)
            draft.put("F", text, repr(number))


def _row(t: Toolpath, i: int) -> Row:
    plane = Plane(int(t.plane[i]))
    a, b, _ = plane.axes
    start, end, centre = t.start[i].tolist(), t.end[i].tolist(), t.centre[i].tolist()
    kind = Kind(int(t.kind[i]))
    element = Element(
        complex(start[a], start[b]),
        complex(end[a], end[b]),
        complex(centre[a], centre[b]) if kind == Kind.ARC and not math.isnan(centre[a]) else None,
        float(t.sweep[i]),
    )
    feed, line = float(t.feed[i]), int(t.source[i])
    return Row(kind, start, end, element, plane, feed, line, int(t.compensation[i]), int(t.tool[i]))


def _arc(move: Row, start: list[float], end: list[float], sweep: float) -> Row:
    a, b, _ = move.plane.axes
    assert move.element is not None
    element = Element(complex(start[a], start[b]), complex(end[a], end[b]), move.element.centre, sweep)
    return Row(move.kind, start, end, element, move.plane, move.feed, move.line, move.compensation, move.tool)


def _up_to(move: Row, place: complex) -> Row:
    """A line that goes on to another place."""
    a, b, _ = move.plane.axes
    assert move.element is not None
    end = list(move.end)
    end[a], end[b] = place.real, place.imag
    return replace(move, end=end, element=Element(move.element.start, place))


def _middle(move: Row) -> complex:
    """Place halfway along a move, in its plane."""
    element = move.element
    assert element is not None
    if element.centre is None:
        return (element.start + element.end) / 2
    return element.centre + (element.start - element.centre) * cmath.exp(0.5j * element.sweep)


def _differ(old: Toolpath, new: Toolpath) -> Bools:
    """Rows of two toolpaths of one length that are not the same, (n,)."""
    out: Bools = old.kind != new.kind
    for name, within in (("end", SAME), ("centre", SAME), ("sweep", 1e-12), ("feed", 1e-9)):
        a, b = (np.reshape(getattr(t, name), (len(t), -1)) for t in (old, new))
        out |= ~((np.abs(a - b) <= within) | (np.isnan(a) & np.isnan(b))).all(axis=1)
    return out


def _same_feed(a: float, b: float) -> bool:
    return (math.isnan(a) and math.isnan(b)) or abs(a - b) <= 1e-9 * abs(b)


def _alike(run: list[Line], other: list[Line]) -> bool:
    """Whether two runs of a block come to the same text."""
    kept = all(line.as_read for line in (*run, *other))
    return kept or [line.text for line in run] == [line.text for line in other]


def _states_place(block: Block) -> bool:
    return (block.find("X") is not None and block.find("Y") is not None) or block.find("PR") is not None


def _close(a: Sequence[float], b: Sequence[float], within: float, loose: float = 0.0) -> bool:
    return all(abs(x - y) <= max(within, loose) or (math.isnan(x) and math.isnan(y)) for x, y in zip(a, b, strict=True))


def _numbered(lines: list[Line], program: KlartextProgram) -> str:
    """The text; block numbers that followed one another do so again."""
    if program.style.number_step != 1:
        return "".join(line.text + line.ending for line in lines)
    out, number = [], None
    for line in lines:
        first, last = line.number
        text = line.text
        if first < last:
            own = text[first:last]
            number = int(own) if number is None else number + 1
            text = (
                text[:first] + str(number).zfill(len(own) if own.startswith("0") and len(own) > 1 else 0) + text[last:]
            )
        out.append(text + line.ending)
    return "".join(out)


def _with_header(lines: list[Line], program: KlartextProgram, header: Sequence[str]) -> list[Line]:
    """Lines with comment blocks behind BEGIN PGM."""
    top = next((i + 1 for i, line in enumerate(lines) if "BEGIN" in line.text.upper()), 0)
    numbered = program.style.number_step == 1
    added = []
    for text in comment_texts(header):
        body = f"; {text}"
        number = (0, 1) if numbered else (0, 0)
        added.append(Line(f"0 {body}" if numbered else body, program.style.ending.decode(), number, False))
    return [*lines[:top], *added, *lines[top:]]
