# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of what a simulation wrote or found beside itself: slowed corners, a tilted tool, an identified machine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

from millcorr.prediction.corner_feed import CornerFeeds
from millcorr.prediction.logged_machine import LoggedMachine
from millcorr.remedy_programs import ShiftedProgram, TiltedProgram

from .html import html_table, um
from .plots import MICRO, UM

MOST_TABLED = 12
"""Corners of which the page has figures; simulation.json has all."""


@dataclass(frozen=True, eq=False, slots=True)
class Asked:
    """What a simulation is asked for beside its report.

    Parameters
    ----------
    slowed, shifted, tilted : Path, optional
        Programs to write.
    corner_error : float, optional
        Largest distance in mm between a corner and the path of the tool, for `slowed`.
    trace : Path, optional
        Log of the program, from which keys of the machine are identified; the simulation then runs with them.
    identify : tuple of str
        Which keys, from `millcorr.prediction.logged_machine.KEYS`; by default those that the setup does not state.
    """

    slowed: Path | None = None
    corner_error: float | None = None
    shifted: Path | None = None
    tilted: Path | None = None
    trace: Path | None = None
    identify: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False, slots=True)
class Done:
    """What came of it; None for what was not asked for."""

    asked: Asked
    slowed: CornerFeeds | None = None
    shifted: ShiftedProgram | None = None
    tilted: TiltedProgram | None = None
    machine: LoggedMachine | None = None

    def outputs(self) -> dict[Path, bytes]:
        """Programs to write."""
        a = self.asked
        made = ((a.slowed, self.slowed), (a.shifted, self.shifted), (a.tilted, self.tilted))
        return {place: found.data for place, found in made if place is not None and found is not None}

    def summary(self) -> dict[str, Any]:
        """What simulation.json says of it: lengths in mm, times in s."""
        return {
            "slowed": None if self.slowed is None else self._slowed(self.slowed),
            "shifted": None
            if self.shifted is None
            else {
                "program": str(self.asked.shifted),
                "path_moved_mm": self.shifted.largest,
                "largest_before_mm": self.shifted.before,
                "largest_after_mm": self.shifted.after,
            },
            "tilted": None if self.tilted is None else self._tilted(self.tilted),
            "identified": None if self.machine is None else self.machine.summary(),
        }

    def _slowed(self, found: CornerFeeds) -> dict[str, Any]:
        rows = zip(found.line, found.vertex, found.feed, found.before, found.after, strict=True)
        return {
            "program": str(self.asked.slowed),
            "bound_mm": self.asked.corner_error,
            "time_before_s": found.duration[0],
            "time_after_s": found.duration[1],
            "corners": [
                {
                    "line": int(line),
                    "place_mm": [None if v != v else v for v in vertex.tolist()],
                    "feed_mm_min": 60 * float(feed),
                    "before_mm": float(before),
                    "after_mm": float(after),
                }
                for line, vertex, feed, before, after in rows
            ],
        }

    def _tilted(self, found: TiltedProgram) -> dict[str, Any]:
        return {
            "program": str(self.asked.tilted),
            "lines": list(found.lines),
            "stretches": [
                {
                    "stretch": int(found.remedy.number[k]) + 1,
                    "tilt_deg": float(found.remedy.degrees[k]),
                    "path_moved_mm": float(found.shift[k]),
                    "largest_before_mm": float(found.remedy.worst[k, 0]),
                    "largest_after_mm": float(found.after[k]),
                }
                for k in range(len(found.after))
            ],
        }

    def in_words(self) -> Iterator[str]:
        """What to say in the terminal."""
        if self.machine is not None:
            m = self.machine
            left = f"{UM * m.residual:.2g} {MICRO}" if m.positions else f"{60 * m.residual:.2g} mm/min"
            yield f"identified  [machine] by {m.source}, which scatters by {left} about it; simulated with it"
            yield from (f"            {line}" for line in m.lines())
        if self.slowed is not None:
            yield f"slowed      {self._slowed_in_words(self.slowed)}: {self.asked.slowed}"
        if self.shifted is not None:
            yield f"shifted     {self._shifted_in_words(self.shifted)}: {self.asked.shifted}"
        if self.tilted is not None:
            before, after = (UM * v.max() for v in (self.tilted.remedy.worst[:, 0], self.tilted.after))
            yield f"tilted      walls from {before:.1f} to {after:.1f} {MICRO} off at most: {self.asked.tilted}"

    @staticmethod
    def _shifted_in_words(found: ShiftedProgram) -> str:
        before, after, largest = (f"{UM * v:.1f}" for v in (found.before, found.after, found.largest))
        return f"walls from {before} to {after} {MICRO} off at most, by moving the contour up to {largest} {MICRO}"

    def _slowed_in_words(self, found: CornerFeeds) -> str:
        bound = f"{UM * (self.asked.corner_error or 0):g} {MICRO}"
        if not len(found.line):
            return f"no corner is off by more than {bound}, the program is written as it was"
        corners = f"{len(found.line)} {'corner' if len(found.line) == 1 else 'corners'}"
        return (
            f"{corners} from {UM * found.before.max():.1f} to {UM * found.after.max():.1f} {MICRO} at most (bound "
            f"{bound}), in {found.duration[1]:.2f} s in place of {found.duration[0]:.2f} s"
        )

    def sections(self) -> Iterator[str]:
        """Parts of the page, as HTML."""
        if self.machine is not None:
            lines = "\n".join(escape(line) for line in self.machine.lines())
            yield (
                f"<h2>Machine by its log</h2><p>Identified from {escape(self.machine.source)}, with standard "
                f"uncertainties; this simulation runs with it.</p><pre>[machine]\n{lines}</pre>"
            )
        if self.slowed is not None:
            yield f"<h2>Corners run slower</h2><p>{escape(self._slowed_in_words(self.slowed))}.</p>" + self._corners(
                self.slowed
            )
        if self.shifted is not None:
            yield (
                f"<h2>Shifted contour</h2><p>{escape(str(self.asked.shifted))}: "
                f"{escape(self._shifted_in_words(self.shifted))}. It has been read back and predicted again.</p>"
            )
        if self.tilted is not None:
            t = self.tilted
            rows = [
                (
                    f"stretch {t.remedy.number[k] + 1}",
                    f"{t.remedy.degrees[k]:+.4f}",
                    um(t.shift[k], True),
                    um(t.remedy.worst[k, 0]),
                    um(t.after[k]),
                )
                for k in range(min(len(t.after), MOST_TABLED))
            ]
            head = ("", "tilt / \N{DEGREE SIGN}", *(f"{w} / {MICRO}" for w in ("path moved", "at most off", "tilted")))
            yield (
                f"<h2>Tilted tool</h2><p>{escape(str(self.asked.tilted))} turns the tool on lines "
                f"{', '.join(map(str, t.lines))}. It has been read back and predicted again. The control keeps the tip "
                "where it is programmed, so its path is moved with the tilt.</p>" + html_table(head, rows)
            )

    @staticmethod
    def _corners(found: CornerFeeds) -> str:
        if not len(found.line):
            return ""
        rows = [
            (
                f"line {found.line[k]}, X{found.vertex[k, 0]:.3f} Y{found.vertex[k, 1]:.3f}",
                f"{60 * found.feed[k]:g}",
                um(found.before[k]),
                um(found.after[k]),
            )
            for k in range(min(len(found.line), MOST_TABLED))
        ]
        more = len(found.line) - len(rows)
        note = f"<p class=small>{more} more corners are in simulation.json.</p>" if more else ""
        head = ("", "feed / mm/min", f"before / {MICRO}", f"after / {MICRO}")
        return html_table(head, rows) + note
