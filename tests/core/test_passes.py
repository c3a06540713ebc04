# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs as shops write them: roughing and finishing in one file, several tools, depths, laps, neighbours, facets.

The surface of the written program is found by shapely, from the text alone: the boundary of the discs.
"""

from __future__ import annotations

import re

import numpy as np
import pytest
import shapely

from millcorr import gcode, pipeline
from millcorr.errors import LimitError
from millcorr.measurement import Measurement
from millcorr.path import emission

R = 4.0
W, H = 80.0, 50.0


def ring(distance: float) -> list[tuple[float, float]]:
    """Outside of a rectangle of W x H about the origin, from the middle of the lower side, clockwise."""
    x, y = W / 2 + distance, H / 2 + distance
    return [(0.0, -y), (-x, -y), (-x, y), (x, y), (x, -y), (0.0, -y)]


def once(distance: float, z: float, *, head: str = "", begin: float = 15.0) -> str:
    """One pass with straight leads along Y, so that leads and rapids are no part of the contour."""
    points = ring(distance)
    lines = [f"G0 X0. Y{-H / 2 - distance - begin:.3f}", "G0 Z5.", f"G1 Z{z:.3f} F100."]
    lines += [f"G1 X{x:.3f} Y{y:.3f} F400." for x, y in points]
    lines += [f"G1 X0. Y{-H / 2 - distance - begin:.3f}", "G0 Z20."]
    return head + "\n".join(lines) + "\n"


def program(*passes: str) -> str:
    return "%\nO1\nG21 G90 G17\n" + "".join(passes) + "M30\n%\n"


def points(deviation: float, z: float = -2.0, distance: float = 0.0, count: int = 200) -> np.ndarray:
    """Contact points on all sides, none within 6 mm of a corner."""
    out = []
    for (x0, y0), (x1, y1) in zip(ring(distance + deviation)[:-1], ring(distance + deviation)[1:], strict=True):
        a, b = np.array([x0, y0]), np.array([x1, y1])
        length = np.hypot(*(b - a))
        share = np.linspace(6 / length, 1 - 6 / length, max(3, int(count * length / (2 * W + 2 * H))))
        out.append(a + share[:, None] * (b - a))
    xy = np.concatenate(out)
    xy = xy[np.abs(xy[:, 0]) > 0.1]
    return np.column_stack([xy, np.full(len(xy), z)])


def measured(*groups: np.ndarray) -> Measurement:
    xyz = np.concatenate(groups)
    return Measurement(xyz, None, 0.0, np.arange(1, len(xyz) + 1), "part.csv", "cd" * 32)


def correct(text: str, part: Measurement, **settings) -> tuple[pipeline.Result, str]:
    request = pipeline.Request(gcode.parse(text, "part.nc"), R, part, settings=pipeline.Settings(**settings))
    result = pipeline.correct(request)
    return result, "\n".join(line for line in result.text.decode().splitlines() if not line.startswith("("))


def left(text: str, z: float, radius: float = R) -> shapely.Geometry:
    """What the discs of all cuts that go down to z take away, read by a few lines of its own."""
    at, deep, cuts = [np.nan, np.nan], 5.0, []
    for line in text.splitlines():
        words = dict(re.findall(r"([GXYZ])(-?[\d.]+)", re.sub(r"\(.*?\)", "", line)))
        new = [float(words.get("X", at[0])), float(words.get("Y", at[1]))]
        deep = float(words.get("Z", deep))
        if words.get("G") != "0" and deep <= z and np.isfinite(at + new).all():
            cuts.append(shapely.LineString([at, new]) if new != at else shapely.Point(at))
        at = new
    return shapely.union_all([cut.buffer(radius, quad_segs=256) for cut in cuts])


def wall(text: str, z: float) -> list[float]:
    """Where the walls of the part stand that all cuts leave: left, bottom, right, top, mm over the nominal."""
    inside = shapely.Polygon(ring(0.5)).difference(left(text, z))
    x0, y0, x1, y1 = max(getattr(inside, "geoms", [inside]), key=lambda g: g.area).bounds
    return [-x0 - W / 2, -y0 - H / 2, x1 - W / 2, y1 - H / 2]


@pytest.mark.parametrize("allowance", [0.03, 0.05, 0.1, 0.3])
def test_the_finish_is_corrected_and_not_the_roughing(allowance: float) -> None:
    text = program(once(R + allowance, -3.0), once(R, -3.0))
    _, new = correct(text, measured(points(0.02)))
    assert new.startswith("%\nO1\nG21 G90 G17\n" + once(R + allowance, -3.0))
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)


def test_a_roughing_tool_of_another_diameter_stays() -> None:
    rough = once(4.1 + 0.05, -3.0, head="(T1 D8.2 ROUGHER)\nT1 M6\n")
    text = program(rough, once(R, -3.0, head="(T2 D8.0 FINISHER)\nT2 M6\n"))
    result, new = correct(text, measured(points(0.02)))
    assert [line for line in rough.splitlines() if line[0] != "("] == new.splitlines()[3:15]
    np.testing.assert_allclose(wall(new[new.index("T2") :], -2.0), -0.02, atol=0.001)
    assert not any("not known" in w for w in result.warnings)


def test_a_tool_of_which_nothing_is_known_stays_and_is_said() -> None:
    rough = once(4.1 + 0.05, -3.0, head="T1 M6\n")
    text = program(rough, once(R, -3.0, head="T2 M6\n"))
    result, new = correct(text, measured(points(0.02)))
    assert rough in new
    assert any("diameter of T1 is not known" in w and "--tool 1=MM" in w for w in result.warnings)
    result, new = correct(text, measured(points(0.02)), tools=("1=8.2",))
    assert rough in new and not any("not known" in w for w in result.warnings)


def test_roughing_that_would_cut_into_the_corrected_wall_is_refused_or_kept_away() -> None:
    """The part is 0.06 mm too small all round: the wall goes out beyond the roughing's 0.03."""
    text = program(once(R + 0.03, -3.0), once(R, -3.0))
    with pytest.raises(LimitError, match=r"line \d+ .*would cut 30\.\d um .*--keep-allowance"):
        correct(text, measured(points(-0.06)))
    _, new = correct(text, measured(points(-0.06)), keep_allowance=True)
    rough, finish = new.split("G0 Z20.")[:2]
    np.testing.assert_allclose(wall(rough, -2.0), 0.09, atol=0.001)
    np.testing.assert_allclose(wall(finish, -2.0), 0.06, atol=0.001)


