# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounds of a correction: a part is cut, measured and the path corrected; the next part is cut with that path.

One dressup holds all of them. The newest round are its properties `Measurement` and `FurtherParts` with its settings;
the earlier ones keep the settings with which their path was made, and the path itself, for the parts that came after
were cut with it. A part that is switched off counts for nothing; a round without parts is passed over.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.process import setup_file
from millcorr.process.setup_file import Setup

from . import draft

_ALL_ROUNDS = (
    "Base",
    "Measurement",
    "FurtherParts",
    "EarlierParts",
    "EarlierRounds",
    "SwitchedOff",
    "Nominal",
    "ToolDiameter",
    "Setup",
)
"""Properties that are no settings of one round."""


@dataclass(frozen=True, slots=True)
class Round:
    """One round that counts.

    Parameters
    ----------
    parts : tuple of document object
        Its measurements that are switched on.
    values : object
        Has the settings of the dressup as attributes.
    setup : Setup or None
    smoothed, cut : str
        The dressup's `Smoothed` and `CutPath` of that round.
    begun, left : str
        SHA-256 of the operation's path that it began with, and the path that it left, as G-code; empty where that is
        to be computed.
    """

    parts: tuple[Any, ...]
    values: Any
    setup: Setup | None
    smoothed: str
    cut: str
    begun: str = ""
    left: str = ""


def rounds_of(obj: Any) -> list[Round]:
    """Rounds of a dressup or a draft that count, oldest first; the newest has its own settings."""
    out = []
    parts, begin = list(getattr(obj, "EarlierParts", [])), 0
    for text in getattr(obj, "EarlierRounds", []):
        said = json.loads(text)
        end = begin + said["parts"]
        setup = None if said["setup"] is None else setup_file.from_dict(tomllib.loads(said["setup"]), said["named"])
        # The path that it left holds for the parts that counted then.
        left = said["left"] if [is_on(obj, part) for part in parts[:end]] == said["on"] else ""
        values = draft.Draft(obj.Label, said["settings"])
        on = _on(obj, parts[begin:end])
        out.append(Round(on, values, setup, said["smoothed"], said["cut"], said["begun"], left))
        begin = end
    smoothed, cut = getattr(obj, "Smoothed", ""), getattr(obj, "CutPath", "")
    out.append(Round(_on(obj, newest_parts(obj)), obj, setup_of(obj), smoothed, cut))
    return [one for one in out if one.parts]


def setup_of(obj: Any) -> Setup | None:
    """Setup of a dressup where its method needs one."""
    place = getattr(obj, "Setup", "")
    if not place or obj.Method not in ("combined", "predicted"):
        return None
    # The copy in the document lies elsewhere every time.
    return setup_file.from_dict(tomllib.loads(_text_of(place)), Path(place).name)


def newest_parts(obj: Any) -> list[Any]:
    """Measured parts of the newest round, on or off."""
    return [] if obj.Measurement is None else [obj.Measurement, *obj.FurtherParts]


def parts_of(obj: Any) -> list[Any]:
    """All measured parts of a dressup or a draft, newest last, on or off."""
    return [*getattr(obj, "EarlierParts", []), *newest_parts(obj)]


def is_on(obj: Any, part: Any) -> bool:
    """Whether a measured part counts."""
    return part.Name not in {off.Name for off in getattr(obj, "SwitchedOff", [])}


def added(obj: Any, settings: Mapping[str, Any], measurement: Any, begun: str) -> dict[str, Any]:
    """What a dressup's properties become when a newly measured part is added to those that it has.

    Parameters
    ----------
    obj : document object
        The dressup.
    settings : mapping of str to object
        Its properties that are no results, as `draft.values_of` gives them.
    measurement : document object
    begun : str
        SHA-256 of the path of the operation below it.

    Returns
    -------
    dict of str to object
        Those that change.

    Raises
    ------
    UsageError
        If the part is there already.
    """
    if measurement.Name in {part.Name for part in parts_of(obj)}:
        raise UsageError(
            phrase("{} is a measured part of {} already: switch it on instead", measurement.Label, obj.Label)
        )
    if obj.Measurement is None:
        return {"Measurement": measurement}
    kept = {name: value for name, value in settings.items() if name not in _ALL_ROUNDS}
    place = settings["Setup"]
    one = {
        "parts": len(newest_parts(obj)),
        "settings": kept,
        "setup": _text_of(place) if place else None,
        "named": Path(place).name,
        "smoothed": obj.Smoothed,
        "cut": obj.CutPath,
        "on": [is_on(obj, part) for part in parts_of(obj)],
        "begun": begun,
        # One that is still to be computed is not the one that any part was cut with.
        "left": obj.Path.toGCode() if obj.Path.Commands and not {"Touched", "Invalid"} & set(obj.State) else "",
    }
    return {
        "EarlierParts": parts_of(obj),
        "EarlierRounds": [*obj.EarlierRounds, json.dumps(one, sort_keys=True)],
        "Measurement": measurement,
        "FurtherParts": [],
        "Accept": [],
    }


def _on(obj: Any, parts: list[Any]) -> tuple[Any, ...]:
    return tuple(part for part in parts if is_on(obj, part))


def _text_of(place: str) -> str:
    setup_file.load(place)
    return Path(place).read_text(encoding="utf-8")
