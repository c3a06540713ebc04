# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration document: a part with a free-form contour, a job and a Profile operation.

Contour, tool and cutting conditions follow the experiment in Werner (2018): a closed cubic B-spline on a
control polygon of 15 vertices, milled along its profile with a 10 mm cutter at 300 mm/min and 6000 rpm.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import Part

from . import compat

CONTROL_VERTICES = (
    (95.0, 40.0), (83.75, 54.75), (69.25, 61.75), (59.0, 67.25), (46.5, 71.75),
    (33.25, 68.75), (22.25, 59.75), (13.25, 48.0), (8.75, 31.0), (16.25, 15.25),
    (33.25, 11.25), (47.5, 16.25), (57.5, 17.75), (72.75, 14.75), (91.25, 21.75),
)  # fmt: skip
"""Control polygon in mm; the contour is 223.98 mm long, its radius of curvature nowhere below 15.3 mm on
convex and 30.4 mm on concave stretches."""

HEIGHT = 12.0
"""Height of the part in mm."""

TOOL_DIAMETER = 10.0
"""Diameter of the end mill in mm."""


def contour_curve() -> Any:
    """The part's contour as a FreeCAD curve: closed periodic cubic B-spline, anticlockwise."""
    curve = Part.BSplineCurve()
    poles = [FreeCAD.Vector(x, y, 0.0) for x, y in CONTROL_VERTICES]
    count = len(poles)
    curve.buildFromPolesMultsKnots(poles, [1] * (count + 1), list(range(count + 1)), True, 3)
    return curve


def build(document: Any, curve: Any = None, side: str = "Outside") -> Any:
    """Fill a document with the part, the job and the operation.

    Parameters
    ----------
    document : FreeCAD document
    curve : Part curve, optional
        Closed contour of the part; default `contour_curve`.
    side : {"Outside", "Inside"}
        Side of the contour on which the tool runs.

    Returns
    -------
    document object
        The job.
    """
    wire = Part.Wire([(contour_curve() if curve is None else curve).toShape()])
    part = document.addObject("Part::Feature", "Part")
    part.Shape = Part.Face(wire).extrude(FreeCAD.Vector(0, 0, HEIGHT))
    job = compat.make_job(document, [part])
    controller = job.Tools.Group[0]
    compat.set_end_mill(controller, TOOL_DIAMETER)
    controller.HorizFeed = "300 mm/min"
    controller.VertFeed = "100 mm/min"
    controller.SpindleSpeed = 6000
    controller.SpindleDir = "Forward"
    operation = compat.make_profile(job)
    operation.Side = side
    operation.setExpression("StepDown", None)
    operation.StepDown = HEIGHT + 10.0
    document.recompute()
    return job


def make(document_path: str | Path, program_path: str | Path) -> tuple[Path, Path]:
    """Write the demonstration document and its program, posted by FreeCAD for LinuxCNC.

    Parameters
    ----------
    document_path, program_path : str or Path
        Files to write, .FCStd and .nc.

    Returns
    -------
    tuple of Path
        The two files.
    """
    document = FreeCAD.newDocument("Demonstration")
    try:
        job = build(document)
        document.saveAs(str(document_path))
        Path(program_path).write_text(compat.post(job), encoding="utf-8")
    finally:
        FreeCAD.closeDocument(document.Name)
    return Path(document_path), Path(program_path)
