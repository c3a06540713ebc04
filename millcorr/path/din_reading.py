# SPDX-License-Identifier: LGPL-2.1-or-later
"""A second, small reader of HEIDENHAIN's ISO code (DIN/ISO), for the proof; it shares no code with the writer's.

Words are taken by their letters and handed to the second reader of plain language, whose steps these are.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from millcorr.arrays import Ints

from .klartext_reading import DYADIC, FUNCTIONS, Reader, Words, reading_of
from .reading import Reading

_LEADING = re.compile(r"(?:\xef\xbb\xbf|\xcf\xbb\xbf)?[ \t]*/?[ \t]*(?:N *\d+)? *(?:/ *)?")
_NUMBER = r"[-+]? *(?:Q[LR]?\d+|\d+[.,]?\d*|[.,]\d+)"
_PART = re.compile(rf"([A-Z]) *({_NUMBER}|MAX|AUTO|\"[^\"]*\")?")
_WITH_MORE = re.compile(r"((?<![A-Z])M *(?:101|103|118|120|128|138|14[023])(?!\d)).*", re.DOTALL)
"""M codes that take words of their own behind them."""
_SHAPES = {2: "C", 3: "C", 5: "C", 6: "CT", 12: "CP", 13: "CP", 15: "CP", 16: "CTP"}
_STRAIGHT = (0, 1, 10, 11)
_SIDES = {40: "R0", 41: "RL", 42: "RR"}
_TURNED = {28: "8", 72: "11", 73: "10", 80: "19"}
_OLD_CYCLES = {83: 1, 84: 2, 85: 17, 86: 18, 74: 3, 75: 4, 76: 4, 77: 5, 78: 5, 56: 15, 57: 6, 58: 16, 59: 16, 39: 12}
_QUIET = {4, 30, 31, 36, 37, 38, 51, 62, 98, 99, *range(120, 126)}


def iso_of_heidenhain(data: bytes) -> bool:
    """Whether a text is a program in HEIDENHAIN's ISO code: its first block holds name and unit."""
    first = data.removeprefix(b"\xef\xbb\xbf").lstrip()[:200].splitlines()[:1]
    return bool(first) and re.match(rb"%[^\s(;]*[ \t]*\bG[ \t]*7[01](?!\d)", first[0].upper()) is not None


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
    >>> text = b"%A G71 *\nG00 G90 X+0 Y+0 *\nG01 X+5 F600 *\nG25 R1 *\nY+4 *\n%A G71 *\n"
    >>> read(text).moves.end[:, :2].tolist()
    [[0.0, 0.0], [4.0, 0.0], [5.0, 1.0], [5.0, 4.0]]
    """
    return reading_of(data, _DinReader)


def bare(line: str) -> str:
    """A line without number, comment and the mark of its end, upper case."""
    line = re.sub(r';(?=(?:[^"]*"[^"]*")*[^"]*$).*', "", line.upper().rstrip("\r\n\x1a \t"))
    return _LEADING.sub("", line, count=1).strip().removesuffix("*").strip()


class _DinReader(Reader):
    """What holds on in ISO code, and its words."""

    def __init__(self, data: bytes, starts: Ints) -> None:
        self.code = -1
        self.counting: bool | None = False
        self.begun = False
        super().__init__(data, starts)

    def blocks(self, text: str, starts: Ints) -> Iterator[tuple[int, int, str]]:
        """Lines, and where G26 and G27 join two, these as one, with a line feed between them."""
        lines = [bare(text[starts[i] : starts[i + 1]]) for i in range(len(starts) - 1)]
        i = 0
        while i < len(lines):
            pair = lines[i : i + 2]
            joined = len(pair) == 2 and (
                (_goes(pair[0]) and _codes(pair[1]) == [26]) or (_codes(pair[0]) == [27] and _goes(pair[1]))
            )
            yield i, i + joined, "\n".join(pair) if joined else pair[0]
            i += 1 + joined

    def label(self, text: str) -> str | None:
        """Label of G98, "0" for the end of a subprogram."""
        found = re.fullmatch(r'G *98 *L *("[^"]*"|\w+)', text)
        return found[1] if found else None

    def call(self, text: str) -> tuple[str, int | None] | None:
        """L1,0 and L1 call a subprogram, L1,2 has a section repeated twice."""
        found = re.fullmatch(r'L *("[^"]*"|\w+) *(?:, *(\d+))?', text)
        if found is None:
            return None
        return found[1], int(found[2]) if found[2] and int(found[2]) else None

    def jump(self, text: str) -> tuple[int, float, float, str] | None:
        """D09 to D12."""
        found = re.match(rf"D *0*(9|1[012]) *P01 *({_NUMBER}) *P02 *({_NUMBER}) *P03 *(.+)", text)
        if found is None:
            return None
        return int(found[1]), self._worth(found[2]), self._worth(found[3]), found[4].strip()

    def _worth(self, text: str) -> float:
        text = text.replace(" ", "")
        if not text or text[:1] in '"MA':
            return math.nan
        return self.value(text[0] if text[0] in "+-" else "", text.lstrip("+-"))

    def block(self, text: str, line: int) -> bool:
        """Take a block over; False where the program ends."""
        if not text:
            return True
        if text[0] == "%":
            return self._of_program(text)
        if "\n" in text:
            return self._lead_of_two(text, line)
        if re.match(r"D *\d", text):
            self._function(text)
        elif text[0] == "Q":
            self._assign(text)
        elif self.call(text) is None:
            return self._words_of(text, line)
        return True

    def _of_program(self, text: str) -> bool:
        unit = re.search(r"\bG *7([01])$", text)
        if not self.begun:
            self.begun = True
            self.unit = 25.4 if unit and unit[1] == "0" else 1.0
            return True
        if unit is None:
            self.q, self.feed, self.centre, self.at = {}, math.nan, [math.nan] * 3, [math.nan] * 3
            self.code, self.counting = -1, None
        return unit is None

    def _function(self, text: str) -> None:
        found = re.match(
            rf"D *(\d+) *(Q[LRS]?\d+)? *(?:P01 *({_NUMBER}))? *(?:P02 *({_NUMBER}))?", text
        )  # fmt: skip
        assert found is not None
        number, name = int(found[1]), found[2]
        if name is None:
            if number in (9, 10, 11, 12, 14, 15, 16, 19, 20, 26, 27, 29, 37, 38):
                return
            self.at = [math.nan] * 3
            return
        value = math.nan
        try:
            if number in (0, 5, 6, 7) and found[3]:
                value = self._worth(found[3])
                value = value if not number else float(FUNCTIONS[{5: "SQRT", 6: "SIN", 7: "COS"}[number]](value))
            elif number in DYADIC and found[3] and found[4]:
                value = float(DYADIC[number](self._worth(found[3]), self._worth(found[4])))
        except (ValueError, ArithmeticError):
            value = math.nan
        self.q[name] = value

    def _words_of(self, text: str, line: int) -> bool:
        text = _WITH_MORE.sub(r"\1", text)
        parts = _parts(text)
        if any(not value for _, value in parts) or re.sub(_PART, "", text).strip():
            return self.go("L", self._unread(parts, _codes(text)), line)
        codes = _codes(text)
        letters = {letter for letter, _ in parts}
        known = self._counted(parts)
        special = [code for code in codes if code not in (90, 91)]
        if "T" in letters and not letters & set("XYZABCUVWHIJK"):
            axis = next((a for code, a in ((17, "Z"), (18, "Y"), (19, "X")) if code in codes), "")
            number, feed = dict(parts)["T"], next((v for letter, v in parts if letter == "F"), "")
            if not {99, 51} & set(codes):
                self.tool_call(f"{number} {axis}" + (f" F{feed}" if feed else ""))
        elif special and all(code in (29, 17) for code in special) and letters <= set("GIJK"):
            self.pole(self._pole_words(parts, known))
        elif not special and letters & set("IJK") and letters <= set("GIJK"):
            self.pole(self._pole_words(parts, known))
        elif self._cycle_of(special, text):
            return not (38 in special and {2, 30} & {int(v) for letter, v in parts if letter == "M" and v.isdigit()})
        else:
            return self._motion(parts, codes, line, known)
        return True

    def _counted(self, parts: list[tuple[str, str]]) -> set[str] | None:
        """Letters whose numbers are increments, by the last G90 or G91 before each; None where that is not known."""
        out: set[str] | None = set()
        for letter, value in parts:
            if letter == "G" and value in ("90", "91"):
                self.counting = value == "91"
            elif letter in "XYZABCUVWRHIJK":
                if self.counting is None:
                    out = None
                elif self.counting and out is not None:
                    out.add(letter)
        return out

    def _unread(self, parts: list[tuple[str, str]], codes: list[int]) -> Words:
        """Words of a block that goes nobody knows where."""
        out = self._taken(parts, codes, set())
        out.alone.add("?")
        out.number = {"X": math.nan} | {k: v for k, v in out.number.items() if k == "F"}
        return out

    def _pole_words(self, parts: list[tuple[str, str]], counted: set[str] | None) -> Words:
        out = Words()
        for letter, value in parts:
            if letter in "IJK":
                out.number["XYZ"["IJK".index(letter)]] = math.nan if counted is None else self._worth(value)
                if counted and letter in counted:
                    out.more.add("XYZ"["IJK".index(letter)])
        return out

    def _cycle_of(self, special: list[int], text: str) -> bool:
        """Whether a block is of cycles, datums, frames and what stands beside the path; what it does to the place."""
        code = next((c for c in special if c in _TURNED or c in _OLD_CYCLES or c in _QUIET or c > 99), -1)
        if 79 in special:
            self.called()
            return True
        for found in re.finditer(r"(Q\d+) *= *([-+]?) *(Q\d+|[\d.,]+)", text):
            self.q[found[1]] = self.value(found[2], found[3])
        if 55 in special or 400 <= code < 500:
            self.at = [math.nan] * 3
            self.q = {k: v for k, v in self.q.items() if not re.fullmatch(r"Q1\d\d", k)}
        elif {53, 54} & set(special):
            rest = re.sub(r"^.*?G *5[34]", "", text)
            self.shifted("" if re.fullmatch(r" *(?:[XYZ] *[-+]?0*[.,]?0* *)+", rest) and 54 in special else text)
        elif code == 247 or code in _TURNED:
            self.shifted(text)
        elif code in _OLD_CYCLES:
            self.cycle = str(_OLD_CYCLES[code])
        elif code > 99 and code not in _QUIET and code not in (270, 271, 272):
            self.cycle = str(code if code >= 200 else code - 100)
        elif code not in _QUIET and code not in (270, 271, 272):
            return False
        return True

    def _motion(self, parts: list[tuple[str, str]], codes: list[int], line: int, counted: set[str] | None) -> bool:
        moving = [code for code in codes if code in _STRAIGHT or code in _SHAPES]
        corner = {24, 25} & set(codes)
        self.code = moving[-1] if moving else self.code
        letters = {letter for letter, _ in parts}
        words = self._taken(parts, codes, counted or set())
        if corner:
            head = "CHF" if 24 in corner else "RND"
            words.number["CHF"] = words.number.get("R", math.nan)
            self.corner(head, words, line)
            return True
        places = letters & set("XYZABCUVWRH")
        understood = (
            counted is not None
            and len(moving) < 2
            and letters <= set("GXYZABCUVWRHFMSN")
            and all(c in _STRAIGHT or c in _SHAPES or c in _SIDES or c in (17, 90, 91) for c in codes)
        )
        head = self._shape(letters)
        if not places and understood:
            head = "L"
        elif not understood or not head or self.code < 0:
            words, head = self._unread(parts, codes), "L"
        elif self.code in (0, 10):
            words.alone.add("FMAX")
        if head in ("LP", "CP", "CTP"):
            if "R" in words.number:
                words.number["PR"] = words.number.pop("R")
        else:
            words.more.discard("PR")
        if self.code in (2, 12, 3, 13):
            words.alone.add("DR-" if self.code in (2, 12) else "DR+")
        return self.go(head, words, line)

    def _shape(self, letters: set[str]) -> str:
        """Head of the block in plain language; empty where its words contradict each other."""
        if self.code >= 10 and letters & set("RH"):
            head = _SHAPES.get(self.code, "LP")
            return "" if letters & set("XY") or (head == "CP" and "R" in letters) else head
        if "H" in letters:
            return ""
        if self.code in _STRAIGHT:
            return "" if "R" in letters or (self.code >= 10 and letters & set("XY")) else "L"
        if self.code >= 10 or not letters & set("XY"):
            return ""
        if self.code == 6:
            return "" if "R" in letters else "CT"
        return "CR" if "R" in letters else "C"

    def _taken(self, parts: list[tuple[str, str]], codes: list[int], counted: set[str]) -> Words:
        out = Words()
        out.alone = {_SIDES[code] for code in codes if code in _SIDES}
        for letter, value in parts:
            if letter == "F" and value in ("MAX", "AUTO"):
                out.alone.add("F" + value)
            elif letter == "M" and value.isdigit():
                out.codes.append(int(value))
            elif letter in "XYZABCUVWRHF" and value:
                name = {"H": "PA"}.get(letter, letter)
                out.number[name] = self._worth(value)
                if letter in counted:
                    out.more.add("PR" if letter == "R" else name)
        return out

    def _lead_of_two(self, text: str, line: int) -> bool:
        """G26 and G27 with the block of the place that they lead from or to."""
        first, second = text.split("\n")
        approach = _codes(second) == [26]
        place, curve = (first, second) if approach else (second, first)
        parts = _parts(place)
        codes = _codes(place)
        counted = self._counted(parts)
        moving = [code for code in codes if code in _STRAIGHT or code in _SHAPES]
        self.code = moving[-1] if moving else self.code
        words = self._taken(parts, codes, counted or set())
        radius = re.fullmatch(rf"G *2[67] *R *({_NUMBER})(?: *F *[\d.,Q]+)?", curve)
        sound = counted is not None and self.code in _STRAIGHT and radius and {41, 42, 40} & set(codes)
        if not sound or radius is None or (40 in codes) == approach:
            words.alone.add("?")
            words.number["X"] = math.nan
            return self.go("L", words, line)
        if "R" in words.number:
            words.number["PR"] = words.number.pop("R")
        words.number["R"] = self._worth(radius[1])
        if self.code in (0, 10):
            words.alone.add("FMAX")
        return self.lead("APPR" if approach else "DEP", "LCT", words, line)


def _parts(text: str) -> list[tuple[str, str]]:
    """Letters and numbers of a block; names of tools with their blanks."""
    found = [(m[1], m[2] or "") for m in _PART.finditer(text)]
    return [(letter, value if value[:1] == '"' else value.replace(" ", "")) for letter, value in found]


def _codes(text: str) -> list[int]:
    """G codes of a block."""
    return [int(code) for code in re.findall(r"(?<![A-Z])G *(\d+)", text)]


def _goes(text: str) -> bool:
    """Whether a block states a place of the path."""
    fine = all(c in _STRAIGHT or c in _SHAPES or c in (40, 41, 42, 43, 44, 17, 90, 91) for c in _codes(text))
    return fine and text[:1] != "%" and re.search(r"[XYH] *[-+.,\dQ]", text) is not None
