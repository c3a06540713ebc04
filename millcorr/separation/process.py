# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaussian process along smooth stretches with a banded precision: form, noise with a memory, white noise.

The form is a Matern 5/2 process, kept as value and two derivatives at the nodes of a regular grid (state space:
Hartikainen & Sarkka 2010; Sarkka & Solin 2019, ch. 12) and read between them by the quintic through two nodes, which
is what the process itself says there as the grid becomes narrow. Where several heights are measured, a second process
of the same length, the lean, stands beside it at the same nodes and is read with the sign and share of each height. The
noise with a memory is an Ornstein-Uhlenbeck
process at the points, one for every part and level. Constants (means, offsets) are columns beside the band. A closed
stretch is a ring, folded flat: places equally far from the seam to both sides are neighbours in the band.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats, Ints

ROOT = math.sqrt(5.0)

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_NODES, _WEIGHTS = (_NODES + 1.0) / 2.0, _WEIGHTS / 2.0
_LOWER = np.tril_indices(3)
_EYE = np.eye(3)

# Value, slope and bend at both ends of the unit interval to the powers of the quintic between them.
_QUINTIC = np.linalg.inv(
    np.array(
        [
            [1, 0, 0, 0, 0, 0],
            [0, 1, 0, 0, 0, 0],
            [0, 0, 2, 0, 0, 0],
            [1, 1, 1, 1, 1, 1],
            [0, 1, 2, 3, 4, 5],
            [0, 0, 2, 6, 12, 20],
        ],
        dtype=np.float64,
    )
).T
_CHUNK = 256

_LINK = 4.0
"""Steps of the form's grid that neighbouring states of the noise are apart at most: over a gap it has states without
points, or the band were as wide as the gap has nodes."""


@dataclass(frozen=True, slots=True)
class Sizes:
    """Standard deviations in mm and lengths in mm.

    Parameters
    ----------
    form, form_length : float
        Standard deviation and length of the Matern 5/2 process (Rasmussen & Williams 2006, eq. 4.17).
    process, memory : float
        Standard deviation of the noise with a memory, and the distance over which its correlation falls to 1/e.
    white : float
        Standard deviation of the white noise of a point of weight 1.
    part, level : float
        Standard deviation of the offsets of whole parts and of whole levels.
    lean : float
        Standard deviation of how the form at the highest level differs from that at the lowest.
    """

    form: float
    form_length: float
    process: float
    memory: float
    white: float
    part: float
    level: float
    lean: float


@dataclass(frozen=True, eq=False, slots=True)
class Cells:
    """Points gathered to the places where the process is looked at.

    Parameters
    ----------
    stretch, block : (n,) int64
        Smooth stretch; part and level together.
    s : (n,) float64
        mm from the stretch's start, increasing within each stretch and block.
    columns : (n, k) float64
        1 where a constant (mean of a contour, offset of a part, of a level) belongs to the place.
    kind : (k,) int64
        What each column is: 0 the mean of a contour, 1 a part's offset, 2 a level's.
    across : (n,) float64
        How far each place is above the mean of the levels, in units of the distance of the highest from the lowest; 0
        everywhere where there is one.
    scale : (n,) float64
        How many times as large as it is the systematic part is seen at each place; the noise is seen as it is.
    """

    stretch: Ints
    block: Ints
    s: Floats
    columns: Floats
    kind: Ints
    across: Floats
    scale: Floats


@dataclass(frozen=True, eq=False, slots=True)
class Solved:
    """The posterior for given sizes, kept as a factor.

    Parameters
    ----------
    minus_log : float
        -2 log of the restricted likelihood, but for a constant.
    factor : (w + 1, N) float64
        Cholesky factor of the posterior precision of the unit processes, lower band.
    state : (N,) float64
        Posterior mean of the unit processes.
    constants : (k,) float64
        Posterior mean of the constants, mm.
    spread : (k, k) float64
        Their covariance, mm2.
    answer : (N, k) float64
        Change of the state for a constant of 1 mm, negative.
    """

    minus_log: float
    factor: Floats
    state: Floats
    constants: Floats
    spread: Floats
    answer: Floats
    sizes: Sizes


