# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines that execute measuring programs against a simulated part, one small interpreter a control.

Written from the makers' documentation, without anything of millcorr: what a block does, where the probe stops, what
the control writes. A ball that enters the part in a move that is not a probing one is a `Collision`; a block that the
control would not know is a `NotUnderstood`.
"""

from __future__ import annotations

import math
import re
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tests.core import rs274

CONTACT = 1e-12
DEEP = 1e-6
"""A move that is not a probing one may leave a contact; deeper than this, in mm, it may not go."""

Distance = Callable[[np.ndarray], np.ndarray]


class Collision(Exception):
    """The ball entered the part."""


class NotUnderstood(Exception):
    """The control would refuse the block."""


class Alarm(Exception):
    """The control stopped: no contact, or contact where there should be none."""


@dataclass
class Machine:
    """A ball on the way; `distance` is the part's signed distance, positive outside the material."""

    distance: Distance
    radius: float
    top: float = 0.0
    at: list[float] = field(default_factory=lambda: [0.0, 0.0, 100.0])
    nearest: float = math.inf
    """Smallest gap of all moves below the part's top that were no probing moves and did not leave a contact."""

    def gap(self, p: np.ndarray) -> float:
        return float(self.distance(p[None, :2])[0]) - self.radius

    def go(self, **words: float) -> None:
        """A move without probing."""
        start, end = np.array(self.at), np.array(self._target(words))
        self.at = end.tolist()
        if min(start[2], end[2]) - self.radius >= self.top:
            return
        length = float(np.hypot(*(end - start)[:2]))
        leaving = self.gap(start) < 1e-3
        t, smallest = 0.0, math.inf
        while True:
            gap = self.gap(start + (end - start) * (t / length if length else 0.0))
            smallest = min(smallest, gap)
            if gap < -DEEP:
                x, y = start[:2] + (end - start)[:2] * (t / length if length else 0.0)
                raise Collision(f"{-gap:.3f} mm deep at X{x:.3f} Y{y:.3f}")
            if t >= length:
                break
            t = min(length, t + max(gap / 2, 0.01))
        if not leaving:
            self.nearest = min(self.nearest, smallest)

    def probe(self, **words: float) -> bool:
        """A move that stops at contact; whether there was one."""
        start, end = np.array(self.at), np.array(self._target(words))
        length = float(np.linalg.norm(end - start))
        if length == 0:
            raise NotUnderstood("a probing block without a way")
        if self.gap(start) < DEEP and min(start[2], end[2]) < self.top:
            raise Alarm("the probe is deflected before the measuring block")
        below = min(start[2], end[2]) - self.radius < self.top
        t = 0.0
        for _ in range(100_000):
            p = start + (end - start) * (t / length)
            gap = self.gap(p) if below else math.inf
            if gap < CONTACT:
                self.at = p.tolist()
                return True
            t += gap
            if t >= length:
                break
        self.at = end.tolist()
        return False

    def _target(self, words: dict[str, float]) -> list[float]:
        return [words.get(axis, here) for axis, here in zip("XYZ", self.at, strict=True)]


@dataclass
class Run:
    """What came of a program."""

    log: bytes
    machine: Machine
    touches: int


def words_of(block: str, letters: str) -> dict[str, float]:
    """Words of a block, each a letter and a decimal number; NotUnderstood for anything else."""
    out: dict[str, float] = {}
    rest = block
    while rest.strip():
        found = re.match(r"\s*([A-Z])([+-]?(?:\d+\.?\d*|\.\d+))", rest)
        if found is None or (found[1] not in letters) or (found[1] in out and found[1] not in "GM"):
            raise NotUnderstood(block)
        if found[1] in "GM":
            out[found[1] + found[2].rstrip(".")] = 1.0
        else:
            out[found[1]] = float(found[2])
        rest = rest[found.end() :]
    return out


