# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where and how a touch probe measures a contour: places, directions of touch, safe ways between them.

A three-axis touch probe is only sure of axis-parallel touches: along X where the normal is nearer X, along Y where it
is nearer Y, else along the normal (petrakov-2018). Every touch is planned so that a ball on the nominal contour
touches it at the intended point: the ball's centre lies one radius along the normal, whatever way it came.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np
from numpy.typing import NDArray

from millcorr.arrays import Bools, Floats, Ints, ReadOnlyArrays
from millcorr.comparison.deviation import REACHED
from millcorr.errors import RefusedError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, xy

from .links import links_between
from .space import Space
from .workpiece import Obstacles

TOUCHES = ("auto", "axis", "normal")

TIE = np.radians(1.0)
"""A normal that is within this of 45 degrees is near neither axis."""

MOST_POINTS = 100_000

_LENGTHENED = (1.0, 1.2, 1.5, 2.0, 3.0)
"""In a hollow the ball must back off farther than beside a flat to stand as clear."""


@dataclass(frozen=True, slots=True)
class TouchProbe:
    """The probe and how much room it is given.

    Parameters
    ----------
    ball_radius : float
        Radius in mm at which the probe triggers (the calibrated one).
    clearance : float
        How far the ball backs off the stock before a touch, along the normal in mm, and the gap of its way along the
        contour. To anything else the gap is at least half of it, anywhere.
    overtravel : float
        How far behind the nominal surface, along the normal in mm, a touch gives up.
    stock : float
        Material in mm that may still be on the nominal surface.
    margin : float
        Distance in mm that the ball keeps from corners and from other walls.
    free_width : float
        How far from the contour, in mm, the space is free; the ball stays within.
    touch : {'auto', 'axis', 'normal'}
        Along X or Y whichever is nearer the normal, and along the normal where neither is; always along X or Y;
        always along the normal.
    """

    ball_radius: float
    clearance: float = 2.0
    overtravel: float = 1.0
    stock: float = 0.0
    margin: float = 0.5
    free_width: float = inf
    touch: str = "auto"

    def __post_init__(self) -> None:
        for key, value, least in (
            ("probe_radius", self.ball_radius, 0.01),
            ("clearance", self.clearance, 0.1),
            ("overtravel", self.overtravel, 0.01),
            ("stock", self.stock, 0.0),
        ):
            if not (isfinite(value) and least <= value <= 1000.0):
                raise UsageError(phrase("{} must lie between {:g} and 1000 mm", option(key, value), least))
        if not (isfinite(self.margin) and 0.0 <= self.margin <= 1000.0):
            raise UsageError(phrase("the margin {:g} at corners must lie between 0 and 1000 mm", self.margin))
        if not self.free_width > 2 * self.ball_radius + self.stock:
            raise UsageError(
                phrase("{}: the ball and the stock do not fit in there", option("free_width", self.free_width))
            )
        if self.touch not in TOUCHES:
            raise UsageError(phrase("{} is one of {}, not {!r}", option("touch"), ", ".join(TOUCHES), self.touch))


@dataclass(frozen=True, slots=True)
class Placement:
    """Where points are wanted.

    Parameters
    ----------
    count : int, optional
        Number of points.
    spacing : float, optional
        Largest distance along the contour in mm, in place of `count`.
    by_curvature : bool
        Half of the points by length, half by how much the contour turns: denser where it bends.
    stretch : int, optional
        Only on this smooth stretch, counted from 1 in the order of the profile, or of the chosen contour.
    contour : int, optional
        Only on this contour, counted from 1.
    """

    count: int | None = None
    spacing: float | None = None
    by_curvature: bool = False
    stretch: int | None = None
    contour: int | None = None

    def __post_init__(self) -> None:
        if (self.count is None) == (self.spacing is None):
            raise UsageError(phrase("give either {} or {}", option("points_count"), option("spacing")))
        if self.count is not None and not 1 <= self.count <= MOST_POINTS:
            raise UsageError(phrase("{} must lie between 1 and {}", option("points_count", self.count), MOST_POINTS))
        if self.spacing is not None and not (isfinite(self.spacing) and self.spacing > 0):
            raise UsageError(phrase("{} is no distance in mm", option("spacing", self.spacing)))


@dataclass(frozen=True, slots=True)
class LeftOut:
    """A place where no touch is planned, in mm, and why."""

    x: float
    y: float
    reason: str


