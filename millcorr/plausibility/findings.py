# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings: what a user should know about a measurement before correcting from it, by name."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from millcorr.errors import DistrustError, UsageError
from millcorr.messages import Accepted, message, option, phrase

NAMES = (
    "unit",
    "mirrored",
    "turned",
    "ball-not-compensated",
    "axis-compensated",
    "not-axis-compensated",
    "axis-radius",
    "compensated-twice",
    "diameter-for-radius",
    "radius-for-diameter",
    "wrong-side",
    "constant-offset",
    "step",
    "misalignment",
    "scale",
    "identical-to-nominal",
    "wrong-level",
    "below-the-cut",
    "above-the-cut",
    "thin-wall",
    "normals-reversed",
    "outliers",
    "unmeasured",
    "earlier-program",
    "same-part",
    "first-part",
    "coarse-resolution",
    "height-map",
    "implausible-radius",
    "implausible-extent",
    "many-levels",
    "other-nominal",
    "stated-deviations",
    "many-rejected",
)
"""What ``--accept`` takes; docs/distrust.md says what each means."""


@dataclass(frozen=True, slots=True)
class Finding:
    """Something about a measurement that a user should know before correcting from it.

    Parameters
    ----------
    name : str
        One of `NAMES`; what ``--accept`` takes.
    text : str
        What was seen, with its figure, and what to do.
    dangerous : bool
        True where correcting would probably scrap the part.
    place : (float, float), optional
        Where in XY, mm.
    figure : float, optional
        How much: of a length mm, of a part of the whole its share.
    """

    name: str
    text: str
    dangerous: bool
    place: tuple[float, float] | None = None
    figure: float | None = None


def refuse_dangerous(findings: Iterable[Finding], accepted: Collection[str], source: str) -> tuple[str, ...]:
    """Stop at the first dangerous finding that was not accepted.

    Parameters
    ----------
    findings : iterable of Finding
    accepted : collection of str
        Names the user accepts.
    source : str
        Name of the measured file.

    Returns
    -------
    tuple of str
        Notes for the report: harmless findings, and accepted ones, marked as such.

    Raises
    ------
    UsageError
        If a name to accept does not exist.
    DistrustError
        If a dangerous finding was not accepted.
    """
    unknown = sorted(set(accepted) - set(NAMES))
    if unknown:
        raise UsageError(
            phrase("{}: there is no such finding; known are {}", option("accept", unknown[0]), ", ".join(NAMES))
        )
    notes = []
    for finding in findings:
        if finding.dangerous and finding.name not in accepted:
            raise DistrustError(
                f"{source}: ", finding.text, finding=finding.name, place=finding.place, figure=finding.figure
            )
        accept = Accepted(finding.name, finding.place)
        notes.append(phrase("accepted {}: {}", accept, finding.text) if finding.dangerous else finding.text)
    return tuple(notes)


def named(source: str, notes: Iterable[str]) -> tuple[str, ...]:
    """Notes with the name of the file they belong to; as they are where `source` is empty."""
    return tuple(message(f"{source}: ", note) if source else note for note in notes)