def linuxcnc(text: str, machine: Machine, companions: dict[str, str]) -> Run:
    """LinuxCNC's own interpreter makes canonical motions of the program, which are carried out here.

    Logs what PROBEOPEN does: the end of every probing move (emccanon.cc), unless it equals the one before; or what
    LOG says, with the trigger's position in place of the interpreter's, who lets every probing move reach its end.
    """
    canon = _canon(text)
    rows: list[str] = []
    named = ""
    touches = 0
    last: list[float] = []
    for index, (name, arguments) in enumerate(canon):
        if name == "COMMENT" and arguments.startswith('"PROBEOPEN '):
            named = "probe"
        elif name == "LOGOPEN":
            named = "log"
        elif name == "PROGRAM_END":
            assert named, "the log was never opened"
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            machine.go(**dict(zip("XYZ", map(float, arguments.split(",")[:3]), strict=True)))
        elif name == "STRAIGHT_PROBE":
            met = machine.probe(**dict(zip("XYZ", map(float, arguments.split(",")[:3]), strict=True)))
            row = " ".join(f"{v:.6f}" for v in [*machine.at, *[0.0] * 6])
            logged = any(n == "LOG" for n, _ in canon[index + 1 : index + 3])
            if named == "log" and met != logged:
                raise Alarm("contact on a protected way" if met else "G38.2 move finished without making contact.")
            if named == "probe" and not met:
                raise Alarm("G38.2 move finished without making contact.")
            touches += met
            if logged or (named == "probe" and last != machine.at):
                rows.append(row)
                last = machine.at
    return Run(("\n".join(rows) + "\n").encode(), machine, touches)


_CALL = re.compile(r"^\s*\d+ N\S+\s+(\w+)\((.*)\)$")


def _canon(text: str) -> list[tuple[str, str]]:
    assert rs274.RS274, rs274.MISSING
    with tempfile.TemporaryDirectory() as directory:
        folder = Path(directory)
        (folder / "p.ngc").write_text(text)
        (folder / "tool.tbl").write_text("".join(f"T{i} P{i} Z0 D0\n" for i in range(1, 60)))
        ran = subprocess.run(
            [rs274.RS274, "-t", "tool.tbl", "-g", "p.ngc"],
            cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60,
        )  # fmt: skip
    if "PROGRAM_END" not in ran.stdout:
        raise NotUnderstood(ran.stderr[-300:])
    return [(m[1], m[2]) for m in map(_CALL.match, ran.stdout.splitlines()) if m]


def grbl(text: str, machine: Machine, companions: dict[str, str]) -> Run:
    """GRBL 1.1: lines of less than 80 characters but for comments and blanks; reports in the machine frame."""
    offset = np.array([-210.25, -95.5, -40.125])
    out = [f"<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:{offset[0]:.3f},{offset[1]:.3f},{offset[2]:.3f}>"]
    mode, feed, touches = "", False, 0
    for line in text.splitlines():
        block = re.sub(r"\([^()]*\)|\s", "", line)
        if len(block) > 79:
            raise NotUnderstood(f"too long: {line}")
        words = words_of(block, "GMXYZF")
        codes = {w for w in words if w[0] in "GM" and len(w) > 1}
        if codes - {"G0", "G1", "G38.2", "G17", "G21", "G40", "G90", "G94", "M2", "M5"}:
            raise NotUnderstood(line)
        motion = codes & {"G0", "G1", "G38.2"}
        mode = motion.pop() if motion else mode
        feed = feed or "F" in words
        axes = {w: v for w, v in words.items() if w in "XYZ"}
        if not axes:
            continue
        if mode == "G38.2":
            if not feed or not machine.probe(**axes):
                raise Alarm("ALARM:5")
            touches += 1
            x, y, z = np.array(machine.at) + offset
            out.append(f"[PRB:{x:.3f},{y:.3f},{z:.3f}:1]")
        elif mode in ("G0", "G1"):
            machine.go(**axes)
        else:
            raise NotUnderstood(line)
        out.append("ok")
    return Run(("\r\n".join(out) + "\r\n").encode(), machine, touches)


_EXPRESSION = re.compile(r"[\d.+\-*/() ]+")


