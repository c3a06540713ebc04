# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves of one line of an NC program, written in the state the control has there."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from millcorr.errors import FormatError, InputError
from millcorr.messages import mm, phrase
from millcorr.nc.toolpath import Kind, Plane

from .line import Line
from .statements import Piece
from .style import Style

SAME = 1e-9
"""Two coordinates in mm closer than this are equal."""
_LEANING = "acdghlmnoqrt"
"""Words whose meaning hangs on other moves than their own: such a line is written out when one of these changes."""
_TURN = 2 * math.pi
_PATH_CODES = (0, 1, 2, 3, 5)
# Program stops, spindle and coolant off act when the moves of their line are done.
_ACTS_AT_END = (0, 1, 2, 5, 9, 30, 60, 99)

Point = tuple[float, float]


@dataclass(slots=True)
class State:
    """What the control knows when it comes to a line.

    Parameters
    ----------
    position : list of three float
        Position in mm after rounding; NaN where unknown.
    motion : int
        Motion code in force times ten; -1 where unknown.
    feed : float
        F word in force, in the program's unit per minute; NaN before any.
    tangent : pair of float, optional
        P and Q of the spline just before, in the program's unit.
    """

    position: list[float]
    motion: int
    feed: float
    tangent: Point | None = None


@dataclass(frozen=True, slots=True)
class Move:
    """A row of a `Toolpath` as plain numbers, in mm, rad and mm/s."""

    kind: int
    start: tuple[float, ...]
    end: tuple[float, ...]
    centre: tuple[float, ...]
    sweep: float
    control: tuple[float, ...]
    plane: int
    feed: float

    @property
    def code(self) -> int:
        """Number of the G code that makes such a move."""
        if self.kind == Kind.ARC:
            return 2 if self.sweep < 0 else 3
        return {Kind.RAPID: 0, Kind.LINE: 1, Kind.CUBIC: 5}[Kind(self.kind)]

    @property
    def turns(self) -> int:
        """Number of turns an arc begins."""
        return max(math.ceil(abs(self.sweep) / _TURN - 1e-9), 1)

    @property
    def closed(self) -> bool:
        """Whether an arc ends where it starts."""
        return self.kind == Kind.ARC and abs(abs(self.sweep) - _TURN * self.turns) < 1e-9

    def halves(self) -> list[Move]:
        """An arc of up to one turn as two."""
        a, b, c = Plane(self.plane).axes
        u, v = self.start[a] - self.centre[a], self.start[b] - self.centre[b]
        cos, sin = math.cos(self.sweep / 2), math.sin(self.sweep / 2)
        middle = list(self.start)
        middle[a] = self.centre[a] + u * cos - v * sin
        middle[b] = self.centre[b] + u * sin + v * cos
        middle[c] = (self.start[c] + self.end[c]) / 2
        first = replace(self, end=tuple(middle), sweep=self.sweep / 2)
        return [first, replace(self, start=tuple(middle), sweep=self.sweep / 2)]


@dataclass(frozen=True, slots=True)
class Form:
    """How one line writes its numbers: the modal state it stands in and the habits of its program.

    Parameters
    ----------
    program : str
        Name of the program.
    line : int
        Index of the line, from 0.
    style : Style
        Habits of the program.
    scale : float
        mm per program unit.
    decimals : int
        Digits behind the point of changed numbers.
    tolerance : float
        Allowed path error in mm.
    incremental, absolute_arcs : bool
        G91, and G90.1.
    plane : int
        17, 18 or 19.
    motion : int
        Motion code in force behind the line as read, times ten.
    shift : tuple of three float
        What TRANS adds to stated positions, mm.
    pieces : tuple of Piece
        Words of a line that holds more than plain words, with the numbers that they have in this run of it.
    shared : callable, optional
        Says of a word that is computed what else uses its variables; "" for nothing.
    """

    program: str
    line: int
    style: Style
    scale: float
    decimals: int
    tolerance: float
    incremental: bool
    absolute_arcs: bool
    plane: int
    motion: int
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    pieces: tuple[Piece, ...] = ()
    shared: Callable[[Piece], str] | None = None

    @property
    def unit(self) -> float:
        """Smallest step of a changed number, in mm."""
        return self.scale * 10.0**-self.decimals

    def round(self, value: float) -> float:
        """Value in the program's unit as it will be read back."""
        steps: float = 10.0**self.decimals
        return round(value * steps) / steps

    def letter(self, letter: str) -> str:
        """Letter in the program's case."""
        return letter.lower() if self.style.lower else letter

    def number(self, value: float) -> str:
        """Write a value in the program's unit."""
        style = self.style
        steps = round(value * 10**self.decimals)
        digits = f"{abs(steps):0{self.decimals + 1}d}"
        whole, part = digits[: len(digits) - self.decimals], digits[len(digits) - self.decimals :]
        if not style.trailing_zeros:
            part = part.rstrip("0")
        if part and not style.leading_digit and whole == "0":
            whole = ""
        sign = "-" if steps < 0 else ("+" if style.plus else "")
        return f"{sign}{whole}{'.' if part or style.point else ''}{part}"

    def code(self, code: int) -> str:
        """Number of a G code."""
        return f"0{code}" if self.style.leading_zero else str(code)

    def feed(self, value: float) -> str:
        """Number of an F word."""
        text = f"{value:.6f}".rstrip("0").rstrip(".")
        return text + ("." if self.style.point and "." not in text else "")


