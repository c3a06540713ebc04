# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows from where the measured points lie: unit, side, frame, ball, thin walls."""

from __future__ import annotations

import numpy as np

from millcorr import progress
from millcorr.arrays import Bools, Floats
from millcorr.comparison.ball_radius import axis_signature
from millcorr.comparison.deviation import REACH
from millcorr.geometry.footpoint import FootPoints, FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.messages import message, mm, option, phrase, remedy, xy
from millcorr.nc.codes import INCH
from millcorr.readers.measurement import Measurement

from . import elastic
from .findings import Finding

CONSTANT_OFFSET = 0.2
"""A median deviation beyond this, in mm, with little scatter is no machining error."""

SMALL_SCATTER = 0.15
"""Scatter of an offset, as a share of it, up to which it counts as constant."""

LARGE = 0.05
"""Deviations typically beyond this, in mm, make it worth looking whether another frame fits far better."""

FAR_BETTER = 0.2
"""Another frame fits far better where the deviations are at most this share of what they were."""

OTHER_NOMINAL = 0.05
"""The file's own nominal points lie at most this far, in mm, from the profile if both mean the same part."""

THIN_WALL = 2.0
"""Walls below this, in mm, can be taken for their other side: points are believed up to 1 mm off."""

CERTAIN = 0.25
"""Without normals a side is certain up to deviations of this share of the wall: the other is three times as far."""

SOME = 0.02
"""A larger share of points on the wrong side of a wall is no slip at single points."""

LARGER = 1.5
"""Points spread at most this much wider than the profile that they were measured on."""

SAMPLE = 2000
"""So many points, evenly chosen, are enough to recognise a wrong unit or frame."""


