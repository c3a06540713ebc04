# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files, read back by a small parser of Part 21 here, and by OCCT in tests/app."""

from __future__ import annotations

import re

import numpy as np
import pytest

from millcorr.geometry import step
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.virtual.simulated_machine import reference_contour


def curves_in(text: str) -> list[NurbsCurve]:
    """Curves of a STEP file, made again from its entities."""
    entities = dict(re.findall(r"^(#\d+)=(.*);$", text, re.MULTILINE))
    members = re.search(r"GEOMETRIC_CURVE_SET\('',\(([^)]*)\)\)", text)
    out = []
    for name in members[1].split(","):  # type: ignore[index]
        entity = entities[name]
        degree, points = re.search(r"(?:KNOTS\(''|B_SPLINE_CURVE\((?=\d)),?(\d+),\(([^)]*)\)", entity).groups()  # type: ignore[union-attr]
        poles = [
            [float(v) for v in re.findall(r"[-+0-9.E]+", entities[p].split("(", 2)[2])[:2]] for p in points.split(",")
        ]
        mult, knots = re.search(r"\(([\d,]+)\),\(([-+0-9.E,]+)\),\.UNSPECIFIED\.", entity).groups()  # type: ignore[union-attr]
        weights = re.search(r"RATIONAL_B_SPLINE_CURVE\(\(([^)]*)\)\)", entity)
        out.append(
            NurbsCurve(
                int(degree),
                np.array(poles),
                np.array([float(w) for w in weights[1].split(",")]) if weights else np.ones(len(poles)),
                np.array([float(k) for k in knots.split(",")]),
                np.array([int(m) for m in mult.split(",")]),
            )
        )
    return out


def test_every_curve_comes_back_exactly() -> None:
    arc = NurbsCurve.arc([5, 0], [-5, 0], [0, 0], np.pi)
    half = Contour((arc, NurbsCurve.line([-5, 0], [5, 0])), True)
    profile = Profile.from_contours([*reference_contour().contours, half])
    curves = curves_in(step.text(profile, "part"))
    given = [c for contour in profile.contours for c in contour.curves]
    assert len(curves) == len(given) == 3
    for a, b in zip(given, curves, strict=True):
        u = np.linspace(a.knots[0], a.knots[-1], 301)
        assert np.abs(a.evaluate(u) - b.evaluate(u)).max() < 1e-12


@pytest.mark.parametrize("mult", [[1, 1, 1, 1, 1, 1], [2, 3, 1, 2], [2, 1, 1, 2, 2], [3, 2, 3]])
def test_periodic_curves_are_cut_open_without_changing(mult: list[int]) -> None:
    count = sum(mult[:-1])
    angle = np.arange(count) * 2 * np.pi / count
    poles = np.column_stack([20 * np.cos(angle), 12 * np.sin(angle)])
    knots = np.cumsum(np.r_[0.3, np.linspace(1, 2, len(mult) - 1)])
    weights = np.linspace(1.0, 2.0, count)
    curve = NurbsCurve(3, poles, weights, knots, np.array(mult), True)
    opened = curve.clamped()
    u = np.linspace(knots[0], knots[-1], 401)
    assert np.abs(curve.evaluate(u) - opened.evaluate(u)).max() < 1e-12
    assert not opened.periodic
    assert opened.multiplicities[0] == opened.multiplicities[-1] == 4


def test_names_are_quoted_and_numbers_have_points() -> None:
    profile = Profile.from_contours([Contour((NurbsCurve.line([0, 0], [1e-7, 1e9]),), False)])
    text = step.text(profile, "Bob's \u00e4 \\ part")
    assert "'Bob''s \\X4\\000000E4\\X0\\ \\\\ part'" in text
    assert "(1.E-07,1000000000.0,0.)" in text