class Emitter:
    """Writes the moves of one line and moves the state on."""

    def __init__(self, form: Form, state: State) -> None:
        self.form = form
        self.state = state

    def _error(self, message: str) -> FormatError:
        return FormatError(message, self.form.program, self.form.line + 1)

    # -- what a line's own text gives in the emitted state -------------------------------------------------

    def pass_by(self, body: str) -> str:
        """Take over what a line without moves states; return its text."""
        line = self.line(body)
        self._rounds_no_more(line)
        motion = self.form.motion
        if line.motion() >= 0 or motion not in (10 * code for code in _PATH_CODES):
            self.state.motion = motion
        self._take_feed(line)
        return line.text()

    def _rounds_no_more(self, line: Line) -> None:
        """Switch off the rounding of all corners: those of a contour that is written anew are written out."""
        i = line.find("s")
        if i >= 0 and line.value(i) != 0:
            self._free(line, "s")
            line.set_number(i, "0")

    def _take_corner_feed(self, line: Line) -> None:
        """Take FRC= off a line whose corner is written out: its number is the F of the move in its place."""
        line.remove("!")

    def _take_feed(self, line: Line) -> None:
        feed = line.number("F")
        if feed is not None:
            self.state.feed = feed

    def _target(self, line: Line) -> list[float]:
        """End in mm that the axis words of a line give."""
        end = list(self.state.position)
        for k, axis in enumerate("XYZ"):
            i, incremental = line.axis(axis)
            if i >= 0:
                end[k] = line.value(i) * self.form.scale + self._base(k, incremental)
        return end

    def _base(self, k: int, incremental: bool | None) -> float:
        """What the number of an axis word counts from, mm."""
        counted = self.form.incremental if incremental is None else incremental
        return self.state.position[k] if counted else self.form.shift[k]

    def _code(self, line: Line) -> int:
        i = line.motion()
        return self.state.motion // 10 if i < 0 else int(line.value(i))

    def _centre(self, line: Line) -> Point | None:
        """Centre in mm that I, J, K of a line give; None without them."""
        a, b, _ = Plane(self.form.plane).axes
        if self._absolute_centre(line):
            x, y = (line.values[line.find("ijk"[k])] * self.form.scale + self.form.shift[k] for k in (a, b))
            return x, y
        if line.stated_centre:
            return None
        given = [line.number("IJK"[k]) for k in (a, b)]
        if given == [None, None]:
            return None
        x, y = ((value or 0.0) * self.form.scale for value in given)
        if self.form.absolute_arcs:
            return x + self.form.shift[a], y + self.form.shift[b]
        return self.state.position[a] + x, self.state.position[b] + y

    def _control(self, line: Line, end: list[float]) -> list[float] | None:
        """Inner points of a spline in mm that a line gives."""
        i, j, p, q = (line.number(letter) for letter in "IJPQ")
        if p is None or q is None:
            return None
        if i is None or j is None:
            if self.state.tangent is None:
                return None
            i, j = -self.state.tangent[0], -self.state.tangent[1]
        x, y = self.state.position[:2]
        scale = self.form.scale
        return [x + i * scale, y + j * scale, end[0] + p * scale, end[1] + q * scale]

    def _feed_kept(self, line: Line, move: Move) -> bool:
        if move.kind == Kind.RAPID or math.isnan(move.feed):
            return True
        stated = line.number("F")
        feed = self.state.feed if stated is None else stated
        return abs(feed * self.form.scale / 60.0 - move.feed) <= 1e-9 * move.feed

    def _gives(self, line: Line, move: Move) -> bool:
        """Whether a line as it stands gives the wanted move."""
        if self._code(line) != move.code or not self._feed_kept(line, move):
            return False
        if any(letter in line.letters for letter in _LEANING):
            return False
        end = self._target(line)
        if not _close(end, move.end):
            return False
        if move.kind == Kind.CUBIC:
            control = self._control(line, end)
            return control is not None and _close(control, move.control)
        if move.kind != Kind.ARC:
            return True
        a, b, _ = Plane(self.form.plane).axes
        if not _close([self.state.position[a], self.state.position[b]], [move.start[a], move.start[b]]):
            return False
        if line.find("R") >= 0:
            # Same start, end and R text: the arc is the one that was read, unless it was changed.
            s, e = (move.start[a], move.start[b]), (end[a], end[b])
            radius = line.value(line.find("R")) * self.form.scale
            centre: Point | None = _centre_by_radius(s, e, radius, move.sweep < 0)
        else:
            centre = self._centre(line)
        more = line.number("p")
        turns = line.number("P") or 1.0 if more is None else more + 1.0
        return centre is not None and _close(centre, [move.centre[a], move.centre[b]]) and turns == move.turns

    # -- writing -------------------------------------------------------------------------------------------

    def rewrite(self, body: str, moving: bool, wanted: list[Move]) -> list[str]:
        """Write the moves of a line.

        Parameters
        ----------
        body : str
            The line without its ending.
        moving : bool
            Whether the line makes a move as it was read.
        wanted : list of Move
            The moves it is to make.

        Returns
        -------
        list of str
            Text of the line and of those inserted with it, without endings.
        """
        if not moving:
            return [self.pass_by(body), *self._inserted_all(body, wanted)]
        line = self.line(body)
        self._rounds_no_more(line)
        if len(wanted) == 1 and self._gives(line, wanted[0]):
            self._advance(line)
            return [line.text()]
        if not wanted:
            return self._without_moves(line)
        moves = [part for move in wanted for part in self._divided(move)]
        if len(moves) == 1 or not self._acts_at_end(line):
            self._put(line, moves[0])
            return [line.text(), *self._inserted_all(body, moves[1:])]
        if any(self._sets_state(line, i) for i in range(len(line.words))):
            message = phrase("this line becomes several moves, but its M code belongs behind the last of them")
            raise self._error(phrase("{}: put the M code on a line of its own", message))
        before = self._inserted_all(body, moves[:-1])
        self._put(line, moves[-1])
        return [*before, line.text()]

    def line(self, body: str) -> Line:
        """The line as words."""
        return Line(body, self.form.pieces)

    def _acts_at_end(self, line: Line) -> bool:
        return any(line.letter(i) == "M" and line.value(i) in _ACTS_AT_END for i in range(len(line.words)))

    def _sets_state(self, line: Line, i: int) -> bool:
        letter = line.letter(i)
        if letter == "G":
            return line.value(i) not in _PATH_CODES
        return letter in "STDH" or (letter == "M" and line.value(i) not in _ACTS_AT_END)

    def _divided(self, move: Move) -> list[Move]:
        """An almost closed arc in halves: rounding its ends onto one another would make it another arc."""
        if move.kind != Kind.ARC or move.closed or move.turns > 1 or abs(move.sweep) < math.pi:
            return [move]
        a, b, _ = Plane(move.plane).axes
        chord = math.hypot(move.end[a] - move.start[a], move.end[b] - move.start[b])
        return move.halves() if chord < 8 * self.form.unit else [move]

    def _without_moves(self, line: Line) -> list[str]:
        """A line that moves no more, without its target; nothing where nothing else stands on it."""
        i = line.motion()
        spline = self._code(line) == 5
        for letter in "xyzuvwijkp" + _LEANING:
            self._take_away(line, letter)
        self._take_corner_feed(line)
        for letter in "XYZIJKRPQ" if spline or self._code(line) in (2, 3) else "XYZ":
            line.remove(letter)
        if i >= 0:
            i = line.motion()
            if line.value(i) in (0, 1) and len(line.words) > 1:
                self.state.motion = int(line.value(i)) * 10
            else:
                line.remove_at(i)
        self._take_feed(line)
        rest = "".join(line.gaps).strip(" \t/*")
        return [] if not rest and all(word[0] in "Nn" for word in line.words) else [line.text()]

    def _inserted_all(self, body: str, moves: list[Move]) -> list[str]:
        texts = (self._inserted(body, move) for move in moves)
        return [text for text in texts if text is not None]

    def _inserted(self, body: str, move: Move) -> str | None:
        """A line of its own for a further move; None where rounding leaves nothing to move."""
        line = Line("")
        at, motion = list(self.state.position), self.state.motion
        self._put(line, move)
        if self.state.motion in (0, 10) and self.state.position == at:
            self.state.motion = motion
            return None
        if line.motion() < 0 and not self.form.style.modal:
            self._insert(line, "G", self.form.code(self.state.motion // 10))
        opening = re.match(r"([ \t]*)(?:[Nn][ \t]*\d+[ \t]*)?(/[1-9]?)?", body)
        indent, skip = (opening.group(1), opening.group(2) or "") if opening else ("", "")
        return indent + skip + line.text() + (" *" if body.rstrip().endswith("*") else "")

    def _insert(self, line: Line, letter: str, number: str) -> None:
        line.insert(self.form.letter(letter) + number, self.form.style.blanks)

    def _put(self, line: Line, move: Move) -> None:
        """Change the words of a line so that it gives a move, and take the state behind it."""
        form, state = self.form, self.state
        self._continuous(move)
        # X=5 in place of AP= and RP= tells Siemens' poles from work offsets of others.
        polar = any(letter in line.letters for letter in "hotq")
        for letter in _LEANING + ("ijk" if not self._absolute_centre(line) else ""):
            self._take_away(line, letter)
        self._take_corner_feed(line)
        end, values, redundant = self._axis_words(line, move)
        code = move.code
        had_radius = line.find("R") >= 0 and self._code(line) in (2, 3)
        if move.kind == Kind.ARC:
            if move.plane != form.plane:
                raise InputError(
                    phrase("toolpath: an arc of line {} is not in the plane in force there", form.line + 1)
                )
            arc = self._arc_words(move, end, had_radius)
            code = code if arc else 1
        elif move.kind == Kind.CUBIC:
            arc = self._cubic_words(move, end)
        else:
            arc = {}
        leftover = "IJKRPQ" if self._code(line) in (2, 3, 5) else "IJKR"
        for letter in [*redundant, *(c for c in leftover if c not in arc)]:
            self._take_away(line, letter)
        arc = self._as_the_line_has_it(line, move, arc)
        # G2 X1 I5: a program that leaves out a zero offset goes on doing so.
        centred = not form.absolute_arcs and any(line.find(c) >= 0 and arc.get(c) for c in "IJK")
        for letter, value in {**values, **arc}.items():
            if centred and code in (2, 3) and letter in "IJK" and value == 0 and line.find(letter) < 0:
                continue
            turns = letter == "P" and code in (2, 3)
            number = str(int(value)) if turns else form.number(value)
            i = line.axis(letter)[0] if letter in "XYZ" else line.find(letter)
            if i < 0:
                self._insert(line, letter.upper(), f"={number}" if polar and letter in "XY" else number)
            elif line.value(i) != value:
                self._free(line, line.letter(i))
                line.set_number(i, number)
        i = line.motion()
        # LinuxCNC refuses P on a line that does not repeat its motion code.
        if i < 0 and (state.motion != code * 10 or "P" in arc):
            self._insert(line, "G", form.code(code))
        elif i >= 0 and line.value(i) != code:
            digits = line.words[i][1:].strip()
            line.set_number(i, f"{code:0{len(digits)}d}" if digits.isdigit() else form.code(code))
        if not self._feed_kept(line, move):
            number = form.feed(move.feed * 60.0 / form.scale)
            i = line.find("F")
            if i < 0:
                self._insert(line, "F", number)
            else:
                self._free(line, "F")
                line.set_number(i, number)
        self._take_feed(line)
        state.motion = code * 10
        state.tangent = (arc["P"], arc["Q"]) if code == 5 else None
        state.position[:] = end

    def _axis_words(self, line: Line, move: Move) -> tuple[list[float], dict[str, float], list[str]]:
        """End after rounding in mm, axis words to state, and axis words to take away."""
        form, at = self.form, self.state.position
        stated = self._target(line)
        end = list(at)
        values: dict[str, float] = {}
        redundant = []
        in_plane = Plane(move.plane).axes[:2]
        for k, axis in enumerate("XYZ"):
            wanted = move.end[k]
            i, incremental = line.axis(axis)
            present = i >= 0
            if math.isnan(wanted):
                continue
            if move.closed and k in in_plane:
                # A circle ends exactly where the control stands.
                if present and not abs(stated[k] - at[k]) <= SAME:
                    redundant.append(line.letter(i))
                continue
            if present and abs(stated[k] - wanted) <= SAME:
                end[k] = stated[k]
                continue
            base = self._base(k, incremental)
            value = form.round((wanted - base) / form.scale)
            reached = base + value * form.scale
            if present or not abs(reached - at[k]) <= SAME:
                values[axis] = value
                end[k] = reached
        if move.kind == Kind.CUBIC and not values and line.axis("X")[0] < 0 and line.axis("Y")[0] < 0:
            # Shorter than a digit, it states its end all the same: controls want an axis word.
            values["X"] = form.round((end[0] - self._base(0, None)) / form.scale)
        return end, values, redundant

    def _take_away(self, line: Line, letter: str) -> None:
        if line.find(letter) >= 0:
            self._free(line, letter)
            line.remove(letter)

    def _free(self, line: Line, letter: str) -> None:
        """Refuse to state the number of a word whose variables anything else uses."""
        piece = line.pieces[line.find(letter)] if line.pieces else None
        if piece is None or not piece.expression or self.form.shared is None:
            return
        why = self.form.shared(piece)
        if why:
            raise self._error(
                phrase("{}{}{} cannot be corrected: {}", piece.before, piece.expression, piece.after, why)
            )

    def _absolute_centre(self, line: Line) -> bool:
        a, b, _ = Plane(self.form.plane).axes
        return line.find("ijk"[a]) >= 0 and line.find("ijk"[b]) >= 0

    def _as_the_line_has_it(self, line: Line, move: Move, arc: dict[str, float]) -> dict[str, float]:
        """Arc words as positions where the line states them so, and turns as TURN=."""
        out = dict(arc)
        if line.find("p") >= 0:
            if line.number("p") != arc.get("P", 1.0) - 1.0:
                raise self._error(phrase("the turns of this arc would change: write it as arcs of one turn"))
            out.pop("P", None)
        for k, letter in enumerate("IJK"):
            if line.find(letter.lower()) < 0:
                continue
            value = out.pop(letter, None)
            if value is None:
                self._take_away(line, letter.lower())
            elif self.form.absolute_arcs:
                out[letter.lower()] = value
            else:
                at = self.state.position[k] + value * self.form.scale
                out[letter.lower()] = self.form.round((at - self.form.shift[k]) / self.form.scale)
        return out

    def _continuous(self, move: Move) -> None:
        allowed = 2 * self.form.unit + self.form.tolerance
        for at, start in zip(self.state.position, move.start, strict=True):
            if abs(at - start) > allowed:
                raise InputError(
                    phrase(
                        "toolpath: a move of line {} of {} starts {} from where the one before ends",
                        self.form.line + 1,
                        self.form.program,
                        mm(abs(at - start), ".4f"),
                    )
                )

    def _cubic_words(self, move: Move, end: list[float]) -> dict[str, float]:
        form = self.form
        bases = (*self.state.position[:2], *end[:2])
        return {
            letter: form.round((value - base) / form.scale)
            for letter, value, base in zip("IJPQ", move.control, bases, strict=True)
        }

    def _arc_words(self, move: Move, end: list[float], by_radius: bool) -> dict[str, float]:
        """Arc words of a move in the program's unit; none where a line is as good as the arc."""
        form = self.form
        a, b, _ = Plane(form.plane).axes
        s, e = (self.state.position[a], self.state.position[b]), (end[a], end[b])
        wanted = (move.centre[a], move.centre[b])
        radius = math.hypot(move.start[a] - wanted[0], move.start[b] - wanted[1])
        clockwise = move.sweep < 0
        sweep = abs(move.sweep) - _TURN * (move.turns - 1)
        arc = _Arc(wanted, radius, math.atan2(move.start[b] - wanted[1], move.start[a] - wanted[0]), sweep, clockwise)
        base = (form.shift[a], form.shift[b]) if form.absolute_arcs else s
        words, centre = self._centre_on_grid(arc, s, e, base)
        slack = (3 * form.unit + form.tolerance) / max(radius, 1e-12)
        if abs(_sweep(s, e, centre, clockwise) - sweep) > slack or centre == s:
            if move.turns == 1 and sweep < math.pi and arc.sagitta <= form.tolerance / 2:
                return {}
            raise self._error(phrase("rounding would make another arc of this one: allow more decimals"))
        out = {"IJK"[a]: words[0], "IJK"[b]: words[1]}
        if by_radius and move.turns == 1 and sweep < math.pi - 1e-6:
            r = form.round(radius / form.scale)
            if 2 * r * form.scale >= math.hypot(e[0] - s[0], e[1] - s[1]):
                off = arc.error(s, e, _centre_by_radius(s, e, r * form.scale, clockwise))
                if off <= form.tolerance / 2:
                    out = {"R": r}
        if move.turns > 1:
            out["P"] = float(move.turns)
        return out

    def _centre_on_grid(self, arc: _Arc, s: Point, e: Point, base: Point) -> tuple[Point, Point]:
        """Centre words in the program's unit, and the centre in mm they give.

        Controls check that start and end lie on one circle: of the neighbouring centres the one is taken
        whose radii agree best without leaving the wanted arc.
        """
        form = self.form
        steps = 10**form.decimals
        near = [round((arc.centre[k] - base[k]) / form.scale * steps) for k in (0, 1)]
        best = math.inf
        out: tuple[Point, Point] = (s, s)
        for di, dj in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            words = ((near[0] + di) / steps, (near[1] + dj) / steps)
            centre = (base[0] + words[0] * form.scale, base[1] + words[1] * form.scale)
            cost = arc.error(s, e, centre)
            if cost < best:
                best, out = cost, (words, centre)
            if best <= 0.5 * form.unit:
                break
        return out

    def _advance(self, line: Line) -> None:
        """Take the state behind a line that stays as it is."""
        end = self._target(line)
        code = self._code(line)
        p, q = line.number("P"), line.number("Q")
        self.state.tangent = (p, q) if code == 5 and p is not None and q is not None else None
        self.state.position[:] = end
        self.state.motion = code * 10
        self._take_feed(line)


@dataclass(frozen=True, slots=True)
class _Arc:
    """A wanted arc of up to one turn in its plane, in mm and rad."""

    centre: Point
    radius: float
    begin: float
    sweep: float
    clockwise: bool

    @property
    def sagitta(self) -> float:
        """Height of the arc over its chord."""
        return self.radius * (1 - math.cos(min(self.sweep, math.pi) / 2))

    def error(self, s: Point, e: Point, centre: Point) -> float:
        """Path error of an arc from s to e about another centre, plus its mismatch of radii."""
        first = math.hypot(s[0] - centre[0], s[1] - centre[1])
        last = math.hypot(e[0] - centre[0], e[1] - centre[1])
        worst = 0.0
        for t in (0.25, 0.5, 0.75):
            angle = self.begin + (-t if self.clockwise else t) * self.sweep
            x = self.centre[0] + self.radius * math.cos(angle)
            y = self.centre[1] + self.radius * math.sin(angle)
            off = math.hypot(x - centre[0], y - centre[1]) - (first * (1 - t) + last * t)
            worst = max(worst, abs(off))
        return worst + abs(first - last)


def _close(a: Sequence[float], b: Sequence[float]) -> bool:
    return all(abs(x - y) <= SAME or (math.isnan(x) and math.isnan(y)) for x, y in zip(a, b, strict=True))


def _centre_by_radius(s: Point, e: Point, radius: float, clockwise: bool) -> Point:
    """Centre of an arc stated by its radius; see `arcs.centre_by_radius`."""
    dx, dy = e[0] - s[0], e[1] - s[1]
    half = math.hypot(dx, dy) / 2
    if half == 0:
        return s
    height = math.sqrt(max(radius**2 - half**2, 0.0)) / (2 * half)
    if clockwise != (radius < 0):
        height = -height
    return (s[0] + e[0]) / 2 - dy * height, (s[1] + e[1]) / 2 + dx * height


def _sweep(s: Point, e: Point, c: Point, clockwise: bool) -> float:
    """Angle from s to e about c in (0, 2 pi], in the sense of the arc."""
    if math.hypot(e[0] - s[0], e[1] - s[1]) <= SAME:
        return _TURN
    u, v, w, z = s[0] - c[0], s[1] - c[1], e[0] - c[0], e[1] - c[1]
    angle = math.atan2(u * z - v * w, u * w + v * z)
    angle = -angle if clockwise else angle
    return angle if angle > 0 else angle + _TURN