def _value(expression: str, variable: Callable[[re.Match[str]], str], pattern: str) -> float:
    """Value of a sum or product with brackets, as macros have them."""
    plain = re.sub(pattern, variable, expression).replace("[", "(").replace("]", ")")
    if not _EXPRESSION.fullmatch(plain):
        raise NotUnderstood(expression)
    return float(eval(plain, {"__builtins__": {}}))  # noqa: S307 - digits and operators only


class InspectionPlus:
    """Renishaw's cycles: O9810 protected positioning, O9811 single surface, O9821 angled single surface.

    The ball is compensated along the direction of travel by the calibrated radius; both measuring cycles go back to
    their start. Results: X, Y (O9811, O9821) and the size from the start (O9821).
    """

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.on = False
        self.results: dict[str, float] = {}
        self.touches = 0

    def call(self, number: int, words: dict[str, float]) -> None:
        if number in (9832, 9833):
            self.on = number == 9832
            return
        if not self.on:
            raise Alarm("PROBE OFF")
        if number == 9810:
            _only(words, "XYZFM")
            if self.machine.probe(**{a: v for a, v in words.items() if a in "XYZ"}):
                raise Alarm("PATH OBSTRUCTED")
            return
        start = np.array(self.machine.at)
        r = self.machine.radius
        if number == 9811:
            _only(words, "XYZQ")
            axes = [a for a in words if a in "XYZ"]
            if len(axes) != 1:
                raise NotUnderstood("O9811 takes one axis")
            k = "XYZ".index(axes[0])
            sign = math.copysign(1.0, words[axes[0]] - start[k])
            way = np.zeros(3)
            way[k] = sign
            size = abs(words[axes[0]] - start[k])
        elif number == 9821:
            _only(words, "ADQ")
            angle = math.radians(words["A"])
            way, size = np.array([math.cos(angle), math.sin(angle), 0.0]), words["D"]
        else:
            raise NotUnderstood(f"O{number}")
        if size < r:
            raise Alarm("the ball starts inside the surface")
        end = start + way * (size - r + words.get("Q", 10.0))
        if not self.machine.probe(**dict(zip("XYZ", end, strict=True))):
            raise Alarm("SURFACE NOT FOUND")
        self.touches += 1
        trigger = np.array(self.machine.at)
        pole = trigger + r * way
        self.results = {"x": float(pole[0]), "y": float(pole[1]), "size": float(np.linalg.norm(trigger - start)) + r}
        if number == 9811:
            # Only the axis that was touched has a result.
            self.results["y" if k == 0 else "x"] = math.nan
        self.machine.go(**dict(zip("XYZ", start, strict=True)))


def _only(words: dict[str, float], letters: str) -> None:
    if set(words) - set(letters):
        raise NotUnderstood(str(words))


def _macro_b(first: int) -> Callable[[str, Machine, dict[str, str]], Run]:
    def run(text: str, machine: Machine, companions: dict[str, str]) -> Run:
        """Fanuc custom macro B: G65, local variables, DPRNT between POPEN and PCLOS (DC2, DC4, lines with CR LF)."""
        cycles = InspectionPlus(machine)
        local: dict[int, float] = {}
        out = b""
        is_open = False
        lines = text.splitlines()
        if lines[0] != "%" or lines[-1] != "%" or not re.fullmatch(r"O\d{4}", lines[1]):
            raise NotUnderstood("program frame")

        def variable(found: re.Match[str]) -> str:
            n = int(found[1])
            results = {first: "x", first + 1: "y", first + 3: "size"}
            value = cycles.results[results[n]] if n in results else local[n]
            return f"({value!r})"

        for line in lines[2:-1]:
            # In ISO code the colon begins a program and the semicolon ends a block.
            if not re.fullmatch(r"[ -~]*", line) or line != line.upper() or {":", ";"} & set(line):
                raise NotUnderstood(line)
            block = re.sub(r"\([^()]*\)", "", line).strip()
            if not block:
                continue
            printed = re.fullmatch(r"DPRNT\[(.*)\]", block)
            assigned = re.fullmatch(r"#(\d+)=(.+)", block)
            called = re.fullmatch(r"G65 P(98\d\d)(.*)", block)
            if printed:
                if not is_open:
                    raise Alarm("DPRNT without POPEN")
                out += _dprnt(printed[1], local).encode() + b"\r\n"
            elif assigned:
                if not 1 <= int(assigned[1]) <= 33:
                    raise NotUnderstood("not a local variable: the cycles use #100 and above themselves")
                local[int(assigned[1])] = _value(assigned[2], variable, r"#(\d+)")
            elif called:
                cycles.call(int(called[1]), words_of(called[2], "XYZAQDFM"))
            elif block in ("POPEN", "PCLOS"):
                is_open = block == "POPEN"
                out += b"\x12" if is_open else b"\x14"
            elif block == "M30":
                break
            else:
                words = words_of(block, "GMXYZTH")
                axes = {w: v for w, v in words.items() if w in ("X", "Y", "Z")}
                if axes:
                    machine.go(**axes)
        if is_open or cycles.on:
            raise Alarm("left open or on")
        return Run(out, machine, cycles.touches)

    return run


