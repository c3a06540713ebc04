# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing changed moves back into a program in HEIDENHAIN's ISO code.

The blocks are written anew in plain language, as a plain-language program's are, and then said in ISO code: words are
changed in place, and a motion code, G90 or G91 is stated where a block no longer inherits what it needs.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from millcorr.nc.comment_texts import comment_texts
from millcorr.nc.repeated import agreed
from millcorr.nc.toolpath import Toolpath

from .blocks import Block, read_block
from .din import CORNERS, MOTIONS, POLE, Modal, Sentence, Told, read_sentence
from .din_program import DinCourse, DinProgram, told_in_iso
from .writer import Line, Writer

_BY_SENSE = {"-": 2, "+": 3, "": 5}
_POLAR_BY_SENSE = {"-": 12, "+": 13, "": 15}
_LETTERS = {"PR": "R", "PA": "H", "CHF": "R"}
_RANK = {letter: rank for rank, letter in enumerate("GXYZABCUVWIJKRHF")}
_AFTER_PLACES, _LAST = len(_RANK), len(_RANK) + 1
_ONE_BLOCK = (*CORNERS, 29)
"""Codes that hold in their block only, and are what a block is."""


def write(
    program: DinProgram,
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
    with told_in_iso(program.name):
        writer = Writer(program, toolpath, decimals, tolerance)
        blocks = writer.lines()
    if not header and all(line.as_read for lines in blocks for line in lines):
        return program.data
    assert isinstance(writer.course, DinCourse)
    lines = _Speller(program, writer.course, blocks).lines()
    return _numbered(_with_header(lines, header) if header else lines).encode("latin-1")


@dataclass(slots=True)
class _Wanted:
    """What a block in plain language is in ISO code.

    Parameters
    ----------
    motion : int
        -1 for a block that needs none.
    incremental : bool or None
        Whether its coordinates are increments; None without any.
    numbers : dict of str to str
        By letter, as they are to be written.
    codes : list of str
        M words.
    """

    motion: int = -1
    incremental: bool | None = None
    numbers: dict[str, str] = field(default_factory=dict)
    codes: list[str] = field(default_factory=list)


def _wanted(block: Block) -> _Wanted:
    out = _Wanted()
    for word in block.words:
        number = re.sub(r"[A-Za-z]+[ \t]*", "", block.text[word.start : word.stop], count=1)
        letter = _LETTERS.get(word.name, word.name)
        if word.name in ("X", "Y", "Z", "PR", "PA"):
            out.incremental = word.incremental
        if block.kind == "CC":
            letter = next(pole for pole, axis in POLE.items() if axis == word.name)
        if word.name == "M":
            out.codes.append(number)
        elif word.name not in ("COMP", "DR") and word.value not in ("MAX", "AUTO", ""):
            out.numbers[letter] = number
    rapid = any(w.name == "F" and w.value == "MAX" for w in block.words)
    turn = block.find("DR")
    sense = turn.value if turn is not None else ""
    if block.moves or block.kind in ("RND", "CHF"):
        out.motion = {
            "": 0 if rapid else 1, "L": 0 if rapid else 1, "LP": 10 if rapid else 11,
            "C": _BY_SENSE[sense], "CR": _BY_SENSE[sense], "CP": _POLAR_BY_SENSE[sense], "CT": 6, "CTP": 16,
            "RND": 25, "CHF": 24,
        }[block.kind]  # fmt: skip
    return out


class _Speller:
    """Says blocks of plain language in ISO code, with what each of their runs needs stated.

    Parameters
    ----------
    program : DinProgram
    course : DinCourse
        How the program runs as it was read.
    blocks : list of list of Line
        What stands in plain language for every block of the text.
    """

    def __init__(self, program: DinProgram, course: DinCourse, blocks: list[list[Line]]) -> None:
        self.program, self.course, self.blocks = program, course, blocks
        self.told: dict[int, Told] = {}
        self.motion: set[tuple[int, int]] = set()
        self.distance: set[tuple[int, int]] = set()
        """Lines, as block and place in it, that have to state what they would inherit."""
        self.short = re.search(rb"(?i)G[0-3](?!\d)", program.data) and not re.search(rb"(?i)G0[0-3]", program.data)
        self._find_missing()

    def _read(self, line: Line) -> Block:
        return read_block(line.text + line.ending, 0, 0, self.program.name)

    def _find_missing(self) -> None:
        now = Modal()
        for told, owner in zip(self.course.told, self.course.owner, strict=True):
            self.told.setdefault(owner, told)
            for i, line in enumerate(self.blocks[owner]):
                if line.as_read:
                    now = self._as_read(told, now, owner, i)
                else:
                    now = self._rewritten(told, line, now, owner, i)

    def _as_read(self, told: Told, now: Modal, owner: int, i: int) -> Modal:
        if told.leans_on_motion and told.before.motion != now.motion:
            self.motion.add((owner, i))
            now = replace(now, motion=told.before.motion)
        if told.leans_on_distance and told.before.incremental != now.incremental:
            self.distance.add((owner, i))
            now = replace(now, incremental=told.before.incremental)
        if told.sentences[0].role == "call":
            return told.after
        own = told.moving
        return Modal(
            own.motion if own.motion >= 0 else now.motion,
            now.incremental if own.distance is None else own.distance,
        )

    def _rewritten(self, told: Told, line: Line, now: Modal, owner: int, i: int) -> Modal:
        wanted = _wanted(self._read(line))
        own = told.moving if line.own else None
        motion = now.motion if own is None or own.motion < 0 else own.motion
        if own is not None and told.mixed:
            # Its places keep the G90 or G91 before each; what is added stands behind the last.
            if told.leans_on_distance and told.before.incremental != now.incremental:
                self.distance.add((owner, i))
            wanted.incremental, incremental = None, told.after.incremental
        else:
            incremental = now.incremental if own is None or own.distance is None else own.distance
        lead = len(told.sentences) > 1
        if not lead and 0 <= wanted.motion and wanted.motion not in CORNERS and wanted.motion != motion:
            self.motion.add((owner, i))
            motion = wanted.motion
        if lead and told.leans_on_motion and motion != told.before.motion:
            self.motion.add((owner, i))
            motion = told.before.motion
        if wanted.incremental is not None and wanted.incremental != incremental:
            self.distance.add((owner, i))
            incremental = wanted.incremental
        return Modal(motion, incremental)

    def lines(self) -> list[tuple[Sentence, str]]:
        """Lines of the text, with how each is taken apart."""
        out = []
        for owner, group in enumerate(self.blocks):
            told = self.told.get(owner)
            for i, line in enumerate(group):
                if told is None:
                    out += self._as_it_stands(owner)
                elif line.as_read or line.own:
                    out += self._own(told, line, (owner, i))
                else:
                    out.append(self._inserted(told, line, (owner, i)))
        return [(sentence, sentence.text + sentence.ending) for sentence in out]

    def _as_it_stands(self, owner: int) -> list[Sentence]:
        block = self.course.text[owner]
        lines = (self.program.line(i).decode("latin-1") for i in range(block.first, block.last + 1))
        return [read_sentence(line, block.first + j) for j, line in enumerate(lines)]

    def _own(self, told: Told, line: Line, key: tuple[int, int]) -> list[Sentence]:
        out = []
        moving = told.moving
        for sentence in told.sentences:
            text = sentence.text
            if sentence is moving and not line.as_read:
                text = self._changed(sentence, told, _wanted(self._read(line)), key)
            elif sentence is moving and (key in self.motion or key in self.distance):
                text = self._stated(sentence, told, key)
            out.append(read_sentence(text + sentence.ending, sentence.line))
        return out

    def _code(self, number: int) -> str:
        return f"G{number}" if self.short else f"G{number:02d}"

    def _stated(self, sentence: Sentence, told: Told, key: tuple[int, int]) -> str:
        """A line with the codes that it would no longer inherit."""
        words = _Words(sentence)
        if key in self.motion:
            words.put("G", self._code(told.before.motion), first=True)
        if key in self.distance:
            words.put("G", "G91" if told.before.incremental else "G90")
        return words.text()

    def _changed(self, sentence: Sentence, told: Told, wanted: _Wanted, key: tuple[int, int]) -> str:
        lead = len(told.sentences) > 1
        words = _Words(sentence)
        numbers = dict(wanted.numbers)
        if lead:
            # The radius stands with G26 or G27.
            numbers.pop("R", None) if "R" not in sentence.letters else None
            if "R" in sentence.letters:
                numbers["R"] = next(p.value for p in sentence.pieces if p.letter == "R")
        motion = told.before.motion if lead else wanted.motion
        if (key in self.motion or (0 <= motion != sentence.motion and set(sentence.codes) & set(_ONE_BLOCK))) and not (
            words.replace_code((*MOTIONS, *_ONE_BLOCK), self._code(motion))
        ):
            words.put("G", self._code(motion), first=True)
        if motion < 0 and "I" in numbers:
            words.drop_code(29)
        if key in self.distance and told.mixed:
            words.put("G", "G91" if told.before.incremental else "G90", first=True)
        elif key in self.distance:
            code = "G91" if wanted.incremental else "G90"
            if not words.replace_code((90, 91), code):
                words.put("G", code)
        words.take_numbers(numbers, last=told.mixed)
        words.take_codes(wanted.codes)
        return words.text()

    def _inserted(self, told: Told, line: Line, key: tuple[int, int]) -> Sentence:
        sentence = told.sentences[0]
        wanted = _wanted(self._read(line))
        words = _Words(sentence, empty=True)
        if key in self.motion:
            words.put("G", self._code(wanted.motion))
        if key in self.distance:
            words.put("G", "G91" if wanted.incremental else "G90")
        words.take_numbers(wanted.numbers)
        words.take_codes(wanted.codes)
        ending = sentence.ending or self.program.style.ending.decode()
        return read_sentence(words.text() + ending, -1)


class _Words:
    """The words of a line with what stands between them.

    Parameters
    ----------
    sentence : Sentence
    empty : bool
        Of another line like it, that has none yet.
    """

    def __init__(self, sentence: Sentence, empty: bool = False) -> None:
        self.opening = sentence.text[: sentence.body]
        self.tail = sentence.text[sentence.stop :]
        self.pieces: list[list[str]] = []
        place = sentence.body
        gaps = []
        for piece in sentence.pieces:
            gaps.append(sentence.text[place : piece.start])
            self.pieces.append([gaps[-1], piece.letter, piece.value, sentence.text[piece.start : piece.stop]])
            place = piece.stop
        self.blank = " " if any(gaps[1:]) or len(gaps) < 2 else ""
        if empty:
            self.pieces = []
            ended = re.match(r"[ \t]*\*", self.tail)
            self.tail = ended.group() if ended else ""

    def text(self) -> str:
        """The line as it now reads, without its ending."""
        return self.opening + "".join(piece[0] + piece[3] for piece in self.pieces) + self.tail

    def put(self, letter: str, text: str, first: bool = False, last: bool = False) -> None:
        """Put a word where it belongs, or first, or behind all places."""
        rank = _rank("H" if last else letter)
        place = 0
        for i, piece in enumerate(self.pieces):
            if not first and _rank(piece[1]) <= rank:
                place = i + 1
        gap = self.blank if place else ""
        self.pieces.insert(place, [gap, letter, "", text])
        if not place and len(self.pieces) > 1 and not self.pieces[1][0]:
            self.pieces[1][0] = self.blank

    def replace_code(self, codes: tuple[int, ...], text: str) -> bool:
        """Put another G code in place of one; False where there is none of them."""
        for piece in self.pieces:
            if piece[1] == "G" and piece[2].isdigit() and int(piece[2]) in codes:
                piece[2:] = [text[1:], text]
                return True
        return False

    def drop_code(self, code: int) -> None:
        """Take a G code away."""
        self._keep([p for p in self.pieces if not (p[1] == "G" and p[2].isdigit() and int(p[2]) == code)])

    def _keep(self, pieces: list[list[str]]) -> None:
        if pieces and pieces[0] is not self.pieces[0]:
            pieces[0][0] = ""
        self.pieces = pieces

    def take_numbers(self, numbers: dict[str, str], last: bool = False) -> None:
        """Have these numbers and no others behind the letters of places, radius, angle and feed; new ones `last`."""
        kept = []
        left = dict(numbers)
        for piece in self.pieces:
            letter = piece[1]
            if letter in _RANK and letter != "G" and not (letter == "F" and piece[2] in ("MAX", "AUTO", "")):
                if letter not in left:
                    continue
                number = left.pop(letter)
                if re.sub(r"[ \t]", "", number).replace(",", ".") != piece[2]:
                    start = re.match(r"[A-Za-z][ \t]*", piece[3])
                    assert start is not None
                    piece[2:] = [number, start.group() + number]
            kept.append(piece)
        self._keep(kept)
        for letter, number in left.items():
            self.put(letter, letter + number, last=last and letter in "XYZ")

    def take_codes(self, codes: list[str]) -> None:
        """Have these M words and no others."""
        kept, left = [], list(codes)
        for piece in self.pieces:
            if piece[1] == "M":
                if piece[2] not in left:
                    continue
                left.remove(piece[2])
            kept.append(piece)
        self._keep(kept)
        for code in left:
            self.put("M", "M" + code)


def _rank(letter: str) -> int:
    return _LAST if letter == "M" else _RANK.get(letter, _AFTER_PLACES)


def _with_header(lines: list[tuple[Sentence, str]], header: Sequence[str]) -> list[tuple[Sentence, str]]:
    """Lines with comment blocks behind the first block."""
    top = next((i for i, (sentence, _) in enumerate(lines) if sentence.role), 0) + 1
    model = next((s for s, _ in lines[top:] if s.pieces), lines[0][0])
    words = _Words(model, empty=True)
    opening = model.text[: model.number[1]] + " " if model.number[0] < model.number[1] else ""
    added = []
    for text in comment_texts(header):
        line = f"{opening}; {text}{words.tail}{lines[0][0].ending or chr(10)}"
        added.append((read_sentence(line, -1), line))
    return [*lines[:top], *added, *lines[top:]]


def step_of(numbers: list[int]) -> int:
    """Step by which block numbers count on, the last one, which ends the program, apart; 0 where they do not."""
    steps = {b - a for a, b in zip(numbers[:-2], numbers[1:-1], strict=True)}
    return steps.pop() if len(steps) == 1 and min(steps) > 0 else 0


def _numbered(lines: list[tuple[Sentence, str]]) -> str:
    """The text; block numbers that counted on by one step do so again, else blocks that are inserted have none."""
    read = [int(_number(s)) for s, _ in lines if s.line >= 0 and s.number[0] < s.number[1]]
    step = step_of(read)
    out, number = [], None
    last = max((i for i, (s, _) in enumerate(lines) if s.number[0] < s.number[1]), default=-1)
    for i, (sentence, text) in enumerate(lines):
        a, b = sentence.number
        if a < b and step:
            own = _number(sentence)
            on_with = number is not None and (i < last or int(own) == read[-2] + step)
            number = read[0] if number is None else number + step if on_with else int(own)
            padded = str(number).zfill(len(own)) if own.startswith("0") else str(number)
            text = text[: b - len(own)] + padded + text[b:]
        elif a < b and sentence.line < 0:
            text = text[:a] + text[b:].lstrip(" \t")
        out.append(text)
    return "".join(out)


def _number(sentence: Sentence) -> str:
    return sentence.text[slice(*sentence.number)].lstrip("Nn \t")
