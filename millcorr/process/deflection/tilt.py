# SPDX-License-Identifier: LGPL-2.1-or-later
"""Remedies for a wall that the bending tool leaves high and out of square: shift the contour, tilt the tool.

dat-2025: the tool is turned by the slope of the deflection over the height. Here slope and mean are those of the wall's
error, fitted over the heights on each stretch of the nominal, and the elastic loop is closed again with the tool so
placed. A tilted end mill does not leave a flat floor: how deep its end face digs is reported.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.correction.compensation import correction_from
from millcorr.errors import InputError, RefusedError
from millcorr.geometry.correction import Correction
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile, Stretch
from millcorr.messages import mm, option, phrase, um

from .height_deviation import left_standing
from .height_error import HeightError, WallModel

NEAR = 0.1
"""A place of the path whose contact is within this of the nominal, in mm, makes it."""

ROUNDS = 8

_ONE_DEPTH = 1e-6
_SETTLED = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class Remedy:
    """Shift and tilt of every stretch of the nominal that the program cuts, one row a stretch.

    Parameters
    ----------
    number : (m,) int64
        Stretch of the nominal.
    stretches : tuple of Stretch
    offset : (m,) float64
        Shift of the contour at the height `about`, mm, positive out of the part.
    lean : (m,) float64
        Angle in rad by which the tool's upper end leans out of the part.
    about : float
        Height above the deepest tip about which the tool is tilted, mm: the middle of the heights.
    heights : (k,) float64
        mm above the deepest tip.
    before, shifted, after : (m, k) float64
        Mean error of the wall in mm: as it is; with the mean shift alone; shifted and tilted.
    worst : (m, 3) float64
        Largest absolute error on the stretch over all heights, of the same three.
    floor : (m,) float64
        How far the end face of the tilted tool reaches below its tip, on the side away from the wall: R sin(lean), mm.
    step : (n,) int64
        For each step of the path the row of its stretch; -1 where it makes none.
    """

    number: Ints
    stretches: tuple[Stretch, ...]
    offset: Floats
    lean: Floats
    about: float
    heights: Floats
    before: Floats
    shifted: Floats
    after: Floats
    worst: Floats
    floor: Floats
    step: Ints

    @property
    def degrees(self) -> Floats:
        """`lean` in degrees."""
        out: Floats = np.degrees(self.lean)
        return out

    def lines(self) -> list[str]:
        """One line of text a stretch: what to do, and what is left."""
        out: list[str] = []
        for k, number in enumerate(self.number):
            a, b, c = self.worst[k]
            out.append(
                phrase(
                    "stretch {} ({}): at most {} off over the heights; shift {}: {}; shift and tilt {:+.4f} deg: {}, "
                    "and the tilted end face digs {} below the tip",
                    number + 1,
                    mm(self.stretches[k].length, ".1f"),
                    um(a),
                    um(self.offset[k], "+.1f"),
                    um(b),
                    self.degrees[k],
                    um(c),
                    um(self.floor[k], ".0f"),
                )
            )
        return out


def remedies(error: HeightError, nominal: Profile, *, near: float = NEAR) -> Remedy:
    """Mean shift and tilt of every stretch that the program cuts.

    Parameters
    ----------
    error : HeightError
        At two heights at least.
    nominal : Profile
    near : float
        A place of the path whose contact is within this of the nominal, in mm, makes it.

    Returns
    -------
    Remedy

    Raises
    ------
    InputError
        If there are fewer than two heights on a stretch, or the program makes no place of the nominal.
    RefusedError
        If the elastic loop does not settle.
    """
    model, heights = error.model, error.heights
    if len(heights) < 2:
        raise InputError(phrase("tilt: the slope of the wall needs two heights at least"))
    number, _ = on_nominal(error, nominal, near)
    made = number >= 0
    found, inverse = np.unique(number[made], return_inverse=True)
    if not len(found):
        raise InputError(
            phrase(
                "tilt: the program makes no wall within {} of the nominal: check {}", mm(near, "g"), option("nominal")
            )
        )
    step = np.full(len(number), -1, dtype=np.int64)
    step[made] = inverse
    m, about = len(found), float(heights.mean())
    weight = _weights(model)

    def means(value: Floats) -> Floats:
        out = np.full((m, len(heights)), np.nan)
        for k in range(len(heights)):
            rows = np.flatnonzero((step >= 0) & np.isfinite(value[:, k]))
            total = np.bincount(step[rows], weight[rows], minlength=m)
            mean = np.bincount(step[rows], weight[rows] * value[rows, k], minlength=m)
            np.divide(mean, total, out=out[:, k], where=total > 0)
        return out

    def settled(tilting: bool) -> tuple[Floats, Floats, Floats]:
        offset, lean, value = np.zeros(m), np.zeros(m), error.value
        for _ in range(ROUNDS):
            progress.step()
            high, slope = _line(means(value), heights - about)
            slope = slope if tilting else np.zeros(m)
            offset, lean = offset - high, lean - slope
            value = model.errors(heights, offset=_each(offset, step), lean=_each(lean, step), about=about).value
            if np.abs(high).max() <= _SETTLED and np.abs(slope).max() <= _SETTLED:
                break
        return offset, lean, value

    _, _, shifted = settled(False)
    offset, lean, after = settled(True)
    worst = np.zeros((m, 3))
    for k, value in enumerate((error.value, shifted, after)):
        rows = np.flatnonzero((step >= 0) & np.isfinite(value).any(axis=1))
        np.maximum.at(worst[:, k], step[rows], np.nanmax(np.abs(value[rows]), axis=1))
    stretches = nominal.stretches()
    return Remedy(
        found,
        tuple(stretches[k] for k in found),
        offset,
        lean,
        about,
        heights,
        means(error.value),
        means(shifted),
        means(after),
        worst,
        model.engagement.radius * np.sin(np.abs(lean)),
        step,
    )


def mean_shift(error: HeightError, nominal: Profile, *, limit: float) -> tuple[Correction, tuple[str, ...]]:
    """Correction that takes out the mean over the heights of the wall's error, everywhere along the contour.

    Parameters
    ----------
    error : HeightError
    nominal : Profile
    limit : float
        Largest displacement allowed, mm.

    Returns
    -------
    Correction
        For `millcorr.path`, like any other.
    warnings : tuple of str

    Raises
    ------
    LimitError
        As `millcorr.correction.compensation.correction_from`.
    InputError
        If the program makes no place of the nominal.
    """
    model = error.model
    number, s = on_nominal(error, nominal)
    rows = np.flatnonzero(number >= 0)
    if not len(rows):
        raise InputError(
            phrase(
                "mean shift: the program makes no wall within {} of the nominal: check {}",
                mm(NEAR, "g"),
                option("nominal"),
            )
        )
    offset, value = np.zeros(len(number)), error.value
    for _ in range(ROUNDS):
        mean = np.nanmean(value[rows], axis=1)
        offset[rows] -= mean
        if np.abs(mean).max() <= _SETTLED:
            break
        value = model.errors(error.heights, offset=offset).value
    return correction_from(nominal, number[rows], s[rows], offset[rows], limit=limit)


def tip_shifts(error: HeightError, remedy: Remedy) -> Floats:
    """How far the tip's path goes with a tilt on each stretch, for controls that keep the tip where it is programmed.

    A tool that leans about its tip stands ``z tan(lean) - R (1 / cos(lean) - 1)`` farther out at the height z: what
    it is farther out at `Remedy.about` has to be taken back.

    Parameters
    ----------
    error : HeightError
    remedy : Remedy
        Of this error.

    Returns
    -------
    (m,) float64
        mm, positive out of the part.

    Raises
    ------
    RefusedError
        If walls are cut in passes of several depths: each would need its own.
    """
    tip = error.model.tip[remedy.step >= 0]
    if np.ptp(tip) > _ONE_DEPTH:
        raise RefusedError(
            phrase("tilt: the walls are cut in passes of several depths: only walls of one depth are tilted")
        )
    lean, radius = remedy.lean, error.model.engagement.radius
    out: Floats = remedy.offset - (remedy.about - tip[0]) * np.tan(lean) + radius * (1 / np.cos(lean) - 1)
    return out


def even_shift(
    error: HeightError, remedy: Remedy, nominal: Profile, shift: Floats, *, limit: float
) -> tuple[Correction, tuple[str, ...]]:
    """Correction that is even on each stretch of a remedy.

    Parameters
    ----------
    error : HeightError
    remedy : Remedy
        Of this error.
    nominal : Profile
    shift : (m,) float64
        mm, one a stretch, positive out of the part.
    limit : float
        Largest displacement allowed, mm.

    Returns
    -------
    Correction
    warnings : tuple of str

    Raises
    ------
    LimitError
        As `millcorr.correction.compensation.correction_from`.
    """
    rows = np.flatnonzero(remedy.step >= 0)
    number, s = on_nominal(error, nominal)
    return correction_from(nominal, number[rows], s[rows], shift[remedy.step[rows]], limit=limit)


def on_nominal(error: HeightError, nominal: Profile, near: float = NEAR) -> tuple[Ints, Floats]:
    """Places of the nominal that the steps of a wall make.

    Parameters
    ----------
    error : HeightError
    nominal : Profile
    near : float
        A place of the path whose contact is within this of the nominal, in mm, makes it.

    Returns
    -------
    (n,) int64, (n,) float64
        Stretch of the nominal, -1 for none, and arc length from its contour's start in mm, one a step.
    """
    model = error.model
    e = model.engagement
    number, s = np.full(len(e), -1, dtype=np.int64), np.full(len(e), np.nan)
    rows = np.flatnonzero(np.isfinite(error.value).any(axis=1))
    contact = e.position[rows, :2] - e.radius * model.wall[rows]
    stands = left_standing(model.path.toolpath, contact, e.radius)
    rows, contact = rows[stands], contact[stands]
    feet = FootPointSearch(nominal, margin=2.0).find(contact)
    # At a corner both sides are near: the wall's normal tells them apart.
    makes = (np.abs(feet.distance) <= near) & ((feet.normal * model.wall[rows]).sum(axis=1) > 0.9)
    k = np.flatnonzero(makes)
    number[rows[k]] = nominal.stretch[feet.span[k]]
    s[rows[k]] = nominal.arc_length(feet.span[k], feet.t[k])
    return number, s


def _weights(model: WallModel) -> Floats:
    """Length of path that each step stands for, mm: steps lie closer where the tool is slow."""
    s = model.engagement.s
    out: Floats = np.maximum(np.gradient(s), 1e-9) if len(s) > 1 else np.ones(1)
    return out


def _each(value: Floats, step: Ints) -> Floats:
    out: Floats = np.where(step >= 0, value[step], 0.0)
    return out


def _line(value: Floats, x: Floats) -> tuple[Floats, Floats]:
    """Value at 0 and slope of straight lines through rows, by least squares; NaN are left out."""
    known = np.isfinite(value)
    count = known.sum(axis=1)
    if (count < 2).any():
        raise InputError(
            phrase("tilt: a stretch is cut at fewer than two of the heights: give heights within its depth")
        )
    y = np.where(known, value, 0.0)
    xs = np.where(known, x, 0.0)
    mean_x, mean_y = xs.sum(axis=1) / count, y.sum(axis=1) / count
    square = (np.where(known, x - mean_x[:, None], 0.0) ** 2).sum(axis=1)
    slope = (np.where(known, x - mean_x[:, None], 0.0) * y).sum(axis=1) / square
    return mean_y - slope * mean_x, slope
