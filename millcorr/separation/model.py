# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repeats: sizes and lengths of form and noise from the data, outliers, the systematic part with its uncertainty.

Measured values are ``d(s) = mu + f(s) + c(s) + e`` and the offsets of whole parts and levels: a constant for each
contour, a form f that all parts and heights share, noise c with a short memory, anew for every part and height, and
white noise e. The systematic part is mu + f.
"""

from __future__ import annotations

import copy
import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .filters import Filter, filtered
from .process import Bound, Cells, Layout, Sizes, Solved

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

MOST_CELLS = 2000
"""Points are gathered to about so many places: closer ones than a thousandth of a contour tell the same."""

MANY = 20_000
"""Of more points a share is enough to find the sizes."""

SEARCHED = 500
"""Places that outliers, sizes and lengths are looked for with; with all cells only the last steps are made."""

MOST_PARTS = 4
"""So many parts may have so many places each: gathered to fewer, what they share would be lost between its waves."""

SEARCHED_PARTS = 3
"""Of more parts the first ones are enough to begin from: what two share is form already. All say how large it is."""

COINCIDING = 1e-3
"""Points nearer than this, in mm, are at one place: no noise with a memory tells them apart."""

FINEST_NODES, NODES, NODES_SEARCHED = 40.0, 6.0, 3.5
"""Nodes in a length of the form: with 6 the grid is exact to a thousandth of the scatter, with 3.5 the likelihood is to
some hundredths; more than 40 make the precision of a Matern 5/2 process ill-conditioned (fifth power)."""

SHORTEST_FORM = 2.0
"""Length of the form in mm, at least: machines repeat themselves with the pitch of their ball screws, 5 mm and more,
and over the width of the cutter's engagement; what is smooth over less, on one part, is as well the process."""

WHITE_LEAST = 1e-5
"""No measured value is better than this, in mm."""

OUTLIERS = 0.01
"""Share of points that are expected to be wrong, before anything is known: a tenth to ten times as much moves the
border between a far point and an outlier by half a standard deviation."""

OUTLIER_SPREAD = 10.0
"""Half of the wrong points lie within so many standard deviations (Cauchy: they may be as far as they like)."""

IGNORED = 1e-6
"""Weight of what is certainly wrong: its own value no longer counts, its distance from the others is known."""

# Median and spread, in logarithms, of what machines do: form of 10 um on 30 mm, noise of 1 um each with a memory of
# 1 mm; weak enough for some tens of points to overrule them.
_PRIOR = {
    "form": (math.log(0.010), 1.5),
    "form_length": (math.log(30.0), 1.0),
    "process": (math.log(0.001), 1.0),
    "memory": (math.log(1.0), 0.7),
    "white": (math.log(0.001), 1.5),
    "part": (math.log(0.002), 1.5),
    "level": (math.log(0.002), 1.5),
}
_NAMES = tuple(_PRIOR)
_MEMORY_OF_SEVERAL = 1.5
_SHORTER = 3.0
_BARRIER = 0.15

_SUSPECT = 6.0
_HALVES = (6, 2)
_ROUNDS = 8
_FEW = 8
_SETTLED = 0.2
_UNLIKELY = 0.01
_KNOWN_BADLY = 60
_ROUNDS_OF_START, _ROUNDS_OF_SEARCH, _HOPEFUL = 5, 12, 25.0
_MOST_PLACES = 1000


@dataclass(frozen=True, eq=False, slots=True)
class Observed:
    """Measured values along smooth stretches.

    Parameters
    ----------
    stretch : (n,) int64
    s : (n,) float64
        mm from the stretch's start.
    value : (n,) float64
        mm.
    part, level : (n,) int64
    """

    stretch: Ints
    s: Floats
    value: Floats
    part: Ints
    level: Ints

    def __len__(self) -> int:
        return len(self.s)

    def take(self, rows: Ints) -> Observed:
        """Some of the values."""
        return Observed(*(getattr(self, name)[rows] for name in Observed.__slots__))


@dataclass(frozen=True, eq=False, slots=True)
class Stretches:
    """Stretches that values lie on: lengths in mm, whether they are rings, and the contour of each."""

    lengths: Floats
    closed: Bools
    contour: Ints


