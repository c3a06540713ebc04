# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction: deviations as whiskers, profiles and paths, as arrays that any viewer can draw.

Everything along the normal is drawn magnified about the nominal profile (about its parallel for paths), because
errors of a few micrometres on a part of a hundred millimetres cannot be seen otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.errors import UsageError
from millcorr.footpoint import FootPointSearch
from millcorr.pipeline import Result
from millcorr.toolpath import Toolpath

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Singles = NDArray[np.float32]
Colours = NDArray[np.uint32]
Indices = NDArray[np.int32]

EXCESS = ((0.42, 0.71, 1.0), (0.05, 0.29, 1.0))
"""Red, green, blue of material left, from just outside the tolerance to the largest deviation: blue."""

WITHIN = (0.10, 0.66, 0.24)
"""Within the tolerance: green."""

UNDERCUT = ((1.0, 0.50, 0.30), (0.88, 0.02, 0.06))
"""Too much cut away, from just outside the tolerance to the largest deviation: red."""

NOMINAL, BAND, COMPENSATED = 0x202020FF, 0x1A9E3DFF, 0xE07A00FF
BEFORE, AFTER, REJECTED = 0x9678BEFF, 0xC000A0FF, 0x8A8A00FF
"""Colours 0xRRGGBBAA of the lines that are no whiskers."""

SHADES = 4
"""Shades of blue and of red in the legend."""

MOST_WHISKERS = 100_000
"""More deviations than this are thinned; of each group of neighbours the largest stays."""

LEVELS = 12
"""Profiles are drawn at no more heights than this."""

SPACING = 0.25
"""Points along profiles are at most this far apart, in mm."""

PATH_POINTS = 200_000
"""So many points along a path are enough."""

CROSS = 0.6
"""Half the size of the cross at a rejected point, mm."""


@dataclass(frozen=True, slots=True)
class Look:
    """How to draw.

    Parameters
    ----------
    magnification : float
        Deviations are drawn so many times longer than they are.
    tolerance : float
        Deviations up to this, in mm, are in tolerance, either way.
    """

    magnification: float = 500.0
    tolerance: float = 0.01

    def __post_init__(self) -> None:
        if not 1 <= self.magnification <= 1e6:
            raise UsageError(f"magnification {self.magnification:g}: must be from 1 to 1000000")
        if not 0 <= self.tolerance <= 10:
            raise UsageError(f"tolerance band {self.tolerance:g}: must be from 0 to 10 mm")


@dataclass(frozen=True, eq=False, slots=True)
class Lines:
    """Polylines.

    Parameters
    ----------
    vertices : (m, 3) float32
        mm, in the frame of the job.
    colours : (m,) uint32
        0xRRGGBBAA of each vertex.
    index : (k,) int32
        Vertices of one polyline after the other, -1 behind each.
    """

    vertices: Singles
    colours: Colours
    index: Indices

    def __len__(self) -> int:
        return int((self.index < 0).sum())


@dataclass(frozen=True, eq=False, slots=True)
class Overlay:
    """What to draw of one correction.

    Parameters
    ----------
    whiskers : Lines
        From the nominal along the normal; polyline k belongs to row ``rows[k]`` of the deviations.
    rows : (w,) int64
    rejected : Lines
        Polyline k belongs to entry ``k`` of the deviations' rejected points: a cross.
    nominal, band, compensated : Lines
        The nominal profile, the tolerance on both sides of it, and the profile to cut.
    before, after : Lines
        Path of the operation and corrected path, their distances from the nominal's parallel magnified.
    steps : (k,) float64
        Bounds in mm between the shades, from the largest deviation down to the least.
    shades : (k - 1,) uint32
        Colour between each two of them.
    thinned : int
        One of so many deviations is drawn.
    """

    whiskers: Lines
    rows: Ints
    rejected: Lines
    nominal: Lines
    band: Lines
    compensated: Lines
    before: Lines
    after: Lines
    steps: Floats
    shades: Colours
    thinned: int


