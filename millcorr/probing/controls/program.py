# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all measuring programs have in common: the order of their moves, their heads, numbers and names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import Protocol

from millcorr.errors import UsageError
from millcorr.messages import Coordinates, Message, at_z, joined, message, option, phrase
from millcorr.probing import ProbingPlan, Touch

DECIMALS = 4
"""Programs give lengths to 0.1 um."""

HEADLINE = "MILLCORR MEASURING PROGRAM"
"""Stands in the head of every program."""


@dataclass(frozen=True, slots=True)
class Job:
    """What a measuring program is to do; lengths in mm, feeds in mm/min.

    Parameters
    ----------
    plan : ProbingPlan
    z, safe_z : float
        Height of measuring, and height at which the probe passes over everything.
    feed, positioning : float
        Feed of the touch, and of moves at measuring height.
    name : str
        Name of the program.
    log : str or None
        Name of the file that the control writes; None: the dialect's own.
    tool : int or None
        Number of the probe in the magazine.
    source : str
        What the contour comes from.
    """

    plan: ProbingPlan
    z: float
    safe_z: float
    feed: float
    positioning: float
    name: str = "PROBE"
    log: str | None = None
    tool: int | None = None
    source: str = ""

    def __post_init__(self) -> None:
        for key, value in (("feed", self.feed), ("positioning_feed", self.positioning)):
            if not (isfinite(value) and 0 < value <= 50_000):
                raise UsageError(phrase("{} is no feed in mm/min", option(key, value)))
        if not (isfinite(self.z) and isfinite(self.safe_z) and abs(self.z) < 1e4 and abs(self.safe_z) < 1e4):
            raise UsageError(
                phrase("{} and {} are no heights in mm", option("z", self.z), option("safe_z", self.safe_z))
            )
        if self.safe_z <= self.z:
            raise UsageError(phrase("{} must lie above {}", option("safe_z", self.safe_z), option("z", self.z)))
        if self.tool is not None and not 1 <= self.tool <= 9999:
            raise UsageError(phrase("{} is no tool number", option("probe_tool", self.tool)))

    @property
    def radius(self) -> float:
        """Radius of the ball, mm."""
        return self.plan.probe.ball_radius


