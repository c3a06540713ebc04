# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program of a first cut: exact parallels of the finishing path, small fillets included."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc, pipeline
from millcorr.__main__ import main
from millcorr.correction.settings import Settings
from millcorr.errors import InputError, LimitError, UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.production.split import split
from millcorr.virtual.simulated_machine import SimulatedMachine
from tests.core import loop_programs as programs
from tests.core.sweeps import examples

RADIUS = 5.0


def parsed(text):
    return nc.parse(text.encode() if isinstance(text, str) else text, "finish.nc")


def path_points(toolpath, following):
    moves = toolpath.take(np.flatnonzero(following))
    return moves.position(np.linspace(0, 1, 41))[:, :, :2].reshape(-1, 2)


def pocket(fillet, width=90.0, height=40.0):
    """A pocket with one fillet of the path, run anticlockwise: material to the right."""
    x, y = width, height
    return (
        f"G0 X50 Y20\nG1 Z-5 F100\nG1 X50 Y0 F300\nG1 X{x - fillet:.9f} Y0\nG3 X{x} Y{fillet:.9f} I0 J{fillet:.9f}\n"
        f"G1 Y{y}\nX0\nY0\nX50\nG1 X50 Y20\nG0 Z20\n"
    )


@settings(deadline=None, max_examples=examples(40))
@given(
    st.floats(0.05, 20.0, allow_nan=False), st.floats(0.1, 3.0, allow_nan=False), st.floats(0.1, 0.9, allow_nan=False)
)
def test_first_path_is_the_finishing_path_moved_out(fillet, depth, at):
    """shapely's buffer with mitred joins of the finishing path is the oracle: inner corners need no more."""
    fillet, depth, at = round(fillet, 3), round(depth, 3), round(at, 3)
    done = split(parsed(pocket(fillet)), RADIUS, depth, at, settings=Settings(side="left"))
    left = depth * (1 - at)
    emitted = nc.parse(done.result.text).toolpath
    got = path_points(emitted, done.result.regeneration.following)
    angle = np.linspace(-np.pi / 2, 0, 2000)
    bend = np.column_stack([90 - fillet + fillet * np.cos(angle), fillet + fillet * np.sin(angle)])
    if fillet <= left + 0.001:
        # The parallel of a fillet as small as this is the corner of its neighbours' parallels.
        bend = np.array([[90.0, 0.0]])
    finish = shapely.Polygon(np.vstack([bend, [[90, 40], [0, 40], [0, 0]]]))
    expected = finish.buffer(-left, join_style="mitre", mitre_limit=50).exterior
    # The polygon's chords lie up to r (1 - cos(half a step)) inside the arc; programs have the digits they have.
    chord = fillet * (1 - np.cos(np.pi / 8000)) + 1e-6
    assert shapely.distance(expected, shapely.points(got)).max() <= 0.001 + chord
    back = shapely.Polygon(emitted.end[done.result.regeneration.following][:, :2])
    assert back.is_valid
    assert done.result.verification.path_error_max <= 0.001


def test_arcs_stay_arcs_and_all_else_stays():
    done = split(parsed(programs.ROUNDED), RADIUS, 1.0, 0.5, settings=Settings(side="right"))
    text = done.result.text.decode().splitlines()
    assert done.left == done.depth == 0.5
    assert "N70 G3 X105.5 Y10. I0. J15.5" in text and "N110 G3 X-0.5 Y-5.5 I5. J0." in text
    assert sum("G3" in line for line in text) == programs.ROUNDED.count("G3")
    plain = {line for line in programs.ROUNDED.splitlines() if not set(line) & set("XYIJ")}
    assert plain <= set(text)
    assert text[2:4] == ["(MILLCORR 0.1.0 FIRST CUT, LEAVES 0.5 MM)", "(OF FINISH.NC)"]


def test_spline_contour_through_its_nominal():
    """A contour of small arcs and lines along an ellipse: every point lies the allowance farther out."""
    t = np.linspace(0, 2 * np.pi, 721)
    a, b = 60.0, 35.0
    normal = np.column_stack([b * np.cos(t), a * np.sin(t)])
    normal /= np.hypot(*normal.T)[:, None]
    path = np.column_stack([a * np.cos(t), b * np.sin(t)]) + RADIUS * normal
    moves = "\n".join(f"G1 X{x:.6f} Y{y:.6f}" for x, y in path[1:])
    far = f"X{path[0, 0] + 8:.6f}"
    text = f"G0 {far} Y0\nG1 Z-5 F100\nG1 X{path[0, 0]:.6f} F300\n{moves}\nG1 {far}\nG0 Z9\n"
    done = split(parsed(text), RADIUS, 0.8, 0.25, settings=Settings(side="right"))
    emitted = nc.parse(done.result.text).toolpath
    got = path_points(emitted, done.result.regeneration.following)
    away = FootPointSearch(done.result.nominal, margin=8).find(got).distance
    np.testing.assert_allclose(away, RADIUS + 0.6, atol=0.001)


