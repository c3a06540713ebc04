# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrected toolpath: every following move laid anew on the exact parallel of the compensated contour.

Each move keeps its place in the sequence, its feed and its neighbours; leads, ramps and links go along rigidly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from millcorr.compensation import Correction
from millcorr.errors import LimitError, UsageError
from millcorr.reconstruction import CompensatedContour
from millcorr.theoretical_contour import SAME_POINT
from millcorr.toolpath import Kind, Toolpath

from .curve_moves import Intervals, fit_moves
from .leads import carry_along, own_work
from .path_following import Following, follow

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

BAND = 0.1
"""A following move is at most this far, in mm, from the exact parallel of what the program is to follow."""

KEEP_SHARE = 0.4
"""A move already within this share of the tolerance from where it should be stays as it is."""

OWN_SHARE = 0.95
"""Share of the tolerance up to which a move may keep the rounding that the nominal was taken from."""

FIT_SHARE = 0.4
"""Share of the tolerance that replacing the exact path by lines and arcs may use; rounding needs the rest."""

OUTPUT_MOVES = ("keep", "lines", "arcs", "nurbs")


@dataclass(frozen=True, eq=False, slots=True)
class Regeneration:
    """A corrected toolpath and where it came from.

    Parameters
    ----------
    toolpath : Toolpath
        The corrected moves; `source` as in the original.
    origin : (m,) int64
        Row of the original toolpath of each corrected move.
    following : (m,) bool
        Moves that follow the contour.
    changed : int
        Number of original moves that changed.
    original_error : float
        Largest distance in mm of the original following moves from the nominal's parallel.
    fit_error : float
        Largest distance in mm between the new moves and the exact path, before rounding.
    largest_shift : float
        Largest displacement of a vertex of the path, mm.
    lines : (k,) int64
        Lines of the program (`source`) whose moves, or their starts, are not where they were.
    """

    toolpath: Toolpath
    origin: Ints
    following: Bools
    changed: int
    original_error: float
    fit_error: float
    largest_shift: float
    lines: Ints


def regenerate(
    toolpath: Toolpath,
    contour: CompensatedContour,
    radius: float,
    *,
    tolerance: float = 0.001,
    output_moves: str = "keep",
    rows: Bools | None = None,
    nominal_from_path: bool = False,
    expected: CompensatedContour | None = None,
) -> Regeneration:
    """Lay the following moves of a toolpath on the compensated contour's parallel.

    Parameters
    ----------
    toolpath : Toolpath
    contour : CompensatedContour
    radius : float
        Distance in mm from contour to path; 0 where the program gives the contour itself (G41, G42).
    tolerance : float
        Largest distance in mm between emitted and exact path, rounding included.
    output_moves : {'keep', 'lines', 'arcs', 'nurbs'}
        Kinds of move to write; 'keep' uses the kind each move has, 'nurbs' cubic splines (G5).
    rows : (n,) bool, optional
        Moves that may be changed; all by default.
    nominal_from_path : bool
        True where the nominal was taken from this toolpath: what a move is off it by is rounding, and no reason
        to change the move.
    expected : CompensatedContour, optional
        What the toolpath follows so far: the nominal, with the correction that it carries; the nominal by default.

    Returns
    -------
    Regeneration

    Raises
    ------
    LimitError
        If nothing follows the profile, or the cutter would gouge: the contour turns tighter than the radius.
    """
    if output_moves not in OUTPUT_MOVES:
        raise UsageError(f"--output-moves {output_moves}: choose one of {', '.join(OUTPUT_MOVES)}")
    if expected is None:
        expected = CompensatedContour(contour.profile, Correction.none(contour.profile))
    parts = follow(toolpath, expected, radius, band=BAND, rows=rows)
    if not len(parts.row):
        raise LimitError(
            f"no move of the program follows the profile at {radius:g} mm: the nearest runs "
            f"{parts.distance:.3f} mm off; check --tool-diameter, --side, stock to leave and the work frame"
        )
    start, end, sigma0, sigma1 = _vertices(toolpath, contour, radius, parts)
    allowed = np.full(len(toolpath), KEEP_SHARE * tolerance)
    if nominal_from_path:
        own = np.minimum(np.nan_to_num(parts.error) + 1e-7, OWN_SHARE * tolerance)
        allowed = np.maximum(allowed, own)
    keep = _kept(toolpath, contour, radius, parts, allowed)
    _release_moved_corners(toolpath, contour, parts, keep, end, 0.5 * FIT_SHARE * tolerance)
    _hold_kept_vertices(toolpath, parts, keep, start, end)
    shift0, shift1 = _shifts(toolpath, parts, keep, start, end)
    return _assemble(
        toolpath,
        contour,
        radius,
        parts,
        keep,
        (start, end, sigma0, sigma1),
        (shift0, shift1),
        tolerance,
        output_moves,
    )