class Gathered:
    """Points gathered to cells, with what is the same for all weights and sizes."""

    def __init__(self, observed: Observed, stretches: Stretches, most: int) -> None:
        self.stretches = stretches
        parts, part = np.unique(observed.part, return_inverse=True)
        levels, level = np.unique(observed.level, return_inverse=True)
        block = part * len(levels) + level
        blocks = len(parts) * len(levels)
        seen = np.unique(observed.stretch)
        room = float(stretches.lengths[seen].sum()) * blocks
        most *= min(len(parts), MOST_PARTS)
        width = COINCIDING if len(observed) <= most else max(room / most, COINCIDING)
        cells_of = np.ceil(stretches.lengths / width).astype(np.int64) + 1
        first = np.concatenate([[0], np.cumsum(cells_of)])
        cell = first[observed.stretch] + np.floor(observed.s / width).astype(np.int64)
        key = block * first[-1] + cell
        _, start, self.of = np.unique(key, return_index=True, return_inverse=True)
        self.count = np.bincount(self.of).astype(np.float64)
        s = np.bincount(self.of, observed.s) / self.count
        stretch = observed.stretch[start]
        contours, contour = np.unique(stretches.contour[stretch], return_inverse=True)
        columns = [contour[:, None] == np.arange(len(contours))]
        kinds = [np.zeros(len(contours), dtype=np.int64)]
        for number, index, kind in ((len(parts), part, 1), (len(levels), level, 2)):
            if number > 1:
                columns.append(index[start][:, None] == np.arange(number))
                kinds.append(np.full(number, kind))
        self.contours = contours
        self.kind = np.concatenate(kinds)
        table = np.concatenate(columns, axis=1).astype(np.float64)
        self.cells = Cells(stretch, block[start], s, table, self.kind)
        self.value = observed.value
        self.parts, self.levels = len(parts), len(levels)
        self.part = part[start]
        self.scale: Floats | None = None
        self.spacing = room / blocks / max(len(s), 1)
        self.longest = float(stretches.lengths[seen].max())

    def data(self, weight: Floats) -> tuple[Floats, Floats, float]:
        """Means and weights of the cells, and the weighted squares of the points about them, for weights (n,)."""
        total: Floats = np.bincount(self.of, weight).astype(np.float64)
        mean: Floats = np.bincount(self.of, weight * self.value) / total
        return mean, total, float(weight @ (self.value - mean[self.of]) ** 2)

    def counting(self, count: Floats) -> Gathered:
        """The same where each part counts so many times, (parts,), as if all its noise were 1/sqrt(count) as large.

        Its values are seen through sqrt(count): what is systematic is scaled and the noise is as it was.
        """
        out = copy.copy(self)
        out.scale = np.sqrt(count)[self.part]
        systematic = np.where(self.kind == 1, 1.0, out.scale[:, None])
        out.cells = replace(self.cells, columns=self.cells.columns * systematic)
        out.value = out.scale[self.of] * self.value
        return out

    def step(self, form_length: float, nodes: float) -> float:
        """Distance of the form's nodes, mm: a power of the root of two, so that lengths near each other share it."""
        fitting = min(max(6.0 * self.spacing, form_length / FINEST_NODES), form_length / nodes)
        return float(2.0 ** (0.5 * math.floor(2.0 * math.log2(fitting))))