@dataclass(frozen=True, slots=True)
class MeasuringProgram:
    """A program for a control, and how its log is read back.

    Parameters
    ----------
    text : str
        ASCII, lines ending in LF.
    plan : ProbingPlan
    z, safe_z : float
        Height of measuring, and height at which the probe passes over everything, mm.
    companions : mapping of str to str
        Files that the program needs beside it, by name.
    log_format : str
        Name from `millcorr.readers.FORMATS`.
    log : str
        Where the log is found.
    warnings : tuple of str
    """

    text: str
    plan: ProbingPlan
    z: float
    safe_z: float
    log_format: str
    log: str
    companions: Mapping[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()

    def words(self) -> Message:
        """What was planned, what was left out and why, and how the log is read, in a few lines."""
        plan = self.plan
        over = sum(link is None for link in plan.links)
        touches = phrase(
            "{} touches, {} of {} ways between them over the safe height", len(plan), over, len(plan.links)
        )
        heights = phrase("measured at {}, passed over at {}", at_z(self.z), at_z(self.safe_z))
        lines = [_line(phrase("points"), touches), _line(phrase("heights"), heights)]
        reasons: dict[str, list[Coordinates]] = {}
        for left in plan.left_out:
            reasons.setdefault(left.reason, []).append(Coordinates("XY", (left.x, left.y)))
        for reason, where in reasons.items():
            places = joined([message(place) for place in where[:3]])
            if len(where) > 3:
                places = phrase("{} and {} more", places, len(where) - 3)
            lines.append(_line(phrase("left out"), message(places, ": ", reason)))
        lines += [_line(phrase("warning"), warning) for warning in self.warnings]
        read = message(option("measured", of="LOG"), " ", how_to_read(self.log_format, plan))
        lines.append(_line(phrase("log"), message(self.log, ": ", read)))
        return joined(lines, "\n")


def _line(name: str, said: str) -> Message:
    """A line as the console aligns it."""
    return message(name, " " * (12 - len(name)), said)


def how_to_read(log_format: str, plan: ProbingPlan) -> str:
    """Options of ``millcorr check`` and ``correct`` that read the log; G800 and G801 lines state the radius."""
    radius = "" if log_format == "msr" else message(" ", option("probe_radius", plan.probe.ball_radius))
    return message(option("format", log_format), radius)


class Dialect(Protocol):
    """What writes a plan for one kind of control. Every method gives lines of program."""

    @property
    def log_format(self) -> str:
        """Name from `millcorr.readers.FORMATS`."""

    def log_name(self, job: Job) -> str:
        """Name of the file that the control writes, or where the log comes from."""

    def opening(self, job: Job, head: list[str]) -> list[str]:
        """Head as comments, modes, tool, log opened, probe at the safe height and on."""

    def over(self, job: Job, x: float, y: float) -> list[str]:
        """To a place at the safe height, then down to measuring height."""

    def position(self, job: Job, x: float, y: float) -> list[str]:
        """To a place at measuring height, stopping if the probe meets anything."""

    def lift(self, job: Job) -> list[str]:
        """Straight up to the safe height."""

    def touch(self, job: Job, touch: Touch) -> list[str]:
        """Touch, log the ball's centre, and back to the start of the touch."""

    def closing(self, job: Job) -> list[str]:
        """Probe off, log closed, end."""

    def finished(self, job: Job, lines: list[str]) -> str:
        """Text of the program from its lines: line numbers and the like."""

    def companions(self, job: Job) -> Mapping[str, str]:
        """Files that the program needs beside it."""


def written(job: Job, name: str, dialect: Dialect) -> MeasuringProgram:
    """A plan as the program of a control."""
    plan = job.plan
    lines = dialect.opening(job, _head(job, name, dialect))
    here: tuple[str, str] | None = None
    for index, touch in enumerate(plan.touches()):
        link = plan.links[index - 1] if index else None
        if link is None:
            if index:
                lines += dialect.lift(job)
            lines += dialect.over(job, *touch.start)
        else:
            for x, y in link[1:].tolist():
                there = (number(x), number(y))
                # A block without a way is an error for some measuring commands.
                lines += dialect.position(job, x, y) if there != here else []
                here = there
        lines += dialect.touch(job, touch)
        here = (number(touch.start[0]), number(touch.start[1]))
    lines += dialect.lift(job)
    lines += dialect.closing(job)
    text = dialect.finished(job, lines)
    return MeasuringProgram(
        text, plan, job.z, job.safe_z, dialect.log_format, dialect.log_name(job), dialect.companions(job)
    )


def _head(job: Job, name: str, dialect: Dialect) -> list[str]:
    plan, probe = job.plan, job.plan.probe
    frame = "machine frame" if dialect.log_format == "grbl" else "work frame"
    head = [
        f"{HEADLINE}, {name}",
        f"contour of {plain(job.source)}" if job.source else "",
        f"{len(plan)} touches at Z{number(job.z)}, all lengths in mm",
        f"ball radius {number(probe.ball_radius)}, clearance {number(probe.clearance)}, "
        f"overtravel {number(probe.overtravel)}",
        f"log {dialect.log_name(job)}, ball centres, {frame}",
        f"read back with {how_to_read(dialect.log_format, plan)}",
        "" if job.tool else "needs the probe in the spindle, its length offset and the work offset active",
    ]
    return [line for line in head if line]


def nominal_words(touch: Touch) -> str:
    """Number, nominal contact point and normal of a touch, for a comment."""
    (x, y), (i, j) = touch.contact, touch.normal
    return f"POINT {touch.number} NOMINAL X{number(x)} Y{number(y)} I{number(i, 6)} J{number(j, 6)}"


def nominal_line(job: Job, touch: Touch) -> str:
    """Nominal point and normal of a touch as a G800 line of an MSR log."""
    (x, y), (i, j) = touch.contact, touch.normal
    place = f"X{number(x)} Y{number(y)} Z{number(job.z)}"
    return f"G800 N{touch.number} {place} I{number(i, 6)} J{number(j, 6)} K0"


def number(value: float, decimals: int = DECIMALS) -> str:
    """A decimal number with a point and without needless zeros: ``12.5``, ``3.``, ``-0.0625``."""
    text = f"{value:.{decimals}f}".rstrip("0")
    return "0." if text in ("-0.", "0.") else text


def plain(text: str) -> str:
    """Text that any control accepts in a comment: ASCII, no brackets, colons or ends of block, not long."""
    kept = re.sub(r"[^A-Za-z0-9 .,+/=-]", "-", text)
    return kept if len(kept) <= 60 else kept[:57] + "..."


def file_name(job: Job, default: str, allowed: str = r"[A-Za-z0-9_.-]{1,60}") -> str:
    """Name of the log that the caller gave, or the default; UsageError where a control would not take it."""
    name = default if job.log is None else job.log
    if not re.fullmatch(allowed, name):
        raise UsageError(phrase("{}: this control takes names like {}", option("log", repr(name)), default))
    return name


def program_name(job: Job, pattern: str, example: str) -> str:
    """Name of the program; UsageError where a control would not take it."""
    if not re.fullmatch(pattern, job.name):
        raise UsageError(phrase("program name {!r}: this control takes names like {}", job.name, example))
    return job.name
