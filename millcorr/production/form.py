# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of the parts of a series as one number a part: how much of the form that all share each shows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from millcorr.arrays import Floats, Ints

from .points import Points
from .trend import components

CELL = 1.0
"""Parts are compared every so many mm, straight between their points: the same for all, so that no part is favoured."""


def shared_form(parts: Sequence[Points | None]) -> tuple[Floats, Floats]:
    """Share of each part in the form of all of them, as that form's root mean square.

    Parameters
    ----------
    parts : sequence of Points or None
        None for a part whose points are not known.

    Returns
    -------
    value, commanded : (n,) float64
        mm, of what the machine adds and of what the program commands; mean and place of the part are taken out
        before. NaN where the points are not known, and where a part has none in common with the others.

    Notes
    -----
    A part's deviations are projected on the mean over the parts, which are exchangeable as long as nothing changes: a
    test of Student's for a trend or a jump over them keeps its rate of false alarms. The projection is linear, so that
    a share of what is commanded that comes back shows as that share.
    """
    known = [k for k, part in enumerate(parts) if part is not None]
    value, commanded = (np.full(len(parts), np.nan) for _ in range(2))
    if not known:
        return value, commanded
    some = [part for part in parts if part is not None]
    cells = [np.floor(part.s / CELL).astype(np.int64) for part in some]
    first = np.cumsum([0, *(1 + max(int(c[p.stretch == k].max(initial=-1)) for c, p in zip(cells, some, strict=True))
                            for k in range(1 + max(int(p.stretch.max()) for p in some)))])  # fmt: skip
    machine = np.stack([_along(part, part.value, first) for part in some])
    own = np.stack([_along(part, part.commanded, first) for part in some])
    seen = np.isfinite(machine)
    count = seen.sum(axis=0)
    mean = np.divide(np.where(seen, machine, 0.0).sum(axis=0), count, out=np.zeros(len(count)), where=count > 0)
    square = np.where(seen, mean**2, 0.0).sum(axis=1)
    size = float(np.sqrt((mean[count > 0] ** 2).mean()))
    for out, field in ((value, machine), (commanded, own)):
        share = np.where(seen, field * mean, 0.0).sum(axis=1)
        out[known] = np.divide(size * share, square, out=np.full(len(some), np.nan), where=square > 0)
    return value, commanded


def _along(part: Points, value: Floats, first: Ints) -> Floats:
    """Values less their mean and place, at the middles of all cells; NaN outside the points."""
    size = components(value, part.normal)
    design = np.column_stack([np.ones(len(value)), part.normal])
    left = value - design @ np.nan_to_num(size)
    out = np.full(first[-1], np.nan)
    for k in np.unique(part.stretch):
        rows = part.stretch == k
        cell, of, count = np.unique(np.floor(part.s[rows] / CELL), return_inverse=True, return_counts=True)
        at, mean = (np.bincount(of.ravel(), v) / count for v in (part.s[rows], left[rows]))
        inside = np.arange(int(cell[0]), int(cell[-1]) + 1)
        out[first[k] + inside] = np.interp((inside + 0.5) * CELL, at, mean)
    return out
