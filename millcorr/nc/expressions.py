# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions of NC programs: variables of all families, arithmetic, functions, comparisons.

Fanuc, Haas, Mazak and LinuxCNC write `#1`, `#<name>` and brackets; Siemens `R1`, names and parentheses; Okuma `VC1`
and names. Where controls give different values of one expression it has none here.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping

from millcorr.messages import phrase


class UnknownValue(Exception):
    """A value that only the control knows; says which."""


Variables = Mapping[str, float]

_NUMBER = re.compile(r"[0-9]+(?:\.[0-9]*)?|\.[0-9]+")
_NAME = re.compile(r"\$?[A-Z_][A-Z_0-9]*")
_NAMED = re.compile(r"#<\s*([^>]*?)\s*>")
_OPERATORS = (
    (("OR", "XOR"),),
    (("AND",),),
    (("==", "<>", ">=", "<=", ">", "<", "EQ", "NE", "GE", "LE", "GT", "LT"),),
    (("+", "-"),),
    (("*", "/", "MOD", "DIV"),),
    (("**",),),
)
_DEEPEST = 60
"""Brackets within brackets beyond this are no expression of a part program."""


def _whole(value: float, up: bool) -> float:
    if value < 0 and value != math.floor(value):
        raise UnknownValue(phrase("controls round numbers below zero differently"))
    return float(math.ceil(value) if up else math.floor(value))


_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda v: math.sin(math.radians(v)),
    "COS": lambda v: math.cos(math.radians(v)),
    "TAN": lambda v: math.tan(math.radians(v)),
    "ASIN": lambda v: math.degrees(math.asin(v)),
    "ACOS": lambda v: math.degrees(math.acos(v)),
    "SQRT": math.sqrt,
    "SQR": math.sqrt,
    "ABS": abs,
    "EXP": math.exp,
    "LN": math.log,
    "POT": lambda v: v * v,
    "ROUND": lambda v: math.copysign(math.floor(abs(v) + 0.5), v),
    "TRUNC": lambda v: float(math.trunc(v)),
    "FIX": lambda v: _whole(v, up=False),
    "FUP": lambda v: _whole(v, up=True),
}


def evaluate(text: str, place: int, variables: Variables | None) -> tuple[float, int]:
    """Value of the expression that begins at a place, and the place behind it.

    Parameters
    ----------
    text : str
        Upper case, without comments.
    place : int
        Where the expression begins.
    variables : mapping, optional
        Values by name: `#1`, `#<NAME>`, `R1`, `VC1`, names. Without it nothing is computed: the value is NaN.

    Returns
    -------
    float
    int

    Raises
    ------
    UnknownValue
        If the value is not known, or there is no expression.

    Examples
    --------
    >>> evaluate("[#1+2]*3 X5", 0, {"#1": 4.0})
    (18.0, 8)
    """
    return _Parser(text, place, variables).run(lambda p: p.binary(0))


def evaluate_factor(text: str, place: int, variables: Variables | None) -> tuple[float, int]:
    """Value of a sign and one number, variable or bracket, as behind an address letter; see `evaluate`."""
    return _Parser(text, place, variables).run(lambda p: p.unary())


def variable(text: str, place: int, variables: Variables | None) -> tuple[str, int]:
    """Name of the variable that stands at a place, and the place behind it; "" where its index is not known."""
    parser = _Parser(text, place, variables)
    name = parser.variable()
    return name, parser.place


