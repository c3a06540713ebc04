# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's lines in the order in which they run, in words of one letter: the second reader's own interpreter.

It shares no code with `millcorr.nc`. What decides the order and what a word's number is are found by patterns, and
computed by Python's own parser. Where either is not known the lines go on as they stand.
"""

from __future__ import annotations

import ast
import bisect
import math
import operator
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Ints

ADDRESS = {
    name: bytes([0xC0 + k]).decode("latin-1")
    for k, name in enumerate(
        "X=IC Y=IC Z=IC X=AC Y=AC Z=AC I=AC J=AC K=AC RND CHR CHF ANG AR TURN I1 J1 K1 FRAME ARC RNDM "
        "AP AP=AC AP=IC RP RP=IC POLE PX PY FRC FRCM".split()
    )
}
"""Letters, beyond those of ASCII, that stand for addresses of several."""
_FRAMES = {
    "TRANS": 0,
    "ATRANS": 1,
    "ROT": 2,
    "AROT": 2,
    "MIRROR": 2,
    "AMIRROR": 2,
    "SCALE": 2,
    "ASCALE": 2,
    "ROTS": 2,
    "MCALL": 2,
}
_FAR = 5_000_000
_FUNCTIONSS = 500_000
_DEEP = 32

_SIGNS = (b"=", b"#", b"[", b",")
_CALL = re.compile(rb"M[ \t]*0*(?:9[78]|198|17)(?!\d)")
_BARE_CALL = re.compile(rb"(?m)L[ \t]*\d+[ \t]*(?:P[ \t]*\d+[ \t]*)?\r?$")
_STEERING = re.compile(
    r"[=#\[,]|[A-Z_]{2}|M\s*0*(?:2|30|9[789]|198|17)(?![\d.])|G\s*6[56](?!\d)|^\s*(?:N\s*\d+\s*)?[OL:]|^\s*%"
)
_CALLING = re.compile(r"M\s*0*(?:97|98|198)(?![\d.])")
_TEXT = re.compile(rb'\([^()\r\n]*\)|;[^\r\n]*|"[^"\r\n]*"')
_STEERS = re.compile(
    r"(?:IF|WHILE|GOTO\w?|FOR|REPEATB?|CALL|DEF|PROC|EXTERN|MSG|DO|LOOP|SUB|ELSE\w*|END\w+|CASE|RETURN|UNTIL|BEGIN"
    r"|TOOL[ \t]+(?:CALL|DEF)|BLK|BREAK|CONTINUE|A?TRANS|A?ROTS?|A?MIRROR|A?SCALE|WORKPIECE|CYCLE\d*|SUPA)\b"
)
_HEAD = re.compile(r"\s*(?:N\s*\d+\s*)?(?:[O:]\s*(\d+)|O([A-Z]\w*)|%_N_(\w+?)_[MS]PF)\s*$")
_ATOM = re.compile(r"[-+\s]*(?:NOT\b\s*)?(?:#\s*<[^>]*>|#+\s*\d+|#+(?=\[)|\d+\.?\d*|\.\d+|\$?[A-Z_]\w*|(?=[\[(]))\s*")
_OPERATOR = re.compile(r"\s*(?:\*\*|==|<>|[<>]=?|[-+*/]|(?:MOD|DIV|AND|OR|XOR|EQ|NE|GE|LE|GT|LT)(?![A-Z]))")
_WORDS_OF_PYTHON = {
    "EQ": "==", "NE": "!=", "GE": ">=", "LE": "<=", "GT": ">", "LT": "<", "<>": "!=",
    "AND": " and ", "OR": " or ", "MOD": "%", "DIV": "//", "NOT": " not ", "XOR": "!=",
}  # fmt: skip
_LEXEME = re.compile(
    r"(?:MOD|DIV|AND|OR|XOR|EQ|NE|GE|LE|GT|LT|NOT)(?![A-Z_])|#\s*<[^>]*>|#+\s*\d+|#|\d+\.?\d*|\.\d+|\$?[A-Z_]\w*(?=\s*[\[(])|\$?[A-Z_]\w*|\*\*|==|<>|>=|<=|[-+*/<>()\[\],]"
)
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda a: math.sin(math.radians(a)),
    "COS": lambda a: math.cos(math.radians(a)),
    "TAN": lambda a: math.tan(math.radians(a)),
    "ASIN": lambda a: math.degrees(math.asin(a)),
    "ACOS": lambda a: math.degrees(math.acos(a)),
    "SQRT": math.sqrt,
    "SQR": math.sqrt,
    "ABS": abs,
    "EXP": math.exp,
    "LN": math.log,
    "POT": lambda a: a * a,
    "TRUNC": math.trunc,
    "ROUND": lambda a: math.copysign(math.floor(abs(a) + 0.5), a),
    "FIX": math.floor,
    "FUP": math.ceil,
}
_ARITHMETIC: dict[type, Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Mod: operator.mod,
    ast.FloorDiv: operator.floordiv,
    ast.Pow: operator.pow,
}


class _Unknown(Exception):
    """What only the control knows."""


@dataclass(frozen=True, eq=False, slots=True)
class Unrolled:
    """A text as it runs.

    Parameters
    ----------
    raw : tuple of bytes
        The line of every block as it stands, with its ending.
    plain : tuple of bytes
        The same in words of one letter with numbers, in capitals; see `ADDRESS`.
    line : (blocks,) int64
        Index of the line of every block; lines of files beside the program count on behind its own.
    """

    raw: tuple[bytes, ...]
    plain: tuple[bytes, ...]
    line: Ints


def unrolled(data: bytes, starts: Ints, beside: Sequence[tuple[str, bytes]] = ()) -> Unrolled | None:
    """A text as it runs; None where it runs as it stands, in plain words.

    Parameters
    ----------
    data : bytes
    starts : (lines + 1,) int64
        Offset of every line, and the length of the text.
    beside : sequence of (str, bytes)
        Names and texts of files that hold subprograms.
    """
    upper = data.upper()
    if _plain(upper) or _plain(_TEXT.sub(b"", upper)):
        return None
    lines = [data[a:b] for a, b in zip(starts[:-1].tolist(), starts[1:].tolist(), strict=True)]
    return _Machine(lines, beside).run()


def _plain(text: bytes) -> bool:
    """Whether a text in capitals holds letters with numbers only, and calls nothing."""
    if any(sign in text for sign in _SIGNS) or _CALL.search(text) or (b"L" in text and _BARE_CALL.search(text)):
        return False
    letter = np.frombuffer(text, np.uint8) - np.uint8(ord("A")) < 26
    return not (letter[1:] & letter[:-1]).any()


# -- numbers --------------------------------------------------------------------------------------------------


def _closing(text: str, place: int) -> int:
    """Place behind the bracket that opens at one."""
    depth = 0
    for k in range(place, len(text)):
        depth += (text[k] in "[(") - (text[k] in "])")
        if not depth:
            return k + 1
    return len(text)


def _atom(text: str, place: int) -> int:
    """Place behind one value: a number, a variable, a function, a bracket."""
    found = _ATOM.match(text, place)
    if found is None:
        return place
    end = found.end()
    if end < len(text) and text[end] in "[(":
        end = _closing(text, end)
        rest = re.compile(r"\s*/\s*(?=[\[(])").match(text, end)
        if found.group().strip() == "ATAN" and rest:
            end = _closing(text, rest.end())
    return end


def _expression(text: str, place: int) -> int:
    """Place behind a row of values."""
    end = _atom(text, place)
    while found := _OPERATOR.match(text, end):
        further = _atom(text, found.end())
        if further == found.end():
            break
        end = further
    return end


def _value(text: str, known: dict[str, float]) -> float:
    """Number that a text gives with what is known."""
    out = []
    for found in _LEXEME.finditer(text):
        token = found.group()
        if token[0] in "[]":
            out.append("(" if token == "[" else ")")
        elif token in _WORDS_OF_PYTHON:
            out.append(_WORDS_OF_PYTHON[token])
        elif token[0].isdigit() or token[0] == ".":
            out.append(repr(float(token)))
        elif token[0] == "#" or token[0] == "$" or token[0].isalpha() or token[0] == "_":
            called = text[found.end() :].lstrip()[:1] in ("(", "[") or token == "#"
            name = re.sub(r"\s|(?<=[A-Z#])0+(?=\d)", "", token)
            out.append(f"f({name!r})" if called else f"v({name!r})")
        else:
            out.append(token)
    try:
        tree = ast.parse("".join(out).strip(), mode="eval").body
        number = float(_node(tree, known))
    except (SyntaxError, ArithmeticError, ValueError, TypeError, RecursionError) as error:
        raise _Unknown(text) from error
    if not math.isfinite(number):
        raise _Unknown(text)
    return number


def _node(node: ast.expr, known: dict[str, float]) -> float:
    if isinstance(node, ast.Constant) and isinstance(node.value, float):
        return node.value
    if isinstance(node, ast.UnaryOp):
        a = _node(node.operand, known)
        return -a if isinstance(node.op, ast.USub) else float(not a) if isinstance(node.op, ast.Not) else a
    if isinstance(node, ast.BoolOp):
        both = [_node(n, known) for n in node.values]
        if not set(both) <= {0.0, 1.0}:
            raise _Unknown("bits")
        return float(all(both)) if isinstance(node.op, ast.And) else float(any(both))
    if isinstance(node, ast.Compare) and len(node.ops) == 1:
        a, b = _node(node.left, known), _node(node.comparators[0], known)
        near, sign = abs(a - b) < 1e-9, type(node.ops[0])
        answers = {ast.Eq: near, ast.NotEq: not near, ast.Lt: a < b and not near, ast.Gt: a > b and not near}
        return float(answers.get(sign, (a < b or near) if sign is ast.LtE else (a > b or near)))
    if isinstance(node, ast.BinOp) and type(node.op) in _ARITHMETIC:
        name, given = _called(node.left)
        if name == "ATAN" and len(given) == 1 and isinstance(node.op, ast.Div):
            return _degrees(_node(given[0], known), _node(node.right, known))
        a, b = _node(node.left, known), _node(node.right, known)
        if isinstance(node.op, ast.Mod | ast.FloorDiv) and (a < 0 or b <= 0):
            raise _Unknown("MOD")
        return float(_ARITHMETIC[type(node.op)](a, b))
    name, inner = _called(node)
    if name == "#" or name in ("R", "VC", "V", "Q"):
        index = _node(inner[0], known)
        return _known(f"{name}{int(index)}", known)
    if name in ("ATAN", "ATAN2") and len(inner) == 2:
        return _degrees(*(_node(n, known) for n in inner))
    if name in _FUNCTIONS and len(inner) == 1:
        a = _node(inner[0], known)
        if name in ("FIX", "FUP") and a < 0 and a != math.floor(a):
            raise _Unknown(name)
        return float(_FUNCTIONS[name](a))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "v":
        return _known(str(ast.literal_eval(node.args[0])), known)
    raise _Unknown("no value")


def _called(node: ast.expr) -> tuple[str, list[ast.expr]]:
    """Name and arguments of a function: f('SIN')(...)."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Call):
        return str(ast.literal_eval(node.func.args[0])), node.args
    return "", []