def test_depth_passes_and_spring_passes_on_one_path_move_together() -> None:
    text = program(once(R, -3.0), once(R, -6.0), once(R, -6.0))
    _, new = correct(text, measured(points(0.02, -5.0)))
    for part in new.split("G0 Z20.")[:3]:
        np.testing.assert_allclose(wall(part, -2.0), -0.02, atol=0.001)


def test_a_neighbours_wall_beside_the_measured_one_stays() -> None:
    """Another part's pass 0.05 mm farther out, at the same height, after the finish."""
    text = program(once(R, -3.0), once(R + 0.05, -3.0))
    _, new = correct(text, measured(points(0.02)))
    assert new.endswith(once(R + 0.05, -3.0) + "M30\n%")
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)


def test_of_a_draft_in_steps_the_measured_one_moves() -> None:
    """Five steps of 0.05 mm, each deeper one farther out: the third, from -4 to -6 mm, was measured."""
    steps = [once(R + 0.05 * k, -2.0 - 2.0 * k) for k in range(5)]
    _, new = correct(program(*steps), measured(points(0.015, -5.0, 0.10)))
    parts = [part + "G0 Z20.\n" for part in new.split("G0 Z20.\n")[:5]]
    for k in (0, 1, 3, 4):
        assert parts[k].endswith(steps[k]), k
    np.testing.assert_allclose(wall(parts[2], -5.0), 0.10 - 0.015, atol=0.001)