class Likelihood:
    """-2 log of likelihood times prior of the sizes, for given weights of the points."""

    def __init__(self, gathered: Gathered, weight: Floats, nodes: float = NODES_SEARCHED) -> None:
        self.gathered, self.nodes = gathered, nodes
        self.mean, self.total, self.within = gathered.data(weight)
        # Points of no weight tell nothing of the white noise either.
        self.freedom = float((weight > 1e3 * IGNORED).sum()) - float((self.total > 1e3 * IGNORED).sum())
        self.bounds: dict[float, Bound] = {}
        self.free = [
            name
            for name in _NAMES
            if not (name == "part" and gathered.parts == 1) and not (name == "level" and gathered.levels == 1)
        ]
        several = gathered.parts > 1
        self.prior = {n: _PRIOR[n] for n in self.free}
        if several:
            self.prior["memory"] = (_PRIOR["memory"][0], _MEMORY_OF_SEVERAL)
        self.box = {
            "form": (1e-6, 3.0),
            "form_length": (SHORTEST_FORM, max(3.0 * gathered.longest, 5.0 * SHORTEST_FORM)),
            "process": (1e-6, 3.0),
            "memory": (0.02, 50.0),
            "white": (WHITE_LEAST, 3.0),
            "part": (1e-5, 3.0),
            "level": (1e-5, 3.0),
        }

    def sizes(self, x: Floats) -> Sizes:
        """Sizes of logarithms."""
        values = {name: math.exp(_PRIOR[name][0]) for name in _NAMES}
        values.update(zip(self.free, np.exp(x).tolist(), strict=True))
        return Sizes(**values)

    def logs(self, sizes: Sizes) -> Floats:
        """Logarithms of sizes within their bounds."""
        return np.array([math.log(min(max(getattr(sizes, n), self.box[n][0]), self.box[n][1])) for n in self.free])

    def limits(self) -> list[tuple[float, float]]:
        """Bounds of the logarithms."""
        return [(math.log(self.box[n][0]), math.log(self.box[n][1])) for n in self.free]

    def bound(self, form_length: float) -> Bound:
        """Layout with data for a length of the form."""
        step = self.gathered.step(form_length, self.nodes)
        if step not in self.bounds:
            g = self.gathered
            layout = Layout(g.cells, g.stretches.lengths, g.stretches.closed, step)
            if g.scale is not None:
                layout.weight = g.scale[:, None] * layout.weight
            self.bounds[step] = layout.bind(self.mean, self.total)
        return self.bounds[step]

    def __call__(self, x: Floats, bound: Bound | None = None) -> float:
        """-2 log of likelihood and prior for logarithms of the sizes, on a grid that fits their length or another."""
        sizes = self.sizes(x)
        solved = (bound or self.bound(sizes.form_length)).solve(sizes)
        if solved is None or not math.isfinite(solved.minus_log):
            return 1e12
        out = solved.minus_log + self.freedom * math.log(sizes.white**2) + self.within / sizes.white**2
        for name, value in zip(self.free, x, strict=True):
            centre, spread = self.prior[name]
            out += ((value - centre) / spread) ** 2
        if self.gathered.parts == 1:
            over = math.log(_SHORTER * sizes.memory / sizes.form_length)
            out += (max(over, 0.0) / _BARRIER) ** 2
        return out

    def gradient(self, x: Floats) -> tuple[float, Floats]:
        """Value and gradient, by differences on one grid."""
        bound = self.bound(math.exp(x[self.free.index("form_length")]))
        here = self(x, bound)
        step = 1e-4
        out = np.empty(len(x))
        for i in range(len(x)):
            moved = x.copy()
            moved[i] += step
            out[i] = (self(moved, bound) - here) / step
        return here, out

    def minimum(self, x: Floats, rounds: int) -> tuple[float, Floats]:
        """Smallest value from a start on."""
        from scipy.optimize import minimize

        limits = self.limits()
        x = np.clip(x, [a for a, _ in limits], [b for _, b in limits])
        found = minimize(
            self.gradient, x, jac=True, method="L-BFGS-B", bounds=limits, options={"maxiter": rounds, "ftol": 1e-6}
        )
        return float(found.fun), np.asarray(found.x)


