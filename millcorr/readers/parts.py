# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several measured parts in one file: how they show, and which one is wanted."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import UsageError
from millcorr.messages import joined, option, phrase

from .source import Source, slices

SAME_PLACE = 0.5
"""Two touches of one point on two parts lie no farther apart than this, in mm: errors of parts are smaller."""

_FEWEST = 3
_SHOWN = 4


def chosen_part(source: Source, titles: Sequence[str]) -> int:
    """Index from 0 of the measured part that the caller wants.

    Parameters
    ----------
    source : Source
    titles : sequence of str
        What to say of each part of the file, in its order: its lines, its name.

    Raises
    ------
    UsageError
        If there are several parts and the caller chooses none, or there is no part of this number.
    """
    number, total = source.part, len(titles)
    if number is None and total > 1:
        told, begin = [], 1
        for title, alike in groupby(titles):
            end = begin + len(list(alike)) - 1
            told.append(phrase("{}: {}", begin, title) if begin == end else phrase("{} to {}: {}", begin, end, title))
            begin = end + 1
        some = joined([*told[:_SHOWN], *(["..."] if len(told) > _SHOWN else [])], "; ")
        raise UsageError(
            phrase(
                "{} holds {} measured parts ({}): say which with {}", source.name, total, some, option("part", of="N")
            )
        )
    if number is not None and not 1 <= number <= total:
        holds = phrase("one measured part") if total == 1 else phrase("{} measured parts, counted from 1", total)
        raise UsageError(phrase("{}: {} holds {}", option("part", number), source.name, holds))
    return (number or 1) - 1


def rows_of_part(source: Source, lines: Ints, part_of: Ints) -> Bools:
    """Rows (n,) of the measured part that the caller wants.

    Parameters
    ----------
    source : Source
    lines, part_of : (n,) int64
        Line of each row, and its part, ascending from 0 without a gap.

    Raises
    ------
    UsageError
        As `chosen_part`.
    """
    begins = np.flatnonzero(np.diff(part_of, prepend=-1))
    titles = [titled(piece) for piece in np.split(lines, begins[1:])]
    wanted: Bools = part_of == chosen_part(source, titles)
    return wanted


def titled(lines: Ints) -> str:
    """What to say of a part with points in these lines, (n,)."""
    if not len(lines):
        return phrase("no points")
    return phrase("{} points in lines {} to {}", len(lines), int(lines.min()), int(lines.max()))


def point_keys(numbers: Ints | Floats, places: Floats, reach: float) -> Ints:
    """Keys (n,) that are equal for rows with one number whose places are the same.

    Parameters
    ----------
    numbers : (n,) int64 or float64
        Number of the point in the file.
    places : (n, 3) float64
    reach : float
        Places no farther apart than this, in their unit, are the same.
    """
    if (np.diff(numbers) > 0).all():
        return np.arange(len(numbers))
    found, group = np.unique(numbers, return_inverse=True)
    if len(found) == len(numbers) or not np.isfinite(places).all():
        return np.asarray(group, dtype=np.int64)
    # Imported where there is need of it: it takes longer than reading.
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import KDTree

    # A fourth direction keeps points of different numbers apart.
    tree = KDTree(np.column_stack([places / reach, 10.0 * group]))
    pairs = tree.query_pairs(1.0, output_type="ndarray")
    links = coo_array((np.ones(len(pairs), dtype=bool), (pairs[:, 0], pairs[:, 1])), shape=(len(numbers),) * 2)
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def parts_by_repetition(keys: Ints, blocks: Ints) -> tuple[Ints, tuple[int, int] | None]:
    """Parts to which blocks of rows belong: blocks are of one part until something comes that this part has.

    Parameters
    ----------
    keys : (n,) int64
        Equal for what can be there only once in a part.
    blocks : (n,) int64
        Block of each row, ascending.

    Returns
    -------
    part_of : (n,) int64
        Part of each row, from 0.
    twice : tuple of 2 int, or None
        First two rows of one block that have the same key, which no part can have.
    """
    count = len(keys)
    part_of = np.zeros(count, dtype=np.int64)
    order = np.argsort(keys, kind="stable")
    alike = keys[order[1:]] == keys[order[:-1]]
    if not alike.any():
        return part_of, None
    before = np.full(count, -1)
    before[order[1:][alike]] = order[:-1][alike]
    starts = np.concatenate([[0], np.flatnonzero(np.diff(blocks)) + 1])
    sizes = np.diff(np.append(starts, count))
    own = np.flatnonzero(before >= np.repeat(starts, sizes))
    if len(own):
        return part_of, (int(before[own[0]]), int(own[0]))
    latest = np.maximum.reduceat(before, starts)
    part, begun, parts = 0, 0, []
    for start, seen in zip(starts.tolist(), latest.tolist(), strict=True):
        if seen >= begun:
            part, begun = part + 1, start
        parts.append(part)
    return np.repeat(parts, sizes), None


def near(points: Floats, others: Floats) -> Bools:
    """Whether points, (n, 3) in mm, are at the same place as others, (n, 3); (n,)."""
    out = np.empty(len(points), dtype=np.bool_)
    with np.errstate(over="ignore"):
        for rows in slices(points):
            out[rows] = np.linalg.norm(points[rows] - others[rows], axis=1) <= SAME_PLACE
    return out


def parts_by_place(points: Floats) -> Ints:
    """Parts, (n,) from 0, of touches without a name: a part begins where the touches go through the places again.

    Parameters
    ----------
    points : (n, 3) float64
        In mm, in the order of the touches.

    Notes
    -----
    A further part must repeat at least half of the touches, one by one, each within `SAME_PLACE` of the first's, so
    that a contour whose end overlaps its beginning, and a touch repeated on the spot, remain one part.
    """
    count = len(points)
    if count < 2 * _FEWEST or not np.isfinite(points).all():
        return np.zeros(count, dtype=np.int64)
    near_first = near(points, np.broadcast_to(points[0], points.shape))
    for period in np.flatnonzero(near_first).tolist():
        if period < _FEWEST or 2 * (count - period) < period or near_first[: period + 1].sum() > (period + 1) / 2:
            continue
        if near(points[period:], points[:-period]).all():
            return np.arange(count) // period
    return np.zeros(count, dtype=np.int64)
