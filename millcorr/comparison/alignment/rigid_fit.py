# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid fit of points to a profile: coarse, robust least squares, minimum zone, and what is determined at all.

The gradient of a deviation over a motion of its point is the profile's normal at the foot point, exactly. So
Gauss-Newton steps and linear programmes need no more than foot points.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import BRANCH_GAP, REACH
from millcorr.errors import FitError, InputError
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import CORNER_ANGLE, Profile
from millcorr.messages import mm, option, phrase
from millcorr.readers.measurement import Measurement
from millcorr.readers.transform import Transform

OUTLIER = (4.5, 7.0)
"""Residuals below the first multiple of the robust standard deviation have weight 1, above the second none."""

FINEST = 1e-4
"""No measurement is taken to scatter by less than this, in mm."""

TRIAL = 1.0
"""A direction of the motion is tried by a move of about this many mm (for a turn: at the points' mean lever)."""

VISIBLE = 1e-3
"""A trial move must change the deviations by this much, in mm root mean square, and ..."""

CERTAIN = 10.0
"""... by this many standard uncertainties; otherwise the direction is undetermined."""

_COARSE, _COARSEST = 500, 150
_COARSE_FLOOR = 0.01
_GOOD = 0.1
_CLOSE = 1e-9
_ROUNDS = 80
_TURN = 0.3
"""An undetermined direction with a larger part of turning counts as a turn, with a smaller one as a slide."""


@dataclass(frozen=True, eq=False, slots=True)
class Look:
    """Deviations at one pose: value (n,), slope (n, 3) over the motion in mm, feet and moved points."""

    value: Floats
    slope: Floats
    feet: FootPoints
    xy: Floats


@dataclass(frozen=True, eq=False, slots=True)
class Weights:
    """Weights and points of a least squares fit."""

    weight: Floats
    taking_part: Bools
    iterations: int