def _dprnt(content: str, local: dict[int, float]) -> str:
    """``*`` is a blank, ``#n[ab]`` a number with a digits before and b behind the point, padded with blanks."""

    def shown(found: re.Match[str]) -> str:
        value, before, behind = local[int(found[1])], int(found[2]), int(found[3])
        if before + behind > 8 or abs(value) >= 10**before:
            raise NotUnderstood(found[0])
        return f"{value:{before + behind + 2}.{behind}f}"

    # Between the variables only these characters may stand (no decimal point).
    if not re.fullmatch(r"[A-Z0-9*/+\-?@&_]*", re.sub(r"#(\d+)\[(\d)(\d)\]", "", content)):
        raise NotUnderstood(content)
    return re.sub(r"#(\d+)\[(\d)(\d)\]", shown, content.replace("*", " "))


def okuma(text: str, machine: Machine, companions: dict[str, str]) -> Run:
    """OSP: CALL with named arguments, VC and VS variables, FWRITC, PUT, WRITE C, CLOSE C."""
    cycles = InspectionPlus(machine)
    common: dict[int, float] = {}
    row, rows = "", []
    is_open = False

    def variable(found: re.Match[str]) -> str:
        n = int(found[2])
        value = common[n] if found[1] == "VC" else cycles.results[{75: "x", 76: "y", 78: "size"}[n]]
        return f"({value!r})"

    lines = text.splitlines()
    if not re.fullmatch(r"O[A-Z0-9]{1,4}", lines[0]):
        raise NotUnderstood(lines[0])
    for line in lines[1:]:
        block = re.sub(r"\([^()]*\)", "", line).strip()
        called = re.fullmatch(r"CALL O(98\d\d)((?: P[A-Z]=[-\d.]+)*)", block)
        assigned = re.fullmatch(r"VC(\d+)=(.+)", block)
        literal, number = re.fullmatch(r"PUT '([^']*)'", block), re.fullmatch(r"PUT VC(\d+),(\d+)", block)
        if not block:
            continue
        if called:
            words = {a: float(v) for a, v in re.findall(r" P([A-Z])=(\S+)", called[2])}
            cycles.call(int(called[1]), words)
        elif assigned:
            common[int(assigned[1])] = _value(assigned[2], variable, r"(VC|VS)(\d+)")
        elif re.fullmatch(r"FWRITC MD1:[A-Z0-9]+\.TXT", block):
            is_open = True
        elif literal or number:
            if not is_open:
                raise Alarm("no file open")
            row += literal[1] if literal else f"{common[int(number[1])]:{number[2]}.4f}" if number else ""
        elif block == "WRITE C":
            rows.append(row)
            row = ""
        elif block == "CLOSE C":
            is_open = False
        elif block == "M02":
            break
        else:
            words = words_of(block, "GMXYZTH")
            axes = {w: v for w, v in words.items() if w in ("X", "Y", "Z")}
            if axes:
                machine.go(**axes)
    if is_open or cycles.on:
        raise Alarm("left open or on")
    return Run("".join(r + "\r\n" for r in rows).encode(), machine, cycles.touches)


