# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a correction: deviations as whiskers, profiles and paths, as arrays that any viewer can draw.

Everything along the normal is drawn magnified about the nominal profile (about its parallel for paths), because
errors of a few micrometres on a part of a hundred millimetres cannot be seen otherwise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.messages import Message, joined, phrase
from millcorr.nc.toolpath import Toolpath
from millcorr.pipeline import Result
from millcorr.report.length_unit import MM, LengthUnit
from millcorr.report.magnification import bound_of, magnification_for

from .parallel import index_of, unfolded
from .scale import Look, Scale

Singles = NDArray[np.float32]
Colours = NDArray[np.uint32]
Indices = NDArray[np.int32]

NOMINAL, BAND, COMPENSATED = 0x202020FF, 0x1A9E3DFF, 0xE07A00FF
BEFORE, AFTER, REJECTED = 0x9678BEFF, 0xC000A0FF, 0x8A8A00FF
"""Colours 0xRRGGBBAA of the lines that are no whiskers."""

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
        Polyline k belongs to entry ``k`` of the result's points that are left out: a cross.
    nominal, band, compensated : Lines
        The nominal profile, the tolerance on both sides of it, and the profile to cut.
    before, after : Lines
        Path of the operation and corrected path, their distances from the nominal's parallel magnified.
    scale : Scale
        What the colours of the whiskers mean.
    magnification, bound : float
        So many times larger deviations and differences are drawn; more than the bound would turn a contour inside out.
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
    scale: Scale
    magnification: float
    bound: float
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
    deviation, nominal = result.deviation, result.nominal
    span, t = nominal.samples(SPACING)
    point, _, _ = nominal.evaluate(span, t)
    normal = nominal.normals(span, t)
    correction = result.correction.at(nominal.stretch[span], nominal.arc_length(span, t), nominal)
    bound, times = _magnification(result, look, nominal.contour[span], correction)
    rows = thinned(result, MOST_WHISKERS)
    heights = _heights(result)
    z = deviation.z[rows] if _has_z(result) else np.full(len(rows), heights[0])
    value = deviation.value[rows]
    scale = Scale.of(look, deviation.value)
    tips = deviation.foot[rows] + times * value[:, None] * deviation.normal[rows]
    ends = np.stack([np.column_stack([deviation.foot[rows], z]), np.column_stack([tips, z])], axis=1)

    def parallel(offset: Floats | float, colour: int) -> Lines:
        off = times * np.broadcast_to(offset, len(span))
        drawn = unfolded(nominal, span, point, normal, off)
        moved = point + off[:, None] * normal
        return _at_heights(moved, index_of(moved, span, drawn), heights, colour)

    limits = (look.upper, look.lower) if len(deviation) else (0.0, 0.0)
    before, after = result.request.program.toolpath, result.regeneration.toolpath
    return Overlay(
        whiskers=_polylines(ends, scale.colours(value).repeat(2)),
        rows=rows,
        rejected=_crosses(result, heights[0]),
        nominal=parallel(0.0, NOMINAL),
        band=_joined(*(parallel(limit, BAND) for limit in limits)),
        compensated=parallel(correction, COMPENSATED),
        before=_path(result, times, before, cutting_moves(result), BEFORE),
        after=_path(result, times, after, np.flatnonzero(result.regeneration.following), AFTER),
        scale=scale,
        magnification=times,
        bound=bound,
        thinned=max(1, round(len(deviation) / len(rows))) if len(rows) else 1,
    )


def _magnification(result: Result, look: Look, contour: Ints, correction: Floats) -> tuple[float, float]:
    """Largest magnification that is sound, and the one to draw by."""
    deviation, sound = result.deviation, ~result.outlier
    measured = deviation.value[sound]
    bound = bound_of(result.nominal, [(deviation.contour[sound], measured), (contour, correction)])
    if look.magnification is not None:
        return bound, min(look.magnification, bound)
    largest = max(float(np.abs(measured).max(initial=0.0)), float(np.abs(correction).max(initial=0.0)))
    # Where nothing is measured and nothing corrected, the picture is of the path.
    return bound, magnification_for(result.nominal, largest or result.regeneration.original_error, bound)


def thinned(result: Result, most: int) -> Ints:
    """Rows of the deviations to draw, (w,), in their order: all, or of each group of neighbours the largest."""
    progress.step()
    deviation = result.deviation
    n = len(deviation)
    if n <= most:
        return np.arange(n)
    order = np.lexsort((deviation.s, deviation.level, deviation.contour))
    group = np.arange(n) * most // n
    by_size = np.lexsort((-np.abs(deviation.value[order]), group))
    first = np.flatnonzero(np.diff(group[by_size], prepend=-1))
    return np.sort(order[by_size[first]])


