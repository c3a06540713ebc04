# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs as shops write them: roughing and finishing in one file, several tools, depths, laps, neighbours, facets.

The surface of the written program is found by shapely, from the text alone: the boundary of the discs.
"""

from __future__ import annotations

import re

import numpy as np
import pytest
import shapely

from millcorr import nc, pipeline
from millcorr.comparison.cutters import stated_diameters
from millcorr.errors import InputError, LimitError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.nc.toolpath import named_tool
from millcorr.path import emission
from millcorr.readers.measurement import Measurement

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


def backwards(distance: float, z: float) -> str:
    """The same pass the other way round."""
    lines = once(distance, z).splitlines()
    return "\n".join([*lines[:3], *lines[8:2:-1], *lines[9:]]) + "\n"


def numbers(note: str) -> set[int]:
    """Line numbers that a note lists: 'lines 3-5, 8'."""
    ranges = re.findall(r"(\d+)(?:-(\d+))?", note[note.index("lines ") :].split(" of ")[0])
    return {n for a, b in ranges for n in range(int(a), int(b or a) + 1)}


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
    request = pipeline.Request(nc.parse(text, "part.nc"), R, part, settings=pipeline.Settings(**settings))
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


def wall(text: str, z: float, radius: float = R) -> list[float]:
    """Where the walls of the part stand that all cuts leave: left, bottom, right, top, mm over the nominal."""
    inside = shapely.Polygon(ring(0.5)).difference(left(text, z, radius))
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


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("rough", "fine", "name"),
    [
        ('T="ROUGH 8" D1\nM6\n', 'T="FINE" D1\nM6\n', "ROUGH 8"),
        ('T1="ROUGH 8" M6\n', "T=2 M6\n", "ROUGH 8"),
        ("T=ROUGH_8 M6\n", "T=FINE_8 M6\n", "ROUGH_8"),
        ('T"ROUGH 8" G17 S900\n', 'T"FINE" G17 S900\n', "ROUGH 8"),
    ],
)
def test_tools_with_names_are_tools_of_their_own(rough: str, fine: str, name: str) -> None:
    """The rougher's path is 0.05 mm outside the finisher's, its cutter 0.2 mm larger: it leaves 0.05 mm less stock."""
    roughing = once(4.1 + 0.05, -3.0, head=rough)
    text = program(roughing, once(R, -3.0, head=fine))
    result, new = correct(text, measured(points(0.02)))
    assert roughing in new
    assert any(f"diameter of {name} is not known" in w and f"--tool {name}=MM" in w for w in result.warnings)
    np.testing.assert_allclose(wall(new[new.index(fine) :], -2.0), -0.02, atol=0.001)
    for tool in (f"{name}=8.2", f'T="{name.lower()}"=8.2'):
        result, new = correct(text, measured(points(0.02)), tools=(tool,))
        assert roughing in new and not any("not known" in w for w in result.warnings)
    # Were the wall to go out by 0.06 mm, that tool would cut 0.01 mm into it: its radius is known and is used.
    with pytest.raises(LimitError, match=r"would cut 10\.\d um"):
        correct(text, measured(points(-0.06)), tools=(f"{name}=8.2",))


def test_diameters_in_comments() -> None:
    texts = ["T1 D16 ROUGHER", 'T="EM 10" D=10 R=0', 'T="FINE" DIA 8', 'T="FINE" D 1', "T4 D4", "T5 D5.", "T6 H6 D16"]
    stated = stated_diameters(list(enumerate(texts)), 1.0)
    assert stated == {1: 16.0, named_tool(b"em 10"): 10.0, named_tool(b"FINE"): 8.0, 5: 5.0}


@pytest.mark.parametrize("text", ["8.2", "=8.2", "ROUGH=", "ROUGH=0", "ROUGH=x", "1=-3"])
def test_a_tool_is_stated_with_its_diameter(text: str) -> None:
    with pytest.raises(UsageError, match="as --tool 3=16"):
        pipeline.Settings(tools=(text,))


def test_roughing_that_would_cut_into_the_corrected_wall_is_refused_or_kept_away() -> None:
    """The part is 0.06 mm too small all round: the wall goes out beyond the roughing's 0.03."""
    text = program(once(R + 0.03, -3.0), once(R, -3.0))
    with pytest.raises(LimitError, match=r"line \d+ .*would cut 30\.\d um .*--keep-allowance"):
        correct(text, measured(points(-0.06)))
    _, new = correct(text, measured(points(-0.06)), keep_allowance=True)
    rough, finish = new.split("G0 Z20.")[:2]
    np.testing.assert_allclose(wall(rough, -2.0), 0.09, atol=0.001)
    np.testing.assert_allclose(wall(finish, -2.0), 0.06, atol=0.001)


