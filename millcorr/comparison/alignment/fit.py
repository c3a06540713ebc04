# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alignment: the rigid motion that lays a measurement on its profile, and what that motion hides.

The fit has three degrees of freedom, shift in X, shift in Y and a turn, each free or locked. It goes in steps:
a coarse fit of few points with a redescending weight; a test which directions of the motion the points determine
at all; a least squares fit in which outliers have no weight; on demand the minimum zone of the points that are
left. A direction that the points do not determine stays at 0 and is named.
"""

from __future__ import annotations

import dataclasses
import logging
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, um
from millcorr.readers.measurement import Measurement
from millcorr.readers.transform import Transform

from .rigid_fit import FINEST, VISIBLE, Look, RigidFit, Weights

log = logging.getLogger(__name__)

__all__ = ["Alignment", "Freedom", "Spread", "Transform", "align", "given"]

_AXES = ("shift X", "shift Y", "turn")


@dataclass(frozen=True, slots=True)
class Freedom:
    """What the fit may move, and what it makes small.

    Parameters
    ----------
    shift_x, shift_y, rotation : bool
        Free degrees of freedom; a locked one stays exactly 0. Where one shift is locked, the turn is about the
        origin of the work frame.
    zone : bool
        False for least squares, True for the minimum zone: the largest deviation is made as small as possible.
    robust : bool
        Outliers lose their weight. False makes every point count, as a plain Gaussian best fit.
    """

    shift_x: bool = True
    shift_y: bool = True
    rotation: bool = True
    zone: bool = False
    robust: bool = True

    @staticmethod
    def parse(text: str) -> Freedom:
        """Freedom from an option's text.

        Parameters
        ----------
        text : str
            ``none``, ``shift``, ``rigid`` or degrees of freedom joined by ``+`` (``x``, ``y``, ``turn``); then
            ``:zone`` for the minimum zone or ``:all`` for least squares in which outliers count too.

        Raises
        ------
        UsageError
            If the text is none of these.
        """
        words, _, kind = text.strip().lower().partition(":")
        named = {"none": "", "shift": "x+y", "rigid": "x+y+turn"}
        axes = [w for w in named.get(words, words).split("+") if w or words not in named]
        if not set(axes) <= {"x", "y", "turn"} or kind not in ("", "zone", "all") or len(set(axes)) < len(axes):
            raise UsageError(
                phrase(
                    "{}: give none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all",
                    option("align", text),
                ),
            )
        return Freedom("x" in axes, "y" in axes, "turn" in axes, kind == "zone", kind != "all")

    @property
    def free(self) -> tuple[bool, bool, bool]:
        """Shift X, shift Y, turn."""
        return self.shift_x, self.shift_y, self.rotation

    def in_words(self) -> str:
        """The free degrees of freedom and the criterion."""
        axes = ", ".join(name for name, free in zip(_AXES, self.free, strict=True) if free) or "nothing"
        return f"{'minimum zone' if self.zone else 'least squares'}, free: {axes}"


@dataclass(frozen=True, slots=True)
class Spread:
    """Mean, root mean square and largest absolute value of deviations, mm; NaN without points."""

    mean: float
    rms: float
    max: float

    @staticmethod
    def of(value: Floats) -> Spread:
        """Spread of the given deviations, (n,) in mm."""
        if not len(value):
            return Spread(math.nan, math.nan, math.nan)
        return Spread(float(value.mean()), float(np.sqrt(np.mean(value * value))), float(np.abs(value).max()))


@dataclass(frozen=True, eq=False, slots=True)
class Alignment(ReadOnlyArrays):
    """A motion that was applied to a measurement, how sure it is, and what it absorbed.

    Parameters
    ----------
    transform : Transform
        ``p' = Rot(rotation) p + shift``, about the origin of the work frame.
    method : {'none', 'given', 'least squares', 'minimum zone'}
    free : (bool, bool, bool)
        Shift X, shift Y, turn; False where locked at 0.
    undetermined : tuple of str
        Directions of the motion that the points do not determine, in words; the motion has no part in them.
    covariance : (3, 3) float64
        Of shift X, shift Y and rotation, in mm and rad, for independent random errors of the points. 0 where
        locked or undetermined; NaN for the minimum zone, which has no such law.
    before, after : Spread
        Deviations of the points with weight, before and after the motion: what the fit absorbed.
    residual_std : float
        Standard deviation of the residuals about their mean in mm, degrees of freedom taken off; NaN unless
        fitted.
    offset_hidden : float
        Share 0..1 of a constant deviation (a wrong tool or ball radius) that the free degrees of freedom hide:
        0 on an evenly measured closed profile, 1 on a straight edge.
    scale, scale_uncertainty : float
        Size of the part over that of the profile, estimated together with a constant deviation, and its standard
        uncertainty; never applied. NaN and inf where the points do not determine it.
    weight : (n,) float64
        Weight of each point of the measurement, 0..1.
    taking_part : (n,) bool
        False at corners, beyond open ends and where two branches are equally near; such points have no weight.
    iterations : int
        Steps of the final fit.
    warnings : tuple of str
    """

    transform: Transform
    method: str
    free: tuple[bool, bool, bool]
    undetermined: tuple[str, ...]
    covariance: Floats
    before: Spread
    after: Spread
    residual_std: float
    offset_hidden: float
    scale: float
    scale_uncertainty: float
    weight: Floats
    taking_part: Bools
    iterations: int
    warnings: tuple[str, ...]

    @property
    def shift(self) -> tuple[float, float]:
        """Shift in mm."""
        return self.transform.shift

    @property
    def rotation(self) -> float:
        """Rotation about the origin in rad."""
        return self.transform.rotation

    @property
    def outliers(self) -> Ints:
        """Rows of the measurement that took part and lost more than half of their weight."""
        return np.flatnonzero(self.taking_part & (self.weight < 0.5)).astype(np.int64)

    def as_dict(self) -> dict[str, Any]:
        """Plain numbers for report.json; lengths in mm, angles in degrees, None where unknown."""
        sigma = np.sqrt(np.diag(self.covariance))

        def number(value: float) -> float | None:
            return float(value) if math.isfinite(value) else None

        return {
            "method": self.method,
            "shift": list(self.shift),
            "rotation_deg": math.degrees(self.rotation),
            "shift_uncertainty": [number(sigma[0]), number(sigma[1])],
            "rotation_uncertainty_deg": number(math.degrees(sigma[2])),
            "free": [name for name, free in zip(_AXES, self.free, strict=True) if free],
            "undetermined": list(self.undetermined),
            "before": {f.name: number(getattr(self.before, f.name)) for f in dataclasses.fields(Spread)},
            "after": {f.name: number(getattr(self.after, f.name)) for f in dataclasses.fields(Spread)},
            "residual_std": number(self.residual_std),
            "offset_hidden": number(self.offset_hidden),
            "scale": number(self.scale),
            "scale_uncertainty": number(self.scale_uncertainty),
            "outliers": [int(i) for i in self.outliers],
            "not_taking_part": int((~self.taking_part).sum()),
            "iterations": self.iterations,
        }

    def in_words(self) -> str:
        """Motion and what it absorbed, in one line."""
        x, y = self.shift
        text = f"{self.method}: shift X{x:+.4f} Y{y:+.4f} mm, turn {math.degrees(self.rotation):+.5f} deg"
        if self.before is not self.after:
            a, b = self.before, self.after
            text += (
                f"; rms {a.rms * 1e3:.2f} -> {b.rms * 1e3:.2f} um, max {a.max * 1e3:.2f} -> {b.max * 1e3:.2f} um, "
                f"mean {a.mean * 1e3:+.2f} -> {b.mean * 1e3:+.2f} um"
            )
        return text


def given(
    measurement: Measurement, transform: Transform, profile: Profile | None = None
) -> tuple[Measurement, Alignment]:
    """Move a measurement by a known motion: a work offset, a rotation, the frame a file states.

    Parameters
    ----------
    measurement : Measurement
    transform : Transform
        Applied as it is.
    profile : Profile, optional
        Tells what the motion did to the deviations.

    Returns
    -------
    Measurement, Alignment
    """
    moved = transform.measurement(measurement)
    if profile is None:
        nothing = Spread.of(np.zeros(0))
        return moved, _unfitted(transform, "given", nothing, nothing, np.ones(len(measurement), dtype=bool))
    value, _ = _deviations(measurement, profile)
    value_after, taking_part = _deviations(moved, profile)
    before, after = Spread.of(value[taking_part]), Spread.of(value_after[taking_part])
    return moved, _unfitted(transform, "given", before, after, taking_part)


def align(measurement: Measurement, profile: Profile, freedom: Freedom | None = None) -> tuple[Measurement, Alignment]:
    """Lay a measurement on its profile with the free degrees of freedom.

    Parameters
    ----------
    measurement : Measurement
        Contact points or ball centres of radius `ball_radius`; order, start and direction do not matter. It may
        be a few mm and a few degrees off.
    profile : Profile
    freedom : Freedom, optional
        All free by default, least squares.

    Returns
    -------
    Measurement, Alignment
        The measurement moved, its normals turned with it; the motion and what it absorbed.

    Raises
    ------
    InputError
        If there are too few points for the free degrees of freedom.
    FitError
        If the fit does not converge, or most points do not belong to the profile.

    Notes
    -----
    Least squares minimises the sum of ``w d**2``, the minimum zone ``max |d|``, d being the deviation of
    `deviations` (werner-2018). The gradient of d over a motion of the point is the profile's normal at the
    foot point, exactly, so that Gauss-Newton steps need no more than foot points.
    """
    freedom = freedom or Freedom()
    if not any(freedom.free):
        value, taking_part = _deviations(measurement, profile)
        spread = Spread.of(value[taking_part])
        return measurement, _unfitted(Transform(), "none", spread, spread, taking_part)
    fit = RigidFit(measurement, profile, freedom.free, freedom.robust)
    fit.require(len(measurement))
    q = fit.coarse()
    basis, undetermined = fit.determined(q)
    q, look, weights = fit.least_squares(basis @ (basis.T @ q), basis)
    if undetermined:
        # Which way an undetermined direction points is known well only at the end.
        basis, undetermined = fit.determined(q)
        q, look, weights = fit.least_squares(basis @ (basis.T @ q), basis)
    iterations = weights.iterations
    if freedom.zone:
        q, look, more = fit.minimum_zone(q, basis, weights.weight >= 0.5)
        iterations += more
    result = _finished(fit, freedom, q, look, basis, undetermined, weights, iterations)
    log.info("%s: %s", measurement.source, result.in_words())
    return result.transform.measurement(measurement), result


def _deviations(measurement: Measurement, profile: Profile) -> tuple[Floats, Bools]:
    """Deviations as they are, (n,) mm, and which of them take part."""
    fit = RigidFit(measurement, profile, (False, False, False))
    look = fit.look(np.zeros(3))
    return look.value, fit.usable(look)


def _finished(
    fit: RigidFit,
    freedom: Freedom,
    q: Floats,
    look: Look,
    basis: Floats,
    undetermined: tuple[str, ...],
    weights: Weights,
    iterations: int,
) -> Alignment:
    """The noun of a finished fit."""
    weight, slope = weights.weight, look.slope @ basis
    size = _Size.of(fit, look, slope, weight)
    covariance = np.full((3, 3), math.nan)
    if not freedom.zone:
        root = fit.jacobian(q) @ basis
        covariance = size.variance * root @ np.linalg.inv(slope.T @ (weight[:, None] * slope)) @ root.T
        covariance = (covariance + covariance.T) / 2
    counted = weight >= 0.5
    result = Alignment(
        transform=fit.transform(q),
        method="minimum zone" if freedom.zone else "least squares",
        free=freedom.free,
        undetermined=undetermined,
        covariance=covariance,
        before=Spread.of(fit.look(np.zeros(3)).value[counted]),
        after=Spread.of(look.value[counted]),
        residual_std=math.sqrt(size.variance),
        offset_hidden=_offset_hidden(slope, weight),
        scale=size.scale,
        scale_uncertainty=size.uncertainty,
        weight=weight,
        taking_part=weights.taking_part,
        iterations=iterations,
        warnings=(),
    )
    return dataclasses.replace(result, warnings=_advice(result, size, fit.lever))


def _offset_hidden(slope: Floats, weight: Floats) -> float:
    """Share of a constant deviation that motions with the given slopes take away."""
    root = np.sqrt(weight)
    fitted = slope @ np.linalg.lstsq(root[:, None] * slope, root, rcond=1e-9)[0]
    return float(weight @ fitted**2 / weight.sum()) if slope.shape[1] else 0.0


@dataclass(frozen=True, slots=True)
class _Size:
    """What the residuals say about the part's size.

    A constant deviation is estimated beside the scale, so that excess material is not taken for a larger part.
    `variance` is of the residuals about such a constant, mm2; `explained` the share of it that a scale explains.
    """

    variance: float
    scale: float = math.nan
    uncertainty: float = math.inf
    explained: float = 0.0

    @staticmethod
    def of(fit: RigidFit, look: Look, slope: Floats, weight: Floats) -> _Size:
        root = np.sqrt(weight)
        growth = root * ((look.xy - fit.centre) * look.feet.normal).sum(axis=1)
        others = root[:, None] * np.column_stack([slope, np.ones(len(root))])
        both, _, rank, _ = np.linalg.lstsq(others, np.column_stack([root * look.value, growth]), rcond=1e-9)
        y, clear = (np.column_stack([root * look.value, growth]) - others @ both).T
        spare = float(weight.sum()) - int(rank)
        variance = float(y @ y) / spare if spare > 0 else math.nan
        total = float(clear @ clear)
        # On a round profile growing and a constant deviation are the same.
        if spare <= 1 or total <= (1e-2 * fit.lever) ** 2 * float(weight.sum()):
            return _Size(variance)
        rate = float(clear @ y) / total
        left = y - rate * clear
        noise = max(float(left @ left) / (spare - 1), (1e-3 * FINEST) ** 2)
        share = rate**2 * total / max(float(y @ y), 1e-300)
        return _Size(variance, 1.0 + rate, math.sqrt(noise / total), share)


def _advice(result: Alignment, size: _Size, lever: float) -> tuple[str, ...]:
    """What the user should know about a fit."""
    out = [
        phrase("alignment: the points do not determine the {}; the fit leaves it alone", what)
        for what in result.undetermined
    ]
    took, lost = int(result.taking_part.sum()), len(result.outliers)
    if lost > 0.05 * took:
        out.append(
            phrase(
                "alignment: {} of {} points ({:.0f} %) lie off the rest and have no weight in the fit; is a "
                "side of the part displaced?",
                lost,
                took,
                100 * lost / took,
            )
        )
    if result.offset_hidden > 0.1:
        out.append(
            phrase(
                "alignment: the fit hides {:.0f} % of a constant deviation such as a wrong tool or ball "
                "radius (mean {} before, {} after)",
                100 * result.offset_hidden,
                um(result.before.mean, "+.2f"),
                um(result.after.mean, "+.2f"),
            )
        )
    off = abs(size.scale - 1.0)
    if off > 5 * size.uncertainty and off * lever > VISIBLE and size.explained > 0.25:
        out.append(
            phrase(
                "alignment: the part measures {:.6f} +- {:.6f} of the profile's size ({} at {}); the scale "
                "is not applied: check temperature and unit",
                size.scale,
                size.uncertainty,
                um(off * lever),
                mm(lever, ".0f"),
            )
        )
    return tuple(out)


def _unfitted(
    transform: Transform,
    method: str,
    before: Spread,
    after: Spread,
    taking_part: Bools,
) -> Alignment:
    return Alignment(
        transform=transform,
        method=method,
        free=(False, False, False),
        undetermined=(),
        covariance=np.zeros((3, 3)),
        before=before,
        after=after,
        residual_std=math.nan,
        offset_hidden=0.0,
        scale=math.nan,
        scale_uncertainty=math.inf,
        weight=taking_part.astype(np.float64),
        taking_part=taking_part,
        iterations=0,
        warnings=(),
    )
