# SPDX-License-Identifier: LGPL-2.1-or-later
"""A simulated milling machine with known errors: cuts any program, lets the part be measured.

For trying settings before metal is cut, and for tests that need to know the truth. Along the nominal normal
n at arc length s, the surface it leaves is, in mm and positive for excess material::

    d(s) = e(s) + D(s) + (a - e(s)) MS(s) / (1 + MS(s)) + w(s) + r(s)

e
    Where the program puts the surface: the envelope of the cutter of radius R along its centre path, exact.
    It is the x for which the distance from ``C(s) + x n(s)`` to the path is R. Fillets that a round cutter
    leaves in concave corners are part of it.
D
    Determined error field: repeats on every part.
a, MS
    Stock allowance left before the finishing cut, and transfer function of the machining system
    (petrakov-2025, eqs. 3 and 4): of the commanded depth ``H = a - e`` the share ``MS / (1 + MS)`` stays.
w
    Loss of cutter radius by wear, so far.
r
    What does not repeat: a Gaussian process along s with standard deviation sigma_r, new for every part, with
    correlation ``exp(-(ds / noise_length)^2)``, so points farther apart than three lengths are independent.

A measured point is ``C(s) + (d(s) + ball radius + m) n(s)``, m white with standard deviation sigma_m. The
ball approaches along the nominal normal; its own filtering of narrow valleys is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from hashlib import sha256

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats, Ints
from millcorr.comparison.theoretical_contour import cutting_runs
from millcorr.errors import InputError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath
from millcorr.readers.measurement import Measurement

UNCUT = 5.0
"""Where the envelope is farther from the nominal than this, in mm, the program does not cut the profile."""

LEVEL = 1e-3
"""Moves whose heights differ by less than this, in mm, are one pass."""

REFERENCE_POLES = (
    (95.0, 40.0), (83.75, 54.75), (69.25, 61.75), (59.0, 67.25), (46.5, 71.75),
    (33.25, 68.75), (22.25, 59.75), (13.25, 48.0), (8.75, 31.0), (16.25, 15.25),
    (33.25, 11.25), (47.5, 16.25), (57.5, 17.75), (72.75, 14.75), (91.25, 21.75),
)  # fmt: skip
"""Control polygon of the reference contour in mm, 15 vertices as in werner-2018."""


def reference_contour(scale: float = 1.0) -> Profile:
    """Contour of the demonstration part.

    Parameters
    ----------
    scale : float
        1 for a contour 223.98 mm long whose radius of curvature is at least 15.3 mm on convex and 30.4 mm on
        concave stretches; these lengths grow with the scale.

    Returns
    -------
    Profile
        One closed, periodic, cubic B-spline of 15 control vertices, anticlockwise, material inside.
    """
    poles = np.array(REFERENCE_POLES) * scale
    n = len(poles)
    curve = NurbsCurve(3, poles, np.ones(n), np.arange(n + 1.0), np.ones(n + 1, dtype=np.int64), periodic=True)
    return Profile.from_contours([Contour((curve,), True)])


@dataclass(frozen=True, slots=True)
class ErrorField:
    """Errors that repeat on every part, positive where material is left; all of them add up.

    Parameters
    ----------
    constant : float
        mm.
    harmonics : tuple of (k, A, phi)
        ``A cos(2 pi k s / L + phi)`` along a contour of length L; A in mm, phi in rad.
    directional : tuple of (m, A, phi)
        ``A cos(m theta + phi)`` over the direction theta of the nominal normal: m = 1 is a displacement of
        the part (heat, zero point), m = 2 a scale or squareness error of the axes.
    backlash : (bx, by)
        Lost motion in mm of each axis: half of it is left where the normal points along +axis and taken
        where it points along -axis.
    table : tuple of (s, value)
        mm over arc length in mm, straight between entries, round the seam of a closed contour.
    function : callable, optional
        ``f(s, normal)`` in mm, for arc lengths (n,) and normals (n, 2).
    """

    constant: float = 0.0
    harmonics: tuple[tuple[int, float, float], ...] = ()
    directional: tuple[tuple[int, float, float], ...] = ()
    backlash: tuple[float, float] = (0.0, 0.0)
    table: tuple[tuple[float, float], ...] = ()
    function: Callable[[Floats, Floats], Floats] | None = None

    def __call__(self, s: Floats, normal: Floats, length: float, closed: bool) -> Floats:
        """Error in mm at arc lengths s (n,) of a contour of the given length, with normals (n, 2)."""
        out = np.full(len(s), float(self.constant))
        for k, amplitude, phase in self.harmonics:
            out += amplitude * np.cos(2 * np.pi * k * s / length + phase)
        theta = np.arctan2(normal[:, 1], normal[:, 0])
        for m, amplitude, phase in self.directional:
            out += amplitude * np.cos(m * theta + phase)
        for axis in (0, 1):
            if self.backlash[axis]:
                out += 0.5 * self.backlash[axis] * np.sign(normal[:, axis])
        if self.table:
            at, value = np.array(sorted(self.table), dtype=float).T
            out += np.interp(s, at, value, period=length if closed else None)
        if self.function is not None:
            out += self.function(s, normal)
        return out

    def describe(self) -> str:
        """The error field in words, amplitudes in micrometres."""
        words = [f"constant {_um(self.constant)}"] if self.constant else []
        words += [f"wave {k} of {_um(a)} along the contour" for k, a, _ in self.harmonics]
        words += [f"wave {m} of {_um(a)} over the direction of the normal" for m, a, _ in self.directional]
        words += [f"backlash {n} {_um(b)}" for n, b in zip("XY", self.backlash, strict=True) if b]
        if self.table:
            words.append(f"a table of {len(self.table)} values")
        if self.function is not None:
            words.append("a function of place and normal")
        return ", ".join(words) or "none"


@dataclass(frozen=True, slots=True)
class SimulatedMachine:
    """A machine with known errors; cut parts with `cut` or `follow`.

    Parameters
    ----------
    errors : ErrorField
        Determined errors.
    allowance : float or callable
        Stock in mm left on the nominal contour before the finishing cut, one number or ``a(s)`` over arc lengths (n,)
        in mm, as the surface that a first cut has left. To cut at another depth: ``replace(machine, allowance=...)``.
    transfer : float or callable
        Transfer function MS, one number or ``MS(s)`` over arc lengths (n,) in mm.
    wear_per_metre, wear_per_part : float
        Cutter radius lost, in mm, for every metre of cutting moves (grows along the contour) and for every
        part (steps between parts).
    process_noise : float
        sigma_r in mm.
    noise_length : float
        Correlation length of the process noise in mm.
    measurement_noise : float
        sigma_m in mm.

    Raises
    ------
    UsageError
        If a number is negative or not finite, or `noise_length` or 1 + MS is not positive.
    """

    errors: ErrorField = field(default_factory=ErrorField)
    allowance: float | Callable[[Floats], Floats] = 0.0
    transfer: float | Callable[[Floats], Floats] = 0.0
    wear_per_metre: float = 0.0
    wear_per_part: float = 0.0
    process_noise: float = 0.0
    noise_length: float = 0.1
    measurement_noise: float = 0.0

    def __post_init__(self) -> None:
        for name in ("wear_per_metre", "wear_per_part", "process_noise", "measurement_noise"):
            value = getattr(self, name)
            if not (np.isfinite(value) and value >= 0):
                raise UsageError(f"simulated machine: {name} {value!r} is not a number of at least 0")
        if not (np.isfinite(self.noise_length) and self.noise_length > 0):
            raise UsageError(f"simulated machine: noise_length {self.noise_length!r} is not positive")
        if not callable(self.allowance) and not np.isfinite(self.allowance):
            raise UsageError(f"simulated machine: allowance {self.allowance!r} is not a number")
        if not callable(self.transfer) and not (np.isfinite(self.transfer) and self.transfer > -1):
            raise UsageError(f"simulated machine: transfer function {self.transfer!r} is not above -1")

    @staticmethod
    def reference() -> SimulatedMachine:
        """The machine of the demonstration, after the "before correction" column of werner-2018.

        Measured with 200 points, a part cut along the exact path shows mean 10.4, height about 14 and
        standard deviation about 2.7 um:

        - mean ``0.3 * 0.03 / 1.03 + 0.00166 = 0.0104`` mm, elastic response to the paper's allowance of
          0.3 mm and a constant;
        - determined waves of 2.3 um standard deviation, the root of half the sum of squared amplitudes;
        - standard deviation ``sqrt(2.3^2 + 0.5^2 + 1.2^2) = 2.64`` um with sigma_r = 0.5, sigma_m = 1.2 um.

        One correction at full gain leaves a mean of ``0.0104 * 0.03 / 1.03 + 0.0015 = 0.0018`` mm, the wear
        of one part included, and on the true surface a standard deviation of ``sqrt(2 sr^2 + sm^2)`` = 1.39
        um from raw data, ``sqrt(sr^2 + 0.2 (sr^2 + sm^2)) = 0.77`` um through a mean of 5, and never less
        than sr = 0.5 um. A first program that errs adds its elastic share: 0.03 / 1.03 of an error of 9.6 um,
        as of FreeCAD's arcs along this contour, makes 0.77 um into 0.82.
        """
        return SimulatedMachine(
            errors=ErrorField(
                constant=0.0016621,
                harmonics=((1, 0.0022, 3.3), (2, 0.0018, 3.0), (3, 0.0013, 1.3), (5, 0.0008, 2.4)),
            ),
            allowance=0.3,
            transfer=0.03,
            wear_per_part=0.0015,
            process_noise=0.0005,
            measurement_noise=0.0012,
        )

    def cut(
        self,
        toolpath: Toolpath,
        radius: float,
        nominal: Profile,
        *,
        z: float | None = None,
        cutter_compensation: str = "contour",
        worn: float = 0.0,
        seed: int | None = None,
    ) -> SimulatedPart:
        """Cut a part with a program.

        Parameters
        ----------
        toolpath : Toolpath
            Only feed moves cut; the side follows from where they lie, or from G41 and G42.
        radius : float
            Tool radius in mm.
        nominal : Profile
            What the part should be.
        z : float, optional
            Height in mm at which the part is looked at: moves with the tip at or below it cut. By default the
            lowest pass.
        cutter_compensation : {"contour", "wear"}
            With G41 or G42, whether the program gives the contour (the control does the offset) or already
            the centre path.
        worn : float
            Cutter radius already lost, in mm: `SimulatedPart.worn` of the part before.
        seed : int, optional
            Seed of the process noise; by default a new one, kept in `SimulatedPart.seed`.

        Returns
        -------
        SimulatedPart

        Raises
        ------
        InputError
            If nothing is cut, or the control could not do the offset.
        UsageError
            If an argument has no such value.
        """
        if not (np.isfinite(radius) and radius > 0):
            raise UsageError(f"simulated machine: tool radius {radius!r} mm is not positive")
        if cutter_compensation not in ("contour", "wear"):
            raise UsageError(f"cutter compensation is contour or wear, not {cutter_compensation!r}")
        envelope = _Envelope.of(toolpath, radius, nominal, z, cutter_compensation == "contour")
        return SimulatedPart(self, nominal, envelope, envelope.total, worn, _seed(seed))

    def follow(
        self,
        nominal: Profile,
        shift: Callable[[int, Floats], Floats] | None = None,
        *,
        worn: float = 0.0,
        seed: int | None = None,
    ) -> SimulatedPart:
        """Cut a part along the ideal path of a contour, without a program.

        Parameters
        ----------
        nominal : Profile
        shift : callable, optional
            ``e(contour, s)`` in mm: how far outside the nominal the path is meant to put the surface, that is
            the correction; 0 by default.
        worn, seed
            As in `cut`.
        """
        commanded = _Shift(nominal, shift)
        return SimulatedPart(self, nominal, commanded, float(nominal.total.sum()), worn, _seed(seed))

    def transfer_at(self, s: Floats) -> Floats:
        """MS at arc lengths (n,)."""
        return _along(self.transfer, s)

    def allowance_at(self, s: Floats) -> Floats:
        """Stock over the nominal at arc lengths (n,), mm."""
        return _along(self.allowance, s)

    def describe(self) -> str:
        """The machine's errors in words."""
        ms = "a function of place" if callable(self.transfer) else f"{self.transfer:g}"
        stock = "that is a function of place" if callable(self.allowance) else f"of {self.allowance:g} mm"
        return (
            f"determined errors: {self.errors.describe()}; elastic response: transfer function {ms} at an "
            f"allowance {stock}; wear {_um(self.wear_per_metre)} a metre and "
            f"{_um(self.wear_per_part)} a part; process noise {_um(self.process_noise)} over "
            f"{self.noise_length:g} mm; measurement noise {_um(self.measurement_noise)}"
        )


