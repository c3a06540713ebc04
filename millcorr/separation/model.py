# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repeats: sizes and lengths of form and noise from the data, outliers, the systematic part with its uncertainty.

Measured values are ``d(s) = mu + f(s) + a g(s) + c(s) + e`` and the offsets of whole parts and levels: a constant for
each contour, a form f that all parts and heights share, a lean g by which the form at the highest level differs from
that at the lowest (a is the level's place between them, about their mean), noise c with a short memory, anew for every
part and height, and white noise e. The systematic part is mu + f.
"""

from __future__ import annotations

import copy
import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

from .filters import Filter, filtered
from .process import Bound, Cells, Layout, Sizes, Solved

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

WHITE_LEAST = 1e-4
"""No measured value is better than this, in mm: the best measuring machines repeat to 0.1 um, and a milled surface is
rougher. What the rounding of the file's numbers adds comes on top (`Observed.rounding`)."""

SMOOTHEST = 1e-3
"""Where many points are suspects and less noise than this, mm, is found, outliers are looked for as if it were so much:
no milled surface is smoother from point to point. Where a simulated one is, some humps on a flat to a hair were as
likely a quarter of outliers as a form, and the last digit decided. They are settled with the noise as it is."""

OUTLIERS = 0.01
"""Share of points that are expected to be wrong, before anything is known: a tenth to ten times as much moves the
border between a far point and an outlier by half a standard deviation."""

OUTLIER_SPREAD = 10.0
"""Half of the wrong points lie within so many standard deviations (Cauchy: they may be as far as they like)."""

MANY_SUSPECTS = 0.05
"""Share of points that stand out from their neighbours above which it is tried, too, whether all are sound: files have
some outliers in a hundred points."""

IGNORED = 1e-6
"""Weight of what is certainly wrong: its own value no longer counts, its distance from the others is known."""

# Lowest and highest usual value and the spread beyond them, in logarithms, of what machines do: form of 10 um on 30 mm,
# noise of 1 um each; weak enough for some tens of points to overrule them. Memories from 0.7 to 6 mm are as
# likely: between noise that is soon forgotten under a short form and noise long remembered under a
# long one the values decide, and where they cannot, the uncertainty holds for either.
_PRIOR = {
    "form": (math.log(0.010), math.log(0.010), 1.5),
    "form_length": (math.log(30.0), math.log(30.0), 1.0),
    "process": (math.log(0.001), math.log(0.001), 1.0),
    "memory": (math.log(0.7), math.log(6.0), 0.7),
    "white": (math.log(0.001), math.log(0.001), 1.5),
    "lean": (math.log(0.002), math.log(0.002), 1.5),
    "part": (math.log(0.002), math.log(0.002), 1.5),
    "level": (math.log(0.002), math.log(0.002), 1.5),
}
_NAMES = tuple(_PRIOR)
_MEMORY_OF_SEVERAL = 1.5
_SHORTER = 3.0
"""On one part noise is remembered over at most a third of the form's length: at 1 / sqrt(5) of it the spectra of noise
(1 / memory) and form (sqrt(5) / length) bend at the same wavelength."""
_BARRIER = 0.15
_TOLD = 4.0
"""Of memories up to a quarter of the form's length 92 % and more lie within the 95 % band, whatever the form; of a
third it may be 83 % (tests of the separation, 200 points)."""

DRAWN, WIDER, NEGLIGIBLE = 32, 1.3, 0.03
"""Sizes drawn for the uncertainty, how much wider than the likelihood's peak, and the share of the likeliest below
which one is left out: some twenty count, enough for a tenth of the variance over the sizes."""

NORMAL_95 = 1.959964
"""Half width of the 95 % interval of the normal distribution."""

_SUSPECT = 6.0
_HALVES = (6, 2)
_ROUNDS = 8
_FEW = 8
_SETTLED = 0.2
_AT_ONCE = 1 << 17
_ROUNDS_OF_START, _ROUNDS_OF_SEARCH, _HOPEFUL, _MET, _FLAT = 5, 12, 25.0, 0.5, 0.01
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
    z : (n,) float64, optional
        Height, mm; without it the levels are equally far apart, in the order of their numbers.
    rounding : float
        Standard deviation in mm that the rounding of the measured coordinates alone gives the values.
    """

    stretch: Ints
    s: Floats
    value: Floats
    part: Ints
    level: Ints
    z: Floats | None = None
    rounding: float = 0.0

    def __len__(self) -> int:
        return len(self.s)

    def take(self, rows: Ints) -> Observed:
        """Some of the values."""
        z = None if self.z is None else self.z[rows]
        one = (self.stretch[rows], self.s[rows], self.value[rows], self.part[rows], self.level[rows], z)
        return Observed(*one, rounding=self.rounding)


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
        z = observed.level.astype(np.float64) if observed.z is None else observed.z
        height = np.bincount(level, z) / np.bincount(level)
        several = len(levels) > 1
        self.across = (height - height.mean()) / np.ptp(height) if several else np.zeros(1)
        self.cells = Cells(stretch, block[start], s, table, self.kind, self.across[level[start]], np.ones(len(s)))
        self.value = observed.value
        self.least = math.hypot(WHITE_LEAST, observed.rounding)
        self.parts, self.levels = len(parts), len(levels)
        self.part = part[start]
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
        scale = np.sqrt(count)[self.part]
        systematic = np.where(self.kind == 1, 1.0, scale[:, None])
        out.cells = replace(self.cells, columns=self.cells.columns * systematic, scale=scale)
        out.value = scale[self.of] * self.value
        return out

    def no_smoother(self, least: float) -> Gathered:
        """The same where no value is taken to be better than this, mm."""
        out = copy.copy(self)
        out.least = max(self.least, least)
        return out

    def step(self, form_length: float, nodes: float) -> float:
        """Distance of the form's nodes, mm: a power of the root of two, so that lengths near each other share it."""
        fitting = min(max(6.0 * self.spacing, form_length / FINEST_NODES), form_length / nodes)
        return float(2.0 ** (0.5 * math.floor(2.0 * math.log2(fitting))))


class Likelihood:
    """-2 log of likelihood times prior of the sizes, for given weights of the points."""

    def __init__(self, gathered: Gathered, weight: Floats, nodes: float = NODES_SEARCHED) -> None:
        progress.step()
        self.gathered, self.nodes = gathered, nodes
        self.mean, self.total, self.within = gathered.data(weight)
        # Points of no weight tell nothing of the white noise either.
        self.freedom = float((weight > 1e3 * IGNORED).sum()) - float((self.total > 1e3 * IGNORED).sum())
        self.bounds: dict[float, Bound] = {}
        self.usual = {name: math.exp(low) for name, (low, _, _) in _PRIOR.items()}
        self.free = [
            name
            for name in _NAMES
            if not (name == "part" and gathered.parts == 1) and not (name in ("level", "lean") and gathered.levels == 1)
        ]
        several = gathered.parts > 1
        self.prior = {n: _PRIOR[n] for n in self.free}
        if several:
            self.prior["memory"] = (*_PRIOR["memory"][:2], _MEMORY_OF_SEVERAL)
        self.box = {
            "form": (1e-6, 3.0),
            "form_length": (SHORTEST_FORM, max(3.0 * gathered.longest, 5.0 * SHORTEST_FORM)),
            "process": (1e-6, 3.0),
            "memory": (0.02, 50.0),
            "white": (gathered.least, 3.0),
            "part": (1e-5, 3.0),
            "level": (1e-5, 3.0),
            "lean": (1e-6, 3.0),
        }

    def sizes(self, x: Floats) -> Sizes:
        """Sizes of logarithms."""
        return Sizes(**self.usual | dict(zip(self.free, np.exp(x).tolist(), strict=True)))

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
            self.bounds[step] = layout.bind(self.mean, self.total)
        return self.bounds[step]

    def __call__(self, x: Floats, bound: Bound | None = None) -> float:
        """-2 log of likelihood and prior for logarithms of the sizes, on a grid that fits their length or another."""
        sizes = self.sizes(x)
        minus = (bound or self.bound(sizes.form_length)).minus_log(sizes)
        if not math.isfinite(minus):
            return 1e12
        out = minus + self.freedom * math.log(sizes.white**2) + self.within / sizes.white**2
        for name, value in zip(self.free, x, strict=True):
            low, high, spread = self.prior[name]
            out += (max(low - value, value - high, 0.0) / spread) ** 2
        if self.gathered.parts == 1:
            over = math.log(_SHORTER * sizes.memory / sizes.form_length)
            out += (max(over, 0.0) / _BARRIER) ** 2
        return out

    def gradient(self, x: Floats, bound: Bound | None = None) -> tuple[float, Floats]:
        """Value and gradient, by differences on one grid: that of a layout, or the one that fits the length."""
        bound = bound or self.bound(math.exp(x[self.free.index("form_length")]))
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
            self.gradient,
            x,
            jac=True,
            method="L-BFGS-B",
            bounds=limits,
            options={"maxiter": rounds, "ftol": _FLAT / max(abs(self(x)), 1.0)},
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
                max(white * noise, 2 * g.least), max(noise, 1e-4), max(noise, 1e-4), max(noise, 1e-4),
            )  # fmt: skip
            x = likelihood.logs(sizes)
            begun.append((likelihood(x), len(begun), x))
        out.append(min(begun, key=lambda row: row[:2])[2])
    return out


