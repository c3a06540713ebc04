# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's Profile round a plate with a notch at its outer edge: its arcs are up to 29 um off the exact parallel.

That is the program's own error. It is taken out where the nominal is given, and is no reason to refuse where the
program is its own nominal.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from millcorr import nc, pipeline
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.readers.measurement import Measurement
from tests.core import loop_programs as programs

PROGRAM = Path(__file__).parents[2] / "data" / "nc" / "freecad-notch.nc"
CORNERS = [(62.0, 60.0), (100.0, 60.0), (100.0, 0.0), (0.0, 0.0), (0.0, 60.0), (38.0, 60.0)]
"""A plate of 100 x 60 mm with a notch of radius 12 about X50 Y60."""


def plate() -> Profile:
    sides = [NurbsCurve.line(a, b) for a, b in zip(CORNERS[1:], CORNERS[:-1], strict=True)][::-1]
    notch = NurbsCurve.arc((62.0, 60.0), (38.0, 60.0), (50.0, 60.0), -np.pi)
    return Profile.from_contours([Contour((*sides, notch), True)])


def measured(nominal: Profile) -> Measurement:
    """Points of a part whose surface has a smooth error on the nominal."""
    noise = np.random.default_rng(1).normal(0, 0.001, 1000)
    return programs.measured(
        nominal,
        lambda _, s: 0.012 + 0.005 * np.sin(6 * np.pi * s / nominal.total[0]) + noise[: len(s)],
        spacing=1.9,
        z=5.0,
    )


def corrected(nominal: Profile | None) -> pipeline.Result:
    request = pipeline.Request(nc.read(PROGRAM), 5.0, measured(plate()), nominal, pipeline.Settings(filter="mean:5"))
    return pipeline.correct(request)


def test_errors_of_the_program_go_where_the_nominal_is_given() -> None:
    assert corrected(plate()).verification.path_error_max <= 0.001


def test_kinks_of_a_program_that_is_its_own_nominal_are_no_reason_to_refuse() -> None:
    assert corrected(None).verification.path_error_max <= 0.001
