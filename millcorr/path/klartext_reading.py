# SPDX-License-Identifier: LGPL-2.1-or-later
"""A second, small reader of plain-language (Klartext) text, for the proof; it shares no code with the writer's.

The blocks are first turned into steps from corner to corner; what the control makes of corners (RND, CHF) and of
approaches is then worked out between the steps. What it cannot follow makes a place unknown (NaN); nothing is refused
here.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.nc.toolpath import Kind, named_tool
from millcorr.tolerances import ARITHMETIC

from .reading import PlainMoves, Reading, line_starts

_NOWHERE = complex(math.nan, math.nan)
_MOST = 5_000_000
_NUMBER = re.compile(rb"(?m)^((?:\xef\xbb\xbf)?[ \t]*)(\d+)(?=[ \t/;*]|\r?$)")
_TAIL = re.compile(
    r"(R0(?![\d.,])|RL|RR|F *MAX|F *AUTO|DR[-+]|R[-+](?! *[\dQ.,]))"
    r"|(I?)(PR|PA|LEN|CCA|CHF|MB|F[UZT]?|[XYZABCUVWRM])(?: *([-+]?) *(Q[LR]?\d+|\d+[.,]?\d*|[.,]\d+))?"
)
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda v: math.sin(v * math.pi / 180),
    "COS": lambda v: math.cos(v * math.pi / 180),
    "TAN": lambda v: math.tan(v * math.pi / 180),
    "ASIN": lambda v: math.asin(v) * 180 / math.pi,
    "ACOS": lambda v: math.acos(v) * 180 / math.pi,
    "ATAN": lambda v: math.atan(v) * 180 / math.pi,
    "SQRT": math.sqrt,
    "SQ": lambda v: v * v,
    "LN": math.log,
    "LOG": math.log10,
    "EXP": math.exp,
    "NEG": lambda v: -v,
    "INT": lambda v: float(int(v)),
    "FRAC": lambda v: v - int(v),
    "ABS": abs,
    "SGN": lambda v: float(np.sign(v)),
}
DYADIC: dict[int, Callable[[float, float], float]] = {
    1: lambda a, b: a + b,
    2: lambda a, b: a - b,
    3: lambda a, b: a * b,
    4: lambda a, b: a / b,
    8: math.hypot,
    13: lambda a, b: math.degrees(math.atan2(a, b)) % 360,
}
_AXES_OF = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


def plain_language(data: bytes) -> bool:
    """Whether a text is a plain-language program."""
    return re.match(rb"(?:\xef\xbb\xbf)?[\s%]*(?:\d+[ \t]+)?BEGIN[ \t]+PGM", data[:400], re.IGNORECASE) is not None


def without_numbers(data: bytes) -> tuple[bytes, list[int]]:
    """A text without its block numbers, and these."""
    found = [int(m[2]) for m in _NUMBER.finditer(data)]
    return _NUMBER.sub(rb"\1", data), found


@dataclass(slots=True)
class _Step:
    """One move between programmed places, in its plane; `what`: go, corner, lead or leave."""

    what: str
    line: int
    plane: int
    a: complex
    b: complex
    low: float
    high: float
    rapid: bool
    feed: float
    word: float
    side: int
    tool: int
    offset: int
    centre: complex = _NOWHERE
    turn: float = 0.0
    size: float = 0.0
    form: str = ""
    angle: float = 0.0
    before: tuple[bool, float] = (False, math.nan)

    @property
    def arc(self) -> bool:
        return self.turn != 0.0

    def way(self, at_end: bool) -> complex:
        """Direction of travel at an end."""
        if self.arc:
            out = ((self.b if at_end else self.a) - self.centre) * (1j if self.turn > 0 else -1j)
        else:
            out = self.b - self.a
        return out / abs(out) if abs(out) > ARITHMETIC else _NOWHERE


def read(data: bytes, beside: Sequence[tuple[str, bytes]] = ()) -> Reading:
    r"""Read a program's text: its moves and what the proof wants of its lines.

    Parameters
    ----------
    data : bytes
    beside : sequence of (str, bytes)
        Not looked at: what another program does is not known.

    Returns
    -------
    Reading

    Examples
    --------
    >>> text = b"BEGIN PGM A MM\nL X+0 Y+0 FMAX\nL X+5 F600\nRND R1\nL Y+4\nEND PGM A MM\n"
    >>> read(text).moves.end[:, :2].tolist()
    [[0.0, 0.0], [4.0, 0.0], [5.0, 1.0], [5.0, 4.0]]
    """
    return reading_of(data, Reader)


def reading_of(data: bytes, reader_of: type[Reader]) -> Reading:
    """Read a text by one of the readers of HEIDENHAIN's languages."""
    starts = line_starts(data)
    reader = reader_of(data, starts)
    lines = np.array(reader.line, np.int64)
    if (lines == np.arange(len(lines))).all():
        reader.line += range(len(lines), len(starts) - 1)
        missing = len(starts) - 1 - len(lines)
        reader.in_plane += [False] * missing
        reader.words += [math.nan] * missing
        text, lines = data, np.array(reader.line, np.int64)
    else:
        text = b"".join(data[starts[i] : starts[i + 1]] for i in reader.line)
        starts = np.concatenate([[0], np.cumsum(starts[lines + 1] - starts[lines])])
    return _reading(text, starts, lines, _resolved(reader.steps), reader)