def test_roughing_of_another_tool_goes_along_by_its_own_radius() -> None:
    """A larger cutter, in one pass the other way round, leaves 0.03 and 0.2 mm; the wall goes out by 0.06."""
    head = "(T1 D8.2 ROUGHER)\nT1 M6\n"
    rough = [once(4.1 + 0.2, -3.0, head=head), backwards(4.1 + 0.03, -2.8)]
    text = program(*rough, once(R, -3.0, head="(T2 D8.0 FINISHER)\nT2 M6\n"))
    result, new = correct(text, measured(points(-0.06)), keep_allowance=True)
    parts = new.split("G0 Z20.")[:3]
    for part, radius, stands in zip(parts, (4.1, 4.1, R), (0.26, 0.09, 0.06), strict=True):
        np.testing.assert_allclose(wall(part, -2.0, radius), stands, atol=0.001)
    sides = [n for n, line in enumerate(text.splitlines(), 1) if "F400." in line]
    (note,) = (w for w in result.warnings if "moved along" in w)
    # The first of each six leads onto the ring.
    assert numbers(note) == {*sides[1:6], *sides[7:12]}


def test_roughing_in_one_chain_with_the_finish_goes_along() -> None:
    """No rapid, no lead between: the cutter steps over from ring to ring."""
    rings = [f"G1 X{x:.3f} Y{y:.3f} F400.\n" for d in (R + 0.3, R + 0.03, R) for x, y in ring(d)]
    text = program("G0 X0. Y-44.\nG1 Z-3. F100.\n", *rings, "G1 X0. Y-44.\nG0 Z20.\n")
    _, new = correct(text, measured(points(-0.06)), keep_allowance=True)
    moved = [line for line in new.splitlines() if "F400." in line]
    for k, stands in enumerate((0.36, 0.09, 0.06)):
        part = "G0 X0. Y-44.\nG1 Z-3.\n" + "\n".join(moved[6 * k : 6 * k + 6])
        np.testing.assert_allclose(wall(part, -2.0), stands, atol=0.001)


def test_roughing_round_corners_goes_along() -> None:
    """Arcs about the corners, 0.2 mm from the finish, which turns about them in arcs, too."""

    def about(distance: float) -> str:
        x, y, d = W / 2, H / 2, distance
        ends = [(-x, -y - d), (-x - d, -y), (-x - d, y), (-x, y + d), (x, y + d), (x + d, y), (x + d, -y), (x, -y - d)]
        lines = [f"G{1 + k % 2} X{a:.3f} Y{b:.3f}" + f" R{d:.3f}" * (k % 2) for k, (a, b) in enumerate(ends)]
        lead = f"G0 X0. Y{-y - d - 15:.3f}\nG1 Z-3. F100.\nG1 X0. Y{-y - d:.3f} F400.\n"
        return lead + "\n".join([*lines, f"G1 X0. Y{-y - d:.3f}", f"G1 Y{-y - d - 15:.3f}", "G0 Z20."]) + "\n"

    result, new = correct(program(about(R + 0.2), about(R)), measured(points(-0.06)), keep_allowance=True)
    (note,) = (w for w in result.warnings if "moved along" in w)
    assert numbers(note) == set(range(7, 16))
    path = nc.parse(new).toolpath
    rows = np.flatnonzero((path.kind != 0) & (path.start[:, 2] == -3))
    wanted = shapely.Polygon([(x + np.sign(x) * 0.06, y + np.sign(y) * 0.06) for x, y in ring(0.0)[1:]])
    for k, distance in ((0, R + 0.2), (1, R)):
        mine = rows[11 * k + 1 : 11 * k + 10]
        places = path.take(mine).position(np.linspace(0, 1, 21))[:, :, :2].reshape(-1, 2)
        np.testing.assert_allclose(shapely.distance(shapely.points(places), wanted), distance, atol=0.001)


