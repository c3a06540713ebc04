# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q parameters whose value is known on reading: FN functions and formulas, angles in degrees."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

_TOKEN = re.compile(r"[ \t]*(?:(\d+(?:[.,]\d*)?|[.,]\d+)|(Q[LR]?\d+)|([A-Z]+)|([-+*/^()%=<>]))")
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda v: math.sin(math.radians(v)),
    "COS": lambda v: math.cos(math.radians(v)),
    "TAN": lambda v: math.tan(math.radians(v)),
    "ASIN": lambda v: math.degrees(math.asin(v)),
    "ACOS": lambda v: math.degrees(math.acos(v)),
    "ATAN": lambda v: math.degrees(math.atan(v)),
    "SQRT": math.sqrt,
    "SQ": lambda v: v * v,
    "LN": math.log,
    "LOG": math.log10,
    "EXP": math.exp,
    "NEG": lambda v: -v,
    "INT": lambda v: float(math.trunc(v)),
    "FRAC": lambda v: v - math.trunc(v),
    "ABS": abs,
    "SGN": lambda v: float((v > 0) - (v < 0)),
}
_COMPARED: dict[str, Callable[[float, float], bool]] = {
    "9": lambda a, b: a == b,
    "10": lambda a, b: a != b,
    "11": lambda a, b: a > b,
    "12": lambda a, b: a < b,
}
_OPERAND = r"[ \t]*([-+]?[ \t]*(?:Q[LR]?\d+|\d+(?:[.,]\d*)?|[.,]\d+))"
_ASSIGNED = re.compile(r"FN[ \t]*(\d+)[ \t]*:[ \t]*(Q[LR]?\d+)[ \t]*=(.*)", re.DOTALL)
_JUMP = re.compile(
    r"FN[ \t]*(\d+)[ \t]*:[ \t]*IF" + _OPERAND + r"[ \t]+(EQU|NE|GT|LT)" + _OPERAND + r"[ \t]+GOTO[ \t]+LBL(.*)"
)
_OPERATORS = {"1": r"\+", "2": "-", "3": r"\*", "4": "(?:DIV|/)", "8": "LEN", "13": "ANG"}
_SINGLE = {"0": "", "5": "SQRT", "6": "SIN", "7": "COS"}
_FORMULA = re.compile(r"(Q[LR]?\d+)[ \t]*=(.*)", re.DOTALL)
_IN_CYCLE = re.compile(r"(Q\d+)[ \t]*=[ \t]*([-+]?[ \t]*(?:Q[LR]?\d+|\d+(?:[.,]\d*)?|[.,]\d+))")
_SILENT = ("14", "15", "16", "19", "20", "26", "27", "29", "37", "38")
"""Messages, prints and tables: they set nothing that a path comes from."""