# -- from blocks to steps -------------------------------------------------------------------------------------


def _blocks(text: str, starts: Ints) -> Iterator[tuple[int, int, str]]:
    """First and last line of every block, and its text without number and comments."""
    numbered = re.match(r"(?:[\xcf\xef]\xbb\xbf)?[\s%]*\d+[ \t]+BEGIN", text) is not None
    first, whole, open_ended = -1, "", False
    for i in range(len(starts) - 1):
        line = text[starts[i] : starts[i + 1]].rstrip("\r\n\x1a \t")
        bare = re.sub(r"^(?:[\xcf\xef]\xbb\xbf)?[ \t]*(?:/[ \t]*)?(?:\d+(?=[ \t/;*]|$))?[ \t]*(?:/[ \t]*)?", "", line)
        indented = numbered and line[:1] in (" ", "\t") and bare == line.strip() and bare[:1] not in ("", ";", "*", "%")
        goes_on = first >= 0 and (open_ended or indented)
        open_ended = line.endswith("~")
        content = re.sub(r';(?=(?:[^"]*"[^"]*")*[^"]*$).*', "", bare.rstrip("~")).strip()
        if goes_on:
            whole += " " + content
            continue
        if first >= 0:
            yield first, i - 1, whole
        first, whole = i, content
    if first >= 0:
        yield first, len(starts) - 2, whole


@dataclass(slots=True)
class Words:
    """Words of a block: numbers by name, which of them are increments, and what stands alone."""

    number: dict[str, float] = field(default_factory=dict)
    more: set[str] = field(default_factory=set)
    alone: set[str] = field(default_factory=set)
    codes: list[int] = field(default_factory=list)


