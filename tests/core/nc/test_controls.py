# SPDX-License-Identifier: LGPL-2.1-or-later
"""One contour as every family of controls writes it: the same moves, deviations and corrected surface."""

from __future__ import annotations

import re

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings

from millcorr import nc, pipeline
from millcorr.arrays import Floats
from millcorr.nc.toolpath import Compensation, Kind, Toolpath
from millcorr.path.second_reader import moves_of
from tests.core.control_programs import FAMILIES, Contour, Edge, contours, written
from tests.core.path.test_second_reader import check
from tests.core.stages.test_shop_programs import part
from tests.core.sweeps import examples

PLATE = Contour(
    (0.0, 5.0),
    (-9.0, 5.0),
    (
        Edge((0.0, 30.0), corner=("R", 4.0)),
        Edge((40.0, 30.0), corner=("C", 3.0)),
        Edge((40.0, 20.0)),
        Edge((30.0, 10.0), (40.0, 10.0), clockwise=False),
        Edge((30.0, -10.0), corner=("R", 2.0)),
        Edge((0.0, -10.0), corner=("R", 3.0)),
        Edge((0.0, 5.0)),
    ),
)


def same_moves(a: Toolpath, b: Toolpath, within: float = 1e-9) -> None:
    for name in ("kind", "plane", "compensation", "tool"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)
    for name in ("start", "end", "centre"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=0, atol=within, err_msg=name)


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=examples(40), deadline=None)
@given(contours())
def test_every_family_gives_the_same_moves(family: str, contour: Contour) -> None:
    text = written(contour, family).encode()
    program = nc.parse(text)
    assert not program.opaque
    same_moves(program.toolpath, nc.parse(written(contour, "plain")).toolpath)
    assert nc.write(program, program.toolpath.with_moves()) == text
    check(text, moves_of(text))


def corrected(contour: Contour, family: str) -> tuple[pipeline.Result, nc.Program]:
    program = nc.parse(written(contour, family), "part.nc")
    path = nc.parse(written(contour, "plain")).toolpath
    cuts = path.take((path.compensation == Compensation.LEFT) & (path.kind != Kind.RAPID) & (path.end[:, 2] == -6))
    points = cuts.take(np.arange(1, len(cuts))).position(np.linspace(0.1, 0.9, 9))[:, :, :2].reshape(-1, 2)
    chosen = pipeline.Settings(filter="none", cutter_compensation="contour")
    result = pipeline.correct(pipeline.Request(program, 5.0, part(points + [0.03, -0.02]), None, chosen))
    return result, nc.parse(result.text, "out.nc")


SAMPLED = 2e-4
"""By how much chords of the samples below are off their arcs, mm: 20 mm of radius 25 in 128 parts, and less."""


TIP = 0.1
"""So near to a sharp corner, mm, a path may run on past it by some micrometres, or not: the proof leaves that free."""


def cutting_path(path: Toolpath) -> Floats:
    """Row of places of all moves under G41, at all depths, (n, 2)."""
    cuts = path.take((path.compensation == Compensation.LEFT) & (path.kind != Kind.RAPID))
    return cuts.position(np.linspace(0.0, 1.0, 129))[:, :, :2].reshape(-1, 2)


def farthest(row: Floats, other: Floats, contour: Contour) -> float:
    """Largest distance of the places of one row from the chords of another, mm; the tips of sharp corners are free."""
    tips = shapely.MultiPoint([edge.end for edge in contour.edges if edge.corner is None])
    row = row[shapely.distance(shapely.points(row), tips) > TIP]
    tree = shapely.STRtree(shapely.linestrings(np.stack([other[:-1], other[1:]], axis=1)))
    return float(tree.query_nearest(shapely.points(row), return_distance=True, all_matches=False)[1].max())


def assert_alike(contour: Contour) -> None:
    plain, wanted = corrected(contour, "plain")
    for family in FAMILIES:
        result, program = corrected(contour, family)
        np.testing.assert_allclose(result.deviation.value, plain.deviation.value, rtol=0, atol=1e-9, err_msg=family)
        if (result.outlier != plain.outlier).any():
            # The points lie exactly on a part: which of them count as outliers is then decided in the last digits.
            continue
        ours, theirs = (cutting_path(p.toolpath) for p in (program, wanted))
        # The text of either is proven to lie within the tolerance of what is wanted; where a move is divided is free.
        assert max(farthest(ours, theirs, contour), farthest(theirs, ours, contour)) <= 2 * 0.001 + SAMPLED, family
        before, after = written(contour, family).splitlines(), result.text.decode().splitlines()
        assert [_bare(line) for line in after if _steers(line)] == [_bare(line) for line in before if _steers(line)]


def _bare(line: str) -> str:
    """A line without the number of a block of Heidenhain's, which counts on."""
    return re.sub(r"^(?:\d+|N\d+(?=.*\*$)) ", "", line)


def _steers(line: str) -> bool:
    """Whether a line of these programs has to do with their order."""
    bare = _bare(line)
    if bare != line:
        return bare[:2] in ("T1", "L1", "Z0") or not bare.startswith(
            ("L ", "C ", "CC ", "CR ", "RND ", "CHF ", "; ", "G0", "G24", "G25", "X", "Y", "I")
        )
    return line[:1] in "$%OoLN" or (line[:1] not in "(;" and "M" in line[:3])


@pytest.mark.thorough
def test_a_plate_is_corrected_alike_by_every_family() -> None:
    assert_alike(PLATE)


@settings(max_examples=examples(5), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(contours())
def test_random_contours_are_corrected_alike(contour: Contour) -> None:
    assert_alike(contour)


@pytest.mark.slow
@settings(max_examples=examples(200), deadline=None, suppress_health_check=list(HealthCheck))
@given(contours())
def test_two_hundred_contours_are_corrected_alike(contour: Contour) -> None:
    assert_alike(contour)