class Layout:
    """Grid of the form and places of the points in one band, for lengths of the form near `step` times eight.

    Parameters
    ----------
    cells : Cells
    lengths : (K,) float64
        mm, of all stretches.
    closed : (K,) bool
    step : float
        Largest distance of two nodes, mm.
    """

    def __init__(self, cells: Cells, lengths: Floats, closed: Bools, step: float) -> None:
        self.cells, self.lengths, self.closed = cells, lengths, closed
        self.leans = bool(cells.across.any())
        number = np.maximum(np.ceil(lengths / step - 1e-9).astype(np.int64), np.where(closed, 4, 1))
        self.number, self.step = number, lengths / number
        nodes = number + ~closed
        self.first = np.concatenate([[0], np.cumsum(nodes)])
        of = np.repeat(np.arange(len(lengths)), nodes)
        at = (np.arange(len(of)) - self.first[of]) * self.step[of]
        self._bridge()
        self._order(of, at)
        self._links()
        self._memory()
        row, weight = self.read(cells.stretch, cells.s)
        weight = cells.scale[:, None] * weight
        # What a place is read from: the form, the lean where there is one, its noise with a memory.
        self.reads = [(row, weight)]
        if self.leans:
            self.reads.append((row + 3, cells.across[:, None] * weight))
        self.reads.append((self.own[:, None], np.ones((len(row), 1))))

    def _bridge(self) -> None:
        """Places of the noise with a memory: those of the points, then some in every gap between them."""
        c = self.cells
        order = np.lexsort((c.s, c.stretch, c.block))
        stretch, block, s = c.stretch[order], c.block[order], c.s[order]
        last = np.append((stretch[1:] != stretch[:-1]) | (block[1:] != block[:-1]), True)[: len(s)]
        first = np.flatnonzero(np.append(True, last[:-1])[: len(s)])
        # Behind the last point of a ring comes its first one.
        behind = np.append(s[1:], 0.0)[: len(s)]
        behind[last] = np.where(self.closed[stretch[last]], s[first] + self.lengths[stretch[last]], s[last])
        gap = behind - s
        more = np.maximum(np.ceil(gap / (_LINK * self.step[stretch])).astype(np.int64) - 1, 0)
        row = np.repeat(np.arange(len(s)), more)
        part = np.arange(len(row)) - np.repeat(np.cumsum(more) - more, more) + 1
        between = s[row] + gap[row] * part / (more[row] + 1)
        length = self.lengths[stretch[row]]
        between = np.where(between >= length, between - length, between)
        self.noise_stretch = np.concatenate([c.stretch, stretch[row]])
        self.noise_block = np.concatenate([c.block, block[row]])
        self.noise_s = np.concatenate([c.s, between])

    def _order(self, of: Ints, at: Floats) -> None:
        """Rows of the band, by stretch and place; the two halves of a ring side by side."""
        stretch, s = np.concatenate([of, self.noise_stretch]), np.concatenate([at, self.noise_s])
        length = self.lengths[stretch]
        s = np.where(self.closed[stretch], np.minimum(s, length - s), s)
        order = np.lexsort((s, stretch))
        count = np.concatenate([np.full(len(of), 6 if self.leans else 3), np.ones(len(self.noise_s), dtype=np.int64)])
        start = np.empty(len(order), dtype=np.int64)
        start[order] = np.cumsum(count[order]) - count[order]
        self.size = int(count.sum())
        self.node, self.noise = start[: len(of)], start[len(of) :]
        self.own = self.noise[: len(self.cells.s)]

    def _links(self) -> None:
        """Neighbouring nodes of the form, and where their numbers stand."""
        last = np.where(self.closed, self.first[1:] - 1, self.first[1:] - 2)
        k = np.repeat(np.arange(len(self.lengths)), self.number)
        a = np.arange(len(k)) - (np.cumsum(self.number) - self.number)[k] + self.first[k]
        b = np.where((a == last[k]) & self.closed[k], self.first[k], a + 1)
        self.link_stretch = k
        self.link = (self.node[a], self.node[b])
        self.begin = self.node[self.first[:-1][~self.closed]]

    def _memory(self) -> None:
        """Neighbouring points of one part and level."""
        stretch, block = self.noise_stretch, self.noise_block
        key = stretch * (int(block.max(initial=0)) + 1) + block
        order = np.lexsort((self.noise_s, key))
        key, s = key[order], self.noise_s[order]
        same = key[1:] == key[:-1]
        starts = np.flatnonzero(np.concatenate([[True], ~same])) if len(key) else np.zeros(0, dtype=np.int64)
        ends = np.append(starts[1:], len(key)) - 1
        self.chain_gap = [s[1:][same] - s[:-1][same]]
        chain = [(order[:-1][same], order[1:][same])]
        ring = self.closed[stretch[order[starts]]]
        self.ring_length = self.lengths[stretch[order[starts]]][ring]
        self.chain_gap.append(s[starts[ring]] + self.ring_length - s[ends[ring]])
        chain.append((order[ends[ring]], order[starts[ring]]))
        self.gap = np.concatenate(self.chain_gap)
        self.pair = tuple(self.noise[np.concatenate([p[i] for p in chain])] for i in (0, 1))
        self.head = self.noise[order[starts[~ring]]]

    def _cell(self, stretch: Ints, s: Floats) -> tuple[Ints, Floats]:
        """Link that each place lies on, and how far it lies along it, 0 to 1; (n,) each."""
        s = np.where(self.closed[stretch], np.mod(s, self.lengths[stretch]), np.clip(s, 0.0, self.lengths[stretch]))
        x = s / self.step[stretch]
        i = np.minimum(x.astype(np.int64), self.number[stretch] - 1)
        return (np.cumsum(self.number) - self.number)[stretch] + i, x - i

    def _states(self) -> Ints:
        """Rows of the six states at both ends of every link; (links, 6)."""
        three = np.arange(3)
        return np.concatenate([self.link[0][:, None] + three, self.link[1][:, None] + three], axis=1)

    def read(self, stretch: Ints, s: Floats) -> tuple[Ints, Floats]:
        """Rows of the six states that a place is read from, (n, 6), and their weights, (n, 6)."""
        link, u = self._cell(stretch, s)
        weight: Floats = (u[:, None] ** np.arange(6)) @ _QUINTIC.T
        return self._states()[link], weight

    def value(self, state: Floats, stretch: Ints, s: Floats) -> Floats:
        """The form at places, in the unit of the state; (n,)."""
        link, u = self._cell(stretch, s)
        power = state[self._states()] @ _QUINTIC
        out: Floats = power[link, 5]
        for k in (4, 3, 2, 1, 0):
            out = out * u + power[link, k]
        return out

    def bind(self, value: Floats, weight: Floats) -> Bound:
        """Data at the cells: means, mm, and weights (1/weight times the white variance is a mean's own)."""
        return Bound(self, value, weight)


