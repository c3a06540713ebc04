# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour check: a program's path, the contour it stands for, and measured points beside it.

Petrakov 2018 recognises path and theoretical contour from the milling program alone, with the slope angle of the
contour everywhere, and compares the points that a probe touched along the normal.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.comparison.theoretical_contour import path_profile
from millcorr.decimal_text import lines
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.path_following import length_in_plane
from millcorr.pipeline import Result

STATIONS_APART = 1.0
"""Stations along the path are at most this far apart, in mm."""

STATIONS_TURN = np.radians(5.0)
"""An arc of the path turns by at most this between two stations."""


@dataclass(frozen=True, eq=False, slots=True)
class PathStations:
    """The program's path in its own order, and the theoretical contour beside it; one row a station.

    Parameters
    ----------
    line : (m,) int64
        Line of the program, from 1.
    path : (m, 2) float64
        Cutter centre (or the programmed contour, where the control offsets it), mm.
    contour : (m,) int64
        Contour of the nominal.
    s : (m,) float64
        Arc length from that contour's start, mm.
    point, normal : (m, 2) float64
        Theoretical contour in mm, and its normal out of the material.
    """

    line: Ints
    path: Floats
    contour: Ints
    s: Floats
    point: Floats
    normal: Floats

    def __len__(self) -> int:
        return len(self.line)


@dataclass(frozen=True, eq=False, slots=True)
class TouchedPoints:
    """Measured points against the theoretical contour; one row a used point.

    Parameters
    ----------
    line : (n,) int64
        Line of the measured file, from 1.
    measured : (n, 3) float64
        As measured: ball centres where the file gives those, mm.
    contact : (n, 2) float64
        The point on the surface: the ball's radius taken off along the contour's normal, mm.
    foot, normal : (n, 2) float64
        Nominal point in mm, and normal out of the material.
    error : (n,) float64
        Deviation along the normal in mm, positive where material is left.
    """

    line: Ints
    measured: Floats
    contact: Floats
    foot: Floats
    normal: Floats
    error: Floats

    def __len__(self) -> int:
        return len(self.line)


def slope_angle(normal: Floats) -> Floats:
    """Slope angle of the contour in degrees, 0 up to 360, anticlockwise from +X (petrakov-2018, fig. 4).

    Parameters
    ----------
    normal : (n, 2) float64
        Out of the material; the contour runs with the material on its left.
    """
    out: Floats = np.mod(np.degrees(np.arctan2(normal[:, 0], -normal[:, 1])), 360.0)
    return out


def path_stations(result: Result) -> PathStations:
    """Path and theoretical contour of the program that was checked.

    Parameters
    ----------
    result : Result

    Returns
    -------
    PathStations
        At the start of every move that follows the contour, and between, so that stations are nowhere farther
        apart than `STATIONS_APART` and `STATIONS_TURN`; and at the end of the last one.
    """
    toolpath = result.request.program.toolpath
    rows = _following(result)
    points, row = _stations(toolpath, rows)
    feet = FootPointSearch(result.nominal, margin=result.path_radius + 1.0).find(points)
    nominal = result.nominal
    return PathStations(
        toolpath.line(row),
        points,
        nominal.contour[feet.span],
        nominal.arc_length(feet.span, feet.t),
        feet.foot,
        nominal.normals(feet.span, feet.t),
    )


def touched_points(result: Result) -> TouchedPoints:
    """Measured points, ball taken off, and their errors along the normal.

    Parameters
    ----------
    result : Result
        With a measurement.
    """
    measurement, deviation = result.request.measurement, result.deviation
    if measurement is None:
        flat = np.zeros((0, 2))
        return TouchedPoints(np.zeros(0, dtype=np.int64), np.zeros((0, 3)), flat, flat, flat, np.zeros(0))
    return TouchedPoints(
        measurement.lines[deviation.index],
        measurement.points[deviation.index],
        deviation.foot + deviation.value[:, None] * deviation.normal,
        deviation.foot,
        deviation.normal,
        deviation.value,
    )


def path_contours(result: Result) -> Profile:
    """The program's path along the contour as curves, in its own direction; one contour a pass."""
    toolpath, rows = result.request.program.toolpath, _following(result)
    passes = np.split(rows, _breaks(toolpath.take(rows))[:-1] + 1)
    return Profile.from_contours([c for one in passes for c in path_profile(toolpath, one, False).contours])


def _following(result: Result) -> Ints:
    """Moves of the original program that follow the nominal, in order."""
    made = result.regeneration
    out: Ints = np.unique(made.origin[made.following])
    return out[out >= 0]


def _breaks(moves: Toolpath) -> Ints:
    """Moves behind which the path breaks off, the last one among them."""
    gap = np.abs(moves.end[:-1, :2] - moves.start[1:, :2]).max(axis=1, initial=0.0) > 1e-6
    return np.flatnonzero(np.append(gap, True))


def _stations(toolpath: Toolpath, rows: Ints) -> tuple[Floats, Ints]:
    """Points along moves, (m, 2), and the move of each, (m,), in order."""
    moves = toolpath.take(rows)
    steps = np.ceil(np.maximum(length_in_plane(moves) / STATIONS_APART, 1.0))
    turning = moves.kind == Kind.ARC
    steps[turning] = np.maximum(steps[turning], np.ceil(np.abs(moves.sweep[turning]) / STATIONS_TURN))
    count = steps.astype(np.int64)
    points, owner, order = [], [], []
    for number in np.unique(count):
        mine = np.flatnonzero(count == number)
        t = np.arange(number) / number
        points.append(moves.take(mine).position(t)[:, :, :2].reshape(-1, 2))
        owner.append(np.repeat(mine, number))
        order.append((mine[:, None] + t).reshape(-1))
    # Where the path breaks off or ends, the last move's end is a station, too.
    last = _breaks(moves)
    points.append(moves.end[last, :2])
    owner.append(last)
    order.append(last + 1 - 1e-9)
    turn = np.argsort(np.concatenate(order), kind="stable")
    return np.concatenate(points)[turn], rows[np.concatenate(owner)[turn]]


PATH_COLUMNS = ("line", "x_path", "y_path", "contour", "s", "x", "y", "nx", "ny", "slope_deg")
"""Columns of contour.csv: the path, and the theoretical contour beside it."""


def path_lines(stations: PathStations) -> Iterator[bytes]:
    """Lines of contour.csv, in mm and degrees; the header first."""
    progress.step()
    yield ",".join(PATH_COLUMNS).encode() + b"\n"
    columns = (
        stations.line,
        *stations.path.T,
        stations.contour,
        stations.s,
        *stations.point.T,
        *stations.normal.T,
        slope_angle(stations.normal),
    )
    yield from lines(columns, (12,) * 9 + (9,))


def table(points: TouchedPoints) -> str:
    """The points for a console: coordinates in mm, slope in degrees, error in um."""
    head = f"{'line':>6} {'X':>10} {'Y':>10} {'X contact':>10} {'Y contact':>10} {'slope':>8} {'error um':>9}"
    columns = (points.measured[:, :2], points.contact, slope_angle(points.normal), points.error * 1000)
    rows = np.column_stack(columns).tolist()
    lines = [
        f"{line:6d} {x:10.4f} {y:10.4f} {cx:10.4f} {cy:10.4f} {slope:8.3f} {error:+9.2f}"
        for line, (x, y, cx, cy, slope, error) in zip(points.line.tolist(), rows, strict=True)
    ]
    return "\n".join([head, *lines])