class Reader:
    """The blocks one after another, each from the place where the one before ends."""

    def __init__(self, data: bytes, starts: Ints) -> None:
        self.steps: list[_Step] = []
        self.line: list[int] = []
        self.in_plane: list[bool] = []
        self.words: list[float] = []
        self.at = [math.nan] * 3
        self.centre = [math.nan] * 3
        self.q: dict[str, float] = {}
        self.unit = 1.0
        self.plane = 17
        self.feed = self.tool_feed = math.nan
        self.was_rapid = False
        self.per_turn = False
        self.side, self.tool, self.sense = 0, -1, 0
        self.offset, self.shifts = 0, {"": 0}
        self.cycle = ""
        self._run(list(self.blocks(data.decode("latin-1").upper(), starts)))

    # -- the language ----------------------------------------------------------------------------------------

    def blocks(self, text: str, starts: Ints) -> Iterator[tuple[int, int, str]]:
        """First and last line of every block, and its text without number and comments."""
        return _blocks(text, starts)

    def label(self, text: str) -> str | None:
        """Label that a block sets, "0" for the end of a subprogram."""
        found = re.match(r"LBL +(.+)", text)
        return found[1].strip() if found else None

    def call(self, text: str) -> tuple[str, int | None] | None:
        """Label that a block calls, "" for one that is not known, and how often a section is repeated."""
        found = re.match(r'CALL +LBL +("[^"]*"|\w+) *(?:REP *(\d+)(?: */ *\d+)?)?$', text)
        if found is None:
            return ("", None) if text.startswith("CALL LBL") else None
        return found[1], None if found[2] is None else int(found[2])

    def jump(self, text: str) -> tuple[int, float, float, str] | None:
        """Number of the comparison, what is compared and the label of a jump."""
        found = re.match(r"FN *0*(9|1[012]) *: *IF *([-+]?) *(\S+) +[A-Z]+ *([-+]?) *(\S+) +GOTO +LBL *(.+)", text)
        if found is None:
            return None
        return int(found[1]), self.value(found[2], found[3]), self.value(found[4], found[5]), found[6].strip()

    def _run(self, blocks: list[tuple[int, int, str]]) -> None:
        """The blocks in the order in which they run; as they stand behind a jump that is not known."""
        labels: dict[str, int] = {}
        for k, (_, _, text) in enumerate(blocks):
            if (name := self.label(text)) is not None:
                labels.setdefault(name, k)
        back: list[int] = []
        rounds: dict[int, int] = {}
        k, known = 0, True
        while k < len(blocks) and len(self.line) < _MOST:
            first, last, text = blocks[k]
            now = len(self.line)
            self.line += range(first, last + 1)
            self.in_plane += [False] * (last + 1 - first)
            self.words += [math.nan] * (last + 1 - first)
            going_on = self.block(text, now)
            for i in range(now, len(self.line)):
                self.words[i] = self.feed if math.isnan(self.words[now]) else self.words[now]
            if not going_on:
                return
            k += 1
            if not known:
                continue
            call, jump = self.call(text), self.jump(text)
            target: str | None = None
            if call is not None and call[1] is not None:
                left = rounds.get(k, call[1])
                rounds[k] = left - 1
                if left:
                    target = call[0]
                else:
                    del rounds[k]
            elif call is not None:
                target = call[0]
                back.append(k)
            elif jump is not None:
                number, a, b, name = jump
                known = a == a and b == b
                if {9: a == b, 10: a != b, 11: a > b, 12: a < b}[number] and known:
                    target = name
            elif self.label(text) == "0" and back:
                k = back.pop()
            if target is not None:
                if re.fullmatch(r"Q[LR]?\d+", target) and target in self.q:
                    target = f"{self.q[target]:.0f}"
                known = target in labels
                k = labels.get(target, k)

    # -- numbers -------------------------------------------------------------------------------------------

    def value(self, sign: str, text: str) -> float:
        """Number, or parameter, with its sign."""
        number = self.q.get(text, math.nan) if text.startswith("Q") else float(text.replace(",", "."))
        return -number if sign == "-" else number

    def taken(self, text: str) -> Words:
        """Words of a block."""
        out = Words()
        place = 0
        while place < len(text):
            found = _TAIL.match(text, place)
            if found is None:
                if not text[place].isspace():
                    out.alone.add("?")
                    rest = re.match(r"\S+", text[place:])
                    place += len(rest[0]) if rest else 1
                else:
                    place += 1
                continue
            place = found.end()
            if found[1]:
                out.alone.add(found[1].replace(" ", ""))
            elif found[4] is None or found[5] is None:
                if found[3] == "M":
                    place += len(re.match(r"[A-Z]* *(?:MAX)?", text[place:])[0])  # type: ignore[index]
            else:
                if found[3] == "M":
                    code = int(self.value(found[4], found[5])) if not found[5].startswith("Q") else -1
                    out.codes.append(code)
                    if code in (101, 103, 118, 120, 128, 138, 140, 142, 143):
                        break
                    continue
                out.number.setdefault(found[3], self.value(found[4], found[5]))
                if found[2]:
                    out.more.add(found[3])
        return out

    # -- blocks --------------------------------------------------------------------------------------------

    def block(self, text: str, line: int) -> bool:
        """Take a block over; False where the program ends."""
        if not text or text[0] in "*%":
            return True
        short = re.match(r"I?[XYZABCUVW] *[-+]? *[Q\d.,]|M *\d", text)
        head = "" if short else re.match(r"[A-Z]*", text)[0]  # type: ignore[index]
        rest = text[len(head) :].strip()
        if head == "BEGIN":
            self.unit = 25.4 if rest.endswith("INCH") else 1.0
        elif head == "END":
            return False
        elif head in ("L", "LP", "C", "CP", "CR", "CT", "CTP", ""):
            return self.go(head, self.taken(rest), line)
        elif head in ("RND", "CHF"):
            self.corner(head, self.taken(text if head == "CHF" else rest), line)
        elif head in ("APPR", "DEP"):
            form = re.match(r"P?(LT|LN|CT|LCT)(?![A-Z])", rest)
            if form is not None:
                return self.lead(head, form[1], self.taken(rest[form.end() :]), line)
        elif head == "CC":
            self.pole(self.taken(rest))
        elif re.match(r"Q[LRS]?\d* *=", text) or head == "FN":
            self._assign(text)
        elif head == "TOOL" and rest.startswith("CALL"):
            self.tool_call(rest[4:].strip())
        elif head == "CYCL" and rest.startswith("DEF"):
            self.define_cycle(rest[3:].strip())
        elif head == "CYCL":
            self.called()
        elif head == "LN":
            self._unknown(self.taken(rest), line)
        elif head in ("TRANS", "PLANE") or (head == "FUNCTION" and "TCPM" in rest):
            self.shifted(text)
        elif head == "TCH":
            for found in re.finditer(r"(Q\d+) *= *([-+]?) *(Q\d+|[\d.,]+)", rest):
                self.q[found[1]] = self.value(found[2], found[3])
            self.q = {k: v for k, v in self.q.items() if not re.fullmatch(r"Q1\d\d", k)}
            self.at = [math.nan] * 3
        elif head == "STOP":
            return not set(self.taken(rest).codes) & {2, 30}
        elif head in ("BLK", "TOOL", "LBL") or (head == "CALL" and rest.startswith("LBL")):
            pass
        elif head == "FUNCTION" and rest.startswith(("FEED", "MODE MILL", "PROG PATH IS CONTOUR", "DWELL", "S-PULSE")):
            pass
        else:
            if head in ("CALL", "PGM"):
                self.q, self.feed, self.centre = {}, math.nan, [math.nan] * 3
            self.at = [math.nan] * 3
        return True

    def _assign(self, text: str) -> None:
        found = re.match(r"(?:FN *(\d+) *: *)?(Q[LR]?\d+) *= *(.*)", text)
        if found is None:
            self.q = {k: v for k, v in self.q.items() if not re.search(rf"{k} *=", text)}
            return
        number, name, right = found.groups()
        try:
            value = self._calculated(int(number) if number else -1, right.replace(",", ".").strip())
        except (ValueError, ArithmeticError, IndexError, KeyError):
            value = math.nan
        self.q[name] = value

    def _calculated(self, number: int, right: str) -> float:
        if number > 0:
            one = r"([-+]?) *(Q[LR]?\d+|[\d.]+)"
            if number in (5, 6, 7):
                found = re.fullmatch(r"(?:SQRT|SIN|COS) *" + one, right)
                return (
                    FUNCTIONS[right.split()[0][:4].strip("+-")](self.value(found[1], found[2])) if found else math.nan
                )
            found = re.fullmatch(one + r" *(?:\+|-|\*|/|DIV|LEN|ANG) *" + one, right)
            if found is None or number not in DYADIC:
                return math.nan
            return float(DYADIC[number](self.value(found[1], found[2]), self.value(found[3], found[4])))
        tokens = re.findall(r"Q[LR]?\d+|\d+\.?\d*|\.\d+|[A-Z]+|\S", right)[::-1]
        value = self._climb(tokens, 0)
        return math.nan if tokens else value

    def _climb(self, tokens: list[str], least: int) -> float:
        """Value of an expression by precedence; takes its tokens from the end of the list."""
        token = tokens.pop()
        if token in "+-":
            value = self._climb(tokens, 4) * (-1 if token == "-" else 1)
        elif token == "(":
            value = self._climb(tokens, 0)
            if tokens.pop() != ")":
                raise ValueError(token)
        elif token == "PI":
            value = math.pi
        elif token in FUNCTIONS:
            value = float(FUNCTIONS[token](self._climb(tokens, 4)))
        else:
            value = self.value("", token)
        rank = {"+": 1, "-": 1, "*": 2, "/": 2, "%": 2, "^": 3}
        while tokens and rank.get(tokens[-1], -1) > least:
            sign = tokens.pop()
            other = self._climb(tokens, rank[sign])
            if sign == "+":
                value += other
            elif sign == "-":
                value -= other
            elif sign == "*":
                value *= other
            elif sign == "/":
                value /= other
            elif sign == "^":
                value = math.pow(value, other)
            else:
                value = math.fmod(value, other)
        return value

    def tool_call(self, rest: str) -> None:
        """A tool, its axis and its feed."""
        found = re.match(r'"([^"]*)"|(\d+)(?:\.\d+)?|(Q[LR]?\d+)', rest)
        was = self.tool
        if found is not None:
            if found[1] is not None:
                self.tool = named_tool(found[1].encode("latin-1"))
            else:
                number = float(found[2]) if found[2] else self.value("", found[3])
                self.tool = -1 if math.isnan(number) else int(number)
            rest = rest[found.end() :]
        if self.tool != was:
            self.at[2] = math.nan
        axis = re.search(r"(?:^| )([XYZ])(?= |S|F|$)", rest)
        if axis is not None:
            self.plane = {"X": 19, "Y": 18, "Z": 17}[axis[1]]
        feed = re.search(r"(?<![A-Z])F *(Q[LR]?\d+|[\d.,]+)", rest)
        if feed is not None:
            self.feed = self.tool_feed = self.value("", feed[1])

    def define_cycle(self, rest: str) -> None:
        """What the definition of a cycle does to place, datum and parameters."""
        number = re.match(r"(\d+)(\.\d+)?", rest)
        if number is None:
            return
        for found in re.finditer(r"(Q\d+) *= *([-+]?) *(Q\d+|[\d.,]+)", rest):
            self.q[found[1]] = self.value(found[2], found[3])
        if number[1] in ("7", "247"):
            self.shifted("" if re.fullmatch(r"7\.1 *(?:I?[XYZ] *[-+]?0*[.,]?0* *)+", rest) else rest)
        elif number[1] in ("8", "10", "11", "19", "26", "27", "28", "29"):
            if number[2] != ".0":
                self.shifted(rest)
        elif int(number[1]) not in (9, 13, 14, 20, 21, 22, 23, 24, 25, 32, 270, 271, 272):
            self.cycle = number[1]

    def shifted(self, how: str) -> None:
        """Another datum or frame: the place is not known."""
        self.offset = self.shifts.setdefault(how, -len(self.shifts))
        self.at = [math.nan] * 3

    def called(self) -> None:
        """A cycle runs: where it leaves the tool."""
        known = int(self.cycle or -1) in (1, 2, 17, 18, *range(200, 208), 209, 240, 241)
        self.at = [*self.at[:2], math.nan] if known else [math.nan] * 3
        if self.cycle == "12":
            self.q = {}

    def pole(self, words: Words) -> None:
        """Where arcs have their centre and polar places their pole."""
        axes = _AXES_OF[self.plane][:2]
        named = [k for k in range(3) if "XYZ"[k] in words.number]
        if not named:
            self.centre = list(self.at)
            return
        self.centre = [math.nan] * 3
        for k in named:
            if k in axes:
                self.centre[k] = self._coordinate(words, k)

    def _coordinate(self, words: Words, k: int) -> float:
        name = "XYZ"[k]
        if name not in words.number:
            return self.at[k]
        return words.number[name] * self.unit + (self.at[k] if name in words.more else 0.0)

    def _there(self, head: str, words: Words) -> tuple[list[float], float]:
        """End of a block, and the angle in rad by which a polar one is stated to turn; NaN where it is not."""
        a, b, _ = _AXES_OF[self.plane]
        end = [self._coordinate(words, k) for k in range(3)]
        turn = math.nan
        if "PR" in words.number or "PA" in words.number or head in ("LP", "CP", "CTP"):
            pole = complex(self.centre[a], self.centre[b])
            arm = complex(self.at[a], self.at[b]) - pole
            radius, angle = abs(arm), math.degrees(cmath.phase(arm)) if arm == arm else math.nan
            if "PR" in words.number:
                radius = words.number["PR"] * self.unit + (radius if "PR" in words.more else 0.0)
            if "PA" in words.number:
                if "PA" in words.more:
                    turn = math.radians(words.number["PA"])
                    angle += words.number["PA"]
                else:
                    angle = words.number["PA"]
            place = pole + radius * cmath.exp(1j * math.radians(angle))
            end[a], end[b] = place.real, place.imag
        return end, turn

    def _modal(self, words: Words) -> bool:
        """Take feed and compensation over; whether the block runs in rapid traverse."""
        if words.alone & {"R0", "RL", "RR"}:
            self.side = 1 if "RL" in words.alone else -1 if "RR" in words.alone else 0
        if "FAUTO" in words.alone:
            self.feed = self.tool_feed
        elif "FMAX" not in words.alone:
            if "F" in words.number:
                self.feed = words.number["F"]
            elif words.number.keys() & {"FU", "FZ", "FT"}:
                self.feed = math.nan
        return "FMAX" in words.alone

    def _speed(self, word: float) -> float:
        return math.nan if self.per_turn else word * (2.54 if self.unit != 1.0 else 1.0) / 60

    def _step(self, what: str, line: int, end: list[float], rapid: bool) -> _Step:
        a, b, c = _AXES_OF[self.plane]
        return _Step(
            what,
            line,
            self.plane,
            complex(self.at[a], self.at[b]),
            complex(end[a], end[b]),
            self.at[c],
            end[c],
            rapid,
            self._speed(self.feed),
            self.feed,
            self.side,
            self.tool,
            self.offset,
        )

    def go(self, head: str, words: Words, line: int) -> bool:
        """A contour element; False where the program ends."""
        stated = words.number.keys() & {"X", "Y", "Z", "PR", "PA"}
        self.in_plane[line] = bool(words.number.keys() & {"X", "Y", "PR", "PA"})
        if 136 in words.codes or 137 in words.codes:
            self.per_turn = 136 in words.codes
        if set(words.codes) & {114, 115, 128, 129, 144, 145}:
            self.shifted(" ".join(str(code) for code in words.codes if code in (114, 128, 144)))
        end, turn = self._there(head, words)
        if "?" in words.alone:
            end = [math.nan] * 3
        rapid = self._modal(words)
        if stated or head not in ("L", "", "LP"):
            step = self._step("go", line, end, rapid)
            a, b, _ = _AXES_OF[self.plane]
            if head in ("C", "CP", "CR", "CT", "CTP"):
                self._bend(step, head, words, turn)
            if 91 in words.codes or 92 in words.codes:
                end = [math.nan if "XYZ"[k] in words.number else end[k] for k in range(3)]
                step.b = complex(end[a], end[b])
                step.high = end[_AXES_OF[self.plane][2]]
            self.steps.append(step)
            self.at, self.was_rapid = end, rapid
        if 140 in words.codes:
            self.at[2] = math.nan
        if 89 in words.codes or 99 in words.codes:
            self.called()
        return not (2 in words.codes or 30 in words.codes)

    def _bend(self, step: _Step, head: str, words: Words, turn: float) -> None:
        """Centre and angle of an arc."""
        step.rapid = False
        for sign in (1, -1):
            if ("DR+" if sign > 0 else "DR-") in words.alone:
                self.sense = sign
        sense, chord = self.sense, step.b - step.a
        if head in ("C", "CP"):
            a, b, _ = _AXES_OF[self.plane]
            step.centre = complex(self.centre[a], self.centre[b])
        elif head == "CR":
            radius = words.number.get("R", math.nan) * self.unit
            half = chord / 2
            rise = math.sqrt(max(radius**2 - abs(half) ** 2, 0.0)) if radius == radius else math.nan
            left = sense if radius > 0 else -sense
            step.centre = step.a + half + 1j * left * rise * (half / abs(half) if abs(half) else _NOWHERE)
        else:
            before = self.steps[-1] if self.steps and self.steps[-1].what in ("go", "lead") else None
            ahead = _NOWHERE if before is None else before.way(at_end=True)
            if before is not None and before.what == "lead":
                ahead = _NOWHERE
            # The chord makes half the angle of the arc with the tangent.
            step.turn = 2 * cmath.phase(chord / ahead) if ahead == ahead and chord else math.nan
            if abs(step.turn) < 2e-6:
                step.turn = 0.0
                return
            step.centre = (step.a - step.b * cmath.exp(-1j * step.turn)) / (1 - cmath.exp(-1j * step.turn))
            return
        if turn == turn:
            step.turn = turn
            return
        ratio = (step.b - step.centre) / (step.a - step.centre) if step.a != step.centre else _NOWHERE
        angle = cmath.phase(ratio) if ratio == ratio else math.nan
        if abs(chord) <= ARITHMETIC:
            angle = 0.0
        angle = angle % (2 * math.pi) if sense > 0 else -((-angle) % (2 * math.pi))
        step.turn = angle if angle != 0 else sense * 2 * math.pi

    def corner(self, head: str, words: Words, line: int) -> None:
        """A corner that the control makes of its neighbours."""
        size = words.number.get("R" if head == "RND" else "CHF", math.nan) * self.unit
        held = self.feed
        rapid = self._modal(words)
        step = self._step("corner", line, self.at, rapid)
        step.size, step.form = size, head
        self.steps.append(step)
        self.feed = held
        self.words[line] = step.word

    def lead(self, head: str, form: str, words: Words, line: int) -> bool:
        """An approach or departure; False where the program ends."""
        self.in_plane[line] = bool(words.number.keys() & {"X", "Y", "PR", "PA"})
        before = self.was_rapid, self._speed(self.feed)
        end, _ = self._there("", words)
        side = self.side
        rapid = self._modal(words)
        step = self._step("lead" if head == "APPR" else "leave", line, end, rapid)
        step.form, step.before = form, before
        step.size = words.number.get("LEN" if form in ("LT", "LN") else "R", math.nan) * self.unit
        step.angle = math.radians(words.number.get("CCA", math.nan))
        self.was_rapid = rapid
        if head == "APPR":
            self.steps.append(step)
            self.at = end
        else:
            step.side = side
            self.side = 0
            last = self.steps[-1] if self.steps else None
            step.centre = last.way(at_end=True) if last is not None and last.what == "go" else _NOWHERE
            self.steps.append(step)
            a, b, c = _AXES_OF[self.plane]
            self.at = list(self.at)
            self.at[c] = end[c]
            far = _departure(step)[-1].b
            known = form == "LCT" or side == 0
            self.at[a], self.at[b] = (far.real, far.imag) if known else (math.nan, math.nan)
        return not (2 in words.codes or 30 in words.codes)

    def _unknown(self, words: Words, line: int) -> None:
        end, _ = self._there("", words)
        self.in_plane[line] = True
        self.steps.append(self._step("go", line, end, self._modal(words)))
        self.at = end