def test_two_laps_with_compensation_are_one_contour() -> None:
    lap = "".join(f"G1 X{x:.3f} Y{y:.3f} F400.\n" for x, y in ring(0.0)[1:])
    head = "G21 G90\nG0 X0. Y-60.\nG0 Z5.\nG1 Z-3. F100.\nG41 D1 G1 X0. Y-25. F400.\n"
    text = f"{head}{lap}{lap}G40 G1 X0. Y-60.\nG0 Z20.\n"
    _, new = correct(text, measured(points(0.02)))
    assert len(re.findall(r"X-39\.98 Y-24\.98\b", new)) == 2


@pytest.mark.parametrize("facet", [0.005, 0.05, 1.0])
def test_facets_of_any_length(facet: float) -> None:
    """An ellipse in facets at three decimals, 15 um too large."""
    a, b = (30.0, 18.0) if facet > 0.01 else (6.0, 5.0)
    t = np.linspace(0, 2 * np.pi, int(2 * np.pi * a / facet))
    normal = np.column_stack([b * np.cos(t), a * np.sin(t)])
    normal /= np.hypot(*normal.T)[:, None]
    path = np.round(np.column_stack([a * np.cos(t), b * np.sin(t)]) + R * normal, 3)[::-1]
    lines = "".join(f"G1 X{x:.3f} Y{y:.3f}\n" for x, y in path[1:])
    start = f"X{path[0, 0]:.3f} Y{path[0, 1]:.3f}"
    text = f"G21 G90\nG0 X60. Y0.\nG1 Z-3. F100.\nG1 {start} F400.\n{lines}G1 X60. Y0.\nG0 Z20.\nM30\n"
    s = np.arange(0, len(t), max(1, len(t) // 150))
    on = np.column_stack([a * np.cos(t), b * np.sin(t)])[s] + 0.015 * normal[s]
    _, new = correct(text, measured(np.column_stack([on, np.full(len(on), -2.0)])))
    removed = left(new, -2.0)
    middle = np.arange(0, len(t), max(1, len(t) // 97))
    wanted = np.column_stack([a * np.cos(t), b * np.sin(t)])[middle] - 0.015 * normal[middle]
    off = shapely.distance(shapely.points(wanted), removed)
    inside = shapely.distance(shapely.points(wanted), removed.boundary)
    # Facets of 1 mm stand off the curve by 8 um on the radius of the ends; rounding by 0.7 um.
    allowed = 0.0025 + facet**2 / (8 * b * b / a) * (1 + R / (b * b / a))
    assert off.max() < allowed and inside.max() < allowed


def test_a_program_in_facets_is_corrected_again() -> None:
    """Facets of 0.3 mm at three decimals; what is left after the first correction goes with the second."""
    t = np.linspace(0, 2 * np.pi, 700)
    on = np.column_stack([30.0 * np.cos(t), 18.0 * np.sin(t)])
    normal = np.column_stack([18.0 * np.cos(t), 30.0 * np.sin(t)])
    normal /= np.hypot(*normal.T)[:, None]
    path = np.round(on + R * normal, 3)[::-1]
    lines = "".join(f"G1 X{x:.3f} Y{y:.3f}\n" for x, y in path[1:])
    start = f"X{path[0, 0]:.3f} Y{path[0, 1]:.3f}"
    text = f"G21 G90\nG0 X60. Y0.\nG1 Z-3. F100.\nG1 {start} F400.\n{lines}G1 X60. Y0.\nG0 Z20.\nM30\n"
    first = gcode.parse(text, "first.nc")
    nominal = pipeline.nominal_from_program(first, R, pipeline.Settings(), measured(np.column_stack([on, 0 * t - 2.0])))

    def part(deviation: np.ndarray, digest: str) -> Measurement:
        xyz = np.column_stack([on + deviation[:, None] * normal, np.full(len(on), -2.0)])[::3]
        return Measurement(xyz, None, 0.0, np.arange(1, len(xyz) + 1), digest + ".csv", digest * 32)

    one, two = 0.02 + 0.01 * np.cos(2 * t), 0.004 * np.sin(t)
    request = pipeline.Request(first, R, part(one, "ab"))
    second = gcode.parse(pipeline.correct(request).text, "second.nc")
    request = pipeline.Request(second, R, part(two, "cd"), nominal, nominal_is_first_program=True)
    removed = left(pipeline.correct(request).text.decode(), -2.0)
    middle = slice(5, -5, 7)
    off = shapely.distance(shapely.points((on - (one + two)[:, None] * normal)[middle]), removed.boundary)
    # Each program is within 1 um of what is wanted, and the facets stand off by 1 um.
    assert off.max() < 0.004


def test_what_is_cut_under_another_work_offset_is_another_part() -> None:
    """The same plate 0.05 mm smaller on a second fixture, whose finish lies nearer to the first one's points."""
    other = once(R - 0.05, -3.0, head="G55\n")
    result, new = correct(program(once(R, -3.0, head="G54\n"), other), measured(points(0.02)))
    assert new.endswith(other + "M30\n%")
    np.testing.assert_allclose(wall(new.split("G55")[0], -2.0), -0.02, atol=0.001)
    assert any("G55 is another part" in w for w in result.warnings)


def test_roughing_less_deep_than_the_finish_is_looked_at() -> None:
    text = program(once(R + 0.03, -2.8), once(R + 0.5, -3.0), once(R, -3.0))
    with pytest.raises(LimitError, match="--keep-allowance"):
        correct(text, measured(points(-0.06)))


def test_a_rebate_above_the_wall_is_no_roughing() -> None:
    """A cut that is deeper than the wall at another height stays, whatever the wall does."""
    rebate = once(R - 0.5, -1.0)
    _, new = correct(program(rebate, once(R, -3.0)), measured(points(-0.05, -2.0)))
    assert rebate in new
    np.testing.assert_allclose(wall(new, -2.0), 0.05, atol=0.001)


def test_the_tool_that_fits_the_points_is_corrected_whatever_is_stated() -> None:
    rough = once(R + 0.05, -3.0, head="(T1 D8. ROUGHER)\nT1 M6\n")
    _, new = correct(program(rough, once(R, -3.0, head="T2 M6\n")), measured(points(0.02)))
    assert "".join(line + "\n" for line in rough.splitlines()[1:]) in new
    np.testing.assert_allclose(wall(new[new.index("T2") :], -2.0), -0.02, atol=0.001)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"X-43\.9\S+ Y-28\.98", "X-143.98 Y-28.98"),
        (r"X-43\.9\S+ Y28\.98", "X-43.97 Y28.98"),
        (r"X0\. Y-35\.98", "X0. Y0."),
    ],
)
def test_a_spoilt_place_in_the_written_text_is_caught(monkeypatch: pytest.MonkeyPatch, old: str, new: str) -> None:
    """F and Z on lines of their own, so that no other word holds a place."""
    lines = [f"X{x:.2f} Y{y:.2f}" for x, y in ring(R)[1:]]
    head = "G21 G90\nG0 X0. Y-36.\nG0 Z5.\nF400.\nG1\nZ-3.\nX0. Y-29.\n"
    text = head + "\n".join(lines) + "\nX0. Y-36.\nG0 Z20.\nM30\n"
    wrote = emission.written_text

    def spoilt(*args):
        out = wrote(*args)
        changed, count = re.subn(old.encode(), new.encode(), out)
        assert count
        return changed

    correct(text, measured(points(0.02)))
    monkeypatch.setattr(emission, "written_text", spoilt)
    with pytest.raises(LimitError):
        correct(text, measured(points(0.02)))
