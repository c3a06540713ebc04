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
from numpy.typing import NDArray

from .deviation import BRANCH_GAP
from .errors import FitError, InputError, UsageError
from .footpoint import FootPoints, FootPointSearch, Place
from .measurement import Measurement
from .profile import CORNER_ANGLE, Profile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

log = logging.getLogger(__name__)

BELONGS = 2.0
"""When most points lie farther than this from the profile after the fit, in mm, they are not its points."""

OUTLIER = (4.5, 7.0)
"""Residuals below the first multiple of the robust standard deviation have weight 1, above the second none."""

FINEST = 1e-4
"""No measurement is taken to scatter by less than this, in mm."""

TRIAL = 1.0
"""A direction of the motion is tried by a move of this many mm (for a turn: at the points' mean lever)."""

VISIBLE = 1e-3
"""A trial move must change the deviations by this much, in mm root mean square, and ..."""

CERTAIN = 10.0
"""... by this many standard uncertainties; otherwise the direction is undetermined."""

_COARSE = 500
_COARSE_FLOOR = 0.01
_GOOD = 0.1
_CLOSE = 1e-9
_ROUNDS = 80
_TURN = 0.3
"""An undetermined direction with a larger part of turning counts as a turn, with a smaller one as a slide."""

_AXES = ("shift X", "shift Y", "turn")


@dataclass(frozen=True, slots=True)
class Transform:
    """Motion of the plane: a turn about the origin, then a shift; ``p' = Rot(rotation) p + shift``.

    Parameters
    ----------
    shift : (float, float)
        mm.
    rotation : float
        rad, positive anticlockwise. At multiples of 90 degrees sine and cosine are exact.
    """

    shift: tuple[float, float] = (0.0, 0.0)
    rotation: float = 0.0

    @staticmethod
    def about(
        rotation: float, centre: tuple[float, float] = (0.0, 0.0), shift: tuple[float, float] = (0.0, 0.0)
    ) -> Transform:
        """Turn about a centre, then a shift: ``p' = Rot(rotation) (p - centre) + centre + shift``.

        A work offset G54 with rotation places the work frame in the machine: this maps work to machine, and
        its `inverse` lays points measured in machine coordinates into the work frame.

        Parameters
        ----------
        rotation : float
            rad, positive anticlockwise.
        centre, shift : (float, float)
            mm.
        """
        (a, b), (x, y) = Transform((0.0, 0.0), rotation)._turned(*centre), centre
        return Transform((float(shift[0] + (x - a)), float(shift[1] + (y - b))), rotation)

    @property
    def matrix(self) -> Floats:
        """Rotation matrix, (2, 2)."""
        quarters = self.rotation / (math.pi / 2)
        if quarters == round(quarters):
            c, s = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
        else:
            c, s = math.cos(self.rotation), math.sin(self.rotation)
        return np.array([[c, -s], [s, c]])

    def _turned(self, x: Any, y: Any) -> tuple[Any, Any]:
        (c, minus_s), (s, _) = self.matrix
        return c * x + minus_s * y, s * x + c * y

    def points(self, xy: Floats) -> Floats:
        """Moved points; (n, 2) or (n, 3) in mm, a third coordinate stays."""
        out = np.array(xy, dtype=np.float64)
        x, y = self._turned(xy[:, 0], xy[:, 1])
        out[:, 0], out[:, 1] = x + self.shift[0], y + self.shift[1]
        return out

    def directions(self, vectors: Floats) -> Floats:
        """Turned vectors; (n, 2) or (n, 3), a third component stays."""
        out = np.array(vectors, dtype=np.float64)
        out[:, 0], out[:, 1] = self._turned(vectors[:, 0], vectors[:, 1])
        return out

    def measurement(self, measurement: Measurement) -> Measurement:
        """The measurement moved, its normals turned with it."""
        normals = measurement.normals
        return dataclasses.replace(
            measurement,
            points=self.points(measurement.points),
            normals=None if normals is None else self.directions(normals),
        )

    def inverse(self) -> Transform:
        """The motion that takes this one back."""
        back = Transform((0.0, 0.0), -self.rotation)
        x, y = back._turned(*self.shift)
        return Transform((0.0 - float(x), 0.0 - float(y)), 0.0 - self.rotation)

    def then(self, other: Transform) -> Transform:
        """The motion that another one follows."""
        x, y = other._turned(*self.shift)
        return Transform(
            (float(x) + other.shift[0], float(y) + other.shift[1]), self.rotation + other.rotation
        )


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
                f"--align {text}: give none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all"
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
        return Spread(
            float(value.mean()), float(np.sqrt(np.mean(value * value))), float(np.abs(value).max())
        )