Commanded = Callable[[int, Floats], tuple[Floats, Floats]]
"""Offset of the commanded surface and metres cut before, both (n,), at arc lengths of a contour."""


@dataclass(frozen=True, eq=False, slots=True)
class SimulatedPart:
    """A part that `SimulatedMachine` cut; its true surface is known.

    Parameters
    ----------
    machine : SimulatedMachine
    nominal : Profile
    commanded : callable
        ``(contour, s) -> (e, cut)``: offset e in mm of the commanded surface, and mm cut before reaching it.
    cut_length : float
        Length of all cutting moves, mm.
    worn_before : float
        Cutter radius lost before this part, mm.
    seed : int
        Seed of the process noise.
    """

    machine: SimulatedMachine
    nominal: Profile
    commanded: Commanded
    cut_length: float
    worn_before: float
    seed: int

    @property
    def worn(self) -> float:
        """Cutter radius lost after this part, in mm; give it to the next `SimulatedMachine.cut`."""
        m = self.machine
        return self.worn_before + m.wear_per_part + m.wear_per_metre * self.cut_length / 1000.0

    def determined(self, contour: int, s: ArrayLike) -> Floats:
        """Deviation without the process noise, in mm: what a part cut the same way would repeat; (n,).

        Raises
        ------
        InputError
            If the program does not cut the profile there.
        """
        m = self.machine
        s = np.atleast_1d(np.asarray(s, dtype=float))
        _, normal = self.nominal.at(contour, s)
        e, before = self.commanded(contour, s)
        length = float(self.nominal.total[contour])
        ms = m.transfer_at(s)
        left = (m.allowance_at(s) - e) * ms / (1.0 + ms)
        wear = self.worn_before + m.wear_per_metre * before / 1000.0
        out: Floats = e + m.errors(s, normal, length, self.nominal.contours[contour].closed) + left + wear
        return out

    def deviation(self, contour: int, s: ArrayLike) -> Floats:
        """Deviation of the true surface in mm along the nominal normal.

        Parameters
        ----------
        contour : int
            Contour of the nominal profile.
        s : (n,)
            Arc lengths in mm from the contour's start.

        Returns
        -------
        (n,) float64
            Positive for excess material; the same place always gives the same value.

        Raises
        ------
        InputError
            If the program does not cut the profile there.
        """
        s = np.atleast_1d(np.asarray(s, dtype=float))
        return self.determined(contour, s) + self._noise(contour, s)

    def measure(
        self,
        count: int = 200,
        *,
        points: str = "contact",
        ball_radius: float = 1.0,
        s: ArrayLike | None = None,
        contour: int | None = None,
        z: float | Sequence[float] = 0.0,
        order: str = "along",
        normals: bool = False,
        noise: float | None = None,
        seed: int | None = None,
    ) -> Measurement:
        """Measure the part.

        Parameters
        ----------
        count : int
            Points for each height, spread evenly along the contours.
        points : {"contact", "centre"}
            What is reported: contact points or centres of the ball.
        ball_radius : float
            Radius of the probe ball in mm; matters for centres only.
        s : (n,), optional
            Arc lengths to measure instead; `contour` then is 0 unless stated.
        contour : int, optional
            Only this contour; by default all.
        z : float or sequence of float
            Heights in mm.
        order : {"along", "reversed", "shuffled"}
        normals : bool
            Whether the measurement carries the nominal normals.
        noise : float, optional
            sigma_m in mm in place of the machine's.
        seed : int, optional
            Seed of the measurement noise and of the shuffling; by default a new one.

        Returns
        -------
        Measurement

        Raises
        ------
        UsageError
            If an argument has no such value.
        InputError
            If the program does not cut the profile at a point.
        """
        if points not in ("contact", "centre"):
            raise UsageError(f"points are contact or centre, not {points!r}")
        if order not in ("along", "reversed", "shuffled"):
            raise UsageError(f"order is along, reversed or shuffled, not {order!r}")
        if points == "centre" and not ball_radius > 0:
            raise UsageError(f"ball radius {ball_radius!r} mm is not positive")
        owner, at = self._places(count, s, contour)
        heights = np.atleast_1d(np.asarray(z, dtype=float))
        deviation, nominal, normal = np.empty(len(at)), np.empty((len(at), 2)), np.empty((len(at), 2))
        for k in np.unique(owner):
            rows = owner == k
            deviation[rows] = self.deviation(int(k), at[rows])
            nominal[rows], normal[rows] = self.nominal.at(int(k), at[rows])
        seed = _seed(seed)
        rng = np.random.default_rng([seed, 2])
        sigma = self.machine.measurement_noise if noise is None else noise
        radius = ball_radius if points == "centre" else 0.0
        n = len(at)
        reach = np.tile(deviation, len(heights)) + radius + sigma * rng.standard_normal(n * len(heights))
        xyz = np.empty((n * len(heights), 3))
        xyz[:, :2] = np.tile(nominal, (len(heights), 1)) + reach[:, None] * np.tile(normal, (len(heights), 1))
        xyz[:, 2] = np.repeat(heights, n)
        ijk = np.zeros_like(xyz)
        ijk[:, :2] = np.tile(normal, (len(heights), 1))
        turn = np.arange(len(xyz))
        if order == "reversed":
            turn = turn[::-1]
        elif order == "shuffled":
            turn = rng.permutation(len(xyz))
        xyz, ijk = xyz[turn].copy(), ijk[turn].copy()
        return Measurement(
            xyz,
            ijk if normals else None,
            radius,
            np.arange(1, len(xyz) + 1, dtype=np.int64),
            f"simulated part (seed {self.seed}, measured with seed {seed})",
            sha256(xyz.tobytes()).hexdigest(),
        )

    def describe(self) -> str:
        """Plain statement that the part is simulated, and with which errors."""
        return (
            f"SIMULATED part, no metal was cut (seed {self.seed}, cutter worn by {_um(self.worn_before)} "
            f"before): {self.machine.describe()}"
        )

    def _places(self, count: int, s: ArrayLike | None, contour: int | None) -> tuple[Ints, Floats]:
        if s is not None:
            at = np.atleast_1d(np.asarray(s, dtype=float))
            return np.full(len(at), contour or 0, dtype=np.int64), at
        if count < 1:
            raise UsageError(f"{count} points cannot be measured")
        total = self.nominal.total
        chosen = np.arange(len(total)) if contour is None else np.array([contour])
        end = np.cumsum(total[chosen])
        along = (np.arange(count) + 0.5) / count * end[-1]
        which = np.searchsorted(end, along, side="right")
        owner: Ints = chosen[which].astype(np.int64)
        return owner, along - (end - total[chosen])[which]

    def _noise(self, contour: int, s: Floats) -> Floats:
        """Process noise: white noise on a fine grid, smoothed by a Gaussian, scaled back to sigma_r."""
        sigma, width = self.machine.process_noise, self.machine.noise_length
        if sigma == 0.0:
            return np.zeros(len(s))
        from scipy.interpolate import CubicSpline

        total = float(self.nominal.total[contour])
        closed = self.nominal.contours[contour].closed
        period = total if closed else total + 8 * width
        n = max(16, int(np.ceil(5 * period / width)))
        white = np.random.default_rng([self.seed, 1, contour]).standard_normal(n)
        frequency = np.fft.rfftfreq(n, period / n)
        # exp(-(x/l)^2) has the spectrum exp(-(pi f l)^2); the filter is its root.
        response = np.exp(-0.5 * (np.pi * frequency * width) ** 2)
        power = (np.abs(np.concatenate([response, response[1 : (n + 1) // 2]])) ** 2).sum() / n
        grid = np.fft.irfft(np.fft.rfft(white) * response, n) * (sigma / np.sqrt(power))
        spline = CubicSpline(np.arange(n + 1) * (period / n), np.append(grid, grid[0]), bc_type="periodic")
        out: Floats = spline(np.mod(s, period))
        return out


@dataclass(frozen=True, eq=False, slots=True)
class _Shift:
    """Commanded surface given as a shift of the nominal."""

    nominal: Profile
    shift: Callable[[int, Floats], Floats] | None

    def __call__(self, contour: int, s: Floats) -> tuple[Floats, Floats]:
        e = np.zeros(len(s)) if self.shift is None else np.asarray(self.shift(contour, s), dtype=float)
        return e, s + float(self.nominal.total[:contour].sum())


@dataclass(frozen=True, eq=False, slots=True)
class _Envelope:
    """Commanded surface as the envelope of a cutter along its centre path."""

    nominal: Profile
    path: Profile
    search: FootPointSearch
    radius: float
    before: Floats
    """Length of cutting moves before each contour of the path, mm."""
    total: float

    @staticmethod
    def of(toolpath: Toolpath, radius: float, nominal: Profile, z: float | None, offset: bool) -> _Envelope:
        length = np.where(toolpath.kind == Kind.RAPID, 0.0, np.nan_to_num(toolpath.length()))
        cut = np.concatenate([[0.0], np.cumsum(length)])
        tip = np.fmax(toolpath.start[:, 2], toolpath.end[:, 2])
        contours, before = [], []
        runs = cutting_runs(toolpath)
        if z is None:
            used = tip[np.concatenate(runs)] if runs else tip[:0]
            z = float(used[np.isfinite(used)].min(initial=np.inf))
        # A height that the program never states counts as deep enough.
        high = tip > z + LEVEL
        for run in runs:
            for rows in np.split(run, np.flatnonzero(np.diff(high[run])) + 1):
                if high[rows[0]]:
                    continue
                side = int(toolpath.compensation[rows[0]])
                i = int(rows[0])
                start = rows
                previous = int(toolpath.compensation[i - 1]) if i else int(Compensation.OFF)
                if offset and previous != side:
                    # During its first move with G41 or G42 the control comes up to the contour, during the
                    # first one with G40 it leaves: neither is a cut along it.
                    start = rows[1:]
                if not len(start):
                    continue
                if offset and side != Compensation.OFF:
                    curves = _offset_by_control(toolpath, start, radius * side)
                else:
                    curves = _centre_path(toolpath, start)
                if curves:
                    contours.append(Contour(tuple(curves), False))
                    before.append(float(cut[start[0]]))
        if not contours:
            raise InputError("simulated machine: the program has no cutting move in the XY plane")
        path = Profile.from_contours(contours)
        search = FootPointSearch(path, margin=2.0 * radius)
        return _Envelope(nominal, path, search, radius, np.array(before), float(cut[-1]))

    def __call__(self, contour: int, s: Floats) -> tuple[Floats, Floats]:
        point, normal = self.nominal.at(contour, s)
        x = np.zeros(len(s))
        before = np.zeros(len(s))
        rows = np.arange(len(s))
        for _ in range(200):
            q = point[rows] + x[rows, None] * normal[rows]
            feet = self.search.find(q)
            away = q - feet.foot
            distance = np.hypot(*away.T)
            gap = distance - self.radius
            before[rows] = self.before[self.path.contour[feet.span]]
            before[rows] += self.path.arc_length(feet.span, feet.t)
            # A step as long as the gap cannot pass the envelope; near it Newton's step is the shorter way.
            slope = -(away * normal[rows]).sum(axis=1) / np.maximum(distance, 1e-12)
            step = np.where((slope > 0.5) & (np.abs(gap) < 0.1), gap / np.maximum(slope, 0.5), gap)
            x[rows] += step
            far = np.abs(x[rows]) > UNCUT
            if far.any():
                i = rows[np.flatnonzero(far)[0]]
                raise InputError(
                    f"simulated machine: the program does not cut the profile near X{point[i, 0]:.3f} "
                    f"Y{point[i, 1]:.3f}"
                )
            rows = rows[np.abs(step) > 1e-12]
            if not len(rows):
                break
        return x, before


def _centre_path(toolpath: Toolpath, rows: Ints) -> list[NurbsCurve]:
    """Curves of connected moves as programmed; straight moves in a row become one polyline."""
    curves: list[NurbsCurve] = []
    kinds = toolpath.kind[rows]
    for part in np.split(rows, np.flatnonzero(np.diff(kinds == Kind.LINE)) + 1):
        if toolpath.kind[part[0]] == Kind.LINE:
            points = np.vstack([toolpath.start[part[:1], :2], toolpath.end[part, :2]])
            curves += _polyline(points)
            continue
        for i in part:
            a, b = toolpath.start[i, :2], toolpath.end[i, :2]
            if toolpath.kind[i] == Kind.CUBIC:
                poles = np.array([a, toolpath.control[i, :2], toolpath.control[i, 2:], b])
                curves.append(NurbsCurve(3, poles, np.ones(4), np.array([0.0, 1.0]), np.array([4, 4])))
            elif toolpath.plane[i] == Plane.XY:
                curves.append(_arc(a, b, toolpath.centre[i, :2], float(toolpath.sweep[i])))
    return curves


def _polyline(points: Floats) -> list[NurbsCurve]:
    kept = np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 1e-9])
    points = points[kept]
    n = len(points)
    if n < 2:
        return []
    mult = np.ones(n, dtype=np.int64)
    mult[[0, -1]] = 2
    return [NurbsCurve(1, points, np.ones(n), np.arange(float(n)), mult)]


def _arc(start: Floats, end: Floats, centre: Floats, sweep: float) -> NurbsCurve:
    """Arc whose radius goes evenly from the start's to the end's, as programs round them."""
    sweep = float(np.clip(sweep, -2 * np.pi, 2 * np.pi))
    curve = NurbsCurve.arc(start, end, centre, sweep)
    r0, r1 = float(np.hypot(*(start - centre))), float(np.hypot(*(end - centre)))
    if r0 == r1:
        return curve
    grow = 1.0 + (r1 / r0 - 1.0) * np.linspace(0.0, 1.0, len(curve.poles))
    poles = centre + (curve.poles - centre) * grow[:, None]
    poles[-1] = end
    return NurbsCurve(2, poles, curve.weights, curve.knots, curve.multiplicities)


@dataclass(slots=True)
class _Side:
    """An offset line or arc while it is trimmed: from angle or position u = `low` to `high` of 0..1."""

    start: Floats
    end: Floats
    centre: Floats | None
    sweep: float
    low: float = 0.0
    high: float = 1.0

    def at(self, u: float) -> tuple[Floats, Floats]:
        if self.centre is None:
            return self.start + u * (self.end - self.start), self.end - self.start
        x, y = self.start - self.centre
        c, s = np.cos(u * self.sweep), np.sin(u * self.sweep)
        arm = np.array([c * x - s * y, s * x + c * y])
        return self.centre + arm, self.sweep * np.array([-arm[1], arm[0]])

    def curve(self) -> NurbsCurve:
        a, b = self.at(self.low)[0], self.at(self.high)[0]
        if self.centre is None:
            return NurbsCurve.line(a, b)
        return NurbsCurve.arc(a, b, self.centre, self.sweep * (self.high - self.low))


def _offset_by_control(toolpath: Toolpath, rows: Ints, offset: float) -> list[NurbsCurve]:
    """Centre path that a control makes of a programmed contour; `offset` is positive to the left.

    Outer corners are rounded about their vertex, inner ones cut where the neighbours' offsets meet.
    """
    sides: list[_Side] = []
    vertices: list[Floats] = []
    for i in rows:
        a, b = toolpath.start[i, :2], toolpath.end[i, :2]
        kind = toolpath.kind[i]
        if kind == Kind.CUBIC:
            raise InputError("simulated machine: a control cannot offset a spline move (G5) with G41 or G42")
        centre = toolpath.centre[i, :2] if kind == Kind.ARC else None
        piece = _Side(a, b, centre, float(toolpath.sweep[i]))
        if centre is not None and np.hypot(*(a - centre)) <= offset * np.sign(piece.sweep):
            raise InputError(
                f"simulated machine: the control would stop at the arc about X{centre[0]:.3f} "
                f"Y{centre[1]:.3f}: its radius is not larger than the tool's {abs(offset):g} mm"
            )
        moved = []
        for u in (0.0, 1.0):
            p, d = piece.at(u)
            moved.append((b if u else a) + offset * np.array([-d[1], d[0]]) / np.hypot(*d))
        sides.append(_Side(moved[0], moved[1], centre, piece.sweep))
        vertices.append(b)
    count = len(sides)
    loop = count > 1 and np.hypot(*(toolpath.end[rows[-1], :2] - toolpath.start[rows[0], :2])) < 1e-3
    joints: dict[int, NurbsCurve] = {}
    for n in range(count if loop else count - 1):
        first, second = sides[n], sides[(n + 1) % count]
        d0, d1 = first.at(1.0)[1], second.at(0.0)[1]
        turn = float(np.arctan2(d0[0] * d1[1] - d0[1] * d1[0], d0 @ d1))
        if abs(turn) < 1e-7:
            continue
        if turn * offset > 0:
            if not _meet(first, second):
                x, y = vertices[n]
                raise InputError(f"simulated machine: the control finds no way into the corner at X{x:.3f} Y{y:.3f}")
        else:
            joints[n] = NurbsCurve.arc(first.end, second.start, vertices[n], turn)
    curves: list[NurbsCurve] = []
    for n, side in enumerate(sides):
        if side.high - side.low <= 0:
            x, y = vertices[n]
            raise InputError(
                f"simulated machine: the control would stop near X{x:.3f} Y{y:.3f}: the contour is narrower "
                "than the tool"
            )
        curves.append(side.curve())
        if n in joints:
            curves.append(joints[n])
    return curves


def _meet(first: _Side, second: _Side) -> bool:
    """Trim the end of one side and the start of the next to where they meet (Newton from the ends)."""
    u, v = 1.0, 0.0
    for _ in range(50):
        p, dp = first.at(u)
        q, dq = second.at(v)
        gap = p - q
        if np.hypot(*gap) < 1e-13:
            break
        det = dp[1] * dq[0] - dp[0] * dq[1]
        if det == 0.0:
            return False
        u += (gap[0] * dq[1] - gap[1] * dq[0]) / det
        v += (gap[0] * dp[1] - gap[1] * dp[0]) / det
    if np.hypot(*(first.at(u)[0] - second.at(v)[0])) > 1e-9:
        return False
    first.high, second.low = u, v
    return True


def _along(value: float | Callable[[Floats], Floats], s: Floats) -> Floats:
    """A number or a function of arc length at arc lengths (n,)."""
    return np.broadcast_to(np.asarray(value(s) if callable(value) else value, dtype=float), s.shape)


def _seed(seed: int | None) -> int:
    if seed is None:
        return int(np.random.SeedSequence().generate_state(1)[0])
    if seed < 0:
        raise UsageError(f"seed {seed} is negative")
    return int(seed)


def _um(value: float) -> str:
    return f"{value * 1000:.4g} um"
