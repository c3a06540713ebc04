# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mark a corrected program carries: from what, with what, when. It makes applying twice detectable."""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import PurePath

from . import __version__
from .errors import InputError, RefusedError

_SHORT = 16
_BEGIN = re.compile(r"\bMILLCORR\s+\S+\s+CORRECTED\s+(?P<date>\d{4}-\d\d-\d\d)\b", re.IGNORECASE)
_REST = re.compile(
    r"\s+MEASUREMENT\s+(?P<measured>[0-9A-F]{16}(?:[\s+]+[0-9A-F]{16})*)\s+SOURCE\s+(?P<source>[0-9A-F]{16})\b",
    re.IGNORECASE,
)
_GAIN = re.compile(r"\bGAIN\s+(\d+(?:\.\d+)?)\b", re.IGNORECASE)
_LINES = 40
"""A mark with many measurements is wrapped into at most this many comments."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A correction that a program carries.

    Parameters
    ----------
    line : int
        Line of the comment, from 1.
    date : str
    measured : tuple of str
        First 16 digits of the SHA-256 of each measured file that was applied.
    source : str
        First 16 digits of the SHA-256 of the program before that correction.
    """

    line: int
    date: str
    measured: tuple[str, ...]
    source: str


def header(measured: Sequence[tuple[str, str]], source: tuple[str, str], settings: str) -> tuple[str, ...]:
    """Comment lines for a corrected program.

    Parameters
    ----------
    measured : sequence of (name, digest)
        The measured files.
    source : (name, digest)
        The program before the correction.
    settings : str
        Settings in words.
    """
    today = datetime.date.today().isoformat()
    # Parted by blanks, so that a long row of digests can be wrapped into comments that a control shows.
    digests = " ".join(digest[:_SHORT] for _, digest in measured)
    names = " ".join(PurePath(name).name for name, _ in measured)
    return (
        f"millcorr {__version__} corrected {today} measurement {digests} source {source[1][:_SHORT]}",
        f"from {PurePath(source[0]).name} measured {names}",
        settings,
    )


def marks(comments: Iterable[tuple[int, str]]) -> tuple[Mark, ...]:
    """Corrections that a program carries.

    Parameters
    ----------
    comments : iterable of (int, str)
        Line, counted from 0, and text of each comment in their order; one mark may be wrapped into several.

    Raises
    ------
    InputError
        If a mark is damaged, so that nobody can tell which measurement was applied.
    """
    listed = list(comments)
    found = []
    for i, (line, text) in enumerate(listed):
        begin = _BEGIN.search(text)
        if not begin:
            continue
        joined = " ".join([text[begin.end() :], *(more for _, more in listed[i + 1 : i + _LINES])])
        rest = _REST.match(joined)
        if not rest:
            raise InputError(
                f"line {line + 1}: the comment that says which measurement corrected this program is damaged; take "
                "the corrected program as it was written"
            )
        digests = tuple(d.lower() for d in re.split(r"[\s+]+", rest["measured"]))
        found.append(Mark(line + 1, begin["date"], digests, rest["source"].lower()))
    return tuple(found)


def gain(comments: Iterable[tuple[int, str]]) -> float:
    """Gain of the first correction that a program carries, 1 where it does not say."""
    joined = " ".join(text for _, text in comments)
    begin = _BEGIN.search(joined)
    found = _GAIN.search(joined, begin.end()) if begin else None
    return float(found[1]) if found else 1.0


def applied(carried: Sequence[Mark], digests: Sequence[str]) -> Mark | None:
    """The mark of a correction that was made from one of the measurements; None where there is none."""
    given = {d[:_SHORT].lower() for d in digests}
    return next((mark for mark in carried if given & set(mark.measured)), None)


def refuse_second_use(carried: Sequence[Mark], digests: Sequence[str], program: str, has_nominal: bool) -> None:
    """Refuse to apply a measurement twice, or to take a corrected program for the nominal.

    Raises
    ------
    RefusedError
        If one of the measurements is in the program already.
    InputError
        If the program was corrected before and no nominal is given.
    """
    mark = applied(carried, digests)
    if mark is not None:
        raise RefusedError(
            f"{program}:{mark.line}: this measurement was applied on {mark.date} already; cut and measure a "
            "new part with the corrected program first"
        )
    if carried and not has_nominal:
        raise InputError(
            f"{program}:{carried[-1].line}: the program was corrected on {carried[-1].date}, so it does not show the "
            "nominal any more; give the first, uncorrected program or the drawing with --nominal"
        )
