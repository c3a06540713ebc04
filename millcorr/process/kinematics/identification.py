# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constants of a machine from a logged trace of a known program."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats
from millcorr.errors import FitError, UsageError
from millcorr.nc.toolpath import Toolpath

from .control import SHORTEST, AxisDynamics, ContourControl, Control
from .motion import response_between
from .schedule import Halts, schedule
from .trace import Trace

LARGEST_UNCERTAINTY = 0.1
"""A constant whose standard uncertainty is a larger share of it is not determined."""
CONSTANTS = ("time", "kv", *(f"{a}.{c}" for a in "xyz" for c in ("time", "kv")), "contour.speed_change", "contour.time")
LONGEST = 1000
"""A program with more moves is no test program."""
_AXES = "xyz"
_EXPLAINED = 0.5
"""The model must bring the residual below this share of what an ideal machine leaves."""
_CERTAIN = 0.1
"""A fit that leaves less than this share needs no second start."""
_FIRST_GUESS = 0.02
_STARTS = (1.0, 0.4, 2.5)
_OFFSETS = 160
_FINER = 20
_SCAN_POINTS = 300


@dataclass(frozen=True, slots=True)
class Constant:
    """An identified constant: its value and its standard uncertainty, in the units of `Control`."""

    value: float
    uncertainty: float


@dataclass(frozen=True, slots=True)
class Identification:
    """What a trace says of a machine.

    Parameters
    ----------
    control : Control
        The control asked about, with the identified constants.
    constants : dict of str to Constant
        By name. The uncertainty comes from the scatter of the residuals, wider where neighbouring residuals are
        alike (the model is then not all that is there); it is no statement on the model itself.
    start : float
        Time of the trace in s at which the program began.
    residual : float
        Robust standard deviation of trace minus model, in mm (positions) or mm/s (feed).
    """

    control: Control
    constants: dict[str, Constant]
    start: float
    residual: float


def identify(
    trace: Trace,
    toolpath: Toolpath,
    control: Control,
    fit: Sequence[str],
    *,
    halts: Halts | None = None,
    largest: float = LARGEST_UNCERTAINTY,
    called: Mapping[str, str] | None = None,
) -> Identification:
    """Fit constants of a control to a trace, by robust least squares on the exact model.

    The time at which the program began is fitted along. Positions count where they were logged, else the feed.

    Parameters
    ----------
    trace : Trace
        In the work frame of the program.
    toolpath : Toolpath
        What the machine ran; a short test program.
    control : Control
        Shape of acc/dec, constants that are known, and first guesses of the others.
    fit : sequence of str
        From `CONSTANTS`: "time" and "kv" for all axes alike, "x.time" and so on for one; "contour.speed_change";
        "contour.time", the accuracy-maintenance time at the one feed of the program (see `maintenance_regression`).
    halts : Halts, optional
    largest : float
        Largest standard uncertainty of a constant, as a share of it.
    called : mapping of str to str, optional
        What the user calls a constant, where that is not its name.

    Returns
    -------
    Identification

    Raises
    ------
    UsageError
        If a constant is unknown, or cannot be told from another by any trace, or the program has more than
        `LONGEST` moves.
    FitError
        If the trace does not determine the constants, or is not one of this program.
    """
    _check(control, fit)
    if len(toolpath) > LONGEST:
        raise UsageError(f"{trace.source}: {len(toolpath)} moves are no test program: log one of {LONGEST} at most")
    search = _Search(trace, toolpath, control, tuple(fit), halts, called or {})
    ideal = search.ideal()
    found, cost = None, math.inf
    for factor in _STARTS:
        progress.step()
        result = search.fitted(factor)
        if result[1] < cost:
            found, cost = result[0], result[1]
        if cost < _CERTAIN * ideal:
            break
    assert found is not None
    return search.judged(found, ideal, largest)


def _check(control: Control, fit: Sequence[str]) -> None:
    if not fit or len(set(fit)) < len(fit):
        raise UsageError("name each constant to identify once")
    for name in fit:
        if name not in CONSTANTS:
            raise UsageError(f"{name!r} is no constant to identify: {', '.join(CONSTANTS)}")
        if name.startswith("contour.") and control.contour is None:
            raise UsageError(f"{name} needs a control with contour control")
        if name[0] in _AXES and name[1:2] == "." and name[2:] in fit:
            raise UsageError(f"{name} and {name.split('.')[1]} are the same constant: name one")
    for axis, dynamics in zip(_AXES, control.axes, strict=True):
        both = all(c in fit or f"{axis}.{c}" in fit for c in ("time", "kv"))
        if both and dynamics.shape == "exponential":
            raise UsageError(
                "exponential acc/dec and servo are two lags that no trace tells apart: state kv and identify time"
            )


