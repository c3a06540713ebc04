# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compensated contour: every point of the nominal profile moved along its normal by the correction.

``T = C + c n``, with the outward normal n and the correction c as functions of arc length. Its tangent follows
from ``n' = kappa t``: ``T' = (1 + c kappa) t + c' n``. The cutter's path is ``T + R m`` with the normal m of T.
Where the nominal turns (corners, facets) the moved pieces are continued, straight or along the circle of their
last curvature, and cut at their intersection, so corners stay corners.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats, Ints
from millcorr.errors import FitError, LimitError
from millcorr.geometry.correction import Correction, along
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import CORNER_ANGLE, GAP, Contour, Profile
from millcorr.messages import mm, option, phrase, um, xy

KINK = 2e-4
"""Joints that turn less, in rad, are passed as smooth: their gap at 5 mm offset is 1 um along the tangent and
0.0001 um across it."""

FIT = 5e-5
"""Largest distance in mm between the compensated contour and its NURBS."""

STRAIGHT = 1e-5
"""A piece that is off a line by no more than this, in mm, is written as one."""

ROUND = 1e-7
"""A piece with a constant correction that is off a row of lines or an arc by no more than this, in mm, is one."""

NEARLY_TANGENT = 0.05
"""Joints that turn less, in rad, may be so flat that rounding keeps their sides from meeting."""


@dataclass(frozen=True, eq=False, slots=True)
class Joints:
    """Places where one piece meets the next at an angle; one row a joint.

    Parameters
    ----------
    before, after : (j,) int64
        Pieces.
    turn : (j,) float64
        Angle in rad by which the nominal turns, positive to the left (convex part corner).
    point : (j, 2) float64
        Nominal corner in mm.
    """

    before: Ints
    after: Ints
    turn: Floats
    point: Floats


