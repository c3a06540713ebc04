# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a measured file shows by itself, without a program or a nominal from elsewhere."""

from __future__ import annotations

import numpy as np

from millcorr import progress
from millcorr.arrays import Floats
from millcorr.messages import mm, option, phrase, remedy, um
from millcorr.nc.codes import INCH
from millcorr.readers.measurement import Measurement
from millcorr.tolerances import EXACT

from .findings import Finding

STATED = 6e-4
"""Deviations that the file states agree with its own points within this, in mm: half a unit of 0.001 and a bit."""

COARSE = 5e-3
"""Coordinates printed in steps above this, in mm, hide deviations that are worth correcting."""

BALLS = (0.1, 10.0)
"""Radii of probe balls, in mm: styli are made with balls from 0.3 to 12 mm in diameter, and a little beside."""

EXTENTS = (2.0, 5000.0)
"""Larger side of a measured contour, in mm: one of 2 m in metres is below, one of 5 mm in micrometres above."""

ROUNDING = 0.75
"""Rounding two coordinates moves a point along any direction by at most 0.71 of the step; and a bit."""


def examine_file(measurement: Measurement) -> tuple[Finding, ...]:
    """Signs that a measured file is not what it is taken for, from the file alone.

    Parameters
    ----------
    measurement : Measurement
        As read, before any alignment.

    Returns
    -------
    tuple of Finding
    """
    progress.step()
    step = resolution(measurement)
    found = (
        _identical(measurement, step),
        _stated(measurement, step),
        _coarse(step),
        _height_map(measurement),
        _radius(measurement),
        _extent(measurement),
    )
    return tuple(finding for finding in found if finding is not None)


def resolution(measurement: Measurement) -> float:
    """Step in mm in which the file gives x and y: the last decimal that any point uses, in the file's unit.

    0 where there is none to a millionth of the unit (computed points), or with fewer than three points.
    """
    progress.step()
    if len(measurement) < 3:
        return 0.0
    unit = INCH if measurement.unit == "inch" else 1.0
    numbers = measurement.points[:, :2] / unit
    for decimals in range(6):
        scaled = numbers * 10.0**decimals
        # Reading and converting leave an error of a few parts in 1e16 of numbers below 1e4.
        if np.abs(scaled - np.round(scaled)).max() < 1e-5:
            return float(unit * 10.0**-decimals)
    return 0.0


def identical_to_nominal(value: Floats, step: float) -> Finding | None:
    """Finding where no deviation, in mm, is larger than what rounding to the file's step makes of none at all."""
    if len(value) < 3:
        return None
    largest = float(np.abs(value).max())
    if largest > max(EXACT, ROUNDING * step):
        return None
    if largest <= EXACT:
        seen = phrase("every deviation is 0")
    else:
        seen = phrase(
            "no deviation is larger than {}, what rounding to {} alone makes", um(largest, ".2f"), mm(step, "g")
        )
    text = phrase(
        "{}: the nominal was probably exported in place of the measured points; export the actual points, to 0.0001 mm",
        seen,
    )
    return Finding("identical-to-nominal", text, False)


def _identical(measurement: Measurement, step: float) -> Finding | None:
    """Whether the measured points are the file's own nominal points."""
    if measurement.nominal is None:
        return None
    value = measurement.from_nominal()
    if value is None:
        if measurement.ball_radius:
            return None
        value = np.hypot(*(measurement.points - measurement.nominal)[:, :2].T)
    value = value[np.isfinite(value)]
    # Points and nominals are both rounded.
    return identical_to_nominal(value, step)


def _stated(measurement: Measurement, step: float) -> Finding | None:
    """Whether the deviations that the file states are those of its own points."""
    recomputed = measurement.from_nominal()
    if recomputed is None or measurement.stated is None:
        return None
    stated = measurement.stated
    gap = np.nan_to_num(np.abs(recomputed - stated))
    # Both ends of the distance are rounded, in three coordinates each.
    allowed = STATED + np.sqrt(3.0) * step
    worst = int(np.argmax(gap)) if len(gap) else 0
    if not len(gap) or gap[worst] <= allowed:
        return None
    known = int((np.isfinite(recomputed) & np.isfinite(stated)).sum())
    turned = np.nan_to_num(np.abs(recomputed + stated)).max() <= allowed
    remedy = (
        phrase("its sign is the other way round, positive into the material")
        if turned
        else phrase("check what its columns mean")
    )
    text = phrase(
        "{} states a deviation of {}, its points give {} ({} of {} disagree): {}; leave the column "
        "of deviations out, or correct it",
        measurement.origin(worst),
        mm(stated[worst], "+.4f"),
        mm(recomputed[worst], "+.4f"),
        int((gap > allowed).sum()),
        known,
        remedy,
    )
    return Finding("stated-deviations", text, True)


def _height_map(measurement: Measurement) -> Finding | None:
    """Whether the points were touched from above, on a grid, for levelling."""
    if measurement.format != "height-map":
        return None
    text = phrase(
        "the {} points are a height map, touched along Z: they show nothing of a contour; touch its "
        "walls with a measuring program",
        len(measurement),
    )
    return Finding("height-map", text, True)


def _radius(measurement: Measurement) -> Finding | None:
    """Whether a ball of this radius can be on a touch probe."""
    radii = measurement.axis_radii or ((measurement.ball_radius,) if measurement.ball_radius else ())
    radius = next((r for r in radii if not BALLS[0] <= r <= BALLS[1]), None)
    if radius is None:
        return None
    text = phrase(
        "a ball of radius {} is on no touch probe ({} to {})", mm(radius, ".4g"), *(mm(ball, "g") for ball in BALLS)
    )
    inch = radius * INCH
    if _assumed(measurement) and BALLS[0] <= inch <= BALLS[1]:
        text = phrase(
            "{}; {:.4g} inch are {}, and the file does not say its unit: {}",
            text,
            radius,
            mm(inch, ".4g"),
            remedy("units", "inch"),
        )
    else:
        text = phrase("{}: {} takes a radius in mm", text, option("probe_radius"))
    return Finding("implausible-radius", text, True)


def _extent(measurement: Measurement) -> Finding | None:
    """Whether the points are as far apart as those of a part, in a unit that nobody named."""
    if len(measurement) < 3 or not _assumed(measurement):
        return None
    extent = float(np.ptp(measurement.points[:, :2], axis=0).max())
    if EXTENTS[0] <= extent <= EXTENTS[1]:
        return None
    other = phrase("metres or inches") if extent < EXTENTS[0] else phrase("micrometres")
    text = phrase(
        "the points extend over {}, and the file does not say its unit: {}? Say {} if it is right, {}, or export in mm",
        mm(extent, ".4g"),
        other,
        remedy("units", "mm"),
        remedy("units", "inch"),
    )
    return Finding("implausible-extent", text, True)


def _assumed(measurement: Measurement) -> bool:
    """Whether neither file nor user named the unit, nor the file's figures show it."""
    return "unit" in measurement.bases and measurement.bases["unit"].how == "assumed"


def _coarse(step: float) -> Finding | None:
    if step <= COARSE:
        return None
    # A rounded number is uniformly distributed over a step: standard deviation step / sqrt(12).
    text = phrase(
        "the coordinates are given in steps of {}, which alone scatters deviations by {} (standard "
        "deviation): export to 0.0001 mm",
        mm(step, "g"),
        um(step / np.sqrt(12)),
    )
    return Finding("coarse-resolution", text, False)
