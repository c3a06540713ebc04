# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calibration of a touch probe, written down once as TOML."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from millcorr.errors import FormatError
from millcorr.messages import joined, phrase
from millcorr.readers.measurement import INTERPOLATIONS, Probe

from .source import LARGEST_BALL, shown
from .toml_table import toml_table

KEYS = ("name", "radius", "control_radius", "offset", "directions", "radii", "interpolation")
"""What a probe's file can say; see docs/probe-radius.md."""

_LARGEST_OFFSET = 100.0
_LONGEST_TABLE = 3600


def load(path: str | Path) -> Probe:
    """Probe from a TOML file: lengths in mm, directions in degrees from X+ anticlockwise.

    Raises
    ------
    FormatError
        If the file cannot be read, or a key is unknown, missing or has no such value; names the file and the key.
    """
    table = toml_table(path, phrase("probe"), KEYS)
    if not isinstance(table.get("name", ""), str):
        raise FormatError(phrase("name is a text, not {}", shown(repr(table["name"]))), path)
    radii = _numbers(table, "radii", path, 0.0, LARGEST_BALL)
    directions = _numbers(table, "directions", path, -360.0, 360.0)
    if (radii is None) != (directions is None):
        raise FormatError(
            phrase("{} is missing: the two go together", "radii" if radii is None else "directions"), path
        )
    radius = _numbers(table, "radius", path, 0.0, LARGEST_BALL, (0,))
    if radius is None:
        if radii is None:
            raise FormatError(phrase("radius is missing: the effective radius of the ball in mm"), path)
        radius = np.array(float(radii.mean()))
    control = _numbers(table, "control_radius", path, 0.0, LARGEST_BALL, (0, 2))
    offset = _numbers(table, "offset", path, -_LARGEST_OFFSET, _LARGEST_OFFSET, (2,))
    interpolation = table.get("interpolation", INTERPOLATIONS[0])
    if interpolation not in INTERPOLATIONS:
        wanted = phrase(" or ").join(INTERPOLATIONS)
        raise FormatError(phrase("interpolation is {}, not {}", wanted, shown(repr(interpolation))), path)
    return Probe(
        float(radius),
        None if directions is None else np.radians(directions),
        radii,
        interpolation,
        (0.0, 0.0) if offset is None else (float(offset[0]), float(offset[1])),
        None if control is None else (float(control.flat[0]), float(control.flat[-1])),
        str(path),
    )


def _numbers(
    table: dict[str, Any], key: str, path: str | Path, low: float, high: float, sizes: tuple[int, ...] = ()
) -> Any:
    """Value of a key as an array: a number where 0 is among `sizes`, or a list of one of these lengths, or of any."""
    if key not in table:
        return None
    value = table[key]
    many = value if isinstance(value, list) else [value]
    plain = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in many)
    size = len(value) if isinstance(value, list) else 0
    fits = size in sizes if sizes else 3 <= size <= _LONGEST_TABLE
    if not (plain and fits and all(math.isfinite(v) and low <= v <= high for v in many)):
        lists = [phrase("a list of {} numbers", n) if n else phrase("a number") for n in sizes] or [
            phrase("a list of at least 3 numbers")
        ]
        wanted = phrase("{} from {:g} to {:g}", joined(lists, phrase(" or ")), low, high)
        raise FormatError(phrase("{} is {}, not {}", key, wanted, shown(repr(value))), path)
    return np.array(value, dtype=np.float64)