# -- corners and approaches -----------------------------------------------------------------------------------


def _resolved(steps: list[_Step]) -> list[_Step]:
    """The moves: corners cut or rounded, approaches and departures in their parts."""
    out: list[_Step] = []
    for i, step in enumerate(steps):
        behind = steps[i + 1] if i + 1 < len(steps) and steps[i + 1].what == "go" else None
        if step.what == "corner":
            before = out[-1] if out and out[-1].what == "go" else None
            out.append(_cut(before, step, behind))
        elif step.what == "lead":
            out += _approach(step, _NOWHERE if behind is None else behind.way(at_end=False))
        elif step.what == "leave":
            out += _departure(step)
        else:
            out.append(step)
    return out


def _cut(before: _Step | None, corner: _Step, behind: _Step | None) -> _Step:
    """The line or arc in place of a corner; shortens its neighbours."""
    lost = replace(corner, what="done", a=_NOWHERE, b=_NOWHERE)
    if before is None or behind is None or not corner.size > 0 or before.low != before.high:
        return lost
    u, v = before.way(at_end=True), behind.way(at_end=False)
    bend = cmath.phase(v / u) if u == u and v == v else math.nan
    if not 1e-6 <= abs(bend) <= math.pi - 1e-6:
        return lost
    if corner.form == "CHF":
        short, turn = corner.size, 0.0
        a, b, centre = before.b - short * u, behind.a + short * v, _NOWHERE
        if before.arc or behind.arc:
            return lost
    else:
        side = 1 if bend > 0 else -1
        found = _tangent_circle(before, behind, side, corner.size)
        if found is None:
            return lost
        a, centre, b = found
        turn = side * ((side * cmath.phase((b - centre) / (a - centre))) % (2 * math.pi))
    if before.arc:
        before.turn -= _swept(a, before.b, before.centre, before.turn)
    before.b = a
    if behind.arc:
        behind.turn -= _swept(behind.a, b, behind.centre, behind.turn)
    behind.a = b
    return replace(corner, what="done", a=a, b=b, centre=centre, turn=turn, rapid=False)