@dataclass(frozen=True, eq=False, slots=True)
class Alignment:
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
        Standard deviation of the residuals in mm, with the degrees of freedom taken off; NaN unless fitted.
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

    def __post_init__(self) -> None:
        for array in (self.covariance, self.weight, self.taking_part):
            array.flags.writeable = False

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
    before = after = Spread.of(np.zeros(0))
    taking_part = np.ones(len(measurement), dtype=bool)
    if profile is not None and len(measurement):
        fit = _Fit(measurement, profile, Freedom(False, False, False))
        fit_after = _Fit(moved, profile, Freedom(False, False, False))
        at, end = fit.look(np.zeros(3)), fit_after.look(np.zeros(3))
        taking_part = fit_after.usable(end)
        before, after = Spread.of(at.value[taking_part]), Spread.of(end.value[taking_part])
    locked = (False, False, False)
    return moved, _unfitted(transform, "given", locked, before, after, taking_part)


def align(
    measurement: Measurement, profile: Profile, freedom: Freedom | None = None
) -> tuple[Measurement, Alignment]:
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
    fit = _Fit(measurement, profile, freedom)
    if not any(freedom.free):
        look = fit.look(np.zeros(3))
        taking_part = fit.usable(look)
        spread = Spread.of(look.value[taking_part])
        return measurement, _unfitted(Transform(), "none", freedom.free, spread, spread, taking_part)
    fit.require(len(measurement), "are given")
    q = fit.coarse()
    basis, undetermined = fit.determined(q)
    q, look, state = fit.least_squares(basis @ (basis.T @ q), basis)
    iterations = state.iterations
    if freedom.zone:
        q, look, more = fit.minimum_zone(q, basis, state.weight >= 0.5)
        iterations += more
    result = _finished(fit, q, look, basis, undetermined, state, iterations)
    log.info("%s: %s", measurement.source, result.in_words())
    return result.transform.measurement(measurement), result


@dataclass(frozen=True, eq=False, slots=True)
class _Look:
    """Deviations at one pose: value (n,), slope (n, 3) over the motion in mm, feet and moved points."""

    value: Floats
    slope: Floats
    feet: FootPoints
    xy: Floats


@dataclass(frozen=True, eq=False, slots=True)
class _State:
    """Weights and points of a least squares fit."""

    weight: Floats
    taking_part: Bools
    iterations: int