@dataclass(frozen=True, slots=True)
class Touch:
    """One touch; lengths in mm, places are those of the ball's centre but for `contact`.

    Parameters
    ----------
    number : int
        From 1.
    contact, normal : tuple of 2 float
        Intended point on the nominal contour and directional cosines there.
    start, target : tuple of 2 float
        Where the touch starts, and where it gives up.
    direction : tuple of 2 float
        Unit vector of travel.
    centre : tuple of 2 float
        Ball centre when it touches the nominal contour.
    axis : {'X', 'Y', ''}
        Axis of travel, or none.
    """

    number: int
    contact: tuple[float, float]
    normal: tuple[float, float]
    start: tuple[float, float]
    target: tuple[float, float]
    direction: tuple[float, float]
    centre: tuple[float, float]
    axis: str


@dataclass(frozen=True, eq=False, slots=True)
class ProbingPlan(ReadOnlyArrays):
    """Touches in the order in which they are made.

    Parameters
    ----------
    probe : TouchProbe
    contact, normal : (n, 2) float64
        Intended points on the nominal contour in mm, and directional cosines there.
    direction : (n, 2) float64
        Unit vectors of travel.
    start, target : (n, 2) float64
        Ball centre in mm where a touch starts, and where it gives up.
    contour : (n,) int64
    s : (n,) float64
        Arc length in mm of the contact from the contour's start.
    links : tuple of ((k, 2) float64 or None)
        Way of the ball's centre from the start of each touch to that of the next one, both included; None where it
        leads over the safe height. One fewer than touches.
    left_out : tuple of LeftOut
    """

    probe: TouchProbe
    contact: Floats
    normal: Floats
    direction: Floats
    start: Floats
    target: Floats
    contour: Ints
    s: Floats
    links: tuple[Floats | None, ...]
    left_out: tuple[LeftOut, ...]

    def __len__(self) -> int:
        return len(self.contact)

    @property
    def centre(self) -> Floats:
        """Ball centre in mm when it touches the nominal contour; (n, 2)."""
        out: Floats = self.contact + self.probe.ball_radius * self.normal
        return out

    def touches(self) -> Iterator[Touch]:
        """The touches one by one."""
        arrays = (self.contact, self.normal, self.start, self.target, self.direction, self.centre)
        for k, row in enumerate(zip(*(a.tolist() for a in arrays), strict=True), 1):
            contact, normal, start, target, direction, centre = (tuple(v) for v in row)
            axis = "X" if direction[1] == 0 else "Y" if direction[0] == 0 else ""
            yield Touch(k, contact, normal, start, target, direction, centre, axis)


@dataclass(frozen=True, eq=False, slots=True)
class Wanted:
    """Where touches are wanted, in the order of the profile.

    Parameters
    ----------
    contour : (n,) int64
    s : (n,) float64
        Arc length in mm from the contour's start.
    contact, normal : (n, 2) float64
        Places in mm and directional cosines there.
    left_out : tuple of LeftOut
        Stretches too short for any point.
    """

    contour: Ints
    s: Floats
    contact: Floats
    normal: Floats
    left_out: tuple[LeftOut, ...]


def wanted(profile: Profile, placement: Placement, probe: TouchProbe) -> Wanted:
    """Where touches are wanted on a contour; raises as `places` does."""
    contour, s, left_out = places(profile, placement, probe.ball_radius + probe.margin)
    span, t = profile.locate(contour, s)
    contact, _, _ = profile.evaluate(span, t)
    return Wanted(contour, s, contact, profile.normals(span, t), tuple(left_out))


