# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrected path of random parts, against the closed-form distance from the compensated contour."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from millcorr.geometry.footpoint import FootPointSearch, Place
from millcorr.geometry.profile import Profile
from millcorr.path.moves import Regeneration
from millcorr.path.reconstruction import CompensatedContour
from tests.core.contours import Element, Part, Path, parts, profile_of, rectangle, reversed_elements, started_at
from tests.core.laid_paths import laid
from tests.core.path.test_reconstruction import constant, waves
from tests.core.sweeps import examples

R = 5.0


def check(done: Regeneration, contour: CompensatedContour, length: float, tolerance: float = 1e-3) -> None:
    """Every following move lies on the parallel, the path hangs together and is as long as before."""
    t = done.toolpath
    assert np.hypot(*(t.start[1:, :2] - t.end[:-1, :2]).T).max(initial=0.0) < 1e-9
    compensated, _ = contour.to_profile()
    points = t.take(np.flatnonzero(done.following)).position(np.linspace(0, 1, 33))[:, :, :2].reshape(-1, 2)
    feet = FootPointSearch(compensated, margin=R + 3.0).find(points)
    off = feet.distance - R
    # Past a convex corner the path may run on; it is then farther away.
    error = np.where((feet.place != Place.SMOOTH) & (off > 0), 0.0, np.abs(off))
    assert error.max() < tolerance
    # A displacement of 0.05 mm changes the length by at most 0.05 mm times the turns; nothing is run twice.
    assert abs(t.length()[done.following].sum() - length) < 0.01 * length + 1.0


def program(elements: list[Element], lead: bool, material_right: bool, passes: int) -> Path:
    p0 = elements[0].p0
    ahead = elements[0].at(np.array([1e-7]))[0] - p0
    ahead /= np.hypot(*ahead)
    out = p0 + 9 * np.array([ahead[1], -ahead[0]]) * (-1 if material_right else 1)
    path = Path().rapid(*out).plunge(-1.0).line(*p0) if lead else Path(here=(*p0, 0.0))
    for _ in range(passes):
        path.along(elements)
    return path.line(*out) if lead else path


def corners(part: Part) -> int:
    return sum(r == 0 for r in part.radii)


# Three of five parts drawn are not wanted; that they are known to be many is no reason to fail.
@settings(
    max_examples=examples(60), deadline=None, derandomize=True, suppress_health_check=[HealthCheck.filter_too_much]
)
@given(
    part=parts(cutter=R),
    mitre=st.booleans(),
    climb=st.booleans(),
    index=st.integers(0, 12),
    fraction=st.sampled_from([0.0, 0.37, 0.5]),
    size=st.sampled_from([0.0, 0.003, 0.05]),
    wavelength=st.sampled_from([30.0, 200.0]),
    moves=st.sampled_from(["keep", "lines", "arcs"]),
    seam=st.tuples(st.integers(0, 9), st.sampled_from([0.0, 0.4])),
    lead=st.booleans(),
    passes=st.integers(1, 2),
)
def test_random_parts(part, mitre, climb, index, fraction, size, wavelength, moves, seam, lead, passes):
    # One and two corners: see below.
    assume(corners(part) not in (1, 2))
    assume(all(r == 0 or r >= 1.5 * R or t > 0 for r, t in zip(part.radii, _turns(part), strict=True)))
    profile = profile_of(started_at(part.elements, *seam))
    elements = part.path(R, mitre)
    if climb:
        elements = reversed_elements(elements)
    elements = started_at(elements, index, fraction)
    contour = CompensatedContour(profile, waves(profile, size, wavelength))
    done = laid(program(elements, lead, climb, passes).toolpath(), profile, contour.correction, R, moves)
    check(done, contour, passes * sum(e.length for e in elements))
    if size == 0.0 and moves == "keep":
        assert done.changed == 0


def _turns(part: Part) -> np.ndarray:
    from tests.core.contours import turns

    return turns(part.vertices)


def go(profile: Profile, elements: list[Element], climb: bool) -> None:
    if climb:
        elements = reversed_elements(elements)
    elements = started_at(elements, 0, 0.5)
    contour = CompensatedContour(profile, constant(profile, 0.05))
    done = laid(program(elements, False, climb, 1).toolpath(), profile, contour.correction, R, "lines")
    check(done, contour, sum(e.length for e in elements))


@pytest.mark.parametrize(("climb", "mitre"), [(False, False), (False, True), (True, False), (True, True)])
def test_two_corners(mitre, climb):
    """Run backwards, the joint from piece 1 to piece 0 is taken for the other joint between the same two."""
    part = Part(rectangle(60.0, 40.0).vertices, (0.0, 8.0, 0.0, 8.0))
    go(part.profile, part.path(R, mitre), climb)


@pytest.mark.parametrize("mitre", [False, True])
@pytest.mark.parametrize("climb", [False, True])
def test_one_corner(mitre, climb):
    """The only piece meets itself: a vertex at the corner belongs to its end or its start."""
    part = Part(rectangle(60.0, 40.0).vertices, (0.0, 8.0, 8.0, 8.0))
    go(part.profile, part.path(R, mitre), climb)


@pytest.mark.parametrize("climb", [False, True])
def test_one_inner_corner(climb):
    vertices = rectangle(60.0, 40.0).vertices[::-1].copy()
    part = Part(vertices, (0.0, 8.0, 8.0, 8.0))
    go(part.profile, part.path(R, False), climb)


def test_beside_an_inside_corner_of_which_the_other_side_moves_in():
    """The places between the old and the new corner are clear where their own side wants them, and only there."""
    vertices = [(9.27050983, -28.53169549), (-36.40576475, -26.45033635), (-22.65247584, 16.45798706)]
    part = Part(np.array([*vertices, (6.79837388, 20.92324336), (22.0, 0.0)]), (0.0,) * 5)
    profile, elements = profile_of(part.elements), part.path(R, False)
    contour = CompensatedContour(profile, waves(profile, 0.05, 30.0))
    done = laid(program(elements, False, False, 1).toolpath(), profile, contour.correction, R)
    check(done, contour, sum(e.length for e in elements))