def test_finished_walls_beside_the_corrected_one_do_not_go_along() -> None:
    """The step of a draft above, one below, and a later pass: each makes a surface of its own."""
    others = [once(R - 0.05, -1.0), once(R + 0.05, -5.0), once(R + 0.4, -3.0)]
    text = program(*others[:2], once(R, -3.0), others[2])
    result, new = correct(text, measured(points(0.02)), keep_allowance=True)
    assert all(other in new for other in others)
    assert not any("moved along" in w for w in result.warnings)
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)


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


def slot_wall(gap: float, radius: float = R, head: str = "", z: float = -3.0) -> str:
    """A pass of its own along the left side, whose wall stands `gap` beyond the back of the finish's cutter."""
    x = -W / 2 - 2 * R - gap + radius
    lines = ["G0 X-70. Y-15.", "G0 Z5.", f"G1 Z{z:.3f} F100.", f"G1 X{x:.3f} Y-15. F400.", "G1 Y15.", "G1 X-70."]
    return head + "\n".join([*lines, "G0 Z20."]) + "\n"


@pytest.mark.few(2)
@pytest.mark.parametrize("radius", [3.0, 2.0])
@pytest.mark.parametrize("z", [-1.0, -5.0])
def test_a_finish_that_would_cut_into_another_wall_with_its_back_is_refused(radius: float, z: float) -> None:
    """The wall stands 0.01 mm behind the finish's cutter, which has to go out by 0.05: 0.04 mm too far."""
    head = f"(T1 D{2 * radius:.1f})\nT1 M6\n"
    text = program(slot_wall(0.01, radius, head, z), once(R, -3.0, head="(T2 D8.0)\nT2 M6\n"))
    message = r"line 2\d of the corrected program would cut 40\.\d um into another wall at X-48\.01\d .* line 10 of the"
    with pytest.raises(LimitError, match=message):
        correct(text, measured(points(-0.05)))
    for gap, deviation in ((0.06, -0.05), (0.01, 0.05), (0.01, -0.01)):
        near = slot_wall(gap, radius, head, z)
        _, new = correct(program(near, once(R, -3.0, head="(T2 D8.0)\nT2 M6\n")), measured(points(deviation)))
        assert new.count(near.split("M6\n")[1]) == 1


def test_an_edge_between_two_walls_moves_with_one_of_them() -> None:
    """A slot square to the measured wall ends where the finish's cutter now begins."""
    slot = "G0 X20. Y60.\nG0 Z5.\nG1 Z-5. F100.\nG1 Y36. F400.\nG0 Z20.\n"
    for deviation in (0.05, -0.05):
        _, new = correct(program(slot, once(R, -3.0)), measured(points(deviation)))
        assert slot in new


def test_two_laps_with_compensation_are_one_contour() -> None:
    lap = "".join(f"G1 X{x:.3f} Y{y:.3f} F400.\n" for x, y in ring(0.0)[1:])
    head = "G21 G90\nG0 X0. Y-60.\nG0 Z5.\nG1 Z-3. F100.\nG41 D1 G1 X0. Y-25. F400.\n"
    text = f"{head}{lap}{lap}G40 G1 X0. Y-60.\nG0 Z20.\n"
    _, new = correct(text, measured(points(0.02)))
    assert len(re.findall(r"X-39\.98 Y-24\.98\b", new)) == 2


