# SPDX-License-Identifier: LGPL-2.1-or-later
"""MSR files of on-machine inspection: ``G800`` nominal point, ``G801`` ball centre, ``G330`` orientation.

Written by the inspection macros of PowerInspect and Fusion through DPRNT, hence words that run together. The
surface point is the ball centre less R times the nominal normal. After ``G330 A B C X Y Z`` points, normals and
nominals p are those of a turned workplane; ``Rz(C) Ry(B) Rx(A) p + (X, Y, Z)``, about fixed axes and with angles
in degrees, brings them back. Between them may stand what probing cycles print, COMPONENT, SIZE and POSN blocks, which
is left out.
"""

from __future__ import annotations

import math
import re
from array import array

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.errors import FormatError
from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement

from .decimal_columns import decimal_words
from .decoding import beginning
from .parts import parts_by_repetition, point_keys, rows_of_part
from .source import LONGEST_LINE, MM_PER_INCH, Source, shown

_RECOGNISED = re.compile(rb"(?:^|[\r\n\x00])[ \t]*(?:START[ \t]*[\r\n]|G80[01][ \t]*N[ \t]*\d)", re.IGNORECASE)
_WORD = re.compile(r"([A-Z])[ \t]*([+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?)[ \t]*", re.ASCII)
_CODE = re.compile(r"G[ \t]*(800|801|330|331)(?!\d)[ \t]*", re.ASCII)
_REMARK = re.compile(r"[A-Z]{4,}(?![A-Z])|-{3,}$|ANG\s|\+{3,}[A-Z ]+\+{3,}", re.ASCII)
_FEATURE = re.compile(r"COMPONENT\s+NO\b")
_CYCLES = re.compile(rb"(?:^|[\r\n])[ \t]*COMPONENT[ \t]+NO\b", re.IGNORECASE)
_POINT = re.compile(rb"(?:^|[\r\n\x00])[ \t]*G[ \t]*80[01][ \t]*N", re.IGNORECASE)
_HEAD = re.compile(rb"\s*START[ \t]*[\r\n]+[ \t]*(?:RESULTSFILE|DOCUMENTID|MODELVERSION|TOOLPATH|END\b)", re.IGNORECASE)
_COMMENT = re.compile(r";.*|\([^()]*\)")
_CONTROLS = b"\x00\x11\x12\x13\x14\x1a"
"""What serial lines put around a print-out: device controls, fill bytes, end of file."""

_LARGEST = 1e9
_SAME_NOMINAL = 1e-5
"""Nominals no farther apart than this, in the file's unit, are one: they were printed alike."""
_MEANINGS = {
    "N": phrase("number of the point"),
    "X": "coordinate",
    "Y": "coordinate",
    "Z": "coordinate",
    "I": "normal",
    "J": "normal",
    "K": "normal",
    "R": phrase("radius of the ball"),
}


def recognises(data: bytes) -> bool:
    """Whether a file holds G800 or G801 lines, or begins as results do and is not of probing cycles alone."""
    head = beginning(data, 65536)
    if _CYCLES.search(head) and not _POINT.search(data):
        return False
    if _HEAD.match(head):
        return True
    found = _RECOGNISED.search(data[:65536]) or _RECOGNISED.search(head)
    return bool(found and (re.search(rb"G\s*(?:800|801|330)", head, re.IGNORECASE) or b"MODELVERSION" in head))


def read(source: Source) -> Measurement:
    """Ball centres, nominal points and nominal normals of an MSR file, in the frame that G330 leads back to.

    Parameters
    ----------
    source : Source
        The file says that its points are ball centres and gives the radius; its unit is mm unless the caller says
        otherwise.

    Returns
    -------
    Measurement

    Raises
    ------
    FormatError
        If a line is spoilt, or G800 and G801 do not come in pairs of one number; names the line.
    UsageError
        If the caller contradicts the file.
    """
    _refuse_foreign_bytes(source)
    reading = _Reading(source)
    for number, piece in source.pieces(drop=_CONTROLS):
        lines = piece.split("\n")
        # The block may begin or end between the two lines of a point.
        begin = 0 if reading.waiting is None else 1
        end = len(lines) - (len(lines) - begin) % 2
        reading.each(number, lines[:begin])
        if not reading.pairs(number + begin, lines[begin:end]):
            reading.each(number + begin, lines[begin:end])
        reading.each(number + end, lines[end:])
    return reading.measurement()


