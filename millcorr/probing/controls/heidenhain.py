# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain Klartext: touch probe cycle 3 in any direction, output of G800 and G801 lines by FN 16 through masks.

Cycle 3 stores the centre of the ball in the active frame, uncompensated, in three Q parameters, and -1 in a fourth
where nothing was met. Positioning needs no cycle: the control itself stops when the stylus is deflected in a move.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import atan2, degrees, hypot

from millcorr.probing import Touch

from .program import DECIMALS, Job, file_name, nominal_words, number, program_name

_NAME = r"[A-Za-z0-9_]{1,24}"


@dataclass(frozen=True, slots=True)
class Heidenhain:
    """Programs for iTNC 530, TNC 620, TNC 640 and the like."""

    log_format: str = "msr"

    def log_name(self, job: Job) -> str:
        """File in the control's own store."""
        return "TNC:\\" + file_name(job, "PROBE.TXT", r"[A-Za-z0-9_]{1,24}\.TXT")

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Head, probe, safe height."""
        name = program_name(job, _NAME, "PROBE")
        lines = [f"BEGIN PGM {name} MM", *(f"; {line}" for line in head)]
        if job.tool is not None:
            lines.append(f"TOOL CALL {job.tool} Z")
        return [*lines, f"L Z{_signed(job.safe_z)} R0 FMAX M5"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """At the safe height, then down at the positioning feed."""
        return [
            f"L X{_signed(x)} Y{_signed(y)} R0 FMAX",
            f"L Z{_signed(job.z)} R0 F{_plain(job.positioning)}",
        ]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """At measuring height; the control watches the stylus."""
        return [f"L X{_signed(x)} Y{_signed(y)} R0 F{_plain(job.positioning)}"]

    def lift(self, job: Job) -> list[str]:
        """Straight up."""
        return [f"L Z{_signed(job.safe_z)} R0 FMAX"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """Cycle 3, its result checked and printed, and back."""
        (x0, y0), (dx, dy) = touch.start, touch.direction
        length = hypot(touch.target[0] - x0, touch.target[1] - y0)
        return [
            f"; {nominal_words(touch)}",
            "TCH PROBE 3.0 MEASURING",
            "TCH PROBE 3.1 Q21",
            f"TCH PROBE 3.2 X ANGLE: {_signed(degrees(atan2(dy, dx)))}",
            f"TCH PROBE 3.3 DIST {_signed(length)} F{_plain(job.feed)} MB{_plain(length)} REFERENCE SYSTEM: 0",
            "TCH PROBE 3.4 ERRORMODE0",
            "FN 12: IF +Q24 LT +0 GOTO LBL 99",
            f"FN 0: Q20 = +{touch.number}",
            *(
                f"FN 0: Q{k} = {_signed(value, 6)}"
                for k, value in zip((11, 12, 13, 14), (*touch.contact, *touch.normal), strict=True)
            ),
            self._printed(job, ""),
            *self.position(job, x0, y0),
        ]

    def closing(self, job: Job) -> list[str]:
        """End; below it the place where a touch without contact leads."""
        stop = ["LBL 99", "; NO CONTACT", *self.lift(job), "STOP", "LBL 0"]
        return [self._printed(job, "_END"), "M30", *stop, f"END PGM {job.name} MM"]

    def finished(self, job: Job, lines: list[str]) -> str:
        """With block numbers."""
        return "\n".join(f"{k} {line}" for k, line in enumerate(lines)) + "\n"

    def _printed(self, job: Job, mask: str) -> str:
        return f"FN 16: F-PRINT TNC:\\{job.name}{mask}.A / {self.log_name(job)}"

    def companions(self, job: Job) -> Mapping[str, str]:
        """Masks of FN 16: two lines a point, and the last line."""
        nominal = '"G800 N%d X%10.4LF Y%10.4LF Z%10.4LF I%9.6LF J%9.6LF K0",Q20,Q11,Q12,Q23,Q13,Q14;\n'
        measured = f'"G801 N%d X%10.4LF Y%10.4LF Z%10.4LF R{number(job.radius)}",Q20,Q21,Q22,Q23;\n'
        return {f"{job.name}.A": nominal + measured, f"{job.name}_END.A": '"END";\n'}


def _signed(value: float, decimals: int = DECIMALS) -> str:
    text = _plain(value, decimals)
    return text if text.startswith("-") else f"+{text}"


def _plain(value: float, decimals: int = DECIMALS) -> str:
    return number(value, decimals).rstrip(".")