def _known(name: str, known: dict[str, float]) -> float:
    if name not in known:
        raise _Unknown(name)
    return known[name]


def _degrees(a: float, b: float) -> float:
    if a < 0:
        raise _Unknown("ATAN")
    return math.degrees(math.atan2(a, b))


# -- lines ----------------------------------------------------------------------------------------------------


def _bare(raw: bytes) -> tuple[str, str]:
    """A line in capitals without its comments and texts, and these."""
    text = raw.removeprefix(b"\xef\xbb\xbf").decode("latin-1").rstrip("\r\n\x1a \t")
    text = "".join(c.upper() if c.isascii() else c for c in text)
    out, said, k = "", "", 0
    depth = 0
    while k < len(text):
        c = text[k]
        if c == ";":
            said += text[k:]
            break
        if c == '"':
            end = text.find('"', k + 1) + 1 or len(text)
            keep = re.search(r"(?:T\d*\s*=?|CALL)\s*$", out)
            out += text[k:end] if keep else ""
            said += "" if keep else text[k:end]
            k = end
            continue
        if c == "(" and not depth and not _computes(out):
            end = text.find(")", k) + 1 or len(text)
            said += text[k:end]
            out += " "
            k = end
            continue
        depth += (c == "(") - (c == ")" and depth > 0)
        out += c
        k += 1
    return out, said