@pytest.mark.few(1)
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


@pytest.mark.thorough
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
    first = nc.parse(text, "first.nc")
    nominal = pipeline.nominal_from_program(first, R, pipeline.Settings(), measured(np.column_stack([on, 0 * t - 2.0])))

    def part(deviation: np.ndarray, digest: str) -> Measurement:
        xyz = np.column_stack([on + deviation[:, None] * normal, np.full(len(on), -2.0)])[::3]
        return Measurement(xyz, None, 0.0, np.arange(1, len(xyz) + 1), digest + ".csv", digest * 32)

    one, two = 0.02 + 0.01 * np.cos(2 * t), 0.004 * np.sin(t)
    request = pipeline.Request(first, R, part(one, "ab"))
    second = nc.parse(pipeline.correct(request).text, "second.nc")
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


def wandering(stock: float, phase: float, z0: float, z1: float) -> str:
    """A lap round a disc of 20 mm, from one height to another, that wanders by 15 um six times."""
    turn = np.radians(np.arange(0, 361, 2))
    r = 20 + R + stock + 0.015 * np.sin(6 * turn + phase)
    z = z0 + (z1 - z0) * turn / (2 * np.pi)
    return "".join(
        f"G1 X{x:.4f} Y{y:.4f} Z{h:.4f}\n" for x, y, h in zip(-r * np.cos(turn), r * np.sin(turn), z, strict=True)
    )


@pytest.mark.few(1)
@pytest.mark.parametrize("stock", [0.0, 0.06])
def test_on_a_drawing_laps_that_wander_otherwise_are_no_roughing(stock: float) -> None:
    """All laps of a helix go onto the drawing; a lap that leaves more than they wander does stays."""
    laps = [wandering(0.0, k, -1.0 - k, -2.0 - k) for k in range(2)] + [wandering(0.0, 2.5, -3.0, -3.0)]
    rough = "G0 X-30 Y-1\nG1 Z-3\n" + wandering(0.06, 1.0, -3.0, -3.0) + "G1 X-30 Y1\nG0 Z5\n" if stock else ""
    text = f"G21 G90\nG0 Z5\n{rough}G0 X-30 Y-1\nG1 Z-1 F100\n{''.join(laps)}G1 X-30 Y1\nG0 Z20\nM30\n"
    half = [NurbsCurve.arc((-20, 0), (20, 0), (0, 0), -np.pi), NurbsCurve.arc((20, 0), (-20, 0), (0, 0), -np.pi)]
    turn = np.linspace(0.05, 2 * np.pi, 120, endpoint=False)
    part = measured(np.column_stack([20.03 * np.cos(turn), 20.03 * np.sin(turn), np.full(120, -2.5)]))
    nominal = Profile.from_contours([Contour(tuple(half), True)])
    done = pipeline.correct(pipeline.Request(nc.parse(text, "part.nc"), R, part, nominal))
    moves = nc.parse(done.text, "part.nc").toolpath
    new = done.text.decode()
    assert rough in new
    end = moves.end[moves.source >= new[: new.index(rough) + len(rough)].count("\n")]
    end = end[np.abs(np.hypot(*end.T[:2]) - 20 - R) < 0.1]
    turn, off = np.arctan2(end[:, 1], end[:, 0]), np.hypot(*end.T[:2]) - 20 - R
    order = np.argsort(turn)
    # All laps come to lie on one line; what the part was measured with was cut by whichever lay innermost.
    assert np.abs(np.diff(off[order]))[np.diff(turn[order]) < 1e-3].max() < 0.002


