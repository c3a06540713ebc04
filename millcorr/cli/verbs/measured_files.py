# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr inspect` and `convert`: what a measured file holds, and the same as text."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from millcorr import plausibility
from millcorr.comparison.deviation import statistics
from millcorr.errors import UsageError
from millcorr.messages import message, option, remedy
from millcorr.readers import Reading, text
from millcorr.readers.measurement import Basis, Measurement
from millcorr.whole_file import refuse_places

from .inputs import UNSAID, measured_inputs


def inspect(measured: Path, reading: Reading = UNSAID) -> str:
    """What a measured file holds, in a few lines.

    Parameters
    ----------
    measured : Path
    reading : Reading
        How it is to be read; `points` may be left out.

    Raises
    ------
    MillcorrError
        If the file cannot be read.
    """
    said = ""
    try:
        measurement = reading.read(measured)
    except UsageError as first:
        if reading.points is not None:
            raise
        try:
            measurement = replace(reading, points="contact", probe=None, probe_radius=None).read(measured)
        except UsageError:
            raise first from None
        said = message(
            "the file does not say of what: correcting needs ", remedy("points", "contact"), ", centre or axis"
        )
    low, high = measurement.points.min(axis=0), measurement.points.max(axis=0)
    levels = np.unique(measurement.levels())
    counted = f"{len(levels)} level{'s' if len(levels) > 1 else ''}"
    lines = [
        f"file        {measured}",
        f"format      {measurement.format}",
        f"unit        {measurement.unit}, {_basis(measurement, 'unit')}"
        + ("" if measurement.unit == "mm" else "; all lengths here in mm"),
        f"points      {len(measurement)}, {said or _kind(measurement)}",
        f"frame       {_basis(measurement, 'frame')}",
        f"normals     {'none' if measurement.normals is None else 'of every point'}",
        f"nominal     {'none' if measurement.nominal is None else 'in the file'}",
        f"extents     X{low[0]:.3f} to {high[0]:.3f}, Y{low[1]:.3f} to {high[1]:.3f}"
        + (f", Z{low[2]:.3f} to {high[2]:.3f} on {counted}" if measurement.has_z else ", no Z"),
    ]
    deviation = measurement.from_nominal()
    if deviation is not None:
        row = statistics(deviation[np.isfinite(deviation)])
        spread = f"{row['min']:+.4f} to {row['max']:+.4f}, mean {row['mean']:+.4f}"
        lines.append(f"deviations  {spread} (from the file's nominal)")
    lines += [f"note        {note}" for note in measurement.notes]
    lines += [f"finding     {finding.name}: {finding.text}" for finding in plausibility.examine_file(measurement)]
    return "\n".join(lines)


def _kind(measurement: Measurement) -> str:
    known = _basis(measurement, "points")
    if measurement.axis_radii is not None:
        radii = " and ".join(f"{radius:g}" for radius in sorted(set(measurement.axis_radii)))
        return f"centres shifted along an axis by the ball's radius {radii} ({known})"
    if not measurement.ball_radius:
        return f"contact ({known})"
    known = f"centres {known}; radius {_basis(measurement, 'radius')}"
    return f"centres of a ball of radius {measurement.ball_radius:g} ({known})"


def _basis(measurement: Measurement, what: str) -> str:
    """How something is known, in words; a person said it where nothing was written down."""
    return str(measurement.bases.get(what, Basis("said")))


def convert(measured: Path, output: Path, reading: Reading = UNSAID) -> str:
    """Write a measured file's points as text, ``x,y,z`` or ``x,y,z,i,j,k`` in mm.

    Parameters
    ----------
    measured, output : Path
    reading : Reading
        How the file is to be read.

    Raises
    ------
    MillcorrError
        If the file cannot be read, or `output` is the file itself.
    """
    refuse_places({"output": output}, {"file": measured, **measured_inputs((), reading)})
    measurement = reading.read(measured)
    text.write(output, measurement)
    ball = measurement.ball_radius
    kind = (
        message("ball centres, ", option("points", "centre"), " ", option("probe_radius", ball))
        if ball
        else message("contact points, ", option("points", "contact"))
    )
    return f"{len(measurement)} {kind}\npoints      {output}"