def with_constant(control: Control, name: str, value: float) -> Control:
    """Control with one of `CONSTANTS` changed; "contour.time" makes it the same at all feeds."""
    if name.startswith("contour."):
        contour = control.contour
        assert isinstance(contour, ContourControl)
        if name == "contour.time":
            return replace(control, contour=replace(contour, slope=0.0, intercept=value))
        return replace(control, contour=replace(contour, speed_change=value))
    axes, _, field = name.rpartition(".")
    changed: dict[str, AxisDynamics] = {}
    for axis in axes or _AXES:
        dynamics: AxisDynamics = getattr(control, axis)
        changed[axis] = replace(dynamics, time=value) if field == "time" else replace(dynamics, kv=value)
    return replace(control, x=changed.get("x", control.x), y=changed.get("y", control.y), z=changed.get("z", control.z))


def _constant(control: Control, name: str) -> float:
    """First guess of a constant."""
    if name.startswith("contour."):
        assert control.contour is not None
        return control.contour.intercept if name == "contour.time" else control.contour.speed_change
    axes, _, field = name.rpartition(".")
    dynamics: AxisDynamics = getattr(control, axes or "x")
    if field == "time":
        return dynamics.time or _FIRST_GUESS
    return dynamics.kv if math.isfinite(dynamics.kv) else 1.0 / _FIRST_GUESS


