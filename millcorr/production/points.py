# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured points of the parts of a series, as the journal keeps them, and parts looked at together."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.geometry.profile import Profile
from millcorr.separation import Filter, Observed
from millcorr.separation.parts import same_levels
from millcorr.separation.steps import Systematic, steps_of

from .places import Places

MOST = 2000
"""More points of an entry than these are kept as means of so many places: closer ones tell the same of a form."""


@dataclass(frozen=True, eq=False, slots=True)
class Points:
    """What the machine added at the measured points of one entry, which may be several parts of one program.

    Parameters
    ----------
    part, stretch : (n,) int64
        Number of the part within the entry; smooth stretch of the nominal.
    s : (n,) float64
        mm from the stretch's start.
    z : (n,) float64
        Height of the point's level, mm; NaN where it is not known.
    cos_alpha, cos_beta : (n,) float64
        Directional cosines of the nominal there.
    commanded : (n,) float64
        What the program of the part commanded, mm.
    value : (n,) float64
        Measured deviation less that, mm.
    """

    part: Ints
    stretch: Ints
    s: Floats
    z: Floats
    cos_alpha: Floats
    cos_beta: Floats
    commanded: Floats
    value: Floats

    @property
    def normal(self) -> Floats:
        """Directional cosines, (n, 2)."""
        return np.column_stack([self.cos_alpha, self.cos_beta])

    @property
    def parts(self) -> int:
        """How many parts the entry has."""
        return len(np.unique(self.part))

    @staticmethod
    def of(systematic: Systematic, nominal: Profile, places: Places, commanded: Floats) -> Points:
        """Points that were separated.

        Parameters
        ----------
        systematic : Systematic
        nominal : Profile
        places : Places
        commanded : (m,) float64
            What the program commands at the places, mm; NaN where it is not known.
        """
        seen = systematic.measured
        assert seen.z is not None
        heights = np.bincount(seen.level, seen.z) / np.maximum(np.bincount(seen.level), 1)
        part, stretch, level, s, value = seen.part, seen.stretch, seen.level, seen.s, seen.value
        if len(s) > MOST:
            sound = ~systematic.separated.outlier
            blocks = np.unique(np.column_stack([part, level]), axis=0, return_inverse=True)[1].ravel()
            lengths = np.array([t.length for t in places.stretches])
            width = lengths[np.unique(stretch)].sum() * (blocks.max() + 1) / MOST
            cell = np.column_stack([blocks, stretch, np.floor(s / width).astype(np.int64)])[sound]
            _, first, of = np.unique(cell, axis=0, return_index=True, return_inverse=True)
            count = np.bincount(of.ravel())
            s, value = (np.bincount(of.ravel(), v[sound]) / count for v in (s, value))
            part, stretch, level = (v[sound][first] for v in (part, stretch, level))
        normal, own = np.empty((len(s), 2)), np.empty(len(s))
        begin = np.cumsum([0, *places.counts])
        for k in np.unique(stretch).tolist():
            rows, t = stretch == k, places.stretches[k]
            _, normal[rows] = nominal.at(t.contour, t.begin + s[rows])
            own[rows] = np.interp(s[rows], places.s(k), np.nan_to_num(commanded[begin[k] : begin[k + 1]]))
        return Points(part, stretch, s, heights[level], normal[:, 0], normal[:, 1], own, value)

    def packed(self) -> bytes:
        """As bytes."""
        rows = np.stack([np.asarray(getattr(self, name), dtype="<f8") for name in self.__slots__])
        return zlib.compress(rows.tobytes())

    @staticmethod
    def from_packed(data: bytes) -> Points:
        """From bytes; ValueError or zlib.error where they are damaged."""
        rows = np.frombuffer(zlib.decompress(data), dtype="<f8").reshape(len(Points.__slots__), -1).astype(np.float64)
        rows.flags.writeable = False
        return Points(rows[0].astype(np.int64), rows[1].astype(np.int64), *rows[2:])


def together(entries: Sequence[Points], count: Floats, nominal: Profile, filter: Filter) -> Systematic:
    """What repeats over the parts of several entries.

    Parameters
    ----------
    entries : sequence of Points
    count : (entries,) float64
        How many times each entry counts; see `separate`.
    nominal : Profile
    filter : Filter
    """
    step = steps_of(nominal)[[t.contour for t in nominal.stretches()]]
    own: list[tuple[Ints, Floats]] = []
    rows: list[Ints] = []
    for one in entries:
        height, of = np.unique(one.z, return_inverse=True)
        pairs, row = np.unique(np.column_stack([step[one.stretch], of.ravel()]), axis=0, return_inverse=True)
        own.append((pairs[:, 0], height[pairs[:, 1]]))
        rows.append(row.ravel())
    level = np.concatenate([number[row] for number, row in zip(same_levels(own), rows, strict=True)])
    part: list[Ints] = []
    each: list[float] = []
    for one, times in zip(entries, count, strict=True):
        part.append(one.part + len(each))
        each += [float(times) / one.parts] * one.parts
    names = ("stretch", "s", "value", "z")
    stretch, s, value, z = (np.concatenate([getattr(one, name) for one in entries]) for name in names)
    measured = Observed(stretch, s, value, np.concatenate(part), level, z if np.isfinite(z).all() else None)
    return Systematic.of(measured, nominal, filter, np.array(each))
