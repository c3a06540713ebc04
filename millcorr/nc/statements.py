# SPDX-License-Identifier: LGPL-2.1-or-later
"""One line of a program that holds more than letters with numbers, taken apart into pieces with their places.

Named addresses become words of one small letter, so that a line of any family is a row of words:
`X=AC(5)` is `u5`, `CR=5` is `R5`, `,R2` and `RND=2` are `r2`.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field, replace

from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.nc.toolpath import named_tool

from .codes import (
    CIRCLE_BY_POINT,
    MODAL_CALL,
    MODAL_CALL_OFF,
    NEW_FRAME,
    OTHER_FRAME,
    SHIFT,
    SHIFT_MORE,
    SWIVEL,
    SWIVEL_OFF,
    TANGENT_CIRCLE,
)
from .expressions import UnknownValue, evaluate, evaluate_factor, variable

LARGEST = 1e9
"""Numbers beyond this are no coordinates, codes or line numbers."""

INCREMENTS = {"X": "x", "Y": "y", "Z": "z"}
POSITIONS = {"X": "u", "Y": "v", "Z": "w"}
CENTRES = "ijk"
"""Letters of X=IC(), X=AC() and I=AC()."""
ADDRESSES = {
    "CR": "R",
    "AR": "a",
    "TURN": "p",
    "I1": "l",
    "J1": "m",
    "K1": "n",
    "RND": "r",
    "RNDM": "s",
    "CHF": "d",
    "CHR": "c",
    "ANG": "g",
    "AP": "h",
    "RP": "q",
    "FRC": "!",
    "FRCM": "&",
}
"""Siemens' named addresses and the letters they are words of; signs, where no letter is left."""
ANGLES = {"AC": "t", "IC": "o"}
"""Letters of AP=AC() and AP=IC()."""
POLE_CODES = (110, 111, 112)
POLES = {"G": "b", "X": "e", "Y": "f", "x": "e", "y": "f", "u": "e", "v": "f"}
"""Letters of what a line with G110, G111, G112 states: no code and no target of a move."""
_CORNERS = {"R": "r", "C": "c", "A": "g"}
_MOTIONS = {"CIP": CIRCLE_BY_POINT, "CT": TANGENT_CIRCLE}
_FRAMES = ("ROT", "AROT", "ROTS", "AROTS", "MIRROR", "AMIRROR", "SCALE", "ASCALE")
_NO_MOVE = "FB SPOS SPOSA DISR ADIS ADISPOS OVR OVRA DL STOPRE FFWON SCC S M H".split()
"""Assigned names that neither move nor are variables."""

