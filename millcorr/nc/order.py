# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order in which the lines of a program run, and the values that it computes itself.

A *block* is one run of one line. Subprograms, jumps and loops are followed as far as all that decides them is known on
reading: constants, arithmetic, variables that the program sets. Behind the first decision that only the control can
take the lines follow as they stand, and are marked.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from millcorr.arrays import Ints
from millcorr.messages import joined, phrase

from .expressions import UnknownValue, Variables, evaluate, evaluate_factor, variable
from .statements import Piece, Statement
from .words import Words

MOST_BLOCKS = 5_000_000
"""More blocks than this are no part program: a loop without end."""
MOST_STEPS = 500_000
"""So many decisions likewise."""
_DEEPEST = 32
"""Calls within calls beyond this never return."""
_HARMLESS_UNKNOWN = frozenset("FSDHNETM")
"""Words whose number says nothing of where the cutter goes."""
_ENDS, _RETURNS, _CALLS = (2.0, 30.0), (99.0, 17.0), (97.0, 98.0, 198.0)
_STEERS = (*_ENDS, *_RETURNS, *_CALLS)
_MACROS = (65.0, 66.0)
"""G codes of macros, which may set any variable."""
_LOCALS = range(1, 31)

Beside = Callable[[str], "tuple[Words, Mapping[int, Statement], int, str] | None"]
"""Words, statements, number of lines and name of a file beside the program, by the name of a subprogram."""


@dataclass(frozen=True, slots=True)
class OddBlock:
    """A block that cannot be followed.

    Parameters
    ----------
    line : int
        Index of the block.
    reason : str
        Why.
    effect : str
        "" nothing but its own words, "frame" the coordinate frame may change, "call" a subprogram moves the
        machine, "flow" the order of the lines is not that of the text from here on.
    """

    line: int
    reason: str
    effect: str


@dataclass(frozen=True, eq=False, slots=True)
class Run:
    """A program as it runs.

    Parameters
    ----------
    line : (blocks,) int64 or None
        Line of every block; None where every line runs once, in the order of the text.
    words : Words
        Words by block.
    odd : tuple of OddBlock
    blocks : int
        Number of blocks.
    statements : mapping of int to Statement
        Lines that hold more than plain words, by line.
    values : mapping of (int, int) to float
        Numbers that the program computes, by block and place of the word in its line's pieces.
    """

    line: Ints | None
    words: Words
    odd: tuple[OddBlock, ...]
    blocks: int
    statements: Mapping[int, Statement]
    values: Mapping[tuple[int, int], float]

    def pieces(self, block: int) -> tuple[Piece, ...]:
        """Words of a block whose line holds more than plain words, with their numbers; none of other lines."""
        found = self.statements.get(int(self.lines(np.array([block]))[0]))
        if found is None:
            return ()
        values = self.values
        return tuple(
            replace(p, value=values[block, k]) if (block, k) in values else p for k, p in enumerate(found.pieces)
        )

    def until(self, block: int) -> Run:
        """The blocks before one."""
        words = self.words.take(np.arange(int(np.searchsorted(self.words.line, block))))
        odd = tuple(o for o in self.odd if o.line < block)
        return replace(self, words=words, odd=odd, blocks=block, line=None if self.line is None else self.line[:block])

    def without_words(self) -> Run:
        """The same without the words, which hold most of the memory."""
        return replace(self, words=self.words.take(np.empty(0, np.int64)))

    def lines(self, blocks: Ints) -> Ints:
        """Lines of some blocks."""
        return blocks if self.line is None else self.line[blocks]

    def number(self, block: int) -> int:
        """Number of the line of a block, from 1."""
        return (block if self.line is None else int(self.line[block])) + 1


class _Lost(Exception):
    """The order of the lines is not known from here on; says why."""


@dataclass(slots=True)
class _Frame:
    """A subprogram that runs: where it begins, where it returns to, how often it runs again."""

    begin: int
    back: int
    left: int
    local: dict[str, float] | None = None