def _starts(likelihood: Likelihood, noise: float, spread: float) -> list[Floats]:
    """Logarithms to begin at: short and long forms with little remembered noise, and any form with much."""
    g = likelihood.gathered
    low, high = SHORTEST_FORM, max(0.5 * g.longest, 3.0 * SHORTEST_FORM)
    count = max(3, min(8, 2 + round(math.log(high / low) / 0.8)))
    lengths = np.geomspace(low, high, count)
    out = []
    short, long = lengths[: count // 2], lengths[count // 2 :]
    kinds = [(0.3, 1.0, short), (0.3, 1.0, long), (3.0, 0.5, lengths)]
    if g.parts > 1:
        # What parts share may look like noise along each of them.
        kinds.append((0.3, 0.2, short))
    for process, white, some in kinds:
        begun: list[tuple[float, int, Floats]] = []
        for length in some:
            sizes = Sizes(
                max(spread, 2 * noise, 1e-4), float(length), max(process * noise, 1e-5), min(1.0, length / 4),
                max(white * noise, 2 * WHITE_LEAST), max(noise, 1e-4), max(noise, 1e-4),
            )  # fmt: skip
            x = likelihood.logs(sizes)
            begun.append((likelihood(x), len(begun), x))
        out.append(min(begun, key=lambda row: row[:2])[2])
    return out


def _suspects(gathered: Gathered, observed: Observed, half: int) -> Bools:
    """Points far off the median of `half` neighbours on either side, in units of what is usual; (n,)."""
    from scipy.ndimage import median_filter

    out = np.zeros(len(observed), dtype=bool)
    block = gathered.cells.block[gathered.of]
    key = observed.stretch * (int(block.max(initial=0)) + 1) + block
    order = np.lexsort((observed.s, key))
    off = np.zeros(len(observed))
    for rows in np.split(order, np.flatnonzero(np.diff(key[order])) + 1):
        if len(rows) < 2 * half + 3:
            continue
        mode = "wrap" if gathered.stretches.closed[observed.stretch[rows[0]]] else "nearest"
        value = observed.value[rows]
        off[rows] = value - median_filter(value, size=2 * half + 1, mode=mode)
    usual = 1.482602 * float(np.median(np.abs(off)))
    if usual > 0.0:
        out = np.abs(off) > _SUSPECT * usual
    return out


def _point_to_point(gathered: Gathered, mean: Floats) -> float:
    """Standard deviation in mm of neighbouring cells about the line through theirs, by the median."""
    c = gathered.cells
    order = np.lexsort((c.s, c.stretch, c.block))
    value = mean[order]
    same = (c.block[order][2:] == c.block[order][:-2]) & (c.stretch[order][2:] == c.stretch[order][:-2])
    second = (value[1:-1] - 0.5 * (value[:-2] + value[2:]))[same]
    return float(1.482602 * np.median(np.abs(second)) / math.sqrt(1.5)) if len(second) else 0.0


@dataclass(frozen=True, eq=False, slots=True)
class Fit:
    """Sizes found, with weights of the points and what they cost."""

    x: Floats
    weight: Floats
    cost: float


def _noise_of_one(sizes: Sizes, gap: float) -> float:
    """Variance of remembered noise at a point, mm2, about what neighbours every `gap` mm to both sides say of it.

    The harmonic mean of the spectrum is the variance of a value about all others (Grenander & Rosenblatt 1957).
    """
    if not gap > 0.0:
        return sizes.process**2
    rho, cosine = math.exp(-gap / sizes.memory), np.cos((np.arange(128) + 0.5) * math.pi / 128)
    spectrum = sizes.process**2 * (1 - rho**2) / (1 - 2 * rho * cosine + rho**2) + sizes.white**2
    return max(1.0 / float((1.0 / spectrum).mean()) - sizes.white**2, 0.0)


def _judged(likelihood: Likelihood, x: Floats, weight: Floats, gap: float) -> tuple[Floats, Floats, float]:
    """Probability that each point is sound, (n,), its distance in standard deviations, and what the wrong ones cost."""
    g = likelihood.gathered
    sizes = likelihood.sizes(x)
    bound = likelihood.bound(sizes.form_length)
    solved = bound.solve(sizes)
    assert solved is not None
    form, process = bound.residual(solved)
    left = g.value - (form + process)[g.of]
    own = np.full(len(weight), _noise_of_one(sizes, gap))
    doubted = np.flatnonzero(weight < 0.5)
    if len(doubted):
        cells, back = np.unique(g.of[doubted], return_inverse=True)
        own[doubted] = np.maximum(own[doubted], bound.cell_variance(solved, cells)[back])
    v = sizes.white**2
    # Its own value has drawn the posterior towards it: distance from what all others say.
    z2 = (left * (1.0 + own * weight / v)) ** 2 / (v + own)
    sound = (1.0 - OUTLIERS) / math.sqrt(2 * math.pi) * np.exp(-0.5 * np.minimum(z2, 1400.0))
    wrong = OUTLIERS / (math.pi * OUTLIER_SPREAD * (1.0 + z2 / OUTLIER_SPREAD**2))
    probability = sound / (sound + wrong)
    out = weight < 0.5
    cost = -2.0 * float(np.log(wrong[out] / np.sqrt(v + own[out])).sum())
    # What the likelihood has counted of them is theirs alone.
    cost -= float((np.log(v + 0.0 * own[out]) - np.log(np.maximum(weight[out], IGNORED))).sum())
    return probability, np.sqrt(z2), cost


def _settled(gathered: Gathered, weight: Floats, gap: float, x: Floats | None) -> Fit:
    """Weights and sizes renewed until they settle."""
    cost = math.inf
    for turn in range(_ROUNDS):
        likelihood = Likelihood(gathered, weight)
        if x is None:
            noise = _point_to_point(gathered, likelihood.mean)
            spread = float(np.sqrt(likelihood.total @ (likelihood.mean - np.average(
                likelihood.mean, weights=likelihood.total)) ** 2 / likelihood.total.sum()))  # fmt: skip
            found = [likelihood.minimum(start, _ROUNDS_OF_START) for start in _starts(likelihood, noise, spread)]
            least = min(row[0] for row in found)
            # Four rounds come within some units of the end.
            hopeful = [row for row in found if row[0] < least + _HOPEFUL]
            value, x = min((likelihood.minimum(row[1], _ROUNDS_OF_SEARCH) for row in hopeful), key=lambda row: row[0])
        else:
            value, x = likelihood.minimum(x, _ROUNDS_OF_START if turn else _ROUNDS_OF_SEARCH)
        if len(weight) < _FEW:
            return Fit(x, weight, value)
        probability, _, dear = _judged(likelihood, x, weight, gap)
        cost = value + dear
        renewed = np.maximum(probability, IGNORED)
        settled = float(np.abs(renewed - weight).max()) < _SETTLED
        if settled or turn == _ROUNDS - 1:
            return Fit(x, weight, cost)
        weight = renewed
    raise AssertionError


def _weights(gathered: Gathered, observed: Observed, x: Floats) -> Floats:
    """Trust in every point by what sizes say that were found from some of them; (n,)."""
    weight: Floats = np.where(_suspects(gathered, observed, max(_HALVES)), IGNORED, 1.0)
    for _ in range(2):
        probability, _, _ = _judged(Likelihood(gathered, weight), x, weight, gathered.spacing)
        weight = np.maximum(probability, IGNORED)
    return weight


def _fitted(observed: Observed, stretches: Stretches) -> tuple[Gathered, Fit]:
    """Sizes and weights of the likeliest of the ways to begin, for all points."""
    gathered = Gathered(observed, stretches, MOST_CELLS)
    if len(observed) > MANY:
        # Sizes from a share of the points, evenly among all; then every point is judged by what they say.
        order = np.lexsort((observed.s, observed.stretch, observed.level, observed.part))
        found = _fitted(observed.take(np.sort(order[:: -(-len(order) // MANY)])), stretches)[1]
        return gathered, replace(found, weight=_weights(gathered, observed, found.x))
    if gathered.parts > SEARCHED_PARTS:
        first = observed.part <= np.unique(observed.part)[SEARCHED_PARTS - 1]
        found = _fitted(observed.take(np.flatnonzero(first)), stretches)[1]
        weight = _weights(gathered, observed, found.x)
        return gathered, Fit(Likelihood(gathered, weight).minimum(found.x, _ROUNDS_OF_SEARCH)[1], weight, found.cost)
    few = gathered if len(observed) <= SEARCHED else Gathered(observed, stretches, SEARCHED)
    gap = few.spacing
    begun: list[Bools] = []
    fits: list[Fit] = []
    for half in _HALVES:
        wrong = _suspects(gathered, observed, half) if len(observed) >= _FEW else np.zeros(len(observed), dtype=bool)
        if not any(np.array_equal(wrong, other) for other in begun):
            begun.append(wrong)
            fits.append(_settled(few, np.where(wrong, IGNORED, 1.0), gap, None))
            if not wrong.any() and fits[-1].weight.min() >= 0.5:
                # Nothing stands out, neither beforehand nor of what was found.
                break
    best = min(fits, key=lambda fit: fit.cost)
    if few is gathered:
        return gathered, best
    return gathered, replace(best, x=Likelihood(gathered, best.weight).minimum(best.x, _ROUNDS_OF_START)[1])


@dataclass(frozen=True, eq=False, slots=True)
class LevelDifference:
    """How a height differs from the mean of all heights.

    Parameters
    ----------
    level : int
    mean, std : float
        mm, and its standard uncertainty.
    significant : bool
        Whether that is more than chance (three standard uncertainties).
    """

    level: int
    mean: float
    std: float

    @property
    def significant(self) -> bool:
        """Whether the difference is more than chance: three standard uncertainties."""
        return abs(self.mean) > 3.0 * self.std


@dataclass(frozen=True, eq=False, slots=True)
class Separated:
    """What repeats along the contour, and what does not.

    Parameters
    ----------
    systematic, uncertainty : (n,) float64
        Systematic part at the observed points and its standard uncertainty (k = 1), mm.
    weight : (n,) float64
        Trust in every point, 0 (outlier) to 1.
    sizes : Sizes
        Standard deviations and lengths of form and noise.
    band : float
        Factor on the standard uncertainty for a band that holds along the whole contour with 95 %.
    levels : tuple of LevelDifference
        One a level where there are several.
    """

    observed: Observed
    stretches: Stretches
    filter: Filter
    systematic: Floats
    uncertainty: Floats
    weight: Floats
    sizes: Sizes
    band: float
    levels: tuple[LevelDifference, ...]
    notes: tuple[str, ...]
    _bound: Bound
    _solved: Solved
    _contours: Ints
    _grid: tuple[Floats, Ints, Floats]
    _more: tuple[tuple[Floats, Floats] | None, ...]

    @property
    def outlier(self) -> Bools:
        """Which points are more probably wrong than right; (n,)."""
        out: Bools = self.weight < 0.5
        return out

    @property
    def random_std(self) -> float:
        """Standard deviation of what does not repeat, mm: process and measurement together."""
        return math.hypot(self.sizes.process, self.sizes.white)

    def at(self, stretch: Ints, s: Floats) -> tuple[Floats, Floats]:
        """Systematic part and its standard uncertainty at any place, mm; (m,) each.

        Parameters
        ----------
        stretch : (m,) int64
        s : (m,) float64
            mm from each stretch's start.

        Returns
        -------
        mean, std : (m,) float64
            On a contour without points 0 and NaN: not known.
        """
        stretch, s = np.asarray(stretch, dtype=np.int64), np.asarray(s, dtype=np.float64)
        column, known = _columns(self.stretches, self._contours, stretch)
        mean = np.where(known, self._bound.mean(self._solved, stretch, s, column), 0.0)
        first, of, std = self._grid
        out = np.full(len(s), math.nan)
        for k in np.unique(stretch):
            rows = stretch == k
            here = of == k
            if here.any():
                out[rows] = _interpolated(s[rows], (first[here], std[here]), self._period(k))
            more = self._more[k] if self._more else None
            if more is not None:
                mean[rows] += _interpolated(s[rows], more, self._period(k))
        return mean, out

    def _period(self, k: int) -> float | None:
        return float(self.stretches.lengths[k]) if self.stretches.closed[k] else None


def _columns(stretches: Stretches, contours: Ints, stretch: Ints) -> tuple[Ints, Bools]:
    """Column of the mean of each stretch's contour, and whether it has one."""
    contour = stretches.contour[stretch]
    at = np.minimum(np.searchsorted(contours, contour), len(contours) - 1)
    return at.astype(np.int64), contours[at] == contour


def _interpolated(s: Floats, course: tuple[Floats, Floats], period: float | None) -> Floats:
    """Shape-preserving cubic through values at increasing places; held beyond the ends of an open stretch."""
    from scipy.interpolate import PchipInterpolator

    at, value = course
    if len(at) == 1:
        return np.full(len(s), value[0])
    if period is not None:
        near = min(3, len(at))
        at = np.concatenate([at[-near:] - period, at, at[:near] + period])
        value = np.concatenate([value[-near:], value, value[:near]])
        s = np.mod(s, period)
    found: Floats = PchipInterpolator(at, value)(np.clip(s, at[0], at[-1]))
    return found


def _places(stretches: Stretches, contours: Ints, form_length: float) -> tuple[Ints, Floats]:
    """Stretch and arc length of places where the uncertainty is worked out."""
    use = np.flatnonzero(np.isin(stretches.contour, contours))
    step = max(form_length / 8.0, float(stretches.lengths[use].sum()) / _MOST_PLACES)
    of, at = [], []
    for k in use:
        count = max(math.ceil(stretches.lengths[k] / step), 4)
        x = np.arange(count) if stretches.closed[k] else np.arange(count + 1)
        at.append(x * (stretches.lengths[k] / count))
        of.append(np.full(len(x), k))
    return np.concatenate(of).astype(np.int64), np.concatenate(at)


def _whole_band(variance: Floats, along: Floats, of: Ints) -> float:
    """Factor for 95 % along all places together, from the length of the path of the standardised error.

    Sun & Loader 1994, eq. 2.1: P(max |t| > k) = 2 (1 - Phi(k)) a stretch + length / pi exp(-k^2/2), both at most.
    """
    from scipy.optimize import brentq
    from scipy.special import ndtr

    same = of[1:] == of[:-1]
    cosine = along[:-1] / np.sqrt(np.maximum(variance[:-1] * variance[1:], 1e-30))
    length = float(np.arccos(np.clip(cosine[same], -1.0, 1.0)).sum())

    def over(k: float) -> float:
        return 2.0 * float(ndtr(-k)) + length / math.pi * math.exp(-0.5 * k * k) - 0.05

    return float(brentq(over, 1.9, 10.0))


def separate(
    observed: Observed, stretches: Stretches, filter: Filter | None = None, count: Floats | None = None
) -> Separated:
    """Split measured values into what repeats and what does not.

    Parameters
    ----------
    observed : Observed
        At least one point.
    stretches : Stretches
    filter : Filter, optional
        `auto` (default): the model. With a prescribed filter the values at the points are the filter's, each part
        and level by itself, then the mean over them; in between and in gaps the model carries them on.
    count : (parts,) float64, optional
        How many times each part counts for the systematic part, in the order of their numbers; by default once. What
        is form and what is noise, all parts say alike.

    Returns
    -------
    Separated
    """
    filter = filter or Filter("auto")
    gathered, fit = _fitted(observed, stretches)
    # Weights of the noise are those of its sizes; parts that count otherwise do so for the posterior alone.
    seen = gathered if count is None else gathered.counting(count)
    likelihood = Likelihood(seen, fit.weight, NODES)
    sizes = likelihood.sizes(fit.x)
    bound = likelihood.bound(sizes.form_length)
    solved = bound.solve(sizes)
    assert solved is not None
    of, at = _places(stretches, gathered.contours, sizes.form_length)
    column, _ = _columns(stretches, gathered.contours, of)
    variance, along = bound.variance(solved, of, at, column)
    band = _whole_band(variance, along, of)
    variance = variance + _of_sizes(gathered, seen, fit, variance, of, at, column)
    variance = variance + _of_kind(gathered, fit, sizes, bound.mean(solved, of, at, column), of, at, column)
    out = Separated(
        observed, stretches, filter, np.zeros(0), np.zeros(0), fit.weight, sizes, band,
        _level_differences(observed, gathered, solved), (), bound, solved, gathered.contours,
        (at, of, np.sqrt(np.maximum(variance, 0.0))), (),
    )  # fmt: skip
    mean, std = out.at(observed.stretch, observed.s)
    if filter.kind == "auto":
        return replace(out, systematic=mean, uncertainty=std)
    return _prescribed(out, mean, count)


def _of_sizes(
    gathered: Gathered, seen: Gathered, fit: Fit, variance: Floats, of: Ints, at: Floats, column: Ints
) -> Floats:
    """Variance of the systematic part at places because the sizes are not known exactly; to first order.

    Their covariance is the inverse of the curvature of the likelihood (Laplace; Rasmussen & Williams 2006, 5.2).
    """
    likelihood = Likelihood(gathered, fit.weight)
    x, n = fit.x, len(fit.x)
    bound = likelihood.bound(math.exp(x[1]))
    step = 0.1
    unit = step * np.eye(n)
    here = likelihood(x, bound)
    plus = np.array([likelihood(x + unit[i], bound) for i in range(n)])
    minus = np.array([likelihood(x - unit[i], bound) for i in range(n)])
    curve = np.empty((n, n))
    for i in range(n):
        curve[i, i] = plus[i] - 2 * here + minus[i]
        for j in range(i):
            curve[i, j] = curve[j, i] = likelihood(x + unit[i] + unit[j], bound) - plus[i] - plus[j] + here
    value, vector = np.linalg.eigh(curve / (2.0 * step**2))
    if seen is not gathered:
        bound = Likelihood(seen, fit.weight).bound(math.exp(x[1]))
    out, more = np.zeros(len(of)), np.zeros(len(of))
    few = len(gathered.value) <= _KNOWN_BADLY
    lower, upper = np.array(likelihood.limits()).T
    # The priors know a logarithm to 1.5: no direction is known worse.
    for spread, direction in zip(1.0 / np.sqrt(np.maximum(value, 1.0 / 1.5**2)), vector.T, strict=True):
        means = []
        for sign in (1.0, -1.0):
            solved = bound.solve(likelihood.sizes(np.clip(x + sign * spread * direction, lower, upper)))
            if solved is None:
                continue
            means.append(bound.mean(solved, of, at, column))
            if few:
                # Of few points the variance itself is known badly: its mean over the sizes, to second order.
                more += 0.5 * (bound.variance(solved, of, at, column)[0] - variance)
        if len(means) == 2:
            out += 0.25 * (means[0] - means[1]) ** 2
    return out + np.maximum(more, 0.0)


def _of_kind(gathered: Gathered, fit: Fit, sizes: Sizes, mean: Floats, of: Ints, at: Floats, column: Ints) -> Floats:
    """Variance of the systematic part at places because what is taken for form may be the process of this one part.

    On one part a form hardly longer than the process's memory cannot be told from it but by what is usual for both.
    Were it process, the systematic part would be a longer form's; the difference counts with the odds of that.
    """
    if gathered.parts * gathered.levels > 1:
        return np.zeros(len(of))

    def usual(name: str, value: float) -> float:
        centre, spread = _PRIOR[name]
        return -0.5 * ((math.log(value) - centre) / spread) ** 2 - math.log(spread)

    odds = math.exp(
        usual("memory", sizes.form_length) + usual("process", sizes.form)
        - usual("form_length", sizes.form_length) - usual("form", sizes.form)
    )  # fmt: skip
    share = odds / (1.0 + odds)
    if share < _UNLIKELY:
        return np.zeros(len(of))
    longer = _SHORTER * sizes.form_length
    likelihood = Likelihood(gathered, fit.weight)
    likelihood.box["form_length"] = (longer, max(likelihood.box["form_length"][1], 2.0 * longer))
    begin = replace(sizes, form_length=max(2.0 * longer, 20.0), process=sizes.form, memory=sizes.form_length)
    x = likelihood.minimum(likelihood.logs(begin), _ROUNDS_OF_SEARCH)[1]
    other = likelihood.sizes(x)
    bound = likelihood.bound(other.form_length)
    solved = bound.solve(other)
    if solved is None:
        return np.zeros(len(of))
    out: Floats = share * (mean - bound.mean(solved, of, at, column)) ** 2
    return out


def _level_differences(observed: Observed, gathered: Gathered, solved: Solved) -> tuple[LevelDifference, ...]:
    rows = np.flatnonzero(gathered.kind == 2)
    if not len(rows):
        return ()
    centred = np.eye(len(rows)) - 1.0 / len(rows)
    mean = centred @ solved.constants[rows]
    std = np.sqrt(np.diag(centred @ solved.spread[np.ix_(rows, rows)] @ centred.T))
    return tuple(
        LevelDifference(int(level), float(m), float(u))
        for level, m, u in zip(np.unique(observed.level), mean, std, strict=True)
    )


def _prescribed(out: Separated, model: Floats, count: Floats | None) -> Separated:
    """Values of a prescribed filter at the points; the model carries on what it differs by."""
    observed, stretches = out.observed, out.stretches
    value = np.empty(len(observed))
    uncertainty = np.empty(len(observed))
    more: list[tuple[Floats, Floats] | None] = [None] * len(stretches.lengths)
    for k in np.unique(observed.stretch):
        length, closed = float(stretches.lengths[k]), bool(stretches.closed[k])
        here = np.flatnonzero(observed.stretch == k)
        courses = []
        blocks = observed.part[here] * (int(observed.level.max()) + 1) + observed.level[here]
        period = length if closed else None
        numbers = np.unique(blocks)
        part = np.searchsorted(np.unique(observed.part), numbers // (int(observed.level.max()) + 1))
        share = np.ones(len(numbers)) if count is None else count[part]
        if not share.any():
            # No part that counts has a point here.
            share = np.ones(len(numbers))
        for block in numbers:
            rows = here[blocks == block]
            made = filtered(observed.s[rows], observed.value[rows], length=length, closed=closed, filter=out.filter)
            courses.append(_through(observed.s[rows], made.determined - model[rows], length, closed))
        if len(courses) == 1:
            more[k] = courses[0]
        else:
            # Every part and height by itself, then their mean where the densest has its points.
            s = max(courses, key=lambda c: len(c[0]))[0]
            more[k] = s, np.average([_interpolated(s, c, period) for c in courses], axis=0, weights=share)
        course = more[k]
        assert course is not None
        difference = _interpolated(observed.s[here], course, period)
        value[here] = model[here] + difference
        # The filter is off the model by what noise it lets through and what form it takes away; both are errors.
        std = out.at(observed.stretch[here], observed.s[here])[1]
        uncertainty[here] = np.sqrt(std**2 + float(np.mean(difference**2)))
    at, of, std = out._grid
    wider = np.array([0.0 if c is None else float(np.mean(c[1] ** 2)) for c in more])
    grid = (at, of, np.sqrt(std**2 + wider[of]))
    return replace(out, systematic=value, uncertainty=uncertainty, _grid=grid, _more=tuple(more))


def _through(s: Floats, value: Floats, length: float, closed: bool) -> tuple[Floats, Floats]:
    """Places in order with the mean of the values there; those that nearly coincide are one."""
    s = np.mod(s, length) if closed else s
    group = np.floor(s / COINCIDING)
    _, inverse, count = np.unique(group, return_inverse=True, return_counts=True)
    return np.bincount(inverse, s) / count, np.bincount(inverse, value) / count


def interpolated(s: Floats, value: Floats, length: float, closed: bool, at: Floats) -> Floats:
    """Values at places through values at points of one stretch, those at one place averaged; mm. (m,)."""
    return _interpolated(at, _through(s, value, length, closed), length if closed else None)