_TOOL = re.compile(r'(?<![A-Z_])T(?:(?:\d*[ \t]*=)?[ \t]*"(?P<quoted>[^"]*)"|\d*[ \t]*=[ \t]*(?P<bare>[^\s"=(;]+))')
_NUMBER = re.compile(
    r"([A-Z])[ \t]*([+-]?[ \t]*(?:[0-9][0-9 \t]*(?:\.[0-9 \t]*)?|\.[ \t]*[0-9][0-9 \t]*))(?![0-9.\[#]|\s*=|,\s*[0-9])"
)
_CORNER = re.compile(r",\s*([A-Z])\s*=?\s*")
_VARIABLE = re.compile(r"#|(?:R|VC|V|Q)\d+\s*=|(?:R|VC|V|Q|\$[A-Z_0-9]+)\s*\[[^=]*\]\s*=|\$[A-Z_0-9]+\s*=")
_EQUALS = re.compile(r"([A-Z_]+\d*(?:_[A-Z_0-9]+)?)\s*(\[[^\]=]*\])?\s*=(?!=)\s*")
_MODE = re.compile(r"(AC|IC|DC|ACP|ACN)\s*\(")
_COMPUTED = re.compile(r"([A-Z])\s*(?=[+-]?\s*(?:[\[#<]|VC\d|V\d|Q[LRS]?\d))")
_WORD = re.compile(r"\$?[A-Z_][A-Z_0-9]*:?")
_BEFORE_EXPRESSION = re.compile(r"(?:\b(?:AC|IC|DC|ACP|ACN|MSG|IF|WHILE|UNTIL|NOT|AND|OR)\s*|[A-Z_]{2}[A-Z_0-9]*)$")
_NO_CALL = re.compile(
    r"(?:^|[\s0-9])(?:SUB|ENDSUB|CALL|ELSE|ENDIF|ENDWHILE|ENDREPEAT|DO|END\d+|DO\d+|ENDLOOP|RET|RTS)$"
)
_CALLS = ("CALL", "CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE")
_QUIET = frozenset(
    "MSG SETAL STOPRE WORKPIECE FFWON FFWOF SOFT BRISK DRIVE DIAMOF DIAM90 CUT2D CUT2DF CFC CFTCP CFIN COMPOF "
    "COMPON COMPCAD COMPCURV CYCLE832 TRAFOOF UPATH SPATH KONT KONTT KONTC NORM CDON CDOF CDOF2 ORIWKS ORIMKS "
    "ORIAXES FIFOCTRL STARTFIFO STOPFIFO SBLON SBLOF DISPLOF DISPLON SAVE EXTERN DEF PROC GETTCOR DYNNORM DYNPOS "
    "DYNROUGH DYNSEMIFIN DYNFINISH SPCON SPCOF LIMS ENDPROC WALIMON WALIMOF RTLION RTLIOF RPY EULER ACTFRAME "
    "PAROTOF TOROTOF".split()
)
_TITLE = re.compile(
    r"\s*(?:N\s*\d+\s*)?(O\s*\d+\s+)?"
    r"(?!O\s*\d)(?!(?:IF|WHILE|GOTO\w?|FOR|REPEATB?|CALL|DEF|PROC|EXTERN|MSG|DO|LOOP|SUB|ELSE\w*|END\w+|CASE|RETURN|UNTIL|BEGIN"
    r"|TOOL[ \t]+(?:CALL|DEF)|BLK|BREAK|CONTINUE|A?TRANS|A?ROTS?|A?MIRROR|A?SCALE|WORKPIECE|CYCLE\d*|SUPA)\b)"
    r"(?=.*[A-Z]{3})([A-Z0-9][A-Z0-9 ._/:+-]*)"
)
"""Titles that posts write without brackets: O1000 BRACKET REV B."""
_SHORT = frozenset("IF DO OR AC IC DC GE GT LE LT EQ NE CT".split())


@dataclass(frozen=True, slots=True)
class Piece:
    """A word of a line and where it stands.

    Parameters
    ----------
    letter : str
        Its address: a capital, or a small letter for a named address.
    value : float
        Its number; NaN where it is computed.
    start, end : int
        Where it stands in the line.
    before, after : str
        What goes before and behind a new number in its place.
    expression : str
        What computes it; "" for a number.
    """

    letter: str
    value: float
    start: int
    end: int
    before: str
    after: str = ""
    expression: str = ""


@dataclass(slots=True)
class Statement:
    """A line taken apart.

    Parameters
    ----------
    pieces : list of Piece
    reasons : list of str
        Why it cannot be followed.
    effect : str
        See `OddLine`.
    assigned : list of (str, str)
        Variable and expression of every assignment.
    flow : str
        Text from the first word that steers the order of the lines, or calls; upper case, without comments.
    label : str
        Name of the line: Siemens' label, Okuma's sequence name.
    """

    pieces: list[Piece] = field(default_factory=list)
    reasons: list[str] = field(default_factory=list)
    effect: str = ""
    assigned: list[tuple[str, str]] = field(default_factory=list)
    flow: str = ""
    label: str = ""