def _swept(a: complex, b: complex, centre: complex, turn: float) -> float:
    sense = 1 if turn > 0 else -1
    angle = (sense * cmath.phase((b - centre) / (a - centre))) % (2 * math.pi)
    # A hair behind is nothing, not a whole turn.
    return sense * (angle if angle < 2 * math.pi - 1e-9 else 0.0)


def _tangent_circle(before: _Step, behind: _Step, side: int, radius: float) -> tuple[complex, complex, complex] | None:
    """Where a circle on one side touches two steps, and its centre between them: found along the first by bisection."""

    def at(share: float) -> tuple[complex, complex]:
        """Place on the first step at a share from its end, and the centre beside it."""
        if before.arc:
            place = before.centre + (before.b - before.centre) * cmath.exp(-1j * share * before.turn)
            ahead = (place - before.centre) * (1j if before.turn > 0 else -1j)
        else:
            place, ahead = before.b + share * (before.a - before.b), before.b - before.a
        return place, place + side * 1j * radius * ahead / abs(ahead)

    def gap(share: float) -> float:
        """By how much that centre is nearer to the second step's line or circle than the radius, on its side."""
        centre = at(share)[1]
        if behind.arc:
            sense = 1 if behind.turn > 0 else -1
            arm = abs(behind.a - behind.centre)
            return side * sense * (arm - abs(centre - behind.centre)) - radius
        v = behind.way(at_end=False)
        return side * ((centre - behind.a) / v).imag - radius

    shares = np.linspace(0.0, 1.0, 257)
    values = [gap(float(share)) for share in shares]
    for k in range(len(shares) - 1):
        if values[k] == 0.0 and k:
            share = float(shares[k])
        elif values[k] * values[k + 1] < 0:
            low, high = float(shares[k]), float(shares[k + 1])
            while low < (share := (low + high) / 2) < high:
                low, high = (share, high) if gap(share) * values[k] > 0 else (low, share)
        elif k == len(shares) - 2 and abs(values[-1]) < ARITHMETIC:
            share = 1.0
        else:
            continue
        a, centre = at(share)
        if behind.arc:
            arm = centre - behind.centre
            b = behind.centre + arm / abs(arm) * abs(behind.a - behind.centre)
            if abs(_swept(behind.a, b, behind.centre, behind.turn)) > abs(behind.turn) + 1e-9:
                continue
        else:
            v = behind.way(at_end=False)
            along = ((centre - behind.a) / v).real
            if not -ARITHMETIC <= along <= abs(behind.b - behind.a) + ARITHMETIC:
                continue
            b = behind.a + along * v
        return a, centre, b
    return None