def heidenhain(text: str, machine: Machine, companions: dict[str, str]) -> Run:
    """Klartext: L, touch probe cycle 3, FN 0, FN 12, FN 16 with its mask."""
    blocks = []
    for k, line in enumerate(text.splitlines()):
        if not line.startswith(f"{k} "):
            raise NotUnderstood(f"block number: {line}")
        blocks.append(line.split(" ", 1)[1])
    name = re.fullmatch(r"BEGIN PGM (\w+) MM", blocks[0])
    if name is None or blocks[-1] != f"END PGM {name[1]} MM":
        raise NotUnderstood("program frame")
    q: dict[int, float] = {}
    rows: list[str] = []
    touches, k = 0, 0
    while True:
        k += 1
        block = blocks[k].partition(";")[0].strip()
        jump = re.fullmatch(r"FN 12: IF \+Q(\d+) LT \+0 GOTO LBL (\d+)", block)
        output = re.fullmatch(r"FN 16: F-PRINT TNC:\\(\S+) / TNC:\\(\S+)", block)
        if not block or block.startswith("TOOL CALL"):
            continue
        if block == "M30":
            break
        if block == "TCH PROBE 3.0 MEASURING":
            first, touched = _cycle_3(blocks[k + 1 : k + 5], machine, q)
            assert first == 21
            touches += touched
            k += 4
        elif jump:
            if q[int(jump[1])] < 0:
                raise Alarm(f"LBL {jump[2]}: no contact")
        elif set_q := re.fullmatch(r"FN 0: Q(\d+) = ([+-][\d.]+)", block):
            q[int(set_q[1])] = float(set_q[2])
        elif output:
            rows += [_mask(line, q) for line in companions[output[1]].splitlines()]
        elif moved := re.fullmatch(r"L((?: [XYZ][+-][\d.]+)+) R0 F(MAX|[\d.]+)(?: M5)?", block):
            # A stylus that is deflected in a move stops the control.
            machine.go(**{a: float(v) for a, v in re.findall(r" ([XYZ])(\S+)", moved[1])})
        else:
            raise NotUnderstood(block)
    return Run("".join(r + "\r\n" for r in rows).encode(), machine, touches)


def _cycle_3(blocks: list[str], machine: Machine, q: dict[int, float]) -> tuple[int, bool]:
    """Probes at an angle from X over a distance; four results: centre, and -1 without contact; retracts by MB."""
    where = re.fullmatch(r"TCH PROBE 3\.1 Q(\d+)", blocks[0])
    angle = re.fullmatch(r"TCH PROBE 3\.2 X ANGLE: ([+-][\d.]+)", blocks[1])
    way = re.fullmatch(r"TCH PROBE 3\.3 DIST \+([\d.]+) F[\d.]+ MB([\d.]+) REFERENCE SYSTEM: 0", blocks[2])
    if not (where and angle and way and blocks[3] == "TCH PROBE 3.4 ERRORMODE0"):
        raise NotUnderstood(str(blocks))
    first, turned = int(where[1]), math.radians(float(angle[1]))
    direction = np.array([math.cos(turned), math.sin(turned), 0.0])
    start = np.array(machine.at)
    met = machine.probe(**dict(zip("XYZ", start + float(way[1]) * direction, strict=True)))
    trigger = np.array(machine.at)
    q.update(zip(range(first, first + 3), trigger.tolist(), strict=True))
    q[first + 3] = 0.0 if met else -1.0
    back = min(float(way[2]), float(np.linalg.norm(trigger - start)))
    machine.go(**dict(zip("XYZ", trigger - back * direction, strict=True)))
    return first, met


