# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC: G38.2 stops at contact, G38.3 goes on without an error; results in #5061 to #5063, #5070 says contact.

PROBEOPEN logs the end of every probing move, also of one that met nothing. Positioning protected by G38.3 therefore
cannot go with it: the protected program writes the nine columns of such a log itself, by LOG, after touches only.
All probing moves give X, Y and Z, for the control takes its position anew after each.
The ways between touches are proven clear corner by corner; G64 would blend the corners, so G61 is set. It
stays in force after the program, whose comment says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from millcorr.probing import Touch

from .program import Job, file_name, nominal_words, number


@dataclass(frozen=True, slots=True)
class LinuxCnc:
    """Programs for LinuxCNC 2.8 and later.

    Parameters
    ----------
    protected : bool
        Whether positioning stops at contact.
    """

    protected: bool
    log_format: str = "linuxcnc"

    def log_name(self, job: Job) -> str:
        """Name of the file, in the directory of LinuxCNC's configuration."""
        return file_name(job, "probe.txt")

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Modes in mm; the log opened; the way of a protected move as a subroutine."""
        lines = [f"({line})" for line in head]
        lines += ["G21 G90 G17 G40 G94 G80", "G61 (exact path, stays in force, write G64 after it for blended corners)"]
        if job.tool is not None:
            lines.append(f"T{job.tool} M6 G43")
        lines.append("M5")
        if self.protected:
            lines += [
                "o<protected> sub",
                f"  G38.3 X#1 Y#2 Z#3 F{number(job.positioning)}",
                "  o100 if [#5070 NE 0]",
                "    (ABORT,the probe met something on its way)",
                "  o100 endif",
                "o<protected> endsub",
                f"(LOGOPEN,{self.log_name(job)})",
            ]
        else:
            lines.append(f"(PROBEOPEN {self.log_name(job)})")
        return [*lines, f"G0 Z{number(job.safe_z)}"]

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """At the safe height, then down at the positioning feed."""
        return [f"G0 X{number(x)} Y{number(y)}", *self._move(job, x, y)]

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """At measuring height."""
        return self._move(job, x, y)

    def _move(self, job: Job, x: float, y: float) -> list[str]:
        if self.protected:
            return [f"o<protected> call [{number(x)}] [{number(y)}] [{number(job.z)}]"]
        return [f"G1 X{number(x)} Y{number(y)} Z{number(job.z)} F{number(job.positioning)}"]

    def lift(self, job: Job) -> list[str]:
        """Straight up."""
        return [f"G0 Z{number(job.safe_z)}"]

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """G38.2, which is an error where nothing is met, and back."""
        (x, y), (x0, y0) = touch.target, touch.start
        lines = [
            f"({nominal_words(touch)})",
            f"G38.2 X{number(x)} Y{number(y)} Z{number(job.z)} F{number(job.feed)}",
        ]
        if self.protected:
            lines.append("(LOG,#5061 #5062 #5063 #5064 #5065 #5066 #5067 #5068 #5069)")
        return [*lines, f"G1 X{number(x0)} Y{number(y0)} Z{number(job.z)} F{number(job.positioning)}"]

    def closing(self, job: Job) -> list[str]:
        """The log closed."""
        return ["(LOGCLOSE)" if self.protected else "(PROBECLOSE)", "M2"]

    def finished(self, job: Job, lines: list[str]) -> str:
        """As it is."""
        return "\n".join(lines) + "\n"

    def companions(self, job: Job) -> Mapping[str, str]:
        """None."""
        return {}
