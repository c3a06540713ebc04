# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one block after another does to position, pole, feed, compensation and parameters, and the moves it makes."""

from __future__ import annotations

import cmath
import copy
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from millcorr.errors import FormatError
from millcorr.nc.arcs import RADIUS_TOLERANCE, RADIUS_TOLERANCE_RELATIVE
from millcorr.nc.codes import INCH
from millcorr.nc.toolpath import Compensation, Kind, Plane, named_tool

from .blocks import APPROACHES, CORNERS, DEPARTURES, MOVING, SILENT, Block, Word
from .contour import Element, Impossible, Lead, angle_between, by_radius, chamfered, rounded, tangential
from .parameters import Parameters

AXES = "XYZ"
ENDS = (2, 30)
_MACHINE_FRAME = frozenset((91, 92))
_FRAMES = {
    128: "M128 controls the tool centre point",
    114: "M114 compensates the machine geometry",
    144: "M144 compensates the machine kinematics",
}
_FRAMES_OFF = {129: 128, 115: 114, 145: 144}
_CALLS = frozenset((89, 99))
_OTHER_AXES = frozenset("ABCUVW")
_DRILLING = (1, 2, 17, 18, *range(200, 208), 209, 240, 241)
"""Cycles that end over the place where they began."""
_TURNED_FRAMES = {
    "8": "cycle 8 mirrors the frame",
    "10": "cycle 10 rotates the frame",
    "11": "cycle 11 scales the frame",
    "19": "cycle 19 tilts the plane",
    "26": "cycle 26 scales the frame",
    "27": "cycle 27 works on a cylinder",
    "28": "cycle 28 works on a cylinder",
    "29": "cycle 29 works on a cylinder",
}
_QUIET_CYCLES = ("9", "13", "32", "14", "20", "21", "22", "23", "24", "25", "270", "271", "272", "247", "7")
_FREE = ("FL", "FLT", "FC", "FCT", "FPOL", "FSELECT")
_COMPENSATIONS = {"0": Compensation.OFF, "L": Compensation.LEFT, "R": Compensation.RIGHT}


@dataclass(slots=True)
class Row:
    """A move, as a row of a `Toolpath`."""

    kind: Kind
    start: list[float]
    end: list[float]
    element: Element | None
    plane: Plane
    feed: float
    line: int
    compensation: int
    tool: int

    @property
    def centre(self) -> list[float]:
        """Centre of an arc, NaN for other moves."""
        out = [math.nan] * 3
        if self.kind == Kind.ARC and self.element is not None and self.element.centre is not None:
            a, b, c = self.plane.axes
            out[a], out[b], out[c] = self.element.centre.real, self.element.centre.imag, self.start[c]
        return out

    @property
    def sweep(self) -> float:
        """Angle of an arc; NaN for one that is not known, 0 for other moves."""
        if self.kind != Kind.ARC:
            return 0.0
        return math.nan if self.element is None else self.element.sweep


