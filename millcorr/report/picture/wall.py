# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part's wall as a surface in the colours of its deviation, between the heights at which it was cut.

It lies where the nominal is, in its own size: what is magnified are whiskers and lines, not the part.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Floats, Ints
from millcorr.geometry.correction import along as along_stretch
from millcorr.geometry.profile import Profile
from millcorr.pipeline import Result
from millcorr.report.plots import course

from .correction import cutting_moves
from .scale import Scale

Singles = NDArray[np.float32]
Colours = NDArray[np.uint32]
Indices = NDArray[np.int32]

UNKNOWN = 0xA8A8A8FF
"""Colour 0xRRGGBBAA where no point is near."""

SPACING = 0.5
"""Points along the wall are at most this far apart, mm, as long as they are not too many."""

MOST_PLACES = 60_000
"""So many points of the whole wall are enough; more would keep the window from running when they are drawn."""

BETWEEN = 6
"""So many rows of points from one measured height to the next: colours between two far ones are those of the scale."""

LEAST_HEIGHT = 0.05
"""A wall whose height is not known, or nothing, is as high as this share of the part's size."""


@dataclass(frozen=True, eq=False, slots=True)
class Wall:
    """A surface of four-cornered faces.

    Parameters
    ----------
    vertices, normals : (m, 3) float32
        mm in the frame of the job, and directional cosines out of the material.
    colours : (m,) uint32
        0xRRGGBBAA of each vertex.
    index : (k,) int32
        Vertices of one face after the other, -1 behind each.
    """

    vertices: Singles
    normals: Singles
    colours: Colours
    index: Indices

    def __len__(self) -> int:
        return int((self.index < 0).sum())

    @property
    def bare(self) -> bool:
        """Whether it has places without a point near."""
        return bool((self.colours == UNKNOWN).any())


def wall_of(result: Result, scale: Scale, top: float | None = None) -> Wall:
    """The wall of a correction's nominal, coloured by the deviations measured on it; outliers count for nothing.

    Parameters
    ----------
    result : Result
    scale : Scale
    top : float, optional
        Height in mm at which cutting began, where that is known.

    Returns
    -------
    Wall
        Empty where nothing was measured. Between points and measured heights the deviation is interpolated, above and
        below them it is that of the nearest height.
    """
    profile = result.nominal
    rows_at_most = 3 + BETWEEN * max(len(np.unique(result.deviation.level)) - 1, 0)
    span, t = profile.samples(max(SPACING, rows_at_most * float(profile.total.sum()) / MOST_PLACES))
    point, _, _ = profile.evaluate(span, t)
    normal, s = profile.normals(span, t), profile.arc_length(span, t)
    heights = wall_heights(result, top)
    vertices, normals, colours, index = [np.zeros((0, 3))], [np.zeros((0, 3))], [np.zeros(0, np.uint32)], []
    count = 0
    for k in range(len(profile.contours)):
        rows = np.flatnonzero(profile.contour[span] == k)
        z, value = _values(result, k, profile.stretch[span[rows]], s[rows], _of_contour(profile, k, heights))
        n = len(rows)
        if not len(z):
            continue
        known = np.isfinite(value).reshape(-1)
        shade = np.full(len(known), UNKNOWN, dtype=np.uint32)
        shade[known] = scale.colours(value.reshape(-1)[known])
        vertices.append(np.column_stack([np.tile(point[rows], (len(z), 1)), np.repeat(z, n)]))
        normals.append(np.tile(np.column_stack([normal[rows], np.zeros(n)]), (len(z), 1)))
        colours.append(shade)
        index.append(_faces(span[rows], len(z)) + count)
        count += n * len(z)
    corners = np.concatenate([np.zeros((0, 4), dtype=np.int64), *index])
    faces = np.column_stack([corners, np.full(len(corners), -1)])
    return Wall(
        np.concatenate(vertices).astype(np.float32),
        np.concatenate(normals).astype(np.float32),
        np.concatenate(colours),
        faces.reshape(-1).astype(np.int32),
    )