def whisker_text(result: Result, row: int, unit: LengthUnit = MM) -> Message:
    """What a deviation is: point, deviation, directional cosines, and where in the file it stands.

    Parameters
    ----------
    result : Result
    row : int
        Row of the deviations.
    unit : LengthUnit, optional
        In which lengths are told.

    Returns
    -------
    Message
        A line each.
    """
    d, measurement = result.deviation, result.request.measurement
    x, y = d.foot[row] + d.value[row] * d.normal[row]
    where = _coordinates((x, y, float(d.z[row])) if _has_z(result) else (x, y), unit)
    value, determined = float(d.value[row]), float(result.filtered[row])
    kind = phrase("on the profile")
    if value:
        kind = phrase("material left") if value > 0 else phrase("undercut")
    shown, settled, then = (
        f"{unit.number(length, '+')} {unit.name}" for length in (value, determined, float(result.predicted[row]))
    )
    lines: list[str] = [
        where,
        phrase("deviation {} ({})", shown, kind),
        phrase("of that determined {}, expected next {}", settled, then),
        f"cos \u03b1 {d.normal[row, 0]:+.6f}  cos \u03b2 {d.normal[row, 1]:+.6f}",
    ]
    if measurement is not None:
        lines.append(measurement.origin(int(d.index[row])))
    return joined(lines, "\n")


def rejected_text(result: Result, entry: int, unit: LengthUnit = MM) -> Message:
    """Why a point is left out, where it lies, and where in the file it stands; a line each."""
    point, measurement = result.left_out[entry], result.request.measurement
    assert measurement is not None
    x, y, z = measurement.points[point.index]
    where = _coordinates((x, y, z) if measurement.has_z else (x, y), unit)
    said = phrase("left out: {}", point.reason), phrase("{} as measured", where), measurement.origin(point.index)
    return joined(said, "\n")


def _coordinates(place: Sequence[float], unit: LengthUnit) -> str:
    """Coordinates given in mm, with their axes and their unit."""
    words = [f"{axis} {unit.number(float(value))}" for axis, value in zip("XYZ", place, strict=False)]
    return f"{'  '.join(words)} {unit.name}"


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
    toolpath, rows = result.request.program.toolpath, cutting_moves(result)
    z = toolpath.end[rows, 2]
    return np.array([np.min(z[np.isfinite(z)], initial=0.0) if len(z) else 0.0])


def cutting_moves(result: Result) -> Ints:
    """Moves of the operation that follow the contour, (k,)."""
    made = result.regeneration
    rows: Ints = np.unique(made.origin[made.following])
    return rows[rows >= 0]


def _path(result: Result, times: float, toolpath: Toolpath, rows: Ints, colour: int) -> Lines:
    """Following moves, their distance from the nominal's parallel magnified."""
    progress.step()
    moves = toolpath.take(rows)
    if not len(moves):
        return _polylines(np.zeros((0, 2, 3)), np.zeros(0, dtype=np.uint32))
    pieces = int(np.clip(np.ceil(moves.length().max() / SPACING), 1, max(1, PATH_POINTS // len(moves))))
    points = moves.position(np.linspace(0.0, 1.0, pieces + 1))
    flat = points.reshape(-1, 3)
    feet = FootPointSearch(result.nominal, margin=result.path_radius + 1.0).find(flat[:, :2])
    away = result.path_radius + times * (feet.distance - result.path_radius)
    drawn = unfolded(result.nominal, feet.span, feet.foot, feet.normal, away)
    moved = feet.foot + away[:, None] * feet.normal
    index = index_of(moved, np.repeat(np.arange(len(moves)), pieces + 1), drawn)
    return _coloured(np.column_stack([moved, np.nan_to_num(flat[:, 2])]), index, colour)


def _crosses(result: Result, height: float) -> Lines:
    """A cross at every point that is left out, as one polyline each."""
    measurement, rejected = result.request.measurement, result.left_out
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


def _at_heights(points: Floats, index: Indices, heights: Floats, colour: int) -> Lines:
    """Polylines in the plane, repeated at every height."""
    n = len(points)
    repeated = np.concatenate([np.where(index < 0, -1, index + k * n) for k in range(len(heights))])
    return _coloured(
        np.column_stack([np.tile(points, (len(heights), 1)), np.repeat(heights, n)]), repeated.astype(np.int32), colour
    )


def _coloured(vertices: Floats, index: Indices, colour: int) -> Lines:
    """Polylines of one colour."""
    return Lines(vertices.astype(np.float32), np.full(len(vertices), colour, dtype=np.uint32), index)


def _joined(a: Lines, b: Lines) -> Lines:
    index = np.where(b.index < 0, -1, b.index + len(a.vertices)).astype(np.int32)
    return Lines(
        np.concatenate([a.vertices, b.vertices]),
        np.concatenate([a.colours, b.colours]),
        np.concatenate([a.index, index]),
    )
