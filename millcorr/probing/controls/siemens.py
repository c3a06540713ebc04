# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens SINUMERIK: measuring block MEAS=1 in any direction, output of G800 and G801 lines by WRITE.

The measuring cycles (CYCLE978) state compensated results. A block with MEAS=1 stops at contact; $AC_MEA[1] says
whether there was one, $AA_MW[axis] where the axis stood in the work frame: the centre of the ball. The same block
protects positioning: there a contact leads to an alarm.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from millcorr.probing import Touch

from .program import Job, file_name, nominal_line, nominal_words, number, program_name


@dataclass(frozen=True, slots=True)
class Siemens:
    """Programs for 840D sl, 828D and SINUMERIK ONE."""

    log_format: str = "msr"

    def log_name(self, job: Job) -> str:
        """File beside the program."""
        return file_name(job, "PROBELOG", r"[A-Z][A-Z0-9_]{1,20}")

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Variables, modes in mm, tool, an empty log, safe height."""
        program_name(job, r"[A-Za-z_][A-Za-z0-9_]{1,22}", "PROBE")
        lines = [
            *(f"; {line}" for line in head),
            "DEF INT FAULT",
            "G17 G71 G90 G94 G40 G60",
        ]
        if job.tool is not None:
            lines.append(f"T{job.tool} D1 M6")
        log = self.log_name(job)
        return [*lines, "M5", f'DELETE(FAULT,"{log}")', f'WRITE(FAULT,"{log}","START")', f"G0 Z{number(job.safe_z)}"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """At the safe height, then down, protected."""
        return [
            f"G0 X{number(x)} Y{number(y)}",
            f"MEAS=1 G1 Z{number(job.z)} F{number(job.positioning)}",
            *_PROTECTED,
        ]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """At measuring height, protected."""
        return [f"MEAS=1 G1 X{number(x)} Y{number(y)} F{number(job.positioning)}", *_PROTECTED]

    def lift(self, job: Job) -> list[str]:
        """Straight up."""
        return [f"G0 Z{number(job.safe_z)}"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """Measuring block, its result checked and written, and back."""
        (x, y), (x0, y0) = touch.target, touch.start
        log = self.log_name(job)
        return [
            f"; {nominal_words(touch)}",
            f"MEAS=1 G1 X{number(x)} Y{number(y)} F{number(job.feed)}",
            "STOPRE",
            "IF $AC_MEA[1]==0 GOTOF NOCONTACT",
            f'WRITE(FAULT,"{log}","{nominal_line(job, touch)}")',
            f'WRITE(FAULT,"{log}","G801 N{touch.number} X"<<{_rounded("X")}<<" Y"<<{_rounded("Y")}'
            f'<<" Z{number(job.z)} R{number(job.radius)}")',
            "IF FAULT<>0 GOTOF LOGFAULT",
            f"G1 X{number(x0)} Y{number(y0)} F{number(job.positioning)}",
        ]

    def closing(self, job: Job) -> list[str]:
        """End; below it the alarms."""
        lines = [f'WRITE(FAULT,"{self.log_name(job)}","END")', "M30"]
        for label, message in _ALARMS:
            lines += [f"{label}:", f'SETAL(65000,"{message}")', "M0", "M30"]
        return lines

    def finished(self, job: Job, lines: list[str]) -> str:
        """With block numbers."""
        return (
            "\n".join(
                line if line.startswith(";") or line.endswith(":") else f"N{10 * k} {line}"
                for k, line in enumerate(lines, 1)
            )
            + "\n"
        )

    def companions(self, job: Job) -> Mapping[str, str]:
        """None."""
        return {}


_PROTECTED = ["STOPRE", "IF $AC_MEA[1]==1 GOTOF OBSTRUCTED"]


_ALARMS = (
    ("OBSTRUCTED", "PROBE MET SOMETHING ON ITS WAY"),
    ("NOCONTACT", "NO CONTACT"),
    ("LOGFAULT", "LOG NOT WRITTEN"),
)


def _rounded(axis: str) -> str:
    """Measured position to 0.1 um; without it the control writes as many digits as it likes."""
    return f"(ROUND($AA_MW[{axis}]*10000)/10000)"
