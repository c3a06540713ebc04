# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which the window shows lengths: FreeCAD's, as its user has chosen it."""

from __future__ import annotations

from dataclasses import replace

from millcorr.report.length_unit import INCH, MM, LengthUnit

from .text import translate

_INCHES = frozenset({"thou", "mil", "in", '"', "ft", "'", "yd", "mi"})
"""Units that FreeCAD's schemas of inches give to an inch."""


def chosen() -> LengthUnit:
    """Inches where FreeCAD's unit schema is one of inches, else millimetres; millimetres without FreeCAD."""
    try:
        from FreeCAD import Units
    except ImportError:
        return MM
    _, _, name = Units.Quantity(25.4, Units.Length).getUserPreferred()
    return INCH if name in _INCHES else MM


def unit() -> LengthUnit:
    """The same with its names in the window's language."""
    if chosen() is INCH:
        return replace(INCH, name=translate("Millcorr", "in"), fine=translate("Millcorr", "thou"))
    return replace(MM, name=translate("Millcorr", "mm"), fine=translate("Millcorr", "\u00b5m"))