class Bound:
    """A layout with data: the likelihood and the posterior for any sizes.

    Made by `Layout.bind`.
    """

    def __init__(self, layout: Layout, value: Floats, weight: Floats) -> None:
        self.layout, self.value, self.weight = layout, value, weight
        self.offsets = [np.flatnonzero(layout.cells.kind == kind) for kind in range(3)]
        # Of each two of form, lean and noise the numbers of the matrix that the data add to; of one with itself half.
        pairs = []
        for g, (rows, a) in enumerate(layout.reads):
            for h, (others, b) in enumerate(layout.reads[: g + 1]):
                i, j = np.tril_indices(rows.shape[1]) if g == h else np.indices((rows.shape[1], others.shape[1]))
                i, j = i.ravel(), j.ravel()
                pairs.append((rows[:, i], others[:, j], weight[:, None] * a[:, i] * b[:, j]))
        self.read_of = [(g, h) for g in range(len(layout.reads)) for h in range(g + 1)]
        three = np.arange(3)
        links = []
        for more in (0, 3) if layout.leans else (0,):
            la, lb = (x + more for x in layout.link)
            begin = layout.begin + more
            links += [
                (la[:, None] + _LOWER[0], la[:, None] + _LOWER[1]),
                (lb[:, None] + _LOWER[0], lb[:, None] + _LOWER[1]),
                (np.repeat(lb[:, None] + three, 3, axis=1), np.tile(la[:, None] + three, (1, 3))),
                (begin[:, None] + _LOWER[0], begin[:, None] + _LOWER[1]),
            ]
        p, q = layout.pair
        everything = [*((x, y) for x, y, _ in pairs), *links, (p, q)]
        self.band = max((int(np.abs(x - y).max(initial=0)) for x, y in everything), default=0)
        size = layout.size
        self.shape = (self.band + 1, size)

        def place(x: Ints, y: Ints) -> Ints:
            out: Ints = (np.abs(x - y) * size + np.minimum(x, y)).ravel()
            return out

        total = self.shape[0] * size
        self.data = np.stack([np.bincount(place(x, y), np.ascontiguousarray(w).ravel(), total) for x, y, w in pairs])
        # Both sides of a ring of a single point are the same number of the matrix, and count twice on its diagonal.
        self.twice = np.where(p == q, 2.0, 1.0)
        self.form_place = np.concatenate([place(x, y) for x, y in links])
        self.memory_place = np.concatenate([place(p, p), place(q, q), place(p, q), place(layout.head, layout.head)])
        right = np.column_stack([value, layout.cells.columns])
        self.right = right
        weighted = weight[:, None] * right
        self.rights = np.array(
            [
                [np.bincount(rows.ravel(), (a * weighted[:, [c]]).ravel(), size) for c in range(right.shape[1])]
                for rows, a in layout.reads
            ]
        ).transpose(0, 2, 1)
        self.normal = right.T @ weighted
        self.log_weight = float(np.log(weight).sum())
        self.forms: dict[float, tuple[Floats, float]] = {}
        self.memories: dict[float, tuple[Floats, float]] = {}

    def prior(self, form_length: float, memory: float) -> tuple[Floats, float]:
        """Precision of the unit processes, lower band, and the logarithm of its determinant."""
        # Of neighbouring sizes only one changes at a time.
        if form_length not in self.forms:
            self.forms = {**dict(list(self.forms.items())[-1:]), form_length: self._form(form_length)}
        if memory not in self.memories:
            self.memories = {**dict(list(self.memories.items())[-1:]), memory: self._memory(memory)}
        (form, log_form), (process, log_process) = self.forms[form_length], self.memories[memory]
        return form + process, log_form + log_process

    def _form(self, form_length: float) -> tuple[Floats, float]:
        layout = self.layout
        z = ROOT * layout.step / form_length
        t = _NODES
        decay = np.exp(-z[:, None] * t)
        zt = z[:, None] * t
        column = decay * np.stack([np.broadcast_to(t * t / 2, zt.shape), t - zt * t / 2, 1 - 2 * zt + zt * zt / 2])
        column = column.transpose(1, 0, 2)  # (K, 3, 8)
        noise = (column * _WEIGHTS) @ column.transpose(0, 2, 1) * (16.0 / 3.0 * z**5)[:, None, None]
        shift = np.zeros((len(z), 3, 3))
        shift[:, 0, 1] = shift[:, 1, 2] = 1.0
        shift[:, 2] = np.stack([-(z**3), -3 * z**2, -3 * z], axis=1)
        nil = shift + z[:, None, None] * _EYE
        turn = np.exp(-z)[:, None, None] * (_EYE + nil + 0.5 * nil @ nil)
        back = np.linalg.inv(noise)
        back = 0.5 * (back + back.transpose(0, 2, 1))
        first = turn.transpose(0, 2, 1) @ back @ turn
        across = back @ turn
        # Inverse of the covariance ((1, 0, -a), (0, a, 0), (-a, 0, z^4)), a = z^2 / 3, of the states at an open end.
        a, rest = z**2 / 3, 8.0 / 9.0 * z**4
        nil_end = np.zeros_like(z)
        at_begin = np.stack([z**4 / rest, nil_end, 1.0 / a, a / rest, nil_end, 1.0 / rest], axis=1)
        k, open_ = layout.link_stretch, ~layout.closed
        values = np.concatenate(
            [
                first[:, _LOWER[0], _LOWER[1]][k].ravel(),
                back[:, _LOWER[0], _LOWER[1]][k].ravel(),
                -across.reshape(-1, 9)[k].ravel(),
                at_begin[open_].ravel(),
            ]
        )
        total, times = self.shape[0] * self.shape[1], 2 if layout.leans else 1
        band: Floats = np.bincount(self.form_place, np.tile(values, times), total).astype(np.float64)
        log_begin = np.log(a[open_] * rest[open_])
        log_det = -float(layout.number @ np.linalg.slogdet(noise)[1]) - float(log_begin.sum())
        if layout.closed.any():
            zl = (z * layout.number)[layout.closed]
            nil_l = nil[layout.closed] * layout.number[layout.closed, None, None]
            whole = np.exp(-zl)[:, None, None] * (_EYE + nil_l + 0.5 * nil_l @ nil_l)
            log_det += 2.0 * float(np.linalg.slogdet(_EYE - whole)[1].sum())
        return band, times * log_det

    def _memory(self, memory: float) -> tuple[Floats, float]:
        layout = self.layout
        rho = np.exp(-layout.gap / memory)
        left = -np.expm1(-2.0 * layout.gap / memory)
        values = np.concatenate([rho * rho / left, 1.0 / left, -rho / left * self.twice, np.ones(len(layout.head))])
        band: Floats = np.bincount(self.memory_place, values, self.shape[0] * self.shape[1]).astype(np.float64)
        log_det = 2.0 * float(np.log(-np.expm1(-layout.ring_length / memory)).sum()) - float(np.log(left).sum())
        return band, log_det

    def _factored(self, sizes: Sizes) -> tuple[float, Floats, Floats, Floats, Floats] | None:
        """-2 log likelihood, factor, answers of the states, normal matrix of the constants and their mean."""
        progress.step()
        from scipy.linalg.lapack import dpbtrf, dpbtrs, dposv

        v = sizes.white**2
        prior, log_prior = self.prior(sizes.form_length, sizes.memory)
        std = self.std(sizes)
        band = (prior + np.array([std[g] * std[h] / v for g, h in self.read_of]) @ self.data).reshape(self.shape)
        factor, failed = dpbtrf(band, lower=1, overwrite_ab=1)
        if failed:
            return None
        right = np.tensordot(np.array(std) / v, self.rights, 1)
        found = dpbtrs(factor, right, lower=1)[0]
        inner = self.normal / v - right.T @ found
        normal, log_own = inner[1:, 1:], 0.0
        for kind, size in ((1, sizes.part), (2, sizes.level)):
            columns = self.offsets[kind]
            if len(columns):
                normal[columns, columns] += 1.0 / size**2
                log_own -= 2.0 * len(columns) * math.log(size)
        root, constants, failed = dposv(normal, inner[1:, 0], lower=1)
        if failed:
            return None
        square = float(inner[0, 0] - inner[1:, 0] @ constants)
        minus = (
            len(self.value) * math.log(v)
            - self.log_weight
            + 2.0 * float(np.log(factor[0]).sum())
            - log_prior
            + 2.0 * float(np.log(root.diagonal()).sum())
            - log_own
            + square
        )
        return minus, factor, found, normal, constants

    def minus_log(self, sizes: Sizes) -> float:
        """-2 log of the restricted likelihood for given sizes, but for a constant; infinite where numbers fail."""
        found = self._factored(sizes)
        return math.inf if found is None else found[0]

    def solve(self, sizes: Sizes) -> Solved | None:
        """Posterior for given sizes; None where the numbers do not allow it."""
        made = self._factored(sizes)
        if made is None:
            return None
        minus, factor, found, normal, constants = made
        state = found[:, 0] - found[:, 1:] @ constants
        spread = np.linalg.inv(normal).astype(np.float64, copy=False)
        return Solved(minus, factor, state, constants, spread, found[:, 1:], sizes)

    def std(self, sizes: Sizes) -> list[float]:
        """Standard deviations of what a place is read from, mm."""
        return [sizes.form, *([sizes.lean] if self.layout.leans else []), sizes.process]

    def residual(self, solved: Solved) -> tuple[Floats, Floats]:
        """Of every cell its form with lean and all constants, and its noise with a memory, mm; (n,) each."""
        *form, process = (
            x * (a * solved.state[rows]).sum(axis=1)
            for x, (rows, a) in zip(self.std(solved.sizes), self.layout.reads, strict=True)
        )
        return sum(form, self.layout.cells.columns @ solved.constants), process

    def cell_variance(self, solved: Solved, cells: Ints) -> Floats:
        """Posterior variance at some cells of form, lean, remembered noise and constants together, mm2; (m,)."""
        rows = np.column_stack([rows[cells] for rows, _ in self.layout.reads])
        a = np.column_stack([x * a[cells] for x, (_, a) in zip(self.std(solved.sizes), self.layout.reads, strict=True)])
        return self.variance_of(solved, rows, a, self.layout.cells.columns[cells])[0]

    def mean(self, solved: Solved, stretch: Ints, s: Floats, column: Ints) -> Floats:
        """Form and the constant of a column at places, mm; column -1 for none. (m,)."""
        form = solved.sizes.form * self.layout.value(solved.state, stretch, s)
        out: Floats = form + np.append(solved.constants, 0.0)[column]
        return out

    def variance(self, solved: Solved, stretch: Ints, s: Floats, column: Ints) -> tuple[Floats, Floats]:
        """Variance of `mean` at places, and its covariance from each place to the next, mm2; (m,) each."""
        rows, a = self.layout.read(stretch, s)
        unit = np.zeros((len(s), len(solved.constants) + 1))
        unit[np.arange(len(s)), column] = 1.0
        return self.variance_of(solved, rows, solved.sizes.form * a, unit[:, :-1])

    def lean(self, solved: Solved, stretch: Ints, s: Floats, unit: Floats) -> tuple[Floats, Floats, Floats]:
        """Lean and so much of each constant, (k,), at places: mean, mm, variance and covariance to the next; (m,)."""
        rows, a = self.layout.read(stretch, s)
        rows, a = rows + 3, solved.sizes.lean * a
        mean = (a * solved.state[rows]).sum(axis=1) + unit @ solved.constants
        return mean, *self.variance_of(solved, rows, a, np.tile(unit, (len(s), 1)))

    def variance_of(self, solved: Solved, rows: Ints, a: Floats, unit: Floats) -> tuple[Floats, Floats]:
        """Variance of sums of states and constants, and the covariance of each sum with the next, mm2; (m,) each.

        Parameters
        ----------
        solved : Solved
        rows : (m, r) int64
        a : (m, r) float64
            So many mm of each of these states.
        unit : (m, k) float64
            So much of each constant.
        """
        progress.step()
        from scipy.linalg import cho_solve_banded

        # What a constant that is wrong by 1 mm does to the sum.
        constant = unit - (a[:, :, None] * solved.answer[rows]).sum(axis=1)
        spread = constant @ solved.spread
        variance: Floats = (spread * constant).sum(axis=1)
        along = np.append((spread[:-1] * constant[1:]).sum(axis=1), 0.0)
        for low in range(0, len(rows), _CHUNK):
            progress.step()
            here = np.arange(low, min(low + _CHUNK, len(rows)))
            column = (here - low)[:, None]
            right = np.zeros((self.layout.size, len(here)), order="F")
            np.add.at(right, (rows[here], column), a[here])
            found = cho_solve_banded((solved.factor, True), right, overwrite_b=True, check_finite=False)
            variance[here] += (a[here] * found[rows[here], column]).sum(axis=1)
            after = np.minimum(here + 1, len(rows) - 1)
            along[here] += (a[after] * found[rows[after], column]).sum(axis=1)
        return variance, along