def _suspects(gathered: Gathered, observed: Observed, half: int) -> Bools:
    """Points far off the median of `half` neighbours on either side, in units of what is usual; (n,)."""
    # Without the point itself: on a slope it is its own median, and nothing would be usual.
    beside = np.flatnonzero(np.arange(2 * half + 1) != half)
    block = gathered.cells.block[gathered.of]
    key = observed.stretch * (int(block.max(initial=0)) + 1) + block
    order = np.lexsort((observed.s, key))
    off, told = np.zeros(len(observed)), np.zeros(len(observed), dtype=bool)
    for rows in np.split(order, np.flatnonzero(np.diff(key[order])) + 1):
        if len(rows) < 2 * half + 3:
            continue
        told[rows] = True
        mode: Literal["wrap", "edge"] = "wrap" if gathered.stretches.closed[observed.stretch[rows[0]]] else "edge"
        value = observed.value[rows]
        # No rank filter of SciPy's: in one dimension 1.17.1 takes no notice of its footprint.
        around = np.lib.stride_tricks.sliding_window_view(np.pad(value, half, mode=mode), 2 * half + 1)
        for begin in range(0, len(rows), _AT_ONCE):
            progress.step()
            part = slice(begin, begin + _AT_ONCE)
            ranked = np.partition(around[part, beside], (half - 1, half), axis=1)
            off[rows[part]] = value[part] - 0.5 * ranked[:, half - 1 : half + 1].sum(axis=1)
    usual = 1.482602 * float(np.median(np.abs(off[told]))) if told.any() else 0.0
    out: Bools = np.abs(off) > _SUSPECT * max(usual, gathered.least)
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
    """Sizes found, with weights of the points and what they cost, and other maxima of the likelihood."""

    x: Floats
    weight: Floats
    cost: float
    others: tuple[Floats, ...] = ()