def _vertices(
    toolpath: Toolpath, contour: CompensatedContour, radius: float, parts: Following
) -> tuple[Floats, Floats, Floats, Floats]:
    """New start and end of every part, (e, 2), and their arc lengths on its piece, (e,)."""
    count = len(parts.row)
    start, end = np.empty((count, 2)), np.empty((count, 2))
    sigma0, sigma1 = parts.first.copy(), parts.last.copy()
    on_piece = parts.piece >= 0
    rows = np.flatnonzero(on_piece)
    start[rows] = contour.evaluate(parts.piece[rows], sigma0[rows], radius)[0]
    end[rows] = contour.evaluate(parts.piece[rows], sigma1[rows], radius)[0]

    this, after = _neighbours(toolpath, parts)
    a, b = parts.piece[this], parts.piece[after]
    turned = _passes_joint(contour, parts, this, after)
    # Within one piece the vertex keeps the foot it has; both parts sample the same point.
    same = (a == b) & (a >= 0) & ~turned
    t, f = this[same], after[same]
    near = np.abs(_wrapped(contour, parts.piece[t], sigma1[t] - sigma0[f])) <= 0.05 + 2 * np.abs(_part_length(parts, t))
    middle = sigma1[t]
    sigma0[f[near]] = middle[near]
    start[f[near]] = end[t[near]]

    joints = contour.joints
    number = {pair: j for j, pair in enumerate(zip(joints.before.tolist(), joints.after.tolist(), strict=True))}
    # Two pieces may meet at two joints; the direction of the path says which of them is passed.
    forward = parts.way[this] >= 0
    passed = zip(np.where(forward, a, b).tolist(), np.where(forward, b, a).tolist(), strict=True)
    joint = np.array([number.get(pair, -1) for pair in passed], dtype=np.int64)
    rows = np.flatnonzero((joint >= 0) & ((a != b) | turned))
    if len(rows):
        j, back = joint[rows], ~forward[rows]
        on_before, on_after = contour.meet(j, radius)
        t, f = this[rows], after[rows]
        sigma1[t] = np.where(back, on_after, on_before)
        sigma0[f] = np.where(back, on_before, on_after)
        vertex = contour.evaluate(joints.before[j], on_before, radius)[0]
        end[t], start[f] = vertex, vertex
    # Onto or off the arc about a convex corner: the path leaves each side where that side ends.
    for i in np.flatnonzero((a >= 0) != (b >= 0)):
        t, f = int(this[i]), int(after[i])
        side, arc = (t, f) if parts.piece[t] >= 0 else (f, t)
        piece, about = int(parts.piece[side]), -1 - int(parts.piece[arc])
        if piece not in (joints.before[about], joints.after[about]):
            raise LimitError(_lost(toolpath, int(parts.row[t])))
        leaves_at_its_end = (side == t) == (parts.way[side] >= 0)
        at = contour.high[piece] if leaves_at_its_end else contour.low[piece]
        vertex = contour.evaluate(np.array([piece]), np.array([at]), radius)[0][0]
        (sigma1 if side == t else sigma0)[side] = at
        end[t], start[f] = vertex, vertex
    _end_at_known_corners(toolpath, parts, start, end, this, after, (a != b) | turned)
    _round_corner_ends(toolpath, contour, radius, parts, start, end, this, after)
    return start, end, sigma0, sigma1


