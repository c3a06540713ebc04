# SPDX-License-Identifier: LGPL-2.1-or-later
"""HEIDENHAIN's ISO programs (DIN/ISO, `%NAME G71 *`): the blocks of plain language in other words.

A block is taken apart here and said in plain language, in the state in which it runs: the motion code, G90 and G91
hold on. What it means is then the business of the plain language alone. Nothing is refused here: what cannot be said
is the `odd` of its block.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from millcorr.arrays import Ints

from .blocks import WITH_MORE, Block, comment_of, decoded, read_block

RECOGNISED = re.compile(rb"(?:\xef\xbb\xbf)?\s*%[^\s(;]*[ \t]*(?<![A-Za-z])G[ \t]*7[01](?!\d)", re.IGNORECASE)
"""The first block names the program and states its unit: G70 inches, G71 millimetres."""
LINES, ARCS, TANGENTS = (0, 1), (2, 3, 5), (6,)
POLAR = {10: "LP", 11: "LP", 12: "CP", 13: "CP", 15: "CP", 16: "CTP"}
CORNERS = {24: "CHF", 25: "RND"}
MOTIONS = (*LINES, *ARCS, *TANGENTS, *POLAR)
COMPENSATIONS = {40: "R0", 41: "RL", 42: "RR", 43: "R+", 44: "R-"}
SENSES = {2: "DR-", 3: "DR+", 12: "DR-", 13: "DR+"}
POLE = dict(zip("IJK", "XYZ", strict=True))
COORDINATES = "XYZABCUVWRH"
_PLANES = {17: "Z", 18: "Y", 19: "X"}
_OPENING = re.compile(r"(?:[\xcf\xef]\xbb\xbf)?[ \t]*(?:/[ \t]*)?(?:(N[ \t]*\d+)[ \t]*)?(?:/[ \t]*)?")
_NUMBER = r"[-+]?[ \t]*(?:Q[LR]?\d+|\d+(?:[.,]\d*)?|[.,]\d+)"
_WORD = re.compile(rf'[ \t]*(?P<word>(?P<letter>[A-Z])(?:[ \t]*(?P<value>{_NUMBER}|MAX|AUTO|"[^"]*"))?)')
_CALL = re.compile(r'L[ \t]*("[^"]*"|Q[LRS]?\d+|\d+)(?:[ \t]*,[ \t]*(\d+))?')
_OPERAND = rf"[ \t]*({_NUMBER})[ \t]*"
_D = re.compile(
    rf"D[ \t]*(\d+)[ \t]*(Q[LRS]?\d+)?[ \t]*(?:P01{_OPERAND})?(?:P02{_OPERAND})?(?:P03[ \t]*(.*))?(.*)", re.DOTALL
)
_DYADIC = {1: "+", 2: "-", 3: "*", 4: "DIV", 8: "LEN", 13: "ANG"}
_SINGLE = {0: "", 5: "SQRT ", 6: "SIN ", 7: "COS "}
_COMPARED = {9: "EQU", 10: "NE", 11: "GT", 12: "LT"}
_CYCLES = {
    4: "9.1 DWELL ", 28: "8.1 ", 36: "13.1 ", 37: "14.1 ", 39: "12.1 ", 53: "7.1 #", 54: "7.1 ", 56: "15.1 ",
    57: "6.1 ", 58: "16.1 ", 59: "16.1 ", 62: "32.1 ", 72: "11.1 SCL ", 73: "10.1 ROT ", 74: "3.1 ", 75: "4.1 ",
    76: "4.1 ", 77: "5.1 ", 78: "5.1 ", 80: "19.1 ", 83: "1.1 ", 84: "2.1 ", 85: "17.1 ", 86: "18.1 ",
}  # fmt: skip
"""Codes of the cycles that plain language knows by number."""
_HELD = "{} beside a motion: state the pole in a block of its own"


@dataclass(frozen=True, slots=True)
class Modal:
    """What holds on from block to block.

    Parameters
    ----------
    motion : int
        Motion code; -1 where none was stated.
    incremental : bool or None
        G91; None where it is not known.
    """

    motion: int = -1
    incremental: bool | None = False


@dataclass(frozen=True, slots=True)
class Piece:
    """A word: its letter, its number without blanks, and where it stands in the text."""

    letter: str
    value: str
    start: int
    stop: int

    @property
    def code(self) -> int:
        """Number of a G or M word, -1 where it is none."""
        return int(self.value) if self.value.isdigit() else -1


@dataclass(frozen=True, slots=True)
class Sentence:
    """A line of text, taken apart.

    Parameters
    ----------
    line : int
        From 0.
    text, ending : str
    number : (int, int)
        Where its N word stands; equal without one.
    body, stop : int
        Where the words begin and end: before the asterisk and the comment.
    pieces : tuple of Piece
    role : str
        begin, end or call of a program (%), "" for others.
    odd : str
        What is no word.
    codes : tuple of int
        Its G codes.
    letters : str
        Letters of its words.
    """

    line: int
    text: str
    ending: str
    number: tuple[int, int]
    body: int
    stop: int
    pieces: tuple[Piece, ...] = ()
    role: str = ""
    odd: str = ""
    codes: tuple[int, ...] = ()
    letters: str = ""

    @property
    def bare(self) -> str:
        """The words, upper case."""
        return self.text[self.body : self.stop].upper()

    @property
    def motion(self) -> int:
        """The motion code that it states; -1 without one."""
        return next((code for code in self.codes if code in MOTIONS), -1)

    @property
    def distance(self) -> bool | None:
        """Whether it states G91 last; None where it states neither G90 nor G91."""
        return next((code == 91 for code in reversed(self.codes) if code in (90, 91)), None)


@dataclass(slots=True)
class Told:
    """One block or, where an approach or departure needs two, both: as text and said in plain language.

    Parameters
    ----------
    sentences : tuple of Sentence
    block : Block
        In plain language.
    before, after : Modal
        What holds before and behind it.
    """

    sentences: tuple[Sentence, ...]
    block: Block
    before: Modal
    after: Modal

    @property
    def leans_on_motion(self) -> bool:
        """Whether it takes its motion code from a block before."""
        needs = self.block.moves and not self.block.odd
        return needs and self.moving.motion < 0

    @property
    def leans_on_distance(self) -> bool:
        """Whether G90 or G91 of a block before counts for one of its places."""
        polar = self.block.find("PR") is not None
        for piece in self.moving.pieces:
            if piece.letter == "G" and piece.code in (90, 91):
                return False
            if piece.letter in "XYZABCUVWHIJK" or (piece.letter == "R" and polar):
                return True
        return False

    @property
    def mixed(self) -> bool:
        """Whether some of its coordinates are increments, and others are not."""
        return len({w.incremental for w in self.block.words if w.name in ("X", "Y", "Z", "PR", "PA")}) > 1

    @property
    def moving(self) -> Sentence:
        """The sentence that states the place."""
        return next((s for s in self.sentences if not {26, 27}.intersection(s.codes)), self.sentences[0])


def sentences_of(data: bytes, starts: Ints) -> list[Sentence]:
    """Lines of a program taken apart.

    Parameters
    ----------
    data : bytes
    starts : (lines + 1,) int64
        Offsets of its lines.
    """
    text = decoded(data)
    bounds = starts.tolist()
    out: list[Sentence] = []
    begun = False
    for i in range(len(bounds) - 1):
        sentence = read_sentence(text[bounds[i] : bounds[i + 1]], i)
        if sentence.role:
            if not begun:
                sentence = replace(sentence, role="begin")
            begun = True
        out.append(sentence)
    return out


def read_sentence(whole: str, line: int) -> Sentence:
    """Take one line apart; `whole` with its line ending."""
    text = whole.rstrip("\r\n")
    ending = whole[len(text) :]
    upper = text.upper()
    opening = _OPENING.match(upper)
    assert opening is not None
    number = opening.span(1) if opening.group(1) else (0, 0)
    body = opening.end()
    stop = len(text[: comment_of(text, body)].rstrip(" \t\x1a"))
    if stop > body and text[stop - 1] == "*":
        stop = len(text[: stop - 1].rstrip(" \t"))
    stop = max(stop, body)
    bare = upper[body:stop]
    if bare.startswith("%"):
        role = "end" if re.search(r"(?<![A-Z])G[ \t]*7[01]$", bare) else "call"
        return Sentence(line, text, ending, number, body, stop, (), role)
    if re.match(r"[DQ]", bare) or _CALL.fullmatch(bare):
        return Sentence(line, text, ending, number, body, stop)
    pieces = []
    place = body
    while (found := _WORD.match(upper, place, stop)) is not None:
        value = found["value"] or ""
        if not value.startswith('"'):
            value = re.sub(r"[ \t]", "", value).replace(",", ".")
        piece = Piece(found["letter"], value, *found.span("word"))
        place = found.end()
        if piece.letter == "M" and piece.code in WITH_MORE:
            piece = replace(piece, stop=stop)
            place = stop
        pieces.append(piece)
    bare_letter = next((p.letter for p in pieces if not p.value), "")
    odd = next(iter(upper[place:stop].split()), "")[:20] or bare_letter
    codes = tuple(p.code for p in pieces if p.letter == "G")
    letters = "".join(p.letter for p in pieces)
    return Sentence(line, text, ending, number, body, stop, tuple(pieces), "", odd, codes, letters)


@dataclass(slots=True)
class _Said:
    """A block in plain language in the making."""

    text: str = ""
    odd: str = ""
    after: Modal = field(default_factory=Modal)


class Story(Sequence[Block]):
    """The blocks of a program in plain language, each as it is where it runs next.

    Parameters
    ----------
    data : bytes
    starts : (lines + 1,) int64
    name : str
        Of the program, for messages.
    """

    def __init__(self, data: bytes, starts: Ints, name: str) -> None:
        self.name = name
        self.groups = _with_leads(sentences_of(data, starts))
        self.told: list[Told] = []
        modal = Modal()
        for group in self.groups:
            self.told.append(told(group, modal, name))
            modal = self.told[-1].after

    def __len__(self) -> int:
        return len(self.told)

    def __getitem__(self, k):  # type: ignore[no-untyped-def]
        return [t.block for t in self.told[k]] if isinstance(k, slice) else self.told[k].block

    def from_here(self, k: int, modal: Modal) -> None:
        """Say the blocks from one on anew, if it runs in another state than it was said in."""
        while k < len(self.told) and self.told[k].before != modal:
            self.told[k] = told(self.groups[k], modal, self.name)
            modal = self.told[k].after
            k += 1


def _with_leads(sentences: list[Sentence]) -> list[tuple[Sentence, ...]]:
    """Sentences one by one; those that G26 and G27 make a lead of together."""
    out: list[tuple[Sentence, ...]] = []
    i = 0
    while i < len(sentences):
        pair = tuple(sentences[i : i + 2])
        if len(pair) == 2 and (
            (_states_place(pair[0]) and 26 in pair[1].codes) or (27 in pair[0].codes and _states_place(pair[1]))
        ):
            out.append(pair)
        else:
            out.append(pair[:1])
        i += len(out[-1])
    return out


def _states_place(sentence: Sentence) -> bool:
    return not sentence.role and bool(set("XYH").intersection(sentence.letters)) and _plain_motion(sentence)


def _plain_motion(sentence: Sentence) -> bool:
    return set(sentence.codes) <= {*MOTIONS, *COMPENSATIONS, 17, 90, 91}


def told(group: tuple[Sentence, ...], modal: Modal, name: str) -> Told:
    """Say one block, or the two of a lead, in plain language.

    Parameters
    ----------
    group : tuple of Sentence
    modal : Modal
        What holds before it.
    name : str
        Of the program, for messages.
    """
    said = _said(group[0], modal) if len(group) == 1 else _lead(group, modal)
    # Of what cannot be said it is known that it moves, not where to.
    text = "L IX0" + "".join(_held_on(s) + _codes(s) for s in group) if said.odd else said.text
    block = read_block(text + group[-1].ending, group[0].line, group[-1].line, name)
    block.odd = said.odd or block.odd
    block.increments = bool(said.after.incremental)
    return Told(group, block, modal, said.after)


def _lead(group: tuple[Sentence, ...], modal: Modal) -> _Said:
    """G26 and G27: an arc that touches the contour and the straight way to it, as APPR LCT and DEP LCT have it."""
    approach = 26 in group[1].codes
    place, curve = group if approach else group[::-1]
    said = _said(place, modal)
    own = f"G{26 if approach else 27}"
    radius = next((p.value for p in curve.pieces if p.letter == "R"), "")
    kind = re.match(r"LP|L(?![A-Z])", said.text)
    if curve.odd or set(curve.letters) - set("GRF") or len(curve.codes) != 1 or not radius:
        said.odd = said.odd or f"{own} with other words than R and F"
    elif kind is None:
        said.odd = said.odd or f"{own} beside another motion than G00, G01, G10 or G11"
    elif approach and not {41, 42}.intersection(place.codes):
        said.odd = said.odd or f"{own} without G41 or G42 in the block before"
    elif not approach and 40 not in place.codes:
        said.odd = said.odd or f"{own} without G40 in the block behind"
    if said.odd or kind is None:
        return said
    polar = "P" if kind.group() == "LP" else ""
    rest = said.text[kind.end() :]
    if not approach:
        rest = re.sub(r" R0(?![\d.,])", "", rest)
    return replace(said, text=f"{'APPR' if approach else 'DEP'} {polar}LCT R{radius}{rest}")


def _said(sentence: Sentence, modal: Modal) -> _Said:
    bare = sentence.bare
    if sentence.role:
        return _of_program(sentence, modal)
    if not bare:
        return _Said(";" if sentence.stop < len(sentence.text.rstrip("* \t")) else "", "", modal)
    if bare.startswith("D"):
        return _Said(_function(bare), "", modal)
    if bare.startswith("Q"):
        return _Said(bare, "", modal)
    call = _CALL.fullmatch(bare)
    if call is not None:
        again = f" REP {call[2]}" if call[2] and int(call[2]) else ""
        return _Said(f"CALL LBL {call[1]}{again}", "", modal)
    if sentence.odd:
        return _Said("L", sentence.odd, modal)
    after = modal if sentence.distance is None else replace(modal, incremental=sentence.distance)
    text = _other(sentence, modal)
    return _motion(sentence, modal) if text is None else _Said(text, "", after)


def _of_program(sentence: Sentence, modal: Modal) -> _Said:
    bare = sentence.bare
    if sentence.role == "call":
        return _Said(f"CALL PGM {bare[1:]}", "", Modal(-1, None))
    name = re.sub(r"[ \t]*G[ \t]*7[01]$", "", bare[1:]).strip()
    unit = "INCH" if re.search(r"G[ \t]*70$", bare) else "MM"
    return _Said(f"{sentence.role.upper()} PGM {name} {unit}", "", modal)


def _function(bare: str) -> str:
    """D00 to D38 as FN functions."""
    found = _D.match(bare)
    if found is None:
        return "FN 18: Q0 = ?"
    number, name, first, second, third, rest = found.groups()
    n = int(number)
    first, second = ((v or "").replace(" ", "") for v in (first, second))
    if n in _SINGLE and name and first and not rest.strip():
        return f"FN {n}: {name} = {_SINGLE[n]}{first}"
    if n in _DYADIC and name and first and second and not rest.strip():
        return f"FN {n}: {name} = {first} {_DYADIC[n]} {second}"
    if n in _COMPARED and first and second and third:
        return f"FN {n}: IF {first} {_COMPARED[n]} {second} GOTO LBL {third.strip()}"
    return f"FN {n}: {name} = ?" if name else f"FN {n}: ?"


def _other(sentence: Sentence, before: Modal) -> str | None:
    """A block that is no motion; None for one that is."""
    codes, letters = set(sentence.codes), sentence.letters
    value = {p.letter: p.value for p in sentence.pieces}
    plain = codes - {90, 91}
    if 98 in codes and set(letters) <= set("GL"):
        return f"LBL {value.get('L', '')}"
    if codes & {99, 51}:
        return "TOOL DEF"
    if codes & {30, 31}:
        return "BLK FORM"
    if plain == {38} and set(letters) <= set("GM"):
        return "STOP" + _codes(sentence)
    if plain == {79}:
        return "CYCL CALL" + _codes(sentence)
    if "T" in letters and not set(letters) & set("XYZABCUVWHIJK") and plain <= {*_PLANES, *COMPENSATIONS}:
        axis = next((_PLANES[code] for code in sentence.codes if code in _PLANES), "")
        feed = f" F{value['F']}" if "F" in value else ""
        return f"TOOL CALL {value['T']} {axis}{feed}"
    cycle = next((c for c in sentence.codes if c in _CYCLES or c == 55 or 100 <= c < 1000), None)
    if cycle is not None:
        return _cycle(cycle, sentence)
    if plain <= {29, 17} and (29 in plain or set(letters) & set("IJK")) and set(letters) <= set("GIJK"):
        return "CC" + _pole(sentence, before)
    return None


def _pole(sentence: Sentence, modal: Modal) -> str:
    """Coordinates of a pole."""
    out, incremental = "", modal.incremental
    for piece in sentence.pieces:
        if piece.code in (90, 91) and piece.letter == "G":
            incremental = piece.code == 91
        elif piece.letter in POLE:
            out += f" {'I' if incremental else ''}{POLE[piece.letter]}{piece.value}"
    return out


def _cycle(code: int, sentence: Sentence) -> str:
    """The definition of a cycle."""
    own = next(p for p in sentence.pieces if p.code == code and p.letter == "G")
    words = sentence.text[own.stop : sentence.stop].upper()
    if code == 55 or 400 <= code < 500:
        return f"TCH PROBE {code} {words}"
    if 120 <= code < 200:
        return f"CYCL DEF {code - 100}.1 {words}"
    if code >= 200:
        return f"CYCL DEF {code} {words}"
    if code in (4, 72, 73):
        words = "".join(p.value for p in sentence.pieces if p.letter in "FH")
    return f"CYCL DEF {_CYCLES[code]}{words}"


def _codes(sentence: Sentence) -> str:
    """M words, with what belongs to them."""
    return "".join(" " + sentence.text[p.start : p.stop].upper() for p in sentence.pieces if p.letter == "M")


def _motion(sentence: Sentence, modal: Modal) -> _Said:
    """A block that moves, or states feed, compensation, M codes or what holds on."""
    codes = sentence.codes
    motions = [code for code in codes if code in MOTIONS]
    corner = next((code for code in codes if code in CORNERS), -1)
    motion = motions[-1] if motions else modal.motion
    odd = "" if len(motions) < 2 else f"G{motions[0]:02d} beside G{motions[1]:02d}"
    strange = [code for code in codes if code not in (*MOTIONS, *CORNERS, *COMPENSATIONS, 17, 90, 91)]
    odd = odd or (f"G{strange[0]:02d}" if strange else "")
    places: list[tuple[Piece, bool | None]] = []
    incremental = modal.incremental
    for piece in sentence.pieces:
        # They hold from where they stand in the block.
        if piece.letter == "G" and piece.code in (90, 91):
            incremental = piece.code == 91
        elif piece.letter in COORDINATES:
            places.append((piece, incremental))
    letters = "".join(p.letter for p, _ in places)
    held = [p.letter for p in sentence.pieces if p.letter in POLE]
    if held:
        odd = odd or _HELD.format(" and ".join(held))
    other = next((p for p in sentence.pieces if p.letter not in COORDINATES + "GFMSNIJK"), None)
    if other is not None:
        odd = odd or sentence.text[other.start : other.stop].upper()
    after = Modal(motions[-1] if motions else modal.motion, incremental)
    if corner >= 0:
        return _of_corner(sentence, corner, letters, odd, after)
    if any(counted is None for _, counted in places):
        odd = odd or "a place without G90 or G91 behind another program"
    if places and motion < 0:
        odd = odd or "a place without a motion code"
    kind, missing = _kind(motion, letters)
    odd = odd or missing
    words = []
    for piece, counted in sorted(places, key=lambda p: COORDINATES.index(p[0].letter)):
        more = "I" if counted else ""
        if piece.letter in "RH":
            name = {"R": "R" if kind == "CR" else more + "PR", "H": more + "PA"}[piece.letter]
        else:
            name = more + piece.letter
        words.append(name + piece.value)
    if kind in ("C", "CR", "CP") and motion in SENSES:
        words.append(SENSES[motion])
    rapid = " FMAX" if motion in (0, 10) and places else ""
    return _Said(" ".join([kind, *words]) + _held_on(sentence) + rapid + _codes(sentence), odd, after)


def _held_on(sentence: Sentence) -> str:
    """Compensation and feed."""
    out = [COMPENSATIONS[code] for code in sentence.codes if code in COMPENSATIONS]
    out += [f"F{p.value}" for p in sentence.pieces if p.letter == "F" and p.value]
    return "".join(" " + word for word in out)


def _of_corner(sentence: Sentence, code: int, letters: str, odd: str, after: Modal) -> _Said:
    """G24 and G25; they hold in their block only."""
    size = next((p.value for p in sentence.pieces if p.letter == "R"), "")
    if letters != "R" or not size:
        odd = odd or f"G{code} with other words than R"
    feed = "".join(f" F{p.value}" for p in sentence.pieces if p.letter == "F" and p.value)
    start = f"RND R{size}" if code == 25 else f"CHF {size}"
    return _Said(start + feed + _codes(sentence), odd, after)


def _kind(motion: int, letters: str) -> tuple[str, str]:
    """Plain language's block for a motion code and the letters of places beside it; what is wrong with them."""
    if not letters:
        return "L", ""
    if motion in POLAR and set(letters) & set("RH"):
        kind = POLAR[motion]
        odd = "X and Y beside R and H" if set(letters) & set("XY") else ""
        return kind, odd or ("R of a circle about the pole" if kind == "CP" and "R" in letters else "")
    if "H" in letters:
        return "L", "H without a polar motion code"
    if motion in (*LINES, 10, 11):
        if motion in POLAR and set(letters) & set("XY"):
            return "L", f"X and Y under G{motion}"
        return "L", "R of a straight line" if "R" in letters else ""
    if motion in POLAR or not set(letters) & set("XY"):
        return "L", "an arc without its end"
    if motion in TANGENTS:
        return "CT", "R of a tangent arc" if "R" in letters else ""
    return "CR" if "R" in letters else "C", ""