def _computes(before: str) -> bool:
    """Whether a parenthesis behind a text is one of an expression and no comment."""
    if re.search(r"(?:\b(?:AC|IC|DC|ACP|ACN|MSG|IF|WHILE|UNTIL|NOT|AND|OR)\s*|[=<>\[,]\s*)$", before):
        return True
    if re.search(r"[-+*/]\s*$", before) and re.search(r"=|\b(?:IF|WHILE|UNTIL)\b", before):
        return True
    word = re.search(r"[A-Z_]{2}\w*$", before)
    return bool(word) and not re.search(
        r"(?:^|[\s\d])(?:SUB|ENDSUB|CALL|ELSE|ENDIF|ENDWHILE|ENDREPEAT|DO|END\d+|DO\d+|ENDLOOP|RET|RTS)$", before
    )


_NAMED = re.compile(
    r"(?<![A-Z_#$])(?:(?P<mode>[XYZIJK]1?|[CAR]R|[AR]P)\s*=\s*(?P<how>AC|IC|DC|ACP|ACN)\s*\("
    r"|(?P<name>CR|AR|AP|RP|TURN|FRCM|FRC|RNDM|RND|CHR|CHF|ANG|[IJK]1|[XYZIJKFPQL])\s*=(?!=)"
    r"|,\s*(?P<corner>[RCA])\s*=?"
    r"|(?P<word>CIP|CT|MCALL|A?TRANS|A?ROTS?|A?MIRROR|A?SCALE|SUPA|G153)(?![A-Z_=])"
    r"|(?P<letter>[A-Z])(?=\s*[-+]?\s*(?:[\[#]|VC?\d|Q[LRS]?\d)))"
)
_PUSHED_ASIDE = re.compile(
    r"(?:MSG|SETAL|CYCLE832|WORKPIECE|COMP\w+|DYN\w+|FFW\w+|KONTT?C?|CDON|CDOF2?|SOFT|BRISK|DRIVE|STOPRE|NORM|CUT2DF?"
    r"|CFC|CFTCP|CFIN|DIAMOF|DIAM90|TRAFOOF|UPATH|SPATH|ORI\w+|FIFOCTRL|STARTFIFO|STOPFIFO|SBLO[NF]|DISPLO[NF]|SAVE"
    r"|GETTCOR|SPCO[NF]|LIMS|WALIMO[NF]|RTLIO[NF]|RPY|EULER|ACTFRAME|PAROTOF|TOROTOF)(?![A-Z_])"
)
_SET = re.compile(
    r"(?P<to>#\s*\d+|#\s*<[^>]*>|#\s*\[|(?<![A-Z_])(?:R|VC|V|Q)\d+|(?<![A-Z_])(?:R|VC)\s*\[|\$?[A-Z_]{2}\w*)"
)
_NO_VARIABLE = re.compile(
    r"CR|AR|TURN|RNDM?|CH[RF]|ANG|FRCM?|FB|S?SPOSA?|DISR|ADIS\w*|OVRA?|DL|SCC|[SMHD]\d*|AP|RP|POS\w*|OFFN"
)


