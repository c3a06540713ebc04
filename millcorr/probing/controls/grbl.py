# SPDX-License-Identifier: LGPL-2.1-or-later
"""GRBL 1.1: G38.2 reports ``[PRB:x,y,z:1]`` to the sender, whose log is the file to read.

A protected move (G38.3) that meets nothing reports ``[PRB:...:0]``, which is what a failed touch looks like in the
log. So positioning is by G1, unprotected; touches are protected by themselves.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from millcorr.errors import UsageError
from millcorr.messages import option, phrase
from millcorr.probing import Touch

from .program import Job, nominal_words, number


@dataclass(frozen=True, slots=True)
class Grbl:
    """Programs for GRBL 1.1 and what follows it."""

    log_format: str = "grbl"

    def log_name(self, job: Job) -> str:
        """The sender's log; GRBL has no files."""
        if job.log is not None:
            raise UsageError(phrase("{}: GRBL writes no file, save the log of the sender", option("log")))
        return "of the G-code sender, with its status reports"

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Modes in mm and the safe height."""
        if job.tool is not None:
            raise UsageError(phrase("{}: GRBL changes no tools, leave it out", option("probe_tool")))
        return [*(f"({line})" for line in head), "G21 G90 G17 G40 G94", "M5", f"G0 Z{number(job.safe_z)}"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """At the safe height, then down at the positioning feed."""
        return [f"G0 X{number(x)} Y{number(y)}", f"G1 Z{number(job.z)} F{number(job.positioning)}"]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """At measuring height, unprotected."""
        return [f"G1 X{number(x)} Y{number(y)} F{number(job.positioning)}"]

    def lift(self, job: Job) -> list[str]:
        """Straight up."""
        return [f"G0 Z{number(job.safe_z)}"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """G38.2, an alarm where nothing is met, and back."""
        x, y = touch.target
        return [
            f"({nominal_words(touch)})",
            f"G38.2 X{number(x)} Y{number(y)} F{number(job.feed)}",
            *self.position(job, *touch.start),
        ]

    def closing(self, job: Job) -> list[str]:
        """End."""
        return ["M2"]

    def finished(self, job: Job, lines: list[str]) -> str:
        """As it is."""
        return "\n".join(lines) + "\n"

    def companions(self, job: Job) -> Mapping[str, str]:
        """None."""
        return {}
