# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points measured in another frame, laid into the work frame by a known offset and turn."""

from __future__ import annotations

import math
from dataclasses import replace

from millcorr.messages import phrase
from millcorr.readers.measurement import Measurement
from millcorr.readers.transform import Transform


def laid_in_work_frame(
    measurement: Measurement, offset: tuple[float, float, float] | None, rotation: float | None
) -> Measurement:
    """Points, normals and nominal points in the work frame.

    Parameters
    ----------
    measurement : Measurement
        In the file's frame.
    offset : tuple of 3 float, or None
        Origin of the work frame in the file's frame, mm.
    rotation : float or None
        Turn of the work frame in the file's frame about its origin, degrees, positive anticlockwise: the angle
        that a control keeps beside G54, or that G68 is given.

    Returns
    -------
    Measurement
        ``p' = Rot(-rotation) (p - offset)``, with a note that says so.
    """
    if offset is None and not rotation:
        return measurement
    x, y, z = offset or (0.0, 0.0, 0.0)
    into, down = Transform.about(math.radians(rotation or 0.0), shift=(x, y)).inverse(), (0.0, 0.0, z)
    moved = into.measurement(measurement)
    nominal = None if moved.nominal is None else into.points(moved.nominal) - down
    turn = phrase(", turned by {:g} deg", rotation) if rotation else ""
    note = phrase("laid into the work frame at X{:g} Y{:g} Z{:g}{} of the file's frame, as given", x, y, z, turn)
    return replace(moved, points=moved.points - down, nominal=nominal, notes=(*measurement.notes, note))