def plan(
    profile: Profile,
    at: Placement | Wanted,
    probe: TouchProbe,
    cutter_radius: float = 0.0,
    *,
    standing: Bools | None = None,
    obstacles: Obstacles | None = None,
) -> ProbingPlan:
    """Touches on a contour.

    Parameters
    ----------
    profile : Profile
        Nominal, material on the left.
    at : Placement or Wanted
    probe : TouchProbe
    cutter_radius : float
        Radius in mm of the cutter that made the part: the fillets that it leaves in inner corners are neither
        touched nor come near to.
    standing : (n,) bool, optional
        Whether a touch at each wanted place meets a wall at all.
    obstacles : Obstacles, optional
        What else stands at the height of the ball, and above.

    Returns
    -------
    ProbingPlan
        Points where the ball does not fit or has no room are left out, with the reason.

    Raises
    ------
    UsageError
        If there is no such contour or stretch.
    RefusedError
        If nothing is left; names the first place and why.
    """
    where = at if isinstance(at, Wanted) else wanted(profile, at, probe)
    contour, s, contact, normal = where.contour, where.s, where.contact, where.normal
    direction = touch_directions(normal, probe.touch)
    steep = -(normal * direction).sum(axis=1)
    centre = contact + probe.ball_radius * normal
    search = FootPointSearch(profile, margin=2 * probe.ball_radius + probe.clearance + probe.stock)
    space = Space(search, cutter_radius, obstacles)
    start, reason = _starts(space, centre, direction, steep, probe)
    in_the_way = _other_wall_first(space, start, centre, steep, probe)
    reason = np.where(in_the_way & (reason == ""), _IN_THE_WAY, reason)
    reason = np.where(_too_tight(search, centre, probe), _TIGHT, reason)
    if cutter_radius > 0:
        cutter = search.find(contact + cutter_radius * normal)
        reason = np.where(cutter.distance < cutter_radius - REACHED, _FILLET, reason)
    if standing is not None:
        reason = np.where(standing, reason, _NOTHING)
    left_out = list(where.left_out)
    for row in np.flatnonzero(reason != ""):
        left_out.append(LeftOut(float(contact[row, 0]), float(contact[row, 1]), _SAID[str(reason[row])]))
    good = reason == ""
    if not good.any():
        worst = left_out[0] if left_out else None
        first = phrase("near {} {}", xy(worst.x, worst.y), worst.reason) if worst else phrase("no stretch")
        too_high = worst is not None and worst.reason == _NOTHING
        check = option("z") if too_high else phrase("{} and {}", option("probe_radius"), option("clearance"))
        raise RefusedError(phrase("no point of the contour can be touched: {}; check {}", first, check))
    target = centre + (probe.overtravel / steep)[:, None] * direction
    start, contour, s = start[good], contour[good], s[good]
    links = links_between(
        space, contour, s, start,
        stand=probe.ball_radius + probe.stock + probe.clearance,
        least=probe.ball_radius + probe.stock + probe.clearance / 2,
        most=probe.free_width - probe.ball_radius,
    )  # fmt: skip
    return ProbingPlan(
        probe, contact[good], normal[good], direction[good], start, target[good], contour, s, links, tuple(left_out)
    )


def touch_directions(normal: Floats, touch: str = "auto") -> Floats:
    """Unit vectors of travel for touches, towards the material.

    Parameters
    ----------
    normal : (n, 2) float64
        Directional cosines.
    touch : {'auto', 'axis', 'normal'}
        As in `TouchProbe`.

    Returns
    -------
    (n, 2) float64
        Against the larger component of the normal, or against the normal (petrakov-2018: along X or Y, whichever
        the normal is nearer).
    """
    if touch == "normal":
        out: Floats = -normal
        return out
    along_x = np.abs(normal[:, 0]) >= np.abs(normal[:, 1])
    out = np.where(np.stack([along_x, ~along_x], axis=1), -np.sign(normal), 0.0)
    if touch == "axis":
        return out
    angle = np.arctan2(np.abs(normal[:, 1]), np.abs(normal[:, 0]))
    tie = np.abs(angle - np.pi / 4) < TIE
    out[tie] = -normal[tie]
    return out


def places(profile: Profile, placement: Placement, keep: float) -> tuple[Ints, Floats, list[LeftOut]]:
    """Contours and arc lengths of the wanted points.

    Parameters
    ----------
    profile : Profile
    placement : Placement
    keep : float
        Distance in mm kept from corners and open ends, along the contour.

    Returns
    -------
    contour : (n,) int64
    s : (n,) float64
        mm from the contour's start; in the order of the profile.
    left_out : list of LeftOut
        Stretches too short for any point.

    Raises
    ------
    UsageError
        If there is no such contour or stretch.
    RefusedError
        If every stretch is too short.
    """
    stretches = profile.stretches()
    if placement.contour is not None:
        if not 1 <= placement.contour <= len(profile.contours):
            raise UsageError(
                phrase("{}: the profile has {} contours", option("contour", placement.contour), len(profile.contours))
            )
        stretches = [stretch for stretch in stretches if stretch.contour == placement.contour - 1]
    if placement.stretch is not None:
        if not 1 <= placement.stretch <= len(stretches):
            raise UsageError(
                phrase("{}: there are {} smooth stretches", option("stretch", placement.stretch), len(stretches))
            )
        stretches = stretches[placement.stretch - 1 : placement.stretch]
    left_out: list[LeftOut] = []
    pieces: list[tuple[int, Floats, Floats]] = []
    for stretch in stretches:
        first, last = (0.0, stretch.length) if stretch.closed else (keep, stretch.length - keep)
        if last <= first:
            middle, _ = profile.at(stretch.contour, np.array([stretch.begin + stretch.length / 2]))
            short = phrase(
                "the stretch of {} between corners is shorter than {}", mm(stretch.length), mm(2 * keep, "g")
            )
            left_out.append(LeftOut(float(middle[0, 0]), float(middle[0, 1]), short))
            continue
        steps = int(np.clip(np.ceil((last - first) / 0.05), 64, 4000))
        along = np.linspace(first, last, steps + 1)
        _, normal = profile.at(stretch.contour, stretch.begin + along)
        turn = np.arctan2(
            normal[:-1, 0] * normal[1:, 1] - normal[:-1, 1] * normal[1:, 0], (normal[:-1] * normal[1:]).sum(axis=1)
        )
        pieces.append((stretch.contour, stretch.begin + along, np.concatenate([[0.0], np.cumsum(np.abs(turn))])))
    if not pieces:
        raise RefusedError(
            phrase(
                "no point of the contour can be touched: {} near {}; use a smaller ball",
                left_out[0].reason,
                xy(left_out[0].x, left_out[0].y),
            )
        )
    length = sum(float(along[-1] - along[0]) for _, along, _ in pieces)
    turned = sum(float(turn[-1]) for _, _, turn in pieces)
    number = placement.count or int(min(np.ceil(length / (placement.spacing or length)), MOST_POINTS + 1))
    if number > MOST_POINTS:
        raise UsageError(phrase("{} makes more than {} points", option("spacing", placement.spacing), MOST_POINTS))
    shares = (np.arange(number) + 0.5) / number
    by_turn = 0.5 if placement.by_curvature and turned > 1e-6 else 0.0
    contour, s, before = [], [], 0.0
    for index, along, turn in pieces:
        measure = before + (1 - by_turn) * (along - along[0]) / length + by_turn * turn / max(turned, 1e-6)
        here = shares[(shares >= before) & (shares < measure[-1])]
        s.append(np.interp(here, measure, along))
        contour.append(np.full(len(here), index, dtype=np.int64))
        before = float(measure[-1])
    which = np.concatenate(contour)
    return which, np.mod(np.concatenate(s), profile.total[which]), left_out


