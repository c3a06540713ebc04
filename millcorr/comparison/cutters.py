# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which cutter every move of a program runs with: its radius, where that is known.

Programs rough and finish with several tools. The diameter that a user gives is that of the tool that made the measured
surface; others are stated apart, or in the program's comments. A pass whose radius is not known is never moved, and
leaves no surface to reckon with.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.nc.toolpath import Compensation, Kind, Toolpath, named_tool
from millcorr.readers.measurement import Measurement

from .path_distance import PathDistance

SAMPLE = 500
"""So many points, evenly taken, tell which tool made them."""

_IN_COMMENT = re.compile(
    r"\bT\s*=?\s*(?:(\d+)\b|\"([^\"]+)\")[^()]*?\b(D(?:IA(?:METER)?)?\s*[=:]?)\s*(\d+(?:\.\d*)?|\.\d+)", re.IGNORECASE
)

_OFFSETS = re.compile(r"\bH\s*\d+\b", re.IGNORECASE)
"""Beside the number of a length offset, D is the number of a radius offset."""


def stated_diameters(comments: Sequence[tuple[int, str]], scale: float) -> dict[int, float]:
    """Diameters in mm that comments state of tools, such as ``T4 D10 END MILL``, by tool number (`named_tool`).

    Parameters
    ----------
    comments : sequence of (int, str)
        Line and text.
    scale : float
        mm per unit of the program.
    """
    out: dict[int, float] = {}
    for _, text in comments:
        found = _IN_COMMENT.search(text)
        if found is None or _OFFSETS.search(text):
            continue
        number, name, word, length = found.groups()
        # D4 beside T4 is the number of an offset as likely as a diameter, and so is D1 beside a name.
        plain = number is None and word.strip().upper() == "D" or number is not None and float(number) == float(length)
        if float(length) > 0 and ("." in length or not plain):
            out.setdefault(named_tool((number or name).encode("latin-1")), scale * float(length))
    return out


def cutter_radii(
    toolpath: Toolpath,
    radius: float,
    path_radius: float,
    stated: Mapping[int, float],
    measurement: Measurement | None,
) -> tuple[Floats, tuple[int, ...]]:
    """Radius of the cutter of every move.

    Parameters
    ----------
    toolpath : Toolpath
    radius : float
        Of the tool that made the measured surface, mm.
    path_radius : float
        Distance in mm from path to contour under G41 and G42: 0 where the control takes the radius into account.
    stated : mapping of int to float
        Diameters of tools that are known otherwise, mm.
    measurement : Measurement or None

    Returns
    -------
    radii : (n,) float64
        mm; 0 under compensation where the path is the contour, and NaN of moves without it in such a program, which
        begin where the control has put the cutter. NaN, too, of tools that nothing is known of.
    unknown : tuple of int
        Numbers of such tools.
    """
    progress.step()
    compensated = toolpath.compensation != Compensation.OFF
    out = np.where(compensated, path_radius, np.nan if path_radius == 0 else radius)
    cuts = (toolpath.kind != Kind.RAPID) & np.isfinite(toolpath.end[:, :2]).all(axis=1)
    tools = np.unique(toolpath.tool[cuts])
    if len(tools) < 2:
        return out, ()
    mine = _tool_of(toolpath, cuts, tools.tolist(), radius, path_radius, stated, measurement)
    if mine is None:
        return out, ()
    unknown = []
    for tool in tools[tools != mine].tolist():
        rows = (toolpath.tool == tool) & ~compensated
        out[rows] = stated[tool] / 2 if tool in stated else np.nan
        out[(toolpath.tool == tool) & compensated & (path_radius > 0)] = stated.get(tool, np.nan) / 2
        out[(toolpath.tool == tool) & compensated & (path_radius == 0)] = np.nan
        if tool not in stated:
            unknown.append(int(tool))
    return out, tuple(unknown)


def _tool_of(
    toolpath: Toolpath,
    cuts: Bools,
    tools: list[int],
    radius: float,
    path_radius: float,
    stated: Mapping[int, float],
    measurement: Measurement | None,
) -> int | None:
    """The tool whose radius is given: the one that is stated with it, else the one that runs so far from the points."""
    same = [tool for tool in tools if abs(stated.get(tool, 0.0) - 2 * radius) < 1e-6]
    others = [tool for tool in tools if tool not in stated]
    if len(same) == 1 and not others:
        return same[0]
    if measurement is None:
        return same[0] if len(same) == 1 else None
    away = abs(path_radius - measurement.ball_radius), abs(radius - measurement.ball_radius)
    return nearest_group(toolpath, cuts, toolpath.tool, same + others or tools, away, measurement)


def nearest_group(
    toolpath: Toolpath,
    cuts: Bools,
    group: Ints,
    candidates: Sequence[int],
    away: tuple[float, float],
    measurement: Measurement,
) -> int:
    """Which group of moves runs as far from the points as the one that made them.

    Parameters
    ----------
    toolpath : Toolpath
    cuts : (n,) bool
        Moves to look at.
    group : (n,) int64
        Number of the group of each move, such as its tool or its work offset.
    candidates : sequence of int
        Groups to choose from; of two that run alike the first.
    away : (float, float)
        Distance in mm of the points from moves with and without compensation.
    measurement : Measurement
    """
    points = measurement.points[:: max(1, len(measurement) // SAMPLE), :2]
    off = np.full((len(candidates), len(points)), np.inf)
    for k, number in enumerate(candidates):
        rows = np.flatnonzero(cuts & (group == number))
        if len(rows):
            compensated = bool((toolpath.compensation[rows] != Compensation.OFF).any())
            off[k] = np.abs(PathDistance(toolpath, rows)(points) - away[0 if compensated else 1])
    nearest = (off <= off.min(axis=0) + 1e-6).argmax(axis=0)
    return int(candidates[int(np.bincount(nearest, minlength=len(candidates)).argmax())])
