# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transfer function of the machining system: what it leaves of a commanded depth, and what to command instead.

The elastic loop is closed: of a commanded depth h the system removes ``h - delta`` and leaves ``delta``, which is
in proportion to what it removes, ``delta = MS (h - delta)`` (petrakov-2025, fig. 3). Hence

- ``delta / h = MS / (1 + MS)`` (eq. 3) and ``MS = delta / (h - delta)`` (eq. 4);
- to remove exactly H the program must command ``H (1 + MS)``: the path goes ``H MS`` deeper than the nominal.

Eq. (5) of the paper prints ``H (1 - MS)``. That is a misprint: its own corrected program (fig. 4) was computed
with the plus sign, and only that solves the loop.

A constant offset a (tool radius, backlash, edge force) is no transfer function: ``delta = a + b h`` with
``b = MS / (1 + MS)``. A path put e over the nominal (negative: deeper) in stock of H over it leaves

    ``d = e + a + b (H - e)``, which is 0 for ``e = -(a + b H) / (1 - b) = -(1 + MS) a - MS H``.

The offset is taken out (1 + MS)-fold, because the path moved by a cuts deeper, too. One depth cannot tell a
from b h; two can.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats, ReadOnlyArrays
from millcorr.errors import InputError, RefusedError
from millcorr.messages import mm, option, phrase, remedy, xy

IMPLAUSIBLE = 0.5
"""A transfer function from this on means that a third of the depth stays: no finishing cut, and worth a look."""

STIFF = 0.01
"""A transfer function below this means less than 1 um of 0.1 mm: no milling machine is known to be so stiff."""

LEAST_REMOVED = 0.1
"""Where a smaller share of the commanded depth was removed, MS = delta / (h - delta) has no meaning."""

LEAST_COSINE = 0.5
"""A deviation is taken along an axis only where the normal is within 60 degrees of it."""

CHANCE = 0.01
"""Of measurements of a rigid machine, the share in which some point may look negative beyond its uncertainty."""


@dataclass(frozen=True, eq=False, slots=True)
class TransferFunction(ReadOnlyArrays):
    """Transfer function at measured points, with the constant offset kept apart where it is known.

    Parameters
    ----------
    ms : (n,) float64
        MS, a pure number.
    ms_std : (n,) float64
        Its standard uncertainty; NaN where the random part is not known.
    offset : (n,) float64
        Constant a of ``delta = a + b h`` along the normal, mm, positive where material is left; 0 where one depth
        cannot tell it.
    offset_std : (n,) float64
        Its standard uncertainty, mm.
    covariance : (n,) float64
        Of MS and offset, mm: what is taken for one of them is missing from the other.
    offset_known : bool
        True where two depths or more were measured.
    """

    ms: Floats
    ms_std: Floats
    offset: Floats
    offset_std: Floats
    covariance: Floats
    offset_known: bool = False

    @staticmethod
    def constant(ms: float, std: float, count: int) -> TransferFunction:
        """The same MS with the same uncertainty at so many points, without an offset."""
        return TransferFunction(
            np.full(count, ms), np.full(count, std), np.zeros(count), np.zeros(count), np.zeros(count)
        )

    def __len__(self) -> int:
        return len(self.ms)

    @property
    def share(self) -> Floats:
        """Share b = MS / (1 + MS) of a commanded depth that stays (eq. 3); (n,)."""
        out: Floats = self.ms / (1.0 + self.ms)
        return out

    def error(self, depth: float | Floats) -> Floats:
        """What stays of a commanded depth, ``a + b h`` in mm; (n,).

        Parameters
        ----------
        depth : float or (n,) float64
            Commanded depth h along the normal, mm.
        """
        out: Floats = self.offset + self.share * depth
        return out

    def correction(self, next_depth: float | Floats) -> Floats:
        """Where to put the path so that the surface comes to lie on the nominal.

        Parameters
        ----------
        next_depth : float or (n,) float64
            Stock over the nominal that the next program finds, mm along the normal.

        Returns
        -------
        (n,) float64
            ``-(1 + MS) a - MS H`` in mm along the normal, negative: deeper. The commanded depth is then
            ``H (1 + MS)`` and a part more for the offset (petrakov-2025, eq. 5 with its sign put right).
        """
        out: Floats = -(1.0 + self.ms) * self.offset - self.ms * next_depth
        return out

    def correction_std(self, next_depth: float | Floats) -> Floats:
        """Standard uncertainty of `correction` in mm; (n,).

        From the derivatives ``-(1 + MS)`` over the offset and ``-(a + H)`` over MS, with their covariance.
        """
        by_offset, by_ms = 1.0 + self.ms, self.offset + next_depth
        variance = (by_offset * self.offset_std) ** 2 + (by_ms * self.ms_std) ** 2
        variance = variance + 2.0 * by_offset * by_ms * self.covariance
        out: Floats = np.sqrt(np.maximum(variance, 0.0))
        return out

    def left(self, next_depth: float | Floats, shift: float | Floats) -> Floats:
        """Deviation that a path leaves: ``e + a + b (H - e)``.

        Parameters
        ----------
        next_depth : float or (n,) float64
            Stock H over the nominal, mm.
        shift : float or (n,) float64
            Where the path puts the surface, e in mm over the nominal.

        Returns
        -------
        (n,) float64
            mm, positive where material is left.
        """
        out: Floats = shift + self.error(next_depth - shift)
        return out


