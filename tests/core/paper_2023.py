# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of Petrakov and Romanov 2023, figures 5 to 9: two straights joined by an inner arc of radius 15."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from millcorr import nc, pipeline
from millcorr.correction.settings import Settings
from millcorr.process.prediction import Simulation, simulate
from millcorr.process.setup_file import Setup, load
from millcorr.readers.measurement import Measurement

SETUP = Path(__file__).resolve().parents[2] / "resources" / "setups" / "petrakov-2023.toml"

PROGRAM = """%
O1 (CONTOUR)
G21 G90 G17
T1 M6
S1500 M3
G0 X-30 Y0
G0 Z5
G1 Z-10 F400
G1 X20
G3 X25 Y5 I0 J5
G1 Y60
G0 Z20
M30
%
"""

RADIUS = 10.0
LEFT = Settings(side="left")


def program(text: str = PROGRAM) -> nc.Program:
    """The milling program, or another one."""
    return nc.parse(text, "part.nc")


def setup() -> Setup:
    """The paper's, with the stiffness and force that give its figures."""
    return load(SETUP)


@cache
def nominal():
    """What the program cuts on a rigid machine."""
    return pipeline.nominal_from_program(program(), RADIUS, LEFT, None)


@cache
def as_cut() -> Simulation:
    """The uncorrected program on the paper's machine."""
    return simulate(program(), setup(), nominal())


def touched(simulation: Simulation, *places: tuple[float, float], noise: float = 0.0) -> Measurement:
    """Touches of a simulated surface next to places, as contact points."""
    d = simulation.deviation
    rows = [int(np.argmin(np.hypot(*(d.foot - place).T))) for place in places]
    value = d.value[rows] + noise * np.random.default_rng(5).standard_normal(len(rows))
    xy = d.foot[rows] + value[:, None] * d.normal[rows]
    xyz = np.column_stack([xy, np.full(len(rows), -5.0)])
    return Measurement(xyz, None, 0.0, np.arange(2, len(rows) + 2), "touches.csv", f"{len(rows):064d}")


def softer(kx: float, ky: float) -> Setup:
    """The paper's setup with another machine."""
    its = setup()
    return replace(its, machine=replace(its.machine, kx_n_per_mm=kx, ky_n_per_mm=ky))


def cut_again(text: bytes, its: Setup) -> Simulation:
    """A corrected program on a machine."""
    return simulate(nc.parse(text, "corrected.nc"), its, nominal())