def _noise_of_one(sizes: Sizes, gap: float) -> float:
    """Variance of remembered noise at a point, mm2, about what neighbours every `gap` mm to both sides say of it.

    The harmonic mean of the spectrum is the variance of a value about all others (Grenander & Rosenblatt 1957).
    """
    if not gap > 0.0:
        return sizes.process**2
    rho, cosine = math.exp(-gap / sizes.memory), np.cos((np.arange(128) + 0.5) * math.pi / 128)
    spectrum = sizes.process**2 * (1 - rho**2) / (1 - 2 * rho * cosine + rho**2) + sizes.white**2
    return max(1.0 / float((1.0 / spectrum).mean()) - sizes.white**2, 0.0)


def _agreed(g: Gathered, off: Floats, variance: Floats, far: Ints) -> Floats:
    """How well other parts and heights agree with points that are far off: density of their standardised distance.

    Where the nearest point of most others is far off, too, that is form of the place or chance: one as well as the
    other, but for how unusual a form of that size is, as short as can just be told. If it is form, the point is off as
    that one is, and the nearest sound point would be, as far as it hangs together; the rest of it is as large again.

    Parameters
    ----------
    g : Gathered
    off, variance : (n,) float64
        Distance of all points from what is known without them, mm, and its variance.
    far : (m,) int64
        Points to look at.

    Returns
    -------
    (m,) float64
    """
    stretch, s, block = g.cells.stretch[g.of], g.cells.s[g.of], g.cells.block[g.of]
    blocks = np.unique(block)
    # A form shorter than the distance of one part's or height's points is not seen by it at all.
    reach = max(SHORTEST_FORM, g.spacing * len(blocks))
    is_far = np.zeros(len(off), dtype=bool)
    is_far[far] = True
    partner, apart = np.full((len(blocks), len(far)), -1), np.full((len(blocks), len(far)), math.inf)
    sound, between = np.zeros(len(far), dtype=np.int64), np.full(len(far), math.inf)
    order = np.lexsort((s, stretch, block))
    for rows in np.split(order, np.flatnonzero(np.diff(stretch[order]) | np.diff(block[order])) + 1):
        k, own = stretch[rows[0]], int(np.searchsorted(blocks, block[rows[0]]))
        here = np.flatnonzero(stretch[far] == k)
        period = float(g.stretches.lengths[k]) if g.stretches.closed[k] else math.inf

        def nearest(among: Ints, here: Ints = here, period: float = period) -> tuple[Ints, Floats]:
            after = np.searchsorted(s[among], s[far[here]])
            near = np.stack([among[after - 1], among[after % len(among)]])
            distance = np.abs(s[near] - s[far[here]])
            distance = np.minimum(distance, period - distance)
            nearer = distance.argmin(axis=0), np.arange(len(here))
            return near[nearer], distance[nearer]

        right = rows[~is_far[rows]]
        if len(right):
            near, distance = nearest(right)
            nearer = distance < between[here]
            sound[here[nearer]], between[here[nearer]] = near[nearer], distance[nearer]
        partner[own, here], apart[own, here] = nearest(rows)
        apart[own, here[block[far[here]] == block[rows[0]]]] = math.inf
    # Of those that have a point near the lower median, by how far they are off to the same side.
    same = np.where(apart <= reach, np.sign(off[far]) * off[partner], math.inf)
    number = (apart <= reach).sum(axis=0)
    middle = np.argsort(same, axis=0)[np.maximum(number - 1, 0) // 2, np.arange(len(far))]
    other, distance = partner[middle, np.arange(len(far))], apart[middle, np.arange(len(far))]

    def together(distance: Floats) -> Floats:
        z = math.sqrt(5.0) * np.where(np.isfinite(distance), distance, 1e3 * reach) / reach
        near: Floats = (1.0 + z + z * z / 3.0) * np.exp(-z)
        return near

    def density(left: Floats, variance: Floats) -> Floats:
        likely: Floats = np.exp(-0.5 * np.minimum(left**2 / variance, 1400.0)) / np.sqrt(2.0 * math.pi * variance)
        return likely

    usual = np.zeros(len(far))
    for name, value in (("form", np.maximum(np.abs(off[far]), 1e-9)), ("form_length", np.full(len(far), reach))):
        low, high, spread = _PRIOR[name]
        usual -= 0.5 * (np.maximum(np.maximum(low - np.log(value), np.log(value) - high), 0.0) / spread) ** 2
    rho, to_sound = together(distance), together(between)
    follows = density(off[far] - rho * off[other], (1.0 - rho**2) * off[other] ** 2 + variance[far] + variance[other])
    free = (1.0 - to_sound**2) * off[far] ** 2 + variance[sound]
    spared = density(off[sound] - to_sound * off[far], free) / density(off[sound], variance[sound])
    agreed = 0.5 * np.exp(usual) * rho**2 * follows * np.minimum(spared, 1.0) * np.sqrt(variance[far])
    out: Floats = np.where((number > 0) & is_far[other], agreed, 0.0)
    return out


def _judged(likelihood: Likelihood, x: Floats, weight: Floats, gap: float) -> tuple[Floats, Bools, float]:
    """Probability that each point is sound, (n,), if only because others agree, and what the wrong ones cost."""
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
    far, agreed = np.flatnonzero(sound < wrong), np.zeros(len(weight), dtype=bool)
    if g.parts * g.levels > 1 and len(far) > 1:
        sound[far] += _agreed(g, left * (1.0 + own * weight / v), v + own, far)
        agreed[far] = sound[far] > wrong[far]
    probability = sound / (sound + wrong)
    out = weight < 0.5
    cost = -2.0 * float(np.log(wrong[out] / np.sqrt(v + own[out])).sum())
    # What the likelihood has counted of them is theirs alone.
    cost -= float((np.log(v + 0.0 * own[out]) - np.log(np.maximum(weight[out], IGNORED))).sum())
    return probability, agreed, cost


def _settled(gathered: Gathered, weight: Floats, gap: float, x: Floats | None) -> Fit:
    """Weights and sizes renewed until they settle."""
    cost = math.inf
    others: tuple[Floats, ...] = ()
    for turn in range(_ROUNDS):
        likelihood = Likelihood(gathered, weight)
        if x is None:
            noise = _point_to_point(gathered, likelihood.mean)
            spread = float(np.sqrt(likelihood.total @ (likelihood.mean - np.average(
                likelihood.mean, weights=likelihood.total)) ** 2 / likelihood.total.sum()))  # fmt: skip
            found = [likelihood.minimum(start, _ROUNDS_OF_START) for start in _starts(likelihood, noise, spread)]
            found.sort(key=lambda row: row[0])
            # Some rounds come within some units of the end; starts that have met by then go on as one.
            hopeful = [
                row for i, row in enumerate(found)
                if row[0] < found[0][0] + _HOPEFUL
                and all(np.abs(row[1] - other[1]).max() > _MET for other in found[:i])
            ]  # fmt: skip
            ends = sorted((likelihood.minimum(row[1], _ROUNDS_OF_SEARCH) for row in hopeful), key=lambda row: row[0])
            value, x = ends[0]
            others = tuple(row[1] for row in ends[1:] if np.abs(row[1] - x).max() > _MET)
        else:
            value, x = likelihood.minimum(x, _ROUNDS_OF_START if turn else _ROUNDS_OF_SEARCH)
        if len(weight) < _FEW:
            return Fit(x, weight, value)
        probability, agreed, dear = _judged(likelihood, x, weight, gap)
        cost = value + dear
        renewed = np.maximum(probability, IGNORED)
        settled = float(np.abs(renewed - weight).max()) < _SETTLED
        if settled or turn == _ROUNDS - 1:
            return Fit(x, weight, cost, others)
        if (agreed & (weight < 0.5)).any():
            # What others agree with is form, and the form is another than that without it.
            x = None
        weight = renewed
    raise AssertionError


def _weights(gathered: Gathered, observed: Observed, x: Floats) -> Floats:
    """Trust in every point by what sizes say that were found from some of them; (n,)."""
    weight: Floats = np.where(_suspects(gathered, observed, max(_HALVES)), IGNORED, 1.0)
    for _ in range(2):
        probability, _, _ = _judged(Likelihood(gathered, weight), x, weight, gathered.spacing)
        weight = np.maximum(probability, IGNORED)
    return weight


def _carried(few: Gathered, found: Fit, all_points: Gathered) -> Fit:
    """What some of the points say, for all of them: of those a part or height may be missing."""
    begin, go_on = Likelihood(few, found.weight), Likelihood(all_points, np.ones(len(all_points.value)))
    x, *others = (go_on.logs(begin.sizes(x)) for x in (found.x, *found.others))
    return replace(found, x=x, others=tuple(others))


def _fitted(observed: Observed, stretches: Stretches) -> tuple[Gathered, Fit]:
    """Sizes and weights of the likeliest of the ways to begin, for all points."""
    gathered = Gathered(observed, stretches, MOST_CELLS)
    if len(observed) > MANY:
        # Sizes from a share of the points, evenly among all; then every point is judged by what they say.
        order = np.lexsort((observed.s, observed.stretch, observed.level, observed.part))
        few, found = _fitted(observed.take(np.sort(order[:: -(-len(order) // MANY)])), stretches)
        found = _carried(few, found, gathered)
        return gathered, replace(found, weight=_weights(gathered, observed, found.x))
    if gathered.parts > SEARCHED_PARTS:
        first = observed.part <= np.unique(observed.part)[SEARCHED_PARTS - 1]
        few, found = _fitted(observed.take(np.flatnonzero(first)), stretches)
        found = _carried(few, found, gathered)
        weight = _weights(gathered, observed, found.x)
        x = Likelihood(gathered, weight).minimum(found.x, _ROUNDS_OF_SEARCH)[1]
        return gathered, replace(found, x=x, weight=weight)
    few = gathered if len(observed) <= SEARCHED else Gathered(observed, stretches, SEARCHED)
    best, many = _likeliest(few, gathered, observed)
    sizes = Likelihood(few, best.weight).sizes(best.x)
    if many and math.hypot(sizes.process, sizes.white) < SMOOTHEST:
        milled, _ = _likeliest(few.no_smoother(SMOOTHEST), gathered.no_smoother(SMOOTHEST), observed)
        best = _settled(few, milled.weight, few.spacing, None)
    if few is gathered:
        return gathered, best
    return gathered, replace(best, x=Likelihood(gathered, best.weight).minimum(best.x, _ROUNDS_OF_START)[1])


def _likeliest(few: Gathered, gathered: Gathered, observed: Observed) -> tuple[Fit, bool]:
    """The likeliest of the fits that different outliers lead to, and whether many points were suspects."""
    begun: list[Bools] = []
    fits: list[Fit] = []
    none = np.zeros(len(observed), dtype=bool)
    for half in _HALVES:
        wrong = _suspects(gathered, observed, half) if len(observed) >= _FEW else none
        if not any(np.array_equal(wrong, other) for other in begun):
            begun.append(wrong)
            fits.append(_settled(few, np.where(wrong, IGNORED, 1.0), few.spacing, fits[0].x if fits else None))
            if not wrong.any() and fits[-1].weight.min() >= 0.5:
                # Nothing stands out, neither beforehand nor of what was found.
                break
    many = max(wrong.mean() for wrong in begun) > MANY_SUSPECTS
    if many:
        # Where all but some humps is flat to a hair, every point of a hump stands out, and the humps are form.
        fits.append(_settled(few, np.ones(len(observed)), few.spacing, None))
    return min(fits, key=lambda fit: fit.cost), many


CERTAIN = 0.0027
"""Odds of chance below which heights are said to differ: three standard uncertainties of one number."""


@dataclass(frozen=True, eq=False, slots=True)
class LevelDifference:
    """How a height differs from the mean of all heights, on the average along the measured contours.

    Parameters
    ----------
    level : int
    mean, std : float
        mm, and its standard uncertainty.
    """

    level: int
    mean: float
    std: float

    @property
    def significant(self) -> bool:
        """Whether the difference is more than chance: three standard uncertainties."""
        return abs(self.mean) > 3.0 * self.std


@dataclass(frozen=True, eq=False, slots=True)
class Lean:
    """By how much the highest level has more than the lowest, along the measured contours.

    Parameters
    ----------
    low, high : int
        The levels.
    stretch : (m,) int64
    s, difference, std : (m,) float64
        Place, the difference there and its standard uncertainty, mm.
    band : float
        Factor on the standard uncertainty that chance exceeds anywhere with `CERTAIN`.
    """

    low: int
    high: int
    stretch: Ints
    s: Floats
    difference: Floats
    std: Floats
    band: float

    @property
    def significant(self) -> Bools:
        """Where the difference is more than chance; (m,)."""
        out: Bools = np.abs(self.difference) > self.band * self.std
        return out


@dataclass(frozen=True, eq=False, slots=True)
class Grid:
    """Places where it is worked out how well the systematic part is known.

    Parameters
    ----------
    stretch : (m,) int64
    s : (m,) float64
        mm.
    std : (m,) float64
        Standard uncertainty, mm.
    unknown : (m,) float64
        How much less is known than at the contour's place known best, as a share of the form's variance.
    """

    stretch: Ints
    s: Floats
    std: Floats
    unknown: Floats


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
        Factor on the standard uncertainty for a band that holds along the whole contour with 95 %, as long as the
        process remembers no more than `longest_memory`.
    levels : tuple of LevelDifference
        One a level where there are several.
    lean : Lean or None
        Where there are several levels.
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
    lean: Lean | None
    notes: tuple[str, ...]
    _bound: Bound
    _solved: Solved
    _contours: Ints
    _grid: Grid
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

    @property
    def longest_memory(self) -> float:
        """Longest memory of the process, mm, for which the uncertainty holds.

        One part at one height does not tell noise remembered over more than a quarter of the form's length from form;
        of several it is what they do not share. Infinite there.
        """
        several = np.ptp(self.observed.part) > 0 or np.ptp(self.observed.level) > 0
        return math.inf if several else self.sizes.form_length / _TOLD

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
        progress.step()
        stretch, s = np.asarray(stretch, dtype=np.int64), np.asarray(s, dtype=np.float64)
        column, known = _columns(self.stretches, self._contours, stretch)
        mean = np.where(known, self._bound.mean(self._solved, stretch, s, column), 0.0)
        for k in np.unique(stretch):
            rows = stretch == k
            more = self._more[k] if self._more else None
            if more is not None:
                mean[rows] += _interpolated(s[rows], more, self._period(k))
        return mean, self._from_grid(self._grid.std, stretch, s)

    def unknown(self, stretch: Ints, s: Floats) -> Floats:
        """How much less is known at any place than where most is, as a share of the form's variance, 0 to 1; (m,).

        How well the offsets of all parts and heights are known is no matter of the place. NaN on a contour without
        points.
        """
        return self._from_grid(self._grid.unknown, np.asarray(stretch, dtype=np.int64), np.asarray(s, dtype=np.float64))

    def _from_grid(self, value: Floats, stretch: Ints, s: Floats) -> Floats:
        out = np.full(len(s), math.nan)
        for k in np.unique(stretch):
            rows, here = stretch == k, self._grid.stretch == k
            if here.any():
                out[rows] = _interpolated(s[rows], (self._grid.s[here], value[here]), self._period(k))
        return out

    def _period(self, k: int) -> float | None:
        return float(self.stretches.lengths[k]) if self.stretches.closed[k] else None


def _columns(stretches: Stretches, contours: Ints, stretch: Ints) -> tuple[Ints, Bools]:
    """Column of the mean of each stretch's contour, and whether it has one."""
    contour = stretches.contour[stretch]
    at = np.minimum(np.searchsorted(contours, contour), len(contours) - 1)
    return at.astype(np.int64), contours[at] == contour


def _interpolated(s: Floats, course: tuple[Floats, Floats], period: float | None) -> Floats:
    """Shape-preserving cubic through values at increasing places; held beyond the ends of an open stretch."""
    progress.step()
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


def _whole_band(length: float, outside: float = 0.05) -> float:
    """Factor that chance exceeds anywhere with odds `outside`, from the length of the path of the standardised error.

    Sun & Loader 1994, eq. 2.1: P(max |t| > k) = 2 (1 - Phi(k)) a stretch + length / pi exp(-k^2/2), both at most.
    """
    from scipy.optimize import brentq
    from scipy.special import ndtr

    def over(k: float) -> float:
        return 2.0 * float(ndtr(-k)) + length / math.pi * math.exp(-0.5 * k * k) - outside

    return float(brentq(over, 1.9, 10.0))


def _turned(covariance: Floats, variance: Floats) -> float:
    """Length of the path of a standardised error, from its covariances from place to place and its variances."""
    return float(np.arccos(np.clip(covariance / np.maximum(variance, 1e-30), -1.0, 1.0)).sum())


def _path(variance: Floats, along: Floats, of: Ints) -> float:
    """The same from place to place of all stretches, from variances and each place's covariance with the next."""
    same = of[1:] == of[:-1]
    return _turned(along[:-1][same], np.sqrt(np.maximum(variance[:-1] * variance[1:], 0.0))[same])


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
    fine, coarse = Likelihood(gathered, fit.weight, NODES), Likelihood(gathered, fit.weight)
    peak = _peak(fine, fit.x)
    drawn = _drawn(coarse, peak, fit.others)
    if count is not None:
        # What the sizes are, all parts say alike; parts that count otherwise do so for the posterior alone.
        seen = gathered.counting(count)
        fine, coarse = Likelihood(seen, fit.weight, NODES), Likelihood(seen, fit.weight)
    sizes = fine.sizes(peak.x)
    bound = fine.bound(sizes.form_length)
    solved = bound.solve(sizes)
    assert solved is not None
    of, at = _places(stretches, gathered.contours, sizes.form_length)
    column, _ = _columns(stretches, gathered.contours, of)
    variance, along = bound.variance(solved, of, at, column)
    band = _whole_band(_path(variance, along, of))
    variance = _over_sizes(coarse, drawn, bound.mean(solved, of, at, column), variance, of, at, column)
    # What is as open at the place known best, as the offset of all parts is, is no matter of the place.
    least = np.full(column.max(initial=-1) + 1, np.inf)
    np.minimum.at(least, column, variance)
    unknown = np.clip((variance - least[column]) / sizes.form**2, 0.0, 1.0)
    out = Separated(
        observed, stretches, filter, np.zeros(0), np.zeros(0), fit.weight, sizes, band,
        _level_differences(observed, gathered, bound, solved), _lean(observed, gathered, bound, solved, of, at), (),
        bound, solved, gathered.contours,
        Grid(of, at, np.sqrt(np.maximum(variance, 0.0)), unknown), (),
    )  # fmt: skip
    mean, std = out.at(observed.stretch, observed.s)
    if filter.kind == "auto":
        return replace(out, systematic=mean, uncertainty=std)
    return _prescribed(out, mean, count)


@dataclass(frozen=True, eq=False, slots=True)
class Peak:
    """The likeliest sizes, in logarithms, and how well the values tell them.

    Parameters
    ----------
    x : (k,) float64
    axes : (j, j) float64
        Directions of the first j sizes, all but the offsets', in columns: in each the likelihood falls by itself.
    spread : (j,) float64
        Standard deviations in these directions, from the curvature (Laplace; Rasmussen & Williams 2006, 5.2).
    """

    x: Floats
    axes: Floats
    spread: Floats


def _peak(likelihood: Likelihood, x: Floats) -> Peak:
    """Curvature of the likelihood, and with it the last steps to its maximum."""
    n = len(x)
    bound = likelihood.bound(math.exp(x[likelihood.free.index("form_length")]))
    step = 0.1
    unit = step * np.eye(n)
    here = likelihood(x, bound)
    plus = np.array([likelihood(x + unit[i], bound) for i in range(n)])
    minus = np.array([likelihood(x - unit[i], bound) for i in range(n)])
    curve = np.empty((n, n))
    for i in range(n):
        curve[i, i] = plus[i] - 2 * here + minus[i]
        for j in range(i):
            both = likelihood(x + unit[i] + unit[j], bound) + likelihood(x - unit[i] - unit[j], bound)
            curve[i, j] = curve[j, i] = 0.5 * (both - plus[i] - plus[j] - minus[i] - minus[j]) + here
    curve /= step**2
    form_and_noise = np.flatnonzero([name not in ("part", "level") for name in likelihood.free])
    value, axes = np.linalg.eigh(0.5 * curve[np.ix_(form_and_noise, form_and_noise)])
    # The priors know a logarithm to 1.5: no direction is known worse.
    value = np.maximum(value, 1.0 / 1.5**2)
    return Peak(_nearer(likelihood, bound, x, curve), axes, 1.0 / np.sqrt(value))


def _nearer(likelihood: Likelihood, bound: Bound, x: Floats, curve: Floats) -> Floats:
    """Newton's steps to the maximum, from the curvature of -2 log likelihood near it, (k, k).

    A size at its bound that would be beyond it stays there, and the others go where the likelihood is largest for that.
    """
    low, high = np.array(likelihood.limits()).T
    for _ in range(_ROUNDS):
        # By a small step: over that of the curvature the slope is off by more than is left of it.
        here, slope = likelihood.gradient(x, bound)
        free = np.flatnonzero(np.where(slope > 0.0, x > low, x < high))
        value, axes = np.linalg.eigh(curve[np.ix_(free, free)])
        step = np.zeros(len(x))
        step[free] = axes @ (axes.T @ slope[free] / np.maximum(value, 2.0 / 1.5**2))
        for share in (1.0, 0.5, 0.25, 0.125):
            moved = np.clip(x - share * step, low, high)
            there = likelihood(moved, bound)
            if there < here:
                break
        else:
            return x
        x = moved
        if here - there < 0.01 * _FLAT:
            return x
    return x


def _drawn(likelihood: Likelihood, peak: Peak, others: tuple[Floats, ...]) -> tuple[Floats, Floats]:
    """Logarithms of sizes that the values allow, (m, k), and their shares, (m,).

    Importance sampling (Gelman et al. 2013, 10.4): drawn evenly and the same every time (Roberts' additive
    recurrence) from a normal distribution with the curvature of the likelihood at its maximum, a little wider, they
    weigh as their likelihood is to the density of that distribution. Other maxima count as this one would, were it
    their height.
    """
    from scipy.special import ndtri

    n = len(peak.spread)
    ratio = 2.0
    for _ in range(40):
        ratio = (1.0 + ratio) ** (1.0 / (n + 1))
    z = ndtri((0.5 + np.arange(DRAWN)[:, None] * ratio ** -np.arange(1.0, n + 1)) % 1.0)
    drawn = np.tile(peak.x, (DRAWN, 1))
    drawn[:, :n] += (z * WIDER * peak.spread) @ peak.axes.T
    low, high = np.array(likelihood.limits()).T
    drawn = np.clip(np.concatenate([drawn, *(x[None] for x in others)]), low, high)
    density = np.append(-0.5 * (z**2).sum(axis=1), np.full(len(others), n * math.log(WIDER) - math.log(DRAWN)))
    logs = -0.5 * np.array([likelihood(x) for x in drawn]) - density
    if likelihood.gathered.parts * likelihood.gathered.levels == 1:
        # Evenly likely in mm, not in its logarithm: one part hardly tells 1.5 mm from 6, and a band too narrow costs
        # more than one too wide.
        logs += drawn[:, likelihood.free.index("memory")]
    share = np.exp(logs - logs.max())
    kept = np.flatnonzero(share > NEGLIGIBLE)
    return drawn[kept], share[kept] / share[kept].sum()


def _over_sizes(
    likelihood: Likelihood,
    drawn: tuple[Floats, Floats],
    mean: Floats,
    variance: Floats,
    of: Ints,
    at: Floats,
    column: Ints,
) -> Floats:
    """Variance of the systematic part at places over all sizes that the values allow, mm2; (m,).

    From mean and variance at the likeliest sizes, (m,) each. It is that of the normal distribution about that mean
    with the same 95 % interval: what is likely at some sizes and wide at few has a variance much wider than its band.
    """
    from scipy.special import ndtr

    logs, share = drawn
    # The variance over the sizes is to that at the likeliest as smooth as the form: four places in its length suffice.
    ends = np.flatnonzero(np.diff(of, prepend=-1, append=-1))
    few = np.unique(np.concatenate([np.arange(0, len(of), 2), ends[:-1], ends[1:] - 1]))
    off, std = np.zeros((len(logs), len(few), 1)), np.zeros((len(logs), len(few), 1))
    for k, row in enumerate(logs):
        sizes = likelihood.sizes(row)
        bound = likelihood.bound(sizes.form_length)
        solved = bound.solve(sizes)
        assert solved is not None
        place = of[few], at[few], column[few]
        off[k, :, 0] = bound.mean(solved, *place) - mean[few]
        std[k, :, 0] = np.sqrt(bound.variance(solved, *place)[0])
    low, high = np.zeros(len(few)), 2.3 * np.sqrt(np.einsum("k,kma->m", share, off**2 + std**2))
    # Half widths within which so much lies, by halving; by Chebyshev no more than sqrt(20) standard deviations.
    for _ in range(12):
        middle = 0.5 * (low + high)
        edge = NORMAL_95 * middle[:, None] * np.array([-1.0, 1.0])
        inside = share @ np.diff(ndtr((edge - off) / std))[:, :, 0]
        low, high = np.where(inside < 0.95, middle, low), np.where(inside < 0.95, high, middle)
    out: Floats = variance * np.interp(np.arange(len(of)), few, high**2 / variance[few])
    return out


def _level_differences(
    observed: Observed, gathered: Gathered, bound: Bound, solved: Solved
) -> tuple[LevelDifference, ...]:
    kinds = np.flatnonzero(gathered.kind == 2)
    if not len(kinds):
        return ()
    unit = np.zeros((len(kinds), len(gathered.kind)))
    unit[:, kinds] = np.eye(len(kinds)) - 1.0 / len(kinds)
    # The lean at all places with points, times each level's place between the outermost.
    of, at, share = bound.layout.cells.stretch, bound.layout.cells.s, bound.weight / bound.weight.sum()
    rows, a = bound.layout.read(of, at)
    lean = (solved.sizes.lean * share[:, None] * a).ravel()
    rows, lean = np.tile(rows.ravel() + 3, (len(kinds), 1)), gathered.across[:, None] * lean
    mean = (lean * solved.state[rows]).sum(axis=1) + unit @ solved.constants
    variance, _ = bound.variance_of(solved, rows, lean, unit)
    return tuple(
        LevelDifference(int(level), float(m), math.sqrt(max(u, 0.0)))
        for level, m, u in zip(np.unique(observed.level), mean, variance, strict=True)
    )


def _lean(observed: Observed, gathered: Gathered, bound: Bound, solved: Solved, of: Ints, at: Floats) -> Lean | None:
    """The lean at places, of stretches that several heights were measured on."""
    kinds = np.flatnonzero(gathered.kind == 2)
    if not len(kinds):
        return None
    both = [k for k in np.unique(observed.stretch) if np.ptp(observed.level[observed.stretch == k])]
    here = np.isin(of, both)
    if not here.any():
        return None
    low, high = int(np.argmin(gathered.across)), int(np.argmax(gathered.across))
    unit = np.zeros(len(gathered.kind))
    unit[kinds[[low, high]]] = -1.0, 1.0
    mean, variance, along = bound.lean(solved, of[here], at[here], unit)
    band = _whole_band(_path(variance, along, of[here]), CERTAIN)
    levels = np.unique(observed.level)
    std = np.sqrt(np.maximum(variance, 0.0))
    return Lean(int(levels[low]), int(levels[high]), of[here], at[here], mean, std, band)


def _prescribed(out: Separated, model: Floats, count: Floats | None) -> Separated:
    """Values of a prescribed filter at the points; the model carries on what it differs by."""
    progress.step()
    observed, stretches = out.observed, out.stretches
    value = np.empty(len(observed))
    uncertainty = np.empty(len(observed))
    more: list[tuple[Floats, Floats] | None] = [None] * len(stretches.lengths)
    turned = 0.0
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
        if len(course[1]) > 1:
            # From point to point the model's error stays, what the filter adds changes.
            along = float(np.mean(std**2) + np.mean(course[1][1:] * course[1][:-1]))
            turned += len(course[1]) * _turned(np.array(along), np.array(np.mean(uncertainty[here] ** 2)))
    wider = np.array([0.0 if c is None else float(np.mean(c[1] ** 2)) for c in more])
    grid = replace(out._grid, std=np.sqrt(out._grid.std**2 + wider[out._grid.stretch]))
    band = max(out.band, _whole_band(turned))
    return replace(out, systematic=value, uncertainty=uncertainty, band=band, _grid=grid, _more=tuple(more))


def _through(s: Floats, value: Floats, length: float, closed: bool) -> tuple[Floats, Floats]:
    """Places in order with the mean of the values there; those that nearly coincide are one."""
    s = np.mod(s, length) if closed else s
    group = np.floor(s / COINCIDING)
    _, inverse, count = np.unique(group, return_inverse=True, return_counts=True)
    return np.bincount(inverse, s) / count, np.bincount(inverse, value) / count


def interpolated(s: Floats, value: Floats, length: float, closed: bool, at: Floats) -> Floats:
    """Values at places through values at points of one stretch, those at one place averaged; mm. (m,)."""
    progress.step()
    return _interpolated(at, _through(s, value, length, closed), length if closed else None)
