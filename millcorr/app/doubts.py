# SPDX-License-Identifier: LGPL-2.1-or-later
"""What speaks against a measured file before it is in the document: alone, and against the operation it belongs to."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from millcorr import pipeline, plausibility
from millcorr.comparison.ball_radius import contact_known
from millcorr.errors import MillcorrError
from millcorr.plausibility import Finding
from millcorr.readers.measurement import Measurement

from . import correction, draft, dressup


def prepared(operation: Any = None) -> Callable[[Measurement], tuple[Finding, ...]]:
    """Do now what needs FreeCAD, and give what looks for doubts: it may be called in any thread.

    Parameters
    ----------
    operation : document object, optional
        The operation that cut the part; without one only the file itself is looked at.

    Returns
    -------
    callable
        Gives the findings about a measurement; raises MillcorrError where the points lie nowhere near the
        operation.
    """
    request = None
    if operation is not None:
        values = draft.defaults(dressup.PROPERTIES) | {"Base": operation}
        try:
            request, _ = correction.request_of(draft.Draft(operation.Label, values))
        except MillcorrError:
            # The correction itself will say so; the file can be looked at nevertheless.
            request = None

    def find(measurement: Measurement) -> tuple[Finding, ...]:
        found = plausibility.examine_file(measurement)
        if request is None:
            return found
        nominal = request.nominal
        if nominal is None:
            program, radius = request.program, request.radius
            nominal = pipeline.nominal_from_program(program, radius, request.settings, measurement)
        return found + plausibility.examine_points(contact_known(measurement, nominal), nominal, request.radius)

    return find