def _approach(step: _Step, ahead: complex) -> list[_Step]:
    """From where the tool is to the contour; in the plane first, then down, then onto it."""
    left = 1 if step.side > 0 else -1
    contour, start = step.b, step.a
    centre, turn = _NOWHERE, 0.0
    if step.form == "LT":
        helper = contour - step.size * ahead
    elif step.form == "LN":
        helper = contour + left * 1j * step.size * ahead
    else:
        left = left if step.size > 0 else -left
        centre = contour + left * 1j * abs(step.size) * ahead
        if step.form == "CT":
            turn = left * step.angle
            helper = centre + (contour - centre) / cmath.exp(1j * turn)
        else:
            helper = _touched(start, centre, abs(step.size), left)
            turn = left * ((left * cmath.phase((contour - centre) / (helper - centre))) % (2 * math.pi))
            turn = turn if turn else left * 2 * math.pi
    if math.isnan(helper.real):
        return [replace(step, what="done", b=_NOWHERE)]
    rapid, feed = (step.rapid, step.feed) if step.form == "LCT" else step.before
    over = step.high if step.form == "LCT" else step.low
    out = [replace(step, what="done", b=helper, high=over, rapid=rapid, feed=feed)]
    if over != step.high and not math.isnan(step.high):
        out.append(replace(step, what="done", a=helper, b=helper, low=over, rapid=rapid, feed=feed))
    onto = replace(step, what="lead", a=helper, low=step.high, centre=centre, turn=turn)
    if onto.rapid and turn:
        onto.rapid, onto.feed = False, math.nan
    return [*out, onto]


