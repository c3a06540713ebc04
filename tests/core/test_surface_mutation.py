# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places changed in the written text, on the very lines that were to change: what alters the surface is refused."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import shapely

from millcorr import nc, pipeline
from millcorr.errors import MillcorrError
from millcorr.nc.toolpath import Kind
from millcorr.path import emission
from millcorr.stages import written
from tests.core import loop_programs as programs
from tests.core.sweeps import slow
from tests.core.test_pipeline import CASES, nominal_of
from tests.core.text_mutants import mutants

NAMES = ("mitres", "pocket")


@cache
def laid(name: str, drawn: bool) -> tuple[tuple, dict, pipeline.Result]:
    """What the pipeline hands to `emit`, and its result; with and without a drawing."""
    program, nominal = nominal_of(name)
    _, radius, _, clear = CASES[name]
    measurement = programs.measured(nominal, lambda k, s: 0.02 + 0.005 * np.sin(2 * np.pi * s / 60.0), clear=clear)
    kept: list[tuple[tuple, dict]] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(written, "emit", lambda *args, **more: kept.append((args, more)) or emission.emit(*args, **more))
        chosen = pipeline.Settings(filter="none")
        result = pipeline.correct(pipeline.Request(program, radius, measurement, nominal if drawn else None, chosen))
    return *kept[-1], result


def path_of(text: bytes) -> shapely.Geometry:
    """The cutting moves of a text, arcs as fine chords."""
    moves = nc.parse(text).toolpath
    known = np.isfinite(moves.position(np.array([0.0, 1.0]))).all(axis=(1, 2))
    moves = moves.take(np.flatnonzero((moves.kind != Kind.RAPID) & known))
    places = moves.position(np.linspace(0, 1, 65))
    return shapely.multilinestrings([shapely.linestrings(p[:, :2]) for p in places if p[:, 2].min() < 0])


@pytest.mark.parametrize(("seed", "count"), [(0, 8), slow(1, 400)])
@pytest.mark.parametrize("drawn", [False, True])
@pytest.mark.parametrize("name", NAMES)
def test_what_alters_the_surface_is_refused(name: str, drawn: bool, seed: int, count: int) -> None:
    """Distances of the wall from the path, by shapely, say what a change does: 2 um more or less must not pass."""
    args, more, result = laid(name, drawn)
    compensated = result.compensated
    s = np.arange(0.0, float(compensated.total[0]), 0.1)
    wall = shapely.points(compensated.at(0, s)[0])
    right = shapely.distance(path_of(result.text), wall)
    harmful = 0
    for text, what, kind, _ in mutants(result.text, seed, count):
        if kind != "place":
            continue
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(emission, "written_text", lambda *a, text=text, **k: text)
            try:
                emission.emit(*args, **more)
            except MillcorrError:
                continue
        try:
            off = np.abs(shapely.distance(path_of(text), wall) - right).max()
        except MillcorrError:
            pytest.fail(f"{what}: passes and cannot be read")
        assert off <= 0.002, what
        harmful += 1
    # Most changes of a place harm, and are refused; doubled lines do not.
    assert harmful < 0.6 * count