def test_a_lead_on_the_tangent_turns_with_the_contour() -> None:
    """Where a wall turns by 0.025 rad with its correction, an arc led onto it as before cuts 5 um into it."""
    text = (
        "G21 G90\nG0 X20. Y-6.\nG0 Z5.\nG1 Z-3. F100.\nG3 X26. Y0. I0. J6. F400.\nG3 X-26. Y0. I-26. J0.\nG3 X26. Y0. "
        "I26. J0.\nG3 X20. Y6. I-6. J0.\nG1 X10.\nG0 Z20.\nM30\n"
    )
    turn = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    r = 30 - 0.25 * np.sin(3 * turn)
    part = measured(np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(240, -2.0)]))
    _, new = correct(text, part)
    moves = nc.parse(new, "part.nc").toolpath
    arcs = np.flatnonzero((moves.kind == 2) & (moves.end[:, 2] < -2))
    u = np.linspace(0, 1, 50)
    places = np.concatenate([moves.place(np.full(50, k), u) for k in arcs[[0, -1]]])
    # The wanted wall about the origin, by discs at every place of the leads: none reaches over it by a micrometre.
    rim = places[:, None] + R * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    angle = np.arctan2(rim[..., 1], rim[..., 0])
    assert (np.hypot(rim[..., 0], rim[..., 1]) - (30 + 0.25 * np.sin(3 * angle))).max() < 0.001
    before, after = (moves.direction(arcs[k : k + 1], np.array([at]))[0] for k, at in ((0, 1.0), (1, 0.0)))
    assert abs(before[0] * after[1] - before[1] * after[0]) < 2e-3


def test_beyond_what_was_measured_a_pass_that_stays_is_only_told() -> None:
    """Another pass makes the first 5 mm of an open wall, as a lead that two passes share does; the wall comes out."""
    other = "G0 X-10. Y4.\nG0 Z2.\nG1 Z-3. F100.\nG1 X5. F400.\nG0 Z5.\n"
    text = f"G21 G90\n{other}G0 X-10. Y4.\nG0 Z2.\nG1 Z-3.\nG1 X100. F400.\nG0 Z20.\nM30\n"
    x = np.linspace(20.0, 99.0, 120)
    part = measured(np.column_stack([x, np.full(120, -0.02), np.full(120, -2.0)]))
    result, _ = correct(text, part, side="left")
    assert any("cuts 20.0 um into" in w and "beyond what was measured" in w for w in result.warnings)


@pytest.mark.parametrize("deviation", [0.02, -0.02])
def test_a_smaller_cutter_in_the_corners_makes_the_wall_beside_them_too(deviation: float) -> None:
    """Rest machining: both cutters move with the wall, or the second one would cut or leave a step."""
    big = once(-R, -3.0, head="(T1 D8.0)\nT1 M6\n", begin=-10.0)
    corners = []
    for sx, sy in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        x, y = sx * (W / 2 - 2), sy * (H / 2 - 2)
        way = [(x - 12 * sx, y), (x, y), (x, y - 12 * sy)]
        corners += [f"G0 X{way[0][0]:.3f} Y{way[0][1]:.3f}", "G0 Z5.", "G1 Z-3. F100."]
        corners += [f"G1 X{a:.3f} Y{b:.3f} F400." for a, b in way[1:]] + ["G0 Z20."]
    small = "(T2 D4.0)\nT2 M6\n" + "\n".join(corners) + "\n"
    _, new = correct(program(big, small), measured(points(-deviation)))
    first, second = new.split("T2 M6")
    for text, radius in ((first, 4.0), (second, 2.0)):
        x0, y0, x1, y1 = left(text, -2.0, radius).bounds
        off = [-x0 - W / 2, -y0 - H / 2, x1 - W / 2, y1 - H / 2]
        np.testing.assert_allclose(off, deviation, atol=0.001)