def _touched(start: complex, centre: complex, radius: float, left: int) -> complex:
    """Where the tangent from a place meets a circle that is run in a sense."""
    away = abs(start - centre)
    if not away >= radius - ARITHMETIC:
        return _NOWHERE
    # The triangle of centre, start and place is right-angled at the place.
    along = radius**2 / away
    aside = math.sqrt(max(radius**2 - along**2, 0.0))
    return centre + (start - centre) / away * complex(along, left * aside)


def _departure(step: _Step) -> list[_Step]:
    """From the contour, left in the direction that `centre` holds, to where the tool is free."""
    ahead, contour = step.centre, step.a
    left = 1 if step.side > 0 else -1
    flat = replace(step, what="done", high=step.low, centre=_NOWHERE)
    if ahead != ahead:
        return [replace(step, what="done", b=_NOWHERE, centre=_NOWHERE)]
    if step.form in ("LT", "LN"):
        out = [replace(flat, b=contour + step.size * ahead * (1 if step.form == "LT" else left * 1j))]
    else:
        left = left if step.size > 0 else -left
        centre = contour + left * 1j * abs(step.size) * ahead
        if step.form == "CT":
            turn = left * step.angle
            out = [replace(flat, b=centre + (contour - centre) * cmath.exp(1j * turn), centre=centre, turn=turn)]
        else:
            # Run backwards it is an approach on the other side.
            helper = _touched(step.b, centre, abs(step.size), -left)
            if math.isnan(helper.real):
                return [replace(step, what="done", b=_NOWHERE, centre=_NOWHERE)]
            turn = left * ((left * cmath.phase((helper - centre) / (contour - centre))) % (2 * math.pi))
            out = [replace(flat, b=helper, centre=centre, turn=turn or left * 2 * math.pi), replace(flat, a=helper)]
        if out[0].rapid:
            out[0].rapid, out[0].feed = False, math.nan
    if step.high != step.low and not math.isnan(step.high):
        out.append(replace(out[-1], a=out[-1].b, high=step.high, centre=_NOWHERE, turn=0.0, rapid=step.rapid))
    return out