def overlay_of(result: Result, look: Look | None = None) -> Overlay:
    """What to draw of a correction.

    Parameters
    ----------
    result : Result
    look : Look, optional

    Returns
    -------
    Overlay
    """
    look = look or Look()
    deviation = result.deviation
    rows = thinned(result, MOST_WHISKERS)
    heights = _heights(result)
    z = deviation.z[rows] if _has_z(result) else np.full(len(rows), heights[0])
    value = deviation.value[rows]
    largest = float(np.abs(deviation.value).max(initial=look.tolerance))
    tips = deviation.foot[rows] + look.magnification * value[:, None] * deviation.normal[rows]
    ends = np.stack([np.column_stack([deviation.foot[rows], z]), np.column_stack([tips, z])], axis=1)
    steps, shades = scale(look.tolerance, largest)
    nominal = result.nominal
    span, t = nominal.samples(SPACING)
    point, _, _ = nominal.evaluate(span, t)
    normal = nominal.normals(span, t)
    correction = result.correction.at(nominal.stretch[span], nominal.arc_length(span, t), nominal)

    def parallel(offset: Floats | float, colour: int) -> Lines:
        moved = point + look.magnification * np.reshape(offset, (-1, 1)) * normal
        return _at_heights(moved, span, heights, colour)

    band = look.tolerance if len(deviation) else 0.0
    return Overlay(
        whiskers=_polylines(ends, colours_of(value, look.tolerance, largest).repeat(2)),
        rows=rows,
        rejected=_crosses(result, heights[0]),
        nominal=parallel(0.0, NOMINAL),
        band=_joined(parallel(band, BAND), parallel(-band, BAND)),
        compensated=parallel(correction, COMPENSATED),
        before=_path(result, look, result.request.program.toolpath, _before(result), BEFORE),
        after=_path(result, look, result.regeneration.toolpath, np.flatnonzero(result.regeneration.following), AFTER),
        steps=steps,
        shades=shades,
        thinned=max(1, round(len(deviation) / len(rows))) if len(rows) else 1,
    )


def thinned(result: Result, most: int) -> Ints:
    """Rows of the deviations to draw, (w,), in their order: all, or of each group of neighbours the largest."""
    deviation = result.deviation
    n = len(deviation)
    if n <= most:
        return np.arange(n)
    order = np.lexsort((deviation.s, deviation.level, deviation.contour))
    group = np.arange(n) * most // n
    by_size = np.lexsort((-np.abs(deviation.value[order]), group))
    first = np.flatnonzero(np.diff(group[by_size], prepend=-1))
    return np.sort(order[by_size[first]])


def scale(tolerance: float, largest: float) -> tuple[Floats, Colours]:
    """Bounds between shades in mm, from the largest deviation to its negative, and the shades between them."""
    outside = np.linspace(largest, tolerance, SHADES + 1) if largest > tolerance else np.array([tolerance])
    steps = np.concatenate([outside, -outside[::-1]])
    middle = (steps[1:] + steps[:-1]) / 2
    return steps, colours_of(middle, tolerance, largest)


def colours_of(value: Floats, tolerance: float, largest: float) -> Colours:
    """Colours 0xRRGGBBAA of deviations in mm; (n,).

    Blue where material is left, red where too much is cut away, darker with size up to the largest; green in
    tolerance.
    """
    room = largest - tolerance
    far = np.clip((np.abs(value) - tolerance) / room, 0.0, 1.0)[:, None] if room > 0 else np.zeros((len(value), 1))
    # The legend's shades are the very colours of the whiskers.
    far = np.minimum(np.floor(far * SHADES), SHADES - 1) / (SHADES - 1)
    (near_blue, far_blue), (near_red, far_red) = np.array(EXCESS), np.array(UNDERCUT)
    blue, red = near_blue + far * (far_blue - near_blue), near_red + far * (far_red - near_red)
    rgb = np.where((value > 0)[:, None], blue, red)
    rgb[np.abs(value) <= tolerance] = WITHIN
    parts = np.round(rgb * 255).astype(np.uint32)
    out: Colours = (parts[:, 0] << 24) | (parts[:, 1] << 16) | (parts[:, 2] << 8) | np.uint32(255)
    return out


def whisker_text(result: Result, row: int) -> str:
    """What a deviation is: point, deviation, directional cosines, and where in the file it stands.

    Parameters
    ----------
    result : Result
    row : int
        Row of the deviations.

    Returns
    -------
    str
        A line each.
    """
    d, measurement = result.deviation, result.request.measurement
    x, y = d.foot[row] + d.value[row] * d.normal[row]
    where = f"X {x:z.4f}  Y {y:z.4f}" + (f"  Z {d.z[row]:z.4f}" if _has_z(result) else "") + " mm"
    value, determined = float(d.value[row]), float(result.filtered[row])
    kind = "material left" if value > 0 else "undercut" if value < 0 else "on the profile"
    lines = [
        where,
        f"deviation {value:+.4f} mm ({kind})",
        f"of that determined {determined:+.4f} mm, expected next {float(result.predicted[row]):+.4f} mm",
        f"cos \u03b1 {d.normal[row, 0]:+.6f}  cos \u03b2 {d.normal[row, 1]:+.6f}",
    ]
    if measurement is not None:
        lines.append(measurement.origin(int(d.index[row])))
    return "\n".join(lines)