def examine_points(
    measurement: Measurement, profile: Profile, cutter_radius: float, depth: float = 0.0, allowance: float = 0.0
) -> tuple[Finding, ...]:
    """Signs of a wrong unit, frame, side or probe radius, from where the points lie.

    Parameters
    ----------
    measurement : Measurement
    profile : Profile
        Nominal.
    cutter_radius : float
        mm; tells a wrong side.
    depth : float
        Depth in mm along the normal that the part was cut at, where elastic deviations are expected; 0 elsewhere.
    allowance : float
        Stock in mm that is said to be left over the profile. To the geometry it is the same as so much more of a ball,
        and in `ball_radius` already.

    Returns
    -------
    tuple of Finding
    """
    progress.step()
    search = FootPointSearch(profile)
    step = max(1, len(measurement) // SAMPLE)
    points = measurement.points[::step]
    if not len(points):
        return ()
    own = _other_nominal(measurement, search, step)
    ball = measurement.ball_radius
    feet = search.find(points)
    if measurement.normals is not None:
        normals = measurement.normals[::step, :2]
        said = search.on_the_side_of(points, normals, feet)
        turned = _normals_reversed(measurement, normals, feet, said)
        own = (*turned, *own)
        # Normals the wrong way round say the wrong side.
        feet = feet if turned else said
    value = feet.distance - ball
    offset, scatter = _middle(value)
    size = np.abs(value)
    near, typical = float((size <= REACH).mean()), float(np.median(size))
    if near < 0.9 or scatter > LARGE:
        wrong_frame = _wrong_frame(points[:, :2], search, ball, near, typical)
        if wrong_frame is not None:
            return (wrong_frame, *own)
    if abs(offset) >= CONSTANT_OFFSET and scatter <= SMALL_SCATTER * abs(offset):
        constant = _constant_offset(offset, scatter, ball - allowance, cutter_radius, depth, allowance)
        if constant.dangerous:
            return (constant, *own)
        own = (constant, *own)
    shifted = axis_signature(measurement, profile)
    if shifted is not None:
        return (Finding(*shifted), *own)
    return (*_thin_walls(measurement, search, feet, value, step), *own)


def _other_nominal(measurement: Measurement, search: FootPointSearch, step: int) -> tuple[Finding, ...]:
    """The file's own nominal points compared with the profile."""
    if measurement.nominal is None:
        return ()
    nominal = measurement.nominal[::step]
    nominal = nominal[np.isfinite(nominal).all(axis=1)]
    away = float(np.median(np.abs(search.find(nominal).distance))) if len(nominal) else 0.0
    if away <= OTHER_NOMINAL:
        return ()
    text = phrase(
        "the file's own nominal points lie {} off the profile: check {}, the operation and the work frame",
        mm(away),
        option("nominal"),
    )
    return (Finding("other-nominal", text, True, figure=away),)


def _normals_reversed(
    measurement: Measurement, normals: Floats, nearest: FootPoints, said: FootPoints
) -> tuple[Finding, ...]:
    """Normals that point into the material; `said` are the feet on the sides that the normals say."""
    value = nearest.distance - measurement.ball_radius
    belongs = (np.abs(value) <= REACH) & (nearest.place == Place.SMOOTH)
    length, facing = np.hypot(*normals.T), (normals * nearest.normal).sum(axis=1)
    against = belongs & (length > 0.1) & (facing < -0.5 * length)
    if against.sum() <= 0.5 * belongs.sum():
        return ()
    # Where no side faces as the normal does none is near; a thin wall's other side is near, but far less so.
    moved = (said.normal * nearest.normal).sum(axis=1) < 0.0
    other = np.where(moved, np.abs(said.distance - measurement.ball_radius), np.inf)
    if np.median(np.abs(value[against])) > FAR_BETTER * np.median(other[against]):
        return ()
    text = phrase(
        "the normals of {} of {} points point into the material: export normals out of the material, "
        "not directions of approach",
        int(against.sum()),
        int(belongs.sum()),
    )
    return (Finding("normals-reversed", text, bool(moved[against].any())),)


def _thin_walls(
    measurement: Measurement, search: FootPointSearch, feet: FootPoints, value: Floats, step: int
) -> tuple[Finding, ...]:
    """Points on walls so thin that either side may be meant, where no normals say which."""
    belongs = (np.abs(value) <= REACH) & (feet.place == Place.SMOOTH)
    if measurement.normals is not None or not belongs.any():
        return ()
    wall = _wall(search, feet, belongs)
    doubtful = np.abs(value) >= CERTAIN * wall
    if not doubtful.any():
        return ()
    worst = int(np.argmin(np.where(doubtful, wall, np.inf)))
    x, y = measurement.points[worst * step, :2]
    count = int(doubtful.sum())
    text = phrase(
        "points on thin walls that lie so far off that the other side may be meant: {}, the thinnest wall {} ({}, {}); "
        "the file has no normals: export normals",
        count,
        mm(wall[worst]),
        xy(x, y),
        measurement.origin(worst * step),
    )
    return (Finding("thin-wall", text, bool(count >= 3 and count > SOME * len(value)), place=(float(x), float(y))),)


def _wall(search: FootPointSearch, feet: FootPoints, rows: Bools) -> Floats:
    """Thickness of the material behind foot points, mm; infinite from THIN_WALL on and where no side faces away.

    Seen from half of THIN_WALL below the surface the opposite side is at the thickness less that half.
    """
    wall = np.full(len(feet.distance), np.inf)
    at = np.flatnonzero(rows)
    depth = 0.5 * THIN_WALL
    other = search.find(feet.foot[at] - depth * feet.normal[at])
    away = (other.normal * feet.normal[at]).sum(axis=1) < -0.7
    thickness = depth - other.distance
    found = away & (thickness < THIN_WALL) & (thickness > 0.0)
    wall[at[found]] = thickness[found]
    return wall


def _middle(value: Floats) -> tuple[float, float]:
    """Median, and scatter as the standard deviation of a normal distribution with the same quartiles."""
    low, middle, high = np.percentile(value, [25.0, 50.0, 75.0])
    return float(middle), float((high - low) / 1.349)


def _wrong_frame(points: Floats, search: FootPointSearch, ball: float, near: float, typical: float) -> Finding | None:
    """A unit, mirroring or turn in which clearly more points lie on the profile, or all of them far nearer.

    A part whose zero is at its corner has half of its points on the profile in either unit; one that is nearly
    its own mirror image has all of them nearly on it.
    """
    x, y = points.T
    mirror = phrase("mirror the work frame of the measurement")
    turn = phrase("turn the work frame of the measurement back")
    attempts = (
        (
            "unit",
            phrase("times {:g}", INCH),
            points * INCH,
            phrase("the file is in inches: {}", remedy("units", "inch")),
        ),
        (
            "unit",
            phrase("divided by {:g}", INCH),
            points / INCH,
            phrase("the file is in millimetres or was converted twice: {}", remedy("units", "mm")),
        ),
        ("mirrored", phrase("with x reversed"), np.column_stack([-x, y]), mirror),
        ("mirrored", phrase("with y reversed"), np.column_stack([x, -y]), mirror),
        ("mirrored", phrase("with x and y exchanged"), np.column_stack([y, x]), phrase("exchange the columns x and y")),
        ("mirrored", phrase("with x and y exchanged and reversed"), np.column_stack([-y, -x]), mirror),
        ("turned", phrase("turned by {} degrees", 180), -points, turn),
        ("turned", phrase("turned by {} degrees", 90), np.column_stack([-y, x]), turn),
        ("turned", phrase("turned by {} degrees", -90), np.column_stack([y, -x]), turn),
    )
    best: tuple[float, Finding] | None = None
    # A part with its zero at a corner lies on the profile as a speck, too: in its unit it is as large as the profile.
    size, wanted = _extent(points), _extent(np.reshape(search.profile.bounding_box(), (2, 2)))
    for name, how, changed, way_out in attempts:
        times = _extent(changed) / size if size > 0 else 1.0
        if (times > 2.0 and _extent(changed) > LARGER * wanted) or (times < 0.5 and size < LARGER * wanted):
            continue
        # The probe radius is in millimetres already.
        value = np.abs(search.find(np.ascontiguousarray(changed)).distance - ball)
        share, middle = float((value <= REACH).mean()), float(np.median(value))
        if share > max(0.5, 1.2 * near):
            seen = phrase("{:.0f} % of the points lie on the profile, but {} {:.0f} %", 100 * near, how, 100 * share)
        elif share >= near and typical > LARGE and middle < FAR_BETTER * typical:
            seen = phrase("the points lie typically {} off the profile, but {} {}", mm(typical), how, mm(middle))
        else:
            continue
        if best is None or middle < best[0]:
            best = middle, Finding(name, message(seen, ": ", way_out), True)
    return None if best is None else best[1]


def _extent(points: Floats) -> float:
    """Diagonal in mm of the box round points."""
    return float(np.hypot(*np.ptp(points, axis=0))) if len(points) else 0.0


def _constant_offset(
    offset: float, scatter: float, ball: float, cutter_radius: float, depth: float, allowance: float
) -> Finding:
    surface = phrase("the surface {} over the profile", mm(allowance, "g")) if allowance else phrase("the profile")
    seen = phrase(
        "the points lie {} off {} all along, with only {} of scatter", mm(offset, "+.3f"), surface, mm(scatter)
    )
    near = SMALL_SCATTER
    if ball > 0 and abs(offset + ball) < near * ball:
        return Finding(
            "compensated-twice",
            phrase("{}: they are contact points already: {}", seen, remedy("points", "contact")),
            True,
        )
    if ball > 0 and abs(offset + ball / 2) < near * ball / 2:
        text = phrase(
            "{}: {} seems to be the diameter: {}", seen, option("probe_radius"), remedy("probe_radius", ball / 2)
        )
        return Finding("diameter-for-radius", text, True, figure=offset)
    if ball > 0 and abs(offset - ball) < near * ball:
        text = phrase(
            "{}: {} seems to be half of what it should be: {}",
            seen,
            option("probe_radius"),
            remedy("probe_radius", 2 * ball),
        )
        return Finding("radius-for-diameter", text, True, figure=offset)
    if abs(abs(offset) - 2 * cutter_radius) < near * cutter_radius:
        text = phrase(
            "{}, the cutter's diameter: the profile was taken on the wrong side of the path: {}", seen, option("side")
        )
        return Finding("wrong-side", text, True, figure=offset)
    if elastic.expected(offset, offset, depth) and (ball > 0 or not elastic.like_a_ball(offset)):
        seen = phrase(
            "{}: what a transfer function of {:.3f} leaves of {}", seen, elastic.transfer(offset, depth), mm(depth, "g")
        )
        return Finding(
            "constant-offset", phrase("{}; check {} if that seems much", seen, option("tool_diameter")), False
        )
    if allowance:
        text = phrase(
            "{}: check {}, by this {} were left, and {} and {}",
            seen,
            option("allowance", allowance),
            mm(allowance + offset, ".2f"),
            option("points"),
            option("probe_radius"),
        )
        return Finding("constant-offset", text, True, figure=offset)
    if ball == 0 and CONSTANT_OFFSET < offset < 10:
        text = phrase(
            "{}: they look like centres of a ball of about that radius: {} with the radius from the "
            "probe's calibration; or stock was left there ({}), or the tool differs from {}",
            seen,
            remedy("points", "centre"),
            option("allowance"),
            option("tool_diameter"),
        )
        return Finding("ball-not-compensated", text, True, figure=offset)
    tool, probe = option("tool_diameter"), option("probe_radius")
    if offset > 0:
        left = option("allowance")
        text = phrase("{}: check {}, {} (stock left on the part), {} and the work frame", seen, tool, left, probe)
    else:
        text = phrase("{}: check {}, {} and the work frame", seen, tool, probe)
    return Finding("constant-offset", text, True)
