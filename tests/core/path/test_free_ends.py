# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free ends of straight cuts slide along themselves and keep one coordinate; leads go along, other ends stay."""

from __future__ import annotations

import re

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.geometry.correction import Correction, Course
from millcorr.path.free_ends import keep_coordinate
from tests.core import loop_programs as programs
from tests.core.laid_paths import laid

LEADS = """G21 G90
G0 X-10 Y-20
G1 Z-5 F100
G3 X0 Y-10 I0 J10 F300
G1 X40 Y10
X80 Y20
G3 X90 Y30 I0 J10
G0 Z20
M30
"""
"""An open contour of two straight cuts, arcs leading on and off; the cutter on its left."""

ROUND = """G21 G90
G0 X0 Y30
G1 Z-5 F100
G1 X30 Y40 F300
G2 X60 Y10 I0 J-30
G0 Z20
M30
"""
"""Ends in an arc, along which nothing can slide and keep a coordinate exactly."""


def corrected(text: str, along: str, depth: float = 1.0) -> nc.Program:
    """Correct for an MS of 0.05 all along."""
    program = nc.parse(text, "open.nc")
    settings = pipeline.Settings(side="left", filter="none", method="transfer", depth=depth, depth_along=along)
    nominal = pipeline.nominal_from_program(program, 5.0, settings, None)
    measurement = programs.measured(nominal, lambda k, s: np.full(len(s), depth * 0.05 / 1.05), clear=6.0)
    result = pipeline.correct(pipeline.Request(program, 5.0, measurement, None, settings))
    assert result.verification.path_error_max <= 0.001
    return nc.parse(result.text, "corrected.nc")


def words(program: nc.Program, axis: str) -> list[str]:
    lines = [t for t in program.data.decode().splitlines() if not t.startswith("(")]
    return [word for text in lines for word in re.findall(rf"{axis}[-.\d]+", text)]


@pytest.mark.parametrize(("along", "kept", "moved"), [("y", "X", "Y"), ("x", "Y", "X")])
def test_a_straight_cut_keeps_a_coordinate(along: str, kept: str, moved: str) -> None:
    """At 45 degrees both axes can be kept, and the path is the same line."""
    text = "G0 X0 Y0\nG1 Z-5 F100\nG1 X60 Y60 F300\nG0 Z20\nM30\n"
    result = corrected(text, along)
    assert words(result, kept) == words(nc.parse(text), kept)
    assert words(result, moved) != words(nc.parse(text), moved)
    # MS along an axis: delta is sqrt(2) larger, H is not; H MS is the shift along the normal in both readings.
    delta = 0.05 / 1.05 * np.sqrt(2)
    shift = delta / (1 - delta)
    line = result.toolpath.take(np.flatnonzero(result.toolpath.kind == 1))
    off = (line.end[-1, 0] - line.end[-1, 1]) / np.sqrt(2)
    # The cutter runs on the left: it goes to the right, x - y > 0, by as much; words are rounded to 1 um.
    assert off == pytest.approx(shift, abs=0.001)


def regenerated(text: str, bare: str, shift: float):
    """A program moved out by a constant correction, and the same with its ends slid to keep X."""
    program = nc.parse(text)
    nominal = pipeline.nominal_from_program(nc.parse(bare), 5.0, pipeline.Settings(side="left"), None)
    stretches = tuple(nominal.stretches())
    courses = tuple(Course.constant(shift, t.length, t.closed) for t in stretches)
    plain = laid(program.toolpath, nominal, Correction(stretches, courses), 5.0)
    return program.toolpath, plain.toolpath, keep_coordinate(program.toolpath, plain, 0).toolpath


def test_leads_go_along_rigidly() -> None:
    bare = "".join(t for t in LEADS.splitlines(keepends=True) if not t.startswith("G3")).replace("X-10 Y-20", "X0 Y-10")
    before, plain, after = regenerated(LEADS, bare, 0.05)
    for row in np.flatnonzero(before.kind == 2):
        move = after.start[row, :2] - before.start[row, :2]
        assert np.hypot(*move) > 0.05
        np.testing.assert_allclose(after.end[row, :2] - before.end[row, :2], move, atol=1e-12)
        np.testing.assert_allclose(after.centre[row, :2] - before.centre[row, :2], move, atol=1e-12)
    first, last = np.flatnonzero(before.kind == 1)[-2:]
    assert abs(plain.start[first, 0] - before.start[first, 0]) > 0.01
    assert after.start[first, 0] == pytest.approx(before.start[first, 0], abs=1e-12)
    assert after.end[last, 0] == pytest.approx(before.end[last, 0], abs=1e-12)
    # The rapid before and the one after meet the leads; the corner between the cuts is where it was.
    assert after.start[1, :2].tolist() == after.end[0, :2].tolist()
    np.testing.assert_array_equal(after.end[first], plain.end[first])
    # An end slides along its cut: it stays on the line.
    for row, new, old in ((first, after.start, plain.start), (last, after.end, plain.end)):
        along = plain.end[row, :2] - plain.start[row, :2]
        step = new[row, :2] - old[row, :2]
        assert abs(step[0] * along[1] - step[1] * along[0]) < 1e-12 * np.hypot(*along)


def test_an_arc_at_the_end_stays_where_the_normal_takes_it() -> None:
    before, plain, after = regenerated(ROUND, ROUND, 0.05)
    first, last = np.flatnonzero(before.kind == 1)[-1], np.flatnonzero(before.kind == 2)[-1]
    assert after.start[first, 0] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_array_equal(after.end[last], plain.end[last])


def test_a_closed_contour_stays_as_it_is() -> None:
    _, plain, after = regenerated(programs.LEVELS, programs.LEVELS, 0.05)
    np.testing.assert_array_equal(after.start, plain.start)
    np.testing.assert_array_equal(after.end, plain.end)
