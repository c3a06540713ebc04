# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has set once for all: the page in FreeCAD's preferences, and what forms begin with.

Preferences change what a form shows when it opens, never what a recorded macro or a document means.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

PAGE = Path(__file__).resolve().parents[2] / "resources" / "ui" / "preferences.ui"
"""The page."""

PLACE = "User parameter:BaseApp/Preferences/Mod/Millcorr"
"""Where FreeCAD keeps them."""

DEFAULTS: dict[str, Any] = {
    "Filter": "auto",
    "Gain": 1.0,
    "Limit": 0.5,
    "DeadBand": 0.0,
    "Tolerance": 0.001,
    "Points": 0,
    "BallRadius": 0.0,
    "AutomaticMagnification": True,
    "Magnification": 500.0,
    "UpperLimit": 0.01,
    "LowerLimit": -0.01,
    "MaterialLeft": 0,
    "ShowPicture": True,
    "Dialect": 0,
    "TouchFeed": 100.0,
    "PositioningFeed": 1000.0,
    "Plots": 0,
    "LastDirectory": "",
}
"""Every preference and what it is where nothing was set; choices are counted from 0."""

LOOK = ("AutomaticMagnification", "Magnification", "UpperLimit", "LowerLimit", "MaterialLeft")
"""Preferences of pictures; properties of a dressup's view have the same names."""

CHOICES = {
    "Points": ("as the file says", "contact", "centre", "axis"),
    "Dialect": ("linuxcnc-protected", "linuxcnc", "grbl", "fanuc", "haas", "okuma", "heidenhain", "siemens"),
    "Plots": ("as the window", "light", "dark"),
    "MaterialLeft": ("blue", "red"),
}
"""What the numbers of choices stand for, in the order of the page."""


def get(name: str) -> Any:
    """Value of a preference; KeyError for a name that is none."""
    usual = DEFAULTS[name]
    parameters = FreeCAD.ParamGet(PLACE)
    if isinstance(usual, bool):
        return parameters.GetBool(name, usual)
    if isinstance(usual, int):
        at = parameters.GetInt(name, usual)
        return CHOICES[name][at if 0 <= at < len(CHOICES[name]) else usual]
    if isinstance(usual, float):
        return parameters.GetFloat(name, usual)
    return parameters.GetString(name, usual)


def put(name: str, value: Any) -> None:
    """Set a preference; KeyError for a name that is none."""
    usual = DEFAULTS[name]
    parameters = FreeCAD.ParamGet(PLACE)
    if isinstance(usual, bool):
        parameters.SetBool(name, bool(value))
    elif isinstance(usual, int):
        parameters.SetInt(name, CHOICES[name].index(value))
    elif isinstance(usual, float):
        parameters.SetFloat(name, float(value))
    else:
        parameters.SetString(name, str(value))


def correction_values() -> dict[str, Any]:
    """Settings that a new correction begins with, by field."""
    return {name: get(name) for name in ("Filter", "Gain", "Limit", "DeadBand", "Tolerance")}


def form_values() -> dict[str, Any]:
    """Values that a form on files begins with, by field."""
    return correction_values() | {name: get(name) for name in ("Points", "BallRadius")}


def look_values() -> dict[str, Any]:
    """How a new picture looks, by field."""
    return {name: get(name) for name in LOOK}


def add_page() -> None:
    """Add the page to FreeCAD's preferences."""
    FreeCADGui.addPreferencePage(str(PAGE), "Millcorr")