def wall_heights(result: Result, top: float | None = None) -> tuple[float, float]:
    """Heights in mm between which the wall was cut: of its passes, of what began above them, and of its points.

    Parameters
    ----------
    result : Result
    top : float, optional
        As in `wall_of`.
    """
    toolpath = result.request.program.toolpath
    z = np.unique(toolpath.end[cutting_moves(result), 2])
    z = z[np.isfinite(z)]
    measurement = result.request.measurement
    if measurement is not None and measurement.has_z and len(result.deviation):
        z = np.concatenate([z, result.deviation.z])
    if top is not None and len(z) and top > z.max():
        z = np.append(z, top)
    left, bottom, right, upper = result.nominal.bounding_box()
    low, high = (float(z.min()), float(z.max())) if len(z) else (0.0, 0.0)
    return low, max(high, low + LEAST_HEIGHT * max(right - left, upper - bottom))


def _of_contour(profile: Profile, contour: int, heights: tuple[float, float]) -> tuple[float, float]:
    """Heights of one contour: a step of a wall is there between its own."""
    bottom, top = (float(bound[0]) for bound in profile.heights(np.array([contour])))
    return max(heights[0], bottom), min(heights[1], top)


def _values(
    result: Result, contour: int, stretch: Ints, s: Floats, heights: tuple[float, float]
) -> tuple[Floats, Floats]:
    """Heights of the rows of points, (r,), and the deviation in mm there, (r, n); NaN where no point is near."""
    d = result.deviation
    here = (d.contour == contour) & ~result.outlier
    levels = np.unique(d.level[here])
    low, high = heights
    if not len(levels) or not low < high:
        return np.zeros(0), np.zeros((0, len(s)))
    # Without heights in the file there is one level, and it holds at all of them.
    mean = np.array([float(d.z[here & (d.level == level)].mean()) for level in levels])
    mean = np.nan_to_num(mean, nan=(low + high) / 2)
    order = np.argsort(mean)
    measured = np.stack([_along(result, np.flatnonzero(here & (d.level == k)), stretch, s) for k in levels[order]])
    mean = mean[order]
    inside = np.interp(np.arange(BETWEEN * (len(mean) - 1) + 1) / BETWEEN, np.arange(len(mean)), mean)
    z = np.unique(np.concatenate([[low], inside[(inside > low) & (inside < high)], [high]]))
    above = np.clip(np.searchsorted(mean, z), 0, len(mean) - 1)
    below = np.clip(above - 1, 0, None)
    below = np.where(z >= mean[above], above, np.where(z <= mean[0], 0, below))
    apart = mean[above] - mean[below]
    weight = np.where(apart > 0, (z - mean[below]) / np.where(apart > 0, apart, 1.0), 0.0)[:, None]
    a, b = measured[below], measured[above]
    between = (1.0 - weight) * a + weight * b
    return z, np.where(np.isnan(a), b, np.where(np.isnan(b), a, between))


def _along(result: Result, rows: Ints, stretch: Ints, s: Floats) -> Floats:
    """Deviation in mm at places of a contour, (n,), by the points of one height; NaN where none is near."""
    d, profile = result.deviation, result.nominal
    out = np.full(len(s), np.nan)
    for number in np.unique(d.stretch[rows]):
        one, there = result.correction.stretches[number], np.flatnonzero(stretch == number)
        mine = rows[d.stretch[rows] == number]
        place = along_stretch(one, s[there], profile)
        for x, value in course(along_stretch(one, d.s[mine], profile), d.value[mine], one.length, one.closed):
            inside = (place >= x[0]) & (place <= x[-1])
            out[there[inside]] = np.interp(place[inside], x, value)
    return out


def _faces(owner: Ints, rows: int) -> Ints:
    """Corners of the faces between rows of points, (f, 4): where two neighbours have one owner."""
    n = len(owner)
    first = np.flatnonzero(owner[1:] == owner[:-1])
    corners = np.column_stack([first, first + 1, first + 1 + n, first + n])
    return (corners[None] + n * np.arange(rows - 1)[:, None, None]).reshape(-1, 4)