def _mask(mask: str, q: dict[int, float]) -> str:
    """A line of FN 16's mask: a format in quotes, the Q parameters behind it, a semicolon."""
    found = re.fullmatch(r'"([^"]*)"((?:,Q\d+)*);', mask)
    if found is None:
        raise NotUnderstood(mask)
    values = [q[int(n)] for n in re.findall(r"Q(\d+)", found[2])]
    formats = re.findall(r"%(?:d|\d+\.\d+LF)", found[1])
    if len(formats) != len(values):
        raise NotUnderstood(mask)
    out = found[1]
    for form, value in zip(formats, values, strict=True):
        out = out.replace(form, f"{value:.0f}" if form == "%d" else f"{value:{form[1:-2]}f}", 1)
    return out


def siemens(text: str, machine: Machine, companions: dict[str, str]) -> Run:
    """SINUMERIK: MEAS=1 in a block with G1, $AC_MEA and $AA_MW, IF ... GOTOF, WRITE with <<."""
    rows: list[str] = []
    written: str | None = None
    labels = {line[:-1] for line in text.splitlines() if line.endswith(":")}
    met, touches, measured, declared = 0, 0, [math.nan] * 3, False
    for line in text.splitlines():
        block = re.sub(r"^N\d+ ", "", line).partition(";")[0].strip()
        jump = re.fullmatch(r"IF \$AC_MEA\[1\]==([01]) GOTOF (\w+)", block)
        write = re.fullmatch(r'WRITE\(FAULT,"(\w+)",(.*)\)', block)
        if block == "M30":
            break
        if not block or block == "STOPRE" or re.fullmatch(r"(IF FAULT<>0 GOTOF \w+|T\d+ D1 M6)", block):
            continue
        if block == "DEF INT FAULT":
            declared = True
        elif re.fullmatch(r'DELETE\(FAULT,"\w+"\)', block):
            rows.clear()
        elif jump:
            if jump[2] not in labels:
                raise NotUnderstood(f"no label {jump[2]}")
            if met == int(jump[1]):
                raise Alarm(jump[2])
            touches += met
        elif write:
            assert declared
            written = written or write[1]
            text_of_row = _string(write[2], measured)
            if len(text_of_row) > 200 or len(write[1]) > 24 or write[1] != written:
                raise NotUnderstood(block)
            rows.append(text_of_row)
        elif block.startswith("MEAS=1 "):
            words = words_of(block.removeprefix("MEAS=1 "), "GXYZF")
            axes = {w: v for w, v in words.items() if w in ("X", "Y", "Z")}
            met = int(machine.probe(**axes))
            # Only axes programmed in the block are measured.
            measured = [v if a in axes else math.nan for a, v in zip("XYZ", machine.at, strict=True)]
        else:
            words = words_of(block, "GMXYZF")
            axes = {w: v for w, v in words.items() if w in ("X", "Y", "Z")}
            if axes:
                machine.go(**axes)
    return Run("".join(r + "\n" for r in rows).encode(), machine, touches)


def _string(expression: str, measured: list[float]) -> str:
    """Strings and numbers joined by <<; a number is written without needless zeros."""
    out = ""
    for part in expression.split("<<"):
        text = re.fullmatch(r'"([^"]*)"', part)
        value = re.fullmatch(r"\(ROUND\(\$AA_MW\[([XYZ])\]\*10000\)/10000\)", part)
        if text:
            out += text[1]
        elif value:
            out += f"{round(measured['XYZ'.index(value[1])] * 10000) / 10000:.10g}"
        else:
            raise NotUnderstood(expression)
    return out


CONTROLS: dict[str, Callable[[str, Machine, dict[str, str]], Run]] = {
    "linuxcnc": linuxcnc,
    "linuxcnc-protected": linuxcnc,
    "grbl": grbl,
    "fanuc": _macro_b(135),
    "haas": _macro_b(185),
    "okuma": okuma,
    "heidenhain": heidenhain,
    "siemens": siemens,
}
LOG_STEP = {"linuxcnc": 1e-6, "linuxcnc-protected": 1e-6, "grbl": 1e-3}
"""Last digit of a log, mm; 0.1 um where it is not named here."""
