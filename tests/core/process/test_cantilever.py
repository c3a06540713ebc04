# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bent end mill against closed forms, the beam's differential equation and Maxwell's theorem."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.errors import UsageError
from millcorr.process.deflection.cantilever import Cantilever, deflection, second_moment, slope
from millcorr.process.setup_file import Machine, Material, Setup, Stock, Tool
from tests.core.sweeps import examples

E = 600_000.0
"""N/mm^2, carbide."""


def printed(z, force, a, h, rigidity):
    """Eqs. 2 and 3 letter by letter."""
    lead = force * (h - a) ** 3 / (6 * rigidity)
    if z <= a:
        return lead * (3 * (h - z) / (h - a) - 1)
    return lead * (3 * (h - z) ** 2 / (h - a) ** 2 - (h - z) ** 3 / (h - a) ** 3)


@pytest.mark.parametrize(("factor", "micron"), [(1.0, 3.493), (0.8, 8.528)])
def test_force_at_the_tip(factor, micron):
    """F h^3 / (3 E I) of 100 N, 40 mm, D 12, 600 GPa."""
    rigidity = E * second_moment(12.0, factor)
    found = deflection(0.0, 100.0, 0.0, 40.0, rigidity)
    assert found == pytest.approx(100.0 * 40.0**3 / (3 * E * np.pi * (factor * 12.0) ** 4 / 64), rel=1e-14)
    assert found * 1000 == pytest.approx(micron, abs=5e-4)


def test_ratio_of_fluted_to_solid():
    assert second_moment(12.0, 1.0) / second_moment(12.0) == pytest.approx(0.8**-4, rel=1e-14)
    assert 0.8**-4 == pytest.approx(2.441, abs=5e-4)


places = st.floats(0.0, 1.0)


@given(places, places, st.floats(5.0, 120.0), st.floats(1.0, 500.0))
@settings(max_examples=examples(200), deadline=None, derandomize=True)
def test_equations_2_and_3(z, a, h, force):
    """The printed forms, but for a force at the holder, where they divide by nothing."""
    z, a = z * h, a * 0.99 * h
    rigidity = E * second_moment(10.0)
    wanted = printed(z, force, a, h, rigidity)
    # Cubes of (h - a) down to 1 % of h lose no digits; differences of z and h lose as many as they are near.
    assert deflection(z, force, a, h, rigidity) == pytest.approx(wanted, rel=1e-9, abs=1e-15)


@given(places, st.floats(5.0, 120.0))
@settings(max_examples=examples(50), deadline=None, derandomize=True)
def test_both_equations_are_equal_at_the_force(a, h):
    a *= 0.99 * h
    rigidity = E * second_moment(10.0)
    both = 100.0 * (h - a) ** 3 / (3 * rigidity)
    assert printed(a, 100.0, a, h, rigidity) == pytest.approx(both, rel=1e-12)
    assert deflection(a, 100.0, a, h, rigidity) == pytest.approx(both, rel=1e-12)


def test_clamped_at_the_holder_and_bent_as_the_beam_equation_says():
    """E I delta'' is the bending moment F (z - a) above the force; deflection and slope vanish at the holder."""
    h, a, force = 50.0, 12.0, 80.0
    rigidity = E * second_moment(10.0)
    z = np.linspace(0.5, 49.5, 99)
    step = 1e-2
    bend = (
        deflection(z + step, force, a, h, rigidity)
        - 2 * deflection(z, force, a, h, rigidity)
        + deflection(z - step, force, a, h, rigidity)
    ) / step**2
    moment = force * np.maximum(z - a, 0.0)
    # The second difference of a cubic is exact; at the kink of the moment it is off by F step / 6 at most.
    assert rigidity * bend == pytest.approx(moment, abs=force * step)
    first = (deflection(z + step, force, a, h, rigidity) - deflection(z - step, force, a, h, rigidity)) / (2 * step)
    assert -first == pytest.approx(slope(z, force, a, h, rigidity), abs=force * step**2 / rigidity)
    assert deflection(h, force, a, h, rigidity) == 0.0
    assert slope(h, force, a, h, rigidity) == 0.0
    assert deflection(10.0, force, h, h, rigidity) == 0.0


@given(places, places)
@settings(max_examples=examples(50), deadline=None, derandomize=True)
def test_maxwell(z, a):
    tool = Cantilever(50.0, 1e8)
    assert tool.compliance(50 * z, 50 * a) == pytest.approx(tool.compliance(50 * a, 50 * z), rel=1e-12, abs=1e-18)


def test_stiffness_along_the_height():
    tool = Cantilever(50.0, 1.2e8)
    assert tool.stiffness(0.0) == pytest.approx(tool.tip_stiffness, rel=1e-14)
    assert tool.stiffness(25.0) == pytest.approx(8 * tool.tip_stiffness, rel=1e-14)
    assert np.isinf(tool.stiffness(50.0))


SETUP = Setup(
    Tool(12.0, 4, 2000.0, overhang_mm=40.0),
    Material("", 2000.0, 600.0),
    Machine(),
    Stock(solid=True, axial_depth_mm=2.0),
)


def test_of_a_setup():
    tool = Cantilever.of(SETUP)
    assert 100.0 * tool.compliance(0.0, 0.0) * 1000 == pytest.approx(8.528, abs=5e-4)
    assert tool.machine == (0.0, 0.0)
    solid = Cantilever.of(replace(SETUP, tool=replace(SETUP.tool, effective_diameter_factor=1.0)))
    assert 100.0 * solid.compliance(0.0, 0.0) * 1000 == pytest.approx(3.493, abs=5e-4)
    measured = Cantilever.of(replace(SETUP, tool=replace(SETUP.tool, stiffness_n_per_mm=5000.0)))
    assert measured.tip_stiffness == pytest.approx(5000.0, rel=1e-14)


def test_the_machine_gives_way_by_what_the_tool_leaves():
    alone = Cantilever.of(SETUP).tip_stiffness
    both = Cantilever.of(replace(SETUP, machine=Machine(alone / 2, alone)))
    assert 1 / both.tip_stiffness + both.machine[0] == pytest.approx(2 / alone, rel=1e-12)
    assert both.machine[1] == pytest.approx(0.0, abs=1e-15)


def test_refusals():
    with pytest.raises(UsageError, match="overhang_mm is missing"):
        Cantilever.of(replace(SETUP, tool=replace(SETUP.tool, overhang_mm=None)))
    with pytest.raises(UsageError, match="ky_n_per_mm 1e\\+06 N/mm is of the whole loop"):
        Cantilever.of(replace(SETUP, machine=Machine(None, 1e6)))
    with pytest.raises(UsageError, match="rigidity"):
        Cantilever(50.0, 0.0)