def _passes_joint(contour: CompensatedContour, parts: Following, this: Ints, after: Ints) -> Bools:
    """Pairs of parts on one piece between which the path passes the only corner of the contour."""
    same = (parts.piece[this] == parts.piece[after]) & (parts.piece[this] >= 0)
    open_ = ~contour.closed[np.maximum(parts.piece[this], 0)]
    step = np.nan_to_num(parts.middle[after] - parts.middle[this])
    out: Bools = same & open_ & (step * parts.way[this] < 0)
    return out


def _end_at_known_corners(
    toolpath: Toolpath, parts: Following, start: Floats, end: Floats, this: Ints, after: Ints, corner: Bools
) -> None:
    """A chain that begins or ends at a corner shares its vertex with the parts that meet there. In place."""
    known = {
        tuple(np.round(toolpath.end[parts.row[t], :2] / SAME_POINT).astype(int).tolist()): end[t]
        for t in this[corner]
        if parts.end[t] == 1.0
    }
    if not known:
        return
    free_end, free_start = np.ones(len(parts.row), dtype=bool), np.ones(len(parts.row), dtype=bool)
    free_end[this], free_start[after] = False, False
    for i in np.flatnonzero(free_end & (parts.end == 1.0)):
        key = tuple(np.round(toolpath.end[parts.row[i], :2] / SAME_POINT).astype(int).tolist())
        end[i] = known.get(key, end[i])
    for i in np.flatnonzero(free_start & (parts.begin == 0.0)):
        key = tuple(np.round(toolpath.start[parts.row[i], :2] / SAME_POINT).astype(int).tolist())
        start[i] = known.get(key, start[i])


def _round_corner_ends(
    toolpath: Toolpath,
    contour: CompensatedContour,
    radius: float,
    parts: Following,
    start: Floats,
    end: Floats,
    this: Ints,
    after: Ints,
) -> None:
    """Vertices within the arc about a corner, and free ends of such arcs, keep their direction. In place."""
    joints = contour.joints
    fixed_end, fixed_start = np.zeros(len(parts.row), dtype=bool), np.zeros(len(parts.row), dtype=bool)
    mixed = (parts.piece[this] >= 0) | (parts.piece[after] >= 0)
    fixed_end[this[mixed]] = True
    fixed_start[after[mixed]] = True
    for i in np.flatnonzero(parts.piece < 0):
        j = -1 - int(parts.piece[i])
        before = joints.before[j : j + 1]
        corner = contour.evaluate(before, contour.high[before])[0][0]
        row = toolpath.take(parts.row[i : i + 1])
        for fraction, done, target in ((parts.begin[i], fixed_start, start), (parts.end[i], fixed_end, end)):
            if not done[i]:
                arm = row.position(np.array([fraction]))[0, 0, :2] - joints.point[j]
                target[i] = corner + arm * (radius / max(np.hypot(*arm), 1e-12))


def _neighbours(toolpath: Toolpath, parts: Following) -> tuple[Ints, Ints]:
    """Pairs of parts that share a vertex: followers within a chain, and the seam of a closed chain."""
    this = np.flatnonzero(np.diff(parts.chain) == 0)
    after = this + 1
    chains = np.flatnonzero(np.diff(np.concatenate([[-1], parts.chain]))).tolist() + [len(parts.chain)]
    for a, b in zip(chains[:-1], chains[1:], strict=True):
        first, last = toolpath.start[parts.row[a], :2], toolpath.end[parts.row[b - 1], :2]
        if np.hypot(*(first - last)) < SAME_POINT and b - a > 1:
            this, after = np.append(this, b - 1), np.append(after, a)
    return this, after


def _part_length(parts: Following, rows: Ints) -> Floats:
    return np.nan_to_num(parts.last[rows] - parts.first[rows])


def _wrapped(contour: CompensatedContour, piece: Ints, step: Floats) -> Floats:
    length = contour.length[piece]
    return np.where(contour.closed[piece], (step + length / 2) % length - length / 2, step)