_TIGHT = phrase("the ball does not reach it: the contour is too hollow there, or another wall is too near")
_FILLET = phrase("the cutter does not reach it: its fillet stands there")
_IN_THE_WAY = phrase("another wall is in the way of the touch")
_NOTHING = phrase("no wall stands there that is as high, and cut as deep, as the ball needs it")
_NO_ROOM = phrase("there is no room for the ball to stand clear before the touch")
_SAID = {str(reason): reason for reason in (_TIGHT, _FILLET, _IN_THE_WAY, _NOTHING, _NO_ROOM)}
"""Reasons by what an array keeps of them."""


def _starts(
    space: Space, centre: Floats, direction: Floats, steep: Floats, probe: TouchProbe
) -> tuple[Floats, NDArray[np.str_]]:
    """Where touches start, and a reason where there is no such place."""
    back_off = probe.stock + probe.clearance
    least = probe.ball_radius + probe.stock + probe.clearance / 2
    start = centre - (back_off / steep)[:, None] * direction
    reason = np.full(len(centre), _NO_ROOM, dtype="U100")
    open_rows = np.arange(len(centre))
    for longer in _LENGTHENED:
        back = longer * back_off / steep[open_rows]
        tried = centre[open_rows] - back[:, None] * direction[open_rows]
        own, nearest = space.distances(tried)
        good = (nearest >= least) & (own + probe.ball_radius <= probe.free_width + 1e-6)
        start[open_rows[good]] = tried[good]
        reason[open_rows[good]] = ""
        open_rows = open_rows[~good]
        if not len(open_rows):
            break
    return start, reason


def _too_tight(search: FootPointSearch, centre: Floats, probe: TouchProbe) -> Bools:
    """Whether a ball that should touch the nominal in one place overlaps it, or nearly, in another."""
    feet = search.find(centre, rivals=True)
    out: Bools = (feet.distance < probe.ball_radius - REACHED) | (feet.rival < probe.margin / 2)
    return out


def _other_wall_first(space: Space, start: Floats, centre: Floats, steep: Floats, probe: TouchProbe) -> Bools:
    """Whether the ball, on its way to the touch, comes nearer to the contour than to the place it should touch.

    Beside a flat wall, and a convex one, the gap is the way left times the cosine of the slope or more; half of that
    leaves room for a hollow.
    """
    u = np.linspace(0.0, 1.0, 33)[:-1]
    way = np.hypot(*(centre - start).T)
    points = (start[:, None, :] * (1 - u)[:, None] + centre[:, None, :] * u[:, None]).reshape(-1, 2)
    _, nearest = space.distances(points)
    gap = nearest.reshape(len(start), -1) - probe.ball_radius
    expected = 0.5 * steep[:, None] * way[:, None] * (1 - u)
    out: Bools = (gap < expected - REACHED).any(axis=1)
    return out