def identify(
    deviation: ArrayLike, depth: ArrayLike, std: ArrayLike = math.nan, place: Floats | None = None
) -> TransferFunction:
    """Transfer function from what one depth has left.

    Parameters
    ----------
    deviation : (n,) float64
        What the machine left of the commanded depth, mm: measured deviation less the program's own offset.
    depth : float or (n,) float64
        Commanded depth h = H - offset along the normal, mm.
    std : float or (n,) float64
        Standard uncertainty of the deviation, mm; NaN where it is not known.
    place : (n, 2) float64, optional
        Points in mm, for messages.

    Returns
    -------
    TransferFunction
        ``MS = delta / (h - delta)`` (petrakov-2025, eq. 4) with the standard uncertainty
        ``u(MS) = (1 + MS)^2 u(delta) / h``, the derivative of eq. (4). The offset is not known and 0.

    Raises
    ------
    InputError
        If a depth is not positive.
    RefusedError
        Where next to nothing of the depth was removed: the quotient has no meaning.
    """
    delta, h, u = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in (deviation, depth, std)))
    if (bad := np.flatnonzero(~(h > 0.0))).size:
        raise InputError(
            phrase(
                "{}the commanded depth is {}, not above 0: a transfer function needs a cut; check {}",
                _at(place, bad[0]),
                mm(h.flat[bad[0]], ".4f"),
                option("depth"),
            ),
        )
    removed = h - delta
    if (bad := np.flatnonzero(~(removed >= LEAST_REMOVED * h))).size:
        i = bad[0]
        raise RefusedError(
            phrase(
                "{}{} of a commanded depth of {} stayed: the transfer function delta/(H - delta) has no "
                "meaning there; check {}",
                _at(place, i),
                mm(delta.flat[i], ".4f"),
                mm(h.flat[i], ".4f"),
                option("depth"),
            ),
        )
    ms = delta / removed
    return TransferFunction(ms, (1.0 + ms) ** 2 * u / h, np.zeros(h.shape), np.zeros(h.shape), np.zeros(h.shape))


@dataclass(frozen=True, eq=False, slots=True)
class Line:
    """Least squares line ``delta = a + b h`` at every place through what several depths have left.

    Parameters
    ----------
    slope : (n,) float64
        b, NaN at places where only one depth was measured.
    spread : (n,) float64
        Sum of squared distances of the depths from their mean, mm^2: ``u(b) = u(delta) / sqrt(spread)``.
    depth : (n,) float64
        Mean of the depths, mm. The line's value there and its slope are independent.
    std : float
        Standard deviation of single values about the lines, mm; NaN without more parts than depths.
    """

    slope: Floats
    spread: Floats
    depth: Floats
    std: float