class CompensatedContour:
    """The nominal profile with a correction applied, in smooth pieces.

    Parameters
    ----------
    profile : Profile
    correction : Correction

    Attributes
    ----------
    joints : Joints
    low, high : (p,) float64
        Arc lengths on each piece's nominal between which its moved curve is used, in mm.

    Raises
    ------
    LimitError
        If moved neighbours no longer meet, or a piece vanishes.
    """

    def __init__(self, profile: Profile, correction: Correction) -> None:
        self.profile = profile
        self.correction = correction
        self._cut_into_pieces()
        self.low = np.zeros(len(self.length))
        self.high = self.length.copy()
        a, b = self.meet(np.arange(len(self.joints.before)), 0.0)
        self.high[self.joints.before] = a
        self.low[self.joints.after] = b
        gone = np.flatnonzero(self.high - self.low <= 0)
        if len(gone):
            p = self.evaluate(gone[:1], self.length[gone[:1]] / 2)[0][0]
            raise LimitError(
                phrase(
                    "the correction leaves nothing of the {} long piece of the profile near {}",
                    mm(self.length[gone[0]]),
                    xy(p[0], p[1]),
                )
            )

    def _cut_into_pieces(self) -> None:
        profile = self.profile
        order: list[Ints] = []
        closed: list[bool] = []
        before: list[int] = []
        after: list[int] = []
        turn: list[float] = []
        ends: list[int] = []
        for k, contour in enumerate(profile.contours):
            spans = np.arange(profile.first[k], profile.first[k + 1])
            kink = np.abs(np.nan_to_num(profile.turn[spans])) > KINK
            if contour.closed and kink.any() and not kink[-1]:
                spans = np.roll(spans, -(int(np.flatnonzero(kink)[0]) + 1))
                kink = np.abs(np.nan_to_num(profile.turn[spans])) > KINK
            parts = np.split(spans, np.flatnonzero(kink[:-1]) + 1)
            first = len(order)
            order += parts
            closed += [contour.closed and not kink.any()] * len(parts)
            count = len(parts)
            for i in range(count if contour.closed and kink.any() else count - 1):
                before.append(first + i)
                after.append(first + (i + 1) % count)
                turn.append(float(profile.turn[parts[i][-1]]))
                ends.append(int(parts[i][-1]))
        self._order = np.concatenate(order)
        """Spans, piece by piece in their direction."""
        self.piece_of_span = np.empty(profile.spans, dtype=np.int64)
        counts = np.array([len(p) for p in order])
        owner = np.repeat(np.arange(len(order)), counts)
        self.piece_of_span[self._order] = owner
        lengths = profile.length[self._order]
        before_each = np.cumsum(lengths) - lengths
        first_row = np.cumsum(counts) - counts
        self._row_begin = before_each - before_each[first_row][owner]
        self._row_of_span = np.empty(profile.spans, dtype=np.int64)
        self._row_of_span[self._order] = np.arange(len(self._order))
        self.length = np.add.reduceat(lengths, first_row)
        self.closed = np.array(closed)
        # One increasing key for all pieces, with room between them, finds the span of (piece, arc length).
        self._key = np.cumsum(self.length + 1.0) - (self.length + 1.0)
        self._row_key = self._key[owner] + self._row_begin
        self._first_row, self._last_row = first_row, first_row + counts - 1
        self.stretch = profile.stretch[self._order[first_row]]
        self.contour = profile.contour[self._order[first_row]]
        starts = profile.begin[self._order[first_row]]
        self._in_stretch = np.array(
            [
                float(along(self.correction.stretches[k], np.array([s]), profile)[0])
                for k, s in zip(self.stretch, starts, strict=True)
            ]
        )
        point = profile.evaluate(np.array(ends, dtype=np.int64), np.ones(len(ends)))[0]
        self.joints = Joints(np.array(before, dtype=np.int64), np.array(after, dtype=np.int64), np.array(turn), point)

    def position_on_piece(self, span: Ints, t: Floats) -> tuple[Ints, Floats]:
        """Piece and arc length from its start, for spans and local parameters of the profile."""
        inner = self.profile.arc_length(span, t) - self.profile.begin[span]
        return self.piece_of_span[span], self._row_begin[self._row_of_span[span]] + inner

    def _locate(self, piece: Ints, sigma: Floats) -> tuple[Ints, Floats, Floats]:
        """Span and local parameter, and by how much sigma lies beyond the piece's ends, mm."""
        length = self.length[piece]
        inside = np.where(self.closed[piece], np.mod(sigma, length), np.clip(sigma, 0.0, length))
        row = np.searchsorted(self._row_key, self._key[piece] + inside, side="right") - 1
        row = np.clip(row, self._first_row[piece], self._last_row[piece])
        t = self.profile.parameter(self._order[row], inside - self._row_begin[row])
        return self._order[row], t, np.where(self.closed[piece], 0.0, sigma - inside)

    def _nominal(self, span: Ints, t: Floats, beyond: Floats) -> tuple[Floats, Floats, Floats]:
        """Points, unit tangents and curvature of the nominal, continued beyond ends on the circle of curvature."""
        c, d1, d2 = self.profile.evaluate(span, t)
        speed = np.hypot(*d1.T)
        kappa = (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]) / speed**3
        tangent = d1 / speed[:, None]
        if beyond.any():
            half = kappa * beyond / 2
            ahead, aside = beyond * np.sinc(2 * half / np.pi), beyond * np.sin(half) * np.sinc(half / np.pi)
            left = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
            c = c + ahead[:, None] * tangent + aside[:, None] * left
            tangent = np.cos(2 * half)[:, None] * tangent + np.sin(2 * half)[:, None] * left
        return c, tangent, kappa

    def evaluate(
        self, piece: Ints, sigma: Floats, offset: float = 0.0, *, corrected: bool = True
    ) -> tuple[Floats, Floats, Floats]:
        """Points of the contour, or of its parallel curve outside it.

        Parameters
        ----------
        piece : (n,) int64
        sigma : (n,) float64
            Arc length on the piece's nominal, mm; beyond its ends the piece is continued.
        offset : float
            Distance in mm along the compensated contour's own normal, e.g. the tool radius.
        corrected : bool
            False for the nominal in place of the compensated contour.

        Returns
        -------
        point : (n, 2) float64
            mm.
        normal : (n, 2) float64
            Unit normal out of the material.
        stretch : (n,) float64
            Length of the curve per length of nominal; not positive where it turns tighter than the offset.
        """
        return self._moved(piece, sigma, *self._locate(piece, sigma), offset, corrected)

    def _moved(
        self, piece: Ints, sigma: Floats, span: Ints, t: Floats, beyond: Floats, offset: float, corrected: bool
    ) -> tuple[Floats, Floats, Floats]:
        c, tangent, kappa = self._nominal(span, t, beyond)
        normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
        if corrected:
            shift, slope, bend = self._correction(piece, sigma)
        else:
            shift = slope = bend = np.zeros(len(t))
        forward = 1.0 + shift * kappa
        size = np.hypot(forward, slope)
        own = (forward[:, None] * normal - slope[:, None] * tangent) / size[:, None]
        point = c + shift[:, None] * normal + offset * own
        # Curvature of T; only c c' times the rate at which the nominal's curvature changes is left out, a
        # millionth of that rate for corrections of 0.01 mm.
        curvature = (forward * (forward * kappa - bend) + 2 * slope * slope * kappa) / size**3
        stretch = size * (1.0 + offset * curvature)
        return point, own, np.where(forward > 0, stretch, -np.abs(stretch))

    def distance_off(
        self, piece: Ints, guess: Floats, points: Floats, offset: float, *, corrected: bool = True
    ) -> tuple[Floats, Floats]:
        """Signed distance of points from the parallel curve of given pieces, continued beyond their ends.

        Parameters
        ----------
        piece : (n,) int64
        guess : (n,) float64
            Arc lengths on the pieces to start from, mm.
        points : (n, 2) float64
            mm.
        offset : float
            Distance of the parallel curve, mm.
        corrected : bool
            False for the nominal in place of the compensated contour.

        Returns
        -------
        off : (n,) float64
            mm, positive outside.
        sigma : (n,) float64
            Arc lengths of the foot points, mm.
        """
        sigma = guess
        for _ in range(8):
            q, normal, size = self.evaluate(piece, sigma, offset, corrected=corrected)
            gap = points - q
            forward = gap[:, 1] * normal[:, 0] - gap[:, 0] * normal[:, 1]
            step = forward / np.where(np.abs(size) > 1e-3, size, 1.0)
            sigma = sigma + np.clip(step, -20.0, 20.0)
            if np.abs(step).max(initial=0.0) < 1e-10:
                break
        q, normal, _ = self.evaluate(piece, sigma, offset, corrected=corrected)
        off: Floats = ((points - q) * normal).sum(axis=1)
        return off, sigma

    def nominal_normal(self, piece: Ints, sigma: Floats) -> Floats:
        """Directional cosines of the nominal at places of the pieces; (n, 2)."""
        _, tangent, _ = self._nominal(*self._locate(piece, sigma))
        return np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)

    def _correction(self, piece: Ints, sigma: Floats) -> tuple[Floats, Floats, Floats]:
        """Correction and its first two derivatives over arc length."""
        out = np.empty((3, len(piece)))
        number = self.stretch[piece]
        s = self._in_stretch[piece] + sigma
        for k in np.unique(number):
            rows = number == k
            out[:, rows] = self.correction.courses[k].derivatives(s[rows])
        return out[0], out[1], out[2]

    def correction_on(self, piece: Ints, sigma: Floats) -> Floats:
        """Correction in mm along the nominal normal at places of the pieces; (n,)."""
        return self._correction(piece, sigma)[0]

    def meet(self, joint: Ints, offset: float) -> tuple[Floats, Floats]:
        """Where the pieces before and after joints intersect, moved out by `offset` mm.

        Returns
        -------
        a, b : (k,) float64
            Arc length on the piece before and on the piece after, mm; they may lie beyond the pieces' ends.

        Raises
        ------
        LimitError
            If two pieces do not meet.
        """
        before, after = self.joints.before[joint], self.joints.after[joint]
        if not len(joint):
            return np.zeros(0), np.zeros(0)
        reach = offset * np.tan(np.clip(self.joints.turn[joint], -2.8, 2.8) / 2)
        a, b = self.length[before] + reach, -reach
        for _ in range(50):
            progress.step()
            pa, na, fa = self.evaluate(before, a, offset)
            pb, nb, fb = self.evaluate(after, b, offset)
            gap = pa - pb
            if np.abs(gap).max() < 1e-11:
                break
            ta = np.stack([-na[:, 1], na[:, 0]], 1) * np.where(np.abs(fa) > 1e-3, fa, 1.0)[:, None]
            tb = np.stack([-nb[:, 1], nb[:, 0]], 1) * np.where(np.abs(fb) > 1e-3, fb, 1.0)[:, None]
            det = tb[:, 0] * ta[:, 1] - ta[:, 0] * tb[:, 1]
            det = np.where(np.abs(det) > 1e-12, det, 1e-12)
            a = a + np.clip((gap[:, 0] * tb[:, 1] - gap[:, 1] * tb[:, 0]) / det, -5.0, 5.0)
            b = b + np.clip((gap[:, 0] * ta[:, 1] - gap[:, 1] * ta[:, 0]) / det, -5.0, 5.0)
        miss = np.hypot(*(self.evaluate(before, a, offset)[0] - self.evaluate(after, b, offset)[0]).T)
        lost = np.flatnonzero(~(miss < 1e-6))
        if len(lost):
            # A line and an arc that rounding left a hair apart run past each other: join them across the gap.
            a[lost] = self.length[before[lost]] + reach[lost]
            end, _, _ = self.evaluate(before[lost], a[lost], offset)
            off, b[lost] = self.distance_off(after[lost], -reach[lost], end, offset)
            flat = np.abs(self.joints.turn[joint[lost]]) < NEARLY_TANGENT
            bad = np.flatnonzero(~flat | ~(np.abs(off) < GAP / 2))
            if len(bad):
                x, y = self.joints.point[joint[lost[bad[0]]]]
                raise LimitError(phrase("the corrected contour does not close at the corner {}", xy(x, y)))
        return a, b

    def to_profile(self) -> tuple[Profile, float]:
        """The compensated contour as NURBS: one a smooth piece, periodic where the contour is smooth all round.

        Lines and arcs with a constant correction stay lines and arcs.

        Returns
        -------
        Profile
        residual : float
            Largest distance in mm between the exact compensated contour and its NURBS.

        Raises
        ------
        FitError
            If a piece cannot be fitted to `FIT`.
        """
        contours: list[Contour] = []
        self._close_gaps()
        gap = np.maximum.reduceat(np.hypot(*self._gap_end.T), self._first_row)
        residual = 0.0
        for k, contour in enumerate(self.profile.contours):
            pieces = np.flatnonzero(self.contour == k)
            still = all(
                c.is_constant and c.coefficient[0, 0] == 0.0
                for c in (self.correction.courses[i] for i in np.unique(self.stretch[pieces]))
            )
            if still:
                contours.append(contour)
                continue
            curves: list[NurbsCurve] = []
            for piece in pieces:
                progress.step()
                new, error = self._curves_of(int(piece))
                curves += new
                residual = max(residual, error, float(gap[piece]))
            contours.append(Contour(tuple(_polylines(curves)), contour.closed, contour.step))
        return Profile.from_contours(contours), residual

    def _close_gaps(self) -> None:
        """Find where spans within a piece do not quite meet: half of each gap is bridged along either span."""
        rows = np.arange(len(self._order))
        piece = self.piece_of_span[self._order]
        last = rows == self._last_row[piece]
        after = np.where(last, self._first_row[piece], rows + 1)
        zero, one = np.zeros(len(rows)), np.ones(len(rows))
        width = self.profile.length[self._order]
        begin, _, _ = self._moved(piece, self._row_begin, self._order, zero, zero, 0.0, True)
        end, _, _ = self._moved(piece, self._row_begin + width, self._order, one, zero, 0.0, True)
        gap = begin[after] - end
        gap[last & ~self.closed[piece]] = 0.0
        self._gap_end = gap / 2
        self._gap_begin = np.empty_like(gap)
        self._gap_begin[after] = -gap / 2

    def _curves_of(self, piece: int) -> tuple[list[NurbsCurve], float]:
        low, high = float(self.low[piece]), float(self.high[piece])
        rows = np.arange(self._first_row[piece], self._last_row[piece] + 1)
        inner = self._row_begin[rows[1:]]
        knots = inner[(inner > low) & (inner < high)]
        primitives, error = self._primitives(piece, rows, knots)
        if primitives:
            return primitives, error
        spans = self._order[rows]
        end = self.profile.curvature(spans[:-1], np.ones(len(rows) - 1))
        start = self.profile.curvature(spans[1:], np.zeros(len(rows) - 1))
        jump = np.abs(end - start) > 1e-7 * (1.0 + np.abs(end))
        jumps = inner[jump & (inner > low) & (inner < high)]
        if self.closed[piece]:
            seam_end = self.profile.curvature(spans[-1:], np.ones(1))
            seam_start = self.profile.curvature(spans[:1], np.zeros(1))
            seam = bool(abs(seam_end - seam_start)[0] > 1e-7 * (1.0 + abs(seam_end[0])))
            if not len(jumps) and not seam:
                return self._fit_periodic(piece, np.concatenate([[0.0], knots, [high]]))
            if not seam:
                shift = jumps[0]
                jumps = np.append(jumps[1:], shift + high)
                knots = np.concatenate([knots[knots > shift], [high], knots[knots <= shift] + high])
                low, high = float(shift), float(shift + high)
                jumps = jumps[jumps < high]
        edges = np.concatenate([[low], jumps, [high]])
        return self._fit_joined(piece, edges, knots)

    def _primitives(self, piece: int, rows: Ints, knots: Floats) -> tuple[list[NurbsCurve], float]:
        """The moved piece as lines and arcs, none where it is something else; and their error in mm."""
        low, high = float(self.low[piece]), float(self.high[piece])
        course = self.correction.courses[self.stretch[piece]]
        if not self.closed[piece]:
            ends = self._sample(piece, np.array([low, high]))
            probe = np.concatenate([np.linspace(low, high, 9), knots, self._bends(piece, low, high)])
            error = _off_line(self._sample(piece, probe), ends[0], ends[1])
            if error <= STRAIGHT:
                return [NurbsCurve.line(ends[0], ends[1])], error
        if not course.is_constant:
            return [], 0.0
        change = rows[1:][np.diff(self.profile.curve[self._order[rows]]) != 0]
        cuts = np.concatenate([[low], self._row_begin[change], [high]])
        found = [self._line_or_arc(piece, a, b, knots) for a, b in zip(cuts[:-1], cuts[1:], strict=True)]
        whole = [curve for curve in found if curve is not None]
        return (whole, 0.0) if len(whole) == len(found) else ([], 0.0)

    def _bends(self, piece: int, low: float, high: float) -> Floats:
        """Arc lengths between `low` and `high` where the correction may bend: its breaks, and halfway between."""
        course = self.correction.courses[self.stretch[piece]]
        if course.is_constant:
            return np.zeros(0)
        at = np.sort(np.concatenate([course.breaks, course.breaks[:-1] + np.diff(course.breaks) / 2]))
        at = at - self._in_stretch[piece]
        turns = np.arange(-1, 3) * course.period if course.period else np.zeros(1)
        found = [at[np.searchsorted(at, low - turn) : np.searchsorted(at, high - turn)] + turn for turn in turns]
        return np.concatenate(found)

    def _sample(self, piece: int, sigma: Floats) -> Floats:
        """Points of the moved piece, its inner gaps closed."""
        names = np.full(len(sigma), piece)
        span, t, beyond = self._locate(names, sigma)
        point, _, _ = self._moved(names, sigma, span, t, beyond, 0.0, True)
        row = self._row_of_span[span]
        inside = np.mod(sigma, self.length[piece]) if self.closed[piece] else sigma
        u = np.clip((inside - self._row_begin[row]) / self.profile.length[span], 0.0, 1.0)[:, None]
        out: Floats = point + (1 - u) * self._gap_begin[row] + u * self._gap_end[row]
        return out

    def _slope(self, piece: int, sigma: Floats) -> Floats:
        _, normal, size = self.evaluate(np.full(len(sigma), piece), sigma)
        return np.stack([-normal[:, 1], normal[:, 0]], axis=1) * size[:, None]

    def _line_or_arc(self, piece: int, low: float, high: float, knots: Floats) -> NurbsCurve | None:
        """Part of a piece with a constant correction as a line, a row of lines or an arc; None if it is neither."""
        # Inside only: at its very ends a curve may already show its neighbour's curvature.
        inner = low + (high - low) * np.linspace(0.01, 0.99, 17)
        span, t, _ = self._locate(np.full(17, piece), inner)
        kappa = self.profile.curvature(span, t)
        bends = knots[(knots > low) & (knots < high)]
        if np.abs(kappa).max() < 1e-12:
            points = self._sample(piece, np.concatenate([[low], bends, [high]]))
            half = self._sample(piece, np.concatenate([[low], bends]) + np.diff([low, *bends, high]) / 2)
            if np.abs(half - (points[1:] + points[:-1]) / 2).max() > ROUND:
                return None
            return _row_of_lines(points)
        if np.ptp(kappa) > 1e-9 * abs(kappa[8]):
            return None
        c, _, _ = self.profile.evaluate(span[8:9], t[8:9])
        n = self.profile.normals(span[8:9], t[8:9])
        centre = (c - n / kappa[8])[0]
        sweep = float(kappa[8] * (high - low))
        ends = self._sample(piece, np.array([low, high]))
        round_ = self._sample(piece, np.concatenate([inner, bends]))
        radius = float(np.hypot(*(ends[0] - centre)))
        if abs(sweep) > 2 * np.pi + 1e-9 or np.abs(np.hypot(*(round_ - centre).T) - radius).max() > ROUND:
            return None
        return NurbsCurve.arc(ends[0], ends[1], centre, sweep)

    def _refine(self, piece: int, nodes: Floats, spline: Callable[[Floats], Floats]) -> tuple[Floats, float]:
        """Nodes with every interval halved whose spline is off by more than `FIT`; and the largest error."""
        width = np.diff(nodes)
        inside = nodes[:-1, None] + width[:, None] * np.array([0.05, 0.21, 0.5, 0.79, 0.95])
        probe = np.concatenate([inside.ravel(), self._bends(piece, float(nodes[0]), float(nodes[-1]))])
        gap = spline(probe) - self._sample(piece, probe)
        _, normal, _ = self.evaluate(np.full(len(probe), piece), probe)
        # What lies along the curve is no distance from it, but for the curve's bend.
        error = np.abs((gap * normal).sum(axis=1)) + (gap * gap).sum(axis=1)
        worst = np.zeros(len(width))
        np.maximum.at(worst, np.clip(np.searchsorted(nodes, probe, side="right") - 1, 0, len(width) - 1), error)
        # Between the probes the error may be a little larger.
        bad = ~(worst <= 0.8 * FIT)
        return np.sort(np.concatenate([nodes, nodes[:-1][bad] + width[bad] / 2])), float(worst.max())

    def _fit_periodic(self, piece: int, nodes: Floats) -> tuple[list[NurbsCurve], float]:
        from scipy.interpolate import make_interp_spline

        nodes = np.unique(nodes)
        while len(nodes) < 9:
            nodes = np.sort(np.concatenate([nodes, nodes[:-1] + np.diff(nodes) / 2]))
        for _ in range(16):
            values = self._sample(piece, nodes)
            values[-1] = values[0]
            spline = make_interp_spline(nodes, values, k=3, bc_type="periodic")
            refined, error = self._refine(piece, nodes, spline)
            if len(refined) == len(nodes):
                n = len(nodes) - 1
                curve = NurbsCurve(3, spline.c[:n], np.ones(n), nodes, np.ones(n + 1, dtype=np.int64), True)
                return [curve], error
            nodes = refined
        raise FitError(self._cannot_fit(piece, error))

    def _fit_joined(self, piece: int, edges: Floats, knots: Floats) -> tuple[list[NurbsCurve], float]:
        """Cubic splines between places where the curvature jumps, joined with equal tangents (double knots)."""
        from scipy.interpolate import make_interp_spline

        all_knots: list[Floats] = []
        poles: list[Floats] = []
        largest = 0.0
        # Both sides of an edge must use the very same point and slope, round the seam too.
        at, slopes = self._sample(piece, edges), self._slope(piece, edges)
        if self.closed[piece]:
            at[-1], slopes[-1] = at[0], slopes[0]
        for i, (a, b) in enumerate(zip(edges[:-1], edges[1:], strict=True)):
            nodes = np.unique(np.concatenate([[a], knots[(knots > a) & (knots < b)], np.linspace(a, b, 4)[1:-1], [b]]))
            for _ in range(16):
                values = self._sample(piece, nodes)
                values[[0, -1]] = at[i : i + 2]
                spline = make_interp_spline(nodes, values, k=3, bc_type=([(1, slopes[i])], [(1, slopes[i + 1])]))
                refined, error = self._refine(piece, nodes, spline)
                if len(refined) == len(nodes):
                    break
                nodes = refined
            else:
                raise FitError(self._cannot_fit(piece, error))
            largest = max(largest, error)
            all_knots.append(nodes)
            poles.append(np.asarray(spline.c))
        knot = np.concatenate([all_knots[0]] + [k[1:] for k in all_knots[1:]])
        mult = np.ones(len(knot), dtype=np.int64)
        mult[np.searchsorted(knot, edges[1:-1])] = 2
        if self.closed[piece]:
            inner = np.concatenate([p[1:-1] for p in poles])
            mult[[0, -1]] = 2
            return [NurbsCurve(3, np.roll(inner, 1, axis=0), np.ones(len(inner)), knot, mult, True)], largest
        mult[[0, -1]] = 4
        inner = np.concatenate([poles[0][:1]] + [p[1:-1] for p in poles] + [poles[-1][-1:]])
        return [NurbsCurve(3, inner, np.ones(len(inner)), knot, mult)], largest

    def _cannot_fit(self, piece: int, error: float) -> str:
        x, y = self._sample(piece, self.length[piece : piece + 1] / 2)[0]
        return phrase(
            "the compensated profile near {} cannot be fitted better than {}: the deviations change too "
            "fast; use a stronger {}",
            xy(x, y),
            um(error, ".2f"),
            option("filter"),
        )


