# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which steps of an engagement make the surface at places of a profile."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Bools, Floats, Ints

from .steps import Engagement

AT_PLACE = 0.05
"""A step makes the surface at a place if its cutter is at most 1 mm and so many radii from touching it there."""


@dataclass(frozen=True, eq=False, slots=True)
class Contacts:
    """Steps of an engagement that make the surface at places of a profile: between which two, and how far.

    Parameters
    ----------
    first, second : (n,) int64
        Steps; equal to each other where none follows.
    share : (n,) float64
        0 at the first, 1 at the second.
    cut : (n,) bool
        False where no cut comes by.
    """

    first: Ints
    second: Ints
    share: Floats
    cut: Bools

    @staticmethod
    def of(engagement: Engagement, foot: Floats, normal: Floats) -> Contacts:
        """Steps whose cutter touches places from outside.

        Parameters
        ----------
        engagement : Engagement
        foot, normal : (n, 2) float64
            Places in mm, and normals out of the part.
        """
        from scipy.spatial import cKDTree

        e = engagement
        rows = np.flatnonzero(e.area > 0)
        n = len(foot)
        if not len(rows):
            none = np.zeros(n, dtype=np.int64)
            return Contacts(none, none, np.zeros(n), np.zeros(n, dtype=bool))
        centre = foot + e.radius * normal
        first = rows[cKDTree(e.position[rows, :2]).query(centre)[1]]
        best = np.full(n, np.inf)
        second, share = first.copy(), np.zeros(n)
        for step in (-1, 1):
            other = np.clip(first + step, 0, len(e) - 1)
            a, way = e.position[first, :2], (e.position[other] - e.position[first])[:, :2]
            length = (way**2).sum(axis=1)
            t = np.clip(((centre - a) * way).sum(axis=1) / np.maximum(length, 1e-18), 0.0, 1.0)
            # Steps that do not follow one another are no line.
            t = np.where((length > 0) & (length < (AT_PLACE * e.radius + 1.0) ** 2), t, 0.0)
            away = np.hypot(*(centre - a - t[:, None] * way).T)
            better = away < best
            best = np.where(better, away, best)
            second, share = np.where(better, other, second), np.where(better, t, share)
        return Contacts(first, second, share, best < AT_PLACE * e.radius + 1.0)

    def take(self, values: Floats) -> Floats:
        """Values of the steps at the places, linear between steps, 0 where no cut comes by; (n, ...)."""
        t = self.share.reshape(-1, *[1] * (values.ndim - 1))
        cut = self.cut.reshape(t.shape)
        return np.where(cut, (1 - t) * values[self.first] + t * values[self.second], 0.0)
