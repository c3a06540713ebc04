# SPDX-License-Identifier: LGPL-2.1-or-later
"""Okuma OSP with Renishaw Inspection Plus: arguments PX, PY, ..., results from VS75, output by FWRITC, PUT and WRITE.

The cycles are those of `millcorr.probing.controls.renishaw`: the ball's radius is put back along the direction of
travel and the centre is written, as G800 and G801 lines.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from millcorr.probing import Touch

from .program import Job, file_name, nominal_line, nominal_words, number, program_name
from .renishaw import cycle_of

_RESULTS = {"x": "VS75", "y": "VS76", "size": "VS78"}


@dataclass(frozen=True, slots=True)
class Okuma:
    """Programs for OSP-P controls of machining centres."""

    log_format: str = "msr"

    def log_name(self, job: Job) -> str:
        """File on the control's own store."""
        return "MD1:" + file_name(job, "PROBE.TXT", r"[A-Z0-9_-]{1,16}\.TXT")

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Modes, tool, safe height, probe on, file open."""
        name = "PRB1" if job.name == "PROBE" else program_name(job, r"[A-Z][A-Z0-9]{0,3}", "PRB1")
        lines = [f"O{name}", *(f"({line.upper()})" for line in head), "G21 G90 G17 G40 G80 G94"]
        if job.tool is not None:
            lines += [f"T{job.tool} M6", f"G56 H{job.tool} Z{number(job.safe_z)}"]
        else:
            lines.append(f"G0 Z{number(job.safe_z)}")
        return [*lines, "M5", "CALL O9832", f"FWRITC {self.log_name(job)}", "PUT 'START'", "WRITE C"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """Protected, at the safe height and down."""
        return [*self.position(job, x, y), f"CALL O9810 PZ={number(job.z)} PF={number(job.positioning)}"]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """Protected positioning."""
        return [f"CALL O9810 PX={number(x)} PY={number(y)} PF={number(job.positioning)}"]

    def lift(self, job: Job) -> list[str]:
        """Straight up, protected."""
        return [f"CALL O9810 PZ={number(job.safe_z)} PF={number(job.positioning)}"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """The cycle, which goes back to its start by itself, and two lines of log."""
        cycle = cycle_of(job, touch)
        words = "".join(f" P{letter}={value}" for letter, value in cycle.arguments)
        return [
            f"({nominal_words(touch)})",
            f"CALL O{cycle.program}{words}",
            f"VC1={cycle.centre[0].format(**_RESULTS)}",
            f"VC2={cycle.centre[1].format(**_RESULTS)}",
            f"PUT '{nominal_line(job, touch)}'",
            "WRITE C",
            f"PUT 'G801 N{touch.number} X'",
            "PUT VC1,10",
            "PUT ' Y'",
            "PUT VC2,10",
            f"PUT ' Z{number(job.z)} R{number(job.radius)}'",
            "WRITE C",
        ]

    def closing(self, job: Job) -> list[str]:
        """File closed, probe off."""
        return ["PUT 'END'", "WRITE C", "CLOSE C", "CALL O9833", "M02"]

    def finished(self, job: Job, lines: list[str]) -> str:
        """As it is."""
        return "\n".join(lines) + "\n"

    def companions(self, job: Job) -> Mapping[str, str]:
        """None."""
        return {}