class RigidFit:
    """One fit: the points, the profile, and the coordinates q of the motion, three lengths in mm.

    With both shifts free, ``p' = Rot(q3 / lever) (p + (q1, q2) - centre) + centre``, centre being the profile's
    centroid: on a round profile the turn then leaves the deviations alone, and only the turn. Otherwise
    ``p' = Rot(q3 / lever) p + (q1, q2)``, so that a locked shift is 0.
    """

    def __init__(
        self, measurement: Measurement, profile: Profile, free: tuple[bool, bool, bool], robust: bool = True
    ) -> None:
        self.source = measurement.source
        self.profile = profile
        self.robust = robust
        self.radius = measurement.ball_radius
        self.points, self.z = measurement.points[:, :2], measurement.points[:, 2]
        self.normals = None if measurement.normals is None else measurement.normals[:, :2]
        self.search = FootPointSearch(profile, margin=5.0 + self.radius)
        self.free = np.eye(3)[:, np.flatnonzero(free)]
        self.central = (free[0] and free[1]) or not free[2]
        self.centre = _centroid(profile)
        pivot = self.centre if self.central else np.zeros(2)
        lever = float(np.median(np.hypot(*(self.points - pivot).T))) if len(self.points) else 0.0
        self.lever = max(lever, 1e-3)
        # Points at random do not fall in step with a pattern along the contour; the same ones at every call.
        order = np.random.default_rng(0).permutation(len(self.points))
        self.few, self.fewer = order[:_COARSE], order[:_COARSEST]

    def require(self, count: int) -> None:
        """InputError where so many points are too few for the free degrees of freedom."""
        needed = self.free.shape[1] + 1
        if count < needed:
            raise InputError(
                phrase(
                    "{}: alignment with {} free degrees of freedom needs at least {} points, there are {}",
                    self.source,
                    needed - 1,
                    needed,
                    count,
                )
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

    def look(self, q: Floats, rows: Ints | None = None) -> Look:
        """Deviations of the points, or of some rows, at a pose."""
        progress.step()
        transform = self.transform(q)
        points = self.points if rows is None else self.points[rows]
        xy = transform.points(points)
        at_height = np.column_stack([xy, self.z if rows is None else self.z[rows]])
        feet = self.search.find(at_height, rivals=True)
        if self.normals is not None:
            normals = transform.directions(self.normals if rows is None else self.normals[rows])
            feet = self.search.on_the_side_of(at_height, normals, feet)
        return Look(feet.distance - self.radius, self.slope(q, xy, feet.normal), feet, xy)

    def slope(self, q: Floats, xy: Floats, normal: Floats) -> Floats:
        """Derivative of the deviations over q, (n, 3)."""
        arm = xy - self.pivot(q)
        turn = (normal[:, 1] * arm[:, 0] - normal[:, 0] * arm[:, 1]) / self.lever
        return np.column_stack([normal @ self.push(q), turn])

    def usable(self, look: Look) -> Bools:
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
        q, spread = self._descend(np.zeros(3), self.few)
        if spread > _GOOD:
            found = [self._descend(start, self.fewer) for start in self._starts()]
            other, wider = self._descend(min(found, key=lambda pair: pair[1])[0], self.few)
            if wider < 0.7 * spread:
                q = other
        look = self.look(q, self.few)
        far = float(np.mean(np.abs(self._off(look.xy, look.feet)) > REACH))
        if far > 0.5:
            raise FitError(
                phrase(
                    "{}: alignment: {:.0f} % of the points stay farther than {} from the profile; check unit, "
                    "work frame, {} and {}",
                    self.source,
                    100 * far,
                    mm(REACH, "g"),
                    option("points"),
                    option("nominal"),
                ),
            )
        return q

    def _descend(self, q: Floats, rows: Ints) -> tuple[Floats, float]:
        """Reweighted Gauss-Newton of some points from a start, with Tukey's biweight; pose and spread left, mm."""
        e = np.zeros(0)
        for _ in range(40):
            look = self.look(q, rows)
            e, slope = self._pulled(q, look)
            a = slope @ self.free
            cut = 4.685 * max(1.4826 * float(np.median(np.abs(e))), _COARSE_FLOOR)
            weight = _guarded(np.abs(e) / cut, 0.0, 1.0, a)
            values, vectors = np.linalg.eigh(a.T @ (weight[:, None] * a))
            seen = values > (VISIBLE / TRIAL) ** 2 * max(float(weight.sum()), 1e-9)
            right = vectors[:, seen].T @ (a.T @ (weight * e))
            step = -self.free @ (vectors[:, seen] @ (right / values[seen]))
            step /= max(1.0, float(np.hypot(*step[:2])) / 5.0, abs(float(step[2])) / self.lever / 0.1)
            q = q + step
            if np.abs(step).max() < 1e-4:
                break
        return q, float(np.quantile(np.abs(e - np.median(e)), 0.8))

    def _off(self, xy: Floats, feet: FootPoints) -> Floats:
        """Deviations, (n,) mm; of points beyond an open end, the distance from that end."""
        gap = np.hypot(*(xy - feet.foot).T)
        out: Floats = np.where(feet.place == Place.END, gap, feet.distance) - self.radius
        return out

    def _pulled(self, q: Floats, look: Look) -> tuple[Floats, Floats]:
        """Deviations and slopes in which points beyond an open end are drawn back to that end."""
        beyond = np.flatnonzero(look.feet.place == Place.END)
        if not len(beyond):
            return look.value, look.slope
        away = look.xy[beyond] - look.feet.foot[beyond]
        slope = look.slope.copy()
        slope[beyond] = self.slope(q, look.xy[beyond], away / np.maximum(np.hypot(*away.T), 1e-12)[:, None])
        return self._off(look.xy, look.feet), slope

    def _starts(self) -> list[Floats]:
        """The most promising of many turns and shifts."""
        angles = np.radians([0.0, -2.0, 2.0, -5.0, 5.0, -10.0, 10.0]) if self.free[2].any() else np.zeros(1)
        moves = np.array([0.0, -2.0, 2.0, -4.0, 4.0])
        xs = moves if self.free[0].any() else np.zeros(1)
        ys = moves if self.free[1].any() else np.zeros(1)
        poses = np.stack(np.meshgrid(xs, ys, angles * self.lever, indexing="ij"), axis=-1).reshape(-1, 3)
        xy = np.concatenate([self.transform(q).points(self.points[self.fewer]) for q in poses])
        feet = self.search.find(xy)
        score = np.quantile(np.abs(self._off(xy, feet)).reshape(len(poses), -1), 0.8, axis=1)
        return [poses[i] for i in np.argsort(score, kind="stable")[:6]]

    def determined(self, q: Floats) -> tuple[Floats, tuple[str, ...]]:
        """Basis (3, k) of the directions of q that the points determine, and the others in words.

        The eigenvectors of the normal matrix are tried one by one: the foot points, which lie on the profile, are
        moved along by `TRIAL` and more than twice as far, the other directions may compensate, and the deviations that
        are left must be seen (`VISIBLE`) and certain (`CERTAIN`), in proportion to the move. Finite moves see through
        the facets of a rounded profile, which a derivative takes for shape.
        """
        look = self.look(q, self.few)
        used = np.flatnonzero(self.usable(look))
        self.require(len(used))
        foot, value = look.feet.foot[used], look.value[used]
        noise = max(1.4826 * float(np.median(np.abs(value - np.median(value)))), FINEST)
        a = self.slope(q, foot, look.feet.normal[used]) @ self.free
        values, vectors = np.linalg.eigh(a.T @ a)
        heard = values > 1e-12 * len(used)
        share = len(self.points) / len(self.few)
        keep, words = [], []
        for i in range(vectors.shape[1]):
            others = a @ vectors[:, heard & (np.arange(len(heard)) != i)]
            direction = self.free @ vectors[:, i]
            change = min(
                self._change(q, foot, sign * move * direction, others) / move**2
                for move in (0.97 * TRIAL, 2.3 * TRIAL)
                for sign in (-1.0, 1.0)
            )
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

    def weights(self, look: Look, taking_part: Bools, basis: Floats) -> Floats:
        """Weight of each point: 1 up to the first limit of `OUTLIER`, then falling as Tukey's biweight to 0."""
        weight = taking_part.astype(np.float64)
        value = look.value[taking_part]
        # Few points do not tell which of them is wrong.
        if not self.robust or len(value) < 5 * self.free.shape[1]:
            return weight
        away = np.abs(value - np.median(value))
        scale = max(1.4826 * float(np.median(away)), FINEST)
        weight[taking_part] = _guarded(away / scale, *OUTLIER, look.slope[taking_part] @ basis)
        return weight

    def least_squares(self, q: Floats, basis: Floats) -> tuple[Floats, Look, Weights]:
        """Pose of the least sum of weighted squares.

        Raises
        ------
        InputError
            If too few points can be used.
        FitError
            If the steps do not become small.
        """
        weight, taking_part = np.zeros(len(self.points)), np.zeros(len(self.points), dtype=bool)
        fixed, size, idle = False, math.inf, 0
        look = self.look(q)
        for iteration in range(1, _ROUNDS + 1):
            if not fixed:
                taking_part = self.usable(look)
                self.require(int(taking_part.sum()))
                new = self.weights(look, taking_part, basis)
                settled = size < 1e-3 and np.abs(new - weight).max() < 1e-9
                fixed, weight = settled or iteration > _ROUNDS // 4, new
                self.require(int((weight > 0).sum()))
            a = look.slope @ basis
            fall = a.T @ (weight * look.value)
            try:
                step = np.asarray(-np.linalg.solve(a.T @ (weight[:, None] * a), fall), dtype=np.float64)
            except np.linalg.LinAlgError:
                raise FitError(
                    phrase("{}: alignment: the usable points do not determine the motion", self.source)
                ) from None
            before, size = size, float(np.abs(basis @ step).max(initial=0.0))
            if fixed and size < _CLOSE:
                return q, look, Weights(weight, taking_part, iteration)
            trial = self.look(q + basis @ step)
            if fixed:
                height = float(weight @ look.value**2)
                step, trial = self._downhill(q, basis, step, trial, height, weight, size > 0.5 * before)
                # A fall of the sum by this is a step of a thousandth of the standard uncertainty.
                fallen = height - float(weight @ trial.value**2)
                idle = idle + 1 if fallen < 1e-6 * height / float(weight.sum()) else 0
                if idle > 3:
                    return q, look, Weights(weight, taking_part, iteration)
            q, look = q + basis @ step, trial
        raise FitError(
            phrase("{}: alignment: no end after {} steps, the last one {}", self.source, _ROUNDS, mm(size, ".2g"))
        )

    def _downhill(
        self, q: Floats, basis: Floats, step: Floats, trial: Look, height: float, weight: Floats, slow: bool
    ) -> tuple[Floats, Look]:
        """Step made shorter until the sum of squares does not grow, or, where it goes slowly, longer while it falls.

        Between the facets of a coarse polygon a whole Gauss-Newton step may lead uphill, or no way at all.
        """
        reached = float(weight @ trial.value**2)
        for _ in range(12):
            if reached <= height * (1 + 1e-12):
                break
            step = step / 2
            trial = self.look(q + basis @ step)
            reached = float(weight @ trial.value**2)
        else:
            return np.zeros_like(step), self.look(q)
        while slow and reached < height and np.abs(step).max() < 1.0:
            longer = self.look(q + basis @ (2 * step))
            further = float(weight @ longer.value**2)
            if further >= reached:
                break
            step, trial, reached = 2 * step, longer, further
        return step, trial

    def minimum_zone(self, q: Floats, basis: Floats, inside: Bools) -> tuple[Floats, Look, int]:
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
            size = float(np.abs(z).max())
            if size < 100 * _CLOSE:
                return q + basis @ z, self.look(q + basis @ z), iteration
            trial = self.look(q + basis @ z, rows)
            reached = float(np.abs(trial.value).max())
            # Where several motions reach the same height, a step between them may cost a little curvature.
            if reached <= height - 0.1 * (height - expected) + 0.01 * size:
                q, look, height = q + basis @ z, trial, reached
            else:
                reach = size / 4
        raise FitError(phrase("{}: alignment: no minimum zone after {} steps", self.source, _ROUNDS))


def _guarded(away: Floats, low: float, high: float, slope: Floats) -> Floats:
    """Weights 1 up to `low`, falling as Tukey's biweight to 0 at `high`; wider where that would lose a direction.

    A short side may be all that holds a direction of the motion. Its few points look like outliers until the fit
    has come near; so the limits grow until every direction keeps half of what all points tell about it.
    """
    values, vectors = np.linalg.eigh(slope.T @ slope)
    seen = values > (VISIBLE / TRIAL) ** 2 * len(slope)
    a = slope @ (vectors[:, seen] / np.sqrt(values[seen]))
    for widening in 2.0 ** np.arange(40):
        over = np.clip((away / widening - low) / (high - low), 0.0, 1.0)
        weight: Floats = (1 - over**2) ** 2
        if not seen.any() or np.linalg.eigvalsh(a.T @ (weight[:, None] * a))[0] >= 0.5:
            return weight
    return np.ones(len(slope))


def _chebyshev_step(value: Floats, slope: Floats, reach: float) -> tuple[Floats, float]:
    """Step z, no component above `reach`, that makes max |value + slope z| least, and that maximum.

    A linear programme over the points that matter: solved for the largest ones, then again with the worst offenders
    added until no point exceeds the programme's own maximum. Where several steps reach it, the one with the least
    sum of squares is taken.
    """
    from scipy.optimize import linprog

    unit = float(np.abs(value).max())
    d, k = value / unit, slope.shape[1]
    cost = np.append(np.zeros(k), 1.0)
    bounds = [(-reach / unit, reach / unit)] * k + [(0.0, None)]
    chosen = np.zeros(len(d), dtype=bool)
    chosen[np.argsort(-np.abs(d), kind="stable")[:100]] = True
    while True:
        a, b = slope[chosen], d[chosen]
        ones = np.ones((len(b), 1))
        limit = np.concatenate([-b, b])
        found = linprog(cost, np.block([[a, -ones], [-a, -ones]]), limit, bounds=bounds, method="highs")
        if found.x is None:
            raise FitError(phrase("minimum zone: the linear programme failed: {}", found.message))
        left = np.abs(d + slope @ found.x[:k])
        if not _add_worst(chosen, left, float(left[chosen].max())):
            break
    height = float(left.max())
    z, tolerance = found.x[:k], 1e-9
    while True:
        a, b = np.vstack([slope[chosen], np.eye(k)]), np.append(d[chosen], np.zeros(k))
        limit = np.append(np.full(int(chosen.sum()), height + tolerance), np.full(k, reach / unit))
        nearest = _least_squares_within(slope, d, np.vstack([-a, a]), np.append(b - limit, -b - limit))
        if nearest is None:
            break
        left = np.abs(d + slope @ nearest)
        if left[chosen].max() > height + 10 * tolerance:
            break
        if not _add_worst(chosen, left, height + 10 * tolerance):
            z = nearest
            break
    return z * unit, height * unit


def _add_worst(chosen: Bools, left: Floats, height: float) -> bool:
    """Choose the points that exceed a height most, in place; False where none does."""
    excess = np.where(chosen, 0.0, left - height)
    worst = np.argsort(-excess, kind="stable")[:100]
    worst = worst[excess[worst] > 1e-10]
    chosen[worst] = True
    return bool(len(worst))


def _least_squares_within(slope: Floats, d: Floats, g: Floats, h: Floats) -> Floats | None:
    """The z of least |d + slope z| with ``g z >= h``, or None where there is none.

    Least distance programming by non-negative least squares (Lawson & Hanson 1974, ch. 23).
    """
    from scipy.optimize import nnls

    root = np.linalg.cholesky(slope.T @ slope / len(d)).T
    free = -np.linalg.lstsq(slope, d, rcond=None)[0]
    turned: Floats = np.linalg.solve(root.T, g.T)
    e = np.vstack([turned, h - (root @ free) @ turned])
    f = np.append(np.zeros(len(root)), 1.0)
    try:
        u, _ = nnls(e, f)
    except RuntimeError:
        return None
    r = e @ u - f
    if not -r[-1] > 1e-12:
        return None
    out: Floats = np.asarray(free + np.linalg.solve(root, -r[:-1] / r[-1]), dtype=np.float64)
    return out


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
