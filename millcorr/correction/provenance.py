# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mark a corrected program carries: from what, with what, when. It makes applying twice detectable."""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import NoReturn

import numpy as np

from millcorr import __version__
from millcorr.arrays import Ints
from millcorr.comparison.deviation import Deviation
from millcorr.errors import InputError, RefusedError
from millcorr.geometry.profile import Profile
from millcorr.messages import option, phrase

PLACES = 24
"""So many deviations are noted of each part."""

ENOUGH = 20
"""So many of them that agree are the same part: near corners other points may be left out."""

TENTHS = 1e4
"""Tenths of a micrometre in a millimetre."""

MODULUS = 4096
"""Three hexadecimal digits hold deviations of -0.2 to 0.2 mm; larger ones come round again."""

_SHORT = 16
_BEGIN = re.compile(r"\bMILLCORR\s+\S+\s+CORRECTED\s+(?P<date>\d{4}-\d\d-\d\d)\b", re.IGNORECASE)
_REST = re.compile(
    r"\s+MEASUREMENT\s+(?P<measured>[0-9A-F]{16}(?:[\s+]+[0-9A-F]{16})*)\s+SOURCE\s+(?P<source>[0-9A-F]{16})\b",
    re.IGNORECASE,
)
_VALUES = re.compile(r"\bVALUES((?:\s+[0-9A-F]{24})+)(?![0-9A-F])", re.IGNORECASE)
_GAIN = re.compile(r"\bGAIN\s+(\d+(?:\.\d+)?)\b", re.IGNORECASE)
_GROUP = 24
_LINES = 40
"""A mark with many measurements is wrapped into at most this many comments."""


@dataclass(frozen=True, eq=False, slots=True)
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
    values : (m, 24) int64
        What `values_of` gave of each part; none where the program is older than they are.
    """

    line: int
    date: str
    measured: tuple[str, ...]
    source: str
    values: Ints


def header(
    measured: Sequence[tuple[str, str]], source: tuple[str, str], settings: str, values: Sequence[Ints] = ()
) -> tuple[str, ...]:
    """Comment lines for a corrected program.

    Parameters
    ----------
    measured : sequence of (name, digest)
        The measured files.
    source : (name, digest)
        The program before the correction.
    settings : str
        Settings in words.
    values : sequence of (24,) int64
        `values_of` each part.
    """
    today = datetime.date.today().isoformat()
    # Parted by blanks, so that a long row of digests can be wrapped into comments that a control shows.
    digests = " ".join(digest[:_SHORT] for _, digest in measured)
    names = " ".join(PurePath(name).name for name, _ in measured)
    return (
        f"millcorr {__version__} corrected {today} measurement {digests} source {source[1][:_SHORT]}",
        f"from {PurePath(source[0]).name} measured {names}",
        settings,
        *([f"values {' '.join(_in_text(row) for row in values)}"] if values else []),
    )


def values_of(deviation: Deviation, profile: Profile) -> Ints:
    """Deviations at places spread over the contours: recognises a measurement saved with other digits or otherwise.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    profile : Profile

    Returns
    -------
    (24,) int64
        In 0.1 um, modulo 4096, of the lowest level's points nearest to the places.
    """
    before = np.concatenate([[0.0], np.cumsum(profile.total)])
    rows = np.flatnonzero(deviation.level == deviation.level.min())
    along = before[deviation.contour[rows]] + deviation.s[rows]
    # No fraction of the length, where evenly spread points may lie equally near on both sides.
    places = (np.arange(PLACES) + 0.381966) * before[-1] / PLACES
    order = np.argsort(along, kind="stable")
    after = np.clip(np.searchsorted(along[order], places), 1, max(len(rows) - 1, 1))
    sides = np.stack([order[after - 1], order[np.minimum(after, len(rows) - 1)]])
    nearest = sides[np.abs(along[sides] - places).argmin(axis=0), np.arange(PLACES)]
    out: Ints = np.round(deviation.value[rows[nearest]] * TENTHS).astype(np.int64) % MODULUS
    return out


def _in_text(values: Ints) -> str:
    digits = "".join(f"{value:03X}" for value in values)
    return " ".join(digits[i : i + _GROUP] for i in range(0, len(digits), _GROUP))


def _from_text(text: str) -> Ints:
    digits = "".join(text.split())
    return np.array([int(digits[i : i + 3], 16) for i in range(0, len(digits), 3)], dtype=np.int64).reshape(-1, PLACES)


def recognised(carried: Sequence[Mark], values: Ints, step: float) -> Mark | None:
    """The mark of a correction that was made from these values, in other digits; None where there is none.

    Parameters
    ----------
    carried : sequence of Mark
    values : (24,) int64
        `values_of` the measurement.
    step : float
        Resolution of its file in mm.

    Notes
    -----
    Rounding two coordinates on either side moves a deviation by up to one step. A part of the corrected program
    differs by all that was corrected: where that is itself no more than digits so coarse can hide, nothing is said.
    """
    within = step * TENTHS + 1.0
    for mark in carried:
        same = np.abs(_signed(values - mark.values)) <= within
        told = np.abs(_signed(mark.values)) > 2 * within
        if ((same.sum(axis=1) >= ENOUGH) & (2 * told.sum(axis=1) > PLACES)).any():
            return mark
    return None


def _signed(values: Ints) -> Ints:
    """Values modulo `MODULUS` as the nearest to zero."""
    return (values + MODULUS // 2) % MODULUS - MODULUS // 2


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
        # Up to the next mark.
        joined = joined[: (later.start() if (later := _BEGIN.search(joined)) else len(joined))]
        rest = _REST.match(joined)
        if not rest:
            raise InputError(
                phrase(
                    "line {}: the comment that says which measurement corrected this program is damaged; take "
                    "the corrected program as it was written",
                    line + 1,
                )
            )
        digests = tuple(d.lower() for d in re.split(r"[\s+]+", rest["measured"]))
        values = _VALUES.search(joined, rest.end())
        whole = values is not None and len("".join(values[1].split())) % (3 * PLACES) == 0
        table = _from_text(values[1] if values is not None and whole else "")
        found.append(Mark(line + 1, begin["date"], digests, rest["source"].lower(), table))
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


def refuse_mark(mark: Mark, program: str) -> NoReturn:
    """RefusedError for a measurement that was applied with a mark already."""
    raise RefusedError(
        phrase(
            "{}:{}: this measurement was applied on {} already; cut and measure a new part with the "
            "corrected program first",
            program,
            mark.line,
            mark.date,
        )
    )


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
        refuse_mark(mark, program)
    if carried and not has_nominal:
        raise InputError(
            phrase(
                "{}:{}: the program was corrected on {}, so it does not show the nominal any more; give the "
                "first, uncorrected program or the drawing with {}",
                program,
                carried[-1].line,
                carried[-1].date,
                option("nominal"),
            ),
        )