class _Fit:
    """One fit: the points, the profile, and the coordinates q of the motion, three lengths in mm.

    With both shifts free, ``p' = Rot(q3 / lever) (p + (q1, q2) - centre) + centre``, centre being the profile's
    centroid: on a round profile the turn then leaves the deviations alone, and only the turn. Otherwise
    ``p' = Rot(q3 / lever) p + (q1, q2)``, so that a locked shift is 0.
    """

    def __init__(self, measurement: Measurement, profile: Profile, freedom: Freedom) -> None:
        self.source = measurement.source
        self.profile = profile
        self.freedom = freedom
        self.radius = measurement.ball_radius
        self.points = measurement.points[:, :2]
        self.normals = None if measurement.normals is None else measurement.normals[:, :2]
        self.search = FootPointSearch(profile, margin=5.0 + self.radius)
        self.free = np.eye(3)[:, np.flatnonzero(freedom.free)]
        self.central = freedom.shift_x and freedom.shift_y or not freedom.rotation
        self.centre = _centroid(profile)
        pivot = self.centre if self.central else np.zeros(2)
        lever = float(np.sqrt(np.mean(np.sum((self.points - pivot) ** 2, axis=1)))) if len(self.points) else 0.0
        self.lever = max(lever, 1e-3)
        # The same points whenever the same measurement is fitted, without regard to their order along the contour.
        order = np.random.default_rng(0).permutation(len(self.points))
        self.few = np.sort(order[:_COARSE])

    def require(self, count: int, what: str) -> None:
        """InputError where so many points are too few for the free degrees of freedom."""
        needed = self.free.shape[1] + 1
        if count < needed:
            raise InputError(
                f"{self.source}: alignment with {needed - 1} free degrees of freedom needs at least {needed} points, "
                f"{count} {what}"
            )

    def transform(self, q: Floats) -> Transform:
        """The motion of the coordinates q."""
        rotation = float(q[2] / self.lever) + 0.0
        if not self.central:
            return Transform((float(q[0]), float(q[1])), rotation)
        turn = Transform((0.0, 0.0), rotation)
        x, y = turn._turned(q[0], q[1])
        a, b = turn._turned(*self.centre)
        return Transform((float(x + (self.centre[0] - a)), float(y + (self.centre[1] - b))), rotation)

    def jacobian(self, q: Floats) -> Floats:
        """Derivative of shift X, shift Y and rotation over q, (3, 3)."""
        out = np.diag([1.0, 1.0, 1.0 / self.lever])
        if self.central:
            matrix = self.transform(q).matrix
            x, y = matrix @ (q[:2] - self.centre)
            out[:2, :2] = matrix
            out[:2, 2] = np.array([-y, x]) / self.lever
        return out

    def pivot(self, q: Floats) -> Floats:
        """Point about which a change of q3 turns, after the motion, mm."""
        return self.centre if self.central else q[:2]

    def push(self, q: Floats) -> Floats:
        """Derivative of the shift of the moved points over q1 and q2, (2, 2)."""
        return self.transform(q).matrix if self.central else np.eye(2)

    def look(self, q: Floats, rows: Ints | None = None) -> _Look:
        """Deviations of the points, or of some rows, at a pose."""
        transform = self.transform(q)
        points = self.points if rows is None else self.points[rows]
        xy = transform.points(points)
        feet = self.search.find(xy)
        if self.normals is not None:
            normals = transform.directions(self.normals if rows is None else self.normals[rows])
            feet = self.search.on_the_side_of(xy, normals, feet)
        return _Look(feet.distance - self.radius, self.slope(q, xy, feet.normal), feet, xy)

    def slope(self, q: Floats, xy: Floats, normal: Floats) -> Floats:
        """Derivative of the deviations over q, (n, 3)."""
        arm = xy - self.pivot(q)
        turn = (normal[:, 1] * arm[:, 0] - normal[:, 0] * arm[:, 1]) / self.lever
        return np.column_stack([normal @ self.push(q), turn])

    def usable(self, look: _Look) -> Bools:
        """Points with one certain normal: not at a corner, beyond an open end or between two branches."""
        feet, profile = look.feet, self.profile
        before = np.where(feet.t == 1.0, feet.span, profile.neighbour(feet.span, -1))
        corner = (feet.place == Place.JOINT) & (np.abs(np.nan_to_num(profile.turn[before])) > CORNER_ANGLE)
        unsure = feet.rival < np.maximum(BRANCH_GAP, np.abs(look.value))
        out: Bools = ~corner & ~unsure & (feet.place != Place.END)
        return out

    def coarse(self) -> Floats:
        """Pose near the best one, from few points; several starts where the first leads nowhere.

        Raises
        ------
        FitError
            If most points stay far from the profile.
        """
        q, spread = self._descend(np.zeros(3))
        if spread > _GOOD:
            for start in self._starts():
                other, wider = self._descend(start)
                if wider < 0.7 * spread:
                    q, spread = other, wider
        look = self.look(q, self.few)
        gap = np.hypot(*(look.xy - look.feet.foot).T) - self.radius
        far = float(np.mean(np.abs(gap) > BELONGS))
        if far > 0.5:
            raise FitError(
                f"{self.source}: alignment: {100 * far:.0f} % of the points stay farther than {BELONGS:g} mm from the "
                "profile; check unit, work frame, --points and --nominal"
            )
        return q

    def _descend(self, q: Floats) -> tuple[Floats, float]:
        """Reweighted Gauss-Newton from a start, with Tukey's biweight; the pose and the spread left, mm."""
        e = np.zeros(0)
        for _ in range(40):
            look = self.look(q, self.few)
            e, slope = self._pulled(q, look)
            cut = 4.685 * max(1.4826 * float(np.median(np.abs(e))), _COARSE_FLOOR)
            weight = np.maximum(1 - (e / cut) ** 2, 0.0) ** 2
            a = slope @ self.free
            values, vectors = np.linalg.eigh(a.T @ (weight[:, None] * a))
            seen = values > (VISIBLE / TRIAL) ** 2 * max(float(weight.sum()), 1e-9)
            right = vectors[:, seen].T @ (a.T @ (weight * e))
            step = -self.free @ (vectors[:, seen] @ (right / values[seen]))
            step /= max(1.0, float(np.hypot(*step[:2])) / 5.0, abs(float(step[2])) / self.lever / 0.1)
            q = q + step
            if np.abs(step).max() < 1e-4:
                break
        return q, float(np.quantile(np.abs(e - np.median(e)), 0.8))

    def _pulled(self, q: Floats, look: _Look) -> tuple[Floats, Floats]:
        """Deviations and slopes in which points beyond an open end are drawn back to that end."""
        beyond = np.flatnonzero(look.feet.place == Place.END)
        if not len(beyond):
            return look.value, look.slope
        away = look.xy[beyond] - look.feet.foot[beyond]
        gap = np.hypot(*away.T)
        value, slope = look.value.copy(), look.slope.copy()
        value[beyond] = gap - self.radius
        slope[beyond] = self.slope(q, look.xy[beyond], away / np.maximum(gap, 1e-12)[:, None])
        return value, slope

    def _starts(self) -> list[Floats]:
        """The most promising of many turns and shifts."""
        angles = np.radians([0.0, -2.0, 2.0, -5.0, 5.0, -10.0, 10.0]) if self.freedom.rotation else np.zeros(1)
        moves = np.array([0.0, -2.0, 2.0, -4.0, 4.0])
        xs = moves if self.freedom.shift_x else np.zeros(1)
        ys = moves if self.freedom.shift_y else np.zeros(1)
        poses = np.stack(np.meshgrid(xs, ys, angles * self.lever, indexing="ij"), axis=-1).reshape(-1, 3)
        rows = self.few[:: max(1, len(self.few) // 150)]
        xy = np.concatenate([self.transform(q).points(self.points[rows]) for q in poses])
        feet = self.search.find(xy)
        gap = np.abs(np.hypot(*(xy - feet.foot).T) - self.radius).reshape(len(poses), -1)
        score = np.quantile(gap, 0.8, axis=1)
        return [poses[i] for i in np.argsort(score, kind="stable")[:6]]

    def determined(self, q: Floats) -> tuple[Floats, tuple[str, ...]]:
        """Basis (3, k) of the directions of q that the points determine, and the others in words.

        The eigenvectors of the normal matrix are tried one by one: the foot points, which lie on the profile, are
        moved along by `TRIAL`, the other directions may compensate, and the deviations that are left must be seen
        (`VISIBLE`) and certain (`CERTAIN`). A finite move sees through the facets of a rounded profile, which a
        derivative takes for shape.
        """
        look = self.look(q, self.few)
        used = np.flatnonzero(self.usable(look))
        self.require(len(used), "can be used")
        foot, value = look.feet.foot[used], look.value[used]
        noise = max(1.4826 * float(np.median(np.abs(value - np.median(value)))), FINEST)
        a = self.slope(q, foot, look.feet.normal[used]) @ self.free
        _, vectors = np.linalg.eigh(a.T @ a)
        share = len(self.points) / len(self.few)
        keep, words = [], []
        for i in range(vectors.shape[1]):
            others = a @ np.delete(vectors, i, axis=1)
            direction = self.free @ vectors[:, i]
            change = min(self._change(q, foot, sign * TRIAL * direction, others) for sign in (-1.0, 1.0))
            if change <= VISIBLE**2 * len(used) or change * share <= (CERTAIN * noise) ** 2:
                words.append(self._name(q, direction))
            else:
                keep.append(i)
        basis = self.free @ vectors[:, keep]
        return _without_turn(basis, self.free @ np.delete(vectors, keep, axis=1)), tuple(words)

    def _change(self, q: Floats, foot: Floats, move: Floats, others: Floats) -> float:
        """Sum of squared deviations, mm2, that a move of points of the profile leaves whatever the others do."""
        pivot = self.pivot(q)
        x, y = self.push(q) @ move[:2]
        moved = Transform.about(move[2] / self.lever, (pivot[0], pivot[1]), (x, y)).points(foot)
        feet = self.search.find(moved)
        inside = feet.place != Place.END
        e, others = feet.distance[inside], others[inside]
        if others.shape[1] and len(e):
            e = e - others @ np.linalg.lstsq(others, e, rcond=1e-9)[0]
        return float(e @ e)

    def _name(self, q: Floats, direction: Floats) -> str:
        """A direction of q in words."""
        x, y = self.push(q) @ direction[:2]
        if abs(direction[2]) > 0.01:
            turn = direction[2] / self.lever
            cx, cy = np.round(self.pivot(q) + np.array([-y, x]) / turn, 1) + 0.0
            return f"{'turn about' if abs(direction[2]) > _TURN else 'slide round'} X{cx:.1f} Y{cy:.1f}"
        angle = round(math.degrees(math.atan2(y, x)), 1) % 180.0
        return {0.0: "shift along X", 90.0: "shift along Y"}.get(angle, f"shift along {angle:.1f} deg to X")

    def weights(self, look: _Look, taking_part: Bools) -> Floats:
        """Weight of each point: 1 up to the first limit of `OUTLIER`, then falling as Tukey's biweight to 0."""
        weight = taking_part.astype(np.float64)
        value = look.value[taking_part]
        # Few points do not tell which of them is wrong.
        if not self.freedom.robust or len(value) < 5 * self.free.shape[1]:
            return weight
        away = np.abs(value - np.median(value))
        scale = max(1.4826 * float(np.median(away)), FINEST)
        over = np.clip((away / scale - OUTLIER[0]) / (OUTLIER[1] - OUTLIER[0]), 0.0, 1.0)
        weight[taking_part] = (1 - over**2) ** 2
        return weight

    def least_squares(self, q: Floats, basis: Floats) -> tuple[Floats, _Look, _State]:
        """Pose of the least sum of weighted squares.

        Raises
        ------
        InputError
            If too few points can be used.
        FitError
            If the steps do not become small.
        """
        weight, taking_part = np.zeros(len(self.points)), np.zeros(len(self.points), dtype=bool)
        fixed, size, damping = False, math.inf, 1.0
        for iteration in range(1, _ROUNDS + 1):
            look = self.look(q)
            if not fixed:
                taking_part = self.usable(look)
                self.require(int(taking_part.sum()), "can be used")
                new = self.weights(look, taking_part)
                fixed = size < 1e-3 and (np.abs(new - weight).max() < 1e-9 or iteration > _ROUNDS // 3)
                weight = new
                self.require(int((weight > 0).sum()), "can be used")
            a = look.slope @ basis
            normal = a.T @ (weight[:, None] * a)
            try:
                step = -damping * (basis @ np.linalg.solve(normal, a.T @ (weight * look.value)))
            except np.linalg.LinAlgError:
                raise FitError(f"{self.source}: alignment: the usable points do not determine the motion") from None
            before, size = size, float(np.abs(step).max()) if len(basis.T) else 0.0
            if fixed and size < _CLOSE:
                return q, look, _State(weight, taking_part, iteration)
            if fixed and size > 0.7 * before:
                damping *= 0.5
                if size < 1e-6 and damping < 0.01:
                    return q, look, _State(weight, taking_part, iteration)
            q = q + step
        raise FitError(f"{self.source}: alignment: no end after {_ROUNDS} steps, the last one {size:.2g} mm")

    def minimum_zone(self, q: Floats, basis: Floats, inside: Bools) -> tuple[Floats, _Look, int]:
        """Pose of the least largest absolute deviation, by linear programmes within a trust region.

        Raises
        ------
        FitError
            If the steps do not become small.
        """
        rows = np.flatnonzero(inside).astype(np.int64)
        look = self.look(q, rows)
        height = float(np.abs(look.value).max())
        reach = 10 * height
        for iteration in range(1, _ROUNDS + 1):
            if height < _CLOSE or not basis.shape[1]:
                return q, self.look(q), iteration
            z, expected = _chebyshev_step(look.value, look.slope @ basis, reach)
            step = basis @ z
            if height - expected < _CLOSE or np.abs(step).max() < _CLOSE:
                return q, self.look(q), iteration
            trial = self.look(q + step, rows)
            reached = float(np.abs(trial.value).max())
            gain = (height - reached) / (height - expected)
            if gain > 0.1:
                q, look, height = q + step, trial, reached
                reach *= 2.0 if gain > 0.75 else 1.0
            else:
                reach = float(np.abs(z).max()) / 4
            if reach < _CLOSE:
                return q, self.look(q), iteration
        raise FitError(f"{self.source}: alignment: no minimum zone after {_ROUNDS} steps")


def _finished(
    fit: _Fit,
    q: Floats,
    look: _Look,
    basis: Floats,
    undetermined: tuple[str, ...],
    state: _State,
    iterations: int,
) -> Alignment:
    """The noun of a finished fit."""
    weight, taking_part = state.weight, state.taking_part
    a, d = look.slope @ basis, look.value
    spare = float(weight.sum()) - basis.shape[1]
    variance = float(weight @ d**2) / spare if spare > 0 else math.nan
    covariance = np.full((3, 3), math.nan)
    if not fit.freedom.zone:
        root = fit.jacobian(q) @ basis
        covariance = variance * root @ np.linalg.inv(a.T @ (weight[:, None] * a)) @ root.T
        covariance = (covariance + covariance.T) / 2
    counted = weight >= 0.5
    hidden = _offset_hidden(a, weight)
    scale, uncertainty, explained = _scale(fit, look, a, weight)
    result = Alignment(
        transform=fit.transform(q),
        method="minimum zone" if fit.freedom.zone else "least squares",
        free=fit.freedom.free,
        undetermined=undetermined,
        covariance=covariance,
        before=Spread.of(fit.look(np.zeros(3)).value[counted]),
        after=Spread.of(d[counted]),
        residual_std=math.sqrt(variance),
        offset_hidden=hidden,
        scale=scale,
        scale_uncertainty=uncertainty,
        weight=weight,
        taking_part=taking_part,
        iterations=iterations,
        warnings=(),
    )
    return dataclasses.replace(result, warnings=tuple(_advice(fit, result, explained)))


def _offset_hidden(slope: Floats, weight: Floats) -> float:
    """Share of a constant deviation that motions with the given slopes take away."""
    root = np.sqrt(weight)
    fitted = slope @ np.linalg.lstsq(root[:, None] * slope, root, rcond=1e-9)[0]
    return float(weight @ fitted**2 / weight.sum()) if slope.shape[1] else 0.0


def _scale(fit: _Fit, look: _Look, slope: Floats, weight: Floats) -> tuple[float, float, float]:
    """Scale, its standard uncertainty, and the share of the residuals' squares that it explains.

    A constant deviation is estimated with it, so that excess material is not taken for a larger part.
    """
    root = np.sqrt(weight)
    growth = ((look.xy - fit.centre) * look.feet.normal).sum(axis=1)
    others = root[:, None] * np.column_stack([slope, np.ones(len(growth))])
    y, g = root * look.value, root * growth
    y = y - others @ np.linalg.lstsq(others, y, rcond=1e-9)[0]
    clear = g - others @ np.linalg.lstsq(others, g, rcond=1e-9)[0]
    total, spare = float(clear @ clear), float(weight.sum()) - others.shape[1] - 1
    # On a round profile growing and a constant deviation are the same.
    if spare <= 0 or total <= (1e-2 * fit.lever) ** 2 * float(weight.sum()):
        return math.nan, math.inf, 0.0
    rate = float(clear @ y) / total
    left = y - rate * clear
    noise = max(float(left @ left) / spare, (FINEST * 1e-3) ** 2)
    return 1.0 + rate, math.sqrt(noise / total), rate**2 * total / max(float(y @ y), 1e-300)


def _advice(fit: _Fit, result: Alignment, explained: float) -> list[str]:
    """What the user should know about a fit."""
    out = [
        f"alignment: the points do not determine the {what}; the fit leaves it alone" for what in result.undetermined
    ]
    took, lost = int(result.taking_part.sum()), len(result.outliers)
    if lost > 0.05 * took:
        out.append(
            f"alignment: {lost} of {took} points ({100 * lost / took:.0f} %) lie off the rest and have no weight in "
            "the fit; is a side of the part displaced?"
        )
    if result.offset_hidden > 0.1:
        out.append(
            f"alignment: the fit hides {100 * result.offset_hidden:.0f} % of a constant deviation such as a wrong "
            f"tool or ball radius (mean {result.before.mean * 1e3:+.2f} um before, {result.after.mean * 1e3:+.2f} um "
            "after)"
        )
    off = abs(result.scale - 1.0)
    if off > 5 * result.scale_uncertainty and off * fit.lever > VISIBLE and explained > 0.25:
        out.append(
            f"alignment: the part measures {result.scale:.6f} +- {result.scale_uncertainty:.6f} of the profile's size "
            f"({off * fit.lever * 1e3:.1f} um at {fit.lever:.0f} mm); the scale is not applied: check temperature "
            "and unit"
        )
    return out


def _chebyshev_step(value: Floats, slope: Floats, reach: float) -> tuple[Floats, float]:
    """Step z, no component above `reach`, that makes max |value + slope z| least, and that maximum.

    A linear programme over the points that matter: solved for the largest ones, then again with the worst offenders
    added until no point exceeds the programme's own maximum.
    """
    from scipy.optimize import linprog

    unit = float(np.abs(value).max())
    d, k = value / unit, slope.shape[1]
    chosen = np.zeros(len(d), dtype=bool)
    chosen[np.argsort(-np.abs(d), kind="stable")[:100]] = True
    cost = np.append(np.zeros(k), 1.0)
    bounds = [(-reach / unit, reach / unit)] * k + [(0.0, None)]
    while True:
        a, b = slope[chosen], d[chosen]
        ones = np.ones((len(b), 1))
        found = linprog(
            cost, np.block([[a, -ones], [-a, -ones]]), np.concatenate([-b, b]), bounds=bounds, method="highs"
        )
        if found.x is None:
            raise FitError(f"minimum zone: the linear programme failed: {found.message}")
        z = found.x[:k]
        all_of = np.abs(d + slope @ z)
        excess = np.where(chosen, -1.0, all_of - all_of[chosen].max())
        if excess.max() <= 1e-10:
            return z * unit, float(all_of.max()) * unit
        worst = np.argsort(-excess, kind="stable")[:100]
        chosen[worst[excess[worst] > 0]] = True


def _without_turn(basis: Floats, lost: Floats) -> Floats:
    """Basis without any turn where a turn is lost, so that shifts alone make up what is determined."""
    if lost.shape[1] and np.abs(lost[2]).max() > _TURN and basis.shape[1]:
        flat = basis.copy()
        flat[2] = 0.0
        return np.linalg.qr(flat)[0]
    return basis


def _centroid(profile: Profile) -> Floats:
    """Centre of gravity of the profile's line, (2,) mm."""
    nodes, weights = np.polynomial.legendre.leggauss(16)
    span = np.repeat(np.arange(profile.spans), 16)
    c, d1, _ = profile.evaluate(span, np.tile((nodes + 1) / 2, profile.spans))
    mass = np.hypot(*d1.T) * np.tile(weights, profile.spans)
    out: Floats = mass @ c / mass.sum()
    return out


def _unfitted(
    transform: Transform,
    method: str,
    free: tuple[bool, bool, bool],
    before: Spread,
    after: Spread,
    taking_part: Bools,
) -> Alignment:
    return Alignment(
        transform=transform,
        method=method,
        free=free,
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