def run(
    words: Words, statements: Mapping[int, Statement], lines: int, sections: Mapping[int, str], beside: Beside
) -> Run:
    """Follow the lines of a program in the order in which they run.

    Parameters
    ----------
    words : Words
        By line.
    statements : mapping of int to Statement
        Lines that hold more than plain words.
    lines : int
        Number of lines.
    sections : mapping of int to str
        Names that lines give to what stands below them, besides their O words.
    beside : callable
        Finds a subprogram in a file beside the program.

    Returns
    -------
    Run
    """
    m = words.of("M")
    steers = any(s.flow or s.assigned or any(p.expression for p in s.pieces) for s in statements.values())
    if not (steers or np.isin(m.value, _CALLS).any() or len(_bare_calls(words))):
        odd = [
            OddBlock(i, joined(dict.fromkeys(s.reasons), "; "), s.effect) for i, s in statements.items() if s.reasons
        ]
        return Run(None, words, tuple(odd), lines, statements, {})
    return _Runner(words, statements, lines, sections, beside).result()


def _numbered_name(letter: str, number: float | None) -> str:
    """Name of a subprogram that has a number."""
    return f"{letter}{int(number)}" if number is not None and np.isfinite(number) else letter


def _bare_calls(words: Words) -> Ints:
    """Lines of nothing but N, L and P: Siemens' L100 P3."""
    calls = words.of("L").line
    if not len(calls):
        return np.empty(0, np.int64)
    others = words.line[~np.isin(words.letter, [ord(c) for c in "NLP"])]
    out: Ints = np.setdiff1d(calls, others)
    return out


