# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renishaw Inspection Plus on Fanuc (results from #135) and Haas (from #185), printed by DPRNT as G800 and G801 lines.

O9811 touches along an axis and states where the surface is: the ball's pole in the direction of travel, the ball
compensated along the axis. On a slope that is no point of the part. The program puts the ball's radius back along the
axis and prints the centre; the coordinate across is the one commanded. This needs no variable of the calibration and
no trust in what the last skip was. O9821 touches at an angle; its size from the start, less the radius, leads from the
start to the centre (what its X and Y are counted from differs between editions of the cycles).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import atan2, degrees, hypot

from millcorr.errors import UsageError
from millcorr.messages import option, phrase
from millcorr.probing import Touch

from .program import Job, nominal_words, number, program_name

_NUMBER = r"[1-9]\d{0,3}"


@dataclass(frozen=True, slots=True)
class Cycle:
    """A measuring cycle and how the ball's centre follows from its results.

    Parameters
    ----------
    program : int
    arguments : tuple of (str, str)
        Letters and numbers.
    centre : tuple of 2 str
        X and Y as macro expressions, in which ``{x}``, ``{y}`` and ``{size}`` stand for the cycle's results.
    """

    program: int
    arguments: tuple[tuple[str, str], ...]
    centre: tuple[str, str]


def cycle_of(job: Job, touch: Touch) -> Cycle:
    """O9811 for a touch along an axis, O9821 for one at an angle."""
    r, (x0, y0), (dx, dy) = job.radius, touch.start, touch.direction
    over = number(hypot(touch.target[0] - touch.centre[0], touch.target[1] - touch.centre[1]))
    if touch.axis:
        along = 0 if touch.axis == "X" else 1
        pole = touch.centre[along] + r * touch.direction[along]
        back = f"-{number(r)}" if touch.direction[along] > 0 else f"+{number(r)}"
        centre = (f"{{x}}{back}", number(y0)) if along == 0 else (number(x0), f"{{y}}{back}")
        return Cycle(9811, ((touch.axis, number(pole)), ("Q", over)), centre)
    size = hypot(touch.centre[0] - x0, touch.centre[1] - y0) + r
    way = f"[{{size}}-{number(r)}]"
    return Cycle(
        9821,
        (("A", number(degrees(atan2(dy, dx)))), ("D", number(size)), ("Q", over)),
        (f"{number(x0)}+{way}*[{number(dx, 7)}]", f"{number(y0)}+{way}*[{number(dy, 7)}]"),
    )


@dataclass(frozen=True, slots=True)
class InspectionPlus:
    """Programs for one of the controls.

    Parameters
    ----------
    control : str
    first_result : int
        Variable of the X result; Y and the size follow as the next and the third.
    """

    control: str
    first_result: int
    log_format: str = "msr"

    def log_name(self, job: Job) -> str:
        """What DPRNT writes; where it goes is set on the control."""
        if job.log is not None:
            raise UsageError(phrase("{}: where DPRNT writes is set on the {} control", option("log"), self.control))
        return "printed by DPRNT, where the control is set to"

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Modes in mm, tool, safe height, probe on, output open; the radius in #8, the height in #3."""
        name = "8100" if job.name == "PROBE" else program_name(job, _NUMBER, "8100")
        lines = ["%", f"O{int(name):04d}", *(f"({line.upper()})" for line in head), "G21 G90 G17 G40 G80 G94"]
        if job.tool is not None:
            lines += [f"T{job.tool} M6", f"G43 H{job.tool} Z{number(job.safe_z)}"]
        else:
            lines.append(f"G0 Z{number(job.safe_z)}")
        lines += ["M5", "G65 P9832", f"#3={number(job.z)}", f"#8={number(job.radius)}"]
        return [*lines, "POPEN", "DPRNT[START]"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """Protected, at the safe height and down."""
        return [*self.position(job, x, y), f"G65 P9810 Z{number(job.z)} F{number(job.positioning)}"]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """Protected positioning: an alarm if the probe meets anything."""
        return [f"G65 P9810 X{number(x)} Y{number(y)} F{number(job.positioning)}"]

    def lift(self, job: Job) -> list[str]:
        """Straight up, protected."""
        return [f"G65 P9810 Z{number(job.safe_z)} F{number(job.positioning)}"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """The cycle, which goes back to its start by itself, and two lines of log.

        DPRNT takes no decimal point among its letters, so the nominal goes through variables as well.
        """
        cycle = cycle_of(job, touch)
        first = self.first_result
        results = {"x": f"#{first}", "y": f"#{first + 1}", "size": f"#{first + 3}"}
        words = "".join(f" {letter}{value}" for letter, value in cycle.arguments)
        return [
            f"({nominal_words(touch)})",
            f"G65 P{cycle.program}{words}",
            f"#1={cycle.centre[0].format(**results)}",
            f"#2={cycle.centre[1].format(**results)}",
            *(
                f"#{k}={number(value, 6)}"
                for k, value in zip((4, 5, 6, 7), (*touch.contact, *touch.normal), strict=True)
            ),
            f"DPRNT[G800*N{touch.number}*X#4[44]*Y#5[44]*Z#3[44]*I#6[16]*J#7[16]*K0]",
            f"DPRNT[G801*N{touch.number}*X#1[44]*Y#2[44]*Z#3[44]*R#8[34]]",
        ]

    def closing(self, job: Job) -> list[str]:
        """Output closed, probe off."""
        return ["DPRNT[END]", "PCLOS", "G65 P9833", "M30", "%"]

    def finished(self, job: Job, lines: list[str]) -> str:
        """As it is."""
        return "\n".join(lines) + "\n"

    def companions(self, job: Job) -> Mapping[str, str]:
        """None."""
        return {}
