# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a transfer function, as a table for a panel."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import Any

from millcorr.app.text import QT_TRANSLATE_NOOP, translate

from .figures import NONE, Figure, length

_text = QT_TRANSLATE_NOOP

_ROWS = (
    ("ms_mean", _text("Millcorr", "MS, mean"), _text("Millcorr", "Share of the depth removed that the machine yields")),
    ("ms_min", _text("Millcorr", "MS, least"), _text("Millcorr", "Where the machine is stiffest")),
    ("ms_max", _text("Millcorr", "MS, greatest"), _text("Millcorr", "Where the machine yields most")),
    ("ms_uncertainty", _text("Millcorr", "Uncertainty of MS"), _text("Millcorr", "Standard uncertainty at a point")),
)
_LENGTHS = (
    ("next_depth", _text("Millcorr", "Next depth"), _text("Millcorr", "Depth that the corrected path will find")),
    (
        "correction_uncertainty",
        _text("Millcorr", "Uncertainty of the correction"),
        _text("Millcorr", "Standard uncertainty of where the path is put"),
    ),
)
_OFFSET = (
    _text("Millcorr", "Constant offset"),
    _text("Millcorr", "What stays whatever the depth, such as a wrong tool radius; known from two depths only"),
)


def transfer_figures(summary: Mapping[str, Any] | None) -> list[Figure]:
    """Figures of the transfer function in a summary; dashes where there is none.

    Parameters
    ----------
    summary : mapping or None
        `pipeline.Result.summary`.
    """
    found = None if summary is None else summary["transfer"]
    out = [_figure(label, meaning, _number(found, key)) for key, label, meaning in _ROWS]
    for key, label, meaning in _LENGTHS:
        out.append(_figure(label, meaning, length(None if found is None else found[key], False)))
    offset = None if found is None or found["offset"] is None else found["offset"]["mean"]
    return [*out, _figure(*_OFFSET, length(offset, True))]


def _number(found: Mapping[str, Any] | None, key: str) -> str:
    value = None if found is None else found[key]
    return NONE if value is None or not isfinite(value) else f"{value:.4f}"


def _figure(label: str, meaning: str, shown: str) -> Figure:
    return Figure(translate("Millcorr", label), translate("Millcorr", meaning), (shown,))