def line_over_depth(deviation: Floats, depth: Floats) -> Line:
    """Lines through the deviations of parts cut at different depths, place by place.

    Parameters
    ----------
    deviation : (m, n) float64
        What m parts have left at n places, mm; NaN where a part says nothing.
    depth : (m, n) float64
        Commanded depths, mm.

    Returns
    -------
    Line

    Raises
    ------
    InputError
        If no place was measured at two depths.
    """
    known = np.isfinite(deviation)
    count = known.sum(axis=0)
    h = np.where(known, depth, 0.0)
    delta = np.where(known, deviation, 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        centre, mean = h.sum(axis=0) / count, delta.sum(axis=0) / count
        x, y = np.where(known, h - centre, 0.0), np.where(known, delta - mean, 0.0)
        spread = (x * x).sum(axis=0)
        two = spread > 1e-12 * centre**2
        slope = np.where(two, (x * y).sum(axis=0) / spread, math.nan)
    if not two.any():
        raise InputError(
            phrase("the parts of different depth were measured at different places: nothing can be compared")
        )
    residual = np.where(known & two, y - slope * x, 0.0)
    freedom = int((count - 2)[two].sum())
    std = math.sqrt(float((residual**2).sum()) / freedom) if freedom > 0 else math.nan
    return Line(slope, np.where(two, spread, 0.0), centre, std)


def from_line(
    offset: Floats,
    slope: Floats,
    *,
    slope_std: ArrayLike,
    level_std: ArrayLike,
    depth: ArrayLike,
    place: Floats | None = None,
) -> TransferFunction:
    """Transfer function and offset from a line over depth.

    Parameters
    ----------
    offset, slope : (n,) float64
        a in mm and b of ``delta = a + b h``.
    slope_std : (n,) float64
        Standard uncertainty of the slope.
    level_std : (n,) float64
        Standard uncertainty of the line's value at `depth`, mm.
    depth : (n,) float64
        Mean of the measured depths, mm, where value and slope of the line are independent.
    place : (n, 2) float64, optional
        Points in mm, for messages.

    Returns
    -------
    TransferFunction
        ``MS = b / (1 - b)``, ``u(MS) = (1 + MS)^2 u(b)``, ``u(a)^2 = u(level)^2 + depth^2 u(b)^2`` and
        ``cov(a, MS) = -depth (1 + MS)^2 u(b)^2``.

    Raises
    ------
    RefusedError
        Where next to nothing of the depth is removed.
    """
    a, b, ub, ul, h = np.broadcast_arrays(
        *(np.asarray(x, dtype=np.float64) for x in (offset, slope, slope_std, level_std, depth))
    )
    if (bad := np.flatnonzero(~(1.0 - b >= LEAST_REMOVED))).size:
        raise RefusedError(
            phrase(
                "{}{:.0f} % of the difference between the depths stayed: no transfer function follows from "
                "that; check {}",
                _at(place, bad[0]),
                100 * b[bad[0]],
                option("depth"),
            ),
        )
    ms = b / (1.0 - b)
    growth = (1.0 + ms) ** 2
    return TransferFunction(
        ms, growth * ub, a.copy(), np.sqrt(ul**2 + (h * ub) ** 2), -h * growth * ub**2, offset_known=True
    )


def one_value(value: Floats, trust: Floats, std: Floats) -> tuple[float, float]:
    """Mean over the points, as the paper takes it, with its standard uncertainty.

    Parameters
    ----------
    value : (n,) float64
        MS, or the slope b, at every point.
    trust : (n,) float64
        Weight of every point, 0 to 1.
    std : (n,) float64
        Standard uncertainty of single points, taken as independent; where it is not known the scatter about the mean
        stands for it.
    """
    share = trust / trust.sum()
    mean = float(share @ value)
    if not np.isfinite(std).all():
        n = len(value)
        std = np.full(n, math.sqrt(float(share @ (value - mean) ** 2) * n / (n - 1)) if n > 1 else math.nan)
    return mean, math.sqrt(float((share * std) @ (share * std)))


def along_axis(normal: Floats, foot: Floats, along: str) -> Floats:
    """Factor that takes a deviation along the normal to one along an axis: ``1 / |cosine|``.

    petrakov-2025 reads delta along Y (table 2) and H along the normal, ``MSy = delta_y / (H - delta_y)``, and moves
    the path by ``H (1 + MSy) / cos alpha`` along Y, which is ``H (1 + MSy)`` along the normal. So the same
    correction as along the normal follows from ``delta_y = delta / |cos beta|`` in place of delta; it is larger by
    nearly ``1 / |cos beta|``.

    Parameters
    ----------
    normal, foot : (n, 2) float64
        Directional cosines and place of the points.
    along : {'normal', 'x', 'y'}

    Returns
    -------
    (n,) float64
        1 for 'normal'.

    Raises
    ------
    RefusedError
        Where the contour runs more along the axis than across it: the reading means nothing there.
    """
    if along == "normal":
        return np.ones(len(normal))
    cosine = np.abs(normal[:, "xy".index(along)])
    worst = int(np.argmin(cosine)) if len(cosine) else 0
    if len(cosine) and cosine[worst] < LEAST_COSINE:
        raise RefusedError(
            phrase(
                "{}the normal is {:.0f} degrees off {}: a deviation along {} says little there; use {}",
                _at(foot, worst),
                math.degrees(math.acos(cosine[worst])),
                along.upper(),
                along.upper(),
                remedy("depth_along", "normal"),
            ),
        )
    out: Floats = 1.0 / cosine
    return out


def examine(transfer: TransferFunction, foot: Floats) -> tuple[str, ...]:
    """Look whether a transfer function can be one.

    Parameters
    ----------
    transfer : TransferFunction
    foot : (n, 2) float64
        Place of the points, mm.

    Returns
    -------
    tuple of str
        Warnings: an implausibly large MS, and one that is small beyond its uncertainty.

    Raises
    ------
    RefusedError
        Where MS is negative beyond its uncertainty: no elastic system removes more than it is told to. The bound
        lets one measurement in a hundred of a rigid machine through this by chance, over all points together.
        Also where MS is implausibly large at most points.
    """
    from scipy.special import ndtri

    if not len(transfer):
        return ()
    ms, std = transfer.ms, transfer.ms_std
    if not np.isfinite(std).all():
        scatter = float(ms.std(ddof=1)) if len(ms) > 1 else 0.0
        std = np.where(np.isfinite(std), std, scatter)
    bound = -float(ndtri(CHANCE / len(ms))) * std
    low = int(np.argmin(ms + bound))
    if ms[low] < -bound[low] - 1e-9:
        x, y = foot[low]
        way_out = (
            phrase("check {} and which part was cut at which", option("depth"))
            if transfer.offset_known
            else phrase(
                "the tool may be larger than stated or the path off; measure a part cut at another {} as "
                "well, or use {}",
                option("depth"),
                remedy("method", "mirror"),
            )
        )
        raise RefusedError(
            phrase(
                "at {} the transfer function would be {:+.4f}, negative beyond its uncertainty of {:.4f}: no "
                "elastic system removes more than it is told to; {}",
                xy(x, y),
                ms[low],
                std[low],
                way_out,
            ),
        )
    middle = float(np.median(ms))
    if middle >= IMPLAUSIBLE:
        raise RefusedError(
            phrase(
                "the transfer function would be {:.3f} in the middle: {:.0f} % of the depth would stay, "
                "which no machine is left to do; check {}",
                middle,
                100 * middle / (1 + middle),
                option("depth"),
            ),
        )
    # The middle is known better than a single point: its own uncertainty is at most that of the points.
    if 3.0 * float(np.median(std)) < middle < STIFF:
        return (
            phrase(
                "the transfer function is {:.4f} in the middle: only {:.1f} % of the depth stays, less than "
                "milling machines give way; check {}",
                middle,
                100 * middle,
                option("depth"),
            ),
        )
    high = int(np.argmax(ms))
    if ms[high] >= IMPLAUSIBLE:
        x, y = foot[high]
        return (
            phrase(
                "the transfer function is {:.3f} at {}: {:.0f} % of the depth stays; check {}",
                ms[high],
                xy(x, y),
                100 * ms[high] / (1 + ms[high]),
                option("depth"),
            ),
        )
    return ()


def _at(place: Floats | None, row: int) -> str:
    return "" if place is None else phrase("at {}: ", xy(place[row, 0], place[row, 1]))