def test_passes_to_and_fro_make_one_wall() -> None:
    """Moves of two passes lie on each other: which of them a point is nearest to is chance."""
    there = "".join(f"G1 X{x} F400.\n" for x in range(-45, 55, 5))
    back = "".join(f"G1 X{x}\n" for x in range(45, -55, -5))
    cuts = f"G0 X-50. Y-29.\nG0 Z5.\nG1 Z-1.5 F100.\n{there}G1 Z-3. F100.\n{back}G0 Z20.\n"
    edge = np.column_stack([np.linspace(-40, 40, 80), np.full(80, -25.02), np.full(80, -1.0)])
    _, new = correct(program(cuts), measured(edge))
    for z in (-1.0, -2.0):
        inside = shapely.box(-30, -30, 30, 0).difference(left(new, z))
        assert inside.bounds[1] == pytest.approx(-25.0 + 0.02, abs=0.001)


def test_a_ramp_to_and_fro_on_the_contour_tells_no_side() -> None:
    lines = once(R, -3.0).splitlines()
    y = -H / 2 - R
    ways = [*range(-5, -40, -5), *range(-30, 5, 5)]
    ramp = [f"G1 X{x} Y{y:.3f} Z{-3 * (n + 1) / len(ways):.3f} F100." for n, x in enumerate(ways)]
    lap = [f"G1 X{x} Y{y:.3f} F400." for x in range(-5, -40, -5)]
    text = program("\n".join([*lines[:2], f"G0 X0. Y{y:.3f}", "G1 Z0. F100.", *ramp, *lap, *lines[4:]]) + "\n")
    all_round = points(0.02)
    front = all_round[all_round[:, 1] < -H / 2]
    _, new = correct(text, measured(front, all_round))
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)


def test_centres_of_a_ball_as_large_as_the_cutter_lie_on_the_path() -> None:
    """Another pass clears one side: the wall is on the other."""
    finish, clearing = once(R, -3.0), once(R + 6.0, -3.0)
    centres = points(0.02, distance=R)
    part = Measurement(centres, None, R, np.arange(1, len(centres) + 1), "part.csv", "cd" * 32)
    _, new = correct(program(clearing, finish), part)
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)
    with pytest.raises(InputError, match="--side left or --side right"):
        correct(program(finish), part)
    across = np.abs(centres[:, 0]) > W / 2 + R
    outward = np.where(across[:, None], [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]]) * np.sign(centres)
    known = Measurement(centres, outward, R, np.arange(1, len(centres) + 1), "part.csv", "cd" * 32)
    _, new = correct(program(finish), known)
    np.testing.assert_allclose(wall(new, -2.0), -0.02, atol=0.001)


@pytest.mark.parametrize("deviation", [0.02, -0.03])
def test_both_walls_beside_a_step_lower_than_the_cutter_are_corrected(deviation: float) -> None:
    text = program(f"G0 X60 Y{-R:g}\nG1 Z-5 F300\nG1 X{R:g} Y{-R:g}\nG1 X{R:g} Y{1.5 - R:g}\nG1 X-60 Y{1.5 - R:g}")
    walls = [(np.linspace(50, 2, 80), 0.0), (np.linspace(-8, -50, 80), 1.5)]
    part = measured(*(np.column_stack([x, np.full(80, y - deviation), np.full(80, -2.0)]) for x, y in walls))
    result, _ = correct(text, part)
    x, y = result.regeneration.toolpath.end[result.regeneration.following, :2].T
    np.testing.assert_allclose(y[[0, 2]], [deviation - R, 1.5 + deviation - R], rtol=0, atol=1e-3)
    # The step's own wall shows nowhere: it stays within the two beside it.
    assert np.abs(x[:2] - R).max() <= abs(deviation) + 1e-3