def without_comments(text: str) -> str:
    """Line in capitals with blanks in place of its comments; parentheses of expressions stay.

    Examples
    --------
    >>> without_comments("g1 x=ac(5) (a comment)").rstrip()
    'G1 X=AC(5)'
    """
    out = list(text.upper() if len(text.upper()) == len(text) else text)
    depth, i = 0, 0
    while i < len(out):
        c = out[i]
        if c == ";":
            out[i:] = " " * (len(out) - i)
        elif c == '"':
            i = next((k for k in range(i + 1, len(out)) if out[k] == '"'), len(out))
        elif c == "(" and (depth or _opens_expression("".join(out[:i]))):
            depth += 1
        elif c == ")" and depth:
            depth -= 1
        elif c == "(":
            close = next((k for k in range(i + 1, len(out)) if out[k] in "()"), -1)
            if close >= 0 and out[close] == ")":
                out[i : close + 1] = " " * (close + 1 - i)
                i = close
        i += 1
    return "".join(out)


def _opens_expression(before: str) -> bool:
    bare = before.rstrip(" \t")
    if not bare:
        return False
    computes = "=" in bare or bool(re.search(r"\b(?:IF|WHILE|UNTIL)\b", bare))
    if bare[-1] in "=<>[," or (computes and bare[-1] in "+-*/"):
        return True
    found = _BEFORE_EXPRESSION.search(before)
    return bool(found) and not _NO_CALL.search(bare)


def take_line_apart(raw: str, name: str, line: int) -> Statement:
    """Take one line apart that holds more than plain words.

    Parameters
    ----------
    raw : str
        The line without its ending.
    name : str
        Name of the program, for messages.
    line : int
        Index of the line from 0.

    Returns
    -------
    Statement

    Raises
    ------
    FormatError
        If a word is malformed.
    """
    return _Line(without_comments(raw), name, line).statement()


def pole_of(line: Statement) -> Statement:
    """A line that states the pole of Siemens' polar positions (G110, G111, G112), from its plain words."""
    pieces = []
    for piece in line.pieces:
        if piece.letter in "xyuv":
            # X=AC(), X=IC(): a pole is relative to what its code says.
            piece = replace(piece, value=math.nan, expression="")
        if piece.letter in POLES and (piece.letter != "G" or piece.value in POLE_CODES):
            piece = replace(piece, letter=POLES[piece.letter])
        if piece.letter not in "Zzw":
            pieces.append(piece)
    return replace(line, pieces=pieces)


def is_title(raw: str, before: str) -> Statement | None:
    """A line above the first code that is a title without brackets, as its program number; None for other lines.

    Parameters
    ----------
    raw : str
        The line.
    before : str
        The line before it: a single word is a title only behind the mark or number of the program.
    """
    found = _TITLE.fullmatch(without_comments(raw).rstrip())
    if found is None:
        return None
    number, words = found.groups()
    if not (number or len(words.split()) > 1 or re.match(r"\s*(?:%(?!_N_)|[Oo:]\s*\d)", before)):
        return None
    if number is None:
        return Statement()
    digits = re.sub(r"\D", "", number)
    return Statement([Piece("O", float(digits), found.start(1), found.start(1) + len(number.rstrip()), "O")])