def _off_line(points: Floats, start: Floats, end: Floats) -> float:
    """Largest distance of points from a line, mm; inf where it has no length."""
    chord = end - start
    away = points - start
    size = float(np.hypot(*chord))
    return float(np.abs(away[:, 0] * chord[1] - away[:, 1] * chord[0]).max() / size) if size > 0 else float("inf")


def _row_of_lines(points: Floats) -> NurbsCurve:
    mult = np.ones(len(points), dtype=np.int64)
    mult[[0, -1]] = 2
    return NurbsCurve(1, points, np.ones(len(points)), np.arange(float(len(points))), mult)


def _polylines(curves: list[NurbsCurve]) -> list[NurbsCurve]:
    """Join neighbouring rows of lines that turn by less than a corner into one curve of degree 1."""
    rows: list[list[NurbsCurve]] = []
    for curve in curves:
        if rows and curve.degree == 1 and rows[-1][-1].degree == 1:
            a, b = np.diff(rows[-1][-1].poles[-2:], axis=0)[0], np.diff(curve.poles[:2], axis=0)[0]
            if 1e-9 < abs(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b)) < CORNER_ANGLE:
                rows[-1].append(curve)
                continue
        rows.append([curve])
    return [
        row[0] if len(row) == 1 else _row_of_lines(np.vstack([row[0].poles[:1], *(c.poles[1:] for c in row)]))
        for row in rows
    ]