class _Runner:
    """One walk through one program."""

    def __init__(
        self, words: Words, statements: Mapping[int, Statement], lines: int, sections: Mapping[int, str], beside: Beside
    ) -> None:
        self.words, self.lines = words, lines
        self.statements = dict(statements)
        self.names: dict[str, int] = {}
        self.begins: list[int] = [0]
        self.beside = beside
        self.variables: dict[str, float] = {}
        self.frames: list[_Frame] = []
        self.left: dict[int, int] = {}
        self.again = -1
        self.steps = 0
        self.ranges: list[tuple[int, int]] = []
        self.blocks = 0
        self.values: list[tuple[int, int, float]] = []
        self.odd: list[OddBlock] = []
        self._index(0, sections)

    # -- what stands where --------------------------------------------------------------------------------

    def _index(self, since: int, sections: Mapping[int, str]) -> None:
        """Note lines that matter, from one on: heads of programs, codes, loops."""
        w = self.words
        self.first = np.searchsorted(w.line, np.arange(self.lines + 1))
        heads = w.of("O")
        named = {int(i): _numbered_name("O", v) for i, v in zip(heads.line, heads.value, strict=True)}
        for line, name in sorted((named | dict(sections)).items()):
            if line >= since:
                self.names.setdefault(name, line)
                self.begins.append(line)
        for line, s in self.statements.items():
            found = re.match(r"(O(?:\d+|<[^>]*>))\s*SUB\b", s.flow)
            if found and line >= since:
                self.names.setdefault(found.group(1), line)
        self.begins = sorted(set(self.begins))
        m, g = w.of("M"), w.of("G")
        stops = np.concatenate([m.line[np.isin(m.value, _STEERS)], g.line[np.isin(g.value, _MACROS)]])
        calls = _bare_calls(w)
        odd = np.array(sorted(self.statements), np.int64)
        self.stops = np.unique(np.concatenate([stops, calls, odd, np.array(self.begins[1:], np.int64)]))
        self.calls = set(calls.tolist())
        self.match = self._matched()

    def _matched(self) -> dict[int, list[int]]:
        """For every line of a loop or a choice all lines of it, in their order."""
        out: dict[int, list[int]] = {}
        stack: list[tuple[str, list[int]]] = []
        for line in sorted(self.statements):
            role, key = _role(self.statements[line].flow)
            if role == "open":
                stack.append((key, [line]))
            elif role in ("middle", "close"):
                while stack and stack[-1][0] != key:
                    stack.pop()
                if not stack:
                    continue
                stack[-1][1].append(line)
                if role == "close":
                    group = stack.pop()[1]
                    out.update(dict.fromkeys(group, group))
        return out

    def _section(self, line: int) -> tuple[int, int]:
        """First line of the program that a line belongs to, and the line behind its last."""
        place = int(np.searchsorted(self.begins, line, side="right")) - 1
        last = self.begins[place + 1] if place + 1 < len(self.begins) else self.lines
        return self.begins[place], last

    def _numbered(self, number: float, line: int) -> int:
        """Line with an N word, ahead in the program first."""
        first, last = self._section(line)
        n = self.words.of("N")
        there = n.line[n.value == number]
        there = there[(there >= first) & (there < last)]
        if not len(there):
            raise _Lost(phrase("no line N{:g} is there to go to", number))
        ahead = there[there > line]
        return int(ahead[0] if len(ahead) else there[0])

    def _word(self, line: int, letter: str) -> float | None:
        here = slice(int(self.first[line]), int(self.first[line + 1]))
        found = np.flatnonzero(self.words.letter[here] == ord(letter))
        return float(self.words.value[here][found[0]]) if len(found) else None

    # -- the walk -----------------------------------------------------------------------------------------

    def result(self) -> Run:
        self._walk()
        line = np.concatenate([np.arange(a, b) for a, b in self.ranges] or [np.empty(0, np.int64)])
        first, count = self.first[line], self.first[line + 1] - self.first[line]
        start = np.concatenate([[0], np.cumsum(count)])
        index = np.arange(start[-1]) + np.repeat(first - start[:-1], count)
        words = self.words.take(index)
        value = words.value.copy()
        for block, k, number in self.values:
            value[start[block] + k] = number
        blocks = np.repeat(np.arange(len(line)), count).astype(self.words.line.dtype)
        by_block = Words(words.letter, value, blocks, words.decimals)
        in_order = len(line) == self.lines and bool((line == np.arange(self.lines)).all())
        values = {(block, k): number for block, k, number in self.values}
        return Run(None if in_order else line, by_block, tuple(self.odd), len(line), self.statements, values)

    def _walk(self) -> None:
        line = 0
        while line < self.lines:
            place = int(np.searchsorted(self.stops, line))
            stop = int(self.stops[place]) if place < len(self.stops) else self.lines
            if stop > line:
                self._emit(line, stop)
            if stop == self.lines:
                break
            if stop in self.begins and stop != self._entered(stop):
                break
            self._emit(stop, stop + 1)
            try:
                self.steps += 1
                if self.blocks > MOST_BLOCKS or self.steps > MOST_STEPS:
                    raise _Lost(phrase("a loop does not end"))
                following = self._special(stop)
            except _Lost as lost:
                self._mark(stop, lost.args[0], "flow")
                self._rest(stop + 1)
                return
            if stop == self.again:
                self.again = -1
            if following < 0:
                break
            line = following
        self._tail()

    def _entered(self, line: int) -> int:
        """The line itself where a program begins that runs now, as the first one of the text or by a call."""
        before = [b for b in self.begins if b < line]
        fresh = not self.frames and all(self._empty(b, line) for b in before[-1:])
        called = bool(self.frames) and self.frames[-1].begin == line
        return line if fresh or called else -1

    def _empty(self, first: int, last: int) -> bool:
        letters = self.words.letter[int(self.first[first]) : int(self.first[last])]
        return not np.isin(letters, [ord(c) for c in "GMXYZTS"]).any()

    def _tail(self) -> None:
        """The lines behind the end, where nothing else is out of the order of the text."""
        if len(self.ranges) == 1 and self.ranges[0][0] == 0 and not np.any(np.array(self.begins) > self.ranges[0][1]):
            self._emit(self.ranges[0][1], self.lines)

    def _rest(self, line: int) -> None:
        """The lines of the text from here to the end of the program, as they stand."""
        _, last = self._section(line - 1)
        m = self.words.of("M")
        ends = m.line[np.isin(m.value, (*_ENDS, *_RETURNS)) & (m.line >= line) & (m.line < last)]
        stop = int(ends[0]) + 1 if len(ends) else last
        odd = {b.line for b in self.odd}
        block = self.blocks
        self._emit(line, stop)
        self._tail()
        for i in range(line, stop):
            s = self.statements.get(i)
            if s and s.reasons and block + i - line not in odd:
                self.odd.append(OddBlock(block + i - line, joined(dict.fromkeys(s.reasons), "; "), s.effect))

    def _emit(self, first: int, last: int) -> None:
        if self.ranges and self.ranges[-1][1] == first:
            self.ranges[-1] = (self.ranges[-1][0], last)
        elif last > first:
            self.ranges.append((first, last))
        self.blocks += last - first

    def _mark(self, line: int, reason: str, effect: str) -> None:
        self.odd.append(OddBlock(self.blocks - 1, reason, effect))

    def _special(self, line: int) -> int:
        """Run a line that matters; return the line that runs next, -1 at the end."""
        s = self.statements.get(line)
        following = line + 1
        if s is not None:
            self._compute(line, s)
            if s.flow:
                following = self._flow(line, s)
        code = None
        m = self.words
        here = slice(int(self.first[line]), int(self.first[line + 1]))
        codes = m.value[here][m.letter[here] == ord("M")]
        for value in codes.tolist():
            if value in _STEERS:
                code = value
        if np.isin(m.value[here][m.letter[here] == ord("G")], _MACROS).any():
            self.variables.clear()
        if code in _ENDS:
            return -1
        if code in _RETURNS:
            return self._return(line)
        if code is not None:
            return self._called_by_code(line, code)
        if line in self.calls:
            number, count = self._word(line, "L"), self._word(line, "P")
            return self._call(_numbered_name("L", number), line, 1 if count is None else int(count))
        return following

    def _compute(self, line: int, s: Statement) -> None:
        """Values of the words and variables of a line."""
        reasons = list(s.reasons) if not s.flow else []
        for k, piece in enumerate(s.pieces):
            if not piece.expression:
                continue
            rule = evaluate if piece.before.endswith(("=", "(")) else evaluate_factor
            try:
                value, _ = rule(piece.expression, 0, self.variables)
                self.values.append((self.blocks - 1, k, value))
            except UnknownValue as unknown:
                if piece.letter not in _HARMLESS_UNKNOWN:
                    reasons.append(
                        phrase("{} is computed by a macro expression: {}", piece.before.rstrip("=("), unknown.args[0])
                    )
        computed: dict[str, float | None] = {}
        for target, expression in s.assigned:
            try:
                name, _ = variable(target, 0, self.variables)
                value, _ = evaluate(expression, 0, self.variables)
                computed[name] = None if any(n in expression for n in computed) else value
            except UnknownValue:
                try:
                    computed[variable(target, 0, self.variables)[0]] = None
                except UnknownValue:
                    # Any variable may have been set.
                    self.variables.clear()
        for name, number in computed.items():
            if not name:
                self.variables.clear()
            elif number is None:
                self.variables.pop(name, None)
            else:
                self.variables[name] = number
        if reasons:
            self._mark(line, joined(dict.fromkeys(reasons), "; "), s.effect)

    # -- calls --------------------------------------------------------------------------------------------

    def _called_by_code(self, line: int, code: float) -> int:
        number, count = self._word(line, "P"), self._word(line, "L")
        # H and Q begin at a line within the subprogram.
        within = self._word(line, "H") is not None or self._word(line, "Q") is not None
        if number is None or not np.isfinite(number) or within:
            return self._unknown_call(line, phrase("a subprogram is called"))
        times = 1 if count is None else int(count)
        if code == 97:
            return self._enter(self._numbered(number, line), line + 1, times)
        if count is None and number > 9999 and self._find(_numbered_name("O", number)) is None:
            # Fanuc's count before four digits of the number.
            times, number = max(int(number // 10000), 1), number % 10000
        return self._call(_numbered_name("O", number), line, times)

    def _find(self, name: str) -> int | None:
        """Line where a subprogram begins, in the file or in one beside it."""
        if name not in self.names:
            found = self.beside(name)
            if found is not None:
                words, statements, lines, _ = found
                since = self.lines
                both = np.concatenate([self.words.line, (words.line + since).astype(self.words.line.dtype)])
                self.words = Words(
                    np.concatenate([self.words.letter, words.letter]),
                    np.concatenate([self.words.value, words.value]),
                    both,
                    np.concatenate([self.words.decimals, words.decimals]),
                )
                self.statements |= {i + since: s for i, s in statements.items()}
                self.lines += lines
                self.begins.append(since)
                self._index(since, {since: name})
        return self.names.get(name)

    def _call(self, name: str, line: int, times: int) -> int:
        begin = self._find(name)
        if begin is None:
            return self._unknown_call(
                line, phrase("subprogram {} is called, which is neither in the file nor beside it", name)
            )
        return self._enter(begin, line + 1, times)

    def _unknown_call(self, line: int, reason: str) -> int:
        self._mark(line, reason, "call")
        # What it sets is not known.
        self.variables.clear()
        return line + 1

    def _enter(self, begin: int, back: int, times: int, local: dict[str, float] | None = None) -> int:
        if len(self.frames) >= _DEEPEST:
            raise _Lost(phrase("subprograms call each other without end"))
        if times < 1:
            return back
        self.frames.append(_Frame(begin, back, times - 1, local))
        return begin

    def _return(self, line: int) -> int:
        if not self.frames:
            return -1
        frame = self.frames[-1]
        if self._word(line, "L") is not None:
            raise _Lost(phrase("M99 with L is not followed"))
        if frame.left:
            frame.left -= 1
            return frame.begin
        self.frames.pop()
        if frame.local is not None:
            for i in _LOCALS:
                self.variables.pop(f"#{i}", None)
            self.variables |= frame.local
        number = self._word(line, "P")
        return frame.back if number is None else self._numbered(number, frame.back - 1)

    # -- jumps and loops ----------------------------------------------------------------------------------

    def _value(self, text: str) -> float:
        try:
            value, end = evaluate(text, 0, self.variables)
        except UnknownValue as unknown:
            raise _Lost(phrase("{}: which line comes next is not known", unknown.args[0])) from unknown
        if text[end:].strip(" \t)"):
            raise _Lost(phrase("'{}' is not followed", text.strip()[:40]))
        return value

    def _flow(self, line: int, s: Statement) -> int:
        """Line that comes next behind a jump, a loop or a call."""
        text = s.flow
        if self.names.get(text) == line:
            # The head of a program (Okuma's OSUB) calls nothing.
            return line + 1
        for pattern, action in _ACTIONS:
            if found := pattern.fullmatch(text):
                return action(self, line, *found.groups())
        name = text if re.fullmatch(r"[A-Z_][A-Z_0-9]+", text) else ""
        if name and self._find(name) is not None:
            return self._call(name, line, 1)
        if s.effect == "call":
            return self._unknown_call(line, joined(dict.fromkeys(s.reasons), "; "))
        raise _Lost(joined(dict.fromkeys(s.reasons), "; "))

    def goto(self, line: int, target: str) -> int:
        # Whatever loop is left so begins anew.
        self.left.clear()
        target = target.strip()
        if target[:1] == "N" and target[1:].strip().isdigit():
            target = target[1:].strip()
        if re.fullmatch(r"[A-Z_][A-Z_0-9]*", target) and target not in self.variables:
            return self.label(line, target)
        return self._numbered(self._value(target), line)

    def label(self, line: int, name: str) -> int:
        """Line with a label of Siemens or a sequence name of Okuma."""
        first, last = self._section(line)
        there = [i for i in sorted(self.labels()) if first <= i < last and self.labels()[i] == name]
        if not there:
            raise _Lost(phrase("no label {} is there to go to", name))
        return next((i for i in there if i > line), there[0])

    def labels(self) -> dict[int, str]:
        return {i: s.label for i, s in self.statements.items() if s.label}

    def if_goto(self, line: int, condition: str, target: str) -> int:
        return self.goto(line, target) if self._value(condition) else line + 1

    def if_then(self, line: int, condition: str, target: str, expression: str) -> int:
        if self._value(condition):
            self.variables[target.strip()] = self._value(expression)
        return line + 1

    def _group(self, line: int) -> list[int]:
        if line not in self.match:
            raise _Lost(phrase("a loop or choice is not complete"))
        return self.match[line]

    def loop_while(self, line: int, condition: str) -> int:
        return line + 1 if self._value(condition) else self._group(line)[-1] + 1

    def loop_end(self, line: int) -> int:
        self.again = self._group(line)[0]
        return self.again

    def skip(self, line: int) -> int:
        self._group(line)
        return line + 1

    def until(self, line: int, condition: str) -> int:
        return line + 1 if self._value(condition) else self._group(line)[0] + 1

    def choice(self, line: int, condition: str) -> int:
        """IF: behind it, or at what comes when it does not hold."""
        group = self._group(line)
        for k, place in enumerate(group):
            flow = re.sub(r"^O(?:\d+|<[^>]*>)\s*", "", self.statements[place].flow)
            holds = k > 0 and flow.startswith("ELSE") and not flow.startswith("ELSEIF")
            test = condition if k == 0 else flow.removeprefix("ELSEIF") if flow.startswith("ELSEIF") else ""
            if holds or (test and self._value(test)) or k == len(group) - 1:
                return place + 1
        return line + 1

    def leave_choice(self, line: int) -> int:
        return self._group(line)[-1] + 1

    def loop_for(self, line: int, name: str, begin: str, end: str) -> int:
        value = self.variables.get(name, 0.0) + 1.0 if self.again == line else self._value(begin)
        self.variables[name] = value
        return self._group(line)[-1] + 1 if value > self._value(end) else line + 1

    def loop_repeat(self, line: int, count: str) -> int:
        """LinuxCNC's repeat."""
        left = self.left[line] if self.again == line else int(self._value(count))
        self.left[line] = left - 1
        return line + 1 if left > 0 else self._group(line)[-1] + 1

    def repeat_label(self, line: int, only: str, label: str, last: str | None, count: str | None) -> int:
        """Siemens' REPEAT: from a label to here, or to another label, or only its line."""
        left = self.left.get(line, int(self._value(count)) if count else 1)
        if not left:
            del self.left[line]
            return line + 1
        self.left[line] = left - 1
        begin = self.label(line, label)
        if not only and last is None:
            if begin > line:
                raise _Lost(phrase("REPEAT of what stands behind it is not followed"))
            return begin
        end = begin if only else self.label(line, last or label)
        stop = end + 1
        while begin < stop:
            # What is repeated is run as it stands: nothing that steers stands in it.
            s = self.statements.get(begin)
            if begin in self.stops and (s is None or s.flow):
                raise _Lost(phrase("REPEAT of lines that call or jump is not followed"))
            self._emit(begin, begin + 1)
            if s is not None:
                self._compute(begin, s)
            begin += 1
        return self.repeat_label(line, only, label, last, count)

    def sub(self, line: int, name: str) -> int:
        """LinuxCNC's definition of a subprogram: passed over, or run by a call."""
        if self.frames and self.frames[-1].begin == line:
            return line + 1
        for place in sorted(self.statements):
            if place > line and re.match(re.escape(name) + r"\s*ENDSUB\b", self.statements[place].flow):
                return place + 1
        raise _Lost(phrase("{} SUB without its ENDSUB", name))

    def word_call(self, line: int, name: str, arguments: str) -> int:
        """LinuxCNC's call with its values."""
        begin = self._find(name)
        if begin is None:
            return self._unknown_call(line, phrase("subprogram {} is called, which is not in the file", name))
        values, place = [], 0
        while arguments[place:].strip():
            try:
                value, place = evaluate_factor(arguments, place, self.variables)
            except UnknownValue as unknown:
                raise _Lost(*unknown.args) from unknown
            values.append(value)
        local = {f"#{i}": self.variables.pop(f"#{i}") for i in _LOCALS if f"#{i}" in self.variables}
        self.variables |= {f"#{i}": 0.0 for i in _LOCALS}
        self.variables |= {f"#{i}": v for i, v in enumerate(values, 1)}
        return self._enter(begin, line + 1, 1, local)

    def back(self, line: int) -> int:
        return self._return(line)

    def call_named(self, line: int, name: str, count: str | None) -> int:
        """CALL O1000 Q3, CALL "NAME", NAME P3."""
        return self._call(re.sub(r"^O0*(?=\d)", "O", name), line, int(self._value(count)) if count else 1)


Action = Callable[..., int]
_O = r"(?:O(?:\d+|<[^>]*>))\s*"
_ACTIONS: tuple[tuple[re.Pattern[str], Action], ...] = tuple(
    (re.compile(pattern), action)
    for pattern, action in (
        (r"IF\s*(.+?)\s*GOTO[FBC]?\s*([A-Z_0-9#\[\]+*/ -]+)", _Runner.if_goto),
        (r"IF\s*(\[.+\])\s*(N\s*\w+)", _Runner.if_goto),
        (r"GOTO[FBC]?\s*([A-Z_0-9#\[\]+*/ -]+)", _Runner.goto),
        (r"IF\s*(\[.+\])\s*THEN\s*(#\d+)\s*=(.+)", _Runner.if_then),
        (r"WHILE\s*(\[.+\])\s*DO\s*\d+", _Runner.loop_while),
        (r"END\s*\d+", _Runner.loop_end),
        (r"WHILE\b\s*(.+)", _Runner.loop_while),
        (r"ENDWHILE", _Runner.loop_end),
        (r"FOR\s+(\w+)\s*=(.+?)\s+TO\s+(.+)", _Runner.loop_for),
        (r"ENDFOR", _Runner.loop_end),
        (r"REPEAT(B?)\s+([A-Z_]\w+)(?:\s+([A-Z_]\w+))?(?:\s+P\s*=?\s*(\d+))?", _Runner.repeat_label),
        (r"REPEAT", _Runner.skip),
        (r"UNTIL\b\s*(.+)", _Runner.until),
        (r"IF\b\s*(.+)", _Runner.choice),
        (r"ELSE", _Runner.leave_choice),
        (r"ENDIF", _Runner.skip),
        (r"(?:RET|RTS)\b.*", _Runner.back),
        (r'CALL\s+"?(\w+)"?(?:\s+Q\s*=?\s*(\w+))?', _Runner.call_named),
        (r"([A-Z_]{2}\w*)\s+P\s*=?\s*(\d+)", _Runner.call_named),
        (r"(O(?:\d+|<[^>]*>))\s*SUB", _Runner.sub),
        (r"(O(?:\d+|<[^>]*>))\s*CALL\s*(.*)", _Runner.word_call),
        (_O + r"(?:ENDSUB|RETURN)\b.*", _Runner.back),
        (_O + r"WHILE\s*(.+)", _Runner.loop_while),
        (_O + r"ENDWHILE", _Runner.loop_end),
        (_O + r"REPEAT\s*(.+)", _Runner.loop_repeat),
        (_O + r"ENDREPEAT", _Runner.loop_end),
        (_O + r"IF\s*(.+)", _Runner.choice),
        (_O + r"ELSE(?:IF\b.*)?", _Runner.leave_choice),
        (_O + r"ENDIF", _Runner.skip),
    )
)
_ROLES = (
    (re.compile(r"WHILE\s*\[.+\]\s*DO\s*(\d+)"), "open", "DO"),
    (re.compile(r"END\s*(\d+)"), "close", "DO"),
    (re.compile(r"(O(?:\d+|<[^>]*>))\s*(?:WHILE|REPEAT|IF)\b.*"), "open", ""),
    (re.compile(r"(O(?:\d+|<[^>]*>))\s*ELSE.*"), "middle", ""),
    (re.compile(r"(O(?:\d+|<[^>]*>))\s*(?:ENDWHILE|ENDREPEAT|ENDIF)"), "close", ""),
    (re.compile(r"(WHILE)\b.*"), "open", ""),
    (re.compile(r"END(WHILE)"), "close", ""),
    (re.compile(r"(FOR)\b.*"), "open", ""),
    (re.compile(r"END(FOR)"), "close", ""),
    (re.compile(r"(REPEAT)"), "open", ""),
    (re.compile(r"UNTIL()\b.*"), "close", "REPEAT"),
    (re.compile(r"(IF)\b(?!.*\bGOTO)(?!.*\bTHEN)(?!.*\]\s*N\w).*"), "open", ""),
    (re.compile(r"ELSE()"), "middle", "IF"),
    (re.compile(r"END(IF)"), "close", ""),
)


def _role(flow: str) -> tuple[str, str]:
    """Whether a line opens, parts or closes a loop or choice, and which."""
    for pattern, role, kind in _ROLES:
        if found := pattern.fullmatch(flow):
            return role, kind + found.group(1)
    return "", ""


__all__ = ["MOST_BLOCKS", "OddBlock", "Run", "Variables", "run"]
