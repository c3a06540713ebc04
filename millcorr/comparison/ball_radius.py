# SPDX-License-Identifier: LGPL-2.1-or-later
"""The radius of the probe's ball, taken back where a control put it in wrongly and applied along the normal.

A simple cycle (Renishaw O9811 and its like) reports ``p = c + r a``: the ball's centre c, shifted by the radius r
along the direction of travel a. The surface is touched at ``c - r n`` instead. With theta between travel and normal,
p lies ``r (1 - cos theta)`` too far out along the normal, which is ``r (1 / cos theta - 1)`` along the axis: nothing
where the slope is a multiple of 90 degrees, 0.40 mm at 30 degrees and r = 3 (petrakov-2018, fig. 4).

Back to the centre is exact, since ``c = p - r a`` holds only a and r; from there the deviation needs the normal at the
foot of the centre, which is the normal where the ball touches. Nothing is iterated and nothing is left over.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, option, phrase, remedy, um
from millcorr.readers.measurement import Measurement
from millcorr.readers.measurement import Probe as Probe
from millcorr.readers.names import Names

from .deviation import REACH, Deviation, Rejected

MARGIN = np.radians(1.0)
"""Nearer to 45 degrees than this, the rule does not tell along which axis a point was touched."""

GRAZING = 0.1
"""Travel towards the material has at least this share along the normal: 84 degrees off, a ball slides."""

SMALLEST_BALL = 0.4
"""A signature of a smaller ball, in mm, is not told from deviations that machining leaves."""

FOLLOWS_SLOPE = 0.02
"""Deviations that follow the slope with less scatter than this, in mm, corners that give way leave, too (13 um)."""

_LEFT = 0.7
_NO_SHIFT = 0.2
_AXES = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
_SAMPLE = 500
_ON_THE_PART = 4.0

_REASONS = (
    phrase("touched along X or along Y: the slope is too near to 45 degrees to tell, and the file does not say"),
    phrase("touched neither along X nor along Y by the slope of the profile, and the file does not say"),
    phrase("the probe did not travel towards the material here"),
)
_EITHER, _NEITHER, _AWAY = range(3)


def contact_known(measurement: Measurement, nominal: Profile) -> Measurement:
    """Ball centres with the one radius at which deviations from the profile are right.

    Parameters
    ----------
    measurement : Measurement
        Where it has `axis_radii`, ball centres shifted along the axis of travel: by its own directions of travel,
        else by the rule of petrakov-2018, along X where the normal is nearer to X, along Y where nearer to Y. Where
        it has a `probe`, that calibration is applied.
    nominal : Profile
        Tells the normals.

    Returns
    -------
    Measurement
        The same one where there is nothing to do. Else ball centres; points whose direction of travel cannot be
        told, or leads away from the material, are in `left_out`.

    Raises
    ------
    InputError
        If no point is left, or two radii leave open by which one a point was shifted.

    Notes
    -----
    By the rule each of the four directions +X, -X, +Y, -Y is a hypothesis: it gives a centre, the centre a foot, the
    foot a normal. It is possible if that normal lies within 46 degrees of it and the deviation within `REACH`. Only
    one possible hypothesis decides. The normal where the ball touched decides so, not the one below the reported
    point, which lies up to ``r sin theta`` beside it.

    A radius by direction changes nothing in the foot: the centre moves along its own normal, to where a ball of the
    mean radius would stand.
    """
    probe, shifted, radius = measurement.probe, measurement.axis_radii, measurement.ball_radius
    if shifted is None and probe is None:
        return measurement
    if shifted is not None:
        radius += shifted[0] if probe is None else probe.radius
    search = FootPointSearch(nominal, margin=REACH + radius)
    points = measurement.points.copy()
    if probe is not None:
        points[:, :2] += probe.offset
    reasons = np.full(len(points), -1)
    if shifted is not None:
        travel, reasons = _travel(measurement, points[:, :2], radius, search)
        points -= _shift(measurement, travel, shifted)
    rows = np.flatnonzero(reasons < 0)
    if not len(rows):
        why = _REASONS[int(np.bincount(reasons).argmax())]
        raise InputError(
            phrase(
                "{}: the probe's radius can be taken back at none of {} points, most are {}: check {}, {} "
                "and the work frame, or give each point's direction of travel",
                measurement.source,
                len(points),
                why,
                option("points"),
                option("probe_radius"),
            ),
        )
    known = _of(measurement, rows, points[rows], radius, reasons)
    if probe is None or probe.directions is None:
        return known
    moved = known.points.copy()
    normal = search.find(moved[:, :2]).normal if known.normals is None else _facing(search, moved, known.normals)
    excess = probe.effective(np.arctan2(-normal[:, 1], -normal[:, 0])) - probe.radius
    moved[:, :2] -= excess[:, None] * normal
    return replace(known, points=moved)


def numbered_as_read(deviation: Deviation, measurement: Measurement) -> Deviation:
    """Deviations whose rows count the file's points, also those that `contact_known` left out and why.

    Parameters
    ----------
    deviation : Deviation
        Of the measurement.
    measurement : Measurement
        What `contact_known` gave, aligned or not.
    """
    if not measurement.left_out:
        return deviation
    gone = [row for row, _ in measurement.left_out]
    rows = np.delete(np.arange(len(measurement) + len(gone)), gone)
    rejected = [Rejected(int(rows[r.index]), r.reason) for r in deviation.rejected]
    rejected += [Rejected(row, reason) for row, reason in measurement.left_out]
    return replace(deviation, index=rows[deviation.index], rejected=tuple(sorted(rejected, key=lambda r: r.index)))


def axis_signature(measurement: Measurement, nominal: Profile) -> tuple[str, str, bool] | None:
    """Whether points said to be contact points or ball centres look shifted along the axis of travel.

    Parameters
    ----------
    measurement : Measurement
    nominal : Profile

    Returns
    -------
    (name, text, dangerous) or None
        What `millcorr.plausibility.Finding` takes.

    Notes
    -----
    The distances from the profile then grow with the slope, as ``r (1 - cos theta)``. A straight line through them
    gives a first r; then the shift is taken back as `contact_known` does it, with the r that leaves the least
    scatter. It must leave less than half of what there is.
    """
    if measurement.axis_radii is not None or measurement.probe is not None:
        return None
    step = max(1, len(measurement) // _SAMPLE)
    search = FootPointSearch(nominal)
    feet = search.find(measurement.points[::step])
    points, z = measurement.points[::step, :2], measurement.points[::step, 2]
    use = np.flatnonzero((feet.place == Place.SMOOTH) & (np.abs(feet.distance) < _ON_THE_PART))
    slope = 1.0 - np.abs(feet.normal[use]).max(axis=1)
    if len(use) < 10 or slope.std() < 0.02:
        return None
    distance = feet.distance[use]
    design = np.column_stack([np.ones(len(use)), slope])
    (at_zero, first), *_ = np.linalg.lstsq(design, distance, rcond=None)
    if first < SMALLEST_BALL / 2 or (distance - design @ (at_zero, first)).std() > 0.7 * distance.std():
        return None

    def left(radius: float) -> tuple[float, float]:
        """Scatter of the clear points with the shift taken back, and as they were, mm."""
        travel, reasons = _by_rule(points[use], (radius, radius), radius, search)
        clear = np.flatnonzero(reasons < 0)
        if len(clear) < max(10, len(use) // 4):
            return np.inf, 0.0
        taken_back = np.column_stack([points[use][clear] - radius * travel[clear], z[use][clear]])
        return _scatter(search.find(taken_back).distance), _scatter(distance[clear])

    # On curved contours the line bends: search round its slope, then between the neighbours of the best.
    radii = first * np.geomspace(0.4, 2.5, 19)
    for _ in range(3):
        best = int(np.argmin([left(r)[0] for r in radii]))
        radius = float(radii[best])
        radii = np.linspace(radii[max(best - 1, 0)], radii[min(best + 1, len(radii) - 1)], 9)
    after, before = left(radius)
    if radius < SMALLEST_BALL or not after < 0.5 * before:
        return None
    low, high = np.percentile(distance, [2, 98])
    text = phrase(
        "the points lie {:+.3f} to {} off the profile, by its slope, as if the control had shifted "
        "them along X and Y by the radius of a ball of about {}; taken back, {:.0f} of {} of scatter "
        "are left: {} with {} from the probe's calibration",
        low,
        mm(high, "+.3f"),
        mm(radius, ".2f"),
        after * 1000,
        um(before, ".0f"),
        remedy("points", "axis"),
        option("probe_radius"),
    )
    return "axis-compensated", text, True


def axis_residue(shifted: Measurement, known: Measurement, nominal: Profile) -> tuple[str, str, bool] | None:
    """Whether taking a shift along the axis of travel back left, or made, a shift of the same kind.

    Parameters
    ----------
    shifted : Measurement
        As read, with `axis_radii`.
    known : Measurement
        What `contact_known` made of it.
    nominal : Profile

    Returns
    -------
    (name, text, dangerous) or None
        What `millcorr.plausibility.Finding` takes.

    Notes
    -----
    With the radius R taken back where the control had put in r, ``(r - R) (1 - cos theta)`` is left of every
    deviation; where it had put in nothing, r is 0. A straight line over ``1 - cos theta`` gives r - R.
    """
    if shifted.axis_radii is None:
        return None
    step = max(1, len(known) // _SAMPLE)
    feet = FootPointSearch(nominal, margin=REACH + known.ball_radius).find(known.points[::step])
    value = feet.distance - known.ball_radius
    use = np.flatnonzero((feet.place == Place.SMOOTH) & (np.abs(value) < _ON_THE_PART))
    slope = 1.0 - np.abs(feet.normal[use]).max(axis=1)
    if len(use) < 10 or slope.std() < 0.02:
        return None
    value = value[use]
    design = np.column_stack([np.ones(len(use)), slope])
    (_, excess), *_ = np.linalg.lstsq(design, value, rcond=None)
    before, after = _scatter(value), _scatter(value - slope * excess)
    if abs(excess) * slope.std() < FOLLOWS_SLOPE or not after < _LEFT * before:
        return None
    radius = max(shifted.axis_radii)
    seen = phrase(
        "with the shift by {} along the axis of travel taken back, {} times (1 - cos) of the slope "
        "is left, {} of scatter, {} without it",
        mm(radius, "g"),
        mm(excess, "+.3f"),
        um(before, ".0f"),
        um(after, ".0f"),
    )
    if abs(excess + radius) < _NO_SHIFT * radius:
        text = phrase(
            "{}: the points were not shifted along the axis: {}, or centre with {}",
            seen,
            remedy("points", "contact"),
            option("probe_radius"),
        )
        return "not-axis-compensated", text, True
    return (
        "axis-radius",
        phrase("{}: {} seems to be about {:.2f}; see its calibration", seen, option("probe_radius"), radius + excess),
        True,
    )


def _scatter(value: Floats) -> float:
    """Standard deviation without the outermost 2 % on either side."""
    return float(np.clip(value, *np.percentile(value, [2, 98])).std())


def _travel(measurement: Measurement, points: Floats, radius: float, search: FootPointSearch) -> tuple[Floats, Ints]:
    """Direction of travel of each point, (n, 3), and why it is not known, (n,), else -1."""
    assert measurement.axis_radii is not None
    n = len(points)
    if measurement.travel is not None:
        travel = measurement.travel
        centres = np.column_stack([points, np.zeros(n)]) - _shift(measurement, travel, measurement.axis_radii)
        if measurement.normals is None:
            normal = search.find(centres[:, :2]).normal
        else:
            normal = _facing(search, centres, measurement.normals)
        return travel, np.where(-(travel[:, :2] * normal).sum(axis=1) < GRAZING, _AWAY, -1)
    if measurement.normals is None:
        flat, reasons = _by_rule(points, measurement.axis_radii, radius, search)
    else:
        nx, ny = measurement.normals[:, 0], measurement.normals[:, 1]
        slope = np.arctan2(np.abs(ny), np.abs(nx))
        along_x = slope < np.pi / 4
        flat = np.stack([np.where(along_x, -np.sign(nx), 0.0), np.where(along_x, 0.0, -np.sign(ny))], axis=1)
        reasons = np.where(np.abs(slope - np.pi / 4) <= MARGIN, _EITHER, -1)
    return np.column_stack([flat, np.zeros(n)]), reasons


def _by_rule(
    points: Floats, shifted: tuple[float, float], radius: float, search: FootPointSearch
) -> tuple[Floats, Ints]:
    """Direction of travel by the slope where the ball touched, (n, 2), and why it is not known, (n,), else -1."""
    possible = np.empty((4, len(points)), dtype=bool)
    for k, axis in enumerate(_AXES):
        feet = search.find(points - axis * shifted)
        towards = -(feet.normal @ axis)
        possible[k] = (towards >= np.cos(np.pi / 4 + MARGIN)) & (np.abs(feet.distance - radius) <= REACH)
    count = possible.sum(axis=0)
    reasons = np.where(count == 0, _NEITHER, np.where(count > 1, _EITHER, -1))
    return _AXES[possible.argmax(axis=0)], reasons


def _shift(measurement: Measurement, travel: Floats, radii: tuple[float, float]) -> Floats:
    """What the control added to the ball's centres, (n, 3) in mm."""
    x, y = radii
    if x != y:
        if measurement.probe is None:
            raise InputError(
                phrase("{}: two radii of a shift need a probe that says the effective one", measurement.source)
            )
        oblique = np.flatnonzero((np.abs(travel) > 1e-9).sum(axis=1) > 1)
        if len(oblique):
            raise InputError(
                phrase(
                    "{}: the probe travelled along no axis, and control_radius has one radius for X and another "
                    "one for Y",
                    measurement.origin(int(oblique[0])),
                )
            )
    out: Floats = travel * np.array([x, y, x])
    return out


def _facing(search: FootPointSearch, points: Floats, normals: Floats) -> Floats:
    """Normals of the profile, (n, 2), below points whose measured normals choose the side."""
    flat = np.ascontiguousarray(points[:, :2])
    return search.on_the_side_of(flat, normals[:, :2], search.find(flat)).normal


def _of(measurement: Measurement, rows: Ints, points: Floats, radius: float, reasons: Ints) -> Measurement:
    """The chosen rows as ball centres; the others are left out."""

    def chosen(array: Floats | None) -> Floats | None:
        return None if array is None else array[rows]

    elements = measurement.elements
    return replace(
        measurement,
        points=points,
        normals=chosen(measurement.normals),
        ball_radius=radius,
        lines=measurement.lines[rows],
        nominal=chosen(measurement.nominal),
        elements=None if elements is None else Names(elements[row] for row in rows.tolist()),
        stated=chosen(measurement.stated),
        axis_radii=None,
        travel=None,
        probe=None,
        left_out=tuple((int(row), _REASONS[reasons[row]]) for row in np.flatnonzero(reasons >= 0)),
    )