def _pole(text: str) -> str:
    """A line with G110, G111 or G112: what is stated beside them is where the pole is, and no place to go to."""
    text = re.sub(r"(?<![A-Z_])G11([012])(?!\d)", ADDRESS["POLE"] + r"\1", text)
    for axis in "XY":
        text = re.sub(rf"(?<![A-Z_]){axis}(?=\s*[-+#.\d])", ADDRESS[f"P{axis}"], text)
        # X=AC(), X=IC(): a pole is relative to what its code says.
        own = ADDRESS[f"{axis}=AC"] + ADDRESS[f"{axis}=IC"]
        text = re.sub(rf"[{own}]\s*[-+#.\d]+", ADDRESS[f"P{axis}"] + "# ", text)
    return re.sub(rf"(?:(?<![A-Z_])Z|[{ADDRESS['Z=AC']}{ADDRESS['Z=IC']}])\s*[-+#.\d]+", "", text)


class _Machine:
    """A control that runs one text and moves nothing."""

    def __init__(self, lines: list[bytes], beside: Sequence[tuple[str, bytes]]) -> None:
        self.raw = lines
        self.own = len(lines)
        self.beside = list(beside)
        self.text: list[str] = []
        self.said: list[str] = []
        self.heads: dict[str, int] = {}
        self.cuts: list[int] = [0]
        self.labels: dict[str, list[int]] = {}
        self.numbers: dict[float, list[int]] = {}
        self.known: dict[str, float] = {}
        self.stack: list[tuple[int, int, int, dict[str, float] | None]] = []
        self.counts: dict[int, int] = {}
        self.came_from_end = -1
        self.blocks: list[int] = []
        self.plain: list[bytes] = []
        self.pairs: dict[int, list[int]] = {}
        self.polar = any(re.search(r"(?<![A-Z_])(?:[AR]P|[XY])\s*=", _bare(line)[0]) for line in lines if b"=" in line)
        jumps = rb"(?:GOTO|\])[ \t]*(N[A-Z]\w{0,3})(?!\w)"
        self.names = {name.decode() for line in lines for name in re.findall(jumps, line.upper())}
        """Okuma's sequence names, to which jumps go."""
        self._take(0)

    def _take(self, since: int) -> None:
        """Note what lines begin programs, carry labels, open and close loops."""
        ended = 0
        coded = False
        for i in range(since, len(self.raw)):
            bare, said = _bare(self.raw[i])
            # Okuma begins with the name of the file.
            bare = "" if i == 0 and re.fullmatch(r"\s*\$.*%", bare) else bare
            coded = coded or bool(re.search(r"(?<![A-Z_])[GM]\s*\d", bare))
            if not coded and (titled := self._untitled(i, bare)) is not None:
                bare, said = titled, said + bare[len(titled) :]
            skip = re.match(r"(\s*(?:N\s*\d+\s*)?)/[1-9]?", bare)
            if skip and self.raw[i].lstrip()[:1] in (b"/", b"N", b"n"):
                bare, said = skip.group(1) + bare[skip.end() :], said + "/"
            if (named := re.match(r"\s*(N[A-Z]\w{0,3})(?!\w)", bare)) and named[1] in self.names:
                self.labels.setdefault(named[1], []).append(i)
                bare = " " * named.end() + bare[named.end() :]
            if self.polar and re.search(r"(?<![A-Z_])G11[012](?!\d)", bare):
                bare = _pole(bare)
            self.text.append(bare)
            self.said.append(said)
            if bare.lstrip()[:1] == "%" and not re.match(r"\s*%_N_", bare) and since == 0:
                # What stands behind the second mark is no program.
                ended += 1 if ended or not any(t.strip() for t in self.text[:-1]) else 0
                if ended == 2:
                    self.text[-1] = " "
            if ended >= 2:
                self.text[-1] = ""
                continue
            if head := _HEAD.match(bare):
                name = head[1] and f"O{int(head[1])}" or head[2] and f"O{head[2]}" or head[3]
                self.heads.setdefault(str(name), i)
                self.cuts.append(i)
            if sub := re.match(r"\s*(O(?:\d+|<[^>]*>))\s*SUB\b", bare):
                self.heads.setdefault(sub[1], i)
            if number := re.match(r"\s*N\s*(\d+)", bare):
                self.numbers.setdefault(float(number[1]), []).append(i)
            if label := re.match(r"\s*(?:N\s*\d+\s*)?([A-Z_]{2}\w*):", bare):
                self.labels.setdefault(label[1], []).append(i)
        self.cuts = sorted(set(self.cuts))
        self.pairs = self._pairs()

    def _untitled(self, i: int, bare: str) -> str | None:
        """A line without the title that stands on it without brackets; None without one."""
        found = re.fullmatch(r"(\s*(?:N\s*\d+\s*)?(?:O\s*\d+(?=\s))?)\s*([A-Z0-9][A-Z0-9 ._/:+-]*)", bare.rstrip())
        if found is None or not re.search(r"[A-Z]{3}", found[2]) or _STEERS.match(found[2]):
            return None
        headed = bool(i) and bool(re.match(rb"\s*(?:%(?!_N_)|[Oo:]\s*\d)", self.raw[i - 1]))
        return found[1] if "O" in found[1] or len(found[2].split()) > 1 or headed else None

    def _pairs(self) -> dict[int, list[int]]:
        out: dict[int, list[int]] = {}
        opened: list[tuple[str, list[int]]] = []
        for i, text in enumerate(self.text):
            if not re.search(r"\b(?:WHILE|REPEAT|FOR|IF|ELSE\w*|UNTIL)\b|END|\]DO", text):
                continue
            flow = re.sub(r"^\s*N\s*\d+\s*", "", text).strip()
            word = re.match(r"(O(?:\d+|<[^>]*>))\s*(\w+)", flow)
            key, verb = (word[1], word[2]) if word else ("", "")
            if not word:
                if found := re.fullmatch(r"WHILE\s*\[.*\]\s*DO\s*(\d+)|END\s*(\d+)", flow):
                    key, verb = "D" + (found[1] or found[2]), "WHILE" if found[1] else "ENDWHILE"
                elif found := re.match(r"(?:END)?(WHILE|FOR|IF)\b|(ELSE)\b|(REPEAT)$|(UNTIL)\b", flow):
                    kind = found[1] or ("IF" if found[2] else "REPEAT")
                    opens = not flow.startswith("END") and not found[2] and not found[4]
                    if kind == "IF" and opens and re.search(r"GOTO|THEN|\]\s*N\w", flow):
                        continue
                    key, verb = kind, kind if opens else "ELSE" if found[2] else "ENDIF"
                else:
                    continue
            if verb in ("WHILE", "REPEAT", "IF", "FOR"):
                opened.append((key, [i]))
            elif verb.startswith(("ELSE", "ENDWHILE", "ENDREPEAT", "ENDIF")):
                while opened and opened[-1][0] != key:
                    opened.pop()
                if opened:
                    opened[-1][1].append(i)
                    if not verb.startswith("ELSE"):
                        group = opened.pop()[1]
                        out.update(dict.fromkeys(group, group))
        return out

    def _program(self, i: int) -> tuple[int, int]:
        place = int(np.searchsorted(self.cuts, i, side="right")) - 1
        return self.cuts[place], self.cuts[place + 1] if place + 1 < len(self.cuts) else len(self.text)

    # -- the run ----------------------------------------------------------------------------------------------

    def run(self) -> Unrolled:
        at = 0
        steer = [i for i, t in enumerate(self.text) if _STEERING.search(t)]
        rounds, known_lines = 0, len(self.text)
        while 0 <= at < len(self.text):
            if len(self.text) != known_lines:
                steer = [i for i, t in enumerate(self.text) if _STEERING.search(t)]
                known_lines = len(self.text)
            place = bisect.bisect_left(steer, at)
            stop = steer[place] if place < len(steer) else len(self.text)
            for i in range(at, stop):
                self._put(i, self.text[i])
            if stop >= len(self.text):
                break
            if stop in self.cuts and not self._may_begin(stop):
                break
            rounds += 1
            try:
                if rounds > _FUNCTIONSS or len(self.blocks) > _FAR:
                    raise _Unknown("no end")
                at = self._run_line(stop)
            except _Unknown:
                for i in self._to_the_end(stop):
                    self._put(i, self._words(i))
                break
        line = np.array(self.blocks, np.int64)
        if (line == np.arange(len(line))).all() and not any(c > len(line) for c in self.cuts):
            # What stands behind the end is part of the text.
            for i in range(len(line), self.own):
                self.blocks.append(i)
                self.plain.append(b"\n")
            line = np.array(self.blocks, np.int64)
        return Unrolled(tuple(self.raw[i] for i in self.blocks), tuple(self.plain), line)

    def _put(self, i: int, words: str) -> None:
        self.blocks.append(i)
        skip = "/" if self.said[i].endswith("/") else ""
        number = re.match(r"\s*N\s*\d+", words)
        words = words[: number.end()] + skip + words[number.end() :] if number and skip else skip + words
        # A call that is followed loses nothing.
        words = _CALLING.sub(" ", words)
        self.plain.append(f"{words} {self.said[i].removesuffix('/')}\n".encode("latin-1"))

    def _to_the_end(self, i: int) -> Iterator[int]:
        last = self._program(i)[1]
        begun = bool(self.blocks) and self.blocks[-1] == i
        for k in range(i + 1 if begun else i, last):
            yield k
            if re.search(r"M\s*0*(?:2|30|99|17)(?![\d.])", self.text[k]):
                return

    def _may_begin(self, i: int) -> bool:
        if self.stack:
            return self.stack[-1][0] == i
        earlier = [c for c in self.cuts if c < i]
        return not re.search(r"[GMXYZTS]\s*[-+]?[\d.]", "\n".join(self.text[earlier[-1] if earlier else 0 : i]))

    def _run_line(self, i: int) -> int:
        """Run a line; the line that runs next, -1 at the end."""
        text = re.sub(r"^\s*N\s*\d+\s*", "", self.text[i])
        self._put(i, self._words(i))
        self._assign(i)
        if re.search(r"G\s*6[56](?![\d.])", text):
            self.known.clear()
        if re.match(r"\s*(?:CYCLE(?!832)|POCKET|SLOT|HOLES|LONGHOLE)", text):
            return self._lost_call(i)
        code = re.findall(r"M\s*0*(2|30|99|17|97|98|198)(?![\d.=])", text)
        if self.heads.get(text.strip()) == i:
            # A program's head (Okuma's OSUB) calls nothing.
            return i + 1
        flow = self._steering_text(text)
        if flow:
            return self._steer(i, flow)
        if not code:
            return self._bare_call(i, text)
        if code[-1] in ("2", "30"):
            return -1
        p, many = (re.search(letter + r"\s*0*(\d+)", text) for letter in "PL")
        if code[-1] in ("99", "17"):
            return self._leave(i, p)
        if p is None or re.search(r"[HQ]\s*\d", text):
            return self._lost_call(i)
        times = int(many[1]) if many else 1
        if code[-1] == "97":
            return self._enter(self._line_number(float(p[1]), i), i + 1, times)
        name = f"O{int(p[1])}"
        if many is None and int(p[1]) > 9999 and self._where(name) is None:
            times, name = max(int(p[1]) // 10000, 1), f"O{int(p[1]) % 10000}"
        return self._call(name, i, times)

    def _bare_call(self, i: int, text: str) -> int:
        found = re.fullmatch(r"\s*L\s*0*(\d+)\s*(?:P\s*(\d+)\s*)?", text)
        return self._call(f"L{found[1]}", i, int(found[2] or 1)) if found else i + 1

    def _call(self, name: str, i: int, times: int) -> int:
        begin = self._where(name)
        return self._lost_call(i) if begin is None else self._enter(begin, i + 1, times)

    def _where(self, name: str) -> int | None:
        for k, (path, data) in enumerate(self.beside):
            stem = re.sub(r"\.[^.]*$", "", re.split(r"[/\\]", path)[-1]).upper()
            if name not in self.heads and re.sub(r"^([OL]?)0+(?=\d)", r"\1", stem) in (
                name,
                re.sub(r"^O(?=\d)", "", name),
            ):
                del self.beside[k]
                since = len(self.raw)
                ends = re.split(rb"(?<=\n)" if b"\n" in data else rb"(?<=\r)", data)
                self.raw = self.raw + [line for line in ends if line]
                self.heads[name] = since
                self.cuts.append(since)
                self._take(since)
                break
        return self.heads.get(name)

    def _lost_call(self, i: int) -> int:
        # The plain text says M98: the reader loses the position there.
        self.known.clear()
        self.plain[-1] = b"M98 " + self.plain[-1]
        return i + 1

    def _enter(self, begin: int, back: int, times: int, kept: dict[str, float] | None = None) -> int:
        if len(self.stack) >= _DEEP:
            raise _Unknown("too deep")
        if times < 1:
            return back
        self.stack.append((begin, back, times - 1, kept))
        return begin

    def _leave(self, i: int, to: re.Match[str] | None) -> int:
        if not self.stack:
            return -1
        if re.search(r"L\s*\d", self.text[i]):
            raise _Unknown("M99 L")
        begin, back, left, kept = self.stack.pop()
        if left:
            self.stack.append((begin, back, left - 1, kept))
            return begin
        if kept is not None:
            self.known = {k: v for k, v in self.known.items() if not re.fullmatch(r"#(?:[12]?\d|30)", k)} | kept
        return back if to is None else self._line_number(float(to[1]), back - 1)

    def _line_number(self, number: float, i: int) -> int:
        first, last = self._program(i)
        there = [k for k in self.numbers.get(number, []) if first <= k < last]
        if not there:
            raise _Unknown("no such line")
        return next((k for k in there if k > i), there[0])

    def _label(self, name: str, i: int) -> int:
        first, last = self._program(i)
        there = [k for k in self.labels.get(name, []) if first <= k < last]
        if not there:
            raise _Unknown("no such label")
        return next((k for k in there if k > i), there[0])

    # -- what steers ------------------------------------------------------------------------------------------

    def _steering_text(self, text: str) -> str:
        """What of a line steers the program, from its first such word on."""
        found = re.search(
            r"(?<![A-Z_])(?:IF|WHILE|GOTO[FBC]?|FOR|ENDFOR|ENDWHILE|REPEATB?|UNTIL|ELSE|ENDIF|CALL|RET|RTS|END\s*\d)(?![A-Z_])"
            r"|^\s*O\s*(?:\d+|<[^>]*>)\s*[A-Z].*",
            text,
        )
        if found:
            return text[found.start() :].strip(" *")
        word = re.fullmatch(r"\s*([A-Z_]{2}\w*)(?:\s+P\s*=?\s*\d+)?\s*", text)
        if word and not _PUSHED_ASIDE.match(word[1]) and word[1] not in ("CIP", "CT", *_FRAMES):
            if self._where(word[1]) is not None:
                return text.strip()
            if not re.match(r"CYCLE|POCKET|SLOT|HOLES|LONGHOLE|PROC|DEF|EXTERN|SUPA|G153|T\b", word[1]):
                raise _Unknown(word[1])
        return ""

    def _steer(self, i: int, flow: str) -> int:
        value = self._number
        word = re.match(r"(O(?:\d+|<[^>]*>))\s*(\w+)\s*(.*)", flow)
        if word:
            return self._word_steers(i, word[1], word[2], word[3])
        if found := re.fullmatch(r"IF\s*(\[.*\])\s*THEN\s*(#\s*\d+)\s*=(.*)", flow):
            if value(found[1]):
                self.known[re.sub(r"\s", "", found[2])] = value(found[3])
            return i + 1
        if found := re.fullmatch(r"(?:IF\s*(.+?)\s*)?GOTO[FBC]?\s*(.+)|IF\s*(\[.*\])\s*(N\s*\w+)", flow):
            test, to = found[1] or found[3], (found[2] or found[4]).strip()
            if test is not None and not value(test):
                return i + 1
            self.counts.clear()
            if number := re.fullmatch(r"N?\s*(\d+)", to):
                return self._line_number(float(number[1]), i)
            return self._label(to, i) if to in self.labels else self._line_number(value(to), i)
        if found := re.fullmatch(r"WHILE\s*(\[.*\])\s*DO\s*\d+|WHILE\s*(.*)", flow):
            return i + 1 if value(found[1] or found[2]) else self._group(i)[-1] + 1
        if found := re.fullmatch(r"FOR\s+(\w+)\s*=(.+?)\s+TO\s+(.+)", flow):
            again, self.came_from_end = self.came_from_end == i, -1
            self.known[found[1]] = self.known.get(found[1], 0.0) + 1.0 if again else value(found[2])
            return i + 1 if self.known[found[1]] <= value(found[3]) else self._group(i)[-1] + 1
        if re.fullmatch(r"END\s*\d+|ENDWHILE|ENDFOR", flow):
            self.came_from_end = self._group(i)[0]
            return self.came_from_end
        if found := re.fullmatch(r"UNTIL\s*(.*)", flow):
            return i + 1 if value(found[1]) else self._group(i)[0] + 1
        if found := re.fullmatch(r"REPEAT(B?)\s+([A-Z_]\w+)(?:\s+([A-Z_]\w+))?(?:\s+P\s*=?\s*(\d+))?", flow):
            return self._repeat(i, found)
        if flow in ("REPEAT", "ENDIF"):
            self._group(i)
            return i + 1
        if flow == "ELSE":
            return self._group(i)[-1] + 1
        if found := re.fullmatch(r"IF\b(.*)", flow):
            return self._choose(i, found[1])
        if re.match(r"RE?TS?\b", flow):
            return self._leave(i, None)
        if found := re.fullmatch(r'(?:CALL\s+)?"?(\w+)"?(?:\s+[QP]\s*=?\s*(\w+))?', flow):
            return self._call(re.sub(r"^O0*(?=\d)", "O", found[1]), i, int(value(found[2])) if found[2] else 1)
        if flow.startswith("CALL"):
            return self._lost_call(i)
        raise _Unknown(flow)

    def _number(self, text: str) -> float:
        text = text.strip()
        if _expression(text, 0) < len(text):
            raise _Unknown(text)
        return _value(text, self.known)

    def _group(self, i: int) -> list[int]:
        if i not in self.pairs:
            raise _Unknown("incomplete")
        return self.pairs[i]

    def _choose(self, i: int, condition: str) -> int:
        group = self._group(i)
        if self._number(condition):
            return i + 1
        for k in group[1:-1]:
            other = re.search(r"ELSEIF\s*(.*)", self.text[k])
            if other is None or self._number(other[1]):
                return k + 1
        return group[-1] + 1

    def _repeat(self, i: int, found: re.Match[str]) -> int:
        only, label, last, count = found.groups()
        begin = self._label(label, i)
        if not only and last is None:
            left = self.counts.get(i, int(count or 1))
            if begin > i:
                raise _Unknown("REPEAT ahead")
            self.counts[i] = left - 1
            if left:
                return begin
            del self.counts[i]
            return i + 1
        end = begin if only else self._label(last, i)
        for _ in range(int(count or 1)):
            for k in range(begin, end + 1):
                if self._steering_text(re.sub(r"^\s*N\s*\d+\s*", "", self.text[k])) or re.search(
                    r"M\s*0*(?:2|30|9[789]|198|17)(?![\d.])", self.text[k]
                ):
                    raise _Unknown("REPEAT of calls")
                self._put(k, self._words(k))
                self._assign(k)
        return i + 1

    def _word_steers(self, i: int, name: str, verb: str, rest: str) -> int:
        """LinuxCNC's O words."""
        if verb == "SUB":
            if self.stack and self.stack[-1][0] == i:
                return i + 1
            last = re.compile(r"\s*(?:N\s*\d+\s*)?" + re.escape(name) + r"\s*ENDSUB")
            there = [k for k in range(i + 1, len(self.text)) if last.match(self.text[k])]
            if not there:
                raise _Unknown("SUB")
            return there[0] + 1
        if verb in ("ENDSUB", "RETURN"):
            return self._leave(i, None)
        if verb == "CALL":
            begin = self._where(name)
            if begin is None:
                return self._lost_call(i)
            given, place = [], 0
            while rest[place:].strip():
                end = _atom(rest, place)
                if end == place:
                    raise _Unknown(rest)
                given.append(_value(rest[place:end], self.known))
                place = end
            mine = {k: v for k, v in self.known.items() if re.fullmatch(r"#(?:[12]?\d|30)", k)}
            self.known |= {f"#{k}": given[k - 1] if k <= len(given) else 0.0 for k in range(1, 31)}
            return self._enter(begin, i + 1, 1, mine)
        if verb == "WHILE":
            return i + 1 if self._number(rest) else self._group(i)[-1] + 1
        if verb == "REPEAT":
            again, self.came_from_end = self.came_from_end == i, -1
            self.counts[i] = (self.counts[i] if again else int(self._number(rest))) - 1
            return i + 1 if self.counts[i] >= 0 else self._group(i)[-1] + 1
        if verb in ("ENDWHILE", "ENDREPEAT"):
            self.came_from_end = self._group(i)[0]
            return self.came_from_end
        if verb == "IF":
            return self._choose(i, rest)
        if verb.startswith("ELSE"):
            return self._group(i)[-1] + 1
        if verb == "ENDIF":
            return i + 1
        raise _Unknown(verb)

    # -- words ------------------------------------------------------------------------------------------------

    def _assign(self, i: int) -> None:
        """Variables that a line sets."""
        text = re.sub(r"^\s*(?:N\s*\d+\s*)?", "", self.text[i])
        if defined := re.match(r"DEF\s+(?:REAL|INT|BOOL)\s+(.*)", text):
            for part in re.split(r",(?![^\[(]*[\])])", defined[1]):
                target, _, value = part.partition("=")
                if re.fullmatch(r"\s*[A-Z_]\w*\s*", target):
                    self._set(target.strip(), value.strip() or "0")
            return
        if "=" not in text or re.match(r"(?:IF|WHILE|FOR|UNTIL|PROC|GOTO)\b|O(?:\d+|<)", text):
            return
        place, done, found_values = 0, set[str](), dict[str, str | None]()
        while found := _SET.search(text, place):
            end = _closing(text, found.end() - 1) if found["to"].endswith("[") else found.end()
            equals = re.compile(r"\s*=(?!=)\s*").match(text, end)
            place = max(end, found.start() + 1)
            if equals is None or _NO_VARIABLE.fullmatch(found["to"]):
                continue
            target, stop = text[found.start() : end], _expression(text, equals.end())
            value = text[equals.end() : stop]
            place = max(stop, place)
            found_values[target] = None if any(d in value for d in done) else value
            done.add(re.sub(r"\s", "", target))
        before = dict(self.known)
        for target, source in found_values.items():
            self._set(target, source or "", before)

    def _set(self, target: str, source: str, known: dict[str, float] | None = None) -> None:
        known = self.known if known is None else known
        name = re.sub(r"\s|(?<=[A-Z#])0+(?=\d)", "", target)
        if "[" in name:
            try:
                head, _, index = name.partition("[")
                name = f"{head}{int(_value(index.rstrip(']'), known))}"
            except _Unknown:
                self.known.clear()
                return
        try:
            self.known[name] = _value(source, known)
        except _Unknown:
            self.known.pop(name, None)

    def _words(self, i: int) -> str:
        """A line in words of one letter with numbers; what is not known stays, and reads as such."""
        text, out, place = self.text[i], "", 0
        if not re.search(r"[=#\[,]|[A-Z_]{2}|VC?\d", text):
            return text
        head = re.match(r"\s*(?:N\s*\d+\s*)?", text)
        flow = re.sub(r"^\s*N\s*\d+\s*", "", text)
        if re.match(r"(?:IF|WHILE|GOTO|FOR|UNTIL|PROC|DEF|EXTERN|CALL|REPEAT|O\s*(?:\d+|<[^>]*>)\s*[A-Z])", flow):
            return head[0] if head else ""
        text = re.sub(r"(?<![A-Z_])([A-Z_]{2}\w*):", lambda m: " " * len(m[0]), text)
        while found := _NAMED.search(text, place):
            out += text[place : found.start()]
            new, place = self._word(text, found)
            out += new
        out += text[place:]
        if ADDRESS["POLE"] in out:
            out = _pole(out)
        # Variables that are set, and words that do not move.
        out = re.sub(r"(?:#\s*\d+|#\s*<[^>]*>|#\s*\[[^=]*\]|(?<![A-Z])(?:R|VC|V|Q)(?:\d+|\[[^=]*\]))\s*=.*", "", out)
        out = _PUSHED_ASIDE.sub(" ", out)
        out = re.sub(r"\([^()]*\)", "", out)
        named = re.compile(r"(?<![A-Z_])\$?[A-Z_]{2}\w*(?:\[[^\]]*\])?\s*=\s*")
        while found := named.search(out):
            out = out[: found.start()] + " " + out[max(_expression(out, found.end()), found.end()) :]
        return re.sub(r"(?<![A-Z])(?!T)[A-Z]\d*\s*=\s*\S+", " ", out)

    def _word(self, text: str, found: re.Match[str]) -> tuple[str, int]:
        """One word in its one letter, and the place behind it."""
        if word := found["word"]:
            if word in ("SUPA", "G153"):
                return "G53 ", found.end()
            if word in ("CIP", "CT"):
                return f"{ADDRESS['ARC']}{int(word == 'CT')} ", found.end()
            bare = not text[found.end() :].strip()
            ends = bare and _FRAMES[word] == 2 and not word.startswith("A") and word != "MCALL"
            kind = 3 if ends else _FRAMES[word]
            return f"{ADDRESS['FRAME']}{kind} ", len(text) if kind == 2 else found.end()
        if mode := found["mode"]:
            end = _expression(text, found.end())
            letter = ADDRESS.get(f"{mode}={'IC' if found['how'] == 'IC' else 'AC'}") or ADDRESS.get(mode)
            letter = {"CR": "R"}.get(mode, letter or mode)
            behind = re.compile(r"\s*\)").match(text, end)
            return self._stated(letter, text[found.end() : end]), behind.end() if behind else end
        if name := found["name"]:
            letter = {"CR": "R"}.get(name) or ADDRESS.get(name, name)
            end = _expression(text, found.end())
            return self._stated(letter, text[found.end() : end]), end
        if corner := found["corner"]:
            end = _atom(text, found.end())
            return self._stated(ADDRESS[{"R": "RND", "C": "CHR", "A": "ANG"}[corner]], text[found.end() : end]), end
        end = _atom(text, found.end())
        return self._stated(found["letter"], text[found.end() : end]), end

    def _stated(self, letter: str, source: str) -> str:
        try:
            number = _value(source, self.known)
        except _Unknown:
            return f"{letter}# "
        return f"{letter}{np.format_float_positional(number, trim='-')} "
