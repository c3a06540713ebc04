# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program in HEIDENHAIN's ISO code (DIN/ISO): its text, and the toolpath that it makes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import ClassVar

from millcorr.errors import FormatError
from millcorr.nc.toolpath import named_tool
from millcorr.nc.words import line_starts

from .din import RECOGNISED, Modal, Story, Told
from .program import Course, Follower, KlartextProgram, nothing_collected, parts_of, style_of

_IN_ISO = (
    (r"CC, C and CR blocks", "G02 and G03 blocks"),
    (r"(?:APPR|DEP) P?LCT", "G26 or G27"),
    (r"no (?:pole|centre) CC is", "no pole (I, J) is"),
    (r"correct it or its CC", "correct it or its pole (I, J)"),
    (r"correct CC", "correct its pole (I, J)"),
    (r"with CC and C\b", "with the pole (I, J) and G02 or G03"),
    (r"\bCC with", "a pole with"),
    (r"\bRND\b", "G25"),
    (r"\bCHF\b", "G24"),
    (r"\bCTP?\b", "G06 or G16"),
    (r"\bCR\b", "an arc by R"),
    (r"\bIPA and DR of CP\b", "the increment H and the sense of rotation"),
    (r"state DR\+ or DR-", "state G02 or G03, G12 or G13"),
    (r"\bPR\b", "R"),
    (r"\bBEGIN PGM without a unit: state MM or INCH", "the first block without a unit: state G71 or G70"),
    (r"\bCALL LBL\b", "L"),
    (r"no LBL (\S+)", r"no G98 L\1"),
)
"""Words of plain language in what is said of its blocks, and those of ISO code."""


def recognises(data: bytes) -> bool:
    """Whether a text is a program in HEIDENHAIN's ISO code."""
    return RECOGNISED.match(data) is not None


def in_iso(text: str) -> str:
    """What is said of a block of plain language, said of one in ISO code."""
    for pattern, instead in _IN_ISO:
        text = re.sub(pattern, instead, text)
    return text


@contextmanager
def told_in_iso(name: str) -> Iterator[None]:
    """Have refusals speak of ISO code."""
    try:
        yield
    except FormatError as error:
        text = str(error.said)
        if in_iso(text) == text:
            raise
        raise FormatError(in_iso(text), error.file or name, error.line) from error


@dataclass(frozen=True, slots=True)
class DinCourse(Course):
    """Blocks as they run, and what they stand for in the text.

    Parameters
    ----------
    told : list of Told
        As they run.
    """

    told: list[Told]


@dataclass(frozen=True, eq=False, slots=True)
class DinProgram(KlartextProgram):
    """A program in ISO code; its blocks are those of plain language, said otherwise."""

    plain_moves: ClassVar[str] = "G01, and G02 or G03 with R or about a pole (I, J) stated in a block of its own before"

    def as_they_run(self) -> DinCourse:
        """The blocks in plain language, as they stand in the text and in the order in which they run."""
        story = Story(self.data, self.line_start, self.name)
        text = [t.block for t in story.told]
        followed = DinFollower(story, self.name, len(self))
        at, runs = [], 0
        for k in followed.order:
            at.append(runs)
            runs += text[k].last + 1 - text[k].first
        ran = followed.ran + [story.told[k] for k in followed.order[len(followed.ran) :]]
        return DinCourse(text, [t.block for t in ran], at, list(followed.order), ran)

    def comments(self) -> list[tuple[int, str]]:
        """All comments: index of the line from 0, and the text without its mark and that of the block's end."""
        return [(line, text.removesuffix("*").rstrip()) for line, text in KlartextProgram.comments(self)]

    def tool(self, number: int) -> str:
        """A tool as the command line takes it: its number, or its name where the program calls it by one."""
        for found in re.finditer(rb'(?i)(?<![A-Z])T[ \t]*"([^"\r\n]*)"', self.data):
            if named_tool(found[1]) == number:
                return found[1].decode("latin-1")
        return str(number)


class DinFollower(Follower):
    """One run of a program in ISO code: a block is said in plain language as it is where it runs."""

    def __init__(self, story: Story, name: str, lines: int) -> None:
        self.story = story
        self.modal = Modal()
        self.ran: list[Told] = []
        super().__init__(story, name, lines)
        self.stretches = [replace(s, reason=in_iso(s.reason)) for s in self.stretches]

    def prepare(self, k: int) -> None:
        """Say the blocks from here on as they are in the state that holds now."""
        self.story.from_here(k, self.modal)
        self.modal = self.story.told[k].after
        self.ran.append(self.story.told[k])


def parse(data: bytes, name: str) -> DinProgram:
    r"""Read a program in HEIDENHAIN's ISO code from its text.

    Parameters
    ----------
    data : bytes
    name : str
        For messages.

    Returns
    -------
    DinProgram

    Raises
    ------
    FormatError
        If a block cannot be read or an arc is impossible.

    Examples
    --------
    >>> text = b"%A G71 *\nN10 G00 G90 X+0 Y+0 *\nN20 G01 X+5 F600 *\nN30 G25 R1 *\nN40 Y+4 *\nN50 %A G71 *\n"
    >>> parse(text, "A.I").toolpath.end[:, :2].tolist()
    [[0.0, 0.0], [4.0, 0.0], [5.0, 1.0], [5.0, 4.0]]
    """
    starts = line_starts(data)
    with nothing_collected(), told_in_iso(name):
        story = Story(data, starts, name)
        blocks = [t.block for t in story.told]
        followed = DinFollower(story, name, len(starts) - 1)
        parts = parts_of(followed)
    return DinProgram(name, data, starts, style=style_of(data, blocks), **parts)