class _Parser:
    """One pass over one expression."""

    def __init__(self, text: str, place: int, variables: Variables | None) -> None:
        self.text = text
        self.place = place
        self.variables = variables
        self.depth = 0

    def run(self, rule: Callable[[_Parser], float]) -> tuple[float, int]:
        try:
            value = rule(self)
        except (ArithmeticError, ValueError):
            if self.variables is not None:
                raise UnknownValue(phrase("'{}' has no value", self.text.strip()[:40])) from None
            value = math.nan
        if self.variables is not None and not math.isfinite(value):
            raise UnknownValue(phrase("'{}' has no value", self.text.strip()[:40]))
        return value, self.place

    def skip(self) -> None:
        while self.place < len(self.text) and self.text[self.place] in " \t":
            self.place += 1

    def take(self, *signs: str) -> str:
        """Sign or keyword that comes next, if it is one of these."""
        self.skip()
        for sign in signs:
            if not self.text.startswith(sign, self.place):
                continue
            end = self.place + len(sign)
            if sign[0].isalpha() and end < len(self.text) and self.text[end].isalpha():
                continue
            if sign == "*" and self.text.startswith("**", self.place):
                continue
            self.place = end
            return sign
        return ""

    def binary(self, level: int) -> float:
        if level == len(_OPERATORS):
            return self.unary()
        value = self.binary(level + 1)
        while sign := self.take(*_OPERATORS[level][0]):
            value = self._apply(sign, value, self.binary(level + 1))
        return value

    def _apply(self, sign: str, a: float, b: float) -> float:
        if self.variables is None:
            return math.nan
        if sign in ("MOD", "DIV") and (a < 0 or b <= 0):
            raise UnknownValue(phrase("controls divide numbers below zero differently"))
        if sign in ("AND", "OR", "XOR") and not {a, b} <= {0.0, 1.0}:
            raise UnknownValue(phrase("{} of bits is not computed", sign))
        same = abs(a - b) < 1e-9
        values: dict[str, Callable[[], float]] = {
            "+": lambda: a + b,
            "-": lambda: a - b,
            "*": lambda: a * b,
            "/": lambda: a / b,
            "**": lambda: float(a**b),
            "MOD": lambda: math.fmod(a, b),
            "DIV": lambda: float(a // b),
            "AND": lambda: a * b,
            "OR": lambda: max(a, b),
            "XOR": lambda: float(a != b),
            "EQ": lambda: float(same),
            "NE": lambda: float(not same),
            "GT": lambda: float(a > b and not same),
            "LT": lambda: float(a < b and not same),
            "GE": lambda: float(a > b or same),
            "LE": lambda: float(a < b or same),
        }
        words = {"==": "EQ", "<>": "NE", ">": "GT", "<": "LT", ">=": "GE", "<=": "LE"}
        return values[words.get(sign, sign)]()

    def unary(self) -> float:
        sign = self.take("-", "+", "NOT")
        if sign == "NOT":
            return float(not self.unary())
        value = self.primary() if not sign else self.unary()
        return -value if sign == "-" else value

    def primary(self) -> float:
        self.skip()
        self.depth += 1
        if self.depth > _DEEPEST or self.place >= len(self.text):
            raise UnknownValue(phrase("an expression is not complete"))
        found = _NUMBER.match(self.text, self.place)
        if found:
            self.place = found.end()
            value = float(found.group())
        elif self.text[self.place] in "[(":
            value = self.bracket()
        else:
            value = self._named()
        self.depth -= 1
        return value

    def bracket(self) -> float:
        """Value between brackets of either kind."""
        opening = self.take("[", "(")
        if not opening:
            raise UnknownValue(phrase("a bracket is missing"))
        value = self.binary(0)
        if not self.take("]" if opening == "[" else ")"):
            raise UnknownValue(phrase("a bracket is not closed"))
        return value

    def _named(self) -> float:
        """Value of a function or a variable."""
        found = _NAME.match(self.text, self.place)
        name = found.group() if found else ""
        if found and self.text[found.end() : found.end() + 1] in ("[", "(") and len(name) > 1:
            if name in _FUNCTIONS:
                self.place = found.end()
                value = self.bracket()
                return value if self.variables is None else float(_FUNCTIONS[name](value))
            if name in ("ATAN", "ATAN2"):
                return self._arc_tangent(found.end())
        key = self.variable()
        if self.variables is None:
            return math.nan
        if key not in self.variables:
            raise UnknownValue(phrase("{} has no value that this program sets", key or phrase("a variable")))
        return self.variables[key]

    def _arc_tangent(self, place: int) -> float:
        """ATAN[a]/[b], ATAN2(a, b)."""
        self.place = place
        opening = self.take("[", "(")
        a = self.binary(0)
        if self.take(","):
            b = self.binary(0)
            closed = self.take("]" if opening == "[" else ")")
        else:
            closed = self.take("]" if opening == "[" else ")")
            if not self.take("/"):
                raise UnknownValue(phrase("ATAN of one number is not computed"))
            b = self.bracket()
        if not closed:
            raise UnknownValue(phrase("a bracket is not closed"))
        value = math.degrees(math.atan2(a, b))
        if self.variables is not None and value < 0:
            raise UnknownValue(phrase("controls give arc tangents below zero differently"))
        return value

    def variable(self) -> str:
        """Name of the variable that comes next; "" where its index is not known."""
        self.skip()
        named = _NAMED.match(self.text, self.place)
        if named:
            self.place = named.end()
            return "#<" + re.sub(r"\s", "", named.group(1)) + ">"
        if self.text.startswith("#", self.place):
            self.place += 1
            return self._indexed("#")
        found = _NAME.match(self.text, self.place)
        if not found:
            raise UnknownValue(phrase("'{}' is no value", self.text[self.place :].strip()[:20]))
        self.place = found.end()
        name = found.group()
        if self.text[self.place : self.place + 1] in ("[", "(") and (name in ("R", "VC", "V", "Q") or name[0] == "$"):
            return self._indexed(name)
        return re.sub(r"^(R|VC|Q)0+(?=\d)", r"\1", name)

    def _indexed(self, kind: str) -> str:
        found = _NUMBER.match(self.text, self.place)
        if found:
            self.place = found.end()
            return f"{kind}{int(float(found.group()))}"
        index = self.unary()
        if self.variables is None or index != math.floor(index):
            return ""
        return f"{kind}{int(index)}"
