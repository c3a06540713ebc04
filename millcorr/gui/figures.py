# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a correction, as a table for a panel: what was measured, what will change, what to expect."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any

from millcorr.app.text import QT_TRANSLATE_NOOP, translate
from millcorr.app.unit import unit

_text = QT_TRANSLATE_NOOP

NONE = "\u2013"
"""Shown where there is no figure."""


@dataclass(frozen=True, slots=True)
class Figure:
    """One row of the table.

    Parameters
    ----------
    label, meaning : str
        Name, and what it means; translated.
    shown : tuple of str
        One text for each column, with sign where it has one; lengths in mm.
    """

    label: str
    meaning: str
    shown: tuple[str, ...]


COLUMNS = (_text("Millcorr", "measured"), _text("Millcorr", "expected"))
"""Headings of the columns of deviations: of this part, and of the next one after the correction."""

_DEVIATIONS = (
    ("mean", True, _text("Millcorr", "Mean"), _text("Millcorr", "Mean deviation; positive where material is left")),
    ("min", True, _text("Millcorr", "Least"), _text("Millcorr", "Deepest undercut")),
    ("max", True, _text("Millcorr", "Greatest"), _text("Millcorr", "Most material left")),
    ("height", False, _text("Millcorr", "Height"), _text("Millcorr", "Greatest less least")),
    ("std", False, _text("Millcorr", "Std. dev."), _text("Millcorr", "Spread of deviations about their mean")),
)

_LENGTHS = (
    (("random_std",), _text("Millcorr", "Scatter"),
     _text("Millcorr", "Standard deviation of what does not repeat and is therefore not corrected")),
    (("correction", "max"), _text("Millcorr", "Largest correction"),
     _text("Millcorr", "Farthest that the profile to cut lies from the nominal")),
    (("path_error_of_program",), _text("Millcorr", "Path error before"),
     _text("Millcorr", "How far the operation's own path is off the exact one")),
    (("verification", "path_error_max"), _text("Millcorr", "Path error after"),
     _text("Millcorr", "How far the corrected path is off the exact one, read back from the finished path")),
)  # fmt: skip

_COUNTS = (
    (_text("Millcorr", "Points used"), _text("Millcorr", "Points used, of those in the file")),
    (_text("Millcorr", "Points left out"), _text("Millcorr", "Each is marked in the picture, with its reason")),
)


def length(value: float | None, signed: bool) -> str:
    """A length in mm as the panel shows it, under a heading with the window's unit; a dash where there is none."""
    if value is None or not isfinite(value):
        return NONE
    shown = unit()
    plain = shown.number(value)
    return plain if not signed or float(plain) == 0 else shown.number(value, "+")


def figures_of(summary: Mapping[str, Any] | None) -> list[Figure]:
    """Figures of a correction.

    Parameters
    ----------
    summary : mapping or None
        `pipeline.Result.summary`; None where nothing was computed: every figure is a dash.

    Returns
    -------
    list of Figure
        Always the same ones in the same order; first those with two columns.
    """
    out = []
    for key, signed, label, meaning in _DEVIATIONS:
        values = (None, None) if summary is None else (summary["deviation"][key], summary["predicted"][key])
        out.append(_figure(label, meaning, *(length(value, signed) for value in values)))
    for keys, label, meaning in _LENGTHS:
        value: Any = summary
        for key in keys:
            value = None if value is None else value[key]
        out.append(_figure(label, meaning, length(value, False)))
    counts = (NONE, NONE)
    if summary is not None:
        points = summary["points"]
        counts = f"{points['used']} / {points['read']}", str(points["left_out"])
    return out + [_figure(label, meaning, text) for (label, meaning), text in zip(_COUNTS, counts, strict=True)]


def _figure(label: str, meaning: str, *shown: str) -> Figure:
    return Figure(translate("Millcorr", label), translate("Millcorr", meaning), shown)