def rejected_text(result: Result, entry: int) -> str:
    """Why a point is left out, where it lies, and where in the file it stands; a line each."""
    point, measurement = result.deviation.rejected[entry], result.request.measurement
    assert measurement is not None
    x, y, z = measurement.points[point.index]
    where = f"X {x:z.4f}  Y {y:z.4f}" + (f"  Z {z:z.4f}" if measurement.has_z else "") + " mm as measured"
    return f"left out: {point.reason}\n{where}\n{measurement.origin(point.index)}"


def _has_z(result: Result) -> bool:
    measurement = result.request.measurement
    return measurement is not None and measurement.has_z


def _heights(result: Result) -> Floats:
    """Heights in mm at which profiles are drawn: the levels measured, or the lowest of the path."""
    deviation = result.deviation
    if _has_z(result) and len(deviation):
        count = np.bincount(deviation.level)
        there = np.flatnonzero(count)
        mean = np.bincount(deviation.level, deviation.z)[there] / count[there]
        return mean if len(mean) <= LEVELS else mean[[0, -1]]
    toolpath, rows = result.request.program.toolpath, _before(result)
    z = toolpath.end[rows, 2]
    return np.array([np.min(z[np.isfinite(z)], initial=0.0) if len(z) else 0.0])


def _before(result: Result) -> Ints:
    """Moves of the operation that follow the contour."""
    made = result.regeneration
    rows: Ints = np.unique(made.origin[made.following])
    return rows[rows >= 0]


def _path(result: Result, look: Look, toolpath: Toolpath, rows: Ints, colour: int) -> Lines:
    """Following moves, their distance from the nominal's parallel magnified."""
    moves = toolpath.take(rows)
    if not len(moves):
        return _polylines(np.zeros((0, 2, 3)), np.zeros(0, dtype=np.uint32))
    pieces = int(np.clip(np.ceil(moves.length().max() / SPACING), 1, max(1, PATH_POINTS // len(moves))))
    points = moves.position(np.linspace(0.0, 1.0, pieces + 1))
    flat = points.reshape(-1, 3)
    feet = FootPointSearch(result.nominal, margin=result.path_radius + 1.0).find(flat[:, :2])
    away = result.path_radius + look.magnification * (feet.distance - result.path_radius)
    z = np.nan_to_num(flat[:, 2])
    moved = np.column_stack([feet.foot + away[:, None] * feet.normal, z]).reshape(points.shape)
    return _polylines(moved, np.full(len(flat), colour, dtype=np.uint32))


def _crosses(result: Result, height: float) -> Lines:
    """A cross at every rejected point, as one polyline each."""
    measurement, rejected = result.request.measurement, result.deviation.rejected
    if measurement is None or not rejected:
        return _polylines(np.zeros((0, 5, 3)), np.zeros(0, dtype=np.uint32))
    points = measurement.points[[r.index for r in rejected]].copy()
    if result.alignment is not None:
        points[:, :2] = result.alignment.transform.points(points[:, :2])
    if not measurement.has_z:
        points[:, 2] = height
    arms = CROSS * np.array([[-1, -1, 0], [1, 1, 0], [0, 0, 0], [-1, 1, 0], [1, -1, 0]])
    crosses = points[:, None, :] + arms
    return _polylines(crosses, np.full(crosses[..., 0].size, REJECTED, dtype=np.uint32))


def _polylines(points: Floats, colours: Colours) -> Lines:
    """Polylines of equally many points, (n, k, 3), with a colour for each of the n k points."""
    n, k, _ = points.shape
    index = np.full((n, k + 1), -1, dtype=np.int32)
    index[:, :k] = np.arange(n * k).reshape(n, k)
    return Lines(points.reshape(-1, 3).astype(np.float32), colours.astype(np.uint32), index.reshape(-1))


def _at_heights(points: Floats, owner: Ints, heights: Floats, colour: int) -> Lines:
    """Points of one span after the other as polylines, repeated at every height."""
    n = len(points)
    ends = np.flatnonzero(np.diff(owner, append=-1)) + 1
    one = np.insert(np.arange(n), ends, -1)
    index = np.concatenate([np.where(one < 0, -1, one + k * n) for k in range(len(heights))])
    vertices = np.column_stack([np.tile(points, (len(heights), 1)), np.repeat(heights, n)])
    return Lines(vertices.astype(np.float32), np.full(len(vertices), colour, dtype=np.uint32), index.astype(np.int32))


def _joined(a: Lines, b: Lines) -> Lines:
    index = np.where(b.index < 0, -1, b.index + len(a.vertices)).astype(np.int32)
    return Lines(
        np.concatenate([a.vertices, b.vertices]),
        np.concatenate([a.colours, b.colours]),
        np.concatenate([a.index, index]),
    )
