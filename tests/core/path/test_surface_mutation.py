# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places changed in the written text, on the very lines that were to change: what alters the surface is refused."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely

from millcorr import nc, pipeline
from millcorr.errors import LimitError, MillcorrError
from millcorr.nc.toolpath import Kind
from millcorr.path import emission
from millcorr.readers.measurement import Measurement
from millcorr.stages import written
from tests.core import loop_programs as programs
from tests.core.stages.test_pipeline import CASES, nominal_of
from tests.core.sweeps import slow
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


@pytest.mark.few(2)
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


@pytest.mark.parametrize("facets", [60, 400])
def test_material_left_on_a_facetted_wall_is_seen(facets: int) -> None:
    """A stretch of the path stays where it was: the wall would keep 20 um there, at joints of facets and between."""
    turn = np.linspace(0, 2 * np.pi, facets + 1)
    ring = np.column_stack([np.cos(turn), -np.sin(turn)])
    lines = [f"G1 X{x:.4f} Y{y:.4f}" for x, y in 35 * ring]
    text = "\n".join(["G21 G90", "G0 X60 Y0", "G1 Z-3 F300", *lines, "G1 X60 Y0", "G0 Z20", "M30", ""])
    places = np.column_stack([30.02 * ring[:-1], np.full(facets, -2.0)])
    part = Measurement(places, None, 0.0, np.arange(facets), "part.csv", "cd" * 32)
    kept: list[tuple[tuple, dict]] = []
    with pytest.MonkeyPatch.context() as patch:
        prove = emission.prove_surface
        patch.setattr(emission, "prove_surface", lambda *a, **k: kept.append((a, k)) or prove(*a, **k))
        pipeline.correct(pipeline.Request(nc.parse(text), 5.0, part, settings=pipeline.Settings(filter="none")))
    (original, written_one, *rest), more = kept[-1]
    moves, was = written_one.toolpath, original.toolpath.take(rest[1])
    start, end = moves.start.copy(), moves.end.copy()
    stays = np.arange(facets // 2, facets // 2 + facets // 10)
    start[stays[1:]], end[stays[:-1]] = was.start[stays[1:]], was.end[stays[:-1]]
    left = replace(written_one, toolpath=moves.with_moves(start=start, end=end))
    prove(original, written_one, *rest, **more)
    with pytest.raises(LimitError, match="off at"):
        prove(original, left, *rest, **more)