class Parameters:
    """Values by name; a name that is not here has a value that only the control knows.

    Parameters
    ----------
    values : dict of str to float
    origin : dict of str to int
        Line, from 0, where each name was last set.
    """

    def __init__(self) -> None:
        self.values: dict[str, float] = {}
        self.origin: dict[str, int] = {}

    def copy(self) -> Parameters:
        """The same values, to look ahead with."""
        out = Parameters()
        out.values, out.origin = dict(self.values), dict(self.origin)
        return out

    def number(self, text: str) -> float:
        """Value of a number or parameter with its sign; NaN where it is not known."""
        if "Q" not in text:
            return float(text.replace(" ", "").replace(",", "."))
        sign = -1.0 if text.startswith("-") else 1.0
        return sign * self.values.get(text.lstrip("+- \t"), math.nan)

    def put(self, name: str, value: float, line: int) -> None:
        """Set a parameter; to a value that is not known, too."""
        self.origin[name] = line
        if math.isfinite(value):
            self.values[name] = value
        else:
            self.values.pop(name, None)

    def forget(self) -> None:
        """What called something that may set any of them leaves behind."""
        self.values.clear()

    def carry_out(self, text: str, line: int) -> bool:
        """Carry out an FN function or a formula; False for one that may do anything.

        What reads something of the control (FN 18) leaves its parameter unknown; jumps and messages set nothing.
        """
        if self.assign(text, line) or self.jump(text) is not None or self._silent(text):
            return True
        read = re.findall(r"(Q[LR]?\d+)[ \t]*=", text)
        for name in read:
            self.put(name, math.nan, line)
        return bool(read)

    def assign(self, text: str, line: int) -> bool:
        """Carry out `FN 0: Q1 = +5` or `Q1 = SIN Q2 * 10`; False where it is none of these.

        Parameters
        ----------
        text : str
            The block, upper case, without number and comment.
        line : int
            Its line, from 0.
        """
        found = _ASSIGNED.match(text)
        if found is None:
            formula = _FORMULA.match(text)
            if formula is None:
                return False
            self.put(formula[1], self._formula(formula[2]), line)
            return True
        number, name, right = found.groups()
        self.put(name, self._function(str(int(number)), right.strip()), line)
        return True

    def _function(self, number: str, right: str) -> float:
        if number in _SINGLE:
            one = re.fullmatch((_SINGLE[number] and rf"{_SINGLE[number]}\b") + _OPERAND, right)
            if one is None:
                return math.nan
            value = self.number(one[1])
            return _calculated(_FUNCTIONS[_SINGLE[number]], value) if _SINGLE[number] else value
        if number not in _OPERATORS:
            return math.nan
        two = re.fullmatch(_OPERAND + r"[ \t]*" + _OPERATORS[number] + _OPERAND, right)
        if two is None:
            return math.nan
        a, b = self.number(two[1]), self.number(two[2])
        return _calculated(
            {
                "1": lambda v: v + b,
                "2": lambda v: v - b,
                "3": lambda v: v * b,
                "4": lambda v: v / b,
                "8": lambda v: math.hypot(v, b),
                "13": lambda v: math.degrees(math.atan2(v, b)) % 360.0,
            }[number],
            a,
        )

    def in_cycle(self, text: str, line: int) -> None:
        """Parameters that the definition of a cycle sets."""
        for found in _IN_CYCLE.finditer(text):
            self.put(found[1], self.number(found[2].replace(" ", "")), line)

    def jump(self, text: str) -> tuple[str, bool | None] | None:
        """Label and outcome of `FN 9: IF +Q1 EQU +0 GOTO LBL 1`, None for one that is not known; None for no jump."""
        found = _JUMP.match(text)
        if found is None:
            return None
        number = str(int(found[1]))
        a, b = (self.number(found[k].replace(" ", "")) for k in (2, 4))
        if number not in _COMPARED or math.isnan(a + b):
            return found[5].strip(), None
        return found[5].strip(), _COMPARED[number](a, b)

    @staticmethod
    def _silent(text: str) -> bool:
        """Whether an FN function sets nothing: messages, prints."""
        found = re.match(r"FN[ \t]*(\d+)", text)
        return found is not None and str(int(found[1])) in _SILENT

    def _formula(self, text: str) -> float:
        """Value of a formula; NaN where it is not known."""
        tokens: list[str] = []
        place = 0
        while place < len(text.rstrip()):
            found = _TOKEN.match(text, place)
            if found is None:
                return math.nan
            tokens.append(found.group().strip().replace(",", "."))
            place = found.end()
        try:
            value, rest = self._sum(tokens)
        except (ArithmeticError, ValueError, IndexError):
            return math.nan
        return value if not rest else math.nan

    def _sum(self, tokens: list[str]) -> tuple[float, list[str]]:
        value, tokens = self._product(tokens)
        while tokens and tokens[0] in "+-":
            sign = 1.0 if tokens[0] == "+" else -1.0
            more, tokens = self._product(tokens[1:])
            value += sign * more
        return value, tokens

    def _product(self, tokens: list[str]) -> tuple[float, list[str]]:
        value, tokens = self._power(tokens)
        while tokens and tokens[0] in ("*", "/", "%"):
            operator = tokens[0]
            more, tokens = self._power(tokens[1:])
            value = value * more if operator == "*" else value / more if operator == "/" else math.fmod(value, more)
        return value, tokens

    def _power(self, tokens: list[str]) -> tuple[float, list[str]]:
        value, tokens = self._unary(tokens)
        while tokens and tokens[0] == "^":
            more, tokens = self._unary(tokens[1:])
            value = math.pow(value, more)
        return value, tokens

    def _unary(self, tokens: list[str]) -> tuple[float, list[str]]:
        token = tokens[0]
        if token in ("+", "-"):
            value, rest = self._unary(tokens[1:])
            return (value if token == "+" else -value), rest
        if token == "(":
            value, rest = self._sum(tokens[1:])
            if rest[0] != ")":
                raise ValueError(token)
            return value, rest[1:]
        if token == "PI":
            return math.pi, tokens[1:]
        if token in _FUNCTIONS:
            value, rest = self._unary(tokens[1:])
            return _FUNCTIONS[token](value), rest
        return self.number(token), tokens[1:]


def _calculated(function: Callable[[float], float], value: float) -> float:
    try:
        return function(value)
    except (ArithmeticError, ValueError):
        return math.nan