def test_single_piece_from_split_to_second_half():
    """Split, cut, measure, correct: what a yielding machine leaves falls to less than a twentieth."""
    depth, ms = 1.6, 0.08
    program = parsed(programs.ROUNDED)
    done = split(program, RADIUS, depth, 0.5, settings=Settings(side="right"))
    machine = SimulatedMachine(allowance=depth, transfer=ms)
    first = machine.cut(nc.parse(done.result.text).toolpath, RADIUS, done.result.nominal, seed=1)
    s = np.linspace(0, float(done.result.nominal.total[0]), 400, endpoint=False)
    # Away from corners, where the cutter cuts two walls at once.
    corner = np.concatenate([[t.begin, t.begin + t.length] for t in done.result.nominal.stretches()])
    s = s[np.abs(s[:, None] - corner).min(axis=1) > 2 * depth]
    measurement = first.measure(s=s, seed=1)
    second = replace(machine, allowance=lambda at: first.deviation(0, at))
    plain = second.cut(program.toolpath, RADIUS, done.result.nominal, seed=2).deviation(0, s)
    chosen = Settings(method="transfer", depth=done.depth, allowance=done.left, side="right")
    result = pipeline.correct(pipeline.Request(program, RADIUS, measurement, settings=chosen))
    final = second.cut(nc.parse(result.text).toolpath, RADIUS, done.result.nominal, seed=2).deviation(0, s)
    assert np.abs(plain).max() > 0.06
    assert np.abs(final).max() < np.abs(plain).max() / 20


@pytest.mark.parametrize(
    ("change", "error", "says"),
    [
        ({"depth": 0.0}, UsageError, "--depth 0"),
        ({"depth": float("nan")}, UsageError, "--depth nan"),
        ({"at": 0.0}, UsageError, "--at 0"),
        ({"at": 1.0}, UsageError, "--at 1"),
        ({"radius": -1.0}, UsageError, "tool diameter"),
        ({"settings": Settings()}, UsageError, "--side left or --side right"),
        ({"depth": 90.0}, LimitError, "leaves nothing of"),
    ],
)
def test_what_cannot_be_split_is_refused(change, error, says):
    arguments = {"radius": RADIUS, "depth": 1.0, "at": 0.5, "settings": Settings(side="left")} | change
    with pytest.raises(error, match=says):
        split(parsed(pocket(0.3)), **arguments)


def test_two_vanishing_arcs_in_a_row_are_refused():
    text = pocket(0.5).replace(
        "G3 X90.0 Y0.500000000 I0 J0.500000000",
        "G3 X89.853553391 Y0.146446609 I0 J0.5\nG3 X90 Y0.5 I-0.353553391 J0.353553391",
    )
    assert text != pocket(0.5)
    with pytest.raises(LimitError, match="do not meet in a corner"):
        split(parsed(text), RADIUS, 2.0, 0.5, settings=Settings(side="left"))


def test_corrected_program_is_not_split():
    text = "(millcorr 0.1.0 corrected 2026-01-01 measurement 0123456789abcdef source 0123456789abcdef)\n"
    with pytest.raises(InputError, match="finish.nc:1: the program was corrected before"):
        split(parsed(text + pocket(3)), RADIUS, 1.0, settings=Settings(side="left"))


def test_command(tmp_path, capsys):
    (tmp_path / "finish.nc").write_text(programs.EDGE)
    line = f"split --program {tmp_path}/finish.nc --tool-diameter 16 --depth 2 --side left --depth-along y"
    assert main([*line.split(), "--output", str(tmp_path / "first.nc")]) == 0
    said = capsys.readouterr().out
    assert "takes 1 mm and leaves 1 mm of 2 mm" in said and "--method transfer --depth 1 --allowance 1" in said
    first, finish = ((tmp_path / n).read_text() for n in ("first.nc", "finish.nc"))
    y = [
        np.array(
            [float(w[1:]) for w in text.replace("X", " X").replace("F", " F").replace("Y", " Y").split() if w[0] == "Y"]
        )
        for text in (first, finish)
    ]
    assert len(y[0]) == 2
    slope = (y[1][1] - y[1][0]) / 100.0
    # A millimetre along the normal is 1/cos of the slope along Y; programs have three decimals.
    np.testing.assert_allclose(y[0] - y[1], np.hypot(1.0, slope), atol=1.01e-3)
    assert "X5" in first and "X105" in first
    assert main([*line.split(), "--output", str(tmp_path / "finish.nc")]) == 2
    assert "must stay untouched" in capsys.readouterr().err