def _kept(
    toolpath: Toolpath,
    contour: CompensatedContour,
    radius: float,
    parts: Following,
    allowed: Floats,
) -> Bools:
    """Rows whose every part already lies on the exact path within their `allowed` mm, ends included."""
    keep = np.zeros(len(toolpath), dtype=bool)
    keep[parts.row] = True
    samples = np.linspace(0.0, 1.0, 9)
    fraction = parts.begin[:, None] + (parts.end - parts.begin)[:, None] * samples
    for group in np.array_split(np.arange(len(parts.row)), max(1, len(parts.row) // 4096)):
        rows = parts.row[group]
        unique, inverse = np.unique(rows, return_inverse=True)
        # Parts of one row are few; the row is sampled at all fractions of its parts.
        piece = parts.piece[group]
        points = np.empty((len(group), len(samples), 2))
        plain = (parts.begin[group] == 0) & (parts.end[group] == 1)
        whole = toolpath.take(unique).position(samples)[:, :, :2]
        points[plain] = whole[inverse[plain]]
        for i in np.flatnonzero(~plain):
            points[i] = toolpath.take(rows[i : i + 1]).position(fraction[group[i]])[0, :, :2]
        off = np.zeros((len(group), len(samples)))
        side = np.flatnonzero(piece >= 0)
        if len(side):
            first, last = parts.first[group][side], parts.last[group][side]
            step = _wrapped(contour, piece[side], last - first)
            # A full turn ends at the foot point where it starts.
            meets = np.hypot(*(points[side, 0] - points[side, -1]).T) < 1e-9
            full = contour.closed[piece[side]] & plain[side] & meets
            way = parts.way[group][side]
            step = np.where(full, way * contour.length[piece[side]], step)
            guess = first[:, None] + step[:, None] * samples
            names = np.repeat(piece[side], len(samples))
            flat, _ = contour.distance_off(names, guess.ravel(), points[side].reshape(-1, 2), radius)
            off[side] = flat.reshape(-1, len(samples))
        for i in np.flatnonzero(piece < 0):
            j = -1 - int(piece[i])
            before = contour.joints.before[j : j + 1]
            corner = contour.evaluate(before, contour.high[before])[0][0]
            off[i] = np.hypot(*(points[i] - corner).T) - radius
        # A vertex is checked across both its parts; along the path it may lie where it likes.
        bad = np.abs(off).max(axis=1) > allowed[rows]
        keep[rows[bad]] = False
    return keep


def _release_moved_corners(
    toolpath: Toolpath, contour: CompensatedContour, parts: Following, keep: Bools, end: Floats, limit: float
) -> None:
    """Moves on the exact path are not kept where they end at a corner that their neighbour moves. In place.

    `limit` is how far, in mm, a corner may move before it counts: the neighbour must end there within its share.
    """
    this, after = _neighbours(toolpath, parts)
    corner = (parts.piece[this] != parts.piece[after]) | _passes_joint(contour, parts, this, after)
    moved = np.hypot(*(end[this] - toolpath.end[parts.row[this], :2]).T) > limit
    pairs = np.stack([parts.row[this], parts.row[after]], axis=1)[corner & moved & (parts.end[this] == 1.0)]
    while (mixed := keep[pairs[:, 0]] != keep[pairs[:, 1]]).any():
        keep[pairs[mixed]] = False


def _hold_kept_vertices(toolpath: Toolpath, parts: Following, keep: Bools, start: Floats, end: Floats) -> None:
    """A vertex of a kept move does not move, for its neighbour either. In place."""
    kept = keep[parts.row]
    old_start, old_end = toolpath.start[parts.row, :2], toolpath.end[parts.row, :2]
    whole_begin, whole_end = parts.begin == 0, parts.end == 1
    start[kept & whole_begin] = old_start[kept & whole_begin]
    end[kept & whole_end] = old_end[kept & whole_end]
    this, after = _neighbours(toolpath, parts)
    held = kept[this] & ~kept[after]
    start[after[held]] = end[this[held]]
    held = kept[after] & ~kept[this]
    end[this[held]] = start[after[held]]
    # A seam or a vertex that rounding left a hair open closes exactly.
    free = ~kept[this] & ~kept[after]
    gap = np.hypot(*(end[this[free]] - start[after[free]]).T)
    close = gap < 1e-9
    start[after[free][close]] = end[this[free][close]]


def _shifts(toolpath: Toolpath, parts: Following, keep: Bools, start: Floats, end: Floats) -> tuple[Floats, Floats]:
    """Displacement of the start and end of every row, (n, 2) each, in mm.

    Leads go along rigidly, see `leads`.
    """
    n = len(toolpath)
    shift0, shift1 = np.zeros((n, 2)), np.zeros((n, 2))
    first = parts.begin == 0
    last = parts.end == 1
    shift0[parts.row[first]] = start[first] - toolpath.start[parts.row[first], :2]
    shift1[parts.row[last]] = end[last] - toolpath.end[parts.row[last], :2]
    following = np.zeros(n, dtype=bool)
    following[parts.row] = True
    carry_along(toolpath, following, own_work(toolpath, following, parts.beside), shift0, shift1)
    return shift0, shift1


def _assemble(
    toolpath: Toolpath,
    contour: CompensatedContour,
    radius: float,
    parts: Following,
    keep: Bools,
    ends: tuple[Floats, Floats, Floats, Floats],
    shifts: tuple[Floats, Floats],
    tolerance: float,
    output_moves: str,
) -> Regeneration:
    start, end, sigma0, sigma1 = ends
    shift0, shift1 = shifts
    n = len(toolpath)
    rewrite = ~keep[parts.row]
    pick = np.flatnonzero(rewrite)
    intervals = _intervals(toolpath, contour, parts, pick, start, end, sigma0, sigma1, output_moves)
    fitted, owner, fit_error = fit_moves(intervals, contour, radius, FIT_SHARE * tolerance)

    following = np.zeros(n, dtype=bool)
    following[parts.row] = True
    return put_together(
        toolpath,
        following,
        parts.row[pick],
        fitted,
        owner,
        shift0,
        shift1,
        original_error=float(np.nanmax(parts.error)),
        fit_error=fit_error,
    )


def put_together(
    toolpath: Toolpath,
    following: Bools,
    replaced: Ints,
    fitted: Toolpath,
    owner: Ints,
    shift0: Floats,
    shift1: Floats,
    *,
    original_error: float,
    fit_error: float,
) -> Regeneration:
    """The corrected toolpath: new moves in place of some, the others displaced with their neighbours.

    Parameters
    ----------
    toolpath : Toolpath
        As it was.
    following : (n,) bool
        Moves that follow the contour.
    replaced : (k,) int64
        Rows that new moves stand for; the order of those of one row counts.
    fitted : Toolpath
        The new moves.
    owner : (m,) int64
        Which of `replaced` each new move belongs to.
    shift0, shift1 : (n, 2) float64
        Displacement of every move's start and end, mm; NaN where a place is not known.
    original_error, fit_error : float
        See `Regeneration`.
    """
    rewritten = np.zeros(len(toolpath), dtype=bool)
    rewritten[replaced] = True
    rigid = _moved_rigidly(toolpath, shift0, shift1, ~rewritten)
    base = toolpath.with_moves(start=rigid.start, end=rigid.end, centre=rigid.centre, control=rigid.control)
    rest = np.flatnonzero(~rewritten)
    moves = Toolpath.concatenate([base.take(rest), _dressed(fitted, toolpath, replaced[owner])])
    origin = np.concatenate([rest, replaced[owner]])
    # Fitted moves come part by part and in order within a part; a stable sort restores the program's order.
    order = np.argsort(origin, kind="stable")
    shift = np.concatenate([shift0[np.isfinite(shift0).all(axis=1)], shift1[np.isfinite(shift1).all(axis=1)]])
    changed = rewritten | (np.abs(shift0) > 0).any(axis=1) | (np.abs(shift1) > 0).any(axis=1)
    return Regeneration(
        moves.take(order),
        origin[order],
        following[origin[order]],
        int(changed.sum()),
        original_error,
        fit_error,
        float(np.hypot(*shift.T).max(initial=0.0)),
        np.unique(toolpath.source[changed]),
    )


def wanted_kind(kind: Ints, z0: Floats, z1: Floats, output_moves: str) -> Ints:
    """Kind of move to write in place of each, from heights at its ends in mm."""
    if output_moves == "keep":
        return kind.copy()
    wanted = {"lines": Kind.LINE, "arcs": Kind.ARC, "nurbs": Kind.CUBIC}[output_moves]
    out = np.full(len(kind), int(wanted))
    # A spline block (G5) moves in the plane only; a rising move takes arcs.
    out[(out == Kind.CUBIC) & (z0 != z1)] = int(Kind.ARC)
    return out


def _intervals(
    toolpath: Toolpath,
    contour: CompensatedContour,
    parts: Following,
    pick: Ints,
    start: Floats,
    end: Floats,
    sigma0: Floats,
    sigma1: Floats,
    output_moves: str,
) -> Intervals:
    row, piece = parts.row[pick], parts.piece[pick]
    z0, z1 = toolpath.start[row, 2], toolpath.end[row, 2]
    kind = wanted_kind(toolpath.kind[row], z0, z1, output_moves)
    # On a closed piece the arc length runs on past the seam, the way the move does.
    whole = np.hypot(*(end[pick] - start[pick]).T) < 1e-9
    step = sigma1[pick] - sigma0[pick]
    safe = np.maximum(piece, 0)
    closed = (piece >= 0) & contour.closed[safe]
    length = contour.length[safe]
    way = parts.way[pick]
    turned = np.where(way > 0, np.mod(step, length), -np.mod(-step, length))
    turned = np.where(whole & closed, way * length, turned)
    step = np.where(closed, turned, step)
    corner = np.full((len(pick), 2), np.nan)
    for i in np.flatnonzero(piece < 0):
        before = contour.joints.before[-1 - piece[i]][None]
        corner[i] = contour.evaluate(before, contour.high[before])[0][0]
    return Intervals(
        owner=np.arange(len(pick)),
        piece=piece,
        sigma0=sigma0[pick],
        sigma1=sigma0[pick] + step,
        start=start[pick],
        end=end[pick],
        z0=z0 + (z1 - z0) * parts.begin[pick],
        z1=z0 + (z1 - z0) * parts.end[pick],
        kind=kind,
        corner=corner,
        whole=whole,
        sweep_sign=np.sign(toolpath.sweep[row]),
    )


def _dressed(fitted: Toolpath, toolpath: Toolpath, row: Ints) -> Toolpath:
    """Fitted moves with feed, plane, source and modes of the moves they replace."""
    return fitted.with_moves(
        plane=toolpath.plane[row].copy(),
        feed=toolpath.feed[row].copy(),
        source=toolpath.source[row].copy(),
        compensation=toolpath.compensation[row].copy(),
        tool=toolpath.tool[row].copy(),
    )


def _moved_rigidly(toolpath: Toolpath, shift0: Floats, shift1: Floats, rows: Bools) -> Toolpath:
    """Moves with displaced ends; an arc whose ends move alike moves as a whole, else it is turned and scaled."""
    start, end = toolpath.start.copy(), toolpath.end.copy()
    centre, control = toolpath.centre.copy(), toolpath.control.copy()
    start[rows, :2] += shift0[rows]
    end[rows, :2] += shift1[rows]
    bent = np.flatnonzero(rows & ((toolpath.kind == Kind.ARC) | (toolpath.kind == Kind.CUBIC)))
    for i in bent:
        if not (shift0[i].any() or shift1[i].any()):
            continue
        old0, old1 = complex(*toolpath.start[i, :2]), complex(*toolpath.end[i, :2])
        new0, new1 = complex(*start[i, :2]), complex(*end[i, :2])
        same = abs((new1 - new0) - (old1 - old0)) < 1e-12 or abs(old1 - old0) < 1e-9
        factor = 1.0 if same else (new1 - new0) / (old1 - old0)

        centre[i, :2] = _carried(toolpath.centre[i, :2], old0, new0, factor)
        control[i, :2] = _carried(toolpath.control[i, :2], old0, new0, factor)
        control[i, 2:] = _carried(toolpath.control[i, 2:], old0, new0, factor)
    return toolpath.with_moves(start=start, end=end, centre=centre, control=control)


def _carried(point: Floats, old: complex, new: complex, factor: complex) -> tuple[float, float]:
    """A point carried along by the similarity that takes `old` to `new`."""
    z = new + factor * (complex(point[0], point[1]) - old)
    return z.real, z.imag


def _lost(toolpath: Toolpath, row: int) -> str:
    x, y, _ = toolpath.end[row]
    return (
        f"the path near X{x:.3f} Y{y:.3f} passes between parts of the profile that do not meet: "
        "check --nominal and --tool-diameter"
    )