class _Search:
    """Residuals of one trace, and the fit to them; parameters are the start and logarithms of the constants."""

    def __init__(
        self,
        trace: Trace,
        toolpath: Toolpath,
        control: Control,
        fit: tuple[str, ...],
        halts: Halts | None,
        called: Mapping[str, str],
    ) -> None:
        self.called = called
        self.trace, self.toolpath, self.control, self.fit, self.halts = trace, toolpath, control, fit, halts
        self.axes = np.flatnonzero(np.isfinite(trace.position).all(axis=0))
        self.guess = np.log([_constant(control, name) for name in fit])

    def with_logs(self, logs: Floats) -> Control:
        control = self.control
        for name, value in zip(self.fit, np.exp(logs).tolist(), strict=True):
            control = with_constant(control, name, value)
        return control

    def answer(self, control: Control, rows: slice = slice(None)) -> Callable[[float], Floats]:
        """Residuals as a function of the start."""
        plan = schedule(self.toolpath, control, self.halts, self.trace.source)
        response = response_between(plan, 0.0, plan.duration)
        trace, axes = self.trace, self.axes

        def residuals(start: float) -> Floats:
            position, speed = response.actual(trace.t[rows] - start)
            if len(axes):
                out: Floats = (trace.position[rows][:, axes] - position[:, axes]).T.ravel()
                return out
            feed: Floats = trace.feed[rows] - np.sqrt((speed**2).sum(axis=1))
            return feed

        return residuals

    def start(self, control: Control) -> float:
        """Start at which a control comes nearest to the trace."""
        trace = self.trace
        rows = slice(None, None, max(1, len(trace) // _SCAN_POINTS))
        residuals = self.answer(control, rows)
        duration = schedule(self.toolpath, control, self.halts, trace.source).duration
        low, high, count = float(trace.t[0]) - duration, float(trace.t[-1]), _OFFSETS
        while True:
            progress.step()
            candidates = np.linspace(low, high, count)
            costs = [float(np.abs(residuals(c)).mean()) for c in candidates]
            best = float(candidates[int(np.argmin(costs))])
            step = (high - low) / (count - 1)
            if step < 1e-3:
                return best
            low, high, count = best - 2 * step, best + 2 * step, _FINER

    def ideal(self) -> float:
        """Mean size of what a machine that follows exactly leaves."""
        perfect = replace(
            Control.alike(AxisDynamics()),
            x=AxisDynamics(rapid=self.control.x.rapid),
            y=AxisDynamics(rapid=self.control.y.rapid),
            z=AxisDynamics(rapid=self.control.z.rapid),
        )
        return float(np.abs(self.answer(perfect)(self.start(perfect))).mean())

    def fitted(self, factor: float) -> tuple[Floats, float]:
        """Parameters and mean residual of a fit begun at a multiple of the first guess."""
        from scipy.optimize import least_squares

        logs = self.guess + math.log(factor)
        begin = np.concatenate([[self.start(self.with_logs(logs))], logs])
        # In s for times, in 1/s for gains: the shortest lag is the largest gain.
        widest = math.log(1.0 / SHORTEST)
        low = np.concatenate([[-np.inf], np.full(len(logs), -widest)])
        high = np.concatenate([[np.inf], np.full(len(logs), widest)])

        def residuals(p: Floats) -> Floats:
            return self.answer(self.with_logs(p[1:]))(float(p[0]))

        for _ in range(2):
            scale = max(2.0 * _spread(residuals(begin)), 1e-12)
            result = least_squares(
                residuals, begin, bounds=(low, high), loss="soft_l1", f_scale=scale, x_scale=self._scale()
            )
            begin = np.clip(result.x, low, high)
        return begin, float(np.abs(residuals(begin)).mean())

    def _scale(self) -> Floats:
        return np.concatenate([[self.control.delay or _FIRST_GUESS], np.ones(len(self.fit))])

    def judged(self, p: Floats, ideal: float, largest: float) -> Identification:
        """The result, or the refusal of a trace that does not support it."""
        name = self.trace.source

        def residuals(q: Floats) -> Floats:
            return self.answer(self.with_logs(q[1:]))(float(q[0]))

        r = residuals(p)
        left = float(np.abs(r).mean())
        if not left < _EXPLAINED * ideal:
            unit = "mm" if len(self.axes) else "mm/s"
            raise FitError(
                f"{name}: the model leaves {left:.4g} {unit} where an ideal machine leaves {ideal:.4g} {unit}: the "
                "trace is not one of this program on such a control, or shows too few changes of feed and direction: "
                "log corners at a higher feed"
            )
        jacobian = np.empty((len(r), len(p)))
        for k, step in enumerate([1e-5, *[1e-4] * len(self.fit)]):
            d = np.zeros(len(p))
            d[k] = step
            jacobian[:, k] = (residuals(p + d) - residuals(p - d)) / (2 * step)
        size = np.sqrt((jacobian**2).sum(axis=0))
        sigma = _spread(r)
        with np.errstate(divide="ignore", invalid="ignore"):
            normal = (jacobian / size).T @ (jacobian / size)
            regular = bool(np.isfinite(normal).all()) and np.linalg.cond(normal) < 1e12
            spread = sigma * _alike(r) / size
            if regular:
                spread *= np.sqrt(np.diag(np.linalg.inv(normal)))
            elif (spread[1:] <= largest).all():
                spread[1:] = np.inf
        for k, constant in enumerate(self.fit, 1):
            if not spread[k] <= largest:
                share = f"{spread[k]:.0%} of it" if spread[k] < 10 else "more than ten times as large"
                raise FitError(
                    f"{name}: the trace does not determine {self.called.get(constant, constant)} (its standard "
                    f"uncertainty is {share}): log a corner or a start and stop of the axes at a higher feed"
                )
        values = np.exp(p[1:])
        step = float(np.median(np.diff(self.trace.t)))
        for constant, value in zip(self.fit, values.tolist(), strict=True):
            duration = value if constant.endswith("time") else 1.0 / value
            if constant != "contour.speed_change" and duration < 2 * step:
                raise FitError(
                    f"{name}: samples every {step:.4g} s are too few for {self.called.get(constant, constant)}: log at "
                    "a higher rate"
                )
        constants = {c: Constant(float(v), float(v * s)) for c, v, s in zip(self.fit, values, spread[1:], strict=True)}
        return Identification(self.with_logs(p[1:]), constants, float(p[0]), sigma)


def _spread(r: Floats) -> float:
    """Standard deviation by the median of sizes, insensitive to outliers."""
    return 1.4826 * float(np.median(np.abs(r)))


def _alike(r: Floats) -> float:
    """By how much neighbours' likeness widens an uncertainty (lag-one correlation, first-order process)."""
    clipped = np.clip(r, -3 * _spread(r), 3 * _spread(r))
    power = float((clipped**2).sum())
    rho = float((clipped[1:] * clipped[:-1]).sum()) / power if power > 0 else 0.0
    rho = min(max(rho, 0.0), 0.99)
    return math.sqrt((1 + rho) / (1 - rho))


def maintenance_regression(feed: Floats, time: Floats) -> tuple[Constant, Constant]:
    """Straight line through accuracy-maintenance times at several feeds (dat-2025, eq. 1).

    Parameters
    ----------
    feed : (n,) float64
        Programmed feeds in mm/s.
    time : (n,) float64
        Accuracy-maintenance times in s, from `identify` on a trace at each feed.

    Returns
    -------
    slope, intercept : Constant
        In s per mm/s and s, for `ContourControl`.

    Raises
    ------
    FitError
        If there are fewer than three feeds: two always lie on a line.
    """
    v, t = np.asarray(feed, dtype=float), np.asarray(time, dtype=float)
    if len(v) != len(t) or len(np.unique(v)) < 3:
        raise FitError("accuracy-maintenance times at three feeds or more are needed: log more traces")
    design = np.column_stack([v, np.ones(len(v))])
    (slope, intercept), *_ = np.linalg.lstsq(design, t, rcond=None)
    variance = float(((t - design @ [slope, intercept]) ** 2).sum()) / (len(v) - 2)
    spread = np.sqrt(np.diag(np.linalg.inv(design.T @ design)) * variance)
    return Constant(float(slope), float(spread[0])), Constant(float(intercept), float(spread[1]))