def _refuse_foreign_bytes(source: Source) -> None:
    """Name the line of numbers in which a byte is not ASCII: it was spoilt on the way."""
    data = source.data
    if data.isascii() or data[:2] in (b"\xff\xfe", b"\xfe\xff") or data[:3] == b"\xef\xbb\xbf" or b"\x00" in data:
        return
    for number, line in enumerate(re.split(rb"\r\n|\r|\n", data), 1):
        if not line.isascii() and re.match(rb"\s*\W{0,3}G\W*[38]\W*[03]", line, re.IGNORECASE):
            spoilt = next(b for b in line if b > 127)
            raise source.error(
                phrase("byte 0x{:02X} among the numbers: transmission has spoilt the line", spoilt), number
            )


class _Reading:
    """State of reading: the transform in force, the nominal that waits for its measured point, what was read."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.waiting: tuple[int, int, list[float]] | None = None
        self.numbers = array("q")
        self.lines = array("q")
        self.values = array("d")
        self.blocks: list[tuple[int, Floats | None, Floats]] = [(0, None, np.zeros(3))]
        self.offsets = 0
        self.features = 0
        """Features of probing cycles."""
        self.ended = False
        self.starts: list[int] = []
        """Points read before each START or END."""

    def each(self, number: int, lines: list[str]) -> None:
        """Take lines one by one, the first of them being line `number`."""
        for further, raw in enumerate(lines):
            if len(raw) > LONGEST_LINE:
                raise self._error(
                    phrase("a line of {} characters: no MSR file, or damaged", len(raw)), number + further
                )
            self.line(number + further, raw)

    def pairs(self, number: int, lines: list[str]) -> bool:
        """Take lines that are nothing but pairs of G800 and G801 with the same letters; False where they are not."""
        words = decimal_words("\n".join(lines).upper()) if self.waiting is None and lines else None
        if words is None:
            return False
        counts = np.diff(words.first)
        nominal, measured = int(counts[0]), int(counts[1])
        if (counts[::2] != nominal).any() or (counts[1::2] != measured).any():
            return False
        whole = nominal + measured
        letters, values = words.letters.reshape(-1, whole), words.values.reshape(-1, whole)
        if (letters != letters[0]).any() or (words.digits.reshape(-1, whole)[:, [0, nominal]] != 3).any():
            return False
        names = letters[0].tobytes().decode("ascii")
        own, touched = names[1:nominal], names[nominal + 1 :]
        if names[0] + names[nominal] != "GG" or (values[:, [0, nominal]] != (800, 801)).any():
            return False
        if any(len(set(row)) < len(row) for row in (own, touched)) or not set("NXYZIJK") <= set(own):
            return False
        if not set("NXYZR") <= set(touched) or (np.abs(values) > _LARGEST).any():
            return False
        places = [1 + own.index(c) for c in "XYZIJK"] + [nominal + 1 + touched.index(c) for c in "XYZR"]
        numbers, again = values[:, 1 + own.index("N")], values[:, nominal + 1 + touched.index("N")]
        rows = values[:, places]
        if (numbers != again).any() or (numbers < 0).any() or (numbers % 1 != 0).any() or (rows[:, 9] < 0).any():
            return False
        if "O" in own:
            self.offsets += int(np.count_nonzero(values[:, 1 + own.index("O")]))
        self.values.frombytes(np.ascontiguousarray(rows).tobytes())
        self.numbers.frombytes(numbers.astype(np.int64).tobytes())
        self.lines.frombytes((number + 1 + 2 * np.arange(len(rows), dtype=np.int64)).tobytes())
        return True

    def line(self, number: int, raw: str) -> None:
        text = _COMMENT.sub("", raw).strip().upper() if ";" in raw or "(" in raw else raw.strip().upper()
        if not text or text == "%":
            return
        code = _CODE.match(text)
        if code is None:
            self._other(number, text)
        elif code[1] == "800":
            self._nominal(number, text[code.end() :])
        elif code[1] == "801":
            self._measured(number, text[code.end() :])
        else:
            self._refuse_waiting(number)
            if code[1] == "330":
                self._transform(number, text[code.end() :])

    def _other(self, number: int, text: str) -> None:
        self._refuse_waiting(number)
        if text == "END":
            self.ended = True
            self.starts.append(len(self.lines))
        elif text == "START":
            self.ended = False
            self.starts.append(len(self.lines))
            self._turn(None, np.zeros(3))
        elif _FEATURE.match(text):
            self.features += 1
        elif not _REMARK.match(text):
            raise self._error(
                phrase("{} is no line of an MSR file: transmission may have spoilt it", shown(text)), number
            )

    def _nominal(self, number: int, text: str) -> None:
        self._refuse_waiting(number)
        words = self._words(number, text, "G800", "NXYZIJK")
        self.offsets += words.get("O", 0.0) != 0.0
        self.waiting = (number, self._index(number, words), [words[c] for c in "XYZIJK"])

    def _measured(self, number: int, text: str) -> None:
        if self.waiting is None:
            raise self._error(phrase("G801 without its G800 line: a line was lost, send the results again"), number)
        words = self._words(number, text, "G801", "NXYZR")
        index = self._index(number, words)
        nominal_line, nominal_index, nominal = self.waiting
        if index != nominal_index:
            raise self._error(
                phrase(
                    "G801 of point {} follows G800 of point {} in line {}: lines were lost",
                    index,
                    nominal_index,
                    nominal_line,
                ),
                number,
            )
        if words["R"] < 0:
            raise self._error(phrase("ball radius R{:g} is negative", words["R"]), number)
        self.values.extend(nominal)
        self.values.extend([words[c] for c in "XYZR"])
        self.numbers.append(index)
        self.lines.append(number)
        self.waiting = None

    def _transform(self, number: int, text: str) -> None:
        words = self._words(number, text, "G330", "ABC")
        shift = np.array([words.get(c, 0.0) for c in "XYZ"])
        self._turn(_fixed_axes(words["A"], words["B"], words["C"]), shift)

    def _turn(self, rotation: Floats | None, shift: Floats) -> None:
        self.blocks.append((len(self.lines), rotation, shift))

    def _words(self, number: int, text: str, code: str, needed: str) -> dict[str, float]:
        words: dict[str, float] = {}
        position = 0
        while position < len(text):
            found = _WORD.match(text, position)
            if found is None:
                raise self._error(phrase("{}: {} is no letter with a number", code, shown(text[position:])), number)
            if found[1] in words:
                raise self._error(phrase("{} has the letter {} twice: two lines ran together", code, found[1]), number)
            words[found[1]] = float(found[2])
            if abs(words[found[1]]) > _LARGEST:
                raise self._error(
                    phrase("{}: {}{} is no length, number or angle", code, found[1], shown(found[2])), number
                )
            position = found.end()
        for letter in needed:
            if letter not in words:
                what = _MEANINGS.get(letter, "angle")
                raise self._error(phrase("{} lacks {}, {}: the line is incomplete", code, letter, what), number)
        return words

    def _index(self, number: int, words: dict[str, float]) -> int:
        index = words["N"]
        if not (index >= 0 and index == math.floor(index)):
            raise self._error(phrase("N{:g} is no number of a point", index), number)
        return int(index)

    def _refuse_waiting(self, number: int) -> None:
        if self.waiting is not None:
            line, index, _ = self.waiting
            raise self._error(
                phrase("G801 of point {} is missing after its G800 in line {}: send the results again", index, line),
                number,
            )

    def _error(self, message: str, number: int) -> FormatError:
        return self.source.error(message, number)

    def measurement(self) -> Measurement:
        source = self.source
        if self.waiting is not None:
            line, index, _ = self.waiting
            raise self._error(phrase("G801 of point {} is missing: the file was cut off after this line", index), line)
        values = np.frombuffer(self.values, dtype=np.float64).reshape(-1, 10)
        unit = source.unit(None)
        nominal, normals, points, radii = values[:, :3], values[:, 3:6], values[:, 6:9], values[:, 9]
        if unit == "inch":
            radii = radii * MM_PER_INCH
        if len(radii):
            stated = float(radii[0])
            asked = source.ball_radius(centres=True if stated else None, radius=stated or None)
            radii = radii if stated or not asked else np.full(len(radii), asked)
        else:
            only = phrase(", only {} features of probing cycles", self.features) if self.features else ""
            raise source.error(
                phrase("no measured points G800 and G801 in the file{}: the inspection printed none", only)
            )
        notes = self._apply(nominal, normals, points)
        if self.features:
            notes.append(
                phrase("{} features of probing cycles left out: COMPONENT, SIZE and POSN blocks", self.features)
            )
        if self.offsets:
            notes.append(phrase("{} points have a nominal offset O, which is not applied", self.offsets))
        if not self.ended:
            notes.append(phrase("no END: points may be missing at the end of the file"))
        chosen = self._chosen(nominal)
        return source.measurement(
            "msr", points[chosen], np.array(self.lines)[chosen], ball_radius=radii[chosen], unit=unit,
            normals=normals[chosen], nominal=nominal[chosen],
            elements=[f"N{n}" for n in np.array(self.numbers)[chosen]], notes=notes,
        )  # fmt: skip

    def _chosen(self, nominal: Floats) -> Bools:
        """Points of the part that the caller wants: a part ends where its points begin again in another block."""
        lines, numbers = np.array(self.lines, dtype=np.int64), np.array(self.numbers, dtype=np.int64)
        blocks = np.searchsorted(np.array(self.starts, dtype=np.int64), np.arange(len(lines)), side="right")
        part_of, twice = parts_by_repetition(point_keys(numbers, nominal, _SAME_NOMINAL), blocks)
        if twice is not None:
            first, again = twice
            raise self._error(
                phrase(
                    "point N{} with the same nominal is there twice, first in line {}: keep one of them",
                    numbers[again],
                    lines[first],
                ),
                int(lines[again]),
            )
        return rows_of_part(self.source, lines, part_of)

    def _apply(self, nominal: Floats, normals: Floats, points: Floats) -> list[str]:
        """Bring every block of points back from the workplane in force. In place."""
        turned = shifted = 0
        ends = [begin for begin, _, _ in self.blocks[1:]] + [len(points)]
        with np.errstate(over="ignore", invalid="ignore"):
            for (begin, rotation, shift), end in zip(self.blocks, ends, strict=True):
                if rotation is None or begin == end:
                    continue
                for vectors, by in ((nominal, shift), (points, shift), (normals, 0.0)):
                    vectors[begin:end] = vectors[begin:end] @ rotation.T + by
                turned += 0 if np.array_equal(rotation, np.eye(3)) else end - begin
                shifted += end - begin if shift.any() else 0
        notes: list[str] = []
        if turned:
            notes.append(phrase("{} points turned back by G330", turned))
        if shifted:
            notes.append(phrase("{} points shifted by G330, after turning: compare with another export once", shifted))
        return notes


def _fixed_axes(a: float, b: float, c: float) -> Floats:
    """Rotation Rz(c) Ry(b) Rx(a), (3, 3); angles in degrees about the fixed axes."""
    (ca, sa), (cb, sb), (cc, sc) = ((math.cos(math.radians(t)), math.sin(math.radians(t))) for t in (a, b, c))
    return np.array(
        [
            [cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa],
            [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa],
            [-sb, cb * sa, cb * ca],
        ]
    )