def test_points_that_lie_mostly_in_the_fillets_of_inner_corners_are_believed() -> None:
    """A slot's end: the cutter leaves a fillet in either corner, on which half of the touches fall."""
    text = program(f"G0 X{R:g} Y-60\nG1 Z-5 F300\nG1 X{R:g} Y{-R:g}\nG1 X{R + 4:g} Y{-R:g}\nG1 X{R + 4:g} Y-60\n")
    inside, deviation = R - 0.02, 0.02
    arc = np.linspace(0.03, np.pi / 2 - 0.03, 30)
    corners = [
        np.column_stack([x + way * inside * np.cos(arc), -R + inside * np.sin(arc)])
        for x, way in ((R, -1.0), (R + 4, 1.0))
    ]
    sides = [np.column_stack([np.full(8, x), np.linspace(-9, -5, 8)]) for x in (deviation, 2 * R + 4 - deviation)]
    end = np.column_stack([np.linspace(R + 0.4, R + 3.6, 8), np.full(8, -deviation)])
    part = measured(*(np.column_stack([xy, np.full(len(xy), -2.0)]) for xy in (*corners, *sides, end)))
    result, new = correct(text, part, filter="none")
    assert len(result.left_out) >= 60
    went = nc.parse(new).toolpath.end[-4:, :2]
    np.testing.assert_allclose(went[:, 0], [R - 0.02, R - 0.02, R + 4.02, R + 4.02], rtol=0, atol=1e-3)
    np.testing.assert_allclose(went[1:3, 1], 0.02 - R, rtol=0, atol=1e-3)


def test_a_move_past_a_corner_stays_one_move() -> None:
    """It touches nothing, turned away from the wall before and cut off by the one behind it; both move alike."""
    moves = ["X-6.079 Y3.630", "X-16.204 Y10.782", "X-39.277 Y9.830", "X-40.574 Y10.615", "X-43.861 Y5.184"]
    text = program("G0 X0 Y0\nG1 Z-5 F300\n" + "".join(f"G1 {move}\n" for move in moves))
    path = shapely.LineString([(0, 0), *(tuple(float(w[1:]) for w in move.split()) for move in moves)])
    swept = path.buffer(R, quad_segs=256)
    beside = shapely.offset_curve(path, R, quad_segs=256)
    seen = shapely.line_merge(beside.intersection(swept.boundary.buffer(2e-4)))
    seen = max(shapely.get_parts(seen), key=lambda one: one.length)
    at = shapely.get_coordinates(seen.interpolate(np.arange(0.4, seen.length - 0.4, 0.4)))
    nearest = shapely.get_coordinates(path.interpolate(path.project(shapely.points(at))))
    normal = (nearest - at) / np.hypot(*(nearest - at).T)[:, None]
    _, new = correct(text, measured(np.column_stack([at + 0.0363 * normal, np.full(len(at), -2.0)])), filter="none")
    assert new.count("G1 ") == text.count("G1 ")


def test_where_a_point_lies_near_a_tip_is_asked_of_what_the_part_shows() -> None:
    """Off by a little more than the others one would be taken for a point of the other side, and moved that."""
    half = np.radians(12.0)
    ahead = np.array([[np.cos(half), np.sin(half)], [np.cos(half), -np.sin(half)]])
    out = np.array([[-np.sin(half), np.cos(half)], [-np.sin(half), -np.cos(half)]])
    far, near = 60 * ahead + R * out, -R / np.sin(half) * np.array([1.0, 0.0])
    text = program(
        "G0 X{:.4f} Y{:.4f}\nG1 Z-5 F300\nG1 X{:.4f} Y{:.4f}\nG1 X{:.4f} Y{:.4f}\n".format(*far[0], *near, *far[1])
    )
    s = np.arange(0.22, 50, 0.4)
    off = -0.05 - 0.02 * np.exp(-s / 20)
    sides = [s[:, None] * ahead[k] + (off if k else 0 * off)[:, None] * out[k] for k in (0, 1)]
    part = measured(*(np.column_stack([xy, np.full(len(s), -2.0)]) for xy in sides))
    result, _ = correct(text, part, filter="none")
    d = result.deviation
    lower = d.index >= len(s)
    np.testing.assert_allclose(d.value[lower], off[d.index[lower] - len(s)], rtol=0, atol=1e-4)