class Machine:
    """The control's state, moved on block by block.

    Parameters
    ----------
    name : str
        Of the program, for messages.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self.at = 0
        """Index of the block that runs, as moves and reasons are filed under."""
        self.scale = 1.0
        self.position = [math.nan] * 3
        self.trimmed: complex | None = None
        """Where in the plane the next element begins, where a corner before it was rounded or cut off."""
        self.pole = [math.nan] * 3
        self.polar_radius = math.nan
        self.feed = math.nan
        self.feed_word = math.nan
        self.tool_feed = math.nan
        self.rapid = False
        self.per_turn = False
        self.compensation = 0
        self.tool = -1
        self.plane = Plane.XY
        self.sense = ""
        self.direction = 0j
        self.parameters = Parameters()
        self.row: Row | None = None
        """The last contour element, which a corner behind it shortens."""
        self.cycle = ""
        self.frames: dict[str, tuple[int, str]] = {}
        self.reasons: list[str] = []
        """Why the block that was carried out last cannot be corrected."""
        self.ended: list[tuple[int, str]] = []
        """Frames that the block has ended: since which line, and why they were none to correct in."""

    def copy(self) -> Machine:
        """The same state, to look ahead with."""
        out = copy.copy(self)
        out.position, out.pole = list(self.position), list(self.pole)
        out.parameters = self.parameters.copy()
        out.frames, out.reasons, out.ended = dict(self.frames), [], []
        return out

    # -- places --------------------------------------------------------------------------------------------

    def _here(self) -> complex:
        a, b, _ = self.plane.axes
        return complex(self.position[a], self.position[b])

    def _error(self, block: Block, message: str) -> FormatError:
        return FormatError(message, self.name, block.first + 1)

    def _value(self, word: Word, block: Block) -> float:
        """Number of a word; NaN, and the reason, where it is not known."""
        if not word.value:
            raise self._error(block, f"'{word.name}' has no number")
        value = self.parameters.number(word.value)
        if math.isnan(value):
            bare = word.value.lstrip("+-")
            since = self.parameters.origin.get(bare)
            where = "" if since is None else f", set in line {since + 1}"
            self.reasons.append(f"{word.name} comes from {bare}{where}, whose value is not known on reading")
        return value

    def _number(self, block: Block, name: str) -> float | None:
        word = block.find(name)
        if word is None or not word.value:
            return None
        return self._value(word, block)

    def _target(self, block: Block) -> list[float]:
        """End in mm by the X, Y and Z of a block; where it is silent, where the tool is."""
        out = list(self.position)
        seen = set()
        for word in block.words:
            if word.name not in AXES:
                continue
            if word.name in seen:
                raise self._error(block, f"two {word.name} words on one line: keep the one that is meant")
            seen.add(word.name)
            k = AXES.index(word.name)
            value = self._value(word, block) * self.scale
            out[k] = value + (self.position[k] if word.incremental else 0.0)
        return out

    def _polar(self, block: Block) -> tuple[complex, float]:
        """Place by PR and PA about the pole, and the increment of the angle in rad; NaN without one."""
        a, b, _ = self.plane.axes
        pole, here = complex(self.pole[a], self.pole[b]), self._here()
        if cmath.isnan(pole):
            raise Impossible("no pole CC is stated before")
        at, angle = abs(here - pole), cmath.phase(here - pole) if here != pole else 0.0
        radius_word, angle_word = block.find("PR"), block.find("PA")
        turned = math.nan
        if radius_word is not None:
            value = self._value(radius_word, block) * self.scale
            radius = value + (at if radius_word.incremental else 0.0)
        else:
            radius = at
            if block.kind in ("LP", "CTP") and abs(self.polar_radius - at) > 1e-6:
                raise Impossible("PR is not stated, and the last one is not where the tool is")
        if angle_word is not None:
            value = math.radians(self._value(angle_word, block))
            turned = value if angle_word.incremental else math.nan
            angle = value + (angle if angle_word.incremental else 0.0)
        if math.isnan(radius + angle):
            raise Impossible("the polar position is not known")
        self.polar_radius = radius
        return pole + cmath.rect(radius, angle), turned

    def _anticlockwise(self, block: Block) -> bool:
        word = block.find("DR")
        if word is not None:
            self.sense = word.value
        if not self.sense:
            raise self._error(block, "an arc needs its sense of rotation: state DR+ or DR-")
        return self.sense == "+"

    def start(self) -> list[float]:
        """Where the next move starts: the tool's place, or where a corner has left it."""
        out = list(self.position)
        if self.trimmed is not None:
            a, b, _ = self.plane.axes
            out[a], out[b] = self.trimmed.real, self.trimmed.imag
        return out

    # -- contour elements ----------------------------------------------------------------------------------

    def _element(self, block: Block) -> tuple[Element, list[float]]:
        """Contour element of a block from the programmed place on, and its end."""
        end = self._target(block)
        a, b, _ = self.plane.axes
        here = self._here()
        turned = math.nan
        if block.kind in ("LP", "CTP", "CP"):
            place, turned = self._polar(block)
            end[a], end[b] = place.real, place.imag
        there = complex(end[a], end[b])
        if block.kind in ("L", "", "LP"):
            return Element(here, there), end
        if cmath.isnan(here) or cmath.isnan(there):
            raise Impossible("arc from or to a place that is not known: state the position before it")
        if block.kind in ("CT", "CTP"):
            if self.trimmed is not None:
                raise Impossible("an arc on the tangent behind a rounded corner")
            return tangential(here, there, self.direction), end
        anticlockwise = self._anticlockwise(block)
        if block.kind == "CR":
            radius = self._number(block, "R")
            if radius is None:
                raise self._error(block, "CR needs its radius R")
            return by_radius(here, there, radius * self.scale, anticlockwise), end
        centre = complex(self.pole[a], self.pole[b])
        if cmath.isnan(centre):
            raise Impossible("no centre CC is stated before")
        first, last = abs(here - centre), abs(there - centre)
        if max(first, last) == 0:
            raise self._error(block, "arc of radius zero: correct CC")
        if abs(first - last) > max(RADIUS_TOLERANCE, RADIUS_TOLERANCE_RELATIVE * max(first, last)):
            raise self._error(block, "arc whose end is not on its circle: correct it or its CC")
        if not math.isnan(turned):
            if turned == 0 or (turned > 0) != anticlockwise:
                raise Impossible("IPA and DR of CP contradict each other")
            return Element(here, there, centre, turned), end
        return Element(here, there, centre, angle_between(here, there, centre, anticlockwise)), end

    def _next(self, blocks: Sequence[Block], k: int) -> Element:
        """The contour element behind a block, from the place where the tool is."""
        ahead = self.copy()
        ahead.trimmed = None
        for i in range(k + 1, len(blocks)):
            block = blocks[i]
            if block.moves:
                if block.odd or block.kind in ("CT", "CTP"):
                    break
                element, _ = ahead._element(block)
                if cmath.isnan(element.end) or abs(element.end - element.start) <= 1e-9 and element.sweep == 0:
                    break
                return element
            if block.kind not in (*SILENT, "L", "") or (block.kind == "LBL" and block.rest == "0"):
                break
            ahead.silent(block)
        raise Impossible(f"no contour element that could be followed stands behind {blocks[k].kind}")

    # -- words of a motion ---------------------------------------------------------------------------------

    def _take_feed(self, block: Block) -> tuple[bool, float]:
        """Whether a block runs in rapid traverse, and its feed in mm/s; takes over what holds on."""
        for word in block.words:
            if word.name in ("FU", "FZ", "FT"):
                self.feed = self.feed_word = math.nan
            if word.name != "F" or not word.value:
                continue
            if word.value == "MAX":
                return True, math.nan
            if word.value == "AUTO":
                value = self.tool_feed
            else:
                value = self.parameters.number(word.value)
            self.feed_word, self.feed = value, self.speed(value)
        return False, math.nan if self.per_turn else self.feed

    def speed(self, word: float) -> float:
        """Feed in mm/s of an F word: mm/min, or tenths of an inch a minute."""
        return word * (INCH / 10 if self.scale != 1.0 else 1.0) / 60.0

    def _codes(self, block: Block) -> list[int]:
        if "M" not in block.names:
            return []
        found = (self.parameters.number(w.value) for w in block.words if w.name == "M" and w.value and w.value != "MAX")
        return [int(value) for value in found if math.isfinite(value)]

    # -- blocks --------------------------------------------------------------------------------------------

    def silent(self, block: Block) -> bool:
        """Carry out a block that neither moves nor calls; False for one that is not known."""
        kind = block.kind
        if kind == "CC":
            self._take_pole(block)
        elif kind in ("Q", "FN"):
            text = block.rest
            if not self.parameters.carry_out(text, block.first):
                return False
        elif kind == "TOOL CALL":
            self._take_tool(block)
        elif kind == "CYCL DEF":
            self._take_cycle(block)
        elif kind not in SILENT:
            return False
        return True

    def _take_pole(self, block: Block) -> None:
        a, b, _ = self.plane.axes
        stated = {AXES.index(w.name): w for w in block.words if w.name in AXES}
        if block.odd or set(stated) - {a, b}:
            self.reasons.append(f"CC with '{block.odd or 'another axis'}' is not followed")
        if not stated:
            self.pole = list(self.position)
        else:
            # Controls differ on what a single coordinate leaves of the pole before.
            pole = [math.nan] * 3
            for k, word in stated.items():
                value = self._value(word, block) * self.scale
                pole[k] = value + (self.position[k] if word.incremental else 0.0)
            self.pole = pole
        self.polar_radius = math.nan

    def _take_tool(self, block: Block) -> None:
        text = block.rest
        quoted = re.match(r'"([^"]*)"', text)
        numbered = re.match(r"(\d+)(?:\.\d+)?|(Q[LR]?\d+)", text)
        if quoted is not None:
            tool = named_tool(quoted[1].encode("latin-1"))
            text = text[quoted.end() :]
        elif numbered is not None:
            value = float(numbered[1]) if numbered[1] else self.parameters.number(numbered[2])
            tool = int(value) if math.isfinite(value) else -1
            text = text[numbered.end() :]
        else:
            tool = self.tool
        if tool != self.tool:
            # Another length: the height that is shown is another one.
            self.position[2] = math.nan
        self.tool = tool
        axis = re.search(r"(?:^|[ \t])([XYZ])(?=[ \t]|S|F|$)", text)
        if axis is not None:
            self.plane = {"Z": Plane.XY, "Y": Plane.ZX, "X": Plane.YZ}[axis[1]]
        feed = re.search(r"(?<![A-Z])F[ \t]*(\d+(?:[.,]\d*)?|Q[LR]?\d+)", text)
        if feed is not None:
            self.tool_feed = self.parameters.number(feed[1])
            self.feed_word, self.feed = self.tool_feed, self.speed(self.tool_feed)

    def _take_cycle(self, block: Block) -> None:
        """Definition of a cycle: parameters, what a call will run, frames."""
        text = block.rest
        found = re.match(r"(\d+)(?:\.(\d+))?", text)
        if found is None:
            self.reasons.append("a cycle that is not known")
            return
        number, part = found[1], found[2]
        self.parameters.in_cycle(text, block.first)
        if number in _TURNED_FRAMES:
            if part == "0":
                return
            arguments = text[found.end() :]
            values = [float(v.replace(",", ".")) for v in re.findall(r"[-+]?\d+(?:[.,]\d*)?", arguments)]
            neutral = {"8": not re.search(r"[XYZ]", arguments), "11": values == [1.0], "26": set(values) <= {1.0}}
            on = not neutral.get(number, not any(values) and "Q" not in arguments)
            self._frame(f"cycle {number}", on, _TURNED_FRAMES[number])
        elif number in ("7", "247"):
            self.lose()
        elif number == "12":
            self.cycle = "12"
        elif number not in _QUIET_CYCLES:
            self.cycle = number

    def _frame(self, key: str, on: bool, reason: str) -> None:
        if on:
            self.frames.setdefault(key, (self.at, reason))
            self.reasons.append(reason)
        elif key in self.frames:
            self.ended.append(self.frames.pop(key))
        else:
            return
        self.lose()

    def lose(self) -> None:
        """The position is not known until it is stated."""
        self.position = [math.nan] * 3
        self.trimmed, self.row, self.direction = None, None, 0j

    def run_cycle(self) -> None:
        """A call of the cycle that is defined: where it ends."""
        kept = self.cycle.isdigit() and int(self.cycle) in _DRILLING
        x, y = self.position[:2]
        self.lose()
        if kept:
            self.position[:2] = [x, y]
        if self.cycle == "12":
            self.parameters.forget()

    def execute(self, blocks: Sequence[Block], k: int, at: int | None = None) -> list[Row]:
        """Carry out a block: its moves. `reasons` tells why they cannot be corrected.

        Parameters
        ----------
        blocks : sequence of Block
            What a corner or an approach needs of what comes behind is looked up here.
        k : int
            Which of them.
        at : int, optional
            Index of this run of it; by default that of its line.

        Returns
        -------
        list of Row
        """
        block = blocks[k]
        self.at = block.first if at is None else at
        self.reasons, self.ended = [], []
        kind = block.kind
        if kind not in MOVING:
            if not self.silent(block):
                self._other(block)
            return []
        codes = self._codes(block)
        for code in codes:
            if code in _FRAMES:
                self._frame(f"M{code}", True, _FRAMES[code])
            elif code in _FRAMES_OFF:
                self._frame(f"M{_FRAMES_OFF[code]}", False, "")
            elif code in (136, 137):
                self.per_turn = code == 136
        if block.odd or kind == "LN":
            what = "LN with its surface normal" if kind == "LN" else f"'{block.odd}'"
            rows = self._not_followed(block, f"{what} is not followed")
        elif not _MACHINE_FRAME.isdisjoint(codes):
            rows = self._in_machine_frame(block)
        else:
            try:
                rows = self._motion(blocks, k)
            except Impossible as error:
                rows = self._not_followed(block, str(error))
        if not _OTHER_AXES.isdisjoint(block.names):
            self.reasons.append("a rotary or parallel axis moves with this line")
        if 140 in codes:
            self.position[2] = math.nan
        if not _CALLS.isdisjoint(codes):
            self.run_cycle()
        return rows

    def _other(self, block: Block) -> None:
        """A block that is passed through: what it may do to the position."""
        kind, text = block.kind, block.rest
        if kind == "CYCL CALL":
            self.run_cycle()
            self.reasons.append("a cycle is called")
        elif kind == "TCH PROBE":
            self.parameters.in_cycle(text, block.first)
            for name in [n for n in self.parameters.values if n.startswith("Q1") and len(n) == 4]:
                self.parameters.put(name, math.nan, block.first)
            self.lose()
            self.reasons.append("a probing cycle runs")
        elif kind in ("CALL PGM", "PGM"):
            self.lose()
            self.parameters.forget()
            self.feed = self.feed_word = math.nan
            self.pole = [math.nan] * 3
            self.reasons.append("another program is called")
        elif kind == "PLANE":
            self._frame("PLANE", not text.startswith("RESET"), "PLANE tilts the plane")
        elif kind == "TRANS":
            self.lose()
        elif kind == "FUNCTION" and text.startswith(("TCPM", "RESET TCPM")):
            self._frame("TCPM", text.startswith("TCPM"), "TCPM controls the tool centre point")
        elif kind in _FREE:
            self.lose()
            self.reasons.append("free contour programming (FK) is not followed")
        elif kind in ("BEGIN PGM", "END PGM", "CALL LBL"):
            pass
        elif kind == "FUNCTION" and text.startswith(("FEED", "MODE MILL", "PROG PATH IS CONTOUR", "DWELL", "S-PULSE")):
            pass
        else:
            self.lose()
            self.reasons.append(f"{kind} is not followed")

    def _not_followed(self, block: Block, reason: str) -> list[Row]:
        """Moves of a block whose way is not known, only, where stated, its end."""
        self.reasons.append(reason)
        rapid, feed = self._take_feed(block)
        self._take_compensation(block)
        start = list(self.position)
        a, b, _ = self.plane.axes
        if not block.moves and block.kind == "":
            return []
        end = self._target(block)
        if block.kind not in ("L", "", "LN", "C", "CR", "CT"):
            end[a] = end[b] = math.nan
        elif any(w.incremental for w in block.words):
            end = [math.nan] * 3
        if block.kind in DEPARTURES:
            self.compensation = 0
        self.lose()
        self.position = list(end)
        kind = Kind.RAPID if rapid else Kind.LINE
        return [self._row(kind, start, end, None, feed, block)]

    def _in_machine_frame(self, block: Block) -> list[Row]:
        rows = self._not_followed(block, "M91 or M92 moves in the machine frame")
        for k, axis in enumerate(AXES):
            if block.find(axis) is not None:
                self.position[k] = math.nan
                for row in rows:
                    row.end[k] = math.nan
        return rows

    def _take_compensation(self, block: Block) -> None:
        word = block.find("COMP")
        if word is None:
            return
        if word.value in "+-":
            self.reasons.append(f"R{word.value} lengthens or shortens the way by the cutter's radius")
        else:
            self.compensation = _COMPENSATIONS[word.value]

    def _row(
        self, kind: Kind, start: list[float], end: list[float], element: Element | None, feed: float, block: Block
    ) -> Row:
        return Row(
            kind,
            list(start),
            list(end),
            element,
            self.plane,
            math.nan if kind == Kind.RAPID else feed,
            self.at,
            int(self.compensation),
            self.tool,
        )

    def _motion(self, blocks: Sequence[Block], k: int) -> list[Row]:
        block = blocks[k]
        if block.kind in CORNERS:
            return self._corner(blocks, k)
        if block.kind in APPROACHES:
            return self._approach(blocks, k)
        if block.kind in DEPARTURES:
            return self._departure(block)
        if not block.moves:
            self._take_feed(block)
            self._take_compensation(block)
            return []
        element, end = self._element(block)
        rapid, feed = self._take_feed(block)
        self._take_compensation(block)
        start = list(self.position)
        if self.trimmed is not None:
            a, b, _ = self.plane.axes
            start[a], start[b] = self.trimmed.real, self.trimmed.imag
            element = element.cut_at_start(self.trimmed)
        kind = Kind.ARC if element.centre is not None else Kind.RAPID if rapid else Kind.LINE
        if kind == Kind.ARC and rapid:
            feed = math.nan
        self.trimmed, self.rapid, self.position = None, rapid, end
        self.row = self._row(kind, start, end, element, feed, block)
        ahead = element.direction(at_end=True)
        self.direction = ahead if ahead != 0 else self.direction
        return [self.row]

    def _corner(self, blocks: Sequence[Block], k: int) -> list[Row]:
        """RND and CHF: shorten the element before, begin the one behind later."""
        block, row = blocks[k], self.row
        size = self._number(block, "R" if block.kind == "RND" else "CHF")
        if size is None or math.isnan(size):
            raise Impossible(f"the size of {block.kind} is not known")
        if row is None or row.element is None or self.trimmed is not None:
            raise Impossible(f"{block.kind} has no contour element before it")
        a, b, c = self.plane.axes
        if not math.isnan(row.start[c]) and row.end[c] != row.start[c]:
            raise Impossible(f"{block.kind} behind a move that rises")
        behind = self._next(blocks, k)
        make = rounded if block.kind == "RND" else chamfered
        before, corner, after = make(row.element, behind, size * self.scale)
        held = self.feed, self.feed_word
        rapid, feed = self._take_feed(block)
        self.feed, self.feed_word = held
        row.element = before
        row.end[a], row.end[b] = before.end.real, before.end.imag
        self.trimmed = after.start
        start, end = list(self.position), list(self.position)
        start[a], start[b] = corner.start.real, corner.start.imag
        end[a], end[b] = corner.end.real, corner.end.imag
        self.row = None
        self.direction = corner.direction(at_end=True)
        return [self._row(Kind.LINE if corner.centre is None else Kind.ARC, start, end, corner, feed, block)]

    # -- approach and departure ----------------------------------------------------------------------------

    def _lead(self, block: Block) -> Lead:
        form = block.kind.split()[1].removeprefix("P")
        numbers = []
        for name, needed in (("LEN", form in ("LT", "LN")), ("R", "C" in form), ("CCA", form == "CT")):
            value = self._number(block, name) if needed else 0.0
            if value is None or math.isnan(value):
                raise Impossible(f"{block.kind} without a known {name}")
            numbers.append(value)
        side = 1.0 if self.compensation == Compensation.LEFT else -1.0
        return Lead(form, numbers[0] * self.scale, numbers[1] * self.scale, math.radians(numbers[2]), side)

    def take_lead(self, block: Block, end: list[float], lead: Row) -> None:
        """Stand at the end of an approach, whatever way the control takes to it."""
        self._take_compensation(block)
        self.rapid, _ = self._take_feed(block)
        self.position = list(end)
        self.trimmed, self.row = None, lead
        self.direction = lead.element.direction(at_end=True) if lead.element is not None else 0j

    def end_of_lead(self, block: Block) -> list[float]:
        """End that an approach or departure states, mm."""
        end = self._target(block)
        if block.find("PR") is not None or block.find("PA") is not None:
            a, b, _ = self.plane.axes
            place, _ = self._polar(block)
            end[a], end[b] = place.real, place.imag
        return end

    def _approach(self, blocks: Sequence[Block], k: int) -> list[Row]:
        block = blocks[k]
        a, b, c = self.plane.axes
        start, end = list(self.position), self.end_of_lead(block)
        before_rapid, before_feed, before = self.rapid, self.feed, self.compensation
        self._take_compensation(block)
        rapid, feed = self._take_feed(block)
        lead = self._lead(block)
        here, there = complex(start[a], start[b]), complex(end[a], end[b])
        if cmath.isnan(here) or cmath.isnan(there):
            self.compensation = before
            raise Impossible("approach from or to a place that is not known: state the position before it")
        self.position = list(end)
        ahead = self._next(blocks, k).direction(at_end=False)
        way, onto = lead.approach(here, there, ahead)
        helper = list(start)
        helper[a], helper[b] = way.end.real, way.end.imag
        down = list(helper)
        down[c] = end[c]
        # On LCT the block's feed holds from the start on, and the height is reached on the way.
        if lead.form == "LCT":
            rows = [self._row(Kind.RAPID if rapid else Kind.LINE, start, down, way, feed, block)]
        else:
            kind = Kind.RAPID if before_rapid else Kind.LINE
            rows = [self._row(kind, start, helper, way, before_feed, block)]
            if down[c] != helper[c] and not math.isnan(down[c]):
                rows.append(self._row(kind, helper, down, Element(way.end, way.end), before_feed, block))
        kind = Kind.ARC if onto.centre is not None else Kind.LINE
        rows.append(self._row(kind, down, end, onto, feed, block))
        self.trimmed, self.rapid, self.row = None, rapid, rows[-1]
        self.direction = ahead
        return rows

    def _departure(self, block: Block) -> list[Row]:
        a, b, c = self.plane.axes
        start, end = list(self.position), self.end_of_lead(block)
        if cmath.isnan(self._here()) or self.direction == 0 or self.trimmed is not None:
            raise Impossible(f"{block.kind} from a place that is not known")
        lead = self._lead(block)
        there = complex(end[a], end[b]) if lead.form == "LCT" else None
        rapid, feed = self._take_feed(block)
        kind = Kind.RAPID if rapid else Kind.LINE
        rows = []
        at = start
        for element in lead.departure(self._here(), self.direction, there):
            to = list(at)
            to[a], to[b] = element.end.real, element.end.imag
            rows.append(self._row(Kind.ARC if element.centre is not None else kind, at, to, element, feed, block))
            at = to
        if end[c] != at[c] and not math.isnan(end[c]):
            to = list(at)
            to[c] = end[c]
            rows.append(self._row(kind, at, to, Element(element.end, element.end), feed, block))
            at = to
        free = self.compensation == Compensation.OFF or lead.form == "LCT"
        self.compensation = 0
        self.position = list(at)
        if not free:
            # The tool's centre is off this by the cutter's radius.
            self.position[a] = self.position[b] = math.nan
        self.trimmed, self.rapid, self.row, self.direction = None, rapid, None, 0j
        return rows
