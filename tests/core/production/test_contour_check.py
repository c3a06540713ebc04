# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour check: two straights and an arc, as in Petrakov 2018, with everything known in closed form."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.production import contour_check
from millcorr.readers.measurement import Measurement
from millcorr.report.files import deviation_lines

RADIUS = 10.0
# Climb milling of two walls, X+ then up at 60 degrees, joined by a hollow arc of part radius 15 (path radius 5).
ARC_CENTRE = np.array([40.0, 15.0])
ANGLE = np.radians(60.0)
PART_RADIUS = 15.0


def program() -> str:
    path_radius = PART_RADIUS - RADIUS
    leave = ARC_CENTRE + path_radius * np.array([np.sin(ANGLE), -np.cos(ANGLE)])
    end = leave + 30 * np.array([np.cos(ANGLE), np.sin(ANGLE)])
    return "\n".join(
        [
            "G21 G90 G17",
            "G0 X0 Y10 Z5",
            "G1 Z-5 F300",
            "G1 X40 F400",
            f"G3 X{leave[0]:.9f} Y{leave[1]:.9f} I0 J5",
            f"G1 X{end[0]:.9f} Y{end[1]:.9f}",
            "G0 Z50",
            "M2",
        ]
    )


def centres(ball, deviation):
    """Ball centres over both straights and the arc, and the slope angle at each, in degrees."""
    x = np.linspace(3, 37, 18)
    flat = np.column_stack([x, np.zeros(18)]), np.tile([0.0, 1.0], (18, 1)), np.zeros(18)
    turn = np.linspace(0.05, ANGLE - 0.05, 12)
    outward = np.column_stack([np.sin(turn), -np.cos(turn)])
    bend = ARC_CENTRE + PART_RADIUS * outward, -outward, np.degrees(turn)
    along = np.linspace(2, 28, 14)[:, None] * np.array([np.cos(ANGLE), np.sin(ANGLE)])
    side = np.array([np.sin(ANGLE), -np.cos(ANGLE)])
    wall = ARC_CENTRE + PART_RADIUS * side + along, np.tile(-side, (14, 1)), np.full(14, 60.0)
    foot, normal, slope = (np.concatenate(parts) for parts in zip(flat, bend, wall, strict=True))
    error = deviation(np.arange(len(foot)))
    return foot, normal, slope, error, foot + (error + ball)[:, None] * normal


@pytest.fixture(scope="module")
def checked():
    foot, normal, slope, error, ball = centres(3.0, lambda k: 0.02 + 0.01 * np.sin(k / 3.0))
    xyz = np.column_stack([ball, np.full(len(ball), -3.0)])
    measurement = Measurement(xyz, None, 3.0, np.arange(2, len(xyz) + 2), "touches.csv", "0")
    settings = pipeline.Settings(filter="none", side="left")
    source = nc.parse(program().encode(), "part.nc")
    result = pipeline.correct(pipeline.Request(source, RADIUS, measurement, settings=settings))
    return result, foot, normal, slope, error


def test_points_are_taken_off_along_the_normal(checked):
    result, foot, normal, slope, error = checked
    points = contour_check.touched_points(result)
    assert len(points) == len(foot) == 44
    # Nine decimals in the program.
    np.testing.assert_allclose(points.foot, foot, atol=2e-8)
    np.testing.assert_allclose(points.contact, foot + error[:, None] * normal, atol=2e-8)
    np.testing.assert_allclose(points.error, error, atol=2e-8)
    # The contour runs with the material on its left, the program with it on the right.
    np.testing.assert_allclose(contour_check.slope_angle(points.normal), (slope + 180) % 360, atol=1e-6)


def test_path_lies_a_radius_off_the_contour(checked):
    result = checked[0]
    stations = contour_check.path_stations(result)
    np.testing.assert_allclose(stations.path - stations.point, RADIUS * stations.normal, atol=2e-8)
    step = np.hypot(*np.diff(stations.path, axis=0).T)
    assert step.max() <= contour_check.STATIONS_APART + 1e-9 and step.min() > 1e-6
    np.testing.assert_array_equal(np.unique(stations.line), [4, 5, 6])
    np.testing.assert_allclose(stations.path[[0, -1]], np.array([[0, 10], result.request.program.toolpath.end[-2, :2]]))
    # On the arc the stations turn by five degrees at most.
    assert np.diff(np.unwrap(np.arctan2(*stations.normal.T))).max() <= contour_check.STATIONS_TURN + 1e-9
    assert contour_check.path_contours(result).total.sum() == pytest.approx(40 + 5 * ANGLE + 30, abs=1e-6)


def test_files_and_table_hold_the_same(checked):
    result, foot, _, _, error = checked
    points = contour_check.touched_points(result)
    rows = list(csv.DictReader(io.TextIOWrapper(io.BytesIO(b"".join(deviation_lines(result))))))
    np.testing.assert_allclose([float(row["deviation"]) for row in rows], error, atol=2e-8)
    np.testing.assert_allclose([(float(row["x_nominal"]), float(row["y_nominal"])) for row in rows], foot, atol=2e-8)
    stations = contour_check.path_stations(result)
    path = [line.split(",") for line in b"".join(contour_check.path_lines(stations)).decode().splitlines()]
    assert tuple(path[0]) == contour_check.PATH_COLUMNS and len(path) == len(stations) + 1
    text = contour_check.table(points).splitlines()
    assert len(text) == 45 and text[1].split()[0] == "2"
    assert float(text[1].split()[-1]) == pytest.approx(error[0] * 1000, abs=0.006)


def test_check_lists_the_points_on_request(tmp_path, capsys):
    """The points of the paper's part, touched 20 um outside: contact, slope and error of each, in a row."""
    from millcorr.__main__ import main

    _, _, slope, _, ball = centres(3.0, lambda k: np.full(len(k), 0.02))
    (tmp_path / "part.nc").write_text(program())
    rows = [f"{x:.9f},{y:.9f},-3" for x, y in ball]
    (tmp_path / "touches.csv").write_text("\n".join(["x,y,z", *rows]) + "\n")
    said = [
        "check",
        "--program",
        str(tmp_path / "part.nc"),
        "--tool-diameter",
        "20",
        "--side",
        "left",
        "--filter",
        "none",
    ]
    said += ["--measured", str(tmp_path / "touches.csv"), "--points", "centre", "--probe-radius", "3"]
    assert main([*said, "--table"]) == 0
    listed = capsys.readouterr().out.splitlines()[1 : 1 + len(slope)]
    assert [line.split()[-1] for line in listed] == ["+20.00"] * len(slope)
    np.testing.assert_allclose([float(line.split()[-2]) for line in listed], (slope + 180) % 360, atol=1e-3)
    assert main(said) == 0
    assert "slope" not in capsys.readouterr().out