class _Line:
    """One pass over one line."""

    def __init__(self, text: str, name: str, line: int) -> None:
        self.text = text.rstrip("* \t\r\n\x0b\x0c\x1a")
        self.name, self.line = name, line
        self.out = Statement()

    def statement(self) -> Statement:
        out, text = self.out, self.text
        place = 0
        skip = re.match(r"[ \t]*(?:N[ \t]*\d+[ \t]*)?/[1-9]?", text)
        if skip:
            number = re.match(r"[ \t]*N[ \t]*(\d+)", text)
            if number:
                out.pieces.append(Piece("N", float(number.group(1)), number.start(), number.end(), "N"))
            place = skip.end()
        while place < len(text):
            if text[place] in " \t\r\x0b\x0c":
                place += 1
                continue
            if text[place] == '"':
                place = text.find('"', place + 1) + 1 or len(text)
                continue
            place = self._piece(place)
        return out

    def _malformed(self, place: int) -> FormatError:
        return FormatError(malformed(self.text[place:]), self.name, self.line + 1)

    def _piece(self, place: int) -> int:
        text, out = self.text, self.out
        if found := _TOOL.match(text, place):
            tool = found["bare"] if found["quoted"] is None else found["quoted"]
            if tool and not re.fullmatch(r"[RQ]\d+|VC\d+", tool):
                number = float(named_tool(tool.encode("latin-1", "replace")))
                out.pieces.append(Piece("T", number, place, found.end(), "T"))
            return found.end()
        if found := _NUMBER.match(text, place):
            return self._number(found)
        if found := _CORNER.match(text, place):
            return self._corner(found)
        if _VARIABLE.match(text, place):
            return self._assignment(place)
        if found := _EQUALS.match(text, place):
            return self._equals(found)
        if found := _COMPUTED.match(text, place):
            return self._computed(found)
        if found := _WORD.match(text, place):
            return self._keyword(found)
        raise self._malformed(place)

    def _number(self, found: re.Match[str]) -> int:
        letter, number = found.groups()
        value = float(re.sub(r"[ \t]", "", number))
        if abs(value) > LARGEST:
            raise FormatError(phrase("number too large: correct it"), self.name, self.line + 1)
        rest = self.text[found.end() :].strip()
        if letter == "O" and rest:
            # An O word with a keyword behind it.
            self._steers(found.start(), phrase("an O word steers the program"))
            return len(self.text)
        end = found.start() + len(found.group().rstrip())
        self.out.pieces.append(Piece(letter, value, found.start(), end, letter))
        return found.end()

    def _corner(self, found: re.Match[str]) -> int:
        letter = _CORNERS.get(found.group(1))
        if letter is None:
            raise self._malformed(found.start())
        return self._value(letter, found.start(), found.end(), f",{found.group(1)}", factor=True)

    def _value(self, letter: str, start: int, place: int, before: str, factor: bool = False) -> int:
        """Add a word whose value is an expression."""
        rule = evaluate_factor if factor else evaluate
        try:
            _, end = rule(self.text, place, None)
        except UnknownValue as error:
            raise self._malformed(start) from error
        source = self.text[place:end].rstrip()
        value, expression = _constant(source)
        self.out.pieces.append(Piece(letter, value, start, place + len(source), before, "", expression))
        return end

    def _assignment(self, place: int) -> int:
        """A variable that is set, by its sign."""
        try:
            _, end = variable(self.text, place, None)
            sign = re.compile(r"\s*=\s*").match(self.text, end)
            if sign is None:
                raise self._malformed(place)
            return self._assign(self.text[place:end].strip(), sign.end())
        except UnknownValue:
            self.out.reasons.append(phrase("variable set: {}", self.text[place:].strip()[:40]))
            self.out.assigned.append((self.text[place:], ""))
            return len(self.text)

    def _assign(self, target: str, place: int) -> int:
        _, end = evaluate(self.text, place, None)
        self.out.assigned.append((target, self.text[place:end].strip()))
        system = re.match(r"#\s*(\d+)$", target)
        if (system and int(system.group(1)[:9]) >= 5000) or target.startswith("$"):
            self.out.reasons.append(phrase("{} may change the frame", target))
            self.out.effect = self.out.effect or "frame"
        return end

    def _equals(self, found: re.Match[str]) -> int:
        """A named address, or a variable with a name."""
        name, index, place, start = found.group(1), found.group(2), found.end(), found.start()
        bare = name.rstrip("0123456789")
        if mode := _MODE.match(self.text, place):
            return self._stated_mode(name, mode.group(1), start, place, mode.end())
        if name in ADDRESSES:
            return self._value(ADDRESSES[name], start, place, f"{name}=")
        if len(name) == 1 and name not in "SMHDTE":
            if name in "GO":
                self._steers(start, phrase("{} is assigned with '='", name))
                return len(self.text)
            return self._value(name, start, place, f"{name}=")
        if name in ("POS", "POSA", "POLF"):
            self.out.reasons.append(phrase("{} is not followed", name))
            stated = {piece.letter for piece in self.out.pieces}
            self.out.pieces += [Piece(axis, math.nan, start, start, axis) for axis in "XYZ" if axis not in stated]
            return self._behind(place)
        if bare in _NO_MOVE or (len(bare) == 1 and not index):
            return self._behind(place)
        if name == "OFFN":
            self.out.reasons.append(phrase("OFFN shifts the contour"))
            self.out.effect = self.out.effect or "frame"
            return self._behind(place)
        try:
            return self._assign(name + re.sub(r"\s", "", index or ""), place)
        except UnknownValue:
            self.out.assigned.append((name, ""))
            return self._behind(place)

    def _stated_mode(self, name: str, mode: str, start: int, place: int, inner: int) -> int:
        """X=AC(5), X=IC(5), I=AC(5)."""
        letter = name
        if name in INCREMENTS:
            letter = INCREMENTS[name] if mode == "IC" else POSITIONS[name]
        elif name in ("I", "J", "K") and mode == "AC":
            letter = name.lower()
        elif name == "AP" and mode in ANGLES:
            letter = ANGLES[mode]
        elif name in ADDRESSES:
            letter = ADDRESSES[name]
        strange = letter != name and letter in "lmnRhq" and mode != "AC"
        if strange:
            self.out.reasons.append(phrase("{}={}() is not followed", name, mode))
        end = self._value(letter, start, inner, f"{name}={mode}(")
        closed = re.compile(r"\s*\)").match(self.text, end)
        if closed is None:
            raise self._malformed(start)
        piece = self.out.pieces[-1]
        value = math.nan if strange and letter in "hq" else piece.value
        self.out.pieces[-1] = Piece(letter, value, start, closed.end(), piece.before, ")", piece.expression)
        return closed.end()

    def _computed(self, found: re.Match[str]) -> int:
        """A letter with a variable or a bracket behind it."""
        letter = found.group(1)
        if letter in "OG" or self.text[found.end() : found.end() + 1] == "<":
            self._steers(found.start(), phrase("{} is computed by a macro expression", letter))
            return len(self.text)
        return self._value(letter, found.start(), found.end(), letter, factor=True)

    def _keyword(self, found: re.Match[str]) -> int:
        text, out = self.text, self.out
        token, place = found.group(), found.start()
        if token.endswith(":"):
            out.label = token[:-1]
            return found.end()
        if len(token.rstrip("0123456789")) < 3 and token not in _SHORT and not (place == 0 and len(token) > 3):
            raise self._malformed(place)
        if token in ("BEGIN", "TOOL", "BLK"):
            raise FormatError(
                phrase("a plain-language block among ISO code; write the program in one of both languages"),
                self.name,
                self.line + 1,
            )
        if token in _MOTIONS:
            out.pieces.append(Piece("G", _MOTIONS[token], place, found.end(), token))
            return found.end()
        if token in ("TRANS", "ATRANS"):
            code = SHIFT if token == "TRANS" else SHIFT_MORE
            out.pieces.append(Piece("G", code, place, found.end(), token))
            return found.end()
        if token in _FRAMES:
            bare = not text[found.end() :].strip() and not token.startswith("A")
            out.pieces.append(Piece("G", NEW_FRAME if bare else OTHER_FRAME, place, found.end(), token))
            return found.end() if bare else len(text)
        if token == "MCALL":
            code = MODAL_CALL if text[found.end() :].strip() else MODAL_CALL_OFF
            out.pieces.append(Piece("G", code, place, found.end(), token))
            return len(text)
        if token in ("SUPA", "G153"):
            # Siemens' ways to say G53.
            out.pieces.append(Piece("G", 53.0, place, found.end(), token))
            return found.end()
        if token in _QUIET:
            if token in ("PROC", "EXTERN", "WORKPIECE"):
                return len(text)
            if token == "DEF":
                return self._definition(found.end())
            return self._behind_bracket(found.end())
        if token == "CYCLE800":
            code = SWIVEL if self._swivels(found.end()) else SWIVEL_OFF
            out.pieces.append(Piece("G", code, place, found.end(), token))
        if token == "M17" or token in ("RET", "RTS"):
            self._steers(place, phrase("the program returns"))
            return len(text)
        self._steers(place, phrase("{} is not plain ISO code", token), "call" if token.startswith(_CALLS) else "flow")
        return len(text)

    def _swivels(self, place: int) -> bool:
        """Whether a CYCLE800 whose arguments begin here shifts or turns: from the fifth to the thirteenth."""
        found = re.compile(r"\s*\((.*)\)").match(self.text, place)
        arguments = found[1].split(",") if found else []
        return any(not re.fullmatch(r"[+-]?0*\.?0*", argument.strip()) for argument in arguments[4:13])

    def _definition(self, place: int) -> int:
        """DEF REAL DEPTH=5, N: names with their first values."""
        found = re.compile(r"\s*(?:REAL|INT|BOOL)\s+").match(self.text, place)
        if found is None:
            return len(self.text)
        for part in re.split(r",(?![^\[(]*[\])])", self.text[found.end() :]):
            target, _, value = part.partition("=")
            if re.fullmatch(r"\s*[A-Z_][A-Z_0-9]*\s*", target):
                self.out.assigned.append((target.strip(), value.strip() or "0"))
        return len(self.text)

    def _steers(self, place: int, reason: str, effect: str = "flow") -> None:
        self.out.flow = self.text[place:].strip()
        self.out.reasons.append(reason)
        self.out.effect = effect

    def _behind_bracket(self, place: int) -> int:
        """Place behind a bracket that opens here."""
        found = re.compile(r"\s*\(").match(self.text, place)
        if found is None:
            return place
        depth = 0
        for i in range(found.end() - 1, len(self.text)):
            depth += (self.text[i] == "(") - (self.text[i] == ")")
            if depth == 0:
                return i + 1
        return len(self.text)

    def _behind(self, place: int) -> int:
        """Place behind an assigned value: up to the next blank outside brackets."""
        depth = 0
        while place < len(self.text) and (depth or self.text[place] not in " \t"):
            depth += (self.text[place] in "([") - (self.text[place] in ")]")
            place += 1
        return place


def _constant(source: str) -> tuple[float, str]:
    """Value and expression of what is assigned: a number is no expression."""
    try:
        value, _ = evaluate(source, 0, {})
    except UnknownValue:
        return math.nan, source
    return (value, "") if abs(value) <= LARGEST else (math.nan, source)


def malformed(rest: str) -> str:
    """What is wrong with a text that is no word."""
    shown = rest[:20].encode("ascii", "replace").decode()
    if re.match(r"L\s*\d+,\d+\s*\*?\s*$", rest):
        return phrase(
            "'{}' calls a label as HEIDENHAIN's ISO programs do: let the program begin with %NAME G71 or G70", shown
        )
    if re.match(r"[A-Z]\s*[+-]?\s*\d+,\d", rest):
        return phrase("decimal comma in '{}': write numbers with a decimal point", shown)
    if rest.startswith("("):
        return phrase("comment without ')': close it on the same line")
    if rest[0].isascii() and rest[0].isalpha():
        return phrase("'{}' is not a word: a letter needs one number behind it", shown)
    return phrase("cannot read '{}': is this an NC program?", shown)