# -- columns --------------------------------------------------------------------------------------------------


def _reading(text: bytes, starts: Ints, lines: Ints, steps: list[_Step], reader: Reader) -> Reading:
    n = len(steps)
    start, end, centre = np.full((n, 3), np.nan), np.full((n, 3), np.nan), np.full((n, 2), np.nan)
    for i, step in enumerate(steps):
        a, b, c = _AXES_OF[step.plane]
        start[i, [a, b, c]] = step.a.real, step.a.imag, step.low
        end[i, [a, b, c]] = step.b.real, step.b.imag, step.high
        if step.arc:
            centre[i] = step.centre.real, step.centre.imag
    kind = np.array([Kind.ARC if s.arc else Kind.RAPID if s.rapid else Kind.LINE for s in steps], np.int64)
    turn = np.array([s.turn for s in steps], np.float64)
    line = np.array([s.line for s in steps], np.int64)

    def column(name: str) -> Ints:
        return np.array([getattr(s, name) for s in steps], np.int64)

    feed: Floats = np.array([math.nan if s.rapid and not s.arc else s.feed for s in steps], np.float64)
    moves = PlainMoves(
        kind,
        start,
        end,
        centre,
        turn,
        np.full((n, 4), np.nan),
        column("plane"),
        feed,
        column("tool"),
        column("side"),
        column("offset"),
        line,
    )
    words = np.array(reader.words, np.float64)
    feeding = np.unique(line[kind != Kind.RAPID])
    words[np.setdiff1d(line, feeding)] = np.nan
    motion = np.full(len(lines), 10, np.int64)
    motion[line] = np.where(kind == Kind.ARC, np.where(turn < 0, 20, 30), np.where(kind == Kind.RAPID, 0, 10))
    in_plane = np.array(reader.in_plane, np.bool_)
    corners = np.broadcast_to(np.nan, len(moves))
    return Reading(text, starts, text, starts, lines, motion, in_plane, words, corners, moves)
